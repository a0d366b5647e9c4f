// The picture of the drawing: an SVG whose parts are made once for each structure and moved with every answer.

import { colourOf, gradient } from "../colour.js";
import { KINDS } from "../display.js";
import { el, fill, svg } from "../dom.js";
import { quantity } from "../format.js";
import { symbolAt } from "../supports.js";
import { Labels, wide } from "./labels.js";
import { bodies, springs } from "./marks.js";
import { HANDS, spanOf } from "./measures.js";
import { arrow, ring } from "./tools/given.js";
import { couplings } from "./tools/joints.js";
import { ARROW, largest } from "./tools/loads.js";
import { dimensions } from "./tools/measuring.js";

const LINES = 60; // most grid lines to either side
const SUPPORT = 24; // pixels of the symbol of a support
const MANY = 80; // nodes above which names are hidden
const FEW = 24; // members up to which all have their names while it moves
const SOME = 60; // members up to which those with room have their names at rest; else those that are picked or pointed at
const CLOSE = 12, FINGER = 22; // pixels from a node within which it is meant, by a pointer and by a finger
const SEVERAL = 7; // arrows of a load along a member
const TURN = 15; // pixels, radius of the arc of a drive
const STROKE = 5; // half of what a mark of a drive takes across its line

const colour = (scale, value, limits) => `rgb(${colourOf(scale, value, limits).map(Math.round).join(" ")})`;
const path = (points, close = false) => (points.length ? `M${points.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join("L")}${close ? "Z" : ""}` : "");

export class Canvas {
  constructor(draw) {
    this.draw = draw;
    const layer = (name) => svg("g", { class: name });
    this.layers = Object.fromEntries(["picture", "grid", "bodies", "curve", "paths", "apart", "task", "bars", "marks", "diagram", "nodes", "names", "values", "rubber"].map((name) => [name, layer(name)]));
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
    this.coils = new Set(Object.entries(state.data.bars || {}).filter(([, one]) => one?.kind === "elastic" && one.stiffness !== undefined).map(([name]) => name));
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
    this.marks(state);
    this.place(state, picked, shown.names && few);
    this.draw.picture.place(this.layers.picture);
    this.draw.curves.place(this.layers.curve);
    this.draw.task.place(this.layers.task);
    this.draw.play.paths(this.layers.paths);
    this.rubber();
    this.draw.value.place();
  }

  /** The name of what the pointer is near is shown, also where there is little room. */
  near(hit) {
    const key = hit ? `${hit.type} ${hit.name}` : "";
    if (key === this.nearKey) return;
    this.nearKey = key;
    const { state, picked, shown } = this.draw;
    this.place(state, picked, shown.names && state.nodes.length <= MANY);
  }

  isNear(type, name) {
    return this.nearKey === `${type} ${name}`;
  }

  paint(state, picked, shown, quick) {
    const forces = this.draw.stale ? null : state.force; // not those before an edit that is computed
    const sizes = (forces || []).filter((value) => value !== null).map(Math.abs);
    const { play } = this.draw, largest = (play.away && play.film.largest) || Math.max(...sizes, 0) || 1; // one scale for a whole motion
    const used = this.draw.stale ? {} : state.used || {}; // null: it is computed
    if (shown.strength) this.strengthLegend(used, state.used ? "not checked: it needs forces, sections and materials" : "it is computed");
    else this.legend.hidden = !shown.force || !sizes.some((value) => value > 0);
    if (!shown.strength && this.legend.dataset.of !== (this.legend.dataset.of = `${largest};${state.unsure.length}`)) fill(this.legend, el("b", {}, "Force"), el("div", { class: "bar", style: `background: ${gradient("diverging")}` }), el("div", { class: "ticks" }, el("span", {}, quantity(-largest, "N")), el("span", {}, "0"), el("span", {}, quantity(largest, "N"))), el("div", { class: "words" }, el("span", {}, "compression"), el("span", {}, "tension")),
      state.unsure.length ? el("div", {}, "?: not unique, in the colour of its kind") : null);
    const unsure = new Set(state.unsure), told = !quick || state.members.length <= FEW;
    this.bars.forEach((bar, k) => {
      const { name, ends, kind } = state.members[k];
      const [a, b] = ends.map((end) => this.at(end));
      bar.setAttribute("d", path(kind === "elastic" && this.coils.has(name) ? coil(a, b) : [a, b]));
      const force = forces?.[k] ?? null;
      const sure = force !== null && !unsure.has(name);
      if (shown.strength) bar.style.stroke = colour("capacity", name in used ? used[name] : NaN, [0, 1]);
      else bar.style.stroke = shown.force && sure ? colour("diverging", force, [-largest, largest]) : KINDS[kind] || KINDS.rigid;
      if (!quick) {
        bar.classList.toggle("picked", picked.members.has(name));
        bar.classList.toggle("apart", name in state.apart);
        bar.classList.toggle("coil", kind === "elastic" && this.coils.has(name));
        bar.classList.toggle("soft", (kind === "elastic" && !this.coils.has(name)) || kind === "cable" || kind === "free");
      }
      if (!told && !picked.members.has(name)) return;
      this.tags[k].textContent = shown.strength && name in used && !shown.lengths ? `${name} ${quantity(used[name], "%")}${unsure.has(name) ? " ?" : ""}` : shown.lengths || this.touches(ends) ? `${name} ${spanOf(...ends.map((end) => this.draw.at(end)), state.dim)}` : shown.force && force !== null ? `${name} ${quantity(Math.abs(force) < 1e-12 * largest ? 0 : force, "N")}${sure ? "" : " ?"}` : name;
    });
  }

