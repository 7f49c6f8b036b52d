#!/usr/bin/env python3
"""Links of the documents: every relative one leads to a file, and to a heading of it where it names one.

    links.py [FILES]        default: all .md files but those of builds and results
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def without_code(text):
    return re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```", "", text, flags=re.S | re.M))


def anchor(heading):
    """As GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors(file):
    return {anchor(heading) for heading in re.findall(r"^#+ (.*)$", file.read_text(), flags=re.M)}


def broken(file):
    for target in re.findall(r"\]\(([^)\s]+)\)", without_code(file.read_text())):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, heading = target.partition("#")
        to = (file.parent / path).resolve() if path else file
        if not to.exists():
            yield f"{target}: there is no such file"
        elif heading and to.suffix == ".md" and heading not in anchors(to):
            yield f"{target}: there is no such heading"


def main():
    names = sys.argv[1:] or [name for name in map(str, (file.relative_to(ROOT) for file in ROOT.rglob("*.md")))
                             if not name.startswith(("build/", "results/"))]
    failures = [f"{name}: {what}" for name in names for what in broken(ROOT / name)]
    print("\n".join(failures) or f"{len(names)} documents, no broken link")
    return 1 if failures or not names else 0


if __name__ == "__main__":
    sys.exit(main())
