// Camera, light and the canvas of one moving picture. Draws when something has changed, not always.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { css, onTheme } from "../theme.js";

export class Stage {
  // `fine`: with smooth edges, which cost much where there is no graphics card.
  constructor(host, size, fine) {
    this.size = size; // m, half of what is to be seen
    this.renderer = new THREE.WebGLRenderer({ antialias: fine, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.canvas = this.renderer.domElement;
    host.append(this.canvas);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, size / 50, size * 40);
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x777788, 2.0), this.camera);
    const lamp = new THREE.DirectionalLight(0xffffff, 1.6);
    lamp.position.set(0.35, 0.45, 0.82);
    this.camera.add(lamp);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.waiting = false;
    onTheme(() => this.paint());
    this.paint();
    new ResizeObserver(() => this.fit(host)).observe(host);
  }

  paint() {
    this.scene.background = new THREE.Color(css("--stage") || "#e9edf2");
    this.draw();
  }

  fit(host) {
    const width = host.clientWidth,
      height = host.clientHeight;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.fov =
      (2 * Math.atan(Math.tan((15 * Math.PI) / 180) / Math.min(1, width / height)) * 180) / Math.PI;
    this.camera.updateProjectionMatrix();
    this.drawNow();
  }

  // Looks along -z at `target`, from slightly above and beside.
  home(target) {
    this.controls.target.copy(target);
    this.camera.position
      .copy(target)
      .add(new THREE.Vector3(0.1, 0.09, 1).normalize().multiplyScalar(4.3 * this.size));
    this.controls.update();
    this.draw();
  }

  draw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.drawNow();
    });
  }

  // Returns when the picture is there.
  finish() {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  drawNow() {
    this.renderer.render(this.scene, this.camera);
  }
}
