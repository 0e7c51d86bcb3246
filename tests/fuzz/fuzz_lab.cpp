// The protocol of laboratories: whatever pages send, each page receives consistent messages.
//
// The input is lines. One that begins with + lets a page join, with - the last one leave, with .
// the laboratory work; any other one is a message of the page whose number comes first, by default
// 0.

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <tuple>
#include <vector>

#include "laboratory.hpp"
#include "target.hpp"

using namespace armlet;

namespace {

constexpr int kSlices = 60;
constexpr std::size_t kMostPages = 4;

// What a page has received so far.
class Listener {
 public:
  explicit Listener(int page) : number(page) {}

  void take(const std::vector<lab::Message>& messages) {
    for (const lab::Message& each : messages) each.is_binary ? rows(each) : text(each);
  }

  const int number;

 private:
  void text(const lab::Message& message) {
    const auto json = nlohmann::json::parse(message.bytes, nullptr, false);
    fuzz::demand(json.is_object() && json.contains("type"), "a message is an object with a type");
    if (json["type"] == "welcome") known_.clear();
    if (!json.contains("first")) return;
    advance({json["run"].get<int>(), json["type"].get<std::string>(), 0},
            json["first"].get<std::size_t>(), json["items"].size());
  }

  void rows(const lab::Message& message) {
    std::uint32_t head[6];
    fuzz::demand(message.bytes.size() >= sizeof head, "rows have a head");
    std::memcpy(head, message.bytes.data(), sizeof head);
    fuzz::demand(message.bytes.size() == sizeof head + std::size_t{8} * head[3] * head[4],
                 "rows are as many as the head says");
    advance({static_cast<int>(head[1]), std::to_string(head[0]), head[2]}, head[5], head[4]);
  }

  void advance(const std::tuple<int, std::string, std::uint32_t>& list, std::size_t first,
               std::size_t count) {
    std::size_t& known = known_[list];
    fuzz::demand(first == known || first == 0, "lists grow without gaps");
    known = first + count;
  }

  std::map<std::tuple<int, std::string, std::uint32_t>, std::size_t> known_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lab::LaboratoryOptions options;
  options.session = fuzz::small_session();
  options.text = "wait(1s)\n";
  options.bounds = {.time_ns = 10'000'000'000, .steps = 50'000};
  options.most_runs = 4;
  lab::Laboratory laboratory(options);
  std::vector<Listener> pages;
  const auto join = [&] {
    if (pages.size() < kMostPages) pages.emplace_back(laboratory.join());
  };
  const auto listen = [&] {
    for (Listener& each : pages) each.take(laboratory.take_messages(each.number, 20'000));
  };
  join();
  const std::string text = fuzz::text_of(data, size);
  std::string_view rest = text;
  while (!rest.empty()) {
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    if (line.starts_with('+')) {
      join();
    } else if (line.starts_with('-')) {
      if (!pages.empty()) laboratory.leave(pages.back().number);
      if (!pages.empty()) pages.pop_back();
    } else if (line.starts_with('.')) {
      for (int i = 0; i < kSlices && laboratory.advance(); ++i) listen();
    } else if (!pages.empty()) {
      const bool has_number = !line.empty() && line[0] >= '0' && line[0] <= '9';
      const std::size_t page = has_number ? static_cast<std::size_t>(line[0] - '0') : 0;
      if (has_number) line.remove_prefix(1);
      laboratory.receive(pages[page % pages.size()].number, line);
    }
    listen();
  }
  for (int i = 0; i < 200; ++i) listen();
  return 0;
}
