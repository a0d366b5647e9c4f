// What can be changed in a live model: gravity, loads, payloads, load case, kinds of members.

import { el, fill } from "./dom.js";

const KINDS = ["rigid", "driven", "elastic", "cut"];

export class Changes {
  constructor(live) {
    this.live = live;
    this.acting = el("div", {});
    this.kind = el("div", {});
    this.node = el("div", {}, el("details", { open: true }, el("summary", {}, "Member"), this.kind),
      el("details", {}, el("summary", {}, "Gravity, payload, loads"), this.acting));
  }

  rebuild(setup) {
    this.setup = setup;
    fill(this.acting, this.cases(setup), this.gravity(setup), this.masses(setup), setup.loads.map((load) => this.load(load, setup)),
      this.load({ name: this.free(setup), node: this.chosen || setup.nodes[setup.nodes.length - 1], force: Array(setup.dim).fill(0) }, setup, "Add"));
    this.members(setup);
  }

  /** Send what fields hold; where one holds no number, or it is refused, they show again what is so. */
  async sent(fields, send) {
    if (fields.every((field) => Number.isFinite(field.valueAsNumber))) {
      if ((await send())?.kind === "error") this.rebuild(this.setup);
      return;
    }
    this.live.controls.tell("A field is empty or holds no number. It was set back.", true);
    this.rebuild(this.setup);
  }

  free(setup) {
    let k = 1;
    while (setup.loads.some((load) => load.name === `load_${k}`)) k++;
    return `load_${k}`;
  }

  cases(setup) {
    if (!setup.cases.length) return null;
    const choice = el("select", { "aria-label": "load case", onchange: () => this.live.ask({ do: "case", name: choice.value || null }) },
      el("option", { value: "" }, "all loads"), setup.cases.map((name) => el("option", { value: name, selected: name === setup.case }, name)));
    return el("label", { class: "row" }, "Load case", choice);
  }

  vector(values, label) {
    return values.map((value, k) => el("input", { type: "number", step: "any", value, "aria-label": `${label} ${"xyz"[k]}`, class: "component" }));
  }

  gravity(setup) {
    const fields = this.vector(setup.gravity, "gravity");
    const send = () => this.sent(fields, () => this.live.ask({ do: "gravity", value: fields.map((field) => field.valueAsNumber) }));
    const size = Math.hypot(...setup.gravity) || 9.80665;
    const turn = (axis, sign) => {
      fields.forEach((field, k) => (field.value = k === axis ? sign * size : 0));
      send();
    };
    const down = fields.flatMap((_, axis) => [1, -1].map((sign) => el("button", { type: "button", title: `gravity along ${sign < 0 ? "-" : "+"}${"xyz"[axis]}`, onclick: () => turn(axis, sign) }, `${sign < 0 ? "-" : "+"}${"xyz"[axis]}`)));
    fields.forEach((field) => field.addEventListener("change", send));
    return el("fieldset", {}, el("legend", {}, "Gravity (m/s²)"), el("div", { class: "row" }, fields), el("div", { class: "row" }, down));
  }

  masses(setup) {
    const heavy = Object.keys(setup.masses).reduce((best, name) => (setup.masses[name] > setup.masses[best] ? name : best));
    const usual = setup.masses[heavy] ? heavy : setup.nodes[setup.nodes.length - 1];
    this.chosen = this.chosen && this.chosen in setup.masses ? this.chosen : usual;
    const mass = el("input", { type: "number", min: 0, step: "any", value: setup.masses[this.chosen], "aria-label": "payload in kg", class: "component",
      onchange: () => this.sent([mass], () => this.live.ask({ do: "mass", node: node.value, mass: mass.valueAsNumber })) });
    const node = nodeChoice(setup, this.chosen, "node of the payload", (name) => {
      this.chosen = name;
      mass.value = setup.masses[name];
    });
    return el("fieldset", {}, el("legend", {}, "Payload (kg)"), el("div", { class: "row" }, node, mass));
  }

  load(load, setup, word = "Set") {
    if (!load.force) return el("p", { class: "faint" }, `Load ${load.name} changes in time; at its start here.`);
    const fields = this.vector(load.force, `load ${load.name}`);
    const node = nodeChoice(setup, load.node, `node of load ${load.name}`);
    const send = (force) => this.live.ask({ do: "load", name: load.name, node: node.value, force });
    const set = el("button", { type: "button", onclick: () => this.sent(fields, () => send(fields.map((field) => field.valueAsNumber))) }, word);
    const away = word === "Set" ? el("button", { type: "button", title: "Take this load away", onclick: () => send(fields.map(() => 0)) }, "×") : null;
    return el("fieldset", {}, el("legend", {}, word === "Set" ? `Load ${load.name} (N)` : "Another load (N)"), el("div", { class: "row" }, node, ...fields, set, away));
  }

  members(setup) {
    this.member = el("select", { "aria-label": "member", onchange: () => this.mark() }, setup.members.map(({ name, role, own }) => el("option", { value: name }, role === own ? name : `${name} (${role})`)));
    if (this.shown && setup.members.some((one) => one.name === this.shown)) this.member.value = this.shown;
    this.buttons = new Map([...KINDS, "own"].map((kind) => [kind, el("button", { type: "button", onclick: () => this.live.ask({ do: "switch", member: this.member.value, to: kind }) }, kind === "own" ? "as in the file" : kind)]));
    const lost = setup.lost.length ? el("p", { class: "faint" }, `Rests on changed members, not in the model now: ${setup.lost.join(", ")}.`) : null;
    fill(this.kind, setup.members.length ? [el("div", { class: "row" }, this.member, el("span", { class: "group" }, [...this.buttons.values()])), lost] : []);
    if (setup.members.length) this.mark();
  }

  mark() {
    this.shown = this.member.value;
    const { role } = this.setup.members.find((one) => one.name === this.shown);
    for (const [kind, button] of this.buttons) button.setAttribute("aria-pressed", String(kind === role));
  }

  picked(picked) {
    if (picked?.type !== "member") return;
    this.member.value = picked.name;
    this.mark();
  }
}

function nodeChoice(setup, chosen, label, then = () => {}) {
  const select = el("select", { "aria-label": label, onchange: () => then(select.value) }, setup.nodes.map((name) => el("option", { value: name, selected: name === chosen }, name)));
  return select;
}
