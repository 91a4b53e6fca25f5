// Colour scales for fields, as lookup tables for textures and canvases. Viridis and a diverging
// scale by their control points, linear between (Smith and van der Walt's viridis, sampled).

const VIRIDIS = [
  "440154",
  "482475",
  "414487",
  "355f8d",
  "2a788e",
  "21918c",
  "22a884",
  "44bf70",
  "7ad151",
  "bddf26",
  "fde725",
];
const HEAT = ["2b2b33", "4a2b3f", "7a2c45", "a8333f", "cf4a32", "e86f2b", "f59a36", "fac858", "fcf0a4"];
const DIVERGING = ["2166ac", "4393c3", "92c5de", "d1e5f0", "f7f7f7", "fddbc7", "f4a582", "d6604d", "b2182b"];

function rgb(hex) {
  return [0, 2, 4].map((k) => parseInt(hex.slice(k, k + 2), 16));
}

function table(hexes, size = 256) {
  const points = hexes.map(rgb),
    out = new Uint8ClampedArray(4 * size);
  for (let i = 0; i < size; i += 1) {
    const at = (i / (size - 1)) * (points.length - 1),
      k = Math.min(Math.floor(at), points.length - 2);
    for (let c = 0; c < 3; c += 1)
      out[4 * i + c] = points[k][c] + (at - k) * (points[k + 1][c] - points[k][c]);
    out[4 * i + 3] = 255;
  }
  return out;
}

// Of the liner: from its own grey to dark red.
const WEAR = ["99a1ac", "c9bb86", "f0b23e", "ea7a2c", "c8392b", "8e1530", "560a2a"];

export const viridis = table(VIRIDIS);
export const heat = table(HEAT);
export const wear = table(WEAR);
export const diverging = table(DIVERGING);

// Up to eight kinds that are told apart on light and dark ground.
export const KINDS = ["c9a227", "4a90d9", "d9603b", "3fae7f", "b366c9", "8a8f98", "e58fb1", "6fd0d6"];

export function kinds() {
  const out = new Uint8ClampedArray(4 * 256);
  for (let i = 0; i < 256; i += 1) out.set([...rgb(KINDS[i % KINDS.length]), 255], 4 * i);
  return out;
}

export function cssGradient(lookup) {
  const stops = Array.from({ length: 17 }, (_, k) => {
    const i = 4 * Math.round((k * 255) / 16);
    return `rgb(${lookup[i]},${lookup[i + 1]},${lookup[i + 2]})`;
  });
  return `linear-gradient(to right, ${stops.join(", ")})`;
}
