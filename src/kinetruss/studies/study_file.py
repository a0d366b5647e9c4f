"""A study: a run of a model, the variables that change it, how they are sampled and what is kept; read from a file."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Annotated, Any

from pydantic import BeforeValidator, Field, ValidationError, model_validator

from kinetruss.errors import Fault, InputError, shown
from kinetruss.io import MAX_SIZE
from kinetruss.io.records import record_of_file
from kinetruss.limits import MOST_VARIANTS
from kinetruss.model import Model, Record
from kinetruss.model.record import Name, Whole, one_format
from kinetruss.model.table import Table
from kinetruss.model.words import faults_of
from kinetruss.units import NUMBER

FORMAT = 1
START = "Start with kinetruss_study: 1, then model, run or optimum, variables, sample, results."
RANDOM = ("latin_hypercube", "sobol", "monte_carlo", "saltelli")
"""Samples that are drawn, each with its number of points."""

Text = Annotated[str, BeforeValidator(lambda value: str(value) if isinstance(value, (int, float)) else value)]
"""A value as it stands in a model file."""
Count = Annotated[Whole, Field(ge=1, le=MOST_VARIANTS)]


def parted(text: str) -> tuple[float, str] | None:
    """Number and unit of a text; None if it is none.

    >>> parted("40 kg"), parted("0.5"), parted("steel_s235")
    ((40.0, 'kg'), (0.5, ''), None)
    """
    found = NUMBER.match(text.strip())
    if found is None:
        return None
    unit = text.strip()[found.end() :].strip()
    return None if unit[:1].isdigit() else (float(found[0]), unit)


def unit_in(texts: Iterable[str]) -> str | None:
    """The unit that all texts have; None if they have none in common."""
    units = {None if (one := parted(text)) is None else one[1] for text in texts}
    return units.pop() if len(units) == 1 else None


class Variable(Record):
    """What changes from variant to variant: the value at one path of the model, or the same value at several.

    paths : as for `io.set_value`; by default the name of the variable is the path.
    values : a list of values, as in a model file. between : least and largest value, evenly distributed. normal : mean and
    standard deviation of a normal distribution. Both numbers have the same unit: ``[10 kg, 40 kg]``.
    """

    paths: tuple[str, ...] = ()
    values: Annotated[tuple[Text, ...], Field(min_length=1)] | None = None
    between: tuple[Text, Text] | None = None
    normal: tuple[Text, Text] | None = None

    @model_validator(mode="before")
    @classmethod
    def _from_list(cls, value: Any) -> Any:
        return {"values": value} if isinstance(value, (list, tuple)) else {} if value is None else value

    @model_validator(mode="after")
    def _one(self) -> Variable:
        given = [name for name in ("values", "between", "normal") if getattr(self, name) is not None]
        if len(given) > 1:
            raise ValueError(f"has {' and '.join(given)}. Give one of them.")
        if self.values is not None and len(set(self.values)) < len(self.values):
            raise ValueError(f"has a value twice: {', '.join(self.values)}. Leave one out.")
        for pair in (self.between, self.normal):
            if pair is not None:
                self._numbers(pair)
        return self

    def _numbers(self, pair: tuple[str, str]) -> None:
        found = [parted(text) for text in pair]
        if None in found or found[0][1] != found[1][1]:  # type: ignore[index]
            raise ValueError(f"has {pair[0]!r} and {pair[1]!r}. Give two numbers with the same unit, e.g. [10 kg, 40 kg].")
        (first, _), (second, _) = found  # type: ignore[misc]
        if self.between is not None and not first < second:
            raise ValueError(f"is between {pair[0]} and {pair[1]}. Give the smaller number first.")
        if self.normal is not None and not second > 0:
            raise ValueError(f"has the standard deviation {pair[1]}. Give a positive one, e.g. normal: [0 mm, 1 mm].")

    @property
    def unit(self) -> str | None:
        """The unit in which its numbers are given ("" of bare ones, which are in SI); None if its values are texts."""
        return unit_in(self.values or self.between or self.normal or ())


class Sample(Record):
    """How the variables are sampled: one of these.

    grid : all combinations, with so many equidistant values of each variable `between` two numbers; variables with `values`
    have these. latin_hypercube, sobol (scrambled; a power of two), monte_carlo : so many points. saltelli : so many base points
    of Saltelli's design (a power of two), which has d + 2 times as many points, for Sobol indices of d variables.
    table : a CSV file with a column of values for each variable, under its name. seed : of the draws.
    """

    grid: Count | None = None
    latin_hypercube: Count | None = None
    sobol: Count | None = None
    monte_carlo: Count | None = None
    saltelli: Count | None = None
    table: str | None = None
    seed: Annotated[Whole, Field(ge=0)] = 0

    @model_validator(mode="after")
    def _one(self) -> Sample:
        given = [name for name in type(self).model_fields if name != "seed" and getattr(self, name) is not None]
        if len(given) != 1:
            what = f"has {' and '.join(given)}" if given else "names no way of sampling"
            raise ValueError(f"{what}. Give one of grid, latin_hypercube, sobol, monte_carlo, saltelli, table.")
        for name in ("sobol", "saltelli"):
            count = getattr(self, name)
            if count is not None and count & (count - 1):
                near = 2 ** round(math.log2(count))
                raise ValueError(f"{name}: {count} is no power of two, which Sobol points need. Give for example {near}.")
        return self

    @property
    def kind(self) -> str:
        """The way of sampling."""
        return next(name for name in type(self).model_fields if getattr(self, name) is not None)


def _model(value: Any) -> Any:
    if isinstance(value, (Model, str)):
        return value
    if isinstance(value, Path):
        return str(value)
    raise ValueError(f"{shown(value)} is no model. Give the path of a model file, or a Model.")


class Study(Record):
    """Many variants of a run, and the numbers that are kept of each.

    model : a model file or a `Model`. run : a run of it, of any analysis, a mission too; may be omitted if there is only one.
    optimum : in place of a run the file of the task of an optimum, as of `io.read_optimum`: each variant is an optimum of the
        model. Paths that begin with ``optimum.`` change the task: ``optimum.limits.sag.at_most``.
    variables : name -> what it changes; a plain list are its values. sample : by default a grid of all `values`.
    results : name -> what is kept of every variant, e.g. ``peak: max(abs(member_force))`` (`studies.scalars`); by default its
    largest utilisation, member force, drive force and power, displacement, and its mass.

    Examples
    --------
    >>> import kinetruss as kt
    >>> study = kt.studies.Study(
    ...     model="four_bar.yaml", variables={"nodes.C.mass": {"between": ["0.2 kg", "1 kg"]}}, sample={"sobol": 8}
    ... )
    >>> study.variables["nodes.C.mass"].unit
    'kg'
    """

    kinetruss_study: Annotated[int, one_format(FORMAT, "kinetruss_study", "study format {}")] = FORMAT
    title: str = ""
    model: Annotated[Any, BeforeValidator(_model)]
    run: Name | None = None
    optimum: str | None = None
    variables: Table[str, Variable] = Field(default_factory=dict)
    sample: Sample | None = None
    results: Table[str, str] = Field(default_factory=dict)

    @model_validator(mode="after")
    def _sampled(self) -> Study:
        if self.run is not None and self.optimum is not None:
            raise ValueError("has a run and an optimum. Leave one of them out.")
        kind = "" if self.sample is None else self.sample.kind
        table = kind == "table"
        if not self.variables and not table:
            raise ValueError("has no variables. Give for example variables: {nodes.B.mass: {between: [10 kg, 40 kg]}}.")
        for name, one in self.variables.items():
            if table and (one.values or one.between or one.normal):
                raise ValueError(f"variables.{name} has values of its own and a table. Leave one of them out.")
            if not table and not (one.values or one.between or one.normal):
                raise ValueError(f"variables.{name} has no values. Give values: [..], between: [.., ..] or normal: [.., ..].")
            if kind == "grid" and one.normal is not None:
                raise ValueError(f"variables.{name} is normal, which has no grid. Give between, or sample: {{sobol: 256}}.")
            if kind == "grid" and one.between is not None and self.sample.grid < 2:  # type: ignore[operator, union-attr]
                raise ValueError(f"variables.{name} is between two numbers. Give sample: {{grid: 5}} or {{sobol: 256}}.")
        return self

    @classmethod
    def _faults(cls, error: ValidationError, data: dict[str, Any]) -> list[Fault]:
        return faults_of(error, data, cls)

    def paths_of(self, name: str) -> tuple[str, ...]:
        """The paths that a variable sets; one that is not listed, of a table, is a path itself."""
        one = self.variables.get(name)
        return one.paths if one is not None and one.paths else (name,)


def read_study(path: str | Path, *, max_size: int = MAX_SIZE) -> Study:
    r"""Read a study from a YAML or JSON file; paths of its model and table are relative to it.

    Raises
    ------
    ModelError : all faults of the file at once, each with line and column and its fix.

    Examples
    --------
    >>> import kinetruss as kt
    >>> import tempfile
    >>> from pathlib import Path
    >>> text = "model: four_bar.yaml\nvariables: {nodes.C.mass: [0.5 kg, 1 kg]}\n"
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = Path(folder, "mass.study.yaml").write_text(text)
    ...     study = kt.studies.read_study(Path(folder, "mass.study.yaml"))
    >>> study.variables["nodes.C.mass"].values
    ('0.5 kg', '1 kg')
    """
    file = Path(path)

    def build(data: Mapping[str, Any]) -> Study:
        found = dict(data)
        for name in ("model", "optimum"):
            if isinstance(found.get(name), str):
                found[name] = str(file.parent / found[name])
        sample = found.get("sample")
        if isinstance(sample, dict) and isinstance(sample.get("table"), str):
            found["sample"] = sample | {"table": str(file.parent / sample["table"])}
        return Study(**found)

    others = {"model": "A study names it: model: FILE.", "mission": "Size it by kinetruss size."}
    return record_of_file(file, build, START, "a study", others, max_size)


def study_of(given: Study | str | Path, max_size: int = MAX_SIZE) -> Study:
    """A study, or that of a file.

    Raises
    ------
    InputError : neither.
    """
    if isinstance(given, (str, Path)):
        return read_study(given, max_size=max_size)
    if not isinstance(given, Study):
        raise InputError(f"A study is expected, not {shown(given)}. Give a kt.studies.Study or the path of a study file.")
    return given
