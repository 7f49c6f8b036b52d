#!/usr/bin/env python3
"""Runs small cases on one rank and on several and compares all that they write, to the last bit: state hash,
history, frames, results. One line a try; exit code 1 when one differs.

    ranks.py CASES [--program PROGRAM] [--ranks 2,3,4] [--seed SEED] [--tries N] [--minutes M] [--keep]

CASES is one of
    fixed    each case of the list below on each number of ranks, and two stopped and resumed on another number
    random   cases of the list with random parameters on random numbers of ranks, stopped and resumed at random
             moments, until N tries are made or M minutes are over
    FILE     a parameter file, on each number of ranks

Ranks deal their stones anew at every 500th step besides (random cases: every 50th to never), so that this happens
in short runs, too. Pull-outs are run again with the geogrid's lattice shared out among the ranks, which only large
ones are otherwise. The plain pull-out is run on each number of ranks either way, its variants on the smallest
number, and on the next one with the lattice shared out: more ranks than cores are slow.
"""
import argparse
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE.parent / "reliability"))
import compare_runs  # noqa: E402

SMALL = ROOT / "tests/reliability/small.prm"
PACKING = ROOT / "cases/benchmark/w1.prm"
THROWN = ["Time/Warm-up steps=0", "Packing/Throw speed=1", "Packing/Throw spin=30"]
# Weak triangles, which yield in a small box.
TRIANGLES = [f"Geogrid/Product={ROOT / 'cases/geogrids/tx160.prm'}", "Geogrid/Elements per rib=8",
             "Product/Elements per rib=3", "Product/Junction reach=0"] + [
    f"Geogrid/{name}=0" for name in ("Pitch along", "Pitch across", "Rib width", "Rib thickness", "Youngs modulus",
                                     "Poisson ratio", "Density")] + [
    f"Product/{name} {direction}={value}" for direction in ("along", "across") for name, value in (
        ("Youngs modulus", 0), ("Stiffness at 2 %", 2e4), ("Stiffness at 5 %", 1.6e4), ("Strength", 1e3))]
TRIAXIAL = ("triaxial, between walls that keep a pressure", HERE / "cases/triaxial.prm", [])
# Name, parameter file, entries. What each of them is there for is in its name.
FIXED = [
    ("pull-out, flexible", SMALL, []),
    ("pull-out, rigid, below heavy spheres", SMALL, ["Geogrid/Rigid=true", "Surcharge/Force=50",
                                                     "Surcharge/Sphere radius=0.02"]),
    ("pull-out, flattened, below a plate that keeps its force", SMALL,
     ["Geogrid/Placement=flattened", "Surcharge/Kind=plate", "Surcharge/Force=50", "Pull/Distance=0.002"]),
    ("pull-out, weighed in and pressed", SMALL,
     ["Geogrid/Placement=flattened", "Filling/Stone friction=0.05", "Filling/Lower bulk density=1100",
      "Filling/Upper bulk density=1100", "Pull/Distance=0.001"]),
    ("pull-out, shared contacts", SMALL, ["Contact/Share among contacts=true", "Pull/Distance=0.002"]),
    ("pull-out, ribs rub at side walls and edges of a narrow slot", SMALL,
     ["Contact/Box friction=0.3", "Box/Width=0.1352", "Box/Slot height=0.0027", "Pull/Distance=0.002"]),
    ("pull-out, stones crush", SMALL, ["Contact/Crushing pressure=2e7", "Pull/Distance=0.002"]),
    ("pull-out, triangles that soften and yield, cut off beside the last ones", SMALL, TRIANGLES + [
        "Geogrid/Apertures along=3", "Geogrid/Apertures across=2", "Geogrid/Cut width=0.134", "Pull/Distance=0.0015"]),
    ("heap, rolling, on triangles", HERE / "cases/heap.prm", []),
    ("shear box, below a plate that keeps its force", HERE / "cases/shear_box.prm", []),
    TRIAXIAL,
    ("packing, thrown", PACKING, THROWN + ["Time/Timed steps=4000"]),
    ("packing, squeezed", PACKING, ["Packing/Squeeze=0.009", "Time/Warm-up steps=200", "Time/Timed steps=1000",
                                    "Packing/Missed contact checks=2"]),
    ("packing, Hertz-Mindlin, shared", PACKING,
     THROWN + ["Contact/Model=hertz-mindlin", "Contact/Youngs modulus=5e8", "Contact/Share among contacts=true",
               "Time/Timed steps=2000", "Time/Step=5e-6"]),
]


def environment(deal_every, lattice_in_parts):
    values = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", INTERLOCK_DEAL_EVERY=str(deal_every),
                  INTERLOCK_WHOLE_LATTICE_UP_TO="0" if lattice_in_parts else "2000",
                  OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                  OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_btl_vader_single_copy_mechanism="none",
                  OMPI_MCA_btl_base_warn_component_unused="0", OMPI_MCA_hwloc_base_binding_policy="none",
                  OMPI_MCA_mpi_yield_when_idle="1")
    return values


