// Geometries of the spatial picture. Round bodies carry sectors of two brightnesses, so that one
// sees them turn; plane outlines become slabs that lie on each other as they are painted.
import {BoxGeometry, BufferGeometry, CapsuleGeometry, ConeGeometry, CylinderGeometry, EdgesGeometry, Float32BufferAttribute,
  Matrix4, SphereGeometry, TorusGeometry} from "three";
import {toCreasedNormals} from "three/addons/utils/BufferGeometryUtils.js";
import type {SceneShape} from "./data";
import {add, cross, dot, norm, scaled, sub, unit, type V3} from "./math";

/** Darkens faces for which `dark` says so of their middle. */
function sectors(geometry: BufferGeometry, dark: (x: number, y: number, z: number) => boolean, depth = 0.8): BufferGeometry {
  const g = geometry.index ? geometry.toNonIndexed() : geometry;
  const p = g.getAttribute("position"), colour = new Float32Array(3 * p.count);
  for (let i = 0; i < p.count; i += 3) {
    const mid = (get: (k: number) => number): number => (get(i) + get(i + 1) + get(i + 2)) / 3;
    const shade = dark(mid(k => p.getX(k)), mid(k => p.getY(k)), mid(k => p.getZ(k))) ? depth : 1;
    colour.fill(shade, 3 * i, 3 * i + 9);
  }
  g.setAttribute("color", new Float32BufferAttribute(colour, 3));
  return g;
}

/** A ball of radius 1; eight parts, light and dark in turn. */
export function ball(many: boolean): BufferGeometry {
  if (!many) return sectors(new SphereGeometry(1, 40, 24), (x, y, z) => x * y * z > 0);
  // shared corners: a fourth of the work; the parts fade into each other
  const g = new SphereGeometry(1, 10, 7), p = g.getAttribute("position");
  const shade = Array.from({length: p.count}, (_, i) => p.getX(i) * p.getY(i) * p.getZ(i) > 0.01 ? 0.72 : 1);
  g.setAttribute("color", new Float32BufferAttribute(shade.flatMap(s => [s, s, s]), 3));
  return g;
}

/** A cylinder of radius 1 from z = −1 to 1; quarters. */
export function cylinder(): BufferGeometry {
  const g = new CylinderGeometry(1, 1, 2, 48).applyMatrix4(new Matrix4().makeRotationX(Math.PI / 2));
  return sectors(g, (x, y) => x * y > 0);
}

export function capsule(radius: number, halfLength: number): BufferGeometry {
  const g = new CapsuleGeometry(radius, 2 * halfLength, 12, 28).applyMatrix4(new Matrix4().makeRotationX(Math.PI / 2));
  return sectors(g, (x, y) => x * y > 0);
}

/** A cone of radius 1 about z, its base at z = 0, its tip at z = 2. */
export function cone(): BufferGeometry {
  const g = new ConeGeometry(1, 2, 48).applyMatrix4(new Matrix4().makeRotationX(Math.PI / 2).setPosition(0, 0, 1));
  return sectors(g, (x, y) => x * y > 0);
}

export function torus(radius: number, tube: number): BufferGeometry {
  return sectors(new TorusGeometry(radius, tube, 20, 64), (x, y) => x * y > 0);
}

/** Triangles from which on a mesh has curved surfaces: faces that meet at less than this angle [deg] are parts of one. */
const kMany = 400, kCurved = 30;

/** Triangles with the edges between faces that meet at an angle. */
export function meshGeometry({points = [], triangles = []}: SceneShape): {solid: BufferGeometry; edges: BufferGeometry} {
  const solid = new BufferGeometry(), at = triangles.flatMap(t => t.flatMap(i => points[i]));
  solid.setAttribute("position", new Float32BufferAttribute(at, 3));
  solid.computeVertexNormals();
  const many = triangles.length > kMany, shaded = many ? toCreasedNormals(solid, kCurved * Math.PI / 180) : solid;
  return {solid: sectors(shaded, () => false), edges: new EdgesGeometry(solid, many ? kCurved : 12)};
}

/** A cube from −1 to 1. */
export function cube(): BufferGeometry { return sectors(new BoxGeometry(2, 2, 2), () => false); }
export function cubeEdges(): BufferGeometry { return new EdgesGeometry(new BoxGeometry(2, 2, 2)); }

