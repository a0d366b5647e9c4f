// Tools that join: a block that slides on a bar, a pair of gear wheels, springs, ropes.

import { svg } from "../../dom.js";
import { between } from "./parts.js";
import { freeName, line, memberOf, membersAt, path, valueOf } from "./given.js";

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
  name: "slider", words: "Slider", key: "x", about: "A block that slides on a bar: click the node that lies on it, or pull from the node to the bar. For a slide on the ground take Roller", icon: "M3 19L21 7M7 10l4 6l6 -4l-4 -6z",
  takes: (given, draw) => (!given.length ? "node" : given.length > 1 || under(draw, given[0].node).length === 1 ? null : "member"),
  shows: (draw, [from], to) => line(draw, from?.point, to?.point),
  async act(draw, [{ node, point }, to]) {
    const { data, dim } = draw.state, member = to?.member || under(draw, node)[0];
    if (dim !== 2) return draw.tell("In space a slide is joints.prismatic of the library; here blocks slide in the plane.", true);
    if (membersAt(draw, node).includes(member)) return draw.tell(`${node} is an end of ${member}. A block slides on another bar than its own.`, true);
    const name = freeName(data, "couplings", "block"), { nodes } = memberOf(draw, member), there = onto(draw, member, point);
    const moved = apart(there, point) * draw.camera.scale < 1e-6 ? [] : [[["nodes", node, "at"], draw.cut(there).map((value) => Number(value.toPrecision(12)))]];
    await draw.change(`${node} slides on ${member}`, [...moved, [["couplings", name], { terms: [[{ kind: "offset", line: nodes.slice(0, 2), point: node }, 1]] }]], { type: "node", name: node });
  },
};

const gear = {
  name: "gear", words: "Gear", key: "5", about: "Gear wheels or a belt between two bars that turn: click one, then the other, and type how often the second turns for one turn of the first (negative: the other way round)", icon: "M8 8a4 4 0 1 0 .1 0M8 4v4M8 16v4M2 12h2M12 12h2M17 4a3 3 0 1 0 .1 0M17 2v2M17 10v2",
  takes: (given) => (given.length < 2 ? "member" : null),
  shows: (draw, [from], to) => line(draw, from?.point, to?.point),
  async act(draw, [{ member: one }, { member: two, point }]) {
    if (one === two) return draw.tell("Gear wheels need two bars. Click one, then the other.", true);
    if (draw.state.dim !== 2) return draw.tell("Here gear wheels lie in the plane. In space write a coupling of two hinges (Entries of the model).", true);
    const name = freeName(draw.state.data, "couplings", "gear");
    const entry = (ratio) => ({ terms: [[{ kind: "angle", bar: one }, ratio], [{ kind: "angle", bar: two }, -1]] });
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
    name: "hinge", words: "Hinge spring", key: "7", about: "A spring of the angle between two bars that meet: pull from one to the other; a click is for the angle to the ground", icon: "M4 20L20 20M4 20L15 5M14 20a10 10 0 0 0 -4 -8M9 15l2 -1M11 18l2 -1",
    takes: (given) => (given.length < 2 ? "member" : null), more: () => true,
    shows: (draw, [from], to) => line(draw, from?.point, to?.point),
    async act(draw, [one, two]) {
      const members = [one.member, ...(two && two.member !== one.member ? [two.member] : [])], answer = await draw.edit({ do: "make", what: "angle_spring", members });
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
    if (terms.length === 1 && one.kind === "offset") return block(at(one.point), one.line.map(at));
    const wheels = terms.length === 2 && [one, two].every((term) => term.kind === "angle") && [one, two].map((term) => bar(term.bar));
    if (!wheels || !wheels.every(Boolean) || !Number(f) || !Number(g)) return [];
    const [p, q] = wheels.map((ends) => at(ends.find((end) => fixed[end]) || ends[0])), far = Math.hypot(p[0] - q[0], p[1] - q[1]);
    const [r, s] = [Math.abs(f), Math.abs(g)].map((share) => (far * share) / (Math.abs(f) + Math.abs(g)));
    if (f * g > 0) return [circle(p, r), circle(q, s)];
    const size = Math.min(1, 26 / Math.max(r, s)), [a, b] = [r * size, s * size], turned = Math.atan2(q[1] - p[1], q[0] - p[0]);
    const side = (way) => path([p, q].map(([x, y], k) => [x - way * [a, b][k] * Math.sin(turned), y + way * [a, b][k] * Math.cos(turned)]));
    return [circle(p, a), circle(q, b), svg("path", { class: "wheel", d: side(1) + side(-1) })];
  });
}

const circle = ([x, y], r) => svg("circle", { class: "wheel", cx: x.toFixed(1), cy: y.toFixed(1), r: r.toFixed(1) });

function block(place, [a, b]) {
  if (!place || !a || !b) return [];
  return [svg("rect", { class: "block", x: -13, y: -8, width: 26, height: 16, rx: 2, transform: `translate(${place[0].toFixed(1)} ${place[1].toFixed(1)}) rotate(${((Math.atan2(b[1] - a[1], b[0] - a[0]) * 180) / Math.PI).toFixed(2)})` })];
}
