// The page: time, buttons, keys, panels, address.
import {copyLink, readAddress} from "./address";
import {fillCard} from "./body_card";
import {BodyTools} from "./body_tools";
import {Comparison} from "./comparison";
import type {Event, PageData, Scene, Signal} from "./data";
import type {Film} from "./film";
import type {Live, LiveFeed} from "./live";
import {FilmStudio, saveFilm} from "./film_file";
import {kPauseIcon, kPlayIcon, kSpeeds, kThemeIcon, kViews} from "./labels";
import {clamp, shortNumber} from "./math";
import type {OtherRun} from "./other_run";
import {checksOf, element, EventList, fillHelp, modelText, tableOf, turned} from "./panels";
import {panelsOf, Plots} from "./plots";
import {spanOf} from "./film";
import {SceneModel} from "./scene_model";
import {Stage, type StageHandler} from "./stage";
import {kStates, mixed, theme, useTheme} from "./theme";

const byId = <T extends HTMLElement = HTMLElement>(id: string): T => document.getElementById(id) as T;

export class Replay {
  readonly stage: Stage;
  readonly studio = new FilmStudio(this);
  begin: number;
  end: number;
  live: Live | null = null;
  readonly tools: BodyTools;
  readonly comparison: Comparison;
  t: number;
  private playing = false;
  private queued = false;
  private tab = "";
  private readonly plots: Plots;
  private readonly energy: Plots;
  private readonly list: EventList;
  private readonly model: SceneModel;
  private sizes = "";
  private named: Record<string, HTMLButtonElement> = {};

  constructor(readonly data: PageData, readonly scene: Scene, readonly film: Film, private readonly signals: Signal[],
              private readonly events: Event[], private ledger: Map<string, Float64Array>, address: URLSearchParams,
              private readonly grows = false) {
    [this.begin, this.end] = spanOf(film, signals);
    this.t = this.begin;
    const wanted = address.get("theme");
    useTheme(wanted ? wanted === "dark" : matchMedia("(prefers-color-scheme: dark)").matches);
    document.documentElement.classList.toggle("dark", theme.dark);
    this.model = new SceneModel(scene, film);
    const handler: StageHandler = {redraw: () => this.draw(), selected: frame => this.select(frame), clicked: () => false};
    this.stage = new Stage(byId("stage"), this.model,
      {...handler, clicked: (x, y) => this.tools.clicked(x, y, this.t)}, address.get("webgl"));
    this.tools = new BodyTools(this.stage, scene, () => this.draw());
    this.comparison = new Comparison(this, handler, address.get("webgl"), address.get("beside") === "1");
    const follow = scene.follow ?? -1;
    this.stage.follow(follow < film.poses ? follow : -1, this.t);
    const seek = (t: number): void => { this.pause().seek(t); };
    this.plots = new Plots(byId("plots"), panelsOf(signals), this.begin, this.end, seek);
    this.energy = new Plots(byId("energy"), this.comparison.ledger(ledger), this.begin, this.end, seek);
    this.list = new EventList(byId("events"), events, Number(data.run?.eventsLeftOut ?? 0), seek);
    const main = document.querySelector("main") as HTMLElement;
    main.classList.toggle("alone", !grows && !signals.length && !data.model.text && !data.run);
    main.classList.toggle("unseen", !scene.shapes.length && signals.length > 0);
    this.fillPanels(ledger.size > 0);
    this.addTransport();
    this.addTools();
    document.addEventListener("keydown", event => this.key(event));
    new ResizeObserver(() => this.resize()).observe(byId("stage"));
    new ResizeObserver(() => this.resize()).observe(byId("side"));
    window.addEventListener("hashchange", () => readAddress(this, new URLSearchParams(location.hash.slice(1))));
    this.comparison.resize();
    this.setView(this.model.naturalView());
    this.resize();
    readAddress(this, address);
  }

  /** A run that goes on: more of it is there. `slowly`: time for curves and for what needs all frames. */
  grow(feed: LiveFeed, slowly: boolean): void {
    const {film, stage} = this, views = film.count < 40 && !stage.touched;
    this.end = Math.max(this.end, film.end);
    if (views && this.model.naturalView() !== stage.camera.view) this.setView(this.model.naturalView());
    if (!slowly) return;
    if (this.model.remeasure()) {
      stage.space?.remeasured();
      if (!stage.touched) stage.fit();
    }
    stage.overlay.usualForce = film.usualForce();
    stage.overlay.usualImpact = film.usualImpact();
    this.plots.grow(this.begin, this.end);
    this.ledger = feed.ledgerColumns();
    this.energy.grow(this.begin, this.end, this.comparison.ledger(this.ledger));
    this.list.take(this.comparison.events(this.events));
    for (const id of ["before", "after"]) byId<HTMLButtonElement>(id).disabled = !this.events.length;
    this.comparison.showHead();
    this.fillLegend();
    this.comparison.paintMarks(this.events);
    this.draw();
  }

