"""Files that commands write, whose names say what is in them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click


class FormatFile(click.Path):
    """The path of a file in a format (`SVG`); names that end as those of other formats do are
    refused, and so is `-`: no command writes such a file to standard output."""

    def __init__(self, format_name: str, *endings: str) -> None:
        super().__init__(dir_okay=False)
        self.format_name = format_name
        self.endings = endings

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The path. Raises `click.BadParameter`."""
        if Path(str(value)).suffix.lower() not in self.endings:
            ending = f"name a file that ends in `{self.endings[0]}`"
            self.fail(f"this writes {self.format_name}: {ending}, not {value!r}.", param, ctx)
        return super().convert(value, param, ctx)
