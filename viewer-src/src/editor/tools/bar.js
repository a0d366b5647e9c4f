// Nodes and bars: what most of a drawing is made of.

import { quantity } from "../../format.js";
import { clean } from "../camera.js";
import { metres } from "../readout.js";
import { freeName, memberOf, nodesOf, valueOf } from "./given.js";

/** The length of a bar, to be typed. moves : its second end has just been made, and goes where the length leads; all else stays. */
function lengthOf(draw, bar, moves) {
  const { nodes } = memberOf(draw, bar), [a, b] = nodes.map((node) => draw.at(node)), way = a.map((value, k) => b[k] - value), far = Math.hypot(...way);
  const set = (text) => {
    const value = valueOf(text, "m"), to = metres(value?.join(" ")) / far;
    if (!value) return draw.tell(`A length is a number with a unit: 200 mm. Got ${text}.`, true);
    const end = moves && to > 0 ? [[["nodes", nodes[1]], draw.cut(a.map((from, k) => clean(from + to * way[k])))]] : [];
    return draw.change(`length of ${bar}`, [...end, [["bars", bar, "length"], value.join(" ")]]);
  };
  return { label: `Length of ${bar}`, value: quantity(far, "m", 6), set };
}

export const bars = [
  {
    name: "node", words: "Node", key: "n", about: "A node where you click", icon: "M12 7a5 5 0 1 0 .1 0",
    takes: (given) => (given.length ? null : "spot"),
    act: async (draw, [{ node, point }]) => (node ? draw.pick({ type: "node", name: node }) : void (await draw.edit({ do: "add", at: draw.cut(point) }))),
  },
  {
    name: "bar", words: "Bar", key: "b", about: "A bar from press to release, or from click to click and on to the next; the last one again ends it. It makes the nodes it needs; its length can be typed at once", icon: "M6 18L18 6M5 17a2 2 0 1 0 .1 0M19 3a2 2 0 1 0 .1 0", chain: true,
    takes: (given) => (given.length < 2 ? "place" : null),
    async act(draw, given) {
      const [ends, made] = nodesOf(draw, given), there = draw.state.members.find((one) => ends.every((end) => one.ends.includes(end)));
      if (there) {
        draw.pick({ type: "member", name: there.name });
        return draw.tell(`${there.name} joins ${ends[0]} and ${ends[1]} already. It is picked now.`, true);
      }
      const name = freeName(draw.state.data, "bars", "b", false);
      return (await draw.change(`adding ${name}`, [...made, [["bars", name], ends]], { type: "member", name })) && lengthOf(draw, name, made.some(([[, node]]) => node === ends[1]));
    },
  },
];
