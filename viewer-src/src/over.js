// Section forces and deflections over the structure: an area beside each member, and the largest values. Over any picture.

import { svg } from "./dom.js";
import { quantity } from "./format.js";
import { axesOf, sectionAt, sectionsOf } from "./mechanics.js";

const HIGHEST = 0.13; // height of the largest value, of the structure
const STATIONS = 13, MOST = 40, SMALL = 0.02; // along a member; values written; share of the largest that is none
const ROUND_OFF = 1e-7; // of the largest force: numbers of a scene have seven digits
const LOOKED = 4000; // members and frames that are looked at for the scale
const KEYS = { N: "T", V: "V2", M: "M3" };
const AROUND = [[0, 1], [0, -1], [1, 0], [-1, 0], [1, 1], [-1, 1], [1, -1], [-1, -1]];
const NEAR = [1, 2], FAR = [1, 2, 4, 8, 16, 24]; // rings about a tip where its words may stand; the largest value's are never left out

export class Over {
  constructor(view) {
    this.view = view;
    this.node = svg("svg", { class: "diagram", "aria-hidden": true });
    this.labels = [];
    this.boxes = [];
    this.factors = new Map();
  }

  /** Draw what is chosen where the members are now; null: nothing. */
  place(show) {
    const { scene, frame } = this.view;
    this.labels = [];
    this.boxes = [];
    if (!show || !offered(scene, show)) {
      this.node.replaceChildren();
      return;
    }
    const factor = this.factor(show), curves = curvesOf(scene, frame, show, this.view.now);
    const parts = curves.map((curve) => this.drawn(curve, show, factor));
    const size = this.view.canvas.getBoundingClientRect();
    this.node.setAttribute("viewBox", `0 0 ${size.width} ${size.height}`);
    this.node.replaceChildren(...parts.flatMap(({ shown }) => shown), ...this.written(curves, parts, show, size));
  }

  /** The tips of the largest values of all frames that are looked at, in space. */
  reach(show) {
    const { scene } = this.view;
    if (!show || !offered(scene, show)) return [];
    const factor = this.factor(show), step = stepOf(scene), found = [];
    for (let k = 0; k < scene.frames; k += step) {
      for (const { base, values, ways, extremes } of curvesOf(scene, k, show)) found.push(...extremes.map((e) => base[e].map((x, i) => x + factor * values[e] * ways[e][i])));
    }
    return found;
  }

  /** m a unit, or how many times as large deflections are drawn: one for all frames. */
  factor(show) {
    const { scene } = this.view, key = `${show.id} ${scene.header.load_case}`;
    if (!this.factors.has(key)) {
      const step = stepOf(scene);
      let largest = 0;
      for (let k = 0; k < scene.frames; k += step) for (const { values } of curvesOf(scene, k, show)) for (const value of values) largest = Math.max(largest, Math.abs(value));
      const factor = largest ? (HIGHEST * scene.extent.size) / largest : 0, power = 10 ** Math.floor(Math.log10(factor || 1));
      this.factors.set(key, show.id === "deflection" && factor ? power * Math.max(...[1, 2, 5].filter((one) => one * power <= factor * (1 + 1e-9))) : factor);
    }
    return this.factors.get(key);
  }

  /** The parts of a curve on the canvas: points at the member, tips, and what is drawn of them. */
  drawn({ base, values, ways }, show, factor) {
    const on = (points) => points.map((point) => this.view.project(point));
    const foot = on(base), tips = on(base.map((point, k) => point.map((x, i) => x + factor * values[k] * ways[k][i])));
    return { tips, foot, shown: areaOf(foot, tips, values, show.id) };
  }

  /** The largest values beside their places. */
  written(curves, parts, show, size) {
    const found = curves.flatMap(({ extremes, values, member }, c) => extremes.map((k) => ({ member: this.view.scene.members[member], value: values[k], tip: parts[c].tips[k], foot: parts[c].foot[k] })));
    const placed = placedValues(found, show.unit, size, legendBoxes(this.node));
    this.labels = placed.map(({ member, value, words }) => ({ member, value, words }));
    this.boxes = placed.map(({ box }) => box);
    return placed.map(textOf);
  }
}

/**
 * Values {value, tip, foot} with a place of their words on a sheet: the largest of all first; those that would cover others, or what
 * is taken, are left out.
 */
export function placedValues(found, unit, { width, height }, taken) {
  const most = Math.max(0, ...found.map(({ value }) => Math.abs(value))), placed = [];
  const ranked = found.filter(({ value }) => Math.abs(value) > SMALL * most).sort((a, b) => Math.abs(b.value) - Math.abs(a.value)).slice(0, MOST);
  for (const one of ranked) {
    const words = quantity(one.value, unit), wide = 6.4 * words.length + 6, high = 15;
    const box = ([x, y]) => [x - wide / 2, y - high / 2, x + wide / 2, y + high / 2];
    const places = placesAbout(one, wide, high, placed.length ? NEAR : FAR).filter(([x, y]) => x > wide / 2 && y > high / 2 && x < width - wide / 2 && y < height - high / 2);
    const at = places.find((place) => [...taken, ...placed.map((other) => other.box)].every((other) => apart(box(place), other))) || (placed.length ? null : places[0]);
    if (at) placed.push({ ...one, words, at, box: box(at), chief: !placed.length });
  }
  return placed;
}

