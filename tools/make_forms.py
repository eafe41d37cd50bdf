#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The names of the other forms of a modulus, from those of the modulus k itself:

   python3 tools/make_forms.py [FOLDER]    writes src/*/furiko_<topic>_forms.inc, or all of them into FOLDER;
                                           .ci/run compares

A room that includes such a file has each public generic `name_k` with its docstring and its specifics. What is
written are the same generics for the other forms that its door uses of furiko_forms: `name_m`, `name_mc` and, where
the door has it, `name_alpha`, each "As [[name_k]], ...".
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).parent.parent
# The argument in words, in the docstring of the name and of the dummy argument, and the range that `abs(k) <= 1` is
FORMS = {
    "m": ("the parameter m = k^2", "Parameter m = k^2", "`m <= 1`"),
    "mc": ("the complementary parameter mc = 1 - m", "Complementary parameter 1 - m", "`mc >= 0`"),
    "alpha": ("the modular angle alpha in radians, k = sin(alpha)", "Modular angle in radians", "`abs(alpha) <= pi/2`"),
}
RANGE = "`abs(k) <= 1`"
INTERFACE = re.compile(r"((?:   !>.*\n)+)   interface (\w+)_k\n((?:.*\n)+?)   end interface \w+\n")
# What a specific calls by the form in its name
CALLED = re.compile(r"\b(by|modulus_from|complement_of)_k\b")


def other(name, form):
    """A specific's name, its last k replaced"""
    before, after = name.rsplit("_k", 1)
    return f"{before}_{form}{after}"


def procedure(name, form, room):
    """A specific of another form"""
    text = re.search(rf"^   (?:\w+ )+{name}\((?:.*\n)+?   end \w+ {name}\n", room, re.M)[0]
    dummies = re.search(rf"{name}\(([^)]*)\)", text)[1].split(", ")
    _, words, bounds = FORMS[form]
    text = text.replace("!> Modulus", f"!> {words}").replace(RANGE, bounds)
    text = re.sub(rf"\b{name}\b", other(name, form), CALLED.sub(rf"\1_{form}", text))
    lines = text.split("\n")
    argument = "modulus" if "modulus" in dummies else "k"
    return "\n".join(line if "!>" in line else re.sub(rf"\b{argument}\b", form, line) for line in lines)


def written(room, forms):
    """What the room includes"""
    found = INTERFACE.findall(room)
    yield "   ! Written by tools/make_forms.py: the names of the other forms, after those of the modulus k."
    for _, stem, _ in found:
        yield "   public :: " + ", ".join(f"{stem}_{form}" for form in forms)
    for doc, stem, specifics in found:
        for form in forms:
            words, _, bounds = FORMS[form]
            yield ""
            yield f"   !> As [[{stem}_k]], of {words}{f', {bounds}' if RANGE in doc else ''}"
            yield f"   interface {stem}_{form}"
            yield re.sub(r"\w+$", lambda name: other(name[0], form), specifics, flags=re.M).rstrip("\n")
            yield f"   end interface {stem}_{form}"
    yield from ("", "", "contains")
    for _, _, specifics in found:
        for form in forms:
            for name in re.findall(r"\w+$", specifics, re.M):
                yield from ("", "", procedure(name, form, room).rstrip("\n"))


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else None
    for path in sorted(ROOT.glob("src/*/*.inc")):
        room = path.read_text()
        if f"include '{path.stem}_forms.inc'" in room:
            used = re.findall(r"use furiko_forms, only : (.*)", path.with_suffix(".F90").read_text())
            forms = [form for form in FORMS if f"by_{form}" in ", ".join(used).split(", ")]
            target = (folder or path.parent) / f"{path.stem}_forms.inc"
            target.write_text("\n".join(written(room, forms)) + "\n")


if __name__ == "__main__":
    main()
