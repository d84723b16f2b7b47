#!/usr/bin/python3
"""Draws the figures of experiments again and writes their reports, from what lies in their directories.

    deploy/report/report.py runs/experiments/obstacle
    deploy/report/report.py runs/experiments/* --index runs/experiments/index.html

Exit codes: 0 all were written, 1 one could not be, 2 bad usage.
"""

import argparse
import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # this folder's name is the package's

from report import ReportError, write, write_index  # noqa: E402


def main() -> int:
    options = parse_options()
    written, failed = [], False
    for directory in options.directory:
        try:
            files = write(directory, options.bin)
            print(files[-1])
            written.append(directory)
        except (ReportError, OSError) as error:
            print(f"report.py: {error}", file=sys.stderr)
            failed = True
    if options.index and written:
        print(write_index(written, options.index))
    return 1 if failed else 0


def parse_options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, allow_abbrev=False,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", type=Path, nargs="+", help="of an experiment, with plan.json and results.csv")
    parser.add_argument("--index", type=Path, metavar="FILE", help="writes one page over all of them, too")
    parser.add_argument("--bin", type=Path, metavar="DIRECTORY",
                        help="where scarab-log is (SCARAB_BIN, or build/release/bin)")
    options = parser.parse_args()
    for directory in options.directory:
        if not directory.is_dir():
            parser.error(f"{directory} is no directory")
    return options


if __name__ == "__main__":
    sys.exit(main())
