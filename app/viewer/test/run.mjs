// The replay in headless Chromium: it opens from disk, asks for nothing else, says no error, paints
// something, and its controls act. Skips (exit 77) where Chromium or playwright-core is missing.
//   node test/run.mjs PROGRAM MODEL…          PROGRAM: the built dynamy
import {execFileSync} from "node:child_process";
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {basename, join} from "node:path";

const [program, ...models] = process.argv.slice(2);
const skip = why => { console.log(`skipped: ${why}`); process.exit(77); };
const browserPath = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
if (!browserPath) skip("no chromium");
const {chromium} = await import("playwright-core").catch(() => skip("no playwright-core: run `npm ci` in app/viewer"));
if (!program || !models.length) throw new Error("usage: node test/run.mjs PROGRAM MODEL…");

const folder = mkdtempSync(join(tmpdir(), "replay-"));
// Without these flags a browser without a graphics card has no WebGL at all and the test sees nothing.
const browser = await chromium.launch({executablePath: browserPath,
  args: ["--no-sandbox", "--enable-unsafe-swiftshader", "--use-angle=swiftshader"]});
let failures = 0;

function expect(holds, what) {
  if (holds) return;
  ++failures;
  console.error(`FAILED: ${what}`);
}

/** How many colours the picture of the stage has, counted on a grid. */
const colours = page => page.evaluate(() => {
  const picture = window.replay.stage.picture(window.replay.t), ctx = picture.getContext("2d");
  const {data, width, height} = ctx.getImageData(0, 0, picture.width, picture.height);
  const seen = new Set();
  for (let i = 0; i < 4 * width * height; i += 4 * 37) seen.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
  return seen.size;
});

async function open(file, hash, viewport = {width: 1280, height: 800}) {
  const page = await browser.newPage({viewport});
  page.said = [];
  page.asked = [];
  page.on("console", m => { if (m.type() === "error") page.said.push(m.text()); });
  page.on("pageerror", e => page.said.push(e.message));
  page.on("request", r => page.asked.push(r.url()));
  await page.goto(`file://${file}#${hash}`);
  await page.waitForFunction(() => window.replay, null, {timeout: 60000});
  return page;
}

/** What every model must pass: both pictures, no error, one request. */
async function basics(name, file) {
  for (const [hash, viewport] of [["", undefined], ["view=iso&theme=dark", undefined], ["view=iso&webgl=0", {width: 390, height: 844}]]) {
    const page = await open(file, hash, viewport), what = `${name} #${hash}`;
    const span = await page.evaluate(() => window.replay.end - window.replay.begin);
    await page.evaluate(t => window.replay.seek(t), 0.3 * span);
    expect(await colours(page) > 5, `${what}: the picture is not blank`);
    if (!hash.includes("webgl=0")) {
      expect(await page.evaluate(() => window.replay.stage.space !== null), `${what}: WebGL draws the spatial view`);
    }
    const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(over <= 0, `${what}: nothing is wider than the window`);
    expect(page.said.length === 0, `${what}: ${page.said.join("; ")}`);
    expect(page.asked.filter(url => !url.startsWith("data:")).length === 1, `${what}: one request, not ${page.asked}`);
    await page.close();
  }
}

