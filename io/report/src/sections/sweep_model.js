// A sweep's table as the page works with it: points (cases that differ in their seed only), means with
// errors, levels and effects of factors.

const known = (v) => v !== null && v !== undefined && Number.isFinite(v);
const mean = (list) => list.reduce((a, b) => a + b, 0) / list.length;

// Values of cases: mean, standard error of it by the spread between them, and by what each case says
// of itself.
export function summarize(response, cases) {
  const rows = cases.filter((k) => known(response.value[k]));
  if (rows.length === 0) return { mean: NaN, between: NaN, within: NaN, count: 0 };
  const values = rows.map((k) => response.value[k]),
    m = mean(values);
  const squares = values.reduce((sum, v) => sum + (v - m) ** 2, 0);
  const between = rows.length > 1 ? Math.sqrt(squares / (rows.length - 1) / rows.length) : NaN;
  const errors = rows.map((k) => response.error[k]);
  const within = errors.every(known)
    ? Math.sqrt(errors.reduce((sum, e) => sum + e * e, 0)) / rows.length
    : NaN;
  return { mean: m, between, within, count: rows.length };
}

// Cases by point, in order.
export function pointsOf(sweep) {
  const points = [];
  sweep.cases.forEach((entry, k) => {
    points[entry.point] ??= [];
    points[entry.point].push(k);
  });
  return points;
}

const MOST_LEVELS = 8,
  BINS = 5;

// The levels of a factor: { at, text, has(case) }. Of very many values equal parts of the range.
export function levelsOf(factor) {
  const numeric = factor.numbers.length > 0;
  const texts = [...new Set(factor.texts)];
  if (numeric && texts.length > MOST_LEVELS) {
    const low = Math.min(...factor.numbers),
      step = (Math.max(...factor.numbers) - low) / BINS;
    return Array.from({ length: BINS }, (_, b) => ({
      at: low + (b + 0.5) * step,
      text: `${(low + b * step).toPrecision(3)} to ${(low + (b + 1) * step).toPrecision(3)}`,
      has: (k) => Math.min(BINS - 1, Math.floor((factor.numbers[k] - low) / step)) === b,
    }));
  }
  const levels = texts.map((text, row) => ({
    at: numeric ? factor.numbers[factor.texts.indexOf(text)] : row + 1,
    text,
    has: (k) => factor.texts[k] === text,
  }));
  return numeric ? levels.sort((a, b) => a.at - b.at) : levels;
}

// The value of a case on an axis: "factor:0", "response:3".
export function axisOf(sweep, id) {
  const [kind, row] = id.split(":"),
    k = Number(row);
  if (kind === "response") {
    const r = sweep.responses[k];
    return { label: labelOf(r.name), unit: r.unit, values: r.value, errors: r.error };
  }
  const f = sweep.factors[k],
    texts = [...new Set(f.texts)];
  const values = f.numbers.length > 0 ? f.numbers : f.texts.map((text) => texts.indexOf(text) + 1);
  return { label: factorLabel(f), unit: f.unit, values, texts: f.numbers.length > 0 ? null : texts };
}

export function axesOf(sweep) {
  return [
    ...sweep.factors.map((f, k) => [`factor:${k}`, factorLabel(f)]),
    ...sweep.responses.map((r, k) => [`response:${k}`, labelOf(r.name)]),
  ];
}

export const factorLabel = (factor) => factor.keys.map((key) => key.split(".").slice(-1)[0].replaceAll("_", " ")).join(", ");

const LABELS = {
  power_W: "power",
  shoulder_deg: "shoulder",
  toe_deg: "toe",
  impact_toe_deg: "impact toe",
  head_deg: "head",
};

export function labelOf(name) {
  const kind = /^power_(.+)_W$/.exec(name);
  if (kind) return `power, ${kind[1]}`;
  return LABELS[name] ?? name.replace(/_(W|deg|m3|J|Nm|kg|m|s)$/, "").replaceAll("_", " ");
}

export { known };
