"""Where the program `interlock` is that belongs to this package."""

import os
import shutil

from .errors import InputError

PACKAGE = os.path.dirname(os.path.abspath(__file__))
# BUILD/python/interlock beside BUILD/bin; PREFIX/lib/python3/dist-packages/interlock beside PREFIX/bin.
BESIDE = [os.path.normpath(os.path.join(PACKAGE, *[".."] * up, "bin", "interlock")) for up in (2, 4)]


def program():
    """The path of the program. Raises InputError when there is none."""
    for path in BESIDE:
        if os.access(path, os.X_OK):
            return path
    path = shutil.which("interlock")
    if path is None:
        raise InputError(f"The program interlock is neither beside the package ({', '.join(BESIDE)}) nor on the PATH.")
    return path
