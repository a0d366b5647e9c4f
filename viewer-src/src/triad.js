// The axes in a corner, and where gravity pulls.

import { AmbientLight, CanvasTexture, DirectionalLight, PerspectiveCamera, Scene as World, Sprite, SpriteMaterial, Vector3 } from "three";
import { arrow, placeArrow } from "./shapes.js";

const SIZE = 104; // CSS pixels
const INK = { light: "#2a3138", dark: "#e3e8ee" };
const AXES = [["x", [1, 0, 0], "#c0392b"], ["y", [0, 1, 0], "#2e8b57"], ["z", [0, 0, 1], "#2f6fc1"]];

export class Triad {
  constructor(scene) {
    this.world = new World();
    this.camera = new PerspectiveCamera(30, 1, 0.1, 20);
    const lamp = new DirectionalLight("#ffffff", 1.5);
    lamp.position.set(1, -2, 3);
    this.world.add(new AmbientLight("#ffffff", 1.8), lamp);
    const shown = AXES.slice(0, scene.dim);
    const g = [0, 1, 2].map((i) => scene.header.gravity[i] || 0), size = Math.hypot(...g);
    if (size) shown.push(["g", g.map((x) => (0.85 * x) / size), "#8a949e"]);
    this.letters = shown.map(([name, direction, colour]) => {
      const one = arrow(colour);
      placeArrow(one, [0, 0, 0], direction, name === "g" ? 0.07 : 0.05);
      const letter = new Sprite(new SpriteMaterial({ depthTest: false }));
      letter.position.set(...direction.map((x) => 1.27 * x));
      letter.scale.setScalar(0.44);
      this.world.add(one, letter);
      return { name, letter, one, at: letter.position.clone() };
    });
  }

  setTheme(theme) {
    for (const { name, letter } of this.letters) {
      letter.material.map?.dispose();
      letter.material.map = written(name, INK[theme]);
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
    for (const { name, letter, one, at } of this.letters) {
      if (name !== "g") continue;
      one.position.copy(aside);
      letter.position.copy(at).add(aside);
    }
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
