"""What a YAML file may hold, declared once: it reads the file strictly, and it is the file's JSON Schema."""

import re
from dataclasses import dataclass, field
from typing import Dict, List, Protocol, Tuple

from .strict_yaml import Value

Schema = Dict[str, object]


class Part(Protocol):
    """A part of the file."""

    note: str

    def read(self, value: Value) -> object:
        """The plain value. ConfigError, with the place, for anything else than what is declared."""

    def schema(self) -> Schema:
        """Without the note, which is the description."""


@dataclass(frozen=True)
class Text:
    """`pattern` is searched for; where it is not found, the text `is` that which `otherwise` says."""

    note: str = ""
    empty: bool = False
    pattern: str = ""
    otherwise: str = ""

    def read(self, value: Value) -> str:
        text = value.text(self.empty)
        if not re.search(self.pattern, text):
            value.fail(f"'{text}' is {self.otherwise}")
        return text

    def schema(self) -> Schema:
        length = {} if self.empty else {"minLength": 1}
        return {"type": "string", **length, **({"pattern": self.pattern} if self.pattern else {})}


@dataclass(frozen=True)
class Choice:
    options: Tuple[str, ...]
    note: str = ""

    def read(self, value: Value) -> str:
        return value.choice(self.options)

    def schema(self) -> Schema:
        return {"enum": list(self.options)}


@dataclass(frozen=True)
class Integer:
    low: int
    high: int
    note: str = ""

    def read(self, value: Value) -> int:
        return value.integer(self.low, self.high)

    def schema(self) -> Schema:
        return {"type": "integer", "minimum": self.low, "maximum": self.high}


@dataclass(frozen=True)
class Number:
    low: float
    high: float
    note: str = ""

    def read(self, value: Value) -> float:
        return value.number(self.low, self.high)

    def schema(self) -> Schema:
        return {"type": "number", "minimum": self.low, "maximum": self.high}


@dataclass(frozen=True)
class Boolean:
    note: str = ""

    def read(self, value: Value) -> bool:
        return value.boolean()

    def schema(self) -> Schema:
        return {"type": "boolean"}


@dataclass(frozen=True)
class ListOf:
    item: Part
    note: str = ""
    least: int = 0

    def read(self, value: Value) -> List[object]:
        items = [self.item.read(v) for v in value.sequence()]
        if len(items) < self.least:
            value.fail("must name at least one")
        return items

    def schema(self) -> Schema:
        return {"type": "array", "items": described(self.item), "minItems": self.least}


@dataclass(frozen=True)
class Fields:
    """A mapping with exactly these keys."""

    required: Dict[str, Part]
    optional: Dict[str, Part] = field(default_factory=dict)
    note: str = ""

    def read(self, value: Value) -> Dict[str, object]:
        found = value.fields(self.required, self.optional)
        parts = {**self.required, **self.optional}
        return {name: parts[name].read(v) for name, v in found.items()}

    def schema(self) -> Schema:
        parts = {**self.required, **self.optional}
        return {"type": "object", "additionalProperties": False, "required": list(self.required),
                "properties": {name: described(part) for name, part in parts.items()}}


@dataclass(frozen=True)
class Named:
    """A mapping from names of the writer's choice."""

    item: Part
    note: str = ""
    name: str = r"^[a-z][a-z0-9_-]*$"

    def read(self, value: Value) -> Dict[str, object]:
        items = value.mapping()
        for name, item in items.items():
            if not re.search(self.name, name):
                item.fail(f"'{name}' is no name (small letters, digits, _ and -)")
        return {name: self.item.read(v) for name, v in items.items()}

    def schema(self) -> Schema:
        return {"type": "object", "additionalProperties": described(self.item),
                "propertyNames": {"pattern": self.name}}


def described(part: Part) -> Schema:
    return {**({"description": part.note} if part.note else {}), **part.schema()}
