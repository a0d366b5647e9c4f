// The numbers beside the picture: every member with its values now.

import { el, fill } from "./dom.js";
import { channelText } from "./format.js";

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
    return own.flatMap((channel) => views.flatMap((view, k) => {
      if (channel.id !== "length" && !view.scene.channel(channel.id)) return [];
      const label = views.length > 1 ? `${channel.label}, ${this.app.labels[k]}` : channel.label;
      return [{ id: `${channel.id}:${k}`, label, channel, view }];
    }));
  }

  /** Columns and rows anew. */
  show() {
    const columns = this.columns();
    const heading = (id, label) => el("th", { scope: "col", "aria-sort": this.order.id === id ? (this.order.down ? "descending" : "ascending") : "none" },
      el("button", { type: "button", class: "link", onclick: () => this.sort(id) }, label));
    fill(this.head, el("tr", {}, heading("name", "member"), columns.map((one) => heading(one.id, one.label))));
    const { scene } = this.app.views[0];
    const wanted = this.filter.value.trim().toLowerCase();
    const rows = scene.members.map((name, member) => ({ name, member })).filter(({ name }) => name.toLowerCase().includes(wanted));
    const by = columns.find((one) => one.id === this.order.id);
    if (by) rows.sort((a, b) => (this.order.down ? 1 : -1) * (size(by, b.name) - size(by, a.name)));
    else if (!this.order.down) rows.reverse();
    this.rows = rows.slice(0, MOST);
    this.cells = [];
    fill(this.body, this.rows.map(({ name }) => this.row(name, columns)));
    this.note.textContent = rows.length > MOST ? `${MOST} of ${rows.length} members; sort or search to see others.` : "";
    this.node.hidden = !scene.members.length;
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
    for (const { cell, column, index } of this.cells) {
      cell.textContent = index < 0 ? "–" : channelText(column.channel, column.view.scene.value(column.channel.id, column.view.frame, index), true);
    }
  }

  mark() {
    const { picked } = this.app;
    for (const row of this.body.children) {
      const here = picked?.type === "member" && row.dataset.name === picked.name;
      row.toggleAttribute("aria-current", here);
      if (here && this.node.offsetParent) row.scrollIntoView({ block: "nearest" });
    }
  }
}

function size(column, name) {
  const { scene, frame } = column.view;
  const value = Math.abs(scene.value(column.channel.id, frame, scene.members.indexOf(name)));
  return Number.isNaN(value) ? -1 : value;
}
