"""The pose of a robot in which its loops are closed, and which conditions of its closures are independent.

Frames follow from the values of the joints along the tree. Closures are solved by Gauss-Newton steps of least length with the
geometric Jacobian. Joints whose values were asked for and joints with drives stay where they are if the others can close the
loops; what moves is told. Couplings of joints are further conditions: the sum of factor times value, minus what it stays at.
A tree without couplings has nothing to close.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from kinetruss.display import counted
from kinetruss.errors import InputError
from kinetruss.exchange.robots import COLUMNS, Closure, JointCoupling, Pivot, Robot, placement, turn_about

if TYPE_CHECKING:
    from numpy.typing import NDArray


STEPS = 100
LONGEST = 0.5
"""Longest step of a joint, rad, or as a multiple of the size of the robot."""
CLOSED = 1e-12
"""Gap of a loop that counts as closed, as a multiple of the size."""
NEARLY = 1e-5
"""Largest gap, as a multiple of the size, that is accepted and reported: files hold few digits."""
INDEPENDENT = 1e-9
"""Smallest singular value, relative to the largest, that counts as independent."""

SHORT = 0.1
"""Step of an asked value on the way from the pose of the file, rad, or as a multiple of the size of the robot."""
MOVED = 1e-9
"""Change of a joint that is told, rad or m."""

State = dict[str, Any]
"""Name of a joint -> (4, 4) motion, or the value of a revolute or prismatic one."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Posed:
    """A robot in its closed pose.

    frames : (4, 4) of each link. values : of revolute and prismatic joints, rad, m. gap : largest that is left, m or rad.
    freedoms : of the joints and closures together, by rank. redundant : closure -> number of its conditions that the
        joints and the closures before it imply. implied : couplings that the joints, closures and couplings before imply.
    moved : what closing the loops did to joints that were asked to be elsewhere, and to driven ones, in words.
    """

    robot: Robot
    frames: Mapping[str, NDArray[np.float64]]
    values: Mapping[str, float]
    gap: float
    freedoms: int
    redundant: Mapping[str, int]
    implied: Sequence[str] = ()
    moved: Sequence[str] = ()


def closed(robot: Robot) -> Posed:
    """The closed pose nearest to that of the file.

    Raises
    ------
    InputError : loops that no values of the joints close.
    """
    single = {pivot.name for pivot in robot.pivots if COLUMNS[pivot.kind] == 1}
    asked = {pivot.name for pivot in robot.pivots if pivot.start is not None and pivot.name in single}
    state = _values(robot)
    if not robot.closures and not robot.couplings:
        values = {name: float(state[name]) for name in single}
        freedoms = sum(COLUMNS[pivot.kind] for pivot in robot.pivots)
        return Posed(robot=robot, frames=frames_of(robot, state), values=values, gap=0.0, freedoms=freedoms, redundant={})
    frames = frames_of(robot, _values(robot, at_home=True))
    robot = replace(robot, closures=[_defined(one, frames) for one in robot.closures])
    size = _size(robot, frames)
    gap, found = _nearest(robot, state, size, asked)
    if gap > NEARLY:
        raise _open(robot, found, size)
    frames = frames_of(robot, found)
    freedoms, redundant, implied = _independent(robot, frames, size)
    return Posed(
        robot=robot,
        frames=frames,
        values={name: float(found[name]) for name in single},
        gap=0.0 if gap <= CLOSED * 10 else gap * size,
        freedoms=freedoms,
        redundant=redundant,
        implied=implied,
        moved=_moved(robot, state, found, asked),
    )


def _nearest(robot: Robot, state: State, size: float, asked: set[str]) -> tuple[float, State]:
    """The closed pose in which asked values are kept if possible: on the way there from the pose of the file, or at once."""
    kept = [pivot for pivot in robot.pivots if pivot.name not in asked]
    stages = [pivot for pivot in kept if pivot.drive is None], kept
    if asked and (found := _along(robot, state, stages, size, asked)) is not None:
        return found
    found = _closest(robot, state, stages, size)
    return _closest(robot, state, [list(robot.pivots)], size) if asked and found[0] > NEARLY else found


def _closest(robot: Robot, state: State, stages: Sequence[Sequence[Pivot]], size: float) -> tuple[float, State]:
    """The state with the least gap if one set of joints moves, or the next if that does not close the loops."""
    found: list[tuple[float, State]] = []
    for moving in stages:
        found.append(_solve(robot, dict(state), moving, size))
        if found[-1][0] <= CLOSED * 10:
            break
    return min(found, key=lambda one: one[0])


