#!/usr/bin/env python3
"""Checks which folder includes which (docs/architecture.md). Prints each offending line.

    rooms_check.py ROOT         checks the tree under ROOT
    rooms_check.py --self-test  shows on small made-up trees that each rule can fail
"""
import pathlib
import re
import sys
import tempfile

# The rooms of src/ in the order of the pipeline, each with the rooms that it may include.
ROOMS = {
    "core": [],
    "kernel": ["core"],
    "dual": ["core", "kernel"],
    "quadrangulate": ["core", "kernel", "dual"],
    "convex": ["core", "kernel", "dual", "quadrangulate"],
    "strips": ["core", "kernel", "dual", "quadrangulate", "convex"],
    "certify": ["core", "kernel"],  # so that it can judge the rest
    "generate": ["core", "kernel"],
    "io": ["core", "kernel", "dual", "quadrangulate", "convex", "strips", "certify"],
}
THREADS = "src/core/parallel.cpp"  # the one file that includes oneTBB
HUGE_PAGES = "src/core/large_array.cpp"  # the one file that asks Linux for them
LIBRARY = [room for room in ROOMS if room != "io"]  # needs the standard library and Boost's headers
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
STANDARD = re.compile(r"^[a-z_0-9]+$")


def includes(path):
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if found := INCLUDE.match(line):
            yield number, line, found[1], found[2]


def room_of_include(name):
    """The room that an include in quotes is in; None if it is in none."""
    parts = name.split("/")
    if len(parts) != 2:
        return None
    room = parts[1].removesuffix(".hpp") if parts[0] == "quadloom" else parts[0]
    return room if room in ROOMS else None


def fault_of(file, room, public, quote, name):
    """What is wrong with one include in a file of the room, or None."""
    if quote == "<":
        if name.startswith("tbb/"):
            return None if file == THREADS else f"threads are {THREADS}'s"
        if name == "sys/mman.h" and file == HUGE_PAGES:
            return None
        if room == "io" and not public or STANDARD.match(name):
            return None
        if not name.startswith("boost/"):
            return "the library needs the standard library and Boost's headers alone"
        return "a public header needs the standard library alone" if public else None
    if public and not name.startswith("quadloom/"):
        return "a public header includes public headers alone"
    if name == "quadloom/version.hpp":
        return None
    target = room_of_include(name)
    if target is None:
        return 'not "quadloom/ROOM.hpp" or "ROOM/FILE.hpp" of a room'
    if target != room and target not in ROOMS[room]:
        return f"{room} must not include {target}"
    return None


def check_rooms(root):
    """Rooms and public headers: what they include."""
    files = [(path.parent.name, False, path) for path in root.glob("src/*/*.[hc]pp")]
    files += [(path.stem, True, path) for path in root.glob("include/quadloom/*.hpp")]
    for room, public, path in sorted(files):
        if room not in ROOMS:
            if not (public and room == "quadloom"):
                yield f"{path.relative_to(root)}: {room} is not a room"
            continue
        for number, line, quote, name in includes(path):
            if fault := fault_of(str(path.relative_to(root)), room, public, quote, name):
                yield f"{path.relative_to(root)}:{number}: {line.strip()}  <- {fault}"


def check_public_headers(root):
    """One public header to a room; quadloom.hpp includes those of the library."""
    rooms = {path.name for path in root.glob("src/*") if path.is_dir()}
    headers = {path.stem for path in root.glob("include/quadloom/*.hpp")} - {"quadloom"}
    for room in sorted(rooms - headers):
        yield f"src/{room}: has no public header include/quadloom/{room}.hpp"
    for room in sorted(headers - rooms):
        yield f"include/quadloom/{room}.hpp: is no room of src/"
    all_of_it = root / "include/quadloom/quadloom.hpp"
    named = {room_of_include(name) for _, _, _, name in includes(all_of_it)}
    for room in sorted((headers & set(LIBRARY)) - named):
        yield f"include/quadloom/quadloom.hpp: lacks quadloom/{room}.hpp"
    if "io" in named:
        yield "include/quadloom/quadloom.hpp: io is a library of its own"


def check_users(root):
    """The command line, the bindings and the examples are users: public headers alone."""
    for path in sorted(path for folder in ("apps", "bindings", "examples") for path in root.glob(f"{folder}/**/*.[hc]pp")):
        for number, line, quote, name in includes(path):
            room = name.split("/")[0] if quote == '"' else None
            if room in ROOMS and not (path.parent / name).exists():
                yield f"{path.relative_to(root)}:{number}: {line.strip()}  <- uses the public headers alone"


