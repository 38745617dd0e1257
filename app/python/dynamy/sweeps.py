"""Many runs of one model file, in processes of their own."""

import gc
import itertools
import multiprocessing
import os
from concurrent.futures import ProcessPoolExecutor
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Union

from . import _core
from .runs import Run, run

_File = Union[str, "os.PathLike[str]"]
_Values = Optional[Callable[[Run], Any]]


def _one(file: _File, parameters: Dict[str, Any], values: _Values) -> Any:
    done = run(_core.load(os.fspath(file), **parameters))
    done.parameters = parameters
    return done if values is None else values(done)


_job: Any = None  # what the processes of a pool work on: file and values


def _begin(file: _File, values: _Values) -> None:
    global _job
    _job = file, values
    gc.freeze()  # what the parent holds is the parent's to destroy


def _work(parameters: Dict[str, Any]) -> Any:
    return _one(_job[0], parameters, _job[1])


def sweep(file: _File, parameters: Mapping[str, Iterable[Any]], processes: Optional[int] = None,
          values: _Values = None) -> List[Any]:
    """Runs a model file with each combination of the values of its parameters.

    Returns the runs in the order of `itertools.product`, each with its `parameters`; with
    values=f, f(run) in place of each run, computed in the process of the run, so that only its
    result is sent. processes: how many at once; 1: none but this; default: one a processor.
    """
    for name, these in parameters.items():
        if isinstance(these, str) or not hasattr(these, "__iter__"):
            raise TypeError(f"{name}: a list of values is needed, not {these!r}")
    names = list(parameters)
    points = [dict(zip(names, point)) for point in itertools.product(*parameters.values())]
    if processes is None:
        processes = len(os.sched_getaffinity(0))
    if processes < 1:
        raise ValueError(f"processes must be 1 or more, is {processes}")
    if processes == 1 or len(points) < 2:
        return [_one(file, point, values) for point in points]
    # Forked processes know the laws and plug-ins of this one, and `values` need not be importable.
    context = multiprocessing.get_context("fork")
    with ProcessPoolExecutor(min(processes, len(points)), context, _begin, (file, values)) as pool:
        return list(pool.map(_work, points))
