// Power over time and by kind of collision (the paper's Table 3).
import { checkbox, dataTable, el, section, select } from "../dom.js";
import { number, withError } from "../format.js";
import { csvButton, plot } from "../plot.js";
import { head, rowOf } from "./headline.js";

const DASHES = [undefined, [7, 4], [2, 3], [9, 3, 2, 3]];
const SERIES_TIME = { label: "time", unit: "s" };

export const nameIn = (runs, run, text) => (runs.length > 1 ? `${run.name}: ${text}` : text);
export const dashOf = (run) => DASHES[run.index % DASHES.length];

// Mean of `values` over the last `width` of time, at each time.
function smoothed(time, values, width) {
  if (!(width > 0)) return values;
  const out = [];
  let first = 0,
    sum = 0,
    held = 0;
  for (let k = 0; k < time.length; k += 1) {
    sum += values[k] ?? 0;
    held += 1;
    while (time[k] - time[first] > width) {
      sum -= values[first] ?? 0;
      held -= 1;
      first += 1;
    }
    out.push(sum / held);
  }
  return out;
}

// Time of a fiftieth of the run, to smooth over.
const windowOf = (run) => (run.time.at(-1) - run.time[0]) / 50;

function powerPlot(runs) {
  let smooth = false;
  const figure = plot(() => ({
    title: "Power of the mill over time",
    x: SERIES_TIME,
    y: { label: "power", unit: "W" },
    series: runs.map((run) => ({
      label: nameIn(runs, run, "power"),
      x: run.time,
      dash: dashOf(run),
      colour: run.index,
      y: smooth ? smoothed(run.time, run.values("series/power"), windowOf(run)) : run.values("series/power"),
    })),
    marks: runs.slice(0, 1).map((run) => ({ at: run.recordFrom, label: "recorded from here" })),
    note: smooth
      ? `Mean over the last ${number(windowOf(runs[0]), 2)} s.`
      : "Each point is the mean since the point before.",
  }));
  return el(
    "div",
    { class: "block" },
    figure,
    checkbox("smoothed", false, (on) => {
      smooth = on;
      figure.change();
    }),
  );
}

// Rates from sums, as means over stretches of a fiftieth of the run.
function rates(time, sums) {
  const step = Math.max(1, Math.floor(time.length / 50));
  const x = [],
    y = [];
  for (let k = step; k < time.length; k += step) {
    if (sums[k] === null || sums[k - step] === null) continue;
    x.push(0.5 * (time[k] + time[k - step]));
    y.push((sums[k] - sums[k - step]) / (time[k] - time[k - step]));
  }
  return { x, y };
}

function overTime(runs, title, group, names, note) {
  const series = runs.flatMap((run) =>
    names(run).map((name, k) => ({
      label: nameIn(runs, run, name.label),
      colour: k,
      dash: dashOf(run),
      ...rates(run.time, run.values(`${group}/${name.array}`)),
    })),
  );
  return plot({ title, x: SERIES_TIME, y: { label: "power", unit: "W", zero: true }, series, note });
}

const PARTS = [
  ["dissipation_normal", "normal damping"],
  ["dissipation_sliding", "sliding"],
  ["dissipation_tangential", "tangential damping"],
];

function partsOverTime(runs) {
  if (!runs.every((run) => run.has("series/dissipation"))) return null;
  return overTime(
    runs,
    "Dissipation by mechanism over time",
    "series",
    () => PARTS.map(([array, label]) => ({ array, label })),
    "Means over a fiftieth of the run each.",
  );
}

function kindsOverTime(runs) {
  if (!runs.every((run) => run.below("series/dissipation_by_kind").length > 0)) return null;
  const names = (run) =>
    run.lines("power_by_kind/kind").filter((kind) => run.has(`series/dissipation_by_kind/${kind}`));
  const some = (run) => (names(run).length > 0 ? names(run) : run.below("series/dissipation_by_kind"));
  return overTime(
    runs,
    "Dissipation by kind of collision over time",
    "series/dissipation_by_kind",
    (run) => some(run).map((kind) => ({ array: kind, label: kind })),
    "Means over a fiftieth of the run each; from the start of the record.",
  );
}

const COLUMNS = ["total", "normal", "sliding", "tangential"];

export function kindFigure(run, column, kind) {
  const k = run.lines("power_by_kind/kind").indexOf(kind);
  return {
    value: run.values(`power_by_kind/${column}`)[k] ?? NaN,
    error: run.values(`power_by_kind/${column}_standard_error`)[k] ?? NaN,
  };
}

