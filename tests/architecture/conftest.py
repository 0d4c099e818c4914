"""What is shared by the tests of the house."""

from collections.abc import Iterator

import pytest

from tests.architecture.house import forget_trees


@pytest.fixture(scope="package", autouse=True)
def trees() -> Iterator[None]:
    """Trees of all files are millions of objects, which would slow down every later test."""
    yield
    forget_trees()
