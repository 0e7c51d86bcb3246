#include "saved_laboratory.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base85.hpp"

namespace armlet::lab {

Result<SavedLaboratory> read_saved(std::string_view json, std::string_view version) {
  try {
    const nlohmann::json given = nlohmann::json::parse(json);
    const std::string made_by = given.at("version").get<std::string>();
    if (given.at("format").get<int>() != 1 || made_by != version) {
      return Error{"version",
                   fmt::format("The laboratory was made by Armlet {}, and this is Armlet {}.",
                               made_by, version)};
    }
    SavedLaboratory saved{.robot = given.at("robot").get<std::string>(),
                          .world = {},
                          .file = given.at("file").get<std::string>(),
                          .text = given.at("text").get<std::string>(),
                          .is_demo = given.at("demo").get<bool>(),
                          .files = {}};
    for (const auto& [path, file] : given.at("files").items()) {
      std::optional<std::string> bytes = file.is_string()
                                             ? file.get<std::string>()
                                             : from_base85(file.at("base85").get<std::string>());
      if (!bytes)
        return Error{"format", fmt::format("The file \"{}\" of the laboratory is damaged.", path)};
      saved.files[path] = *std::move(bytes);
    }
    if (const auto& world = given.at("world"); !world.is_null()) {
      saved.world =
          WorldText{world.at("name").get<std::string>(), world.at("text").get<std::string>()};
    }
    return saved;
  } catch (const nlohmann::json::exception& error) {
    return Error{"format",
                 fmt::format("This is no laboratory that was exported: {}", error.what())};
  }
}

}  // namespace armlet::lab
