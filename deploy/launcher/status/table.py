"""The picture of a stack as lines of text for a person."""

from typing import Iterable, List, Optional, Sequence, Tuple

from ..colour import Colour
from ..places import shown
from .picture import Picture
from .processes import KEEPER, ProcessView

_HEADINGS = ("process", "pid", "up", "restarts", "cpu", "memory", "lifecycle", "health", "trial",
             "tick", "ticks/s")
_RIGHT = {"pid", "up", "restarts", "cpu", "memory", "trial", "tick", "ticks/s"}
_PAINT = {"ok": "green", "waiting": "yellow", "degraded": "yellow", "fault": "red",
          "silent": "red"}
_NOT_RUNNING = "NOT RUNNING"
_HISTOGRAMS = (("p50", "p50_s"), ("p99", "p99_s"), ("max", "max_s"))
Row = Sequence[str]


def lines(picture: Picture, colour: Colour) -> List[str]:
    """All there is to say of one stack."""
    return [*_head(picture, colour), "",
            *_aligned(_HEADINGS, [*map(lambda p: _row(picture, p), picture.processes),
                                  *map(_row_elsewhere, picture.elsewhere)], colour),
            *_section("waiting", picture.waits()),
            *_section("refused", _refused(picture)),
            *_histograms(picture, colour),
            *_section("wrong", picture.troubles(), colour, "red")]


def _head(picture: Picture, colour: Colour) -> List[str]:
    stack = picture.stack
    state = "" if stack.ready else ", starting or stopping"
    found = [colour.paint(f"DDS domain {stack.bus.domain}, {stack.kind.value} stack "
                          f"{stack.pace.words}{state}: {shown(stack.directory.path)}", "bold")]
    master = picture.tick_master
    if master and master["trial"]:
        rate = (f", {picture.ticks_per_s:.1f} ticks/s, {picture.real_time_factor:.2f} x real time"
                if picture.in_trial else ", over")
        found.append(f"trial {master['trial']}: tick {master['tick']}, "
                     f"{master['sim_time_s']:.1f} s{rate}")
    elif master:
        found.append("no trial yet")
    return found


def _row(picture: Picture, process: ProcessView) -> Row:
    restarts = str(process.crashes.restarts)
    if process.pid is None:
        return (process.name, _NOT_RUNNING, "-", restarts, *["-"] * 7)
    system = (process.name, str(process.pid), duration(process.uptime_s),
              restarts if process.name != KEEPER else "",
              f"{picture.cpu_percent[process.name]:.0f} %", f"{process.memory_bytes / 1e6:.0f} MB")
    if not process.speaks:
        return (*system, "", "", "", "", "")
    service = picture.services.get(process.service)
    if service is None:
        return (*system, "-", "silent" if picture.said is not None else "-", "-", "-", "-")
    return (*system, *_report(service))


def _row_elsewhere(service: dict) -> Row:
    name = f"{service['service']}/{service['instance']}"
    return (f"{name} on {service['host'] or 'another host'}", str(service["pid"]), "", "", "", "",
            *_report(service))


def _report(service: dict) -> Row:
    rate = f"{service['ticks_per_s']:.1f}" if service["lifecycle"] == "active" else "-"
    return (service["lifecycle"], service["health"], str(service["trial"] or "-"),
            str(service["tick"]) if service["trial"] else "-", rate)


def _aligned(headings: Row, rows: Iterable[Row], colour: Colour) -> List[str]:
    table = [tuple(headings), *map(tuple, rows)]
    widths = [max(len(row[i]) for row in table) for i in range(len(headings))]
    return [_line(row, headings, widths, colour, number == 0) for number, row in enumerate(table)]


def _line(row: Row, headings: Row, widths: Sequence[int], colour: Colour, is_heading: bool) -> str:
    cells = []
    for text, heading, width in zip(row, headings, widths):
        cell = text.rjust(width) if heading in _RIGHT else text.ljust(width)
        paint = "faint" if is_heading else _paint_of(text, heading)
        cells.append(colour.paint(cell, paint) if paint else cell)
    return "  " + "  ".join(cells).rstrip()


def _paint_of(text: str, heading: str) -> Optional[str]:
    if text == _NOT_RUNNING:
        return "red"
    return _PAINT.get(text) if heading == "health" else None


def _section(title: str, texts: Sequence[str], colour: Optional[Colour] = None,
             paint: str = "") -> List[str]:
    """The title in front of the first text, the others below it."""
    if not texts:
        return []
    head = f"{title + ':':9}"
    if colour:
        head = colour.paint(head, paint)
    first, *others = texts
    return ["", head + first, *(" " * 9 + text for text in others)]


def _refused(picture: Picture) -> List[str]:
    return [f"{service}: {', '.join(f'{name} {count}' for name, count in counts.items())}"
            for service, counts in picture.refused().items()]


def _histograms(picture: Picture, colour: Colour) -> List[str]:
    found: List[Tuple[str, ...]] = []
    for (name, instance), service in picture.services.items():
        for what, values in service["histograms"].items():
            if values["count"]:
                found.append((f"{name}/{instance} {what}",
                              *(time_text(values[key]) for _, key in _HISTOGRAMS),
                              str(values["count"])))
    if not found:
        return []
    headings = ("timing", *(title for title, _ in _HISTOGRAMS), "times")
    widths = [max(len(row[i]) for row in (headings, *found)) for i in range(len(headings))]
    rows = []
    for row in (headings, *found):
        cells = [row[0].ljust(widths[0]), *(c.rjust(w) for c, w in zip(row[1:], widths[1:]))]
        text = "  " + "  ".join(cells)
        rows.append(colour.paint(text, "faint") if row is headings else text)
    return ["", *rows]


def duration(seconds: float) -> str:
    """1:02:03, or 2:03 below an hour; days in front of what is longer."""
    whole = int(seconds)
    days, rest = divmod(whole, 86400)
    hours, rest = divmod(rest, 3600)
    clock = f"{hours}:{rest // 60:02}:{rest % 60:02}" if whole >= 3600 else \
        f"{rest // 60}:{rest % 60:02}"
    return f"{days} d {clock}" if days else clock


def time_text(seconds: float) -> str:
    """With the unit that suits: 20 us, 1.5 ms, 2 s."""
    for unit, size in (("s", 1.0), ("ms", 1e-3)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds * 1e6:.3g} us"
