"""What a page says, as text and as HTML from one list of entries."""

import re

import kinetruss as kt
from kinetruss import report
from kinetruss.display import Markup, Table
from kinetruss.report.entries import Figure, Numbers, as_text

ENTRIES = [
    "one < two\nlines",
    Table(("a", "b"), [("x", "1")], "First"),
    Figure(panels=[Markup("<svg></svg>")], caption="drawn"),
    Markup("<ul></ul>"),
    Table(("a",), [], "empty"),
    Table(("a", "b"), [("y", "2")], "Second"),
]


def test_a_text_has_sentences_and_tables():
    assert as_text(ENTRIES) == "one < two\nlines\n\nFirst\na  b\nx  1\n\nSecond\na  b\ny  2"


def test_a_page_has_all_numbered_and_links_to_them():
    numbers = Numbers()
    inside, links = numbers.html(ENTRIES)
    assert re.findall(r'id="([a-z]+-\d)"', inside) == ["table-1", "picture-1", "table-2"]
    assert "one &lt; two" in inside
    assert re.sub(r"<[^>]*>", "", links) == "Tables 1 and 2; Figure 1"
    assert re.sub(r"<[^>]*>", "", numbers.html(ENTRIES[1:2])[1]) == "Table 3"


def test_pages_of_the_package_have_html_too():
    model = kt.read(kt.library.example_files()["four_bar"][0])
    found = kt.run(model)
    forces = found.forces["all"]
    body = kt.dynamics.free_body(model, found.motion, forces, member="coupler", time=0.25)
    for page in (report.summary(found), report.joints(found), report.explain(body), report.compare([found], "drive_force")):
        html = page.html
        assert html.startswith("<!doctype html>")
        cells = re.sub(r"<[^>]*>", " ", html)
        for word in re.findall(r"[a-z]{5,}", page.text):
            assert word in cells
