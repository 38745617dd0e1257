// A scene of many bodies and the answer to it, as in bench/peers/scene.hpp.
import { readFileSync } from "node:fs";

export const processTime = () => {
  const t = process.cpuUsage();
  return 1e-6 * (t.user + t.system);
};

export function readScene(file) {
  const s = { planes: [], slabs: [], bodies: [], joints: [] };
  for (const line of readFileSync(file, "utf8").split("\n")) {
    const [word, ...rest] = line.split(" ");
    const x = rest.map(Number);
    if (word === "run") [s.h, s.steps, s.samples] = x;
    if (word === "law") [s.g, s.mu, s.e] = x;
    if (word === "plane") s.planes.push({ at: x.slice(0, 3), normal: x.slice(3, 6) });
    if (word === "slab") s.slabs.push({ size: x.slice(0, 3), at: x.slice(3, 6), turn: x.slice(6, 10) });
    if (word === "joint") s.joints.push(rest);
    if (word === "body") {
      const n = x[1], y = x.slice(2 + n);
      s.bodies.push({
        kind: rest[0], size: x.slice(2, 2 + n), mass: y[0], inertia: y.slice(1, 4), at: y.slice(4, 7),
        turn: y.slice(7, 11), v: y.slice(11, 14), w: y.slice(14, 17),
      });
    }
  }
  if (s.joints.length > 0) leave("joints are left out");
  return s;
}

/** Ends the program: this scene is none for this peer. */
export function leave(why) {
  console.log("note " + why);
  process.exit(1);
}

/** v turned by the quaternion w x y z, or back. */
export function turned([w, x, y, z], v, back = false) {
  const s = back ? -1 : 1, q = [s * x, s * y, s * z];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const t = cross(q, v).map((c) => 2 * c), u = cross(q, t);
  return v.map((c, k) => c + w * t[k] + u[k]);
}

/** Steps through the scene; pose(i) gives the 13 numbers of a body. */
export function runScene(s, step, pose) {
  const out = [];
  let cpu = 0, next = 1;
  for (let i = 1; i <= s.steps; ++i) {
    const begin = processTime();
    step();
    if (i > 1) cpu += processTime() - begin;
    if (i < (next * s.steps) / s.samples) continue;
    ++next;
    for (let k = 0; k < s.bodies.length; ++k) out.push("pose " + pose(k).join(" "));
  }
  console.log("cpu " + cpu);
  console.log(out.join("\n"));
}