  strengthLegend(used, nothing) {
    const most = Object.entries(used).reduce((best, one) => (one[1] > best[1] ? one : best), ["", -1]), key = `strength;${most};${nothing}`;
    this.legend.hidden = false;
    if (this.legend.dataset.of === (this.legend.dataset.of = key)) return;
    fill(this.legend, el("b", {}, "Strength: share of what is allowed"), el("div", { class: "bar", style: `background: ${gradient("sequential")}` }), el("div", { class: "ticks" }, el("span", {}, "0"), el("span", {}, "50 %"), el("span", {}, "100 %")),
      el("div", { class: "swatch" }, el("i", { style: `background: ${colour("capacity", 2, [0, 1])}` }), "beyond a limit"), el("div", { class: "swatch" }, el("i", { style: `background: ${colour("capacity", NaN, [0, 1])}` }), most[0] ? "not checked" : nothing),
      most[0] ? el("div", { class: "words" }, `most: ${most[0]}, ${quantity(most[1], "%")}`) : null);
  }

  /** Whether a member ends at a node that is dragged. */
  touches(ends) {
    return ends.some((end) => this.draw.gripped.has(end));
  }

  /** Names of nodes, values of loads and dimensions, names of what is picked or pointed at, and of members where there is room. */
  place(state, picked, named) {
    const { gripped, play, diagram } = this.draw, members = state.members.map(({ ends }) => ends.map((end) => this.at(end)));
    this.names.begin(this.seen, state.members.length <= SOME ? members : [], this.taken);
    if (named || gripped.size) this.labels.forEach((label, k) => (named ? this.names.node(label, this.seen[k], picked.nodes.has(state.nodes[k]) || this.isNear("node", state.nodes[k])) : label.setAttribute("display", "none")));
    diagram.place(this.layers.diagram, this.names.taken);
    this.values(named);
    if (!named && !gripped.size) return;
    const rank = ({ name }) => (this.isNear("member", name) ? 2 : 0) + (picked.members.has(name) ? 1 : 0), order = state.members.map((_, k) => k).sort((a, b) => rank(state.members[b]) - rank(state.members[a]));
    const some = play.playing ? FEW : SOME;
    for (const k of order) {
      const { name, ends, goes_on: more } = state.members[k], must = !more && (rank(state.members[k]) > 0 || this.touches(ends));
      if ((named && !diagram.found && state.members.length <= some && !more) || must) this.names.member(this.tags[k], ...members[k], must);
      else this.tags[k].setAttribute("display", "none");
    }
  }

