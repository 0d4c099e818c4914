"""Files that commands write, whose names say what is in them."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import click


class OutputPath(click.Path):
    """The path of a file or folder that a command writes. No name, as from a variable that is not
    set, is refused: as a path it is the current folder, of which files would be replaced."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The path. Raises `click.BadParameter`."""
        if not str(value):
            here = "; `.` is the current folder" if self.dir_okay else ""
            self.fail(f"the name is empty{here}", param, ctx)
        return super().convert(value, param, ctx)


class FormatFile(OutputPath):
    """The path of a file in a format (`SVG`); names that end as those of other formats do are
    refused, and so is `-`: no command writes such a file to standard output. `hint`: what writes
    other formats."""

    def __init__(self, format_name: str, *endings: str, hint: str = "") -> None:
        super().__init__(dir_okay=False)
        self.format_name = format_name
        self.endings = endings
        self.hint = hint

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The path. Raises `click.BadParameter`."""
        if Path(str(value)).suffix.lower() not in self.endings:
            ending = f"name a file that ends in `{self.endings[0]}`"
            text = f"this writes {self.format_name}: {ending}, not {value!r}.{self.hint}"
            self.fail(text, param, ctx)
        return super().convert(value, param, ctx)


def keep_inputs(written: Iterable[str | Path], read: Iterable[str | Path]) -> None:
    """Raises `click.UsageError` where a file would be written over one that is read."""
    inputs = [Path(name) for name in read if os.path.exists(name)]
    for path in map(Path, written):
        for source in inputs:
            if os.path.exists(path) and path.samefile(source):
                raise click.UsageError(
                    f"{path.name} would overwrite {source}, from which it is made: choose "
                    "another name for the output"
                )
