"""The C++ reference: one page a public header, made from what Doxygen finds in it.

A page follows its header from top to bottom. What a declaration promises (its `///` comment) becomes text, the
declaration itself is shown as it stands, since its fields are explained beside them.
"""
import pathlib
import re
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree

DOXYGEN = """
INPUT            = {headers}
FILE_PATTERNS    = *.hpp
STRIP_FROM_PATH  = {headers}
OUTPUT_DIRECTORY = {output}
GENERATE_HTML    = NO
GENERATE_LATEX   = NO
GENERATE_XML     = YES
XML_PROGRAMLISTING = NO
EXTRACT_ALL      = YES
AUTOLINK_SUPPORT = NO
WARN_AS_ERROR    = FAIL_ON_WARNINGS
QUIET            = YES
"""
SECTION = re.compile(r"// ---- (.*?)\.? ----\n")


class Declaration:
    """A class, struct, enum, function or constant at namespace level."""

    def __init__(self, node, name, location):
        self.name = name
        self.header = pathlib.PurePath(location.get("file")).stem
        self.line = int(location.get("line"))
        self.last = max(self.line, int(location.get("bodyend", "-1")))
        self.text = "\n\n".join(filter(None, (paragraph(p) for d in ("briefdescription", "detaileddescription")
                                              for p in node.find(d))))

    def find_lines(self, lines):
        """Widens to whole lines of the header: from the type before the name to the semicolon or brace at the end."""
        while not starts_declaration(lines[self.line - 2]):
            self.line -= 1
        while not lines[self.last - 1].split("//")[0].rstrip().endswith((";", "}")):
            self.last += 1


def starts_declaration(line_before):
    line = line_before.split("//")[0].rstrip()
    return not line or line.endswith((";", "{", "}"))


def paragraph(node):
    """The Markdown of one element of a description."""
    text = [node.text or ""]
    for child in node:
        inner = paragraph(child)
        match child.tag:
            case "computeroutput":
                inner = f"`{inner}`"
            case "listitem":
                inner = f"\n- {inner.strip()}"
            case "itemizedlist":
                inner = f"\n{inner}\n\n"
            case "ndash":
                inner = "--"
            case "para" | "ref" | "ulink":
                pass
            case _:
                raise ValueError(f"no Markdown for <{child.tag}> in {inner!r}")
        text += [inner, child.tail or ""]
    return "".join(text).strip() if node.tag == "para" else "".join(text)


def declarations(xml):
    for path in sorted(xml.glob("*.xml")):
        for compound in ElementTree.parse(path).getroot().iter("compounddef"):
            name = compound.findtext("compoundname")
            if compound.get("kind") in ("class", "struct") and name.startswith("quadloom::"):
                yield Declaration(compound, name.rsplit("::", 1)[1], compound.find("location"))
            elif compound.get("kind") == "namespace" and name.startswith("quadloom"):
                for member in compound.iter("memberdef"):
                    yield Declaration(member, member.findtext("name"), member.find("location"))


def anchor(name):
    return name.lower()


def link_names(text, pages, here):
    """Names of other declarations, wherever they are in the text, become links."""
    def link(match):
        name = match.group(0).strip("`")
        page = pages.get(name)
        if page is None:
            return match.group(0)
        return f"[`{name}`]({'' if page == here else page + '.md'}#{anchor(name)})"

    return re.sub(r"`[^`]*`|\b(?:[a-z0-9]+_[a-z0-9_]+|[A-Z][a-z]+(?:[A-Z][a-z]+)+|k[A-Z]\w+)\b", link, text)


def blocks(found, lines):
    """Declarations without a line between them share a comment and a block."""
    block = []
    for one in sorted(found, key=lambda d: d.line):
        one.find_lines(lines)
        if block and one.line > block[-1].last + 1:
            yield block
            block = []
        block.append(one)
    if block:
        yield block


def intro(lines):
    """What a header says of itself in its first lines."""
    return " ".join(line.removeprefix("//").strip() for line in lines[:lines.index("#pragma once")])


def header_page(lines, name, found, where):
    parts = [f"# {name}.hpp", intro(lines), f"```cpp\n#include <quadloom/{name}.hpp>\n```"]
    place = 0
    for block in blocks(found, lines):
        parts += [f"## {title}" for title in SECTION.findall("\n".join(lines[place:block[0].line - 1]) + "\n")]
        names = [*dict.fromkeys(one.name for one in block)]
        parts += [f'<a id="{anchor(name)}"></a>' for name in names[1:]]
        parts.append(f"### {', '.join(names)} {{ #{anchor(names[0])} }}")
        parts += [link_names(one.text, where, name) for one in block if one.text]
        place = block[-1].last
        parts.append("```cpp\n" + "\n".join(lines[block[0].line - 1:place]) + "\n```")
    return "\n\n".join(parts) + "\n"


class Headers:
    """The public headers, in the order of the rooms in CMakeLists.txt, io at the end."""

    def __init__(self, root):
        folder = root / "include/quadloom"
        rooms = re.search(r"set\(rooms (.*)\)", (root / "CMakeLists.txt").read_text()).group(1).split()
        order = [name for name in [*rooms, "io"] if (folder / f"{name}.hpp").exists()]
        self.lines = {name: (folder / f"{name}.hpp").read_text().splitlines() for name in order}
        with tempfile.TemporaryDirectory() as scratch:
            settings = DOXYGEN.format(headers=folder, output=scratch)
            subprocess.run(["doxygen", "-"], input=settings, text=True, check=True)
            self.found = [d for d in declarations(pathlib.Path(scratch, "xml")) if d.header in self.lines]
        self.where = {d.name: d.header for d in self.found}

    def intros(self):
        return {name: intro(lines) for name, lines in self.lines.items()}

    def pages(self):
        return {name: header_page(lines, name, [d for d in self.found if d.header == name], self.where)
                for name, lines in self.lines.items()}
