// A plot with its title, its legend, its keys and its numbers as CSV; uPlot draws.
//
// plot({ title, note, x: { label, unit, log, scale }, y: { label, unit, log, zero }, series: [{ label, x, y,
// error, spread, colour, dash, points, scatter, exact, labels }], marks: [{ at, label }] }). Lines may have places (x) of
// their own. Errors are whiskers, spreads are bands, labels stand beside their points, scatter leaves the line away, exact
// are places for the CSV where those drawn were set apart. On log axes what is not positive is left out.
import uPlot from "uplot";
import { download, el } from "./dom.js";
import { axisPrefix, labelled, number, powerOfTen, tickTexts } from "./format.js";
import { placeLabels } from "./labels.js";
import { colour, css, isPrinting, onTheme } from "./theme.js";

export const plots = []; // for tests: what is on the page

const PAPER = 660; // px, what fits between the margins
const FONT = "12px system-ui, sans-serif";

// Ticks at decades, at most `most` of them; below two decades at 1, 2 and 5 of each.
function decades(low, high, most) {
  if (high / low < 100) {
    const all = [];
    for (let k = Math.floor(Math.log10(low)); k <= Math.log10(high); k += 1)
      all.push(...[1, 2, 5].map((m) => m * 10 ** k));
    return all.filter((v) => v >= low * 0.999 && v <= high * 1.001);
  }
  const first = Math.ceil(Math.log10(low) - 1e-9),
    last = Math.floor(Math.log10(high) + 1e-9);
  const step = Math.max(1, Math.ceil((last - first + 1) / most));
  const ticks = [];
  for (let k = Math.ceil(first / step) * step; k <= last; k += step) ticks.push(10 ** k);
  return ticks;
}

function axis(spec, side, most) {
  const common = {
    label: labelled(spec.label, spec.unit),
    font: FONT,
    labelFont: FONT,
    labelSize: 22,
    stroke: () => css("--text"),
    grid: { stroke: () => css("--grid"), width: 1 },
    ticks: { stroke: () => css("--grid"), width: 1, size: 5 },
    size: side === "y" ? 62 : 40,
  };
  if (!spec.log) {
    return { ...common, values: (_, splits) => tickTexts(splits) };
  }
  return {
    ...common,
    splits: (u, _, low, high) => decades(low, high, most(u)),
    filter: (_, splits) => splits,
    values: (_, splits) => splits.map((v) => (v === null ? "" : logText(v))),
  };
}

// 10⁻⁶, 2·10⁻⁶; near one as plain numbers.
function logText(v) {
  const exponent = Math.floor(Math.log10(v) + 1e-9),
    mantissa = Math.round(v / 10 ** exponent);
  if (exponent >= -2 && exponent <= 3) return exponent >= 0 ? String(Math.round(v)) : v.toFixed(-exponent);
  return mantissa === 1 ? powerOfTen(exponent) : `${mantissa}·${powerOfTen(exponent)}`;
}

// Watts and joules on an even axis get the prefix that suits the largest; CSV stays in SI.
function scaled(spec) {
  const most = spec.series.reduce((m, line) => line.y.reduce((n, v) => Math.max(n, Math.abs(v ?? 0)), m), 0);
  const [size, prefix] = spec.y.log ? [1, ""] : axisPrefix(most, spec.y.unit);
  if (size === 1) return spec;
  const shrink = (list) => list?.map((v) => (v === null || v === undefined ? v : v / size));
  return {
    ...spec,
    y: { ...spec.y, unit: `${prefix}${spec.y.unit}` },
    series: spec.series.map((line) => ({
      ...line,
      y: shrink(line.y),
      error: shrink(line.error),
      spread: shrink(line.spread),
    })),
  };
}

const usable = (v, log) =>
  v === null || v === undefined || !Number.isFinite(v) || (log && v <= 0) ? null : v;

