#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Sources in an order to compile them in, each behind those whose modules it uses:

   python3 tools/make_order.py [FOLDER]    writes src/order, or FOLDER/order; .ci/run compares
   python3 tools/make_order.py --tests     prints that of test-drive's stand-in, the program and the tests

For those who build without fpm.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).parent.parent
MODULE = re.compile(r"^\s*module (?!procedure\b|subroutine\b|function\b)(\w+)", re.M)
USE = re.compile(r"^\s*use (?:, *(?:non_)?intrinsic *:: *)?(\w+)", re.M)


def order(folder):
    """Paths of a folder's sources, relative to the root"""
    texts = {path: path.read_text() for path in sorted((ROOT / folder).glob("**/*.[fF]90"))}
    home = {module: path for path, text in texts.items() for module in MODULE.findall(text)}
    ordered = []

    def place(path):
        if path in ordered:
            return
        for module in USE.findall(texts[path]):
            if home.get(module, path) != path:
                place(home[module])
        ordered.append(path)

    for path in texts:
        place(path)
    return [str(path.relative_to(ROOT)) for path in ordered]


def tests():
    return ["tools/test-drive/src/testdrive.f90", *order("app"), *order("test")]


if __name__ == "__main__":
    if sys.argv[1:] == ["--tests"]:
        print("\n".join(tests()))
    else:
        target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "src"
        (target / "order").write_text("".join(f"{path}\n" for path in order("src")))
