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

function bob(h, a) {
  const w = world(h, { integrator: "RK4" }, `<body><joint type="hinge" axis="0 1 0"/>
    <inertial pos="-1 0 0" mass="1" diaginertia="5e-15 1e-14 1e-14"/></body>`);
  march(a, h, 10, [1, 2, 5, 10], w.step, (v) => v.push(-Math.cos(w.data.qpos[0]), Math.sin(w.data.qpos[0])));
}

/** Two points held at each other, as stiff as contact. */
const connect = (h, a, b) =>
  `<connect site1="${a}" site2="${b}" solref="${2 * h} 1" solimp="0.9999 0.9999 0.001 0.5 2"/>`;

function fourBars(h, a) {
  const rod = (x, name, inside, at = "") => `<body pos="${x}"${at}><joint type="hinge" axis="0 1 0"/>
    <inertial pos="0.5 0 0" mass="1" diaginertia="1e-3 ${1 / 12} ${1 / 12}"/><site name="${name}" pos="1 0 0"/>${inside}</body>`;
  const up = ` euler="0 ${-0.5 * Math.PI} 0"`, flat = ` euler="0 ${0.5 * Math.PI} 0"`;
  const crank = (i) => rod(`${i} 0 0`, `crank${i}`, i < 2 ? rod("1 0 0", `coupler${i}`, "", flat) : "", up);
  const w = world(h, { integrator: "RK4" }, [0, 1, 2].map(crank).join(""),
    `<equality>${[0, 1].map((i) => connect(h, `coupler${i}`, `crank${i + 1}`)).join("")}</equality>`);
  // crank, its coupler, crank, its coupler, crank
  [1, -1, 1, -1, 1].forEach((u, i) => { w.data.qvel[i] = u; });
  march(a, h, 10, [1, 10], w.step, (v) => {
    const q = w.data.qpos[0] - 0.5 * Math.PI;
    v.push(0.5 * Math.cos(q), -0.5 * Math.sin(q));
  });
}

function andrews(h, a) {
  const q0 = [-0.0617138900142764496, 0, 0.45527981916307038, 0.222668390165885885, 0.48736497954384255,
    -0.222668390165885885, 1.23054744454982119];
  const link = (at, q, mass, inertia, centre, inside) => `<body pos="${at} 0" euler="0 0 ${q}"><joint type="hinge" axis="0 0 1"/>
    <inertial pos="${centre} 0" mass="${mass}" diaginertia="${0.5 * inertia} ${0.5 * inertia} ${inertia}"/>${inside}</body>`;
  const site = (name, at) => `<site name="${name}" pos="${at} 0"/>`;
  const bodies = link("0 0", q0[0], 0.04325, 2.194e-6, "0.00092 0",
    link("0.007 0", q0[1], 0.00365, 4.41e-7, "-0.0115 0", site("E", "-0.028 0"))) +
    link("-0.03635 0.03273", q0[2], 0.02373, 5.255e-6, "0.01043 -0.01874", site("E3", "0 -0.035") + site("D", "0.02 -0.018")) +
    link("-0.06934 -0.00227", q0[4], 0.0705, 1.169e-5, "0.02308 0.00916",
      link("0.04 0", q0[3], 0.00706, 5.667e-7, "0 -0.00579", site("E4", "0 -0.02"))) +
    link("-0.06934 -0.00227", q0[6], 0.05498, 1.912e-5, "0.00449 -0.01228",
      link("0 -0.04", q0[5], 0.00706, 5.667e-7, "0.00579 0", site("E6", "0.02 0"))) +
    site("C", "0.014 0.072");
  const w = world(h, { gravity: [0, 0, 0], integrator: "RK4" }, bodies,
    `<equality>${["E3", "E4", "E6"].map((e) => connect(h, "E", e)).join("")}</equality>
     <tendon><spatial stiffness="4530" springlength="0.07785"><site site="C"/><site site="D"/></spatial></tendon>`);
  w.data.qfrc_applied[0] = 0.033;
  march(a, h, 0.03, [0.03], w.step, (v) => {
    // joints in the order of the bodies: β, Θ, γ, δ, Φ, ε, Ω
    const q = w.data.qpos;
    [[0, 0], [1, 1], [2, 2], [4, 3], [3, 4], [6, 5], [5, 6]].forEach(([from, k]) => v.push(q0[k] + q[from]));
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
  ["pendulum", "Runge-Kutta 4", smoothSteps, bob],
  ["four_bars", "Runge-Kutta 4, loops as stiff as contact", smoothSteps, fourBars],
  ["andrews", "Runge-Kutta 4, loops as stiff as contact", ["2e-4", "1e-4*", "5e-5", "2e-5*", "1e-5", "5e-6", "2e-6"], andrews],
  ["slope_slide", ring, ballSteps, (h, a) => slope(h, a, false, "Euler")],
  ["slope_slide", ring + ", Runge-Kutta 4", ballSteps, (h, a) => slope(h, a, false, "RK4")],
  ["slope_stick", ring, restSteps, (h, a) => slope(h, a, true, "Euler")],
  ["slide_to_roll", ring, ballSteps, (h, a) => slideToRoll(h, a, "Euler")],
  ["slide_to_roll", ring + ", Runge-Kutta 4", ballSteps, (h, a) => slideToRoll(h, a, "RK4")],
  ["ratio_stack", ring, restSteps, (h, a) => stack(h, a, 5, 10, 5)],
  ["tower", ring, restSteps, (h, a) => stack(h, a, 10, 1, 10)],
  ["heavy_chain", "joint tree, Runge-Kutta 4", chainSteps, heavyChain],
]);
