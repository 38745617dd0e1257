// The panels beside the plots: events, facts of the run, text of the model, the card of a body.
import type {Event, PageData} from "./data";
import {kKeys} from "./labels";
import {lastAtOrBefore, shortNumber} from "./math";
import type {OtherRun} from "./other_run";
import type {Curve, PlotPanel} from "./plots";
import {kStates} from "./theme";

export function element<K extends keyof HTMLElementTagNameMap>(tag: K, text = "", className = ""): HTMLElementTagNameMap[K] {
  const e = document.createElement(tag);
  if (text) e.textContent = text;
  if (className) e.className = className;
  return e;
}

const factText = (x: unknown): string =>
  x === null ? "\u2013" : typeof x === "number" && !Number.isInteger(x) ? shortNumber(x) : String(x);

/** The members of an object as rows; text is set as text, never as HTML. Lists of objects are left
 *  to those who read run.json. */
/** What members of run.json are called where their names say it badly. */
const kMemberNames: Record<string, string> = {
  gTol: "gap of closed contacts [m]", inBodies: "joints within bodies", flat: "bodies kept in a plane", rowsSaved: "rows saved",
  of: "of all joints", every: "signals every [s]", until: "until [s]", step: "step [s]", framesPerSecond: "frames per second"
};

/** Members that say nothing: texts without letters, and what a run with steps of given length has no use for. */
const saysNothing = (name: string, x: unknown): boolean => x === "" || ((name === "tolerance" || name === "step") && x === 0);

export function tableOf(object: Record<string, unknown>): HTMLTableElement {
  const table = element("table");
  const addRows = (members: Record<string, unknown>, depth: number): void => {
    for (const [name, x] of Object.entries(members)) {
      const list = Array.isArray(x) ? x : null;
      if (saysNothing(name, x) || (list && list.some(e => e !== null && typeof e === "object"))) continue;
      const row = table.insertRow(), cell = row.insertCell();
      cell.textContent = kMemberNames[name] ?? name.replace(/_/g, " ").replace(/([a-z])([A-Z])/g, "$1 $2").toLowerCase();
      cell.style.paddingLeft = `${14 * depth}px`;
      if (x !== null && typeof x === "object" && !list) {
        cell.colSpan = 2;
        cell.className = "group";
        addRows(x as Record<string, unknown>, depth + 1);
      } else {
        row.insertCell().textContent = list ? list.map(factText).join(", ") : factText(x);
      }
    }
  };
  addRows(object, 0);
  return table;
}

/** The checks of the model with what came out. */
export function checksOf(run: Record<string, unknown>): HTMLElement | null {
  const checks = Array.isArray(run.checks) ? run.checks as Record<string, unknown>[] : [];
  if (!checks.length) return null;
  const table = element("table", "", "checks");
  for (const c of checks) {
    const row = table.insertRow();
    row.insertCell().append(element("span", c.pass ? "pass" : "fail", c.pass ? "good" : "bad"));
    row.insertCell().textContent = `${c.measure === "value" ? "" : `${c.measure} `}${c.signal}${c.over ? ` ${c.over}` : ""}`;
    row.insertCell().textContent = `${factText(c.got)} (${String(c.expected)})`;
  }
  return table;
}

/** Lists the keys. */
export function fillHelp(help: HTMLDialogElement): void {
  const table = element("table");
  for (const [keys, text] of kKeys) {
    const row = table.insertRow();
    row.insertCell().textContent = keys;
    row.insertCell().textContent = text;
  }
  help.append(element("h2", "Keys"), table);
  help.onclick = () => help.close();
}

/** What the curves of a panel are, in every run. */
export const kindOf = (p: PlotPanel): string => `${p.title ?? p.curves[0]?.name} [${p.unit}]`;

