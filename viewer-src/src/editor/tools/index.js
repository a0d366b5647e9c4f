// All tools by name, in the order of the toolbar. A tool is a record in one of these files, and in no other place: its button, its
// key, its entry in the menu and what mouse, fingers and keys give to it follow from the record.
//
//   name, words     : what it is called; `key`: its letter or digit; `about`: what one does with it, a sentence
//   icon            : a path on 24 x 24
//   takes(given, draw) : what it wants next, null when it has all: "place" (a node, or a point where one is made), "spot" (the same,
//                     in the work plane), "node", "member", "thing" (a node or a member), "tip" (any point)
//   next(given)     : words about what it wants then, if its name does not tell
//   more(first)     : whether a click is enough, though it would take more of a pull
//   chain           : whether the last place of what is clicked begins the next one; a pull stands alone
//   shows(draw, given, to) : what is drawn meanwhile (SVG); by default a line from the last place
//   act(draw, given): what it changes; the promise of a value to type, {at, label, value, set}, or of nothing. Without `at` its field
//                     stands in the corner, out of the way of what is drawn next
//
// What is given: {node, member, share (of the member), point}, one after another: press and release, click and click, Enter and Enter.
// Tools without `takes` are those that drag (hand.js) and those of ask.js.

import { bars } from "./bar.js";
import { drives } from "./drives.js";
import { joints } from "./joints.js";
import { loads } from "./loads.js";
import { measuring } from "./measuring.js";
import { parts } from "./parts.js";
import { supports } from "./supports.js";

const hands = [
  { name: "pick", words: "Pick", key: "v", about: "Pick and change: drag nodes, lengths follow; Shift adds to what is picked, Shift-drag draws a box", icon: "M6 3l12 10h-6l3 7l-3 1l-3 -7l-3 4z" },
  { name: "move", words: "Move", key: "m", about: "Move what is drawn: drag a node, all lengths are kept and drives follow", icon: "M12 3v18M3 12h18M9 6l3 -3l3 3M9 18l3 3l3 -3M6 9l-3 3l3 3M18 9l3 3l-3 3" },
];
const asking = [
  { name: "positions", words: "Positions", key: "q", about: "Positions that a linkage shall take: press at a point of the body, release along its direction", icon: "M4 18l7 -3M8 11l7 -1M13 5l7 2M9 13l2 2l-3 1M13 8l2 2l-3 1M18 4l2 3l-3 1" },
  { name: "path", words: "Path", key: "w", about: "A path that a linkage shall draw: press, draw, release", icon: "M3 15c3 -14 15 -12 18 -3c-2 9 -14 9 -18 3z" },
];

export const GROUPS = [["pick", hands], ["draw", [...bars, ...parts]], ["hold", supports], ["drive", drives], ["load", loads], ["join", joints], ["measure", measuring], ["ask for a linkage", asking]];
export const TOOLS = new Map(GROUPS.flatMap(([, tools]) => tools).map((one) => [one.name, one]));
