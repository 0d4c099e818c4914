"""The samples mean something: nothing is wrong with them but kinds that nobody has built yet."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path

import pytest

from roadlang.plugins.discovery import registry_of
from roadlang.plugins.registry import Registry
from roadlang.semantics import check_text
from tests.semantics.sample_files import SAMPLES, copy_samples

NAMES = [path.name for path in sorted(SAMPLES.glob("*.rl"))]
ACME = Path(__file__).parents[1] / "plugins" / "acme_plugin"


@pytest.fixture(scope="module")
def registry() -> Registry:
    """All that is installed, and the plugin that the samples use."""
    sys.path.insert(0, str(ACME))
    try:
        acme_module = importlib.import_module("roadlang_acme")
    finally:
        sys.path.remove(str(ACME))
    return registry_of({"acme": acme_module}, installed=True)


def test_there_are_samples() -> None:
    assert len(NAMES) >= 16


@pytest.mark.parametrize("name", NAMES)
def test_sample(name: str, registry: Registry, tmp_path: Path) -> None:
    copy_samples(tmp_path)
    scenario, found = check_text((tmp_path / name).read_text(), tmp_path / name, {}, registry)
    unbuilt = [diagnostic for diagnostic in found if diagnostic.code == "RL212"]
    assert found == unbuilt, [diagnostic.message for diagnostic in found]
    assert (scenario is not None) == (not unbuilt)
