#pragma once
// The named objects of the host's world, which the host describes before it compiles a program.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace armlet {

// Constant: the host makes it once for the programs of one world.
struct WorldNames {
  std::string world;  // the name of the world; empty: it has none
  std::vector<std::string> things{};
  std::string maker{};  // the function that returns an object by its name; empty: none

  [[nodiscard]] bool has(std::string_view name) const {
    return std::ranges::find(things, name) != things.end();
  }
};

}  // namespace armlet
