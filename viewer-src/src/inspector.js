// The picked member or node: name, values now, history, free body, diagrams along it.

import { el, fill, press, toggle } from "./dom.js";
import { channelText, column, quantity } from "./format.js";
import { freeBodyPicture, freeBodyTable } from "./freebody.js";
import { drivesAt, drivesOf, freeBodyOf, sectionAt, sectionsOf } from "./mechanics.js";
import { plot } from "./plot.js";

const STATIONS = 41, MOST_CURVES = 12;
const LIMITED = new Set(["stress"]);
// diagrams of beams: title, unit, and which of the numbers of a station with which label
const PLANE = [["Axial force T", "N", [[0, ""]]], ["Shear V", "N", [[1, ""]]], ["Bending moment M", "N m", [[2, ""]]], ["von Mises stress", "Pa", [[3, ""]]]];
const SPACE = [
  ["Axial force T", "N", [[0, ""]]], ["Shear V", "N", [[1, "V2"], [2, "V3"]]], ["Bending moment M", "N m", [[3, "M2"], [4, "M3"]]],
  ["Torsion", "N m", [[5, ""]]], ["von Mises stress", "Pa", [[6, ""]]],
];

export class Inspector {
  constructor(app) {
    this.app = app;
    this.node = el("section", { class: "inspector", "aria-label": "what is picked" });
  }

  /** Build anew for another pick; numbers follow in `update`. */
  show() {
    const { picked } = this.app;
    this.updates = [];
    if (!picked) {
      const some = this.app.views.some(({ scene }) => scene.members.length);
      const keys = (some ? ["N", "P"] : ["Shift N", "Shift P"]).map((one) => el("kbd", {}, one));
      const what = `${this.app.touch ? "Tap" : "Pick"} ${some ? "a member or node in the picture or the table" : "a node in the picture"}`;
      fill(this.node, el("p", { class: "faint" }, what, this.app.touch ? "." : ["; or step through them with ", keys[0], " and ", keys[1], "."]), some ? null : this.overview(), this.app.views.map((view, k) => this.measured(view, k)));
      this.update();
      return;
    }
    fill(this.node, el("div", { class: "views" }, this.app.views.map((view, k) => this.column(view, k, picked))));
    this.update();
  }

  /** Of a structure without members: what it is made of and what presses on it. */
  overview() {
    const rows = this.app.views.flatMap(({ scene }) => {
      const { skins = [], pressures, loads } = scene.header;
      const found = skins.map((one) => [`${one.kind[0].toUpperCase()}${one.kind.slice(1)}`, one.name]);
      found.push(["Nodes", scene.nodes.length], ["Faces", scene.faces]);
      if (pressures) found.push(["Pressure", `${pressures.least === pressures.largest ? "" : `${quantity(pressures.least, "Pa")} to `}${quantity(pressures.largest, "Pa")} on ${pressures.count} ${pressures.count === 1 ? "face" : "faces"}`]);
      const single = loads.filter((one) => !one.pressure && !one.at).length;
      if (single) found.push(["Nodal loads", single]);
      return found;
    });
    return el("table", { class: "values" }, rows.map(([words, value]) => el("tr", {}, el("th", {}, words), el("td", {}, value))));
  }

  /** The quantities that the model defines: their values now, and a curve of each. */
  measured(view, k) {
    const { scene } = view, found = scene.header.quantities || [];
    if (!found.length) return null;
    const beyond = ({ limits }, value) => limits && ((limits[0] !== null && value < limits[0]) || (limits[1] !== null && value > limits[1]));
    const table = this.values(() => found.map((one, row) => {
      const value = scene.number("quantity", view.frame, row);
      return [one.name, quantity(value, one.unit), beyond(one, value) ? "beyond its limit" : one.words];
    }));
    const curves = scene.frames < 2 ? [] : found.slice(0, MOST_CURVES).map((one, row) => {
      const canvas = el("canvas", { class: "plot", role: "img", "aria-label": `${one.name} over time` });
      const y = Array.from(scene.time, (_, frame) => scene.number("quantity", frame, row));
      this.updates.push(() => plot(canvas, [{ x: scene.time, y, label: "" }], { title: one.name, unit: one.unit, cursor: scene.time[view.frame] }));
      return canvas;
    });
    const several = this.app.views.length > 1;
    return el("div", { class: "subject" }, el("h2", {}, "Quantities", several ? el("small", {}, ` ${this.app.labels[k]}`) : null), table, ...curves);
  }

