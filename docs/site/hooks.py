"""What MkDocs does not do by itself: pages made from the program, the headers and the bibliography; citations; links to
headers, which lead to their pages in the reference."""
import os
import pathlib
import posixpath
import re
import sys

from mkdocs.structure.files import File

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import command_reference  # noqa: E402
import cpp_reference  # noqa: E402
import python_reference  # noqa: E402
from papers import Papers  # noqa: E402

ROOT = pathlib.Path(__file__).parents[2]
PAPERS = Papers(ROOT / "docs/references.bib")
HELP = "<!-- the help of all verbs: the site puts it here -->"
HEADER_LINK = re.compile(r"\]\((?:\.\./)+include/quadloom/(\w+)\.hpp\)")


def made_pages():
    yield "papers.md", PAPERS.page()
    yield "changelog.md", (ROOT / "CHANGELOG.md").read_text()
    headers = cpp_reference.Headers(ROOT)
    for name, page in python_reference.pages(headers.where, headers.intros()).items():
        yield f"reference/python/{name}.md", page
    for name, page in headers.pages().items():
        yield f"reference/cpp/{name}.md", page


MADE = dict(made_pages())


def with_folders(nav):
    """The navigation, where a folder of made pages stands for the pages in it."""
    if isinstance(nav, list):
        return [with_folders(item) for item in nav]
    if isinstance(nav, dict):
        return {title: with_folders(target) for title, target in nav.items()}
    return [uri for uri in MADE if uri.startswith(f"{nav}/")] or nav


def on_config(config):
    config.nav = with_folders(config.nav)
    return config


def on_files(files, config):
    for uri, text in MADE.items():
        files.append(File.generated(config, uri, content=text))
    return files


def on_page_markdown(markdown, page, config, files):
    def path_to(target):
        return posixpath.relpath(target, posixpath.dirname(page.file.src_uri) or ".")

    if HELP in markdown:
        markdown = markdown.replace(HELP, command_reference.help_of_all(os.environ["QUADLOOM_APP"]))
    markdown = HEADER_LINK.sub(lambda match: f"]({path_to(f'reference/cpp/{match.group(1)}.md')})", markdown)
    return PAPERS.cite(markdown, path_to("papers.md"))
