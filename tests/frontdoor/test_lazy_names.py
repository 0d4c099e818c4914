"""Names of packages that are loaded when they are asked for."""

from __future__ import annotations

from importlib import import_module

import pytest

LAZY = ["", ".api", ".commands", ".geometry", ".semantics", ".stl", ".syntax"]


@pytest.mark.parametrize("package", [f"roadlang{name}" for name in LAZY])
def test_names_that_are_not_there_are_missing_attributes(package: str) -> None:
    module = import_module(package)
    assert not hasattr(module, "no_such_name")
    with pytest.raises(AttributeError, match=f"'{package}' has no attribute 'no_such_name'"):
        _ = module.no_such_name
    for name in list(module.__all__)[::7]:
        found = getattr(module, name)
        assert getattr(module, name) is found
