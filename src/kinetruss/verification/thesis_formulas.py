"""What formulas of Lacy (1991) give that are not right: his program of the triangular truss, his frames of a chain of bays.

Program (appendix A), the only road to his dynamic figures: 50 samples 0.06 s apart; x and its derivatives exact, the angles
exact, but their rates by a backward difference applied twice, zero at the first sample (first order, one step late); the
inertia of a cut-off part of the follower taken with the whole length, Iz = m (3 (od^2 + id^2) + 4 L^2)/48. Gravity acts
downward, as in the published figures (the listing's sign is wrong), and printed times are one step late.

Frames (chapter 6): equation 6.9 turns the spin of a bay's top relative to its base by the orientation of the top instead of
that of the base; equation 6.14 leaves out the cross product of the two spins. Each bay moves in its base frame as the
product's single bay does. Forces follow from the tip down: bays on base nodes that move as given, loaded by the reactions of
the bay above.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

import kinetruss as kt
from kinetruss.verification.measures import Numbers
from kinetruss.verification.thesis_bay import TILT, double_octahedral
from kinetruss.verification.thesis_triangle import CUTS, STEP, TIMES, analysed, stresses

Record = tuple[Any, Any, Any]
"""A quantity with its first and second derivative."""
LENGTH, ROD_MASS, ROD_LENGTH = 2.0, 2.4, 2.1
"""m, of follower, tube and ground; kg and m of the base rod, which is thin."""
SECTION, DOWN = kt.Tube(outer=0.0254, inner=0.022225), np.array([0.0, -9.81])
LINE = 2711.5 * SECTION.area
"""kg/m, of follower and tube."""
RADIUS = (SECTION.outer**2 + SECTION.inner**2) / 16
"""Square of the radius of gyration of the section, m^2."""


class Member(NamedTuple):
    """Unit vectors (n, 2) along a member and along its increasing angle; angle and length (n,)."""

    along: Any
    normal: Any
    angle: Record
    length: Record

    def cut(self, at_b: Any, s: Any, *, whole: bool) -> tuple[Any, Any]:
        """Tension and moment (n,) at distance s from the pin, from the balance of the piece on the B side."""
        piece, centre = self.length[0] - s, (self.length[0] + s) / 2
        radial = self.length[2] - centre * self.angle[1] ** 2 - self.along @ DOWN
        around = centre * self.angle[2] + 2 * self.length[1] * self.angle[1] - self.normal @ DOWN
        tension, pin = (at_b * self.along).sum(1) - LINE * piece * radial, (at_b * self.normal).sum(1)
        inertia = LINE * piece * (RADIUS + (LENGTH if whole else piece) ** 2 / 12)
        return tension, inertia * self.angle[2] + piece / 2 * (LINE * piece * around - 2 * pin)


def program(payload: float) -> Numbers:
    """Sections 3.3, 3.5 and Table 3.3: by his formulas along the product's motion, and (``.product``) by the product."""
    model, forces, (total, static) = analysed(TIMES, payload)
    motion = forces.motion.data.sel(member="actuator")
    length = motion["length"].values, motion["length_rate"].values, motion["length_acceleration"].values
    still, tension = stresses(model, static), total.data["section_T"]
    compression = {name: -tension.sel(part=part).min("station").values for name, (part, _) in CUTS.items()}
    his = _largest(*_by_differences(length, payload), still, STEP)
    own = _largest(stresses(model, total), compression, still, 0.0)
    return his | {f"{name}.product": value for name, value in own.items()}


def _largest(stress: Any, compression: Any, still: Any, late: float) -> Numbers:
    """Largest values and their times; `late`: how much later than the samples the times are printed, s."""
    found: dict[str, float] = {}
    for name in CUTS:
        for key, values in ((f"{name}_largest", stress[name]), (f"{name}_motion_largest", stress[name] - still[name])):
            found |= {key: values.max(), f"{key}_time": TIMES[values.argmax()] + late}
        found[f"{name}_largest_compression"] = compression[name].max()
    return found


