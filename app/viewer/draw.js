// draw.js: the picture at one time: ground, bodies from back to front, contacts, trails, axes.

const kStates = [
  {name: "open", colour: "#8a94a0"}, {name: "stick", colour: "#1b8a4b"},
  {name: "slip", colour: "#d1610f"}, {name: "impact", colour: "#c2185b"}];

class Picture {
  constructor(canvas, scene, film) {
    this.canvas = canvas;
    this.scene = scene;
    this.film = film;
    this.camera = new Camera();
    this.show = {contacts: true, trails: false, grid: true};
    this.selected = -1;  // frame whose name and place are shown
    this.usualForce = film.usualForce();
    this.bodies = scene.shapes.filter(s => s.kind in kBuilders);
    this.grounds = scene.shapes.filter(s => s.kind === "halfspace");
    this.painted = [];
    this.extent = this.sceneExtent();
    this.followed = -1;         // frame that the camera moves with
    this.anchor = [0, 0, 0];    // where it was when the camera moved last
    this.size = this.extent.size;
    const normal = this.grounds.length ? this.plane(this.grounds[0], film.begin).n : [0, 0, 1];
    if (Math.abs(normal[1]) > 0.9) {  // y is up: x stays to the right, z comes to the viewer
      this.camera.upAxis = 1;
      this.camera.azimuth = 28 * Math.PI / 180;
    }
  }

  item(shape, t) {
    const pose = chained(this.film.pose(shape.frame, t), shape.position, shape.orientation);
    const end = shape.kind === "link" ? this.film.pose(shape.frameEnd, t) : null;
    return kBuilders[shape.kind](shape, pose, end);
  }

  /** Point and outward normal of a half space at t. */
  plane(shape, t) {
    const pose = chained(this.film.pose(shape.frame, t), shape.position, shape.orientation);
    return {c: pose.r, n: rotated(pose.q, [0, 0, 1])};
  }

  colourOf(shape) {
    if (/^#[0-9a-f]{6}$/i.test(shape.colour || "")) return shape.colour;
    return shape.frame < 0 ? kStill : kPalette[shape.frame % kPalette.length];
  }

  /** Points that span everything that is drawn at some instants of the film. */
  sceneExtent() {
    const lo = [Infinity, Infinity, Infinity], hi = [-Infinity, -Infinity, -Infinity];
    const points = [];
    const take = p => {
      if (!p.every(Number.isFinite)) return;
      points.push(p);
      p.forEach((x, k) => {
        lo[k] = Math.min(lo[k], x);
        hi[k] = Math.max(hi[k], x);
      });
    };
    const instants = clamp(Math.floor(3000 / Math.max(1, this.bodies.length)), 2, 60);
    for (let i = 0; i < instants; ++i) {
      const t = this.film.begin + (this.film.end - this.film.begin) * i / (instants - 1);
      for (const shape of this.bodies) this.item(shape, t).points().forEach(take);
    }
    if (!(lo[0] <= hi[0])) { take([-1, -1, -1]); take([1, 1, 1]); }
    // a ground that is near belongs to the picture
    const size = Math.max(norm(sub(hi, lo)), 1e-9);
    for (const shape of this.grounds) {
      const {c, n} = this.plane(shape, this.film.begin);
      const middle = scaled(add(lo, hi), 0.5);
      const foot = sub(middle, scaled(n, dot(n, sub(middle, c))));
      if (norm(sub(foot, middle)) < 1.5 * size) take(foot);
    }
    return {lo, hi, points, size: Math.max(norm(sub(hi, lo)), 1e-9)};
  }

  /** The view that the scene asks for, or the plane in which everything moves, or the spatial one. */
  naturalView() {
    if (this.scene.view) return this.scene.view;
    const {film} = this;
    const still = (i, k, value) => !film.course[7 * i + k] &&
      (value === undefined || Math.abs(film.lo[7 * i + k] - value) < 1e-6);
    const plane = (fixed, turns) => {
      for (let i = 0; i < film.poses; ++i) {
        if (!still(i, fixed) || turns.some(k => !still(i, 3 + k, 0))) return false;
      }
      return film.poses > 0;
    };
    const up = this.camera.upAxis;
    if (up === 1 && plane(2, [1, 2])) return "xy";
    if (plane(1, [1, 3])) return "xz";
    if (plane(2, [1, 2])) return "xy";
    if (plane(0, [2, 3])) return "yz";
    return "iso";
  }

  setView(view) {
    this.camera.view = view;
    this.camera.look();
    this.fit();
  }

  fit() {
    const points = this.followed >= 0 ? this.pointsAround(this.followed) : this.extent.points;
    this.size = this.followed >= 0 ? spread(points) : this.extent.size;
    this.camera.fit(points);
  }

  /** The camera moves with a frame from now on; -1: it stands. */
  follow(frame, t) {
    this.followed = frame;
    if (frame >= 0) this.anchor = this.film.pose(frame, t).r;
  }

  keepUp(t) {
    if (this.followed < 0) return;
    const {r} = this.film.pose(this.followed, t);
    this.camera.centre = add(this.camera.centre, sub(r, this.anchor));
    this.anchor = r;
  }

  /** What moves, seen from a frame at some instants of the film, put to where the frame is now. */
  pointsAround(frame) {
    const moving = this.bodies.filter(s => this.film.moves(s.frame));
    const points = [], instants = 40;
    for (let i = 0; i < instants; ++i) {
      const t = this.film.begin + (this.film.end - this.film.begin) * i / (instants - 1);
      const shift = sub(this.anchor, this.film.pose(frame, t).r);
      for (const shape of moving)
        this.item(shape, t).points().filter(p => p.every(Number.isFinite)).forEach(p => points.push(add(p, shift)));
    }
    return points.length ? points : this.extent.points;
  }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    const {clientWidth: w, clientHeight: h} = this.canvas;
    const first = this.camera.width <= 1;
    this.canvas.width = Math.round(w * ratio);
    this.canvas.height = Math.round(h * ratio);
    const grown = Math.min(w / this.camera.width, h / this.camera.height);
    Object.assign(this.camera, {width: w, height: h});
    if (!first) this.camera.scale *= grown;
  }

