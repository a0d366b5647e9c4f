// The drawing runs: the drives go through their range, and forces, paths, reactions and what holds the drives follow.

import { el, svg } from "../dom.js";
import { number, quantity } from "../format.js";
import { Player } from "../player.js";
import { plot } from "../plot.js";
import { TimeBar, usualSpeed } from "../timebar.js";
import { button, choice, refill } from "./fields.js";
import { nextSteps } from "./next_steps.js";
import { Rate, rateOf } from "./rate.js";
import { usual } from "./sweep.js";

const ALL = "all drives", FREE = "let go";
const FEW_PATHS = 6; // moving nodes up to which all have their path, else those that are picked
const SWINGS = 2; // bars whose swing is told
const LISTED = 4; // members that are told by name
const TOLD = 100; // ms between two changes of the numbers in the panel while it plays
const NEAR_END = 0.01; // of all samples, within which the reason why it goes no further is marked
const WAYS = { round: "Full turn", back: "There and back", once: "Once" };

export class Play extends Player {
  constructor(draw) {
    super();
    Object.assign(this, { draw, film: null, drawn: null, way: "round", chosen: "", atSpeed: false, rate: new Rate(this), pace: null, told: 0, awaited: 0, turn: 0, touch: matchMedia("(hover: none)").matches });
    this.controls = el("div", { class: "row" });
    this.aside = el("span", { class: "row", hidden: true }, button("Keep this pose", () => this.keep(), { title: "Draw the mechanism in the pose shown" }),
      button("Back", () => this.home(), { title: this.hint("Back to the pose that is drawn", "Escape"), "aria-label": "back to the drawn pose" }));
    this.words = el("p", { class: "words", role: "status" });
    this.canvas = el("canvas", { class: "plot", role: "img", "aria-label": "force or torque of the drive along its range" });
    this.cursor = el("i", { class: "now" });
    this.graph = el("div", { class: "graph", hidden: true }, this.canvas, this.cursor);
    for (const kind of ["pointerdown", "pointermove"]) this.graph.addEventListener(kind, (event) => event.buttons && this.point(event));
    this.node = el("section", { class: "motion", "aria-label": "motion" }, this.controls, this.words, this.graph);
    this.node.addEventListener("keydown", (event) => {
      if (event.key !== " " || event.target.type !== "range") return;
      event.preventDefault();
      this.togglePlay();
    });
    new ResizeObserver(() => this.curve()).observe(this.graph);
  }

  hint(words, key) {
    return this.touch ? words : `${words} (${key})`;
  }

  /** Whether another pose is shown than the one that is drawn. */
  get away() {
    return this.drawn !== null;
  }

  // -- the motion --------------------------------------------------------------------------------------------------

  /** Whether it moves by itself: nothing drives it, or what is driven leaves a mechanism. */
  get falls() {
    const { drives, mobility } = this.draw.state;
    return this.chosen === FREE || !drives.length || mobility?.undriven > 0;
  }

  get movable() {
    const { drives, mobility } = this.draw.state;
    return Boolean(drives.length || mobility?.freedoms);
  }

  get drives() {
    const names = this.falls ? [] : this.draw.state.drives.map(({ name }) => name);
    return this.chosen === ALL ? names : [names.includes(this.chosen) ? this.chosen : names[0]].filter(Boolean);
  }

  /** Play or pause; the motion is computed where it is not known. */
  async toggle() {
    if (this.draw.closed) return;
    if (this.film) return this.togglePlay();
    this.going = true;
    await this.load();
  }

  /** Ask for the motion of the drives. Of several that are asked for the last is shown, if the drawing is still the same. */
  async load() {
    if (!this.movable) return this.refuse("Nothing is driven yet.");
    const { revision } = this.draw.state, turn = ++this.turn;
    const film = await this.ask(this.command(this.falls ? null : this.rate.good(this.unit)));
    if (turn !== this.turn || revision !== this.draw.state.revision) return;
    if (!this.isFilm(film)) return this.refuse(film.message || "");
    this.show(film);
    if (this.going && !this.playing) this.togglePlay();
    this.going = false;
  }

