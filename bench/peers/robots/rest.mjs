// Height at rest of a machine with held joints that falls onto a plane, against MuJoCo with stiff
// contacts (time constant 1 ms).
//   node rest.mjs FILE SECONDS LIFT     LIFT: height of the root above the floor [m], of MJCF beyond the file's
// Of URDF, whose files have no floor, shapes of contact without meshes; MuJoCo itself writes it as MJCF, to
// which the floor is added.
import fs from "node:fs";
import path from "node:path";
import { clean, imported, isUrdf, kBody, mujoco, nameOf, numbers, peerModel, scratch, signalsOf, sourceText, without } from "./machine.mjs";

const [file, until, height] = process.argv.slice(2);
const T = Number(until), lift = Number(height ?? 0), urdf = isUrdf(file);
const kFloor = `<geom name="floor" type="plane" size="9 9 1" friction="1 0 0" pos="0 0 ${-lift}"/>`;

/** Bodies without joints are rigidly connected with what carries them. */
function held(text) {
  const begin = text.indexOf("<worldbody");
  return text.slice(0, begin) + without(text.slice(begin).replace(/<joint\b[^>]*type="free"[^>]*\/>/g, "<freejoint/>"), "joint");
}

function fromUrdf() {
  // Heights at rest do not depend on inertia, and some files hold values that MuJoCo refuses.
  const text = sourceText(file, "collision")
    .replace(/<inertia\b[^>]*\/>/g, '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>')
    .replace(/<collision\b[^>]*>(?:(?!<\/collision>)[\s\S])*<mesh[\s\S]*?<\/collision>/g, "")
    .replace(/(<joint\b[^>]*\btype=")(?:revolute|continuous|prismatic)"/g, '$1fixed"');
  const model = peerModel(text);
  mujoco.mj_saveLastXML("/saved.xml", model);
  const saved = mujoco.FS.readFile("/saved.xml", { encoding: "utf8" });
  const root = saved.match(/<worldbody>\s*<body name="([^"]*)"/);
  const peer = saved.replace(/<worldbody>\s*<body ([^>]*?)(?:pos="[^"]*")?>/, (_, a) => `<worldbody>${kFloor}<body ${a}><freejoint/>`);
  return { text, peer, root: root[1], options: ["--free-base"] };
}

function fromMjcf() {
  const whole = held(without(sourceText(file), "equality", "contact"));
  const text = whole.replace(/<body\b[^>]*>/, (body) =>
    body.replace(/pos="([^"]*)"/, (_, pos) => { const [x, y, z] = numbers(pos); return `pos="${x} ${y} ${z + lift}"`; }));
  return { text, peer: text, options: [] };
}

const { text, peer, root, options } = urdf ? fromUrdf() : fromMjcf();
const model = mujoco.MjModel.from_xml_string(peer), data = new mujoco.MjData(model);
model.opt.timestep = 2e-4;
model.opt.cone = 1;  // elliptic
model.opt.integrator = 0;
for (let g = 0; g < model.ngeom; g++) {
  model.geom_solref[2 * g] = 1e-3;
  model.geom_solref[2 * g + 1] = 1;
  model.geom_margin[g] = 0;
}
let base = 1;
for (let b = 1; b < model.nbody; b++) if (model.body_dofnum[b] === 6) base = b;
const name = clean(root ?? nameOf(model, kBody, base));

const source = scratch(urdf ? "held.urdf" : "held.xml");
fs.writeFileSync(source, text);
let { xml } = imported(source, options);
if (urdf) {
  const ground = `<Ground name="floor"><HalfSpace position="0 0 ${-lift}" normal="0 0 1" material="floor"/></Ground>`;
  xml = xml.replace("<systems>", `<systems>${ground}`).replace(/(<Contacts\b)/, '<Material name="floor" mu="1"/>$1');
}
const origin = (a) => `${name}.origin.${a}`;
const run = signalsOf(
  xml.replace(/<record[^>]*\/>/, `<record signals="${origin("z")} ${name}.vz ${name}.qw" every="0.1"/>`)
    .replace(/<simulation[^>]*\/>/, `<simulation until="${T}" step="1e-3" coordinates="minimal"/>`), "rest");
const last = run.rows.at(-1);

mujoco.mj_forward(model, data);
const start = data.xpos[3 * base + 2];
while (data.time < T) mujoco.mj_step(model, data);
mujoco.mj_forward(model, data);
const z = data.xpos[3 * base + 2], ours = last[run.column(origin("z"))];
console.log(`${path.basename(file)}: ${model.ngeom} shapes, start ${start.toFixed(4)} m, at rest MuJoCo ${z.toFixed(6)} m, dynamY ${ours.toFixed(6)} m, ` +
  `difference ${Math.abs(z - ours).toExponential(1)} m; speeds ${Math.abs(data.qvel[2]).toExponential(1)}, ${Math.abs(last[run.column(`${name}.vz`)]).toExponential(1)} m/s; ` +
  `qw ${data.xquat[4 * base].toFixed(4)}, ${last[run.column(`${name}.qw`)].toFixed(4)}`);
