// The buttons of the tools: all in sight; on a phone a row of their groups, and one of the tools of the group that is open.

import { el, press, svg } from "../dom.js";
import { GROUPS, TOOLS } from "./tools/index.js";

/** The picture of a tool. */
export function iconOf(path) {
  return svg("svg", { class: "icon", viewBox: "0 0 24 24", width: 24, height: 24, "aria-hidden": "true" }, svg("path", { d: path }));
}

export class Palette {
  constructor(draw) {
    this.tools = new Map([...TOOLS.values()].map(({ name, words, key, about, icon }) => [name, el("button", { type: "button", "aria-label": words, title: `${about} (${key.toUpperCase()})`, onclick: () => draw.setTool(name) }, iconOf(icon), el("span", {}, words))]));
    this.groups = GROUPS.map(([name, tools]) => {
      const head = el("button", { type: "button", class: "head", "aria-label": `${name}: ${tools.map(({ words }) => words).join(", ")}`, onclick: () => this.open(group) });
      const group = { name, tools, head, buttons: tools.map((tool) => this.tools.get(tool.name)) };
      group.node = el("span", { class: "group", role: "group", "aria-label": name }, head, group.buttons);
      return group;
    });
    this.node = el("div", { class: "palette", role: "toolbar", "aria-label": "tools" }, this.groups.map(({ node }) => node));
  }

  open(group) {
    for (const one of this.groups) {
      one.node.classList.toggle("open", one === group);
      one.head.setAttribute("aria-expanded", String(one === group));
    }
  }

  /** The chosen tool, which stands for its group; a group without a tool in this drawing is not shown. */
  rebuild(chosen, dim) {
    for (const [name, one] of this.tools) press(one, chosen === name);
    for (const name of ["positions", "path"]) this.tools.get(name).hidden = dim === 3;
    for (const { name, tools, head, buttons } of this.groups) {
      const own = tools.find((tool) => tool.name === chosen);
      head.hidden = buttons.every(({ hidden }) => hidden);
      head.setAttribute("aria-current", String(Boolean(own)));
      head.replaceChildren(iconOf((own || tools[0]).icon), el("span", {}, own ? own.words : name.split(" ")[0]));
    }
    if (chosen !== this.chosen) this.open(this.groups.find(({ tools }) => tools.some((tool) => tool.name === chosen)));
    this.chosen = chosen;
  }
}
