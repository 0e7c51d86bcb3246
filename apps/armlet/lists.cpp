// armlet help --lists: what there is, as JSON: for documents that are made from it, and for
// editors.

#include <nlohmann/json.hpp>

#include "armlet/backend/trace_format.hpp"
#include "armlet/interpreter/reference.hpp"
#include "armlet/interpreter/unit.hpp"
#include "armlet/model/catalog.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/trajectory/planner.hpp"
#include "console.hpp"

namespace armlet::cli {
namespace {

using Json = nlohmann::ordered_json;

Json words() {
  Json list = Json::array();
  for (const LanguageWord& word : reserved_and_soft_words())
    list.push_back({{"word", word.text}, {"soft", word.soft}});
  return list;
}

Json units() {
  Json list = Json::array();
  for (const Unit& unit : all_units())
    list.push_back({{"unit", unit.name}, {"of", dimension_name(unit.dim)}});
  return list;
}

Json chapters() {
  Json list = Json::array();
  for (const LibraryChapter& chapter : library_chapters())
    list.push_back({{"title", chapter.title}, {"mathematics", chapter.is_mathematics}});
  return list;
}

Json robots() {
  Json list = Json::array();
  for (const CatalogArm& entry : catalog_arms()) {
    list.push_back({{"name", entry.name},
                    {"secondName", entry.second_name},
                    {"source", entry.source},
                    {"help", entry.help}});
  }
  return list;
}

Json planners() {
  Json list = Json::array();
  for (const PlannerRow& row : planner_rows())
    list.push_back({{"name", row.name}, {"does", row.does}});
  return list;
}

Json traces() {
  Json list = Json::array();
  for (const TraceFormat& format : trace_formats())
    list.push_back({{"ending", format.ending}, {"holds", format.holds}});
  return list;
}

}  // namespace

int lists() {
  const Json all = {
      {"words", words()},       {"units", units()},         {"names", help_names(engine())},
      {"chapters", chapters()}, {"robots", robots()},       {"planners", planners()},
      {"traces", traces()},     {"later", later_features()}};
  print_out(all.dump(1) + "\n");
  return finish_output() ? kDone : kFailed;
}

}  // namespace armlet::cli
