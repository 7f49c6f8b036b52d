"""YADE: its own clumps and Law2_ScGeom_FrictPhys_CundallStrack (Debian package yade).

The linear law of YADE has no dashpots: it damps by Cundall's local damping, the one difference in physics.
The skin is its verletDist.
"""
import json
import os
import re
import sys

from job import Job, Result, run_program


def run(job: Job) -> Result:
    with open(os.path.join(job.folder, "state.json"), "w") as file:
        json.dump(job.state, file)
    settings = dict(vars(job.law), warm=job.warm, steps=job.steps, skin=job.skin, state="state.json",
                    scripts=os.path.dirname(os.path.abspath(__file__)))
    case = os.path.join(settings["scripts"], "yade_case.py")
    program = run_program(["yade", "-n", "-x", "-j1", case], job, PEER_SETTINGS=json.dumps(settings))
    found = re.search(r"^RESULT (\S+) (\d+)$", program.stdout, re.M)
    if not found:
        sys.exit("YADE failed: " + (program.stdout + program.stderr)[-1500:])
    return Result(seconds=float(found[1]), contacts=int(found[2]))
