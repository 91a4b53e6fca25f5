// The page of `quern trade`: cost against the error of a chosen figure, and the tables.
import { dataTable, el, section, select } from "../dom.js";
import { number, plain } from "../format.js";
import { csvButton, plot } from "../plot.js";

const KEY = "power_W";

const unitOf = (error) => (error.unit === "deg" ? "°" : error.unit);

function figuresOf(trade) {
  const all = new Map();
  for (const row of trade.rows) {
    for (const error of row.errors) if (!all.has(error.name)) all.set(error.name, error);
  }
  return all;
}

const errorOf = (row, name) => row.errors.find((error) => error.name === name);
const known = (error) => error && Number.isFinite(error.value) && Number.isFinite(error.standard_error);
// What it is at most, as far as this can tell.
const bound = (error) => (error.below ? 2 * error.standard_error : Math.abs(error.value));

function errorText(error) {
  if (!known(error)) return "–";
  if (error.value === 0 && error.standard_error === 0) return "0";
  if (error.below) return `< ${number(2 * error.standard_error, 2)}`;
  const text = `${error.value > 0 ? "+" : ""}${number(error.value, 2)} ± ${number(error.standard_error, 1)}`;
  return el("strong", {}, text);
}

function costText(row) {
  if (row.status) return "–";
  return `${number(row.cost, 3)} (${number(row.cost_low, 2)}–${number(row.cost_high, 2)})`;
}

// A line for each dial, in the order of cost; a setting says nothing against itself.
function seriesOf(trade, name) {
  const dials = [...new Set(trade.rows.map((row) => row.dial))];
  return dials
    .map((dial) => {
      const rows = trade.rows
        .filter((row) => row.dial === dial && row.status === "" && row.setting !== row.against)
        .filter((row) => known(errorOf(row, name)) && bound(errorOf(row, name)) > 0)
        .sort((a, b) => a.cost - b.cost);
      const errors = rows.map((row) => errorOf(row, name));
      return {
        label: dial,
        x: rows.map((row) => row.cost),
        y: errors.map(bound),
        error: errors.map((error) => (error.below ? 0 : error.standard_error)),
        labels: rows.map((row, k) => `${errors[k].below ? "< " : ""}${row.value}`),
        points: true,
        dash: [2, 4],
      };
    })
    .filter((line) => line.x.length > 0);
}

function pareto(trade) {
  const figures = figuresOf(trade);
  const options = [...figures.values()].map((error) => [error.name, `${error.label} (${error.name})`]);
  let name = figures.has(KEY) ? KEY : options[0]?.[0];
  if (!name) return null;
  const figure = plot(() => {
    const error = figures.get(name);
    return {
      title: "Cost against error",
      note:
        "Size of the error against the setting that each dial is measured against; < marks what is below two " +
        "standard errors, drawn there: the error is no larger. Down and to the left is better.",
      x: { label: "cost: time for a second of the mill over the default's", unit: "1", log: true },
      y: { label: `error of ${error.label}`, unit: unitOf(error), log: true },
      series: seriesOf(trade, name),
    };
  });
  return section(
    "pareto",
    "Cost against error",
    select("Error of", options, (value) => {
      name = value;
      figure.change();
    }),
    figure,
  );
}

// In one line.
const rowHead = (row) => `${row.dial}: ${row.value}${row.front ? " *" : ""}`.replaceAll(" ", "\u00a0");

function errorsTable(trade) {
  const figures = [...figuresOf(trade).values()];
  const head = ["", "against", "cost", ...figures.map((e) => `${e.label}, ${unitOf(e)}`)];
  const rows = trade.rows.map((row) => [
    rowHead(row),
    row.status ? el("span", { class: "reason" }, row.status) : row.against,
    costText(row),
    ...figures.map((figure) => (row.status ? "" : errorText(errorOf(row, figure.name)))),
  ]);
  return section(
    "errors",
    "Errors",
    csvButton("errors", () => csvOf(trade, figures)),
    dataTable("Errors of all settings", head, rows),
    el(
      "p",
      { class: "note" },
      "± is the standard error of a difference: the root of the summed squares of both runs', each from ten blocks " +
        "of the recorded window (of the profile: from the lifters). < : below two of them. Bold: above. Peaks and means of spectra are in decades of energy. " +
        "* : none measured against the same is both cheaper and nearer in power.",
    ),
  );
}

function csvOf(trade, figures) {
  const quote = (text) => `"${String(text).replaceAll('"', '""')}"`;
  const head = ["dial", "value", "against", "cost", "cost_low", "cost_high"];
  for (const figure of figures) head.push(`${figure.name} [${figure.unit}]`, "standard error");
  const lines = trade.rows.map((row) => [
    ...[row.dial, row.value, row.against].map(quote),
    ...(row.status ? ["", "", ""] : [row.cost, row.cost_low, row.cost_high]),
    ...figures.flatMap((figure) => {
      const error = errorOf(row, figure.name);
      return [error?.value ?? "", error?.standard_error ?? ""];
    }),
  ]);
  return `${[head.map(quote), ...lines].map((cells) => cells.join(",")).join("\n")}\n`;
}

function numerics(trade) {
  const head = [
    "",
    "state",
    "time step (s)",
    "steps a contact",
    "overlap at impact (r)",
    "restitution asked",
    "delivered",
    "scatter",
    "ledger error",
    "numerical loss",
    "wall clock for 1 s (s)",
  ];
  const rows = trade.rows.map((row) => [
    rowHead(row),
    row.state,
    ...(row.status
      ? []
      : [
          number(row.time_step),
          number(row.steps_per_contact),
          number(row.impact_overlap, 2),
          plain(row.restitution_asked),
          number(row.restitution_delivered, 4),
          number(row.restitution_scatter, 2),
          number(row.ledger_error, 2),
          number(row.numerical_loss, 2),
          number(row.wall_s_per_s),
        ]),
  ]);
  return section(
    "numerics",
    "Numerics",
    dataTable("What each setting does to single contacts and to the account of energy", head, rows),
    el(
      "p",
      { class: "note" },
      "Restitution of head-on collisions of the smallest spheres, of the pair of materials that is furthest off, over all phases of " +
        "arrival. Overlap at impact: of two of the heaviest particles at the speed of the scene's fastest impacts, over their radius. State: what a setting starts from.",
    ),
  );
}

function settings(trade) {
  const seen = new Map(trade.rows.map((row) => [row.setting, row.set]));
  const rows = [...seen].map(([name, set]) => [name, set === "" ? "the scene as it is" : set]);
  return section("settings", "Settings", dataTable("What --set makes of each", ["", "set"], rows, "text"));
}

export function trade(page) {
  const all = page.trade;
  const facts = [
    all.scene,
    `${plain(all.revolutions)} turns recorded after ${plain(all.lead)}`,
    `${all.machine}, ${all.threads} threads`,
  ];
  const header = el(
    "header",
    {},
    el("h1", {}, page.title),
    el("p", { class: "facts" }, facts.join(" · ")),
    el("p", { class: "note" }, all.command),
  );
  return [header, ...[pareto(all), errorsTable(all), numerics(all), settings(all)].filter(Boolean)];
}
