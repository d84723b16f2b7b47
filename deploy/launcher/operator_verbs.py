"""`scarab start`, `pause`, `step`, `stop`, `estop`, `reset`, `drive`: to the robot, while a trial runs."""

import argparse
from typing import Callable, List, NoReturn

from .failure import EXIT_FAILURE, EXIT_OK, Failure
from .places import Places
from .running_stack import RunningStack, choose_stack, running_stacks
from .spawn import spawn
from .stack_options import bounded_integer
from .strategies import strategies_of_running
from .tool_verbs import become, bus_of
from .verbs import Verbs

_STOP_MORE = """The trial's verdict is a failure, by the operator; the stack stays up for the next one. To stop the
stack itself: `deploy/scarab down`. To hold the robot at once: `deploy/scarab estop`."""
_ESTOP_MORE = """The robot holds its position, whatever is commanded. It stays so until
`deploy/scarab reset`. Without --domain it goes to every stack that is up on this machine."""
_RESET_MORE = """Each joint first moves slowly to the start pose (homing); then the trial goes on."""


def add_verbs(verbs: Verbs) -> None:
    _add(verbs, "start", "go on after a pause")
    _add(verbs, "pause", "hold the trial; `start` goes on, `step` does one tick")
    parser = _add(verbs, "step", "do one tick, or N, then pause again", operands=" [N]")
    parser.add_argument("count", nargs="?", metavar="N", type=bounded_integer(1, 1000),
                        help="how many ticks (1)")
    _add(verbs, "stop", "end the trial, as failed; the stack stays up (`down` stops that)", _STOP_MORE)
    parser = verbs.add("estop", emergency_stop, "emergency stop: safe stop at once, until `reset`",
                       "deploy/scarab estop --reason 'a hand is in the way'", _ESTOP_MORE)
    _add_reason(parser)
    _add(verbs, "reset", "leave the safe stop, through homing", _RESET_MORE)
    verbs.add_tool("drive", "scarab-drive", "drive the robot by hand, in this terminal",
                   _bus_and_strategies)
    verbs.add_tool("operator", "scarab-operator", "all that an operator can say, to any domain",
                   bus_of)


def emergency_stop(options: argparse.Namespace, places: Places) -> int:
    """To all stacks that could be meant: nobody should have to think first."""
    stacks = [s for s in running_stacks(places.runs) if options.domain in (None, s.bus.domain)]
    if not stacks:
        raise Failure(_no_stack(options))
    told = [spawn(_command("estop", stack, options, places)) for stack in stacks]  # all at once
    return EXIT_OK if all([process.wait() == 0 for process in told]) else EXIT_FAILURE


def _bus_and_strategies(stack: RunningStack) -> List[str]:
    known = strategies_of_running(stack)
    return [*bus_of(stack), *(["--strategies", ",".join(known)] if known else [])]


def _add(verbs: Verbs, name: str, text: str, more: str = "",
         operands: str = "") -> argparse.ArgumentParser:
    parser = verbs.add(name, _teller(name), text, f"deploy/scarab {name}", more, operands)
    _add_reason(parser)
    return parser


def _add_reason(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--reason", metavar="TEXT", help="why; it is written to the log")


def _teller(name: str) -> Callable[[argparse.Namespace, Places], int]:
    def tell(options: argparse.Namespace, places: Places) -> NoReturn:
        become(_command(name, _stack(options, places), options, places))

    return tell


def _command(name: str, stack: RunningStack, options: argparse.Namespace,
             places: Places) -> List[str]:
    count = [str(options.count)] if getattr(options, "count", None) else []
    reason = ["--reason", options.reason] if options.reason else []
    return [str(places.program("scarab-operator")), *stack.bus.arguments(), name, *count, *reason]


def _stack(options: argparse.Namespace, places: Places) -> RunningStack:
    stack = choose_stack(places.runs, options.domain)
    if stack is None:
        raise Failure(_no_stack(options))
    return stack


def _no_stack(options: argparse.Namespace) -> str:
    where = "" if options.domain is None else f" on DDS domain {options.domain}"
    return (f"no stack of this source tree is running{where}: start one with deploy/scarab up "
            "(deploy/scarab operator COMMAND --domain N speaks to any)")
