#pragma once

#include "common/bus/participant.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"
#include "tests/interop/domain_claim.hpp"

namespace scarab::test {

/// A participant of the test on the domain, which says a word on scarab/operator: nobody else does
/// in a trial that needs no operator.
class Bystander {
 public:
  explicit Bystander(const DomainClaim& claim)
      : participant_(options_on(claim)), operators_(participant_, bus::kOperator) {
    scarab_Operator word{};
    word.header.stamp_ns = 1;  // far too old to be obeyed
    word.command = scarab_OPERATOR_MODE;
    word.mode = scarab_MODE_BOXING;
    word.inputs[3] = -0.1;
    bus::assign(word.strategy, "soft+hard");
    bus::assign(word.reason, "\"käfer\" \\ \n");
    operators_.write(word);
  }

  [[nodiscard]] bus::Participant& participant() { return participant_; }

 private:
  static bus::ParticipantOptions options_on(const DomainClaim& claim) {
    bus::ParticipantOptions options;
    options.domain = claim.domain();
    return options;
  }

  bus::Participant participant_;
  bus::Writer<scarab_Operator> operators_;
};

}  // namespace scarab::test