/** A spring of radius 1 from z = 0 to 1. */
export function helix(): Float32Array {
  const turns = 9, n = 16 * turns, out = new Float32Array(3 * (n + 1));
  for (let i = 0; i <= n; ++i) {
    const s = i / n, phi = 2 * Math.PI * turns * s, r = Math.min(1, 12 * Math.min(s, 1 - s));
    out.set([r * Math.cos(phi), r * Math.sin(phi), s], 3 * i);
  }
  return out;
}

export interface Slab { points: V3[]; n: V3; thickness: number }

/** Outline, normal and thickness of a plane shape; `under`: slabs of the same frame painted before. */
export function slabOf(points: V3[], under: Slab[]): Slab {
  let doubled: V3 = [0, 0, 0], round = 0;
  for (let i = 0; i < points.length; ++i) {
    const p = points[i], q = points[(i + 1) % points.length];
    doubled = add(doubled, cross(p, q));
    round += norm(sub(q, p));
  }
  const n = unit(doubled), centre = scaled(points.reduce(add, [0, 0, 0]), 1 / points.length);
  // as thick as a bar of this outline would be square
  let thickness = norm(doubled) / Math.max(round, 1e-12);
  for (const other of under) if (inside(centre, other)) thickness = Math.max(thickness, 1.08 * other.thickness);
  return {points, n, thickness};
}

function inside(p: V3, slab: Slab): boolean {
  const {points, n} = slab;
  const size = Math.max(...points.map(q => norm(sub(q, points[0]))));
  if (Math.abs(dot(n, sub(p, points[0]))) > 0.02 * size) return false;
  return points.every((a, i) => dot(n, cross(sub(points[(i + 1) % points.length], a), sub(p, a))) >= 0);
}

/** The slab as triangles: two faces and the rim. */
export function slabGeometry({points, n, thickness}: Slab): {solid: BufferGeometry; edges: BufferGeometry} {
  const up = scaled(n, thickness / 2), faces: number[] = [], lines: number[] = [];
  const top = points.map(p => add(p, up)), bottom = points.map(p => sub(p, up));
  for (let i = 1; i + 1 < points.length; ++i) {
    faces.push(...top[0], ...top[i], ...top[i + 1], ...bottom[0], ...bottom[i + 1], ...bottom[i]);
  }
  for (let i = 0; i < points.length; ++i) {
    const j = (i + 1) % points.length;
    faces.push(...top[i], ...bottom[i], ...bottom[j], ...top[i], ...bottom[j], ...top[j]);
    lines.push(...top[i], ...top[j], ...bottom[i], ...bottom[j]);
  }
  const solid = new BufferGeometry(), edges = new BufferGeometry();
  solid.setAttribute("position", new Float32BufferAttribute(faces, 3));
  solid.computeVertexNormals();
  edges.setAttribute("position", new Float32BufferAttribute(lines, 3));
  return {solid: sectors(solid, () => false), edges};
}

/** The matrix that puts a bar along z (from −1 to 1, radius 1) between two points. */
export function barBetween(p: V3, q: V3, radius: number): Matrix4 {
  const d = sub(q, p), e = unit(d), a = unit(cross(Math.abs(e[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], e)), b = cross(e, a);
  const c = scaled(add(p, q), 0.5), half = norm(d) / 2, [A, B, E] = [scaled(a, radius), scaled(b, radius), scaled(e, half)];
  return new Matrix4().set(A[0], B[0], E[0], c[0], A[1], B[1], E[1], c[1], A[2], B[2], E[2], c[2], 0, 0, 0, 1);
}

/** What tells two shapes that can share one geometry. */
export function groupKey(shape: SceneShape, index: number): string {
  if (shape.kind === "capsule") return `capsule ${shape.radius} ${shape.halfLength}`;
  if (shape.kind === "torus") return `torus ${shape.radius} ${shape.tube}`;
  if (shape.kind === "polygon" || shape.kind === "mesh") return `${shape.kind} ${index}`;
  if (shape.kind === "ellipsoid") return "sphere";
  if (shape.kind === "circle") return "cylinder";
  return shape.kind;
}
