"""Handles, and the texts that dragging them makes, are what they were.

A difference that is meant is stored with `python -m tests.golden`; read its diff first.
"""

from __future__ import annotations

import pytest

from tests.golden.cases import CASES, Case
from tests.golden.comparing import check


@pytest.mark.parametrize(
    "case", [c for c in CASES.values() if c.room == "handles"], ids=lambda c: c.name
)
def test_nothing_changed(case: Case) -> None:
    check(case.name, case.lines(), case.absolute)
