"""Random messages at both addresses of a studio, wrong hosts, origins and sizes: it answers each in a sentence and lives on.

    .venv/bin/python tests/campaigns/studio_attack.py --work DIR [--messages 1000] [--seed 1]

Messages of every kind that the studio knows, with arguments that fit, nearly fit or are absurd, cut off or not JSON at all,
from pages with sliders and from a drawing page. A fault: an answer that nobody foresaw or that is no JSON (NaN), a page that
was closed, an address that was let in, a file elsewhere, a studio that is not alive. Exit code 1 where there is one.
"""

from __future__ import annotations

import argparse
import json
import random
import sys
from collections import Counter
from contextlib import suppress
from pathlib import Path
from typing import Any

from websockets.exceptions import WebSocketException
from websockets.sync.client import ClientConnection, connect

import kinetruss as kt
import kinetruss.studio.messages  # each message enters MESSAGES
from kinetruss.studio.protocol import MESSAGES
from kinetruss.studio.session import LARGE, SMALL

sys.path.insert(0, str(Path(__file__).parents[1]))
from served import WAIT, Served, serve

PAGE = 60
"""Messages of one page."""

ABSURD = (
    None,
    True,
    "",
    "x",
    -1,
    0,
    1e16,
    10**400,
    float("nan"),
    [],
    {},
    [1, 2, 3, 4],
    {"a": {"a": 1}},
    "a" * 300,
    "\ud7ff\x00",
)
NUMBERS = (0, 1, -1, 0.3, 1.1, 9.81, 1e15, -1e15, 1e-300, float("inf"), "1", "50 mm", "2 kg")
FILES = (
    "../x.yaml",
    "/tmp/x.yaml",
    "..",
    ".x.yaml",
    "a/b.yaml",
    "CON.yaml",
    "x\x00.yaml",
    "model.yaml",
    "n.json",
    "u.yaml",
    "x.exe",
)


