// Impacts and switches as ticks on the time line: impacts above the slider, switches below.
import type {Event} from "./data";
import {kStates, theme} from "./theme";

const kPad = 8;  // half a thumb: where the slider begins and ends [pixel]

/** Where there are two runs, marks of the second are the outer halves and those of the first the inner ones. */
export function paintMarks(canvas: HTMLElement, events: Event[], begin: number, end: number): void {
  if (!(canvas instanceof HTMLCanvasElement)) return;
  const ratio = window.devicePixelRatio || 1, {clientWidth: w, clientHeight: h} = canvas;
  canvas.width = w * ratio;
  canvas.height = h * ratio;
  const ctx = canvas.getContext("2d");
  if (!ctx || !w || !(end > begin)) return;
  ctx.scale(ratio, ratio);
  const two = events.some(e => e.other), size = two ? 3 : 6;
  for (const impact of [false, true]) {
    ctx.fillStyle = (impact ? kStates[3] : kStates[2]).colour + (theme.dark ? "b0" : "90");
    const drawn = [new Set<number>(), new Set<number>()];
    for (const e of events) {
      if (e.impact !== impact || e.brief) continue;
      const x = Math.round(kPad + (w - 2 * kPad) * (e.t - begin) / (end - begin));
      const outer = two && e.other === true, seen = drawn[outer ? 1 : 0];
      if (seen.has(x)) continue;
      seen.add(x);
      const inner = two && !outer ? size : 0;  // how far from the upper edge
      ctx.fillRect(x, impact ? inner : 25 - size - inner, 1.4, size);
    }
  }
}
