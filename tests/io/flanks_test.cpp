#include "higherpair/cam/flank.hpp"
#include "higherpair/geometry/pose.hpp"
#include "higherpair/io/notes.hpp"
#include "higherpair/io/profile_reader.hpp"
#include "support/texts.hpp"

#include <cmath>
#include <string>

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::contains;
using ::testing::IsEmpty;
using testing::lines_are;
using testing::part;

// A profile of a cam that contains these parts.
struct Parts {
  std::string flank = R"({ type = "cam", law = "lift", contact = "touch" })";
  std::string more_curves;
  std::string follower = R"({ type = "circle", center = [0, 0], radius = 10 })";
  std::string height = "50";
  std::string rising_law = "cycloidal";
  std::string rise = "20";
  std::string law;  // replaces the four segments with the rise above
  std::string joint = R"(type = "prismatic"
between = ["ground.O", "follower.P"]
direction = [0, 1])";
  std::string between = R"(["cam.flank", "follower.roller"])";
};

std::string profile_with(const Parts& parts) {
  const std::string segments = fmt::format(
      R"(segments = [ {{ over = 120, law = "{}", rise = {} }}, {{ over = 40, law = "dwell" }},
             {{ over = 120, law = "cycloidal", rise = -20 }}, {{ over = 80, law = "dwell" }} ])",
      parts.rising_law, parts.rise);
  return fmt::format(R"([bodies.ground]
points = {{ O = [0, 0], Q = [-60, 50] }}
[bodies.cam]
points.O = [0, 0]
curves.flank = {}
{}
[bodies.follower]
pose = {{ x = 0, y = {} }}
points.P = [0, 0]
curves.roller = {}
[laws.lift]
{}
[joints.pivot]
type = "revolute"
between = ["ground.O", "cam.O"]
[joints.slide]
{}
[contacts.touch]
between = {}
[driver]
joint = "pivot"
)",
                     parts.flank, parts.more_curves, parts.height, parts.follower,
                     parts.law.empty() ? segments : parts.law, parts.joint, parts.between);
}

std::string mistakes_in(const Parts& parts) {
  const auto profile = read_profile_text(profile_with(parts), "cam.toml");
  std::string text;
  if (!profile) {
    for (const Diagnostic& diagnostic : profile.error()) {
      text += to_string(diagnostic) + "\n";
    }
  }
  return text;
}

TEST(Flanks, AreBoundariesOfAsManySpansAsTheLawHasSegments) {
  const auto profile = read_profile_text(profile_with({}), "cam.toml");
  ASSERT_TRUE(profile);
  const NamedCurve& flank = profile->mechanism.bodies[1].curves[0];
  ASSERT_TRUE(flank.boundary);
  EXPECT_TRUE(flank.boundary->is_closed());
  EXPECT_EQ(flank.boundary->spans().size(), 4U);
  EXPECT_TRUE(profile->mechanism.contacts[0].by_boundary);
}

TEST(Flanks, OfALawThatLacksSomeOfATurnAreNoted) {
  const auto notes_of = [](double last) {
    Parts parts;
    parts.law = fmt::format(
        R"(segments = [ {{ over = 120, law = "cycloidal", rise = 20 }}, {{ over = 40, law = "dwell" }},
             {{ over = 120, law = "cycloidal", rise = -20 }}, {{ over = {}, law = "dwell" }} ])",
        last);
    const auto profile = read_profile_text(profile_with(parts), "cam.toml");
    std::string text;
    for (const Diagnostic& note : profile.value().notes) text += note_text(note) + "\n";
    return text;
  };
  EXPECT_TRUE(contains(notes_of(60),
                       "the law goes over 340 deg of the cam, and the flank ends there; over "
                       "360 deg it would be closed"));
  EXPECT_EQ(notes_of(80), "");
}

