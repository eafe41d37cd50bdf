#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The interface for C and C++, from the functions by name (make_catalogue.py) and tools/furiko.h.in:

   python3 tools/make_c_interface.py [FOLDER]   writes include/furiko.h, include/furiko.hpp, src/c/furiko_c.f90 and,
                                                of each module of the facade that has functions by name, the door
                                                src/c/furiko_c_<topic>.F90 and its room, of each object
                                                src/c/furiko_c_<object>_methods.inc, or all of them into FOLDER;
                                                .ci/run compares

What an object has is read from the prototypes in tools/furiko.h.in.
"""
import pathlib
import re
import sys

import make_catalogue

ROOT = make_catalogue.ROOT
WRITTEN = "Written by tools/make_c_interface.py."
# What the symbols of arguments mean, in words for the header
MEANINGS = {
    "k": "modulus, m = k^2",
    "m": "parameter, m = k^2",
    "mc": "complementary parameter 1 - m",
    "alpha": "modular angle in radians, k = sin(alpha)",
    "n": "characteristic, in DLMF's sign",
    "phi": "angle in radians",
    "u": "argument",
    "q": "nome",
    "big_k": "K, complete integral of the first kind",
    "s": "E(phi), incomplete integral of the second kind",
    "ratio": "T/T_h, period over that of small swings",
    "excess": "T/T_h - 1",
    "amplitude": "of the swing, in radians",
}
MEANINGS_OF = {
    "agm": {"a": "first number", "b": "second number"},
    "bulirsch_cel": {"kc": "complementary modulus", "p": "1 - n", "a": "weight of the squared cosine",
                     "b": "weight of the squared sine"},
    "ellipse_perimeter": {"a": "semiaxis", "b": "semiaxis"},
}
# Symbols that are no names in C, or not to be told from an argument's in Fortran
SYMBOLS = {"K": "big_k", "T/T_h": "ratio", "M": "mean", "Pi": "pi"}
OBJECTS = ["modulus", "motion"]
HEADINGS = {
    "agm": "Arithmetic-geometric mean",
    "complete": "Complete integrals K, E, B, D",
    "ellips": "The complete integral S",
    "incomplete": "Incomplete integrals F, E, D",
    "third_kind": "The third kind",
    "ellipj": "The associate integral of the third kind",
    "cel": "Bulirsch's cel",
    "carlson": "Carlson's integrals",
    "nome": "The nome",
    "theta": "Theta functions",
    "jacobi": "Jacobi elliptic functions",
    "jacobi_epsilon": "Jacobi's epsilon",
    "jacobi_inverse": "Inverses of Jacobi's functions",
    "inverse_period": "Inverses of K and of the period",
    "second_inverse": "The inverse of E(phi)",
    "jacobi_zeta": "Jacobi's zeta, Heuman's lambda",
    "period": "The pendulum's period",
    "series": "The pendulum's period by its series",
    "ellipse": "The ellipse",
}


def name_of(symbol):
    """As a name in C and in Fortran"""
    return re.sub(r"'", "_prime", SYMBOLS.get(symbol, symbol)).lower()


def names_of(symbols):
    return [name_of(symbol) for symbol in symbols]


def meaning(name, argument):
    return MEANINGS_OF.get(name, {}).get(argument) or MEANINGS.get(argument, "number")


# The Fortran side

def scalar_text(name, arguments, results):
    label = f"bind(c, name='furiko_{name}' // suffix)"
    given = ", ".join(arguments)
    if len(results) == 1:
        yield f"   pure function c_{name}({given}) result(f) &"
        yield f"      {label}"
        yield f"      real(wp), intent(in), value :: {given}"
        yield from ("      real(wp) :: f", "", f"      f = {name}({given})", f"   end function c_{name}")
    else:
        out = ", ".join(results)
        yield f"   pure subroutine c_{name}({given}, {out}) &"
        yield f"      {label}"
        yield f"      real(wp), intent(in), value :: {given}"
        yield f"      real(wp), intent(out) :: {out}"
        yield from ("", f"      call {name}({given}, {out})", f"   end subroutine c_{name}")


def array_text(name, arguments, results, batches):
    """One by one, or in batches, since kernels of arrays count by default integers"""
    label = f"bind(c, name='furiko_{name}_v' // suffix)"
    out = results if len(results) > 1 else ["f"]
    given = ", ".join(arguments)
    yield f"   pure subroutine c_{name}_v(count, {given}, {', '.join(out)}) &"
    yield f"      {label}"
    yield "      integer(c_size_t), intent(in), value :: count"
    yield f"      real(wp), dimension(count), intent(in) :: {given}"
    yield f"      real(wp), dimension(count), intent(out) :: {', '.join(out)}"
    if batches:
        at = "(first:last)"
        yield from ("      integer(c_size_t) :: first, last", "")
        yield from ("      do first = 1, count, most", "         last = min(first + most - 1, count)")
    else:
        at = "(i)"
        yield from ("      integer(c_size_t) :: i", "", "      do i = 1, count")
    given = ", ".join(argument + at for argument in arguments)
    if len(results) == 1:
        yield f"         f{at} = {name}({given})"
    else:
        yield f"         call {name}({given}, {', '.join(result + at for result in results)})"
    yield from ("      end do", f"   end subroutine c_{name}_v")


def write_room(entries, lines):
    batched = {entry[0] for entry in entries if make_catalogue.takes_arrays(entry[0], lines)}
    yield f"   ! {WRITTEN} Functions for C: one by one, and arrays."
    if batched:
        yield "   ! How many of an array are worked on at once"
        yield "   integer(c_size_t), parameter :: most = 4096"
    yield from ("", "", "contains")
    for name, symbols, symbols_out, _ in entries:
        arguments, results = names_of(symbols), names_of(symbols_out)
        yield from ("", "", *scalar_text(name, arguments, results))
        yield from ("", "", *array_text(name, arguments, results, name in batched))


def write_door(topic, entries, stamp):
    yield "! SPDX-License-Identifier: MIT"
    yield '#include "../arithmetic/furiko_compiler.inc"'
    yield ""
    yield f"! {WRITTEN}"
    # A C name that is that of the facade's module, of which no C program knows
    clash = topic in [name for name, *_ in entries]
    if clash:
        yield "! The kinds' modules are used, since a compiler objects that sees C's name and the module's in one file."
    for kind, c_type, words, suffix in (("sp", "c_float", "float", "f"), ("dp", "c_double", "double", "")):
        yield from ("", *([""] if kind == "dp" else []))
        yield f"!> {HEADINGS[topic]}, for C, in {words}; the text is in furiko_c_{topic}.inc."
        yield f"module furiko_c_{topic}_{kind}"
        yield f"   use, intrinsic :: iso_c_binding, only : c_size_t, wp => {c_type}"
        yield "   ! allow(C121)"
        yield f"   use furiko_{topic}{f'_{kind}' if clash else ''} ! all there is"
        yield from ("   implicit none", "   private", "   ! What C's names end in")
        yield f"   character(len=*), parameter :: suffix = '{suffix}'"
        yield f"   include 'furiko_c_{topic}.inc'"
        yield f"end module furiko_c_{topic}_{kind}"
    yield stamp


def methods(name, template):
    """Prototypes of an object's functions of at most one number: result, name, the number, whether of an array"""
    self = rf"const furiko_{name} \*self"
    for line in template.split("\n"):
        found = re.match(rf"(double|int) furiko_{name}_(\w+)\({self}(?:, double (\w+))?\);", line)
        if found:
            yield (*found.groups(), False)
        found = re.match(rf"void furiko_{name}_(\w+)_v\({self}, size_t count, const double (\w+)\[\], double \w+\[\]\);", line)
        if found:
            yield ("double", *found.groups(), True)


