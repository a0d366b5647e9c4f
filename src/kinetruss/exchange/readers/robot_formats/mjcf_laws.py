"""Couplings of joints and straight tendons of MJCF."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace

from kinetruss.exchange.readers.naming import Names
from kinetruss.exchange.readers.robot_formats.mjcf_mass import Defaults
from kinetruss.exchange.readers.robot_formats.xml import Element
from kinetruss.exchange.robots import JointCoupling, LeftOut, Pivot, Span
from kinetruss.model import nearest

__all__ = ["Laws"]


class Laws:
    """Reads what acts between joints and between sites; adds to `left` what a model cannot have."""

    def __init__(self, defaults: Defaults, names: Names, left: list[LeftOut]) -> None:
        self._defaults, self._names, self._left = defaults, names, left

    def couplings(self, elements: Iterable[Element], pivots: Mapping[str, Pivot]) -> list[JointCoupling]:
        """Of <equality><joint>: y - y0 = c0 + c1 (x - x0), with y0, x0 the values where the file draws the robot."""
        return [made for one in elements if (made := self._coupling(one, pivots)) is not None]

    def _coupling(self, element: Element, pivots: Mapping[str, Pivot]) -> JointCoupling | None:
        given = self._defaults.of(element, "main", "equality")
        element = Element(element.file, element.tag, element.line, given)
        if given.get("active", "true") == "false":
            self._lost("joint equality", element, "is not active")
            return None
        found = []
        for word in ("joint1", "joint2"):
            if word in given or word == "joint1":
                if (name := element.text(word)) not in pivots:
                    raise element.fault(f"{word}: no joint called {name!r}.", nearest(name, pivots))
                found.append(pivots[name])
        if any(one.kind not in ("revolute", "prismatic") for one in found):
            raise element.fault("couples a joint that has no single value.", "Name hinges and slides.")
        if len(found) == 2 and found[0] is found[1]:
            raise element.fault("couples a joint with itself.", "Name two joints, or joint1 alone to hold it.")
        series = [float(c) for c in element.numbers("polycoef", (1, 2, 3, 4, 5), (0, 1, 0, 0, 0))]
        if len(found) == 2 and any(series[2:]):
            self._lost("joint equality", element, "only linear couplings (c0, c1) are carried")
            return None
        slope = series[1] if len(series) > 1 and len(found) == 2 else 0.0
        factors, value = {found[0].name: 1.0}, found[0].home + series[0]
        if slope:
            factors[found[1].name] = -slope
            value -= slope * found[1].home
        name = self._names.of(given.get("name", f"coupling_{element.line}"), element.where, "joint")
        return JointCoupling(name=name, factors=factors, value=value, where=element.where)

    def spans(self, elements: Iterable[Element], points: Mapping[str, str]) -> dict[str, Span]:
        """Tendons straight between two sites, by their names in the file. points : site -> name of its node."""
        found = {}
        for one in elements:
            given = self._defaults.of(one, "main", "tendon")
            if (span := self._span(Element(one.file, one.tag, one.line, given, one.children), points)) is not None:
                found[given.get("name", span.name)] = span
        return found

    def _span(self, element: Element, points: Mapping[str, str]) -> Span | None:
        ends = [one for one in element.children if one.tag == "site"]
        if element.tag != "spatial" or len(ends) != 2 or len(element.children) != 2:
            self._lost(element.tag, element, "only tendons straight between two sites are carried")
            return None
        if any(len(element.text(word, "").split()) > 1 for word in ("stiffness", "damping", "springlength", "frictionloss")):
            self._lost(element.tag, element, "its law of several numbers is not carried")
            return None
        for one in ends:
            if (site := one.text("site")) not in points:
                raise one.fault(f"no site called {site!r}.", nearest(site, points))
        for word in ("range", "armature"):
            if word in element.attributes:
                self._lost(word, element, "is not carried of tendons")
        first, second = (points[one.text("site")] for one in ends)
        stiffness, damping, friction = (element.number(word, 0.0) for word in ("stiffness", "damping", "frictionloss"))
        rest = element.number("springlength", -1.0)
        return Span(
            name=self._names.of(element.attributes.get("name", f"tendon_{element.line}"), element.where, "joint"),
            points=(first, second),
            spring=(stiffness, rest if rest >= 0 else None, damping, friction) if stiffness or damping or friction else None,
            where=element.where,
        )

    def acting(self, spans: Mapping[str, Span], drives: Collection[str]) -> list[Span]:
        """The tendons that have a motor or a law of their own."""
        for one in spans.values():
            if one.name not in drives and one.spring is None:
                self._left.append(LeftOut("spatial", one.where, "has no actuator, stiffness, damping or friction, so no force"))
        return [replace(one, driven=one.name in drives) for one in spans.values() if one.name in drives or one.spring]

    def _lost(self, what: str, element: Element, why: str) -> None:
        self._left.append(LeftOut(what, element.where, why))
