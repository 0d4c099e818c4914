"""Each page of a syntax error shows a file with that error and no other, and the mended file."""

from __future__ import annotations

import re

import pytest

from roadlang.diagnostics import Source, codes, page
from roadlang.syntax import parse

PAGES = [code for code in codes() if code < "RL100"]
EXAMPLES = [
    (code, kind, text)
    for code in PAGES
    for kind, text in re.findall(r"```roadlang (wrong|right)\n(.*?)\n```", page(code).body, re.S)
]


@pytest.mark.parametrize(("code", "kind", "text"), EXAMPLES)
def test_examples_show_what_they_say(code: str, kind: str, text: str) -> None:
    _, found = parse(Source(f"{code}.rl", text))
    assert [d.code for d in found] == ([code] if kind == "wrong" else [])


def test_every_code_that_can_be_shown_has_an_example() -> None:
    assert sorted({code for code, kind, _ in EXAMPLES if kind == "wrong"} | {"RL029"}) == PAGES
