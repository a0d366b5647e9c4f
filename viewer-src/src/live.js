// The live page: a model that answers. One message out, one answer back; what is drawn is always a pose that was reached.

import { App } from "./app.js";
import { Controls } from "./controls.js";
import { el } from "./dom.js";
import { fromBase64, readScene } from "./scene.js";
import { opened, Talk } from "./talk.js";

const REST = 150; // ms after the last answer at which what takes longer is asked for
const SILENT = 2500; // ms after which a page that no kernel answers shows its still
const MANY = 40; // members above which that is needed

/** Connects the page to whoever serves it. */
export function startLive(root) {
  const live = new Live(root);
  window.kinetruss.live = live;
  if (root.dataset.live === "frame") throughFrame(live);
  else {
    live.store = `kinetruss ${location.pathname}`;
    const [how] = performance.getEntriesByType("navigation");
    if (how?.type === "reload") live.page = sessionStorage.getItem(live.store) || ""; // a copied tab begins anew
    live.connect();
  }
}

function throughFrame(live) {
  window.addEventListener("message", ({ source, data }) => {
    if (source === window.parent && source !== window && data?.kinetruss) live.hear(data.kinetruss);
  });
  window.parent.postMessage({ kinetruss: "{\"do\":\"show\"}" }, "*");
  setTimeout(() => live.still(), window.parent === window ? 0 : SILENT); // alone there is nobody to answer
  live.open((text) => window.parent.postMessage({ kinetruss: text }, "*"));
}

export class Live extends Talk {
  constructor(root) {
    super(root);
    Object.assign(this, { app: null, running: false, answers: 0, adopt: true, page: "" });
    this.controls = new Controls(this);
    root.ownerDocument.addEventListener("keydown", (event) => this.key(event));
  }

  get there() {
    return this.app;
  }

  /** Drives to new values; of many wishes while an answer is awaited only the last counts. */
  move(values) {
    this.wanted = { ...this.wanted, ...values };
    this.pump();
  }

  hurried() {
    if (!this.wanted) return null;
    this.sent = this.wanted;
    this.wanted = null;
    return { command: { do: "move", values: this.sent } };
  }

  /** Undo and redo; typing into a field stays typing. */
  key(event) {
    const command = { z: event.shiftKey ? "redo" : "undo", y: "redo" }[event.key.toLowerCase()];
    if (!command || !(event.ctrlKey || event.metaKey) || this.closed || !this.setup?.[command] || event.target.matches("input:not([type=range], [type=checkbox]), textarea")) return;
    event.preventDefault();
    this.ask({ do: command });
  }

  /** What is computed; the numbers of the pose before are dimmed. */
  showBusy(words) {
    super.showBusy(words);
    if (!this.app && this.root.dataset.state !== "failed") this.root.replaceChildren(words ? el("p", { class: "failure busy" }, words) : "");
  }

  // -- hearing -----------------------------------------------------------------------------------------------------

  heard({ kind, message }) {
    if (kind === "error" || kind === "saved") this.controls.tell(message, kind === "error");
    this.answers++;
    if (kind === "state" && !this.wanted && !this.queue.length) this.rest();
  }

  async unpacked(buffer) {
    const [header, body] = opened(buffer);
    if (header.kind === "state") this.place(header, body);
    else await this.stage(header, body);
    return header;
  }

  /** Nobody answers: show the pose that came with the page, as it is. */
  async still() {
    const [source] = document.querySelectorAll("script.kinetruss-scene");
    if (this.app || this.answers || !source) return;
    this.busy.end();
    this.app = new App(this.root, [await readScene(fromBase64(source.textContent))]);
    window.kinetruss.app = this.app;
    window.kinetruss.ready = true;
    this.root.dataset.state = "ready";
    this.app.stage.append(el("p", { class: "note" }, "A still: run the notebook to move it."));
  }

  rest() {
    clearTimeout(this.timer);
    if (this.setup.members.length <= MANY || this.fine) {
      this.fine = false;
      return;
    }
    this.timer = setTimeout(() => {
      this.fine = true;
      this.ask({ do: "move", values: {}, fine: true });
    }, REST);
  }

  /** A new picture: the live model, or a run of the key frames. */
  async stage(header, body) {
    const scene = await readScene(body);
    const running = header.kind === "run";
    if (!running) Object.assign(scene.header, { kind: "live", verdict: header.state.verdict });
    const before = this.app;
    before?.end();
    const app = new App(this.root, [scene], [], this.controls.node);
    app.stage.append(this.doing);
    if (before) {
      app.shown = before.shown;
      app.apply();
      app.views[0].sized = true;
      app.views[0].copyCamera(before.views[0]);
      app.views[0].controls.update();
      if (scene.channel(before.channel?.id)) app.setChannel(before.channel.id);
      if (before.picked && scene[`${before.picked.type}s`].includes(before.picked.name)) app.pick(before.picked);
    }
    Object.assign(this, { app, scene, running });
    window.kinetruss.app = app;
    app.onPick = () => this.controls.picked();
    if (!running) {
      this.setup = header.setup;
      this.controls.rebuild(header.setup);
      this.controls.update(header.state);
      if (this.adopt) this.begin(header.setup);
    }
    this.controls.running(running ? header : null);
    window.kinetruss.ready = true;
    this.root.dataset.state = "ready";
  }

  /** A new pose of the same picture. */
  place(header, body) {
    let at = body.byteOffset;
    for (const [name, count] of header.arrays) {
      const array = this.scene.arrays[name];
      if (array && array.data.length === count) array.data.set(new Float32Array(body.buffer, at, count));
      at += 4 * count;
    }
    if (!this.running) {
      this.scene.header.verdict = header.state.verdict;
      this.app.refresh();
    }
    this.controls.update(header.state);
  }

  // -- begin, end and begin again ------------------------------------------------------------------------------------

  open(post) {
    this.post = post;
    this.adopt = true;
    if (!this.app) this.busy.wait("Computing ...", performance.now());
  }

  /** Go on with the changes that a page of an earlier studio has left, or remove them. */
  draft(keep) {
    this.adopt = keep;
    return this.ask({ do: "draft", keep });
  }

  /** The first scene of a studio, or of changes that it has kept. */
  begin({ page, frames }) {
    const again = this.closed, same = page === this.page && page !== "";
    Object.assign(this, { adopt: false, closed: false, page });
    if (this.store) sessionStorage.setItem(this.store, page);
    if (frames.length || (again && same)) this.controls.frames.take(frames);
    if (!again) {
      if (same) this.controls.tell("The page was loaded again and goes on with its changes.");
      return;
    }
    this.setEnded(false);
    this.controls.history(this.setup);
    this.controls.frames.show();
    if (!same) this.controls.frames.keep();
    this.controls.tell(same ? "The studio answers again." : "The studio answers again, but it has kept no changes of this page: the model is that of the file.", !same);
  }

  // -- the end -----------------------------------------------------------------------------------------------------

  fail(message) {
    super.fail(message, this.store ? el("p", {}, el("a", { href: "draw/" }, "Go to the drawing")) : "");
  }

  close() {
    clearTimeout(this.timer);
    super.close();
    if (this.app) this.controls.tell("The studio has ended. The picture stays and cannot be changed. The changes are kept beside the file: start the studio of the same file again, and this page goes on with them.", true);
  }

  setEnded(ended) {
    super.setEnded(ended, this.controls.node);
  }
}
