"""Do a named run of a model; resume an interrupted one."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from kinetruss.errors import InputError
from kinetruss.io import read
from kinetruss.limits import hold
from kinetruss.model import Model
from kinetruss.model.runs import MISSION
from kinetruss.results import Status, model_hash, provenance
from kinetruss.results.folder import Ledger, claimed
from kinetruss.results.lock import check_unlocked, holding
from kinetruss.results.store import End, Store, Writer, create, open_store, reopen
from kinetruss.runs.blocks import blocks, stored_blocks
from kinetruss.runs.joining import Accumulator, groups_of, in_memory, tail_groups
from kinetruss.runs.missions import resume_mission, run_mission
from kinetruss.runs.plans import Block, Plan, chosen_run, plan
from kinetruss.runs.results import RunResult, from_store, model_of

Progress = Callable[[int, int], None]


def run(
    model: Model | str | Path,
    name: str | None = None,
    out: str | Path | None = None,
    *,
    overwrite: bool = False,
    progress: Progress | None = None,
    block: int | None = None,
    settings: Mapping[str, str] | None = None,
) -> RunResult:
    """Do a named run: motion, member forces of each load case, section forces, utilisation, motor demands.

    The motion is prescribed (``dynamics.inverse``) or simulated (``dynamics.simulate``); or the structure stands still, or it
    is a mission of many motions.

    Parameters
    ----------
    model : a model, or a model file. name : a run of the model; may be omitted if there is only one.
    out : folder to write to, block by block; None keeps everything in memory.
    overwrite : replace the kinetruss run in `out`; any other folder that is not empty is still refused.
    progress : called with (samples done, samples requested) after each block.
    block : samples per block; by default 2000, fewer for large models; for a simulation the samples of about five seconds.
    settings : values that were set to make this model, by dotted path; stored with the run as its label in pictures.

    Returns
    -------
    RunResult; of a mission a `MissionRun`. A path that ends early (a singular position, lengths that cannot close) raises no
    exception: the good samples are in the result, with status and message.

    Raises
    ------
    InputError : no such run, an output folder that is not empty, faults of the trajectory. Nothing was computed.
    StoreError : another process is writing the folder; or it cannot be written, e.g. the disk is full. Committed samples
    stay readable.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> result = kt.run(model, "turn")
    >>> result.status.name, list(result.forces)
    ('COMPLETED', ['all'])
    >>> worst = result.verdict.table()[0]
    >>> worst.part, worst.rule, round(worst.utilisation, 3)
    ('crank', 'yield', 0.036)
    """
    started = time.perf_counter()
    model = model if isinstance(model, Model) else read(model)
    if (chosen := chosen_run(model, name)) and model.runs[chosen].analysis == MISSION:
        return run_mission(model, chosen, out, overwrite=overwrite, progress=progress, settings=settings)
    job = plan(model, name, block)
    if out is None:
        return replace(_in_memory(job, progress, started), settings=settings or {})
    path = Path(out)
    with claimed(path, overwrite) as held:
        computed = blocks(job, fitted=block is None)
        first = next(computed)  # all input errors are raised before the folder is changed
        if first.simulation is not None and block is None:
            job = replace(job, block=max(1, int(first.motion.whole.sizes["time"])))
        writer = create(path, ledger_of(job, settings), job.origin.model_dump_json(), overwrite=overwrite, held=held)
        stored = _stream(job, writer, Accumulator(job.model), _chained(first, computed), progress, started)
    if len(job.times) > job.block:
        return from_store(open_store(path))
    # one block: the run is already complete
    whole = in_memory(job, [first], stored, time.perf_counter() - started)
    return replace(whole, path=path, settings=settings or {})


def resume(out: str | Path, *, progress: Progress | None = None) -> RunResult:
    """Continue a run that was killed, interrupted or ran out of disk space, after its last good sample.

    A simulation continues from the stored state of its integration; the results equal those of a run without interruption to
    the last bit.

    Raises
    ------
    InputError : the run has already ended.
    StoreError : no run folder, or another process is writing it.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> import tempfile
    >>> def stop(done: int, asked: int) -> None:
    ...     if done < asked:
    ...         raise KeyboardInterrupt  # as Ctrl-C
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     try:
    ...         _ = kt.run(model, out=f"{folder}/turn", block=100, progress=stop)
    ...     except KeyboardInterrupt:
    ...         len(kt.runs.load(f"{folder}/turn").motion.time)
    ...     len(kt.runs.resume(f"{folder}/turn").motion.time)
    100
    361
    """
    started = time.perf_counter()
    path = Path(out)
    check_unlocked(path)
    unfinished = _unfinished(path)  # raises an error before anything is written there
    if unfinished.ledger.options.get("analysis") == MISSION:
        return resume_mission(path, progress=progress)
    with holding(path) as held:
        store = _unfinished(path)  # read it again, now that no other process writes it
        job = plan(model_of(store), store.ledger.run, store.ledger.block)
        first = store.ledger.committed
        position, state = (
            (store.read("motion", whole=True)["position"].isel(time=-1).values, store.state()) if first else (None, None)
        )
        accumulated = Accumulator(job.model, message=store.ledger.message)
        if first:
            before = from_store(store)
            for block in stored_blocks(job, before):
                accumulated.add(block)
            if before.simulation is not None:
                accumulated.simulation = before.simulation.whole.drop_dims("time")
                accumulated.between = accumulated.between[-1:]  # each has all of them
        computed = blocks(job, first, position, state)
        _stream(job, reopen(path, store.ledger, held), accumulated, computed, progress, started - store.ledger.wall_time)
    return from_store(open_store(path))


def _unfinished(path: Path) -> Store:
    """The store of a run that can be continued."""
    store = open_store(path)
    if store.ledger.state == "finished":
        raise InputError(f"{path} has ended: {Status[store.ledger.status].value} There is nothing to resume.")
    return store


def _stream(
    job: Plan, writer: Writer, accumulated: Accumulator, computed: Iterator[Block], progress: Progress | None, started: float
) -> Accumulator:
    """Write block after block, then the results known only at the end."""
    try:
        for block in computed:
            accumulated.add(block)
            end = _end_of(accumulated) if block.last else None
            state = accumulated.state if block.state is None else block.state
            writer.append(groups_of(block), time.perf_counter() - started, state, end)
            if progress is not None:
                progress(writer.ledger.committed, len(job.times))
        if writer.ledger.state != "finished":  # nothing was left to compute
            writer.append({}, time.perf_counter() - started, end=_end_of(accumulated))
    except KeyboardInterrupt:
        writer.pause(Status.INTERRUPTED.name, accumulated.message, time.perf_counter() - started)
        raise
    finally:
        writer.release()
    return accumulated


def _end_of(accumulated: Accumulator) -> End:
    """The end of a run, with the results known only then."""
    return End(accumulated.status.name, accumulated.message, tail_groups(accumulated) if accumulated.count else {})


def _in_memory(job: Plan, progress: Progress | None, started: float) -> RunResult:
    members = len(job.model.whole.members)
    a_sample = 9 * len(job.model.whole.nodes) + members * (10 + len(job.cases) * (10 + 6 * job.run.stations) * job.full)
    mend = "Write it to a folder (out), or take fewer samples or stations."
    hold(len(job.times) * a_sample, f"A run of {len(job.times):,} samples kept in memory", mend)
    accumulated, kept = Accumulator(job.model), []
    for block in blocks(job):
        accumulated.add(block)
        kept.append(block)
        if progress is not None:
            progress(accumulated.count, len(job.times))
    return in_memory(job, kept, accumulated, time.perf_counter() - started)


def _chained(first: Block, rest: Iterator[Block]) -> Iterator[Block]:
    yield first
    yield from rest


def ledger_of(job: Plan, settings: Mapping[str, str] | None = None) -> Ledger:
    """The ledger of a new run."""
    cases = [case or "all" for case in job.cases]
    options = {"analysis": job.run.analysis, "stations": job.run.stations, "load_cases": cases}
    return Ledger(
        run=job.name,
        samples=len(job.times),
        block=job.block,
        model_hash=model_hash(job.origin),
        options=options | ({"settings": dict(settings)} if settings else {}),
        provenance=provenance(job.origin, run=job.name),
    )
