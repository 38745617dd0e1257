// From the JSON of the page to numbers. Formats: doc/replay.md.
import {unzlibSync} from "fflate";
import {Film, type Contact} from "./film";
import {clamp, lastAtOrBefore, scaled, unit, type Pose, type Q4, type V3} from "./math";

export interface SceneShape {
  kind: string; name?: string; frame: number; position: V3; orientation: Q4; colour?: string;
  style?: string; radius?: number; halfLength?: number; halfExtents?: V3; points?: V3[]; frameEnd?: number;
  tube?: number; triangles?: V3[];
}
export interface Scene {
  view: string; follow?: number; frames: {name: string; place: string}[]; shapes: SceneShape[];
}
export interface PageData {
  title: string; model: {name: string; text: string}; run: Record<string, unknown> | null; scene: string;
  frames: {
    count: number; recorded: number; poses: number; placeSteps: number; turnSteps: number; t: string; steps?: string; ranges: string;
    orders: string; data: string;
    contacts: {box: number[]; placeSteps: number; turnSteps: number; octaveSteps: number; counts: string; data: string};
  };
  signals: {name: string; unit: string; t?: string; y: string}[];
  events: string; ledger: string;
}
export interface Signal { name: string; unit: string; t: Float64Array; y: Float32Array }
export interface Event {
  t: number; impact: boolean; system: string; contact: string; from: string; to: string; speed: number; impulse: number;
  brief?: boolean;  // a switch that is taken back within a step
  run?: string; other?: boolean;  // where two runs are shown: the name of its run, and whether that is the second
}

