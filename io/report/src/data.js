// The data of the page: packed texts to arrays, and a run with its tables under their own names.
import { blockMean, criticalSpeed, meanRate, timeOfRevolution } from "./derived.js";

function bytesOf(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const raw = atob(text),
    bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i += 1) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

async function unpack(text) {
  const stream = new Blob([bytesOf(text)]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

let keep = false;

// On a page that shows a picture now and again: what is packed stays.
export function keepBlobs() {
  keep = true;
}

// A packed array by its number; its text is let go once it has been read.
export async function blob(number) {
  const element = document.getElementById(`blob${number}`);
  const buffer = await unpack(element.textContent);
  if (!keep) element.remove();
  return buffer;
}

export async function readPage() {
  const text = new TextDecoder().decode(await unpack(document.getElementById("data").textContent));
  const page = JSON.parse(text);
  const runs = (page.runs ?? page.pictures ?? []).map((raw, index) => new Run(raw, index));
  return { title: page.title, runs, trade: page.trade, sweep: page.sweep };
}

export class Run {
  constructor(raw, index) {
    this.index = index;
    this.name = raw.name;
    this.scene = raw.scene;
    this.sceneText = raw.scene_text;
    this.provenance = raw.provenance;
    this.notes = raw.notes;
    this.view = raw.view;
    this.arrays = raw.arrays;
    this.texts = raw.texts;
    // A resumed run has the summary of where it was stopped, until it ends.
    const summary = readSummary(raw.summary);
    this.complete = raw.summary !== "" && !(this.time.at(-1) > summary.time_s * (1 + 1e-9));
    this.summary = this.complete ? summary : {};
    this.recordFrom = this.summary.recorded_from_s ?? recordFrom(this.scene);
    if (!this.complete) this.fillIn();
  }

  has(name) {
    return name in this.arrays && this.arrays[name].data.length > 0;
  }

  // Values of an array; [] where it is absent.
  values(name) {
    return this.arrays[name]?.data ?? [];
  }

  unit(name) {
    return this.arrays[name]?.unit ?? "1";
  }

  lines(name) {
    return this.texts[name]?.split("\n").filter((line) => line !== "") ?? [];
  }

  // Names below a group: names("zones") -> ["toe"] for "zones/toe/count".
  below(group) {
    const start = `${group}/`;
    const found = Object.keys(this.arrays).filter((name) => name.startsWith(start));
    return [...new Set(found.map((name) => name.slice(start.length).split("/")[0]))];
  }

  // A figure of the summary with its standard error.
  figure(name) {
    return { value: this.summary[name] ?? NaN, error: this.summary[`${name}_standard_error`] ?? NaN };
  }

  get time() {
    return this.values("series/time");
  }

  get endTime() {
    return this.summary.time_s ?? this.time.at(-1) ?? 0;
  }

  // rad/s, mean over the recorded window; share of the critical speed
  get speed() {
    const mill = this.scene?.mill;
    return mill ? meanRate(mill.rotation, this.recordFrom, this.endTime) : NaN;
  }

  get shareOfCritical() {
    const mill = this.scene?.mill;
    return mill ? Math.abs(this.speed) / criticalSpeed(mill.diameter, this.scene.gravity) : NaN;
  }

  // Of a run that has not ended: the means that its summary will have, from the series so far.
  fillIn() {
    const time = this.time;
    const first = time.findIndex((t) => t > this.recordFrom + 1e-9);
    const means = {
      power: "power_W",
      torque: "torque_Nm",
      kinetic_energy: "kinetic_energy_J",
      contacts_per_particle: "contacts_per_particle",
    };
    for (const [series, name] of Object.entries(means)) {
      const values = first < 0 ? [] : this.values(`series/${series}`).slice(first);
      const mean = blockMean(values.filter((v) => v !== null));
      this.summary[name] = mean.mean;
      this.summary[`${name}_standard_error`] = mean.error;
    }
    this.summary.ledger_error = this.values("series/ledger_error").at(-1);
    this.summary.time_s = time.at(-1) ?? 0;
  }
}

function readSummary(text) {
  try {
    return text === "" ? {} : JSON.parse(text);
  } catch {
    return {};
  }
}

function recordFrom(scene) {
  if (!scene) return 0;
  if (scene.record_from_revolution === null || !scene.mill) return scene.record_from;
  return timeOfRevolution(scene.mill.rotation, scene.record_from_revolution);
}
