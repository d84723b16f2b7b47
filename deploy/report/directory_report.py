"""The report of one experiment, from its directory."""

from pathlib import Path
from typing import List, Optional

from .experiment import read_experiment
from .failure import ReportError
from .figures import draw_figures
from .findings import findings
from .page.report_page import report_page
from .summary import write_summary


def write_report(directory: Path, bin: Path) -> List[Path]:
    """The files that were written, report.html last. ReportError where the directory's tables do not serve.

    Where only the figure cannot be drawn, the report says why and has the rest; of a finished experiment that is an
    error, too, once all else is written.
    """
    experiment = read_experiment(directory, bin)
    drawn: List[Path] = []
    trouble = ""
    try:
        drawn = draw_figures(experiment, directory)
    except ReportError as error:
        trouble = str(error)
    found = findings(experiment)
    summary, report = directory / "summary.json", directory / "report.html"
    write_summary(summary, experiment, found)
    svg: Optional[Path] = next((file for file in drawn if file.suffix == ".svg"), None)
    report.write_text(report_page(experiment, directory, found, svg, trouble))
    if trouble and experiment.is_complete:
        raise ReportError(f"the figure of {directory} could not be drawn: {trouble}")
    return [*drawn, summary, report]
