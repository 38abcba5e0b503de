"""Results as values: numbers in SI units, many of them as numpy arrays."""

import csv
import dataclasses
import functools
import json
import os
from typing import Any, Dict, List, Optional, Union

import numpy as np


def columns_of(records):
    """Records that are alike as arrays by their keys; what is no number stays a list."""
    if not records:
        return {}
    first = records[0]
    if isinstance(first, dict):
        return {key: columns_of([record[key] for record in records]) for key in first
                if all(key in record for record in records)}
    if all(isinstance(record, (int, float)) and not isinstance(record, bool) for record in records):
        return np.array(records, dtype=float)
    if isinstance(first, list) and all(isinstance(record, list) and len(record) == len(first) for record in records):
        numbers = [x for record in records for x in record]
        if numbers and all(isinstance(x, (int, float)) for x in numbers):
            return np.array(records, dtype=float)
    return list(records)


class _Document:
    """A document of the program in JSON, which is the one source of what the attributes say."""

    def __init__(self, text: str):
        self._written = text

    @property
    def _text(self) -> str:
        return self._written

    @functools.cached_property
    def _data(self) -> Dict[str, Any]:
        return json.loads(self._text)

    def to_dict(self) -> Dict[str, Any]:
        """The document as dictionaries and lists; its schema: `boxbeam schema`."""
        return json.loads(self._text)

    def to_json(self) -> str:
        """The document as the program writes it."""
        return self._text

    def __getitem__(self, key: str) -> Any:
        return self._data[key]

    def __reduce__(self):
        return type(self), (self._text,)


@dataclasses.dataclass(frozen=True)
class Check:
    """One check: what acts, what resists, and how much of it is used."""

    id: str
    criterion: str
    acting: float
    resisting: float
    safety_factor: float
    required: float
    utilisation: float
    unit: str
    station: Optional[float]
    time: Optional[float]
    source: str

    @property
    def passes(self) -> bool:
        return self.utilisation <= 1.0


def _check(of):
    return Check(**{field.name: of.get(field.name) for field in dataclasses.fields(Check)})


class Verification(_Document):
    """What `boxbeam verify` finds ("boxbeam.results/1")."""

    @property
    def case(self) -> str:
        return self._data["case"]

    @property
    def verdict(self) -> str:
        """"pass", "fail" or "not applicable"."""
        return self._data["verdict"]

    @property
    def passes(self) -> bool:
        return self.verdict == "pass"

    @property
    def checks(self) -> List[Check]:
        """The most used first."""
        return [_check(of) for of in self._data["checks"]]

    @property
    def governing(self) -> Dict[str, Check]:
        """The most used check of each criterion that is judged: "yield", "effective section", "patch loading", .."""
        most_used: Dict[str, Check] = {}
        for check in self.checks:
            most_used.setdefault(check.criterion, check)
        return most_used

    @property
    def mass(self) -> float:
        """Of the beam that decides [kg]."""
        return self._data["beam"]["mass"]

    @property
    def stations(self) -> Dict[str, Any]:
        """Cut forces of the beam that decides: "s" [m], "side", and [n, 2] arrays of least and largest "N", "V", "M"
        (in space "V_y", "V_z", "T", "M_y", "M_z") [N, N m]."""
        return columns_of(self._data["beam"]["stations"])

    @property
    def remarks(self) -> List[str]:
        return list(self._data["remarks"])

    def __repr__(self):
        worst = self._data["checks"][0] if self._data["checks"] else None
        said = f", {worst['id']} used {100 * worst['utilisation']:.1f} %" if worst else ""
        return f"<boxbeam.Verification {self.case}: {self.verdict}{said}>"


class Motion(_Document):
    """What `boxbeam motion` finds ("boxbeam.motion/1"); `columns` has its states as arrays over `time`.

    The document itself is written when it is asked for: of very many instants ask for the columns."""

    def __init__(self, of):
        self._of = of

    @functools.cached_property
    def _text(self) -> str:
        return self._of if isinstance(self._of, str) else self._of.json()

    @property
    def kind(self) -> str:
        return self._data["kind"]

    @functools.cached_property
    def columns(self) -> Dict[str, Any]:
        """By the keys of a state, columns["bodies"]["beam"]["ax"]; empty where there are none. Vectors are arrays
        [n, 3], rotations [n, 3, 3]; numbers stay where the program has put them."""
        return columns_of(self._data.get("states", [])) if isinstance(self._of, str) else self._of.columns()

    @property
    def time(self) -> np.ndarray:
        """Instants [s]."""
        return self.columns.get("time", np.empty(0))

    def __repr__(self):
        return f"<boxbeam.Motion {self.kind}, {len(self.time)} instants>"


