#!/usr/bin/python3 -I
"""Error of the volume and distance of the surface against the number of spheres, in both orders.

    figure.py REPORT WITH_BULGE -o FOLDER        reports of `interlock clump --compare-orders`
"""

import argparse
import csv
import json
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "apps"))
import plain_matplotlib  # before Matplotlib
import matplotlib.pyplot as plt


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("report")
    parser.add_argument("with_bulge")
    parser.add_argument("-o", "--output", required=True, metavar="FOLDER")
    arguments = parser.parse_args()
    rows = []
    for path in (arguments.report, arguments.with_bulge):
        with open(path, encoding="utf-8") as file:
            report = json.load(file)
        rows += [{"largest_bulge_m": report["parameters"]["bulge_m"], **row} for row in report["orders"]]
    with open(os.path.join(arguments.output, "orders.csv"), "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, rows[0])
        table.writeheader()
        table.writerows(rows)

    figure, (volume, distance) = plt.subplots(1, 2, figsize=(9, 3.8), dpi=130)
    for order, bulge, style, label in (("random", False, "o--", "random order"), ("gain", False, "s-", "by gain"),
                                       ("gain", True, "^-", "by gain, with bulge")):
        some = [row for row in rows if row["order"] == order and (row["largest_bulge_m"] > 0) == bulge]
        spheres = [row["spheres"] for row in some]
        volume.plot(spheres, [100 * row["volume_error"] for row in some], style, label=label)
        distance.plot(spheres, [1e3 * row["surface_distance_95_m"] for row in some], style, label=label)
    for (n, percent, millimetres) in ((55, 10, 1.3), (150, 5, 0.6)):
        volume.plot(n, -percent, "_", color="black", markersize=14)
        distance.plot(n, millimetres, "_", color="black", markersize=14)
    volume.set_ylabel("volume of the union against the stone [%]")
    distance.set_ylabel("95 % of the surface within [mm]")
    distance.set_ylim(bottom=0)
    for axis in (volume, distance):
        axis.set_xlabel("spheres, mean of the stones")
        axis.grid(alpha=0.3)
    distance.plot([], [], "_", color="black", markersize=14, label="target")
    distance.legend()
    figure.tight_layout()
    path = os.path.join(arguments.output, "orders.png")
    figure.savefig(path)
    print(f"Figure: {path}")


if __name__ == "__main__":
    main()
