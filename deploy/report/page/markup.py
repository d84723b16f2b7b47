"""Pieces of HTML. Whatever text goes in is escaped; what is HTML already says so by its type."""

from html import escape
from pathlib import Path
from typing import Iterable, Sequence, Union


class Html(str):
    """Text that is HTML."""


Content = Union[str, Html]
STYLE_SHEET = Path(__file__).with_name("style.css")


def html(content: Content) -> Html:
    return content if isinstance(content, Html) else Html(escape(content))


def element(tag: str, *content: Content, **attributes: str) -> Html:
    """class_ stands for class."""
    words = "".join(f' {name.rstrip("_")}="{escape(value)}"' for name, value in attributes.items())
    return Html(f"<{tag}{words}>{''.join(map(html, content))}</{tag}>\n")


def bullets(items: Iterable[Content]) -> Html:
    return element("ul", *(element("li", item) for item in items))


def table(head: Sequence[Content], rows: Iterable[Sequence[Content]], class_: str = "") -> Html:
    """Wide ones scroll sideways by themselves. Each field knows its head, for narrow screens."""
    body = [element("tr", *(element("td", field, **{"data-head": name}) for name, field in zip(head, row)))
            for row in rows]
    whole = element("table", element("thead", element("tr", *(element("th", name, scope="col") for name in head))),
                    element("tbody", *body), class_=class_)
    return element("div", whole, class_="scrolls")


def command(text: str) -> Html:
    return element("pre", element("code", text))


def page(title: str, *content: Content) -> str:
    """A whole document that needs no other file."""
    head = "".join([
        '<meta charset="utf-8">\n<meta name="viewport" content="width=device-width, initial-scale=1">\n',
        element("title", title), element("style", Html(STYLE_SHEET.read_text()))])
    body = element("body", element("main", *content))
    return f'<!DOCTYPE html>\n<html lang="en">\n<head>\n{head}</head>\n{body}</html>\n'
