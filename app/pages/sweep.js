"use strict";
// The page of a sweep: a line for one parameter, a map for two, points where values were drawn; a
// table that sorts by any column. All from the JSON in #data.
const sweep = JSON.parse(document.getElementById("data").textContent);
const names = sweep.parameters.concat(sweep.columns.map((c) => c.name));
const units = sweep.parameters.map(() => "").concat(sweep.columns.map((c) => c.unit));
const inputs = sweep.parameters.length;
const rows = sweep.rows.map((r) => ({ id: r.id, link: r.link, done: r.cells.length > 0,
  cells: r.values.concat(r.cells.length > 0 ? r.cells : sweep.columns.map(() => null)) }));
const stateColumn = inputs + sweep.measured;
const finished = (r) => r.cells[stateColumn] === "finished";

function make(tag, attributes, text) {
  const e = document.createElement(tag);
  for (const k in attributes || {}) e.setAttribute(k, attributes[k]);
  if (text !== undefined) e.textContent = text;
  return e;
}
function draw(tag, attributes, text) {
  const e = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const k in attributes) e.setAttribute(k, attributes[k]);
  if (text !== undefined) e.textContent = text;
  return e;
}
/** Six digits for people; the files hold all of them. */
function shown(x) {
  if (x === null || x === undefined) return "";
  if (typeof x !== "number") return String(x);
  const tiny = x !== 0 && (Math.abs(x) < 1e-3 || Math.abs(x) >= 1e6);
  const text = tiny ? x.toExponential(5).replace(/\.?0*e\+?/, "e") : String(Number(x.toPrecision(6)));
  return text.replace(/-/g, "\u2212");
}
const titled = (k) => names[k] + (units[k] ? " [" + units[k] + "]" : "");

// Facts
(function () {
  const done = rows.filter(finished).length, missing = rows.filter((r) => !r.done).length;
  const bad = rows.length - done - missing;
  const facts = document.getElementById("facts");
  facts.append(sweep.model + " \u00b7 " + rows.length + " runs, " + done + " finished");
  if (bad > 0) facts.append(", ", make("span", { class: "bad" }, bad + " failed"));
  if (missing > 0) facts.append(", ", make("span", { class: "bad" }, missing + " missing"));
  for (const [n, v] of sweep.fixed) facts.append(" \u00b7 " + n + " = " + v);
  facts.append(" \u00b7 dynamY " + sweep.dynamy);
})();

// Which parameters are axes. A parameter with texts (a scheme) has its values side by side.
const distinct = (k, among) => {
  const all = [...new Set((among || rows).map((r) => r.cells[k]))];
  return all.every((v) => typeof v === "number") ? all.sort((a, b) => a - b) : all;
};
const values = sweep.parameters.map((_, k) => distinct(k));
const numeric = (k) => values[k].every((v) => typeof v === "number");
/** Values of a range with equal ratios (or nearly) ask for a logarithmic axis. */
function spreadsByRatio(v) {
  if (v.length < 3 || !v.every((x) => typeof x === "number" && x > 0)) return false;
  const steps = v.slice(1).map((x, i) => x / v[i]);
  return Math.min(...steps) > 1 && Math.max(...steps) < Math.min(...steps) * 1.3 && v[v.length - 1] / v[0] > 9;
}
/** Of a full grid every value comes back; drawn values do not. */
const isGrid = (k) => rows.length === 1 || values[k].length <= Math.max(2, rows.length / 2) || inputs === 1;

const state = { show: inputs, x: 0, y: -1, fixed: sweep.parameters.map(() => null), logX: false, logY: false, logV: false };
const plottable = names.map((_, k) => k).filter((k) => k >= inputs && k !== stateColumn &&
  rows.some((r) => typeof r.cells[k] === "number"));
state.show = plottable[0] === undefined ? -1 : plottable[0];
state.y = inputs > 1 && isGrid(0) && isGrid(1) ? 1 : inputs > 1 && !isGrid(0) && !isGrid(1) ? 1 : -1;
state.logX = inputs > 0 && spreadsByRatio(values[0]);
state.logY = state.y > 0 && spreadsByRatio(values[state.y]);
for (let k = 0; k < inputs; ++k)
  if (k !== state.x && k !== state.y && isGrid(k)) state.fixed[k] = values[k][0];

