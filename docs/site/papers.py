"""The papers: docs/references.bib as a page, and the citations [@key] of the pages as links to it."""
import re

import pybtex.database
import pybtex.plugin

CITATION = re.compile(r"\[@([\w-]+)\]")


class Papers:
    def __init__(self, path):
        self.entries = pybtex.database.parse_file(path).entries

    def label(self, key):
        """Authors and year: Bose and Toussaint 1995."""
        entry = self.entries[key]
        names = [" ".join(map(str, person.rich_prelast_names + person.rich_last_names))
                 for person in entry.persons["author"]]
        authors = " and ".join(names) if len(names) <= 2 else f"{names[0]} and others"
        return f"{authors} {entry.fields['year']}"

    def cite(self, markdown, to_page):
        return CITATION.sub(lambda m: f"[{self.label(m.group(1))}]({to_page}#{m.group(1)})", markdown)

    def page(self):
        """All of them, in the order of the file: first the papers that Quadloom implements."""
        style = pybtex.plugin.find_plugin("pybtex.style.formatting", "plain")()
        html = pybtex.plugin.find_plugin("pybtex.backends", "html")()
        parts = ["# Papers", "The papers that Quadloom implements, then those that its parts rest on."]
        for key, entry in self.entries.items():
            text = style.format_entry(label=key, entry=entry).text.render(html)
            parts.append(f'<p id="{key}">{text}</p>')
        return "\n\n".join(parts) + "\n"
