// The menu at the right button (a long press of a finger; the menu key, or Shift+F10): all tools that begin at what is there.

import { el } from "../dom.js";
import { iconOf } from "./palette.js";
import { GROUPS } from "./tools/index.js";

export class Menu {
  constructor(draw) {
    this.draw = draw;
    this.node = el("div", { class: "menu", role: "menu", tabindex: -1, hidden: true, onkeydown: (event) => this.key(event), onfocusout: (event) => !this.node.contains(event.relatedTarget) && this.close() });
  }

  /** Open at a place of the screen, for what is there: {node, member, share, point}. */
  open(place, target) {
    const { draw } = this, hit = target.node ? { type: "node", name: target.node } : target.member ? { type: "member", name: target.member } : null;
    const kinds = target.node ? ["node", "thing", "place"] : target.member ? ["member", "thing", "place"] : ["place", "spot"];
    if (hit && !draw.isPicked(hit)) draw.pick(hit);
    const groups = GROUPS.map(([name, tools]) => [name, tools.filter((tool) => kinds.includes(tool.takes?.([], draw)))]);
    const item = (label, act, icon) => el("button", { type: "button", role: "menuitem", tabindex: -1, onclick: () => { this.close(); draw.canvas.node.focus({ preventScroll: true }); act(); } }, icon || null, label);
    const own = [...groups.flatMap(([, tools]) => tools.map((tool) => item(tool.words, () => draw.tools.once(tool, target), iconOf(tool.icon))))];
    if (hit) own.push(item("Fields", () => draw.properties.focus()), item("Delete", () => draw.remove()));
    else own.push(item("Show all", () => draw.fit()), item("Undo", () => draw.ask({ do: "undo" })));
    this.node.setAttribute("aria-label", hit ? `what to do at ${hit.name}` : "what to do here");
    this.node.replaceChildren(el("b", {}, hit ? hit.name : "Here"), el("div", { class: "items" }, own));
    this.node.hidden = false;
    const { camera } = draw, { offsetWidth: wide, offsetHeight: high } = this.node;
    Object.assign(this.node.style, { left: `${Math.max(4, Math.min(place[0], camera.width - wide - 4))}px`, top: `${Math.max(4, Math.min(place[1], camera.height - high - 4))}px` });
    this.node.querySelector("button").focus({ preventScroll: true });
  }

  close() {
    this.node.hidden = true;
  }

  key(event) {
    const items = [...this.node.querySelectorAll("button")], here = items.indexOf(document.activeElement), { key } = event;
    event.stopPropagation();
    if (key === "Escape" || key === "Tab") {
      event.preventDefault();
      this.close();
      this.draw.canvas.node.focus({ preventScroll: true });
      return;
    }
    const by = { ArrowDown: 1, ArrowRight: 1, ArrowUp: -1, ArrowLeft: -1 }[key];
    const letter = items.findIndex((one, k) => k > here && one.textContent.trim().toLowerCase().startsWith(key.toLowerCase()));
    const to = by ? (here + by + items.length) % items.length : { Home: 0, End: items.length - 1 }[key] ?? (key.length === 1 && key !== " " ? letter : -1);
    if (to >= 0) items[to].focus();
    if (to >= 0 || (key.length === 1 && key !== " ")) event.preventDefault();
  }
}
