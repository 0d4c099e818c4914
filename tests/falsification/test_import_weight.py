"""What a search for failures need not import."""

from __future__ import annotations

import subprocess
import sys

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
