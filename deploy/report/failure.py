"""What keeps a report, a figure or a finding from being made."""


class ReportError(Exception):
    """One line for a person: what is wrong with which file."""
