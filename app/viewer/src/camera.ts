// The camera of all pictures: planar views are parallel projections, so that a planar scene is its
// own drawing; the spatial view has perspective, if WebGL can draw it.
import {add, clamp, cross, dot, scaled, sub, type V2, type V3} from "./math";

const kPlanes: Record<string, {right: V3; up: V3; toward: V3}> = {
  xy: {right: [1, 0, 0], up: [0, 1, 0], toward: [0, 0, 1]},
  xz: {right: [1, 0, 0], up: [0, 0, 1], toward: [0, -1, 0]},
  yz: {right: [0, 1, 0], up: [0, 0, 1], toward: [1, 0, 0]}
};
export const kFieldOfView = 26 * Math.PI / 180;  // of the height

export class Camera {
  view = "iso";
  upAxis = 2;  // the coordinate that points up in the spatial view
  azimuth = -62 * Math.PI / 180;
  elevation = 22 * Math.PI / 180;
  centre: V3 = [0, 0, 0];
  scale = 100;  // [pixel/m] in the plane through the centre
  width = 1;
  height = 1;
  perspective = true;
  right: V3 = [1, 0, 0];
  up: V3 = [0, 0, 1];
  toward: V3 = [0, -1, 0];

  constructor() { this.look(); }

  get isPlanar(): boolean { return this.view in kPlanes; }
  /** Distance of the eye from the centre [m]. */
  get distance(): number { return this.height / (2 * Math.tan(kFieldOfView / 2) * this.scale); }
  get hasDepth(): boolean { return this.perspective && !this.isPlanar; }

  /** Sets right, up, toward from the view or from the two angles. */
  look(): void {
    if (this.isPlanar) {
      Object.assign(this, kPlanes[this.view]);
      return;
    }
    const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    // with z up; a cyclic change of the axes brings another coordinate up
    const turned = (v: V3): V3 =>
      this.upAxis === 2 ? v : this.upAxis === 1 ? [v[1], v[2], v[0]] : [v[2], v[0], v[1]];
    this.toward = turned([ce * ca, ce * sa, se]);
    this.right = turned([-sa, ca, 0]);
    this.up = cross(this.toward, this.right);
  }

  /** Pixels per metre at a point. */
  scaleAt(p: V3): number {
    if (!this.hasDepth) return this.scale;
    const D = this.distance, depth = D - dot(sub(p, this.centre), this.toward);
    return depth > 1e-3 * D ? this.scale * D / depth : 0;
  }

  /** Canvas coordinates of a point; far outside if it lies behind the eye. */
  project(p: V3): V2 {
    const d = sub(p, this.centre), s = this.scaleAt(p);
    if (s === 0) return [-1e6, -1e6];
    return [this.width / 2 + s * dot(d, this.right), this.height / 2 - s * dot(d, this.up)];
  }

  /** The point in the plane through the centre that is seen at (x, y). */
  unproject(x: number, y: number): V3 {
    return add(this.centre, add(scaled(this.right, (x - this.width / 2) / this.scale),
                                scaled(this.up, (this.height / 2 - y) / this.scale)));
  }

  depth(p: V3): number { return dot(sub(p, this.centre), this.toward); }

  orbit(dx: number, dy: number): void {
    this.azimuth -= dx * 0.008;
    this.elevation = clamp(this.elevation + dy * 0.008, -1.55, 1.55);
    this.look();
  }

  pan(dx: number, dy: number): void {
    this.centre = add(this.centre, add(scaled(this.right, -dx / this.scale), scaled(this.up, dy / this.scale)));
  }

  /** Scales by `factor` so that the point under (x, y) stays. */
  zoom(factor: number, x: number, y: number): void {
    const before = this.unproject(x, y);
    this.scale *= factor;
    this.centre = add(this.centre, sub(before, this.unproject(x, y)));
  }

  /** Shows all of `points`, with room for the tools at the borders. */
  fit(points: V3[]): void {
    const range = (values: number[]): V2 => {
      let lo = Infinity, hi = -Infinity;
      for (const x of values) { lo = Math.min(lo, x); hi = Math.max(hi, x); }
      return [lo, hi];
    };
    const along = (axis: V3): V2 => range(points.map(p => dot(p, axis)));
    const [right, up, toward] = [along(this.right), along(this.up), along(this.toward)];
    const size = Math.max(right[1] - right[0], up[1] - up[0], 1e-9);
    const top = 56, bottom = this.height > 420 ? 92 : 44;
    const w = this.width * 0.84, h = Math.max(40, this.height - top - bottom);
    const middle = (r: V2): number => (r[0] + r[1]) / 2;
    this.scale = Math.min(w / Math.max(right[1] - right[0], size * 1e-3), h / Math.max(up[1] - up[0], size * 1e-3));
    this.centre = add(scaled(this.right, middle(right)),
                      add(scaled(this.up, middle(up)), scaled(this.toward, middle(toward))));
    // near points look larger: a few corrections bring their outline into the frame
    for (let i = 0; i < 4; ++i) {
      const seen = points.map(p => this.project(p));
      const x = range(seen.map(s => s[0])), y = range(seen.map(s => s[1]));
      this.centre = this.unproject(middle(x), middle(y) - (top - bottom) / 2);
      if (!this.hasDepth) break;
      this.scale *= Math.min(w / Math.max(x[1] - x[0], 1e-3), h / Math.max(y[1] - y[0], 1e-3), 4);
    }
  }
}
