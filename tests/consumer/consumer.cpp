// Uses the core library: succeeds if a triangulated square turns left at its corner.
#include <cstring>
#include <quadloom/quadloom.hpp>
#include <quadloom/version.hpp>
#include <vector>

int main() {
  const std::vector<quadloom::Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const bool turns_left = quadloom::orient2d(square[0], square[1], square[2]) == 1;
  return turns_left && std::strlen(quadloom::kVersion) >= 5 ? 0 : 1;
}
