"""The figure script on a small made-up run.

Fails when a figure is not written, when a folder without history is not answered with one sentence and
status 2, when an absent field stops the other figures, or when a half-written last line does; when anything in
the user's environment changes a pixel; when a straight line is not its own mean; when a case that is not the
paper's is held against the paper's laboratory; or when a part that is not to be used is not marked.
Run by ctest: apps_figures.py FIGURES_SCRIPT
"""

import hashlib
import json
import os
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy as np

SCRIPT = os.path.abspath(sys.argv.pop())
sys.path.insert(0, os.path.dirname(SCRIPT))
import figures

# What the paper's laboratory tested, and what a run writes of it.
PAPERS_CASE = """
set Experiment = pull-out
subsection Box
  set Length = 0.4
  set Width = 0.2
  set Height = 0.3
end
subsection Geogrid
  set Rigid = false
  set Apertures along = 6
  set Apertures across = 3
  set Pitch along = 0.065
  set Pitch across = 0.065
  set Rib width = 0.005
  set Rib thickness = 0.0025
  set Youngs modulus = 2.4e9
end
subsection Surcharge
  set Force = 500
end
subsection Pull
  set Speed = 0.01
end
"""


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


def draw(*arguments, **how):
    """By the script's first line, as a user starts it."""
    return subprocess.run([SCRIPT, *arguments], capture_output=True, text=True, check=False, **how)


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


class Environment(unittest.TestCase):
    """What users have in their shells: none of it may change a pixel or say a word."""

    def test_changes_nothing(self):
        with tempfile.TemporaryDirectory() as scratch:
            run, foreign, home = (os.path.join(scratch, name) for name in ("run", "foreign", "home"))
            write_history(run, "0,0,0,0,1e-3\n0.1,1e-3,100,90,2e-3\n0.2,2e-3,150,130,1e-3\n")
            os.makedirs(os.path.join(home, ".config", "matplotlib"))
            # A numpy for another Python, and a module of the name of one that the script imports.
            os.makedirs(os.path.join(foreign, "numpy"))
            for module in ("numpy/__init__.py", "figures.py", "plain_matplotlib.py", "json.py"):
                with open(os.path.join(foreign, module), "w", encoding="utf-8") as file:
                    file.write("raise ImportError('built for another Python')\n")
            settings = "lines.linewidth: 20\nfont.size: 30\nno_such_entry: 1\nbackend: TkAgg\n"
            for place in (foreign, os.path.join(home, ".config", "matplotlib")):
                with open(os.path.join(place, "matplotlibrc"), "w", encoding="utf-8") as file:
                    file.write(settings)
            clean = {"PATH": os.environ["PATH"], "HOME": scratch}
            pictures = {}
            for name, changes in (
                    ("clean", {}),
                    ("all at once", {"PYTHONPATH": foreign, "PYTHONHOME": "/opt/nothing", "PYTHONSTARTUP": "/no",
                                     "PYTHONWARNINGS": "error", "PYTHONOPTIMIZE": "2", "PYTHONIOENCODING": "ascii",
                                     "LC_ALL": "C", "MPLBACKEND": "no_such_backend", "MATPLOTLIBRC": foreign,
                                     "HOME": home}),
                    ("no home", {"HOME": "/proc/no/home", "MPLCONFIGDIR": "/proc/no"}),
                    ("home is a file", {"HOME": SCRIPT, "XDG_CACHE_HOME": "/proc/no/caches"})):
                # The current folder has settings and modules in every case but the first.
                where = scratch if name == "clean" else foreign
                result = draw(run, env={**clean, **changes}, cwd=where)
                self.assertEqual((result.returncode, result.stderr), (0, ""), name)
                with open(os.path.join(run, "figures", "force_displacement.png"), "rb") as file:
                    pictures[name] = hashlib.sha256(file.read()).hexdigest()
            self.assertEqual(len(set(pictures.values())), 1, pictures)
            self.assertFalse(os.path.exists(os.path.join(scratch, "no")))


class CentredMean(unittest.TestCase):
    def test_a_straight_line_is_its_own_mean(self):
        # Places as uneven as at the start of a pull; a record is the mean since the one before it.
        place = np.concatenate([[0, 1e-5, 3e-5, 7e-5], np.arange(2, 60) * 1e-4])
        force = 10 + 2e5 * np.concatenate([place[:1], 0.5 * (place[1:] + place[:-1])])
        mean = figures.centred_mean(place, force, 1e-3)
        # To a fraction of what a record rises by (20 N), where a window ends inside a record; a trailing mean would lag
        # behind by 100 N. The end itself has only the last record.
        np.testing.assert_allclose(mean[:-1], 10 + 2e5 * place[:-1], atol=4)
        self.assertAlmostEqual(mean[-1], force[-1])

    def test_noise_is_averaged_over_the_length(self):
        place = np.linspace(0, 0.01, 1001)
        force = np.where(np.arange(1001) % 2, 100.0, 300.0)
        mean = figures.centred_mean(place, force, 1e-3)
        np.testing.assert_allclose(mean[60:-60], 200, atol=2.1)
        self.assertEqual((mean[0], mean[-1]), (force[0], force[-1]))

    def test_one_record_is_itself(self):
        self.assertEqual(figures.centred_mean(np.array([0.0]), np.array([5.0]), 1e-3).tolist(), [5.0])


