"""Outputs of roads have nothing to write of a scenario without any."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from roadlang_formats.road_backend import RoadBackend


@pytest.mark.parametrize(
    ("roads", "networks", "reasons"),
    [
        (("main",), (), []),
        ((), ("town",), []),
        (("main",), ("town",), []),
        ((), (), ["it has no road"]),
    ],
)
def test_roads_may_be_those_of_a_network(
    roads: tuple[str, ...], networks: tuple[str, ...], reasons: list[str]
) -> None:
    contents: Any = SimpleNamespace(roads=roads, networks=networks)
    backend: Any = None
    assert list(RoadBackend.unsupported(backend, contents)) == reasons