// One list of places for all lines.
function join(spec) {
  const tables = spec.series.map((line) => {
    const rows = line.x
      .map((x, k) => [usable(x, spec.x.log), k])
      .filter(([x]) => x !== null)
      .sort((a, b) => a[0] - b[0]);
    const pick = (list) => rows.map(([, k]) => usable(list[k], spec.y.log));
    const columns = [pick(line.y)];
    if (line.error) columns.push(rows.map(([, k]) => usable(line.error[k], false)));
    if (line.spread) {
      columns.push(rows.map(([, k]) => usable(line.y[k] + line.spread[k], spec.y.log)));
      columns.push(rows.map(([, k]) => usable(line.y[k] - line.spread[k], false)));
    }
    return [rows.map(([x]) => x), ...columns];
  });
  return tables;
}

// The drawn data, and for each line the row of its errors.
function assemble(spec) {
  const tables = join(spec);
  const joined = uPlot.join(tables);
  const data = [joined[0]],
    lines = [{}],
    errors = new Map(),
    bands = [];
  let at = 1;
  spec.series.forEach((line, k) => {
    const stroke = () => colour(line.colour ?? k);
    lines.push({
      label: line.label,
      stroke,
      width: line.scatter ? 0 : 1.75,
      dash: line.dash,
      spanGaps: true,
      points: { show: line.points ?? false, size: 7, fill: stroke },
      value: (_, v) => (v === null || v === undefined ? "" : number(v, 4)),
    });
    data.push(joined[at]);
    const main = data.length - 1;
    at += 1;
    if (line.error) {
      errors.set(main, joined[at]);
      at += 1;
    }
    if (line.spread) {
      for (let side = 0; side < 2; side += 1) {
        lines.push({
          label: "",
          stroke: "transparent",
          width: 0,
          points: { show: false },
          spanGaps: true,
          auxiliary: true,
        });
        data.push(joined[at]);
        at += 1;
      }
      bands.push({ series: [data.length - 2, data.length - 1], fill: () => `${colour(line.colour ?? k)}33` });
    }
  });
  return { data, lines, errors, bands };
}

function whiskers(errors) {
  return (u) => {
    const { ctx } = u;
    const half = 4 * devicePixelRatio;
    ctx.save();
    ctx.lineWidth = 1.25 * devicePixelRatio;
    for (const [k, error] of errors) {
      if (!u.series[k].show) continue;
      ctx.strokeStyle = u.series[k].stroke();
      ctx.beginPath();
      u.data[k].forEach((value, i) => {
        if (value === null || value === undefined || !(error[i] > 0)) return;
        const x = u.valToPos(u.data[0][i], "x", true);
        const low = u.valToPos(
          Math.max(value - error[i], u.scales.y.distr === 3 ? u.scales.y.min : -Infinity),
          "y",
          true,
        );
        const high = u.valToPos(value + error[i], "y", true);
        ctx.moveTo(x, low);
        ctx.lineTo(x, high);
        ctx.moveTo(x - half, low);
        ctx.lineTo(x + half, low);
        ctx.moveTo(x - half, high);
        ctx.lineTo(x + half, high);
      });
      ctx.stroke();
    }
    ctx.restore();
  };
}

function drawMarks(marks) {
  return (u) => {
    const { ctx, bbox } = u;
    ctx.save();
    ctx.strokeStyle = ctx.fillStyle = css("--muted");
    ctx.font = `${11 * devicePixelRatio}px system-ui, sans-serif`;
    ctx.setLineDash([4 * devicePixelRatio, 4 * devicePixelRatio]);
    for (const mark of marks) {
      const x = u.valToPos(mark.at, "x", true);
      if (!(x >= bbox.left && x <= bbox.left + bbox.width)) continue;
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      const left = x > bbox.left + 0.8 * bbox.width;
      ctx.textAlign = left ? "right" : "left";
      ctx.fillText(mark.label, x + (left ? -5 : 5) * devicePixelRatio, bbox.top + 13 * devicePixelRatio);
    }
    ctx.restore();
  };
}

