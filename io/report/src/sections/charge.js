// Where the charge lies: the mean map of the cross-section, named angles, their course.
import { diverging, heat, viridis } from "../colours.js";
import { turned } from "../derived.js";
import { checkbox, dataTable, el, section, select } from "../dom.js";
import { number, withError } from "../format.js";
import { colourBar } from "../legend.js";
import { PolarGrid, mapFigure } from "../map.js";
import { csvButton, plot } from "../plot.js";
import { head, rowOf } from "./headline.js";
import { dashOf, nameIn } from "./power.js";

const ANGLES = [
  ["shoulder", "shoulder"],
  ["head", "head"],
  ["toe", "bulk toe"],
  ["impact_toe", "impact toe"],
  ["dynamic_angle", "dynamic angle"],
];
const KNOWN = { solid_fraction: ["solid fraction", viridis], speed: ["mean speed", heat] };

const gridOf = (run) => new PolarGrid(run.values("charge_map/radius"), run.values("charge_map/angle"));

function fieldsOf(run) {
  const fields = [["solid_fraction", ...KNOWN.solid_fraction]];
  if (run.has("charge_map/speed")) fields.push(["speed", ...KNOWN.speed]);
  for (const name of run.below("charge_map").filter((n) => n.startsWith("solid_fraction_"))) {
    fields.push([name, `solid fraction of ${name.slice(15)}`, viridis]);
  }
  return fields;
}

function raysOf(run) {
  return ANGLES.filter(
    ([name]) => name !== "dynamic_angle" && Number.isFinite(run.summary[`${name}_deg`]),
  ).map(([name, label]) => ({
    label,
    angle: run.summary[`${name}_deg`],
    dash: name === "head" || name === "impact_toe",
  }));
}

// The liner as it stands at the end of the run.
function profileOf(run) {
  const mill = run.scene?.mill;
  if (!mill) return [];
  const angle = turned(mill.rotation, run.endTime),
    c = Math.cos(angle),
    s = Math.sin(angle);
  return mill.profile.map(([x, y]) => [c * x - s * y, s * x + c * y]);
}

function arrowsOf(run) {
  if (!run.has("charge_map/velocity_x")) return null;
  return {
    x: run.values("charge_map/velocity_x"),
    y: run.values("charge_map/velocity_y"),
    speed: run.values("charge_map/speed"),
    solid: run.values("charge_map/solid_fraction"),
  };
}

const most = (values) => values.reduce((a, b) => Math.max(a, b ?? 0), 0);

class Maps {
  constructor(runs) {
    this.runs = runs;
    this.grids = runs.map(gridOf);
    this.field = "solid_fraction";
    this.arrows = runs.every((run) => run.has("charge_map/velocity_x"));
    this.profiles = runs.map(profileOf);
    this.legend = el("div", { class: "legend" });
    this.figures = runs.map((run, k) => mapFigure(nameIn(runs, run, "Cross-section"), () => this.content(k)));
    if (runs.length === 2 && this.grids[0].sameAs(this.grids[1])) {
      this.figures.push(mapFigure("Difference", () => this.difference()));
    }
    this.paintLegend();
  }

  get label() {
    return fieldsOf(this.runs[0]).find(([name]) => name === this.field);
  }

  get unit() {
    return this.runs[0].unit(`charge_map/${this.field}`);
  }

  get high() {
    return most(this.runs.flatMap((run) => run.values(`charge_map/${this.field}`))) || 1;
  }

  content(k) {
    const run = this.runs[k],
      [, label, lookup] = this.label,
      solid = run.values("charge_map/solid_fraction");
    return {
      grid: this.grids[k],
      values: run.values(`charge_map/${this.field}`),
      low: 0,
      high: this.high,
      lookup,
      label,
      unit: this.unit,
      profile: this.profiles[k],
      rays: raysOf(run),
      arrows: this.arrows ? arrowsOf(run) : null,
      faint: (cell) => !(solid[cell] > 0.005),
    };
  }

  difference() {
    const [a, b] = this.runs.map((run) => run.values(`charge_map/${this.field}`));
    const values = a.map((v, k) => (b[k] ?? 0) - (v ?? 0)),
      high = most(values.map(Math.abs)) || 1;
    this.spread = high;
    return {
      grid: this.grids[0],
      values,
      low: -high,
      high,
      lookup: diverging,
      label: "difference",
      unit: this.unit,
      profile: this.profiles[0],
      rays: [],
      arrows: null,
      faint: (cell) => !this.runs.some((run) => run.values("charge_map/solid_fraction")[cell] > 0.005),
    };
  }

