"""Packages whose names are imported when they are asked for."""

from __future__ import annotations

from importlib import import_module

import pytest

PACKAGES = ("", ".api", ".commands", ".geometry", ".semantics", ".stl", ".syntax")


@pytest.mark.parametrize("package", PACKAGES)
def test_a_name_that_a_package_lacks_is_an_attribute_error(package: str) -> None:
    module = import_module(f"roadlang{package}")
    with pytest.raises(AttributeError, match=r"no attribute 'no_such_name'"):
        _ = module.no_such_name
    assert not hasattr(module, "__no_such_name__")


@pytest.mark.parametrize("package", PACKAGES)
def test_every_public_name_is_found(package: str) -> None:
    module = import_module(f"roadlang{package}")
    assert module.__all__
    assert all(hasattr(module, name) for name in module.__all__)
