// All entries of the model by their tables, each as a form; runs, which can be started from here.

import { el, section } from "../dom.js";
import { button, choice, field, refill } from "./fields.js";
import { Forms, words } from "./forms.js";

const FIRST = ["active", "beams", "links", "bodies", "springs", "drives", "loads", "load_cases", "trajectories"];
const AGAIN = 300; // ms between questions how far a run is
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
    const names = Object.keys(all), { doing } = this;
    if (!names.includes(this.run)) this.run = names[0] || "";
    const add = () => this.draw.make("run");
    refill(this.runs, el("div", { class: "row" }, names.length ? choice("Run", names, this.run, (name) => { this.run = name; this.rebuild(); }, "run") : el("span", { class: "faint" }, "No run yet: a run moves the drives, or computes the equilibrium."),
      button("New run", add), this.run && !doing ? button("Do it", () => this.start(this.run), { "aria-label": `do run ${this.run}` }) : null),
      doing ? this.progress(doing) : null, doing?.name === this.run ? null : this.result(this.ran[this.run]), this.run ? this.form("runs", this.run) : null);
  }

  /** The run that is computed; what is drawn meanwhile does not change it. */
  progress({ name, done, total }) {
    this.bar = el("progress", { max: total || 1, value: done || undefined, "aria-label": `progress of ${name}` });
    this.share = el("span", { role: "status", "aria-live": "off" }, shareOf(this.doing));
    return el("div", { class: "row doing" }, this.share, this.bar, button("Stop", () => this.stop(), { "aria-label": `stop run ${name}` }));
  }

  result(found) {
    if (!found) return null;
    const changed = found.revision !== this.draw.state.revision;
    return el("div", { role: "status" }, el("pre", { class: "about" }, found.words), changed ? el("p", { class: "faint" }, "The drawing has changed since.") : null,
      found.number ? el("a", { href: `result/${found.number}`, target: "_blank", rel: "noopener" }, "Show the result") : null);
  }

  async start(name) {
    this.doing = { name };
    this.rebuild();
    this.hear(await this.draw.ask({ do: "run", name }));
  }

  async stop() {
    const { name } = this.doing || {}, answer = await this.draw.ask({ do: "stop" });
    this.hear(answer);
    if (answer.kind === "stopped") this.draw.tell(`The run ${name} was stopped.`);
  }

  /** How far the run is, or its end; asked again until it ends. */
  hear(answer) {
    clearTimeout(this.timer);
    const before = this.doing;
    this.doing = answer.kind === "running" ? answer : null;
    if (this.doing) this.timer = setTimeout(() => this.follow(), AGAIN);
    else if (answer.kind === "ran") {
      this.ran[answer.name] = answer;
      this.draw.tell(`The run ${answer.name} is done.`);
    }
    if (!this.doing || !before) return this.rebuild();
    this.bar.max = answer.total || 1;
    if (answer.done) this.bar.value = answer.done; // what is typed in the form stays
    this.share.textContent = shareOf(answer);
  }

  async follow() {
    if (this.doing) this.hear(await this.draw.ask({ do: "running" }));
  }

  /** The run of a page before this one. */
  take(running) {
    if (running?.form) return; // of a file
    if (running?.kind === "running") this.hear(running);
    else if (running?.kind === "ran") this.ran[running.name] = running;
  }
}

/** How far a run is. note : what is done before its first samples. */
function shareOf({ name, done, total, what = "samples", note = "" }) {
  return `Computing ${name}${total ? `: ${done} of ${total} ${what}` : " ..."}${note ? `. ${note}` : ""}`;
}