function select(label, options, value, use) {
  const box = make("label", {}, label);
  const s = make("select");
  for (const [v, text] of options) {
    const o = make("option", { value: String(v) }, text);
    if (v === value) o.selected = true;
    s.append(o);
  }
  s.addEventListener("change", () => { use(options[s.selectedIndex][0]); update(); });
  box.append(s);
  return box;
}
function tick(label, value, use) {
  const box = make("label");
  const i = make("input", { type: "checkbox" });
  i.checked = value;
  i.addEventListener("change", () => { use(i.checked); update(); });
  box.append(i, " " + label);
  return box;
}
function choices() {
  const at = document.getElementById("choice");
  at.replaceChildren();
  if (state.show < 0) return;
  const parameters = sweep.parameters.map((n, k) => [k, n]);
  at.append(select("show", plottable.map((k) => [k, titled(k)]), state.show, (v) => { state.show = v; }));
  at.append(select("over", parameters, state.x, (v) => {
    if (v === state.y) state.y = state.x;
    state.x = v, state.logX = spreadsByRatio(values[v]), state.fixed[v] = null;
  }));
  if (inputs > 1)
    at.append(select("and", [[-1, "\u2013"]].concat(parameters.filter(([k]) => k !== state.x)), state.y, (v) => {
      state.y = v, state.logY = v >= 0 && spreadsByRatio(values[v]);
      if (v >= 0) state.fixed[v] = null;
    }));
  for (let k = 0; k < inputs; ++k)
    if (k !== state.x && k !== state.y && isGrid(k))
      at.append(select(names[k] + " =", [[null, "all"]].concat(values[k].map((v) => [v, shown(v)])), state.fixed[k],
        (v) => { state.fixed[k] = v; }));
  if (numeric(state.x) && values[state.x][0] > 0) at.append(tick("log " + names[state.x], state.logX, (v) => { state.logX = v; }));
  if (state.y >= 0 && numeric(state.y) && values[state.y][0] > 0)
    at.append(tick("log " + names[state.y], state.logY, (v) => { state.logY = v; }));
  if (rows.every((r) => !(r.cells[state.show] <= 0) || r.cells[state.show] === null))
    at.append(tick("log of what is shown", state.logV, (v) => { state.logV = v; }));
}

/** Maps numbers to pixels; texts and a map's cells by their place in the list. */
function axis(list, from, to, log, cells, distance = 80) {
  const size = to - from;
  if (cells || !list.every((v) => typeof v === "number")) {
    const wide = size / Math.max(list.length, 1);
    const every = Math.ceil(list.length / Math.max(1, Math.floor(Math.abs(size) / 70)));
    return { at: (v) => from + (list.indexOf(v) + 0.5) * wide, wide: Math.abs(wide),
      ticks: list.filter((_, i) => i % every === 0).map((v) => [v, shown(v)]) };
  }
  let lo = Math.min(...list), hi = Math.max(...list);
  if (log && lo > 0) {
    const a = Math.log10(lo), b = Math.log10(hi), pad = (b - a || 1) * 0.03;
    const at = (v) => from + (Math.log10(v) - a + pad) / (b - a + 2 * pad) * size;
    const ticks = [];
    const fine = b - a < 2.5 ? [1, 2, 5] : [1];
    for (let d = Math.floor(a); d <= Math.ceil(b); ++d)
      for (const m of fine) if (m * 10 ** d >= lo * 0.95 && m * 10 ** d <= hi * 1.05) ticks.push([m * 10 ** d, shown(m * 10 ** d)]);
    const most = Math.max(2, Math.abs(size) / 60), every = Math.ceil(ticks.length / most);
    return { at, ticks: ticks.filter((_, i) => i % every === 0) };
  }
  const pad = (hi - lo) * 0.04 || Math.abs(lo) * 0.1 || 1;
  lo -= pad, hi += pad;
  const raw = (hi - lo) / Math.max(2, Math.abs(size) / distance), power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw);
  const ticks = [];
  for (let i = Math.ceil(lo / step); i * step <= hi; ++i) ticks.push([i * step, shown(Number((i * step).toPrecision(12)))]);
  return { at: (v) => from + (v - lo) / (hi - lo) * size, ticks };
}

const W = 900, H = 430, LEFT = 92, RIGHT = 128, TOP = 14, BOTTOM = 52;
function frame(svg, x, y, xTitle, yTitle, right) {
  for (const [v, text] of x.ticks) {
    if (!x.wide) svg.append(draw("line", { class: "grid", x1: x.at(v), x2: x.at(v), y1: TOP, y2: H - BOTTOM }));
    svg.append(draw("text", { x: x.at(v), y: H - BOTTOM + 18, "text-anchor": "middle" }, text));
  }
  for (const [v, text] of y.ticks) {
    if (!y.wide) svg.append(draw("line", { class: "grid", x1: LEFT, x2: W - right, y1: y.at(v), y2: y.at(v) }));
    svg.append(draw("text", { x: LEFT - 8, y: y.at(v) + 4, "text-anchor": "end" }, text));
  }
  svg.append(draw("path", { class: "axis", d: `M${LEFT} ${TOP}V${H - BOTTOM}H${W - right}` }));
  svg.append(draw("text", { class: "label", x: (LEFT + W - right) / 2, y: H - 10, "text-anchor": "middle" }, xTitle));
  svg.append(draw("text", { class: "label", transform: `translate(16 ${(TOP + H - BOTTOM) / 2}) rotate(-90)`, "text-anchor": "middle" }, yTitle));
}

