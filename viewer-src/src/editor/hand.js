// What pointer and keys do in the drawing: pick and move, nodes, bars, what tools are given; pan, turn and approach; the menu.

import { clean } from "./camera.js";
import { HANDS } from "./measures.js";
import { TOOLS } from "./tools/index.js";

const EDGE = "The work plane is seen edge-on. Turn the view, or choose another plane.";
const SLACK = 4; // pixels that a click may move
const LONG = 550; // ms after which the press of a finger is long
const LIFT = { PageUp: 1, PageDown: -1 };
const FEW_KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** The number of a drag: its moves are one step of undo. */
const stroke = () => Math.floor(Math.random() * 2 ** 50);

export class Hand {
  constructor(draw) {
    Object.assign(this, { draw, given: [], before: null });
    this.pointers = new Map();
    const { node } = draw.canvas;
    node.addEventListener("pointerdown", (event) => this.down(event));
    node.addEventListener("pointermove", (event) => this.move(event));
    node.addEventListener("pointerup", (event) => this.up(event));
    node.addEventListener("pointercancel", (event) => this.cancel(event));
    node.addEventListener("wheel", (event) => {
      event.preventDefault();
      draw.camera.zoom(Math.exp(-event.deltaY / 500), this.place(event));
      draw.canvas.update();
    }, { passive: false });
    node.addEventListener("contextmenu", (event) => event.preventDefault()); // a press without moving opens it, of keys `key`
    node.addEventListener("keydown", (event) => this.key(event));
    node.addEventListener("blur", () => {
      this.cancelAct();
      this.setCursor(null);
    });
    node.addEventListener("pointerleave", () => this.point(null));
  }

  place(event) {
    const box = this.draw.canvas.node.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  /** Node or free point at a place: {node} or {point}; null where the plane is seen edge-on. New nodes see those of their plane. */
  target(place, touch) {
    const { draw } = this;
    const hit = draw.canvas.hit(place, touch, (name) => draw.tool !== "node" || draw.inPlane(name));
    if (hit?.type === "node") return { node: hit.name, point: draw.at(hit.name) };
    const point = draw.camera.unproject(place);
    if (!point) {
      draw.tell(EDGE, true);
      return null;
    }
    const there = draw.snapped(point), own = draw.nodeAt(there); // the grid may lead to a node that was not hit
    return own === undefined ? { point: there } : { node: own, point: draw.at(own) };
  }

  down(event) {
    const { draw } = this, place = this.place(event), touch = event.pointerType === "touch";
    draw.canvas.node.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, place);
    draw.canvas.node.focus({ preventScroll: true });
    this.setCursor(null);
    draw.menu.close();
    clearTimeout(this.long);
    if (this.pointers.size === 2) return this.pinch();
    if (touch) this.long = setTimeout(() => this.pressed(place), LONG);
    if (event.button === 1 || event.button === 2 || event.altKey) {
      this.act = { kind: draw.camera.dim === 3 && !event.shiftKey ? "turn" : "pan", last: place, start: place, asks: event.button === 2 };
      return;
    }
    if (draw.picture.placing) return draw.picture.click(place);
    const hit = draw.canvas.hit(place, touch);
    if (this.draws && draw.play.away) return this.back();
    if (HANDS[draw.tool]) this.begin(hit, place, event);
    else if (draw.task.takes(draw.tool)) this.act = draw.task.begin(draw.tool, place, this.target(place, touch));
    else if (this.using) this.act = this.give(this.wanted(place, touch)) ? { kind: "give", start: place } : null;
    else this.act = { kind: draw.tool, start: place, from: this.target(place, touch) };
  }

  begin(hit, place, event) {
    const { draw } = this, more = event.shiftKey || draw.several;
    if (!hit) {
      this.act = more ? { kind: "box", start: place } : { kind: "pan", last: place, start: place, clear: true };
      return;
    }
    if (more) draw.toggle(hit);
    else if (!draw.isPicked(hit)) draw.pick(hit);
    if (hit.type === "node") this.act = { kind: "drag", start: place, node: hit.name, from: Object.fromEntries([...draw.picked.nodes].map((name) => [name, draw.at(name)])), number: stroke() };
    else this.act = { kind: "none" };
  }