// Texts beside points, in the colour of their line.
function drawLabels(spec) {
  return (u) => {
    const { ctx, bbox } = u;
    const px = devicePixelRatio;
    ctx.save();
    ctx.font = `${11 * px}px system-ui, sans-serif`;
    ctx.textAlign = "left";
    ctx.lineWidth = px / 2;
    const points = spec.series.flatMap((line, k) =>
      (line.labels ?? []).flatMap((text, i) => {
        if (usable(line.x[i], spec.x.log) === null || usable(line.y[i], spec.y.log) === null) return [];
        const at = { x: u.valToPos(line.x[i], "x", true) / px, y: u.valToPos(line.y[i], "y", true) / px };
        return [{ ...at, text, width: ctx.measureText(text).width / px, ink: colour(line.colour ?? k) }];
      }),
    );
    const frame = {
      left: bbox.left / px,
      right: (bbox.left + bbox.width) / px,
      top: bbox.top / px,
      bottom: (bbox.top + bbox.height) / px,
    };
    placeLabels(points, frame).forEach((place, k) => {
      const { x, y, text, ink } = points[k];
      ctx.fillStyle = ctx.strokeStyle = ink;
      ctx.fillText(text, place.left * px, place.base * px);
      if (!place.off) return;
      ctx.beginPath();
      ctx.moveTo(x * px, y * px);
      ctx.lineTo((place.left > x ? place.left - 2 : place.right + 2) * px, (place.base - 4) * px);
      ctx.stroke();
    });
    ctx.restore();
  };
}

function rangeOfPlaces(spec) {
  const even = (_, low, high) => {
    const pad = spec.series.some((line) => line.points) ? 0.04 * (high - low || 1) : 0;
    return low === null ? [0, 1] : [low - pad, high + pad];
  };
  return spec.x.log ? range({ log: true }) : even;
}

// Whiskers are part of what is to be seen.
function rangeOfValues(spec) {
  const plain = range(spec.y);
  if (spec.y.log) return plain;
  const ends = spec.series.flatMap((line) =>
    (line.error ?? []).flatMap((e, k) => {
      const known = usable(line.y[k], false) !== null && usable(e, false) !== null;
      return known ? [line.y[k] - e, line.y[k] + e] : [];
    }),
  );
  const [least, most] = [Math.min(...ends), Math.max(...ends)];
  return (u, low, high) =>
    low === null || ends.length === 0 ? plain(u, low, high) : plain(u, Math.min(low, least), Math.max(high, most));
}

function range(spec) {
  if (spec.log) return (_, low, high) => (low > 0 ? uPlot.rangeLog(low, high, 10, false) : [1, 10]);
  return (_, low, high) => {
    if (low === null || high === null) return [0, 1];
    const pad = 0.06 * (high - low || Math.abs(high) || 1);
    return [spec.zero && low >= 0 ? 0 : low - pad, spec.zero && high <= 0 ? 0 : high + pad];
  };
}

// "0 ... 12" of the drawn values, for those who do not see the plot.
function describe(spec, data) {
  const x = data[0],
    names = spec.series.map((line) => line.label).join(", ");
  return (
    `${spec.title}: ${labelled(spec.y.label, spec.y.unit)} against ${labelled(spec.x.label, spec.x.unit)}, ` +
    `${number(x[0])} to ${number(x.at(-1))}; ${names}. Arrow keys move the reading.`
  );
}

export function csvOf(spec) {
  const quote = (text) => `"${String(text).replaceAll('"', '""')}"`;
  const unit = (u) => (u === "1" ? "" : ` [${u}]`);
  const lines = [
    [
      `${spec.x.label}${unit(spec.x.unit)}`,
      "line",
      `${spec.y.label}${unit(spec.y.unit)}`,
      "standard error",
      "spread",
    ]
      .map(quote)
      .join(","),
  ];
  for (const line of spec.series) {
    line.x.forEach((x, k) => {
      const cells = [line.exact?.[k] ?? x, quote(line.label), line.y[k], line.error?.[k], line.spread?.[k]];
      lines.push(cells.map((v) => v ?? "").join(","));
    });
  }
  return `${lines.join("\n")}\n`;
}

export function fileName(title) {
  return `${title
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "_")
    .replace(/^_|_$/g, "")}.csv`;
}

