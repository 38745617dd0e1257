// A machine of a URDF or MJCF file in MuJoCo and as an imported model; shared by the comparisons.
import load from "@mujoco/mujoco";
import { spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";

export const mujoco = await load();
export const kBody = 1, kJoint = 3;  // kinds of named objects
const kFree = 0, kBall = 1;          // kinds of joints
const bin = process.env.DYNAMY_BIN ?? "build/release/bin";
const folder = process.env.KEEP ?? fs.mkdtempSync(path.join(os.tmpdir(), "robots-"));
if (!process.env.KEEP) process.on("exit", () => fs.rmSync(folder, { recursive: true }));

export const numbers = (text) => text.trim().split(/\s+/).map(Number);
export const scratch = (name) => path.join(folder, name);
/** A name as it can stand in a model file. */
export const clean = (name) => name.replace(/[ \t./[\]{}*"'<>&]/g, "_");
export const nameOf = (model, kind, i) => mujoco.mj_id2name(model, kind, i) ?? "";

/** Without elements of these tags. */
export const without = (text, ...tags) =>
  tags.reduce((t, tag) => t.replace(new RegExp(`<${tag}\\b[^>]*?/>|<${tag}\\b[^>]*>[\\s\\S]*?</${tag}>`, "g"), ""), text);

const readText = (file) => fs.readFileSync(file, "utf8").replace(/<!--[\s\S]*?-->/g, "");

function included(text, folder) {
  return text.replace(/<include\s+file="([^"]+)"\s*\/>/g, (_, name) => {
    const inner = readText(path.join(folder, name));
    return included(inner.replace(/^[\s\S]*?<mujoco[^>]*>/, "").replace(/<\/mujoco\w*>\s*$/, ""), folder);
  });
}

export const isUrdf = (file) => /<robot\b/.test(readText(file));

/** Text of the file as one, without what needs further files or is not compared; `kept`: tags that stay. */
export function sourceText(file, ...kept) {
  const drop = isUrdf(file) ? ["visual", "collision", "transmission", "gazebo", "mujoco", "ros2_control"]
                            : ["sensor", "tendon", "keyframe", "visual", "actuator"];
  const text = isUrdf(file) ? readText(file) : included(readText(file), path.dirname(file));
  return without(text, ...drop.filter((tag) => !kept.includes(tag)));
}

/** MuJoCo's model of a text; of URDF with all links as bodies. */
export function peerModel(text) {
  const settings = '<mujoco><compiler fusestatic="false" discardvisual="true"/></mujoco>';
  return mujoco.MjModel.from_xml_string(text.replace(/<robot[^>]*>/, (root) => root + settings));
}

/** Runs a program of the project; its output, or an exception with what it wrote. */
export function dynamy(program, args, { input, accept = [0] } = {}) {
  const run = spawnSync(path.join(bin, program), args, { input, encoding: "utf8", maxBuffer: 1 << 30 });
  if (!accept.includes(run.status)) throw new Error(`${program} ${args[0]}: ${run.stderr || run.stdout}`);
  return run;
}

/** The imported model: its text, and the names of joints that were changed. */
export function imported(file, options) {
  const out = scratch("model.xml");
  const run = dynamy("dynamy", ["import", file, "-o", out, ...options]);
  const xml = fs.readFileSync(out, "utf8");
  const renamed = new Map([...run.stderr.matchAll(/joint (\S+): is named "([^"]+)"/g)].map((m) => [m[1], m[2]]));
  return { xml, jointName: (name) => renamed.get(name) ?? clean(name) };
}

/** Value of a joint at the start of the imported model; undefined if no element has one. */
export const startOf = (xml, joint) => {
  const found = xml.match(new RegExp(`name="${joint}_(?:stop|spring)"[^>]* start="([^"]*)"`));
  return found ? Number(found[1]) : undefined;
};

/** Bodies that both have: [name, index in MuJoCo's model]. */
export function commonBodies(model, xml) {
  const ours = new Set([...xml.matchAll(/<RigidBody name="([^"]+)"/g)].map((m) => m[1]));
  return Array.from({ length: model.nbody }, (_, i) => [clean(nameOf(model, kBody, i)), i]).filter(([name]) => ours.has(name));
}

/** Joints with one coordinate: name in the model, and addresses of q and u in MuJoCo's. */
export function simpleJoints(model, jointName) {
  const all = Array.from({ length: model.njnt }, (_, j) => j).filter((j) => ![kFree, kBall].includes(model.jnt_type[j]));
  return all.map((j) => ({ name: jointName(nameOf(model, kJoint, j)), q: model.jnt_qposadr[j], u: model.jnt_dofadr[j] }));
}

/** Runs a model; rows of its signals after the head, with the column of each signal. */
export function signalsOf(xml, name) {
  const file = scratch(`${name}.xml`), out = scratch(name);
  fs.writeFileSync(file, xml);
  dynamy("dynamy", ["run", file, "--quiet", "--out", out], { accept: [0, 3] });
  const lines = fs.readFileSync(path.join(out, "signals.csv"), "utf8").trim().split("\n");
  const head = lines[0].split(",").map((cell) => cell.replace(/\s*\[.*/, "").trim());
  return { rows: lines.slice(1).map((line) => line.split(",").map(Number)), column: (signal) => head.indexOf(signal) };
}

export const short = (x) => x.toExponential(1);
