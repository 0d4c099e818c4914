"""Options of a call: its own, and those that every kind of its verb has."""

from __future__ import annotations

from roadlang.ir.read_only import FrozenDict
from roadlang.ir.values import ConstantValue, PassCall


def test_an_option_is_looked_for_among_both() -> None:
    one, other = ConstantValue(3.0), ConstantValue(4.0)
    call = PassCall(
        "perturb", "standard.sine", FrozenDict({"amplitude": one}), "bent/perturb 1",
        common=FrozenDict({"taper": other}),
    )  # fmt: skip
    assert call.option("amplitude") == one
    assert call.option("taper") == other
    assert call.option("over") is None
