#!/usr/bin/python3 -I
"""Kills a study (signal 9, or 15 every third time) at random moments and starts it again, and compares runs.csv, means.csv,
differences.csv, variance.csv and curves.h5 with those of a study that nobody disturbed, on one job, on two, on three
ranks of mpirun, and with --ranks with two ranks a run. One line a comparison; exit code 1 when a byte differs.

    study_kills.py [--kills N] [--ranks] [--jobs N] [--seed SEED] [--study FILE] [--program PROGRAM]

default: 10 kills, tests/reliability/study.prm, some seconds each.
"""
import argparse
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
FILES = ["runs.csv", "means.csv", "differences.csv", "variance.csv", "curves.h5"]


def command(arguments, folder, jobs, study=None):
    return [arguments.program, "study", study or arguments.study, "-o", folder, "--jobs", str(jobs)]


def undisturbed(words):
    begin = time.monotonic()
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode not in (0, 3):
        sys.exit(f"the undisturbed study ended with {done.returncode}: {done.stderr}")
    return done.returncode, time.monotonic() - begin


def killed(arguments, folder, duration, draws):
    """Kills it until it has happened `kills` times, then lets it end. Returns the exit code and how many kills came
    while it ran."""
    kills = 0
    for k in range(arguments.kills):
        process = subprocess.Popen(command(arguments, folder, arguments.jobs), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        try:
            process.wait(draws.uniform(0, 2 * duration / arguments.kills))
            break  # it was over before
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGTERM if k % 3 == 2 else signal.SIGKILL)
            process.wait()
            kills += 1
    done = subprocess.run(command(arguments, folder, arguments.jobs), stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, text=True)
    return done.returncode, kills


def compare(name, folder, reference, code, expected):
    different = [file for file in FILES
                 if (folder / file).exists() != (reference / file).exists()
                 or (reference / file).exists() and (folder / file).read_bytes() != (reference / file).read_bytes()]
    if code == expected and not different:
        print(f"ok: {name}: the same bytes in {', '.join(FILES)}")
        return True
    print(f"FAILED: {name}: exit code {code} (undisturbed {expected}), other bytes in {', '.join(different) or 'no file'}")
    return False


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--ranks", action="store_true", help="also with two ranks a run")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--study", type=os.path.abspath, default=str(HERE / "study.prm"))
    parser.add_argument("--program", default=str(HERE.parent.parent / "build/release/bin/interlock"))
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        expected, duration = undisturbed(command(arguments, folder / "one", 1))
        code, _ = undisturbed(command(arguments, folder / "two", 2))
        good = compare("two jobs", folder / "two", folder / "one", code, expected)
        code, _ = undisturbed(["mpirun", "-n", "3", arguments.program, "study", arguments.study, "-o", folder / "farm"])
        good = compare("three ranks", folder / "farm", folder / "one", code, expected) and good
        if arguments.ranks:
            (folder / "ranks.prm").write_text(f"include {arguments.study}\nset Ranks per run = 2\n")
            code, _ = undisturbed(command(arguments, folder / "ranks", 1, folder / "ranks.prm"))
            good = compare("two ranks a run", folder / "ranks", folder / "one", code, expected) and good
        code, kills = killed(arguments, folder / "killed", duration, random.Random(arguments.seed))
        good = compare(f"killed {kills} times", folder / "killed", folder / "one", code, expected) and good
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