class Runner:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        self.deal_every = 500  # steps
        self.lattice_in_parts = False

    def run(self, name, case, entries, ranks, options=(), stop_after=None):
        """Returns the exit code; `stop_after` seconds after its first words the run is told to stop: before them, on
        a busy machine, it would end without a state."""
        command = ["mpirun", "-n", str(ranks)] if ranks > 1 else []
        command += [str(self.program), "run", str(case), "--output", str(self.folder / name), *options]
        for entry in [*entries, "Output/Report=false"] if case != PACKING else entries:
            command += ["--set", entry]
        told_to_stop = False
        with open(self.folder / (name + ".log"), "a") as log:
            length = os.fstat(log.fileno()).st_size
            process = subprocess.Popen(command, stdout=log, stderr=log, env=environment(self.deal_every, self.lattice_in_parts),
                                       cwd=self.folder)
            while stop_after and process.poll() is None and os.fstat(log.fileno()).st_size == length:
                time.sleep(0.02)
            try:
                code = process.wait(timeout=stop_after)
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGTERM)  # mpirun passes it on, and has an exit code of its own
                told_to_stop, code = True, process.wait()
        said = (self.folder / (name + ".log")).read_text(errors="replace")
        said = said[max(0, said.rfind("Going on from")):]  # of the last part of the run
        if told_to_stop and "Everything is in" in said:  # it had just ended
            return 0
        # While MPI starts and stones are made a run on a busy machine may not answer before mpirun kills it: there is no state
        # to go on from yet.
        too_early = code in (1, 143) and not (self.folder / name / "checkpoint.h5").exists()
        return 130 if told_to_stop and ("interlock: interrupted" in said or too_early) else code

    def differences(self, one, other):
        found = list(compare_runs.differences(self.folder / one, self.folder / other))
        return [line for line in found if not line.startswith("ranks of summary")
                and not (line.startswith("results of summary") and self.only_times_differ(one, other))
                and "clumps_000000.vtkhdf is missing" not in line]

    def only_times_differ(self, one, other):
        def kept(folder):
            results = json.loads((self.folder / folder / "summary.json").read_text())["results"]
            return {key: value for key, value in results.items()
                    if not key.endswith("_s_per_step") and not key.startswith("list_")}
        return kept(one) == kept(other)

    def verdict(self, one, other, code):
        if code != 0:
            text = (self.folder / (other + ".log")).read_text(errors="replace")
            said = [line for line in text.replace("\r", "\n").splitlines() if line.strip() and "%" not in line]
            return f"FAILED, exit code {code}: " + " | ".join(line[:300] for line in said[-8:])
        found = self.differences(one, other)
        return "same" if not found else "DIFFERS: " + " | ".join(line[:200] for line in found[:3])

    def forget(self, name):
        shutil.rmtree(self.folder / name, ignore_errors=True)
        (self.folder / (name + ".log")).unlink(missing_ok=True)


def hash_of(folder):
    return json.loads((folder / "summary.json").read_text())["state_hash"]


def on_each_number(runner, cases, numbers):
    """Each case on one rank and on each of these numbers."""
    for name, case, entries in cases:
        begin = time.time()
        code = runner.run("one", case, entries, 1)
        if code != 0:
            yield f"{name}: 1 rank: FAILED, exit code {code}", False
            runner.forget("one")
            continue
        yield f"{name}: 1 rank, {time.time() - begin:.1f} s, state_hash {hash_of(runner.folder / 'one')}", True
        variant = case == SMALL and entries and len(numbers) > 1
        plain = sorted(numbers)[:1] if variant else numbers
        in_parts = sorted(numbers)[1:2] if variant else numbers if case == SMALL else []
        for ranks, runner.lattice_in_parts in [(n, False) for n in plain] + [(n, True) for n in in_parts]:
            begin = time.time()
            code = runner.run("several", case, entries, ranks)
            verdict = runner.verdict("one", "several", code)
            way = ", lattice in parts" if runner.lattice_in_parts else ""
            yield f"{name}: {ranks} ranks{way}, {time.time() - begin:.1f} s: {verdict}", verdict == "same"
            runner.forget("several")
        runner.forget("one")
        runner.lattice_in_parts = False


def stopped_and_resumed(runner, name, case, entries, numbers, moments):
    """Whether a run that goes on with another number of ranks after each of these moments [s] is the same as on
    one rank, which must lie in the folder "one"."""
    text, options = "", ()
    for ranks, moment in zip(numbers, moments):
        begin = time.time()
        code = runner.run("several", case, entries, ranks, options, moment)
        text += f"{ranks} ranks, {time.time() - begin:.1f} s; "
        if code == 0:
            break
        if code != 130:
            return f"{name}: {text}" + runner.verdict("one", "several", code), False
        options = ("--resume",) if (runner.folder / "several" / "checkpoint.h5").exists() else ("--force",)
    verdict = runner.verdict("one", "several", code)
    runner.forget("several")
    return f"{name}: {text}{verdict}", verdict == "same"


