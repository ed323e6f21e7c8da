#!/usr/bin/env python3
"""docs/benchmarks.md and its plot are what bench/compare makes of the figures in docs/benchmarks.

    benchmarks_check.py ROOT         says what is not
    benchmarks_check.py --self-test  shows that a changed figure, page or plot is found
"""
import html
import pathlib
import re
import shutil
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "bench"))
import benchmark_page  # noqa: E402
import benchmark_plot  # noqa: E402


def faults(docs):
    if (docs / "benchmarks.md").read_text() != benchmark_page.make(docs):
        yield "docs/benchmarks.md is not what docs/benchmarks/*.json and bench/benchmarks.md.in make: run bench/compare --page"
    drawn = re.search("<dc:description>(.*?)</dc:description>", (docs / "benchmarks/seconds.svg").read_text(), re.DOTALL)
    if drawn is None or html.unescape(drawn[1]) != benchmark_plot.description(docs):
        yield "docs/benchmarks/seconds.svg is not drawn from docs/benchmarks/*.json: run bench/compare --page"


def self_test():
    def after(name, change):
        with tempfile.TemporaryDirectory() as folder:
            docs = pathlib.Path(folder, "docs")
            (docs / "benchmarks").mkdir(parents=True)
            for path in [ROOT / "docs/benchmarks.md", *(ROOT / "docs/benchmarks").iterdir()]:
                shutil.copy(path, docs / path.relative_to(ROOT / "docs"))
            path = docs / name
            changed = change(path.read_text())
            assert changed != path.read_text(), f"nothing to change in {name}"
            path.write_text(changed)
            return [*faults(docs)]

    def doubled(text):
        return re.sub(r'"seconds": \[(.*?)\]', lambda m: f'"seconds": [{", ".join(str(2 * float(s)) for s in m[1].split(","))}]', text)

    assert not [*faults(ROOT / "docs")], "the tree as it is"
    assert len(after("benchmarks/delaunay.json", doubled)) == 2
    assert len(after("benchmarks/strips.json", doubled)) == 1
    assert len(after("benchmarks.md", lambda text: text.replace("1", "2", 1))) == 1
    assert len(after("benchmarks/seconds.svg", lambda text: text.replace("<dc:description>{", "<dc:description>{ "))) == 1
    print("the tree passes, changed figures, page and plot are found")


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    else:
        found = [*faults(pathlib.Path(sys.argv[1]) / "docs")]
        sys.exit("\n".join(found) if found else 0)
