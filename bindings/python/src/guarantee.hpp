// What was promised and is met, in a sentence with the theorem.
#pragma once

#include <string>

#include "quadloom/convex.hpp"
#include "quadloom/quadrangulate.hpp"

namespace quadloom::python {

std::string guarantee_of(const PointResult& result, const PointOptions& options);
std::string guarantee_of(const KAngulationResult& result, std::size_t k);
std::string guarantee_of(const TriangleResult& result, const TriangleOptions& options);
std::string guarantee_of(const ConvexResult& result, const ConvexOptions& options);
std::string guarantee_of(const ConvexMeshResult& result);

}  // namespace quadloom::python
