"""What a search for failures need not import."""

from __future__ import annotations

import subprocess
import sys

import pytest

CODE = """
import sys
import roadlang.session.falsification, roadlang.session.falsification_files, roadlang.session.drives
unused = {"roadlang.scenes.sampling", "roadlang.scenes.emitting", "roadlang.search.scene_search",
          "roadlang.geometry.junctions.plan", "roadlang.geometry.junctions.building"}
print(sorted(unused & set(sys.modules)))
"""


def test_a_search_imports_neither_sampling_nor_plans_of_junctions() -> None:
    found = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, check=True)
    assert found.stdout == "[]\n"


DEFERRED = """
import sys
from roadlang.cli.deferred_modules import defer_parts_of_numpy
defer_parts_of_numpy()
import numpy, scipy.linalg, scipy.special
print("numpy.f2py.crackfortran" in sys.modules, numpy.testing.assert_equal(1, 1))
from numpy.polynomial.polynomial import polyval
print(polyval(2.0, [1.0, 3.0]), numpy.char.upper("a"))
"""


def test_parts_of_numpy_that_scipy_names_are_loaded_when_they_are_used() -> None:
    found = subprocess.run(
        [sys.executable, "-c", DEFERRED], capture_output=True, text=True, check=True
    )
    assert found.stdout == "False None\n7.0 A\n"


COMPILING = """
import sys
from roadlang.geometry.numbers import compiling
compiling.loaded()
print("coverage" in sys.modules)
import coverage
"""


def test_loading_numba_does_not_load_coverage() -> None:
    pytest.importorskip("numba")
    pytest.importorskip("coverage")
    found = subprocess.run(
        [sys.executable, "-c", COMPILING], capture_output=True, text=True, check=True
    )
    assert found.stdout == "False\n"


NAMES_OF_CHARACTERS = """
import sys
import roadlang.session.falsification
print(sorted({"difflib", "html"} & set(sys.modules)))
"""


def test_a_search_imports_neither_names_of_characters_nor_what_compares_words() -> None:
    code = [sys.executable, "-c", NAMES_OF_CHARACTERS]
    found = subprocess.run(code, capture_output=True, text=True, check=True)
    assert found.stdout == "[]\n"
