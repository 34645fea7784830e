// The number of places at which two bodies touch along the path.
#include "check_parts.hpp"

#include <algorithm>

namespace higherpair {

std::optional<double> mean_of_places(std::size_t at_start, std::size_t contact,
                                     const std::vector<Event>& events) {
  double places = static_cast<double>(at_start);
  double sum = 0;  // of places times travel of the driver, since contact first began
  std::optional<double> first, last;
  double mean = 0, least = 0, most = 0;
  for (const Event& event : events) {
    const bool begins = event.type == EventType::kEngage;
    if (event.contact != static_cast<int>(contact) || !(begins || event.type == EventType::kRelease)) {
      continue;
    }
    const double at = event.driver_si;
    if (first) {
      sum += places * (at - *last);
      least = std::min(least, at - *last);
      most = std::max(most, at - *last);
    }
    places += begins ? 1 : -1;
    if (begins && !first) {
      first = at;
    } else if (begins) {
      mean = sum / (at - *first);
    }
    last = first ? std::optional(at) : std::nullopt;
  }
  const bool turns_back = least < 0 && most > 0;
  return mean > 0 && !turns_back ? std::optional(mean) : std::nullopt;
}

}  // namespace higherpair
