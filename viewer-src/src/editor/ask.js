// Asking for a linkage: positions or a path, drawn or typed; what was found, to pick from.

import { el, section, svg } from "../dom.js";
import { quantity } from "../format.js";
import { clean } from "./camera.js";
import { button, check, field, refill } from "./fields.js";
import { metres } from "./readout.js";
import { thumb } from "./thumb.js";

const MOST = 5; // positions
const POINTS = 24; // of a path that was drawn
const CLOSES = 18; // pixels between first and last point of a path that is meant to close
const EXACT = 1e-9; // of the size of a linkage: what is left is round-off
const DEGREE = Math.PI / 180;
const TOOLS = ["positions", "path"];

const apart = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);

/** Points of a drawn line, equally spaced. */
function even(line, count) {
  const along = line.reduce((sums, point, k) => [...sums, k ? sums.at(-1) + apart(point, line[k - 1]) : 0], []);
  return Array.from({ length: count }, (_, k) => {
    const at = (along.at(-1) * k) / (count - 1), next = Math.max(1, along.findIndex((sum) => sum >= at - 1e-12));
    const f = (at - along[next - 1]) / (along[next] - along[next - 1] || 1);
    return [0, 1].map((i) => Number((line[next - 1][i] + f * (line[next][i] - line[next - 1][i])).toPrecision(6)));
  });
}

export class Ask {
  constructor(draw) {
    Object.assign(this, { draw, positions: [], path: [], closed: false, length: 0, fourBars: true, sliders: true, rows: [], told: "", begun: null });
    this.body = el("div", {});
    this.node = section("Ask for a linkage", this.body);
    this.node.open = false;
  }

  takes(tool) {
    return TOOLS.includes(tool);
  }

  // -- drawing the task --------------------------------------------------------------------------------------------

  /** A press with one of the tools: what is being drawn. */
  begin(tool, place, target) {
    this.node.open = true;
    if (tool === "path") return { kind: "ask", line: [this.draw.camera.unproject(place)], places: [place] };
    return target && { kind: "ask", from: target.point };
  }

  move(act, place, target) {
    if (act.line) {
      act.line.push(this.draw.camera.unproject(place));
      act.places.push(place);
    } else if (target) act.to = target.point;
    this.act = act;
    this.draw.canvas.update();
  }

  end(act) {
    this.act = null;
    if (act.line && act.line.length > 3) {
      this.closed = apart(act.places[0], act.places.at(-1)) < CLOSES;
      this.path = even(this.closed ? [...act.line.slice(0, -1), act.line[0]] : act.line, POINTS + this.closed).slice(0, POINTS);
      this.positions = [];
    } else if (act.to) this.add(act.from, act.to);
    this.changed();
  }

  /** With keys alone: points of a path one by one; of a position first the place, then the direction. */
  enter(tool, point) {
    this.node.open = true;
    if (tool === "path") {
      this.path.push(point.slice(0, 2));
      this.positions = [];
    } else if (!this.begun) this.begun = point;
    else {
      this.add(this.begun, point);
      this.begun = null;
    }
    this.changed();
  }

  add(from, to) {
    if (!apart(from, to)) return;
    if (this.positions.length === MOST) return this.draw.tell(`At most ${MOST} positions: no four-bar takes more. Remove one first.`, true);
    if (!this.positions.length) this.length = apart(from, to);
    this.positions.push([from[0], from[1], clean(Math.atan2(to[1] - from[1], to[0] - from[0]))]);
    this.path = [];
  }

  clear() {
    Object.assign(this, { positions: [], path: [], rows: [], told: "", begun: null, length: 0 });
    this.changed();
  }

  changed() {
    this.draw.canvas.update();
    this.rebuild();
  }

  /** The task in the picture. */
  place(layer) {
    const { camera } = this.draw, seen = (point) => camera.project(point);
    const d = (points, close) => `M${points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}${close ? "Z" : ""}`;
    const parts = [], line = this.act?.line || this.path;
    if (line.length > 1) parts.push(svg("path", { class: "way", d: d(line.map(seen), this.closed && !this.act) }));
    if (!this.act?.line) for (const point of this.path) { const [x, y] = seen(point); parts.push(svg("circle", { class: "at", cx: x, cy: y, r: 2.5 })); }
    const size = this.length || 60 / camera.scale;
    const rows = [...this.positions];
    if (this.act?.to) rows.push([...this.act.from.slice(0, 2), Math.atan2(this.act.to[1] - this.act.from[1], this.act.to[0] - this.act.from[0])]);
    rows.forEach(([x, y, angle], k) => {
      const p = seen([x, y]), q = seen([x + size * Math.cos(angle), y + size * Math.sin(angle)]);
      const turned = Math.atan2(q[1] - p[1], q[0] - p[0]), wing = (by) => [q[0] - 10 * Math.cos(turned + by), q[1] - 10 * Math.sin(turned + by)];
      parts.push(svg("path", { class: "position", d: d([p, q]) + d([wing(0.45), q, wing(-0.45)]) }), svg("circle", { class: "at", cx: p[0], cy: p[1], r: 4 }), svg("text", { x: p[0] - 14, y: p[1] + 5 }, k + 1));
    });
    if (this.begun) { const [x, y] = seen(this.begun); parts.push(svg("circle", { class: "at", cx: x, cy: y, r: 4 })); }
    layer.replaceChildren(...parts);
  }

