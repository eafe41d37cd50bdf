#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The house drawn from its own code, and whether its arrows run downwards:

   python3 tools/make_map.py            writes doc/map.svg (needs Graphviz)
   python3 tools/make_map.py --check    no arrow upwards, no circle, and doc/map.svg is of this code

A room is a source file. An arrow is a `use`, or an `include` of another folder's text.
"""
import hashlib
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).parent.parent
MAP = ROOT / "doc" / "map.svg"
# From the foundation up: a folder may use itself and those before it.
STOREYS = {"arithmetic": "pairs and triples of numbers, bits, sine and cosine of large angles",
           "integrals": "Legendre's and Carlson's, the arithmetic-geometric mean",
           "functions": "nome, theta, Jacobi's functions and their inverses, zeta",
           "pendulum": "its period and its exact motion",
           "integrators": "equations of motion step by step",
           "driven": "driven, damped pendulums, many at once",
           "classics": "the lecture notes' own ways, the ellipse",
           "selftest": "known values",
           "src": "what a program uses",
           "catalogue": "functions by name",
           "c": "what a C program calls",
           "f77": "what Fortran 77 calls",
           "app": "the program"}
USE = re.compile(r"^ *use (furiko\w*)", re.M)
INCLUDE = re.compile(r"""^#? *include ['"](?:\.\./)?(\w+)/furiko_\w+\.inc""", re.M)
MODULE = re.compile(r"^ *(?:module|program) (?!procedure\b|subroutine\b|function\b)(\w+)", re.M)


class House:
    """Rooms by folder, and who uses whom"""

    def __init__(self, root):
        doors = sorted([*root.glob("src/*.[fF]90"), *root.glob("src/*/*.[fF]90"), *root.glob("app/*.[fF]90")])
        text = {path: path.read_text() for path in doors}
        self.folder = {path.stem: path.parent.name for path in doors}
        home = {module: path.stem for path in doors for module in MODULE.findall(text[path])}
        self.uses = {path.stem: sorted({home[name] for name in USE.findall(text[path])} - {path.stem}) for path in doors}
        # Texts of arithmetic that no module holds are in other folders for inlining.
        self.includes = sorted({(path.parent.name, folder) for path in [*doors, *root.glob("src/*/*.inc"), *root.glob("app/*.inc")]
                                for folder in INCLUDE.findall(path.read_text()) if folder != path.parent.name})

    def faults(self):
        """Arrows upwards, and circles"""
        height = {folder: i for i, folder in enumerate(STOREYS)}
        found = [f"{folder} is no folder of the house" for folder in sorted(set(self.folder.values()) - set(STOREYS))]
        if found:
            return found
        found += [f"{room} ({self.folder[room]}) uses {other} ({self.folder[other]}) above it" for room in self.uses
                  for other in self.uses[room] if height[self.folder[other]] > height[self.folder[room]]]
        found += [f"{below} includes a text of {above} above it" for below, above in self.includes if height[above] > height[below]]
        left = {room: set(others) for room, others in self.uses.items()}
        # Whoever uses none, or is used by none, of those that are left
        while free := {room for room, others in left.items() if not others} | (set(left) - set().union(*left.values())):
            left = {room: others - free for room, others in left.items() if room not in free}
        return found + ([f"a circle among {', '.join(sorted(left))}"] if left else [])

    def dot(self):
        """For Graphviz: a box a folder; of arrows, those that no longer way stands for"""
        lines = ["digraph furiko {", "rankdir=TB; ranksep=0.5; nodesep=0.12; compound=true;",
                 'node [shape=box, style="rounded,filled", fillcolor=white, color="#888888", fontname="Helvetica", fontsize=11, height=0.3];',
                 'edge [color="#777777", arrowsize=0.6]; fontname="Helvetica";']
        for folder in STOREYS:
            rooms = [room for room in self.folder if self.folder[room] == folder]
            if folder == "app":
                continue
            lines.append(f'subgraph cluster_{folder} {{ label="{folder}/: {STOREYS[folder]}"; style="rounded,filled"; '
                         'fillcolor="#eef3f8"; color="#bbccdd"; fontsize=12;')
            lines += [f'{room} [label="{room.removeprefix("furiko_")}"];' for room in rooms]
            lines.append("}")
        shown = {room: others for room, others in self.uses.items() if self.folder[room] != "app"}
        far = {room: self.reach(others) for room, others in shown.items()}
        lines += [f"{room} -> {other};" for room, others in shown.items() for other in others if other not in far[room]]
        return "\n".join([*lines, "}", ""])

    def reach(self, rooms):
        """All that is used by these, at any distance"""
        seen, todo = set(), list(rooms)
        while todo:
            for other in self.uses[todo.pop()]:
                if other not in seen:
                    seen.add(other)
                    todo.append(other)
        return seen


def main():
    house = House(ROOT)
    dot = house.dot()
    mark = f"<!-- of {hashlib.sha256(dot.encode()).hexdigest()[:16]} by tools/make_map.py -->\n"
    if sys.argv[1:] == ["--check"]:
        faults = house.faults()
        if not MAP.exists() or not MAP.read_text().endswith(mark):
            faults.append("doc/map.svg is not of this code: python3 tools/make_map.py")
        print("\n".join(faults) or f"{len(house.uses)} rooms, {sum(map(len, house.uses.values()))} arrows, all downwards")
        return 1 if faults else 0
    svg = subprocess.run(["dot", "-Tsvg"], input=dot, capture_output=True, text=True, check=True).stdout
    MAP.write_text(svg + mark)
    return 0


if __name__ == "__main__":
    sys.exit(main())
