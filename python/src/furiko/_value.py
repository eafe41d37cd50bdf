# SPDX-License-Identifier: MIT
"""What C keeps in the caller's storage, a modulus or a motion."""

from ctypes import c_double, c_void_p
from typing import Any

from ._library import library, quick_library
from ._routine import number_of
from ._version import __version__


def constant(name: str, doc: str, result: type = c_double) -> property:
    """A number that a value tells of itself, as a property"""
    function = quick_library[f"furiko_{name}"]
    function.argtypes = [c_void_p]
    function.restype = result
    return property(lambda self: function(self._value), doc=doc)


class Value:
    """A value of C, which the library fills once and then only reads; `_bytes` is its size."""

    __slots__ = ("_value",)
    _bytes: int

    def _fill(self, function_name: str, name: str, **numbers: float) -> None:
        """By a function of C from these numbers; `name` is Python's, for errors"""
        function = library[f"furiko_{function_name}"]
        function.argtypes = [c_void_p] + [c_double] * len(numbers)
        function.restype = None
        self._value = (c_double * (self._bytes // 8))()
        function(self._value, *(number_of(name, argument, number) for argument, number in numbers.items()))

    def __getstate__(self) -> Any:
        return __version__, bytes(self._value)

    def __setstate__(self, state: Any) -> None:
        version, value = state
        if version != __version__:
            raise ValueError(f"furiko: stored by version {version}, which {__version__} cannot read")
        self._value = (c_double * (self._bytes // 8)).from_buffer_copy(value)
