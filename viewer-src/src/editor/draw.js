// The drawing page: what the studio says of the drawing, and what is picked.

import { el } from "../dom.js";
import { Talk } from "../talk.js";
import { Ask } from "./ask.js";
import { Camera } from "./camera.js";
import { Canvas } from "./canvas.js";
import { Curves } from "./curves.js";
import { Diagram } from "./diagram.js";
import style from "./editor.css";
import { Entries } from "./entries.js";
import { Files } from "./files.js";
import { Groups } from "./groups.js";
import { Hand } from "./hand.js";
import { HANDS } from "./measures.js";
import { Keyboard } from "./keyboard.js";
import { Menu } from "./menu.js";
import { Picture } from "./picture.js";
import { Play } from "./play.js";
import { Properties } from "./properties.js";
import { Readout } from "./readout.js";
import { Starters } from "./starters.js";
import { Status } from "./status.js";
import { Sweep } from "./sweep.js";
import { Take } from "./take.js";
import { Text } from "./text.js";
import { ToolRail } from "./rail.js";
import { Value } from "./value.js";
import { Welcome } from "./welcome.js";
import { Whole } from "./whole.js";

const OFTEN = 6; // moves of a drag after which the curve may follow
const QUIET = new Set(["running"]); // asked again and again, beside what is drawn
/** Parts of the page by the names under which they know each other. */
const PARTS = {
  picture: Picture, curves: Curves, diagram: Diagram, readout: Readout, play: Play, welcome: Welcome, canvas: Canvas, status: Status, properties: Properties, whole: Whole, groups: Groups,
  text: Text, entries: Entries, files: Files, task: Ask, starters: Starters, takeAway: Take, menu: Menu, value: Value, rail: ToolRail, tools: Hand, keyboard: Keyboard,
};
// what does not change the drawing; while anything else is computed, nothing is shown of the state before
const ASIDE = { curve: "Computing the path ...", over: "Computing the diagram ...", sweep: "Computing the motion ...", let_go: "Computing the motion ...", run: "Starting the run ...", stop: "Stopping the run ...", ask: "Looking for linkages ...", starters: "Drawing the pictures ...", take: "Making the file ...", save: "Saving ...", keep: "Saving ...", versions: "Reading the versions ...", picture: "Saving the picture ...", dimension: "Saving the dimension ..." };

export function startDraw(root) {
  const sheet = document.createElement("style");
  sheet.textContent = style;
  document.head.append(sheet);
  const draw = new Draw(root);
  window.kinetruss.draw = draw;
  draw.connect();
}

export class Draw extends Talk {
  constructor(root) {
    super(root);
    Object.assign(this, { state: null, tool: "bar", snap: true, closed: true, cursor: null, rubber: null, pointed: null, gripped: new Set(), several: false, moves: 0, stale: false });
    this.picked = { nodes: new Set(), members: new Set() };
    this.shown = { names: true, force: true, strength: false, lengths: false };
    this.theme = root.dataset.theme || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
    root.dataset.theme = this.theme;
    this.camera = new Camera();
    this.banner = el("p", { class: "banner", role: "status", hidden: true });
    this.spoken = el("p", { class: "spoken", role: "status", "aria-live": "polite" });
    for (const [name, Part] of Object.entries(PARTS)) this[name] = new Part(this);
    const panel = el("aside", { class: "controls sketch", "aria-label": "drawing" }, el("div", { class: "head" }, this.banner, this.files.offer, this.status.node), el("div", { class: "parts" }, this.status.details, this.properties.node, this.whole.node,
      this.properties.freshNode, this.entries.runsNode, this.starters.node, this.task.node, this.entries.node, this.groups.node, this.curves.node, this.picture.node, this.text.node, this.takeAway.node, this.files.node));
    root.replaceChildren(this.rail.node, el("main", {}, el("div", { class: "sheet" }, el("div", { class: "sheetpane" }, this.canvas.node, this.welcome.node, this.starters.strip, this.canvas.legend, this.diagram.told, this.doing, this.readout.node, this.spoken, this.value.node, this.menu.node), this.play.node), panel));
    root.ownerDocument.addEventListener("keydown", (event) => this.rail.key(event));
  }

  // -- asking ------------------------------------------------------------------------------------------------------

  get there() {
    return this.state;
  }

  /** Whatever changes the drawing begins at the pose that is drawn. */
  ask(command, since) {
    if (!(command.do in ASIDE) && !QUIET.has(command.do)) {
      this.play.going ||= this.play.playing && command.do !== "put";
      this.play.home();
    }
    return super.ask(command, since);
  }

  /** An edit: what it made is picked. */
  async edit(command) {
    const answer = await this.ask(command);
    const { made } = answer;
    if (made?.member) this.pick({ type: "member", name: made.member });
    else if (made?.node) this.pick({ type: "node", name: made.node });
    if (made?.entry && !made.member) this.entries.show(made.entry);
    if (made?.lost?.length) this.tell(`Removed with it: ${made.lost.join(", ")}.`);
    return answer;
  }