/** Every control, on one model that has contacts. */
async function controls(file) {
  const page = await open(file, "t=0.05");
  const t = () => page.evaluate(() => window.replay.t);
  const start = await t();
  expect(Math.abs(start - 0.05) < 1e-9, "the address sets the time");
  await page.keyboard.press("ArrowRight");
  // A film is as slow as the page: a tenth of the speed, 25 pictures a second, 0.1 s.
  const pictures = await page.evaluate(() => {
    document.getElementById("speed").value = "0.1";
    return window.replay.studio.begin({fps: 25, from: 0, to: 0.1});
  });
  expect(Math.abs(pictures - 25) <= 1, `a film of a tenth of the speed: ${pictures} pictures`);
  const stepped = await t();
  expect(stepped > start && stepped < start + 0.02, "arrow right: the next frame");
  await page.keyboard.press("ArrowLeft");
  expect(await t() < stepped, "arrow left: the frame before");
  // Back from the second event of the run: before the first one there is none.
  await page.keyboard.press("Home");
  await page.keyboard.press("n");
  const event = await t();
  expect(event > 0, "n: the next event");
  await page.keyboard.press("n");
  expect(await t() > event, "n again: the one after it");
  await page.keyboard.press("p");
  expect(await t() === event, "p: the event before");
  await page.keyboard.press("p");
  expect(await t() === event, "p at the first event: it stays");
  await page.keyboard.press("Space");
  await page.waitForTimeout(400);
  await page.keyboard.press("Space");
  const played = await t();
  await page.waitForTimeout(100);
  expect(await t() === played, "space pauses");
  await page.keyboard.press("Home");
  expect(await t() === await page.evaluate(() => window.replay.begin), "home: the begin");
  await page.click("#play");
  await page.waitForTimeout(400);
  await page.click("#play");
  expect(await t() > 0, "the button plays");
  await page.locator("#scrub").evaluate(e => { e.value = 0.5; e.dispatchEvent(new Event("input")); });
  const span = await page.evaluate(() => window.replay.end - window.replay.begin);
  expect(Math.abs(await t() - 0.5 * span) < 1e-6, "the slider sets the time");
  for (const [key, view] of [["1", "xz"], ["2", "xy"], ["3", "yz"], ["4", "iso"]]) {
    await page.keyboard.press(key);
    expect(await page.evaluate(() => window.replay.stage.camera.view) === view, `key ${key}: ${view}`);
    expect(await colours(page) > 2, `view ${view} is not blank`);
  }
  const before = await page.evaluate(() => window.replay.stage.camera.azimuth);
  await page.mouse.move(400, 500);
  await page.mouse.down();
  await page.mouse.move(460, 520, {steps: 3});
  await page.mouse.up();
  expect(await page.evaluate(() => window.replay.stage.camera.azimuth) !== before, "dragging turns");
  const scale = await page.evaluate(() => window.replay.stage.camera.scale);
  await page.mouse.wheel(0, -300);
  await page.waitForTimeout(100);
  expect(await page.evaluate(() => window.replay.stage.camera.scale) > scale, "the wheel zooms");
  await page.keyboard.press("f");
  await page.keyboard.press("t");
  expect(await page.evaluate(() => window.replay.stage.show.trails), "t: trails");
  await page.keyboard.press("0");
  await page.evaluate(() => window.replay.select(0));
  expect(await page.isVisible("#selected"), "a body that is selected shows its card");
  if (await page.locator("#selected a").count()) {
    await page.click("#selected a");
    expect(await page.locator("#model code.here").count() === 1, "its place opens the model at the line");
  }
  for (const tab of await page.locator("#tabs button").all()) await tab.click();
  await page.click('#tabs [data-tab="plots"]');
  expect(await page.locator("#plots canvas").count() > 0, "there are curves");
  const box = await page.locator("#plots .u-over").first().boundingBox();
  await page.mouse.click(box.x + 0.25 * box.width, box.y + 20);
  expect(Math.abs(await t() - 0.25 * span) < 0.02 * span, "a click on a curve sets the time");
  await page.mouse.move(box.x + 20, box.y + 20);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 20, {steps: 4});
  await page.mouse.up();
  expect(await page.evaluate(() => document.getElementById("plots").classList.contains("zoomed")), "dragging on a curve zooms");
  await page.mouse.dblclick(box.x + 60, box.y + 30);
  expect(!await page.evaluate(() => document.getElementById("plots").classList.contains("zoomed")), "double click: the whole time");
  await page.keyboard.press("?");
  expect(await page.isVisible("#help"), "?: the keys");
  await page.keyboard.press("Escape");
  const download = page.waitForEvent("download");
  await page.click("#png");
  expect((await download).suggestedFilename().endsWith(".png"), "PNG");
  await page.click("#link");
  expect(page.url().includes("#t="), "the link holds the time");
  // A canvas that has been given a size is empty: what the browser shows next must be drawn.
  await page.evaluate(() => {
    window.blank = 0;
    const {replay} = window, stage = document.getElementById("stage"), draw = replay.stage.draw;
    let drawn = 0;
    replay.stage.draw = t => { ++drawn; draw.call(replay.stage, t); };
    new ResizeObserver(() => { if (!drawn) ++window.blank; drawn = 0; }).observe(stage);
    drawn = 1;
  });
  await page.setViewportSize({width: 1000, height: 700});
  await page.waitForTimeout(200);
  expect(await page.evaluate(() => window.blank) === 0, "a new size of the window: drawn at once");
  await page.keyboard.press("d");
  expect(await page.evaluate(() => document.documentElement.classList.contains("dark")), "d: dark");
  expect(page.said.length === 0, `controls: ${page.said.join("; ")}`);
  await page.close();
}

