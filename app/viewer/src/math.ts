// Vectors, unit quaternions [w, x, y, z], and small helpers for numbers.

export type V3 = [number, number, number];
export type V2 = [number, number];
export type Q4 = [number, number, number, number];
export interface Pose { r: V3; q: Q4 }

export const add = (a: V3, b: V3): V3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a: V3, b: V3): V3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a: V3, s: number): V3 => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a: V3, b: V3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: V3, b: V3): V3 =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const norm = (a: V3): number => Math.hypot(a[0], a[1], a[2]);
export const unit = (a: V3): V3 => scaled(a, 1 / (norm(a) || 1));

/** A unit vector at right angles to n. */
export const across = (n: V3): V3 => unit(cross(Math.abs(n[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], n));

/** q ∘ p. */
export function product(q: Q4, p: Q4): Q4 {
  return [
    q[0] * p[0] - q[1] * p[1] - q[2] * p[2] - q[3] * p[3],
    q[0] * p[1] + q[1] * p[0] + q[2] * p[3] - q[3] * p[2],
    q[0] * p[2] - q[1] * p[3] + q[2] * p[0] + q[3] * p[1],
    q[0] * p[3] + q[1] * p[2] - q[2] * p[1] + q[3] * p[0]];
}

/** A(q) v = v + 2 w (e × v) + 2 e × (e × v). */
export function rotated(q: Q4, v: V3): V3 {
  const e: V3 = [q[1], q[2], q[3]];
  const c = scaled(cross(e, v), 2);
  return add(add(v, scaled(c, q[0])), cross(e, c));
}

/** Pose of S from that of K and the place of S in K. */
export function chained(pose: Pose, position: V3, orientation: Q4): Pose {
  return {r: add(pose.r, rotated(pose.q, position)), q: product(pose.q, orientation)};
}

export function clamp(x: number, lo: number, hi: number): number {
  return Math.min(hi, Math.max(lo, x));
}

/** Index of the last of the sorted numbers that is ≤ x; 0 if none is. */
export function lastAtOrBefore(sorted: ArrayLike<number>, x: number): number {
  let lo = 0, hi = sorted.length - 1;
  while (lo < hi) {
    const middle = (lo + hi + 1) >> 1;
    if (sorted[middle] <= x) lo = middle; else hi = middle - 1;
  }
  return lo;
}

/** Ticks inside [lo, hi], at most `most`, steps 1, 2 or 5 · 10^k. */
export function niceTicks(lo: number, hi: number, most: number): {step: number; values: number[]} {
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

const kMinus = "\u2212";

/** A number with the decimals that `step` needs. */
export function tickLabel(value: number, step: number): string {
  if (value === 0) return "0";
  const size = Math.max(Math.abs(value), step);
  if (size >= 1e5 || size < 1e-3) return Number(value.toPrecision(6)).toExponential().replace("e+", "e").replace(/-/g, kMinus);
  return value.toFixed(Math.max(0, -Math.floor(Math.log10(step) + 1e-9))).replace("-", kMinus);
}

/** A number for reading: four digits. */
export function shortNumber(x: number): string {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? "\u2013" : String(x);
  const size = Math.abs(x);
  if (size !== 0 && (size >= 1e5 || size < 1e-4)) {
    return Number(x.toPrecision(4)).toExponential().replace("e+", "e").replace(/-/g, kMinus);
  }
  return String(Number(x.toPrecision(4))).replace("-", kMinus);
}

/** A length with a unit that suits it. */
export function lengthText(x: number): string {
  const [factor, unitName] = x < 0.0095 ? [1e3, "mm"] : x < 0.95 ? [1e2, "cm"] : x < 950 ? [1, "m"] : [1e-3, "km"];
  return `${Number((x * (factor as number)).toPrecision(4))} ${unitName}`;
}
