// Elastic beams as curves: places along their axes, linear in the nodes of both ends.

/** The curves of a scene: by member, points of its axis and directions of its local axis 2 for any positions of nodes. */
export class BeamCurves {
  constructor(scene) {
    this.scene = scene;
    const { beam_member: member, beam_along: along } = scene.arrays;
    this.row = new Map(member ? [...member.data].map((index, k) => [index, k]) : []);
    this.places = along ? along.shape[1] : 0;
    this.several = along ? along.shape[2] : 0;
  }

  /** Points (each three numbers) of a member from A to B: of a straight one its ends. */
  points(nodes, member) {
    const { ends } = this.scene;
    return this.row.has(member) ? this.combined("beam_along", nodes, this.row.get(member)) : [nodes[ends[2 * member]], nodes[ends[2 * member + 1]]];
  }

  /** Local axis 2 of a beam at the same places. */
  across(nodes, member) {
    return this.combined("beam_across", nodes, this.row.get(member));
  }

  combined(name, nodes, row) {
    const { scene: { arrays }, places, several } = this, { data } = arrays[name];
    return Array.from({ length: places }, (_, g) => {
      const found = [0, 0, 0];
      for (let v = 0; v < several; v++) {
        const weight = data[(row * places + g) * several + v], x = nodes[arrays.beam_nodes.data[row * several + v]];
        for (let i = 0; i < 3; i++) found[i] += weight * x[i];
      }
      return found;
    });
  }
}

/** Straight pieces between points. */
export function piecesOf(points) {
  return points.slice(1).map((q, k) => [points[k], q]);
}