def method_text(object_name, result, name, number, many):
    label = f"bind(c, name='furiko_{object_name}_{name}{'_v' if many else ''}')"
    given = f", {number}" if number else ""
    if many:
        yield f"   pure subroutine c_{name}_v(self, count, {number}, f) {label}"
    else:
        yield f"   pure function c_{name}(self{given}) result(f) {label}"
    yield "      type(c_object), intent(in) :: self"
    if many:
        yield "      integer(c_size_t), intent(in), value :: count"
        yield f"      real(wp), intent(in) :: {number}(count)"
        yield "      real(wp), intent(out) :: f(count)"
    else:
        if number:
            yield f"      real(wp), intent(in), value :: {number}"
        yield f"      {'integer(c_int)' if result == 'int' else 'real(wp)'} :: f"
    yield "      type(object) :: p"
    if many:
        yield "      integer(c_size_t) :: first, last"
    yield from ("", "      p = stored(self)")
    if many:
        yield "      do first = 1, count, most"
        yield "         last = min(first + most - 1, count)"
        yield f"         f(first:last) = p%{name}({number}(first:last))"
        yield from ("      end do", f"   end subroutine c_{name}_v")
    else:
        value = f"p%{name}({number or ''})"
        yield f"      f = {f'merge(1_c_int, 0_c_int, {value})' if result == 'int' else value}"
        yield f"   end function c_{name}"


def write_methods(name):
    yield f"   ! {WRITTEN} What C asks of the object."
    for method in methods(name, (ROOT / "tools/furiko.h.in").read_text()):
        yield from ("", "", *method_text(name, *method))