/** The bytes behind a base64 text of zlib data. The browser's own inflater is faster by far. */
async function inflated(base64: string): Promise<Uint8Array> {
  if (!base64) return new Uint8Array(0);
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  if (typeof DecompressionStream === "undefined") return unzlibSync(bytes);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const viewOf = (b: Uint8Array): DataView => new DataView(b.buffer, b.byteOffset, b.byteLength);

async function doubles(base64: string): Promise<Float64Array> {
  const view = viewOf(await inflated(base64));
  return Float64Array.from({length: view.byteLength / 8}, (_, i) => view.getFloat64(8 * i, true));
}
async function floats(base64: string): Promise<Float32Array> {
  const view = viewOf(await inflated(base64));
  return Float32Array.from({length: view.byteLength / 4}, (_, i) => view.getFloat32(4 * i, true));
}

/** Columns of u16 from planes of low and high bytes; written to out[f · columns + v]. */
function unfold(bytes: Uint8Array, columns: number, count: number, orders: ArrayLike<number>): Uint16Array {
  const out = new Uint16Array(columns * count), high = columns * count;
  for (let v = 0; v < columns; ++v) {
    let a = 0, b = 0;
    const order = orders[v];
    for (let f = 0, at = v * count; f < count; ++f, ++at) {
      const z = bytes[at] | bytes[high + at] << 8;
      const e = (z >> 1) ^ -(z & 1);
      if (f === 1) b = a;
      const c = (e + (order === 0 ? 0 : order === 1 ? a : 2 * a - b)) & 0xffff;
      out[f * columns + v] = c;
      b = a;
      a = c;
    }
  }
  return out;
}

const kContactColumns = 12, kNone = -32768;
/** 2^(x / steps); nothing is 0. */
const power = (x: number, steps: number): number => x === kNone ? 0 : 2 ** (x / steps);

/** The film of a page: all frames are there, in coded form. */
export class RecordedFilm extends Film {
  readonly count: number;
  readonly varying: Int32Array;  // coordinate 7 i + k → its column, or −1
  readonly now: Float32Array;    // poses at the time of sample()
  private readonly step: Float32Array;
  private readonly coming = new Set<number>();  // bodies that are absent in some frame
  private readonly firstContact: Uint32Array;

  private constructor(
      readonly poses: number, readonly t: Float64Array, readonly lo: Float32Array, hi: Float32Array,
      private readonly course: Uint16Array, counts: Uint32Array, private readonly contact: Int16Array,
      private readonly steps: Float32Array, private readonly coding: PageData["frames"]) {
    super();
    this.count = t.length;
    this.now = new Float32Array(7 * poses);
    this.varying = new Int32Array(7 * poses).fill(-1);
    this.step = new Float32Array(7 * poses);
    this.columns = 0;
    for (let k = 0; k < 7 * poses; ++k) {
      if (!(lo[k] < hi[k])) continue;
      this.varying[k] = this.columns++;
      this.step[k] = (hi[k] - lo[k]) / (k % 7 < 3 ? coding.placeSteps : coding.turnSteps);
    }
    for (let i = 0; i < poses; ++i) if (this.count && this.isAbsentAnywhere(i)) this.coming.add(i);
    this.firstContact = new Uint32Array(counts.length + 1);
    for (let f = 0; f < counts.length; ++f) this.firstContact[f + 1] = this.firstContact[f] + counts[f];
  }
  private readonly columns: number;

  static async from(frames: PageData["frames"]): Promise<RecordedFilm> {
    const [t, steps, ranges, orders, data, counts, contact] = await Promise.all([
      doubles(frames.t), floats(frames.steps ?? ""), floats(frames.ranges), inflated(frames.orders), inflated(frames.data),
      inflated(frames.contacts.counts), inflated(frames.contacts.data)]);
    const part = (odd: number): Float32Array => ranges.filter((_, i) => i % 2 === odd);
    const course = unfold(data, orders.length, t.length, orders);
    const view = viewOf(counts);
    const n = Uint32Array.from({length: view.byteLength / 4}, (_, i) => view.getUint32(4 * i, true));
    const marks = unfold(contact, kContactColumns, contact.length / 2 / kContactColumns, new Uint8Array(kContactColumns));
    return new RecordedFilm(frames.poses, t, part(0), part(1), course, n, new Int16Array(marks.buffer), steps, frames);
  }

  get contactCount(): number { return this.contact.length / kContactColumns; }

  private place(t: number): [number, number, number] {
    const f = this.indexAt(t), next = Math.min(f + 1, this.count - 1);
    const share = next > f ? clamp((t - this.t[f]) / (this.t[next] - this.t[f]), 0, 1) : 0;
    return [f * this.columns, next * this.columns, share];
  }

  protected comes(i: number): boolean { return this.coming.has(i); }

  /** The quaternion of an absent body is 0; the steps of the coding leave less than a tenth of it. */
  private isAbsent(i: number, row: number): boolean {
    let size = 0;
    for (let k = 7 * i + 3; k < 7 * i + 7; ++k) {
      const v = this.varying[k];
      size += (v < 0 ? this.lo[k] : this.lo[k] + this.step[k] * this.course[row + v]) ** 2;
    }
    return size < 0.25;
  }

  private isAbsentAnywhere(i: number): boolean {
    for (let k = 7 * i + 3; k < 7 * i + 7; ++k) {  // 0 lies in the range of each component, or it is never absent
      const hair = this.step[k], hi = this.lo[k] + 65536 * this.step[k];
      if (this.lo[k] > hair || hi < -hair) return false;
    }
    for (let f = 0; f < this.count; ++f) if (this.isAbsent(i, f * this.columns)) return true;
    return false;
  }

  /** Fills `now` with all poses at t, straight between frames. */
  sample(t: number): Float32Array {
    if (!this.count) return this.now;
    const [a, b, share] = this.place(t), {now, varying, lo, step, course} = this;
    for (let k = 0; k < now.length; ++k) {
      const v = varying[k];
      now[k] = v < 0 ? lo[k] : lo[k] + step[k] * (course[a + v] + (course[b + v] - course[a + v]) * share);
    }
    for (const i of this.coming) {
      const {r, q} = this.pose(i, t);
      now.set([...r, ...q], 7 * i);
    }
    for (let k = 3; k < now.length; k += 7) {
      const size = Math.sqrt(now[k] ** 2 + now[k + 1] ** 2 + now[k + 2] ** 2 + now[k + 3] ** 2) || 1;
      for (let i = k; i < k + 4; ++i) now[i] /= size;
    }
    return now;
  }

  /** Pose i at time t; the inertial frame is −1. */
  pose(i: number, t: number): Pose {
    if (i < 0 || !this.count) return {r: [0, 0, 0], q: [1, 0, 0, 0]};
    const place = this.place(t), [a, b] = place;
    let share = place[2];
    if (this.coming.has(i)) {  // from and to a place where it is not nothing moves
      if (this.isAbsent(i, a)) return {r: [0, 0, 0], q: [0, 0, 0, 0]};
      if (this.isAbsent(i, b)) share = 0;
    }
    const at = (k: number): number => {
      const v = this.varying[7 * i + k], lo = this.lo[7 * i + k];
      if (v < 0) return lo;
      return lo + this.step[7 * i + k] * (this.course[a + v] + (this.course[b + v] - this.course[a + v]) * share);
    };
    const q: Q4 = [at(3), at(4), at(5), at(6)];
    const size = Math.hypot(...q) || 1;
    return {r: [at(0), at(1), at(2)], q: q.map(x => x / size) as Q4};
  }

  moves(i: number): boolean { return i >= 0 && [0, 1, 2, 3, 4, 5, 6].some(k => this.varying[7 * i + k] >= 0); }
  /** Whether coordinate k of pose i stands, at `value` if one is given. */
  stands(i: number, k: number, value?: number): boolean {
    const at = 7 * i + k;
    return this.varying[at] < 0 && (value === undefined || Math.abs(this.lo[at] - value) < 1e-6);
  }
  /** Contacts of the last frame at or before t. */
  contacts(t: number): Contact[] {
    const out: Contact[] = [];
    if (!this.count) return out;
    const f = this.indexAt(t);
    for (let c = this.firstContact[f]; c < this.firstContact[f + 1]; ++c) out.push(this.decoded(c, f));
    return out;
  }

  get knowsSteps(): boolean { return this.steps.some(dt => dt > 0); }

  contactAt(c: number): Contact { return this.decoded(c, lastAtOrBefore(this.firstContact, c)); }

  /** Contact number c, of frame f. */
  private decoded(c: number, f: number): Contact {
    const x = this.contact.subarray(kContactColumns * c, kContactColumns * (c + 1));
    const {box, placeSteps, octaveSteps} = this.coding.contacts;
    const at = (k: number): number => box[2 * k] + (box[2 * k + 1] - box[2 * k]) * (x[k] & 0xffff) / placeSteps;
    const n = unit([x[3], x[4], x[5]]), e = unit([x[3] + x[7], x[4] + x[8], x[5] + x[9]]);
    const size = power(x[6], octaveSteps), limit = power(x[11], octaveSteps) * (size || 1);
    return {r: [at(0), at(1), at(2)], n, F: scaled(e, size), state: x[10], limit, step: this.steps[f] ?? 0};
  }
}

export async function sceneOf(data: PageData): Promise<Scene> {
  return JSON.parse(new TextDecoder().decode(await inflated(data.scene))) as Scene;
}

export async function signalsOf(data: PageData): Promise<Signal[]> {
  const units = new Map<string, string>();
  const listed = data.run && Array.isArray(data.run.signals) ? data.run.signals as {name: string; unit: string}[] : [];
  for (const s of listed) units.set(s.name, s.unit);
  const times = await Promise.all(data.signals.map(s => s.t === undefined ? null : doubles(s.t)));
  const values = await Promise.all(data.signals.map(s => floats(s.y)));
  let t: Float64Array = new Float64Array(0);
  return data.signals.map((s, i) => {
    t = times[i] ?? t;
    return {name: s.name, unit: s.unit || units.get(s.name) || "", t, y: values[i]};
  });
}

/** Fields of a line of CSV; quoted ones may hold commas, not line ends. */
const fieldsOf = (line: string): string[] =>
  (line.includes('"') ? line.match(/("([^"]|"")*"|[^,]*)(,|$)/g) ?? [] : line.split(","))
    .map(x => x.replace(/,$/, "").replace(/^"(.*)"$/, "$1").replace(/""/g, '"'));

async function rowsOf(base64: string): Promise<string[][]> {
  const text = new TextDecoder().decode(await inflated(base64));
  return text.split("\n").filter(line => line).map(fieldsOf);
}

const eventOf = (r: string[]): Event => ({
  t: Number(r[0]), impact: r[1] === "impact", system: r[1] === "impact" || r[1] === "switch" ? "" : r[1], contact: r[2],
  from: r[3], to: r[4], speed: Number(r[5]), impulse: Number(r[6])});
export const eventIn = (line: string): Event => eventOf(fieldsOf(line));

export async function eventsOf(data: PageData): Promise<Event[]> {
  const rows = await rowsOf(data.events), settings = data.run?.settings as {step?: number} | undefined;
  const events = rows.slice(1).filter(r => r.length >= 7).map(eventOf);
  for (const e of flickers(events, 1.5 * (settings?.step ?? 0))) e.brief = true;
  return events;
}

/** Switches that are taken back at once: a gap of rounding size opens and closes again. */
function flickers(events: Event[], brief: number): Set<Event> {
  const last = new Map<string, Event>(), gone = new Set<Event>();
  for (const e of events) {
    const before = last.get(e.contact);
    if (before && !e.system && !e.impact && !before.impact && !gone.has(before) && e.t - before.t <= brief && before.from === e.to &&
        before.to === e.from) {
      gone.add(before).add(e);
    }
    last.set(e.contact, e);
  }
  return gone;
}

/** Columns of ledger.csv by name, with t. */
export async function ledgerOf(data: PageData): Promise<Map<string, Float64Array>> {
  const rows = await rowsOf(data.ledger), out = new Map<string, Float64Array>();
  if (rows.length < 2) return out;
  const whole = rows.slice(1).filter(r => r.length === rows[0].length);
  rows[0].forEach((name, i) => out.set(name, Float64Array.from(whole, r => Number(r[i]))));
  return out;
}
