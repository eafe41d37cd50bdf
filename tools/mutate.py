#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Do the tests see? Puts small faults, one at a time, into src/ and app/ and runs the tests on each:

   python3 tools/mutate.py --seed 7 --count 60

The seed says which faults; a larger count goes on where a smaller one ended, and so does a run that
was interrupted. Results are lines of build/mutate/seed-7.txt, the last one of a fault counts.
--survivors puts in again what survived, --again everything; --score only counts; --list shows the
faults; --trust does not try first whether the tests pass as they are. Faults that change no behaviour stand in tools/mutants-equivalent.txt with the reason.
Needs gfortran and GSL, and as many cores as --jobs says (2). See doc/robustness.md.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
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
import traceback

import make_order

ROOT = pathlib.Path(__file__).resolve().parent.parent
RESULTS = ROOT / "build/mutate"
EQUIVALENT = ROOT / "tools/mutants-equivalent.txt"
COMPILER = os.environ.get("FPM_FC", "gfortran")
FLAGS = os.environ.get("MUTATE_FLAGS", "-O1 -fcheck=bounds").split()
LIBRARIES = ["-lgsl", "-lgslcblas"]

# ---------------------------------------------------------------------------------------- the faults

IDENTIFIER = r"[a-z]\w*(?:%\w+)*"
OPERAND = rf"(?:{IDENTIFIER}|\d[\w.]*)"
# What is no statement of the algorithm
PASSIVE = re.compile(
    r"\s*(?:use|implicit|private|public|import|interface|end|contains|module|submodule|include|#|"
    r"(?:(?:pure|elemental|impure|recursive)\s+)*(?:subroutine|function)|procedure|generic|type\b(?!\w)"
    r"(?!\()|else\s*$|program|intrinsic|allocate|select|!|class\s+default)",
    re.I,
)
# One for the other
WORDS = {
    "sn": "cn", "cn": "dn", "dn": "cn", "m": "mc", "mc": "m", "min": "max", "max": "min",
    "nan": "infinity", "infinity": "nan", "huge": "tiny", "tiny": "huge", "sin": "cos", "cos": "sin",
    "any": "all", "all": "any", "floor": "nint", "ceiling": "floor", "cycle": "exit", "exit": "cycle",
    "x": "y", "y": "x", "a": "b", "b": "a", "sinh": "cosh", "cosh": "sinh", "k": "m", "lo": "hi", "hi": "lo",
}
COMPARED = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "/=", "/=": "=="}
# The number within epsilon(1.0_wp) is no value
NO_INQUIRY = "".join(rf"(?<!\b{word}\()" for word in ("digits", "epsilon", "huge", "tiny", "exponent", "kind"))
NAMED = re.compile(r"\b(?:ellip|jacobi_|carlson_|theta|nome_|period_|put_|is_|two_|read_)\w*")


def parts_of(line):
    """The spans of a line that are code and those that are text within quotation marks."""
    code, text, start, quote = [], [], 0, ""
    for i, letter in enumerate(line):
        if quote:
            if letter == quote:
                text.append((start, i))
                start, quote = i + 1, ""
        elif letter in "'\"":
            code.append((start, i))
            start, quote = i + 1, letter
        elif letter == "!":
            code.append((start, i))
            return code, text
    code.append((start, len(line)))
    return code, text


def other_real(match):
    """A constant with a digit of its front changed"""
    number = match.group()
    at = [i for i, c in enumerate(re.match(r"[\d.]+", number).group()) if c != "."]
    i = at[min(len(at) - 1, 5)]
    return number[:i] + str((int(number[i]) + 1) % 10) + number[i + 1:]


def other_text(match):
    """A letter changed to the next"""
    word = match.group()
    i = len(word)//2
    return word[:i] + chr(ord(word[i]) + (-1 if word[i] in "zZ9" else 1)) + word[i + 1:]


