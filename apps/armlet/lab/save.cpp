// armlet lab --export and --record FILE.html: the laboratory as a page that needs no command. An
// exported page contains an engine and can be used; a recorded page shows one run.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "armlet/core/base64.hpp"
#include "armlet/stdlib/install.hpp"
#include "console/console.hpp"
#include "console/output_file.hpp"
#include "console/setup.hpp"
#include "embedded_demo.hpp"
#include "lab/lab.hpp"
#include "laboratory.hpp"
#include "run/inputs.hpp"
#include "server/server.hpp"

namespace armlet::cli {
namespace {

using SavedJson = nlohmann::ordered_json;

constexpr std::size_t kMostPageBytes = std::size_t{64} << 20U;
constexpr std::string_view kPlace = "<div id=\"page\"></div>";

int cannot_save(const std::string& why, int exit) {
  progress(fmt::format("armlet: {}", why));
  return exit;
}

// ---- a client of the laboratory, which sends the messages of a page ---------------------------

class Visitor {
 public:
  explicit Visitor(lab::Laboratory& laboratory)
      : laboratory_(laboratory), page_(laboratory.join()) {}

  // Sends a message, lets the laboratory work until it is idle, and returns its messages.
  std::vector<lab::Message> send(const SavedJson& message) {
    laboratory_.receive(page_, message.dump());
    while (!interrupted() && laboratory_.advance()) {
    }
    std::vector<lab::Message> all;
    while (true) {
      std::vector<lab::Message> some = laboratory_.take_messages(page_, std::size_t{1} << 20U);
      if (some.empty()) return all;
      for (lab::Message& each : some) all.push_back(std::move(each));
    }
  }

  // Sends a message and returns the last reply of a type; null: there is none.
  SavedJson ask(const SavedJson& message, std::string_view type) {
    SavedJson found;
    for (const lab::Message& each : send(message)) {
      if (each.is_binary) continue;
      SavedJson told = SavedJson::parse(each.bytes);
      if (told["type"] == "error") throw ArgumentError(told["message"].get<std::string>());
      if (told["type"] == type) found = std::move(told);
    }
    return found;
  }

  // The bytes of a file that pages draw.
  [[nodiscard]] lab::FileBytes file(const std::string& name) const {
    return laboratory_.file(name);
  }

