"""Makes a wheel of dynamY: the interface of PEP 517 between pip and the build by CMake.

    python3 -m pip wheel --no-deps --no-build-isolation app/python
    python3 -m pip wheel --no-deps --no-build-isolation \\
      --config-settings build-dir=build/release app/python

The first builds the preset `release` with the module, the second takes a folder as it was built.
The wheel holds the package `dynamy`, in it an installation in small: bin, lib, share; the libraries
find each other relative to their own places. What they need of the system (cmake/packages.txt) is
not in it. Rejected: scikit-build-core, which the distribution does not have.
"""

import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path

_ROOT = Path(__file__).resolve().parents[2]
_PACKAGES = "lib/python3/dist-packages"


def _version():
    text = (_ROOT / "framework/dynamy/core/version.hpp").read_text(encoding="utf-8")
    return ".".join(re.search(rf"kVersion{part} = (\d+)", text)[1]
                    for part in ("Major", "Minor", "Patch"))


def _metadata():
    """Name -> text of the files of dist-info, without RECORD."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return {
        "METADATA": "Metadata-Version: 2.1\nName: dynamy\n"
                    f"Version: {_version()}\n"
                    "Summary: Simulation of multibody systems with impacts and friction\n"
                    f"Requires-Python: >={sys.version_info.major}.{sys.version_info.minor}\n"
                    "Requires-Dist: numpy\nProvides-Extra: pandas\nProvides-Extra: plots\n"
                    'Requires-Dist: pandas; extra == "pandas"\n'
                    'Requires-Dist: matplotlib; extra == "plots"\n',
        "WHEEL": "Wheel-Version: 1.0\nGenerator: dynamy\nRoot-Is-Purelib: false\n"
                 f"Tag: {python}-{python}-{platform}\n",
        "entry_points.txt": "[console_scripts]\ndynamy = dynamy.program:main\n",
        "LICENSE": (_ROOT / "LICENSE").read_text(encoding="utf-8"),
    }


def _info():
    return f"dynamy-{_version()}.dist-info"


def _run(*command):
    """Runs a command of the build; what it prints is shown by `pip -v`, or if it fails."""
    done = subprocess.run([str(word) for word in command], cwd=_ROOT, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    print(done.stdout)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit status {done.returncode}")


def _built(settings):
    """The build folder; builds it unless it is given."""
    given = (settings or {}).get("build-dir")
    if given:
        build = Path(os.environ.get("PWD", "."), given)
        if not (build / "CMakeCache.txt").is_file():
            sys.exit(f"build-dir: {build} is no build folder")
        return build
    _run("cmake", "--preset", "release", "-DDYNAMY_PYTHON=ON")
    _run("cmake", "--build", "--preset", "release", "--target", "dynamy", "plugins",
         "dynamy_python")
    return _ROOT / "build/release"


def _contents(stage):
    """Name in the wheel -> file of an installation."""
    out = {}
    for file in sorted(stage.rglob("*")):
        name = file.relative_to(stage).as_posix()
        if file.is_dir():
            continue
        if name.startswith(_PACKAGES + "/"):
            out[name[len(_PACKAGES) + 1:]] = file
        elif name.startswith(("bin/", "lib/", "share/dynamy/")):
            out["dynamy/" + name] = file
    return out


def _checked(contents, build):
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    if f"dynamy/_core{suffix}" not in contents:
        others = [name for name in contents if name.startswith("dynamy/_core.") and ".so" in name]
        sys.exit(f"{build} holds {others[0]}, for another Python than {sys.executable}: call the "
                 "python3 that it was built with (cmake -L: Python3_EXECUTABLE)" if others else
                 f"{build} holds no module: configure it with -DDYNAMY_PYTHON=ON and build it")
    return contents


def _write(wheel, contents):
    record = []

    def add(name, data, mode):
        entry = zipfile.ZipInfo(name)  # of 1980: equal builds make equal wheels
        entry.external_attr = (0o100000 | mode) << 16
        entry.compress_type = zipfile.ZIP_DEFLATED
        archive.writestr(entry, data)
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record.append(f"{name},sha256={digest},{len(data)}\n")

    with zipfile.ZipFile(wheel, "w") as archive:
        for name, file in contents.items():
            add(name, file.read_bytes(), 0o755 if os.access(file, os.X_OK) else 0o644)
        for name, text in _metadata().items():
            add(f"{_info()}/{name}", text.encode(), 0o644)
        record.append(f"{_info()}/RECORD,,\n")
        add(f"{_info()}/RECORD", "".join(record).encode(), 0o644)


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Writes the folder dist-info; nothing is built for it."""
    folder = Path(metadata_directory, _info())
    folder.mkdir()
    for name, text in _metadata().items():
        (folder / name).write_text(text, encoding="utf-8")
    return folder.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Builds, installs into a folder of its own, and packs what is there."""
    build = _built(config_settings)
    tag = re.search("Tag: (.*)", _metadata()["WHEEL"])[1]
    wheel = Path(wheel_directory, f"dynamy-{_version()}-{tag}.whl")
    with tempfile.TemporaryDirectory(prefix="dynamy") as stage:
        _run("cmake", "--install", build, "--component", "runtime", "--strip", "--prefix", stage)
        _write(wheel, _checked(_contents(Path(stage)), build))
    return wheel.name


def build_sdist(sdist_directory, config_settings=None):
    """There is no package of sources: a wheel is made in a clone."""
    sys.exit("dynamY has no package of sources: make a wheel in a clone")
