"""Values for params from YAML files: a map of them, or a list of maps."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..diagnostics import Code, Diagnostic, DiagnosticError, Source, Span, diagnose
from ..files.reading import UnreadableFile, read_file, written_text
from .params import is_param_name, param_texts

if TYPE_CHECKING:
    import yaml

LARGEST = 4_000_000
"""bytes"""
_MOST_ITEMS = 10_000
"""of one value"""


@dataclass(frozen=True)
class ParamFile:
    """`sets`: the value of each param, with its place in the file. Of a file that holds a list each
    of its maps, of one that holds a map this one."""

    path: str
    sha256: str
    sets: tuple[Mapping[str, Source], ...]
    is_list: bool


def read_params(name: str) -> ParamFile:
    """The values in a file. Texts are as in the language (`12m`), numbers have no unit.

    Raises `DiagnosticError`: RL920, RL922 and RL936 where it cannot be read, RL937 for what is no
    value of a param.
    """
    import yaml

    source, digest = _read(name)
    try:
        root = yaml.compose(source.text, Loader=yaml.SafeLoader)
    except yaml.MarkedYAMLError as error:
        raise DiagnosticError(_malformed(source, error)) from None
    except (yaml.YAMLError, RecursionError) as error:
        reason = " ".join(str(error).split())
        raise DiagnosticError(diagnose(Code.MALFORMED_YAML, path=name, reason=reason)) from None
    reader = _ParamReader(source)
    is_list = isinstance(root, yaml.SequenceNode)
    maps = root.value if isinstance(root, yaml.SequenceNode) else [root]
    sets = tuple(reader.values(node) for node in maps)
    if not sets:
        reader.report(
            source.span(0, 0), "the list is empty", "write params for each run: `- reach: 12m`"
        )
    if reader.faults:
        raise DiagnosticError(*reader.faults)
    return ParamFile(name, digest, sets, is_list)


def _read(name: str) -> tuple[Source, str]:
    try:
        data = read_file(Path(name), LARGEST)
        return Source(name, written_text(data)), hashlib.sha256(data).hexdigest()
    except UnreadableFile as error:
        fault = diagnose(Code.UNREADABLE_FILE, path=name, reason=error.reason)
    except UnicodeDecodeError:
        fault = diagnose(Code.NOT_UTF8, path=name, reason="it is not text")
    raise DiagnosticError(fault) from None


def _malformed(source: Source, error: yaml.MarkedYAMLError) -> Diagnostic:
    mark = error.problem_mark or error.context_mark
    at = mark.index if mark is not None else 0
    span = source.span(at, min(at + 1, len(source.text)))
    return diagnose(Code.MALFORMED_YAML, span, reason=error.problem or "it cannot be parsed")


class _ParamReader:
    """Collects the faults of a file."""

    def __init__(self, source: Source) -> None:
        self._source = source
        self.faults: list[Diagnostic] = []

    def report(self, span: Span, reason: str, help_: str) -> None:
        self.faults.append(diagnose(Code.NOT_A_PARAM, span, reason=reason, help=help_))

    def values(self, node: yaml.Node | None) -> dict[str, Source]:
        """The params of a map."""
        import yaml

        if not isinstance(node, yaml.MappingNode):
            start, end = (0, 0) if node is None else _ends(node)
            self.report(
                self._source.span(start, end),
                "expected params with their values",
                "write each on a line of its own: `reach: 12m`",
            )
            return {}
        found: dict[str, Source] = {}
        for key, value in node.value:
            if not isinstance(key, yaml.ScalarNode) or not is_param_name(key.value):
                self.report(
                    self._source.span(*_ends(key)),
                    "this is not the name of a param",
                    "names have letters, digits and `_`, and begin with a letter",
                )
            elif key.value in found:
                self.report(
                    self._source.span(*_ends(key)),
                    f"`{key.value}` is set twice",
                    "keep one of them",
                )
            else:
                text = self._text(key.value, value)
                if text is not None:
                    found[key.value] = text
        return found

    def _text(self, name: str, node: yaml.Node) -> Source | None:
        """A value as it would be written in a scene file, at its place."""
        import yaml

        start, end = _ends(node)
        try:
            text = param_texts({name: _plain(node, iter(range(_MOST_ITEMS)))})[name]
        except _ReadTwoWays as error:
            self.report(
                self._source.span(*_ends(error.node)),
                f"YAML 1.1 reads `{error.node.value}` as {error}, YAML 1.2 does not",
                "write a number without leading zeros, `true` or `false`, or a text in quotes",
            )
            return None
        except (TypeError, ValueError, RecursionError, yaml.YAMLError):
            self.report(
                self._source.span(start, end),
                f"`{name}` cannot have this value",
                "write a number, a text such as `12m`, true, false, or a list of these",
            )
            return None
        written = self._source.text[start:end]
        if written == text:
            return self._source.part(start, end)
        if written[:1] in "'\"" and written[1:-1] == text:
            return self._source.part(start + 1, end - 1)
        return Source(f"{self._source.path}:{self._source.position(start)[0]}", text)


class _ReadTwoWays(Exception):
    """A plain word or number that is another value in YAML 1.2 than in YAML 1.1, which PyYAML
    reads: `010` is 8 there, `1:30` 90, and `yes` true."""

    def __init__(self, node: yaml.ScalarNode, value: str) -> None:
        super().__init__(value)
        self.node = node


_CORE = {
    "bool": re.compile(r"true|True|TRUE|false|False|FALSE"),
    "int": re.compile(r"[-+]?(0|[1-9][0-9]*)|0x[0-9a-fA-F]+"),
    "float": re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?|[-+]?\.\w+"),
}
"""What both versions read alike, of each type: of the core schema of YAML 1.2, section 10.3.2."""


def _is_of_old_yaml(node: yaml.ScalarNode) -> bool:
    alike = _CORE.get(node.tag.rpartition(":")[2])
    return alike is not None and alike.fullmatch(node.value) is None


def _ends(node: yaml.Node) -> tuple[int, int]:
    return node.start_mark.index, node.end_mark.index


def _plain(node: yaml.Node, budget: Iterator[int]) -> Any:
    """The Python value of a node. Raises `TypeError`, `ValueError` for what is no value."""
    import yaml

    if next(budget, None) is None:  # aliases of aliases grow without end
        raise ValueError("too many items")
    if isinstance(node, yaml.SequenceNode) and node.tag.endswith(":seq"):
        return [_plain(item, budget) for item in node.value]
    if isinstance(node, yaml.ScalarNode):
        value = yaml.constructor.SafeConstructor().construct_object(node)
        if node.style is None and _is_of_old_yaml(node):
            raise _ReadTwoWays(node, param_texts({"value": value})["value"])
        return value
    raise TypeError(node.tag)
