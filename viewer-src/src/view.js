// One picture of one scene, drawn by WebGL: what is drawn, and from where.

import {
  AmbientLight, Color, DirectionalLight, MOUSE, PerspectiveCamera, Scene as World, TOUCH, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Bars } from "./bars.js";
import { THEMES } from "./display.js";
import { Halo } from "./halo.js";
import { Bodies } from "./bodies.js";
import { Centres, Drives, Faces, ghost, ground, Loads, Supports } from "./marks.js";
import { Picture, PRESETS } from "./picture.js";
import { Skins } from "./skins.js";
import { Traces } from "./traces.js";
import { Triad } from "./triad.js";

const MARGIN = 0.8; // of the picture that a structure fills, so that names and arrows have room
const SEVERAL = 20000; // points of a run that a camera looks at
const LEGEND = 104; // CSS pixels above, where the legend stands

/** Places of a run that are to be seen: nodes, tips of arrows, feet of supports, and those of diagrams beside members. */
export function placesOf({ scene, loads, supports, beside = [] }) {
  const places = [...beside], step = Math.max(1, Math.ceil((scene.frames * scene.nodes.length) / SEVERAL)), last = scene.frames - 1;
  for (let k = 0; k <= last; k = k < last ? Math.min(k + step, last) : k + 1) {
    for (let node = 0; node < scene.nodes.length; node++) if (!scene.directors.has(node)) places.push(scene.position(k, node));
    places.push(...loads.tips(k), ...supports.feet(k));
  }
  return places;
}

/**
 * What the camera looks at and how far away it is, so that all places are in the picture and as large as possible.
 * margin : part of the picture that they fill; legend : CSS pixels above that they leave free.
 */
export function fitted({ scene, camera, canvas }, backward, places, margin = MARGIN, legend = LEGEND) {
  const right = new Vector3().crossVectors(camera.up, backward);
  if (right.length() < 1e-3) right.set(1, 0, 0); // seen along the upright axis
  right.normalize();
  const upward = new Vector3().crossVectors(backward, right), slope = Math.tan((camera.fov * Math.PI) / 360), wide = camera.aspect;
  const above = Math.min(legend / (canvas.clientHeight || 1000), 0.25), across = slope * wide * margin, steep = slope * (margin - above);
  const flat = places.map((point) => {
    const place = new Vector3(...point);
    return [place.dot(right), place.dot(upward), place.dot(backward)];
  });
  const middle = [0, 1, 2].map((axis) => (flat.reduce((low, one) => Math.min(low, one[axis]), Infinity) + flat.reduce((high, one) => Math.max(high, one[axis]), -Infinity)) / 2);
  let far = scene.extent.size;
  for (let turn = 0; turn < 4; turn++) { // near points look larger, so that the middle of the picture is not that of the box
    far = flat.reduce((most, [x, y, w]) => Math.max(most, Math.abs(x - middle[0]) / across + w - middle[2], Math.abs(y - middle[1]) / steep + w - middle[2]), 0.05 * scene.extent.size);
    for (const axis of [0, 1]) {
      const seen = flat.map((one) => (one[axis] - middle[axis]) / (far - one[2] + middle[2]));
      if (turn < 3) middle[axis] += (far * (seen.reduce((a, b) => Math.min(a, b), Infinity) + seen.reduce((a, b) => Math.max(a, b), -Infinity))) / 2;
    }
  }
  // only as far below the middle as the legend asks for
  const top = flat.reduce((most, one) => Math.max(most, (one[1] - middle[1]) / (far - one[2] + middle[2]) / slope), 0);
  middle[1] += Math.max(0, top - margin + 2 * above) * slope * far;
  const centre = new Vector3().addScaledVector(right, middle[0]).addScaledVector(upward, middle[1]).addScaledVector(backward, middle[2]);
  return { centre, far };
}

/** Whether this browser draws by WebGL. */
export function hasWebGL() {
  return Boolean(document.createElement("canvas").getContext("webgl2"));
}

export class View extends Picture {
  constructor(canvas, scene, theme, antialias = scene.members.length < 2000) {
    super(canvas, scene);
    this.renderer = new WebGLRenderer({ canvas, antialias, preserveDrawingBuffer: true });
    this.renderer.autoClear = false;
    this.world = new World();
    this.camera = new PerspectiveCamera(32, 1, scene.extent.size / 500, scene.extent.size * 60);
    this.camera.up.set(0, scene.dim === 2 ? 1 : 0, scene.dim === 2 ? 0 : 1);
    this.lamp = new DirectionalLight("#ffffff", 2.1);
    this.lampPlace = [-0.35, 0.6, 1]; // it goes with the eye, a little above and to the left of it
    this.ambient = new AmbientLight("#ffffff", 1.45);
    this.world.add(this.ambient, this.lamp);
    this.controls = new OrbitControls(this.camera, canvas);
    if (scene.dim === 2) { // stays flat: what would turn it shifts it
      this.controls.enableRotate = false;
      this.controls.mouseButtons.LEFT = MOUSE.PAN;
      this.controls.touches.ONE = TOUCH.PAN;
    }
    this.controls.addEventListener("change", () => this.onCamera?.(this));
    this.triad = new Triad(scene);
    this.build();
    this.setTheme(theme);
    this.aim(scene.dim === 2 ? "plane" : "corner");
    this.setFrame(0);
  }

