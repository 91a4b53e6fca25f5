// What power formulas of the literature say of the same mill, beside the simulation.
import { dataTable, el, section, svg } from "../dom.js";
import { number, parts, withError } from "../format.js";
import { csvButton } from "../plot.js";
import { colour, css, onTheme } from "../theme.js";

function rowsOf(run) {
  return run.lines("formulas/name").map((name, k) => ({
    name,
    low: run.values("formulas/low")[k],
    high: run.values("formulas/high")[k],
    source: run.lines("formulas/source")[k] ?? "",
    valid: run.lines("formulas/valid")[k] ?? "",
  }));
}

// Ranges of the formulas and the simulation with its error on one axis of power.
function picture(run) {
  const box = el("div", { class: "ranges" });
  const draw = () => {
    const f = run.figure("power_W"),
      e = Number.isFinite(f.error) ? f.error : 0;
    const rows = [
      ...rowsOf(run).map((r, k) => ({ ...r, k })),
      { name: "simulation", low: f.value - e, high: f.value + e, middle: f.value },
    ];
    const least = Math.min(...rows.map((r) => r.low)),
      most = Math.max(...rows.map((r) => r.high)),
      pad = 0.12 * (most - least || most);
    const x = (v) => 150 + (430 * (v - least + pad)) / (most - least + 2 * pad);
    const height = 34 * rows.length + 34;
    const root = svg("svg", {
      viewBox: `0 0 600 ${height}`,
      role: "img",
      "aria-label": `Power: ${rows.map((r) => `${r.name} ${number(r.low)} to ${number(r.high)} W`).join(", ")}`,
    });
    for (let k = 0; k <= 4; k += 1) {
      const v = least + ((most - least) * k) / 4,
        p = parts(v, NaN, "W");
      root.append(
        svg("line", { x1: x(v), x2: x(v), y1: 6, y2: height - 26, stroke: css("--grid") }),
        svg(
          "text",
          { x: x(v), y: height - 8, "text-anchor": "middle", fill: css("--text"), "font-size": 12 },
          `${number(Number(p.value.replace(/[^0-9.]/g, "")), 3)} ${p.unit}`,
        ),
      );
    }
    rows.forEach((r, k) => {
      const y = 22 + 34 * k,
        stroke = r.middle === undefined ? colour(r.k) : css("--text");
      root.append(
        svg("text", { x: 140, y: y + 4, "text-anchor": "end", fill: css("--text"), "font-size": 13 }, r.name),
        svg("line", {
          x1: x(r.low),
          x2: Math.max(x(r.high), x(r.low) + 1),
          y1: y,
          y2: y,
          stroke,
          "stroke-width": 5,
          "stroke-linecap": "round",
        }),
      );
      if (r.middle !== undefined) root.append(svg("circle", { cx: x(r.middle), cy: y, r: 6, fill: stroke }));
    });
    box.replaceChildren(root);
  };
  draw();
  onTheme(draw);
  return box;
}

function verdict(run) {
  const { power_formula_low_W: low, power_formula_high_W: high, power_within_formulas: within } = run.summary;
  if (within === undefined) return null;
  const band = `${withError(low, NaN, "W")} to ${withError(high, NaN, "W")}`;
  return el(
    "p",
    { class: within ? "good" : "warn" },
    within
      ? `The simulated power lies within what the formulas span, ${band}.`
      : `The simulated power lies outside of what the formulas span, ${band}.`,
  );
}

export function formulas(page) {
  const runs = page.runs.filter((run) => run.has("formulas/low"));
  if (runs.length === 0) return null;
  const csv = () =>
    [
      "run,formula,low [W],high [W],source,valid",
      ...runs.flatMap((run) =>
        rowsOf(run).map((r) =>
          [run.name, r.name, r.low, r.high, r.source, r.valid]
            .map((v) => `"${String(v).replaceAll('"', '""')}"`)
            .join(","),
        ),
      ),
    ].join("\n");
  return section(
    "formulas",
    "Power formulas",
    runs.map((run, k) =>
      el(
        "div",
        {},
        el(
          "div",
          { class: "plot-head" },
          el("h3", {}, runs.length > 1 ? run.name : "Beside the simulation"),
          k === 0 ? csvButton("Power formulas", csv) : null,
        ),
        verdict(run),
        picture(run),
        dataTable(
          "Formulas",
          ["formula", "power", "valid for", "source"],
          rowsOf(run).map((r) => [
            r.name,
            r.low === r.high
              ? withError(r.low, NaN, "W")
              : `${withError(r.low, NaN, "W")} – ${withError(r.high, NaN, "W")}`,
            r.valid,
            r.source,
          ]),
          "text quiet",
        ),
      ),
    ),
  );
}
