"""Tables as text and HTML."""

from kinetruss.display import Markup, Table, element
from kinetruss.display.tables import bar, drawn, measured, mixed, seconds, together, words


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


FORCES = [
    {"member": "M1", "force": 1250.0, "rest": 0.0, "load_case": "all", "axes": {"x": 3.0}, "unit": "N"},
    {"member": "M2", "force": -3.4, "rest": None, "load_case": "all", "axes": {}, "unit": "N m"},
]


def test_a_unit_stands_in_the_cells_of_a_text_and_in_the_head_of_a_page():
    table = Table([words("member"), measured("force", unit="N")], FORCES)
    assert table.text.splitlines() == ["member      force", "M1       1.250 kN", "M2      -0.003 kN"]
    page = table.html()
    assert ">force (kN)<" in page.replace("\u00a0", " ")
    assert ">1.250<" in page and "1.250 kN" not in page.replace("\u00a0", " ")


def test_columns_of_one_quantity_share_their_unit_and_decimals_and_the_unit_of_other_rows():
    alone, grouped = (
        [measured("force", unit="N"), measured("rest", unit="N")],
        together("N", {"force": "force", "rest": "rest"}),
    )
    assert Table(alone, FORCES).text.splitlines()[1].split() == ["1.250", "kN", "0", "N"]
    assert Table(grouped, FORCES).text.splitlines()[1].split() == ["1.250", "kN", "0", "kN"]
    small = Table([measured("force", unit="N")], FORCES[1:], among=FORCES)
    assert small.text.splitlines()[1].split() == ["-0.0034", "kN"]


def test_rows_with_units_of_their_own_share_those_of_equal_rows():
    rows = [{"a": 7.63e6, "b": 160e6, "unit": "Pa"}, {"a": 0.1567, "b": 1.0, "unit": ""}]
    table = Table([mixed("demand", "a", group="d"), mixed("allowed", "b", group="d")], rows)
    assert [line.split() for line in table.text.splitlines()[1:]] == [["7.63", "MPa", "160", "MPa"], ["0.1567", "1"]]
    assert "7.63 MPa" in table.html()
    assert ">demand (MPa)<" in Table([mixed("demand", "a")], rows[:1]).html().replace("\u00a0", " ")


def test_columns_that_say_nothing_are_left_out_and_empty_tables_too():
    columns = [words("member"), words("load case", "load_case", idle="all"), seconds("time", lambda row: None)]
    assert Table(columns, FORCES).text.splitlines()[0] == "member"
    assert Table([*columns, seconds("time", ("axes", "x"))], FORCES).text.splitlines()[1:] == ["M1       3 s", "M2         -"]
    one = [FORCES[0], FORCES[1] | {"load_case": "wind"}]
    assert Table(columns, one).text.splitlines() == ["member  load case", "M1      all", "M2      wind"]
    assert not Table(columns, [])


def test_drawings_are_in_pages_and_what_is_left_out_is_said():
    columns = [words("member"), drawn(lambda row: bar(0.5)), words("why", "unit", only="texts")]
    table = Table(columns, FORCES, most=(1, 2), rank=lambda row: -row["force"], rest=lambda left: f", {left[0]['member']}")
    assert table.text.splitlines() == ["member  why", "M2      N m", "and 1 more, M1"]
    assert "<svg" in table.html() and "N m" not in table.html()
    assert "1 more are in the data of this page." in Table(columns, FORCES, most=(1, 1)).html()
