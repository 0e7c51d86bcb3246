// Reads messages of pages from JSON.

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base85.hpp"
#include "request.hpp"

namespace armlet::lab {
namespace {

using Json = nlohmann::json;

constexpr int kMostNesting = 8;
constexpr std::size_t kMostNumbers = 4096;

struct Wrong {
  std::string why;
};

const Json& field(const Json& message, const char* name) {
  const auto found = message.find(name);
  if (found == message.end()) throw Wrong{fmt::format("The field \"{}\" is missing.", name)};
  return *found;
}

bool has(const Json& message, const char* name) {
  const auto found = message.find(name);
  return found != message.end() && !found->is_null();
}

std::string text_of(const Json& message, const char* name, std::size_t most) {
  const Json& value = field(message, name);
  if (!value.is_string()) throw Wrong{fmt::format("\"{}\" is to be a text.", name)};
  std::string text = value.get<std::string>();
  if (text.size() > most)
    throw Wrong{fmt::format("\"{}\" has {} bytes; at most {} are taken.", name, text.size(), most)};
  return text;
}

double number(const Json& value, const char* name) {
  if (!value.is_number()) throw Wrong{fmt::format("\"{}\" is to be a number.", name)};
  const double out = value.get<double>();
  if (!std::isfinite(out)) throw Wrong{fmt::format("\"{}\" is to be finite.", name)};
  return out;
}

std::int64_t integer(const Json& value, const char* name, std::int64_t least, std::int64_t most) {
  if (value.is_number_integer() &&
      !(value.is_number_unsigned() && value.get<std::uint64_t>() > std::uint64_t{1} << 62U)) {
    const auto out = value.get<std::int64_t>();
    if (out >= least && out <= most) return out;
  }
  throw Wrong{fmt::format("\"{}\" is to be an integer from {} to {}.", name, least, most)};
}

int small(const Json& message, const char* name) {
  return static_cast<int>(integer(field(message, name), name, 0, 1'000'000'000));
}

std::vector<double> numbers(const Json& message, const char* name) {
  const Json& value = field(message, name);
  if (!value.is_array() || value.size() > kMostNumbers)
    throw Wrong{fmt::format("\"{}\" is to be a list of at most {} numbers.", name, kMostNumbers)};
  std::vector<double> out;
  for (const Json& each : value) out.push_back(number(each, name));
  return out;
}

TextPlace place(const Json& message, const char* name) {
  const Json& value = field(message, name);
  if (!value.is_array() || value.size() != 2)
    throw Wrong{fmt::format("\"{}\" is to be [line, column].", name)};
  return {static_cast<int>(integer(value[0], name, 1, 1'000'000'000)),
          static_cast<int>(integer(value[1], name, 0, 1'000'000'000))};
}

std::vector<double> pose_numbers(const Json& message, const char* name) {
  std::vector<double> out = numbers(message, name);
  if (!pose_of(out)) {
    throw Wrong{fmt::format(
        "\"{}\" is to be [x, y, z, qw, qx, qy, qz] with a quaternion that is not zero.", name)};
  }
  return out;
}

constexpr std::size_t kNameBytes = 1000;
constexpr std::size_t kPersonBytes = 80;
constexpr std::size_t kMostFieldBytes = 100'000;

GiveInput input(const Json& message) {
  GiveInput out;
  if (has(message, "t")) out.t = number(field(message, "t"), "t");
  if (has(message, "set")) {
    SetField set{text_of(message, "set", kNameBytes)};
    const Json& value = field(message, "value");
    if (value.is_boolean()) {
      set.value = value.get<bool>();
    } else if (value.is_string()) {
      set.value = text_of(message, "value", kMostFieldBytes);
    } else {
      set.value = number(value, "value");
    }
    out.what = std::move(set);
  } else if (has(message, "press")) {
    out.what = PressButton{text_of(message, "press", kNameBytes)};
  } else if (has(message, "joints")) {
    out.what = SetJoints{text_of(message, "joints", kNameBytes), numbers(message, "values")};
  } else if (has(message, "hand")) {
    out.what = SetHand{text_of(message, "hand", kNameBytes), numbers(message, "values")};
  } else {
    throw Wrong{"An input has one of \"set\", \"press\", \"joints\" and \"hand\"."};
  }
  return out;
}

bool truth(const Json& message, const char* name) {
  if (!has(message, name)) return false;
  if (!message[name].is_boolean()) throw Wrong{fmt::format("\"{}\" is to be true or false.", name)};
  return message[name].get<bool>();
}

SendFile sent_file(const Json& message) {
  std::optional<std::string> bytes = from_base85(text_of(message, "base85", kMostMessageBytes));
  if (!bytes) throw Wrong{"\"base85\" is not written in digits to the base 85."};
  return {.name = text_of(message, "name", kNameBytes),
          .bytes = *std::move(bytes),
          .first = truth(message, "first"),
          .last = truth(message, "last")};
}

Step step(const Json& message) {
  const std::string how = text_of(message, "how", kNameBytes);
  if (how == "into") return {StepHow::kInto};
  if (how == "over") return {StepHow::kOver};
  if (how == "out") return {StepHow::kOut};
  if (how == "back") return {StepHow::kBack};
  if (how == "continue") return {StepHow::kContinue};
  throw Wrong{"\"how\" is to be \"into\", \"over\", \"out\", \"back\" or \"continue\"."};
}

SetBreakpoints breakpoints(const Json& message) {
  SetBreakpoints out;
  for (const double line : numbers(message, "lines")) {
    if (line < 1 || line > 1e9 || line != std::floor(line))
      throw Wrong{"\"lines\" are to be integers from 1."};
    out.lines.push_back(static_cast<int>(line));
  }
  return out;
}

decltype(Request::what) what_of(const std::string& type, const Json& message) {
  using What = AskText::What;
  if (type == "hello") {
    if (integer(field(message, "protocol"), "protocol", 0, 1'000'000) != 1)
      throw Wrong{"This laboratory speaks protocol 1; load the page again."};
    return Hello{has(message, "key") ? text_of(message, "key", kNameBytes) : std::string()};
  }
  if (type == "text") {
    SetText out{text_of(message, "text", kMostTextBytes),
                integer(field(message, "version"), "version", 0, std::int64_t{1} << 53U)};
    if (has(message, "run")) out.runs = truth(message, "run");
    if (has(message, "change")) out.change = small(message, "change");
    return out;
  }
  if (type == "name") return SetName{text_of(message, "name", kPersonBytes)};
  if (type == "complete") return AskText{What::kComplete, place(message, "at")};
  if (type == "hover") return AskText{What::kHover, place(message, "at")};
  if (type == "signature") return AskText{What::kSignature, place(message, "at")};
  if (type == "definition") return AskText{What::kDefinition, place(message, "at")};
  if (type == "format") return FormatText{};
  if (type == "goto") {
    GoTo out{number(field(message, "t"), "t")};
    if (has(message, "run")) out.run = small(message, "run");
    out.looks = has(message, "looks") && truth(message, "looks");
    return out;
  }
  if (type == "picture") {
    AskPicture out{text_of(message, "element", kNameBytes), number(field(message, "t"), "t")};
    if (has(message, "run")) out.run = small(message, "run");
    return out;
  }
  if (type == "step") return step(message);
  if (type == "breakpoints") return breakpoints(message);
  if (type == "input") return input(message);
  if (type == "inverse") {
    AskInverse out{text_of(message, "robot", kNameBytes)};
    out.T_world_tool = *pose_of(pose_numbers(message, "pose"));
    if (has(message, "seed")) out.seed = numbers(message, "seed");
    return out;
  }
  if (type == "show") return ShowRun{small(message, "run")};
  if (type == "compare") return CompareRuns{small(message, "run"), small(message, "with")};
  if (type == "fetch") return FetchRun{small(message, "run")};
  if (type == "stop") return StopRun{};
  if (type == "export") return AskExport{};
  if (type == "save") return SaveText{truth(message, "replaces")};
  if (type == "file") return AskFile{text_of(message, "name", kNameBytes)};
  if (type == "keep") return sent_file(message);
  if (type == "take") return TakeControl{};
  if (type == "give") {
    GiveControl out;
    if (has(message, "to")) out.to = small(message, "to");
    return out;
  }
  throw Wrong{fmt::format("There is no message of the type \"{}\".", type.substr(0, 40))};
}

// Whether brackets are nested deeper than messages need.
bool is_too_deep(std::string_view message) {
  int depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < message.size(); ++i) {
    const char c = message[i];
    if (in_text) {
      if (c == '\\') ++i;
      if (c == '"') in_text = false;
    } else if (c == '"') {
      in_text = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kMostNesting) return true;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return false;
}

}  // namespace

std::optional<Eigen::Isometry3d> pose_of(const std::vector<double>& numbers) {
  if (numbers.size() != 7) return std::nullopt;
  Eigen::Quaterniond turn(numbers[3], numbers[4], numbers[5], numbers[6]);
  const double norm = turn.norm();
  if (!(norm > 1e-6) || !(norm < 1e6)) return std::nullopt;
  turn.coeffs() /= norm;
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.linear() = turn.toRotationMatrix();
  out.translation() = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  return out;
}

std::variant<Request, Unreadable> read_request(std::string_view message) {
  std::optional<std::int64_t> seq;
  try {
    if (message.size() > kMostMessageBytes) {
      throw Wrong{fmt::format("A message has at most {} bytes, not {}.", kMostMessageBytes,
                              message.size())};
    }
    if (is_too_deep(message))
      throw Wrong{"The brackets of the message lie too deep in each other."};
    const Json json = Json::parse(message, nullptr, false);
    if (!json.is_object()) throw Wrong{"A message is one JSON object."};
    if (has(json, "seq")) seq = integer(json["seq"], "seq", 0, std::int64_t{1} << 53U);
    return Request{seq, what_of(text_of(json, "type", kNameBytes), json)};
  } catch (const Wrong& wrong) {
    return Unreadable{seq, wrong.why};
  }
}

}  // namespace armlet::lab
