from .case import Case as Case
from .errors import InputError as InputError, Interrupted as Interrupted, RunFailure as RunFailure
from .program import program as program
from .results import Results as Results
from .stones_and_clumps import Clump as Clump, Stone as Stone, clump as clump, stones as stones
from .study import Study as Study

__version__: str
__all__: list[str]