/** What is done with bodies and plots, at the width at which tabs were once cut off. */
async function tools(file, other) {
  const page = await open(file, "t=0.05", {width: 1100, height: 800});
  const cut = await page.evaluate(() => { const t = document.getElementById("tabs"); return t.scrollWidth - t.clientWidth; });
  expect(cut <= 0, `the tabs are not cut off at 1100 px: ${cut} px`);
  const overlap = await page.evaluate(() =>
    document.getElementById("switches").getBoundingClientRect().right > document.getElementById("views").getBoundingClientRect().left);
  expect(!overlap, "the tools of the picture do not overlap");
  await page.keyboard.press("b");
  expect(await page.evaluate(() => window.replay.stage.overlay.labels.length > 0), "b: names");
  await page.keyboard.press("m");
  await page.evaluate(() => {
    const {tools, stage, t} = window.replay, at = stage.camera.project([0, 0, 0]), to = stage.camera.project([0.1, 0, 0]);
    tools.clicked(at[0], at[1], t);
    tools.clicked(to[0], to[1], t);
  });
  await page.waitForFunction(() => /^[\d.]+ m +\u0394x/.test(document.querySelector(".measured").textContent), null, {timeout: 20000})
    .catch(async () => expect(false, `m: the distance of two points, not ${await page.textContent(".measured")}`));
  await page.keyboard.press("m");
  await page.evaluate(() => window.replay.select(0));
  await page.keyboard.press("h");
  expect(await page.evaluate(() => window.replay.stage.flat.hidden.has(0)), "h: hides the selected body");
  await page.keyboard.press("H");
  expect(await page.evaluate(() => window.replay.stage.flat.hidden.size) === 0, "shift h: shows all");
  for (const [kind, begin] of [["CSV", "t [s],"], ["SVG", "<svg "]]) {
    const download = page.waitForEvent("download");
    await page.locator(`#plots .files button:has-text("${kind}")`).first().click();
    const saved = join(folder, `plot.${kind}`);
    await (await download).saveAs(saved);
    expect(readFileSync(saved, "utf8").startsWith(begin), `a plot as ${kind}`);
  }
  const curves = () => page.evaluate(() => document.querySelectorAll("#plots .names > span:not(.files)").length);
  const alone = await curves();
  await page.click("#switches button:has-text('compare')");
  await page.locator("#stage input[type=file]").setInputFiles(other);
  await page.waitForFunction(() => window.replay.tools.other);
  expect(await curves() > alone, "o: the curves of the other run");
  await apart(page);
  await page.keyboard.press("o");
  expect(await curves() === alone, "o again: they go");
  expect(await page.isHidden("#beside"), "and the second picture goes");
  const nameless = await page.evaluate(() => [...document.querySelectorAll("button, input, select")].filter(e =>
    !(e.textContent.trim() || e.getAttribute("aria-label") || e.title || e.labels?.length)).map(e => e.id || e.className));
  expect(nameless.length === 0, `every control has a name for screen readers: ${nameless}`);
  expect(page.said.length === 0, `tools: ${page.said.join("; ")}`);
  await page.close();
}

