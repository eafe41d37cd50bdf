#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The pages of the reference, one a family of manual/families.toml: python3 manual/pages.py FOLDER, of which reference/ and index.md are written

A page has all parts, or this stops and says which is missing; a public name without a page stops it as well.
"""
import fnmatch
import pathlib
import re
import sys
import textwrap
import tomllib

import plots
import sources as of

MEANINGS = of.make_c_interface.MEANINGS
UNITS = {"phi": "rad", "alpha": "rad", "z": "rad", "amplitude": "rad", "angle": "rad", "theta0": "rad", "low": "rad",
         "time": "s", "length": "m", "gravity": "m/s²", "t0": "of your choice", "h": "as t0", "omega2": "1/time²",
         "rate": "rad/time"}
MORE_MEANINGS = {"x": "number", "y": "number", "z": "number", "p": "number", "a": "number", "b": "number",
                 "terms": "how many terms", "n": "characteristic, in DLMF's sign"}
FORM_WORDS = {"k": "modulus, m = k²", "m": "parameter, m = k²", "mc": "complementary parameter, 1 − m",
              "alpha": "modular angle, k = sin α"}
PARTS = ["Signatures", "Definition", "Arguments", "Special values", "Accuracy", "Speed", "Method", "Pictures", "Example",
         "See also", "Names elsewhere"]


class Book:
    """All families, and on which page a name is"""

    def __init__(self):
        self.families = tomllib.loads((of.ROOT / "manual/families.toml").read_text())
        self.page_of = {}
        for page, family in self.families.items():
            family["members"] = [name for name in of.matching(family["names"], of.public_names())
                                 if name not in self.page_of]
            self.page_of.update((name, page) for name in family["members"])
        # An entry may be written before its functions are
        self.families = {page: family for page, family in self.families.items() if family["members"]}
        self.lacking = []
        missing = sorted(set(of.public_names()) - set(self.page_of))
        if missing:
            sys.exit(f"manual/families.toml: no page has {', '.join(missing)}; add them to an entry, or add an entry")

    def page(self, page):
        family = self.families[page]
        writers = dict(zip(PARTS, (signatures, definition, arguments, special, accuracy, speed, method, pictures,
                                   example, see_also, elsewhere)))
        yield f"# {family['title']}"
        yield ""
        yield f"{family.get('about', '')}".strip()
        yield ""
        yield "".join(f"(name-{name})=\n" for name in family["members"]).rstrip()
        for part in PARTS:
            text = "\n".join(writers[part](self, page, family)).strip()
            if not text:
                self.lacking.append(f"{page}: {part}")
            yield f"\n## {part}\n\n{text}"
        yield from details(self, family)


# Text

def escaped(text):
    """Of a docstring, as Markdown: words between backticks stay, all else is literal"""
    pieces = re.split(r"(`[^`]*`)", text)
    return "".join(piece if piece.startswith("`") else re.sub(r"([*_<>\[\]\\|~$])", r"\\\1", piece) for piece in pieces)


def linked(book, text):
    pieces = re.split(r"\[\[(\w+)\]\]", text)
    return "".join(link(book, piece) if number % 2 else escaped(piece) for number, piece in enumerate(pieces))


def link(book, name):
    return f"[`{name}`](#name-{name})" if name in book.page_of else f"`{name}`"


def latex(text):
    """As docutils knows it"""
    for ours, known in ((r"\dots", r"\ldots"), (r"\Bigl", r""), (r"\Bigr", r"")):
        text = text.replace(ours, known)
    return text.strip()


def formula(text):
    return f"```{{math}}\n{latex(text)}\n```\n"


def in_a_cell(book, lines):
    """A docstring on one line"""
    pieces = " ".join(lines).split("$$")
    return "".join(f"${latex(piece).rstrip(',;')}$, " if number % 2 else linked(book, piece.strip() + " ")
                   for number, piece in enumerate(pieces)).strip(" ,")


def markdown(book, lines):
    """A docstring"""
    text = "\n".join(lines)
    for number, piece in enumerate(re.split(r"\$\$", text)):
        if number % 2:
            yield "\n" + formula(piece)
        else:
            for paragraph in re.split(r"\n\n+", piece.strip("\n")):
                yield verbatim_or(book, paragraph) + "\n"


def verbatim_or(book, paragraph):
    if paragraph.startswith("if (furiko_selftest"):
        return f"```fortran\n{paragraph}\n```"
    return re.sub(r"\n\\?- ", "\n- ", linked(book, paragraph))


def table(header, rows):
    yield "| " + " | ".join(header) + " |"
    yield "|" + "---|"*len(header)
    yield from ("| " + " | ".join(re.sub(r"(?<!\\)\|", r"\\|", cell) for cell in row) + " |" for row in rows)


def code(language, lines):
    yield f"```{language}"
    yield from lines
    yield "```"


# Parts

def fortran_call(name, body):
    head = of.make_catalogue.PROCEDURE.match(body[0])
    if head[1] == "subroutine":
        return f"call {name}({head[3]})"
    if name in of.catalogue():
        arguments, results = of.catalogue()[name]
        head_arguments = ", ".join(arguments)
        return f"{results[0].replace(chr(39), '_prime')} = {name}({head_arguments})"
    return f"{head[4] or name} = {name}({head[3]})"


def fortran_lines(page, family):
    if page == "furiko_selftest":
        return ["integer :: wrong", "wrong = furiko_selftest()", "character(len=*), parameter :: furiko_version"]
    lines = []
    for name in family["members"]:
        bodies = of.specifics(name)
        calls = [fortran_call(name, body) for body in bodies] if page == "rk4" else \
            [fortran_call(name, body) for body in bodies[:1]]
        lines += calls
    if page in ("pendulum", "modulus", "motion"):
        lines += [f"type({page}) :: p"]
        lines += [f"{'call ' if sub else ''}p%{name}({', '.join(arguments)})"
                  for name, arguments, _, sub in of.bindings(page)]
    return lines


def signatures(book, page, family):
    uses = ", ".join(family["members"])
    use = textwrap.wrap(f"use furiko, only : {uses}", 96, subsequent_indent="   ", break_long_words=False)
    yield from code("fortran", [*(line + " &" for line in use[:-1]), use[-1], "", *fortran_lines(page, family)])
    yield ""
    kinds = family.get("kinds", "real32, real64 or real128")
    elemental = [name for name in family["members"] if any(of.dummies(body)[1] for body in of.specifics(name))]
    if elemental:
        who = "The functions" if all(name in elemental for name in family["members"] if of.specifics(name)) else \
            ", ".join(f"`{name}`" for name in elemental)
        yield (f"All numbers are of one kind: {kinds}. {who} {'are' if ' ' in who else 'is'} elemental: arrays of any shape do."
               + (" Arrays of rank 1 go to a vectorised kernel of their own." if of.takes_arrays(elemental[0]) else ""))
    elif page in ("pendulum", "modulus", "motion"):
        yield (f"`{page}` is of real64; `{page}_real32` and `{page}_real128` are its sisters with the same functions. "
               "Times and arguments may be one number or an array of rank 1 where the function says so below.")
    elif page != "furiko_selftest":
        yield f"All numbers are of one kind: {kinds}." if "kinds" not in family else f"All numbers are of {kinds}."
    yield ""
    yield from other_languages(page, family)


def other_languages(page, family):
    prefix = {"pendulum": "motion_", "motion": "motion_", "modulus": "modulus_"}.get(page)
    if prefix:
        c = [text for name, text in of.c_prototypes().items() if name.startswith("furiko_" + prefix)
             and not name.endswith("_size")]
    else:
        c = [of.c_prototypes()[f"furiko_{name}"] for name in family["members"] if f"furiko_{name}" in of.c_prototypes()]
    if c:
        yield "In C and C++ ([guide](../doc/c.md)); `f` at the end of a name is float, `_v` takes arrays:\n"
        yield from code("c", c)
    else:
        yield "In C: these functions are Fortran's alone."
    yield ""
    f77 = list(of.f77_calls(family["members"]))
    if f77:
        yield "In Fortran 77 ([guide](../doc/f77.md)):\n"
        yield from code("fortran", f77)
        yield ""
    python = [f"furiko.{name}({of.python_names()[name]})" for name in family["members"] if name in of.python_names()]
    if python:
        yield "In Python ([guide](../doc/python.md)):\n"
        yield from code("python", python)
        yield ""


def own_docs(family):
    """(name, docstring) of those that do more than to point to another"""
    docs = ((name, of.docstrings().get(name, [])) for name in family["members"])
    return [(name, doc) for name, doc in docs if doc and not re.match(r"As \[\[", doc[0])]


def definition(book, page, family):
    if "definition" in family:
        yield formula(family["definition"])
        return
    seen = set()
    for name, doc in own_docs(family):
        found = re.search(r"\$\$(.*?)\$\$", "\n".join(doc), re.S)
        if found and found[1] not in seen:
            seen.add(found[1])
            yield formula(found[1])


def arguments(book, page, family):
    rows = {}
    for name in family["members"]:
        form = of.FORM.match(name)
        for body in of.specifics(name)[:1 if page != "rk4" else None]:
            for dummy, shape, declared, meaning in of.dummies(body)[0]:
                if dummy in rows:
                    continue
                if form and dummy == form[2]:
                    meaning = FORM_WORDS[dummy]
                elif len(meaning.split()) < 2:
                    known = {**MORE_MEANINGS, **MEANINGS} if declared.startswith("real") else {}
                    meaning = known.get(dummy) or meaning or dummy
                unit = UNITS.get(dummy, "1" if declared.startswith("real") else "")
                given = "any shape (elemental)" if of.dummies(body)[1] else \
                    ("rank " + str(shape.count(":")) if ":" in shape else "scalar")
                intent = re.search(r"intent\((\w+)\)", declared)
                what = re.sub(r", intent\(\w+\)", "", declared)
                rows[dummy] = [f"`{dummy}`", escaped(meaning), unit, given, f"`{what}`", intent[1] if intent else ""]
    if rows:
        yield from table(["argument", "what", "unit", "shape", "type", "intent"], rows.values())
        yield ""
    if page in ("pendulum", "modulus", "motion"):
        yield from table(["function", "what it says"],
                         [[f"`{name}({', '.join(arguments)})`", in_a_cell(book, doc)]
                          for name, arguments, doc, _ in of.bindings(page)])
        yield ""
    for name in family["members"]:
        rows = list(of.components(name))
        if rows:
            yield f"Components of `type({name})`:\n"
            yield from table(["component", "what", "type"], [[f"`{component}`", linked(book, doc), f"`{declared}`"]
                                                             for component, declared, doc in rows])
            yield ""
    first = family["members"][0]
    found = [family["range"]] if "range" in family else \
        [text for pattern, text in of.ranges().items() if fnmatch.fnmatchcase(first, pattern)]
    if not found:
        sys.exit(f"manual: the page {page} has no range; doc/*.md has no row for {first}")
    yield f"Range: {escaped(found[0])}."


def special_sentence(doc):
    text = " ".join(line for line in doc)
    found = re.search(r"(Special cases.*?)(?= Accuracy|  |$)", text) or \
        re.search(r"(?:\$\$ +)([A-Z]\(\w+=.*?NaN out\.)", text)
    return re.sub(r"^Special cases:? ?", "", found[1]).split(" Method:")[0] if found else ""


def special(book, page, family):
    if "special" in family:
        yield escaped(family["special"])
    for name, doc in own_docs(family):
        sentence = special_sentence(doc)
        if sentence:
            yield f"- `{name}`: {linked(book, sentence)}"
    # Every argument in turn, the others at 1/2; of those the tests compare
    tested = [name for name in family["members"] if name in of.special_values()]
    name = next((name for name in tested if name.endswith("_m")), tested[0] if tested else None)
    if name:
        symbols, results = of.catalogue()[name]
        taken = [(given, said) for given, said in of.special_values()[name]
                 if sum(word != "0.5" for word in given) <= 1 and not any(len(word) > 4 or word == "-0.0" for word in given)]
        yield f"\nTested values of `{name}`{', the other arguments at 1/2' if len(symbols) > 1 else ''}:\n"
        yield from table([*symbols, *(f"`{word}`" for word in results)], [[*given, *said] for given, said in taken])


def accuracy(book, page, family):
    if "inexact" in family:
        yield family["inexact"]
        return
    names = of.matching(family.get("accuracy", family["members"]), dict.fromkeys(row[1] for row in of.accuracy()))
    fold = len(set(names)) > 8
    rows = {}
    for kind, name, regime, points, largest, promised, at in of.accuracy():
        if name in names:
            form = of.FORM.match(name)
            key = (form[1] + "_*" if fold and form else name, kind)
            old = rows.get(key, (0, 0.0, "", "", ""))
            rows[key] = (old[0] + points, *((largest, regime, at, name) if largest >= old[1] else old[1:]))
    if not rows:
        return
    yield ("Largest error found in ulp against references of 40 digits (motions, and complex u: in epsilon of what "
           "[the report](../doc/accuracy.md) says), and where.\n")
    yield from table(["name", "kind", "points", "largest", "regime", "arguments there"],
                     [[f"`{name}`", kind, f"{points:,}", f"{largest:.2f}", regime, at]
                      for (name, kind), (points, largest, regime, at, _) in
                      sorted(rows.items(), key=lambda item: of.KINDS.index(item[0][1]))])


def speed(book, page, family):
    if "unmeasured" in family:
        yield f"{family['unmeasured']} See [speed](../doc/speed.md)."
        return
    rows, header = [], None
    for name in family["speed"]:
        if name not in of.speed():
            sys.exit(f"manual: doc/speed.md has no row '{name}', of which the page {page} speaks")
        for titles, cells in of.speed()[name]:
            if header and len(cells) != len(header):
                continue
            header = header or titles
            rows.append(cells)
    keep = [i for i, title in enumerate(header) if "/" not in title and "flang" not in title and title != "waits"
            and any(row[i] not in ("-", "") for row in rows)]
    yield "Nanoseconds a call or a value in real64 on one thread, gfortran -O3 ([all figures](../doc/speed.md)).\n"
    yield from table([header[i] or "what" for i in keep], [[row[i] for i in keep] for row in rows])


def method(book, page, family):
    yield family["method"]


def example(book, page, family):
    names = set(family["members"])
    found = sorted((len(used - names), path) for path, (used, _, _) in of.examples().items() if used & names)
    for _, path in found[:2]:
        _, source, output = of.examples()[path]
        yield f"[{path.relative_to(of.ROOT)}](../{path.relative_to(of.ROOT)}), which CI runs and compares:\n"
        yield from code("fortran", source.strip().split("\n"))
        yield "\nIt prints\n"
        yield from code("text", output)
        yield ""


def pictures(book, page, family):
    """None, and the page lacks a part, where families.toml neither has one nor says why"""
    yield family.get("unplotted", "")
    for picture in family.get("figure", []):
        caption = of.captions()[picture]
        yield f"![{caption}](../doc/figures/{picture})\n\n{caption}. [How it is made](../doc/gallery.md)\n"
    if "plot" in family and (plots.FOLDER / f"{page}.svg").exists():
        caption = escaped(plots.caption(family["plot"]))
        yield f"![{caption}](../manual/plots/{page}.svg)\n\n{caption}."


def see_also(book, page, family):
    for other in family["see"]:
        yield f"- [{book.families[other]['title']}](#name-{book.families[other]['members'][0]})"


def elsewhere(book, page, family):
    found = False
    for header, rows in of.elsewhere(family["members"]):
        found = True
        yield from table(header, rows)
        yield ""
    text = family["method"] + "\n" + "\n".join(line for _, doc in own_docs(family) for line in doc)
    sections = list(dict.fromkeys(re.findall(r"\b(\d\d\.\d{1,2}\.\d+)\b", text)))
    if not found:
        yield "No peer that we know of has it under a name of its own.\n"
    if sections:
        links = (f"[{name}](https://dlmf.nist.gov/{name.rpartition('.')[0]}#E{name.rpartition('.')[2]})" for name in sections)
        yield f"In the [DLMF](https://dlmf.nist.gov): {', '.join(links)}."


def details(book, family):
    yield "\n## In the words of the source\n"
    for name in family["members"]:
        doc = of.docstrings().get(name)
        if doc:
            yield f"\n```{{index}} {name}\n```\n\n**`{name}`**\n"
            yield from markdown(book, doc)


def main():
    source = pathlib.Path(sys.argv[1])
    folder = source / "reference"
    folder.mkdir(parents=True, exist_ok=True)
    book = Book()
    for page in book.families:
        (folder / f"{page}.md").write_text("\n".join(book.page(page)) + "\n")
    if book.lacking:
        sys.exit("manual: pages without a part: " + "; ".join(book.lacking))
    rows = [[link(book, name), f"[{book.families[page]['title']}](#name-{book.families[page]['members'][0]})"]
            for name, page in sorted(book.page_of.items())]
    listing = "\n".join(table(["name", "page"], rows))
    (folder / "names.md").write_text(f"# All names\n\nEvery public name of the library, {len(rows)} of them.\n\n{listing}\n")
    # A page of doc/ that the index does not name is among the subjects
    index = (of.ROOT / "manual/index.md").read_text()
    others = sorted(page for path in (of.ROOT / "doc").glob("*.md") if f"\n{(page := f'doc/{path.stem}')}\n" not in index)
    (source / "index.md").write_text(index.replace("@others@", "\n".join(others)))
    print(f"{len(book.families)} pages, {len(rows)} names, each with {len(PARTS)} parts")


main()
