"""The program that makes report.html, on small made-up runs, without a browser.

Fails when an attitude is not the rotation that spheres were given, when a place is off by more than half a step, when the
surface of spheres is open or off, when a run without frames, without a state or without a package breaks instead of
saying why, when text of the user can end the script that carries it, or when a page that cannot be written takes the
old one with it.
Run by ctest: apps_report.py APPS_FOLDER
"""

import base64
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

APPS = os.path.abspath(sys.argv.pop())
sys.path.insert(0, APPS)
import report
import report_curves
import report_replay
import report_stones
import report_surfaces
import report_text

HISTORY = "time [s],displacement [m],pull_force [N]\n0,0,0\n0.1,1e-3,100\n0.2,2e-3,150\n"
PARAMETERS = "set Experiment = pull-out\nsubsection Pull\n  set Speed = 1 # </script><b>\nend\n"


def made_up_run(folder):
    run = os.path.join(folder, "a <b> run")
    os.makedirs(run)
    for name, text in (("history.csv", HISTORY), ("used.prm", PARAMETERS)):
        with open(os.path.join(run, name), "w", encoding="utf-8") as file:
            file.write(text)
    return run


def page_of(run):
    with open(os.path.join(run, "report.html"), encoding="utf-8") as file:
        return file.read()


def data_of(page):
    return json.loads(re.search(r'<script id="data" type="application/json">(.*?)</script>', page, re.DOTALL).group(1))


def make(run):
    return subprocess.run([os.path.join(APPS, "report.py"), run], capture_output=True, text=True)


class Poses(unittest.TestCase):
    def test_rotations_come_back(self):
        random = np.random.default_rng(1)
        body = random.normal(size=(7, 3))
        attitudes = random.normal(size=(50, 4))
        attitudes /= np.linalg.norm(attitudes, axis=1)[:, None]
        places = random.normal(size=(50, 3))
        world = np.stack([places + report_stones.rotated(attitudes, point) for point in body], axis=1)
        found_places, found = report_stones.fit(body, world)
        np.testing.assert_allclose(found_places, places, atol=1e-12)
        np.testing.assert_allclose(np.abs(np.sum(found * attitudes, axis=1)), 1, atol=1e-12)  # q and -q are one rotation

    def test_half_a_turn_and_none(self):
        body = np.array([[0.0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3]])
        world = np.stack([body, body * [1, -1, -1]])
        _, found = report_stones.fit(body, world)
        np.testing.assert_allclose(np.abs(found), [[0, 0, 0, 1], [1, 0, 0, 0]], atol=1e-12)

    def test_steps(self):
        low, high = np.array([-0.1, 0, 2]), np.array([0.3, 0.2, 2.3])
        steps = report_replay.Steps(low, high)
        points = np.random.default_rng(2).uniform(low, high, (100, 3))
        packed = steps.of(points)
        numbers = np.frombuffer(base64.b64decode(packed["data"]), dtype="<u2").reshape(-1, 3)
        np.testing.assert_allclose(low + steps.step * numbers, points, atol=0.5001 * 0.4 / 65535)


class Ribs(unittest.TestCase):
    def test_section(self):
        plain = {"Geogrid/Rib width": "0.005", "Geogrid/Rib thickness": "0.0025"}
        self.assertEqual(report_replay.section_of_ribs(plain), {"width": 0.005, "thickness": 0.0025})
        product = {"Geogrid/Rib width": "0", "Geogrid/Rib thickness": "0", "Product/Pitch along": "0.065",
                   "Product/Rib width along": "0.004", "Product/Rib thickness along": "0.0017"}
        self.assertEqual(report_replay.section_of_ribs(product), {"width": 0.004, "thickness": 0.0017})


