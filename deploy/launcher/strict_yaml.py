"""Strict reading of YAML: every mistake is one line `file:line:col: key: reason`.

PyYAML alone accepts duplicate keys and says nothing of unknown ones; this walks its node graph, which
still knows the place of every word, instead of the plain values.
"""

import difflib
import math
import re
from pathlib import Path
from typing import Dict, Iterable, List, NoReturn, Optional

import yaml

from .failure import ConfigError

_INTEGER = "tag:yaml.org,2002:int"
_FLOAT = "tag:yaml.org,2002:float"
_BOOLEAN = "tag:yaml.org,2002:bool"
_STRING = "tag:yaml.org,2002:str"
_KIND_NAMES = {_INTEGER: "an integer", _FLOAT: "a number", _BOOLEAN: "a boolean",
               _STRING: "a text", "tag:yaml.org,2002:null": "nothing"}


class Value:
    """A node of the file, with its key path (such as services.plant.binary)."""

    def __init__(self, file: Path, key: str, node: yaml.Node):
        self._file = file
        self.key = key
        self._node = node

    def fail(self, reason: str, key: Optional[str] = None,
             node: Optional[yaml.Node] = None) -> NoReturn:
        mark = (node or self._node).start_mark
        raise ConfigError(self._file, mark.line + 1, mark.column + 1, key or self.key, reason)

    def mapping(self, allowed: Optional[Iterable[str]] = None) -> Dict[str, "Value"]:
        """Keys and values; `allowed` None takes any key, else an unknown one is an error."""
        if not isinstance(self._node, yaml.MappingNode):
            self.fail(f"expected a mapping, found {self._kind()}")
        known = None if allowed is None else list(allowed)
        found: Dict[str, Value] = {}
        for key_node, value_node in self._node.value:
            name = str(key_node.value)
            path = name if self.key == "file" else f"{self.key}.{name}"
            if name in found:
                self.fail("duplicate key", path, key_node)
            if known is not None and name not in known:
                self.fail(f"unknown key{did_you_mean(name, known)}", path, key_node)
            found[name] = Value(self._file, path, value_node)
        return found

    def at(self, *names: str) -> "Value":
        """A part of nested mappings that is known to be there."""
        part = self
        for name in names:
            part = part.mapping()[name]
        return part

    def fields(self, required: Iterable[str], optional: Iterable[str] = ()) -> Dict[str, "Value"]:
        """A mapping with exactly these keys."""
        required = list(required)
        found = self.mapping([*required, *optional])
        for name in required:
            if name not in found:
                path = name if self.key == "file" else f"{self.key}.{name}"
                self.fail("missing key", path)
        return found

    def sequence(self) -> List["Value"]:
        if not isinstance(self._node, yaml.SequenceNode):
            self.fail(f"expected a list, found {self._kind()}")
        return [Value(self._file, f"{self.key}[{i}]", node)
                for i, node in enumerate(self._node.value)]

    def text(self, empty: bool = False) -> str:
        value = self._scalar([_STRING], "a text")
        if not value and not empty:
            self.fail("must not be empty")
        return value

    def choice(self, options: Iterable[str]) -> str:
        options = list(options)
        value = self._scalar([_STRING], "a text")
        if value not in options:
            self.fail(f"unknown value '{value}'{did_you_mean(value, options)}; "
                      f"one of {', '.join(options)}")
        return value

    def boolean(self) -> bool:
        text = self._scalar([_BOOLEAN], "true or false")
        if text not in ("true", "false"):  # YAML 1.1 would take yes, on, ... too
            self.fail(f"expected true or false, found '{text}'")
        return text == "true"

    def integer(self, low: int, high: int) -> int:
        text = self._scalar([_INTEGER], "an integer")
        if not re.fullmatch(r"[+-]?(0|[1-9][0-9]*)", text):  # YAML 1.1 would read 010 as 8
            self.fail(f"expected a decimal integer, found '{text}'")
        value = int(text)
        if not low <= value <= high:
            self.fail(f"{value} is out of range [{low}, {high}]")
        return value

    def number(self, low: float, high: float) -> float:
        text = self._scalar([_INTEGER, _FLOAT], "a number")
        try:
            value = float(text)
        except ValueError:
            self.fail(f"expected a finite number, found '{text}'")
        if not math.isfinite(value):
            self.fail(f"expected a finite number, found '{text}'")
        if not low <= value <= high:
            self.fail(f"{text} is out of range [{low:g}, {high:g}]")
        return value

    def _scalar(self, tags: List[str], expected: str) -> str:
        if not isinstance(self._node, yaml.ScalarNode) or self._node.tag not in tags:
            self.fail(f"expected {expected}, found {self._kind()}")
        return self._node.value

    def _kind(self) -> str:
        if isinstance(self._node, yaml.MappingNode):
            return "a mapping"
        if isinstance(self._node, yaml.SequenceNode):
            return "a list"
        kind = _KIND_NAMES.get(self._node.tag, self._node.tag)
        return f"{kind} '{self._node.value}'" if self._node.value else kind


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """` (did you mean 'x'?)`, or nothing where no known word is near."""
    near = difflib.get_close_matches(word, list(known), n=1, cutoff=0.6)
    return f" (did you mean '{near[0]}'?)" if near else ""


def read_yaml(file: Path) -> Value:
    """The top of the file. ConfigError where it cannot be read or is not YAML."""
    try:
        text = file.read_text(encoding="utf-8")
    except OSError as error:
        raise ConfigError(file, 1, 1, "file", f"cannot be read: {error.strerror}") from None
    except UnicodeDecodeError:
        raise ConfigError(file, 1, 1, "file", "is not UTF-8 text") from None
    try:
        node = yaml.compose(text, Loader=yaml.SafeLoader)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line, column = (mark.line + 1, mark.column + 1) if mark else (1, 1)
        raise ConfigError(file, line, column, "file", f"not valid YAML: {error.problem}") from None
    except yaml.YAMLError as error:
        reason = str(error).splitlines()[0]
        raise ConfigError(file, 1, 1, "file", f"not valid YAML: {reason}") from None
    if node is None:
        raise ConfigError(file, 1, 1, "file", "is empty")
    return Value(file, "file", node)
