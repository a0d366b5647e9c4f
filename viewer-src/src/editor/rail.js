// The tools above the drawing, and the keys of the page.

import { el, press } from "../dom.js";
import { field } from "./fields.js";
import { HANDS } from "./measures.js";
import { Palette } from "./palette.js";
import { metres } from "./readout.js";
import { TOOLS } from "./tools/index.js";

export class ToolRail {
  constructor(draw) {
    this.draw = draw;
    this.palette = new Palette(draw);
    this.tools = this.palette.tools;
    const made = (words, title, action) => el("button", { type: "button", title, "aria-label": title.replace(/ \(.*/, ""), onclick: action }, words);
    this.several = made("Several", "Pick several: as with Shift held", () => this.toggleSeveral());
    this.several.className = "several";
    this.undo = made("Undo", "Undo (Ctrl+Z)", () => draw.ask({ do: "undo" }));
    this.redo = made("Redo", "Redo (Ctrl+Y)", () => draw.ask({ do: "redo" }));
    this.delete = made("Delete", "Delete what is picked (Delete)", () => draw.remove());
    this.fit = made("Fit", "Show all (F)", () => draw.fit());
    this.names = made("Names", "Names and forces (A)", () => this.toggle("names"));
    this.force = made("Forces", "Colour by force (C)", () => this.toggle("force"));
    this.strength = made("Strength", "Colour by strength: how much of what is allowed is used (8)", () => this.toggle("strength"));
    this.lengths = made("Lengths", "Lengths and angles (L)", () => this.toggle("lengths"));
    this.snap = made("Snap", "Snap to the grid (G)", () => this.toggleSnap());
    this.theme = made("◐", "Dark or light (D)", () => draw.toggleTheme());
    this.fold = el("button", { type: "button", class: "fold", "aria-expanded": "false", title: "What is shown: names, colours, diagram, grid", onclick: () => this.fold.setAttribute("aria-expanded", String(this.node.classList.toggle("open"))) }, "View ▾"); // on a phone
    this.looks = el("span", { class: "group view", role: "group", "aria-label": "view" }, ["corner", "top", "front", "side"].map((name) => el("button", { type: "button", title: `View: ${name}`, onclick: () => this.look(name) }, name[0].toUpperCase() + name.slice(1))));
    this.plane = el("span", { class: "group view plane" });
    this.grid = el("span", { class: "group view" });
    this.title = el("h1", {});
    this.node = el("header", { class: "toolbar rail" }, el("div", { class: "title" }, this.title, el("a", { href: "../", class: "operate" }, "Operate: sliders and forces")),
      el("div", { class: "tools" }, el("span", { class: "group" }, this.several, this.undo, this.redo, this.delete, this.fit, this.fold),
        el("span", { class: "group view" }, this.names, this.force, this.strength, this.lengths, this.snap, this.theme, draw.diagram.node), this.grid, this.looks, this.plane), this.palette.node);
  }

  toggle(name) {
    const { shown } = this.draw, other = { force: "strength", strength: "force" }[name];
    shown[name] = !shown[name];
    if (other && shown[name]) shown[other] = false; // a bar has one colour
    this.draw.canvas.update();
    this.rebuild();
    this.draw.play.judge();
  }

  toggleSnap() {
    this.draw.snap = !this.draw.snap;
    this.rebuild();
  }

  /** For fingers, which have no Shift. */
  toggleSeveral() {
    this.draw.several = !this.draw.several;
    if (this.draw.several && !HANDS[this.draw.tool]) this.draw.setTool("pick");
    this.rebuild();
  }

  look(name) {
    this.draw.camera.look(name);
    this.draw.fit();
  }

  setPlane(change) {
    Object.assign(this.draw.camera.plane, change);
    this.draw.canvas.update();
    this.rebuild();
  }

  rebuild() {
    const { draw } = this, { state, camera } = draw;
    this.palette.rebuild(draw.tool, state?.dim);
    press(this.several, draw.several);
    press(this.names, draw.shown.names);
    press(this.force, draw.shown.force);
    press(this.strength, draw.shown.strength);
    press(this.lengths, draw.shown.lengths);
    press(this.snap, draw.snap);
    if (!state) return;
    this.title.textContent = `${state.file || "Untitled drawing"}${state.dirty ? " (not saved)" : ""}`;
    this.undo.disabled = !state.undo;
    this.redo.disabled = !state.redo;
    this.undo.title = state.undo ? `Undo ${state.undo} (Ctrl+Z)` : "Nothing to undo";
    this.redo.title = state.redo ? `Redo ${state.redo} (Ctrl+Y)` : "Nothing to redo";
    this.delete.disabled = !draw.picked.nodes.size && !draw.picked.members.size;
    this.looks.hidden = this.plane.hidden = state.dim !== 3;
    this.grid.replaceChildren(field("Grid", camera.step ?? "", (value) => this.setStep(value), { hint: "auto", size: 4, name: "grid step in m" }));
    const select = el("select", { "aria-label": "work plane", onchange: () => this.setPlane({ axis: Number(select.value), at: 0 }) }, ["y-z", "x-z", "x-y"].map((name, k) => el("option", { value: k }, name)));
    select.value = camera.plane.axis;
    this.plane.replaceChildren(el("label", { class: "entry" }, el("span", {}, "Plane"), select),
      field(`at ${"xyz"[camera.plane.axis]} =`, camera.plane.at, (value) => this.setHeight(value), { size: 4, name: "height of the work plane in m" }),
      el("button", { type: "button", title: "Look straight at the work plane", onclick: () => { camera.face(); draw.fit(); } }, "Face it"));
  }

  setHeight(value) {
    const at = metres(value);
    if (Number.isFinite(at)) this.setPlane({ at });
    else {
      this.draw.tell(`The height of the work plane is a length: 0.5, 500 mm. Got ${value ?? "nothing"}.`, true);
      this.rebuild();
    }
  }

  setStep(value) {
    const { draw } = this, { camera } = draw, step = value === null ? null : metres(value);
    if (step === null || step > 0) camera.step = step;
    else draw.tell(`The step of the grid is a length: 0.05, 50 mm, 2 in. Got ${value}.`, true);
    if (step > 0 && !draw.state.nodes.length && (step * camera.scale < 8 || step * camera.scale > 150)) camera.zoom(44 / step / camera.scale);
    draw.canvas.update();
    this.rebuild();
  }

  /** Keys of the page; typing into a field stays typing. */
  key(event) {
    const { draw } = this, { target } = event;
    const typing = target.tagName === "TEXTAREA" || target.tagName === "SELECT" || (target.tagName === "INPUT" && target.type !== "checkbox");
    if (draw.closed || event.defaultPrevented || typing) return;
    this.press(event);
  }

  press(event) {
    const { draw } = this, { target } = event;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (event.ctrlKey || event.metaKey) {
      const command = { z: event.shiftKey ? "redo" : "undo", y: "redo" }[key];
      if (command) draw.ask({ do: command });
      else if (key === "a") draw.pickAll();
      else if (key === "s") draw.files.save();
      else return;
      event.preventDefault();
      return;
    }
    if (event.altKey) return;
    const tool = [...TOOLS.values()].find((one) => one.key === key);
    const turn = { i: [0, 0.12], k: [0, -0.12], j: [-0.12, 0], o: [0.12, 0] }[key];
    if (tool) draw.setTool(tool.name);
    else if (turn) { draw.camera.turn(...turn); draw.canvas.update(); }
    else if (key === "Delete" || key === "Backspace") draw.remove();
    else if (key === "Escape") draw.keyboard.escape();
    else if (key === " " && !target.closest("button, a, summary")) draw.play.toggle();
    else if ((key === "+" || key === "-") && draw.play.film) draw.play.faster(key === "+" ? 1 : -1);
    else if (key === "f") draw.fit();
    else if (key === "a") this.toggle("names");
    else if (key === "c") this.toggle("force");
    else if (key === "8") this.toggle("strength");
    else if (key === "l") this.toggle("lengths");
    else if (key === "g") this.toggleSnap();
    else if (key === "d") draw.toggleTheme();
    else return;
    event.preventDefault();
  }
}
