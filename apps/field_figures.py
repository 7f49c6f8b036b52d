"""Pictures from the fields written for ParaView (field_series.py): the box from the side and the contact force
network. Imported by figures.py; needs h5py.
"""

import os
import xml.etree.ElementTree

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.colors import Normalize
from field_series import open_series


def way_of_stones(clumps, frame):
    """For every sphere, how far its stone has gone since the first frame [mm]."""
    return 1e3 * np.linalg.norm(clumps.attribute(frame, "displacement"), axis=1)


def draw_stones(axes, clumps, frame, limit):
    """Stones of the rear half of the box, coloured by their way, the nearest on top; returns the scale."""
    points, stone = 1e3 * clumps.points(frame), clumps.attribute(frame, "clump")
    diameter = 2e3 * clumps.attribute(frame, "radius")
    scale = ScalarMappable(Normalize(0, limit), "YlGnBu")
    colours = scale.to_rgba(way_of_stones(clumps, frame))
    middle = 0.5 * (points[:, 1].min() + points[:, 1].max())
    depth = {key: points[stone == key, 1].mean() for key in np.unique(stone)}
    rear = [key for key in depth if depth[key] >= middle]
    # Each stone is painted twice: a little larger and dark, then its own colour, which leaves an outline.
    members, grow, paint = [], [], []
    for key in sorted(rear, key=depth.get, reverse=True):
        mine = np.flatnonzero(stone == key)
        members += [mine, mine]
        grow += [np.full(len(mine), 1.2), np.zeros(len(mine))]
        paint += [np.tile([0.25, 0.25, 0.25, 1.0], (len(mine), 1)), colours[mine]]
    if members:
        members, grow = np.concatenate(members), np.concatenate(grow)
        size = diameter[members] + grow
        axes.add_collection(EllipseCollection(
            size, size, np.zeros(len(size)), units="xy", offsets=points[members][:, [0, 2]],
            offset_transform=axes.transData, facecolors=np.concatenate(paint), linewidths=0))
    return scale


def draw_lines(axes, points, lines, **style):
    """Lines between points, seen along y, in mm; returns the artist."""
    ends = 1e3 * points[:, [0, 2]]
    return axes.add_collection(LineCollection(ends[lines], **style))


def dress(axes, points, title):
    """The same scale on both axes, with room around everything that is drawn."""
    low, high = 1e3 * points.min(axis=0), 1e3 * points.max(axis=0)
    axes.set_xlim(low[0] - 30, high[0] + 30)
    axes.set_ylim(low[2] - 30, high[2] + 30)
    axes.set_aspect("equal")
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("z [mm]")
    axes.set_title(title, fontsize=10)


def box_figure(run, path, save, pulled):
    clumps, geogrid = open_series(run, "clumps"), open_series(run, "geogrid")
    if clumps is None:
        print(f"Left out {path}: {run} holds no clumps.xdmf with a frame.")
        return
    figure, panels = plt.subplots(1, 2, figsize=(12, 5), sharey=True, layout="constrained")
    last = len(clumps) - 1
    limit = max(1e-3, np.percentile(way_of_stones(clumps, last), 98))
    for axes, frame in zip(panels, (0, last)):
        scale = draw_stones(axes, clumps, frame, limit)
        extent = [clumps.points(0), clumps.points(last)]
        if geogrid is not None:
            ribs = geogrid.frame_at(clumps.time(frame))
            draw_lines(axes, geogrid.points(ribs), geogrid.lines(ribs), color="#D55E00", linewidth=1.6)
            extent += [geogrid.points(0), geogrid.points(len(geogrid) - 1)]
        dress(axes, np.concatenate(extent), f"rear half of the box, {pulled(clumps.time(frame))}")
    figure.colorbar(scale, ax=panels, label="way of the stone since the first frame [mm]", shrink=0.8)
    save(figure, path)


def force_chain_figure(run, path, save, pulled):
    contacts, geogrid = open_series(run, "contacts"), open_series(run, "geogrid")
    if contacts is None:
        print(f"Left out {path}: {run} holds no contacts.xdmf with a frame.")
        return
    # The frame with the largest force: arches form and break, and the last frame may fall between.
    strengths = [contacts.attribute(i, "force") for i in range(len(contacts))]
    frame = int(np.argmax([strength.max(initial=0) for strength in strengths]))
    if strengths[frame].size == 0:
        print(f"Left out {path}: there is no contact in any frame.")
        return
    strength, points = strengths[frame], contacts.points(frame)
    order = np.argsort(strength)
    figure, axes = plt.subplots(figsize=(8, 5), layout="constrained")
    # Full width at the strongest contacts; one outlier must not thin all the others.
    reference = np.percentile(strength, 99.5)
    width = 5 * np.minimum(strength[order] / reference, 1.5)
    colours = np.array(["black", "0.6", "#0072B2"])[contacts.attribute(frame, "kind")[order].astype(int)]
    draw_lines(axes, points, contacts.lines(frame)[order], color=colours, linewidth=width, alpha=0.8,
               capstyle="round")
    for label, colour in (("between stones", "black"), ("at walls", "0.6"), ("at ribs", "#0072B2")):
        axes.plot([], [], color=colour, linewidth=3, label=label)
    axes.legend(frameon=False, fontsize=8, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    extent = [points]
    if geogrid is not None:
        ribs = geogrid.frame_at(contacts.time(frame))
        draw_lines(axes, geogrid.points(ribs), geogrid.lines(ribs), color="#D55E00", linewidth=1.6)
        extent.append(geogrid.points(ribs))
    dress(axes, np.concatenate(extent), f"contact forces, {pulled(contacts.time(frame))}; line width in "
          f"proportion to force, largest {strength.max():.3g} N")
    save(figure, path)


def draw_all(run, folder, save, pulled):
    """Both pictures into `folder`. `save(figure, path)` writes one; `pulled(time)` says in words how far
    the geogrid has been pulled then."""
    for draw, name in ((box_figure, "box.png"), (force_chain_figure, "force_chains.png")):
        path = os.path.join(folder, name)
        try:
            draw(run, path, save, pulled)
        except (OSError, KeyError, xml.etree.ElementTree.ParseError) as error:
            # The files of a running case may be in the middle of being written.
            print(f"Left out {path}: the fields cannot be read ({error}).")
