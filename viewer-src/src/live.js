// The live page: a model that answers. One message out, one answer back; what is drawn is always a pose that was reached.

import { App } from "./app.js";
import { Busy } from "./busy.js";
import { Controls } from "./controls.js";
import { el } from "./dom.js";
import { fromBase64, readScene } from "./scene.js";

const REST = 150; // ms after the last answer at which what takes longer is asked for
const SILENT = 2500; // ms after which a page that no kernel answers shows its still
const MANY = 40; // members above which that is needed
const AGAIN = 2000; // ms between attempts to reach a lost studio

/** Connects the page to whoever serves it. */
export function startLive(root) {
  const live = new Live(root);
  window.kinetruss.live = live;
  if (root.dataset.live === "frame") throughFrame(live);
  else throughSocket(live);
}

function throughSocket(live) {
  const address = `${location.origin.replace(/^http/, "ws")}${location.pathname}live`;
  live.store = `kinetruss ${location.pathname}`;
  const [how] = performance.getEntriesByType("navigation");
  if (how?.type === "reload") live.page = sessionStorage.getItem(live.store) || ""; // a copied tab begins anew
  const connect = () => {
    const socket = new WebSocket(`${address}?busy=1${live.page ? `&page=${live.page}` : ""}`); // busy: told what an answer waits for
    socket.binaryType = "arraybuffer";
    socket.addEventListener("open", () => live.open((text) => socket.send(text)));
    socket.addEventListener("message", ({ data }) => live.hear(data));
    socket.addEventListener("close", () => live.close(connect));
  };
  connect();
}

function throughFrame(live) {
  window.addEventListener("message", ({ source, data }) => {
    if (source === window.parent && source !== window && data?.kinetruss) live.hear(data.kinetruss);
  });
  window.parent.postMessage({ kinetruss: "{\"do\":\"show\"}" }, "*");
  setTimeout(() => live.still(), window.parent === window ? 0 : SILENT); // alone there is nobody to answer
  live.open((text) => window.parent.postMessage({ kinetruss: text }, "*"));
}

/** Header and arrays of a binary message. */
export function opened(buffer) {
  const size = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, size)));
  return [header, new Uint8Array(buffer, 4 + size)];
}

export class Live {
  constructor(root) {
    Object.assign(this, { root, app: null, running: false, waiting: null, queue: [], wanted: null, answers: 0, closed: false, adopt: true, page: "" });
    this.controls = new Controls(this);
    this.doing = el("p", { class: "busy", hidden: true });
    this.busy = new Busy((words) => this.showBusy(words));
  }

  // -- asking ------------------------------------------------------------------------------------------------------

  /** Ask for something; the promise holds the header of the answer. */
  ask(command) {
    return new Promise((resolve) => {
      this.queue.push({ command, resolve, since: performance.now() });
      this.pump();
    });
  }

  /** Drives to new values; of many wishes while an answer is awaited only the last counts. */
  move(values) {
    this.wanted = { ...this.wanted, ...values };
    this.pump();
  }

  pump() {
    this.send();
    const awaited = this.waiting || this.queue[0];
    if (awaited) this.busy.wait("Computing ...", awaited.since);
    else this.busy.end();
  }

  /** What is computed; the numbers of the pose before are dimmed. */
  showBusy(words) {
    this.doing.hidden = !words;
    this.doing.textContent = words;
    this.root.classList.toggle("awaiting", Boolean(words));
    if (!this.app && this.root.dataset.state !== "failed") this.root.replaceChildren(words ? el("p", { class: "failure busy" }, words) : "");
  }

  send() {
    if (this.waiting || this.closed) return;
    if (this.wanted) {
      this.sent = this.wanted;
      this.waiting = { resolve: () => {}, since: performance.now() };
      this.post(JSON.stringify({ do: "move", values: this.wanted }));
      this.wanted = null;
    } else if (this.queue.length) {
      this.waiting = this.queue.shift();
      this.post(JSON.stringify(this.waiting.command));
    }
  }

  // -- hearing -----------------------------------------------------------------------------------------------------

  async hear(data) {
    const header = typeof data === "string" ? JSON.parse(data) : await this.take(data);
    if (header.kind === "busy") {
      if (this.busy.words || !this.app) this.busy.say(header.text);
      return;
    }
    if (header.kind === "failed") {
      this.fail(header.message);
      return;
    }
    if (header.kind === "error") this.controls.tell(header.message, true);
    if (header.kind === "saved") this.controls.tell(header.message, false);
    this.answers++;
    const { waiting } = this;
    this.waiting = null;
    waiting?.resolve(header);
    this.pump();
    if (header.kind === "state" && !this.waiting) this.rest();
  }

  async take(buffer) {
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
    this.controls.frames.show();
    if (!same) this.controls.frames.keep();
    this.controls.tell(same ? "The studio answers again." : "The studio answers again, but it has kept no changes of this page: the model is that of the file.", !same);
  }

  // -- the end -----------------------------------------------------------------------------------------------------

  fail(message) {
    window.kinetruss.failed = message;
    this.closed = true;
    const back = this.store && el("p", {}, el("a", { href: "draw/" }, "Go to the drawing"));
    this.root.replaceChildren(el("div", { class: "failure" }, el("p", {}, message), back || ""));
    this.root.dataset.state = "failed";
  }

  /** The studio is lost: the picture stays, and nothing can be changed until it answers again. */
  close(connect) {
    if (this.root.dataset.state === "failed") return;
    this.closed = true;
    for (const { resolve } of [this.waiting, ...this.queue].filter(Boolean)) resolve({ kind: "lost" });
    Object.assign(this, { waiting: null, queue: [], wanted: null });
    clearTimeout(this.timer);
    this.busy.end();
    if (!this.app) {
      this.fail("The studio does not answer. Start it again, and open the address that it prints.");
      return;
    }
    this.setEnded(true);
    this.controls.tell("The studio has ended. The picture stays and cannot be changed. The changes are kept beside the file: start the studio of the same file again, and this page goes on with them.", true);
    setTimeout(connect, AGAIN);
  }

  setEnded(ended) {
    this.controls.node.classList.toggle("ended", ended);
    for (const field of this.controls.node.querySelectorAll("input, select, button")) field.disabled = ended;
  }
}
