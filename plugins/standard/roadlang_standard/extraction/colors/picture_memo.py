"""What several rules ask of the same picture is measured once in an extraction."""

from __future__ import annotations

import weakref
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any, Generic, TypeVar

from .tones import Image

_Measure = TypeVar("_Measure")
_Known = dict[tuple[Any, ...], tuple["weakref.ref[Image]", Any]]
_known: ContextVar[_Known | None] = ContextVar("known", default=None)


@contextmanager
def measuring_once() -> Iterator[None]:
    """Within it, nothing writes to a picture that was measured: what was found is kept as long as
    the picture exists."""
    before = _known.set({})
    try:
        yield
    finally:
        _known.reset(before)


class OncePerPicture(Generic[_Measure]):
    """A function of a picture (h, w, 3), and of values that can be keys."""

    def __init__(self, measure: Callable[..., _Measure]) -> None:
        self._measure = measure
        self.__doc__ = measure.__doc__

    def __call__(self, image: Image, *values: Any) -> _Measure:
        """What the function finds of a picture; what it found, while that is remembered."""
        known = _known.get()
        if known is None:
            return self._measure(image, *values)
        key = (self, id(image), *values)
        seen = known.get(key)
        if seen is not None and seen[0]() is image:
            remembered: _Measure = seen[1]
            return remembered
        found = self._measure(image, *values)
        known[key] = (weakref.ref(image, lambda _: known.pop(key, None)), found)
        return found
