"""What may stand in the block of an `include`: each param once, and no passes."""

from __future__ import annotations

from pathlib import Path

import pytest

from roadlang.plugins.discovery import registry_of
from roadlang.semantics import check_text

STREET = """param reach = 80m
param wide = 6m
road street { draw with waypoints { points: [(0m, 0m), (reach, 0m)] }, width: wide }
"""


def said(block: str, folder: Path, alias: str = "") -> list[tuple[int, str, str]]:
    (folder / "street.rl").write_text(STREET, encoding="utf-8")
    text = f'include "street.rl"{alias} {{ {block} }}\n'
    _, found = check_text(text, folder / "scene.rl", {}, registry_of({}))
    return [(one.span.column if one.span else 0, one.code, one.message) for one in found]


@pytest.mark.parametrize("alias", ["", " as one"])
def test_each_param_is_set_once_and_nothing_else_stands_there(tmp_path: Path, alias: str) -> None:
    start = len('include "street.rl" { ') + len(alias) + 1
    assert said("reach: 90m, wide: 5m", tmp_path, alias) == []
    ((column, code, message),) = said("reach: 90m, reach: 70m", tmp_path, alias)
    assert (column, code) == (start + 12, "RL222")
    assert "`reach`" in message
    found = said("reach: 90m, draw with segments { pieces: [straight(9m)] }", tmp_path, alias)
    (column, _, message) = found[0]
    assert column == start + 12
    assert "`include`" in message
    assert "`draw" in message