def sites(path, lines):
    """All faults of a file: (line number from 0, kind, line that results)"""
    found, head, names = [], "", []
    continued = fresh = False
    for n, line in enumerate(lines):
        code, text = parts_of(line)
        bare = line[:code[-1][1]] if code[-1][1] > code[-1][0] or not text else line
        if not bare.strip():
            continue
        if not continued:
            head = bare
        fresh = not continued
        continued = bare.rstrip().endswith("&")
        declares = "::" in head
        passive = PASSIVE.match(head) or (declares and "=" not in head and "'" not in head)
        if passive or re.match(r"\s*(?:real|integer|logical|type|character)\b[^=]*$", bare):
            if not (declares and not fresh and "parameter" in head):
                continue
        first = bare.find("::") + 2 if declares and fresh else 0

        def put(kind, pattern, change, where):
            for match in re.finditer(pattern, bare):
                if match.start() >= first and any(a <= match.start() and match.end() <= b for a, b in where):
                    new = change(match) if callable(change) else match.expand(change)
                    if new != match.group():
                        found.append((n, kind, line[:match.start()] + new + line[match.end():]))

        span = [(0, len(bare))] if not text else code
        put("comparison", r"(?<=\s)(?:<=|>=|==|/=|<|>)(?=\s)", lambda m: COMPARED[m.group()], code)
        put("sign", r"(?<=[\w)\]] )[+-](?= )", lambda m: "-" if m.group() == "+" else "+", code)
        put("sign", r"(?<=[(=,] )-(?=\w)|(?<=\()-(?=[a-z])", "", code)
        put("factor", r"(?<=[\w)])[*/](?=[\w(])(?!\*)", lambda m: "/" if m.group() == "*" else "*", code)
        put("constant", rf"{NO_INQUIRY}(?<![\w.%])\d+\.\d*(?:[ed][+-]?\d+)?", other_real, code)
        put("constant", r"(?<![\w.%])\d+(?![\w.])", lambda m: str(int(m.group()) + 1), code)
        put("constant", r"(?<![\w.%])[1-9]\d*(?![\w.])", lambda m: str(int(m.group()) - 1), code)
        put("term", rf" [+-] {OPERAND}(?=[\s,)])|(?<=[\w)])[*/]{OPERAND}(?=[\s,)])", "", code)
        put("logical", r"\.and\.|\.or\.", lambda m: ".or." if "and" in m.group() else ".and.", code)
        put("logical", r"\.not\. ", "", code)
        put("logical", r"\.true\.|\.false\.", lambda m: ".false." if "true" in m.group() else ".true.", code)
        put("arguments", rf"(?<!max)(?<!min)\(({OPERAND}), ({OPERAND})(?=[,)])", r"(\2, \1", span)
        put("name", r"(?<![\w%'])[a-z]+(?![\w'])(?!\s*=[^=])", lambda m: WORDS.get(m.group(), m.group()), code)
        put("index", r"(?<=\w)\(([ijn])\)", r"(\1 + 1)", code)
        if not declares:
            put("magnitude", r"\babs\(", "(", code)
            if fresh and not continued:
                if re.match(rf"\s*(?:{IDENTIFIER}(?:\([^=]*\))? = |call )", bare):
                    found.append((n, "statement", re.match(r"\s*", bare).group() + "continue"))
                put("condition", r"(?<=if )\((.*)\)(?= then| \w| \()", r"(.not. (\1))", span)
        seen = NAMED.findall(bare)
        for name in dict.fromkeys(seen):
            like = [old for old in names if old != name and old.split("_")[0] == name.split("_")[0]]
            if like and not declares:
                put("name", rf"\b{name}\b", like[-1], code)
        names += seen
        # Text that a format or a file's mode is made of, no word: left alone
        if text and ("app/" in path or "catalogue" in path) and "open(" not in head:
            for a, b in text:
                if not re.match(r"\(.*\)$", line[a:b]):
                    put("text", r"[A-Za-z0-9]+(?:[^\w']+[A-Za-z0-9]+)?", other_text, [(a, b)])
    return found