  draw(t) {
    const ratio = window.devicePixelRatio || 1;
    const ctx = this.canvas.getContext("2d"), {camera} = this;
    this.keepUp(t);
    ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
    ctx.fillStyle = "#ffffff";
    ctx.fillRect(0, 0, camera.width, camera.height);
    camera.zigzag = clamp(0.02 * this.size * camera.scale, 4, 12);
    if (camera.isPlanar && this.show.grid) paintGrid(ctx, camera);

    const below = g => dot(this.plane(g, t).n, camera.toward) < -1e-3;
    const grounds = this.grounds.slice().sort((a, b) =>
      dot(this.plane(a, t).n, camera.toward) - dot(this.plane(b, t).n, camera.toward));
    for (const g of grounds.filter(g => !below(g))) paintGround(ctx, camera, this.plane(g, t), this.extent);
    if (this.show.trails) this.paintTrails(ctx, t);
    this.painted = [];
    for (const {item, shape} of backToFront(this.bodies.map(s => ({shape: s, item: this.item(s, t)})), camera)) {
      const path = item.paint(ctx, camera, this.colourOf(shape));
      this.painted.push({path, shape});
      if (shape.frame >= 0 && shape.frame === this.selected) {
        ctx.strokeStyle = "#1769aa";
        ctx.lineWidth = 3;
        ctx.stroke(path);
      }
    }
    for (const g of grounds.filter(below)) paintGround(ctx, camera, this.plane(g, t), this.extent);
    if (this.show.contacts) this.paintContacts(ctx, t);
    paintAxes(ctx, camera);
  }

  /** The shape that is seen at (x, y), or null. */
  pick(x, y) {
    const ctx = this.canvas.getContext("2d");
    ctx.setTransform(1, 0, 0, 1, 0, 0);
    for (let i = this.painted.length - 1; i >= 0; --i) {
      if (ctx.isPointInPath(this.painted[i].path, x, y)) return this.painted[i].shape;
    }
    return null;
  }

  paintTrails(ctx, t) {
    const {film, camera} = this;
    const last = film.indexAt(t), stride = Math.max(1, Math.ceil(last / 600));
    for (let i = 0; i < Math.min(film.poses, 60); ++i) {
      const points = [];
      for (let f = 0; f <= last; f += stride) points.push(camera.project(film.pose(i, film.t[f]).r));
      points.push(camera.project(film.pose(i, t).r));
      ctx.strokeStyle = mixed(kPalette[i % kPalette.length], 0.25);
      ctx.lineWidth = 1.4;
      ctx.stroke(polygonPath(points, false));
    }
  }

