// The state of the page, and what can be done with it. Buttons, keys and tests all call these methods.

import { limitsOf } from "./colour.js";
import { el } from "./dom.js";
import { FlatView } from "./flat.js";
import { number, quantity } from "./format.js";
import { diagramsOf, Inspector } from "./inspector.js";
import { helpPage, listen } from "./keys.js";
import { Legend } from "./legend.js";
import { freeBodyOf } from "./mechanics.js";
import { Names } from "./names.js";
import { legendBoxes, Over, unknownOf } from "./over.js";
import { Player } from "./player.js";
import { Table } from "./table.js";
import { TimeBar } from "./timebar.js";
import { ToolBar } from "./toolbar.js";
import { movingNodes } from "./traces.js";
import { Verdict } from "./verdict.js";
import { hasWebGL, View } from "./view.js";

const MARGIN = 24; // CSS pixels at the rim of a picture in which no diagram ends
const SWING = 0.08; // amplitude of a mode, of the size of the structure

/** Whether a structure is one of bodies only: no member has a section, and rigid bars form triangles. */
function bodily(scene) {
  return scene.header.triangles.length > 0 && scene.arrays.radius.data.every(Number.isNaN);
}

export class App extends Player {
  /** side: an element that stands left of the picture. */
  constructor(root, scenes, labels = [], side = null) {
    super();
    Object.assign(this, { root, side, ended: new AbortController() });
    Object.assign(this, { channel: null, limits: [0, 1], picked: null, mode: -1, labels });
    this.shown = { ghost: false, names: scenes[0].nodes.length <= 12, loads: true, supports: true, grid: true, faces: scenes.every(bodily), paths: false };
    this.paths = new Set(); // names of nodes whose path is shown by itself
    this.touch = matchMedia("(hover: none)").matches;
    this.theme = root.dataset.theme || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
    root.dataset.theme = this.theme;
    this.setLead(scenes.reduce((best, one) => (one.time[one.frames - 1] > best.time[best.frames - 1] ? one : best)));
    const canvases = scenes.map((scene, k) => el("canvas", { tabindex: 0, role: "img", "aria-label": `picture of ${labels[k] || scene.header.title || "the model"}` }));
    this.diagram = null;
    this.offered = [...new Map(scenes.flatMap((scene) => scene.header.shows || []).map((one) => [one.id, one])).values()];
    this.flat = !hasWebGL();
    const Kind = this.flat ? FlatView : View;
    this.views = scenes.map((scene, k) => new Kind(canvases[k], scene, this.theme));
    this.layout(canvases);
    this.wire();
    listen(this, root.ownerDocument, this.ended.signal);
    this.setChannel(scenes[0].header.channels[0]?.id || "");
    this.table.show();
    this.pick(null);
    this.apply();
    this.goTo(0);
  }

  /** Words of a title with the key that does the same; on a touch screen there are no keys. */
  hint(words, key) {
    return this.touch ? words : `${words} (${key})`;
  }

  layout(canvases) {
    const { views } = this;
    this.bar = new ToolBar(this);
    this.verdict = new Verdict(this);
    this.time = new TimeBar(this);
    this.legend = new Legend(this);
    this.inspector = new Inspector(this);
    this.table = new Table(this);
    this.names = views.map((view) => new Names(view));
    this.over = views.map((view) => new Over(view));
    const panes = canvases.map((canvas, k) => el("div", { class: "pane" }, canvas, this.over[k].node, this.names[k].node,
      views.length > 1 ? el("div", { class: "label" }, this.labels[k]) : null,
      el("div", { class: "scale" }, `grid ${quantity(views[k].step, "m")}`)));
    this.told = el("p", { class: "told", role: "note", "aria-live": "polite" });
    this.panel = el("aside", { class: "panel" }, this.inspector.node, this.table.node);
    this.stage = el("div", { class: "stage" }, el("div", { class: "panes" }, panes), this.legend.node,
      el("div", { class: "said" }, this.flat ? el("p", { class: "note" }, "This browser has no WebGL: a plain picture, turned by the buttons.") : null, this.told));
    this.help = helpPage(this);
    this.root.replaceChildren(this.bar.node, this.verdict.node, el("main", {}, this.side, this.stage, this.panel), this.time.node, this.help);
  }

  wire() {
    const watch = new ResizeObserver(() => this.resize());
    this.ended.signal.addEventListener("abort", () => watch.disconnect());
    this.views.forEach((view, k) => {
      watch.observe(view.canvas.parentElement);
      view.onCamera = () => this.follow(view);
      view.onDrawn = () => {
        this.over[k].place(this.diagram);
        this.names[k].place(this.shown.names, this.over[k].boxes);
      };
      let down = null;
      view.canvas.addEventListener("pointerdown", (event) => (down = [event.clientX, event.clientY]));
      view.canvas.addEventListener("pointerup", (event) => {
        if (down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < 5) this.click(view, event);
        down = null;
      });
    });
    this.resize();
  }

