#include "tools/operator/operator.hpp"

#include <algorithm>
#include <iostream>
#include <optional>
#include <string>

#include "common/runtime/operator_desk.hpp"
#include "common/runtime/program.hpp"
#include "tools/operator/exchange.hpp"
#include "tools/operator/sentence.hpp"

namespace scarab::operator_desk {
namespace {

using namespace std::chrono_literals;
using Report = runtime::ServiceReport;

constexpr std::chrono::milliseconds kListenerLimit = 3s;
constexpr std::chrono::milliseconds kAnswerLimit = 3s;
constexpr std::chrono::milliseconds kEffectLimit = 1s;
constexpr std::chrono::milliseconds kTickLimit = 300ms;  // in real time a tick takes 100 ms

/// What nobody must take for done.
std::string warning(const Order& order) {
  const bool emergency = order.command == scarab_OPERATOR_EMERGENCY_STOP;
  return emergency ? "THE EMERGENCY STOP DID NOT GET THROUGH: " : "";
}

int fail(const std::string& what) {
  std::cerr << "scarab-operator: " << what << '\n';
  return runtime::kExitFailure;
}

std::string where(const runtime::BusOptions& options) {
  return "domain " + std::to_string(options.domain) +
         (options.tag.empty() ? "" : " with tag " + options.tag);
}

/// The supervisor takes words with the next tick, and a paused trial has none.
bool waits_for_a_tick(const Exchange& exchange) {
  const auto master = exchange.tick_master();
  const Report* report = master ? exchange.report(*master) : nullptr;
  return report != nullptr && is_paused(*report);
}

int report_silence(const Exchange& exchange, const bus::Peer& listener, const Order& order) {
  const auto master = exchange.tick_master();
  const Report* tick_master = master ? exchange.report(*master) : nullptr;
  const bool for_supervisor = !runtime::is_for_tick_master(order.command);
  if (for_supervisor && waits_for_a_tick(exchange)) {
    std::cout << bus::to_string(listener) << ": '" << order.name
              << "' counts from the next tick (start or step); " << sentence(*tick_master) << '\n';
    return runtime::kExitSuccess;
  }
  const std::string stands = tick_master != nullptr ? "; " + sentence(*tick_master) : "";
  return fail(warning(order) + bus::to_string(listener) + " has not acknowledged '" + order.name +
              "' within " + std::to_string(kAnswerLimit / 1s) + " s" + stands);
}

int report_nobody(const runtime::BusOptions& bus_options, const Order& order) {
  const bool for_master = runtime::is_for_tick_master(order.command);
  return fail(
      warning(order) + (for_master ? "no tick master (plant or robot bridge)" : "no supervisor") +
      ": nobody listens on scarab/operator on " + where(bus_options) + " (is the stack up?)");
}

std::optional<bus::Peer> await_acknowledgement(Exchange& exchange, const Order& order) {
  const auto since = std::chrono::steady_clock::now();
  const bool for_master = runtime::is_for_tick_master(order.command);
  return exchange.await_acknowledgement(
      [&] {
        const bool patient = std::chrono::steady_clock::now() - since < kTickLimit;
        return !for_master && !patient && waits_for_a_tick(exchange);
      },
      kAnswerLimit);
}

/// An emergency stop is said before anybody is found: it is handed to the tick master the moment
/// the two have met. All else is said to somebody known to listen, as of the running trial.
int exchange_order(Exchange& exchange, const runtime::BusOptions& bus_options, const Order& order) {
  const bool at_once = order.command == scarab_OPERATOR_EMERGENCY_STOP;
  const bool for_master = runtime::is_for_tick_master(order.command);
  if (at_once) exchange.say(order, 0);
  const auto listener = exchange.find_listener(for_master, kListenerLimit);
  if (!listener) return report_nobody(bus_options, order);
  const auto before = at_once ? std::nullopt : exchange.await_report(*listener, kListenerLimit);
  if (!at_once) {
    const auto trial = before ? std::max(before->header.trial, before->ready_trial) : 0;
    exchange.say(order, for_master ? 0 : trial);
  }
  const auto who = await_acknowledgement(exchange, order);
  if (!who) return report_silence(exchange, *listener, order);
  const auto answer = exchange.await_effect(
      *who, [&](const Report& now) { return shows_effect(order, before.value_or(now), now); },
      kEffectLimit + order.times * kTickLimit);
  if (!answer) return fail(bus::to_string(*who) + " has gone since it took '" + order.name + "'");
  if (!for_master && answer->health != scarab_HEALTH_OK) return fail(sentence(*answer));
  const bool refused = order.command == scarab_OPERATOR_RESET &&
                       !shows_effect(order, before.value_or(*answer), *answer);
  if (refused) return fail(sentence(*answer));
  std::cout << sentence(*answer) << '\n';
  return runtime::kExitSuccess;
}

}  // namespace

int give(const runtime::BusOptions& bus_options, const Order& order) {
  try {
    Exchange exchange(bus_options);
    return exchange_order(exchange, bus_options, order);
  } catch (const Interrupted&) {
    std::cerr << "scarab-operator: interrupted: '" << order.name
              << "' may or may not have been carried out\n";
    return runtime::kExitInterrupted;
  }
}

}  // namespace scarab::operator_desk
