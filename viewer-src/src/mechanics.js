// What goes on inside one member at one instant, from end accelerations and its mean axial force.
//
// Member axes 1, 2, 3 as in kinetruss: 1 from A to B; in the plane 3 = z and 2 = 3 x 1; in space 3 = 1 x h, 2 = 3 x 1.
// The B-side part exerts T, V, M on the A-side part. With b = a - g and xi the fraction of a part's length:
//   T, V quadratic, M cubic in xi (Newton-Euler for a straight rod; the base of an active member has two pieces, a bar one
//   more than places where something acts on it).

import { vonMises } from "./stress.js";

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (f, a) => [f * a[0], f * a[1], f * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => times(1 / (Math.hypot(...a) || 1), a);

/** Axes of a member as rows, its length, and the nodes at its ends. */
export function axesOf(scene, frame, member) {
  const A = scene.ends[2 * member], B = scene.ends[2 * member + 1];
  const xA = scene.position(frame, A), d = sub(scene.position(frame, B), xA);
  const L = Math.hypot(...d), u = times(1 / L, d);
  if (scene.dim === 2) return { A, B, L, xA, axes: [u, [-u[1], u[0], 0], [0, 0, 1]] };
  const o = scene.arrays.orient.data[member];
  const h = o >= 0 ? sub(scene.position(frame, o), xA) : [...scene.arrays.reference.data.slice(3 * member, 3 * member + 3)];
  let z = cross(u, h);
  if (dot(z, z) <= 1e-18 * dot(h, h)) {
    const k = [0, 1, 2].reduce((best, i) => (Math.abs(u[i]) < Math.abs(u[best]) ? i : best), 0);
    z = cross(u, [0, 1, 2].map((i) => (i === k ? 1 : 0)));
  }
  z = unit(z);
  return { A, B, L, xA, axes: [u, cross(z, u), z] };
}

/** Everything about a member at an instant that the rest is made of, vectors in member axes. */
export function stateOf(scene, frame, member) {
  const place = axesOf(scene, frame, member);
  const local = (v) => place.axes.map((axis) => dot(axis, v));
  const gravity = [0, 1, 2].map((i) => scene.header.gravity[i] || 0);
  const aA = scene.vector("acceleration", frame, place.A), aB = scene.vector("acceleration", frame, place.B);
  const dv = local(sub(scene.vector("velocity", frame, place.B), scene.vector("velocity", frame, place.A)));
  const b = local(sub(aA, gravity)), e = local(sub(aB, aA));
  const L = place.L, turn = [dv[1] / L, dv[2] / L];
  const bend = [-(turn[0] ** 2 + turn[1] ** 2), (e[1] - 2 * dv[0] * turn[0]) / L, (e[2] - 2 * dv[0] * turn[1]) / L];
  const rods = rodsOf(scene, member, L);
  const actions = actionsOn(scene, frame, member, L, local);
  const ends = endForces(scene, frame, member, { ...place, local, b, e, bend, rods, actions });
  return { ...place, member, frame, gravity, local, b, e, bend, rods, actions, FA: ends[0], FB: ends[1], derived: ends[2] };
}

/**
 * What acts on a member beside its weight: force and couple (member axes) at a fraction from A; fA, fB worth the same; of a
 * couple that is spread the whole.
 */
function actionsOn(scene, frame, member, L, local) {
  return (scene.header.actions || []).flatMap((action, k) => {
    if (action.member !== member) return [];
    const [fA, fB] = [0, 1].map((end) => local(scene.actionForce(frame, k, end)));
    const force = add(fA, fB), place = action.spread ? 0.5 : scene.number("action_place", frame, k);
    const arm = sub(fB, times(place, force));
    return [{ ...action, fA, fB, force, place, couple: [0, -L * arm[2], L * arm[1]], whole: [0, -L * fB[2], L * fB[1]] }];
  });
}

/** Rods of a member; of an active one with the masses clamped on them, each at a fraction from the end towards A. */
function rodsOf(scene, member, L) {
  const r = scene.arrays.rods.data, at = 6 * member;
  const first = { mass: r[at], rotary: r[at + 2], start: 0, length: L, role: "bar", masses: [] };
  if (!scene.active.has(member)) return [first];
  const on = (rod) => (scene.header.clamped || []).filter((one) => one.rod === rod);
  return [
    { ...first, length: r[at + 1], role: "base", masses: on(2 * member) },
    { mass: r[at + 3], rotary: r[at + 5], start: L - r[at + 4], length: r[at + 4], role: "tube", masses: on(2 * member + 1) },
  ];
}

/** m b of a mass on a rod. */
function resisting({ first, change }, one) {
  return times(one.mass, add(first, times(one.place, change)));
}

/** b at the centre of a rod and its change along the rod (member axes). */
function fieldOf(state, rod) {
  const { b, e, bend } = state;
  if (rod.role === "bar") return { first: b, change: e };
  if (rod.role === "base") return { first: b, change: times(rod.length, bend) };
  return { first: sub(add(b, e), times(rod.length, bend)), change: times(rod.length, bend) };
}

/** Force on the member at A and at B in member axes; formed from the mean axial force where the scene lacks it. */
function endForces(scene, frame, member, state) {
  if (scene.has("joint_force")) {
    return [0, 1].map((end) => state.local(scene.jointForce(frame, member, end))).concat(false);
  }
  // of the mean force what couplings pull along the member, which comes off with the other actions below
  const N = state.actions.filter((one) => one.mean).reduce(
    (left, one) => left - one.fA[0] + (1 - one.place) * one.force[0], scene.number("member_force", frame, member));
  let total = [0, 0, 0], about = [0, 0, 0];
  const pushes = state.rods.map((rod) => {
    const field = fieldOf(state, rod), { first, change } = field;
    const push = rod.masses.reduce((sum, one) => add(sum, resisting(field, one)), times(rod.mass, add(first, times(0.5, change))));
    total = add(total, push);
    // moment about B: the lever arm of the mass is its distance from B
    const arm = state.L - rod.start;
    const lever = add(times(arm - rod.length / 2, first), times(arm / 2 - rod.length / 3, change));
    about = add(about, sub(times(rod.mass, lever), times(rod.rotary, state.bend)));
    for (const one of rod.masses) about = add(about, times(arm - one.place * rod.length, resisting(field, one)));
    return { push, change, mass: rod.mass };
  });
  const FA = times(1 / state.L, about);
  // the mean of T over a bar is N; between base and tube it is N at the nut
  FA[0] = state.rods.length === 2
    ? pushes[0].push[0] - N
    : pushes[0].mass * (state.b[0] / 2 + state.e[0] / 6) - N;
  const taken = (end) => state.actions.reduce((sum, one) => add(sum, one[end]), [0, 0, 0]);
  return [sub(FA, taken("fA")), sub(sub(total, FA), taken("fB")), true];
}

/** Polynomials of T, V2, V3, M2, M3 over xi of every part of a member, piece by piece, each up to its `end`. */
export function sectionsOf(scene, frame, member) {
  const state = stateOf(scene, frame, member);
  const parts = state.rods.map((rod, k) => {
    const { first, change } = fieldOf(state, rod);
    const linear = times(rod.mass, first), square = times(rod.mass / 2, change);
    const fromA = times(-1, state.FA);
    const coupleAt = (end) => state.actions.filter((one) => one.place === end).reduce((sum, one) => add(sum, one.couple), [0, 0, 0]);
    let pieces;
    if (rod.role === "bar") pieces = barPieces(state, rod, linear, square, fromA);
    else if (rod.role === "tube") {
      pieces = toTheEnd(state, rod, rod.masses, sub(sub(state.FB, linear), square), linear, square, coupleAt(1), 0);
    } else {
      const nut = (state.L - state.rods[1].length) / rod.length;
      let S0 = fromA, K = times(-1, coupleAt(0));
      pieces = [];
      for (const one of rod.masses.filter((each) => each.place < nut)) {
        const s = one.place, q = resisting({ first, change }, one);
        if (s > 0) pieces.push(piece(S0, linear, square, rod, state.bend, K, false, s));
        S0 = add(S0, q);
        K = add(K, [0, -rod.length * q[2] * s, rod.length * q[1] * s]);
      }
      pieces.push({ ...piece(S0, linear, square, rod, state.bend, K, false, nut), nut: true });
      const beyond = rod.masses.filter((each) => each.place >= nut);
      pieces.push(...toTheEnd(state, rod, beyond, sub(times(-1, linear), square), linear, square, [0, 0, 0], nut));
    }
    return { part: scene.partsOf[member][k], ...rod, pieces };
  });
  if (parts.length === 2) pushRods(state, parts);
  return { state, parts };
}

/** The rest of a rod from `start`, given force (without masses) and couple at its end xi = 1: a new piece behind each mass. */
function toTheEnd(state, rod, masses, S0, linear, square, K, start) {
  const field = fieldOf(state, rod), pieces = [];
  const moment = (q, s) => [0, rod.length * q[2] * (1 - s), -rod.length * q[1] * (1 - s)];
  for (const one of masses) {
    const q = resisting(field, one);
    S0 = sub(S0, q);
    K = sub(K, moment(q, one.place));
  }
  for (const one of masses) {
    const s = one.place, q = resisting(field, one);
    if (s > start) pieces.push(piece(S0, linear, square, rod, state.bend, K, true, s));
    S0 = add(S0, q);
    K = add(K, moment(q, s));
  }
  pieces.push(piece(S0, linear, square, rod, state.bend, K, true, 2));
  return pieces;
}

/** Pieces of a bar from place to place: S falls by the force and M by the couple of what acts there. */
function barPieces(state, rod, linear, square, fromA) {
  const places = state.actions.flatMap(({ spread, place }) => (spread ? [spread.begin, spread.end] : [place]));
  const ends = [...new Set(places.filter((s) => s > 0 && s < 1))].sort((a, b) => a - b);
  return [...ends, 2].map((end, k) => {
    const start = k ? ends[k - 1] : 0, found = piece(fromA, linear, square, rod, state.bend, [0, 0, 0], false, end);
    for (const one of state.actions) {
      if (!one.spread) {
        if (one.place <= start && one.place < 1) subtract(found, rod, point(one));
      } else if (one.spread.end <= start) subtract(found, rod, passed(one));
      else if (one.spread.begin <= start) subtract(found, rod, within(one, 0, 1));
    }
    return found;
  });
}

/** What a part of a member has taken from S up to xi, and from the integral of S, and from M: coefficients of 1, xi, xi^2, xi^3. */
const point = ({ force, place, couple }) => ({ D: [force], P: [times(-place, force), force], C: [couple] });

/** The density q = c0 + c1 s of a force along a member, s from A; of a couple its share a length. */
function density({ spread: { begin, end, ratio }, fA, fB, force }) {
  const w = end - begin;
  if (ratio) return [times((ratio[0] - ((ratio[1] - ratio[0]) * begin) / w) / w, force), times((ratio[1] - ratio[0]) / (w * w), force)];
  const r = times(1 / w, sub(fB, times(begin, force)));
  const q0 = sub(times(4, force), times(6, r)), q1 = sub(times(12, r), times(6, force));
  return [times(1 / w, sub(q0, times(begin / w, q1))), times(1 / (w * w), q1)];
}

/** Of an action along a member that goes on at xi; s = from + scale xi. */
function within(one, from, scale) {
  const { begin, couple } = one.spread, first = Math.max(begin, from), start = (first - from) / scale;
  const [c0, c1] = density(couple ? { ...one, force: one.whole } : one);
  const at = (s) => add(times(s, c0), times((s * s) / 2, c1)); // int q from 0
  const D = [sub(at(from), at(first)), add(times(scale, c0), times(scale * from, c1)), times((scale * scale) / 2, c1)];
  if (couple) return { D: [], P: [], C: D };
  const P = [[0, 0, 0], D[0], times(1 / 2, D[1]), times(1 / 3, D[2])];
  P[0] = times(-1, P.reduce((sum, c, k) => add(sum, times(start ** k, c)), [0, 0, 0]));
  return { D, P, C: [] };
}

/** The same behind its end, on a bar. */
function passed(one) {
  if (one.spread.couple) return { D: [], P: [], C: [one.whole] };
  const { P } = within(one, 0, 1), e = one.spread.end;
  const there = P.reduce((sum, c, k) => add(sum, times(e ** k, c)), [0, 0, 0]);
  return { D: [one.force], P: [sub(there, times(e, one.force)), one.force], C: [] };
}

/** Take what acts up to xi off a piece: S falls by D, M2 and M3 by l P across them and by C. */
function subtract(found, rod, { D, P, C }) {
  D.forEach((d, k) => (found.S[k] = sub(found.S[k], d)));
  P.forEach((p, k) => {
    found.M[0][k] -= rod.length * p[2];
    found.M[1][k] += rod.length * p[1];
  });
  C.forEach((c, k) => [1, 2].forEach((axis) => (found.M[axis - 1][k] -= c[axis])));
}

/** What acts along an active member: on the base up to the nut, on the tube from its end. */
function pushRods(state, parts) {
  for (const one of state.actions.filter(({ spread }) => spread)) {
    const [base, tube] = parts, nut = Math.max(0, tube.start / state.L);
    for (const found of base.pieces) {
      subtract(found, base, within(one, 0, base.length / state.L));
      if (found.nut) break;
    }
    const { D, P } = within(one, nut, tube.length / state.L);
    const [whole, moment] = [D, P].map((each) => each.reduce((sum, c) => add(sum, c), [0, 0, 0]));
    // S = D(1) - D, and M = 0 at xi = 1
    const rest = { D: [sub(D[0], whole), ...D.slice(1)], P: P.map((c, k) => add(c, k === 0 ? sub(whole, moment) : k === 1 ? times(-1, whole) : [0, 0, 0])), C: [] };
    for (const found of tube.pieces) subtract(found, tube, rest);
  }
}

/** A piece whose moments about axes 2, 3 are those of K at xi = 0, or at 1 where `atB`. */
function piece(S0, S1, S2, rod, bend, K, atB, end) {
  const l = rod.length;
  const M2 = [K[1], l * S0[2] - rod.rotary * bend[2], (l * S1[2]) / 2, (l * S2[2]) / 3];
  const M3 = [K[2], rod.rotary * bend[1] - l * S0[1], (-l * S1[1]) / 2, (-l * S2[1]) / 3];
  if (atB) {
    M2[0] -= M2[1] + M2[2] + M2[3];
    M3[0] -= M3[1] + M3[2] + M3[3];
  }
  return { S: [S0, S1, S2], M: [M2, M3], end };
}

/** Section forces and von Mises stress of a part (from `sectionsOf`) at the fraction xi. */
export function sectionAt(scene, part, xi) {
  const { S, M } = part.pieces.find((one) => xi <= one.end);
  const [T, V2, V3] = [0, 1, 2].map((i) => S[0][i] + xi * (S[1][i] + xi * S[2][i]));
  const [M2, M3] = M.map((m) => m[0] + xi * (m[1] + xi * (m[2] + xi * m[3])));
  const c = scene.arrays.part_scale.data.slice(4 * part.part, 4 * part.part + 4);
  const shape = scene.arrays.part_shape.data[part.part];
  return { T, V2, V3, M2, M3, stress: vonMises(shape, T * c[0], M2 * c[1], M3 * c[2], V2 * c[3], V3 * c[3]) };
}

/** Forces on a member cut free, and its inertia: rows of {symbol, words, force (member axes), at (m from A)}. */
export function freeBodyOf(scene, frame, member) {
  const state = stateOf(scene, frame, member);
  const g = state.local(state.gravity);
  let weight = [0, 0, 0], inertia = [0, 0, 0], moment = 0, mass = 0;
  for (const rod of state.rods) {
    const field = fieldOf(state, rod);
    for (const { mass: m, place } of [{ mass: rod.mass, place: 0.5 }, ...rod.masses]) {
      weight = add(weight, times(m, g));
      inertia = add(inertia, times(m, add(add(field.first, times(place, field.change)), g)));
      moment += m * (rod.start + place * rod.length);
      mass += m;
    }
  }
  const centre = mass > 0 ? moment / mass : state.L / 2;
  const terms = [
    { symbol: "F_A", words: `joint ${scene.nodes[state.A]} on it`, force: state.FA, at: 0 },
    { symbol: "F_B", words: `joint ${scene.nodes[state.B]} on it`, force: state.FB, at: state.L },
    { symbol: "m g", words: "weight", force: weight, at: centre },
    { symbol: "m a", words: "inertia: what they sum to", force: inertia, at: centre, inertia: true },
  ];
  const size = Math.max(...state.FA.map(Math.abs), ...state.FB.map(Math.abs), 1e-30);
  const acting = state.actions.filter((one) => Math.max(...one.force.map(Math.abs)) > 1e-6 * size);
  terms.splice(2, 0, ...acting.map((one) => (
    { symbol: SYMBOLS[one.kind], words: `${one.kind} ${one.source}`, force: one.force, at: one.place * state.L })));
  const couples = state.actions.filter((one) => Math.hypot(...one.couple) > 1e-6 * size * state.L).map((one) => (
    { words: `${one.kind} ${one.source}`, at: one.place * state.L, couple: one.couple,
      size: scene.dim === 2 ? one.couple[2] : Math.hypot(...one.couple) }));
  return { state, mass, centre, terms, couples, drives: drivesOf(scene, frame, member).filter((drive) => drive.unit === "m") };
}

const SYMBOLS = {
  drive: "T", coupling: "Q", load: "P", body: "B", friction: "C", spring: "K", bearing: "C", hub: "H", couple: "C", hinge: "C",
};

/** Drives of a member: name, kind, coordinate and drive force now. */
export function drivesOf(scene, frame, member) {
  return drivesThat(scene, frame, (drive) => drive.member === member);
}

/** The same of a node: those that move it, and hinges about it. */
export function drivesAt(scene, frame, node) {
  return drivesThat(scene, frame, (drive) => drive.node === node || drive.axis?.includes?.(node) === true);
}

function drivesThat(scene, frame, wanted) {
  return scene.header.drives.flatMap((drive, k) => {
    if (!wanted(drive)) return [];
    const now = (name) => (scene.has(name) ? scene.number(name, frame, k) : NaN);
    return [{ ...drive, position: now("drive_position"), force: now("drive_force") }];
  });
}
