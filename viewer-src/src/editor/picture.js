// A picture under the drawing, to trace: placed, turned and scaled by two of its points.

import { el, section, svg } from "../dom.js";
import { button, check, field, refill } from "./fields.js";

const LARGEST = 3_000_000; // characters of a picture that is kept as it is
const SIDE = 1600; // pixels of a larger one

/** A file as a data URL. */
function url(file) {
  return new Promise((resolve) => {
    const reader = new FileReader();
    reader.addEventListener("load", () => resolve(reader.result));
    reader.addEventListener("error", () => resolve(""));
    reader.readAsDataURL(file);
  });
}

/** A large picture with fewer pixels; its place counts in those it had, and stays. */
function smaller(image, { width, height }) {
  const share = Math.min(1, SIDE / Math.max(width, height));
  const canvas = el("canvas", { width: Math.round(share * width), height: Math.round(share * height) });
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  return canvas.toDataURL("image/jpeg", 0.85);
}

export class Picture {
  constructor(draw) {
    Object.assign(this, { draw, image: null, placing: null, points: [], opacity: 0.5, shown: true });
    this.file = el("input", { type: "file", accept: "image/*", "aria-label": "picture to trace", onchange: () => this.load() });
    this.body = el("div", {});
    this.node = section("Picture to trace", this.file, this.body);
    this.node.open = false;
    this.image = null;
  }

  async load() {
    const [file] = this.file.files;
    if (!file) return;
    const source = await url(file);
    const image = new Image();
    image.addEventListener("load", () => {
      const { camera } = this.draw, { axis, at } = camera.plane;
      const [u, v] = camera.across;
      const size = (0.6 * Math.min(camera.width, camera.height)) / camera.scale / Math.max(image.naturalWidth, image.naturalHeight);
      const origin = camera.unproject([camera.width / 2, camera.height / 2]) || [0, 0, 0];
      origin[u] -= (size * image.naturalWidth) / 2;
      origin[v] += (size * image.naturalHeight) / 2;
      this.loaded = image;
      this.image = { source: image.src, width: image.naturalWidth, height: image.naturalHeight, axes: [u, v], axis, at, turn: [size, 0], origin: [origin[u], origin[v]] };
      this.points = [];
      this.rebuild();
      this.draw.canvas.update();
      this.keep(true);
    });
    image.addEventListener("error", () => this.draw.tell("This file is no picture that the browser can show.", true));
    image.src = source;
  }

  /** Let the picture outlive the page; one that is too large is kept smaller. */
  async keep(whole = false) {
    if (!this.image || this.draw.closed) return;
    const { source, ...place } = this.image;
    const command = { do: "picture", place: { ...place, opacity: this.opacity, shown: this.shown } };
    if (whole) command.source = source.length < LARGEST ? source : smaller(this.loaded, place);
    await this.draw.ask(command);
  }

  /** The picture that an earlier page had. */
  take(kept) {
    if (!kept || this.image) return;
    const { opacity, shown, ...place } = kept.place;
    Object.assign(this, { image: { ...place, source: kept.source }, opacity, shown });
    this.rebuild();
  }

  remove() {
    this.image = null;
    this.file.value = "";
    refill(this.body);
    this.draw.canvas.update();
    this.draw.ask({ do: "picture", place: null });
  }

  rebuild() {
    if (!this.image) return;
    const slider = el("input", { type: "range", min: 0, max: 1, step: 0.05, value: this.opacity, "aria-label": "opacity of the picture" });
    slider.addEventListener("input", () => { this.opacity = Number(slider.value); this.draw.canvas.update(); });
    slider.addEventListener("change", () => this.keep());
    const words = ["Click the first point in the picture.", "Click the second point in the picture."];
    refill(this.body, el("div", { class: "row" }, check("shown", this.shown, (on) => { this.shown = on; this.draw.canvas.update(); this.keep(); }), slider, button("Remove", () => this.remove(), { "aria-label": "remove the picture" })),
      button("Place by two points", () => this.begin()), this.placing ? el("p", { role: "status" }, words[this.points.length] || "") : null,
      this.points.length === 2 && !this.placing ? this.entries() : null);
  }

  begin() {
    Object.assign(this, { placing: true, points: [] });
    this.rebuild();
    this.draw.tell("Click the first point in the picture.");
  }

  /** A click while the picture is being placed: the pixel under it. */
  click(place) {
    const { origin, turn, axes, at } = this.image, point = this.draw.camera.unproject(place, at);
    if (!point) return;
    const [dx, dy] = [point[axes[0]] - origin[0], point[axes[1]] - origin[1]];
    const [c, s] = turn, size = c * c + s * s;
    this.points.push([(c * dx + s * dy) / size, (s * dx - c * dy) / size]);
    if (this.points.length === 2) this.placing = null;
    this.draw.tell(this.points.length === 2 ? "Now write where the two points are." : "Click the second point in the picture.");
    this.rebuild();
  }

  entries() {
    const names = this.image.axes.map((k) => "xyz"[k]);
    const rows = ["first", "second"].map((which, k) => names.map((name, i) => field(name, k && !i ? 1 : 0, () => {}, { size: 5, name: `${name} of the ${which} point in m` })));
    const apply = () => {
      const values = rows.map((row) => row.map((one) => Number(one.querySelector("input").value)));
      if (values.flat().some((value) => !Number.isFinite(value))) return this.draw.tell("Write the places as numbers, in m.", true);
      this.fit(values);
    };
    return el("fieldset", {}, el("legend", {}, "Their places (m)"), rows.map((row) => el("div", { class: "row" }, row)), button("Place", apply));
  }

  /** The similarity that takes the two pixels to the two places. */
  fit([a, b]) {
    const [p, q] = this.points.map(([x, y]) => [x, -y]); // pixels run down
    const [px, py] = [q[0] - p[0], q[1] - p[1]], [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    const size = px * px + py * py;
    if (!size || !(dx || dy)) return this.draw.tell("The two points coincide. Choose two that are far apart.", true);
    const [c, s] = [(px * dx + py * dy) / size, (px * dy - py * dx) / size];
    this.image.turn = [c, s];
    this.image.origin = [a[0] - c * p[0] + s * p[1], a[1] - s * p[0] - c * p[1]];
    this.points = [];
    this.rebuild();
    this.draw.tell("");
    this.draw.canvas.update();
    this.keep();
  }

  place(layer) {
    const { image, draw } = this;
    if (!image || !this.shown) return layer.replaceChildren();
    const [u, v] = image.axes, [c, s] = image.turn;
    const at = (x, y) => {
      const point = [0, 0, 0];
      [point[u], point[v], point[image.axis]] = [image.origin[0] + c * x + s * y, image.origin[1] + s * x - c * y, image.at];
      return draw.camera.project(point);
    };
    const [o, ex, ey] = [at(0, 0), at(1, 0), at(0, 1)];
    const matrix = [ex[0] - o[0], ex[1] - o[1], ey[0] - o[0], ey[1] - o[1], o[0], o[1]];
    this.element ||= svg("image", {});
    for (const [name, value] of Object.entries({ href: image.source, width: image.width, height: image.height, opacity: this.opacity, preserveAspectRatio: "none", transform: `matrix(${matrix.join(" ")})` })) this.element.setAttribute(name, value);
    layer.replaceChildren(this.element);
  }
}
