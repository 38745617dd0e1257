// The picture on a plain canvas: grid, ground, bodies from back to front. It serves planar views,
// and every view where WebGL is missing.
import type {Camera} from "./camera";
import {kItems, pathOf, type Item} from "./flat_shapes";
import type {SceneShape} from "./data";
import {cutLine, type Plane} from "./ground";
import {add, dot, niceTicks, scaled, sub, type V2, type V3} from "./math";
import type {SceneModel} from "./scene_model";
import {colourOf, theme} from "./theme";

type Context = CanvasRenderingContext2D;
interface Entry { item: Item; frame: number; colour: string; depth: number }

export class FlatPicture {
  private readonly ctx: Context;
  private painted: {path: Path2D; frame: number}[] = [];
  private colours: string[];
  hidden: ReadonlySet<number> = new Set();  // frames whose bodies are not shown

  constructor(readonly canvas: HTMLCanvasElement, private readonly scene: SceneModel) {
    this.ctx = canvas.getContext("2d") as Context;
    this.colours = scene.bodies.map(colourOf);
  }

  recolour(): void { this.colours = this.scene.bodies.map(colourOf); }

  resize(width: number, height: number, ratio: number): void {
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
  }

  draw(camera: Camera, t: number, selected: number): void {
    const {ctx, scene} = this, ratio = this.canvas.width / camera.width;
    ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
    ctx.fillStyle = theme.paper;
    ctx.fillRect(0, 0, camera.width, camera.height);
    if (camera.isPlanar) paintGrid(ctx, camera);
    const grounds = scene.grounds.map(shape => ({shape, facing: dot(scene.plane(shape, t).n, camera.toward)}));
    grounds.sort((a, b) => a.facing - b.facing);
    for (const g of grounds) if (g.facing >= -1e-3) paintGround(ctx, camera, g.shape, scene, t);
    this.painted = [];
    const entries = scene.bodies.map((shape, i): Entry => ({
      item: kItems[shape.kind](shape, scene.shapePose(shape, t), scene.film.pose(shape.frameEnd ?? -1, t)),
      frame: shape.frame, colour: this.colours[i], depth: 0}));
    const seen = entries.filter((e, i) => !this.hidden.has(e.frame) && !scene.absent(scene.bodies[i], t));
    for (const {item, frame, colour} of backToFront(seen, camera)) {
      const path = item.paint(ctx, camera, colour);
      this.painted.push({path, frame});
      if (frame >= 0 && frame === selected) {
        ctx.strokeStyle = theme.accent;
        ctx.lineWidth = 3;
        ctx.stroke(path);
      }
    }
    for (const g of grounds) if (g.facing < -1e-3) paintGround(ctx, camera, g.shape, scene, t);
  }

  /** The frame of the shape that is seen at (x, y); −2: none. */
  pick(x: number, y: number): number {
    this.ctx.setTransform(1, 0, 0, 1, 0, 0);
    for (let i = this.painted.length - 1; i >= 0; --i) {
      if (this.ctx.isPointInPath(this.painted[i].path, x, y)) return this.painted[i].frame;
    }
    return -2;
  }
}

/** Items in the order of painting. Depth of the centres orders most; a plane that has one item on
 *  each side orders a pair for certain (a ball on a large table), so these pairs rule. */
function backToFront(entries: Entry[], camera: Camera): Entry[] {
  for (const e of entries) e.depth = camera.depth(e.item.centre);
  entries.sort((a, b) => a.depth - b.depth);
  if (camera.isPlanar || entries.length > 200) return entries;
  const out: Entry[] = [], seen = new Set<Entry>();
  const visit = (e: Entry): void => {
    if (seen.has(e)) return;  // done, or a circle of overlaps: broken here
    seen.add(e);
    for (const other of entries) if (other !== e && isBefore(other.item, e.item, camera)) visit(other);
    out.push(e);
  };
  entries.forEach(visit);
  return out;
}

/** Whether b may hide a, but a cannot hide b. */
function isBefore(a: Item, b: Item, camera: Camera): boolean {
  const free = (p: Item, q: Item): boolean => isOutside(p, q, camera, 1) || isOutside(q, p, camera, -1);
  return free(a, b) && !free(b, a);
}

/** Whether b is beyond a plane of a that faces the viewer (side 1) or that does not (side −1). */
function isOutside(a: Item, b: Item, camera: Camera, side: number): boolean {
  return a.planes.some(({n, o}) =>
    side * dot(n, camera.toward) > 1e-6 && b.least(n) >= o - 1e-9 - 1e-4 * Math.abs(o));
}

