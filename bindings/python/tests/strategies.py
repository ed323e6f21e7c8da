"""Arrays of points, of all kinds that people may have."""
import numpy as np
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

_few = st.integers(0, 4).map(float)  # many collinear, cocircular and equal ones
_some = st.floats(-1e3, 1e3, width=32)
_any = st.floats()  # NaN, infinities, subnormal numbers


def points(elements=st.one_of(_few, _some, _any)):
    """float64 (n, 2)."""
    return st.integers(0, 40).flatmap(lambda n: hnp.arrays(np.float64, (n, 2), elements=elements))


def finite_points():
    return points(st.one_of(_few, _some))


def one_of_a_kind():
    """Arrays whose elements are all of one of the kinds."""
    return st.one_of(points(_few), points(_some), points(_any))
