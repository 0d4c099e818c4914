"""What sequences of commands print and write in one folder, in lines."""

from __future__ import annotations

import csv
import io
import json
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path

from tests.golden.comparing import SCENES
from tests.golden.scene_views import printed
from tests.golden.search_views import page_lines, table_lines
from tests.golden.summaries import of_json, of_svg, of_text

_IMPOSSIBLE = """
road main { draw with segments { pieces: [straight(100m)] }, width: 6m..8m }
require wide: always (width(main) > 9m)
require long: length(main) > (50m)..(150m)
agent ego is car on main at 20m { drive with lane_follow { speed: 9m/s } }
expect slow: always (ego.speed < 8m/s)
"""
_FAULTY = """scenario demo "Demo"
road main { draw with segments { pieces: [strait(100m), arc(50, 30deg)] }, lane: 2, widht: 7m }
agent ego is car on mian at 10m { drive with lane_follow { speed: 30km/s } }
requires long: length(main) > 50m
"""
_PARAMS = """
- { gap: 12m, pace: 9m/s }
- { gap: 25m }
- { pace: 14m/s }
"""
_FAULTY_PARAMS = "- { gap: 12m }\n- { pace: 14.0, gab: 3m }\n"
_TABLE = """
param gap = 8m..30m
param pace = choice(7m/s, 11m/s)
road main { draw with segments { pieces: [straight(60m), arc(60m, 40deg), straight(9m)] } lanes: 2 }
agent ego is car on main at 10m { drive with car_follow { speed: pace } }
agent lead is van on main at ahead_of(ego, gap) { drive with lane_follow { speed: 5m/s } }
expect apart: always (gap(ego, lead) > 5m)
expect quick: eventually (ego.speed > 10m/s)
expect long: length(main) > 105m
simulate with builtin { duration: 6s, step: 0.2s, control_step: 0.1s }
"""
_SEQUENCES: dict[str, tuple[str, ...]] = {
    "runs": (
        "compile table.rl -o c --params params.yaml --emit json",
        "run table.rl -o r --params params.yaml",
        "compile table.rl -o c --params faulty.yaml",
        "run table.rl -o a -n 4 --seed 3 --json",
        "run table.rl -o a -n 6 --seed 3 --resume",
        "run a/scene-0001.json -o again --duration 3",
        "compile table.rl -o d -n 2 --set gap=9m --print-after all --json",
        "compile table.rl -o s -n 5 --emit svg{size:400px},json",
        "compile impossible.rl -o e",
        "compile impossible.rl -o e --json",
        "compile faulty.rl -o e",
        "report a",
    ),
    "failures": (
        "falsify table.rl -o f --evaluations 24 --batch 12 --seed 2 --json",
        "falsify table.rl -o f --evaluations 36 --batch 12 --seed 2 --resume",
        "falsify table.rl -o g --evaluations 36 --with grid --expect quick --failures 2",
        "falsify impossible.rl -o h --evaluations 24 --batch 12",
        "explain f/failures/0001.json",
        "shrink f/failures/0001.json",
        "run f/failures/0001.json -o x",
        "report f",
    ),
    "traces": (
        "run table.rl -o t -n 2 --seed 3",
        'monitor "always (ego.speed < 11)" t/scene-0000.trace.csv',
        'monitor "always[0, 3] (speed < 40km/h)" t/scene-0000.trace.csv --agent ego --json',
        'monitor "eventually[0, 20] (speed > 90)" t/scene-0000.trace.csv t/scene-0001.trace.csv'
        " --agent lead --plot p.svg",
        'monitor "eventually[0.01, 0.02] (speed > 9)" t/scene-0001.trace.csv --agent ego --strict',
        'monitor "always (sped < 11)" t/scene-0000.trace.csv',
        'mine "always (ego.speed < top)" t/scene-0000.trace.csv t/scene-0001.trace.csv'
        " --param top=0..40",
        'mine "always (ego.speed < top)" t/scene-0000.trace.csv --param top=0..5',
        'mine "eventually[0, tau] (ego.x > far)" t/scene-0000.trace.csv --param tau=0..6'
        " --param far=0..90 --front 5 --digits 4 --json",
        'mine "eventually[0, tau] (ego.x > far)" t/scene-0000.trace.csv --param tau=0..6'
        " --param far=0..90 --margin 0.5",
        'mine "always (abs(ego.x - c) > 0.1)" t/scene-0000.trace.csv --param c=0..9',
    ),
    "files": (
        "check faulty.rl table.rl",
        "check faulty.rl --json",
        "check faulty.rl --fix",
        "fmt faulty.rl table.rl --diff",
        "fmt table.rl",
        "fmt table.rl --check",
        "extract bend.png --with contour --scale 0.5 -o b.json --overlay b.svg",
        "extract sketch.png --threshold 0.4 --width 9",
        "extract ring.png --with aerial --through 4,60 --only-through -o r.json",
        "extract nothing.png",
        "plugins --verb piece",
        "plugins show nothing",
        "explain wrong-type",
        "explain 601",
        "schema drive",
    ),
}
SEQUENCES = tuple(_SEQUENCES)
_PICTURES = {"p.svg", "b.svg", "contact-sheet.svg"}
_DOCUMENTS = {"manifest.json", "summary.json", "index.json", "b.json", "r.json"}


