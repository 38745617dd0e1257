// What a replay costs: size, bytes a body and frame, time to load, time a frame while scrubbing.
//   node test/measure.mjs REPLAY.html…      medians; times are worth as much as the machine is idle
import {readFileSync} from "node:fs";
import {resolve} from "node:path";
import {chromium} from "playwright-core";

const kLoads = 5, kSeeks = 21;
const median = all => [...all].sort((a, b) => a - b)[Math.floor(all.length / 2)];
const browser = await chromium.launch({executablePath: "/usr/bin/chromium",
  args: ["--no-sandbox", "--enable-unsafe-swiftshader", "--use-angle=swiftshader"]});

/** Milliseconds of the script alone, and until the picture is there, at instants all over the film. */
const scrub = (page, seeks) => page.evaluate(count => {
  const {replay} = window, own = [], whole = [], pixel = new Uint8Array(4);
  const gl = replay.stage.space?.renderer.getContext();
  for (let i = 0; i <= count; ++i) {
    replay.t = replay.begin + (replay.end - replay.begin) * (i * 0.618034 % 1);
    const begin = performance.now();
    replay.drawNow();
    own.push(performance.now() - begin);
    gl?.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);  // waits for the picture
    whole.push(performance.now() - begin);
  }
  return {own: own.slice(1), whole: whole.slice(1)};  // the first one builds buffers
}, seeks);

for (const file of process.argv.slice(2)) {
  const page = readFileSync(file, "utf8"), begin = page.indexOf('id="data">') + 10;
  const {frames, scene} = JSON.parse(page.slice(begin, page.indexOf("</script>", begin)));
  const share = (...texts) => (texts.join("").length / (frames.count * frames.poses)).toFixed(2);
  const loads = [];
  let times;
  for (let i = 0; i < kLoads; ++i) {
    const tab = await browser.newPage({viewport: {width: 1280, height: 800}}), start = performance.now();
    await tab.goto(`file://${resolve(file)}`);
    await tab.waitForFunction(() => window.replay, null, {timeout: 60000});
    loads.push(performance.now() - start);
    if (i + 1 === kLoads) times = await scrub(tab, kSeeks);
    await tab.close();
  }
  console.log(`${file}: ${(page.length / 1e6).toFixed(2)} MB, ${frames.count} frames of ${frames.poses} poses`);
  console.log(`  bytes a body and frame: poses ${share(frames.data, frames.ranges, frames.orders)}, ` +
    `contacts ${share(frames.contacts.data, frames.contacts.counts)}, scene ${share(scene)}`);
  console.log(`  loaded in ${median(loads).toFixed(0)} ms; a frame: own work ${median(times.own).toFixed(1)} ms, ` +
    `with drawing ${median(times.whole).toFixed(0)} ms`);
}
await browser.close();