  /** What a tool has drawn, in one step: values at paths of the model; `pick` is picked then. False if the model refuses it. */
  async change(words, changes, pick) {
    const answer = await this.edit({ do: "change", changes, words });
    if (answer.kind !== "drawing") return false;
    if (pick) this.pick(pick);
    return true;
  }

  /** A new part from what is picked. */
  make(what) {
    return this.edit({ do: "make", what, axis: "xyz"[this.camera.plane.axis], nodes: [...this.picked.nodes], members: [...this.picked.members] });
  }

  /** Nodes to new places while they are dragged; of many wishes only the last counts. */
  drag(places, number, keep = false) {
    this.wanted = { do: "move", places, drag: number, keep };
    this.gripped = new Set(Object.keys(places));
    this.pump();
  }

  /** The drag has ended: everything is computed and kept. */
  dragged() {
    this.gripped = new Set();
    return this.ask({ do: "show" });
  }

  /** Why a node that was dragged with all lengths kept has not moved. */
  held(node) {
    const { fixed, mobility } = this.state;
    if (fixed[node]) return `${node} is held. Free it in the panel, or drag another node.`;
    const stands = mobility && !mobility.freedoms ? "All lengths are kept, and nothing can move. " : "Nothing moves that way with all lengths kept. ";
    return `${stands}Pick (V) drags a node and changes the lengths.`;
  }

  /** A drag goes first; a path that is shown follows it now and then. */
  hurried() {
    const command = this.wanted;
    if (!command || (this.curves.stale && this.moves >= OFTEN)) return null;
    this.moves++;
    this.wanted = null;
    return { command };
  }

  leisurely() {
    if (this.diagram.stale && !this.play.playing) return { command: this.diagram.command() };
    if (!this.curves.stale) return null;
    this.moves = 0;
    return { command: this.curves.command() };
  }

  /** Say what is awaited, once that takes long. */
  watch() {
    if (!this.state) return;
    const awaited = [this.waiting, ...this.queue].filter((one) => one && !QUIET.has(one.command.do));
    const edit = awaited.find(({ command }) => !(command.do in ASIDE)), [first] = edit ? [edit] : awaited;
    this.changing = Boolean(edit);
    if (first) this.busy.wait(ASIDE[first.command.do] || "Computing ...", first.since);
    else this.busy.end();
  }

  /** What is computed; the state before an edit is not shown as if it were the answer to it. */
  showBusy(words) {
    const stale = Boolean(words && this.changing && this.state);
    if (words && this.doing.hidden) this.say(words);
    super.showBusy(words);
    this.status.wait(stale ? words : "");
    if (stale === this.stale) return;
    this.stale = stale;
    this.root.classList.toggle("stale", stale);
    this.canvas.update();
  }

  // -- hearing -----------------------------------------------------------------------------------------------------

  unpacked(buffer) {
    return new Sweep(buffer);
  }

  heard(answer) {
    if (answer.kind === "drawing") this.take(answer);
    else if (answer.kind === "moved") this.place(answer);
    else if (answer.kind === "over") this.diagram.take(answer);
    else if (answer.kind === "curve") this.curves.take(answer);
    else if (answer.kind === "error" && this.waiting?.command !== this.play.rate.trying) this.refuse(answer.message); // of a rate it is said beside it
    return answer.other || answer.choices;
  }

  /** A value that is not taken: every field shows again what holds. */
  refuse(message) {
    this.play.going = false;
    this.curves.failed(message, this.waiting);
    this.tell(message, true);
    for (const part of [this.properties, this.whole, this.entries]) part.rebuild();
  }

  take(answer) {
    const first = !this.state, dim = this.state?.dim, emptied = Boolean(this.state?.nodes.length) && !answer.nodes.length;
    let running = null;
    if (answer.choices) {
      this.choices = answer.choices;
      this.files.setOffer(answer.offer);
      this.picture.take(answer.picture);
      running = answer.running;
    }
    this.state = answer;
    this.camera.setDim(answer.dim);
    this.keepPicked(answer.made?.renamed);
    if (!answer.other && !first) this.tell(answer.saved || "");
    this.diagram.spoil();
    this.canvas.rebuild();
    if (first || emptied || answer.dim !== dim) this.fit();
    this.curves.spoil();
    for (const part of [this.rail, this.welcome, this.status, this.properties, this.whole, this.groups, this.entries, this.curves, this.diagram, this.text, this.files, this.starters, this.task, this.takeAway]) part.rebuild();
    this.play.spoil();
    if (running) this.entries.take(running);
    window.kinetruss.ready = true;
    this.root.dataset.state = "ready";
  }

  place(answer) {
    Object.assign(this.state, answer, { kind: "drawing" });
    this.diagram.spoil();
    this.play.spoil();
    this.canvas.update();
    this.curves.spoil();
    this.status.rebuild();
    this.properties.follow();
  }

