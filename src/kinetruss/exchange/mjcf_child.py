"""Compiles MJCF with MuJoCo: a script for a process of its own, which reads JSON on its input and writes NPZ on its output.

The file is a stranger's: time and memory of this process are limited, it writes no file, and what it returns is plain arrays.
It imports nothing of kinetruss, so that it starts in the time that MuJoCo takes.
"""

from __future__ import annotations

import io
import json
import os
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

LEAST = 2e-15
"""kg and kg m^2: above what MuJoCo refuses, mjMINVAL. A body that has no more has none in the result."""
LISTS = {
    "body": "bodies", "joint": "joints", "geom": "geoms", "site": "sites", "equality": "equalities", "tendon": "tendons",
    "actuator": "actuators", "flex": "flexes",
}  # fmt: skip
WORDS = {
    "jnt_type": "mjtJoint", "eq_type": "mjtEq", "eq_objtype": "mjtObj", "actuator_trntype": "mjtTrn", "wrap_type": "mjtWrap",
}  # fmt: skip


def limit(seconds: int, memory: int) -> None:
    """Processor time, memory and files of this process; Windows has no such limits."""
    try:
        import resource
    except ImportError:
        return
    for what, most in (("CPU", seconds), ("AS", memory), ("FSIZE", 0), ("CORE", 0)):
        resource.setrlimit(getattr(resource, f"RLIMIT_{what}"), (most, most + (what == "CPU")))


def values(record: Any) -> Iterator[tuple[str, Any]]:
    """The fields of a model or its options, without methods and accessors."""
    import numpy as np

    for name in dir(record):
        if name[0] != "_" and isinstance(value := getattr(record, name), (np.ndarray, int, float)):
            yield name, np.asarray(value)


def without_idle_meshes(spec: Any) -> list[str]:
    """Put a small tetrahedron in place of each mesh from which no mass follows; the files of those that are not there.

    Raises
    ------
    FileNotFoundError : a file is not there, and the mass of a body follows from it.
    """
    from mujoco import mjtInertiaFromGeom as Rule

    meshes = {one.name: one.compiler for one in spec.meshes}
    needed = {one.meshname for one in spec.sites}
    for geom in spec.geoms:
        if geom.meshname not in meshes or geom.parent.name == "world":
            continue
        rule, (first, last) = meshes[geom.meshname].inertiafromgeom, meshes[geom.meshname].inertiagrouprange
        given = geom.parent.explicitinertial and rule != Rule.mjINERTIAFROMGEOM_TRUE
        never = rule == Rule.mjINERTIAFROMGEOM_FALSE or not first <= geom.group <= last
        light = geom.mass == 0 or (geom.mass != geom.mass and geom.density == 0)  # a mass that is not given is NaN
        if not (given or never or light):
            needed.add(geom.meshname)
    missing = []
    for mesh in spec.meshes:
        there = not mesh.file or Path(mesh.file).is_file()
        if mesh.name in needed and not there:
            raise FileNotFoundError(
                f"names the file {mesh.file!r}, which is not there; the mass of a body follows from it.\nElement {mesh.info}"
            )
        if mesh.name not in needed and mesh.file:
            missing += [] if there else [mesh.file]
            mesh.file, mesh.content_type, mesh.scale = "", "", [1, 1, 1]
            mesh.uservert, mesh.userface = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]
    return missing


def compiled(asked: Mapping[str, Any]) -> dict[str, Any]:
    """Arrays of the compiled model; ``said``, as JSON: names and lines of elements, flags, unknown fields, the version."""
    import mujoco
    import numpy as np

    texts = {name: text.encode() for name, text in asked["models"].items()}
    spec = mujoco.MjSpec.from_string(asked["text"], include=texts)
    options = spec.compiler
    options.fusestatic = options.discardvisual = options.usethread = False
    options.LRopt.mode = 0  # ranges of lengths, which only muscles use, take long
    options.boundmass, options.boundinertia = max(options.boundmass, LEAST), max(options.boundinertia, LEAST)
    for body in spec.bodies:  # the bounds would lift it
        if min(body.mass, *body.inertia) < 0:
            raise ValueError(f"mass and moments of inertia cannot be negative.\nElement {body.info}")
    missing = without_idle_meshes(spec)
    option = {name: value.copy() for name, value in values(spec.option)}
    spec.option.integrator = spec.option.enableflags = 0  # MuJoCo refuses some of them for bodies that are deformed
    model = spec.compile()
    fields = dict(values(model))
    unknown = [name for name, value in fields.items() if name not in asked["known"] and value.any()]
    unknown += [f"opt.{name}" for name, value in option.items() if f"opt.{name}" not in asked["known"] and value.any()]
    found = {name: fields[name] for name in asked["fields"] if name in fields}
    found |= {f"opt.{name}": value for name, value in option.items()}
    for name, enum in WORDS.items():
        kinds = getattr(mujoco, enum)
        found[name] = np.array([kinds(int(one)).name for one in fields[name].ravel()], dtype="U40")
    said: dict[str, Any] = {"version": mujoco.__version__, "missing": missing, "unknown": unknown, "names": {}, "lines": {}}
    for kind, several in LISTS.items():
        elements = sorted(getattr(spec, several), key=lambda one: one.id)
        said["names"][kind] = [one.name for one in elements]
        said["lines"][kind] = [int("0" + "".join(filter(str.isdigit, one.info))) for one in elements]
    for key, enum in (("disableflags", "mjtDisableBit"), ("enableflags", "mjtEnableBit")):
        bits = {one.value: name for name, one in getattr(mujoco, enum).__members__.items() if "BL_" in name}  # no counts
        value = int(option[key])
        said[key] = [bits.get(1 << k, f"bit {k}") for k in range(32) if value >> k & 1]
    return {**found, "said": json.dumps(said)}


def main() -> None:
    """Answer one question; an error is a text."""
    output = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what MuJoCo prints is no part of the answer
    asked = json.load(sys.stdin)
    limit(asked["seconds"], asked["memory"])
    import mujoco
    import numpy as np

    try:
        found = compiled(asked)
    except FileNotFoundError as error:
        found = {"error": str(error)}
    except (ValueError, mujoco.FatalError) as error:
        found = {"error": str(error), "said": mujoco.__version__}
    except (MemoryError, RuntimeError):  # MuJoCo's own want of memory comes as an unknown exception
        found = {"error": "memory"}
    answer = io.BytesIO()
    arrays: dict[str, Any] = {name: np.asarray(value) for name, value in found.items()}
    np.savez(answer, **arrays)
    output.write(answer.getvalue())
    output.close()


if __name__ == "__main__":
    main()
