# SPDX-License-Identifier: MIT
"""The package as it is installed, against the repository's references and against Fortran's own bits."""

import copy
import ctypes.util
import gzip
import inspect
import os
import pathlib
import pickle
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from numpy.testing import assert_array_equal

import furiko
from furiko import _functions

DATA = pathlib.Path(__file__).parents[2] / "test/data"
MASKED = np.ma.array([0.25, 0.5], mask=[False, True])
FUNCTIONS = [name for name in _functions.__all__ if inspect.isfunction(getattr(furiko, name))]


def rows():
    """Of names.dat: name, arguments, results"""
    for line in (DATA / "names.dat").read_text().splitlines():
        if not line.startswith("#"):
            name, arguments, results, *numbers = line.split()
            assert len(numbers) == int(arguments) + int(results)
            numbers = [float(number) for number in numbers]
            yield name, numbers[: int(arguments)], numbers[int(arguments) :]


def parts(result):
    return result if isinstance(result, tuple) else (result,)


def near(results, expected, units, kind=np.float64):
    return np.allclose(parts(results), expected, rtol=units * np.finfo(kind).eps, atol=0)


def test_every_name_has_references():
    assert {name for name, *_ in rows()} == set(FUNCTIONS)
    assert set(furiko.__all__) <= set(dir(furiko))


@pytest.mark.parametrize(("name", "arguments", "expected"), list(rows()))
def test_references(name, arguments, expected):
    f = getattr(furiko, name)
    result = f(*arguments)
    assert all(type(part) is float for part in parts(result))
    assert near(result, expected, 64)
    by_keyword = dict(reversed(list(zip(inspect.signature(f).parameters, arguments))))
    assert f(**by_keyword) == result
    assert near(f(*map(np.float32, arguments)), expected, 64, np.float32)
    for kind in (np.float32, np.float64):
        for many in parts(f(*(np.full(5, x, kind) for x in arguments))):
            assert many.shape == (5,)
            assert many.dtype == kind
        assert near(f(*(np.full((2, 3), x, kind) for x in arguments)), np.reshape(expected, (-1, 1, 1)), 64, kind)


def test_special_values():
    """Infinity, NaN, zeros and their signs against each other, to 9 digits"""
    seen = 0
    with gzip.open(DATA / "special.dat.gz", "rt") as file:
        for head in file:
            name, arguments, results, count = head.split()
            table = np.array([[float(x) for x in next(file).split()] for _ in range(int(count))])
            given, expected = table[:, : int(arguments)].T, table[:, int(arguments) :].T
            assert expected.shape[0] == int(results)
            with np.errstate(all="ignore"):
                for result, right in zip(parts(getattr(furiko, name)(*given)), expected):
                    assert np.allclose(result, right, rtol=1e-6, atol=1e-300, equal_nan=True), name
                    zero = right == 0
                    assert_array_equal(np.signbit(result[zero]), np.signbit(right[zero]), name)
            seen += 1
    assert seen == len(FUNCTIONS)


