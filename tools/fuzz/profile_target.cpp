// Any text is read as a profile or refused with at least one message. A profile that is read is a valid
// mechanism, with a schedule or a message why it has none.
#include "higherpair/io/driver_schedule.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "target.hpp"

#include <cstdlib>
#include <string_view>

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace higherpair;
  const auto profile = read_profile_text({reinterpret_cast<const char*>(data), size}, "fuzz");
  if (!profile) {
    if (profile.error().empty() || to_string(profile.error().front()).empty()) {
      std::abort();
    }
    return 0;
  }
  const Mechanism& mechanism = profile->mechanism;
  if (mechanism.bodies.empty() || profile->programs.size() != mechanism.drivers.size()) {
    std::abort();
  }
  const auto schedule = DriverSchedule::analyze(*profile);
  if (!schedule && schedule.error().empty()) {
    std::abort();
  }
  return 0;
}