// One lobe of three, and all three.
TEST(Flanks, OfALawThatRepeatsGoRoundTheCam) {
  const std::string lobe =
      R"({ over = 60, law = "cycloidal", rise = 5 }, { over = 60, law = "cycloidal", rise = -5 })";
  const auto read = [](const std::string& law) {
    Parts parts;
    parts.law = law;
    auto profile = read_profile_text(profile_with(parts), "cam.toml");
    EXPECT_TRUE(profile);
    return *std::move(profile);
  };
  const Profile one = read("repeat = true\nsegments = [" + lobe + "]");
  const Profile all = read("segments = [" + lobe + ", " + lobe + ", " + lobe + "]");
  const Boundary& flank = *one.mechanism.bodies[1].curves[0].boundary;
  const Boundary& written = *all.mechanism.bodies[1].curves[0].boundary;
  EXPECT_TRUE(flank.is_closed());
  ASSERT_EQ(flank.spans().size(), written.spans().size());
  for (std::size_t i = 0; i < flank.spans().size(); ++i) {
    const Bounds range = written.spans()[i]->range();
    const SpanPoint point = flank.spans()[i]->at(range.low + 0.3 * range.width());
    const SpanPoint same = written.spans()[i]->at(range.low + 0.3 * range.width());
    EXPECT_NEAR((point.p_B - same.p_B).norm(), 0, 1e-15) << i;
    EXPECT_NEAR(point.kappa, same.kappa, 1e-9) << i;
  }
  EXPECT_TRUE(one.notes.empty());
  const Profile part = read(
      R"(repeat = true
segments = [ { over = 50, law = "cycloidal", rise = 5 }, { over = 50, law = "cycloidal", rise = -5 } ])");
  EXPECT_FALSE(part.mechanism.bodies[1].curves[0].boundary->is_closed());
  ASSERT_EQ(part.notes.size(), 1U);
  EXPECT_TRUE(contains(part.notes[0].message,
                       "the law goes over 100 deg of the cam, and the flank ends there; it "
                       "repeats on the cam where a whole number"));
}

TEST(Flanks, ThatTheDriverNeverComesToAreNoted) {
  const auto notes_of = [](double start, double end, const char* joint) {
    Parts parts;
    parts.law = R"(origin = 3
segments = [ { over = 60, law = "cycloidal", rise = 10 }, { over = 40, law = "cycloidal", rise = -10 } ])";
    std::string text = profile_with(parts) + fmt::format("start = {}\nend = {}\n", start, end);
    const std::string pivot = "[joints.pivot]\ntype = \"revolute\"";
    text.replace(text.find(pivot), pivot.size(), fmt::format("[joints.pivot]\n{}", joint));
    const auto profile = read_profile_text(text, "cam.toml");
    std::string notes;
    for (const Diagnostic& note : profile.value().notes) notes += note_text(note) + "\n";
    return notes;
  };
  const char* slide = "type = \"prismatic\"\ndirection = [1, 0]";
  EXPECT_TRUE(contains(notes_of(-4, -1, slide),
                       "driver: from -4 mm to -1 mm the other body never comes to the flank cam.flank, which "
                       "goes from 3 mm to 103 mm"));
  EXPECT_TRUE(contains(notes_of(110, 104, slide), "never comes to the flank"));
  EXPECT_EQ(notes_of(-4, 4, slide), "");
  EXPECT_EQ(notes_of(50, 40, slide), "");
  const char* pivot = "type = \"revolute\"";
  EXPECT_TRUE(contains(notes_of(-250, -5, pivot), "never comes to the flank"));
  EXPECT_EQ(notes_of(-270, -5, pivot), "");
  EXPECT_EQ(notes_of(410, 440, pivot), "");
}

