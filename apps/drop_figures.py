#!/usr/bin/python3 -I
"""The contact forces before, during and after the largest drop of the force of a pull-out test.

    drop_figures.py RUN_DIR

Reads what `interlock drop RUN_DIR` has left (apps/drop/): RUN_DIR/drop/drop.json, the frames in RUN_DIR/drop, and
RUN_DIR/history.csv and used.prm. Writes RUN_DIR/figures/force_drop.png and prints a table of its numbers. Ends with 2
when there is nothing to draw.
"""

import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import plain_matplotlib  # before Matplotlib
import figures
import matplotlib.pyplot as plt
import numpy as np
from field_series import open_series
from matplotlib.collections import LineCollection
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.lines import Line2D
from run_files import InputError, during_pull, number, read_history, read_parameters, read_summary, unusable_part

MOMENTS = ["before", "during", "after"]
WIDEST, NARROWEST = 7.0, 0.25  # lines of the largest force of the three moments, and of the smallest ones [points]
# Light to dark, so that it needs no colours to be read; white itself would not be seen.
FORCES = LinearSegmentedColormap.from_list("forces", plt.get_cmap("YlGnBu")(np.linspace(0.35, 1.0, 256)))
GEOGRID, BOX = "#D55E00", "0.35"
STONES, WALL, RIB = 0, 1, 2  # kinds of contacts (coupling/output/field_frames.h)


def line_of(force, largest):
    """Width and colour of a force: the width in proportion to it, the colour by its root, which tells small ones apart."""
    share = np.asarray(force) / largest
    return {"linewidths": np.maximum(NARROWEST, WIDEST * share), "colors": FORCES(np.sqrt(share))}


class Network:
    """The contact forces of one frame, one for each pair of bodies.

    A stone of several spheres may touch another body in several places, whose forces are added as vectors. A force
    acts between the centre of the stone and that of the other stone, or the mean of the places on the wall or rib."""

    def __init__(self, contacts, frame):
        lines, points = contacts.lines(frame), contacts.points(frame)
        body = contacts.attribute(frame, "body")
        on_body = contacts.attribute(frame, "force_on_body")
        kind = contacts.attribute(frame, "kind").astype(int)
        first, second = lines[:, 0], lines[:, 1]
        # Two stones in ascending order; of others the stone is the first one.
        swap = (kind == STONES) & (body[first] > body[second])
        first, second = np.where(swap, second, first), np.where(swap, first, second)
        pairs = np.column_stack([kind, body[first].astype(int), body[second].astype(int)])
        unique, pair = np.unique(pairs, axis=0, return_inverse=True)
        pair = pair.reshape(-1)
        self.kind = unique[:, 0]
        count = np.bincount(pair)
        mean = lambda values: np.column_stack([np.bincount(pair, values[:, i]) / count for i in range(3)])
        self.ends = 1e3 * np.stack([mean(points[first]), mean(points[second])], axis=1)  # [mm]
        self.on_second = mean(on_body[second]) * count[:, None]  # [N]
        self.size = np.linalg.norm(self.on_second, axis=1)

    def on_front(self):
        """Push of the stones on the front wall against the pull, in its direction [N]."""
        at_front = (self.kind == WALL) & (np.abs(self.ends[:, 1, 0]) < 1)
        return -self.on_second[at_front, 0].sum()

    def on_ribs(self):
        """What the stones hold the geogrid with [N]."""
        return self.on_second[self.kind == RIB, 0].sum()


def read_drop(run):
    """drop.json as a dictionary; raises InputError where there is none."""
    path = os.path.join(run, "drop", "drop.json")
    if not os.path.isfile(path):
        raise InputError(f"{path} is not there: \"interlock drop {run}\" makes it.")
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def box_of(run):
    """Length, width, height of the box, heights of the slot's lower and upper edge [mm]."""
    parameters = read_parameters(run)
    length, width, height, slot = (1e3 * number(parameters, "Box/" + name)
                                   for name in ("Length", "Width", "Height", "Slot height"))
    return length, width, height, 0.5 * (height - slot), 0.5 * (height + slot)


def draw_box(axes, box, across):
    """From the side, or from the front, where the slot is as wide as the box."""
    length, width, height, below, above = box
    wide = width if across else length
    style = {"color": BOX, "linewidth": 1.2, "zorder": 0}
    if across:
        axes.plot([0, wide, wide, 0, 0], [0, 0, height, height, 0], **style)
        for edge in (below, above):
            axes.plot([0, wide], [edge, edge], linestyle=":", **style)
    else:
        axes.plot([0, 0, wide, wide], [below, 0, 0, height], **style)
        axes.plot([0, 0], [above, height], **style)


def draw_network(axes, network, largest, across):
    """The strongest on top. `across`: seen from the front, else from the side."""
    order = np.argsort(network.size)
    plane = [1, 2] if across else [0, 2]
    axes.add_collection(LineCollection(network.ends[order][:, :, plane], capstyle="round", zorder=2,
                                       **line_of(network.size[order], largest)))


def draw_geogrid(axes, geogrid, time, across):
    frame = geogrid.frame_at(time)
    ends = 1e3 * geogrid.points(frame)[:, [1, 2] if across else [0, 2]]
    axes.add_collection(LineCollection(ends[geogrid.lines(frame)], colors=GEOGRID, linewidths=1.2, zorder=1))