  // -- the panel ---------------------------------------------------------------------------------------------------

  rebuild() {
    const { draw } = this, { state } = draw;
    if (!state) return;
    if (state.dim !== 2) return refill(this.body, el("p", { class: "faint" }, "Linkages lie in the plane; this drawing is in space."));
    const few = this.positions.length ? this.positions.length < 3 : this.path.length < 4;
    const tool = (name, words) => button(words, () => draw.setTool(name), { "aria-pressed": String(draw.tool === name), "aria-label": `draw ${name}` });
    refill(this.body, el("p", { class: "faint" }, "Draw three to five positions of a body, each from a point along its direction, or draw a path. Four-bars and slider-cranks that pass there are found."),
      el("div", { class: "row" }, tool("positions", "Draw positions"), tool("path", "Draw a path"), button("Type a position", () => this.type(), { disabled: this.positions.length === MOST }), button("Clear", () => this.clear(), { "aria-label": "clear the task" })),
      this.positions.map((row, k) => this.position(row, k)), this.path.length || !this.positions.length ? this.points() : null,
      el("div", { class: "row" }, check("four-bars", this.fourBars, (on) => (this.fourBars = on)), check("slider-cranks", this.sliders, (on) => (this.sliders = on)), button("Find linkages", () => this.find(), { disabled: few || Boolean(this.asking) })),
      el("div", { class: "cards" }, this.rows.map((row, k) => this.card(row, k))),
      this.told ? el("p", { role: "status", class: this.rows.length ? "faint" : "banner warning" }, this.told) : null);
  }

  position(row, k) {
    const set = (i, value, read) => {
      const found = value === null ? NaN : read(value);
      if (Number.isFinite(found)) row[i] = found;
      else this.draw.tell(`${i === 2 ? "An angle is a number of degrees" : "A place is a length: 0.1, 50 mm"}. Got ${value ?? "nothing"}.`, true);
      this.changed();
    };
    return el("div", { class: "row" }, el("b", {}, k + 1), ["x", "y"].map((axis, i) => field(axis, Number(row[i].toPrecision(5)), (value) => set(i, value, metres), { size: 5, name: `${axis} of position ${k + 1}` })),
      field("deg", Number((row[2] / DEGREE).toPrecision(4)), (value) => set(2, value, (one) => Number(one) * DEGREE), { size: 4, name: `angle of position ${k + 1}` }),
      button("×", () => { this.positions.splice(k, 1); this.changed(); }, { "aria-label": `remove position ${k + 1}` }));
  }

  /** Another position, to be typed. */
  type() {
    const last = this.positions.at(-1) || [0, 0, 0];
    this.positions.push(this.positions.length ? [clean(last[0] + this.draw.camera.grid), last[1], clean(last[2] + 15 * DEGREE)] : [...last]);
    this.length ||= 2 * this.draw.camera.grid;
    this.path = [];
    this.changed();
  }

  points() {
    const area = el("textarea", { rows: 3, "aria-label": "points of the path", placeholder: "x, y of each point, one a line", spellcheck: "false" });
    area.value = this.path.map((point) => point.join(", ")).join("\n");
    area.addEventListener("change", () => {
      const lines = area.value.split("\n").map((line) => line.trim()).filter(Boolean);
      const rows = lines.map((line) => line.split(/[,;\s]+/).map(Number)), wrong = rows.findIndex((row) => row.length !== 2 || row.some((value) => !Number.isFinite(value)));
      if (wrong >= 0) return this.draw.tell(`Line ${wrong + 1} of the path: ${lines[wrong]}. Write two numbers, in m, e.g. 0.1, 0.25.`, true);
      Object.assign(this, { path: rows, positions: rows.length ? [] : this.positions });
      this.changed();
    });
    return el("div", { class: "points" }, area, check("closed", this.closed, (on) => { this.closed = on; this.changed(); }, "closed path"));
  }

  card({ type, error, transmission, size, picture }, k) {
    const words = [error > EXACT * size ? `off by ${quantity(error, "m")}` : "exact", `transmission ${Math.round(transmission / DEGREE)}°`];
    return el("button", { type: "button", class: "card", title: "Put it into the drawing", "aria-label": `put linkage ${k + 1}: ${type}, ${words.join(", ")}`, onclick: () => this.put(k) }, thumb(picture), el("b", {}, type), words.map((word) => el("span", {}, word)));
  }

  async find() {
    this.asking = true;
    Object.assign(this, { rows: [], told: "" });
    this.rebuild();
    const kinds = [this.fourBars && "four-bar", this.sliders && "slider-crank"].filter(Boolean);
    const task = this.positions.length ? { positions: this.positions, point: this.length } : { path: this.path, closed: this.closed };
    const answer = kinds.length ? await this.draw.ask({ do: "ask", kinds, ...task }) : { message: "Choose four-bars, slider-cranks or both." };
    Object.assign(this, { asking: false, rows: answer.rows || [], told: answer.message || "" });
    this.rebuild();
  }

  async put(k) {
    const answer = await this.draw.edit({ do: "choose", number: k });
    if (answer.kind === "drawing") this.draw.reveal();
  }
}
