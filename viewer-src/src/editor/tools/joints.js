// Tools that join: a block that slides on a bar, a pair of gear wheels, springs, ropes.

import { svg } from "../../dom.js";
import { between } from "./parts.js";
import { direction, freeName, line, memberOf, membersAt, path, ring, turning, valueOf } from "./given.js";

const BELT = 26; // pixels of the larger wheel of a belt
const RATIO = -1; // of new gear wheels: as large, meshing

/** The point of the line through a member's ends nearest to a point. */
function onto(draw, member, point) {
  const { nodes } = memberOf(draw, member), [a, b] = [draw.at(nodes[0]), draw.at(nodes[1])];
  const along = b.map((value, k) => value - a[k]), square = along.reduce((sum, value) => sum + value * value, 0) || 1;
  const f = point.reduce((sum, value, k) => sum + (value - a[k]) * along[k], 0) / square;
  return a.map((value, k) => value + f * along[k]);
}

const apart = (p, q) => Math.hypot(...p.map((value, k) => value - q[k]));

/** Members on which a node lies without being joined to them. */
function under(draw, node) {
  const own = membersAt(draw, node), point = draw.at(node);
  return draw.state.members.filter(({ name, goes_on: more, ends }) => !more && !own.includes(name) && apart(onto(draw, name, point), point) * draw.camera.scale < 1 && apart(point, draw.at(ends[0])) < apart(...ends.map((end) => draw.at(end)))).map(({ name }) => name);
}

const slider = {
  name: "slider", words: "Slider", key: "x", about: "A block that slides on a bar: click the node that lies on it, or pull from the node to the bar; the same again removes it. For a slide on the ground take Roller", icon: "M3 19L21 7M7 10l4 6l6 -4l-4 -6z",
  takes: (given, draw) => (!given.length ? "node" : given.length > 1 || under(draw, given[0].node).length === 1 ? null : "member"),
  shows: (draw, [from], to) => line(draw, from?.point, to?.point),
  async act(draw, [{ node, point }, to]) {
    const { data } = draw.state, member = to?.member || under(draw, node)[0];
    if (membersAt(draw, node).includes(member)) return draw.tell(`${node} is an end of ${member}. A block slides on another bar than its own.`, true);
    const pair = memberOf(draw, member).nodes.slice(0, 2), there = onto(draw, member, point), own = blocks(data, node, pair);
    if (own.length) return draw.change(`${node} leaves ${member}`, own.map((name) => [["couplings", name], null]), { type: "node", name: node }).then(() => null);
    const moved = apart(there, point) * draw.camera.scale < 1e-6 ? [] : [[["nodes", node, "at"], draw.cut(there).map((value) => Number(value.toPrecision(12)))]];
    const entries = conditions(draw, pair, node).map(([name, coordinate]) => [["couplings", name], { terms: [[coordinate, 1]], value: 0 }]);
    await draw.change(`${node} slides on ${member}`, [...moved, ...entries], { type: "node", name: node });
  },
};

/** The couplings that keep a node on a line: names. */
const blocks = (data, node, line) => Object.entries(data.couplings || {}).filter(([, { terms = [] }]) => terms.length === 1 && terms[0][0].kind === "offset" && terms[0][0].point === node && String(terms[0][0].line) === String(line)).map(([name]) => name);

/** What is zero while a node is on a line, by name: its offset; in space that about the axis of the model most nearly across the line, and along it. */
function conditions(draw, line, node) {
  const name = freeName(draw.state.data, "couplings", "block"), offset = { kind: "offset", line, point: node };
  if (draw.state.dim === 2) return [[name, offset]];
  const [a, b] = line.map((end) => draw.at(end)), size = [0, 1, 2].map((k) => Math.abs(b[k] - a[k])), normal = draw.camera.plane.axis;
  const least = Math.min(...size), axis = "xyz"[size[normal] <= least + 1e-9 ? normal : size.indexOf(least)];
  return [[name, { ...offset, axis }], [`${name}.along`, { ...offset, along: axis }]];
}

const gear = {
  name: "gear", words: "Gear", key: "5", about: "Gear wheels or a belt between two bars that turn, in space each about the axis of its drive or the normal of the work plane: click one, then the other, and type how often the second turns for one turn of the first (negative: the other way round)", icon: "M8 8a4 4 0 1 0 .1 0M8 4v4M8 16v4M2 12h2M12 12h2M17 4a3 3 0 1 0 .1 0M17 2v2M17 10v2",
  takes: (given) => (given.length < 2 ? "member" : null),
  shows: (draw, [from], to) => line(draw, from?.point, to?.point),
  async act(draw, [{ member: one }, { member: two, point }]) {
    if (one === two) return draw.tell("Gear wheels need two bars. Click one, then the other.", true);
    const name = freeName(draw.state.data, "couplings", "gear"), first = turning(draw, one), second = first && turning(draw, two);
    if (!second) return null;
    const entry = (ratio) => ({ terms: [[first, ratio], [second, -1]] });
    const put = (ratio) => draw.change(`${name} of ${one} and ${two}`, [[["couplings", name], entry(ratio)]], { type: "member", name: two });
    if (!(await put(RATIO))) return null;
    const set = (text) => {
      const ratio = ratioOf(text);
      return ratio ? put(ratio) : draw.tell(`A ratio is a number or two: -0.5, -20/40. Got ${text}.`, true);
    };
    return { at: point, label: `Turns of ${two} a turn of ${one}`, value: String(RATIO), set };
  },
};

