#!/usr/bin/env python3
"""Breaks a header in many small ways, one at a time, and says which of them its tests do not notice.

    python3 tests/mutation/mutate.py HEADER [TEST...] [--build DIR] [--count N] [--seed N] [--jobs N]
                                     [--verbose]
    python3 tests/mutation/mutate.py --all [--count N] ...
    python3 tests/mutation/mutate.py HEADER --list

HEADER is below include/, e.g. rme/tracking/sensor_noise.hpp; TEST is a test program of the build, e.g.
tracking_test_sensor_noise. Without a TEST, and with --all, tests/mutation/headers.txt says which tests a header has;
--all takes every header there, --count then counts for each. The build folder must have these tests built.

Each mutant differs in one line. As many as possible are compiled at once, each behind a test of an environment variable;
the others, where a line cannot hold both, one at a time. They are compiled from the test's own source and command, with a
copy of include/ in front, with assertions, and without precompiled templates. A mutant that does not compile does not
count. One that fails, or runs ten times longer than the original, is dead. What survives is printed, unless
tests/mutation/equivalent.txt explains it: those are not run, and count as alive. With --verbose every mutant is printed,
with what became of it. With --list they are printed, and nothing is compiled or run.

Exit codes: 0 every survivor is explained, and with --all at least 95 % are dead; 1 otherwise; 2 unusable arguments, or
an explanation of a mutant that does not exist.
"""
import argparse
import concurrent.futures
import json
import os
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
HERE = pathlib.Path(__file__).resolve().parent

