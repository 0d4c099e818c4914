"""The exit code of several runs is that of the severest."""

from __future__ import annotations

import pytest

from roadlang.cli.exit_codes import exit_code_of, severest
from roadlang.diagnostics import Diagnostic


@pytest.mark.parametrize(
    ("codes", "expected"),
    [
        ([], 0),
        ([0, 4], 4),
        ([4, 1], 1),
        ([4, 3], 3),
        ([1, 3], 3),
        ([3, 2], 2),
        ([2, 5], 5),
        ([5, 70], 70),
    ],
)
def test_the_severest_counts_in_any_order(codes: list[int], expected: int) -> None:
    assert severest(codes) == severest(reversed(codes)) == expected


def test_a_code_of_a_plugin_has_no_page_and_means_an_error_of_the_scenario() -> None:
    assert exit_code_of([Diagnostic("KIT02", "error", "")]) == 1
    assert exit_code_of([Diagnostic("KIT02", "warning", "")]) == 0
