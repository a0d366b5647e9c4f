// Play, pause, step and speed.

import { el } from "./dom.js";
import { number } from "./format.js";

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4, 10];

export class TimeBar {
  constructor(app) {
    this.app = app;
    this.button = el("button", { type: "button", class: "play", title: "Play or pause (space)", onclick: () => app.togglePlay() }, "▶");
    this.slider = el("input", { type: "range", min: 0, max: Math.max(app.lead.frames - 1, 0), step: 1, value: 0, "aria-label": "time", oninput: () => app.goTo(Number(this.slider.value)) });
    this.readout = el("output", { class: "time" });
    this.speed = el("select", { "aria-label": "speed", title: "Speed (+ and −)", onchange: () => app.setSpeed(Number(this.speed.value)) },
      SPEEDS.map((one) => el("option", { value: one, selected: one === 1 }, `${one}×`)));
    this.node = el("footer", { class: "timebar" }, this.button, this.slider, this.readout, this.speed);
    this.node.hidden = app.lead.frames < 2;
  }

  update() {
    const { app } = this;
    const time = app.lead.time[app.index], end = app.lead.time[app.lead.frames - 1];
    const digits = Math.max(4, Math.ceil(Math.log10(app.lead.frames)) + 1);
    this.slider.value = app.index;
    this.slider.setAttribute("aria-valuetext", `${number(time, digits)} s of ${number(end, digits)} s`);
    this.readout.textContent = `${number(time, digits)} s`;
    this.button.textContent = app.playing ? "❚❚" : "▶";
    this.button.setAttribute("aria-label", app.playing ? "pause" : "play");
    this.speed.value = String(app.speed);
  }
}
