// The page of `quern sweep`: responses over factors, effects, all cases, the two ends in motion.
import { keepBlobs } from "../data.js";
import { dataTable, el, section, select } from "../dom.js";
import { number, plain, unitText, withError } from "../format.js";
import { csvButton, plot } from "../plot.js";
import { Clock } from "../viewer/clock.js";
import { axesOf, axisOf, factorLabel, known, labelOf, levelsOf, pointsOf, summarize } from "./sweep_model.js";
import { parallel } from "./sweep_parallel.js";

const degrees = (unit) => (unit === "deg" ? "°" : unit);
const responseOptions = (sweep) => sweep.responses.map((r, k) => [String(k), labelOf(r.name)]);

const BARS = [
  ["between", "spread between seeds"],
  ["within", "blocks of each run"],
];
const barNote = (bars) =>
  bars === "between"
    ? "Bars: standard error of the mean by the spread between seeds."
    : "Bars: standard error by what each run says of its own blocks, of the mean over seeds.";

// Cases of all points where the other factors are the same: a line for each.
function linesOver(sweep, x, response, bars) {
  const points = pointsOf(sweep);
  const axis = axisOf(sweep, `factor:${x}`);
  const others = sweep.factors.filter((_, k) => k !== x);
  const groups = new Map();
  for (const cases of points) {
    const name = others.map((f) => f.texts[cases[0]]).join(", ");
    if (!groups.has(name)) groups.set(name, []);
    groups.get(name).push(cases);
  }
  const MOST = 10;
  if (groups.size > MOST) return [{ label: "all", groups: points }].map(({ label, groups: g }) => line(label, g, true));
  return [...groups].map(([label, g]) => line(label || "all", g, false));

  function line(label, list, scatter) {
    const rows = list
      .map((cases) => ({ at: axis.values[cases[0]], ...summarize(response, cases) }))
      .filter((row) => known(row.mean))
      .sort((a, b) => a.at - b.at);
    const shown = apart(rows.map((row) => row.at));
    return {
      label,
      x: shown,
      exact: rows.map((row) => row.at),
      y: rows.map((row) => row.mean),
      error: rows.map((row) => (known(row[bars]) ? row[bars] : 0)),
      points: true,
      scatter,
    };
  }
}

// Equal places are set apart by a hair, so that each keeps its point.
function apart(places) {
  const seen = new Map(),
    span = Math.max(...places) - Math.min(...places) || 1;
  return places.map((at) => {
    const before = seen.get(at) ?? 0;
    seen.set(at, before + 1);
    return at + before * span * 1e-7;
  });
}

function responsesOver(sweep) {
  const replicated = pointsOf(sweep).some((cases) => cases.length > 1);
  let x = 0,
    bars = replicated ? "between" : "within";
  const shown = sweep.responses.slice(0, 4).map((_, k) => k);
  const figures = shown.map((_, place) =>
    plot(() => {
      const response = sweep.responses[shown[place]],
        axis = axisOf(sweep, `factor:${x}`);
      return {
        title: labelOf(response.name),
        note: axis.texts ? axis.texts.map((text, k) => `${k + 1}: ${text}`).join(", ") : "",
        x: { label: axis.label, unit: degrees(axis.unit) },
        y: { label: labelOf(response.name), unit: degrees(response.unit) },
        series: linesOver(sweep, x, response, bars),
      };
    }),
  );
  const note = el("p", { class: "note" }, barNote(bars));
  const again = () => figures.forEach((figure) => figure.change());
  const choices = [
    select("Over", sweep.factors.map((f, k) => [String(k), factorLabel(f)]), (value) => {
      x = Number(value);
      again();
    }),
  ];
  if (replicated) {
    choices.push(
      select("Bars", BARS, (value) => {
        bars = value;
        note.textContent = barNote(bars);
        again();
      }),
    );
  }
  const blocks = figures.map((figure, place) => {
    const choice = select(`Plot ${place + 1}`, responseOptions(sweep), (value) => {
      shown[place] = Number(value);
      figure.change();
    });
    choice.querySelector("select").value = String(shown[place]);
    return el("div", {}, choice, figure);
  });
  return section("responses", "Responses", el("div", { class: "controls" }, choices), el("div", { class: "pair" }, blocks), note);
}

