// Pictures and films: one scene drawn at a size, sample by sample, for the program that opened the page.

import { Color, MeshBasicMaterial, Vector3 } from "three";
import { limitsOf } from "./colour.js";
import { piecesOf } from "./beams.js";
import { THEMES } from "./display.js";
import { held } from "./format.js";
import { fromBase64, readScene } from "./scene.js";
import { cylinder, placeAlong } from "./shapes.js";
import { edgesOf } from "./skins.js";
import { fitted, placesOf, View } from "./view.js";

const ANGLE = 24; // deg, of the camera: narrower than in the page, where one may turn
const MARGIN = 0.94; // of the picture that is filled
const SWING = 0.08; // amplitude of a mode, of the size of the structure
const FINE = 2, LARGEST = 8192; // pixels drawn for one, each way, and the most that every browser draws
const THIN = 0.001; // radius of thin lines, of the size of the structure: they grow with the picture
const LIGHT = 0.7; // of the light that comes from the eye; the rest comes from everywhere, so that a face towards the eye has its own colour

/** Let the program make its film of the scene of this page: `kinetruss.film(look)`. */
export function startFilm(root) {
  window.kinetruss.film = async (look) => {
    const scene = await readScene(fromBase64(document.querySelector("script.kinetruss-scene").textContent));
    window.kinetruss.shown = new Film(root, scene, look);
    return window.kinetruss.shown.said;
  };
}

class Film {
  /**
   * look : width, height, pixels; direction, towards the eye; colour, id of a channel or null; mode, number of a shape or null;
   * paths, nodes; ghost, faces, loads, grid, whether they are shown.
   */
  constructor(root, scene, look) {
    const [canvas, sheet] = [0, 1].map(() => document.createElement("canvas")), { width, height } = look;
    canvas.style.cssText = `display: block; width: ${width}px; height: ${height}px;`;
    root.replaceChildren(canvas);
    // drawn larger and reduced, or if it is too large for that smoothed by WebGL
    const fine = FINE * Math.max(width, height) > LARGEST ? 1 : FINE;
    Object.assign(this, { scene, look, fine, view: new View(canvas, scene, "light", fine === 1) });
    Object.assign(sheet, { width, height });
    this.pen = sheet.getContext("2d", { willReadFrequently: true });
    this.dress();
    this.aim();
    this.said = this.colour();
  }

  /** What is shown beside the bars, and the light. */
  dress() {
    const { view, scene, look } = this;
    view.renderer.setClearColor(new Color("#ffffff"));
    view.triad.render = () => {}; // the axes stand below the picture
    view.lamp.intensity = Math.PI * LIGHT;
    view.lampPlace = [0, 0, 1];
    view.ambient.intensity = Math.PI * (1 - LIGHT);
    view.loads.group.visible = look.loads;
    view.faces.mesh.visible = look.faces;
    view.grid.visible = false;
    const thin = THIN * scene.extent.size;
    if (look.grid) this.lines(groundOf(view), thin, THEMES.light.line);
    if (look.ghost) this.lines(ghostOf(scene), thin, "#a8b0b9");
    for (const node of look.paths) this.lines(piecesOf(Array.from({ length: scene.frames }, (_, k) => scene.position(k, node))), 2 * thin, THEMES.light.ink);
    if (look.mode === null) return;
    const { array } = scene.header.modes[look.mode];
    this.reach = (SWING * scene.extent.size) / (scene.arrays[array].data.reduce((most, x) => Math.max(most, Math.abs(x)), 0) || 1);
    view.mode = { array, size: 0 };
  }

  /** Lines as thin rods. */
  lines(pieces, radius, colour) {
    const rods = cylinder(pieces.length, 6);
    rods.material = new MeshBasicMaterial({ color: colour });
    pieces.forEach(([p, q], k) => placeAlong(rods, k, p, q, radius));
    this.view.world.add(rods);
  }

  /** The whole run, as near as it can be. */
  aim() {
    const { view, look } = this, { camera, controls } = view;
    camera.fov = ANGLE;
    view.resize();
    view.renderer.setPixelRatio(this.fine);
    const places = placesOf(view), around = 2 * view.bars.ball;
    if (view.mode) for (const size of [-this.reach, this.reach]) places.push(...this.swung(size));
    if (look.grid) places.push(...groundOf(view).flat());
    this.places = [-around, around].flatMap((more) => places.map((point) => point.map((x) => x + more)));
    const backward = new Vector3(...look.direction).normalize();
    camera.up.set(0, ...(Math.abs(backward.z) > 0.999 ? [1, 0] : [0, 1]));
    const { centre, far } = fitted(view, backward, this.places, MARGIN, 0);
    camera.position.copy(centre).addScaledVector(backward, far);
    camera.lookAt(centre);
    controls.target.copy(centre);
  }

  swung(size) {
    this.view.mode.size = size;
    return this.view.points();
  }

  /** Colours of members and faces; what the text around the picture says of them. */
  colour() {
    const { view, scene, look } = this, channel = look.colour && scene.channel(look.colour);
    if (!channel) return { step: view.step, unsure: false, limits: [0, 1], largest: 0, over: false, missing: false };
    const range = scene.range(channel.id), limits = limitsOf(channel.scale, [range]);
    view.setColours(channel, limits);
    return { step: view.step, unsure: scene.unsure.size > 0, limits, largest: Math.max(...range.map(Math.abs)), over: held(channel) && range[1] > 1, missing: this.missing(channel) };
  }

  missing(channel) {
    const { scene } = this;
    const seen = scene.members.map((_, member) => member).filter((member) => scene.shows(member));
    for (let k = 0; k < scene.frames; k++) if (seen.some((member) => Number.isNaN(scene.value(channel.id, k, member)))) return true;
    return false;
  }

  /** The picture of a sample as a data URL; phase : of the mode, -1 to 1. */
  shoot(sample, phase) {
    const { view } = this;
    if (view.mode) view.mode.size = phase * this.reach;
    view.setFrame(sample);
    view.render();
    this.pen.drawImage(view.canvas, 0, 0, this.look.width, this.look.height);
    return this.pen.canvas.toDataURL("image/png");
  }
}

/** The start pose: axes of bars, edges of faces. */
function ghostOf(scene) {
  const start = scene.nodes.map((_, node) => scene.position(0, node)), edges = edgesOf(scene.skin);
  const bars = scene.members.flatMap((_, member) => (scene.shows(member) ? piecesOf(scene.curves.points(start, member)) : []));
  return [...bars, ...Array.from({ length: edges.length / 2 }, (_, k) => [start[edges[2 * k]], start[edges[2 * k + 1]]])];
}

/** Lines of the ground at round distances, as far as the run reaches. */
function groundOf({ scene, step, grid, supports }) {
  const { low, high } = scene.extent;
  const from = [0, 1].map((axis) => Math.floor(low[axis] / step - 0.2)), to = [0, 1].map((axis) => Math.ceil(high[axis] / step + 0.2));
  const level = scene.dim === 2 ? grid.position.z : Math.min(grid.position.z, ...supports.feet(0).map((foot) => foot[2]));
  return [0, 1].flatMap((axis) => Array.from({ length: to[axis] - from[axis] + 1 }, (_, k) => [from, to].map((end) => {
    const point = [end[0] * step, end[1] * step, level];
    point[axis] = (from[axis] + k) * step;
    return point;
  })));
}
