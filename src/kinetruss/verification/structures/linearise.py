"""Transfer functions, small motions, prestress, feedback: Andrews' mechanism, a star dome, a prism, an oscillator."""

from __future__ import annotations

import math

import numpy as np

import kinetruss as kt

INCH, POUND = 0.0254, 4.4482216152605


def andrews() -> dict[str, float]:
    """Components of F' and F'' at the start, and the reduced mass."""
    model = kt.library.mechanisms.andrews()
    found = kt.kinematics.transfer_functions(model, "OF.angle")
    values = {"mass": kt.dynamics.linearise(model, dofs="OF.angle").mass.item()}
    for node in "FEDGH":
        for k, axis in enumerate("xy"):
            values[f"first_{node}{axis}"] = found.first.sel(node=node).values[k, 0].item()
            values[f"second_{node}{axis}"] = found.second.sel(node=node).values[k, 0, 0].item()
    return values


def dome() -> kt.Model:
    """24 bars, 220.46 lbf on the crown."""
    hexagon = [(4.92125, 8.5239), (-4.92125, 8.5239), (-9.8425, 0.0), (-4.92125, -8.5239), (4.92125, -8.5239), (9.8425, 0.0)]
    rim = [(0.0, 19.685), (-17.0472, 9.8425), (-17.0472, -9.8425), (0.0, -19.685), (17.0472, -9.8425), (17.0472, 9.8425)]
    at = [(0.0, 0.0, 3.2346), *((x, y, 2.4472) for x, y in hexagon), *((x, y, 0.0) for x, y in rim)]
    pairs = [(1, k) for k in range(2, 8)] + [(k, k + 1) for k in range(2, 7)] + [(7, 2)]
    pairs += [(6, 12), (7, 12), (7, 13), (2, 13), (2, 8), (3, 8), (3, 9), (4, 9), (4, 10), (5, 10), (5, 11), (6, 11)]
    return kt.Model(
        nodes={str(k): tuple(c * INCH for c in place) for k, place in enumerate(at, start=1)},
        fixed=[str(k) for k in range(8, 14)],
        bars={f"{a}-{b}": kt.Bar(ends=(str(a), str(b)), kind="elastic") for a, b in pairs},
        section=kt.General(area=0.0155 * INCH**2, I2=1e-12, I3=1e-12, c2=0.001, c3=0.001),
        material=kt.Material(E=30e6 * POUND / INCH**2, density=7850.0),
        loads={"crown": kt.NodalForce(node="1", force=(0.0, 0.0, -220.46 * POUND))},
    )


def crown() -> dict[str, float]:
    """Linear deflection of the crown, in: stiffness method, static response of the linearisation, start of the path."""
    model = dome()
    by_path = kt.statics.path(model, "crown", to=1e-5, step=1e-7, points=9)
    sag = (by_path.position.sel(node="1", axis="z").values / INCH - 3.2346)[-1] / by_path.load_factor.values[-1]
    lin = kt.dynamics.linearise(model, inputs="1.z", outputs="1.z")
    return {
        "stiffness_method": kt.statics.linear(model, weight=False).displacement.sel(node="1", axis="z").item() / INCH,
        "linearised": -220.46 * POUND * lin.frequency_response(0.0).item().real / INCH,
        "path": float(sag),
    }


def prism() -> dict[str, float]:
    """Twist, deg, and force densities over that of the verticals, of a prism released 10 degrees off."""
    side = {
        name: [(math.cos(a), math.sin(a), z) for a in np.radians([start, start + 120, start + 240])]
        for name, start, z in (("L", 0.0, 0.0), ("H", 140.0, 1.2))
    }
    cable = {"kind": "cable", "stiffness": 5e4, "pretension": 8e3}
    bars = {f"{s}{k}": kt.Bar(ends=(f"{s}{k}", f"{s}{(k + 1) % 3}"), **cable) for s in "LH" for k in range(3)}
    bars |= {f"strut{k}": kt.Bar(ends=(f"L{k}", f"H{k}")) for k in range(3)}
    bars |= {f"vertical{k}": kt.Bar(ends=(f"L{k}", f"H{(k + 2) % 3}"), **cable) for k in range(3)}
    nodes = {f"{s}{k}": place for s, places in side.items() for k, place in enumerate(places)}
    found = kt.statics.equilibrium(kt.Model(nodes=nodes, fixed=["L0"], bars=bars))
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
    bars = {f"b{i}": kt.Bar(ends=(f"N{i}", f"N{i + 1}")) for i in range(count)}
    bars |= {f"s{i}": kt.Bar(ends=(f"N{i}", f"W{i}"), kind="elastic", stiffness=12.0) for i in range(1, count)}
    fixed = {"N0": "xy", f"N{count}": "x"} | {f"W{i}": "xy" for i in range(1, count)}
    model = kt.Model(nodes=nodes, fixed=fixed, bars=bars, loads={"P": kt.NodalForce(node=f"N{count}", force=(0.0, -1.0))})
    return {f"mode_{k}": float(value) for k, value in enumerate(kt.statics.buckling(model, "P").load_factor.values, start=1)}


def oscillator() -> dict[str, float]:
    """Transmissibility at twice the natural frequency, damping ratio 0.1; poles of feedback of least cost on a free mass."""
    k, m, z = 50.0, 2.0, 0.1
    nodes = {"A": kt.Node(at=(0.0, 0.0)), "B": kt.Node(at=(1.0, 0.0), mass=m)}
    spring = kt.Bar(ends=("A", "B"), kind="elastic", stiffness=k, damping=2 * z * math.sqrt(k * m))
    lin = kt.dynamics.linearise(
        kt.Model(nodes=nodes, fixed={"A": "xy", "B": "y"}, bars={"s": spring}), inputs="A.x", outputs="B.x"
    )
    mass = kt.Model(nodes={"B": kt.Node(at=(0.0, 0.0), mass=1.0)}, fixed={"B": "y"})
    free = kt.dynamics.linearise(mass, inputs="B.x", dofs="B.x")
    pole = kt.dynamics.feedback(free, state_cost={"B.x": 16.0**2}).poles[0]
    return {
        "transmissibility": lin.transmissibility(2 * math.sqrt(k / m)).item(),
        "pole_real": float(pole.real),
        "pole_imag": abs(float(pole.imag)),
    }
