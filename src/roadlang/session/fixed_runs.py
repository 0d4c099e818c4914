"""What a run refuses whatever is drawn: two outputs that are one, grids that are too large."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from ..diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.values import PassCall
from ..plugins.kinds import implements


def equal_outputs(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """RL931 for each `emit` that is the same as one before it, so that they write the same files.

    Two with other options may write other files: only their names, with a scene, tell.
    """
    seen: set[PassCall] = set()
    for call in scenario.source.emits:
        entry, kind = scenario.kind(call)
        written = replace(call, place="", span=None)
        if written in seen and any(implements(kind, name) for name in ("files", "collection")):
            name, files = entry.recorded, "the same files"
            yield diagnose(Code.DUPLICATE_OUTPUT, call.span, first=name, second=name, files=files)
        seen.add(written)


def large_grid(scenario: IndexedScenario) -> tuple[Diagnostic, ...]:
    """What a sampler that goes through a fixed number of points says of their number (RL614)."""
    call = scenario.source.sample
    if call is None or not implements(scenario.kind(call)[1], "size"):
        return ()
    from ..search.samplers import drawn_values, sampler_of
    from ..world.index import index_scenario

    indexed = index_scenario(scenario.source, scenario.registry)
    try:
        sampler = sampler_of(indexed)
        with sampler.guarded:
            sampler.kind.size(drawn_values(indexed))
    except DiagnosticError as error:
        return error.diagnostics
    return ()
