#include "higherpair/dynamics/preload.hpp"

#include "higherpair/dynamics/contact_forces.hpp"
#include "higherpair/numeric/contains.hpp"
#include "higherpair/numeric/special_values.hpp"
#include "least_sum.hpp"
#include "numeric/chebyshev.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace higherpair {
namespace {

// Exchanges take up to five; this many end those that rounding keeps from settling.
constexpr int kMostExchanges = 200;

// The columns at the position where a weighted force is furthest below 0; none if it is nowhere negative
// beyond rounding.
std::optional<std::vector<double>> worst_place(const ContactForces& forces, std::size_t contact,
                                               const std::vector<double>& weights) {
  const ForcePiece* worst = nullptr;
  LowestValue lowest;  // of force + tolerance
  for (const ForcePiece& piece : forces.pieces) {
    if (!piece.known[contact]) {
      continue;
    }
    ForceSeries force = weighted_force(piece, contact, weights);
    double parts = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const ForceSeries& column = piece.columns[contact * weights.size() + i];
      parts += std::abs(weights[i]) * bound_of(column);
    }
    force[0] += piece.noise + kSumRounding * parts;
    const double before = lowest.value;
    find_lower(force, kLowestForce * parts, lowest);
    worst = lowest.value < before ? &piece : worst;
  }
  if (worst == nullptr) {
    return std::nullopt;
  }
  std::vector<double> columns;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    columns.push_back(value_at(worst->columns[contact * weights.size() + i], lowest.t));
  }
  return columns;
}

// Largest absolute value of a column.
double largest_of(const ContactForces& forces, std::size_t column) {
  double largest = 0;
  for (const ForcePiece& piece : forces.pieces) {
    for (std::size_t i = column; i < piece.columns.size(); i += ForcePiece::kParts + forces.preloads.size()) {
      largest = std::max(largest, bound_of(piece.columns[i]));
    }
  }
  return largest;
}

// Whether a contact force, extrapolated with its slope, falls below 0 towards a singular position.
bool opens_at_singular(const ContactForces& forces, std::size_t contact, const std::vector<double>& weights) {
  return std::any_of(forces.pieces.begin(), forces.pieces.end(), [&](const ForcePiece& piece) {
    if (!piece.known[contact] || !(piece.singular_from || piece.singular_to)) {
      return false;
    }
    const ForceSeries force = weighted_force(piece, contact, weights);
    const ForceSeries slope = derivative(force);
    // What is left out is about as long as the piece next to it: 2 in t.
    const auto falls = [&](double end) {
      return value_at(force, end) + 2 * end * value_at(slope, end) <
             -piece.noise - kSumRounding * bound_of(force);
    };
    return (piece.singular_from && falls(-1)) || (piece.singular_to && falls(1));
  });
}

bool opens_at_singular(const ContactForces& forces, const std::vector<double>& weights) {
  for (std::size_t contact = 0; contact < forces.lowest.size(); ++contact) {
    if (opens_at_singular(forces, contact, weights)) {
      return true;
    }
  }
  return false;
}

struct ForceTerms {
  double most = kInf;  // largest possible preload
  double weight = 1;   // weight in the sum
  double nothing = 0;  // contributions to a contact force up to this are rounding
};

ForceTerms terms_of(const Preload& preload, const Mechanism& mechanism, double size) {
  const auto index = static_cast<std::size_t>(preload.index);
  const bool on_spring = preload.on == Preload::On::kSpring;
  const Spring* spring = on_spring ? &mechanism.springs[index] : nullptr;
  if (spring != nullptr && !spring->joint) {
    return {spring->stiffness * spring->free, 1, 0};  // at a free length of 0
  }
  const auto joint = on_spring ? static_cast<std::size_t>(*spring->joint) : index;
  return {kInf, has_angle(mechanism.joints[joint].type) ? 1 / size : 1, 0};
}

// Finds the smallest preloads, of those in `used`, by an exchange method: solves a linear programme, adds the
// worst position of every contact that opens as a condition, and repeats until none opens.
class Exchange {
public:
  Exchange(const ContactForces& forces, const std::vector<ForceTerms>& terms,
           const std::vector<std::size_t>& used, const PreloadRounding* rounding)
      : forces_(forces),
        terms_(terms),
        used_(used),
        rounding_(rounding),
        weights_(ForcePiece::kParts + terms.size(), 0) {
    std::fill_n(weights_.begin(), ForcePiece::kParts, 1);
    for (const std::size_t k : used) {
      programme_.weights.push_back(terms[k].weight);
    }
    for (std::size_t j = 0; j < used.size(); ++j) {
      if (std::isfinite(terms[used[j]].most)) {
        LeastSum::Condition bound{std::vector<double>(used.size(), 0), -terms[used[j]].most};
        bound.coefficients[j] = -1;
        bound.at_least += margin(used[j]);
        programme_.conditions.push_back(bound);
      }
    }
  }

