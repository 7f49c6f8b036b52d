"""Run inside `yade -n -x` by yade_coupled.py; settings come as JSON in PEER_SETTINGS."""
import json
import math
import os
import sys
import time

settings = json.loads(os.environ["PEER_SETTINGS"])
sys.path.insert(0, settings["scripts"])
import numpy as np
from job import rotation
from yade.gridpfacet import gridConnection, gridNode

LOCAL_DAMPING = 0.3
NOBODY = 4  # mask of the balls at the nodes: the connections between them touch the stones

with open(settings["state"]) as file:
    state = json.load(file)
angle = math.atan(settings["friction"])
stone = O.materials.append(FrictMat(young=1e9, poisson=0.3, density=state["density"], frictionAngle=angle))
for clump in state["clumps"]:
    shape = state["shapes"][clump["shape"]]
    turn, centre = rotation(clump["quat"]), np.array(clump["pos"])
    members = [sphere(tuple(turn @ np.array(s[:3]) + centre), s[3], material=stone) for s in shape["spheres"]]
    body, _ = O.bodies.appendClumped(members, discretization=0)
    motion = O.bodies[body].state
    motion.mass = clump["mass"]
    motion.inertia = tuple(clump["inertia"])
box = state["box"]
for axis, place in ((0, 0), (0, box[0]), (1, 0), (1, box[1]), (2, 0)):
    O.bodies.append(wall(place, axis=axis, material=stone))

ribs = state["ribs"]
beam = O.materials.append(CohFrictMat(young=ribs["youngs_modulus"], poisson=ribs["poisson_ratio"], density=ribs["density"],
                                      frictionAngle=angle, normalCohesion=1e40, shearCohesion=1e40,
                                      momentRotationLaw=True))
surface = O.materials.append(FrictMat(young=1e9, poisson=0.3, density=ribs["density"], frictionAngle=angle))
nodes = [O.bodies.append(gridNode(tuple(x), ribs["radius"], wire=False, fixed=k in ribs["clamped"], material=beam))
         for k, x in enumerate(ribs["nodes"])]
for node in nodes:
    O.bodies[node].mask = NOBODY
for a, b in ribs["elements"]:
    O.bodies.append(gridConnection(nodes[a], nodes[b], ribs["radius"], material=surface))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_GridConnection_Aabb(), Bo1_Wall_Aabb()], verletDist=settings["skin"]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(), Ig2_GridNode_GridNode_GridNodeGeom6D(),
                     Ig2_Sphere_GridConnection_ScGridCoGeom()],
                    [Ip2_FrictMat_FrictMat_FrictPhys(kn=settings["k_n"], ks=settings["k_t"], frictAngle=angle),
                     Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True, setCohesionOnNewContacts=False)],
                    [Law2_ScGeom_FrictPhys_CundallStrack(), Law2_ScGridCoGeom_FrictPhys_CundallStrack(),
                     Law2_ScGeom6D_CohFrictPhys_CohesionMoment()]),
    NewtonIntegrator(damping=LOCAL_DAMPING, gravity=(0, 0, -settings["gravity"]))]
O.dt = settings["dt"]
O.run(settings["warm"], True)
start = time.time()
O.run(settings["steps"], True)
seconds = (time.time() - start) / settings["steps"]

at_ribs = sum(1 for i in O.interactions if i.isReal and
              GridConnection in (type(O.bodies[i.id1].shape), type(O.bodies[i.id2].shape)))
beams = sum(1 for i in O.interactions if i.isReal and
            type(O.bodies[i.id1].shape) == type(O.bodies[i.id2].shape) == GridNode)
stones = sum(1 for i in O.interactions if i.isReal and
             type(O.bodies[i.id1].shape) == type(O.bodies[i.id2].shape) == Sphere)
print("\nRESULT %.9g %d %d %d" % (seconds, stones, at_ribs, beams), flush=True)
