// The free-body picture of a member: end forces, weight and inertia in its plane 1-2 or 1-3; all numbers in a table.

import { el, svg } from "./dom.js";
import { column, number, quantity } from "./format.js";

const WIDTH = 320, HEIGHT = 160, LEFT = 66, RIGHT = 254, MIDDLE = 62;
const COLOURS = { F_A: "var(--pen-1)", F_B: "var(--pen-1)", "m g": "var(--pen-3)", "m a": "var(--pen-2)", T: "var(--pen-3)", Q: "var(--pen-3)", P: "var(--pen-3)", B: "var(--pen-3)" };

export function freeBodyPicture(scene, body) {
  const largest = Math.max(...body.terms.map((term) => Math.hypot(...term.force))) || 1;
  const most = (axis) => Math.max(...body.terms.map((term) => Math.abs(term.force[axis])));
  const plane = most(2) > most(1) ? 2 : 1, across = most(plane); // drawn in the plane where more happens
  const long = 38 / largest, tall = across > 0.02 * largest ? long : Math.min(long * 20, across ? 26 / across : long);
  const x = (at) => LEFT + (at / body.state.L) * (RIGHT - LEFT);
  const picture = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": "free body of the member" });
  picture.append(
    svg("line", { x1: LEFT, y1: MIDDLE, x2: RIGHT, y2: MIDDLE, class: "rod" }),
    ...[LEFT, RIGHT].map((at) => svg("circle", { cx: at, cy: MIDDLE, r: 4, class: "joint" })),
    text(LEFT, HEIGHT - 24, `end A: ${scene.nodes[body.state.A]}`), text(RIGHT, HEIGHT - 24, `end B: ${scene.nodes[body.state.B]}`),
    text(WIDTH / 2, HEIGHT - 7, `plane 1–${plane + 1}${across > 1e-6 * largest && tall > 1.01 * long ? `, across × ${number(tall / long, 2)}` : ""}`, "faint"),
  );
  for (const drive of body.drives) picture.append(...driveMark(drive, body, x));
  body.couples.forEach((one, k) => picture.append(...coupleMark(one, k, x)));
  for (const term of body.terms) arrow(picture, x(term.at), term, [term.force[0] * long, -term.force[plane] * tall]);
  return picture;
}

/** Where a drive of the length acts: a collar at the nut or in the middle; its force above. */
function driveMark(drive, body, x) {
  const tube = body.state.rods[1], at = x(tube ? tube.start : body.state.L / 2);
  const mark = svg("rect", { x: at - 4, y: MIDDLE - 7, width: 8, height: 14, rx: 2, fill: "var(--pen-3)" });
  return [mark, ...said(`thrust of ${drive.name}: ${quantity(drive.force, "N")}`, 0)];
}

/** Where a couple acts: a ring; its size above. */
function coupleMark(one, k, x) {
  const mark = svg("circle", { cx: x(one.at), cy: MIDDLE, r: 10 + 3 * k, fill: "none", stroke: "var(--pen-3)", "stroke-width": 3 });
  return [mark, ...said(`couple of ${one.words}: ${quantity(one.size, "N m")}`, k)];
}

function said(words, k) {
  return [svg("text", { x: WIDTH / 2, y: 12 + 12 * k, "text-anchor": "middle", fill: "var(--pen-3)" }, words)];
}

function text(x, y, words, kind = "") {
  return svg("text", { x, y, "text-anchor": "middle", class: kind }, words);
}

function arrow(picture, x, term, [dx, dy]) {
  const size = Math.hypot(dx, dy);
  if (size < 3) return;
  // a push ends at its point, a pull begins there: the arrow always lies outside the bar
  const push = (term.symbol === "F_A" && dx > 0) || (term.symbol === "F_B" && dx < 0);
  const level = MIDDLE + (term.inertia ? 10 : 0);
  const [x1, y1] = push ? [x - dx, level - dy] : [x, level];
  const [x2, y2] = [x1 + dx, y1 + dy], ux = dx / size, uy = dy / size, h = Math.min(9, size);
  const tip = [[x2, y2], [x2 - h * ux - 0.4 * h * uy, y2 - h * uy + 0.4 * h * ux], [x2 - h * ux + 0.4 * h * uy, y2 - h * uy - 0.4 * h * ux]];
  const stroke = COLOURS[term.symbol];
  const [tx, ty] = push ? [x1 - 14 * ux, y1 - 12 * uy] : [x2 + 14 * ux, y2 + 12 * uy];
  picture.append(
    svg("line", { x1, y1, x2: x2 - 0.7 * h * ux, y2: y2 - 0.7 * h * uy, stroke, "stroke-width": 2.4, "stroke-dasharray": term.inertia ? "4 3" : "none" }),
    svg("polygon", { points: tip.map((p) => p.join(",")).join(" "), fill: stroke }),
    svg("text", { x: Math.min(WIDTH - 14, Math.max(14, tx)), y: Math.min(HEIGHT - 36, Math.max(11, ty + 4.5)), "text-anchor": "middle", fill: stroke }, term.symbol),
  );
}

/** All forces by component, and what they sum to against the inertia. */
export function freeBodyTable(scene, body) {
  const largest = Math.max(...body.terms.map((term) => Math.hypot(...term.force)));
  const axes = scene.dim === 3 ? [0, 1, 2] : [0, 1];
  const [texts, unit] = column(body.terms.flatMap((term) => axes.map((i) => (Math.abs(term.force[i]) < 1e-6 * largest ? 0 : term.force[i]))), "N");
  return el("table", { class: "numbers" },
    el("thead", {}, el("tr", {}, el("th", {}, `force (${unit})`), axes.map((i) => el("th", {}, `along ${i + 1}`)))),
    el("tbody", {}, body.terms.map((term, k) => el("tr", { title: term.words },
      el("th", {}, term.symbol, el("small", {}, ` ${term.words}`)), axes.map((i) => el("td", {}, texts[k * axes.length + i])))),
    body.couples.map((one) => el("tr", {}, el("th", {}, "couple ", el("small", {}, one.words)),
      el("td", { colspan: axes.length }, quantity(one.size, "N m")))),
    body.drives.map((drive) => el("tr", {}, el("th", {}, "drive ", el("small", {}, drive.name)),
      el("td", { colspan: axes.length }, quantity(drive.force, "N"))))));
}
