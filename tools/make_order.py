#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write src/order, the sources in an order to compile them in: python3 tools/make_order.py [FOLDER]

For those who build without fpm; .ci/run compares. Each file comes behind those whose modules it uses.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).parent.parent
MODULE = re.compile(r"^\s*module (?!procedure\b|subroutine\b|function\b)(\w+)", re.M)
USE = re.compile(r"^\s*use (?:, *(?:non_)?intrinsic *:: *)?(furiko\w*)", re.M)

texts = {path: path.read_text() for path in sorted(ROOT.glob("src/**/*.[fF]90"))}
home = {module: path for path, text in texts.items() for module in MODULE.findall(text)}
order = []


def place(path):
    if path in order:
        return
    for module in USE.findall(texts[path]):
        if home[module] != path:
            place(home[module])
    order.append(path)


for path in texts:
    place(path)
folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "src"
(folder / "order").write_text("".join(f"{path.relative_to(ROOT)}\n" for path in order))