  /** Unit of the first drive that moves. */
  get unit() {
    return this.draw.state.drives.find(({ name }) => name === this.drives[0]).unit;
  }

  /** What is asked for, at a rate of the first drive; the strength where it is shown. */
  command(rate) {
    if (this.falls) return { do: "let_go", held: this.chosen !== FREE, strength: this.draw.shown.strength };
    return { do: "sweep", drives: this.drives, rate: this.atSpeed ? rate : null, at_speed: this.atSpeed, strength: this.draw.shown.strength };
  }

  async ask(command) {
    this.awaited++;
    const answer = await this.draw.ask(command);
    this.awaited--;
    return answer;
  }

  isFilm(answer) {
    return answer.kind === "sweep" && answer.revision === this.draw.state.revision;
  }

  /** Show a motion, at the place of the one before. */
  show(film) {
    const { value } = this, inside = this.node.contains(document.activeElement), before = this.film, home = before && !this.away;
    Object.assign(this, { film, key: "", failed: "", index: film.here });
    film.number = this.loads = (this.loads || 0) + 1;
    this.setLead(film);
    if (this.pace) Object.assign(this, { speed: this.pace, speeds: [...new Set([...this.speeds, this.pace])].sort((a, b) => a - b) });
    this.way = film.falls ? "once" : !film.whole && this.way === "round" ? "back" : film.whole && !this.asked ? "round" : this.way;
    this.time = new TimeBar(this);
    this.rebuild();
    if (home) this.time.update();
    else this.goTo(value === undefined ? film.here : this.nearest(value));
    if (this.playing) this.start();
    this.judge();
    if (before) return;
    this.reveal();
    if (inside) this.time.button.focus();
  }

  /** The strength is shown, or not any more: along a motion it is computed when it is asked for. */
  judge() {
    const { film } = this;
    if (film && !film.judged && this.draw.shown.strength && !this.awaited) this.load();
    this.say();
  }

  /** A speed that is chosen stays for the motions that follow. */
  setSpeed(speed) {
    this.pace = speed === usualSpeed(this.duration) ? null : speed;
    super.setSpeed(speed);
  }

  /** Show all that moves, if a part of it goes out of sight. */
  reveal() {
    const { draw, film } = this, { camera } = draw;
    draw.canvas.resize();
    const places = Array.from({ length: film.frames }, (_, k) => film.nodes.map((_, node) => film.position(k, node))).flat();
    const away = ([x, y]) => x < 0 || y < 0 || x > camera.width || y > camera.height;
    if (!places.some((place) => away(camera.project(place)))) return;
    camera.fit(places);
    draw.canvas.update();
  }

  refuse(message) {
    Object.assign(this, { failed: message, going: false });
    this.rebuild();
  }

  /** The sample at which the first drive is nearest to a value. */
  nearest(value) {
    const { film } = this;
    let best = film.here;
    for (let k = 0; k < film.frames; k++) if (Math.abs(film.value(k) - value) < Math.abs(film.value(best) - value)) best = k;
    return best;
  }

  togglePlay() {
    super.togglePlay();
    if (this.playing) this.draw.diagram.spoil();
    else this.tell();
  }

  goTo(index) {
    const { draw, film } = this, { state } = draw;
    this.index = Math.min(Math.max(Math.round(index), 0), film.frames - 1);
    const fields = film.shown(this.index, state);
    this.drawn ||= Object.fromEntries(Object.keys(fields).map((name) => [name, state[name]]));
    this.value = film.value(this.index);
    Object.assign(state, fields);
    draw.root.classList.add("away");
    this.aside.hidden = false;
    draw.canvas.update(this.playing);
    this.time.update();
    this.mark();
    if (!this.playing || performance.now() - this.told > TOLD) this.tell();
  }