/** Lines at round numbers, in the planar views. */
export function paintGrid(ctx: Context, camera: Camera): void {
  const a = camera.unproject(0, camera.height), b = camera.unproject(camera.width, 0);
  const step = niceTicks(0, camera.width / camera.scale, Math.max(4, Math.round(camera.width / 90))).step;
  ctx.lineWidth = 1;
  for (const [axis, vertical] of [[camera.right, true], [camera.up, false]] as [V3, boolean][]) {
    for (let k = Math.ceil(dot(a, axis) / step); k * step <= dot(b, axis); ++k) {
      const at = add(camera.centre, scaled(axis, k * step - dot(camera.centre, axis)));
      const [x, y] = camera.project(at).map(v => Math.round(v) + 0.5);
      ctx.strokeStyle = k === 0 ? theme.gridZero : theme.grid;
      ctx.beginPath();
      if (vertical) { ctx.moveTo(x, 0); ctx.lineTo(x, camera.height); }
      else { ctx.moveTo(0, y); ctx.lineTo(camera.width, y); }
      ctx.stroke();
    }
  }
}

/** A half space: a hatched line if it is seen from the edge, else a sheet with a grid. */
export function paintGround(ctx: Context, camera: Camera, shape: SceneShape, scene: SceneModel, t: number): void {
  const plane = scene.plane(shape, t), facing = dot(plane.n, camera.toward);
  if (Math.abs(facing) < 0.02) {
    const ends = scene.endsOf(shape, t).filter(p => Math.abs(dot(p.n, camera.toward)) < 0.02);
    paintHatchedLine(ctx, camera, plane, ends, scene.extent.size);
    return;
  }
  if (camera.isPlanar) return;  // the paper itself
  const {outline, lines} = scene.sheet(shape, t, 0.75, 12);
  const sheet = pathOf(outline.map(p => camera.project(p)));
  ctx.fillStyle = facing > 0 ? theme.ground : theme.sheet;
  ctx.fill(sheet);
  ctx.strokeStyle = theme.groundLine;
  ctx.lineWidth = 1;
  if (facing < 0) {  // it stands between the viewer and the bodies
    ctx.stroke(sheet);
    return;
  }
  for (const line of lines) ctx.stroke(pathOf(line.map(p => camera.project(p)), false));
}

/** As long as the canvas, or up to the planes that end it. */
function paintHatchedLine(ctx: Context, camera: Camera, {c, n}: Plane, ends: Plane[], size: number): void {
  const p = camera.project(c);
  const m: V2 = [dot(n, camera.right), -dot(n, camera.up)];  // out of the matter, on the canvas
  const d: V2 = [-m[1], m[0]];
  // as long as the canvas, with strokes that stay when the view is moved
  const reach = camera.width + camera.height;
  const towardMiddle = (camera.width / 2 - p[0]) * d[0] + (camera.height / 2 - p[1]) * d[1];
  const first = Math.floor((towardMiddle - reach) / 11), last = Math.ceil((towardMiddle + reach) / 11);
  const at = (s: number, depth: number): V2 => [p[0] + d[0] * s - m[0] * depth, p[1] + d[1] * s - m[1] * depth];
  // a pixel along d in space, to find where other planes end the line
  const along = scaled(add(scaled(camera.right, d[0]), scaled(camera.up, -d[1])), 1 / camera.scale);
  const seen = cutLine(add(c, scaled(along, first * 11)), add(c, scaled(along, last * 11)), ends, 1e-6 * size);
  if (!seen) return;
  const [from, to] = seen.map(x => dot(sub(x, c), along) / dot(along, along));
  ctx.save();
  ctx.clip(pathOf([at(from - 14, -2), at(to + 14, -2), at(to + 14, 15), at(from - 14, 15)]));
  ctx.fillStyle = theme.ground;
  ctx.fill(pathOf([at(first * 11, 0), at(last * 11, 0), at(last * 11, 14), at(first * 11, 14)]));
  ctx.strokeStyle = theme.hatch;
  ctx.lineWidth = 1.1;
  ctx.beginPath();
  for (let k = first; k <= last; ++k) {
    const a = at(k * 11 + 11, 0), b = at(k * 11, 14);
    ctx.moveTo(a[0], a[1]);
    ctx.lineTo(b[0], b[1]);
  }
  ctx.stroke();
  ctx.restore();
  ctx.strokeStyle = theme.edge;
  ctx.lineWidth = 1.8;
  ctx.stroke(pathOf([at(from, 0), at(to, 0)], false));
}
