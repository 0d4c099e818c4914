"""Whether a value is of the sort that an option takes, whatever its unit and bounds."""

from __future__ import annotations

from ...plugins import option_types as opt
from . import expression_types as ty
from .expression_types import TypedExpression


def matches(typed: TypedExpression, expected: opt.OptionType) -> bool:
    """Whether the sort of value is right; units and limits are looked at afterwards."""
    kind = typed.type
    match expected:
        case opt.QuantityType() | opt.LikeType():
            return isinstance(kind, ty.Quantity)
        case opt.FlagType():
            return isinstance(kind, ty.BooleanType)
        case opt.TextType() | opt.FileType() | opt.WordType():
            return isinstance(kind, ty.StringType)
        case opt.ListType() | opt.IntervalType():
            return isinstance(kind, ty.SequenceType)
        case opt.PointType():
            return isinstance(kind, ty.CoordinatesType)
        case opt.EntityType(roles):
            return isinstance(kind, ty.DeclaredType) and kind.role in roles
        case opt.NamesType(word) if isinstance(kind, ty.ConstraintType):
            return word in ("", kind.word)
        case opt.NamesType():
            return isinstance(kind, ty.SequenceType)
        case opt.CallType(verb) | opt.KindNameType(verb):
            return isinstance(kind, ty.KindCallType) and kind.verb == verb
        case opt.MapType() | opt.RecordType():
            return isinstance(kind, ty.MappingType)
        case opt.ConditionType():
            return isinstance(kind, ty.FormulaType | ty.BooleanType)
        case opt.AnyType():
            return typed.value is not None
        case opt.UnionType(alternatives):
            return any(matches(typed, part) for part in alternatives)
