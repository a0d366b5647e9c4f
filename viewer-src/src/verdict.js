// The verdict above the picture: OK, over capacity or not verified; what governs, and a way there.

import { el, fill } from "./dom.js";

const SIGNS = { ok: "✓", over: "✕", open: "-", none: "-" };

export class Verdict {
  constructor(app) {
    this.app = app;
    this.node = el("div", { class: "verdicts", role: "status", "aria-label": "verdict" });
    this.update();
  }

  update() {
    const told = JSON.stringify(this.app.views.map(({ scene }) => scene.header.verdict || null));
    if (told === this.told) return; // a status that is written anew is read aloud anew
    this.told = told;
    fill(this.node, this.app.views.map((view, k) => this.strip(view, k)));
    this.node.hidden = !this.node.childElementCount;
  }

  strip({ scene }, k) {
    const { verdict } = scene.header;
    if (!verdict) return null;
    const { state, text, governing, more } = verdict;
    return el("div", { class: `verdict ${state}` }, el("span", { class: "headline" }, el("b", { class: "sign", "aria-hidden": true }, SIGNS[state]),
      el("b", {}, this.app.views.length > 1 ? `${this.app.labels[k]}: ${text}` : text)),
      governing ? el("button", { type: "button", class: "governing", title: "Show this member and instant", onclick: () => this.go(scene, governing) },
        state === "open" ? `highest of what was checked: ${governing.text}` : governing.text) : null,
      more.length ? el("span", {}, more.join("; ")) : null);
  }

  /** The instant, load case and member (or the member or node that the drive moves) that govern. */
  go(scene, governing) {
    const { app } = this;
    app.pause();
    if (scene.cases.includes(governing.load_case)) app.setCase(governing.load_case);
    if (governing.kind === "member" && scene.channel("utilisation")) app.setChannel("utilisation");
    if (governing.time !== null) app.goTo(app.lead.frameAt(governing.time));
    if (governing.kind === "quantity") return app.pick(null); // the panel then has the quantities
    const drive = scene.header.drives.find((one) => one.name === governing.name);
    if (scene.members.includes(governing.member)) app.pick({ type: "member", name: governing.member });
    else if (drive?.member !== undefined) app.pick({ type: "member", name: scene.members[drive.member] });
    else if (drive) app.pick({ type: "node", name: scene.nodes[drive.node ?? drive.start] });
  }
}
