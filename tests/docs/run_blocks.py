#!/usr/bin/env python3
"""Runs the code blocks of README.md, docs/ and examples/ (tests/docs/blocks.py says how they are marked).

    run_blocks.py shell ROOT PREFIX     sh and console blocks, with the programs and packages installed in PREFIX
    run_blocks.py python ROOT           python blocks, with this interpreter
    run_blocks.py cpp ROOT FILE         writes one C++ program that runs all cpp blocks
    run_blocks.py self-test             shows that a wrong block fails
"""
import doctest
import itertools
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import blocks
from blocks import Block


def runs(block, *languages):
    return block.language in languages and not block.not_run and not block.title


def by_page(root, *languages):
    """The pages that have blocks to run in these languages, each with all its blocks."""
    for page, found in itertools.groupby(blocks.all_blocks(root), lambda block: block.page):
        found = [*found]
        if any(runs(block, *languages) for block in found):
            yield page, found


def count(root, *languages):
    """What is run, and what is not and why: printed, so that nothing slips."""
    found = [block for block in blocks.all_blocks(root) if block.language in languages]
    left = [block for block in found if block.not_run]
    files = [block for block in found if block.title]
    print(f"{len(found)} blocks of {', '.join(languages)}: {len(found) - len(left) - len(files)} run, "
          f"{len(files)} are files of others, {len(left)} not run")
    for block in left:
        print(f"  {block}: {block.not_run}")


# ---- Shell. ----

def shell(script, folder, environment):
    return subprocess.run(["bash", "-c", script], cwd=folder, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def run_script(block, folder, environment):
    run = shell("set -euo pipefail\n" + block.text, folder, environment)
    if run.returncode:
        yield f"{block}: exit code {run.returncode}\n{run.stdout}"


def run_console(block, folder, environment):
    sessions = re.split(r"^\$ ", block.text, flags=re.MULTILINE)
    if sessions.pop(0):
        yield f"{block}: a console block begins with '$ '"
    status = 0
    for number, session in enumerate(sessions):
        command, _, expected = session.partition("\n")
        run = shell(f"(exit {status})\n{command}", folder, environment)
        status = run.returncode
        if not doctest.OutputChecker().check_output(expected, run.stdout, doctest.ELLIPSIS):
            yield f"{block}: $ {command}\nprints\n{run.stdout}instead of\n{expected}"
        asked = number + 1 < len(sessions) and sessions[number + 1].startswith("echo $?")
        if status and not asked:
            yield f"{block}: $ {command}\nexit code {status}\n{run.stdout}"


def run_shell_page(found, folder, environment):
    for block in found:
        if block.title:
            (folder / block.title).write_text(block.text)
        elif runs(block, "sh"):
            yield from run_script(block, folder, environment)
        elif runs(block, "console"):
            yield from run_console(block, folder, environment)


def run_shell(root, prefix):
    environment = dict(os.environ, PATH=f"{prefix / 'bin'}:{os.environ['PATH']}", CMAKE_PREFIX_PATH=str(prefix))
    for _, found in by_page(root, "sh", "console"):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            blocks.copy_examples(root, folder)
            yield from run_shell_page(found, folder, environment)


# ---- Python: all blocks of a page are one program, in a process of its own. ----

def python_program(found):
    """Each block compiled under its own place in the page, so that a traceback names it."""
    lines = ["scope = {'__name__': '__main__'}"]
    for block in found:
        if runs(block, "python"):
            padded = "\n" * (block.line - 1) + block.text
            lines.append(f"exec(compile({padded!r}, {str(block.page)!r}, 'exec'), scope)")
    return "\n".join(lines)


def run_python(root):
    environment = dict(os.environ, MPLBACKEND="Agg")
    for page, found in by_page(root, "python"):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            blocks.copy_examples(root, folder)
            run = subprocess.run([sys.executable, "-c", python_program(found)], cwd=folder, env=environment, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            if run.returncode:
                yield f"{page}:\n{run.stdout}"


# ---- C++: one program, in which each block has a namespace or a function of its own. ----

def cpp_program(root):
    includes, bodies, names = ['#include "prelude.hpp"'], [], []
    for block in blocks.all_blocks(root):
        if not runs(block, "cpp"):
            continue
        lines = block.text.splitlines()
        includes += [line for line in lines if line.startswith("#include")]
        code = "\n".join("" if line.startswith("#include") else line for line in lines)
        if not re.search(r"^int main\(", code, re.MULTILINE):
            code = f"int main() {{\n#line {block.line}\n{code}\nreturn 0; }}"
        name = f"block_{len(names)}"
        bodies.append(f'namespace {name} {{\n#line {block.line} "{root / block.page}"\n{code}\n}}')
        names.append((name, str(block)))
    calls = "\n".join(f'  run("{place}", {name}::main);' for name, place in names)
    return "\n".join([*dict.fromkeys(includes), *bodies, '#line 1 "main"', f"int main() {{\n{calls}\n}}"]) + "\n"


# ---- That it can fail. ----

def self_test():
    def block(language, text):
        return Block(pathlib.Path("page.md"), 1, language, text, None, None)

    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        good = [block("sh", "true\n"), block("console", "$ echo one two\none ...\n$ false\n$ echo $?\n1\n")]
        assert not [*run_shell_page(good, folder, os.environ)]
        for bad in (block("sh", "false\ntrue\n"), block("console", "$ echo one\ntwo\n"), block("console", "$ false\n"),
                    block("console", "echo one\none\n")):
            assert [*run_shell_page([bad], folder, os.environ)], bad
    with tempfile.TemporaryDirectory() as scratch:
        root = pathlib.Path(scratch)
        (root / "examples").mkdir()
        for code, good in (("import math\n", True), ("assert False\n", False), ("x = (\n", False)):
            (root / "README.md").write_text(f"```python\n{code}```\n")
            assert good == (not [*run_python(root)]), code
        (root / "README.md").write_text("```cpp\nint x = 1;\n```\n")
        assert "int x = 1;" in cpp_program(root)
    for text, words in (("```\nx\n```\n", "language ''"), ("```py\nx\n```\n", "language 'py'"),
                        ("a\n\n    x = 1\n", "indented code")):
        assert any(words in fault for fault in blocks.faults(text, "page.md")), text
    assert not [*blocks.faults("- a\n\n    of a\n\n=== \"C++\"\n\n    ```cpp\n    x\n    ```\n", "page.md")]
    print("good blocks pass, bad ones fail")


def main():
    task, *rest = sys.argv[1:]
    if task == "self-test":
        return self_test()
    root, *rest = [pathlib.Path(arg).resolve() for arg in rest]
    if task == "cpp":
        return rest[0].write_text(cpp_program(root))
    if task == "shell":
        count(root, "sh", "console", "cpp")
        faults = [*run_shell(root, rest[0])]
    else:
        count(root, "python")
        faults = [*run_python(root)]
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
