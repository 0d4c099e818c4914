"""All that the author of a command imports, in addition to `roadlang` and `roadlang.api`.

A command is a click command under an entry point of the group `roadlang.commands`. What it prints
looks like what the commands of roadlang print, and what it writes is whole or absent. Import what
is needed only while the command runs inside it: `roadlang --help` loads every command.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from .cli import exit_codes
from .cli.console import echo, note, report, style
from .cli.finite_range import FiniteRange, Seed, WholeNumber
from .cli.output_files import FormatFile, keep_inputs
from .cli.quantities import pixel_size, seconds

if TYPE_CHECKING:
    from .cli.progress import ProgressBar
    from .diagnostics import Code, Diagnostic, DiagnosticError, diagnose
    from .drive.controllers import python_controllers
    from .files.staging import staged_set
    from .files.writing import replace_file, write_all, write_file
    from .handles.handle import Handle
    from .handles.handles import (
        dragged,
        handles_of,
        inserted,
        is_at_point,
        nearest_on_road,
        removed,
    )
    from .handles.networks import network_motion
    from .ir.edited_starts import edited_starts
    from .judging.running_drives import judge_so_far
    from .session.named_outputs import emitted_files
    from .session.outputs import parse_outputs
    from .session.params import parse_overrides
    from .session.scene_files import read_scene_file
    from .syntax.moved_places import moved_places_of
    from .syntax.scene_edits import offset_of, waypoints_of

_LATER = {
    ".files.staging": "staged_set",
    ".files.writing": "replace_file write_all write_file",
    ".cli.progress": "ProgressBar",
    ".diagnostics": "Code Diagnostic DiagnosticError diagnose",
    ".drive.controllers": "python_controllers",
    ".ir.edited_starts": "edited_starts",
    ".judging.running_drives": "judge_so_far",
    ".handles.handle": "Handle",
    ".handles.handles": "dragged handles_of inserted is_at_point nearest_on_road removed",
    ".handles.networks": "network_motion",
    ".session.named_outputs": "emitted_files",
    ".session.outputs": "parse_outputs",
    ".session.params": "parse_overrides",
    ".syntax.moved_places": "moved_places_of",
    ".session.scene_files": "read_scene_file",
    ".syntax.scene_edits": "offset_of waypoints_of",
}
_HOME = {name: module for module, names in _LATER.items() for name in names.split()}

__all__ = [
    "Code",
    "Diagnostic",
    "DiagnosticError",
    "FiniteRange",
    "FormatFile",
    "Handle",
    "ProgressBar",
    "Seed",
    "WholeNumber",
    "diagnose",
    "dragged",
    "echo",
    "edited_starts",
    "emitted_files",
    "exit_codes",
    "handles_of",
    "inserted",
    "is_at_point",
    "judge_so_far",
    "keep_inputs",
    "moved_places_of",
    "nearest_on_road",
    "network_motion",
    "note",
    "offset_of",
    "parse_outputs",
    "parse_overrides",
    "pixel_size",
    "python_controllers",
    "read_scene_file",
    "removed",
    "replace_file",
    "report",
    "seconds",
    "staged_set",
    "style",
    "waypoints_of",
    "write_all",
    "write_file",
]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOME[name], __package__), name)
