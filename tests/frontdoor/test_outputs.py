"""Names of outputs on a command line."""

from __future__ import annotations

import pytest

from roadlang.session.outputs import parse_outputs


@pytest.mark.parametrize(
    ("text", "outputs"),
    [
        ("json,svg", ["json", "svg"]),
        (" json , ,svg,", ["json", "svg"]),
        ("svg{size: 1px, labels: false},json", ["svg{size: 1px, labels: false}", "json"]),
        ('a{title: "x, {y"},b', ['a{title: "x, {y"}', "b"]),
        ("a{of: [1, (2, 3)]}", ["a{of: [1, (2, 3)]}"]),
        ("", []),
    ],
)
def test_commas_within_brackets_and_quotes_do_not_count(text: str, outputs: list[str]) -> None:
    assert parse_outputs(text) == outputs
