# SPDX-License-Identifier: MIT
"""Equations of motion step by step: many pendulums at once, and any system whose right-hand side is Python's."""

from collections.abc import Callable
from ctypes import CFUNCTYPE, c_int, c_size_t, c_void_p
from operator import index
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._library import library
from ._routine import KINDS, PYTHON, array_of, kind_of, number_of


class State(NamedTuple):
    """Where pendulums are, radians, and how fast they go, radians per unit of time."""

    angle: Any
    rate: Any


class Coordinates(NamedTuple):
    """Coordinates and velocities of a system x'' = a(x)."""

    x: Any
    v: Any


def _count(name: str, steps: int) -> int:
    """Steps, as C counts them"""
    steps = index(steps)
    if steps >= 2**31:
        raise ValueError(f"{name}: steps is {steps}, more than 2**31 - 1")
    return max(steps, 0)


def _pendulum(method: str, omega2: ArrayLike, h: float, steps: int, angle: ArrayLike, rate: ArrayLike) -> State:
    name = f"pendulum_{method}"
    given = (omega2, angle, rate)
    arrays = [array_of(name, argument, number) for argument, number in zip(("omega2", "angle", "rate"), given)]
    kind = kind_of(given, arrays)
    suffix, number = KINDS[kind]
    shape = np.broadcast_shapes(*(array.shape for array in arrays))
    omegas, angles, rates = (np.array(np.broadcast_to(array, shape), kind, order="C") for array in arrays)
    function = library[f"furiko_{name}{'_same' if arrays[0].ndim == 0 else ''}{suffix}"]
    first = number(arrays[0]) if arrays[0].ndim == 0 else c_void_p(omegas.ctypes.data)
    starts = c_void_p(angles.ctypes.data), c_void_p(rates.ctypes.data)
    step = number(number_of(name, "h", h))
    function(c_size_t(angles.size), first, step, c_int(_count(name, steps)), *starts)
    if angles.ndim:
        return State(angles, rates)
    return State(*(part.item() if set(map(type, given)) <= PYTHON else part[()] for part in (angles, rates)))


def pendulum_rk4(omega2: ArrayLike, h: float, steps: int, angle: ArrayLike, rate: ArrayLike) -> State:
    """Runge-Kutta steps of equal size for pendulums, angle'' = -omega2 sin(angle), as many as there are.

    `omega2` = g/l, `angle` (radians) and `rate` are numbers or arrays, and are broadcast; with one omega2 for all,
    they are computed side by side, which is some times as fast. The step `h` may be below 0; with `steps` <= 0
    nothing is done. The arrays that were given stay as they are.

    >>> pendulum_rk4(omega2=1.0, h=0.125, steps=4, angle=1.0, rate=0.0)
    State(angle=0.8960326915124885, rate=-0.41087785557237383)
    """
    return _pendulum("rk4", omega2, h, steps, angle, rate)


def pendulum_verlet(omega2: ArrayLike, h: float, steps: int, angle: ArrayLike, rate: ArrayLike) -> State:
    """Verlet's steps for pendulums, with the arguments of pendulum_rk4."""
    return _pendulum("verlet", omega2, h, steps, angle, rate)


def pendulum_forest_ruth(omega2: ArrayLike, h: float, steps: int, angle: ArrayLike, rate: ArrayLike) -> State:
    """Forest and Ruth's steps for pendulums, with the arguments of pendulum_rk4."""
    return _pendulum("forest_ruth", omega2, h, steps, angle, rate)


class _Callback:
    """The right-hand side for C: from and to the memory of the integrator, errors kept for later.

    A state is handed over as a copy, since the integrator's memory is gone when it returns.
    """

    def __init__(self, name: str, f: Callable[..., ArrayLike], shape: tuple[int, ...], number: type):
        self.name, self.f, self.shape = name, f, shape
        self.block = number * int(np.prod(shape))
        self.views: dict[int, NDArray[Any]] = {}
        self.error: list[BaseException] = []

    def view(self, address: int) -> NDArray[Any]:
        if address not in self.views:
            self.views[address] = np.frombuffer(self.block.from_address(address), self.block._type_).reshape(self.shape)
        return self.views[address]

    def put(self, at: int, to: int, *time: float) -> None:
        try:
            if not self.error:
                change = array_of(self.name, "what f returns", self.f(*time, self.view(at).copy()))
                if change.shape != self.shape:
                    raise ValueError(f"{self.name}: f returns the shape {change.shape}, not {self.shape}")
                self.view(to)[...] = change
        except BaseException as error:  # C cannot hand it on: all else is NaN, and it is raised in the end
            self.error.append(error)
        if self.error:
            self.view(to)[...] = np.nan


def _run(name: str, f: Callable[..., ArrayLike], times: dict[str, float], steps: int, **states: ArrayLike) -> Any:
    """The states after the steps; `times` are the step and, of rk4, before it the time of the first state"""
    arrays = [array_of(name, argument, state) for argument, state in states.items()]
    kind = kind_of(list(states.values()), arrays)
    suffix, number = KINDS[kind]
    results = [np.array(array, kind, order="C") for array in np.broadcast_arrays(*arrays)]
    callback = _Callback(name, f, results[0].shape, number)
    if "t0" in times:
        given = CFUNCTYPE(None, number, c_void_p, c_void_p, c_void_p)(lambda t, y, dy, _: callback.put(y, dy, t))
    else:
        given = CFUNCTYPE(None, c_void_p, c_void_p, c_void_p)(lambda x, a, _: callback.put(x, a))
    numbers = [number(number_of(name, argument, time)) for argument, time in times.items()]
    starts = [c_void_p(result.ctypes.data) for result in results]
    library[f"furiko_{name}{suffix}"](
        given, None, c_size_t(results[0].size), *numbers, c_int(_count(name, steps)), *starts
    )
    if callback.error:
        raise callback.error[0]
    return [result if result.ndim else result[()] for result in results]


def rk4(f: Callable[[float, Any], ArrayLike], t0: float, h: float, steps: int, y: ArrayLike) -> Any:
    """Runge-Kutta steps of equal size for y' = f(t, y), any number of equations; the state after them.

    `f` takes the time and the state, an array of the shape of `y`, and returns y' of that shape; `t0` is the time of
    `y`. The step `h` may be below 0; with `steps` <= 0 nothing is done. An error in `f` ends it.

    >>> rk4(lambda t, y: [y[1], -y[0]], t0=0.0, h=0.01, steps=100, y=[0.0, 1.0])
    array([0.84147098, 0.54030231])
    """
    return _run("rk4", f, {"t0": t0, "h": h}, steps, y=y)[0]


def verlet(f: Callable[[Any], ArrayLike], h: float, steps: int, x: ArrayLike, v: ArrayLike) -> Coordinates:
    """Stoermer-Verlet steps of equal size for x'' = f(x), any number of coordinates: symplectic, of order h^2.

    `f` takes the coordinates, an array of the shape of `x` and `v`, and returns x'' of that shape.

    >>> verlet(lambda x: -x, h=0.01, steps=100, x=[0.0], v=[1.0])
    Coordinates(x=array([0.84146272]), v=array([0.5402988]))
    """
    return Coordinates(*_run("verlet", f, {"h": h}, steps, x=x, v=v))


def forest_ruth(f: Callable[[Any], ArrayLike], h: float, steps: int, x: ArrayLike, v: ArrayLike) -> Coordinates:
    """Forest and Ruth's steps for x'' = f(x), with the arguments of verlet: symplectic, of order h^4."""
    return Coordinates(*_run("forest_ruth", f, {"h": h}, steps, x=x, v=v))
