"""What is said of scene files with one fault, and what is made of right ones, in lines."""

from __future__ import annotations

import json
import random
import re
from collections.abc import Iterable, Iterator

from roadlang.diagnostics import Diagnostic
from roadlang.plugins.discovery import registry_of
from roadlang.semantics import check_text
from tests.golden.comparing import SCENES
from tests.golden.scene_views import printed
from tests.golden.summaries import of_json

_TOKEN = re.compile(r'"[^"\n]*"|\w+|\.\.|[^\w\s]|\n')
_OTHERS = ("(", ")", "{", "}", ",", ":", "5m", "3", "main", "always", "<", "with", "1m..2m", '"a"')


def said(found: Diagnostic) -> str:
    """A diagnostic in a line: place, code, message, help, fixes, labels."""
    place = "-"
    if found.span is not None:
        place = f"{found.span.line}:{found.span.column}+{found.span.end - found.span.start}"
    parts = [f"{place} {found.code} {found.message}", *(f"help {help}" for help in found.help)]
    parts += [f"fix {fix.span.column} `{fix.replacement}`" for fix in found.fixes]
    parts += [f"there {label.span.line}:{label.span.column} {label.text}" for label in found.labels]
    return " | ".join(parts)


def fault_lines(name: str, count: int) -> Iterator[str]:
    """One fault after another in a scene file: a token is left out, doubled, changed or moved."""
    path = SCENES / f"{name}.rl"
    text = path.read_text(encoding="utf-8")
    tokens = list(_TOKEN.finditer(text, text.index("scenario")))
    registry = registry_of({})
    rng = random.Random(name)
    for _ in range(count):
        token = rng.choice(tokens)
        old = token.group()
        new = (
            ("", f"{old} {old}", f"{old[:-1]}x", rng.choice(_OTHERS), rng.choice(tokens).group())
        )[rng.randrange(5)]
        damaged = text[: token.start()] + new + text[token.end() :]
        line = text.count("\n", 0, token.start()) + 1
        yield f"line {line}: {old!r} -> {new!r}"
        try:
            _, diagnostics = check_text(damaged, path, {}, registry)
        except RecursionError:
            continue
        for found in diagnostics[:4]:
            yield "  " + said(found).replace(str(SCENES), "SCENES").replace("\n", " / ")


def scenario_lines(name: str) -> Iterator[str]:
    """`roadlang check --scenario`."""
    text = "\n".join(printed("check", "--scenario", str(SCENES / f"{name}.rl")))
    code, _, document = text.partition("\n")
    yield code
    found, end = json.JSONDecoder().raw_decode(document)
    yield from of_json(found)
    yield from document[end:].strip().splitlines()


def command_output(commands: Iterable[tuple[str, ...]]) -> Iterator[str]:
    """What commands print, one after another."""
    for words in commands:
        yield f"$ roadlang {' '.join(words)}"
        yield from printed(*(str(SCENES / w) if w.endswith(".rl") else w for w in words))


def kind_lines() -> Iterator[str]:
    """Every kind that ships, and its options with their types, defaults, bounds and help."""
    text = "\n".join(printed("plugins", "--json"))
    for kind in json.loads(text.partition("\n")[2])["kinds"]:
        if kind["distribution"] != "roadlang":
            continue
        yield f"{kind['verb']} {kind['qualified']}: {kind['help']}"
        for option in kind["options"]:
            needed = "required" if option["required"] else f"= {option['default']}"
            known = f"{option['type']} {needed} {option['bounds']} {option['words']}"
            yield f"  {option['name']}: {known} {option['help']}"
