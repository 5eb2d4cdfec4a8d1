"""Runs lumaknot's benches next to their peers and prints the ratios with their bars.

    report.py --build FOLDER --peers FOLDER [--rounds N] [--json FILE]

FOLDER of --build is where cmake built; of --peers, where npm installed three. Every round runs all
of ours and all of theirs, one after the other; a figure is the median over rounds, and its spread
their minimum and maximum. Exit status 0: every bar is met; 1: one is not, or was not measured.
"""

import argparse
import json
import math
import os
import statistics
import sys
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path

from rounds import SIZES, Failed, Turns


@dataclass
class Row:
    """A line of the table; `values` has one number per round."""
    what: str
    values: list
    unit: str = ""
    bar: str = ""
    met: bool = None
    beside: str = ""

    def median(self):
        return statistics.median(self.values)


def power(size):
    """Of ten: 4 for 10^4."""
    return round(math.log10(size))


def at_least(row, bar):
    row.bar, row.met = f">= {bar:g}{row.unit}", row.median() >= bar
    return row


def at_most(row, bar):
    row.bar, row.met = f"<= {bar:g}{row.unit}", row.median() <= bar
    return row


def quotient(samples, above, below):
    """One quotient per round."""
    return [a / b for a, b in zip(samples.medians(above), samples.medians(below), strict=True)]


def typical(samples, name):
    return statistics.median(samples.medians(name))


def three_rows(samples):
    for convention, family in (("", "one_thread"), (", convention three", "three_one_thread")):
        for size in SIZES[:3]:
            ours, theirs = f"make_knot/{family}/triangles:{size}", f"three.js/triangles:{size}"
            if samples.counters[ours] != samples.counters[theirs]:
                sys.exit(f"{ours} and {theirs} built different meshes: {samples.counters[ours]}, "
                         f"{samples.counters[theirs]}")
            row = Row(f"10^{power(size)} triangles on 1 thread{convention}: faster than three.js",
                      quotient(samples, theirs, ours), " x")
            row.beside = f"{typical(samples, theirs):.3g} : {typical(samples, ours):.3g} ms"
            yield at_least(row, 20)


def large_rows(samples):
    one, two = (f"make_knot/{n}_{t}/triangles:{SIZES[-1]}"
                for n, t in (("one", "thread"), ("two", "threads")))
    seconds = [ms / 1000 for ms in samples.medians(two)]
    yield at_most(Row("10^7 triangles on 2 threads", seconds, " s"), 1)
    yield Row("10^7 triangles: 2 threads faster than 1", quotient(samples, one, two), " x")


def exponent(each):
    """The slope of log time over log size, least squares, of nanoseconds per triangle."""
    logs = [math.log(size) for size in SIZES]
    return statistics.linear_regression(
        logs, [math.log(ns) + log for ns, log in zip(each, logs, strict=True)]).slope


def rms(each):
    """RMS as in Google Benchmark: of the fit t = c n, over the mean time, in per cent."""
    times = [ns * size for ns, size in zip(each, SIZES, strict=True)]
    slope = sum(map(math.prod, zip(times, SIZES))) / sum(size * size for size in SIZES)
    squares = [(t - slope * size) ** 2 for t, size in zip(times, SIZES, strict=True)]
    return 100 * math.sqrt(statistics.mean(squares)) / statistics.mean(times)


def linear_rows(samples):
    medians = [samples.medians(f"make_knot/one_thread/triangles:{size}") for size in SIZES]
    rounds = [[1e6 * ms / size for ms, size in zip(times, SIZES, strict=True)]
              for times in zip(*medians, strict=True)]
    for index, size in enumerate(SIZES):
        yield Row(f"10^{power(size)} triangles on 1 thread, each", [each[index] for each in rounds],
                  " ns")
    yield at_most(Row("dearest over cheapest of these four",
                      [max(each) / min(each) for each in rounds], " x"), 1.1)
    slope = Row("exponent of time over triangles", [exponent(each) for each in rounds],
                bar="1 +- 0.1")
    slope.met = abs(slope.median() - 1) <= 0.1
    yield slope
    yield at_most(Row("RMS of the linear fit", [rms(each) for each in rounds], " %"), 10)


def memory_rows(samples):
    for name, what in (("mesh", "making"), ("ply", "lumaknot mesh -o .ply"),
                       ("glb", "lumaknot mesh -o .glb"), ("obj", "lumaknot mesh -o .obj")):
        row = Row(f"10^7 triangles, {what}: peak memory over the flat mesh's",
                  samples.medians(f"memory/{name}") if f"memory/{name}" in samples else [], " x")
        yield at_most(row, 1.5) if row.values else lost(row, samples, f"memory/{name}", "<= 1.5 x")


