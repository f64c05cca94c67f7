#!/usr/bin/env python3
"""Every figure of README.md, a number with a unit, stands in a table or a paragraph that a command writes, or is given.

    <!-- figure: 26 g, 1 g <- results.md: TEXT -->   TEXT is in docs/results.md, and has numbers that round to these
    <!-- given: 1.1 kg -->                           a setting of an experiment, not a result

    python3 tests/docs/figures.py ROOT
"""
import pathlib
import re
import sys

UNIT = r"(kg|g|mm|ms|us|kB|N m|N|rad/s|%)(?![\w/])"
NUMBER = r"\d+(?:\.\d+)?"
# "26 g", "0.04 to 0.58 kg", "6.8 instead of 7.6 g"
FIGURE = re.compile(rf"({NUMBER})(?: (?:to|and|or|instead of) ({NUMBER}))? {UNIT}")


def figures_of(text):
    """[(number as written, unit)]"""
    return [(n, m.group(3)) for m in FIGURE.finditer(text) for n in m.groups()[:2] if n]


def rounds_to(number, shown):
    """Whether a number, in the same unit or in one a thousand times as large or small, is `shown` after rounding."""
    half = 0.5 * 10.0 ** -len(shown.partition(".")[2]) * (1 + 1e-9)
    return any(abs(scale * number - float(shown)) <= half for scale in (1, 1000, 0.001))


def problems(root):
    readme = (root / "README.md").read_text(encoding="utf-8")
    allowed = set()
    for comment in re.findall(r"<!-- given: (.*?) -->", readme):
        allowed.update(figures_of(comment))
    sources = re.findall(r"<!-- figure: (.*?) <- (\S+): (.*?) -->", readme)
    if not sources:
        yield "README.md says of no figure where it is from"
    for shown, page, text in sources:
        if " ".join(text.split()) not in " ".join((root / "docs" / page).read_text(encoding="utf-8").split()):
            yield f'docs/{page} has no "{text}", from which README.md takes {shown}'
        numbers = [float(n) for n in re.findall(NUMBER, text)]
        for figure, unit in figures_of(shown):
            if not any(rounds_to(n, figure) for n in numbers):
                yield f'README.md takes {figure} {unit} from "{text}", which has no such number'
            allowed.add((figure, unit))
    prose = re.sub(r"<!--.*?-->|```.*?```|^    .*?$|`[^`]*`", " ", readme, flags=re.DOTALL | re.MULTILINE)
    for figure in sorted(set(figures_of(" ".join(prose.split()))) - allowed):
        yield f"README.md: {figure[0]} {figure[1]} is in no comment that says where it is from"


def main():
    found = list(problems(pathlib.Path(sys.argv[1])))
    sys.exit("\n".join(found) or 0)


if __name__ == "__main__":
    main()
