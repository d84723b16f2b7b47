#!/usr/bin/python3
"""Stands in for every compiled program of the stack in the launcher's tests.

It is installed into a folder of the test, behind a script with each program's name (fake_program.sh), which answers
the quick questions itself. What it does is told by files in `<folder>/orders/`, and it writes what it lived through
to `<folder>/journal`.
"""

import json
import os
import signal
import sys
import time
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
NAME = Path(sys.argv[0]).stem


def journal(word):
    with open(FOLDER / "journal", "a") as file:
        file.write(f"{word} {NAME} {os.getpid()}\n")


def order(word):
    """The text of an order for this program, or None."""
    file = FOLDER / "orders" / f"{NAME}.{word}"
    return file.read_text() if file.exists() else None


def value_of(option, default=""):
    return sys.argv[sys.argv.index(option) + 1] if option in sys.argv else default


def wait_until(condition, timeout_s):
    deadline = time.monotonic() + timeout_s
    while not condition():
        if time.monotonic() > deadline:
            return False
        time.sleep(0.01)
    return True


def up_file(service):
    return FOLDER / f"up.{value_of('--domain', '0')}.{service}"


def program_of(service):
    return "scarab-" + service.replace("_", "-")


def free_name(folder):
    """As the logger: a file that an earlier one left is not touched."""
    names = ["trial.mcap", "trial-2.mcap", "trial-3.mcap"]
    taken = [name for name in names if list(folder.glob(f"{name}*"))]
    return folder / names[len(taken)]


def serve():
    stopped = []
    for number in (signal.SIGTERM, signal.SIGINT):
        signal.signal(number, lambda *_: stopped.append(1))
    journal("start")
    (FOLDER / f"{NAME}.environment").write_text("\n".join(sorted(os.environ)))
    (FOLDER / f"{NAME}.command").write_text("\n".join(sys.argv[1:]))
    print("a line of", NAME, file=sys.stderr, flush=True)
    if order("die-at-start"):
        print("cannot open the device", file=sys.stderr)
        return 1
    output = free_name(Path(value_of("--run-dir"))) if NAME == "scarab-logger" else None
    active = output.with_name(output.name + ".active") if output else None
    if active:
        active.write_text("log\n")
        for number in range(2, int(order("files") or 1) + 1):
            output.with_name(f"{output.stem}-{number}.mcap").write_text("log\n")
    if NAME == "scarab-emulator":
        link = Path(value_of("--device"))
        link.unlink(missing_ok=True)
        link.symlink_to("/dev/null")
        journal("device")
    if NAME == "scarab-robot-bridge" and order("open"):
        os.open(value_of("--device"), os.O_RDWR | os.O_NOCTTY)
    up_file(NAME).write_text(str(os.getpid()))
    while not (stopped and not order("ignore-term")):
        if order("crash"):
            (FOLDER / "orders" / f"{NAME}.crash").unlink()
            journal("crash")
            os.kill(os.getpid(), signal.SIGKILL)
        time.sleep(0.01)
    up_file(NAME).unlink(missing_ok=True)
    if active:
        os.replace(active, output)
    journal("stop")
    return 0


def status():
    if order("progress") and "--progress" in sys.argv:
        print(f"scarab-status: waiting: {order('progress')}", file=sys.stderr, flush=True)
    while order("hold"):
        time.sleep(0.01)
    services = [part.split("=")[0] for part in value_of("--wait").split(",") if part]
    all_up = wait_until(lambda: all(up_file(program_of(s)).exists() for s in services),
                        float(value_of("--timeout", "1")))
    if all_up and order("never-ready") is None:
        if order("document") and "--json" in sys.argv:
            print(order("document"))
        return 0
    print("a table")
    missing = [s for s in services if not up_file(program_of(s)).exists()] or ["premotor"]
    print(f"scarab-status: {', '.join(missing)} is missing", file=sys.stderr)
    return 1


def experiment():
    stopped = []
    signal.signal(signal.SIGTERM, lambda *_: stopped.append(1))
    journal("start")
    print("progress", flush=True)
    (FOLDER / "trial-runs").write_text("")
    fault = Path(value_of("--fault-file"))
    while order("hold") and not stopped and not fault.exists():
        time.sleep(0.01)
    (FOLDER / "trial-runs").unlink(missing_ok=True)
    (FOLDER / "scarab-experiment.command").write_text("\n".join(sys.argv[1:]))
    if fault.exists():
        print("result: failure:", fault.read_text(), flush=True)
        return 1
    if stopped:
        journal("stop")
        return 130
    Path(value_of("--results")).write_text("trial,success\n1,1\n")
    print("result: success", flush=True)
    return int(order("exit-code") or 0)


def withdraw_one(word):
    """Takes one of an order's times away; False where it has none (left)."""
    file = FOLDER / "orders" / f"{NAME}.{word}"
    times = int(order(word) or 0)
    if times > 0:
        file.write_text(str(times - 1))
    return times > 0


def result_of(trial):
    """A deterministic one: trials across 10 cm and more fail."""
    success = trial["height_m"] < 0.1
    return json.dumps({**trial, "success": success, "time_s": 12.5 + trial["seed"] % 7 if success else 60,
                       "reason": "across, at last" if success else "time is up",
                       "object_travel_m": 0.1 + trial["index"] / 3, "object_sideways_m": 1e-17,
                       "trunk_travel_m": 1.5, "heading_rad": -0.25, "heading_max_rad": 0.5, "climb_s": 2,
                       "mode1_s": 2.5, "mode2_s": None})


def worker():
    """As scarab-sim and scarab-experiment with --worker."""
    journal("start")
    (FOLDER / f"{NAME}.command").write_text("\n".join(sys.argv[1:]))
    if order("refuse-trials"):
        print(json.dumps({"error": order("refuse-trials")}), flush=True)
        return 2
    for line in sys.stdin:
        trial = json.loads(line)
        while order("hold"):
            time.sleep(0.01)
        if withdraw_one("die"):
            os.kill(os.getpid(), signal.SIGKILL)
        if withdraw_one("error"):
            print(json.dumps({"index": trial["index"], "error": "plant is silent"}), flush=True)
            return 1
        if withdraw_one("nonsense"):
            print("a line of the debugger", flush=True)
        time.sleep(float(order("slow") or 0))
        with open(FOLDER / "trials", "a") as file:
            print(trial["index"], file=file)
        print(result_of(trial), flush=True)
    if value_of("--output"):
        Path(value_of("--output")).write_text("log\n")
    journal("stop")
    return 0


def log():
    """Mends a log, and has nothing to export."""
    if sys.argv[1:2] == ["recover"]:
        Path(sys.argv[3]).write_text("mended\n")
        return 0
    print("header.sim_time_ns")
    return 1


def tool():
    """Ends as it is told to; one told to hold ends as all tools do when they are interrupted."""
    (FOLDER / f"{NAME}.command").write_text("\n".join(sys.argv[1:]))
    with open(FOLDER / f"{NAME}.domains", "a") as file:
        print(value_of("--domain"), file=file)
    stopped = []
    signal.signal(signal.SIGINT, lambda *_: stopped.append(1))
    if order("hold"):
        journal("start")
        wait_until(lambda: stopped, 60)
    return 130 if stopped else int(order("exit-code") or 0)


def main():
    if "--worker" in sys.argv:
        return worker()
    if NAME == "scarab-status":
        return status()
    if NAME == "scarab-experiment":
        return experiment()
    if NAME in ("scarab-operator", "scarab-sim", "scarab-topic", "scarab-drive"):
        return tool()
    if NAME == "scarab-log":
        return log()
    return serve()


sys.exit(main())
