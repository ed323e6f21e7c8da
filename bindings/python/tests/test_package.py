"""The package as it is installed: its parts, its command line, what it takes of memory."""
import importlib.metadata
import importlib.resources
import re
import subprocess
import sys

import pytest

import quadloom


def run(*arguments, **options):
    return subprocess.run([sys.executable, "-m", "quadloom", *arguments], capture_output=True, text=True, **options)


def test_the_version_is_that_of_the_source(source):
    version = re.search(r"project\(quadloom VERSION ([\d.]+)", (source / "CMakeLists.txt").read_text())[1]
    assert quadloom.__version__ == importlib.metadata.version("quadloom") == version
    assert run("--version").stdout == f"quadloom {version}\n"


def test_the_licence_comes_along(source):
    files = importlib.metadata.files("quadloom")
    licence = [f for f in files if f.name == "LICENSE"]
    assert licence and licence[0].read_text() == (source / "LICENSE").read_text()


def test_numpy_alone_is_needed():
    needed = [r for r in importlib.metadata.requires("quadloom") if "extra" not in r]
    assert [re.match(r"[\w-]+", r)[0] for r in needed] == ["numpy"]
    code = "import sys, quadloom; print({m.split('.')[0] for m in sys.modules} & {'matplotlib', 'scipy', 'shapely'})"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "set()\n"


def test_types_come_along():
    package = importlib.resources.files("quadloom")
    assert (package / "py.typed").is_file()
    stub = (package / "_core.pyi").read_text()
    compile(stub, "_core.pyi", "exec")
    assert "::" not in stub  # a C++ name where a Python one should be
    for name in quadloom.__all__:
        if getattr(getattr(quadloom, name), "__module__", "") == "quadloom._core":
            assert re.search(rf"^(class|def) {name}\b|^    def {name}\b", stub, re.MULTILINE), name


def test_everything_has_a_docstring():
    for name in quadloom.__all__:
        thing = getattr(quadloom, name)
        if callable(thing):
            assert thing.__doc__ and len(thing.__doc__) > 20, name
        for _, doc, *_ in getattr(thing, "__nb_signature__", ()):  # __doc__ begins with the signatures
            assert doc and len(doc) > 10, name


def test_every_function_of_the_headers_is_here(source):
    """Free functions at the start of a line; those of a few lines inline in the header are C++'s own."""
    inline = {"next_halfedge", "previous_halfedge", "triangle_of", "lex_less", "report_progress"}
    known = {"blends": "interpolate", "carry_values": "interpolate", "steiner_bound": "guarantee"}  # of results
    declaration = re.compile(r"^[A-Za-z][\w:<>, ]*[ >&*](\w+)\((?!\))", re.MULTILINE)
    names = set()
    for header in (source / "include/quadloom").glob("*.hpp"):
        text = re.sub(r"//.*", "", header.read_text())
        text = re.sub(r"^(struct|class|enum)\b.*?^\};", "", text, flags=re.MULTILINE | re.DOTALL)
        names |= set(declaration.findall(text))
    assert len(names) > 70
    for name in names - inline:
        assert hasattr(quadloom, name) or hasattr(quadloom.Mesh, known.get(name, name)), name


def test_the_command_line(tmp_path):
    points = run("generate", "uniform", "-n", "50", "-o", "-")
    assert points.returncode == 0 and len(points.stdout.splitlines()) == 50
    out = tmp_path / "mesh.obj"
    made = run("quadrangulate", "-", "-o", str(out), input=points.stdout)
    assert made.returncode == 0 and "certified" in made.stdout + made.stderr
    assert len(quadloom.read_mesh(out).points) >= 50


@pytest.mark.parametrize("arguments, code", [(["--help"], 0), (["no-such-verb"], 2), (["quality", "no/such.obj"], 3)])
def test_exit_codes(arguments, code):
    assert run(*arguments).returncode == code


def resident():
    with open("/proc/self/statm") as statm:
        return int(statm.read().split()[1]) * 4096


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_nothing_leaks():
    """Many results of some megabytes each, errors, cancelled work and views of all of it."""
    points = quadloom.generate_points("uniform", 20_000)
    triangles = quadloom.delaunay(points)

    def work():
        result = quadloom.quadrangulate_points(points)
        _ = result.points, result.quads, result.is_steiner, result.steiner, result.statistics.as_dict()
        quadloom.certify_points(result, points)
        quadloom.quadrangulate_triangles(triangles.points.tolist(), triangles.triangles.tolist())
        with pytest.raises(quadloom.Error):
            quadloom.quadrangulate_points(points, progress=lambda *_: False)
        with pytest.raises(quadloom.Error):
            quadloom.quadrangulate_points([[0, 0], *points.tolist(), [float("nan"), 0]])

    for _ in range(5):
        work()
    before = resident()
    for _ in range(25):
        work()
    assert resident() - before < 40e6
