// A step takes no memory: what it needs is kept from step to step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>
#include <vector>

#include "tests/unit/plant/rig.hpp"

namespace {

std::size_t taken = 0;  // calls of operator new

void* take(std::size_t size) {
  ++taken;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

namespace scarab::plant {
namespace {

/// The robot waves its legs at an object right behind it; of every step, how often it took memory.
TEST(Step, TakesNoMemory) {
  PlantConfig config = testing::default_config();
  config.object.start_distance_m = 0.34;
  testing::Rig rig(testing::beetle(), config);
  const robot::JointVector stance = rig.targets;
  std::vector<std::size_t> steps_that_took;
  steps_that_took.reserve(1000);
  std::size_t contacts_most = 0;
  for (std::size_t step = 0; step < 1000; ++step) {
    for (std::size_t j = 0; j < robot::kJointCount; ++j) {
      rig.targets[j] = stance[j] + 0.4 * std::sin(0.01 * static_cast<double>(step * (j + 1)));
    }
    const std::size_t before = taken;
    rig.step(0.002);
    if (taken != before) steps_that_took.push_back(step);
    contacts_most = std::max(contacts_most, rig.stepper.contacts().size());
  }
  EXPECT_GT(taken, 0U) << "the scene itself needs memory, and it is counted";
  EXPECT_GT(contacts_most, 8U) << "legs must have met ground and object";
  // Simbody may, in the steps that are held against it.
  for (const std::size_t step : steps_that_took) EXPECT_EQ(step % 500, 0U) << step;
}

}  // namespace
}  // namespace scarab::plant
