// Tools that draw members of several parts, or of a kind of their own.

import { freeName, line, nodesOf, path } from "./given.js";
import { svg } from "../../dom.js";

const same = (a, b) => (a.node ? a.node === b.node : !b.node && a.point.every((value, k) => Math.abs(value - b.point[k]) < 1e-12));

const link = {
  name: "link", words: "Link", key: "1", about: "One stiff member through two pins or more: click them in their order; the last one again ends it, the first one again closes it",
  icon: "M4 19L11 10L20 5M4 17a2 2 0 1 0 .1 0M11 8a2 2 0 1 0 .1 0M20 3a2 2 0 1 0 .1 0",
  takes: (given) => {
    const last = given.at(-1), before = given.slice(0, -1);
    return given.length > 2 && (same(last, before.at(-1)) || (given.length > 3 && same(last, before[0]))) ? null : "place";
  },
  shows: (draw, given, to) => [svg("path", { class: "rubber", d: path([...given, ...(to ? [to] : [])].map(({ point }) => draw.camera.project(point))) })],
  async act(draw, given) {
    const last = given.at(-1), closed = same(last, given[0]), pins = closed ? given.slice(0, -1) : given.filter((one, k) => !k || !same(one, given[k - 1]));
    if (pins.every((one) => same(one, pins[0]))) return draw.tell("A link needs two different places.", true);
    const [nodes, changes] = nodesOf(draw, pins), name = freeName(draw.state.data, "links", "link", false);
    await draw.change(`adding ${name}`, [...changes, [["links", name], closed ? [...nodes, nodes[0]] : nodes]], { type: "member", name });
  },
};

/** A tool that draws a member from place to place. */
export function between(record, entryOf, value) {
  return {
    ...record, takes: (given) => (given.length < 2 ? "place" : null),
    shows: (draw, [from], to) => line(draw, from?.point, to?.point),
    async act(draw, given) {
      const [ends, made] = nodesOf(draw, given);
      if (ends[0] === ends[1]) return draw.tell("It needs two different places.", true);
      const { data, members } = draw.state, there = members.find((one) => !one.goes_on && ends.every((end) => one.ends.includes(end)) && one.name in (data.bars || {}));
      const { table, stem, entry } = entryOf(draw, ends, given), name = there?.name || freeName(data, table, stem, false);
      const changes = [...made, ...(there ? [[["bars", name], null]] : []), [[table, name], entry]];
      if (!(await draw.change(`adding ${name}`, changes, { type: "member", name }))) return;
      const middle = [0, 1, 2].map((k) => (draw.at(ends[0])[k] + draw.at(ends[1])[k]) / 2);
      return value && { at: middle, ...value(draw, name) };
    },
  };
}

export const parts = [link];
