// Supports, loads, drives, centres of mass, the ground grid and the ghost of one scene.

import {
  BufferAttribute, BufferGeometry, DoubleSide, GridHelper, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshLambertMaterial, Quaternion, Vector3,
} from "three";
import { piecesOf } from "./beams.js";
import { KINDS, LOAD } from "./display.js";
import { niceStep } from "./format.js";
import { edgesOf } from "./skins.js";
import { arrow, cones, cylinder, moved, placeAlong, placeArrow, placeSphere, ring, spheres } from "./shapes.js";
import { symbolAt, symbolSize } from "./supports.js";

const DRIVE = KINDS.driven, BODY = "#3f4a55";
export const PRESSURE = 0.3; // of the length of other arrows: many stand beside each other
const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

/** Symbols of supports: triangles as cones whose tips touch the nodes, lines as thin rods. */
export class Supports {
  constructor(scene) {
    Object.assign(this, { scene, size: symbolSize(scene) });
    this.marks = scene.header.support_marks;
    this.pointed = this.marks.filter(({ kind }) => coned(kind));
    const pieces = this.marks.reduce((count, mark) => count + this.rodsOf(mark, [0, 0, 0]).length, 0);
    this.cones = cones(this.pointed.length, 4, "#ffffff");
    this.rods = cylinder(pieces, 6);
    this.mesh = new Group();
    this.mesh.add(this.cones, this.rods);
  }

  /** Straight pieces of a symbol at a place, but those of its cone. */
  rodsOf(mark, at) {
    return symbolAt(mark, at, this.size).filter((_, k) => k > 0 || !coned(mark.kind)).flatMap(piecesOf);
  }

  /** The ground of the symbols at a frame. */
  feet(frame) {
    return this.marks.map(({ node, along }) => this.scene.position(frame, node).map((x, i) => x - this.size * along[i]));
  }

  setTheme({ support }) {
    for (const mesh of this.mesh.children) mesh.material.color.set(support);
  }

  place(points) {
    this.pointed.forEach((mark, k) => {
      const [[tip, left, right]] = symbolAt(mark, points[mark.node], this.size);
      placeAlong(this.cones, k, left.map((x, i) => (x + right[i]) / 2), tip, 0.5 * this.size);
    });
    this.marks.flatMap((mark) => this.rodsOf(mark, points[mark.node])).forEach(([p, q], k) => placeAlong(this.rods, k, p, q, 0.045 * this.size));
    moved(this.cones);
    moved(this.rods);
  }
}

const coned = (kind) => kind === "pin" || kind === "roller";

/** Arrows of the loads, the longest of all times a fifth of the structure. */
export class Loads {
  constructor(scene, size) {
    this.scene = scene;
    this.radius = 0.1 * size;
    this.group = new Group();
    this.shown = scene.header.loads.map((load, k) => ({ ...load, k })).filter((load) => load.drawn !== false);
    this.arrows = this.shown.map(() => arrow(LOAD));
    for (const one of this.arrows) this.group.add(one);
    let largest = 0;
    if (scene.has("load_force")) {
      const { data } = scene.arrays.load_force;
      for (let i = 0; i < data.length; i += scene.dim) largest = Math.max(largest, Math.hypot(...data.slice(i, i + scene.dim)));
    }
    this.factor = largest ? (0.16 * scene.extent.size) / largest : 0;
  }

  /** Ends of the arrows at a frame. */
  tips(frame) {
    return this.shown.map((load) => {
      const force = this.scene.vector("load_force", frame, load.k), size = (load.pressure ? PRESSURE : 1) * this.factor;
      return this.scene.placeOfLoad(load, (node) => this.scene.position(frame, node)).map((x, i) => (load.at ? x - size * force[i] : x + size * force[i]));
    });
  }

  place(points, frame) {
    this.shown.forEach((load, i) => {
      const part = load.pressure ? PRESSURE : 1;
      const force = this.scene.vector("load_force", frame, load.k).map((f) => part * f * this.factor);
      // the tip of what acts between the ends of a member is on it
      const point = this.scene.placeOfLoad(load, (node) => points[node]);
      placeArrow(this.arrows[i], load.at ? point.map((x, j) => x - force[j]) : point, force, part * this.radius);
    });
  }
}

