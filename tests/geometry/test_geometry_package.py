"""The package itself: light to import, and true to its list of names."""

from __future__ import annotations

import subprocess
import sys

import roadlang.geometry as geometry


def test_importing_the_package_imports_no_numpy() -> None:
    code = "import roadlang.geometry, sys; sys.exit('numpy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_importing_curves_imports_no_scipy() -> None:
    code = "from roadlang.geometry import RoadNetwork, displace; import sys; "
    code += "sys.exit('scipy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_every_name_is_there_and_only_those() -> None:
    for name in geometry.__all__:
        found = getattr(geometry, name)
        if name not in ("Booleans", "Floats", "Integers", "Marking") and not name.isupper():
            assert found.__name__ == name
    assert dir(geometry) == sorted(geometry.__all__)
    assert not hasattr(geometry, "nonsense")