  build() {
    const { scene, world } = this;
    const size = 0.1 * scene.length0;
    this.bars = new Bars(scene);
    this.supports = new Supports(scene);
    this.loads = new Loads(scene, 0.9 * size);
    this.drives = new Drives(scene, size);
    this.bodies = new Bodies(scene, this.bars.ball);
    this.traces = new Traces(scene);
    this.centres = new Centres(scene, 0.25 * size);
    this.faces = new Faces(scene, scene.header.triangles, 0.35);
    this.faces.mesh.visible = false;
    this.skins = new Skins(scene);
    this.halo = new Halo(this.bars);
    Object.assign(this, ground(scene));
    this.ghost = ghost(scene);
    this.ghost.visible = false;
    world.add(...this.bars.objects(), this.supports.mesh, this.loads.group, this.drives.group, this.bodies.group, this.centres.mesh,
      this.faces.mesh, this.traces.group, ...this.skins.objects(), this.halo.group, this.grid, this.ghost);
  }

  rebuildLoads() {
    this.world.remove(this.loads.group);
    this.loads = new Loads(this.scene, 0.09 * this.scene.length0);
    this.world.add(this.loads.group);
    this.triad.setGravity(this.scene.header.gravity);
  }

  setTheme(theme) {
    this.renderer.setClearColor(new Color(THEMES[theme].back));
    for (const one of [this.bars, this.supports, this.bodies, this.traces]) one.setTheme(THEMES[theme]);
    this.skins.setTheme(theme);
    this.triad.setTheme(theme);
    this.paint();
  }

  move() {
    this.now = this.points();
    [this.bars, this.supports, this.drives, this.bodies, this.centres, this.faces, this.skins].forEach((one) => one.place(this.now, this.frame));
    this.loads.place(this.now, this.frame);
    this.halo.place(this.now, this.picked);
    this.request();
  }

  pick(picked) {
    this.picked = picked;
    this.halo.place(this.now, picked);
    this.request();
  }

  paint() {
    this.bars.paint((member) => this.shade(member), (member) => this.hatched(member));
    this.skins.paint(this.channel, this.frame, this.limits);
    this.request();
  }

  /** Paths of these nodes. */
  showTraces(nodes) {
    this.traces.show(nodes);
    this.request();
  }

  /** Look at the whole from one of the presets. */
  aim(name) {
    const { scene, camera, controls } = this;
    const direction = new Vector3(...PRESETS[name]).normalize();
    const { centre, far } = fitted(this, direction, placesOf(this));
    camera.position.copy(centre).addScaledVector(direction, far);
    controls.target.copy(centre);
    controls.update();
    this.preset = name;
    this.request();
  }

  /** Turn (rad) and approach (factor) by keys. */
  orbit(across, upward, factor) {
    const { camera, controls } = this;
    const offset = camera.position.clone().sub(controls.target);
    offset.applyAxisAngle(camera.up, across);
    const side = new Vector3().crossVectors(camera.up, offset).normalize();
    const lifted = offset.clone().applyAxisAngle(side, -upward);
    if (Math.abs(lifted.clone().normalize().dot(camera.up)) < 0.995) offset.copy(lifted);
    camera.position.copy(controls.target).addScaledVector(offset, factor);
    controls.update();
    this.request();
  }

  copyCamera(other) {
    this.camera.position.copy(other.camera.position);
    this.controls.target.copy(other.controls.target);
    this.camera.lookAt(this.controls.target);
    this.request();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.bars.resize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (!this.sized && this.preset) this.aim(this.preset); // the first size is known only now
    this.sized = true;
    this.request();
  }

  end() {
    this.ended = true;
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** Draw now: what was asked for is then on the screen. */
  render() {
    cancelAnimationFrame(this.waiting);
    this.waiting = 0;
    if (this.ended) return;
    const { renderer, camera } = this;
    this.lamp.position.set(...this.lampPlace).applyQuaternion(camera.quaternion);
    const far = camera.position.distanceTo(this.controls.target), pixel = (2 * far * Math.tan((camera.fov * Math.PI) / 360)) / this.canvas.clientHeight;
    this.bars.setScale(this.bars.ball / 1.55 / pixel);
    renderer.clear();
    renderer.render(this.world, camera);
    this.triad.render(renderer, camera);
    this.drawn = (this.drawn || 0) + 1;
    this.onDrawn?.(this);
  }

  /** Where a point is on the canvas, in CSS pixels, and how far away. */
  project(point) {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const seen = new Vector3(...point).project(this.camera);
    return [((seen.x + 1) / 2) * width, ((1 - seen.y) / 2) * height, seen.z];
  }
}
