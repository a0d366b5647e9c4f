// Reads a scene: the bytes of kinetruss.viewer.pack. The form is described in docs/viewer.md.

import { BeamCurves } from "./beams.js";
import { sampleAt } from "./player.js";

const MAGIC = "KTSCENE1";
const FORMAT = "kinetruss.scene";
const VERSION = 1;

/** Bytes of base64 text, in one pass of the browser's own decoder. */
export function fromBase64(text) {
  const raw = atob(text.trim());
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

async function inflate(bytes) {
  // written to directly: a blob of some megabytes cannot be read in a page opened from a file
  const { readable, writable } = new DecompressionStream("deflate");
  const writer = writable.getWriter();
  const written = writer.write(bytes).then(() => writer.close());
  const [buffer] = await Promise.all([new Response(readable).arrayBuffer(), written]);
  return new Uint8Array(buffer);
}

/** The scene in some bytes; throws an Error with a sentence where there is none. */
export async function readScene(bytes) {
  const magic = String.fromCharCode(...bytes.subarray(0, MAGIC.length));
  if (magic !== MAGIC) throw new Error("These bytes are no kinetruss scene.");
  const begin = MAGIC.length + 4;
  const end = begin + new DataView(bytes.buffer, bytes.byteOffset).getUint32(MAGIC.length, true);
  const [first, second] = await Promise.all([inflate(bytes.subarray(begin, end)), inflate(bytes.subarray(end))]);
  const start = 4 + new DataView(first.buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(first.subarray(4, start)));
  if (header.format !== FORMAT || header.version !== VERSION) {
    throw new Error(`Scene version ${header.version} is not known to this viewer, which reads ${VERSION}.`);
  }
  const arrays = {};
  for (const [name, entry] of Object.entries(header.arrays)) {
    const data = entry.form === "plain" ? readPlain(first, start, entry) : readHistory(second, entry);
    arrays[name] = { shape: entry.shape, data };
  }
  return new Scene(header, arrays);
}

const countOf = (entry) => entry.shape.reduce((a, b) => a * b, 1);

function readPlain(body, start, entry) {
  const at = start + entry.at;
  const { buffer } = body.slice(at, at + 4 * countOf(entry));
  return entry.type === "int32" ? new Int32Array(buffer) : new Float32Array(buffer);
}

function readHistory(body, entry) {
  const count = countOf(entry), columns = count / entry.shape[0];
  return entry.form === "float32" ? readFloats(body, entry.at, count, columns) : readRounded(body, entry, count, columns);
}

function readFloats(body, at, count, columns) {
  const words = new Uint32Array(count);
  const b = at + count, c = b + count, d = c + count;
  for (let i = 0; i < count; i++) {
    words[i] = body[at + i] | (body[b + i] << 8) | (body[c + i] << 16) | (body[d + i] << 24);
    if (i >= columns) words[i] += words[i - columns];
  }
  return new Float32Array(words.buffer);
}

function readRounded(body, { at, order }, count, columns) {
  const steps = Float64Array.from(new Int8Array(body.slice(at, at + columns).buffer), (exponent) => 2 ** exponent);
  const base = new Int32Array(body.slice(at + columns, at + 5 * columns).buffer);
  const low = at + 5 * columns, high = low + count;
  const values = new Float32Array(count);
  // sums[0] are the values themselves, sums[k] their k-th differences; all wrap at 2^16
  const sums = Array.from({ length: order }, () => new Uint16Array(columns));
  for (let i = 0, j = 0, row = 0; i < count; i++) {
    const coded = body[low + i] | (body[high + i] << 8);
    let change = (coded >>> 1) ^ -(coded & 1);
    for (let k = Math.min(order - 1, row); k >= 0; k--) change = sums[k][j] += change;
    values[i] = (sums[0][j] + base[j]) * steps[j];
    if (++j === columns) {
      j = 0;
      row++;
    }
  }
  return values;
}

/** A scene with the questions that the page asks of it. */
export class Scene {
  constructor(header, arrays) {
    Object.assign(this, { header, arrays, stored: { ...arrays }, cases: header.cases.map((one) => one.load_case) });
    this.time = arrays.time.data;
    this.frames = this.time.length;
    this.dim = header.dim;
    this.nodes = header.nodes;
    this.members = header.members;
    this.ends = arrays.ends.data;
    this.active = new Set(header.two_rods);
    this.directors = new Set(header.directors || []);
    this.partsOf = this.members.map(() => []);
    arrays.part_member.data.forEach((member, part) => this.partsOf[member].push(part));
    this.curves = new BeamCurves(this);
    this.skin = arrays.skin ? arrays.skin.data : new Int32Array(0);
    this.faces = this.skin.length / 3;
    this.extent = extentOf(arrays.position.data, this.dim);
    this.length0 = typicalLength(this);
    this.ranges = {};
    this.kept = {};
    this.sure();
  }

  /** Whether pictures show a member: bars of the frames of beams are left out. */
  shows(member) {
    return this.header.kinds[member] !== "frame";
  }

  /** Members whose force is not unique. */
  sure() {
    this.unsure = new Set((this.header.not_unique || []).map((name) => this.members.indexOf(name)).filter((k) => k >= 0));
  }

  /** Arrays changed in place: ranges only widen, so that colours do not jump. */
  renew() {
    Object.assign(this.kept, this.ranges);
    this.ranges = {};
  }

  /** Let one load case be the one that all questions are about; false where it is not there. */
  choose(name) {
    const k = this.cases.indexOf(name);
    if (k < 0) return false;
    Object.assign(this.header, this.header.cases[k]);
    for (const entry of Object.keys(this.stored)) {
      const own = this.stored[`${k}:${entry}`];
      this.arrays[entry] = own || this.stored[entry];
    }
    this.ranges = {};
    this.kept = {};
    this.sure();
    return true;
  }

  /** Whether some rule of some member was not checked at all: a value is missing. */
  get unchecked() {
    return ["utilisation", "buckling"].some((name) => this.has(name) && this.arrays[name].data.some((value, k) => Number.isNaN(value) && this.shows(k % this.members.length)));
  }

  has(name) {
    return name in this.arrays;
  }

  /** Vector of a history at (frame, row), three components. */
  vector(name, frame, row) {
    const { data, shape } = this.arrays[name];
    const dim = this.dim, at = (frame * shape[1] + row) * dim;
    return [data[at], data[at + 1], dim === 3 ? data[at + 2] : 0];
  }

  position(frame, node) {
    return this.vector("position", frame, node);
  }

  /** Where a load acts: its node, or a place between nodes; `point` gives that of a node. */
  placeOfLoad(load, point) {
    if (!load.at) return point(load.node);
    return [0, 1, 2].map((i) => load.at.reduce((sum, [node, factor]) => sum + factor * point(node)[i], 0));
  }

  /** Force on a member at its end 0 (A) or 1 (B), where the scene has it. */
  jointForce(frame, member, end) {
    const { data } = this.arrays.joint_force;
    const dim = this.dim, at = ((frame * this.members.length + member) * 2 + end) * dim;
    return [data[at], data[at + 1], dim === 3 ? data[at + 2] : 0];
  }

  /** What action k is worth as a force at end 0 (A) or 1 (B) of its member. */
  actionForce(frame, k, end) {
    const { data, shape } = this.arrays.action_force;
    const dim = this.dim, at = ((frame * shape[1] + k) * 2 + end) * dim;
    return [data[at], data[at + 1], dim === 3 ? data[at + 2] : 0];
  }

  /** Entry of (frames, columns). */
  number(name, frame, column) {
    const { data, shape } = this.arrays[name];
    return shape.length === 1 ? data[column] : data[frame * shape[1] + column];
  }

  channel(id) {
    return this.header.channels.find((one) => one.id === id);
  }

  /** What a channel says of a member now. */
  value(id, frame, member) {
    if (id === "length") return this.length(frame, member);
    const channel = this.channel(id);
    if (!channel) return NaN;
    if (channel.array) return this.has(channel.array) ? this.number(channel.array, frame, member) : NaN;
    return this.memberSpeed(frame, member);
  }

  /** The same as it is read: what is round-off of the largest value of all is 0. */
  plainValue(id, frame, member) {
    const value = this.value(id, frame, member);
    if (!this.channel(id)) return value;
    const [low, high] = this.range(id);
    return Math.abs(value) < 1e-12 * Math.max(Math.abs(low), Math.abs(high)) ? 0 : value;
  }

  /** Whether a channel has values of the faces of membranes and solids. */
  coloursFaces(id) {
    return this.has(this.channel(id)?.faces);
  }

  /** What a channel says of a face now. */
  faceValue(id, frame, face) {
    return this.number(this.channel(id).faces, frame, face);
  }

  memberSpeed(frame, member) {
    const a = this.vector("velocity", frame, this.ends[2 * member]);
    const b = this.vector("velocity", frame, this.ends[2 * member + 1]);
    return Math.hypot(a[0] + b[0], a[1] + b[1], a[2] + b[2]) / 2;
  }

  length(frame, member) {
    const a = this.position(frame, this.ends[2 * member]), b = this.position(frame, this.ends[2 * member + 1]);
    return Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }

  /** Least and largest value of a channel over all frames and members. */
  range(id) {
    if (!(id in this.ranges)) {
      let [low, high] = this.kept[id] || [Infinity, -Infinity];
      const channel = this.channel(id);
      const frames = channel && channel.array && this.arrays[channel.array]?.shape.length === 1 ? 1 : this.frames;
      const meet = (value) => {
        if (value < low) low = value;
        if (value > high && Number.isFinite(value)) high = value;
      };
      for (let k = 0; k < frames; k++) for (let m = 0; m < this.members.length; m++) if (this.shows(m)) meet(this.value(id, k, m));
      if (this.coloursFaces(id)) this.arrays[channel.faces].data.forEach(meet);
      this.ranges[id] = low <= high ? [low, high] : [0, 0];
    }
    return this.ranges[id];
  }

  /** The frame nearest to a time. */
  frameAt(time) {
    return sampleAt(this.time, time);
  }
}

function extentOf(data, dim) {
  const low = [Infinity, Infinity, dim === 3 ? Infinity : 0], high = [-Infinity, -Infinity, dim === 3 ? -Infinity : 0];
  for (let i = 0; i < data.length; i++) {
    const axis = i % dim;
    if (data[i] < low[axis]) low[axis] = data[i];
    if (data[i] > high[axis]) high[axis] = data[i];
  }
  const centre = low.map((value, axis) => (value + high[axis]) / 2);
  const size = Math.hypot(...high.map((value, axis) => value - low[axis])) || 1;
  return { low, high, centre, size };
}

function typicalLength(scene) {
  const seen = scene.members.map((_, member) => member).filter((member) => scene.shows(member));
  const lengths = seen.map((member) => scene.length(0, member)).sort((a, b) => a - b);
  return lengths[lengths.length >> 1] || scene.extent.size / 4;
}