export function textOf({ words, at: [x, y], chief }) {
  return svg("text", { class: chief ? "chief" : "", x: x.toFixed(1), y: y.toFixed(1) }, words);
}

/** The areas between points at members and at the values, by sign of axial forces, and the rim; of a deflection a line. */
export function areaOf(foot, tips, values, id) {
  if (id === "deflection") return [svg("path", { class: "shape", d: path(tips) })];
  const area = (kind, keeps) => svg("path", { class: `area ${kind}`, d: `${path([...foot, ...tips.map((tip, k) => (keeps(values[k]) ? tip : foot[k])).reverse()])}Z` });
  const areas = id === "N" ? [area("tension", (value) => value > 0), area("compression", (value) => value < 0)] : [area("plain", () => true)];
  return [...areas, svg("path", { class: "rim", d: path([foot[0], ...tips, foot.at(-1)]) })];
}

const offered = (scene, show) => scene.header.shows?.some(({ id }) => id === show.id);
const stepOf = (scene) => Math.max(1, Math.ceil((scene.frames * scene.members.length) / LOOKED));
const path = (points) => `M${points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`;
const apart = (a, b) => a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1];

/** Middles of a text about a tip, those away from the member first. */
function placesAbout({ tip, foot }, wide, high, rings) {
  const way = [tip[0] - foot[0], tip[1] - foot[1]], along = ([x, y]) => x * way[0] + y * way[1];
  return rings.flatMap((far) => AROUND.toSorted((a, b) => along(b) - along(a)).map(([x, y]) => [tip[0] + x * (wide / 2 + 3 * far), tip[1] + y * (high / 2 + 4 * far)]));
}

/** Where the legend of a picture is, and the line on its diagram. */
export function legendBoxes(node) {
  const offset = node.getBoundingClientRect();
  return [...(node.closest(".stage")?.querySelectorAll(".legend, .told") || [])].filter((one) => !one.hidden).map((one) => {
    const box = one.getBoundingClientRect();
    return [box.left - offset.left, box.top - offset.top, box.right - offset.left, box.bottom - offset.top];
  });
}

/** Curves of all members at a frame, with nodes at `now`: {member, base, values, ways (a unit of the value), extremes (indices)}. */
export function curvesOf(scene, frame, show, now) {
  return everyCurve(scene, frame, show, now).filter(({ values }) => values.some(Boolean) && !values.some(Number.isNaN)).map((curve) => ({ ...curve, extremes: chosen(curve) }));
}

/** Names of members whose values are not known at a frame. */
export function unknownOf(scene, frame, show) {
  const known = new Map();
  for (const { member, values } of everyCurve(scene, frame, show)) known.set(member, !values.some(Number.isNaN));
  return scene.members.filter((_, member) => scene.shows(member) && !known.get(member) && !(show.id === "torque" && !scene.curves.row.has(member)));
}

function everyCurve(scene, frame, show, now = scene.nodes.map((_, node) => scene.position(frame, node))) {
  const least = show.unit === "m" ? 0 : ROUND_OFF * forceOf(scene) * (show.unit === "N m" ? scene.extent.size : 1);
  const bodies = new Set(scene.header.bodies.map(({ member }) => member)), beams = new Set(scene.header.beams);
  return scene.members.flatMap((_, member) => {
    if (!scene.shows(member)) return [];
    const row = scene.curves.row.get(member);
    if (row !== undefined) return scene.has("beam_section") ? [ofBeam(scene, frame, show, now, member, row)] : [];
    if (beams.has(member) || bodies.has(member)) return [];
    return show.id === "deflection" ? [ofEnds(scene, frame, member)] : ofBar(scene, frame, show, member);
  }).map((curve) => ({ ...curve, values: curve.values.map((value) => (Math.abs(value) <= least ? 0 : value)) }));
}

/** The larger of two extremes with one sign, in the middle of a constant. */
function chosen({ values, extremes }) {
  const found = [...new Set(extremes)].filter((k) => values[k]);
  if (found.length < 2 || values[found[0]] * values[found[1]] < 0) return found;
  const top = found.reduce((best, k) => (Math.abs(values[k]) > Math.abs(values[best]) ? k : best));
  const spread = Math.max(...values) - Math.min(...values);
  return [spread <= 1e-6 * Math.abs(values[top]) ? values.length >> 1 : top];
}

/** The largest axial and shear force of a scene, N. */
function forceOf(scene) {
  const meet = (data, at) => data.reduce((most, value, k) => (at(k) && Math.abs(value) > most ? Math.abs(value) : most), 0);
  scene.forces ??= new Map();
  const key = scene.header.load_case, { joint_force: joint, beam_section: beam } = scene.arrays;
  if (!scene.forces.has(key)) {
    const count = beam?.shape[3];
    scene.forces.set(key, Math.max(joint ? meet(joint.data, () => true) : 0, beam ? meet(beam.data, (k) => k % count < scene.dim) : 0));
  }
  return scene.forces.get(key);
}

