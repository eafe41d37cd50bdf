#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The functions as externals for Fortran 77, from the functions by name (make_catalogue.py) and the short names below:

   python3 tools/make_f77.py [FOLDER]   writes src/f77/furiko_f77_*.inc, include/furiko_f77.inc and the table of names in
                                        doc/f77.md, or all of them into FOLDER; .ci/run compares

A room `furiko_f77_TOPIC.inc` has the DOUBLE PRECISION functions of a topic, `furiko_f77_TOPIC_real.inc` their REAL
twins; the door beside them includes both.
"""
import pathlib
import re
import sys

import make_catalogue
from make_c_interface import names_of

ROOT = make_catalogue.ROOT
WRITTEN = "Written by tools/make_f77.py."
# What follows FK, and in REAL FKS: by topic, for a function in all its forms or for one of them
STEMS = {
    "complete": {"agm": "AGM", "ellipk": "K", "ellipe": "E", "ellipb": "B", "ellipd": "D", "ellipke": "KE"},
    "incomplete": {"ellipf": "F", "ellipeinc": "EI", "ellipdinc": "DI", "ellippi": "P", "ellippiinc": "PI",
                   "ellipeinc_inverse": "IE", "ellips": "DB", "ellipj": "J", "ellipjinc": "JI"},
    "carlson": {"carlson_rf": "RF", "carlson_rc": "RC", "carlson_rd": "RD", "carlson_rj": "RJ", "carlson_rg": "RG",
                "bulirsch_cel": "CEL"},
    "jacobi": {"jacobi_k": "JAC", "jacobi_m": "JCM", "jacobi_mc": "JCC", "jacobi_am": "AM", "jacobi_epsilon": "EP",
               "jacobi_zeta": "Z", "heuman_lambda": "L", "jacobi_arcsn": "AS", "jacobi_arccn": "AC", "jacobi_arcdn": "AD"},
    "nome": {"nome": "Q", "theta1": "T1", "theta2": "T2", "theta3": "T3", "theta4": "T4", "theta1_prime": "T1P",
             "theta2_prime": "T2P", "theta3_prime": "T3P", "theta4_prime": "T4P", "parameter_from_nome": "IQM",
             "complementary_parameter_from_nome": "IQC", "parameter_from_ellipk": "IKM",
             "complementary_parameter_from_ellipk": "IKC"},
    "period": {"period_ratio": "PER", "period_excess": "PEX", "amplitude_of_period": "IPA", "amplitude_of_excess": "IXA",
               "parameter_from_period_ratio": "IPM", "complementary_parameter_from_period_ratio": "IPC",
               "ellipse_perimeter": "ELL"},
}
LETTERS = {"k": "", "m": "M", "mc": "C", "alpha": "A"}
# Quotients of what FKJAC gives, and their inverses; three terms of a series
LEFT_OUT = re.compile(r"jacobi_(arc)?(sn|cn|dn|ns|nc|nd|sc|cs|sd|ds|cd|dc)_(k|mc?)|amplitude_three_terms")
# Of those written by hand, in src/f77/
BY_HAND = ["MSET", "MSEM", "MSEC", "MSEA", "MGET", "MJAC", "MAM", "MEP", "PSET", "PGET", "PANG", "PRAT", "PTEN", "PTIM",
           "RK4", "VERL", "FRUT", "TEST"]
# Arguments whose names would be integers in Fortran 77, or are too long for it
ARGUMENTS = {"k": "ak", "m": "am", "mc": "amc", "n": "en", "big_k": "ck", "e": "ce", "amplitude": "ampl"}


class Function:
    """A function under its short name"""

    def __init__(self, topic, stem, module, entry):
        self.topic, self.stem, self.module = topic, stem, module
        self.name, symbols, results, self.about = entry
        self.arguments, self.results = ([ARGUMENTS.get(name, name) for name in names_of(found)] for found in (symbols, results))

    def short(self, prefix="FK"):
        return prefix + self.stem

    def call(self, prefix="FK"):
        """As a caller writes it"""
        given = self.arguments if len(self.results) == 1 else self.arguments + self.results
        return f"{self.short(prefix)}({', '.join(given)})".upper()

    def text(self, prefix, kind):
        """The external procedure"""
        short, given = self.short(prefix).lower(), ", ".join(self.arguments)
        subroutine = len(self.results) > 1
        out = ", ".join(self.results)
        yield f"!> {self.about}" + ("" if len(self.about + self.name) > 90 else f": [[{self.name}]]")
        yield f"pure subroutine {short}({given}, {out})" if subroutine else f"pure {kind} function {short}({given})"
        yield f"   use furiko_f77_{self.topic}, only : {self.name}"
        yield "   implicit none"
        yield f"   {kind}, intent(in) :: {given}"
        if subroutine:
            yield from (f"   {kind}, intent(out) :: {out}", "", f"   call {self.name}({given}, {out})")
            yield f"end subroutine {short}"
        else:
            yield from ("", f"   {short} = {self.name}({given})", f"end function {short}")


def functions():
    """By topic, in the order of STEMS"""
    entries = {entry[0]: (module, entry) for module, found in make_catalogue.topics().items() for entry in found}
    by_topic = {}
    for topic, stems in STEMS.items():
        by_topic[topic] = taken = []
        for base, stem in stems.items():
            forms = {name: stem + LETTERS[found[1]] for name in entries
                     if (found := re.fullmatch(rf"{base}_(k|mc?|alpha)", name))}
            if base in entries:
                forms = {base: stem}
            taken += [Function(topic, letters, *entries[name]) for name, letters in forms.items()]
    check(entries, [function for taken in by_topic.values() for function in taken])
    return by_topic


def check(entries, taken):
    """Each function has a name, each name is of one function and has at most six letters, no REAL name is another's"""
    named = {function.name for function in taken}
    for name in set(entries) - named:
        if not LEFT_OUT.fullmatch(name):
            sys.exit(f"make_f77: no short name for {name}")
    names = [function.short(prefix) for function in taken for prefix in ("FK", "FKS")] + ["FK" + stem for stem in BY_HAND]
    for name in names:
        if names.count(name) > 1 or len(name) > 6:
            sys.exit(f"make_f77: {name} is there twice, or too long")
    for function in taken:
        door = (ROOT / f"src/f77/furiko_f77_{function.topic}.f90").read_text()
        if f"use {function.module}\n" not in door:
            sys.exit(f"make_f77: furiko_f77_{function.topic} does not use {function.module}")


