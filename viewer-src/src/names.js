// Names of nodes and members over the picture.

import { el, fill } from "./dom.js";

const MOST = 400;

export class Names {
  constructor(view) {
    this.view = view;
    this.node = el("div", { class: "names", "aria-hidden": true });
  }

  /** Put the names where their nodes and members are now. */
  place(shown) {
    this.node.hidden = !shown || this.view.scene.members.length > MOST;
    if (this.node.hidden) return;
    const { scene, now } = this.view;
    if (!this.tags) {
      this.tags = [...scene.nodes.map((name, k) => el("span", { class: "of-node", hidden: scene.directors.has(k) }, name)),
        ...scene.members.map((name, k) => el("span", { hidden: !scene.shows(k) }, name))];
      fill(this.node, this.tags);
    }
    const middles = scene.members.map((_, k) => {
      const [p, q] = [now[scene.ends[2 * k]], now[scene.ends[2 * k + 1]]];
      return p.map((x, i) => (x + q[i]) / 2);
    });
    [...now, ...middles].forEach((point, k) => {
      const [x, y] = this.view.project(point);
      this.tags[k].style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    });
  }
}
