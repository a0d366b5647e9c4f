// Instanced bars, nodes and marks. Matrices are written straight into the buffers: thousands of bars a frame.

import {
  BoxGeometry, ConeGeometry, CylinderGeometry, DynamicDrawUsage, Group, IcosahedronGeometry, InstancedMesh, Mesh, MeshLambertMaterial,
  TorusGeometry, Vector3, Quaternion,
} from "three";

const UP = new Vector3(0, 1, 0);

/** Instances of one geometry, each with a colour of its own. */
export function instances(geometry, count, colour = "#ffffff") {
  const mesh = new InstancedMesh(geometry, new MeshLambertMaterial({ color: colour }), Math.max(count, 1));
  mesh.count = count;
  mesh.instanceMatrix.setUsage(DynamicDrawUsage);
  mesh.frustumCulled = false;
  return mesh;
}

export function cylinder(count, sides) {
  return instances(new CylinderGeometry(1, 1, 1, sides, 1, false), count);
}

export function boxes(count) {
  return instances(new BoxGeometry(2, 1, 2), count);
}

export function spheres(count, detail, colour) {
  return instances(new IcosahedronGeometry(1, detail), count, colour);
}

export function cones(count, sides, colour) {
  return instances(new ConeGeometry(1, 1, sides), count, colour);
}

/** Put instance k of a mesh along the y axis from p to q with radius r. */
export function placeAlong(mesh, k, p, q, r) {
  const m = mesh.instanceMatrix.array, at = 16 * k;
  const x = q[0] - p[0], y = q[1] - p[1], z = q[2] - p[2];
  const l = Math.hypot(x, y, z) || 1e-12;
  const ux = x / l, uy = y / l, uz = z / l;
  // a first direction across: the axis that the bar is farthest from, made normal
  let ax = 0, ay = -uz, az = uy;
  if (Math.abs(ux) > 0.7) [ax, ay, az] = [uz, 0, -ux];
  const s = r / (Math.hypot(ax, ay, az) || 1);
  ax *= s; ay *= s; az *= s;
  m[at] = ax; m[at + 1] = ay; m[at + 2] = az; m[at + 3] = 0;
  m[at + 4] = x; m[at + 5] = y; m[at + 6] = z; m[at + 7] = 0;
  m[at + 8] = ay * uz - az * uy; m[at + 9] = az * ux - ax * uz; m[at + 10] = ax * uy - ay * ux; m[at + 11] = 0;
  m[at + 12] = (p[0] + q[0]) / 2; m[at + 13] = (p[1] + q[1]) / 2; m[at + 14] = (p[2] + q[2]) / 2; m[at + 15] = 1;
}

/** Put instance k of boxes along its y axis from p to q, half as high along axis 2 and as wide along axis 3 as given. */
export function placeBox(mesh, k, p, q, axis2, [high, wide]) {
  const m = mesh.instanceMatrix.array, at = 16 * k;
  const d = [q[0] - p[0], q[1] - p[1], q[2] - p[2]], l = Math.hypot(...d) || 1e-12, u = d.map((x) => x / l);
  const along = u[0] * axis2[0] + u[1] * axis2[1] + u[2] * axis2[2];
  let two = axis2.map((x, i) => x - along * u[i]); // normal to the bar also where a mode moves its ends
  const size = Math.hypot(...two) || 1;
  two = two.map((x) => x / size);
  const three = [two[1] * u[2] - two[2] * u[1], two[2] * u[0] - two[0] * u[2], two[0] * u[1] - two[1] * u[0]];
  for (let i = 0; i < 3; i++) {
    m[at + i] = high * two[i];
    m[at + 4 + i] = d[i];
    m[at + 8 + i] = wide * three[i];
    m[at + 12 + i] = (p[i] + q[i]) / 2;
  }
  m[at + 3] = m[at + 7] = m[at + 11] = 0;
  m[at + 15] = 1;
}

export function placeSphere(mesh, k, p, r) {
  const m = mesh.instanceMatrix.array, at = 16 * k;
  m.fill(0, at, at + 16);
  m[at] = m[at + 5] = m[at + 10] = r;
  m[at + 12] = p[0]; m[at + 13] = p[1]; m[at + 14] = p[2]; m[at + 15] = 1;
}

export function moved(mesh) {
  mesh.instanceMatrix.needsUpdate = true;
}

/** An arrow of length 1 along y, to be scaled and turned. */
export function arrow(colour) {
  const group = new Group(), material = new MeshLambertMaterial({ color: colour });
  const shaft = new Mesh(new CylinderGeometry(1, 1, 1, 12), material);
  const head = new Mesh(new ConeGeometry(1, 1, 16), material);
  group.add(shaft, head);
  return group;
}

/** Put an arrow from a point along a vector; nothing is drawn of a vector too short to see. */
export function placeArrow(group, from, vector, radius) {
  const length = Math.hypot(...vector);
  group.visible = length > 2 * radius;
  if (!group.visible) return;
  const [shaft, head] = group.children, tip = Math.min(5 * radius, length / 2);
  shaft.scale.set(radius, length - tip, radius);
  shaft.position.y = (length - tip) / 2;
  head.scale.set(2.4 * radius, tip, 2.4 * radius);
  head.position.y = length - tip / 2;
  group.position.set(...from);
  group.quaternion.copy(new Quaternion().setFromUnitVectors(UP, new Vector3(...vector).normalize()));
}

/** A ring about an axis: a motor that turns a bar. */
export function ring(radius, colour) {
  return new Mesh(new TorusGeometry(radius, radius / 5, 10, 32), new MeshLambertMaterial({ color: colour }));
}
