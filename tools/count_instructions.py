#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Has a function become slower? python3 tools/count_instructions.py

Counts the instructions of every function of the catalogue, one call at a time and as arrays, and of the
objects, at fixed points (bench/app/counts.F90, by valgrind), and compares them with those in
bench/counts.txt: fails where one is off by more than 3 %, faster or slower, says where and by how much.
`--store` writes bench/counts.txt anew: call it when a change of speed is meant, and commit the file.

Counted is the library's own code. Not counted, since they differ with the processor or the machine's
libraries: libm, libc, libgfortran, libquadmath and libgcc, which does the arithmetic of real128; calls of
them are counted instead, in a column of their own. The counts are those of gfortran 12 on x86-64, -O3; with another compiler
or processor there is nothing to compare.
"""
import collections
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
STORED = ROOT / "bench/counts.txt"
ALLOWED = 0.03
COUNTERS = ["sp_MOD_count_one", "sp_MOD_count_many", "dp_MOD_count_one", "dp_MOD_count_many", "qp_MOD_count_one",
            "qp_MOD_count_many", "objects_MOD_count_object"]
# What calls the functions, and is not counted
CALLERS = re.compile(r"MAIN__|main|\(below main\)|(say|count_function)\..*|__(furiko_by_name|bench_counts)_.._MOD_.*"
                     r"|__furiko_catalogue_MOD_.*")


def reason_to_skip():
    version = subprocess.run(["gfortran", "-dumpversion"], capture_output=True, text=True).stdout.strip()
    if platform.machine() != "x86_64" or version.partition(".")[0] != "12":
        return f"the stored ones are gfortran 12's on x86_64, here is {version}'s on {platform.machine()}"
    return None


def fpm():
    return subprocess.run([ROOT / "tools/fpm-path"], check=True, capture_output=True, text=True).stdout.strip()


def profiles(folder):
    """What was called and how often, and valgrind's profile of each, in the same order"""
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/profile"]
    command += [f"--dump-after=__bench_counts_{name}" for name in COUNTERS]
    run = subprocess.run(
        ["env", "LD_BIND_NOW=1", "FPM_CC=gcc", "FPM_CXX=g++", fpm(), "run", "counts", "--profile", "release",
         "--cxx-flag", "-O3", "--runner", " ".join(command)],
        cwd=ROOT / "bench", capture_output=True, text=True)
    called = re.findall(r"^(.*) \| (real.*|not counted) \| (\d+)$", run.stdout, re.M)
    if run.returncode != 0 or not called:
        sys.exit(run.stdout + run.stderr)
    for i, (name, form, calls) in enumerate(called, 1):
        yield name, form, int(calls), (folder / f"profile.{i}").read_text()


def own_costs(profile):
    """Instructions in the program's own object, and calls from there into others; of functions, not callers

    The format: https://valgrind.org/docs/manual/cl-format.html
    """
    names = {}

    def name(kind, text):
        number, _, known = text.partition(" ")
        if known:
            names[kind, number] = known
        return names[kind, number]

    def own(place):
        return place.endswith("/app/counts")

    costs = collections.Counter()
    place, function, other, called = "", "", None, False
    for line in profile.splitlines():
        key, equals, text = line.partition("=")
        counted = own(place) and not CALLERS.fullmatch(function)
        if equals and key == "ob":
            place = name("ob", text)
        elif equals and key == "fn":
            function = name("fn", text)
        elif equals and key == "cob":
            other = name("ob", text)
        elif equals and key == "cfn":
            name("fn", text)
        elif equals and key == "calls":
            if counted and other and not own(other):
                costs["calls"] += int(text.split()[0])
            other, called = None, True
        elif re.match(r"[+*\-\d]", line):
            if counted and not called:
                costs["instructions"] += int(line.split()[1])
            called = False
    return costs


def counted():
    """(function, form): (instructions a call, calls of other libraries a call)"""
    with tempfile.TemporaryDirectory() as folder:
        return {(name, form): tuple(round(own_costs(profile)[what] / calls, 2) for what in ("instructions", "calls"))
                for name, form, calls, profile in profiles(pathlib.Path(folder)) if form != "not counted"}


def store(counts):
    lines = [" | ".join([*key, f"{own:.2f}", f"{others:.2f}"]) for key, (own, others) in counts.items()]
    STORED.write_text("# Instructions a call, and calls of libm and the like, by tools/count_instructions.py --store\n"
                      + "\n".join(lines) + "\n")


def stored():
    rows = [line.split(" | ") for line in STORED.read_text().splitlines() if not line.startswith("#")]
    return {(name, form): (float(own), float(others)) for name, form, own, others in rows}


def differences(old, new):
    for key in sorted(old.keys() | new.keys()):
        name = ", ".join(key)
        if key not in new or key not in old:
            yield f"{name}: {'new' if key in new else 'gone'}"
            continue
        for what, before, after in zip(("instructions", "calls of other libraries"), old[key], new[key]):
            if abs(after - before) > max(ALLOWED * before, 0.02):
                change = f"{100 * (after / before - 1):+.1f} %" if before else "new"
                yield f"{name}: {after:.2f} {what} a call, were {before:.2f} ({change})"


def main():
    reason = reason_to_skip()
    if reason:
        print(f"count_instructions: skipped, {reason}")
        return
    if not shutil.which("valgrind"):
        sys.exit("count_instructions: valgrind is missing (Debian: apt-get install valgrind)")
    new = counted()
    if "--store" in sys.argv:
        store(new)
        return
    found = list(differences(stored(), new))
    print("\n".join(found) or f"{len(new)} counts of instructions are what they were")
    if found:
        sys.exit("\nIf this is meant: python3 tools/count_instructions.py --store, and commit bench/counts.txt")


main()