// While the follower rests, whatever it is, the flank is an arc about the cam's pivot.
TEST(Flanks, AreArcsWhereTheLawDwells) {
  Parts ellipse;
  ellipse.follower = R"({ type = "ellipse", center = [0, 0], semi_axes = [14, 9], rotation = 20 })";
  Parts flat;
  flat.follower = R"({ type = "line", point = [0, 0], normal = [0, -1] })";
  for (const Parts& parts : {Parts(), ellipse, flat}) {
    const auto profile = read_profile_text(profile_with(parts), "cam.toml");
    ASSERT_TRUE(profile) << mistakes_in(parts);
    const Boundary& flank = *profile->mechanism.bodies[1].curves[0].boundary;
    int arcs = 0;
    for (std::size_t i = 0; i < flank.spans().size(); ++i) {
      if (!flank.is_arc(static_cast<int>(i))) continue;
      ++arcs;
      const Span& span = *flank.spans()[i];
      const Bounds range = span.range();
      const double radius = span.at(range.low).p_B.norm();
      double arc = 0;
      Vector2d last = span.at(range.low).p_B;
      for (int k = 1; k <= 200; ++k) {
        const SpanPoint point = span.at(range.low + k * range.width() / 200);
        EXPECT_NEAR(point.p_B.norm(), radius, 1e-15);
        EXPECT_NEAR(std::abs(cross(point.p_B, point.n_B)), 0, 1e-14);
        EXPECT_NEAR(point.kappa, 1 / radius, 1e-10);
        arc += std::abs(std::atan2(cross(last, point.p_B), last.dot(point.p_B)));
        last = point.p_B;
      }
      EXPECT_NEAR(arc, range.width(), 1e-12);
      EXPECT_LT((span.at(range.high).p_B - span.at(range.high - 1e-9).p_B).norm(), 1e-9 * 2 * radius);
    }
    EXPECT_EQ(arcs, 2);
  }
}

TEST(Flanks, HaveOffsets) {
  Parts parts;
  parts.more_curves = R"(curves.inner = { type = "offset", of = "flank", by = -5 }
curves.further = { type = "offset", of = "inner", by = -2 })";
  const auto profile = read_profile_text(profile_with(parts), "cam.toml");
  ASSERT_TRUE(profile) << mistakes_in(parts);
  const auto& curves = profile->mechanism.bodies[1].curves;
  const SpanPoint flank = curves[0].boundary->spans()[0]->at(curves[0].boundary->spans()[0]->range().low);
  const SpanPoint further = curves[2].boundary->spans()[0]->at(curves[2].boundary->spans()[0]->range().low);
  EXPECT_NEAR((flank.p_B - further.p_B).norm(), 7e-3, 1e-15);
}

// A harmonic lift of 2 mm as a rounded table in steps of 3 degrees.
std::string table_of_lifts() {
  std::string text = "points = [";
  for (int x = 0; x <= 360; x += 3) {
    text += fmt::format("[{}, {:.3f}], ", x, 1 - std::cos(x * kPi / 180));
  }
  return text + "]";
}

TEST(Flanks, MoveTheFollowerByTheSplineOfATableInSiUnits) {
  Parts parts;
  parts.law = table_of_lifts();
  const auto profile = read_profile_text(profile_with(parts), "cam.toml");
  ASSERT_TRUE(profile) << mistakes_in(parts);
  const auto origin = flank_origin(*profile->mechanism.bodies[1].curves[0].boundary->spans().front());
  ASSERT_TRUE(origin);
  const MotionLaw law = MotionLaw::make(profile->mechanism.laws[0].law).value();
  EXPECT_NEAR(law(kPi), 2e-3, 1e-18);
  for (const double x : {0.0, 1.2345, 3.0, 5.4321}) {
    for (int k = 0; k < 6; ++k) {
      EXPECT_EQ(origin->motion.law.derivative(k, x), law.derivative(k, x)) << k << " at " << x;
    }
  }
}

