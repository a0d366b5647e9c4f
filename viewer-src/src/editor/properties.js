// What is picked: exact places, lengths, supports, kinds, drives, loads.

import { el, section } from "../dom.js";
import { quantity } from "../format.js";
import { Forms } from "./forms.js";
import { materialChoice, sectionChoice, weightText } from "./sections.js";
import { button, check, choice, field, refill, showIn } from "./fields.js";
import { freeName, memberOf } from "./tools/given.js";

const KINDS = [["rigid", "rigid"], ["driven", "driven length"], ["elastic", "elastic (spring)"], ["cable", "cable"], ["free", "free (measures only)"]];
const OTHER = [["active", "active member (rods, screw, motor)"], ["beam", "beam (bends)"], ["link", "link (more pins)"]];
const MAKES = { angle_spring: "Angle spring", body: "Body" };
const LISTED = 12; // names of what is picked
const AXES = [..."xyz"];

export class Properties {
  constructor(draw) {
    this.draw = draw;
    this.body = el("div", {});
    this.forms = new Forms(draw, () => this.rebuild());
    this.node = section("Picked", this.body);
    this.fresh = el("div", {});
    this.freshNode = section("Node by its place", this.fresh);
  }

  /** Its first field, for the keys. */
  focus() {
    this.node.open = true;
    (this.body.querySelector("input[type=text]") || this.body.querySelector("select")).focus();
  }

  set(path, value) {
    return this.draw.edit({ do: "set", path, value });
  }

  entry(table, name) {
    const found = this.draw.state.data[table]?.[name];
    return Array.isArray(found) ? { [{ nodes: "at", links: "nodes" }[table] || "ends"]: found } : found || {};
  }

  rebuild() {
    const { draw } = this, { picked, state } = draw;
    if (!state) return;
    const nodes = [...picked.nodes], members = [...picked.members];
    const lists = this.lists(state, nodes, members);
    refill(this.fresh, this.newNode());
    if (nodes.length === 1 && !members.length) refill(this.body, lists, this.ofNode(nodes[0]));
    else if (members.length === 1 && !nodes.length) refill(this.body, lists, this.ofMember(members[0]));
    else refill(this.body, lists, el("p", { class: "faint" }, nodes.length + members.length ? [counted(nodes, "node"), counted(members, "member")].filter(Boolean).join("; ") : "Nothing is picked."), members.length > 1 ? this.ofMany(members) : null, this.making([...(members.length === 2 ? ["angle_spring"] : []), ...(nodes.length + members.length > 1 ? ["body"] : [])]), state.nodes.length ? null : this.other(state.dim));
  }

  /** Lists of all nodes and members: picking by keys; and the name of what is picked. */
  lists(state, nodes, members) {
    const list = (type, names, chosen) => choice("", [["", `${type} ...`], ...names], chosen.length === 1 ? chosen[0] : "", (name) => this.draw.pick(name ? { type, name } : null), `pick a ${type}`);
    return el("div", { class: "row" }, list("node", state.nodes, nodes), list("member", [...new Set(state.members.map(({ name }) => name))], members), nodes.length + members.length === 1 ? this.naming(nodes.length ? "nodes" : memberOf(this.draw, members[0]).table, [...nodes, ...members][0]) : null);
  }

  /** An empty drawing of the other kind. */
  other(dim) {
    const words = dim === 2 ? "Draw in space" : "Draw in the plane";
    return el("div", { class: "row" }, el("span", { class: "faint" }, `This drawing is ${dim === 2 ? "planar" : "in space"}.`), button(words, () => this.draw.edit({ do: "fresh", dim: 5 - dim })));
  }

  /** A node by its coordinates; the next one can be typed at once. */
  newNode() {
    const { dim } = this.draw.state;
    const inputs = AXES.slice(0, dim).map((axis) => field(axis, "", () => {}, { hint: "0", size: 6, name: `${axis} of the new node` }));
    const add = async () => {
      const words = inputs.map((one) => one.querySelector("input").value.trim() || "0");
      const answer = await this.draw.edit({ do: "add", at: words.map((word) => (Number.isFinite(Number(word)) ? Number(word) : word)) });
      if (answer.kind !== "drawing") return;
      this.draw.reveal();
      this.fresh.querySelector('[aria-label="x of the new node"]').focus();
    };
    for (const one of inputs) one.addEventListener("keydown", (event) => event.key === "Enter" && add());
    return el("div", { class: "row" }, inputs, button("Add node", add), el("small", {}, "m, or with a unit"));
  }

