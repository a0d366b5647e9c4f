// Bars and nodes of one scene: where they are, what colour they have.

import { BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments } from "three";
import { ELASTIC, KINDS } from "./display.js";
import { piecesOf } from "./beams.js";
import { axesOf } from "./mechanics.js";
import { boxes, cylinder, moved, placeAlong, placeBox, placeSphere, spheres } from "./shapes.js";
import { Rims, withHatch } from "./surface.js";

const COLLAR = new Color(KINDS.driven);
const FINE = 0.3; // CSS pixels, radius of a bar below which it is a line
const BAND = new Color(ELASTIC);

/** How thick each member is drawn, m: its section, but never too thin to be seen. */
export function radiiOf(scene) {
  const least = 0.011 * scene.length0, most = 0.05 * scene.length0;
  return Float32Array.from(scene.arrays.radius.data, (r) => Math.min(most, Math.max(least, r || 0)));
}

/** Half height and width of each member drawn as a rectangle, m, as much enlarged as its radius; null for round ones. */
function boxesOf(scene, radius) {
  const sizes = scene.arrays.box?.data;
  return scene.members.map((_, member) => {
    const half = sizes ? [sizes[2 * member], sizes[2 * member + 1]] : [NaN];
    if (!half.every((x) => x > 0) || scene.active.has(member)) return null;
    const factor = radius[member] / Math.max(...half);
    return half.map((x) => Math.max(factor * x, 0.2 * radius[member]));
  });
}

/** Instances of bars, of the collars and bands that tell kinds apart, and of nodes. */
export class Bars {
  constructor(scene) {
    this.scene = scene;
    this.radius = radiiOf(scene);
    const large = scene.members.length > 800;
    this.pieces = scene.members.flatMap((_, member) => {
      if (scene.active.has(member)) return [[member, "base"], [member, "tube"], [member, "screw"]];
      if (scene.curves.row.has(member)) return Array.from({ length: scene.curves.places - 1 }, (_, k) => [member, "beam", k]);
      return [[member, scene.header.kinds[member]]];
    });
    this.box = boxesOf(scene, this.radius);
    const flat = this.pieces.filter(([member]) => this.box[member]), round = this.pieces.filter(([member]) => !this.box[member]);
    this.pieces = [...round, ...flat]; // rods first, then boxes
    this.round = round.length;
    this.firstPiece = [];
    this.pieces.forEach(([member], k) => (this.firstPiece[member] ??= k));
    this.marks = scene.members.flatMap((_, member) => marksOf(scene, member));
    this.rods = withHatch(cylinder(round.length, large ? 6 : 14));
    this.boxes = withHatch(boxes(flat.length));
    this.collars = cylinder(this.marks.length, large ? 6 : 18);
    this.balls = spheres(scene.nodes.length, large ? 1 : 3, "#ffffff");
    this.small = smallNodes(scene);
    this.lines = axisLines(this.pieces.length);
    this.ball = 1.55 * this.radius.reduce((least, r) => Math.min(least, r), 0.02 * scene.length0);
    const white = new Color("#ffffff");
    this.pieces.forEach((_, k) => this.at(k).mesh.setColorAt(this.at(k).index, white));
    this.marks.forEach((mark, k) => this.collars.setColorAt(k, mark.colour));
    this.paintNodes("#5b6672");
    this.rims = new Rims([this.rods, this.boxes, this.collars, this.balls], [this.rods, this.boxes]);
  }

  objects() {
    return [this.rods, this.boxes, this.collars, this.balls, this.lines, ...this.rims.meshes];
  }

  /** The mesh of a piece and its place in it. */
  at(k) {
    return k < this.round ? { mesh: this.rods, index: k } : { mesh: this.boxes, index: k - this.round };
  }

  /** Colours of nodes, rims and hatching. */
  setTheme({ node, outline, back }) {
    this.paintNodes(node);
    this.rims.setColour(outline);
    for (const { material } of [this.rods, this.boxes]) material.userData.stripe.value.set(back);
  }

