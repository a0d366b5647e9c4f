// The path of a node along the range of a drive, and what holds the drive there.

import { el, section, svg } from "../dom.js";
import { plot } from "../plot.js";
import { button, choice, refill } from "./fields.js";
import { holding } from "./status.js";

export class Curves {
  constructor(draw) {
    Object.assign(this, { draw, on: null, found: null, stale: false });
    this.body = el("div", {});
    this.plot = el("canvas", { class: "plot", role: "img", "aria-label": "force of the drive along its range" });
    this.note = el("p", { class: "faint", role: "status" });
    this.node = section("Path of a node", this.body, this.note, this.plot);
    this.plot.hidden = true;
  }

  rebuild() {
    const { draw } = this, { state, picked } = draw;
    if (!state) return;
    const drives = state.drives.map(({ name }) => name);
    if (this.on && (!state.nodes.includes(this.on.node) || !drives.includes(this.on.drive))) this.stop();
    const node = [...picked.nodes][0] || this.on?.node || state.nodes.at(-1) || "";
    this.wish = { node, drive: this.on?.drive || drives[0] || "" };
    if (!drives.length) refill(this.body, el("p", { class: "faint" }, "A path needs a drive: pick a bar and choose its driven length or angle."));
    else {
      refill(this.body, el("div", { class: "row" }, choice("of node", state.nodes, node, (name) => (this.wish.node = name), "node of the path"), choice("by drive", drives, this.wish.drive, (name) => (this.wish.drive = name), "drive of the path"),
        button("Show path", () => this.start()), this.on ? button("Hide", () => { this.stop(); this.rebuild(); }) : null));
    }
  }

  start() {
    this.on = { ...this.wish };
    this.stale = true;
    this.rebuild();
    this.draw.pump();
  }

  stop() {
    Object.assign(this, { on: null, found: null, stale: false });
    this.note.textContent = "";
    this.plot.hidden = true;
    this.draw.canvas.update();
  }

  /** The drawing has changed: the path follows as soon as there is time. */
  spoil() {
    if (this.on) this.stale = true;
  }

  command() {
    this.stale = false;
    return { do: "curve", ...this.on };
  }

  take(found) {
    if (!this.on) return;
    this.found = found;
    this.note.textContent = found.stopped;
    this.draw.canvas.update();
    this.plot.hidden = false;
    const unit = found.unit === "rad" ? "N m" : "N", factor = found.unit === "rad" ? 180 / Math.PI : 1;
    const x = found.values.map((value) => value * factor), y = found.force.map((value) => value ?? NaN);
    plot(this.plot, [{ x, y, label: found.drive }], { unit, xUnit: found.unit === "rad" ? "deg" : "m", title: holding([found]) });
  }

  /** A path that could not be found is not shown any more. */
  failed(message, waiting) {
    if (!this.on || waiting?.command || !message.startsWith("No")) return;
    this.found = null;
    this.note.textContent = message;
    this.plot.hidden = true;
    this.draw.canvas.update();
  }

  place(layer) {
    if (!this.found) return layer.replaceChildren();
    const { camera } = this.draw;
    const points = this.found.path.map((point) => camera.project(point));
    layer.replaceChildren(svg("path", { class: "curve", d: `M${points.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join("L")}` }));
  }
}
