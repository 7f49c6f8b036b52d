#!/usr/bin/env python3
"""Prints one table of what a code reports of a body against its clump file.

  compare.py --head
  compare.py CLUMP.clump.json DENSITY LABEL BODIES     (and spheres.txt beside it)

BODIES: mass, three moments, centre x y z and quaternion w x y z (principal axes to the world); its
last line counts, so LAMMPS's and LIGGGHTS's dumps serve. spheres.txt: x y z r of every sphere in the
world, in any order. Ends with 1 when a number is off by more than 1e-6; all codes write 17 digits and
sample nothing.
"""
import json
import math
import sys

TOLERANCE = 1e-6
ROW = "%-12s %-8s %-34s %24s %24s %10s"


def numbers(path):
    """The lines of numbers of the last frame of a dump, or of a plain table."""
    rows = []
    for line in open(path):
        if line.startswith("ITEM:"):
            rows = []
        else:
            rows.append([float(x) for x in line.split()])
    return rows


def axes_of(w, x, y, z):
    """Columns of the rotation matrix of a quaternion: the principal axes in the world."""
    return ((1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)),
            (2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)),
            (2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)))


def quantities(mass, moments, spheres, hand=1):
    """Name, value and scale. Spheres are in principal axes; of their coordinates the absolute values
    count, because an axis may point either way. `hand` is -1 when the axes are left-handed."""
    farthest = max(math.hypot(*s[:3]) for s in spheres)
    yield "mass [kg]", mass, mass
    for k in range(3):
        yield "moment of inertia %d [kg m2]" % (k + 1), moments[k], moments[k]
    yield "number of spheres", len(spheres), 1
    yield "sum of radii [m]", sum(s[3] for s in spheres), farthest
    for k in range(3):
        yield ("sum of r |x_%d - centre| [m2]" % (k + 1), sum(abs(s[k]) * s[3] for s in spheres),
               sum(s[3] for s in spheres) * farthest)
    # Keeps its sign when axes turn round in pairs, changes it in a mirror.
    yield ("sum of r x_1 x_2 x_3 [m4]", hand * sum(math.prod(s) for s in spheres),
           sum(s[3] for s in spheres) * farthest**3)


def ours(path, density):
    clump = json.load(open(path))
    mass = density * clump["volume_m3"]
    return quantities(mass, [density * i for i in clump["unit_inertia_m5"]],
                      clump["spheres_x_y_z_r_m"])


def theirs(path):
    mass, i1, i2, i3, x, y, z, *quaternion = numbers(path)[-1]
    # Codes order the moments as they like; an axis goes with its moment.
    pairs = sorted(zip((i1, i2, i3), axes_of(*quaternion)))
    spheres = []
    for *position, radius in numbers("spheres.txt"):
        arm = [p - c for p, c in zip(position, (x, y, z))]
        spheres.append([sum(a * b for a, b in zip(arm, axis)) for _, axis in pairs] + [radius])
    a, b, c = (axis for _, axis in pairs)
    hand = sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))
    return quantities(mass, [moment for moment, _ in pairs], spheres, hand)


def main():
    if sys.argv[1:] == ["--head"]:
        print(ROW % ("code", "clump", "quantity", "clump file", "code has", "difference"))
        return 0
    path, density, label, table = sys.argv[1:]
    clump = path.split("/")[-1].split(".")[0]
    worst = 0.0
    for (name, a, scale), (_, b, _) in zip(ours(path, float(density)), theirs(table)):
        difference = abs(b - a) / scale
        worst = max(worst, difference)
        verdict = "" if difference <= TOLERANCE else "  <- above %g" % TOLERANCE
        print(ROW % (label, clump, name, "%.15g" % a, "%.15g" % b, "%.1e" % difference) + verdict)
    return 0 if worst <= TOLERANCE else 1


if __name__ == "__main__":
    sys.exit(main())
