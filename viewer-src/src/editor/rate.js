// The rate at which a drive moves where its forces are those at speed: kept as it is typed, one for turns and one for strokes.

import { el } from "../dom.js";
import { number, quantity } from "../format.js";
import { field } from "./fields.js";

const PLAIN = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** A rate, rad/s or m/s, as it is read. */
export function rateOf(value, unit) {
  return unit === "rad" ? `${number((value * 180) / Math.PI)} deg/s` : quantity(value, "m/s");
}

export class Rate {
  constructor(play) {
    Object.assign(this, { play, trying: null });
    this.of = { rad: { text: "", good: "", error: "" }, m: { text: "", good: "", error: "" } };
  }

  /** What the studio is asked for: a number alone counts in deg/s or m/s; null for its own rate. */
  asked(text, unit) {
    return PLAIN.test(text) ? `${text} ${unit === "rad" ? "deg/s" : "m/s"}` : text || null;
  }

  /** The last rate that was understood. */
  good(unit) {
    return this.asked(this.of[unit].good, unit);
  }

  /** The field, with what is wrong beside it. */
  node(film) {
    const { unit } = film.drives[film.lead], own = this.of[unit];
    const node = field("Rate", own.text, (_, text) => this.take(text, unit), { hint: rateOf(film.rate, unit), size: 10, name: "rate of the drive" });
    if (!own.error) return node;
    const input = node.querySelector("input");
    input.setAttribute("aria-invalid", "true");
    input.setAttribute("aria-describedby", "rate-error");
    return [node, el("span", { id: "rate-error", class: "wrong", role: "alert" }, `${own.error} Shown at ${rateOf(film.rate, unit)}.`)];
  }

  /** One that is not understood leaves the motion as it is. */
  async take(text, unit) {
    const { play } = this, { revision } = play.draw.state, own = this.of[unit], command = play.command(this.asked(text, unit));
    Object.assign(own, { text, error: "" });
    this.trying = command;
    const film = await play.ask(command);
    if (play.draw.state.revision !== revision) return this.take(text, unit);
    if (film.kind === "error") {
      own.error = film.message;
      play.rebuild();
    } else if (play.isFilm(film)) {
      own.good = text;
      play.show(film);
    }
  }
}
