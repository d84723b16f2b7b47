#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/config.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/parser.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/status.hpp"
#include "services/robot_bridge/drivers/dynamixel/question.hpp"
#include "services/robot_bridge/drivers/serial/serial_port.hpp"

namespace scarab::bridge::dynamixel {

/// What went over the bus, and what went wrong, since the program started; the parser counts the
/// rest.
struct BusCounters {
  std::uint64_t exchanges = 0;      ///< questions, each with its answer or answers
  std::uint64_t retries = 0;        ///< questions put once more
  std::uint64_t timeouts = 0;       ///< attempts without all of the answers
  std::uint64_t wrong_answers = 0;  ///< from a device or of a length that was not asked
  std::uint64_t refusals = 0;       ///< answers with an error number
  std::uint64_t echoes = 0;         ///< own instructions heard
  std::uint64_t bytes_received = 0;
  std::uint64_t bytes_late = 0;  ///< of answers to a question that was given up
};

struct BusOptions {
  std::string port;
  unsigned baud = 1000000;
  double reply_timeout_s = 0.005;
  unsigned retries = 2;
  std::map<std::uint8_t, std::string> names;  ///< what each device is called in messages
};

/// The line with all devices on it: puts questions, waits for their answers, asks again.
///
/// An attempt lasts as long as its bytes take on the line, and `reply_timeout_s`; so the whole
/// exchange is bounded. Throws SerialError when the port is gone, and DeviceError naming the first
/// silent or refusing device when the retries are used up. Used by one thread.
class Bus {
 public:
  explicit Bus(BusOptions options) : options_(std::move(options)) {}

  void open();
  void close() noexcept { port_.reset(); }
  [[nodiscard]] bool is_open() const noexcept { return port_.has_value(); }
  /// Of the open port.
  [[nodiscard]] int fd() const { return port_.value().fd(); }
  [[nodiscard]] const std::string& path() const noexcept { return options_.port; }
  [[nodiscard]] std::string name_of(std::uint8_t id) const;

  /// An instruction that nobody answers.
  void tell(const Packet& instruction);
  /// An instruction to one device, and its answer with `data_bytes` of data.
  Status ask(const Packet& instruction, std::size_t data_bytes);
  /// The same once and no more; none if the device is silent.
  std::optional<Status> ask_once(const Packet& instruction, std::size_t data_bytes);
  /// A region of several devices: their answers in the order of `ids`.
  std::vector<Status> read_all(Region region, const std::vector<std::uint8_t>& ids,
                               SyncReadKind kind);

  /// The last instruction was sent at.
  [[nodiscard]] serial::Deadline told_at() const noexcept { return told_at_; }
  [[nodiscard]] const BusCounters& counters() const noexcept { return counters_; }
  [[nodiscard]] const ParserCounters& parser_counters() const noexcept {
    return parser_.counters();
  }

 private:
  /// Until it is complete; throws after the last attempt.
  void put(Question& question);
  bool attempt(Question& question);
  void listen(Question& question, serial::Deadline deadline);
  void take(const Packet& packet, Question& question);
  void wait_out_late_answers();
  [[nodiscard]] serial::Clock::duration time_of(std::size_t bytes) const;
  [[nodiscard]] DeviceError error(const Question& question, std::uint64_t faults) const;
  [[nodiscard]] serial::SerialPort& port();

  BusOptions options_;
  std::optional<serial::SerialPort> port_;
  Parser parser_;
  BusCounters counters_;
  serial::Deadline told_at_;
  serial::Deadline late_until_;  ///< answers to a question that was given up may come until then
};

}  // namespace scarab::bridge::dynamixel