// The notes about a table do not depend on what uses it.
TEST(Flanks, NoteTheRoundingOfATableInTheProfilesUnits) {
  Parts parts;
  parts.law = table_of_lifts();
  const auto note_of = [](const std::string& text) {
    const auto profile = read_profile_text(text, "cam.toml");
    std::string notes;
    for (const Diagnostic& note : profile ? profile->notes : profile.error()) notes += to_string(note) + "\n";
    const std::size_t at = notes.find("laws.lift: its values");
    EXPECT_EQ(notes.find("laws.lift: its values", at + 1), std::string::npos) << notes;
    return at == std::string::npos ? notes : notes.substr(at, notes.find('\n', at) - at);
  };
  const std::string of_flank = note_of(profile_with(parts));
  EXPECT_TRUE(contains(of_flank, "probably rounded to, 0.001 mm; the spline"));
  EXPECT_TRUE(contains(of_flank, "mm/deg^2"));
  const std::string design = R"([design.variables]
h = { path = "bodies.follower.pose.y", min = 45, max = 55 }
[[design.objectives]]
column = "slide.position"
follow = "lift"
)";
  EXPECT_EQ(note_of(profile_with(parts) + design), of_flank);
  parts.flank = R"({ type = "circle", center = [5, 0], radius = 40 })";
  EXPECT_EQ(note_of(profile_with(parts) + design), of_flank);
}

// The number that follows these words in the message [mm].
double number_behind(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + words.size()));
}

TEST(Flanks, OfLawsWhoseVelocityJumpsNeedAKnifeEdge) {
  Parts parts;
  parts.rising_law = "uniform";
  EXPECT_TRUE(contains(mistakes_in(parts),
                       "at 0 deg of the cam the law's velocity jumps: this follower would go on at another "
                       "place of its curve, with a gap in the flank; a knife edge"));
  parts.follower = R"({ type = "point", at = [0, 0] })";
  EXPECT_EQ(mistakes_in(parts), "");
}

TEST(Flanks, ThatWouldBeUndercutSayWhatWouldDo) {
  Parts flat;
  flat.height = "5";
  flat.follower = R"({ type = "line", point = [0, 0], normal = [0, -1] })";
  const std::string about_flat = mistakes_in(flat);
  EXPECT_TRUE(contains(about_flat,
                       "deg of the cam on the flank would be undercut: it takes a base circle of more than"));
  EXPECT_TRUE(contains(about_flat, " mm instead of 5 mm (the follower's pose moved by "));
  EXPECT_TRUE(contains(about_flat, "or a longer segment of the law"));
  const double circle = number_behind(about_flat, "more than ");
  EXPECT_NEAR(number_behind(about_flat, "moved by "), circle - 5, 1e-4);
  flat.height = fmt::format("{}", circle * 1.00001);
  EXPECT_EQ(mistakes_in(flat), "");
  flat.height = fmt::format("{}", circle * 0.999);
  EXPECT_NE(mistakes_in(flat), "");

  Parts roller;
  roller.height = "46";
  roller.follower = R"({ type = "circle", center = [0, 0], radius = 45 })";
  const std::string about_roller = mistakes_in(roller);
  const double largest = number_behind(about_roller, "a roller of less than ");
  const double moved = number_behind(about_roller, "moved by ");
  Parts smaller = roller;
  smaller.follower = fmt::format(R"({{ type = "circle", center = [0, 0], radius = {} }})", largest * 0.99999);
  EXPECT_EQ(mistakes_in(smaller), "");
  Parts higher = roller;
  higher.height = fmt::format("{}", 46 + moved + 1e-3);
  EXPECT_EQ(mistakes_in(higher), "");
}

