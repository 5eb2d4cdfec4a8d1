"""Runs the benches and their peers in turns, and keeps the results of every turn."""

import json
import re
import statistics
import subprocess
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
SIZES = (10**4, 10**5, 10**6, 10**7)
LARGE = ("6250", "800")  # segments and sides of 10^7 triangles
SMALLEST = ("3", "3")
THREE_GRIDS = ("250x20", "625x80", "2500x200")


class Failed(Exception):
    """A program that failed; the message names it and quotes its output."""


class Samples:
    """The measurements: per name one list per round, of one number per repetition."""

    def __init__(self):
        self.rounds = {}
        self.counters = {}  # name -> {counter: value}, of the last repetition
        self.failures = {}  # name -> why

    def add(self, name, values):
        self.rounds.setdefault(name, []).append(list(values))

    def medians(self, name):
        """One median per round."""
        return [statistics.median(values) for values in self.rounds[name]]

    def __contains__(self, name):
        return name in self.rounds and name not in self.failures


def output_of(command, **options):
    """The output of a command."""
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        words = (done.stderr or done.stdout).strip().splitlines() or ["no output"]
        raise Failed(f"{Path(command[0]).name}: status {done.returncode}, {words[-1]}")
    return done.stdout


def peak_bytes(command, folder):
    """(peak of resident memory, what it printed) of a command."""
    with tempfile.NamedTemporaryFile("r") as output:
        text = output_of(["/usr/bin/time", "-f", "%M", "-o", output.name, *command], cwd=folder)
        return 1024 * int(output.read().split()[-1]), text


class Turns:
    """The programs of one run."""

    def __init__(self, build, peers, folder):
        self.build, self.peers, self.folder = Path(build).resolve(), Path(peers).resolve(), folder
        self.samples = Samples()
        self.context = {}

    def knots(self):
        """One process per size: how glibc allocates depends on earlier allocations."""
        for size in SIZES:
            self.benches(f"make_knot/.*triangles:{size}/")

    def benches(self, pattern):
        """Runs the benches of lumaknot_bench whose names match, in milliseconds."""
        output = Path(self.folder) / "benches.json"
        output_of([self.build / "bench/lumaknot_bench", f"--benchmark_filter={pattern}",
                   "--benchmark_enable_random_interleaving=true", "--benchmark_min_time=0.1",
                   "--benchmark_out_format=json", f"--benchmark_out={output}"], cwd=self.folder)
        report = json.loads(output.read_text(encoding="utf-8"))
        self.context.update(report["context"])
        times = {}
        for entry in report["benchmarks"]:
            self.keep(entry, times)
        for name, values in times.items():
            self.samples.add(name, values)

    def keep(self, entry, times):
        name = re.sub(r"/(iterations|repeats):\d+|/real_time", "", entry["run_name"])
        if entry.get("error_occurred"):
            self.samples.failures[name] = entry["error_message"]
        elif entry["run_type"] == "iteration":
            times.setdefault(name, []).append(entry["real_time"])
            self.samples.counters[name] = {key: value for key, value in entry.items() if key in
                                           ("bytes", "vertices", "triangles")}

    def three_js(self):
        output = json.loads(output_of(["node", HERE / "three_js.mjs", self.peers, *THREE_GRIDS]))
        self.context["three.js"] = output["revision"]
        for grid in output["grids"]:
            name = f"three.js/triangles:{grid['triangles']}"
            self.samples.add(name, [grid["median_ms"]])
            self.samples.counters[name] = {key: grid[key] for key in ("triangles", "vertices")}

    def memory(self):
        """Peaks of children beyond what they need for the smallest knot, over the flat mesh."""
        mesh = self.build / "bench/lumaknot_bench_mesh"
        smallest, _ = peak_bytes([mesh, *SMALLEST], self.folder)
        peak, output = peak_bytes([mesh, *LARGE], self.folder)
        flat = int(output)
        self.samples.add("memory/mesh", [(peak - smallest) / flat])
        for extension in ("ply", "glb", "obj"):
            name = f"memory/{extension}"
            try:
                self.samples.add(name, [self.writing_peak(extension) / flat])
            except Failed as failure:
                self.samples.failures[name] = str(failure)

    def writing_peak(self, extension):
        def peak(segments, sides):
            path = f"large.{extension}"
            command = [self.build / "lumaknot", "mesh", "--segments", segments, "--sides", sides,
                       "--quiet", "-o", path]
            return peak_bytes(command, self.folder)[0]
        return peak(*LARGE) - peak(*SMALLEST)
