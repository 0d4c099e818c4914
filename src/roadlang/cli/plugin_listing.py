"""What is installed, as `roadlang plugins` prints it: what is broken first, then what works."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from .commands import OURS
from .console import style
from .option_listing import option_lines
from .plugin_commands import PluginCommands, help_of, plugin_commands

if TYPE_CHECKING:
    from ..plugins.entry_points import Origin
    from ..plugins.registry import BrokenPlugin, KindEntry, Registry


def listing_lines(registry: Registry, verb: str | None) -> list[str]:
    """Broken plugins, kinds and commands with the reason, then every plugin with what it brings;
    of kinds those of `verb` alone where it is given."""
    commands = plugin_commands(OURS)
    lines = [_broken_line(broken) for broken in _broken(registry, commands)]
    for origin in _origins(registry, commands):
        entries = [entry for entry in registry.entries if entry.origin == origin]
        rows = [_row(entry) for entry in entries if verb in (None, entry.verb)]
        rows += list(_command_rows(commands, origin)) if verb is None else []
        if rows:
            count = f", {len(entries)} kind{'' if len(entries) == 1 else 's'}" if entries else ""
            lines += [""] if lines else []
            lines.append(f"{style(origin.plugin, bold=True)}  ({origin}{count})")
            lines += [f"  {name:<30} {text}" for name, text in rows]
    return lines or ["no plugins are installed"]


def _broken(registry: Registry, commands: PluginCommands) -> list[BrokenPlugin]:
    from ..plugins.registry import BrokenPlugin

    added = (BrokenPlugin(b.origin, b.reason, f"command {b.name}") for b in commands.broken)
    return [*registry.broken, *added]


def _broken_line(broken: BrokenPlugin) -> str:
    verb, _, name = broken.kind.partition(" ")
    what = f"the command `{name}` of " if verb == "command" else f"`{broken.kind}` of "
    owner = f"{what if broken.kind else ''}{broken.origin.plugin} ({broken.origin})"
    return f"{style(f'{owner} is broken', fg='red')}: {broken.reason}"


def _origins(registry: Registry, commands: PluginCommands) -> list[Origin]:
    """Those that bring something, shipped ones first."""
    candidates = (candidate.origin for candidate in commands.found.values())
    found = dict.fromkeys([*(entry.origin for entry in registry.entries), *candidates])
    return sorted(found, key=lambda origin: not origin.is_shipped)


def _row(entry: KindEntry) -> tuple[str, str]:
    return f"{entry.verb} {entry.name}", _help(entry)


def _command_rows(commands: PluginCommands, origin: Origin) -> Iterator[tuple[str, str]]:
    for name, candidate in sorted(commands.found.items()):
        text = help_of(candidate) if candidate.origin == origin else None
        if text is not None:
            yield f"command {name}", text


def _help(entry: KindEntry) -> str:
    from ..plugins.attribution import PluginFault, attributed

    try:
        with attributed():
            return entry.help
    except PluginFault as fault:  # the kind is listed with the reason
        return f"cannot be used: {fault}"


def kind_lines(entry: KindEntry) -> list[str]:
    """A kind with all its options."""
    lines = [f"{style(f'{entry.verb} {entry.name}', bold=True)}: {_help(entry)}"]
    lines.append(f"  from {entry.origin} (plugin `{entry.origin.plugin}`)")
    lines += option_lines(entry.options)
    if not entry.options:
        lines.append("  no options")
    return lines


def listing_record(registry: Registry, verb: str | None) -> dict[str, Any]:
    """As `listing_lines`, for JSON."""
    commands = plugin_commands(OURS)
    entries = [entry for entry in registry.entries if verb in (None, entry.verb)]
    return {
        "kinds": [kind_record(entry) for entry in entries],
        "commands": [
            {"name": name, **_origin_record(candidate.origin), "help": help_of(candidate)}
            for name, candidate in sorted(commands.found.items())
        ],
        "broken": [
            {
                **_origin_record(broken.origin),
                "kind": broken.kind or None,
                "reason": broken.reason,
            }
            for broken in _broken(registry, commands)
        ],
    }


def _origin_record(origin: Origin) -> dict[str, str]:
    return {
        "plugin": origin.plugin,
        "distribution": origin.distribution,
        "version": origin.version,
    }


def kind_record(entry: KindEntry) -> dict[str, Any]:
    """A kind with all its options, for JSON."""
    from ..plugins.attribution import PluginFault, attributed

    record: dict[str, Any] = {
        "verb": entry.verb,
        "name": entry.name,
        "qualified": entry.qualified,
        **_origin_record(entry.origin),
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
