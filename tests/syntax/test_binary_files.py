"""From which number of control characters on a file is no text."""

from __future__ import annotations

import pytest

from roadlang.diagnostics.source import Source
from roadlang.syntax import parse
from roadlang.syntax.recovery.unprintable import binary


@pytest.mark.parametrize(
    ("text", "is_binary"),
    [
        (7 * "\x01", False),
        (8 * "\x01", True),
        (8 * "\x01" + 152 * "a", True),
        (8 * "\x01" + 153 * "a", False),
        (160 * "a", False),
        (100 * "\t\n\r", False),
    ],
)
def test_eight_and_one_in_twenty(text: str, is_binary: bool) -> None:
    assert (binary(Source("scene.rl", text)) is not None) == is_binary


def test_the_first_of_them_is_shown() -> None:
    found = binary(Source("scene.rl", "road" + 9 * "\x00"))
    assert found is not None
    assert found.span is not None
    assert (found.span.start, found.span.end) == (4, 5)


@pytest.mark.parametrize("text", ['<?xml version="1.0"?>\n<osm/>', "\n<OpenDRIVE></OpenDRIVE>\n"])
def test_a_map_in_xml_is_one_fault_that_says_how_maps_are_read(text: str) -> None:
    _, (found,) = parse(Source("maps/town.osm", text))
    assert (found.code, found.span and found.span.text) == ("RL001", "<")
    assert '`network town from "town.osm"`' in found.help[0]
