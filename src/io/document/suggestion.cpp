#include "higherpair/io/diagnostic.hpp"
#include "higherpair/io/names.hpp"
#include "higherpair/numeric/contains.hpp"
#include "numeric/joined_words.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/core.h>

namespace higherpair {
namespace {

using io_detail::same_letter;

constexpr std::size_t kMostSuggestions = 3;
constexpr std::size_t kMostListed = 18;
constexpr std::size_t kShortestMisspelt = 5;  // of synonyms; shorter words are near to too many others
constexpr std::size_t kLongestCompared = 64;  // comparing takes time ~ length²

// How many single-character edits (insert, delete, replace, swap of neighbours) turn one name into the other;
// upper and lower case count as equal.
int edit_distance(std::string_view a, std::string_view b) {
  if (a.size() > kLongestCompared || b.size() > kLongestCompared) {
    return static_cast<int>(std::max(a.size(), b.size()));
  }
  // Rows i-2, i-1 and i of the table of distances between the first i letters of a and the first j of b.
  std::vector<int> before(b.size() + 1);
  std::vector<int> last(b.size() + 1);
  std::vector<int> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    row[j] = static_cast<int>(j);
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = last;
    last = row;
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replace = same_letter(a[i - 1], b[j - 1]) ? 0 : 1;
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + replace});
      if (i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1])) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

// One wrong letter is always allowed, and one more for every five letters; where that is half of the name,
// only if the first letter is right.
bool is_near(int distance, std::string_view name, std::string_view candidate) {
  const int size = static_cast<int>(name.size());
  const bool begins_alike = !candidate.empty() && !name.empty() && same_letter(name[0], candidate[0]);
  return distance <= 1 + size / 5 && distance < size &&
         (distance <= 1 || 2 * distance < size || begins_alike);
}

// Whether a name is the last word of another: "pivot" of "joints.pivot", "angle" of "pressure_angle".
bool is_end(std::string_view name, std::string_view whole) {
  const std::size_t before = whole.size() - name.size() - 1;
  return !name.empty() && whole.size() > name.size() + 1 && whole.ends_with(name) &&
         std::string_view("._-").find(whole[before]) != std::string_view::npos;
}

