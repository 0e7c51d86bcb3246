#include "console/output_file.hpp"

#include <fmt/format.h>

#include <utility>

#include "console/console.hpp"

namespace armlet::cli {

int OutputFile::open(const std::vector<std::string>& texts) {
  for (const std::string& text : texts) {
    if (!is_same_file(path_, text)) continue;
    progress(fmt::format("armlet: the {} {} would take the place of {}", what_, path_, text));
    return kUsage;
  }
  Result<NewFile> made = create_file(path_);
  if (!made.ok()) return refuse(made.error().message, kNoFile);
  file_.emplace(std::move(made).value());
  return kDone;
}

int OutputFile::finish() {
  if (const auto error = file_->finish())
    return refuse(error->message + "; what was there before is as it was", kFailed);
  return kDone;
}

int OutputFile::refuse(const std::string& why, int exit) const {
  progress(fmt::format("armlet: the {} {} cannot be written: {}", what_, path_, why));
  return exit;
}

}  // namespace armlet::cli