def write_all(topics):
    """A module that uses all that is called from C, the hand-written doors too"""
    used = [f"furiko_c_{topic}_{kind}" for topic in topics for kind in ("sp", "dp")]
    for door in (ROOT / "src/c").glob("*.F90"):
        used += re.findall(r"^module (\w+)", door.read_text(), re.M)
    yield "! SPDX-License-Identifier: MIT"
    yield ""
    yield f"! {WRITTEN}"
    yield ""
    yield "!> All that C calls: for fpm, which leaves out of a library the modules that no program uses. Fortran finds"
    yield "!> nothing here."
    yield "! allow(C121)"
    yield "module furiko_c"
    yield from (f"   use {module}" for module in sorted(set(used)))
    yield from ("   implicit none", "   private", "end module furiko_c")


# The headers

def prototypes(name, arguments, results):
    """Of the four: double, float, arrays of both"""
    for kind, letter in (("double", ""), ("float", "f")):
        given = [f"{kind} {argument}" for argument in arguments]
        if len(results) == 1:
            yield f"{kind} furiko_{name}{letter}({', '.join(given)});"
        else:
            yield f"void furiko_{name}{letter}({', '.join(given + [f'{kind} *{result}' for result in results])});"
    for kind, letter in (("double", ""), ("float", "f")):
        given = [f"const {kind} {argument}[]" for argument in arguments]
        out = [f"{kind} {result}[]" for result in results]
        yield f"void furiko_{name}_v{letter}({', '.join(['size_t count', *given, *out])});"


def folded(line):
    """A prototype on lines of up to 110"""
    if len(line) <= 110:
        return [line]
    cut = line.rindex(", ", 0, 110) + 1
    return [line[:cut], *folded("        " + line[cut + 1:])]


def write_functions(topics):
    for topic, entries in topics.items():
        yield from ("", f"/* ---- {HEADINGS[topic]} ---- */")
        for name, symbols, results, about in entries:
            arguments = names_of(symbols)
            yield from ("", f"/** {about}.", " *")
            yield from (f" * @param {argument} {meaning(name, argument)}" for argument in arguments)
            yield " * @{ */"
            for line in prototypes(name, arguments, names_of(results)):
                yield from folded(line)
            yield "/** @} */"


def write_overloads(topics):
    """Of furiko.hpp: one name for double and float, and for arrays"""
    for topic, entries in topics.items():
        yield from ("", f"/* ---- {HEADINGS[topic]} ---- */")
        for name, symbols, symbols_out, about in entries:
            arguments, results = names_of(symbols), names_of(symbols_out)
            passed = ", ".join(arguments)
            yield from ("", f"/** {about}. @{{ */")
            for kind, letter in (("double", ""), ("float", "f")):
                given = ", ".join(f"{kind} {argument}" for argument in arguments)
                if len(results) == 1:
                    yield f"inline {kind} {name}({given}) {{ return furiko_{name}{letter}({passed}); }}"
                else:
                    yield f"inline void {name}({given}, {', '.join(f'{kind} &{result}' for result in results)}) {{"
                    yield f"    furiko_{name}{letter}({passed}, {', '.join('&' + result for result in results)});"
                    yield "}"
                given = ", ".join(f"const {kind} {argument}[]" for argument in arguments)
                out = ", ".join(f"{kind} {result}[]" for result in results)
                yield from folded(f"inline void {name}(std::size_t count, {given}, {out}) {{")
                yield f"    furiko_{name}_v{letter}(count, {passed}, {', '.join(results)});"
                yield "}"
            yield "/** @} */"


def filled(template, topics):
    """A template of tools/ with the functions and the version in their places"""
    version = re.search(r"furiko_version = '(\d+)\.(\d+)\.(\d+)'", (ROOT / "src/furiko.F90").read_text())
    text = (ROOT / "tools" / template).read_text()
    for mark, value in (("@WRITTEN@", WRITTEN), ("@MAJOR@", version[1]), ("@MINOR@", version[2]), ("@PATCH@", version[3]),
                        ("@FUNCTIONS@", "\n".join(write_functions(topics)).strip()),
                        ("@OVERLOADS@", "\n".join(write_overloads(topics)).strip())):
        text = text.replace(mark, value)
    return text


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else None
    topics = {module.removeprefix("furiko_"): found for module, found in make_catalogue.topics().items()}
    doors = ROOT / "src/c"
    written = {"furiko_c.f90": write_all(topics)}
    for topic, entries in topics.items():
        name = f"furiko_c_{topic}"
        door = doors / f"{name}.F90"
        # The sum over the rooms is not ours, but tools/stamp's
        stamp = door.read_text().splitlines()[-1] if door.exists() else "! rooms: 0"
        written[door.name] = write_door(topic, entries, stamp)
        written[f"{name}.inc"] = write_room(entries, make_catalogue.module_lines(f"furiko_{topic}"))
    for name in OBJECTS:
        written[f"furiko_c_{name}_methods.inc"] = write_methods(name)
    for name, lines in written.items():
        ((folder or doors) / name).write_text("\n".join(lines) + "\n")
    for header in ("furiko.h", "furiko.hpp"):
        ((folder or ROOT / "include") / header).write_text(filled(f"{header}.in", topics))


if __name__ == "__main__":
    main()
