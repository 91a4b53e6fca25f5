// The report page: reads what it carries, shows the first picture, then the sections. A section
// whose data were not recorded is left out.
import "uplot/dist/uPlot.min.css";
import "./style.css";
import { readPage } from "./data.js";
import { el } from "./dom.js";
import { plots } from "./plot.js";
import { charge } from "./sections/charge.js";
import { classes } from "./sections/classes.js";
import { course } from "./sections/course.js";
import { formulas } from "./sections/formulas.js";
import { contents, headline, notes } from "./sections/headline.js";
import { power } from "./sections/power.js";
import { spectra } from "./sections/spectra.js";
import { sweep } from "./sections/sweep.js";
import { trade } from "./sections/trade.js";
import { view } from "./sections/view.js";
import { wear } from "./sections/wear.js";

async function start() {
  const main = document.getElementById("page");
  const page = await readPage();
  if (page.trade) {
    showParts(main, page, trade(page), page.trade.commit);
    return;
  }
  if (page.sweep) {
    showParts(main, page, sweep(page), page.sweep.commit);
    return;
  }
  const moving = view(page);
  const first = [headline(page), moving].filter(Boolean);
  main.replaceChildren(...first);
  if (moving) await moving.start();
  const seconds = performance.now() / 1000;
  await new Promise((done) => setTimeout(done)); // the picture first
  const parts = [power, charge, wear, spectra, classes, formulas, notes, course]
    .map((make) => make(page))
    .filter(Boolean);
  main.append(...parts);
  main.querySelector("header").after(contents([moving, ...parts].filter(Boolean)));
  main.append(
    el(
      "footer",
      {},
      `Made by quern ${page.runs[0].provenance.version ?? ""}. All numbers are in run.h5 and summary.json under the same names.`,
    ),
  );
  // For tests and scripts.
  window.quern = { page, plots, clock: moving?.clock ?? null, firstPicture: seconds, ready: true };
}

// A page of another kind: its header and sections.
function showParts(main, page, [header, ...parts], commit) {
  header.append(contents(parts));
  main.replaceChildren(header, ...parts, el("footer", {}, `Made by quern ${commit}.`));
  window.quern = { page, plots, ready: true };
}

start().catch((error) => {
  document
    .getElementById("page")
    .prepend(el("p", { class: "bad" }, `This page does not work here: ${error.message}`));
  throw error;
});
