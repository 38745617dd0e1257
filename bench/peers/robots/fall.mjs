// A fall of an imported machine against MuJoCo: damping, springs, armature and drives with constant
// inputs; no contact, limits and dry friction, no equalities.
//   node fall.mjs FILE SECONDS INPUT [options of dynamy import]     INPUT: of all drives
import path from "node:path";
import { commonBodies, imported, mujoco, peerModel, signalsOf, short, simpleJoints, sourceText, startOf, without } from "./machine.mjs";

const [file, until, drive, ...options] = process.argv.slice(2);
const T = Number(until), kRows = 10;
const model = peerModel(sourceText(file, "actuator")), data = new mujoco.MjData(model);
model.opt.integrator = 1;  // Runge-Kutta
model.opt.timestep = 1e-4;
model.opt.disableflags |= 0b11111;  // constraint, equality, frictionloss, limit, contact

const { xml, jointName } = imported(file, options);
const bodies = commonBodies(model, xml);
const signals = bodies.map(([name]) => `${name}.x ${name}.y ${name}.z`).join(" ");
const text = without(xml.replace(/ material="[^"]*"/g, ""), "JointStop", "GivenFriction", "NoContact", "Material", "Contacts", "Gear")
  .replace(/(<Input name="[^"]*")[^>]*\/>/g, `$1 value="${drive}"/>`)
  .replace(/<record[^>]*\/>/, `<record signals="${signals}" every="${T / kRows}"/>`)
  .replace(/<simulation[^>]*\/>/, `<simulation until="${T}" tolerance="1e-11" coordinates="minimal"/>`);
const run = signalsOf(text, "fall");

for (let k = 0; k < model.nu; k++) data.ctrl[k] = Number(drive);
for (const joint of simpleJoints(model, jointName)) data.qpos[joint.q] = startOf(xml, joint.name) ?? model.qpos0[joint.q];
mujoco.mj_forward(model, data);
const start = Array.from(data.xipos);
let worst = 0, where = "", far = 0;
for (let i = 1; i <= kRows; i++) {
  while (data.time < (i * T) / kRows - 1e-9) mujoco.mj_step(model, data);
  mujoco.mj_forward(model, data);
  for (const [name, id] of bodies)
    ["x", "y", "z"].forEach((axis, k) => {
      const x = data.xipos[3 * id + k], error = Math.abs(run.rows[i][run.column(`${name}.${axis}`)] - x);
      far = Math.max(far, Math.abs(x - start[3 * id + k]));
      if (!(error <= worst)) [worst, where] = [error, `${name}.${axis} at ${(i * T) / kRows} s`];
    });
}
console.log(`${path.basename(file)}: ${bodies.length} bodies, ${model.nu} drives, ${T} s, moved up to ${far.toFixed(3)} m, differs by ${short(worst)} m (${where})`);