  /** The numbers beside the picture. */
  tell() {
    const { draw } = this;
    this.told = performance.now();
    draw.status.numbers(draw.state);
    draw.properties.follow();
    if (!this.playing) draw.diagram.follow();
    this.say();
  }

  pause() {
    super.pause();
    this.tell();
  }

  /** Back to the pose that is drawn: whatever changes the drawing begins there. */
  home() {
    if (!this.away) return;
    this.playing = false;
    Object.assign(this.draw.state, this.drawn);
    this.drawn = null;
    this.draw.root.classList.remove("away");
    this.draw.canvas.update();
    this.index = this.film.here;
    this.time.update();
    this.aside.hidden = true;
    this.tell();
    this.mark();
  }

  /** The drawing has changed: its motion is another one, which goes on if it was played. */
  spoil() {
    const { state } = this.draw;
    if (this.film?.revision === state.revision) {
      if (this.away) {
        this.drawn = null;
        this.goTo(this.index);
      }
      if (this.going) this.toggle();
      this.going = false;
      return;
    }
    const going = this.going || this.playing;
    Object.assign(this, { film: null, drawn: null, playing: false, failed: "", going: false });
    this.draw.root.classList.remove("away");
    this.rebuild();
    if (going) this.toggle();
  }

  /** The pose shown becomes the drawn one. */
  async keep() {
    const { film, index, draw } = this;
    const values = Object.fromEntries(film.drives.map(({ name }, d) => [name, film.arrays.drive_position.data[index * film.drives.length + d]]));
    this.value = undefined;
    await draw.edit({ do: "put", ...(film.falls ? { sample: index } : { values }) });
  }

  /** A place of the curve. */
  point(event) {
    if (!this.frame) return;
    const x = event.clientX - this.canvas.getBoundingClientRect().left, { xs } = this;
    let best = 0;
    for (let k = 0; k < xs.length; k++) if (Math.abs(this.frame.x(xs[k]) - x) < Math.abs(this.frame.x(xs[best]) - x)) best = k;
    this.seek(this.order[best]);
  }

  // -- what is shown -----------------------------------------------------------------------------------------------

  rebuild() {
    const { draw, film } = this, { state } = draw;
    if (!state) return;
    const names = state.drives.map(({ name }) => name);
    const other = (change) => {
      Object.assign(this, change);
      const playing = this.playing || !film;
      this.home();
      this.film = null;
      if (playing && film) return this.toggle();
      return film ? this.load() : this.rebuild();
    };
    const bar = film ? this.time.node : button("▶ Play", () => this.toggle(), { class: "play", title: this.hint("Play: the drives go through their range", "space"), disabled: !this.movable });
    const moves = state.mobility?.undriven ? [["", "hold still"]] : [...names, ...(names.length > 1 ? [ALL] : [])];
    const drive = names.length ? choice("Drive", [...moves, FREE], this.chosen || moves[0], (chosen) => other({ chosen, value: undefined }), "drive that moves") : null;
    const ways = Object.entries(WAYS).filter(([way]) => film?.whole || way !== "round");
    const way = film && !film.falls ? choice("Way", ways, this.way, (chosen) => { this.asked = true; this.setWay(chosen); }, "way through the range") : null;
    const speed = film ? el("label", { class: "entry" }, el("span", {}, "Speed"), this.time.speed) : null;
    const inertia = (film ? !film.bent && !film.falls : this.atSpeed) ? choice("Forces", [["", "at rest"], ["on", "at speed"]], this.atSpeed ? "on" : "", (on) => other({ atSpeed: Boolean(on) }), "forces while it moves") : null;
    refill(this.controls, bar, speed, drive, way, inertia, film && this.atSpeed ? this.rate.node(film) : null, this.aside);
    this.aside.hidden = !this.away;
    if (film) this.graph.before(this.words);
    else this.controls.append(this.words); // beside the button: the picture keeps its size
    this.graph.hidden = !film;
    this.say();
    this.curve();
  }