// So steep that on a small base circle the roller's centre moves backwards around the cam's pivot for a
// while.
TEST(Flanks, ThatWouldBeUndercutSayWhichBaseCircleWouldDoHoweverSteepTheLaw) {
  Parts parts;
  parts.law = R"(segments = [ { over = 20, law = "parabolic", rise = 20 }, { over = 40, law = "dwell" },
             { over = 120, law = "cycloidal", rise = -20 }, { over = 180, law = "dwell" } ])";
  parts.follower = R"({ type = "circle", center = [10, 0], radius = 10 })";
  for (const double height : {0.01, 10.0, 30.0, 50.0}) {
    SCOPED_TRACE(height);
    parts.height = fmt::format("{}", height);
    const std::string mistake = mistakes_in(parts);
    EXPECT_NEAR(number_behind(mistake, "more than "), 57.0267, 1e-4);
    const double enough = height + number_behind(mistake, "moved by ");
    parts.height = fmt::format("{}", enough * 1.0001);
    EXPECT_EQ(mistakes_in(parts), "");
    parts.height = fmt::format("{}", enough * 0.9999);
    EXPECT_TRUE(contains(mistakes_in(parts), "the flank would be undercut"));
  }
}

// A roller small enough for the rise would still leave a gap in the flank where the return begins.
TEST(Flanks, ThatWouldBeUndercutNameAJumpOfVelocityFirst) {
  Parts parts;
  parts.law = R"(segments = [ { over = 20, law = "parabolic", rise = 20 }, { over = 40, law = "dwell" },
             { over = 120, law = "uniform", rise = -20 }, { over = 180, law = "dwell" } ])";
  const std::string mistake = mistakes_in(parts);
  EXPECT_TRUE(contains(mistake, "at 60 deg of the cam the law's velocity jumps"));
  EXPECT_EQ(mistake.find("roller of less"), std::string::npos);
}

TEST(Flanks, SayWhatIsWrong) {
  Parts parts;
  parts.flank = R"({ type = "cam", law = "lfit", contact = "touch" })";
  EXPECT_TRUE(contains(mistakes_in(parts), "lift"));
  parts.flank = R"({ type = "cam", law = "lift", contact = "tuch" })";
  EXPECT_TRUE(contains(mistakes_in(parts), "there is no contact `tuch`"));
  parts.flank = R"({ type = "cam", law = "lift" })";
  EXPECT_TRUE(contains(mistakes_in(parts), "the name of the contact with the follower"));
  parts.flank = R"({ type = "cam", contact = "touch" })";
  EXPECT_TRUE(contains(mistakes_in(parts), "the name of one of [laws]"));
  parts.flank = R"({ type = "cam", law = "lift", contact = "touch", radius = 3 })";
  EXPECT_TRUE(contains(mistakes_in(parts), "radius"));

  Parts undercut;
  undercut.height = "46";
  undercut.follower = R"({ type = "circle", center = [0, 0], radius = 45 })";
  EXPECT_TRUE(contains(mistakes_in(undercut), "the flank would be undercut"));
  Parts flat;
  flat.height = "5";
  flat.follower = R"({ type = "line", point = [0, 0], normal = [0, -1] })";
  EXPECT_TRUE(contains(mistakes_in(flat), "the flank would be undercut"));
  flat.height = "50";
  EXPECT_EQ(mistakes_in(flat), "");
  flat.follower = R"({ type = "line", point = [0, 0], normal = [0, 1] })";
  EXPECT_TRUE(contains(mistakes_in(flat),
                       "the follower's face points away from the cam: its normal points out of "
                       "the follower's material, to the flank; write normal = [0, -1]"));
  Parts step;
  step.rise = "20.8";
  EXPECT_TRUE(contains(mistakes_in(step),
                       "the flank does not close: over the turn of the cam the law ends 0.8 mm "
                       "off the value with which it begins"));
  Parts round_its_pivot;
  round_its_pivot.follower = R"({ type = "circle", center = [-60, 0], radius = 10 }
points.pivot = [-60, 0])";
  round_its_pivot.joint = R"(type = "revolute"
