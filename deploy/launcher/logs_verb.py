"""`scarab logs`: what the processes wrote."""

import argparse
import os

from .failure import EXIT_OK, Failure, UsageError
from .places import Places, shown
from .run_directory import RunDirectory
from .running_stack import choose_stack
from .service_child import last_lines
from .strict_yaml import did_you_mean


def logs(options: argparse.Namespace, places: Places) -> int:
    """Of the running stack, else of the latest run."""
    stack = choose_stack(places.runs, options.domain)
    directory = stack.directory if stack else RunDirectory((places.runs / "latest").resolve())
    files = sorted(directory.logs.glob("*.log"))
    if not files:
        raise Failure(f"there are no logs yet in {shown(places.runs)}")
    if options.service:
        names = [f.stem for f in files]
        if options.service not in names:
            raise UsageError(f"no log of '{options.service}'"
                             f"{did_you_mean(options.service, names)}; one of {', '.join(names)}")
        files = [directory.log_of(options.service)]
    if options.follow:
        os.execv("/usr/bin/tail", ["tail", "-n", str(options.lines), "-F", *map(str, files)])
    for file in files:
        if len(files) > 1:
            print(f"==> {shown(file)} <==")
        print("\n".join(last_lines(file, options.lines)))
    return EXIT_OK
