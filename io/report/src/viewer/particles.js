// Spheres as impostors (a square each, the ray through a pixel meets the true sphere, so that depth
// and shading are exact) and polyhedra as instances of their shapes, in one colour scale.
import * as THREE from "three";

const LIGHTING = `
  uniform vec3 lightDirection;
  vec3 lit(vec3 colour, vec3 normal) {
    float front = max(dot(normal, lightDirection), 0.0);
    float sky = 0.5 + 0.5 * normal.y;
    return colour * (0.36 + 0.18 * sky + 0.56 * front);
  }`;

const SPHERE_VERTEX = `
  in vec3 position;      // corner of the square, -1 ... 1
  in vec3 centre;
  in float radius;
  in float value;
  uniform mat4 modelViewMatrix, projectionMatrix;
  uniform sampler2D colours;
  out vec3 onSquare, centreInView, colour;
  flat out float size;
  void main() {
    vec4 c = modelViewMatrix * vec4(centre, 1.0);
    // Wider than the sphere: its outline in perspective is larger than its section.
    float d = max(length(c.xyz), radius * 1.01);
    float reach = radius * d / sqrt(max(d * d - radius * radius, 1e-12));
    vec3 towards = normalize(-c.xyz);
    vec3 side = normalize(cross(vec3(0.0, 1.0, 0.0), towards));
    vec3 up = cross(towards, side);
    onSquare = c.xyz + reach * (position.x * side + position.y * up);
    centreInView = c.xyz;
    size = radius;
    colour = texture(colours, vec2((value + 0.5) / 256.0, 0.5)).rgb;
    gl_Position = projectionMatrix * vec4(onSquare, 1.0);
  }`;

const SPHERE_FRAGMENT = `
  precision highp float;
  in vec3 onSquare, centreInView, colour;
  flat in float size;
  uniform mat4 projectionMatrix;
  out vec4 result;
  ${LIGHTING}
  void main() {
    vec3 ray = normalize(onSquare);
    float along = dot(ray, centreInView);
    float inside = size * size - (dot(centreInView, centreInView) - along * along);
    if (inside < 0.0) discard;
    vec3 hit = ray * (along - sqrt(inside));
    vec3 normal = (hit - centreInView) / size;
    vec4 clip = projectionMatrix * vec4(hit, 1.0);
    gl_FragDepth = 0.5 + 0.5 * clip.z / clip.w;
    result = vec4(lit(colour, normal), 1.0);
  }`;

const BODY_VERTEX = `
  in vec3 position, normal;
  in vec3 centre;
  in float radius;
  in float value;
  in vec4 orientation;   // w x y z
  uniform mat4 modelViewMatrix, projectionMatrix;
  uniform mat3 normalMatrix;
  uniform sampler2D colours;
  out vec3 normalInView, colour;
  vec3 turn(vec3 v) {
    vec3 q = orientation.yzw;
    return v + 2.0 * cross(q, cross(q, v) + orientation.x * v);
  }
  void main() {
    normalInView = normalMatrix * turn(normal);
    colour = texture(colours, vec2((value + 0.5) / 256.0, 0.5)).rgb;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(centre + radius * turn(position), 1.0);
  }`;

const BODY_FRAGMENT = `
  precision highp float;
  in vec3 normalInView, colour;
  out vec4 result;
  ${LIGHTING}
  void main() { result = vec4(lit(colour, normalize(normalInView)), 1.0); }`;

function material(vertexShader, fragmentShader, colours) {
  return new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader,
    fragmentShader,
    uniforms: {
      colours: { value: colours },
      lightDirection: { value: new THREE.Vector3(0.35, 0.45, 0.82).normalize() },
    },
  });
}

function perInstance(geometry, name, length, size, type = Float32Array, scaled = false) {
  const attribute = new THREE.InstancedBufferAttribute(new type(length * size), size, scaled);
  attribute.setUsage(THREE.DynamicDrawUsage);
  geometry.setAttribute(name, attribute);
  return attribute;
}

// A group of instances: rows `first` ... `first + count` of a frame.
class Instances {
  constructor(geometry, shader, rows) {
    this.rows = rows;
    geometry.instanceCount = rows.length;
    this.centre = perInstance(geometry, "centre", rows.length, 3);
    this.radius = perInstance(geometry, "radius", rows.length, 1);
    this.value = perInstance(geometry, "value", rows.length, 1);
    this.mesh = new THREE.Mesh(geometry, shader);
    this.mesh.frustumCulled = false;
  }

  place(frame, radius) {
    this.rows.forEach((row, i) => {
      this.centre.array.set(frame.position.subarray(3 * row, 3 * row + 3), 3 * i);
      this.radius.array[i] = radius[row];
    });
    this.centre.needsUpdate = this.radius.needsUpdate = true;
  }

  colour(bytes) {
    this.rows.forEach((row, i) => {
      this.value.array[i] = bytes[row];
    });
    this.value.needsUpdate = true;
  }
}

class Bodies extends Instances {
  constructor(geometry, shader, rows, spheres) {
    super(geometry, shader, rows);
    this.spheres = spheres;
    this.orientation = perInstance(geometry, "orientation", rows.length, 4);
  }

  place(frame, radius) {
    super.place(frame, radius);
    this.rows.forEach((row, i) => {
      const at = 4 * (row - this.spheres);
      this.orientation.array.set(frame.orientation.subarray(at, at + 4), 4 * i);
    });
    this.orientation.needsUpdate = true;
  }
}

const squareGeometry = () => {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute(
    "position",
    new THREE.Float32BufferAttribute([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 3),
  );
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
};

const bodyGeometry = (corners) => {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));
  geometry.computeVertexNormals(); // corners are not shared: faces stay flat
  return geometry;
};

// All that is to be drawn of the particles: place(frame), colour(bytes), group.
export class Particles {
  constructor(frames, colours) {
    this.frames = frames;
    this.group = new THREE.Group();
    this.parts = [];
    const rowsOf = (wanted) => [...frames.shape.keys()].filter((row) => frames.shape[row] === wanted);
    if (frames.spheres > 0) {
      const rows = Array.from({ length: frames.spheres }, (_, k) => k);
      this.parts.push(
        new Instances(squareGeometry(), material(SPHERE_VERTEX, SPHERE_FRAGMENT, colours), rows),
      );
    }
    for (const [shape, corners] of Object.entries(frames.view.shapes)) {
      const rows = rowsOf(Number(shape));
      if (rows.length === 0) continue;
      this.parts.push(
        new Bodies(
          bodyGeometry(corners),
          material(BODY_VERTEX, BODY_FRAGMENT, colours),
          rows,
          frames.spheres,
        ),
      );
    }
    for (const part of this.parts) this.group.add(part.mesh);
  }

  place(frame) {
    const radius = this.frames.shownRadius(frame);
    for (const part of this.parts) part.place(frame, radius);
  }

  colour(bytes) {
    for (const part of this.parts) part.colour(bytes);
  }
}
