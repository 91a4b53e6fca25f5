// A map of the mill's cross-section in its polar cells, with the section of the liner, named angles
// and arrows of the mean velocity. Angles count counterclockwise from +x, y is up.
import { el } from "./dom.js";
import { number, unitText } from "./format.js";
import { css, onTheme } from "./theme.js";

const DEGREE = Math.PI / 180;

export class PolarGrid {
  constructor(radius, angle) {
    this.rings = radius.length;
    this.angles = angle.length;
    this.width = this.rings > 1 ? (radius.at(-1) - radius[0]) / (this.rings - 1) : 2 * radius[0];
    this.step = (2 * Math.PI) / this.angles;
    this.start = angle[0] * DEGREE - 0.5 * this.step;
    this.inner = radius[0] - 0.5 * this.width;
    this.outer = this.inner + this.rings * this.width;
  }

  // Number of the cell at (x, y); -1 outside.
  cell(x, y) {
    const ring = Math.floor((Math.hypot(x, y) - this.inner) / this.width);
    if (ring < 0 || ring >= this.rings) return -1;
    const turn = (Math.atan2(y, x) - this.start) / (2 * Math.PI);
    return ring * this.angles + Math.floor((turn - Math.floor(turn)) * this.angles);
  }

  sameAs(other) {
    return (
      this.rings === other.rings &&
      this.angles === other.angles &&
      Math.abs(this.outer - other.outer) < 1e-6 * this.outer
    );
  }
}

// content() gives { grid, values, low, high, lookup, label, unit, profile, rays, arrows, faint }.
export function mapFigure(title, content) {
  const canvas = el("canvas", { tabindex: "0", role: "img" });
  const reading = el("output", { class: "reading" }, " ");
  const figure = el("div", { class: "map" }, canvas, reading);
  const draw = () => {
    const size = Math.min(canvas.parentElement?.clientWidth || 480, 560);
    if (size < 50) return;
    const ratio = Math.min(devicePixelRatio, 2);
    canvas.width = canvas.height = Math.round(size * ratio);
    canvas.style.width = canvas.style.height = `${size}px`;
    const map = content();
    canvas.setAttribute(
      "aria-label",
      `${title}: ${map.label}. ${map.rays.map((ray) => `${ray.label} ${number(ray.angle)} degrees`).join(", ")}`,
    );
    paint(canvas, map, ratio);
  };
  canvas.addEventListener("pointermove", (event) => {
    const map = content(),
      box = canvas.getBoundingClientRect(),
      scale = canvas.clientWidth / 2 / (map.grid.outer * 1.16);
    const x = (event.clientX - box.left - box.width / 2) / scale,
      y = -(event.clientY - box.top - box.height / 2) / scale;
    const cell = map.grid.cell(x, y),
      angle = (Math.atan2(y, x) / DEGREE + 360) % 360;
    reading.value =
      cell < 0
        ? " "
        : `r ${number(Math.hypot(x, y))} m, ${angle.toFixed(0)}°: ${number(map.values[cell])} ${unitText(map.unit)}`;
  });
  canvas.addEventListener("pointerleave", () => {
    reading.value = " ";
  });
  new ResizeObserver(draw).observe(figure);
  onTheme(draw);
  figure.draw = draw;
  return figure;
}

function paint(canvas, map, ratio) {
  const context = canvas.getContext("2d");
  const { grid } = map,
    half = canvas.width / 2,
    scale = half / (grid.outer * 1.16);
  const image = context.createImageData(canvas.width, canvas.height);
  for (let py = 0; py < canvas.height; py += 1) {
    const y = (half - py - 0.5) / scale;
    for (let px = 0; px < canvas.width; px += 1) {
      const cell = grid.cell((px + 0.5 - half) / scale, y);
      if (cell < 0 || map.faint?.(cell)) continue;
      const share = (map.values[cell] - map.low) / (map.high - map.low);
      if (!Number.isFinite(share)) continue;
      const k = 4 * Math.round(255 * Math.min(1, Math.max(0, share)));
      const at = 4 * (py * canvas.width + px);
      for (let c = 0; c < 4; c += 1) image.data[at + c] = map.lookup[k + c];
    }
  }
  context.putImageData(image, 0, 0);
  context.save();
  context.translate(half, half);
  context.scale(1, -1);
  drawLiner(context, map, scale, ratio);
  if (map.arrows) drawArrows(context, map, scale, ratio);
  context.restore();
  drawRays(context, map, { half, scale, ratio });
}

