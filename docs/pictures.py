"""Makes the pictures of a page again, by the commands on it.

    python -m docs.pictures docs/paper.md

Each picture with a title, `![...](images/NAME "FILE")`, becomes a copy of the FILE that the page's
commands write.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from pathlib import Path

from tests.docs.page_reader import follow, pictures


def main(pages: list[str]) -> None:
    """Follow each page in an empty folder, and take its pictures from there."""
    for page in map(Path, pages):
        with tempfile.TemporaryDirectory() as folder:
            follow(page, Path(folder))
            for picture, source in pictures(page):
                if (Path(folder) / source).exists():
                    picture.parent.mkdir(parents=True, exist_ok=True)
                    shutil.copyfile(Path(folder) / source, picture)
                    print(f"{picture}: {picture.stat().st_size:,} bytes")
                else:
                    print(f"{picture}: left as it is, for no Godot engine was found")


if __name__ == "__main__":
    main(sys.argv[1:])
