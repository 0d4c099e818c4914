"""What is said of habits from other languages, and of the same texts with a token less, more or
other, in lines."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator

from roadlang.diagnostics import Source
from roadlang.plugins.discovery import registry_of
from roadlang.semantics import check_text
from roadlang.syntax import parse
from roadlang.syntax.recovery.foreign_notation import SYMBOLS
from tests.golden.comparing import SCENES
from tests.golden.language_views import said
from tests.semantics.habit_statements import EGO, ROAD
from tests.semantics.habits import HABITS
from tests.syntax.test_mistakes import FAULTS, SAMPLES

_TOKEN = re.compile(r'"[^"\n]*"|[\w.]+|\.\.|[^\w\s]')
_COMMANDS = (
    *("leq", "le", "leqslant", "lt", "geq", "ge", "geqslant", "gt", "neq", "ne", "cdot", "times"),
    *("infty", "top", "bot", "Box", "square", "Diamond", "lozenge", "bigcirc", "neg", "lnot"),
    *("land", "wedge", "lor", "vee", "to", "rightarrow", "Rightarrow", "implies", "iff"),
    *("leftrightarrow", "mathcal", "mathbf", "mathrm", "text", "operatorname", "alpha", "quad"),
    *("left", "right", "bigl", "bigr", "mathcal{U}", "mathbf{G}", "text{F}", "mathit{S}"),
)
_OTHERS = (
    "(",
    ")",
    "{",
    "}",
    "[",
    ",",
    ":",
    "=",
    "5m",
    "main",
    "with",
    "..",
    "and",
    "-",
    '"a"',
    "5",
)
_MORE = (
    r"require r: \Box_{[0,10]} (p \rightarrow \Diamond q)",
    r"require r: G_{[0,10]} (e_{1} < 10m) \land \neg F_{\left[0, 5\right]} (p)",
    r"require r: \varphi \vee \mathbf{G} (x \leq 3m) \wedge y \geq 2",
    "require r: □[0m, 5m] (p) ∧ ◇ q → ¬ r",
    "require r: always[0s..5s] (p) and eventually[5s] (q)",
    "require r: always(0s, 5s) (p)",
    "require r: G e1 < 10m",
    "require r: G_[0, 10] (e1 < 10m)",
    "require always (p)",
    "require r always (p)",
    "require r: p =< 3m and q => 4m and s <> 5",
    "require r: 3m < x < 5m",
    "require r: x = 3m and y == 4m",
    "param w = 2 ** 3 + x^2",
    "param w = |x| + x.abs()",
    "param w = .5m + 5.m + 1,5m + 5 m + 5 %",
    "param w = 0m...5m",
    "param w = 1'000m + 1_000m + 1e3 m + 0x10",
    "param w = {1m: 2, 3m: 1}",
    "param w = Discrete({1m: 2, 3m: 1})",
    "param w: float = 3m",
    "param float reach = 8m",
    "let w == 3m; let v = 4m;",
    "let é = 3m",
    "road a from b { lanes 2 width = 7m color: #2e7d32 }",
    "road a from b { // no comment\n  lanes: 2 /* more */\n}",
    "road a from b { lanes }",
    "road a from b { scale: 8m/px px, count 5 }",
    "road a from b { perturb sine { amplitude: 3m }, perturb: sine }",
    "road a from b { width:\n  lanes: 2\n}\n",
    "road a from b { width: (3m + 4m\n  lanes: 2\n}\n",
    "road a from b {\n  width: 3m\nroad c from d\n",
    "road a from b } lanes: 2 }",
    'image photo from """\n..#..\n##',
    'image photo from "a\\qb.png" { scale: 1m/px }',
    "include street.rl",
    "override agent ego { speed: 3m/s }",
    "behavior drives { speed: 3m/s }",
    "agent traffic is 300 of car on main at random",
    "agents cars is car on main { count: 3 }",
    "300 of car on main",
    "agent ego is car at 5m on main",
    "agent ego is car on main 5m",
    "agent ego is car main at 5m",
    "agent ego is car at main 5m",
    "agent ego is car at 5m of main",
    "agent ego is car on main at 40m, 32m",
    "agent ego is car on main at 20m ahead of lead by 3m",
    "agent image is car on main at 5m",
    "scenario hairpin A bend",
    'scenario "A bend"',
    "network town = photo",
    "emitt json",
    "emit json emit svg",
    "emit json with { size: 3px }",
    "world { time_of_day: 14:30, rain: 0.4 to 0.9 }",
    "param w = 1,5m",
    "param w = 3m\nparam v = 1 ,5m",
    "road a from b { width: 7,5m }",
    "param w = 5. m",
    "param w = 5.m",
    "param w = .5m",
    "param w = 5 %",
    "param w = 5 \t % of it",
    "param w = (5) %",
    "% w",
    "param w = [#2e7d32, #abcdef, #12345, #123456 ]",
    "param w = f(#2e7d32) + g(a, #AABBCC)",
    "param w = #fff\nparam v = 3",
    "road a from b { color: #fff, width: 3m }",
    "param größe = 3m\nparam v = größe + ähm",
    "param w = 3€ + 4m",
    "param w = a ¿¿¿ b",
    "param w = a \u200b\u200b b",
    "param w = a ? b : c",
    "param w = 'text'",
    "param w = 'text",
    "param w = `text`",
    "param w = a /* b */ + c",
    "param w = a /* b",
    "param w = a // b",
    "param w = 3m; param v = 4m;",
    'image i from """"',
    "agent ego is car on main at 20m ahead of lead by 7m",
    "agent ego is car on main at ahead lead by 7m",
    "object tree is tree at ego behind lead",
)


