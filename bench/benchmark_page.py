"""The tables of docs/benchmarks.md from the figures of bench/compare, and the page from bench/benchmarks.md.in, in which
{{TABLE KIND}} stands for the table of that kind (a function of KINDS)."""
import json
import pathlib
import re
import statistics

from catalogue import TABLES

TEMPLATE = pathlib.Path(__file__).with_name("benchmarks.md.in")
NAMES = {"uniform": "uniform", "clusters": "clusters", "grid": "grid", "circle": "circle", "lines": "five lines",
         "towns": "towns of Germany", "cities": "cities of the world"}

BEST = {"greedy": "quadloom weight", "weight": "quadloom weight",  # what a matching is compared with
        "near": "quadloom perfect", "cardinality": "quadloom perfect", "perfect": "quadloom perfect"}


# ---- The figures: docs/benchmarks/TABLE.json, a list of groups, one an input. ----

def path_of(folder, table):
    return folder / "benchmarks" / f"{table.name}.json"


def read(folder, table):
    path = path_of(folder, table)
    return json.loads(path.read_text()) if path.exists() else {"missing": {}, "groups": []}


def read_groups(folder, table):
    """In the order of the catalogue."""
    order = [f"{kind} {count}" for kind, count, *_ in table.inputs]
    groups = [group for group in read(folder, table)["groups"] if group["input"] in order]
    return sorted(groups, key=lambda group: order.index(group["input"]))


def write_group(folder, table, group, missing):
    """Puts it in the place of the one of the same input; a line a row, seconds to four digits."""
    for figure in group["figures"].values():
        if "seconds" in figure:
            figure["seconds"] = [float(f"{seconds:.4g}") for seconds in figure["seconds"]]
    kept = [other for other in read_groups(folder, table) if other["input"] != group["input"]]
    relevant = {name: why for name, why in missing.items() if any(name == row.program for row in table.rows) or
                any(name == kind for kind, *_ in table.inputs)}
    text = ",\n".join(group_text(each) for each in [*kept, group])
    path_of(folder, table).write_text(f'{{"missing": {json.dumps(relevant)}, "groups": [\n{text}\n]}}\n')


def group_text(group):
    head = json.dumps({key: value for key, value in group.items() if key != "figures"})[:-1]
    rows = ",\n".join(f"    {json.dumps(key)}: {json.dumps(figure)}" for key, figure in group["figures"].items())
    return f'  {head}, "figures": {{\n{rows}}}}}'


# ---- What they say. ----

def seconds(figure):
    return statistics.median(figure["seconds"]) if figure and "seconds" in figure else None


def ratio(table, row, group):
    """Of a row's seconds to its unit's, the median of the rounds; None if there is none."""
    ours, unit = (group["figures"].get(key, {}).get("seconds", []) for key in (row.key, table.unit_of(row)))
    return statistics.median(a / b for a, b in zip(ours, unit)) if ours and unit else None


def ratio_of_bytes(table, row, group):
    ours, unit = (group["figures"].get(key, {}).get("bytes", 0) for key in (row.key, table.unit_of(row)))
    return ours / unit if ours and unit else None


def name_of(group):
    return f"{NAMES[group['kind']]} {group['points']:,}"


# ---- Cells. ----

def digits(x, count=3):
    """So many digits that count: 0.0153, 1.53, 1,530."""
    places = count - 1 - int(f"{x:.{count - 1}e}".partition("e")[2])
    return f"{round(x, places):,.{max(0, places)}f}"


def degrees(angle):
    """Strictly convex quads are under 180 degrees, even if they round to it."""
    text = f"{angle:.1f}"
    return f"under {text}°" if angle < float(text) in (180, 360) else f"{text}°"


def cell_of_seconds(table, row, group):
    figure = group["figures"].get(row.key)
    if figure is None:
        return ""
    if "seconds" not in figure:
        return figure["stopped"]
    found = ratio(table, row, group)
    text = digits(seconds(figure)) + (f" ({digits(found, 2)})" if found and row.key != table.unit_of(row) else "")
    return f"{text}, **wrong**" if is_wrong(row, figure) else text


def cell_of_bytes(row, group):
    figure = group["figures"].get(row.key, {})
    return f"{figure['bytes'] / group['points']:,.0f}" if "bytes" in figure else ""


def is_wrong(row, figure):
    """Gmsh does not promise what judge asks of quads; what it does is in the tables of meshes."""
    return "wrong" in figure and not (row.judge == "quads" and row.program != "quadloom")


def rows_shown(table, groups):
    return [row for row in table.rows if any(row.key in group["figures"] for group in groups)]


def markdown(head, rows):
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in
                     [head, ["---", *["--:"] * (len(head) - 1)], *rows])


# ---- The kinds of tables. ----

def by_input(table, groups):
    """An input a line: seconds, and the ratio to the unit, of each row; then bytes a point."""
    rows = rows_shown(table, groups)
    head = ["points", *(f"{row.label}, s" for row in rows), *(f"{row.label}, bytes a point" for row in rows)]
    return markdown(head, [[name_of(group), *(cell_of_seconds(table, row, group) for row in rows),
                            *(cell_of_bytes(row, group) for row in rows)] for group in groups])


def times(table, groups):
    """A row a line: seconds, and the ratio to the unit, for each input."""
    return markdown(["seconds", *map(name_of, groups)],
                    [[row.label, *(cell_of_seconds(table, row, group) for group in groups)] for row in rows_shown(table, groups)])


def memory(table, groups):
    return markdown(["bytes a point", *map(name_of, groups)],
                    [[row.label, *(cell_of_bytes(row, group) for group in groups)] for row in rows_shown(table, groups)])


