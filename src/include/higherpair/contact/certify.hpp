#pragma once

#include "higherpair/contact/conic_contacts.hpp"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace higherpair {

enum class CertificateStatus {
  kCertified,   ///< every entry of the list is a contact, decided exactly, and there are no others
  kAtLimit,     ///< the same, except for entries at a double root: rounding of the input creates or destroys
                ///< them
  kNotDecided,  ///< the list is not kComplete, or a case that the exact decision does not cover
  kDisagreement,  ///< list and exact answer differ: an error in this program
  kUnavailable,   ///< this build of the library has no exact arithmetic: nothing was decided
};

/// Whether this build can decide contacts: with HIGHERPAIR_EXACT=OFF it is made without CGAL, GMP and MPFR.
[[nodiscard]] bool has_exact_arithmetic();

/// The verdict of exact arithmetic on a list of contacts.
struct Certificate {
  CertificateStatus status = CertificateStatus::kNotDecided;
  /// For each contact of the list an interval of q [rad or m] that contains this contact and no other (two at
  /// one position share theirs); none for an entry at a limit.
  std::vector<std::optional<std::array<double, 2>>> intervals;
};

/// Decides in exact rational arithmetic how many tangencies the pair has, whether their normals are opposed
/// and the bodies free, and compares the result with the list returned by find_curve_contacts(pair, u).
///
/// The doubles of the pair are taken as exact numbers, the driver's angle u as a rational rotation within
/// 2^-60 (quarter turns exactly). The real roots of the discriminant are isolated; at each of them the signs
/// of polynomials in tan(q/2), or q, decide whether the contact is real, at infinity or on the other branch
/// of a hyperbola, and how the bodies lie. Each interval is the isolating one, refined, rounded outwards, and
/// widened by the distance that rounding of every number of the pair (2^-50 relative, to first order) can
/// move the contact. Where a body is the outside of a hyperbola's or around a hyperbola, `free` is taken from
/// the list. Cost: some 10 ms (two conics).
[[nodiscard]] Certificate certify_contacts(const ContactPair& pair, double u, const CurveContacts& list);

/// The status as a sentence.
[[nodiscard]] std::string_view describe(CertificateStatus status);

}  // namespace higherpair
