"""`python -m tests.golden [NAME ...]`: store the lines of the cases anew; `git diff` shows what changed."""  # noqa: E501

from __future__ import annotations

import sys

from tests.golden.cases import CASES
from tests.golden.comparing import store

if __name__ == "__main__":
    for name in sys.argv[1:] or CASES:
        store(name, CASES[name].lines())
        sys.stdout.write(f"{name}\n")
