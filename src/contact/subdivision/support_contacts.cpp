#include "support_contacts.hpp"

#include "higherpair/contact/boundary_enumeration.hpp"
#include "higherpair/contact/separation.hpp"
#include "higherpair/contact/tolerances.hpp"
#include "higherpair/geometry/curve_queries.hpp"
#include "higherpair/geometry/support_chains.hpp"
#include "higherpair/numeric/special_values.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace higherpair {
namespace {

// The chains of spans that a curve consists of; none for a curve with cusps.
std::vector<Boundary> chains_of(const Curve& curve, double reach) {
  return curve.support == nullptr ? std::vector{boundary_of(curve, reach)}
                                  : support_chains(*curve.support, reach);
}

// Largest distance of its points from its joint; for an open curve its size near the vertex [m].
double extent_of(const Curve& curve, const OneFreedom& freedom) {
  return reach_from(curve, freedom.p_BO).value_or(size_of(curve));
}

// Largest error of a curve's points [m].
double error_of_points(const Curve& curve) {
  double error = 0;
  for (std::size_t i = 0; curve.support != nullptr && i < curve.support->pieces().size(); ++i) {
    const Bounds phi = normals_of(curve.support->pieces()[i]);
    error = std::max({error, curve.support->at(i, phi.low).error, curve.support->at(i, phi.high).error});
  }
  return error;
}

// The same curve with the material on its other side, without its corners.
std::vector<Boundary> turned_inside_out(const std::vector<Boundary>& chains) {
  std::vector<Boundary> all;
  for (const Boundary& chain : chains) {
    std::vector<SpanPtr> spans;
    for (auto span = chain.spans().rbegin(); span != chain.spans().rend(); ++span) {
      if (!(*span)->is_corner()) {
        spans.push_back(reversed_span(*span));
      }
    }
    if (auto turned = Boundary::make(std::move(spans), chain.is_closed(), kInf)) {
      all.push_back(*std::move(turned));
    }
  }
  return all;
}

class SupportContacts {
public:
  SupportContacts(const ContactPair& pair, double u) : pair_(pair), u_(u), size_(size_of_pair(pair)) {}

  [[nodiscard]] CurveContacts list() {
    const double reach = kSupportReach * (size_ + extent_of(pair_.curve1, pair_.motion1) +
                                          extent_of(pair_.curve2, pair_.motion2));
    const std::vector<Boundary> one = chains_of(pair_.curve1, reach);
    const std::vector<Boundary> two = chains_of(pair_.curve2, reach);
    result_.status = one.empty() || two.empty() ? ContactsStatus::kUndecided : ContactsStatus::kComplete;
    add(one, two, true);
    if (!is_point(pair_.curve1)) {
      add(one, turned_inside_out(two), false);
    }
    std::sort(result_.contacts.begin(), result_.contacts.end(),
              [](const CurveContact& a, const CurveContact& b) { return a.q < b.q; });
    return std::move(result_);
  }

private:
  void add(const std::vector<Boundary>& chains1, const std::vector<Boundary>& chains2, bool opposed) {
    const TangencySearch search{true, std::max(error_of_points(pair_.curve1), error_of_points(pair_.curve2))};
    for (const Boundary& one : chains1) {
      for (const Boundary& two : chains2) {
        const BoundaryContacts found =
            enumerate_boundary_contacts({&one, pair_.motion1, &two, pair_.motion2}, u_, search);
        if (!found.undecided.empty()) {
          result_.status = ContactsStatus::kUndecided;
        }
        for (const BoundaryContact& contact : found.contacts) {
          if (opposed || !one.is_corner(contact.place1)) {
            result_.contacts.push_back(contact_at(contact, opposed));
          }
        }
      }
    }
  }

  [[nodiscard]] CurveContact contact_at(const BoundaryContact& found, bool opposed) const {
    CurveContact contact;
    contact.u = u_;
    contact.q = found.q;
    contact.n_W = found.at.n_W;
    contact.p_W = found.at.p1_W;
    contact.opposed = opposed;
    contact.branch = !opposed ? 0 : found.gap_q > 0 ? 1 : -1;
    const auto gap = [&] {
      return separation(pair_.curve1, pose_at(pair_.motion1, u_), pair_.curve2,
                        pose_at(pair_.motion2, found.q), kFineGap * size_)
          .gap;
    };
    contact.free =
        opposed && always_free(pair_.curve1, pair_.curve2).value_or(gap() >= -kFreeOverlap * size_);
    return contact;
  }

  const ContactPair& pair_;
  double u_;
  double size_;
  CurveContacts result_;
};

}  // namespace

CurveContacts list_support_contacts(const ContactPair& pair, double u) {
  return SupportContacts(pair, u).list();
}

}  // namespace higherpair
