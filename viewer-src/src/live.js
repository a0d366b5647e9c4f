// The live page: a model that answers. One message out, one answer back; what is drawn is always a pose that was reached.

import { App } from "./app.js";
import { Controls } from "./controls.js";
import { el } from "./dom.js";
import { fromBase64, readScene } from "./scene.js";

const REST = 150; // ms after the last answer at which what takes longer is asked for
const SILENT = 2500; // ms after which a page that no kernel answers shows its still
const MANY = 40; // members above which that is needed

/** Connects the page to whoever serves it. */
export function startLive(root) {
  const live = new Live(root);
  window.kinetruss.live = live;
  const { post } = root.dataset.live === "frame" ? throughFrame(live) : throughSocket(live);
  live.post = post;
}

function throughSocket(live) {
  const address = `${location.origin.replace(/^http/, "ws")}${location.pathname}live`;
  const socket = new WebSocket(address);
  socket.binaryType = "arraybuffer";
  socket.addEventListener("message", ({ data }) => live.hear(data));
  socket.addEventListener("close", () => live.close());
  return { post: (text) => socket.send(text) };
}

function throughFrame(live) {
  window.addEventListener("message", ({ source, data }) => {
    if (source === window.parent && source !== window && data?.kinetruss) live.hear(data.kinetruss);
  });
  window.parent.postMessage({ kinetruss: "{\"do\":\"live\"}" }, "*");
  setTimeout(() => live.still(), window.parent === window ? 0 : SILENT); // alone there is nobody to answer
  return { post: (text) => window.parent.postMessage({ kinetruss: text }, "*") };
}

/** Header and arrays of a binary message. */
export function opened(buffer) {
  const size = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, size)));
  return [header, new Uint8Array(buffer, 4 + size)];
}

export class Live {
  constructor(root) {
    Object.assign(this, { root, app: null, running: false, waiting: null, queue: [], wanted: null, answers: 0, closed: false });
    this.controls = new Controls(this);
  }

  // -- asking ------------------------------------------------------------------------------------------------------

  /** Ask for something; the promise holds the header of the answer. */
  ask(command) {
    return new Promise((resolve) => {
      this.queue.push({ command, resolve });
      this.pump();
    });
  }

  /** Drives to new values; of many wishes while an answer is awaited only the last counts. */
  move(values) {
    this.wanted = { ...this.wanted, ...values };
    this.pump();
  }

  pump() {
    if (this.waiting || this.closed) return;
    if (this.wanted) {
      this.sent = this.wanted;
      this.waiting = { resolve: () => {} };
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

  // -- the end -----------------------------------------------------------------------------------------------------

  fail(message) {
    window.kinetruss.failed = message;
    this.closed = true;
    this.root.textContent = message;
    this.root.dataset.state = "failed";
  }

  close() {
    if (this.closed) return;
    this.closed = true;
    if (!this.app) this.fail("The studio does not answer. Start it again, and open the address that it prints.");
    else this.controls.tell("The studio has ended. The picture stays; what was not saved is lost. Start the studio again and open the address that it prints: each start has a new one.", true);
    this.controls.node.classList.add("ended");
    for (const field of this.controls.node.querySelectorAll("input, select, button")) field.disabled = true;
  }
}
