"""The figure script of studies on small made-up tables.

Fails when a figure is not written, when an absent table stops the others, when a study without pairs or curves is not
drawn, or when a folder without runs.csv is not answered with one sentence and status 2.
Run by ctest: apps_study_figures.py APPS_FOLDER
"""

import os
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

SCRIPT = os.path.join(os.path.abspath(sys.argv.pop()), "study_figures.py")
DIFFERENCES = """factor,level,less,measure,n,mean_difference,standard_deviation,half_width_of_interval,mean_of_reference
ribs,soft,"stiff, thick",peak_force_N,3,-10,2,5,100
ribs,soft,"stiff, thick",mean_force_N,1,5,,,50
ribs,soft,"stiff, thick",fluctuation_N,0,,,,
"""
SHARES = """measure,term,kind,degrees_of_freedom,sum_of_squares,variance,share,F,p
peak_force_N,ribs,geogrid,1,4,1,0.25,2,0.3
peak_force_N,filling,filling,2,12,3,0.75,,
peak_force_N,all of geogrid,geogrid,,,1,0.25,,
peak_force_N,all of filling,filling,,,3,0.75,,
"""
INDICES = """measure,factor,kind,variance,first_index,standard_error_of_first,total_index,standard_error_of_total
other,x,set-up,1,0.3,0.01,0.5,0.01
other,filling,filling,1,0.2,0.01,0.4,0.01
"""


class StudyFigures(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = self.temporary.name

    def tearDown(self):
        self.temporary.cleanup()

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def write_curves(self, points):
        with h5py.File(os.path.join(self.folder, "curves.h5"), "w") as file:
            file["displacement"] = np.linspace(0, 0.02, 5)
            file["force"] = np.arange(5.0 * points * 2).reshape(2 * points, 5)
            file["point_of_run"] = np.repeat(np.arange(points), 2).astype(float)
            file["points"] = [f"ribs={k}".encode() for k in range(points)]
            file["n"] = np.full((points, 5), 2.0)
            file["mean"] = np.ones((points, 5))
            file["deviation"] = np.where(np.arange(5) == 4, np.nan, np.ones((points, 5)))

    def draw(self):
        return subprocess.run([SCRIPT, self.folder], capture_output=True, text=True, check=False)

    def drawn(self):
        folder = os.path.join(self.folder, "figures")
        return sorted(os.listdir(folder)) if os.path.isdir(folder) else []

    def test_all_figures(self):
        self.write("runs.csv", "run\n")
        self.write("differences.csv", DIFFERENCES)
        self.write("variance.csv", SHARES)
        self.write_curves(2)
        done = self.draw()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.drawn(), ["curves.png", "differences.png", "variance.png"])

    def test_indices_of_sobol_and_more_points_than_colours(self):
        self.write("runs.csv", "run\n")
        self.write("differences.csv", DIFFERENCES.splitlines()[0] + "\n")
        self.write("variance.csv", INDICES)
        self.write_curves(20)
        done = self.draw()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.drawn(), ["curves.png", "variance.png"])

    def test_tables_alone(self):
        self.write("runs.csv", "run\n")
        self.write("variance.csv", SHARES)
        self.assertEqual(self.draw().returncode, 0)
        self.assertEqual(self.drawn(), ["variance.png"])

    def test_another_folder(self):
        done = self.draw()
        self.assertEqual(done.returncode, 2)
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertIn("runs.csv", done.stderr)


if __name__ == "__main__":
    unittest.main()
