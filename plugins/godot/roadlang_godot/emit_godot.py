"""`emit godot`: each scene built live in a Godot engine, and proven built."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from roadlang.api import Backend, String, Whole, Word, option

if TYPE_CHECKING:
    from roadlang.api import Scene


@dataclass(frozen=True)
class Godot(Backend):
    """Build the scene in a running engine (`roadlang godot` starts one), and prove it built."""

    name: ClassVar[str] = "godot"

    road: Word = option("mesh", words=("mesh", "tiles"), help="along the curve, or pixel by pixel")
    transport: Word = option("udp", words=("udp", "websocket"), help="how it is sent")
    host: String = option("127.0.0.1", help="where the engine listens")
    port: Whole = option(4242, minimum=1, maximum=65535, help="at which port")

    def send(self, scene: Scene) -> None:
        """Build, and compare what the engine holds with what was sent."""
        from .engine import connect
        from .layout import layout_of

        layout = layout_of(scene, self.road)
        with connect(self.host, self.port, self.transport, scene.name) as session:
            session.begin(layout.settings(), clear=True)
            session.update(layout.things)
            session.prove()
