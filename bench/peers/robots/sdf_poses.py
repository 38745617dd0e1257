#!/usr/bin/env python3
"""Poses and masses of links, places and axes of joints of an imported SDF model against a reading of its own.

  bench/peers/robots/sdf_poses.py FILE...      prints one line a file; DYNAMY_BIN: folder of the program

The reading knows poses in the frames of models, links, joints and <frame>, the format's defaults (a joint's
frame is that of its child, an axis is in the joint's frame) and use_parent_model_frame of old versions. Files
with models in models or <include> are passed over.
"""
import math
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

BIN = os.environ.get("DYNAMY_BIN", "build/release/bin")
UNIT = [[1.0, 0, 0, 0], [0, 1.0, 0, 0], [0, 0, 1.0, 0], [0, 0, 0, 1.0]]


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def direction(a, p):
    return [sum(a[i][k] * p[k] for k in range(3)) for i in range(3)]


def numbers(text, count):
    out = [float(x) for x in (text or "").split()]
    return out + [0.0] * (count - len(out))


def pose_of(node):
    """Matrix of a <pose>: x y z and roll, pitch, yaw about fixed axes."""
    if node is None:
        return UNIT
    x, y, z, r, p, w = numbers(node.text, 6)
    if node.get("degrees") == "true":
        r, p, w = (math.radians(v) for v in (r, p, w))
    cr, sr, cp, sp, cw, sw = math.cos(r), math.sin(r), math.cos(p), math.sin(p), math.cos(w), math.sin(w)
    return [[cw * cp, cw * sp * sr - sw * cr, cw * sp * cr + sw * sr, x],
            [sw * cp, sw * sp * sr + cw * cr, sw * sp * cr - cw * sr, y],
            [-sp, cp * sr, cp * cr, z], UNIT[3]]


class Poses:
    """Poses in the world of what a model names."""

    def __init__(self, model):
        self.root = pose_of(model.find("pose"))
        self.named = {e.get("name"): e for tag in ("joint", "frame", "link") for e in model.findall(tag)}

    def of(self, name):
        if name in ("", "__model__"):
            return self.root
        if name == "world":
            return UNIT
        return self.of_element(self.named[name])

    def of_element(self, node):
        pose = node.find("pose")
        base = pose.get("relative_to", "") if pose is not None else ""
        if not base and node.tag == "joint":
            base = node.findtext("child").strip()
        if base == "" and node.tag == "frame":
            base = node.get("attached_to", "")
        return times(self.of(base), pose_of(pose))


def expected(root):
    """Links: name → (pose, mass); joints: name → (place, axis), both in the world."""
    links, joints = {}, {}
    for model in root.iter("model"):
        poses = Poses(model)
        for link in model.findall("link"):
            mass = link.find("inertial/mass")
            links[link.get("name")] = (poses.of(link.get("name")), float(mass.text) if mass is not None else 1.0)
        for joint in model.findall("joint"):
            if joint.get("type") not in ("revolute", "continuous", "prismatic"):
                continue
            here, xyz = poses.of_element(joint), joint.find("axis/xyz")
            frame, text = here, "0 0 1"
            if xyz is not None:
                text = xyz.text
                if xyz.get("expressed_in") is not None:
                    frame = poses.of(xyz.get("expressed_in"))
            if (joint.findtext("axis/use_parent_model_frame") or "").strip() in ("1", "true"):
                frame = poses.root
            axis = direction(frame, numbers(text, 3))
            size = math.sqrt(sum(x * x for x in axis))
            joints[joint.get("name")] = ([row[3] for row in here[:3]], [x / size for x in axis])
    return links, joints


def attribute(text, name, default="0 0 0"):
    found = re.search(f' {name}="([^"]*)"', text)
    return [float(x) for x in (found.group(1) if found else default).split()]


def turn_of(w, x, y, z):
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def compare(path):
    root = ET.parse(path).getroot()
    if root.find(".//include") is not None or root.find(".//model/model") is not None:
        return "passed over: models in models"
    if root.find("world/frame") is not None or root.find("world/model/pose[@relative_to]") is not None:
        return "passed over: frames of the world"
    links, joints = expected(root)
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "model.xml")
        run = subprocess.run([os.path.join(BIN, "dynamy"), "import", path, "-o", out], capture_output=True, text=True)
        if run.returncode != 0:
            return "not imported: " + (run.stderr.strip().splitlines() or [""])[-1]
        with open(out, encoding="utf-8") as file:
            text = file.read()
    worst = {"mass": 0.0, "position": 0.0, "axes": 0.0, "joint": 0.0, "axis": 0.0}
    seen = [0, 0]

    def differ(key, a, b, scale=1.0):
        worst[key] = max(worst[key], *(abs(x - y) / scale for x, y in zip(a, b)))

    for name, body, frame in re.findall(r'<RigidBody name="([^"]+)"([^>]*)>\s*<Frame name="origin"([^>]*)/>', text):
        if name not in links:
            continue
        seen[0] += 1
        pose, mass = links[name]
        turn = turn_of(*attribute(body, "orientation", "1 0 0 0"))
        at = [x + y for x, y in zip(attribute(body, "position"), direction(turn, attribute(frame, "position")))]
        differ("mass", attribute(body, "mass"), [mass], max(mass, 1e-12))
        differ("position", at, [row[3] for row in pose[:3]])
        for ours, theirs in zip(turn, pose):
            differ("axes", ours, theirs)
    for name, rest in re.findall(r'<(?:Revolute|Prismatic) name="([^"]+)"([^>]*)>', text):
        if name not in joints:
            continue
        seen[1] += 1
        differ("joint", attribute(rest, "at"), joints[name][0])
        differ("axis", attribute(rest, "axis"), joints[name][1])
    moved = run.stderr.count("it starts at")
    return (f"links {seen[0]} of {len(links)}, joints {seen[1]} of {len(joints)}, "
            + ", ".join(f"{key} {value:.1e}" for key, value in worst.items())
            + (f"; {moved} joints start elsewhere" if moved else ""))


if __name__ == "__main__":
    for given in sys.argv[1:]:
        print(f"{os.path.relpath(given)}: {compare(given)}")
