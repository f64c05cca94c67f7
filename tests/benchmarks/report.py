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
    "one `MismatchNetwork<float>`": """#include <new>
#include <rme/network/mismatch_network.hpp>
using Network = rme::MismatchNetwork<float>;
void construct(Network::Weights& weights, void* memory) { new (memory) Network(weights); }
bool ask(const Network& network, const Network::Window& window, Network::Output& out) {
  return network.forward(window, out) == rme::Status::Ok;
}
""",
}


def output_of(*command, environment=None):
    return subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout.strip()


def priority():
    """The command that gives a program the priority of a control loop, where that is allowed."""
    command = ["chrt", "--fifo", "50"]
    try:
        return command if subprocess.run([*command, "true"], capture_output=True).returncode == 0 else []
    except FileNotFoundError:
        return []


def blas_folders(root="/usr/lib"):
    """Where the machine has implementations of BLAS, in the folders in which Debian keeps them beside each other:
    {name: folder}. TorchScript takes the one whose folder LD_LIBRARY_PATH names."""
    found = {"OpenBLAS": sorted(Path(root).glob("*/openblas-*/libblas.so.3")),
             "Debian's default BLAS": sorted(Path(root).glob("*/blas/libblas.so.3"))}
    return {name: files[0].parent for name, files in found.items() if files}


class Benchmarks:
    """The programs of a build folder: their tables as text, and their rows by name (median, 99 %, 99.9 % [us])."""

    def __init__(self, build, quick):
        self.folder = build / "tests" / "benchmarks"
        self.prefix = priority()
        self.quick = ["--quick"] if quick else []
        self.commands = {}
        self.text = {}
        self.rows = {}

    def run(self, name, *arguments, run=None, blas=None):
        """Runs a program; `run` names the run, where there are several of one program.
        @param blas  folder of the BLAS that the program is to take"""
        run = run or name
        if not (self.folder / name).exists():
            print(f"left out: {name} was not built", file=sys.stderr)
            return
        print(f"running {run}", file=sys.stderr, flush=True)
        environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
        command = " ".join([name, *(Path(argument).name for argument in arguments)])
        if blas:
            environment["LD_LIBRARY_PATH"] = str(blas)
            command = f"LD_LIBRARY_PATH={blas} {command}"
            taken = output_of("ldd", self.folder / name, environment=environment)
            if f"libblas.so.3 => {blas}/" not in taken:
                raise RuntimeError(f"{name} does not take its BLAS from {blas}:\n{taken}")
        self.add(run, command, output_of(*self.prefix, self.folder / name, *arguments, *self.quick,
                                         environment=environment))

    def takes_blas(self, name):
        """Whether a program was built, and with TorchScript."""
        return (self.folder / name).exists() and "libblas.so.3" in output_of("ldd", self.folder / name)

    def add(self, run, command, text):
        """What a program has printed; each of its tables is given the command under its heading."""
        self.commands[run] = f"`{command}`"
        self.text[run] = re.sub(r"^(### .*)$", rf"\1\n\n`{command}`", text, flags=re.MULTILINE)
        self.rows[run] = {}
        for line in text.splitlines():
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            if len(cells) == 5 and re.fullmatch(r"[-\d.]+", cells[1]):
                self.rows[run][cells[0]] = tuple(map(float, cells[1:4]))

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
    """Median CPU seconds of translation units with one thing in them; in turns, so that each meets the same machine."""
    units = {**INCLUDES, **PROGRAMS}
    times = {name: [] for name in units}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(runs):
            for name, text in units.items():
                source = Path(folder) / "unit.cpp"
                source.write_text(text)
                start = os.times()
                subprocess.run(compile_command(build, source, Path(folder) / "unit.o"), check=True)
                end = os.times()
                times[name].append(end.children_user + end.children_system - start.children_user - start.children_system)
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
        ("bench_scaling", r"slowest tick of a block: (\d+) joints", "joints", "estimator, slowest tick [µs]"),
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
    """The rows of the table of targets: (what, measured, target, whether it is met, command)."""
    rows = []

    def add(what, value, unit, target, met, command):
        rows.append(f"| {what} | {value}{unit} | {target} | {'yes' if met else 'no'} | {command} |")

    ticks = benchmarks.rows["bench_estimator"]
    command = benchmarks.commands["bench_estimator"]
    means = {name: times[0] for name, times in ticks.items() if name.startswith("tick, mean over a block")}
    for name, median in means.items():
        add(name, f"{median:.2f}", " µs", "≤ 1 µs", median <= 1, command)
    slowest = max((times[0], name) for name, times in ticks.items() if name.startswith("slowest kind of tick"))
    add(f"{slowest[1]}, median", f"{slowest[0]:.1f}", " µs", "≤ 15 µs", slowest[0] <= 15, command)
    for run, blas in published_runs(benchmarks)[:1]:
        tick = benchmarks.median(run, "tracker: the slowest of the 200 after the attachment")
        estimate = benchmarks.median(run, "published estimate, early stop")
        if tick and estimate:
            add(f"published estimate with its early stop, {blas}, divided by the slowest tick of the 200 after the attachment",
                f"{estimate / tick:.0f}", "", "≥ 100", estimate >= 100 * tick, benchmarks.commands[run])
    cpic = benchmarks.median("bench_cpic", "Cpic::update, all")
    add("CPIC with 14 joint limits and the torque limits, median", f"{cpic:.2f}", " µs", "≤ 1.1 µs", cpic <= 1.1,
        benchmarks.commands["bench_cpic"])
    eigen, rme = seconds["`#include <Eigen/Dense>`"], seconds["`#include <rme/rme.hpp>`"]
    add("compile time of `<rme/rme.hpp>`, divided by that of `<Eigen/Dense>`", f"{rme / eigen:.2f}", "", "≤ 1.5", rme <= 1.5 * eigen,
        "`g++`, as below")
    estimator = seconds["one `Estimator<double, 7>`"]
    add("compile time of one `Estimator<double, 7>`", f"{estimator:.1f}", " s", "≤ 6 s", estimator <= 6,
        "`g++`, as below")
    return rows


