"""Variables of the caller that the stack does not heed, but other DDS programs do."""

import os
from typing import List

from .finding import Finding, ok, problem
from .subject import Subject


def environment(_: Subject) -> List[Finding]:
    uri = os.environ.get("CYCLONEDDS_URI")
    if uri:
        return [problem(f"CYCLONEDDS_URI is set ({uri[:60]}): the stack ignores it, your own DDS "
                        "programs do not, so that the two may not meet",
                        "Unset it, or see deploy/cyclonedds for what matches the stack.")]
    return [ok("nothing in it changes DDS")]
