// Masses, centres, inertias, poses and mass matrix of an imported machine against MuJoCo.
//   node compare.mjs FILE [options of dynamy import]
import path from "node:path";
import { commonBodies, dynamy, imported, mujoco, numbers, peerModel, scratch, short, simpleJoints, sourceText, startOf } from "./machine.mjs";

const kSets = 100;
const [file, ...options] = process.argv.slice(2);
const model = peerModel(sourceText(file)), data = new mujoco.MjData(model);
const { xml, jointName } = imported(file, options);
const check = dynamy("dynamy", ["check", scratch("model.xml")], { accept: [0, 1, 3] }).status;
const worst = { mass: 0, centre: 0, inertia: 0, position: 0, axes: 0, M: 0 };
const differ = (key, x) => { worst[key] = x > worst[key] || Number.isNaN(x) ? x : worst[key]; };

function rotation([w, x, y, z]) {
  return [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z), 1 - 2 * (x * x + z * z),
          2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)];
}
const three = (array, i) => [0, 1, 2].map((k) => array[3 * i + k]);
const four = (array, i) => [0, 1, 2, 3].map((k) => array[4 * i + k]);

/** Inertia in the axes of the link: xx yy zz xy xz yz. */
function inertiaOf(i) {
  const A = rotation(four(model.body_iquat, i)), I = three(model.body_inertia, i);
  const J = (a, b) => [0, 1, 2].reduce((sum, k) => sum + A[3 * a + k] * I[k] * A[3 * b + k], 0);
  return [J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2)];
}

const bodies = commonBodies(model, xml);
for (const [name, i] of bodies) {
  const escaped = name.replace(/[$^+?()|\\]/g, "\\$&");
  const [, body, frame] = xml.match(new RegExp(`<RigidBody name="${escaped}"([^>]*)>\\s*<Frame name="origin"([^>]*)/>`));
  const value = (text, attribute) => numbers(text.match(new RegExp(` ${attribute}="([^"]*)"`))?.[1] ?? "0 0 0");
  const m = model.body_mass[i], J = inertiaOf(i), ours = value(body, "inertia"), origin = value(frame, "position");
  differ("mass", Math.abs(value(body, "mass")[0] - m) / Math.max(m, 1e-12));
  three(model.body_ipos, i).forEach((x, k) => differ("centre", Math.abs(x + origin[k])));
  J.forEach((x, k) => differ("inertia", Math.abs(x - ours[k]) / Math.max(J[0] + J[1] + J[2], 1e-300)));
}

const joints = simpleJoints(model, jointName);
for (const joint of joints) joint.start = startOf(xml, joint.name) ?? model.qpos0[joint.q];
let seed = 12345;
const random = () => { seed = (seed * 1103515245 + 12345) % 2147483648; return seed / 1073741824 - 1; };
const sets = Array.from({ length: kSets }, () => joints.map(() => Math.PI * random()));
const input = sets.map((set) => joints.map((joint, k) => `${joint.name} ${set[k] - joint.start}`).join(" ")).join("\n") + "\n";
const answer = dynamy("bench_machine", [scratch("model.xml"), joints.map((j) => j.name).join(" "), bodies.map(([name]) => name).join(" ")], { input });

const buffer = new mujoco.DoubleBuffer(model.nv);
function columnOfM(u) {
  mujoco.mj_mulM(model, data, buffer, Array.from({ length: model.nv }, (_, k) => (k === u ? 1 : 0)));
  return Array.from(buffer.GetView());
}
answer.stdout.trim().split("\n").map((line) => JSON.parse(line)).forEach((ours, i) => {
  for (let k = 0; k < model.nq; k++) data.qpos[k] = model.qpos0[k];
  joints.forEach((joint, k) => { data.qpos[joint.q] = sets[i][k]; });
  mujoco.mj_forward(model, data);
  let scale = 1e-300, error = 0;
  for (const a of joints) {
    const column = columnOfM(a.u);
    for (const b of joints) {
      scale = Math.max(scale, Math.abs(column[b.u]));
      error = Math.max(error, Math.abs(column[b.u] - ours.M[ours.index[b.name] * ours.nu + ours.index[a.name]]));
    }
  }
  differ("M", error / scale);
  for (const [name, id] of bodies) {
    const v = ours.bodies[name], q = four(data.xquat, id);
    three(data.xipos, id).forEach((x, k) => differ("position", Math.abs(x - v[k])));
    const sign = Math.sign(q.reduce((sum, x, k) => sum + x * v[3 + k], 0));
    q.forEach((x, k) => differ("axes", Math.abs(x - sign * v[3 + k])));
  }
});
console.log(`${path.basename(file)}: check ${check}, bodies ${bodies.length} of ${model.nbody - 1}, joints ${joints.length} of ${model.njnt}, ` +
  Object.entries(worst).map(([key, x]) => `${key} ${short(x)}`).join(", "));
