"""Times the portal in one program: `measure.py portal_opensees|portal_pynite ELEMENTS...` prints JSON, or ends with 3 where the program is not there.

A time is that of the process for one model and its ten frequencies, the least of some rounds, after imports.
"""

import ctypes
import datetime
import importlib
import importlib.metadata
import importlib.util
import json
import os
import platform
import sys
import time

# one thread, as the others have
os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")

PACKAGES = {"portal_opensees": ("OpenSeesPy", "openseespy"), "portal_pynite": ("PyNite", "PyNiteFEA")}


def find_libraries():
    """Loads the libraries that OpenSeesPy's package for Linux brings along, where the loader does not look for them."""
    package = importlib.util.find_spec("openseespylinux")
    if package is None:
        return
    folder = os.path.join(package.submodule_search_locations[0], "lib")
    for name in ("libquadmath.so.0", "libgfortran.so.4", "libgomp.so.1", "libblas.so.3", "liblapack.so.3"):
        path = os.path.join(folder, name)
        if os.path.exists(path):
            ctypes.CDLL(path, mode=ctypes.RTLD_GLOBAL)


def measured(program, elements):
    best, begin = float("inf"), time.process_time()
    rounds = 0
    while rounds < 5 or (rounds < 100 and time.process_time() - begin < 2.0):
        start = time.process_time()
        hertz = program.hertz(elements)
        best = min(best, time.process_time() - start)
        rounds += 1
    return {"elements": elements, "seconds": best, "hertz": hertz}


def main(name, *meshes):
    shown, package = PACKAGES[name]
    try:
        if name == "portal_opensees":
            find_libraries()
        program = importlib.import_module(name)
        version = importlib.metadata.version(package)
    except Exception as error:  # OpenSeesPy raises what it likes where a library is missing
        print(f"{shown} is not there ({error}): pip install {package}", file=sys.stderr)
        sys.exit(3)
    runs = [measured(program, int(elements)) for elements in meshes]
    today = datetime.date.today().isoformat()
    print(json.dumps({"program": shown, "version": version, "python": platform.python_version(), "date": today, "runs": runs}))


main(*sys.argv[1:])
