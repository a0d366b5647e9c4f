// Bodies as solid links: a planar body is a plate with round corners, a body in space its hull.

import {
  BufferAttribute, BufferGeometry, DoubleSide, EdgesGeometry, ExtrudeGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial,
  Shape, Vector2,
} from "three";

const ARCS = 24; // points around each corner

export class Bodies {
  /** size : radius of the corners of plates, m. */
  constructor(scene, ball) {
    this.scene = scene;
    this.group = new Group();
    this.material = new MeshLambertMaterial({ side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.ink = new LineBasicMaterial({});
    this.plates = scene.header.bodies.map((body, k) => this.plate(body, ball, k));
    this.hulls = scene.header.solids || [];
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(9 * this.hulls.length), 3));
    this.hull = new Mesh(geometry, this.material);
    this.hull.frustumCulled = false;
    this.group.add(this.hull);
  }

  setTheme({ body, outline }) {
    this.material.color.set(body);
    this.ink.color.set(outline);
  }

  plate(body, ball, k) {
    const L = this.scene.length(0, body.member), radius = 1.9 * ball, depth = 0.5 * ball;
    const outline = rounded([[0, 0], [L, 0], body.center], radius);
    const geometry = new ExtrudeGeometry(new Shape(outline.map(([x, y]) => new Vector2(x, y))), { depth, bevelEnabled: false, steps: 1 });
    // plates that overlap lie above each other by less than can be seen, so that their faces do not flicker
    geometry.translate(0, 0, -depth * (0.5 + 0.02 * k));
    const plate = new Group();
    plate.add(new Mesh(geometry, this.material), new LineSegments(new EdgesGeometry(geometry, 50), this.ink));
    this.group.add(plate);
    return { body, plate };
  }

  place(points) {
    const { scene } = this;
    for (const { body, plate } of this.plates) {
      const p = points[scene.ends[2 * body.member]], q = points[scene.ends[2 * body.member + 1]];
      plate.position.set(...p);
      plate.rotation.z = Math.atan2(q[1] - p[1], q[0] - p[0]);
    }
    if (!this.hulls.length) return;
    const { position } = this.hull.geometry.attributes;
    this.hulls.forEach((corners, k) => corners.forEach((node, i) => position.array.set(points[node], 9 * k + 3 * i)));
    position.needsUpdate = true;
    this.hull.geometry.computeVertexNormals();
  }
}

/** The convex outline of circles about some points, counterclockwise. */
export function rounded(points, radius) {
  const around = points.flatMap(([x, y]) => Array.from({ length: ARCS }, (_, k) => {
    const angle = (2 * Math.PI * k) / ARCS;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  }));
  around.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list) => {
    const found = [];
    for (const point of list) {
      while (found.length > 1 && turn(found[found.length - 2], found[found.length - 1], point) <= 0) found.pop();
      found.push(point);
    }
    return found.slice(0, -1);
  };
  return [...half(around), ...half(around.reverse())];
}

function turn(a, b, c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