  move(event) {
    const { draw } = this, { act } = this, place = this.place(event);
    if (this.pointers.has(event.pointerId)) this.pointers.set(event.pointerId, place);
    if (act?.kind === "pinch") return this.pinched();
    if (act && Math.hypot(place[0] - (act.start || place)[0], place[1] - (act.start || place)[1]) > SLACK) clearTimeout(this.long);
    if (!act) return this.hover(place);
    if (act.kind === "give") return this.show(place, event.pointerType === "touch");
    if (act.kind === "pan" || act.kind === "turn") {
      const [dx, dy] = [place[0] - act.last[0], place[1] - act.last[1]];
      const far = Math.hypot(place[0] - act.start[0], place[1] - act.start[1]) > SLACK;
      if (far) act.clear = act.asks = false;
      if (act.kind === "pan") draw.camera.pan(dx, dy);
      else draw.camera.turn(-dx / 150, dy / 150);
      act.last = place;
      draw.canvas.update();
    } else if (act.kind === "box") {
      draw.rubber = { box: [...act.start, ...place] };
      draw.canvas.rubber();
    } else if (act.kind === "drag") this.drag(place);
    else if (act.kind === "ask") draw.task.move(act, place, this.target(place, event.pointerType === "touch"));
    else if (act.kind === "bar" && act.from) {
      const to = this.target(place, event.pointerType === "touch");
      draw.rubber = to && { from: act.from.point, to: to.point };
      draw.canvas.rubber();
    }
  }

  hover(place) {
    const { draw } = this;
    if (draw.closed) return;
    const hit = draw.canvas.hit(place);
    draw.canvas.near(hit);
    if (this.using) return this.show(place);
    if (HANDS[draw.tool]) return this.point(hit?.type === "node" ? { name: hit.name, at: draw.at(hit.name) } : null);
    const point = hit?.type === "node" ? draw.at(hit.name) : draw.camera.unproject(place);
    const to = point && (hit?.type === "node" ? point : draw.snapped(point));
    draw.rubber = to ? { from: this.pending?.point, to } : null;
    draw.canvas.rubber();
  }

  /** One draws in the pose that is drawn. */
  back() {
    this.act = null;
    this.draw.play.home();
    this.draw.tell("This is the pose that is drawn: draw here. Or stop the motion where you want, and choose Keep this pose.");
  }

  /** What the readout tells of the pointer. */
  point(pointed) {
    this.draw.pointed = pointed;
    if (!pointed && !this.act) this.draw.rubber = null;
    this.draw.canvas.rubber();
  }

  /** Drag the picked nodes, in a plane parallel to the work plane. */
  drag(place) {
    const { draw, act } = this, own = act.from[act.node];
    if (!act.moved && Math.hypot(place[0] - act.start[0], place[1] - act.start[1]) <= SLACK) return;
    if (draw.play.away) return this.back();
    const to = draw.camera.unproject(place, own[draw.camera.plane.axis] || 0);
    if (!to) return draw.tell(EDGE, true);
    act.moved = true;
    const keep = draw.tool === "move", there = keep ? to : draw.snapped(to, new Set(Object.keys(act.from)));
    const places = {};
    for (const [name, from] of Object.entries(act.from)) places[name] = from.map((value, k) => (k === draw.camera.plane.axis || there[k] === own[k] ? value : clean(value + there[k] - own[k]))).slice(0, draw.camera.dim);
    draw.pointed = { name: act.node, at: places[act.node] };
    draw.drag(places, act.number, keep);
  }

  up(event) {
    const { draw, act } = this, place = this.place(event);
    this.pointers.delete(event.pointerId);
    clearTimeout(this.long);
    this.act = null;
    draw.rubber = null;
    if (act?.asks) return draw.menu.open(place, this.there(place));
    if (act?.kind === "give") return this.released(act, place, event.pointerType === "touch");
    if (act?.kind === "drag") draw.pointed = null;
    if (act?.kind === "pan" && act.clear) draw.pick(null);
    else if (act?.kind === "drag" && act.moved) this.release(act);
    else if (act?.kind === "box") draw.pickBox(act.start, place);
    else if (act?.kind === "ask") draw.task.end(act);
    else if (act?.kind === "node" && act.from) this.drawNode(act.from);
    else if (act?.kind === "bar" && act.from) this.drawBar(act, place, event.pointerType === "touch");
    draw.canvas.rubber();
  }

