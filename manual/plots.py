#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The pictures of pages for which doc/figures has none: python3 manual/plots.py PROGRAM [--check]

What a picture shows is the row `plot` of manual/families.toml, its numbers are what PROGRAM says, and gnuplot draws it into
manual/plots. With --check each is compared with the one there, if that is by the same gnuplot: another places labels otherwise.
"""
import csv
import math
import pathlib
import re
import subprocess
import sys
import tomllib

import sources as of

FOLDER = of.ROOT / "manual/plots"
# Pens, and what makes a picture dark on a dark page, as furiko plot has them
PENS = ["'#000000'", "'#0072B2' dt (9, 3)", "'#B84A00' dt (4, 3)", "'#00795A' dt (9, 3, 2, 3)"]
DARK = re.search(r"<style>.*</style>", (of.ROOT / "doc/figures/functions.svg").read_text())[0]
ANGLES = ("phi", "z")
TICS = {"0": 0, "π/2": 0.5, "π": 1, "3π/2": 1.5, "2π": 2}
POINTS = 120


def call(name, plot):
    """ellippiinc_m(n, phi, 0.5)"""
    given = {symbol: value for symbol, value in plot.items() if not isinstance(value, list)}
    return f"{name}({', '.join(str(given.get(symbol, symbol)) for symbol in of.catalogue()[name][0])})"


def several(plot):
    """The argument that has several values, and these"""
    lists = (item for item in plot.items() if isinstance(item[1], list) and item[0] in of.catalogue()[plot["of"][0]][0])
    return next(lists, ("", []))


def caption(plot):
    if "command" in plot:
        return plot["caption"]
    (symbol, values), pi = several(plot), "π" if plot["over"] in ANGLES else ""
    calls, low, high = " and ".join(call(name, plot) for name in plot["of"]), *plot["range"]
    return (f"{calls} for {plot['over']} from {low}{pi if low else ''} to {high}{pi}"
            + (f", {symbol} = {', '.join(map(str, values[:-1]))} and {values[-1]}" if symbol else ""))


def ask(program, words, text=""):
    done = subprocess.run([program, *words, "--format", "csv"], input=text, text=True, capture_output=True)
    if done.returncode:
        sys.exit(f"manual/plots.py: {' '.join(words)}: {done.stderr}")
    return csv.DictReader(done.stdout.splitlines())


def curve(program, name, plot):
    """Points closer together towards both ends, where functions are steep"""
    unit = math.pi if plot["over"] in ANGLES else 1
    low, high = plot["range"]
    xs = [(low + high)/2 - (high - low)/2*math.cos(math.pi*i/POINTS) for i in range(POINTS + 1)]
    rows = [" ".join(str({**plot, plot["over"]: unit*x}[symbol]) for symbol in of.catalogue()[name][0]) for x in xs]
    return [(x, float(next(iter(row.values())))) for x, row in zip(xs, ask(program, ["eval", name], "\n".join(rows)))]


def panels(program, plot):
    """(heading, [(name, points)]) of each: one a function if an argument has several values, else all in one"""
    if "command" in plot:
        # A cycle comes again and again
        points = dict.fromkeys(tuple(round(float(row[name]), 6) for name in plot["columns"])
                               for row in ask(program, plot["command"].split()))
        return [(plot["columns"][1], [("", list(points))])]
    symbol, values = several(plot)
    if symbol:
        return [(call(name, plot), [(f"{symbol} = {value}", curve(program, name, {**plot, symbol: value})) for value in values])
                for name in plot["of"]]
    curves = [(call(name, plot), curve(program, name, plot)) for name in plot["of"]]
    return [("", curves)] if len(curves) > 1 else [(curves[0][0], [("", curves[0][1])])]


def block(points, height):
    """Lines of data; a blank one where there is no value, and at a pole, which a curve does not cross"""
    last = math.nan
    for point in points:
        if not math.isfinite(point[1]) or (point[1]*last < 0 and abs(point[1] - last) > height):
            yield ""
        if math.isfinite(point[1]):
            yield " ".join(f"{number:.7g}" for number in point)
        last = point[1]


def script(plot, drawn):
    """gnuplot's: one panel or four, and one key for all of them"""
    rows, beside = 1 if len(drawn) == 1 else 2, any(heading and curves[1:] for heading, curves in drawn)
    height = 200 + 160*rows
    low, high = plot.get("within", (-math.inf, math.inf))
    under = plot["columns"][0] if "command" in plot else plot["over"]
    yield f"""set terminal svg size 640,{height} font 'sans-serif,13' background '#ffffff'
set encoding utf8; set minussign; set border 3; set tics nomirror out; set xzeroaxis lt 1 lc rgb '#a0a0a0'
unset colorbox; set palette defined (1 '#0072B2', 2 '#B84A00'); set autoscale xfix
set key at screen 0.99, screen {0.86 if beside else 0.995} right top noenhanced samplen 2.5
set multiplot layout {rows},{rows} margins screen 0.1,{0.79 if beside else 0.96},{72/height},0.86 spacing screen 0.1,0.17"""
    for axis, key in ("x", "range"), ("y", "within"):
        if key in plot:
            yield f"set {axis}range [{plot[key][0]}:{plot[key][1]}]"
    if under in ANGLES:
        yield f"set xtics ({', '.join(f'{name!r} {place}' for name, place in TICS.items() if place <= plot['range'][1])})"
    for number, (heading, curves) in enumerate(drawn):
        for pen, (_, points) in enumerate(curves):
            yield from (f"$c{pen} << E", *block(points, high - low), "E")
        yield f"set label 1 '{heading}' at graph 0, graph 1.07 left noenhanced"
        yield f"set xlabel '{under if number >= len(drawn) - rows else ''}' noenhanced"
        yield "plot " + ", ".join(f"$c{pen} with {plot.get('with', f'lines lw 2 lc rgb {PENS[pen]}')} title '{name}'"
                                  for pen, (name, _) in enumerate(curves))
        yield "unset key"
    yield "unset multiplot"


