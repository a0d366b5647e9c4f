// The picture of the drawing: an SVG whose parts are made once for each structure and moved with every answer.

import { colourOf, gradient } from "../colour.js";
import { KINDS } from "../display.js";
import { el, fill, svg } from "../dom.js";
import { quantity } from "../format.js";
import { symbolAt } from "../supports.js";
import { Labels } from "./labels.js";
import { bodies, springs } from "./marks.js";
import { HANDS, spanOf } from "./measures.js";

const LINES = 60; // most grid lines to either side
const SUPPORT = 24; // pixels of the symbol of a support
const ARROW = 46; // pixels of the largest load
const MANY = 80; // nodes above which names are hidden
const FEW = 24; // members up to which all have their names, else those that are picked

const path = (points, close = false) => (points.length ? `M${points.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join("L")}${close ? "Z" : ""}` : "");

export class Canvas {
  constructor(draw) {
    this.draw = draw;
    const layer = (name) => svg("g", { class: name });
    this.layers = Object.fromEntries(["picture", "grid", "bodies", "curve", "paths", "apart", "task", "bars", "marks", "diagram", "nodes", "names", "rubber"].map((name) => [name, layer(name)]));
    this.node = svg("svg", { class: "drawing", tabindex: 0, role: "application", "aria-label": "drawing; arrow keys move the cursor, Enter draws there, Tab leaves" }, ...Object.values(this.layers));
    this.names = new Labels();
    this.legend = el("div", { class: "legend", hidden: true });
    new ResizeObserver(() => this.resize()).observe(this.node);
  }

  resize() {
    const { width, height } = this.node.getBoundingClientRect();
    if (!width || !height) return;
    Object.assign(this.draw.camera, { width, height });
    this.node.setAttribute("viewBox", `0 0 ${width} ${height}`);
    if (!this.sized && this.draw.state) this.draw.fit();
    this.sized = true;
    this.update();
  }

  /** Another structure: its parts are made anew. */
  rebuild() {
    const { state } = this.draw;
    this.places = new Map();
    this.bars = state.members.map(({ name }) => svg("path", { class: "bar", "data-member": name }));
    this.circles = state.nodes.map((name) => svg("circle", { class: "node", "data-node": name, r: 6 }));
    this.labels = state.nodes.map((name) => svg("text", { class: "name" }, name));
    this.tags = state.members.map(({ name }) => svg("text", { class: "tag" }, name));
    this.layers.bars.replaceChildren(...this.bars);
    this.layers.nodes.replaceChildren(...this.circles);
    this.layers.names.replaceChildren(...this.tags, ...this.labels);
    this.index = new Map(state.nodes.map((name, k) => [name, k]));
    this.update();
  }

  /** Place of a node on the screen. */
  at(name) {
    return this.seen[this.index.get(name)];
  }

  /** quick : only places and forces are others than in the last picture. */
  update(quick = false) {
    const { state, camera, picked, shown } = this.draw;
    if (!state || !this.bars) return;
    this.seen = state.places.map((place) => camera.project(place));
    this.grid();
    this.paint(state, picked, shown, quick);
    const few = state.nodes.length <= MANY;
    this.layers.names.setAttribute("display", (shown.names && few) || this.draw.gripped.size ? "inline" : "none");
    this.circles.forEach((circle, k) => {
      const [x, y] = this.seen[k];
      circle.setAttribute("cx", x.toFixed(2));
      circle.setAttribute("cy", y.toFixed(2));
      if (!quick) circle.classList.toggle("picked", picked.nodes.has(state.nodes[k]));
    });
    this.place(state, picked, shown.names && few);
    this.marks(state);
    this.draw.picture.place(this.layers.picture);
    this.draw.curves.place(this.layers.curve);
    this.draw.task.place(this.layers.task);
    this.draw.play.paths(this.layers.paths);
    this.rubber();
  }

