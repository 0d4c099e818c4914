"""What a tape computes for few agents at few times alone, such as which wheels are beside the road:
left out where a truth value says that nobody is concerned."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from . import operations as do

Instruction = tuple[int, tuple[int, ...], tuple[int, ...], int]
"""Operation, values that it takes, values that it gives, and a number more."""
FEWEST = 4
"""Instructions for which it pays to ask."""
_PURE = frozenset(range(do.MOVE))
"""Operations that do nothing but to give values."""


@dataclass(frozen=True)
class _Guarded:
    """Instructions that are left out where `condition` is true of no agent."""

    condition: int
    instructions: tuple[Instruction, ...]


_Item = Instruction | _Guarded


def guarded(instructions: Sequence[Instruction], gives: Sequence[int]) -> list[Instruction]:
    """The same computation, with a `SKIP` before instructions on which nothing depends but choices
    (`WHERE`) by one truth value, and before these. `gives`: the values that it comes to."""
    items: list[_Item] = [*instructions]
    values = [value for _, takes, results, _ in instructions for value in (*takes, *results)]
    fresh = max((*values, *gives), default=0) + 1
    conditions = dict.fromkeys(
        takes[0] for operation, takes, _, _ in instructions if operation == do.WHERE
    )
    for condition in conditions:
        items, fresh = _with_guard(items, condition, gives, fresh)
    return _flat(items)


def _flat(items: Sequence[_Item]) -> list[Instruction]:
    out: list[Instruction] = []
    for item in items:
        if isinstance(item, _Guarded):
            out.append((do.SKIP, (item.condition,), (), len(item.instructions)))
            out += item.instructions
        else:
            out.append(item)
    return out


def _with_guard(
    items: list[_Item], condition: int, gives: Sequence[int], fresh: int
) -> tuple[list[_Item], int]:
    """The items with those of one condition guarded, and the first number that no value has."""
    begin, choices = _choices(items, condition)
    uses = Counter(value for item in items for value in _takes(item))
    uses.update(gives)
    chain = _needed_by(items[:begin], choices, uses)
    if len(chain) + len(choices) < FEWEST:
        return items, fresh
    left = [item for item in items[:begin] if item not in chain]
    computed = {value for item in left for value in _results(item)}
    inside: list[Instruction] = [item for item in items[:begin] if item in chain]  # type: ignore[misc]
    for operation, (_, yes, no), results, more in choices:
        if no not in computed or uses[no] > 1:  # what it is otherwise is put where the choice is
            left.append((do.COPY, (no,), (fresh,), 0))
            no, fresh = fresh, fresh + 1
        inside.append((operation, (condition, yes, no), results, more))
    after = items[begin + len(choices) :]
    return [*left, _Guarded(condition, tuple(inside)), *after], fresh


def _choices(items: Sequence[_Item], condition: int) -> tuple[int, list[Instruction]]:
    """The first choices by a condition that follow one another, and where they begin."""
    begin, found = len(items), list[Instruction]()
    for place, item in enumerate(items):
        if not isinstance(item, _Guarded) and item[0] == do.WHERE and item[1][0] == condition:
            begin = min(begin, place)
            found.append(item)
        elif found:
            break
    return begin, found


def _needed_by(
    items: Sequence[_Item], choices: Sequence[Instruction], uses: Counter[int]
) -> set[_Item]:
    """The items of which nothing is used but for what the choices are where their condition is
    true."""
    inside = Counter(takes[1] for _, takes, _, _ in choices)
    found: set[_Item] = set()
    for item in reversed(items):
        results = _results(item)
        if (
            not isinstance(item, _Guarded)
            and item[0] in _PURE
            and all(inside[value] == uses[value] for value in results)
        ):
            found.add(item)
            inside.update(item[1])
    return found


def _takes(item: _Item) -> tuple[int, ...]:
    if isinstance(item, _Guarded):
        inside = tuple(value for one in item.instructions for value in one[1])
        return (item.condition, *inside)
    return item[1]


def _results(item: _Item) -> tuple[int, ...]:
    if isinstance(item, _Guarded):
        return tuple(value for one in item.instructions for value in one[2])
    return item[2]
