"""Diagnostics for names that are not declared."""

from __future__ import annotations

from ...diagnostics import Code, KnownNames, nearest
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..quoted_words import word_help
from ..suggestions import meant_name
from ..types.expression_types import TypedExpression, unknown
from .habits import is_side_as_lane, monitor_help, name_help
from .kinds import MOST_LISTED, find_kind

_FLAGS = {"yes": "true", "no": "false", "true": "true", "false": "false", "off": "false"}


def report_unresolved(checker: Checker, name: ast.Name, context: Context) -> TypedExpression:
    """RL101, or what is wrong with the name as a word or kind of an option."""
    if checker.program.incomplete and not (context.words or context.verbs):
        return unknown(name.span)
    declared = nearest(name.text, _fitting_names(checker, context)) or nearest(
        name.text, checker.program.declarations
    )
    if declared == context.user and context.verbs:
        declared = None  # `object zebra is zebra_crossing` does not mean itself
    kinds = [kind for verb in context.verbs for kind in checker.registry.names(verb)]
    words = (*context.words, *kinds)
    word = meant_name(name.text, words)
    if context.words and (word or not (declared or is_side_as_lane(name, context))):
        listed = ", ".join(f"`{word}`" for word in words)
        return checker.report(
            Code.UNKNOWN_OPTION_VALUE,
            name.span,
            word=name.text,
            help=f"the words are {listed}",
            meant=word,
        )
    if context.verbs and not context.words:
        verb = context.verbs[0]
        if not declared or nearest(name.text, checker.registry.names(verb)):
            find_kind(checker, verb, name.text, name.span)
            return unknown(name.span)
    return _report_unknown(checker, name, declared or _FLAGS.get(name.text.lower()), context)


def _report_unknown(
    checker: Checker, name: ast.Name, meant: str | None, context: Context
) -> TypedExpression:
    habit = name_help(checker, name, context)
    if habit is not None:
        help_, fixes = habit
        return checker.report(Code.UNKNOWN_NAME, name.span, name=name.text, help=help_, fixes=fixes)
    about = (
        () if meant else _about_functions(checker, name.text) or _declared_names(checker, context)
    )
    if not meant:
        about = (*about, *word_help(checker.program.declarations.get(context.user), name.text))
    if "image" in context.roles and not meant:
        about = (*about, f'`image {name.text} from "FILE"` declares a picture')
    return checker.report(Code.UNKNOWN_NAME, name.span, name=name.text, help=about, meant=meant)


def _about_functions(checker: Checker, text: str) -> tuple[str, ...]:
    if checker.registry.has("lane", text):
        return (f"a lane is chosen in the block: `on ROAD at 20m {{ lane: {text} }}`",)
    if checker.registry.has("monitor", text):
        return (monitor_help(text),)
    if not any(checker.registry.has(verb, text) for verb in ("signal", "number")):
        return ()
    return (f"`{text}` is a function: write what it is of, as in `{text}(road)`",)


def _declared_names(checker: Checker, context: Context) -> tuple[str, ...]:
    """What the scene declares that fits, as far as it can be taken in at a glance."""
    names = [name for name in _fitting_names(checker, context).names if name != context.user]
    if not names and not context.roles:
        return ()
    if not names:
        own = checker.program.declarations.get(context.user)
        none = "no other" if own is not None and own.role in context.roles else "no"
        return (f"this scene declares {none} {' or '.join(context.roles)}",)
    shown = ", ".join(f"`{name}`" for name in names[:MOST_LISTED])
    more = f" and {len(names) - MOST_LISTED} more" if len(names) > MOST_LISTED else ""
    return (f"this scene declares {shown}{more}",)


def _fitting_names(checker: Checker, context: Context) -> KnownNames:
    roles = context.roles
    known = checker.names_of_roles.get(roles)
    if known is None:
        known = KnownNames(
            name
            for name, found in checker.program.declarations.items()
            if (found.role in roles if roles else found.role not in ("require", "expect"))
        )
        checker.names_of_roles[roles] = known
    return known
