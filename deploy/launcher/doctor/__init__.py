"""`scarab doctor`: looks for what keeps a stack from running. One file a family of findings.

Each family has one or more functions `(Subject) -> List[Finding]`; `verb.py` lists them.
"""