/** Two runs beside each other: films of all sizes have equal scales along both sides, and nothing shows one run alone. */
async function both(page) {
  for (const [width, height] of [[400, 300], [640, 480], [800, 400], [900, 600], [300, 600], [320, 100]]) {
    const sizes = await page.evaluate(([width, height]) => {
      window.replay.studio.begin({fps: 25, width, height});
      const {comparison, t} = window.replay, whole = comparison.picture(t);
      return {whole: [whole.width, whole.height], each: ["stage", "beside"].map(id => {
        const {clientWidth: w, clientHeight: h} = document.getElementById(id);
        return [w, h];
      })};
    }, [width, height]);
    const tall = height > width, half = tall ? [width, height / 2] : [width / 2, height];
    expect(`${sizes.whole}` === `${[width, height]}`, `a film of ${width}x${height}: the picture has ${sizes.whole}`);
    expect(sizes.each.every(s => `${s}` === `${half}`), `a film of ${width}x${height}: its parts have ${sizes.each.join(" and ")}`);
  }
  const seen = await page.evaluate(() => {
    const {replay} = window, dashed = plots => plots.panels.map(p => p.curves.filter(c => c.dashed).length);
    return {energy: dashed(replay.energy), head: document.getElementById("facts").textContent,
      events: replay.list.all.map(e => e.run), own: replay.events.length};
  });
  expect(seen.energy.length > 0 && seen.energy.every(n => n > 0), `energies of both runs: ${seen.energy} dashed`);
  expect(seen.events.length === 2 * seen.own && seen.events.every(x => x), `events of both runs: ${seen.events.length} of ${seen.own}`);
  expect(seen.head.includes("\u2016"), `the head has both runs: ${seen.head}`);
}

/** What the address says about bodies and arrows. */
async function looks(file) {
  const name = await open(file, "").then(async page => {
    const out = await page.evaluate(() => window.replay.tools.names[0]);
    await page.close();
    return out;
  });
  const page = await open(file, `names=1&arrows=2.5&hide=${encodeURIComponent(name)},nobody`);
  const got = await page.evaluate(() => ({factor: window.replay.stage.forceFactor, hidden: [...window.replay.stage.flat.hidden],
    unknown: window.replay.tools.unknown,
    labels: window.replay.tools.labelled.length}));
  expect(got.factor === 2.5 && `${got.hidden}` === "0" && `${got.unknown}` === "nobody" && got.labels > 0,
    `names, arrows and hide in the address: ${JSON.stringify(got)}`);
  await page.close();
}

/** Grains that were taken away are not drawn, in either picture. */
async function grains(out) {
  const model = `${out}.xml`;
  writeFileSync(model, `<dynamy version="1"><systems><Grains name="g" count="4" within="1 1 1 3 3 1.4" pitch="0.5" takeWithin="-9 -9 -9 9 9 0.5">
    <Sphere radius="0.1" density="1000"/></Grains></systems><forces><Gravity acceleration="0 0 -9.81"/></forces>
    <simulation until="0.6" step="1e-3"/><record frames="50Hz"/></dynamy>`);
  execFileSync(program, ["run", model, "--out", out, "--quiet"], {stdio: "inherit"});
  for (const hash of ["view=iso", "view=xz", "view=iso&webgl=0"]) {
    const page = await open(join(out, "replay.html"), hash);
    const at = async t => {
      await page.evaluate(time => window.replay.seek(time).drawNow(), t);
      return [await page.evaluate(() => [0, 1, 2, 3].filter(i => !window.replay.film.absent(i, window.replay.t)).length), await colours(page)];
    };
    const [many, full] = await at(0.1), [none, empty] = await at(0.6);
    expect(many === 4 && none === 0, `grains ${hash}: ${many} before, ${none} after they were taken`);
    expect(empty < full, `grains ${hash}: an empty picture has fewer colours: ${full}, ${empty}`);
    const lowest = await page.evaluate(() => window.replay.stage.model.extent.lo);
    expect(lowest[0] > 0.8, `grains ${hash}: the origin is not part of the scene: ${lowest}`);
    expect(page.said.length === 0, `grains ${hash}: ${page.said.join("; ")}`);
    await page.close();
  }
}

