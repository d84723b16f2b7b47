#include "tools/doctor/survey.hpp"

#include <algorithm>
#include <iostream>

#include "common/bus/waitset.hpp"
#include "common/runtime/program.hpp"
#include "common/runtime/shutdown.hpp"

namespace scarab::doctor {
namespace {

using Clock = std::chrono::steady_clock;

// Participants on one machine know each other within some 10 ms; of a stack of 30, within 1 s.
constexpr std::chrono::milliseconds kQuiet{300};
constexpr std::chrono::milliseconds kTypePatience{500};

/// All but those of the participant that looks.
Survey seen_by(const bus::Participants& participants, const bus::Discovery& discovery) {
  Survey survey{participants.all(), {}};
  survey.participants.erase(participants.self());
  for (auto& endpoint : discovery.endpoints()) {
    if (endpoint.participant != participants.self())
      survey.endpoints.push_back(std::move(endpoint));
  }
  return survey;
}

}  // namespace

int look(const runtime::BusOptions& options, std::chrono::milliseconds limit,
         std::size_t at_least) {
  bus::Participant participant(options.participant("doctor", 0));
  bus::Discovery discovery(participant);
  bus::Participants participants(participant);
  bus::Guard guard(participant);
  runtime::Shutdown shutdown(guard);
  bus::WaitSet wait_set(participant);
  wait_set.attach(guard);
  wait_set.attach(discovery);

  const auto end = Clock::now() + limit;
  Survey survey;
  while (!shutdown.requested() && Clock::now() < end) {
    const Clock::duration left = end - Clock::now();
    const bool enough = survey.participants.size() >= at_least;
    const bool news = wait_set.wait(enough ? std::min<Clock::duration>(left, kQuiet) : left);
    discovery.update();
    participants.update();
    survey = seen_by(participants, discovery);
    if (enough && !news) break;
  }
  if (shutdown.requested()) return runtime::kExitInterrupted;
  bus::TypeTexts types(discovery, kTypePatience);
  const auto faults =
      bus::endpoint_faults(survey.endpoints, [&](const auto& endpoint) { return types(endpoint); });
  std::cout << json(survey, faults);
  return runtime::kExitSuccess;
}

}  // namespace scarab::doctor
