"""The kinds that this plugin brings; each is imported when it is used."""

from __future__ import annotations

from collections.abc import Mapping

from roadlang.api import hookimpl

_KINDS = {
    "drive manual": "drive_manual:Manual",
    "emit godot": "emit_godot:GodotBackend",
    "simulate godot": "simulate_godot:GodotSimulator",
}


@hookimpl
def roadlang_kinds() -> Mapping[str, str]:
    """Verb and name to where the class is."""
    return {kind: f"{__package__}.{target}" for kind, target in _KINDS.items()}
