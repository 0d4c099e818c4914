"""Names of kinds, without the plugin that they come from."""

from __future__ import annotations


def plain_name(kind: str) -> str:
    """`pure_pursuit` of `roadlang.pure_pursuit` or `standard.pure_pursuit`; a stranger's name
    stays whole."""
    plugin, _, name = kind.rpartition(".")
    return name if plugin in ("", "roadlang", "standard") else kind
