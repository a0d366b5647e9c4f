// A slider and a field for every drive.

import { el, fill, section } from "./dom.js";
import { number } from "./format.js";

const STEPS = 2000;
const DEGREE = Math.PI / 180;

export class Drives {
  constructor(live) {
    this.live = live;
    this.list = el("div", { class: "drives" });
    this.node = section("Drives", this.list);
  }

  rebuild(setup) {
    this.rows = new Map(setup.drives.map((drive) => [drive.name, this.row(drive)]));
    fill(this.list, setup.drives.length ? [...this.rows.values()].map((row) => row.node) : el("p", { class: "faint" }, "This model has no drive."));
  }

  row(drive) {
    const factor = drive.unit === "rad" ? 1 / DEGREE : 1000, unit = drive.unit === "rad" ? "deg" : "mm";
    const { low, high, name } = drive;
    const slider = el("input", { type: "range", min: low, max: high, step: (high - low) / STEPS, "aria-label": `drive ${name}`,
      oninput: () => this.live.move({ [name]: Number(slider.value) }) });
    const field = el("input", { type: "number", step: "any", "aria-label": `value of ${name} in ${unit}`,
      oninput: () => (row.typing = true),
      onchange: () => {
        row.typing = false; // what is reached takes the place of what was asked for
        if (Number.isFinite(field.valueAsNumber)) this.live.move({ [name]: field.valueAsNumber / factor });
        else this.update(this.live.controls.last);
      } });
    const ends = el("small", {}, `${number(low * factor, 4)} to ${number(high * factor, 4)} ${unit}${drive.limited ? "" : ", no limits in the model"}`);
    const node = el("div", { class: "drive", "data-drive": name }, el("b", {}, name), el("span", { class: "value" }, field, ` ${unit}`), slider, ends);
    const row = { node, slider, field, factor, typing: false };
    return row;
  }

  /** Where the drives are now; a slider that ran ahead of what can be reached comes back. */
  update({ values, stopped }) {
    for (const [name, { node, slider, field, factor, typing }] of this.rows) {
      const value = values[name];
      if (value === undefined) continue;
      const ahead = this.live.wanted && name in this.live.wanted;
      if (!ahead || stopped) slider.value = value;
      if (!typing) field.value = Number((value * factor).toFixed(4));
      node.classList.toggle("stopped", Boolean(stopped) && name in (this.live.sent || {}));
    }
  }
}
