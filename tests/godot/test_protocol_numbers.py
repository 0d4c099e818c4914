"""Both sides of the wire have the same numbers, and both engines one rule of who is in the way."""

from __future__ import annotations

import re

from roadlang.simulation.surroundings import road_gaps
from roadlang_godot.engines import engine as engines
from roadlang_godot.net import protocol
from roadlang_godot.net.link_websocket import WebSocketLink
from roadlang_godot.usual_port import USUAL_PORT

_CONSTANT = re.compile(r"^const (\w+) := (\S+)$", re.MULTILINE)
_KNOWN_TO_THE_ENGINE_ALONE = {"MAX_WORLDS", "MAX_THINGS"}


def test_constants_of_the_protocol() -> None:
    text = (engines.project() / "net" / "protocol.gd").read_text(encoding="utf-8")
    there = {name: float(int(value, 0) if "." not in value else float(value))
             for name, value in _CONSTANT.findall(text)}  # fmt: skip
    here = {message.name: float(message) for message in protocol.Message}
    here |= {name: float(getattr(protocol, name)) for name in there.keys() & vars(protocol).keys()}
    here["USUAL_PORT"] = float(USUAL_PORT)
    here["WEBSOCKET_WINDOW"] = float(WebSocketLink.window)
    assert here == {name: there[name] for name in there.keys() - _KNOWN_TO_THE_ENGINE_ALONE}


def test_how_far_beside_its_line_a_vehicle_is_in_the_way() -> None:
    text = (engines.project() / "agents" / "signals.gd").read_text(encoding="utf-8")
    there = {name: float(value) for name, value in _CONSTANT.findall(text) if "(" not in value}
    assert there == {
        name: getattr(road_gaps, name) for name in ("SAME_LANE", "MARGIN", "CLEARANCE")
    }
