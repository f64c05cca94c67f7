#!/usr/bin/env python3
"""Writes docs/api.md: every public name with its header, from Doxygen's XML of include/rme. With --check it compares.

    python3 tests/docs/api.py XML_DIR docs/api.md [--check]
"""
import collections
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

HEAD = """# Every public name, with its header

The target `docs_api` writes this page from the headers, and the ctest `docs.api` compares them. The manual, target
`docs_html`, has all of it with parameters, units and frames.

From version 1.0 on, what stands under "Frozen" changes only with a major release, in name, meaning and order of arguments.
A minor release may add names, fields and enumerators. Numbers that an estimator finds are no part of the promise: a release
may estimate better. What is in `rme::detail`, and what stands under "Parts of the estimator", may change with every release.
"""
# The parts of the estimator; but these are in its settings, its input or its state.
PARTS = "rme/tracking/"
FROZEN = {"rme/tracking/arm_prior.hpp", "rme/tracking/event_monitor.hpp", "rme/tracking/inertial_parameters.hpp",
          "rme/tracking/mode.hpp"}
KINDS = {"class": "class", "struct": "struct", "function": "function", "enum": "enum", "typedef": "type", "variable": "constant",
         "define": "macro"}


def text(node):
    return " ".join("".join(node.itertext()).split()) if node is not None else ""


def cell(words):
    return words.replace("|", "\\|")


def unique(names):
    return list(dict.fromkeys(names))


def members(compound):
    """Public names of a class, in the order of its header."""
    own = text(compound.find("compoundname")).split("::")[-1].split("<")[0].strip()
    found = []
    for member in compound.iter("memberdef"):
        name = text(member.find("name"))
        if member.get("prot") == "public" and name != own and not name.startswith("~"):
            found.append((int(member.find("location").get("line")), name))
    return unique(name for _, name in sorted(found))


def rows(folder):
    """{header: [(line, name, kind, members, summary)]}"""
    out = collections.defaultdict(list)
    for file in sorted(folder.glob("*.xml")):
        if file.name in ("index.xml", "Doxyfile.xml"):
            continue
        compound = ElementTree.parse(file).getroot().find("compounddef")
        kind, name = compound.get("kind"), text(compound.find("compoundname"))
        if kind in ("class", "struct"):
            place = compound.find("location")
            nested = name.removeprefix("rme::")
            if compound.get("prot", "public") != "public" or "detail::" in nested or "<" in nested:
                continue  # private, or a specialisation
            out[place.get("file")].append((int(place.get("line")), nested, KINDS[kind], members(compound),
                                           text(compound.find("briefdescription"))))
        elif kind == "file" or (kind == "namespace" and name == "rme"):
            for member in compound.iter("memberdef"):
                if kind == "file" and member.get("kind") != "define":
                    continue
                place = member.find("location")
                values = [text(value.find("name")) for value in member.iter("enumvalue")]
                out[place.get("file")].append((int(place.get("line")), text(member.find("name")), KINDS[member.get("kind")],
                                               values, text(member.find("briefdescription"))))
    return out


def table(header, entries):
    lines = [f"### `{header}`", "", "| name | kind | what |", "|---|---|---|"]
    seen = set()
    for _, name, kind, inner, summary in sorted(entries):
        if (name, kind) in seen:  # an overload
            continue
        seen.add((name, kind))
        summary = summary[:-1] + "." if summary.endswith(":") else summary
        shown = f" Has {', '.join(f'`{n}`' for n in inner)}." if inner else ""
        lines.append(f"| `{name}` | {kind} | {cell(summary + shown)} |")
    return lines + [""]


def page(folder):
    found = rows(folder)
    part = {header for header in found if header.startswith(PARTS) and header not in FROZEN}
    lines = [HEAD, "## Frozen", ""]
    for header in sorted(set(found) - part, key=lambda h: (h.count("/") > 1, h)):
        lines += table(header, found[header])
    lines += ["## Parts of the estimator", ""]
    for header in sorted(part):
        lines += table(header, found[header])
    return "\n".join(lines).rstrip("\n") + "\n"


def main():
    xml, target = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    new = page(xml)
    if "--check" not in sys.argv[3:]:
        target.write_text(new, encoding="utf-8")
    elif not target.exists() or target.read_text(encoding="utf-8") != new:
        sys.exit(f"{target} differs from the headers: build the target docs_api")


if __name__ == "__main__":
    main()
