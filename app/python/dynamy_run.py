"""Reads the folder of a run of dynamY. Needs numpy alone; copy this file wherever it is wanted.

    import dynamy_run
    run = dynamy_run.Run("runs/woodpecker")
    run.t, run["toy.phiM"]                 # recorded signals, one array each
    run.units["toy.phiM"]                  # "rad"
    run.facts["energy"]                    # run.json
    for e in run.events: print(e["t"], e["event"], e["contact"])
    run.ledger["friction"]                 # energies and works
    run.frames.r("ball")                   # positions of a frame, n x 3
    run.plot("toy.phiM", "toy.phiS")       # needs matplotlib
    run.frame()                            # the signals in a DataFrame of pandas

A long run keeps its signals in signals.h5 (<record format="hdf5">): that needs h5py.

doc/run_folder.md says every byte. What was written before a run was killed is read; what a cut file
lost is left out. A wrong file raises RunError with its path.
"""

import csv
import html
import importlib
import io
import json
import struct
import sys
import zlib
from pathlib import Path

import numpy as np

_EVENT = ("t", "event", "contact", "from", "to", "speed", "impulse")
STATES = ("open", "stick", "slip", "impact", "spin")


class RunError(Exception):
    """A file is missing, is not what its name says, or has another version."""


class Run:
    """The folder of one run. Files are read when they are asked for."""

    def __init__(self, folder):
        self.folder = Path(folder)
        if not (self.folder / "run.json").is_file():
            raise RunError(f"{self.folder}: no run.json, not the folder of a run")
        self._read = {}
        self._open()

    def _open(self):
        self.facts = json.loads(self._data("run.json").decode("utf-8"))
        if self.facts.get("format") != "dynamy-run" or self.facts.get("version") != 1:
            raise RunError(f"{self.folder}/run.json: not a dynamy-run of version 1")
        self.units = {s["name"]: s.get("unit", "") for s in self.facts.get("signals", [])}

    def _data(self, name):
        """The bytes of one file of the run."""
        if not (self.folder / name).is_file():
            raise RunError(f"{self.folder / name}: no such file")
        return (self.folder / name).read_bytes()

    def _has(self, name):
        return (self.folder / name).is_file()

    def _once(self, name, read):
        if name not in self._read:
            self._read[name] = read(self._data(name), f"{self.folder}/{name}")
        return self._read[name]

    @property
    def warnings(self):
        """What the figures of the run say against it: dicts with kind, text, count, t, place."""
        return self.facts.get("warnings", [])

    @property
    def notes(self):
        """What the run resolved in a model that contradicts itself: dicts as in warnings."""
        return self.facts.get("notes", [])

    @property
    def qualified(self):
        """True if a warning says that the run is not what its model asks for: exit status 3."""
        return any(w.get("qualifies") for w in self.warnings)

    @property
    def signals(self):
        """name -> values; "t" is the time [s]."""
        if self._has("signals.csv") or not self._has("signals.h5"):
            return self._once("signals.csv", _table)
        return self._once("signals.h5", _packed)

    @property
    def t(self):
        """Times of the signals [s]."""
        return self.signals["t"]

    def __getitem__(self, name):
        if name not in self.signals:
            raise KeyError(f'no signal "{name}" was recorded; there are {", ".join(self.signals)}')
        return self.signals[name]

    def __contains__(self, name):
        return name in self.signals

    @property
    def events(self):
        """Impacts and switches, a list of dicts with t, event, contact, from, to, speed, impulse."""
        return self._once("events.csv", _events)

    @property
    def ledger(self):
        """Energies, works and figures of the solver: name -> values, with "t"."""
        return self._once("ledger.csv", _table)

    @property
    def frames(self):
        """Poses of all frames and the drawn contacts: Frames."""
        return self._once("frames.bin", Frames)

    def frame(self, of="signals", unique=False):
        """`signals`, `ledger` or `events` as a DataFrame of pandas; the index is the time [s].

        At an impact there are two rows, before and after it; unique=True keeps the latter, for
        `reindex`, `join` and `asof`.
        """
        if of not in ("signals", "ledger", "events"):
            raise ValueError(f'there is no table "{of}", but signals, ledger, events')
        pandas = _package("pandas", "tables")
        table = pandas.DataFrame(getattr(self, of), columns=_EVENT if of == "events" else None)
        if of == "signals":
            table.attrs["units"] = dict(self.units)
        table = table.set_index("t")
        return table[~table.index.duplicated(keep="last")] if unique else table

    def plot(self, *names, axes=None, label=None):
        """Signals over time, one curve each; returns the axes. Needs matplotlib.

        `axes`: those of an earlier plot, to lay runs over each other; `label` stands before the
        names of this run's curves."""
        if axes is None:
            axes = _package("matplotlib.pyplot", "plots").subplots()[1]
        for name in names or [n for n in self.signals if n != "t"]:
            unit = self.units.get(name, "")
            text = f"{name} [{unit}]" if unit else name
            axes.plot(self.t, self[name], label=f"{label}: {text}" if label else text)
        axes.set_xlabel("t [s]")
        axes.legend()
        return axes

    def page(self):
        """The replay as one page of HTML."""
        return self._data("replay.html").decode("utf-8")

    def _repr_html_(self):
        """What a notebook shows: the replay, in a frame of its own that reaches nothing outside."""
        try:
            page = self.page()
        except RunError as error:
            return f"<p>{html.escape(str(error))}</p>"
        return (f'<iframe srcdoc="{html.escape(page)}" sandbox="allow-scripts allow-downloads" '
                'style="width: 100%; height: 640px; border: 0"></iframe>')

    def __repr__(self):
        title, state = self.facts.get("title") or "run", self.facts.get("state", "?")
        return f"<dynamY run: {title}, {state} at t = {self.facts.get('t', 0.0):g} s>"


