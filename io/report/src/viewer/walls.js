// Walls of the moving picture: seen from the side of the charge only, so that one looks into the
// mill; coloured by wear where it was recorded.
import * as THREE from "three";
import { blob } from "../data.js";
import { wear as lookup } from "../colours.js";

const PLAIN = new THREE.Color(0x8d949e);

function geometryOf(corners) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
  geometry.computeVertexNormals();
  return geometry;
}

function plainMaterial(coloured) {
  return new THREE.MeshLambertMaterial({
    color: coloured ? 0xffffff : PLAIN,
    vertexColors: coloured,
    side: THREE.FrontSide,
  });
}

// Six times the volume within, with the sign of the orientation.
function volume(corners) {
  let sum = 0;
  for (let k = 0; k < corners.length; k += 9) {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = corners.subarray(k, k + 9);
    sum += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return sum;
}

function turnOver(corners) {
  for (let k = 0; k < corners.length; k += 9) {
    for (let c = 3; c < 6; c += 1)
      [corners[k + c], corners[k + c + 3]] = [corners[k + c + 3], corners[k + c]];
  }
}

// The ends of a mill reach beyond its shell; what is seen of them is its section at both ends.
function endsOf(mill) {
  const shape = new THREE.Shape(mill.profile.map(([x, y]) => new THREE.Vector2(x, y)));
  const face = new THREE.ShapeGeometry(shape).toNonIndexed().getAttribute("position").array;
  const near = Float32Array.from(face),
    far = Float32Array.from(face);
  for (let k = 2; k < far.length; k += 3) far[k] = mill.length;
  turnOver(far);
  return Float32Array.of(...near, ...far);
}

// Wear cells with their values, field by field.
async function readWear(wear) {
  const floats = new Float32Array(await blob(wear.blob)),
    n = wear.cells;
  const fields = wear.fields.map((field, k) => ({
    ...field,
    values: floats.subarray((9 + k) * n, (10 + k) * n),
  }));
  return { corners: floats.slice(0, 9 * n), fields };
}

export class Walls {
  constructor(view, mill) {
    this.view = view;
    this.mill = mill;
    this.group = new THREE.Group();
    this.walls = [];
    this.fields = []; // names and units of wear fields that some wall has
  }

  async read() {
    for (const wall of this.view.walls) {
      const entry = { poses: wall.poses, wear: null };
      let corners = new Float32Array(await blob(wall.blob));
      if (wall.wear) {
        entry.wear = await readWear(wall.wear);
        if (volume(corners) * volume(entry.wear.corners) < 0) turnOver(entry.wear.corners);
        for (const { name, unit } of entry.wear.fields) {
          if (!this.fields.some((field) => field.name === name)) this.fields.push({ name, unit });
        }
      }
      if (wall.name === "ends" && this.mill && !wall.wear) corners = endsOf(this.mill);
      const geometry = geometryOf(entry.wear ? entry.wear.corners : corners);
      if (entry.wear) {
        geometry.setAttribute(
          "color",
          new THREE.BufferAttribute(new Float32Array(entry.wear.corners.length), 3),
        );
      }
      entry.mesh = new THREE.Mesh(geometry, plainMaterial(entry.wear !== null));
      this.group.add(entry.mesh);
      this.walls.push(entry);
    }
  }

  pose(k) {
    for (const { mesh, poses } of this.walls) {
      const [w, x, y, z, ...shift] = poses[k];
      mesh.quaternion.set(x, y, z, w);
      mesh.position.set(...shift);
    }
  }

  // The largest value but for one cell in two hundred: single cells do not pale the rest.
  most(name) {
    const all = this.walls.flatMap(({ wear }) => [
      ...(wear?.fields.find((f) => f.name === name)?.values ?? []),
    ]);
    all.sort((a, b) => a - b);
    return all.length > 0 ? all[Math.min(all.length - 1, Math.floor(0.995 * all.length))] : 0;
  }

  // Values from 0 to `most` over the scale; a field of no name colours nothing.
  colour(name, most) {
    for (const { wear, mesh } of this.walls) {
      if (!wear) continue;
      const values = wear.fields.find((field) => field.name === name)?.values;
      const colours = mesh.geometry.getAttribute("color"),
        one = new THREE.Color();
      for (let cell = 0; cell < wear.corners.length / 9; cell += 1) {
        if (values && most > 0) {
          const k = 4 * Math.round(255 * Math.min(1, Math.max(0, values[cell] / most)));
          one.setRGB(lookup[k] / 255, lookup[k + 1] / 255, lookup[k + 2] / 255, THREE.SRGBColorSpace);
        } else {
          one.copy(PLAIN);
        }
        for (let c = 0; c < 3; c += 1) colours.setXYZ(3 * cell + c, one.r, one.g, one.b);
      }
      colours.needsUpdate = true;
    }
  }
}
