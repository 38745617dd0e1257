// The scene with its film: where shapes are, how large everything is, which view suits.
import type {Scene, SceneShape} from "./data";
import type {Film} from "./film";
import {kItems} from "./flat_shapes";
import {sheetOf, type Plane, type Sheet} from "./ground";
import {add, chained, clamp, dot, norm, rotated, scaled, sub, type Pose, type V3} from "./math";

export interface Extent { lo: V3; hi: V3; points: V3[]; size: number }

export class SceneModel {
  readonly bodies: SceneShape[];
  readonly grounds: SceneShape[];
  extent: Extent;
  readonly upAxis: number;

  constructor(readonly scene: Scene, readonly film: Film) {
    // A shape that only touches is "transparent".
    this.bodies = scene.shapes.filter(s => s.kind in kItems && s.colour !== "transparent");
    const halfSpaces = scene.shapes.filter(s => s.kind === "halfspace");
    this.grounds = halfSpaces.filter(s => s.colour !== "transparent");
    this.extent = this.measure();
    const normal: V3 = halfSpaces.length ? this.plane(halfSpaces[0], film.begin).n : [0, 0, 1];
    this.upAxis = Math.abs(normal[1]) > 0.9 ? 1 : 2;
  }

  /** The film has grown. True: its scene is larger by a tenth or more. */
  remeasure(): boolean {
    const before = this.extent.size, now = this.measure();
    if (now.size < 1.1 * before) return false;
    this.extent = now;
    return true;
  }

  shapePose(shape: SceneShape, t: number): Pose {
    return chained(this.film.pose(shape.frame, t), shape.position, shape.orientation);
  }

  /** Point and outward normal of a half space at t. */
  plane(shape: SceneShape, t: number): Plane {
    const pose = this.shapePose(shape, t);
    return {c: pose.r, n: rotated(pose.q, [0, 0, 1])};
  }

  /** Whether a body of the shape, or of an end of a link, takes no part at t. */
  absent(shape: SceneShape, t: number): boolean {
    return this.film.absent(shape.frame, t) || this.film.absent(shape.frameEnd ?? -1, t);
  }

  /** The planes that end that of `shape` at t: those that no moving body lies beyond. */
  endsOf(shape: SceneShape, t: number): Plane[] {
    const bodies = this.bodies.filter(s => s.frame >= 0 && s.frame !== shape.frame && !this.absent(s, t)).slice(0, 300).map(s => this.shapePose(s, t).r);
    return this.grounds.filter(g => g !== shape).map(g => this.plane(g, t)).filter(({c, n}) => bodies.every(r => dot(n, sub(r, c)) >= 0));
  }

  /** What is seen of a half space: `share` of the scene's size to each side. */
  sheet(shape: SceneShape, t: number, share: number, most: number): Sheet {
    const {lo, hi, size} = this.extent;
    return sheetOf(this.plane(shape, t), scaled(add(lo, hi), 0.5), share * size, most, this.endsOf(shape, t));
  }

  /** The part of a half space around a place that is looked at. */
  sheetAround(shape: SceneShape, t: number, middle: V3, half: number, most: number): Sheet {
    return sheetOf(this.plane(shape, t), middle, half, most, this.endsOf(shape, t));
  }

  private pointsOf(shape: SceneShape, t: number): V3[] {
    if (this.absent(shape, t)) return [];
    const pose = this.shapePose(shape, t), R = shape.radius ?? 0;
    if (shape.kind === "sphere" && this.bodies.length > 300) {
      return [add(pose.r, [R, R, R]), sub(pose.r, [R, R, R])];
    }
    return kItems[shape.kind](shape, pose, this.film.pose(shape.frameEnd ?? -1, t)).points();
  }

  private instants(shapes: number, most: number): number[] {
    const n = clamp(Math.floor(3000 / Math.max(1, shapes)), 2, most), {begin, end} = this.film;
    return Array.from({length: n}, (_, i) => begin + (end - begin) * i / (n - 1));
  }

  /** Points that span everything that is drawn at some instants of the film. */
  private measure(): Extent {
    const lo: V3 = [Infinity, Infinity, Infinity], hi: V3 = [-Infinity, -Infinity, -Infinity];
    let points: V3[] = [];
    const take = (p: V3): void => {
      if (!p.every(Number.isFinite)) return;
      points.push(p);
      p.forEach((x, k) => {
        lo[k] = Math.min(lo[k], x);
        hi[k] = Math.max(hi[k], x);
      });
    };
    for (const t of this.instants(this.bodies.length, 60)) {
      for (const shape of this.bodies) this.pointsOf(shape, t).forEach(take);
    }
    if (!(lo[0] <= hi[0])) { take([-1, -1, -1]); take([1, 1, 1]); }
    // a ground that is near belongs to the picture
    const size = Math.max(norm(sub(hi, lo)), 1e-9);
    if (points.length > 20000) {
      points = [];
      for (const x of [lo[0], hi[0]]) for (const y of [lo[1], hi[1]]) for (const z of [lo[2], hi[2]]) points.push([x, y, z]);
    }
    for (const shape of this.grounds) {
      const {c, n} = this.plane(shape, this.film.begin), middle = scaled(add(lo, hi), 0.5);
      const foot = sub(middle, scaled(n, dot(n, sub(middle, c))));
      if (norm(sub(foot, middle)) < 1.5 * size) take(foot);
    }
    return {lo, hi, points, size: Math.max(norm(sub(hi, lo)), 1e-9)};
  }

  /** What moves, seen from a frame at some instants of the film, put to where the frame is now. */
  pointsAround(frame: number, anchor: V3): V3[] {
    const moving = this.bodies.filter(s => this.film.moves(s.frame)), points: V3[] = [];
    for (const t of this.instants(moving.length, 40)) {
      const shift = sub(anchor, this.film.pose(frame, t).r);
      for (const shape of moving) {
        for (const p of this.pointsOf(shape, t)) if (p.every(Number.isFinite)) points.push(add(p, shift));
      }
    }
    return points.length ? points : this.extent.points;
  }

  /** The view that the scene asks for, or the plane in which everything moves, or the spatial one. */
  naturalView(): string {
    if (this.scene.view) return this.scene.view;
    const {film} = this;
    const plane = (fixed: number, turns: number[]): boolean => {
      for (let i = 0; i < film.poses; ++i) {
        if (!film.stands(i, fixed) || turns.some(k => !film.stands(i, 3 + k, 0))) return false;
      }
      return film.poses > 0;
    };
    if (this.upAxis === 1 && plane(2, [1, 2])) return "xy";
    if (plane(1, [1, 3])) return "xz";
    if (plane(2, [1, 2])) return "xy";
    if (plane(0, [2, 3])) return "yz";
    return "iso";
  }
}

/** Diagonal of the box around points. */
export function spread(points: V3[]): number {
  const range = (k: number): number => {
    let lo = Infinity, hi = -Infinity;
    for (const p of points) { lo = Math.min(lo, p[k]); hi = Math.max(hi, p[k]); }
    return hi - lo;
  };
  return Math.max(norm([range(0), range(1), range(2)]), 1e-9);
}
