"""An MJCF file, with the files that it includes, compiled by MuJoCo in a process of its own."""

from __future__ import annotations

import importlib.util
import io
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import numpy as np

from kinetruss.errors import InputError
from kinetruss.exchange import mjcf_child
from kinetruss.exchange.drawings import text_of
from kinetruss.exchange.imported import needed
from kinetruss.exchange.mjcf_fields import CARRIED, KNOWN, LISTED
from kinetruss.exchange.xml import Element, parse_xml
from kinetruss.limits import LARGEST, MOST_ENTRIES
from kinetruss.model import nearest

ROOTS = ("mujocoinclude", "mujoco")


def included(root: Element, folder: Path, max_size: int) -> Element:
    """The tree with each <include file="..."/> replaced by the elements of that file, whose path starts at `folder`.

    Raises
    ------
    ModelError : a file that is not there, not XML, outside the folder, or included twice.
    """
    return _expanded(root, folder, max_size, set(), [0])


def _expanded(element: Element, folder: Path, max_size: int, seen: set[Path], count: list[int]) -> Element:
    children: list[Element] = []
    for child in element.children:
        count[0] += 1
        if count[0] > MOST_ENTRIES:
            raise child.fault(f"makes more than {MOST_ENTRIES:,} elements.", "Give a smaller file.")
        if child.tag == "include":
            other = _file(child, folder, max_size, seen)
            children += _expanded(other, folder, max_size, seen, count).children
        else:
            children.append(_expanded(child, folder, max_size, seen, count))
    return Element(element.file, element.tag, element.line, element.attributes, children)


def _file(element: Element, folder: Path, max_size: int, seen: set[Path]) -> Element:
    path = beside(element, folder, folder)
    if path.resolve() in seen:
        raise element.fault(f"includes {element.text('file')!r} a second time.", "MuJoCo allows a file once. Remove one.")
    seen.add(path.resolve())
    return parse_xml(path, text_of(path, max_size), ROOTS)


def beside(element: Element, folder: Path, top: Path) -> Path:
    """The file that an element names from the folder `top`, which must be in the folder of the model."""
    name = element.text("file")
    path = top / name
    if not path.resolve().is_relative_to(folder.resolve()):
        raise element.fault(f"file {name!r} is outside the folder of the model.", "Move it beside the model, or below.")
    if not path.is_file():
        raise element.fault(f"file {name!r} is not there.", f"Put it into {top}, or correct the name.")
    return path


# An MJCF file compiled by MuJoCo in a process of its own, with the place in the file of every element.
#
# MuJoCo gets the elements of all files as one text, each on a line of its own, so that the line in its messages and in its
# records names the element. It does not get what neither moves nor carries: textures, cameras, sensors, poses.

SECONDS, MEMORY = 60, 4 * 2**30
"""Limits of the process: processor time, s (three times as long on the clock), and bytes."""
WITHOUT = ("sensor", "keyframe", "visual", "statistic", "size", "custom", "texture", "material", "skin", "camera", "light")
"""Elements that MuJoCo does not get."""
FORMER = {
    "option": ("apirate", "collision", "mpr_iterations", "mpr_tolerance"),
    "flag": ("sensornoise",),
    "compiler": ("convexhull", "exactmeshinertia"),
    "contact": ("internal",),
}
"""Attributes that MuJoCo had once and refuses now; none has an influence on the equations of motion."""
FOLDERS = ("assetdir", "meshdir", "texturedir", "strippath")


@dataclass(eq=False)
class Compiled:
    """The compiled model: its fields by name, names of the elements of each kind, and what else MuJoCo said.

    roots : the outermost elements of the file and of the models that it attaches. former : elements with an attribute that
    MuJoCo does not know any more, and its name.
    """

    fields: Mapping[str, Any]
    said: Mapping[str, Any]
    elements: Sequence[Element]
    roots: Sequence[Element]
    former: Sequence[tuple[Element, str]]

    def __getattr__(self, name: str) -> Any:
        return self.fields[name]

    def name(self, kind: str, index: int) -> str:
        """The name of a body, joint, ...; empty without."""
        return str(self.said["names"][kind][index])

    def element(self, kind: str, index: int) -> Element:
        """The element of the file that made a body, joint, ...; the whole file if it has none."""
        line = int(self.said["lines"][kind][index])
        return self.elements[max(line - 1, 0)]


