// Play, pause, step and speed.

import { el } from "./dom.js";
import { number } from "./format.js";

const SHORT = 0.5, LONG = 120, EASY = 6; // s: what plays faster or slower than can be followed, and how long it then takes

/** Speeds to choose from: those at which a run takes a second to some minutes, and real time. */
export function speedsOf(duration) {
  const found = new Set([0.1, 0.25, 0.5, 1, 2, 4, 10]);
  for (let power = -12; power <= 12; power++) {
    for (const factor of [1, 2, 5]) {
      const speed = Number(`${factor}e${power}`), takes = duration / speed;
      if ((speed < 0.1 || speed > 10) && takes >= 1 && takes <= 100) found.add(speed);
    }
  }
  return [...found].sort((a, b) => a - b);
}

/** Real time; of a run too short or too long for it the speed at which it takes some seconds. */
export function usualSpeed(duration) {
  if (!(duration > 0) || (duration >= SHORT && duration <= LONG)) return 1;
  return speedsOf(duration).reduce((best, speed) => (Math.abs(Math.log(duration / speed / EASY)) < Math.abs(Math.log(duration / best / EASY)) ? speed : best));
}

export class TimeBar {
  constructor(app) {
    this.app = app;
    this.button = el("button", { type: "button", class: "play", title: "Play or pause (space)", onclick: () => app.togglePlay() }, "▶");
    this.slider = el("input", { type: "range", min: 0, max: Math.max(app.lead.frames - 1, 0), step: 1, value: 0, "aria-label": "time", oninput: () => app.goTo(Number(this.slider.value)) });
    this.readout = el("output", { class: "time" });
    this.speed = el("select", { "aria-label": "speed", title: "Speed (+ and −)", onchange: () => app.setSpeed(Number(this.speed.value)) },
      app.speeds.map((one) => el("option", { value: one, selected: one === app.speed }, `${one}×`)));
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
