# SPDX-License-Identifier: MIT
"""What the manual is made from: each function here reads one source of the repository."""
import ast
import fnmatch
import functools
import gzip
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import make_c_interface  # noqa: E402
import make_catalogue  # noqa: E402

FORM = make_catalogue.FORM
KINDS = ["real32", "real64", "real128"]


def doc_above(lines, number):
    """The docstring that ends above a line"""
    doc = []
    while number > 0 and lines[number - 1].strip().startswith("!>"):
        number -= 1
        doc.insert(0, lines[number].strip()[2:].strip())
    return doc


def modules():
    return re.findall(r"^   use (furiko_\w+)", (ROOT / "src/furiko.F90").read_text(), re.M)


@functools.cache
def module_lines(name):
    return make_catalogue.module_lines(name)


def listed(access, text):
    """The names of all `public ::` or `private ::` statements"""
    text = re.sub(r" *&\n *(?:& *)?", " ", text)
    return [name.strip() for names in re.findall(rf"^ *{access} :: (.*)", text, re.M) for name in names.split(",")]


@functools.cache
def public_names():
    """{name: module of the facade}; a door that makes all public passes on what its room of real64 does, and its renamings"""
    found = {"furiko_version": "furiko"}
    for module in modules():
        door = next(make_catalogue.SRC.glob(f"*/{module}.[fF]90")).read_text()
        text = door[door.index(f"\nmodule {module}\n"):]
        names = listed("public", text) or [*listed("public", "\n".join(module_lines(module))),
                                           *re.findall(r"(\w+) => \w+", text)]
        found.update((name, module) for name in names if name not in listed("private", text))
    return found


@functools.cache
def docstrings():
    """{name: lines} of generics, types and functions"""
    found = {"furiko_version": ["The library's version as text, by the rules of semver.org."]}
    for module in modules():
        lines = module_lines(module)
        for number, line in enumerate(lines):
            opened = re.match(r"   (?:interface|type ::|(?:(?:pure|elemental) )*(?:function|subroutine)) (\w+)", line)
            doc = doc_above(lines, number)
            if opened and doc:
                found.setdefault(opened[1], doc)
    door = (ROOT / "src/selftest/furiko_known_values.F90").read_text().split("\n")
    number = next(i for i, line in enumerate(door) if "function furiko_selftest" in line)
    found["furiko_selftest"] = doc_above(door, number)
    return found


@functools.cache
def catalogue():
    """{name: (arguments, results)} of the functions of real numbers"""
    return {name: (arguments, results) for name, arguments, results, _ in make_catalogue.entries()}


def dummies(body):
    """(name, declaration, meaning) of each argument of a procedure, and whether it is elemental"""
    head = make_catalogue.PROCEDURE.match(body[0])
    names = [name.strip() for name in head[3].split(",") if name.strip()]
    found = {}
    for number, line in enumerate(body[1:], 1):
        if line.strip().startswith(("end ", "call ", "if ", "do ")):
            break
        declared = re.match(r"\s*((?:real|integer|logical|type|class|procedure|complex)\(?.*?) :: (.*)", line)
        for name in re.split(r", (?![^(]*\))", declared[2]) if declared else ():
            plain = re.match(r"\w+", name)[0]
            if plain in names:
                found[plain] = (name, declared[1], " ".join(doc_above(body, number)))
    return [(name, *found.get(name, (name, "", ""))) for name in names], body[0].lstrip().startswith("elemental")


def specifics(name):
    """The procedures of a generic: their bodies from the head on"""
    if public_names()[name] not in modules() or name == "furiko_selftest":
        return []
    lines = module_lines(public_names()[name])
    procedures = make_catalogue.specifics(name, lines) or [name]
    bodies = (make_catalogue.specific_lines(procedure, lines) for procedure in procedures)
    return [body for body in bodies if body]


def takes_arrays(name):
    return make_catalogue.takes_arrays(name, module_lines(public_names()[name]))


def bindings(type_name):
    """(name, arguments, docstring) of what a type's objects are asked"""
    lines = module_lines(public_names()[type_name])
    start = lines.index(f"   type :: {type_name}")
    block = lines[start:lines.index(f"   end type {type_name}")]
    for number, line in enumerate(block):
        found = re.match(r"      (?:procedure|generic) :: (\w+)(?: => (\w+))?", line)
        if not found:
            continue
        doc = doc_above(block, number)
        place = next(i for i, text in enumerate(lines) if (match := make_catalogue.PROCEDURE.match(text))
                     and match[2] == (found[2] or found[1]))
        arguments = [name for name, *_ in dummies(lines[place:])[0] if name != "self"]
        yield found[1], arguments, doc or doc_above(lines, place), "subroutine" in lines[place].split("(")[0]


def components(type_name):
    """(name, type, docstring) of the public components of a type"""
    lines = module_lines(public_names()[type_name]) if public_names()[type_name] in modules() else []
    if f"   type :: {type_name}" not in lines:
        return
    for number in range(lines.index(f"   type :: {type_name}") + 1, len(lines)):
        if lines[number].strip() in ("private", "contains") or lines[number].startswith("   end type"):
            return
        declared = re.match(r"      (\w.*) :: (.*)", lines[number])
        if declared:
            yield declared[2], declared[1], " ".join(doc_above(lines, number))


