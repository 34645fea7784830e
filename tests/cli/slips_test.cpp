// The program's answers to mistakes on its command line and in otherwise valid profiles.
#include "program_testing.hpp"
#include "support/texts.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/wait.h>
#include <vector>

#include <fmt/core.h>
#include <gmock/gmock.h>

namespace {

using higherpair::testing::contains;
using higherpair::testing::Outcome;
using higherpair::testing::ProgramTest;
using higherpair::testing::read_file;
using higherpair::testing::shipped_profile;
namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

class Slips : public ProgramTest {
protected:
  void SetUp() override {
    ProgramTest::SetUp();
    fs::copy_file(shipped_profile("four_bar.toml"), profile_, fs::copy_options::overwrite_existing);
    text_ = read_file(profile_);
  }

  [[nodiscard]] Outcome run(const std::string& arguments) const { return run_program(arguments); }

  const fs::path profile_ = folder_ / "p.toml";
  std::string text_;
};

TEST_F(Slips, AnEmptyNameIsNoFile) {
  for (const std::string arguments : {"analyze ''",
                                      "analyze p.toml --csv ''",
                                      "step p.toml --json ''",
                                      "forces p.toml --events ''",
                                      "branches ''",
                                      "mobility p.toml --json ''",
                                      "map p.toml -o ''",
                                      "draw p.toml -o ''",
                                      "export p.toml --curve a.b -o ''",
                                      "plot p.toml --y driver -o ''",
                                      "polygon p.toml --at 0 -o ''",
                                      "report p.toml -o ''",
                                      "check ''",
                                      "sweep p.toml -o ''",
                                      "sensitivity p.toml --rows ''",
                                      "design p.toml -o ''",
                                      "fit '' p.toml",
                                      "fit p.toml p.csv -o ''",
                                      "verify p.toml ''",
                                      "verify --json ''"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_TRUE(contains(outcome.err, ": is empty; see higherpair ")) << arguments;
    EXPECT_THAT(outcome.out, IsEmpty()) << arguments;
  }
}

// Otherwise a search would be finished before its result turns out to be unwritable.
TEST_F(Slips, EveryCommandRefusesAnOutputThatHasNoPlaceBeforeTheWork) {
  fs::create_directories(folder_ / "folder.svg");
  for (const std::string arguments : {"analyze p.toml --csv ",
                                      "analyze p.toml --hdf5 ",
                                      "analyze p.toml --csv t --events ",
                                      "step p.toml --json ",
                                      "forces p.toml --csv ",
                                      "branches p.toml --json ",
                                      "mobility p.toml --csv ",
                                      "check p.toml --json ",
                                      "map p.toml --csv ",
                                      "map p.toml -o ",
                                      "draw p.toml -o ",
                                      "plot p.toml --y slider.x -o ",
                                      "polygon p.toml --at 0 -o ",
                                      "export p.toml --curve a.b -o ",
                                      "sensitivity p.toml --csv ",
                                      "sensitivity p.toml --rows ",
                                      "design p.toml -o ",
                                      "design p.toml -o t --report ",
                                      "fit p.toml m.csv -o ",
                                      "fit p.toml m.csv -o t.toml --json ",
                                      "fit --curve circle m.csv --csv ",
                                      "verify --json "}) {
    const Outcome missing = run(arguments + "none/t.svg");
    EXPECT_EQ(missing.code, 1) << arguments;
    EXPECT_TRUE(contains(missing.err, "none/t.svg: there is no folder none; make it first (mkdir -p), or "))
        << arguments;
    const Outcome folder = run(arguments + "folder.svg");
    const bool is_hdf5 = arguments.find("hdf5") != std::string::npos;  // wants a name that ends in .h5 first
    EXPECT_EQ(folder.code, is_hdf5 ? 2 : 1) << arguments;
    if (!is_hdf5) {
      EXPECT_TRUE(contains(folder.err, "folder.svg is a folder; name a file in it")) << arguments;
    }
  }
  for (const std::string arguments : {"sweep p.toml -o none/t.csv", "report p.toml -o none/t.html"}) {
    const Outcome missing = run(arguments);
    EXPECT_EQ(missing.code, 1) << arguments;
    EXPECT_TRUE(contains(missing.err, "there is no folder none; make it first (mkdir -p), or ")) << arguments;
  }
}

TEST_F(Slips, AnOutputThatTheMachineDoesNotTakeIsAFailureOfTheMachine) {
  for (const std::string arguments :
       {"analyze p.toml --csv", "mobility p.toml --json", "check p.toml --json"}) {
    const Outcome outcome = run(arguments + " /dev/full");
    EXPECT_EQ(outcome.code, 1) << arguments;
    EXPECT_TRUE(contains(outcome.err, "cannot write /dev/full: No space left on device")) << arguments;
  }
}

TEST_F(Slips, AnOutputThatIsTheProfileIsRefused) {
  fs::create_symlink("p.toml", folder_ / "link");
  fs::create_symlink("link", folder_ / "link_to_link");
  fs::create_hard_link(profile_, folder_ / "hard");
  for (const std::string command : {"analyze", "step", "forces", "branches", "mobility", "map"}) {
    for (const std::string& path :
         std::vector<std::string>{"p.toml", "./p.toml", "../" + folder_.filename().string() + "/p.toml",
                                  profile_.string(), "link", "link_to_link", "hard"}) {
      for (const std::string option : {"--csv", "--json"}) {
        const Outcome outcome = run(command + " p.toml " + option + " " + path);
        EXPECT_EQ(outcome.code, 2) << command << path;
        EXPECT_TRUE(contains(
            outcome.err,
            option + ": " + path + " is the file that is read as FILE; give the output a name of its own"));
        EXPECT_THAT(outcome.out, IsEmpty());
      }
    }
  }
  EXPECT_EQ(run("analyze link --csv p.toml").code, 2);
  EXPECT_EQ(run("analyze p.toml --csv a --json a").code, 2);
  EXPECT_EQ(read_file(profile_), text_);
}

TEST_F(Slips, AnInputOfVerifyIsNotWrittenTo) {
  std::ofstream(folder_ / "table.csv") << "driver[deg]\n0\n";
  EXPECT_TRUE(
      contains(run("verify p.toml table.csv --json table.csv").err, "is the file that is read as TABLE"));
  EXPECT_EQ(run("verify p.toml table.csv --json p.toml").code, 2);
  EXPECT_EQ(read_file(folder_ / "table.csv"), "driver[deg]\n0\n");
  EXPECT_EQ(read_file(profile_), text_);
}

// Also through links, whose extensions are those that the outputs have to have.
TEST_F(Slips, AnOutputThatTheProfileReadsIsRefusedByEveryCommand) {
  copy_profiles({"spline_cam"});
  fs::copy_file(shipped_profile("spline_cam.csv"), folder_ / "spline_cam.csv");
  for (const char* link : {"link.svg", "link.html", "link.toml", "link.h5"}) {
    fs::create_symlink("spline_cam.csv", folder_ / link);
  }
  std::ofstream(folder_ / "table.csv") << "driver[deg],follower.angle[deg]\n0,0\n";
  const std::string points = file("spline_cam.csv");
  for (const std::string arguments : {"analyze spline_cam.toml --csv spline_cam.csv",
                                      "step spline_cam.toml --json spline_cam.csv",
                                      "forces spline_cam.toml --hdf5 link.h5",
                                      "analyze spline_cam.toml --events spline_cam.csv",
                                      "branches spline_cam.toml --csv spline_cam.csv",
                                      "mobility spline_cam.toml --json spline_cam.csv",
                                      "check spline_cam.toml --csv spline_cam.csv",
                                      "map spline_cam.toml --csv spline_cam.csv",
                                      "map spline_cam.toml -o link.svg",
                                      "draw spline_cam.toml -o link.svg",
                                      "plot spline_cam.toml --y follower.alpha -o link.svg",
                                      "polygon spline_cam.toml --at 30 -o link.svg",
                                      "export spline_cam.toml --curve cam.outline -o spline_cam.csv",
                                      "report spline_cam.toml -o link.html",
                                      "sensitivity spline_cam.toml --json spline_cam.csv",
                                      "sensitivity spline_cam.toml --rows spline_cam.csv",
                                      "fit spline_cam.toml table.csv -o link.toml",
                                      "fit spline_cam.toml table.csv -o o --csv spline_cam.csv",
                                      "design spline_cam.toml -o link.toml",
                                      "design spline_cam.toml -o o --report link.html",
                                      "sweep spline_cam.toml -o spline_cam.csv",
                                      "verify spline_cam.toml table.csv --json spline_cam.csv"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_THAT(
        outcome.err,
        AnyOf(
            HasSubstr(" is the file that is read as part of the profile; give the output a name of its own"),
            HasSubstr("built without HDF5")))
        << arguments;
    EXPECT_THAT(outcome.out, IsEmpty()) << arguments;
    EXPECT_EQ(file("spline_cam.csv"), points) << arguments;
  }
}

TEST_F(Slips, StandardOutputThatGoesIntoTheProfileIsRefused) {
  const std::string command =
      "cd " + folder_.string() + " && " + HIGHERPAIR_PROGRAM + " analyze p.toml >>p.toml 2>err";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_EQ(read_file(profile_), text_);
}

TEST_F(Slips, StandardOutputThatGoesIntoATableThatTheProfileReadsIsRefused) {
  const std::string profiles = HIGHERPAIR_SOURCE_DIR "/profiles/";
  for (const char* name : {"camshaft_lift_table.toml", "camshaft_lift_table.csv"}) {
    fs::copy_file(profiles + name, folder_ / name);
  }
  const std::string table = read_file(folder_ / "camshaft_lift_table.csv");
  const std::string command = "cd " + folder_.string() + " && " + HIGHERPAIR_PROGRAM +
                              " analyze camshaft_lift_table.toml >>camshaft_lift_table.csv 2>err";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 2);
  EXPECT_EQ(read_file(folder_ / "camshaft_lift_table.csv"), table);
}

TEST_F(Slips, ForcesOfAMechanismThatNothingLoadsAreNoted) {
  const std::string four_bar = HIGHERPAIR_SOURCE_DIR "/profiles/four_bar.toml";
  EXPECT_TRUE(contains(run("forces " + four_bar).err, "note: nothing loads the mechanism"));
  EXPECT_FALSE(contains(run("forces " + four_bar +
                            " --set bodies.crank.mass=1 --set bodies.crank.center_of_mass=[0,0] "
                            "--set bodies.crank.inertia=1")
                            .err,
                        "nothing loads"));
}

// Nothing balances a moment about the pin of a roller that slips; 7 N at 15 mm make 105 N mm, 0.1 kg at 4 mm
// in gravity make 3.9 N mm where its weight is level with the pin, as in the pose.
TEST_F(Slips, AMomentOnABodyThatTurnsFreelyIsNoted) {
  const std::string forces = "forces " + shipped_profile("roller_body.toml") + " --csv /dev/null ";
  const std::string load = "--set loads.t.body=roller --set loads.t.torque=0 --set 'loads.t.force=[0,7]' ";
  const std::string mass =
      "--set bodies.roller.mass=0.1 --set bodies.roller.inertia=10 --set 'gravity=[0,-9.81]' ";
  const auto note = [](const std::string& moment) {
    return HasSubstr("note: bodies.roller: it turns freely, and nothing balances the moment about its pin, " +
                     moment);
  };
  EXPECT_THAT(run(forces + "--set loads.t.body=roller --set loads.t.torque=1000").err,
              note("1000 N*mm at driver = "));
  EXPECT_THAT(run(forces + "--set driver.samples=9001 --threads 2 --set loads.t.point=M " + load).err,
              note("105 N*mm at driver = "));
  EXPECT_THAT(run(forces + mass + "--set 'bodies.roller.center_of_mass=[4,0]'").err, note("-"));
  EXPECT_THAT(run("check " + shipped_profile("roller_body.toml") +
                  " --set loads.t.body=roller --set loads.t.torque=3")
                  .err,
              note("3 N*mm"));
  for (const std::string& balanced :
       {load + "--set loads.t.point=P", mass + "--set 'bodies.roller.center_of_mass=[0,0]'",
        load + "--set loads.t.point=M --set contacts.touch.rolling=true"}) {
    EXPECT_FALSE(contains(run(forces + balanced).err, "note: bodies.roller")) << balanced;
  }
}

TEST_F(Slips, AContactThatNeverTouchesIsNotedByAllCommandsThatRunThePath) {
  const std::string missed = shipped_profile("geneva_four_slots.toml") +
                             " --set bodies.crank.curves.pin.at=[50,0] --set driver.samples=5 "
                             "--set driver.duration=6 --set driver.time_step=1";
  for (const std::string command : {"analyze", "step", "forces", "check",
                                    "sensitivity --results wheel.angle:max --by bodies.wheel.pose.x",
                                    "plot --y driver -o p.svg", "report -o p.html"}) {
    const Outcome outcome = run(command + " " + missed);
    if (outcome.err.find("built without the page") != std::string::npos) continue;
    EXPECT_TRUE(contains(outcome.err, "note: contacts.drive: the two bodies touch nowhere on the path"))
        << command;
    EXPECT_FALSE(contains(run(command + " --quiet " + missed).err, "note:")) << command;
  }
}

TEST_F(Slips, DevicesAndPipesMayBeNamedTwice) {
  EXPECT_EQ(run("analyze p.toml --csv /dev/null --json /dev/null").code, 0);
  EXPECT_EQ(run("analyze p.toml --csv new.csv --json new.json").code, 0);
}

TEST_F(Slips, NotesGoToStandardErrorAndChangeNothing) {
  const Outcome plain = run("analyze p.toml");
  const Outcome noted = run("analyze p.toml --set 'gravity=[0,-9.81]'");
  EXPECT_EQ(noted.code, plain.code);
  EXPECT_EQ(noted.out, plain.out);
  EXPECT_TRUE(
      contains(noted.err, "--set gravity=[0,-9.81]: note: gravity = [0, -9.81]: 0.01 times the earth's"));
  EXPECT_FALSE(contains(plain.err, "note:"));
  EXPECT_FALSE(contains(run("analyze p.toml --quiet --set 'gravity=[0,-9.81]'").err, "note:"));
  for (const std::string command : {"branches", "mobility"}) {
    EXPECT_TRUE(contains(run(command + " p.toml --set 'gravity=[0,-9.81]'").err, "note:"));
    EXPECT_FALSE(contains(run(command + " p.toml --quiet --set 'gravity=[0,-9.81]'").err, "note:"));
  }
}

TEST_F(Slips, UnknownOptionsAndCommandsGetTheNearest) {
  const auto message = [&](const std::string& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2);
    return outcome.err;
  };
  EXPECT_EQ(message("analyze p.toml --cvs a.csv"),
            "higherpair: analyze has no option --cvs; did you mean `--csv`?\n");
  EXPECT_EQ(message("analyze p.toml --rows=7"),
            "higherpair: analyze has no option --rows; did you mean `--samples`?\n");
  EXPECT_EQ(message("step p.toml --output a"),
            "higherpair: step has no option --output; did you mean `--csv` or `--json`?\n");
  EXPECT_EQ(message("mobility p.toml --wibble"),
            "higherpair: mobility has no option --wibble; see higherpair mobility --help\n");
  EXPECT_EQ(message("analyze p.toml --cert"),
            "higherpair: analyze has no option --cert; see higherpair analyze --help\n");
  EXPECT_EQ(message("analyze p.toml --forces"),
            "higherpair: analyze has no option --forces; did you mean the command `higherpair forces`?\n");
  EXPECT_EQ(message("analyze p.toml --positions 3"),
            "higherpair: analyze has no option --positions; it is a key of the profile's driver: "
            "--set driver.positions=…\n");
  EXPECT_EQ(message("analyze p.toml --speed=3"),
            "higherpair: analyze has no option --speed; it is a key of the profile's driver: "
            "--set driver.velocity=…\n");
  EXPECT_TRUE(contains(message("verify p.toml --samples 3"), "verify has no option --samples"));
  EXPECT_EQ(message("help"), "higherpair: there is no command help; did you mean `higherpair --help`?\n");
  EXPECT_EQ(message("version"),
            "higherpair: there is no command version; did you mean `higherpair --version`?\n");
  EXPECT_EQ(message("analyze p.toml q.toml"), "higherpair: analyze does not take `q.toml`\n");
  EXPECT_EQ(message("analyse p.toml"),
            "higherpair: there is no command analyse; did you mean `analyze`? See higherpair --help\n");
  EXPECT_EQ(
      message("simulate p.toml"),
      "higherpair: there is no command simulate; did you mean `analyze` or `step`? See higherpair --help\n");
}

TEST_F(Slips, WordsOfOtherProgramsGetTheCommand) {
  for (const auto& [word, command] :
       {std::pair("optimize", "`design`"), std::pair("synth", "`design`"), std::pair("animate", "`report`"),
        std::pair("view", "`draw` or `report`")}) {
    EXPECT_EQ(run(word + std::string(" p.toml")).err,
              fmt::format("higherpair: there is no command {}; did you mean {}? See higherpair --help\n",
                          word, command));
    EXPECT_EQ(run(fmt::format("analyze p.toml --{}", word)).err,
              fmt::format("higherpair: analyze has no option --{}; as a command, did you mean {}?\n", word,
                          command));
  }
}

TEST_F(Slips, ArgumentsThatCannotBeTakenGetASentenceAndARemedy) {
  const auto message = [&](const std::string& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    return outcome.err;
  };
  const std::string help = "; see higherpair analyze --help\n";
  EXPECT_EQ(message("analyze p.toml --samples ten"), "higherpair: --samples ten: must be an integer" + help);
  EXPECT_EQ(message("analyze p.toml --samples 3.5"), "higherpair: --samples 3.5: must be an integer" + help);
  EXPECT_EQ(
      message("analyze p.toml --tolerance 1e-9,5"),
      "higherpair: --tolerance: '1e-9,5' is no number above 0; decimals are written with a point" + help);
  const std::string point = "; a decimal number is written with a point: ";
  EXPECT_EQ(message("analyze p.toml --tolerance 0,5"),
            "higherpair: --tolerance: '0,5' is no number above 0" + point + "0.5" + help);
  EXPECT_EQ(message("draw p.toml -o t.svg --at 30,5"),
            "higherpair: --at: '30,5' is no number" + point + "30.5; see higherpair draw --help\n");
  EXPECT_TRUE(contains(message("draw p.toml -o t.svg --every 30,5"), point + "30.5;"));
  EXPECT_TRUE(contains(message("draw p.toml -o t.svg --width 720,5"), point + "720.5;"));
  EXPECT_EQ(message("design p.toml --seed one"),
            "higherpair: --seed one: must be an integer; see higherpair design --help\n");
  EXPECT_TRUE(contains(message("design p.toml --seed -1"), "--seed: '-1' is negative"));
  EXPECT_EQ(message("analyze p.toml --csv"), "higherpair: --csv needs a value" + help);
  EXPECT_EQ(message("analyze p.toml --csv a --csv b"), "higherpair: --csv is given more than once" + help);
  EXPECT_EQ(message("analyze p.toml --csv --quiet"),
            "higherpair: --csv: a value is missing before --quiet" + help);
  EXPECT_EQ(message("draw p.toml --trace -o t.svg"),
            "higherpair: --trace: a value is missing before -o; see higherpair draw --help\n");
  EXPECT_EQ(message("analyze p.toml -- --csv"),
            "higherpair: higherpair has no option --csv; see higherpair --help\n");
  EXPECT_EQ(message("analyze"), "higherpair: FILE is required" + help);
  EXPECT_EQ(
      message("p.toml"),
      "higherpair: there is no command p.toml; did you mean `higherpair analyze p.toml`? See higherpair "
      "--help\n");
  EXPECT_EQ(message("--verson"),
            "higherpair: higherpair has no option --verson; did you mean `--version`?\n");
  EXPECT_THAT(message(""), StartsWith("higherpair: a command is missing: one of analyze, step, "));
}

TEST_F(Slips, AStartThatCannotBeAssembledNamesThoseThatCan) {
  const Outcome outcome = run("analyze " + shipped_profile("lock_up.toml") + " --set driver.start=90");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_TRUE(
      contains(outcome.err, "; it is possible, for example, with driver.start from -65.8 to 65.8 deg\n"));
}

}  // namespace
