"""The gallery: figures of the examples, each with the command that draws it.

python docs/site/gallery.py FOLDER
"""

from __future__ import annotations

import contextlib
import io
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from roadlang.cli.main import run

EXAMPLES = Path(__file__).parents[2] / "examples"


@dataclass(frozen=True)
class Figure:
    """A scene file of `examples/`, how many scenes of it are drawn, and which file is shown."""

    scene: str
    shows: str
    count: int = 1
    file: str = "scene-0000.svg"

    @property
    def command(self) -> str:
        """What a reader types to draw it."""
        return f"roadlang compile examples/{self.scene}.rl -o out -n {self.count} --emit svg"


FIGURES = (
    Figure("hairpin", "A bend read from an aerial photo and bent further, under three formulas"),
    Figure("hairpin", "Nine of its variants", 9, "contact-sheet.svg"),
    Figure("street", "A street with what stands beside it"),
    Figure("network", "A network perturbed as a whole: junctions stay joined"),
    Figure("drawn_town", "A drawing with colors as a legend"),
    Figure("typed_town", "A map typed as text"),
    Figure("traffic", "Traffic on a street"),
    Figure("signals", "Traffic at a crossing with signals"),
    Figure("two_versions", "Two versions of one road, compared by formulas"),
    Figure("composed", "Perturbations one after the other"),
    Figure("sweep", "A sweep over a parameter", 6, "contact-sheet.svg"),
)


def draw_gallery(folder: Path) -> Iterator[Path]:
    """Write `gallery.md` and its pictures into `folder`; give their paths."""
    page = [
        "# Gallery",
        "",
        "Figures of the scene files in `examples/`, drawn when this page was built.",
        "",
    ]
    for number, figure in enumerate(FIGURES):
        picture = f"gallery/{number:02d}-{figure.scene}.svg"
        _draw(figure, folder / picture)
        yield folder / picture
        page += [f"## {figure.shows}", "", f"![{figure.shows}]({picture})", ""]
        page += ["```console", f"$ {figure.command}", "```", ""]
        page += [f'??? note "{figure.scene}.rl"', ""]
        text = (EXAMPLES / f"{figure.scene}.rl").read_text(encoding="utf-8")
        page += ["    ```roadlang", *(f"    {line}" for line in text.splitlines()), "    ```", ""]
    path = folder / "gallery.md"
    path.write_text("\n".join(page), encoding="utf-8")
    yield path


def _draw(figure: Figure, picture: Path) -> None:
    """Compile the scene as the command does, and keep the one file."""
    output = picture.parent / "out"
    command = ["compile", str(EXAMPLES / f"{figure.scene}.rl"), "-o", str(output)]
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
        status = run([*command, "-n", str(figure.count), "--emit", "svg"])
    if status:
        raise SystemExit(f"{figure.command} ended with {status}: {printed.getvalue()}")
    (output / figure.file).rename(picture)


if __name__ == "__main__":
    for written in draw_gallery(Path(sys.argv[1])):
        print(written)
