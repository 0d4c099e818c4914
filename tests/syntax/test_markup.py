"""Files of other tools in place of a scene file."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.plugins.discovery import load_registry
from roadlang.semantics import check_text


@pytest.mark.parametrize(
    ("text", "help"),
    [
        ('<?xml version="1.0"?>\n<OpenDRIVE/>\n', '`network town from "a.xodr"`'),
        ('<?xml version="1.0"?>\n<OpenSCENARIO/>\n', "`emit openscenario`"),
    ],
)
def test_markup_is_named_with_what_to_do(text: str, help: str) -> None:
    _, found = check_text(text, Path("a.xodr"), {}, load_registry())
    assert [diagnostic.code for diagnostic in found] == ["RL001"]
    assert help in found[0].help[0]
