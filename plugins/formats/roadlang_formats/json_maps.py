"""Maps in JSON: parsed with limits; errors are reported at their place in the file."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from roadlang.api import read_input

from .map_xml import LARGEST, fault_at


def read_json(path: Path) -> tuple[str, Any]:
    """The text and the content of a file. Raises RL400, RL401, and RL479 for invalid JSON."""
    text = read_input(path, LARGEST).decode("utf-8-sig", errors="replace")
    try:
        return text, json.loads(text)
    except json.JSONDecodeError as error:
        raise fault_at(path, text, error.pos, f"invalid JSON: {error.msg}") from None
    except (RecursionError, ValueError) as error:
        raise fault_at(path, text, 0, f"invalid JSON: {error}") from None
