// Tools that drive: an angle, a length, a cylinder, a coordinate of a node. The same again stops it.

import { freeName, memberOf, turning } from "./given.js";
import { between } from "./parts.js";

const CYLINDER = { rod: 0.75, shortest: 0.8, longest: 1.4, barrel: [0.06, 0.05], piston: [0.03, 0] }; // of its length as drawn

/** The name of the drive of this kind on a bar or node, if there is one. */
const driveOn = (draw, kind, field, name) => Object.entries(draw.state.data.drives || {}).find(([, one]) => (one.kind || "angle") === kind && one[field] === name)?.[0];

/** The coordinate that changes most where a roller slides along a line that is turned; undefined for other supports. */
function freest({ turned, along } = {}) {
  const angle = (Number.parseFloat(turned) * Math.PI) / 180, way = Array.isArray(along) ? along.map(Number) : turned === undefined ? [] : [Math.cos(angle), Math.sin(angle)];
  const size = way.map(Math.abs);
  return "xyz"[size.indexOf(Math.max(...size))];
}

const tube = (length, [outer, inner]) => ({ kind: inner ? "tube" : "rod", ...(inner ? { outer: millimetres(length * outer), inner: millimetres(length * inner) } : { diameter: millimetres(length * outer) }) });
const millimetres = (value) => `${Number((1000 * value).toPrecision(2))} mm`;

export const drives = [
  {
    name: "turn", words: "Turn", key: "t", about: "Drive the angle of a bar or link, in space about the normal of the work plane: click it; again stops it", icon: "M5 19L18 12M5 17a2 2 0 1 0 .1 0M9 6a9 9 0 0 1 10 12M21 14l-2 4l-4 -2",
    takes: (given) => (given.length ? null : "member"),
    async act(draw, [{ member }]) {
      const there = driveOn(draw, "angle", "bar", member), name = there || freeName(draw.state.data, "drives", "motor"), entry = there ? null : turning(draw, member);
      if (!there && !entry) return;
      await draw.change(there ? `${name} removed` : `${name} turns ${member}${entry.axis ? ` about ${entry.axis}` : ""}`, [[["drives", name], entry]], { type: "member", name: member });
    },
  },
  {
    name: "stroke", words: "Stroke", key: "s", about: "Drive the length of a bar: click it; again stops it", icon: "M3 17L21 7M8 8l-5 9l10 1M14 5l7 2l-4 6",
    takes: (given) => (given.length ? null : "member"),
    async act(draw, [{ member }]) {
      const { table, record } = memberOf(draw, member), { kind, stiffness, natural_length, pretension, strain, ...rest } = record;
      if (table !== "bars") return draw.tell(`${member} is no bar; the length of a bar is driven.`, true);
      const driven = kind === "driven", entry = driven ? rest : { ...rest, kind: "driven" };
      await draw.change(driven ? `${member} keeps its length` : `driving the length of ${member}`, [[["bars", member], Object.keys(entry).length === 1 ? entry.ends : entry]], { type: "member", name: member });
    },
  },
  between(
    { name: "cylinder", words: "Cylinder", key: "y", about: "A hydraulic cylinder from pin to pin, with the limits of its stroke: press and release, or click and click. Drawn over a bar, it replaces it", icon: "M3 20l9 -9M8 18l-3 -3l7 -7l4 4l-7 7zM14 10l6 -6M20 2a2 2 0 1 0 .1 0" },
    (draw, ends, given) => {
      const [a, b] = given.map(({ point }) => point), length = Math.hypot(...a.map((value, k) => b[k] - value)), digits = (value) => Number(value.toPrecision(3));
      const { rod, shortest, longest, barrel, piston } = CYLINDER, material = draw.state.data.material || "steel_s355";
      const part = (shape) => ({ length: digits(rod * length), section: tube(length, shape), material });
      return { table: "active", stem: "cylinder", entry: { ends, base: part(barrel), tube: part(piston), limits: [digits(shortest * length), digits(longest * length)] } };
    },
  ),
  {
    name: "push", words: "Push", key: "3", about: "Drive a node along the direction that is free to it, as the block of a slide: click it; again stops it", icon: "M3 16h10v-8h-10zM13 12h8M17 8l4 4l-4 4M2 20h20",
    takes: (given) => (given.length ? null : "node"),
    async act(draw, [{ node }]) {
      const { data, dim, fixed } = draw.state, there = driveOn(draw, "coordinate", "node", node);
      const axis = freest(data.supports?.[node]) || [..."xyz"].slice(0, dim).find((one) => !(fixed[node] || "").includes(one)), name = there || freeName(data, "drives", "slide");
      if (!axis) return draw.tell(`${node} is held in all directions. Make it a roller first.`, true);
      await draw.change(there ? `${name} removed` : `${name} pushes ${node} along ${axis}`, [[["drives", name], there ? null : { kind: "coordinate", node, axis }]], { type: "node", name: node });
    },
  },
];
