"""Writers and readers of one topic that do not meet, and the QoS policy because of which."""

from typing import Dict, List

from .finding import Finding, note, ok, problem
from .subject import Subject
from .survey import who

_STRONGER = "Let the writer offer {asked}, or the reader ask for {offered} only."
_SAME = "Give both the same {policy}: {offered}, or {asked}."
_ADVICE: Dict[str, str] = {
    "reliability": _STRONGER,
    "durability": _STRONGER,
    "deadline": "Let the writer promise a deadline of {asked} or less, or the reader ask for "
                "{offered} or more.",
    "latency budget": _STRONGER,
    "liveliness": _STRONGER,
    "destination order": _STRONGER,
    "presentation": _STRONGER,
    "ownership": _SAME,
    "partition": _SAME,
    "data representation": "Let the reader accept {offered}, or the writer write {asked}.",
    "type name": "Give both the same type; that of the stack's topics is in idl/README.md.",
    "type": "One of the two was built from other IDL files: build both from the same ones.",
}


def endpoints(subject: Subject) -> List[Finding]:
    found = []
    for bus in subject.buses:
        seen = subject.seen(bus)
        if seen.fault:
            found.append(problem(f"DDS domain {bus.domain} cannot be looked at: {seen.fault}",
                                 "See the other findings."))
        found += [_mismatch(m) for m in seen.mismatches]
    if not found and not any(subject.seen(bus).participants for bus in subject.buses):
        return [ok("nobody is there to be looked at")]
    return found or [ok("all writers and readers of a topic fit together")]


def _mismatch(mismatch: dict) -> Finding:
    policy = mismatch["policy"]
    what = (f"{mismatch['topic']}: {who(mismatch['writer'])} writes and "
            f"{who(mismatch['reader'])} reads it, but their {policy} differs: offered is "
            f"{mismatch['offered']}, asked for is {mismatch['asked']}")
    return problem(what, _ADVICE.get(policy, _SAME).format(**mismatch))