class Attack:
    """One studio under attack. faults : what was wrong. counts : kinds of answers."""

    def __init__(self, work: Path, seed: int) -> None:
        self.dice = random.Random(seed)
        self.folder = work / "in"
        self.folder.mkdir(parents=True, exist_ok=True)
        self.model = kt.read(kt.library.example_files()["driven_bay"][0])
        self.served: Served = serve(self.model, self.folder)
        self.faults: list[str] = []
        self.counts: Counter[str] = Counter()

    def line(self, page: str, **changes: Any) -> ClientConnection:
        options = {"origin": self.served.origin, "max_size": None, "open_timeout": WAIT, "compression": None, "proxy": None}
        return connect(changes.pop("uri", self.served.live.removesuffix("live") + page), **options | changes)

    def value(self, message: str, name: str, schema: dict[str, Any]) -> Any:
        """An argument of this name: often one that fits, also one of a message that nobody thought of here."""
        one, nodes, members = self.dice.choice, list(self.model.nodes), list(self.model.members)
        number, drives = one(NUMBERS), list(self.model.all_drives)
        if self.dice.random() < 0.05:
            return one(ABSURD)
        frame = {"time": one((0, 1, 2.5, -1)), "values": {one(drives): self.dice.uniform(0.8, 1.3)}}
        path = [one(("bars", "nodes", "fixed", "loads", "runs", "zz")), one([*members, *nodes]), one(("mass", "kind", "at"))]
        drive = one(drives)
        fitting = {
            "values": {one([*drives, drives[0], "zz"]): one((number, 1.1, "1.05 m"))}, "places": {one(nodes): [number] * 3},
            "path": path, "mass": number,
            "node": one(nodes), "nodes": self.dice.sample(nodes, one((1, 2, 3))), "members": [one(members)],
            "member": one(members), "ends": self.dice.sample(nodes, 2), "at": one(([number, 0.1, 0.2], number)),
            "by": [number, 0, 0.5], "force": [number, 0, -5.0],
            "value": one(([0, 0, number], number, one(members), None, {"node": one(nodes)})),
            "name": one([*FILES, *nodes, *members, "run1", None]), "drive": drive, "low": number, "high": number,
            "frames": [frame] * self.dice.randrange(3), "samples": one((2, 11, 1, 10**9)),
            "cell": one(("octahedron", "prism", "zz")), "count": one((1, 2, 201)), "table": one(("bars", "nodes", "zz")),
            "old": one([*members, *nodes]), "new": one(("q", "A", "a b")), "drag": one((None, 1, 2)),
            "text": one(("", "nodes: {A: [0, 0]}", "nodes: [", "- 1")), "number": one((0, 1, 2, -1)),
            "place": one((None, {"width": 1})), "changes": [[path, number]], "bar_from": one((None, *nodes)),
            "drives": self.dice.sample(drives, 1), "rate": one((None, "10 mm/s", "1 rpm", number)),
            "show": one(("N", "M", "deflection", "zz")), "sample": one((None, 0, 7, 10**6)),
            "arguments": one((None, {"zz": 1})),
            "begin.name": one(("Four-bar", "Stewart platform", "zz")), "case.name": one((None, *self.model.load_cases, "zz")),
            "run.name": one((None, *self.model.runs)), "take.run": one(("", *self.model.runs)),
            "ask.positions": one(((), [[0, 0, 0], [1, 0.2, 0.4], [2, 0.1, 0.9]])), "ask.path": (),
        }  # fmt: skip
        known = [given for key, given in fitting.items() if key in (f"{message}.{name}", name)]
        return known[-1] if known else self.of(schema)

    def of(self, schema: dict[str, Any]) -> Any:
        """What a schema takes."""
        if "anyOf" in schema:
            return self.of(self.dice.choice(schema["anyOf"]))
        if "enum" in schema:
            return self.dice.choice(schema["enum"])
        match schema.get("type"):
            case "boolean":
                return self.dice.random() < 0.5
            case "integer" | "number":
                return self.dice.choice((schema.get("minimum", 0), 1, 2))
            case "array":
                return [self.of(schema.get("items", {})) for _ in range(schema.get("minItems", 0) or self.dice.randrange(3))]
            case "object":
                return {}
            case _:
                return self.dice.choice((*self.model.nodes, "x"))

    def message(self) -> str | bytes:
        name = self.dice.choice([*MESSAGES, "what"])
        fields = MESSAGES[name][0].model_json_schema() if name in MESSAGES else {}
        given = {
            one: self.value(name, one, schema)
            for one, schema in fields.get("properties", {}).items()
            if one in fields.get("required", ()) or self.dice.random() < 0.5
        }
        for pair in (("values", "places"), ("name", "frames")):  # one of them is meant
            if name in ("move", "run") and set(pair) <= set(fields) and self.dice.random() < 0.8:
                one, other = self.dice.sample(pair, 2)
                given[one] = self.value(one)
                given.pop(other, None)
        text = json.dumps({"do": name} | given | ({"more": 1} if self.dice.random() < 0.05 else {}))
        kind = self.dice.random()
        if kind < 0.06:
            text = text[: self.dice.randrange(len(text))]
        elif kind < 0.08:
            text = self.dice.choice(("[" * 5000, '{"a":' * 3000, "\ud7ff\x00" + text))
        return text.encode() if self.dice.random() < 0.1 else text

    def page(self, page: str, count: int) -> None:
        """Messages of one page, each answered."""
        with self.line(page) as line:
            line.recv(WAIT)
            for sent in range(count):
                text = self.message() if sent % 10 else '{"do": "reset"}'  # names fit again
                try:
                    line.send(text)
                    answer = line.recv(WAIT)
                except WebSocketException as error:
                    self.faults.append(f"CLOSED by {text[:200]!r}: {error}")
                    return
                head = answer if isinstance(answer, str) else answer[4 : 4 + int.from_bytes(answer[:4], "little")].decode()
                found = json.loads(
                    head, parse_constant=lambda word, text=text: self.faults.append(f"{word} after {text[:200]!r}")
                )
                self.counts[found["kind"]] += 1
                if "could not be done:" in found.get("message", ""):
                    self.faults.append(f"UNFORESEEN {found['message']} after {text[:300]!r}")

    def doors(self) -> None:
        """What must not be let in, and messages that are too long."""
        for page in ("live", "draw/live"):
            for wrong in (
                {"origin": None},
                {"origin": "http://evil.example"},
                {"uri": f"ws://{self.served.host}/wrong/{page}"},
            ):
                with suppress(WebSocketException), self.line(page, **wrong) as line:
                    self.faults.append(f"ACCEPTED {wrong}: {line.recv(WAIT)[:40]!r}")
            with self.line(page) as line:
                line.recv(WAIT)
                with suppress(WebSocketException):
                    line.send("x" * (1 + (SMALL if page == "live" else LARGE)))
                    self.faults.append(f"ACCEPTED a long message: {line.recv(WAIT)[:40]!r}")

    def alive(self) -> None:
        with self.line("live") as line:
            line.recv(WAIT)
            line.send('{"do": "query"}')
            if json.loads(line.recv(WAIT))["kind"] not in ("numbers", "error"):
                self.faults.append("NOT ALIVE")


def campaign(work: Path, messages: int, seed: int) -> Attack:
    """The attack, and its end."""
    attack = Attack(work, seed)
    try:
        attack.doors()
        attack.alive()
        for begun in range(0, messages, PAGE):
            page = "draw/live" if begun // PAGE % 2 else "live"
            attack.page(page, min(PAGE, messages - begun))
            print(f"{begun + PAGE} messages, {len(attack.faults)} faults", file=sys.stderr)
            if page == "draw/live":  # from the beginning again, so that pages with sliders have a model
                with attack.line(page) as line:
                    line.recv(WAIT)
                    for text in ('{"do": "reset"}', '{"do": "query"}'):
                        line.send(text)
                        line.recv(WAIT)
        attack.alive()
        written = {path.suffix for path in attack.folder.iterdir() if path.is_file()}
        elsewhere = [path.name for path in work.iterdir() if path != attack.folder]
        if elsewhere or not written <= {".yaml", ".json", ".yml"}:
            attack.faults.append(f"FILES {elsewhere} {written}")
        if attack.served.stop():
            attack.faults.append("Ctrl-C did not end it well")
    finally:
        attack.served.process.kill()
        attack.served.process.communicate()
    return attack


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--messages", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    attack = campaign(given.work, given.messages, given.seed)
    print(dict(attack.counts))
    print("\n".join(attack.faults) or "no fault")
    return int(bool(attack.faults))


if __name__ == "__main__":
    sys.exit(main())
