"""The finite elements of examples/finite-elements: bilinear ones converge in the order of their theory."""
import importlib.util
import pathlib

import pytest

ROOT = pathlib.Path(__file__).parents[3]


def example():
    spec = importlib.util.spec_from_file_location("poisson", ROOT / "examples/finite-elements/poisson.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


poisson = example()
PAGE = (ROOT / "docs/finite-elements.md").read_text()


@pytest.mark.parametrize("name", poisson.SERIES)
def test_the_order_is_that_of_bilinear_elements(name):
    rows = poisson.measure(*poisson.SERIES[name])
    print(poisson.table(name, rows))
    for errors, expected in ((rows[:, 3], 2), (rows[:, 4], 1)):
        order, margin = poisson.order(rows[:, 2], errors)
        assert margin < 0.2
        assert abs(order - expected) <= margin
    assert poisson.table(name, rows) in PAGE
