"""Run inside `yade -n -x` by yade_peer.py; settings come as JSON in PEER_SETTINGS."""
import json
import math
import os
import sys
import time

settings = json.loads(os.environ["PEER_SETTINGS"])
sys.path.insert(0, settings["scripts"])
import numpy as np
from job import rotation

LOCAL_DAMPING = 0.3
DISCRETIZATION = 10  # of YADE's own inertia; 0, its default, sums overlapping spheres

with open(settings["state"]) as file:
    state = json.load(file)
angle = math.atan(settings["friction"])
stone = O.materials.append(FrictMat(young=1e9, poisson=0.3, density=state["density"], frictionAngle=angle))
for clump in state["clumps"]:
    shape = state["shapes"][clump["shape"]]
    turn, centre = rotation(clump["quat"]), np.array(clump["pos"])
    members = [sphere(tuple(turn @ np.array(s[:3]) + centre), s[3], material=stone) for s in shape["spheres"]]
    body, _ = O.bodies.appendClumped(members, discretization=DISCRETIZATION)
    # The mass of the stone, and YADE's inertia scaled to it.
    motion = O.bodies[body].state
    motion.inertia = motion.inertia * (shape["mass"] / motion.mass)
    motion.mass = shape["mass"]
box = state["box"]
for axis, place in ((0, 0), (0, box[0]), (1, 0), (1, box[1]), (2, 0)):
    O.bodies.append(wall(place, axis=axis, material=stone))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=settings["skin"]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
                    [Ip2_FrictMat_FrictMat_FrictPhys(kn=settings["k_n"], ks=settings["k_t"], frictAngle=angle)],
                    [Law2_ScGeom_FrictPhys_CundallStrack()]),
    NewtonIntegrator(damping=LOCAL_DAMPING, gravity=(0, 0, -settings["gravity"]))]
O.dt = settings["dt"]
O.run(settings["warm"], True)
start = time.time()
O.run(settings["steps"], True)
seconds = (time.time() - start) / settings["steps"]
touching = sum(1 for i in O.interactions if i.isReal and isinstance(O.bodies[i.id1].shape, Sphere) and
               isinstance(O.bodies[i.id2].shape, Sphere))
print("\nRESULT %.9g %d" % (seconds, touching), flush=True)
