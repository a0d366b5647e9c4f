// What the drawing lacks, what moves, what is redundant, what is beyond a limit; drives and reactions.

import { el } from "../dom.js";
import { column, quantity } from "../format.js";
import { refill } from "./fields.js";

const HEADS = { mechanism: "moves", redundant: "redundant", drive: "drive", open: "does not close" };

export class Status {
  constructor(draw) {
    this.draw = draw;
    this.doing = el("p", { class: "busy", hidden: true });
    this.words = el("div", { class: "words", role: "status", "aria-live": "polite" });
    this.tables = el("div", {});
    this.mobility = el("pre", {});
    this.node = el("section", { class: "verdicts", "aria-label": "state of the drawing" }, this.doing, this.words);
    this.details = el("div", { class: "state" }, this.tables, el("details", {}, el("summary", {}, "Mobility"), this.mobility));
  }

  /** What is computed, in place of what was found before. */
  wait(words) {
    this.doing.hidden = !words;
    this.doing.textContent = words;
  }

  rebuild() {
    const { state } = this.draw;
    const rows = [];
    for (const text of state.missing) rows.push(["", text, "missing"]);
    for (const { kind, text } of state.warnings) rows.push([HEADS[kind] || kind, text]);
    for (const text of state.alarms) rows.push(["limit", text]);
    for (const { text, line } of state.faults || []) rows.push(["fault", line ? `Line ${line}: ${text}` : text]);
    const hints = state.hints || [], pins = state.pins || [];
    const key = JSON.stringify([rows, hints, pins, state.why]);
    if (key !== this.last) {
      this.last = key;
      const good = !rows.length && state.force;
      this.words.replaceChildren(el("p", {}, good ? el("b", { class: "good" }, `Stable, ${driven(state.drives.length)}. `) : null, state.why),
        el("ul", {}, rows.slice(0, 14).map(([head, text, kind = head.split(" ")[0]]) => el("li", { class: `of-${kind}` }, head ? el("b", {}, head) : null, head ? " " : null, text)), hints.map((text) => el("li", {}, el("b", {}, "note"), " ", text)),
          pins.map(({ node, member }) => el("li", {}, el("button", { type: "button", class: "pin", title: `${member} becomes a link through ${node}: stiff there, and pinned to what else is at ${node}`, onclick: () => this.draw.edit({ do: "pin", member, node }) }, `Pin ${node} to ${member}`)))));
    }
    this.mobility.textContent = state.mobility ? state.mobility.text || "It follows when the pointer rests." : "";
    this.numbers(state);
  }

  numbers(state) {
    const tables = [];
    if (state.drives.length) {
      tables.push(el("table", { class: "numbers" }, el("tr", {}, el("th", {}, "drive"), el("th", {}, "at"), el("th", {}, holding(state.drives))),
        state.drives.slice(0, 40).map(({ name, unit, value, force }) => el("tr", {}, el("th", {}, name), el("td", {}, quantity(value, unit)), el("td", {}, force === null ? "-" : quantity(force, unit === "rad" ? "N m" : "N"))))));
    }
    const axes = [..."xyz"].slice(0, state.dim);
    const reactions = Object.entries(state.reaction).slice(0, 60);
    if (reactions.length) {
      const moments = state.reaction_moment, turns = Object.keys(moments).length ? (state.dim === 3 ? axes : ["z"]) : [];
      const [forces, unit] = together(reactions.map(([, values]) => values), "N");
      const [couples, coupleUnit] = together(reactions.map(([name]) => moments[name] || []), "N m");
      const cells = (texts) => texts.map((text) => el("td", {}, text));
      tables.push(el("table", { class: "numbers" }, el("tr", {}, el("th", {}, "reaction"), axes.map((axis) => el("th", {}, `${axis} (${unit})`)), turns.map((axis) => el("th", {}, `M${axis} (${coupleUnit})`))),
        reactions.map(([name], k) => el("tr", {}, el("th", {}, name), cells(forces[k]), couples[k].length ? cells(couples[k]) : turns.map(() => el("td", {}))))));
    }
    refill(this.tables, ...tables);
  }
}

/** Texts of all numbers of a table in one unit, row by row, and the unit. */
function together(rows, unit) {
  const [texts, name] = column(rows.flat().map((value) => value ?? NaN), unit);
  return [rows.map((row) => texts.splice(0, row.length)), name];
}

function driven(count) {
  return count ? `with ${count === 1 ? "one drive" : `${count} drives`}` : "without a drive";
}

/** What holds drives: a torque about an axis, a force along a length. */
export function holding(drives) {
  const turning = drives.filter(({ unit }) => unit === "rad").length;
  return turning === drives.length ? "holding torque" : turning ? "holding force or torque" : "holding force";
}