std::vector<std::string> nearest(std::string_view name, const std::vector<std::string>& existing) {
  struct Candidate {
    int distance;
    std::string_view name;
  };
  std::vector<Candidate> candidates;
  for (const std::string& candidate : existing) {
    const int distance = edit_distance(name, candidate);
    const bool run_on = candidate.size() >= 4 && name.starts_with(candidate);  // a dot may be missing here
    const bool cut_short = name.size() >= 3 && (candidate.starts_with(name) || is_end(name, candidate));
    if (is_near(distance, name, candidate) || run_on || cut_short || is_end(candidate, name) ||
        (name.size() == 1 && distance <= 1)) {
      candidates.push_back({distance, candidate});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(candidates.size(), kMostSuggestions); ++i) {
    names.emplace_back(candidates[i].name);
  }
  return names;
}

// A word of the profile format, and its names in textbooks and other programs.
struct Synonyms {
  std::string_view word;
  std::string_view others;  // separated by spaces, in lower case, with _ within
};

constexpr Synonyms kSynonyms[] = {
    // Tables.
    {"bodies", "links link members member elements body parts"},
    {"joints", "pairs pair lower_pairs constraints connections"},
    {"contacts", "higher_pairs higher_pair cams gears"},
    {"driver", "motor motion actuator input drive motors"},
    {"units", "unit_system"},
    {"title", "name label"},
    {"description", "comment comments notes text"},
    {"gravity", "g"},
    {"loads", "forces external_forces"},
    {"springs", "dampers"},
    {"ground", "frame base fixed fixed_link earth world chassis global absolute"},
    // Bodies.
    {"pose", "position placement location guess initial x y theta phi orientation angle rotation"},
    {"points", "pins nodes"},
    {"curves", "curve profile profiles shape shapes contour geometry"},
    {"mass", "weight m"},
    {"center_of_mass", "com cog cg center_of_gravity centre_of_mass centre_of_gravity centroid"},
    {"inertia", "moment_of_inertia mass_moment_of_inertia moi j i izz"},
    {"angle", "theta phi rotation orientation rot"},
    // Curves.
    {"conic", "quadric general implicit"},
    {"circle", "disc disk roller round ring hole"},
    {"ellipse", "oval"},
    {"line", "flat face plane straight flat_face"},
    {"point", "knife knife_edge edge tip corner"},
    {"center", "centre position origin middle cx cy"},
    {"chain", "polygon polyline rectangle contour outline composite"},
    {"spline", "nurbs bezier freeform b_spline interpolation"},
    {"radius", "r rad diameter d dia"},
    {"semi_axes", "a b axes semiaxes semi_axis radii half_axes major minor"},
    {"rotation", "angle theta phi tilt orientation rot"},
    {"vertex", "apex"},
    {"focal_length", "focus f focal focal_distance p parameter"},
    {"normal", "n outward direction"},
    {"point", "through origin position"},
    {"at", "position point location center xy"},
    {"coefficients", "coeffs equation"},
    {"near", "branch"},
    {"inside", "in inner interior convex solid"},
    {"outside", "out outer exterior concave hole hollow"},
    // Joints and contacts.
    {"revolute", "r pin hinge pivot rotary rotational rotation turning pinned bearing"},
    {"prismatic",
     "p slider slide sliding translational translation linear piston guide rail track guideway slideway"},
    {"slot", "pin_in_slot pin_slot pinslot slotted half_joint"},
    {"gears", "gear gear_pair gearing"},
    {"belt", "chain pulley pulleys toothed_belt belt_drive"},
    {"type", "kind joint_type"},
    {"between", "bodies connects points links curves pair connect a b body1 body2 from to"},
    {"direction", "axis dir along"},
    {"ratio", "i gear_ratio transmission teeth"},
    {"rolling", "roll no_slip noslip slip slipping"},
    {"nearest", "closest"},
    {"+", "plus positive"},
    {"-", "minus negative"},
    // Drivers.
    {"joint", "input crank"},
    {"start", "from begin first initial start_angle"},
    {"end", "to stop final last end_angle"},
    {"samples", "step steps n rows count increment resolution number num frames intervals divisions"},
    {"positions", "angles values points list"},
    {"velocity", "speed omega rpm rate angular_velocity"},
    {"acceleration", "alpha acc accel angular_acceleration"},
    {"duration", "time t_end end_time total_time t"},
    {"time_step", "step dt timestep delta_t"},
    // Laws.
    {"laws", "law motion_laws programs lifts"},
    {"segments", "parts phases sections"},
    {"over", "duration length range span beta angle"},
    {"rise", "lift stroke h by"},
    {"law", "type motion kind"},
    {"repeat", "periodic repeats closed cyclic"},
    {"smoothing", "smooth tolerance"},
    {"dwell", "rest pause hold stop"},
    {"uniform", "linear constant_velocity straight"},
    {"parabolic", "constant_acceleration parabola quadratic"},
    {"harmonic", "simple_harmonic shm cosine"},
    {"cycloidal", "cycloid sinusoidal sine"},
    {"modified-sine", "mod_sine modified_sinusoidal"},
    {"modified-trapezoid", "mod_trapezoid trapezoid modified_trapezoidal trapezoidal"},
    {"polynomial-345", "345 3_4_5 poly345 poly_345 3_4_5_polynomial polynomial_3_4_5 quintic"},
    {"polynomial-4567", "4567 4_5_6_7 poly4567 poly_4567 4_5_6_7_polynomial polynomial_4_5_6_7"},
    {"polynomial", "poly hermite"},
    {"harmonics", "fourier series"},
    // Loads and springs.
    {"torque", "moment"},
    {"body", "bodies local moving on"},
    {"stiffness", "k c rate constant spring_constant spring_rate"},
    {"damping", "c d damper viscous damping_constant"},
    {"free_length", "preload pretension prestress l0 length rest_length natural_length unstretched_length"},
    {"free_angle", "preload pretension prestress rest_angle natural_angle"},
    // Commands and options.
    {"analyze", "run simulate motion kinematics positions"},
    {"step", "time simulate dynamics"},
    {"forces", "force statics dynamics kinetostatics"},
    {"branches", "assemblies solutions"},
    {"mobility", "dof freedom grashof"},
    {"verify", "check test validate"},
    {"draw", "view show picture image svg display render"},
    {"report", "view show animate animation html page player interactive"},
    {"design", "optimize optimise optimization optimisation synth synthesis synthesize synthesise"},
    {"plot", "graph chart diagram"},
    {"polygon", "hodograph velocity_polygon"},
    {"sensitivity", "tolerances tolerance gradient scatter"},
    {"sweep", "vary variants batch parametric"},
    {"fit", "calibrate identify regression"},
    {"export", "dxf convert"},
    {"csv", "output out o"},
    {"json", "output out o"},
    {"samples", "rows n"},
    {"set", "define d override param parameter"},
    {"quiet", "q silent"},
    {"tolerance", "eps epsilon tol"},
    // Tasks.
    {"min", "minimum lower low least"},
    {"max", "maximum upper high most greatest largest"},
    {"maxabs", "absolute abs amplitude"},
    {"mean", "average avg"},
    {"range", "stroke swing peak_to_peak"},
    {"width", "wide breadth"},
    {"height", "high tall"},
    {"below", "max maximum upper less"},
    {"above", "min minimum lower greater"},
    {"plus_minus", "tolerance tol deviation"},
    {"random", "monte_carlo"},
    // Units.
    {"m", "meter meters metre metres"},
    {"mm", "millimeter millimeters millimetre millimetres"},
    {"cm", "centimeter centimeters centimetre centimetres"},
    {"um", "micron microns micrometer micrometre"},
    {"km", "kilometer kilometre"},
    {"in", "inch inches"},
    {"ft", "foot feet"},
    {"deg", "degree degrees grad"},
    {"rad", "radian radians"},
    {"rev", "turn turns revolution revolutions u"},
    {"rpm", "upm rev_per_min"},
    {"kg", "kilogram kilograms kilo"},
    {"g", "gram grams"},
    {"lb", "pound pounds lbs lbm"},
    {"s", "sec second seconds"},
    {"ms", "millisecond milliseconds msec"},
    {"min", "minute minutes"},
    {"N", "newton newtons"},
    {"kN", "kilonewton kilonewtons"},
    {"lbf", "pound_force"},
};

std::string normal_word(std::string_view name) {
  std::string word(name);
  for (char& c : word) {
    c = c == '-' || c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return word;
}

// Whether a word is among `words`, but for so many wrong letters.
bool is_among(std::string_view word, std::string_view words, int wrong) {
  while (!words.empty()) {
    const std::string_view next = words.substr(0, words.find(' '));
    if (wrong == 0 ? next == word : edit_distance(next, word) <= wrong) return true;
    words.remove_prefix(std::min(words.size(), next.size() + 1));
  }
  return false;
}

// The existing names that `name` is a synonym of, but for so many wrong letters.
std::vector<std::string> meant(std::string_view name, const std::vector<std::string>& existing,
                               int wrong = 0) {
  const std::string word = normal_word(name);
  std::vector<std::string> names;
  for (const Synonyms& synonyms : kSynonyms) {
    if (is_among(word, synonyms.others, wrong) && contains(existing, synonyms.word)) {
      names.emplace_back(synonyms.word);
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace

std::vector<std::string> meant_names(std::string_view name, const std::vector<std::string>& existing) {
  std::vector<std::string> names = meant(name, existing);
  if (names.empty()) {
    names = nearest(name, existing);
  }
  if (names.empty() && name.size() >= kShortestMisspelt) {
    names = meant(name, existing, 1);
  }
  return names;
}

std::string did_you_mean(const std::vector<std::string>& meant) {
  std::vector<std::string> names;
  for (const std::string& name : meant) names.push_back(fmt::format("`{}`", name));
  return names.empty() ? "" : fmt::format("did you mean {}?", joined_words(names, " or "));
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& existing) {
  return did_you_mean(meant_names(name, existing));
}

bool is_synonym(std::string_view name, std::string_view word) {
  return !meant(name, {std::string(word)}).empty();
}

std::string suggestion(std::string_view name, const std::vector<std::string>& existing) {
  if (existing.empty()) {
    return "none is defined";
  }
  std::string likely = did_you_mean(name, existing);
  if (!likely.empty()) {
    return likely;
  }
  const auto listed = std::min(existing.size(), kMostListed);
  return fmt::format("there {} {}{}", existing.size() == 1 ? "is only" : "are",
                     joined_words(std::span(existing).first(listed)), listed < existing.size() ? ", …" : "");
}

}  // namespace higherpair
