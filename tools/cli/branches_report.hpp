#pragma once

#include "higherpair/analysis/branches.hpp"
#include "higherpair/contact/certify.hpp"
#include "higherpair/contact/conic_contacts.hpp"
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace higherpair::cli {

/// One contact in the profile's units.
struct ContactEntry {
  double position = 0;
  double x = 0;
  double y = 0;
  double normal = 0;
  bool opposed = false;
  bool free = false;
  std::string remark;
  std::optional<std::array<double, 2>> certified;  ///< interval of the position
};

/// All positions of one follower.
struct ContactReport {
  std::string contact;
  std::string joint;
  std::string position_unit;
  std::vector<ContactEntry> entries;
  std::string note;         ///< why there is no list, or empty
  std::string certificate;  ///< what was certified; empty: not asked for
};

struct BranchesReport {
  std::string title;
  std::string length_unit;
  std::string angle_unit;
  std::string drivers;  ///< in words
  double driver = 0;
  std::vector<ContactReport> contacts;
  std::vector<std::string> joints;
  std::vector<std::string> joint_units;
  std::vector<std::vector<double>> assemblies;
  bool complete = true;
  bool certified = false;
};

/// The assemblies; contacts are to be added.
[[nodiscard]] BranchesReport report_on(const Profile& profile, const DriverSchedule& schedule,
                                       const Branches& branches);

/// The positions of one follower.
[[nodiscard]] ContactReport report_on(const Profile& profile, const ContactPlace& place,
                                      const CurveContacts& found);

/// Adds what was certified of them.
void add_certificate(const Certificate& certificate, const CurveContacts& found, const Profile& profile,
                     const ContactPlace& place, ContactReport& report);

/// The report as readable text, as CSV (contacts only), and as JSON.
[[nodiscard]] std::string branches_text(const BranchesReport& report);
[[nodiscard]] std::string branches_csv(const BranchesReport& report);
[[nodiscard]] nlohmann::ordered_json branches_json(const BranchesReport& report);

}  // namespace higherpair::cli
