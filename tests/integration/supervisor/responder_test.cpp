#include "tests/integration/responder/suite.hpp"
#include "tests/integration/supervisor/supervisor_questions.hpp"

namespace scarab::test {

INSTANTIATE_TYPED_TEST_SUITE_P(Supervisor, Responder, Supervisor);

}  // namespace scarab::test
