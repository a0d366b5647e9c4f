"""Drives at joints: the angle of a hinge, the length of a slide; and the screw, which couples the two."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from kinetruss.errors import Fault, InputError, ModelError
from kinetruss.library.building import own_arguments
from kinetruss.library.joints.sliding import cylindrical
from kinetruss.model import Bar, Coupling, HingeDrive, LengthDrive, Model, nearest


@own_arguments
def drive(
    model: Model, joint: str, name: str, *, hinge: int | None = None, gear: Any = None, motor: Any = None, amplifier: Any = None
) -> Model:
    """A drive at a joint: at one of its hinges an angle (torque), at its slide a length (force).

    Parameters
    ----------
    joint : name of a joint. name : of the drive. hinge : which of its hinges, from 0; by default the slide if it has one,
        else the first hinge. gear, motor, amplifier : of the hinge, records or names; see `HingeDrive`.

    Returns
    -------
    Model : with a `HingeDrive`, or a massless driven bar between the two nodes of the slide.

    Raises
    ------
    InputError : no such joint or hinge; a joint without angle or slide; a gear or motor at a slide. ModelError : a name that
        is in use.

    Examples
    --------
    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> door = kt.Model(nodes=corners, bodies={"door": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> hung = kt.library.joints.revolute(door, "hinge", bodies=("ground", "door"), at=(0, 0, 0), axis="z")
    >>> kt.kinematics.mobility(kt.library.joints.drive(hung, "hinge", "motor")).undriven
    0
    """
    if joint not in model.joints:
        raise InputError(f"no joint called {joint!r}. {nearest(joint, model.joints)}")
    found = model.joints[joint]
    if name in model.all_drives or name in model.whole.members:
        raise ModelError([Fault(("drives", name), "is a drive or a member already.", "Give the drive another name.")])
    train = {word: one for word, one in (("gear", gear), ("motor", motor), ("amplifier", amplifier)) if one is not None}
    if hinge is None and found.slide is not None:
        if train:
            ends = ", ".join(map(repr, found.slide))
            raise InputError(
                f"the slide of joint {joint!r} takes no {' and no '.join(train)}: a length is driven through a screw. Put an "
                f"active member with screw and motor between {ends}, or give the number of a hinge."
            )
        return model.with_(bars=model.bars | {name: Bar(ends=found.slide, kind="driven", mass=0.0)})
    which = hinge or 0
    if not 0 <= which < len(found.hinges):
        has = f"{len(found.hinges)} hinges" if found.hinges else "no angle and no slide"
        raise InputError(f"joint {joint!r}, a {found.kind} one, has {has}. Number a hinge from 0, or drive another joint.")
    one = found.hinges[which]
    return model.with_(drives=model.drives | {name: HingeDrive(axis=one.axis, start=one.start, end=one.end, **train)})


@own_arguments
def screw(
    model: Model,
    name: str,
    *,
    bodies: Sequence[str],
    at: Any,
    axis: Any,
    pitch: float,
    size: float | None = None,
    across: Any = None,
) -> Model:
    """A screw pair: a cylindrical joint whose travel and angle are coupled. One relative freedom.

    Bars alone cannot make one: the coupling ``NAME.screw`` keeps 2 pi/pitch times the travel (of the free bar ``NAME.travel``)
    minus the angle of the hinge.

    Parameters
    ----------
    pitch : travel per turn, m, positive for a right-handed thread. The others as of `cylindrical`.

    Raises
    ------
    ModelError, JointWarning : as of `cylindrical`; a pitch of 0; a second body whose nodes all lie on the axis.

    Examples
    --------
    >>> import kinetruss as kt
    >>> corners = {"O": (0, 0, 0), "X": (1, 0, 0), "Y": (0, 1, 0), "Z": (0, 0, 1)}
    >>> block = kt.Model(nodes=corners, bodies={"block": kt.Body(nodes=tuple(corners), mass=2.0)})
    >>> nut = kt.library.joints.screw(block, "nut", bodies=("ground", "block"), at="O", axis="z", pitch=0.01)
    >>> kt.kinematics.mobility(nut).degrees_of_freedom, list(nut.couplings)
    (1, ['nut.screw'])
    """
    if not pitch or not math.isfinite(pitch):
        raise ModelError([Fault(("joints", name, "pitch"), f"{pitch!r} is no travel in a turn.", "Give metres, not 0.")])
    made = cylindrical(model, name, bodies=bodies, at=at, axis=axis, size=size, across=across)
    joint = made.joints[name]
    if not joint.hinges or joint.slide is None:
        text = f"body {bodies[1]!r} has all its nodes on the axis, so no angle."
        raise ModelError([Fault(("joints", name), text, "Give it a node off the axis.")])
    hinge, bar, key = joint.hinges[0], f"{name}.travel", f"{name}.screw"
    turned = HingeDrive(axis=hinge.axis, start=hinge.start, end=hinge.end)
    coupling = Coupling(terms=((LengthDrive(bar), 2 * math.pi / pitch), (turned, -1.0)))
    return made.with_(
        bars=made.bars | {bar: Bar(ends=joint.slide, kind="free", mass=0.0)},
        couplings=made.couplings | {key: coupling},
        joints=made.joints | {name: joint.with_(kind="screw", bars=(*joint.bars, bar), couplings=(key,))},
    )
