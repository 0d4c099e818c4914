"""The distributions that are installed, and their entry points, read without `importlib.metadata`.

Every command looks for plugins. `importlib.metadata` imports 40 modules for it, `email` among them,
which was a quarter of the time of `roadlang --help`. Where something is on `sys.path` that only it
can read, a zip file or what another finder brings, it is asked instead.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from importlib.machinery import PathFinder
from typing import Any

_METADATA = {".dist-info": "METADATA", ".egg-info": "PKG-INFO"}
"""The file with name and version, by the ending of a distribution's folder."""


@dataclass(frozen=True)
class Installed:
    """An installed distribution: the folder of its metadata, or what `importlib.metadata` has."""

    folder: str
    found: Any = field(default=None, compare=False)

    @property
    def name(self) -> str:
        """As in its metadata; without, as its folder is called."""
        stem = os.path.basename(self.folder).partition("-")[0]
        return next(iter(self._all("name")), stem)

    @property
    def version(self) -> str:
        """As in its metadata, "0" if that is missing."""
        return next(iter(self._all("version")), "0")

    @property
    def requires(self) -> list[str]:
        """The requirements: `numpy>=1.24; extra == "fast"`."""
        if self.found is None and self.folder.endswith(".egg-info"):
            from importlib.metadata import Distribution

            return Distribution.at(self.folder).requires or []
        return self._all("requires-dist")

    def _all(self, key: str) -> list[str]:
        return [value for name, value in self._headers if name == key]

    @cached_property
    def _headers(self) -> list[tuple[str, str]]:
        """Name, in lower case, and value of each line before the README."""
        if self.found is not None:
            read = (self.found.read_text(file) for file in _METADATA.values())
            text = next(filter(None, read), "")
        else:
            text = _text(self.folder, _METADATA[os.path.splitext(self.folder)[1]])
        lines: list[tuple[str, str]] = []
        for line in text.splitlines():
            if not line:
                break
            name, colon, value = line.partition(":")
            if colon and not name[0].isspace():  # else it goes on with the line before
                lines.append((name.lower(), value.strip()))
        return lines


@dataclass(frozen=True)
class EntryPoint:
    """`hello = "roadlang_acme.commands:hello"` of a group: its name and value."""

    group: str
    name: str
    value: str
    installed: Installed

    @property
    def module(self) -> str:
        """The module that it leads to."""
        return self._target[0]

    @property
    def _target(self) -> tuple[str, str]:
        # What is in brackets, the extras that it needs, is long out of use.
        module, _, attribute = self.value.partition("[")[0].partition(":")
        return module.strip(), attribute.strip()

    def load(self) -> Any:
        """What it leads to; raises whatever importing it raises."""
        from pkgutil import resolve_name

        return resolve_name(":".join(self._target))


def entry_points(prefix: str) -> list[EntryPoint]:
    """Those of all groups whose names begin with `prefix`, in the order of `sys.path`."""
    found: list[EntryPoint] = []
    for installed in _everything():
        if installed.found is not None:
            text = installed.found.read_text("entry_points.txt") or ""
        else:
            text = _text(installed.folder, "entry_points.txt")
        if prefix in text:
            found += _points(text, prefix, installed)
    return found


def _points(text: str, prefix: str, installed: Installed) -> Iterator[EntryPoint]:
    group = ""
    for line in map(str.strip, text.splitlines()):
        if line.startswith("[") and line.endswith("]"):
            group = line[1:-1]
        elif group.startswith(prefix) and not line.startswith("#"):
            name, equals, value = line.partition("=")
            if equals:
                yield EntryPoint(group, name.strip(), value.strip(), installed)


def _everything() -> Iterator[Installed]:
    """Each distribution that is installed once: the one that Python would import."""
    folders = _folders(sys.path) if _is_plain() else None
    if folders is None:
        yield from _asked_for()
        return
    seen = set()
    for folder in folders:
        stem = os.path.splitext(os.path.basename(folder))[0]
        name = stem.partition("-")[0].lower().replace("-", "_").replace(".", "_")
        if name not in seen:
            seen.add(name)
            yield Installed(folder)


def _is_plain() -> bool:
    """Whether distributions are found by the finder of Python alone, or by its newer edition.

    The distribution `importlib_metadata` puts its own finder in the place of Python's as soon as
    anything imports it; it looks in the same folders.
    """
    finders = (finder for finder in sys.meta_path if hasattr(finder, "find_distributions"))
    return all(
        finder is PathFinder or type(finder).__module__ == "importlib_metadata"
        for finder in finders
    )


def _folders(path: Sequence[str]) -> list[str] | None:
    """The folders of metadata on a path; None where a part of it is no folder."""
    found = []
    for root in path:
        if root.endswith(".egg"):
            return None
        try:
            names = os.listdir(root or ".")
        except NotADirectoryError:
            return None
        except OSError:
            continue  # it is not there, or not for us to read
        metadata = (name for name in names if name.endswith(tuple(_METADATA)))
        found += [os.path.join(root, name) for name in sorted(metadata)]
    return found


def _asked_for() -> Iterator[Installed]:
    from importlib.metadata import distributions

    seen = set()
    for found in distributions():
        installed = Installed("", found)
        name = installed.name.lower().replace("-", "_").replace(".", "_")
        if name not in seen:
            seen.add(name)
            yield installed


_read: dict[str, tuple[tuple[int, ...], str]] = {}
"""What was read, by path, and how the file was then: whoever loads many scenes looks at the same
hundred files each time, and asking whether one has changed takes a tenth of reading it."""


def _text(folder: str, file: str) -> str:
    path = os.path.join(folder, file)
    try:
        now = os.stat(path)
        state = (now.st_dev, now.st_ino, now.st_size, now.st_mtime_ns)
        known = _read.get(path)
        if known is None or known[0] != state:
            with open(path, encoding="utf-8", errors="replace") as opened:
                known = _read[path] = state, opened.read()
        return known[1]
    except OSError:
        return ""
