"""`[a, b]` where `a..b` is meant, and the other way round; a value where a list of it is meant; a
road where its name is meant."""

from __future__ import annotations

from ...diagnostics import Fix
from ...ir.dimension import ANGLE
from ...plugins import option_types as opt
from . import expression_types as ty
from .expression_types import TypedExpression
from .matching import matches

_ROAD_AS_ROUTE = (
    "an agent follows the road that it is on without a route; a route leads through a network, "
    "by points and turns: `route: [(0m, 0m), left]`"
)


def other_form(
    typed: TypedExpression, expected: opt.OptionType
) -> tuple[tuple[str, ...], tuple[Fix, ...]]:
    """Help and fix for a value that has the wrong one of the two forms; nothing for others."""
    if isinstance(expected, opt.QuantityType | opt.LikeType) and _is_pair(typed):
        return drawn_between(typed), (Fix(typed.span, _as_range(typed)),)
    if isinstance(expected, opt.IntervalType) and typed.range:
        low, _, high = typed.span.text.partition("..")
        meant = f"[{low.strip()}, {high.strip()}]"
        return (f"`..` draws one value between the two; write `{meant}`",), (
            Fix(typed.span, meant),
        )
    if expected == opt.EntityType(("road",)) and typed.type == ty.DeclaredType("network"):
        name = typed.span.text
        return (f"`road NAME from {name} {{ select: longest }}` makes a road of it",), ()
    if isinstance(expected, opt.CallType) and expected.verb == "select":
        digits = typed.span.text.strip('"')
        meant = f"road({digits})"
        is_id = digits.isdecimal()
        return ((f"write `{meant}`",), (Fix(typed.span, meant),)) if is_id else ((), ())
    if isinstance(expected, opt.TextType) and isinstance(typed.type, ty.DeclaredType):
        meant = f'"{typed.span.text}"'
        return (f"write `{meant}`",), (Fix(typed.span, meant),)
    if isinstance(expected, opt.WordType) and isinstance(typed.type, ty.Quantity):
        is_angle = typed.type.dimension == ANGLE  # of `facing`
        return ((f"write `heading: {typed.span.text}`",) if is_angle else ()), ()
    numbers = [item.span.text for item in typed.items if isinstance(item.type, ty.Quantity)]
    if isinstance(expected, opt.PointType) and isinstance(typed.type, ty.SequenceType):
        meant = f"({', '.join(numbers)})"
        fits = len(numbers) == len(typed.items) == len(expected.parts)
        return ((f"write `{meant}`",), (Fix(typed.span, meant),)) if fits else ((), ())
    return _as_list(typed, expected) if isinstance(expected, opt.ListType) else ((), ())


def drawn_between(typed: TypedExpression) -> tuple[str, ...]:
    """Help for `[a, b]` where a number belongs; none for anything else."""
    if not _is_pair(typed):
        return ()
    return (f"to draw a value between the two, write `{_as_range(typed)}`",)


def _as_range(pair: TypedExpression) -> str:
    low, high = (item.span.text for item in pair.items)
    return f"{low}..{high}"


def _as_list(
    typed: TypedExpression, expected: opt.ListType
) -> tuple[tuple[str, ...], tuple[Fix, ...]]:
    if opt.takes_words(expected.item) and typed.type == ty.DeclaredType("road"):
        return (_ROAD_AS_ROUTE,), ()
    is_point = isinstance(typed.type, ty.CoordinatesType)  # lists of points have several
    if is_point and isinstance(expected.item, opt.PointType):
        return (f"a list of points is written `[{typed.span.text}, (X, Y)]`",), ()
    if not is_point and matches(typed, expected.item):
        meant = f"[{typed.span.text}]"
        words = _words(typed)
        if len(words) > 1:  # a command line
            each = "[" + ", ".join(f'"{word}"' for word in words) + "]"
            return (f"write `{each}`, or `{meant}` for one item",), (Fix(typed.span, each),)
        return (f"write `{meant}`",), (Fix(typed.span, meant),)
    return (), ()


def _words(typed: TypedExpression) -> list[str]:
    """Of a text that is written out, what is between its spaces."""
    text = typed.span.text
    if not isinstance(typed.type, ty.StringType) or text[:1] not in "\"'" or "\\" in text:
        return []
    return text[1:-1].split()


def _is_pair(typed: TypedExpression) -> bool:
    return (
        isinstance(typed.type, ty.SequenceType | ty.CoordinatesType)
        and len(typed.items) == 2
        and all(isinstance(item.type, ty.Quantity) for item in typed.items)
    )