def _by_differences(length: Record, load: float) -> tuple[dict[str, Any], dict[str, Any]]:
    """S2 stress (n,) at mid follower and at the tube's clamped end, largest compression of both over seven sections."""
    x = length[0]
    # exact angles by the law of cosines, their rates by backward differences
    phi, theta = _differences(np.arccos(1 - x**2 / (2 * LENGTH**2))), _differences(np.arccos(x / (2 * LENGTH)))
    (c, s), (C, S) = ((np.cos(angle[0]), np.sin(angle[0])) for angle in (phi, theta))
    fixed = (np.full_like(x, LENGTH), np.zeros_like(x), np.zeros_like(x))
    first = Member(np.stack([-c, s], 1), np.stack([s, c], 1), phi, fixed)
    second = Member(np.stack([C, S], 1), np.stack([-S, C], 1), theta, length)
    on_follower, on_tube = _at_b(first, second, load)
    shares = np.linspace(0.0, LENGTH, 7)
    follower = [first.cut(on_follower, s, whole=True) for s in shares]
    tube = [second.cut(on_tube, x - LENGTH + s, whole=False) for s in shares]
    compression = (np.max([-tension for tension, _ in cuts], axis=0) for cuts in (follower, tube))
    stress = (_outer_fibre(*cut) for cut in (follower[3], tube[0]))
    return dict(zip(CUTS, stress, strict=True)), dict(zip(CUTS, compression, strict=True))


def _differences(angle: Any) -> Record:
    rate = np.concatenate([[0.0], np.diff(angle) / STEP])
    return angle, rate, np.concatenate([[0.0], np.diff(rate) / STEP])


def _outer_fibre(tension: Any, moment: Any) -> Any:
    """Stress at S2: |T|/A + |M| c/I."""
    return np.abs(tension) / SECTION.area + np.abs(moment) * SECTION.extreme_fibres[0] / SECTION.second_moments[0]


def _at_b(first: Member, second: Member, load: float) -> tuple[Any, Any]:
    """Forces (n, 2) on follower and tube at B: moments about O1 and O2, balance of the load; its acceleration by phi."""
    phi, theta, (length, rate, _) = first.angle, second.angle, second.length
    m, centre = LINE * LENGTH, length - LENGTH / 2
    follower = m * (LENGTH**2 / 3 + RADIUS) * phi[2] - m * LENGTH / 2 * (first.normal @ DOWN)
    inertia = ROD_MASS * ROD_LENGTH**2 / 3 + m * (centre**2 + LENGTH**2 / 12 + RADIUS)
    moment = ROD_MASS * ROD_LENGTH / 2 + m * centre
    active = inertia * theta[2] + 2 * m * centre * rate * theta[1] - moment * (second.normal @ DOWN)
    acceleration = LENGTH * (phi[2][:, None] * first.normal - phi[1][:, None] ** 2 * first.along)
    across = (follower / LENGTH)[:, None] * first.normal, (active / length)[:, None] * second.normal
    axial = load * (DOWN - acceleration) - across[0] - across[1]
    shares = np.linalg.solve(np.stack([first.along, second.along], 2), axial[:, :, None])
    return across[0] + shares[:, 0] * first.along, across[1] + shares[:, 1] * second.along


BAYS = 3
BELOW = {"N1": "N7", "N2": "N9", "N3": "N8"}
"""Base nodes of a bay -> the top nodes of the bay below that they are."""
SPAN = 3.0  # s, of the motion
MOVES: dict[str, tuple[float | None, tuple[tuple[float, float, tuple[float, ...]], ...]]] = {
    "together": (0.0, ((0.0, SPAN, (0.75, 1.5, 2.25)),)),
    "delayed": (0.75, ((0.0, 0.75, (0.5,)), (0.75, SPAN, (1.0, 1.5, 2.0, 2.5)))),
    "one_axis": (None, ((0.0, SPAN, (0.75, 1.5, 2.25)),)),
}
"""Name -> start of gamma (s; None: it stays 0), and pieces: first and last time, and the instants compared."""


