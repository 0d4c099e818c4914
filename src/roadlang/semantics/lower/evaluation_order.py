"""An order in which declarations can be evaluated: what a thing depends on comes before it."""

from __future__ import annotations

from ..checker import Checker


def evaluation_order(checker: Checker) -> list[str]:
    """All names, each after those that it depends on; cycles are reported."""
    order: list[str] = []
    done: set[str] = set()
    for name in list(checker.program.declarations):
        _visit(checker, name, done, order)
    return order


def _visit(checker: Checker, start: str, done: set[str], order: list[str]) -> None:
    """Depth first, with an explicit stack: chains may be longer than Python's."""
    if start in done:
        return
    path = {start: iter(checker.uses.get(start, ()))}
    while path:
        name = next(reversed(path))
        for other in path[name]:
            if other in path:
                names = list(path)
                _report(checker, names[names.index(other) :])
            elif other not in done and other in checker.program.declarations:
                path[other] = iter(checker.uses.get(other, ()))
                break
        else:
            del path[name]
            done.add(name)
            order.append(name)


def _report(checker: Checker, cycle: list[str]) -> None:
    if not any(checker.definition(name).is_unknown for name in cycle if _is_value(checker, name)):
        checker.report_cycle(cycle)


def _is_value(checker: Checker, name: str) -> bool:
    return checker.program.declarations[name].role in ("param", "let")