function sumOf(figures) {
  return figures.reduce((sum, f) => ({ value: sum.value + f.value, error: Math.hypot(sum.error, f.error) }), {
    value: 0,
    error: 0,
  });
}

// A share as a bar behind the number.
function share(value, total) {
  const bar = el("span", { class: "share" });
  bar.style.width = `${Math.max(0, Math.min(100, (100 * value) / total)).toFixed(1)}%`;
  return el("span", { class: "shared" }, bar, `${number((100 * value) / total)} %`);
}

function tableOfOne(run) {
  const kinds = run.lines("power_by_kind/kind");
  const total = sumOf(kinds.map((kind) => kindFigure(run, "total", kind)));
  const cells = (column, kind) => {
    const f = kindFigure(run, column, kind);
    return withError(f.value, f.error, "W");
  };
  const rows = kinds.map((kind) => [
    kind,
    ...COLUMNS.map((column) => cells(column, kind)),
    share(kindFigure(run, "total", kind).value, total.value),
  ]);
  const sums = COLUMNS.map((column) => sumOf(kinds.map((kind) => kindFigure(run, column, kind))));
  const last = ["all", ...sums.map((s) => withError(s.value, NaN, "W")), ""];
  last.strong = true;
  return dataTable(
    "Power by kind of collision",
    ["kind", "total", "normal damping", "sliding", "tangential damping", "share"],
    [...rows, last],
    "quiet",
  );
}

function tableOfMany(runs) {
  const kinds = [...new Set(runs.flatMap((run) => run.lines("power_by_kind/kind")))];
  const box = el("div");
  const fill = (column) => {
    const rows = kinds.map((kind) =>
      rowOf(
        kind,
        runs.map((run) => kindFigure(run, column, kind)),
        "W",
      ),
    );
    const last = rowOf(
      "all",
      runs.map((run) => sumOf(run.lines("power_by_kind/kind").map((kind) => kindFigure(run, column, kind)))),
      "W",
    );
    last.strong = true;
    box.replaceChildren(dataTable("Power by kind of collision", head(runs), [...rows, last], "quiet"));
  };
  fill("total");
  return el(
    "div",
    {},
    select(
      "Part",
      COLUMNS.map((c) => [c, c]),
      fill,
    ),
    box,
  );
}

function kindsCsv(runs) {
  const lines = ["run,kind,part,power [W],standard error [W]"];
  for (const run of runs) {
    for (const kind of run.lines("power_by_kind/kind")) {
      for (const column of COLUMNS) {
        const f = kindFigure(run, column, kind);
        lines.push(
          [
            `"${run.name.replaceAll('"', '""')}"`,
            kind,
            column,
            f.value,
            Number.isFinite(f.error) ? f.error : "",
          ].join(","),
        );
      }
    }
  }
  return `${lines.join("\n")}\n`;
}

function byKind(runs) {
  const told = runs.filter((run) => run.has("power_by_kind/total"));
  if (told.length === 0) return null;
  return el(
    "div",
    { class: "block" },
    el(
      "div",
      { class: "plot-head" },
      el("h3", {}, "Power by kind of collision"),
      csvButton("Power by kind of collision", () => kindsCsv(told)),
    ),
    told.length === 1 ? tableOfOne(told[0]) : tableOfMany(told),
    el(
      "p",
      { class: "note" },
      "Dissipation of the contacts between two groups, mean over the recorded window. Errors of the kinds are not independent, so the sum of a single run shows none; the errors of sums in a comparison are taken as if they were.",
    ),
  );
}

function wallPower(runs) {
  const [run] = runs;
  const walls = run.below("series/walls").filter((wall) => run.has(`series/walls/${wall}/power`));
  if (runs.length > 1 || walls.length < 2) return null;
  return plot({
    title: "Power of each wall over time",
    x: SERIES_TIME,
    y: { label: "power", unit: "W" },
    note: `In the last step before each record, smoothed over ${number(windowOf(run), 2)} s.`,
    series: walls.map((wall) => ({
      label: wall,
      x: run.time,
      y: smoothed(run.time, run.values(`series/walls/${wall}/power`), windowOf(run)),
    })),
  });
}

export function power(page) {
  const runs = page.runs.filter((run) => run.has("series/power"));
  if (runs.length === 0) return null;
  return section(
    "power",
    "Power",
    powerPlot(runs),
    byKind(runs),
    el("div", { class: "pair" }, kindsOverTime(runs), partsOverTime(runs), wallPower(runs)),
  );
}
