"""How things end other than well."""

from .run_files import InputError

__all__ = ["InputError", "RunFailure", "Interrupted"]

InputError.__doc__ = "An input that its author can mend; the text is what the program prints, one full sentence a line."


class RunFailure(RuntimeError):
    """A run could not go on, or has ended and its result is not to be used (its files are there then)."""


class Interrupted(RuntimeError):
    """A run was stopped before there was a state to keep."""