function drawLiner(context, { profile, grid }, scale, ratio) {
  // Everything between the section and a ring around it is liner.
  context.beginPath();
  context.arc(0, 0, grid.outer * scale * 1.035, 0, 2 * Math.PI);
  if (profile.length > 0) {
    profile.forEach(([x, y], k) =>
      k === 0 ? context.moveTo(x * scale, y * scale) : context.lineTo(x * scale, y * scale),
    );
    context.closePath();
  } else {
    context.moveTo(grid.outer * scale, 0);
    context.arc(0, 0, grid.outer * scale, 0, 2 * Math.PI);
  }
  context.fillStyle = css("--liner");
  context.fill("evenodd");
  context.strokeStyle = css("--liner-line");
  context.lineWidth = ratio;
  context.stroke();
}

// One arrow a patch of cells, where there is something that moves.
function drawArrows(context, { grid, arrows }, scale, ratio) {
  const spacing = grid.outer / 11,
    longest = Math.max(...arrows.speed.filter((v) => Number.isFinite(v)), 1e-12);
  context.strokeStyle = context.fillStyle = css("--arrow");
  context.lineWidth = 1.3 * ratio;
  for (let y = -grid.outer; y <= grid.outer; y += spacing) {
    for (let x = -grid.outer; x <= grid.outer; x += spacing) {
      const cell = grid.cell(x, y);
      if (cell < 0 || !(arrows.solid[cell] > 0.05)) continue;
      const length = ((1.5 * spacing * Math.hypot(arrows.x[cell], arrows.y[cell])) / longest) * scale;
      if (length < 2 * ratio) continue;
      arrow(context, x * scale, y * scale, Math.atan2(arrows.y[cell], arrows.x[cell]), length, ratio);
    }
  }
}

function arrow(context, x, y, angle, length, ratio) {
  const head = Math.min(5 * ratio, 0.45 * length);
  context.save();
  context.translate(x, y);
  context.rotate(angle);
  context.beginPath();
  context.moveTo(0, 0);
  context.lineTo(length - head, 0);
  context.stroke();
  context.beginPath();
  context.moveTo(length, 0);
  context.lineTo(length - head, 0.55 * head);
  context.lineTo(length - head, -0.55 * head);
  context.fill();
  context.restore();
}

function drawRays(context, { rays, grid }, { half, scale, ratio }) {
  context.font = `600 ${12 * ratio}px system-ui, sans-serif`;
  context.textBaseline = "middle";
  const taken = [];
  for (const ray of rays) {
    const c = Math.cos(ray.angle * DEGREE),
      s = Math.sin(ray.angle * DEGREE);
    context.strokeStyle = context.fillStyle = css("--ray");
    context.lineWidth = 1.6 * ratio;
    context.setLineDash(ray.dash ? [5 * ratio, 4 * ratio] : []);
    context.beginPath();
    context.moveTo(half + 0.25 * c * grid.outer * scale, half - 0.25 * s * grid.outer * scale);
    context.lineTo(half + 1.06 * c * grid.outer * scale, half - 1.06 * s * grid.outer * scale);
    context.stroke();
    context.setLineDash([]);
    const text = `${ray.label} ${ray.angle.toFixed(0)}°`,
      width = context.measureText(text).width;
    let x = half + 1.09 * c * grid.outer * scale - (c < 0 ? width : 0),
      y = half - 1.09 * s * grid.outer * scale;
    x = Math.max(2 * ratio, Math.min(2 * half - width - 2 * ratio, x));
    y = Math.max(9 * ratio, Math.min(2 * half - 9 * ratio, y));
    while (taken.some((t) => Math.abs(t.y - y) < 15 * ratio && x < t.x + t.width && t.x < x + width))
      y += (s < 0 ? -1 : 1) * 15 * ratio;
    taken.push({ x, y, width });
    context.fillStyle = css("--halo");
    context.fillRect(x - 3 * ratio, y - 8 * ratio, width + 6 * ratio, 16 * ratio);
    context.fillStyle = css("--ray");
    context.fillText(text, x, y);
  }
}
