#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The functions of the Python package, from the functions by name (make_catalogue.py) and their docstrings:

   python3 tools/make_python.py [FOLDER]   writes _functions.py and _version.py into python/src/furiko or FOLDER;
                                           .ci/run compares

Signatures are those of the C interface, which the package calls. A docstring is the Fortran generic's without what is
said of Fortran alone; one that points to another function's for range and accuracy is followed by that one's.
"""
import pathlib
import re
import sys
import textwrap

import make_c_interface
import make_catalogue

ROOT = make_catalogue.ROOT
# Of the module's lines, as python/pyproject.toml has it, and of docstrings
LINE = 120
WIDTH = 96
LICENCE = "# SPDX-License-Identifier: MIT\n# Written by tools/make_python.py.\n"
HEAD = LICENCE + '''\
"""The functions of the catalogue, each with what it is, its range, special values and accuracy."""

from typing import Any, NamedTuple

from numpy.typing import ArrayLike

from ._routine import Out, Outs, Routine
'''
# What the text says of Fortran alone: how arrays and complex numbers are given, real128, where the method is described
FORTRAN_ONLY = [
    (r": `call [^`]*`", ""),
    (r"u of rank 1 [^.]*\. ", ""),
    (r"u may be complex[^.]*\. ?", ""),
    (r"; of complex u [^.]*", ""),
    (r",? (?:and )?[\d.]+ ulp \(real128\)", ""),
    (r" \(real128: [^)]*\)", ""),
    (r"; [\d.]+ ulp in real128", ""),
    (r",? up to \d+ ms in real128", ""),
    (r"; in real128 [^.]*", ""),
    (r"\s*Method: .*?(?=Source: |Definition: |$)", "  "),
    (r"real(?=32|64)", "float"),
    (r"`wp`", "the kind"),
]
LABELS = r" (?=(?:Special cases|Accuracy|Source|Definition|Argument|Arguments):)"


def docstrings():
    """Of every generic of the facade's modules"""
    return {name: doc for module in make_catalogue.topics()
            for name, doc, _ in make_catalogue.generics(make_catalogue.module_lines(module))}


def resolved(name, about, docs):
    """The first paragraph, and all the rest: where the docstring has no range and accuracy, that of which it speaks"""
    first, _, rest = docs[name].partition("  ") if "  " in docs[name] else (docs[name], "", "")
    if "$$" in first:
        first, formula, more = first.partition("$$")
        rest = f"{formula}{more}  {rest}"
    other = re.search(r"see \[\[(\w+)\]\]", docs[name]) or re.search(r"\[\[(\w+)\]\]", docs[name])
    if not re.search(r"Accuracy|rror at most", docs[name]) and other and other[1] in docs:
        first = re.sub(r"^As \[\[\w+\]\]", about, first.split("; see [[")[0])
        rest = resolved(other[1], about, docs)[1]
    return first, rest


def paragraphs(name, about, docs):
    """A docstring's, wrapped"""
    first, rest = resolved(name, about, docs)
    first = first.strip()
    text = first + ("  " if rest.startswith("$$") and first[-1] in ":f" else ".  " if first[-1] != "." else "  ") + rest
    for pattern, replacement in FORTRAN_ONLY:
        text = re.sub(pattern, replacement, text)
    text = re.sub(r"\[\[(\w+)\]\]", r"\1", text)
    for number, part in enumerate(text.split("$$")):
        if number % 2:
            yield from (*textwrap.wrap(f".. math:: {part.strip()}", WIDTH, subsequent_indent="   ",
                                       break_long_words=False, break_on_hyphens=False), "")
            continue
        for paragraph in re.split(rf"  +|{LABELS}", part):
            if paragraph.strip(" ,."):
                yield from (*textwrap.wrap(paragraph.strip(), WIDTH, break_long_words=False), "")


def class_name(name):
    """Of a tuple of results, without the form of the modulus"""
    form = make_catalogue.FORM.match(name)
    return (form[1] if form else name).title().replace("_", "") + "Values"


def write_function(name, symbols, results, about, docs):
    arguments = make_c_interface.names_of(symbols)
    several = class_name(name) if len(results) > 1 else None
    yield f'_{name} = Routine("{name}", {tuple(arguments)!r}, {several})'.replace("'", '"')
    returned = several or "Any"
    outs = "Outs" if several else "Out"
    given = ", ".join(f"{argument}: ArrayLike" for argument in arguments)
    yield from ("", "")
    signature = f"def {name}({given}, *, out: {outs} = None) -> {returned}:"
    if len(signature) <= LINE:
        yield signature
    else:
        yield f"def {name}("
        yield f"    {given}, *, out: {outs} = None"
        yield f") -> {returned}:"
    lines = list(paragraphs(name, about, docs))
    yield f'    r"""{lines[0]}'
    lines = [*lines[1:], "Parameters", "----------"]
    for argument in arguments:
        lines += [f"{argument} : array_like", f"    {make_c_interface.meaning(name, argument)}"]
    lines += [f"out : {'tuple of ndarray' if several else 'ndarray'}, optional", "    where the result goes", "",
              "Returns", "-------"]
    if several:
        lines += [f"{several}", f"    {', '.join(results)}: each a float, or an array"]
    else:
        lines += ["float or ndarray", f"    {results[0]}"]
    for line in lines:
        yield f"    {line}".rstrip()
    yield '    """'
    floats = " and ".join(f"type({argument}) is float" for argument in arguments)
    passed = ", ".join(arguments)
    yield f"    if {floats} and out is None:"
    yield f"        return _{name}.one({passed})"
    yield f"    return _{name}(out, {passed})"
    yield from ("", "")


def write_module():
    docs, entries = docstrings(), make_catalogue.entries()
    yield HEAD
    yield "__all__ = ["
    yield from (f'    "{name}",' for name in sorted({class_name(e[0]) for e in entries if len(e[2]) > 1}) +
                [name for name, *_ in entries])
    yield from ("]", "", "")
    seen = set()
    for name, _, results, about in entries:
        if len(results) > 1 and class_name(name) not in seen:
            seen.add(class_name(name))
            yield f"class {class_name(name)}(NamedTuple):"
            yield f'    """{about}."""'
            yield ""
            yield from (f"    {result}: Any" for result in results)
            yield from ("", "")
    for name, symbols, results, about in entries:
        yield from write_function(name, symbols, results, about, docs)


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "python/src/furiko"
    version = re.search(r"furiko_version = '(.*)'", (ROOT / "src/furiko.F90").read_text())[1]
    (folder / "_version.py").write_text(f'{LICENCE}__version__ = "{version}"\n')
    (folder / "_functions.py").write_text("\n".join(write_module()).rstrip() + "\n")


if __name__ == "__main__":
    main()
