// What a drawing needs next until it runs, as buttons: what holds it, what turns or joins it, what pulls at it.

import { el } from "../dom.js";
import { button } from "./fields.js";
import { freeName } from "./tools/given.js";

const MOST = 4; // buttons of a kind
const LOAD = -100; // N, upward
const ALL = { 2: "xy", 3: "xyz" };
const NO_CLICK = "What still moves is told in the panel. No single click stops it: clamp a node that turns, join beams stiffly, or add a bar or a support to each part that moves.";

const hold = (node, axes, whole) => [`Hold ${node}${axes === whole ? "" : ` along ${[...axes].join(" and ")}`}`, `support at ${node}`, ["fixed", node], axes, false];
const drive = (words, label, stem, data, entry, plays) => [words, label, ["drives", freeName(data, "drives", stem)], entry, plays];

/** [words, label, path, value, whether it plays then] of each step; in a sentence where there is none. */
function stepsOf(state) {
  const { dim, nodes, members, fixed, drives, mobility, missing, data, force } = state;
  if (!members.length || !mobility) return [];
  const at = new Map(nodes.map((name) => [name, members.filter(({ ends }) => ends.includes(name)).length]));
  const held = (node) => (fixed[node] || "").length === dim;
  if (mobility.undriven > 0) {
    if (dim === 3) return force ? [] : inSpace(state);
    const ends = mobility.undriven > 1 ? nodes.filter((name) => at.get(name) === 1 && !held(name)) : [];
    if (ends.length) return ends.slice(0, MOST).map((name) => hold(name, ALL[2], ALL[2]));
    if (force) return []; // springs hold it
    const driven = new Set(drives.map(({ bar }) => bar)), turning = members.filter(({ name, ends }) => held(ends[0]) !== held(ends[1]) && !driven.has(name) && name in (data.bars || {}));
    return turning.slice(0, MOST).map(({ name, ends }) => drive(`Turn ${name} about ${ends.find(held)}`, `drive ${name} about ${ends.find(held)}`, "motor", data, { kind: "angle", bar: name }, true));
  }
  if (!missing.some((words) => words.startsWith("No load"))) return [];
  const worth = (name) => (fixed[name] ? 0 : members.length) + at.get(name), loose = nodes.filter((name) => !held(name)), most = Math.max(...loose.map(worth));
  const node = loose.filter((name) => worth(name) === most).at(-1);
  return node ? [[`${-LOAD} N down at ${node}`, `load on ${node}`, ["loads", freeName(data, "loads", `F_${node}`)], { node, force: [...ALL[dim]].map((_, k) => `${k === dim - 1 ? LOAD : 0} N`) }, drives.length > 0]] : [];
}

/** What the studio has found that one click takes of the motions of a drawing in space. */
function inSpace({ clicks, data, mobility }) {
  const plays = mobility.undriven === 1, steps = {
    hold: ({ node, axes }) => hold(node, axes, ALL[3]),
    turn: ({ bar, node, axis }) => drive(`Turn ${bar} about ${node}, axis ${axis}`, `drive ${bar} about ${node}`, "motor", data, { kind: "angle", bar, axis }, plays),
    push: ({ node, axis }) => drive(`Push ${node} along ${axis}`, `drive ${node} along ${axis}`, "slide", data, { kind: "coordinate", node, axis }, plays),
    join: ({ ends }) => [`Bar ${ends.join(" to ")}`, `bar from ${ends.join(" to ")}`, ["bars", freeName(data, "bars", "b", false)], ends, false],
  };
  return clicks.length ? clicks.map((one) => steps[one.do](one)) : NO_CLICK;
}

/** Buttons of the next steps; each is one edit, which can be undone and changed in the panel. */
export function nextSteps(draw, play) {
  const found = stepsOf(draw.state);
  if (!found.length) return null;
  const act = async (path, value, plays) => {
    const answer = await draw.edit({ do: "set", path, value });
    if (answer.kind === "drawing" && plays && !play.playing) play.toggle();
  };
  return el("span", { class: "next" }, "Next: ", typeof found === "string" ? found : found.map(([words, label, path, value, plays]) => button(words, () => act(path, value, plays), { "aria-label": label })));
}
