// Rapier on the scenes of bench/work_precision.
//
// Settings by its documentation: small steps, more solver iterations, contacts seen within the
// prediction distance kept short for scenes of decimetres; no sleeping, no damping. Contacts and
// joints are springs of a high frequency by its model; numbers are of single precision.
import RAPIER from "@dimforge/rapier3d-compat";
import {
  angleFromDown, ballSteps, chainSteps, march, placeOnSlope, restSteps, serve, slopeGravity, smoothSteps,
} from "./peer.mjs";

const warn = console.warn;
console.warn = () => {};  // its loader speaks of a deprecated parameter
await RAPIER.init();
console.warn = warn;

const vector = (x, y, z) => ({ x, y, z });

class World {
  constructor(h, gravity = [0, 0, -9.81], iterations = 16) {
    this.world = new RAPIER.World(vector(...gravity));
    this.world.timestep = h;
    this.world.integrationParameters.numSolverIterations = iterations;
    this.world.integrationParameters.normalizedAllowedLinearError = 1e-6;
    this.world.integrationParameters.normalizedPredictionDistance = 1e-3;
  }
  body(at, quaternion) {
    const d = RAPIER.RigidBodyDesc.dynamic().setTranslation(...at).setCanSleep(false);
    if (quaternion) d.setRotation(quaternion);
    d.setLinearDamping(0).setAngularDamping(0);
    return this.world.createRigidBody(d);
  }
  inertia(body, mass, principal) {
    body.setAdditionalMassProperties(mass, vector(0, 0, 0), vector(...principal), { x: 0, y: 0, z: 0, w: 1 }, true);
    return body;
  }
  shape(body, collider, mass, mu, e = 0) {
    collider.setMass(mass).setFriction(mu).setRestitution(e);
    collider.setFrictionCombineRule(RAPIER.CoefficientCombineRule.Max);
    collider.setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max);
    this.world.createCollider(collider, body);
    return body;
  }
  ground() {
    const c = RAPIER.ColliderDesc.cuboid(100, 100, 10).setTranslation(0, 0, -10).setFriction(0).setRestitution(0);
    this.world.createCollider(c);
  }
  join(data, a, b) {
    this.world.createImpulseJoint(data, a, b, true);
  }
  fixed() {
    return this.world.createRigidBody(RAPIER.RigidBodyDesc.fixed());
  }
  step() {
    this.world.step();
  }
}

function bouncingBall(h, a) {
  const w = new World(h);
  w.ground();
  const ball = w.shape(w.body([0, 0, 1.1]), RAPIER.ColliderDesc.ball(0.1), 1, 0, 0.5);
  march(a, h, 1.6, [0.6, 1.0, 1.2, 1.3, 1.6], () => w.step(), (v) => v.push(ball.translation().z));
  w.world.free();
}

function freeTop(h, a) {
  const w = new World(h, [0, 0, 0]);
  const top = w.inertia(w.body([0, 0, 0]), 1, [1, 2, 3]);
  if (top.enableGyroscopicForces) top.enableGyroscopicForces(true);
  top.setAngvel(vector(0.01, 5, 0.01), true);
  march(a, h, 20, [], () => w.step(), () => {});
  const q = top.rotation();
  const sign = q.w > 0 ? -1 : 1;
  a.values.push(sign * q.w, sign * q.x, sign * q.y, sign * q.z);
  w.world.free();
}

function rodPendulum(h, a) {
  const w = new World(h);
  const hinge = (x, y) => RAPIER.JointData.revolute(vector(x, 0, 0), vector(y, 0, 0), vector(0, 1, 0));
  const rods = [0.5, 1.5].map((x) => w.inertia(w.body([x, 0, 0]), 1, [1e-3, 1 / 12, 1 / 12]));
  w.join(hinge(0, -0.5), w.fixed(), rods[0]);
  w.join(hinge(0.5, -0.5), rods[0], rods[1]);
  march(a, h, 10, [0.5, 1, 1.5, 2], () => w.step(), (v) => {
    for (const rod of rods) {
      const q = rod.rotation();  // the rod is the body's x axis
      v.push(angleFromDown(1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.z - q.w * q.y)));
    }
  });
  w.world.free();
}

