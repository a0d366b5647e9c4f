// Fields of the panels: typed values with units, choices, and a section that keeps what is being typed.

import { el } from "../dom.js";

const WIDEST = 34; // letters of a field
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** What was typed: a number, a text with a unit, or null for nothing. */
export function typed(text) {
  const words = text.trim();
  if (!words) return null;
  return NUMBER.test(words) ? Number(words) : words;
}

/** A field with its label; `set` gets what was typed, as a value and letter by letter. */
export function field(label, value, set, { hint = "", size = 9, name = label } = {}) {
  const input = el("input", { type: "text", size, "aria-label": name, placeholder: hint, inputmode: "text", autocomplete: "off", spellcheck: "false" });
  input.dataset.size = size;
  showIn(input, value ?? "");
  const commit = () => {
    delete input.dataset.dirty;
    set(typed(input.value), input.value.trim());
  };
  input.addEventListener("input", () => {
    input.dataset.dirty = "yes";
    widen(input);
  });
  input.addEventListener("change", commit);
  input.addEventListener("blur", () => input.isConnected && input.dataset.dirty && commit()); // typed before the panel was made anew
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") input.blur();
    if (event.key === "Escape") {
      showIn(input, value ?? "");
      delete input.dataset.dirty;
      input.blur();
    }
  });
  return el("label", { class: "entry" }, el("span", {}, label), input);
}

/** Show a value in a field of the panel, which is made wide enough for it. */
export function showIn(input, value) {
  input.value = value;
  widen(input);
}

function widen(input) {
  input.size = Math.min(Math.max(Number(input.dataset.size) || 1, input.value.length), WIDEST);
}

/** A list to choose from; options are names or [value, text]. */
export function choice(label, options, value, set, name = label) {
  const select = el("select", { "aria-label": name }, options.map((one) => (Array.isArray(one) ? el("option", { value: one[0] }, one[1]) : el("option", { value: one }, one))));
  select.value = value ?? "";
  select.addEventListener("change", () => set(select.value));
  return el("label", { class: "entry" }, el("span", {}, label), select);
}

export function check(label, on, set, name = label) {
  const input = el("input", { type: "checkbox", "aria-label": name });
  input.checked = on;
  input.addEventListener("change", () => set(input.checked));
  return el("label", { class: "tick" }, input, label);
}

export function button(words, action, attributes = {}) {
  return el("button", { type: "button", onclick: action, ...attributes }, words);
}

/** Put other content into a node; the field in use keeps the focus and what is typed into it. */
export function refill(node, ...content) {
  const { activeElement: active } = node.ownerDocument;
  const label = node.contains(active) ? active.getAttribute("aria-label") || active.textContent : null;
  const words = label && active.tagName === "INPUT" && active.type === "text" && active.dataset.dirty ? active.value : null;
  const caret = words === null ? null : active.selectionStart;
  node.replaceChildren(...content.flat(4).filter(Boolean));
  if (!label) return;
  const again = [...node.querySelectorAll("input, select, button, textarea")].find((one) => (one.getAttribute("aria-label") || one.textContent) === label);
  if (!again) return;
  again.focus({ preventScroll: true });
  if (words === null) return;
  showIn(again, words);
  again.dataset.dirty = "yes";
  again.setSelectionRange(caret, caret);
}
