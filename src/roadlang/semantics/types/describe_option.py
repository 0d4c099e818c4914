"""What an option takes, in words."""

from __future__ import annotations

from collections.abc import Iterable

from ...plugins import option_types as opt
from ...plugins.describing import with_article, word_text

_CALLS = {
    "piece": "a piece of a road, such as `straight(80m)`",
    "select": "a way to choose a road",
    "region": "a region, such as `box((0m, 0m), (200m, 100m))`",
    "position": "a position, such as `ahead_of(ego, 20m)`",
    "lane": "a lane, such as `drive(3.25m)`",
}


def describe(expected: opt.OptionType, words: Iterable[str] = ()) -> str:
    """`a length`, `a list`, `one of clear, rain`: for messages and tables."""
    named = ", ".join(f"`{word_text(word)}`" for word in words)
    if isinstance(expected, opt.WordType):
        return f"one of {named}"
    if opt.is_list_of_words(expected):
        return f"a list of words among {named}"
    text = _describe(expected)
    return f"{text}, or {named}" if named else text


def _describe(expected: opt.OptionType) -> str:
    match expected:
        case opt.QuantityType(dimension, whole):
            return "an integer" if whole else str(dimension)
        case opt.LikeType():
            return "a number"
        case opt.FlagType():
            return "`true` or `false`"
        case opt.TextType():
            return "a string"
        case opt.FileType():
            return "a string that names a file"
        case opt.WordType():
            return "a word"
        case opt.ListType(item):
            return f"a list in which each item is {_describe(item)}"
        case opt.IntervalType():
            return "an interval `[low, high]`"
        case opt.PointType(dimension, second) if second is not None:
            return f"a pair `(a, b)` in {dimension.unit} and {second.unit}"
        case opt.PointType(dimension, in_space=True):
            return f"a point `(x, y, z)` in {dimension.unit or 'dimensionless numbers'}"
        case opt.PointType(dimension):
            return f"a point `(x, y)` in {dimension.unit or 'dimensionless numbers'}"
        case opt.EntityType(roles):
            return "the name of " + " or ".join(map(with_article, roles))
        case opt.NamesType(word):
            which = f"an `{word}`" if word else "a `require` or `expect`"
            return f"the name of {which}, or a list of such"
        case opt.CallType(verb):
            return _CALLS.get(verb, f"a kind of {verb}")
        case opt.KindNameType(verb):
            return f"a kind of {verb}"
        case opt.MapType() | opt.RecordType():
            return "a map `{ key: value }`"
        case opt.ConditionType():
            return "a condition on the drive"
        case opt.AnyType():
            return "a value"
        case opt.UnionType(alternatives):
            parts = [part for part in alternatives if part != opt.WordType()]  # named at the end
            return " or ".join(_describe(part) for part in parts)