function slope(h, a, stick) {
  const w = new World(h, slopeGravity);
  w.ground();
  const box = w.shape(w.body([0, 0, 0.05]), RAPIER.ColliderDesc.cuboid(0.1, 0.05, 0.05), 1, stick ? 0.5 : 0.3);
  if (!stick) box.setLinvel(vector(2, 0, 0), true);
  march(a, h, stick ? 10 : 2, stick ? [10] : [0.2, 1, 2], () => w.step(), (v) =>
    v.push(placeOnSlope(box.translation().x)));
  w.world.free();
}

function slideToRoll(h, a) {
  const w = new World(h);
  w.ground();
  const ball = w.shape(w.body([0, 0, 0.1]), RAPIER.ColliderDesc.ball(0.1), 1, 0.3);
  ball.setLinvel(vector(3, 0, 0), true);
  march(a, h, 0.5, [0.2, 0.5], () => w.step(), (v) => v.push(ball.translation().x, ball.linvel().x));
  w.world.free();
}

function stack(h, a, count, ratio, until) {
  const w = new World(h, undefined, 50);
  w.ground();
  const cubes = [];
  for (let i = 0; i < count; ++i)
    cubes.push(w.shape(w.body([0, 0, i + 0.5]), RAPIER.ColliderDesc.cuboid(0.5, 0.5, 0.5), ratio ** i, 0.5));
  march(a, h, until, [], () => w.step(), () => {});
  for (const c of [cubes[0], cubes[count - 1]]) a.values.push(c.translation().x, c.translation().z);
  w.world.free();
}

function heavyChain(h, a) {
  const w = new World(h, undefined, 50);
  const c = Math.SQRT1_2, turn = { x: 0, y: Math.sin(Math.PI / 8), z: 0, w: Math.cos(Math.PI / 8) };
  let before = w.fixed();
  for (let i = 0; i < 20; ++i) {
    const at = 0.1 * c * (i + 0.5);
    const link = w.inertia(w.body([at, 0, -at], turn), 0.1, [5e-6, 8.333333333333333e-5, 8.333333333333333e-5]);
    w.join(RAPIER.JointData.spherical(vector(i ? 0.05 : 0, 0, 0), vector(-0.05, 0, 0)), before, link);
    before = link;
  }
  const end = w.inertia(w.body([2 * c, 0, -2 * c]), 100, [0.4, 0.4, 0.4]);
  w.join(RAPIER.JointData.spherical(vector(0.05, 0, 0), vector(0, 0, 0)), before, end);
  march(a, h, 2, [1, 2], () => w.step(), (v) => v.push(end.translation().x, end.translation().z));
  w.world.free();
}

serve("Rapier " + RAPIER.version() + ", WebAssembly of npm", [
  "single precision; contacts and joints are stiff springs by its model",
  "WebAssembly in node; a native build is faster",
], [
  ["bouncing_ball", "16 iterations", ballSteps, bouncingBall],
  ["free_top", "gyroscopic", smoothSteps, freeTop],
  ["rod_pendulum", "impulse joints, 16 iterations", smoothSteps, rodPendulum],
  ["slope_slide", "16 iterations", ballSteps, (h, a) => slope(h, a, false)],
  ["slope_stick", "16 iterations", restSteps, (h, a) => slope(h, a, true)],
  ["slide_to_roll", "16 iterations", ballSteps, slideToRoll],
  ["ratio_stack", "50 iterations", restSteps, (h, a) => stack(h, a, 5, 10, 5)],
  ["tower", "50 iterations", restSteps, (h, a) => stack(h, a, 10, 1, 10)],
  ["heavy_chain", "impulse joints, 50 iterations", chainSteps, heavyChain],
]);
