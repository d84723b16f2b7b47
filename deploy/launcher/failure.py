"""How the launcher ends when something is wrong: one class for each exit code."""

from pathlib import Path

EXIT_OK = 0
EXIT_FAILURE = 1
EXIT_USAGE = 2
EXIT_INTERRUPTED = 130


class Failure(Exception):
    """Something went wrong at run time; the text says what, and what to do about it."""

    exit_code = EXIT_FAILURE


class UsageError(Failure):
    """Bad usage or bad configuration: nothing was started."""

    exit_code = EXIT_USAGE


class ConfigError(UsageError):
    """Bad input in a file; the text is `file:line:col: key: reason`."""

    def __init__(self, file: Path, line: int, column: int, key: str, reason: str):
        super().__init__(f"{file}:{line}:{column}: {key}: {reason}")


class Interrupted(Failure):
    """A person (Ctrl-C) or the system (SIGTERM, SIGHUP) asked the launcher to stop."""

    exit_code = EXIT_INTERRUPTED

    def __init__(self, text: str = "interrupted") -> None:
        super().__init__(text)
