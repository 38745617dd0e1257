// The film of a run that goes on, and the readers of the files that it grows from: frames.bin and the
// tables, as doc/run_folder.md describes them.
import {arrowFactor, Film, kImpact, type Contact} from "./film";
import {clamp, type Pose, type Q4, type V3} from "./math";

const kPoseNumbers = 7, kContactNumbers = 11;
const kMostBytes = 300e6;  // of all frames; beyond that every second one of the older half goes

interface Frame { t: number; step: number; poses: Float32Array; contacts: Float32Array }

export class LiveFilm extends Film {
  readonly now: Float32Array;
  private frames: Frame[] = [];
  private times = new Float64Array(0);
  private bytes = 0;
  private marks = 0;

  constructor(readonly poses: number) {
    super();
    this.now = new Float32Array(kPoseNumbers * poses);
  }

  get count(): number { return this.frames.length; }
  get t(): Float64Array { return this.times; }
  get contactCount(): number { return this.marks; }

  append(frames: Frame[]): void {
    if (!frames.length) return;
    for (const f of frames) {
      this.frames.push(f);
      this.marks += f.contacts.length / kContactNumbers;
      this.bytes += 4 * (f.poses.length + f.contacts.length);
    }
    if (this.bytes > kMostBytes) this.thin();
    this.times = Float64Array.from(this.frames, f => f.t);
  }

  private thin(): void {
    const half = this.frames.length >> 1;
    this.frames = this.frames.filter((_, i) => i >= half || i % 2 === 0);
    this.bytes = this.frames.reduce((sum, f) => sum + 4 * (f.poses.length + f.contacts.length), 0);
    this.marks = this.frames.reduce((sum, f) => sum + f.contacts.length / kContactNumbers, 0);
  }

  private place(t: number): [Frame, Frame, number] {
    const i = this.indexAt(t), a = this.frames[i], b = this.frames[Math.min(i + 1, this.count - 1)];
    return [a, b, b.t > a.t ? clamp((t - a.t) / (b.t - a.t), 0, 1) : 0];
  }

  sample(t: number): Float32Array {
    if (!this.count) return this.now;
    for (let i = 0; i < this.poses; ++i) {
      const {r, q} = this.pose(i, t);
      this.now.set([...r, ...q], kPoseNumbers * i);
    }
    return this.now;
  }

  pose(i: number, t: number): Pose {
    if (i < 0 || !this.count) return {r: [0, 0, 0], q: [1, 0, 0, 0]};
    const place = this.place(t), [a, b] = place, at = kPoseNumbers * i;
    if (isAbsent(a.poses, at)) return {r: [0, 0, 0], q: [0, 0, 0, 0]};
    const share = isAbsent(b.poses, at) ? 0 : place[2];
    // quaternions of both signs are the same turn: the nearer one is taken
    let same = 0;
    for (let k = at + 3; k < at + 7; ++k) same += a.poses[k] * b.poses[k];
    const sign = same < 0 ? -1 : 1;
    const x = (k: number): number => a.poses[at + k] + ((k < 3 ? 1 : sign) * b.poses[at + k] - a.poses[at + k]) * share;
    const q: Q4 = [x(3), x(4), x(5), x(6)], size = Math.hypot(...q) || 1;
    return {r: [x(0), x(1), x(2)], q: q.map(e => e / size) as Q4};
  }

  protected comes(): boolean { return true; }

  /** What stands so far may move later. */
  moves(i: number): boolean { return i >= 0; }

  stands(i: number, k: number, value?: number): boolean {
    const at = kPoseNumbers * i + k, first = value ?? this.frames[0]?.poses[at] ?? 0;
    return this.frames.every(f => Math.abs(f.poses[at] - first) < 1e-6);
  }

  contacts(t: number): Contact[] {
    if (!this.count) return [];
    const {contacts, step} = this.frames[this.indexAt(t)];
    return Array.from({length: contacts.length / kContactNumbers}, (_, c) => contactIn(contacts, c, step));
  }

  contactAt(c: number): Contact {
    for (const {contacts, step} of this.frames) {
      const n = contacts.length / kContactNumbers;
      if (c < n) return contactIn(contacts, c, step);
      c -= n;
    }
    return {r: [0, 0, 0], n: [0, 0, 1], F: [0, 0, 0], state: 0, limit: 0, step: 0};
  }

  readonly knowsSteps = true;
  usualForce(): number { return this.latest(state => state !== kImpact); }
  usualImpact(): number { return this.latest(state => state === kImpact); }

