// A motion of the drives as the studio sends it: names and words, and numbers over time, each sample as the drawing shows it.

import { opened } from "../talk.js";
import { movingNodes } from "../traces.js";

const BEYOND = 8; // times the median of the largest: what is above it, near a dead point, is cut off
const TURN = 2 * Math.PI;

/** The largest value that a scale shows: without those that grow beyond all bounds near a dead point. */
export function usual(sizes) {
  const known = sizes.filter((size) => Number.isFinite(size) && size > 0).sort((a, b) => a - b);
  return known.length ? Math.min(known.at(-1), BEYOND * known[known.length >> 1]) : 0;
}

const finite = (value) => (Number.isFinite(value) ? value : null);

export class Sweep {
  constructor(buffer) {
    const [header, body] = opened(buffer);
    Object.assign(this, header, { header: { supports: [] }, skin: [], directors: [], arrays: {} });
    let at = body.byteOffset;
    for (const [name, shape] of Object.entries(header.arrays)) {
      const data = new Float32Array(buffer, at, shape.reduce((a, b) => a * b, 1));
      this.arrays[name] = { data, shape };
      at += data.byteLength;
    }
    this.time = this.arrays.time.data;
    this.frames = this.time.length;
    [, , this.dim] = this.arrays.position.shape;
    this.columns = new Map(this.members.map((name, k) => [name, k]));
    const { data } = this.arrays.position;
    const [low, high] = [Math.min, Math.max].map((most) => Array.from({ length: this.dim }, (_, i) => data.reduce((best, value, k) => (k % this.dim === i ? most(best, value) : best), data[i])));
    this.extent = { size: Math.hypot(...high.map((value, i) => value - low[i])) };
    this.moving = movingNodes(this);
    this.largest = usual(Array.from({ length: this.frames }, (_, k) => Math.max(0, ...this.row("member_force", k).map(Math.abs).filter(Number.isFinite))));
    this.judge();
    this.lead = this.drives.findIndex(({ name }) => name === this.swept[0]);
  }

  /** The largest utilisation, and members that are checked in no pose. */
  judge() {
    const { data } = this.arrays.used || { data: [] }, count = this.judged?.length;
    this.most = data.reduce((best, value, k) => (value > (best?.value ?? -1) ? { value, member: this.judged[k % count], sample: Math.floor(k / count) } : best), null);
    this.never = (this.judged || []).filter((_, i) => Array.from({ length: this.frames }, (_, k) => data[k * count + i]).every(Number.isNaN));
  }

  /** Utilisation of each member that is checked at a sample; null if the strength was not asked for. */
  used(k) {
    if (!this.judged) return null;
    const row = this.judged.length ? this.row("used", k) : [];
    return Object.fromEntries(this.judged.map((name, i) => [name, row[i]]).filter(([, value]) => Number.isFinite(value)));
  }

  /** The values of a sample of an array, as one row. */
  row(name, k) {
    const { data } = this.arrays[name], size = data.length / this.frames;
    return Array.from(data.subarray(k * size, (k + 1) * size));
  }

  /** A history above its least value. */
  above(name) {
    const { data } = this.arrays[name], least = data.reduce((a, b) => Math.min(a, b));
    return Array.from(data, (value) => value - least);
  }

  position(k, node) {
    const { data } = this.arrays.position, at = (k * this.nodes.length + node) * this.dim;
    return [data[at], data[at + 1], this.dim === 3 ? data[at + 2] : 0];
  }

  /** Whether it moves by itself and not by its drives: then it is told along time. */
  get falls() {
    return !this.swept.length;
  }

  get unit() {
    return this.falls ? "s" : this.drives[this.lead].unit;
  }

  /** The value of a drive, after whole turns as an angle from 0; without one the time. */
  value(k, drive = this.lead) {
    if (drive < 0) return this.time[k];
    const value = this.arrays.drive_position.data[k * this.drives.length + drive];
    return this.whole && this.drives[drive].unit === "rad" ? ((value % TURN) + TURN) % TURN : value;
  }

  held(k, drive = this.lead) {
    return drive < 0 ? NaN : this.arrays.drive_force.data[k * this.drives.length + drive];
  }

  /** The fields of the state of a drawing that a sample changes. */
  shown(k, state) {
    const force = this.row("member_force", k);
    const on = (name) => {
      if (!this.arrays[name]) return {};
      const values = this.row(name, k).map(finite), size = values.length / this.supports.length;
      const rows = this.supports.map((support, i) => [support, values.slice(i * size, (i + 1) * size)]);
      return Object.fromEntries(name === "reaction" ? rows : rows.filter(([support]) => this.moments.includes(support)));
    };
    return {
      places: this.nodes.map((_, node) => this.position(k, node).slice(0, this.dim)),
      force: state.members.map(({ name }) => finite(force[this.columns.get(name)])),
      reaction: on("reaction"),
      reaction_moment: on("reaction_moment"),
      drives: state.drives.map((one) => {
        const d = this.drives.findIndex(({ name }) => name === one.name);
        return { ...one, value: this.value(k, d), force: finite(this.held(k, d)) };
      }),
      unsure: this.unsure,
      used: this.used(k),
    };
  }

  /** The angle from one node to another along all samples without jumps: least and largest, rad. */
  swing(from, to) {
    let [low, high, last] = [Infinity, -Infinity, null];
    for (let k = 0; k < this.frames; k++) {
      const [a, b] = [this.position(k, from), this.position(k, to)];
      let angle = Math.atan2(b[1] - a[1], b[0] - a[0]);
      if (last !== null) angle += TURN * Math.round((last - angle) / TURN);
      last = angle;
      low = Math.min(low, angle);
      high = Math.max(high, angle);
    }
    const round = TURN * Math.floor((low + Math.PI) / TURN);
    return [low - round, high - round];
  }
}