  /** Contact points with their force; a usual force is a tenth of the scene long. */
  paintContacts(ctx, t) {
    const {camera} = this;
    const most = 0.28 * Math.min(camera.width, camera.height);
    const perNewton = this.usualForce > 0 ? 0.1 * this.size * camera.scale / this.usualForce : 0;
    for (const {r, F, state} of this.film.contacts(t)) {
      const p = camera.project(r);
      const tip = [dot(F, camera.right) * perNewton, -dot(F, camera.up) * perNewton];
      const length = Math.hypot(...tip), cut = Math.min(1, most / (length || 1));
      ctx.strokeStyle = ctx.fillStyle = (kStates[state] || kStates[0]).colour;
      if (length > 3) arrow(ctx, p, [p[0] + tip[0] * cut, p[1] + tip[1] * cut]);
      ctx.beginPath();
      ctx.arc(p[0], p[1], 3, 0, 2 * Math.PI);
      ctx.fill();
    }
  }
}

/** Diagonal of the box around points. */
function spread(points) {
  const range = k => {
    let lo = Infinity, hi = -Infinity;
    for (const p of points) { lo = Math.min(lo, p[k]); hi = Math.max(hi, p[k]); }
    return hi - lo;
  };
  return Math.max(norm([0, 1, 2].map(range)), 1e-9);
}

/** Items in the order of painting. Depth of the centres orders most; a plane that has one item on
 *  each side orders a pair for certain (a ball on a large table), so these pairs rule. */
function backToFront(entries, camera) {
  for (const e of entries) e.depth = camera.depth(e.item.centre);
  entries.sort((a, b) => a.depth - b.depth);
  if (camera.isPlanar || entries.length > 200) return entries;
  const out = [], state = new Map();
  const visit = e => {
    if (state.has(e)) return;  // done, or a circle of overlaps: broken here
    state.set(e, 1);
    for (const other of entries) if (other !== e && isBefore(other.item, e.item, camera)) visit(other);
    out.push(e);
  };
  entries.forEach(visit);
  return out;
}

/** Whether b may hide a, but a cannot hide b. */
function isBefore(a, b, camera) {
  const free = (p, q) => isOutside(p, q, camera, 1) || isOutside(q, p, camera, -1);  // p cannot hide q
  return free(a, b) && !free(b, a);
}

/** Whether b is beyond a plane of a that faces the viewer (side 1) or that does not (side -1). */
function isOutside(a, b, camera, side) {
  return a.planes.some(({n, o}) =>
    side * dot(n, camera.toward) > 1e-6 && b.least(n) >= o - 1e-9 - 1e-4 * Math.abs(o));
}

function arrow(ctx, p, q, width = 2.2) {
  const phi = Math.atan2(q[1] - p[1], q[0] - p[0]);
  const head = Math.min(10, 0.6 * Math.hypot(q[0] - p[0], q[1] - p[1]));
  const back = s => [q[0] - head * Math.cos(phi + s), q[1] - head * Math.sin(phi + s)];
  ctx.lineWidth = width;
  ctx.lineCap = "butt";
  ctx.stroke(polygonPath([p, [q[0] - 0.8 * head * Math.cos(phi), q[1] - 0.8 * head * Math.sin(phi)]], false));
  ctx.fill(polygonPath([q, back(0.42), back(-0.42)]));
}

/** Lines at round numbers, in the planar views. */
function paintGrid(ctx, camera) {
  const a = camera.unproject(0, camera.height), b = camera.unproject(camera.width, 0);
  const step = niceTicks(0, camera.width / camera.scale, Math.max(4, Math.round(camera.width / 90))).step;
  ctx.lineWidth = 1;
  for (const [axis, vertical] of [[camera.right, true], [camera.up, false]]) {
    for (let k = Math.ceil(dot(a, axis) / step); k * step <= dot(b, axis); ++k) {
      const at = add(camera.centre, scaled(axis, k * step - dot(camera.centre, axis)));
      const [x, y] = camera.project(at).map(v => Math.round(v) + 0.5);
      ctx.strokeStyle = k === 0 ? "#dde2e8" : "#eff1f4";
      ctx.beginPath();
      if (vertical) { ctx.moveTo(x, 0); ctx.lineTo(x, camera.height); }
      else { ctx.moveTo(0, y); ctx.lineTo(camera.width, y); }
      ctx.stroke();
    }
  }
}