class Fault:
    def __init__(self, path, number, kind, old, new, nth):
        self.path, self.number, self.kind, self.old, self.new = path, number, kind, old, new
        # No line number, so that a result holds when lines are added elsewhere in the file
        self.key = f"{path}: {old.strip()} => {new.strip()}" + (f" ({nth})" if nth > 1 else "")

    @property
    def change(self):
        return self.path, f"{self.old.strip()} => {self.new.strip()}"

    def __str__(self):
        return f"{self.path}:{self.number + 1}  {self.kind}  {self.old.strip()}  =>  {self.new.strip()}"


def all_faults(seed):
    """Every line once, in an order by the seed, with one of its faults, which depends on nothing else"""
    lines = {}
    for folder in "src", "app":
        for file in sorted((ROOT / folder).rglob("*")):
            if file.suffix.lower() not in (".f90", ".inc"):
                continue
            text = file.read_text()
            if re.search(r"ritten by \S+\.py", text[:4000]):
                continue
            path = str(file.relative_to(ROOT))
            rows = text.split("\n")
            for n, kind, new in sites(path, rows):
                nth = rows[:n + 1].count(rows[n])
                lines.setdefault((path, rows[n], nth), []).append(Fault(path, n, kind, rows[n], new, nth))
    for place in sorted(lines, key=lambda place: random.Random(f"{seed}{place}").random()):
        chance = random.Random(f"{seed}{place}!")
        # The kind first, since every line has more signs and constants than conditions,
        # and dropped statements, which are seen most easily, where there is little else.
        kinds = sorted({fault.kind for fault in lines[place]})
        kind = chance.choice(3*[kind for kind in kinds if kind != "statement"] + kinds)
        yield chance.choice([fault for fault in lines[place] if fault.kind == kind])


def known_equivalent():
    """File and `line => fault`, to the reason: blocks of three lines, apart by an empty one"""
    reasons = {}
    if EQUIVALENT.exists():
        for block in EQUIVALENT.read_text().split("\n\n"):
            rows = [row.strip() for row in block.strip().split("\n") if not row.startswith("#")]
            if len(rows) >= 3:
                reasons[rows[0], rows[1]] = " ".join(rows[2:])
    return reasons


# ----------------------------------------------------------------------------------------- the build

INCLUDE = re.compile(r"^\s*#?\s*include\s+['\"]([^'\"]+)['\"]", re.M | re.I)
USE = re.compile(r"^\s*use (\w+)", re.M)


class Failure(Exception):
    pass


class Builder:
    """Compiles what has changed: an object is kept under a sum of its text and of the modules it uses."""

    def __init__(self, scratch):
        self.cache = scratch / "objects"
        self.cache.mkdir(parents=True, exist_ok=True)
        self.keys = {}

    def text_of(self, tree, path):
        text = (tree / path).read_text()
        rooms = []
        for name in INCLUDE.findall(text):
            for place in dict.fromkeys([os.path.normpath(os.path.join(os.path.dirname(path), name))]):
                rooms.append(self.text_of(tree, place) if (tree / place).exists() else "")
        return text + "".join(rooms)

    def build(self, tree, home):
        """Objects of a tree, then the two programs in home. Returns the folders that are new, and all."""
        new, module, objects = [], {}, {}
        texts = {path: self.text_of(tree, path) for path in UNITS}
        for path in UNITS:
            text = texts[path]
            used = sorted(name for name in set(USE.findall(text)) if name in module)
            sum_ = hashlib.sha256(repr([COMPILER, FLAGS, path, text, [module[u][1] for u in used]]).encode())
            place = self.cache / sum_.hexdigest()[:24]
            if not (place / "done").exists():
                self.compile(tree, path, place, [module[u][0] for u in used])
                new.append(place)
            objects[path] = place / "object.o"
            for file in place.glob("*.mod"):
                module[file.stem] = place, hashlib.sha256(file.read_bytes()).hexdigest()
        for name, main in ("app/furiko", "app/main.f90"), ("test/furiko-test", "test/main.F90"):
            (home / name).parent.mkdir(parents=True, exist_ok=True)
            chosen = [objects[path] for path in UNITS if path == main or not path.endswith(("/main.f90", "/main.F90"))
                      and (name.startswith("test") or not path.startswith("test"))
                      and (name.startswith("app") or not path.startswith("app"))]
            run([COMPILER, *chosen, *(LIBRARIES if "test" in name else []), "-o", home / name], tree)
        return new, {path: str(place) for path, place in objects.items()}

    def compile(self, tree, path, place, folders):
        aside = pathlib.Path(tempfile.mkdtemp(dir=self.cache))
        try:
            run([COMPILER, *FLAGS, "-J", aside, *(f"-I{f}" for f in dict.fromkeys(folders)), "-c", path,
                 "-o", aside / "object.o"], tree)
            (aside / "done").touch()
            if not place.exists():
                aside.rename(place)
        finally:
            shutil.rmtree(aside, ignore_errors=True)


