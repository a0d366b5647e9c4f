// Lengths and angles of members, written at them.

import { number, quantity } from "../format.js";

/** What the tools that drag do, at the pointer. */
export const HANDS = { pick: "changes lengths", move: "lengths are kept" };

/** Length of a member, and in the plane its direction from the first to the second end. */
export function spanOf(a, b, dim) {
  const length = Math.hypot(...b.map((value, k) => value - a[k]));
  const angle = (Math.atan2(b[1] - a[1], b[0] - a[0]) * 180) / Math.PI;
  return `${quantity(length, "m")}${dim === 2 && length > 0 ? `, ${number(angle, 4)} deg` : ""}`;
}
