"""LAMMPS: fix rigid/small with pair style gran/hooke/history (Debian package lammps).

Two traps: rigid/small needs `atom_modify map array`; gravity must be a disabled fix that rigid/small
refers to, or it acts on every overlapping sphere besides.
"""
import os
import re
import sys

import numpy as np

from job import Job, Result, rotation, run_program, world_spheres


def write_spheres(job: Job):
    spheres = world_spheres(job.state)
    with open(os.path.join(job.folder, "data"), "w") as file:
        file.write("clumps\n\n%d atoms\n1 atom types\n\n" % len(spheres))
        for k, axis in enumerate("xyz"):
            file.write("%g %g %slo %shi\n" % (-0.02, job.state["box"][k] + 0.02, axis, axis))
        file.write("\nAtoms\n\n")
        for i, (x, y, z, r, _) in enumerate(spheres):
            file.write("%d 1 %.15g %g %.15g %.15g %.15g\n" % (i + 1, 2 * r, job.state["density"], x, y, z))
        file.write("\nMolecules\n\n")
        for i, sphere in enumerate(spheres):
            file.write("%d %d\n" % (i + 1, sphere[4] + 1))


def write_bodies(job: Job):
    """Mass, centre and inertia of each clump; LAMMPS would sum overlapping spheres."""
    with open(os.path.join(job.folder, "bodies"), "w") as file:
        file.write("%d\n" % len(job.state["clumps"]))
        for i, clump in enumerate(job.state["clumps"]):
            shape = job.state["shapes"][clump["shape"]]
            turn = rotation(clump["quat"])
            inertia = turn @ np.diag(shape["inertia"]) @ turn.T
            momentum = inertia @ np.array(clump["omega"])
            numbers = [shape["mass"], *clump["pos"], inertia[0, 0], inertia[1, 1], inertia[2, 2], inertia[0, 1],
                       inertia[0, 2], inertia[1, 2], *clump["vel"], *momentum]
            file.write("%d " % (i + 1) + " ".join("%.15g" % x for x in numbers) + " 0 0 0\n")


def run(job: Job) -> Result:
    write_spheres(job)
    write_bodies(job)
    law, box = job.law, job.state["box"]
    numbers = "%g %.15g %g %g %g 1" % (law.k_n, law.k_t, law.rate_n, law.rate_t, law.friction)
    with open(os.path.join(job.folder, "in"), "w") as file:
        file.write(f"""units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes
fix mol all property/atom mol ghost yes
read_data data fix mol NULL Molecules
neighbor {job.skin} bin
neigh_modify delay 0 every 1 check yes exclude molecule/intra all
pair_style gran/hooke/history {numbers}
pair_coeff * *
timestep {law.dt}
fix g all gravity {law.gravity} vector 0 0 -1 disable
fix rig all rigid/small molecule infile bodies gravity g
fix wx all wall/gran hooke/history {numbers} xplane 0 {box[0]:.15g}
fix wy all wall/gran hooke/history {numbers} yplane 0 {box[1]:.15g}
fix wz all wall/gran hooke/history {numbers} zplane 0 NULL
thermo_style custom step cpu
thermo {max(job.steps // 2, 1)}
thermo_modify lost error
run {job.warm}
run {job.steps}
compute touching all contact/atom
compute twice all reduce sum c_touching
thermo_style custom step cpu c_twice
run 0
""")
    program = run_program(["lmp", "-in", "in", "-log", "log", "-screen", "none"], job)
    log = open(os.path.join(job.folder, "log")).read()
    loops = re.findall(r"Loop time of ([\d.e+-]+) on", log)
    if program.returncode != 0 or len(loops) < 3:
        sys.exit("LAMMPS failed: " + log[-800:] + program.stderr[-800:])
    twice = [line.split() for line in log.splitlines() if re.match(r"^\s+\d+\s+0\s", line)][-1][2]
    return Result(seconds=float(loops[1]) / job.steps, contacts=round(float(twice) / 2))