/** -0.5, or -20/40; 0 if it is neither. */
function ratioOf(text) {
  const [above, below = 1] = text.split(/[/:]/).map(Number);
  return Number.isFinite(above / below) ? above / below : 0;
}

const soft = (kind, stiffness) => (draw, name) => ({ label: "Stiffness", value: stiffness, set: (text) => {
  const value = valueOf(text, "N/m");
  return value ? draw.change(`stiffness of ${name}`, [[["bars", name, "stiffness"], value.join(" ")]]) : draw.tell(`A stiffness is a number with a unit: 1 kN/m. Got ${text}.`, true);
} });

export const joints = [
  slider, gear,
  between({ name: "spring", words: "Spring", key: "z", about: "A coil spring from pin to pin; then type its stiffness", icon: "M3 20l3 -3l-1 -5l6 3l-1 -5l6 3l-1 -5l3 -1l3 -3" }, (draw, ends) => ({ table: "bars", stem: "spring", entry: { ends, kind: "elastic", stiffness: "1 kN/m" } }), soft("elastic", "1 kN/m")),
  between({ name: "rope", words: "Rope", key: "6", about: "A rope from pin to pin, which only pulls; then type its stiffness", icon: "M3 19c4 -6 6 3 9 -4s5 2 9 -10" }, (draw, ends) => ({ table: "bars", stem: "rope", entry: { ends, kind: "cable", stiffness: "100 kN/m" } }), soft("cable", "100 kN/m")),
  {
    name: "hinge", words: "Hinge spring", key: "7", about: "A spring of the angle between two bars that meet: pull from one to the other, and in space click a node on the axis of their hinge; a click is for the angle to the ground, in space about the normal of the work plane", icon: "M4 20L20 20M4 20L15 5M14 20a10 10 0 0 0 -4 -8M9 15l2 -1M11 18l2 -1",
    takes: (given, draw) => (given.length < 2 ? "member" : given.length < 3 && draw.state.dim === 3 && given[0].member !== given[1].member ? "node" : null), more: () => true,
    next: ([one, two]) => two && `Hinge spring: now click a node on the axis of the hinge of ${one.member} and ${two.member}, which goes from where they meet to it.`,
    shows: (draw, [from], to) => line(draw, from?.point, to?.point),
    async act(draw, [one, two, axle]) {
      const members = [one.member, ...(two && two.member !== one.member ? [two.member] : [])];
      if (members.length === 1 && !turning(draw, one.member)) return null;
      const answer = await draw.edit({ do: "make", what: "angle_spring", members, nodes: axle ? [axle.node] : [], axis: "xyz"[draw.camera.plane.axis] });
      const name = answer.made?.entry?.[1];
      return name && { at: one.point, label: "Stiffness", value: "10 N m/rad", set: (text) => {
        const value = valueOf(text, "N m/rad");
        return value ? draw.change(`stiffness of ${name}`, [[["springs", name, "stiffness"], value.join(" ")]]) : draw.tell(`A stiffness is a number with a unit: 10 N m/rad. Got ${text}.`, true);
      } };
    },
  },
];

/** Marks of couplings: a block on its bar; the pitch circles of wheels that mesh, a belt around those that turn the same way. */
export function couplings(draw, at) {
  const { data, members, fixed } = draw.state, bar = (name) => members.find((one) => one.name === name)?.ends;
  return Object.values(data.couplings || {}).flatMap(({ terms = [] }) => {
    const [[one, f] = [], [two, g] = []] = terms;
    if (terms.length === 1 && one.kind === "offset") return one.along ? [] : block(at(one.point), one.line.map(at));
    const wheels = terms.length === 2 && [one, two].every((term) => term.kind === "angle") && [one, two].map((term) => bar(term.bar));
    if (!wheels || !wheels.every(Boolean) || !Number(f) || !Number(g)) return [];
    const [p, q] = wheels.map((ends) => draw.at(ends.find((end) => fixed[end]) || ends[0])), far = apart(p, q);
    const [r, s] = [Math.abs(f), Math.abs(g)].map((share) => (far * share) / (Math.abs(f) + Math.abs(g)));
    const wheel = (d) => svg("path", { class: "wheel", d }), wheelsOf = (size) => [wheel(`${path(ring(draw, p, r * size, one.axis))}Z`), wheel(`${path(ring(draw, q, s * size, two.axis))}Z`)];
    if (f * g > 0) return wheelsOf(1);
    const size = Math.min(1, BELT / draw.camera.scale / Math.max(r, s)), way = q.map((value, k) => value - p[k]); // a belt runs along both, a quarter of a turn beside the line of their axles
    const side = (turn) => path([ring(draw, p, r * size, one.axis, way, [turn, turn])[0], ring(draw, q, s * size, two.axis, way, [turn, turn])[0]]);
    return [...wheelsOf(size), wheel(side(0.25) + side(-0.25))];
  });
}

function block(place, [a, b]) {
  if (!place || !a || !b) return [];
  return [svg("rect", { class: "block", x: -13, y: -8, width: 26, height: 16, rx: 2, transform: `translate(${place[0].toFixed(1)} ${place[1].toFixed(1)}) rotate(${((Math.atan2(b[1] - a[1], b[0] - a[0]) * 180) / Math.PI).toFixed(2)})` })];
}
