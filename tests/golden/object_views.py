"""Everything that public objects say of themselves: members and methods without arguments."""

from __future__ import annotations

import inspect
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from roadlang import DiagnosticError
from roadlang.diagnostics.renamed_names import OldName
from tests.golden.scene_views import SEED, loaded, sampled
from tests.golden.summaries import array, number, plain

_LEFT_OUT = {
    *(
        "evaluator",
        "falsify",
        "loaded",
        "path",
        "provenance",
        "registry",
        "result",
        "run",
        "sample",
        "save",
    ),
    *("scenario", "svg", "task", "text", "to_frame", "to_json"),
}
_MOST_OF_A_TYPE, _DEEPEST = 2, 6


class Description:
    """Lines about an object and what it is made of, each type a few times."""

    def __init__(self) -> None:
        self._seen: Counter[str] = Counter()

    def lines(self, value: Any, name: str, depth: int = 0) -> Iterator[str]:
        """A line for a plain value; for an object one for each thing that it says."""
        flat = _numbers(value)
        if flat is not None:
            yield f"{name}: {flat}"
        elif isinstance(value, str | bytes | None | bool):
            yield f"{name}: {plain(repr(value))[:300]}"
        elif isinstance(value, Mapping):
            yield f"{name}: {len(value)} of {', '.join(map(str, list(value)[:12]))}"
            for key in list(value)[:3]:
                yield from self.lines(value[key], f"{name}[{key!r}]", depth + 1)
        elif type(value).__module__.startswith("roadlang"):
            yield from self._object(value, name, depth)
        elif isinstance(value, Sequence | frozenset | set):
            yield f"{name}: {len(value)}"
            items = sorted(value, key=str) if isinstance(value, frozenset | set) else value
            for place in range(min(2, len(items))):
                yield from self.lines(items[place], f"{name}[{place}]", depth + 1)

    def _object(self, value: Any, name: str, depth: int) -> Iterator[str]:
        kind = type(value).__name__
        self._seen[kind] += 1
        yield f"{name}: a {kind}"
        if self._seen[kind] > _MOST_OF_A_TYPE or depth > _DEEPEST:
            return
        for member in sorted(_members(value)):
            found = getattr(value, member)
            try:
                said = found() if inspect.ismethod(found) else found
            except DiagnosticError as error:
                said = str(error)
            yield from self.lines(said, f"{name}.{member}", depth + 1)
        if isinstance(value, Sequence) and len(value):
            yield from self.lines(value[0], f"{name}[0]", depth + 1)


def _numbers(value: Any) -> str | None:
    if isinstance(value, bool | np.bool_):
        return str(bool(value))
    if isinstance(value, int | float | np.number):
        return number(float(value))
    if isinstance(value, list | tuple) and value and all(type(v) in (int, float) for v in value):
        return array([float(v) for v in value])
    if isinstance(value, np.ndarray) and value.dtype.kind in "fiub":
        return array(value.astype(float).ravel().tolist(), value.shape) if value.size else "empty"
    return None


def _members(value: Any) -> Iterator[str]:
    """Fields, properties, and methods that need no argument."""
    for name, found in inspect.getmembers_static(value):
        if name.startswith("_") or name in _LEFT_OUT:
            continue
        if isinstance(found, property | cached_property) or not callable(found):
            if not isinstance(found, classmethod | staticmethod | OldName):
                yield name
        elif inspect.isfunction(found):
            parameters = list(inspect.signature(found).parameters.values())[1:]
            if all(one.default is not one.empty for one in parameters):
                yield name


def scene_object_lines(name: str) -> Iterator[str]:
    """A set of scenes, its first scene and its drive."""
    scenes = sampled(name, 2)
    yield from Description().lines(scenes, "scenes")
    yield from Description().lines(scenes[0].record, "record")
    yield from Description().lines(scenes.run(duration=3.0), "drives")


def search_object_lines(name: str) -> Iterator[str]:
    """What a search has found."""
    found = loaded(name).falsify(seed=SEED, searcher="random", evaluations=24, batch=12)
    yield from Description().lines(found, "found")