def frames(move: str) -> Numbers:
    """Largest differences from the product over the instants: components of velocity and acceleration, sizes of forces."""
    start, pieces = MOVES[move]
    found: dict[str, list[float]] = {"velocity": [], "acceleration": [], "force": []}
    chain, bay = double_octahedral(BAYS, payload_mass=2.0), double_octahedral()
    for first, last, times in pieces:
        forces = kt.dynamics.inverse(chain, _tilted(chain, start, first, last, times), static=False)
        alone = _tilted(bay, start, first, last, times)
        turn = kt.kinematics.pose(bay, alone, tuple(BELOW.values()))
        for i in range(len(times)):
            now, load = forces.motion.data.isel(time=i), np.zeros((3, 3))
            printed = _as_printed(alone.data.isel(time=i), turn.isel(time=i))
            for k, motion in zip(range(BAYS, 0, -1), reversed(printed), strict=True):
                # base nodes belong to the bay below
                at = [f"B{k - 1}.{BELOW[name]}" if k > 1 and name in BELOW else f"B{k}.{name}" for name in bay.nodes]
                for key, values in zip(("velocity", "acceleration"), motion[1:], strict=True):
                    found[key].append(np.abs(values - now[key].sel(node=at).values).max())
                force, load = _forces(bay, motion, 2.0 if k == BAYS else 0.0, load)
                own = forces.joint_force.isel(time=i).sel(member=[f"B{k}.{name}" for name in bay.members]).values
                found["force"].append(np.linalg.norm(force - own, axis=-1).max())
    return {name: max(values) for name, values in found.items()}


def _tilted(model: kt.Model, start: float | None, first: float, last: float, times: Any) -> kt.results.Motion:
    """Every bay from 0 to 10 degrees: beta in 3 s, gamma from `start` on; a piece of it that is a polynomial, by a table."""
    t = np.linspace(first, last, 13)
    shares = {"beta": t / SPAN, "gamma": 0.0 * t if start is None else np.maximum(t - start, 0.0) / (SPAN - start)}
    tilts = {angle: tuple(TILT * s**3 * (10 - 15 * s + 6 * s**2)) for angle, s in shares.items()}
    values = {f"{pose}.{angle}": tilt for pose in model.poses for angle, tilt in tilts.items()}
    return kt.kinematics.follow(model, kt.Spline(times=tuple(t), values=values), times=np.array(times) - first)


def _as_printed(now: Any, turn: Any) -> list[Record]:
    """Global motion of the nodes of every bay, base first, from those of one bay and the turn of its top."""
    own: Record = (now.position.values, now.velocity.values, now.acceleration.values)
    top = [list(now.node.values).index(name) for name in BELOW.values()]
    R, origin, spin, spin_rate = np.eye(3), (np.zeros(3),) * 3, np.zeros(3), np.zeros(3)
    found = []
    for _ in range(BAYS):
        x, v, a = (one @ R.T for one in own)
        # eq. 6.3, 6.7, 6.11
        velocity = origin[1] + v + np.cross(spin, x)
        turned = np.cross(spin_rate, x) + np.cross(spin, np.cross(spin, x))
        found.append((origin[0] + x, velocity, origin[2] + a + 2 * np.cross(spin, v) + turned))
        # eq. 6.9 and 6.14 as printed
        R, origin = R @ turn.rotation_matrix.values, tuple(one[top].mean(0) for one in found[-1])
        spin, spin_rate = spin + R @ turn.angular_velocity.values, spin_rate + R @ turn.angular_acceleration.values
    return found


def _forces(bay: kt.Model, motion: Record, tip: float, load: Any) -> tuple[Any, Any]:
    """Forces on the members (member, end, axis) of a bay whose base moves as given; and its load on the bay below."""
    tops = tuple(BELOW.values())
    places = zip(bay.nodes, motion[0], strict=True)
    nodes = {name: kt.Node(at=tuple(x), mass=tip if name in tops else 0.0) for name, x in places}
    loads = {f"on_{name}": kt.NodalForce(node=name, force=tuple(force)) for name, force in zip(tops, load, strict=True)}
    drives = {f"{name}.{axis}": kt.CoordinateDrive(node=name, axis=axis) for name in BELOW for axis in "xyz"}
    model = bay.with_(nodes=nodes, fixed={}, poses={}, loads=loads, drives=drives)
    given = kt.kinematics.from_arrays(model, [0.0], *(one[None] for one in motion))
    forces = kt.dynamics.inverse(model, given, static=False)
    held = forces.drive_force.sel(drive=list(drives)).values.reshape(3, 3)
    return forces.joint_force.isel(time=0).values, -held
