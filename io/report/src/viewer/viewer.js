// The moving picture of a run's charge: play, scrub, colours. Keys: space plays, arrows step, Home
// and End go to the ends. Several viewers may share one Clock and then show the same time.
import * as THREE from "three";
import { heat, kinds, viridis } from "../colours.js";
import { checkbox, el, select } from "../dom.js";
import { number } from "../format.js";
import { colourBar, kindsLegend } from "../legend.js";
import { Frames } from "./frames.js";
import { Particles } from "./particles.js";
import { Stage } from "./stage.js";
import { Walls } from "./walls.js";

const WEAR_NAMES = { depth_rate_siem: "wear, SIEM", depth_rate_sliding: "wear, sliding only",
  depth_rate_archard: "wear, Archard", depth_rate_finnie: "wear, Finnie", pressure: "pressure", shear: "shear" };

export function classNames(scene) {
  return (scene?.species ?? []).flatMap((species) => species.classes.map((c) =>
    (c.from === null ? species.name : `${species.name} ${sizes(c)}${c.shape === "polyhedron" ? ", polyhedra" : ""}`)));
}

function sizes({ from, to }) {
  return from === to ? `${number(1000 * from)} mm` : `${number(1000 * from)}–${number(1000 * to)} mm`;
}

export class Viewer {
  constructor(run, clock) {
    this.run = run;
    this.clock = clock;
    this.frames = new Frames(run.view);
    this.walls = new Walls(run.view);
    this.colouring = "speed";
    this.at = -1;
    this.legend = el("div", { class: "legend" });
    this.wallLegend = el("div", { class: "legend" });
    this.label = el("output", { class: "view-time" });
    this.host = el("div", { class: "stage", tabindex: "0", role: "application",
      "aria-label": `Charge of ${run.name}. Space plays, left and right arrow step through the frames, drag or pinch turns the view.` });
    this.host.append(this.label);
  }

  // Draws the first picture; the rest is read when it is asked for.
  async start() {
    const { low, high } = this.run.view;
    const mill = this.run.scene?.mill;
    const span = new THREE.Vector3(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    this.stage = new Stage(this.host, mill ? 0.5 * mill.diameter : 0.6 * span.length());
    await Promise.all([this.frames.readStatics(), this.walls.read()]);
    this.lookup = new THREE.DataTexture(new Uint8Array(viridis), 256, 1);
    this.lookup.colorSpace = THREE.NoColorSpace;
    this.particles = new Particles(this.frames, this.lookup);
    this.stage.scene.add(this.walls.group, this.particles.group);
    this.target = mill ? new THREE.Vector3(0, 0, 0.5 * mill.length)
                       : new THREE.Vector3(...low).addScaledVector(span, 0.5);
    this.wallField = this.walls.fields[0]?.name ?? "";
    this.paintWalls(this.wallField);
    this.stage.home(this.target);
    this.paintLegend();
    await this.show(0);
  }

  // The frame nearest to a time.
  frameAt(time) {
    const { times } = this.frames;
    let best = 0;
    times.forEach((t, k) => { if (Math.abs(t - time) < Math.abs(times[best] - time)) best = k; });
    return best;
  }

  async show(k) {
    this.wanted = k;
    const frame = await this.frames.frame(k);
    if (this.wanted !== k) return; // another was asked for meanwhile
    this.at = k;
    this.frame = frame;
    this.particles.place(frame);
    this.walls.pose(k);
    this.paint();
    this.label.value = `${this.clock.several ? `${this.run.name}  ` : ""}t = ${this.frames.times[k].toFixed(3)} s`;
    this.stage.drawNow();
    this.frames.frame((k + 1) % this.frames.times.length); // the next one is likely wanted
  }

  // Bytes of the colour scale for each particle.
  values() {
    const { frames, frame } = this;
    switch (this.colouring) {
      case "speed": return frame.speed.map((q) => Math.min(q, 254));
      case "spin": return frame.spin;
      case "species": return frames.species;
      case "class": return frames.sizeClass;
      default: {
        const least = Math.log(this.leastRadius), span = Math.log(this.mostRadius) - least || 1;
        return Uint8Array.from(frames.radius, (r) => Math.round(254 * (Math.log(r) - least) / span));
      }
    }
  }

  get leastRadius() { return this.frames.radius.reduce((a, b) => Math.min(a, b), Infinity); }

  get mostRadius() { return this.frames.radius.reduce((a, b) => Math.max(a, b), 0); }

  // Speeds are spread by their root, as the bytes are; the scale says so.
  paint() {
    const table = this.colouring === "species" || this.colouring === "class" ? kinds() : viridis;
    this.lookup.image.data.set(table);
    this.lookup.needsUpdate = true;
    this.particles.colour(this.values());
  }

  paintLegend() {
    const { view, scene } = this.run;
    const bars = {
      speed: () => colourBar("speed, root scale", "m/s", 0, view.speed, viridis),
      spin: () => colourBar("spin, root scale", "rad/s", 0, view.spin, viridis),
      size: () => colourBar("diameter, log scale", "mm", 2000 * this.leastRadius, 2000 * this.mostRadius, viridis),
      species: () => kindsLegend(scene.species.map((s) => s.name)),
      class: () => kindsLegend(classNames(scene)),
    };
    this.legend.replaceChildren(bars[this.colouring]());
  }

  paintWalls(field) {
    this.wallField = field;
    const most = this.walls.colour(field);
    const unit = this.walls.fields.find((f) => f.name === field)?.unit;
    this.wallLegend.replaceChildren(...(field ? [colourBar(WEAR_NAMES[field], unit, 0, most, heat)] : []));
    this.stage.draw();
  }

  colourBy(name) {
    this.colouring = name;
    this.paintLegend();
    this.paint();
    this.stage.draw();
  }
}

// The time that all viewers of a page show, with its controls.
export class Clock {
  constructor(runs) {
    this.several = runs.length > 1;
    this.viewers = runs.map((run) => new Viewer(run, this));
    this.times = [...runs.map((run) => run.view.times)].sort((a, b) => b.length - a.length)[0];
    this.playing = false;
    this.at = 0;
    this.slider = el("input", { type: "range", min: "0", max: String(this.times.length - 1), value: "0", step: "1",
      "aria-label": "Time of the picture", oninput: () => this.go(Number(this.slider.value)) });
    this.button = el("button", { type: "button", class: "play", onclick: () => this.toggle() }, "Play");
    this.time = el("output", { class: "time" }, `t = ${this.times[0].toFixed(3)} s`);
    for (const viewer of this.viewers) viewer.host.addEventListener("keydown", (event) => this.key(event));
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
    const colours = [["speed", "speed"], ["size", "size"], ["spin", "spin"], ["species", "group"], ["class", "size class"]];
    const fields = this.viewers[0].walls.fields;
    const each = (act) => (value) => this.viewers.forEach((viewer) => act(viewer, value));
    const first = this.viewers[0];
    return el("div", { class: "controls" }, this.button, this.slider, this.time,
      select("Colour by", colours, each((viewer, value) => viewer.colourBy(value))),
      fields.length > 0 ? select("Liner by", [...fields.map((f) => [f.name, WEAR_NAMES[f.name]]), ["", "nothing"]],
        each((viewer, value) => viewer.paintWalls(value))) : null,
      first.walls.walls.length > 0 ? checkbox("walls", true, each((viewer, shown) => {
        viewer.walls.group.visible = shown;
        viewer.stage.draw();
      })) : null,
      el("button", { type: "button", onclick: () => this.viewers.forEach((v) => v.stage.home(v.target)) }, "Reset view"));
  }
}

