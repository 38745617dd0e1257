// A live run in headless Chromium: it waits for the page, computes, pauses, takes parameters, is
// pulled, ends, and is repeated with the same hash. Skips (exit 77) as run.mjs does.
//   node test/live.mjs PROGRAM [FOLDER-FOR-PICTURES]
import {execFileSync, spawn} from "node:child_process";
import {existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";

const [program, pictures] = process.argv.slice(2);
const skip = why => { console.log(`skipped: ${why}`); process.exit(77); };
const browserPath = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
if (!browserPath) skip("no chromium");
const {chromium} = await import("playwright-core").catch(() => skip("no playwright-core: run `npm ci` in app/viewer"));

const folder = mkdtempSync(join(tmpdir(), "live-"));
const browser = await chromium.launch({executablePath: browserPath,
  args: ["--no-sandbox", "--enable-unsafe-swiftshader", "--use-angle=swiftshader"]});
let failures = 0;
function expect(holds, what) {
  if (holds) return;
  ++failures;
  console.error(`FAILED: ${what}`);
}

const kModel = `<dynamy version="1" title="box on a floor">
  <parameter name="mu" value="0.3"/><parameter name="g" value="9.81"/><parameter name="size" value="0.2"/>
  <systems>
    <RigidBody name="box" position="0 0 {size/2}"><Box size="{size} 0.2 0.2" mass="1" material="wood"/></RigidBody>
    <RigidBody name="ball" position="0.6 0 0.5"><Sphere radius="0.1" mass="0.5" material="wood"/></RigidBody>
    <Ground><HalfSpace normal="0 0 1" material="wood"/></Ground>
  </systems>
  <forces><Gravity acceleration="0 0 {-g}"/><Input name="push"/>
    <ForceInput on="ball" force="push.out; 0; 0"/></forces>
  <elements><Contact between="wood wood"><UnilateralCoulomb epsilonN="0.5" mu="{mu}"/></Contact></elements>
  <simulation until="1000" step="2e-3"/><record signals="box.x ball.z" every="20ms" frames="60Hz"/></dynamy>`;

/** Starts the program; resolves to the process with the address of its page. */
function startLive(model, out) {
  const child = spawn(program, ["run", model, "--live", "--no-browser", "--out", out], {stdio: ["ignore", "pipe", "inherit"]});
  child.said = "";
  const exited = new Promise(done => child.on("exit", done));
  return new Promise((done, failed) => {
    child.on("error", failed);
    child.stdout.on("data", bytes => {
      child.said += bytes;
      const address = child.said.match(/http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]{32}\//);
      if (address) done({child, exited, address: address[0]});
    });
  });
}

/** Waits until the function holds in the page. */
const until = (page, what, text) => page.waitForFunction(what, null, {timeout: 60000})
  .catch(() => expect(false, `${text} did not come`));
const snap = async (page, name) => { if (pictures) await page.screenshot({path: join(pictures, `${name}.png`)}); };

const model = join(folder, "box.xml"), out = join(folder, "box");
writeFileSync(model, kModel);
const {child, exited, address} = await startLive(model, out);
const page = await browser.newPage({viewport: {width: 1280, height: 800}});
const said = [];
page.on("console", m => { if (m.type() === "error") said.push(m.text()); });
page.on("pageerror", e => said.push(e.message));
await page.goto(address);
await until(page, () => window.replay?.live && window.replay.end > 0.3, "the run");
const text = id => page.evaluate(i => document.querySelector(i)?.textContent ?? "", id);
expect((await text("#livebar > span")).startsWith("computing"), "the bar says that the run is computing");
const phase = () => page.evaluate(() => window.replay.live.state.phase);

// pause, one step, go on
await page.keyboard.press("Space");
await until(page, () => window.replay.live.state.phase === "paused", "pause");
const steps = await page.evaluate(() => window.replay.live.state.steps);
await page.waitForTimeout(300);
expect(await page.evaluate(() => window.replay.live.state.steps) === steps, "a paused run takes no step");
await page.click("#livebar button:has-text('one step')");
await page.waitForFunction(n => window.replay.live.state.steps === n, steps + 1, {timeout: 20000});
expect(await phase() === "paused", "after one step it is paused again");

// parameters and inputs
const field = name => page.locator(`#live input[aria-label="${name}"]`);
await page.click('#tabs [data-tab="live"]');
const set = async (name, value) => { await field(name).fill(value); await field(name).press("Enter"); };
await set("mu", "0.6");
await until(page, () => window.replay.live.state.parameters.mu === 0.6, "the new friction");
await set("size", "0.4");
await until(page, () => document.querySelector("#live .said").textContent.includes("shapes"), "the refusal of a new size");
expect(await field("size").inputValue() === "0.2", "a refused parameter keeps its value");
await set("mu", "much");
expect((await text("#live .said")).includes("no number"), "a word is no number");
await set("push", "0.05");
await until(page, () => window.replay.live.state.inputs.push === 0.05, "the input");
await page.click("#livebar button:has-text('go on')");
await until(page, () => window.replay.live.state.phase === "running", "go on");
await snap(page, "live_running");

// the past, and back
await page.keyboard.press("ArrowLeft");
expect(await page.evaluate(() => !window.replay.live.atEdge), "one frame back: the past is shown");
await page.click("#livebar button:has-text('now')");
expect(await page.evaluate(() => window.replay.live.atEdge), "now: the present is shown");

// pull the box: where it is seen, up and to the side. On a busy machine the box may have moved on
// before the hand comes, so that it is taken again.
const boxAt = () => page.evaluate(() => {
  const {stage, film, end} = window.replay, rect = document.getElementById("overlay").getBoundingClientRect();
  const [x, y] = stage.camera.project(film.pose(0, end).r);
  return [rect.left + x, rect.top + y];
});
const before = await page.evaluate(() => window.replay.film.pose(0, window.replay.end).r[2]);
await page.locator("#live select").selectOption("10");  // hard: its weight stretches the spring by a hundredth of the scene
let lifted = false;
for (let attempt = 0; attempt < 4 && !lifted; ++attempt) {
  const [x, y] = await boxAt();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await until(page, () => window.replay.stage.hand.line !== null, "the hand");
  await page.mouse.move(x + 10, y - 120, {steps: 8});
  lifted = await page.waitForFunction(b => window.replay.film.pose(0, window.replay.end).r[2] > b + 0.03, before, {timeout: 15000})
    .then(() => true, () => false);
  if (!lifted) await page.mouse.up();
}
expect(lifted, "the box is lifted");
await snap(page, "live_pulled");
await page.mouse.up();
await until(page, () => window.replay.stage.hand.line === null, "letting go");
if (pictures) {
  for (const [width, dark] of [[1100, false], [1400, true], [2560, false], [390, true]]) {
    await page.setViewportSize({width, height: width === 390 ? 844 : 800});
    await page.evaluate(d => window.replay.setTheme(d), dark);
    await page.waitForTimeout(500);
    await snap(page, `live_${width}${dark ? "_dark" : ""}`);
  }
}
await page.setViewportSize({width: 1100, height: 760});
const cut = await page.evaluate(() => { const t = document.getElementById("tabs"); return t.scrollWidth - t.clientWidth; });
expect(cut <= 0, `the tabs are not cut off at 1100 px: ${cut} px`);
for (const tab of await page.locator("#tabs button").all()) await tab.click();

// the page loaded again has everything
const end = await page.evaluate(() => window.replay.end);
await page.reload();
await page.waitForFunction(e => window.replay?.end >= e, end, {timeout: 60000}).catch(() => expect(false, "everything comes again"));

await page.click("#livebar button:has-text('end the run')");
await until(page, () => document.querySelector('#tabs [data-tab="run"]') !== null, "the facts of the run");
expect(await exited === 0, "the program ends with 0");
await page.click('#tabs [data-tab="run"]');
expect((await text("#run")).includes("finished"), "the run has finished");
await page.keyboard.press("Home");
expect(await page.evaluate(() => window.replay.t) === 0, "afterwards the page is a replay");
await snap(page, "live_ended");
expect(said.length === 0, `console: ${said.join("; ")}`);
await browser.close();

const facts = JSON.parse(readFileSync(join(out, "run.json"), "utf8"));
const inputs = readFileSync(join(out, "inputs.csv"), "utf8");
for (const what of ["set,mu", "input,push", "grab,box", "move", "release", "end"]) {
  expect(inputs.includes(`,${what}`), `inputs.csv holds ${what}`);
}
expect(facts.live.actions === inputs.trim().split("\n").length - 1, "run.json counts the actions");
expect(Math.abs(facts.energy.discretisation) < 0.02 * facts.energy.nonPotential + 0.05, "the ledger explains the energy");
const again = execFileSync(program, ["run", "--repeat", out], {encoding: "utf8"});
const repeated = JSON.parse(readFileSync(`${out}_repeated/run.json`, "utf8"));
expect(again.includes("the same motion"), "the repeated run says that its motion is the same");
expect(repeated.hash === facts.hash, `the same hash: ${facts.hash}, ${repeated.hash}`);
rmSync(folder, {recursive: true});
if (failures) {
  console.error(`${failures} failed`);
  process.exit(1);
}
console.log("all passed");