  /** The end of a drag; of one that has moved nothing, why. */
  release({ node, from }) {
    const { draw } = this;
    if (draw.tool === "move") {
      draw.dragged().then(() => {
        if (draw.at(node).every((value, k) => value === from[node][k])) draw.tell(draw.held(node), true);
      });
    } else draw.dragged();
  }

  cancel(event) {
    clearTimeout(this.long);
    this.pointers.delete(event.pointerId);
    this.act = null;
    this.draw.rubber = null;
    this.draw.canvas.rubber();
  }

  drawNode(target) {
    const { draw } = this;
    if (target.node) draw.pick({ type: "node", name: target.node });
    else draw.edit({ do: "add", at: draw.cut(target.point) });
  }

  /** From press to release, or from click to click. */
  drawBar(act, place, touch) {
    const moved = Math.hypot(place[0] - act.start[0], place[1] - act.start[1]) > SLACK;
    if (moved) {
      this.pending = null;
      const to = this.target(place, touch);
      if (to) this.join(act.from, to);
    } else this.clickBar(act.from);
  }

  async clickBar(target) {
    const { draw } = this;
    if (!this.pending) {
      let { node } = target;
      if (node) draw.pick({ type: "node", name: node }); // its fields are at hand
      else node = (await draw.edit({ do: "add", at: draw.cut(target.point) })).made?.node;
      this.pending = node ? { node, point: draw.at(node) } : null;
      return;
    }
    const from = this.pending;
    this.pending = null;
    await this.join(from, target);
  }

  async join(from, to) {
    const { draw } = this;
    const start = from.node || (await draw.edit({ do: "add", at: draw.cut(from.point) })).made?.node;
    if (!start) return;
    if (start === to.node) return draw.tell("A bar needs two different places.", true);
    const there = draw.state.members.find(({ ends }) => ends.includes(start) && ends.includes(to.node));
    if (there) {
      draw.pick({ type: "member", name: there.name });
      draw.tell(`${there.name} joins ${start} and ${to.node} already. It is picked now.`, true);
      return;
    }
    if (to.node) await draw.edit({ do: "bar", ends: [start, to.node] });
    else await draw.edit({ do: "add", at: draw.cut(to.point), bar_from: start });
  }

  // -- what a tool is given -----------------------------------------------------------------------------------------

  /** The tool that is used, if it is one of those that are given places and things. */
  get using() {
    const tool = TOOLS.get(this.draw.tool);
    return tool?.takes ? tool : null;
  }

  /** Whether the tool changes the drawing: that begins in the pose that is drawn. */
  get draws() {
    return !HANDS[this.draw.tool] && !this.using?.measures;
  }

  /** Whether a click with what is given is enough, though the tool would take more of a pull. */
  get enough() {
    return this.given.length === 1 && Boolean(this.using.more?.(this.given[0]));
  }

  /** What is at a place of the screen. */
  there(place, touch) {
    const { draw } = this, hit = draw.canvas.hit(place, touch);
    if (hit?.type === "node") return { node: hit.name, point: draw.at(hit.name) };
    return { ...(hit ? { member: hit.name, share: draw.canvas.shareOf(hit.name, place) } : {}), point: hit ? draw.canvas.pointOf(hit.name, place) : draw.camera.unproject(place) };
  }

  /** What the tool wants next at a place; null, and a word about it, if that is not there. */
  wanted(place, touch, quiet = false) {
    const { draw, using } = this, kind = using.takes(this.given, draw);
    if (kind === "place") return this.target(place, touch);
    if (kind === "tip") {
      const point = draw.camera.unproject(place, this.given[0].point[draw.camera.plane.axis] || 0);
      if (!point && !quiet) draw.tell(EDGE, true);
      return point && { point };
    }
    const found = kind === "member" ? this.memberAt(place, touch) : this.there(place, touch);
    if (found && (kind === "thing" ? found.node || found.member : found[kind])) return found;
    if (!quiet) draw.tell(`${using.words}: ${{ node: "a node", member: "a bar, beam or link", thing: "a node or a bar" }[kind]} is wanted here. ${using.about}.`, true);
    return null;
  }