def _along(
    robot: Robot, state: State, stages: Sequence[Sequence[Pivot]], size: float, asked: set[str]
) -> tuple[float, State] | None:
    """The closed pose at asked values, reached in short steps from that of the file; None if the way ends before."""
    unit = {pivot.name: size if pivot.kind == "prismatic" else 1.0 for pivot in robot.pivots}
    start = _values(robot, at_home=True)
    gap, now = _closest(robot, start, stages, size)
    way = {name: float(state[name]) - float(now[name]) for name in asked}
    steps = math.ceil(max(abs(by) / unit[name] for name, by in way.items()) / SHORT)
    if gap > NEARLY or steps > STEPS:
        return None
    begin = {name: float(now[name]) for name in asked}
    for k in range(1, steps + 1):
        share = k / steps
        gap, now = _closest(robot, now | {name: begin[name] + share * by for name, by in way.items()}, stages, size)
        if gap > NEARLY:
            return None
    return gap, now | {name: state[name] for name in asked}


def _moved(robot: Robot, state: State, found: State, asked: set[str]) -> list[str]:
    lines: list[str] = []
    others: dict[str, float] = {}
    for pivot in robot.pivots:
        if COLUMNS[pivot.kind] != 1:
            continue
        old, new = float(state[pivot.name]), float(found[pivot.name])
        unit = "m" if pivot.kind == "prismatic" else "rad"
        if abs(new - old) <= MOVED:
            continue
        if pivot.name in asked or pivot.drive is not None:
            was = "was asked to be at" if pivot.name in asked else "is drawn at"
            text = f"joint {pivot.name} {was} {old:.6g} {unit} and is at {new:.6g} {unit} ({new - old:+.3g})"
            lines.append(f"{text}: there the other joints were not found to close the loops")
        else:
            others[f"{pivot.name} by {new - old:+.3g} {unit}"] = abs(new - old)
    if others:
        count = counted(len(others), "joint")
        lines.append(f"closing the loops moved {count} without drives, most of all {max(others, key=others.__getitem__)}")
    return lines


def _values(robot: Robot, *, at_home: bool = False) -> State:
    """The joints as the file has them, or where the search starts."""
    single = {p.name: p.home if at_home or p.start is None else p.start for p in robot.pivots}
    return {p.name: single[p.name] if COLUMNS[p.kind] == 1 else np.eye(4) for p in robot.pivots}


def frames_of(robot: Robot, state: Mapping[str, Any]) -> dict[str, NDArray[np.float64]]:
    """Frames (4, 4) of all links along the tree."""
    frames = {robot.root: np.eye(4)}
    for pivot in robot.pivots:
        frames[pivot.child] = frames[pivot.parent] @ pivot.origin @ _motion(pivot, state[pivot.name]) @ pivot.after
    return frames


def frames_at_rest(robot: Robot) -> dict[str, NDArray[np.float64]]:
    """Frames (4, 4) of all links where the springs of the joints have no force; loops may be open there."""
    single = {one.name: one.spring[1] for one in robot.pivots if COLUMNS[one.kind] == 1}
    return frames_of(robot, _values(robot, at_home=True) | single)


def _motion(pivot: Pivot, value: Any) -> NDArray[np.float64]:
    if pivot.kind == "revolute":
        return placement(turn_about(pivot.axis, float(value)))
    if pivot.kind == "prismatic":
        return placement(None, float(value) * pivot.axis)
    return np.asarray(value)


def _defined(closure: Closure, frames: Mapping[str, NDArray[np.float64]]) -> Closure:
    """A closure whose second frame is where the pose of the file has the first."""
    first, second = closure.frames
    if second is not None:
        return closure
    one, two = closure.links
    return replace(closure, frames=(first, np.linalg.inv(frames[two]) @ frames[one] @ first))


def _size(robot: Robot, frames: Mapping[str, NDArray[np.float64]]) -> float:
    places = [frame[:3, 3] for frame in frames.values()]
    places += [(frames[pivot.parent] @ pivot.origin)[:3, 3] for pivot in robot.pivots]
    places += [
        (frames[link] @ frame)[:3, 3] for one in robot.closures for link, frame in zip(one.links, _both(one), strict=True)
    ]
    size = float(np.ptp(np.array(places), axis=0).max())
    return size or 1.0


def _both(closure: Closure) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    first, second = closure.frames
    return first, first if second is None else second


