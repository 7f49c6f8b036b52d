"""The figure scripts of strength tests on small made-up runs.

Fails when a figure is not written, when a folder without history or another test is not answered with one sentence
and status 2, when a running test stops the other figures, or when fillings of one series are not averaged, or mixed up.
Run by ctest: apps_strength_figures.py APPS_FOLDER
"""

import csv
import json
import os
import subprocess
import sys
import tempfile
import unittest

APPS = os.path.abspath(sys.argv.pop())
FIGURE = os.path.join(APPS, "..", "cases", "ballast", "figure.py")
HISTORY = """time [s],displacement [m],shear_force [N],normal_force [N],friction_ratio [-],dilation [m],energy_friction [J]
0,0,0,100,0,0,0
1,0.01,80,100,0.8,-0.001,1
2,0.02,90,100,0.9,0.002,2
"""
TRIAXIAL_HISTORY = """time [s],axial_strain [-],axial_stress [Pa],stress_x [Pa],stress_y [Pa],stress_ratio [-],volume_change [-],height [m],energy_friction [J]
0,0,3e4,3e4,3e4,1,0,0.3,0
1,0.01,1e5,3e4,3e4,3.33,0.01,0.297,1
2,0.02,1.2e5,3e4,3e4,4,0.02,0.294,2
"""
TRIAXIAL_RESULTS = {"residual_friction_angle_deg": 37, "dilation_angle_at_peak_deg": 20, "strain_at_peak": 0.02,
                    "secant_stiffness_Pa": 4e7, "volume_change_at_end": 0.02, "porosity": 0.43,
                    "porosity_at_end": 0.46, "spheres_per_stone": 55, "cell_pressure_Pa": 3e4,
                    "not_usable_from_mm": 3}
RESULTS = {"peak_friction_angle_of_applied_load_deg": 46, "residual_friction_angle_deg": 40,
           "dilation_angle_at_peak_deg": 9, "displacement_at_peak_m": 0.01, "secant_stiffness_Pa_per_m": 4e6,
           "volume_change_at_end": 0.01, "porosity": 0.47, "spheres_per_stone": 55, "normal_stress_Pa": 1e4,
           "mean_normal_stress_Pa": 1.01e4, "mean_stone_size_m": 0.035}


def write_run(folder, peak=None, seed=1, history=HISTORY):
    os.makedirs(folder)
    with open(os.path.join(folder, "history.csv"), "w", encoding="utf-8") as file:
        file.write(history)
    with open(os.path.join(folder, "used.prm"), "w", encoding="utf-8") as file:
        file.write("set Experiment = shear box\nsubsection Contact\n set Stone friction = 0.6\nend\n"
                   "subsection Filling\n set Stone friction = 0.1\nend\nsubsection Load\n set Normal stress = 1e4\nend\n")
    if peak is not None:
        with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as file:
            json.dump({"experiment": "shear box", "seed": seed,
                       "results": {**RESULTS, "peak_friction_angle_deg": peak}}, file)


def write_triaxial(folder, peak=None, seed=1, compaction=0):
    os.makedirs(folder)
    with open(os.path.join(folder, "history.csv"), "w", encoding="utf-8") as file:
        file.write(TRIAXIAL_HISTORY)
    with open(os.path.join(folder, "used.prm"), "w", encoding="utf-8") as file:
        file.write("set Experiment = triaxial\nsubsection Contact\n set Stone friction = 0.6\nend\n"
                   "subsection Filling\n set Stone friction = 0.1\nend\nsubsection Load\n set Cell pressure = 3e4\n"
                   f" set Compaction stress = {compaction}\nend\n")
    if peak is not None:
        with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as file:
            json.dump({"experiment": "triaxial", "seed": seed,
                       "results": {**TRIAXIAL_RESULTS, "peak_friction_angle_deg": peak}}, file)


def run(script, *words):
    return subprocess.run(["/usr/bin/python3", "-I", script, *words], capture_output=True, text=True)


class StrengthFigures(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.run_folder = os.path.join(self.temporary.name, "run")

    def draw(self, script="strength_figures.py"):
        return run(os.path.join(APPS, script), self.run_folder)

    def test_finished_run(self):
        write_run(self.run_folder, peak=45)
        answer = self.draw()
        self.assertEqual(answer.returncode, 0, answer.stderr)
        for name in ("curves.png", "strength.png", "energy.png"):
            self.assertTrue(os.path.isfile(os.path.join(self.run_folder, "figures", name)), name)

    def test_running_test(self):
        write_run(self.run_folder)
        answer = self.draw()
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("not finished", answer.stdout)
        self.assertTrue(os.path.isfile(os.path.join(self.run_folder, "figures", "curves.png")))

    def test_other_folders(self):
        self.assertEqual(self.draw().returncode, 2)
        write_run(self.run_folder, history="time [s],displacement [m]\n0,0\n1,1\n")
        answer = self.draw()
        self.assertEqual(answer.returncode, 2)
        self.assertIn("not a shear box test", answer.stderr.replace("\n", " "))

    def test_triaxial(self):
        write_triaxial(self.run_folder)
        answer = self.draw("triaxial_figures.py")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("not finished", answer.stdout)
        self.run_folder += "_finished"
        write_triaxial(self.run_folder, peak=43)
        self.assertEqual(self.draw("triaxial_figures.py").returncode, 0)
        for name in ("curves.png", "strength.png", "energy.png"):
            self.assertTrue(os.path.isfile(os.path.join(self.run_folder, "figures", name)), name)
        self.assertEqual(self.draw().returncode, 2)  # no shear box

    def test_triaxial_fillings_are_averaged(self):
        runs = [os.path.join(self.temporary.name, name) for name in ("one", "two", "tamped", "box")]
        write_triaxial(runs[0], peak=42, seed=1)
        write_triaxial(runs[1], peak=44, seed=2)
        write_triaxial(runs[2], peak=48, compaction=1e5)
        write_run(runs[3], peak=48)
        answer = run(FIGURE, *runs, "-o", self.temporary.name)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("| 55 | 0.6 | dense | 30 | 2 | 43.0 ± 1.4 |", answer.stdout)
        self.assertIn("| 55 | 0.6 | tamped | 30 | 1 | 48.0 |", answer.stdout)
        self.assertIn("box: it is a shear box test", answer.stdout)

    def test_fillings_are_averaged(self):
        runs = [os.path.join(self.temporary.name, name) for name in ("one", "two")]
        write_run(runs[0], peak=44, seed=1)
        write_run(runs[1], peak=48, seed=2)
        answer = run(FIGURE, *runs, "-o", self.temporary.name)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertIn("| 55 | 0.6 | dense | 10 | 2 | 46.0 ± 2.8 |", answer.stdout)
        with open(os.path.join(self.temporary.name, "strength.csv"), newline="", encoding="utf-8") as file:
            self.assertEqual([row["seed"] for row in csv.DictReader(file)], ["1", "2"])
        self.assertTrue(os.path.isfile(os.path.join(self.temporary.name, "strength.png")))


if __name__ == "__main__":
    unittest.main()