/** How the run ended and its size, for the head of the page. */
function headline(data: PageData, span: number, frames: number): (string | Node)[] {
  const {run} = data, parts: (string | Node)[] = [];
  const say = (...nodes: (string | Node)[]): void => { parts.push(...(parts.length ? [" \u00b7 ", ...nodes] : nodes)); };
  if (run && typeof run.state === "string") {
    say(["finished", "ok", "done"].includes(run.state) ? run.state : element("b", run.state, "bad"));
  }
  const checks = Array.isArray(run?.checks) ? run.checks as {pass?: boolean}[] : [], warnings = Array.isArray(run?.warnings) ? run.warnings.length : 0;
  const failed = checks.filter(c => c.pass === false).length;
  if (failed) say(element("b", `${failed} of ${checks.length} checks failed`, "bad"));
  if (warnings) say(element("b", warnings === 1 ? "1 warning" : `${warnings} warnings`, "bad"));
  say(element("b", shortNumber(span)), " s");
  for (const [name, word] of [["steps", "steps"], ["impacts", "impacts"], ["switches", "changes of status"]]) {
    if (run && typeof run[name] === "number") say(element("b", String(run[name])), ` ${word}`);
  }
  if (run && typeof run.wall_s === "number") say("computed in ", element("b", shortNumber(run.wall_s)), " s");
  const {recorded} = data.frames;
  if (frames) say(frames < recorded ? element("b", `${frames} of ${recorded} frames`, "bad") : `${frames} frames`);
  return parts;
}

/** Writes it there, and in full as a hint where the window is narrow. */
export function showHeadline(box: HTMLElement, data: PageData, span: number, frames: number, other: OtherRun | null): void {
  const own = headline(data, span, frames);
  box.replaceChildren(...(other ? [`${data.title}: `, ...own, "  \u2016  ", `${other.title}: `,
    ...headline(other.data, other.end - other.begin, other.film.count)] : own));
  box.title = box.textContent ?? "";
}

/** Energies and works, then what the solver did: panels of the ledger. */
export function ledgerPanels(ledger: Map<string, Float64Array>): PlotPanel[] {
  const t = ledger.get("t");
  if (!t) return [];
  const column = (name: string): Float64Array => ledger.get(name) ?? new Float64Array(t.length);
  const curve = (name: string, y: Float64Array): Curve => ({name, t, y});
  const used = (name: string, label: string): Curve[] => column(name).some(x => x !== 0) ? [curve(label, column(name))] : [];
  const T = column("kinetic"), V = column("potential"), panels: PlotPanel[] = [];
  panels.push({title: "energy", unit: "J", height: 170, curves: [
    curve("kinetic", T), curve("potential", V), curve("sum", T.map((x, i) => x + V[i]))]});
  const works = [...used("normal", "normal forces"), ...used("friction", "friction"), ...used("nonPotential", "drives, dampers"),
    ...used("joints", "joints"), ...used("boundaries", "moving boundaries")];
  if (works.length) panels.push({title: "work", unit: "J", height: 160, curves: works});
  panels.push({title: "ledger", unit: "J", curves: used("discretisation", "discretisation")});
  const strip = (name: string, label: string, unit: string, log = false): void => {
    const curves = used(name, label);
    if (curves.length) panels.push({unit, curves, log, height: 110});
  };
  strip("residual", "solver residual", "", true);
  strip("iterations", "iterations", "");
  strip("contacts", "contacts", "");
  strip("penetration", "penetration", "m", true);
  return panels.filter(p => p.curves.length);
}

const kRow = 26;  // [pixel]
const kKinds = ["all", "impacts", "switches"] as const;

/** A list of which only the seen rows exist. Events that are not in it are counted above it. */
export class EventList {
  private readonly rows = element("div", "", "rows");
  private readonly bar = element("div", "", "bar");
  private readonly note = element("p", "", "note");
  private kind: typeof kKinds[number] = "all";
  private events: Event[] = [];
  private brief = false;  // switches that are taken back at once are listed, too
  private current = -1;
  private t = 0;

  /** `leftOut`: events that the run did not record. */
  constructor(private readonly box: HTMLElement, private all: Event[], private readonly leftOut: number,
              private readonly seek: (t: number) => void) {
    for (const kind of kKinds) {
      const button = element("button");
      button.onclick = () => {
        this.kind = kind;
        this.grown();
      };
      this.bar.append(button);
    }
    const head = element("div", "", "listhead");
    head.append(this.bar, this.note);
    box.replaceChildren(head, this.rows);
    this.grown();
    box.addEventListener("scroll", () => this.fill());
  }

  /** Other events: those of two runs, which name their run, or of one again. */
  take(all: Event[]): void {
    this.all = all;
    this.grown();
  }

  private isOf(e: Event, kind: typeof kKinds[number]): boolean { return kind === "all" || e.impact === (kind === "impacts"); }
  private listed(): Event[] { return this.brief ? this.all : this.all.filter(e => !e.brief); }

