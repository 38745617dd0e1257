// replay.js: the page: time, buttons, keys, pointer, panels. Starts at the end of this file.
// The address may carry #t=0.45&view=xz&play=1&trails=1&azimuth=-40&elevation=30&select=2.

const byId = id => document.getElementById(id);
const kSpeeds = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50];
const kViews = {xy: "x\u2013y", xz: "x\u2013z", yz: "y\u2013z", iso: "3D"};
const kPlayIcon = '<svg viewBox="0 0 14 14"><path d="M2 0.5v13l11-6.5z"/></svg>';
const kPauseIcon = '<svg viewBox="0 0 14 14"><path d="M2 1h3.6v12H2zM8.4 1H12v12H8.4z"/></svg>';
const kKeys = [["space", "play, pause"], ["\u2190 \u2192", "one frame back, on"],
  ["shift \u2190 \u2192", "a tenth of the film"], ["home end", "first, last frame"], ["+ \u2212", "faster, slower"],
  ["1 2 3 4", "view x\u2013z, x\u2013y, y\u2013z, 3D"], ["0", "fit"], ["c t", "contacts, trails"],
  ["f", "follow what is selected, else the body the model names, else the first"], ["drag", "turn (3D) or move; with shift: move"], ["wheel", "zoom"],
  ["click", "name and place of a body"]];

class Replay {
  constructor(data) {
    this.data = data;
    this.film = new Film(data.frames);
    const signals = decodeSignals(data.signals, data.run);
    const times = [this.film.t, ...signals.map(s => s.t)].filter(t => t.length);
    this.begin = Math.min(...times.map(t => t[0]));
    this.end = Math.max(...times.map(t => t[t.length - 1]));
    if (!(this.begin <= this.end)) this.begin = this.end = 0;
    this.t = this.begin;
    this.playing = false;
    this.picture = new Picture(byId("picture"), data.scene, this.film);
    const follow = data.scene.follow ?? -1;
    this.picture.follow(follow < this.film.poses ? follow : -1, this.t);
    this.plots = new Plots(byId("plots"), signals, this.begin, this.end, t => this.pause().seek(t));
    const main = document.querySelector("main");
    main.classList.toggle("alone", !signals.length && !data.model.text && !data.run);
    main.classList.toggle("unseen", !data.scene.shapes.length && signals.length > 0);
    this.fillPanels();
    this.addTransport();
    this.addTools();
    this.addPointer();
    document.addEventListener("keydown", event => this.key(event));
    window.addEventListener("resize", () => this.resize());
    window.addEventListener("hashchange", () => this.readAddress());
    this.resize();
    this.setView(this.picture.naturalView());
    this.readAddress();
  }

  // --- time

  seek(t) {
    this.t = clamp(t, this.begin, this.end);
    this.draw();
    return this;
  }

