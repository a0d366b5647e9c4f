// The picture where there is no WebGL: lines on a plain canvas, from the same sides. It does not turn with the pointer.

import { colourOf } from "./colour.js";
import { KINDS, LOAD, THEMES } from "./display.js";
import { niceStep } from "./format.js";
import { bodyAt, PRESSURE } from "./marks.js";
import { Picture, PRESETS } from "./picture.js";
import { symbolAt, symbolSize } from "./supports.js";
import { Traces } from "./traces.js";

const shown = () => ({ visible: true });

export class FlatView extends Picture {
  constructor(canvas, scene, theme) {
    super(canvas, scene);
    this.step = niceStep(scene.extent.size / 8);
    this.traces = new Traces(scene);
    Object.assign(this, { ghost: { visible: false }, grid: shown(), loads: { group: shown() }, supports: { mesh: shown() }, faces: { mesh: shown() } });
    this.controls = { update() {} };
    this.setTheme(theme);
    this.aim(scene.dim === 2 ? "plane" : "corner");
    this.setFrame(0);
  }

  setTheme(theme) {
    this.colours = THEMES[theme];
    this.request();
  }

  move() {
    this.now = this.points();
    this.request();
  }

  paint() {
    this.request();
  }

  pick(picked) {
    this.picked = picked;
    this.request();
  }

  showTraces(nodes) {
    this.paths = nodes;
    this.request();
  }

  rebuildLoads() {
    this.request();
  }

  aim(name) {
    this.preset = name;
    const back = PRESETS[name], size = Math.hypot(...back), b = back.map((x) => x / size);
    const up = Math.abs(b[2]) > 0.99 ? [0, 1, 0] : [0, 0, 1];
    this.turn(b, up);
    this.zoom = 1;
  }

  /** Axes of the canvas: to the right, upwards, towards the eye. */
  turn(b, up) {
    const r = [up[1] * b[2] - up[2] * b[1], up[2] * b[0] - up[0] * b[2], up[0] * b[1] - up[1] * b[0]], size = Math.hypot(...r) || 1;
    const right = r.map((x) => x / size);
    this.axes = [right, [b[1] * right[2] - b[2] * right[1], b[2] * right[0] - b[0] * right[2], b[0] * right[1] - b[1] * right[0]], b];
    this.request();
  }

  /** Turn (rad) and approach (factor) by keys. */
  orbit(across, upward, factor) {
    const [, , b] = this.axes, flat = Math.hypot(b[0], b[1]) || 1e-6;
    const angle = Math.atan2(b[1], b[0]) + across, rise = Math.min(Math.max(Math.atan2(b[2], flat) + upward, -1.5), 1.5);
    if (across || upward) this.turn([Math.cos(angle) * Math.cos(rise), Math.sin(angle) * Math.cos(rise), Math.sin(rise)], [0, 0, 1]);
    this.zoom /= factor;
    this.request();
    this.onCamera?.(this);
  }

  copyCamera(other) {
    if (other.axes) Object.assign(this, { axes: other.axes, zoom: other.zoom });
    this.request();
  }

  resize() {
    this.request();
  }

  end() {
    this.ended = true;
  }

  project(point) {
    const { clientWidth: width, clientHeight: height } = this.canvas, { centre, size } = this.scene.extent;
    const [x, y, z] = this.axes.map((axis) => axis.reduce((sum, value, i) => sum + value * (point[i] - centre[i]), 0));
    const factor = (0.86 * this.zoom * Math.min(width, height)) / size;
    return [width / 2 + factor * x, height / 2 - factor * y, 0.5 - z / (4 * size)];
  }

  render() {
    cancelAnimationFrame(this.waiting);
    this.waiting = 0;
    const { clientWidth: width, clientHeight: height } = this.canvas, ratio = window.devicePixelRatio || 1;
    if (this.ended || !width || !height) return;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    const pen = this.canvas.getContext("2d"), { scene, colours } = this;
    pen.scale(ratio, ratio);
    pen.fillStyle = colours.back;
    pen.fillRect(0, 0, width, height);
    pen.lineCap = "round";
    const places = this.now.map((point) => this.project(point));
    if (this.ghost.visible) this.bars(pen, scene.nodes.map((_, node) => scene.position(0, node)), () => colours.grid, 1);
    for (const node of this.paths || []) line(pen, Array.from({ length: scene.frames }, (_, frame) => this.project(scene.position(frame, node))), colours.ink, 1);
    this.skins(pen, places);
    this.bars(pen, this.now, () => colours.outline, 6);
    this.bars(pen, this.now, (member) => `rgb(${this.shade(member).join(" ")})`, 4);
    this.bars(pen, this.now, (member) => (this.hatched(member) ? colours.back : null), 4, [3, 6]);
    this.bars(pen, this.now, (member) => (this.picked?.type === "member" && this.picked.index === member ? "#ffb000" : null), 3);
    this.marks(pen, places);
    this.drawn = (this.drawn || 0) + 1;
    this.onDrawn?.(this);
  }

