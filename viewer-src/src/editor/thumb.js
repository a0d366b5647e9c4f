// A small picture of a model: of a drawing to begin with, of a linkage that was found.

import { KINDS } from "../display.js";
import { svg } from "../dom.js";
import { symbolAt } from "../supports.js";
import { Camera } from "./camera.js";

const RIM = 14; // pixels around
const SUPPORT = 10; // pixels of the symbol of a support

/** An SVG of places, lines [node, node, kind], bodies, supports and a path (see studio/small_pictures.py). */
export function thumb({ dim, places, lines, bodies = [], supports = [], turning = [], path = [] }, width = 148, height = 104) {
  const camera = new Camera();
  Object.assign(camera, { width, height });
  camera.setDim(dim);
  camera.fit([...places, ...path]);
  const spans = [...places, ...path].map((place) => camera.project(place));
  const span = (k) => Math.max(...spans.map((p) => p[k])) - Math.min(...spans.map((p) => p[k]));
  camera.scale *= Math.min((width - 2 * RIM) / (span(0) || 1e-9), (height - 2 * RIM) / (span(1) || 1e-9), 1.6);
  const seen = (place) => camera.project(place), at = places.map(seen);
  const d = (points, close) => `M${points.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}${close ? "Z" : ""}`;
  const marks = supports.flatMap(({ node, kind, along }) => symbolAt({ kind, along }, [...places[node], 0].slice(0, 3), SUPPORT / camera.scale).map((line, k) => svg("path", { class: (kind === "pin" || kind === "roller") && k === 0 ? "hold" : "hold line", d: d(line.map(seen)) })));
  const turns = turning.map(([a, b]) => {
    const [p, q] = [at[a], at[b]], angle = Math.atan2(q[1] - p[1], q[0] - p[0]);
    const on = (by) => `${(p[0] + 9 * Math.cos(angle + by)).toFixed(1)} ${(p[1] + 9 * Math.sin(angle + by)).toFixed(1)}`;
    return svg("path", { class: "turn", d: `M${on(0.5)}A9 9 0 1 1 ${on(-0.5)}` });
  });
  return svg("svg", { class: "thumb", viewBox: `0 0 ${width} ${height}`, width, height, "aria-hidden": "true" }, ...marks,
    ...bodies.map((nodes) => svg("path", { class: "plate", d: d(nodes.map((node) => at[node]), true) })),
    path.length ? [svg("path", { class: "way", d: d(path.map(seen)) })] : [],
    ...lines.map(([a, b, kind]) => svg("path", { class: kind === "elastic" ? "piece soft" : "piece", style: `stroke: ${KINDS[kind] || KINDS.rigid}`, d: d([at[a], at[b]]) })),
    ...turns, ...(places.length > 40 ? [] : at.map(([x, y]) => svg("circle", { class: "joint", cx: x.toFixed(1), cy: y.toFixed(1), r: 2 }))));
}
