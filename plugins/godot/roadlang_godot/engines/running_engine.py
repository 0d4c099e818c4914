"""A Godot that somebody has started: `roadlang godot`, or a game with a `RoadlangStage`."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from roadlang.api import Code

from ..faults import EngineError
from ..usual_port import USUAL_PORT
from .engine import connect

if TYPE_CHECKING:
    from ..net.session import Session


@dataclass(frozen=True, slots=True)
class RunningEngine:
    """Where it listens, and by which protocol."""

    host: str
    port: int = USUAL_PORT
    transport: str = "udp"
    otherwise: str = ""
    """help where no engine answers, besides how to start one"""

    def connect(self, name: str = "") -> Session:
        """A session, for the scene of this name.

        Raises `EngineError` as `engine.connect` does; where nobody answers, with what to do.
        """
        try:
            return connect(self.host, self.port, self.transport, name)
        except EngineError as error:
            (found,) = error.diagnostics
            if found.code != Code.GODOT_NOT_ANSWERING:
                raise
            raise EngineError(replace(found, help=self._how_to_start())) from error.__cause__

    def _how_to_start(self) -> tuple[str, ...]:
        port = "" if self.port == USUAL_PORT else f" --port {self.port}"
        transport = "" if self.transport == "udp" else f" --transport {self.transport}"
        start = (
            f"start it in another terminal, `roadlang godot{port}{transport}`, and leave it open"
        )
        return (start, self.otherwise) if self.otherwise else (start,)
