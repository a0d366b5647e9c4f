// Several at once: copies, mirror images, stacks of cells.

import { el, section } from "../dom.js";
import { button, choice, field, refill } from "./fields.js";

export class Groups {
  constructor(draw) {
    Object.assign(this, { draw, values: {} });
    this.body = el("div", {});
    this.node = section("Copy, mirror, stack", this.body);
    this.node.open = false;
  }

  field(label, key, start, name) {
    return field(label, this.values[key] ?? start, (value) => (this.values[key] = value), { size: 6, name });
  }

  value(key, start) {
    return this.values[key] ?? start;
  }

  /** Picked nodes, and those at the ends of picked members. */
  nodes() {
    const { picked, state } = this.draw;
    const ends = state.members.filter(({ name }) => picked.members.has(name)).flatMap(({ ends: pair }) => pair);
    return [...new Set([...picked.nodes, ...ends])];
  }

  rebuild() {
    const { draw } = this, { state } = draw;
    if (!state) return;
    const axes = [..."xyz"].slice(0, state.dim), count = this.nodes().length;
    const copy = () => draw.edit({ do: "copy", nodes: this.nodes(), by: axes.map((axis) => this.value(`d${axis}`, 0)), count: this.value("count", 1) }).then(() => draw.reveal());
    const mirror = () => draw.edit({ do: "mirror", nodes: this.nodes(), axis: this.value("axis", "x"), at: this.value("at", 0) }).then(() => draw.reveal());
    const stack = () => draw.edit({ do: "stack", cell: this.value("cell", cells[0]), count: this.value("cells", 1) }).then((answer) => answer.kind === "drawing" && draw.fit());
    const planar = ["triangle", "panel"];
    const cells = draw.choices.cells.filter((name) => planar.includes(name) === (state.dim === 2));
    refill(this.body, el("p", { class: "faint" }, count ? `${count} node${count === 1 ? " is" : "s are"} picked.` : "No node is picked: Shift-click, Shift-drag a box, or Ctrl+A."),
      el("fieldset", {}, el("legend", {}, "Copy, shifted by"), el("div", { class: "row" }, axes.map((axis) => this.field(axis, `d${axis}`, 0, `shift of copies along ${axis}`)), this.field("times", "count", 1, "number of copies"), button("Copy", copy))),
      el("fieldset", {}, el("legend", {}, "Mirror in the plane"), el("div", { class: "row" }, choice("", axes, this.value("axis", "x"), (value) => (this.values.axis = value), "mirror axis"), this.field("=", "at", 0, "place of the mirror"), button("Mirror", mirror))),
      el("fieldset", {}, el("legend", {}, "Cells of the library"), el("div", { class: "row" }, choice("", cells, this.value("cell", cells[0]), (value) => (this.values.cell = value), "cell"), this.field("times", "cells", 1, "number of cells"), button("Stack", stack))));
  }
}
