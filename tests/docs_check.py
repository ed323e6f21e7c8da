#!/usr/bin/env python3
"""Checks the documentation against the tree. Prints what does not agree.

    docs_check.py ROOT         README's C++ block is examples/cpp/first_mesh.cpp, links lead somewhere,
                               references named in docs/ are in references.bib, every code block says what it is,
                               a page an algorithm has a picture, guarantee, use, example and references
    docs_check.py --self-test  shows on made-up trees that each check can fail
"""
import pathlib
import re
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent / "docs"))
import blocks  # noqa: E402

LINK = re.compile(r"\]\(([^)\s]+)\)")
CPP_BLOCK = re.compile(r"^```cpp\n(.*?)^```", re.MULTILINE | re.DOTALL)
REFERENCE = re.compile(r"\[@([\w-]+)\]")


def check_snippet(root):
    blocks = CPP_BLOCK.findall((root / "README.md").read_text())
    if (root / "examples/cpp/first_mesh.cpp").read_text() not in blocks:
        yield "README.md: no C++ block is examples/cpp/first_mesh.cpp verbatim"


def check_links(root, page):
    for target in LINK.findall(page.read_text()):
        file = target.split("#")[0]
        if "://" not in target and file and not (page.parent / file).exists():
            yield f"{page.relative_to(root)}: {target} is not there"


def check_references(root, page):
    known = set(re.findall(r"^@\w+\{([\w-]+),", (root / "docs/references.bib").read_text(), re.MULTILINE))
    for name in REFERENCE.findall(page.read_text()):
        if name not in known:
            yield f"{page.relative_to(root)}: [@{name}] is not in docs/references.bib"


PARTS_OF_A_PAGE = {  # of docs/algorithms, but for the index and the comparison
    "a picture": r"^!\[.+\]\(\.\./images/",
    "when to use it": r"^\*\*Use (it|them)\*\*",
    "an example": r"^```(sh|console|cpp|python)$",
    "its guarantee": r"^\*\*(Guarantee|What is proved)\b",
    "references": r"^\*\*References\.\*\*",
}


def check_algorithm(root, page):
    if page.parent != root / "docs/algorithms" or page.stem in ("index", "comparison"):
        return
    for part, pattern in PARTS_OF_A_PAGE.items():
        if not re.search(pattern, page.read_text(), re.MULTILINE):
            yield f"{page.relative_to(root)}: lacks {part}"


def check(root):
    faults = [*check_snippet(root)]
    for page in sorted([*root.glob("*.md"), *root.glob("docs/**/*.md"), *root.glob("examples/**/*.md")]):
        faults += [*check_links(root, page), *check_references(root, page)]
        faults += [*check_algorithm(root, page), *blocks.faults(page.read_text(), page.relative_to(root))]
    return faults


ALGORITHM = """![one](../images/one.svg)

**Guarantee.** One.

**Use it** rarely.

```sh
true
```

**References.** [@somebody-1999]
"""


def self_test():
    good = {
        "README.md": "```cpp\nint main() {}\n```\nSee [docs](docs/page.md#part), [site](https://example.org).\n",
        "examples/cpp/first_mesh.cpp": "int main() {}\n",
        "docs/page.md": "[back](../README.md), [@somebody-1999]\n",
        "docs/references.bib": "@article{somebody-1999,\n}\n",
        "docs/images/one.svg": "<svg/>\n",
        "docs/algorithms/one.md": ALGORITHM,
    }
    bad = [
        ("examples/cpp/first_mesh.cpp", "int main() { return 1; }\n", "verbatim"),
        ("docs/page.md", "[gone](gone.md)\n", "gone.md is not there"),
        ("docs/page.md", "![picture](images/gone.svg)\n", "gone.svg is not there"),
        ("docs/page.md", "[@nobody-2000]\n", "nobody-2000"),
        ("docs/page.md", "```\nwhat is it?\n```\n", "language ''"),
        ("docs/algorithms/one.md", ALGORITHM.replace("![", "["), "lacks a picture"),
        ("docs/algorithms/one.md", ALGORITHM.replace("Use", "Take"), "lacks when to use it"),
        ("docs/algorithms/one.md", ALGORITHM.replace("sh", "text"), "lacks an example"),
        ("docs/algorithms/one.md", ALGORITHM.replace("Guarantee", "Hope"), "lacks its guarantee"),
        ("docs/algorithms/one.md", ALGORITHM.replace("References", "See"), "lacks references"),
    ]

    def faults(tree):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in tree.items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
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