  /** A member, also where a node is near: beside that node. */
  memberAt(place, touch) {
    const hit = this.draw.canvas.hit(place, touch, () => false);
    return hit && { member: hit.name, share: this.draw.canvas.shareOf(hit.name, place), point: this.draw.canvas.pointOf(hit.name, place) };
  }

  /** Give something to the tool; true if there was something. */
  give(target) {
    if (!target) return false;
    this.given = [...this.given, target];
    return true;
  }

  /** What is drawn with the pointer at a place. */
  show(place, touch) {
    const { draw, using } = this;
    const to = using.takes(this.given, draw) ? this.wanted(place, touch, true) : null;
    draw.rubber = { parts: using.shows?.(draw, this.given, to) || [], to: to?.point || null };
    draw.canvas.rubber();
  }

  /** The release: a pull gives what is there too, a click waits for the next one if the tool needs it. */
  released(act, place, touch) {
    const { draw, using } = this, moved = Math.hypot(place[0] - act.start[0], place[1] - act.start[1]) > SLACK;
    if (moved && using.takes(this.given, draw)) this.give(this.wanted(place, touch, this.enough));
    this.finish();
    draw.canvas.rubber();
  }

  /** Do it once all is given. more : of what a click is enough for, the rest is still to come. */
  finish(more = false) {
    const { draw, using } = this;
    if (!using || !this.given.length) return;
    if (using.takes(this.given, draw) && (more || !this.enough)) {
      const words = using.next?.(this.given);
      if (words) draw.tell(words);
      return;
    }
    const { given, before } = this;
    this.given = [];
    draw.rubber = null;
    draw.tell("");
    using.act(draw, given).then((value) => value && draw.value.ask(value));
    if (before) draw.setTool(before);
  }

  /** A tool of the menu, begun at what is there; afterwards the one before goes on. */
  once(tool, target) {
    const { draw } = this, before = draw.tool;
    if (!target.point) return draw.tell(EDGE, true);
    draw.setTool(tool.name);
    if (!tool.takes) {
      if (tool.name === "node") this.drawNode({ node: target.node, point: draw.snapped(target.point) });
      else return this.clickBar({ node: target.node, point: target.node ? target.point : draw.snapped(target.point) });
      return draw.setTool(before);
    }
    this.before = before;
    const snapped = tool.takes([], draw) === "place" && !target.node ? { point: draw.snapped(target.point) } : target;
    this.given = [snapped];
    if (tool.takes(this.given, draw) && !this.enough) draw.tell(`${tool.about}.`);
    this.finish();
  }

  /** A finger has rested: the menu, in place of what it had begun. */
  pressed(place) {
    const { draw } = this;
    this.cancelAct();
    this.act = null;
    this.pointers.clear();
    draw.menu.open(place, this.there(place, true));
  }

  // -- two fingers -------------------------------------------------------------------------------------------------

  pinch() {
    this.cancelAct();
    this.act = { kind: "pinch", last: [...this.pointers.values()] };
  }

  cancelAct() {
    this.draw.rubber = null;
    this.pending = null;
    this.given = [];
    this.before = null;
  }

  pinched() {
    const { draw, act } = this, now = [...this.pointers.values()];
    if (now.length < 2) return;
    const middle = (pair) => [(pair[0][0] + pair[1][0]) / 2, (pair[0][1] + pair[1][1]) / 2];
    const apart = (pair) => Math.hypot(pair[0][0] - pair[1][0], pair[0][1] - pair[1][1]);
    const [a, b] = [middle(act.last), middle(now)];
    draw.camera.pan(b[0] - a[0], b[1] - a[1]);
    draw.camera.zoom(apart(now) / (apart(act.last) || 1), b);
    act.last = now.map((one) => [...one]);
    draw.canvas.update();
  }

