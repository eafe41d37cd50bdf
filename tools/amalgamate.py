#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The library in one file, to be copied into a Fortran program (what C calls is left out):

   python3 tools/amalgamate.py [--kinds KINDS] [--modules NAMES] [--f77] [FILE]    writes FILE, furiko.F90

   --kinds real64            one kind of real; or real32,real64. All three are the default. real64 is always
                             among them, since real32 computes in it.
   --modules furiko_complete,furiko_carlson
                             these modules and what they use; the default is all there are
   --f77                     what Fortran 77 calls, FKK and the like, too; by topic: --modules furiko_f77_complete
"""
import argparse
import pathlib
import re

ROOT = pathlib.Path(__file__).parent.parent
KINDS = ["real32", "real64", "real128"]
GUARD = "src/arithmetic/furiko_compiler.inc"
F77 = "src/f77/furiko_f77"
INCLUDE = re.compile(r"^\s*#?include\s+['\"](.*)['\"]")
MODULE = re.compile(r"^\s*module (?!procedure\b|subroutine\b|function\b)(\w+)")
USE = re.compile(r"^\s*use (?:, *(?:non_)?intrinsic *:: *)?(\w+)")
# Not what is written to the compiler, as !$omp and !GCC$
COMMENT = re.compile(r"^\s*!(?![$A-Z])")
IF_REAL128 = "#ifdef FURIKO_REAL128"
# What a module of several kinds says of real32, beside its `use`
OF_REAL32 = re.compile(r", \w+_real32\b|\bwrong_sp\(\) \+ ")


def inlined(path, door, seen, but=""):
    """Lines of a file with those it includes in their places, found as the compiler finds them, but of none whose name
    ends so; comments once, not in each kind of real"""
    again = path in seen
    seen.add(path)
    for line in path.read_text().splitlines():
        found = INCLUDE.match(line)
        if found and but and found[1].endswith(but):
            continue
        if found:
            places = [folder.joinpath(found[1]).resolve() for folder in (path.parent, door.parent)]
            room = next(place for place in places if place.exists())
            if room != ROOT.resolve() / GUARD:
                yield from inlined(room, door, seen)
        elif not line.startswith(("! SPDX", "! rooms:")) and not (again and COMMENT.match(line)):
            yield line


class Module:
    def __init__(self, name, lines, of_real128):
        self.name = name
        self.lines = lines
        self.of_real128 = of_real128
        self.uses = [found[1] for found in map(USE.match, lines) if found]

    def without(self, modules, real32, real128):
        """Lines without the `use` of modules, and without what is there for a kind"""
        continued, conditions = False, []
        for line in self.lines:
            if line.startswith("#if"):
                conditions.append(line)
            skipped = not real128 and IF_REAL128 in conditions
            if line == "#endif":
                conditions.pop()
            found = USE.match(line)
            if not continued and found and found[1] in modules:
                continued = True
            if continued:
                continued = line.endswith("&")
            elif not skipped:
                yield line if real32 else OF_REAL32.sub("", line)

    def text(self, *kinds):
        lines = list(self.without(*kinds))
        if self.of_real128:
            lines = [IF_REAL128, *lines, "#endif"]
        return "\n".join(lines).strip("\n") + "\n"


def modules(real32):
    """All modules in an order to compile them in, each with the comments above it; those for Fortran 77 with the
    externals below"""
    of_real128, name, lines, seen = False, None, [], set()
    for source in (ROOT / "src/order").read_text().split():
        # What C calls bears names of modules, which compilers refuse in one file.
        if source.startswith("src/c/"):
            continue
        if source.startswith(F77):
            lines = list(inlined(ROOT / source, ROOT / source, seen, "" if real32 else "_real.inc"))
            yield Module(pathlib.Path(source).stem, lines, False)
            lines = []
            continue
        for line in inlined(ROOT / source, ROOT / source, seen):
            if name is None and line in (IF_REAL128, "#endif"):
                of_real128 = line == IF_REAL128
                continue
            lines.append(line)
            found = MODULE.match(line)
            if found and name is None:
                name = found[1]
            if line.startswith("end module"):
                yield Module(name, lines, of_real128)
                name, lines = None, []


def header(kinds):
    version = re.search(r'^version = "(.*)"', (ROOT / "fpm.toml").read_text(), re.M)[1]
    licence = (ROOT / "LICENSE").read_text().rstrip("\n").split("\n")
    return "\n".join([
        "! SPDX-License-Identifier: MIT", "!",
        f"! furiko {version} in one file: {', '.join(kinds)}. Made by tools/amalgamate.py; do not edit.", "!",
        *(f"! {line}".rstrip() for line in licence), "", (ROOT / GUARD).read_text()])


def amalgamated(kinds, roots, f77):
    everything = [module for module in modules("real32" in kinds) if "real128" in kinds or not module.of_real128]
    dropped = {module.name for module in everything if module.name.endswith("_sp") and "real32" not in kinds}
    home = {module.name: module for module in everything if module.name not in dropped}
    for root in roots:
        if root not in home:
            raise SystemExit(f"amalgamate.py: no module {root}")
    # What the roots use; without any, what is used by none but modules that are left out goes too.
    if not roots:
        used = {use for module in everything for use in module.uses}
        roots = [name for name in home if name not in used and not name.startswith("furiko_f77")]
    if f77:
        roots.append("furiko_f77")
    needed, waiting = set(), list(roots)
    while waiting:
        name = waiting.pop()
        if name in home and name not in needed:
            needed.add(name)
            waiting += home[name].uses
    texts = [module.text(dropped, "real32" in kinds, "real128" in kinds)
             for module in home.values() if module.name in needed]
    return "\n\n".join([header(kinds), *texts])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kinds", default=",".join(KINDS))
    parser.add_argument("--modules", default="")
    parser.add_argument("--f77", action="store_true")
    parser.add_argument("file", nargs="?", default="furiko.F90")
    options = parser.parse_args()
    wanted = options.kinds.split(",")
    if "real64" not in wanted or not set(wanted) <= set(KINDS):
        parser.error("--kinds is real64, or a list of it and real32 and real128")
    text = amalgamated([kind for kind in KINDS if kind in wanted], [name for name in options.modules.split(",") if name], options.f77)
    pathlib.Path(options.file).write_text(text)
