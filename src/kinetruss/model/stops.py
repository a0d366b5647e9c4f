"""Stops on a coordinate: a gap, and contact behind it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar

from pydantic import model_validator

from kinetruss.model.drives import ForceElement
from kinetruss.model.record import ContactDamping, Coordinate, PositiveNumber, SpringStiffness


class Stop(ForceElement):
    """A stop on a coordinate: nothing acts between `lower` and `upper`; d beyond one of them the coordinate is pushed back with

        k d^n (1 + damping d'),    never pulled

    (K. H. Hunt, F. R. E. Crossley, J. Appl. Mech. 42 (1975) 440, eq. 8). At a small speed v of impact the coefficient of
    restitution is 1 - 2/3 damping v. A simulation reports every beginning (away from the gap) and end of contact as an event
    ``NAME.lower`` or ``NAME.upper``.

    lower, upper : values of the coordinate where contact begins, m or rad; give one of them or both. In the model the
    coordinate must lie between them. stiffness : k, N/m^n or N m/rad^n. damping : s/m or s/rad. exponent : n; 1.5 is Hertz's
    contact of balls.

    coordinate : on which it acts, as a drive that would move it.
    terms : a sum of coordinates in its place: pairs of coordinate and factor.

    >>> import kinetruss as kt
    >>> kt.Stop(coordinate=kt.LengthDrive("strut"), lower="0.8 m", stiffness="40 kN/m", damping=0.5).lower
    0.8
    """

    element: ClassVar[str] = "stop"
    plain: ClassVar[tuple[str, ...]] = ("lower", "upper", "stiffness", "damping")
    lower: Coordinate | None = None
    upper: Coordinate | None = None
    stiffness: SpringStiffness
    damping: ContactDamping = 0.0
    exponent: PositiveNumber = 1.0

    @model_validator(mode="after")
    def _sound(self) -> Stop:
        self.check_coordinate()
        if self.lower is None and self.upper is None:
            raise ValueError("the stop has no end. Give lower, upper or both.")
        if self.lower is not None and self.upper is not None and self.lower >= self.upper:
            raise ValueError(f"lower {self.lower:g} is not below upper {self.upper:g}. Mend one of them.")
        if not self.stiffness:
            raise ValueError("stiffness is 0: nothing stops. Give a stiffness.")
        if self.damping < 0.0:
            raise ValueError(f"damping {self.damping:g} is negative: contact would give energy. Give at least 0.")
        return self

    if TYPE_CHECKING:

        def __init__(self, *, coordinate: Any = None, terms: Any = None, **numbers: Any) -> None: ...
