"""The commands by name. A command's module is imported when it runs, so that `--help` is quick."""

from __future__ import annotations

import importlib
import os
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

COMMANDS: dict[str, tuple[str, str]] = {
    "compile": ("compile", "Check a scene file, sample scenes and write them."),
    "check": ("check", "Check scene files and report all errors."),
    "fmt": ("fmt", "Format scene files; comments are kept."),
    "init": ("init", "Write a starter scene file."),
    "explain": ("explain", "Explain a diagnostic, or a statement and its options."),
    "plugins": ("plugins", "List installed plugins and kinds; show the options of a kind."),
    "schema": ("schema", "Print a JSON Schema of an output format or of a kind's options."),
    "run": ("run", "Drive scenes in a simulator and evaluate their expectations."),
    "extract": ("extract", "Extract the roads of an image."),
    "monitor": ("monitor", "Evaluate an STL formula on recorded traces."),
    "mine": ("mine", "Find the tightest parameters with which a formula holds on traces."),
    "completion": ("completion", "Print a shell completion script."),
}
"""Name: module in this package and one line of help, in the order of `--help`."""

GROUP = "roadlang.commands"
"""The entry points through which plugins add commands: `render = "acme.commands:render"`, a
`click.Command` in a module that imports nothing heavy, since `--help` shows its first line."""


class LazyGroup(click.Group):
    """A group that knows its commands' names and help without importing them."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Commands of roadlang in a fixed order, then those of plugins by name."""
        return [*COMMANDS, *sorted(_of_plugins())]

    def get_command(self, ctx: click.Context, name: str) -> click.Command | None:
        """Import and return a command, or None if there is none of that name."""
        if name in COMMANDS:
            module = importlib.import_module(f".{COMMANDS[name][0]}", __package__)
            command: click.Command = module.command
            return command
        point = _of_plugins().get(name)
        return None if point is None else _loaded(point)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the command; an unknown one raises `UsageError` with near names."""
        try:
            return super().resolve_command(ctx, args)
        except click.UsageError as error:
            from ..diagnostics import did_you_mean

            hint = did_you_mean(args[0], self.list_commands(ctx))
            if not hint:
                raise
            message = f"{error.message} {hint[0].capitalize()}"
            raise click.UsageError(message, ctx) from error

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List commands with their one-line help, without importing them."""
        rows = [(name, line) for name, (_, line) in COMMANDS.items()]
        with formatter.section("Commands"):
            formatter.write_dl(rows)
        added = [(name, _help(point)) for name, point in sorted(_of_plugins().items())]
        if added:
            with formatter.section("Commands of plugins"):
                formatter.write_dl(added)


def _of_plugins() -> dict[str, EntryPoint]:
    """The commands that plugins add; none can take the place of one of ours."""
    refused = os.environ.get("ROADLANG_NO_PLUGINS", "").split(",")
    if "all" in refused:
        return {}
    from importlib.metadata import entry_points  # which imports 40 modules

    return {
        point.name: point
        for point in entry_points(group=GROUP)
        if point.name not in COMMANDS and point.value.partition(".")[0] not in refused
    }


def _loaded(point: EntryPoint) -> click.Command:
    """The command of a plugin. Raises `DiagnosticError` RL926 where it cannot be loaded."""
    from ..diagnostics import Code, DiagnosticError, diagnose

    try:
        command = point.load()
        if not isinstance(command, click.Command):
            raise TypeError(f"{point.value} is a {type(command).__name__}, not a click command")
    except Exception as error:
        origin = (
            f"{point.dist.metadata['Name']} {point.dist.version}" if point.dist else point.value
        )
        reason = f"{type(error).__name__}: {error}"
        raise DiagnosticError(
            diagnose(Code.BROKEN_PLUGIN_COMMAND, command=point.name, plugin=origin, reason=reason)
        ) from error
    return command


def _help(point: EntryPoint) -> str:
    """The first line of a command's help, or why it cannot be used."""
    from ..diagnostics import DiagnosticError

    try:
        return _loaded(point).get_short_help_str(limit=80)
    except DiagnosticError as error:
        return f"cannot be used: {error.diagnostics[0].message}"
