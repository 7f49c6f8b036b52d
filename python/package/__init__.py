"""Interlock from Python: stones, clumps, cases, their runs and results.

    import interlock
    stones = interlock.stones(12, seed=1)                        # closed angular surfaces [m]
    clump = interlock.clump(stones[0], order="gain", max_spheres=40)
    case = interlock.Case("cases/pullout/quick.prm", **{"Geogrid/Rigid": True})
    results = case.run("results/rigid", callback=lambda moment: print(moment.time))
    results.history["pull_force [N]"]

SI units throughout. What is wrong with an input raises InputError with the sentence that the program prints.
docs/python.md and python/tutorial.py show more. The extension with the simulation is loaded by the first call that
needs it; results are read without it.
"""

import importlib

_homes = {
    "InputError": "errors", "RunFailure": "errors", "Interrupted": "errors",
    "Stone": "stones_and_clumps", "Clump": "stones_and_clumps", "stones": "stones_and_clumps",
    "clump": "stones_and_clumps",
    "Case": "case", "Results": "results", "Study": "study", "program": "program",
}
__all__ = list(_homes)


def __getattr__(name):
    if name == "__version__":
        return importlib.import_module("interlock._native").version
    if name not in _homes:
        raise AttributeError(f"module 'interlock' has no attribute '{name}'")
    value = getattr(importlib.import_module("interlock." + _homes[name]), name)
    globals()[name] = value  # a module of the same name must not stand before it
    return value


def __dir__():
    return sorted(set(globals()) | set(__all__))
