// Curves over time with uPlot, all with one time axis, zoomed together, with a cursor at the time of
// the picture.
import uPlot from "uplot";
import {clamp, lastAtOrBefore, shortNumber} from "./math";
import {csvOf, plotName, saveText, svgOf} from "./plot_file";
import {kCurves, mixed, theme} from "./theme";

export interface Curve { name: string; t: ArrayLike<number>; y: ArrayLike<number>; dashed?: boolean; colour?: number }
export interface PlotPanel { unit: string; curves: Curve[]; title?: string; log?: boolean; height?: number }

/** Signals of one element with the same unit share a panel; without a unit each has its own. */
export function panelsOf(signals: {name: string; unit: string; t: Float64Array; y: Float32Array}[]): PlotPanel[] {
  const panels: PlotPanel[] = [];
  const owner = (name: string): string => name.includes(".") ? name.slice(0, name.lastIndexOf(".")) : name;
  for (const s of signals) {
    const fit = s.unit && panels.find(p =>
      p.unit === s.unit && owner(p.curves[0].name) === owner(s.name) && p.curves.length < kCurves.length);
    if (fit) fit.curves.push(s); else panels.push({unit: s.unit, curves: [s]});
  }
  return panels;
}

/** Names of the numbers that a signal `status` has, in the order of the program. */
const kStatuses = ["open", "separating", "stick", "slip", "lower", "upper", "locked"];
const isStatus = (c: Curve): boolean => c.name.endsWith(".status");
const valueText = (c: Curve, v: number): string => (isStatus(c) && kStatuses[v]) || shortNumber(v);

interface Shown { plot: uPlot; panel: PlotPanel; values: HTMLElement[]; line: HTMLElement }

const kFont = "11px system-ui, 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";
const curveColour = (k: number): string => theme.dark ? mixed(kCurves[k % kCurves.length], 0.25) : kCurves[k % kCurves.length];

/** The values of all curves at the union of their times. */
function aligned(panel: PlotPanel): uPlot.AlignedData {
  const clean = (y: ArrayLike<number>): (number | null)[] =>
    Array.from(y, v => !Number.isFinite(v) ? null : panel.log ? (v > 0 ? v : null) : v);
  const same = panel.curves.every(c => c.t === panel.curves[0].t);
  if (same) return [Array.from(panel.curves[0].t), ...panel.curves.map(c => clean(c.y))] as uPlot.AlignedData;
  return uPlot.join(panel.curves.map(c => [apart(c.t), clean(c.y)] as uPlot.AlignedData));
}

/** Times of which none is twice there: the values before and after an impact would become one. */
function apart(t: ArrayLike<number>): number[] {
  const out = Array.from(t), hair = 1e-12 * Math.abs(out[out.length - 1] ?? 0);
  for (let i = 1; i < out.length; ++i) if (out[i] <= out[i - 1]) out[i] = out[i - 1] + hair;
  return out;
}

const kMostPlots = 60;  // at first: hundreds take seconds

export class Plots {
  private most = kMostPlots;
  private shown: Shown[] = [];
  private zoomed: [number, number] | null = null;
  private syncing = false;
  private t = 0;

  constructor(private readonly box: HTMLElement, private panels: PlotPanel[], private begin: number,
              private end: number, private readonly seek: (t: number) => void) {}

  /** Makes all plots anew, for the present width and theme. */
  rebuild(): void {
    for (const s of this.shown) s.plot.destroy();
    this.shown = [];
    this.box.replaceChildren();
    const width = this.box.clientWidth;
    if (!width) return;
    for (const panel of this.panels.slice(0, this.most)) this.shown.push(this.add(panel, width));
    if (this.panels.length > this.most) this.box.append(this.moreButton());
    if (this.zoomed) this.zoom(...this.zoomed);
    this.draw(this.t);
  }

  private moreButton(): HTMLElement {
    const button = document.createElement("button");
    button.className = "more";
    button.textContent = `show ${this.panels.length - this.most} more plots`;
    button.onclick = () => {
      this.most = Infinity;
      this.rebuild();
    };
    return button;
  }

  /** Shows other curves. */
  setPanels(panels: PlotPanel[], begin = this.begin, end = this.end): void {
    this.panels = panels;
    this.begin = begin;
    this.end = end;
    if (this.built) this.rebuild();
  }

  /** The curves have grown, up to `end`; with `panels` others are shown. */
  grow(begin: number, end: number, panels?: PlotPanel[]): void {
    this.begin = begin;
    this.end = end;
    const same = !panels || (panels.length === this.panels.length &&
      panels.every((p, i) => p.curves.length === this.panels[i].curves.length));
    if (panels) this.panels = panels;
    if (!this.built) return;
    if (!same) { this.rebuild(); return; }
    this.syncing = true;
    this.shown.forEach((s, i) => {
      s.panel = this.panels[i];
      s.plot.setData(aligned(s.panel), false);
      s.plot.setScale("x", this.zoomed ? {min: this.zoomed[0], max: this.zoomed[1]} : {min: begin, max: end > begin ? end : begin + 1});
    });
    this.syncing = false;
    this.draw(this.t);
  }

  get built(): boolean { return this.shown.length > 0; }

  resize(): void {
    const width = this.box.clientWidth;
    if (!width) return;
    if (!this.built) { this.rebuild(); return; }
    for (const s of this.shown) s.plot.setSize({width, height: s.plot.height});
    this.draw(this.t);
  }

