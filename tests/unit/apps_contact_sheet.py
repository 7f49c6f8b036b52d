"""Pictures of stones and clumps against what is known of simple bodies.

Fails when a ball or a box is not drawn where it is and as large as it is, when what is behind shows, when
a sheet is not written, or when a folder without stones is not answered with one sentence and status 2.
Run by ctest: apps_contact_sheet.py APPS_FOLDER
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np

APPS = os.path.abspath(sys.argv.pop())
sys.dont_write_bytecode = True
sys.path.insert(0, APPS)
import stone_pictures as pictures

FRONT = np.eye(3)


def box(sides):
    """Triangles of a box around the origin, outward."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * np.array(sides) / 2
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return np.array([corners[[q[0], q[i], q[i + 1]]] for q in quads for i in (1, 2)])


def write_stl(path, triangles):
    fields = [("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]
    record = np.zeros(len(triangles), fields)
    record["corners"] = triangles
    with open(path, "wb") as file:
        file.write(bytes(80) + np.uint32(len(triangles)).tobytes() + record.tobytes())


def covered(picture):
    return (picture < 0.995).any(axis=2)


class Renderer(unittest.TestCase):
    def test_a_ball_covers_its_disc(self):
        picture = pictures.draw_spheres(np.array([[0.01, 0, 0, 0.02]]), FRONT, 200, 200, 2000)
        rows, columns = np.nonzero(covered(picture))
        self.assertAlmostEqual(len(rows) / (np.pi * 40 ** 2), 1, delta=0.05)
        self.assertAlmostEqual(columns.mean(), 100 + 20, delta=1)

    def test_a_box_covers_its_face_and_keeps_its_place(self):
        picture = pictures.draw_mesh(box([0.04, 0.02, 0.03]), FRONT, 200, 200, 2000, centre=(0, 0.01, 0))
        rows, columns = np.nonzero(covered(picture))
        self.assertAlmostEqual(len(rows) / (80 * 40), 1, delta=0.03)
        self.assertAlmostEqual(rows.mean(), 100 + 20, delta=1)  # y runs up, rows run down

    def test_the_nearer_ball_hides_the_other(self):
        near, far = [0, 0, 0.05, 0.02], [0, 0, -0.05, 0.02]
        alone = pictures.draw_spheres(np.array([near]), FRONT, 100, 100, 2000)
        for order in ([near, far], [far, near]):
            both = pictures.draw_spheres(np.array(order), FRONT, 100, 100, 2000)
            self.assertTrue(np.array_equal(both, alone))

    def test_moments_turn_the_longest_side_to_x(self):
        centre, axes = pictures.mesh_moments(box([0.02, 0.04, 0.03]) + [1, 2, 3])
        self.assertTrue(np.allclose(centre, [1, 2, 3]))
        self.assertTrue(np.allclose(np.abs(axes), [[0, 1, 0], [0, 0, 1], [1, 0, 0]]))


class Sheet(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)

    def draw(self, *arguments):
        script = os.path.join(APPS, "contact_sheet.py")
        return subprocess.run([script, *arguments], capture_output=True, text=True,
                              check=False, cwd=self.scratch.name)

    def test_draws_stones_with_and_without_a_clump(self):
        folder = os.path.join(self.scratch.name, "stones")
        os.makedirs(folder)
        for name in ("a", "b"):
            write_stl(os.path.join(folder, name + ".stl"), box([0.05, 0.04, 0.03]))
        with open(os.path.join(folder, "a.clump.json"), "w", encoding="utf-8") as file:
            json.dump({"name": "a", "spheres_x_y_z_r_m": [[0, 0, 0, 0.015], [0.01, 0, 0, 0.015]]}, file)
        done = self.draw("stones", "-o", "sheet.png")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(os.path.getsize(os.path.join(self.scratch.name, "sheet.png")), 1000)

    def test_a_folder_without_stones_is_one_sentence(self):
        done = self.draw(self.scratch.name)
        self.assertEqual(done.returncode, 2)
        self.assertIn("no *.stl file", done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
