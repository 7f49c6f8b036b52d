#!/usr/bin/python3 -I
"""Pictures of a finished or running heap.

    heap_figures.py RUN_DIR        heap.png, profile.png, energy.png in RUN_DIR/figures

Reads clumps.xdmf, stones.csv, profile.csv, history.csv and summary.json. A figure whose input is absent is
left out with a sentence that says so. Ends with 2 when the folder holds no history at all.
"""

import argparse
import csv
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import figures  # before Matplotlib, which it sets up
import matplotlib.pyplot as plt
import numpy as np

STONE, ELONGATED = "#9a8f80", "#D55E00"


def read_table(path):
    """Columns of a CSV file as name -> list of texts, names without unit; None where there is no file."""
    if not os.path.isfile(path):
        return None
    with open(path, newline="", encoding="utf-8") as file:
        rows = [row for row in csv.reader(file) if row]
    names = [name.split("[")[0].strip() for name in rows[0]]
    return {name: [row[i] for row in rows[1:]] for i, name in enumerate(names)}


class Stones:
    """Member spheres of the last frame, and which of them belong to elongated stones."""

    def __init__(self, run):
        import field_figures  # h5py is needed for this only

        clumps = field_figures.open_series(run, "clumps")
        if clumps is None:
            raise FileNotFoundError(f"{run} holds no clumps.xdmf with a frame")
        last = len(clumps) - 1
        self.centres = clumps.points(last)
        self.radii = clumps.attribute(last, "radius")
        table = read_table(os.path.join(run, "stones.csv"))
        long_ids = set() if table is None else {
            float(clump) for clump, mark in zip(table["clump"], table["elongated"]) if mark == "1"}
        self.elongated = np.isin(clumps.attribute(last, "clump"), list(long_ids))
        # A running case has no table yet: the spheres stand for their stones.
        xy = self.centres[:, :2] if table is None else np.array(
            [table["x"], table["y"]], dtype=float).T
        self.middle = np.median(xy, axis=0)
        self.distance = np.linalg.norm(xy - self.middle, axis=1)

    def reach(self, share):
        """The distance from the middle that holds this share of the stones [m]."""
        return np.quantile(self.distance, share) + self.radii.max()


def paint(stones, view, extent, pixel):
    """Picture of the spheres as balls in daylight, the nearest in front. `view` is "plan" or "side" (along
    y); `extent` (left, right, bottom, top) and `pixel` in m. Returns rows from the top, RGB."""
    across, up, towards = {"plan": (0, 1, 2), "side": (0, 2, 1)}[view]
    sign = 1 if view == "plan" else -1  # nearer means higher, or smaller y
    nx, ny = (max(1, int(round((extent[i + 1] - extent[i]) / pixel))) for i in (0, 2))
    depth = np.full((ny, nx), -np.inf)
    image = np.ones((ny, nx, 3))
    light = np.array([-0.45, 0.5, 0.74])
    colours = np.array([plt.matplotlib.colors.to_rgb(colour) for colour in (STONE, ELONGATED)])
    u, v = stones.centres[:, across] - extent[0], stones.centres[:, up] - extent[2]
    w, kind = sign * stones.centres[:, towards], stones.elongated.astype(int)
    for ui, vi, wi, r, k in zip(u, v, w, stones.radii, kind):
        i0, i1 = max(0, int((ui - r) / pixel)), min(nx, int((ui + r) / pixel) + 1)
        j0, j1 = max(0, int((vi - r) / pixel)), min(ny, int((vi + r) / pixel) + 1)
        if i0 >= i1 or j0 >= j1:
            continue
        a = ((np.arange(i0, i1) + 0.5) * pixel - ui) / r
        b = ((np.arange(j0, j1) + 0.5) * pixel - vi)[:, None] / r
        rest = 1 - a * a - b * b
        out = np.sqrt(np.maximum(rest, 0))
        front = (rest > 0) & (wi + r * out > depth[j0:j1, i0:i1])
        shade = 0.42 + 0.58 * np.clip(light[0] * a + light[1] * b + light[2] * out, 0, 1)
        depth[j0:j1, i0:i1][front] = (wi + r * out)[front]
        image[j0:j1, i0:i1][front] = (shade[..., None] * colours[k])[front]
    return image[::-1]


