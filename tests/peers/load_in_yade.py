"""Runs inside YADE: adds one turned stone of the file CLUMP.py, moves it for some steps, and writes
what YADE has of it."""
import importlib
import os
import sys

sys.path.append(".")
stone = importlib.import_module(os.environ["CLUMP"])
material = FrictMat(density=1234)
O.materials.append(material)
turn = Quaternion((1, 2, 3), 0.7)
turn.normalize()
clump_id, sphere_ids = stone.add_stone(Vector3(0.3, -0.2, 1), turn, material)

O.engines = [ForceResetter(),
             InsertionSortCollider([Bo1_Sphere_Aabb()]),
             InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()],
                             [Law2_ScGeom_FrictPhys_CundallStrack()]),
             NewtonIntegrator(damping=0, gravity=(0, 0, -9.81), exactAsphericalRot=True)]
O.dt = 1e-5
O.run(10, True)

state = O.bodies[clump_id].state
numbers = [state.mass, *state.inertia, *state.pos, state.ori[3], *[state.ori[k] for k in range(3)]]
with open("spheres.txt", "w") as file:
    for i in sphere_ids:
        sphere = O.bodies[i]
        print(*[repr(float(x)) for x in (*sphere.state.pos, sphere.shape.radius)], file=file)
with open("bodies.txt", "w") as file:
    print(*[repr(float(x)) for x in numbers], file=file)
os._exit(0)  # without the questions of the prompt
