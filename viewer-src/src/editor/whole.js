// What holds for the whole drawing: gravity, section and material, plane or space.

import { el, section } from "../dom.js";
import { button, field, refill } from "./fields.js";
import { materialChoice, sectionChoice, weightText } from "./sections.js";

export class Whole {
  constructor(draw) {
    this.draw = draw;
    this.body = el("div", {});
    this.node = section("Model", this.body);
  }

  rebuild() {
    const { draw } = this, { state } = draw;
    if (!state) return;
    const { data, dim } = state;
    const set = (path, value) => draw.edit({ do: "set", path, value });
    const gravity = data.gravity || Array(dim).fill(0);
    const fields = [..."xyz"].slice(0, dim).map((axis, k) => field(`g${axis}`, gravity[k], (value) => set(["gravity"], gravity.map((one, i) => (i === k ? value ?? 0 : one))), { size: 6, name: `gravity along ${axis}` }));
    const fresh = (count, words) => button(words, () => draw.edit({ do: "fresh", dim: count }), { title: "It can be undone." });
    refill(this.body, el("div", { class: "row" }, sectionChoice(draw, data.section, (value) => set(["section"], value), "section of the model", data.material)),
      el("div", { class: "row" }, materialChoice(draw, data.material, (value) => set(["material"], value), "material of the model"), el("small", {}, weightText(draw))),
      el("div", { class: "row" }, fields, el("small", {}, "m/s²")), el("div", { class: "row" }, field("Title", data.title, (value) => set(["title"], value === null ? null : String(value)), { size: 20, name: "title" })),
      el("div", { class: "row" }, fresh(2, "New, in the plane"), fresh(3, "New, in space")));
  }
}