  paint(state, picked, shown, quick) {
    const forces = this.draw.stale ? null : state.force; // not those before an edit that is computed
    const sizes = (forces || []).filter((value) => value !== null).map(Math.abs);
    const { play } = this.draw, largest = (play.away && play.film.largest) || Math.max(...sizes, 0) || 1; // one scale for a whole motion
    this.legend.hidden = !shown.force || !sizes.some((value) => value > 0);
    if (this.legend.dataset.of !== (this.legend.dataset.of = `${largest};${state.unsure.length}`)) fill(this.legend, el("b", {}, "Force"), el("div", { class: "bar", style: `background: ${gradient("diverging")}` }), el("div", { class: "ticks" }, el("span", {}, quantity(-largest, "N")), el("span", {}, "0"), el("span", {}, quantity(largest, "N"))), el("div", { class: "words" }, el("span", {}, "compression"), el("span", {}, "tension")),
      state.unsure.length ? el("div", {}, "?: not unique, in the colour of its kind") : null);
    const unsure = new Set(state.unsure), told = !quick || state.members.length <= FEW;
    this.bars.forEach((bar, k) => {
      const { name, ends, kind } = state.members[k];
      const [a, b] = ends.map((end) => this.at(end));
      bar.setAttribute("d", path([a, b]));
      const force = forces?.[k] ?? null;
      const sure = force !== null && !unsure.has(name);
      bar.style.stroke = shown.force && sure ? `rgb(${colourOf("diverging", force, [-largest, largest]).map(Math.round).join(" ")})` : KINDS[kind] || KINDS.rigid;
      if (!quick) {
        bar.classList.toggle("picked", picked.members.has(name));
        bar.classList.toggle("apart", name in state.apart);
        bar.classList.toggle("soft", kind === "elastic" || kind === "cable" || kind === "free");
      }
      if (!told && !picked.members.has(name)) return;
      this.tags[k].textContent = shown.lengths || this.touches(ends) ? `${name} ${spanOf(...ends.map((end) => this.draw.at(end)), state.dim)}` : shown.force && force !== null ? `${name} ${quantity(Math.abs(force) < 1e-12 * largest ? 0 : force, "N")}${sure ? "" : " ?"}` : name;
    });
  }

  /** Whether a member ends at a node that is dragged. */
  touches(ends) {
    return ends.some((end) => this.draw.gripped.has(end));
  }

  /** Names of nodes, of what is picked, and of members where there is room. */
  place(state, picked, named) {
    this.names.begin(this.seen);
    if (named || this.draw.gripped.size) this.labels.forEach((label, k) => (named ? this.names.node(label, this.seen[k]) : label.setAttribute("display", "none")));
    this.draw.diagram.place(this.layers.diagram, this.names.taken);
    if (!named && !this.draw.gripped.size) return;
    const order = state.members.map((_, k) => k).sort((a, b) => picked.members.has(state.members[b].name) - picked.members.has(state.members[a].name));
    for (const k of order) {
      const { name, ends, goes_on: more } = state.members[k], must = !more && (picked.members.has(name) || this.touches(ends));
      if ((named && state.members.length <= FEW && !more) || must) this.names.member(this.tags[k], this.at(ends[0]), this.at(ends[1]), must);
      else this.tags[k].setAttribute("display", "none");
    }
  }

  grid() {
    const { camera } = this.draw;
    const [u, v] = camera.across, { grid } = camera, key = `${camera.key},${grid},${camera.dim}`;
    if (key === this.gridded) return;
    this.gridded = key;
    const middle = camera.unproject([camera.width / 2, camera.height / 2]);
    if (!middle) {
      this.layers.grid.replaceChildren();
      return;
    }
    const reach = Math.min(LINES, Math.ceil((0.75 * Math.hypot(camera.width, camera.height)) / camera.scale / grid));
    const from = (axis) => Math.round(middle[axis] / grid) - reach;
    const point = (x, y) => {
      const p = [0, 0, 0];
      [p[u], p[v], p[camera.plane.axis]] = [x * grid, y * grid, camera.plane.at];
      return camera.project(p);
    };
    const [u0, v0] = [from(u), from(v)], [u1, v1] = [u0 + 2 * reach, v0 + 2 * reach];
    const lines = { thin: "", axis: "" };
    for (let k = u0; k <= u1; k++) lines[k === 0 ? "axis" : "thin"] += path([point(k, v0), point(k, v1)]);
    for (let k = v0; k <= v1; k++) lines[k === 0 ? "axis" : "thin"] += path([point(u0, k), point(u1, k)]);
    const origin = camera.project([0, 0, 0]);
    const names = [..."xyz"].slice(0, camera.dim).map((name, k) => {
      const tip = camera.project([0, 1, 2].map((i) => (i === k ? 34 / camera.scale : 0)));
      return svg("text", { class: "axis-name", x: tip[0], y: tip[1] }, name);
    });
    const cross = [0, 1, 2].slice(0, camera.dim).map((k) => path([origin, camera.project([0, 1, 2].map((i) => (i === k ? 28 / camera.scale : 0)))])).join("");
    this.layers.grid.replaceChildren(svg("path", { class: "thin", d: lines.thin }), svg("path", { class: "zero", d: lines.axis }), svg("path", { class: "cross", d: cross }), ...names);
  }

