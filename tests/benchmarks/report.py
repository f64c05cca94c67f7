#!/usr/bin/env python3
"""report.py BUILD [--quick]: runs the benchmarks of a build folder and writes docs/performance.md with its picture.

--quick runs each program for a moment and writes into BUILD instead: to try the script.
"""
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FLAGS = ["-std=c++17", "-O2", "-DNDEBUG"]
INCLUDES = {
    "`#include <Eigen/Dense>`": "#include <Eigen/Dense>\n",
    "`#include <rme/rme.hpp>`": "#include <rme/rme.hpp>\n",
}
PROGRAMS = {
    "one `Estimator<double, 7>`": """#include <rme/estimator.hpp>
static rme::Estimator<double, 7> estimator(0.001);
bool tick(const rme::Proprioception<double, 7>& in, rme::JointVector<double, 7>& torque) {
  const bool ok = estimator.update(in) == rme::Status::Ok;
  torque = estimator.compensation(in.jacobian, in.rotation);
  return ok;
}
""",
    "one `Cpic<double, 7>`": """#include <rme/control/cpic.hpp>
static rme::Cpic<double, 7> cpic(rme::CpicConfig<double, 7>{});
bool tick(const rme::CpicInput<double, 7>& in, const rme::Cpic<double, 7>::Rows& rows, rme::JointVector<double, 7>& torque) {
  const bool ok = cpic.update(in, rows) == rme::Status::Ok;
  torque = cpic.torque();
  return ok;
}
""",
}


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


def priority():
    """The command that gives a program the priority of a control loop, where that is allowed."""
    command = ["chrt", "--fifo", "50"]
    try:
        return command if subprocess.run([*command, "true"], capture_output=True).returncode == 0 else []
    except FileNotFoundError:
        return []


class Benchmarks:
    """The programs of a build folder: their tables as text, and their rows by name (median, 99 %, 99.9 % [us])."""

    def __init__(self, build, quick):
        self.folder = build / "tests" / "benchmarks"
        self.prefix = priority()
        self.quick = ["--quick"] if quick else []
        self.text = {}
        self.rows = {}

    def run(self, name, *arguments):
        if not (self.folder / name).exists():
            print(f"left out: {name} was not built", file=sys.stderr)
            return
        print(f"running {name}", file=sys.stderr, flush=True)
        text = output_of(*self.prefix, self.folder / name, *arguments, *self.quick)
        self.text[name] = text
        self.rows[name] = {}
        for line in text.splitlines():
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if len(cells) == 5 and re.fullmatch(r"[-\d.]+", cells[1]):
                self.rows[name][cells[0]] = tuple(map(float, cells[1:4]))

    def median(self, program, row):
        return self.rows[program][row][0] if row in self.rows.get(program, {}) else None

    def series(self, program, pattern):
        """Medians by the number in the name of the row."""
        found = ((re.fullmatch(pattern, name), times[0]) for name, times in self.rows.get(program, {}).items())
        return [(int(match[1]), median) for match, median in found if match]


def compiler(build):
    cache = (build / "CMakeCache.txt").read_text()
    return re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, re.MULTILINE)[1]


def eigen_folder(build):
    cache = (build / "CMakeCache.txt").read_text()
    return Path(re.search(r"^Eigen3_DIR:\w+=(.*)$", cache, re.MULTILINE)[1])


def compile_command(build, source, out):
    targets = (eigen_folder(build) / "Eigen3Targets.cmake").read_text()
    prefix = eigen_folder(build).parents[2]
    include = re.search(r'INTERFACE_INCLUDE_DIRECTORIES "\$\{_IMPORT_PREFIX\}/([^"]*)"', targets)[1]
    return [compiler(build), *FLAGS, f"-I{ROOT / 'include'}", f"-isystem{prefix / include}", "-c", source, "-o", out]


def compile_times(build, runs):
    """Median seconds of translation units with one thing in them; in turns, so that each meets the same machine."""
    units = {**INCLUDES, **PROGRAMS}
    times = {name: [] for name in units}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(runs):
            for name, text in units.items():
                source = Path(folder) / "unit.cpp"
                source.write_text(text)
                start = time.perf_counter()
                subprocess.run(compile_command(build, source, Path(folder) / "unit.o"), check=True)
                times[name].append(time.perf_counter() - start)
    return {name: statistics.median(values) for name, values in times.items()}


