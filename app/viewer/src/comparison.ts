// The other run of a page: laid over its picture, or in a picture beside it.
import {Beside} from "./beside";
import type {OtherRun} from "./other_run";
import {element} from "./panels";
import type {Replay} from "./replay";
import type {StageHandler} from "./stage";

const byId = <T extends HTMLElement = HTMLElement>(id: string): T => document.getElementById(id) as T;

export class Comparison {
  other: OtherRun | null = null;
  beside: Beside | null = null;
  private readonly box = byId("beside");
  private readonly captions = ["stage", "beside"].map(() => element("p", "", "caption"));

  constructor(private readonly replay: Replay, private readonly handler: StageHandler, private readonly webgl: string | null,
              private apart: boolean) {
    byId("stages").append(...this.captions);
  }

  get isBeside(): boolean { return this.beside !== null; }

  /** Shows another run, or none. */
  show(other: OtherRun | null): void {
    this.other = other;
    this.apply();
  }

  /** Beside the first picture, or laid over it. */
  setApart(on: boolean): void {
    this.apart = on;
    this.apply();
  }

  /** The runs by name: one text under each picture; none if there is one run. */
  get names(): string[] { return this.captions.filter(p => !p.hidden).map(p => p.textContent ?? ""); }

  private apply(): void {
    const {stage, scene} = this.replay, {other} = this, two = other !== null && this.apart;
    this.beside?.close();
    this.beside = null;
    this.box.hidden = !two;
    byId("stages").classList.toggle("two", two);
    if (two) this.beside = new Beside(this.box, other, stage, scene, this.handler, this.webgl);
    stage.overlay.other = two ? null : other;
    stage.besides = other ? other.points : [];
    const own = this.replay.data.title, left = other?.leftOut ?? 0;
    const dashed = left > 0 && other ? `dashed: ${other.title}, without ${left} of its bodies` : `dashed: ${other?.title ?? ""}`;
    this.captions.forEach((p, i) => {
      p.hidden = !other || (i === 1 && !two);
      p.textContent = two ? (i === 0 ? own : other.title) : dashed;
    });
    this.resize();
    if (!stage.touched) stage.fit();
  }

  draw(t: number): void { this.beside?.draw(t); }
  resize(): boolean {
    const first = this.replay.stage.resize();
    return this.beside?.stage.resize() || first;
  }

  /** Both pictures in one, for a file. */
  picture(t: number): HTMLCanvasElement {
    const first = this.replay.stage.picture(t);
    if (!this.beside) return first;
    const second = this.beside.picture(t), out = element("canvas"), gap = 2;
    out.width = first.width + gap + second.width;
    out.height = Math.max(first.height, second.height);
    const ctx = out.getContext("2d") as CanvasRenderingContext2D;
    ctx.fillStyle = "#888888";
    ctx.fillRect(0, 0, out.width, out.height);
    ctx.drawImage(first, 0, 0);
    ctx.drawImage(second, first.width + gap, 0);
    return out;
  }
}
