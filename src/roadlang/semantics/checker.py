"""The state of one check: what was declared, found out and reported."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from ..diagnostics import (
    Code,
    Diagnostic,
    DiagnosticError,
    Fix,
    KnownNames,
    Label,
    Span,
    diagnose,
)
from ..ir.values import PassCall, Value
from ..plugins.kinds import Kind
from ..plugins.options import OptionSchema
from ..plugins.registry import KindEntry, Registry
from ..plugins.value_bounds import ValueBounds
from ..stl.evaluate.interval_arithmetic import UNKNOWN, Bounds
from ..syntax.tree import nodes as ast
from .context import Context
from .names.program import Program
from .quoted_words import word_help
from .suggestions import suggestion
from .types.expression_types import TypedExpression, unknown

Rule = Callable[["Checker", Any, Context], TypedExpression]


@dataclass(frozen=True, slots=True)
class ResolvedKind:
    """A kind that is there, imported, with its options."""

    entry: KindEntry
    kind: type[Kind]
    schema: tuple[OptionSchema, ...]


class Checker:
    """Passed to every rule. `uses`: what must be evaluated before each declaration."""

    def __init__(
        self, program: Program, registry: Registry, rules: Mapping[type, Rule], define: Rule
    ) -> None:
        self.program = program
        self.registry = registry
        self.diagnostics: list[Diagnostic] = list(program.diagnostics)
        self.uses: dict[str, dict[str, None]] = {}
        self.used: set[str] = set()
        self.kinds: dict[tuple[str, str], ResolvedKind | None] = {}
        self.divisors: list[tuple[str, Span]] = []
        """The `s` of numbers such as `1/s`, and where."""
        self.names_of_roles: dict[tuple[str, ...], KnownNames] = {}
        """What is declared, by the statements that fit: listed once, not for each unknown name."""
        self.value_bounds = ValueBounds(lambda name: self.definition(name).value, self._kind_of)
        self._rules = rules
        self._define = define
        self._definitions: dict[str, TypedExpression] = {}
        self._open: list[str] = []
        self._draws: dict[str, int] = {}

    def report(
        self,
        code: str,
        span: Span,
        *,
        help: str | Iterable[str] = (),
        labels: Iterable[Label] = (),
        fixes: Iterable[Fix] = (),
        meant: str | None = None,
        **values: Any,
    ) -> TypedExpression:
        """Report and go on with a value that fits everywhere.

        `meant`: what was probably meant by the text of `span`; it is suggested and is the fix.
        """
        if meant is not None:
            more = (help,) if isinstance(help, str) else tuple(help)
            help = (suggestion(span.text, meant), *more)
            fixes = (*fixes, Fix(span, meant))
        found = diagnose(code, span, help=help, labels=labels, fixes=fixes, **values)
        self.diagnostics.append(found)
        return unknown(span)

    def infer(self, expression: ast.Expression, context: Context) -> TypedExpression:
        """Type and value of an expression; errors are reported once, here."""
        return self._rules[type(expression)](self, expression, context)

    def bounds_of(self, value: Value) -> Bounds:
        """The least and the greatest number that a value can be, as far as is known."""
        try:
            return self.value_bounds.of(value)
        except DiagnosticError:  # a plugin's mistake shows when it draws, with its name
            return UNKNOWN

    def _kind_of(self, call: PassCall) -> tuple[KindEntry, type[Kind]]:
        entry = self.registry.find(call.verb, call.kind)
        return entry, entry.load()

    def definition(self, name: str) -> TypedExpression:
        """The value of a `param` or `let`."""
        known = self._definitions.get(name)
        if known is not None:
            return known
        declaration = self.program.declarations[name]
        span = declaration.name.span
        if name in self._open:
            self.report_cycle(self._open[self._open.index(name) :])
            return unknown(span)
        self._open.append(name)
        found = self._define(self, declaration, Context(user=name, place=name))
        self._open.pop()
        # A cycle was reported while it was open: what came of it is not to be trusted.
        return self._definitions.setdefault(name, found)

    def report_cycle(self, names: list[str]) -> None:
        """RL104, with each name of the cycle shown once; all of them become unknown."""
        first = min(names, key=lambda name: self.program.declarations[name].name.span.start)
        turn = names.index(first)
        names = [*names[turn:], *names[:turn]]
        places = [self.program.declarations[name].name.span for name in names]
        for name, place in zip(names, places, strict=True):
            self._definitions[name] = unknown(place)
        labels = [Label(place, "") for place in places[1:]]
        cycle = " -> ".join(f"`{name}`" for name in [*names, first])
        help = word_help(self.program.declarations[first], first)
        self.report(Code.CIRCULAR_DEFINITION, places[0], labels=labels, cycle=cycle, help=help)

    def use(self, name: str, context: Context) -> None:
        """Note that the context's declaration refers to `name`."""
        if name != context.user or not context.drive_time:
            self.used.add(name)
            if not context.drive_time:
                self.uses.setdefault(context.user, {})[name] = None

    def draw_place(self, context: Context) -> str:
        """The key of the next draw here: `bent/perturb 1/amplitude`, then `...#2`."""
        count = self._draws[context.place] = self._draws.get(context.place, 0) + 1
        return context.place if count == 1 else f"{context.place}#{count}"

    @property
    def has_errors(self) -> bool:
        """Whether any diagnostic so far is an error."""
        return any(found.is_error for found in self.diagnostics)
