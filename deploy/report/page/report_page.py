"""report.html: one experiment, for a person."""

from pathlib import Path
from typing import List, Optional

from ..cells import Cell
from ..experiment import Experiment
from ..findings.finding import Finding, Verdict
from ..intervals import deviation, mean, median
from ..rerun import from_the_top, rerun_command, row_command
from ..trial import failure_kind
from ..wording import conditions, failures, interval, perturbation, seconds, seeds
from .inline_svg import inline_svg
from .markup import Content, Html, bullets, command, element, page, table

_SHOWN_FAILURES, _OPEN_FAILURES = 400, 20
_CLASS = {Verdict.AGREES: "agrees", Verdict.PARTLY: "partly", Verdict.DIFFERS: "differs", Verdict.OPEN: "open"}


def report_page(experiment: Experiment, directory: Path, findings: List[Finding], svg: Optional[Path],
                trouble: str) -> str:
    """`trouble` says why there is no figure, where there is none."""
    plan = experiment.plan
    kicker = " · ".join(filter(None, ["Scarab", f"experiment {plan.name}", plan.paper_figure]))
    return page(f"{plan.title} · Scarab", element("p", kicker, class_="kicker"), element("h1", plan.title),
                _banner(experiment), _figure_and_paper(experiment, svg, trouble), _findings(findings),
                _notes(plan.notes), _measured(experiment, directory), _cells(experiment),
                _failures(experiment, directory), _method())


def verdict(finding: Finding) -> Html:
    return element("span", finding.word, class_=f"verdict {_CLASS[finding.verdict]}")


def _banner(experiment: Experiment) -> Content:
    if experiment.is_complete:
        return ""
    return element("p", element("strong", f"{len(experiment.trials)} of {len(experiment.plan.trials)} trials. "),
                   "The experiment is not finished; everything below is of the trials so far. The same command goes on "
                   "where it was.", class_="banner")


def _figure_and_paper(experiment: Experiment, svg: Optional[Path], trouble: str) -> Html:
    plan = experiment.plan
    if svg is None:
        drawing = element("p", element("strong", "The figure could not be drawn: "), trouble, class_="banner")
    else:
        drawing = element("figure", Html(inline_svg(svg, plan.name, plan.title)))
    head = f"What the paper says: {plan.paper_figure}" if plan.paper_figure else "What the paper says"
    said = plan.paper or ["The paper has no such experiment."]
    return element("div", element("div", drawing),
                   element("section", element("h2", head), *(element("p", text) for text in said)), class_="beside")


def _findings(findings: List[Finding]) -> Html:
    rows = [(_statement(finding), verdict(finding), _measurement(finding)) for finding in findings]
    return element("section", element("h2", "Where Scarab agrees, and where not"),
                   table(("statement", "verdict", "measured"), rows, "findings"))


def _statement(finding: Finding) -> Html:
    return Html(element("span", finding.statement) + element("span", f" ({finding.source.value})", class_="quiet"))


def _measurement(finding: Finding) -> Html:
    why = "" if finding.verdict is Verdict.AGREES else "Why, as far as the data tell: "
    return Html((bullets(finding.numbers) if finding.numbers else "") +
                (element("p", why, finding.reason, class_="why") if finding.reason else ""))


def _notes(notes: List[str]) -> Content:
    if not notes:
        return ""
    return element("section", element("h2", "Notes"), *(element("p", note) for note in notes))


def _measured(experiment: Experiment, directory: Path) -> Html:
    plan = experiment.plan
    first = plan.trials[0]
    facts = (("trials", f"{len(experiment.trials)} of {len(plan.trials)}"),
             ("part", f"{plan.shard} of the whole experiment" if plan.shard else ""),
             ("perturbation", perturbation(plan.trials)), ("seeds", seeds(plan.trials)), ("robot", plan.robot),
             ("version", plan.version), ("configuration", plan.configuration), ("took", _took(experiment)))
    items = [part for name, text in facts if text for part in (element("dt", name), element("dd", text))]
    return element(
        "section", element("h2", "How it was measured"), command(plan.command), element("dl", *items),
        element("p", "Any one trial again, here the first, by its row; or the same without the table:"),
        command(f"{row_command(directory, first)}\n{rerun_command(first, plan.robot)}".strip()),
        element("p", "The figures and this page again:"), command(f"deploy/report/report.py {from_the_top(directory)}"))


def _took(experiment: Experiment) -> str:
    plan = experiment.plan
    if not plan.wall_s:
        return ""
    return (f"{plan.wall_s:.0f} s, for {plan.simulated_s:.0f} s of the robot's time: "
            f"{plan.simulated_s / plan.wall_s:.0f} × real time")


def _cells(experiment: Experiment) -> Html:
    rows = []
    for cell in experiment.cells:
        times = cell.times_s
        sd = deviation(times)
        rows.append((conditions(cell.key), _count(cell), interval(cell) if cell.n else "", seconds(mean(times)),
                     "" if sd is None else seconds(sd), seconds(median(times)), failures([cell])))
    return element("section", element("h2", "All cells"), table(
        ("conditions", "success", "95 % interval", "mean time", "standard deviation", "median", "failures"), rows,
        "figures"))


def _count(cell: Cell) -> str:
    if not cell.n:
        return f"0 of {cell.planned} run"
    return cell.count if cell.n == cell.planned else f"{cell.count}, {cell.planned} planned"


def _failures(experiment: Experiment, directory: Path) -> Content:
    failed = [trial for trial in experiment.trials if not trial.success]
    if not failed:
        return element("section", element("h2", "Failures"), element("p", "None."))
    rows = [(conditions(trial.asked.cell), str(trial.asked.seed), seconds(trial.time_s), failure_kind(trial.reason),
             trial.reason, element("code", row_command(directory, trial.asked))) for trial in failed[:_SHOWN_FAILURES]]
    left = len(failed) - len(rows)
    return element(
        "section", element("h2", f"Failures: {len(failed)} of {len(experiment.trials)} trials"),
        element("details", element("summary", "each with the command that runs it again"),
                table(("conditions", "seed", "after", "kind", "the referee's reason", "again"), rows),
                element("p", f"and {left} more, in results.csv") if left else "",
                **({"open": "open"} if len(failed) <= _OPEN_FAILURES else {})))


def _method() -> Html:
    return element("section", element("h2", "How to read the numbers"), element(
        "p", "Intervals of shares are Wilson's 95 % score intervals. Times are those of successes; ± is the sample "
             "standard deviation. Every cell has the same seeds, so that strategies are compared from the same starts: "
             "in pairs by the exact sign test, times of all arrivals by the exact rank sum test, both one-sided. No "
             "correction is made for several comparisons. Ten successes in ten trials mean a share of at least 72 %, "
             "none in ten one of at most 28 %."),
        class_="quiet")
