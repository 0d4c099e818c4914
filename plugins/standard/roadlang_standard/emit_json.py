"""`emit json`: each scene in the versioned schema of scenes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Backend

if TYPE_CHECKING:
    from roadlang.api import Scene


@dataclass(frozen=True)
class Json(Backend):
    """The complete scene as JSON, in SI units and radians (`roadlang schema scene`)."""

    name: ClassVar[str] = "json"
    is_default: ClassVar[bool] = True

    def files(self, scene: Scene) -> Mapping[str, str]:
        """The scene's members as they are."""
        from roadlang.api import to_json

        return {"json": to_json(scene)}
