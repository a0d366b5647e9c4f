// Names of nodes and members over the picture: each where it covers no other, or not at all.

import { el, fill } from "./dom.js";

const MOST = 400;
const CELL = 48, GAP = 5, APART = 2; // CSS pixels
const AROUND = [[1, -1], [1, 1], [-1, -1], [-1, 1], [0, -1], [0, 1], [1, 0], [-1, 0]];
const ALONG = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8];

export class Names {
  constructor(view) {
    this.view = view;
    this.node = el("div", { class: "names", "aria-hidden": true });
  }

  /** Put the names where their nodes and members are now. covered : boxes that others have taken. */
  place(shown, covered = []) {
    this.node.hidden = !shown || this.view.scene.members.length > MOST;
    if (this.node.hidden) return;
    const { scene, now } = this.view;
    this.tags ??= this.made();
    const points = now.map((point) => this.view.project(point));
    const offset = this.node.getBoundingClientRect(), taken = new Taken(offset.width, offset.height);
    for (const one of this.node.closest(".stage")?.querySelectorAll(".legend") || []) taken.add(around(one, offset));
    for (const box of covered) taken.add(box);
    for (const { tag, type, index } of this.order()) {
      const places = type === "node" ? besides(points[index], tag) : along(this.view.along(index, points), tag);
      // where it was before comes first, so that names do not jump
      const k = [tag.place ?? 0, ...places.keys()].find((one) => one < places.length && taken.free(places[one]));
      tag.node.style.visibility = k === undefined ? "hidden" : "visible";
      if (k === undefined) continue;
      tag.place = k;
      taken.add(places[k]);
      tag.node.style.transform = `translate(${(places[k][0] + APART).toFixed(1)}px, ${places[k][1].toFixed(1)}px)`;
    }
  }

  made() {
    const { scene } = this.view;
    const nodes = [...scene.nodes.map((name, k) => el("span", { class: "of-node", hidden: scene.directors.has(k) }, name)),
      ...scene.members.map((name, k) => el("span", { hidden: !scene.shows(k) }, name))];
    fill(this.node, nodes);
    return nodes.map((node) => ({ node, width: node.offsetWidth, height: node.offsetHeight }));
  }

  /** What is picked first, then nodes, then members. */
  order() {
    const { scene, picked } = this.view, count = scene.nodes.length;
    const found = this.tags.map((tag, k) => (k < count ? { tag, type: "node", index: k } : { tag, type: "member", index: k - count }));
    const first = picked ? found.splice((picked.type === "node" ? 0 : count) + picked.index, 1) : [];
    return [...first, ...found].filter(({ tag }) => !tag.node.hidden);
  }
}

/** Boxes [left, top, right, bottom] beside a point. */
function besides([x, y], { width, height }) {
  return AROUND.map(([right, down]) => boxAt(x + right * (width / 2 + GAP), y + down * (height / 2 + GAP - 1), width, height));
}

/** Boxes on both sides of a line through points, from its middle outwards: of a curve beside its middle third. */
function along(points, { width, height }) {
  const third = Math.floor(points.length / 3), p = points[third], q = points[points.length - 1 - third];
  const [dx, dy] = [q[0] - p[0], q[1] - p[1]], size = Math.hypot(dx, dy) || 1, normal = [dy / size, -dx / size];
  const apart = (Math.abs(normal[0]) * width + Math.abs(normal[1]) * height) / 2 + GAP - 1;
  return ALONG.flatMap((f) => [1, -1].map((side) => boxAt(p[0] + f * dx + side * apart * normal[0], p[1] + f * dy + side * apart * normal[1], width, height)));
}

function boxAt(x, y, width, height) {
  return [x - width / 2 - APART, y - height / 2, x + width / 2 + APART, y + height / 2];
}

function around(node, offset) {
  const box = node.getBoundingClientRect();
  return [box.left - offset.left, box.top - offset.top, box.right - offset.left, box.bottom - offset.top];
}

/** What is covered, by squares of the picture. */
class Taken {
  /** width, height : of the picture, in which names stay. */
  constructor(width, height) {
    Object.assign(this, { width, height, cells: new Map() });
  }

  /** Squares that a box touches. */
  squares([left, top, right, bottom]) {
    const found = [];
    for (let i = Math.floor(left / CELL); i <= Math.floor(right / CELL); i++) {
      for (let j = Math.floor(top / CELL); j <= Math.floor(bottom / CELL); j++) found.push(1e5 * i + j);
    }
    return found;
  }

  free(box) {
    if (box[0] < 0 || box[1] < 0 || box[2] > this.width || box[3] > this.height) return false;
    return this.squares(box).every((key) => (this.cells.get(key) || []).every((one) => one[2] <= box[0] || one[0] >= box[2] || one[3] <= box[1] || one[1] >= box[3]));
  }

  add(box) {
    for (const key of this.squares(box)) {
      if (this.cells.has(key)) this.cells.get(key).push(box);
      else this.cells.set(key, [box]);
    }
  }
}
