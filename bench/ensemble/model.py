#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The tables and the picture of doc/scaling.md: python3 bench/ensemble/model.py [--check]

Those of what was measured are from measured.json (sh bench/ensemble/run). The others are a model on paper of a cluster:
a round is computing, collective writing, fsync, marking; its costs are the measured ones where this machine can show
them, and those of ASSUMED where it cannot. `--check` writes nothing and fails where the page or the picture is not that.
"""
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).parent.parent.parent
PAGE, PICTURE = ROOT / "doc/scaling.md", ROOT / "doc/scaling.svg"
MEASURED = json.loads((pathlib.Path(__file__).parent / "measured.json").read_text())

# What this machine cannot show: name, value, unit, why
ASSUMED = [
    ("sockets", 2, "of a node", "one process each"),
    ("cores", 64, "of a socket", "one thread each, as fast as a core here"),
    ("spread", 0.01, "of the time", "standard deviation of the time that equal chunks take on equal sockets"),
    ("fork", 5e-6, "s", "until 64 threads have begun and ended a parallel loop"),
    ("latency", 2e-6, "s", "a short message, sent or received"),
    ("writer", 2e9, "bytes/s", "one process into the file system"),
    ("target", 2.5e9, "bytes/s", "a storage target"),
    ("targets", 400, "", "of the file system, which so takes 1 TB/s"),
    ("stripes", 8, "targets", "on which the file of a part lies; that of a whole job lies on all"),
    ("settle", 5e-3, "s", "until a target says that data are safe, and twice for the marks"),
    ("syncs", 10e3, "1/s", "requests for that, which a target or the metadata server answers"),
    ("start", 10.0, "s", "MPI begins a small job"),
    ("start_each", 1e-3, "s", "and longer for each process"),
    ("restart", 300.0, "s", "from a failure until the job script runs the same command again"),
    ("lifetime", 240e3, "hours", "a node runs between failures that end a job: six in three days on 19,000 nodes"),
]
A = {name: value for name, value, *_ in ASSUMED}
BLOCK = 64
# Members of a part's chunk are as many as --chunk takes: 10^7, and 10^8 points of a section
CHUNKS = {"lyapunov": (4096, 65536, 1048576, 8388608), "bifurcation": (4096, 65536, 983040)}
NODES = (1, 10, 100, 1000, 10000)
PART = 128
TRANSIENT, PERIODS, STEPS = 500, 100, 96


def rows_of(name):
    """What was measured of rounds, by (ranks, chunk): least and median seconds, of fsync, bytes, writes, fsyncs"""
    return {(ranks, chunk): rest for ranks, chunk, *rest in MEASURED[name]["rounds"]}


class Costs:
    """Of a member, in seconds and bytes, as `ensemble` computes it when nothing else is said: 500 periods, then 100,
    of 96 steps"""

    def __init__(self, subject):
        cost = {name: least * 1e-9 for name, (least, _) in MEASURED["compute"][subject].items()}
        self.member = (TRANSIENT + PERIODS) * (STEPS * cost["step"] + cost["period"])
        self.alone = max(cost["alone"], 0)
        self.bytes = {"bifurcation": 16 + 16 * PERIODS, "lyapunov": 36, "winding": 28}[subject]


def messages_received(processes):
    """By the busiest process in a round: it grows with the logarithm, as from 16 to 32"""
    y, z = ((more - few) / 10 for *_, few, more in MEASURED["messages"][-2:])
    return z + (z - y) * (math.log2(processes) - 5)


def round_parts(costs, chunk, processes, everywhere):
    """Seconds of a round, by what takes them; `everywhere` are the processes of all parts, which share the file system"""
    targets = A["targets"] if processes == everywhere else A["stripes"]
    evenly = chunk * costs.member / A["cores"]
    size = chunk * costs.bytes
    fsyncs = max(rest[-1] for (ranks, _), rest in rows_of("rounds").items() if ranks > 1)
    pipe = min(processes * A["writer"], targets * A["target"], A["targets"] * A["target"] * processes / everywhere)
    return {
        "computing, all threads even": evenly,
        "one thread alone": chunk * costs.alone + A["fork"],
        "waiting for the slowest process": evenly * A["spread"] * math.sqrt(2 * math.log(processes)),
        "messages": messages_received(processes) * A["latency"] if processes > 1 else 0.0,
        "writing": processes * size / pipe,
        "fsync": A["settle"] + fsyncs * processes / A["syncs"],
        "marks": 2 * A["settle"],
    }


def lost(parts, processes):
    """The share of the time that failures take: half a round is computed again, after the job has begun again"""
    again = sum(parts.values()) / 2 + A["restart"] + A["start"] + A["start_each"] * processes
    return 1 - 1 / (1 + again * processes / A["sockets"] / (A["lifetime"] * 3600))


def efficiency(subject, chunk, nodes, part=None):
    everywhere = nodes * A["sockets"]
    processes = min(part or everywhere, everywhere)
    parts = round_parts(Costs(subject), chunk, processes, everywhere)
    return parts["computing, all threads even"] / sum(parts.values()) * (1 - lost(parts, processes))


def first_nodes(costs, chunk, cause):
    """From how many nodes on a cause takes a tenth of the time of computing; None up to 100,000"""
    for tenth in range(0, 51):
        nodes = round(10 ** (tenth / 10))
        parts = round_parts(costs, chunk, nodes * A["sockets"], nodes * A["sockets"])
        if parts[cause] > 0.1 * parts["computing, all threads even"]:
            return nodes
    return None


def short(x):
    """Two figures"""
    if x == 0:
        return "0"
    digits = 1 - math.floor(math.log10(abs(x)))
    return f"{round(x, digits):,.{max(digits, 0)}f}" if abs(x) >= 1e-4 else f"{x:.0e}"


def span(pair, unit=1.0):
    """Least, median"""
    return f"{short(pair[0] / unit)}, {short(pair[1] / unit)}"


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(str(cell) for cell in line) + " |\n" for line in lines)


def percent(x):
    return f"{100 * x:.0f} %" if x >= 0.095 else f"{100 * x:.1f} %"


def show_machine():
    m = MEASURED["machine"]
    return f"{m['date']}, {m['cores']} cores of an {m['processor']} (AVX-512), Linux {m['system']}, {', '.join(m['versions'])}.\n"


def show_compute():
    rows = []
    for subject, cost in MEASURED["compute"].items():
        full = Costs(subject)
        rows.append([subject, *(span(cost[name]) for name in ("step", "period", "alone")),
                     short(full.member * 1e6), full.bytes, short(full.bytes / full.member / 1e3)])
    return table(["ns of a member", "a step", "a period beyond", "once, one thread alone", "µs of all", "bytes",
                  "kB a core and second"], rows)


def predicted(ranks, threads, chunk):
    """Members a second of the sweep of measure.py on this machine, from the costs of computing and of a round"""
    cost = {name: least * 1e-9 for name, (least, _) in MEASURED["compute"]["lyapunov"].items()}
    busy = min(threads, math.ceil(chunk / BLOCK))
    computing = chunk * (80 * (96 * cost["step"] + cost["period"]) / busy + max(cost["alone"], 0))
    known = sorted((size * rest[4], rest[0]) for (number, size), rest in rows_of("rounds").items() if number == ranks)
    size = max(Costs("lyapunov").bytes * chunk, known[0][0])
    (x, s), (y, t) = next(pair for pair in zip(known, known[1:]) if size <= pair[1][0])
    return max(ranks, 1) * chunk / (computing + s + (t - s) * (size - x) / (y - x))


def show_scaling():
    found = {tuple(case): speeds for *case, most, median in MEASURED["scaling"] for speeds in [(most, median)]}
    names = {(0, 1): "one process, one thread", (0, 2): "one process, two threads", (1, 1): "MPI: one process, one thread",
             (1, 2): "MPI: one process, two threads", (2, 1): "MPI: two processes, one thread each"}
    size = max(members for *_, members in found)
    rows = []
    for (ranks, threads), name in names.items():
        cells = [name]
        for chunk in (4096, 64):
            most, median = found[ranks, threads, chunk, size]
            one = found[min(ranks, 1), 1, chunk, size]
            cells += [f"{most:,.0f}, {median:,.0f}", f"{most / one[0]:.2f}, {median / one[1]:.2f}",
                      f"{predicted(ranks, threads, chunk) / predicted(min(ranks, 1), 1, chunk):.2f}"]
        half = found[min(ranks, 1), 1, 4096, size // 2]
        most, median = found[ranks, threads, 4096, size]
        cells.append(f"{most / half[0] / 2:.2f}, {median / half[1] / 2:.2f}" if ranks + threads > 2 or threads > 1 else "")
        rows.append(cells)
    return table(["", "members/s, chunk 4096", "times one core", "from the parts", "members/s, chunk 64", "times one core",
                  "from the parts", "weak: twice the work on two"], rows)


def show_rounds():
    found = rows_of("rounds")
    rows = []
    for chunk in sorted({chunk for _, chunk in found}):
        cells = [f"{chunk:,}", short(chunk * found[0, chunk][4] / 1e3)]
        for ranks in (0, 1, 2):
            cells += [span(found[ranks, chunk][:2], 1e-3), span(found[ranks, chunk][2:4], 1e-3)]
        rows.append(cells)
    return table(["chunk", "kB a process", "one process: ms", "of it fsync", "MPI, one: ms", "of it fsync", "MPI, two: ms",
                  "of it fsync"], rows)


def show_counts():
    found = rows_of("rounds")
    chunk = max(chunk for _, chunk in found)
    rows = [[["one process", "MPI, one", "MPI, two"][ranks], f"{found[ranks, chunk][4]:.2f}", found[ranks, chunk][5],
             found[ranks, chunk][6]] for ranks in (0, 1, 2)]
    return table(["", "bytes a member that are written", "writes in a round", "fsyncs in a round, each process"], rows)


def show_messages():
    rows = [[ranks, few, more, short((more - few) / 10), longer - few, short((busier - busy) / 10)]
            for ranks, few, more, longer, busy, busier in MEASURED["messages"]]
    return table(["processes", "messages in 10 rounds", "in 20 rounds", "in one", "more with ten times the steps",
                  "received by one process in a round"], rows)


def show_start():
    return table(["processes", "s of `ensemble help`"],
                 [[ranks or "without MPI", span(times)] for ranks, *times in MEASURED["start"]])


def show_making():
    return table(["members", "MB of the file", "ms until it is there"],
                 [[f"{members:,}", short(size / 1e6), span(times, 1e-3)] for members, size, *times in MEASURED["making"]])


def show_memory():
    rows = [[f"{members:,}", f"{chunks:,}", *(short(peak / 1e6) for peak in peaks)] for members, chunks, *peaks in MEASURED["memory"]]
    return table(["members", "chunks", "MB of a process without MPI", "MB of each of two"], rows)


def show_join():
    return table(["chunk", "chunks", "s to join four parts", "MB/s"],
                 [[f"{chunk:,}", chunks, span(times), short(size / times[0] / 1e6)] for chunk, chunks, size, *times in MEASURED["join"]])


def show_assumed():
    def cell(value):
        return f"{value:,}" if isinstance(value, int) else f"{value:g}"

    return table(["assumed", "value", "", "what"], [[name, cell(value), unit, about] for name, value, unit, about in ASSUMED])


def show_efficiency():
    text = ""
    for subject, chunks in CHUNKS.items():
        rows = [[f"{nodes:,}", *(percent(efficiency(subject, chunk, nodes)) for chunk in chunks),
                 *(percent(efficiency(subject, chunk, nodes, PART)) for chunk in chunks[-1:])] for nodes in NODES]
        text += f"\n{subject}, {short(Costs(subject).member * 1e6)} µs and {Costs(subject).bytes} bytes a member:\n\n"
        text += table(["nodes", *(f"chunk {chunk:,}" for chunk in chunks), f"chunk {chunks[-1]:,} in parts of {PART} processes"], rows)
    return text[1:]


def show_round():
    nodes = NODES[-1]
    everywhere = nodes * A["sockets"]
    columns = [(subject, chunk, everywhere) for subject in CHUNKS for chunk in CHUNKS[subject][1:]]
    columns += [(subject, CHUNKS[subject][-1], PART) for subject in CHUNKS]
    found = [round_parts(Costs(subject), chunk, processes, everywhere) for subject, chunk, processes in columns]
    rows = [[cause, *(short(parts[cause]) for parts in found)] for cause in found[0]]
    rows.append(["all", *(short(sum(parts.values())) for parts in found)])
    return table([f"s of a round, {nodes:,} nodes", *(f"{subject}, {chunk:,}{', parts' if processes == PART else ''}"
                                                       for subject, chunk, processes in columns)], rows)


def show_first():
    columns = [(subject, chunk) for subject in CHUNKS for chunk in CHUNKS[subject]]
    rows = []
    for cause in list(round_parts(Costs("lyapunov"), 4096, 2, 2))[1:]:
        counts = [first_nodes(Costs(subject), chunk, cause) for subject, chunk in columns]
        rows.append([cause, *("–" if nodes is None else f"{nodes:,}" for nodes in counts)])
    return table(["costs a tenth from so many nodes on", *(f"{subject}, {chunk:,}" for subject, chunk in columns)], rows)


def show_failures():
    rows = []
    chunk = CHUNKS["lyapunov"][-1]
    for nodes in NODES[2:]:
        everywhere = nodes * A["sockets"]
        hours = A["lifetime"] / nodes
        whole, parts = (round_parts(Costs("lyapunov"), chunk, min(p, everywhere), everywhere) for p in (everywhere, PART))
        # What does not grow with the chunk
        cost = sum(whole[cause] for cause in ("messages", "fsync", "marks"))
        best = math.sqrt(2 * cost * hours * 3600)
        rows.append([f"{nodes:,}", short(hours), percent(lost(whole, everywhere)), percent(lost(parts, min(PART, everywhere))),
                     short(best), f"{float(short(best * A['cores'] / Costs('lyapunov').member).replace(',', '')):,.0f}"])
    return table(["nodes", "hours from failure to failure", f"lost, one job, chunk {chunk:,}", f"in parts of {PART} processes",
                  "best round, s", "chunk of lyapunov"], rows)


def show_pace():
    """How fast a machine of 10,000 nodes is through a sweep of 10^12, the most there is, and joins it"""
    joined = max(size / least for _, _, size, least, _ in MEASURED["join"])
    rows = []
    for subject in CHUNKS:
        chunk, costs = CHUNKS[subject][-1], Costs(subject)
        rate = efficiency(subject, chunk, NODES[-1], PART) * NODES[-1] * A["sockets"] * A["cores"] / costs.member
        size = 1e12 * costs.bytes
        rows.append([subject, short(rate / 1e9), short(1e12 / rate / 60), short(size / 1e12), short(rate * costs.bytes / 1e9),
                     short(size / joined / 3600)])
    return table(["10,000 nodes in parts", "10⁹ members/s", "minutes for 10¹² members", "TB", "GB/s", "hours to join by one process"], rows)


def page(old):
    new = old
    for name, text in re.findall(r"^<!-- (\w+) -->\n(.*?)^<!-- end -->$", old, re.M | re.S):
        begin = f"<!-- {name} -->\n"
        new = new.replace(begin + text, begin + globals()[f"show_{name}"]())
    return new


PLOT = """
set terminal svg size 720,480 font 'sans-serif,14' background '#ffffff'
set output '{output}'
set title 'The model, of lyapunov with 500 + 100 periods of 96 steps'
set xlabel 'nodes of 2 × 64 cores'
set ylabel 'efficiency, %'
set logscale x
set xtics ('1' 1, '10' 10, '100' 100, '1,000' 1000, '10,000' 10000)
set yrange [0:105]
set grid linecolor '#dddddd'
set border 3
set tics nomirror
set key left bottom Left reverse width -4 spacing 1.2
plot {curves}
"""


def draw(output):
    colours = ("#0072b2", "#009e73", "#d55e00", "#000000", "#cc79a7")
    chunks = CHUNKS["lyapunov"]
    cases = [(chunk, None, f"chunk {chunk:,}") for chunk in chunks] + [(chunks[-1], PART, f"chunk {chunks[-1]:,} in parts of {PART}")]
    curves, data = [], ""
    for (chunk, part, name), colour in zip(cases, colours):
        curves.append(f"'-' with lines linewidth 2.5 {'dashtype 2 ' if part else ''}linecolor '{colour}' title '{name}'")
        for tenth in range(0, 41):
            nodes = round(10 ** (tenth / 10))
            data += f"{nodes} {100 * efficiency('lyapunov', chunk, nodes, part):.4f}\n"
        data += "e\n"
    script = PLOT.format(output=output, curves=", ".join(curves)) + data
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def drawn_by(path):
    return re.search(r"Produced by GNUPLOT[^<]*", path.read_text())[0]


def check():
    old = PAGE.read_text()
    if page(old) != old:
        sys.exit(f"{PAGE.relative_to(ROOT)}: not what the model says; run python3 bench/ensemble/model.py")
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder) / PICTURE.name
        draw(made)
        # As doc/figures/make: another gnuplot places labels otherwise
        if drawn_by(made) == drawn_by(PICTURE) and made.read_bytes() != PICTURE.read_bytes():
            sys.exit(f"{PICTURE.relative_to(ROOT)}: not what the model says; run python3 bench/ensemble/model.py")


def main():
    if sys.argv[1:] == ["--check"]:
        check()
        return
    text = page(PAGE.read_text())
    PAGE.write_text(text)
    draw(PICTURE)
    print("\n".join(re.findall(r"^<!-- \w+ -->\n(.*?)^<!-- end -->$", text, re.M | re.S)))


main()
