"""The package interlock without a run: stones, clumps, entries of cases, readers of results.

Fails when a clump is not the one that the program writes, when a mass property is not that of the body, when bad input
gets another sentence than the program's, when a reader drops a unit or a row, or when reading results loads the
simulation.
Run by ctest: python_package.py PACKAGE_FOLDER PROGRAM SOURCES
"""

import ast
import json
import os
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np

SOURCES, PROGRAM, PACKAGE = (os.path.abspath(sys.argv.pop()) for _ in range(3))
sys.path.insert(0, PACKAGE)
import interlock

SMALL = os.path.join(SOURCES, "tests", "reliability", "small.prm")


def program(*words):
    """What the program says on its error output, without the names before its sentences."""
    call = subprocess.run([PROGRAM, *words], capture_output=True, text=True)
    return call.returncode, call.stderr.replace("interlock: error: ", "").strip()


def box(a, b, c):
    """A closed box with edges a, b, c [m], a corner at the origin, as vertices and triangles."""
    vertices = np.array([[x, y, z] for x in (0, a) for y in (0, b) for z in (0, c)], dtype=float)
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return vertices, np.array([t for p, q, r, s in quads for t in ((p, q, r), (p, r, s))])


class Folder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)


class StonesAndClumps(Folder):
    def test_stones_are_those_of_the_program(self):
        stones = interlock.stones(2, seed=5)
        subprocess.run([PROGRAM, "stones", "--count", "2", "--seed", "5", "-o", self.folder], check=True,
                       stdout=subprocess.DEVNULL)
        for i, stone in enumerate(stones):
            self.assertEqual(stone.vertices.shape[1], 3)
            self.assertEqual(stone.triangles.max(), len(stone.vertices) - 1)
            stone.save(self.path("again.stl"))
            with open(self.path(f"stone_{i + 1:03}.stl"), "rb") as theirs, open(self.path("again.stl"), "rb") as ours:
                self.assertEqual(ours.read(), theirs.read())

    def test_style_and_its_errors(self):
        worn, fresh = (interlock.stones(1, seed=1, edge_wear=wear)[0] for wear in (0.4, 0.01))
        self.assertLess(worn.angularity, fresh.angularity)
        with self.assertRaises(interlock.InputError):
            interlock.stones(1, faces=1000)
        with self.assertRaisesRegex(TypeError, "facets"):
            interlock.stones(1, facets=10)

    def test_clump_is_the_one_that_the_program_writes(self):
        interlock.stones(1, seed=3)[0].save(self.path("stone.stl"))
        subprocess.run([PROGRAM, "clump", self.path("stone.stl"), "--sphere-order", "gain", "--spheres", "20",
                        "--bulge", "1e-3", "--density", "2650", "-o", self.path("theirs.clump.json")], check=True,
                       stdout=subprocess.DEVNULL)
        clump = interlock.clump(self.path("stone.stl"), order="gain", max_spheres=20, bulge=1e-3)
        clump.save(self.path("ours.clump.json"))
        with open(self.path("theirs.clump.json")) as theirs, open(self.path("ours.clump.json")) as ours:
            self.assertEqual(ours.read(), theirs.read())
        with open(self.path("theirs.report.json")) as file:
            self.assertEqual(clump.report, json.load(file)["clumps"][0])
        self.assertEqual(clump.spheres.shape, (20, 4))

    # A box of edges a, b, c: m/12 (b^2 + c^2), ...
    def test_mass_properties_of_a_box_from_arrays(self):
        a, b, c = 0.03, 0.05, 0.04
        clump = interlock.clump(box(a, b, c), order="gain", max_spheres=8, density=3000)
        mass = 3000 * a * b * c
        self.assertAlmostEqual(clump.mass / mass, 1, places=12)
        np.testing.assert_allclose(clump.centre, [a / 2, b / 2, c / 2], rtol=1e-12)
        moments = sorted([mass / 12 * (b * b + c * c), mass / 12 * (c * c + a * a), mass / 12 * (a * a + b * b)])
        np.testing.assert_allclose(clump.inertia, moments, rtol=1e-12)
        spheres = clump.spheres_of_surface
        self.assertTrue((spheres[:, :3] - spheres[:, 3:] > -1e-9).all())
        self.assertTrue((spheres[:, :3] + spheres[:, 3:] < np.array([a, b, c]) + 1e-9).all())

    def test_millimetres(self):
        vertices, triangles = box(30, 50, 40)
        clump = interlock.clump((vertices, triangles), unit="mm", order="gain", max_spheres=8)
        self.assertAlmostEqual(clump.volume, 6e-5, places=12)

    def test_sentences_of_the_program(self):
        stone = self.path("stone.stl")
        interlock.stones(1)[0].save(stone)
        for words, options in (({}, []), ({"d_min": 1.0, "r_min": 1e-3}, ["--d-min", "1", "--r-min", "1e-3"]),
                               ({"d_min": 1e-3, "r_min": 1.0, "unusual": True},
                                ["--d-min", "1e-3", "--r-min", "1", "--unusual"])):
            code, sentence = program("clump", stone, "-o", self.path("x.clump.json"), *options)
            self.assertEqual(code, 2)
            with self.assertRaises(interlock.InputError) as caught:
                interlock.clump(stone, **words)
            self.assertEqual(str(caught.exception), sentence)

    def test_bad_arrays(self):
        vertices, triangles = box(0.03, 0.05, 0.04)
        for stone, words in (((vertices, triangles[1:]), "is open"), ((vertices[:, :2], triangles), "n rows of 3"),
                             ((vertices, triangles + 1), "has a triangle with vertex 8"),
                             ((100 * vertices, triangles), "check the length unit"),
                             ((np.where(vertices > 0, np.nan, 0), triangles), "not a finite place"),
                             ((vertices, triangles[:, ::-1]), "inside out")):
            with self.assertRaisesRegex(interlock.InputError, words):
                interlock.clump(stone, order="gain")