/** A half space: a hatched line if it is seen from the edge, else a sheet with a grid. */
function paintGround(ctx, camera, {c, n}, extent) {
  const facing = dot(n, camera.toward);
  if (Math.abs(facing) < 0.02) {
    paintHatchedLine(ctx, camera, c, n);
    return;
  }
  const a = unit(cross(Math.abs(n[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], n)), b = cross(n, a);
  const middle = scaled(add(extent.lo, extent.hi), 0.5);
  const foot = sub(middle, scaled(n, dot(n, sub(middle, c))));
  const half = 0.75 * extent.size, step = niceTicks(0, 2 * half, 12).step;
  const cells = Math.ceil(half / step);
  const origin = [a, b].map(e => Math.round(dot(foot, e) / step) * step - dot(foot, e));
  const at = (i, j) => camera.project(add(foot, add(scaled(a, origin[0] + i * step), scaled(b, origin[1] + j * step))));
  const sheet = polygonPath([at(-cells, -cells), at(cells, -cells), at(cells, cells), at(-cells, cells)]);
  ctx.fillStyle = facing > 0 ? "#f1f3f5" : "rgba(140, 150, 162, .10)";
  ctx.fill(sheet);
  ctx.strokeStyle = "#d5dae0";
  ctx.lineWidth = 1;
  if (facing < 0) {  // it stands between the viewer and the bodies
    ctx.stroke(sheet);
    return;
  }
  for (let i = -cells; i <= cells; ++i) {
    ctx.stroke(polygonPath([at(i, -cells), at(i, cells)], false));
    ctx.stroke(polygonPath([at(-cells, i), at(cells, i)], false));
  }
}

function paintHatchedLine(ctx, camera, c, n) {
  const p = camera.project(c);
  const m = [dot(n, camera.right), -dot(n, camera.up)];  // out of the matter, on the canvas
  const d = [-m[1], m[0]];
  // as long as the canvas, with strokes that stay when the view is moved
  const reach = camera.width + camera.height;
  const towardMiddle = (camera.width / 2 - p[0]) * d[0] + (camera.height / 2 - p[1]) * d[1];
  const first = Math.floor((towardMiddle - reach) / 11), last = Math.ceil((towardMiddle + reach) / 11);
  const at = (s, depth) => [p[0] + d[0] * s - m[0] * depth, p[1] + d[1] * s - m[1] * depth];
  ctx.fillStyle = "#f3f4f6";
  ctx.fill(polygonPath([at(first * 11, 0), at(last * 11, 0), at(last * 11, 14), at(first * 11, 14)]));
  ctx.strokeStyle = "#9aa5b1";
  ctx.lineWidth = 1.1;
  ctx.beginPath();
  for (let k = first; k <= last; ++k) {
    const a = at(k * 11 + 11, 0), b = at(k * 11, 14);
    ctx.moveTo(a[0], a[1]);
    ctx.lineTo(b[0], b[1]);
  }
  ctx.stroke();
  ctx.strokeStyle = "#3e4c59";
  ctx.lineWidth = 1.8;
  ctx.stroke(polygonPath([at(first * 11, 0), at(last * 11, 0)], false));
}

/** Directions of the inertial axes and a scale, in the lower left corner. */
function paintAxes(ctx, camera) {
  const o = [44, camera.height - 44], length = 30;
  const axes = [["x", [1, 0, 0], "#c2413b"], ["y", [0, 1, 0], "#3f8f46"], ["z", [0, 0, 1], "#2f6db5"]];
  axes.sort((a, b) => dot(a[1], camera.toward) - dot(b[1], camera.toward));
  ctx.font = "600 13px 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  for (const [name, axis, colour] of axes) {
    const e = [dot(axis, camera.right), -dot(axis, camera.up)];
    if (Math.hypot(...e) < 0.05) continue;
    ctx.strokeStyle = ctx.fillStyle = colour;
    arrow(ctx, o, [o[0] + e[0] * length, o[1] + e[1] * length], 1.8);
    ctx.fillText(name, o[0] + e[0] * (length + 10), o[1] + e[1] * (length + 10));
  }
  const bar = niceTicks(0, 150 / camera.scale, 2).step, pixels = bar * camera.scale;
  const [x, y] = [o[0] + 62, camera.height - 30];
  ctx.strokeStyle = ctx.fillStyle = "#52606d";
  ctx.lineWidth = 1.4;
  ctx.stroke(polygonPath([[x, y - 4], [x, y], [x + pixels, y], [x + pixels, y - 4]], false));
  ctx.font = "12px 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";
  ctx.fillText(tickLabel(bar, bar) + " m", x + pixels / 2, y + 11);
}
