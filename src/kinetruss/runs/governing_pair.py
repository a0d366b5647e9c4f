"""A pair of a mission as a run of its own."""

from __future__ import annotations

from pathlib import Path

from kinetruss.errors import InputError
from kinetruss.limits import whole
from kinetruss.runs.mission_results import MissionRun, pairs_of
from kinetruss.runs.results import RunResult
from kinetruss.runs.running import run


def governing(mission: MissionRun, pair: int | None = None, out: str | Path | None = None) -> RunResult:
    """Do one pair of a mission as a run, with all histories.

    Parameters
    ----------
    pair : its number; by default the one with the highest utilisation, or the first that can be. out : as of `run`.

    Raises
    ------
    InputError : no such pair, or one that cannot be.

    Examples
    --------
    >>> import kinetruss as kt
    >>> model = kt.read(kt.library.example_files()["four_bar"][0])
    >>> model = model.with_(
    ...     conditions={"laden": kt.Condition(payloads={"C": 5.0}), "bare": kt.Condition()},
    ...     runs={**model.runs, "all": kt.Run(analysis="mission", motions=["turn"], conditions=["laden", "bare"])},
    ... )
    >>> worst = kt.runs.governing(kt.run(model, "all"))
    >>> worst.model.nodes["C"].mass  # kg: that of the pair with the highest utilisation, with its payload
    5.5
    """
    pairs = pairs_of(mission.model, mission.name)
    if pair is None:
        possible = [k for k, samples in enumerate(mission.pairs["samples"].values) if samples > 0]
        if not possible:
            raise InputError(f"No pair of {mission.name!r} could be done: {next(iter(mission.findings.values()), '')}")
        pair = possible[0] if mission.governing is None else mission.governing
    if not 0 <= whole(pair, "pair", least=0) < len(pairs):
        raise InputError(f"The mission has no pair {pair}. It has {len(pairs)}, counted from 0.")
    model, name = pairs[pair].alone(mission.model, mission.model.runs[mission.name])
    return run(model, name, out)
