"""Commands of other tools and what does their work here, for who types them out of habit."""

from __future__ import annotations

_DRIVE = "`run FILE` drives scenes and evaluates their expectations"
_CHECK = "`check FILE` reports all errors of a scene file"
_SAMPLE = "`compile FILE` samples scenes and writes them"
_PICTURE = (
    "`view FILE` draws a map, scene or scene file; `render FILE` makes images and clips in Godot"
)
_CONVERT = "`convert IN OUT` converts maps, and the first scene of a scene file"
_SEARCH = "`falsify FILE` searches for scenes that violate an expectation"
_KINDS = "`plugins` lists all kinds, `plugins show NAME` the options of one"
_MEANT = {
    _DRIVE: "simulate sim drive play exec execute start test tests bench benchmark",
    _CHECK: "validate verify lint typecheck parse",
    _SAMPLE: "sample generate gen build make scenes scene",
    _PICTURE: "show draw plot preview viewer visualize visualise display open image picture video"
    " animate film record",
    _CONVERT: "import export translate",
    _SEARCH: "search fuzz optimize optimise attack find",
    _KINDS: "list ls kinds plugin install options",
    "`run FILE` evaluates expectations on drives, `monitor FORMULA TRACE` a formula on recordings":
    "evaluate eval judge assess",
    "`fmt FILE` formats scene files": "format prettify black",
    "`init FILE` writes a starter scene file": "new create template scaffold starter",
    "`--help` lists the commands, `COMMAND --help` the options of one, `explain` diagnostics and"
    " statements": "help man doc docs info describe",
    "`roadlang --version` shows the version": "version",
    "`report DIR` writes an HTML page with results": "summary summarize html results stats",
    "`watch FILE` drives a file in Godot, and again each time it is saved": "serve live dev edit",
    "`shrink FAILURE.json` finds the simplest scene that still fails": "minimize minimise reduce",
}  # fmt: skip
_HINTS = {word: hint for hint, words in _MEANT.items() for word in words.split()}


def guessed_command_hint(word: str) -> str | None:
    """What to use instead of a command that roadlang does not have, or None."""
    return _HINTS.get(word.lower())