def draw_view(axes, stones, view, reach, height, pixel=1.5e-3):
    """One view, `reach` [m] to either side of the middle and, from the side, `height` [m] high."""
    x, y = stones.middle
    extent = ((x - reach, x + reach, y - reach, y + reach) if view == "plan"
              else (x - reach, x + reach, 0.0, height))
    axes.imshow(paint(stones, view, extent, pixel), extent=[1e3 * (e - o) for e, o in zip(
        extent, (x, x, y, y) if view == "plan" else (x, x, 0, 0))], interpolation="antialiased")
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("y [mm]" if view == "plan" else "z [mm]")


def heap_figure(run, path):
    stones = Stones(run)
    reach = stones.reach(0.98)
    top = 1.1 * (stones.centres[:, 2] + stones.radii).max()
    figure, (plan, side) = plt.subplots(2, 1, figsize=(7, 7 * (1 + top / (2 * reach)) + 1.2),
                                        height_ratios=[2 * reach, top], layout="constrained")
    draw_view(plan, stones, "plan", reach, top)
    draw_view(side, stones, "side", reach, top)
    outside = int(np.sum(stones.distance > reach))
    title = "plan and side view; elongated stones in orange"
    plan.set_title(title + (f"; stones farther out: {outside}" if outside else ""), fontsize=10)
    figures.save(figure, path)


def profile_figure(run, path):
    table, summary = read_table(os.path.join(run, "profile.csv")), figures.read_summary(run)
    if table is None or not summary:
        print(f"Left out {path}: {run} holds no profile.csv and summary.json, so the heap is not at rest yet.")
        return
    sector = np.array(table["sector"])
    radius, height = (1e3 * np.array(table[name], dtype=float) for name in ("radius", "height"))
    figure, axes = plt.subplots(figsize=(7.5, 4.2), layout="constrained")
    for name in dict.fromkeys(sector):
        mine = sector == name
        whole = name == "all"
        axes.plot(radius[mine], height[mine], color=figures.COLOURS[0] if whole else "0.7",
                  linewidth=2.2 if whole else 0.8, zorder=2 if whole else 1,
                  label="all azimuths" if whole else ("one of 8 sectors" if name == "0" else None))
    angle, top = (figures.find_result(summary, name) for name in ("angle_of_repose_deg", "height"))
    if figures.find_result(summary, "azimuths_with_an_angle"):
        slope, top = np.tan(np.radians(angle)), 1e3 * top
        mine = sector == "all"
        middle = np.interp(0.5 * top, height[mine][::-1], radius[mine][::-1])
        ends = middle + np.array([-0.3, 0.3]) * top / slope
        scatter = figures.find_result(summary, "angle_of_repose_scatter_over_azimuths")
        axes.plot(ends, 0.5 * top - slope * (ends - middle), color=figures.COLOURS[1], linewidth=2,
                  linestyle="--", zorder=3,
                  label=f"mean of the fits from 20 to 80 % of the height: {angle:.1f} ± {scatter:.1f} degrees")
    axes.set_xlabel("distance from the centroid in plan [mm]")
    axes.set_ylabel("mean height of the surface [mm]")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    axes.grid(color="0.92")
    axes.legend(frameon=False, fontsize=8)
    figures.save(figure, path)


def main():
    parser = argparse.ArgumentParser(description="Pictures of a finished or running heap.")
    parser.add_argument("run", metavar="RUN_DIR", help="output folder of interlock run")
    run = parser.parse_args().run
    folder = os.path.join(run, "figures")
    try:
        figures.read_history(run)
        figures.energy_figure(run, os.path.join(folder, "energy.png"))
        profile_figure(run, os.path.join(folder, "profile.png"))
        heap = os.path.join(folder, "heap.png")
        try:
            heap_figure(run, heap)
        except (OSError, KeyError) as error:
            # The files of a running case may be absent or in the middle of being written.
            print(f"Left out {heap}: the fields cannot be read ({error}).")
    except figures.InputError as error:
        print(error, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
