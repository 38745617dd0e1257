// The stage: camera, pictures, overlay; which picture serves which view; pointer and touch.
import {Camera} from "./camera";
import {FlatPicture} from "./flat_picture";
import {add, sub, type V3} from "./math";
import {Overlay} from "./overlay";
import {spread, type SceneModel} from "./scene_model";
import {SpacePicture} from "./space_picture";

const kMostFlat = 400;  // more shapes than that are drawn by WebGL in planar views, too

export interface StageHandler { redraw(): void; selected(frame: number): void }

export class Stage {
  readonly camera = new Camera();
  readonly overlay: Overlay;
  readonly flat: FlatPicture;
  readonly space: SpacePicture | null = null;
  show = {contacts: true, trails: false};
  forceFactor = 1;
  selected = -1;
  followed = -1;
  private anchor: V3 = [0, 0, 0];
  private size: number;
  private ratio = 0;

  constructor(private readonly box: HTMLElement, readonly model: SceneModel, private readonly handler: StageHandler,
              webgl: string | null) {
    const canvas = (name: string): HTMLCanvasElement => box.querySelector(`#${name}`) as HTMLCanvasElement;
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
    if (this.followed >= 0) {
      const {r} = this.model.film.pose(this.followed, t);
      this.camera.centre = add(this.camera.centre, sub(r, this.anchor));
      this.anchor = r;
    }
    const used = this.spatial;
    this.flat.canvas.hidden = used !== null;
    if (this.space) this.space.canvas.hidden = used === null;
    (used ?? this.flat).draw(this.camera, t, this.selected);
    this.overlay.draw(this.camera, t, this.size, this.show, this.forceFactor);
  }

  setView(view: string): void {
    this.camera.view = view;
    this.camera.look();
    this.fit();
  }

  fit(): void {
    const points = this.followed >= 0 ? this.model.pointsAround(this.followed, this.anchor) : this.model.extent.points;
    this.size = this.followed >= 0 ? spread(points) : this.model.extent.size;
    this.camera.fit(points);
  }

  /** The camera moves with a frame from now on; −1: it stands. */
  follow(frame: number, t: number): void {
    this.followed = frame;
    if (frame >= 0) this.anchor = this.model.film.pose(frame, t).r;
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
    const {camera} = this;
    let moved = 0;
    canvas.addEventListener("pointerdown", event => {
      canvas.setPointerCapture(event.pointerId);
      canvas.classList.add("dragged");
      fingers.set(event.pointerId, [event.offsetX, event.offsetY]);
      if (fingers.size === 1) moved = 0;
    });
    canvas.addEventListener("pointermove", event => {
      const before = fingers.get(event.pointerId);
      if (!before) return;
      const [dx, dy] = [event.offsetX - before[0], event.offsetY - before[1]];
      const others = [...fingers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
      fingers.set(event.pointerId, [event.offsetX, event.offsetY]);
      moved += Math.abs(dx) + Math.abs(dy);
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
      if (event.type !== "pointerup" || !only || moved > 5) return;
      const used = this.spatial;
      const frame = used ? used.pick(camera, event.offsetX, event.offsetY) : this.pickFlat(event.offsetX, event.offsetY);
      this.handler.selected(frame);
    };
    canvas.addEventListener("pointerup", release);
    canvas.addEventListener("pointercancel", release);
    canvas.addEventListener("contextmenu", event => event.preventDefault());
    canvas.addEventListener("wheel", event => {
      event.preventDefault();
      camera.zoom(Math.exp(-0.0012 * event.deltaY), event.offsetX, event.offsetY);
      this.handler.redraw();
    }, {passive: false});
  }

  private pickFlat(x: number, y: number): number { return this.flat.pick(x, y); }
}
