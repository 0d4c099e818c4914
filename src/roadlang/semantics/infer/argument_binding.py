"""Arguments of a call: by position in the order of the kind's fields, or by name."""

from __future__ import annotations

from collections.abc import Sequence

from ...diagnostics import Code
from ...ir.values import Items, RandomValue
from ...plugins import option_types as opt
from ...plugins.options import OptionSchema
from ...syntax.tree import nodes as ast
from ..checker import Checker
from ..context import Context
from ..suggestions import meant_name
from ..types.assignable import check_assignable
from ..types.expression_types import SequenceType, TypedExpression
from .option_binding import BoundOptions, bound_of, infer_option, report_missing, report_unknown


def bind_arguments(
    checker: Checker,
    call: ast.CallExpression,
    schema: Sequence[OptionSchema],
    rest: str,
    context: Context,
) -> BoundOptions:
    """The arguments against the schema; `rest` names the list that takes all without a name."""
    return _Binder(checker, call, schema, rest, context).bind()


class _Binder:
    def __init__(
        self,
        checker: Checker,
        call: ast.CallExpression,
        schema: Sequence[OptionSchema],
        rest: str,
        context: Context,
    ) -> None:
        self._checker = checker
        self._call = call
        self._schema = schema
        self._rest = rest
        self._context = context
        self._known = {option.name: option for option in schema}
        self._owner = f"`{call.function.span.text}`"
        self._bound: dict[str, TypedExpression] = {}
        self._named: set[str] = set()
        self._gathered: list[TypedExpression] = []
        self._complete = True

    def bind(self) -> BoundOptions:
        names = list(self._known)
        for index, argument in enumerate(self._call.arguments):
            if argument.key is not None:
                self._take_named(argument, argument.key)
            elif self._rest:
                self._gather(argument)
            elif index < len(names):
                self._take(argument, names[index])
            else:
                self._too_many(argument)
                return BoundOptions(self._bound, False)
        if self._gathered:
            self._bound[self._rest] = self._list()
        self._look_for_missing()
        return bound_of(self._checker, self._bound, self._schema, self._complete)

    def _take_named(self, argument: ast.Argument, key: ast.Word) -> None:
        if key.text in self._known:
            self._take(argument, key.text)
            return
        report_unknown(self._checker, key, self._known, self._owner)
        self._complete = False
        # An argument whose name was misspelled is not missing as well.
        meant = meant_name(key.text, self._known)
        if meant is not None:
            self._named.add(meant)

    def _take(self, argument: ast.Argument, name: str) -> None:
        if name in self._named:
            self._checker.report(Code.DUPLICATE_OPTION, argument.span, name=name)
            self._complete = False
            return
        self._named.add(name)
        option = self._known[name]
        typed = infer_option(self._checker, argument.value, option, self._context, argument=True)
        if typed is None:
            self._complete = False
        else:
            self._bound[name] = typed

    def _gather(self, argument: ast.Argument) -> None:
        option = self._known[self._rest]
        assert isinstance(option.type, opt.ListType)
        item = OptionSchema(option.name, option.type.item, None, option.constraints)
        self._named.add(self._rest)
        typed = check_assignable(
            self._checker, self._checker.infer(argument.value, self._context), item
        )
        if typed is None:
            self._complete = False
        else:
            self._gathered.append(typed)

    def _list(self) -> TypedExpression:
        values = tuple(item.value for item in self._gathered if item.value is not None)
        random = any(item.random for item in self._gathered)
        items = tuple(self._gathered)
        return TypedExpression(self._call.span, SequenceType(), Items(values), random, items=items)

    def _look_for_missing(self) -> None:
        missing = [o.name for o in self._schema if o.required and o.name not in self._named]
        if missing and self._complete:  # an argument that is wrong may stand for it
            span = self._call.span
            report_missing(
                self._checker, self._owner, missing, self._known, span, "argument", self._ranges()
            )
            self._complete = False

    def _ranges(self) -> list[str]:
        """Help for `uniform(3m..5m)`: a range is one value, and random by itself."""
        taken = list(self._bound.values())
        if len(taken) != 1 or not taken[0].range:
            return []
        written, drawn = taken[0].span.text, taken[0].value
        low, _, high = written.partition("..")
        name = self._call.function.span.text
        with_comma = f"`{name}({low.strip()}, {high.strip()})`"
        if isinstance(drawn, RandomValue) and name in drawn.call.kind.split("."):
            return [f"`..` draws a {name} value by itself: write `{written}`, or {with_comma}"]
        return [f"arguments are separated by commas, `..` draws one value: {with_comma}"]

    def _too_many(self, argument: ast.Argument) -> None:
        name = self._call.function.span.text
        help_ = f"it is written `{name}({', '.join(self._known)})`"
        self._checker.report(Code.WRONG_ARGUMENT_COUNT, argument.span, name=name, help=help_)
