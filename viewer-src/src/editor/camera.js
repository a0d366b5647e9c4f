// Where things are on the screen: a parallel projection, a work plane to draw in, and what a point snaps to.

import { niceStep } from "../format.js";

const AXES = "xyz";
const FLAT = { azimuth: -Math.PI / 2, elevation: Math.PI / 2 };
const LOOKS = { corner: [-0.95, 0.5], top: [-Math.PI / 2, Math.PI / 2], front: [-Math.PI / 2, 0], side: [0, 0] };
const ALIGN = 8; // pixels within which a point is in line with a node
const PIXELS = 44; // least distance of grid lines

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** A number without the rounding of its sum: 0.30000000000000004 is 0.3. */
export const clean = (value) => Number(value.toPrecision(12)) || 0;

export class Camera {
  constructor() {
    Object.assign(this, { dim: 2, centre: [0, 0, 0], scale: 200, width: 600, height: 400, plane: { axis: 2, at: 0 }, step: null });
    this.turnTo(FLAT.azimuth, FLAT.elevation);
  }

  setDim(dim) {
    if (dim === this.dim) return;
    this.dim = dim;
    this.plane = { axis: 2, at: 0 };
    const [azimuth, elevation] = dim === 3 ? LOOKS.corner : [FLAT.azimuth, FLAT.elevation];
    this.turnTo(azimuth, elevation);
  }

  turnTo(azimuth, elevation) {
    this.azimuth = azimuth;
    this.elevation = Math.min(Math.max(elevation, -Math.PI / 2), Math.PI / 2);
    const [ca, sa, ce, se] = [Math.cos(azimuth), Math.sin(azimuth), Math.cos(this.elevation), Math.sin(this.elevation)].map((value) => (Math.abs(value) < 1e-15 ? 0 : value));
    this.right = [-sa, ca, 0];
    this.up = [-se * ca, -se * sa, ce];
    this.toward = [ce * ca, ce * sa, se];
  }

  turn(across, upward) {
    if (this.dim === 3) this.turnTo(this.azimuth + across, this.elevation + upward);
  }

  look(name) {
    this.turnTo(...LOOKS[name]);
  }

  /** Look straight at the work plane. */
  face() {
    this.look({ x: "side", y: "front", z: "top" }[AXES[this.plane.axis]]);
  }

  pan(dx, dy) {
    this.centre = this.centre.map((value, k) => value - (dx * this.right[k] - dy * this.up[k]) / this.scale);
  }

  /** Approach by a factor; what is at a place of the screen stays there. */
  zoom(factor, [x, y] = [this.width / 2, this.height / 2]) {
    const [dx, dy] = [x - this.width / 2, y - this.height / 2];
    this.pan(-dx, -dy);
    this.scale = Math.min(Math.max(this.scale * factor, 1e-3), 1e7);
    this.pan(dx, dy);
  }

  /** Show all points, or a field of one metre without any. */
  fit(points) {
    if (!points.length) {
      Object.assign(this, { centre: [0, 0, 0], scale: Math.min(this.width, this.height) / 1.2 });
      return;
    }
    this.centre = [0, 1, 2].map((k) => (Math.min(...points.map((p) => p[k] || 0)) + Math.max(...points.map((p) => p[k] || 0))) / 2);
    this.scale = 1;
    const seen = points.map((p) => this.project(p));
    const spans = [0, 1].map((k) => Math.max(...seen.map((p) => p[k])) - Math.min(...seen.map((p) => p[k])));
    this.scale = Math.min((0.62 * this.width) / (spans[0] || 1e-9), (0.62 * this.height) / (spans[1] || 1e-9), 1e5);
    if (points.length === 1) this.scale = Math.min(this.width, this.height) / 1.2;
  }

  project(point) {
    const from = [0, 1, 2].map((k) => (point[k] || 0) - this.centre[k]);
    return [this.width / 2 + this.scale * dot(from, this.right), this.height / 2 - this.scale * dot(from, this.up), dot(from, this.toward)];
  }

  /** The point of the work plane (or of a parallel one) at a place of the screen; null where the plane is seen edge-on. */
  unproject([x, y], at = this.plane.at) {
    const [dx, dy] = [(x - this.width / 2) / this.scale, (this.height / 2 - y) / this.scale];
    const base = this.centre.map((value, k) => value + dx * this.right[k] + dy * this.up[k]);
    const { axis } = this.plane;
    if (Math.abs(this.toward[axis]) < 0.08) return null;
    const far = (at - base[axis]) / this.toward[axis];
    return base.map((value, k) => (k === axis ? at : value + far * this.toward[k]));
  }

  /** What the view depends on, as a text. */
  get key() {
    return [this.scale, ...this.centre, this.azimuth, this.elevation, this.width, this.height, this.plane.axis, this.plane.at].join();
  }

  /** The step of the grid, m. */
  get grid() {
    const step = niceStep(PIXELS / this.scale);
    return this.step || (step * this.scale < 0.6 * PIXELS ? niceStep(2.5 * step) : step);
  }

  /** The nearest point of the grid in the work plane, or in line with a node that is nearer. */
  snapped(point, places = []) {
    return point.map((value, k) => {
      if (k === this.plane.axis) return value;
      const own = clean(Math.round(value / this.grid) * this.grid);
      const near = places.reduce((best, place) => (Math.abs((place[k] || 0) - value) < Math.abs(best - value) ? place[k] || 0 : best), Infinity);
      return Math.abs(near - value) * this.scale < ALIGN && Math.abs(near - value) < Math.abs(own - value) ? near : own;
    });
  }

  /** The two axes of the work plane. */
  get across() {
    return [0, 1, 2].filter((k) => k !== this.plane.axis);
  }
}