def _solve(robot: Robot, state: State, moving: Sequence[Pivot], size: float) -> tuple[float, State]:
    """The gap that is left (relative to the size; rad), and the state."""
    gap = _gap(robot, state, size)
    best = float(np.abs(gap).max(initial=0.0)), dict(state)
    columns = {pivot.name for pivot in moving if COLUMNS[pivot.kind]}
    stalled = 0
    for _ in range(STEPS if columns else 0):
        if best[0] <= CLOSED / 10 or stalled > 3:
            break
        J = _jacobian(robot, frames_of(robot, state), size, columns)
        step = np.linalg.lstsq(J, -gap, rcond=INDEPENDENT)[0]
        step *= min(1.0, LONGEST / max(float(np.abs(step).max()), 1e-300))
        _advance(robot, state, step, size, columns)
        gap = _gap(robot, state, size)
        now = float(np.abs(gap).max(initial=0.0))
        stalled = 0 if now < 0.9 * best[0] else stalled + 1
        if now < best[0]:
            best = now, dict(state)
    return best


def _gap(robot: Robot, state: State, size: float) -> NDArray[np.float64]:
    """Place of the first frame minus that of the second, relative to the size; of welds the rotation between them too, rad.

    Then the gaps of the couplings, in the unit of their largest term, rad or sizes.
    """
    frames, rows = frames_of(robot, state), list[Any]()
    for closure in robot.closures:
        one, two = (frames[link] @ frame for link, frame in zip(closure.links, _both(closure), strict=True))
        rows.append((one[:3, 3] - two[:3, 3]) / size)
        if closure.kind == "weld":
            rows.append(_rotation_vector(one[:3, :3] @ two[:3, :3].T))
    for coupling in robot.couplings:
        total = sum(factor * float(state[name]) for name, factor in coupling.factors.items())
        rows.append(np.array([(total - coupling.value) / max(map(abs, _factors(robot, coupling, size).values()))]))
    return np.concatenate(rows) if rows else np.zeros(0)


def _factors(robot: Robot, coupling: JointCoupling, size: float) -> dict[str, float]:
    """Factors of the joints of a coupling, where lengths count in sizes."""
    slides = {pivot.name for pivot in robot.pivots if pivot.kind == "prismatic"}
    return {name: factor * (size if name in slides else 1.0) for name, factor in coupling.factors.items()}


def _rotation_vector(R: Any) -> NDArray[np.float64]:
    axial = 0.5 * np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    sine, cosine = float(np.linalg.norm(axial)), 0.5 * (float(np.trace(R)) - 1.0)
    if sine > 1e-8:
        return np.asarray(axial * np.arctan2(sine, cosine) / sine)
    if cosine > 0:
        return axial
    axis = np.sqrt(np.maximum(0.5 * (np.diag(R) + 1.0), 0.0))  # half a turn: any of both directions
    return np.asarray(np.pi * axis * np.where(R[int(np.argmax(axis))] < 0, -1.0, 1.0))


def _jacobian(robot: Robot, frames: Mapping[str, Any], size: float, columns: set[str]) -> NDArray[np.float64]:
    """Rates of `_gap` by the joints: of each w (3,), the angular velocity, and v (3,), the velocity of the point."""
    place, count = {}, 0
    for pivot in robot.pivots:
        if pivot.name in columns:
            place[pivot.name] = count
            count += COLUMNS[pivot.kind]
    above = _above(robot)
    blocks = []
    for closure in robot.closures:
        point = (frames[closure.links[0]] @ closure.frames[0])[:3, 3]
        block = np.zeros((6, count))
        for link, sign in zip(closure.links, (1.0, -1.0), strict=True):
            for pivot in above[link]:
                if pivot.name in place:
                    at = place[pivot.name]
                    block[:, at : at + COLUMNS[pivot.kind]] += sign * _rates(pivot, frames, point, size)
        blocks.append(block if closure.kind == "weld" else block[:3])
    for coupling in robot.couplings:
        factors, row = _factors(robot, coupling, size), np.zeros((1, count))
        for name in factors.keys() & place.keys():
            row[0, place[name]] = factors[name] / max(map(abs, factors.values()))
        blocks.append(row)
    return np.vstack(blocks) if blocks else np.zeros((0, count))


