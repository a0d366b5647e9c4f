// Tools that load: a force as an arrow that is pulled, a force along a member, a mass.

import { quantity } from "../../format.js";
import { arrow, freeName, pulled, rounded, textOf, valueOf, vectorOf, words } from "./given.js";

export const ARROW = 46; // pixels of the largest force of a drawing
const FIRST = { N: 100, "N/m": 100 }; // an arrow of that length, in a drawing without loads
const LEAST = 4; // pixels of an arrow
const ALONG = 7; // arrows along a member

/** What an arrow of ARROW pixels means: the largest load of its kind that is drawn. */
export function largest(loads, unit) {
  const own = loads.filter(({ span }) => Boolean(span) === (unit === "N/m"));
  return Math.max(0, ...own.map(({ force, shape = [1, 1] }) => Math.hypot(...force) * Math.max(...shape.map(Math.abs)))) || FIRST[unit];
}

const sizeOf = (draw, unit, pixels) => rounded((pixels / ARROW) * largest(draw.state.loads, unit));

/** A tool that pulls arrows. `first`: what they are pulled at. */
function arrows(record, first, unit, entryOf, feet) {
  return {
    ...record, takes: (given) => [first, "tip"][given.length] || null,
    shows(draw, [from], to) {
      if (!from || !to) return [];
      const { direction, pixels, length } = pulled(draw, from.point, to.point), { camera } = draw;
      const tip = (foot) => camera.project(foot.map((value, k) => value + length * (direction[k] || 0)));
      return [...feet(draw, from).map((foot) => arrow(tip(foot), camera.project(foot))), words(quantity(sizeOf(draw, unit, pixels), unit), tip(from.point))];
    },
    async act(draw, [from, tip]) {
      const { direction, pixels, length } = pulled(draw, from.point, tip.point), size = sizeOf(draw, unit, pixels);
      if (pixels < LEAST) return draw.tell("Pull the arrow away from where it begins.", true);
      const { data } = draw.state, { stem, entry } = entryOf(from), name = freeName(data, "loads", stem);
      const force = (value) => [["loads", name], { ...entry, force: vectorOf(value, direction) }];
      const hit = from.node ? { type: "node", name: from.node } : { type: "member", name: from.member };
      if (!(await draw.change(`${name}`, [force(valueOf(textOf(size, unit), unit))], hit))) return null;
      const set = (text) => {
        const value = valueOf(text, unit);
        return value ? draw.change(`${name}`, [force(value)]) : draw.tell(`A ${unit === "N" ? "force is a number with a unit: 2 kN" : "force along a member is a number with a unit: 2 kN/m"}. Got ${text}.`, true);
      };
      return { at: from.point.map((value, k) => value + length * (direction[k] || 0)), label: name, value: textOf(size, unit), set };
    },
  };
}

export const loads = [
  arrows(
    { name: "force", words: "Force", key: "p", about: "A force: pull its arrow from a node or from a place of a bar, and type its value", icon: "M12 3v16M7 14l5 5l5 -5M8 3h8" },
    "thing", "N", ({ node, member, share }) => (node ? { stem: `F_${node}`, entry: { node } } : { stem: `F_${member}`, entry: { member, at: `${Number((100 * share).toPrecision(3))} %` } }),
    (draw, { point }) => [point],
  ),
  arrows(
    { name: "load", words: "Line load", key: "u", about: "A force along a bar, beam or link, per length: pull its arrow from the member, and type its value", icon: "M3 4h18M4 4v12M12 4v12M20 4v12M2 13l2 3l2 -3M10 13l2 3l2 -3M18 13l2 3l2 -3M3 20h18" },
    "member", "N/m", ({ member }) => ({ stem: `q_${member}`, entry: { member } }),
    (draw, { member, point, share }) => {
      const own = draw.state.members.filter(({ name }) => name === member), [a, b] = [own[0].ends[0], own.at(-1).ends[1]].map((end) => draw.at(end));
      return share === undefined ? [point] : Array.from({ length: ALONG }, (_, k) => a.map((value, i) => value + (k / (ALONG - 1)) * (b[i] - value)));
    },
  ),
  {
    name: "mass", words: "Mass", key: "4", about: "A mass at a node, on which gravity acts: click the node and type it", icon: "M7 9h10l4 12h-18zM12 9a3 3 0 1 0 -.1 0",
    takes: (given) => (given.length ? null : "node"),
    async act(draw, [{ node, point }]) {
      const entry = draw.state.data.nodes[node], now = Array.isArray(entry) ? undefined : entry.mass;
      const set = (text) => {
        const value = valueOf(text, "kg");
        return value ? draw.change(`mass of ${node}`, [[["nodes", node, "mass"], value[0] ? value.join(" ") : null]]) : draw.tell(`A mass is a number with a unit: 5 kg. Got ${text}.`, true);
      };
      draw.pick({ type: "node", name: node });
      if (now === undefined) await set("1 kg");
      return { at: point, label: `Mass of ${node}`, value: typeof now === "number" ? `${now} kg` : now ?? "1 kg", set };
    },
  },
];
