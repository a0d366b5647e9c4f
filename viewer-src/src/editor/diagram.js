// Section forces or the deflection over the drawing, on request: curves of the studio, and their largest values.

import { el } from "../dom.js";
import { number } from "../format.js";
import { areaOf, placedValues, textOf } from "../over.js";

export class Diagram {
  constructor(draw) {
    Object.assign(this, { draw, on: "", found: null, stale: false });
    this.select = el("select", { "aria-label": "diagram", title: "Diagram over the structure, of all loads", onchange: () => this.choose(this.select.value) });
    this.node = el("label", { class: "entry" }, el("span", {}, "Diagram"), this.select);
    this.told = el("p", { class: "told", role: "status" });
  }

  rebuild() {
    const { shows } = this.draw.state;
    if (!shows.some(({ id }) => id === this.on)) this.on = "";
    this.select.replaceChildren(el("option", { value: "" }, "Off"), ...shows.map(({ id, label }) => el("option", { value: id }, label)));
    this.select.value = this.on;
  }

  choose(id) {
    Object.assign(this, { on: id, found: null, stale: Boolean(id) });
    this.select.value = id;
    this.tell();
    this.draw.canvas.update();
    this.draw.pump();
  }

  /** The drawing has changed: what is shown belongs to the one before. */
  spoil() {
    if (!this.on) return;
    this.stale = true;
    this.found = null;
    this.tell();
  }

  /** Another pose of the motion is shown, or the drawn one again. */
  follow() {
    this.spoil();
    this.draw.pump();
  }

  command() {
    const { play } = this.draw;
    this.stale = false;
    return { do: "over", show: this.on, ...(play.away ? { sample: play.index } : {}) };
  }

  take(found) {
    if (found.show !== this.on || this.stale) return;
    this.found = found;
    this.tell();
    this.draw.canvas.update();
  }

  tell() {
    const { found } = this, large = found?.show === "deflection" && found.curves.length ? `, drawn ${number(found.factor)} times as large` : "";
    this.told.textContent = this.on && this.draw.play.playing ? "The diagram is shown where the motion stops." : found ? found.why || `${found.sentence}${large}.` : "";
  }

  /** taken : boxes that names cover, to which those of the values are added. */
  place(layer, taken) {
    const { found, draw } = this, { camera } = draw;
    if (!found || draw.stale || draw.play.playing) return layer.replaceChildren();
    const on = (points) => points.map((point) => camera.project(point));
    const values = [], shown = found.curves.flatMap((curve) => {
      const foot = on(curve.base), tips = on(curve.base.map((point, k) => point.map((x, i) => x + found.factor * curve.shift[k][i])));
      for (const k of curve.extremes) values.push({ value: curve.values[k], tip: tips[k], foot: foot[k] });
      return areaOf(foot, tips, curve.values, found.show);
    });
    const placed = placedValues(values, found.unit, camera, taken);
    taken.push(...placed.map(({ box }) => box));
    layer.replaceChildren(...shown, ...placed.map(textOf));
  }
}
