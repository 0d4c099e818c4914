"""`emit godot`: each scene built live in Godot, and verified."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Backend, Code, Integer, String, Word, option

from .usual_port import USUAL_PORT

if TYPE_CHECKING:
    from roadlang.api import Scene

    from .net.session import Session


@dataclass(frozen=True)
class GodotBackend(Backend):
    """Build the scene in a running Godot (start it with `roadlang godot`) and verify it."""

    name: ClassVar[str] = "godot"

    road: Word = option(
        "mesh",
        words=("mesh", "tiles"),
        help="build the road as a mesh along the curve, or as pixel tiles",
    )
    transport: Word = option("udp", words=("udp", "websocket"), help="transport protocol")
    host: String = option("127.0.0.1", help="host on which Godot listens")
    port: Integer = option(USUAL_PORT, minimum=1, maximum=65535, help="port on which Godot listens")

    def send(self, scene: Scene) -> None:
        """Build, and compare what the engine holds with what was sent."""
        from .build.layout import layout_of

        layout = layout_of(scene, self.road)
        with self._connected(scene.name) as session:
            session.begin(layout.settings(), clear=True)
            session.update(layout.parts)
            session.prove()

    def _connected(self, name: str) -> Session:
        """Raises `EngineError` as `connect` does; where nobody answers, with what to do."""
        from .engines.engine import connect
        from .faults import EngineError

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
        return (
            f"start it in another terminal, `roadlang godot{port}{transport}`, and leave it open",
            "`roadlang render FILE -o scene.tscn` writes a scene that any Godot project opens",
        )