def code_sizes(build):
    """Bytes of machine code and constants of an object file with one thing in it."""
    sizes = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, text in PROGRAMS.items():
            source = Path(folder) / "unit.cpp"
            source.write_text(text)
            subprocess.run(compile_command(build, source, Path(folder) / "unit.o"), check=True)
            sizes[name] = int(output_of("size", Path(folder) / "unit.o").splitlines()[1].split()[0])
    return sizes


def machine(build):
    cpu = re.search(r"^Model name:\s*(.*)$", output_of("lscpu"), re.MULTILINE)
    version = output_of(compiler(build), "--version").splitlines()[0]
    changed = subprocess.run(["git", "-C", ROOT, "diff", "--quiet", "HEAD", "--", "include", "tests/benchmarks"])
    commit = output_of("git", "-C", ROOT, "rev-parse", "--short", "HEAD")
    return (f"{os.cpu_count()} cores of \"{cpu[1] if cpu else 'unknown'}\"; {version}; commit {commit}"
            f"{' with changes' if changed.returncode else ''}")


def draw(benchmarks, path):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 3, figsize=(10, 3.2), constrained_layout=True)
    panels = [
        ("bench_scaling", r"tick, mean over a block: (\d+) joints", "joints", "estimator, mean tick [µs]"),
        ("bench_scaling", r"dearest tick of a block: (\d+) joints", "joints", "estimator, dearest tick [µs]"),
        ("bench_cpic", r"(\d+) rows", "constraint rows", "CPIC [µs]"),
    ]
    for axis, (program, pattern, label, unit) in zip(axes, panels):
        points = benchmarks.series(program, pattern)
        axis.plot(*zip(*points), "o-", color="tab:blue")
        axis.set(xlabel=label, ylabel=unit)
        axis.set_ylim(0, 1.3 * max(y for _, y in points))
        axis.grid(alpha=0.3)
    figure.savefig(path, dpi=120)


def comparison(benchmarks, seconds):
    """The rows of the table of targets: (what, measured, target, whether it is met)."""
    rows = []

    def add(what, value, unit, target, met):
        rows.append(f"| {what} | {value}{unit} | {target} | {'yes' if met else 'no'} |")

    ticks = benchmarks.rows["bench_estimator"]
    means = {name: times[0] for name, times in ticks.items() if name.startswith("tick, mean over a block")}
    for name, median in means.items():
        add(name, f"{median:.2f}", " µs", "≤ 1 µs", median <= 1)
    dearest = max((times[0], name) for name, times in ticks.items() if name.startswith("dearest kind of tick"))
    add(f"{dearest[1]}, median", f"{dearest[0]:.1f}", " µs", "≤ 15 µs", dearest[0] <= 15)
    cpic = benchmarks.median("bench_cpic", "Cpic::update, all")
    add("CPIC with 14 joint limits and the torque limits, median", f"{cpic:.2f}", " µs", "≤ 1.1 µs", cpic <= 1.1)
    eigen, rme = seconds["`#include <Eigen/Dense>`"], seconds["`#include <rme/rme.hpp>`"]
    add("compile time of `<rme/rme.hpp>` over `<Eigen/Dense>`", f"{rme / eigen:.2f}", "", "≤ 1.5", rme <= 1.5 * eigen)
    estimator = seconds["one `Estimator<double, 7>`"]
    add("compile time of one `Estimator<double, 7>`", f"{estimator:.1f}", " s", "≤ 6 s", estimator <= 6)
    return rows


