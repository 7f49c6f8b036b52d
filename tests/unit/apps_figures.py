"""The figure script on a small made-up run.

Fails when a figure is not written, when a folder without history is not answered with one sentence and
status 2, when an absent field stops the other figures, or when a half-written last line does.
Run by ctest: apps_figures.py FIGURES_SCRIPT
"""

import os
import subprocess
import sys
import tempfile
import unittest

SCRIPT = os.path.abspath(sys.argv.pop())


def write_history(folder, rows):
    os.makedirs(folder)
    with open(os.path.join(folder, "history.csv"), "w", encoding="utf-8") as file:
        file.write("time [s],displacement [m],pull_force [N],pull_force_filtered [N],energy_kinetic [J]\n")
        file.write(rows)


def draw(*arguments):
    return subprocess.run(["/usr/bin/python3", SCRIPT, *arguments], capture_output=True, text=True, check=False)


class Figures(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.run_folder = os.path.join(self.scratch.name, "one")

    def figure(self, name):
        return os.path.join(self.run_folder, "figures", name)

    def assert_is_png(self, path):
        with open(path, "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")

    def test_draws_what_there_is_and_names_what_is_absent(self):
        write_history(self.run_folder, "0,0,0,0,1e-3\n0.1,1e-3,100,90,2e-3\n0.2,2e-3,150,130,1e-3\n0.3,3e-")
        result = draw(self.run_folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_is_png(self.figure("force_displacement.png"))
        self.assert_is_png(self.figure("energy.png"))
        self.assertFalse(os.path.exists(self.figure("box.png")))
        self.assertIn("Left out " + self.figure("box.png"), result.stdout)
        self.assertIn("Left out " + self.figure("force_chains.png"), result.stdout)

    def test_compares_runs_in_one_figure(self):
        other = os.path.join(self.scratch.name, "two")
        for folder in (self.run_folder, other):
            write_history(folder, "0,0,0,0,0\n0.1,1e-3,100,90,0\n")
        target = os.path.join(self.scratch.name, "both.png")
        result = draw(self.run_folder, other, "-o", target, "--label", "rigid", "--label", "flexible")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_is_png(target)

    def test_a_folder_without_history_is_answered_with_a_sentence(self):
        os.makedirs(self.run_folder)
        result = draw(self.run_folder)
        self.assertEqual(result.returncode, 2)
        self.assertIn("there is no history.csv", result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
