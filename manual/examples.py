#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""doc/examples.md, one line an example: python3 manual/examples.py [--check]

The line is the docstring of the file. An example has no more than 20 lines of code, blank ones, comments and the module
that a right-hand side takes apart; it prints what its comments promise, which the CI step `examples` compares.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).parent.parent
TOPICS = {"checking": "Before you begin", "integrals": "Elliptic integrals", "functions": "Elliptic functions",
          "pendulum": "The pendulum", "physics": "Elsewhere in physics", "integrators": "Integrators", "driven": "Driven pendulums",
          "notes": "The methods of the lecture notes"}
HEAD = """# Examples

<!-- Written by manual/examples.py -->

Each is a short program that prints something to check, with the output in its comments; CI runs them all and compares.
`./fpmw run --example NAME` runs one of them, for instance `./fpmw run --example motion`.
"""


def code_lines(text):
    program = text[text.index("\nprogram ") + 1:]
    return [line for line in program.split("\n") if line.strip() and not line.strip().startswith("!")]


def page():
    yield HEAD
    loose = sorted((ROOT / "example").glob("*.f90"))
    folders = {folder: sorted((ROOT / "example" / folder).glob("*.f90")) for folder in TOPICS}
    for title, paths in [*((TOPICS[folder], paths) for folder, paths in folders.items()), ("More", loose)]:
        if paths:
            yield f"## {title}\n\n| example | what it shows |\n|---|---|"
            for path in paths:
                text = path.read_text()
                about = re.search(r"((?:^!>.*\n)+)", text, re.M)
                if not about or len(code_lines(text)) > 20 or "! =>" not in text:
                    sys.exit(f"{path}: an example has a docstring, no more than 20 lines of code, and promises its output")
                line = " ".join(row[2:].strip() for row in about[1].split("\n")).strip().replace("|", "\\|")
                yield f"| [{path.stem}](../{path.relative_to(ROOT)}) | {line} |"
            yield ""


def main():
    new, path = "\n".join(page()).rstrip() + "\n", ROOT / "doc/examples.md"
    if "--check" in sys.argv:
        sys.exit(path.read_text() != new and "doc/examples.md: not what example/ has; run manual/examples.py")
    path.write_text(new)


main()