  paintLegend() {
    const [, label, lookup] = this.label;
    const bars = [colourBar(label, this.unit, 0, this.high, lookup)];
    if (this.figures.length > this.runs.length) {
      this.difference();
      bars.push(
        colourBar(
          `${this.runs[1].name} − ${this.runs[0].name}`,
          this.unit,
          -this.spread,
          this.spread,
          diverging,
        ),
      );
    }
    this.legend.replaceChildren(...bars);
  }

  redraw() {
    this.paintLegend();
    for (const figure of this.figures) figure.draw();
  }

  csv() {
    const lines = [
      `run,radius [m],angle [deg],${fieldsOf(this.runs[0])
        .map(([name]) => `${name} [${this.runs[0].unit(`charge_map/${name}`)}]`)
        .join(",")}`,
    ];
    for (const run of this.runs) {
      const radius = run.values("charge_map/radius"),
        angle = run.values("charge_map/angle");
      const columns = fieldsOf(this.runs[0]).map(([name]) => run.values(`charge_map/${name}`));
      radius.forEach((r, ring) =>
        angle.forEach((a, k) => {
          lines.push(
            [
              `"${run.name.replaceAll('"', '""')}"`,
              r,
              a,
              ...columns.map((c) => c[ring * angle.length + k] ?? ""),
            ].join(","),
          );
        }),
      );
    }
    return `${lines.join("\n")}\n`;
  }

  controls() {
    return el(
      "div",
      { class: "controls" },
      select(
        "Show",
        fieldsOf(this.runs[0]).map(([name, label]) => [name, label]),
        (name) => {
          this.field = name;
          this.redraw();
        },
      ),
      this.arrows
        ? checkbox("velocity arrows", true, (on) => {
            this.arrows = on;
            this.redraw();
          })
        : null,
    );
  }

  element() {
    const names = [...this.runs.map((run) => run.name), `${this.runs[1]?.name} − ${this.runs[0].name}`];
    return el(
      "div",
      {},
      el(
        "div",
        { class: "plot-head" },
        el("h3", {}, "Mean over the cross-section"),
        csvButton("Map of the charge", () => this.csv()),
      ),
      this.controls(),
      el(
        "div",
        { class: "maps" },
        this.figures.map((figure, k) =>
          this.figures.length > 1 ? el("div", {}, el("h4", {}, names[k]), figure) : figure,
        ),
      ),
      this.legend,
      el(
        "p",
        { class: "note" },
        `Seen along −z, as the 3D view; mean of ${number(this.runs[0].summary.charge_snapshots)} snapshots. The liner stands as at the end of the run.` +
          (this.arrows ? " The longest arrow is the fastest cell." : ""),
      ),
    );
  }
}

function angleTable(runs) {
  const told = ANGLES.filter(([name]) => runs.some((run) => Number.isFinite(run.summary[`${name}_deg`])));
  if (told.length === 0) return null;
  if (runs.length > 1) {
    return dataTable(
      "Angles",
      head(runs),
      told.map(([name, label]) =>
        rowOf(
          label,
          runs.map((run) => run.figure(`${name}_deg`)),
          "°",
        ),
      ),
    );
  }
  const [run] = runs;
  const degrees = (v) => (Number.isFinite(v) ? `${v.toFixed(1)}°` : "–");
  const at = (name, cut) => degrees(run.summary[`${name}_deg_at_${cut}`]);
  const rows = told.map(([name, label]) => {
    const f = run.figure(`${name}_deg`);
    return [
      label,
      withError(f.value, f.error, "°"),
      degrees(run.summary[`${name}_deg_spread`]),
      at(name, 0.4),
      at(name, 0.6),
    ];
  });
  return dataTable(
    "Angles, counterclockwise from +x",
    ["", "mean map", "spread of snapshots", "bulk above 0.4 of the bed", "above 0.6"],
    rows,
  );
}

function course(runs) {
  const told = runs.filter((run) => run.has("series_of_charge/time"));
  if (told.length === 0) return null;
  return plot({
    title: "Shoulder and toe over time",
    x: { label: "time", unit: "s" },
    y: { label: "angle", unit: "deg" },
    series: told.flatMap((run) =>
      ["shoulder", "toe"]
        .filter((name) => run.has(`series_of_charge/${name}`))
        .map((name, k) => ({
          label: nameIn(runs, run, name),
          colour: k,
          dash: dashOf(run),
          x: run.values("series_of_charge/time"),
          y: run.values(`series_of_charge/${name}`),
        })),
    ),
    note: "Of single snapshots; gaps are snapshots without a bulk.",
  });
}

export function charge(page) {
  const runs = page.runs.filter((run) => run.has("charge_map/solid_fraction"));
  if (runs.length === 0) return null;
  const maps = new Maps(runs);
  return section(
    "charge",
    "Shape of the charge",
    el(
      "div",
      { class: runs.length > 1 ? "" : "pair" },
      maps.element(),
      el("div", {}, angleTable(runs), course(runs)),
    ),
  );
}
