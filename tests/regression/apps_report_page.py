"""report.html of a whole small run, opened in a browser as a reader does: from disk, without a network.

Fails when a run leaves no page, when stones are drawn elsewhere, turned otherwise or with another surface than they
have, when the page has an error, when the slider or a key does not move stones, geogrid and curves, when a click names
another stone than the one that lies there, when the page does not fit a phone, or
shows nothing without WebGL.
What is right is read from the state on disk (checkpoint.h5), which the page's stones are not placed from.
Run by ctest: apps_report_page.py PROGRAM
"""

import os
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
PROGRAM = os.path.abspath(sys.argv.pop())
sys.path[:0] = [os.path.dirname(HERE), os.path.join(HERE, "..", "..", "apps")]
import field_series
import report_stones
from page_in_browser import PHONE, Browser

# Places and attitudes of all stones as the page unpacks them, in the last frame.
POSES = """
const {replay} = report, stones = replay.stones, last = report.moments.length - 1, poses = [];
for (let i = 0; i < stones.count; ++i) {
  const matrix = stones.matrix(last, i, new THREE.Matrix4());
  poses.push([replay.data.stones.ids[i], stones.isThere(last, i), matrix.elements]);
}
return poses;"""
# The product of projection and view, by columns, and the canvas in the page.
CAMERA = """
const {camera, canvas} = report.replay.scene, box = canvas.getBoundingClientRect();
camera.updateMatrixWorld();
const all = new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
return [all.elements, box.left, box.top, box.width, box.height];"""


