// What a page and its studio say to each other: one message on its way, one answer to each, until the studio is lost.

import { Busy } from "./busy.js";
import { el } from "./dom.js";

const AGAIN = 2000; // ms between attempts to reach a lost studio
const LOST = "The studio does not answer. Start it again, and open the address that it prints.";

/** Header and arrays of a binary message. */
export function opened(buffer) {
  const size = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, size)));
  return [header, new Uint8Array(buffer, 4 + size)];
}

/** What both pages of the studio have. A page says what it hears of (`heard`), and whether it shows anything (`there`). */
export class Talk {
  constructor(root) {
    Object.assign(this, { root, waiting: null, queue: [], wanted: null, closed: false });
    this.doing = el("p", { class: "busy", hidden: true });
    this.busy = new Busy((words) => this.showBusy(words));
  }

  // -- asking ------------------------------------------------------------------------------------------------------

  /** Ask for something; the promise holds the answer. since : when it was wished for, ms. */
  ask(command, since = performance.now()) {
    return new Promise((resolve) => {
      this.queue.push({ command, resolve, since });
      this.pump();
    });
  }

  /** Send the next message, if no answer is awaited, and say what takes long. */
  pump() {
    if (!this.waiting && !this.closed) {
      const next = this.hurried() || this.queue.shift() || this.leisurely();
      if (next) {
        this.waiting = { resolve: () => {}, since: performance.now(), ...next };
        this.post(JSON.stringify(next.sent || next.command));
      }
    }
    this.watch();
  }

  /** What goes before everything that was asked for: {command}. */
  hurried() {}

  /** What is asked for when there is nothing else. */
  leisurely() {}

  /** Say what is awaited. */
  watch() {
    const awaited = this.waiting || this.queue[0];
    if (awaited) this.busy.wait("Computing ...", awaited.since);
    else this.busy.end();
  }

  showBusy(words) {
    this.doing.hidden = !words;
    this.doing.textContent = words;
    this.root.classList.toggle("awaiting", Boolean(words));
  }

  // -- hearing -----------------------------------------------------------------------------------------------------

  async hear(data) {
    const answer = typeof data === "string" ? JSON.parse(data) : await this.unpacked(data);
    if (answer.kind === "failed") return this.fail(answer.message);
    if (answer.kind === "busy") {
      if (this.busy.words || !this.there) this.busy.say(answer.text);
      return;
    }
    if (this.heard(answer)) return this.pump(); // nobody here asked
    const { waiting } = this;
    this.waiting = null;
    if (answer.kind === "computing") { // asked for again, behind what else is asked for
      if (this.busy.words) this.busy.say(answer.text);
      this.queue.push({ ...waiting, sent: { do: "motion", number: answer.number } });
      return this.pump();
    }
    waiting?.resolve(answer);
    this.pump();
  }

  // -- begin and end -----------------------------------------------------------------------------------------------

  /** Over a websocket, again and again. */
  connect() {
    const key = this.page ? `&page=${this.page}` : "";
    const socket = new WebSocket(`${location.origin.replace(/^http/, "ws")}${location.pathname}live?busy=1${key}`); // told what an answer waits for
    socket.binaryType = "arraybuffer";
    socket.addEventListener("open", () => this.open((text) => socket.send(text)));
    socket.addEventListener("message", ({ data }) => this.hear(data));
    socket.addEventListener("close", () => this.close());
  }

  fail(message, ...more) {
    window.kinetruss.failed = message;
    this.closed = true;
    this.root.replaceChildren(el("div", { class: "failure" }, el("p", {}, message), ...more));
    this.root.dataset.state = "failed";
  }

  /** The studio is lost: what is shown stays, and nothing can be changed until it answers again. */
  close() {
    if (this.root.dataset.state === "failed") return;
    this.closed = true;
    for (const { resolve } of [this.waiting, ...this.queue].filter(Boolean)) resolve({ kind: "lost" });
    Object.assign(this, { waiting: null, queue: [], wanted: null });
    this.busy.end();
    if (!this.there) return this.fail(LOST);
    this.setEnded(true);
    setTimeout(() => this.connect(), AGAIN);
  }

  setEnded(ended, node = this.root) {
    node.classList.toggle("ended", ended);
    for (const field of node.querySelectorAll("input, select, button, textarea")) field.disabled = ended;
  }
}