  private add(panel: PlotPanel, width: number): Shown {
    const div = document.createElement("div"), names = document.createElement("div");
    div.className = "plot";
    names.className = "names";
    if (panel.title) {
      const title = document.createElement("b");
      title.textContent = panel.title;
      names.append(title);
    }
    const values = panel.curves.map((c, k) => {
      const span = document.createElement("span"), value = document.createElement("em");
      span.textContent = c.name;
      span.style.color = curveColour(c.colour ?? k);
      span.title = "show or hide";
      span.onclick = () => {
        const on = !plot.series[k + 1].show;
        plot.setSeries(k + 1, {show: on});
        span.classList.toggle("off", !on);
      };
      span.append(value);
      names.append(span);
      return value;
    });
    if (panel.unit) {
      const unit = document.createElement("small");
      unit.textContent = `[${panel.unit}]`;
      names.append(unit);
    }
    const files = document.createElement("span");
    files.className = "files";
    for (const [text, what, act] of [
      ["CSV", "save the numbers of these curves as CSV", () => saveText(`${plotName(panel)}.csv`, "text/csv", csvOf(shown.panel))],
      ["SVG", "save this plot as SVG", () => saveText(`${plotName(panel)}.svg`, "image/svg+xml", svgOf(shown.panel,
        shown.panel.curves.map((_, k) => plot.series[k + 1].show !== false), plot.scales.x.min ?? 0, plot.scales.x.max ?? 1))]] as
        [string, string, () => void][]) {
      const button = document.createElement("button");
      button.textContent = text;
      button.title = what;
      button.onclick = act;
      files.append(button);
    }
    names.append(files);
    div.append(names);
    this.box.append(div);
    const plot = new uPlot(this.options(panel, width), aligned(panel), div);
    const line = document.createElement("div");
    line.className = "now";
    plot.over.append(line);
    const shown: Shown = {plot, panel, values, line};
    return shown;
  }

  private options(panel: PlotPanel, width: number): uPlot.Options {
    const axis = {font: kFont, stroke: theme.soft, grid: {stroke: theme.grid, width: 1}, ticks: {show: false}};
    const label = (v: number | null): string => v === null ? "" : shortNumber(v);
    const statuses = panel.curves.every(isStatus);
    const name = (v: number): string => statuses ? kStatuses[v] ?? "" : label(v);
    return {
      width, height: panel.height ?? 138, padding: [6, 14, 0, 0], legend: {show: false},
      cursor: {y: false, points: {show: false}, drag: {x: true, y: false, dist: 6},
        bind: {dblclick: () => () => { this.zoom(this.begin, this.end); return null; }}},
      scales: {x: {time: false, min: this.begin, max: this.end > this.begin ? this.end : this.begin + 1},
        y: panel.log ? {distr: 3} : {range: (_u, lo, hi) => padded(lo, hi)}},
      axes: [{...axis, size: 26, gap: 4, values: (_u, all) => all.map(label)},
        {...axis, size: this.panels.some(p => p.curves.every(isStatus)) ? 76 : 58, gap: 4, values: (_u, all) => all.map(name), space: panel.log ? 18 : 24}],
      series: [{}, ...panel.curves.map((c, k): uPlot.Series => ({
        stroke: curveColour(c.colour ?? k), width: 1.5, spanGaps: true, points: {show: false}, dash: c.dashed ? [5, 4] : undefined}))],
      hooks: {
        setScale: [(u, key) => {
          if (key !== "x" || this.syncing || u.scales.x.min == null || u.scales.x.max == null) return;
          if (this.shown.length) this.zoom(u.scales.x.min, u.scales.x.max);
        }],
        ready: [u => {
          u.over.addEventListener("click", event => {
            if (u.select.width > 0) return;
            this.seek(clamp(u.posToVal(event.offsetX, "x"), this.begin, this.end));
          });
        }]
      }
    };
  }

  /** All plots show [lo, hi]. */
  private zoom(lo: number, hi: number): void {
    this.syncing = true;
    this.zoomed = lo <= this.begin && hi >= this.end ? null : [lo, hi];
    for (const {plot} of this.shown) {
      plot.setScale("x", {min: lo, max: hi});
      plot.setSelect({left: 0, top: 0, width: 0, height: 0}, false);
    }
    this.syncing = false;
    this.draw(this.t);
    this.box.classList.toggle("zoomed", this.zoomed !== null);
  }

  draw(t: number): void {
    this.t = t;
    for (const {plot, panel, values, line} of this.shown) {
      const x = plot.valToPos(t, "x");
      line.hidden = !(x >= -1 && x <= plot.over.clientWidth + 1);
      line.style.transform = `translateX(${Math.round(x)}px)`;
      panel.curves.forEach((c, k) => {
        values[k].textContent = valueText(c, c.t.length ? c.y[lastAtOrBefore(c.t, t)] : NaN);
      });
    }
  }
}

/** A range with a margin; a constant gets one that shows it as a level line. */
function padded(lo: number | null, hi: number | null): [number, number] {
  if (lo === null || hi === null || !Number.isFinite(lo) || !Number.isFinite(hi)) return [0, 1];
  const size = Math.max(Math.abs(lo), Math.abs(hi));
  if (hi - lo <= 1e-9 * size || hi === lo) return size === 0 ? [-1, 1] : [lo - 0.1 * size, hi + 0.1 * size];
  const margin = 0.07 * (hi - lo);
  return [lo - margin, hi + margin];
}