// Viridis in nine stops: told apart in print and by the colour-blind.
const STOPS = ["440154", "472d7b", "3b528b", "2c728e", "21918c", "28ae80", "5ec962", "addc30", "fde725"]
  .map((h) => [0, 2, 4].map((i) => parseInt(h.slice(i, i + 2), 16)));
function colour(s) {
  const p = Math.min(Math.max(s, 0), 1) * (STOPS.length - 1), i = Math.min(Math.floor(p), STOPS.length - 2);
  return "rgb(" + STOPS[i].map((a, k) => Math.round(a + (STOPS[i + 1][k] - a) * (p - i))).join(",") + ")";
}

function point(e, r) {
  const figure = document.getElementById("picture");
  e.addEventListener("pointerenter", () => {
    document.getElementById("tip")?.remove();
    const text = sweep.parameters.map((n, k) => n + " = " + shown(r.cells[k])).join(", ");
    const tip = make("div", { id: "tip" });
    tip.append(text, make("br"), r.done ? (finished(r) ? titled(state.show) + ": " + shown(r.cells[state.show]) : String(r.cells[stateColumn])) : "missing");
    figure.append(tip);
    const box = e.getBoundingClientRect(), own = figure.getBoundingClientRect();
    const half = tip.offsetWidth / 2, middle = box.left + box.width / 2 - own.left;
    tip.style.left = Math.min(Math.max(middle, half), Math.max(own.width - half, half)) + "px";
    tip.style.top = box.top - own.top - 4 + "px";
  });
  e.addEventListener("pointerleave", () => document.getElementById("tip")?.remove());
  e.addEventListener("click", () => here(r.id, true));
  e.style.cursor = "pointer";
}

/** Colour of line i of n, away from that of the paper. */
function lineColour(i, n) {
  const s = 0.9 * i / (n - 1);
  return colour(matchMedia("(prefers-color-scheme: dark)").matches ? 1 - s : s);
}

function lines(svg, chosen, x, y) {
  const k = state.show;
  const others = sweep.parameters.map((_, i) => i).filter((i) => i !== state.x && isGrid(i));
  const series = new Map();  // one line for each combination of the other parameters
  for (const r of chosen) {
    const key = others.map((i) => names[i] + " = " + shown(r.cells[i])).join(", ");
    series.set(key, (series.get(key) || []).concat([r]));
  }
  const drawn = !isGrid(state.x);
  let i = 0;
  for (const [key, list] of series) {
    const c = series.size === 1 ? "var(--curve)" : lineColour(i, series.size);
    if (numeric(state.x)) list.sort((a, b) => a.cells[state.x] - b.cells[state.x]);
    let d = "";
    for (const r of list)
      d += typeof r.cells[k] === "number" ? (d === "" || d.endsWith(" ") ? "M" : "L") + x.at(r.cells[state.x]) + "," + y.at(r.cells[k]) : " ";
    if (!drawn && numeric(state.x)) svg.append(draw("path", { d, fill: "none", stroke: c, "stroke-width": 1.6 }));
    for (const r of list) {
      if (typeof r.cells[k] !== "number") continue;
      const p = draw("circle", { cx: x.at(r.cells[state.x]), cy: y.at(r.cells[k]), r: rows.length > 300 ? 2 : 3.5, fill: c });
      point(p, r);
      svg.append(p);
    }
    if (series.size > 1 && series.size <= 20) {
      svg.append(draw("circle", { cx: W - RIGHT + 12, cy: TOP + 8 + 18 * i, r: 4, fill: c }));
      svg.append(draw("text", { x: W - RIGHT + 20, y: TOP + 12 + 18 * i }, key));
    }
    ++i;
  }
}

function map(svg, chosen, x, y, low, high) {
  const scale = (v) => high > low ? (state.logV ? Math.log(v / low) / Math.log(high / low) : (v - low) / (high - low)) : 0.5;
  for (const r of chosen) {
    const v = r.cells[state.show], known = typeof v === "number";
    const fill = known ? colour(scale(v)) : "var(--bad-wash)";
    const px = x.at(r.cells[state.x]), py = y.at(r.cells[state.y]);
    const p = x.wide && y.wide
      ? draw("rect", { x: px - x.wide / 2, y: py - y.wide / 2, width: x.wide + 0.4, height: y.wide + 0.4, fill })
      : draw("circle", { cx: px, cy: py, r: 4.5, fill, stroke: known ? "none" : "var(--bad)" });
    point(p, r);
    svg.append(p);
  }
  const bar = H - BOTTOM - TOP, left = W - RIGHT + 22;
  for (let i = 0; i < 64; ++i)
    svg.append(draw("rect", { x: left, y: H - BOTTOM - (i + 1) * bar / 64, width: 16, height: bar / 64 + 0.5, fill: colour(i / 63) }));
  const ends = axis([low, high], H - BOTTOM, TOP, state.logV, false, 45);
  for (const [v, text] of ends.ticks) {
    const s = scale(v);
    if (s >= -1e-9 && s <= 1 + 1e-9) svg.append(draw("text", { x: left + 22, y: H - BOTTOM - s * bar + 4 }, text));
  }
}