  /** The run has ended, with these facts: from now on the page is a replay. */
  ended(run: Record<string, unknown>): void {
    this.data.run = run;
    this.comparison.showHead();
    byId("run").replaceChildren(...[checksOf(run), tableOf(run)].filter((e): e is HTMLElement => e !== null));
    this.addTab("run", "Run");
    this.draw();
  }

  get title(): string {
    const {run, title} = this.data;
    return run && typeof run.title === "string" && run.title ? run.title : title;
  }

  // --- time

  seek(t: number): this {
    this.t = clamp(t, this.begin, this.end);
    this.draw();
    return this;
  }

  play(): void {
    if (this.playing) return;
    if (this.live) this.live.atEdge = false;
    if (this.t >= this.end) this.t = this.begin;
    this.playing = true;
    byId("play").innerHTML = kPauseIcon;
    let before = performance.now();
    const tick = (now: number): void => {
      if (!this.playing) return;
      let t = this.t + (now - before) / 1000 * Number(byId<HTMLSelectElement>("speed").value);
      before = now;
      if (t > this.end) {
        if (byId<HTMLInputElement>("loop").checked && this.end > this.begin) {
          t = this.begin + (t - this.begin) % (this.end - this.begin);
        } else {
          this.pause();
        }
      }
      this.seek(t);
      if (this.playing) requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  /** `leaves`: a live run is looked at in the past from now on. */
  pause(leaves = true): this {
    if (leaves && this.live) this.live.atEdge = false;
    this.playing = false;
    byId("play").innerHTML = kPlayIcon;
    return this;
  }

  toggle(): void { if (this.playing) this.pause(); else this.play(); }

  /** To the next or the previous recorded frame. */
  step(by: number): void {
    this.pause();
    if (!this.film.count) return;
    const f = this.film.indexAt(this.t), between = this.t > this.film.t[f];
    this.seek(this.film.t[clamp(by < 0 && between ? f : f + by, 0, this.film.count - 1)]);
  }

  /** To the next or the previous impact or switch. */
  jump(by: number): void {
    const found = this.list.from(this.t, by, 1e-9 * (this.end - this.begin));
    if (found) this.pause().seek(found.t);
  }

  private faster(by: number): void {
    const select = byId<HTMLSelectElement>("speed");
    select.selectedIndex = clamp(select.selectedIndex + by, 0, kSpeeds.length - 1);
  }

  // --- picture

  /** Draws once before the next frame of the screen, however often it is asked for. */
  draw(): void {
    if (this.queued) return;
    this.queued = true;
    requestAnimationFrame(() => {
      this.queued = false;
      this.drawNow();
    });
  }

  drawNow(): void {
    this.stage.draw(this.t);
    this.comparison.draw(this.t);
    if (this.tab === "plots") this.plots.draw(this.t);
    if (this.tab === "energy") this.energy.draw(this.t);
    if (this.tab === "events") this.list.show(this.t);
    const scrub = byId<HTMLInputElement>("scrub");
    scrub.value = String(this.end > this.begin ? (this.t - this.begin) / (this.end - this.begin) : 0);
    const digits = clamp(4 - Math.floor(Math.log10(this.end - this.begin || 1)), 0, 9);
    scrub.setAttribute("aria-valuetext", `${this.t.toFixed(digits)} s of ${this.end.toFixed(digits - 1)} s`);
    byId("clock").replaceChildren(this.t.toFixed(digits), element("small", ` / ${this.end.toFixed(digits - 1)} s`));
    this.fillCard();
    this.tools.show(this.t);
    this.showScale();
  }

  /** How large the forces and percussions are that the arrows stand for. */
  private showScale(): void {
    const text = ([["force", false], ["impact", true]] as const).map(([name, impact]) => {
      const n = this.stage.unitsPerCm(impact), unit = impact && this.film.knowsSteps ? "N s" : "N";
      return n > 0 ? `${name} 1 cm = ${shortNumber(Number(n.toPrecision(2)))} ${unit}` : "";
    }).filter(x => x).join("  \u00b7  ");
    const scale = byId("legend").querySelector(".scale");
    if (scale && scale.textContent !== text) scale.textContent = text;
  }

  /** A canvas of a new size is empty: it is drawn before the browser shows it, not a frame later. */
  private resize(): void {
    const sizes = ["stage", "beside", "side"].map(id => `${byId(id).clientWidth} ${byId(id).clientHeight}`).join();
    if (sizes === this.sizes) return;
    this.sizes = sizes;
    const changed = this.comparison.resize();
    this.showTab(this.tab);
    if (changed) this.drawNow();
    this.comparison.paintMarks(this.events);
  }

  setView(view: string): void {
    this.stage.setView(view in kViews ? view : "iso");
    for (const button of byId("views").children) {
      turned(button, (button as HTMLElement).dataset.view === this.stage.camera.view);
    }
    this.draw();
  }

  setSwitch(name: "contacts" | "trails", on: boolean): void {
    this.stage.show[name] = on;
    turned(byId("switches").querySelector(`[data-name=${name}]`), on);
    byId("legend").hidden = !(this.stage.show.contacts && (this.grows || this.film.contactCount));
    this.draw();
  }

  /** The camera goes with what is selected, or with what the model names; or it stands again. */
  setFollow(on: boolean): void {
    const {stage} = this, named = this.scene.follow ?? this.film.firstMoving();
    stage.follow(on ? (stage.selected >= 0 ? stage.selected : named) : -1, this.t);
    if (stage.selected < 0) stage.fit();
    turned(byId("switches").querySelector("[data-name=follow]"), stage.followed >= 0);
    this.draw();
  }

  setTheme(dark: boolean): void {
    useTheme(dark);
    document.documentElement.classList.toggle("dark", dark);
    this.stage.recolour();
    this.comparison.beside?.stage.recolour();
    this.plots.rebuild();
    this.energy.rebuild();
    this.comparison.paintMarks(this.events);
    this.fillLegend();
    this.draw();
  }

  /** Shows name, place in the model and state of a frame; one that does not exist: of none. */
  select(frame: number): void {
    this.stage.selected = this.scene.frames[frame] ? frame : -1;
    const box = byId("selected"), known = this.scene.frames[frame];
    box.replaceChildren();
    if (known) {
      const close = element("button", "\u00d7", "close");
      close.onclick = () => this.select(-1);
      box.append(close, element("b", known.name));
      if (known.place) {
        const place = element("a", known.place);
        place.onclick = () => this.showLine(known.place);
        box.append(place);
      }
      box.append(this.tools.buttons(frame), element("table"));
    }
    this.fillCard();
    this.draw();
  }

  private fillCard(): void {
    const {selected} = this.stage, box = byId("selected");
    box.hidden = selected < 0;
    if (selected < 0) return;
    fillCard(box.querySelector("table") as HTMLTableElement, this.scene, this.film, this.signals, selected, this.t, this.comparison.other);
  }

  // --- panels

  private fillPanels(ledger: boolean): void {
    const {run, model} = this.data, named = this.title;
    byId("title").textContent = named;
    byId("title").title = named;
    document.title = `${named} \u00b7 dynamY ${this.grows ? "live" : "replay"}`;
    if (this.grows) (document.querySelector(".brand span") as HTMLElement).textContent = "live";
    this.comparison.showHead();
    if (run) byId("run").append(...[checksOf(run), tableOf(run)].filter((e): e is HTMLElement => e !== null));
    if (model.text) byId("model").append(modelText(model.text));
    byId("theme").innerHTML = kThemeIcon;
    byId("theme").onclick = () => this.setTheme(!theme.dark);
    this.fillLegend();
    fillHelp(byId<HTMLDialogElement>("help"));
    const tabs: [string, string, boolean][] = [
      ["live", "Live", this.grows],
      ["plots", "Signals", this.signals.length > 0], ["energy", "Energy, solver", ledger || this.grows],
      ["events", "Events", this.events.length > 0 || this.grows], ["run", "Run", run !== null], ["model", "Model", model.text !== ""]];
    for (const [id, text, there] of tabs) if (there) this.addTab(id, text);
    byId("wait").hidden = true;
  }

  private addTab(id: string, text: string): void {
    const button = element("button", text);
    button.id = `tab_${id}`;
    button.dataset.tab = id;
    button.setAttribute("role", "tab");
    button.setAttribute("aria-controls", id);
    button.onclick = () => this.showTab(id);
    byId("tabs").append(button);
    byId(id).setAttribute("role", "tabpanel");
    byId(id).setAttribute("aria-labelledby", button.id);
    if (!this.tab) this.tab = id;
  }

  private fillLegend(): void {
    const spins = this.events.some(e => e.to === "spin");
    byId("legend").replaceChildren(...kStates.slice(1, spins ? 5 : 4).map(s => {
      const span = element("span"), line = element("i");
      line.style.background = theme.dark ? mixed(s.colour, 0.2) : s.colour;
      span.append(line, s.name);
      return span;
    }), element("span", "", "scale"));
    (byId("legend").lastElementChild as HTMLElement).title =
      "of arrows in the plane through the middle of the picture; the arrow of an impact is its percussion in the step";
  }

  showTab(id: string): void {
    if (!byId("tabs").querySelector(`[data-tab=${id || "none"}]`)) return;
    this.tab = id;
    for (const button of byId("tabs").children as HTMLCollectionOf<HTMLElement>) {
      button.classList.toggle("on", button.dataset.tab === id);
      button.setAttribute("aria-selected", String(button.dataset.tab === id));
      button.tabIndex = button.dataset.tab === id ? 0 : -1;
    }
    for (const pane of ["live", "plots", "energy", "events", "run", "model"]) byId(pane).hidden = pane !== id;
    if (id === "plots") this.plots.resize();
    if (id === "energy") this.energy.resize();
    if (id === "events") this.list.show(this.t, true);
    this.draw();
  }

  /** Opens the model at the line of "file:line". */
  private showLine(place: string): void {
    this.showTab("model");
    const lines = byId("model").querySelectorAll("code");
    lines.forEach(l => l.classList.remove("here"));
    const line = lines[Number((place.match(/:(\d+)/) ?? [])[1]) - 1];
    if (!line) return;
    line.classList.add("here");
    line.scrollIntoView({block: "center"});
  }

  // --- controls

  private addTransport(): void {
    const span = this.grows ? Number(document.body.dataset.until) : this.end - this.begin, wanted = span > 120 ? span / 60 : span < 4 ? span / 4 : 1;
    const best = kSpeeds.filter(s => s <= Math.max(wanted, kSpeeds[0]) * 1.05).pop();
    byId("speed").replaceChildren(...kSpeeds.map(s => {
      const option = element("option", s < 1 ? `1/${Math.round(1 / s)}` : `\u00d7${s}`);
      option.value = String(s);
      option.selected = s === best;
      return option;
    }));
    byId("play").innerHTML = kPlayIcon;
    byId("play").onclick = () => this.toggle();
    byId("back").onclick = () => this.step(-1);
    byId("step").onclick = () => this.step(1);
    byId("before").onclick = () => this.jump(-1);
    byId("after").onclick = () => this.jump(1);
    for (const id of ["before", "after"]) byId<HTMLButtonElement>(id).disabled = !this.events.length;
    byId<HTMLInputElement>("scrub").oninput = event =>
      this.pause().seek(this.begin + Number((event.target as HTMLInputElement).value) * (this.end - this.begin));
    byId("link").onclick = () => copyLink(this);
    byId("png").onclick = () => this.savePicture();
    byId("film").onclick = () => this.saveFilm();
    byId("ask").onclick = () => this.help();
    byId("tabs").onkeydown = event => {
      const tabs = [...byId("tabs").children] as HTMLElement[], at = tabs.findIndex(b => b.dataset.tab === this.tab);
      const to = event.key === "ArrowRight" ? at + 1 : event.key === "ArrowLeft" ? at - 1 : -1;
      if (!tabs[to]) return;
      event.stopPropagation();
      tabs[to].click();
      tabs[to].focus();
    };
  }

  private help(): void {
    const help = byId<HTMLDialogElement>("help");
    if (help.open) help.close(); else help.showModal();
  }

  private savePicture(): void {
    const a = element("a");
    a.href = this.comparison.picture(this.t).toDataURL("image/png");
    a.download = `${this.data.title}_${this.t.toFixed(3)}s.png`;
    a.click();
  }

  private saveFilm(): void {
    this.pause();
    void saveFilm(this, Number(byId<HTMLSelectElement>("speed").value), byId("film"));
  }

  private addTools(): void {
    const button = (box: string, text: string, title: string, act: () => void): HTMLButtonElement => {
      const b = element("button", text);
      b.title = title;
      b.onclick = act;
      byId(box).append(b);
      return b;
    };
    for (const view of ["xz", "xy", "yz", "iso"]) {
      button("views", kViews[view], "view", () => this.setView(view)).dataset.view = view;
    }
    button("views", "fit", "show everything (0)", () => { this.stage.fit(); this.draw(); });
    for (const name of this.grows || this.film.contactCount ? ["contacts", "trails"] as const : ["trails"] as const) {
      button("switches", name, name === "contacts" ? "contact forces (c)" : "paths of the bodies (t)",
        () => this.setSwitch(name, !this.stage.show[name])).dataset.name = name;
    }
    const names = button("switches", "names", "names of the bodies (b)", () => this.tools.nameAll());
    this.tools.onNames = on => turned(names, on);
    const measure = button("switches", "measure", "distance of two points (m)", () => this.pressed("m", this.tools.toggleMeasure()));
    const other = button("switches", "compare", "lay another run over this one: its replay.html (o)", () => {
      if (this.tools.other) this.layOver(null);
      else this.tools.askForOther(run => this.layOver(run), fault => alert(fault));
    });
    const beside = button("switches", "beside", "the other run beside this one, or laid over it (w)", () => this.setBeside(!this.comparison.isBeside));
    beside.hidden = true;
    this.named = {b: names, m: measure, o: other, w: beside};
    button("switches", "follow", "the camera goes with what is selected (f)",
      () => this.setFollow(this.stage.followed < 0)).dataset.name = "follow";
    turned(byId("switches").querySelector("[data-name=follow]"), this.stage.followed >= 0);
    for (const name of ["contacts", "trails"] as const) this.setSwitch(name, this.stage.show[name]);
  }

  /** Bodies and curves of another run with those of this one; null: of none. The time goes to the end of the longer run. */
  layOver(other: OtherRun | null): void {
    const panels = panelsOf(this.signals);
    this.tools.other = other;
    this.comparison.show(other);
    this.end = Math.max(spanOf(this.film, this.signals)[1], other?.end ?? -Infinity);
    this.plots.setPanels(other ? other.addTo(panels, this.data.title) : panels, this.begin, this.end);
    this.energy.setPanels(this.comparison.ledger(this.ledger), this.begin, this.end);
    const events = this.comparison.events(this.events);
    this.list.take(events);
    if (events.length && !document.getElementById("tab_events")) this.addTab("events", "Events");
    for (const id of ["before", "after"]) byId<HTMLButtonElement>(id).disabled = !events.length;
    this.comparison.showHead();
    this.comparison.paintMarks(this.events);
    this.pressed("o", other !== null);
    this.named.w.hidden = !other;
    this.pressed("w", this.comparison.isBeside);
    this.seek(this.t);
  }

  /** The other run in a picture of its own, or laid over. */
  setBeside(on: boolean): void {
    this.comparison.setApart(on);
    this.pressed("w", this.comparison.isBeside);
    this.resize();
    this.draw();
  }

  private pressed(name: string, on: boolean): void {
    turned(this.named[name], on);
  }

  private key(event: KeyboardEvent): void {
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.altKey || event.metaKey || ["SELECT", "INPUT"].includes(target.tagName) && target.id !== "scrub") return;
    const tenth = (this.end - this.begin) / 10;
    const sideways = (by: number): void => { if (event.shiftKey) this.pause().seek(this.t + by * tenth); else this.step(by); };
    const force = (by: number): void => { this.stage.forceFactor *= by; this.draw(); };
    const acts: Record<string, () => void> = {
      " ": () => { if (this.live?.goes) this.live.toggle(); else this.toggle(); }, ArrowLeft: () => sideways(-1), ArrowRight: () => sideways(1),
      Home: () => this.pause().seek(this.begin), End: () => { if (this.live?.goes) this.live.toEdge(); else this.pause().seek(this.end); },
      n: () => this.jump(1), p: () => this.jump(-1), "+": () => this.faster(1), "-": () => this.faster(-1),
      1: () => this.setView("xz"), 2: () => this.setView("xy"), 3: () => this.setView("yz"), 4: () => this.setView("iso"),
      0: () => { this.stage.fit(); this.draw(); },
      c: () => this.setSwitch("contacts", !this.stage.show.contacts), t: () => this.setSwitch("trails", !this.stage.show.trails),
      f: () => this.setFollow(this.stage.followed < 0), l: () => byId("loop").click(), s: () => this.savePicture(), v: () => this.saveFilm(),
      b: () => this.named.b.click(), m: () => this.named.m.click(), o: () => this.named.o.click(),
      w: () => this.named.w.click(),
      h: () => this.tools.hide(this.stage.selected), H: () => this.tools.showAll(),
      d: () => this.setTheme(!theme.dark), "[": () => force(0.8), "]": () => force(1.25),
      "?": () => this.help(), Escape: () => { byId<HTMLDialogElement>("help").close(); this.select(-1); }
    };
    if (!acts[event.key]) return;
    event.preventDefault();
    acts[event.key]();
  }
}