@dataclass(eq=False)
class _Texts:
    """The lines that MuJoCo gets, with their elements, and the models that the file attaches, by names of their own."""

    folder: Path
    max_size: int
    lines: list[str] = field(default_factory=list)
    elements: list[Element] = field(default_factory=list)
    roots: list[Element] = field(default_factory=list)
    models: dict[str, str] = field(default_factory=dict)
    waiting: list[Path] = field(default_factory=list)
    attaches: dict[Path, list[Path]] = field(default_factory=dict)
    former: list[tuple[Element, str]] = field(default_factory=list)

    def add(self, one: Element, folders: Mapping[str, str], top: Path) -> None:
        """An element with those in it. folders : attributes of the compiler about files; top : folder of the model."""
        if one.tag in WITHOUT:
            return
        given = {name: text for name, text in one.attributes.items() if name != "material"}
        for name in FORMER.get(one.tag, ()):
            if given.pop(name, None) is not None:
                self.former.append((one, name))
        if one.tag == "compiler":
            given = {name: text for name, text in given.items() if name not in FOLDERS}
        elif "file" in given and one.tag == "model":
            given["file"] = self._attached(one, top)
        elif "file" in given and one.tag == "hfield":  # shapes for contact only: flat here
            given = {"name": Path(given["file"]).stem, **given, "nrow": "2", "ncol": "2"}
            del given["file"]
        elif "file" in given:
            file = Path(given["file"].replace("\\", "/"))
            name = file.name if folders.get("strippath") == "true" else str(file)
            given["file"] = str(top.absolute() / folders.get("meshdir", folders.get("assetdir", "")) / name)
        self.elements.append(one)
        self.lines.append(f"<{one.tag}" + "".join(f" {name}={quoteattr(text)}" for name, text in given.items()) + ">")
        for child in one.children:
            self.add(child, folders, top)
        self.lines[-1] += f"</{one.tag}>"

    def model(self, root: Element, top: Path) -> str:
        """The text of a model; its first line is the one after all before it."""
        before = len(self.lines)
        self.roots.append(root)
        folders = {name: text for one in root.all("compiler") for name, text in one.attributes.items() if name in FOLDERS}
        self.add(root, folders, top)
        return "\n" * before + "\n".join(self.lines[before:])

    def _attached(self, one: Element, top: Path) -> str:
        """The name of an attached model, each file once."""
        path, here = beside(one, self.folder, top).resolve(), Path(self.roots[-1].file).resolve()
        if path.suffix.lower() == ".urdf":
            raise one.fault("attaches a URDF, which is not read.", "Attach MJCF.")
        self.attaches.setdefault(here, []).append(path)
        below = [path]
        for other in below:
            below += [more for more in self.attaches.get(other, ()) if more not in below]
        if here in below:
            raise one.fault("attaches a model that attaches this file: there is no end.", "Remove one of them.")
        if path not in self.waiting:
            self.waiting.append(path)
        return f"model{self.waiting.index(path) + 1}.xml"


def compiled(root: Element, folder: Path, max_size: int) -> Compiled:
    """The compiled model of a file whose includes are in the tree.

    Raises
    ------
    ModelError : what MuJoCo refuses, with the element. InputError : MuJoCo is not installed.
    """
    if importlib.util.find_spec("mujoco") is None:
        needed("mujoco", "exchange")
    texts = _Texts(folder, max_size)
    text = texts.model(root, folder)
    while len(texts.models) < len(texts.waiting):
        path = texts.waiting[len(texts.models)]
        other = included(parse_xml(path, text_of(path, max_size), "mujoco"), path.parent, max_size)
        texts.models[f"model{len(texts.models) + 1}.xml"] = texts.model(other, path.parent)
    asked = {
        "text": text, "models": texts.models, "seconds": SECONDS, "memory": MEMORY,
        "fields": [*CARRIED, *LISTED], "known": sorted(KNOWN),
    }  # fmt: skip
    found = _answer(asked, root)
    if "error" in found:
        raise _refused(str(found["error"]), str(found.get("said", "")), texts)
    said = json.loads(str(found.pop("said")))
    made = Compiled(found, said, texts.elements, texts.roots, texts.former)
    _check(made, root)
    return made


