// Title, colour, camera and switches above the picture.

import { el, press, toggle } from "./dom.js";
import { quantity } from "./format.js";

const SWITCHES = [["ghost", "Ghost", "Start pose", "G"], ["paths", "Paths", "Paths of all nodes that move", "Y"], ["names", "Names", "Names of members and nodes", "A"],
  ["loads", "Loads", "Loads", "L"], ["grid", "Grid", "Ground grid", "H"]];
const CAMERAS = [["corner", "Corner", "1"], ["front", "Front", "2"], ["side", "Side", "3"], ["plane", "Top", "4"]];

export class ToolBar {
  constructor(app) {
    this.app = app;
    const { header } = app.views[0].scene;
    const titles = [...new Set(app.views.map(({ scene }) => scene.header.title || scene.header.name || "Model"))];
    const channels = [...new Map(app.views.flatMap((view) => view.scene.header.channels).map((one) => [one.id, one])).values()];
    const kinds = el("option", { value: "" }, "Kind of member");
    this.colour = el("select", { "aria-label": "colour by", title: app.hint("Colour by", "C"), onchange: () => app.setChannel(this.colour.value) }, kinds,
      channels.map((one) => el("option", { value: one.id }, one.label)));
    const offered = SWITCHES.filter(([name]) => name !== "paths" || app.lead.frames > 1);
    this.switches = new Map(offered.map(([name, label, title, key]) => [name, toggle(label, app.hint(title, key), app.shown[name], () => app.toggle(name))]));
    const cameras = app.views[0].scene.dim === 3 ? CAMERAS : [];
    const modes = header.modes.length ? el("select", { "aria-label": "mode", title: app.hint("Mode or mechanism", "M"), onchange: () => app.setMode(Number(this.modes.value)) },
      el("option", { value: -1 }, "No mode"), header.modes.map((mode, k) => el("option", { value: k }, modeText(mode)))) : null;
    this.modes = modes;
    const { cases } = app.views[0].scene;
    this.cases = cases.length > 1 ? el("select", { "aria-label": "load case", title: app.hint("Load case", "E"), onchange: () => app.setCase(this.cases.value) },
      cases.map((name) => el("option", { value: name }, name))) : null;
    this.diagram = app.offered.length ? el("select", { "aria-label": "diagram", title: app.hint("Diagram over the structure", "S"), onchange: () => app.setDiagram(this.diagram.value) },
      el("option", { value: "" }, "Off"), app.offered.map(({ id, label }) => el("option", { value: id }, label))) : null;
    this.node = el("header", { class: app.views.length > 1 ? "toolbar two" : "toolbar" },
      el("div", { class: "title" }, el("h1", {}, titles.join(" | ")),
        app.views.map(({ scene }, k) => el("p", {}, app.views.length > 1 ? `${app.labels[k]}: ` : "", subtitle(scene)))),
      el("div", { class: "tools" },
        this.cases && el("label", {}, el("span", {}, "Load case"), this.cases), el("label", {}, el("span", {}, "Colour"), this.colour), this.diagram && el("label", {}, el("span", {}, "Diagram"), this.diagram), modes,
        el("span", { class: "group", role: "group", "aria-label": "camera" }, cameras.map(([name, label, key]) => el("button", { type: "button", title: app.hint(`Camera: ${label}`, key), onclick: () => app.aim(name) }, label))),
        el("span", { class: "group", role: "group", "aria-label": "show" }, [...this.switches.values()]),
        el("span", { class: "group" },
          el("button", { type: "button", title: app.hint("Panel", "V"), onclick: () => app.togglePanel() }, "Panel"),
          el("button", { type: "button", title: app.hint("Dark or light", "D"), "aria-label": "dark or light", onclick: () => app.toggleTheme() }, "◐"),
          el("button", { type: "button", title: app.hint("Help", "?"), "aria-label": "help", onclick: () => app.toggleHelp() }, "?"))));
  }

  update() {
    this.colour.value = this.app.channel?.id || "";
    if (this.cases) this.cases.value = this.app.views[0].scene.header.load_case;
    if (this.diagram) this.diagram.value = this.app.diagram?.id || "";
    if (this.modes) this.modes.value = String(this.app.mode);
    for (const [name, button] of this.switches) press(button, this.app.shown[name]);
  }
}

function modeText(mode) {
  return mode.frequency === null ? mode.name : `${mode.name}: ${quantity(Number(mode.frequency), "Hz")}`;
}

function counted(count, noun) {
  return `${count} ${noun}${count === 1 ? "" : "s"}`;
}

function subtitle(scene) {
  const { header } = scene, members = scene.members.filter((_, k) => scene.shows(k)), nodes = scene.nodes.filter((_, k) => !scene.directors.has(k));
  const words = [header.kind === "run" ? `run ${header.name}` : header.kind];
  if (header.cases.length === 1 && header.load_case !== "all") words.push(`load case ${header.load_case}`);
  const meshes = (header.skins || []).map((one) => `${one.kind} ${one.name}`);
  words.push([members.length || !meshes.length ? counted(members.length, "member") : "", meshes.length > 3 ? `${meshes.length} meshes` : meshes.join(", "), counted(nodes.length, "node")].filter(Boolean).join(", "));
  const { all, shown } = header.samples;
  if (all > 1) words.push(shown < all ? `${shown} of ${all} samples` : `${all} samples`);
  if (header.rounded) words.push("curves rounded");
  if (header.status !== "Completed.") words.push(`${header.status} ${header.message}`);
  else if (header.message && !header.verdict?.more.some((one) => header.message.includes(one))) words.push(header.message);
  return words.join(" · ");
}
