"""Runs of models, with what they recorded."""

import math
import os
import tempfile
from pathlib import Path
from typing import Any, Callable, Dict, Iterator, Mapping, Optional, Union

import dynamy_run

from . import _core

_KEPT = ("run.json", "model.xml", "signals.csv", "signals.h5", "events.csv", "ledger.csv", "frames.bin")


class Run(dynamy_run.Run):
    """A run: signals, events, energies, poses, and how it ended.

    `Run(folder)` reads the folder of an earlier run; `dynamy.run` and `Model.run` return the run in
    memory. `signals, figures = run` unpacks it, and run[0], run[1] are the same.
    """

    #: The values of parameters that `sweep` gave the model.
    parameters: Dict[str, Any]

    def __init__(self, folder: Union[str, "os.PathLike[str]"],
                 figures: Optional[Mapping[str, Any]] = None) -> None:
        self._kept: Dict[str, bytes] = {}
        self._figures = None if figures is None else dict(figures)
        self.parameters = {}
        super().__init__(folder)

    def keep(self) -> "Run":
        """Reads all files into memory: the folder may be removed, and the run be sent elsewhere."""
        for name in _KEPT:
            if name not in self._kept and (self.folder / name).is_file():
                self._kept[name] = (self.folder / name).read_bytes()
        return self

    def _has(self, name: str) -> bool:
        return name in self._kept or super()._has(name)

    def _data(self, name: str) -> bytes:
        return self._kept[name] if name in self._kept else super()._data(name)

    @property
    def figures(self) -> Dict[str, Any]:
        """How the run ended: state, reason, steps, impacts, checks_passed, warnings, …"""
        return self.facts if self._figures is None else self._figures

    @property
    def qualified(self) -> bool:
        """True if a warning says that the run is not what its model asks for."""
        return bool(self.figures.get("qualified", super().qualified))

    def __getitem__(self, name: Any) -> Any:
        return list(self)[name] if isinstance(name, int) else super().__getitem__(name)

    def __iter__(self) -> Iterator[Dict[str, Any]]:
        yield self.signals
        yield self.figures

    def save(self, folder: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the folder of the run (doc/run_folder.md), with its replay."""
        path = Path(folder)
        if path.is_dir() and any(path.iterdir()):
            raise FileExistsError(f"{path} is not empty")
        path.mkdir(parents=True, exist_ok=True)
        for name in _KEPT:
            try:
                data = self._data(name)
            except dynamy_run.RunError:
                continue  # of a run that was killed
            (path / name).write_bytes(data)
        _core._write_replay(str(path))

    def page(self) -> str:
        """The replay as one page of HTML."""
        if not self._kept and (self.folder / "replay.html").is_file():
            return super().page()
        with tempfile.TemporaryDirectory(prefix="dynamy") as folder:
            # The page has the name of its folder.
            own = Path(folder, str(self.facts.get("title") or "run").replace("/", " ")[:100])
            self.save(own)
            return (own / "replay.html").read_text(encoding="utf-8")


def run(model: _core.Model, each: Optional[Callable[[_core.Moment], Optional[bool]]] = None,
        out: Union[str, "os.PathLike[str]"] = "", every: float = 0.0, *,
        until: Optional[float] = None, step: Optional[float] = None,
        tolerance: Optional[float] = None) -> Run:
    """Runs a built model from its initial state.

    until, step and tolerance set those of the model, from now on.

    each(now) is called after every step with now.t, now.q, now.u, now["cart.x"],
    and now["motor"] = 3.0 for an <Input>; False ends the run. With every=T it is called at 0, T,
    2 T, … instead [s], where steps end then: the clock of a controller. With out=DIR the run is
    written there with its replay, else it is kept in memory.
    """
    if not isinstance(model, _core.Model):
        raise TypeError(f"run() needs a model, such as dynamy.load({model!r})"
                        if isinstance(model, (str, os.PathLike)) else
                        f"run() needs a model, not {model!r}")
    if each is not None and not callable(each):
        raise TypeError(f"each is a function of a moment, not {each!r}")
    if not 0.0 <= every < math.inf:
        raise ValueError(f"every is a time between two calls [s], not {every!r}")
    if every and each is None:
        raise TypeError("every is the time between two calls of each, which is not given")
    for name, value in (("until", until), ("step", step), ("tolerance", tolerance)):
        if value is not None:
            setattr(model, name, value)
    if os.fspath(out):
        return Run(out, _core._run_into(model, each, every, os.fspath(out), True))
    with tempfile.TemporaryDirectory(prefix="dynamy") as folder:
        return Run(folder, _core._run_into(model, each, every, folder, False)).keep()


setattr(_core.Model, "run", run)
