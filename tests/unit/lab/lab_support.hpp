#pragma once
// A laboratory with a page, for tests: what the page has received, as JSON.

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "armlet/model/catalog.hpp"
#include "laboratory.hpp"

namespace armlet::lab {

using TestJson = nlohmann::json;

inline LaboratoryOptions lab_with(std::string text) {
  LaboratoryOptions options;
  options.session.robot = make_robot("scara");
  options.session.default_world = table_world();
  options.text = std::move(text);
  return options;
}

inline void finish_work(Laboratory& laboratory) {
  for (int i = 0; i < 100'000 && laboratory.advance(); ++i) {
  }
}

// A picture of an element, as a message has it.
struct TestPicture {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<std::uint8_t> pixels;
  TestJson told;
};

// A page that keeps everything it receives.
class TestPage {
 public:
  explicit TestPage(Laboratory& laboratory) : laboratory_(laboratory), number(laboratory.join()) {}

  void send(const TestJson& message) { laboratory_.receive(number, message.dump()); }
  void hello() { send({{"type", "hello"}, {"protocol", 1}, {"seq", 1}}); }
  // Takes what there is, in pieces of so many bytes.
  void take(std::size_t bytes = 1 << 20) {
    while (true) {
      const std::vector<Message> messages = laboratory_.take_messages(number, bytes);
      if (messages.empty()) return;
      for (const Message& each : messages) keep(each);
    }
  }
  // Sends, lets everything be worked off and gives the answer; null: there is none.
  TestJson ask(TestJson message) {
    message["seq"] = ++seq_;
    send(message);
    finish_work(laboratory_);
    take();
    for (auto each = told.rbegin(); each != told.rend(); ++each) {
      if (each->value("to", std::int64_t{-1}) == seq_) return *each;
    }
    return {};
  }
  // The last message of a type; null: there is none.
  [[nodiscard]] TestJson last(std::string_view type) const {
    for (auto each = told.rbegin(); each != told.rend(); ++each) {
      if ((*each)["type"] == type) return *each;
    }
    return {};
  }
  // All items of a list of a run.
  [[nodiscard]] TestJson list(std::string_view type, int run) const {
    TestJson items = TestJson::array();
    for (const TestJson& each : told) {
      if (each["type"] != type || each["run"] != run) continue;
      if (each["first"] == 0) items.clear();
      for (const TestJson& item : each["items"]) items.push_back(item);
    }
    return items;
  }

  using Key = std::array<std::uint32_t, 3>;  // kind, run, index
  std::vector<TestJson> told;
  std::map<Key, std::vector<double>> rows;
  std::map<std::int64_t, TestPicture> pictures;  // by the number of the question
  [[nodiscard]] std::int64_t last_seq() const { return seq_; }

 private:
  void keep(const Message& message) {
    if (!message.is_binary) {
      told.push_back(TestJson::parse(message.bytes));
      return;
    }
    std::uint32_t head[6];
    std::memcpy(head, message.bytes.data(), sizeof head);
    if (head[0] == kPictureMessage) {
      const std::size_t size = std::size_t{head[2]} * head[3] * head[4];
      if (message.bytes.size() != sizeof head + size + head[5]) told.push_back({{"type", "gap"}});
      const char* pixels = message.bytes.data() + sizeof head;
      pictures[head[1]] = {static_cast<int>(head[3]),
                           static_cast<int>(head[4]),
                           static_cast<int>(head[2]),
                           {pixels, pixels + size},
                           TestJson::parse(std::string(pixels + size, head[5]))};
      return;
    }
    std::vector<double> values((message.bytes.size() - sizeof head) / sizeof(double));
    std::memcpy(values.data(), message.bytes.data() + sizeof head, values.size() * sizeof(double));
    std::vector<double>& known = rows[{head[0], head[1], head[2]}];
    if (head[5] == 0) known.clear();
    if (known.size() != std::size_t{head[5]} * head[3] ||
        values.size() != std::size_t{head[4]} * head[3])
      told.push_back({{"type", "gap"}});
    known.insert(known.end(), values.begin(), values.end());
  }

  Laboratory& laboratory_;
  std::int64_t seq_ = 1;

 public:
  const int number;
};

}  // namespace armlet::lab
