// What the pointer is at: its coordinates, the length of the bar that is drawn, the step of the grid, and what is out of sight.

import { el } from "../dom.js";
import { quantity } from "../format.js";
import { clean } from "./camera.js";

export class Readout {
  constructor(draw) {
    this.draw = draw;
    this.place = el("span", {});
    this.grid = el("span", {});
    this.outside = el("button", { type: "button", hidden: true, onclick: () => draw.fit() });
    this.node = el("div", { class: "readout" }, this.place, this.grid, this.outside);
  }

  update() {
    const { draw } = this, { state, camera, rubber, cursor, pointed } = draw;
    const to = rubber?.to || cursor || pointed?.at;
    const at = to && `${pointed?.name && !rubber ? `${pointed.name}: ` : ""}${draw.cut(to).map((value) => clean(value)).map((value) => Number(value.toPrecision(6))).join(", ")} m`;
    const length = rubber?.from && rubber.to && Math.hypot(...rubber.to.map((value, k) => value - rubber.from[k]));
    this.place.textContent = [at, length ? `length ${quantity(length, "m")}` : ""].filter(Boolean).join("; ");
    this.grid.textContent = `grid ${quantity(camera.grid, "m")}`;
    const away = (draw.canvas.seen || []).filter(([x, y]) => x < 0 || y < 0 || x > camera.width || y > camera.height).length;
    this.outside.hidden = !away || !state?.nodes.length;
    this.outside.textContent = `${away} node${away === 1 ? " is" : "s are"} out of sight. Show all`;
  }
}

/** Metres from what is typed: 0.05, 50 mm, 2 in; NaN if it is no length. */
export function metres(typed) {
  const [, number, unit = "m"] = /^\s*([+-]?[\d.]+(?:e[+-]?\d+)?)\s*([a-z]+)?\s*$/i.exec(String(typed ?? "")) || [];
  return Number(number ?? NaN) * ({ m: 1, cm: 0.01, mm: 0.001, in: 0.0254, ft: 0.3048 }[unit] ?? NaN);
}