class Cases(unittest.TestCase):
    """What used.prm and summary.json decide."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.run_folder = os.path.join(scratch.name, "one")
        write_history(self.run_folder, "0,0,0,0,0\n0.1,1e-3,100,90,0\n0.2,2e-3,150,130,0\n")

    def parameters(self, *changes):
        text = PAPERS_CASE
        for old, new in changes:
            self.assertEqual(text.count(old), 1, old)
            text = text.replace(old, new)
        with open(os.path.join(self.run_folder, "used.prm"), "w", encoding="utf-8") as file:
            file.write(text)
        return figures.read_parameters(self.run_folder)

    def drawn(self):
        """The axes of the force figure."""
        kept = []
        save, figures.save = figures.save, lambda figure, path: kept.append(figure)
        try:
            figures.force_figure([self.run_folder], [], "none.png", True)
        finally:
            figures.save = save
        return kept[0].axes[0]

    def test_reads_parameters(self):
        parameters = self.parameters()
        self.assertEqual(parameters["Experiment"], "pull-out")
        self.assertEqual(figures.number(parameters, "Box/Length"), 0.4)
        self.assertTrue(np.isnan(figures.number(parameters, "Geogrid/Rigid")))
        self.assertAlmostEqual(figures.geogrid_width(parameters), 0.2)

    def test_only_the_papers_case_is_held_against_the_laboratory(self):
        self.assertEqual(figures.surcharge_of_laboratory(self.parameters()), 500)
        self.assertEqual(figures.surcharge_of_laboratory(self.parameters(("Force = 500", "Force = 0"))), 0)
        rigid = self.parameters(("Rigid = false", "Rigid = true"), ("2.4e9", "1"))
        self.assertEqual(figures.surcharge_of_laboratory(rigid), 500)
        for change in (("Length = 0.4", "Length = 0.5"), ("Width = 0.2", "Width = 0.25"),
                       ("Height = 0.3", "Height = 0.2"), ("along = 6", "along = 5"), ("across = 3", "across = 2"),
                       ("along = 0.065", "along = 0.04"), ("across = 0.065", "across = 0.04"), ("2.4e9", "2.4e8"),
                       ("Force = 500", "Force = 250"), ("Speed = 0.01", "Speed = 0.1"),
                       ("  set Height = 0.3\n", "")):
            self.assertIsNone(figures.surcharge_of_laboratory(self.parameters(change)), change)
        os.remove(os.path.join(self.run_folder, "used.prm"))
        self.assertIsNone(figures.surcharge_of_laboratory(figures.read_parameters(self.run_folder)))

    def test_the_figure_holds_the_papers_case_against_the_laboratory(self):
        self.parameters()
        self.assertTrue(any("laboratory" in text.get_text() for text in self.drawn().texts))
        self.parameters(("Height = 0.3", "Height = 0.2"))
        self.assertFalse(any("laboratory" in text.get_text() for text in self.drawn().texts))

    def test_force_over_width(self):
        self.parameters(("across = 3", "across = 2"))
        axes = self.drawn()
        (right,) = axes.child_axes
        self.assertIn("135 mm [kN/m]", right.get_ylabel())
        axes.figure.canvas.draw()
        np.testing.assert_allclose(right.get_ylim(), 1e-3 * np.array(axes.get_ylim()) / 0.135)
        os.remove(os.path.join(self.run_folder, "used.prm"))
        self.assertEqual(self.drawn().child_axes, [])

    def test_legend_explains_the_lines(self):
        words = " ".join(text.get_text() for text in self.drawn().get_legend().get_texts())
        self.assertIn("thin: mean between records", words)
        self.assertIn("thick: centred mean over 1 mm", words)
        self.assertNotIn("not to be used", words)

    def test_what_is_not_to_be_used_is_shaded(self):
        reason = "The results are not usable from 1.5 mm on: stones are caught between a rib and the wall of the box."
        for summary in ({"results": {"not_usable_from_mm": 1.5}}, {"results": {}, "not_usable_from_mm": 1.5}):
            with open(os.path.join(self.run_folder, "summary.json"), "w", encoding="utf-8") as file:
                json.dump({**summary, "warnings": ["The step was long.", reason]}, file)
            axes = self.drawn()
            (shade,) = axes.patches
            self.assertEqual((shade.get_xy()[:, 0].min(), shade.get_xy()[:, 0].max()), (1.5, 2.0))
            label = shade.get_label()
            self.assertTrue(label.startswith("not to be used: The results are not usable from 1.5 mm on"), label)
            self.assertLess(len(label), 90)
        # A reason of its own goes before the warnings.
        with open(os.path.join(self.run_folder, "summary.json"), "w", encoding="utf-8") as file:
            json.dump({"results": {"not_usable_from_mm": 1.0, "not_usable_because": "a rib yields"},
                       "warnings": [reason]}, file)
        self.assertEqual(self.drawn().patches[0].get_label(), "not to be used: a rib yields")

    def test_a_wedged_stone_is_marked(self):
        stone = "stone 118 (centre at x = 12, y = 80, z = 95 mm) between transverse rib 2 (40.20 kN) and the wall 'front'"
        with open(os.path.join(self.run_folder, "summary.json"), "w", encoding="utf-8") as file:
            json.dump({"results": {"wedged_stone": stone, "wedged_from_mm": 1.2}}, file)
        (line,) = [line for line in self.drawn().lines if line.get_label().startswith("wedged")]
        self.assertEqual(set(line.get_xdata()), {1.2})
        self.assertEqual(" ".join(line.get_label().split()), "wedged from 1.2 mm on: " + stone)


if __name__ == "__main__":
    unittest.main()
