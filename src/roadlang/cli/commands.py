"""The commands by name. A command's module is imported when it runs, so that `--help` is quick."""

from __future__ import annotations

import importlib
from importlib.util import find_spec

import click

COMMANDS: dict[str, tuple[str, str]] = {
    "compile": ("compile", "Make scenes of a scene file and write them."),
    "check": ("check", "Report every fault of scene files; write nothing."),
    "fmt": ("fmt", "Put scene files into the one layout; comments stay."),
    "init": ("init", "Write a starter scene that compiles."),
    "explain": ("explain", "Explain a diagnostic code."),
    "plugins": ("plugins", "List plugins and their kinds; show a kind's options."),
    "schema": ("schema", "Print a JSON Schema: scene, manifest, scenario, a kind's options."),
    "run": ("run", "Drive scenes and judge their expectations."),
    "falsify": ("falsify", "Search for scenes that break an expectation."),
    "report": ("report", "Summarise what runs and searches found."),
    "watch": ("watch", "Compile again on every save and send the changes to Godot."),
    "godot": ("godot", "Start the bundled Godot project."),
    "render": ("render", "Render a scene to a picture or a clip with Godot."),
    "extract": ("extract", "Find the roads of a picture and show what was found."),
    "monitor": ("monitor", "Judge a recorded trace by an STL formula."),
    "mine": ("mine", "Find the tightest parameters of a formula that traces satisfy."),
    "completion": ("completion", "Print the completion script of a shell."),
}
"""Name: module in this package and one line of help, in the order of `--help`. A command whose
module is not there is not listed."""


class LazyGroup(click.Group):
    """A group that knows its commands' names and help without importing them."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return [name for name, (module, _) in COMMANDS.items() if _exists(module)]

    def get_command(self, ctx: click.Context, name: str) -> click.Command | None:
        if name not in COMMANDS or not _exists(COMMANDS[name][0]):
            return None
        module = importlib.import_module(f".{COMMANDS[name][0]}", __package__)
        command: click.Command = module.command
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
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
        rows = [(name, COMMANDS[name][1]) for name in self.list_commands(ctx)]
        with formatter.section("Commands"):
            formatter.write_dl(rows)


def _exists(module: str) -> bool:
    return find_spec(f"{__package__}.{module}") is not None
