// Bodies on a plain canvas, one item each: where it is, how it is ordered, how it is painted.
import type {Camera} from "./camera";
import type {SceneShape} from "./data";
import {add, cross, dot, norm, rotated, scaled, sub, unit, type Pose, type V2, type V3} from "./math";
import {mixed, theme} from "./theme";

type Context = CanvasRenderingContext2D;

export interface Item {
  centre: V3;
  points(): V3[];                    // for the size of the scene
  least(n: V3): number;              // smallest n·x of its matter
  planes: {n: V3; o: number}[];      // all of its matter has n·x ≤ o
  paint(ctx: Context, camera: Camera, colour: string): Path2D;  // returns its outline
}

/** Colour of a face with the outward normal n: light from the upper left, in front. */
function lit(colour: string, camera: Camera, n: V3): string {
  if (camera.isPlanar) return flatFill(colour);
  const light = unit([-0.45, 0.65, 0.62]);
  const seen: V3 = [dot(n, camera.right), dot(n, camera.up), dot(n, camera.toward)];
  return mixed(colour, -0.22 + 0.6 * Math.max(0, dot(seen, light)));
}

const flatFill = (colour: string): string => mixed(colour, theme.dark ? -0.12 : 0.3);
const edgeOf = (colour: string): string => mixed(colour, theme.dark ? 0.3 : -0.38);

export function pathOf(points: V2[], closed = true): Path2D {
  const path = new Path2D();
  points.forEach((p, i) => i ? path.lineTo(p[0], p[1]) : path.moveTo(p[0], p[1]));
  if (closed) path.closePath();
  return path;
}

/** Convex hull of points of the canvas. */
function hull(points: V2[]): V2[] {
  const sorted = points.slice().sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list: V2[]): V2[] => {
    const out: V2[] = [];
    for (const p of list) {
      while (out.length > 1) {
        const [a, b] = out.slice(-2);
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        out.pop();
      }
      out.push(p);
    }
    return out.slice(0, -1);
  };
  return half(sorted).concat(half(sorted.reverse()));
}

function fillAndEdge(ctx: Context, path: Path2D, fill: string | CanvasGradient, colour: string): void {
  ctx.fillStyle = fill;
  ctx.fill(path);
  ctx.strokeStyle = edgeOf(colour);
  ctx.lineWidth = 1.3;
  ctx.lineJoin = "round";
  ctx.stroke(path);
}

/** Points of the circle of radius r about c that spans a and b. */
export function ring(c: V3, a: V3, b: V3, r: number, n = 40): V3[] {
  return Array.from({length: n}, (_, i) => {
    const phi = 2 * Math.PI * i / n;
    return add(c, add(scaled(a, r * Math.cos(phi)), scaled(b, r * Math.sin(phi))));
  });
}

const kAxes: V3[] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

function sphere(shape: SceneShape, pose: Pose): Item {
  const c = pose.r, R = shape.radius ?? 0;
  return {
    centre: c, planes: [], least: n => dot(n, c) - R,
    points: () => corners(c, [[R, 0, 0], [0, R, 0], [0, 0, R]]),
    paint(ctx, camera, colour) {
      const [x, y] = camera.project(c), r = Math.max(1.5, R * camera.scale);
      const path = new Path2D();
      path.arc(x, y, r, 0, 2 * Math.PI);
      let fill: string | CanvasGradient = flatFill(colour);
      if (!camera.isPlanar) {
        fill = ctx.createRadialGradient(x - 0.35 * r, y - 0.42 * r, 0.05 * r, x, y, r);
        fill.addColorStop(0, mixed(colour, 0.62));
        fill.addColorStop(0.55, mixed(colour, 0.12));
        fill.addColorStop(1, mixed(colour, -0.25));
      }
      fillAndEdge(ctx, path, fill, colour);
      if (r > 6) greatCircles(ctx, camera, pose, R, colour);
      return path;
    }
  };
}

