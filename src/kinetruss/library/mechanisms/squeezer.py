"""Andrews' squeezing mechanism."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from typing import Annotated, Any, Literal

from kinetruss.library.building import builder
from kinetruss.library.placing import on_link
from kinetruss.model import (
    AngleDrive,
    Bar,
    Beam,
    Body,
    CoordinateDrive,
    Frame,
    GivenForce,
    Model,
    Node,
    Of,
    PlanarBody,
    PositiveTime,
    Run,
)

ANDREWS_TORQUE = 0.033
"""Torque of the motor on the crank, N m."""

A, B, C = -0.06934 - 0.00227j, -0.03635 + 0.03273j, 0.014 + 0.072j
RR, D, SS, SC, SD, E, ZT, U, ZF = 0.007, 0.028, 0.035, 0.018, 0.020, 0.020, 0.040, 0.040, 0.020
BETA, THETA, GAMMA, PHI, DELTA, OMEGA, EPSILON = (
    -0.0617138900142764496358948458001,
    0.0,
    0.455279819163070380255912382449,
    0.222668390165885884674473185609,
    0.487364979543842550225598953530,
    -0.222668390165885884674473185609,
    1.23054744454982119249735015568,
)

BODIES = {
    "OF": PlanarBody(mass=0.04325, center=(0.00092, 0.0), inertia=2.194e-6),
    "FE": PlanarBody(mass=0.00365, center=(0.0115, 0.0), inertia=4.410e-7),
    "BE": PlanarBody(mass=0.02373, center=(0.01874, 0.01043), inertia=5.255e-6),
    "GE": PlanarBody(mass=0.00706, center=(E - 0.01421, 0.0), inertia=5.667e-7),
    "AG": PlanarBody(mass=0.07050, center=(0.02308, 0.00916), inertia=1.169e-5),
    "HE": PlanarBody(mass=0.00706, center=(ZF - 0.01421, 0.0), inertia=5.667e-7),
    "AH": PlanarBody(mass=0.05498, center=(0.01228, -0.00449), inertia=1.912e-5),
}
LENGTHS = {
    "OF": RR,
    "FE": D,
    "BE": SS,
    "ED": math.hypot(SS - SC, SD),
    "BD": math.hypot(SC, SD),
    "GE": E,
    "AG": ZT,
    "HE": ZF,
    "AH": U,
}


@builder("mechanisms.andrews")
def andrews(
    *,
    form: Literal["bars", "beam", "conventional"] = "bars",
    torque: Annotated[float, Of("torque")] = ANDREWS_TORQUE,
    duration: PositiveTime = 0.03,
    title: str = "Andrews' squeezing mechanism",
) -> Model:
    """Seven bodies in three loops, a spring and a motor: a standard test of solvers for stiff and for constrained equations.

    Ten bars: nine rigid ones, of which ``ED`` and ``BD`` only hold D on the body of ``BE`` and have no mass, and the spring
    ``CD``. Nodes O, A, B, C are fixed; drive ``motor`` turns the crank ``OF``. Each body is the extended mass of the
    bar that carries it. It starts at rest, without gravity.

    Or nine bars and a beam: the crank ``OF`` is a rigid beam, its rotation the coordinate ``beta``. Or the conventional model
    of finite elements: eleven rigid beams and the spring. Each of the seven bodies has a rotation coordinate and each centre
    of mass off the line of its pins a node; the mass is at the centre, the moment of inertia on the rotation.

    Parameters
    ----------
    form : ``bars``, or ``beam``: a rigid beam with a rotation coordinate in place of the bar ``OF``. ``beta.x`` (rad) counts on
        over full turns, so it is a degree of freedom throughout: 19 coordinates, 8 fixed. ``conventional``: rotations of all
        bodies, ``beta`` and ``BODY.angle``: 31 coordinates, 8 fixed.
    torque : on the crank, N m, constant; it belongs to the run ``spin``. duration : of that run, s.

    Notes
    -----
    One degree of freedom. The crank makes 2.5 turns in 0.03 s, so no node coordinate is a valid degree of freedom throughout;
    O, F and E are on one line at the start, so those of E, D, G, H are not valid there.

    Raises
    ------
    ModelError : faults of the parameters.

    Source
    ------
    E. Hairer & G. Wanner, Solving Ordinary Differential Equations II (1996), section VII.7, after G. C. Andrews and
    W. O. Schiehlen; start angles of 30 digits from the Test Set for IVP Solvers (problem andrews).

    Examples
    --------
    >>> model = andrews()
    >>> len(model.bars), model.bars["AH"].body.center
    (10, (0.01228, -0.00449))
    """
    places = _start()
    spring = Bar(ends=("C", "D"), kind="elastic", stiffness=4530.0, natural_length=0.07785, mass=0.0)
    nodes: dict[str, Any] = {name: (z.real, z.imag) for name, z in places.items()}
    if form == "conventional":
        bars, more = {}, _conventional(nodes, places)
    else:
        bars = {
            name: Bar(ends=(name[0], name[1]), length=length, body=BODIES.get(name), mass=None if name in BODIES else 0.0)
            for name, length in LENGTHS.items()
        }
        more = {"drives": {"motor": AngleDrive("OF")}}
    if form == "beam":
        nodes["beta"] = Node(at=(BETA, 0.0), scalar=True)
        del bars["OF"]
        more = {
            "beams": {"OF": Beam(ends=("O", "F"), kind="rigid", rotation="beta", mass=0.0)},
            "bodies": {"crank": _on_its_pins("OF", places, BODIES["OF"].inertia)},
        }
    if form != "bars":
        more["drives"] = {"motor": CoordinateDrive(node="beta", axis="x")}
    return Model(
        title=title,
        nodes=nodes,
        fixed=["O", "A", "B", "C"],
        bars=bars | {"CD": spring},
        **more,
        runs={"spin": Run(analysis="dynamics.simulate", t_end=duration, tasks={"motor": GivenForce(torque=torque)})},
    )


def _on_its_pins(name: str, places: Mapping[str, complex], inertia: float) -> Body:
    """The mass of a body whose centre is on the line of its pins, with this moment of inertia (kg m^2)."""
    start = places[name[0]]
    along = (places[name[1]] - start) / abs(places[name[1]] - start)
    frame = Frame(origin=(start.real, start.imag), axes=((along.real, along.imag), (-along.imag, along.real)))
    body = BODIES[name]
    return Body(nodes=(name[0], name[1]), mass=body.mass, center=body.center, inertia=inertia, frame=frame, brace=False)


def _conventional(nodes: dict[str, Any], places: Mapping[str, complex]) -> dict[str, Any]:
    """Rigid beams and masses of the seven bodies; their rotations and the centres off the lines of pins join `nodes`."""
    beams, bodies = {}, {}

    def beam(name: str, first: str, second: str, angle: str) -> None:
        # the pins are free: the rotation is that of the body alone
        ends = (first, second)
        beams[name] = Beam(ends=ends, kind="rigid", rotation=angle, mass=0.0, release=ends)

    for name, body in BODIES.items():
        first, second = name[0], name[1]
        way = places[second] - places[first]
        angle = "beta" if name == "OF" else f"{name}.angle"
        nodes[angle] = Node(at=(cmath.phase(way), 0.0), scalar=True, mass=body.inertia)
        beam(name, first, second, angle)
        if name == "BE":
            beam("BD", "B", "D", angle)
        if body.center[1]:
            center = on_link(places[first], places[second], body.center)
            nodes[f"{name}.center"] = Node(at=(center.real, center.imag), mass=body.mass)
            beam(f"{name}.arm", first, f"{name}.center", angle)
        else:
            bodies[name] = _on_its_pins(name, places, 0.0)
    return {"beams": beams, "bodies": bodies}


def _start() -> dict[str, complex]:
    """Places of the nodes from the angles; -i exp(i a) is (sin a, -cos a)."""
    F = RR * cmath.exp(1j * BETA)
    along = -1j * cmath.exp(1j * GAMMA)
    return {
        "O": 0j,
        "A": A,
        "B": B,
        "C": C,
        "F": F,
        "E": F - D * cmath.exp(1j * (BETA + THETA)),
        "D": B + (SC + 1j * SD) * along,
        "G": A + ZT * cmath.exp(1j * DELTA),
        "H": A - 1j * U * cmath.exp(1j * EPSILON),
    }
