"""From stones of your own to a pull-out curve, in some ten seconds: run it as a script, or cell by cell.

    export PYTHONPATH=build/release/python
    /usr/bin/python3 python/tutorial.py [FOLDER]
"""

# %% What is written goes into one folder.
import pathlib
import sys

import numpy as np

import interlock

folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "results/python_tutorial")
cases = pathlib.Path(__file__).resolve().parent.parent / "cases"

# %% Six stones. Scans of your own are as good: interlock.clump("scan.stl", unit="mm", ...).
stones = interlock.stones(6, seed=7, faces=8)
for stone in stones:
    print(f"{1e3 * stone.longest:.0f} x {1e3 * stone.intermediate:.0f} x {1e3 * stone.shortest:.0f} mm, "
          f"angularity {stone.angularity:.0f} degrees")

# %% A clump of 30 spheres for each, the sphere that adds most to the shape first.
(folder / "clumps").mkdir(parents=True, exist_ok=True)
clumps = [interlock.clump(stone, order="gain", max_spheres=30, bulge=1e-3, name=f"stone_{i}")
          for i, stone in enumerate(stones)]
for clump in clumps:
    print(f"{clump.name}: {len(clump.spheres)} spheres, {1e3 * clump.mass:.0f} g, "
          f"volume off by {100 * clump.report['volume_error']:+.1f} %")
    clump.save(folder / "clumps" / f"{clump.name}.clump.json")

# %% A small case: that of the quick pull-out, in a box for some seventy stones and pulled over 4 mm.
case = interlock.Case(cases / "pullout/quick.prm", {
    "Stones/Folder": folder / "clumps",
    "Box/Length": 0.16, "Box/Width": 0.14, "Box/Height": 0.12,
    "Contact/Stone stiffness": 1e7, "Contact/Box stiffness": 1e7,
    "Geogrid/Apertures along": 2, "Geogrid/Apertures across": 2, "Geogrid/Placement": "not flattened",
    "Filling/Stone friction": -1, "Filling/Lower bulk density": 0, "Filling/Upper bulk density": 0,
    "Pull/Speed": 0.2, "Pull/Distance": 0.004, "Pull/Ramp time": 0.002,
    "Output/Field frames": 8, "Output/Report": False,
})
print(case.describe("Pull/Speed"))
print(f"stone friction {case['Contact/Stone friction']}, forecast "
      f"{sum(stage['processor_time'] for stage in case.forecast()['stages']):.0f} s")

# %% The run, watched: the arrays of a moment are the simulation's own, so only numbers are kept.
times, heights, speeds = [], [], []


def watch(moment):
    times.append(moment.time)
    heights.append(moment.positions[:, 2].max() if len(moment) else 0)
    speeds.append(np.sqrt((moment.velocities**2).sum(axis=1).mean()) if len(moment) else 0)
    return "stop" if moment.time > 10 else None  # a filling that never comes to rest


results = case.run(folder / "run", callback=watch, every=500, force=True)

# %% Results.
history = results.history
print(f"{results.summary['clumps']} stones, {results.summary['steps']} steps, state {results.state_hash}")
print(f"highest pull force {history['pull_force [N]'].max():.0f} N")
first, last = results.frames[0], results.frames[-1]
both, of_first, of_last = np.intersect1d(first.ids, last.ids, return_indices=True)
ways = np.linalg.norm(last.positions[of_last] - first.positions[of_first], axis=1)
print(f"{len(both)} stones moved by {1e3 * ways.mean():.2f} mm on average while the geogrid was pulled")

# %% A figure.
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.5), layout="constrained")
left.plot(1e3 * history["displacement [m]"], history["pull_force [N]"])
left.set(xlabel="displacement [mm]", ylabel="pull force [N]")
right.plot(times, speeds)
right.set(xlabel="time [s]", ylabel="r.m.s. speed of stones [m/s]")
right.set_yscale("symlog", linthresh=1e-3)
figure.savefig(folder / "tutorial.png", dpi=120)
print(f"Wrote {folder / 'tutorial.png'}.")
