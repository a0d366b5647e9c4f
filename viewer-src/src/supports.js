// Symbols of supports in space: lines of the table that pictures on paper have too.

import { SUPPORTS } from "./display.js";

/** Size of the symbols of a scene, m: they are to be seen beside thick members. */
export function symbolSize({ length0, extent }) {
  return Math.max(0.1 * length0, 0.04 * extent.size);
}

/** Lines (lists of points) of a symbol of a size whose node is at a place; the first one of a pin or roller is its triangle. */
export function symbolAt({ kind, along }, at, size) {
  const [across, up] = frameOf(kind, along);
  return SUPPORTS[kind].map((line) => line.map(([x, y]) => at.map((value, i) => value + size * (x * across[i] + y * up[i]))));
}

/** Axes x and y of a symbol: y along the direction held; both across the axis of a rotation, and upright of one about all axes. */
function frameOf(kind, along) {
  if (!along.some(Boolean)) return [[1, 0, 0], [0, 0, 1]];
  const flat = Math.hypot(along[0], along[1]), across = flat > 1e-9 ? [along[1] / flat, -along[0] / flat, 0] : [1, 0, 0];
  return [across, kind.startsWith("turn") ? cross(along, across) : along];
}

function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}