def published_runs(benchmarks):
    """The runs of bench_published at -O2: (run, which BLAS TorchScript has); (run, None) without TorchScript."""
    return [(run, run.partition(", ")[2] or None) for run in benchmarks.rows if run.startswith("bench_published_o2")]


def alternatives(benchmarks):
    """What a user would pick instead: (what, its time [us], the other one, its time [us], command)."""
    rows = []

    def add(what, other, run, ours, theirs):
        ours, theirs = benchmarks.median(run, ours), benchmarks.median(run, theirs)
        if ours and theirs:
            rows.append((what, ours, other, theirs, benchmarks.commands[run]))

    for run, blas in published_runs(benchmarks):
        add("network in float, with its input, first pass", f"TorchScript in C++, one thread, {blas}", run,
            "rme: network with its input, first pass", "TorchScript: network with its input, first pass")
        add("the same network, again", f"TorchScript in C++, one thread, {blas}", run,
            "rme: network with its input, again", "TorchScript: network with its input, again")
    for run, blas in published_runs(benchmarks)[:1]:
        name = "published estimate" if blas else "published estimate without network"
        for stop, how in (("early stop", "with its early stop, as published"), ("all steps", "all of 2,500 steps")):
            other = f"one published estimate in C++: {f'TorchScript, {blas}' if blas else 'no network'}; " \
                    f"stochastic VI over all residuals, {how}"
            add("tracker, the 200 ticks after an attachment together", other, run,
                "tracker: the 200 ticks after the attachment, together", f"{name}, {stop}")
            add("tracker, the slowest of these ticks", other, run,
                "tracker: the slowest of the 200 after the attachment", f"{name}, {stop}")
            add("PublishedPipeline, the tick that estimates", other, run,
                "PublishedPipeline: the tick that estimates", f"{name}, {stop}")
    for run, _ in published_runs(benchmarks)[:1]:
        add("tracker, 200 ticks in which nothing happens together", "PublishedPipeline, which only watches", run,
            "tracker: the 200 ticks before the attachment, together", "PublishedPipeline: the 200 before the attachment, together")
        add("tracker, the 200 ticks after an attachment together", "PublishedPipeline, the tick that estimates", run,
            "tracker: the 200 ticks after the attachment, together", "PublishedPipeline: the tick that estimates")
    add("closed-form VI, from the likelihood", "rme's stochastic VI with the published settings, from the same",
        "bench_inference", "infer_payload: full covariance, from the likelihood",
        "infer_payload: stochastic VI as published, from the likelihood")
    for active in ("no active row", "1 active row", "2 or 3 active rows", "4 or more active rows"):
        for peer, name in (("quadprog", "quadprog, Fortran from R's package"), ("NLopt SLSQP", "NLopt's SLSQP")):
            add(f"quadratic program of 14 rows and a box, cold, {active}", name, "bench_qp_peers",
                f"ActiveSetSolver::solve, {active}", f"{peer}, {active}")
    add("model of the arm, momentum observer, pseudo-wrench", "Orocos KDL's ChainExternalWrenchEstimator",
        "bench_observer", "the same and the arm's model (examples/synthetic_arm)", "KDL::ChainExternalWrenchEstimator")
    return rows