/** The other run in a picture of its own, which moves with the first one. */
async function apart(page) {
  expect(await page.isVisible(".caption"), "the other run is named");
  await page.keyboard.press("w");
  await page.waitForFunction(() => window.replay.comparison.isBeside);
  const widths = await page.evaluate(() => ["stage", "beside", "stages"].map(id => document.getElementById(id).clientWidth));
  expect(Math.abs(widths[0] - widths[1]) <= 2 && widths[0] + widths[1] >= widths[2] - 2, `w: two pictures of equal width: ${widths}`);
  const looks = () => page.evaluate(() => {
    const {stage, comparison, t} = window.replay, {camera} = comparison.beside.stage;
    comparison.draw(t);
    return {same: camera.scale === stage.camera.scale && camera.azimuth === stage.camera.azimuth && camera.view === stage.camera.view &&
      camera.centre.every((x, k) => x === stage.camera.centre[k]), azimuth: stage.camera.azimuth,
    scales: [false, true].map(impact => comparison.beside.stage.overlay.perUnit(1, 1, impact) === stage.overlay.perUnit(1, 1, impact))};
  });
  await page.keyboard.press("4");
  const before = await looks();
  expect(before.same, "both have one view");
  expect(before.scales.every(x => x), "forces and impacts have the same scales in both");
  const box = await page.locator("#beside").boundingBox();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.7 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.5 * box.width + 50, box.y + 0.7 * box.height, {steps: 3});
  await page.mouse.up();
  const after = await looks();
  expect(after.azimuth !== before.azimuth && after.same, "dragging the second picture turns both");
  const seen = await page.evaluate(() => {
    const whole = window.replay.comparison.picture(window.replay.t), ctx = whole.getContext("2d");
    return [0, 1].map(k => {
      const {data} = ctx.getImageData(k * whole.width / 2, 0, whole.width / 2, whole.height), colours = new Set();
      for (let i = 0; i < data.length; i += 4 * 37) colours.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
      return colours.size;
    });
  });
  expect(seen.every(n => n > 2), `neither picture is blank: ${seen}`);
  await page.evaluate(() => window.replay.select(0));
  expect((await page.textContent("#selected table")).includes("this run"), "the card has the values of both runs");
  await page.evaluate(() => window.replay.select(-1));
}

/** A ball that falls: its percussion is m (1 + \u03b5) v whatever the step is; its weight is a force. */
async function impulses() {
  const scale = async step => {
    const model = join(folder, "ball.xml"), out = join(folder, `ball_${step}`);
    writeFileSync(model, `<dynamy version="1"><systems>
      <RigidBody name="ball" position="0 0 0.6"><Sphere radius="0.1" mass="2" material="wood"/></RigidBody>
      <Ground><HalfSpace normal="0 0 1" material="wood"/><HalfSpace normal="1 0 0" position="-0.5 0 0" material="wood"/></Ground></systems>
      <forces><Gravity/></forces><elements><Contact between="wood wood"><UnilateralCoulomb epsilonN="0.5" mu="0.3"/></Contact></elements>
      <simulation until="0.4" step="${step}"/><record frames="5kHz"/></dynamy>`);
    execFileSync(program, ["run", model, "--out", out, "--quiet"], {stdio: "inherit"});
    const page = await open(join(out, "replay.html"), "view=iso");
    const found = await page.evaluate(() => {
      const {film, stage} = window.replay, hits = [];
      for (let c = 0; c < film.contactCount; ++c) {
        const x = film.contactAt(c);
        if (x.state === 3) hits.push(Math.hypot(...x.F) * x.step);
      }
      return {hits, usual: film.usualImpact(), legend: document.querySelector("#legend .scale").textContent,
        floor: Math.max(...stage.space.grounds.map(g => -Math.min(...g.outline.geometry.attributes.position.array.filter((_, i) => i % 3 === 2)))),
        wall: Math.min(...stage.space.grounds.flatMap(g => [...g.outline.geometry.attributes.position.array.filter((_, i) => i % 3 === 0)]))};
    });
    expect(page.said.length === 0, `impulses: ${page.said.join("; ")}`);
    // 2 kg (1 + 0.5) \u221a(2 g 0.5 m); the step in which it arrives adds or takes at most m g \u0394t, the coding of the page 0.3 %
    const exact = 3 * Math.sqrt(2 * 9.81 * 0.5), off = 2 * 2 * 9.81 * step + 0.003 * exact;
    expect(found.hits.length > 0 && Math.abs(found.hits[0] - exact) < off, `the percussion in N s: ${found.hits[0]}, not ${exact}`);
    expect(/impact 1 cm = [\d.]+ N s/.test(found.legend), `the legend says N s: ${found.legend}`);
    expect(found.floor < 1e-3, `a wall ends at the floor: ${found.floor}`);
    expect(found.wall > -0.501, `a floor ends at the wall: ${found.wall}`);
    await page.click('#tabs [data-tab="events"]');
    expect(/m\/s, [\d.]+ N s/.test(await page.textContent("#events")), "the list of events has N s");
    await page.close();
    return found.usual;
  };
  const coarse = await scale(1e-3), fine = await scale(2.5e-4);
  expect(Math.abs(coarse / fine - 1) < 0.01, `the scale of impacts does not depend on the step: ${coarse}, ${fine}`);
}

