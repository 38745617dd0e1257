// What the peers of npm share: the lines they print, and the clock; as peer.hpp.
const repeatFor = 0.05;  // [s]

export const ballSteps = ["1e-2*", "5e-3", "2e-3*", "1e-3", "2e-4", "1e-4", "2e-5"];
export const smoothSteps = ["2e-2*", "1e-2*", "5e-3", "2e-3", "1e-3", "5e-4", "2e-4", "1e-4"];
export const restSteps = ["1e-2*", "5e-3", "2e-3", "1e-3*"];
export const chainSteps = ["1e-2", "5e-3", "2e-3", "1e-3*", "5e-4", "2e-4", "1e-4"];

const processTime = () => {
  const t = process.cpuUsage();
  return 1e-6 * (t.user + t.system);
};

/** Calls step() up to `until`, and sample() whenever one of `times` is reached. */
export function march(answer, h, until, times, step, sample) {
  const n = Math.round(until / h);
  const at = times.map((t) => Math.round(t / h));
  let next = 0;
  const begin = processTime();
  for (let i = 1; i <= n; ++i) {
    step();
    while (next < at.length && i >= at[next]) {
      sample(answer.values);
      ++next;
    }
  }
  answer.cpu = processTime() - begin;
  answer.evaluations = n;
}

/** Angle of the direction (x, z) from straight down, as angleFromDown of peer.hpp. */
export function angleFromDown(x, z) {
  let phi = Math.atan2(z, x);
  if (phi > 0.7) phi -= 2 * Math.PI;
  return phi + 0.5 * Math.PI;
}

export const slopeAngle = (20 * Math.PI) / 180;
export const slopeGravity = [-9.81 * Math.sin(slopeAngle), 0, -9.81 * Math.cos(slopeAngle)];
export const placeOnSlope = (way) => way * Math.cos(slopeAngle) - 0.05 * Math.sin(slopeAngle);

/** lines: [scene, method, settings, (setting, answer) => …]. */
export function serve(engine, notes, lines) {
  const [scene, method, setting] = process.argv.slice(2);
  if (setting === undefined) {
    console.log("engine " + engine);
    for (const n of notes) console.log("note " + n);
    for (const [s, m, settings] of lines)
      for (const x of settings) console.log(`point ${s}\t${m}\t${x}`);
    return;
  }
  const line = lines.find((l) => l[0] === scene && l[1] === method);
  if (!line) {
    console.log("note no such scene or method");
    process.exitCode = 1;
    return;
  }
  const run = () => {
    const answer = { values: [], cpu: 0, evaluations: 0 };
    line[3](Number(setting), answer);
    return answer;
  };
  // The first run, which compiles, does not count unless it was long.
  const first = run();
  const times = first.cpu > 1 ? [first.cpu] : [];
  for (let all = 0; times.length === 0 || (all < repeatFor && times.length < 20); ) {
    times.push(run().cpu);
    all += times.at(-1);
  }
  times.sort((a, b) => a - b);
  const median = 0.5 * (times[(times.length - 1) >> 1] + times[times.length >> 1]);
  console.log("values " + first.values.join(" "));
  console.log("cpu " + median);
  console.log("evaluations " + first.evaluations);
}
