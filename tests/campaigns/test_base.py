"""The net under the engines, for some seconds: the tree agrees with itself, and what is planted is found."""

import dataclasses
import os
import shutil
from collections import Counter

import numpy as np
import pytest

from campaigns.base import compare

pytestmark = pytest.mark.slow

SEED, COUNT, RUNS = 4, 17, 1


@pytest.fixture(scope="module")
def answers(tmp_path_factory):
    """Answers of the tree, with their scales."""
    folder = tmp_path_factory.mktemp("net") / "old"
    options = ["--seed", str(SEED), "--count", str(COUNT), "--runs", str(RUNS), "--conditions"]
    assert compare.asked(compare.TREE / compare.PROBE, compare.TREE / "src", folder, options).wait() == 0
    return folder


def against(answers, source):
    """What comes out where a source is compared with the tree."""
    probe = compare.TREE / compare.PROBE
    old, new = (probe, compare.TREE / "src", answers), (probe, source, answers.parent)
    return compare.side_by_side(old, new, SEED, COUNT, RUNS)


def test_the_tree_agrees_with_itself(answers):
    found = against(answers, compare.TREE / "src")
    assert found.differences == []
    assert found.counts.total() > 30 * COUNT
    assert {"forward mass", "forward rows", "inverse left 1 1", "still stiffness", "mobility counts"} <= found.counts.keys()
    # every engine answers: what is refused is refused for a reason of the case
    assert max(found.refused[name] for name in found.refused if name.split()[0] in ("forward", "still", "inverse")) < COUNT / 2


def changed(folder, file, more):
    """A copy of the source with some lines more in one file; it borrows the compiled kernels."""
    source = folder / "src"
    shutil.copytree(compare.TREE / "src", source, ignore=shutil.ignore_patterns("__pycache__"))
    kernels = "kinetruss/kernels/__pycache__"
    (source / kernels).symlink_to(compare.TREE / "src" / kernels)
    with (source / "kinetruss" / file).open("a") as out:
        out.write(more)
    return source


@pytest.mark.skipif(not hasattr(os, "symlink"), reason="the test needs symbolic links, which this system lacks")
def test_a_changed_source_is_found(answers, tmp_path):
    """The area of tubes grows by 1e-9: masses and stiffnesses."""
    more = "\n_area = Tube.area.fget\nTube.area = property(lambda one: (1 + 1e-9) * _area(one))\n"
    source = changed(tmp_path, "model/sections.py", more)
    found = Counter(one.quantity for one in against(answers, source).differences)
    assert {"forward mass", "still mass", "inverse left 1 1"} <= found.keys()
    assert "forward rows" not in found


@pytest.mark.skipif(not hasattr(os, "symlink"), reason="the test needs symbolic links, which this system lacks")
def test_a_changed_message_is_found(tmp_path, monkeypatch):
    """Every fault ends in another word."""
    monkeypatch.setattr(compare, "hash_of", lambda _: "")
    monkeypatch.setattr(compare, "tree_of", lambda *_: compare.TREE / "src")
    more = "\n_words = Fault.__str__\nFault.__str__ = lambda one: _words(one) + ' Please.'\n"
    for source, differ in ((compare.TREE / "src", False), (changed(tmp_path, "errors.py", more), True)):
        found = compare.Found()
        compare.read_alike(tmp_path, source, 0, 12, SEED, found)
        assert bool(found.differences) is differ
    assert "Please." in found.differences[0].new


def test_a_change_of_any_quantity_is_found(answers):
    """The largest entry of every quantity of every case, by 1e-9 of its scale."""
    checked = Counter()
    for file in answers.glob("*.answers"):
        for answer in compare.read(file):
            for name, part in answer.parts.items():
                if isinstance(part, compare.Refused) or not part.value.size or part.allowed >= 1e-9:
                    continue
                scale = np.broadcast_to(np.asarray(part.scale, float), part.value.shape)
                at = np.unravel_index(int(np.abs(part.value).argmax()), part.value.shape)
                changed = part.value.astype(float)
                changed[at] += 1e-9 * scale[at]
                if changed[at] == part.value[at]:
                    continue  # beyond the last digit
                place, *_, entries = compare.compared(part, dataclasses.replace(part, value=changed))
                assert entries == 1
                assert place.split(" / ")[0] in (part.places[0] if part.places else ("value",))
                checked[name] += 1
    assert len(checked) > 40


def part(*values, names="AB", **more):
    return compare.Part(np.array(values), (tuple(names),), **({"scale": 1.0} | more))


def test_the_order_of_names_does_not_matter():
    assert compare.compared(part(1.0, 2.0), part(2.0, 1.0, names="BA")) is None
    assert compare.compared(part(1.0, 2.0), part(2.0, 1.0))[4] == 2


@pytest.mark.parametrize("new", [part(1.0, 2.0, names="AC"), part(1.0, np.nan), compare.Refused("InputError"), None])
def test_what_is_missing_or_no_number_differs(new):
    assert compare.compared(part(1.0, 2.0), new) is not None


def taken(new, rules=()):
    found = compare.Found()
    old, new = (compare.Answer(7, "planar web", "same", (), {"forward mass": one}) for one in (part(1.0, 2.0), new))
    found.take(old, new, list(rules))
    return found


def test_the_last_bit_is_a_difference_and_another_order_of_sums_is_meant_only_where_an_entry_says_so():
    new = part(1.0, np.nextafter(2.0, 3.0))
    assert taken(new).differences
    rule = {"quantity": "*", "reason": "another order of sums", "bound": "allowed"}
    assert taken(new, [rule]).intended == {"another order of sums": 1}
    assert taken(part(1.0, 2.0 + 1e-12), [rule]).differences


def test_a_difference_says_where_it_is():
    (one,) = taken(part(1.0, 2.5)).differences
    assert str(one) == "7 planar web: forward mass at B: 2 is now 2.5 (5.0e-01)"


def test_intended_differences_are_counted_within_their_bound():
    rule = {"quantity": "forward *", "kind": "planar *", "reason": "a better formula", "bound": 1e-6}
    assert taken(part(1.0, 2.0 + 5e-7), [rule]).intended == {"a better formula": 1}
    assert taken(part(1.0, 2.5), [rule]).differences


def test_without_the_history_nothing_counts_as_checked(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr(compare, "BASE", "0" * 40)
    monkeypatch.setattr(compare.sys, "argv", ["compare.py", "--work", str(tmp_path)])
    assert compare.main() == compare.NOT_CHECKED
    assert "NOT CHECKED" in capsys.readouterr().out
