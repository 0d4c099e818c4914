"""`emit godot`: each scene built live in Godot, and verified."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Backend, Integer, String, Word, option

from .usual_port import USUAL_PORT

if TYPE_CHECKING:
    from roadlang.api import Scene

_WITHOUT_ENGINE = "`roadlang render FILE -o scene.tscn` writes a scene that any Godot project opens"


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
        from .engines.running_engine import RunningEngine

        layout = layout_of(scene, self.road)
        running = RunningEngine(self.host, self.port, self.transport, _WITHOUT_ENGINE)
        with running.connect(scene.name) as session:
            session.begin(layout.settings(), clear=True)
            session.update(layout.parts)
            session.prove()
