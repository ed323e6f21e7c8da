// The verbs: each adds its subcommand, with its options and its help, and sets `run` when it is the
// one that was asked for.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace quadloom::app {

using Run = std::function<int()>;

void add_quadrangulate(CLI::App& app, Run& run);
void add_triangulate(CLI::App& app, Run& run);
void add_check(CLI::App& app, Run& run);
void add_quality(CLI::App& app, Run& run);
void add_draw(CLI::App& app, Run& run);
void add_generate(CLI::App& app, Run& run);
void add_layers(CLI::App& app, Run& run);
void add_polygonize(CLI::App& app, Run& run);
void add_compare(CLI::App& app, Run& run);
void add_strip(CLI::App& app, Run& run);
void add_unstrip(CLI::App& app, Run& run);

}  // namespace quadloom::app