function box(shape: SceneShape, pose: Pose): Item {
  const half = shape.halfExtents ?? [0, 0, 0];
  const axes = kAxes.map(e => rotated(pose.q, e));
  const spans = axes.map((a, k) => scaled(a, half[k]));
  const planes: {n: V3; o: number; k: number; s: number}[] = [];
  for (const k of [0, 1, 2]) {
    for (const s of [1, -1]) {
      const n = scaled(axes[k], s);
      planes.push({n, o: dot(n, pose.r) + half[k], k, s});
    }
  }
  return {
    centre: pose.r, planes,
    least: n => dot(n, pose.r) - spans.reduce((sum, a) => sum + Math.abs(dot(n, a)), 0),
    points: () => corners(pose.r, spans),
    paint(ctx, camera, colour) {
      const all = new Path2D();
      for (const {n, k, s} of planes) {
        if (dot(n, camera.toward) <= 1e-3) continue;
        const [a, b] = [spans[(k + 1) % 3], spans[(k + 2) % 3]];
        const middle = add(pose.r, scaled(spans[k], s));
        const face = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([i, j]) =>
          camera.project(add(middle, add(scaled(a, i), scaled(b, j)))));
        const path = pathOf(face);
        fillAndEdge(ctx, path, lit(colour, camera, n), colour);
        all.addPath(path);
      }
      return all;
    }
  };
}

function capsule(shape: SceneShape, pose: Pose): Item {
  const axis = rotated(pose.q, [0, 0, shape.halfLength ?? 0]), R = shape.radius ?? 0;
  const ends = [sub(pose.r, axis), add(pose.r, axis)];
  return {
    centre: pose.r, planes: [], least: n => dot(n, pose.r) - Math.abs(dot(n, axis)) - R,
    points: () => ends.flatMap(e => corners(e, [[R, 0, 0], [0, R, 0], [0, 0, R]])),
    paint(ctx, camera, colour) {
      const r = R * camera.scale, [p, q] = ends.map(e => camera.project(e));
      const phi = Math.atan2(q[1] - p[1], q[0] - p[0]);
      const path = new Path2D();
      path.arc(p[0], p[1], r, phi + Math.PI / 2, phi - Math.PI / 2);
      path.arc(q[0], q[1], r, phi - Math.PI / 2, phi + Math.PI / 2);
      path.closePath();
      fillAndEdge(ctx, path, acrossLight(ctx, camera, p, phi, r, colour), colour);
      return path;
    }
  };
}

function cylinder(shape: SceneShape, pose: Pose): Item {
  const [a, b, e] = kAxes.map(v => rotated(pose.q, v));
  const R = shape.radius ?? 0, half = shape.halfLength ?? 0, axis = scaled(e, half);
  const ends = [sub(pose.r, axis), add(pose.r, axis)];
  const rings = ends.map(c => ring(c, a, b, R));
  return {
    centre: pose.r,
    planes: [1, -1].map(s => ({n: scaled(e, s), o: s * dot(e, pose.r) + half})),
    least: n => dot(n, pose.r) - Math.abs(dot(n, axis)) - R * Math.hypot(dot(n, a), dot(n, b)),
    points: () => rings.flat(),
    paint(ctx, camera, colour) {
      const seen = rings.map(r => r.map(c => camera.project(c)));
      const path = pathOf(hull(seen.flat()));
      const [p, q] = ends.map(c => camera.project(c));
      const phi = Math.atan2(q[1] - p[1], q[0] - p[0]);
      fillAndEdge(ctx, path, acrossLight(ctx, camera, p, phi, R * camera.scale, colour), colour);
      const facing = dot(e, camera.toward);
      if (Math.abs(facing) > 1e-3) {
        const near = facing > 0 ? 1 : 0;
        fillAndEdge(ctx, pathOf(seen[near]), lit(colour, camera, scaled(e, Math.sign(facing))), colour);
        spoke(ctx, camera, ends[near], a, R, colour);
      }
      return path;
    }
  };
}

/** A body of triangles, those that face the viewer from back to front. */
function solid(points: V3[], triangles: V3[], centre: V3): Item {
  return {
    centre, planes: [], least: n => Math.min(...points.map(p => dot(n, p))), points: () => points,
    paint(ctx, camera, colour) {
      const all = new Path2D(), faces: {n: V3; corners: V3[]; depth: number}[] = [];
      for (const t of triangles) {
        const corners = t.map(i => points[i]), n = unit(cross(sub(corners[1], corners[0]), sub(corners[2], corners[0])));
        if (dot(n, camera.toward) > 1e-3) faces.push({n, corners, depth: dot(mean(corners), camera.toward)});
      }
      faces.sort((a, b) => a.depth - b.depth);
      for (const {n, corners} of faces) {
        const path = pathOf(corners.map(p => camera.project(p)));
        ctx.fillStyle = ctx.strokeStyle = lit(colour, camera, n);
        ctx.lineWidth = 0.7;
        ctx.fill(path);
        ctx.stroke(path);
        all.addPath(path);
      }
      return all;
    }
  };
}