  /** Faces of meshes and bodies from back to front; those of meshes in the colour of their value, if it is known. */
  skins(pen, places) {
    const { scene, channel, frame, limits, colours } = this, told = channel && scene.coloursFaces(channel.id);
    const shade = (face) => (told ? `rgb(${colourOf(channel.scale, scene.faceValue(channel.id, frame, face), limits).join(" ")})` : colours.body);
    const faces = Array.from({ length: scene.faces }, (_, face) => ({ corners: [...scene.skin.slice(3 * face, 3 * face + 3)].map((node) => places[node]), fill: shade(face) }));
    faces.push(...(scene.header.solids || []).map((corners) => ({ corners: corners.map((node) => places[node]), fill: colours.body })));
    for (const body of scene.header.bodies) faces.push({ corners: bodyAt(scene, body, this.now).map((point) => this.project(point)), fill: colours.body });
    const depth = ({ corners }) => corners.reduce((sum, one) => sum + one[2], 0) / corners.length;
    pen.strokeStyle = colours.edge;
    pen.lineWidth = 0.3;
    pen.lineJoin = "round";
    for (const { corners, fill } of faces.sort((a, b) => depth(b) - depth(a))) {
      pen.beginPath();
      for (const [x, y] of corners) pen.lineTo(x, y);
      pen.closePath();
      pen.fillStyle = fill;
      pen.fill();
      pen.stroke();
    }
  }

  bars(pen, points, colour, width, dashes = []) {
    const { scene } = this;
    scene.members.forEach((_, member) => {
      const stroke = scene.shows(member) && colour(member);
      if (stroke) line(pen, scene.curves.points(points, member).map((point) => this.project(point)), stroke, width, dashes);
    });
  }

  marks(pen, places) {
    const { scene, colours } = this;
    const dot = ([x, y], radius, colour) => {
      pen.beginPath();
      pen.arc(x, y, radius, 0, 7);
      pen.fillStyle = colour;
      pen.fill();
    };
    if (this.supports.mesh.visible) for (const mark of scene.header.support_marks) {
      for (const one of symbolAt(mark, this.now[mark.node], symbolSize(scene))) line(pen, one.map((point) => this.project(point)), colours.support, 1.5);
    }
    if (scene.members.length < 800) places.forEach((place, node) => !scene.directors.has(node) && dot(place, this.picked?.type === "node" && this.picked.index === node ? 6 : 3, colours.node));
    for (const drive of scene.header.drives) {
      const node = drive.kind === "coordinate" ? drive.node : drive.kind === "hinge" ? drive.axis[0] : scene.ends[2 * drive.member];
      dot(drive.kind === "length" ? middle(places, scene, drive.member) : places[node], 5, KINDS.driven);
    }
    if (this.loads.group.visible && scene.has("load_force")) this.arrows(pen);
  }

  arrows(pen) {
    const { scene, frame } = this;
    const sizes = scene.header.loads.map((_, k) => Math.hypot(...scene.vector("load_force", frame, k))), most = Math.max(...sizes, 1e-30);
    scene.header.loads.forEach((load, k) => {
      if (load.drawn === false || sizes[k] < 1e-3 * most) return;
      const force = scene.vector("load_force", frame, k), point = scene.placeOfLoad(load, (node) => this.now[node]);
      const long = (load.pressure ? PRESSURE : 1) * 0.16 * scene.extent.size;
      const from = load.at ? point.map((x, i) => x - (long * force[i]) / most) : point;
      const [p, q] = [from, from.map((x, i) => x + (long * force[i]) / most)].map((point) => this.project(point));
      line(pen, [p, q], LOAD, 2);
      pen.fillStyle = LOAD;
      pen.fillRect(q[0] - 3, q[1] - 3, 6, 6);
    });
  }
}

function middle(places, scene, member) {
  const [p, q] = [places[scene.ends[2 * member]], places[scene.ends[2 * member + 1]]];
  return [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
}

function line(pen, points, colour, width, dashes = []) {
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.setLineDash(dashes);
  pen.beginPath();
  for (const [x, y] of points) pen.lineTo(x, y);
  pen.stroke();
  pen.setLineDash([]);
}