 private:
  lab::Laboratory& laboratory_;
  int page_;
};

// Sends the inputs of a script; its lines are messages. The inputs "show" are only for the command.
void give_inputs(Visitor& visitor, const std::string& path) {
  const std::optional<std::string> text = read_file(path, false);
  if (!text) return;
  for (std::size_t at = 0; at < text->size();) {
    const std::size_t end = std::min(text->find('\n', at), text->size());
    const std::string_view line = std::string_view(*text).substr(at, end - at);
    at = end + 1;
    SavedJson input = SavedJson::parse(line, nullptr, false);
    if (!input.is_object() || input.contains("show")) continue;
    input["type"] = "input";
    visitor.ask(input, "taken");
  }
}

// ---- a run as a page --------------------------------------------------------------------------

// JSON as the text of an element of a page: with no character that ends the element.
std::string in_page(const SavedJson& json) {
  const std::string plain = json.dump(-1, ' ', false, SavedJson::error_handler_t::replace);
  std::string out;
  out.reserve(plain.size());
  for (const char c : plain) c == '<' ? out += "\\u003c" : out += c;
  return out;
}

std::string with_element(std::string page, std::string_view behind, const std::string& element) {
  const std::size_t at = page.find(behind);
  if (at == std::string::npos) throw ArgumentError("the page has no place for it");
  return page.insert(at + behind.size(), element);
}

// Adds the files that a description names, before it.
void add_files(const Visitor& visitor, const SavedJson& told, SavedJson& recording) {
  const auto add = [&](const SavedJson& thing, const char* field) {
    const auto name = thing.find(field);
    if (name == thing.end()) return;
    const lab::FileBytes bytes = visitor.file(name->get<std::string>());
    if (bytes != nullptr) recording.push_back({{"file", *name}, {"binary", to_base64(*bytes)}});
  };
  for (const SavedJson& object : told.at("objects")) {
    add(object, "file");
    add(object, "texture");
  }
  for (const SavedJson& element : told.at("elements")) add(element, "file");
  for (const SavedJson& robot : told.at("robots")) {
    for (const SavedJson& picture : robot.at("pictures")) add(picture, "file");
  }
}

// The times at which data is recorded: at equal intervals, and at the start and end of moves.
std::vector<double> times_to_look(double t_end, const std::vector<SavedJson>& moves) {
  constexpr int kEven = 240;
  constexpr std::size_t kMost = 600;
  std::vector<double> times;
  for (int i = 0; i <= kEven; ++i) times.push_back(t_end * i / kEven);
  for (const SavedJson& each : moves) {
    if (times.size() + 2 > kMost) break;
    for (const char* at : {"t0", "t1"}) times.push_back(std::min(each.at(at).get<double>(), t_end));
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// The members of a JSON object that differ from the known one, which then becomes `now`.
SavedJson changes_of(SavedJson now, SavedJson& known) {
  SavedJson changed = SavedJson::object();
  for (const auto& [name, value] : now.items())
    if (!known.contains(name) || known[name] != value) changed[name] = value;
  known = std::move(now);
  return changed;
}

// The answers to a page at these times of a run, each without what the one before contained.
SavedJson looks_of(Visitor& visitor, int run, const std::vector<double>& times) {
  SavedJson looks = {{"type", "looks"}, {"run", run}, {"items", SavedJson::array()}};
  SavedJson known = SavedJson::object(), known_values = SavedJson::object();
  for (const double t : times) {
    if (interrupted()) break;
    SavedJson instant = visitor.ask(
        {{"type", "goto"}, {"t", t}, {"run", run}, {"looks", true}, {"seq", 1}}, "instant");
    SavedJson values = instant.value("values", SavedJson::object());
    for (const char* own : {"type", "to", "run", "t", "cursor", "values"}) instant.erase(own);
    looks["items"].push_back({{"t", t},
                              {"instant", changes_of(std::move(instant), known)},
                              {"values", changes_of(std::move(values), known_values)}});
  }
  return looks;
}

std::string recorded_page(Visitor& visitor) {
  visitor.ask({{"type", "goto"}, {"t", 0.0}}, "instant");
  SavedJson recording = SavedJson::array();
  std::vector<SavedJson> moves;
  SavedJson run;
  for (const lab::Message& each : visitor.send({{"type", "hello"}, {"protocol", 1}})) {
    if (each.is_binary) {
      recording.push_back({{"binary", to_base64(each.bytes)}});
    } else {
      SavedJson told = SavedJson::parse(each.bytes);
      if (told["type"] == "description") add_files(visitor, told, recording);
      if (told["type"] == "run") run = told;
      if (told["type"] == "moves")
        moves.insert(moves.end(), told["items"].begin(), told["items"].end());
      recording.push_back(std::move(told));
    }
  }
  if (run.is_object())
    recording.push_back(looks_of(visitor, run.at("run").get<int>(),
                                 times_to_look(run.at("t_end").get<double>(), moves)));
  return with_element(std::string(lab::built_in_page()), kPlace,
                      "<script type=\"application/json\" id=\"armlet-recording\">" +
                          in_page(recording) + "</script>");
}

// ---- a page with an engine --------------------------------------------------------------------

// Searches laboratory.html beside the command, in a package, and where `./dev wasm` writes it.
std::optional<std::string> find_engine() {
  std::error_code none;
  const std::filesystem::path command = std::filesystem::read_symlink("/proc/self/exe", none);
  for (const char* folder : {".", "../share/armlet", "../wasm", "../../wasm"}) {
    const std::filesystem::path file = command.parent_path() / folder / "laboratory.html";
    if (std::filesystem::is_regular_file(file, none)) return file.lexically_normal().string();
  }
  return std::nullopt;
}

constexpr std::string_view kNoEngine =
    "the engine for pages is missing: laboratory.html beside this command, in ../share/armlet or "
    "in ../wasm. In the source tree `./dev wasm` makes it (a quarter of an hour the first time, "
    "with emscripten); --engine FILE names another one";

// The page without a laboratory, or the exit status after a message.
struct Template {
  std::string page;
  int exit = kDone;
};

Template read_template(const LabOptions& options) {
  const std::optional<std::string> path =
      options.engine.empty() ? find_engine() : std::optional(options.engine);
  if (!path) return {{}, cannot_save(std::string(kNoEngine), kNoFile)};
  Result<std::string> page = armlet::read_file(*path, kMostPageBytes);
  if (!page.ok())
    return {{}, cannot_save(fmt::format("{}: {}", *path, page.error().message), kNoFile)};
  if (page->find("<meta name=\"armlet-engine\" content=\"" ARMLET_VERSION "\"") ==
      std::string::npos) {
    return {{},
            cannot_save(fmt::format("{} is no engine of Armlet {}; `./dev wasm` makes one", *path,
                                    ARMLET_VERSION),
                        kRejected)};
  }
  return {std::move(page).value()};
}

std::string exported_page(Visitor& visitor, std::string page) {
  const SavedJson exported = visitor.ask({{"type", "export"}}, "exported");
  return with_element(
      std::move(page), kPlace,
      "<script type=\"application/json\" class=\"armlet-part\" id=\"armlet-laboratory\">" +
          in_page(exported.at("laboratory")) + "</script>");
}

int write_page(const std::string& path, const std::string& text,
               const std::vector<std::string>& texts) {
  OutputFile file("page");
  file.set_path(path);
  if (const int exit = file.open(texts); exit != kDone) return exit;
  file.file().write(text);
  if (const int exit = file.finish(); exit != kDone) return exit;
  progress(fmt::format("{}: {:.2f} MB", path, 1e-6 * static_cast<double>(text.size())));
  return kDone;
}

}  // namespace

int save_lab(const LabOptions& options, const RunOptions& run) {
  if (run.file.empty() && !options.demo)
    return cannot_save("which program? armlet lab FILE --export lab.html", kUsage);
  if (!options.export_to.empty() && !options.export_to.ends_with(".html"))
    return cannot_save(
        fmt::format("a laboratory is written to an .html file, not \"{}\"", options.export_to),
        kUsage);
  if (!run.record.empty() && !run.record.ends_with(".html"))
    return cannot_save("a laboratory that is exported is recorded as a page, an .html file",
                       kUsage);
  const std::string file = options.demo ? "demo.rbt" : run.file;
  std::optional<std::string> text =
      options.demo ? std::string(*embedded_demo("demo.rbt")) : read_file(file, run.program.json);
  if (!text) return kNoFile;
  if (InputScript script; script.read(run.inputs) != kDone) return kRejected;
  // Messages about a program that cannot run are shown as by `armlet check`.
  {
    Setup setup = make_setup(run.program, file);
    if (setup.exit != kDone) return setup.exit;
    Session session(library_engine(), std::move(setup.session));
    const bool runs = session.compile(*text, file);
    show(session.problems(), run.program.json);
    if (!runs) return kRejected;
  }
  Template engine;
  if (!options.export_to.empty()) engine = read_template(options);
  if (engine.exit != kDone) return engine.exit;

  lab::Laboratory laboratory({.session = make_setup(run.program, file).session,
                              .file = file.substr(file.find_last_of('/') + 1),
                              .text = *std::move(text),
                              .version = ARMLET_VERSION,
                              .is_demo = options.demo});
  const StayOnInterrupt guard;
  try {
    Visitor visitor(laboratory);
    const SavedJson ended = visitor.ask({{"type", "hello"}, {"protocol", 1}}, "run");
    if (!run.inputs.empty()) give_inputs(visitor, run.inputs);
    if (interrupted()) return kStopped;
    if (ended.value("state", "") != "done")
      progress(fmt::format("{}: {}", file,
                           ended["error"].is_object() ? ended["error"]["message"].get<std::string>()
                                                      : std::string("the run has not ended")));
    const std::vector<std::string> texts{run.file, run.program.world, run.inputs};
    if (!run.record.empty()) {
      if (const int exit = write_page(run.record, recorded_page(visitor), texts); exit != kDone)
        return exit;
    }
    if (options.export_to.empty()) return kDone;
    return write_page(options.export_to, exported_page(visitor, std::move(engine.page)), texts);
  } catch (const ArgumentError& error) {
    return cannot_save(error.what(), kFailed);
  }
}

}  // namespace armlet::cli
