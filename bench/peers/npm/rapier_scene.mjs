// Rapier on a scene of many bodies (scene.mjs): settings by its defaults with the length of the
// scene told to it; no sleeping, no damping. Single precision.
import RAPIER from "@dimforge/rapier3d-compat";
import { leave, readScene, runScene, turned } from "./scene.mjs";

const warn = console.warn;
console.warn = () => {};  // its loader speaks of a deprecated parameter
await RAPIER.init();
console.warn = warn;

const s = readScene(process.argv[2]);
const vector = ([x, y, z]) => ({ x, y, z });
const quaternion = ([w, x, y, z]) => ({ w, x, y, z });
const upright = { w: Math.SQRT1_2, x: Math.SQRT1_2, y: 0, z: 0 };  // its axes of revolution are y

function collider(b) {
  const d = b.size, C = RAPIER.ColliderDesc;
  if (b.kind === "Sphere") return C.ball(d[0]);
  if (b.kind === "Box") return C.cuboid(0.5 * d[0], 0.5 * d[1], 0.5 * d[2]);
  if (b.kind === "Capsule") return C.capsule(0.5 * d[1], d[0]).setRotation(upright);
  if (b.kind === "Cylinder") return C.cylinder(0.5 * d[1], d[0]).setRotation(upright);
  if (b.kind === "Cone") return C.cone(0.5 * d[1], d[0]).setRotation(upright);
  const hull = b.kind === "Polyhedron" ? C.convexHull(new Float32Array(d)) : null;
  if (!hull) leave(`no shape ${b.kind}`);
  return hull;
}

const world = new RAPIER.World(vector([0, 0, -s.g]));
world.timestep = s.h;
world.lengthUnit = Math.max(...s.bodies.map((b) => Math.max(...b.size.map(Math.abs))));
const law = (c) => c.setFriction(s.mu).setRestitution(s.e)
  .setFrictionCombineRule(RAPIER.CoefficientCombineRule.Max)
  .setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max);
for (const p of s.planes) {  // a wide slab: its half spaces are no colliders of this package
  const n = p.normal, turn = [1 + n[2], -n[1], n[0], 0], size = Math.hypot(...turn);
  const q = n[2] < -0.999999 ? [0, 1, 0, 0] : turn.map((x) => x / size);
  world.createCollider(law(RAPIER.ColliderDesc.cuboid(100, 100, 10)
    .setTranslation(...p.at.map((x, k) => x - 10 * n[k])).setRotation(quaternion(q))));
}
for (const b of s.slabs)
  world.createCollider(law(RAPIER.ColliderDesc.cuboid(...b.size.map((x) => 0.5 * x))
    .setTranslation(...b.at).setRotation(quaternion(b.turn))));
const bodies = s.bodies.map((b) => {
  const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(...b.at)
    .setRotation(quaternion(b.turn)).setLinvel(...b.v).setAngvel(vector(turned(b.turn, b.w)))
    .setCanSleep(false).setLinearDamping(0).setAngularDamping(0));
  world.createCollider(law(collider(b)).setDensity(0), body);
  body.setAdditionalMassProperties(b.mass, vector([0, 0, 0]), vector(b.inertia), quaternion([1, 0, 0, 0]), true);
  if (body.enableGyroscopicForces) body.enableGyroscopicForces(true);
  return body;
});
runScene(s, () => world.step(), (i) => {
  const r = bodies[i].translation(), q = bodies[i].rotation(), v = bodies[i].linvel(), o = bodies[i].angvel();
  return [r.x, r.y, r.z, q.w, q.x, q.y, q.z, v.x, v.y, v.z,
    ...turned([q.w, q.x, q.y, q.z], [o.x, o.y, o.z], true)];
});
