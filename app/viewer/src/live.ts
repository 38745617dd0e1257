// A run that is being computed: the page asks the program for what was recorded since, and sends it
// commands. doc/replay.md describes both.
import {eventIn, type Event, type Signal} from "./data";
import {FramesReader, Growing, LinesReader, LiveFilm} from "./live_film";
import {LivePanel} from "./live_panel";
import {add, dot, rotated, scaled, sub, type V3} from "./math";
import type {Replay} from "./replay";
import type {Grabbed} from "./stage";

const kMostRows = 40000;

export interface LiveState {
  number: number; phase: "waiting" | "running" | "paused" | "ended"; t: number; pace: number; steps: number;
  actions: number; end: string; parameters: Record<string, number>; inputs: Record<string, number>;
}
type Part = "signals" | "events" | "ledger" | "frames";

/** Reads what the program has recorded, from the beginning on. */
export class LiveFeed {
  readonly film: LiveFilm;
  readonly events: Event[] = [];
  readonly ledger = new Map<string, Growing<Float64Array>>();
  state: LiveState | null = null;
  private readonly time = new Growing<Float64Array>(n => new Float64Array(n));
  private readonly values: Growing<Float32Array>[];
  private readonly at: Record<Part, number> = {signals: 0, events: 0, ledger: 0, frames: 0};
  private readonly frames = new FramesReader();
  private readonly lines = {signals: new LinesReader(), events: new LinesReader(), ledger: new LinesReader()};

  constructor(poses: number, private readonly signals: Signal[]) {
    this.film = new LiveFilm(poses);
    this.values = signals.map(() => new Growing<Float32Array>(n => new Float32Array(n)));
  }

  /** Waits for news, at most half a second; throws if the program is gone. */
  async ask(): Promise<boolean> {
    const where = (Object.keys(this.at) as Part[]).map(p => `${p}=${this.at[p]}`).join("&");
    const answer = await fetch(`feed?number=${this.state?.number ?? 0}&${where}`, {cache: "no-store"});
    if (!answer.ok) throw new Error(await answer.text());
    const bytes = new Uint8Array(await answer.arrayBuffer());
    const head = 4 + new DataView(bytes.buffer).getUint32(0, true);
    const state = JSON.parse(new TextDecoder().decode(bytes.subarray(4, head))) as LiveState & Record<Part, number>;
    let from = head, grown = false;
    for (const part of Object.keys(this.at) as Part[]) {
      const more = bytes.subarray(from, from += state[part]);
      this.at[part] += more.length;
      grown ||= more.length > 0;
      this.take(part, more);
    }
    this.state = state;
    return grown;
  }

  private take(part: Part, bytes: Uint8Array): void {
    if (part === "frames") {
      this.film.append(this.frames.take(bytes));
      return;
    }
    const lines = this.lines[part].take(bytes);
    if (part === "events") this.events.push(...lines.map(eventIn));
    if (part === "signals") this.takeRows(lines);
    if (part === "ledger") this.takeLedger(lines, this.lines.ledger.head.split(","));
  }

  private takeRows(lines: string[]): void {
    for (const line of lines) {
      const row = line.split(",").map(Number);
      this.time.push(row[0]);
      this.values.forEach((v, i) => v.push(row[i + 1]));
    }
    if (this.time.length > kMostRows) for (const column of [this.time, ...this.values]) column.thin();
    this.signals.forEach((s, i) => { s.t = this.time.view; s.y = this.values[i].view; });
  }

  private takeLedger(lines: string[], names: string[]): void {
    for (const line of lines) {
      line.split(",").forEach((x, i) => {
        let column = this.ledger.get(names[i]);
        if (!column) this.ledger.set(names[i], column = new Growing<Float64Array>(n => new Float64Array(n)));
        column.push(Number(x));
      });
    }
  }

  ledgerColumns(): Map<string, Float64Array> {
    return new Map([...this.ledger].map(([name, column]) => [name, column.view]));
  }
}

/** What is held by the pointer. */
interface Held extends Grabbed { target: V3; sent: V3 }

/** Commands, pulling, and the page's growth. */
export class Live {
  readonly panel: LivePanel;
  atEdge = true;
  strength = 1;
  private held: Held | null = null;
  private sending = false;
  private fresh = 0;  // wall time of the last look at plots and sizes [ms]

