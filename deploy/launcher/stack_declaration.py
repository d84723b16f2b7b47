"""What stack.yaml may hold. Editors that know its schema (`scarab config schema stack`) show the notes."""

import json

from .declaration import (Boolean, Choice, Fields, Integer, ListOf, Named, Number, Text, described)
from .stack import Pace, Restart
from .stack_changes import MOST_INSTANCES

_PATH = "from the root of the source tree; {robot} and {driver} stand for the names of those"
_MEMBERS = ListOf(Text(), least=1, note="in the order of `services`")

STACK = Fields(
    required={
        "bus": Fields({
            "interface": Text("network interface of the DDS traffic"),
            "tag": Text("discovery tag of Cyclone DDS: only programs with the same one meet",
                        empty=True),
        }, {
            "peers": ListOf(Text(), "addresses of the other hosts, for a network without multicast"),
        }),
        "log_level": Choice(("trace", "debug", "info", "warning", "error"), "of every service"),
        "timing": Fields({
            "ready_s": Number(0.1, 600.0, "longest wait until the services of this host are ready"),
        }),
        "restart": Fields({
            "first_s": Number(0.0, 60.0, "wait before the first restart of a service that crashed"),
            "longest_s": Number(0.0, 600.0, "the wait doubles at each crash, up to this"),
            "forget_s": Number(0.0, 86400.0, "who has run this long starts over with first_s"),
        }),
        "services": Named(
            note="in start order; they are stopped in the reverse order",
            name=r"^[a-z][a-z0-9_]*$",
            item=Fields({
                "binary": Text("name of a program in build/*/bin", pattern="^[^/]*$",
                               otherwise="a path; expected the name of a program in build/*/bin"),
                "instances": Integer(1, MOST_INSTANCES, "how many processes"),
                "restart": Choice(tuple(r.value for r in Restart), "after a crash"),
                "stop_s": Number(0.1, 600.0, "how long it may take to stop"),
            }, {
                "tick_master": Boolean("it has the one clock of the stack, and is told its pace"),
                "paces": ListOf(Choice(tuple(p.value for p in Pace)), least=1,
                                note="of a tick master: those that it can go at (both)"),
                "device": Boolean("of a tick master: it drives a device, which --device can name"),
                "hardware": Boolean("no service: it stands in for the device of the tick master, and is given "
                                    "that one's files"),
                "robot": Text(f"robot file, {_PATH}"),
                "config": Text(f"configuration file, {_PATH}"),
                "plant": Text(f"of hardware: the plant's file, for the robot behind it; {_PATH}"),
            })),
        "profiles": Named(Fields({
            "services": _MEMBERS,
        }, {
            "elsewhere": _MEMBERS,
            "emulated": ListOf(Text(), least=1, note="started, too, with --emulated: hardware alone"),
        }), "`services` are started on this host; those `elsewhere` belong to the stack, too"),
    },
    optional={
        "robot": Text("name of a file in config/robot; --robot says another one"),
        "driver": Text("config/robot_bridge has a <robot>-<driver>.yaml of it; --driver says another one"),
    })


def stack_schema() -> str:
    """The JSON Schema of stack.yaml."""
    return json.dumps({
        "$schema": "http://json-schema.org/draft-07/schema#",
        "$comment": "Written by scarab config schema stack; do not edit.",
        "title": "Scarab: deploy/stack.yaml",
        **described(STACK)}, indent=2) + "\n"