// Of a factor the mean response at each level, all other factors mixed.
function effectsOf(sweep, response) {
  const all = sweep.cases.map((_, k) => k);
  return sweep.factors.map((factor) => {
    const levels = levelsOf(factor).map((level) => ({ ...level, ...summarize(response, all.filter(level.has)) }));
    const means = levels.map((l) => l.mean).filter(known);
    return { factor, levels, size: means.length ? Math.max(...means) - Math.min(...means) : NaN };
  });
}

function effects(sweep) {
  let row = 0;
  const figure = plot(() => {
    const response = sweep.responses[row];
    return {
      title: `Main effects on ${labelOf(response.name)}`,
      note: "Mean over all cases at each level of a factor, against where the level lies between the factor's least and greatest.",
      x: { label: "level: 0 least, 1 greatest", unit: "1" },
      y: { label: labelOf(response.name), unit: degrees(response.unit) },
      series: effectsOf(sweep, response).map(({ factor, levels }) => {
        const span = levels.length > 1 ? levels.at(-1).at - levels[0].at : 1;
        return {
          label: factorLabel(factor),
          x: levels.map((l) => (l.at - levels[0].at) / span),
          y: levels.map((l) => (known(l.mean) ? l.mean : null)),
          labels: levels.map((l) => l.text),
          points: true,
        };
      }),
    };
  });
  const head = ["", ...sweep.factors.map(factorLabel)];
  const rows = sweep.responses.map((response) => [
    `${labelOf(response.name)} (${unitText(degrees(response.unit)) || "1"})`,
    ...effectsOf(sweep, response).map((effect) => number(effect.size)),
  ]);
  const choice = select("Of", responseOptions(sweep), (value) => {
    row = Number(value);
    figure.change();
  });
  return section("effects", "Main effects", choice, figure, dataTable("Greatest less least mean over the levels of a factor", head, rows));
}

function scatter(sweep) {
  const options = axesOf(sweep);
  const start = sweep.responses.map((_, k) => `response:${k}`);
  let x = start.length > 1 ? start[0] : "factor:0",
    y = start[1] ?? start[0],
    by = 0;
  const figure = plot(() => {
    const a = axisOf(sweep, x),
      b = axisOf(sweep, y);
    return {
      title: `${b.label} against ${a.label}`,
      note: "A point for each case.",
      x: { label: a.label, unit: degrees(a.unit) },
      y: { label: b.label, unit: degrees(b.unit) },
      series: levelsOf(sweep.factors[by]).map((level) => {
        const rows = sweep.cases.map((_, k) => k).filter((k) => level.has(k) && known(a.values[k]) && known(b.values[k]));
        return {
          label: level.text,
          x: apart(rows.map((k) => a.values[k])),
          exact: rows.map((k) => a.values[k]),
          y: rows.map((k) => b.values[k]),
          error: b.errors ? rows.map((k) => (known(b.errors[k]) ? b.errors[k] : 0)) : undefined,
          points: true,
          scatter: true,
        };
      }),
    };
  });
  const choose = (label, value, set) => {
    const choice = select(label, options, (chosen) => {
      set(chosen);
      figure.change();
    });
    choice.querySelector("select").value = value;
    return choice;
  };
  return section(
    "scatter",
    "Any two axes",
    el(
      "div",
      { class: "controls" },
      choose("Across", x, (v) => (x = v)),
      choose("Up", y, (v) => (y = v)),
      select("Colour", sweep.factors.map((f, k) => [String(k), factorLabel(f)]), (v) => {
        by = Number(v);
        figure.change();
      }),
    ),
    figure,
  );
}

// The mills with the least and the most of a response, in motion beside each other.
function endsInMotion(page, sweep) {
  const shown = sweep.responses.map((r, k) => [String(k), labelOf(r.name), r]).filter(([, , r]) => r.ends.length === 2);
  const usable = shown.filter(([, , r]) => r.ends.every((k) => page.runs[k]?.view) && r.ends[0] !== r.ends[1]);
  if (usable.length === 0) return null;
  keepBlobs();
  const place = el("div", {});
  const made = new Map(); // a pair of pictures is made once
  const show = async (row) => {
    const response = sweep.responses[row];
    if (!made.has(row)) made.set(row, pairOf(page, response));
    place.replaceChildren(made.get(row).element);
    await made.get(row).start();
  };
  const part = section(
    "ends",
    "Least and most",
    select("Of", usable.map(([k, label]) => [k, label]), (value) => show(Number(value))),
    place,
    el("p", { class: "note" }, "By the mean of a point; its first seed is shown. Drag turns, wheel or pinch zooms. With a picture in focus: space plays, ← → step."),
  );
  show(Number(usable[0][0]));
  return part;
}

