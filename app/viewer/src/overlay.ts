// What lies over the bodies in every picture: trails, contact forces with friction discs, axes, scale.
import type {Camera} from "./camera";
import {arrowFactor, kImpact, type Contact, type Film} from "./film";
import {pathOf, ring} from "./flat_shapes";
import {across, add, cross, dot, lengthText, niceTicks, scaled, type V2, type V3} from "./math";
import type {Measure} from "./measure";
import type {OtherRun} from "./other_run";
import {kPalette, kStates, mixed, theme} from "./theme";

type Context = CanvasRenderingContext2D;
const kFont = "system-ui, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";
const kMostDiscs = 60, kMostHeads = 1500;

export class Overlay {
  private readonly ctx: Context;
  usualForce: number;
  usualImpact: number;
  hand: [V3, V3] | null = null;  // the point that is held, and where it is pulled to
  measure: Measure | null = null;
  other: OtherRun | null = null;
  labels: {frame: number; text: string}[] = [];
  axes = true;

  constructor(readonly canvas: HTMLCanvasElement, private readonly film: Film) {
    this.ctx = canvas.getContext("2d") as Context;
    this.usualForce = film.usualForce();
    this.usualImpact = film.usualImpact();
  }

  /** Length of a force [m/N] in a picture, or of a percussion [m/(N s)]: impacts have a scale of their own. */
  perUnit(size: number, factor: number, impact: boolean): number {
    const usual = impact ? this.usualImpact : this.usualForce;
    return usual > 0 ? 0.1 * factor * size / usual : 0;
  }

  resize(width: number, height: number, ratio: number): void {
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
  }

  /** `size`: of the scene [m]; a usual force is a tenth of it long, times `factor`. */
  draw(camera: Camera, t: number, size: number, show: {contacts: boolean; trails: boolean}, factor: number): void {
    const {ctx} = this, ratio = this.canvas.width / camera.width;
    ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
    ctx.clearRect(0, 0, camera.width, camera.height);
    this.other?.paint(ctx, camera, t);
    if (show.trails) this.paintTrails(camera, t);
    if (show.contacts) this.paintContacts(camera, t, size, factor);
    if (this.hand) this.paintHand(camera, this.hand);
    this.paintLabels(camera, t);
    if (this.measure?.on) this.paintMeasure(camera, this.measure, t);
    if (this.axes) paintAxes(ctx, camera);
  }

  private paintHand(camera: Camera, hand: [V3, V3]): void {
    const {ctx} = this, [p, q] = hand.map(x => camera.project(x));
    ctx.strokeStyle = ctx.fillStyle = theme.accent;
    ctx.lineWidth = 2;
    ctx.setLineDash([6, 4]);
    ctx.stroke(pathOf([p, q], false));
    ctx.setLineDash([]);
    for (const [x, y] of [p, q]) {
      ctx.beginPath();
      ctx.arc(x, y, 4.5, 0, 2 * Math.PI);
      ctx.fill();
    }
  }

  /** Text on a plate of paper, so that it can be read over anything. */
  private paintText(text: string, x: number, y: number, within = Infinity): void {
    const {ctx} = this;
    ctx.font = `600 12px ${kFont}`;
    ctx.textAlign = "center";
    ctx.textBaseline = "middle";
    const w = ctx.measureText(text).width + 10;
    if (x > -w / 2 && x < within + w / 2) x = Math.min(Math.max(x, w / 2), Math.max(w / 2, within - w / 2));  // not cut at the edge
    ctx.globalAlpha = 0.85;
    ctx.fillStyle = theme.paper;
    ctx.fillRect(x - w / 2, y - 9, w, 18);
    ctx.globalAlpha = 1;
    ctx.fillStyle = theme.ink;
    ctx.fillText(text, x, y);
  }

  private paintLabels(camera: Camera, t: number): void {
    for (const {frame, text} of this.labels) {
      if (this.film.absent(frame, t)) continue;
      const [x, y] = camera.project(this.film.pose(frame, t).r);
      this.paintText(text, x, y, camera.width);
    }
  }

