// MuJoCo on the scenes of bench/work_precision.
//
// Settings by its documentation: the Runge-Kutta integrator where motion is smooth; with contact
// Newton's method, elliptic cones and the stiffest contact it takes (time constant of two steps,
// impedance at its cap). Damping is off by default. Contact is soft by its model. It has no
// coefficient of restitution: a spring and damper are fitted to e, as its documentation shows.
import load from "@mujoco/mujoco";
import {
  angleFromDown, ballSteps, chainSteps, march, placeOnSlope, restSteps, serve, slopeGravity, smoothSteps,
} from "./peer.mjs";

const mujoco = await load();

/** A model and its data, made from MJCF; freed by the end of the process. */
function world(h, { gravity = [0, 0, -9.81], integrator = "Euler", geom = "" }, bodies, after = "") {
  const model = mujoco.MjModel.from_xml_string(`<mujoco>
    <compiler angle="radian" autolimits="true"/>
    <option timestep="${h}" gravity="${gravity.join(" ")}" integrator="${integrator}" cone="elliptic" solver="Newton"
            tolerance="1e-14" iterations="100"/>
    <default><geom ${geom}/></default>
    <worldbody>${bodies}</worldbody>${after}</mujoco>`);
  const data = new mujoco.MjData(model);
  mujoco.mj_forward(model, data);
  return { data, step: () => mujoco.mj_step(model, data) };
}

const ground = '<geom type="plane" size="50 50 1"/>';
const stiff = (h, mu) =>
  `friction="${mu} 0 0" condim="3" solref="${2 * h} 1" solimp="0.9999 0.9999 0.001 0.5 2"`;

function bouncingBall(h, a) {
  // A spring of half period π c h and the damping that leaves e of the speed.
  const e = 0.5, c = 3;
  const z = -Math.log(e) / Math.hypot(Math.PI, Math.log(e));
  const k = 1 / (c * h) ** 2, d = 2 * z * Math.sqrt(k);
  const w = world(h, { geom: `condim="1" solref="${-k} ${-d}" solimp="0.9999 0.9999 0.001 0.5 2"` },
    `${ground}<body pos="0 0 1.1"><freejoint/><geom type="sphere" size="0.1" mass="1"/></body>`);
  march(a, h, 1.6, [0.6, 1.0, 1.2, 1.3, 1.6], w.step, (v) => v.push(w.data.qpos[2]));
}

function freeTop(h, a) {
  const w = world(h, { gravity: [0, 0, 0], integrator: "RK4" },
    '<body><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="1 2 3"/></body>');
  const v = w.data.qvel;
  [v[3], v[4], v[5]] = [0.01, 5, 0.01];
  march(a, h, 20, [], w.step, () => {});
  const q = [3, 4, 5, 6].map((i) => w.data.qpos[i]);
  const sign = q[0] > 0 ? -1 : 1;
  for (const x of q) a.values.push(sign * x);
}

function pendulum(h, a, rods) {
  const at = rods ? 0.5 : 1, inertia = rods ? 1 / 12 : 1e-14;
  const link = (pos, inside) => `<body pos="${pos} 0 0"><joint type="hinge" axis="0 1 0"/>
    <inertial pos="${at} 0 0" mass="1" diaginertia="${0.5 * inertia} ${inertia} ${inertia}"/>${inside}</body>`;
  const w = world(h, { integrator: "RK4" }, link(0, link(1, "")));
  march(a, h, 10, rods ? [0.5, 1, 1.5, 2] : [10], w.step, (v) => {
    const upper = 0.5 * Math.PI - w.data.qpos[0];
    v.push(upper, upper - w.data.qpos[1]);
  });
}

function slope(h, a, stick, integrator) {
  const w = world(h, { gravity: slopeGravity, integrator, geom: stiff(h, stick ? 0.5 : 0.3) },
    `${ground}<body pos="0 0 0.05"><freejoint/><geom type="box" size="0.1 0.05 0.05" mass="1"/></body>`);
  if (!stick) w.data.qvel[0] = 2;
  march(a, h, stick ? 10 : 2, stick ? [10] : [0.2, 1, 2], w.step, (v) => v.push(placeOnSlope(w.data.qpos[0])));
}

