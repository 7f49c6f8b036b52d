#!/usr/bin/python3
"""How large a report.html is, how soon it shows its first picture, how many pictures a second it draws.

    report_page.py FILE...        pages of any runs with frames

In headless Chromium without a graphics card (tests/page_in_browser.py), where a picture costs some ten times what it
does with one. Pictures go through all frames and are waited for to the last pixel, after ten that are not counted. Beside wall-clock time stands
the processor time of all of Chromium's processes, which a busy machine changes less.
"""

import argparse
import glob
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.realpath(__file__)), ".."))
from page_in_browser import PHONE, Browser

COUNT = 60
DRAW = """
const {replay} = report;
replay.move(arguments[0]);
const time = report.measurePictures(replay, arguments[1]);
replay.move(false);
return time;"""


def processor_time(root):
    """Of a process and all that it has started [s]."""
    children, own = {}, {}
    for path in glob.glob("/proc/[0-9]*/stat"):
        try:
            with open(path, encoding="utf-8") as file:
                words = file.read().rpartition(")")[2].split()
        except OSError:
            continue
        pid = int(path.split("/")[2])
        children.setdefault(int(words[1]), []).append(pid)
        own[pid] = (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")

    def tree(pid):
        return own.get(pid, 0) + sum(tree(child) for child in children.get(pid, []))

    return tree(root)


def measure(page):
    print(f"{page}: {os.path.getsize(page) / 1e6:.2f} MB")
    for name, size in (("1400 x 1000", None), ("phone", PHONE)):
        with Browser(size) if size else Browser() as browser:
            browser.open(page)
            print(f"  {name}: first picture after {browser.run('return report.firstPicture') / 1e3:.2f} s", flush=True)
            for what, is_moving in (("while it moves", True), ("at rest", False)):
                browser.run(DRAW, is_moving, 10)  # what the browser compiles on the way
                before = processor_time(browser.process)
                wall = browser.run(DRAW, is_moving, COUNT)
                spent = 1e3 * (processor_time(browser.process) - before) / COUNT
                print(f"  {name}, {what}: {wall:.0f} ms a picture, {1e3 / wall:.0f} a second; {spent:.0f} ms of processor "
                      "time each", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("pages", nargs="+", metavar="FILE")
    for page in parser.parse_args().pages:
        measure(page)


if __name__ == "__main__":
    main()
