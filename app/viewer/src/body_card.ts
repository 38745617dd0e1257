// The card of a selected body: name, place in the model, state and signals; beside them those of another run.
import type {Scene, Signal} from "./data";
import type {Film} from "./film";
import {clamp, lastAtOrBefore, norm, shortNumber} from "./math";
import type {OtherRun} from "./other_run";
import {element} from "./panels";

const kMostSignals = 8;

/** Names with values and units of a frame at t. */
function stateOf(film: Film, frame: number, t: number): [string, number, string][] {
  if (film.absent(frame, t)) return [];
  const pose = film.pose(frame, t), {v, omega} = film.rates(frame, t);
  const angle = 2 * Math.acos(clamp(Math.abs(pose.q[0]), 0, 1)) * 180 / Math.PI;
  return [["x", pose.r[0], " m"], ["y", pose.r[1], " m"], ["z", pose.r[2], " m"], ["speed", norm(v), " m/s"],
    ["turned by", angle, "\u00b0"], ["turns with", norm(omega), " rad/s"]];
}

const valueAt = (s: Signal, t: number): number => s.t.length ? s.y[lastAtOrBefore(s.t, t)] : NaN;

/** Fills the table of a card. */
export function fillCard(table: HTMLTableElement, scene: Scene, film: Film, signals: Signal[], frame: number, t: number,
                         other: OtherRun | null): void {
  const {name} = scene.frames[frame], owner = `${name.split(".")[0]}.`, twin = other?.frameNamed(name) ?? -1;
  const theirs = other && twin >= 0 ? stateOf(other.film, twin, t) : [];
  const rows = stateOf(film, frame, t).map(([label, value, unit], i): string[] =>
    [label, `${shortNumber(value)}${unit}`, ...(theirs[i] ? [`${shortNumber(theirs[i][1])}${unit}`] : [])]);
  if (film.absent(frame, t)) rows.push(["", "absent"]);
  const own = signals.filter(s => s.name.startsWith(owner) && !/\.[xyz]$/.test(s.name));
  for (const s of own.slice(0, kMostSignals)) {
    const same = twin >= 0 ? other?.signals.find(o => o.name === s.name) : undefined;
    rows.push([s.name.slice(owner.length), `${shortNumber(valueAt(s, t))} ${s.unit}`,
      ...(twin >= 0 ? [same ? `${shortNumber(valueAt(same, t))} ${same.unit}` : "\u2013"] : [])]);
  }
  if (own.length > kMostSignals) rows.push(["", `and ${own.length - kMostSignals} more signals`]);
  if (twin >= 0 && other) rows.unshift(["", "this run", other.title]);
  table.replaceChildren(...rows.map(cells => {
    const row = element("tr");
    row.append(...cells.map(text => element("td", text)));
    return row;
  }));
}
