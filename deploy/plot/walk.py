#!/usr/bin/python3
"""Says how a robot walked, and draws it: the way of its trunk, its footprints, its gait.

Reads the samples of scarab/world_state of one or more logs, a row for each trial:

    scarab-log export trial.mcap --format csv --topic scarab/world_state --elements 16 > forward.csv
    walk.py forward.csv backward.csv --output walk

Without --output it only prints the table.
"""

import argparse
import sys
from pathlib import Path

from walk_table import WalkTableError, read_walks

_HEAD = f"{'walk':20} {'trial':>5} {'time s':>7} {'m/s':>7} {'turned deg':>10} {'sideways m':>10} {'tilt deg':>8}"


def main() -> int:
    options = parse_options()
    try:
        found = {file.stem: read_walks(file) for file in options.world}
    except (OSError, WalkTableError) as error:
        print(f"walk.py: {error}", file=sys.stderr)
        return 1
    print(_HEAD)
    for name, walks in found.items():
        for walk in walks:
            print(f"{name:20} {walk.trial:5d} {walk.time_s:7.1f} {walk.speed_m_s:+7.3f} "
                  f"{walk.turned_deg:+10.1f} {walk.sideways_m:+10.2f} {walk.tilt_deg:8.1f}")
    if options.output:
        from walk_panels import draw  # matplotlib only where there is something to draw
        draw({name: walks[0] for name, walks in found.items()}, options.output)
    return 0


def parse_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("world", type=Path, nargs="+", metavar="CSV",
                        help="samples of scarab/world_state with their contacts")
    parser.add_argument("--output", type=Path, metavar="PREFIX",
                        help="draws the first trial of each to PREFIX.svg and PREFIX.png")
    options = parser.parse_args()
    stems = [file.stem for file in options.world]
    if len(set(stems)) < len(stems):
        parser.error("two tables have the same name; a walk is called after its file")
    return options


sys.exit(main())
