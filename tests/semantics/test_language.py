"""The language tests: scene files in Markdown, with the errors expected of each line.

A block ```roadlang is checked; `# error: 8 [RL201]` at the end of a line expects that code at
column 8 of it, and nothing that is not expected may be reported; `# error: 8 [RL202] fix: 3m`
expects the fix as well, `fix: 3deg | 3rad` both of two. A block with a file name
behind `roadlang` is a file that the next block may include. `# --set reach=12s` sets a param.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import pytest

from roadlang.plugins.discovery import load_registry
from roadlang.plugins.registry import Registry
from roadlang.semantics import check_text

_FENCE = re.compile(r"^```roadlang ?(\S*)\n(.*?)^```", re.DOTALL | re.MULTILINE)
_EXPECTED = re.compile(
    r"# (error|warning): (\d+) \[(RL\d{3})\](?: fix: (.*?)(?=\s*(?:# error|# warning|$)))?"
)
_SETTING = re.compile(r"^# --set (\w+)=(.*?)\s*(?:# |$)")
_HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)


@dataclass(frozen=True)
class Example:
    title: str
    text: str
    files: tuple[tuple[str, str], ...]


@cache
def registry() -> Registry:
    return load_registry()


def _examples() -> list[Example]:
    examples = []
    for path in sorted(Path(__file__).parent.glob("*.md")):
        text = path.read_text()
        files: list[tuple[str, str]] = []
        for number, match in enumerate(_FENCE.finditer(text)):
            name, block = match.groups()
            if name:
                files.append((name, block))
                continue
            heading = _HEADING.findall(text[: match.start()])[-1]
            title = f"{path.stem}: {heading} {number}"
            examples.append(Example(title, block, tuple(files)))
            files = []
    return examples


def _expected(name: str, text: str) -> list[tuple[str, int, int, str, str, str]]:
    expected = []
    for number, line in enumerate(text.splitlines(), start=1):
        setting = _SETTING.match(line)
        for severity, column, code, fixes in _EXPECTED.findall(line):
            file, at = (f"--set {setting[1]}", 1) if setting else (name, number)
            expected.append((file, at, int(column), severity, code, fixes))
    return expected


@pytest.mark.parametrize("example", _examples(), ids=lambda example: example.title)
def test_example(example: Example, tmp_path: Path) -> None:
    for name, text in example.files:
        (tmp_path / name).write_text(text)
    settings = (_SETTING.match(line) for line in example.text.splitlines())
    overrides = {match[1]: match[2] for match in settings if match}
    scenario, found = check_text(example.text, tmp_path / "scene.rl", overrides, registry())
    reported = []
    for diagnostic in found:
        span = diagnostic.span
        assert span is not None
        file = Path(span.source.path).name
        fixes = " | ".join(fix.replacement for fix in diagnostic.fixes)
        place = (file, span.line, span.column)
        reported.append((*place, diagnostic.severity, diagnostic.code, fixes))
    expected = _expected("scene.rl", example.text)
    for name, text in example.files:
        expected += _expected(name, text)
    assert sorted(reported) == sorted(expected), [d.message for d in found]
    assert (scenario is None) == any(diagnostic.is_error for diagnostic in found)
