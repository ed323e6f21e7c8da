// The command line: finds the verb, runs it, and turns what went wrong into a sentence and a code.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exit_codes.hpp"
#include "options.hpp"
#include "quadloom/core.hpp"
#include "quadloom/version.hpp"
#include "verbs.hpp"

namespace quadloom::app {
namespace {

constexpr const char* kAbout =
    "Quadloom: meshes of quadrilaterals from points, triangles and polygons, exact and certified.\n"
    "\n"
    "  quadloom quadrangulate towns.csv -o towns.vtu --picture towns.png\n"
    "  quadloom quadrangulate coast.14 -o coast.vtu\n"
    "  quadloom VERB --help";

constexpr const char* kFooter =
    "\nExit codes: 0 done; 1 the mesh does not pass the check; 2 usage; 3 a file or what is in\n"
    "it; 4 a guarantee that was asked for is not met.";

// What the library says, but for a verb that is not there: the first word that is no option's.
std::string sentence(const CLI::ParseError& e, const CLI::App& app) {
  const std::vector<std::string> words = app.remaining();
  const bool no_verb = dynamic_cast<const CLI::RequiredError*>(&e) != nullptr &&
                       std::string_view(e.what()).find("subcommand") != std::string_view::npos;
  if (no_verb && !words.empty() && words[0][0] != '-') {
    return fmt::format("there is no command '{}'", words[0]);
  }
  return e.what();
}

int run_command_line(int argc, char** argv) {
  CLI::App app(kAbout, "quadloom");
  app.footer(kFooter);
  app.set_version_flag("--version", std::string("quadloom ") + kVersion);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  app.fallthrough();  // --threads may follow the verb
  std::size_t threads = 0;
  add_threads(app, threads);
  Run run;
  for (const auto add :
       {add_quadrangulate, add_triangulate, add_check, add_quality, add_draw, add_generate,
        add_layers, add_polygonize, add_compare, add_strip, add_unstrip}) {
    add(app, run);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help, --version
    fmt::print(stderr, "quadloom: {}; see quadloom --help\n", sentence(e, app));
    return kUsage;
  }
  std::optional<ThreadLimit> limit;
  if (threads > 0) limit.emplace(threads);
  return run();
}

}  // namespace
}  // namespace quadloom::app

int main(int argc, char** argv) {
  using namespace quadloom;
  try {
    return app::run_command_line(argc, argv);
  } catch (const Error& e) {
    fmt::print(stderr, "quadloom: {}\n", e.what());
    return app::exit_code(e.code());
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "quadloom: not enough memory for this input\n");
    return app::kInput;
  } catch (const std::exception& e) {
    fmt::print(stderr, "quadloom: {}\n", e.what());
    return app::kCheckFailed;
  }
}
