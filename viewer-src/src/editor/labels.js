// Names beside nodes and members, each at the first of its places where it covers no other and no mark of a drive.

const BESIDE = [9, 15, 21]; // pixels from a node to its name: beside it, or beyond what is drawn about it
const HIGH = 13; // pixels of a line
const ROUND = [[1, 0], [-1, 0], [0, 1], [0, -1], [0.7, 0.7], [-0.7, 0.7], [0.7, -0.7], [-0.7, -0.7]]; // ways out of a crowded place
const FAR = [18, 36, 54, 72, 90, 120, 160]; // pixels out
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

const context = document.createElement("canvas").getContext("2d"), widths = new Map();

/** Pixels of a text, from those of its letters: each is measured once, as words that tell a value change with every picture. */
export function wide(words, size, weight = 400) {
  return [...words].reduce((sum, letter) => {
    const key = `${weight} ${size} ${letter}`;
    if (!widths.has(key)) {
      context.font = `${weight} ${size}px ${getComputedStyle(document.getElementById("kinetruss")).fontFamily}`;
      widths.set(key, context.measureText(letter).width);
    }
    return sum + widths.get(key);
  }, 0);
}

export class Labels {
  constructor() {
    Object.assign(this, { taken: [], lines: [] });
  }

  /** Nodes and marks (boxes of supports and drives) are covered by no name. lines : members, which names cover only where there is no other room. */
  begin(points, lines, marks) {
    this.taken = [...points.map(([x, y]) => [x - 6, y - 6, x + 6, y + 6]), ...marks];
    this.lines = lines;
  }

  /** Put a text into the first ring of places with a free one, on no line if it can be; if it must be seen further out, else nowhere. */
  put(text, rings, width, must) {
    const [[[x0, y0]]] = rings, out = must ? FAR.map((far) => ROUND.map(([u, v]) => [x0 + far * u, y0 + far * v])) : [];
    const free = (ring) => ring.filter(([x, y]) => !this.taken.some((one) => meet(one, box(x, y, width))));
    const best = (ring) => ring.find(([x, y]) => !this.lines.some((line) => crosses(line, box(x, y, width)))) || ring[0];
    const found = [...rings, ...out].reduce((there, ring) => there || best(free(ring)), null) || (must ? [x0, y0] : null);
    text.setAttribute("display", found ? "inline" : "none");
    if (!found) return;
    this.taken.push(box(...found, width));
    text.setAttribute("x", found[0].toFixed(1));
    text.setAttribute("y", found[1].toFixed(1));
  }

  node(text, [x, y], must) {
    const width = wide(text.textContent, 12, 600);
    this.put(text, BESIDE.map((out) => [[x + out, y - out], [x - out - width, y - out], [x + out, y + 8 + out], [x - out - width, y + 8 + out], [x - width / 2, y - 3 - out], [x - width / 2, y + 13 + out], [x + 2 + out, y + 4], [x - 2 - out - width, y + 4]]), width, must);
  }

  member(text, a, b, must) {
    const width = wide(text.textContent, 11);
    const places = PARTS.flatMap((part) => {
      const [x, y] = [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])];
      return [[x + 6, y - 6], [x - 6 - width, y - 6], [x + 6, y + 16], [x - 6 - width, y + 16], [x - width / 2, y - 8], [x - width / 2, y + 18]];
    });
    this.put(text, [places], width, must);
  }
}
