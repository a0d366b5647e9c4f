// Drawings to begin with: their pictures stand under an empty drawing, and in the panel of any other.

import { el, section } from "../dom.js";
import { button } from "./fields.js";
import { thumb } from "./thumb.js";

export class Starters {
  constructor(draw) {
    Object.assign(this, { draw, rows: null, away: false });
    this.strip = el("section", { class: "starters", "aria-label": "drawings to begin with", hidden: true });
    this.all = button("All of them", () => this.all.setAttribute("aria-pressed", String(this.strip.classList.toggle("all"))), { "aria-pressed": "false" });
    this.cards = el("div", { class: "cards" });
    this.node = section("Begin from", el("p", { class: "faint" }, "A copy in place of this drawing; it can be undone."), this.cards);
    this.node.open = false;
    this.node.addEventListener("toggle", () => this.node.open && this.fetch());
  }

  get empty() {
    return Boolean(this.draw.state) && !this.draw.state.nodes.length;
  }

  rebuild() {
    this.strip.hidden = !this.empty || this.away || !this.rows || this.draw.task.takes(this.draw.tool);
    if (this.empty && !this.away) this.fetch();
  }

  async fetch() {
    if (this.rows || this.asked) return;
    this.asked = true;
    const { rows } = await this.draw.ask({ do: "starters" });
    this.asked = false;
    if (!rows) return;
    this.rows = rows;
    this.cards.replaceChildren(...rows.map((row) => this.card(row)));
    this.strip.replaceChildren(el("header", {}, el("b", {}, "Begin from one of these, or draw"), this.all, button("×", () => this.hide(), { "aria-label": "hide the drawings to begin with", title: "Hide (they stay in the panel)" })),
      el("div", { class: "cards" }, rows.map((row) => this.card(row))));
    this.rebuild();
  }

  card({ name, words, picture }) {
    return el("button", { type: "button", class: "card", title: words, onclick: () => this.begin(name) }, thumb(picture), el("b", {}, name), el("span", {}, words));
  }

  hide() {
    this.away = true;
    this.rebuild();
    this.draw.canvas.node.focus({ preventScroll: true });
  }

  async begin(name) {
    const answer = await this.draw.ask({ do: "begin", name });
    if (answer.kind !== "drawing") return;
    this.node.open = false;
    this.draw.fit();
    this.draw.canvas.node.focus({ preventScroll: true });
    this.draw.say(`${name}: a copy to change`);
  }
}