def draw_curve(axes, history, drop, zoomed):
    pull = during_pull(history)
    axes.plot(1e3 * pull["displacement"], pull["pull_force"], color="0.3", linewidth=1.0)
    for name, marker, shift in zip(MOMENTS, "o^s", ((-6, 6), (7, 0), (6, 6))):
        moment = drop[name]
        place = (1e3 * moment["displacement_m"], moment["force_N"])
        axes.plot(*place, marker, color="#0072B2", markersize=6)
        if zoomed:
            axes.annotate(name, place, xytext=shift, textcoords="offset points", fontsize=9,
                          ha="right" if shift[0] < 0 else "left")
    if zoomed:
        begin, end = 1e3 * drop["before"]["displacement_m"], 1e3 * drop["after"]["displacement_m"]
        margin = max(0.5, 0.6 * (end - begin))
        axes.set_xlim(max(0, begin - margin), end + margin)
        place = 1e3 * pull["displacement"]
        shown = pull["pull_force"][(place >= begin - margin) & (place <= end + margin)]
        room = 0.12 * np.ptp(shown)
        axes.set_ylim(shown.min() - room, shown.max() + room)
    else:
        axes.set_xlim(left=0)
    axes.set_xlabel("displacement of the pulled edge [mm]")
    axes.set_ylabel("pull-out force [N]")
    axes.grid(color="0.92")
    axes.set_axisbelow(True)


def round_forces(largest):
    """Four forces for the legend, the first digit a 1, 2 or 5."""
    steps = [digit * 10.0**power for power in range(-4, 7) for digit in (1, 2, 5)]
    return [step for step in steps if step <= largest][-4:]


def draw_legend(axes, largest):
    axes.axis("off")
    lines = []
    for force in round_forces(largest):
        style = line_of(force, largest)
        lines.append(Line2D([], [], color=style["colors"], linewidth=style["linewidths"], label=f"{force:g} N"))
    lines += [Line2D([], [], color=GEOGRID, linewidth=1.2, label="geogrid"),
              Line2D([], [], color=BOX, linewidth=1.2, label="box (dotted: its slot)")]
    axes.legend(handles=lines, loc="center left", frameon=False, fontsize=9, ncol=2, labelspacing=1.0,
                title=f"force between two bodies; width in proportion to it,\nlargest of all panels "
                      f"{largest:.0f} N", title_fontsize=9, alignment="left")


def drop_figure(run, drop, networks, geogrid, times, path):
    box = box_of(run)
    length, width, height = box[:3]
    left = min(0, min(1e3 * geogrid.points(geogrid.frame_at(time))[:, 0].min() for time in times))
    top = max(height, max(network.ends[:, :, 2].max() for network in networks))
    margin = 8
    largest = max(network.size.max() for network in networks)
    sizes = [length - left + 2 * margin, width + 2 * margin]
    figure = plt.figure(figsize=(11.4, 9.3), layout="constrained")
    panels, beside = figure.subfigures(1, 2, width_ratios=[1.5, 1])
    grid = panels.subplots(3, 2, width_ratios=sizes, sharey=True)
    for row, name, network, time in zip(grid, MOMENTS, networks, times):
        moment = drop[name]
        for axes, across in zip(row, (False, True)):
            draw_box(axes, box, across)
            draw_network(axes, network, largest, across)
            draw_geogrid(axes, geogrid, time, across)
            axes.set_aspect("equal")
            # Who looks along x has y on the left.
            axes.set_xlim(*((width + margin, -margin) if across else (left - margin, length + margin)))
            axes.set_ylim(-margin, top + margin)
        row[0].set_ylabel("z [mm]")
        row[0].set_title(f"{name}: {1e3 * moment['displacement_m']:.2f} mm, {moment['force_N']:.0f} N", fontsize=11,
                         loc="left")
    grid[2, 0].set_xlabel("x [mm], from the side; pulled to the left")
    grid[2, 1].set_xlabel("y [mm], from the front")
    whole, near, legend = beside.subplots(3, 1, height_ratios=[1, 1, 0.55])
    history = read_history(run)
    draw_curve(whole, history, drop, False)
    draw_curve(near, history, drop, True)
    summary = read_summary(run)
    part = unusable_part(summary)
    if part is not None:
        figures.shade_unusable(whole, part, "0.3", "")
        whole.legend(loc="best", fontsize=7, edgecolor="none")
    whole.set_title(figures.title_of(run, summary), fontsize=11)
    draw_legend(legend, largest)
    figures.save(figure, path)


def print_table(drop, networks):
    print("moment  displacement  pull force  on the ribs  on the front wall  largest of all contacts")
    for name, network in zip(MOMENTS, networks):
        print(f"{name:<6}  {1e3 * drop[name]['displacement_m']:9.3f} mm  {drop[name]['force_N']:8.1f} N  "
              f"{network.on_ribs():9.1f} N  {network.on_front():15.1f} N  {network.size.max():21.1f} N")


def draw(run):
    drop, folder = read_drop(run), os.path.join(run, "drop")
    contacts, geogrid = (open_series(folder, name) for name in ("contacts", "geogrid"))
    if contacts is None or geogrid is None or len(contacts) != len(MOMENTS):
        raise InputError(f"{folder} holds {len(contacts) if contacts else 0} frames with contacts, and not one "
                                 "for each of the three moments: they lie within a step, or the folder is not whole.")
    networks = [Network(contacts, frame) for frame in range(len(MOMENTS))]
    times = [contacts.time(frame) for frame in range(len(MOMENTS))]
    print_table(drop, networks)
    drop_figure(run, drop, networks, geogrid, times, os.path.join(run, "figures", "force_drop.png"))


def main():
    if len(sys.argv) != 2:
        print("One argument: the output folder of a pull-out.", file=sys.stderr)
        return 2
    try:
        draw(sys.argv[1])
    except InputError as error:
        print(error, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
