// Saving, versions, and the drawing that an earlier studio left.

import { el, section } from "../dom.js";
import { button } from "./fields.js";

export class Files {
  constructor(draw) {
    this.draw = draw;
    this.name = el("input", { type: "text", "aria-label": "file name", size: 18 });
    this.rows = el("ul", { class: "versions" });
    this.offer = el("p", { class: "banner", hidden: true });
    this.ask = el("p", { class: "banner warning", hidden: true });
    this.body = el("div", {}, this.ask, el("div", { class: "row" }, this.name, button("Save", () => this.save(), { title: "Save (Ctrl+S)" })),
      el("div", { class: "row" }, button("Keep this state", () => this.list({ do: "keep" })), button("Show versions", () => this.list({ do: "versions" }))), this.rows);
    this.node = section("Save and versions", this.body, el("p", { class: "faint" }, "Every edit is kept beside the file, in the folder .kinetruss, until it is saved."));
  }

  rebuild() {
    const { state } = this.draw;
    this.body.hidden = !state.writable;
    if (!state.offered) this.offer.hidden = true;
    if (!this.name.value) this.name.value = state.file || "model.yaml";
    if (state.saved) this.list({ do: "versions" });
  }

  async save(replace = false) {
    this.ask.hidden = true;
    const name = this.name.value.trim();
    if (name && !/[./\\]/.test(name)) this.name.value = `${name}.yaml`;
    const answer = await this.draw.ask({ do: "save", name: this.name.value.trim(), replace });
    if (answer.kind !== "exists") return;
    this.ask.hidden = false;
    this.ask.replaceChildren(`${answer.message} `, button("Overwrite", () => this.save(true)));
    this.draw.tell(answer.message, true);
    this.node.open = true;
    this.ask.scrollIntoView({ block: "nearest" });
  }

  async list(command) {
    const { rows } = await this.draw.ask(command);
    if (!rows) return;
    const when = (time) => new Date(1000 * time).toLocaleString();
    this.rows.replaceChildren(...(rows.length ? rows.toReversed().map(({ number, when: time, words }) => el("li", {}, button(`Back to ${number}`, () => this.draw.ask({ do: "restore", number })), ` ${words}, ${when(time)}`)) : [el("li", {}, "No version yet.")]));
  }

  /** A drawing that was not saved when its studio ended. */
  setOffer(offer) {
    this.offer.hidden = !offer;
    if (!offer) return;
    const answer = async (keep) => {
      this.offer.hidden = true;
      await this.draw.ask({ do: "draft", keep });
      this.draw.fit();
    };
    this.offer.replaceChildren(`A drawing of ${offer.lines} lines was not saved when its studio ended, ${new Date(1000 * offer.when).toLocaleString()}. `,
      button("Go on with it", () => answer(true)), " ", button("Remove it", () => answer(false)));
  }
}
