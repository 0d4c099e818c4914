"""The backends that write files of drives: those that a scene file or `run --emit` names."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..diagnostics import Code, DiagnosticError, diagnose
from ..plugins.kinds import implements
from ..scenes.emitting import backends_of
from .named_outputs import scenario_of_outputs

if TYPE_CHECKING:
    from ..evaluate.kind_instance import KindInstance
    from ..ir.scenario import Scenario
    from ..plugins.registry import Registry
    from .loading import LoadedScenario


def drive_backends(loaded: LoadedScenario) -> list[KindInstance]:
    """Of a scene file: the backends of its `emit`s that write files of drives.

    Raises RL939 for one that the command line names and that writes none.
    """
    return _backends(loaded.scenario, loaded.registry, named=loaded.outputs is not None)


def named_backends(outputs: Sequence[str], registry: Registry) -> list[KindInstance]:
    """Of the command line alone, for a scene without its scene file.

    Raises RL939, and RL930, RL928, RL220 and the like for kinds and options.
    """
    return _backends(scenario_of_outputs(outputs, registry), registry, named=True)


def _backends(scenario: Scenario, registry: Registry, named: bool) -> list[KindInstance]:
    found = backends_of(scenario, registry, scenario.emits)
    writing = [backend for backend in found if implements(type(backend.kind), "drive_files")]
    if named:
        faults = [
            diagnose(Code.NO_DRIVE_FILES, kind=backend.entry.name, help=_drive_kinds(registry))
            for backend in found
            if backend not in writing
        ]
        if faults:
            raise DiagnosticError(*faults)
    return writing


def _drive_kinds(registry: Registry) -> list[str]:
    """One line of help that lists the kinds that write files of drives."""
    from ..semantics.checker import ResolvedKind
    from ..semantics.infer.kinds import loaded

    found = [loaded(entry) for entry in registry.of("emit")]
    kinds = [kind for kind in found if isinstance(kind, ResolvedKind)]
    names = [kind.entry.name for kind in kinds if implements(kind.kind, "drive_files")]
    listed = ", ".join(f"`{name}`" for name in names)
    return [f"those that do are {listed}"] if names else []
