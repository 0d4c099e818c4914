"""The gallery: pictures and figures of the examples, each with the command that draws it.

python docs/site/gallery.py FOLDER      # the page, as on the site
python docs/site/gallery.py --render    # the pictures by Godot in docs/images/gallery, anew
"""

from __future__ import annotations

import contextlib
import io
import shlex
import shutil
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from roadlang.cli.main import run

EXAMPLES = Path(__file__).parents[2] / "examples"
KEPT = Path(__file__).parents[1] / "images" / "gallery"


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
    Figure("hairpin", "A bend from an aerial photo, perturbed under three requirements"),
    Figure("hairpin", "Nine of its variants", 9, "contact-sheet.svg"),
    Figure("street", "A street with trees and other objects"),
    Figure("network", "A network perturbed as a whole: junctions stay connected"),
    Figure("drawn_town", "A drawing with colors as a legend"),
    Figure("typed_town", "A map typed as text"),
    Figure("traffic", "Traffic on a street"),
    Figure("signals", "Traffic at an intersection with signals"),
    Figure("two_versions", "Two versions of one road, compared by formulas"),
    Figure("composed", "Several perturbations in turn"),
    Figure("sweep", "A parameter sweep", 6, "contact-sheet.svg"),
)


@dataclass(frozen=True)
class GodotPicture:
    """A picture that Godot draws: its name, a scene file of `examples/`, and the options."""

    name: str
    scene: str
    options: str
    shows: str

    @property
    def path(self) -> Path:
        """Where it is kept: a site is built without an engine."""
        return KEPT / f"{self.name}.jpg"

    @property
    def command(self) -> str:
        """What a reader types to draw it."""
        scene = f"examples/{self.scene}.rl"
        return f"roadlang render {scene} {self.options} --size 864x486 -o {self.name}.jpg"


PICTURES = (
    GodotPicture(
        "city",
        "pictures/city",
        "--view free --camera 14,14,13,42,-17 --at 8",
        "A few blocks of a town, typed as text: intersections with signals, traffic of all kinds",
    ),
    GodotPicture(
        "city_night",
        "pictures/city",
        "--view free --camera 14,14,13,42,-17 --at 8 --set hour=21h",
        "The same at night",
    ),
    GodotPicture(
        "city_rain",
        "pictures/city",
        "--at 8 --set hour=18.4h --set sky='\"rain\"'",
        "The same in rain at dusk, behind the red car `ego`",
    ),
    GodotPicture(
        "vehicles",
        "pictures/vehicles",
        "--view free --camera 4,-15,5.5,52,-13 --at 1",
        "An agent of every kind",
    ),
    GodotPicture("winter", "pictures/winter_road", "--at 6", "A road in winter"),
    GodotPicture(
        "fog", "pictures/winter_road", "--at 6 --set hour=7h --set sky='\"fog\"'", "In fog"
    ),
    GodotPicture(
        "dusk",
        "pictures/winter_road",
        "--at 7 --set hour=18.1h --set sky='\"clear\"'",
        "After sunset",
    ),
    GodotPicture(
        "roundabout",
        "roundabout",
        "--view free --camera 84,60,13,45,-18 --at 10",
        "A roundabout from a drawing",
    ),
    GodotPicture(
        "parked_row",
        "parked_row",
        "--view free --camera 127,1.5,1.9,163,-4 --at 12",
        "A child who steps out from behind parked cars",
    ),
    GodotPicture("drawn_town", "drawn_town", "--view free", "A drawing with colors as a legend"),
    GodotPicture(
        "tiles", "godot_tiles", "--view free --road tiles --at 3", "A map of pixels, built of tiles"
    ),
    GodotPicture("hairpin", "hairpin", "--view free --at 16", "A bend from an aerial photo"),
)


def render_pictures() -> Iterator[Path]:
    """Render all pictures with Godot again; give their paths."""
    KEPT.mkdir(parents=True, exist_ok=True)
    for picture in PICTURES:
        command = shlex.split(picture.command)[1:-1]
        command[1] = str(EXAMPLES.parent / command[1])
        if status := run([*command, str(picture.path)]):
            raise SystemExit(f"{picture.command} ended with {status}")
        yield picture.path


def _godot_section(folder: Path) -> Iterator[str]:
    """Lines of the page; the pictures are copied to the folder."""
    yield from ("## Rendered by Godot", "")
    for picture in PICTURES:
        copy = f"gallery/{picture.path.name}"
        shutil.copyfile(picture.path, folder / copy)
        yield from (f"![{picture.shows}]({copy})", "", f"{picture.shows}.", "")
        yield from ("```console", f"$ {picture.command}", "```", "")


def draw_gallery(folder: Path) -> Iterator[Path]:
    """Write `gallery.md` and its pictures into `folder`; give their paths."""
    page = [
        "# Gallery",
        "",
        "Pictures and figures of the scene files in `examples/`, with the commands that draw them.",
        "",
    ]
    (folder / "gallery").mkdir(parents=True, exist_ok=True)
    page += _godot_section(folder)
    yield from (folder / "gallery" / picture.path.name for picture in PICTURES)
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
    anew = sys.argv[1] == "--render"
    for written in render_pictures() if anew else draw_gallery(Path(sys.argv[1])):
        print(written)
