"""The Python reference: a page a family of functions, as the C++ headers part them. The text is that of the docstrings, which
mkdocstrings reads from the installed package."""
import ast
import importlib.util
import pathlib


def folder():
    package = importlib.util.find_spec("quadloom")
    if package is None:
        raise SystemExit("the package quadloom is not installed where the site is built: see scripts/site")
    return pathlib.Path(package.submodule_search_locations[0])


def public_names(folder):
    """What the stub of the compiled part defines, in its order, and what the package imports from its other modules."""
    stub = ast.parse((folder / "_core.pyi").read_text()).body
    found = [node.name for node in stub if isinstance(node, ast.ClassDef | ast.FunctionDef)]
    for node in ast.parse((folder / "__init__.py").read_text()).body:
        if isinstance(node, ast.ImportFrom):
            found += [alias.asname or alias.name for alias in node.names]
    return [name for name in dict.fromkeys(found) if name.isidentifier() and not name.startswith("_")]


def pages(header_of, intros):
    """{family: its page}. What C++ does not have, or not in a header, is in core."""
    families = {header: [] for header in intros}
    for name in public_names(folder()):
        families[header_of.get(name, "core")].append(name)
    return {family: f"# {family}\n\n{intros[family]}\n\n" + "\n\n".join(f"::: quadloom.{name}" for name in names)
            for family, names in families.items() if names}
