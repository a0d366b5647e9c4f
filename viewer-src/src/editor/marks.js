// Marks of bodies and of springs of angles in the drawing.

import { svg } from "../dom.js";

const TURN = 26; // pixels, radius of the arc of a spring

/** Bodies as areas, or lines, between their nodes. */
export function bodies(data, at) {
  return Object.values(data.bodies || {}).map(({ nodes }) => {
    const places = (nodes || []).map(at).filter(Boolean);
    const middle = [0, 1].map((k) => places.reduce((sum, place) => sum + place[k] / places.length, 0));
    const turn = ([x, y]) => Math.atan2(y - middle[1], x - middle[0]);
    const around = places.toSorted((a, b) => turn(a) - turn(b));
    return svg("path", { class: "body", d: around.length > 1 ? `M${around.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}Z` : "" });
  });
}

/** Springs of angles as arcs. */
export function springs(data, at, ends) {
  const arcs = Object.values(data.springs || {}).map(({ coordinate: one }) => {
    if (one?.kind === "hinge") return arc(at(one.axis?.[0]), at(one.start), at(one.end));
    const pair = one?.kind === "angle" ? ends(one.bar)?.map(at) : null;
    return pair && pair[0] ? arc(pair[0], [pair[0][0] + 1, pair[0][1]], pair[1]) : null;
  });
  return arcs.filter(Boolean);
}

/** A zigzag along the arc about a point from one direction to another, the shorter way. */
function arc(about, from, to) {
  if (!about || !from || !to) return null;
  const [a, b] = [from, to].map(([x, y]) => Math.atan2(y - about[1], x - about[0]));
  const by = ((b - a + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
  const points = Array.from({ length: 13 }, (_, k) => {
    const r = TURN + (k % 2 && k > 1 && k < 11 ? 5 : 0) - (k % 2 === 0 && k > 1 && k < 11 ? 5 : 0), turned = a + (by * k) / 12;
    return `${(about[0] + r * Math.cos(turned)).toFixed(1)} ${(about[1] + r * Math.sin(turned)).toFixed(1)}`;
  });
  return svg("path", { class: "spring", d: `M${points.join("L")}` });
}