  /** The values of loads beside their arrows, and of dimensions. */
  values(named) {
    const shown = (words, kind) => svg("text", { class: kind }, words), texts = [];
    const put = (text, places, width, must) => {
      this.names.put(text, [places], width, must);
      texts.push(text);
    };
    for (const { words, at: [x, y], way: [u, v] } of this.measured) {
      const width = wide(words, 12);
      put(shown(words, "measure"), [0, 0.18, -0.18, 0.32, -0.32].map((share) => [x + share * u - width / 2, y + share * v + 4]), width, true);
    }
    if (named) for (const { words, tip, foot } of this.arrows.slice(0, SOME)) {
      const width = wide(words, 12, 600), down = tip[1] > foot[1] ? 15 : -6, [x, y] = tip;
      put(shown(words, "amount"), [[x - width / 2, y + down], [x + 7, y + 4], [x - width - 7, y + 4], [x + 7, (y + foot[1]) / 2 + 4], [x - width - 7, (y + foot[1]) / 2 + 4], [x - width / 2, y + 2 * down]], width, false);
    }
    this.layers.values.replaceChildren(...texts);
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

  /** Supports, drives, loads, couplings, springs, dimensions. */
  marks(state) {
    const marks = [], at = (name) => this.at(name), ends = (name) => state.members.find((one) => one.name === name)?.ends;
    this.taken = [];
    for (const mark of state.supports) marks.push(...this.support(mark));
    for (const drive of state.drives) marks.push(...this.drive(drive, ends));
    this.arrows = [];
    for (const load of state.loads) marks.push(...this.load(load));
    this.layers.bodies.replaceChildren(...bodies(state.data, at), ...couplings(this.draw, at));
    const measured = dimensions(this.draw, at);
    this.measured = measured.texts;
    this.layers.marks.replaceChildren(...marks, ...springs(state.data, at, ends), ...measured.lines);
  }

  /** The mark of a drive, whose ground no name covers: arrows of a push, an arc about the first end of what turns, a sleeve on a length. */
  drive({ unit, bar, node, axis }, ends) {
    const { camera } = this.draw, takes = (points) => points.forEach(([x, y]) => this.taken.push([x - STROKE, y - STROKE, x + STROKE, y + STROKE]));
    if (node && axis) {
      const from = this.at(node);
      if (!from) return [];
      const place = this.draw.at(node), along = (pixels) => camera.project(place.map((value, k) => value + ("xyz"[k] === axis ? pixels / camera.scale : 0)));
      return [1, -1].map((way) => {
        takes([34, 28, 23, 17, 12].map((pixels) => along(way * pixels)));
        return arrow(along(way * 34), along(way * 12), "drive");
      });
    }
    const pair = ends(bar);
    if (!pair) return [];
    const [a, b] = pair.map((end) => this.at(end)), [x, y] = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], turned = Math.atan2(b[1] - a[1], b[0] - a[0]);
    if (unit === "rad") {
      const [from, to] = pair.map((end) => this.draw.at(end)), arc = ring(this.draw, from, TURN / camera.scale, axis, to.map((value, k) => value - from[k]), [0, 0.8]);
      takes(arc.filter((_, k) => k % 4 === 0));
      return [svg("path", { class: "drive", d: path(arc) })];
    }
    takes([-8, 0, 8].map((along) => [x + along * Math.cos(turned), y + along * Math.sin(turned)]));
    return [svg("rect", { class: "drive", x: -11, y: -5, width: 22, height: 10, rx: 3, transform: `translate(${x} ${y}) rotate(${(turned * 180) / Math.PI})` })];
  }

  /** The arrows of a load, and where its value belongs. */
  load({ name, node, member, force, at, span, shape, turns }) {
    const { state, camera } = this.draw, unit = span ? "N/m" : "N", most = largest(state.loads, unit);
    const own = node ? [] : state.members.filter((one) => one.name === member);
    if (node ? !this.index.has(node) : !own.length) return [];
    const points = node ? [] : [...own.map(({ ends }) => ends[0]), own.at(-1).ends[1]].map((end) => this.draw.at(end));
    const along = (share) => pointAt(points, share);
    let way = [0, 1, 2].map((k) => force[k] || 0);
    if (turns && state.dim === 2) {
      const [p, q] = [points[0], points.at(-1)], length = Math.hypot(q[0] - p[0], q[1] - p[1]) || 1, [c, s] = [(q[0] - p[0]) / length, (q[1] - p[1]) / length];
      way = [c * way[0] - s * way[1], s * way[0] + c * way[1], 0];
    }
    const feet = node ? [[this.draw.at(node), 1]] : span ? Array.from({ length: SEVERAL }, (_, k) => [along(span[0] + ((span[1] - span[0]) * k) / (SEVERAL - 1)), shape[0] + ((shape[1] - shape[0]) * k) / (SEVERAL - 1)]) : [[along(at), 1]];
    const drawn = feet.map(([foot, share]) => [camera.project(foot), camera.project(foot.map((value, k) => value + ((share * way[k]) / most) * (ARROW / camera.scale)))]);
    const [foot, tip] = drawn[Math.floor(drawn.length / 2)];
    this.arrows.push({ name, words: quantity(Math.hypot(...force) * (span ? Math.max(...shape.map(Math.abs)) : 1), unit), foot, tip });
    const rim = span ? [svg("path", { class: "load thin", d: path(drawn.map(([, end]) => end)) })] : [];
    return [...drawn.filter(([p, q]) => Math.hypot(p[0] - q[0], p[1] - q[1]) > 1).map(([p, q]) => arrow(q, p)), ...rim];
  }

