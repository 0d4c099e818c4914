"""The loop that carries out programs, compiled by numba."""

from __future__ import annotations

from functools import cache
from typing import Any

from ...geometry.numbers import compiling
from ..vehicles import compiled
from . import interpreting, operations


@cache
def repeated() -> Any:
    """`interpreting.repeated`, compiled."""
    _register()
    return compiled.compile_loop(interpreting.repeated, interpreting, operations)


@cache
def _register() -> None:
    """Make the functions that the loop calls known to numba."""
    overload = compiling.loaded().extending.overload
    loops = (
        interpreting.compute, interpreting.frame, interpreting.move, interpreting.finite,
        interpreting.concerns, interpreting.call, interpreting.once, interpreting.repeated,
    )  # fmt: skip
    compiled.register((), loops)
    called = _called_by_address()
    overload(interpreting.call_loop, jit_options=compiled.OPTIONS)(
        lambda address, arguments, count, strides, data: (
            lambda address, arguments, count, strides, data: called(
                address, arguments, count, strides, data
            )
        )
    )


def _called_by_address() -> Any:
    """A function for compiled code that calls `void loop(char **, npy_intp *, npy_intp *, void *)`,
    of which all are given as addresses."""
    from llvmlite import ir
    from numba.core import types
    from numba.extending import intrinsic

    def call(context: Any, builder: Any, _: Any, given: Any) -> Any:
        pointer = ir.IntType(8).as_pointer()
        kind = ir.FunctionType(ir.VoidType(), [pointer] * 4)
        loop = builder.inttoptr(given[0], kind.as_pointer())
        builder.call(loop, [builder.inttoptr(one, pointer) for one in given[1:]])
        return context.get_dummy_value()

    def called(
        _context: Any, address: Any, arguments: Any, count: Any, strides: Any, data: Any
    ) -> Any:
        whole = types.intp
        return types.void(whole, whole, whole, whole, whole), call

    return intrinsic(called)
