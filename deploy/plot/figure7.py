#!/usr/bin/python3
"""Draws the paper's Fig. 7 from a trial: what the robot felt and did while it moved its object.

Panels over time: the inclination signal BS and the joint signal AS with their thresholds, and the angles
of the T- and C-joints of the left legs, shaded by behaviour. Reads the tables of

    scarab-log export trial.mcap --format csv --topic scarab/behaviour   > behaviour.csv
    scarab-log export trial.mcap --format csv --topic scarab/robot_state > robot_state.csv
    figure7.py --behaviour behaviour.csv --robot-state robot_state.csv --output figure7

or, to draw again, the table it wrote itself: figure7.py --table figure7.csv --output figure7.
"""

import argparse
import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])

from report.failure import ReportError  # noqa: E402
from report.signal_table import join_tables, read_table, write_table  # noqa: E402


def main() -> int:
    options = parse_options()
    try:
        source = options.table
        if source is None:
            source = options.output.with_suffix(".csv")
            write_table(source, join_tables(options.behaviour, options.robot_state))
        table = read_table(source)  # so that drawing again from the table gives the same figure
    except (OSError, ReportError) as error:
        print(f"figure7.py: {error}", file=sys.stderr)
        return 1
    from report.figures.sequence import draw_signals  # matplotlib only where there is something to draw
    draw_signals(table, options.output)
    return 0


def parse_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--behaviour", type=Path, metavar="CSV", help="samples of scarab/behaviour")
    parser.add_argument("--robot-state", type=Path, metavar="CSV",
                        help="samples of scarab/robot_state of the same trial")
    parser.add_argument("--table", type=Path, metavar="CSV", help="table of an earlier figure")
    parser.add_argument("--output", type=Path, required=True, metavar="PREFIX",
                        help="writes PREFIX.svg, PREFIX.png and, from samples, PREFIX.csv")
    options = parser.parse_args()
    if bool(options.table) == bool(options.behaviour and options.robot_state):
        parser.error("give either --behaviour and --robot-state, or --table")
    return options


sys.exit(main())
