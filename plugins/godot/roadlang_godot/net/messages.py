"""What a session and an engine say to each other in JSON, and the proof of what was built."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from roadlang.api import Code
from roadlang_godot.faults import EngineError, fault


@dataclass(frozen=True, slots=True)
class Proof:
    """What the engine's scene tree holds after a commit; `builds` counts every build ever made."""

    parts: int
    builds: int
    digest: bytes


def as_json(value: Mapping[str, Any]) -> bytes:
    """As an engine reads it: ASCII, without blanks."""
    return json.dumps(value, ensure_ascii=True, allow_nan=False, separators=(",", ":")).encode()


def text_of(payload: bytes) -> str:
    """The text of an engine's complaint, or the first bytes of what is none."""
    return str(_complaint(payload).get("text", payload[:80].decode("ascii", "replace")))


_HELP = {
    "busy": "an engine serves one client at a time: stop the other one, or start another engine"
    " with `roadlang godot --port 4243`",
    "protocol": "start the engine of this version of roadlang: `roadlang godot`",
}
"""What to do where an engine refuses a client, by its reason."""


def refusal(payload: bytes) -> EngineError:
    """The error RL503 of an engine's complaint to who greets it."""
    help = _HELP.get(str(_complaint(payload).get("code")), ())
    return fault(Code.GODOT_REFUSED, help, reason=text_of(payload))


def _complaint(payload: bytes) -> dict[str, Any]:
    try:
        found = json.loads(payload)
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}
