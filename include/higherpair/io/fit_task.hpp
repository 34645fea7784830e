#pragma once

#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/profile.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

namespace higherpair {

class ProfileDocument;

/// How a residual counts, in units of the noise of its column.
enum class FitLoss {
  kSquares,  ///< by its square
  kHuber,    ///< by its square up to 1.345, beyond in proportion: for a few wrong values
  kTukey,    ///< by less and less beyond 1, from 4.685 on not at all: for many, far off
};

/// "squares", "huber", "tukey".
[[nodiscard]] const std::vector<std::string>& fit_loss_names();
[[nodiscard]] std::string_view name_of(FitLoss loss);

/// What [fit] of a profile says of the columns that were measured. Which numbers are unknown say the
/// variables of [design].
struct FitTask {
  /// [[fit.columns]]
  struct Column {
    std::string column;               ///< name or glob
    std::optional<double> deviation;  ///< standard deviation of its noise, in the unit of tables; none: found
    double weight = 1;                ///< how much its squares count
    bool offset = false;              ///< its zero is not known
    Place place;
    std::string path;  ///< "fit.columns.0"
  };
  /// [[fit.frames]]: a point whose path was measured in a frame of its own.
  struct Frame {
    std::string point;      ///< "coupler.E"
    bool position = false;  ///< whether the place of that frame is free,
    bool turn = false;      ///< its angle,
    bool scale = false;     ///< and its unit of length
    Place place;
    std::string path;
  };

  std::vector<Column> columns;
  std::vector<Frame> frames;
  std::vector<std::string> use;  ///< names or globs of the measured columns that count; empty: all
  FitLoss loss = FitLoss::kSquares;
  double confidence = 0.95;
  std::optional<int> starts;
  std::optional<std::uint64_t> seed;
  Place place;  ///< of [fit]; of the whole profile where there is none
};

/// [fit] of a profile that was read without a mistake; what holds without it where there is none.
[[nodiscard]] FitTask fit_task_of(const ProfileDocument& document, const Profile& profile);

}  // namespace higherpair
