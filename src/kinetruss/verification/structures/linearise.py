"""Transfer functions, small motions, prestress, feedback: Andrews' mechanism, a star dome, a prism, an oscillator."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from kinetruss import dynamics, kinematics, statics
from kinetruss.library import mechanisms
from kinetruss.model import Bar, General, Material, Model, NodalForce, Node
from kinetruss.verification._case import Case
from kinetruss.verification._reference import Reference

__all__ = ["cases"]

INCH, POUND = 0.0254, 4.4482216152605

ANDREWS = Reference("independent", "geometric transfer functions of Andrews' mechanism at the start, by the angle of the crank")
FIRST = {"F": (0.0004317230645688956, 0.006986674115451446)}
SECOND = {
    "F": (-0.006986674115451447, 0.0004317230645688956),
    "E": (-0.005424106389506854, -0.0026555535367728117),
    "D": (-0.0012720812650190605, -0.0044652026129156485),
    "G": (-0.00073076488781945, 0.0013787803486838782),
    "H": (-0.0017588910434139363, -0.004968381189306901),
}
REDUCED_MASS = 2.32027633125e-06

DOME = Reference(
    "printed",
    "Levy & Spillers, Analysis of Geometrically Nonlinear Structures (2003), sec. 2.4.2: linear deflection of the crown",
)
CROWN = -0.20641184
"""in, as printed; independent computation -0.20641183795091453."""

PRISM = Reference("closed-form", "self-stress at a twist of 150 deg only, strut : vertical : horizontal = -1 : 1 : 1/sqrt(3)")
LEFT = Reference("count", "one node of a stable prism is held: three turns are left free")
SHAKEN = Reference("closed-form", "sqrt((1 + (2 z r)^2)/((1 - r^2)^2 + (2 z r)^2))")
LINKS = Reference("closed-form", "rigid links of length l on springs k buckle at k l/3 and k l (three links), k l/2 (two)")
SKYHOOK = Reference("closed-form", "least cost of k^2 x^2 + f^2 on a unit mass: poles at sqrt(k) (-1 +- i)/sqrt(2)")


def andrews() -> dict[str, float]:
    """Components of F' and F'' at the start, and the reduced mass."""
    model = mechanisms.andrews()
    found = kinematics.transfer_functions(model, "OF.angle")
    values = {"mass": dynamics.linearise(model, dofs="OF.angle").mass.item()}
    for node in "FEDGH":
        for k, axis in enumerate("xy"):
            values[f"first_{node}{axis}"] = found.first.sel(node=node).values[k, 0].item()
            values[f"second_{node}{axis}"] = found.second.sel(node=node).values[k, 0, 0].item()
    return values


def dome() -> Model:
    """24 bars, 220.46 lbf on the crown."""
    hexagon = [(4.92125, 8.5239), (-4.92125, 8.5239), (-9.8425, 0.0), (-4.92125, -8.5239), (4.92125, -8.5239), (9.8425, 0.0)]
    rim = [(0.0, 19.685), (-17.0472, 9.8425), (-17.0472, -9.8425), (0.0, -19.685), (17.0472, -9.8425), (17.0472, 9.8425)]
    at = [(0.0, 0.0, 3.2346), *((x, y, 2.4472) for x, y in hexagon), *((x, y, 0.0) for x, y in rim)]
    pairs = [(1, k) for k in range(2, 8)] + [(k, k + 1) for k in range(2, 7)] + [(7, 2)]
    pairs += [(6, 12), (7, 12), (7, 13), (2, 13), (2, 8), (3, 8), (3, 9), (4, 9), (4, 10), (5, 10), (5, 11), (6, 11)]
    return Model(
        nodes={str(k): tuple(c * INCH for c in place) for k, place in enumerate(at, start=1)},
        fixed=[str(k) for k in range(8, 14)],
        bars={f"{a}-{b}": Bar(ends=(str(a), str(b)), kind="elastic") for a, b in pairs},
        section=General(area=0.0155 * INCH**2, I2=1e-12, I3=1e-12, c2=0.001, c3=0.001),
        material=Material(E=30e6 * POUND / INCH**2, density=7850.0),
        loads={"crown": NodalForce(node="1", force=(0.0, 0.0, -220.46 * POUND))},
    )


def crown() -> dict[str, float]:
    """Linear deflection of the crown, in: stiffness method, static response of the linearisation, start of the path."""
    model = dome()
    by_path = statics.path(model, "crown", to=1e-5, step=1e-7, points=9)
    sag = (by_path.position.sel(node="1", axis="z").values / INCH - 3.2346)[-1] / by_path.load_factor.values[-1]
    lin = dynamics.linearise(model, inputs="1.z", outputs="1.z")
    return {
        "stiffness_method": statics.linear(model, weight=False).displacement.sel(node="1", axis="z").item() / INCH,
        "linearised": -220.46 * POUND * lin.frequency_response(0.0).item().real / INCH,
        "path": float(sag),
    }


