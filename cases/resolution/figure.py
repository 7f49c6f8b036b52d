#!/usr/bin/python3 -I
"""A stone and clumps of it beside one another, from the same direction and at the same scale.

    figure.py STONE.stl NAME.clump.json... -o FILE
"""

import argparse
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "apps"))
import contact_sheet  # before Matplotlib, which it sets up
import matplotlib.pyplot as plt
import numpy as np
import stone_pictures as pictures

# The published numbers of spheres and d_min, r_min [mm], p_max [%] of Table 4, in the order of the clumps.
TABLE_4 = [(5500, "0.1", "2", "10"), (800, "0.1", "0.5", "1"), (400, "1.14", "1", "1"), (100, "1.8", "3", "1")]
VIEW = contact_sheet.VIEW
PIXELS = 380  # a picture's side


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("stone")
    parser.add_argument("clumps", nargs="+")
    parser.add_argument("-o", "--output", required=True)
    arguments = parser.parse_args()
    triangles = pictures.read_stl(arguments.stone)
    centre, axes = pictures.mesh_moments(triangles)
    triangles = (triangles - centre) @ axes.T
    scale = PIXELS / (1.05 * np.ptp((triangles @ VIEW.T)[..., :2], axis=(0, 1)).max())
    panels = [(pictures.draw_mesh(triangles, VIEW, PIXELS, PIXELS, scale), f"stone: {len(triangles):,} facets")]
    for path, (published, d_min, r_min, p_max) in zip(arguments.clumps, TABLE_4):
        spheres = contact_sheet.align(pictures.read_clump(path)[1], triangles)
        text = f"{len(spheres):,} spheres (paper: {published:,})\n$d_{{min}}$ {d_min} mm, $r_{{min}}$ {r_min} mm, $p_{{max}}$ {p_max} %"
        panels.append((pictures.draw_spheres(spheres, VIEW, PIXELS, PIXELS, scale), text))
    figure, all_axes = plt.subplots(1, len(panels), figsize=(3 * len(panels), 3.6), dpi=130)
    for axis, (picture, text) in zip(all_axes, panels):
        axis.imshow(picture)
        axis.set_title(text, fontsize=9)
        axis.axis("off")
    figure.tight_layout()
    figure.savefig(arguments.output)
    print(f"Figure: {arguments.output}")


if __name__ == "__main__":
    main()
