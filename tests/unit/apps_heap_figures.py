"""The heap's figure script on a small made-up run.

Fails when a figure is not written, when a ball is painted at the wrong place, in the wrong colour or behind
one that it hides, when a folder without history is not answered with one sentence and status 2, or when absent
fields stop the other figures.
Run by ctest: apps_heap_figures.py APPS_FOLDER
"""

import json
import os
import subprocess
import sys
import tempfile
import types
import unittest

import h5py
import numpy as np

APPS = os.path.abspath(sys.argv.pop())
sys.path.insert(0, APPS)
import heap_figures


def stones(centres, radii, elongated):
    return types.SimpleNamespace(centres=np.array(centres, dtype=float), radii=np.array(radii, dtype=float),
                                 elongated=np.array(elongated))


def is_orange(colour):
    return colour[0] > 2 * colour[2]


class Painting(unittest.TestCase):
    extent = (0.0, 0.2, 0.0, 0.1)

    def test_ball_is_where_it_is(self):
        image = heap_figures.paint(stones([[0.05, 7, 0.03]], [0.02], [False]), "side", self.extent, 1e-3)
        self.assertEqual(image.shape, (100, 200, 3))
        rows, columns = np.nonzero(image.min(axis=2) < 1)
        # Rows count from the top.
        self.assertEqual((columns.min(), columns.max()), (30, 69))
        self.assertEqual((100 - rows.max() - 1, 100 - rows.min() - 1), (10, 49))

    def test_nearest_hides_the_others(self):
        for order in ([0, 1], [1, 0]):
            # From above the higher one is seen, from the side that with the smaller y.
            both = [[0.1, 0.05, 0.08], [0.1, 0.04, 0.02]]
            heap = stones([both[i] for i in order], [0.02, 0.02], [i == 0 for i in order])
            plan = heap_figures.paint(heap, "plan", self.extent, 1e-3)
            self.assertTrue(is_orange(plan[100 - 50, 100]))
            heap.centres[:, 2] = 0.05
            side = heap_figures.paint(heap, "side", self.extent, 1e-3)
            self.assertFalse(is_orange(side[100 - 50, 100]))

    def test_what_is_outside_is_cut_off(self):
        image = heap_figures.paint(stones([[0.2, 0, 0.1], [5, 5, 5]], [0.02, 1], [True, True]), "side",
                                   self.extent, 1e-3)
        self.assertTrue(is_orange(image[0, 199]))
        self.assertEqual(image[50, 100].tolist(), [1, 1, 1])


class Script(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.run = os.path.join(self.folder.name, "run")
        os.makedirs(self.run)
        self.addCleanup(self.folder.cleanup)

    def write(self, name, text):
        with open(os.path.join(self.run, name), "w", encoding="utf-8") as file:
            file.write(text)

    def draw(self):
        return subprocess.run([os.path.join(APPS, "heap_figures.py"), self.run], text=True,
                              capture_output=True, check=False)

    def figures(self):
        folder = os.path.join(self.run, "figures")
        return sorted(os.listdir(folder)) if os.path.isdir(folder) else []

    def test_all_figures(self):
        self.write("history.csv", "time [s],stones [-],energy_kinetic_stones [J]\n0,1,0\n1,2,3\n")
        self.write("stones.csv", "clump [-],shape,x [m],y [m],elongated [-]\n0,a,0,0,1\n5,b,0.3,0,0\n")
        self.write("profile.csv", "sector,radius [m],height [m]\n" + "".join(
            f"{s},{r},{max(0, 0.1 - 0.5 * r)}\n" for s in (0, 1, "all") for r in (0.02, 0.08, 0.14, 0.2)))
        self.write("summary.json", json.dumps({"results": {
            "angle_of_repose_deg": 26.6, "angle_of_repose_scatter_over_azimuths_deg": 0.0,
            "azimuths_with_an_angle": 8, "height_m": 0.09}}))
        with h5py.File(os.path.join(self.run, "clumps.h5"), "w") as file:
            file["f/points"] = np.array([[0, 0, 0.02], [0.01, 0, 0.02], [0.3, 0, 0.02]])
            file["f/radius"], file["f/clump"] = np.full(3, 0.02), np.array([0, 0, 5])
        item = lambda key: f"<DataItem Format='HDF'>clumps.h5:/f/{key}</DataItem>"
        self.write("clumps.xdmf", "<Xdmf><Domain><Grid CollectionType='Temporal'><Grid><Time Value='1'/>"
                   f"<Geometry>{item('points')}</Geometry><Attribute Name='radius'>{item('radius')}</Attribute>"
                   f"<Attribute Name='clump'>{item('clump')}</Attribute></Grid></Grid></Domain></Xdmf>")
        done = self.draw()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.figures(), ["energy.png", "heap.png", "profile.png"])

    def test_absent_fields_leave_the_others(self):
        self.write("history.csv", "time [s],stones [-],energy_kinetic_stones [J]\n0,1,0\n1,2,3\n")
        done = self.draw()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.figures(), ["energy.png"])
        self.assertEqual(done.stdout.count("Left out"), 2)

    def test_folder_without_history(self):
        done = self.draw()
        self.assertEqual(done.returncode, 2)
        self.assertIn("history.csv", done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
