// Another run that is laid over the one of the page: its bodies as outlines, its curves dashed.
import type {Camera} from "./camera";
import {eventsOf, ledgerOf, RecordedFilm, sceneOf, signalsOf, type Event, type PageData, type Scene, type SceneShape,
  type Signal} from "./data";
import {spanOf, type Film} from "./film";
import {kItems} from "./flat_shapes";
import {chained, type V3} from "./math";
import {kindOf, ledgerPanels} from "./panels";
import type {Curve, PlotPanel} from "./plots";
import {SceneModel} from "./scene_model";
import {colourOf, mixed, theme} from "./theme";

const kMostLaidOver = 500;  // bodies

export class OtherRun {
  private spanned: V3[] | null = null;
  private readonly bodies: SceneShape[];
  readonly leftOut: number;  // bodies that are not laid over

  private constructor(readonly title: string, readonly data: PageData, readonly scene: Scene, readonly film: Film,
                      readonly signals: Signal[], readonly events: Event[], readonly ledger: Map<string, Float64Array>) {
    const all = scene.shapes.filter(s => s.kind in kItems && s.colour !== "transparent" && s.frame >= 0);
    this.bodies = all.slice(0, kMostLaidOver);
    this.leftOut = all.length - this.bodies.length;
  }

  get begin(): number { return spanOf(this.film, this.signals)[0]; }
  get end(): number { return spanOf(this.film, this.signals)[1]; }

  /** Points that span its motion. */
  get points(): V3[] {
    this.spanned ??= new SceneModel(this.scene, this.film).extent.points;
    return this.spanned;
  }

  frameNamed(name: string | undefined): number { return name === undefined ? -1 : this.scene.frames.findIndex(f => f.name === name); }

  /** From the text of a replay.html. */
  static async fromPage(html: string, name: string): Promise<OtherRun> {
    const text = new DOMParser().parseFromString(html, "text/html").getElementById("data")?.textContent;
    if (!text) throw new Error("it holds no run");
    return OtherRun.from(JSON.parse(text) as PageData, name);
  }

  static async from(data: PageData, name: string): Promise<OtherRun> {
    const [scene, film, signals, events, ledger] = await Promise.all(
      [sceneOf(data), RecordedFilm.from(data.frames), signalsOf(data), eventsOf(data), ledgerOf(data)]);
    return new OtherRun(data.title || name, data, scene, film, signals, events, ledger);
  }

  /** Its bodies at t over the picture: transparent, so that both are seen. */
  paint(ctx: CanvasRenderingContext2D, camera: Camera, t: number): void {
    ctx.save();
    ctx.globalAlpha = 0.4;
    const there = this.bodies.filter(s => !this.film.absent(s.frame, t) && !this.film.absent(s.frameEnd ?? -1, t));
    const items = there.map(shape => ({shape, item: kItems[shape.kind](shape,
      chained(this.film.pose(shape.frame, t), shape.position, shape.orientation), this.film.pose(shape.frameEnd ?? -1, t))}));
    items.sort((a, b) => camera.depth(a.item.centre) - camera.depth(b.item.centre));
    for (const {shape, item} of items) {
      const path = item.paint(ctx, camera, mixed(colourOf(shape), theme.dark ? -0.3 : 0.4));
      ctx.setLineDash([5, 4]);
      ctx.strokeStyle = theme.ink;
      ctx.lineWidth = 1.5;
      ctx.stroke(path);
      ctx.setLineDash([]);
    }
    ctx.restore();
  }

  /** Its curves beside those of the same name, which get the name of their run, too. */
  addTo(panels: PlotPanel[], title: string): PlotPanel[] {
    return this.merged(panels.map(panel => ({panel, theirs: this.signals})), title);
  }

  /** The same of energies and solver: panels of both runs that have the same title and unit. */
  addLedger(panels: PlotPanel[], title: string): PlotPanel[] {
    const own = ledgerPanels(this.ledger), same = (a: PlotPanel, b: PlotPanel): boolean => kindOf(a) === kindOf(b);
    const alone = own.filter(p => !panels.some(q => same(p, q)));
    return this.merged([...panels.map(panel => ({panel, theirs: own.find(p => same(p, panel))?.curves ?? []})),
      ...alone.map(p => ({panel: {...p, curves: []}, theirs: p.curves}))], title, true);
  }

  /** `all`: also curves that the panel has not. */
  private merged(pairs: {panel: PlotPanel; theirs: Curve[]}[], title: string, all = false): PlotPanel[] {
    const named = (name: string, run: string): string => run ? `${name} (${run})` : name;
    return pairs.map(({panel, theirs: found}) => {
      const more = all ? found.filter(s => !panel.curves.some(c => c.name === s.name)) : [];
      const curves = [...panel.curves, ...more].flatMap((c, k) => {
        const own = found.find(s => s.name === c.name);
        return own ? [{name: named(c.name, this.title), t: own.t, y: own.y, dashed: true, colour: panel.curves.length + k}] : [];
      });
      const first = curves.length > 0 ? panel.curves.map(c => ({...c, name: named(c.name, title)})) : panel.curves;
      return {...panel, curves: [...first, ...curves]};
    });
  }
}
