// Files and pictures: see include/quadloom/io.hpp.