  play() {
    if (this.playing) return;
    if (this.t >= this.end) this.t = this.begin;
    this.playing = true;
    byId("play").innerHTML = kPauseIcon;
    let before = performance.now();
    const tick = now => {
      if (!this.playing) return;
      let t = this.t + (now - before) / 1000 * Number(byId("speed").value);
      before = now;
      if (t > this.end) {
        if (byId("loop").checked && this.end > this.begin) {
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

  pause() {
    this.playing = false;
    byId("play").innerHTML = kPlayIcon;
    return this;
  }

  toggle() { if (this.playing) this.pause(); else this.play(); }

  /** To the next or the previous recorded frame. */
  step(by) {
    this.pause();
    if (!this.film.count) return;
    const f = this.film.indexAt(this.t);
    const between = this.t > this.film.t[f];
    this.seek(this.film.t[clamp(by < 0 && between ? f : f + by, 0, this.film.count - 1)]);
  }

  faster(by) {
    const select = byId("speed");
    select.selectedIndex = clamp(select.selectedIndex + by, 0, kSpeeds.length - 1);
  }

  // --- picture

  draw() {
    const {picture} = this, {selected} = picture;
    picture.draw(this.t);
    this.plots.draw(this.t);
    byId("scrub").value = this.end > this.begin ? (this.t - this.begin) / (this.end - this.begin) : 0;
    const digits = clamp(3 - Math.floor(Math.log10(this.end - this.begin || 1)), 0, 9);
    byId("clock").innerHTML = `${this.t.toFixed(digits)} <small>/ ${this.end.toFixed(digits)} s</small>`;
    const box = byId("selected");
    box.hidden = selected < 0;
    if (selected >= 0) {
      const r = this.film.pose(selected, this.t).r.map(shortNumber);
      box.querySelector("span").textContent = `x  ${r[0]}\ny  ${r[1]}\nz  ${r[2]}  m`;
    }
  }

  resize() {
    this.picture.resize();
    this.plots.resize();
    this.draw();
  }

  setView(view) {
    this.picture.setView(view in kViews ? view : "iso");
    for (const button of byId("views").children) {
      button.classList.toggle("on", button.dataset.view === this.picture.camera.view);
    }
    this.draw();
  }

  setSwitch(name, on) {
    this.picture.show[name] = on;
    const button = byId("switches").querySelector(`[data-name=${name}]`);
    if (button) button.classList.toggle("on", on);
    byId("legend").hidden = !(this.picture.show.contacts && this.film.contact.length);
    this.draw();
  }

  /** The camera goes with what is selected, or with what the model names; or it stands again. */
  setFollow(on) {
    const {picture, film} = this, named = this.data.scene.follow ?? film.firstMoving();
    const frame = picture.selected >= 0 ? picture.selected : named;
    picture.follow(on ? frame : -1, this.t);
    if (picture.selected < 0) picture.fit();
    this.showFollow();
    this.draw();
  }

  showFollow() {
    const button = byId("switches").querySelector("[data-name=follow]");
    if (button) button.classList.toggle("on", this.picture.followed >= 0);
  }

  /** Shows name, place in the model and position of a frame; −1: of none. */
  select(frame) {
    this.picture.selected = frame;
    const known = this.data.scene.frames[frame];
    if (known) {
      const box = byId("selected"), name = document.createElement("b");
      name.textContent = known.name;
      box.replaceChildren(name, "\n", document.createElement("span"));
      if (known.place) {
        const place = document.createElement("a");
        place.textContent = known.place;
        place.onclick = () => this.showLine(known.place);
        box.append("\n", place);
      }
    } else {
      this.picture.selected = -1;
    }
    this.draw();
  }

  // --- panels

  fillPanels() {
    const {title, run, model} = this.data;
    byId("title").textContent = title;
    const facts = byId("run").querySelector(".body");
    if (run) facts.append(tableOf(run)); else byId("run").hidden = true;
    byId("facts").innerHTML = headline(run, this.film, this.begin, this.end, this.data.frames.recorded);
    if (!model.text) byId("model").hidden = true;
    const pre = document.createElement("pre");
    for (const line of model.text.replace(/\n$/, "").split("\n")) {
      const code = document.createElement("code");
      code.textContent = line;
      pre.append(code);
    }
    byId("model").querySelector(".body").append(pre);
    byId("model").querySelector("summary").textContent = "Model " + (model.name || "");
    byId("legend").innerHTML = kStates.slice(1).map(s => `<span><i style="background:${s.colour}"></i>${s.name}</span>`).join("");
    byId("help").innerHTML = `<table>${kKeys.map(([k, v]) => `<tr><td>${k}</td><td>${v}</td></tr>`).join("")}</table>`;
  }

  /** Opens the model at the line of "file:line". */
  showLine(place) {
    byId("model").open = true;
    const lines = byId("model").querySelectorAll("code");
    lines.forEach(l => l.classList.remove("here"));
    const line = lines[Number((place.match(/:(\d+)/) || [])[1]) - 1];
    if (!line) return;
    line.classList.add("here");
    line.scrollIntoView({block: "center"});
  }

  // --- controls

  addTransport() {
    const span = this.end - this.begin;
    const wanted = span > 120 ? span / 60 : span < 4 ? span / 4 : 1;
    const best = kSpeeds.filter(s => s <= Math.max(wanted, kSpeeds[0]) * 1.05).pop();
    byId("speed").innerHTML = kSpeeds.map(s =>
      `<option value="${s}" ${s === best ? "selected" : ""}>${s < 1 ? "1/" + Math.round(1 / s) : "\u00d7" + s}</option>`).join("");
    byId("play").innerHTML = kPlayIcon;
    byId("play").onclick = () => this.toggle();
    byId("back").onclick = () => this.step(-1);
    byId("step").onclick = () => this.step(1);
    byId("scrub").oninput = event =>
      this.pause().seek(this.begin + Number(event.target.value) * (this.end - this.begin));
    byId("link").onclick = () => this.copyLink();
    byId("png").onclick = () => {
      const a = document.createElement("a");
      a.href = byId("picture").toDataURL("image/png");
      a.download = `${this.data.title}_${this.t.toFixed(3)}s.png`;
      a.click();
    };
    byId("ask").onclick = () => { byId("help").hidden = !byId("help").hidden; };
  }

  addTools() {
    const button = (box, text, title, act) => {
      const b = document.createElement("button");
      b.textContent = text;
      b.title = title;
      b.onclick = act;
      byId(box).append(b);
      return b;
    };
    for (const view of ["xz", "xy", "yz", "iso"]) {
      button("views", kViews[view], "view", () => this.setView(view)).dataset.view = view;
    }
    button("views", "fit", "show everything (0)", () => { this.picture.fit(); this.draw(); });
    for (const name of this.film.contact.length ? ["contacts", "trails"] : ["trails"]) {
      button("switches", name, "", () => this.setSwitch(name, !this.picture.show[name])).dataset.name = name;
    }
    button("switches", "follow", "the camera goes with what is selected (f)",
      () => this.setFollow(this.picture.followed < 0)).dataset.name = "follow";
    this.showFollow();
    for (const name of ["contacts", "trails"]) this.setSwitch(name, this.picture.show[name]);
  }

  addPointer() {
    const canvas = byId("picture"), {camera} = this.picture;
    let moved = 0;
    canvas.addEventListener("pointerdown", event => {
      canvas.setPointerCapture(event.pointerId);
      canvas.classList.add("dragged");
      moved = 0;
    });
    canvas.addEventListener("pointermove", event => {
      if (!event.buttons) return;
      moved += Math.abs(event.movementX) + Math.abs(event.movementY);
      if (camera.isPlanar || event.shiftKey || event.buttons !== 1) {
        camera.pan(event.movementX, event.movementY);
      } else {
        camera.orbit(event.movementX, event.movementY);
      }
      this.draw();
    });
    canvas.addEventListener("pointerup", event => {
      canvas.classList.remove("dragged");
      if (moved > 4) return;
      const shape = this.picture.pick(event.offsetX, event.offsetY);
      this.select(shape ? shape.frame : -1);
    });
    canvas.addEventListener("wheel", event => {
      event.preventDefault();
      camera.zoom(Math.exp(-0.0012 * event.deltaY), event.offsetX, event.offsetY);
      this.draw();
    }, {passive: false});
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === "SELECT") return;
    const tenth = (this.end - this.begin) / 10;
    const sideways = by => event.shiftKey ? this.pause().seek(this.t + by * tenth) : this.step(by);
    const acts = {
      " ": () => this.toggle(), ArrowLeft: () => sideways(-1), ArrowRight: () => sideways(1),
      Home: () => this.pause().seek(this.begin), End: () => this.pause().seek(this.end),
      "+": () => this.faster(1), "-": () => this.faster(-1),
      1: () => this.setView("xz"), 2: () => this.setView("xy"), 3: () => this.setView("yz"), 4: () => this.setView("iso"),
      0: () => { this.picture.fit(); this.draw(); },
      c: () => this.setSwitch("contacts", !this.picture.show.contacts),
      t: () => this.setSwitch("trails", !this.picture.show.trails),
      f: () => this.setFollow(this.picture.followed < 0),
      "?": () => byId("ask").click(), Escape: () => { byId("help").hidden = true; this.select(-1); }
    };
    if (!acts[event.key]) return;
    event.preventDefault();
    acts[event.key]();
  }

  // --- address

  copyLink() {
    const {camera} = this.picture;
    const part = {t: Number(this.t.toPrecision(9)), view: camera.view};
    if (!camera.isPlanar) {
      part.azimuth = Math.round(camera.azimuth * 180 / Math.PI);
      part.elevation = Math.round(camera.elevation * 180 / Math.PI);
    }
    history.replaceState(null, "", "#" + new URLSearchParams(part));  // unlike a new hash: no event
    if (navigator.clipboard) navigator.clipboard.writeText(location.href).catch(() => {});
  }

  readAddress() {
    const part = new URLSearchParams(location.hash.slice(1));
    const {camera} = this.picture;
    for (const angle of ["azimuth", "elevation"]) {
      if (part.has(angle)) camera[angle] = Number(part.get(angle)) * Math.PI / 180;
    }
    if (part.has("view")) this.setView(part.get("view")); else { camera.look(); this.picture.fit(); }
    for (const name of ["contacts", "trails"]) if (part.has(name)) this.setSwitch(name, part.get(name) !== "0");
    if (part.has("select")) this.select(Number(part.get("select")));
    if (part.has("open")) byId(part.get("open") === "model" ? "model" : "run").open = true;
    const t = Number(part.get("t"));
    this.pause().seek(part.has("t") && Number.isFinite(t) ? t : this.t);
    if (part.get("play") === "1") this.play();
  }
}

new Replay(JSON.parse(byId("data").textContent));
