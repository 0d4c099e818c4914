"""What `reset(options=...)` may hold."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..diagnostics import did_you_mean
from ..diagnostics.arguments import mapping


def known_options(options: Any, name: str) -> Mapping[str, Any]:
    """The options, of which there is one. Raises TypeError for what is no map, ValueError for
    others than that."""
    if options is None:
        return {}
    for found in mapping("options", options):
        if found != name:
            near = "".join(f"; {hint}" for hint in did_you_mean(str(found), [name]))
            raise ValueError(f"`options` may have `{name}`, not `{found}`{near}")
    return dict(options)
