// Dimensions: lengths and angles that stay in the picture, and a length that is given by typing it.

import { svg } from "../../dom.js";
import { number, quantity } from "../../format.js";
import { line, memberOf, path, valueOf } from "./given.js";

const BESIDE = 24; // pixels between a bar and its dimension
const ROUND = 30; // radius of the arc of an angle

export const measuring = [
  {
    name: "dimension", words: "Dimension", key: "0", about: "A dimension that stays in the picture: click a bar, and type the length if it is to be kept; pull from node to node for a distance, from bar to bar for an angle; the same again removes it", icon: "M3 7v10M21 7v10M3 12h18M7 9l-4 3l4 3M17 9l4 3l-4 3",
    takes: ([first, second]) => (!first ? "thing" : second ? null : first.node ? "node" : "member"), more: ({ member }) => Boolean(member),
    shows: (draw, [from], to) => line(draw, from?.point, to?.point),
    async act(draw, [one, two]) {
      const key = JSON.stringify(one.node ? { nodes: [one.node, two?.node] } : two && two.member !== one.member ? { bars: [one.member, two.member] } : { bar: one.member });
      if (one.node && (!two || two.node === one.node)) return draw.tell("Pull from one node to another.", true);
      if (two?.member && two.member !== one.member && !shared(...[one, two].map(({ member }) => memberOf(draw, member).nodes))) return draw.tell(`${one.member} and ${two.member} do not meet at a node: there is no angle between them to measure. A click on one of them measures its length.`, true);
      if (!draw.dimensions.delete(key)) draw.dimensions.add(key);
      draw.canvas.update();
      const bar = JSON.parse(key).bar;
      if (!bar || !draw.dimensions.has(key) || memberOf(draw, bar).table !== "bars") return null;
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

/** The node that two members share; undefined if there is none. */
const shared = (one, two) => one.find((end) => two.includes(end));

/** The dimensions of a drawing: lines, and words that stand beside them. */
export function dimensions(draw, at) {
  const { state } = draw, ends = (name) => state.members.find((one) => one.name === name)?.ends, lines = [], texts = [];
  for (const key of draw.dimensions) {
    const { nodes, bars, bar } = JSON.parse(key), pair = bars ? bars.map(ends) : nodes || (ends(bar) && memberOf(draw, bar).nodes);
    if (!pair || !pair.flat().every((node) => node && state.nodes.includes(node))) continue;
    if (bars) {
      const hinge = shared(...pair);
      if (!hinge) continue;
      const ways = pair.map((two) => two.find((end) => end !== hinge)), about = at(hinge), [d, e] = ways.map((end) => draw.at(end).map((value, k) => value - draw.at(hinge)[k]));
      const angle = Math.acos(Math.max(-1, Math.min(1, d.reduce((sum, value, k) => sum + value * e[k], 0) / (Math.hypot(...d) * Math.hypot(...e)))));
      const [from, to] = ways.map((end) => Math.atan2(at(end)[1] - about[1], at(end)[0] - about[0])), by = ((to - from + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
      lines.push(svg("path", { class: "dimension", d: path(Array.from({ length: 17 }, (_, k) => [about[0] + ROUND * Math.cos(from + (by * k) / 16), about[1] + ROUND * Math.sin(from + (by * k) / 16)])) }));
      texts.push({ words: `${number((angle * 180) / Math.PI, 4)} deg`, at: [about[0] + (ROUND + 18) * Math.cos(from + by / 2), about[1] + (ROUND + 18) * Math.sin(from + by / 2)], way: [0, 60] });
    } else {
      const [a, b] = [pair[0], pair.at(-1)], [p, q] = [at(a), at(b)], far = Math.hypot(q[0] - p[0], q[1] - p[1]) || 1;
      const [nx, ny] = [((q[1] - p[1]) / far) * BESIDE, (-(q[0] - p[0]) / far) * BESIDE], [u, v] = [[p[0] + nx, p[1] + ny], [q[0] + nx, q[1] + ny]];
      const turned = Math.atan2(q[1] - p[1], q[0] - p[0]), wing = ([x, y], way, by) => [x + way * 8 * Math.cos(turned + by), y + way * 8 * Math.sin(turned + by)];
      lines.push(svg("path", { class: "dimension", d: path([p, [p[0] + 1.15 * nx, p[1] + 1.15 * ny]]) + path([q, [q[0] + 1.15 * nx, q[1] + 1.15 * ny]]) + path([wing(u, 1, 0.35), u, v, wing(v, -1, 0.35)]) + path([wing(u, 1, -0.35), u]) + path([v, wing(v, -1, -0.35)]) }));
      const given = bar && state.data.bars?.[bar]?.length, length = Math.hypot(...draw.at(a).map((value, k) => value - draw.at(b)[k]));
      texts.push({ words: typeof given === "string" ? given : quantity(length, "m"), at: [(u[0] + v[0]) / 2 + 0.4 * nx, (u[1] + v[1]) / 2 + 0.4 * ny], way: [v[0] - u[0], v[1] - u[1]] });
    }
  }
  return { lines, texts };
}
