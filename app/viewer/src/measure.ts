// Measuring: the distance of two points that are fixed to bodies, at the time of the picture.
import type {Film} from "./film";
import {add, norm, rotated, shortNumber, sub, type V3} from "./math";

interface Mark { frame: number; local: V3 }

export class Measure {
  on = false;
  private marks: Mark[] = [];

  constructor(private readonly film: Film) {}

  /** A point of a body, or of the ground (frame −1), as it is seen at t; the third one begins anew. */
  take(frame: number, point: V3, t: number): void {
    if (this.marks.length === 2) this.marks = [];
    const {r, q} = this.film.pose(frame, t);
    this.marks.push({frame, local: rotated([q[0], -q[1], -q[2], -q[3]], sub(point, r))});
  }

  clear(): void { this.marks = []; }

  points(t: number): V3[] {
    return this.marks.map(({frame, local}) => {
      const {r, q} = this.film.pose(frame, t);
      return add(r, rotated(q, local));
    });
  }

  /** "0.31 m   Δx 0.1   Δy 0   Δz 0.29"; what to do while points are missing. */
  text(t: number): string {
    const [p, q] = this.points(t);
    if (!p) return "click two points";
    if (!q) return "click the second point";
    const d = sub(q, p);
    return `${shortNumber(norm(d))} m   ${["x", "y", "z"].map((n, k) => `\u0394${n} ${shortNumber(d[k])}`).join("   ")}`;
  }
}
