"""Methods that no one has called are not compiled, and do what they always do."""

from __future__ import annotations

import dataclasses
import pickle
from dataclasses import dataclass
from typing import Any

import pytest

import roadlang.cli  # noqa: F401 - from here on

PLACE = "dataclass_methods.py"


@dataclass(frozen=True)
class Plain:
    """Of two numbers."""

    one: int
    other: float = 2.0


@dataclass(frozen=True, slots=True)
class Slotted(Plain):
    """With slots, and one more."""

    third: str = ""


def is_compiled(kind: type, name: str) -> bool:
    """Whether it is the method itself that is there."""
    method: Any = getattr(kind, name)
    return not getattr(method, "__wrapped__", method).__code__.co_filename.endswith(PLACE)


@pytest.mark.skipif(not hasattr(dataclasses, "_create_fn"), reason="compiles all in one go")
def test_methods_are_compiled_when_they_are_called() -> None:
    @dataclass(frozen=True)
    class Fresh:
        value: int

    names = ("__eq__", "__hash__", "__setattr__", "__delattr__", "__repr__")
    assert not any(is_compiled(Fresh, name) for name in names)
    assert Fresh(1) == Fresh(1)
    assert hash(Fresh(1)) == hash((1,))
    assert [is_compiled(Fresh, name) for name in names] == [True, True, False, False, False]


@pytest.mark.parametrize("kind", [Plain, Slotted])
def test_they_do_what_they_always_do(kind: type[Plain]) -> None:
    it, same, another = kind(1), kind(1), kind(2)
    for _ in range(2):  # compiled, and then as they are
        assert it == same
        assert it not in (another, (1, 2.0))
        assert len({it, same, another}) == 2
        assert repr(it).endswith(
            f"{kind.__name__}(one=1, other=2.0" + ", third=''" * (kind is Slotted) + ")"
        )
        with pytest.raises(dataclasses.FrozenInstanceError, match="cannot assign to field 'one'"):
            it.one = 3  # type: ignore[misc]
        with pytest.raises(dataclasses.FrozenInstanceError, match="cannot delete field 'one'"):
            del it.one  # type: ignore[misc]
    assert pickle.loads(pickle.dumps(it)) == it
    assert dataclasses.replace(it, one=2) == another
    assert Plain(1) != Slotted(1)
