// Play, pause, step and speed.

import { el } from "./dom.js";
import { number } from "./format.js";

const SPEEDS = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];
const ROUND = [1, 1.5, 2, 3, 4, 6, 8];
const LEAST = 5, MOST = 8; // s that a run takes at its own speed

/** The round speed at which a run takes 5 to 8 s, whether it is as short as a blink or as long as an hour. */
export function usualSpeed(duration) {
  if (!(duration > 0) || !Number.isFinite(duration)) return 1;
  const power = Math.floor(Math.log10(duration / MOST));
  const round = [...ROUND, ...ROUND.map((one) => 10 * one)].map((one) => Number(`${one}e${power}`));
  return round.find((speed) => duration / speed <= MOST && duration / speed >= LEAST) || 1;
}

/** Speeds to choose from: 0.001 to 10 times real time, and the one at which the run takes some seconds. */
export function speedsOf(duration) {
  return [...new Set([...SPEEDS, usualSpeed(duration)])].sort((a, b) => a - b);
}

/** app : a `Player`; `said`, if it has one, tells where it is in other words than the time. */
export class TimeBar {
  constructor(app) {
    this.app = app;
    const time = app.lead.time, duration = time[app.lead.frames - 1] - time[0], usual = usualSpeed(duration);
    const words = (one) => `${number(one)}×${one === usual && duration > 0 ? ` (${number(duration / one, 2)} s)` : ""}`;
    this.button = el("button", { type: "button", class: "play", title: app.hint("Play or pause", "space"), onclick: () => app.togglePlay() }, "▶");
    this.slider = el("input", { type: "range", min: 0, max: Math.max(app.lead.frames - 1, 0), step: 1, value: 0, "aria-label": "time", oninput: () => app.seek(Number(this.slider.value)) });
    this.readout = el("output", { class: "time" });
    this.speed = el("select", { "aria-label": "speed", title: app.hint("Speed", "+ and -"), onchange: () => app.setSpeed(Number(this.speed.value)) },
      app.speeds.map((one) => el("option", { value: one, selected: one === app.speed }, words(one))));
    this.node = el("footer", { class: "timebar" }, this.button, this.slider, this.readout, this.speed);
    this.node.hidden = app.lead.frames < 2;
  }

  update() {
    const { app } = this;
    const time = app.lead.time[app.index], end = app.lead.time[app.lead.frames - 1];
    const digits = Math.max(4, Math.ceil(Math.log10(app.lead.frames)) + 1);
    this.slider.value = app.index;
    this.slider.setAttribute("aria-valuetext", app.said?.() ?? `${number(time, digits)} s of ${number(end, digits)} s`);
    this.readout.textContent = app.said?.() ?? `${number(time, digits)} s`;
    this.button.textContent = app.playing ? "❚❚" : "▶";
    this.button.setAttribute("aria-label", app.playing ? "pause" : "play");
    this.speed.value = String(app.speed);
  }
}
