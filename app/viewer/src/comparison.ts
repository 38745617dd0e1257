// The other run of a page: laid over its picture, or in a picture beside it.
import {Beside} from "./beside";
import type {Event} from "./data";
import type {OtherRun} from "./other_run";
import {spanOf} from "./film";
import {element, ledgerPanels, showHeadline} from "./panels";
import type {PlotPanel} from "./plots";
import type {Replay} from "./replay";
import type {StageHandler} from "./stage";
import {paintMarks} from "./timeline";

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
  /** Whether the second picture is below the first, as in a narrow window. */
  get stacked(): boolean { return this.isBeside && this.box.offsetTop > byId("stage").offsetTop; }

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

  /** The events of both runs in the order of their times, each with the name of its run; `own` if there is one run. */
  events(own: Event[]): Event[] {
    const {other} = this;
    if (!other) return own;
    const named = (events: Event[], run: string, second: boolean): Event[] => events.map(e => ({...e, run, other: second}));
    return [...named(own, this.replay.data.title, false), ...named(other.events, other.title, true)].sort((a, b) => a.t - b.t);
  }

  /** Panels of energies and solver, of both runs. */
  ledger(own: Map<string, Float64Array>): PlotPanel[] {
    const panels = ledgerPanels(own);
    return this.other ? this.other.addLedger(panels, this.replay.data.title) : panels;
  }

  paintMarks(own: Event[]): void { paintMarks(byId("marks"), this.events(own), this.replay.begin, this.replay.end); }

  showHead(): void {
    const {data, begin, end, film} = this.replay;
    showHeadline(byId("facts"), data, this.other ? spanOf(film, [])[1] - begin : end - begin, film.count, this.other);
  }

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
    const second = this.beside.picture(t), out = element("canvas"), {stacked} = this;
    out.width = stacked ? Math.max(first.width, second.width) : first.width + second.width;
    out.height = stacked ? first.height + second.height : Math.max(first.height, second.height);
    const ctx = out.getContext("2d") as CanvasRenderingContext2D;
    const at: [number, number] = stacked ? [0, first.height] : [first.width, 0];
    ctx.drawImage(first, 0, 0);
    ctx.drawImage(second, ...at);
    ctx.fillStyle = "#888888";
    ctx.fillRect(Math.max(0, at[0] - 1), Math.max(0, at[1] - 1), stacked ? out.width : 2, stacked ? 2 : out.height);
    return out;
  }
}