def misfit(points, centres, radii):
    """The root mean square distance of points from the surface of the spheres [m]."""
    return np.sqrt(np.mean(np.min(np.linalg.norm(points[:, None] - centres, axis=2) - radii.ravel(), axis=1) ** 2))


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.run_folder = os.path.join(cls.temporary.name, "run")
        ending = subprocess.run([PROGRAM, "run", os.path.join(HERE, "tiny_pull_out.prm"), "--output", cls.run_folder],
                                capture_output=True, text=True)
        assert ending.returncode == 0, ending.stdout + ending.stderr
        cls.page = os.path.join(cls.run_folder, "report.html")
        with h5py.File(os.path.join(cls.run_folder, "checkpoint.h5"), "r") as state:
            clumps = state[report_stones.CLUMPS]
            cls.ids, cls.position, cls.attitude = (clumps[name][:] for name in ("id", "position", "orientation"))
            cls.unit_inertia = [clumps[f"shapes/{k}/unit_inertia"][0] for k in range(6)]
            cls.spheres = [tuple(clumps[f"shapes/{k}/spheres/{name}"][:] for name in ("centre", "radius")) for k in range(6)]
            cls.volume = [clumps[f"shapes/{k}/volume"][0] for k in range(6)]
        cls.ids = cls.ids.ravel().astype(int)
        cls.browser = Browser()
        cls.browser.open(cls.page)

    @classmethod
    def tearDownClass(cls):
        cls.browser.driver.quit()
        cls.temporary.cleanup()

    def setUp(self):
        self.browser.run("report.show(report.moments.length - 1); report.replay.cut.axis = 'off'; report.replay.update();")

    def test_no_complaints_and_one_file(self):
        self.assertEqual(self.browser.complaints(), [])
        self.assertEqual(self.browser.run("return performance.getEntriesByType('resource').length"), 0)
        self.assertFalse(os.path.exists(self.page + ".part"))

    def test_stones_are_where_they_are(self):
        poses = {pose[0]: np.reshape(pose[2], (4, 4)).T for pose in self.browser.run(POSES) if pose[1]}
        self.assertEqual(sorted(poses), sorted(self.ids.tolist()))
        for stone, place, quaternion in zip(self.ids, self.position, self.attitude):
            matrix = poses[stone]
            # Steps of 16 bits over a box of some 0.2 m; frames are in single precision.
            np.testing.assert_allclose(matrix[:3, 3], place, atol=1e-5)
            axes = np.stack([report_stones.rotated(quaternion[None], axis)[0] for axis in np.eye(3)], axis=1)
            np.testing.assert_allclose(matrix[:3, :3], axes, atol=1e-3)

    def test_surfaces_are_those_of_the_stones(self):
        shapes = self.browser.run("""return report.replay.stones.fine.map((shape) =>
            [Array.from(shape.attributes.position.array), Array.from(shape.index.array)]);""")
        self.assertIn("their own closed surfaces", self.browser.run("return document.getElementById('about').textContent"))
        for (vertices, triangles), volume, inertia, spheres in zip(shapes, self.volume, self.unit_inertia, self.spheres):
            corners = np.reshape(vertices, (-1, 3))[np.reshape(triangles, (-1, 3))]
            parts = np.linalg.det(corners) / 6  # signed tetrahedra
            self.assertLessEqual(len(corners), 330)
            self.assertAlmostEqual(parts.sum() / volume, 1, delta=0.03)  # decimated
            centre = (parts[:, None] * corners.sum(axis=1) / 4).sum(axis=0) / parts.sum()
            self.assertLess(np.linalg.norm(centre), 0.03 * volume ** (1 / 3))  # the body frame begins there
            second = np.einsum("t,tik,til->kl", parts / 20, corners, corners) + np.einsum(
                "t,tk,tl->kl", parts / 20, corners.sum(axis=1), corners.sum(axis=1))
            moments = np.trace(second) * np.eye(3) - second
            np.testing.assert_allclose(np.diag(moments), inertia, rtol=0.06)  # along its axes
            self.assertLess(np.abs(moments - np.diag(np.diag(moments))).max(), 0.06 * inertia.max())

            # Half a turn about an axis of the body keeps all of that, but not how far the spheres are from the surface.
            misfits = [misfit(np.reshape(vertices, (-1, 3)) * turn, *spheres)
                       for turn in ([1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1])]
            self.assertEqual(np.argmin(misfits), 0, misfits)

    def test_slider_moves_stones_geogrid_and_curves(self):
        what = """return [Array.from(report.replay.stones.centre), Array.from(report.replay.ribs.mesh.geometry.attributes.position.array),
                          document.getElementById('now').textContent];"""
        last = self.browser.run(what)
        self.browser.run("""const slider = document.getElementById('slider');
            slider.value = 0; slider.dispatchEvent(new Event('input')); slider.dispatchEvent(new Event('change'));""")
        first = self.browser.run(what)
        self.assertGreater(np.abs(np.subtract(first[0], last[0])).max(), 1e-4)
        # Pulled by 3 mm towards -x.
        self.assertAlmostEqual(np.min(first[1][0::3]) - np.min(last[1][0::3]), 3e-3, delta=2e-4)
        self.assertIn("0.0 mm", first[2])
        self.assertIn("3.0 mm", last[2])
        self.browser.key("ArrowRight")
        self.assertIn("frame 2 of 4", self.browser.run(what)[2])
        self.browser.key("End")
        self.assertEqual(self.browser.run(what), last)

    def test_pictures_are_of_the_present_frame_whatever_was_before(self):
        # Frames that are passed without being drawn, from fine stones to coarse ones and back.
        same = self.browser.run("""const {replay, show, moments} = report, {scene} = replay, {copies} = replay.stones;
            const gl = scene.renderer.getContext(), size = 4 * gl.drawingBufferWidth * gl.drawingBufferHeight;
            const picture = () => {
              const pixels = new Uint8Array(size);
              scene.drawNow();
              gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
              return pixels;
            };
            return [true, false].map((isMoving) => {
              replay.cut.axis = "y";
              replay.move(!isMoving);
              show(0);
              picture();
              replay.move(isMoving);
              replay.cut.at = 0.9;  // few stones
              replay.update();
              replay.cut.axis = "off";
              show(moments.length - 1);
              const found = picture();
              for (const attribute of copies.attributes) {  // all of it to the renderer again
                attribute.updateRange.count = -1;
                attribute.needsUpdate = true;
              }
              const expected = picture();
              replay.move(false);
              return expected.some((value, i) => value !== expected[0]) && found.every((value, i) => value === expected[i]);
            });""")
        self.assertEqual(same, [True, True])

    def test_a_click_on_a_curve_goes_there(self):
        box = self.browser.run("""const {chartArea: area, canvas} = report.data.charts[0].drawn;
            canvas.scrollIntoView({block: 'center'});
            const {left, top} = canvas.getBoundingClientRect();
            return [left + area.left, left + area.right, top + 0.5 * (area.top + area.bottom)];""")
        self.browser.click(box[0] + 0.35 * (box[1] - box[0]), box[2])  # of 0 to 3 mm: 1 mm is nearest
        self.assertTrue(self.browser.waits_for("return document.getElementById('now').textContent.startsWith('1.0 mm')"))
        self.browser.run("window.scrollTo(0, 0)")

    def test_a_click_names_the_stone_that_lies_there(self):
        for view in ("1", "2", "3", "0"):
            self.browser.key(view)
            elements, left, top, width, height = self.browser.run(CAMERA)
            camera = np.reshape(elements, (4, 4)).T
            seen = np.concatenate([self.position, np.ones((len(self.ids), 1))], axis=1) @ camera.T
            nearest = int(np.argmin(seen[:, 3]))  # nothing is in front of the middle of the stone nearest to the eye
            x, y = seen[nearest, :2] / seen[nearest, 3]
            self.browser.click(left + 0.5 * width * (1 + x), top + 0.5 * height * (1 - y))
            told = self.browser.run("return document.getElementById('stone').innerText")
            self.assertTrue(told.startswith(f"Stone {self.ids[nearest]} "), (view, told))
        self.browser.key("Escape")
        self.assertTrue(self.browser.run("return document.getElementById('stone').hidden"))

    def test_contacts_of_a_stone(self):
        series = field_series.open_series(self.run_folder, "contacts")
        frame = len(series) - 1
        bodies, kind = series.attribute(frame, "body")[series.lines(frame)], series.attribute(frame, "kind")
        stone = int(bodies[0, 0])
        expected = [int(np.sum((kind == k) & ((bodies[:, 0] == stone) | ((k == 0) & (bodies[:, 1] == stone)))))
                    for k in range(3)]
        found = self.browser.run("""const {replay} = report;
            return replay.contacts.count(report.moments.length - 1, replay.data.stones.ids.indexOf(arguments[0]));""", stone)
        self.assertEqual(found, expected)

    def test_keys_change_what_is_shown(self):
        shown = "return [report.replay.stones.mode, report.replay.contacts.mesh.visible, report.replay.byWay, report.replay.cut.axis]"
        self.assertEqual(self.browser.run(shown), ["solid", False, False, "off"])
        for key in "cwk":
            self.browser.key(key)
        self.assertEqual(self.browser.run(shown), ["faint", True, True, "y"])
        self.assertIn("contact force [N]", self.browser.run("return document.getElementById('legends').innerText"))
        for key in "cw":
            self.browser.key(key)
        self.assertEqual(self.browser.run(shown), ["solid", False, False, "y"])

    def test_without_webgl_the_rest_is_there(self):
        with Browser(more=["--disable-3d-apis"]) as browser:
            browser.open(self.page)
            self.assertIn("needs WebGL", browser.run("return document.getElementById('replay').innerText"))
            self.assertGreater(browser.run("return document.querySelectorAll('.chart canvas').length"), 1)
            browser.key("End")
            self.assertIn("3.0 mm", browser.run("return document.getElementById('now').textContent"))

    def test_fits_a_phone(self):
        with Browser(PHONE, is_dark=True) as phone:
            phone.open(self.page)
            self.assertEqual(phone.complaints(), [])
            self.assertLessEqual(phone.run("return document.documentElement.scrollWidth"), PHONE[0])
            self.assertNotEqual(phone.run("return getComputedStyle(document.body).backgroundColor"), "rgb(255, 255, 255)")


if __name__ == "__main__":
    unittest.main()
