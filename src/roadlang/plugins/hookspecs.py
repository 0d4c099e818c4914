"""The hooks of a plugin: they collect kinds, the runner runs them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import pluggy

hookspec = pluggy.HookspecMarker("roadlang")
hookimpl = pluggy.HookimplMarker("roadlang")


@hookspec
def roadlang_kinds() -> Iterable[type] | Mapping[str, str]:
    """The kinds of the plugin.

    A list of classes, or, to have each imported only when it is used, a map such as
    `{"perturb sine": "my_package.perturb_sine:Sine"}`.
    """
    return ()


@hookspec
def roadlang_planned() -> Iterable[str]:
    """Kinds that are planned and do not exist yet (`"emit gltf"`), so that the error says so."""
    return ()