function picture() {
  const figure = document.getElementById("picture");
  figure.replaceChildren();
  if (state.show < 0) return figure.append(make("p", { class: "soft" }, "No run has a number to show yet."));
  const chosen = rows.filter((r) => state.fixed.every((v, k) => v === null || k === state.x || k === state.y || r.cells[k] === v));
  const seen = chosen.map((r) => r.cells[state.show]).filter((v) => typeof v === "number");
  if (seen.length === 0) return figure.append(make("p", { class: "soft" }, "No run has this value."));
  const low = Math.min(...seen), high = Math.max(...seen);
  const svg = draw("svg", { viewBox: `0 0 ${W} ${H}`, role: "img", "aria-label": titled(state.show) });
  const two = state.y >= 0, grid = two && isGrid(state.x) && isGrid(state.y);
  const others = sweep.parameters.some((_, k) => k !== state.x && isGrid(k) && state.fixed[k] === null);
  const right = two || others ? RIGHT : 20;
  const x = axis(distinct(state.x, chosen), LEFT, W - right, state.logX, grid);
  const y = two ? axis(distinct(state.y, chosen), H - BOTTOM, TOP, state.logY, grid) : axis([low, high], H - BOTTOM, TOP, state.logV, false, 55);
  frame(svg, x, y, names[state.x], two ? names[state.y] : titled(state.show), right);
  if (two) {
    map(svg, chosen, x, y, low, high);
    svg.append(draw("text", { class: "label", transform: `translate(${W - 8} ${(TOP + H - BOTTOM) / 2}) rotate(-90)`, "text-anchor": "middle" }, titled(state.show)));
  } else {
    lines(svg, chosen, x, y);
  }
  figure.append(svg);
}

// Table
const order = { column: -1, down: false };
/** Columns that say the same of every run are left out of the table; results.csv has them. */
const told = names.map((_, k) => k).filter((k) => k < stateColumn || names[k] === "state" ||
  (names[k] !== "hash" && new Set(rows.filter((r) => r.done).map((r) => r.cells[k])).size > 1));
function compare(a, b) {
  const x = order.column < 0 ? a.id : a.cells[order.column], y = order.column < 0 ? b.id : b.cells[order.column];
  if (x === y) return a.id - b.id;
  if (x === null || y === null) return x === null ? 1 : -1;  // what is not there stays last
  const less = typeof x === "number" && typeof y === "number" ? x - y : String(x) < String(y) ? -1 : 1;
  return order.down ? -less : less;
}
function table() {
  const t = make("table"), head = make("tr");
  const column = (k, text) => {
    const th = make("th", { scope: "col", class: k >= 0 && ["state", "warnings", "message"].includes(names[k]) ? "text" : "" });
    const button = make("button", { type: "button" }, text);
    th.append(button);
    if (order.column === k) th.setAttribute("aria-sort", order.down ? "descending" : "ascending");
    th.addEventListener("click", () => {
      order.down = order.column === k && !order.down;
      order.column = k;
      table();
    });
    head.append(th);
  };
  column(-1, "run");
  for (const k of told) column(k, titled(k));
  const body = make("tbody");
  for (const r of [...rows].sort(compare)) {
    const tr = make("tr", { id: "run" + r.id, class: r.done && finished(r) ? "" : "wrong" });
    const first = make("td");
    first.append(r.link ? make("a", { href: r.link }, String(r.id)) : String(r.id));
    tr.append(first);
    for (const k of told) {
      const message = names[k] === "message";
      tr.append(make("td", { class: k < inputs ? "input" : message ? "long" : names[k] === "state" || names[k] === "warnings" ? "text" : "" },
        k === stateColumn && !r.done ? "missing" : shown(r.cells[k])));
    }
    body.append(tr);
  }
  const thead = make("thead");
  thead.append(head);
  t.append(thead, body);
  document.getElementById("runs").replaceChildren(t);
}
function here(id, scroll) {
  for (const e of document.querySelectorAll("#runs tr.here")) e.classList.remove("here");
  const tr = document.getElementById("run" + id);
  tr.classList.add("here");
  if (scroll) tr.scrollIntoView({ block: "nearest", behavior: "smooth" });
}
function update() {
  choices();
  picture();
}
update();
table();
