"""The commands by name. A command's module is imported when it runs, so that `--help` is quick."""

from __future__ import annotations

import importlib
from typing import Any

import click

COMMANDS: dict[str, tuple[str, str]] = {
    "compile": ("compile", "Check a scene file, sample scenes and write them."),
    "check": ("check", "Check scene files and report all errors."),
    "fmt": ("fmt", "Format scene files; comments are kept."),
    "init": ("init", "Write a starter scene file."),
    "explain": (
        "explain",
        "Explain a diagnostic, a statement, a kind or a failure.",
    ),
    "plugins": ("plugins", "List installed plugins and kinds; show the options of a kind."),
    "schema": ("schema", "Print a JSON Schema of an output format or of a kind's options."),
    "run": ("run", "Drive scenes in a simulator and evaluate their expectations."),
    "falsify": ("falsify", "Search for scenes that violate an expectation."),
    "shrink": ("shrink", "Find the simplest scene that still fails."),
    "report": ("report", "Write an HTML page with the results of `run` or `falsify`."),
    "extract": ("extract", "Extract the roads of an image."),
    "monitor": ("monitor", "Evaluate an STL formula on recorded traces."),
    "mine": ("mine", "Find the tightest parameters with which a formula holds on traces."),
    "completion": ("completion", "Print a shell completion script."),
}
"""Name: module in this package and one line of help, in the order of `--help`."""

OURS = frozenset(COMMANDS)
"""The names that no plugin can take."""
_CANDIDATE = "roadlang.plugin_command"


class LazyGroup(click.Group):
    """A group that knows its commands' names and help without importing them.

    Those of plugins come from the entry points `roadlang.commands`; they are imported for
    `--help`, which shows their first lines, and when they run.
    """

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Commands of roadlang in a fixed order, then those of plugins by name."""
        from .plugin_commands import plugin_commands

        return [*COMMANDS, *sorted(plugin_commands(OURS).found)]

    def get_command(self, ctx: click.Context, name: str) -> click.Command | None:
        """Import and return a command, or None if there is none of that name.

        Raises `DiagnosticError` RL932 for a broken command of a plugin.
        """
        if name in COMMANDS:
            module = importlib.import_module(f".{COMMANDS[name][0]}", __package__)
            command: click.Command = module.command
            return command
        from ..diagnostics import DiagnosticError
        from .plugin_commands import load_command, plugin_commands

        added = plugin_commands(OURS)
        broken = added.broken_command(name)
        try:
            if broken is not None:
                raise broken.refuse()
            candidate = added.found.get(name)
            return None if candidate is None else load_command(candidate)
        except DiagnosticError:
            if ctx.resilient_parsing:  # completion goes on without it
                return None
            raise

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command; what a plugin's command raises is a fault of the plugin."""
        try:
            return super().invoke(ctx)
        except Exception as error:
            candidate = ctx.meta.get(_CANDIDATE)
            if candidate is None:
                raise
            from ..plugins.tracebacks import show_traceback
            from .plugin_commands import failure_of

            failure = failure_of(candidate, error)
            if failure is None:
                raise
            show_traceback(error)
            raise failure from error

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the command; an unknown one raises `UsageError` with near names."""
        try:
            found = super().resolve_command(ctx, args)
        except click.UsageError as error:
            from ..diagnostics import did_you_mean
            from .guessed_commands import guessed_command_hint

            near = did_you_mean(args[0], self.list_commands(ctx))
            hint = guessed_command_hint(args[0]) or (near[0].capitalize() if near else None)
            if hint is None:
                raise
            message = f"{error.message} {hint}"
            raise click.UsageError(message, ctx) from error
        if found[0] is not None and found[0] not in COMMANDS:
            from .plugin_commands import plugin_commands

            ctx.meta[_CANDIDATE] = plugin_commands(OURS).found[found[0]]
        return found

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List commands with their one-line help; only those of plugins are imported for it."""
        from .plugin_commands import help_of, plugin_commands

        rows = [(name, line) for name, (_, line) in COMMANDS.items()]
        with formatter.section("Commands"):
            formatter.write_dl(rows)
        added = plugin_commands(OURS)
        lines = {name: help_of(candidate) for name, candidate in added.found.items()}
        lines |= {
            b.name: f"cannot be used: {b.reason}"
            for b in added.broken
            if b.name not in OURS and b.name not in lines
        }
        shown = [(name, line) for name, line in sorted(lines.items()) if line is not None]
        if shown:
            with formatter.section("Commands of plugins"):
                formatter.write_dl(shown)
