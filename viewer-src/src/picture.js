// What every picture of a scene has, however it is drawn: a frame, colours, what is picked, what is under the pointer.

import { colourOf, parse } from "./colour.js";
import { piecesOf } from "./beams.js";
import { KINDS } from "./display.js";

const REACH = 9, TOUCH = 22; // pixels around a pointer, or a finger, in which something is hit

export const PRESETS = {
  corner: [0.72, -1, 0.42], front: [0, -1, 0], side: [1, 0, 0], top: [0, -1e-4, 1], plane: [0, 0, 1],
};

export class Picture {
  constructor(canvas, scene) {
    Object.assign(this, { canvas, scene, frame: 0, channel: null, limits: [0, 1], picked: null });
  }

  /** Positions of all nodes at the present frame, moved by the mode shown. */
  points() {
    const { scene, frame, mode } = this;
    return scene.nodes.map((_, node) => {
      const x = scene.position(frame, node);
      if (!mode) return x;
      const shape = scene.arrays[mode.array].data, at = node * scene.dim;
      for (let i = 0; i < scene.dim; i++) x[i] += mode.size * shape[at + i];
      return x;
    });
  }

  setFrame(frame) {
    this.frame = frame;
    this.move();
    this.paint();
  }

  setColours(channel, limits) {
    Object.assign(this, { channel, limits });
    this.paint();
  }

  get plain() {
    return !this.channel || !this.scene.channel(this.channel.id);
  }

  /** The sRGB colour of a member now, 0..255. */
  shade(member) {
    const { scene, channel, frame, limits } = this;
    return this.plain ? parse(KINDS[scene.header.kinds[member]]) : colourOf(channel.scale, scene.value(channel.id, frame, member), limits);
  }

  /** Whether a member is striped: its value was not checked, or its force is not unique. */
  hatched(member) {
    const { scene, channel, frame } = this;
    return !this.plain && channel.id !== "speed" && (scene.unsure.has(member) || Number.isNaN(scene.value(channel.id, frame, member)));
  }

  request() {
    this.waiting ||= requestAnimationFrame(() => this.render());
  }

  /** Places of a member on the canvas from A to B, given those of the nodes: of a beam along its curve. */
  along(member, places) {
    const { curves, ends } = this.scene;
    return curves.row.has(member) ? curves.points(this.now, member).map((point) => this.project(point)) : [places[ends[2 * member]], places[ends[2 * member + 1]]];
  }

  /** The node or member under a place on the canvas: the nearest to the eye of those within reach. */
  pickAt(x, y, touched = false) {
    const places = this.now.map((point) => this.project(point)), reach = touched ? TOUCH : REACH;
    let best = null;
    const offer = (type, index, apart, depth, bonus) => {
      const far = depth + 1e-4 * apart - bonus;
      if (apart <= reach && depth < 1 && (!best || far < best.far)) best = { type, index, far };
    };
    this.scene.members.forEach((_, member) => {
      if (!this.scene.shows(member)) return;
      for (const [p, q] of piecesOf(this.along(member, places))) {
        const [dx, dy] = [q[0] - p[0], q[1] - p[1]];
        const f = Math.min(1, Math.max(0, ((x - p[0]) * dx + (y - p[1]) * dy) / (dx * dx + dy * dy || 1)));
        offer("member", member, Math.hypot(p[0] + f * dx - x, p[1] + f * dy - y), p[2] + f * (q[2] - p[2]), 0);
      }
    });
    // a node lies at the ends of bars that are as near: it comes first
    places.forEach((p, node) => this.scene.directors.has(node) || offer("node", node, Math.hypot(p[0] - x, p[1] - y), p[2], 2e-3));
    return best && { type: best.type, index: best.index };
  }
}
