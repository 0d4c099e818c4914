"""What a formula without temporal operators can be worth at a sample that has not been recorded
yet.

Its signals may then have any values, but the same ones throughout the formula. Robustness is a
maximum of minima of affine functions of them, abs, min and max included (a product of signals is
taken for one more signal, within the bounds of interval arithmetic). How high a minimum of affine
functions rises is a linear program, solved here through its dual by enumeration: the dual's corners
have at most one function more than there are signals.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache, reduce
from itertools import combinations

import numpy as np

from ..formula import formulas as f
from ..formula import terms as t
from .interval_arithmetic import term_bounds
from .trace import FloatArray

_MOST_PIECES = 256
_MOST_FUNCTIONS = 14
_OPEN = np.full(1, math.inf)


class TooManyPieces(Exception):
    """The formula has too many cases; any value is then thought possible."""


@dataclass(frozen=True)
class Affine:
    """slopes . signals + offset; the offset is one number per variant, (V,) or (1,)."""

    slopes: tuple[tuple[str, float], ...]
    offset: FloatArray

    def plus(self, other: Affine) -> Affine:
        """The sum of two affine functions."""
        slopes = dict(self.slopes)
        for name, slope in other.slopes:
            slopes[name] = slopes.get(name, 0.0) + slope
        nonzero = tuple(sorted((name, slope) for name, slope in slopes.items() if slope))
        return Affine(nonzero, self.offset + other.offset)

    def times(self, scale: float) -> Affine:
        """The function multiplied by a number."""
        slopes = tuple((name, scale * slope) for name, slope in self.slopes if scale)
        return Affine(slopes, scale * self.offset)


Pieces = tuple[tuple[Affine, ...], ...]
"""The greatest, over the outer tuple, of the least of each inner one."""

Constants = Mapping[str, FloatArray]


def unseen_range(formula: f.Formula, constants: Constants) -> tuple[FloatArray, FloatArray]:
    """(inf, sup) of the robustness of a state formula in normal form, each (V,) or (1,).

    `constants` are the signals that are one number per variant, now and later.
    """
    if constants and not formula.variables.isdisjoint(constants):
        return -_highest(f.Not(formula), constants), _highest(formula, constants)
    return _range_without_constants(formula)


@lru_cache(maxsize=1024)
def _range_without_constants(formula: f.Formula) -> tuple[FloatArray, FloatArray]:
    return -_highest(f.Not(formula), {}), _highest(formula, {})


def _highest(formula: f.Formula, constants: Constants) -> FloatArray:
    try:
        pieces = _formula_pieces(formula, constants)
        return reduce(np.maximum, (_highest_least(piece) for piece in pieces), -_OPEN)
    except TooManyPieces:
        return _OPEN


def _formula_pieces(formula: f.Formula, constants: Constants) -> Pieces:
    match formula:
        case f.Truth(value):
            return ((),) if value else ()
        case f.Not(operand):
            from ..formula.normal_form import normal_form

            return _formula_pieces(normal_form(operand, negated=True), constants)
        case f.LogicalJunction(operands):
            join = _least if formula.least else _greatest
            return join([_formula_pieces(operand, constants) for operand in operands])
        case f.Comparison(op, left, right):
            sides = _term_pieces(left, constants), _term_pieces(right, constants)
            above, below = _difference(*sides), _difference(*sides[::-1])
            if op in (">", ">="):
                return above
            if op in ("<", "<="):
                return below
            return _least([above, below]) if op == "==" else _greatest([above, below])
    raise TypeError(f"not a state formula in normal form: {formula!r}")


def _term_pieces(term: t.Term, constants: Constants) -> Pieces:
    match term:
        case t.Constant(value):
            return ((Affine((), np.full(1, value)),),)
        case t.Variable(name):
            if name in constants:
                return ((Affine((), constants[name]),),)
            return ((Affine(((name, 1.0),), np.zeros(1)),),)
        case t.Negate(operand):
            return _scaled(_term_pieces(operand, constants), -1.0)
        case t.Apply("abs", (argument,)):
            pieces = _term_pieces(argument, constants)
            return _greatest([pieces, _scaled(pieces, -1.0)])
        case t.Apply(function, arguments):
            parts = [_term_pieces(argument, constants) for argument in arguments]
            return _least(parts) if function == "min" else _greatest(parts)
        case t.Arithmetic("+" | "-" as op, left, right):
            join = _sum if op == "+" else _difference
            return join(_term_pieces(left, constants), _term_pieces(right, constants))
        case t.Arithmetic("*", t.Constant(scale), other) | t.Arithmetic(
            "*", other, t.Constant(scale)
        ):
            return _scaled(_term_pieces(other, constants), scale)
        case t.Arithmetic("/", other, t.Constant(divisor)) if divisor:
            return _scaled(_term_pieces(other, constants), 1.0 / divisor)
    return _unknown(term, constants)


def _unknown(term: t.Term, constants: Constants) -> Pieces:
    """A term that is not affine: one more signal, within bounds that hold for all variants."""
    low, high = term_bounds(term, {name: (value, value) for name, value in constants.items()})
    pieces: Pieces = ((Affine(((str(term), 1.0),), np.zeros(1)),),)
    if np.isfinite(low).all():
        pieces = _greatest([pieces, ((Affine((), np.atleast_1d(low)),),)])
    if np.isfinite(high).all():
        pieces = _least([pieces, ((Affine((), np.atleast_1d(high)),),)])
    return pieces


def _sum(left: Pieces, right: Pieces) -> Pieces:
    return _each_pair(left, right, lambda a, b: tuple(x.plus(y) for x in a for y in b))


def _difference(left: Pieces, right: Pieces) -> Pieces:
    return _sum(left, _scaled(right, -1.0))


def _scaled(pieces: Pieces, scale: float) -> Pieces:
    scaled = tuple(tuple(affine.times(scale) for affine in piece) for piece in pieces)
    if scale >= 0:
        return scaled
    return _least([tuple((affine,) for affine in piece) for piece in scaled])


def _greatest(parts: Sequence[Pieces]) -> Pieces:
    return _checked(tuple(piece for part in parts for piece in part))


def _least(parts: Sequence[Pieces]) -> Pieces:
    return reduce(lambda a, b: _each_pair(a, b, lambda x, y: x + y), parts, ((),))


def _each_pair(
    left: Pieces,
    right: Pieces,
    join: Callable[[tuple[Affine, ...], tuple[Affine, ...]], tuple[Affine, ...]],
) -> Pieces:
    if len(left) * len(right) > _MOST_PIECES:
        raise TooManyPieces
    return _checked(tuple(join(a, b) for a in left for b in right))


def _checked(pieces: Pieces) -> Pieces:
    if len(pieces) > _MOST_PIECES or any(len(piece) > _MOST_FUNCTIONS for piece in pieces):
        raise TooManyPieces
    return pieces


def _highest_least(functions: tuple[Affine, ...]) -> FloatArray:
    """sup over the signals of the least of `functions`: the dual's best corner, (V,) or (1,)."""
    names = sorted({name for affine in functions for name, _ in affine.slopes})
    slopes = np.array([[dict(a.slopes).get(name, 0.0) for name in names] for a in functions])
    if not np.isfinite(slopes).all():  # products of constants that overflow: anything may come
        return _OPEN
    best = _OPEN
    for size in range(1, min(len(functions), len(names) + 1) + 1):
        for chosen in combinations(range(len(functions)), size):
            weights = _balance(slopes[list(chosen)])
            if weights is not None:
                offsets = [w * functions[i].offset for w, i in zip(weights, chosen, strict=True)]
                best = np.fmin(best, reduce(np.add, offsets))
    return best


def _balance(slopes: FloatArray) -> FloatArray | None:
    """The only positive weights, adding up to one, that cancel all slopes; None if none do."""
    system = np.vstack([slopes.T, np.ones(len(slopes))])
    target = np.zeros(len(system))
    target[-1] = 1.0
    solution, _, rank, _ = np.linalg.lstsq(system, target, rcond=None)
    weights = np.round(solution, 13)
    unique = rank == len(slopes)
    solved = np.allclose(system @ weights, target, atol=1e-12)
    return weights if unique and solved and (weights > 0).all() else None
