// Every key, what it does, and the page that lists them.

import { el } from "./dom.js";

export const KEYS = [
  ["Time", [
    [" ", "play or pause", (app) => app.togglePlay(), "space"],
    ["ArrowRight", "one sample on (Shift: ten)", (app, event) => app.step(event.shiftKey ? 10 : 1), "→"],
    ["ArrowLeft", "one sample back (Shift: ten)", (app, event) => app.step(event.shiftKey ? -10 : -1), "←"],
    ["Home", "to the start", (app) => app.goTo(0)],
    ["End", "to the end", (app) => app.goTo(app.lead.frames - 1)],
    ["+", "faster", (app) => app.faster(1)],
    ["-", "slower", (app) => app.faster(-1)],
    ["x", "to the worst sample of what colours", (app) => app.toWorst()],
  ]],
  ["What is shown", [
    ["c", "next colour (Shift: previous)", (app, event) => app.nextChannel(event.shiftKey ? -1 : 1)],
    ["s", "next diagram over the structure (Shift: previous)", (app, event) => app.nextDiagram(event.shiftKey ? -1 : 1)],
    ["e", "next load case", (app) => app.nextCase()],
    ["m", "next mode or mechanism", (app) => app.nextMode()],
    ["g", "start pose as a ghost", (app) => app.toggle("ghost")],
    ["y", "paths of all nodes that move", (app) => app.toggle("paths")],
    ["l", "loads", (app) => app.toggle("loads")],
    ["b", "supports", (app) => app.toggle("supports")],
    ["r", "faces of rigid bars", (app) => app.toggle("faces")],
    ["h", "ground grid", (app) => app.toggle("grid")],
    ["a", "names", (app) => app.toggle("names")],
    ["v", "panel beside the picture", (app) => app.togglePanel()],
    ["d", "dark or light", (app) => app.toggleTheme()],
  ]],
  ["Picking", [
    ["n", "next member (Shift: next node)", (app, event) => app.pickNext(event.shiftKey ? "node" : "member", 1)],
    ["p", "previous member (Shift: node)", (app, event) => app.pickNext(event.shiftKey ? "node" : "member", -1)],
    ["w", "the worst member now", (app) => app.pickWorst()],
    ["t", "path of the picked node", (app) => app.toggleTrace()],
    ["/", "find by name", (app) => app.find()],
    ["Escape", "nothing picked", (app) => app.escape(), "Esc"],
  ]],
  ["Camera", [
    ["1", "from a corner", (app) => app.aim("corner")],
    ["2", "from the front (along y)", (app) => app.aim("front")],
    ["3", "from the side (along x)", (app) => app.aim("side")],
    ["4", "from above (the x-y plane)", (app) => app.aim("plane")],
    ["f", "fit", (app) => app.aim(app.views[0].preset)],
    ["i", "turn up", (app) => app.orbit(0, 0.12, 1)],
    ["k", "turn down", (app) => app.orbit(0, -0.12, 1)],
    ["j", "turn left", (app) => app.orbit(-0.12, 0, 1)],
    ["o", "turn right", (app) => app.orbit(0.12, 0, 1)],
    [",", "nearer", (app) => app.orbit(0, 0, 0.9)],
    [".", "farther", (app) => app.orbit(0, 0, 1.1)],
    ["?", "this page", (app) => app.toggleHelp()],
  ]],
];

const TURNING = new Set([..."1234ikjo"]); // keys of the camera that a planar structure does not have
const TYPING = new Set(["text", "search", "number"]);

/** Let the keys act on an app; typing into a field stays typing. */
export function listen(app, target, signal) {
  const actions = new Map(KEYS.flatMap(([, rows]) => rows.map(([name, , action]) => [name, action])));
  target.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const field = event.target;
    if (event.key !== "Escape" && field.closest?.(".controls")) return; // sliders and fields have their own keys
    if (field.tagName === "INPUT" && TYPING.has(field.type)) {
      if (event.key === "Enter") app.table.pickFirst();
      if (event.key === "Escape" || event.key === "Enter") field.blur();
      return;
    }
    const own = (field.tagName === "BUTTON" && (event.key === " " || event.key === "Enter")) || field.tagName === "SELECT";
    if (own) return;
    const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const action = actions.get(name);
    if (!action) return;
    event.preventDefault();
    action(app, event);
  }, { signal });
  // a list chosen from with the pointer gives the keys back; one stepped through with the keys keeps them
  let pointed = false;
  target.addEventListener("pointerdown", () => (pointed = true), { signal });
  target.addEventListener("keydown", () => (pointed = false), { capture: true, signal });
  target.addEventListener("change", (event) => {
    if (pointed && event.target.tagName === "SELECT") event.target.blur();
  }, { signal });
}

export function helpPage(app) {
  const flat = app.views[0].scene.dim === 2;
  const known = KEYS.map(([title, rows]) => [title, rows.filter(([name]) => !flat || !TURNING.has(name))]);
  const lists = known.map(([title, rows]) => el("div", {}, el("h3", {}, title), el("dl", {}, rows.map(([name, words, , shown]) => [el("dt", {}, el("kbd", {}, shown || name.toUpperCase())), el("dd", {}, words)]).flat())));
  const close = el("button", { type: "button", onclick: () => app.toggleHelp() }, app.hint("Close", "Esc"));
  const hands = app.touch ? `${flat ? "Drag to shift, two fingers to approach" : "Drag to turn, two fingers to shift and approach"}, tap to pick.` : `${flat ? "Drag to shift" : "Drag to turn, right-drag to shift"}, wheel to approach, click to pick.`;
  const marks = `Bars thinner than a hundredth of the usual length are drawn thicker, to be seen. Green: what moves by itself (collars at the screw, rings at motors). Hatched: supports. Violet arrows: loads. Striped: not checked, or a force that is not unique. ${hands}`;
  // the button is the only thing in it that takes the focus: it keeps it until the page is closed
  const kept = (event) => {
    if (event.key !== "Tab") return;
    event.preventDefault();
    close.focus();
  };
  return el("div", { class: "help", role: "dialog", "aria-modal": "true", "aria-label": app.touch ? "help" : "keys", hidden: true, onkeydown: kept },
    el("div", { class: "sheet" }, app.touch ? el("h2", {}, "Help") : [el("h2", {}, "Keys"), el("div", { class: "columns" }, lists)], el("p", {}, marks), close));
}
