"""Which parts of a formula have no value between samples."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from . import formulas as f
from . import terms as t
from .evaluation_options import Semantics


def unknown_between_samples(
    formula: f.Formula, semantics: Semantics, constants: Collection[str]
) -> str | None:
    """The text of the first part without a value between samples, None where all of them have one.

    What counts samples has none, nor have products and quotients of signals that are linear.
    `constants` are the variables that are one number.
    """
    if semantics == "sampled":
        return None
    for part in formula.walk():
        if isinstance(part, f.SampleStep | f.Rise | f.Fall | f.Count):
            return str(part)
        if semantics == "linear" and isinstance(part, f.Comparison):
            terms = (*part.left.walk(), *part.right.walk())
            curved = next(filter(lambda term: _is_curved(term, constants), terms), None)
            if curved is not None:
                return str(curved)
    return None


def _is_curved(term: t.Term, constants: Collection[str]) -> bool:
    if not isinstance(term, t.Arithmetic) or term.op in ("+", "-"):
        return False
    left, right = (frozenset(_variables(side)) <= frozenset(constants) for side in term.parts)
    return not ((left and right) or (right and term.op in ("*", "/")) or (left and term.op == "*"))


def _variables(term: t.Term) -> Iterator[str]:
    return (part.name for part in term.walk() if isinstance(part, t.Variable))
