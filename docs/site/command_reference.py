"""The reference of the command line: what `quadloom --help` and `quadloom VERB --help` print."""
import re
import subprocess


def help_of(program, *words):
    return subprocess.run([program, *words, "--help"], check=True, capture_output=True, text=True).stdout.strip()


def verbs(overview):
    """The verbs and what each does, in the order of the help."""
    table = overview.split("Subcommands:\n")[1].split("\n\n")[0]
    return re.findall(r"^  (\w+) +(.*)$", table, re.MULTILINE)


def help_of_all(program):
    overview = help_of(program)
    parts = [f"```text\n{overview}\n```"]
    for verb, purpose in verbs(overview):
        parts += [f"## quadloom {verb} {{ #{verb} }}", f"```text\n{help_of(program, verb)}\n```"]
    return "\n\n".join(parts) + "\n"
