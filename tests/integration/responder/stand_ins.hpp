#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/sample_fields.hpp"
#include "common/bus/writer.hpp"
#include "tests/support/inbox.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {

/// The test's own participants around one stateful service of the chain: they tell the trial, ask
/// its questions and read its answers. Service names the service, its topics and its questions.
template <class Service>
class StandIns {
 public:
  using Question = typename Service::Question;
  using Answer = typename Service::Answer;

  StandIns() {
    for (const auto* role : Service::kReaders) {
      readers_.push_back(std::make_unique<bus::Participant>(test_options(role)));
      inboxes_.push_back(std::make_unique<Inbox<Answer>>(*readers_.back(), Service::answer()));
    }
  }

  void tell_trial(std::uint32_t trial) { tell(Service::trial(trial)); }
  void tell(const scarab_Trial& trial) { trials_.write(trial); }

  void ask(const Question& question) { questions_.write(question); }
  void ask(std::uint32_t trial, std::uint32_t tick) { ask(Service::question_of(trial, tick)); }
  Inbox<Answer>& answers() { return *inboxes_.front(); }

  /// Asks and waits for the answer.
  std::optional<Answer> consult(std::uint32_t trial, std::uint32_t tick) {
    ask(trial, tick);
    return answers().await(trial, tick);
  }
  /// The bytes of all answers of ticks first..last, each asked for.
  std::vector<sample::Bytes> consult_all(std::uint32_t trial, std::uint32_t first,
                                         std::uint32_t last) {
    std::vector<sample::Bytes> bytes;
    for (std::uint32_t tick = first; tick <= last; ++tick) {
      const auto answer = consult(trial, tick);
      if (!answer) break;
      bytes.push_back(timeless_bytes(*answer));
    }
    return bytes;
  }

 private:
  bus::Participant experiment_{test_options("experiment")};
  bus::Participant asker_{test_options(Service::kAsker)};
  bus::Writer<scarab_Trial> trials_{experiment_, bus::kTrial};
  bus::Writer<Question> questions_{asker_, Service::question()};
  std::vector<std::unique_ptr<bus::Participant>> readers_;
  std::vector<std::unique_ptr<Inbox<Answer>>> inboxes_;
};

}  // namespace scarab::test