  /** Events were added to the list that it was made of, or others are chosen. */
  grown(): void {
    const listed = this.listed();
    [...this.bar.children].forEach((button, i) => {
      button.textContent = `${kKinds[i]} ${listed.filter(e => this.isOf(e, kKinds[i])).length}`;
      turned(button, kKinds[i] === this.kind);
    });
    this.fillNote();
    this.events = listed.filter(e => this.isOf(e, this.kind));
    this.rows.style.height = `${kRow * this.events.length}px`;
    this.current = -2;
    this.show(this.t, true);
  }

  private fillNote(): void {
    const own = this.all.reduce((n, e) => n + (e.other ? 0 : 1), 0);
    const brief = this.all.reduce((n, e) => n + (e.brief ? 1 : 0), 0), parts: (string | Node)[] = [];
    if (brief) {
      const button = element("button", this.brief ? "leave them out" : "list them", "inline");
      button.onclick = () => {
        this.brief = !this.brief;
        this.grown();
      };
      parts.push(`${brief} switches are taken back within a step: `, button);
    }
    if (this.leftOut > 0) {
      if (parts.length) parts.push(element("br"));
      parts.push(element("b", `The run recorded the first ${own} of ${own + this.leftOut} events.`));
    }
    this.note.replaceChildren(...parts);
    this.note.hidden = !parts.length;
  }

  /** The next event after t (by 1) or the last before it (by −1). */
  from(t: number, by: number, tiny: number): Event | undefined {
    const all = this.events.length ? this.events : this.listed();
    return by > 0 ? all.find(e => e.t > t + tiny) : [...all].reverse().find(e => e.t < t - tiny);
  }

  show(t: number, anyway = false): void {
    this.t = t;
    const {events} = this, at = events.length && events[0].t <= t ? lastAtOrBefore(events.map(e => e.t), t) : -1;
    if (at === this.current && !anyway) return;
    this.current = at;
    if (this.box.clientHeight) {
      const top = Math.max(0, at) * kRow, {scrollTop, clientHeight} = this.box;
      if (top < scrollTop || top > scrollTop + clientHeight - 3 * kRow) this.box.scrollTop = top - clientHeight / 3;
    }
    this.fill();
  }

  fill(): void {
    const first = Math.max(0, Math.floor(this.box.scrollTop / kRow) - 4), last = first + Math.ceil(this.box.clientHeight / kRow) + 8;
    this.rows.replaceChildren(...this.events.slice(first, last).map((e, i) => {
      const row = element("div", "", `event${first + i === this.current ? " on" : ""}`);
      row.style.top = `${kRow * (first + i)}px`;
      const mark = element("i"), colour = kStates.find(s => s.name === (e.impact || e.system ? "impact" : e.to)) ?? kStates[0];
      mark.style.background = colour.colour;
      row.append(mark, element("span", `${e.t.toFixed(5)}`, "t"), element("span", e.run ? `${e.run}: ${e.contact}` : e.contact, "c"),
        element("span", e.impact ? `${shortNumber(e.speed)} m/s, ${shortNumber(e.impulse)} N s` : e.system ? e.system :
          `${e.from} → ${e.to}`, "k"));
      row.title = e.impact ? `impact on ${e.contact} at ${shortNumber(e.speed)} m/s with ${shortNumber(e.impulse)} N s` : e.contact;
      row.tabIndex = 0;
      row.setAttribute("role", "button");
      row.onclick = () => this.seek(e.t);
      row.onkeydown = key => {
        if (key.key !== "Enter") return;
        key.stopPropagation();
        this.seek(e.t);
      };
      return row;
    }));
  }
}

/** Shows that a button is pressed or not, to eyes and to screen readers. */
export function turned(button: Element | null, on: boolean): void {
  button?.classList.toggle("on", on);
  button?.setAttribute("aria-pressed", String(on));
}

/** The model with numbered lines. */
export function modelText(text: string): HTMLPreElement {
  const pre = element("pre");
  for (const line of text.replace(/\n$/, "").split("\n")) {
    const code = element("code");
    // tags, attributes and comments in colours; pieces are set as text
    const pieces = line.match(/<!--.*?(-->|$)|<\/?[\w.:-]+|"[^"]*"|\/?>|[^<>"]+|./g) ?? [];
    for (const p of pieces) {
      const kind = p.startsWith("<!--") ? "note" : /^<|^\/?>$/.test(p) ? "tag" : p.startsWith('"') ? "value" : "";
      code.append(kind ? element("span", p, kind) : p);
    }
    pre.append(code);
  }
  return pre;
}
