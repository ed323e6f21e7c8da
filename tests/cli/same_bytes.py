#!/usr/bin/env python3
"""Two builds of the command line, of different compilers, say, write the same bytes. Says what differs or fails.

    same_bytes.py QUADLOOM OTHER_QUADLOOM
"""
import pathlib
import subprocess
import sys
import tempfile

from harness import CHAIN

KINDS = ["uniform", "grid", "circle", "lines", "decades"]
SIZE = "1500"
LARGE = "70000"  # of points, for Delaunay triangles in ranges


def generate(kind, size):
    return ["generate", kind, "-n", size, "-o", "points.xyz"]


def outputs(program, folder):
    """{command: what it said and wrote}"""
    found = {}
    for commands in [*([generate(kind, SIZE), *CHAIN] for kind in KINDS),
                     [generate("uniform", LARGE), ["triangulate", "points.xyz", "-o", "large.off"]]]:
        for command in commands:
            done = subprocess.run([program, *command], cwd=folder, capture_output=True, text=True)
            if done.returncode != 0:
                sys.exit(f"{program} {' '.join(command)}: {done.stderr}")
            name = f"{' '.join(command)}, of {commands[0][1]} {commands[0][3]}"
            found[name] = done.stderr, (folder / command[-1]).read_bytes()
    return found


def main():
    both = []
    for program in map(pathlib.Path, sys.argv[1:3]):
        with tempfile.TemporaryDirectory() as folder:
            both.append(outputs(program.resolve(), pathlib.Path(folder)))
    differing = [run for run in both[0] if both[0][run] != both[1][run]]
    if differing:
        sys.exit("not the same:\n" + "\n".join(differing))
    print(f"{len(both[0])} runs, the same bytes")


if __name__ == "__main__":
    main()
