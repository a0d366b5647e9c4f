// Elements in one line.

/** el("button", {class: "x", onclick: f}, "text", child, ..): attributes, listeners (on...) and children. */
export function el(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  apply(node, attributes);
  node.append(...children.flat(2).filter((child) => child !== null && child !== undefined));
  return node;
}

export function svg(tag, attributes = {}, ...children) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  apply(node, attributes);
  node.append(...children.flat());
  return node;
}

function apply(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
    else if (value === true) node.setAttribute(name, "");
    else if (value !== false && value !== undefined) node.setAttribute(name, value);
  }
}

/** Put children in place of what an element holds. */
export function fill(node, ...children) {
  node.replaceChildren(...children.flat().filter(Boolean));
  return node;
}

/** A button that stays pressed. */
export function toggle(label, title, pressed, action) {
  const button = el("button", { title, type: "button", "aria-pressed": String(pressed) }, label);
  button.addEventListener("click", () => action());
  return button;
}

export function press(button, pressed) {
  button.setAttribute("aria-pressed", String(Boolean(pressed)));
}

/** A part of the controls that can be folded. */
export function section(title, ...content) {
  return el("details", { open: true }, el("summary", {}, title), ...content);
}
