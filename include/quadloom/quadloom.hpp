// All of the library. Files and pictures are apart: quadloom/io.hpp, in the library quadloom::io.
#pragma once

#include "quadloom/certify.hpp"
#include "quadloom/convex.hpp"
#include "quadloom/core.hpp"
#include "quadloom/dual.hpp"
#include "quadloom/generate.hpp"
#include "quadloom/kernel.hpp"
#include "quadloom/quadrangulate.hpp"
#include "quadloom/strips.hpp"