def prism() -> dict[str, float]:
    """Twist, deg, and force densities over that of the verticals, of a prism let go 10 degrees off."""
    side = {
        name: [(math.cos(a), math.sin(a), z) for a in np.radians([start, start + 120, start + 240])]
        for name, start, z in (("L", 0.0, 0.0), ("H", 140.0, 1.2))
    }
    cable = {"kind": "cable", "stiffness": 5e4, "pretension": 8e3}
    bars = {f"{s}{k}": Bar(ends=(f"{s}{k}", f"{s}{(k + 1) % 3}"), **cable) for s in "LH" for k in range(3)}
    bars |= {f"strut{k}": Bar(ends=(f"L{k}", f"H{k}")) for k in range(3)}
    bars |= {f"vertical{k}": Bar(ends=(f"L{k}", f"H{(k + 2) % 3}"), **cable) for k in range(3)}
    nodes = {f"{s}{k}": place for s, places in side.items() for k, place in enumerate(places)}
    found = statics.equilibrium(Model(nodes=nodes, fixed=["L0"], bars=bars))
    low, high = (found.position.sel(node=[f"{s}{k}" for k in range(3)]).values for s in "LH")
    axis = high.mean(axis=0) - low.mean(axis=0)
    one, two = low[0] - low.mean(axis=0), high[0] - high.mean(axis=0)
    twist = math.atan2(float(np.cross(one, two) @ axis) / float(np.linalg.norm(axis)), float(one @ two))
    density = found.member_force / found.length
    unit = density.sel(member="vertical0").item()
    return {
        "twist": abs(math.degrees(twist)),
        "strut": density.sel(member="strut1").item() / unit,
        "horizontal": density.sel(member="H2").item() / unit,
        "left_free": float(found.data.attrs["neutral"]),
    }


def links(count: int) -> dict[str, float]:
    """Buckling factors of a column of rigid links of 1 m on springs of 12 N/m."""
    nodes = {f"N{i}": (0.0, float(i)) for i in range(count + 1)} | {f"W{i}": (1.0, float(i)) for i in range(1, count)}
    bars = {f"b{i}": Bar(ends=(f"N{i}", f"N{i + 1}")) for i in range(count)}
    bars |= {f"s{i}": Bar(ends=(f"N{i}", f"W{i}"), kind="elastic", stiffness=12.0) for i in range(1, count)}
    fixed = {"N0": "xy", f"N{count}": "x"} | {f"W{i}": "xy" for i in range(1, count)}
    model = Model(nodes=nodes, fixed=fixed, bars=bars, loads={"P": NodalForce(node=f"N{count}", force=(0.0, -1.0))})
    return {f"mode_{k}": float(value) for k, value in enumerate(statics.buckling(model, "P").load_factor.values, start=1)}


def oscillator() -> dict[str, float]:
    """Transmissibility at twice the natural frequency, damping ratio 0.1; poles of feedback of least cost on a free mass."""
    k, m, z = 50.0, 2.0, 0.1
    nodes = {"A": Node(at=(0.0, 0.0)), "B": Node(at=(1.0, 0.0), mass=m)}
    spring = Bar(ends=("A", "B"), kind="elastic", stiffness=k, damping=2 * z * math.sqrt(k * m))
    lin = dynamics.linearise(Model(nodes=nodes, fixed={"A": "xy", "B": "y"}, bars={"s": spring}), inputs="A.x", outputs="B.x")
    mass = Model(nodes={"B": Node(at=(0.0, 0.0), mass=1.0)}, fixed={"B": "y"})
    free = dynamics.linearise(mass, inputs="B.x", dofs="B.x")
    pole = dynamics.feedback(free, state_cost={"B.x": 16.0**2}).poles[0]
    return {
        "transmissibility": lin.transmissibility(2 * math.sqrt(k / m)).item(),
        "pole_real": float(pole.real),
        "pole_imag": abs(float(pole.imag)),
    }


def cases() -> Iterator[Case]:
    """Exact to round-off, and the printed deflection at its own digits."""
    size = max(abs(part) for pair in SECOND.values() for part in pair)
    for order, table in (("first", FIRST), ("second", SECOND)):
        for node in "FEDGH":
            for k, axis in enumerate("xy"):
                name = f"{order}_{node}{axis}"
                value = table.get(node, (0.0, 0.0))[k]
                yield Case(f"transfer_functions.andrews.{name}", ANDREWS, value, 1e-13, andrews, (), (name,), size)
    yield Case("transfer_functions.andrews.reduced_mass", ANDREWS, REDUCED_MASS, 1e-12, andrews, (), ("mass",))
    for name, tolerance in (("stiffness_method", 2e-8), ("linearised", 2e-8), ("path", 1e-4)):
        yield Case(f"linearise.star_dome.{name}", DOME, CROWN, tolerance, crown, (), (name,))
    exact = {"twist": 150.0, "strut": -1.0, "horizontal": 1 / math.sqrt(3)}
    yield Case("equilibrium.prism.left_free", LEFT, 3.0, 0.0, prism, (), ("left_free",))
    for name, value in exact.items():
        yield Case(f"equilibrium.prism.{name}", PRISM, value, 1e-9, prism, (), (name,))
    r, z = 2.0, 0.1
    shaken = math.sqrt((1 + (2 * z * r) ** 2) / ((1 - r**2) ** 2 + (2 * z * r) ** 2))
    yield Case("linearise.oscillator.transmissibility", SHAKEN, shaken, 1e-12, oscillator, (), ("transmissibility",))
    for count, factors in ((2, (6.0,)), (3, (4.0, 12.0))):
        for k, value in enumerate(factors, start=1):
            yield Case(f"buckling.links_{count}.mode_{k}", LINKS, value, 1e-12, links, (count,), (f"mode_{k}",))
    for name, value in (("pole_real", -math.sqrt(8.0)), ("pole_imag", math.sqrt(8.0))):
        yield Case(f"feedback.least_cost.{name}", SKYHOOK, value, 1e-12, oscillator, (), (name,))
