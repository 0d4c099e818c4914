"""What every output of roads needs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from roadlang.api import Backend

if TYPE_CHECKING:
    from collections.abc import Iterable

    from roadlang.api import ScenarioContents


class RoadBackend(Backend):
    """An output that is of roads: a scenario without any has nothing for it."""

    def unsupported(self, contents: ScenarioContents) -> Iterable[str]:
        """It is of roads."""
        if not (contents.roads or contents.networks):
            yield "it has no road"
