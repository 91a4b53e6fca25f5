// Colours of plots in the light and in the dark, and who redraws when that changes. Print is light.

const LIGHT = ["#0b62a8", "#c8500a", "#0a8560", "#a8418a", "#9a7400", "#3f8fd0", "#6b6f76", "#7a3ea8"];
const DARK = ["#5fb0f0", "#f08a4b", "#3cc79b", "#e283c2", "#e0b93c", "#8cc8f5", "#a4a9b2", "#b98ae6"];

const dark = matchMedia("(prefers-color-scheme: dark)");
const listeners = new Set();
let printing = false;

export function isDark() {
  return dark.matches && !printing;
}

export function isPrinting() {
  return printing;
}

export function palette() {
  return isDark() ? DARK : LIGHT;
}

// Colour k of a plot: a number, so that it is looked up when drawn.
export function colour(k) {
  const all = palette();
  return all[k % all.length];
}

export function css(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

export function onTheme(redraw) {
  listeners.add(redraw);
}

function tell() {
  document.documentElement.classList.toggle("print", printing);
  for (const redraw of listeners) redraw();
}

dark.addEventListener("change", tell);
addEventListener("beforeprint", () => {
  printing = true;
  tell();
});
addEventListener("afterprint", () => {
  printing = false;
  tell();
});
