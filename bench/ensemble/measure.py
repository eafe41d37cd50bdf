#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures the program ensemble: python3 bench/ensemble/measure.py FOLDER [PART ...], which bench/ensemble/run calls.

FOLDER has the programs serial/ensemble, mpi/ensemble and compute. What comes out goes into measured.json, from which
model.py makes the tables of doc/scaling.md. Each part below measures one thing; those that take time are repeated in
turns, so that a disturbance meets all that is compared, and all times are kept as (least, median).
"""
import contextlib
import datetime
import itertools
import json
import math
import os
import pathlib
import platform
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).parent
MEASURED = HERE / "measured.json"
BUILT = pathlib.Path(sys.argv[1]).resolve()
SERIAL, MPI = str(BUILT / "serial/ensemble"), str(BUILT / "mpi/ensemble")
# As root too, and on a machine with fewer cores than processes, of which none is bound to a core
os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_rmaps_base_oversubscribe="1",
                  OMPI_MCA_hwloc_base_binding_policy="none", OMPI_MCA_mpi_yield_when_idle="1", OMP_NUM_THREADS="1")
# A sweep of nearly no work, for what does not depend on the work
IDLE = ["--from", "1", "--to", "1.1", "--transient", "0", "--steps", "1", "--method", "rk4", "--quiet"]


def program(ranks):
    return ["mpirun", "-n", str(ranks), MPI] if ranks else [SERIAL]


def run(command, threads=1):
    """What it says on standard error"""
    done = subprocess.run(command, env={**os.environ, "OMP_NUM_THREADS": str(threads)}, text=True, capture_output=True)
    if done.returncode:
        sys.exit(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return done.stderr


def seconds(command):
    start = time.perf_counter()
    run(command)
    return time.perf_counter() - start


def least_and_median(numbers):
    return [min(numbers), statistics.median(numbers)]


def in_turns(repeats, measure, cases):
    """{case: (least, median)} of measure(*case); all cases, then all again"""
    found = {case: [] for case in cases}
    for _, case in itertools.product(range(repeats), cases):
        found[case].append(measure(*case))
    return {case: least_and_median(numbers) for case, numbers in found.items()}


def fresh(name="a.h5"):
    pathlib.Path(name).unlink(missing_ok=True)
    return name


def compute():
    """Nanoseconds of a member: a step; a period beyond its steps; and once, what only one thread does"""
    said = subprocess.run([str(BUILT / "compute")], text=True, capture_output=True, check=True).stdout
    cost, found = {}, {}
    for subject, periods, steps, threads, *times in map(str.split, said.splitlines()):
        cost[subject, int(periods), int(steps), int(threads)] = least_and_median([float(x) for x in times])
    (few, one), (_, more), (many, _) = sorted({key[1:3] for key in cost})
    for subject in sorted({key[0] for key in cost}):
        parts = []
        for i in (0, 1):
            short, steeper, longer = (cost[subject, *key, 1][i] for key in ((few, one), (few, more), (many, one)))
            step = (steeper - short) / (few * (more - one))
            # Of t = alone + shared/threads; what of it grows with the periods is that two threads are less than twice
            # as fast as one.
            alone, alone_longer = (2 * cost[subject, n, one, 2][i] - cost[subject, n, one, 1][i] for n in (few, many))
            parts.append([step, (longer - short) / (many - few) - one * step,
                          alone - few * (alone_longer - alone) / (many - few)])
        found[subject] = dict(zip(("step", "period", "alone"), map(list, zip(*parts))))
    return found


SCALING = ["--from", "0.5", "--to", "1.5", "--transient", "16", "--periods", "64"]


def members_a_second(ranks, threads, chunk, members):
    """As the program says at its end: from the first chunk on, without the start"""
    command = [*program(ranks), "lyapunov", fresh(), *SCALING, "--points", str(members), "--chunk", str(chunk)]
    return int(re.search(r"(\d+) members/s", run(command, threads))[1])


def scaling():
    """Members a second by (ranks, 0 without MPI; threads; chunk; members), greatest and median"""
    members = 16384
    layouts = [(0, 1), (0, 2), (1, 1), (1, 2), (2, 1)]
    cases = [(*layout, chunk, members) for layout in layouts for chunk in (4096, 64)]
    # Half of the work for half of the cores
    cases += [(ranks, 1, 4096, members // 2) for ranks in (0, 1)]
    found = in_turns(5, lambda *case: 1 / members_a_second(*case), cases)
    return [[*case, 1 / least, 1 / median] for case, (least, median) in found.items()]


def traced(ranks, chunk, rounds):
    """The writes and fsyncs of each process: [(start, call, bytes, seconds)]"""
    for path in pathlib.Path().glob("trace.*"):
        path.unlink()
    watched = ["strace", "-ff", "-ttt", "-T", "--seccomp-bpf", "-f", "-qq", "-o", "trace", "-e", "trace=pwrite64,fsync"]
    command = program(ranks)
    run([*command[:-1], *watched, command[-1], "bifurcation", fresh(), *IDLE, "--periods", "100", "--points",
         str(max(ranks, 1) * chunk * rounds), "--chunk", str(chunk)])
    line = re.compile(r"([\d.]+) (\w+)\(.*\) += (\d+) <([\d.]+)>")
    found = []
    for path in sorted(pathlib.Path().glob("trace.*")):
        calls = [(float(at), call, int(count), float(took)) for at, call, count, took in line.findall(path.read_text())]
        if calls:
            found.append(calls)
    return found


def rounds_of(processes):
    """Seconds from when the last process has computed to when the round's last write is done; of these in fsync; bytes;
    writes of all processes; fsyncs of one"""
    session = 16
    clock = next(calls for calls in processes if any(size == session for _, call, size, _ in calls if call != "fsync"))
    ends = [at + took for at, call, size, took in clock if call == "pwrite64" and size == session]
    for begin, end in list(itertools.pairwise(ends))[1:-1]:
        these = [[one for one in calls if begin <= one[0] < end] for calls in processes]
        # Marks and session are no beginning of a round
        starts = [min((at for at, call, size, _ in calls if call == "pwrite64" and size > session), default=0) for calls in these]
        yield (end - max(starts), max(sum(took for _, call, _, took in calls if call == "fsync") for calls in these),
               sum(size for calls in these for _, call, size, _ in calls if call == "pwrite64"),
               sum(call == "pwrite64" for calls in these for _, call, *_ in calls),
               max(sum(call == "fsync" for _, call, *_ in calls) for calls in these))


def rounds():
    """By (ranks, chunk): seconds of a round after computing; of it in fsync; bytes a member; writes; fsyncs a process"""
    cases = [(ranks, chunk) for chunk in (16, 256, 4096, 16384) for ranks in (0, 1, 2)]
    times, syncs, found = {case: [] for case in cases}, {case: [] for case in cases}, []
    counts = {}
    for _, case in itertools.product(range(2), cases):
        processes = traced(*case, 12)
        for took, sync, size, writes, fsyncs in rounds_of(processes):
            times[case].append(took)
            syncs[case].append(sync)
            counts[case] = size / (max(case[0], 1) * case[1]), writes, fsyncs
    for case in cases:
        found.append([*case, *least_and_median(times[case]), *least_and_median(syncs[case]), *counts[case]])
    sizes = []
    for members in (4096, 8192):
        run([*program(0), "bifurcation", fresh(), *IDLE, "--periods", "100", "--points", str(members)])
        sizes.append(os.path.getsize("a.h5"))
    return {"rounds": found, "file_bytes_a_member": (sizes[1] - sizes[0]) / 4096}


def messages_of(ranks, rounds, steps):
    """Sent by all, received by the busiest"""
    for path in pathlib.Path().glob("monitor.*"):
        path.unlink()
    monitor = ["--mca", "pml_monitoring_enable", "2", "--mca", "pml_monitoring_enable_output", "3",
               "--mca", "pml_monitoring_filename", str(pathlib.Path("monitor").resolve())]
    run(["mpirun", "-n", str(ranks), *monitor, MPI, "lyapunov", fresh(), "--from", "0.5", "--to", "0.9", "--points",
         str(ranks * rounds * 64), "--chunk", "64", "--periods", "16", "--transient", "0", "--steps", str(steps), "--quiet"])
    received = {}
    for path in pathlib.Path().glob("monitor.*.prof"):
        for to, count in re.findall(r"^[IE]\t\d+\t(\d+)\t\d+ bytes\t(\d+) msgs", path.read_text(), re.M):
            received[to] = received.get(to, 0) + int(count)
    return sum(received.values()), max(received.values())


def messages():
    """By ranks: messages of 10 rounds, of 20, of 10 with ten times as many steps; received by the busiest in 10 and 20"""
    found = []
    for ranks in (2, 4, 8, 16, 32):
        (few, busy), (more, busier), (longer, _) = (messages_of(ranks, *case) for case in ((10, 8), (20, 8), (10, 80)))
        found.append([ranks, few, more, longer, busy, busier])
    return found


def start():
    """Seconds of the program that only says its help, by ranks; 0: without MPI"""
    found = in_turns(3, lambda ranks: seconds([*program(ranks), "help"]), [(ranks,) for ranks in (0, 1, 2, 4, 8, 16, 32, 64)])
    return [[*case, *times] for case, times in found.items()]


def time_to_make(members):
    """Seconds until the file has its name; then the program is stopped."""
    name = fresh("made.h5")
    begun = time.perf_counter()
    job = subprocess.Popen([SERIAL, "bifurcation", name, "--from", "1", "--to", "1.1", "--points", str(members), "--quiet"])
    while not os.path.exists(name) and job.poll() is None:
        time.sleep(0.0005)
    took = time.perf_counter() - begun
    size = os.path.getsize(name)
    job.kill()
    job.wait()
    fresh(name)
    return took, size


def making():
    """Members, bytes of the file, seconds until it is there"""
    found = []
    for members in (10**4, 10**5, 10**6, 10**7):
        times, sizes = zip(*(time_to_make(members) for _ in range(5)))
        found.append([members, sizes[0], *least_and_median(times)])
    return found


def memory():
    """By chunks of the sweep: largest resident set of a process in bytes, without MPI and of two ranks"""
    found = []
    for members in (10**6, 10**7, 10**8, 10**9):
        peaks = []
        for ranks in (0, 2):
            command = program(ranks)
            run([*command[:-1], "/usr/bin/time", "-a", "-o", fresh("peak"), "-f", "%M", command[-1], "winding", fresh(),
                 *IDLE, "--periods", "1", "--points", str(members), "--chunk", "64", "--part", "1/1000000"])
            peaks.append(1024 * max(map(int, pathlib.Path("peak").read_text().split())))
        found.append([members, math.ceil(members / 64), *peaks])
    return found


def join():
    """By chunk: chunks, seconds to join four parts"""
    found = []
    for chunk in (256, 4096):
        size = ["--periods", "100", "--points", str(65536), "--chunk", str(chunk)]
        parts = [fresh(f"part{p}.h5") for p in (1, 2, 3, 4)]
        for p, name in enumerate(parts, 1):
            run([SERIAL, "bifurcation", name, *IDLE, *size, "--part", f"{p}/4"])
        times = [seconds([SERIAL, "join", fresh("joined.h5"), *parts]) for _ in range(3)]
        found.append([chunk, 65536 // chunk, os.path.getsize("joined.h5"), *least_and_median(times)])
    return found


PARTS = {part.__name__: part for part in (compute, scaling, rounds, messages, start, making, memory, join)}


def machine():
    processor = re.search(r"^model name\s*: *(.*)", pathlib.Path("/proc/cpuinfo").read_text(), re.M)[1]
    versions = [subprocess.run([name, "--version"], text=True, capture_output=True).stdout.splitlines()[0]
                for name in ("gfortran", "mpirun")]
    return {"date": datetime.date.today().isoformat(), "processor": processor, "cores": os.cpu_count(),
            "system": platform.release(), "versions": versions}


def main():
    wanted = sys.argv[2:] or list(PARTS)
    if unknown := [name for name in wanted if name not in PARTS]:
        sys.exit(f"bench/ensemble: no part '{unknown[0]}'; there are {', '.join(PARTS)}")
    found = json.loads(MEASURED.read_text()) if MEASURED.exists() else {}
    scratch = tempfile.mkdtemp()
    with contextlib.chdir(scratch):
        for name in wanted:
            begun = time.perf_counter()
            found[name] = PARTS[name]()
            print(f"{name}: {time.perf_counter() - begun:.0f} s", file=sys.stderr)
    shutil.rmtree(scratch)
    found["machine"] = machine()
    MEASURED.write_text(written(found))


def written(found):
    """JSON with a line for each row, that a person can compare"""
    text = json.dumps(found, indent=1)
    return re.sub(r"\[[^][{}]*\]", lambda match: re.sub(r"\s+", " ", match[0]), text) + "\n"


main()
