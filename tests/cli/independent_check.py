"""An exact check of an OBJ mesh against its input points, in rational arithmetic.

Shares nothing with the program that it judges. check() returns the number of added points or raises
Wrong. What it establishes: every input point is a vertex; faces are simple, counter-clockwise and
of positive area; no directed edge occurs twice; the edges without a twin are the edges of the convex
hull, every vertex on the hull included. So the faces cover the hull exactly once.
"""

from fractions import Fraction


class Wrong(Exception):
    pass


def require(condition, sentence):
    if not condition:
        raise Wrong(sentence)


def read_obj(path):
    vertices, faces = [], []
    with open(path) as f:
        for line in f:
            words = line.split()
            if words[:1] == ["v"]:
                vertices.append((float(words[1]) + 0.0, float(words[2]) + 0.0))
            elif words[:1] == ["f"]:
                faces.append([int(w.split("/")[0]) - 1 for w in words[1:]])
    return vertices, faces


def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def between(a, b, p):
    """p, known to be on the line a-b, lies on the closed segment."""
    return min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])


def segments_meet(a, b, c, d):
    t = [turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)]
    if ((t[0] > 0) != (t[1] > 0)) and ((t[2] > 0) != (t[3] > 0)) and 0 not in t:
        return True
    return any(v == 0 and between(*s) for v, s in zip(t, [(a, b, c), (a, b, d), (c, d, a), (c, d, b)]))


def simple_and_positive(corners):
    n = len(corners)
    for i in range(n):
        for j in range(i + 2, n):
            if (i, j) == (0, n - 1):
                continue
            if segments_meet(corners[i], corners[i + 1], corners[j], corners[(j + 1) % n]):
                return False
        a, b, c = corners[i], corners[(i + 1) % n], corners[(i + 2) % n]
        if turn(a, b, c) == 0 and (between(a, b, c) or between(b, c, a)):
            return False  # folds back
    area = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(corners, corners[1:] + corners[:1]))
    return area > 0


def hull_edges(indices, at):
    """Directed edges of the convex hull, counter-clockwise, every vertex on it included."""
    order = sorted(indices, key=lambda v: at[v])

    def half(vertices):
        chain = []
        for v in vertices:
            while len(chain) > 1 and turn(at[chain[-2]], at[chain[-1]], at[v]) < 0:
                chain.pop()
            chain.append(v)
        return list(zip(chain, chain[1:]))

    return set(half(order)) | set(half(order[::-1]))


def check(path, points, corners=4, triangles=0):
    vertices, faces = read_obj(path)
    at = [(Fraction(x), Fraction(y)) for x, y in vertices]
    used = sorted({v for face in faces for v in face})
    require(faces, "no faces")
    require(used[0] >= 0 and used[-1] < len(vertices), "an index out of range")
    require(len({vertices[v] for v in used}) == len(used), "two vertices at one place")

    given = {(x + 0.0, y + 0.0) for x, y in points}
    missing = given - {vertices[v] for v in used}
    require(not missing, f"missing points: {sorted(missing)[:3]}")

    found = sum(len(face) == 3 for face in faces) if corners != 3 else 0
    require(found <= triangles, f"{found} triangles")
    directed = set()
    for face in faces:
        require(len(face) == corners or len(face) == 3, f"a face with {len(face)} corners")
        require(simple_and_positive([at[v] for v in face]), f"not simple and positive: {face}")
        for edge in zip(face, face[1:] + face[:1]):
            require(edge not in directed, f"edge twice: {edge}")
            directed.add(edge)
    boundary = {(a, b) for a, b in directed if (b, a) not in directed}
    require(boundary == hull_edges(used, at), "the boundary is not the hull")
    return len(used) - len(given)


def boundary_of(faces):
    directed = {edge for face in faces for edge in zip(face, face[1:] + face[:1])}
    return {(a, b) for a, b in directed if (b, a) not in directed}


def check_mesh(path, source, triangles=0, split=0, outside=0):
    """The same for a planar mesh (.obj) made from another. Vertices of the source keep their numbers and
    places; the boundary is the source's, but `split` edges may have a vertex in their middle and
    `outside` edges may be two that meet at an added vertex. Returns the number of added points."""
    vertices, faces = read_obj(path)
    given, given_faces = read_obj(source)
    at = [(Fraction(x), Fraction(y)) for x, y in vertices]
    require(faces, "no faces")
    require(vertices[: len(given)] == given, "vertices of the source moved")
    used = {v for face in faces for v in face}
    require({v for face in given_faces for v in face} <= used, "a vertex of the source is in no face")
    require(len({vertices[v] for v in used}) == len(used), "two vertices at one place")
    require(sum(len(face) == 3 for face in faces) <= triangles, "too many triangles")
    directed = set()
    for face in faces:
        require(len(face) in (3, 4), f"a face with {len(face)} corners")
        require(simple_and_positive([at[v] for v in face]), f"not simple and positive: {face}")
        for edge in zip(face, face[1:] + face[:1]):
            require(edge not in directed, f"edge twice: {edge}")
            directed.add(edge)
    boundary, wanted = boundary_of(faces), boundary_of(given_faces)
    after = dict(boundary)
    for a, b in wanted - boundary:
        middle = after.get(a)
        require(middle is not None and middle >= len(given) and after.get(middle) == b,
                f"boundary edge lost: {(a, b)}")
        boundary -= {(a, middle), (middle, b)}
        side = turn(at[a], at[b], at[middle])
        if side == 0 and between(at[a], at[b], at[middle]):
            split -= 1
        else:
            require(side < 0, f"the edge {(a, b)} was moved inwards")
            outside -= 1
    require(split >= 0 and outside >= 0, "more boundary edges were replaced than allowed")
    require(boundary <= wanted, f"boundary edges too many: {sorted(boundary - wanted)[:3]}")
    return len(used - set(range(len(given))))
