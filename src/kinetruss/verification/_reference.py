"""Sources of expected values, and what agreement shows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

__all__ = ["CLAIMS", "INPUT_CHECK", "KINDS", "Kind", "Reference"]

Kind = Literal[
    "printed",
    "printed-inferred",
    "thesis-formulas",
    "closed-form",
    "independent",
    "count",
    "identity",
    "agreement",
    "input-check",
]
KINDS: tuple[Kind, ...] = get_args(Kind)
INPUT_CHECK: Kind = "input-check"

CLAIMS: dict[Kind, str] = {
    "printed": "A number printed in the source. Its inputs are printed there too. Where the print contradicts itself or "
    "rounds a size, the note says what was taken.",
    "printed-inferred": "A printed number. At least one input is not the printed one; `inferred` names each. Where inputs were "
    "fitted to the numbers compared, the note says so: agreement then shows less.",
    "thesis-formulas": "A printed number that only the thesis' own formulas give, errors included. `computed` repeats his "
    "program along the product's motion; `product` is what the product itself gives. Agreement shows "
    "where the number comes from, not that it is right.",
    "closed-form": "A formula, evaluated apart from the analysis that is tested.",
    "independent": "A number from a separate computation that shares no analysis with the product.",
    "count": "A whole number, or an order of convergence, that theory or a publication gives for any sizes.",
    "identity": "A law that must hold: energy, momentum, equilibrium, a constraint. The expected value is the residual: 0.",
    "agreement": "Two ways of the product to one number. It shows that they agree, not that both are right.",
    "input-check": "A number that went into the model. It shows that the model is the one meant; not counted as verified.",
}
"""The claim of an entry, by class."""


@dataclass(frozen=True)
class Reference:
    """The source of an expected value.

    kind : its class, one of `CLAIMS`.
    note : how to read the number, and which of two conflicting statements of the source is used.
    inferred : inputs that differ from the printed ones, each with the printed one.
    """

    kind: Kind
    source: str
    note: str = ""
    inferred: tuple[str, ...] = ()
