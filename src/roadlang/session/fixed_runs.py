"""What a run refuses whatever is drawn: two outputs that are one, grids that are too large."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from ..diagnostics import Code, Diagnostic, DiagnosticError, diagnose
from ..evaluate.indexed_scenario import IndexedScenario
from ..ir.scenario import FileSource
from ..ir.values import PassCall
from ..plugins.kinds import Searcher, implements


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


def large_grids(scenario: IndexedScenario) -> Iterator[Diagnostic]:
    """What samplers and searchers that go through a fixed number of points say of it (RL614)."""
    source = scenario.source
    if source.sample is not None and implements(scenario.kind(source.sample)[1], "size"):
        yield from _refused_size(scenario)
    if source.falsify is not None and _goes_through_points(scenario.kind(source.falsify)[1]):
        yield from _refused_start(source.falsify, scenario)


def _goes_through_points(kind: type) -> bool:
    return issubclass(kind, Searcher) and not (kind.is_adaptive or kind.is_random)


def _refused_size(scenario: IndexedScenario) -> tuple[Diagnostic, ...]:
    from ..search.samplers import drawn_values, sampler_of
    from ..world.index import index_scenario

    indexed = index_scenario(scenario.source, scenario.registry)
    try:
        sampler, drawn = sampler_of(indexed), drawn_values(indexed)
        with sampler.guarded:
            sampler.kind.size(drawn)
    except DiagnosticError as error:
        return error.diagnostics
    return ()


def _refused_start(call: PassCall, scenario: IndexedScenario) -> tuple[Diagnostic, ...]:
    """Which draws a scene makes is seen by making some, where as many as are written would be
    refused and no file has to be read."""
    from ..evaluate.candidates import fixed_candidate
    from ..evaluate.evaluation import build
    from ..falsification.axes import axes_of, axes_written
    from ..world.index import index_scenario

    indexed = index_scenario(scenario.source, scenario.registry)
    sources = [one.source for one in scenario.images.values()]
    sources += [one.source for one in scenario.networks.values()]
    try:
        searcher = build(call, fixed_candidate(indexed), single=True)
        written = axes_written(indexed)
        try:
            with searcher.guarded:
                searcher.kind.start(written, 0)
        except DiagnosticError:
            if any(isinstance(source, FileSource) for source in sources):
                return ()
            axes = axes_of(indexed, 0)
            with searcher.guarded:
                searcher.kind.start(axes, 0)
    except DiagnosticError as error:
        return error.diagnostics
    return ()
