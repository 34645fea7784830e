#pragma once

#include "analysis_impl.hpp"
#include "higherpair/cam/flank.hpp"
#include "higherpair/dynamics/path_extremes.hpp"
#include "higherpair/front/check.hpp"
#include "higherpair/io/row_path.hpp"

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace higherpair {

/// Collects the figures of a report, in the profile's units, and remembers which limits found something.
class CheckFigures {
public:
  enum class Bound { kMost, kLeast };  ///< of the absolute value, of the value

  CheckFigures(const Profile& profile, const CheckLimits& limits, CheckReport& report)
      : profile_(profile), limits_(limits), report_(report) {}

  /// The item and the curve that the figures after this one are about.
  void about(std::string item, std::string of = "") {
    item_ = std::move(item);
    of_ = std::move(of);
  }
  /// \param value, driver  in SI units; none: without bounds, nowhere
  CheckFigure& add(const std::string& quantity, const Dimension& dimension, std::optional<double> value,
                   std::optional<double> driver, std::string remark = "");
  /// The same with a limit; null: it has none.
  CheckFigure& add(const std::string& quantity, const Dimension& dimension, std::optional<double> value,
                   std::optional<double> driver, const GivenLimit* limit, Bound bound);

  [[nodiscard]] const GivenLimit* of_contact(std::size_t contact, LimitKey key) const {
    return limit_of(limits_, limits_.contacts, contact, key);
  }
  [[nodiscard]] const GivenLimit* of_joint(std::size_t joint, LimitKey key) const {
    return limit_of(limits_, limits_.joints, joint, key);
  }
  [[nodiscard]] const GivenLimit* of_body(int body, LimitKey key) const {
    return limit_of(limits_, limits_.bodies, static_cast<std::size_t>(body), key);
  }
  void use(const GivenLimit* limit) { used_.insert(limit); }

  /// What happens on the path.
  [[nodiscard]] const std::vector<Event>& events() const { return report_.events; }

  /// A note for every limit that nothing in the mechanism has.
  void note_unused();

private:
  const Profile& profile_;
  const CheckLimits& limits_;
  CheckReport& report_;
  std::set<const GivenLimit*> used_;
  std::string item_, of_;
};

/// What is followed along the path for a check, and then read off.
struct CheckedPath {
  const Profile& profile;
  const DriverSchedule& schedule;
  const Run& start;
  const ContactForceReport* forces = nullptr;  ///< none where nothing presses or moves the bodies
};

/// The largest speed of a driver where the path begins, that of a slide relative to the mechanism's size
/// [1/s].
[[nodiscard]] double driver_rate(const CheckedPath& checked);

using PathRanges = std::vector<PathRange>;

inline constexpr Sought kGreatest = {false, true, 0};
inline constexpr Sought kLeast = {true, false, 0};
inline constexpr Sought kBoth = {true, true, 0};

/// The larger extreme by size, with its sign; of two that are the same but for rounding the first.
[[nodiscard]] std::optional<PathExtreme> peak_of(const PathRange& range);

/// Says of a figure that its extreme still grows towards a singular position.
void mark_growing(CheckFigure& figure, const PathExtreme& extreme);

/// \name Parts of a check: what each follows along the path, and how its figures are read off the ranges
/// @{
struct ContactCheck {
  PathQuantities quantities;
  std::function<void(const PathRanges&, CheckFigures&)> read;         ///< angles and speeds
  std::function<void(const PathRanges&, CheckFigures&)> read_curves;  ///< radii and faces
};
/// \param split  whether pressure angles of the return have a limit of their own
[[nodiscard]] ContactCheck contact_check(const CheckedPath& checked, std::size_t index, bool split);

/// The mean number of places at which the two bodies of a contact touch, from one beginning to touch to the
/// last: of gears their contact ratio. None where that happens once at most, or the driver turns back. \param
/// at_start  how many they are where the path begins
[[nodiscard]] std::optional<double> mean_of_places(std::size_t at_start, std::size_t contact,
                                                   const std::vector<Event>& events);

struct JointCheck {
  PathQuantities accelerations, jerks;
  std::function<void(const PathRanges& accelerations, const PathRanges& jerks, CheckFigures&)> read;
};
[[nodiscard]] JointCheck joint_check(const CheckedPath& checked);

struct ForceCheck {
  PathQuantities quantities;
  std::function<void(std::size_t contact, const PathRanges&, CheckFigures&)> read_contact;
  std::function<void(const PathRanges&, CheckFigures&)> read_drivers;
};
/// \pre checked.forces
[[nodiscard]] ForceCheck force_check(const CheckedPath& checked, const CheckFigures& figures);
/// @}

/// Figures of contacts, followers and drivers along the path.
void add_path_figures(const CheckedPath& checked, CheckFigures& figures);

/// Where a path is looked at more closely than elsewhere: the breaks of the laws of flanks, and the
/// parts of boundaries.
[[nodiscard]] PathLook look_at(const CheckedPath& checked, const DriverPath& path);

/// Sizes of the flanks that laws have shaped.
void add_size_figures(const Profile& profile, CheckFigures& figures);

/// The flank that a curve is; none of other curves.
[[nodiscard]] std::optional<FlankOrigin> flank_of(const Mechanism& mechanism, const CurveRef& ref);

/// "cam.flank": the curve that the file names, also of a contact's own copy.
[[nodiscard]] const NamedCurve& named_curve(const Mechanism& mechanism, const CurveRef& ref);
[[nodiscard]] std::string name_of_curve(const Mechanism& mechanism, const CurveRef& ref);

}  // namespace higherpair
