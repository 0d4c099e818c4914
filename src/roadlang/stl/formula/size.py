"""How large a formula is when what it shares is written out."""

from __future__ import annotations

from .formulas import Comparison, Derived, Formula
from .terms import Term


def written_out_size(formula: Formula) -> int:
    """The number of operators, comparisons, variables and numbers, each as often as it occurs.

    A formula that is named twice in another is one object; `iff` and `xor` use their operands
    twice. The work is that of the objects, not of the size.
    """
    sizes: dict[int, int] = {}
    # Nodes are kept, so that no two have one id.
    known: dict[int, tuple[Formula | Term, tuple[Formula | Term, ...]]] = {}
    pending: list[Formula | Term] = [formula]
    while pending:
        node = pending[-1]
        if id(node) not in known:
            known[id(node)] = node, _parts(node)
        parts = known[id(node)][1]
        missing = [part for part in parts if id(part) not in sizes]
        pending.extend(missing)
        if not missing:
            sizes[id(node)] = 1 + sum(sizes[id(part)] for part in parts)
            pending.pop()
    return sizes[id(formula)]


def _parts(node: Formula | Term) -> tuple[Formula | Term, ...]:
    if isinstance(node, Comparison):
        return node.left, node.right
    if isinstance(node, Derived):
        return node.expanded().parts
    return node.parts