  private paintMeasure(camera: Camera, measure: Measure, t: number): void {
    const {ctx} = this, points = measure.points(t).map(p => camera.project(p));
    ctx.strokeStyle = ctx.fillStyle = theme.accent;
    ctx.lineWidth = 1.8;
    if (points.length === 2) ctx.stroke(pathOf(points, false));
    for (const [x, y] of points) {
      ctx.beginPath();
      ctx.arc(x, y, 4, 0, 2 * Math.PI);
      ctx.fill();
    }
    if (points.length === 2) {
      this.paintText(measure.text(t).split("   ")[0], (points[0][0] + points[1][0]) / 2, (points[0][1] + points[1][1]) / 2 - 14);
    }
  }

  private paintTrails(camera: Camera, t: number): void {
    const {film, ctx} = this;
    const last = film.indexAt(t), stride = Math.max(1, Math.ceil(last / 600));
    ctx.lineWidth = 1.4;
    for (let i = 0; i < Math.min(film.poses, 60); ++i) {
      if (!film.moves(i)) continue;
      const points: V2[] = [];
      const pass = (at: number): void => { if (!film.absent(i, at)) points.push(camera.project(film.pose(i, at).r)); };
      for (let f = 0; f <= last; f += stride) pass(film.t[f]);
      pass(t);
      ctx.strokeStyle = mixed(kPalette[i % kPalette.length], theme.dark ? 0 : 0.2);
      ctx.stroke(pathOf(points, false));
    }
  }

  /** One path a colour: a heap of grains has tens of thousands of contacts. */
  private paintContacts(camera: Camera, t: number, size: number, factor: number): void {
    const {ctx} = this, contacts = this.film.contacts(t);
    const scales = [false, true].map(impact => this.perUnit(size, factor, impact));
    const scaleOf = (c: Contact): number => scales[c.state === kImpact ? 1 : 0] * arrowFactor(c);
    const few = contacts.length <= kMostHeads, most = 0.3 * Math.min(camera.width, camera.height);
    if (contacts.length <= kMostDiscs) for (const c of contacts) this.paintCone(camera, c, scaleOf(c), most);
    const lines = kStates.map(() => new Path2D()), marks = kStates.map(() => new Path2D());
    for (const c of contacts) {
      const k = kStates[c.state] ? c.state : 0, p = camera.project(c.r);
      const q = cut(p, camera.project(add(c.r, scaled(c.F, scaleOf(c)))), most);
      if (few) {
        marks[k].moveTo(p[0] + 3, p[1]);
        marks[k].arc(p[0], p[1], 3, 0, 2 * Math.PI);
        if (Math.hypot(q[0] - p[0], q[1] - p[1]) > 3) addArrow(lines[k], marks[k], p, q);
      } else {
        lines[k].moveTo(p[0], p[1]);
        lines[k].lineTo(q[0], q[1]);
      }
    }
    ctx.lineCap = "butt";
    kStates.forEach(({colour}, k) => {
      ctx.strokeStyle = ctx.fillStyle = theme.dark ? mixed(colour, 0.2) : colour;
      ctx.lineWidth = few ? 2.4 : 1.2;
      ctx.stroke(lines[k]);
      ctx.fill(marks[k]);
    });
  }

