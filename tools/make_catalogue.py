#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The functions by name, from the facade, the doors and the rooms:

   python3 tools/make_catalogue.py [FOLDER]   writes furiko_catalogue_entries.inc and furiko_by_name_cases.inc
                                              into src/catalogue or FOLDER; .ci/run compares

Taken is every public generic of real numbers only. Its arguments' names are those of its first specific; the form
of the modulus is in the function's name. A result's symbol is the one word of the docstring above its declaration,
or else its name; what the function is, the beginning of its docstring; both as of the function of the modulus k.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).parent.parent
SRC = ROOT / "src"
PROCEDURE = re.compile(r"\s*(?:(?:pure|elemental) )*(function|subroutine) (\w+)\(([^)]*)\)(?: result\((\w+)\))?")
DECLARED = re.compile(r"\s*real\(wp\)(?:, intent\((in|out)\))? :: (.*)")
FORM = re.compile(r"(.*)_(k|mc?|alpha)$")
# Where a docstring goes on to the arguments, the definition or the range
ABOUT_ENDS = re.compile(r":|;|  | \$\$|\.(?: |$)|,? of (?:the (?:modulus|angle|amplitude phi|characteristic)|u) |, DLMF|"
                        r", principal|, `|, T_h|, \[\[")


def lines_of(path):
    """Of a source, its includes in their places, continued lines joined"""
    text = re.sub(r"^ *include '(.*)'$", lambda found: "\n".join(lines_of(path.parent / found[1])),
                  path.read_text(), flags=re.M)
    return re.sub(r" *&\n *(?:& *)?", " ", text).split("\n")


def module_lines(name):
    """Of the module in real64"""
    lines = lines_of(next(SRC.glob(f"*/{name}.[fF]90")))
    for kind in ("_dp", ""):
        if f"module {name}{kind}" in lines:
            return lines[lines.index(f"module {name}{kind}"):lines.index(f"end module {name}{kind}")]
    raise SystemExit(f"make_catalogue: no module {name}")


def specifics(name, lines):
    """Of all interfaces of this name"""
    rows = [row for number, line in enumerate(lines) if line == f"   interface {name}"
            for row in lines[number + 1:lines.index(f"   end interface {name}", number)]]
    return [specific.strip() for row in rows for specific in re.sub(r".*procedure *(:: *)?", "", row).split(",")]


def generics(lines):
    """Names of the interfaces with their docstrings and specifics"""
    doc = []
    for number, line in enumerate(lines):
        words = line.split()
        if line.strip().startswith("!>"):
            doc.append(line.strip()[2:].strip())
            continue
        if words[:1] == ["interface"] and len(words) == 2 and doc:
            yield words[1], " ".join(doc), specifics(words[1], lines)
        doc = []


def specific_lines(name, lines):
    """From a procedure's head on, in this module or in one that it uses"""
    for number, line in enumerate(lines):
        found = PROCEDURE.match(line)
        if found and found[2] == name:
            return lines[number:]
    for line in lines:
        used = re.match(rf"\s*use (furiko_\w+)_dp, only :.*\b{name}\b", line)
        if used:
            return specific_lines(name, module_lines(used[1]))
    return None


def signature(name, lines):
    """Arguments and results, or None where there are others than scalar reals: names, then symbols"""
    body = specific_lines(name, lines)
    if not body:
        return None
    _, name, dummies, result = PROCEDURE.match(body[0]).groups()
    dummies = [dummy.strip() for dummy in dummies.split(",")]
    symbols, above = {"in": {}, "out": {}}, ""
    for line in body[1:]:
        if line.strip().startswith("end "):
            break
        found = DECLARED.match(line)
        for variable in found[2].split(", ") if found else ():
            if variable in dummies or variable == (result or name):
                intent = found[1] or "out"
                word = re.fullmatch(r"!> (\S+)", above.strip())
                taken = word and (intent == "out" or word[1].lower() == variable)
                symbols[intent][variable] = word[1] if taken else variable
        above = line
    if set(dummies) - set(symbols["in"]) - set(symbols["out"]) or not symbols["out"]:
        return None
    return list(symbols["in"].values()), list(symbols["out"].values())


def takes_arrays(name, lines):
    """Whether a specific is no elemental procedure, and of arrays only"""
    for specific in specifics(name, lines):
        body = specific_lines(specific, lines)
        if not body or "elemental" in body[0]:
            continue
        dummies = PROCEDURE.match(body[0])[3].split(", ")
        declared = "\n".join(body[1:2*len(dummies) + 4])
        if all(re.search(rf"\b{dummy}\(:\)|dimension\(:\).*\b{dummy}\b", declared) for dummy in dummies):
            return True
    return False


def topics():
    """Of the modules that have some: name, arguments, results, what it is"""
    found, by_module = {}, {}
    for module in re.findall(r"^   use (furiko_\w+)", (SRC / "furiko.F90").read_text(), re.M):
        lines = module_lines(module)
        for name, doc, procedures in generics(lines):
            taken = signature(procedures[0], lines)
            if not taken:
                continue
            arguments, results = taken
            form = FORM.match(name)
            if form:
                arguments[-1] = form[2]
            about = re.sub(r"\[\[|\]\]", "", ABOUT_ENDS.split(doc)[0])
            if form and form[2] != "k":
                _, _, results, about = found[f"{form[1]}_k"]
            found[name] = name, arguments, results, about
            by_module.setdefault(module, []).append(found[name])
    return {module: together(found) for module, found in by_module.items()}


def together(found):
    """Those of one name in several forms beside each other"""
    stems = [FORM.sub(r"\1", name) for name, *_ in found]
    return [entry for _, entry in sorted(zip(map(stems.index, stems), found), key=lambda pair: pair[0])]


def entries():
    """Those of all modules"""
    return [entry for found in topics().values() for entry in found]


def quoted(text):
    return "'" + text.replace("'", "''") + "'"


def write_entries(found):
    yield "   ! Written by tools/make_catalogue.py."
    yield "   !> Angles (phi, alpha, amplitude) are in radians; n is the third kind's characteristic, in DLMF's sign."
    yield "   type(catalogue_entry), parameter :: catalogue(*) = [ &"
    for number, (name, arguments, results, about) in enumerate(found, 1):
        entry = f"      catalogue_entry({quoted(name)}, {quoted(' '.join(arguments))}, {quoted(' '.join(results))}, "
        rest = f"{quoted(about)}){', &' if number < len(found) else ']'}"
        # Of 255 continued lines, which is the standard's limit, one each where it fits
        yield entry + rest if len(entry + rest) <= 110 else f"{entry}&\n         {rest}"


def write_cases(found):
    yield "   ! Written by tools/make_catalogue.py. The functions by their names: arguments a, b, c, d, results u, v, w."
    yield "   ! Included for scalars and for arrays."
    yield from ("   u = 0", "   v = 0", "   w = 0", "   select case (name)")
    for name, arguments, results, _ in found:
        passed = ", ".join("abcd"[:len(arguments)])
        yield f"   case ('{name}')"
        if len(results) == 1:
            yield f"      u = {name}({passed})"
        else:
            yield f"      call {name}({passed}, {', '.join('uvw'[:len(results)])})"
    yield from ("   case default", "      u = nan", "   end select")


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else SRC / "catalogue"
    found = entries()
    (folder / "furiko_catalogue_entries.inc").write_text("\n".join(write_entries(found)) + "\n")
    (folder / "furiko_by_name_cases.inc").write_text("\n".join(write_cases(found)) + "\n")