between = ["ground.Q", "follower.pivot"])";
  EXPECT_TRUE(contains(mistakes_in(round_its_pivot), "the follower turns about the centre of its own curve"));
  Parts along_its_guide;
  along_its_guide.follower = R"({ type = "line", point = [20, 0], normal = [-1, 0] })";
  EXPECT_TRUE(contains(mistakes_in(along_its_guide), "the follower slides along its own face"));
  Parts open;
  open.rise = "19";
  EXPECT_TRUE(contains(mistakes_in(open), "lift"));
  Parts close;  // these differ by one unit in the last place in degrees, and not at all in radians
  close.law = "points = [[0, 0], [90, 1], [127, 2], [127.00000000000001, 2], [200, 1], [360, 0]]";
  EXPECT_TRUE(contains(mistakes_in(close), "has the same x as the point before"));
  Parts loose;
  loose.joint = R"(type = "slot"
between = ["ground.O", "follower.P"]
direction = [0, 1])";
  EXPECT_TRUE(contains(mistakes_in(loose), "follower needs one revolute or prismatic joint to ground"));
  Parts other;
  other.more_curves = R"(curves.disc = { type = "circle", center = [0, 0], radius = 30 })";
  other.between = R"(["cam.disc", "follower.roller"])";
  EXPECT_TRUE(contains(mistakes_in(other), "is a contact in which this curve does not take part"));
  Parts chain;
  chain.follower = R"({ type = "segment", from = [10, 0], to = [-10, 0] })";
  EXPECT_TRUE(contains(mistakes_in(chain), "the follower of a cam has a circle"));
  Parts rolling;
  rolling.between += "\nrolling = true";
  EXPECT_TRUE(contains(mistakes_in(rolling), "curves with ends or of several parts slip"));
}

// A lobe so steep and high that its sides come closer than the roller is wide: no radius of the path is
// smaller than the roller's, but the flank passes through itself. By the symmetry of the lobe about 52.5
// degrees the two places are as far from it on either side.
TEST(Flanks, ThatCrossThemselvesAreRefusedWithBothPlaces) {
  Parts neck;
  neck.height = "12";
  neck.law = R"(segments = [ { over = 45, law = "cycloidal", rise = 80 }, { over = 15, law = "dwell" },
             { over = 45, law = "cycloidal", rise = -80 }, { over = 255, law = "dwell" } ])";
  const std::string mistake = mistakes_in(neck);
  EXPECT_TRUE(contains(mistake, "bodies.cam.curves.flank.law = \"lift\": the flank crosses itself: at "));
  EXPECT_TRUE(contains(mistake, ", or a longer segment of the law"));
  const double first = number_behind(mistake, "itself: at "), second = number_behind(mistake, "and at ");
  EXPECT_NEAR(first + second, 105, 1e-3);
  // The roller's centre and the direction of its path there, in the cam's frame.
  const auto flank_point = [](double x) {
    const double u = x / 45, beta = kPi / 4;
    const double y = 12 + 80 * (u - std::sin(2 * kPi * u) / (2 * kPi));
    const double slope = 80 / beta * (1 - std::cos(2 * kPi * u));
    const Vector2d n = Vector2d(-slope, y).normalized();  // of the path (0, y) turned back by x
    return Rotation<double>::from_angle(-x * kPi / 180) * (Vector2d(0, y) - 10 * n);
  };
  // Mirrored in the axis of the lobe, the point is itself.
  const Vector2d axis = unit_vector(kPi / 2 - 52.5 * kPi / 180);
  EXPECT_NEAR(cross(axis, flank_point(first)), 0, 1e-3);
  neck.height = "40";
  EXPECT_EQ(mistakes_in(neck), "");
}

