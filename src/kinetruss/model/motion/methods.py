"""Integration methods of a simulation: one record for each method, with its options."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from pydantic import Field

from kinetruss.model._record import Count, Number, PositiveNumber, PositiveTime, Record, Span

__all__ = ["DOP853", "ERROR_CONTROLLED", "EnergyMomentum", "GeneralizedAlpha", "Method", "Radau", "Rattle", "Solver", "Taylor"]

Solver = Literal["auto", "sweep", "dense", "sparse"]
"""Solver for accelerations and forces: block sweeps, a dense Schur complement, sparse L D L^T, or the fastest of them."""

_Tolerance = Annotated[Number, Field(gt=0, lt=1)]


class DOP853(Record):
    """Explicit Runge-Kutta method of order 8 with error control, projected onto the constraints after every step.

    rtol, atol : relative and absolute tolerance of coordinates and velocities (m, m/s). max_steps : largest number of steps,
        accepted and rejected. first_step : s; found from the equations by default. step : s, all steps alike and no error
        control, to study convergence. solver : of accelerations and forces; the fastest by default.

    Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., 1993, section II.10.
    """

    kind: Literal["dop853"] = "dop853"
    rtol: _Tolerance = 1e-10
    atol: PositiveNumber = 1e-11
    max_steps: Count = 10_000_000
    first_step: PositiveTime | None = None
    step: Span | None = None
    solver: Solver = "auto"


class EnergyMomentum(Record):
    """Implicit midpoint rule with discrete gradients: fixed steps (s) that keep energy and momentum. For long and stiff runs.

    tolerance : of the equations of a step, relative. solver : of the equations; the fastest by default.

    Source: O. Gonzalez, Physica D 132 (1999) 165-174.
    """

    _positional: ClassVar = ("step",)
    kind: Literal["energy_momentum"] = "energy_momentum"
    step: Span
    tolerance: _Tolerance = 1e-11
    solver: Solver = "auto"

    if TYPE_CHECKING:

        def __init__(self, step: float | str, *, tolerance: float = 1e-11, solver: Solver = "auto") -> None: ...


class GeneralizedAlpha(Record):
    """Implicit method with numerical damping of high frequencies; fixed steps (s).

    rho : spectral radius at infinite frequency, 0 to 1: the amplitude of the highest frequencies that remains after a step.
        tolerance : of the equations of a step, relative. solver : of the equations; the fastest by default.

    Source: J. Chung, G. M. Hulbert, Journal of Applied Mechanics 60 (1993) 371-375.
    """

    _positional: ClassVar = ("step",)
    kind: Literal["generalized_alpha"] = "generalized_alpha"
    step: Span
    rho: Annotated[Number, Field(ge=0, le=1)] = 0.85
    tolerance: _Tolerance = 1e-11
    solver: Solver = "auto"

    if TYPE_CHECKING:

        def __init__(
            self, step: float | str, *, rho: float = 0.85, tolerance: float = 1e-11, solver: Solver = "auto"
        ) -> None: ...


class Radau(Record):
    """Implicit Runge-Kutta method Radau IIA of order 5 with error control, projected onto the constraints after every step.

    For stiff runs: steps follow the motion, not the fastest vibration or damper of an elastic bar, once that has died down. It
    damps vibrations that are faster than its steps. The stiffness of elastic bars, dampers, membranes, solids and friction
    about pins is in its matrices; that of user forces and of loads that turn is not.

    rtol, atol : relative and absolute tolerance of coordinates and velocities (m, m/s). max_steps : at most. first_step : s;
    found from the equations by default. step : s, all steps alike and no error control, to study convergence.
    solver : of accelerations and forces; the fastest by default.

    Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., 1996, section IV.8.
    """

    kind: Literal["radau"] = "radau"
    rtol: _Tolerance = 1e-8
    atol: PositiveNumber = 1e-9
    max_steps: Count = 10_000_000
    first_step: PositiveTime | None = None
    step: Span | None = None
    solver: Solver = "auto"


class Rattle(Record):
    """RATTLE: leapfrog with constraints on positions and velocities; fixed steps (s), symplectic.

    tolerance : of the constraints of a step, relative. solver : of the equations; the fastest by default.

    Source: H. C. Andersen, Journal of Computational Physics 52 (1983) 24-34.
    """

    _positional: ClassVar = ("step",)
    kind: Literal["rattle"] = "rattle"
    step: Span
    tolerance: _Tolerance = 1e-12
    solver: Solver = "auto"

    if TYPE_CHECKING:

        def __init__(self, step: float | str, *, tolerance: float = 1e-12, solver: Solver = "auto") -> None: ...


class Taylor(Record):
    """Taylor series of the motion, of high order, each from one factorisation. The fastest method if all forces are smooth.

    rtol, atol : relative and absolute tolerance of coordinates and velocities (m, m/s). order : of the series of the
    velocities; chosen from rtol by default. max_steps : largest number of steps. first_step : s; the scale of time of the
    first series, found from the equations by default. step : s, all steps alike and no error control, to study convergence.
    solver : of accelerations and forces; the fastest by default.

    Rigid, driven and elastic bars of constant mass, planar bodies, angle drives, supports that move, given forces. Not for
    active members, cables, hinges, couplings and springs, loads that turn with bodies, membranes,
    solids, friction about pins, user forces and motors: use `DOP853` for these.

    Source: A. Jorba, M. Zou, Experimental Mathematics 14 (2005) 99-117; J. D. Pryce, Numerical Algorithms 19 (1998) 195-211.
    """

    kind: Literal["taylor"] = "taylor"
    rtol: _Tolerance = 1e-10
    atol: PositiveNumber = 1e-11
    order: Annotated[Count, Field(ge=4, le=40)] | None = None
    max_steps: Count = 10_000_000
    first_step: PositiveTime | None = None
    step: Span | None = None
    solver: Solver = "auto"


ERROR_CONTROLLED = DOP853 | Radau | Taylor
"""Methods whose steps are chosen by the error."""

Method = Annotated[DOP853 | EnergyMomentum | GeneralizedAlpha | Radau | Rattle | Taylor, Field(discriminator="kind")]