/** A surface over a grid of m × n cells, the second direction closed. */
function grid(pose: Pose, m: number, n: number, at: (s: number, phi: number) => V3): Item {
  const points: V3[] = [], triangles: V3[] = [];
  for (let i = 0; i <= m; ++i) for (let j = 0; j < n; ++j) points.push(add(pose.r, rotated(pose.q, at(i / m, 2 * Math.PI * j / n))));
  for (let i = 0; i < m; ++i) {
    for (let j = 0; j < n; ++j) {
      const [a, b] = [i * n + j, i * n + (j + 1) % n];
      triangles.push([a, b, b + n], [a, b + n, a + n]);
    }
  }
  return solid(points, triangles, pose.r);
}

function ellipsoid(shape: SceneShape, pose: Pose): Item {
  const [a, b, c] = shape.halfExtents ?? [0, 0, 0];
  return grid(pose, 14, 28, (s, phi) => {
    const r = Math.sin(Math.PI * s);
    return [a * r * Math.cos(phi), b * r * Math.sin(phi), -c * Math.cos(Math.PI * s)];
  });
}

function torus(shape: SceneShape, pose: Pose): Item {
  const R = shape.radius ?? 0, tube = shape.tube ?? 0;
  return grid(pose, 14, 40, (s, phi) => {
    const r = R - tube * Math.cos(2 * Math.PI * s);
    return [r * Math.cos(phi), r * Math.sin(phi), -tube * Math.sin(2 * Math.PI * s)];
  });
}

function cone(shape: SceneShape, pose: Pose): Item {
  const R = shape.radius ?? 0, height = 2 * (shape.halfLength ?? 0);
  return grid(pose, 2, 40, (s, phi) => {
    const r = s === 0.5 ? R : 0;
    return [r * Math.cos(phi), r * Math.sin(phi), s === 1 ? height : 0];
  });
}

function circle(shape: SceneShape, pose: Pose): Item {
  const [a, b, n] = kAxes.map(v => rotated(pose.q, v)), R = shape.radius ?? 0;
  const item = area(ring(pose.r, a, b, R, 64), pose.r, n);
  const plain = item.paint;
  item.paint = (ctx, camera, colour) => {
    const path = plain(ctx, camera, colour);
    spoke(ctx, camera, pose.r, a, R, colour);
    return path;
  };
  return item;
}

const mean = (points: V3[]): V3 => scaled(points.reduce(add, [0, 0, 0]), 1 / (points.length || 1));

export const kItems: Record<string, (shape: SceneShape, pose: Pose, end: Pose) => Item> = {
  sphere, box, capsule, cylinder, circle, ellipsoid, torus, cone,
  mesh(shape, pose) {
    const points = (shape.points ?? []).map(p => add(pose.r, rotated(pose.q, p)));
    return solid(points, shape.triangles ?? [], mean(points));
  },
  polygon(shape, pose) {
    const points = (shape.points ?? []).map(p => add(pose.r, rotated(pose.q, p)));
    const n: V3 = points.length > 2 ? unit(cross(sub(points[1], points[0]), sub(points[2], points[0]))) : [0, 0, 1];
    return area(points, mean(points), n);
  },
  segment: (shape, pose) => line((shape.points ?? []).map(p => add(pose.r, rotated(pose.q, p))), shape),
  link(shape, pose, end) {
    const [p, q] = shape.points ?? [];
    return line([add(pose.r, rotated(pose.q, p ?? [0, 0, 0])), add(end.r, rotated(end.q, q ?? [0, 0, 0]))], shape);
  }
};

/** The eight corners c ± a ± b ± d. */
function corners(c: V3, [a, b, d]: V3[]): V3[] {
  const out: V3[] = [];
  for (const i of [-1, 1]) for (const j of [-1, 1]) for (const k of [-1, 1]) {
    out.push(add(c, add(scaled(a, i), add(scaled(b, j), scaled(d, k)))));
  }
  return out;
}

/** A plane area with these corners. */
function area(points: V3[], centre: V3, n: V3): Item {
  const o = dot(n, centre);
  return {
    centre, points: () => points,
    planes: [{n, o}, {n: scaled(n, -1), o: -o}],
    least: m => Math.min(...points.map(p => dot(m, p))),
    paint(ctx, camera, colour) {
      const path = pathOf(points.map(p => camera.project(p)));
      fillAndEdge(ctx, path, lit(colour, camera, dot(n, camera.toward) < 0 ? scaled(n, -1) : n), colour);
      return path;
    }
  };
}

