"""The figure of a force drop, on small made-up frames.

Fails when forces of one pair of bodies are not added as vectors, when the same pair in the other order is taken for
another one, when the push on the front wall or the ribs has another sign or size, when the figure is not written, or
when a folder with nothing to draw is not answered with one sentence and status 2.
Run by ctest: apps_drop_figures.py APPS_FOLDER
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

APPS = os.path.abspath(sys.argv.pop())
SCRIPT = os.path.join(APPS, "drop_figures.py")
sys.path.insert(0, APPS)
import drop_figures
import field_figures

HISTORY = "time [s],displacement [m],pull_force [N]\n" + "".join(
    f"{k / 10},{k / 1000},{100 if k < 5 else 40}\n" for k in range(10))
USED = "subsection Box\nset Length = 0.4\nset Width = 0.2\nset Height = 0.3\nset Slot height = 0.02\nend\n"
DROP = {name: {"displacement_m": u, "force_N": force}
        for name, u, force in (("before", 0.004, 100), ("during", 0.0045, 70), ("after", 0.005, 40))}

# One row a contact: kind, the two bodies, their places, the force on the second one.
CONTACTS = [
    (0, 7, 3, (0.10, 0.1, 0.1), (0.12, 0.1, 0.1), (3, 0, 0)),
    (0, 3, 7, (0.12, 0.1, 0.1), (0.10, 0.1, 0.1), (0, 4, 0)),  # of the same pair: (0, -4, 0) on stone 3
    (1, 7, 5, (0.10, 0.1, 0.1), (0.00, 0.1, 0.1), (-20, 0, 1)),  # the front wall
    (1, 7, 0, (0.10, 0.1, 0.1), (0.10, 0.1, 0.0), (0, 0, -9)),  # the floor
    (2, 7, 1, (0.10, 0.1, 0.1), (0.09, 0.1, 0.15), (30, 0, 0)),
    (2, 7, 1, (0.10, 0.1, 0.1), (0.11, 0.1, 0.15), (10, 0, 0)),
]


def frame_of_contacts(factor):
    kind, first, second, here, there, force = (np.array(column) for column in zip(*CONTACTS))
    n, force = len(CONTACTS), factor * force.astype(float)
    pairs = lambda a, b: np.stack([a, b], axis=1).reshape((2 * n, *a.shape[1:]))
    return {"points": pairs(here, there), "lines": np.arange(2 * n).reshape(n, 2),
            "force": np.linalg.norm(force, axis=1), "kind": kind, "body": pairs(first, second).astype(float),
            "force_on_body": pairs(-force, force)}


def write_series(folder, name, frames):
    """A series as coupling/output/field_output.h describes it."""
    grids = ""
    with h5py.File(os.path.join(folder, name + ".h5"), "w") as file:
        for i, frame in enumerate(frames):
            for key, values in frame.items():
                file[f"frame_{i:06d}/{key}"] = values
            item = lambda key: f"<DataItem>{name}.h5:/frame_{i:06d}/{key}</DataItem>"
            grids += (f"<Grid><Time Value='{i}'/><Geometry>{item('points')}</Geometry>"
                      f"<Topology>{item('lines')}</Topology>")
            for key in frame.keys() - {"points", "lines"}:
                grids += f"<Attribute Name='{key}'>{item(key)}</Attribute>"
            grids += "</Grid>"
    with open(os.path.join(folder, name + ".xdmf"), "w", encoding="utf-8") as file:
        file.write(f"<Xdmf><Domain><Grid>{grids}</Grid></Domain></Xdmf>")


class DropFigures(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.run_folder = os.path.join(scratch.name, "run")
        self.drop = os.path.join(self.run_folder, "drop")
        os.makedirs(self.drop)
        for name, text in (("history.csv", HISTORY), ("used.prm", USED), ("drop/drop.json", json.dumps(DROP))):
            with open(os.path.join(self.run_folder, name), "w", encoding="utf-8") as file:
                file.write(text)
        ribs = {"points": np.array([[-0.02, 0.1, 0.15], [0.2, 0.1, 0.15]]), "lines": np.array([[0, 1]])}
        write_series(self.drop, "geogrid", [ribs] * 3)
        write_series(self.drop, "contacts", [frame_of_contacts(factor) for factor in (1, 0.5, 0.1)])

    def draw(self):
        return subprocess.run([SCRIPT, self.run_folder], capture_output=True, text=True, check=False)

    def test_adds_the_forces_of_a_pair(self):
        network = drop_figures.Network(field_figures.open_series(self.drop, "contacts"), 0)
        self.assertEqual(network.kind.tolist(), [0, 1, 1, 2])
        np.testing.assert_allclose(network.size, [5, 9, np.sqrt(401), 40])
        # From stone 3 to stone 7; on the rib the mean of both places.
        np.testing.assert_allclose(network.ends[0], [[120, 100, 100], [100, 100, 100]])
        np.testing.assert_allclose(network.on_second[0], [-3, 4, 0])
        np.testing.assert_allclose(network.ends[3], [[100, 100, 100], [100, 100, 150]])
        self.assertAlmostEqual(network.on_front(), 20)
        self.assertAlmostEqual(network.on_ribs(), 40)

    def test_draws_the_three_moments(self):
        result = self.draw()
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        with open(os.path.join(self.run_folder, "figures", "force_drop.png"), "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")
        with open(os.path.join(self.run_folder, "summary.json"), "w", encoding="utf-8") as file:
            json.dump({"results": {"not_usable_from_mm": 7}}, file)
        self.assertEqual(self.draw().returncode, 0)
        rows = {line.split()[0]: line for line in result.stdout.splitlines()[1:4]}
        self.assertIn("20.0 N", rows["before"])
        self.assertIn("4.0 N", rows["after"])

    def test_forces_of_the_legend_are_round(self):
        self.assertEqual(drop_figures.round_forces(616), [50, 100, 200, 500])
        np.testing.assert_allclose(drop_figures.round_forces(0.3), [0.02, 0.05, 0.1, 0.2])

    def test_a_line_is_as_wide_as_its_force(self):
        style = drop_figures.line_of([10, 50, 100], 100)
        np.testing.assert_allclose(style["linewidths"], drop_figures.WIDEST * np.array([0.1, 0.5, 1]))

    def test_nothing_to_draw_is_one_sentence(self):
        write_series(self.drop, "contacts", [frame_of_contacts(1)] * 2)
        for change in (lambda: None, lambda: os.remove(os.path.join(self.drop, "contacts.xdmf")),
                       lambda: os.remove(os.path.join(self.drop, "drop.json"))):
            change()
            result = self.draw()
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
            self.assertFalse(os.path.exists(os.path.join(self.run_folder, "figures")))


if __name__ == "__main__":
    unittest.main()