  /** The symbol of a support, as large on every scale. */
  support({ node, kind, along }) {
    const place = this.draw.state.places[this.index.get(node)], { camera } = this.draw;
    if (!place) return [];
    const at = [place[0], place[1], place[2] || 0], faces = kind === "pin" || kind === "roller";
    const lines = symbolAt({ kind, along }, at, SUPPORT / camera.scale).map((line) => line.map((point) => camera.project(point)));
    const across = (k) => lines.flat().map((point) => point[k]);
    this.taken.push([Math.min(...across(0)), Math.min(...across(1)), Math.max(...across(0)), Math.max(...across(1))]);
    return lines.map((line, k) => svg("path", { class: faces && k === 0 ? "support" : "support line", "data-support": node, "data-kind": kind, d: path(line) }));
  }

  /** What is being drawn, and the cursor of the keys. */
  rubber() {
    const { camera, rubber, cursor } = this.draw;
    const parts = [];
    if (rubber?.parts) parts.push(...rubber.parts);
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

  /** The lines of a member, on the screen. */
  linesOf(name) {
    return this.draw.state.members.filter((one) => one.name === name).map(({ ends }) => ends.map((end) => this.at(end)));
  }

  /** The share of its length at which a member is nearest to a place of the screen. */
  shareOf(name, [x, y]) {
    const lines = this.linesOf(name), lengths = lines.map(([p, q]) => Math.hypot(q[0] - p[0], q[1] - p[1])), all = lengths.reduce((sum, one) => sum + one, 0) || 1;
    let best = { apart: Infinity, share: 0.5 }, before = 0;
    lines.forEach(([p, q], k) => {
      const f = nearest(p, q, [x, y]), apart = Math.hypot(p[0] + f * (q[0] - p[0]) - x, p[1] + f * (q[1] - p[1]) - y);
      if (apart < best.apart) best = { apart, share: (before + f * lengths[k]) / all };
      before += lengths[k];
    });
    return best.share;
  }

  /** The point of a member nearest to a place of the screen. */
  pointOf(name, place) {
    const own = this.draw.state.members.filter((one) => one.name === name);
    return pointAt([...own.map(({ ends }) => ends[0]), own.at(-1).ends[1]].map((end) => this.draw.at(end)), this.shareOf(name, place));
  }

  /** The node or member at a place of the screen; `allowed` chooses among the nodes. */
  hit([x, y], touch = false, allowed = () => true) {
    const { state } = this.draw;
    const near = touch ? FINGER : CLOSE;
    let best = null;
    this.seen.forEach((p, k) => {
      const apart = Math.hypot(p[0] - x, p[1] - y);
      if (apart <= near && allowed(state.nodes[k]) && (!best || apart < best.apart - 1e-6 || (apart < best.apart + 1e-6 && p[2] > best.depth))) best = { type: "node", name: state.nodes[k], apart, depth: p[2] };
    });
    if (best?.apart <= CLOSE) return best;
    const beside = best ? best.apart - CLOSE + 4 : Infinity; // a short bar under a finger, between its nodes
    state.members.forEach(({ name, ends }) => {
      const [p, q] = ends.map((end) => this.at(end));
      const f = nearest(p, q, [x, y]);
      const apart = Math.hypot(p[0] + f * (q[0] - p[0]) - x, p[1] + f * (q[1] - p[1]) - y);
      if (apart <= (touch ? 16 : 8) && apart < beside && (!best || apart < best.apart)) best = { type: "member", name, apart };
    });
    return best;
  }
}

/** The share of a line at which it is nearest to a point of the screen. */
function nearest(p, q, [x, y]) {
  const [dx, dy] = [q[0] - p[0], q[1] - p[1]];
  return Math.min(1, Math.max(0, ((x - p[0]) * dx + (y - p[1]) * dy) / (dx * dx + dy * dy || 1)));
}

/** The point at a share of the length of a row of points. */
function pointAt(points, share) {
  const lengths = points.slice(1).map((point, k) => Math.hypot(...point.map((value, i) => value - points[k][i])));
  let left = share * lengths.reduce((sum, one) => sum + one, 0);
  const k = lengths.findIndex((length, i) => (left <= length + 1e-12 || i === lengths.length - 1 ? true : ((left -= length), false)));
  return points[k].map((value, i) => value + (left / (lengths[k] || 1)) * (points[k + 1][i] - value));
}

/** A coil spring between two places of the screen. */
function coil(a, b) {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]], far = Math.hypot(dx, dy) || 1, turns = Math.max(4, Math.min(12, Math.round(far / 14)));
  const at = (share, side) => [a[0] + share * dx - (side * dy * 8) / far, a[1] + share * dy + (side * dx * 8) / far];
  return [a, at(0.12, 0), ...Array.from({ length: 2 * turns }, (_, k) => at(0.12 + (0.76 * (k + 0.5)) / (2 * turns), k % 2 ? -1 : 1)), at(0.88, 0), b];
}
