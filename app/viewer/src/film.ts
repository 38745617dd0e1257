// A film: poses and contacts of a run over time. A page holds a recorded one (data.ts); in a live run
// it grows (live_film.ts).
import {lastAtOrBefore, type Pose, type V3} from "./math";

export const kImpact = 3;  // the state of a contact with an impact
/** `step`: Δt of the force [s], 0: unknown. */
export interface Contact { r: V3; n: V3; F: V3; state: number; limit: number; step: number }

/** What the arrow of a contact stands for over its force: an impact is shown by its percussion [N s], if Δt is known. */
export const arrowFactor = (c: Contact): number => c.state === kImpact && c.step > 0 ? c.step : 1;

/** First and last time of a film with its curves. */
export function spanOf(film: Film, signals: {t: Float64Array}[]): [number, number] {
  const times = [film.t, ...signals.map(s => s.t)].filter(t => t.length);
  const begin = Math.min(...times.map(t => t[0])), end = Math.max(...times.map(t => t[t.length - 1]));
  return begin <= end ? [begin, end] : [0, 0];
}

export abstract class Film {
  abstract readonly count: number;
  abstract readonly poses: number;
  abstract readonly t: Float64Array;
  abstract readonly now: Float32Array;  // poses at the time of sample()
  abstract readonly contactCount: number;
  /** Fills `now` with all poses at t, straight between frames. */
  abstract sample(t: number): Float32Array;
  /** Pose i at time t; the inertial frame is −1. */
  abstract pose(i: number, t: number): Pose;
  abstract moves(i: number): boolean;
  /** Whether body i takes no part at t (grains that were taken away): the quaternion of its pose is 0. */
  absent(i: number, t: number): boolean { return i >= 0 && this.comes(i) && this.pose(i, t).q.every(x => x === 0); }
  /** Whether body i may be absent at some time. */
  protected abstract comes(i: number): boolean;
  /** Whether coordinate k of pose i stands, at `value` if one is given. */
  abstract stands(i: number, k: number, value?: number): boolean;
  /** Contacts of the last frame at or before t. */
  abstract contacts(t: number): Contact[];
  abstract contactAt(c: number): Contact;
  /** Whether impacts are shown in N s: older recordings lack Δt. */
  abstract readonly knowsSteps: boolean;

  get begin(): number { return this.count ? this.t[0] : 0; }
  get end(): number { return this.count ? this.t[this.count - 1] : 0; }

  /** Index of the last frame at or before t. */
  indexAt(t: number): number { return lastAtOrBefore(this.t, t); }

  /** Velocity [m/s] and angular velocity [rad/s] of pose i, from the two frames around t. */
  rates(i: number, t: number): {v: V3; omega: V3} {
    const f = Math.min(this.indexAt(t), Math.max(0, this.count - 2)), g = Math.min(f + 1, this.count - 1);
    const dt = this.t[g] - this.t[f];
    if (!(dt > 0)) return {v: [0, 0, 0], omega: [0, 0, 0]};
    const A = this.pose(i, this.t[f]), B = this.pose(i, this.t[g]);
    if (!A.q.some(x => x) || !B.q.some(x => x)) return {v: [0, 0, 0], omega: [0, 0, 0]};
    const [w, x, y, z] = A.q, p = B.q;
    // p ∘ q*: the turn from one frame to the next
    const d = [p[0] * w + p[1] * x + p[2] * y + p[3] * z, p[1] * w - p[0] * x - p[2] * z + p[3] * y,
               p[2] * w - p[0] * y - p[3] * x + p[1] * z, p[3] * w - p[0] * z - p[1] * y + p[2] * x];
    const s = Math.hypot(d[1], d[2], d[3]), angle = 2 * Math.atan2(s, d[0]);
    const factor = s > 1e-12 ? angle / s / dt : 2 / dt;
    return {v: [0, 1, 2].map(k => (B.r[k] - A.r[k]) / dt) as V3, omega: [d[1], d[2], d[3]].map(e => e * factor) as V3};
  }

  firstMoving(): number {
    for (let i = 0; i < this.poses; ++i) if (this.moves(i)) return i;
    return -1;
  }

  /** A force [N] that most contacts stay below: nine of ten of those that are not zero. */
  usualForce(): number { return this.usual(state => state !== kImpact); }
  /** The same of the percussions of impacts [N s]. */
  usualImpact(): number { return this.usual(state => state === kImpact); }

  private usual(counts: (state: number) => boolean): number {
    const sizes: number[] = [], n = this.contactCount, stride = Math.max(1, Math.floor(n / 5000));
    for (let c = 0; c < n; c += stride) {
      const contact = this.contactAt(c), size = Math.hypot(...contact.F) * arrowFactor(contact);
      if (size > 0 && Number.isFinite(size) && counts(contact.state)) sizes.push(size);
    }
    sizes.sort((a, b) => a - b);
    return sizes.length ? sizes[Math.floor(0.9 * (sizes.length - 1))] : 0;
  }
}
