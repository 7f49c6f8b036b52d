"""Matplotlib as it comes, drawing into files, whatever the user's environment says. Import it before Matplotlib.

Neither MPLBACKEND, MATPLOTLIBRC, a matplotlibrc in the current folder or at home, nor a home that cannot be written
matters. PYTHONPATH, PYTHONHOME and packages below the home folder are kept away by the scripts' first line,
`#!/usr/bin/python3 -I`; with it Python does not look for modules beside a script either, so each script adds
its own folder itself. The list of fonts, which takes seconds to make, is kept in ~/.cache/interlock/matplotlib, or in
a temporary folder where that cannot be written.
"""

import atexit
import logging
import os
import shutil
import sys
import tempfile


def cache_folder():
    caches = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    folder = os.path.join(caches, "interlock", "matplotlib")
    try:
        # A home that does not exist is not to be made.
        if os.path.isdir(os.path.dirname(caches)):
            os.makedirs(folder, exist_ok=True)
            with tempfile.TemporaryFile(dir=folder):
                return folder
    except OSError:
        pass
    folder = tempfile.mkdtemp(prefix="interlock-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


for name in ("MPLBACKEND", "MATPLOTLIBRC"):
    os.environ.pop(name, None)
os.environ["MPLCONFIGDIR"] = cache_folder()
# On a busy machine it says that the list of fonts takes a while.
logging.getLogger("matplotlib.font_manager").setLevel(logging.ERROR)
# A matplotlibrc in the current folder goes before all others and is read by the import itself.
here = os.open(".", os.O_PATH)
os.chdir("/")
try:
    import matplotlib
finally:
    os.fchdir(here)
    os.close(here)

matplotlib.rcdefaults()  # nor that of the machine in /etc
matplotlib.use("Agg")

# Names of a run's folder may hold letters that the terminal's encoding lacks.
for stream in (sys.stdout, sys.stderr):
    stream.reconfigure(errors="backslashreplace")
