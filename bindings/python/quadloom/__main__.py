"""The command line: ``python -m quadloom``, and ``quadloom`` where the package is installed."""
import os
import pathlib
import subprocess
import sys


def main():
    """Runs the program that came with the package, with this process's arguments, streams and exit code."""
    folder = pathlib.Path(__file__).parent / "bin"
    program = folder / ("quadloom.exe" if os.name == "nt" else "quadloom")
    command = [str(program), *sys.argv[1:]]
    if os.name == "nt":
        sys.exit(subprocess.run(command).returncode)
    os.execv(command[0], command)


if __name__ == "__main__":
    main()
