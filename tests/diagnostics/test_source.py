"""Places in a source are lines and columns counted from 1."""

from hypothesis import given
from hypothesis import strategies as st

from roadlang.diagnostics import Source


def test_a_span_knows_where_it_starts_and_ends() -> None:
    source = Source("scene.rl", "road main {\n  width: 8m\n}\n")
    span = source.span(14, 19)
    assert span.text == "width"
    assert (span.line, span.column, span.end_line, span.end_column) == (2, 3, 2, 8)
    assert str(span) == "scene.rl:2:3"


def test_a_span_over_several_lines() -> None:
    source = Source("scene.rl", "ab\ncd\nef")
    span = source.span(1, 7)
    assert (span.line, span.column, span.end_line, span.end_column) == (1, 2, 3, 2)


def test_windows_line_ends_are_not_part_of_the_line() -> None:
    assert Source("scene.rl", "ab\r\ncd").line(1) == "ab"


@given(st.text(alphabet="ab\n", max_size=40), st.data())
def test_positions_are_those_of_splitting_at_newlines(text: str, data: st.DataObject) -> None:
    offset = data.draw(st.integers(0, len(text)))
    before = text[:offset].split("\n")
    assert Source("x", text).position(offset) == (len(before), len(before[-1]) + 1)


@given(st.text(max_size=40))
def test_every_line_can_be_shown(text: str) -> None:
    source = Source("x", text)
    for number in range(1, source.line_count + 1):
        assert "\n" not in source.line(number)


def test_a_part_of_a_source_has_the_places_of_the_whole() -> None:
    source = Source("a.yaml", "reach: 12m\nturns: \t3 # three\n")
    start = source.text.index("3")
    part = source.part(start, start + 1)
    assert part.text.strip() == "3"
    span = part.span(start, start + 1)
    assert (span.line, span.column, span.text) == (2, 9, "3")
    assert part.line(2) == "turns: \t3 # three"
