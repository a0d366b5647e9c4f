// A value beside what was just drawn: type it, or go on.

import { el } from "../dom.js";

export class Value {
  constructor(draw) {
    this.draw = draw;
    this.input = el("input", { type: "text", autocomplete: "off", spellcheck: "false", size: 9, onkeydown: (event) => this.key(event), onblur: () => this.close(true), oninput: () => (this.typed = true) });
    this.label = el("span", {});
    this.node = el("label", { class: "value", hidden: true }, this.label, this.input);
  }

  /** at : where, in the drawing. set : takes what was typed. */
  ask({ at, label, value, set }) {
    Object.assign(this, { at, set, typed: false });
    this.label.textContent = label;
    this.input.setAttribute("aria-label", label);
    this.input.value = value;
    this.input.size = Math.max(9, String(value).length);
    this.node.hidden = false;
    this.place();
    this.input.focus({ preventScroll: true });
    this.input.select();
  }

  place() {
    if (this.node.hidden) return;
    const { camera } = this.draw, [x, y] = camera.project(this.at), { offsetWidth: wide, offsetHeight: high } = this.node;
    const within = (place, size, all) => Math.max(4, Math.min(place, all - size - 4));
    Object.assign(this.node.style, { left: `${within(x + 14, wide, camera.width)}px`, top: `${within(y + 10, high, camera.height)}px` });
  }

  /** Letters are no values: they choose tools, as everywhere. */
  key(event) {
    const shortcut = !this.typed && (/^[a-z ]$/i.test(event.key) || event.key === "Delete") && !event.ctrlKey && !event.metaKey;
    if (event.key === "Enter" || event.key === "Escape" || shortcut) {
      event.preventDefault();
      event.stopPropagation();
      this.close(event.key === "Enter");
      this.draw.canvas.node.focus({ preventScroll: true });
      if (shortcut) this.draw.rail.press(event);
    }
  }

  close(take) {
    if (this.node.hidden) return;
    this.node.hidden = true;
    if (take && this.typed && this.input.value.trim()) this.set(this.input.value.trim());
  }
}
