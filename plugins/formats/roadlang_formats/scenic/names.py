"""Names of agents and objects as names of variables."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable

_WORDS = frozenset(
    re.findall(
        r"\w+",
        """
        abort above after ahead along altitude always angle apparent at away back behavior behind
        below beyond bottom by can choose compose deg distance do ego eventually facing final
        following for from front globalParameters heading implies in initial interrupt intersects
        invariant left localPath model monitor mutate network new next of offset on override param
        position precondition record relative require resample right road scenario seconds see self
        setup shuffle simulation simulator steps take terminate to top toward try until using
        visible wait when with workspace
        """,
    )
)
"""Words of Scenic, and names of its driving model that a program often uses."""


def variable_names(names: Iterable[str]) -> dict[str, str]:
    """A variable for each of the names: `cars[0]` becomes `cars_0`."""
    found: dict[str, str] = {}
    used: set[str] = set()
    for name in names:
        word = re.sub(r"\W+", "_", name, flags=re.ASCII).strip("_") or "thing"
        if not word[0].isalpha() or word in _WORDS or keyword.iskeyword(word):
            word = f"the_{word}"
        variable, number = word, 2
        while variable in used:
            variable, number = f"{word}_{number}", number + 1
        used.add(variable)
        found[name] = variable
    return found
