"""An SVG file as a part of a page."""

import re
from html import escape
from pathlib import Path

_NOT_IN_HTML = (r"<\?xml.*?\?>", r"<!DOCTYPE.*?>", r"<metadata>.*?</metadata>", r' xmlns(:\w+)?="[^"]*"',
                r"<!--.*?-->")

# Pixels a point of print: larger looks coarse, smaller is not legible (a phone scrolls instead).
_LARGEST, _SMALLEST = 1.9, 1.1


def inline_svg(file: Path, prefix: str, description: str) -> str:
    """Names nothing outside of itself; its ids begin with the prefix, so that several may stand in one page."""
    text = file.read_text()
    for pattern in _NOT_IN_HTML:
        text = re.sub(pattern, "", text, flags=re.DOTALL)
    text = text.replace("xlink:href", "href")
    text = re.sub(r'\bid="', f'id="{prefix}-', text)
    text = re.sub(r'href="#', f'href="#{prefix}-', text)
    text = re.sub(r"url\(#", f"url(#{prefix}-", text)
    width_pt = float(re.search(r'<svg[^>]* width="([\d.]+)pt"', text).group(1))
    for _ in ("width", "height"):
        text = re.sub(r'(<svg[^>]*?) (?:width|height)="[^"]*pt"', r"\1", text, count=1)
    words = (f'role="img" aria-label="{escape(description)}" '
             f'style="max-width: {width_pt * _LARGEST:.0f}px; min-width: {width_pt * _SMALLEST:.0f}px"')
    return text.replace("<svg", f"<svg {words}", 1).strip()
