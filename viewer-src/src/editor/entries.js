// All entries of the model by their tables, each as a form; runs, which can be started from here.

import { el, section } from "../dom.js";
import { button, choice, field, refill } from "./fields.js";
import { Forms, words } from "./forms.js";

const FIRST = ["active", "beams", "bodies", "springs", "drives", "loads", "load_cases", "trajectories"];
const STEMS = { bodies: "body", trajectories: "trajectory", load_cases: "case", poses: "pose" };

export class Entries {
  constructor(draw) {
    Object.assign(this, { draw, table: "springs", name: "", ran: {} });
    this.forms = new Forms(draw, () => this.rebuild());
    this.body = el("div", {});
    this.runs = el("div", {});
    this.node = section("Entries of the model", this.body);
    this.runsNode = section("Runs", this.runs);
    this.node.open = false;
  }

  /** Show an entry. */
  show([table, name]) {
    const run = table === "runs";
    Object.assign(this, run ? { run: name } : { table, name });
    (run ? this.runsNode : this.node).open = true;
    this.rebuild();
  }

  rebuild() {
    const { draw } = this, { state } = draw;
    if (!state) return;
    this.entries(state.data);
    this.listRuns(state.data.runs || {});
  }

  entries(data) {
    const { tables } = this.draw.choices.forms;
    const count = (table) => Object.keys(data[table] || {}).length;
    const known = Object.keys(tables).filter((table) => table !== "runs" && (!(table in data) || !Array.isArray(data[table])));
    const sorted = [...FIRST, ...known.filter((table) => !FIRST.includes(table))];
    const names = Object.keys(data[this.table] || {});
    const drafts = [...this.forms.drafts.keys()].filter((key) => key.startsWith(`${this.table}.`) && !names.includes(key.slice(this.table.length + 1)) && key.split(".").length === 2).map((key) => key.slice(this.table.length + 1));
    if (![...names, ...drafts].includes(this.name)) this.name = names[0] || drafts[0] || "";
    refill(this.body, el("div", { class: "row" }, choice("Table", sorted.map((table) => [table, `${words(table)} (${count(table)})`]), this.table, (table) => { Object.assign(this, { table, name: "" }); this.rebuild(); }, "table of entries"),
      choice("Entry", [...names, ...drafts.map((name) => [name, `${name} (new)`])], this.name, (name) => { this.name = name; this.rebuild(); }, "entry"),
      button("New", () => this.fresh(), { "aria-label": "new entry" })),
      el("p", { class: "faint" }, tables[this.table].about), this.name ? this.form(this.table, this.name) : null);
  }

  /** The form of an entry with its name. */
  form(table, name) {
    const there = name in (this.draw.state.data[table] || {});
    return el("div", {}, there ? el("div", { class: "row" }, this.naming(table, name), button("Delete", () => this.draw.edit({ do: "set", path: [table, name], value: null }), { "aria-label": `delete ${table} ${name}` })) : null, this.forms.entry(table, name));
  }

  naming(table, name) {
    const rename = async (value) => {
      if (value === null) return this.rebuild();
      const answer = await this.draw.edit({ do: "rename", table, old: name, new: String(value) });
      if (answer.kind === "drawing") this.show([table, String(value)]);
    };
    return field("Name", name, rename, { name: `name of ${table} ${name}` });
  }

  fresh() {
    const { table } = this, spec = this.draw.choices.forms.tables[table];
    const stem = STEMS[table] || table.replace(/s$/, "");
    const used = this.draw.state.data[table] || {};
    let number = 1;
    while (`${stem}${number}` in used || this.forms.drafts.has(`${table}.${stem}${number}`)) number++;
    this.name = `${stem}${number}`;
    const { kind } = spec.type === "record" ? this.draw.choices.forms.records[spec.of[0]] : {};
    this.forms.begin([table, this.name], kind ? { kind } : {});
  }

  listRuns(all) {
    const names = Object.keys(all);
    if (!names.includes(this.run)) this.run = names[0] || "";
    const found = this.ran[this.run];
    const add = () => this.draw.make("run");
    refill(this.runs, el("div", { class: "row" }, names.length ? choice("Run", names, this.run, (name) => { this.run = name; this.rebuild(); }, "run") : el("span", { class: "faint" }, "No run yet: a run moves the drives, or computes the equilibrium."),
      button("New run", add), this.run ? button("Do it", () => this.start(this.run), { "aria-label": `do run ${this.run}` }) : null),
      found ? el("div", { role: "status" }, el("pre", { class: "about" }, found.words), found.number ? el("a", { href: `result/${found.number}`, target: "_blank", rel: "noopener" }, "Show the result") : null) : null,
      this.run ? this.form("runs", this.run) : null);
  }

  async start(name) {
    this.draw.tell(`The run ${name} is computed ...`);
    const answer = await this.draw.ask({ do: "run", name });
    if (answer.kind !== "ran") return;
    this.ran[name] = answer;
    this.draw.tell(`The run ${name} is done.`);
    this.rebuild();
  }
}
