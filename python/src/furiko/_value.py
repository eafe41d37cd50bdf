# SPDX-License-Identifier: MIT
"""What C keeps in the caller's storage, a modulus or a motion."""

from ctypes import c_double, c_void_p
from typing import Any

from ._library import library, quick_library
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

    def _fill(self, name: str, *numbers: float) -> None:
        """By the function of this name from these numbers"""
        function = library[f"furiko_{name}"]
        function.argtypes = [c_void_p] + [c_double] * len(numbers)
        function.restype = None
        self._value = (c_double * (self._bytes // 8))()
        function(self._value, *map(float, numbers))

    def __getstate__(self) -> Any:
        return __version__, bytes(self._value)

    def __setstate__(self, state: Any) -> None:
        version, value = state
        if version != __version__:
            raise ValueError(f"furiko: stored by version {version}, which {__version__} cannot read")
        self._value = (c_double * (self._bytes // 8)).from_buffer_copy(value)
