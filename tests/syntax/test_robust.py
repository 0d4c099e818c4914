"""Whatever the file holds: a tree and diagnostics, never an exception, never a long wait."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from roadlang.diagnostics import Source
from roadlang.diagnostics.render import render_all
from roadlang.syntax import format_file, parse, parse_formula
from tests.syntax.mutations import mutated

SAMPLES = [path.read_text() for path in sorted((Path(__file__).parent / "samples").glob("*.rl"))]
HOPELESS = {
    "parentheses": "let a = " + "(" * 10_000 + "1" + ")" * 10_000,
    "never closed": "let a = " + "(" * 10_000,
    "prefixes": "require a: " + "not " * 10_000 + "b",
    "sums": "let a = 1" + " + 1" * 10_000,
    "members": "let a = b" + ".c" * 10_000,
    "lists": "let a = " + "[" * 10_000 + "]" * 10_000,
    "blocks": "world " + "{ a with b " * 5_000 + " }" * 5_000,
    "foreign characters": "`?@" * 20_000,
    "control characters": "\x00\x01" * 1_000,
}  # fmt: skip
FINE = {
    "long chain": "let a = b" + " and b" * 10_000,
    "long list": "let a = [" + "1, " * 20_000 + "1]",
    "long name": "let " + "a" * 1_000_000 + " = 1",
    "byte order mark": "\ufefflet a = 1\r\n\tlet b = 2\r\n",
    "spaces of a web page": "let a = 1\n\u00a0let b = 2\n\u2003 let c = 3\n",
    "nothing": "",
    "white space": " \n\t\r\n",
}


@pytest.mark.parametrize("text", HOPELESS.values(), ids=HOPELESS)
def test_a_hopeless_file_is_refused(text: str) -> None:
    assert parse(Source("hopeless.rl", text))[1]
    assert parse_formula(Source("hopeless.rl", text))[1]


@pytest.mark.parametrize("text", FINE.values(), ids=FINE)
def test_an_odd_file_is_read(text: str) -> None:
    assert parse(Source("fine.rl", text))[1] == []


def test_a_comment_after_a_space_of_a_web_page_keeps_its_line() -> None:
    text = "let a = 1\n\u00a0# about b\nlet b = 2\n"
    assert format_file(parse(Source("pasted.rl", text))[0]) == "let a = 1\n# about b\nlet b = 2\n"


def test_a_bad_byte_spoils_nothing_around_it() -> None:
    tree, found = parse(Source("nul.rl", "let a = 1\x00\nlet b = 2\n# \udcff\n"))
    assert [d.code for d in found] == ["RL006", "RL006"]
    assert len(tree.statements) == 2


def _damage(count: int, seed: int) -> None:
    rng = random.Random(seed)
    for _ in range(count):
        text = mutated(rng.choice(SAMPLES), rng)
        tree, found = parse(Source("mutant.rl", text))
        render_all(found)
        assert all(d.span and 0 <= d.span.start <= d.span.end <= len(text) for d in found)
        if not found:
            again, more = parse(Source("again.rl", format_file(tree)))
            assert again == tree
            assert not more


def test_damaged_samples_are_survived() -> None:
    _damage(300, seed=1)


@pytest.mark.slow
def test_many_damaged_samples_are_survived() -> None:
    _damage(1_000, seed=2)