class Section(_Document):
    """What `boxbeam section` finds ("boxbeam.section/1"); its numbers are items: section["I_y"] [m^4]."""

    def __repr__(self):
        return f"<boxbeam.Section {self._data.get('name', '')}: area {self._data['area']:.6g} m^2>"


@dataclasses.dataclass(frozen=True)
class Cycles:
    """Cycles of a history, in the order in which they close [Pa]."""

    range: np.ndarray
    mean: np.ndarray
    count: np.ndarray


@dataclasses.dataclass(frozen=True)
class Fatigue:
    """What a history of stress does to a detail."""

    cycles: Cycles
    damage: float
    safety_factor: float     #: on the loads, up to a damage of 1
    equivalent_range: float  #: of 2e6 cycles with the same damage [Pa]
    life: float              #: repetitions of the history up to a damage of 1; inf without damage
    curve: str               #: with the size effect where the thickness is given

    @property
    def passes(self) -> bool:
        return self.damage <= 1.0


@dataclasses.dataclass(frozen=True)
class Sweep:
    """Designs that were verified: results by column, one entry a design; NaN or "" where it has none."""

    columns: Dict[str, Any]
    units: Dict[str, str]
    status: List[str]  #: "ok", or why a design could not be verified

    @property
    def ok(self) -> np.ndarray:
        """Which designs were verified."""
        return np.array([words == "ok" for words in self.status], dtype=bool)

    def __getitem__(self, column: str) -> Any:
        return self.columns[column]

    def to_parquet(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes all columns and `status` to an Apache Parquet file, units as metadata "unit" of the columns.
        Wants pyarrow."""
        import pyarrow  # type: ignore
        import pyarrow.parquet  # type: ignore
        columns = {**self.columns, "status": self.status}
        fields, arrays = [], []
        for name, values in columns.items():
            # Arrays of doubles are handed on without being copied; NaN is no number.
            arrays.append(pyarrow.array(values, from_pandas=True))
            fields.append(_with_unit(pyarrow.field(name, arrays[-1].type), self.units.get(name, "")))
        pyarrow.parquet.write_table(pyarrow.Table.from_arrays(arrays, schema=pyarrow.schema(fields)), os.fspath(path))

    def __len__(self):
        return len(self.status)

    def __repr__(self):
        return f"<boxbeam.Sweep of {len(self)} designs, {int((~self.ok).sum())} not verified>"


def _with_unit(field, unit):
    return field.with_metadata({"unit": unit}) if unit else field


def study_to_parquet(folder: Union[str, "os.PathLike[str]"], path: Union[str, "os.PathLike[str]", None] = None) -> str:
    """Writes the table of a study, rows.csv in the folder of `boxbeam sweep`, as an Apache Parquet file, block by block:
    numbers as doubles with their units as metadata "unit", the rest as texts. path: rows.parquet beside it. Returns the
    path. Wants pyarrow."""
    import pyarrow  # type: ignore
    import pyarrow.csv  # type: ignore
    import pyarrow.parquet  # type: ignore
    folder = os.fspath(folder)
    path = os.path.join(folder, "rows.parquet") if path is None else os.fspath(path)
    with open(os.path.join(folder, "study.json"), encoding="utf-8") as file:
        numbers = {of["column"]: of["unit"] for of in json.load(file)["statistics"]}
    rows = os.path.join(folder, "rows.csv")
    with open(rows, encoding="utf-8", newline="") as file:
        names = next(csv.reader(file))
    types = {name: pyarrow.float64() if name in numbers else pyarrow.string() for name in names}
    types["design"] = pyarrow.int64()
    schema = pyarrow.schema([_with_unit(pyarrow.field(name, types[name]), numbers.get(name, "")) for name in names])
    options = pyarrow.csv.ConvertOptions(column_types=types, null_values=[""], strings_can_be_null=False)
    with pyarrow.csv.open_csv(rows, convert_options=options) as blocks, \
            pyarrow.parquet.ParquetWriter(path, schema) as writer:
        for block in blocks:
            writer.write_table(pyarrow.Table.from_batches([block]).cast(schema))
    return path
