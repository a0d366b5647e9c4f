// Paths of nodes along the run.

import { Group, Line, LineBasicMaterial } from "three";
import { linesOf } from "./marks.js";

export class Traces {
  constructor(scene) {
    this.scene = scene;
    this.group = new Group();
    this.lines = new Map();
    this.material = new LineBasicMaterial({});
  }

  setTheme({ ink }) {
    this.material.color.set(ink);
  }

  /** Show the paths of these nodes only. */
  show(nodes) {
    for (const [node, line] of this.lines) line.visible = nodes.has(node);
    for (const node of nodes) if (!this.lines.has(node)) this.add(node);
  }

  add(node) {
    const { scene } = this;
    const line = new Line(linesOf(Array.from({ length: scene.frames }, (_, frame) => scene.position(frame, node)).flat()), this.material);
    line.frustumCulled = false;
    this.lines.set(node, line);
    this.group.add(line);
  }

  get shown() {
    return [...this.lines].filter(([, line]) => line.visible).map(([node]) => node);
  }
}

/** Nodes that move, but for those of meshes and supports. */
export function movingNodes(scene) {
  const left = new Set([...scene.header.supports.map((one) => one.node), ...scene.skin, ...scene.directors]), found = [];
  for (let node = 0; node < scene.nodes.length; node++) {
    if (left.has(node)) continue;
    const start = scene.position(0, node);
    for (let frame = 1; frame < scene.frames; frame++) {
      const moved = Math.hypot(...scene.position(frame, node).map((x, i) => x - start[i]));
      if (moved > 1e-4 * scene.extent.size) {
        found.push(node);
        break;
      }
    }
  }
  return found;
}
