// The empty sheet: a picture of what one can do, over which one draws.

import { el, svg } from "../dom.js";

const line = (d, kind) => svg("path", { class: kind, d });
const ball = (x, y) => svg("circle", { class: "node", cx: x, cy: y, r: 5 });
const foot = (x, y) => line(`M${x} ${y}l-9 15h18zM${x - 13} ${y + 16}h26`, "foot");
const NODES = [[28, 84], [40, 52], [104, 28], [124, 84]];
const bars = (kinds = []) => [0, 1, 2].map((k) => line(`M${NODES[k]}L${NODES[k + 1]}`, `line ${kinds[k] || ""}`));
const balls = () => NODES.map(([x, y]) => ball(x, y));
const feet = () => [foot(...NODES[0]), foot(...NODES[3])];
const turn = () => line("M10 76a20 20 0 0 1 30 -10m-9 -5l10 5l-6 9", "turn");
const load = () => line("M104 34v30m-6 -9l6 9l6 -9", "pull");

const STEPS = [
  ["Drag from point to point: bars", () => [...bars(["", "", "begun"]), ...balls(), line("M124 84l4 16l4 -6l7 -1z", "tip")]],
  ["Hold what stands", () => [...bars(), ...feet(), ...balls()]],
  ["Turn a bar", () => [...bars(), ...feet(), ...balls(), turn()]],
  ["Play: motion, forces, reactions", () => [...bars(["tension", "compression", "compression"]), ...feet(), line("M66 36C84 16 118 18 130 34", "way"), ...balls(), turn(), load()]],
];

export class Welcome {
  constructor(draw) {
    this.draw = draw;
    this.node = el("div", { class: "welcome", hidden: true, "aria-label": "what one can do here" },
      el("ol", {}, STEPS.map(([words, picture]) => el("li", {}, svg("svg", { viewBox: "0 0 150 108", "aria-hidden": "true" }, ...picture()), el("span", {}, words)))));
  }

  /** It goes with the first node. */
  rebuild() {
    const { nodes, faults } = this.draw.state;
    this.node.hidden = nodes.length > 0 || Boolean(faults?.length);
  }
}
