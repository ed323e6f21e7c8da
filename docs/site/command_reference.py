"""The options of the command line, from what `quadloom --help` and `quadloom VERB --help` print: tables instead of the
columns of a terminal, all else as it is."""
import html
import re
import subprocess

ENTRY = re.compile(r"^  (?P<name>\S.*?)(?:  +(?P<text>\S.*))?$")
CONTINUED = re.compile(r"^ {20,}(?P<text>\S.*)$")

LISTS = ("Points:", "Polygons:")  # lists in the closing words of `generate`, no groups of options


def help_of(program, *words):
    return subprocess.run([program, *words, "--help"], check=True, capture_output=True, text=True).stdout.strip()


def entries(lines):
    """The (name, text) of a group of options; a long name has its text on the next line."""
    found = []
    for line in lines:
        if found and (more := CONTINUED.match(line)):
            found[-1][1] = f"{found[-1][1]} {more['text']}".strip()
        elif entry := ENTRY.match(line):
            found.append([entry["name"], entry["text"] or ""])
        else:
            raise ValueError(f"no entry of a help: {line!r}")
    return found


def cell(text):
    return html.escape(text, quote=False).replace("|", "&#124;")


def table(title, lines):
    rows = [f"| <code>{cell(name)}</code> | {cell(text)} |" for name, text in entries(lines)]
    return "\n".join([f"| {title} | |", "|---|---|", *rows])


def page_of(text):
    """The Markdown of a help: a description, `Usage:`, groups under a title with a colon, and closing words."""
    head, _, rest = text.partition("\nUsage: ")
    usage, _, rest = rest.partition("\n")
    yield f"```text\n{head}\n\nUsage: {usage}\n```"
    for part in re.split(r"\n{2,}", rest.strip("\n")):
        title, *lines = part.split("\n")
        if re.fullmatch(r"[A-Z][a-z ]+:", title) and title not in LISTS:
            yield table(title[:-1], lines)
        else:
            yield f"```text\n{part}\n```"


def help_of_all(program):
    overview = help_of(program)
    verbs = re.findall(r"^  (\w+) ", overview.split("Subcommands:\n")[1].split("\n\n")[0], re.MULTILINE)
    parts = [*page_of(overview)]
    for verb in verbs:
        parts += [f"## quadloom {verb} {{ #{verb} }}", *page_of(help_of(program, verb))]
    return "\n\n".join(parts) + "\n"
