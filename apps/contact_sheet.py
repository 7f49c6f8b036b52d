#!/usr/bin/python3 -I
"""Contact sheet of stones and their clumps, shaded, to scale, side by side.

    contact_sheet.py STONES_DIR [--clumps CLUMPS_DIR] [-o contact_sheet.png]

Draws every *.stl of the folder. Where NAME.clump.json lies beside it or in the clumps' folder, the clump
is drawn to the right of its stone, from the same direction and at the same scale. Below stand the name,
the side of the smallest square opening that the stone passes, and the number of spheres. Ends with 2 and
one sentence when the folder holds no stone.
"""

import argparse
import glob
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))
import plain_matplotlib  # before Matplotlib
import matplotlib.pyplot as plt
import numpy as np

import stone_pictures as pictures

VIEW = pictures.view_from(-55, 38)
MARGIN = 1.04  # of a cell, over the largest stone


class InputError(Exception):
    """What the user named cannot be drawn; the text is one full sentence."""


def sieve_size(points):
    """Side of the smallest square around the shadow along x, the longest axis [m]."""
    best = np.inf
    for angle in np.radians(np.arange(0, 90, 0.5)):
        turned = points[:, 1:] @ np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        best = min(best, np.ptp(turned, axis=0).max())
    return best


class Stone:
    """A stone in its principal frame, as a clump has it, and the clump where there is one."""

    def __init__(self, path, folders):
        triangles = pictures.read_stl(path)
        centre, axes = pictures.mesh_moments(triangles)
        self.triangles = (triangles - centre) @ axes.T
        self.name = os.path.splitext(os.path.basename(path))[0]
        self.sieve = sieve_size(self.triangles.reshape(-1, 3))
        self.spheres = None
        for folder in folders:
            clump = os.path.join(folder, self.name + ".clump.json")
            if os.path.isfile(clump):
                self.spheres = align(pictures.read_clump(clump)[1], self.triangles)
        reach = (self.triangles @ VIEW.T)[..., :2]
        self.low, self.high = reach.min((0, 1)), reach.max((0, 1))


def align(spheres, triangles):
    """Turns a clump by half turns about its axes until it fits the mesh: axes have no sign."""
    points = triangles[::7].mean(1)
    def misfit(flip):
        centres = spheres[:, :3] * flip
        return np.abs((np.linalg.norm(points[:, None] - centres, axis=2) - spheres[:, 3]).min(1)).mean()
    best = min(([1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]), key=misfit)
    return np.hstack([spheres[:, :3] * best, spheres[:, 3:]])


def read_stones(folder, clumps):
    paths = sorted(glob.glob(os.path.join(folder, "*.stl")))
    if not paths:
        raise InputError(f"{folder}: there is no *.stl file in this folder.")
    try:
        return [Stone(path, [folder] + ([clumps] if clumps else [])) for path in paths]
    except ValueError as error:
        raise InputError(str(error)) from error


def draw_cell(stone, width, height, scale):
    """Stone, and clump to its right, in one picture."""
    middle = np.array([*(stone.low + stone.high) / 2, 0]) @ VIEW  # centred as seen, not in space
    picture = pictures.draw_mesh(stone.triangles, VIEW, width, height, scale, middle)
    if stone.spheres is None:
        return picture
    return np.hstack([picture, pictures.draw_spheres(stone.spheres, VIEW, width, height, scale, middle)])


def draw_scale_bar(figure, pixels_per_metre, length=0.05):
    width, height = figure.get_size_inches() * figure.dpi
    x, y, end = 0.012, 1 - 16 / height, length * pixels_per_metre / width
    figure.add_artist(plt.Line2D([x, x + end], [y, y], color="black", linewidth=2.5, solid_capstyle="butt"))
    figure.text(x + end + 8 / width, y, f"{1e3 * length:.0f} mm", va="center", fontsize=9)


def contact_sheet(stones, columns, cell_width):
    """All stones in a grid as a figure of exactly as many pixels as the pictures have."""
    span = MARGIN * max((stone.high - stone.low).max() for stone in stones)
    with_clumps = any(stone.spheres is not None for stone in stones)
    scale = cell_width / span
    cell_height = int(np.ceil(MARGIN * scale * max((s.high - s.low)[1] for s in stones)))
    caption, head = 20, 30
    across, rows = cell_width * (2 if with_clumps else 1), -(-len(stones) // columns)
    width, height = across * columns, (cell_height + caption) * rows + head
    sheet, labels = np.ones((height, width, 3)), []
    for i, stone in enumerate(stones):
        top, left = head + i // columns * (cell_height + caption), i % columns * across
        cell = draw_cell(stone, cell_width, cell_height, scale)
        sheet[top:top + cell_height, left:left + cell.shape[1]] = cell
        count = "" if stone.spheres is None else f", {len(stone.spheres)} spheres"
        labels.append((left + across / 2, top + cell_height + caption / 2,
                       f"{stone.name}: {1e3 * stone.sieve:.0f} mm{count}"))
    figure = plt.figure(figsize=(width / 100, height / 100), dpi=100)
    figure.figimage((255 * sheet).astype(np.uint8), resize=False)
    for x, y, text in labels:
        figure.text(x / width, 1 - y / height, text, ha="center", va="center", fontsize=7.5)
    draw_scale_bar(figure, scale)
    return figure


def save(figure, path):
    """Under a temporary name first, so that a reader never finds half a picture."""
    temporary = path + ".part"
    figure.savefig(temporary, dpi=100, format=os.path.splitext(path)[1][1:] or "png")
    os.replace(temporary, path)
    print(f"Wrote {path}.")


def main():
    parser = argparse.ArgumentParser(description="Contact sheet of stones and their clumps.")
    parser.add_argument("stones", metavar="STONES_DIR", help="folder of binary STL files in metres")
    parser.add_argument("--clumps", metavar="CLUMPS_DIR",
                        help="folder of NAME.clump.json (default: the stones')")
    parser.add_argument("-o", "--output", default="contact_sheet.png", metavar="FILE",
                        help="picture to write")
    parser.add_argument("--columns", type=int, default=6, help="stones beside one another")
    parser.add_argument("--cell", type=int, default=150, help="width of one stone's picture [pixels]")
    arguments = parser.parse_args()
    try:
        stones = read_stones(arguments.stones, arguments.clumps)
        save(contact_sheet(stones, max(1, arguments.columns), max(40, arguments.cell)), arguments.output)
    except (InputError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