def run(command, folder):
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True)
    if done.returncode:
        errors = [row for row in done.stderr.split("\n") if "rror" in row or "undefined" in row]
        raise Failure(errors[0].strip()[:120] if errors else done.stderr[-120:])


# ----------------------------------------------------------------------------------------- the tests

SUITE = re.compile(r"new_testsuite\('([\w-]+)', *collect_(\w+)\)")
# What of a path says which suites see it first
TOPICS = [
    ("catalogue", ["catalogue", "eval"]), ("cli_number|cli_reading|cli_writing|cli_exact", ["number", "eval"]),
    ("cli_eval|cli_rows|cli_fields|cli_input|cli_answers|cli_request|cli_header", ["eval"]),
    ("cli_period|cli_pendulum|cli_motion|cli_rk4|cli_sheet|cli_quantity", ["pendulum-cli"]),
    ("cli_animate", ["animate"]), ("plot|gnuplot|figure", ["plot"]), ("cli_classics|cli_digits", ["notes"]),
    ("cli_table|cli_decimal", ["table", "cli"]), ("app/", ["cli", "pendulum-cli"]),
    ("complete|agm\\.|duplication", ["complete"]), ("word_arith|long", ["word-arithmetic", "table", "notes"]),
    ("integrals|half_pi|arctan", ["incomplete", "edges", "complete"]),
    ("period|motion", ["motion", "pendulum-cli"]), ("nome|theta|zeta|parameters", ["nome", "jacobi"]),
    ("second_inverse", ["second-inverse"]), ("inverse", ["jacobi", "motion"]), ("functions", ["jacobi", "accuracy", "motion"]), ("classics", ["classics"]),
    ("integrators", ["integrators"]), ("selftest", ["known-values"]), ("arithmetic", ["incomplete", "jacobi"]),
]
OF_PROGRAM = ["cli", "eval", "pendulum-cli", "plot", "notes", "animate", "table"]


RUNNING = set()


