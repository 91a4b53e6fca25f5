// The time that the viewers of a page show, with its controls. Keys of a picture in focus: space plays,
// arrows step, Home and End go to the ends.
import { checkbox, el, select } from "../dom.js";
import { Viewer, WEAR_NAMES } from "./viewer.js";

export class Clock {
  constructor(runs) {
    this.several = runs.length > 1;
    this.viewers = runs.map((run) => new Viewer(run, this));
    this.times = [...runs.map((run) => run.view.times)].sort((a, b) => b.length - a.length)[0];
    this.playing = false;
    this.at = this.times.length - 1;
    this.slider = el("input", {
      type: "range",
      min: "0",
      max: String(this.at),
      value: String(this.at),
      step: "1",
      "aria-label": "Time of the picture",
      oninput: () => this.go(Number(this.slider.value)),
    });
    this.button = el("button", { type: "button", class: "play", onclick: () => this.toggle() }, "Play");
    this.time = el("output", { class: "time" }, `t = ${this.times[this.at].toFixed(3)} s`);
    for (const viewer of this.viewers) viewer.host.addEventListener("keydown", (event) => this.key(event));
  }

  // All viewers, so that they share their scales.
  async start() {
    await Promise.all(this.viewers.map((viewer) => viewer.read()));
    const sizes = this.viewers.flatMap(({ frames }) => [
      frames.radius.reduce((a, b) => Math.min(a, b), Infinity),
      frames.radius.reduce((a, b) => Math.max(a, b), 0),
    ]);
    this.radii = [Math.min(...sizes), Math.max(...sizes)];
    for (const viewer of this.viewers) await viewer.start();
    for (const viewer of this.viewers) viewer.stage.finish();
  }

  // The largest "speed" or "spin" of all runs.
  most(name) {
    return Math.max(...this.viewers.map((viewer) => viewer.run.view[name]));
  }

  mostWear(field) {
    return Math.max(...this.viewers.map((viewer) => viewer.walls.most(field)));
  }

  async go(k) {
    this.at = Math.max(0, Math.min(this.times.length - 1, k));
    this.slider.value = String(this.at);
    this.time.value = `t = ${this.times[this.at].toFixed(3)} s`;
    this.slider.setAttribute("aria-valuetext", this.time.value);
    await Promise.all(this.viewers.map((viewer) => viewer.show(viewer.frameAt(this.times[this.at]))));
  }

  key(event) {
    const steps = { ArrowLeft: -1, ArrowRight: 1, PageUp: -10, PageDown: 10, Home: -Infinity, End: Infinity };
    if (event.key === " ") this.toggle();
    else if (event.key in steps) this.go(this.at + steps[event.key]);
    else return;
    event.preventDefault();
  }

  toggle() {
    this.playing = !this.playing;
    this.button.textContent = this.playing ? "Pause" : "Play";
    if (this.playing) this.play();
  }

  async play() {
    const pause = Math.min(200, Math.max(40, 8000 / this.times.length));
    while (this.playing) {
      const started = performance.now();
      await this.go(this.at + 1 < this.times.length ? this.at + 1 : 0);
      await new Promise((done) => setTimeout(done, Math.max(0, pause - (performance.now() - started))));
    }
  }

  controls() {
    const colours = [
      ["speed", "speed"],
      ["size", "size"],
      ["spin", "spin"],
      ["species", "group"],
      ["class", "size class"],
    ];
    const fields = this.viewers[0].walls.fields;
    const each = (act) => (value) => this.viewers.forEach((viewer) => act(viewer, value));
    const first = this.viewers[0];
    return el(
      "div",
      { class: "controls" },
      this.button,
      this.slider,
      this.time,
      select(
        "Colour by",
        colours,
        each((viewer, value) => viewer.colourBy(value)),
      ),
      fields.length > 0
        ? select(
            "Liner by",
            [...fields.map((f) => [f.name, WEAR_NAMES[f.name]]), ["", "nothing"]],
            each((viewer, value) => viewer.paintWalls(value)),
          )
        : null,
      first.walls.walls.length > 0
        ? checkbox(
            "walls",
            true,
            each((viewer, shown) => {
              viewer.walls.group.visible = shown;
              viewer.stage.draw();
            }),
          )
        : null,
      el(
        "button",
        { type: "button", onclick: () => this.viewers.forEach((v) => v.stage.home(v.target)) },
        "Reset view",
      ),
    );
  }
}
