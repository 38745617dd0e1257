// What a person does with bodies of a picture: hide them, write their names, measure between them, lay
// another run over them.
import type {Scene} from "./data";
import {Measure} from "./measure";
import {OtherRun} from "./other_run";
import {element} from "./panels";
import type {Stage} from "./stage";

export class BodyTools {
  readonly measure: Measure;
  other: OtherRun | null = null;
  private readonly hidden = new Set<number>();
  private named = new Set<number>();
  onNames: (any: boolean) => void = () => undefined;
  unknown: string[] = [];  // names in the address that no body has
  private readonly said = element("p", "", "measured");
  private readonly file = element("input");
  private readonly all = element("button", "show all");

  constructor(private readonly stage: Stage, private readonly scene: Scene, private readonly redraw: () => void) {
    this.measure = new Measure(stage.model.film);
    stage.overlay.measure = this.measure;
    const box = document.getElementById("stage") as HTMLElement;
    this.said.setAttribute("role", "status");
    this.said.hidden = true;
    this.all.hidden = true;
    this.all.title = "show the bodies that are hidden (shift h)";
    this.all.onclick = () => this.showAll();
    this.file.type = "file";
    this.file.accept = ".html";
    this.file.hidden = true;
    this.file.setAttribute("aria-label", "replay.html of another run");
    box.append(this.said, this.file);
    (document.getElementById("switches") as HTMLElement).append(this.all);
  }

  /** Buttons of the card of a body. */
  buttons(frame: number): HTMLElement {
    const row = element("p", "", "acts");
    const button = (text: string, title: string, act: () => void): void => {
      const b = element("button", text);
      b.title = title;
      b.onclick = act;
      row.append(b);
    };
    button("hide", "do not show this body (h)", () => this.hide(frame));
    button("others", "show this body alone, or all again", () => this.hideOthers(frame));
    button("name", "write its name into the picture", () => this.name(frame));
    return row;
  }

  get names(): string[] { return this.scene.frames.map(f => f.name); }
  get labelled(): string[] { return this.namesOf(this.named); }
  get unseen(): string[] { return this.namesOf(this.hidden); }
  private namesOf(frames: Set<number>): string[] { return [...frames].map(i => this.scene.frames[i].name); }

  /** The bodies that a list of the address names, "lid,box"; what is no name of a body goes to `unknown`. */
  private framesIn(list: string): number[] {
    const names = list.split(",").map(x => x.trim()).filter(x => x), found = names.map(name => this.names.indexOf(name));
    this.unknown.push(...names.filter((_, i) => found[i] < 0));
    return found.filter(i => i >= 0);
  }

  /** `names`: "1" all, "0" none, or names of bodies; `hide`: bodies that are not shown. null: as it is. */
  choose(names: string | null, hide: string | null): void {
    this.unknown = [];
    if (names !== null) this.named = new Set(names === "1" ? this.nameable() : names === "0" ? [] : this.framesIn(names));
    if (hide !== null) {
      this.hidden.clear();
      this.framesIn(hide).forEach(i => this.hidden.add(i));
    }
    if (names !== null || hide !== null) this.apply();
  }

  hide(frame: number): void {
    if (frame < 0) return;
    this.hidden.add(frame);
    this.apply();
  }

  private hideOthers(frame: number): void {
    const all = this.scene.frames.map((_, i) => i).filter(i => i !== frame);
    if (all.every(i => this.hidden.has(i))) { this.showAll(); return; }
    this.hidden.clear();
    all.forEach(i => this.hidden.add(i));
    this.apply();
  }

  showAll(): void {
    this.hidden.clear();
    this.apply();
  }

  private name(frame: number): void {
    if (!this.named.delete(frame)) this.named.add(frame);
    this.apply();
  }

  /** The names of all bodies, or of none. Of many only the first hundred: more cannot be read. */
  nameAll(): void {
    this.named = new Set(this.named.size ? [] : this.nameable());
    this.apply();
  }

  private nameable(): number[] {
    return this.scene.frames.map((_, i) => i).filter(i => this.stage.model.bodies.some(s => s.frame === i)).slice(0, 100);
  }

  private apply(): void {
    this.stage.hide(new Set(this.hidden));
    this.stage.overlay.labels = [...this.named].filter(i => !this.hidden.has(i)).map(frame => ({frame, text: this.scene.frames[frame].name}));
    this.all.hidden = !this.hidden.size;
    this.onNames(this.named.size > 0);
    this.redraw();
  }

  // --- measuring

  toggleMeasure(): boolean {
    this.measure.on = !this.measure.on;
    this.measure.clear();
    this.said.hidden = !this.measure.on;
    this.redraw();
    return this.measure.on;
  }

  /** A click while measuring; false: nothing is measured now. */
  clicked(x: number, y: number, t: number): boolean {
    if (!this.measure.on) return false;
    const hit = this.stage.hitAt(x, y);
    this.measure.take(hit?.frame ?? -1, hit?.point ?? this.stage.camera.unproject(x, y), t);
    this.redraw();
    return true;
  }

  show(t: number): void {
    if (this.measure.on) this.said.textContent = this.measure.text(t);
  }

  // --- another run

  /** Asks for the replay of another run. */
  askForOther(take: (other: OtherRun) => void, fail: (fault: string) => void): void {
    const {file} = this;
    file.onchange = async () => {
      const chosen = file.files?.[0];
      file.onchange = null;
      if (!chosen) return;
      try {
        take(await OtherRun.fromPage(await chosen.text(), chosen.name));
      } catch (error) {
        fail(`${chosen.name} is no replay of dynamY: ${error instanceof Error ? error.message : error}`);
      }
      file.value = "";
    };
    file.click();
  }
}
