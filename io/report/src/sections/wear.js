// Wear along one pitch of the liner, over the section of the lifter, by model.
import { dataTable, el, section, select } from "../dom.js";
import { number, withError } from "../format.js";
import { plot } from "../plot.js";
import { colour, css, onTheme } from "../theme.js";
import { head, rowOf } from "./headline.js";
import { dashOf, nameIn } from "./power.js";

const MODELS = [
  ["siem", "SIEM"],
  ["sliding", "SIEM, sliding only"],
  ["archard", "Archard"],
  ["finnie", "Finnie"],
];
const told = (run) => MODELS.filter(([name]) => run.has(`wear_profile/${name}`));

function rates(runs) {
  const many = runs.length > 1;
  return plot({
    title: "Wear along one pitch",
    x: { label: "arc along the section", unit: "mm" },
    y: { label: "depth", unit: "mm per 1000 h", zero: true },
    series: runs.flatMap((run) =>
      told(run)
        .filter(([name]) => !many || name === "siem")
        .map(([name, label], k) => ({
          label: nameIn(runs, run, label),
          colour: many ? run.index : k,
          dash: dashOf(run),
          x: run.values("wear_profile/arc").map((v) => 1000 * v),
          y: run.values(`wear_profile/${name}`),
          spread: run.has(`wear_profile/${name}_spread`)
            ? run.values(`wear_profile/${name}_spread`)
            : undefined,
        })),
    ),
    note: "Mean over the equal lifters; the band is their standard deviation. One pitch of the section, in the direction of increasing angle.",
  });
}

function loads(runs) {
  if (!runs.every((run) => run.has("wear_profile/pressure"))) return null;
  return plot({
    title: "Pressure and shear along one pitch",
    x: { label: "arc along the section", unit: "mm" },
    y: { label: "time mean", unit: "Pa", zero: true },
    series: runs.flatMap((run) =>
      ["pressure", "shear"]
        .filter((name) => run.has(`wear_profile/${name}`))
        .map((name, k) => ({
          label: nameIn(runs, run, name),
          colour: k,
          dash: dashOf(run),
          x: run.values("wear_profile/arc").map((v) => 1000 * v),
          y: run.values(`wear_profile/${name}`),
        })),
    ),
  });
}

// The pitch with its middle upwards: u along the shell in the direction of increasing angle, v inwards (m).
function section2d(run) {
  const x = run.values("wear_profile/x"),
    y = run.values("wear_profile/y");
  const sx = x.reduce((a, b) => a + b, 0),
    sy = y.reduce((a, b) => a + b, 0),
    middle = Math.atan2(sy, sx);
  const c = Math.cos(middle),
    s = Math.sin(middle),
    radius = Math.max(...x.map((_, k) => Math.hypot(x[k], y[k])));
  return x.map((_, k) => [-s * x[k] + c * y[k], radius - (c * x[k] + s * y[k])]);
}

// Into the steel: away from the charge, which lies above.
function normals(points) {
  const rising = points.at(-1)[0] >= points[0][0] ? 1 : -1;
  return points.map((_, k) => {
    const [a, b] = [points[Math.max(0, k - 1)], points[Math.min(points.length - 1, k + 1)]];
    const dx = b[0] - a[0],
      dy = b[1] - a[1],
      length = Math.hypot(dx, dy) || 1;
    return [(rising * dy) / length, (-rising * dx) / length];
  });
}

