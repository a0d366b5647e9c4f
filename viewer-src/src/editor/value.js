// A value beside what was just drawn: type it, or go on.

import { el } from "../dom.js";

export class Value {
  constructor(draw) {
    this.draw = draw;
    this.input = el("input", { type: "text", autocomplete: "off", spellcheck: "false", size: 9, onkeydown: (event) => this.key(event), onblur: (event) => this.left(event), oninput: () => (this.typed = true) });
    this.label = el("span", {});
    this.node = el("label", { class: "value", hidden: true }, this.label, this.input);
  }

  /** at : where, in the drawing; by default in the corner. set : takes what was typed. A finger types there only if it wants to. */
  ask({ at, label, value, set }) {
    Object.assign(this, { at, set, typed: false });
    this.node.classList.toggle("corner", !at);
    this.label.textContent = label;
    this.input.setAttribute("aria-label", label);
    this.input.value = value;
    this.input.size = Math.max(9, String(value).length);
    this.node.hidden = false;
    this.place();
    if (!at && this.draw.tools.touch) return;
    this.input.focus({ preventScroll: true });
    this.input.select();
  }

  place() {
    if (this.node.hidden || !this.at) return;
    const { camera } = this.draw, [x, y] = camera.project(this.at), { offsetWidth: wide, offsetHeight: high } = this.node;
    const within = (place, size, all) => Math.max(4, Math.min(place, all - size - 4));
    Object.assign(this.node.style, { left: `${within(x + 14, wide, camera.width)}px`, top: `${within(y + 10, high, camera.height)}px` });
  }

  /** Until something is typed, letters and arrows are no values: they choose tools and move the cursor, as everywhere. */
  key(event) {
    const { draw } = this, { key } = event, shortcut = !this.typed && (event.ctrlKey || event.metaKey ? /^[yzs]$/i : /^([a-z ]|Arrow.*|Page.*|Delete|Escape|ContextMenu|F10)$/i).test(key);
    if (key !== "Enter" && key !== "Escape" && !shortcut) return;
    event.stopPropagation();
    this.close(key === "Enter");
    draw.canvas.node.focus({ preventScroll: true });
    if (shortcut) draw.keyboard.key(event);
    if (shortcut && !event.defaultPrevented) draw.rail.press(event);
    event.preventDefault();
  }

  left({ relatedTarget: to }) {
    this.close(true);
    if (to !== this.draw.canvas.node) this.draw.tools.leave();
  }

  close(take) {
    if (this.node.hidden) return;
    this.node.hidden = true;
    if (take && this.typed && this.input.value.trim()) this.set(this.input.value.trim());
  }
}
