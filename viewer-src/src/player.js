// Plays the samples of a motion in time: to its end, there and back, or round and round.

import { speedsOf, usualSpeed } from "./timebar.js";

/** The sample nearest to a time. */
export function sampleAt(times, time) {
  let low = 0, high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return Math.abs(times[high] - time) < Math.abs(time - times[low]) ? high : low;
}

/** `lead` has the samples' `time` and `frames`; `goTo` shows one, `time` is the bar with the button. */
export class Player {
  constructor() {
    Object.assign(this, { index: 0, playing: false, speed: 1, way: "once", back: false });
  }

  /** Samples to play, at the speed at which they take some seconds. */
  setLead(lead) {
    this.lead = lead;
    Object.assign(this, { speeds: speedsOf(this.duration), speed: usualSpeed(this.duration) });
  }

  get duration() {
    return this.lead.time[this.lead.frames - 1] - this.lead.time[0];
  }

  step(count) {
    this.pause();
    this.goTo(this.index + count);
  }

  togglePlay() {
    if (this.lead.frames < 2) return;
    this.playing = !this.playing;
    if (this.playing && this.way !== "back" && this.index === this.lead.frames - 1) this.goTo(0);
    this.start();
    this.time.update();
    if (this.playing) requestAnimationFrame((now) => this.tick(now));
  }

  pause() {
    this.playing = false;
    this.time.update();
  }

  /** Go on from the sample shown. */
  start() {
    const passed = this.lead.time[this.index] - this.lead.time[0];
    this.clock = { at: performance.now(), from: this.back && this.way === "back" ? 2 * this.duration - passed : passed };
  }

  /** Show a sample, and go on from there. */
  seek(index) {
    this.goTo(index);
    this.start();
  }

  setWay(way) {
    Object.assign(this, { way, back: false });
    this.start();
  }

  tick(now) {
    if (!this.playing) return;
    const { duration, way } = this, whole = way === "back" ? 2 * duration : duration;
    let passed = this.clock.from + (this.speed * (now - this.clock.at)) / 1000;
    const over = way === "once" && passed >= duration;
    if (way !== "once") passed %= whole;
    this.back = way === "back" && passed > duration;
    const index = sampleAt(this.lead.time, this.lead.time[0] + (this.back ? whole - passed : passed));
    if (index !== this.index) this.goTo(index);
    if (over) this.pause();
    else requestAnimationFrame((next) => this.tick(next));
  }

  setSpeed(speed) {
    this.speed = speed;
    this.start();
    this.time.update();
  }

  faster(by) {
    const at = this.speeds.indexOf(this.speed) + by;
    this.setSpeed(this.speeds[Math.min(Math.max(at, 0), this.speeds.length - 1)]);
  }
}
