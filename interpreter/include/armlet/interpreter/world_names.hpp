#pragma once
// The things that programs call by name, described by the host before it compiles.

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace armlet {

// Never changes: the host makes it once for the programs of one world.
struct WorldNames {
  std::string world;  // what the world is called; empty: it has no name
  std::vector<std::string> things{};
  std::string maker{};  // the function that gives a thing by its name; empty: none does

  [[nodiscard]] bool has(std::string_view name) const {
    return std::ranges::find(things, name) != things.end();
  }
};

}  // namespace armlet
