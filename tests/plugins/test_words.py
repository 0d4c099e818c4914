"""Words of options that are no names are written in quotes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

import pytest

from roadlang import testing
from roadlang.api import Backend, Length, Scene, option

TEXT = """\
road main { draw with waypoints { points: [(0m, 0m), (100m, 0m)] } }
emit drawing { OPTION }
"""


@dataclass(frozen=True)
class Drawing(Backend):
    """A drawing."""

    name: ClassVar[str] = "drawing"
    version: Literal["1.7", "1.8", "draft"] = option("1.8", help="version of the format")
    margin: Length | Literal["as needed"] = option(1.0, help="around the roads")

    def files(self, scene: Scene) -> dict[str, str]:
        return {"txt": f"{self.version} {self.margin}"}


@pytest.mark.parametrize("written", ['version: "1.7"', "version: draft", 'margin: "as needed"'])
def test_a_word_is_written_bare_or_in_quotes(written: str) -> None:
    assert not testing.check(TEXT.replace("OPTION", written), kinds=[Drawing])


@pytest.mark.parametrize(
    ("written", "fix"), [("version: 1.8", '"1.8"'), ('version: "1.9"', '"1.7"')]
)
def test_a_near_word_is_fixed_with_quotes(written: str, fix: str) -> None:
    (found,) = testing.check(TEXT.replace("OPTION", written), kinds=[Drawing])
    assert [f.replacement for f in found.fixes] == [fix]
    assert '`"1.7"`, `"1.8"`, `draft`' in f"{found.message} {found.help}"
