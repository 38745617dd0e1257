// What is seen of half spaces: each plane ends where the matter of another one begins, so that a floor
// does not go on behind a wall. The space that half spaces leave free is convex: cutting is exact.
import {across, add, cross, dot, niceTicks, scaled, sub, type V3} from "./math";

export interface Plane { c: V3; n: V3 }

/** The part of a convex polygon that lies outside of the matter below the planes. */
export function cutPolygon(polygon: V3[], planes: Plane[], tiny: number): V3[] {
  for (const {c, n} of planes) {
    const out: V3[] = [];
    polygon.forEach((p, i) => {
      const q = polygon[(i + 1) % polygon.length], a = dot(n, sub(p, c)) + tiny, b = dot(n, sub(q, c)) + tiny;
      if (a >= 0) out.push(p);
      if (a * b < 0) out.push(add(p, scaled(sub(q, p), a / (a - b))));
    });
    polygon = out;
  }
  return polygon;
}

/** The same of a line; null: nothing is left of it. */
export function cutLine(p: V3, q: V3, planes: Plane[], tiny: number): [V3, V3] | null {
  for (const {c, n} of planes) {
    const a = dot(n, sub(p, c)) + tiny, b = dot(n, sub(q, c)) + tiny;
    if (a < 0 && b < 0) return null;
    if (a * b >= 0) continue;
    const at = add(p, scaled(sub(q, p), a / (a - b)));
    if (a < 0) p = at; else q = at;
  }
  return [p, q];
}

export interface Sheet { outline: V3[]; lines: [V3, V3][] }

/** A square of a plane around `middle`, `half` to each side, with lines at round distances, cut by other planes. */
export function sheetOf({c, n}: Plane, middle: V3, half: number, most: number, others: Plane[]): Sheet {
  const a = across(n), b = cross(n, a), foot = sub(middle, scaled(n, dot(n, sub(middle, c))));
  const {step} = niceTicks(0, 2 * half, most), cells = Math.ceil(half / step), tiny = 1e-6 * half;
  const origin = [a, b].map(e => Math.round(dot(foot, e) / step) * step - dot(foot, e));
  const at = (i: number, j: number): V3 => add(foot, add(scaled(a, origin[0] + i * step), scaled(b, origin[1] + j * step)));
  const lines: [V3, V3][] = [];
  for (let i = -cells; i <= cells; ++i) {
    for (const [p, q] of [[at(i, -cells), at(i, cells)], [at(-cells, i), at(cells, i)]]) {
      const seen = cutLine(p, q, others, tiny);
      if (seen) lines.push(seen);
    }
  }
  return {outline: cutPolygon([at(-cells, -cells), at(cells, -cells), at(cells, cells), at(-cells, cells)], others, tiny), lines};
}
