// Names beside nodes and members, each at the first of its places where it covers no other.

const WIDE = 7.4, NARROW = 6.1; // pixels of a letter of a node's and a member's name
const HIGH = 13; // pixels of a line
const PARTS = [0.5, 0.38, 0.62, 0.26, 0.74]; // of a member, where its name may stand

const meet = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];

/** The box of a text that starts at x with its foot at y. */
const box = (x, y, width) => [x - 1, y - HIGH + 3, x + width + 1, y + 3];

/** Whether a line on the screen goes through a box. */
function crosses([p, q], [left, top, right, bottom]) {
  let [from, to] = [0, 1];
  for (const [start, by, low, high] of [[p[0], q[0] - p[0], left, right], [p[1], q[1] - p[1], top, bottom]]) {
    if (Math.abs(by) < 1e-9) {
      if (start < low || start > high) return false;
      continue;
    }
    const [a, b] = [(low - start) / by, (high - start) / by];
    [from, to] = [Math.max(from, Math.min(a, b)), Math.min(to, Math.max(a, b))];
  }
  return from < to;
}

export class Labels {
  constructor() {
    Object.assign(this, { taken: [], lines: [] });
  }

  /** Nodes and symbols of supports are covered by no name. lines : members, which names cover only where there is no other room. */
  begin(points, lines, feet) {
    this.taken = [...points.map(([x, y]) => [x - 6, y - 6, x + 6, y + 6]), ...feet];
    this.lines = lines;
  }

  /** Put a text at the first free place, on no line if there is one; without one at the first place if it must be seen, else nowhere. */
  put(text, places, width, must) {
    const free = places.filter(([x, y]) => !this.taken.some((one) => meet(one, box(x, y, width))));
    const found = free.find(([x, y]) => !this.lines.some((line) => crosses(line, box(x, y, width)))) || free[0] || (must ? places[0] : null);
    text.setAttribute("display", found ? "inline" : "none");
    if (!found) return;
    this.taken.push(box(...found, width));
    text.setAttribute("x", found[0].toFixed(1));
    text.setAttribute("y", found[1].toFixed(1));
  }

  node(text, [x, y], must) {
    const width = WIDE * text.textContent.length;
    this.put(text, [[x + 9, y - 9], [x - 9 - width, y - 9], [x + 9, y + 17], [x - 9 - width, y + 17], [x - width / 2, y - 12], [x - width / 2, y + 22], [x + 11, y + 4], [x - 11 - width, y + 4]], width, must);
  }

  member(text, a, b, must) {
    const width = NARROW * text.textContent.length;
    const places = PARTS.flatMap((part) => {
      const [x, y] = [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])];
      return [[x + 6, y - 6], [x - 6 - width, y - 6], [x + 6, y + 16], [x - 6 - width, y + 16], [x - width / 2, y - 8], [x - width / 2, y + 18]];
    });
    this.put(text, places, width, must);
  }
}