  constructor(private readonly replay: Replay, readonly feed: LiveFeed) {
    this.panel = new LivePanel(this);
    this.show(true);
    void this.follow();
  }

  get state(): LiveState { return this.feed.state as LiveState; }
  get goes(): boolean { return this.state.phase !== "ended"; }

  private async follow(): Promise<void> {
    try {
      while (this.goes) {
        const grown = await this.feed.ask();
        this.show(grown);
      }
      // the rest of the files, then the facts of the run
      while (await this.feed.ask()) this.show(true);
      const facts = await (await fetch("facts", {cache: "no-store"})).json() as Record<string, unknown>;
      this.replay.ended(facts);
      await fetch("bye", {method: "POST"});  // everything has come: the program may end
    } catch (error) {
      this.panel.say(`The program no longer answers: ${error instanceof Error ? error.message : error}`);
      this.state.phase = "ended";
    }
    this.show(true);
    this.panel.close();
  }

  private show(grown: boolean): void {
    const now = performance.now(), slow = now - this.fresh > 250 || !this.goes;
    if (grown) this.replay.grow(this.feed, slow);
    if (grown && slow) this.fresh = now;
    this.panel.show(this.state);
    if (this.atEdge && grown) this.replay.seek(this.replay.end);
  }

  /** Sends a command; a refusal is shown. True: it was carried out. */
  async order(what: string, name = "", values: number[] = []): Promise<boolean> {
    try {
      const answer = await fetch("do", {method: "POST", headers: {"Content-Type": "application/json"},
        body: JSON.stringify({do: what, name, values})});
      const {error} = await answer.json() as {error: string};
      this.panel.say(error);
      if (!error && !["pause", "go", "step", "pace"].includes(what)) this.panel.note(this.replay.end, what, name, values);
      return !error;
    } catch {
      this.panel.say("The program no longer answers.");
      return false;
    }
  }

  toggle(): void {
    this.toEdge();
    void this.order(this.state.phase === "paused" ? "go" : "pause");
  }

  toEdge(): void {
    this.atEdge = true;
    this.replay.pause(false).seek(this.replay.end);
  }

  // --- the hand

  /** A body is grabbed at a point; whether it can be is known when the program answers. */
  async grab(at: Grabbed): Promise<void> {
    if (!this.goes) return;
    this.toEdge();
    const held: Held = {...at, target: at.point, sent: at.point};
    this.held = held;
    const {r, q} = this.replay.film.pose(at.frame, this.replay.t);
    held.local = rotated([q[0], -q[1], -q[2], -q[3]], sub(at.point, r));
    if (!await this.order("grab", "", [at.frame, ...held.local, ...at.point, this.strength])) {
      if (this.held === held) this.held = null;
      return;
    }
    if (this.held !== held) void this.order("release");  // let go meanwhile
    else void this.pull();
  }

  move(target: V3): void {
    if (!this.held) return;
    this.held.target = target;
    if (!this.sending) void this.pull();
  }

  private async pull(): Promise<void> {
    const {held} = this;
    if (!held || this.sending || held.target === held.sent || !held.local) return;
    this.sending = true;
    held.sent = held.target;
    await this.order("move", "", held.target);
    await new Promise(done => setTimeout(done, 20));
    this.sending = false;
    if (this.held === held && held.target !== held.sent) void this.pull();
  }

  release(): void {
    if (!this.held) return;
    this.held = null;
    void this.order("release");
  }

  /** The line of the hand: the point that it holds, and where it pulls to. */
  get line(): [V3, V3] | null {
    const {held} = this;
    if (!held?.local) return null;
    const {r, q} = this.replay.film.pose(held.frame, this.replay.t);
    return [add(r, rotated(q, held.local)), held.target];
  }

  /** The point under the pointer in the plane of the picture through what is held. */
  pointAt(x: number, y: number, through: V3): V3 {
    const {camera} = this.replay.stage, s = camera.scaleAt(through) || camera.scale;
    const depth = dot(sub(through, camera.centre), camera.toward);
    return add(camera.centre, add(scaled(camera.toward, depth), add(
      scaled(camera.right, (x - camera.width / 2) / s), scaled(camera.up, (camera.height / 2 - y) / s))));
  }
}