  update() {
    for (const update of this.updates || []) update();
  }

  column(view, k, picked) {
    const { scene } = view;
    const index = this.app.indexIn(view, picked);
    const several = this.app.views.length > 1;
    const head = several ? el("h3", {}, this.app.labels[k]) : null;
    if (index < 0) return el("div", {}, head, el("p", { class: "faint" }, `no ${picked.type} called ${picked.name} here`));
    const body = picked.type === "member" ? this.member(view, index) : this.atNode(view, index);
    return el("div", { class: "subject" }, head, ...body);
  }

  member(view, member) {
    const { scene } = view;
    const [A, B] = [scene.ends[2 * member], scene.ends[2 * member + 1]];
    const kind = scene.header.kinds[member];
    const title = el("h2", {}, scene.members[member], el("small", {}, ` ${kind}${kind === "cable" ? "" : " member"}, `, this.link(view, A), " → ", this.link(view, B)));
    const found = [title, this.values(() => this.memberValues(view, member)), this.history(view, member), ...this.driveHistories(view, member)];
    if (!scene.has("member_force")) return found;
    if ((scene.header.beams || []).includes(member)) found.push(...this.beam(view, member));
    else if (!scene.header.bodies.some((body) => body.member === member)) found.push(...this.mechanics(view, member));
    return found;
  }

  link(view, node) {
    const name = view.scene.nodes[node];
    return el("button", { class: "link", type: "button", onclick: () => this.app.pick({ type: "node", name }) }, name);
  }

  values(rows) {
    const table = el("table", { class: "values" });
    this.updates.push(() => fill(table, rows().map(([words, value, note]) => el("tr", {}, el("th", {}, words), el("td", {}, value, note ? el("small", {}, ` ${note}`) : null)))));
    return table;
  }

  memberValues(view, member) {
    const { scene, frame } = view;
    const rows = scene.header.channels.map((channel) => {
      const value = scene.plainValue(channel.id, frame, member);
      const sign = channel.id === "force" && value ? (value > 0 ? "tension" : "compression") : "";
      return [channel.label, channelText(channel, value), channel.over_run ? "worst of the run" : sign];
    });
    const body = scene.header.bodies.find((one) => one.member === member);
    if (body) rows.push(["Body", quantity(body.mass, "kg")]);
    rows.push(["Length", quantity(scene.length(frame, member), "m", 6)]);
    rows.push(...loadRows(scene, frame, member));
    rows.push(...driveRows(drivesOf(scene, frame, member)));
    const lacking = scene.header.not_checked?.[scene.members[member]];
    if (lacking) rows.push(["Not checked", lacking]);
    if (scene.unsure.has(member)) rows.push(["Note", "this force is not unique: a share by stiffness or convention"]);
    return rows;
  }

  history(view, member) {
    const { scene } = view;
    if (scene.frames < 2) return null;
    const canvas = el("canvas", { class: "plot", role: "img", "aria-label": "history" });
    this.updates.push(() => {
      const channel = scene.channel(this.app.channel?.id) || scene.header.channels[0];
      const y = Array.from(scene.time, (_, frame) => scene.value(channel.id, frame, member));
      const limit = LIMITED.has(channel.id) ? allowed(scene, member) : ["capacity", "margin"].includes(channel.scale) ? 1 : undefined;
      const title = channel.scale === "margin" ? "Buckling: compression over allowed" : channel.label;
      const curves = [{ x: scene.time, y, label: "" }];
      if (channel.id === "force" && scene.has("rest_force")) {
        const rest = Array.from(scene.time, (_, frame) => scene.number("rest_force", frame, member));
        curves.push({ x: scene.time, y: rest, label: "at rest", dashed: true });
      }
      plot(canvas, curves, { title, unit: channel.unit, cursor: scene.time[view.frame], limit });
    });
    return canvas;
  }

