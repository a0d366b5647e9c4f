// Files to take away: pictures, a film of the motion, the page that plays it, a report, the model as text.

import { el, section } from "../dom.js";
import { button, choice, refill } from "./fields.js";

const AGAIN = 300; // ms between questions how far a file is
const FORMS = [
  ["Picture", [["png", "PNG", "A picture of the drawing, 300 dots per inch"], ["svg", "SVG", "A picture of the drawing as lines and text, for print"], ["pdf", "PDF", "The same picture on a sheet of its size"]]],
  ["Motion", [["gif", "GIF", "A film that plays everywhere (needs Chromium)"], ["mp4", "MP4", "A film (needs Chromium and ffmpeg)"], ["page", "Page", "One file that plays in any browser, without a network"]]],
  ["Model", [["yaml", "YAML", "The model file"], ["python", "Python", "The model as Python code"]]],
  ["Result", [["report", "Report", "A report for a reviewer, one file"], ["paper", "Report as PDF", "The report printed (needs Chromium)"]]],
];

export class Take {
  constructor(draw) {
    Object.assign(this, { draw, run: "", doing: null });
    this.body = el("div", {});
    this.note = el("div", { role: "status" });
    this.node = section("Take it with you", this.body, this.note);
  }

  rebuild() {
    const { state } = this.draw;
    if (!state) return;
    const runs = Object.keys(state.data.runs || {});
    if (!runs.includes(this.run)) this.run = "";
    const rows = FORMS.map(([words, forms]) => el("div", { class: "row take" }, el("span", { class: "faint" }, words), forms.map(([form, name, title]) => button(name, () => this.take(form), { title, "aria-label": `take ${name}`, disabled: Boolean(this.doing) || !state.nodes.length }))));
    refill(this.body, runs.length > 1 ? el("div", { class: "row" }, choice("of run", [["", "the first that moves"], ...runs], this.run, (name) => (this.run = name), "run to take")) : null, rows);
  }

  async take(form) {
    this.doing = form;
    this.rebuild();
    const { play } = this.draw, sample = play.away ? play.index : null; // a picture shows the pose that is seen
    let answer = await this.draw.ask({ do: "take", form, run: this.run, sample });
    while (answer.kind === "running" && answer.form) {
      this.progress(answer);
      await new Promise((done) => setTimeout(done, AGAIN));
      answer = await this.draw.ask({ do: "running" });
    }
    this.doing = null;
    this.rebuild();
    if (answer.kind === "taken") this.fetch(answer);
    else this.note.replaceChildren(answer.kind === "error" ? el("p", { class: "banner warning" }, answer.message) : "");
  }

  progress({ done, total, note }) {
    const name = FORMS.flatMap(([, forms]) => forms).find(([form]) => form === this.doing)[1], words = `Making the ${name}${total ? `: ${done} of ${total} pictures` : " ..."}${note ? `. ${note}` : ""}`;
    this.note.replaceChildren(el("div", { class: "row doing" }, el("span", { "aria-live": "off" }, words), el("progress", { max: total || 1, ...(done ? { value: done } : {}) }), button("Stop", () => this.draw.ask({ do: "stop" }), { "aria-label": "stop making the file" })));
  }

  fetch({ number, file, bytes }) {
    const link = el("a", { href: `result/${number}`, download: file }, file);
    this.note.replaceChildren(el("p", {}, link, ` (${bytes < 1e6 ? `${Math.ceil(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(1)} MB`})`));
    link.click();
  }
}