  /** Words below the bar: what it needs, why it goes no further, how far it swings. */
  say() {
    const { film, draw } = this, { state } = draw;
    const key = [state.revision, film?.number, film && this.ended(), this.limit, this.failed, film && this.unjudged(), draw.shown.strength].join();
    if (key === this.saidOf) return; // a button that is pressed stays
    this.saidOf = key;
    if (film) return refill(this.words, ...this.found());
    const words = this.failed || (state.drives.length || !state.members.length ? "" : this.movable && state.weights?.all > 0 ? "Nothing is driven yet: Play lets it go." : "Nothing is driven yet.");
    refill(this.words, words ? el("span", {}, `${words} `) : null, nextSteps(draw, this));
  }

  /** Whether the first or the last sample is shown, or nearly. */
  ended() {
    const last = this.film.frames - 1, near = Math.max(1, NEAR_END * last);
    return [this.index <= near, this.index >= last - near];
  }

  found() {
    const { film } = this, last = film.frames - 1, here = this.ended();
    const ends = film.ends.map((words, k) => words && el("b", { class: here[k] ? "here" : "" }, `${words} `));
    const spans = film.swept.map((name) => {
      const d = film.drives.findIndex((one) => one.name === name), { unit } = film.drives[d];
      return film.whole ? `${name}: full turn` : `${name}: ${quantity(film.value(0, d), unit)} to ${quantity(film.value(last, d), unit)}`;
    });
    const held = Array.from({ length: film.frames }, (_, k) => Math.abs(film.held(k)));
    const most = held.reduce((best, size, k) => (size <= this.limit * (1 + 1e-6) && size > (held[best] ?? 0) ? k : best), -1);
    const { unit } = film;
    const torque = held[most] > 0 ? ` Largest ${unit === "rad" ? "torque" : "force"}${this.cut ? " away from the dead point" : ""} ${quantity(held[most], unit === "rad" ? "N m" : "N")} at ${quantity(film.value(most), unit)}.` : "";
    const speed = film.at_speed ? `${film.swept[0]} at ${rateOf(film.rate, unit)}. ` : "";
    if (film.falls) spans.push(`Let go${film.arrays.kinetic_energy.data[0] > 0 ? " with the velocities of the model" : ", from rest"}${film.drives_hold && film.drives.length ? ", while the drives hold still" : ""}`);
    const bent = film.bent ? "Parts that bend or stretch are in equilibrium, at rest. " : "";
    return [...ends, el("span", {}, `${bent}${speed}${spans.slice(0, 3).join("; ")}.${torque} ${this.swings().join(" ")} `), this.strength(), nextSteps(this.draw, this)];
  }

  /** Members that are checked in other poses and not in the one shown. */
  unjudged() {
    const { film, draw, index } = this;
    if (!draw.shown.strength || !film.judged) return [];
    const used = film.used(index);
    return film.judged.filter((name) => !(name in used) && !film.never.includes(name));
  }

  /** The largest utilisation along the motion, and what was not checked. */
  strength() {
    const { film, draw } = this, { most, never } = film;
    if (!draw.shown.strength || !film.judged) return null;
    if (!most) return el("span", {}, "Strength is not checked: it needs sections and materials. ");
    const some = (names) => `${names.slice(0, LISTED).join(", ")}${names.length > LISTED ? ` and ${names.length - LISTED} more` : ""}`, here = this.unjudged();
    const unsure = film.unsure.length ? `Not unique: the forces of ${some(film.unsure)}, and so their strength. ` : "";
    return el("span", { class: most.value > 1 ? "here" : "" }, `Strength: at most ${quantity(most.value, "%")} of what is allowed, of ${most.member} at ${this.placeOf(most.sample)}. `,
      never.length ? `Not checked: ${some(never)}. ` : "", here.length ? `Not checked in this pose: ${some(here)}. ` : "", unsure);
  }

