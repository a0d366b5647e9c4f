// What tools share: names of what they make, values with units, what they draw while they are used.

import { svg } from "../../dom.js";
import { scale } from "../../format.js";

export const MEMBERS = ["bars", "active", "beams", "links"];

/** The first name of a table that is free: stem (if `bare`), stem1, stem2, ...; the tables of members share their names. */
export function freeName(data, table, stem, bare = true) {
  const used = new Set((MEMBERS.includes(table) ? MEMBERS : [table]).flatMap((one) => Object.keys(data[one] || {})));
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

export const path = (points) => `M${points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`;

export function line(draw, from, to) {
  return from && to ? [svg("path", { class: "rubber", d: path([from, to].map((one) => draw.camera.project(one))) })] : [];
}

export function arrow(tip, end, kind = "load") {
  const turned = Math.atan2(tip[1] - end[1], tip[0] - end[0]);
  const wing = (by) => [tip[0] - 9 * Math.cos(turned + by), tip[1] - 9 * Math.sin(turned + by)];
  return svg("path", { class: kind, d: path([end, tip]) + path([wing(0.42), tip, wing(-0.42)]) });
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
