// Bars and nodes of one scene: where they are, what colour they have.

import { BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments } from "three";
import { KINDS } from "./display.js";
import { cylinder, moved, placeAlong, placeSphere, spheres } from "./shapes.js";

const COLLAR = new Color(KINDS.driven);
const BAND = new Color("#cc79a7");

/** How thick each member is drawn, m: its section, but never too thin to be seen. */
export function radiiOf(scene) {
  const least = 0.011 * scene.length0, most = 0.05 * scene.length0;
  return Float32Array.from(scene.arrays.radius.data, (r) => Math.min(most, Math.max(least, r || 0)));
}

/** Instances of bars, of the collars and bands that tell kinds apart, and of nodes. */
export class Bars {
  constructor(scene) {
    this.scene = scene;
    this.radius = radiiOf(scene);
    const large = scene.members.length > 800;
    this.pieces = scene.members.flatMap((_, member) =>
      scene.active.has(member) ? [[member, "base"], [member, "tube"], [member, "screw"]] : [[member, scene.header.kinds[member]]]);
    this.firstPiece = [];
    this.pieces.forEach(([member], k) => (this.firstPiece[member] ??= k));
    this.marks = scene.members.flatMap((_, member) => marksOf(scene, member));
    this.rods = cylinder(this.pieces.length, large ? 6 : 14);
    this.collars = cylinder(this.marks.length, large ? 6 : 18);
    this.balls = spheres(scene.nodes.length, large ? 1 : 3, "#ffffff");
    this.small = smallNodes(scene);
    this.lines = axisLines(scene.members.length);
    this.ball = 1.55 * this.radius.reduce((least, r) => Math.min(least, r), 0.02 * scene.length0);
    const white = new Color("#ffffff");
    for (let k = 0; k < this.pieces.length; k++) this.rods.setColorAt(k, white);
    this.marks.forEach((mark, k) => this.collars.setColorAt(k, mark.colour));
    this.paintNodes("#5b6672");
  }

  objects() {
    return [this.rods, this.collars, this.balls, this.lines];
  }

  /** Move everything to positions (n, 3 as arrays). */
  place(points) {
    const { scene, radius } = this;
    const rods = scene.arrays.rods.data;
    this.pieces.forEach(([member, role], k) => {
      const p = points[scene.ends[2 * member]], q = points[scene.ends[2 * member + 1]];
      const r = scene.shows(member) ? radius[member] : 0;
      if (role === "base") placeAlong(this.rods, k, p, along(p, q, Math.min(rods[6 * member + 1], distance(p, q))), 0.75 * r);
      else if (role === "tube") placeAlong(this.rods, k, along(q, p, Math.min(rods[6 * member + 4], distance(p, q))), q, 1.5 * r);
      else placeAlong(this.rods, k, p, q, role === "free" || role === "screw" || role === "cable" ? 0.35 * r : role === "elastic" ? 0.7 * r : r);
    });
    this.marks.forEach((mark, k) => {
      const p = points[scene.ends[2 * mark.member]], q = points[scene.ends[2 * mark.member + 1]];
      const L = distance(p, q), r = radius[mark.member];
      const at = mark.nut ? Math.max(0, L - rods[6 * mark.member + 4]) : mark.place * L;
      const half = mark.half * r;
      placeAlong(this.collars, k, along(p, q, at - half), along(p, q, at + half), mark.width * r);
    });
    points.forEach((point, k) => placeSphere(this.balls, k, point, this.ball * this.small[k]));
    const line = this.lines.geometry.attributes.position;
    // a bar of a frame is a line without length
    scene.ends.forEach((node, k) => line.array.set(points[scene.shows(k >> 1) ? node : scene.ends[k & ~1]], 3 * k));
    line.needsUpdate = true;
    [this.rods, this.collars, this.balls].forEach(moved);
  }

  /** Colours of all members; `of(member)` gives an sRGB triple 0..255. */
  paint(of) {
    const colour = new Color(), line = this.lines.geometry.attributes.color;
    this.pieces.forEach(([member], k) => {
      const [r, g, b] = of(member);
      this.rods.setColorAt(k, colour.setRGB(r / 255, g / 255, b / 255, "srgb"));
      for (const end of [0, 1]) colour.toArray(line.array, 6 * member + 3 * end);
    });
    line.needsUpdate = true;
    if (this.rods.instanceColor) this.rods.instanceColor.needsUpdate = true;
  }

  paintNodes(hex) {
    const colour = new Color(hex);
    for (let k = 0; k < this.scene.nodes.length; k++) this.balls.setColorAt(k, colour);
    if (this.balls.instanceColor) this.balls.instanceColor.needsUpdate = true;
  }

  /** The sRGB colour a member has now, 0..255. */
  colourOf(member) {
    const colour = new Color();
    this.rods.getColorAt(this.firstPiece[member], colour);
    const { r, g, b } = colour.getRGB({ r: 0, g: 0, b: 0 }, "srgb");
    return [r, g, b].map((value) => Math.round(255 * value));
  }
}

/** Size of each node's ball: nodes of a mesh that no member joins are small, or nothing where they are many. */
function smallNodes(scene) {
  const found = new Float32Array(scene.nodes.length).fill(1), joined = new Set(scene.ends), mesh = new Set(scene.skin);
  for (const node of mesh) if (!joined.has(node)) found[node] = mesh.size > 300 ? 0 : 0.6;
  for (const node of scene.directors) found[node] = 0;
  return found;
}

/** Lines along the members, one pixel wide: seen from afar they stay when the bars are too thin to hit a pixel. */
function axisLines(count) {
  const geometry = new BufferGeometry();
  for (const name of ["position", "color"]) geometry.setAttribute(name, new BufferAttribute(new Float32Array(6 * count), 3));
  const lines = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true }));
  lines.frustumCulled = false;
  return lines;
}

/** Collar of an actuator (at the nut, or in the middle of a driven bar), bands of a spring. */
function marksOf(scene, member) {
  if (scene.active.has(member)) return [{ member, nut: true, half: 1.6, width: 2.2, colour: COLLAR }];
  const kind = scene.header.kinds[member];
  if (kind === "driven") return [{ member, place: 0.5, half: 2.2, width: 1.8, colour: COLLAR }];
  if (kind !== "elastic") return [];
  return [0.3, 0.4, 0.5, 0.6, 0.7].map((place) => ({ member, place, half: 0.3, width: 1.7, colour: BAND }));
}

export function distance(p, q) {
  return Math.hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
}

/** The point at a distance from p towards q. */
export function along(p, q, size) {
  const f = size / (distance(p, q) || 1);
  return [p[0] + f * (q[0] - p[0]), p[1] + f * (q[1] - p[1]), p[2] + f * (q[2] - p[2])];
}
