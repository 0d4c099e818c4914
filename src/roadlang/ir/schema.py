"""JSON Schemas, derived from dataclasses: the one writer for scenes, manifests, scenarios, kinds.

Descriptions are the docstrings of the classes and the texts below their fields.
"""

from __future__ import annotations

import dataclasses
import types
import typing
from collections.abc import Mapping
from typing import Any

from .field_docs import class_doc, field_docs
from .read_only import FrozenDict

Schema = dict[str, Any]

_DRAFT = "https://json-schema.org/draft/2020-12/schema"
_PLAIN = {str: "string", int: "integer", bool: "boolean", float: "number", type(None): "null"}


def document(
    identifier: str,
    body: Schema,
    *,
    title: str = "",
    definitions: Mapping[str, Schema] | None = None,
) -> Schema:
    """A whole schema: `body`, with what its references name."""
    head = {"$schema": _DRAFT, "$id": identifier, "title": title or identifier}
    return {**head, **body, **({"$defs": dict(definitions)} if definitions else {})}


def any_of(alternatives: list[Schema]) -> Schema:
    """One of several; a single one stands for itself."""
    return alternatives[0] if len(alternatives) == 1 else {"anyOf": alternatives}


def array(item: Schema, least: int = 0, most: int | None = None) -> Schema:
    """A list of items of one kind."""
    schema: Schema = {"type": "array", "items": item}
    if least:
        schema["minItems"] = least
    if most is not None:
        schema["maxItems"] = most
    return schema


def reference(name: str) -> Schema:
    """A reference to a definition of the document."""
    return {"$ref": f"#/$defs/{name}"}


def schema_of_dataclass(
    kind: type,
    members: Mapping[str, Schema] | None = None,
    definitions: Mapping[str, Schema] | None = None,
) -> Schema:
    """The document of a dataclass with a `schema` field, `Scene` or `Manifest`.

    `members` are the schemas of members whose type says less, by `Class.field`; `definitions` has
    what they refer to.
    """
    version = kind.__dataclass_fields__["schema"].default  # type: ignore[attr-defined]
    writer = DataclassWriter({f"{kind.__name__}.schema": {"const": version}, **(members or {})})
    body = writer.of(kind)
    writer.definitions[kind.__name__]["required"].insert(0, "schema")
    return document(version, body, definitions={**writer.definitions, **(definitions or {})})


UNWRITTEN: Mapping[str, bool] = {"unwritten": True}
"""The metadata of a field that JSON leaves out: where something was read, which may be forgotten"""


def written_fields(kind: Any) -> tuple[dataclasses.Field[Any], ...]:
    """The fields of a dataclass that JSON has."""
    return tuple(f for f in dataclasses.fields(kind) if not f.metadata.get("unwritten"))


class DataclassWriter:
    """Writes the schemas of types; `definitions` gathers the dataclasses met on the way.

    `special` are types whose JSON is not that of their fields. With a `tag` each object names its
    class in that member and has all members, defaults too. `number` is what a float may be.
    """

    def __init__(
        self,
        members: Mapping[str, Schema] | None = None,
        *,
        special: Mapping[Any, Schema] | None = None,
        tag: str = "",
        number: Schema | None = None,
    ) -> None:
        self.definitions: dict[str, Schema] = {}
        self._members = members or {}
        self._special = special or {}
        self._tag = tag
        self._number = number or {"type": "number"}

    def of(self, hint: Any) -> Schema:
        """The schema of a type."""
        if hint in self._special:
            return self._special[hint]
        if hint is float:
            return self._number
        if hint in _PLAIN:
            return {"type": _PLAIN[hint]}
        if dataclasses.is_dataclass(hint):
            return self._reference(hint)
        origin, arguments = typing.get_origin(hint), typing.get_args(hint)
        if origin in (typing.Union, types.UnionType):
            return any_of([self.of(argument) for argument in arguments])
        if origin is typing.Literal:
            return {"enum": list(arguments)}
        if origin is tuple and arguments[1:] == (Ellipsis,):
            return array(self.of(arguments[0]))
        if origin is tuple:
            items = [self.of(argument) for argument in arguments]
            return {"type": "array", "prefixItems": items, "minItems": len(items), "items": False}
        if origin is FrozenDict:  # in order, as pairs
            items = [self.of(argument) for argument in arguments]
            return array({"type": "array", "prefixItems": items, "minItems": 2, "items": False})
        if origin is not None and issubclass(origin, Mapping):
            return {"type": "object", "additionalProperties": self.of(arguments[1])}
        if hint is Any:
            return {}
        raise TypeError(f"no JSON Schema for {hint!r}")

    def _reference(self, kind: Any) -> Schema:
        name = kind.__name__
        if name not in self.definitions:
            self.definitions[name] = {}  # a class may contain itself
            self.definitions[name] = self._object(kind)
        return reference(name)

    def _object(self, kind: Any) -> Schema:
        hints, docs = typing.get_type_hints(kind), field_docs(kind)
        properties: dict[str, Schema] = {}
        if self._tag:
            properties[self._tag] = {"const": kind.__name__}
        required = list(properties)
        for field in written_fields(kind):
            known = self._members.get(f"{kind.__name__}.{field.name}")
            schema = dict(self.of(hints[field.name]) if known is None else known)
            if field.name in docs:
                schema = {"description": docs[field.name], **schema}
            has_default = field.default is not dataclasses.MISSING
            if self._tag or not (has_default or field.default_factory is not dataclasses.MISSING):
                required.append(field.name)
            elif has_default and "const" not in schema:
                schema["default"] = field.default
            properties[field.name] = schema
        return {
            "description": class_doc(kind),
            "type": "object",
            "properties": properties,
            "required": required,
        }
