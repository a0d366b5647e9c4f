"""Do a study: check it, go on with its ledger, compute what is left beside each other, and keep every outcome."""

from __future__ import annotations

import math
import pickle
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from kinetruss import __version__
from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.io import MAX_SIZE, placed
from kinetruss.io.exporting import needed
from kinetruss.io.values import resolved
from kinetruss.io.yaml_text import read_text
from kinetruss.limits import whole
from kinetruss.model import Model
from kinetruss.runs.plans import chosen_run
from kinetruss.runs.processes import beside, processors
from kinetruss.runs.variant_sets import Base
from kinetruss.studies.brief_runs import LEVELS
from kinetruss.studies.evaluating import DIED, FAILED, Outcome, Rows, Task, evaluate, outcome_of, ready
from kinetruss.studies.kept_numbers import Kept
from kinetruss.studies.ledger import PAUSE, Contents, Ledger, claimed, in_memory, write_parquet
from kinetruss.studies.nominal_gradients import nominal_gradients
from kinetruss.studies.optima import OPTIMUM, Numbers, Tasks
from kinetruss.studies.sampling import points_of
from kinetruss.studies.study_file import Study, study_of
from kinetruss.studies.study_result import StudyResult, result_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Progress = Callable[[int, int], None]
Found = list[Outcome] | None
"""What became of some rows; None: the process that computed them died."""
Executor = Callable[[Task, Sequence[Rows]], Iterator[tuple[int, Found]]]

NOMINAL = -1
"""The row of the model as it is."""
TRIES = 3
"""How often a row may cost the process that computes it."""
BATCH = 0.5
"""Seconds of work that a process is given at once."""
PILOT = 2
"""Batches of each process that tell how long a row takes."""
FASTER = 0.7
"""Fraction of the time of a row from which on the next batches tell once more."""
LARGEST = 512
"""Most rows in a batch."""
PROBES = 10.0
"""Seconds that it may take to find out whether every variable changes a result."""


def run_study(
    study: Study | str | Path,
    out: str | Path | None = None,
    *,
    workers: int | None = None,
    cluster: str | None = None,
    overwrite: bool = False,
    check: bool = True,
    points: ArrayLike | None = None,
    progress: Progress | None = None,
    max_size: int = MAX_SIZE,
) -> StudyResult:
    """Do a study: the run of every variant, and of each the numbers that are kept.

    Parameters
    ----------
    study : a `Study`, or its file. out : folder of the ledger and of ``results.parquet``; the same study goes on there. None
        keeps everything in memory.
    workers : processes on this machine; by default all processors; 0: this process, which a variant that crashes ends.
    cluster : address of the scheduler of a Dask cluster instead, e.g. ``tcp://127.0.0.1:8786``; all its workers are used.
        Nothing is started there.
    overwrite : replace another study in `out`. check : refuse variables that change none of the results.
    points : (points, variables) from 0 to 1 instead of the sample of the study, e.g. ``qmc.Halton(2).random(100)`` of SciPy.
    progress : called with (rows done, rows). max_size : largest size of a file, bytes.

    Returns
    -------
    StudyResult. A variant that the model does not allow, that does not converge or whose process dies three times has a status
    and a message, and no numbers.

    Raises
    ------
    ModelError, InputError : faults of study, model, variables, results or points; another study in `out`; a cluster that is not
        reached, or has no workers. Nothing was computed.
    StoreError : another process writes `out`, or it cannot be written. AnalysisError : the cluster is lost; rows that are done
        are kept.

    Notes
    -----
    A row is computed once: the ledger is committed every second, and a study that is started again computes only rows that are
    not in it. A kill costs the rows being computed and at most those of the last second.

    Examples
    --------
    >>> import kinetruss as kt
    >>> study = kt.studies.Study(
    ...     model=kt.library.example_files()["four_bar"][0], run="turn",
    ...     variables={"nodes.C.mass": {"between": ["0.2 kg", "1 kg"]}}, sample={"grid": 3},
    ...     results={"peak": "peak_member_force"},
    ... )
    >>> found = kt.studies.run_study(study, workers=1)
    >>> found.data["nodes.C.mass"].values.tolist(), found.data["peak"].values.round(2).tolist()  # kg, N
    ([0.2, 0.6000000000000001, 1.0], [6.6, 11.06, 15.6])
    """
    file = None if isinstance(study, Study) else Path(study)
    given = study_of(study, max_size)
    if workers is not None:
        whole(workers, "workers", least=0)
    parquet = None if out is None else (needed("pyarrow", "export", "A study"), needed("pyarrow.parquet", "export", "A study"))
    try:
        job = _Job(given, points, max_size)
    except ModelError as error:
        raise _placed(error, file, max_size) from None
    kept = in_memory(job.contents) if out is None else claimed(Path(out), job.contents, overwrite=overwrite)
    with _executor(workers, cluster) as (executor, count), kept as ledger:
        try:
            nominal = job.begin(ledger, executor, local=cluster is None, check=check)
            _work(ledger, executor, count, job, nominal, progress)
        except ModelError as error:
            raise _placed(error, file, max_size) from None
        finally:
            ledger.commit()
            if parquet is not None:
                write_parquet(ledger, *parquet)
        return result_of(ledger)


