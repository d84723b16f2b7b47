#!/usr/bin/python3
"""How many samples a second the recorder takes on one core, against ddsperf's subscriber there."""

import argparse
import csv
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import uuid
from pathlib import Path
from typing import List, NamedTuple, Optional

ROOT = Path(__file__).resolve().parents[3]
AIM_PER_S = 200_000  # samples of 200 bytes, on one core
TOPIC = "DDSPerfRDataKS"  # ddsperf's samples: a number that counts up, a key, octets
START_LIMIT_S = 20
TRIES = 6  # at falling rates, until nothing is lost
SUBSCRIBER_TOTAL = 4  # words of `size 200 total 1234 lost 0 delta ...` before and at the count

_HELP = """ddsperf's publisher floods from a core of its own (reliable, keep-all, batched), as fast as the
reader acknowledges or at --rate. Reader on the other core: once the recorder with its
shipped configuration, all of its threads on that one core, once ddsperf's own subscriber, which only
counts. Where the recorder has lost a sample the rate is lowered until it has not. Processor time is
that of the reader's whole process, from its start to its end.

The recorder's figure is one of samples in the closed log: their numbers are read back from it.
ddsperf's octets are all the same, so that the compressor has little to do; see --config.

examples:
  tests/benchmark/logger/recorder_speed.py --bin build/release/bin
  tests/benchmark/logger/recorder_speed.py --size 504 --rate 2000       # the chain's samples
  tests/benchmark/logger/recorder_speed.py --size 65536 --rate 500      # small images
"""

_CYCLONE = """<CycloneDDS xmlns="https://cdds.io/config"><Domain Id="any">
<General><Interfaces><NetworkInterface name="lo" multicast="true"/></Interfaces>
<AllowMulticast>spdp</AllowMulticast></General>
<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>63</MaxAutoParticipantIndex>
<ExternalDomainId>0</ExternalDomainId><Tag>{tag}</Tag></Discovery></Domain></CycloneDDS>"""


class Flood(NamedTuple):
    size: int             # bytes of a sample
    rate: Optional[int]   # samples a second; None: as many as the reader takes
    seconds: int


class Reading(NamedTuple):
    samples: int
    lost: int
    seconds: float        # from the first sample to the last
    processor_s: float    # of the reader's process
    bytes_written: int

    def rate(self) -> float:
        return self.samples / self.seconds

    def core_share(self) -> float:
        return self.processor_s / self.seconds

    def us_each(self) -> float:
        return 1e6 * self.processor_s / self.samples


def pinned(core: int, command: List[str]) -> List[str]:
    return ["taskset", "--cpu-list", str(core), *command]


def environment(tag: str) -> dict:
    """ddsperf's: the recorder's way of joining the bus."""
    return {**os.environ, "CYCLONEDDS_URI": _CYCLONE.format(tag=tag)}


