"""Long work: reports, stopping, Ctrl-C, threads."""
import os
import subprocess
import sys
import threading
import time

import pytest

import quadloom

MANY = 200_000


@pytest.fixture(scope="module")
def points():
    return quadloom.generate_points("uniform", MANY)


@pytest.mark.parametrize("make", [
    quadloom.quadrangulate_points, quadloom.convex_quadrangulation, quadloom.convex_layers, quadloom.spiral_polygon,
    quadloom.hamiltonian_cycle_triangulation, quadloom.serpentine_triangulation,
    lambda points, progress: quadloom.quadrangulate_triangles(quadloom.delaunay(points), progress=progress),
    lambda points, progress: quadloom.encode_strips(quadloom.delaunay(points), progress=progress),
    lambda points, progress: quadloom.constrained_delaunay(points=points, extent="hull", progress=progress),
])
def test_reports(points, make):
    reports = []
    make(points, progress=lambda stage, done: reports.append((stage, done)))
    assert reports
    assert all(isinstance(stage, str) and stage and 0 <= done <= 1 for stage, done in reports)


def test_false_stops(points):
    for last in (1, 3):
        reports = []

        def stop(stage, done):
            reports.append(stage)
            return len(reports) < last

        with pytest.raises(quadloom.Error, match="stopped during " + ("input" if last == 1 else "")) as caught:
            quadloom.quadrangulate_points(points, progress=stop)
        assert caught.value.code == "cancelled"
        assert len(reports) == last


def test_an_exception_stops_and_comes_through(points):
    class Enough(Exception):
        pass

    def raise_it(stage, done):
        raise Enough(stage)

    with pytest.raises(Enough) as caught:
        quadloom.quadrangulate_points(points, progress=raise_it)
    assert caught.traceback[-1].name == "raise_it"
    quadloom.quadrangulate_points(points[:100])  # all is well again


INTERRUPTED = """
import os, signal, sys, threading, time
import quadloom

points = quadloom.generate_points("uniform", 500_000)
triangles = quadloom.delaunay(points)
graph, weight = quadloom.dual_graph(triangles), quadloom.shape_weights(triangles)
work = {
    "spiral": lambda: quadloom.quadrangulate_points(points, method="spiral"),
    "triangles": lambda: quadloom.quadrangulate_triangles(triangles),
    "matching": lambda: quadloom.maximum_weight_matching(graph, weight, "weight"),
}[sys.argv[1]]
begin = time.process_time()
work()
whole = time.process_time() - begin
threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT)).start()
begin = time.process_time()
try:
    work()
except KeyboardInterrupt:
    print((time.process_time() - begin) / whole)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="there are no such signals")
@pytest.mark.parametrize("work", ["spiral", "triangles", "matching"])
def test_ctrl_c_interrupts(work):
    """A signal early on ends the work long before it is done: the share of its processor time tells."""
    done = subprocess.run([sys.executable, "-c", INTERRUPTED, work], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert float(done.stdout) < 0.6


def test_other_threads_run_meanwhile():
    """Without the GIL this thread counts while the other works."""
    points = quadloom.generate_points("uniform", 2_000_000)
    done = threading.Event()
    count = 0
    at_the_start, in_between = threading.Event(), []

    def work():
        at_the_start.set()
        quadloom.delaunay(points)  # it has no reports, so never takes the GIL in between
        in_between.append(count)
        done.set()

    thread = threading.Thread(target=work)
    switch = sys.getswitchinterval()
    sys.setswitchinterval(3600)  # a thread that holds the GIL keeps it
    try:
        thread.start()
        at_the_start.wait()
        while not done.is_set():
            count += 1
            time.sleep(0)
    finally:
        sys.setswitchinterval(switch)
    thread.join()
    assert in_between[0] > 10


def test_a_limit_of_threads(points):
    """Works inside of another one and after an exception, and the results are the same."""
    free = quadloom.delaunay(points)
    with quadloom.thread_limit(4), quadloom.thread_limit(threads=1):
        assert (quadloom.delaunay(points).triangles == free.triangles).all()
    limit = quadloom.thread_limit(1)
    with pytest.raises(ZeroDivisionError), limit:
        1 / 0
    with limit:
        assert (quadloom.delaunay(points).triangles == free.triangles).all()
    with pytest.raises(quadloom.Error, match="at least one thread"):
        quadloom.thread_limit(0)


def test_a_limit_within_itself():
    """The inner end leaves the outer limit."""
    limit = quadloom.thread_limit(1)
    assert not limit.holds
    for _ in range(2):
        with limit:
            with limit:
                assert limit.holds
            assert limit.holds
        assert not limit.holds


FORKED = """
import os, quadloom
points = quadloom.generate_points("uniform", 200_000)
here = quadloom.delaunay(points).triangles
child = os.fork()
if child == 0:
    os._exit(0 if (quadloom.delaunay(points).triangles == here).all() else 3)
print(os.waitpid(child, 0)[1])
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
def test_a_forked_process_works_on():
    """As multiprocessing starts processes, by default on Linux: without the threads of its parent."""
    done = subprocess.run([sys.executable, "-c", FORKED], capture_output=True, text=True, timeout=60)
    assert done.stdout == "0\n", done.stderr


def test_two_threads_give_what_one_gives(points):
    results = {}

    def work(name, method):
        results[name] = quadloom.quadrangulate_points(points[:50_000], method=method, progress=lambda *_: None)

    threads = [threading.Thread(target=work, args=(i, method)) for i, method in enumerate(["delaunay", "spiral"] * 2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert (results[0].quads == results[2].quads).all() and (results[1].quads == results[3].quads).all()
