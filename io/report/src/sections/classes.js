// Size classes and named zones: how fast what spins and moves.
import { dataTable, el, section, select } from "../dom.js";
import { withError } from "../format.js";
import { plot } from "../plot.js";
import { head, rowOf } from "./headline.js";
import { dashOf, nameIn } from "./power.js";

const QUANTITIES = [
  ["angular_speed", "Mean angular speed", "rad/s"],
  ["kinetic_energy", "Mean kinetic energy", "J"],
  ["rotational_energy", "Mean rotational energy", "J"],
  ["count", "Mean number", "1"],
];

const middles = (run) =>
  run.values("classes/from").map((from, k) => 500 * (from + run.values("classes/to")[k]));

// Classes of one species are one line: names begin with the species'.
function speciesOf(run) {
  const names = run.lines("classes/name"),
    known = (run.scene?.species ?? []).map((s) => s.name);
  return names.map(
    (name) =>
      known.filter((s) => name === s || name.startsWith(`${s} `)).sort((a, b) => b.length - a.length)[0] ??
      name.split(" ")[0],
  );
}

function lines(runs, table, quantity) {
  const all = [...new Set(runs.flatMap(speciesOf))];
  return runs
    .flatMap((run) =>
      all.map((species, k) => {
        const rows = speciesOf(run)
          .map((s, row) => [s, row])
          .filter(([s]) => s === species)
          .map(([, row]) => row);
        const pick = (list) => rows.map((row) => list[row]);
        return {
          label: nameIn(runs, run, species),
          colour: k,
          dash: dashOf(run),
          points: true,
          x: pick(middles(run)),
          y: pick(run.values(`${table}/${quantity}`)),
          error: pick(run.values(`${table}/${quantity}_standard_error`)),
        };
      }),
    )
    .filter((s) => s.x.length > 0 && s.y.some((v) => Number.isFinite(v)));
}

function spec(runs, table, quantity, where) {
  const [, title, unit] = QUANTITIES.find(([q]) => q === quantity);
  const log = quantity !== "angular_speed";
  return {
    title: `${title} by size${where}`,
    x: { label: "diameter, middle of the class", unit: "mm", log: false },
    y: { label: title.toLowerCase(), unit, log, zero: !log },
    series: lines(runs, table, quantity),
    note: "Whiskers are standard errors.",
  };
}

function tableOf(run, table, caption) {
  const shown = QUANTITIES.filter(([q]) => run.has(`${table}/${q}`));
  const rows = run
    .lines("classes/name")
    .map((name, k) => [
      name,
      ...shown.map(([q, , unit]) =>
        withError(run.values(`${table}/${q}`)[k], run.values(`${table}/${q}_standard_error`)[k], unit),
      ),
    ]);
  return dataTable(caption, ["class", ...shown.map(([, title]) => title.toLowerCase())], rows, "quiet");
}

function tableOfMany(runs, table, caption) {
  const shown = QUANTITIES.filter(([q]) => runs.some((run) => run.has(`${table}/${q}`)));
  const names = [...new Set(runs.flatMap((run) => run.lines("classes/name")))];
  const box = el("div");
  const fill = (quantity) => {
    const unit = QUANTITIES.find(([q]) => q === quantity)[2];
    const figure = (run, name) => {
      const k = run.lines("classes/name").indexOf(name);
      return {
        value: run.values(`${table}/${quantity}`)[k] ?? NaN,
        error: run.values(`${table}/${quantity}_standard_error`)[k] ?? NaN,
      };
    };
    box.replaceChildren(
      dataTable(
        caption,
        head(runs),
        names.map((name) =>
          rowOf(
            name,
            runs.map((run) => figure(run, name)),
            unit,
          ),
        ),
        "quiet",
      ),
    );
  };
  fill(shown[0][0]);
  return el(
    "div",
    {},
    select(
      "Quantity",
      shown.map(([q, title]) => [q, title]),
      fill,
    ),
    box,
  );
}

function part(runs, table, caption, where) {
  const shown = QUANTITIES.filter(([q]) => runs.some((run) => run.has(`${table}/${q}`)));
  if (shown.length === 0) return [];
  let second = shown[1]?.[0];
  const right = second ? plot(() => spec(runs, table, second, where)) : null;
  return [
    el(
      "div",
      { class: "pair" },
      plot(spec(runs, table, shown[0][0], where)),
      right
        ? el(
            "div",
            {},
            right,
            shown.length > 2
              ? select(
                  "Quantity",
                  shown.slice(1).map(([q, t]) => [q, t]),
                  (q) => {
                    second = q;
                    right.change();
                  },
                )
              : null,
          )
        : null,
    ),
    runs.length === 1 ? tableOf(runs[0], table, caption) : tableOfMany(runs, table, caption),
  ];
}

export function classes(page) {
  const runs = page.runs.filter((run) => run.has("classes/from"));
  if (runs.length === 0) return null;
  const zones = [...new Set(runs.flatMap((run) => run.below("zones")))];
  return section(
    "classes",
    "Classes and zones",
    part(runs, "classes", "By size class", ""),
    zones
      .map((zone) => [
        el("h3", {}, `Zone ${zone}`),
        ...part(runs, `zones/${zone}`, `Zone ${zone}`, `, zone ${zone}`),
      ])
      .flat(),
  );
}
