"""Kinds that do what they should not, and what is reported then."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
import pytest

from roadlang import testing
from roadlang.api import (
    Backend,
    Diagnostic,
    DiagnosticError,
    Distribution,
    Extractor,
    Kind,
    Like,
    Perturber,
    option,
)
from tests.straight_road import STRAIGHT

PICTURE = 'image plan from """\n####\n""" { scale: 8m/px, legend: { "#": road } }\n'
FOUND = PICTURE + "network town from plan { extract with odd }\nroad main from town\n"
BENT = STRAIGHT + "road bent from main { perturb with odd }\n"
LINE = np.array([(0.0, 0.0), (3.0, 0.0)])


def fault(text: str, *kinds: type[Kind], n: int = 1, folder: Path = Path()) -> Diagnostic:
    """The one thing that is wrong with the scenes of a text."""
    with pytest.raises(DiagnosticError) as caught:
        testing.sample(text, n, kinds=kinds, folder=folder)
    [found] = caught.value.diagnostics
    return found


def extractor(extract: Callable[[Any], Any]) -> type[Extractor]:
    @dataclass(frozen=True)
    class Odd(Extractor):
        """Extracts as it is told to."""

        name: ClassVar[str] = "odd"

        def extract(self, picture: Any) -> Any:
            return extract(picture)

    return Odd


def perturber(displacement: Callable[[Any], Any]) -> type[Perturber]:
    @dataclass(frozen=True)
    class Odd(Perturber):
        """Displaces as it is told to."""

        name: ClassVar[str] = "odd"

        def displacement(self, road: Any, random: Any) -> Any:
            return displacement(road)

    return Odd


def distribution(quantile: Callable[[Any], Any]) -> type[Distribution]:
    @dataclass(frozen=True)
    class Odd(Distribution):
        """Draws as it is told to."""

        name: ClassVar[str] = "odd"
        low: Like = option()

        def quantile(self, uniform: Any) -> Any:
            return quantile(uniform)

    return Odd


def backend(**methods: Any) -> type[Backend]:
    members = {name: (lambda gives: lambda self, _: gives)(g) for name, g in methods.items()}
    annotations = {"name": ClassVar[str]}
    body = {"name": "odd", "__doc__": "Odd.", "__annotations__": annotations, **members}
    return dataclass(frozen=True)(type("Odd", (Backend,), body))


def raising(error: BaseException) -> Callable[[Any], Any]:
    def fail(_: Any) -> Any:
        raise error

    return fail