class Tests:
    def __init__(self):
        text = (ROOT / "test/main.F90").read_text()
        self.suites = dict.fromkeys(name for name, _ in SUITE.findall(text))
        self.seconds = {}
        self.seen_by = {}

    def order(self, path, only_program):
        chosen = [s for s in self.suites if s in OF_PROGRAM or not only_program]
        near = [name for pattern, names in TOPICS if re.search(pattern, path) for name in names]
        base = os.path.basename(path).split(".")[0]

        def rank(suite):
            family = suite.split("-real")[0]
            # these two see much in little time
            topic = near.index(family) if family in near else len(near) + (family not in ("catalogue", "special"))
            return -self.seen_by.get((base, suite), 0), topic, self.seconds.get(suite, 1)

        return sorted(chosen, key=rank)

    def run(self, suite, tree, home, limit):
        """The name of the first test that fails, 'hangs', or None"""
        environment = {**os.environ, "TMPDIR": str(home), "LC_ALL": "C.UTF-8"}
        process = subprocess.Popen(
            [str(home / "test/furiko-test"), suite], cwd=tree, env=environment, text=True, errors="replace",
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True,
            preexec_fn=lambda: (resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30)),
                                resource.setrlimit(resource.RLIMIT_CPU, (int(limit), int(limit) + 1))))
        slow = threading.Event()

        def stop():
            slow.set()
            end(process)

        RUNNING.add(process)
        # The limit is of processor time, since the machine may be busy; this one is for what waits.
        clock = threading.Timer(20*limit, stop)
        clock.start()
        verdict, last = None, "start"
        try:
            for row in process.stderr:
                if match := re.match(r"  Starting (\S+)", row):
                    last = match.group(1)
                elif match := re.match(r" +\.\.\. (\S+) \[(?:FAILED|UNEXPECTED)", row):
                    verdict = match.group(1)
                    break
            if verdict is None and process.wait() != 0:
                hangs = slow.is_set() or process.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
                verdict = last + (" (hangs)" if hangs else " (crash)")
        finally:
            clock.cancel()
            end(process)
            process.stderr.close()
            process.wait()
            RUNNING.discard(process)
        return f"{suite}/{verdict}" if verdict else None


def end(process):
    """Of this test's own process group, which its program and shells are in"""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


# ------------------------------------------------------------------------------------------- the run

def copy_tree(place):
    # What git knows and what is new, but not ignored
    names = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, check=True,
                           capture_output=True, text=True).stdout.split("\0")
    for name in filter(None, names):
        source, target = ROOT / name, place / name
        if source.is_file():
            target.parent.mkdir(parents=True, exist_ok=True)
            if not target.exists() or target.read_bytes() != source.read_bytes():
                shutil.copy2(source, target)


def try_fault(fault, slot, builder, tests, base):
    tree, home = slot / "tree", slot / "home"
    file = tree / fault.path
    text = file.read_text()
    rows = text.split("\n")
    assert rows[fault.number] == fault.old, fault.path
    rows[fault.number] = fault.new
    new = []
    try:
        file.write_text("\n".join(rows))
        try:
            new, objects = builder.build(tree, home)
        except Failure as failure:
            return f"compile error: {failure}"
        changed = [path for path in objects if objects[path] != base[path]]
        for suite in tests.order(fault.path, all(path.startswith("app") for path in changed)):
            verdict = tests.run(suite, tree, home, 3*tests.seconds.get(suite, 100) + 10)
            if verdict:
                key = os.path.basename(fault.path).split(".")[0], suite
                tests.seen_by[key] = tests.seen_by.get(key, 0) + 1
                return "seen by " + verdict
        return "survived"
    finally:
        file.write_text(text)
        for place in new:
            shutil.rmtree(place, ignore_errors=True)


def read_results(file):
    outcome = {}
    if file.exists():
        for row in file.read_text().split("\n"):
            if "\t" in row:
                key, result = row.split("\t")[:2]
                outcome[key] = result
    return outcome


def score(faults, outcome, show):
    reasons = known_equivalent()
    counts = {"seen": 0, "survived": 0, "equivalent": 0, "compile error": 0, "not run": 0}
    kinds = {}
    for fault in faults:
        result = outcome.get(fault.key, "not run")
        verdict = next((name for name in counts if result.startswith(name)), "not run")
        if verdict == "survived" and fault.change in reasons:
            verdict = "equivalent"
        counts[verdict] += 1
        if verdict in ("seen", "survived"):
            kinds.setdefault(fault.kind, [0, 0])[verdict == "survived"] += 1
        if verdict == "survived" and show:
            print("survived:", fault)
    matter = counts["seen"] + counts["survived"]
    print(", ".join(f"{n} {name}" for name, n in counts.items()))
    print("by kind, seen of those that matter: " + ", ".join(
        f"{kind} {a}/{a + b}" for kind, (a, b) in sorted(kinds.items())))
    if matter:
        print(f"score: {counts['seen']} of {matter} faults that matter = {100*counts['seen']/matter:.1f} %")