export function csvButton(title, text) {
  return el(
    "button",
    {
      type: "button",
      class: "csv",
      "aria-label": `Numbers of: ${title}, as CSV`,
      onclick: () => download(fileName(title), text()),
    },
    "CSV",
  );
}

function moveReading(u, event) {
  const step = { ArrowLeft: -1, ArrowRight: 1, PageUp: -20, PageDown: 20 }[event.key];
  if (step === undefined) return;
  event.preventDefault();
  const last = u.data[0].length - 1;
  const at = Math.max(0, Math.min(last, (u.cursor.idx ?? 0) + step));
  u.setCursor({ left: u.valToPos(u.data[0][at], "x"), top: u.over.clientHeight / 2 });
}

function keysForLegend(host) {
  for (const entry of host.querySelectorAll(".u-legend .u-series th")) {
    entry.tabIndex = 0;
    entry.setAttribute("role", "button");
    entry.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      entry.click();
    });
  }
}

// `fresh` gives the specification; change() asks it again (another quantity was chosen).
export function plot(fresh) {
  let spec = typeof fresh === "function" ? fresh() : fresh;
  const host = el("div", { class: "plot-area", tabindex: "0", role: "img" });
  const title = el("h3", {}, spec.title);
  const note = el("p", { class: "note" });
  const figure = el(
    "figure",
    { class: "plot" },
    el(
      "div",
      { class: "plot-head" },
      title,
      csvButton(spec.title, () => csvOf(spec)),
    ),
    host,
    note,
  );
  let u = null;
  const entry = {
    figure,
    get spec() {
      return spec;
    },
    get data() {
      return u?.data;
    },
  };
  plots.push(entry);

  const size = () => {
    const width = isPrinting() ? Math.min(host.clientWidth, PAPER) : host.clientWidth;
    return { width: Math.max(240, width), height: width < 500 ? 260 : 320 };
  };
  const draw = () => {
    spec = typeof fresh === "function" ? fresh() : fresh;
    title.textContent = spec.title;
    note.textContent = spec.note ?? "";
    u?.destroy();
    const shown = scaled(spec);
    const { data, lines, errors, bands } = assemble(shown);
    lines[0] = {
      label: labelled(spec.x.label, spec.x.unit),
      value: (_, v) => (v === null || v === undefined ? "" : number(v, 4)),
    };
    u = new uPlot(
      {
        ...size(),
        scales: {
          x: { time: false, distr: spec.x.log ? 3 : 1, range: rangeOfPlaces(spec) },
          y: { distr: spec.y.log ? 3 : 1, range: rangeOfValues(shown) },
        },
        axes: [axis(spec.x, "x", (p) => p.width / 60), axis(shown.y, "y", (p) => p.height / 30)],
        series: lines,
        bands,
        cursor: { drag: { x: true, y: false } },
        // A line's look: filled, or framed with its dashes.
        legend: {
          live: true,
          markers: {
            width: 2,
            fill: (p, k) => (lines[k].dash ? "transparent" : p.series[k].stroke()),
            stroke: (p, k) => p.series[k].stroke(),
            dash: (_, k) => (lines[k].dash ? (lines[k].dash[0] > 3 ? "dashed" : "dotted") : "solid"),
          },
        },
        hooks: { draw: [whiskers(errors), drawMarks(spec.marks ?? []), drawLabels(shown)] },
      },
      data,
      host,
    );
    lines.forEach((line, k) => {
      if (line.auxiliary) host.querySelectorAll(".u-legend .u-series")[k].hidden = true;
    });
    host.setAttribute("aria-label", describe(spec, data));
    keysForLegend(host);
  };
  host.addEventListener("keydown", (event) => u && event.target === host && moveReading(u, event));
  let width = 0;
  new ResizeObserver(() => {
    if (host.clientWidth === width || host.clientWidth === 0) return;
    width = host.clientWidth;
    if (u) u.setSize(size());
    else draw();
  }).observe(host);
  onTheme(() => u && draw());
  figure.change = draw;
  return figure;
}
