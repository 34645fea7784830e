#include "outlook.hpp"

#include "analysis/tolerances.hpp"
#include "higherpair/contact/step_length.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// Whether more may be placeable between two positions than at both: at the better one it increases inwards.
bool has_hill(const Outlook& a, const Outlook& b) {
  return a.placing < b.placing ? b.rises < 0 : a.rises > 0;
}

// Upper estimate of a hill between two positions. A concave hill lies below its tangents at both ends; twice
// their height over the ends is allowed for one that is not quite concave. +inf if different conditions fail.
double highest_between(const Outlook& a, const Outlook& b) {
  if (a.placing.conditions != b.placing.conditions || !std::isfinite(a.slope + b.slope)) {
    return kInf;
  }
  const double w = b.x - a.x;
  const double from_a = a.placing.room + std::max(a.slope * w, 0.0);
  const double from_b = b.placing.room + std::max(-b.slope * w, 0.0);
  const double share = (b.placing.room - a.placing.room - b.slope * w) / ((a.slope - b.slope) * w);
  const bool both = a.rises > 0 && b.rises < 0;
  const double top = both ? a.placing.room + a.slope * w * share : std::min(from_a, from_b);
  return 2 * top - std::max(a.placing.room, b.placing.room);
}

// Ranges that are shorter than this, or that the driver does not resolve, are not divided.
double shortest_stretch(const LineAhead& line, double x) {
  return std::max(kShortestStretch * line.scale(), shortest_step(line.scale(), x));
}

// Climbs a hill between two positions at which the branch cannot be placed, until it can be placed.
std::optional<double> placed_on_hill(Run& run, const LineAhead& line, Outlook a, Outlook b) {
  const double shortest = shortest_stretch(line, a.x);
  while (has_hill(a, b) && std::abs(b.x - a.x) > shortest && highest_between(a, b) >= 0 && !is_stopped(run)) {
    const Outlook middle = outlook_at(run, line, (a.x + b.x) / 2, b.x - a.x);
    if (middle.placing.complete) {
      return middle.x;
    }
    (has_hill(a, middle) ? b : a) = middle;
  }
  return std::nullopt;
}

// The maximum, within the interval, of the cubic with the values and slopes at both ends, beyond a hollow or
// before one.
std::optional<double> top_of_cubic(const Outlook& a, const Outlook& b) {
  const double w = b.x - a.x;
  const double rise = b.placing.room - a.placing.room, at_a = a.slope * w, at_b = b.slope * w;
  const double c2 = 3 * rise - 2 * at_a - at_b, c3 = at_a + at_b - 2 * rise;
  const double root = std::sqrt(c2 * c2 - 3 * at_a * c3);
  const double share = c2 < 0 ? at_a / (root - c2) : -(c2 + root) / (3 * c3);
  return share > 0 && share < 1 ? std::optional(a.x + share * w) : std::nullopt;
}

// A position at which the branch can be placed, between two that are alike.
std::optional<double> placed_within(Run& run, const LineAhead& line, const Outlook& a, const Outlook& b) {
  if (has_hill(a, b)) {
    return placed_on_hill(run, line, a, b);
  }
  const auto top = top_of_cubic(a, b);
  if (!top) {
    return std::nullopt;
  }
  const Outlook there = outlook_at(run, line, *top, b.x - a.x);
  if (there.placing.complete) {
    return there.x;
  }
  const auto before = placed_on_hill(run, line, a, there);
  return before ? before : placed_on_hill(run, line, there, b);
}

// The contacts of the groups that are placed in run.work.trial.
std::vector<PlacedContact> placed_contacts(const Run& run, const Placeable& placing) {
  std::vector<PlacedContact> contacts;
  for (std::size_t g = 0; g < placing.conditions / 2; ++g) {
    for (const int contact : run.plan().groups[g].contacts) {
      const CommonNormal& at = run.work.trial.contacts[contact].at;
      contacts.push_back({at.p_W(), at.n_W});
    }
  }
  return contacts;
}

// Whether the same condition fails at two positions, with all contacts at the same places: at one that is
// found elsewhere, the rest of the mechanism is another one.
bool are_alike(const Run& run, const Outlook& a, const Outlook& b) {
  return a.placing.conditions == b.placing.conditions &&
         std::equal(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end(),
                    [&](const PlacedContact& one, const PlacedContact& other) {
                      return one.n_W.dot(other.n_W) >= kSameNormalPlace &&
                             (one.p_W - other.p_W).norm() <= kSameContactPlace * run.plan().size;
                    });
}

// The inputs on a line, to within the grid where bodies are coupled.
std::vector<double> inputs_near(const Run& run, const LineAhead& line, double x) {
  std::vector<double> inputs = line.at(x);
  if (!run.plan().couples) {
    return inputs;
  }
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    inputs[i] = i == line.leading() ? x : on_search_grid(inputs[i], input_scale(run, i));
  }
  return inputs;
}

}  // namespace

Outlook outlook_at(Run& run, const LineAhead& line, double x, double spacing) {
  const double nudge = kALittleAhead * spacing;
  const Placeable here = place_anew(run, inputs_near(run, line, x));
  if (here.complete || !std::isfinite(here.room)) {
    return {x, here, 0, kNoValue, {}};
  }
  std::vector<PlacedContact> contacts = placed_contacts(run, here);
  const Placeable ahead = place_anew(run, inputs_near(run, line, x + nudge));
  const bool alike = here.conditions == ahead.conditions && std::isfinite(ahead.room);
  const int rises = here < ahead ? 1 : ahead < here ? -1 : 0;
  return {x, here, rises, alike ? (ahead.room - here.room) / nudge : kNoValue, std::move(contacts)};
}

std::optional<double> placed_between(Run& run, const LineAhead& line, const Outlook& a, const Outlook& b) {
  if (are_alike(run, a, b)) {
    return placed_within(run, line, a, b);
  }
  const double shortest = shortest_stretch(line, a.x);
  Outlook low = a, high = b;
  while (std::abs(high.x - low.x) > shortest && !is_stopped(run)) {
    const Outlook middle = outlook_at(run, line, (low.x + high.x) / 2, high.x - low.x);
    if (middle.placing.complete) {
      return middle.x;
    }
    (are_alike(run, middle, low) ? low : high) = middle;
  }
  const auto before = placed_within(run, line, a, low);
  return before || high.placing.conditions != b.placing.conditions ? before
                                                                   : placed_within(run, line, high, b);
}

}  // namespace higherpair
