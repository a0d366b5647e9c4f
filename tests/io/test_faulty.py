"""Every faulty model file is refused, at the right place, in words that say what is wrong and how to mend it."""

from collections import defaultdict
from pathlib import Path

import pytest

import kinetruss as kt

FAULTY = Path(__file__).parents[1] / "data" / "faulty"

# file, line:column (after the name of the table where the fault is in a CSV file), start of the message
EXPECTED = """
    alias_bomb.yaml                    8:4                      holds more than 2,000,000 values (aliases followed).
    angle_for_a_length.yaml            7:44                     is given as an angle, but 'turn' is a length.
    bar_and_active_member.yaml         6:3                      'bc' is also the name of a bar.
    clock_as_quantity.yaml             7:58                     '12:30' is not a time: ':30' is not a unit known here.
    coincident_nodes.yaml              5:3                      stands where node 'B' stands, at (1.0, 0.0).
    colon_in_text.yaml                 2:14                     is not YAML: mapping values are not allowed in this context.
    comments_only.yaml                 1:1                      is empty.
    control_character.yaml             2:14                     is not text: there is a control character here.
    decimal_comma.yaml                 6:9                      '1,25 m' is not a length: a comma in the number.
    decimal_comma_in_list.yaml         4:3                      has 3 coordinates, other nodes have 2.
    drive_of_fixed_axis.yaml           6:3                      moves A.x, which is fixed.
    duplicate_key.json                 6:5                      'ab' is given twice; first at line 5.
    duplicate_member.yaml              6:3                      'ab' is given twice; first at line 4.
    duplicate_node.yaml                5:3                      'A' is given twice; first at line 3.
    elastic_without_section.yaml       4:3                      is elastic but has no section.
    empty.json                         1:1                      is empty.
    empty.yaml                         1:1                      is empty.
    empty_table.yaml                   3:1                      is empty; expected a table of names.
    fixed_axes.yaml                    3:12                     fixes z in a planar model.
    fixed_axes.yaml                    3:19                     'xw' is not a set of axes.
    fraction_as_count.yaml             7:86                     '20.5' is not a whole number.
    frequency_as_angular_rate.yaml     6:90                     '50 Hz' is not an angular rate (rad/s).
    gravity_in_space.yaml              5:1                      has 3 components, the model has 2 axes.
    infinity.yaml                      5:14                     '-inf' is not a finite acceleration.
    inner_over_outer.yaml              5:1                      inner diameter 0.019 m must be at least 0 and less than
    limits_swapped.yaml                6:3                      limits (1.6, 1.2) must be [least, largest].
    list_at_top.yaml                   1:1                      is not a table of names.
    many_faults.yaml                   5:10                     '100 mmm' is not a length: 'mmm' is not a unit known here.
    many_faults.yaml                   8:12                     no node called 'E'.
    many_faults.yaml                   12:12                    joins node 'D' to itself.
    many_faults.yaml                   12:32                    '5 lbf' is not a mass (kg).
    many_faults.yaml                   12:39                    'colour' is not known here.
    many_faults.yaml                   13:21                    no node called 'F'.
    many_faults.yaml                   13:25                    inner diameter 0.02 m must be at least 0 and less than the outer
    many_faults.yaml                   14:11                    no material called 'steel_s253'.
    many_faults.yaml                   16:29                    no member called 'krank'.
    many_faults.yaml                   18:59                    is given as a rate of length, but 'motor' is an angle.
    many_faults.yaml                   18:78                    -1 must be greater than 0.
    many_faults.yaml                   19:23                    no trajectory called 'slow'.
    model.toml                         1:1                      is TOML, which is not read.
    missing_field.yaml                 6:3                      'inner' is missing.
    missing_unit.yaml                  6:16                     '2.5 /rev' is not a lead: '/' stands where a unit is due.
    motion_columns.yaml                history_columns.csv:1:28 column 'Q.x' is not known here.
    motion_not_there.yaml              6:18                     there is no file '../tables/not_there.csv'.
    name_with_space.yaml               2:9                      'left end' is no name: it is empty, or has a space
    nan.json                           3:32                     is not JSON: 'NaN' is not a value.
    nan.yaml                           4:7                      '.nan' is not a finite length.
    negative_area.yaml                 5:32                     -0.0003 must be greater than 0.
    negative_length.yaml               4:30                     -1 must be greater than 0.
    negative_mass.yaml                 4:28                     -2 must not be negative.
    nested_too_deep.yaml               2:57                     is nested more than 50 levels deep.
    no_nodes.yaml                      1:1                      'nodes' is missing.
    not_utf8.yaml                      2:18                     is not UTF-8 text: byte 30 (0xfc) is not allowed in it.
    number_as_name.json                4:23                     is 2; expected text.
    one_end.yaml                       4:3                      has 1 entry, too few.
    over_library_model.yaml            4:46                     no drive or pose coordinate called 'bay.bta'.
    overflow.yaml                      5:14                     '-1e999' is not a finite acceleration.
    pound_as_force.yaml                6:29                     '-20 lb' is not a force (N).
    pound_force_as_mass.yaml           4:29                     '20 lbf' is not a mass (kg).
    run_without_trajectory.yaml        6:3                      has neither trajectory nor motion.
    self_joined_bar.yaml               6:3                      joins node 'D' to itself.
    tab_indent.yaml                    3:1                      is not YAML: found character that cannot start any token (while
    table_back_in_time.yaml            back_in_time.csv:5:1     time does not increase: 0.15 after 0.2 in line 4.
    table_decimal_commas.yaml          decimal_commas.csv:3:1   has 4 cells; the header has 2.
    table_decimal_commas.yaml          decimal_commas.csv:4:1   has 4 cells; the header has 2.
    table_gap.yaml                     gap.csv:7:1              gap of 2 s before this row; the median step is 0.1 s.
    table_not_there.yaml               7:41                     ../tables/not_there.csv cannot be used: there is no such file.
    table_of_forces.yaml               forces_without_y.csv:1:1 column 'y' is missing.
    table_semicolons.yaml              semicolons.csv:1:1       has one column only.
    table_too_short.yaml               too_short.csv:5:1        has 3 rows.
    table_unknown_column.yaml          7:8                      no drive or pose coordinate called 'trun'.
    table_words.yaml                   words.csv:3:5            'n/a' is not a number, in column 'turn'.
    table_words.yaml                   words.csv:4:5            the cell is empty, in column 'turn'.
    table_words.yaml                   words.csv:5:5            'nan' is not a number, in column 'turn'.
    table_wrong_unit.yaml              wrong_unit.csv:1:7       column 'turn' has the unit [kg], which is not a unit of
    tagged.yaml                        3:8                      has the tag 'tag:yaml.org,2002:python/object/apply:os.getcwd'.
    times_standing_still.yaml          6:3                      time goes back or stands still: entry 3 is 1 s after 1 s.
    two_documents.yaml                 5:1                      holds another document.
    two_drives_of_one_bar.yaml         7:3                      drives what 'first' drives already.
    unclosed_bracket.yaml              4:5                      is not YAML: did not find expected ',' or ']' (while parsing a
    uneven_indent.yaml                 4:2                      is not YAML: did not find expected key (while parsing a block
    unknown_coordinate.yaml            7:44                     no drive or pose coordinate called 'trun'.
    unknown_gauge_member.yaml          9:16                     no member called 'road'.
    unknown_gauge_member.yaml          10:26                    no drive or pose coordinate called 'motor'.
    unknown_key.yaml                   5:1                      'materiel' is not known here.
    unknown_key.yaml                   6:10                     'yeilding' is not known here.
    unknown_kind.yaml                  5:1                      kind 'pipe' is not known.
    unknown_kind.yaml                  7:3                      has no kind.
    unknown_library_model.yaml         2:17                     no library model called 'vgt.double_octahedron'.
    unknown_library_parameter.yaml     4:3                      'bay' is not known here.
    unknown_library_parameter.yaml     5:13                     '35 kg' is not a length (m).
    unknown_load_case.yaml             8:90                     no load case called 'ful'.
    unknown_load_node.yaml             6:15                     no node called 'c'.
    unknown_material.yaml              5:11                     no material called 'steel_s325'.
    unknown_member.yaml                6:29                     no member called 'rocker'.
    unknown_node.yaml                  3:12                     no node called 'D'.
    unknown_node.yaml                  6:11                     no node called 'C'.
    unknown_section.yaml               7:10                     no section called 'tube_16x19'.
    unknown_trajectory.yaml            9:20                     no trajectory called 'extent'.
    unknown_unit.yaml                  4:7                      '1 furlong' is not a length: 'furlong' is not a unit known here.
    unknown_unit.yaml                  5:10                     '3 inches' is not a length: 'inches' is not a unit known here.
    unknown_version.yaml               1:1                      format version '2' is not known here.
    utf16.yaml                         1:1                      is not UTF-8 text: byte 0 (0xff) is not allowed in it. It looks
    word_as_quantity.yaml              4:33                     'no' is not a mass: no number in front.
    wrong_unit.yaml                    4:27                     '20 mm' is not a mass (kg).
    yes_as_flag.yaml                   5:38                     'yes' is not true or false.
    zero_length_bar.yaml               8:3                      has zero length: 'B' and 'C' stand at one place.
"""