def alternatives(benchmarks):
    """What a user would pick instead: (what, rme, the other one, ratio)."""
    rows = []

    def add(what, other, ours, theirs):
        if ours and theirs:
            rows.append(f"| {what} | {ours:.3g} µs | {other} | {theirs:.3g} µs | {theirs / ours:.1f} |")

    published = "bench_published_o2"
    add("network in float, with its input", "TorchScript in C++, one thread",
        benchmarks.median(published, "rme: network with its input"),
        benchmarks.median(published, "published: network in TorchScript, with its input"))
    estimate, how = benchmarks.median(published, "published estimate"), "TorchScript, stochastic VI over all residuals"
    if not estimate:  # built without libtorch
        estimate, how = benchmarks.median(published, "published estimate, without its network"), \
            "stochastic VI over all residuals alone, without the network"
    add("tracker, all of the 200 ms after an attach", f"one published estimate in C++: {how}",
        benchmarks.median(published, "tracker: the 200 ticks after the attach, together"), estimate)
    add("PublishedPipeline, the tick that estimates", "the same",
        benchmarks.median(published, "PublishedPipeline: the tick that estimates"), estimate)
    add("closed-form VI, from the sums", "stochastic VI, published settings, from the same sums",
        benchmarks.median("bench_inference", "infer: full covariance, from the likelihood"),
        benchmarks.median("bench_inference", "infer: stochastic VI, published settings"))
    for active in ("no active row", "1 active row", "2 or 3 active rows", "4 or more active rows"):
        for peer, name in (("quadprog", "quadprog, Fortran from R's package"), ("NLopt SLSQP", "NLopt's SLSQP")):
            add(f"quadratic program of 14 rows and a box, cold, {active}", name,
                benchmarks.median("bench_qp_peers", f"ActiveSetSolver::solve, {active}"),
                benchmarks.median("bench_qp_peers", f"{peer}, {active}"))
    add("model of the arm, momentum observer, pseudo-wrench", "Orocos KDL's ChainExternalWrenchEstimator",
        benchmarks.median("bench_observer", "the same and the arm's model (examples/synthetic_arm)"),
        benchmarks.median("bench_observer", "KDL::ChainExternalWrenchEstimator"))
    return rows


def main():
    build = Path(sys.argv[1]).resolve()
    quick = "--quick" in sys.argv
    benchmarks = Benchmarks(build, quick)
    for name in ("bench_estimator", "bench_scaling", "bench_inference", "bench_cpic", "bench_qp_peers", "bench_observer",
                 "bench_network_o2", "bench_network_native"):
        benchmarks.run(name)
    with tempfile.TemporaryDirectory() as folder:
        model = []
        traced = subprocess.run([sys.executable, Path(__file__).with_name("trace.py"),
                                 ROOT / "examples" / "models" / "panda.json", Path(folder) / "panda.pt"])
        if traced.returncode == 0:
            model = [str(Path(folder) / "panda.pt")]
        for flags in ("o2", "native"):
            benchmarks.run(f"bench_published_{flags}", *model)
    seconds = compile_times(build, 1 if quick else 3)
    sizes = code_sizes(build)

    docs = build / "performance" if quick else ROOT / "docs"
    (docs / "images").mkdir(parents=True, exist_ok=True)
    draw(benchmarks, docs / "images" / "performance_scaling.png")
    target_rows = comparison(benchmarks, seconds)
    other_rows = alternatives(benchmarks)
    text = f"""# Performance

Written by `bash tests/benchmarks/run.sh`; run it on your own machine, and compare ratios rather than microseconds.

{machine(build)}. {' '.join(FLAGS)}, unless a row says otherwise. One thread{', at real-time priority' if benchmarks.prefix else ''}; the machine is shared, and virtual.
Between two ticks of the estimator the caches see a tick of a simulation.

## Against the targets

| what | measured | target | met |
|---|---:|---:|---|
{chr(10).join(target_rows)}

A tick is `update()` and `compensation()`. The work that a block of 20 ticks makes is spread over the ticks after it: the
dearest kind of tick is the one of the 20 whose median is highest. What bounds each call: [real_time.md](real_time.md).

## Against what one would use instead

| rme | | instead | | times slower |
|---|---:|---|---:|---:|
{chr(10).join(other_rows)}

## Scaling

![Time by joints and constraint rows](images/performance_scaling.png)

## What a build pays

| | |
|---|---:|
{chr(10).join(f"| compiling {name} alone | {value:.2f} s |" for name, value in seconds.items())}
{chr(10).join(f"| object code of {name} | {value / 1024:.0f} KiB |" for name, value in sizes.items())}

## All measurements

{(chr(10) + chr(10)).join(benchmarks.text.values())}
"""
    (docs / "performance.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