def picture(program, plot):
    text = "\n".join(script(plot, panels(program, plot))).replace("phi", "φ")
    done = subprocess.run(["gnuplot", "-d"], input=text, text=True, capture_output=True)
    if done.stderr or "</svg>" not in done.stdout:
        sys.exit(f"manual/plots.py: {caption(plot)}: gnuplot says {done.stderr}")
    return done.stdout.replace("<title>Gnuplot</title>", f"<title>{caption(plot)}</title>").replace("</desc>", f"</desc>\n{DARK}")


def alike(one, other):
    """To a fifth of a pixel: the last digits of a number may depend on the compiler's flags"""
    number = re.compile(r"\d+\.\d+")
    return number.sub("", one) == number.sub("", other) and all(
        abs(float(here) - float(there)) < 0.2 for here, there in zip(number.findall(one), number.findall(other)))


def main():
    families = tomllib.loads((of.ROOT / "manual/families.toml").read_text())
    new = {f"{page}.svg": picture(str(pathlib.Path(sys.argv[1]).resolve()), family["plot"])
           for page, family in families.items() if "plot" in family}
    FOLDER.mkdir(exist_ok=True)
    old = {path.name: path.read_text() for path in FOLDER.iterdir()}
    if "--check" in sys.argv:
        version = re.compile(r"Produced by GNUPLOT[^<]*|$")
        other = {name for name in new.keys() & old.keys() if version.search(new[name])[0] != version.search(old[name])[0]}
        wrong = [name for name in sorted(new.keys() | old.keys()) if name not in other and not alike(new.get(name, "+"), old.get(name, "-"))]
        print(f"manual/plots: {len(new) - len(other)} pictures compared, {len(other)} by another gnuplot not")
        sys.exit(f"manual/plots: {', '.join(wrong)}: not what the program's numbers look like; run manual/plots.py" if wrong else 0)
    for name in old.keys() - new.keys():
        (FOLDER / name).unlink()
    for name, text in new.items():
        (FOLDER / name).write_text(text)


if __name__ == "__main__":
    main()
