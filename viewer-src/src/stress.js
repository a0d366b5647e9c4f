// The largest von Mises stress over a section, from nominal stresses, as strength has it:
// a = T/A, b2 = M2 c3/I2, b3 = M3 c2/I3 and the largest shear stresses k2, k3 of V2 and V3 alone.

const ROUND = 0, RECTANGLE = 1, GENERAL = 2;
const STEPS = 48;

export function vonMises(shape, a, b2, b3, k2, k3) {
  if (shape === ROUND) return Math.sqrt(circle(Math.abs(a), b2, b3, k2, k3));
  if (shape === RECTANGLE) return Math.sqrt(box(Math.abs(a), Math.abs(b2), Math.abs(b3), k2, k3));
  if (shape === GENERAL) {
    const top = Math.abs(a) + Math.abs(b2) + Math.abs(b3);
    return Math.sqrt(top * top + 3 * (k2 * k2 + k3 * k3));
  }
  return NaN;
}

/** Largest sigma^2 + 3 tau^2 on the outer circle; psi counts from the point of most bending. */
function circle(a, b2, b3, k2, k3) {
  const b = Math.hypot(b2, b3), K = 3 * (k2 * k2 + k3 * k3);
  if (b === 0 || K === 0) return (a + b) ** 2 + K;
  const p = (k3 * b2 - k2 * b3) / b, q = (k2 * b2 + k3 * b3) / b;
  const f = (psi) => (a + b * Math.cos(psi)) ** 2 + 3 * (p * Math.sin(psi) + q * Math.cos(psi)) ** 2;
  const step = (2 * Math.PI) / STEPS;
  let best = 0, at = 0;
  for (let k = 0; k < STEPS; k++) if (f(k * step) > best) [best, at] = [f(k * step), k * step];
  return Math.max(best, f(climb(f, at, step)));
}

/** The top of f between at - width and at + width, by golden sections. */
function climb(f, at, width) {
  const ratio = (Math.sqrt(5) - 1) / 2;
  let low = at - width, high = at + width;
  for (let k = 0; k < 40; k++) {
    const x = high - ratio * (high - low), y = low + ratio * (high - low);
    if (f(x) > f(y)) high = y;
    else low = x;
  }
  return (low + high) / 2;
}

/** Largest sigma^2 + 3 tau^2 over a rectangle with parabolic shear: along y and z in turn from its corners. */
function box(a, b2, b3, k2, k3) {
  let best = 0;
  for (let start = 0; start < 4; start++) {
    let y = start & 1, z = start >> 1;
    for (let k = 0; k < 20; k++) {
      y = along(a + b2 * z, b3, k2);
      z = along(a + b3 * y, b2, k3);
    }
    const shear = (k2 * (1 - y * y)) ** 2 + (k3 * (1 - z * z)) ** 2;
    best = Math.max(best, (a + b3 * y + b2 * z) ** 2 + 3 * shear);
  }
  return best;
}

/** y in [0, 1] with the largest (A + b y)^2 + 3 k^2 (1 - y^2)^2: the corner, or the one top inside. */
function along(A, b, k) {
  const stiff = 12 * k * k;
  if (2 * b * b >= stiff) return 1;
  let y = 0;
  for (let n = 0; n < 60; n++) {
    const slope = stiff * y ** 3 + (2 * b * b - stiff) * y + 2 * A * b;
    const bend = 3 * stiff * y * y + 2 * b * b - stiff;
    if (slope <= 0) break;
    if (bend >= 0 || y >= 1) return 1;
    const step = -slope / bend;
    y += step;
    if (step < 1e-12) break;
  }
  if (y >= 1) return 1;
  return (A + b * y) ** 2 + (stiff / 4) * (1 - y * y) ** 2 > (A + b) ** 2 ? y : 1;
}
