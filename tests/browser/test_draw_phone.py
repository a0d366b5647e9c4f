"""The tools of the drawing page on a phone: two rows, and each tool within two touches."""

from __future__ import annotations

import pytest

from hands import Fingers

pytestmark = pytest.mark.slow

SEEN = """[...document.querySelectorAll('.palette button')].filter((one) => one.offsetParent).map((one) => {
  const { left, top, right, bottom } = one.getBoundingClientRect();
  return { left, top, right, bottom, head: one.matches('.head'), words: one.getAttribute('aria-label') }; })"""


def seen(hand: Fingers) -> list[dict]:
    """The buttons in sight, each large enough for a finger and inside the window, in two rows."""
    found = hand.js(SEEN)
    assert len({round(one["top"]) for one in found}) <= 2
    for one in found:
        assert 0 <= one["left"] <= one["right"] <= 390
        assert min(one["right"] - one["left"], one["bottom"] - one["top"]) >= 44
    return found


@pytest.mark.parametrize(("dim", "scheme"), [(2, "light"), (3, "dark")])
def test_the_tools_take_two_rows_and_each_is_chosen_by_two_touches(show, served, dim, scheme):
    hand = Fingers(show(served.address, width=390, height=844, scheme=scheme, has_touch=True, is_mobile=True))
    if dim == 3:
        hand.button("Draw in space")
    chosen = []
    for group in [one["words"] for one in seen(hand) if one["head"]]:
        head = hand.page.locator(".palette").get_by_label(group, exact=True)
        before = hand.js("draw.tool")
        hand.touch(head)
        assert hand.js("draw.tool") == before  # to look into a group chooses nothing
        tools = [one["words"] for one in seen(hand) if not one["head"]]
        for words in tools:
            hand.touch(hand.page.locator(".palette").get_by_label(words, exact=True))
            chosen.append(hand.js("draw.tool"))
            assert head.inner_text().lower() == words.lower()
            assert hand.page.locator(".palette [aria-current=true]").count() == 1
    missing = {"positions", "path"} if dim == 3 else set()
    assert set(chosen) == set(hand.js("[...draw.rail.tools.keys()]")) - missing
    hand.press("t")  # a key opens the group of its tool
    assert hand.page.locator(".palette").get_by_label("Turn", exact=True).is_visible()
    assert hand.page.locator(".palette [aria-current=true]").inner_text().lower() == "turn"
    assert hand.page.locator(".palette").bounding_box()["height"] < 100
    assert hand.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    assert (hand.shown.requests, hand.shown.complaints) == ([], [])