/** Along an elastic beam, with its extremes among the points. */
function ofBeam(scene, frame, show, now, member, row) {
  const { arrays, dim, header } = scene, column = header.shows.findIndex(({ id }) => id === show.id);
  const [, beams, several, extremes] = arrays.beam_extreme.shape, at = ((frame * beams + row) * several + column) * extremes;
  const [low, lowAt, high, highAt] = arrays.beam_extreme.data.slice(at, at + 4);
  const section = (k) => arrays.beam_section.data[((frame * beams + row) * STATIONS + k) * arrays.beam_section.shape[3] + column];
  const bent = (k) => [0, 1, 2].map((i) => (i < dim ? arrays.beam_moved.data[((frame * beams + row) * STATIONS + k) * dim + i] : 0));
  const shifts = Array.from({ length: STATIONS }, (_, k) => (show.id === "deflection" ? bent(k) : null));
  const known = Array.from({ length: STATIONS }, (_, k) => [k / (STATIONS - 1), shifts[k] ? Math.hypot(...shifts[k]) : section(k)]);
  const places = [...known, ...(show.id === "deflection" ? [[highAt, high]] : [[lowAt, low], [highAt, high]])].sort((a, b) => a[0] - b[0]);
  const values = places.map(([, value]) => value), extreme = [low, high].map((value) => values.indexOf(value)).filter((k) => k >= 0);
  if (show.id === "deflection") {
    const base = unmoved(scene, frame, member);
    const ways = places.map(([s]) => between(shifts, s)).map((shift) => shift.map((x) => x / (Math.hypot(...shift) || 1)));
    return { member, base: places.map(([s]) => between(base, s)), values, ways, extremes: extreme };
  }
  const points = scene.curves.points(now, member), across = scene.curves.across(now, member);
  const along = points.at(-1).map((x, i) => x - points[0][i]), one = along.map((x) => x / (Math.hypot(...along) || 1));
  const ways = places.map(([s]) => between(across, s)).map((two) => (show.axis === 2 ? two : cross(one, two)).map((x) => show.side * x));
  return { member, base: places.map(([s]) => between(points, s)), values, ways, extremes: extreme };
}

/** A point at a share of a row of points. */
function between(points, share) {
  const at = share * (points.length - 1), k = Math.min(Math.floor(at), points.length - 2), f = at - k;
  return points[k].map((x, i) => (1 - f) * x + f * points[k + 1][i]);
}

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** The ends of a member without loads; `linear` scenes show it there. */
function unmoved(scene, frame, member) {
  return [0, 1].map((end) => scene.vector("unmoved", 0, scene.ends[2 * member + end]));
}

/** The displacement of a bar, straight between its nodes. */
function ofEnds(scene, frame, member) {
  const shifts = [0, 1].map((end) => scene.vector("moved", frame, scene.ends[2 * member + end]));
  const values = shifts.map((shift) => Math.hypot(...shift));
  return { member, base: unmoved(scene, frame, member), values, ways: shifts.map((shift, k) => shift.map((x) => x / (values[k] || 1))), extremes: [values[0] > values[1] ? 0 : 1] };
}

/** Along the parts of a bar; the extremes of polynomials are at the ends of their pieces, or where they do not change. */
function ofBar(scene, frame, show, member) {
  const key = KEYS[show.id] || show.id;
  if (key === "torque") return [];
  const place = axesOf(scene, frame, member), [one, two, three] = place.axes, way = (show.axis === 2 ? two : three).map((x) => show.side * x);
  return sectionsOf(scene, frame, member).parts.map((part) => {
    const shares = new Set(Array.from({ length: STATIONS }, (_, k) => k / (STATIONS - 1)));
    let begin = 0;
    for (const piece of part.pieces) {
      const end = Math.min(piece.end, 1);
      for (const s of [begin, Math.min(1, begin + 1e-9), end, ...turns(piece, key)]) if (s >= begin && s <= end) shares.add(s);
      begin = end;
    }
    const places = [...shares].sort((a, b) => a - b), values = places.map((s) => sectionAt(scene, part, s)[key]);
    const base = places.map((s) => place.xA.map((x, i) => x + (part.start + s * part.length) * one[i]));
    return { member, base, values, ways: places.map(() => way), extremes: [Math.min(...values), Math.max(...values)].map((value) => values.indexOf(value)) };
  });
}

/** Where the polynomial of a section force is level. */
function turns({ S, M }, key) {
  const c = key[0] === "M" ? M[key === "M2" ? 0 : 1] : S.map((one) => one[["T", "V2", "V3"].indexOf(key)]);
  const [a, b, d] = [3 * (c[3] || 0), 2 * c[2], c[1]];
  if (Math.abs(a) < 1e-300) return b ? [-d / b] : [];
  const root = Math.sqrt(b * b - 4 * a * d);
  return Number.isNaN(root) ? [] : [(-b + root) / (2 * a), (-b - root) / (2 * a)];
}