  /** The section of the friction cone at the normal force: the tip of the force lies in this disc,
   *  on its rim when the contact slips. In a planar view it is a bar. */
  private paintCone(camera: Camera, c: Contact, perNewton: number, most: number): void {
    const N = dot(c.F, c.n);
    if (!(c.limit > 0) || !(N > 0) || c.limit > 2 * N) return;  // so wide that it tells nothing
    const {ctx} = this, colour = (kStates[c.state] ?? kStates[0]).colour;
    const p = camera.project(c.r), tip = camera.project(add(c.r, scaled(c.F, perNewton)));
    const length = Math.hypot(tip[0] - p[0], tip[1] - p[1]);
    const scale = perNewton * (length > most ? most / length : 1);
    const middle = add(c.r, scaled(c.n, N * scale)), a = across(c.n), b = cross(c.n, a);
    const rim = ring(middle, a, b, c.limit * scale, 36).map(x => camera.project(x));
    if (Math.hypot(rim[0][0] - rim[18][0], rim[0][1] - rim[18][1]) +
        Math.hypot(rim[9][0] - rim[27][0], rim[9][1] - rim[27][1]) < 5) return;
    // the two rim points that are seen farthest to the sides
    const d: V2 = [camera.project(middle)[0] - p[0], camera.project(middle)[1] - p[1]];
    const side = (x: V2): number => d[0] * (x[1] - p[1]) - d[1] * (x[0] - p[0]);
    const ordered = rim.slice().sort((x, y) => side(x) - side(y));
    ctx.fillStyle = colour + "24";
    ctx.fill(pathOf([p, ordered[0], ordered[ordered.length - 1]]));
    ctx.fill(pathOf(rim));
    ctx.strokeStyle = colour + "90";
    ctx.lineWidth = 1.2;
    ctx.stroke(pathOf(rim));
    ctx.stroke(pathOf([ordered[0], p, ordered[ordered.length - 1]], false));
  }
}

/** q, or the point at `most` pixels from p toward it. */
function cut(p: V2, q: V2, most: number): V2 {
  const length = Math.hypot(q[0] - p[0], q[1] - p[1]);
  return length > most ? [p[0] + (q[0] - p[0]) * most / length, p[1] + (q[1] - p[1]) * most / length] : q;
}

function addArrow(line: Path2D, head: Path2D, p: V2, q: V2): void {
  const phi = Math.atan2(q[1] - p[1], q[0] - p[0]);
  const size = Math.min(11, 0.6 * Math.hypot(q[0] - p[0], q[1] - p[1]));
  const back = (s: number): V2 => [q[0] - size * Math.cos(phi + s), q[1] - size * Math.sin(phi + s)];
  line.moveTo(p[0], p[1]);
  line.lineTo(q[0] - 0.8 * size * Math.cos(phi), q[1] - 0.8 * size * Math.sin(phi));
  head.addPath(pathOf([q, back(0.42), back(-0.42)]));
}

/** Directions of the inertial axes and a scale, in the lower left corner. */
function paintAxes(ctx: Context, camera: Camera): void {
  const small = camera.height < 420, o: V2 = [small ? 34 : 44, camera.height - (small ? 34 : 44)];
  const length = small ? 22 : 30;
  const axes: [string, V3, string][] = [
    ["x", [1, 0, 0], "#c2413b"], ["y", [0, 1, 0], "#3f8f46"], ["z", [0, 0, 1], theme.dark ? "#5a93d6" : "#2f6db5"]];
  axes.sort((a, b) => dot(a[1], camera.toward) - dot(b[1], camera.toward));
  ctx.font = `600 13px ${kFont}`;
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  for (const [name, axis, colour] of axes) {
    const e = [dot(axis, camera.right), -dot(axis, camera.up)];
    if (Math.hypot(e[0], e[1]) < 0.05) continue;
    ctx.strokeStyle = ctx.fillStyle = colour;
    ctx.lineWidth = 1.8;
    const line = new Path2D(), head = new Path2D();
    addArrow(line, head, o, [o[0] + e[0] * length, o[1] + e[1] * length]);
    ctx.stroke(line);
    ctx.fill(head);
    ctx.fillText(name, o[0] + e[0] * (length + 10), o[1] + e[1] * (length + 10));
  }
  const bar = niceTicks(0, 150 / camera.scale, 2).step, pixels = bar * camera.scale;
  const [x, y] = [o[0] + 2 * length + 4, camera.height - (small ? 24 : 30)];
  ctx.strokeStyle = ctx.fillStyle = theme.soft;
  ctx.lineWidth = 1.4;
  ctx.stroke(pathOf([[x, y - 4], [x, y], [x + pixels, y], [x + pixels, y - 4]], false));
  ctx.font = `12px ${kFont}`;
  ctx.fillText(lengthText(bar), x + pixels / 2, y + 11);
}

