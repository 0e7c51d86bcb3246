// armlet help --lists: functions, messages and other lists as JSON, for generated documents and for
// editors.

#include <nlohmann/json.hpp>

#include "armlet/backend/trace_format.hpp"
#include "armlet/interpreter/reference.hpp"
#include "armlet/interpreter/unit.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/trajectory/planner.hpp"
#include "console/console.hpp"

namespace armlet::cli {
namespace {

using Json = nlohmann::ordered_json;

// An array with an object for each row.
template <class Rows, class ToObject>
Json list_of(const Rows& rows, const ToObject& to_object) {
  Json list = Json::array();
  for (const auto& row : rows) list.push_back(to_object(row));
  return list;
}

Json words() {
  return list_of(reserved_and_soft_words(), [](const LanguageWord& word) {
    return Json{{"word", word.text}, {"soft", word.soft}};
  });
}

Json units() {
  return list_of(all_units(), [](const Unit& unit) {
    return Json{{"unit", unit.name}, {"of", dimension_name(unit.dim)}};
  });
}

Json chapters() {
  return list_of(library_chapters(), [](const LibraryChapter& chapter) {
    return Json{{"title", chapter.title}, {"mathematics", chapter.is_mathematics}};
  });
}

Json robots() {
  return list_of(catalog_arms(), [](const CatalogArm& arm) {
    return Json{{"name", arm.name},
                {"secondName", arm.second_name},
                {"source", arm.source},
                {"help", arm.help}};
  });
}

Json planners() {
  return list_of(planner_rows(), [](const PlannerRow& row) {
    return Json{{"name", row.name}, {"does", row.does}};
  });
}

Json traces() {
  return list_of(trace_formats(), [](const TraceFormat& format) {
    return Json{{"ending", format.ending}, {"holds", format.holds}};
  });
}

}  // namespace

int lists() {
  const Json all = {
      {"words", words()},       {"units", units()},   {"names", help_names(library_engine())},
      {"chapters", chapters()}, {"robots", robots()}, {"planners", planners()},
      {"traces", traces()}};
  print_out(all.dump(1) + "\n");
  return finish_output() ? kDone : kFailed;
}

}  // namespace armlet::cli