def lost(row, samples, name, bar):
    """A row that could not be measured: not met, and why."""
    row.bar, row.met = bar, False
    row.beside = samples.failures.get(name, "not measured")
    return row


def speeds(samples, name):
    """Megabytes per second, one per round."""
    return [samples.counters[name]["bytes"] / ms / 1000 for ms in samples.medians(name)]


def file_rows(samples):
    disk = statistics.median(speeds(samples, "write_bytes"))
    yield Row("plain write() of a .ply's bytes", speeds(samples, "write_bytes"), " MB/s")
    for name in ("ply", "glb"):
        for threads in ("one_thread", "two_threads"):
            key = f"write_knot/{name}_{threads}"
            row = Row(f"10^6 triangles to .{name}, {threads.replace('_', ' ')}", [], " MB/s")
            if key not in samples:
                yield lost(row, samples, key, ">= 500 MB/s or 0.9 of write()")
                continue
            row.values = speeds(samples, key)
            row.beside = f"{row.median() / disk:.2f} of write()"
            row = at_least(row, min(500, 0.9 * disk))
            row.bar = ">= 500 MB/s or 0.9 of write()"
            yield row


def obj_rows(samples):
    theirs = "write_open_mesh"
    for threads in ("one_thread", "two_threads"):
        ours = f"write_knot/obj_{threads}"
        row = Row(f"10^6 triangles to .obj, {threads.replace('_', ' ')}: faster than OpenMesh", [],
                  " x")
        if ours not in samples or theirs not in samples:
            yield lost(row, samples, ours, ">= 10 x")
            continue
        row.values = quotient(samples, theirs, ours)
        sizes = [samples.counters[name]["bytes"] / 1e6 for name in (theirs, ours)]
        row.beside = (f"{typical(samples, theirs):.0f} : {typical(samples, ours):.0f} ms, "
                      f"{sizes[0]:.0f} : {sizes[1]:.0f} MB")
        yield at_least(row, 10)


def other_rows(samples):
    """Figures without a bar."""
    for name in sorted(samples.rounds):
        if name.startswith("read_knot/"):
            yield Row(name.replace("_", " "), speeds(samples, name), " MB/s")
        elif name.split("/")[0] in ("measure_deviation", "choose_grid", "find_clearance"):
            yield Row(name.replace("_", " "), samples.medians(name), " ms")


def rows_of(samples):
    for rows in (three_rows, large_rows, linear_rows, memory_rows, file_rows, obj_rows, other_rows):
        yield from rows(samples)
    reported = ("memory/", "write_knot/")  # by their own rows
    for name, why in samples.failures.items():
        if not name.startswith(reported):
            yield Row(name, [], met=False, beside=why)


def number(value):
    return f"{value:.0f}" if value >= 1000 else f"{value:.3g}"


def line(row):
    values = number(row.median()) + row.unit if row.values else "-"
    spread = f"{number(min(row.values))} ... {number(max(row.values))}" if row.values else "-"
    verdict = {None: "", True: "met", False: "MISSED"}[row.met]
    return f"| {row.what} | {values} | {spread} | {row.bar} | {verdict} | {row.beside} |"


def table(rows):
    head = ["| what | median | rounds | bar | | |", "|---|---|---|---|---|---|"]
    return "\n".join(head + [line(row) for row in rows])


def measure(arguments):
    with tempfile.TemporaryDirectory(dir=Path(arguments.build).resolve()) as folder:
        turns = Turns(arguments.build, arguments.peers, folder)
        for number in range(arguments.rounds):
            print(f"round {number + 1} of {arguments.rounds}", file=sys.stderr)
            turns.knots()
            turns.three_js()
            turns.memory()
            turns.benches("write_|read_")
            turns.benches("measure_|choose_|find_")
        return turns


def flags():
    parser = argparse.ArgumentParser()
    parser.add_argument("--build", required=True)
    parser.add_argument("--peers", required=True)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--json", type=Path)
    return parser.parse_args()


def main():
    arguments = flags()
    try:
        turns = measure(arguments)
    except Failed as failure:
        sys.exit(str(failure))
    rows = list(rows_of(turns.samples))
    print(table(rows))
    load = os.getloadavg()[0]
    print(f"\n{turns.context['num_cpus']} cores, load {load:.1f}, three.js r"
          f"{turns.context['three.js']}, {arguments.rounds} rounds")
    if arguments.json:
        result = {"context": turns.context, "rows": [asdict(row) for row in rows],
                  "rounds": turns.samples.rounds, "counters": turns.samples.counters}
        arguments.json.write_text(json.dumps(result, indent=2) + "\n", encoding="utf-8")
    return 0 if all(row.met is not False for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())
