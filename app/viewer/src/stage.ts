// The stage: camera, pictures, overlay; which picture serves which view; pointer and touch.
import {Camera} from "./camera";
import {FlatPicture} from "./flat_picture";
import {add, dot, scaled, sub, type V3} from "./math";
import {Overlay} from "./overlay";
import {spread, type SceneModel} from "./scene_model";
import {SpacePicture} from "./space_picture";

const kMostFlat = 400;  // more shapes than that are drawn by WebGL in planar views, too

/** A point of a body, seen at a place of the picture. */
export interface Grabbed { frame: number; point: V3; local?: V3 }
export interface StageHandler { redraw(): void; selected(frame: number): void; clicked(x: number, y: number): boolean }
/** Who takes a body that is pulled; null: nobody, the pointer moves the view. */
export interface HandHandler {
  grab(at: Grabbed): Promise<void>; move(target: V3): void; release(): void; pointAt(x: number, y: number, through: V3): V3;
  readonly goes: boolean; readonly line: [V3, V3] | null;
}

export class Stage {
  readonly camera = new Camera();
  readonly overlay: Overlay;
  readonly flat: FlatPicture;
  readonly space: SpacePicture | null = null;
  show = {contacts: true, trails: false};
  forceFactor = 1;
  selected = -1;
  followed = -1;
  hand: HandHandler | null = null;
  touched = false;  // somebody has moved the view
  besides: V3[] = [];  // what else belongs into the picture: another run
  private t = 0;  // of the picture
  private anchor: V3 = [0, 0, 0];
  private size: number;
  private ratio = 0;

  constructor(private readonly box: HTMLElement, readonly model: SceneModel, private readonly handler: StageHandler,
              webgl: string | null, private readonly lead: Stage | null = null) {
    const canvas = (name: string): HTMLCanvasElement => box.querySelector(`canvas.${name}`) as HTMLCanvasElement;
    this.flat = new FlatPicture(canvas("flat"), model);
    this.overlay = new Overlay(canvas("overlay"), model.film);
    if (webgl !== "0") {
      try {
        this.space = new SpacePicture(canvas("space"), model, webgl === "fine");
      } catch {
        console.info("no WebGL: plain canvas");
      }
    }
    this.camera.perspective = this.space !== null;
    this.camera.upAxis = model.upAxis;
    if (model.upAxis === 1) this.camera.azimuth = 28 * Math.PI / 180;
    this.size = model.extent.size;
    this.addPointer(this.overlay.canvas);
  }

  private get spatial(): SpacePicture | null {
    return this.camera.isPlanar && this.model.bodies.length <= kMostFlat ? null : this.space;
  }

  draw(t: number): void {
    this.t = t;
    if (this.followed >= 0 && !this.model.film.absent(this.followed, t)) {
      const {r} = this.model.film.pose(this.followed, t);
      this.camera.centre = add(this.camera.centre, sub(r, this.anchor));
      this.anchor = r;
    }
    const used = this.spatial;
    this.flat.canvas.hidden = used !== null;
    if (this.space) this.space.canvas.hidden = used === null;
    (used ?? this.flat).draw(this.camera, t, this.selected);
    this.overlay.hand = this.hand?.line ?? null;
    this.overlay.draw(this.camera, t, this.lead?.size ?? this.size, this.show, this.forceFactor);
  }

  setView(view: string): void {
    this.camera.view = view;
    this.camera.look();
    this.fit();
  }

  fit(): void {
    const points = this.followed >= 0 ? this.model.pointsAround(this.followed, this.anchor) : [...this.model.extent.points, ...this.besides];
    this.size = this.followed >= 0 ? spread(points) : this.model.extent.size;
    this.camera.fit(points);
  }

  /** The camera moves with a frame from now on; −1: it stands. */
  follow(frame: number, t: number): void {
    this.followed = frame;
    if (frame >= 0) this.anchor = this.model.film.pose(frame, t).r;
  }

  /** Bodies of these frames are not shown. */
  hide(frames: ReadonlySet<number>): void {
    this.flat.hidden = frames;
    this.space?.hide(frames);
  }

  /** Newtons, or newton seconds of impacts, that an arrow of 1 cm on the screen stands for (96 pixels an inch); 0: there is none. */
  unitsPerCm(impact: boolean): number {
    const pixels = this.overlay.perUnit(this.size, this.forceFactor, impact) * this.camera.scale;
    return pixels > 0 ? 96 / 2.54 / pixels : 0;
  }

  recolour(): void {
    this.flat.recolour();
    this.space?.recolour();
  }

