// A frames.bin of n spheres that fall, bounce and spin in a box: for measuring size and speed.
//   node test/synthetic.mjs SPHERES FRAMES FOLDER       then: dynamy view FOLDER --no-browser
import {mkdirSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {crc32 as zlibCrc} from "node:zlib";

const [n, frames, folder] = [Number(process.argv[2]), Number(process.argv[3]), process.argv[4]];
const crc32 = zlibCrc ?? ((bytes, seed = 0) => {
  let c = ~seed;
  for (const b of bytes) {
    c ^= b;
    for (let k = 0; k < 8; ++k) c = c & 1 ? c >>> 1 ^ 0xedb88320 : c >>> 1;
  }
  return ~c >>> 0;
});
let seed = 7;
const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;

const side = Math.cbrt(n) * 0.12, radius = 0.04;
const balls = Array.from({length: n}, () => ({
  r: [random() * side, random() * side, radius + random() * side], v: [random() - 0.5, random() - 0.5, random()],
  q: [1, 0, 0, 0], w: [4 * random() - 2, 4 * random() - 2, 4 * random() - 2]}));

/** One frame of 1/60 s: free fall, reflection at the walls with losses, spin. */
function move(b, dt) {
  b.v[2] -= 9.81 * dt;
  for (let k = 0; k < 3; ++k) {
    b.r[k] += b.v[k] * dt;
    const lo = radius, hi = k === 2 ? Infinity : side;
    if (b.r[k] < lo || b.r[k] > hi) {
      b.r[k] = b.r[k] < lo ? 2 * lo - b.r[k] : 2 * hi - b.r[k];
      b.v[k] *= -0.6;
      b.w = b.w.map(x => 0.8 * x + 2 * (random() - 0.5));
    }
  }
  const [w, x, y, z] = b.q, [a, c, d] = b.w.map(e => e * dt / 2);
  const q = [w - x * a - y * c - z * d, x + w * a + y * d - z * c, y + w * c + z * a - x * d, z + w * d + x * c - y * a];
  const size = Math.hypot(...q);
  b.q = q.map(e => e / size);
}

mkdirSync(folder, {recursive: true});
writeFileSync(join(folder, "run.json"), JSON.stringify({format: "dynamy-run", version: 1, state: "finished", title: `${n} spheres`}));
const scene = Buffer.from(JSON.stringify({view: "iso",
  frames: balls.map((_, i) => ({name: `ball[${i}]`, place: ""})),
  shapes: [...balls.map((_, i) => ({kind: "sphere", frame: i, position: [0, 0, 0], orientation: [1, 0, 0, 0], radius})),
    {kind: "halfspace", frame: -1, position: [0, 0, 0], orientation: [1, 0, 0, 0]}]}));
const head = Buffer.alloc(24);
head.write("DYNFRAME", "latin1");
[2, 0x01020304, n, scene.length].forEach((x, i) => head.writeUInt32LE(x, 8 + 4 * i));
const start = Buffer.concat([head, scene]), sum = Buffer.alloc(4);
sum.writeUInt32LE(crc32(start));
const parts = [start, sum];
for (let f = 0; f < frames; ++f) {
  const payload = Buffer.alloc(16 + 28 * n);
  payload.writeDoubleLE(f / 60, 0);
  balls.forEach((b, i) => [...b.r, ...b.q].forEach((x, k) => payload.writeFloatLE(x, 16 + 28 * i + 4 * k)));
  const chunk = Buffer.alloc(40);
  chunk.write("CHNK", "latin1");
  chunk.writeUInt32LE(1, 4);
  chunk.writeBigUInt64LE(BigInt(payload.length), 8);
  chunk.writeDoubleLE(f / 60, 16);
  chunk.writeDoubleLE(f / 60, 24);
  chunk.writeUInt32LE(crc32(payload, crc32(chunk.subarray(0, 32))), 32);
  parts.push(chunk, payload);
  for (const b of balls) for (let k = 0; k < 4; ++k) move(b, 1 / 240);
}
writeFileSync(join(folder, "frames.bin"), Buffer.concat(parts));