def spent():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def baseline(scratch, builder, tests, slot, trusted):
    """Everything compiled, every suite passes, and the time it takes the processor"""
    began = time.time()
    _, objects = builder.build(slot / "tree", slot / "home")
    print(f"built in {time.time() - began:.0f} s", file=sys.stderr)
    noted = scratch / "seconds.json"
    sum_ = hashlib.sha256(repr([sorted(objects.items()), sorted((ROOT / "test/data").iterdir())]).encode())
    if noted.exists():
        old = json.loads(noted.read_text())
        if old["sum"] == sum_.hexdigest():
            tests.seconds = old["seconds"]
            return objects
    if trusted and noted.exists():
        tests.seconds = json.loads(noted.read_text())["seconds"]
        return objects
    for suite in tests.suites:
        began = spent()
        verdict = tests.run(suite, slot / "tree", slot / "home", 900)
        tests.seconds[suite] = spent() - began
        print(f"{suite}: {tests.seconds[suite]:.1f} s", file=sys.stderr)
        if verdict:
            sys.exit(f"fails without any fault: {verdict}")
    noted.write_text(json.dumps({"sum": sum_.hexdigest(), "seconds": tests.seconds}))
    return objects


def main():
    global UNITS
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="faults whose text has this regular expression")
    parser.add_argument("--scratch", default=None, help="folder for trees and objects, kept for the next run")
    for flag in "list", "score", "survivors", "again", "trust":
        parser.add_argument("--" + flag, action="store_true")
    options = parser.parse_args()
    faults = []
    for fault in all_faults(options.seed):
        if len(faults) == options.count:
            break
        faults.append(fault)
    faults = [fault for fault in faults if re.search(options.only, str(fault))]
    RESULTS.mkdir(parents=True, exist_ok=True)
    results = RESULTS / f"seed-{options.seed}.txt"
    outcome = read_results(results)
    if options.list:
        print("\n".join(map(str, faults)))
        return
    if options.score:
        score(faults, outcome, True)
        return

    reasons = known_equivalent()
    wanted = [fault for fault in faults if options.again or fault.key not in outcome
              or (options.survivors and outcome[fault.key].startswith("survived")
                  and fault.change not in reasons)]
    name = hashlib.sha256(str(ROOT).encode()).hexdigest()[:8]
    scratch = pathlib.Path(options.scratch or f"{tempfile.gettempdir()}/furiko-mutate-{name}")
    UNITS = make_order.order("src") + make_order.tests()
    builder, tests = Builder(scratch), Tests()
    slots = [scratch / f"slot-{i}" for i in range(options.jobs)]
    for slot in slots:
        shutil.rmtree(slot, ignore_errors=True)
        (slot / "home").mkdir(parents=True)
        copy_tree(slot / "tree")
    base = baseline(scratch, builder, tests, slots[0], options.trust)
    free, lock = list(slots), threading.Lock()

    def one(fault):
        with lock:
            slot = free.pop()
        began = time.time()
        try:
            result = try_fault(fault, slot, builder, tests, base)
        finally:
            with lock:
                free.append(slot)
        with lock:
            outcome[fault.key] = result
            with results.open("a") as log:
                log.write(f"{fault.key}\t{result}\n")
            print(f"{fault}  --  {result} ({time.time() - began:.0f} s)", flush=True)

    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    pool = concurrent.futures.ThreadPoolExecutor(options.jobs)
    try:
        for done in concurrent.futures.as_completed([pool.submit(one, fault) for fault in wanted]):
            done.result()
    except BaseException:
        traceback.print_exc()
        # Nothing of what is cut short is written down
        pool.shutdown(wait=False, cancel_futures=True)
        for process in list(RUNNING):
            end(process)
        os._exit(1)
    score(faults, outcome, True)


if __name__ == "__main__":
    main()
