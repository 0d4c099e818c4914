"""`roadlang plugins`: what is installed and what is broken; `new` starts a plugin."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING

import click
from click.shell_completion import CompletionItem

from ..diagnostics import Code
from .console import echo
from .named_kinds import kinds_text, named_kinds, other_names
from .option_listing import statement_lines
from .plugin_listing import kind_record, listing_lines, listing_record

if TYPE_CHECKING:
    from ..plugins.registry import KindEntry, Registry


class _PluginsGroup(click.Group):
    """The error of `plugins sine` suggests `plugins show sine`."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        try:
            return super().resolve_command(ctx, args)
        except click.UsageError as error:
            hint = f"`roadlang plugins show {' '.join(args)}` shows a kind"
            raise click.UsageError(f"{error.message} {hint}", ctx) from error


@click.group("plugins", cls=_PluginsGroup, invoke_without_command=True)
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
@click.option("--verb", help="List only the kinds of this verb: `perturb`, `emit`, ...")
@click.pass_context
def command(context: click.Context, as_json: bool, verb: str | None) -> None:
    """List the installed plugins with their kinds, and the plugins that fail to load.

    `roadlang plugins show NAME` lists the options of a kind; `roadlang plugins new NAME` writes a
    new plugin.
    """
    if context.invoked_subcommand is not None:
        return
    from ..plugins.discovery import load_registry

    registry = load_registry()
    if verb is not None:
        _check_verb(verb)
    if as_json:
        click.echo(json.dumps(listing_record(registry, verb), indent=2))
        return
    for line in listing_lines(registry, verb):
        echo(line)


def _complete(
    context: click.Context, parameter: click.Parameter, typed: str
) -> list[CompletionItem]:
    from ..plugins.discovery import load_registry

    names = sorted({entry.name for entry in load_registry().entries})
    return [CompletionItem(name) for name in names if name.startswith(typed)]


@command.command("show")
@click.argument("words", nargs=-1, required=True, metavar="[VERB] NAME", shell_complete=_complete)
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def show(words: tuple[str, ...], as_json: bool) -> None:
    """Show the options of a kind or statement: `show sine`.

    Put the verb first where several kinds have the same name: `show emit svg`. Statements have
    options, too: `show world`. The name of a plugin shows all of its kinds.
    """
    from ..plugins.discovery import load_registry
    from ..semantics.statement_reference import BY_WORD

    if len(words) == 1 and words[0] in BY_WORD and not as_json:
        echo("\n".join(statement_lines(BY_WORD[words[0]])))
        return
    entries = _find(load_registry(), words)
    if as_json:
        click.echo(json.dumps([kind_record(entry) for entry in entries], indent=2))
        return
    echo(kinds_text(entries))


@command.command("new")
@click.argument("name")
@click.option(
    "--kind",
    "verbs",
    metavar="VERB",
    multiple=True,
    help="Verb of a kind in it; may be given several times.  [default: perturb]",
)
@click.option("--folder", metavar="FOLDER", help="Folder to write.  [default: roadlang-NAME]")
def new(name: str, verbs: tuple[str, ...], folder: str | None) -> None:
    """Write a new plugin: a package with tests and types.

    It has one kind for each verb and is ready to install.

    There are templates for the verbs agent, drive, drive_signal, emit, extract, falsify (a
    searcher), monitor, object, perturb, read, sense and signal.
    """
    from ..plugins.discovery import load_registry
    from . import plugin_template

    verbs = tuple(dict.fromkeys(verbs)) or ("perturb",)
    for verb in verbs:
        _check_template(verb, plugin_template.VERBS)
    plugin_template.check_plugin_name(name, verbs, load_registry())
    shown = folder or f"roadlang-{name.replace('_', '-')}"
    plugin_template.write_plugin(name, verbs, shown)
    echo(f"wrote {shown}; now: cd {shown} && pip install -e '.[dev]' && pytest")


def _check_template(verb: str, known: Sequence[str]) -> None:
    from ..diagnostics import DiagnosticError, diagnose, did_you_mean

    if verb not in known:
        hints = (*did_you_mean(verb, known), f"there are templates for {', '.join(known)}")
        raise DiagnosticError(diagnose(Code.UNKNOWN_CHOICE, what="template", name=verb, help=hints))


def _check_verb(verb: str) -> None:
    from ..diagnostics import DiagnosticError, diagnose, did_you_mean
    from ..plugins.kinds import VERBS

    if verb not in VERBS:
        hints = did_you_mean(verb, VERBS) or (f"verbs: {', '.join(VERBS)}",)
        raise DiagnosticError(diagnose(Code.UNKNOWN_CHOICE, what="verb", name=verb, help=hints))


def _find(registry: Registry, words: tuple[str, ...]) -> list[KindEntry]:
    from ..diagnostics import DiagnosticError, diagnose, did_you_mean

    entries = named_kinds(registry, words)
    if not entries:
        hints = other_names(registry, words) or did_you_mean(
            words[-1], {entry.name for entry in registry.entries}
        )
        hints = hints or registry.hints or ("`roadlang plugins` lists all",)
        raise DiagnosticError(
            diagnose(Code.UNKNOWN_KIND_OR_PLUGIN, name=" ".join(words), help=hints)
        )
    return entries