def _rates(pivot: Pivot, frames: Mapping[str, Any], point: Any, size: float) -> NDArray[np.float64]:
    """Velocity of a point over the size, and angular velocity, (6, columns); lengths count in sizes."""
    frame = frames[pivot.parent] @ pivot.origin
    arm = point - frame[:3, 3]
    if pivot.kind == "revolute":
        w = frame[:3, :3] @ pivot.axis
        return np.concatenate([np.cross(w, arm) / size, w])[:, None]
    if pivot.kind == "prismatic":
        return np.concatenate([frame[:3, :3] @ pivot.axis, np.zeros(3)])[:, None]
    if pivot.kind == "free":  # about the origin of the child, which moves with it
        arm = point - (frames[pivot.child] @ np.linalg.inv(pivot.after))[:3, 3]
    turning = np.vstack([np.cross(np.eye(3), arm).reshape(3, 3).T / size, np.eye(3)])
    if pivot.kind == "ball":
        return turning
    return np.hstack([np.vstack([np.eye(3), np.zeros((3, 3))]), turning])


def _above(robot: Robot) -> dict[str, list[Pivot]]:
    """The joints between the root and each link."""
    found: dict[str, list[Pivot]] = {robot.root: []}
    for pivot in robot.pivots:
        found[pivot.child] = [*found[pivot.parent], pivot]
    return found


def _advance(robot: Robot, state: State, step: Any, size: float, columns: set[str]) -> None:
    """Add a step; rotations and translations of balls and free links are in global axes."""
    frames = frames_of(robot, state)
    at = 0
    for pivot in robot.pivots:
        if pivot.name not in columns:
            continue
        count = COLUMNS[pivot.kind]
        part = step[at : at + count]
        at += count
        if count == 1:
            state[pivot.name] += float(part[0]) * (size if pivot.kind == "prismatic" else 1.0)
        elif count:
            R = (frames[pivot.parent] @ pivot.origin)[:3, :3]
            turned, moved = R.T @ part[-3:], (R.T @ part[:3] * size if count == 6 else np.zeros(3))
            angle = float(np.linalg.norm(turned))
            old = state[pivot.name]
            new = placement(turn_about(turned / angle, angle) @ old[:3, :3] if angle else old[:3, :3], old[:3, 3] + moved)
            state[pivot.name] = new


def _independent(robot: Robot, frames: Mapping[str, Any], size: float) -> tuple[int, dict[str, int], list[str]]:
    """Freedoms by rank, of each closure the number of conditions that those before it imply, and couplings that are implied.

    The rows of each closure are judged by what is left of them beside those before it.
    """
    J = _jacobian(robot, frames, size, {pivot.name for pivot in robot.pivots if COLUMNS[pivot.kind]})
    least = INDEPENDENT * (float(np.linalg.norm(J, 2)) if J.size else 1.0)
    basis, row = np.zeros((0, J.shape[1])), 0
    spare: list[int] = []
    for count in [6 if closure.kind == "weld" else 3 for closure in robot.closures] + [1] * len(robot.couplings):
        rest = J[row : row + count]
        for _ in range(2):
            rest = rest - rest @ basis.T @ basis
        sizes, rows = np.linalg.svd(rest, full_matrices=False)[1:] if rest.size else (np.zeros(0), rest)
        new = rows[sizes > least]
        basis = np.vstack([basis, new])
        spare.append(count - len(new))
        row += count
    loops = len(robot.closures)
    redundant = {closure.name: count for closure, count in zip(robot.closures, spare[:loops], strict=True)}
    implied = [one.name for one, count in zip(robot.couplings, spare[loops:], strict=True) if count]
    return J.shape[1] - len(basis), redundant, implied


def _open(robot: Robot, state: State, size: float) -> InputError:
    lines = []
    for closure in robot.closures:
        gap = np.abs(_gap(replace(robot, closures=[closure], couplings=()), state, size))
        apart, turned = float(gap[:3].max()) * size, float(gap[3:].max(initial=0.0))
        if max(apart / size, turned) > NEARLY:
            more = f" and {np.degrees(turned):.3g} deg" if closure.kind == "weld" else ""
            lines.append(f"{closure.where}: closure {closure.name!r} stays open by {apart:.3g} m{more}.")
    off = {one: float(_gap(replace(robot, closures=(), couplings=[one]), state, size)[0]) for one in robot.couplings}
    lines += [f"{one.where}: coupling {one.name!r} is off by {gap:.3g}." for one, gap in off.items() if abs(gap) > NEARLY]
    mend = (
        "The joints cannot bring its two frames together from the pose of the file. Give joint values near a closed pose "
        "(--at JOINT=VALUE), or correct the places of the two frames. A closure of three conditions ('3d', connect) needs "
        "only their origins to meet."
    )
    return InputError("\n".join([*lines, mend]))