class Cases(Folder):
    def test_entries_have_values(self):
        case = interlock.Case(SMALL, {"Pull/Distance": 0.002, "Output/Frames at": [0.001, 0.0015]},
                              **{"Geogrid/Rigid": True})
        self.assertEqual(case.experiment, "pull-out")
        self.assertEqual((case["Pull/Distance"], case["Geogrid/Rigid"], case["Stones/Count"]), (0.002, True, 12))
        self.assertEqual((case["Output/Frames at"], case["Geogrid/Placement"]), ((0.001, 0.0015), "not flattened"))
        case["Stones/Count"] = np.int64(9)
        case["Output/Frames at"] = np.array([0.0005])
        case["Geogrid/Rigid"] = np.bool_(False)
        self.assertEqual((case["Stones/Count"], case["Pull/Distance"]), (9, 0.002))
        self.assertEqual((case["Output/Frames at"], case["Geogrid/Rigid"]), ((0.0005,), False))
        self.assertIn("set Count = 9\n", case.text)
        self.assertIn("[m/s]", case.describe("Pull/Speed"))
        self.assertEqual(len(dict(case)), len(case))

    def test_sentences_of_the_program(self):
        for name, value in (("Pull/Distanc", 1), ("Pull/Distance", -1), ("Pull/Distance", "5 mm"),
                            ("Pull/Speed", 20.0), ("Stones/Folder", "nowhere")):
            code, sentence = program("check", SMALL, "--set", f"{name}={value}")
            self.assertEqual(code, 2, name)
            with self.assertRaises(interlock.InputError) as caught:
                interlock.Case(SMALL, {name: value})
            self.assertEqual(str(caught.exception), sentence)
        with self.assertRaises(interlock.InputError) as caught:
            interlock.Case(self.path("none.prm"))
        self.assertEqual(str(caught.exception), program("check", self.path("none.prm"))[1])

    def test_a_bad_change_changes_nothing(self):
        case = interlock.Case(SMALL)
        with self.assertRaises(interlock.InputError):
            case["Pull/Distance"] = -1
        self.assertEqual(case["Pull/Distance"], 0.004)
        with self.assertRaisesRegex(KeyError, "Pull/Distance"):
            case["Pull/Distanc"]
        with self.assertRaisesRegex(interlock.InputError, "--unusual"):
            interlock.Case(SMALL, {"Stones/Density": 26.5})
        self.assertEqual(interlock.Case(SMALL, {"Stones/Density": 26.5}, unusual=True)["Stones/Density"], 26.5)


