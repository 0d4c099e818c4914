"""What a session and an engine say to each other in JSON, and the proof of what was built."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


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
    """The text of an engine's complaint, or the first bytes of what is no JSON."""
    try:
        return str(json.loads(payload).get("text", ""))
    except ValueError:
        return payload[:80].decode("ascii", "replace")
