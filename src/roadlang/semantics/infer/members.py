"""What follows a dot: `ego.speed`, `lead.start`, `acme.robot`."""

from __future__ import annotations

from ...diagnostics import Code
from ...ir.values import Entity
from ...syntax.tree import nodes as ast
from ..checker import Checker, ResolvedKind
from ..context import Context
from ..suggestions import meant_name
from ..types.assignable import check_assignable
from ..types.expression_types import DeclaredType, TypedExpression, unknown
from .calls import dotted, is_member, of_kind, signature, takes_role
from .habits import member_help
from .inherited_roads import road_of
from .kinds import find_kind, loaded, verbs_with
from .option_binding import BoundOptions
from .signals import measured

_VERBS = ("drive_signal", "number")


def infer_member(checker: Checker, member: ast.Member, context: Context) -> TypedExpression:
    """A signal or number of an agent or object, or a kind by its whole name."""
    parts = dotted(member)
    if parts is None:
        return checker.report(
            Code.UNDEFINED_SIGNAL, member.name.span, name=member.name.text, given="a call"
        )
    base, name = _split(parts, checker)
    if base in checker.program.spoiled:
        return unknown(member.span)
    if base not in checker.program.declarations:
        return _of_nothing(checker, member, parts, base, context)
    root: ast.Expression = member
    while isinstance(root, ast.Member):
        root = root.of
    owner = checker.infer(root, context)
    if owner.is_unknown:
        return unknown(member.span)
    if not isinstance(owner.type, DeclaredType) or owner.type.role not in ("agent", "object"):
        function = any(checker.registry.has(verb, name) for verb in ("signal", "number"))
        of_agents = bool(verbs_with(checker, _VERBS, name))
        help_ = f"agents have it, as in `ego.{name}`" if of_agents else ()
        help_ = f"write `{name}({base})`" if function else help_
        return checker.report(
            Code.NO_MEMBERS, member.name.span, name=base, found=owner.type, member=name, help=help_
        )
    written = owner.value.text if isinstance(owner.value, Entity) else base
    return _of_actor(checker, member, base, written, name, owner)


def _split(parts: str, checker: Checker) -> tuple[str, str]:
    """The declared name at the front, which has dots for what is included as a name; the rest."""
    words = parts.split(".")
    for count in range(len(words) - 1, 0, -1):
        base = ".".join(words[:count])
        if base in checker.program.declarations or base in checker.program.spoiled:
            return base, ".".join(words[count:])
    return words[0], ".".join(words[1:])


def _of_nothing(
    checker: Checker, member: ast.Member, parts: str, base: str, context: Context
) -> TypedExpression:
    """The first name is not declared: perhaps it is a plugin's."""
    if checker.program.incomplete:
        return unknown(member.span)
    for verb in checker.registry.shipped_first((*context.verbs, "agent", "object"), parts):
        return of_kind(
            checker, ast.CallExpression(member, (), span=member.span), verb, parts, context
        )
    if context.verbs:
        find_kind(checker, context.verbs[0], parts, member.span)
        return unknown(member.span)
    front: ast.Expression = member
    while isinstance(front, ast.Member | ast.Numbered):
        front = front.of
    declared = checker.program.declarations
    included = {name.split(".")[0]: None for name in declared if "." in name}
    meant = meant_name(base, [*declared, *included])
    return checker.report(Code.UNKNOWN_NAME, front.span, name=base, meant=meant)


def _of_actor(
    checker: Checker,
    member: ast.Member,
    base: str,
    written: str,
    name: str,
    owner: TypedExpression,
) -> TypedExpression:
    """`written`: the name of the agent or object `base`, with the number of a copy."""
    place = member.name.span
    verb = next(iter(verbs_with(checker, _VERBS, name)), None)
    if verb is None:
        known = _members(checker, owner)
        listed = f"its members are {', '.join(f'`{name}`' for name in known)}"
        habit = member_help(name)
        meant = None if habit else meant_name(name, known)
        help_ = () if meant else (*habit, listed)
        return checker.report(
            Code.UNDEFINED_SIGNAL, place, name=name, given=f"`{base}`", help=help_, meant=meant
        )
    found = find_kind(checker, verb, name, place)
    if found is None:
        return unknown(member.span)
    if not is_member(found) or not found.schema:
        written = f"it is written `{name}({signature(found.schema)})`"
        return checker.report(
            Code.UNDEFINED_SIGNAL, place, name=name, given=f"`{base}`", help=written
        )
    if verb == "number" and not _is_on_road(checker, base):
        if _lacks_road(checker, base):
            return unknown(member.span)
        return checker.report(Code.START_WITHOUT_ROAD, member.span, name=base, member=name)
    fitted = check_assignable(checker, owner, found.schema[0])
    if fitted is None:
        return unknown(member.span)
    bound = BoundOptions({found.schema[0].name: fitted}, True)
    return measured(checker, member.span, found, bound, f"{written}.{name}", member=True)


def _members(checker: Checker, owner: TypedExpression) -> list[str]:
    """The names of the members that an agent or an object has."""
    role = str(getattr(owner.type, "role", ""))
    entries = [entry for verb in _VERBS for entry in checker.registry.of(verb)]
    kinds = [kind for kind in map(loaded, entries) if isinstance(kind, ResolvedKind)]
    return [
        kind.entry.name
        for kind in kinds
        if is_member(kind) and kind.schema and takes_role(kind.schema[0], role)
    ]


def _lacks_road(checker: Checker, name: str) -> bool:
    """Whether the statement is wrong itself: `at 5m` without a road, which is reported there."""
    statement = checker.program.declarations[name].statement
    return isinstance(statement, ast.Actor) and isinstance(statement.at, ast.NumberLiteral)


def _is_on_road(checker: Checker, name: str) -> bool:
    statement = checker.program.declarations[name].statement
    return isinstance(statement, ast.Actor) and road_of(checker, statement) is not None
