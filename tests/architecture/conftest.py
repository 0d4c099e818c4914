"""What the tests of the architecture share."""

from collections.abc import Iterator

import pytest

from tests.architecture.source_tree import forget_trees


@pytest.fixture(scope="package", autouse=True)
def trees() -> Iterator[None]:
    """Trees of all files are millions of objects, which would slow down every later test."""
    yield
    forget_trees()