  /// One for each of forces.preloads. None where no preloads keep all contacts closed, where a contact falls
  /// open towards a singular position, at which no condition can be set, and where exchanges do not settle.
  [[nodiscard]] std::optional<std::vector<double>> run() {
    for (int i = 0; i < kMostExchanges; ++i) {
      const auto solution = solve(programme_);
      if (!solution) {
        return std::nullopt;
      }
      for (std::size_t j = 0; j < used_.size(); ++j) {
        const double x = (*solution)[j];
        weights_[ForcePiece::kParts + used_[j]] = rounding_ != nullptr ? rounding_->round(used_[j], x) : x;
      }
      if (!add_conditions()) {
        return opens_at_singular(forces_, weights_)
                   ? std::nullopt
                   : std::optional<std::vector<double>>(
                         {weights_.begin() + ForcePiece::kParts, weights_.end()});
      }
    }
    return std::nullopt;
  }

private:
  [[nodiscard]] double margin(std::size_t preload) const {
    return rounding_ != nullptr ? rounding_->margin[preload] : 0;
  }

  // Adds the worst position of every contact that opens; false if none does.
  bool add_conditions() {
    bool opens = false;
    for (std::size_t contact = 0; contact < forces_.lowest.size(); ++contact) {
      if (const auto worst = worst_place(forces_, contact, weights_)) {
        programme_.conditions.push_back(condition_at(*worst));
        opens = true;
      }
    }
    return opens;
  }

  // That a contact does not open at a position. \param columns  of its force there
  [[nodiscard]] LeastSum::Condition condition_at(const std::vector<double>& columns) const {
    LeastSum::Condition condition;
    for (std::size_t part = 0; part < ForcePiece::kParts; ++part) {
      condition.at_least -= columns[part];
    }
    for (const std::size_t k : used_) {
      const double added = columns[ForcePiece::kParts + k];
      const double column = std::abs(added) > terms_[k].nothing ? added : 0;
      condition.coefficients.push_back(column);
      condition.at_least += margin(k) * std::abs(column);
    }
    return condition;
  }

  const ContactForces& forces_;
  const std::vector<ForceTerms>& terms_;
  const std::vector<std::size_t>& used_;
  const PreloadRounding* rounding_;
  std::vector<double> weights_;
  LeastSum programme_;
};

}  // namespace

std::vector<Preload> preloads_of(const Mechanism& mechanism, const Plan& plan) {
  std::vector<Preload> preloads;
  for (std::size_t i = 0; i < mechanism.springs.size(); ++i) {
    if (mechanism.springs[i].stiffness > 0) {
      preloads.push_back({Preload::On::kSpring, static_cast<int>(i)});
    }
  }
  if (!preloads.empty()) {
    return preloads;
  }
  for (const Group& group : plan.groups) {
    for (const int index : group.joints) {
      const Joint& joint = mechanism.joints[index];
      const bool carries =
          !contains(group.bodies, joint.first.body) || !contains(group.bodies, joint.second.body);
      if (!group.contacts.empty() && group.drivers.empty() && carries && can_be_driven(joint.type)) {
        preloads.push_back({Preload::On::kJoint, index});
      }
    }
  }
  return preloads;
}

std::optional<std::vector<double>> smallest_preloads(const ContactForces& forces, const Mechanism& mechanism,
                                                     double size, const PreloadRounding* rounding) {
  std::vector<ForceTerms> terms;
  std::vector<std::size_t> all;
  for (const Preload& preload : forces.preloads) {
    all.push_back(terms.size());
    terms.push_back(terms_of(preload, mechanism, size));
    terms.back().nothing = kSumRounding * largest_of(forces, ForcePiece::kParts + terms.size() - 1);
  }
  std::optional<std::vector<double>> best;
  double least = kInf;
  const auto try_with = [&](const std::vector<std::size_t>& used) {
    return Exchange(forces, terms, used, rounding).run();
  };
  for (const std::size_t k : all) {
    auto single = try_with({k});
    if (single && std::abs((*single)[k]) * terms[k].weight < least) {
      least = std::abs((*single)[k]) * terms[k].weight;
      best = std::move(single);
    }
  }
  return best || all.size() < 2 ? best : try_with(all);
}

std::optional<double> highest_speed(const ContactForces& forces) {
  std::vector<double> weights(ForcePiece::kParts + forces.preloads.size(), 0);
  weights[0] = 1;
  for (std::size_t contact = 0; contact < forces.lowest.size(); ++contact) {
    if (worst_place(forces, contact, weights)) {
      return 0;  // opens at rest
    }
  }
  if (!forces.complete || forces.pieces.empty() || largest_of(forces, 1) > 0) {
    return std::nullopt;
  }
  weights[0] = 0;
  weights[2] = 1;  // at infinite speed only inertia counts
  for (std::size_t contact = 0; contact < forces.lowest.size(); ++contact) {
    int exchanges = 0;
    while (const auto worst = worst_place(forces, contact, weights)) {
      const double rest = (*worst)[0], inertia = (*worst)[2];
      if (!(rest > 0)) {
        return 0;  // nothing presses the contact together there
      }
      if (++exchanges > kMostExchanges || !(inertia < 0)) {
        return std::nullopt;
      }
      weights[0] = 1;
      weights[2] = -rest / inertia;
    }
  }
  if (weights[0] != 0 && opens_at_singular(forces, weights)) {
    return std::nullopt;
  }
  return weights[0] == 0 ? kInf : std::sqrt(weights[2]);
}

}  // namespace higherpair