def _answer(asked: Mapping[str, Any], root: Element) -> dict[str, Any]:
    """What the other process returns."""
    quiet = {"MUJOCO_GL": "disable", "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    command = [sys.executable, "-P", "-W", "ignore", mjcf_child.__file__]
    mend = "Give a smaller model: fewer copies (replicate), smaller meshes, or bodies with <inertial>."
    try:
        done = subprocess.run(
            command, input=json.dumps(asked).encode(), capture_output=True, timeout=3 * SECONDS, check=False,
            cwd=tempfile.gettempdir(), env={**os.environ, **quiet},
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        raise root.fault(f"takes MuJoCo more than {3 * SECONDS} s.", mend) from None
    if done.returncode == -getattr(signal, "SIGXCPU", 0):
        raise root.fault(f"takes MuJoCo more than {SECONDS} s of processor time.", mend)
    try:
        with np.load(io.BytesIO(done.stdout), allow_pickle=False) as file:
            found = {name: file[name] for name in file.files}
    except (ValueError, OSError, EOFError, zipfile.BadZipFile):
        last = (done.stderr.decode(errors="replace").strip().splitlines() or ["no message"])[-1][:200]
        found = {"error": "memory"}
        if "MemoryError" not in last and "allocate" not in last:
            text = f"ends MuJoCo with code {done.returncode}: {last}."
            raise root.fault(text, "Load it in MuJoCo, and mend what it says.") from None
    if str(found.get("error")) == "memory":
        raise root.fault(f"ends MuJoCo: it needs more than {MEMORY / 2**30:g} GB, or MuJoCo fails on it.", mend)
    return found


def _refused(error: str, version: str, texts: _Texts) -> InputError:
    """The error of the element that MuJoCo names by its line, with a name that is like the one it misses.

    version : of MuJoCo; empty for what is wrong with a file that the model names.
    """
    lines = [int(number) for number in re.findall(r"line (\d+)", error)]
    one = texts.elements[min(lines[-1], len(texts.elements)) - 1] if lines else texts.elements[0]
    message = re.split(r"\n+Element ", error)[0].strip()
    for word in ("XML Error: ", "Error: ", "Schema violation: "):
        message = message.removeprefix(word)
    names = {other.attributes["name"] for other in texts.elements if "name" in other.attributes}
    names |= {other.attributes["class"] for other in texts.elements if other.tag == "default" and "class" in other.attributes}
    given = [text for name, text in one.attributes.items() if name != "file"]
    called = [text for text in given if f"'{text}'" in message or "unknown default" in message]
    missing = [text for text in called if text not in names and not re.match(r"^[-\d. ]", text)]
    mend = nearest(missing[0], sorted(names)) if missing else "Correct it."
    if not version:
        return one.fault(message, "Put it there, or give the bodies that have its shape an <inertial>.")
    return one.fault(f"MuJoCo {version} refuses it: {' '.join(message.split()).removesuffix('.')}.", mend)


def _check(made: Compiled, root: Element) -> None:
    """NaN passes MuJoCo with a warning."""
    kinds = {
        "body": "body", "jnt": "joint", "dof": "joint", "site": "site", "eq": "equality", "tendon": "tendon",
        "actuator": "actuator",
    }  # fmt: skip
    for name, values in made.fields.items():
        kind = kinds.get(name.split("_")[0])
        if (kind is None and not name.startswith("opt.")) or values.dtype.kind != "f" or name == "jnt_range" or not values.size:
            continue
        rows = (np.abs(values.reshape(len(values) if kind else 1, -1)) <= LARGEST).all(axis=1)
        if not rows.all():
            row = int(np.argmin(rows))
            if name.startswith("dof_"):
                row = int(made.dof_jntid[row])
            elif name == "actuator_gear":
                row = int(np.searchsorted(made.actuator_outadr, row, "right")) - 1
            one = made.element(kind, row) if kind else next(root.all("option"), root)
            raise one.fault(f"has a number that is not finite, or beyond {LARGEST:g}.", "Give finite numbers in SI.")
