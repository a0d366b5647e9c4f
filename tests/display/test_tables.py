"""Tables as text and HTML."""

from kinetruss.display import Markup, Table, element


def test_columns_of_numbers_stand_to_the_right_and_wide_letters_take_two_places():
    text = Table(("part", "force", "at"), [("梁1", "-12.5 N", "-"), ("M19", "∞", "0.5 s")], "Forces", "a note").text
    assert text.splitlines() == ["Forces", "part    force     at", "梁1   -12.5 N      -", "M19         ∞  0.5 s", "a note"]


def test_html_escapes_cells_but_not_markup():
    html = Table(("name", "value"), [("<b>", element("i", "1 < 2")), ("c", Markup("2 N"))], "A & B").html()
    assert "<td" in html and "&lt;b&gt;" in html and "<i>1 &lt; 2</i>" in html and "<b>" not in html
    assert "A &amp; B" in html


def test_a_table_without_a_head_is_names_and_what_they_are():
    table = Table(("", ""), [("mass", "2 kg"), ("a long name", "x")])
    assert table.text.splitlines() == ["mass         2 kg", "a long name  x"]
    assert 'scope="row"' in table.html()


def test_a_table_without_rows_is_its_head():
    assert Table(("a", "b"), []).text == "a  b"