class TypeFiles(unittest.TestCase):
    # Arguments, names and members of each type file (.pyi) are those of its module.
    def test_types_are_those_of_the_modules(self):
        for name in ("case", "results", "stones_and_clumps", "study"):
            trees = []
            for ending in (".py", ".pyi"):
                with open(os.path.join(PACKAGE, "interlock", name + ending), encoding="utf-8") as file:
                    trees.append(signatures(ast.parse(file.read()).body))
            module, declared = trees
            for key, words in declared.items():
                self.assertIn(key, module, name)
                if words is not None and "style" not in module[key]:
                    self.assertEqual(module[key], words, f"{name}: {key}")
            missing = [key for key in module if key not in declared and "_" not in (key[0], key.partition(".")[2][:1])]
            self.assertEqual(missing, [], name)

    def test_types_of_the_extension(self):
        import interlock._native as native
        with open(os.path.join(PACKAGE, "interlock", "_native.pyi"), encoding="utf-8") as file:
            declared = signatures(ast.parse(file.read()).body)
        for key in declared:
            owner, _, member = key.rpartition(".")
            self.assertTrue(hasattr(getattr(native, owner) if owner else native, member), key)
        public = {key for key in dir(native) if not key.startswith("_")} - {"version", "commit"}
        self.assertEqual(public, {key for key in declared if "." not in key})
        members = {key for key in dir(native.Moment) if not key.startswith("_")}
        self.assertEqual(members, {key.partition(".")[2] for key in declared if key.startswith("Moment.")} - {"__len__"})
        for key in members:
            self.assertTrue(getattr(native.Moment, key).__doc__, key)


def signatures(body, owner=""):
    """Classes and functions of a module as name -> names of the arguments (None: a class)."""
    found = {}
    for node in body:
        if isinstance(node, ast.ClassDef):
            found[owner + node.name] = None
            found.update(signatures(node.body, owner + node.name + "."))
        elif isinstance(node, ast.FunctionDef):
            a = node.args
            found[owner + node.name] = [arg.arg for arg in (*a.args, *a.kwonlyargs, a.vararg, a.kwarg) if arg]
    return found


class Results(Folder):
    def test_history_keeps_units_and_whole_rows(self):
        self.write("used.prm", "set Experiment = heap\nsubsection Pull\n  set Speed = 0.1\nend\n")
        self.write("history.csv", "time [s],stage,force [N]\n0,fill,1\n0.5,pull,\n1,pu")
        results = interlock.Results(self.folder)
        self.assertEqual(list(results.history), ["time [s]", "stage", "force [N]"])
        np.testing.assert_array_equal(results.history["time [s]"], [0, 0.5])
        np.testing.assert_array_equal(results.history["force [N]"], [1, np.nan])
        self.assertEqual(results.parameters["Pull/Speed"], "0.1")
        self.assertEqual((results.finished, results.summary, results.state_hash), (False, {}, None))
        with self.assertRaisesRegex(interlock.InputError, "no frames"):
            results.frames

    def test_table_with_and_without_pandas(self):
        self.write("used.prm", "")
        self.write("history.csv", "time [s],force [N]\n0,1\n")
        results = interlock.Results(self.folder)
        frames = mock.Mock()
        with mock.patch.dict(sys.modules, pandas=frames):
            results.table()
        self.assertEqual(list(frames.DataFrame.call_args[0][0]), ["time [s]", "force [N]"])
        with mock.patch.dict(sys.modules, pandas=None), self.assertRaisesRegex(ImportError, "python3-pandas"):
            results.table()

    def test_other_folders(self):
        with self.assertRaisesRegex(interlock.InputError, "not the output folder of a run"):
            interlock.Results(self.folder)
        with self.assertRaisesRegex(interlock.InputError, "no runs.csv"):
            interlock.Study(self.folder).runs

    def test_reading_needs_no_simulation(self):
        code = f"import sys; sys.path.insert(0, {PACKAGE!r}); import interlock; interlock.Results; interlock.Study; " \
            "assert 'interlock._native' not in sys.modules"
        subprocess.run([sys.executable, "-I", "-c", code], check=True)

    def test_without_h5py(self):
        self.write("used.prm", "")
        code = f"import sys; sys.path.insert(0, {PACKAGE!r}); sys.modules['h5py'] = None; import interlock; " \
            f"interlock.Results({self.folder!r}).frames"
        call = subprocess.run([sys.executable, "-I", "-c", code], capture_output=True, text=True)
        self.assertRegex(call.stderr, "ImportError: Frames are read with h5py.*python3-h5py")


if __name__ == "__main__":
    unittest.main()
