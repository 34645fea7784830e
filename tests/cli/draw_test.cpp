// The command draw on the command line.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>

namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

std::string read_file(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class Draw : public ::testing::Test {
protected:
  void SetUp() override {
    fs::create_directories(folder_);
    for (const char* name : {"four_bar", "lock_up", "ellipse_cam_roller"}) {
      fs::copy_file(std::string(HIGHERPAIR_SOURCE_DIR) + "/profiles/" + name + ".toml",
                    folder_ / (std::string(name) + ".toml"), fs::copy_options::overwrite_existing);
    }
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] Outcome run(const std::string& arguments) const {
    const std::string command = "cd " + folder_.string() + " && " + HIGHERPAIR_PROGRAM + " draw " +
                                arguments + " >" + (folder_ / "out").string() + " 2>" +
                                (folder_ / "err").string();
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder_ / "out"),
            read_file(folder_ / "err")};
  }

  fs::path folder_ = fs::temp_directory_path() / ("higherpair-draw-" + std::to_string(getpid()));
};

TEST_F(Draw, WritesAPicture) {
  EXPECT_EQ(run("four_bar.toml -o 'a picture.svg' --at 30 --trace coupler.A").code, 0);
  const std::string svg = read_file(folder_ / "a picture.svg");
  EXPECT_THAT(svg, HasSubstr("data-scale"));
  EXPECT_THAT(svg, HasSubstr("data-name=\"coupler.A\""));
  const Outcome piped = run("ellipse_cam_roller.toml -o - --every 45 --strip --width 200");
  EXPECT_EQ(piped.code, 0);
  EXPECT_THAT(piped.out, HasSubstr("width=\"1800\""));
  EXPECT_THAT(piped.err, IsEmpty());
}

TEST_F(Draw, SaysWhereThePositionCannotBeReached) {
  const Outcome outcome = run("lock_up.toml -o l.svg --at 100");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("driver = 100 cannot be reached; drawn at the limit position 65.83442"));
  EXPECT_TRUE(fs::exists(folder_ / "l.svg"));
}

TEST_F(Draw, DrawsRowsThatAreNotToBeTrusted) {
  const Outcome outcome =
      run("ellipse_cam_roller.toml -o r.svg --quiet --set 'driver.positions=[77]' --tolerance 1e-30");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(read_file(folder_ / "r.svg"), HasSubstr("data-role=\"contact\""));
}

TEST_F(Draw, RefusesWhatIsWrong) {
  const auto message = [&](const std::string& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_FALSE(fs::exists(folder_ / "w.svg")) << arguments;
    return outcome.err;
  };
  EXPECT_THAT(message("four_bar.toml -o w.svg --layers joints"),
              HasSubstr("--layers: there is no layer joints; did you mean `joint`?"));
  EXPECT_THAT(message("four_bar.toml -o w.svg --layers forces"),
              HasSubstr("--layers: there is no layer forces; did you mean `force`?"));
  EXPECT_THAT(message("four_bar.toml -o w.svg --layers force"), HasSubstr("there are no forces to draw"));
  EXPECT_THAT(message("four_bar.toml -o w.svg --trace E"),
              HasSubstr("there is no point E; there are ground.O2"));
  EXPECT_THAT(message("four_bar.toml -o w.svg --at 1 --every 2"), HasSubstr("--at excludes --every"));
  EXPECT_THAT(message("four_bar.toml -o w.svg --width 0"), HasSubstr("--width"));
  EXPECT_THAT(message("four_bar.toml -o ./four_bar.toml"), HasSubstr("is the file that is read as FILE"));
  EXPECT_THAT(message("four_bar.toml"), HasSubstr("--output is required"));
  EXPECT_THAT(message("none.toml -o w.svg"), HasSubstr("cannot be opened"));
  const Outcome folder = run("four_bar.toml -o none/w.svg");
  EXPECT_EQ(folder.code, 2);
  EXPECT_THAT(folder.err, HasSubstr("there is no folder none; make it first"));
}

}  // namespace
