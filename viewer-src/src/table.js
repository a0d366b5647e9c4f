// The numbers beside the picture: every member with its values now.

import { el, fill } from "./dom.js";
import { channelText, columnUpTo, held } from "./format.js";

const MOST = 150;

export class Table {
  constructor(app) {
    this.app = app;
    this.order = { id: "name", down: true };
    this.filter = el("input", { type: "search", placeholder: "find by name", "aria-label": "find members by name", oninput: () => this.show() });
    this.head = el("thead");
    this.body = el("tbody");
    this.note = el("p", { class: "faint" });
    this.node = el("section", { class: "table", "aria-label": "values of all members now" }, this.filter, el("div", { class: "scroll" }, el("table", { class: "numbers" }, this.head, this.body)), this.note);
  }

  columns() {
    const { scene } = this.app.views[0];
    const own = scene.header.channels.filter((channel) => channel.id !== "speed" || scene.header.channels.length === 1);
    const views = this.app.views;
    if (!own.length) own.push({ id: "length", label: "Length", unit: "m" });
    // of two runs only what colours, so that both are on the screen
    const chosen = views.length > 1 ? own.filter((one) => one.id === this.app.channel?.id).concat(own).slice(0, 1) : own;
    const mixed = views.some((view) => view.scene.header.channels.some((one) => one.over_run));
    return chosen.flatMap((channel) => views.flatMap((view, k) => {
      const here = view.scene.channel(channel.id);
      if (channel.id !== "length" && !here) return [];
      const unit = columnUpTo(this.largest(channel), [], channel.unit)[1];
      const label = views.length > 1 ? `${channel.label}, ${this.app.labels[k]}` : channel.label;
      return [{ id: `${channel.id}:${k}`, label, unit, when: !mixed ? "" : here?.over_run ? "worst of run" : "now", channel, view }];
    }));
  }

  /** The largest value of a channel over all pictures, which decides unit and decimals: they stay while the run plays. */
  largest(channel) {
    if (channel.id === "length") {
      return this.app.views.reduce((best, { scene }) => scene.members.reduce((most, _, k) => Math.max(most, scene.length(0, k)), best), 0);
    }
    const ranges = this.app.views.filter(({ scene }) => scene.channel(channel.id)).flatMap(({ scene }) => scene.range(channel.id));
    return Math.max(...ranges.map(Math.abs));
  }

  /** Columns and rows anew. */
  show() {
    const columns = this.columns();
    const heading = (id, label) => el("th", { scope: "col", "aria-sort": this.order.id === id ? (this.order.down ? "descending" : "ascending") : "none" },
      el("button", { type: "button", class: "link", onclick: () => this.sort(id) }, label));
    const words = ({ label, unit, when }) => [label, when ? el("small", {}, when) : null, unit ? el("small", { class: "unit" }, ` (${unit})`) : null];
    fill(this.head, el("tr", {}, heading("name", "member"), columns.map((one) => heading(one.id, words(one)))));
    const members = [...new Set(this.app.views.flatMap(({ scene }) => scene.members.filter((_, k) => scene.shows(k))))];
    const wanted = this.filter.value.trim().toLowerCase();
    const rows = members.map((name) => ({ name })).filter(({ name }) => name.toLowerCase().includes(wanted));
    const by = columns.find((one) => one.id === this.order.id);
    if (by) rows.sort((a, b) => (this.order.down ? 1 : -1) * (size(by, b.name) - size(by, a.name)));
    else if (!this.order.down) rows.reverse();
    this.rows = rows.slice(0, MOST);
    this.cells = [];
    fill(this.body, this.rows.map(({ name }) => this.row(name, columns)));
    const scenes = this.app.views.map(({ scene }) => scene);
    fill(this.note, rows.length > MOST ? el("span", {}, `${MOST} of ${rows.length} members; sort or search to see others. `) : null,
      columns.some((one) => one.channel.id === "force") && scenes.some((scene) => scene.unsure.size) ? el("span", {}, "† not unique: a share by stiffness or convention. ") : null,
      columns.some((one) => held(one.channel)) && scenes.some(({ unchecked }) => unchecked) ? el("span", {}, "- striped: not checked. ") : null,
      columns.some((one) => one.channel.id === "utilisation") && scenes.some((scene) => Object.keys(scene.header.not_checked || {}).length) ? el("span", {}, "* not every rule was checked: pick the member. ") : null);
    this.node.hidden = !members.length;
    this.update();
    this.mark();
  }

  row(name, columns) {
    const cells = columns.map((column) => {
      const cell = el("td");
      this.cells.push({ cell, column, index: column.view.scene.members.indexOf(name) });
      return cell;
    });
    const button = el("button", { type: "button", class: "link", onclick: () => this.app.pick({ type: "member", name }) }, name);
    return el("tr", { "data-name": name }, el("th", { scope: "row" }, button), cells);
  }

  pickFirst() {
    if (this.rows.length) this.app.pick({ type: "member", name: this.rows[0].name });
  }

  sort(id) {
    this.order = { id, down: this.order.id === id ? !this.order.down : true };
    this.show();
  }

  update() {
    const columns = new Map();
    for (const one of this.cells) {
      const { scene, frame } = one.column.view, { channel } = one.column;
      one.value = one.index < 0 ? NaN : scene.plainValue(channel.id, frame, one.index);
      columns.set(one.column, [...(columns.get(one.column) || []), one]);
    }
    for (const [column, cells] of columns) {
      const { channel, view: { scene } } = column, values = cells.map((one) => one.value);
      const texts = channel.scale === "margin" ? values.map((value) => channelText(channel, value, true)) : columnUpTo(this.largest(channel), values, channel.unit, 0, true)[0];
      cells.forEach(({ cell, value, index }, k) => {
        const mark = index < 0 ? "" : this.sign(channel, scene, index, value);
        cell.textContent = mark + texts[k];
        cell.classList.toggle("over", held(channel) && value > 1);
        cell.classList.toggle("hatched", mark.startsWith("†") || (index >= 0 && held(channel) && Number.isNaN(value)));
      });
    }
  }

  /** What is to be known of a value. */
  sign(channel, scene, index, value) {
    const name = scene.members[index];
    if (channel.id === "force" && scene.unsure.has(index)) return "† ";
    return channel.id === "utilisation" && !Number.isNaN(value) && scene.header.not_checked?.[name] ? "* " : "";
  }

  /** Scroll the table, not the page, until a row is seen. */
  reveal(row) {
    const box = this.body.closest(".scroll"), head = this.head.offsetHeight;
    if (row.offsetTop - head < box.scrollTop) box.scrollTop = row.offsetTop - head;
    else if (row.offsetTop + row.offsetHeight > box.scrollTop + box.clientHeight) box.scrollTop = row.offsetTop + row.offsetHeight - box.clientHeight;
  }

  mark() {
    const { picked } = this.app;
    for (const row of this.body.children) {
      const here = picked?.type === "member" && row.dataset.name === picked.name;
      row.toggleAttribute("aria-current", here);
      if (here) this.reveal(row);
    }
  }
}

function size(column, name) {
  const { scene, frame } = column.view, index = scene.members.indexOf(name);
  const value = index < 0 ? NaN : Math.abs(scene.value(column.channel.id, frame, index));
  return Number.isNaN(value) ? -1 : value;
}
