"""Runs within Python against those of the program, on one small case.

Fails when a digit of state or history differs, when an array is a copy or can be written to, when an array outlives its
moment unnoticed, when a stop, an exception or Control-C loses the state, when other threads wait for the run, or when
the tutorial breaks.
Run by ctest: python_runs.py PACKAGE_FOLDER PROGRAM SOURCES
"""

import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

SOURCES, PROGRAM, PACKAGE = (os.path.abspath(sys.argv.pop()) for _ in range(3))
sys.path.insert(0, PACKAGE)
import interlock

SMALL = os.path.join(SOURCES, "tests", "reliability", "small.prm")
SHORT = {"Stones/Count": 3, "Pull/Distance": 0.0005, "Output/Field frames": 3, "Output/Report": False}


def short_case(**changes):
    return interlock.Case(SMALL, {**SHORT, **changes})


class Runs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        words = [word for name, value in SHORT.items() for word in ("--set", f"{name}={str(value).lower()}")]
        subprocess.run([PROGRAM, "run", SMALL, *words, "-o", cls.path("program")], check=True,
                       stdout=subprocess.DEVNULL)
        cls.program = interlock.Results(cls.path("program"))

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder, name)

    def assert_same_run(self, results):
        self.assertTrue(results.finished)
        self.assertEqual(results.state_hash, self.program.state_hash)
        for name in ("history.csv", "used.prm"):
            with open(results.path(name), "rb") as ours, open(self.program.path(name), "rb") as theirs:
                self.assertEqual(ours.read(), theirs.read(), name)
        self.assertEqual(sorted(os.listdir(results.folder)), sorted(os.listdir(self.program.folder)))
        self.assertEqual(results.summary["results"], self.program.summary["results"])

    def test_same_digits_and_what_a_callback_sees(self):
        seen = []

        def look(moment):
            positions, nodes = moment.positions, moment.geogrid_nodes
            for array in (positions, moment.velocities, moment.orientations, moment.ids, moment.masses):
                self.assertFalse(array.flags.writeable)
                self.assertEqual(len(array), len(moment))
                if len(moment):
                    self.assertFalse(array.flags.owndata)
                    self.assertIsNotNone(array.base)
                    with self.assertRaises(ValueError):
                        array.flags.writeable = True
            if len(moment):
                again = moment.positions
                self.assertTrue(np.shares_memory(positions, again))
                self.assertEqual(positions.ctypes.data, again.ctypes.data)
                np.testing.assert_allclose(np.linalg.norm(moment.orientations, axis=1), 1, rtol=1e-12)
            seen.append((moment.stage, moment.step, moment.time, moment.fraction, positions.copy(),
                         moment.ids.copy(), None if nodes is None else nodes[:, 0].max(), moment.clamp_force))

        results = short_case().run(self.path("python"), callback=look)
        self.assert_same_run(results)
        steps = [moment[1] for moment in seen]
        self.assertTrue(all(step % 100 == 0 for step in steps))
        self.assertEqual(steps, sorted(set(steps)))
        self.assertGreater(len(steps), results.summary["steps"] // 100 - 10)
        stages = list(dict.fromkeys(moment[0] for moment in seen))
        self.assertEqual(stages, [stage["name"] for stage in results.summary["stages"] if stage["steps"] >= 100])
        last = seen[-1]
        self.assertEqual(len(last[4]), results.summary["clumps"])
        self.assertEqual(last[7].shape, (3,))
        # The last frame is at most some steps away; stones hardly move.
        frame = results.frames[-1]
        np.testing.assert_array_equal(frame.ids, last[5])
        np.testing.assert_allclose(frame.positions, last[4], atol=2e-4)
        self.assertEqual(len(results.frames), len(results.frames.times))
        self.assertTrue((np.diff(results.frames.times) > 0).all())
        self.assertGreater(frame.field("geogrid").max(), 0)

    def test_stopped_by_the_callback_and_resumed(self):
        case = short_case()
        stages = []

        def stop(moment):
            stages.append(moment.stage)
            return moment.stage == "settle" or None

        results = case.run(self.path("stopped"), callback=stop, every=300)
        self.assertFalse(results.finished)
        self.assertIn("go on with: case.run(", results.stopped)
        self.assertEqual(stages.count("settle"), 1)
        with self.assertRaisesRegex(interlock.InputError, "holds a run that was stopped"):
            case.run(self.path("stopped"))
        self.assert_same_run(case.run(self.path("stopped"), resume=True))
        with self.assertRaisesRegex(interlock.InputError, "holds a finished run"):
            case.run(self.path("stopped"))

    def test_exception_of_the_callback_keeps_the_state(self):
        def break_down(moment):
            if moment.stage != "fill lower half":
                raise ZeroDivisionError("as asked")

        with self.assertRaisesRegex(ZeroDivisionError, "as asked") as caught:
            short_case().run(self.path("broken"), callback=break_down)
        if hasattr(caught.exception, "__notes__"):
            self.assertIn("the state is in", caught.exception.__notes__[0])
        self.assert_same_run(short_case().run(self.path("broken"), resume=True))

    def test_array_that_is_kept(self):
        kept, moments = [], []

        def keep(moment):
            moments.append(moment)
            if len(moment) > 3:
                kept.append(moment.positions[1:, 2])

        with self.assertRaisesRegex(BufferError, "keep a copy"):
            short_case().run(self.path("kept"), callback=keep)
        self.assertEqual(len(kept), 1)
        self.assertTrue(np.isfinite(kept[0]).all())  # its memory is still there
        with self.assertRaisesRegex(RuntimeError, "is over"):
            moments[0].positions

    def test_control_c_and_other_threads(self):
        counted = [0]
        done = threading.Event()
        checkpoint = os.path.join(self.path("interrupted"), "checkpoint.h5")

        def count():
            sent = False
            while not done.wait(0.001):
                counted[0] += 1
                if not sent and os.path.exists(checkpoint):
                    os.kill(os.getpid(), signal.SIGINT)
                    sent = True

        thread = threading.Thread(target=count)
        thread.start()
        try:
            with self.assertRaises(KeyboardInterrupt) as caught:
                short_case().run(self.path("interrupted"))
        finally:
            done.set()
            thread.join()
        self.assertGreater(counted[0], 20)  # without a callback nothing else lets go of the lock
        self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)
        if hasattr(caught.exception, "__notes__"):
            self.assertIn("the state is in", caught.exception.__notes__[0])
        self.assertIn("Stopped: interrupted", interlock.Results(self.path("interrupted")).log)
        self.assert_same_run(short_case().run(self.path("interrupted"), resume=True))

    def test_failures_and_one_run_at_a_time(self):
        with self.assertRaisesRegex(interlock.RunFailure, "one at a time"):
            short_case().run(self.path("outer"), callback=lambda moment: short_case().run(self.path("inner")))
        with self.assertRaises(interlock.RunFailure) as caught:
            short_case(**{"Limits/Overlap": 1e-7}).run(self.path("fast"))
        self.assertIn("Stopped: " + str(caught.exception), interlock.Results(self.path("fast")).log)

    def test_forecast(self):
        forecast = short_case().forecast()
        self.assertGreater(forecast["clumps"], 5)
        self.assertEqual([stage["name"] for stage in forecast["stages"]][-1], "pull")
        self.assertGreater(forecast["memory"], 0)