def microseconds(time):
    """Three digits of it, or all before the point."""
    return f"{time:.0f} µs" if time >= 100 else f"{time:.3g} µs"


def ratio_table(rows, faster):
    """Rows of alternatives() as a table: those in which the other one is slower, or those in which it is faster."""
    lines = [f"| rme | time | alternative | time | times {'faster' if faster else 'slower'} | measured by |",
             "|---|---:|---|---:|---:|---|"]
    for what, ours, other, theirs, command in rows:
        if (theirs < ours) == faster:
            ratio = ours / theirs if faster else theirs / ours
            lines.append(f"| {what} | {microseconds(ours)} | {other} | {microseconds(theirs)} | {ratio:.1f} | {command} |")
    return "\n".join(lines) if len(lines) > 2 else "None of those that were compared."


def main():
    build = Path(sys.argv[1]).resolve()
    quick = "--quick" in sys.argv
    benchmarks = Benchmarks(build, quick)
    for name in ("bench_estimator", "bench_scaling", "bench_inference", "bench_cpic", "bench_qp_peers", "bench_observer",
                 "bench_network_o2", "bench_network_native"):
        benchmarks.run(name)
    with tempfile.TemporaryDirectory() as folder:
        model = Path(folder) / "panda.pt"
        traced = subprocess.run([sys.executable, Path(__file__).with_name("trace.py"),
                                 ROOT / "examples" / "models" / "panda.json", model])
        folders = blas_folders() if traced.returncode == 0 and benchmarks.takes_blas("bench_published_o2") else {}
        for blas, path in folders.items():
            benchmarks.run("bench_published_o2", model, run=f"bench_published_o2, {blas}", blas=path)
        for blas, path in list(folders.items())[:1]:
            benchmarks.run("bench_published_native", model, run=f"bench_published_native, {blas}", blas=path)
        if not folders:  # without TorchScript
            for flags in ("o2", "native"):
                benchmarks.run(f"bench_published_{flags}")
    seconds = compile_times(build, 1 if quick else 3)
    sizes = code_sizes(build)

    docs = build / "performance" if quick else ROOT / "docs"
    (docs / "images").mkdir(parents=True, exist_ok=True)
    draw(benchmarks, docs / "images" / "performance_scaling.png")
    target_rows = comparison(benchmarks, seconds)
    other_rows = alternatives(benchmarks)
    text = f"""# Performance

This page is written by `bash tests/benchmarks/run.sh`. Run it on your own machine, and compare ratios rather than microseconds.

{machine(build)}. {' '.join(FLAGS)}, unless a row says otherwise. One thread{', at real-time priority' if benchmarks.prefix else ''}; the machine is shared, and virtual.
Between two ticks of the estimator, a tick of a simulation runs and uses the same caches.

Every row names the program in `build-benchmarks/tests/benchmarks` that measures it. The times in the first tables are medians.
"All measurements" has the output of each program: the median and the times that 99 % and 99.9 % of the calls do not exceed.
`panda.pt` is made by `python3 tests/benchmarks/trace.py examples/models/panda.json panda.pt`.

## Against the targets

| what | measured | target | target met | measured by |
|---|---:|---:|---|---|
{chr(10).join(target_rows)}

A tick is `update()` and `compensation()`. The work for a block of 20 ticks is spread over the ticks after it, so there are 20
kinds of tick. The slowest kind is the one with the highest median, the fastest kind the one with the lowest. For the upper
bound of each call's work see [real_time.md](real_time.md).

## Alternatives that are slower than rme

{ratio_table(other_rows, faster=False)}

A published estimate is made once in an event, when the caches contain other data. The relevant time is therefore that of the
network's first pass; "again" is a second pass right after it. TorchScript optimises itself in its first 200 calls, which are
not counted. TorchScript uses the BLAS that the system provides: Debian's default is the reference BLAS, OpenBLAS is the package
libopenblas0.

## Alternatives that are faster than rme

{ratio_table(other_rows, faster=True)}

## Scaling

![Time by joints and constraint rows](images/performance_scaling.png)

## Compile time and code size

| what | measured |
|---|---:|
{chr(10).join(f"| compiling {name} alone | {value:.2f} s |" for name, value in seconds.items())}
{chr(10).join(f"| object code of {name} | {value / 1024:.0f} KiB |" for name, value in sizes.items())}

The times are CPU times of `g++ {' '.join(FLAGS)} -c` for a file with nothing else in it, measured by `compile_times()`
of `tests/benchmarks/report.py`. The sizes are those of machine code and constants, measured by `size`.

## All measurements

{(chr(10) + chr(10)).join(benchmarks.text.values())}
"""
    (docs / "performance.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
