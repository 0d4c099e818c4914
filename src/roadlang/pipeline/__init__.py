"""From a scenario to scenes: sources, passes in batches, requirements, sampling, placement.

Nothing is imported until a name is used.
"""

from __future__ import annotations

from importlib import import_module

_HOMES = {
    "SamplingResult": "sampling",
    "sample_scenes": "sampling",
    "Plan": "plan",
    "Variants": "variants",
    "Judge": "judging",
    "realise": "realising",
    "write_all": "writing",
    "mean_nearest": "diversity",
}

__all__ = list(_HOMES)


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f".{_HOMES[name]}", __name__), name)


def __dir__() -> list[str]:
    return __all__
