"""An SVG file as a part of a page."""

import re
from pathlib import Path

_NOT_IN_HTML = (r"<\?xml.*?\?>", r"<!DOCTYPE.*?>", r"<metadata>.*?</metadata>", r' xmlns(:\w+)?="[^"]*"',
                r"<!--.*?-->")


def inline_svg(file: Path, prefix: str, description: str) -> str:
    """Names nothing outside of itself; its ids begin with the prefix, so that several may stand in one page."""
    text = file.read_text()
    for pattern in _NOT_IN_HTML:
        text = re.sub(pattern, "", text, flags=re.DOTALL)
    text = text.replace("xlink:href", "href")
    text = re.sub(r'\bid="', f'id="{prefix}-', text)
    text = re.sub(r'href="#', f'href="#{prefix}-', text)
    text = re.sub(r"url\(#", f"url(#{prefix}-", text)
    text = re.sub(r'(<svg[^>]*?) (?:width|height)="[^"]*pt"', r"\1", text)
    text = re.sub(r'(<svg[^>]*?) (?:width|height)="[^"]*pt"', r"\1", text)
    return text.replace("<svg", f'<svg role="img" aria-label="{description}"', 1).strip()
