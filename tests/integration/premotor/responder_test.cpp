#include "tests/integration/premotor/premotor_questions.hpp"
#include "tests/integration/responder/suite.hpp"

namespace scarab::test {

INSTANTIATE_TYPED_TEST_SUITE_P(Premotor, Responder, Premotor);

}  // namespace scarab::test