  /** Force or torque of the drives that move a member. */
  driveHistories(view, member) {
    const { scene } = view;
    if (scene.frames < 2 || !scene.has("drive_force")) return [];
    return scene.header.drives.flatMap((drive, k) => {
      const y = Array.from(scene.time, (_, frame) => scene.number("drive_force", frame, k));
      if (drive.member !== member || !y.some(Number.isFinite)) return [];
      const turns = drive.unit === "rad";
      const canvas = el("canvas", { class: "plot", role: "img", "aria-label": `drive ${drive.name} over time` });
      this.updates.push(() => plot(canvas, [{ x: scene.time, y, label: "" }], { title: `${turns ? "Torque" : "Force"} of drive ${drive.name}`, unit: turns ? "N m" : "N", cursor: scene.time[view.frame] }));
      return [canvas];
    });
  }

  /** Section forces along a beam, where the scene has them. */
  beam(view, member) {
    const { scene } = view, array = scene.arrays.beam_section, row = scene.curves.row.get(member);
    if (!array || row === undefined) {
      return [el("p", { class: "faint" }, row === undefined ? "Section forces of rigid beams are not computed." : "Section forces of beams: kt.strength.beams.")];
    }
    const [, beams, stations, values] = array.shape, length = scene.length(0, member);
    const s = Array.from({ length: stations }, (_, k) => (k * length) / (stations - 1));
    const along = (value) => s.map((_, k) => array.data[((view.frame * beams + row) * stations + k) * values + value]);
    const groups = scene.dim === 2 ? PLANE : SPACE;
    const plots = groups.map((one) => [el("canvas", { class: "plot small", role: "img", "aria-label": one[0] }), ...one]);
    this.updates.push(() => {
      for (const [canvas, title, unit, series] of plots) {
        const curves = series.map(([value, label]) => ({ x: s, y: along(value), label }));
        plot(canvas, curves, { title, unit, xUnit: "m from A", fill: true });
      }
    });
    return [el("h4", {}, "Along it, now"), ...plots.map(([canvas]) => canvas)];
  }

  mechanics(view, member) {
    const { scene } = view;
    const picture = el("div", { class: "freebody" }), table = el("div");
    this.updates.push(() => {
      const body = freeBodyOf(scene, view.frame, member);
      fill(picture, freeBodyPicture(scene, body));
      fill(table, freeBodyTable(scene, body));
    });
    const across = scene.dim === 3;
    const plots = [
      ["Axial force T", "N", [["T", ""]]],
      ["Shear V", "N", across ? [["V2", "V2"], ["V3", "V3"]] : [["V2", ""]]],
      ["Bending moment M", "N m", across ? [["M2", "M2"], ["M3", "M3"]] : [["M3", ""]]],
      ["von Mises stress", "Pa", [["stress", ""]]],
    ].map((one) => [el("canvas", { class: "plot small", role: "img", "aria-label": one[0] }), ...one]);
    this.updates.push(() => {
      const found = diagramsOf(scene, view.frame, member);
      for (const [canvas, title, unit, series] of plots) {
        const curves = series.map(([key, label]) => ({ x: found.s, y: found[key], label }));
        const limit = key(series) === "stress" ? allowed(scene, member) : undefined;
        plot(canvas, curves, { title, unit, xUnit: "m from A", fill: true, limit });
      }
    });
    return [el("h4", {}, "Cut free, now"), picture, table, el("h4", {}, "Along it, now"), ...plots.map(([canvas]) => canvas)];
  }

  atNode(view, node) {
    const { scene } = view;
    const title = el("h2", {}, scene.nodes[node], el("small", {}, " node"));
    const members = scene.members.flatMap((name, k) => (scene.ends[2 * k] === node || scene.ends[2 * k + 1] === node ? [k] : []));
    const joined = el("p", {}, "joins ", members.slice(0, 24).flatMap((k) => [el("button", { class: "link", type: "button", onclick: () => this.app.pick({ type: "member", name: scene.members[k] }) }, scene.members[k]), " "]));
    const traced = toggle(this.app.hint("Path", "T"), "Path of this node along the run", false, () => this.app.toggleTrace());
    traced.classList.add("trace");
    this.updates.push(() => press(traced, this.app.paths.has(scene.nodes[node])));
    const found = [title, joined, this.values(() => nodeValues(scene, view.frame, node))];
    if (scene.frames > 1) found.push(traced, this.nodeHistory(view, node));
    return found;
  }

