// plots.js: the recorded signals over time, with a cursor at the time of the picture.

const kCurves = ["#1769aa", "#c2410c", "#2f7d32", "#7b3fa0", "#b3861b", "#5b6472"];

/** Signals of one element with the same unit share a panel; without a unit each has its own. */
function panelsOf(signals) {
  const panels = [];
  const owner = name => name.includes(".") ? name.slice(0, name.lastIndexOf(".")) : name;
  for (const s of signals) {
    const panel = s.unit && panels.find(p =>
      p[0].unit === s.unit && owner(p[0].name) === owner(s.name) && p.length < kCurves.length);
    if (panel) panel.push(s); else panels.push([s]);
  }
  return panels;
}

class Plots {
  /** Fills `box` with one canvas a panel; `seek(t)` is called when a time is pointed at. */
  constructor(box, signals, begin, end, seek) {
    this.begin = begin;
    this.end = end > begin ? end : begin + 1;
    this.seek = seek;
    this.panels = panelsOf(signals).slice(0, 40).map(members => this.addPanel(box, members));
  }

  addPanel(box, members) {
    const div = document.createElement("div");
    div.className = "plot";
    const names = document.createElement("div");
    names.className = "names";
    const values = members.map((s, i) => {
      const span = document.createElement("span"), value = document.createElement("em");
      span.textContent = s.name;
      span.style.color = kCurves[i];
      span.append(value);
      names.append(span);
      return value;
    });
    if (members[0].unit) {
      const unit = document.createElement("small");
      unit.textContent = "[" + members[0].unit + "]";
      names.append(unit);
    }
    const canvas = document.createElement("canvas");
    div.append(names, canvas);
    box.append(div);

    let lo = Infinity, hi = -Infinity;
    for (const s of members) {
      for (const y of s.y) {
        if (!Number.isFinite(y)) continue;
        lo = Math.min(lo, y);
        hi = Math.max(hi, y);
      }
    }
    if (!(lo <= hi)) [lo, hi] = [0, 1];
    let margin = 0.07 * (hi - lo);
    if (hi - lo <= 1e-6 * Math.max(Math.abs(lo), Math.abs(hi)) || hi === lo) margin = lo === 0 ? 1 : 0.1 * Math.abs(lo);
    const panel = {canvas, members, values, lo: lo - margin, hi: hi + margin, curves: null};

    const point = event => {
      const {left} = canvas.getBoundingClientRect(), area = this.area(panel);
      const share = clamp((event.clientX - left - area.left) / area.width, 0, 1);
      this.seek(this.begin + share * (this.end - this.begin));
    };
    canvas.addEventListener("pointerdown", event => {
      canvas.setPointerCapture(event.pointerId);
      point(event);
    });
    canvas.addEventListener("pointermove", event => { if (event.buttons) point(event); });
    return panel;
  }

  area(panel) {
    return {left: 54, top: 8, width: panel.canvas.clientWidth - 54 - 10, height: panel.canvas.clientHeight - 8 - 22};
  }

  /** Draws the curves once for the present size; draw(t) then only copies them. */
  resize() {
    const ratio = window.devicePixelRatio || 1;
    for (const panel of this.panels) {
      const {canvas} = panel;
      canvas.width = Math.round(canvas.clientWidth * ratio);
      canvas.height = Math.round(canvas.clientHeight * ratio);
      panel.curves = document.createElement("canvas");
      panel.curves.width = canvas.width;
      panel.curves.height = canvas.height;
      const ctx = panel.curves.getContext("2d");
      ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
      this.paintCurves(ctx, panel);
    }
  }

  paintCurves(ctx, panel) {
    const {left, top, width, height} = this.area(panel);
    const x = t => left + width * (t - this.begin) / (this.end - this.begin);
    const y = v => top + height * (panel.hi - v) / (panel.hi - panel.lo);
    ctx.font = "11px 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";
    ctx.fillStyle = "#5f6c7b";
    ctx.lineWidth = 1;
    const line = (x1, y1, x2, y2, colour) => {
      ctx.strokeStyle = colour;
      ctx.stroke(polygonPath([[x1, y1], [x2, y2]], false));
    };
    const rows = niceTicks(panel.lo, panel.hi, 5);
    const far = rows.values.some(v => tickLabel(v, rows.step).length > 7);
    ctx.textAlign = "right";
    ctx.textBaseline = "middle";
    for (const v of rows.values) {
      const at = Math.round(y(v)) + 0.5;
      line(left, at, left + width, at, v === 0 ? "#aab4bf" : "#e6e9ed");
      const label = far ? "+" + tickLabel(v - rows.values[0], rows.step) : tickLabel(v, rows.step);
      ctx.fillText(label, left - 5, at);
    }
    if (far) {  // long numbers that hardly differ: the lowest tick in full, the others from there
      ctx.textAlign = "left";
      ctx.fillText("0 is " + tickLabel(rows.values[0], rows.step), left + 5, top + 5);
    }
    const columns = niceTicks(this.begin, this.end, Math.max(4, Math.floor(width / 48)));
    ctx.textAlign = "center";
    ctx.textBaseline = "top";
    for (const t of columns.values) {
      const at = Math.round(x(t)) + 0.5;
      line(at, top, at, top + height, "#e6e9ed");
      ctx.fillText(tickLabel(t, columns.step), at, top + height + 5);
    }
    line(left + 0.5, top, left + 0.5, top + height, "#9aa5b1");
    line(left, top + height + 0.5, left + width, top + height + 0.5, "#9aa5b1");

    ctx.beginPath();
    ctx.rect(left, 0, width + 1, top + height + 1);
    ctx.clip();
    panel.members.forEach((s, k) => {
      ctx.strokeStyle = kCurves[k];
      ctx.lineWidth = 1.6;
      ctx.lineJoin = "round";
      ctx.beginPath();
      let down = false;
      for (let i = 0; i < s.t.length; ++i) {
        if (!Number.isFinite(s.y[i])) { down = false; continue; }
        if (down) ctx.lineTo(x(s.t[i]), y(s.y[i])); else ctx.moveTo(x(s.t[i]), y(s.y[i]));
        down = true;
      }
      ctx.stroke();
    });
  }

  draw(t) {
    const ratio = window.devicePixelRatio || 1;
    for (const panel of this.panels) {
      if (!panel.curves) continue;
      const ctx = panel.canvas.getContext("2d"), {left, top, width, height} = this.area(panel);
      ctx.setTransform(1, 0, 0, 1, 0, 0);
      ctx.clearRect(0, 0, panel.canvas.width, panel.canvas.height);
      ctx.drawImage(panel.curves, 0, 0);
      ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
      const x = left + width * clamp((t - this.begin) / (this.end - this.begin), 0, 1);
      ctx.strokeStyle = "#1f2933";
      ctx.lineWidth = 1.2;
      ctx.stroke(polygonPath([[x, top - 4], [x, top + height]], false));
      panel.members.forEach((s, k) => {
        const value = s.t.length ? s.y[lastAtOrBefore(s.t, t)] : NaN;
        panel.values[k].textContent = shortNumber(value);
        if (!Number.isFinite(value)) return;
        ctx.fillStyle = kCurves[k];
        ctx.strokeStyle = "#ffffff";
        ctx.lineWidth = 1.5;
        ctx.beginPath();
        ctx.arc(x, top + height * (panel.hi - value) / (panel.hi - panel.lo), 4, 0, 2 * Math.PI);
        ctx.fill();
        ctx.stroke();
      });
    }
  }
}
