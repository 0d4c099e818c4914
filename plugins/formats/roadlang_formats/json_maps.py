"""Maps in JSON: parsed with limits, faults reported where they are."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from roadlang.api import read_input

from .map_xml import LARGEST, fault_at


def read_json(path: Path) -> tuple[str, Any]:
    """The text and the content of a file. Raises RL400, RL401, and RL479 for what is no JSON."""
    text = read_input(path, LARGEST).decode("utf-8-sig", errors="replace")
    try:
        return text, json.loads(text)
    except json.JSONDecodeError as error:
        raise fault_at(path, text, error.pos, f"it is no JSON here: {error.msg}") from None
    except (RecursionError, ValueError) as error:
        raise fault_at(path, text, 0, f"it is no JSON: {error}") from None
