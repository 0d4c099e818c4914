"""Elements of the page are escaped text."""

from __future__ import annotations

from roadlang.report.elements import drawing, element, text


def test_attributes_are_named_as_in_html_and_left_out_where_they_are_none() -> None:
    made = element("td", "x", class_="a", aria_label='"<', title=None, hidden=True, colspan=0)
    assert made == '<td class="a" aria-label=\'"&lt;\' hidden colspan="0">x</td>'


def test_some_elements_have_no_end() -> None:
    assert element("br") == "<br>"
    assert element("td") == "<td></td>"


def test_a_drawing_has_its_parts_in_order() -> None:
    assert drawing("<g/>", "<a/>", width=3) == '<svg width="3"><g/><a/></svg>'


def test_text_is_escaped_and_has_no_control_characters() -> None:
    assert text("a < b & c\n\td") == "a &lt; b &amp; c\n\td"
    assert "\x1b" not in text("\x1b[31m")
