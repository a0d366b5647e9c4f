// Names beside nodes and members, each at the first of its places where it covers no other.

const WIDE = 7.4, NARROW = 6.1; // pixels of a letter of a node's and a member's name
const HIGH = 13; // pixels of a line
const PARTS = [0.5, 0.38, 0.62, 0.26, 0.74]; // of a member, where its name may stand

const meet = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];

/** The box of a text that starts at x with its foot at y. */
const box = (x, y, width) => [x - 1, y - HIGH + 3, x + width + 1, y + 3];

export class Labels {
  constructor() {
    this.taken = [];
  }

  /** Nodes themselves are covered by no name. */
  begin(points) {
    this.taken = points.map(([x, y]) => [x - 6, y - 6, x + 6, y + 6]);
  }

  /** Put a text at the first free place; without one at the first place if it must be seen, else nowhere. */
  put(text, places, width, must) {
    const found = places.find(([x, y]) => !this.taken.some((one) => meet(one, box(x, y, width)))) || (must ? places[0] : null);
    text.setAttribute("display", found ? "inline" : "none");
    if (!found) return;
    this.taken.push(box(...found, width));
    text.setAttribute("x", found[0].toFixed(1));
    text.setAttribute("y", found[1].toFixed(1));
  }

  node(text, [x, y]) {
    const width = WIDE * text.textContent.length;
    this.put(text, [[x + 9, y - 9], [x - 9 - width, y - 9], [x + 9, y + 17], [x - 9 - width, y + 17]], width, true);
  }

  member(text, a, b, must) {
    const width = NARROW * text.textContent.length;
    const places = PARTS.flatMap((part) => {
      const [x, y] = [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])];
      return [[x + 5, y - 5], [x - 5 - width, y - 5], [x + 5, y + 15], [x - 5 - width, y + 15]];
    });
    this.put(text, places, width, must);
  }
}
