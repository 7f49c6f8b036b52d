"""The figure script of laboratory tests on a small made-up run.

Fails when a figure is not written, when a folder without history is not answered with one sentence and status 2,
when absent fields stop the other figures, or when a view is drawn in which the piece is a line.
Run by ctest: apps_laboratory_figures.py APPS_FOLDER
"""

import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

APPS = os.path.abspath(sys.argv.pop())
sys.path.insert(0, APPS)
import laboratory_figures

HISTORY = """test,deformation_name,deformation,load_name,load
wide-width tension along,strain [-],0,force_per_width [N/m],0
wide-width tension along,strain [-],0.05,force_per_width [N/m],8500
aperture stability,rotation [rad],0,torque [N m],0
aperture stability,rotation [rad],0.1,torque [N m],2
"""
TABLE = """quantity,unit,measured,stated
"wide-width tension, along, force at 2 %",kN/m,4.1,4.0
"mass per area",kg/m2,0.13,
"""


class Figures(unittest.TestCase):
    def run_script(self, folder):
        return subprocess.run([os.path.join(APPS, "laboratory_figures.py"), folder],
                              capture_output=True, text=True)

    def test_curves_without_fields(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("history.csv", HISTORY), ("table.csv", TABLE)):
                with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
                    file.write(text)
            answer = self.run_script(folder)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            self.assertTrue(os.path.isfile(os.path.join(folder, "figures", "curves.png")))
            self.assertIn("left out", answer.stdout)

    def test_folder_without_history(self):
        with tempfile.TemporaryDirectory() as folder:
            answer = self.run_script(folder)
            self.assertEqual(answer.returncode, 2)
            self.assertEqual(answer.stderr.count("\n"), 1)

    def test_stated_forces_belong_to_their_test(self):
        rows = [{"quantity": "wide-width tension, along, force at 2 %", "stated": "4.0"},
                {"quantity": "mass per area", "stated": ""}]
        self.assertEqual(laboratory_figures.stated_forces(rows), {"wide-width tension along": [(2.0, 4.0)]})

    def test_views(self):
        flat = np.array([[0, 0, 0], [1, 1, 0]], dtype=float)
        hanging = np.array([[0, 0, 0], [1, 0, -1]], dtype=float)
        self.assertEqual(laboratory_figures.views_of(flat), ["plan"])
        self.assertEqual(laboratory_figures.views_of(hanging), ["side"])
        self.assertEqual(laboratory_figures.views_of(np.concatenate([flat, hanging])), ["plan", "side"])


if __name__ == "__main__":
    unittest.main()
