"""Scenes as JSON and back."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .scene import Scene


class NotFinite(ValueError):
    """A number that JSON cannot hold; `place` is the way to it (`roads[0].x[3]`)."""

    def __init__(self, place: str) -> None:
        super().__init__(f"`{place}` is not a finite number")
        self.place = place


def to_json(value: Any) -> str:
    """A dataclass of the IR as JSON: one member a line, lists of numbers on one line.

    The same value gives the same text: members in the order of the fields, maps sorted, numbers
    in the shortest form that reads back exactly. Raises `NotFinite`.
    """
    from .json_document import document, plain

    try:
        return document(value) + "\n"
    except ValueError:
        _refuse_non_finite(plain(value), "")
        raise


def scene_from_json(text: str | bytes) -> Scene:
    """Read a scene file of this version or an earlier one.

    Raises `msgspec.ValidationError` where it does not fit the schema, `msgspec.DecodeError` where
    it is no JSON, `UnknownSceneSchema` for another schema, `InconsistentScene` where its members do
    not fit together; all of them are `ValueError`s.
    """
    import msgspec

    from .scene import Scene
    from .scene_consistency import check_scene
    from .scene_versions import current, with_categories

    scene = msgspec.convert(current(msgspec.json.decode(text)), type=Scene)
    check_scene(scene)
    return with_categories(scene)


def _refuse_non_finite(value: Any, place: str) -> None:
    if isinstance(value, float):
        if not math.isfinite(value):
            raise NotFinite(place)
    elif isinstance(value, dict):
        for key, member in value.items():
            _refuse_non_finite(member, f"{place}.{key}" if place else str(key))
    elif isinstance(value, list | tuple):
        for index, item in enumerate(value):
            _refuse_non_finite(item, f"{place}[{index}]")
