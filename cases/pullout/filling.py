#!/usr/bin/python3 -I
"""Fills the box of pullout.prm with several seeds, up to the state before the pull, on a flattened surface and on one that is not: masses,
densities and flatness as mean and standard deviation beside the paper's. Writes one folder a filling and filling.md.

    filling.py [FOLDER] [--seeds 1,2,3,4,5] [--program PROGRAM] [-- OPTIONS OF interlock run]

default: results/filling; after `make build`. Fillings that are complete are not made again. One core; some two minutes each.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# Entries of each kind of filling. Not flattened, stones in the way of ribs are taken out of the lower half, so more is poured there.
KINDS = {
    "flattened": [],
    "not flattened": ["Geogrid/Placement=not flattened", "Filling/Lower bulk density=1930",
                      "Filling/Upper bulk density=1408"],
}
# The ribs of loose.prm, with which the documents' fillings were measured.
ASSUMED_RIBS = f"Geogrid/Product={ROOT / 'cases/geogrids/assumed_5x2.5.prm'}"
# The shortest pull: only the state before it is wanted.
NO_PULL = ["Pull/Distance=2e-5", "Pull/Ramp time=1e-3", "Output/Field frames=0", "Output/Report=false"]
# Row of the table: value of the results, factor, digits, the paper's value for both kinds and its tolerance.
ROWS = {
    "mass in the box [kg]": ("mass_in_box_kg", 1, 2, (36, 36), 0.02),
    "mass over volume of the box [kg/m3]": ("apparent_density_kg_per_m3", 1, 0, (1500, 1500), 0.03),
    "density below the mean surface [kg/m3]": ("bulk_density_kg_per_m3", 1, 0, None, None),
    "poured on the geogrid [kg]": ("mass_poured_on_geogrid_kg", 1, 2, (18.2, 16.9), 0.05),
    "above the geogrid, by centres [kg]": ("mass_above_geogrid_kg", 1, 2, (18.2, 16.9), 0.05),
    "below the geogrid, by centres [kg]": ("mass_below_geogrid_kg", 1, 2, None, None),
    "porosity of the stones": ("porosity_of_stones", 1, 3, None, None),
    "porosity of the clumps": ("porosity_of_clumps", 1, 3, None, None),
    "mean surface [mm]": ("mean_surface_height_m", 1e3, 1, None, None),
    "geogrid off its plane, largest [mm]": ("geogrid_largest_deviation_m", 1e3, 1, None, None),
    "geogrid off its plane, r.m.s. [mm]": ("geogrid_rms_deviation_m", 1e3, 1, None, None),
}


def results_of(folder, kind, seed, program, options):
    run = folder / f"{kind.replace(' ', '-')}-{seed}"
    if not (run / "summary.json").exists():
        sets = KINDS[kind] + [ASSUMED_RIBS, f"Filling/Seed={seed}"] + NO_PULL
        words = [word for entry in sets for word in ("--set", entry)]
        done = subprocess.run([program, "run", ROOT / "cases/pullout/pullout.prm", *words, *options, "--force", "-o", run],
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if done.returncode not in (0, 3):  # 3: the pull of a hundredth of a millimetre is not to be used
            sys.exit(f"{run}: {done.stderr.strip()}")
    summary = json.loads((run / "summary.json").read_text())
    for warning in summary["warnings"]:
        print(f"{run.name}: {warning}", flush=True)
    return summary["results"]


def cell(values, digits):
    deviation = f" ± {statistics.stdev(values):.{digits}f}" if len(values) > 1 else ""
    return f"{statistics.mean(values):.{digits}f}{deviation}"


def table(fillings):
    lines = ["| | " + " | ".join(f"{kind} | paper" for kind in fillings) + " |", "|---|" + "---|---|" * len(fillings)]
    for name, (key, factor, digits, wanted, tolerance) in ROWS.items():
        cells = []
        for k, results in enumerate(fillings.values()):
            values = [factor * r[key] for r in results]
            cells.append(cell(values, digits))
            if wanted is None:
                cells.append("")
                continue
            met = abs(statistics.mean(values) / wanted[k] - 1) <= tolerance
            cells.append(f"{wanted[k]} ± {100 * tolerance:g} %: {'met' if met else 'MISSED'}")
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def read_arguments(description, folder, add=lambda parser: None):
    """What all scripts of this kind are told, and the options of `interlock run` behind "--". Makes the folder."""
    own = sys.argv[1:]
    options = own[own.index("--") + 1:] if "--" in own else []
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path(folder))
    parser.add_argument("--seeds", default="1,2,3,4,5")
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/interlock"))
    add(parser)
    arguments = parser.parse_args(own[:own.index("--")] if "--" in own else own)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    return arguments, options


def main():
    arguments, options = read_arguments(__doc__.splitlines()[0], "results/filling")
    fillings = {kind: [results_of(arguments.folder, kind, seed, arguments.program, options)
                       for seed in arguments.seeds.split(",")] for kind in KINDS}
    text = table(fillings)
    (arguments.folder / "filling.md").write_text(text)
    print(text, end="")


if __name__ == "__main__":
    main()