  /** The numbers of the scenes changed in place: draw and tell them anew. */
  refresh() {
    for (const view of this.views) view.scene.renew();
    this.verdict.update();
    const { channel } = this;
    if (channel) {
      const limits = limitsOf(channel.scale, this.views.map((view) => view.scene.range(channel.id)));
      if (limits.some((value, k) => value !== this.limits[k])) this.setChannel(channel.id);
    }
    this.goTo(this.index);
  }

  /** Let go of everything: another app takes the page. */
  end() {
    this.playing = false;
    this.mode = -1;
    this.ended.abort();
    for (const view of this.views) view.end();
  }

  resize() {
    this.views.forEach((view) => view.resize());
    this.inspector.update();
  }

  // -- time --------------------------------------------------------------------------------------------------------

  goTo(index) {
    this.index = Math.min(Math.max(Math.round(index), 0), this.lead.frames - 1);
    const time = this.lead.time[this.index];
    for (const view of this.views) view.setFrame(view.scene === this.lead ? this.index : view.scene.frameAt(time));
    this.time.update();
    this.inspector.update();
    this.table.update();
  }

  toWorst() {
    const { lead, channel } = this;
    if (!channel || !lead.channel(channel.id)) return;
    let best = [-1, 0];
    for (let k = 0; k < lead.frames; k++) {
      for (let m = 0; m < lead.members.length; m++) {
        const size = Math.abs(lead.value(channel.id, k, m));
        if (size > best[0]) best = [size, k];
      }
      for (let face = 0; lead.coloursFaces(channel.id) && face < lead.faces; face++) {
        const size = lead.faceValue(channel.id, k, face);
        if (size > best[0]) best = [size, k];
      }
    }
    this.pause();
    this.goTo(best[1]);
  }

  // -- what is shown -----------------------------------------------------------------------------------------------

  setChannel(id) {
    const scenes = this.views.map((view) => view.scene).filter((scene) => scene.channel(id));
    this.channel = scenes.length ? scenes[0].channel(id) : null;
    if (this.channel) this.limits = limitsOf(this.channel.scale, scenes.map((scene) => scene.range(id)));
    for (const view of this.views) view.setColours(this.channel, this.limits);
    this.legend.show();
    this.bar.update();
    if (this.views.length > 1) this.table.show(); // of two runs what colours, side by side
    this.inspector.update();
  }

  /** What is drawn over the structure, of those that a picture has; "": nothing. */
  setDiagram(id) {
    const chosen = this.offered.find((one) => one.id === id) || null;
    this.diagram = chosen;
    this.views.forEach((view, k) => {
      view.beside = this.over[k].reach(chosen);
      const { clientWidth: width, clientHeight: height } = view.canvas;
      const [legend] = legendBoxes(this.over[k].node);
      const outside = ([x, y]) => (legend && x < legend[2] && y < legend[3]) || x < MARGIN || y < MARGIN || x > width - MARGIN || y > height - MARGIN;
      if (view.beside.some((point) => outside(view.project(point)))) view.aim(view.preset);
      view.request();
    });
    const large = chosen?.id === "deflection" ? `, drawn ${this.over.map((one) => number(one.factor(chosen))).join(" and ")} times as large` : "";
    const unknown = chosen ? [...new Set(this.views.flatMap(({ scene, frame }) => unknownOf(scene, frame, chosen)))] : [];
    const lacking = unknown.length ? `; not known of ${unknown.slice(0, 4).join(", ")}${unknown.length > 4 ? ` and ${unknown.length - 4} more` : ""}` : "";
    this.told.textContent = chosen ? `${chosen.label}: ${chosen.sign}${large}${lacking}.` : "";
    this.bar.update();
  }

  nextDiagram(by) {
    const ids = ["", ...this.offered.map((one) => one.id)];
    this.setDiagram(ids[(ids.indexOf(this.diagram?.id || "") + by + ids.length) % ids.length]);
  }

  setCase(name) {
    for (const view of this.views) if (view.scene.choose(name)) view.rebuildLoads();
    this.setChannel(this.channel?.id || "");
    this.apply();
    this.inspector.show();
    this.goTo(this.index);
    if (this.diagram) this.setDiagram(this.diagram.id);
  }

  nextCase() {
    const { cases, header } = this.views[0].scene;
    if (cases.length > 1) this.setCase(cases[(cases.indexOf(header.load_case) + 1) % cases.length]);
  }

  nextChannel(by) {
    const ids = ["", ...this.views[0].scene.header.channels.map((one) => one.id)];
    const at = ids.indexOf(this.channel?.id || "");
    this.setChannel(ids[(at + by + ids.length) % ids.length]);
  }

  setMode(index) {
    const { modes } = this.views[0].scene.header;
    this.mode = index < modes.length ? index : -1;
    const view = this.views[0], swinging = this.mode >= 0;
    view.mode = swinging ? { array: modes[this.mode].array, size: 0 } : null;
    this.bar.update();
    view.move();
    if (!swinging) return;
    const shape = view.scene.arrays[view.mode.array].data;
    const largest = shape.reduce((best, x) => Math.max(best, Math.abs(x)), 0) || 1;
    const started = performance.now(), shown = this.mode;
    const swing = (now) => {
      if (this.mode !== shown) return;
      view.mode.size = ((SWING * view.scene.extent.size) / largest) * Math.sin(((now - started) / 1000) * 2.5);
      view.move();
      view.render(); // in this very frame: nothing waits from one to the next
      requestAnimationFrame(swing);
    };
    requestAnimationFrame(swing);
  }

