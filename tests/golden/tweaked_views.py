"""Scene files with one number or word changed: what is said of them, or where things then are."""

from __future__ import annotations

import json
import random
import re
from collections.abc import Iterator

from roadlang import DiagnosticError, LoadedScenario, NoSceneError
from roadlang.plugins.discovery import registry_of
from tests.golden.comparing import SCENES
from tests.golden.scene_views import SEED
from tests.golden.summaries import array

_NUMBER = re.compile(r"(?<![\w.#\"])\d+(?:\.\d+)?(?=[a-z%/,) \]}\n.])")
_SWAPS = (
    ("left", "right"), ("forward", "back"), ("lanes: 2", "lanes: 5"), ("true", "false"),
    ("spline", "polyline"), ("random", "(45m, 40m)"), ("is car", "is truck"), ("at", "at 3m +"),
)  # fmt: skip
_FACTORS = (0.0, 0.3, 2.7, -1.0, 30.0)


def _variants(text: str, rng: random.Random) -> Iterator[tuple[str, str]]:
    """Texts with one change, and what it is; without end."""
    numbers = list(_NUMBER.finditer(text, text.index("scenario")))
    while True:
        if rng.random() < 0.2:
            old, new = rng.choice(_SWAPS)
            old, new = rng.choice([(old, new), (new, old)])
            found = list(re.finditer(rf"\b{re.escape(old)}\b", text))
            if not found:
                continue
            match = rng.choice(found)
        else:
            match = rng.choice(numbers)
            new = f"{float(match.group()) * rng.choice(_FACTORS):g}"
        line = text.count("\n", 0, match.start()) + 1
        said = f"line {line}: {match.group()} -> {new}"
        yield text[: match.start()] + new + text[match.end() :], said


def tweaked_lines(name: str, count: int, drive: bool = False) -> Iterator[str]:
    """`count` changes of a scene file, each compiled, and with `drive` driven for 5 s."""
    path = SCENES / f"{name}.rl"
    registry = registry_of({})
    written = path.read_text(encoding="utf-8")
    few = "" if "sample with" in written else "sample with random { attempts: 30 }\n"
    variants = _variants(written + few, random.Random(f"{name} {drive}" if drive else name))
    for _, (text, said) in zip(range(count), variants, strict=False):
        yield said
        try:
            scenes = LoadedScenario(text, path, {}, registry).sample(1, seed=SEED)
        except NoSceneError as error:
            refusal = str(error).replace(str(SCENES), "SCENES").replace("\n", " / ")
            yield f"  no scene: {refusal}"[:400]
        except DiagnosticError as error:
            for found in error.diagnostics[:2]:
                place = f"{found.span.line}:{found.span.column}" if found.span else "-"
                help = " / ".join(found.help)
                yield f"  {place} {found.code} {found.message} / {help}".replace("\n", " / ")
        else:
            for found in scenes.diagnostics:
                yield f"  {found.code} {found.message}"
            record = json.loads(scenes[0].to_json())
            for road in record["roads"][:8]:
                points = [v for pair in zip(road["x"], road["y"], strict=True) for v in pair]
                yield f"  {road['name']}: {array(points)} width {array(road['width'])}"
            things = [*record["agents"], *record["objects"]]
            yield f"  things: {array([one[k] for one in things for k in ('x', 'y', 'heading')])}"
            if drive:
                driven = scenes[0].run(duration=5.0)
                for key, column in driven.to_dict().items():
                    yield f"  {key}: {array([float(v) for v in column])}"
                values = [verdict.robustness for verdict in driven.verdicts.values()]
                yield f"  {array([float('nan') if v is None else v for v in values])}"
            for kind in ("requirements", "expectations"):
                values = [one["robustness"] for one in record[kind]]
                yield f"  {kind}: {array([float('nan') if v is None else v for v in values])}"