  nodeHistory(view, node) {
    const { scene } = view;
    const canvas = el("canvas", { class: "plot", role: "img", "aria-label": "history" });
    const start = scene.position(0, node);
    const curves = "xyz".slice(0, scene.dim).split("").map((label, i) => ({
      x: scene.time, label, y: Array.from(scene.time, (_, frame) => scene.position(frame, node)[i] - start[i]),
    }));
    this.updates.push(() => plot(canvas, curves, { title: "Moved from the start", unit: "m", cursor: scene.time[view.frame] }));
    return canvas;
  }
}

const key = (series) => series[0][0];

function allowed(scene, member) {
  return Math.min(...scene.partsOf[member].map((part) => scene.arrays.part_allowed.data[part]));
}

function nodeValues(scene, frame, node) {
  const axes = "xyz".slice(0, scene.dim).split("");
  const listed = (v, unit) => {
    const largest = Math.max(...v.map(Math.abs)), [texts, shown] = column(axes.map((_, i) => (Math.abs(v[i]) > 1e-9 * largest ? v[i] : 0)), unit);
    return `${texts.map((one) => one.trim()).join(", ")} ${shown}`;
  };
  const rows = [["Position", listed(scene.position(frame, node), "m")]];
  if (scene.has("velocity")) {
    const v = scene.vector("velocity", frame, node), a = scene.vector("acceleration", frame, node);
    rows.push(["Speed", quantity(Math.hypot(...v), "m/s")], ["Velocity", listed(v, "m/s")], ["Acceleration", listed(a, "m/s²")]);
  }
  const lump = scene.arrays.lump.data[node];
  if (lump) rows.push(["Lumped mass", quantity(lump, "kg")]);
  const held = scene.header.supports.find((one) => one.node === node);
  if (held) rows.push(held.words ? ["Support", held.words] : ["Held in", [...held.axes].join(", ")]);
  const support = scene.header.supported?.indexOf(scene.nodes[node]) ?? -1;
  if (support >= 0) rows.push(["Reaction", listed(scene.vector("reaction", frame, support), "N")]);
  scene.header.loads.forEach((load, k) => {
    if (load.node === node) rows.push([`Load ${load.name}`, listed(scene.vector("load_force", frame, k), "N")]);
  });
  rows.push(...driveRows(drivesAt(scene, frame, node)));
  return rows;
}

/** Loads between the ends of a member: forces at a place, and the largest force a length of those along it. */
function loadRows(scene, frame, member) {
  return scene.header.loads.flatMap((load, k) => {
    if (load.member !== member || load.words === false) return [];
    const size = Math.hypot(...scene.vector("load_force", frame, k));
    return [[`Load ${load.name}`, load.span ? quantity(size / load.span, "N/m") : quantity(size, "N")]];
  });
}

/** Where drives are now, and their force or torque. */
function driveRows(drives) {
  return drives.filter((drive) => !Number.isNaN(drive.position)).map((drive) => {
    const turns = drive.unit === "rad";
    return [`Drive ${drive.name}`, quantity(drive.position, drive.unit, 6), Number.isNaN(drive.force) ? "" : `drive ${turns ? "torque" : "force"} ${quantity(drive.force, turns ? "N m" : "N")}`];
  });
}

/** T, V, M and stress along a member now: arrays over s, m from A; gaps between the parts of an active member. */
export function diagramsOf(scene, frame, member) {
  const found = { s: [], T: [], V2: [], V3: [], M2: [], M3: [], stress: [], parts: [] };
  for (const part of sectionsOf(scene, frame, member).parts) {
    if (found.s.length) push(found, part.start, { T: NaN, V2: NaN, V3: NaN, M2: NaN, M3: NaN, stress: NaN }, "");
    for (let k = 0; k < STATIONS; k++) {
      const xi = k / (STATIONS - 1);
      push(found, part.start + xi * part.length, sectionAt(scene, part, xi), scene.header.parts[part.part]);
    }
  }
  return found;
}

function push(found, s, values, part) {
  found.s.push(s);
  found.parts.push(part);
  for (const [name, value] of Object.entries(values)) found[name].push(value);
}
