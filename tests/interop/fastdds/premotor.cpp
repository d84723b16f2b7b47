#include "tests/interop/fastdds/premotor.hpp"

#include "tests/interop/fastdds/premotor_adapter.hpp"

namespace scarab::fastdds {
namespace {

constexpr std::chrono::milliseconds kPoll{50};  // for signals; samples wake it at once
constexpr std::chrono::seconds kPatience{1};
constexpr std::size_t kHeldMost = 128;

}  // namespace

Premotor::Premotor(Node& node, const Expectation& expect,
                   const premotor::PremotorController& controller, const StateFile& file)
    : node_(node),
      expect_(expect),
      controller_(controller),
      file_(file),
      trials_(node, kTrial),
      questions_(node, kBehaviour),
      activities_(node, kNeuralActivity),
      commands_(node, kJointCommand),
      status_(node) {
  status_.set_lifecycle(LIFECYCLE_INACTIVE);
}

void Premotor::run(StopSignal& stop) {
  while (!stop.requested()) {
    trials_.take([this](const Trial& trial) {
      if (trial.header().trial() > state_.trial) begin(trial);
    });
    questions_.take([this](const Behaviour& question) {
      if (question.header().trial() >= state_.trial) held_.push_back(question);
      if (held_.size() > kHeldMost) held_.pop_front();
    });
    if (state_.trial != 0 && !ready_) check_peers();
    if (ready_) answer_held();
    status_.publish_if_due();
    node_.wait(kPoll);
  }
  status_.set_lifecycle(LIFECYCLE_FINALISED);
  status_.publish_if_due();
}

/// From the start; or, killed in this trial, from where it was.
void Premotor::begin(const Trial& trial) {
  ready_ = false;
  waiting_since_ = std::chrono::steady_clock::now();
  status_.set_lifecycle(LIFECYCLE_INACTIVE);
  state_.trial = trial.header().trial();
  state_.tick = -1;
  state_.network = controller_.initial_state(trial.seed(), trial.perturb_cpg_phase());
  const auto kept = file_.read();
  if (kept && kept->trial == state_.trial) state_ = *kept;
}

/// Ready is who has matched everybody it needs: nothing sent from now on is lost.
void Premotor::check_peers() {
  const std::string absent = missing_peers();
  if (absent.empty()) {
    ready_ = true;
    status_.set_health(HEALTH_OK);
    status_.set_lifecycle(LIFECYCLE_ACTIVE);
    status_.set_ready(state_.trial);
  } else if (std::chrono::steady_clock::now() - waiting_since_ > kPatience) {
    status_.set_health(HEALTH_WAITING, "waits for " + absent);
  }
}

std::string Premotor::missing_peers() const {
  std::string text;
  const auto look = [&](const char* service, const std::vector<Peer>& peers, const char* action) {
    for (const auto& name : missing(expect_, service, peers, action)) {
      text += (text.empty() ? "" : ", ") + name;
    }
  };
  look("supervisor", questions_.matched(), "to write scarab/behaviour");
  look("plant", commands_.matched(), "to read scarab/joint_command");
  look("logger", commands_.matched(), "to read scarab/joint_command");
  look("logger", activities_.matched(), "to read scarab/neural_activity");
  return text;
}

void Premotor::answer_held() {
  while (!held_.empty() && held_.front().header().trial() <= state_.trial) {
    if (held_.front().header().trial() == state_.trial) answer(held_.front());
    held_.pop_front();
  }
}

/// State k comes of state k-1 alone, and is kept before answer k goes out.
void Premotor::answer(const Behaviour& question) {
  const std::int64_t tick = question.header().tick();
  if (tick < state_.tick) return;
  if (tick > state_.tick + 1) {
    status_.set_health(HEALTH_FAULT, "cannot answer tick " + std::to_string(tick) +
                                         ": last state is of tick " + std::to_string(state_.tick));
    return;
  }
  if (tick == state_.tick + 1) {
    state_.network = controller_.step(state_.network, to_intent(question));
    state_.tick = tick;
    file_.write(state_);
  }
  publish(question);
  status_.set_progress(question.header());
  const bool last = question.state() == BEHAVIOUR_DONE || question.state() == BEHAVIOUR_FAILED;
  if (last) status_.set_lifecycle(LIFECYCLE_INACTIVE);
}

void Premotor::publish(const Behaviour& question) {
  const premotor::MotorIntent intent = to_intent(question);
  Header header = question.header();
  header.stamp_ns(now_ns());
  NeuralActivity activity;
  activity.header(header);
  fill(activity, state_.network);
  activities_.write(activity);
  JointCommand command;
  command.header(header);
  fill(command, controller_.targets(state_.network, intent), intent.stop);
  commands_.write(command);
}

}  // namespace scarab::fastdds
