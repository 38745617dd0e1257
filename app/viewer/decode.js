// decode.js: from the JSON of the page to numbers. Formats: doc/run_folder.md.

/** The bytes of a base64 text as an ArrayBuffer. */
function bytesOf(base64) {
  const text = atob(base64 || "");
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

/** Little-endian numbers of one kind: "Float64" (8 bytes), "Float32", "Uint32" (4), "Uint16" (2). */
function numbersOf(base64, kind, size) {
  const view = new DataView(bytesOf(base64));
  const out = new globalThis[kind + "Array"](view.byteLength / size);
  for (let i = 0; i < out.length; ++i) out[i] = view["get" + kind](i * size, true);
  return out;
}

/** Poses and contacts of all frames: t [s], pose(i, t), contacts(t). */
class Film {
  constructor(frames) {
    this.t = numbersOf(frames.t, "Float64", 8);
    this.count = this.t.length;
    this.poses = frames.poses;
    const ranges = numbersOf(frames.ranges, "Float32", 4);
    const data = numbersOf(frames.data, "Uint16", 2);
    this.lo = [];
    this.hi = [];
    this.course = [];  // of each coordinate: its 16-bit numbers, or null if it never changes
    let at = 0;
    for (let k = 0; k < 7 * this.poses; ++k) {
      this.lo.push(ranges[2 * k]);
      this.hi.push(ranges[2 * k + 1]);
      const varies = ranges[2 * k] < ranges[2 * k + 1];
      this.course.push(varies ? data.subarray(at, at + this.count) : null);
      if (varies) at += this.count;
    }
    this.box = frames.contacts.box;
    this.firstContact = numbersOf(frames.contacts.first, "Uint32", 4);
    this.contact = numbersOf(frames.contacts.data, "Uint16", 2);
  }

  get begin() { return this.count ? this.t[0] : 0; }
  get end() { return this.count ? this.t[this.count - 1] : 0; }

  /** Index of the last frame at or before t. */
  indexAt(t) { return lastAtOrBefore(this.t, t); }

  coordinate(k, f, share) {
    const course = this.course[k];
    if (!course) return this.lo[k];
    const a = course[f], b = course[Math.min(f + 1, this.count - 1)];
    return this.lo[k] + (this.hi[k] - this.lo[k]) * (a + (b - a) * share) / 65535;
  }

  /** Pose i at time t, straight between frames: {r: [x, y, z], q: [w, x, y, z]}. */
  pose(i, t) {
    if (i < 0 || !this.count) return kRest;
    const f = this.indexAt(t);
    const next = Math.min(f + 1, this.count - 1);
    const share = next > f ? clamp((t - this.t[f]) / (this.t[next] - this.t[f]), 0, 1) : 0;
    const at = k => this.coordinate(7 * i + k, f, share);
    const q = [at(3), at(4), at(5), at(6)];
    const norm = Math.hypot(...q) || 1;
    return {r: [at(0), at(1), at(2)], q: q.map(x => x / norm)};
  }

  /** Whether pose i ever changes; the inertial frame (−1) does not. */
  moves(i) { return i >= 0 && [0, 1, 2, 3, 4, 5, 6].some(k => this.course[7 * i + k]); }

  firstMoving() {
    for (let i = 0; i < this.poses; ++i) if (this.moves(i)) return i;
    return -1;
  }

  /** Contacts of the last frame at or before t: [{r, n, F, state}]. */
  contacts(t) {
    const out = [];
    if (!this.count) return out;
    const f = this.indexAt(t);
    for (let c = this.firstContact[f]; c < this.firstContact[f + 1]; ++c) out.push(this.contactAt(c));
    return out;
  }

  contactAt(c) {
    const x = this.contact.subarray(10 * c, 10 * c + 10);
    const r = [0, 1, 2].map(k =>
      this.box[2 * k] + (this.box[2 * k + 1] - this.box[2 * k]) * x[k] / 65535);
    const n = [3, 4, 5].map(k => 2 * x[k] / 65535 - 1);
    const F = [6, 7, 8].map(k => upperHalfFloat(x[k]));
    return {r, n, F, state: x[9]};
  }

  /** A force that most contacts stay below: nine of ten of those that are not zero. */
  usualForce() {
    const sizes = [];
    const n = this.contact.length / 10, stride = Math.max(1, Math.floor(n / 5000));
    for (let c = 0; c < n; c += stride) {
      const size = Math.hypot(...this.contactAt(c).F);
      if (size > 0 && Number.isFinite(size)) sizes.push(size);
    }
    sizes.sort((a, b) => a - b);
    return sizes.length ? sizes[Math.floor(0.9 * (sizes.length - 1))] : 0;
  }
}

const kRest = {r: [0, 0, 0], q: [1, 0, 0, 0]};
const kFloatBits = new DataView(new ArrayBuffer(4));

/** The float whose upper 16 bits are given, the lower ones being zero. */
function upperHalfFloat(bits) {
  kFloatBits.setUint16(0, bits);
  kFloatBits.setUint16(2, 0);
  return kFloatBits.getFloat32(0);
}

/** Signals as [{name, unit, t, y}]; a unit that the table does not know may stand in run.json. */
function decodeSignals(signals, run) {
  const units = new Map();
  for (const s of (run && Array.isArray(run.signals) ? run.signals : [])) units.set(s.name, s.unit);
  let t = new Float64Array(0);
  return signals.map(s => {
    if (s.t !== undefined) t = numbersOf(s.t, "Float64", 8);
    return {name: s.name, unit: s.unit || units.get(s.name) || "", t, y: numbersOf(s.y, "Float32", 4)};
  });
}

function clamp(x, lo, hi) { return Math.min(hi, Math.max(lo, x)); }

/** Index of the last of the sorted numbers that is ≤ x; 0 if none is. */
function lastAtOrBefore(sorted, x) {
  let lo = 0, hi = sorted.length - 1;
  while (lo < hi) {
    const middle = (lo + hi + 1) >> 1;
    if (sorted[middle] <= x) lo = middle; else hi = middle - 1;
  }
  return lo;
}

/** Ticks inside [lo, hi], at most `most`, steps 1, 2 or 5 · 10^k: {step, values}. */
function niceTicks(lo, hi, most) {
  const span = hi - lo;
  if (!(span > 0) || !Number.isFinite(span)) return {step: 1, values: [lo]};
  const power = 10 ** Math.floor(Math.log10(span / most));
  for (const factor of [1, 2, 5, 10, 20]) {
    const step = factor * power;
    const first = Math.ceil(lo / step - 1e-9), last = Math.floor(hi / step + 1e-9);
    if (last - first + 1 > most) continue;
    const values = [];
    for (let k = first; k <= last; ++k) values.push(k * step + 0);
    return {step, values};
  }
  return {step: span, values: [lo]};
}

/** A number with the decimals that `step` needs. */
function tickLabel(value, step) {
  if (value === 0) return "0";
  const size = Math.max(Math.abs(value), step);
  if (size >= 1e5 || size < 1e-3) return Number(value.toPrecision(6)).toExponential().replace("e+", "e");
  return value.toFixed(Math.max(0, -Math.floor(Math.log10(step) + 1e-9))).replace("-", "\u2212");
}

/** A number for reading: four digits. */
function shortNumber(x) {
  if (!Number.isFinite(x)) return String(x);
  const size = Math.abs(x);
  if (size !== 0 && (size >= 1e5 || size < 1e-4)) return Number(x.toPrecision(4)).toExponential().replace("e+", "e");
  return String(Number(x.toPrecision(4))).replace("-", "\u2212");
}