class Surfaces(unittest.TestCase):
    def test_ball_is_closed(self):
        for halvings, count in ((1, 80), (2, 320)):
            points, triangles = report_surfaces.ball(halvings)
            self.assertEqual(len(triangles), count)
            edges = {(int(t[i]), int(t[(i + 1) % 3])) for t in triangles for i in range(3)}
            self.assertEqual(len(edges), 3 * count)
            self.assertEqual(edges, {(b, a) for a, b in edges})
            self.assertGreater((np.linalg.det(points[triangles])).min(), 0)  # outward

    def test_two_spheres(self):
        shape = {"centres": np.array([[-1.0, 0, 0], [1, 0, 0]]), "radii": np.array([1.5, 1.5])}
        points, _ = report_surfaces.surface_of_spheres(shape, 2)
        off = np.linalg.norm(points[:, None] - shape["centres"], axis=2) - 1.5
        np.testing.assert_allclose(off.min(axis=1), 0, atol=1e-12)

    def test_only_what_fits_the_shape_is_taken(self):
        ball = report_surfaces.ball(1)
        mesh = {"vertices": ball[0].ravel().tolist(), "triangles": ball[1].ravel().tolist()}
        made = [{"name": "a", "volume": 4.0, "fine": mesh, "coarse": mesh}]
        shapes = [{"name": "a", "volume": volume, "centres": np.zeros((1, 3)), "radii": np.ones(1)} for volume in (4.0, 4.1)]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "made.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(made, file)
            self.assertEqual([surface.is_own for surface in report_surfaces.surfaces(shapes, path)], [True, False])


class Page(unittest.TestCase):
    def test_without_frames(self):
        with tempfile.TemporaryDirectory() as folder:
            run = made_up_run(folder)
            answer = make(run)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            data = data_of(page_of(run))
            self.assertIn("has written no frames", data["replay"]["missing"])
            self.assertIn("no replay", answer.stdout)
            self.assertFalse(data["finished"])
            self.assertEqual(data["charts"][0]["series"][0]["y"], [0, 100, 150])
            self.assertEqual(data["charts"][0]["place"], [0, 1, 2])  # mm
            self.assertIn("doi:10.1007", data["cite"])

    def test_text_of_the_user_stays_text(self):
        with tempfile.TemporaryDirectory() as folder:
            run = made_up_run(folder)
            make(run)
            page = page_of(run)
            self.assertEqual(data_of(page)["inputs"], PARAMETERS)
            self.assertNotIn("<b>", page)
            self.assertIn("<title>Pull-out: a &lt;b&gt; run</title>", page)
            self.assertNotIn("http://" + "localhost", page)
            self.assertIsNone(re.search(r'(src|href)="?(https?:)?//', page))

    def test_folder_without_history(self):
        with tempfile.TemporaryDirectory() as folder:
            answer = make(folder)
            self.assertEqual(answer.returncode, 2)
            self.assertEqual(answer.stderr.count("\n"), 1)
            self.assertEqual(os.listdir(folder), [])

    def test_without_packages(self):
        with tempfile.TemporaryDirectory() as folder:
            run, libraries = made_up_run(folder), report.LIBRARIES
            data = report_text.texts(run, "pull-out", {}, {})
            data.update(charts=[], replay={"times": []})
            report.LIBRARIES = folder
            try:
                report.write(run, data)
            finally:
                report.LIBRARIES = libraries
            found = data_of(page_of(run))
            self.assertIn("libjs-three", found["replay"]["missing"])
            self.assertIn("libjs-chart.js", found["no_charts"])

    def test_a_page_that_cannot_be_written_leaves_the_old_one(self):
        with tempfile.TemporaryDirectory() as folder:
            run = made_up_run(folder)
            make(run)
            old = page_of(run)
            os.mkdir(os.path.join(run, "report.html.part"))  # in the way of the new one
            answer = make(run)
            self.assertEqual(answer.returncode, 1)
            self.assertEqual(answer.stderr.count("\n"), 1)
            self.assertEqual(page_of(run), old)

    def test_results_in_words(self):
        for name, value, row in (("peak_pull_force_N", 1067.04, ["peak pull force", "1067", "N"]),
                                 ("largest_overlap_m", 1.7e-4, ["largest overlap", "0.17", "mm"]),
                                 ("peak_pull_force_N", 126100.0, ["peak pull force", "126.1", "kN"]),
                                 ("normal_stress_Pa", 1e4, ["normal stress", "10", "kPa"]),
                                 ("bulk_density_kg_per_m3", 1410.0, ["bulk density", "1410", "kg/m³"]),
                                 ("rigid", True, ["rigid", "yes", ""])):
            self.assertEqual(report_text.result_row(name, value), row)

    def test_ledger_shows_changes_that_can_be_seen(self):
        history = {"time": np.array([0.0, 1]), "energy_friction": np.array([1.0, 11]),
                   "energy_kinetic_stones": np.array([0, 0.01]), "energy_relative_error": np.array([0, 1e-3])}
        (chart,) = report_curves.ledger(history, history["time"], "time [s]")
        self.assertEqual([(series["label"], series["y"]) for series in chart["series"]], [("friction", [0, 10])])


if __name__ == "__main__":
    unittest.main()
