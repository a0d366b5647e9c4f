// What the colours mean, in words and numbers.

import { gradient } from "./colour.js";
import { KINDS, OVER, SKINS } from "./display.js";
import { el, fill } from "./dom.js";
import { held, number, quantity, scale } from "./format.js";

const KIND_WORDS = {
  rigid: "rigid bar", driven: "driven bar", active: "active member: base and tube", elastic: "elastic bar", beam: "elastic beam", cable: "cable: tension only", free: "free sensor",
};
const SKIN_WORDS = { membrane: "membrane", solid: "surface of a solid" };

export class Legend {
  constructor(app) {
    this.app = app;
    this.node = el("div", { class: "legend", role: "note", "aria-live": "polite" });
  }

  show() {
    const { channel, limits } = this.app;
    if (!channel) {
      const rows = [...this.kinds().map(([kind, words]) => swatch(KINDS[kind], words)), ...this.skins(), ...this.motors()];
      this.node.hidden = !rows.length;
      fill(this.node, el("b", {}, "Kinds of members"), rows);
      return;
    }
    this.node.hidden = false;
    const [factor, unit] = scale(limits[1], channel.unit);
    const title = `${channel.label}${unit ? ` (${unit})` : ""}`;
    const numbers = ticks(channel, limits).map((value) => el("span", {}, tickText(channel, value, factor)));
    const rows = [el("b", {}, title), el("div", { class: "bar", style: `background:${gradient(channel.scale)}` }),
      el("div", { class: "ticks" }, numbers), el("div", { class: "words" }, el("span", {}, channel.low), el("span", {}, this.high(channel)))];
    if (channel.over_run) rows.push(el("small", {}, "worst of the whole run"));
    if (this.over(channel)) rows.push(swatch(OVER, channel.scale === "margin" ? "buckles (margin below 0)" : "over capacity (above 100 %)"));
    if (this.missing(channel)) rows.push(striped("var(--missing)", held(channel) ? "not checked" : "not known"));
    if (channel.id !== "speed" && this.app.views.some(({ scene }) => scene.unsure.size)) rows.push(striped("var(--faint)", "the force is not unique"));
    if (!this.app.views.some(({ scene }) => scene.coloursFaces(channel.id))) rows.push(...this.skins());
    fill(this.node, rows);
  }

  /** The words at the upper end; the scale ends at a round number above the largest value. */
  high(channel) {
    if (channel.high !== "largest of the run") return channel.high;
    const scenes = this.app.views.map(({ scene }) => scene).filter((scene) => scene.channel(channel.id));
    return `largest ${this.app.lead.frames > 1 ? "of the run " : ""}${quantity(Math.max(...scenes.map((scene) => scene.range(channel.id)[1])), channel.unit)}`;
  }

  kinds() {
    const found = new Set(this.app.views.flatMap((view) => view.scene.header.kinds));
    return Object.entries(KIND_WORDS).filter(([kind]) => found.has(kind));
  }

  motors() {
    const turns = this.app.views.some(({ scene }) => scene.header.drives.some((drive) => drive.kind === "angle" || drive.kind === "hinge"));
    return turns ? [swatch(KINDS.driven, "ring: motor about its axis")] : [];
  }

  /** What of faces has the colour of its kind. */
  skins() {
    const found = new Set(this.app.views.flatMap((view) => view.scene.header.skins?.map((one) => one.kind) || []));
    return Object.entries(SKIN_WORDS).filter(([kind]) => found.has(kind)).map(([kind, words]) => swatch(SKINS[kind], words));
  }

  over(channel) {
    return held(channel) && this.app.views.some(({ scene }) => scene.channel(channel.id) && scene.range(channel.id)[1] > 1);
  }

  missing(channel) {
    return this.app.views.some(({ scene, frame }) => scene.members.some((_, k) => Number.isNaN(scene.value(channel.id, frame, k))));
  }
}

function swatch(colour, words) {
  return el("div", { class: "swatch" }, el("i", { style: `background:${colour}` }), words);
}

/** A swatch with stripes, as the bars have them. */
function striped(colour, words) {
  return el("div", { class: "swatch" }, el("i", { style: `background:repeating-linear-gradient(135deg, ${colour} 0 4px, var(--card) 4px 7px)` }), words);
}

function ticks(channel, [low, high]) {
  if (channel.scale === "diverging") return [low, low / 2, 0, high / 2, high];
  return [0, 0.25, 0.5, 0.75, 1].map((f) => low + f * (high - low));
}

function tickText(channel, value, factor) {
  if (channel.scale === "margin") return value <= 0 ? "∞" : number(1 / value - 1, 2);
  return number(value * factor, 3);
}
