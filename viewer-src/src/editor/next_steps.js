// What a drawing needs next until it runs, as buttons: what holds it, what turns it, what pulls at it.

import { el } from "../dom.js";
import { button } from "./fields.js";
import { freeName } from "./tools/given.js";

const MOST = 4; // buttons of a kind
const LOAD = -100; // N, upward

/** [words, label, path, value, whether it plays then] of each step. */
function stepsOf({ dim, nodes, members, fixed, drives, mobility, missing, data, force }) {
  if (dim !== 2 || !members.length || !mobility) return [];
  const at = new Map(nodes.map((name) => [name, members.filter(({ ends }) => ends.includes(name)).length]));
  const held = (node) => (fixed[node] || "").length === 2;
  const driven = new Set(drives.map(({ bar }) => bar));
  if (mobility.undriven > 1) {
    const ends = nodes.filter((name) => at.get(name) === 1 && !held(name));
    if (ends.length) return ends.slice(0, MOST).map((name) => [`Hold ${name}`, `support at ${name}`, ["fixed", name], "xy", false]);
  }
  if (mobility.undriven > 0) {
    if (force) return []; // springs hold it
    const turning = members.filter(({ name, ends }) => held(ends[0]) !== held(ends[1]) && !driven.has(name) && name in (data.bars || {}));
    return turning.slice(0, MOST).map(({ name, ends }) => [`Turn ${name} about ${ends.find(held)}`, `drive ${name} about ${ends.find(held)}`, ["drives", freeName(data, "drives", "motor")], { kind: "angle", bar: name }, true]);
  }
  if (!drives.length || !missing.some((words) => words.startsWith("No load"))) return [];
  const loose = nodes.filter((name) => !held(name)).sort((a, b) => at.get(b) - at.get(a));
  const node = loose.filter((name) => at.get(name) === at.get(loose[0])).at(-1);
  return node ? [[`${-LOAD} N down at ${node}`, `load on ${node}`, ["loads", freeName(data, "loads", `F_${node}`)], { node, force: ["0 N", `${LOAD} N`] }, true]] : [];
}

/** Buttons of the next steps; each is one edit, which can be undone and changed in the panel. */
export function nextSteps(draw, play) {
  const found = stepsOf(draw.state);
  if (!found.length) return null;
  const act = async (path, value, plays) => {
    const answer = await draw.edit({ do: "set", path, value });
    if (answer.kind === "drawing" && plays && !play.playing) play.toggle();
  };
  return el("span", { class: "next" }, "Next: ", found.map(([words, label, path, value, plays]) => button(words, () => act(path, value, plays), { "aria-label": label })));
}
