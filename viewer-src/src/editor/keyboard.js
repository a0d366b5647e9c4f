// Keys in the drawing: a cursor that arrows move and with which Enter gives tools what is there, picks, and takes nodes into the hand.

import { clean } from "./camera.js";
import { stroke } from "./hand.js";
import { HANDS } from "./measures.js";

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

export class Keyboard {
  constructor(draw) {
    Object.assign(this, { draw, grabbed: null });
    draw.canvas.node.addEventListener("keydown", (event) => this.key(event));
  }

  setCursor(point) {
    this.draw.cursor = point;
    this.draw.canvas.rubber();
  }

  key(event) {
    const { draw } = this, { camera } = draw;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "ContextMenu" || (event.key === "F10" && event.shiftKey)) {
      event.preventDefault();
      return this.ask();
    }
    const way = ARROWS[event.key];
    if (way && this.grabbed) {
      event.preventDefault();
      this.nudge(way, event.shiftKey);
    } else if (way) {
      event.preventDefault();
      const [u, v] = camera.across, step = camera.grid * (event.shiftKey ? 10 : 1);
      const start = draw.cursor || camera.snapped(camera.unproject([camera.width / 2, camera.height / 2]) || [0, 0, 0]);
      const next = [...start];
      if (draw.cursor) {
        next[u] = start[u] + way[0] * step;
        next[v] = start[v] + way[1] * step;
      }
      this.goTo(camera.snapped(next));
    } else if (event.key === "PageDown" || event.key === "PageUp") {
      event.preventDefault();
      const by = event.key === "PageDown" ? 1 : -1;
      if (event.shiftKey && camera.dim === 3) this.lift(-by);
      else this.hop(by);
    } else if (event.key === "Enter" && draw.cursor) {
      event.preventDefault();
      this.enter(event);
    } else if (event.key === "Escape") {
      event.preventDefault();
      this.escape();
    }
  }

  /** The cursor at a point, and what is there in words. */
  goTo(point) {
    const { draw } = this, { tools } = draw, place = draw.camera.project(point), hit = draw.canvas.hit(place);
    this.setCursor(point);
    if (tools.using && tools.given.length) tools.show(place);
    draw.say(`${hit ? `${hit.type} ${hit.name}, ` : ""}${draw.cut(point).map((value) => Number(value.toPrecision(6))).join(", ")} m`);
  }

  /** The cursor goes to the next node, after the last one to the middles of members: also where no line of the grid leads. */
  hop(by) {
    const { draw } = this, { nodes, members } = draw.state, { cursor } = draw;
    const stops = [...nodes.map((name) => draw.at(name)), ...members.map(({ ends: [a, b] }) => draw.at(a).map((value, k) => (value + draw.at(b)[k]) / 2))];
    const here = stops.findIndex((stop) => cursor && stop.every((value, k) => Math.abs(value - cursor[k]) * draw.camera.scale < 0.5));
    if (stops.length) this.goTo(stops[here < 0 ? (by > 0 ? 0 : stops.length - 1) : (here + by + stops.length) % stops.length]);
  }

  /** The work plane, and the cursor in it, go on along its normal by a step of the grid. */
  lift(by) {
    const { draw } = this, { axis, at } = draw.camera.plane, to = clean(at + by * draw.camera.grid);
    draw.rail.setPlane({ at: to });
    if (draw.cursor) this.setCursor(draw.cursor.map((value, k) => (k === axis ? to : value)));
    draw.say(`work plane at ${"xyz"[axis]} = ${to} m`);
  }

  /** A node in the hand of the keys goes on by a quarter of a step of the grid (Shift: a whole one). */
  nudge(way, whole) {
    const { draw } = this, { camera } = draw, { node, number } = this.grabbed;
    if (draw.play.away) return draw.tools.back();
    const to = [...((draw.waiting && this.grabbed.to) || draw.at(node))]; // pressed again before the answer: further
    camera.across.forEach((axis, k) => (to[axis] = clean(to[axis] + (way[k] * camera.grid) / (whole ? 1 : 4))));
    draw.drag({ [node]: draw.cut(to) }, number, draw.tool === "move");
    Object.assign(this.grabbed, { to, moved: true });
  }

  /** Take a node into the hand of the keys, or let it go. */
  grab(node) {
    const { draw } = this, before = this.grabbed;
    this.grabbed = node ? { node, number: stroke() } : null;
    if (before?.moved) draw.dragged();
    if (node) draw.say(`${node} is in your hand: arrows move it, ${HANDS[draw.tool]}; Enter lets it go`);
    draw.tools.point(node ? { name: node, at: draw.at(node) } : null);
  }

  /** Nothing begun, no cursor, nothing picked. */
  escape() {
    if (this.grabbed) return this.grab(null);
    const { draw } = this, { tools } = draw;
    if (draw.play.away) return draw.play.home();
    if (tools.before) draw.setTool(tools.before);
    tools.leave();
    draw.pick(null);
  }

  /** The menu of keys: at the cursor, else at what is picked, else in the middle. */
  ask() {
    const { draw } = this, { camera, picked } = draw, [node] = picked.nodes, [member] = picked.members;
    const ends = member && draw.state.members.find(({ name }) => name === member).ends.map((end) => draw.at(end));
    const at = draw.cursor || (node ? draw.at(node) : ends ? ends[0].map((value, k) => (value + ends[1][k]) / 2) : camera.unproject([camera.width / 2, camera.height / 2]) || camera.centre);
    const place = camera.project(at), own = !draw.cursor && (node || member);
    draw.menu.open(place, !own ? draw.tools.there(place) : node ? { node, point: at } : { member, share: 0.5, point: at });
  }

  enter(event) {
    const { draw } = this, { tools } = draw;
    const place = draw.camera.project(draw.cursor), hit = draw.canvas.hit(place), node = hit?.type === "node" && hit.name;
    if (tools.draws && draw.play.away) return tools.back();
    if (tools.using) {
      if (tools.give(tools.wanted(place))) tools.finish({ more: event.shiftKey }); // with Shift it is the press of a pull, which the next one ends
    } else if (draw.task.takes(draw.tool)) draw.task.enter(draw.tool, node ? draw.at(node) : draw.cursor);
    else if (this.grabbed) this.grab(null);
    else if (event.shiftKey && hit) draw.toggle(hit);
    else if (node && (draw.tool === "move" || draw.isPicked(hit))) {
      draw.pick(hit);
      this.grab(node);
    } else draw.pick(hit);
  }
}