def fixed(runner, numbers):
    yield from on_each_number(runner, FIXED, numbers)
    most = max(numbers)
    slow = (*TRIAXIAL[:2], ["Compression/Strain rate=0.01"])
    for name, case, entries in (FIXED[0], slow):
        begin = time.time()
        runner.run("one", case, entries, 1)
        duration = time.time() - begin
        text, same = stopped_and_resumed(runner, name + ", stopped and resumed", case, entries, [2, 1, most, 2],
                                         [0.3 * duration, 0.2 * duration, 0.3 * duration, None])
        resumed = text.count(" ranks, ") > 1
        yield text + ("" if resumed else "; was over before it was stopped"), same and resumed
        runner.forget("one")


def random_case(chance):
    name, case, entries = chance.choice(FIXED)
    entries = list(entries)
    if case == SMALL:
        entries += [f"Filling/Seed={chance.randint(1, 10**6)}", f"Contact/Stone friction={chance.uniform(0.3, 0.9):.3f}",
                    f"Pull/Distance={chance.uniform(0.0005, 0.004):.4g}",
                    f"Output/Checkpoint interval={chance.choice([0, 0.5, 2])}"]
        modulus = f"Geogrid/Youngs modulus={10**chance.uniform(8.5, 10):.4g}"
        if not any(entry.startswith("Geogrid/Product=") for entry in entries):  # a product brings its own
            entries.append(modulus)
    elif case == PACKING:
        entries += [f"Packing/Seed={chance.randint(1, 10**6)}", f"Contact/Friction={chance.uniform(0.2, 0.9):.3f}"]
    else:
        stones = "Drop" if case.stem == "heap" else "Filling"
        entries += [f"{stones}/Seed={chance.randint(1, 10**6)}", f"Contact/Stone friction={chance.uniform(0.3, 0.9):.3f}"]
    return name, case, entries


def random_runs(runner, seed, tries, minutes, numbers):
    chance = random.Random(seed)
    end = time.time() + 60 * minutes
    for number in range(1, tries + 1):
        if time.time() > end:
            return
        name, case, entries = random_case(chance)
        begin = time.time()
        code = runner.run("one", case, entries, 1)
        duration = time.time() - begin
        if code not in (0, 3):  # 3: the physics said no, and must do so on several ranks, too
            yield f"{number}: {name}: 1 rank: FAILED, exit code {code}", False
            continue
        ranks = [chance.choice(numbers), *(chance.choice(numbers + [1]) for _ in range(chance.randint(0, 3)))]
        runner.deal_every = chance.choice([50, 200, 500, 2000, 0])
        runner.lattice_in_parts = chance.choice([False, True])
        if code == 3:
            several = runner.run("several", case, entries, ranks[0])
            verdict = runner.verdict("one", "several", several) if code == 0 else (
                "same" if several == code else f"DIFFERS: exit code {several} instead of {code}")
            yield f"{number}: {name}: {ranks[0]} ranks, exit code {code}: {verdict}", verdict == "same"
        else:
            moments = [chance.uniform(0.2, 1.5) * duration for _ in ranks[1:]] + [None]
            text, same = stopped_and_resumed(runner, name, case, entries, ranks, moments)
            yield f"{number}: {text}" + ("" if same else f" ({' '.join(entries)})"), same
        runner.forget("one")
        runner.forget("several")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/bin/interlock")
    parser.add_argument("--ranks", default="2,3,4")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tries", type=int, default=10**9)
    parser.add_argument("--minutes", type=float, default=60)
    parser.add_argument("--keep", action="store_true", help="keep the folder of the runs and name it")
    arguments = parser.parse_args()
    numbers = [int(word) for word in arguments.ranks.split(",")]
    folder = pathlib.Path(tempfile.mkdtemp(prefix="interlock_ranks_"))
    runner = Runner(arguments.program.resolve(), folder)
    if arguments.cases == "fixed":
        results = fixed(runner, numbers)
    elif arguments.cases == "random":
        results = random_runs(runner, arguments.seed, arguments.tries, arguments.minutes, numbers)
    else:
        case = pathlib.Path(arguments.cases).resolve()
        results = on_each_number(runner, [(case.stem, case, [])], numbers)
    failed = 0
    for line, good in results:
        failed += not good
        print(line, flush=True)
    if arguments.keep:
        print(f"The runs are in {folder}.")
    else:
        shutil.rmtree(folder, ignore_errors=True)
    print(f"{failed} failed")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
