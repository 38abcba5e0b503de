"""What can go wrong, as exceptions."""

import re
from typing import List, NamedTuple, Optional


class Error(Exception):
    """Every exception of boxbeam."""


class Problem(NamedTuple):
    """One thing wrong in the input."""

    file: str
    line: int
    column: int
    key: Optional[str]
    message: str
    hint: str


class InputError(Error, ValueError):
    """The input is wrong. `problems` has all that was found; file, line, column, key, message and hint are those of the
    first. line 0: the problem has no line; key None: its line sets none."""

    def __init__(self, text, problems):
        super().__init__(text)
        self.problems: List[Problem] = [
            Problem(file, line, column, _key_of(source), message, hint)
            for file, line, column, source, message, hint in problems]
        first = self.problems[0] if self.problems else Problem("", 0, 0, None, text, "")
        self.file, self.line, self.column, self.key, self.message, self.hint = first

    def __reduce__(self):  # what another process raised comes back whole
        return _input_error, (str(self), [tuple(problem) for problem in self.problems])


class AnalysisError(Error, RuntimeError):
    """The analysis cannot be done. where: joint, body or station; time [s], residual (SI) and condition where known."""

    def __init__(self, text, what="", where="", time=None, residual=None, condition=None, details=()):
        super().__init__(text)
        self.what, self.where = what, where
        self.time, self.residual, self.condition = time, residual, condition
        self.details = list(details)

    def __reduce__(self):
        return AnalysisError, (str(self), self.what, self.where, self.time, self.residual, self.condition, self.details)


class OutputError(Error, OSError):
    """A result is no number, or a file could not be read or written."""


def _key_of(source):
    found = re.match(r"""\s*([\w.\-"' ]+?)\s*=""", source)
    return found.group(1) if found else None


def _input_error(text, problems):
    error = InputError(text, [])
    error.problems = [Problem(*problem) for problem in problems]
    if error.problems:
        error.file, error.line, error.column, error.key, error.message, error.hint = error.problems[0]
    return error
