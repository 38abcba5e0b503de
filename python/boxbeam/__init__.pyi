import os
from typing import Any, Mapping, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike

from ._errors import AnalysisError as AnalysisError, Error as Error, InputError as InputError
from ._errors import OutputError as OutputError, Problem as Problem
from .results import Check as Check, Cycles as Cycles, Fatigue as Fatigue, Motion as Motion, Section as Section
from .results import Sweep as Sweep, Verification as Verification, study_to_parquet as study_to_parquet

__version__: str
__all__ = ["AnalysisError", "Check", "Cycles", "Error", "Fatigue", "InputError", "Motion", "OutputError", "Problem",
           "Section", "Sweep", "Verification", "damage", "fatigue", "motion", "rainflow", "section", "study_to_parquet",
           "sweep", "verify"]

_Case = Union[str, "os.PathLike[str]", dict]
_Settings = Optional[Mapping[str, Any]]

def verify(case: _Case, set: _Settings = ..., *, folder: Union[str, "os.PathLike[str]", None] = ...) -> Verification: ...
def motion(case: _Case, times: ArrayLike = ..., set: _Settings = ..., *,
           folder: Union[str, "os.PathLike[str]", None] = ...) -> Motion: ...
def section(profile: str, steel: str = ..., forces: Optional[Mapping[str, float]] = ...) -> Section: ...
def rainflow(history: ArrayLike, counting: str = ..., residue: str = ...) -> Cycles: ...
def damage(cycles: Cycles, detail: Union[str, int], *, thickness: Optional[float] = ..., gamma_Ff: float = ...,
           gamma_Mf: float = ..., loading: str = ..., stress_relieved: bool = ...,
           shear: bool = ...) -> Tuple[float, float, float, str]: ...
def fatigue(history: ArrayLike, detail: Union[str, int], *, repetitions: float = ..., counting: str = ...,
            residue: str = ..., thickness: Optional[float] = ..., gamma_Ff: float = ..., gamma_Mf: float = ...,
            loading: str = ..., stress_relieved: bool = ..., shear: bool = ...) -> Fatigue: ...
def sweep(case: _Case, designs: Mapping[str, Union[Sequence[Any], np.ndarray, Tuple[ArrayLike, str]]],
          columns: Sequence[str] = ..., *, threads: int = ...,
          folder: Union[str, "os.PathLike[str]", None] = ...) -> Sweep: ...