  // -- keys --------------------------------------------------------------------------------------------------------

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
    const way = FEW_KEYS[event.key];
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
      this.setCursor(camera.snapped(next));
      if (this.using && this.given.length) this.show(camera.project(draw.cursor));
      const hit = draw.canvas.hit(camera.project(draw.cursor));
      draw.say(`${hit ? `${hit.type} ${hit.name}, ` : ""}${draw.cut(draw.cursor).join(", ")} m`);
    } else if (LIFT[event.key] && camera.dim === 3) {
      event.preventDefault();
      this.lift(LIFT[event.key] * (event.shiftKey ? 10 : 1));
    } else if (event.key === "Enter" && draw.cursor) {
      event.preventDefault();
      this.enter(event);
    } else if (event.key === "Escape") {
      event.preventDefault();
      this.escape();
    }
  }

  /** The work plane, and the cursor in it, go on along its normal by steps of the grid. */
  lift(steps) {
    const { draw } = this, { axis, at } = draw.camera.plane, to = clean(at + steps * draw.camera.grid);
    draw.rail.setPlane({ at: to });
    if (draw.cursor) this.setCursor(draw.cursor.map((value, k) => (k === axis ? to : value)));
    draw.say(`work plane at ${"xyz"[axis]} = ${to} m`);
  }

  /** A node in the hand of the keys goes on by a quarter of a step of the grid (Shift: a whole one). */
  nudge(way, whole) {
    const { draw } = this, { camera } = draw, { node, number } = this.grabbed;
    if (draw.play.away) return this.back();
    const to = [...((draw.waiting && this.grabbed.to) || draw.at(node))]; // pressed again before the answer: further
    camera.across.forEach((axis, k) => (to[axis] = clean(to[axis] + (way[k] * camera.grid) / (whole ? 1 : 4))));
    draw.drag({ [node]: draw.cut(to) }, number, true);
    Object.assign(this.grabbed, { to, moved: true });
  }

  /** Take a node into the hand of the keys, or let it go. */
  grab(node) {
    const { draw } = this, before = this.grabbed;
    this.grabbed = node ? { node, number: stroke() } : null;
    if (before?.moved) draw.dragged();
    if (node) draw.say(`${node} is in your hand: arrows move it, all lengths are kept; Enter lets it go`);
    this.point(node ? { name: node, at: draw.at(node) } : null);
  }

  /** Nothing begun, no cursor, nothing picked. */
  escape() {
    if (this.grabbed) return this.grab(null);
    if (this.draw.play.away) return this.draw.play.home();
    const { before } = this;
    if (before) this.draw.setTool(before);
    this.cancelAct();
    this.setCursor(null);
    this.draw.pick(null);
  }

  /** The menu of keys: at the cursor, else at what is picked, else in the middle. */
  ask() {
    const { draw } = this, { camera, picked } = draw, [node] = picked.nodes, [member] = picked.members;
    const ends = member && draw.state.members.find(({ name }) => name === member).ends.map((end) => draw.at(end));
    const at = draw.cursor || (node ? draw.at(node) : ends ? ends[0].map((value, k) => (value + ends[1][k]) / 2) : camera.unproject([camera.width / 2, camera.height / 2]) || camera.centre);
    const place = camera.project(at), own = !draw.cursor && (node || member);
    draw.menu.open(place, !own ? this.there(place) : node ? { node, point: at } : { member, share: 0.5, point: at });
  }

  enter(event) {
    const { draw } = this;
    const place = draw.camera.project(draw.cursor);
    const hit = draw.canvas.hit(place);
    const target = hit?.type === "node" ? { node: hit.name, point: draw.at(hit.name) } : { point: draw.cursor };
    if (this.draws && draw.play.away) return this.back();
    if (this.using) {
      if (this.give(this.wanted(place))) this.finish(event.shiftKey);
    } else if (draw.tool === "node") this.drawNode(target);
    else if (draw.tool === "bar") this.clickBar(target);
    else if (draw.task.takes(draw.tool)) draw.task.enter(draw.tool, target.point);
    else if (draw.tool === "move" && this.grabbed) this.grab(null);
    else if (draw.tool === "move" && target.node) {
      draw.pick(hit);
      this.grab(target.node);
    } else if (event.shiftKey && hit) draw.toggle(hit);
    else draw.pick(hit);
  }
}
