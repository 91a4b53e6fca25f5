// Parallel coordinates: an axis for each factor and response, a line for each case. With the plot in
// focus the arrows go from case to case.
import { el, svg } from "../dom.js";
import { number, unitText } from "../format.js";
import { colour, onTheme } from "../theme.js";
import { csvButton } from "../plot.js";
import { axesOf, axisOf, known } from "./sweep_model.js";

const HEIGHT = 300,
  TOP = 46,
  BOTTOM = 24,
  STEP = 132; // px at least between axes

function rangeOf(values) {
  const all = values.filter(known);
  const low = Math.min(...all),
    high = Math.max(...all);
  return all.length === 0 ? [0, 1] : low === high ? [low - 0.5, high + 0.5] : [low, high];
}

export function parallel(sweep, csv) {
  const axes = axesOf(sweep).map(([id]) => axisOf(sweep, id));
  const ranges = axes.map((axis) => rangeOf(axis.values));
  const width = Math.max(300, STEP * (axes.length - 1) + 120);
  const x = (a) => 60 + (a * (width - 120)) / Math.max(1, axes.length - 1);
  const y = (a, v) =>
    TOP + (HEIGHT - TOP - BOTTOM) * (1 - (v - ranges[a][0]) / (ranges[a][1] - ranges[a][0]));
  const reading = el("output", { class: "reading" });
  const picture = svg("svg", { viewBox: `0 0 ${width} ${HEIGHT}`, width, height: HEIGHT, "aria-hidden": "true" });
  const rows = sweep.cases
    .map((entry, k) => ({ entry, k }))
    .filter(({ k }) => axes.every((axis) => known(axis.values[k])));
  const first = axes[0];
  const lines = rows.map(({ k }) => {
    const points = axes.map((axis, a) => `${x(a).toFixed(1)},${y(a, axis.values[k]).toFixed(1)}`).join(" ");
    return svg("polyline", { points, fill: "none", class: "case-line" });
  });
  const levels = [...new Set(rows.map(({ k }) => first.values[k]))].sort((a, b) => a - b);
  let at = -1;
  const paint = () =>
    lines.forEach((line, row) => {
      line.setAttribute("stroke", colour(levels.indexOf(first.values[rows[row].k]) % 8));
      line.setAttribute("stroke-width", row === at ? "3.5" : "1.25");
      line.setAttribute("stroke-opacity", at < 0 || row === at ? "1" : "0.3");
    });
  const show = (row) => {
    at = row;
    paint();
    const k = rows[row]?.k;
    reading.value =
      row < 0
        ? ""
        : `${sweep.cases[k].name}: ${axes.map((a) => `${a.label} ${number(a.values[k], 4)} ${unitText(a.unit)}`).join(", ")}`;
  };
  picture.append(...lines);
  axes.forEach((axis, a) => {
    const text = (dy, content, anchor = "middle") =>
      svg("text", { x: x(a), y: dy, "text-anchor": anchor, class: "axis-text" }, content);
    picture.append(
      svg("line", { x1: x(a), x2: x(a), y1: TOP, y2: HEIGHT - BOTTOM, class: "axis-line" }),
      text(14, axis.label),
      text(28, unitText(axis.unit)),
      text(42, number(ranges[a][1])),
      text(HEIGHT - 8, number(ranges[a][0])),
    );
  });
  lines.forEach((line, row) => line.addEventListener("pointerenter", () => show(row)));
  paint();
  onTheme(paint);
  const host = el("div", {
    class: "parallel",
    tabindex: "0",
    role: "img",
    "aria-label": `All cases on ${axes.length} axes: ${axes.map((a) => a.label).join(", ")}. Arrow keys go from case to case.`,
  });
  host.append(picture);
  host.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
    if (event.key === "Escape") show(-1);
    if (step === undefined || lines.length === 0) return;
    event.preventDefault();
    show((at + step + lines.length) % lines.length);
  });
  return el(
    "figure",
    {},
    el("div", { class: "plot-head" }, el("h3", {}, "All cases, all axes"), csvButton("all cases", csv)),
    host,
    reading,
    el("p", { class: "note" }, "A line for each case, coloured by the first axis. Point at a line, or use the arrow keys."),
  );
}