def sequence_lines(name: str) -> Iterator[str]:
    """The commands of a sequence, what they print, and the files that there are then."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place).resolve()
        for file, text in (
            ("impossible.rl", _IMPOSSIBLE), ("faulty.rl", _FAULTY), ("table.rl", _TABLE),
            ("params.yaml", _PARAMS), ("faulty.yaml", _FAULTY_PARAMS),
        ):  # fmt: skip
            (folder / file).write_text(text, encoding="utf-8")
        for picture in SCENES.glob("*.png"):
            shutil.copy(picture, folder)
        for line in _SEQUENCES[name]:
            yield f"$ roadlang {line}"
            (words,) = csv.reader([line], delimiter=" ", quotechar='"')
            said = printed(*(_placed(word, folder) for word in words))
            text = "\n".join(said).replace(str(folder), "DIR")
            yield from _said(text)
        for path in sorted(folder.rglob("*")):
            if path.is_file() and path.name != "journal.jsonl":
                lines = _file(path, str(path.relative_to(folder)))
                yield from (line.replace(str(folder), "DIR") for line in lines)


def _placed(word: str, folder: Path) -> str:
    known = (".rl", ".json", ".csv", ".png", ".svg", ".yaml")
    is_folder = word.isalpha() and (len(word) == 1 or word == "again")
    return str(folder / word) if is_folder or word.endswith(known) else word


def _said(text: str) -> Iterator[str]:
    """Printed text; a JSON document in it line by line of its members."""
    head, _, rest = text.partition("\n")
    start = min((place for place in (rest.find("{"), rest.find("[")) if place >= 0), default=-1)
    if start == 0:
        try:
            document, end = json.JSONDecoder().raw_decode(rest)
        except ValueError:
            pass
        else:
            yield head
            if isinstance(document, dict):
                document.pop("time_s", None)
            yield from of_json(document)
            yield from of_text(rest[end:].strip())
            return
    yield from of_text(text)


def _file(file: Path, name: str) -> Iterator[str]:
    text = file.read_bytes().decode("utf-8", "replace")
    yield f"file {name}" + ("" if text.endswith("\n") else " without a last line break")
    if file.suffix == ".csv" and "trace" not in name:
        yield from table_lines(io.StringIO(text, newline="").read())
    elif file.suffix == ".html":
        yield from page_lines(text)
    elif file.name in _DOCUMENTS or file.name.endswith((".explanation.json", ".verdicts.json")):
        document = json.loads(text)
        for key in ("provenance", "time_s"):
            document.pop(key, None)
        yield from of_json(document)
    elif file.name in _PICTURES or name in ("a/scene-0000.drive.svg", "f/failures/0001.svg"):
        yield from of_svg(text)
    elif file.name in ("faulty.rl", "table.rl"):
        yield from of_text(text)
