"""Which kind reads a file, by the file's name."""

from __future__ import annotations

from pathlib import PurePath

from ...diagnostics import Code, Span
from ...plugins.kinds import Reader
from ...plugins.registry import KindEntry
from ..checker import Checker
from .kinds import display_name, loaded


def reader_of(checker: Checker, path: str, role: str, span: Span) -> str | None:
    """The qualified name of the reader of a file, or None, reported."""
    suffix = PurePath(path).suffix.lower()
    fitting: list[KindEntry] = []
    broken: list[tuple[KindEntry, str]] = []
    suffixes: set[str] = set()
    others: set[str] = set()
    for entry in checker.registry.of("read"):
        found = loaded(entry)
        if isinstance(found, str):  # it may not be the reader that is wanted
            broken.append((entry, found))
            continue
        reader = found.kind
        if not issubclass(reader, Reader) or role not in reader.reads:
            others.update(getattr(reader, "suffixes", ()))
            continue
        suffixes.update(reader.suffixes)
        if suffix in reader.suffixes:
            fitting.append(entry)
    shipped = [entry for entry in fitting if entry.origin.is_shipped]
    if shipped and len(fitting) > 1:
        _warn_of_others(checker, shipped[0], fitting, suffix, span)
    if len(shipped or fitting) == 1:
        return (shipped or fitting)[0].qualified
    if fitting:
        names = " or ".join(f"`read with {entry.qualified}`" for entry in fitting)
        owners = " and ".join(str(entry.origin) for entry in fitting)
        kind = f"a reader of {suffix} files"
        checker.report(
            Code.AMBIGUOUS_KIND, span, kind=kind, owners=owners, help=f"write {names} in its block"
        )
        return None
    planned = checker.registry.planned_reader(suffix)
    if planned is not None:
        checker.report(Code.PLANNED_KIND, span, kind=display_name("read", planned))
        return None
    for entry, reason in broken:
        kind = display_name("read", entry.name)
        checker.report(Code.BROKEN_PLUGIN, span, kind=kind, plugin=entry.origin, reason=reason)
    if broken:
        return None
    _report_none(checker, path, role, (suffixes, others), span)
    return None


def _report_none(
    checker: Checker, path: str, role: str, read: tuple[set[str], set[str]], span: Span
) -> None:
    """RL214. `read`: the endings of files that are read as this role, and as others."""
    suffix = PurePath(path).suffix.lower()
    suffixes, others = read
    known = ", ".join(sorted(suffixes)) or "none"
    shown = f"`{suffix}`" if suffix else "no ending"
    network = (
        f'`network town from "{path}"` reads it; `road NAME from town` selects one of its roads'
    )
    help_ = [network] if role == "road" and suffix in others else []
    help_ += [
        f"a {role} can be read from: {known}",
        "choose a reader with `read with` in its block",
    ]
    checker.report(Code.NO_READER, span, file=path, suffix=shown, role=role, help=help_)


def _warn_of_others(
    checker: Checker, chosen: KindEntry, fitting: list[KindEntry], suffix: str, span: Span
) -> None:
    for other in fitting:
        if not other.origin.is_shipped:
            help_ = f"write `read with {other.qualified}` in its block for that one, or "
            checker.report(
                Code.SHADOWED_KIND,
                span,
                kind=f"a reader of {suffix} files",
                other=other.origin,
                help=f"{help_}`read with {chosen.qualified}` for this one",
            )