/** Motors that turn: a ring about the axis, at the first end of the bar or in the middle of the hinge. Pushed nodes: an arrow. */
export class Drives {
  constructor(scene, size) {
    this.scene = scene;
    this.size = size;
    this.group = new Group();
    this.shown = scene.header.drives.filter((drive) => drive.kind !== "length").map((drive) => {
      const mark = drive.kind === "coordinate" ? arrow(DRIVE) : ring(0.75 * size, DRIVE);
      this.group.add(mark);
      return { drive, mark };
    });
  }

  place(points) {
    for (const { drive, mark } of this.shown) {
      if (drive.kind === "angle") placeRing(mark, points[this.scene.ends[2 * drive.member]], drive.about);
      else if (drive.kind === "hinge") placeRing(mark, ...middle(drive.axis.map((node) => points[node])));
      else placeArrow(mark, points[drive.node], AXES[drive.axis].map((x) => 2.5 * this.size * x), 0.15 * this.size);
    }
  }
}

/** Middle of an axis, and its direction; of a hinge in the plane the node. */
function middle([p, q]) {
  return q ? [p.map((x, i) => (x + q[i]) / 2), q.map((x, i) => x - p[i])] : [p, [0, 0, 1]];
}

function placeRing(mark, at, about = [0, 0, 1]) {
  mark.position.set(...at);
  mark.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...about).normalize());
}

/** Triangles of rigid bars, which move as one. */
export class Faces {
  constructor(scene, triangles, opacity) {
    this.scene = scene;
    this.triangles = triangles;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(9 * triangles.length), 3));
    const material = new MeshLambertMaterial({ color: "#7f93a8", side: DoubleSide, transparent: true, opacity, depthWrite: false });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
  }

  place(points) {
    const { array } = this.mesh.geometry.attributes.position;
    this.triangles.forEach((corners, k) => {
      corners.forEach((node, i) => array.set(points[node], 9 * k + 3 * i));
    });
    this.mesh.geometry.attributes.position.needsUpdate = true;
    this.mesh.geometry.computeVertexNormals();
  }
}

/** Ends of the bar of a planar body, and its centre of mass. */
export function bodyAt(scene, { member, center }, points) {
  const p = points[scene.ends[2 * member]], q = points[scene.ends[2 * member + 1]];
  const L = Math.hypot(q[0] - p[0], q[1] - p[1]) || 1, u = [(q[0] - p[0]) / L, (q[1] - p[1]) / L];
  return [p, q, [p[0] + center[0] * u[0] - center[1] * u[1], p[1] + center[0] * u[1] + center[1] * u[0], 0]];
}

/** A ball at the centre of mass of every planar body. */
export class Centres {
  constructor(scene, size) {
    this.scene = scene;
    this.size = size;
    this.mesh = spheres(scene.header.bodies.length, 2, BODY);
  }

  place(points) {
    this.scene.header.bodies.forEach((body, k) => placeSphere(this.mesh, k, bodyAt(this.scene, body, points)[2], this.size));
    moved(this.mesh);
  }
}

/** A grid below the structure (behind it in the plane), with lines at round distances. */
export function ground(scene) {
  const { low, high, centre, size } = scene.extent;
  const step = niceStep(size / 8), half = Math.max(4, Math.ceil((0.75 * size) / step));
  const grid = new GridHelper(2 * half * step, 2 * half, "#8a949e", "#8a949e");
  grid.material.transparent = true;
  grid.material.opacity = 0.35;
  const round = (x) => Math.round(x / step) * step;
  if (scene.dim === 2) {
    grid.rotation.x = Math.PI / 2;
    grid.position.set(round(centre[0]), round(centre[1]), -0.08 * scene.length0);
  } else {
    grid.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(0, 0, 1)));
    grid.position.set(round(centre[0]), round(centre[1]), low[2] - 0.03 * (high[2] - low[2] || size));
  }
  return { grid, step };
}

/** The start pose as thin lines. */
export function ghost(scene) {
  const start = scene.nodes.map((_, node) => scene.position(0, node));
  const bars = scene.members.flatMap((_, member) => (scene.shows(member) ? piecesOf(scene.curves.points(start, member)).flat() : []));
  const points = [...bars, ...edgesOf(scene.skin).map((node) => start[node])].flat();
  const lines = new LineSegments(linesOf(points), new LineBasicMaterial({ color: "#8a949e", transparent: true, opacity: 0.8 }));
  lines.frustumCulled = false;
  return lines;
}

export function linesOf(points) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  return geometry;
}