  /** How far bars swing that have one held end and are not driven. */
  swings() {
    const { film, draw } = this, { state } = draw;
    if (state.dim !== 2) return [];
    const held = (node) => (state.fixed[node] || "").length === 2, driven = new Set(state.drives.map(({ bar }) => bar));
    const bars = state.members.filter(({ name, ends, goes_on: on }) => !on && held(ends[0]) !== held(ends[1]) && !driven.has(name)).slice(0, SWINGS);
    return bars.map(({ name, ends }) => {
      const [from, to] = (held(ends[0]) ? ends : [...ends].reverse()).map((node) => film.nodes.indexOf(node));
      const [low, high] = film.swing(from, to), deg = (angle) => number((angle * 180) / Math.PI, 4);
      return high - low > 2 * Math.PI - 0.1 ? `${name} turns all round.` : high - low > 1e-6 ? `${name} swings ${deg(high - low)} deg (${deg(low)} to ${deg(high)} deg).` : "";
    });
  }

  /** Where a sample is: the value of the first drive, or the time. */
  placeOf(k) {
    const { film } = this;
    return `${film.falls ? "" : `${film.swept[0]} `}${quantity(film.value(k), film.unit)}`;
  }

  /** What the bar tells beside its slider. */
  said() {
    const { film } = this;
    return film.swept.length < 2 ? this.placeOf(this.index) : `${number((100 * this.index) / (film.frames - 1), 3)} %`;
  }

  /** What holds or moves the drive along its range. */
  curve() {
    const { film } = this;
    if (!film || this.graph.hidden || !this.graph.clientWidth) return;
    const { unit } = film, turning = unit === "rad", single = film.swept.length === 1;
    const x = (k) => (single ? film.value(k) * (turning ? 180 / Math.PI : 1) : film.time[k] - film.time[0]);
    this.order = Array.from({ length: film.frames }, (_, k) => k).sort((a, b) => x(a) - x(b));
    this.xs = this.order.map(x);
    const shown = film.drives.map((one, d) => ({ ...one, d })).filter((one) => film.swept.includes(one.name) && one.unit === unit).slice(0, 3);
    const largest = shown.map(({ d }) => usual(Array.from({ length: film.frames }, (_, k) => Math.abs(film.held(k, d)))));
    this.limit = Math.max(...largest);
    this.cut = shown.some(({ d }, i) => Array.from({ length: film.frames }, (_, k) => Math.abs(film.held(k, d))).some((size) => size > largest[i] * (1 + 1e-6)));
    const curves = shown.map(({ name, d }, i) => ({ x: this.xs, y: this.order.map((k) => (Math.abs(film.held(k, d)) > largest[i] * (1 + 1e-6) ? NaN : film.held(k, d))), label: name }));
    const what = turning ? "torque" : "force", energies = () => ["kinetic", "potential"].map((label) => ({ x: this.xs, y: film.above(`${label}_energy`), label }));
    if (film.falls) this.frame = plot(this.canvas, energies(), { unit: "J", xUnit: "s", title: "energy" });
    else this.frame = plot(this.canvas, curves, { unit: turning ? "N m" : "N", xUnit: single ? (turning ? "deg" : "m") : "s", title: this.atSpeed ? `driving ${what}` : `holding ${what}` });
    this.place = x;
    this.mark();
    this.say();
  }

  mark() {
    if (this.frame && this.film) this.cursor.style.left = `${this.frame.x(this.place(this.index)).toFixed(1)}px`;
  }

  /** The paths of nodes in the picture, made anew where the view or what is picked is another one. */
  paths(layer) {
    const { film, draw } = this, { camera, picked } = draw;
    const nodes = film ? film.moving.filter((node) => film.moving.length <= FEW_PATHS || picked.nodes.has(film.nodes[node])) : [];
    const key = `${camera.key};${nodes}`;
    if (key === this.key && layer.childElementCount === nodes.length) return;
    this.key = key;
    layer.replaceChildren(...nodes.map((node) => svg("path", { class: "path", d: `M${Array.from({ length: film.frames }, (_, k) => camera.project(film.position(k, node)).slice(0, 2).map((value) => value.toFixed(1)).join(" ")).join("L")}` })));
  }
}
