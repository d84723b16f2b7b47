"""Pictures of stacks as text: for a person, or as JSON."""

import json
from typing import List, Sequence, TextIO

from ..colour import Colour
from . import table
from .document import document
from .picture import Picture


def shown_as(pictures: Sequence[Picture], troubles: Sequence[str], as_json: bool, stream: TextIO,
             one_line: bool = False) -> List[str]:
    """Lines of text, to be printed to `stream`."""
    if as_json:
        return [json.dumps(document(pictures, troubles), indent=None if one_line else 1)]
    if not pictures:
        return list(troubles)
    lines: List[str] = []
    for picture in pictures:
        lines += [*([""] if lines else []), *table.lines(picture, Colour(stream))]
    return lines
