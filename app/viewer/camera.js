// camera.js: vectors, rotations, and the parallel projection of the scene to the canvas.
// Parallel, not perspective: lengths can be compared, and a planar scene is its own drawing.

const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scaled = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = a => Math.hypot(a[0], a[1], a[2]);
const unit = a => scaled(a, 1 / (norm(a) || 1));

/** q ∘ p of unit quaternions [w, x, y, z]. */
function product(q, p) {
  return [
    q[0] * p[0] - q[1] * p[1] - q[2] * p[2] - q[3] * p[3],
    q[0] * p[1] + q[1] * p[0] + q[2] * p[3] - q[3] * p[2],
    q[0] * p[2] - q[1] * p[3] + q[2] * p[0] + q[3] * p[1],
    q[0] * p[3] + q[1] * p[2] - q[2] * p[1] + q[3] * p[0]];
}

/** A(q) v = v + 2 w (e × v) + 2 e × (e × v). */
function rotated(q, v) {
  const e = [q[1], q[2], q[3]];
  const c = scaled(cross(e, v), 2);
  return add(add(v, scaled(c, q[0])), cross(e, c));
}

/** Pose of S from that of K and the place of S in K. */
function chained(pose, position, orientation) {
  return {r: add(pose.r, rotated(pose.q, position)), q: product(pose.q, orientation)};
}

/** What is right, up and towards the viewer in the planar views. */
const kPlanes = {
  xy: {right: [1, 0, 0], up: [0, 1, 0], toward: [0, 0, 1]},
  xz: {right: [1, 0, 0], up: [0, 0, 1], toward: [0, -1, 0]},
  yz: {right: [0, 1, 0], up: [0, 0, 1], toward: [1, 0, 0]}
};

class Camera {
  constructor() {
    this.view = "iso";
    this.upAxis = 2;  // the coordinate that points up in the spatial view
    this.azimuth = -62 * Math.PI / 180;
    this.elevation = 22 * Math.PI / 180;
    this.centre = [0, 0, 0];
    this.scale = 100;  // [pixel/m]
    this.width = this.height = 1;
    this.look();
  }

  get isPlanar() { return this.view in kPlanes; }

  /** Sets right, up, toward from the view or from the two angles. */
  look() {
    if (this.isPlanar) {
      Object.assign(this, kPlanes[this.view]);
      return;
    }
    const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
    const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    // with z up; a cyclic change of the axes brings another coordinate up
    const turned = v => this.upAxis === 2 ? v : this.upAxis === 1 ? [v[1], v[2], v[0]] : [v[2], v[0], v[1]];
    this.toward = turned([ce * ca, ce * sa, se]);
    this.right = turned([-sa, ca, 0]);
    this.up = cross(this.toward, this.right);
  }

  /** Canvas coordinates of a point. */
  project(p) {
    const d = sub(p, this.centre);
    return [this.width / 2 + this.scale * dot(d, this.right),
            this.height / 2 - this.scale * dot(d, this.up)];
  }

  /** The point in the plane through the centre that is seen at (x, y). */
  unproject(x, y) {
    return add(this.centre, add(scaled(this.right, (x - this.width / 2) / this.scale),
                                scaled(this.up, (this.height / 2 - y) / this.scale)));
  }

  depth(p) { return dot(sub(p, this.centre), this.toward); }

  orbit(dx, dy) {
    this.azimuth -= dx * 0.008;
    this.elevation = clamp(this.elevation + dy * 0.008, -1.55, 1.55);
    this.look();
  }

  pan(dx, dy) {
    this.centre = add(this.centre, add(scaled(this.right, -dx / this.scale),
                                       scaled(this.up, dy / this.scale)));
  }

  /** Scales by `factor` so that the point under (x, y) stays. */
  zoom(factor, x, y) {
    const before = this.unproject(x, y);
    this.scale *= factor;
    this.centre = add(this.centre, sub(before, this.unproject(x, y)));
  }

  /** Shows all of `points`, with room for the tools at the borders. */
  fit(points) {
    const along = axis => {
      const range = [Infinity, -Infinity];
      for (const p of points) {
        range[0] = Math.min(range[0], dot(p, axis));
        range[1] = Math.max(range[1], dot(p, axis));
      }
      return range;
    };
    const [right, up, toward] = [along(this.right), along(this.up), along(this.toward)];
    const size = Math.max(right[1] - right[0], up[1] - up[0], 1e-9);
    this.scale = Math.min(this.width * 0.8 / Math.max(right[1] - right[0], size * 1e-3),
                          (this.height - 60) * 0.82 / Math.max(up[1] - up[0], size * 1e-3));
    const middle = range => (range[0] + range[1]) / 2;
    this.centre = add(scaled(this.right, middle(right)),
                      add(scaled(this.up, middle(up)), scaled(this.toward, middle(toward))));
  }
}
