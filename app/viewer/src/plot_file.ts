// The curves of one plot as files: CSV with all their numbers, SVG as they are seen.
import {niceTicks, shortNumber, tickLabel} from "./math";
import type {PlotPanel} from "./plots";
import {kCurves} from "./theme";

/** A file that the browser saves. */
export function saveText(name: string, type: string, text: string): void {
  const a = document.createElement("a");
  a.href = URL.createObjectURL(new Blob([text], {type}));
  a.download = name;
  a.click();
  setTimeout(() => URL.revokeObjectURL(a.href), 1000);
}

export const plotName = (panel: PlotPanel): string =>
  (panel.title ?? panel.curves.map(c => c.name).join("_")).replace(/[^\w.-]+/g, "_").slice(0, 60);

const quoted = (text: string): string => /[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;

/** One row an instant of any curve; a curve without a number there has an empty field. */
export function csvOf(panel: PlotPanel): string {
  // by the instant and how many rows of the curve it had before: an impact has one on each side of it
  const rows = new Map<string, {t: number; before: number; values: (number | undefined)[]}>();
  panel.curves.forEach((c, k) => {
    for (let i = 0, before = 0; i < c.t.length; ++i) {
      before = i > 0 && c.t[i] === c.t[i - 1] ? before + 1 : 0;
      const key = `${c.t[i]} ${before}`;
      const row = rows.get(key) ?? {t: c.t[i], before, values: new Array<undefined>(panel.curves.length).fill(undefined)};
      row.values[k] = c.y[i];
      rows.set(key, row);
    }
  });
  const head = ["t [s]", ...panel.curves.map(c => panel.unit ? `${c.name} [${panel.unit}]` : c.name)].map(quoted).join(",");
  const sorted = [...rows.values()].sort((a, b) => a.t - b.t || a.before - b.before);
  const lines = sorted.map(({t, values}) => [t, ...values.map(x => x ?? "")].join(","));
  return `${[head, ...lines].join("\n")}\n`;
}

const escaped = (text: string): string => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");

/** The plot from time lo to hi, on white paper. */
export function svgOf(panel: PlotPanel, shown: boolean[], lo: number, hi: number): string {
  const W = 720, H = 300, left = 70, right = 16, top = 30, bottom = 40;
  const value = (y: number): number => panel.log ? (y > 0 ? Math.log10(y) : NaN) : y;
  let least = Infinity, most = -Infinity;
  panel.curves.forEach((c, k) => {
    for (let i = 0; shown[k] && i < c.t.length; ++i) {
      const y = value(c.y[i]);
      if (c.t[i] < lo || c.t[i] > hi || !Number.isFinite(y)) continue;
      least = Math.min(least, y);
      most = Math.max(most, y);
    }
  });
  if (!(least <= most)) { least = 0; most = 1; }
  const margin = most > least ? 0.06 * (most - least) : Math.abs(most) * 0.1 || 1;
  least -= margin;
  most += margin;
  const x = (t: number): number => left + (W - left - right) * (t - lo) / (hi - lo || 1);
  const y = (v: number): number => H - bottom - (H - top - bottom) * (v - least) / (most - least);
  const text = (px: number, py: number, words: string, anchor: string, colour = "#5f6c7b"): string =>
    `<text x="${px.toFixed(1)}" y="${py.toFixed(1)}" text-anchor="${anchor}" fill="${colour}">${escaped(words)}</text>`;
  const parts: string[] = [];
  const xs = niceTicks(lo, hi, 8), ys = niceTicks(least, most, 6);
  for (const t of xs.values) {
    parts.push(`<path d="M${x(t).toFixed(1)} ${top}V${H - bottom}" stroke="#e3e7ec"/>`, text(x(t), H - bottom + 16, tickLabel(t, xs.step), "middle"));
  }
  for (const v of ys.values) {
    parts.push(`<path d="M${left} ${y(v).toFixed(1)}H${W - right}" stroke="#e3e7ec"/>`,
      text(left - 8, y(v) + 4, panel.log ? shortNumber(10 ** v) : tickLabel(v, ys.step), "end"));
  }
  let at = left;
  panel.curves.forEach((c, k) => {
    if (!shown[k]) return;
    let d = "", pen = "M";
    for (let i = 0; i < c.t.length; ++i) {
      const v = value(c.y[i]);
      if (c.t[i] < lo || c.t[i] > hi) continue;
      if (!Number.isFinite(v)) { pen = "M"; continue; }
      d += `${pen}${x(c.t[i]).toFixed(1)} ${y(v).toFixed(1)}`;
      pen = "L";
    }
    const colour = kCurves[(c.colour ?? k) % kCurves.length];
    parts.push(`<path d="${d}" fill="none" stroke="${colour}" stroke-width="1.5"${c.dashed ? ' stroke-dasharray="5 4"' : ""}/>`,
      `<path d="M${at} 14h22" fill="none" stroke="${colour}" stroke-width="1.5"${c.dashed ? ' stroke-dasharray="5 4"' : ""}/>`,
      text(at + 27, 18, c.name, "start", colour));
    at += 7.2 * c.name.length + 45;
  });
  parts.push(text(W - right, H - 8, "t [s]", "end"), text(W - right, 18, panel.unit ? `[${panel.unit}]` : "", "end"));
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${W} ${H}" width="${W}" height="${H}" font-family="sans-serif" font-size="12">` +
    `<rect width="${W}" height="${H}" fill="#fff"/>${parts.join("\n")}</svg>\n`;
}
