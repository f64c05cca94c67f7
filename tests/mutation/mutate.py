#!/usr/bin/env python3
"""Breaks a header in many small ways, one at a time, and says which of them its tests do not notice.

    python3 tests/mutation/mutate.py HEADER TEST... [--build DIR] [--count N] [--seed N] [--jobs N] [--list]

HEADER is below include/, e.g. rme/tracking/sensor_noise.hpp; TEST is a test program of the build, e.g.
tracking_test_sensor_noise. The build folder must be a finished one. Each mutant is compiled from the test's own source
and command, with a copy of include/ in front in which one line differs, and without precompiled templates. A mutant that
does not compile, fails, or runs ten times longer than the original is dead. Prints one line for each that survives.

Exit codes: 0 at least 95 % are dead; 1 fewer are; 2 unusable arguments.
"""
import argparse
import concurrent.futures
import json
import pathlib
import random
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]

# What to look for in a line of code, and what to put in its place.
PATTERNS = [
    (r" < ", " <= "), (r" > ", " >= "), (r" <= ", " < "), (r" >= ", " > "), (r" == ", " != "), (r" != ", " == "),
    (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "), (r" / ", " * "), (r" \+= ", " -= "), (r" -= ", " += "),
    (r" \*= ", " /= "), (r" /= ", " *= "), (r" && ", " || "), (r" \|\| ", " && "), (r"\btrue\b", "false"),
    (r"\bfalse\b", "true"), (r"std::min\(", "std::max("), (r"std::max\(", "std::min("), (r"\bif \((?!constexpr)", "if (!("),
    (r"\bcontinue;", ";"), (r"(?<![\w.])0\.(\d+)\b", r"3.\1"), (r"Scalar\(([1-9]\d*)\)", r"Scalar(2 * \1)"),
]


def mutants_of(text):
    """All (line number, old line, new line), comments and includes left alone."""
    out = []
    for number, line in enumerate(text.splitlines()):
        code = line.split("//")[0]
        if not code.strip() or code.lstrip().startswith(("#", "template", "static_assert", "using", "namespace")):
            continue
        for pattern, replacement in PATTERNS:
            for match in re.finditer(pattern, code):
                new = code[: match.start()] + match.expand(replacement) + code[match.end():]
                if replacement == "if (!(":  # the bracket that is open now closes with the condition
                    depth, end = 1, match.end() + 2
                    while depth and end < len(new):
                        depth += {"(": 1, ")": -1}.get(new[end], 0)
                        end += 1
                    if depth:
                        continue
                    new = new[:end] + ")" + new[end:]
                out.append((number, line, new))
    return out


class Test:
    """One test program: how to compile it against another include folder, and how long it takes."""

    def __init__(self, name, build):
        folder, source = name.split("_", 1)
        path = ROOT / "tests" / folder / (source + ".cpp")
        entries = json.loads((build / "compile_commands.json").read_text())
        entry = next((e for e in entries if pathlib.Path(e["file"]) == path), None)
        if entry is None:
            sys.exit(f"mutate: {path} is in no command of {build}")
        words, self.compile = shlex.split(entry["command"]), []
        skip = False
        for word in words:
            if skip:
                skip = False
            elif word in ("-include", "-o", "-Xclang", "-MT", "-MF"):
                skip = True
            elif word not in ("-Werror", "-Winvalid-pch", "-O3", "-MD", "-c") and not word.endswith("ccache"):
                self.compile.append(word)
        links = subprocess.run(["ninja", "-C", str(build), "-t", "commands", name], capture_output=True, text=True,
                               check=True).stdout.splitlines()
        link = next(line for line in reversed(links) if f" -o tests/{folder}/{name} " in line)
        link = link.split("&&")[1] if "&&" in link else link
        self.link = [w for w in shlex.split(link) if not w.endswith(source + ".cpp.o")]
        self.name, self.build, self.seconds = name, build, None

    def passes(self, include, folder):
        program, unit = folder / self.name, folder / (self.name + ".o")
        compile_ = [f"-I{include}" if w == f"-I{ROOT}/include" else w for w in self.compile]
        if subprocess.run([*compile_, "-O1", "-w", "-c", "-o", unit], cwd=self.build, capture_output=True).returncode:
            return None
        link = list(self.link)
        link[link.index("-o") + 1] = str(program)
        link.insert(link.index("-o"), str(unit))
        subprocess.run(link, cwd=self.build, capture_output=True, check=True)
        begin = time.monotonic()
        try:
            code = subprocess.run([program], cwd=folder, capture_output=True,
                                  timeout=None if self.seconds is None else 5 + 10 * self.seconds).returncode
        except subprocess.TimeoutExpired:
            return False
        self.seconds = self.seconds or time.monotonic() - begin
        return code == 0


def judge(mutant, header, text, tests, base):
    """'compile' if it does not, the name of the test that fails, or None if all pass."""
    number, _, new = mutant
    with tempfile.TemporaryDirectory(dir=base) as name:
        folder = pathlib.Path(name)
        include = folder / "include"
        shutil.copytree(ROOT / "include", include)
        lines = text.splitlines()
        lines[number] = new
        (include / header).write_text("\n".join(lines) + "\n")
        for test in tests:
            passed = test.passes(include, folder)
            if passed is None:
                return "compile"
            if not passed:
                return test.name
    return None


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("header")
    parser.add_argument("tests", nargs="+")
    parser.add_argument("--build", default="build", type=pathlib.Path)
    parser.add_argument("--count", type=int, help="that many of them, chosen at random")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--list", action="store_true", help="say what became of each")
    options = parser.parse_args()
    build = options.build.resolve()
    header = options.header
    text = (ROOT / "include" / header).read_text()
    mutants = mutants_of(text)
    if options.count and options.count < len(mutants):
        mutants = sorted(random.Random(options.seed).sample(mutants, options.count))
    with tempfile.TemporaryDirectory() as base:
        tests = [Test(name, build) for name in options.tests]
        for test in tests:
            if not test.passes(ROOT / "include", pathlib.Path(base)):
                sys.exit(f"mutate: {test.name} fails on the header as it is")
        dead = broken = 0
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            verdicts = pool.map(lambda m: judge(m, header, text, tests, base), mutants)
            for k, (mutant, verdict) in enumerate(zip(mutants, verdicts), 1):
                number, old, new = mutant
                broken += verdict == "compile"
                dead += verdict not in (None, "compile")
                if verdict is None or options.list:
                    print(f"{header}:{number + 1}: {'SURVIVES' if verdict is None else 'dead, ' + verdict}\n"
                          f"  - {old.strip()}\n  + {new.strip()}", flush=True)
                print(f"\r{k} of {len(mutants)}", end="", file=sys.stderr, flush=True)
        print(file=sys.stderr)
    count = len(mutants) - broken
    print(f"{header}: {dead} of {count} mutants are dead ({100 * dead / max(1, count):.0f} %); "
          f"{broken} more do not compile. Seed {options.seed}.")
    return 0 if dead >= 0.95 * count else 1


if __name__ == "__main__":
    sys.exit(main())
