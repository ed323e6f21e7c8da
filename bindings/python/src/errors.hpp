// Errors of the library as quadloom.Error, with their code and culprits.
#pragma once

namespace quadloom::python {

/// From here on an Error thrown in C++ is a quadloom.Error in Python.
void translate_errors();

}  // namespace quadloom::python