def habit_lines(edits: int) -> Iterator[str]:
    """Each text as it is, and with `edits` changes of one token each."""
    for symbol in SYMBOLS:
        yield from _parsed(f"require r: p {symbol} q {symbol}{symbol} s")
    for command in _COMMANDS:
        yield from _parsed(rf"require r: p \{command} q \{command}{{x}}_{{[1, 2]}}")
    for text in [*dict.fromkeys(written for written, *_ in HABITS), *_MORE]:
        yield from _parsed(text)
        for changed in edited(text, edits):
            yield from _parsed(changed)


def checked_habit_lines(edits: int) -> Iterator[str]:
    """The same, checked with a road and an agent before it."""
    registry = registry_of({})
    for text in [*dict.fromkeys(written for written, *_ in HABITS), *_MORE]:
        for changed in (text, *edited(text, edits)):
            before = ROAD if "agent ego" in text else ROAD + EGO
            _, diagnostics = check_text(before + changed, SCENES / "a.rl", {}, registry)
            yield f"> {changed!r}"
            for found in diagnostics[:3]:
                yield "  " + said(found).replace(str(SCENES), "SCENES").replace("\n", " / ")


def fault_of_sample_lines(edits: int) -> Iterator[str]:
    """The faults of the samples, and samples with another change of a token nearby."""
    for sample, written, instead, *_ in FAULTS:
        text = (SAMPLES / f"{sample}.rl").read_text(encoding="utf-8")
        start = text.index(written)
        begin, end = text.rfind("\n", 0, start) + 1, text.find("\n", start + len(written))
        part = text[begin:end].replace(written, instead, 1)
        yield from _parsed(part)
        for changed in edited(part, edits):
            yield from _parsed(changed)


def edited(text: str, edits: int) -> Iterator[str]:
    """The text with a token less, doubled, cut short, turned around or replaced."""
    tokens, rng = list(_TOKEN.finditer(text)), random.Random(text)
    for token in rng.sample(tokens, min(edits, len(tokens))):
        old = token.group()
        new = rng.choice(("", f"{old} {old}", rng.choice(_OTHERS), old[:-1], old[::-1]))
        yield text[: token.start()] + new + text[token.end() :]


def _parsed(text: str) -> Iterator[str]:
    tree, diagnostics = parse(Source("a.rl", f"{text}\nlet after = 1m\n"))
    yield f"> {text!r}: {len(tree.statements)} statements"
    for found in diagnostics[:4]:
        yield "  " + said(found).replace("\n", " / ")