class Others(unittest.TestCase):
    def test_study(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bars.prm")
            with open(os.path.join(SOURCES, "tests", "regression", "study_of_a_product.prm"), encoding="utf-8") as file:
                text = file.read().replace("set Base case = ", f"set Base case = {SOURCES}/tests/regression/")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            study = interlock.Study(path, os.path.join(folder, "out"))
            self.assertIn("6 runs", study.plan())
            self.assertFalse(os.path.exists(study.folder))
            runs = study.run().runs
            self.assertEqual(runs["status"].tolist(), 6 * ["done"])
            self.assertEqual(runs["state_hash"].tolist(), 6 * [16 * "0"])  # text, though it looks like a number
            # The stretch is c F/E.
            stretch = runs["largest_displacement_m"].reshape(3, 2)
            np.testing.assert_allclose(stretch[:, 0] / stretch[0, 0], [1, 2, 3], rtol=1e-6)
            np.testing.assert_allclose(stretch[:, 1] / stretch[:, 0], 0.5, rtol=1e-6)
            self.assertGreater(len(study.variance["term"]), 3)
            self.assertTrue(interlock.Study(study.folder).results(runs["run"][0]).finished)
            with open(path, "a", encoding="utf-8") as file:
                file.write("set Nonsense = 1\n")
            with self.assertRaisesRegex(interlock.InputError, "bars.prm, line .*Nonsense"):
                study.plan()

    # As users start it: another working folder, no variables but the package's path, any user.
    def test_tutorial(self):
        with tempfile.TemporaryDirectory() as folder:
            start = time.monotonic()
            call = subprocess.run(["/usr/bin/python3", os.path.join(SOURCES, "python", "tutorial.py"), "out"],
                                  cwd=folder, env={"PYTHONPATH": PACKAGE, "PATH": "/usr/bin:/bin", "HOME": folder},
                                  capture_output=True, text=True)
            self.assertEqual(call.returncode, 0, call.stderr)
            self.assertGreater(os.path.getsize(os.path.join(folder, "out", "tutorial.png")), 10000)
            self.assertRegex(call.stdout, r"highest pull force \d+ N")
            print(f"tutorial: {time.monotonic() - start:.0f} s")


if __name__ == "__main__":
    unittest.main()