function pairOf(page, response) {
  const runs = response.ends.map((k) => page.runs[k]);
  const clock = new Clock(runs);
  const controls = el("div", {});
  const words = ["Least", "Most"];
  const figures = clock.viewers.map((viewer, k) =>
    el(
      "div",
      { class: "view" },
      el("h3", {}, `${words[k]}: ${withError(runs[k].summary[response.name], runs[k].summary[`${response.name}_standard_error`], degrees(response.unit))}`),
      el("p", { class: "note" }, runs[k].name),
      viewer.host,
      el("div", { class: "legends" }, viewer.legend, viewer.wallLegend),
    ),
  );
  const element = el("div", {}, el("div", { class: "views of2" }, figures), controls);
  let started = null;
  const begin = async () => {
    try {
      await clock.start();
      controls.replaceChildren(clock.controls());
    } catch (error) {
      console.error(error);
      element.prepend(el("p", { class: "note" }, `No picture (does this browser have WebGL?): ${error.message}`));
    }
  };
  return { element, start: () => (started ??= begin()) };
}

const link = (entry) => el("a", { href: `${encodeURIComponent(entry.name)}/report.html` }, entry.name);

function cases(sweep) {
  const head = [
    "case",
    ...sweep.factors.map((f) => `${factorLabel(f)}`),
    "seed",
    ...sweep.responses.map((r) => `${labelOf(r.name)}${r.unit === "1" ? "" : `, ${unitText(degrees(r.unit))}`}`),
  ];
  const rows = sweep.cases.map((entry, k) => [
    entry.status === "missing" ? entry.name : link(entry),
    ...sweep.factors.map((f) => f.texts[k]),
    plain(entry.seed),
    ...(entry.status === "finished"
      ? sweep.responses.map((r) => (known(r.value[k]) ? withError(r.value[k], r.error[k] ?? NaN, r.unit === "deg" ? "°" : r.unit) : "–"))
      : [entry.status]),
  ]);
  return section("cases", "Cases", csvButton("cases", () => csvOf(sweep)), dataTable("Each case with its standard errors; its name leads to its report", head, rows));
}

function csvOf(sweep) {
  const quote = (text) => `"${String(text).replaceAll('"', '""')}"`;
  const head = ["case", "status", "seed", ...sweep.factors.map((f) => f.key)];
  for (const r of sweep.responses) head.push(`${r.name} [${r.unit}]`, "standard error");
  const lines = sweep.cases.map((entry, k) => [
    quote(entry.name),
    quote(entry.status),
    entry.seed,
    ...sweep.factors.map((f) => quote(f.texts[k])),
    ...sweep.responses.flatMap((r) => [r.value[k] ?? "", r.error[k] ?? ""]),
  ]);
  return `${[head.map(quote), ...lines].map((cells) => cells.join(",")).join("\n")}\n`;
}

export function sweep(page) {
  const all = page.sweep;
  const count = (status) => all.cases.filter((entry) => entry.status.startsWith(status)).length;
  const seeds = new Set(all.cases.map((entry) => entry.seed)).size;
  const facts = [
    `${count("finished")} of ${all.cases.length} cases finished`,
    ...["failed", "running", "stopped", "missing"].map((status) => (count(status) ? `${count(status)} ${status}` : "")),
    all.factors.map(factorLabel).join(" × "),
    seeds > 1 ? `${seeds} seeds` : "",
  ].filter(Boolean);
  const header = el(
    "header",
    {},
    el("h1", {}, page.title),
    el("p", { class: "facts" }, facts.join(" · ")),
    el("p", { class: "note" }, `${all.file}, of ${all.scene}${all.set.length ? `, with ${all.set.join(", ")}` : ""}`),
  );
  if (all.responses.length === 0) return [header, cases(all)];
  const parts = [
    endsInMotion(page, all),
    responsesOver(all),
    effects(all),
    scatter(all),
    section("parallel", "All at once", parallel(all, () => csvOf(all))),
    cases(all),
  ];
  return [header, ...parts.filter(Boolean)];
}