/** A line through points: rod with thickness, thin line, dashed line or spring. */
function line(points: V3[], shape: SceneShape): Item {
  return {
    centre: mean(points), points: () => points, planes: [],
    least: n => Math.min(...points.map(p => dot(n, p))),
    paint(ctx, camera, colour) {
      let seen = points.map(p => camera.project(p));
      const radius = shape.radius ?? 0, width = radius > 0 ? Math.max(1.5, 2 * radius * camera.scale) : 2.4;
      if (shape.style === "spring") seen = zigzag(seen[0], seen[seen.length - 1], 8);
      const path = pathOf(seen, false);
      ctx.lineCap = ctx.lineJoin = "round";
      ctx.setLineDash(shape.style === "dashed" ? [7, 6] : []);
      if (radius > 0 && shape.style !== "spring") {
        ctx.strokeStyle = edgeOf(colour);
        ctx.lineWidth = width + 2.6;
        ctx.stroke(path);
        ctx.strokeStyle = flatFill(colour);
      } else {
        ctx.strokeStyle = mixed(colour, theme.dark ? 0.25 : -0.2);
      }
      ctx.lineWidth = shape.style === "spring" ? 1.8 : width;
      ctx.stroke(path);
      ctx.setLineDash([]);
      return pathOf(hull(seen.flatMap(([x, y]): V2[] => [[x - 4, y - 4], [x + 4, y - 4], [x, y + 5]])));
    }
  };
}

/** A spring from p to q with twelve turns. */
function zigzag(p: V2, q: V2, amplitude: number): V2[] {
  const d: V2 = [q[0] - p[0], q[1] - p[1]], length = Math.hypot(...d) || 1;
  const n: V2 = [-d[1] / length * amplitude, d[0] / length * amplitude];
  const at = (s: number, side: number): V2 => [p[0] + d[0] * s + n[0] * side, p[1] + d[1] * s + n[1] * side];
  const turns = Array.from({length: 24}, (_, i) => at(0.1 + 0.8 * (i + 0.5) / 24, i % 2 ? 1 : -1));
  return [p, at(0.1, 0), ...turns, at(0.9, 0), q];
}

/** Fill of a round bar seen from the side, the axis having the direction phi on the canvas. */
function acrossLight(ctx: Context, camera: Camera, p: V2, phi: number, r: number, colour: string): string | CanvasGradient {
  if (camera.isPlanar) return flatFill(colour);
  // the side nearer to the light is up, or left for upright bars
  let n: V2 = [Math.sin(phi), -Math.cos(phi)];
  if (n[0] * -0.45 + n[1] * -0.65 < 0) n = [-n[0], -n[1]];
  const fill = ctx.createLinearGradient(p[0] + n[0] * r, p[1] + n[1] * r, p[0] - n[0] * r, p[1] - n[1] * r);
  fill.addColorStop(0, mixed(colour, 0.25));
  fill.addColorStop(0.3, mixed(colour, 0.5));
  fill.addColorStop(1, mixed(colour, -0.25));
  return fill;
}

/** A radius along a, so that turning is seen, and the centre. */
function spoke(ctx: Context, camera: Camera, c: V3, a: V3, R: number, colour: string): void {
  const p = camera.project(c), q = camera.project(add(c, scaled(a, R)));
  ctx.strokeStyle = ctx.fillStyle = edgeOf(colour);
  ctx.lineWidth = 1.3;
  ctx.stroke(pathOf([p, q], false));
  ctx.beginPath();
  ctx.arc(p[0], p[1], 2.2, 0, 2 * Math.PI);
  ctx.fill();
}

/** The seen halves of two circles fixed to the sphere: a plain disc would hide that it turns. */
function greatCircles(ctx: Context, camera: Camera, pose: Pose, R: number, colour: string): void {
  ctx.strokeStyle = edgeOf(colour) + (camera.isPlanar ? "b0" : "70");
  ctx.lineWidth = 1.1;
  const [x, y, z] = kAxes.map(v => rotated(pose.q, v));
  for (const [a, b] of [[y, z], [x, y]]) {
    const n = cross(a, b);
    // where the circle crosses the outline it begins and ends
    let start = cross(n, camera.toward);
    if (norm(start) < 1e-6) continue;  // it is the outline
    start = unit(start);
    let middle = cross(start, n);
    if (dot(middle, camera.toward) < 0) middle = scaled(middle, -1);
    const arc = Array.from({length: 25}, (_, i) => {
      const phi = Math.PI * i / 24;
      return camera.project(add(pose.r, add(scaled(start, R * Math.cos(phi)), scaled(middle, R * Math.sin(phi)))));
    });
    ctx.stroke(pathOf(arc, false));
  }
}