# What to look for in a line of code, and what to put in its place.
PATTERNS = [
    (r" < ", " <= "), (r" > ", " >= "), (r" <= ", " < "), (r" >= ", " > "), (r" == ", " != "), (r" != ", " == "),
    (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "), (r" / ", " * "), (r" \+= ", " -= "), (r" -= ", " += "),
    (r" \*= ", " /= "), (r" /= ", " *= "), (r" && ", " || "), (r" \|\| ", " && "), (r"\btrue\b", "false"),
    (r"\bfalse\b", "true"), (r"std::min\(", "std::max("), (r"std::max\(", "std::min("), (r"\bif \((?!constexpr)", "if (!("),
    (r"\bcontinue;", ";"), (r"(?<![\w.])0\.(\d+)\b", r"3.\1"), (r"Scalar\(([1-9]\d*)\)", r"Scalar(2 * \1)"),
]

# What a test's compiler need not read again for each mutant. Nothing of include/ may be in it.
PREFIX = '#include "support/catch.hpp"\n#include <Eigen/Dense>\n#include <deque>\n#include <fstream>\n#include <random>\n'


# Which mutant is chosen; in the first line, so that the others keep their numbers.
SWITCH = """
#include <cstdlib>
namespace rme_mutation {
inline const int chosen = std::getenv("RME_MUTANT") ? std::atoi(std::getenv("RME_MUTANT")) : 0;
}
#line 2"""


def fail(text):
    print("mutate: " + text, file=sys.stderr)
    sys.exit(2)


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
                out.append((number, code, new))
    return out


def closing(code, begin):
    """Where the bracket that is open before `begin` closes."""
    depth = 1
    for i in range(begin, len(code)):
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(code[i], 0)
        if depth == 0:
            return i
    return None


def split_at(code, begin, end, mark):
    """The (begin, end) of what `mark` separates in code[begin:end], brackets left whole."""
    out, depth = [], 0
    for i in range(begin, end):
        depth += {"(": 1, "[": 1, "{": 1, ")": -1, "]": -1, "}": -1}.get(code[i], 0)
        if depth == 0 and code[i] == mark:
            out.append((begin, i))
            begin = i + 1
    return out + [(begin, end)]


ASSIGNMENT = re.compile(r"^ *[\w.\->()\[\]:*&]+(?:<[^=;]*>)? (?:[+\-*/]?=) ")
DECLARATION = re.compile(r"^ *(?:static |constexpr |const )*[\w:]+(?:<[^=;]*>)?[&*]? [&*]?\w+ = ")


def regions(code):
    """Parts of a line that can stand beside a changed form of themselves: (begin, end, is it a statement?)."""
    out, rest = [], re.match(r" *(?:\} )?(?:else )?", code).end()
    while True:
        head = re.match(r"(?:if|while|for) \(", code[rest:])
        if not head:
            break
        begin, end = rest + head.end(), closing(code, rest + head.end())
        if end is None:
            return out
        for b, e in split_at(code, begin, end, ";"):
            declared = DECLARATION.match(code[b:e])
            if " : " not in code[b:e] or "?" in code[b:e]:
                out.append((b + (declared.end() if declared else 0), e, False))
        rest = end + 1 + len(re.match(r" *", code[end + 1:]).group())
    if not code.rstrip().endswith(";"):
        return out
    end = len(code.rstrip()) - 1
    if code.startswith("return ", rest):
        out.append((rest + 7, end, False))
    elif DECLARATION.match(code[rest:]):
        for b, e in split_at(code, rest, end, ","):
            equals = code.find(" = ", b, e)
            if equals >= 0:
                out.append((equals + 3, e, False))
    elif ASSIGNMENT.match(code[rest:]) or re.match(r"[\w:.]+\(|\+\+|--|\(void\)", code[rest:]) or code[rest:end] == "continue":
        out.append((rest, end + 1, True))
    return out


def differing(old, new):
    """The first place, and the last one in each, in which two lines differ."""
    first = next((i for i, (a, b) in enumerate(zip(old, new)) if a != b), min(len(old), len(new)))
    last = 0
    while last < min(len(old), len(new)) - first and old[-1 - last] == new[-1 - last]:
        last += 1
    return first, len(old) - last, len(new) - last


def together(text, mutants):
    """The header with all of `mutants` {number: mutant}, the one chosen whose number is in RME_MUTANT, and the numbers of
    those that it has; the others cannot be switched."""
    lines, held, per_line = text.splitlines(), set(), {}
    for name, mutant in mutants.items():
        per_line.setdefault(mutant[0], []).append((name, mutant))
    for number, here in per_line.items():
        code = lines[number].split("//")[0]
        before = next((l for l in reversed(lines[:number]) if l.split("//")[0].strip()), "").split("//")[0].rstrip()
        if before and not before.endswith((";", "{", "}", ")", "else", ":", ">")) and not before.startswith("#"):
            continue  # in the middle of a statement
        if before.endswith(")") and not re.match(r" *(?:\} )?(?:else )?(?:if|for|while) \(", before):
            continue
        for begin, end, statement in sorted(regions(code), reverse=True):
            out = code[begin:end]
            for name, (_, old, new) in here:
                first, old_end, _ = differing(old, new)
                if first < begin or old_end > end:
                    continue
                changed = new[begin:end + len(new) - len(old)]
                chosen = f"rme_mutation::chosen == {name}"
                out = f"if ({chosen}) {{ {changed} }} else {{ {out} }}" if statement else f"({chosen} ? ({changed}) : ({out}))"
                held.add(name)
            code = code[:begin] + ("{ " + out + " }" if statement else out) + code[end:]
        lines[number] = code
    first = lines.index("#pragma once")
    lines[first] += SWITCH
    return "\n".join(lines) + "\n", held


def same(line):
    """A line of code as equivalent.txt has it: without its indentation and comment."""
    return line.split("//")[0].strip()


def headers():
    """tests/mutation/headers.txt: {header: [test, ...]}."""
    lines = [line.split() for line in (HERE / "headers.txt").read_text().splitlines() if not line.startswith("#")]
    return {words[0]: words[1:] for words in lines if words}


def explanations_of(text):
    """{(header, old line, new line): reason} of equivalent.txt, or of what this program prints."""
    out, header, old, new = {}, None, None, None
    for line in text.splitlines():
        mark, rest = line[:2], line[2:].strip()
        if line.startswith("rme/"):
            header = line.split(":")[0].strip()
        elif mark == "- ":
            old = rest
        elif mark == "+ ":
            new = rest
            out[header, old, new] = ""
        elif mark == "= ":
            out[header, old, new] = rest
        elif line.strip() and not line.startswith(("#", "total")):
            fail(f"expected a header, '- old line', '+ new line' or '= reason', got '{line}'")
    return out


def explained():
    """What tests/mutation/equivalent.txt says."""
    out = explanations_of((HERE / "equivalent.txt").read_text())
    for key, reason in out.items():
        if not reason:
            fail(f"equivalent.txt does not say why '{key[1]}' may become '{key[2]}'")
    return out


class Test:
    """One test program: how to compile it against another include folder, and how long it takes."""

    def __init__(self, name, build, base):
        folder, source = name.split("_", 1)
        path = ROOT / "tests" / folder / (source + ".cpp")
        entries = json.loads((build / "compile_commands.json").read_text())
        entry = next((e for e in entries if pathlib.Path(e["file"]) == path), None)
        if entry is None:
            fail(f"{path} is in no command of {build}")
        words, self.compile = shlex.split(entry["command"]), []
        skip = False
        for word in words:
            if skip:
                skip = False
            elif word in ("-include", "-o", "-Xclang", "-MT", "-MF"):
                skip = True
            elif word not in ("-Werror", "-Winvalid-pch", "-O3", "-DNDEBUG", "-MD", "-c") and not word.endswith("ccache"):
                self.compile.append(word)
        # What leaves an array may do no harm otherwise.
        self.compile += ["-O1", "-w", "-D_GLIBCXX_ASSERTIONS"]
        links = subprocess.run(["ninja", "-C", str(build), "-t", "commands", name], capture_output=True, text=True,
                               check=True).stdout.splitlines()
        link = next(line for line in reversed(links) if f" -o tests/{folder}/{name} " in line)
        link = link.split("&&")[1] if "&&" in link else link
        self.link = [w for w in shlex.split(link) if not w.endswith(source + ".cpp.o")]
        self.name, self.build, self.seconds = name, build, None
        prefix = base / (name + ".hpp")
        prefix.write_text(PREFIX + ("#include <nlohmann/json.hpp>\n" if "json.hpp" in path.read_text() else ""))
        subprocess.run([w for w in self.compile if w != str(path)] + ["-x", "c++-header", prefix, "-o", f"{prefix}.gch"],
                       cwd=build, check=True)
        self.compile += ["-include", str(prefix)]

    def builds(self, include, folder, only_check=False):
        """Compiles against `include`. @return what the compiler says against it, empty if nothing"""
        unit = folder / (self.name + ".o")
        compile_ = [f"-I{include}" if w == f"-I{ROOT}/include" else w for w in self.compile]
        kind = ["-fsyntax-only"] if only_check else ["-c", "-o", unit]
        done = subprocess.run([*compile_, *kind], cwd=self.build, capture_output=True, text=True)
        if done.returncode:
            return done.stderr or "unknown"
        if only_check:
            return ""
        link = list(self.link)
        link[link.index("-o") + 1] = str(folder / self.name)
        link.insert(link.index("-o"), str(unit))
        subprocess.run(link, cwd=self.build, capture_output=True, check=True)
        return ""

    def passes(self, folder, mutant=0):
        """Whether the program in `folder` succeeds."""
        begin = time.monotonic()
        try:
            code = subprocess.run([folder / self.name, "--abort"], cwd=folder, capture_output=True,
                                  env={**os.environ, "RME_MUTANT": str(mutant)},
                                  timeout=None if self.seconds is None else 5 + 10 * self.seconds).returncode
        except subprocess.TimeoutExpired:
            return False
        self.seconds = self.seconds or time.monotonic() - begin
        return code == 0


def include_with(header, text, folder):
    """A copy of include/ in `folder` in which `header` is `text`."""
    include = folder / "include"
    shutil.copytree(ROOT / "include", include)
    (include / header).write_text(text)
    return include


def judge_alone(mutant, header, text, tests, base):
    """'compile' if it does not, the name of the test that fails, or None if all pass."""
    number, _, new = mutant
    with tempfile.TemporaryDirectory(dir=base) as name:
        folder = pathlib.Path(name)
        lines = text.splitlines()
        lines[number] = new
        include = include_with(header, "\n".join(lines) + "\n", folder)
        for test in tests:
            if test.builds(include, folder):
                return "compile"
            if not test.passes(folder):
                return test.name
    return None


def judge_together(mutants, header, text, tests, base, pool):
    """{number: the name of the test that fails, or None} of those that can be compiled at once."""
    with tempfile.TemporaryDirectory(dir=base) as name:
        folder = pathlib.Path(name)

        def complaint(chosen, only_check):
            """What the compilers say against all of `chosen` at once."""
            shutil.rmtree(folder / "include", ignore_errors=True)
            include = include_with(header, together(text, chosen)[0], folder)
            return "".join(pool.map(lambda test: test.builds(include, folder, only_check), tests))

        def lines_of(complaint):
            return {int(n) - 1 for n in re.findall(re.escape(header) + r":(\d+):", complaint)}

        held = together(text, mutants)[1]
        candidates, doubtful = {k: m for k, m in mutants.items() if k in held}, {}
        while candidates and (said := complaint(candidates, True)):
            wrong = {k for k, m in candidates.items() if m[0] in lines_of(said)} or set(candidates)
            doubtful.update({k: candidates.pop(k) for k in wrong})
        # Of a line that is wrong with all of its mutants, one at a time.
        while doubtful:
            first_of = {m[0]: k for k, m in reversed(sorted(doubtful.items()))}
            trial = {k: doubtful.pop(k) for k in first_of.values()}
            while trial and (said := complaint({**candidates, **trial}, True)):
                wrong = {k for k, m in trial.items() if m[0] in lines_of(said)} or set(trial)
                trial = {k: m for k, m in trial.items() if k not in wrong}
            candidates.update(trial)
        if not candidates or complaint(candidates, False):
            return {}
        if not all(test.passes(folder) for test in tests):
            fail(f"the tests of {header} fail where its mutants are switched off")

        def verdict(number):
            return next((test.name for test in tests if not test.passes(folder, number)), None)

        return dict(zip(candidates, pool.map(verdict, candidates)))


class Score:
    """How many mutants became what."""

    def __init__(self):
        self.dead = self.alive = self.known = self.broken = 0

    def __iadd__(self, other):
        for name in vars(self):
            setattr(self, name, getattr(self, name) + getattr(other, name))
        return self

    def __str__(self):
        count = self.dead + self.alive + self.known
        return (f"{self.dead} of {count} mutants are dead ({100 * self.dead / max(1, count):.1f} %), "
                f"{self.known} are explained, {self.alive} are not; {self.broken} more do not compile")


def chosen_mutants(header, text, explanations, options):
    """The mutants of `header` that the options leave."""
    mutants = mutants_of(text)
    keys = {(header, same(old), same(new)) for _, old, new in mutants}
    for key in explanations:
        if key[0] == header and key not in keys:
            fail(f"equivalent.txt explains what no mutant of {header} is: '{key[1]}' -> '{key[2]}'")
    if options.only:
        wanted = explanations_of(options.only.read_text())
        mutants = [m for m in mutants if (header, same(m[1]), same(m[2])) in wanted]
    if options.count and options.count < len(mutants):
        mutants = sorted(random.Random(options.seed).sample(mutants, options.count))
    return mutants


def print_mutant(header, mutant, what):
    number, old, new = mutant
    print(f"{header}:{number + 1}:{what and ' '}{what}\n- {same(old)}\n+ {same(new)}", flush=True)


def examine(header, test_names, explanations, options):
    text = (ROOT / "include" / header).read_text()
    mutants = chosen_mutants(header, text, explanations, options)
    score = Score()
    known = [m for m in mutants if (header, same(m[1]), same(m[2])) in explanations]
    if not options.explained:
        score.known = len(known)
        mutants = [m for m in mutants if m not in known]
    mutants = dict(enumerate(mutants, 1))  # 0 is none
    with tempfile.TemporaryDirectory() as name:
        base = pathlib.Path(name)
        tests = [Test(test, options.build.resolve(), base) for test in test_names]
        for test in tests:
            if test.builds(ROOT / "include", base) or not test.passes(base):
                fail(f"{test.name} fails on {header} as it is")
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            def take(k, verdict):
                if verdict == "compile":
                    score.broken += 1
                elif verdict is not None:
                    score.dead += 1
                elif mutants[k] in known:
                    score.known += 1
                else:
                    score.alive += 1
                if options.verbose or (verdict is None) != (mutants[k] in known):
                    print_mutant(header, mutants[k], "SURVIVES" if verdict is None else "dead, " + verdict)

            verdicts = judge_together(mutants, header, text, tests, base, pool)
            for k, verdict in verdicts.items():
                take(k, verdict)
            alone = [k for k in mutants if k not in verdicts]
            print(f"{header}: {len(verdicts)} mutants at once, {len(alone)} alone", file=sys.stderr, flush=True)
            each = pool.map(lambda k: judge_alone(mutants[k], header, text, tests, base), alone)
            for count, (k, verdict) in enumerate(zip(alone, each), 1):
                take(k, verdict)
                print(f"\r{count} of {len(alone)}", end="", file=sys.stderr, flush=True)
            print(file=sys.stderr)
    print(f"{header}: {score}. Seed {options.seed}.", flush=True)
    return score


def main():
    parser = argparse.ArgumentParser(usage=__doc__.replace("%", "%%"))
    parser.add_argument("header", nargs="?")
    parser.add_argument("tests", nargs="*")
    parser.add_argument("--all", action="store_true", help="every header of headers.txt, and a total")
    parser.add_argument("--build", default="build", type=pathlib.Path)
    parser.add_argument("--count", type=int, help="that many of them, chosen at random")
    parser.add_argument("--only", type=pathlib.Path, metavar="FILE", help="those that FILE, an earlier output, prints")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--list", action="store_true", help="print the mutants and run none")
    parser.add_argument("--verbose", action="store_true", help="say what became of each")
    parser.add_argument("--explained", action="store_true", help="run those that equivalent.txt explains as well")
    options = parser.parse_args()
    table, explanations = headers(), explained()
    if options.all == bool(options.header):
        fail("expected either a header or --all")
    if options.all:
        jobs = table
    elif options.list:
        jobs = {options.header: []}
    elif options.tests or options.header in table:
        jobs = {options.header: options.tests or table[options.header]}
    else:
        fail(f"headers.txt has no tests for {options.header}; name them")
    if options.list:
        for header in jobs:
            for mutant in chosen_mutants(header, (ROOT / "include" / header).read_text(), explanations, options):
                print_mutant(header, mutant, "explained" if (header, same(mutant[1]), same(mutant[2])) in explanations else "")
        return 0
    total = Score()
    for header, tests in jobs.items():
        total += examine(header, tests, explanations, options)
    if options.all:
        print(f"total: {total}.")
    enough = total.dead >= 0.95 * (total.dead + total.known + total.alive)
    return 0 if total.alive == 0 and (enough or not options.all) else 1


if __name__ == "__main__":
    sys.exit(main())
