// Numbers as an engineer writes them: as many digits as the error allows, prefixes for watts and
// joules, powers of ten elsewhere.

const SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
const PREFIXED = new Set(["W", "J", "N m", "N", "Pa", "Hz"]);
const PREFIXES = [
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
  [1e-9, "n"],
  [1e-12, "p"],
];

export const NARROW = "\u202f";

export function superscript(n) {
  return (n < 0 ? "⁻" : "") + [...String(Math.abs(n))].map((d) => SUPERSCRIPT[d]).join("");
}

export function powerOfTen(exponent) {
  return exponent === 0 ? "1" : exponent === 1 ? "10" : `10${superscript(exponent)}`;
}

export function number(value, digits = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const exponent = Math.floor(Math.log10(Math.abs(value)) + 1e-12);
  if (exponent < -3 || exponent >= 6) {
    const mantissa = (value / 10 ** exponent).toFixed(Math.max(0, digits - 1));
    return minus(`${mantissa}·10${superscript(exponent)}`);
  }
  return minus(grouped(value.toFixed(Math.max(0, digits - 1 - exponent))));
}

function minus(text) {
  return text.replace(/^-/, "−");
}

// 12345.6 -> 12 345.6
function grouped(text) {
  const [whole, part] = text.split(".");
  const spaced = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+(?!\d))/g, NARROW) : whole;
  return part === undefined ? spaced : `${spaced}.${part}`;
}

// As few digits as the number has, at most `most`: 0.3, 30, 1.25.
export function plain(value, most = 4) {
  if (!Number.isFinite(value)) return "–";
  const exact = Number(value.toPrecision(most));
  return Math.abs(exact) >= 1e5 || (exact !== 0 && Math.abs(exact) < 1e-3)
    ? number(value)
    : minus(String(exact));
}

// A value with its unit and prefix, to so many digits.
export function withUnit(value, unit, digits = 3) {
  if (!Number.isFinite(value)) return "–";
  const [size, prefix] = prefixFor(Math.abs(value), unit);
  return unit === "1" ? number(value, digits) : `${number(value / size, digits)}${NARROW}${prefix}${unit}`;
}

// Ticks of an even axis with the decimals that their step needs.
export function tickTexts(ticks) {
  const given = ticks.filter((v) => v !== null && v !== undefined);
  const step = given.length > 1 ? Math.abs(given[1] - given[0]) : 0,
    most = Math.max(...given.map(Math.abs));
  if (!(step > 0) || most >= 1e6 || most < 1e-3) return ticks.map((v) => (v === null ? "" : number(v, 2)));
  let places = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  if (Math.abs(step * 10 ** places - Math.round(step * 10 ** places)) > 1e-6) places += 1;
  return ticks.map((v) =>
    v === null ? "" : minus(grouped((Math.abs(v) < step * 1e-6 ? 0 : v).toFixed(places))),
  );
}

// The prefix that suits an axis up to `most`.
export function axisPrefix(most, unit) {
  return prefixFor(most, unit);
}

export function count(value) {
  return Number.isFinite(value) ? minus(grouped(String(Math.round(value)))) : "–";
}

function prefixFor(value, unit) {
  if (!PREFIXED.has(unit) || !Number.isFinite(value) || value === 0) return [1, ""];
  return PREFIXES.find(([size]) => Math.abs(value) >= size * 0.9995) ?? PREFIXES.at(-1);
}

// Decimals that show two digits of the error, at most `most` digits of the value.
function decimals(value, error, most = 6) {
  const of = (x) => Math.floor(Math.log10(Math.abs(x)) + 1e-12);
  const wanted = Number.isFinite(error) && error > 0 ? 1 - of(error) : 3 - (value === 0 ? 0 : of(value));
  return Math.max(0, Math.min(wanted, most - (value === 0 ? 0 : of(value)), 12));
}

// { value, error, unit } as texts with a common prefix.
export function parts(value, error, unit) {
  if (value === null || value === undefined || !Number.isFinite(value)) {
    return { value: "–", error: "", unit: "" };
  }
  const [size, prefix] = prefixFor(Math.max(Math.abs(value), Number.isFinite(error) ? error : 0), unit);
  const v = value / size,
    e = error / size;
  const shown = unit === "1" ? "" : `${prefix}${unit}`;
  const large = Math.abs(v) >= 1e6 || (v !== 0 && Math.abs(v) < 1e-3);
  if (large) return { value: number(v), error: Number.isFinite(e) ? number(e, 2) : "", unit: shown };
  const places = decimals(v, e);
  return {
    value: minus(grouped(v.toFixed(places))),
    error: Number.isFinite(e) ? grouped(e.toFixed(places)) : "",
    unit: shown,
  };
}

export function withError(value, error, unit) {
  const p = parts(value, error, unit);
  const unitText = p.unit === "" ? "" : p.unit === "°" ? "°" : `${NARROW}${p.unit}`;
  return p.error ? `${p.value} ± ${p.error}${unitText}` : `${p.value}${unitText}`;
}

export function duration(seconds) {
  if (!Number.isFinite(seconds)) return "–";
  if (seconds < 120) return `${number(seconds)} s`;
  const s = Math.round(seconds),
    pad = (n) => String(n).padStart(2, "0");
  const hours = Math.floor(s / 3600);
  return hours > 0
    ? `${hours}:${pad(Math.floor(s / 60) % 60)}:${pad(s % 60)} h`
    : `${Math.floor(s / 60)}:${pad(s % 60)} min`;
}

// "m/s^2" -> "m/s²"
export function unitText(unit) {
  return unit === "1" ? "" : unit === "deg" ? "°" : unit.replace(/\^(-?\d+)/g, (_, n) => superscript(+n));
}

export function labelled(label, unit) {
  const text = unitText(unit);
  return text ? `${label} (${text})` : label;
}
