// The charge in motion.
import { el, section } from "../dom.js";
import { Clock } from "../viewer/clock.js";

export function view(page) {
  const runs = page.runs.filter((run) => run.view);
  if (runs.length === 0) return null;
  const clock = new Clock(runs);
  const figures = clock.viewers.map((viewer) =>
    el(
      "div",
      { class: "view" },
      viewer.host,
      el("div", { class: "legends" }, viewer.legend, viewer.wallLegend),
      viewer.run.view.note ? el("p", { class: "note sampled" }, viewer.run.view.note) : null,
    ),
  );
  const place = el("div", { class: "controls-place" });
  const part = section(
    "charge-view",
    "The charge",
    el("div", { class: `views of${Math.min(runs.length, 2)}` }, figures),
    place,
    el(
      "p",
      { class: "note" },
      "Drag turns, wheel or pinch zooms, right drag shifts. With the picture in focus: space plays, ← → step, Home and End jump. " +
        "Walls are drawn from the side of the charge only.",
    ),
  );
  part.start = async () => {
    try {
      await clock.start();
    } catch (error) {
      console.error(error);
      for (const viewer of clock.viewers)
        viewer.host.replaceChildren(
          el("p", { class: "note" }, `No picture (does this browser have WebGL?): ${error.message}`),
        );
      return;
    }
    place.replaceChildren(clock.controls());
  };
  part.clock = clock;
  return part;
}
