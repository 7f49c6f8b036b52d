#!/usr/bin/env python3
"""Commands of README and tutorial, typed as they stand there, in a folder of their own.

    commands.py [--long]

What takes long, by the comment behind it (minutes, or more than 15 s), or needs the results of such a command, is
named and not run, but for --long; of a long `interlock run` the parameter file and entries are checked instead. A
command fails when it ends with another exit code than 0.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = ["README.md", "docs/tutorial.md"]
# What no test types, and why.
NEVER = {
    r"^make (pullout|test)\b": "this test is part of them",
    r"peers/compare\.sh": "needs the other programs",
}
# Needs what a long command before it has left, or is meant to be stopped.
AFTER_LONG = re.compile(r"results/quick|results/tutorial/pull\b.*(drop|state_before)|drop results/tutorial|--resume|"
                        r"results/tutorial/softer|results/softer")
NEW_FOLDER = ["apps", "build", "cases", "docs", "python", "tests"]


def blocks(text):
    return re.findall(r"^```(?:bash|sh)?\n(.*?)^```", text, flags=re.S | re.M)


def commands(block):
    """One string a command: with lines that a backslash or a here-document joins."""
    joined, end = "", None
    for line in block.splitlines():
        joined += line + "\n"
        here = re.search(r"<<'?(\w+)'?", line)
        if here and not end:
            end = here.group(1)
            continue
        if end:
            if line != end:
                continue
            end = None
        elif line.endswith("\\"):
            continue
        if joined.strip():
            yield joined.strip()
        joined = ""


def is_long(command):
    comment = command.rpartition(" # ")[2] if " # " in command else ""
    seconds = [float(number) for number in re.findall(r"([\d.]+) s\b", comment)]
    return bool(re.search(r"[\d.]+ (min|h)\b", comment)) or any(s > 15 for s in seconds)


def checked(command):
    """The same run, only checked; None where that says nothing."""
    match = re.search(r"interlock run (\S+)((?:\s*\\?\s*--set (?:\"[^\"]*\"|\S+))*)", command)
    if not match or AFTER_LONG.search(command):
        return None
    return f"build/release/bin/interlock check {match.group(1)}{match.group(2)}".replace("\\\n", " ")


def plan(command, run_long):
    """What is typed instead, and what is said of it."""
    for pattern, why in NEVER.items():
        if re.search(pattern, command):
            return None, f"not run: {why}"
    if run_long:
        return command, "run"
    if AFTER_LONG.search(command):
        return None, "not run: needs a long one"
    if is_long(command):
        instead = checked(command)
        return instead, "checked" if instead else "not run: long"
    return command, "run"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--long", action="store_true", help="run what takes minutes, too")
    arguments = parser.parse_args()
    failed = ran = 0
    with tempfile.TemporaryDirectory(prefix="interlock_documents_") as name:
        folder = pathlib.Path(name)
        for part in NEW_FOLDER:
            if (ROOT / part).exists():
                (folder / part).symlink_to(ROOT / part)
        for document in DOCUMENTS:
            for block in blocks((ROOT / document).read_text()):
                for command in commands(block):
                    instead, verdict = plan(command, arguments.long)
                    if instead:
                        done = subprocess.run(["bash", "-c", instead], cwd=folder, text=True, stdin=subprocess.DEVNULL,
                                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
                        ran += 1
                        if done.returncode != 0:
                            failed += 1
                            verdict = f"FAILED with {done.returncode}: {done.stdout[-1500:]}"
                    print(f"{document}: {command.splitlines()[0]}: {verdict}", flush=True)
    print(f"{ran} commands run or checked, {failed} failed")
    return 1 if failed or not ran else 0


if __name__ == "__main__":
    sys.exit(main())
