// The head of the page: what was run, its figures, whether they can be trusted.
import { difference } from "../derived.js";
import { dataTable, el, section } from "../dom.js";
import { count, number, parts, plain, withError } from "../format.js";

const FIGURES = [
  ["power_W", "W", "Power"],
  ["torque_Nm", "N m", "Torque"],
  ["kinetic_energy_J", "J", "Kinetic energy"],
  ["shoulder_deg", "°", "Shoulder"],
  ["toe_deg", "°", "Toe (bulk)"],
  ["head_deg", "°", "Head"],
  ["impact_toe_deg", "°", "Impact toe"],
  ["dynamic_angle_deg", "°", "Dynamic angle"],
  ["contacts_per_particle", "1", "Contacts per particle"],
  ["wear_siem_m3", "m³", "Wear of the walls (SIEM)"],
];

const given = (run, name) => Number.isFinite(run.summary[name]);

function tile(run, [name, unit, label]) {
  const { value, error } = run.figure(name);
  const p = parts(value, error, unit);
  return el(
    "div",
    { class: "tile" },
    el("dt", {}, label),
    el(
      "dd",
      {},
      el("span", { class: "big" }, p.value),
      ` ${p.unit}`,
      p.error ? el("span", { class: "error" }, `± ${p.error}`) : null,
    ),
  );
}

export function stateOf(run) {
  const s = run.summary;
  if (s.error) return ["bad", `went wrong at t = ${number(s.time_s)} s`];
  if (!run.complete)
    return [
      "warn",
      `as of its last record, t = ${number(run.endTime, 4)} s: going on, or ended from outside`,
    ];
  if (!s.finished) return ["warn", `stopped at t = ${number(s.time_s, 4)} s`];
  return ["good", "finished"];
}

function millText(run) {
  const mill = run.scene?.mill;
  if (!mill) return "";
  const rpm = (Math.abs(run.speed) * 30) / Math.PI;
  const lifters = mill.lifters ? `, ${mill.lifters.count} lifters` : "";
  return (
    `Mill ${plain(mill.diameter)} m × ${plain(mill.length)} m${lifters}, ` +
    `${plain(rpm)} rpm (${number(100 * run.shareOfCritical)} % of critical)`
  );
}

function steadyLine(run) {
  const s = run.summary;
  if (s.steady === undefined) return null;
  return el(
    "p",
    { class: s.steady ? "good" : "warn" },
    `Recorded window: ${s.steady_statement ?? (s.steady ? "steady" : "not steady")}.`,
  );
}

function subtitle(run) {
  const s = run.summary,
    particles = s.particles ?? run.view?.all_particles;
  const facts = [
    millText(run),
    particles
      ? `${count(particles)} particles${s.polyhedra ? `, ${count(s.polyhedra)} of them polyhedra` : ""}`
      : "",
    run.endTime > run.recordFrom
      ? `recorded from ${plain(run.recordFrom)} s to ${plain(run.endTime)} s`
      : `nothing recorded yet, the record starts at ${plain(run.recordFrom)} s`,
  ].filter(Boolean);
  const [grade, state] = stateOf(run);
  return [
    el("p", { class: "facts" }, facts.join(" · "), " ", el("span", { class: `state ${grade}` }, state)),
    steadyLine(run),
  ];
}

export function headline(page) {
  const [run] = page.runs;
  if (page.runs.length > 1) return comparison(page.runs);
  return el(
    "header",
    {},
    el("h1", {}, page.title),
    subtitle(run),
    el(
      "dl",
      { class: "tiles" },
      FIGURES.filter(([name]) => given(run, name)).map((figure) => tile(run, figure)),
    ),
    el("p", { class: "note" }, "± is the standard error of the mean from ten blocks of the recorded window."),
  );
}

// Angles and powers side by side; differences are from the first run.
function comparison(runs) {
  const rows = FIGURES.filter(([name]) => runs.some((run) => given(run, name))).map((figure) =>
    row(runs, figure),
  );
  return el(
    "header",
    {},
    el("h1", {}, "Runs side by side"),
    el(
      "div",
      { class: "runs" },
      runs.map((run) =>
        el(
          "div",
          { class: "run" },
          el("h3", {}, run.name),
          el("p", {}, run.scene?.title ?? ""),
          subtitle(run),
        ),
      ),
    ),
    dataTable("Headline figures", head(runs), rows),
    el(
      "p",
      { class: "note" },
      `Differences are from ${runs[0].name}. ± is a standard error; that of a difference is the root of the summed squares. ` +
        "A difference below two of its errors may be chance.",
    ),
  );
}

export function head(runs) {
  return [
    "",
    ...runs.map((run) => run.name),
    ...runs.slice(1).flatMap((run) => [`${run.name} − ${runs[0].name}`, "relative"]),
  ];
}

// A row of a table of runs: figures, then differences from the first.
export function rowOf(label, figures, unit) {
  const differences = figures.slice(1).flatMap((figure) => {
    const d = difference(figures[0], figure);
    const share = (100 * d.value) / Math.abs(figures[0].value);
    return [
      significant(withError(d.value, d.error, unit), d),
      Number.isFinite(share) ? `${share > 0 ? "+" : ""}${number(share, 2)} %` : "–",
    ];
  });
  return [label, ...figures.map((f) => withError(f.value, f.error, unit)), ...differences];
}

function significant(text, d) {
  return Math.abs(d.value) > 2 * d.error ? el("strong", {}, text) : text;
}

function row(runs, [name, unit, label]) {
  return rowOf(
    label,
    runs.map((run) => run.figure(name)),
    unit,
  );
}

export function contents(sections) {
  return el(
    "nav",
    { "aria-label": "Sections" },
    sections.map((part) => el("a", { href: `#${part.id}` }, part.querySelector("h2").textContent)),
  );
}

export function notes(page) {
  const all = page.runs.flatMap((run) =>
    run.notes.map((note) => (page.runs.length > 1 ? `${run.name}: ${note}` : note)),
  );
  return all.length === 0
    ? null
    : section(
        "notes",
        "Notes",
        el(
          "ul",
          {},
          all.map((note) => el("li", {}, note)),
        ),
      );
}
