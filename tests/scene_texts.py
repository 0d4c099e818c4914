"""Scene texts to scenes, with the standard kinds and whatever else a test brings."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import roadlang_godot.plugin
import roadlang_standard
from roadlang.ir.scenario import Scenario
from roadlang.judging.acceptance import Judge
from roadlang.plugins.discovery import registry_of
from roadlang.plugins.hookspecs import hookimpl
from roadlang.plugins.registry import Registry
from roadlang.scenes.sampling import SamplingResult, sample_scenes
from roadlang.semantics import check_text
from roadlang.world.index import index_scenario


def plugin_of(*kinds: type) -> ModuleType:
    """A plugin that brings `kinds`."""
    module = ModuleType("acme")

    @hookimpl
    def roadlang_kinds() -> list[type]:
        return list(kinds)

    module.roadlang_kinds = roadlang_kinds  # type: ignore[attr-defined]
    return module


SHIPPED = {"standard": roadlang_standard, "godot": roadlang_godot.plugin}


@pytest.fixture(scope="session")
def registry() -> Registry:
    return registry_of(SHIPPED)


def scenario_of(text: str, registry: Registry, folder: Path = Path()) -> Scenario:
    scenario, found = check_text(text, folder / "scene.rl", {}, registry)
    assert scenario is not None, [f"{d.code}: {d.message}" for d in found]
    return scenario


@pytest.fixture
def sample(registry: Registry, tmp_path: Path) -> Callable[..., SamplingResult]:
    """Compile a text: `sample(text, n, seed=1)`; files it names are in `tmp_path`."""

    def run(text: str, n: int | None = 1, kinds: tuple[type, ...] = (), **more: Any) -> Any:
        known = registry
        if kinds:
            known = registry_of({**SHIPPED, "acme": plugin_of(*kinds)})
        return sample_scenes(scenario_of(text, known, tmp_path), known, n, **more)

    return run


@pytest.fixture
def judge(registry: Registry) -> Callable[[str], Judge]:
    """The judge of a text's requirements."""
    return lambda text: Judge(index_scenario(scenario_of(text, registry), registry))
