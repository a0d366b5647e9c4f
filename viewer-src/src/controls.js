// What moves and changes a live model, left of its picture.

import { el, fill, section } from "./dom.js";
import { Changes } from "./changes.js";
import { Drives } from "./drives.js";
import { KeyFrames } from "./frames.js";
import { column, number, quantity } from "./format.js";

const WEAK = 0.05; // gauge below which a pose counts as near a singular one

export class Controls {
  constructor(live) {
    this.live = live;
    this.banner = el("p", { class: "banner", role: "status", hidden: true });
    this.offer = el("div", {});
    this.alarm = el("p", { class: "alarm", role: "alert", hidden: true });
    this.drives = new Drives(live);
    this.changes = new Changes(live);
    this.frames = new KeyFrames(live);
    this.gauge = el("meter", { min: 0, max: 1, low: WEAK, optimum: 1, value: 0, "aria-label": "distance from a singular pose" });
    this.gaugeText = el("output", {});
    this.mobility = el("pre", {});
    this.note = el("p", { class: "faint" });
    this.motors = el("table", { class: "numbers" });
    this.reactions = el("table", { class: "numbers" });
    this.file = el("input", { type: "text", "aria-label": "file name", size: 18 });
    this.pose = el("input", { type: "checkbox" });
    this.live_ = el("div", {}, this.drives.node, this.state(), this.changes.node);
    this.node = el("aside", { class: "controls", "aria-label": "controls" }, this.banner, this.offer, this.alarm, this.live_, this.frames.node, this.saving());
  }

  state() {
    this.motorSection = section("Motors, holding still", this.motors);
    this.reactionSection = section("Reactions", this.reactions);
    this.mobilitySection = section("Mobility", this.mobility);
    return el("div", {}, el("div", { class: "gauge" }, el("span", {}, "Singularity gauge"), this.gauge, this.gaugeText), this.note,
      this.reactionSection, this.motorSection, this.mobilitySection);
  }

  saving() {
    const save = () => this.save({ do: "save", name: this.file.value.trim(), pose: this.pose.checked, frames: this.frames.told() });
    this.saveSection = section("Save", el("div", { class: "row" }, this.file, el("button", { type: "button", onclick: save }, "Save")),
      el("label", {}, this.pose, " in this pose"),
      el("div", { class: "row" }, this.undo = this.button("Undo", "undo"), this.redo = this.button("Redo", "redo"), this.button("Back to the file's model", "reset"),
        this.live.root.dataset.live === "socket" ? el("a", { href: "draw/" }, "Draw: change the structure") : null));
    return this.saveSection;
  }

  button(words, name) {
    return el("button", { type: "button", onclick: () => this.live.ask({ do: name }) }, words);
  }

  /** Write the model; over another file only when that is confirmed. */
  async save(command) {
    const answer = await this.live.ask(command);
    if (answer.kind !== "exists") return;
    this.tell(answer.message, true);
    this.banner.append(" ", el("button", { type: "button", onclick: () => this.save({ ...command, replace: true }) }, "Overwrite"));
  }

  /** Another model: other drives, loads, members. */
  rebuild(setup) {
    this.setup = setup;
    this.drives.rebuild(setup);
    this.changes.rebuild(setup);
    if (!this.file.value) this.file.value = setup.file || "model.yaml";
    this.saveSection.hidden = !setup.writable;
    this.history(setup);
    this.setOffer(setup.offer);
    this.tell("");
  }

  history({ undo, redo }) {
    for (const [button, words] of [[this.undo, undo], [this.redo, redo]]) {
      button.disabled = !words;
      button.title = words && `${button.textContent} ${words}`;
    }
  }

  /** Changes that were not saved when their studio ended. when : s since 1970. */
  setOffer(when) {
    const answer = (words, keep) => el("button", { type: "button", onclick: () => this.live.draft(keep) }, words);
    fill(this.offer, when ? el("p", { class: "banner" }, `Changes of ${new Date(1000 * when).toLocaleString()} were not saved when their studio ended. They would take the place of what this page shows. `,
      answer("Go on with them", true), " ", answer("Remove them", false)) : null);
  }

  /** Another pose. */
  update(state) {
    this.last = state;
    this.drives.update(state);
    const known = state.gauge !== null;
    this.gauge.value = known ? state.gauge : 0;
    this.gaugeText.textContent = known ? `${number(state.gauge, 3)}${state.gauge < WEAK ? ": near a singular pose" : ""}` : "not known";
    if (state.mobility) this.mobility.textContent = state.mobility;
    this.mobilitySection.hidden = !this.mobility.textContent;
    this.note.textContent = state.note;
    this.tell(state.stopped, true);
    this.alarm.hidden = !state.alarms?.length;
    if (this.alarm.textContent !== (state.alarms || []).join(" ")) this.alarm.textContent = (state.alarms || []).join(" ");
    this.showMotors(state.demand);
    this.showReactions();
  }

  showMotors(demand) {
    this.motorSection.hidden = !demand?.length;
    if (!demand?.length || !this.motorSection.open) return;
    const shown = [["thrust", "N"], ["holding_torque", "N m"], ["breakaway_torque", "N m"], ["current", "A"]].filter(([key]) => key in demand[0]);
    const words = { thrust: "thrust", holding_torque: "hold", breakaway_torque: "start", current: "current" };
    const used = (row) => (row.max_current && row.current !== null ? el("small", { class: "unit" }, quantity(Math.abs(row.current) / row.max_current, "%")) : null);
    const columns = shown.map(([key, unit]) => column(demand.map((row) => row[key] ?? NaN), unit));
    fill(this.motors, el("tr", {}, el("th", {}, "drive"), shown.map(([key], j) => el("th", {}, words[key], el("small", { class: "unit" }, ` (${columns[j][1]})`)))),
      demand.map((row, k) => el("tr", {}, el("th", {}, row.name), shown.map(([key], j) => el("td", {}, columns[j][0][k], key === "current" ? used(row) : null)))));
  }

  showReactions() {
    const { scene, running } = this.live;
    if (running || !scene.has("reaction") || !this.reactionSection.open) return;
    const axes = [..."xyz"].slice(0, scene.dim);
    const names = scene.header.supported.slice(0, 200), all = names.flatMap((_, k) => scene.vector("reaction", 0, k).slice(0, scene.dim));
    const [texts, unit] = column(all, "N");
    fill(this.reactions, el("tr", {}, el("th", {}, "node"), axes.map((axis) => el("th", {}, `${axis} (${unit})`))),
      names.map((name, k) => el("tr", {}, el("th", {}, name), axes.map((_, i) => el("td", {}, texts[k * axes.length + i])))));
  }

  /** A picked member is the one that can be switched. */
  picked() {
    this.changes.picked(this.live.app.picked);
  }

  /** Whether a run is shown in place of the live model. */
  running(run) {
    this.live_.hidden = Boolean(run);
    if (run) this.alarm.hidden = true;
    this.frames.running(run);
    if (run?.note) this.tell(run.note, true);
  }

  /** A sentence above the controls, until the next one. */
  tell(words, warning = false) {
    this.banner.hidden = !words;
    this.banner.textContent = words;
    this.banner.classList.toggle("warning", warning);
  }
}