  /** Supports, drives, loads and masses. */
  marks(state) {
    const marks = [];
    for (const mark of state.supports) marks.push(...this.support(mark));
    for (const { unit, bar } of state.drives) {
      const member = state.members.find((one) => one.name === bar);
      if (!member) continue;
      const [a, b] = member.ends.map((end) => this.at(end));
      const turned = Math.atan2(b[1] - a[1], b[0] - a[0]);
      if (unit === "rad") marks.push(svg("path", { class: "drive", d: `M${a[0] + 15 * Math.cos(turned)} ${a[1] + 15 * Math.sin(turned)}A15 15 0 1 1 ${a[0] + 15 * Math.cos(turned + 1.2)} ${a[1] + 15 * Math.sin(turned + 1.2)}` }));
      else marks.push(svg("rect", { class: "drive", x: -11, y: -5, width: 22, height: 10, rx: 3, transform: `translate(${(a[0] + b[0]) / 2} ${(a[1] + b[1]) / 2}) rotate(${(turned * 180) / Math.PI})` }));
    }
    const largest = Math.max(...state.loads.map(({ force }) => Math.hypot(...force)), 0) || 1;
    for (const { node, force } of state.loads) {
      const place = state.places[this.index.get(node)];
      if (!place) continue;
      const end = this.at(node), { camera } = this.draw;
      const tip = camera.project(place.map((value, k) => value + ((force[k] || 0) / largest) * (ARROW / camera.scale)));
      marks.push(arrow(tip, end));
    }
    const at = (name) => this.at(name), ends = (name) => state.members.find((one) => one.name === name)?.ends;
    this.layers.bodies.replaceChildren(...bodies(state.data, at));
    this.layers.marks.replaceChildren(...marks, ...springs(state.data, at, ends));
  }

  /** The symbol of a support, as large on every scale. */
  support({ node, kind, along }) {
    const place = this.draw.state.places[this.index.get(node)], { camera } = this.draw;
    if (!place) return [];
    const at = [place[0], place[1], place[2] || 0], faces = kind === "pin" || kind === "roller";
    return symbolAt({ kind, along }, at, SUPPORT / camera.scale).map((line, k) => svg("path", { class: faces && k === 0 ? "support" : "support line", "data-support": node, "data-kind": kind, d: path(line.map((point) => camera.project(point))) }));
  }

  /** What is being drawn, and the cursor of the keys. */
  rubber() {
    const { camera, rubber, cursor } = this.draw;
    const parts = [];
    if (rubber?.from && rubber.to) parts.push(svg("path", { class: "rubber", d: path([camera.project(rubber.from), camera.project(rubber.to)]) }));
    if (rubber?.box) parts.push(svg("path", { class: "box", d: path([[rubber.box[0], rubber.box[1]], [rubber.box[2], rubber.box[1]], [rubber.box[2], rubber.box[3]], [rubber.box[0], rubber.box[3]]], true) }));
    if (rubber?.to) {
      const [x, y] = camera.project(rubber.to);
      parts.push(svg("circle", { class: "hint", cx: x, cy: y, r: 9 }));
    }
    const { pointed, tool } = this.draw;
    if (pointed?.name && HANDS[tool]) {
      const [x, y] = camera.project(pointed.at);
      parts.push(svg("text", { class: "hand", x: x + 12, y: y + 24 }, HANDS[tool]));
    }
    if (cursor) {
      const [x, y] = camera.project(cursor);
      parts.push(svg("path", { class: "cursor", d: `M${x - 12} ${y}H${x + 12}M${x} ${y - 12}V${y + 12}` }));
    }
    this.layers.rubber.replaceChildren(...parts);
    this.draw.readout.update();
  }

  /** The node or member at a place of the screen; `allowed` chooses among the nodes. */
  hit([x, y], touch = false, allowed = () => true) {
    const { state } = this.draw;
    const near = touch ? 22 : 12;
    let best = null;
    this.seen.forEach((p, k) => {
      const apart = Math.hypot(p[0] - x, p[1] - y);
      if (apart <= near && allowed(state.nodes[k]) && (!best || apart < best.apart - 1e-6 || (apart < best.apart + 1e-6 && p[2] > best.depth))) best = { type: "node", name: state.nodes[k], apart, depth: p[2] };
    });
    if (best) return best;
    state.members.forEach(({ name, ends }) => {
      const [p, q] = ends.map((end) => this.at(end));
      const [dx, dy] = [q[0] - p[0], q[1] - p[1]];
      const f = Math.min(1, Math.max(0, ((x - p[0]) * dx + (y - p[1]) * dy) / (dx * dx + dy * dy || 1)));
      const apart = Math.hypot(p[0] + f * dx - x, p[1] + f * dy - y);
      if (apart <= (touch ? 16 : 8) && (!best || apart < best.apart)) best = { type: "member", name, apart };
    });
    return best;
  }
}

function arrow(tip, end) {
  const turned = Math.atan2(tip[1] - end[1], tip[0] - end[0]);
  const wing = (by) => [tip[0] - 9 * Math.cos(turned + by), tip[1] - 9 * Math.sin(turned + by)];
  return svg("path", { class: "load", d: path([end, tip]) + path([wing(0.42), tip, wing(-0.42)]) });
}
