// Membranes and the surface of solids: lit faces with the edges of their elements, coloured by stress where it is known.

import { BufferAttribute, BufferGeometry, Color, DoubleSide, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial } from "three";
import { colourOf } from "./colour.js";
import { MISSING, SKINS, THEMES } from "./display.js";

const MOST = 30000; // edges beyond which none are drawn

const parse = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));

export class Skins {
  constructor(scene) {
    this.scene = scene;
    this.corners = scene.skin;
    const count = scene.faces, geometry = new BufferGeometry();
    for (const name of ["position", "color"]) geometry.setAttribute(name, new BufferAttribute(new Float32Array(9 * count), 3));
    const lit = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
    this.mesh = new Mesh(geometry, lit);
    this.mesh.visible = count > 0;
    this.edges = edgesOf(this.corners);
    const lines = new BufferGeometry();
    lines.setAttribute("position", new BufferAttribute(new Float32Array(3 * this.edges.length), 3));
    this.lines = new LineSegments(lines, new LineBasicMaterial({ transparent: true, opacity: 0.35 }));
    for (const one of this.objects()) one.frustumCulled = false;
  }

  objects() {
    return [this.mesh, this.lines];
  }

  setTheme(theme) {
    this.lines.material.color.set(THEMES[theme].edge);
  }

  place(points) {
    const { mesh, lines } = this;
    if (!mesh.visible) return;
    const faces = mesh.geometry.attributes.position, edges = lines.geometry.attributes.position;
    this.corners.forEach((node, k) => faces.array.set(points[node], 3 * k));
    this.edges.forEach((node, k) => edges.array.set(points[node], 3 * k));
    faces.needsUpdate = edges.needsUpdate = true;
    mesh.geometry.computeVertexNormals();
  }

  paint(channel, frame, limits) {
    const { scene, mesh } = this;
    if (!mesh.visible) return;
    const told = channel && scene.coloursFaces(channel.id), colour = new Color(), { array } = mesh.geometry.attributes.color;
    for (let face = 0; face < scene.faces; face++) {
      const kind = scene.header.skins[scene.arrays.skin_part.data[face]].kind;
      const [r, g, b] = told ? colourOf(channel.scale, scene.faceValue(channel.id, frame, face), limits) : parse(SKINS[kind] || MISSING);
      colour.setRGB(r / 255, g / 255, b / 255, "srgb");
      for (let i = 0; i < 3; i++) colour.toArray(array, 9 * face + 3 * i);
    }
    mesh.geometry.attributes.color.needsUpdate = true;
  }

  /** The sRGB colour a face has now, 0..255. */
  colourOf(face) {
    const { r, g, b } = new Color().fromArray(this.mesh.geometry.attributes.color.array, 9 * face).getRGB({ r: 0, g: 0, b: 0 }, "srgb");
    return [r, g, b].map((value) => Math.round(255 * value));
  }
}

/** Nodes of the edges of triangles, each edge once, in pairs. */
export function edgesOf(corners) {
  const found = new Map();
  for (let k = 0; k < corners.length; k += 3) {
    for (let i = 0; i < 3; i++) {
      const a = corners[k + i], b = corners[k + ((i + 1) % 3)];
      found.set(a < b ? `${a} ${b}` : `${b} ${a}`, [a, b]);
    }
  }
  return found.size > MOST ? [] : [...found.values()].flat();
}
