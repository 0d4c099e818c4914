"""Every place that reports a diagnostic passes exactly what the message of its page shows."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from string import Formatter

from roadlang.diagnostics import Code, codes, page

ROOT = Path(__file__).parents[2]
FOLDERS = ("src/roadlang", "plugins/standard", "plugins/godot", "plugins/formats")
REPORTING = {"diagnose", "report", "_report", "fault", "_fault", "stl_error"}
"""Functions that take a code, and the values of its message as keywords."""

FORWARDING = {"_refusal", "_refused"}
"""Functions of one module that take a code and add values of their own."""

CHOSEN_BEFORE = {"RL215", "RL430"}
"""Codes that are stored in a variable before they are reported."""

NOT_VALUES = {"span", "help", "labels", "fixes", "severity", "meant"}
"""Keywords of these functions that are not shown in the message."""


def placeholders(message: str) -> set[str]:
    fields = (name for _, name, _, _ in Formatter().parse(message) if name)
    return {name.partition(".")[0] for name in fields}


def codes_in(argument: ast.expr) -> list[str]:
    """The codes that an argument may be: `Code.X`, or one of two."""
    if isinstance(argument, ast.IfExp):
        return codes_in(argument.body) + codes_in(argument.orelse)
    if isinstance(argument, ast.Attribute) and isinstance(argument.value, ast.Name):
        return [argument.attr] if argument.value.id == "Code" else []
    return []


@cache
def call_sites() -> list[tuple[str, str, str, set[str | None]]]:
    """File and line, function, code and keywords of every call with a code."""
    return list(_call_sites())


def _call_sites() -> Iterator[tuple[str, str, str, set[str | None]]]:
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.py")):
            text = path.read_text(encoding="utf-8")
            for node in ast.walk(ast.parse(text)) if "Code." in text else ():
                if isinstance(node, ast.Call) and node.args:
                    function = node.func
                    name = function.attr if isinstance(function, ast.Attribute) else ""
                    name = function.id if isinstance(function, ast.Name) else name
                    keywords = {keyword.arg for keyword in node.keywords}
                    for code in codes_in(node.args[0]):
                        place = f"{path.relative_to(ROOT)}:{node.lineno}"
                        yield place, name, code, keywords


def test_the_call_sites_are_found() -> None:
    assert len(call_sites()) > 250
    assert {name for _, name, _, _ in call_sites()} - {"exit_code_of"} <= REPORTING | FORWARDING


def test_a_call_passes_the_values_that_the_message_shows() -> None:
    for place, name, code, keywords in call_sites():
        shown = placeholders(page(getattr(Code, code)).message)
        # A message may show the path, which is also where the diagnostic points.
        passed = keywords - NOT_VALUES - ({"path"} - shown)
        assert name not in REPORTING or passed == shown, f"{place}: {code} shows {sorted(shown)}"


def test_every_page_is_reported_somewhere() -> None:
    used = {getattr(Code, code) for _, _, code, _ in call_sites()}
    assert set(codes()) - used <= CHOSEN_BEFORE