def _packed(data, path):
    """The table in a signals.h5."""
    h5py = _package("h5py", "signals in HDF5")
    try:
        with h5py.File(io.BytesIO(data), "r") as file:
            if file.attrs.get("format") not in ("dynamy-signals", b"dynamy-signals"):
                raise RunError(f"{path}: holds no signals of dynamY")
            names = [name.decode("utf-8") for name in file["names"][:]]
            columns = {"t": file["t"][:]}
            columns.update((name, file["signals/" + name][:]) for name in names)
            return columns
    except (KeyError, OSError) as error:
        raise RunError(f"{path}: is damaged: {error}") from error


class Frames:
    """frames.bin: poses of all frames and the drawn contacts at n instants.

    t         n times [s]
    names     of the P frames
    pose      n x P x 7: x y z of r_OS_I [m], unit quaternion w x y z of A_IK;
              0 0 0 0: the body is absent
    contacts  n arrays C x 11: point [m], normal, force [N], state (index into STATES), limit [N]
    step      n steps [s] of these forces: force times step is the percussion of an impact [N s];
              0: unknown
    scene     shapes and frames, a dict
    """

    def __init__(self, data, path):
        if len(data) < 24 or data[:8] != b"DYNFRAME":
            raise RunError(f"{path}: not a frames file")
        version, order, poses, size = struct.unpack_from("<4I", data, 8)
        if version not in (2, 3) or order != 0x01020304:
            raise RunError(f"{path}: version {version}, this reader knows 2 and 3")
        head = 24 + size
        if len(data) < head + 4 or zlib.crc32(data[:head]) != _u32(data, head):
            raise RunError(f"{path}: its head is damaged")
        self.scene = json.loads(data[24:head].decode("utf-8"))
        self.names = [f["name"] for f in self.scene["frames"]]
        t, step, pose, self.contacts = [], [], [], []
        for payload in _chunks(data, head + 4):
            at = 0
            while at < len(payload):
                time, contacts, dt = struct.unpack_from("<dIf", payload, at)
                t.append(time)
                step.append(dt)
                at += 16
                pose.append(np.frombuffer(payload, "<f4", 7 * poses, at).reshape(poses, 7))
                at += 28 * poses
                self.contacts.append(
                    np.frombuffer(payload, "<f4", 11 * contacts, at).reshape(contacts, 11))
                at += 44 * contacts
        self.t = np.array(t)
        self.step = np.array(step)
        self.pose = np.array(pose, dtype=float).reshape(len(t), poses, 7)

    def _index(self, name):
        if name not in self.names:
            raise KeyError(f'no frame "{name}"; there are {", ".join(self.names)}')
        return self.names.index(name)

    def r(self, name):
        """Positions r_OS_I of the frame, n x 3 [m]."""
        return self.pose[:, self._index(name), :3]

    def A(self, name):
        """Rotations A_IK of the frame, n x 3 x 3: components in I = A_IK @ components in K."""
        w, x, y, z = self.pose[:, self._index(name), 3:].T
        return np.array([
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]).transpose(2, 0, 1)


def _package(name, what):
    try:
        return importlib.import_module(name)
    except ImportError as error:
        package = name.partition(".")[0]
        raise ImportError(f"{what} need the package {package}, which is not installed: "
                          f"apt install python3-{package}, or pip install {package}") from error


def _u32(data, at):
    return struct.unpack_from("<I", data, at)[0]


def _chunks(data, at):
    """Payloads of whole chunks, up to the first that is cut off or damaged."""
    while at + 40 <= len(data) and data[at:at + 4] == b"CHNK":
        length = struct.unpack_from("<Q", data, at + 8)[0]
        end = at + 40 + length
        if end > len(data):
            return
        if zlib.crc32(data[at + 40:end], zlib.crc32(data[at:at + 32])) != _u32(data, at + 32):
            return
        yield data[at + 40:end]
        at = end


def _lines(data):
    """Whole lines: a last one without its end was cut off."""
    return data[:data.rfind(b"\n") + 1].decode("utf-8")


def _table(data, path):
    """Columns of numbers under their names."""
    head, _, rows = _lines(data).partition("\n")
    names = next(csv.reader([head]), [])
    if not names or names[0] != "t":
        raise RunError(f'{path}: the first column is not "t"')
    if not rows:
        return {name: np.empty(0) for name in names}
    values = np.loadtxt(io.StringIO(rows), delimiter=",", ndmin=2)
    if values.shape[1] != len(names):
        raise RunError(f"{path}: {len(names)} names over {values.shape[1]} columns")
    return dict(zip(names, values.T))


def _events(data, _):
    rows = list(csv.DictReader(io.StringIO(_lines(data))))
    for row in rows:
        for name in ("t", "speed", "impulse"):
            row[name] = float(row[name]) if row[name] else 0.0
    return rows


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python3 dynamy_run.py DIR")
    try:
        run = Run(sys.argv[1])
        print(f"{run.folder}: {run.facts.get('state')}, {len(run.t)} rows, "
              f"{len(run.frames.t)} pictures, {len(run.events)} events")
        for warning in run.warnings:
            print(f"  WARNING {warning['kind']}: {warning['text']}")
        for note in run.notes:
            print(f"  note {note['kind']}: {note['text']}")
        for name, values in run.signals.items():
            if len(values):
                print(f"  {name} [{run.units.get(name, 's')}]: {values.min():g} … {values.max():g}")
    except RunError as error:
        sys.exit(str(error))
