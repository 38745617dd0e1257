// Another run in a picture of its own beside that of the page: the same time, the same view, the same scale of
// forces. What is moved, hidden, named or selected in one is so in both.
import type {Film} from "./film";
import type {OtherRun} from "./other_run";
import {element} from "./panels";
import {add, sub} from "./math";
import {SceneModel} from "./scene_model";
import {Stage, type StageHandler} from "./stage";
import type {Scene} from "./data";

export class Beside {
  readonly stage: Stage;
  private hidden: ReadonlySet<number> = new Set();

  constructor(box: HTMLElement, readonly other: OtherRun, private readonly first: Stage, private readonly scene: Scene,
              handler: StageHandler, webgl: string | null) {
    const canvases = ["space", "flat", "overlay"].map(name => element("canvas", "", name));
    canvases[2].setAttribute("aria-label", "motion of the other run");
    box.replaceChildren(...canvases);
    this.stage = new Stage(box, new SceneModel(other.scene, other.film),
      {...handler, selected: frame => handler.selected(this.frameOf(frame))}, webgl, first);
    this.stage.overlay.axes = false;  // those of the first picture are the same
  }

  /** The frame of the page's run with the name of a frame of the other run; −1: none. */
  private frameOf(frame: number): number {
    const named = this.other.scene.frames[frame]?.name;
    return named === undefined ? -1 : this.scene.frames.findIndex(f => f.name === named);
  }

  private twin(frame: number): number { return this.other.frameNamed(this.scene.frames[frame]?.name); }

  /** Takes over what is chosen in the first picture, and draws. */
  draw(t: number): void {
    this.adopt(t);
    this.stage.draw(t);
  }

  picture(t: number): HTMLCanvasElement {
    this.adopt(t);
    return this.stage.picture(t);
  }

  private adopt(t: number): void {
    const {first, stage} = this, {width, height, perspective} = stage.camera;
    Object.assign(stage.camera, first.camera, {width, height, perspective});
    const followed = this.twin(first.followed);
    if (followed >= 0) {
      const here = this.other.film.pose(followed, t).r, there = first.model.film.pose(first.followed, t).r;
      stage.camera.centre = add(first.camera.centre, sub(here, there));
    }
    Object.assign(stage, {show: first.show, forceFactor: first.forceFactor, selected: this.twin(first.selected)});
    stage.overlay.usualForce = first.overlay.usualForce || this.own(f => f.usualForce());
    stage.overlay.usualImpact = first.overlay.usualImpact || this.own(f => f.usualImpact());
    stage.overlay.labels = first.overlay.labels.map(({frame, text}) => ({frame: this.twin(frame), text})).filter(l => l.frame >= 0);
    if (first.flat.hidden === this.hidden) return;
    this.hidden = first.flat.hidden;
    stage.hide(new Set([...this.hidden].map(f => this.twin(f)).filter(f => f >= 0)));
  }

  private own(size: (film: Film) => number): number { return size(this.other.film); }

  /** Ends the picture: a page may have only a few contexts of WebGL. */
  close(): void { this.stage.space?.dispose(); }
}
