#include "higherpair/contact/certify.hpp"

#include "contact/exact/exact_decision.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "tangency.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// Contacts that the list takes to be at infinity, such as those of parabolas whose axes are parallel but for
// rounding.
bool is_far(const TangencyProblem& problem, const Extended& q) {
  const Coordinate at = problem.motion.turns ? Coordinate{Extended(cos(q)), Extended(sin(q))}
                                             : Coordinate{Extended(q / problem.length), Extended(0)};
  return !has_finite_point(problem, at);
}

bool is_fragile(const CurveContact& contact) {
  return contact.at_limit || contact.conforming || contact.coincident;
}

double distance(const CurveContact& contact, const DecidedRoot& root, bool turns) {
  const double middle = (root.q[0] + root.q[1]) / 2;
  return std::abs(turns ? std::remainder(contact.q - middle, 2 * kPi) : contact.q - middle);
}

// How far rounding of the numbers of the pair can move a contact: its effect on the gap, divided by ∂gap/∂q.
double widening(const ContactPair& pair, const CurveContact& contact) {
  const Vector2d& p = contact.p_W;
  const double size = p.norm() + (p - pair.motion1.p_WO).norm() + (p - pair.motion2.p_WO).norm() +
                      anchor(pair.curve1).norm() + size_of(pair.curve1) + anchor(pair.curve2).norm() +
                      size_of(pair.curve2) + pair.motion1.p_BO.norm() + pair.motion2.p_BO.norm();
  return kInputRounding * size / std::abs(contact.n_W.dot(velocity_per_q(pair.motion2, p)));
}

std::array<double, 2> interval_of(const ContactPair& pair, const CurveContact& contact,
                                  const DecidedRoot& root) {
  const double middle = (root.q[0] + root.q[1]) / 2;
  const double turn = pair.motion2.turns ? nearest_turn(middle, contact.q) - middle : 0;
  const double margin = widening(pair, contact) + kTurnsRounding * std::abs(turn);
  return {root.q[0] + turn - margin, root.q[1] + turn + margin};
}

// Compares a list of contacts with the roots that exact arithmetic has decided.
class Comparison {
public:
  Comparison(const ContactPair& pair, double u, const std::vector<DecidedRoot>& roots)
      : pair_(pair), problem_(make_problem(pair, u)), roots_(roots), matched_(roots.size(), 0) {}

  // The interval of the root that a contact belongs to; none if no root agrees with it.
  [[nodiscard]] std::optional<std::array<double, 2>> certified(const CurveContact& contact) {
    const auto k = nearest_root(contact);
    if (!k) {
      return std::nullopt;
    }
    ++matched_[*k];
    const DecidedRoot& root = roots_[*k];
    agrees_ =
        agrees_ && (!root.decision.free || *root.decision.free == contact.free || is_crowded(contact, root));
    return interval_of(pair_, contact, root);
  }

  [[nodiscard]] bool agrees() const { return agrees_; }

  // Whether the list has as many contacts at every root as were decided, except next to fragile ones, in
  // degenerate cases and at infinity.
  [[nodiscard]] bool accounts_for_all(const std::vector<CurveContact>& contacts) const {
    for (std::size_t k = 0; k < roots_.size(); ++k) {
      const DecidedRoot& root = roots_[k];
      const double fragile_by = root.multiplicity >= 4 ? kFragileFourfold : kFragile;
      const bool near_fragile = std::any_of(contacts.begin(), contacts.end(), [&](const CurveContact& c) {
        return is_fragile(c) && off(c, root) <= fragile_by * scale_of(c);
      });
      if (matched_[k] != root.decision.contacts && !near_fragile && !root.decision.degenerate &&
          !is_far(problem_, root.middle)) {
        return false;
      }
    }
    return true;
  }

private:
  [[nodiscard]] double off(const CurveContact& contact, const DecidedRoot& root) const {
    return distance(contact, root, pair_.motion2.turns);
  }

  [[nodiscard]] double scale_of(const CurveContact& contact) const {
    return pair_.motion2.turns ? 1 : problem_.length + std::abs(contact.q) + contact.p_W.norm();
  }

  [[nodiscard]] std::optional<std::size_t> nearest_root(const CurveContact& contact) const {
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < roots_.size(); ++k) {
      const DecidedRoot& root = roots_[k];
      const bool fits = matched_[k] < root.decision.contacts && root.decision.opposed == contact.opposed;
      if (fits && off(contact, root) <= kSameRoot * scale_of(contact) &&
          (!best || off(contact, root) < off(contact, roots_[*best]))) {
        best = k;
      }
    }
    return best;
  }

  // Close to another contact, rounding decides at which of the two the bodies overlap.
  [[nodiscard]] bool is_crowded(const CurveContact& contact, const DecidedRoot& root) const {
    return std::any_of(roots_.begin(), roots_.end(), [&](const DecidedRoot& other) {
      return &other != &root && other.decision.contacts > 0 &&
             off(contact, other) <= kCrowded * scale_of(contact);
    });
  }

  const ContactPair& pair_;
  TangencyProblem problem_;
  const std::vector<DecidedRoot>& roots_;
  std::vector<int> matched_;  // contacts of the list matched to each root
  bool agrees_ = true;
};

}  // namespace

Certificate certify_contacts(const ContactPair& pair, double u, const CurveContacts& list) {
  Certificate certificate;
  certificate.intervals.resize(list.contacts.size());
  if (!has_exact_arithmetic()) {
    certificate.status = CertificateStatus::kUnavailable;
    return certificate;
  }
  if (list.status != ContactsStatus::kComplete || !is_algebraic(pair)) {
    return certificate;
  }
  const auto roots = decide_roots(pair, u);
  if (!roots) {
    return certificate;
  }
  Comparison comparison(pair, u, *roots);
  bool fragile = false, all_found = true;
  for (std::size_t i = 0; i < list.contacts.size(); ++i) {
    if (is_fragile(list.contacts[i])) {
      fragile = true;
      continue;
    }
    certificate.intervals[i] = comparison.certified(list.contacts[i]);
    all_found = all_found && certificate.intervals[i];
  }
  const bool agrees = all_found && comparison.agrees() && comparison.accounts_for_all(list.contacts);
  certificate.status = !agrees   ? CertificateStatus::kDisagreement
                       : fragile ? CertificateStatus::kAtLimit
                                 : CertificateStatus::kCertified;
  return certificate;
}

std::string_view describe(CertificateStatus status) {
  switch (status) {
    case CertificateStatus::kCertified:
      return "certified: exactly these contacts exist";
    case CertificateStatus::kAtLimit:
      return "certified, but for contacts at a limit, which rounding of the numbers makes or unmakes";
    case CertificateStatus::kDisagreement:
      return "the exact answer differs from this list";
    case CertificateStatus::kUnavailable:
      return "not decided: this build has no exact arithmetic";
    case CertificateStatus::kNotDecided:
      break;
  }
  return "not decided exactly";
}

}  // namespace higherpair