def _placed(error: ModelError, file: Path | None, max_size: int) -> ModelError:
    """Faults of variables with their place in the file of the study."""
    if file is None or error.source is not None:
        return error
    return ModelError(placed(file, error.faults, max_size=max_size), str(file))


class _Job:
    """A study that was checked: its base, its points, and what its numbers depend on."""

    def __init__(self, study: Study, cube: ArrayLike | None, max_size: int) -> None:
        self.study = study
        self.base: Base | Tasks = Base(study.model, max_size)
        self.kept: Kept | Numbers = Kept(study.results)
        model, optimum = self.base.with_({}), ""
        if study.optimum is not None:
            optimum = read_text(Path(study.optimum), max_size)
            self.base = Tasks(self.base, optimum)
            self.kept = Numbers(self.base.task, study.results)
        self.run = "" if optimum else chosen_run(model, study.run)
        self.points = points_of(study, cube)
        self.paths = {name: study.paths_of(name) for name in self.points.names}
        self._check_paths(model)
        kept = self.kept
        text = model.model_dump_json()
        every = [path for own in self.paths.values() for path in own]
        built = _pickled(model) if any(path.startswith(("library.", "parameters.")) for path in every) else b""
        self.task = Task("" if built else text, self.run, tuple(kept.texts.items()), built, optimum=optimum, max_size=max_size)
        whole = {
            "model": text,
            "run": self.run,
            **({"optimum": optimum} if optimum else {}),
            **({"built by": model.recipe.source} if built and model.recipe is not None else {}),
            "variables": {name: list(paths) for name, paths in self.paths.items()},
            "points": [list(self.points.units), [list(row) for row in self.points.rows]],
            "results": dict(kept.texts),
            "version of kinetruss": __version__,
        }
        saltelli = 0 if study.sample is None or cube is not None else study.sample.saltelli or 0
        results = {name: (text, kept.units.get(name, "")) for name, text in kept.texts.items()}
        more = {"title": study.title or (self.base.task.title if isinstance(self.base, Tasks) else ""), "base points": saltelli}
        self.contents = Contents(whole=whole, more=more, points=self.points, results=results)

    def _check_paths(self, model: Model) -> None:
        """Refuse variables that do not exist, set what another one sets, or change nothing that the run depends on."""
        faults, owner = list[Fault](), dict[str, str]()
        for name, paths in self.paths.items():
            for path in paths:
                if owner.setdefault(path, name) != name:
                    faults.append(Fault(("variables", name), f"sets {path!r}, as {owner[path]!r} does.", "Leave one out."))
                if not (self.study.optimum is not None and path.startswith(OPTIMUM)):
                    faults += _unknown(model, name, path)
        if faults:
            raise ModelError(faults)
        self._check_values()
        for name in self.paths if self.study.optimum is None else ():
            pair = self._ends(name)
            if pair and _used(pair[0], self.run) == _used(pair[1], self.run):
                mend = f"Remove it, or change what run {self.run!r} depends on."
                faults.append(Fault(("variables", name), "does nothing: the run is the same for all its values.", mend))
        if faults:
            raise ModelError(faults)

    def _check_values(self) -> None:
        """Refuse values of which none is allowed, as those in another unit."""
        count = len(self.points.rows)
        refused = list[InputError]()
        for k in dict.fromkeys((0, count // 2, count - 1)):
            try:
                self.base.with_(self._values(k, self.points.names))
                return
            except InputError as error:
                refused.append(error)
        for name in self.points.names:
            try:
                self.base.with_(self._values(0, [name]))
            except ModelError as error:
                path, faults = ("variables", name), error.faults
                raise ModelError([Fault(path, f"{one.path[-1]}: {one.message}", one.mend) for one in faults]) from None
        raise refused[0]

    def _ends(self, name: str) -> tuple[Any, Any] | None:
        """The base with two values of one variable; None if it has one alone, or they are not allowed by themselves."""
        k = self.points.names.index(name)
        column = [row[k] for row in self.points.rows]
        first, last = min(range(len(column)), key=lambda i: column[i]), max(range(len(column)), key=lambda i: column[i])
        if column[first] == column[last]:
            return None
        try:
            return self.base.with_(self._values(first, [name])), self.base.with_(self._values(last, [name]))
        except (ModelError, InputError):
            return None

    def _values(self, k: int, names: Sequence[str]) -> dict[str, Any]:
        """The values of row k by path, of some variables."""
        texts = self.points.texts(k)
        return {path: texts[name] for name in names for path in self.paths[name]}

    def rows(self, numbers: Sequence[int]) -> Rows:
        """Rows with their values."""
        return [(k, self._values(k, self.points.names)) for k in numbers]

    def begin(self, ledger: Ledger, executor: Executor, *, local: bool, check: bool) -> Outcome | None:
        """The model as it is, done once: it shows faults of results before all else is computed. Here, if nothing was begun
        here before that did not end, so that the processes have its kernels.
        """
        if (known := ledger.about("nominal")) is not None:
            self.task = replace(self.task, level=ledger.about("level") or LEVELS[-1])
            return None if known == "begun" else Outcome(**known)
        ledger.note("nominal", "begun")
        rows: Rows = [(NOMINAL, {})]
        for level in LEVELS:  # what a brief run does not have, a fuller one may have
            self.task = replace(self.task, level=level)
            outcomes = evaluate(self.task, rows) if local else next(one for _, one in executor(self.task, [rows]))
            if outcomes is None:
                return None
            (found,) = outcomes
            if not (found.status == FAILED and found.message.startswith("results.")):
                break
        else:
            raise InputError(found.message)
        ledger.note("level", self.task.level)
        if check and local and self.study.optimum is None:
            self._check_influence(found)
        ledger.note("nominal", {name: getattr(found, name) for name in Outcome.__dataclass_fields__})
        if found.numbers is not None and isinstance(self.base, Base):
            ledger.note("gradients", nominal_gradients(self.base.with_({}), self.run, self.kept.texts, self.paths))
        return found

    def _check_influence(self, nominal: Outcome) -> None:
        """Refuse variables that change none of the results."""
        if nominal.numbers is None or 2 * len(self.paths) * nominal.seconds > PROBES:
            return
        for name in self.paths:
            pair = self._ends(name)
            if pair is None:
                continue
            ends = [outcome_of(one, self.task, self.kept, NOMINAL, time.thread_time()) for one in pair]
            if all(one.numbers is not None and _same(one.numbers, nominal.numbers) for one in ends):
                mend = "Remove it, keep a result that it changes, or leave out this check: check=False, --no-check."
                names = ", ".join(self.kept.texts)
                message = f"does nothing to the results: its least and largest value give the same {names}."
                raise ModelError([Fault(("variables", name), message, mend)])


def _pickled(model: Model) -> bytes:
    """A model with the function that builds it.

    Raises
    ------
    InputError : other processes cannot find the function.
    """
    try:
        return pickle.dumps(model)
    except (pickle.PicklingError, AttributeError, TypeError) as error:
        raise InputError(
            f"Other processes cannot find the function that builds the model ({error}). Define it in a module, by its own name."
        ) from None


def _same(one: Mapping[str, float], other: Mapping[str, float]) -> bool:
    return all(a == b or (math.isnan(a) and math.isnan(b)) for a, b in ((one[name], other[name]) for name in one))


def _unknown(model: Model, name: str, path: str) -> list[Fault]:
    try:
        resolved(model, path)
    except ModelError as error:
        return [Fault(("variables", name), f"{path}: {fault.message}", fault.mend) for fault in error.faults]
    return []


def _used(model: Model, run: str) -> Any:
    """What a run depends on: the model without its other runs and trajectories, the run and its motions, and their courses."""
    own = model.runs[run]
    runs = [own, *(model.runs[name] for name in own.motions if name in model.runs)]
    courses: list[Any] = [model.trajectories[name] for name in own.motions if name not in model.runs]
    courses += [model.trajectory_of(one) for one in runs]
    kept = model.trajectories if own.tasks else {}  # a task may name one
    return model.with_(runs={}, trajectories=kept, title=""), runs, courses


# The work.


def _executor(workers: int | None, cluster: str | None) -> AbstractContextManager[tuple[Executor, int]]:
    """What computes batches of rows, and how many at once."""
    if cluster is not None:
        if workers is not None:
            raise InputError("workers are those of this machine; a cluster has its own. Give one of workers and cluster.")
        from kinetruss.studies.cluster import connected

        return connected(cluster)

    def here(task: Task, batches: Sequence[Rows]) -> Iterator[tuple[int, Found]]:
        for k in range(len(batches)):
            yield k, evaluate(task, batches[k])

    def local(task: Task, batches: Sequence[Rows]) -> Iterator[tuple[int, Found]]:
        lost: list[Outcome] = []
        ready(task, batches[0])  # so that the processes have it
        for k, found in beside(lambda k: evaluate(task, batches[k]), range(len(batches)), workers, lost=lost):
            yield k, None if found is lost else found

    return nullcontext((here, 1) if workers == 0 else (local, workers or processors()))


def _work(
    ledger: Ledger, executor: Executor, count: int, job: _Job, nominal: Outcome | None, progress: Progress | None
) -> None:
    """Compute all rows that are left; rows whose process dies are tried again by themselves.

    The first batches tell how long a row takes, and so how many a process is given at once; many at once may take less.
    """
    total, left = ledger.count, ledger.left
    done, died, again = total - len(left), dict[int, int](), list[list[int]]()
    known, pilot, last = False, True, time.monotonic()
    seconds = BATCH if nominal is None or nominal.numbers is None else nominal.seconds
    if progress is not None:
        progress(done, total)
    while left or again:
        batches, again = again, []
        if not batches:
            size = max(1, min(LARGEST, int(BATCH / max(seconds, 1e-6)), math.ceil(len(left) / (4 * count))))
            most = PILOT * count * size if pilot else len(left)
            batches = [left[k : k + size] for k in range(0, min(most, len(left)), size)]
            left = left[sum(map(len, batches)) :]
        taken = list[float]()
        for k, found in executor(job.task, _Lazy(job, batches)):
            if found is None:
                rows, found = batches[k], []
                for row in rows:
                    died[row] = died.get(row, 0) + (len(rows) == 1)
                    if died[row] < TRIES:
                        again.append([row])
                    else:
                        found.append(Outcome(row, DIED, f"Its process died {TRIES} times."))
            ledger.add(found)
            done += len(found)
            taken += [one.seconds for one in found if one.numbers is not None]
            if not known and (units := next((one.units for one in found if one.numbers is not None), None)):
                ledger.set_units(units)
                known = True
            if time.monotonic() - last > PAUSE:
                ledger.commit()
                last = time.monotonic()
            if progress is not None and found:
                progress(done, total)
        before, seconds = seconds, min(taken, default=seconds)  # the first row of a process takes longer
        pilot = pilot and seconds < FASTER * before


class _Lazy(Sequence[Any]):
    """Batches of rows whose values are put together when they are needed."""

    def __init__(self, job: _Job, batches: Sequence[Sequence[int]]) -> None:
        self.job, self.batches = job, batches

    def __len__(self) -> int:
        return len(self.batches)

    def __getitem__(self, k: Any) -> Any:
        return self.job.rows(self.batches[k])
