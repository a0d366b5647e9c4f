// What tools share: names of what they make, values with units, what they draw while they are used.

import { svg } from "../../dom.js";
import { scale } from "../../format.js";

export const MEMBERS = ["bars", "active", "beams", "links"];
const NAMED = [...MEMBERS, "cylinders", "drives", "couplings", "springs", "stops"]; // no two entries of these have one name

/** The first name of a table that is free: stem (if `bare`), stem1, stem2, ... */
export function freeName(data, table, stem, bare = true) {
  const used = new Set((NAMED.includes(table) ? NAMED : [table]).flatMap((one) => Object.keys(data[one] || {})));
  if (bare && !used.has(stem)) return stem;
  let k = bare ? 2 : 1;
  while (used.has(`${stem}${k}`)) k++;
  return `${stem}${k}`;
}

/** Nodes of what is given, and the changes that make those that are not there yet: A to Z first. */
export function nodesOf(draw, given) {
  const changes = [], used = new Set(draw.state.nodes), letters = [...Array(26).keys()].map((k) => String.fromCharCode(65 + k));
  const names = given.map(({ node, point }) => {
    if (node) return node;
    let k = 1;
    while (used.has(`N${k}`)) k++;
    const name = letters.find((one) => !used.has(one)) || `N${k}`;
    used.add(name);
    changes.push([["nodes", name], draw.cut(point)]);
    return name;
  });
  return [names, changes];
}

/** The entry of a member as a record, its table and its nodes. */
export function memberOf(draw, name) {
  const { data } = draw.state, table = MEMBERS.find((one) => name in (data[one] || {}));
  const entry = data[table][name], field = table === "links" ? "nodes" : "ends";
  const record = Array.isArray(entry) ? { [field]: entry } : entry;
  return { table, record, nodes: record[field] };
}

/** Names of members that end at a node. */
export function membersAt(draw, node) {
  return [...new Set(draw.state.members.filter(({ ends }) => ends.includes(node)).map(({ name }) => name))];
}

/** The angle of a member as a coordinate: in space about the axis of its drive, else about the normal of the work plane. Nothing, and
 * words about it, if it has none. */
export function turning(draw, member) {
  const { data, dim } = draw.state;
  if (!["bars", "links", "active"].some((table) => member in (data[table] || {}))) return draw.tell(`${member} is a beam, which has no angle of its own: take a bar or a link (Kind, in the panel).`, true);
  if (dim === 2) return { kind: "angle", bar: member };
  const own = Object.values(data.drives || {}).find((one) => one.kind === "angle" && one.bar === member);
  const axis = own?.axis || "xyz"[draw.camera.plane.axis], { nodes } = memberOf(draw, member), normal = direction(axis);
  const along = draw.at(nodes[0]).map((value, k) => draw.at(nodes.at(-1))[k] - value), length = Math.hypot(...along);
  if (Math.abs(along.reduce((sum, value, k) => sum + value * normal[k], 0)) < 0.999999 * length) return { kind: "angle", bar: member, axis };
  return draw.tell(`${member} points along ${axis}, so it has no angle about it. In space the axis is the normal of the work plane: choose another Plane, above the drawing.`, true);
}

/** The direction of an axis of the model: a letter or three numbers; z if there is none. */
export const direction = (axis) => (Array.isArray(axis) ? axis.map(Number) : [0, 1, 2].map((k) => Number("xyz"[k] === (axis ?? "z"))));

/** Number and unit of what was typed; null if it is neither. */
export function valueOf(text, unit) {
  const [, number, own] = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*([^\d\s].*)?$/i.exec(String(text)) || [];
  return number === undefined ? null : [Number(number), (own || unit).trim()];
}

/** A value as text in the unit in which it is read: 1500 N is "1.5 kN". */
export function textOf(value, unit) {
  const [factor, name] = scale(value, unit);
  return `${Number((value * factor).toPrecision(7))} ${name}`;
}

/** A vector of a size along a direction, as texts with units. */
export function vectorOf([number, unit], direction) {
  return direction.map((share) => `${Number((number * share).toPrecision(7)) || 0} ${unit}`);
}

/** A number with two digits: what a pull of the mouse means. */
export const rounded = (value) => Number(value.toPrecision(2));

// What is drawn meanwhile.

export const path = (points) => (points.length ? `M${points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}` : "");

export function line(draw, from, to) {
  return from && to ? [svg("path", { class: "rubber", d: path([from, to].map((one) => draw.camera.project(one))) })] : [];
}

export function arrow(tip, end, kind = "load") {
  const turned = Math.atan2(tip[1] - end[1], tip[0] - end[0]);
  const wing = (by) => [tip[0] - 9 * Math.cos(turned + by), tip[1] - 9 * Math.sin(turned + by)];
  return svg("path", { class: kind, d: path([end, tip]) + path([wing(0.42), tip, wing(-0.42)]) });
}

/** Points of the screen on a circle about an axis, counter-clockwise about it from the direction `start`: parts of a turn from one to another. */
export function ring({ camera }, centre, radius, axis, start = null, [from, to] = [0, 1]) {
  const n = direction(axis), cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const size = (a) => Math.hypot(...a), seen = start && size(cross(n, start)) > 1e-9 ? start : Math.abs(n[0]) < 0.9 * size(n) ? [1, 0, 0] : [0, 1, 0];
  const side = cross(n, seen), second = side.map((value) => value / size(side)), first = cross(second, n).map((value) => value / size(n));
  return Array.from({ length: 49 }, (_, k) => {
    const turned = 2 * Math.PI * (from + ((to - from) * k) / 48);
    return camera.project(centre.map((value, i) => value + radius * (Math.cos(turned) * first[i] + Math.sin(turned) * second[i])));
  });
}

export function words(text, [x, y]) {
  return svg("text", { class: "hand", x: x + 10, y: y - 8 }, text);
}

/** The direction from a point to another in the work plane, at a multiple of 15 degrees if the drawing snaps; and its length on the screen. */
export function pulled(draw, from, to) {
  const { camera } = draw, [u, v] = camera.across, by = [to[u] - from[u], to[v] - from[v]], length = Math.hypot(...by);
  const step = Math.PI / 12, angle = Math.atan2(by[1], by[0]), turned = draw.snap ? Math.round(angle / step) * step : angle;
  const direction = [0, 0, 0];
  [direction[u], direction[v]] = [Math.cos(turned), Math.sin(turned)].map((value) => (Math.abs(value) < 1e-9 ? 0 : value));
  return { direction: draw.cut(direction), angle: turned, pixels: length * camera.scale, length };
}
