// The axes in a corner, and where gravity pulls.

import { AmbientLight, CanvasTexture, DirectionalLight, PerspectiveCamera, Scene as World, Sprite, SpriteMaterial, Vector3 } from "three";
import { THEMES } from "./display.js";
import { arrow, placeArrow } from "./shapes.js";

const SIZE = 104; // CSS pixels
const AXES = [["x", [1, 0, 0], "#c0392b"], ["y", [0, 1, 0], "#2e8b57"], ["z", [0, 0, 1], "#2f6fc1"]];

export class Triad {
  constructor(scene) {
    this.world = new World();
    this.camera = new PerspectiveCamera(30, 1, 0.1, 20);
    const lamp = new DirectionalLight("#ffffff", 1.5);
    lamp.position.set(1, -2, 3);
    this.world.add(new AmbientLight("#ffffff", 1.8), lamp);
    this.letters = AXES.slice(0, scene.dim).map(([name, direction, colour]) => this.add(name, direction, colour, 0.05));
    this.gravity = this.add("g", [0, 0, 1], "#8a949e", 0.07);
    this.letters.push(this.gravity);
    this.setGravity(scene.header.gravity);
  }

  add(name, direction, colour, radius) {
    const one = arrow(colour), letter = new Sprite(new SpriteMaterial({ depthTest: false }));
    placeArrow(one, [0, 0, 0], direction, radius);
    letter.position.set(...direction.map((x) => 1.27 * x));
    letter.scale.setScalar(0.44);
    this.world.add(one, letter);
    return { name, letter, one };
  }

  setGravity(gravity) {
    const g = [0, 1, 2].map((i) => gravity[i] || 0), size = Math.hypot(...g);
    const { one, letter } = this.gravity;
    letter.visible = size > 0;
    this.pull = new Vector3(...g).multiplyScalar(1.08 / (size || 1));
    placeArrow(one, [0, 0, 0], g.map((x) => (0.85 * x) / (size || 1)), 0.07);
  }

  setTheme(theme) {
    for (const { name, letter } of this.letters) {
      letter.material.map?.dispose();
      letter.material.map = written(name, THEMES[theme].ink);
      letter.material.needsUpdate = true;
    }
  }

  render(renderer, camera) {
    const ratio = renderer.getPixelRatio(), size = renderer.domElement;
    const width = size.width / ratio;
    this.camera.position.set(0, 0, 5.6).applyQuaternion(camera.quaternion);
    this.camera.quaternion.copy(camera.quaternion);
    // gravity stands beside the axes, so that it never covers one
    const aside = new Vector3(-0.95, 0, 0).applyQuaternion(camera.quaternion);
    this.gravity.one.position.copy(aside);
    this.gravity.letter.position.copy(this.pull).add(aside);
    renderer.setViewport(width - SIZE - 4, 4, SIZE, SIZE);
    renderer.clearDepth();
    renderer.render(this.world, this.camera);
    renderer.setViewport(0, 0, width, size.height / ratio);
  }
}

function written(text, colour) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d");
  pen.font = "600 46px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.fillStyle = colour;
  pen.fillText(text, 32, 34);
  return new CanvasTexture(canvas);
}
