#pragma once

#include "front/analysis_impl.hpp"
#include "higherpair/cam/flank.hpp"
#include "higherpair/dynamics/path_extremes.hpp"
#include "higherpair/front/check.hpp"
#include "higherpair/io/row_path.hpp"

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace higherpair {

/// Collects the figures of a report, in the profile's units, and remembers which limits applied to something.
class CheckFigures {
public:
  enum class Bound { kMost, kLeast };  ///< upper bound of the absolute value, lower bound of the value

  CheckFigures(const Profile& profile, const CheckLimits& limits, CheckReport& report)
      : profile_(profile), limits_(limits), report_(report) {}

  /// Sets the item and the curve to which the next figures belong.
  void about(std::string item, std::string of = "") {
    item_ = std::move(item);
    of_ = std::move(of);
  }
  /// \param value, driver  in SI units; without them: unbounded, at no particular place
  CheckFigure& add(const std::string& quantity, const Dimension& dimension, std::optional<double> value,
                   std::optional<double> driver, std::string remark = "");
  /// The same with a limit, which may be null.
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

  /// A position of the first driver [rad or m] in the profile's unit: "12.5 deg".
  [[nodiscard]] std::string place(double driver) const;

  /// The events on the path.
  [[nodiscard]] const std::vector<Event>& events() const { return report_.events; }

  /// Adds a note for every limit that applies to nothing in the mechanism.
  void note_unused();

private:
  const Profile& profile_;
  const CheckLimits& limits_;
  CheckReport& report_;
  std::set<const GivenLimit*> used_;
  std::string item_, of_;
};

/// What is followed along the path for a check and evaluated afterwards.
struct CheckedPath {
  const Profile& profile;
  const DriverSchedule& schedule;
  const Run& start;
  const ContactForceReport* forces = nullptr;  ///< null without masses, loads and springs
};

using PathRanges = std::vector<PathRange>;

inline constexpr Sought kGreatest = {false, true, 0};
inline constexpr Sought kLeast = {true, false, 0};
inline constexpr Sought kBoth = {true, true, 0};

/// The extreme of larger absolute value, with its sign; if both are equal to within rounding, the first on
/// the path.
[[nodiscard]] std::optional<PathExtreme> peak_of(const PathRange& range);

/// Remarks on a figure that its extreme still grows towards a singular position, or that the quantity goes on
/// beyond it towards another one, and takes back that it keeps its limit.
/// \param bound  kLeast: a figure that falls where its extreme grows
void mark_growing(CheckFigure& figure, const PathExtreme& extreme, const CheckFigures& figures,
                  CheckFigures::Bound bound = CheckFigures::Bound::kMost);

/// The same for a figure that is the peak_of() a range, and may grow with the other sign as well.
void mark_growing(CheckFigure& figure, const PathRange& range, const CheckFigures& figures);

/// Adds such a figure, by size and with its sign, if there is one. \param limit  may be null
void add_peak(const std::string& quantity, const Dimension& dimension, const PathRange& range,
              const GivenLimit* limit, CheckFigures& figures);

/// The same for a figure that is not at the place of the extreme. \param how  it grows: "with the other sign
/// it" \param least  what goes on beyond the extreme, but not beyond this size, does not count
void mark_growing_elsewhere(CheckFigure& figure, const PathExtreme& extreme, const CheckFigures& figures,
                            std::string_view how, double least = 0);

/// \name Parts of a check: what each follows along the path, and how it makes figures of the ranges found
/// @{
struct ContactCheck {
  PathQuantities quantities;
  std::function<void(const PathRanges&, CheckFigures&)> read;         ///< angles and speeds
  std::function<void(const PathRanges&, CheckFigures&)> read_curves;  ///< radii and faces
};
/// \param split  whether pressure angles of the return stroke have a limit of their own
[[nodiscard]] ContactCheck contact_check(const CheckedPath& checked, std::size_t index, bool split);

/// The mean number of places at which the two bodies of a contact touch, from the first beginning of contact
/// to the last: for gears, the contact ratio. None where contact begins at most once, or the driver turns
/// back. \param at_start  number of these places at the beginning of the path
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
/// \return the parameter of path_of(checked.schedule) up to which a path is examined that is too long; else
/// none
std::optional<double> add_path_figures(const CheckedPath& checked, CheckFigures& figures);

/// The event of a path that is examined only up to this parameter of path_of(schedule).
[[nodiscard]] Event end_of_examination(const Profile& profile, const DriverSchedule& schedule, double end);

/// Where the driven cams of a straight path come to the breaks of the laws that shaped them: ascending
/// parameters.
[[nodiscard]] std::vector<double> known_breaks(const CheckedPath& checked, const DriverPath& path);

/// Size figures of the flanks that are generated by laws.
void add_size_figures(const Profile& profile, CheckFigures& figures);

/// How a flank was generated; none for other curves.
[[nodiscard]] std::optional<FlankOrigin> flank_of(const Mechanism& mechanism, const CurveRef& ref);

/// The curve as named in the file, such as "cam.flank", also for a contact's own copy.
[[nodiscard]] const NamedCurve& named_curve(const Mechanism& mechanism, const CurveRef& ref);
[[nodiscard]] std::string name_of_curve(const Mechanism& mechanism, const CurveRef& ref);

}  // namespace higherpair
