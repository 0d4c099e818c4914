"""Commands that plugins add; a broken one breaks nothing else, and is named when it fails."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING

import click

from ..plugins.attribution import PluginFault, Reason, attributed, reason_of
from ..plugins.compatibility import unmet_requirement
from ..plugins.entry_points import Candidate, Origin, command_candidates
from ..plugins.tracebacks import help_of_fault, show_traceback

if TYPE_CHECKING:
    from ..diagnostics import DiagnosticError

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_-]*\Z")


@dataclass(frozen=True)
class BrokenCommand:
    """A command that cannot be used, and why."""

    name: str
    origin: Origin
    reason: str

    def refuse(self) -> DiagnosticError:
        """RL932, for the caller to raise."""
        from ..diagnostics import Code, DiagnosticError, diagnose

        return DiagnosticError(
            diagnose(
                Code.BROKEN_PLUGIN_COMMAND,
                command=self.name,
                plugin=str(self.origin),
                reason=self.reason,
            )
        )


@dataclass(frozen=True)
class PluginCommands:
    """The commands of plugins by name, not imported yet, and those that are none."""

    found: dict[str, Candidate]
    broken: tuple[BrokenCommand, ...]

    def broken_command(self, name: str) -> BrokenCommand | None:
        """The broken command of this name, unless another one works."""
        fitting = (b for b in self.broken if b.name == name and name not in self.found)
        return next(fitting, None)


def plugin_commands(reserved: frozenset[str]) -> PluginCommands:
    """What installed plugins add to our `reserved` commands. None takes the place of another: what
    ships with roadlang goes before, and of two strangers with one name neither is meant."""
    candidates = command_candidates()
    counts = Counter(each.name for each in candidates)
    shipped = {each.name: each.origin for each in candidates if each.origin.is_shipped}
    found: dict[str, Candidate] = {}
    broken: list[BrokenCommand] = []
    for candidate in candidates:
        reason = None
        others = [c.origin for c in candidates if c.name == candidate.name and c is not candidate]
        if not _NAME.match(candidate.name):
            reason = "its name is not valid: use letters, digits, `-` and `_`"
        elif candidate.name in reserved:
            reason = "roadlang itself has a command with this name"
        elif counts[candidate.name] > 1 and not candidate.origin.is_shipped:
            other = shipped.get(candidate.name, others[0])
            reason = f"{other} has a command with the same name"
        else:
            reason = unmet_requirement(candidate.installed)
        if reason is None:
            found[candidate.name] = candidate
        else:
            broken.append(BrokenCommand(candidate.name, candidate.origin, reason))
    return PluginCommands(found, tuple(broken))


def load_command(candidate: Candidate) -> click.Command:
    """The command. Raises `DiagnosticError` RL932 where it cannot be loaded."""
    try:
        return _loaded(candidate)
    except PluginFault as fault:
        broken = BrokenCommand(candidate.name, candidate.origin, str(fault))
        if fault.__cause__ is not None and not isinstance(fault.__cause__, Reason):
            show_traceback(fault.__cause__)
        raise broken.refuse() from fault.__cause__


def _loaded(candidate: Candidate) -> click.Command:
    with attributed():
        command = candidate.load()
        if not isinstance(command, click.Command):
            raise Reason(f"it is a {type(command).__name__}, not a click.Command")
    return command


def help_of(candidate: Candidate) -> str | None:
    """The first line of a command's help, or why it cannot be used; None of a hidden one."""
    try:
        command = _loaded(candidate)
        with attributed():
            return None if command.hidden else command.get_short_help_str(limit=80)
    except PluginFault as fault:
        return f"cannot be used: {fault}"


def failure_of(candidate: Candidate, error: Exception) -> DiagnosticError | None:
    """RL470 for what a plugin's command raised as it ran.

    None for diagnostics, exit codes, usage error of the command line, a closed pipe and what the
    machine refuses, which are no faults of it, and for our own commands, whose bugs are ours.
    """
    from ..diagnostics import Code, DiagnosticError, diagnose
    from .machine_faults import machine_fault

    meant = (DiagnosticError, click.ClickException, click.exceptions.Exit, click.Abort)
    if isinstance(error, (*meant, BrokenPipeError)) or machine_fault(error) is not None:
        return None
    if candidate.origin.is_shipped:
        return None
    return DiagnosticError(
        diagnose(
            Code.PLUGIN_FAILED,
            kind=f"roadlang {candidate.name}",
            plugin=str(candidate.origin),
            reason=reason_of(error),
            help=help_of_fault(candidate.origin),
        )
    )