@functools.cache
def c_prototypes():
    """{name: prototype}, of double"""
    text = re.sub(r"/\*.*?\*/", "", (ROOT / "include/furiko.h").read_text(), flags=re.S)
    found = re.findall(r"^((?:double|void|int|size_t) \*?(furiko_\w+)\([^;]*\);)", text, re.M)
    return {name: re.sub(r"\s+", " ", prototype) for prototype, name in found}


def f77_calls(names):
    """Of doc/f77.md: the calls in the rows whose last column has one of these names"""
    page = ROOT / "doc/f77.md"
    for _, header, rows in tables(page) if page.exists() else ():
        for row in rows if header[-1] == "in modern Fortran" else ():
            if matching(re.findall(r"`([^`]+)`", row[-1]), names):
                yield from re.findall(r"`([^`]+)`", row[0])


@functools.cache
def python_names():
    """{name: arguments} of the Python package's functions, without types"""
    found = {}
    for path in sorted((ROOT / "python/src").rglob("*.py")):
        for node in ast.parse(path.read_text()).body:
            if isinstance(node, ast.FunctionDef):
                for argument in ast.walk(node.args):
                    if isinstance(argument, ast.arg):
                        argument.annotation = None
                found.setdefault(node.name, ast.unparse(node.args))
    return found


def cells_of(line):
    return [cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line.strip()[1:-1])]


def tables(path):
    """(heading, header, rows) of each table of a Markdown page"""
    heading, rows = "", []
    for line in [*path.read_text().split("\n"), ""]:
        if line.startswith("|"):
            rows.append(cells_of(line))
        elif rows:
            yield heading, rows[0], rows[2:]
            rows = []
        if line.startswith("#"):
            heading = line.lstrip("# ")


@functools.cache
def ranges():
    """{pattern of a name: domain}, from the tables of doc/*.md that have such a column"""
    found = {}
    for page in ("integrals", "functions", "pendulum", "classics"):
        for _, header, rows in tables(ROOT / f"doc/{page}.md"):
            column = next((i for i, title in enumerate(header) if title.startswith("domain")), None)
            domain = ""
            for row in rows if column else ():
                if not row[column].startswith("likewise"):
                    domain = row[column]
                elif ";" in row[column]:
                    domain += row[column].removeprefix("likewise")
                for pattern in re.findall(r"`([\w*]+)", row[0]):
                    found.setdefault(pattern, domain)
    return found


def elsewhere(names):
    """(header, rows) of the tables of names elsewhere that have one of these"""
    for page in ("integrals", "functions"):
        for heading, header, rows in tables(ROOT / f"doc/{page}.md"):
            if heading == "Names elsewhere":
                taken = [row for row in rows if set(re.findall(r"\w+", row[0])) & set(names)]
                columns = [i for i in range(len(header)) if any(row[i] for row in taken)]
                if taken:
                    yield [header[i] for i in columns], [[row[i] for i in columns] for row in taken]


@functools.cache
def accuracy():
    """Rows (kind, name, regime, points, largest, promised, at) of the report"""
    found = []
    for kind, text in re.findall(r"^## (real\d+)$(.*?)(?=^## |\Z)", (ROOT / "doc/accuracy.md").read_text(), re.M | re.S):
        for line in text.split("\n"):
            cells = cells_of(line) if line.startswith("|") else []
            if len(cells) == 8 and cells[2].isdigit():
                found.append((kind, cells[0], cells[1], int(cells[2]), float(cells[3]), cells[6], cells[7]))
    return found


@functools.cache
def speed():
    """{name: [(header, cells)]} of the section -O3 of the report"""
    text = (ROOT / "doc/speed.md").read_text()
    section = re.search(r"^## -O3$(.*?)^## ", text, re.M | re.S)[1]
    found = {}
    for block in re.findall(r"(?:^\|.*\n)+", section, re.M):
        lines = [cells_of(line) for line in block.strip().split("\n")]
        for cells in lines[2:]:
            name = cells[1] if lines[0][0] == "to" and len(cells) == 4 else cells[0]
            found.setdefault(name, []).append((lines[0], cells))
    return found


@functools.cache
def captions():
    """{picture: what it shows}, of the gallery"""
    found = re.findall(r"^!\[(.*)\]\(figures/(.*)\)$", (ROOT / "doc/gallery.md").read_text(), re.M)
    return {picture: caption for caption, picture in found}


@functools.cache
def special_values():
    """{name: [(arguments, results)]}, the values that test/test_special.inc compares"""
    found, name, count = {}, "", 0
    for line in gzip.decompress((ROOT / "test/data/special.dat.gz").read_bytes()).decode().split("\n"):
        words = line.split()
        if words and words[0][0].isalpha() and words[0] not in ("inf", "nan"):
            name, count = words[0], int(words[1])
            found[name] = []
        elif words:
            found[name].append((words[:count], words[count:]))
    return found


@functools.cache
def examples():
    """{path: (names used, source without the outputs, output)}"""
    found = {}
    for path in sorted((ROOT / "example").rglob("*.f90")):
        text = path.read_text()
        joined = re.sub(r" *&\n *", " ", text)
        names = {name.strip() for names in re.findall(r"use furiko\w*, only : (.*)", joined) for name in names.split(",")}
        output = re.findall(r"! => *(.*)", text)
        source = re.sub(r"^ *! => .*\n", "", text.replace("! SPDX-License-Identifier: MIT\n\n", ""), flags=re.M)
        found[path] = names, re.sub(r" *! => .*", "", source), output
    return found


def matching(patterns, names):
    return [name for pattern in patterns for name in names if fnmatch.fnmatchcase(name, pattern)]
