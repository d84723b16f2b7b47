"""index.html of `experiment all`: every figure, and a table paper / Scarab / command."""

import json
import os
from pathlib import Path
from typing import Any, Dict, List, Tuple

from ..failure import ReportError
from .inline_svg import inline_svg
from .markup import Html, bullets, element, page, table

_SHOWN_NUMBERS = 3  # of a finding; its report has them all
_CLASS = {"agrees": "agrees", "met": "agrees", "partly": "partly", "partly met": "partly", "does not agree": "differs",
          "not met": "differs"}


def write_index_page(directories: List[Path], out: Path) -> Path:
    """From summary.json and the SVG of each; ReportError where one has not been reported."""
    reports = [(directory, _summary(directory)) for directory in directories]
    rows = [row for directory, summary in reports for row in _rows(directory, summary, out)]
    figures = [_figure(directory, summary, out) for directory, summary in reports]
    of_paper, of_aims = _tally(reports, "paper"), _tally(reports, "aim of Scarab")
    out.write_text(page(
        "Scarab: the paper's experiments", element("p", "Scarab", class_="kicker"),
        element("h1", "The paper's experiments, reproduced"),
        element("p", f"Of the paper's statements that were tested {of_paper} agree; of the aims beyond it {of_aims} "
                     "are met. Each experiment has a report of its own with the conditions, all numbers and the "
                     "command that runs any one trial again."),
        element("h2", "Paper, Scarab, command"),
        table(("experiment", "paper", "Scarab", "command"), rows, "findings overview"), *figures))
    return out


def _tally(reports: List[Tuple[Path, Dict[str, Any]]], source: str) -> str:
    verdicts = [finding["verdict"] for _, summary in reports for finding in summary["findings"]
                if finding["source"] == source]
    return f"{sum(verdict in ('agrees', 'met') for verdict in verdicts)} of {len(verdicts)}"


def _summary(directory: Path) -> Dict[str, Any]:
    file = directory / "summary.json"
    try:
        return json.loads(file.read_text())
    except (OSError, ValueError) as error:
        raise ReportError(f"{file}: {error}") from None


def _rows(directory: Path, summary: Dict[str, Any], out: Path) -> List[tuple]:
    rows = []
    for i, finding in enumerate(summary["findings"]):
        verdict = element("span", finding["verdict"], class_=f"verdict {_CLASS.get(finding['verdict'], 'open')}")
        source = "" if finding["source"] == "paper" else f" ({finding['source']})"
        name = Html(_link(directory, summary, out) + element("span", f" {summary['paper_figure']}", class_="quiet"))
        measured = Html(verdict + bullets(finding["numbers"][:_SHOWN_NUMBERS]))
        rows.append((name if i == 0 else "", finding["statement"] + source, measured,
                     element("code", summary["command"]) if i == 0 else ""))
    return rows


def _figure(directory: Path, summary: Dict[str, Any], out: Path) -> Html:
    svg = directory / f"{summary['name']}.svg"
    drawing = element("figure", Html(inline_svg(svg, summary["name"], summary["title"]))) if svg.is_file() else \
        element("p", "No figure was drawn.", class_="banner")
    state = "" if summary["complete"] else f" ({summary['trials']} of {summary['planned']} trials)"
    title = " · ".join(filter(None, [summary["paper_figure"], summary["title"]]))
    link = element("p", _link(directory, summary, out), class_="quiet")
    return element("section", element("h2", title, state), drawing, link)


def _link(directory: Path, summary: Dict[str, Any], out: Path) -> Html:
    report = os.path.relpath(directory / "report.html", out.parent)
    return element("a", summary["name"], href=report)