  /** Fits the canvases to the box; whether that changed them. */
  resize(): boolean {
    const ratio = Math.min(window.devicePixelRatio || 1, 2), {clientWidth: w, clientHeight: h} = this.box;
    if (!w || !h || (w === this.camera.width && h === this.camera.height && ratio === this.ratio)) return false;
    this.ratio = ratio;
    const first = this.camera.width <= 1;
    for (const p of [this.flat, this.space, this.overlay]) p?.resize(w, h, ratio);
    const grown = Math.min(w / this.camera.width, h / this.camera.height);
    this.camera.width = w;
    this.camera.height = h;
    if (!first) this.camera.scale *= grown;
    return true;
  }

  /** The picture with what lies over it, for a file. */
  picture(t: number): HTMLCanvasElement {
    this.draw(t);
    const out = document.createElement("canvas"), under = this.spatial ? this.spatial.canvas : this.flat.canvas;
    out.width = under.width;
    out.height = under.height;
    const ctx = out.getContext("2d") as CanvasRenderingContext2D;
    ctx.drawImage(under, 0, 0);
    ctx.drawImage(this.overlay.canvas, 0, 0, out.width, out.height);
    return out;
  }

  private addPointer(canvas: HTMLCanvasElement): void {
    const fingers = new Map<number, [number, number]>();
    const {camera} = this.lead ?? this;  // two pictures are moved together
    let moved = 0, held: V3 | null = null;
    canvas.addEventListener("pointerdown", event => {
      canvas.setPointerCapture(event.pointerId);
      canvas.classList.add("dragged");
      fingers.set(event.pointerId, [event.offsetX, event.offsetY]);
      if (fingers.size === 1) moved = 0;
      const at = this.hand?.goes && !this.overlay.measure?.on && fingers.size === 1 && !event.shiftKey && event.button === 0
        ? this.hitAt(event.offsetX, event.offsetY) : null;
      held = at?.point ?? null;
      if (at) void this.hand?.grab(at);
    });
    canvas.addEventListener("pointermove", event => {
      const before = fingers.get(event.pointerId);
      if (!before) return;
      const [dx, dy] = [event.offsetX - before[0], event.offsetY - before[1]];
      const others = [...fingers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
      fingers.set(event.pointerId, [event.offsetX, event.offsetY]);
      moved += Math.abs(dx) + Math.abs(dy);
      if (held) {
        this.hand?.move(this.hand.pointAt(event.offsetX, event.offsetY, held));
        this.handler.redraw();
        return;
      }
      (this.lead ?? this).touched = true;
      if (others.length) {  // two fingers: zoom about the other one, and move
        const gap = (x: number, y: number): number => Math.hypot(x - others[0][0], y - others[0][1]) || 1;
        camera.zoom(gap(event.offsetX, event.offsetY) / gap(before[0], before[1]), others[0][0], others[0][1]);
        camera.pan(dx / 2, dy / 2);
      } else if (camera.isPlanar || event.shiftKey || event.buttons > 1) {
        camera.pan(dx, dy);
      } else {
        camera.orbit(dx, dy);
      }
      this.handler.redraw();
    });
    const release = (event: PointerEvent): void => {
      const only = fingers.size === 1;
      fingers.delete(event.pointerId);
      canvas.classList.remove("dragged");
      if (held) {
        held = null;
        this.hand?.release();
        this.handler.redraw();
      }
      if (event.type !== "pointerup" || !only || moved > 5) return;
      if (this.handler.clicked(event.offsetX, event.offsetY)) return;
      const used = this.spatial;
      const frame = used ? used.pick(this.camera, event.offsetX, event.offsetY) : this.pickFlat(event.offsetX, event.offsetY);
      this.handler.selected(frame);
    };
    canvas.addEventListener("pointerup", release);
    canvas.addEventListener("pointercancel", release);
    canvas.addEventListener("contextmenu", event => event.preventDefault());
    canvas.addEventListener("wheel", event => {
      event.preventDefault();
      (this.lead ?? this).touched = true;
      camera.zoom(Math.exp(-0.0012 * event.deltaY), event.offsetX, event.offsetY);
      this.handler.redraw();
    }, {passive: false});
  }

  /** What is seen at (x, y), with the point; null: no body. */
  hitAt(x: number, y: number): Grabbed | null {
    const {camera} = this, used = this.spatial;
    if (used) {
      const hit = used.hit(camera, x, y);
      return hit.frame >= 0 ? hit : null;
    }
    const frame = this.pickFlat(x, y);
    if (frame < 0) return null;
    const {r} = this.model.film.pose(frame, this.t), s = camera.scaleAt(r) || camera.scale;
    const depth = dot(sub(r, camera.centre), camera.toward);
    return {frame, point: add(camera.centre, add(scaled(camera.toward, depth), add(
      scaled(camera.right, (x - camera.width / 2) / s), scaled(camera.up, (camera.height / 2 - y) / s))))};
  }

  private pickFlat(x: number, y: number): number { return this.flat.pick(x, y); }
}