  ofNode(name) {
    const { draw } = this, { state } = draw, entry = this.entry("nodes", name);
    const places = AXES.slice(0, state.dim).map((axis, k) => field(axis, shortened(entry.at?.[k]), (value) => {
      if (value === null) return this.rebuild();
      const at = [...entry.at];
      at[k] = value;
      draw.edit({ do: "move", places: { [name]: at } }).then(() => draw.reveal());
    }, { size: 8, name: `${axis} of ${name}` }));
    const held = state.fixed[name] || "";
    const hold = AXES.slice(0, state.dim).map((axis, k) => check(axis, held.includes(axis), (on) =>
      this.set(["fixed", name], AXES.slice(0, state.dim).filter((one) => (one === axis ? on : held.includes(one))).join("") || null), `hold ${name} along ${axis}`));
    return [el("fieldset", {}, el("legend", {}, "Place (m, or with a unit: 50 mm, 2 in)"), el("div", { class: "row" }, places)),
      el("fieldset", {}, el("legend", {}, "Support: held along"), el("div", { class: "row" }, hold, button("All", () => this.set(["fixed", name], AXES.slice(0, state.dim).join("")), { "aria-label": `hold ${name}` }), button("Free", () => this.set(["fixed", name], null), { "aria-label": `free ${name}` }))),
      this.load(name), el("div", { class: "row" }, field("Mass", entry.mass, (value) => this.set(["nodes", name, "mass"], value), { hint: "0 kg", name: `mass of ${name}` }), this.slide(name))];
  }

  /** A drive of a coordinate of the node. */
  slide(name) {
    const { state } = this.draw;
    const own = Object.entries(state.data.drives || {}).find(([, one]) => one.kind === "coordinate" && one.node === name);
    return choice("Driven along", [["", "-"], ...AXES.slice(0, state.dim)], own?.[1].axis || "", (axis) =>
      this.set(["drives", own?.[0] || this.free("drives", "slide")], axis ? { kind: "coordinate", node: name, axis } : null), `drive ${name} along`);
  }

  load(name) {
    const { state } = this.draw;
    const own = Object.entries(state.data.loads || {}).find(([, one]) => one.node === name && one.force);
    const force = own ? own[1].force : Array(state.dim).fill(0);
    const fields = AXES.slice(0, state.dim).map((axis, k) => field(`F${axis}`, own ? force[k] : "", (value) => {
      const next = force.map((one, i) => (i === k ? value ?? 0 : one));
      const none = next.every((one) => Number(one) === 0);
      this.set(["loads", own?.[0] || this.free("loads", `F_${name}`)], none ? null : { ...(own?.[1] || {}), node: name, force: next });
    }, { hint: "0 N", size: 6, name: `force on ${name} along ${axis}` }));
    return el("fieldset", {}, el("legend", {}, "Load (N, or with a unit: 2 kN)"), el("div", { class: "row" }, fields));
  }

  ofMember(name) {
    const { draw } = this, { state } = draw;
    const { table } = memberOf(draw, name);
    if (table !== "bars") return this.ofOther(table, name);
    const entry = this.entry("bars", name);
    const kind = entry.kind || "rigid";
    this.span = el("small", { class: "span" }, this.spanText(name));
    const weight = el("small", { class: "weight" }, weightText(draw, name));
    const soft = kind === "elastic" || kind === "cable";
    const length = soft ? field("Natural length", entry.natural_length, (value) => this.set(["bars", name, "natural_length"], value), { hint: "as drawn", name: `natural length of ${name}` })
      : field("Length", entry.length, (value) => this.set(["bars", name, "length"], value), { hint: "as drawn", name: `length of ${name}` });
    return [this.span, weight,
      el("div", { class: "row" }, choice("Kind", [...KINDS, ...OTHER], kind, (value) => this.setKind(name, value), `kind of ${name}`), length),
      soft ? el("div", { class: "row" }, field("Stiffness", entry.stiffness, (value) => this.set(["bars", name, "stiffness"], value), { hint: "E A/l", name: `stiffness of ${name}` }),
        field("Pretension", entry.pretension, (value) => this.set(["bars", name, "pretension"], value), { hint: "0 N", name: `pretension of ${name}` })) : null,
      this.made("bars", name, entry), el("div", { class: "row" }, this.angle(name), button(MAKES.angle_spring, () => this.draw.make("angle_spring")))];
  }

  /** Of what it is made, and what it weighs. */
  made(table, name, entry) {
    const { draw } = this, set = (key) => (value) => this.set([table, name, key], value);
    return [el("div", { class: "row" }, sectionChoice(draw, entry.section, set("section"), `section of ${name}`, entry.material || draw.state.data.material)),
      el("div", { class: "row" }, materialChoice(draw, entry.material, set("material"), `material of ${name}`), field("Mass", entry.mass, set("mass"), { hint: "of its section", size: 10, name: `mass of ${name}` }))];
  }

  /** An active member, a beam or a link: all its fields. */
  ofOther(table, name) {
    this.span = el("small", { class: "span" }, this.spanText(name));
    const kind = { beams: "beam", links: "link" }[table] || "active";
    return [this.span, el("small", { class: "weight" }, weightText(this.draw, name)), el("div", { class: "row" }, choice("Kind", [["bar", "bar"], ...OTHER], kind, (value) => this.draw.make(value), `kind of ${name}`)),
      table === "beams" ? this.beamEnds(name) : this.making(["angle_spring"]), table === "active" ? null : this.made(table, name, this.entry(table, name)), this.forms.entry(table, name)];
  }