  /** radius : of the usual bar, CSS pixels: of bars that are thinner than a pixel only the coloured lines along them are drawn. */
  setScale(radius) {
    this.rims.setScale(radius);
    const near = radius > FINE;
    for (const mesh of [this.rods, this.boxes, this.collars, this.balls, ...this.rims.meshes]) mesh.visible = near;
  }

  resize(width, height) {
    this.rims.resize(width, height);
  }

  /** Move everything to positions (n, 3 as arrays) at a frame. */
  place(points, frame) {
    const { scene, radius } = this;
    const rods = scene.arrays.rods.data;
    const line = this.lines.geometry.attributes.position, curves = new Map();
    for (const member of scene.curves.row.keys()) curves.set(member, { pieces: joined(piecesOf(scene.curves.points(points, member)), 0.3 * radius[member]), across: scene.curves.across(points, member) });
    this.pieces.forEach(([member, role, part], k) => {
      const [p, q] = curves.get(member)?.pieces[part] || [points[scene.ends[2 * member]], points[scene.ends[2 * member + 1]]];
      const r = scene.shows(member) ? radius[member] : 0;
      // a bar of a frame is a line without length
      line.array.set(p, 6 * k);
      line.array.set(r ? q : p, 6 * k + 3);
      if (k >= this.round && r) placeBox(this.boxes, k - this.round, p, q, curves.get(member)?.across[part] || axesOf(scene, frame, member).axes[1], this.box[member]);
      else if (role === "base") placeAlong(this.rods, k, p, along(p, q, Math.min(rods[6 * member + 1], distance(p, q))), 0.75 * r);
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
    line.needsUpdate = true;
    [this.rods, this.boxes, this.collars, this.balls].forEach(moved);
  }

  /** Colours of all members; `of(member)` gives an sRGB triple 0..255, `hatched(member)` whether it is striped. */
  paint(of, hatched) {
    const colour = new Color(), line = this.lines.geometry.attributes.color;
    this.pieces.forEach(([member], k) => {
      const [r, g, b] = of(member), { mesh, index } = this.at(k);
      mesh.setColorAt(index, colour.setRGB(r / 255, g / 255, b / 255, "srgb"));
      mesh.geometry.attributes.hatch.array[index] = hatched(member) ? 1 : 0;
      for (const end of [0, 1]) colour.toArray(line.array, 6 * k + 3 * end);
    });
    line.needsUpdate = true;
    for (const mesh of [this.rods, this.boxes]) {
      mesh.geometry.attributes.hatch.needsUpdate = true;
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }

  /** Whether a member is striped now. */
  hatchOf(member) {
    const { mesh, index } = this.at(this.firstPiece[member]);
    return mesh.geometry.attributes.hatch.array[index] === 1;
  }

  paintNodes(hex) {
    const colour = new Color(hex);
    for (let k = 0; k < this.scene.nodes.length; k++) this.balls.setColorAt(k, colour);
    if (this.balls.instanceColor) this.balls.instanceColor.needsUpdate = true;
  }

  /** The sRGB colour a member has now, 0..255. */
  colourOf(member) {
    const colour = new Color(), { mesh, index } = this.at(this.firstPiece[member]);
    mesh.getColorAt(index, colour);
    const { r, g, b } = colour.getRGB({ r: 0, g: 0, b: 0 }, "srgb");
    return [r, g, b].map((value) => Math.round(255 * value));
  }
}

/** Pieces of a curve a little longer where they meet, so that nothing is seen between them. */
function joined(pieces, size) {
  return pieces.map(([p, q], k) => [k ? along(p, q, -size) : p, k < pieces.length - 1 ? along(q, p, -size) : q]);
}

/** Size of each node's ball: nodes of a mesh that no member joins are small, or nothing where they are many. */
function smallNodes(scene) {
  const found = new Float32Array(scene.nodes.length).fill(1), joined = new Set(scene.ends), mesh = new Set(scene.skin);
  for (const node of mesh) if (!joined.has(node)) found[node] = mesh.size > 300 ? 0 : 0.6;
  for (const node of scene.directors) found[node] = 0;
  return found;
}

/** Lines along the pieces of members, one pixel wide: seen from afar they stay when the bars are too thin to hit a pixel. */
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
