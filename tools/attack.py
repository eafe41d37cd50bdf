#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What does the program do with nonsense? Runs it, built with gfortran's checks and sanitizers, on every
option of every command with each of some 160 nasty values, then on random combinations of them:

   python3 tools/attack.py --seconds 120 --seed 7

Commands and options are asked of the program: `furiko --help`, `furiko COMMAND --help`. Each run has a
scratch folder of its own. What counts as a fault is said by `python3 tools/attack.py --rules`; faults go
to build/attack/faults.sh, each as a command that shows it, and the exit code is 1 if there are any.
--program PATH attacks a program that is there already; --self-test attacks one that misbehaves in every
way and looks whether all of it is found. See doc/robustness.md.
"""
import argparse
import collections
import hashlib
import itertools
import json
import multiprocessing
import os
import pathlib
import queue
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import xml.etree.ElementTree

import make_order

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build/attack"
COMPILER = os.environ.get("FPM_FC", "gfortran")
# -fno-backtrace, since gfortran's library would catch the signals of a crash and of a full file before those
# who are to see them
FLAGS = "-O1 -g -fcheck=all -fno-backtrace -fsanitize=address,undefined".split()
# gfortran's library does not free all it has at the end, so leaks are not looked for. An allocation that
# is too large fails, as it does elsewhere, rather than stop the program.
ENVIRONMENT = {
    "PATH": os.environ["PATH"], "HOME": "/nonexistent", "LC_ALL": "C.UTF-8", "UBSAN_OPTIONS": "print_stacktrace=0",
    "ASAN_OPTIONS": "detect_leaks=0:quarantine_size_mb=16:allocator_may_return_null=1:max_allocation_size_mb=2048:hard_rss_limit_mb=3000",
}
SECONDS = 10  # of the processor, for one run
BYTES = 1 << 20  # of a file, standard output among them: then comes EFBIG, as on a full disk
FEWEST_COMMANDS, FEWEST_OPTIONS = 12, 50
# As many steps as are asked for, and no row before the last of them: long is what was asked for.
LONG = {b"rk4": (b"--steps", b"--periods", b"--every"),
        b"driven": (b"--steps", b"--periods", b"--every", b"--transient", b"--points", b"--grid", b"--cycle", b"bifurcation",
                    b"lyapunov", b"attractors", b"basins")}

RULES = {
    "signal": "killed by a signal",
    "sanitizer": "a sanitizer spoke",
    "runtime": "Fortran's runtime library spoke, or a backtrace",
    "time": f"more than {SECONDS} s of the processor",
    "code": "an exit code that is none of 0, 1, 2, 3",
    "silent": "code 0, but nothing on standard output and no file",
    "missing": "code 0, but the file asked for is not there or empty",
    "noise": "code 0, but something on standard error",
    "mute": "another code, but nothing on standard error",
    "talk": "another code, but more than one line on standard error",
    "control": "a control character on standard error: it can do things to a terminal",
    "nameless": "a line on standard error that does not begin with the program's name",
    "half": "code 2, but something on standard output (eval: more rows than stand before the bad one)",
    "left": "another code than 0, and a new file, or an old one changed",
    "stray": "a new file that was not asked for, or an old one changed",
    "stars": "asterisks in the output: a number its column has no room for",
    "nan": "NaN in the output, and neither an argument nor the help says so",
    "json": "--format json, but not JSON",
    "xml": "an SVG file that is not XML",
    "output": "standard output is full or closed, and the code is 0",
    "unknown": "an option that the help has, but the command does not know",
}

# ---------------------------------------------------------------------------------------- the attacks

NUMBERS = """
0 -0 1 -1 +1 +-1 -- - + . -. e 1e e1 1e+ 1e- 1.5.5 1e5e5 .5 5. 1d3 1q3 1_8 1f
nan NaN -nan nan(1) inf -inf +inf Inf Infinity
1e999 -1e999 1e-999 1e99999999999 1e-99999999999 1e308 1.8e308 5e-324 4e-46 1e16 1e-16
179 179.999999999999999 180 180.000000000000001 -180 360 1e5 89.9999999999999999 0.3 90
2147483647 2147483648 -2147483648 -2147483649 4294967296 9223372036854775807 9223372036854775808
18446744073709551616 340282366920938463463374607431768211456 1000000000 1000001 10001
0x10 1E5 1,2 1;2 1,,2 ,1 1, , ;
1/0 0/0 1/3 -1/3 1/-3 1//3 1/ /1 / 1/3/5 1e300/1e-300 1e-300/1e300 2/1 1/1 0/1 1/1e999
2*3 2*
1deg 1degdeg 1rad 1degrad rad 1e3rad 1Rad 3.2rad 1m 25cm 1mcm 1s 500ms 2min 1sms
3% 3%% % -100% 300% 1° 1' 1" 1°30'15" 59°60'60" pi pi/2 2pi -pi
true false .true. T F text csv json xml TEXT csv,json all none list
800x500 300x300 8000x8001 x 0x0 800x 800X500 -800x500 99999x99999
time,angle time,time angle, rk4,error time,angle,harmonic,degrees,rate,energy,tension,turns,phase,rk4,error
""".split()

WORDS = [
    "", " ", "  ", "\t", " 1", "1 ", "1 2", "1\t2", "\n", "1\n", "1\n2", "\r", "1\r\n", "\x01", "\x1b[31m", "\x7f", "\x08\x08",
    "--help", "-h", "--version", "--list", "--nonsense", "-x", "--=", "--format=", "--format=json", "=", "=1", "--from=--to",
    "$(touch INJECTED)", "`touch INJECTED`", "; touch INJECTED", "| touch INJECTED", "< touch INJECTED", "|touch INJECTED",
    "& touch INJECTED &", "> INJECTED", "'; touch INJECTED; '", '"; touch INJECTED; "', '"', "'", "''", '""', "\\", "\\n", "$", "$HOME", "*",
    "?", "~", "!", "#", "%s%s%s%n", "%d", "{}", "[]", "{0}", "`", "@id", "^2", "_{x}",
    "'.system('touch INJECTED').'", '".system("touch INJECTED")."', "'\nsystem 'touch INJECTED'\n#", "<touch INJECTED", "<b>&amp;</b>", "]]>", "&#0;",
    "/dev/full", "/dev/null", "/dev/stdout", "/dev/stderr", "/dev/zero", "/", "//", ".", "..", "folder", "folder/", "folder/new", "../new", "../../a/new",
    "./new", "nowhere/new", "old", "old/new", "old.svg", "folder.svg", "link", "dangling", "-new", "new file", "a.part", "a" * 255, "a" * 256, "b" * 250,
    "/proc/self/mem", "/nowhere/x", "a/" * 2000 + "x",
    "ä", "°", "π", "½", "１", "٣", "−1", "1 2", "\ufeff1", "\u202e1", "😀", "\ufffe", "\uffff", "é", "1\u200b",
    "9" * 310, "9" * 10000, "0" * 10000 + "1", "0." + "0" * 10000 + "1", "1e" + "9" * 10000, "-" * 10000, "." * 10000,
    "1/" + "3" * 10000, "3" * 40 + "/" + "7" * 40, "0.1234567890123456", "0.12345678901234567890123456789012345678901234567890",
    "," * 60000, "1," * 30000, "time," * 10000 + "time", "x" * 100000,
]
BYTES_ONLY = [b"\xff", b"\xc0\xaf", b"\xed\xa0\x80", b"\xf4\x90\x80\x80", b"\xe2\x82", b"\x80", b"1\xb0", b"\xf8\x88\x80\x80\x80", b"\xfe\xff1"]
NASTY = [*dict.fromkeys([word.encode() for word in NUMBERS + WORDS] + BYTES_ONLY)]
# What is right for one option or another, so that a random line gets past the first check
PLAUSIBLE = [b"0.5", b"1", b"2", b"3", b"10", b"45", b"1/2", b"3%", b"1rad", b"csv", b"json", b"text", b"-1", b"100", b"90deg", b"0.1",
             b"verlet", b"forest-ruth", b"time,rk4,error", b"motion", b"phase", b"out.svg", b"out.html", b"-", b"real32", b"agm"]
# Contents of standard input beside the words, each a line
INPUTS = [
    b"", b"\n", b"\n\n\n", b"#", b"# no row\n", b"0.5", b"0.5\r\n", b"0.5\r0.5", b"\0", b"0.5\0\n", b"0.5\n\0\n", b"\xef\xbb\xbf0.5\n",
    b"\xff\xfe0\0.\x005\0\n\0", b"0.5 0.5 0.5 0.5 0.5 0.5\n", b"0.5,,0.5\n", b",0.5\n", b"0.5;0.5\n", b"0.5\t0.5\n", b"0.5 /\n", b"0.5/0.5\n",
    b"2*0.5\n", b"'0.5'\n", b"0.5 ! two\n", b"0.5 # two\n", b"&\n", b"0.5&\n", b"(0.5,0.5)\n", b"0.5\n" * 20000, b"0.5 " * 20000, b"0.5\n\n\n# x\n0.5\nx\n",
    b" " * 999 + b"0.5\n", b" " * 1000 + b"0.5\n", b" " * 5000, b"0." + b"3" * 997 + b"\n", b"0." + b"3" * 998 + b"\n", b"0." + b"3" * 999 + b"\n",
    b"#" + b"x" * 100000 + b"\n0.5\n", b"0.5\n0.5", b"inf\n", b"nan\n", b"-inf inf\n", b"nan nan nan nan\n", bytes(range(256)), b"\x1a\n0.5\n", b"\x0c\n", b"\x0b0.5\n",
]

OUTPUTS = b"-o", b"--output", b"--gif", b"--mp4"
HARMLESS = b"/dev/full", b"/dev/null", b"/dev/stdout", b"/dev/stderr", b"/", b"//", b"/proc/self/mem", b"/nowhere/x"

Case = collections.namedtuple("Case", "words stdin out bytes", defaults=(b"", "file", BYTES))


class Interface:
    """What the program says of itself: commands, their options, an example of each, functions, figures."""

    def __init__(self, program):
        self.program, self.unknown = program, []
        self.options, self.examples, self.may_say_nan = {}, {}, set()
        for line in self.ask(["--help"])[1].splitlines():
            match = re.match(r"\s+(?:furiko )?([a-z][\w-]*)(?:\s{2,}|\s*$| [A-Z\[-])", line)
            if match and match.group(1) not in self.options:
                self.meet(match.group(1))
        if "eval" in self.options:
            self.functions = [line.split()[0].encode() for line in self.ask(["eval", "--list"])[1].splitlines()]
        else:
            self.functions = []

    def ask(self, words):
        done = subprocess.run([self.program, *words], capture_output=True, text=True, errors="replace", timeout=60,
                              stdin=subprocess.DEVNULL, env=ENVIRONMENT)
        return done.returncode, done.stdout, done.stderr

    def meet(self, command):
        code, text, _ = self.ask([command, "--help"])
        if code or "furiko " + command not in text:
            return
        lines = text.splitlines()
        usage = list(itertools.takewhile(str.strip, lines))
        listed = [line for line in lines if re.match(r"\s+-", line)]
        option = re.compile(r"(?<![\w-])--?[a-z][\w-]*")
        wanted = dict.fromkeys(name for line in usage + listed for name in option.findall(line))
        # What the command says of a word it does not know is learnt from one that no command can know.
        stranger = "--qqqq"
        refusal = self.ask([command, stranger])
        options = [name for name in wanted if self.ask([command, name]) != (
            refusal[0], refusal[1], refusal[2].replace(stranger, name))]
        # The text behind an option may speak of another program's
        self.unknown += [f"{command} {name}" for name in wanted if name not in options
                         and any(line.split()[0].rstrip(",") == name for line in listed)]
        self.options[command] = [name.encode() for name in options if name not in ("-h", "--help")]
        examples = re.findall(rf"^ +(?:echo (\S+) \| )?furiko ({command}(?: .*)?)$", text, re.M)
        stdin, words = examples[-1] if examples else ("", command)
        self.examples[command] = Case([word.encode() for word in words.split()], stdin.encode())
        if re.search(r"\bnan\b", text, re.I):
            self.may_say_nan.add(command.encode())

    def suspicious(self):
        count = sum(map(len, self.options.values()))
        if len(self.options) < FEWEST_COMMANDS or count < FEWEST_OPTIONS:
            return f"{len(self.options)} commands and {count} options are suspiciously few"
        if self.options.get("eval") is None or len(self.functions) < 100:
            return "suspiciously few functions in eval --list"
        return ""


def without(words, option):
    """A command line without an option and its value"""
    words = list(words)
    if option in words:
        at = words.index(option)
        del words[at:at + (2 if words[at + 1:] and not words[at + 1].startswith(b"-") else 1)]
    return words


def each_against_each(interface, chance):
    """Every option with every value, every place of the example with every value, in an order by chance"""
    for command, options in interface.options.items():
        example = interface.examples[command]
        name = command.encode()
        for option in options:
            base = without(example.words, option)
            for value in NASTY:
                yield example._replace(words=chance.choice([
                    [*base, option, value], [*base, option, value], [*base, option + b"=" + value]
                    if option.startswith(b"--") else [name, option, value, *base[1:]]]))
                if option in OUTPUTS and len(value) < 3000:
                    ending = chance.choice([b".svg", b".svg", b".png", b".pdf"])
                    yield example._replace(words=[*base, option, value + ending])
            yield example._replace(words=[*base, option])
            yield example._replace(words=[*base, option, b"1", option, b"1"])
        for value in NASTY:
            yield example._replace(words=[*example.words, value])
            yield example._replace(words=[name, value])
            for i, (before, word) in enumerate(zip(example.words, example.words[1:]), 1):
                if not word.startswith(b"-") and not before.startswith(b"-"):
                    yield example._replace(words=[*example.words[:i], value, *example.words[i + 1:]])
        for out in "full", "closed":
            yield example._replace(out=out)
            yield example._replace(words=[name, b"--help"], out=out)
        for words in example.words, [*example.words, b"-o", b"old.svg"], [*example.words, b"-o", b"new.svg"]:
            yield example._replace(words=words, bytes=1000)
    for value in NASTY:
        yield Case([value])
        yield Case([b"--from", value])
    for function in interface.functions:
        yield Case([b"eval", function], b"0.5 0.5 0.5 0.5\n")
    for text in INPUTS + [value + b"\n" for value in NASTY]:
        for kind in b"real32", b"real64", b"real128":
            yield Case([b"eval", chance.choice(interface.functions), b"--kind", kind], text)
            yield Case([b"eval", b"ellipk_m", b"--kind", kind], text)


def random_cases(interface, chance):
    """Without end: a command or what is none, options, values nasty and plausible"""
    commands = [name.encode() for name in interface.options]

    def value():
        if chance.random() < 0.5:
            return chance.choice(PLAUSIBLE)
        nasty = chance.choice(NASTY)
        if chance.random() < 0.2:
            nasty += chance.choice(NASTY)[:1000]
        return nasty

    while True:
        command = chance.choice(commands)
        options = interface.options[command.decode()] or [b"--format"]
        words = list(interface.examples[command.decode()].words) if chance.random() < 0.6 else [command]
        for _ in range(chance.choice([1, 2, 2, 2, 3, 4])):
            option = chance.choice(options)
            words += chance.choice([[option, value()], [option, value()], [option + b"=" + value()], [option], [value()]])
        text = b"".join(chance.choice([value(), chance.choice(INPUTS)[:5000]]) + chance.choice([b" ", b"\n", b",", b""])
                        for _ in range(chance.randrange(6))) if command == b"eval" else b""
        yield Case(words, text)


def stays_inside(case):
    """Whether no file can be made outside of the scratch folder: nothing absolute but what is no plain file"""
    name = output_of(case.words)
    if name.startswith(b"/"):
        return name in HARMLESS
    return os.path.normpath(b"/root/a/b/" + name).startswith(b"/root/")


def all_cases(interface, seed):
    """How many there are of each against each, and all without end"""
    chance = random.Random(seed)
    first = list(filter(stays_inside, each_against_each(interface, chance)))
    chance.shuffle(first)
    return len(first), itertools.chain(first, filter(stays_inside, random_cases(interface, chance)))


# ------------------------------------------------------------------------------------------- one run

class Place:
    """A scratch folder a/b, with an old file, a folder and two links, and what lies around it"""

    def __init__(self, root):
        self.root, self.home = root, os.path.join(root, b"a/b")
        self.make()

    def make(self):
        shutil.rmtree(self.root, ignore_errors=True)
        for folder in b"folder", b"folder.svg":
            os.makedirs(os.path.join(self.home, folder))
        for name in b"old", b"old.svg":
            with open(os.path.join(self.home, name), "wb") as file:
                file.write(b"as it was\n")
        os.symlink(b"old", os.path.join(self.home, b"link"))
        os.symlink(b"nothing", os.path.join(self.home, b"dangling"))
        self.before = self.look()

    def look(self):
        """Each file, to its size and time"""
        seen = {}
        for folder, folders, files in os.walk(self.root):
            for name in folders + files:
                path = os.path.join(folder, name)
                state = os.lstat(path)
                seen[path] = (state.st_mode, state.st_size, state.st_mtime_ns) if name not in folders else ()
        return seen

    def changed(self):
        now = self.look()
        return {path for path in now.keys() | self.before.keys() if now.get(path) != self.before.get(path)}

    def absolute(self, name):
        return os.path.normpath(os.path.join(self.home, name))


def end(process):
    """And all that it started"""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def run(program, case, place, spool):
    """Code, standard output, standard error; None for the code where time was up"""
    command = [program, *case.words]
    if case.out == "closed":
        command = ["/bin/sh", "-c", 'exec "$0" "$@" >&-', *command]
    out = open("/dev/full", "wb") if case.out == "full" else open(spool, "w+b")
    with out, open(spool + b".in", "w+b") as source, open(spool + b".err", "w+b") as errors:
        source.write(case.stdin)
        source.seek(0)
        # Limits are inherited, or set from here: a preexec_fn would have Python fork, which takes longer than
        # the run. SIGXFSZ stays ignored, as in Python, so that a full file shows as an error.
        resource.setrlimit(resource.RLIMIT_FSIZE, (case.bytes, resource.RLIM_INFINITY))
        process = subprocess.Popen(command, cwd=place.home, env=ENVIRONMENT, stdin=source, stdout=out, stderr=errors,
                                   restore_signals=False, start_new_session=True)
        resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        resource.prlimit(process.pid, resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))
        # For what waits; wait(timeout) would look every 50 ms only
        clock = threading.Timer(12*SECONDS, end, (process,))
        clock.start()
        code = process.wait()
        if not clock.is_alive() or code == -signal.SIGXCPU:
            end(process)
            code = None
        clock.cancel()
        errors.seek(0)
        said = errors.read()
        text = b""
        if case.out == "file":
            out.seek(0)
            text = out.read()
    return code, text, said


def output_of(words):
    """The file that a command line names as its output, none for standard output"""
    name = b""
    values = iter(words)
    for word in values:
        if word in OUTPUTS:
            name = next(values, b"")
        elif word == b"--title":
            next(values, b"")
        elif word.split(b"=", 1)[0] in OUTPUTS[1:]:
            name = word.split(b"=", 1)[1]
    return b"" if name == b"-" else name


def rows_of(text):
    return [row for row in text.replace(b"\r", b"\n").split(b"\n") if row.strip(b" \t\0,") and not row.strip().startswith(b"#")]


def judge(case, code, out, said, place, interface):
    """Which rules a run breaks"""
    broken, command = [], case.words[0] if case.words else b""

    def rule(name, holds):
        if holds:
            broken.append(name)

    output = output_of(case.words)
    named = [place.absolute(output)] if output else []
    # Where a link leads
    asked = [os.path.realpath(path) for path in named]
    beside = [os.path.splitext(path)[0] + ending for path in named for ending in (b".csv", b".gp")
              if b"--data" in case.words or code == 3]
    new = place.changed()
    files = {path for path in new if place.before.get(path, 0) != ()}
    if code is None:
        rule("time", not any(word in case.words or any(w.startswith(word + b"=") for w in case.words)
                             for word in LONG.get(command, ())))
        return broken
    rule("signal", code < 0)
    rule("sanitizer", re.search(rb"Sanitizer|:\d+:\d+: runtime error:", said))
    rule("runtime", re.search(rb"Fortran runtime|Backtrace|Error termination|forrtl|Program received|^#\d+ ", said, re.M))
    rule("code", code > 3)
    if code < 0 or code > 3 or broken:
        return broken
    rule("stars", re.search(rb"\*\*\*", out))
    rule("nan", re.search(rb"\bnan\b", out, re.I) and not out.startswith(b"<!doctype html>") and command not in interface.may_say_nan
         and not any(re.search(rb"nan", word, re.I) for word in case.words))
    if code == 0:
        in_dev = output.startswith((b"/dev/", b"/proc/"))
        no_rows = command == b"eval" and not rows_of(case.stdin)
        rule("output", case.out != "file" and not (in_dev or asked))
        rule("silent", case.out == "file" and not out and not files and not in_dev and not no_rows)
        rule("missing", files and any(not os.path.isfile(path) or not os.path.getsize(path) for path in asked))
        rule("noise", said and not in_dev)
        rule("stray", files - set(asked) - set(beside))
        formats = [b for a, b in zip(case.words, case.words[1:]) if a == b"--format"]
        formats += [b[9:] for a, b in zip([b""] + case.words, case.words)
                    if b.startswith(b"--format=") and a not in (b"-o", b"--output", b"--title", b"--")]
        rule("json", formats[-1:] == [b"json"] and not any(word in (b"--help", b"-h", b"--list") for word in case.words) and not is_json(out))
        rule("xml", any(path.endswith(b".svg") and path in files and command == b"plot" and not is_xml(path) for path in asked))
        return broken
    lines = said.split(b"\n")
    rule("mute", not said)
    rule("talk", said and (len(lines) != 2 or lines[1]))
    rule("control", re.search(rb"[\x00-\x09\x0b-\x1f\x7f]", said))
    rule("nameless", said and not said.startswith(b"furiko"))
    rule("left", files - (set(beside) if code == 3 else set()))
    line = re.search(rb"line (\d+)", said)
    answered = int(line.group(1)) - 1 if command == b"eval" and line else 0
    rule("half", code == 2 and out.count(b"\n") > answered)
    return broken


def is_json(text):
    try:
        json.loads(text, parse_constant=lambda name: 1/0)
        return True
    except (ValueError, ZeroDivisionError):
        return False


def is_xml(path):
    try:
        xml.etree.ElementTree.parse(os.fsdecode(path))
        return True
    except xml.etree.ElementTree.ParseError:
        return False


# ------------------------------------------------------------------------------------------ the report

def quoted(word):
    """For bash, what is long by a loop"""
    match = re.fullmatch(rb"(.{0,3}?)((.{1,5}?)\3{199,})(.{0,50})", word, re.S)
    if match:
        count = len(match.group(2))//len(match.group(3))
        return "%s\"$(printf -- '%s%%.0s' {1..%d})\"%s" % (
            quoted(match.group(1)) if match.group(1) else "", match.group(3).decode("latin1").replace("%", "%%"), count,
            quoted(match.group(4)) if match.group(4) else "")
    if re.fullmatch(rb"[\w./:,%+=@-]+", word):
        return word.decode()
    return "$'" + "".join(chr(b) if 32 <= b < 127 and b not in b"'\\" else f"\\x{b:02x}" for b in word) + "'"


def as_command(case):
    line = "furiko " + " ".join(map(quoted, case.words))
    if case.stdin:
        # printf knows no \0 by a quoted word
        text = quoted(case.stdin) if b"\0" not in case.stdin else "'" + "".join(f"\\{b:03o}" for b in case.stdin) + "'"
        line = ("printf '%s' " if b"\0" not in case.stdin else "printf ") + text + " | " + line
    limit = f"ulimit -f {case.bytes/1024:g}; " if case.bytes != BYTES else ""
    return limit + line + {"file": "", "full": " >/dev/full", "closed": " >&-"}[case.out]


def attacker(number, options, interface, until, total, results):
    """One of several: each jobs-th case, until time is up or, without a limit, all and so many by chance"""
    scratch = tempfile.mkdtemp(prefix="furiko-attack-").encode()
    place = Place(os.path.join(scratch, b"run"))
    _, cases = all_cases(interface, options.seed)
    last = None if until else total + options.random
    done = 0
    try:
        for case in itertools.islice(cases, number, last, options.jobs):
            if until and time.time() > until:
                break
            code, out, said = run(interface.program, case, place, os.path.join(scratch, b"spool"))
            broken = judge(case, code, out, said, place, interface)
            if place.changed():
                place.make()
            done += 1
            for rule in broken or [None]:
                results.put((code, rule, case if rule else None, (said or out)[:300]))
    finally:
        shutil.rmtree(scratch, ignore_errors=True)
        results.put(None)


def attack(options, interface):
    """All runs; the faults by rule"""
    total, _ = all_cases(interface, options.seed)
    began = time.time()
    until = began + options.seconds if options.seconds else 0
    results = multiprocessing.Queue()
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    workers = [multiprocessing.Process(target=attacker, args=(i, options, interface, until, total, results))
               for i in range(options.jobs)]
    for worker in workers:
        worker.start()
    codes, faults, left = collections.Counter(), collections.defaultdict(list), len(workers)
    while left:
        try:
            result = results.get(timeout=20*SECONDS)
        except queue.Empty:
            sys.exit("attack: the attackers are silent")
        if result is None:
            left -= 1
            continue
        code, rule, case, said = result
        if rule is None or not faults[rule] or faults[rule][-1][0] is not case:
            codes["time" if code is None else code] += 1
        if rule:
            faults[rule].append((case, code, said))
    for worker in workers:
        worker.join()
    seconds = time.time() - began
    runs = sum(codes.values())
    print(f"{runs} runs in {seconds:.0f} s, {runs/seconds:.0f} a second; "
          f"{min(runs, total)} of {total} of each against each, {max(0, runs - total)} by chance")
    print("exit codes: " + ", ".join(f"{code}: {n}" for code, n in sorted(codes.items(), key=lambda item: str(item[0]))))
    return {rule: found for rule, found in faults.items() if found}


def report(faults, show):
    BUILD.mkdir(parents=True, exist_ok=True)
    with (BUILD / "faults.sh").open("w") as file:
        file.write("# Each fault, for bash in an empty folder, furiko being build/attack/furiko; see tools/attack.py --rules\n")
        for rule, found in sorted(faults.items()):
            print(f"{rule}: {len(found)}, {RULES[rule]}")
            shown = set()
            for case, code, said in found:
                file.write(f"\n# {rule}, code {code}, said: {said!r}\n{as_command(case)}\n")
                # One a command on the screen, the rest in the file
                if case.words[:1] and (first := case.words[0]) not in shown and len(shown) < show:
                    shown.add(first)
                    print(f"   {as_command(case)[:300]}\n      code {code}: {said[:120]!r}")


# ------------------------------------------------------------------------------------------- the build

def build():
    """The program with checks and sanitizers, anew where a source has changed"""
    program, stamp = BUILD / "furiko", BUILD / "stamp"
    units = make_order.order("src") + make_order.order("app")
    text = b"".join(path.read_bytes() for folder in ("src", "app") for path in sorted((ROOT / folder).rglob("*")) if path.is_file())
    key = hashlib.sha256(text + " ".join([COMPILER, *FLAGS, *units]).encode()).hexdigest()
    if program.exists() and stamp.exists() and stamp.read_text() == key:
        return str(program)
    BUILD.mkdir(parents=True, exist_ok=True)
    stamp.unlink(missing_ok=True)
    objects = []
    for unit in units:
        objects.append(pathlib.Path(unit).stem + ".o")
        subprocess.run([COMPILER, *FLAGS, "-c", str(ROOT / unit), "-o", objects[-1]], cwd=BUILD, check=True)
    subprocess.run([COMPILER, *FLAGS, *objects, "-o", "furiko"], cwd=BUILD, check=True)
    stamp.write_text(key)
    return str(program)


# --------------------------------------------------------------------------------------- the self-test

# A program that breaks one rule a command
MISBEHAVING = {
    "signal": "kill -SEGV $$", "sanitizer": "echo 'x.f90:1:2: runtime error: overflow' >&2; exit 2",
    "runtime": "echo 'Fortran runtime error: End of record' >&2; exit 2", "time": "while :; do :; done", "code": "echo furiko >&2; exit 9",
    "silent": "exit 0", "missing": "echo x; : >out.svg", "noise": "echo x; echo furiko >&2", "mute": "exit 2",
    "talk": "printf 'furiko\\nfuriko\\n' >&2; exit 2", "control": "printf 'furiko \\033[1m\\n' >&2; exit 2", "nameless": "echo no >&2; exit 2",
    "half": "echo half; echo furiko: no >&2; exit 2", "left": "echo x >out.svg; echo furiko: no >&2; exit 1", "stray": "echo x; echo y >INJECTED",
    "stars": "echo ' 1.0 ****'", "nan": "echo ' 1.0 NaN'", "json": "echo '[1,'", "xml": "echo '<svg>' >out.svg", "output": "exit 0",
}


def self_test():
    """Each rule is broken by one command of a fake program, and by it alone; and a good program by none"""
    wrong = []
    scratch = tempfile.mkdtemp(prefix="furiko-attack-")
    program = os.path.join(scratch, "furiko")
    with open(program, "w") as file:
        # Standard output is closed for one rule: a shell's echo would say so
        file.write("#!/bin/bash\ncase $1 in\n" + "".join(f"{name}) {body} ;;\n" for name, body in MISBEHAVING.items())
                   + "good) echo ' 1.0 2.0' ;;\nrefuse) echo 'furiko refuse: no' >&2; exit 2 ;;\nesac\n")
    os.chmod(program, 0o755)
    place = Place(os.path.join(scratch, "run").encode())

    class Fake:
        may_say_nan = set()
    special = {"missing": [b"-o", b"out.svg"], "left": [b"-o", b"out.svg"], "json": [b"--format", b"json"], "xml": [b"-o", b"out.svg"]}
    for name in [*MISBEHAVING, "good", "refuse"]:
        word = b"plot" if name == "xml" else b"any"
        case = Case([name.encode(), *special.get(name, [])], out="full" if name == "output" else "file")
        code, out, said = run(program, case, place, os.path.join(scratch, "spool").encode())
        broken = judge(case._replace(words=[word, *case.words[1:]]), code, out, said, place, Fake)
        place.make()
        if broken != ([name] if name in RULES else []):
            wrong.append(f"{name} is found as {broken}")
    with open(program, "w") as file:
        file.write("#!/bin/bash\ncase \"$*\" in\n--help) echo '  table   t' ;;\n'table --help') printf 'furiko table\\n\\n  --lost X  x\\n' ;;\n"
                   "*) echo \"furiko: unknown '$2'\" >&2; exit 2 ;;\nesac\n")
    found = Interface(program)
    if found.unknown != ["table --lost"]:
        wrong.append(f"an option that is not known: {found.unknown}")
    if "suspiciously few" not in found.suspicious():
        wrong.append("one command is not too few")
    shutil.rmtree(scratch)
    untested = set(RULES) - set(MISBEHAVING) - {"unknown"}
    if untested:
        wrong.append(f"no test for {untested}")
    print("\n".join(wrong) or f"self-test: each of {len(RULES)} rules is seen to fire")
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=7, help="of the order and of the random part (7)")
    parser.add_argument("--seconds", type=float, default=0, help="stop after so many; without, all and the random ones")
    parser.add_argument("--random", type=int, default=5000, help="how many random lines where no time is given (5000)")
    parser.add_argument("--jobs", type=int, default=2, help="runs at once (2)")
    parser.add_argument("--show", type=int, default=5, help="commands shown for each rule (5)")
    parser.add_argument("--program", help="a program that is built already")
    parser.add_argument("--rules", action="store_true", help="what is a fault")
    parser.add_argument("--self-test", action="store_true", help="whether each rule finds what breaks it")
    options = parser.parse_args()
    if options.rules:
        print("\n".join(f"{name:10} {text}" for name, text in RULES.items()))
        return 0
    if options.self_test:
        return self_test()
    interface = Interface(os.path.abspath(options.program) if options.program else build())
    if interface.suspicious():
        print("attack:", interface.suspicious())
        return 1
    print(f"{len(interface.options)} commands, {sum(map(len, interface.options.values()))} options, "
          f"{len(NASTY)} values, {len(INPUTS)} inputs, {len(interface.functions)} functions")
    faults = attack(options, interface)
    for name in interface.unknown:
        faults.setdefault("unknown", []).append((Case([word.encode() for word in name.split()]), 2, b""))
    report(faults, options.show)
    count = sum(map(len, faults.values()))
    print(f"{count} faults" + (", in build/attack/faults.sh" if count else ""))
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
