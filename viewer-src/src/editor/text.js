// The file as text, both ways: what is drawn is written here, what is typed here is drawn.

import { el, section } from "../dom.js";

const PAUSE = 240; // ms after the last key at which the text is taken

export class Text {
  constructor(draw) {
    Object.assign(this, { draw, typing: -1 }); // below zero: drags of the pointer have other numbers
    this.area = el("textarea", { "aria-label": "model as text", spellcheck: "false", rows: 18, wrap: "off", oninput: () => this.typed(), onblur: () => this.typing-- });
    this.lines = el("pre", { class: "lines", "aria-hidden": "true" });
    this.faults = el("ul", { class: "faults", role: "status" });
    this.back = el("button", { type: "button", hidden: true, onclick: () => this.reset() }, "Back to the drawing's text");
    this.node = section("The file", el("p", { class: "faint" }, "The same model as text. An edit of the drawing changes only its own lines; comments stay."), el("div", { class: "text" }, this.lines, this.area), this.faults, this.back);
    this.area.addEventListener("scroll", () => (this.lines.scrollTop = this.area.scrollTop));
  }

  typed() {
    this.dirty = true;
    this.since = performance.now();
    this.number([]);
    clearTimeout(this.timer);
    const { typing } = this;
    this.timer = setTimeout(() => this.send(typing), PAUSE);
  }

  async send(drag) {
    const text = this.area.value;
    const answer = await this.draw.ask({ do: "text", text, drag }, this.since);
    if (this.area.value !== text || answer.kind === "lost") return;
    if (answer.kind === "faults") this.show(answer.faults, true);
    else if (answer.kind === "drawing") {
      this.dirty = false;
      this.show(answer.faults, false);
    }
  }

  reset() {
    this.dirty = false;
    this.rebuild();
  }

  rebuild() {
    const { state } = this.draw;
    if (this.dirty && this.area.ownerDocument.activeElement === this.area) return; // someone is typing
    this.dirty = false;
    if (this.area.value !== state.text) this.area.value = state.text;
    this.show(state.faults, false);
  }

  show(faults, kept) {
    this.back.hidden = !kept;
    this.number(faults.map(({ line }) => line));
    this.faults.replaceChildren(...faults.slice(0, 20).map(({ text, line }) => el("li", {}, el("button", { type: "button", class: "link", onclick: () => this.goTo(line) }, line ? `Line ${line}` : "Model"), ` ${text}`)),
      ...(kept ? [el("li", {}, "The drawing is that of the last text without such faults.")] : []));
  }

  number(faulty) {
    const count = this.area.value.split("\n").length;
    this.lines.replaceChildren(...Array.from({ length: count }, (_, k) => el("span", { class: faulty.includes(k + 1) ? "faulty" : "" }, `${k + 1}\n`)));
    this.lines.scrollTop = this.area.scrollTop;
  }

  goTo(line) {
    if (!line) return;
    const rows = this.area.value.split("\n");
    const start = rows.slice(0, line - 1).reduce((sum, row) => sum + row.length + 1, 0);
    this.area.focus();
    this.area.setSelectionRange(start, start + rows[line - 1].length);
    this.area.scrollTop = (line - 4) * (this.area.scrollHeight / rows.length);
  }
}
