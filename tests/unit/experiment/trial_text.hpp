#pragma once

#include <string>

namespace scarab::experiment {

/// A trial line as a dispatcher writes it, and its parts to break.
inline std::string trial_text() {
  return R"({"index": 7, "strategy": "soft+hard", "goal": "across", "height_m": 0.1, )"
         R"("distance_m": 1.46, "time_limit_s": 60.0, "seed": 1000001, )"
         R"("perturb_position_m": 0.02, "perturb_yaw_rad": 0.05235987755982988, )"
         R"("perturb_friction": 0.1, "perturb_cpg_phase": true, "friction_scale": 1.0, )"
         R"("object_mass_kg": 2.5, "object_diameter_m": 0.0})";
}

/// The same with `from`, which is in it, replaced by `to`.
inline std::string trial_text_with(const std::string& from, const std::string& to) {
  std::string text = trial_text();
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace scarab::experiment