function drawSection(canvas, runs, model) {
  const ratio = Math.min(devicePixelRatio, 2),
    width = canvas.parentElement.clientWidth,
    shape = section2d(runs[0]);
  const wide = shape.at(-1)[0] - shape[0][0],
    tall = Math.max(...shape.map((p) => p[1]));
  const height = Math.max(
    120,
    Math.min(360, (0.94 * width * (1.35 * tall + 0.02 * Math.abs(wide))) / Math.abs(wide) / 0.86),
  );
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  canvas.style.height = `${height}px`;
  const context = canvas.getContext("2d");
  const outlines = runs.map(section2d),
    all = outlines.flat();
  const low = Math.min(...all.map((p) => p[0])),
    high = Math.max(...all.map((p) => p[0])),
    top = Math.max(...all.map((p) => p[1]));
  const below = 0.35 * top + 0.02 * (high - low);
  const scale = Math.min((0.94 * width) / (high - low), (0.86 * height) / (top + below)) * ratio;
  const place = ([u, v]) => [
    canvas.width / 2 + (u - 0.5 * (low + high)) * scale,
    0.07 * canvas.height + (top - v) * scale,
  ];
  const most = Math.max(...runs.flatMap((run) => run.values(`wear_profile/${model}`).map((v) => v ?? 0)));
  const deepest = 0.3 * top; // of the picture: where the most worn place is drawn
  const path = (points) =>
    points.forEach((p, k) => (k === 0 ? context.moveTo(...place(p)) : context.lineTo(...place(p))));
  context.beginPath();
  path([...outlines[0], [outlines[0].at(-1)[0], -below], [outlines[0][0][0], -below]]);
  context.closePath();
  context.fillStyle = css("--liner");
  context.fill();
  const tint = (run) => (runs.length > 1 ? run.index : 1);
  runs.forEach((run, r) => {
    const depth = run.values(`wear_profile/${model}`),
      outward = normals(outlines[r]);
    const worn = outlines[r].map(([u, v], k) => [
      u + (outward[k][0] * deepest * (depth[k] ?? 0)) / most,
      v + (outward[k][1] * deepest * (depth[k] ?? 0)) / most,
    ]);
    context.beginPath();
    path([...outlines[r], ...worn.slice().reverse()]);
    context.closePath();
    context.fillStyle = `${colour(tint(run))}${runs.length > 1 ? "44" : "aa"}`;
    context.fill();
    context.strokeStyle = colour(tint(run));
    context.lineWidth = 1.5 * ratio;
    context.beginPath();
    path(worn);
    context.stroke();
  });
  context.strokeStyle = css("--text");
  context.lineWidth = 2 * ratio;
  context.beginPath();
  path(outlines[0]);
  context.stroke();
  context.fillStyle = css("--text");
  context.font = `${12 * ratio}px system-ui, sans-serif`;
  const forward = (runs[0].speed || 1) >= 0;
  context.textAlign = forward ? "right" : "left";
  context.fillText(
    forward ? "moves this way →" : "← moves this way",
    forward ? canvas.width - 8 * ratio : 8 * ratio,
    16 * ratio,
  );
  return most / 1000 / deepest;
}

function picture(runs) {
  const canvas = el("canvas", {
    role: "img",
    "aria-label": "Section of one pitch of the liner with the worn depth drawn into it",
  });
  const box = el("div", { class: "lifter" }, canvas),
    note = el("p", { class: "note" });
  let model = told(runs[0])[0][0];
  const draw = () => {
    if (!(box.clientWidth > 0)) return;
    const shrink = drawSection(canvas, runs, model);
    const hours = shrink > 0 ? 1000 / shrink : NaN;
    note.textContent =
      `The coloured layer is what is worn off in about ${number(hours, 2)} h at this rate, in the scale of the section` +
      (runs.length > 1 ? "; colours as in the plot below." : ".");
  };
  new ResizeObserver(draw).observe(box);
  onTheme(draw);
  const options = told(runs[0]).filter(([name]) => runs.every((run) => run.has(`wear_profile/${name}`)));
  return el(
    "figure",
    { class: "plot" },
    el(
      "div",
      { class: "plot-head" },
      el("h3", {}, "Worn layer over the section"),
      select("Model", options, (name) => {
        model = name;
        draw();
      }),
    ),
    box,
    note,
  );
}

function totals(runs) {
  const rows = MODELS.filter(([name]) => runs.some((run) => Number.isFinite(run.summary[`wear_${name}_m3`])));
  if (rows.length === 0) return null;
  if (runs.length > 1)
    return dataTable(
      "Worn volume of the walls in the recorded time",
      head(runs),
      rows.map(([name, label]) =>
        rowOf(
          label,
          runs.map((run) => run.figure(`wear_${name}_m3`)),
          "m³",
        ),
      ),
    );
  const [run] = runs;
  return dataTable(
    "Worn volume of the walls in the recorded time",
    ["model", "volume", "calibration factor"],
    rows.map(([name, label]) => [
      label,
      `${withError(run.summary[`wear_${name}_m3`], NaN, "m³")}`,
      number(run.summary[`wear_${name}_factor`]),
    ]),
  );
}

function ofGroups(runs) {
  return runs
    .filter((run) => run.lines("wear_of_groups/group").length > 0)
    .map((run) => {
      const shown = MODELS.filter(([name]) => run.has(`wear_of_groups/volume_${name}`));
      return dataTable(
        nameIn(runs, run, "Wear of the particles in the recorded time"),
        ["group", ...shown.map(([, label]) => label)],
        run
          .lines("wear_of_groups/group")
          .map((group, k) => [
            group,
            ...shown.map(([name]) => withError(run.values(`wear_of_groups/volume_${name}`)[k], NaN, "m³")),
          ]),
      );
    });
}

export function wear(page) {
  const withProfile = page.runs.filter((run) => run.has("wear_profile/arc") && told(run).length > 0);
  const runs = page.runs.filter(
    (run) => Number.isFinite(run.summary.wear_siem_m3) || withProfile.includes(run),
  );
  if (runs.length === 0) return null;
  return section(
    "wear",
    "Wear of the liner",
    withProfile.length > 0
      ? [picture(withProfile), el("div", { class: "pair" }, rates(withProfile), loads(withProfile))]
      : null,
    totals(runs),
    ofGroups(runs),
  );
}
