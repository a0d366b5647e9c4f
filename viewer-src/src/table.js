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
    // of two runs only what colours, so that both are on the screen
    const chosen = views.length > 1 ? own.filter((one) => one.id === this.app.channel?.id).concat(own).slice(0, 1) : own;
    return chosen.flatMap((channel) => views.flatMap((view, k) => {
      const here = view.scene.channel(channel.id);
      if (channel.id !== "length" && !here) return [];
      const words = here?.over_run ? `${channel.label} (worst of the run)` : channel.label;
      const label = views.length > 1 ? `${words}, ${this.app.labels[k]}` : words;
      return [{ id: `${channel.id}:${k}`, label, channel, view }];
    }));
  }

  /** Columns and rows anew. */
  show() {
    const columns = this.columns();
    const heading = (id, label) => el("th", { scope: "col", "aria-sort": this.order.id === id ? (this.order.down ? "descending" : "ascending") : "none" },
      el("button", { type: "button", class: "link", onclick: () => this.sort(id) }, label));
    fill(this.head, el("tr", {}, heading("name", "member"), columns.map((one) => heading(one.id, one.label))));
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
    for (const { cell, column, index } of this.cells) {
      const { scene, frame } = column.view;
      const value = index < 0 ? NaN : scene.plainValue(column.channel.id, frame, index);
      cell.textContent = index < 0 ? "-" : channelText(column.channel, value, true) + this.mark_(column.channel, scene, index, value);
      cell.classList.toggle("over", ["capacity", "margin"].includes(column.channel.scale) && value > 1);
    }
  }

  /** What is to be known of a value. */
  mark_(channel, scene, index, value) {
    const name = scene.members[index];
    if (channel.id === "force" && scene.unsure.has(index)) return " †";
    return channel.id === "utilisation" && !Number.isNaN(value) && scene.header.not_checked?.[name] ? " *" : "";
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
  const { scene, frame } = column.view, index = scene.members.indexOf(name);
  const value = index < 0 ? NaN : Math.abs(scene.value(column.channel.id, frame, index));
  return Number.isNaN(value) ? -1 : value;
}
