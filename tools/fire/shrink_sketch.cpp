#include "shrink_sketch.hpp"

#include "round_numbers.hpp"

#include <optional>

namespace higherpair::fire {
namespace {

// The mechanism without some bodies and everything joined to them; none if a driver would be lost.
std::optional<Sketch> without(const Sketch& sketch, int first, int last) {
  const auto gone = [&](int body) { return body >= first && body <= last; };
  const auto renumber = [&](int& body) { body -= body > last ? last - first + 1 : 0; };
  Sketch rest = sketch;
  rest.bodies.erase(rest.bodies.begin() + first, rest.bodies.begin() + last + 1);
  rest.joints.clear();
  std::vector<int> places;  // new indices of the joints; -1: removed
  for (const Sketch::Joint& joint : sketch.joints) {
    const bool coupled = joint.kind == Sketch::JointKind::kGears || joint.kind == Sketch::JointKind::kBelt;
    const bool stays =
        !gone(joint.first.body) && !gone(joint.second.body) && !(coupled && gone(joint.carrier));
    places.push_back(stays ? static_cast<int>(rest.joints.size()) : -1);
    if (stays) {
      rest.joints.push_back(joint);
      renumber(rest.joints.back().first.body);
      renumber(rest.joints.back().second.body);
      renumber(rest.joints.back().carrier);
    }
  }
  rest.contacts.clear();
  for (Sketch::Contact contact : sketch.contacts) {
    if (!gone(contact.first.body) && !gone(contact.second.body)) {
      renumber(contact.first.body);
      renumber(contact.second.body);
      rest.contacts.push_back(contact);
    }
  }
  for (Sketch::Driver& driver : rest.drivers) {
    driver.joint = places[driver.joint];
    if (driver.joint < 0) {
      return std::nullopt;
    }
  }
  return rest;
}

}  // namespace

Sketch shrink(Sketch sketch, const std::function<bool(const Sketch&)>& fails) {
  const auto keep = [&](const Sketch& smaller) {
    const bool still = fails(smaller);
    sketch = still ? smaller : sketch;
    return still;
  };
  // Bodies of a group are consecutive; the largest groups have six.
  for (int count = 6; count > 0; --count) {
    for (int first = static_cast<int>(sketch.bodies.size()) - count; first > 0; --first) {
      const int last = first + count - 1;
      const auto smaller =
          last < static_cast<int>(sketch.bodies.size()) ? without(sketch, first, last) : std::nullopt;
      if (smaller) {
        keep(*smaller);
      }
    }
  }
  round_numbers(sketch, 6, keep);
  return sketch;
}

}  // namespace higherpair::fire
