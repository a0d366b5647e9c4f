// A form of any record of the model: its fields, units, choices and library names come from the schema of model files.

import { el } from "../dom.js";
import { button, choice, field } from "./fields.js";

const SPECIAL = /[:#{}[\],&*!|>'"%@`]|^[-?]/;

/** A value as it is written in YAML, on one line. */
export function flow(value) {
  if (value === null || value === undefined) return "";
  if (Array.isArray(value)) return `[${value.map(flow).join(", ")}]`;
  if (typeof value === "object") return `{${Object.entries(value).map(([key, one]) => `${key}: ${flow(one)}`).join(", ")}}`;
  return typeof value === "string" && SPECIAL.test(value) ? JSON.stringify(value) : String(value);
}

const simple = ({ type, of }) => type === "value" || type === "choice" || type === "text" || type === "flag" || type === "any" || (type === "list" && of.type !== "record");

const DEGREE = Math.PI / 180;
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** An angle or a rate that the file has in rad, as it is read: 1.5708 is "90 deg"; in lists each. */
function inDegrees(value, unit) {
  if (Array.isArray(value)) return value.map((one) => inDegrees(one, unit));
  return typeof value === "number" ? `${Number((value / DEGREE).toPrecision(10))} ${unit}` : value;
}

/** What was typed with the unit that the field shows, where it has none. */
function withUnit(text, unit) {
  return text.split(",").map((part) => (NUMBER.test(part.trim()) ? `${part.trim()} ${unit}` : part.trim())).join(", ");
}

export class Forms {
  /** `drafts`: records whose needed fields are not all typed yet, by their path. */
  constructor(draw, again) {
    Object.assign(this, { draw, again, drafts: new Map(), open: new Set() });
  }

  get forms() {
    return this.draw.choices.forms;
  }

  /** The form of an entry, or of a draft of it. */
  entry(table, name) {
    const path = [table, name], spec = this.forms.tables[table];
    const given = this.draw.state.data[table]?.[name];
    const short = { nodes: "at", bars: "ends", beams: "ends", links: "nodes" }[table];
    const value = Array.isArray(given) && short ? { [short]: given } : given;
    if (spec.type !== "record" || (value !== undefined && typeof value !== "object")) return this.field(this.live(), spec, name, value, path);
    return this.record(this.live(), spec, table, value, path, true);
  }

  live() {
    return { set: (path, value) => this.draw.edit({ do: "set", path, value, typed: true }), draft: false };
  }

  /** Begin a record that is sent as a whole. */
  begin(path, value = {}) {
    this.drafts.set(path.join("."), value);
    this.again();
  }

  drafting(path) {
    const key = path.join("."), root = this.drafts.get(key);
    const set = (where, value) => {
      const steps = where.slice(path.length), last = steps.pop();
      let here = root;
      for (const step of steps) here = here[step] ??= {};
      if (value === null) delete here[last];
      else here[last] = value;
      this.again();
    };
    const send = async () => {
      const answer = await this.live().set(path, root);
      if (answer.kind !== "drawing") return;
      this.drafts.delete(key);
      this.again();
    };
    const drop = () => { this.drafts.delete(key); this.again(); };
    return { context: { set, draft: true }, root, actions: el("div", { class: "row" }, button("Apply", send, { "aria-label": `apply ${key}` }), button("Cancel", drop, { "aria-label": `cancel ${key}` })) };
  }

  /** The unit in which a turning value is shown and typed, deg or deg/s; "" of what does not turn. */
  degrees(spec, name) {
    const own = (spec.type === "list" ? spec.of : spec).unit || "", drive = this.draw.state.drives.find((one) => one.name === name);
    const unit = own.startsWith("rad") ? own : drive?.unit === "rad" && own.includes("or rad") ? own.split("or ")[1] : "";
    return { rad: "deg", "rad/s": "deg/s" }[unit] || "";
  }

  field(context, spec, name, value, path) {
    if (spec.type === "record") return this.record(context, spec, name, value, path);
    if (spec.type === "table" && simple(spec.of)) return this.table(context, spec, name, value, path);
    const label = path.join(".");
    if (spec.type === "flag" || (spec.type === "choice" && !spec.free)) {
      const options = (spec.type === "flag" ? [true, false] : spec.of).map(String);
      return choice(words(name), [["", spec.default === undefined ? "-" : `${spec.default} (default)`], ...options], value === undefined || value === null ? "" : String(value), (chosen) => context.set(path, chosen || null), label);
    }
    const list = spec.type === "list" && spec.of.type !== "record", degrees = this.degrees(spec, name), own = degrees ? inDegrees(value, degrees) : value;
    const shown = list && Array.isArray(own) ? flow(own).slice(1, -1) : typeof own === "string" ? own : flow(own);
    const unit = degrees || (spec.unit ?? (list ? spec.of.unit : ""));
    const set = (typed) => {
      if (typed === null) return context.set(path, null);
      const text = degrees && !String(typed).startsWith("[") ? withUnit(String(typed), degrees) : String(typed);
      if (list && !text.startsWith("[")) return context.set(path, spec.of.type === "list" ? `[[${text}]]` : `[${text}]`);
      return context.set(path, spec.type === "text" && SPECIAL.test(text) ? JSON.stringify(text) : text);
    };
    const hint = spec.default !== undefined && typeof spec.default !== "object" ? `${degrees ? spec.default / DEGREE : spec.default}${unit ? ` ${unit}` : ""}` : unit || (list ? "a, b" : "");
    const entry = field(words(name), shown, set, { hint, size: list || spec.type === "any" ? 16 : 9, name: label });
    offer(entry, label, spec.type === "choice" ? spec.of.map(String) : this.names(spec));
    if (unit && shown !== "") entry.title = unit;
    return entry;
  }

  table(context, spec, name, value, path) {
    const rows = Object.entries(value || {}).map(([key, one]) => el("div", { class: "row" }, this.field(context, spec.of, key, one, [...path, key])));
    const label = path.join(".");
    const names = this.names(spec.keys), next = (spec.keys.names || []).includes("drives") ? names.find((one) => !(one in (value || {}))) || "" : ""; // the drive that is meant, as a rule
    const unit = this.degrees(spec.of, next) || (spec.of.type === "list" ? spec.of.of.unit : spec.of.unit) || "";
    const fields = [["name", next, ""], ["value", "", unit]].map(([which, start, hint]) => field(which, start, () => {}, { hint, size: 8, name: `new ${which} in ${label}` }));
    offer(fields[0], `keys ${label}`, names);
    const add = () => {
      const [key, words] = fields.map((one) => one.querySelector("input").value.trim()), degrees = this.degrees(spec.of, key);
      const typed = degrees && !words.startsWith("[") ? withUnit(words, degrees) : words;
      if (key && typed) context.set([...path, key], spec.of.type === "list" && !typed.startsWith("[") ? `[${typed}]` : typed);
    };
    return el("fieldset", {}, el("legend", {}, words(name)), rows, el("div", { class: "row" }, fields, button("Add", add, { "aria-label": `add to ${label}` })));
  }

  /** A record: of a name, of its fields, or not given; of several kinds one is chosen. */
  record(context, spec, name, value, path, whole = false) {
    const label = path.join("."), { records } = this.forms;
    const draft = !context.draft && this.drafts.has(label) ? this.drafting(path) : null;
    const own = draft ? draft.root : value;
    const inner = draft ? draft.context : context;
    const filled = own !== null && typeof own === "object";
    const kind = filled ? spec.of.find((one) => records[one].kind === own.kind) || spec.of[0] : null;
    const begin = (record) => {
      const start = records[record].kind ? { kind: records[record].kind } : {};
      if (inner.draft) inner.set(path, start);
      else this.begin(path, start);
    };
    const names = this.names(spec);
    const options = [...(whole ? [] : [["", "-"]]), ...names, ...spec.of.map((one) => [`: ${one}`, spec.of.length > 1 ? words(records[one].kind || one) : names.length ? "own values ..." : "given"])];
    const choose = (chosen) => {
      if (chosen.startsWith(": ")) begin(chosen.slice(2));
      else if (draft) { this.drafts.delete(label); context.set(path, chosen || null); }
      else context.set(path, chosen || null);
    };
    const present = filled ? `: ${kind}` : value ?? "";
    if (typeof present === "string" && present && !options.some((one) => (Array.isArray(one) ? one[0] : one) === present)) options.push(present);
    const single = filled && spec.of.length < 2 && !names.length;
    const list = single ? null : choice(filled ? "kind" : words(name), options, present, choose, label);
    const remove = single && !whole && !spec.needed && !draft ? button("Remove", () => context.set(path, null), { "aria-label": `remove ${label}` }) : null;
    if (!filled) return list;
    const body = [list, remove, this.fields(inner, kind, own, path), draft?.actions];
    return whole ? el("div", { class: "form" }, body) : el("fieldset", { class: "form" }, el("legend", {}, words(name)), body);
  }

  /** The fields of a record: those that are given or needed, and the others folded. */
  fields(context, record, value, path) {
    const { fields, about } = this.forms.records[record], label = path.join(".");
    const [shown, more] = [[], []];
    for (const [name, spec] of Object.entries(fields)) (name in value || spec.needed ? shown : more).push(this.field(context, spec, name, value[name], [...path, name]));
    const folded = (title, content) => {
      const key = `${title} ${label}`;
      const part = el("details", { open: this.open.has(key) }, el("summary", { "aria-label": `${title} of ${label}` }, title), content);
      part.addEventListener("toggle", () => (part.open ? this.open.add(key) : this.open.delete(key)));
      return part;
    };
    return [el("div", { class: "row" }, shown), more.length ? folded("More fields", el("div", { class: "row" }, more)) : null, about && path.length === 2 ? folded("What they mean", el("pre", { class: "about" }, about)) : null];
  }

  /** Names of the model and of the library that a field may have; of bars as drives those that are driven. */
  names({ names = [], also = [] }) {
    const { data } = this.draw.state;
    const fits = (table, one) => table !== "poses" && (table !== "bars" || !names.includes("drives") || one.kind === "driven");
    const own = (table) => Object.entries(data[table] || {}).filter(([, one]) => fits(table, one)).map(([name]) => name);
    return [...new Set([...names.flatMap((table) => [...own(table), ...(this.draw.choices[table] || [])]), ...also])];
  }
}

/** Offer names for what is typed into a field. */
function offer(entry, label, names) {
  if (!names.length) return;
  const id = `names-${label.replace(/[^\w-]/g, "_")}`;
  entry.querySelector("input").setAttribute("list", id);
  entry.append(el("datalist", { id }, names.map((one) => el("option", { value: one }))));
}

export function words(name) {
  return name.replaceAll("_", " ");
}
