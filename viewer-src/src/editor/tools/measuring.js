// Dimensions: lengths and angles that stay in the picture, and a length that is given by typing it.

import { svg } from "../../dom.js";
import { number, quantity } from "../../format.js";
import { line, memberOf, path, valueOf } from "./given.js";

const BESIDE = 24; // pixels between a bar and its dimension
const ROUND = 30; // radius of the arc of an angle

export const measuring = [
  {
    name: "dimension", words: "Dimension", key: "0", about: "A dimension that stays in the picture: click a bar, and type the length if it is to be kept; pull from node to node for a distance, from bar to bar for an angle; the same again removes it", icon: "M3 7v10M21 7v10M3 12h18M7 9l-4 3l4 3M17 9l4 3l-4 3",
    measures: true,
    takes: ([first, second]) => (!first ? "thing" : second ? null : first.node ? "node" : "member"), more: ({ member }) => Boolean(member),
    shows: (draw, [from], to) => line(draw, from?.point, to?.point),
    async act(draw, [one, two]) {
      if (one.node && (!two || two.node === one.node)) return draw.tell("Pull from one node to another.", true);
      const bar = one.member, other = two?.member !== bar && two?.member, before = draw.state.dimensions.length;
      if (other && !sharedOf(draw, [bar, other])) return draw.tell(`${bar} and ${other} do not meet at a node: there is no angle between them to measure. A click on one of them measures its length.`, true);
      const answer = await draw.ask({ do: "dimension", ...(bar ? { members: other ? [bar, other] : [bar] } : { nodes: [one.node, two.node] }) });
      if (!bar || other || answer.kind !== "drawing" || answer.dimensions.length < before || draw.play.away || memberOf(draw, bar).table !== "bars") return null;
      draw.pick({ type: "member", name: bar });
      const { record, nodes } = memberOf(draw, bar), [a, b] = nodes.map((node) => draw.at(node)), field = ["elastic", "cable"].includes(record.kind) ? "natural_length" : "length";
      const set = (text) => {
        const value = valueOf(text, "m");
        return value ? draw.change(`length of ${bar}`, [[["bars", bar, field], value.join(" ")]]) : draw.tell(`A length is a number with a unit: 200 mm. Got ${text}.`, true);
      };
      return { at: a.map((value, k) => (value + b[k]) / 2), label: `Length of ${bar}`, value: record[field] ?? quantity(Math.hypot(...a.map((value, k) => b[k] - value)), "m", 6), set };
    },
  },
];

/** The node that two members share. */
function sharedOf(draw, pair) {
  const [one, other] = pair.map((name) => memberOf(draw, name).nodes);
  return one.find((node) => other.includes(node));
}

/** The dimensions of a drawing: lines, and words that stand beside them, in the pose that is shown. */
export function dimensions(draw, at) {
  const { state } = draw, lines = [], texts = [], there = { nodes: new Set(state.nodes), members: new Set(state.members.map(({ name }) => name)) };
  for (const { nodes, members } of state.dimensions) {
    if (!(nodes || members).every((name) => there[nodes ? "nodes" : "members"].has(name))) continue;
    const { line, text } = members?.length === 2 ? angle(draw, at, members) : distance(draw, at, nodes || memberOf(draw, members[0]).nodes, members?.[0]);
    lines.push(svg("path", { class: "dimension", d: line }));
    texts.push(text);
  }
  return { lines, texts };
}

/** Of two members at the node that they share, each towards its other end. */
function angle(draw, at, pair) {
  const shared = sharedOf(draw, pair);
  if (!shared) return { line: "", text: { words: "", at: [0, 0], way: [0, 0] } };
  const ends = pair.map((name) => memberOf(draw, name).nodes).map((own) => (own[0] === shared ? own.at(-1) : own[0])), about = at(shared);
  const [p, q] = ends.map((end) => draw.at(end).map((value, k) => value - draw.at(shared)[k])), cross = [0, 1, 2].map((k) => p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3]);
  const turned = Math.atan2(Math.hypot(...cross), p.reduce((sum, value, k) => sum + value * q[k], 0));
  const [from, to] = ends.map((end) => Math.atan2(at(end)[1] - about[1], at(end)[0] - about[0])), by = ((to - from + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
  const on = (radius, way) => [about[0] + radius * Math.cos(way), about[1] + radius * Math.sin(way)];
  return { line: path(Array.from({ length: 17 }, (_, k) => on(ROUND, from + (by * k) / 16))), text: { words: `${number((turned * 180) / Math.PI, 4)} deg`, at: on(ROUND + 18, from + by / 2), way: [0, 60] } };
}

/** Between the first and the last of some nodes; a length that is given to a bar is told as it was typed. */
function distance(draw, at, nodes, bar) {
  const [a, b] = [nodes[0], nodes.at(-1)], [p, q] = [at(a), at(b)], far = Math.hypot(q[0] - p[0], q[1] - p[1]) || 1;
  const [nx, ny] = [((q[1] - p[1]) / far) * BESIDE, (-(q[0] - p[0]) / far) * BESIDE], [u, v] = [[p[0] + nx, p[1] + ny], [q[0] + nx, q[1] + ny]];
  const turned = Math.atan2(q[1] - p[1], q[0] - p[0]), wing = ([x, y], way, by) => [x + way * 8 * Math.cos(turned + by), y + way * 8 * Math.sin(turned + by)];
  const line = path([p, [p[0] + 1.15 * nx, p[1] + 1.15 * ny]]) + path([q, [q[0] + 1.15 * nx, q[1] + 1.15 * ny]]) + path([wing(u, 1, 0.35), u, v, wing(v, -1, 0.35)]) + path([wing(u, 1, -0.35), u]) + path([v, wing(v, -1, -0.35)]);
  const { length: given, kind = "rigid" } = draw.state.data.bars?.[bar] || {}, length = Math.hypot(...draw.at(a).map((value, k) => value - draw.at(b)[k]));
  return { line, text: { words: typeof given === "string" && kind === "rigid" ? given : quantity(length, "m"), at: [(u[0] + v[0]) / 2 + 0.4 * nx, (u[1] + v[1]) / 2 + 0.4 * ny], way: [v[0] - u[0], v[1] - u[1]] } };
}