  /** Of the last frames: what came long ago need not be looked at in every quarter of a second. */
  private latest(counts: (state: number) => boolean): number {
    const sizes: number[] = [];
    for (const {contacts, step} of this.frames.slice(-300)) {
      for (let c = 0; c < Math.min(contacts.length / kContactNumbers, 50); ++c) {
        const contact = contactIn(contacts, c, step), size = Math.hypot(...contact.F) * arrowFactor(contact);
        if (size > 0 && counts(contact.state)) sizes.push(size);
      }
    }
    sizes.sort((a, b) => a - b);
    return sizes.length ? sizes[Math.floor(0.9 * (sizes.length - 1))] : 0;
  }
}

function isAbsent(x: Float32Array, at: number): boolean {
  return x[at + 3] === 0 && x[at + 4] === 0 && x[at + 5] === 0 && x[at + 6] === 0;
}

function contactIn(x: Float32Array, c: number, step: number): Contact {
  const at = kContactNumbers * c, v = (k: number): V3 => [x[at + k], x[at + k + 1], x[at + k + 2]];
  return {r: v(0), n: v(3), F: v(6), state: x[at + 9], limit: x[at + 10], step};
}

/** Takes the bytes of frames.bin as they come and returns whole frames. */
export class FramesReader {
  private bytes = new Uint8Array(0);
  private poses = -1;

  take(more: Uint8Array): Frame[] {
    if (more.length) {
      const joined = new Uint8Array(this.bytes.length + more.length);
      joined.set(this.bytes);
      joined.set(more, this.bytes.length);
      this.bytes = joined;
    }
    const out: Frame[] = [], view = new DataView(this.bytes.buffer);
    let at = 0;
    if (this.poses < 0) {
      if (this.bytes.length < 24 || this.bytes.length < 28 + view.getUint32(20, true)) return out;
      this.poses = view.getUint32(16, true);
      at = 28 + view.getUint32(20, true);
    }
    while (this.bytes.length >= at + 40) {
      const size = Number(view.getBigUint64(at + 8, true)), begin = at + 40;
      if (this.bytes.length < begin + size) break;
      this.frames(view, begin, view.getUint32(at + 4, true), out);
      at = begin + size;
    }
    this.bytes = this.bytes.slice(at);
    return out;
  }

  private frames(view: DataView, at: number, count: number, out: Frame[]): void {
    const floats = (from: number, n: number): Float32Array => {
      const x = new Float32Array(n);
      for (let i = 0; i < n; ++i) x[i] = view.getFloat32(from + 4 * i, true);
      return x;
    };
    for (let f = 0; f < count; ++f) {
      const t = view.getFloat64(at, true), contacts = view.getUint32(at + 8, true), step = view.getFloat32(at + 12, true);
      const poses = kPoseNumbers * this.poses, marks = kContactNumbers * contacts;
      out.push({t, step, poses: floats(at + 16, poses), contacts: floats(at + 16 + 4 * poses, marks)});
      at += 16 + 4 * (poses + marks);
    }
  }
}

/** Takes the text of a table as it comes and returns its whole lines, without the first one. */
export class LinesReader {
  private text = "";
  private readonly decoder = new TextDecoder();
  head = "";

  take(more: Uint8Array): string[] {
    this.text += this.decoder.decode(more, {stream: true});
    const end = this.text.lastIndexOf("\n");
    if (end < 0) return [];
    const lines = this.text.slice(0, end).split("\n");
    this.text = this.text.slice(end + 1);
    if (!this.head) this.head = lines.shift() ?? "";
    return lines;
  }
}

/** A column of numbers that grows: thinned at 40 000, as the frames are. */
export class Growing<T extends Float64Array | Float32Array> {
  private filled = 0;
  private room: T;

  constructor(private readonly make: (n: number) => T) { this.room = make(256); }

  push(x: number): void {
    if (this.filled === this.room.length) {
      const larger = this.make(2 * this.room.length);
      larger.set(this.room);
      this.room = larger;
    }
    this.room[this.filled++] = x;
  }

  /** Keeps every second number of the first half. */
  thin(): void {
    const half = this.filled >> 1;
    let to = 0;
    for (let i = 0; i < this.filled; ++i) if (i >= half || i % 2 === 0) this.room[to++] = this.room[i];
    this.filled = to;
  }

  get length(): number { return this.filled; }
  get view(): T { return this.room.subarray(0, this.filled) as T; }
}
