"""Random towns come to what they did: every number and word of them.

A difference that is meant is stored with `python -m tests.golden`; read its diff first.
"""

from __future__ import annotations

import pytest

from tests.golden.cases import CASES, Case
from tests.golden.comparing import check


@pytest.mark.parametrize(
    "case", [c for c in CASES.values() if c.room == "towns"], ids=lambda c: c.name
)
def test_nothing_changed(case: Case) -> None:
    check(case.name, case.lines(), case.absolute)