def check(root):
    return [*check_rooms(root), *check_public_headers(root), *check_users(root)]


def self_test():
    good = {
        "include/quadloom/core.hpp": "#include <vector>",
        "include/quadloom/kernel.hpp": '#include "quadloom/core.hpp"',
        "include/quadloom/certify.hpp": '#include "quadloom/core.hpp"',
        "include/quadloom/io.hpp": '#include "quadloom/core.hpp"',
        "include/quadloom/quadloom.hpp": "\n".join(
            f'#include "quadloom/{room}.hpp"' for room in ["core", "kernel", "certify"]),
        "src/core/mesh.cpp": '#include "quadloom/core.hpp"',
        "src/core/parallel.cpp": '#include "quadloom/core.hpp"\n#include <tbb/parallel_for.h>',
        "src/core/large_array.cpp": "#include <sys/mman.h>",
        "src/kernel/hull.cpp": '#include <boost/x.hpp>\n#include "core/random.hpp"\n#include "kernel/a.hpp"',
        "src/certify/certify.cpp": '#include "quadloom/kernel.hpp"',
        "src/io/obj.cpp": '#include <fmt/core.h>\n#include "quadloom/certify.hpp"',
        "apps/quadloom/main.cpp": '#include "verbs.hpp"\n#include "quadloom/io.hpp"',
    }
    bad = [  # file, text, words that the message must have
        ("src/core/mesh.cpp", '// first\n#include "kernel/a.hpp"', "src/core/mesh.cpp:2: "),
        ("src/kernel/hull.cpp", '#include "quadloom/certify.hpp"', "kernel must not include certify"),
        ("src/kernel/hull.cpp", '#include "quadloom/quadloom.hpp"', "not "),
        ("src/kernel/hull.cpp", '#include "a.hpp"', "not "),
        ("src/kernel/hull.cpp", "#include <fmt/core.h>", "Boost's headers alone"),
        ("src/kernel/hull.cpp", "#  include <gmpxx.h>", "Boost's headers alone"),
        ("src/kernel/hull.cpp", "#include <tbb/parallel_for.h>", "threads are src/core/parallel.cpp's"),
        ("src/kernel/hull.cpp", "#include <sys/mman.h>", "Boost's headers alone"),
        ("src/core/parallel.hpp", "#include <tbb/parallel_for.h>", "threads are src/core/parallel.cpp's"),
        ("src/io/obj.cpp", "#include <tbb/parallel_for.h>", "threads are src/core/parallel.cpp's"),
        ("src/kernel/hull.cpp", '#include "quadloom/io.hpp"', "kernel must not include io"),
        ("src/certify/certify.cpp", '#include "dual/graph.hpp"', "certify must not include dual"),
        ("src/attic/old.cpp", "", "attic is not a room"),
        ("src/dual/graph.cpp", "", "has no public header"),
        ("include/quadloom/attic.hpp", "", "attic is not a room"),
        ("include/quadloom/strips.hpp", "", "is no room of src/"),
        ("include/quadloom/kernel.hpp", "#include <boost/x.hpp>", "standard library alone"),
        ("include/quadloom/kernel.hpp", '#include "kernel/a.hpp"', "public headers alone"),
        ("include/quadloom/quadloom.hpp", '#include "quadloom/core.hpp"', "lacks quadloom/kernel.hpp"),
        ("include/quadloom/quadloom.hpp", good["include/quadloom/quadloom.hpp"] + '\n#include "quadloom/io.hpp"',
         "library of its own"),
        ("apps/quadloom/main.cpp", '#include "kernel/a.hpp"', "apps/quadloom/main.cpp:1: "),
        ("bindings/python/src/core.cpp", '#include "core/random.hpp"', "public headers alone"),
        ("examples/cpp/first.cpp", '#include "core/random.hpp"', "public headers alone"),
    ]

    def faults(tree):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in tree.items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text + "\n")
            return check(pathlib.Path(folder))

    assert faults(good) == [], faults(good)
    for name, text, words in bad:
        found = faults({**good, name: text})
        assert any(words in fault for fault in found), f"{name} with {text!r}: found only {found}"
    print(f"the good tree passes, each of {len(bad)} bad ones fails")


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    faults = check(pathlib.Path(sys.argv[1]))
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