def expectations():
    """File -> its faults, in the order they are told."""
    found = defaultdict(list)
    for line in EXPECTED.strip().splitlines():
        file, place, message = line.split(maxsplit=2)
        found[file].append((place, message))
    return found


def place(fault):
    """As in the table of expectations."""
    file = f"{Path(fault.file).name}:" if fault.file else ""
    return f"{file}{fault.line}:{fault.column}"


def test_every_file_is_expected():
    assert {path.name for path in FAULTY.iterdir()} == expectations().keys()


@pytest.mark.parametrize(("file", "expected"), expectations().items())
def test_all_faults_at_once(file, expected):
    faults = kt.check(FAULTY / file)
    told = [(place(fault), fault.message[: len(message)]) for fault, (_, message) in zip(faults, expected, strict=True)]
    assert told == expected
    for fault in faults:
        assert fault.mend
        assert not fault.message.endswith(("..", " "))


@pytest.mark.parametrize("file", expectations())
def test_reading_raises_them(file):
    if file == "motion_columns.yaml":  # a motion is read when it is followed
        return
    with pytest.raises(kt.ModelError) as caught:
        kt.read(FAULTY / file)
    lines = str(caught.value).splitlines()
    assert len(lines) == len(expectations()[file])
    for line in lines:
        assert line.startswith((f"{FAULTY / file}:", str(FAULTY / ".." / "tables")))
