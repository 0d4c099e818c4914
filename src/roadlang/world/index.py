"""A scenario indexed for evaluation, with what reads numbers off its geometry."""

from __future__ import annotations

from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import Scenario
from ..plugins.registry import Registry
from .signals import measured


def index_scenario(source: Scenario, registry: Registry) -> IndexedScenario:
    """The scenario by names, its kinds found in `registry`."""
    return IndexedScenario(source, registry, measured)
