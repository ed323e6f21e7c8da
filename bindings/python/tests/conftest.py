"""What the tests share: inputs, and how hypothesis reports what it found."""
import pathlib

import hypothesis
import pytest

import quadloom

hypothesis.settings.register_profile("quadloom", deadline=None, print_blob=True, max_examples=60)
hypothesis.settings.load_profile("quadloom")


@pytest.fixture(scope="session")
def towns():
    return quadloom.generate_points("clusters", 300, seed=3)


@pytest.fixture(scope="session")
def lake():
    """A polygon with holes, as rings."""
    return quadloom.with_holes(quadloom.generate_polygon("two-opt", 60, seed=2), 4, seed=2)


@pytest.fixture(scope="session")
def source():
    """The source tree, for what the package must agree with."""
    return pathlib.Path(__file__).resolve().parents[3]
