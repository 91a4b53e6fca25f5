// The moving picture of one run's charge, in the colours that are asked for.
import * as THREE from "three";
import { kinds, viridis, wear } from "../colours.js";
import { el } from "../dom.js";
import { number } from "../format.js";
import { colourBar, kindsLegend } from "../legend.js";
import { Frames } from "./frames.js";
import { Particles } from "./particles.js";
import { Stage } from "./stage.js";
import { Walls } from "./walls.js";

export const WEAR_NAMES = {
  depth_rate_siem: "wear, SIEM",
  depth_rate_sliding: "wear, sliding only",
  depth_rate_archard: "wear, Archard",
  depth_rate_finnie: "wear, Finnie",
  pressure: "pressure",
  shear: "shear",
};

export function classNames(scene) {
  return (scene?.species ?? []).flatMap((species) =>
    species.classes.map((c) =>
      c.from === null
        ? species.name
        : `${species.name} ${sizes(c)}${c.shape === "polyhedron" ? ", polyhedra" : ""}`,
    ),
  );
}

function sizes({ from, to }) {
  return from === to ? `${number(1000 * from)} mm` : `${number(1000 * from)}–${number(1000 * to)} mm`;
}

// Root-scaled bytes of a run on the scale of all runs.
function rescaled(bytes, own, all) {
  const factor = all > 0 ? Math.sqrt(own / all) : 0;
  return bytes.map((q) => Math.round(factor * Math.min(q, 254)));
}

const rootBar = (label, unit, most) => colourBar(`${label}, root scale`, unit, 0, most, viridis, most / 4);
const logBar = (label, unit, low, high) =>
  colourBar(`${label}, log scale`, unit, low, high, viridis, Math.sqrt(low * high));

export class Viewer {
  constructor(run, clock) {
    this.run = run;
    this.clock = clock;
    this.frames = new Frames(run.view);
    this.walls = new Walls(run.view, run.scene?.mill);
    const groups = (run.scene?.species ?? []).map((species) => species.group);
    this.groups = [...new Set(groups)];
    this.groupOf = groups.map((group) => this.groups.indexOf(group));
    this.colouring = "speed";
    this.at = -1;
    this.legend = el("div", { class: "legend" });
    this.wallLegend = el("div", { class: "legend" });
    this.label = el("output", { class: "view-time" });
    this.host = el("div", {
      class: "stage",
      tabindex: "0",
      role: "application",
      "aria-label": `Charge of ${run.name}. Space plays, left and right arrow step through the frames, drag or pinch turns the view.`,
    });
    this.host.append(this.label);
  }

  async read() {
    await Promise.all([this.frames.readStatics(), this.walls.read()]);
  }

  // Draws the first picture; the rest is read when it is asked for.
  async start() {
    const { low, high } = this.run.view;
    const mill = this.run.scene?.mill;
    const span = new THREE.Vector3(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    this.stage = new Stage(
      this.host,
      mill ? 0.5 * mill.diameter : 0.6 * span.length(),
      this.frames.count < 10000,
    );
    this.lookup = new THREE.DataTexture(new Uint8Array(viridis), 256, 1);
    this.lookup.colorSpace = THREE.NoColorSpace;
    this.particles = new Particles(this.frames, this.lookup);
    this.stage.scene.add(this.walls.group, this.particles.group);
    this.target = mill
      ? new THREE.Vector3(0, 0, 0.5 * mill.length)
      : new THREE.Vector3(...low).addScaledVector(span, 0.5);
    this.wallField = this.walls.fields[0]?.name ?? "";
    this.paintWalls(this.wallField);
    this.stage.home(this.target);
    this.paintLegend();
    await this.show(this.frames.times.length - 1); // the charge as it moves at last
  }

  // The frame nearest to a time.
  frameAt(time) {
    const { times } = this.frames;
    let best = 0;
    times.forEach((t, k) => {
      if (Math.abs(t - time) < Math.abs(times[best] - time)) best = k;
    });
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
      case "speed":
        return rescaled(frame.speed, this.run.view.speed, this.clock.most("speed"));
      case "spin":
        return rescaled(frame.spin, this.run.view.spin, this.clock.most("spin"));
      case "species":
        return frames.species.map((row) => this.groupOf[row] ?? row);
      case "class":
        return frames.sizeClass;
      default: {
        const [from, to] = this.clock.radii,
          least = Math.log(from),
          span = Math.log(to) - least || 1;
        return Uint8Array.from(frames.radius, (r) => Math.round((254 * (Math.log(r) - least)) / span));
      }
    }
  }

  // Speeds are spread by their root, as the bytes are; the scale says so.
  paint() {
    const table = this.colouring === "species" || this.colouring === "class" ? kinds() : viridis;
    this.lookup.image.data.set(table);
    this.lookup.needsUpdate = true;
    this.particles.colour(this.values());
  }

  paintLegend() {
    const { scene } = this.run;
    const bars = {
      speed: () => rootBar("speed", "m/s", this.clock.most("speed")),
      spin: () => rootBar("spin", "rad/s", this.clock.most("spin")),
      size: () => logBar("diameter", "mm", ...this.clock.radii.map((r) => 2000 * r)),
      species: () => kindsLegend(this.groups),
      class: () => kindsLegend(classNames(scene)),
    };
    this.legend.replaceChildren(bars[this.colouring]());
  }

  paintWalls(field) {
    this.wallField = field;
    const most = this.clock.mostWear(field);
    this.walls.colour(field, most);
    const unit = this.walls.fields.find((f) => f.name === field)?.unit;
    this.wallLegend.replaceChildren(...(field ? [colourBar(WEAR_NAMES[field], unit, 0, most, wear)] : []));
    this.stage.draw();
  }

  colourBy(name) {
    this.colouring = name;
    this.paintLegend();
    this.paint();
    this.stage.draw();
  }
}
