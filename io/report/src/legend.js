// The bar that tells what the colours of a picture mean.
import { KINDS, cssGradient } from "./colours.js";
import { el } from "./dom.js";
import { labelled, number } from "./format.js";

// `middle`: the value in the middle of the bar, where the scale is not even.
export function colourBar(label, unit, low, high, lookup, middle = 0.5 * (low + high)) {
  const bar = el("div", { class: "bar-colours" });
  bar.style.backgroundImage = cssGradient(lookup);
  return el(
    "div",
    {
      class: "colour-bar",
      role: "img",
      "aria-label": `Colours: ${labelled(label, unit)} from ${number(low)} to ${number(high)}`,
    },
    el("span", { class: "bar-label" }, labelled(label, unit)),
    bar,
    el(
      "div",
      { class: "bar-ticks" },
      [low, middle, high].map((v) => el("span", {}, number(v, 2))),
    ),
  );
}

export function kindsLegend(names) {
  return el(
    "ul",
    { class: "kinds" },
    names.map((name, k) => {
      const swatch = el("span", { class: "swatch" });
      swatch.style.background = `#${KINDS[k % KINDS.length]}`;
      return el("li", {}, swatch, name);
    }),
  );
}
