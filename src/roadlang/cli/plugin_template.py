"""A new plugin as files: a distribution with kinds, tests and types, made from templates."""

from __future__ import annotations

import os
import re
import shutil
import tempfile
import unicodedata
from collections.abc import Mapping, Sequence
from importlib.resources import files
from pathlib import Path

from ..diagnostics import Code, DiagnosticError, diagnose
from ..plugins.entry_points import plugin_candidates
from ..plugins.registry import Registry
from ..syntax.words import RESERVED
from ..version import API_VERSION

VERBS = (
    "agent",
    "drive",
    "drive_signal",
    "emit",
    "extract",
    "falsify",
    "monitor",
    "object",
    "perturb",
    "read",
    "sense",
    "signal",
)
"""The verbs that there is a template for."""
_DATA = {"read": "track"}
"""Verbs whose scenes name a file, by its name without the ending, which is that of the kind; it
stands beside the tests."""
_NAME = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*\Z")
_TEMPLATES = files(__package__) / "templates" / "plugin"


def check_plugin_name(name: str, verbs: Sequence[str], registry: Registry) -> None:
    """Raises `DiagnosticError` RL938 for a name that a plugin, or its kinds, cannot have."""
    shipped = {c.name: c.origin for c in plugin_candidates() if c.origin.is_shipped}
    help: str | tuple[()] = "choose another name"
    if not _NAME.match(name):
        reason = "use lowercase letters, digits and `_`, beginning with a letter"
        suggestion = _as_name(name)
        help = f"did you mean `{suggestion}`?" if _NAME.match(suggestion) else ()
    elif name in RESERVED:
        reason = "it is a keyword"
    elif name in shipped:
        reason = f"{shipped[name]} has a plugin with this name"
    else:
        clashes = [verb for verb in verbs if _is_shipped(registry, verb, name)]
        if not clashes:
            return
        reason = f"its kind would be called `{clashes[0]} {name}`, which exists in roadlang"
    raise DiagnosticError(diagnose(Code.BAD_PLUGIN_NAME, name=name, reason=reason, help=help))


def _as_name(text: str) -> str:
    plain = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    words = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", plain).lower()
    return re.sub(r"[^a-z0-9]+", "_", words.removeprefix("roadlang-")).strip("_")


def _is_shipped(registry: Registry, verb: str, name: str) -> bool:
    return any(entry.name == name and entry.origin.is_shipped for entry in registry.of(verb))


def write_plugin(name: str, verbs: Sequence[str], folder: str) -> None:
    """Write the files of a plugin with a kind of each verb to a new folder, all or none.

    Raises `DiagnosticError`: RL929 if `folder` exists, RL927 if it cannot be written.
    """
    try:
        exists = os.path.lexists(folder)
        if not exists:
            _write(plugin_files(name, verbs), Path(folder))
    except (OSError, ValueError) as error:
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        raise DiagnosticError(
            diagnose(Code.UNWRITABLE_OUTPUT, path=folder, reason=reason)
        ) from None
    if exists:
        help = "choose another name, or another folder with `--folder`"
        raise DiagnosticError(diagnose(Code.FILE_EXISTS, path=folder, help=help))


def _write(texts: Mapping[str, str], folder: Path) -> None:
    folder.parent.mkdir(parents=True, exist_ok=True)
    temporary = Path(tempfile.mkdtemp(prefix=".roadlang-", dir=folder.parent))
    try:
        for path, text in texts.items():
            target = temporary / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
        temporary.chmod(0o755)  # temporary folders are closed to others
        temporary.rename(folder)
    except BaseException:
        shutil.rmtree(temporary, ignore_errors=True)
        raise


def plugin_files(name: str, verbs: Sequence[str]) -> dict[str, str]:
    """The files of a plugin by their paths in its folder."""
    module = f"roadlang_{name}"
    words = {
        "NAME": name,
        "CLASS": "".join(word.capitalize() for word in name.split("_")),
        "DISTRIBUTION": f"roadlang-{name.replace('_', '-')}",
        "MODULE": module,
        "CODE": name.replace("_", "").upper(),
        "ROADLANG": f"roadlang>={API_VERSION},<{_next_minor(API_VERSION)}",
    }
    scenes = {verb: _filled(f"{verb}.rl", words).strip() for verb in verbs}
    words["KINDS"] = "\n".join(f"- the kind `{verb} {name}`" for verb in verbs)
    words["EXAMPLES"] = "\n\n".join(f"```roadlang\n{scene}\n```" for scene in scenes.values())
    words["ENTRIES"] = "\n".join(
        f'"{verb}.{name}" = "{module}.{verb}_{name}:{words["CLASS"]}"' for verb in verbs
    )
    words["SCENES"] = "\n".join(f'    "{v}": {_quoted(text)},' for v, text in scenes.items())
    texts = {
        "pyproject.toml": _filled("pyproject.toml", words),
        "README.md": _filled("README.md", words),
        ".gitignore": _filled("gitignore", words),
        f"src/{module}/__init__.py": _filled("__init__.py", words),
        f"src/{module}/py.typed": "",
        "tests/test_plugin.py": _filled("test_plugin.py", words),
    }
    for verb in verbs:
        about = {**words, "SCENE": scenes[verb]}
        texts[f"src/{module}/{verb}_{name}.py"] = _filled(f"{verb}.py", about)
        texts[f"tests/test_{verb}_{name}.py"] = _filled(f"{verb}_test.py", about)
        if verb in _DATA:
            texts[f"tests/{_DATA[verb]}.{name}"] = _filled(f"{verb}.data", about)
    return texts


def _quoted(text: str) -> str:
    """A scene as a text of Python; pictures that are typed in it stand in double quotes."""
    quotes = "'''" if '"""' in text else '"""'
    return f"{quotes}\n{text}\n{quotes}"


def _next_minor(version: str) -> str:
    major, minor = version.split(".")
    return f"{major}.{int(minor) + 1}"


def _filled(template: str, words: dict[str, str]) -> str:
    text = (_TEMPLATES / f"{template}.txt").read_text(encoding="utf-8")
    return re.sub(r"\{\{([A-Z_]+)\}\}", lambda match: words[match[1]], text)
