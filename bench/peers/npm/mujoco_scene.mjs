// MuJoCo on a scene of many bodies (scene.mjs): its Newton solver with elliptic cones, otherwise as
// its documentation has it. It has no coefficient of restitution; scenes with one are left out.
import load from "@mujoco/mujoco";
import { leave, readScene, runScene } from "./scene.mjs";

const mujoco = await load();
const s = readScene(process.argv[2]);
if (s.e > 0) leave("no coefficient of restitution");

let meshes = "";
const list = (x) => x.join(" ");

function geom(b, i) {
  const d = b.size;
  if (b.kind === "Sphere") return `type="sphere" size="${d[0]}"`;
  if (b.kind === "Box") return `type="box" size="${list(d.map((x) => 0.5 * x))}"`;
  if (b.kind === "Capsule" || b.kind === "Cylinder") return `type="${b.kind.toLowerCase()}" size="${d[0]} ${0.5 * d[1]}"`;
  if (b.kind !== "Polyhedron") leave(`no shape ${b.kind}`);
  meshes += `<mesh name="m${i}" vertex="${list(d)}" inertia="convex"/>`;
  return `type="mesh" mesh="m${i}"`;
}

/** Quaternion that turns e_z to n. */
function toNormal(n) {
  if (n[2] < -0.999999) return [0, 1, 0, 0];
  const q = [1 + n[2], -n[1], n[0], 0], size = Math.hypot(...q);
  return q.map((x) => x / size);
}

const ground = s.planes.map((p) => `<geom type="plane" size="50 50 1" pos="${list(p.at)}" quat="${list(toNormal(p.normal))}"/>`)
  .concat(s.slabs.map((b) => `<geom type="box" size="${list(b.size.map((x) => 0.5 * x))}" pos="${list(b.at)}" quat="${list(b.turn)}"/>`));
const bodies = s.bodies.map((b, i) => `<body pos="${list(b.at)}" quat="${list(b.turn)}"><freejoint/>
  <inertial pos="0 0 0" mass="${b.mass}" diaginertia="${list(b.inertia)}"/><geom ${geom(b, i)}/></body>`);
const model = mujoco.MjModel.from_xml_string(`<mujoco><compiler angle="radian"/>
  <option timestep="${s.h}" gravity="0 0 ${-s.g}" cone="elliptic" solver="Newton"/><size memory="1G"/>
  <default><geom friction="${s.mu} 0 0" condim="${s.mu > 0 ? 3 : 1}"/></default>
  <asset>${meshes}</asset><worldbody>${ground.join("")}${bodies.join("")}</worldbody></mujoco>`);
const data = new mujoco.MjData(model);
s.bodies.forEach((b, i) => [...b.v, ...b.w].forEach((x, k) => { data.qvel[6 * i + k] = x; }));
mujoco.mj_forward(model, data);
runScene(s, () => mujoco.mj_step(model, data), (i) => {
  const q = data.qpos, u = data.qvel, out = [];
  for (let k = 0; k < 7; ++k) out.push(q[7 * i + k]);
  for (let k = 0; k < 6; ++k) out.push(u[6 * i + k]);  // its angular velocities are in the body's axes
  return out;
});
