#include "run/record.hpp"

#include <fmt/format.h>

#include "console/console.hpp"

namespace armlet::cli {

int Record::choose(const std::string& path) {
  if (path.empty() || path.ends_with(".arec")) {
    file_.set_path(path);
    return kDone;
  }
  progress(fmt::format("armlet: a record is an .arec file, not \"{}\"", path));
  return kUsage;
}

int Record::open(const std::vector<std::string>& texts) {
  return is_wanted() ? file_.open(texts) : kDone;
}

int Record::finish(const SessionLog& log) {
  if (!is_wanted()) return kDone;
  const Result<std::string> text = write_log(log);
  if (text.ok()) {
    file_.file().write(*text);
    return file_.finish();
  }
  progress(fmt::format("armlet: the run cannot be recorded: {}", text.error().message));
  return kFailed;
}

}  // namespace armlet::cli