// What the message names has been tried: a little more than the limit does, a little less does not.
TEST(Flanks, ThatCrossThemselvesAreRefusedWithTheSizesThatWouldDo) {
  const auto neck = [](double height, double radius) {
    Parts parts;
    parts.height = fmt::format("{:.9g}", height);
    parts.follower = fmt::format("{{ type = \"circle\", center = [0, 0], radius = {:.9g} }}", radius);
    parts.law = R"(segments = [ { over = 45, law = "cycloidal", rise = 80 }, { over = 15, law = "dwell" },
             { over = 45, law = "cycloidal", rise = -80 }, { over = 255, law = "dwell" } ])";
    return mistakes_in(parts);
  };
  const std::string mistake = neck(12, 10);
  const double base = number_behind(mistake, "a base circle of more than ");
  EXPECT_NEAR(number_behind(mistake, "pose moved by "), base + 10 - 12, 1e-3);
  EXPECT_EQ(neck(base + 10 + 1e-3, 10), "");
  EXPECT_TRUE(contains(neck(0.997 * base + 10, 10), "crosses itself"));
  const double roller = number_behind(mistake, "a roller of less than ");
  EXPECT_EQ(neck(12, roller - 1e-3), "");
  EXPECT_TRUE(contains(neck(12, 1.003 * roller), "crosses itself"));
}

// The ends of a flank over a whole turn whose law does not repeat touch.
TEST(Flanks, MayEndWhereTheyBegin) {
  for (const char* follower :
       {R"({ type = "circle", center = [0, 0], radius = 10 })", R"({ type = "point", at = [0, 0] })"}) {
    Parts once;
    once.follower = follower;
    once.law = R"(segments = [ { over = 180, law = "cycloidal", rise = 20 },
             { over = 180, law = "parabolic", rise = -20 } ]
repeat = false)";
    EXPECT_EQ(mistakes_in(once), "");
    once.law = R"(segments = [ { over = 180, law = "polynomial", start = [0, 0.1], end = [20, 0] },
             { over = 180, law = "cycloidal", rise = -20 } ]
repeat = false)";
    EXPECT_EQ(mistakes_in(once), "");
  }
}

// The path of a knife edge beside the pivot, and that of an arm that swings across it, have no cusps.
TEST(Flanks, AreNotCalledUndercutWhereTheyPassThePivot) {
  Parts edge;
  edge.follower = R"({ type = "point", at = [3, 0] })";
  edge.height = "5";
  edge.law = R"(segments = [ { over = 180, law = "cycloidal", rise = -12 },
             { over = 180, law = "cycloidal", rise = 12 } ])";
  const std::string mistake = mistakes_in(edge);
  EXPECT_TRUE(contains(mistake, "the flank crosses itself"));
  EXPECT_FALSE(contains(mistake, "roller"));
}

TEST(Flanks, AreCutAnewForTolerancesAsANoteSays) {
  const auto notes = [](const std::string& path) {
    const auto profile = read_profile_text(
        profile_with({}) + "[tolerances]\nr = { path = \"" + path +
            "\", plus_minus = 0.05 }\nresults.y = { column = \"slide.position\", of = \"max\" }\n",
        "test.toml");
    EXPECT_TRUE(profile) << path;
    std::vector<std::string> texts;
    for (const Diagnostic& note : profile ? profile->notes : Diagnostics{}) texts.push_back(note.message);
    return texts;
  };
  EXPECT_TRUE(
      lines_are(notes("bodies.follower.curves.roller.radius"),
                {"tolerances.r: the flank cam.flank is cut anew for every value of "
                 "bodies.follower.curves.roller.radius, so that the other body moves by the law all the "
                 "same; to see what a deviation does to a flank that is cut once, `export` cam.flank and "
                 "read the file as its curve"}));
  for (const char* path : {"bodies.ground.points.O.0", "bodies.follower.pose.y", "joints.slide.direction.0",
                           "bodies.follower.points.P.0", "bodies.cam.points.O.1"}) {
    EXPECT_TRUE(lines_are(notes(path), {part(std::string("cut anew for every value of ") + path)}));
  }
  EXPECT_THAT(notes("laws.lift.segments.0.rise"), IsEmpty());
  EXPECT_THAT(notes("bodies.ground.points.Q.0"), IsEmpty());
}

}  // namespace
}  // namespace higherpair
