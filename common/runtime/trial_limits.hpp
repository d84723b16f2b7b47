#pragma once

/// What a trial may ask for, whoever says it: the command line, or a trial line of a worker.
namespace scarab::runtime {

/// Both ends belong to it.
struct Limits {
  double low = 0;
  double high = 0;
};

inline constexpr Limits kHeightLimitsM{0, 0.5};
inline constexpr Limits kDistanceLimitsM{0.01, 10};
inline constexpr Limits kTimeLimitsS{0.1, 36000};
inline constexpr Limits kPerturbPositionLimitsM{0, 0.2};
inline constexpr Limits kPerturbYawLimitsRad{0, 3.1415926535897932};
inline constexpr Limits kPerturbFrictionLimits{0, 0.9};
inline constexpr Limits kFrictionScaleLimits{0.01, 10};
inline constexpr Limits kObjectMassLimitsKg{0, 100};   ///< 0: as configured
inline constexpr Limits kObjectDiameterLimitsM{0, 1};  ///< 0: as configured

}  // namespace scarab::runtime