  keepPicked(renamed) {
    if (renamed) {
      for (const set of Object.values(this.picked)) if (set.delete(renamed[0])) set.add(renamed[1]);
    }
    const names = { nodes: new Set(this.state.nodes), members: new Set(this.state.members.map(({ name }) => name)) };
    for (const [type, set] of Object.entries(this.picked)) for (const name of set) if (!names[type].has(name)) set.delete(name);
  }

  // -- picking -----------------------------------------------------------------------------------------------------

  at(name) {
    const place = this.state.places[this.state.nodes.indexOf(name)];
    return [place[0], place[1], place[2] || 0];
  }

  /** A point on the grid or in line with other nodes, where that is chosen. */
  snapped(point, except = new Set()) {
    if (!this.snap) return point;
    return this.camera.snapped(point, this.state.places.filter((_, k) => !except.has(this.state.nodes[k])));
  }

  /** The node at a point, to less than a pixel. */
  nodeAt(point) {
    const { places, nodes } = this.state;
    return nodes[places.findIndex((place) => point.every((value, k) => Math.abs(value - (place[k] || 0)) * this.camera.scale < 0.5))];
  }

  /** Whether a node lies in the work plane. */
  inPlane(name) {
    const { axis, at } = this.camera.plane;
    return Math.abs(this.at(name)[axis] - at) * this.camera.scale < 1;
  }

  /** As many coordinates as the drawing has. */
  cut(point) {
    return point.slice(0, this.camera.dim);
  }

  isPicked({ type, name }) {
    return this.picked[`${type}s`].has(name);
  }

  pick(hit) {
    this.picked.nodes.clear();
    this.picked.members.clear();
    if (hit) this.picked[`${hit.type}s`].add(hit.name);
    this.repick();
  }

  toggle({ type, name }) {
    const set = this.picked[`${type}s`];
    if (!set.delete(name)) set.add(name);
    this.repick();
  }

  pickAll() {
    this.state.nodes.forEach((name) => this.picked.nodes.add(name));
    this.state.members.forEach(({ name }) => this.picked.members.add(name));
    this.repick();
  }

  pickBox(a, b) {
    const inside = ([x, y]) => (x - a[0]) * (x - b[0]) <= 0 && (y - a[1]) * (y - b[1]) <= 0;
    this.state.nodes.forEach((name, k) => inside(this.canvas.seen[k]) && this.picked.nodes.add(name));
    this.state.members.forEach(({ name, ends }) => ends.every((end) => this.picked.nodes.has(end)) && this.picked.members.add(name));
    this.repick();
  }

  repick() {
    this.canvas.update();
    for (const part of [this.rail, this.properties, this.groups, this.curves]) part.rebuild();
    this.say([...this.picked.nodes, ...this.picked.members].join(", ") || "nothing picked");
  }

  remove() {
    const nodes = [...this.picked.nodes], members = [...this.picked.members];
    if (nodes.length || members.length) this.edit({ do: "delete", nodes, members });
  }

  /** Show all if something is out of sight: after edits that are typed, not drawn. */
  reveal() {
    const { width, height } = this.camera;
    if (this.canvas.seen.some(([x, y]) => x < 0 || y < 0 || x > width || y > height)) this.fit();
  }

  fit() {
    this.camera.fit(this.state.places);
    this.canvas.update();
  }

  setTool(tool) {
    if (this.task.takes(tool) && this.state?.dim === 3) return this.tell("Linkages are asked for in the plane. Begin a planar drawing: Draw in the plane, in the panel of an empty drawing.", true);
    this.tool = tool;
    if (!HANDS[tool]) this.several = false;
    this.keyboard.grabbed = null;
    this.canvas.node.dataset.tool = tool;
    this.tools.cancelAct();
    this.canvas.rubber();
    this.rail.rebuild();
    this.task.rebuild();
    this.starters.rebuild();
  }

  toggleTheme() {
    this.theme = this.theme === "dark" ? "light" : "dark";
    this.root.dataset.theme = this.theme;
    this.play.curve();
  }

  // -- words -------------------------------------------------------------------------------------------------------

  tell(words, warning = false) {
    this.banner.hidden = !words;
    this.banner.textContent = words;
    this.banner.classList.toggle("warning", warning);
  }

  say(words) {
    this.spoken.textContent = words;
  }

  // -- the server --------------------------------------------------------------------------------------------------

  open(post) {
    this.post = post;
    this.closed = false;
    this.setEnded(false);
    if (this.state) this.tell("The studio answers again.");
    else this.busy.wait("Opening ...", performance.now());
  }

  close() {
    super.close();
    if (this.state) this.tell("The studio has ended. The drawing stays as it was last confirmed and cannot be changed. It is kept beside its file: start the studio again in the same folder, and this page goes on with it.", true);
  }
}
