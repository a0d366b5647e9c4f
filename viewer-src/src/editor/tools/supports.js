// Tools that hold nodes: every kind of support. The same support again frees the node.

import { line, memberOf, membersAt, pulled, valueOf } from "./given.js";

const DEGREE = Math.PI / 180;

/** The changes after which a node has this support alone; `clamped` says whether the ground holds its rotation too. */
function held(draw, node, { fixed = null, support = null, clamped = false }) {
  const { data, fixed: axes } = draw.state, given = data.clamped || [], changes = [];
  if (fixed !== (axes[node] || null)) changes.push([["fixed", node], fixed]);
  if (JSON.stringify(support) !== JSON.stringify(data.supports?.[node] || null)) changes.push([["supports", node], support]);
  const own = Array.isArray(given) ? given.includes(node) : node in given;
  if (own !== clamped) {
    if (!Array.isArray(given)) changes.push([["clamped", node], clamped ? "ground" : null]);
    else {
      const rest = given.filter((one) => one !== node);
      changes.push([["clamped"], clamped ? [...given, node] : rest.length ? rest : null]);
    }
  }
  return changes;
}

/** Hold a node in this way, or free it if it is held so already. */
function hold(draw, node, kind, way, more = []) {
  const changes = [...more, ...held(draw, node, way)];
  return changes.length ? draw.change(`${kind} at ${node}`, changes, { type: "node", name: node }) : draw.change(`freeing ${node}`, held(draw, node, {}), { type: "node", name: node });
}

const all = (draw) => "xyz".slice(0, draw.state.dim);

/** A roller that slides along a direction of the plane: a fixed coordinate, or a support that is turned. */
function sliding(angle) {
  const degrees = Number((angle / DEGREE).toFixed(4)), flat = ((degrees % 180) + 180) % 180;
  if (flat === 0) return { fixed: "y" };
  if (flat === 90) return { fixed: "x" };
  return { support: { y: "held", turned: `${flat} deg` } };
}

/** The same in space: the other coordinates, or those of axes of its own. */
function slidingInSpace(along) {
  const held = [..."xyz"].filter((_, k) => Math.abs(along[k]) < 1e-9).join("");
  return held.length === 2 ? { fixed: held } : { support: { along: along.map((value) => Number(value.toPrecision(12))), y: "held", z: "held" } };
}

/** A clamp holds the rotation of a beam or of a welded link; a single bar there becomes such a link. */
function clamp(draw, node) {
  const members = membersAt(draw, node).map((name) => ({ name, ...memberOf(draw, name) }));
  const turning = members.filter(({ table }) => table === "beams" || table === "links");
  if (turning.some(({ table, record }) => table === "beams" || (record.weld || []).includes(node))) return [];
  const [one] = turning.length ? turning : members.length === 1 ? members : [];
  if (!one) return null;
  const { kind, ends, ...rest } = one.record;
  if (one.table === "bars" && ((kind && kind !== "rigid") || Object.keys(rest).some((key) => !["section", "material", "mass"].includes(key)))) return null;
  const link = { nodes: one.nodes, ...(one.table === "links" ? one.record : rest), weld: [...(one.record.weld || []), node] };
  return [...(one.table === "bars" ? [[["bars", one.name], null]] : []), [["links", one.name], link]];
}

export const supports = [
  {
    name: "pin", words: "Pin", key: "h", about: "Hold a node in all directions: click it; again frees it", icon: "M12 5l-6 11h12zM3 19h18M5 22l2 -3M10 22l2 -3M15 22l2 -3",
    takes: (given) => (given.length ? null : "node"),
    act: (draw, [{ node }]) => hold(draw, node, "pin", { fixed: all(draw) }).then(() => null),
  },
  {
    name: "roller", words: "Roller", key: "r", about: "Let a node slide along a line: click it for a level line (in space a level plane), or pull from it along the line, in space in the work plane; again frees it", icon: "M12 4l-6 10h12zM8 16a2 2 0 1 0 .1 0M16 16a2 2 0 1 0 .1 0M3 22h18",
    takes: (given) => ["node", "tip"][given.length] || null, more: () => true,
    shows: (draw, [from], to) => {
      if (!from || !to) return [];
      const { direction, length } = pulled(draw, from.point, to.point), end = (by) => from.point.map((value, k) => value + by * length * (direction[k] || 0));
      return line(draw, end(-1), end(1));
    },
    act: (draw, [{ node, point }, tip]) => {
      const by = tip && pulled(draw, point, tip.point);
      return hold(draw, node, "roller", draw.state.dim === 2 ? sliding(by ? by.angle : 0) : by ? slidingInSpace(by.direction) : { fixed: "z" }).then(() => null);
    },
  },
  {
    name: "clamp", words: "Clamp", key: "e", about: "Hold the place and the rotation of a beam or link at its node: click the node; again frees it. A single bar there becomes a link", icon: "M6 4v16M6 12h15M2 7l4 -3M2 12l4 -3M2 17l4 -3M2 22l4 -3",
    takes: (given) => (given.length ? null : "node"),
    async act(draw, [{ node }]) {
      const changes = clamp(draw, node);
      if (!changes) return draw.tell(`Nothing at ${node} has a rotation to hold: bars are pinned. Make one of them a beam or a link first (Kind, in the panel).`, true);
      await hold(draw, node, "clamp", { clamped: true }, changes);
    },
  },
  {
    name: "foot", words: "Spring foot", key: "2", about: "Hold a node by a spring, upright; the other directions stay held. Click the node and type the stiffness; again frees it", icon: "M12 3v3l-4 2l8 3l-8 3l8 3l-4 2v2M4 21h16",
    takes: (given) => (given.length ? null : "node"),
    async act(draw, [{ node, point }]) {
      const axes = all(draw), up = axes.at(-1), own = draw.state.data.supports?.[node];
      if (own && own[up] !== undefined && own[up] !== "held") return hold(draw, node, "spring foot", {}).then(() => null);
      const entry = Object.fromEntries([...axes].map((axis) => [axis, axis === up ? "10 kN/m" : "held"]));
      if (!(await draw.change(`spring foot at ${node}`, held(draw, node, { support: entry }), { type: "node", name: node }))) return null;
      const set = (text) => {
        const given = valueOf(text, "N/m");
        return given ? draw.change(`spring foot at ${node}`, [[["supports", node, up], given.join(" ")]]) : draw.tell(`A stiffness is a number with a unit: 10 kN/m. Got ${text}.`, true);
      };
      return { at: point, label: "Stiffness", value: "10 kN/m", set };
    },
  },
];
