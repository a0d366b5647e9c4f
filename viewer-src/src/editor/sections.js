// Sections and materials: chosen from a list, found in the catalogues, or a tube by its diameters; and what they weigh.

import { el } from "../dom.js";
import { number, quantity } from "../format.js";
import { button, choice, field } from "./fields.js";

const MOST = 60; // rows of the catalogue that are shown

/** The rows of the catalogue in which all words occur: "steel 60.3". */
function found(rows, words) {
  const parts = words.toLowerCase().split(/\s+/).filter(Boolean);
  return rows.filter(({ name, of }) => parts.every((part) => `${name} ${of}`.toLowerCase().includes(part)));
}

const millimetres = (value) => String(value).replace(/ mm$/, "");

/** A section in words: "tube 60.3 x 52.3 mm". */
function worded({ kind, outer, inner, diameter, width, height }) {
  const size = { tube: [outer, inner], rod: [diameter], rectangle: [width, height] }[kind];
  return size ? `${kind} ${size.map(millimetres).join(" x ")}${String(size[0]).endsWith("mm") ? " mm" : ""}` : `${kind} of its own`;
}

/** The catalogue to look into, under the field that is set. */
function finder(draw, set, name, material) {
  const input = el("input", { type: "search", "aria-label": `find ${name}`, placeholder: "steel 60.3, inch 0.75 ...", size: 20 });
  const body = el("tbody", {}), told = el("p", { class: "faint", role: "status" });
  const table = el("table", { class: "numbers catalogue" }, el("thead", {}, el("tr", {}, ["section", "A (cm²)", "I (cm⁴)", "kg/m"].map((words) => el("th", {}, words)))), body);
  const node = el("div", { class: "finder", hidden: true }, el("label", { class: "entry" }, el("span", {}, "Find"), input), el("div", { class: "rows" }, table), told);
  const list = async () => {
    draw.catalogue ||= await draw.ask({ do: "sections" });
    const rows = found(draw.catalogue.rows, input.value), shown = rows.slice(0, MOST), density = draw.catalogue.densities[material];
    body.replaceChildren(...shown.map(({ name: own, of, section, area, inertia }) => el("tr", {}, el("th", {}, button(own, () => set(section), { "aria-label": `${own}, ${of}`, title: of, class: "link" }), el("small", {}, ` ${of}`)),
      [1e4 * area, 1e8 * inertia, density * area].map((value) => el("td", { title: density ? "" : "choose a material first" }, number(value, 4))))));
    told.textContent = rows.length > shown.length ? `${rows.length - shown.length} more: type a part of the name.` : rows.length ? "" : "Nothing is called so.";
  };
  input.addEventListener("input", list);
  const open = button("Find ...", () => {
    node.hidden = !node.hidden;
    open.setAttribute("aria-expanded", String(!node.hidden));
    if (node.hidden) return;
    list();
    input.focus();
  }, { "aria-label": `catalogue, ${name}`, "aria-expanded": "false" });
  return [open, node];
}

/** A section of the model, of the library, or a tube by its diameters. */
export function sectionChoice(draw, value, set, name, material) {
  const names = [...Object.keys(draw.state.data.sections || {}), ...draw.choices.sections];
  const own = value && typeof value === "object" ? "own" : value || "";
  const outer = field("Outer", own === "own" ? value.outer ?? value.diameter : "", () => {}, { hint: "20 mm", size: 6, name: `outer diameter, ${name}` });
  const inner = field("Inner", own === "own" ? value.inner : "", () => {}, { hint: "0", size: 6, name: `inner diameter, ${name}` });
  const tube = () => {
    const [d, i] = [outer, inner].map((one) => one.querySelector("input").value.trim());
    const bare = [d, i].find((one) => Number(one) !== 0 && Number.isFinite(Number(one)));
    if (bare !== undefined) return draw.tell(`A diameter needs its unit, or it would be metres: ${bare} mm.`, true);
    if (d) set(!i || Number(i) === 0 ? { kind: "rod", diameter: d } : { kind: "tube", outer: d, inner: i });
  };
  const fields = el("span", { class: "row", hidden: own !== "own" }, outer, inner, button("Set", tube, { "aria-label": `set ${name}` }));
  const [open, catalogue] = finder(draw, set, name, material);
  const list = choice("Section", [["", name.endsWith("of the model") ? "none" : "of the model"], ...new Set(names), ["own", own === "own" ? worded(value) : "tube or rod ..."]], own, (chosen) => {
    fields.hidden = chosen !== "own";
    if (chosen !== "own") set(chosen || null);
  }, name);
  return el("span", { class: "row" }, list, open, fields, catalogue);
}

export function materialChoice(draw, value, set, name) {
  const names = [...Object.keys(draw.state.data.materials || {}), ...draw.choices.materials];
  const own = value && typeof value === "object" ? [["own", "of its own"]] : [];
  return choice("Material", [["", name.endsWith("of the model") ? "none" : "of the model"], ...new Set(names), ...own], own.length ? "own" : value || "", (chosen) => chosen !== "own" && set(chosen || null), name);
}

/** What a member weighs, and all of the drawing. */
export function weightText(draw, name) {
  const { weights } = draw.state, own = weights?.members[name];
  if (!weights) return "";
  const all = `all: ${quantity(weights.all, "kg")}`;
  return name === undefined ? all : own ? `weighs ${quantity(own, "kg")}, ${all}` : `weighs nothing: no section and material, no mass`;
}