def meshes(table, groups):
    """What the faces are, an input after the other."""
    head = ["", "quads", "triangles", "not convex", "turned over", "points added", "points lost", "greatest angle", "mean shape"]
    keys = ["quads", "triangles", "non_convex", "turned_over", "added", "lost"]
    parts = []
    for group in groups:
        lines = []
        for row in rows_shown(table, [group]):
            figure = group["figures"][row.key]
            if row.judge != "quads":
                continue
            if "max_angle" not in figure:
                lines.append([row.label, figure.get("stopped", figure.get("wrong")), *[""] * 7])
                continue
            lines.append([row.label, *(f"{figure[key]:,}" for key in keys), degrees(figure["max_angle"]),
                          f"{figure['mean_shape']:.3f}"])
        parts.append(markdown([name_of(group), *head[1:]], lines))
    return "\n\n".join(parts)


def weights(table, groups):
    """Of our matchings: pairs, and the weight in per cent of the best matching with the same goal."""
    parts = []
    for group in groups:
        lines = []
        for row in rows_shown(table, [group]):
            figure = group["figures"][row.key]
            if row.program == "quadloom" and "weight" in figure:
                best = group["figures"][BEST[row.task]]["weight"]
                lines.append([row.label, f"{figure['pairs']:,}", f"{100 * figure['weight'] / best:.2f}%"])
        parts.append(markdown([name_of(group), "pairs", "weight of the best"], lines))
    return "\n\n".join(parts)


def indices(table, groups):
    return markdown(["indices a triangle", *map(name_of, groups)],
                    [[row.label, *(digits(group["figures"][row.key]["indices"], 4) if
                                   "indices" in group["figures"].get(row.key, {}) else "" for group in groups)]
                     for row in rows_shown(table, groups)])


def megabytes(table, groups):
    """Of files, and how fast they are read or written."""
    lines = []
    for row in rows_shown(table, groups):
        found = [group["figures"].get(row.key, {}) for group in groups]
        if any("file" in figure for figure in found):
            lines.append([row.label, *(f"{figure['file'] / 1e6:.1f} ({figure['file'] / 1e6 / seconds(figure):,.0f})"
                                       for figure in found)])
    return markdown(["megabytes (a second)", *map(name_of, groups)], lines)


def faults(table, groups):
    """A sentence for each wrong result."""
    lines = [f"- {row.label}, {name_of(group)}: {group['figures'][row.key]['wrong']}" for group in groups
             for row in rows_shown(table, [group]) if is_wrong(row, group["figures"][row.key])]
    return "\n".join(["Wrong:\n", *lines]) if lines else "No result was wrong."


KINDS = {"by input": by_input, "times": times, "memory": memory, "meshes": meshes, "weights": weights, "indices": indices,
         "megabytes": megabytes, "faults": faults}


# ---- What is about all tables. ----

def spread(ratios):
    """'0.31 to 0.52'."""
    low, high = digits(min(ratios), 2), digits(max(ratios), 2)
    return low if low == high else f"{low} to {high}"


def summary(folder):
    """Our rows that have a peer as their unit."""
    lines = []
    for table in TABLES:
        groups = read_groups(folder, table)
        for row in rows_shown(table, groups):
            unit = table.row(table.unit_of(row))
            measured = [group for group in groups if ratio(table, row, group)]
            if row.program != "quadloom" or unit.program == "quadloom" or not measured:
                continue
            times_of = [ratio(table, row, group) for group in measured]
            bytes_of = [found for group in measured if (found := ratio_of_bytes(table, row, group))]
            slower = sum(found > 1 for found in times_of)
            what = re.sub("^Quadloom,? ?", "", row.label)
            lines.append([f"{table.title}: {what}" if what else table.title, unit.label.removesuffix(": the unit"),
                          spread(times_of), f"{slower} of {len(times_of)}", spread(bytes_of) if bytes_of else ""])
    return markdown(["", "peer", "time, the peer's = 1", "slower", "memory, the peer's = 1"], lines)


def all_groups(folder):
    return [(table, group) for table in TABLES for group in read_groups(folder, table)]


def machines(folder):
    texts = {(f"{m['processor']}, {m['cores']} cores, {m['gibibytes']} GiB, {m['compiler']}", m["date"]): None
             for _, group in all_groups(folder) for m in [group["machine"]]}
    return "; ".join(f"{what} ({date})" for what, date in texts)


def versions(folder):
    found = {row.program: figure["version"] for table, group in all_groups(folder) for row in table.rows
             if row.program != "quadloom" and "version" in (figure := group["figures"].get(row.key, {}))}
    return ", ".join(f"{program} {version.replace('_', '.')}" for program, version in found.items())


def missing(folder):
    found = {name: why for table in TABLES for name, why in read(folder, table)["missing"].items()}
    return "".join(f" Left out: {NAMES.get(name, name)}, which {why}." for name, why in found.items())


WHOLE = {"summary": summary, "machines": machines, "versions": versions, "missing": missing}


# ---- The page. ----

def make(folder):
    """The text of FOLDER/benchmarks.md."""
    tables = {table.name: table for table in TABLES}

    def fill(match):
        name, _, rest = match[1].partition(" ")
        if name in WHOLE:
            return WHOLE[name](folder)
        kind, _, only = rest.partition(": ")  # inputs by a pattern
        groups = [group for group in read_groups(folder, tables[name]) if re.search(only, group["input"])]
        return KINDS[kind](tables[name], groups) if groups else "Not measured."
    return re.sub(r"\{\{(.+?)\}\}", fill, TEMPLATE.read_text())
