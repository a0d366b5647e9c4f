// Key frames on a timeline: set poses, run the motion through them, see its worst instants.

import { el, fill, section, svg } from "./dom.js";
import { instant, quantity } from "./format.js";

export class KeyFrames {
  constructor(live) {
    Object.assign(this, { live, frames: [] });
    this.at = el("input", { type: "number", min: 0, step: "any", value: 0, "aria-label": "time of the key frame in s", class: "component" });
    this.samples = el("input", { type: "number", min: 2, max: 2001, step: 1, value: 201, "aria-label": "samples", class: "component" });
    this.line = el("div", { class: "timeline" });
    this.list = el("div", {});
    this.worst = el("table", { class: "numbers" });
    this.play = el("button", { type: "button", onclick: () => this.run() }, "Run");
    this.back = el("button", { type: "button", hidden: true, onclick: () => this.live.ask({ do: "show" }) }, "Back to the sliders");
    this.setter = el("div", { class: "row" }, "at", this.at, "s", el("button", { type: "button", onclick: () => this.set() }, "Set key frame here"));
    this.node = section("Motion through key frames", this.setter, this.line, this.list, el("div", { class: "row" }, this.play, this.samples, "samples", this.back), this.worst);
    this.show();
  }

  /** The present pose as a key frame at the time in the field; one that is there is replaced. */
  set() {
    const time = Math.max(0, this.at.valueAsNumber || 0);
    this.frames = this.frames.filter((one) => Math.abs(one.time - time) > 1e-6);
    this.frames.push({ time, values: { ...this.live.controls.last.values } });
    this.frames.sort((a, b) => a.time - b.time);
    this.next();
    this.keep();
  }

  remove(frame) {
    this.frames = this.frames.filter((one) => one !== frame);
    this.keep();
  }

  /** The field shows a time after the last key frame. */
  next() {
    this.at.value = this.frames.length ? Number((this.frames[this.frames.length - 1].time + 1).toFixed(6)) : 0;
  }

  /** Key frames that the studio has kept. */
  take(frames) {
    this.frames = frames;
    this.next();
    this.show();
  }

  /** Show the key frames; the studio keeps them. */
  keep() {
    this.show();
    if (this.live.page) this.live.ask({ do: "frames", frames: this.frames });
  }

  /** Only drives that are still there. */
  told() {
    const known = new Set((this.live.setup?.drives || []).map((one) => one.name));
    return this.frames.map(({ time, values }) => ({ time, values: Object.fromEntries(Object.entries(values).filter(([name]) => known.has(name))) }));
  }

  show() {
    const end = this.frames.length ? this.frames[this.frames.length - 1].time : 0;
    this.play.disabled = this.frames.length < 2;
    const marks = this.frames.map(({ time }) => svg("circle", { cx: 8 + (284 * time) / (end || 1), cy: 12, r: 6 }));
    fill(this.line, this.frames.length ? svg("svg", { viewBox: "0 0 300 24", role: "img", "aria-label": `${this.frames.length} key frames over ${end} s` }, svg("line", { x1: 8, y1: 12, x2: 292, y2: 12 }), marks) : null);
    fill(this.list, this.frames.map((frame) => el("div", { class: "row" }, el("button", { type: "button", title: "Go there", onclick: () => this.live.move(frame.values) }, instant(frame.time)),
      el("button", { type: "button", title: "Remove this key frame", "aria-label": `remove the key frame at ${frame.time} s`, onclick: () => this.remove(frame) }, "×"))));
  }

  async run() {
    this.play.disabled = true;
    this.live.controls.tell("Running ...");
    await this.live.ask({ do: "run", frames: this.told(), samples: Math.round(this.samples.valueAsNumber || 201) });
    this.play.disabled = this.frames.length < 2;
  }

  /** A run is shown: its worst instants, each a way there. */
  running(run) {
    for (const part of [this.setter, this.line, this.list]) part.hidden = Boolean(run);
    this.back.hidden = !run;
    if (run) this.live.controls.tell("");
    fill(this.worst, run ? [el("tr", {}, ["worst", "member", "value", "of limit", "at"].map((words) => el("th", {}, words))), ...run.worst.map((row) => this.row(row))] : []);
  }

  row(row) {
    const go = () => {
      const { app } = this.live;
      app.pause();
      if (app.views[0].scene.cases.includes(row.case)) app.setCase(row.case);
      if (row.time !== null) app.goTo(app.lead.frameAt(row.time));
      if (row.member) app.pick({ type: "member", name: row.member });
    };
    const value = row.value === null ? "-" : quantity(row.value, row.unit);
    return el("tr", {}, el("th", {}, el("button", { type: "button", class: "link", onclick: go }, row.what)), el("td", {}, row.member), el("td", {}, value),
      el("td", {}, usedText(row.used)), el("td", {}, row.time === null ? "" : instant(row.time)));
  }
}

/** Share of a limit. */
function usedText(used) {
  if (used === null) return "";
  return quantity(used === "Infinity" ? Infinity : used, "%");
}
