# SPDX-License-Identifier: MIT
"""A function of the library for Python numbers, NumPy scalars and arrays that are broadcast, as NumPy's ufuncs are."""

from collections.abc import Callable, Sequence
from ctypes import addressof, c_double, c_float, c_size_t, c_void_p, sizeof
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.ma import MaskedArray
from numpy.typing import ArrayLike, NDArray

from ._library import library, quick_library

Out = Optional[NDArray[Any]]
Outs = Optional[tuple[Out, ...]]
FLOAT64, FLOAT32 = np.dtype(np.float64), np.dtype(np.float32)
# What C's names end in, and C's type
KINDS = {FLOAT64: ("", c_double), FLOAT32: ("f", c_float)}
# Python's numbers adapt to the arrays and NumPy scalars beside them.
PYTHON = {float, int, bool}
SCALARS = PYTHON | {np.float64, np.float32}
FLAGS = ["external_loop", "buffered", "growinner", "zerosize_ok", "copy_if_overlap"]
READ = ["readonly", "contig"]
WRITE = ["writeonly", "contig", "allocate", "no_broadcast", "no_subtype"]


def array_of(name: str, argument: str, given: ArrayLike) -> NDArray[Any]:
    """An argument of the function `name` as an array of real numbers; anything else is a TypeError"""
    if isinstance(given, MaskedArray):
        raise TypeError(
            f"{name}: {argument} is a masked array, whose mask would be lost: use np.ma.array(f(x.data), mask=x.mask)"
        )
    array = np.asarray(given)
    if array.dtype.kind not in "biuf" or array.dtype.itemsize > 8:
        raise TypeError(f"{name}: {argument} is {_described(given, array)}, not real numbers of 64 or 32 bits")
    return array


def _described(given: Any, array: NDArray[Any]) -> str:
    """What is not of real numbers, in words"""
    if given is None:
        return "None"
    if array.dtype.kind in "UST":
        return "an array of strings" if array.ndim else "a string"
    if array.dtype.kind == "O":
        return "an array of Python objects" if array.ndim else f"of type {type(given).__name__}"
    return array.dtype.name


def number_of(name: str, argument: str, given: ArrayLike) -> float:
    """An argument of which there is only one number, with the same check"""
    if type(given) in PYTHON:
        return float(given)
    array = array_of(name, argument, given)
    if array.ndim:
        raise TypeError(f"{name}: {argument} is an array of the shape {array.shape}, not one number")
    return float(array)


def kind_of(given: Sequence[ArrayLike], arrays: Sequence[NDArray[Any]]) -> np.dtype[Any]:
    """float32 or float64 by NumPy's rule, for numbers and arrays as they were given and as arrays"""
    kinds = [array.dtype for number, array in zip(given, arrays) if type(number) not in PYTHON]
    return np.result_type(FLOAT32, *kinds) if kinds else FLOAT64


class Routine:
    """A function `furiko_name` of C with its sisters of float and of arrays.

    `arguments` are their names, `values` is the tuple of several results. A method of a modulus or a motion takes
    that first, `heads` = 1, and is of float64 alone.
    """

    def __init__(
        self, name: str, arguments: tuple[str, ...], values: Optional[type[NamedTuple]] = None, heads: int = 0
    ):
        self.name, self.arguments, self.values, self.heads = name, arguments, values, heads
        self.results = len(values._fields) if values else 1
        kinds = [FLOAT64] if heads else KINDS
        self.ones = {kind: self._one(*KINDS[kind]) for kind in kinds}
        self.many = {kind: self._many(KINDS[kind][0]) for kind in kinds}
        self.one = self.ones[FLOAT64]

    def _one(self, suffix: str, number: type) -> Callable[..., Any]:
        """Of floats: a float, or a tuple of them"""
        function = quick_library[f"furiko_{self.name}{suffix}"]
        function.argtypes = [c_void_p] * self.heads + [number] * len(self.arguments)
        if not self.values:
            function.restype = number
            return function
        function.argtypes += [c_void_p] * self.results
        function.restype = None
        make, room, offsets = (
            self.values._make,
            number * self.results,
            [sizeof(number) * i for i in range(self.results)],
        )

        def one(*arguments: float) -> Any:
            results = room()
            address = addressof(results)
            function(*arguments, *[address + offset for offset in offsets])
            return make(results)

        return one

    def _many(self, suffix: str) -> Callable[..., None]:
        """Of arrays: the head, the count, and where they begin"""
        name = f"furiko_{self.name}_v{suffix}"
        if not hasattr(library, name):
            return self._one_by_one
        function = library[name]
        function.argtypes = [c_void_p] * self.heads + [c_size_t] + [c_void_p] * (len(self.arguments) + self.results)
        function.restype = None
        return function

    def _one_by_one(self, value: Any, count: int, argument: int, result: int) -> None:
        """A method that has no sister of arrays"""
        arguments, results = ((c_double * count).from_address(address) for address in (argument, result))
        for i, number in enumerate(arguments):
            results[i] = self.one(value, number)

    def __call__(self, out: Union[Out, Outs], *given: ArrayLike, head: Sequence[Any] = ()) -> Any:
        """Of anything: `out` is an array or None, or a tuple of them where there are several results."""
        kinds = set(map(type, given))
        if out is None and kinds <= PYTHON:
            return self.one(*head, *map(float, given))
        if out is None and kinds <= SCALARS:
            kind = FLOAT32 if np.float64 not in kinds and not self.heads else FLOAT64
            result = self.ones[kind](*head, *map(float, given))
            return self.values._make(map(kind.type, result)) if self.values else kind.type(result)
        outs = self._outs(out)
        arrays = [array_of(self.name, argument, number) for argument, number in zip(self.arguments, given)]
        kind = FLOAT64 if self.heads else kind_of(given, arrays)
        count = len(arrays) + self.results
        flags = [READ] * len(arrays) + [WRITE] * self.results
        with np.nditer([*arrays, *outs], FLAGS, flags, [kind] * count, casting="same_kind") as blocks:
            for block in blocks:
                self.many[kind](*head, block[0].size, *[part.ctypes.data for part in block])
            made = blocks.operands[len(arrays) :]
        results = [
            asked if asked is not None else array if array.ndim else array[()] for array, asked in zip(made, outs)
        ]
        return self.values._make(results) if self.values else results[0]

    def _outs(self, out: Union[Out, Outs]) -> Sequence[Out]:
        """An array or None for each result"""
        if out is None:
            return [None] * self.results
        outs = out if self.values else (out,)
        if not isinstance(outs, tuple) or len(outs) != self.results:
            raise TypeError(f"{self.name}: out is not a tuple of {self.results} arrays")
        for array in outs:
            is_array = isinstance(array, np.ndarray) and not isinstance(array, MaskedArray)
            if not is_array and not (array is None and self.values):
                raise TypeError(f"{self.name}: out is of type {type(array).__name__}, not an array")
        return outs
