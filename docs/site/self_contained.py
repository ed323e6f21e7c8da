"""Nothing is fetched from elsewhere when a page of the built site is read: no script, style, font or picture."""
import html.parser
import pathlib
import re
import sys

FETCHED = {"script": "src", "img": "src", "iframe": "src", "source": "src", "link": "href", "object": "data"}


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.elsewhere = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        address = dict(attributes).get(FETCHED.get(tag, ""), "") or ""
        if re.match(r"(\w+:)?//", address):
            self.elsewhere.append(address)


def faults(site):
    for page in sorted(site.rglob("*.html")):
        yield from (f"{page}: fetches {address}" for address in Page(page.read_text()).elsewhere)
    for style in sorted(site.rglob("*.css")):
        yield from (f"{style}: fetches {address}"
                    for address in re.findall(r"url\([\"']?((?:\w+:)?//[^)\"']+)", style.read_text()))


if __name__ == "__main__":
    found = [*faults(pathlib.Path(sys.argv[1]))]
    if found:
        sys.exit("\n".join(found))