def room(taken, prefix, kind):
    yield f"! {WRITTEN} For Fortran 77, {kind.upper()}; each calls the function that it names."
    for function in taken:
        yield from ("", "", *function.text(prefix, kind))


def declarations(by_topic):
    yield "! SPDX-License-Identifier: MIT"
    yield f"! {WRITTEN}"
    yield "! The types of furiko's functions, to be included into what calls them: INCLUDE 'furiko_f77.inc'"
    for taken in by_topic.values():
        of_values = [function for function in taken if len(function.results) == 1]
        for prefix, kind in (("FK", "DOUBLE PRECISION"), ("FKS", "REAL")):
            for start in range(0, len(of_values), 6):
                names = ", ".join(function.short(prefix) for function in of_values[start:start + 6])
                yield from (f"      {kind} {names}", f"      EXTERNAL {names}")


def table(by_topic):
    """Of doc/f77.md: a row a function, with its forms"""
    yield from ("| call | | in modern Fortran |", "|---|---|---|")
    for taken in by_topic.values():
        rows = {}
        for function in taken:
            found = make_catalogue.FORM.match(function.name)
            rows.setdefault(found[1] if found else function.name, []).append(function)
        for base, forms in rows.items():
            calls = ", ".join(f"`{function.call()}`" for function in forms)
            about = forms[0].about.replace("|", "\\|")
            yield f"| {calls} | {about} | `{base}{'_*' if len(forms) > 1 else ''}` |"


def page(by_topic):
    text = (ROOT / "doc/f77.md").read_text()
    begin, end = "<!-- names -->\n", "<!-- end of names -->"
    before, rest = text.split(begin)
    return before + begin + "\n".join(table(by_topic)) + "\n" + end + rest.split(end)[1]


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else None
    by_topic = functions()
    for topic, taken in by_topic.items():
        for prefix, kind, end in (("FK", "double precision", ""), ("FKS", "real", "_real")):
            path = (folder or ROOT / "src/f77") / f"furiko_f77_{topic}{end}.inc"
            path.write_text("\n".join(room(taken, prefix, kind)) + "\n")
    ((folder or ROOT / "include") / "furiko_f77.inc").write_text("\n".join(declarations(by_topic)) + "\n")
    ((folder or ROOT / "doc") / "f77.md").write_text(page(by_topic))


if __name__ == "__main__":
    main()
