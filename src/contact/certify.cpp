#include "higherpair/contact/certify.hpp"

#include "exact/exact_decision.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "tangency.hpp"
#include "tolerances.hpp"

#include <algorithm>
#include <cmath>

namespace higherpair {
namespace {

// Contacts that the list takes to be at infinity, such as of parabolas whose axes are parallel but for
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

// How far rounding of the numbers of the pair can move a contact: what it does to the gap, divided by
// ∂gap/∂q.
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
  const double margin = widening(pair, contact) + 2e-16 * std::abs(turn);
  return {root.q[0] + turn - margin, root.q[1] + turn + margin};
}

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
  const bool turns = pair.motion2.turns;
  certificate.status = CertificateStatus::kCertified;
  const auto disagree = [&] { certificate.status = CertificateStatus::kDisagreement; };
  const TangencyProblem problem = make_problem(pair, u);
  const auto scale_of = [&](const CurveContact& contact) {
    return turns ? 1 : problem.length + std::abs(contact.q) + contact.p_W.norm();
  };
  std::vector<int> matched(roots->size(), 0);
  bool fragile = false;
  for (std::size_t i = 0; i < list.contacts.size(); ++i) {
    const CurveContact& contact = list.contacts[i];
    if (is_fragile(contact)) {
      fragile = true;
      continue;
    }
    const double scale = scale_of(contact);
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < roots->size(); ++k) {
      const DecidedRoot& root = (*roots)[k];
      const double off = distance(contact, root, turns);
      const bool fits = matched[k] < root.decision.contacts && root.decision.opposed == contact.opposed;
      if (fits && off <= kSameRoot * scale && (!best || off < distance(contact, (*roots)[*best], turns))) {
        best = k;
      }
    }
    if (!best) {
      disagree();
      continue;
    }
    ++matched[*best];
    const DecidedRoot& root = (*roots)[*best];
    // Next to another contact rounding decides which of the two cuts in.
    const bool crowded = std::any_of(roots->begin(), roots->end(), [&](const DecidedRoot& other) {
      return &other != &root && other.decision.contacts > 0 &&
             distance(contact, other, turns) <= kCrowded * scale;
    });
    if (!crowded && root.decision.free && *root.decision.free != contact.free) {
      disagree();
    }
    certificate.intervals[i] = interval_of(pair, contact, root);
  }
  for (std::size_t k = 0; k < roots->size(); ++k) {
    const DecidedRoot& root = (*roots)[k];
    const double fragile_by = root.multiplicity >= 4 ? kFragileFourfold : kFragile;
    const bool near_fragile = std::any_of(list.contacts.begin(), list.contacts.end(), [&](const auto& c) {
      return is_fragile(c) && distance(c, root, turns) <= fragile_by * scale_of(c);
    });
    if (matched[k] != root.decision.contacts && !near_fragile && !root.decision.degenerate &&
        !is_far(problem, root.middle)) {
      disagree();
    }
  }
  if (fragile && certificate.status == CertificateStatus::kCertified) {
    certificate.status = CertificateStatus::kAtLimit;
  }
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
