#include <armlet/core/error.hpp>

#include <cstdio>

int main() {
  try {
    armlet::check_size("q", 5, 6);
  } catch (const armlet::ArgumentError& error) {
    std::puts(error.what());
    return 0;
  }
  return 1;
}
