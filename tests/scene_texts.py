"""Scene texts to scenes, with the standard kinds and whatever else a test brings."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from roadlang import LoadedScenario, NoSceneError, testing
from roadlang.ir.scenario import Scenario
from roadlang.judging.acceptance import Acceptance
from roadlang.plugins.discovery import registry_of
from roadlang.plugins.registry import Registry
from roadlang.scenes.sampling import SamplingResult
from roadlang.world.index import index_scenario


@pytest.fixture(scope="session")
def registry() -> Registry:
    """The kinds in the wheel, whatever else is installed."""
    return registry_of({})


def scenario_of(text: str, registry: Registry, folder: Path = Path()) -> Scenario:
    """The checked scenario of a text; files that it names are in `folder`."""
    return LoadedScenario(text, folder / "scene.rl", {}, registry).scenario


@pytest.fixture
def sample(registry: Registry, tmp_path: Path) -> Callable[..., SamplingResult]:
    """Compile a text: `sample(text, n, seed=1)`; files it names are in `tmp_path`."""

    def run(text: str, n: int | None = 1, kinds: tuple[type, ...] = (), **more: Any) -> Any:
        known = registry
        if kinds:
            known = registry_of({"acme": testing.plugin_of(*kinds)})
        loaded = LoadedScenario(text, tmp_path / "scene.rl", more.pop("overrides", {}), known)
        try:
            return loaded.sample(n, **more).result
        except NoSceneError as error:
            return error.result.result

    return run


@pytest.fixture
def acceptance(registry: Registry) -> Callable[[str], Acceptance]:
    """The requirements of a text."""
    return lambda text: Acceptance(index_scenario(scenario_of(text, registry), registry))