def publish(flood: Flood, core: int, tag: str) -> None:
    """Floods; ends by itself. What it sends before the reader is there is nobody's loss."""
    words = ["pub"]
    if flood.rate is not None:
        burst = max(1, flood.rate // 2000)
        words += [f"{max(1, flood.rate // burst)}Hz", "burst", str(burst)]
    command = ["ddsperf", "-D", str(flood.seconds), *words, "size", str(flood.size)]
    done = subprocess.run(pinned(core, command), env=environment(tag), stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False,
                          timeout=flood.seconds + 2 * START_LIMIT_S)
    # 1: more has come or gone than it was told to expect.
    if done.returncode not in (0, 1):
        raise RuntimeError(f"ddsperf pub ended with {done.returncode}: {done.stdout}")


def ended(process: subprocess.Popen, limit_s: float) -> float:
    """Waits for the end; the process's time on a processor, s."""
    deadline = time.monotonic() + limit_s
    while time.monotonic() < deadline:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        if pid == process.pid:
            process.returncode = os.waitstatus_to_exitcode(status)
            return usage.ru_utime + usage.ru_stime
        time.sleep(0.01)
    process.kill()
    process.wait()
    raise RuntimeError(f"{process.args[3]} did not end within {limit_s} s")


def subscribe(flood: Flood, cores: List[int]) -> Reading:
    """ddsperf's own subscriber takes the flood."""
    tag = f"recorder-speed-{uuid.uuid4()}"
    command = ["ddsperf", "-1", "-D", str(flood.seconds + START_LIMIT_S), "sub"]
    reader = subprocess.Popen(pinned(cores[1], command), env=environment(tag),
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    try:
        publish(flood, cores[0], tag)
        reader.send_signal(signal.SIGINT)
        output = reader.stdout.read()
        processor_s = ended(reader, START_LIMIT_S)
    finally:
        if reader.returncode is None:
            reader.kill()
            reader.wait()
    return subscriber_reading(output, processor_s)


def subscriber_reading(output: str, processor_s: float) -> Reading:
    """Of lines as `[1] 2.000  size 200 total 123 lost 0 delta 60 lost 0 rate 60.00 kS/s ...`; the
    seconds are those in which something came."""
    samples, lost, seconds, before = 0, 0, 0.0, 0.0
    for line in output.splitlines():
        words = line.split()
        if "total" not in words or "delta" not in words:
            continue
        now = float(words[1])
        total = int(words[words.index("total") + 1])
        lost = int(words[words.index("lost") + 1])
        if total > samples:
            seconds += now - before
        samples, before = total, now
    if samples == 0:
        raise RuntimeError(f"ddsperf sub has counted nothing: {output}")
    return Reading(samples, lost, seconds, processor_s, 0)


def record(flood: Flood, cores: List[int], options: argparse.Namespace) -> Reading:
    """The recorder takes the flood."""
    tag = f"recorder-speed-{uuid.uuid4()}"
    with tempfile.TemporaryDirectory(prefix="scarab-recorder-speed-", dir=options.folder) as folder:
        log = Path(folder) / "flood.mcap"
        command = [str(options.bin / "scarab-logger"), "--tag", tag, "--output", str(log),
                   "--log-level", "warning"]
        if options.config:
            command += ["--config", str(options.config)]
        reader = subprocess.Popen(pinned(cores[1], command))
        try:
            await_file(Path(f"{log}.active"), reader)
            publish(flood, cores[0], tag)
            reader.send_signal(signal.SIGINT)
            processor_s = ended(reader, START_LIMIT_S)
        finally:
            if reader.returncode is None:
                reader.kill()
                reader.wait()
        if reader.returncode != 0:
            raise RuntimeError(f"scarab-logger ended with {reader.returncode}")
        return log_reading(log, processor_s, options.bin)


def await_file(path: Path, process: subprocess.Popen) -> None:
    deadline = time.monotonic() + START_LIMIT_S
    while not path.exists():
        if process.poll() is not None or time.monotonic() > deadline:
            raise RuntimeError(f"scarab-logger has not begun {path}")
        time.sleep(0.01)


def log_reading(log: Path, processor_s: float, programs: Path) -> Reading:
    """What is in the closed log: every number from the first to the last, or so many lost."""
    command = [str(programs / "scarab-log"), "export", str(log), "--topic", TOPIC, "--format", "csv",
               "--field", "seq", "--times"]
    samples, first, last = 0, None, None
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as table:
        rows = csv.reader(table.stdout)
        columns = next(rows, [])
        if columns:
            time_at, number_at = columns.index("publish_time_ns"), columns.index("seq")
        for row in rows:
            last = row
            first = first or row
            samples += 1
    if table.returncode != 0 or samples < 2:
        raise RuntimeError(f"{log} holds {samples} samples of {TOPIC}")
    sent = int(last[number_at]) - int(first[number_at]) + 1
    seconds = (int(last[time_at]) - int(first[time_at])) * 1e-9
    return Reading(samples, sent - samples, seconds, processor_s, log.stat().st_size)


def sustained(flood: Flood, options: argparse.Namespace) -> Reading:
    """The recorder's highest rate without loss, from the flood's downwards."""
    for _ in range(TRIES):
        reading = record(flood, options.cores, options)
        if reading.lost == 0:
            return reading
        print(f"recorder: {reading.lost} of {reading.samples + reading.lost} lost at "
              f"{reading.rate():.0f}/s; slower", file=sys.stderr)
        flood = flood._replace(rate=int(0.8 * reading.rate()))
    raise RuntimeError("the recorder loses samples at every rate tried")


def row(name: str, reading: Reading) -> str:
    written = f", {reading.bytes_written / 1e6:.1f} MB written" if reading.bytes_written else ""
    return (f"{name:<16} {reading.rate():9.0f} samples/s, {reading.lost} lost; "
            f"{100 * reading.core_share():5.1f} % of a core, {reading.us_each():6.2f} us each{written}")


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, epilog=_HELP,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=Path, default=ROOT / "build/release/bin",
                        help="compiled programs (build/release/bin)")
    parser.add_argument("--size", type=int, default=200, help="bytes of a sample (200)")
    parser.add_argument("--rate", type=int, help="samples a second (as many as the reader takes)")
    parser.add_argument("--seconds", type=int, default=5, help="length of each flood (5)")
    cores = sorted(os.sched_getaffinity(0))
    parser.add_argument("--cores", type=int, nargs=2, default=[cores[0], cores[-1]],
                        metavar=("PUB", "READ"),
                        help=f"of the publisher and of the reader ({cores[0]} {cores[-1]})")
    parser.add_argument("--config", type=Path, help="the recorder's, in place of its defaults")
    parser.add_argument("--folder", type=Path, help="where the log is written (the system's for such)")
    options = parser.parse_args()
    if options.size < 12 or options.seconds < 1 or (options.rate is not None and options.rate < 1):
        parser.error("at least 12 bytes, 1 second, 1 sample a second")
    for program in ("scarab-logger", "scarab-log"):
        if not (options.bin / program).is_file():
            parser.error(f"no {program} in {options.bin} (--bin)")
    for program in ("ddsperf", "taskset"):
        if shutil.which(program) is None:
            parser.error(f"{program} is not installed")
    return options


def main() -> int:
    options = parse()
    flood = Flood(options.size, options.rate, options.seconds)
    try:
        ours = sustained(flood, options)
        theirs = subscribe(flood, options.cores)
    except (RuntimeError, OSError, ValueError, subprocess.TimeoutExpired) as error:
        print(f"recorder_speed: {error}", file=sys.stderr)
        return 1
    aim = f"   aim {AIM_PER_S}" if options.size == 200 and options.rate is None else ""
    print(f"{options.size} bytes, {options.seconds} s, reader on core {options.cores[1]}")
    print(row("scarab-logger", ours) + aim)
    print(row("ddsperf sub", theirs))
    print(f"rate, recorder / ddsperf sub              {ours.rate() / theirs.rate():.2f}")
    print(f"processor time each, recorder / ddsperf   {ours.us_each() / theirs.us_each():.2f}")
    if options.rate is None:
        print(f"a whole core has time for                 {1e6 / ours.us_each():.0f} samples/s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
