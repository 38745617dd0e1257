// The controls of a run that goes on: pause and pace above the time line; parameters, inputs and what
// was done in a panel of its own.
import type {Live, LiveState} from "./live";
import {shortNumber} from "./math";
import {element} from "./panels";

const kPaces = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];
const kStrengths: [number, string][] = [[0.1, "soft"], [1, "medium"], [10, "hard"], [100, "very hard"]];

export class LivePanel {
  private readonly bar = element("div");
  private readonly pause = element("button", "pause", "text");
  private readonly step = element("button", "one step", "text");
  private readonly end = element("button", "end the run", "text");
  private readonly now = element("button", "now", "text");
  private readonly pace = element("select");
  private readonly phase = element("span");
  private readonly box = document.getElementById("live") as HTMLElement;
  private readonly said = element("p", "", "said");
  private readonly done = element("ol", "", "done");
  private readonly fields = new Map<string, HTMLInputElement>();

  constructor(private readonly live: Live) {
    this.bar.id = "livebar";
    this.bar.setAttribute("role", "group");
    this.bar.setAttribute("aria-label", "the run that is being computed");
    this.phase.setAttribute("role", "status");
    const {footer} = {footer: document.querySelector("footer") as HTMLElement};
    const label = element("label", "pace ");
    label.append(this.pace);
    this.bar.append(this.phase, this.pause, this.step, this.now, label, this.end);
    footer.prepend(this.bar);
    this.pause.title = "pause or go on (space)";
    this.pause.onclick = () => live.toggle();
    this.step.title = "one step, then pause";
    this.step.onclick = () => { live.toEdge(); void live.order("step"); };
    this.now.title = "show the present, not the past (end)";
    this.now.onclick = () => live.toEdge();
    this.end.title = "end the run and write its files";
    this.end.onclick = () => void live.order("end");
    this.fillPace(live.state.pace);
    this.pace.onchange = () => void live.order("pace", "", [Number(this.pace.value)]);
    this.fillPanel(live.state);
  }

  private fillPace(pace: number): void {
    const all = [...new Set([...kPaces, ...(pace > 0 ? [pace] : [])])].sort((a, b) => a - b);
    const option = (text: string, value: number): HTMLOptionElement => {
      const o = element("option", text);
      o.value = String(value);
      o.selected = value === pace;
      return o;
    };
    this.pace.replaceChildren(...all.map(p => option(p < 1 ? `1/${Math.round(1 / p)}` : p === 1 ? "real time" : `\u00d7${p}`, p)),
      option("as fast as it can", 0));
    this.pace.title = "simulated time over your time";
  }

  private fillPanel(state: LiveState): void {
    this.said.setAttribute("role", "alert");
    const strength = element("select"), hand = element("label", "strength of the hand ");
    for (const [value, text] of kStrengths) {
      const o = element("option", text);
      o.value = String(value);
      o.selected = value === 1;
      strength.append(o);
    }
    strength.onchange = () => { this.live.strength = Number(strength.value); };
    hand.append(strength);
    this.box.append(this.said, element("p", "Pull a body with the pointer. With shift the pointer moves the view.", "none"), hand);
    for (const [kind, title] of [["parameters", "Parameters"], ["inputs", "Inputs"]] as const) {
      const names = Object.keys(state[kind]);
      if (!names.length) continue;
      const table = element("table");
      for (const name of names) table.append(this.row(kind, name, state[kind][name]));
      this.box.append(element("h2", title), table);
    }
    this.box.append(element("h2", "What was done"), this.done);
  }

  private row(kind: "parameters" | "inputs", name: string, value: number): HTMLTableRowElement {
    const row = element("tr"), field = element("input");
    field.type = "text";
    field.inputMode = "decimal";
    field.value = String(value);
    field.setAttribute("aria-label", name);
    field.onchange = () => {
      const x = Number(field.value.trim() || NaN);
      if (!Number.isFinite(x)) { this.say(`${name}: ${field.value} is no number`); return; }
      void this.live.order(kind === "parameters" ? "set" : "input", name, [x]).then(good => {
        if (!good) field.value = String(this.live.state[kind][name]);
      });
    };
    this.fields.set(`${kind} ${name}`, field);
    row.insertCell().textContent = name;
    row.insertCell().append(field);
    return row;
  }

  show(state: LiveState): void {
    const words = {waiting: "the run waits", running: "computing", paused: "paused", ended: "the run has ended"};
    this.phase.textContent = `${words[state.phase]} \u00b7 ${shortNumber(state.t)} s`;
    this.phase.className = state.phase;
    this.pause.textContent = state.phase === "paused" ? "go on" : "pause";
    this.now.classList.toggle("on", this.live.atEdge);
    for (const kind of ["parameters", "inputs"] as const) {
      for (const [name, value] of Object.entries(state[kind])) {
        const field = this.fields.get(`${kind} ${name}`);
        if (field && field !== document.activeElement) field.value = String(value);
      }
    }
  }

  say(text: string): void { this.said.textContent = text; }

  note(t: number, what: string, name: string, values: number[]): void {
    if (what === "move") return;
    const words: Record<string, string> = {set: `${name} = ${values[0]}`, input: `${name} = ${values[0]}`, grab: "pull a body",
      release: "let go", end: "end the run"};
    const item = element("li", words[what] ?? what);
    item.prepend(element("span", `${shortNumber(t)} s`));
    this.done.append(item);
    item.scrollIntoView({block: "nearest"});
  }

  /** The run has ended: what was done stays, nothing can be changed. */
  close(): void {
    this.bar.hidden = true;
    for (const field of this.box.querySelectorAll("input, select")) (field as HTMLInputElement).disabled = true;
  }
}