/** Events that are not in the list are counted above it. */
async function leftOut(file) {
  const text = readFileSync(file, "utf8"), other = join(folder, "left_out.html");
  writeFileSync(other, text.replace(/"eventsLeftOut":\s*0/, '"eventsLeftOut":12345'));
  const page = await open(other, "open=events");
  const all = await page.evaluate(() => window.replay.events.length), brief = await page.evaluate(() => window.replay.events.filter(e => e.brief).length);
  const note = await page.textContent("#events .note");
  expect(note.includes(`first ${all} of ${all + 12345} events`), `a cut list says so: ${note}`);
  if (brief) {
    expect(note.includes(`${brief} switches`), `brief switches are counted: ${note}`);
    await page.click("#events .note button");
  }
  expect((await page.textContent("#events .bar button")) === `all ${all}`, "all events can be listed");
  expect(page.said.length === 0, `events: ${page.said.join("; ")}`);
  await page.close();
}

/** A half space that only touches is not drawn, as other shapes. */
async function transparentGround() {
  const model = join(folder, "between.xml"), out = join(folder, "between");
  writeFileSync(model, `<dynamy version="1"><systems>
    <PlanarBody name="box" position="0 0 0.1"><Box size="0.2 0.2 0.2" mass="1" material="wood"/></PlanarBody>
    <Ground><HalfSpace normal="0 0 1" material="wood"/>
      <HalfSpace normal="0 0 -1" position="0 0 0.5" material="wood" colour="transparent"/></Ground></systems>
    <forces><Gravity/></forces><elements><Contact between="wood wood"><UnilateralCoulomb mu="0.3"/></Contact></elements>
    <simulation until="0.1" step="1e-2"/><record frames="60Hz"/></dynamy>`);
  execFileSync(program, ["run", model, "--out", out, "--quiet"], {stdio: "inherit"});
  const page = await open(join(out, "replay.html"), "view=iso");
  const grounds = await page.evaluate(() => window.replay.stage.space.grounds.length);
  expect(grounds === 1, `a transparent half space is not drawn: ${grounds} planes`);
  expect(page.said.length === 0, `transparent ground: ${page.said.join("; ")}`);
  await page.close();
}

await transparentGround();
await impulses();
for (const model of models) {
  const name = basename(model, ".xml"), out = join(folder, name);
  execFileSync(program, ["run", model, "--out", out, "--quiet"], {stdio: "inherit"});
  const file = join(out, "replay.html");
  await basics(name, file);
  if (model === models[0]) {
    await controls(file);
    await tools(file, file);
    await leftOut(file);
    execFileSync(program, ["view", out, "--with", out, "--no-browser"], {stdio: "ignore"});
    const page = await open(file, "");
    expect(await page.evaluate(() => window.replay.tools.other !== null), "view --with: the other run is there");
    expect(page.said.length === 0, `view --with: ${page.said.join("; ")}`);
    await page.close();
    execFileSync(program, ["view", out, "--with", out, "--beside", "--no-browser"], {stdio: "ignore"});
    const two = await open(file, "");
    expect(await two.evaluate(() => window.replay.comparison.isBeside), "view --with --beside: two pictures");
    expect(two.said.length === 0, `view --beside: ${two.said.join("; ")}`);
    await both(two);
    await two.close();
    await looks(file);
    await grains(join(folder, "grains"));
  }
  console.log(`${name}: done`);
}
await browser.close();
rmSync(folder, {recursive: true});
if (failures) {
  console.error(`${failures} failed`);
  process.exit(1);
}
console.log("all passed");