def pseudo_random(kind):
    """The numbers of .ci/bits.F90"""
    state = 7
    while True:
        state = state * 16807 % 2147483647
        yield kind(state // 128) / kind(8388607) - kind(1)


@pytest.mark.skipif("FURIKO_BITS" not in os.environ, reason="FURIKO_BITS names no folder with what .ci/bits.F90 prints")
@pytest.mark.parametrize(("real", "kind"), [("real32", np.float32), ("real64", np.float64)])
def test_bits_of_fortran(real, kind):
    numbers, count = pseudo_random(kind), 64
    lines = iter((pathlib.Path(os.environ["FURIKO_BITS"]) / real).read_text().splitlines())
    seen = 0
    for head in lines:
        name, *words = head.split()
        f = getattr(furiko, name)
        arguments = [np.empty(count, kind) for name in inspect.signature(f).parameters if name != "out"]
        for argument in arguments:
            for j in range(count):
                x = next(numbers) * kind(1 if (j + 1) % 4 < 2 else 12)
                argument[j] = abs(x) if j % 2 else x
        many = np.concatenate(parts(f(*arguments)))
        assert_array_equal(many.view(np.uint32), [int(word, 16) for word in words], name)
        for row in zip(*arguments):
            one = np.array(parts(f(*row)), kind)
            assert_array_equal(one.view(np.uint32), [int(word, 16) for word in next(lines).split()], name)
        seen += 1
    assert seen == len(FUNCTIONS)


def test_broadcasting():
    phi, m = np.linspace(-3, 3, 7)[:, None], np.array([-1.0, 0.25, 1.0])
    table = furiko.ellipf_m(phi, m)
    assert table.shape == (7, 3)
    for i, j in np.ndindex(table.shape):
        assert near(table[i, j], furiko.ellipf_m(phi[i, 0], m[j]), 4)
    assert furiko.ellipf_m(phi.T[:, ::-2], 0.25).shape == (1, 4)
    assert furiko.ellipk_m(np.empty((0, 3))).shape == (0, 3)
    assert furiko.ellipf_m(np.ones((0, 1)), [0.1, 0.2]).shape == (0, 2)
    # Strides, orders and lengths beyond one block
    x = np.asfortranarray(np.linspace(-2, 1, 60000).reshape(200, 300))
    straight = furiko.ellipk_m(np.ascontiguousarray(x))
    for other in (
        furiko.ellipk_m(x),
        furiko.ellipk_m(x[::-1])[::-1],
        furiko.ellipk_m(x.T).T,
        furiko.ellipk_m(x.astype(">f8")),
    ):
        assert_array_equal(other, straight)
    assert near(straight[7, ::50], [furiko.ellipk_m(m) for m in x[7, ::50]], 1)
    frozen = np.array([0.5])
    frozen.flags.writeable = False
    assert furiko.ellipk_m(frozen) == furiko.ellipk_m(0.5)


def test_kinds():
    single, double = np.float32(0.5), np.float64(0.5)
    f = furiko.ellipf_m
    assert type(f(1, 0.5)) is type(f(True, 0)) is float
    assert type(f(single, 0.5)) is type(f(single, single)) is type(f(np.array(0.5, "f"), 1)) is np.float32
    assert (
        type(f(single, double))
        is type(f(double, 1))
        is type(f(np.array(0.5), 1))
        is type(f(np.int64(1), 0.5))
        is np.float64
    )
    assert f([0.5], single).dtype == f(np.arange(3), 0.5).dtype == f(np.ones(3, "f"), np.ones(3)).dtype == np.float64
    assert (
        f(np.ones(3, "f"), 0.1).dtype
        == f(np.ones(3, "f"), single).dtype
        == f(np.ones(3, np.float16), 0).dtype
        == np.float32
    )
    assert f(1, m=0.5) == f(1.0, np.float64(0.5)) == f(True, 0.5)
    assert all(type(part) is np.float32 for part in furiko.jacobi_m(single, 0.5))
    values = furiko.jacobi_m(0.5, [0.1, 0.2])
    assert values.dn is values[2]
    assert values._fields == ("sn", "cn", "dn")


def test_out():
    m, out = np.linspace(0, 0.9, 10), np.empty(10)
    assert furiko.ellipk_m(m, out=out) is out
    assert_array_equal(out, furiko.ellipk_m(m))
    single = np.zeros((2, 10), "f")
    assert_array_equal(furiko.ellipk_m(m, out=single)[1], out.astype("f"))
    strided = np.zeros((10, 2))
    furiko.ellipk_m(m, out=strided[:, 1])
    assert_array_equal(strided, np.column_stack([np.zeros(10), out]))
    sn, dn = np.empty(10), np.empty(10)
    values = furiko.jacobi_m(1.5, m, out=(sn, None, dn))
    assert values.sn is sn and values.dn is dn
    assert_array_equal(values, furiko.jacobi_m(1.5, m))
    # Where it overlaps an argument
    for here, there in ((slice(1, None), slice(None, -1)), (slice(None, -1), slice(1, None))):
        m = np.linspace(0, 0.9, 20001)
        expected = furiko.ellipk_m(m[here])
        furiko.ellipk_m(m[here], out=m[there])
        assert_array_equal(m[there], expected)


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: furiko.ellipk_m("a"), TypeError, "ellipk_m: m is a string, not real"),
        (lambda: furiko.ellipk_m(None), TypeError, "ellipk_m: m is None, not real"),
        (lambda: furiko.ellipk_m(["a"]), TypeError, "ellipk_m: m is an array of strings"),
        (lambda: furiko.ellipk_m([1.0, None]), TypeError, "ellipk_m: m is an array of Python objects"),
        (lambda: furiko.ellipk_m({}), TypeError, "ellipk_m: m is of type dict"),
        (lambda: furiko.ellipk_m(MASKED), TypeError, "m is a masked array, whose mask would be lost: use np.ma.array("),
        (lambda: furiko.ellipf_m(1, np.ma.masked), TypeError, "ellipf_m: m is a masked array"),
        (lambda: furiko.ellipk_m([1, 2], out=MASKED), TypeError, "ellipk_m: out is of type MaskedArray, not an array"),
        (lambda: furiko.ellipf_m(1, 1j), TypeError, "ellipf_m: m is complex128"),
        (lambda: furiko.ellipk_m(np.longdouble(1)), TypeError, "ellipk_m: m is "),
        (lambda: furiko.ellipk_m(), TypeError, "missing 1 required positional argument: 'm'"),
        (lambda: furiko.ellipk_m(k=1), TypeError, "unexpected keyword argument 'k'"),
        (lambda: furiko.ellipf_m([1, 2], [1, 2, 3]), ValueError, "could not be broadcast"),
        (lambda: furiko.ellipk_m(1.0, out=[0]), TypeError, "ellipk_m: out is of type list, not an array"),
        (lambda: furiko.ellipk_m([1, 2], out=np.empty(1)), ValueError, "non-broadcastable output operand"),
        (lambda: furiko.ellipk_m([1, 2], out=np.empty(2, int)), TypeError, "could not be cast"),
        (lambda: furiko.jacobi_m(1, 0, out=np.empty(3)), TypeError, "jacobi_m: out is not a tuple of 3 arrays"),
        (lambda: furiko.jacobi_m(1, 0, out=(0, 0, 0)), TypeError, "jacobi_m: out is of type int, not an array"),
        (furiko.Modulus, TypeError, "Modulus takes one of k, m"),
        (lambda: furiko.Modulus(k=0.5, m=0.25), TypeError, "Modulus takes one of k, m"),
        (lambda: furiko.Modulus(m=0.5).am("a"), TypeError, "modulus_am: u is a string"),
        (lambda: furiko.Modulus(m=0.5).am(MASKED), TypeError, "modulus_am: u is a masked array"),
        (lambda: furiko.Modulus(m="a"), TypeError, "Modulus: m is a string"),
        (lambda: furiko.Modulus(k="0.5"), TypeError, "Modulus: k is a string"),
        (lambda: furiko.Modulus(mc=1j), TypeError, "Modulus: mc is complex128"),
        (lambda: furiko.Modulus(m=[0.1, 0.2]), TypeError, "Modulus: m is an array of the shape (2,), not one number"),
        (lambda: furiko.Pendulum(length="1"), TypeError, "Pendulum: length is a string"),
        (lambda: furiko.Pendulum(gravity=None), TypeError, "Pendulum: gravity is None"),
        (lambda: furiko.Pendulum().released(angle="x"), TypeError, "released: angle is a string"),
        (lambda: furiko.Pendulum().swinging("0.5"), TypeError, "swinging: amplitude is a string"),
        (lambda: furiko.Pendulum().started(0, None), TypeError, "started: rate is None"),
        (furiko.Motion, TypeError, "a Motion is made by a Pendulum"),
        (lambda: furiko.pendulum_rk4(1, 0.1, 2**31, 1, 0), ValueError, "pendulum_rk4: steps is 2147483648"),
        (lambda: furiko.pendulum_rk4(1, 0.1, 1.5, 1, 0), TypeError, "cannot be interpreted as an integer"),
        (lambda: furiko.pendulum_rk4(1j, 0.1, 1, 1, 0), TypeError, "pendulum_rk4: omega2 is complex128"),
        (lambda: furiko.pendulum_rk4(1, "0.1", 1, 1, 0), TypeError, "pendulum_rk4: h is a string"),
        (lambda: furiko.rk4(lambda t, y: y, None, 0.1, 1, 0), TypeError, "rk4: t0 is None"),
        (lambda: furiko.rk4(lambda t, y: 1j * y, 0, 0.1, 1, 0), TypeError, "rk4: what f returns is complex128"),
        (lambda: furiko.rk4(lambda t, y: y, 0, 0.1, 1, MASKED), TypeError, "rk4: y is a masked array"),
        (lambda: furiko.verlet(lambda x: x, 0.1, 1, 0, "a"), TypeError, "verlet: v is a string"),
        (
            lambda: furiko.rk4(lambda t, y: [1.0], 0, 0.1, 1, [0, 0]),
            ValueError,
            "rk4: f returns the shape (1,), not (2,)",
        ),
        (lambda: furiko.rk4(lambda t, y: 1 // 0, 0, 0.1, 1, 0), ZeroDivisionError, "by zero"),
        (lambda: furiko.verlet(lambda x: 1 // 0, 0.1, 1, 0, 0), ZeroDivisionError, "by zero"),
    ],
)
def test_errors(call, error, message):
    with pytest.raises(error) as caught:
        call()
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


def test_one_number():
    """Of any real type, where there is only one: as of a float"""
    for one in (True, 1, np.int8(1), np.float32(1), np.array(1.0)):
        assert furiko.Modulus(mc=one).m == 0.0
        assert furiko.Pendulum(one).released(one).amplitude == 1.0
    # Beyond 64 bits NumPy takes a whole number for a Python object.
    assert furiko.Modulus(m=-(10**30)).m == -1e30


def test_subclass():
    """Other subclasses of ndarray come back as plain arrays."""

    class Lengths(np.ndarray):
        __array_priority__ = 1

    assert type(furiko.ellipk_m(np.array([0.25, 0.5]).view(Lengths))) is np.ndarray


def scipy_rows():
    """Of doc/python.md: SciPy's name, and what is written here"""
    page = (DATA.parents[1] / "doc/python.md").read_text()
    for line in page.partition("## From SciPy")[2].partition("\n## ")[0].splitlines():
        if line.startswith("| `"):
            name, here = re.findall(r"`([^`]*)`", line)[:2]
            yield name, here


def test_scipy_names():
    """A name of SciPy's is an error that says what it is called here, as the page does."""
    seen = set()
    for call, here in scipy_rows():
        name = call.partition("(")[0]
        if hasattr(furiko, name):
            assert call == here
            continue
        with pytest.raises(AttributeError) as caught:
            getattr(furiko, name)
        message = str(caught.value)
        assert message.startswith(f"module 'furiko' has no attribute '{name}': SciPy's {call} is furiko.{here}"), (
            message
        )
        for named, arguments in re.findall(r"furiko\.(\w+)\(([^)]*)\)", message):
            assert len(inspect.signature(getattr(furiko, named)).parameters) == len(arguments.split(",")) + 1
        seen.add(name)
    assert seen == set(furiko._SCIPY)
    assert furiko._SCIPY.keys().isdisjoint(dir(furiko))
    with pytest.raises(AttributeError, match=r"^module 'furiko' has no attribute 'ellipx'$"):
        _ = furiko.ellipx
    # Python adds no guess of its own to it.
    run = subprocess.run(
        [sys.executable, "-c", "import furiko; furiko.ellipj"], capture_output=True, text=True, check=False
    )
    assert run.stderr.splitlines()[-1].endswith("ph is furiko.jacobi_am_m(u, m)")


def test_threads():
    """The same results from many threads, which take turns as often as they can"""
    m, p = np.linspace(-5, 1, 100_000), furiko.Modulus(m=0.7)
    jobs = [
        lambda: furiko.jacobi_m(m, m),
        lambda: p.jacobi(m),
        lambda: [furiko.jacobi_m(0.5, float(x)) for x in m[:5000]],
        lambda: [furiko.jacobi_m(0.25, float(x)) for x in m[-5000:]],
    ]
    expected = [job() for job in jobs]
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        with ThreadPoolExecutor(8) as threads:
            found = list(threads.map(lambda i: jobs[i % 4](), range(40)))
    finally:
        sys.setswitchinterval(interval)
    for i, result in enumerate(found):
        assert_array_equal(result, expected[i % 4])


def test_modulus():
    p = furiko.Modulus(m=0.75)
    assert near((p.ellipk, p.ellipe, p.nome), (furiko.ellipk_m(0.75), furiko.ellipe_m(0.75), furiko.nome_m(0.75)), 2)
    assert (p.k, p.m, p.mc, p.quarter_period) == (0.75**0.5, 0.75, 0.25, p.ellipk)
    assert p.complement().ellipk == furiko.Modulus(mc=0.75).ellipk
    for form, number in (("k", 0.6), ("mc", 0.64), ("alpha", 0.7), ("amplitude", 1.4)):
        same = {"amplitude": lambda _: furiko.ellipk_alpha(0.7)}.get(form) or getattr(furiko, f"ellipk_{form}")
        assert near(furiko.Modulus(**{form: number}).ellipk, same(number), 2)
    u = np.linspace(-9, 9, 24).reshape(4, 6)
    for q in (p, copy.copy(p), pickle.loads(pickle.dumps(p))):
        assert near(q.jacobi(u), furiko.jacobi_m(u, 0.75), 16)
        assert near(q.am(u), furiko.jacobi_am_m(u, 0.75), 16)
        assert near(q.epsilon(u), furiko.jacobi_epsilon_m(u, 0.75), 16)
    assert_array_equal([p.jacobi(float(x)).sn for x in u.flat], p.jacobi(u).sn.flat)
    assert type(p.am(1)) is float
    out = np.empty_like(u)
    assert p.am(u, out=out) is out
    assert np.isnan(furiko.Modulus(m=np.inf).ellipk)
    assert repr(p) == "Modulus(m=0.75, mc=0.25)"
    with pytest.raises(ValueError, match="stored by version 0"):
        p.__setstate__(("0.0.0", b""))


def test_motion():
    path = furiko.Pendulum(length=0.25, gravity=9.75).released(1.0)
    # By mpmath, as in src/selftest
    times, angles = [0.125, 1000.25], [0.7510970672173277814768, -0.4657508214882975244145]
    omega2 = 39.0
    assert near(path.angle(times), angles, 16)
    assert near(path.angle(0.125), angles[0], 16)
    assert near(np.abs(path.rate(times)), np.sqrt(2 * omega2 * (np.cos(angles) - np.cos(1))), 16)
    assert near(path.tension(times), 3 * np.cos(angles) - 2 * np.cos(1), 16)
    assert near(path.period, 2 * np.pi / omega2**0.5 * furiko.period_ratio(1.0), 4)
    assert near((path.amplitude, path.energy), (1, -omega2 * np.cos(1)), 4)
    assert path.is_libration is True and path.is_rotation is False
    assert near(path.time_to([angles[0], 1.0]), (0.125, 0.0), 16)
    assert np.isnan(path.time_to(1.5)) and np.isnan(path.slack_angle)
    assert near(path.phase(np.array([0.0])), 0.25, 4)
    assert near(path.harmonic_angle(0.125), np.cos(0.125 * omega2**0.5), 16)
    turning = furiko.Pendulum(1.0, 1.0).started(angle=0.0, rate=5.0)
    assert turning.is_rotation and turning.amplitude == np.inf and near(turning.energy, 11.5, 4)
    assert near(furiko.Pendulum(1, 1).started(0, 3**0.5).slack_angle, np.arccos(-1 / 3), 4)
    swinging = furiko.Pendulum(0.25).swinging(-1.0)
    assert near(swinging.angle(swinging.period / 4), -1, 4)
    assert furiko.Pendulum().started(0.0, 0.0).energy == -9.80665
    assert repr(path) == f"<Motion with period {path.period!r} s and amplitude 1.0 rad>"
    assert np.isnan(furiko.Pendulum(length=-1.0).released(1.0).period)
    assert pickle.loads(pickle.dumps(path)).angle(0.125) == path.angle(0.125)


def test_phase():
    """From the bottom on in the direction of the start; from rest in that of growing angles"""
    pendulum = furiko.Pendulum()
    for angle, rate, way in ((1, 0, 1), (-1, 0, 1), (-1, 1, 1), (1, -1, -1), (1, -0.0, -1), (0.5, -20, -1)):
        path = pendulum.started(angle, rate)
        bottom = (1 - path.phase(0.0)) * path.period
        assert abs(np.sin(path.angle(bottom))) < 1e-14
        assert np.sign(path.rate(bottom)) == way
    for angle, phase in ((1.0, 0.25), (-1.0, 0.75)):
        assert near(pendulum.released(angle).phase(0.0), phase, 4)


def test_steps():
    # By mpmath, as in src/selftest
    end = 0.8960326915124886745242, -0.4108778555723738168800
    assert near(furiko.pendulum_rk4(1, 0.125, 4, 1, 0), end, 8)
    assert near(furiko.rk4(lambda t, y: [y[1], -np.sin(y[0])], 0, 0.125, 4, [1, 0]), end, 8)
    angles, omegas = np.linspace(0.1, 3, 5), np.array([[1.0], [1.5]])
    for steps, general in ((furiko.pendulum_verlet, furiko.verlet), (furiko.pendulum_forest_ruth, furiko.forest_ruth)):
        state = steps(omegas, 0.125, 4, angles, 0.25)
        assert state.angle.shape == (2, 5)
        found = general(lambda x: -omegas * np.sin(x), 0.125, 4, np.broadcast_to(angles, (2, 5)), 0.25)
        assert near(found, state, 64)
        assert near(steps(1.5, 0.125, 4, angles, 0.25), (state.angle[1], state.rate[1]), 64)
    assert furiko.pendulum_rk4(np.ones(2, "f"), 0.1, 10, 1, 0).rate.dtype == np.float32
    assert type(furiko.pendulum_rk4(1, 0.1, 10, 1, 0).angle) is float
    assert_array_equal(furiko.pendulum_rk4(1, 0.1, -3, angles, 0).angle, angles)
    # In time, where Simpson's rule is exact; a state of no dimension, and of two
    assert near(furiko.rk4(lambda t, y: t**3, 1.5, 0.125, 4, 0), (2**4 - 1.5**4) / 4, 8)
    states = []
    furiko.rk4(lambda t, y: states.append(y) or -y, 0, 0.1, 3, np.eye(2, dtype="f"))
    assert len(states) == 12 and states[0].dtype == np.float32
    assert_array_equal(states[0], np.eye(2))


def test_help():
    text = inspect.getdoc(furiko.ellipk_m)
    assert str(inspect.signature(furiko.ellipk_m)).startswith("(m: ")
    for part in ("first kind, of the parameter m", "`m <= 1`", "+Inf", "ulp (float64)", "m : array_like"):
        assert part in text
    for name in FUNCTIONS:
        text = inspect.getdoc(getattr(furiko, name))
        assert "[[" not in text and "`call" not in text, name


def test_library():
    """Another library, or none, is an error of import in one line."""
    math = ctypes.util.find_library("m")
    for path, message in (
        ("/none/libfuriko.so", "furiko: /none/libfuriko.so: cannot open"),
        (math, "is not the library of"),
    ):
        environment = {**os.environ, "FURIKO_LIBRARY": path}
        run = subprocess.run(
            [sys.executable, "-c", "import furiko"], env=environment, capture_output=True, text=True, check=False
        )
        assert run.returncode == 1
        assert message in run.stderr.splitlines()[-1]


def test_self():
    assert furiko.selftest() == 0
