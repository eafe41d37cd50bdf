# SPDX-License-Identifier: MIT
"""The pendulum and its exact motion."""

from dataclasses import dataclass
from typing import Any

from numpy.typing import ArrayLike

from ._library import library
from ._routine import Out, Routine, number_of
from ._value import Value, constant

_angle = Routine("motion_angle", ("time",), heads=1)
_rate = Routine("motion_rate", ("time",), heads=1)
_tension = Routine("motion_tension", ("time",), heads=1)
_harmonic_angle = Routine("motion_harmonic_angle", ("time",), heads=1)
_phase = Routine("motion_phase", ("time",), heads=1)
_time_to = Routine("motion_time_to", ("angle",), heads=1)


class Motion(Value):
    """An exact motion of a pendulum without friction, in float64, made by a Pendulum.

    Time in seconds, which may be negative, angles in radians from the bottom; in rotation they go on beyond pi. Times
    and angles are numbers or arrays. A motion does not change: share it among threads.

    Accuracy: the angle to 4 epsilon absolute (relative, where turns have piled up) for |t| up to 10^6 periods, also
    next to the separatrix; the rate likewise, as a part of its largest value.
    """

    __slots__ = ()
    _bytes = library.furiko_motion_size()

    def __init__(self) -> None:
        raise TypeError("a Motion is made by a Pendulum: Pendulum(length=1.0).released(angle=0.5)")

    @classmethod
    def _made(cls, start: str, pendulum: "Pendulum", **numbers: float) -> "Motion":
        self = cls.__new__(cls)
        self._fill(f"motion_{start}", start, length=pendulum.length, gravity=pendulum.gravity, **numbers)
        return self

    period = constant("motion_period", "Of a full swing to and fro, or of a full turn, seconds; infinite in between.")
    amplitude = constant("motion_amplitude", "The largest angle, radians; infinite in rotation.")
    energy = constant("motion_energy", "rate^2/2 - g/l cos(angle), s^-2.")
    is_libration = constant("motion_is_libration", "True where it swings to and fro.", bool)
    is_rotation = constant("motion_is_rotation", "True where it goes over the top.", bool)
    slack_angle = constant("motion_slack_angle", "The angle at which a string would go slack first; NaN if never.")

    def angle(self, time: ArrayLike, *, out: Out = None) -> Any:
        """The angle at a time, radians."""
        return _angle(out, time, head=(self._value,))

    def rate(self, time: ArrayLike, *, out: Out = None) -> Any:
        """The rate of the angle at a time, radians per second."""
        return _rate(out, time, head=(self._value,))

    def tension(self, time: ArrayLike, *, out: Out = None) -> Any:
        """What pulls the rod at a time, over the weight; negative where the rod pushes."""
        return _tension(out, time, head=(self._value,))

    def harmonic_angle(self, time: ArrayLike, *, out: Out = None) -> Any:
        """The angle of the small-angle motion from the same state, radians."""
        return _harmonic_angle(out, time, head=(self._value,))

    def phase(self, time: ArrayLike, *, out: Out = None) -> Any:
        """The part of a period since the bottom was passed in the direction of the start, from 0 up to 1.

        That direction is the sign of the rate at the time 0; where it was 0, that of growing angles (of falling ones
        where it was -0.0).
        """
        return _phase(out, time, head=(self._value,))

    def time_to(self, angle: ArrayLike, *, out: Out = None) -> Any:
        """When the angle is reached first, seconds from the time 0 on; NaN if never."""
        return _time_to(out, angle, head=(self._value,))

    def __repr__(self) -> str:
        return f"<Motion with period {self.period!r} s and amplitude {self.amplitude!r} rad>"


@dataclass(frozen=True)
class Pendulum:
    """A point mass on a rod without mass: length in metres, gravity in metres per square second, both above 0.

    >>> path = Pendulum(length=0.25).released(angle=1.0)
    >>> path.period
    1.0697514696687809
    >>> path.angle([0.1, 1.0e6])
    array([ 0.83799773, -0.9191998 ])
    """

    length: float = 1.0
    gravity: float = 9.80665

    def __post_init__(self) -> None:
        number_of("Pendulum", "length", self.length)
        number_of("Pendulum", "gravity", self.gravity)

    def released(self, angle: float) -> Motion:
        """At rest at an angle, radians, at the time 0."""
        return Motion._made("released", self, angle=angle)

    def swinging(self, amplitude: float) -> Motion:
        """Through the bottom at the time 0, up to an amplitude; a negative one swings to the other side first."""
        return Motion._made("swinging", self, amplitude=amplitude)

    def started(self, angle: float, rate: float) -> Motion:
        """Any angle, radians, and any rate, radians per second, at the time 0."""
        return Motion._made("started", self, angle=angle, rate=rate)
