#include "services/robot_bridge/drivers/dynamixel/bus.hpp"

#include <array>
#include <chrono>

namespace scarab::bridge::dynamixel {
namespace {

using serial::Clock;
using serial::Deadline;

constexpr double kBitsPerByte = 10;  // 8N1: a start and a stop bit

Clock::duration seconds(double s) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
}

std::uint64_t faults_in(const ParserCounters& c) {
  return c.crc_errors + c.length_errors + c.stuffing_errors + c.cut_short;
}

}  // namespace

void Bus::open() {
  port_.emplace(options_.port, options_.baud);
  parser_.reset();
  late_until_ = {};
}

std::string Bus::name_of(std::uint8_t id) const {
  const auto found = options_.names.find(id);
  const std::string number = "ID " + std::to_string(static_cast<int>(id));
  return found == options_.names.end() ? number : found->second + " (" + number + ")";
}

void Bus::tell(const Packet& instruction) {
  const Bytes frame = encode(instruction);
  told_at_ = Clock::now();
  port().write(frame, told_at_ + time_of(frame.size()) + seconds(options_.reply_timeout_s));
}

Status Bus::ask(const Packet& instruction, std::size_t data_bytes) {
  Question question(instruction, data_bytes);
  put(question);
  return question.answers().front();
}

std::optional<Status> Bus::ask_once(const Packet& instruction, std::size_t data_bytes) {
  Question question(instruction, data_bytes);
  wait_out_late_answers();
  ++counters_.exchanges;
  if (!attempt(question)) return std::nullopt;
  return question.answers().front();
}

std::vector<Status> Bus::read_all(Region region, const std::vector<std::uint8_t>& ids,
                                  SyncReadKind kind) {
  Question question(region, ids, kind);
  put(question);
  return question.answers();
}

void Bus::put(Question& question) {
  wait_out_late_answers();
  ++counters_.exchanges;
  const std::uint64_t faults_before = faults_in(parser_.counters());
  for (unsigned retry = 0; retry <= options_.retries; ++retry) {
    if (retry > 0) ++counters_.retries;
    if (attempt(question)) return;
  }
  throw error(question, faults_in(parser_.counters()) - faults_before);
}

bool Bus::attempt(Question& question) {
  port().discard_input();
  parser_.reset();
  question.begin_attempt();
  const Packet instruction = question.instruction();
  tell(instruction);
  const std::size_t bytes = encode(instruction).size() + question.answer_bytes();
  const Deadline deadline = told_at_ + time_of(bytes) + seconds(options_.reply_timeout_s);
  listen(question, deadline);
  if (question.complete()) return true;
  if (Clock::now() >= deadline) {
    ++counters_.timeouts;
    late_until_ = deadline + seconds(options_.reply_timeout_s);
  }
  return false;
}

void Bus::listen(Question& question, Deadline deadline) {
  const std::size_t wanted = question.answer_bytes();
  const std::uint64_t faults_before = faults_in(parser_.counters());
  std::array<std::uint8_t, kMaxFrameBytes> chunk{};
  std::vector<Packet> packets;
  std::size_t received = 0;
  while (!question.over()) {
    // What came in full and does not fit is not waited for any longer.
    const bool broken = faults_in(parser_.counters()) != faults_before;
    if (broken && received >= wanted && parser_.pending().empty()) return;
    const std::size_t size = port().read_some(chunk, deadline);
    if (size == 0) return;
    received += size;
    counters_.bytes_received += size;
    packets.clear();
    parser_.feed({chunk.data(), size}, packets);
    for (const Packet& packet : packets) take(packet, question);
  }
}

void Bus::take(const Packet& packet, Question& question) {
  if (!packet.is_status()) {
    ++counters_.echoes;
  } else if (!question.take(packet)) {
    ++counters_.wrong_answers;
  } else if (question.refusal()) {
    ++counters_.refusals;
  }
}

/// The protocol does not number its questions: an answer that comes after all to one that was given
/// up could be taken for that to the next one.
void Bus::wait_out_late_answers() {
  std::array<std::uint8_t, kMaxFrameBytes> late{};
  while (Clock::now() < late_until_) {
    const std::size_t size = port().read_some(late, late_until_);
    counters_.bytes_received += size;
    counters_.bytes_late += size;
  }
}

Clock::duration Bus::time_of(std::size_t bytes) const {
  return seconds(kBitsPerByte * static_cast<double>(bytes) / options_.baud);
}

DeviceError Bus::error(const Question& question, std::uint64_t faults) const {
  const std::string attempts = " (attempts: " + std::to_string(options_.retries + 1) + ")";
  if (const auto& refusal = question.refusal()) {
    return DeviceError(path() + ": " + name_of(refusal->id) + " refuses instruction " +
                       std::to_string(static_cast<int>(question.instruction().instruction)) + ": " +
                       dynamixel::name_of(refusal->error));
  }
  const Question::Silence silence = question.silence(parser_.pending(), faults > 0);
  const std::string who = name_of(silence.first);
  if (silence.broken) {
    return DeviceError(path() + ": answers arrive broken, first that of " + who + attempts);
  }
  if (silence.of_all) {
    return DeviceError(path() + ": nobody answers, first asked was " + who + attempts);
  }
  return DeviceError(path() + ": " + who + " does not answer" + attempts);
}

serial::SerialPort& Bus::port() {
  if (!port_) throw DeviceError(path() + " is not open");
  return *port_;
}

}  // namespace scarab::bridge::dynamixel
