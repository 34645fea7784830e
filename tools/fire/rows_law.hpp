#pragma once

#include "higherpair/io/profile.hpp"
#include "trial.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace higherpair::fire {

/// One row of a run.
struct RowValues {
  int status = 0;             ///< a RowStatus
  bool rates = true;          ///< whether those of all bodies are defined
  std::vector<double> place;  ///< of all bodies: x, y [m], angle [rad]
  std::vector<double> velocity;
  std::vector<double> acceleration;
};

/// Something that happens between rows.
struct Happening {
  std::string type;
  std::string item;   ///< the joint or contact; empty: none
  double share = 0;   ///< of the whole path, of `step` of its time
  double driver = 0;  ///< coordinate of the first driver [rad or m]
};

/// A whole run of a profile, as `analyze` or `step` make it.
struct RunRecord {
  std::string not_started;  ///< why it cannot be started; empty: it was
  std::vector<RowValues> rows;
  std::vector<Happening> events;
};

/// The largest absolute value, and the largest difference of two lists (infinite with a NaN).
[[nodiscard]] double largest(const std::vector<double>& values);
[[nodiscard]] double difference(const std::vector<double>& a, const std::vector<double>& b);

/// \param timed  as `step` does, else as `analyze`
[[nodiscard]] RunRecord record_run(const Profile& profile, bool timed, std::int64_t samples);

/// The rows law: what a run says does not depend on how many rows it has. Runs the profile at 7, 61 and 601
/// rows and compares up to the first limit what each says of it, of the events before it and of the rows that
/// all of them have; then what comes behind it. A failure's law is the kind of disagreement.
[[nodiscard]] Failure rows_law(const Profile& profile, bool timed);

}  // namespace higherpair::fire
