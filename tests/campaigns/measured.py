"""Standard errors of smoothed records, against motions that are known: what docs/measured.md promises, for every law of motion.

    .venv/bin/python tests/campaigns/measured.py [--count 1000] [--seed 1] [--only trapezoid]

A kind is a law, a noise (over the range of the motion) and even or uneven times. Each record has its own law, rows and noise.
A record that warns (noise not white, or not to be distinguished from the motion) is left out of the shares within 1.96
standard errors. Exit 1 if fewer than 93 % of values, rates or accelerations of a kind are within, or more than 5 % of its
records warn, by more than twice the standard error of that share.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterator, Sequence
from itertools import product
from typing import Any, NamedTuple

import numpy as np

import kinetruss as kt
from kinetruss.kinematics.sampling import sample_profile

LEAST, MOST = 0.93, 0.05
NOISES = (1e-4, 1e-3, 1e-2)
DURATION = 3.0
WORDS = ("value", "rate", "acceleration")


def _step(dice: np.random.Generator, order: int) -> kt.StepResponse:
    damping, factor = dice.uniform(0.4, 1.5), dice.uniform(3.0, 6.0)
    return kt.StepResponse(moves={"M": (0, 1)}, duration=DURATION, order=order, damping=damping, settling_factor=factor)


LAWS: dict[str, Callable[[np.random.Generator], Any]] = {
    "quintic": lambda _: kt.Quintic(moves={"M": (0, 1)}, duration=DURATION),
    "trapezoid": lambda dice: kt.Trapezoid(moves={"M": (0, 1)}, duration=DURATION, ramp=dice.uniform(0.1, 0.5)),
    "constant_rate": lambda _: kt.ConstantRate(rates={"M": 1 / DURATION}, duration=DURATION),
    "sine": lambda dice: kt.Sine(
        amplitudes={"M": 0.5}, duration=DURATION, period=DURATION / dice.uniform(0.5, 3), phase=dice.uniform(0, 6.28)
    ),
    "cyclic": lambda dice: kt.Cyclic(moves={"M": (0, 1)}, period=DURATION / (n := dice.uniform(0.5, 3)), cycles=n),
    "step_response, order 2": lambda dice: _step(dice, 2),
    "step_response, order 3": lambda dice: _step(dice, 3),
}


class Kind(NamedTuple):
    """Shares (records, 3) of value, rate, acceleration within 1.96 standard errors, of records that do not warn."""

    within: np.ndarray
    warned: int
    count: int

    def faults(self) -> Iterator[str]:
        """The promises that are not kept."""
        error = self.within.std(axis=0) / np.sqrt(max(len(self.within), 1))
        for word, share, off in zip(WORDS, self.within.mean(axis=0), error, strict=True):
            if share + 2 * off < LEAST:
                yield f"{word} {share:.3f} +- {off:.3f}"
        share = self.warned / self.count
        if share - 2 * np.sqrt(MOST * (1 - MOST) / self.count) > MOST:
            yield f"{share:.1%} warn"


def kind(law: str, noise: float, even: bool, count: int, seed: int) -> Kind:
    """So many records of a kind."""
    key = [seed, list(LAWS).index(law), NOISES.index(noise), even]
    dice, within, warned = np.random.default_rng(key), [], 0
    for k in range(count):
        if k % 5 == 0:  # splines of the same rows are made once
            rows = int(dice.integers(80, 200))
            t = np.linspace(0, DURATION, rows)
            if not even:
                t[1:-1] = np.sort(dice.uniform(0, DURATION, rows - 2))
        truth = sample_profile(LAWS[law](dice), t, {})["M"]
        readings = truth[0] + noise * float(np.ptp(truth[0])) * dice.standard_normal(rows)
        found = kt.kinematics.measured(kt.Measured(times=t, values={"M": readings}, largest_gap=1e9))
        if "white" in found.message or "distinguish" in found.message:
            warned += 1
            continue
        off = [np.abs(found.data[word].values[:, 0] - true) for word, true in zip(WORDS, truth, strict=True)]
        within.append(
            [(one < 1.96 * found.data[f"{word}_error"].values[:, 0]).mean() for word, one in zip(WORDS, off, strict=True)]
        )
    return Kind(np.array(within).reshape(-1, 3), warned, count)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the campaign; 1 if a promise is not kept."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--count", type=int, default=1000, help="records of each kind")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--only", default="", help="laws whose name contains this")
    chosen = options.parse_args(arguments)
    kinds, faults = [one for one in product(LAWS, NOISES, (True, False)) if chosen.only in one[0]], 0
    for k, (law, noise, even) in enumerate(kinds):
        found = kind(law, noise, even, chosen.count, chosen.seed)
        shares = " ".join(f"{word} {share:.3f}" for word, share in zip(WORDS, found.within.mean(axis=0), strict=True))
        wrong = list(found.faults())
        faults += len(wrong)
        times = "even" if even else "uneven"
        print(f"{law}, noise {noise:g}, {times}: {shares} warned {found.warned / found.count:.3f}", flush=True)
        print("".join(f"  NOT KEPT: {one}\n" for one in wrong), end="", flush=True)
        print(f"{k + 1} of {len(kinds)} kinds, {faults} faults", file=sys.stderr, flush=True)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