  /** How a beam is joined at its ends. */
  beamEnds(name) {
    const { data } = this.draw.state, entry = this.entry("beams", name), release = entry.release || [];
    const clamped = data.clamped || [], held = (node) => (Array.isArray(clamped) ? clamped.includes(node) : node in clamped);
    const without = (list, node) => (list.filter((one) => one !== node).length ? list.filter((one) => one !== node) : null);
    const choose = async (node, how) => {
      if (release.includes(node) !== (how === "hinge")) await this.set(["beams", name, "release"], how === "hinge" ? [...release, node] : without(release, node));
      if (held(node) === (how === "clamped")) return;
      if (!Array.isArray(clamped)) await this.set(["clamped", node], null);
      else await this.set(["clamped"], how === "clamped" ? [...clamped, node] : without(clamped, node));
    };
    return el("div", { class: "row" }, entry.ends.map((node) => choice(`At ${node}`, [["joined", "joined stiffly"], ["hinge", "hinge"], ["clamped", "clamped to the ground"]], release.includes(node) ? "hinge" : held(node) ? "clamped" : "joined", (how) => choose(node, how), `end of ${name} at ${node}`)));
  }

  /** Buttons for parts that are made from what is picked. */
  making(whats) {
    return el("div", { class: "row" }, whats.map((what) => button(MAKES[what], () => this.draw.make(what))));
  }

  /** Another kind; an elastic bar without section and material needs a stiffness, which is offered. */
  setKind(name, kind) {
    if (OTHER.some(([other]) => other === kind)) return this.draw.make(kind);
    const entry = { ...this.entry("bars", name) }, { state } = this.draw;
    delete entry.kind;
    if (kind === "elastic" || kind === "cable") {
      delete entry.length;
      const stiff = (entry.section || state.data.section) && (entry.material || state.data.material);
      if (!stiff && entry.stiffness === undefined) entry.stiffness = "1 kN/m";
    } else for (const field of ["stiffness", "natural_length", "pretension", "strain"]) delete entry[field];
    this.set(["bars", name], kind === "rigid" ? (Object.keys(entry).length === 1 ? entry.ends : entry) : { ...entry, kind });
  }

  ofMany(members) {
    const set = async (key, value) => {
      for (const name of members) if (name in (this.draw.state.data.bars || {})) await this.set(["bars", name, key], value);
    };
    return el("div", { class: "row" }, sectionChoice(this.draw, null, (value) => set("section", value), "section of all picked"), materialChoice(this.draw, null, (value) => set("material", value), "material of all picked"));
  }

  angle(name) {
    const { state } = this.draw;
    const own = Object.entries(state.data.drives || {}).find(([, one]) => (one.kind || "angle") === "angle" && one.bar === name);
    const options = state.dim === 2 ? [["", "-"], ["on", "yes"]] : [["", "-"], ...AXES.map((axis) => [axis, `about ${axis}`])];
    return choice("Driven angle", options, own ? own[1].axis || "on" : "", (value) =>
      this.set(["drives", own?.[0] || this.free("drives", "motor")], value ? { kind: "angle", bar: name, ...(state.dim === 3 ? { axis: value } : {}) } : null), `driven angle of ${name}`);
  }

  free(table, stem) {
    return freeName(this.draw.state.data, table, stem);
  }

  naming(table, name) {
    return field("Name", name, (value) => (value === null ? this.rebuild() : this.draw.edit({ do: "rename", table, old: name, new: String(value) })), { size: 5, name: `name of ${name}` });
  }

  spanText(name) {
    const { state } = this.draw;
    const k = state.members.findIndex((one) => one.name === name);
    if (k < 0) return "";
    const parts = state.members.filter((one) => one.name === name).map(({ ends }) => ends); // of a link one between each two pins
    const length = (pair) => ((a, b) => Math.hypot(...a.map((value, i) => value - b[i])))(...pair.map((end) => this.draw.at(end)));
    const force = state.force?.[k] ?? null;
    return `${[parts[0][0], ...parts.map((pair) => pair[1])].join(" to ")}, ${quantity(parts.map(length).reduce((sum, one) => sum + one), "m")}${force === null ? "" : `, ${quantity(force, "N")}${state.unsure.includes(name) ? " (not unique)" : ""}`}`;
  }

  /** While nodes are dragged: only what they change. */
  follow() {
    const { picked, state } = this.draw;
    if (picked.members.size === 1 && this.span) this.span.textContent = this.spanText([...picked.members][0]);
    if (picked.nodes.size !== 1) return;
    const [name] = picked.nodes;
    state.places[state.nodes.indexOf(name)].forEach((value, k) => {
      const input = this.body.querySelector(`[aria-label="${AXES[k]} of ${CSS.escape(name)}"]`);
      if (input) showIn(input, shortened(value));
    });
  }
}

/** A number as short as a micrometre in ten metres allows; the model has all its digits. */
function shortened(value) {
  return typeof value === "number" ? Number(value.toPrecision(7)) : value;
}

/** How many and which: "2 nodes: A, B". */
function counted(names, what) {
  if (!names.length) return "";
  return `${names.length} ${what}${names.length === 1 ? "" : "s"}: ${names.slice(0, LISTED).join(", ")}${names.length > LISTED ? " ..." : ""}`;
}
