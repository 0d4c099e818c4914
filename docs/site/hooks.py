"""Hooks of MkDocs: pages written for a reader of the repository become pages of a site.

- `CONTRIBUTING.md` and its like become pages too; the gallery is drawn.
- Links that leave `docs/` lead to such a page or to a copy of the file; folders lose their link.
- Words after the language of a code block, which the tests of the documentation read, become its
  title.
"""

from __future__ import annotations

import posixpath
import re
import sys
import tempfile
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page
from pygments import lexers

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(Path(__file__).parent))

from gallery import draw_gallery  # noqa: E402 - this folder is no package of an installation
from lexer import RoadlangLexer  # noqa: E402

#: Pages of the site that are no files of `docs/`, and where they come from.
PAGES = {
    "index.md": "README.md",
    "contributing.md": "CONTRIBUTING.md",
    "changelog.md": "CHANGELOG.md",
    "security.md": "SECURITY.md",
    "conduct.md": "CODE_OF_CONDUCT.md",
    "model_card.md": "plugins/standard/roadlang_standard/extraction/photos/weights/MODEL_CARD.md",
}
_LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s#]+)(#[^)\s]*)?\)")
_FENCE = re.compile(r"^(```\w+) +([^\n`]+)$", re.MULTILINE)
_CODE = re.compile(r"^```.*?^```$|`[^`\n]+`", re.MULTILINE | re.DOTALL)


def on_config(config: MkDocsConfig) -> None:
    """Make the lexer of scene files known to Pygments."""
    known = RoadlangLexer.name, RoadlangLexer.aliases, RoadlangLexer.filenames, ()
    lexers.LEXERS["RoadlangLexer"] = (RoadlangLexer.__module__, *known)


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add pages of the repository's root, the gallery, and every file that pages link to."""
    for name, source in PAGES.items():
        files.append(File.generated(config, name, content=(ROOT / source).read_text("utf-8")))
    folder = Path(tempfile.mkdtemp(prefix="roadlang-gallery-"))
    for path in draw_gallery(folder):
        name = path.relative_to(folder).as_posix()
        files.append(File.generated(config, name, abs_src_path=str(path)))
    for file in list(files.documentation_pages()):
        for match in _LINK.finditer(_CODE.sub("", file.content_string)):
            path = _in_repository(file.src_uri, match[3])
            if path and _on_site(path).startswith("files/") and (ROOT / path).is_file():
                name = _on_site(path)
                if not files.get_file_from_path(name):
                    files.append(File.generated(config, name, abs_src_path=str(ROOT / path)))
    return files


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Mend links and the heads of code blocks."""
    source = page.file.src_uri
    kept: list[str] = []

    def hide(match: re.Match[str]) -> str:
        kept.append(match[0])
        return f"\0{len(kept) - 1}\0"

    def show(match: re.Match[str]) -> str:
        return kept[int(match[1])]

    text = _CODE.sub(hide, markdown)
    text = _LINK.sub(lambda match: _mended(match, source), text)
    text = re.sub("\0(\\d+)\0", show, text)
    return _FENCE.sub(_titled, text)


def _titled(match: re.Match[str]) -> str:
    """The head of a code block with what the tests read from it as its title."""
    words = match[2].split()
    if words[0] == "wrong":
        words = ["gives", *words[1:]] if len(words) > 1 else words
    named = words[0] in ("wrong", "right", "gives") or "." in words[0]
    return f'{match[1]} title="{" ".join(words)}"' if named else match[1]


def _mended(match: re.Match[str], source: str) -> str:
    bang, words, target, anchor = match.groups()
    path = _in_repository(source, target)
    if path is None:
        return match[0]
    if (ROOT / path).is_dir():
        return words
    link = posixpath.relpath(_on_site(path), posixpath.dirname(source) or ".")
    return f"{bang}[{words}]({link}{anchor or ''})"


def _in_repository(source: str, target: str) -> str | None:
    """The path, from the root of the repository, that a page links to; None for a web address."""
    if re.match(r"\w+:|/", target):
        return None
    page = PAGES.get(source, f"docs/{source}")
    return posixpath.normpath(posixpath.join(posixpath.dirname(page), target))


def _on_site(path: str) -> str:
    """Where a file of the repository is on the site."""
    pages = {source: page for page, source in PAGES.items()}
    if path in pages:
        return pages[path]
    return path.removeprefix("docs/") if path.startswith("docs/") else f"files/{path}"
