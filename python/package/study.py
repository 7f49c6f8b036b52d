"""A study: many runs that a file describes (docs/studies.md). They are processes of the program."""

import os
import signal
import subprocess

from . import run_files
from .errors import Interrupted, RunFailure
from .program import program
from .results import Results, _pandas
from .run_files import InputError

__all__ = ["Study"]


class Study:
    """Study("my_study.prm") is a study to be run, into results/my_study or `folder`; Study("results/my_study") one that
    is there."""

    def __init__(self, file, folder=None):
        file = os.fspath(file)
        if os.path.isdir(file):
            self.file, self.folder = None, file
        else:
            name = os.path.splitext(os.path.basename(file))[0]
            self.file, self.folder = file, os.fspath(folder or os.path.join("results", name))

    def __repr__(self):
        return f"Study({self.file or self.folder!r})"

    def plan(self):
        """Checks every combination and says how many runs there are, how long they take, how much disk: the text of
        `interlock study --check`. Raises InputError with its sentences."""
        return self._call("--check", quiet=True)

    def run(self, jobs=1, *, force=False, quiet=True):
        """Makes the runs that are missing, `jobs` at a time, and the tables. A study that was interrupted goes on.
        Returns itself. Raises InputError, RunFailure when a run failed or is not to be used, KeyboardInterrupt after
        Control-C; runs keep their states."""
        self._call("--jobs", str(jobs), *(["--force"] if force else []), quiet=quiet)
        return self

    @property
    def runs(self):
        """runs.csv: dict of arrays, one entry a run: run (its name), filling, levels, status, measures with their units."""
        return self._table("runs.csv")

    @property
    def means(self):
        """means.csv: mean, standard deviation and interval of each point and measure over the fillings."""
        return self._table("means.csv")

    @property
    def differences(self):
        """differences.csv: paired differences of each level from the first one."""
        return self._table("differences.csv")

    @property
    def variance(self):
        """variance.csv: the parts of the variance."""
        return self._table("variance.csv")

    def table(self, name="runs"):
        """One of these tables as a pandas DataFrame."""
        return _pandas().DataFrame(self._table(name + ".csv"))

    def results(self, name):
        """The Results of one run, by its name in `runs`."""
        return Results(os.path.join(self.folder, "runs", name))

    def _table(self, name):
        path = os.path.join(self.folder, name)
        if not os.path.isfile(path):
            raise InputError(f"{self.folder}: there is no {name}, so no study has been run there.")
        return run_files.read_table(path)

    def _call(self, *options, quiet):
        if self.file is None:
            raise InputError(f"{self.folder} is a study that is there; to run one, name its file.")
        # Not what MPI has added in this process: the program would take itself for a rank of it.
        call = subprocess.Popen([program(), "study", self.file, "--output", self.folder, *options],
                                stdout=subprocess.PIPE if quiet else None, stderr=subprocess.PIPE, text=True,
                                env=dict(os.environ), start_new_session=True)
        try:
            said, errors = call.communicate()
        except KeyboardInterrupt:
            call.send_signal(signal.SIGINT)  # a session of its own: the terminal's has not reached it
            call.communicate()
            raise
        sentences = "\n".join(_bare(line) for line in errors.splitlines())
        if call.returncode == 2:
            raise InputError(sentences)
        if call.returncode == 130:
            raise Interrupted(sentences)
        if call.returncode != 0:
            raise RunFailure(sentences or f"the program ended with {call.returncode}.")
        return said


def _bare(line):
    for start in ("interlock: error: ", "interlock: "):
        if line.startswith(start):
            return line[len(start):]
    return line