  nextMode() {
    const count = this.views[0].scene.header.modes.length;
    if (count) this.setMode(this.mode + 1 < count ? this.mode + 1 : -1);
  }

  toggle(name) {
    this.shown[name] = !this.shown[name];
    this.apply();
  }

  apply() {
    for (const view of this.views) {
      view.ghost.visible = this.shown.ghost;
      view.loads.group.visible = this.shown.loads;
      view.supports.mesh.visible = this.shown.supports;
      view.grid.visible = this.shown.grid;
      view.faces.mesh.visible = this.shown.faces;
      view.showTraces(this.tracedIn(view));
      view.canvas.parentElement.classList.toggle("gridless", !this.shown.grid);
      view.request();
    }
    this.bar.update();
  }

  togglePanel() {
    this.root.classList.toggle("wide");
    this.resize();
  }

  toggleTheme() {
    this.theme = this.theme === "dark" ? "light" : "dark";
    this.root.dataset.theme = this.theme;
    for (const view of this.views) view.setTheme(this.theme);
    this.inspector.update();
  }

  toggleHelp() {
    this.help.hidden = !this.help.hidden;
    if (!this.help.hidden) {
      this.before = this.root.ownerDocument.activeElement;
      this.help.querySelector("button").focus();
    } else this.before?.focus?.();
  }

  // -- picking -----------------------------------------------------------------------------------------------------

  /** Pick {type: "member" | "node", name}, or null. */
  pick(picked) {
    this.picked = picked;
    for (const view of this.views) {
      const index = picked ? this.indexIn(view, picked) : -1;
      view.pick(index < 0 ? null : { type: picked.type, index });
    }
    this.panel.classList.toggle("picked", Boolean(picked));
    this.inspector.show();
    this.table.mark();
    this.onPick?.(picked);
  }

  indexIn(view, picked) {
    return view.scene[picked.type === "member" ? "members" : "nodes"].indexOf(picked.name);
  }

  click(view, event) {
    const box = view.canvas.getBoundingClientRect();
    const hit = view.pickAt(event.clientX - box.left, event.clientY - box.top, event.pointerType === "touch");
    this.pick(hit && { type: hit.type, name: view.scene[`${hit.type}s`][hit.index] });
  }

  pickNext(type, by) {
    const names = this.views[0].scene[`${type}s`];
    if (!names.length) return;
    const at = this.picked?.type === type ? names.indexOf(this.picked.name) : by > 0 ? -1 : 0;
    this.pick({ type, name: names[(at + by + names.length) % names.length] });
  }

  pickWorst() {
    const { scene, frame } = this.views[0];
    if (!this.channel) return;
    let best = [-1, 0];
    scene.members.forEach((_, k) => {
      const size = Math.abs(scene.value(this.channel.id, frame, k));
      if (size > best[0]) best = [size, k];
    });
    if (scene.members.length) this.pick({ type: "member", name: scene.members[best[1]] });
  }

  toggleTrace() {
    if (this.picked?.type !== "node" || this.lead.frames < 2) return;
    const { name } = this.picked;
    if (!this.paths.delete(name)) this.paths.add(name);
    this.apply();
    this.inspector.update();
  }

  /** Nodes whose path a picture shows: the chosen ones, or all that move. */
  tracedIn(view) {
    if (this.shown.paths) view.moving ??= movingNodes(view.scene);
    return new Set([...(this.shown.paths ? view.moving : []), ...[...this.paths].map((name) => view.scene.nodes.indexOf(name)).filter((node) => node >= 0)]);
  }

  find() {
    this.root.classList.remove("wide");
    this.table.filter.focus();
  }

  escape() {
    if (this.help.hidden) this.pick(null);
    else this.toggleHelp();
  }

  // -- camera ------------------------------------------------------------------------------------------------------

  aim(name) {
    for (const view of this.views) view.aim(view.scene.dim === 2 ? "plane" : name);
  }

  /** Turn (rad) and approach (factor); a planar structure stays flat. */
  orbit(across, upward, factor) {
    const turns = this.views[0].scene.dim === 3;
    this.views[0].orbit(turns ? across : 0, turns ? upward : 0, factor);
  }

  follow(moved) {
    moved.request();
    for (const view of this.views) if (view !== moved) view.copyCamera(moved);
  }

  // -- for those who ask -------------------------------------------------------------------------------------------

  /** T, V, M and stress along a member now. */
  diagrams(member, k = 0) {
    const { scene, frame } = this.views[k];
    return diagramsOf(scene, frame, scene.members.indexOf(member));
  }

  /** The free body of a member now. */
  freeBody(member, k = 0) {
    const { scene, frame } = this.views[k];
    return freeBodyOf(scene, frame, scene.members.indexOf(member));
  }
}

