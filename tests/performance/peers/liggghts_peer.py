"""LIGGGHTS: fix multisphere (Debian package liggghts).

It reads no state of multispheres: every clump is put in its place by a `fix insert/pack` of its own, one
particle with a constant orientation into a tiny region. `-screen none` makes that fix crash.
"""
import os
import re
import sys

from job import Job, Result, run_program


def primes():
    """The seeds of LIGGGHTS must be primes."""
    candidate = 15485863
    while True:
        if all(candidate % k for k in range(3, int(candidate ** 0.5) + 1, 2)):
            yield candidate
        candidate += 2


def shapes_text(job: Job, seeds):
    text = ""
    for i, shape in enumerate(job.state["shapes"]):
        with open(os.path.join(job.folder, "shape%d" % i), "w") as file:
            for sphere in shape["spheres"]:
                file.write("%.15g %.15g %.15g %.15g\n" % tuple(sphere))
        moments = shape["inertia"]
        text += (f"fix pt{i} all particletemplate/multisphere {next(seeds)} atom_type 1 density constant "
                 f"{job.state['density']} nspheres {len(shape['spheres'])} ntry 20000 spheres file shape{i} "
                 f"scale 1.0 type {i + 1} mass {shape['mass']:.15g} inertia_tensor {moments[0]:.15g} 0 0 "
                 f"{moments[1]:.15g} 0 {moments[2]:.15g} use_density\n"
                 f"fix pd{i} all particledistribution/discrete {next(seeds)} 1 pt{i} 1.0\n")
    return text


def clumps_text(job: Job, seeds):
    text, some = "", [next(seeds) for _ in range(50)]
    for i, clump in enumerate(job.state["clumps"]):
        region = " ".join("%.15g %.15g" % (x - 1e-8, x + 1e-8) for x in clump["pos"])
        turn = " ".join("%.15g" % q for q in clump["quat"])
        text += (f"region r{i} block {region} units box volume_limit 1e-30\n"
                 f"fix i{i} all insert/pack seed {some[i % 50]} distributiontemplate pd{clump['shape']} vel "
                 f"constant 0 0 0 orientation constant {turn} insert_every once overlapcheck no all_in no "
                 f"region r{i} ntry_mc 1000 particles_in_region 1\n")
    return text


def run(job: Job) -> Result:
    law, box, seeds = job.law, job.state["box"], primes()
    model = "model hooke/stiffness tangential history"
    text = f"""atom_style sphere
atom_modify map array
boundary f f f
newton off
communicate single vel yes
processors 1 1 1
units si
region reg block -0.02 {box[0] + 0.02} -0.02 {box[1] + 0.02} -0.02 {box[2] + 0.02} units box
create_box 1 reg
neighbor {job.skin} bin
neigh_modify every 1 delay 0 check yes
fix m1 all property/global kn peratomtypepair 1 {law.k_n}
fix m2 all property/global kt peratomtypepair 1 {law.k_t}
fix m3 all property/global gamman peratomtypepair 1 {law.rate_n}
fix m4 all property/global gammat peratomtypepair 1 {law.rate_t}
fix m5 all property/global coefficientFriction peratomtypepair 1 {law.friction}
pair_style gran {model}
pair_coeff * *
timestep {law.dt}
fix g all gravity {law.gravity} vector 0 0 -1
fix wx1 all wall/gran {model} primitive type 1 xplane 0
fix wx2 all wall/gran {model} primitive type 1 xplane {box[0]:.15g}
fix wy1 all wall/gran {model} primitive type 1 yplane 0
fix wy2 all wall/gran {model} primitive type 1 yplane {box[1]:.15g}
fix wz1 all wall/gran {model} primitive type 1 zplane 0
"""
    text += shapes_text(job, seeds) + clumps_text(job, seeds)
    text += f"""fix ms all multisphere
compute touching all contact/atom
compute twice all reduce sum c_touching
thermo_style custom step atoms cpu
thermo {max(job.steps // 2, 1)}
thermo_modify lost error norm no
run 1
"""
    text += "".join("unfix i%d\n" % i for i in range(len(job.state["clumps"])))
    text += f"""run {job.warm}
run {job.steps}
thermo_style custom step atoms cpu c_twice
run 0
"""
    with open(os.path.join(job.folder, "in"), "w") as file:
        file.write(text)
    program = run_program(["liggghts", "-in", "in", "-log", "log"], job)
    log = open(os.path.join(job.folder, "log")).read()
    loops = re.findall(r"Loop time of ([\d.e+-]+) on", log)
    if program.returncode != 0 or "ERROR" in log or len(loops) < 4:
        sys.exit("LIGGGHTS failed: " + log[-800:] + program.stderr[-800:])
    last = [line.split() for line in log.splitlines() if re.match(r"^\s+\d+\s+\d+\s+\S+\s+[\d.e+-]+\s*$", line)][-1]
    return Result(seconds=float(loops[2]) / job.steps, contacts=round(float(last[3]) / 2))
