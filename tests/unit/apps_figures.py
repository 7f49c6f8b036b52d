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

import h5py
import numpy as np

SCRIPT = os.path.abspath(sys.argv.pop())


def write_history(folder, rows):
    os.makedirs(folder)
    with open(os.path.join(folder, "history.csv"), "w", encoding="utf-8") as file:
        file.write("time [s],displacement [m],pull_force [N],pull_force_filtered [N],energy_kinetic [J]\n")
        file.write(rows)


def write_series(folder, name, frames):
    """A series as coupling/output/field_output.h describes it; frames: dictionaries data set -> array."""
    grids = ""
    with h5py.File(os.path.join(folder, name + ".h5"), "w") as file:
        for i, frame in enumerate(frames):
            group = f"frame_{i:06d}"
            for key, values in frame.items():
                file[f"{group}/{key}"] = values
            item = lambda key: f"<DataItem Format='HDF'>{name}.h5:/{group}/{key}</DataItem>"
            topology = item("lines") if "lines" in frame else ""
            grids += (f"<Grid><Time Value='{0.5 * i}'/><Geometry>{item('points')}</Geometry>"
                      f"<Topology>{topology}</Topology>")
            for key in frame.keys() - {"points", "lines"}:
                grids += f"<Attribute Name='{key}'>{item(key)}</Attribute>"
            grids += "</Grid>"
    with open(os.path.join(folder, name + ".xdmf"), "w", encoding="utf-8") as file:
        file.write(f"<Xdmf><Domain><Grid CollectionType='Temporal'>{grids}</Grid></Domain></Xdmf>")


def two_stones(way):
    """Stone 7 of two spheres, stone 3 of one; stone 7 has gone `way` along x."""
    points = np.array([[0.1 + way, 0.1, 0.1], [0.12 + way, 0.1, 0.1], [0.3, 0.1, 0.1]])
    gone = np.array([[way, 0, 0], [way, 0, 0], [0, 0, 0]])
    return {"points": points, "radius": np.full(3, 0.02), "clump": np.array([7, 7, 3]), "displacement": gone}


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

    def test_draws_the_fields(self):
        write_history(self.run_folder, "0,0,0,0,0\n0.1,1e-3,100,90,0\n")
        write_series(self.run_folder, "clumps", [two_stones(0), two_stones(0.004)])
        ribs = {"points": np.array([[0.0, 0.1, 0.1], [0.2, 0.1, 0.11]]), "lines": np.array([[0, 1]])}
        write_series(self.run_folder, "geogrid", [ribs, ribs])
        # The first frame has no contact at all.
        contacts = [{"points": np.zeros((0, 3)), "lines": np.zeros((0, 2), int), "force": np.zeros(0),
                     "kind": np.zeros(0)},
                    {**ribs, "force": np.array([5.0]), "kind": np.array([2.0])}]
        write_series(self.run_folder, "contacts", contacts)
        result = draw(self.run_folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_is_png(self.figure("box.png"))
        self.assert_is_png(self.figure("force_chains.png"))

    def test_a_field_that_is_absent_is_named(self):
        write_history(self.run_folder, "0,0,0,0,0\n0.1,1e-3,100,90,0\n")
        frame = two_stones(0)
        del frame["radius"]
        write_series(self.run_folder, "clumps", [frame])
        result = draw(self.run_folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("no field radius", result.stdout)


if __name__ == "__main__":
    unittest.main()
