// A rim around what is picked.

import { BackSide, CylinderGeometry, Group, IcosahedronGeometry, InstancedMesh, MeshBasicMaterial } from "three";
import { piecesOf } from "./beams.js";
import { moved, placeAlong, placeSphere } from "./shapes.js";

const COLOUR = "#ffb000";

export class Halo {
  constructor(bars) {
    this.bars = bars;
    this.group = new Group();
    const material = new MeshBasicMaterial({ color: COLOUR, side: BackSide });
    this.bar = new InstancedMesh(new CylinderGeometry(1, 1, 1, 18, 1, true), material, Math.max(1, bars.scene.curves.places - 1));
    this.ball = new InstancedMesh(new IcosahedronGeometry(1, 3), material, 1);
    for (const mesh of [this.bar, this.ball]) {
      mesh.frustumCulled = mesh.visible = false;
      this.group.add(mesh);
    }
  }

  place(points, picked) {
    const { bars } = this;
    this.bar.visible = picked?.type === "member";
    this.ball.visible = picked?.type === "node";
    if (this.bar.visible) {
      const { active, curves } = bars.scene, member = picked.index, pieces = piecesOf(curves.points(points, member));
      const width = bars.radius[member] * (active.has(member) ? 2.9 : 1.9);
      pieces.forEach(([p, q], k) => placeAlong(this.bar, k, p, q, width));
      this.bar.count = pieces.length;
    }
    if (this.ball.visible) placeSphere(this.ball, 0, points[picked.index], 1.7 * bars.ball);
    [this.bar, this.ball].forEach(moved);
  }
}
