// Frames of the charge: packed bytes to arrays (layout: io/report_view.h), each when it is asked for.
import { blob } from "../data.js";

const ABSENT = 255;

export class Frames {
  constructor(view) {
    this.view = view;
    this.count = view.particles;
    this.spheres = view.spheres;
    this.times = view.times;
    this.waiting = new Map();
  }

  async readStatics() {
    const buffer = await blob(this.view.statics),
      n = this.count;
    this.id = new Uint32Array(buffer, 0, n);
    this.radius = new Float32Array(buffer, 4 * n, n);
    this.species = new Uint16Array(buffer, 8 * n, n);
    this.sizeClass = new Uint16Array(buffer, 10 * n, n);
    this.shape = new Uint16Array(buffer, 12 * n, n);
  }

  // A promise of frame k, the same each time.
  frame(k) {
    if (!this.waiting.has(k)) this.waiting.set(k, this.decode(k));
    return this.waiting.get(k);
  }

  async decode(k) {
    const bytes = new Uint8Array(await blob(this.view.frames + k));
    const { count, spheres, view } = this,
      bodies = count - spheres;
    const position = new Float32Array(3 * count),
      orientation = new Float32Array(4 * bodies);
    for (let axis = 0; axis < 3; axis += 1) {
      const at = 2 * count * axis,
        low = view.low[axis],
        step = (view.high[axis] - low) / 65535;
      for (let i = 0; i < count; i += 1) {
        position[3 * i + axis] = low + step * (256 * bytes[at + i] + bytes[at + count + i]);
      }
    }
    const speed = bytes.subarray(6 * count, 7 * count),
      spin = bytes.subarray(7 * count, 8 * count);
    for (let c = 0; c < 4; c += 1) {
      const at = 8 * count + 2 * bodies * c;
      for (let i = 0; i < bodies; i += 1) {
        orientation[4 * i + c] = (256 * bytes[at + i] + bytes[at + bodies + i] - 32767) / 32767;
      }
    }
    return { position, orientation, speed, spin };
  }

  // What is absent has no size.
  shownRadius(frame) {
    const shown = this.radius.slice();
    for (let i = 0; i < shown.length; i += 1) if (frame.speed[i] === ABSENT) shown[i] = 0;
    return shown;
  }
}

// Root-scaled byte to a value: (q / 254)^2 of the largest.
export function unscaled(byte, most) {
  return most * (byte / 254) ** 2;
}
