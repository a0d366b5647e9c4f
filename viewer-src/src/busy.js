// What is said while an answer is awaited: as soon as it takes longer than a moment, and until it comes.

const SOON = 200; // ms after which an answer is said to be awaited
const LEAST = 40; // ms that every answer has

export class Busy {
  /** show(words): what is awaited; "" when it has come. */
  constructor(show) {
    Object.assign(this, { show, words: "", timer: 0 });
  }

  /** An answer is awaited that was asked for at `since`, ms. */
  wait(words, since) {
    const age = performance.now() - since;
    if (since === this.since || (this.words && age >= SOON)) return; // said already, or soon
    this.end();
    this.since = since;
    this.timer = setTimeout(() => this.say(words), Math.max(LEAST, SOON - age));
  }

  say(words) {
    clearTimeout(this.timer);
    this.words = words;
    this.show(words);
  }

  end() {
    clearTimeout(this.timer);
    this.since = null;
    if (this.words) this.say("");
  }
}
