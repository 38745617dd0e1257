// Derivatives by differences of whole runs of MuJoCo, beside `dynamy gradient` (theory 53.3):
//
//   node build/peers/npm/mujoco_derivatives.mjs      after bench/peers/install
//
// A ball that falls from h0 on a floor with e = 0.5 (a spring and damper fitted to e, since it has no restitution): its height
// at 0.6 s, before and after which it bounces, by h0. A block on a spring with dry friction (frictionloss): its place after 13
// half swings by the stiffness. For each step the difference (v(p + δ) − v(p − δ))/2δ with δ/p = 1e-1 … 1e-8; the best of them
// is told, which a user without the truth cannot choose. Truth: tests/data/derivatives/reference.csv.
import load from "@mujoco/mujoco";

const mujoco = await load();
const steps = [1e-2, 2e-3, 1e-3, 2e-4, 1e-4, 2e-5];

function run(h, until, xml, start, value) {
  const model = mujoco.MjModel.from_xml_string(xml);
  const data = new mujoco.MjData(model);
  start(data);
  mujoco.mj_forward(model, data);
  for (let i = Math.round(until / h); i > 0; --i) mujoco.mj_step(model, data);
  const out = value(data);
  data.delete();
  model.delete();
  return out;
}

function ball(h, h0) {
  const z = -Math.log(0.5) / Math.hypot(Math.PI, Math.log(0.5)), k = 1 / (3 * h) ** 2, d = 2 * z * Math.sqrt(k);
  return run(h, 0.6, `<mujoco><option timestep="${h}" gravity="0 0 -9.81" cone="elliptic" solver="Newton" tolerance="1e-14" iterations="100"/>
    <default><geom condim="1" solref="${-k} ${-d}" solimp="0.9999 0.9999 0.001 0.5 2"/></default><worldbody><geom type="plane" size="50 50 1"/>
    <body pos="0 0 1"><freejoint/><geom type="sphere" size="0.1" mass="1"/></body></worldbody></mujoco>`,
    (data) => { data.qpos[2] = h0 + 0.1; }, (data) => data.qpos[2]);
}

function block(h, stiffness) {
  return run(h, 6, `<mujoco><option timestep="${h}" gravity="0 0 0" solver="Newton" tolerance="1e-14" iterations="100"/>
    <worldbody><body><joint type="slide" axis="1 0 0" stiffness="${stiffness}" frictionloss="${0.2 * 9.81}" solreffriction="${2 * h} 1"
    solimpfriction="0.9999 0.9999 0.001 0.5 2"/><geom type="sphere" size="0.1" mass="1"/></body></worldbody></mujoco>`,
    (data) => { data.qpos[0] = 0.5; }, (data) => data.qpos[0]);
}

for (const [name, f, p, exact, scale] of [
  ["ball.z at 0.6 s by h0", ball, 1, -0.0067488868684909223, 0.3207022262630182],
  ["block.x at 6 s by k", block, 100, -26 * 0.2 * 9.81 / 1e4, 26 * 0.2 * 9.81 / 1e4],
]) {
  let best = [Infinity];
  for (const h of steps) {
    const errors = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8].map((r) =>
      [Math.abs((f(h, p * (1 + r)) - f(h, p * (1 - r))) / (2 * r * p) - exact) / scale, r]);
    errors.sort((a, b) => a[0] - b[0]);
    console.log(`${name}  step ${h}: best error ${errors[0][0].toExponential(1)} at δ/p ${errors[0][1]}, worst ${errors.at(-1)[0].toExponential(1)}`);
    if (errors[0][0] < best[0]) best = [errors[0][0], h, errors[0][1]];
  }
  console.log(`${name}  best of all: ${best[0].toExponential(1)} (step ${best[1]}, δ/p ${best[2]})`);
}
