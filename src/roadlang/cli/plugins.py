"""`roadlang plugins`: what is installed, what it brings, and what is broken."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import click
from click.shell_completion import CompletionItem

from ..diagnostics import Code
from .console import echo, style
from .option_listing import option_lines, statement_lines

if TYPE_CHECKING:
    from ..plugins.registry import KindEntry, Registry


@click.group("plugins", invoke_without_command=True)
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
@click.option("--verb", help="List only the kinds of this verb: `perturb`, `emit`, ...")
@click.pass_context
def command(context: click.Context, as_json: bool, verb: str | None) -> None:
    """List the installed plugins with their kinds, and the plugins that fail to load.

    `roadlang plugins show NAME` lists the options of a kind.
    """
    if context.invoked_subcommand is not None:
        return
    from ..plugins.discovery import load_registry

    registry = load_registry()
    if verb is not None:
        _check_verb(verb)
    if as_json:
        click.echo(json.dumps(_record(registry, verb), indent=2))
        return
    for line in _listing(registry, verb):
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
    """Show the options of a kind or statement: `show sine`, `show emit svg`, `show world`."""
    from ..plugins.discovery import load_registry
    from ..plugins.guard import plugin_guard
    from ..semantics.statement_reference import BY_WORD

    if len(words) == 1 and words[0] in BY_WORD and not as_json:
        echo("\n".join(statement_lines(BY_WORD[words[0]])))
        return
    entries = _find(load_registry(), words)
    for entry in entries:
        with plugin_guard(entry, None):
            entry.load()
    if as_json:
        click.echo(json.dumps([_kind_record(entry) for entry in entries], indent=2))
        return
    echo("\n\n".join("\n".join(_shown(entry)) for entry in entries))


def _check_verb(verb: str) -> None:
    from ..diagnostics import DiagnosticError, diagnose, did_you_mean
    from ..plugins.kinds import VERBS

    if verb not in VERBS:
        hints = did_you_mean(verb, VERBS) or (f"verbs: {', '.join(VERBS)}",)
        raise DiagnosticError(diagnose(Code.UNKNOWN_CHOICE, what="verb", name=verb, help=hints))


def _find(registry: Registry, words: tuple[str, ...]) -> list[KindEntry]:
    from ..diagnostics import DiagnosticError, diagnose, did_you_mean

    verb, name = (words[0], words[1]) if len(words) > 1 else (None, words[0])
    entries = [
        entry
        for entry in registry.entries
        if name in (entry.name, entry.qualified) and verb in (None, entry.verb)
    ]
    if not entries:
        hints = did_you_mean(name, {entry.name for entry in registry.entries})
        hints = hints or registry.hints
        raise DiagnosticError(
            diagnose(Code.UNKNOWN_KIND_OR_PLUGIN, name=" ".join(words), help=hints)
        )
    return entries


def _listing(registry: Registry, verb: str | None) -> list[str]:
    lines = []
    for broken in registry.broken:
        what = f"`{broken.kind}` of {broken.origin.plugin}" if broken.kind else broken.origin.plugin
        head = style(f"{what} ({broken.origin}) is broken", fg="red")
        lines.append(f"{head}: {broken.reason}")
    for origin in dict.fromkeys(entry.origin for entry in registry.entries):
        entries = [entry for entry in registry.entries if entry.origin == origin]
        shown = [entry for entry in entries if verb in (None, entry.verb)]
        if shown:
            lines += ["", f"{style(origin.plugin, bold=True)}  ({origin}, {len(entries)} kinds)"]
            lines += [f"  {name:<30} {text}" for name, text in map(_line, shown)]
    if lines and not lines[0]:
        del lines[0]
    return lines or ["no plugins are installed"]


def _line(entry: KindEntry) -> tuple[str, str]:
    return f"{entry.verb} {entry.name}", _help(entry)


def _help(entry: KindEntry) -> str:
    from ..plugins.guard import PluginFault, attributed

    try:
        with attributed():
            return entry.help
    except PluginFault as fault:  # the kind is listed with the reason
        return f"cannot be used: {fault}"


def _shown(entry: KindEntry) -> list[str]:
    lines = [f"{style(f'{entry.verb} {entry.name}', bold=True)}: {_help(entry)}"]
    lines.append(f"  from {entry.origin} (plugin `{entry.origin.plugin}`)")
    lines += option_lines(entry.options)
    if not entry.options:
        lines.append("  no options")
    return lines


def _record(registry: Registry, verb: str | None) -> dict[str, Any]:
    return {
        "kinds": [_kind_record(entry) for entry in registry.entries if verb in (None, entry.verb)],
        "broken": [
            {
                "plugin": broken.origin.plugin,
                "distribution": broken.origin.distribution,
                "version": broken.origin.version,
                "kind": broken.kind or None,
                "reason": broken.reason,
            }
            for broken in registry.broken
        ],
    }


def _kind_record(entry: KindEntry) -> dict[str, Any]:
    from ..plugins.guard import PluginFault, attributed

    record: dict[str, Any] = {
        "verb": entry.verb,
        "name": entry.name,
        "qualified": entry.qualified,
        "plugin": entry.origin.plugin,
        "distribution": entry.origin.distribution,
        "version": entry.origin.version,
        "help": _help(entry),
    }
    try:
        with attributed():
            options = entry.options
        record["options"] = [_option_record(option) for option in options]
    except PluginFault as fault:  # the kind's module failed; the listing goes on
        record["broken"] = str(fault)
    return record


def _option_record(option: Any) -> dict[str, Any]:
    from ..plugins.describing import bounds_text, default_text, type_text

    return {
        "name": option.name,
        "type": type_text(option),
        "required": option.required,
        "default": default_text(option) or None,
        "bounds": bounds_text(option) or None,
        "words": list(option.words),
        "help": option.help,
    }