function slideToRoll(h, a, integrator) {
  const w = world(h, { integrator, geom: stiff(h, 0.3) },
    `${ground}<body pos="0 0 0.1"><freejoint/><geom type="sphere" size="0.1" mass="1"/></body>`);
  w.data.qvel[0] = 3;
  march(a, h, 0.5, [0.2, 0.5], w.step, (v) => v.push(w.data.qpos[0], w.data.qvel[0]));
}

function stack(h, a, count, ratio, until) {
  let bodies = ground;
  for (let i = 0; i < count; ++i)
    bodies += `<body pos="0 0 ${i + 0.5}"><freejoint/><geom type="box" size="0.5 0.5 0.5" mass="${ratio ** i}"/></body>`;
  const w = world(h, { geom: stiff(h, 0.5) }, bodies);
  march(a, h, until, [], w.step, () => {});
  for (const i of [0, count - 1]) a.values.push(w.data.qpos[7 * i], w.data.qpos[7 * i + 2]);
}

function heavyChain(h, a) {
  let bodies = `<body pos="0.1 0 0"><joint type="hinge" axis="0 1 0"/>
    <inertial pos="0 0 0" mass="100" diaginertia="0.4 0.4 0.4"/></body>`;
  for (let i = 19; i >= 0; --i)
    bodies = `<body pos="${i === 0 ? 0 : 0.1} 0 0"${i === 0 ? ` euler="0 ${Math.PI / 4} 0"` : ""}>
      <joint type="hinge" axis="0 1 0"/>
      <inertial pos="0.05 0 0" mass="0.1" diaginertia="5e-6 8.333333333333333e-5 8.333333333333333e-5"/>${bodies}</body>`;
  const w = world(h, { integrator: "RK4" }, bodies);
  march(a, h, 2, [1, 2], w.step, (v) => {
    let x = 0, z = 0, sum = Math.PI / 4;
    for (let i = 0; i < 20; ++i) {
      sum += w.data.qpos[i];
      x += 0.1 * Math.cos(sum);
      z -= 0.1 * Math.sin(sum);
    }
    v.push(x, z);
  });
}

const ring = "Newton, elliptic, stiff";
serve("MuJoCo " + mujoco.mj_versionString() + ", WebAssembly of npm", [
  "contact is soft by its model, here as stiff as it takes; no restitution: a spring fitted to e",
  "joints in reduced coordinates; Runge-Kutta 4 where nothing touches",
  "WebAssembly in node; a native build is faster",
], [
  ["bouncing_ball", "spring fitted to e", ballSteps, bouncingBall],
  ["free_top", "Runge-Kutta 4", smoothSteps, freeTop],
  ["double_pendulum", "Runge-Kutta 4", smoothSteps, (h, a) => pendulum(h, a, false)],
  ["rod_pendulum", "Runge-Kutta 4", smoothSteps, (h, a) => pendulum(h, a, true)],
  ["slope_slide", ring, ballSteps, (h, a) => slope(h, a, false, "Euler")],
  ["slope_slide", ring + ", Runge-Kutta 4", ballSteps, (h, a) => slope(h, a, false, "RK4")],
  ["slope_stick", ring, restSteps, (h, a) => slope(h, a, true, "Euler")],
  ["slide_to_roll", ring, ballSteps, (h, a) => slideToRoll(h, a, "Euler")],
  ["slide_to_roll", ring + ", Runge-Kutta 4", ballSteps, (h, a) => slideToRoll(h, a, "RK4")],
  ["ratio_stack", ring, restSteps, (h, a) => stack(h, a, 5, 10, 5)],
  ["tower", ring, restSteps, (h, a) => stack(h, a, 10, 1, 10)],
  ["heavy_chain", "joint tree, Runge-Kutta 4", chainSteps, heavyChain],
]);
