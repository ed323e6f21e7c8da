#include "mesh.hpp"

#include <nanobind/stl/array.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include <filesystem>
#include <numeric>

#include "arrays.hpp"
#include "bind.hpp"
#include "choice.hpp"
#include "fields.hpp"
#include "inputs.hpp"
#include "progress.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace quadloom::python {
namespace {

constexpr int kNotebookWidth = 640;
constexpr std::size_t kMostFacesAsSvg = 5000;  // more make a notebook slow; they are shown as PNG

void add_faces(PolygonMesh& out, std::span<const VertexId> corners, std::uint32_t size) {
  auto end = out.face_begin.back();
  for (std::size_t i = 0; i < corners.size(); i += size) out.face_begin.push_back(end += size);
  out.face_vertex.insert(out.face_vertex.end(), corners.begin(), corners.end());
}

// The faces of that many corners, cached in the mesh.
std::span<const VertexId> faces_of_size(const Mesh& mesh, std::size_t size) {
  const Parts parts = mesh.parts();
  if (parts.faces == nullptr) return size == 4 ? parts.quads : parts.triangles;
  std::vector<VertexId>& cache = size == 4 ? mesh.quads_of_faces : mesh.triangles_of_faces;
  if (cache.empty()) {
    for (std::size_t f = 0; f < parts.faces->face_count(); ++f) {
      const auto face = parts.faces->face(f);
      if (face.size() == size) cache.insert(cache.end(), face.begin(), face.end());
    }
  }
  return cache;
}

// (n, 2), or (n, 3) with heights.
nb::object points_array(const Mesh& mesh, nb::handle owner) {
  const std::span<const Point> points = mesh.parts().points;
  const std::span<const double> z = mesh.z();
  if (z.empty()) return nb::cast(view(points, owner));
  if (mesh.xyz.empty()) mesh.xyz = interleaved(points, z);
  return nb::cast(view<3>(mesh.xyz, owner));
}

Array<bool> is_steiner(const Mesh& mesh) {
  const Parts parts = mesh.parts();
  if (mesh.is_steiner.empty()) {
    mesh.is_steiner.resize(parts.points.size(), 0);
    for (const VertexId v : mesh.added()) mesh.is_steiner[v] = 1;
  }
  return view_rows<bool, 1>(mesh.is_steiner.data(), mesh.is_steiner.size());
}

std::string text_of(nb::handle self) {
  const Mesh& mesh = *nb::cast<const Mesh*>(self);
  const Parts parts = mesh.parts();
  const std::size_t quads = faces_of_size(mesh, 4).size() / 4;
  const std::size_t triangles = faces_of_size(mesh, 3).size() / 3;
  const std::size_t others = mesh.face_count() - quads - triangles;
  const std::size_t added = mesh.added().size();
  std::string text = std::string("<") + nb::cast<std::string>(self.type().attr("__name__")) + ": " +
                     counted(parts.points.size(), "point");
  if (added > 0) text += " (" + counted(added, "of them added", "of them added") + ")";
  if (quads > 0) text += ", " + counted(quads, "quad");
  if (triangles > 0) text += ", " + counted(triangles, "triangle");
  if (others > 0) text += ", " + counted(others, "other face");
  if (mesh.face_count() == 0) text += ", no faces";
  return text + ">";
}

// Values at the input points are those of the first of them at each vertex.
Array<double> interpolated(nb::handle self, const NumbersLike& given) {
  const Mesh& mesh = *nb::cast<const Mesh*>(self);
  const Parts parts = mesh.parts();
  std::vector<double> values = doubles_from(given, "values");
  std::vector<VertexId> vertex(parts.input_vertices);
  std::iota(vertex.begin(), vertex.end(), VertexId{0});
  if (nb::hasattr(self, "input_to_vertex")) {
    const nb::object map = self.attr("input_to_vertex");
    vertex = indices_from(nb::borrow<NumbersLike>(map), "input_to_vertex");
  }
  if (values.size() != vertex.size()) {
    throw Error(ErrorCode::kBadOption, "values has " + counted(values.size(), "number") +
                                           ", there are " + counted(vertex.size(), "input point"));
  }
  return own(carry_values(values, vertex, parts.points, parts.steiner).values);
}

io::DrawOptions notebook_options(const Mesh& mesh) {
  io::DrawOptions options;
  options.width = kNotebookWidth;
  options.steiner = mesh.added();
  return options;
}

bool can_be_drawn(const io::MeshFile& file) {
  try {
    check_faces(file.mesh);
    return true;
  } catch (const Error&) {
    return false;
  }
}

// The picture in that format, or None where the other format is the better one, or where there is none.
nb::object notebook_picture(const Mesh& mesh, bool svg) {
  if (mesh.face_count() == 0 || (mesh.face_count() <= kMostFacesAsSvg) != svg) return nb::none();
  const io::MeshFile file = mesh.file();
  if (!can_be_drawn(file)) return nb::none();
  const std::string picture = without_gil(
      [&] { return io::draw_picture(svg ? "svg" : "png", file, notebook_options(mesh)); });
  if (svg) return nb::str(picture.data(), picture.size());
  return nb::bytes(picture.data(), picture.size());
}

// A method that is a function of one of the package's modules in Python.
template <typename... Extra>
void def_python(nb::class_<Mesh>& mesh, const char* name, const char* module,
                const Extra&... extra) {
  mesh.def(
      name,
      [name, module](nb::handle self, const nb::args& args, const nb::kwargs& options) {
        return nb::module_::import_(module).attr(name)(self, *args, **options);
      },
      extra...);
}

void bind_other_packages(nb::class_<Mesh>& mesh) {
  def_python(
      mesh, "to_meshio", "quadloom._interop", nb::sig("def to_meshio(self) -> typing.Any"),
      "A meshio.Mesh of the points (n, 3), the faces, the lines of a MeshFile and the data; added "
      "points are marked in point_data[\"added\"]. Needs the extra `meshio`.");
  def_python(mesh, "to_pyvista", "quadloom._interop", nb::sig("def to_pyvista(self) -> typing.Any"),
             "A pyvista.PolyData of the faces and the data; added points are marked in "
             "point_data[\"added\"]. "
             "Needs the extra `pyvista`.");
  def_python(
      mesh, "plot", "quadloom._plot",
      nb::sig("def plot(self, ax: typing.Any = None, *, colour: str | numpy.typing.ArrayLike = "
              "'quality', edges: bool = True, added: bool = True, **options: typing.Any) -> "
              "typing.Any"),
      R"(Draws the mesh, seen from above, into Matplotlib's axes, the current ones if none are given, and returns the
artist that has the colours, for a colour bar. Needs the extra `plot`.

`colour`: "quality", the quads by quad_shape, other faces grey; "none"; one number a face; or one a vertex, for smooth
shading (where there are as many faces as vertices the numbers are taken for the vertices'). `edges` draws the edges,
`added` a ring around each added point. `options` go to Matplotlib: cmap, clim, linewidths, edgecolors, alpha.)");
}

void bind_steiner_point(nb::module_& m) {
  bind_words<SteinerKind>(m, "SteinerKind", "Where an added point lies.",
                          {{SteinerKind::kOutside, "outside", "outside the region of the input"},
                           {SteinerKind::kOnEdge, "on-edge", "on an edge of its boundary"},
                           {SteinerKind::kInner, "inner", "inside"}});
  Fields<SteinerPoint>(
      m, "SteinerPoint",
      "An added point, and the vertices that it was made from (an edge's ends or a "
      "triangle's corners; NONE where there are fewer than three).")
      .value("vertex", &SteinerPoint::vertex, "Its number.")
      .value("kind", &SteinerPoint::kind, "Where it lies.")
      .value("parents", &SteinerPoint::parents, "Three vertices.")
      .done();
}

}  // namespace

std::span<const double> Mesh::z() const {
  const Parts p = parts();
  return p.z.empty() ? std::span<const double>(heights) : p.z;
}

PolygonMesh Mesh::polygons() const {
  const Parts p = parts();
  if (p.faces != nullptr) return *p.faces;
  PolygonMesh out;
  out.points.assign(p.points.begin(), p.points.end());
  add_faces(out, p.quads, 4);
  add_faces(out, p.triangles, 3);
  return out;
}

std::vector<VertexId> Mesh::added() const {
  std::vector<VertexId> out;
  for (const SteinerPoint& s : parts().steiner) out.push_back(s.vertex);
  return out;
}

std::size_t Mesh::face_count() const {
  const Parts p = parts();
  return p.faces != nullptr ? p.faces->face_count() : p.quads.size() / 4 + p.triangles.size() / 3;
}

io::MeshFile Mesh::file() const {
  io::MeshFile out;
  out.mesh = polygons();
  out.z.assign(z().begin(), z().end());
  out.z_is_data = parts().z.empty() && !heights.empty();
  const std::vector<VertexId> steiner = added();
  if (!steiner.empty()) {
    io::Attribute flag{"added", std::vector<double>(out.mesh.points.size(), 0)};
    for (const VertexId v : steiner) flag.values[v] = 1;
    out.vertex_data.push_back(std::move(flag));
  }
  return out;
}

std::string counted(std::size_t n, const std::string& singular, const std::string& plural) {
  const std::string digits = std::to_string(n);
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out + " " + (n == 1 ? singular : plural.empty() ? singular + "s" : plural);
}

void bind_mesh(nb::module_& m) {
  bind_steiner_point(m);
  nb::class_<Mesh> mesh(
      m, "Mesh",
      "A mesh: the base of all results that have points and faces.\n\n"
      "The arrays view the memory of the result and keep it alive; they are read-only, "
      "`.copy()` gives one to write to.");
  mesh.def_prop_ro(
      "points", [](nb::pointer_and_handle<Mesh> self) { return points_array(*self.p, self.h); },
      nb::sig("def points(self) -> numpy.typing.NDArray[numpy.float64]"),
      "The vertices, float64 (n, 2), or (n, 3) where there are heights; those of the input come "
      "first, in the order of their first occurrence, added points follow.");
  mesh.def_prop_ro(
      "quads", [](const Mesh& self) { return view<4>(faces_of_size(self, 4)); },
      "The quadrilaterals, uint32 (m, 4): numbers of vertices, counter-clockwise.");
  mesh.def_prop_ro(
      "triangles", [](const Mesh& self) { return view<3>(faces_of_size(self, 3)); },
      "The triangles, uint32 (t, 3): numbers of vertices, counter-clockwise. Of a mesh of quads: "
      "those "
      "that were left over, as a rule none.");
  mesh.def_prop_ro(
      "face_count", &Mesh::face_count,
      "How many faces there are. Where faces are numbered, quads come first, then triangles.");
  mesh.def_prop_ro("is_steiner", &is_steiner, "Per vertex: is it an added point? bool (n,).");
  mesh.def_prop_ro(
      "steiner",
      [](const Mesh& self) {
        const auto steiner = self.parts().steiner;
        return std::vector<SteinerPoint>(steiner.begin(), steiner.end());
      },
      "The added points: the vertex, where it lies, and the vertices that it was made from.");
  mesh.def_prop_ro(
      "input_vertices", [](const Mesh& self) { return self.parts().input_vertices; },
      "How many vertices are distinct points of the input; the others are added points.");
  mesh.def_ro(
      "guarantee", &Mesh::guarantee,
      "What was promised for this input and these options, by which theorem, and is met; empty for "
      "a mesh that no algorithm made.");
  mesh.def(
      "interpolate",
      [](nb::handle self, const NumbersLike& values) { return interpolated(self, values); },
      "values"_a,
      "Numbers at the vertices, float64 (n,), from numbers at the input points: those of an added "
      "point are "
      "interpolated between the vertices that it was made from.");
  mesh.def(
      "save",
      [](nb::handle self, const std::filesystem::path& path) {
        nb::module_::import_("quadloom").attr("write_mesh")(path, self);
      },
      "path"_a, "Writes the mesh to a file, by the name: see write_mesh.");
  mesh.def(
      "draw",
      [](nb::handle self, const std::filesystem::path& path, const nb::kwargs& options) {
        nb::module_::import_("quadloom").attr("draw_mesh")(path, self, **options);
      },
      "path"_a, "options"_a, "Draws the mesh into a file, .svg .png or .pdf: see draw_mesh.");
  bind_other_packages(mesh);
  mesh.def("__repr__", &text_of);
  mesh.def(
      "_repr_svg_", [](const Mesh& self) { return notebook_picture(self, true); },
      "The picture that notebooks show, for up to 5,000 faces.");
  mesh.def(
      "_repr_png_", [](const Mesh& self) { return notebook_picture(self, false); },
      "The same for more faces.");
}

}  // namespace quadloom::python
