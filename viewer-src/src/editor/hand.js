// What the pointer does in the drawing: pick and move, pan, turn and approach, the menu; and what tools are given, also by keys (keyboard.js).

import { clean } from "./camera.js";
import { HANDS } from "./measures.js";
import { TOOLS } from "./tools/index.js";

const EDGE = "The work plane is seen edge-on. Turn the view, or choose another plane.";
const SLACK = 4; // pixels that a click may move
const LONG = 550; // ms after which the press of a finger is long

/** The number of a drag: its moves are one step of undo. */
export const stroke = () => Math.floor(Math.random() * 2 ** 50);

export class Hand {
  constructor(draw) {
    Object.assign(this, { draw, given: [], before: null, doing: Promise.resolve() });
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
    node.addEventListener("contextmenu", (event) => event.preventDefault()); // a press without moving opens it
    node.addEventListener("blur", ({ relatedTarget: to }) => !draw.value.node.contains(to) && this.leave());
    node.addEventListener("touchend", (event) => this.rested && event.preventDefault()); // no click follows, which would close the menu
    node.addEventListener("pointerleave", () => this.point(null));
  }

  place(event) {
    const box = this.draw.canvas.node.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  /** Node or free point at a place: {node} or {point}; null where the plane is seen edge-on. */
  target(place, touch, allowed) {
    const { draw } = this;
    const hit = draw.canvas.hit(place, touch, allowed);
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
    const { draw } = this, place = this.place(event), touch = (this.touch = event.pointerType === "touch");
    draw.canvas.node.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, place);
    draw.canvas.node.focus({ preventScroll: true });
    draw.keyboard.setCursor(null);
    draw.menu.close();
    draw.value.close(true);
    clearTimeout(this.long);
    if (this.pointers.size === 2) return this.pinch();
    this.rested = false;
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
    else this.act = this.give(this.wanted(place, touch)) ? { kind: "give", start: place, touch } : null;
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
    const far = act?.start && Math.hypot(place[0] - act.start[0], place[1] - act.start[1]) > SLACK;
    if (far) clearTimeout(this.long);
    if (!act) return this.hover(place);
    if (act.kind === "give") {
      if (far && this.using.chain) this.given = this.given.slice(-1); // a pull stands alone
      return this.show(place, act.touch);
    }
    if (act.kind === "pan" || act.kind === "turn") {
      const [dx, dy] = [place[0] - act.last[0], place[1] - act.last[1]];
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
  }

  hover(place) {
    const { draw } = this;
    if (draw.closed) return;
    const hit = draw.canvas.hit(place);
    draw.canvas.near(hit);
    if (this.using) return this.show(place);
    if (HANDS[draw.tool]) return this.point(hit?.type === "node" ? { name: hit.name, at: draw.at(hit.name) } : null);
    draw.rubber = { to: this.target(place)?.point };
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
    if (act?.kind === "give") return this.released(act, place);
    if (act?.kind === "drag") draw.pointed = null;
    if (act?.kind === "pan" && act.clear) draw.pick(null);
    else if (act?.kind === "drag" && act.moved) this.release(act);
    else if (act?.kind === "box") draw.pickBox(act.start, place);
    else if (act?.kind === "ask") draw.task.end(act);
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
    if (kind === "spot") return this.target(place, touch, (name) => draw.inPlane(name));
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

  /** A place as it is now: the node that has been made there meanwhile, or that has moved. */
  now(given) {
    const { draw } = this, node = given.member ? undefined : draw.state.nodes.includes(given.node) ? given.node : draw.nodeAt(given.point);
    return node === undefined ? { ...given, node } : { ...given, node, point: draw.at(node) };
  }

  /** What is drawn with the pointer at a place. */
  show(place, touch) {
    const { draw, using } = this, given = this.given.map((one) => this.now(one));
    const to = using.takes(given, draw) ? this.wanted(place, touch, true) : null;
    draw.rubber = { parts: using.shows?.(draw, given, to) || [], from: using.shows ? null : given.at(-1)?.point, to: to?.point || null };
    draw.canvas.rubber();
  }

  /** The release: a pull gives what is there too, a click waits for the next one if the tool needs it. */
  released({ start, touch }, place) {
    const { draw, using } = this, pulled = Math.hypot(place[0] - start[0], place[1] - start[1]) > SLACK;
    if (pulled && using.takes(this.given, draw)) this.give(this.wanted(place, touch, this.enough));
    this.finish({ pulled });
    draw.canvas.rubber();
  }

  /** Do it once all is given, after what was given before; of a node that is not enough the fields are at hand.
   * pulled : from press to release. more : of what a click is enough for, the rest is still to come. */
  finish({ pulled = false, more = false } = {}) {
    const { draw, using, given, before } = this;
    if (!using || !given.length) return;
    if (using.takes(given, draw) && (more || !this.enough)) {
      const words = using.next?.(given);
      if (given.at(-1).node) draw.pick({ type: "node", name: given.at(-1).node });
      if (words) draw.tell(words);
      return;
    }
    const [start, end] = given.map((one) => this.now(one).point), ends = using.chain && end.every((value, k) => value === start[k]);
    this.given = using.chain && !pulled && !before && !ends ? given.slice(-1) : [];
    draw.rubber = null;
    draw.tell(ends ? `${using.words}: ended. Another one needs two different places.` : "");
    if (!ends) this.doing = this.doing.catch(() => {}).then(() => this.do(using, given));
    if (before) draw.setTool(before);
  }

  async do(tool, given) {
    const { draw } = this, value = await tool.act(draw, given.map((one) => this.now(one)));
    this.given = this.given.map((one) => this.now(one)); // the node that was made, wherever it goes
    if (value && !this.act) draw.value.ask(value);
  }

  /** A tool of the menu, begun at what is there; afterwards the one before goes on. */
  once(tool, target) {
    const { draw } = this, before = draw.tool;
    if (!target.point) return draw.tell(EDGE, true);
    draw.setTool(tool.name);
    this.before = before;
    const snapped = ["place", "spot"].includes(tool.takes([], draw)) && !target.node ? { point: draw.snapped(target.point) } : target;
    this.given = [snapped];
    if (tool.takes(this.given, draw) && !this.enough) draw.tell(`${tool.about}.`);
    this.finish();
  }

  /** A finger has rested: the menu, in place of what it had begun. */
  pressed(place) {
    const { draw } = this;
    this.cancelAct();
    this.act = null;
    this.rested = true;
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
    this.given = [];
    this.before = null;
  }

  /** The drawing is left for another part of the page. */
  leave() {
    this.cancelAct();
    this.draw.keyboard.setCursor(null);
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
}
