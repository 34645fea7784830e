#include "higherpair/io/names.hpp"
#include "reading.hpp"

#include <fmt/core.h>

namespace higherpair::io_detail {
namespace {

// The index of a body, and of its point or curve.
struct Member {
  int body;
  int index;
};

// Access to the points or the curves of a body, with the words for messages.
struct Points {
  static constexpr std::string_view kKind = "point";
  static constexpr std::string_view kOtherKind = "curve";
  static const std::vector<NamedPoint>& of(const Body& body) { return body.points; }
  static const std::vector<NamedCurve>& others_of(const Body& body) { return body.curves; }
};

struct Curves {
  static constexpr std::string_view kKind = "curve";
  static constexpr std::string_view kOtherKind = "point";
  static const std::vector<NamedCurve>& of(const Body& body) { return body.curves; }
  static const std::vector<NamedPoint>& others_of(const Body& body) { return body.points; }
};

// Another body that has this member and whose name differs from that of `owner` in capital letters only, or
// is another word for it, as `frame` is for `ground`.
template <class Kind>
const Body* spelt_alike(const Mechanism& mechanism, const Body& owner, const std::string& name) {
  for (const Body& body : mechanism.bodies) {
    const bool meant = same_letters(body.name, owner.name) || is_synonym(body.name, owner.name);
    if (&body != &owner && meant && index_of(Kind::of(body), name)) {
      return &body;
    }
  }
  return nullptr;
}

// "body.name"
template <class Kind>
std::optional<Member> member(Reading& reading, const Item& item, const Mechanism& mechanism) {
  const auto text = as_text(reading, item);
  if (!text) {
    return std::nullopt;
  }
  // In "bodies.cam.O" there is something before the body, in "cam.points.O" behind it.
  const bool begins_with_body = index_of(mechanism.bodies, text->substr(0, text->find('.'))).has_value();
  const std::size_t dot = begins_with_body ? text->find('.') : text->rfind('.');
  if (dot == std::string::npos) {
    report(reading, item, fmt::format("expected \"body.{}\"", Kind::kKind));
    return std::nullopt;
  }
  const auto body =
      named_thing(reading, item, text->substr(0, dot), "there is no body", mechanism.bodies, "bodies");
  if (!body) {
    return std::nullopt;
  }
  const Body& owner = mechanism.bodies[*body];
  const std::string name = text->substr(dot + 1);
  if (!index_of(Kind::of(owner), name) && index_of(Kind::others_of(owner), name)) {
    report(reading, item, fmt::format("this is a {}, expected a {}", Kind::kOtherKind, Kind::kKind));
    return std::nullopt;
  }
  if (!index_of(Kind::of(owner), name)) {
    if (const Body* other = spelt_alike<Kind>(mechanism, owner, name)) {
      report(reading, item,
             fmt::format(
                 "{} `{}`, but body `{}` has one: {}", has_no(owner.name, Kind::kKind), name, other->name,
                 *body == 0 ? "the frame has the name `ground`" : "capital and small letters differ"));
      return std::nullopt;
    }
  }
  const auto index = named_thing(reading, item, name, has_no(owner.name, Kind::kKind), Kind::of(owner),
                                 fmt::format("bodies.{}.{}s", owner.name, Kind::kKind));
  return index ? std::optional(Member{*body, *index}) : std::nullopt;
}

// \param resolve  turns an Item into a Member
template <class Pair, class F>
std::optional<Pair> member_pair(Reading& reading, const Item& item, const Mechanism& mechanism,
                                std::string_view kind, F resolve) {
  const auto items = as_items(
      reading, item, fmt::format("two {0}s on two bodies, [\"body.{0}\", \"body.{0}\"]", kind), 2, 2);
  if (!items) {
    return std::nullopt;
  }
  const std::optional<Member> first = resolve(items->front());
  const std::optional<Member> second = resolve(items->back());
  if (!first || !second) {
    return std::nullopt;
  }
  if (first->body == second->body) {
    report(reading, item,
           fmt::format("both are on body `{}`: expected two bodies", mechanism.bodies[first->body].name));
    return std::nullopt;
  }
  return Pair{{first->body, first->index}, {second->body, second->index}};
}

// Joins all curves of a body whose names begin with `start`, and adds them to it as one curve.
std::optional<int> join_curves(Reading& reading, const Item& item, Body& body, const std::string& start) {
  NamedCurve joined;
  joined.curve.kind = CurveKind::kChain;
  for (std::size_t i = 0; i < body.curves.size(); ++i) {
    if (body.curves[i].parts.empty() && body.curves[i].name.starts_with(start)) {
      joined.parts.push_back(static_cast<int>(i));
    }
  }
  if (joined.parts.empty()) {
    report(reading, item,
           body.curves.empty() ? fmt::format("body `{}` has no curve that could touch anything", body.name)
                               : fmt::format("no curve of `{}` has a name that begins so; {}", body.name,
                                             suggestion(start, names_of(body.curves))));
    return std::nullopt;
  }
  if (joined.parts.size() == 1) {
    return joined.parts.front();
  }
  joined.copy_of = joined.parts.front();
  body.curves.push_back(std::move(joined));
  return static_cast<int>(body.curves.size()) - 1;
}

// "body.curve", "body.start*" or "body" for all of its curves.
std::optional<Member> curve_or_curves(Reading& reading, const Item& item, Mechanism& mechanism) {
  const auto* text = std::get_if<std::string>(&item.value->content);
  const std::size_t dot = text == nullptr ? 0 : text->find('.');
  if (text == nullptr || (dot != std::string::npos && !text->ends_with('*'))) {
    return member<Curves>(reading, item, mechanism);
  }
  const auto index =
      named_thing(reading, item, text->substr(0, dot), "there is no body", mechanism.bodies, "bodies");
  if (!index) {
    return std::nullopt;
  }
  const std::string start = dot == std::string::npos ? "" : text->substr(dot + 1, text->size() - dot - 2);
  const auto curve = join_curves(reading, item, mechanism.bodies[*index], start);
  return curve ? std::optional(Member{*index, *curve}) : std::nullopt;
}

}  // namespace

std::optional<int> as_body(Reading& reading, const Item& item, const Mechanism& mechanism) {
  const auto name = as_text(reading, item);
  return name ? named_thing(reading, item, *name, "there is no body", mechanism.bodies, "bodies")
              : std::nullopt;
}

std::optional<int> as_joint(Reading& reading, const Item& item, const Mechanism& mechanism) {
  const auto name = as_text(reading, item);
  return name ? named_thing(reading, item, *name, "there is no joint", mechanism.joints, "joints")
              : std::nullopt;
}

std::optional<int> as_point_of(Reading& reading, const Item& item, const Body& body) {
  const auto name = as_text(reading, item);
  return name ? named_thing(reading, item, *name, has_no(body.name, "point"), body.points,
                            fmt::format("bodies.{}.points", body.name))
              : std::nullopt;
}

std::optional<PointRef> as_point(Reading& reading, const Item& item, const Mechanism& mechanism) {
  const auto point = member<Points>(reading, item, mechanism);
  return point ? std::optional(PointRef{point->body, point->index}) : std::nullopt;
}

std::optional<PointPair> as_point_pair(Reading& reading, const Item& item, const Mechanism& mechanism) {
  return member_pair<PointPair>(reading, item, mechanism, Points::kKind,
                                [&](const Item& one) { return member<Points>(reading, one, mechanism); });
}

std::optional<CurvePair> as_curve_pair(Reading& reading, const Item& item, Mechanism& mechanism) {
  return member_pair<CurvePair>(reading, item, mechanism, Curves::kKind,
                                [&](const Item& one) { return curve_or_curves(reading, one, mechanism); });
}

}  // namespace higherpair::io_detail
