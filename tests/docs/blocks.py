"""The code blocks of the documentation, as every reader and test of them sees them.

A block is fenced and has a language. What happens to it:

    sh              a script of which every line has to succeed
    console         commands after `$ ` and what they print, where `...` stands for anything; one that fails is
                    followed by `$ echo $?`
    cpp             a program, or lines that compile after tests/docs/prelude.hpp; runs
    python          runs, after the blocks before it on the page
    text json cmake data, output or a drawing: shown

A block with `title="NAME"` is written to that file for the blocks after it. A comment `<!-- not run: REASON -->` on the
line before a block says that it is not run, and why. Files of examples/ are in the folder in which blocks run.
"""
import dataclasses
import pathlib
import re
import shutil

RUN = ("sh", "console", "cpp", "python")
SHOWN = ("text", "json", "cmake")

FENCE = re.compile(r"^(?P<indent> *)```(?P<info>.*)\n(?P<text>(?:.*\n)*?)(?P=indent)```$", re.MULTILINE)
TITLE = re.compile(r'title="([^"]+)"')
NOT_RUN = re.compile(r"<!-- not run: (.+) -->\n\s*\Z")


@dataclasses.dataclass
class Block:
    page: pathlib.Path
    line: int
    language: str
    text: str
    title: str | None
    not_run: str | None  # the reason

    def __str__(self):
        return f"{self.page}:{self.line}"


def pages(root):
    found = [root / "README.md", *root.glob("docs/**/*.md"), *root.glob("examples/**/*.md")]
    return [page.relative_to(root) for page in sorted(found)]


def blocks_of(text, page):
    for match in FENCE.finditer(text):
        before = text[:match.start()]
        info = match["info"].split()
        reason = NOT_RUN.search(before)
        title = TITLE.search(match["info"])
        indent = len(match["indent"])
        yield Block(page, before.count("\n") + 2, info[0] if info else "",
                    "".join(line[indent:] if line.strip() else line for line in match["text"].splitlines(True)),
                    title and title.group(1), reason and reason.group(1))


def all_blocks(root):
    for page in pages(root):
        yield from blocks_of((root / page).read_text(), page)


def faults(text, page):
    """What would slip through: blocks without a language that is known, and code that is merely indented."""
    for block in blocks_of(text, page):
        if block.language not in RUN + SHOWN:
            yield f"{block}: a block of language '{block.language}', not one of {', '.join(RUN + SHOWN)}"
    outside = FENCE.sub(lambda m: "x\n" * m.group(0).count("\n") + "x", text)
    previous, before = "", ""
    for number, line in enumerate(outside.splitlines(), 1):
        if line.startswith("    ") and not previous and not re.match(r"\s*([-*] |\d+\. |=== )| {4}", before):
            yield f"{page}:{number}: indented code; fence it and give it a language"
        if line.strip():
            before = line
        previous = line.strip()


def copy_examples(root, folder):
    """A copy of examples/, and its files of data once more beside it, as the pages name them."""
    for path in sorted(root.glob("examples/*/*")):
        if path.suffix in (".csv", ".14", ".geojson", ".stl"):
            shutil.copy(path, folder)
    shutil.copytree(root / "examples", folder / "examples")
