"""What section forces follow from, and what they are handed on as."""

from __future__ import annotations

from typing import NamedTuple

from kinetruss.kernels.compiled.record import F1, F2, I0, I1, Floats, Record, record

__all__ = ["Histories", "Members", "Polynomials"]


@record
class Members(Record):
    """Members, their masses and the actions on them: what stays the same along a motion.

    segments : that a part has at most. p, q (m,) : nodes at the ends A, B. orient (m,) : node that spans plane 1-2 with the
    member, or -1; reference (m, 3) : direction where there is none. two_rods (m,) : 1 of active members. rods (m, 6) : mass kg,
    length m, rotary inertia kg m^2 of a bar or base, then of a tube. acting (m + 1,) : actions acting[k]:acting[k + 1] are on
    member k. clamped_ptr (2 m + 1,) : masses clamped[clamped_ptr[j]:clamped_ptr[j + 1]] are on the base of member k, j = 2 k,
    or on its tube, j = 2 k + 1; clamped (c, 2) : fraction from the end towards A, ascending, and kg, besides those in rods.
    spread (actions,) : 1 of those along the whole bar. gravity (3,) m/s^2.
    """

    segments: I0
    p: I1
    q: I1
    orient: I1
    two_rods: I1
    acting: I1
    spread: I1
    clamped_ptr: I1
    clamped: F2
    rods: F2
    reference: F2
    gravity: F1


class Histories(NamedTuple):
    """What members go through: how their nodes move, what their joints do, what acts on them between their ends.

    position, velocity, acceleration (t, n, dim) m, m/s, m/s^2. joint_force (t, m, 2, dim) : on the member at its ends A, B, N.
    worth (t, actions, 2, dim) : forces at A and B that an action is worth, N. place (t, actions) : its fraction from A; on an
    active member an end.
    """

    position: Floats
    velocity: Floats
    acceleration: Floats
    joint_force: Floats
    worth: Floats
    place: Floats


class Polynomials(NamedTuple):
    """Section forces along the segments s of all parts.

    coef (t, parts, s, 17) : T 0:3, V2 3:6, V3 6:9 N, M2 9:13, M3 13:17 N m, in ascending powers of xi. ends (t, parts, s) : the
    xi where a segment ends, that of the last beyond every xi; segments behind it mean nothing. nut (t, parts) : the one of them
    where the nut is on a base; beyond every xi on other parts.
    """

    coef: Floats
    ends: Floats
    nut: Floats
