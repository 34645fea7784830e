#include "io/profile_testing.hpp"
#include "support/texts.hpp"

#include <initializer_list>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace higherpair {
namespace {

using testing::lines_are;
using testing::messages;

struct Slip {
  const char* text;
  const char* message;  ///< without "test.toml:"
};

void expect_messages(std::initializer_list<Slip> slips) {
  for (const Slip& slip : slips) {
    EXPECT_TRUE(lines_are(messages(slip.text), {"test.toml:" + std::string(slip.message)})) << slip.text;
  }
}

// Strings: quotation marks, and the words that need them.
TEST(SyntaxMessages, OfTextsSayWhatWasDoneAndWhatToDo) {
  expect_messages(
      {Slip{"[joints.j]\ntype = \"revolute\n",
            "2:8: the closing quotation mark \" of this text is missing on its line"},
       Slip{"title = 'cam\n", "1:9: the closing quotation mark ' of this text is missing on its line"},
       Slip{"title = \"cam", "1:9: the closing quotation mark \" of this text is missing on its line"},
       Slip{"between = [\"a.b\", \"c.d]\nx = 3\n",
            "1:19: the closing quotation mark \" of this text is missing on its line"},
       Slip{"between = [\"a.b, \"c.d\"]\n",
            "1:19: a quotation mark \" is missing in this line, before or after `c`"},
       Slip{"points.O = [0, 0]\"\n",
            "1:18: there is a quotation mark \" too many here, or one is missing before"},
       Slip{"title = \"\"\"cam\n\n", "1:9: this text in \"\"\" is not closed"},
       Slip{"title = “cam”\n",
            "1:9: “ is a typographic quotation mark, not the one of the keyboard; write the plain \""},
       Slip{"between = [\"a.b\", “c.d”]\n",
            "1:19: “ is a typographic quotation mark, not the one of the keyboard; write the plain \""},
       Slip{"title = \"cam”\n",
            "1:13: ” is a typographic quotation mark, not the one of the keyboard; write the plain \""},
       Slip{"type = revolute\n", "1:8: a text is written in quotes: \"revolute\""},
       Slip{"between = [ground.O, cam.O]\n", "1:12: a text is written in quotes: \"ground.O\""},
       Slip{"type = revolute\"\n", "1:8: the opening quotation mark of `revolute\"` is missing"},
       Slip{"rolling = True\n", "1:11: write true instead of `True`"},
       Slip{"rolling = yes\n", "1:11: write true instead of `yes`"},
       Slip{"rolling = off\n", "1:11: write false instead of `off`"},
       Slip{"rolling = tru\n", "1:11: write true instead of `tru`"},
       Slip{"end = none\n", "1:7: leave the key out where it has no value"},
       Slip{"title = \"C:\\cams\"\n",
            "1:9: a backslash begins an escape within \"…\": write it twice, or the text in single quotes "
            "'…'"},
       Slip{"title = \"a\x01z\"\n", "1:11: a control character within a text"}});
}

TEST(SyntaxMessages, OfNumbersSayWhatWasDoneAndWhatToDo) {
  expect_messages(
      {Slip{"radius = 30,5\n", "1:10: a decimal number is written with a point: 30.5"},
       Slip{"radius = 0,125\n", "1:10: a decimal number is written with a point: 0.125"},
       Slip{"radius = 1234,567\n", "1:10: a decimal number is written with a point: 1234.567"},
       Slip{"radius = -0,25 # mm\n", "1:10: a decimal number is written with a point: -0.25"},
       Slip{"roller = { center = [0, 0], radius = 30,5 }\n",
            "1:38: a decimal number is written with a point: 30.5"},
       Slip{"pose = { x = -1,25, y = 2 }\n", "1:14: a decimal number is written with a point: -1.25"},
       Slip{"pose = { x = 1,5 mm }\n", "1:14: a decimal number is written with a point: 1.5"},
       Slip{"pose = { x = +1,5 }\n", "1:14: a decimal number is written with a point: +1.5"},
       Slip{"pose = { x = 1.30,5 }\n", "1:19: expected = after the key `5`"},
       Slip{"pose = { x = 1e-5,3 }\n", "1:19: expected = after the key `3`"},
       Slip{"radius = 1,000.5\n", "1:10: write 1000.5: no separator of thousands"},
       Slip{"samples = 1,000\n",
            "1:11: a decimal number is written with a point: 1.000; if thousands are meant, write 1000"},
       Slip{"pose = { x = 1,000 }\n",
            "1:14: a decimal number is written with a point: 1.000; if thousands are meant, write 1000"},
       Slip{"samples = 1,000,000\n", "1:11: write 1000000: no separator of thousands"},
       Slip{"velocity = 1.000,5\n",
            "1:12: write 1000.5: no separator of thousands, and a point for decimals"},
       Slip{"pose = { x = 1.000,5 }\n",
            "1:14: write 1000.5: no separator of thousands, and a point for decimals"},
       Slip{"samples = 1'000\n", "1:11: write 1000: no separator of thousands"},
       Slip{"samples = 1 000 # rows\n", "1:11: write 1000: no separator of thousands"},
       Slip{"points = 1,5,2\n", "1:11: several values are a list in brackets: [1, 2]"},
       Slip{"radius = 30 mm\n", "1:10: a number with its unit is written in quotes: \"30 mm\""},
       Slip{"radius = 30mm # disc\n", "1:10: a number with its unit is written in quotes: \"30 mm\""},
       Slip{"velocity = 60 rpm\n", "1:12: a number with its unit is written in quotes: \"60 rpm\""},
       Slip{"gravity = [0, 9.81 m/s^2]\n",
            "1:15: a number with its unit is written in quotes: \"9.81 m/s^2\""},
       Slip{"elastic_modulus = 210 GPa\n", "1:19: a number with its unit is written in quotes: \"210 GPa\""},
       Slip{"angle = 30°\n", "1:9: a number with its unit is written in quotes: \"30 deg\""},
       Slip{"radius = 2\"\n", "1:10: a number with its unit is written in quotes: \"2 in\""},
       Slip{"radius = .5\n", "1:10: .5 is written 0.5 in TOML"},
       Slip{"radius = 5.\n", "1:10: 5. is written 5.0 in TOML"},
       Slip{"radius = -05.5\n", "1:10: -05.5 is written -5.5 in TOML"},
       Slip{"radius = 1e400\n", "1:10: 1e400 is too large for a number"},
       Slip{"radius = −5\n", "1:10: − is a dash, not the minus sign of the keyboard; write the plain -"},
       Slip{"radius =\u00a05\n",
            "1:9: the blank here (U+00A0) is not an ordinary one: replace it by a space"},
       Slip{"radius = 5\u2028end = 3\n",
            "1:11: the line end here (U+2028) is not an ordinary one: begin a new line instead"},
       Slip{"radius = 5\u0085end = 3\n",
            "1:11: the line end here (U+0085) is not an ordinary one: begin a new line instead"},
       Slip{"rad\u00adius = 5\n", "1:4: the invisible character here (U+00AD) is out of place: remove it"},
       Slip{"angle = pi/2\n", "1:9: nothing is worked out here: write the number instead of `pi/2`"},
       Slip{"ratio = 1/3\n", "1:9: nothing is worked out here: write the number instead of `1/3`"},
       Slip{"radius = sqrt(2)\n", "1:10: nothing is worked out here: write the number instead of `sqrt(2)`"},
       Slip{"radius = +-3\n",
            "1:10: `+-3` is no value: expected a number, a \"text\" in quotes, true, false, or a [list]"},
       Slip{"radius = 5 6\n", "1:12: nothing but a comment may follow the value on its line: `6`"},
       Slip{"radius =\n", "1:9: a value is missing after the ="}});
}

TEST(SyntaxMessages, OfListsAndTablesSayWhatWasDoneAndWhatToDo) {
  expect_messages(
      {Slip{"[bodies.cam]\npose = { x = 1,\n  y = 2 }\n",
            "2:8: the table that { begins here must be closed by } on the same line; longer ones are "
            "written as a table "
            "of their own, [bodies.cam.pose], with a line for each key"},
       Slip{"pose = { x = 1\n",
            "1:8: the table that { begins here must be closed by } on the same line; longer ones are "
            "written as a table "
            "of their own, [pose], with a line for each key"},
       Slip{"pose = { x = 1, }\n", "1:17: there is a comma too many here"},
       Slip{"pose = { x = 1 y = 2 }\n", "1:16: a comma is missing before `y = 2 }`"},
       Slip{"pose = { x = 1; y = 2 }\n", "1:15: write a comma instead of the semicolon"},
       Slip{"pose = { x: 1 }\n", "1:11: key and value are joined by =, not by :"},
       Slip{"center = [10 0]\n", "1:14: a comma is missing before `0]`"},
       Slip{"pose = x = 1, y = 2 }\n", "1:8: keys within a value are a table in braces: { x = 1, ... }"},
       Slip{"pose = { x = , y = 2 }\n", "1:14: a value is missing here"},
       Slip{"center = [10,, 0]\n", "1:14: there is a comma too many here"},
       Slip{"center = [10, 0\nradius = 3\n", "1:10: the list that [ begins here is not closed by ]"},
       Slip{"center = [10, 0\n[driver]\n", "1:10: the list that [ begins here is not closed by ]"},
       Slip{"center = (10, 0)\n", "1:10: a list is written in brackets: [1, 2]"},
       Slip{"center = 10, 0\n", "1:12: several values are a list in brackets: [1, 2]"},
       Slip{"center = [10, 0]]\n", "1:17: this ] closes nothing: there is one too many"}});
}

TEST(SyntaxMessages, OfKeysAndHeadingsSayWhatWasDoneAndWhatToDo) {
  expect_messages(
      {Slip{"format = 1\n[driver]\njoint = \"a\"\n[driver]\nend = 3\n",
            "4:1: [driver] is here a second time after line 2: put all its keys under one heading (several "
            "drivers are "
            "tables [drivers.NAME])"},
       Slip{"[bodies.cam]\n[joints.j]\n[bodies.cam]\n",
            "3:1: [bodies.cam] is here a second time after line 1: put all its keys under one heading"},
       Slip{"pose = { x = 1 }\n[pose]\ny = 1\n",
            "2:1: [pose] is written in line 1 already, as a key: put all its keys there"},
       Slip{"[bodies.ground]\n[[bodies]]\nname = \"crank\"\n",
            "2:1: [[bodies]] begins a list: write [bodies.NAME], each with a name of its own"},
       Slip{"[a]\nradius = 1\nradius = 2\n",
            "3:1: `radius` is here a second time after line 2: keep one of them"},
       Slip{"pose = { x = 1 }\npose.y = 2\n",
            "2:1: `pose.y` is written in line 1 already, as a whole: put all of it there"},
       Slip{"[bodies.crank.points]\nO = [0, 0]\n[bodies.crank]\npoints.A = [1, 0]\n",
            "4:1: `points.A` belongs to [bodies.crank.points] in line 1, where all keys of that table must "
            "be: "
            "put `A` there"},
       Slip{"[bodies.crank.curves.disc]\n[bodies.crank]\ncurves.disc.radius = 3\n",
            "3:1: `curves.disc.radius` belongs to [bodies.crank.curves.disc] in line 1, where all keys of "
            "that "
            "table must be: put `radius` there"},
       Slip{"[bodies.crank]\n[bodies]\ncrank.points.O = [0, 0]\n",
            "3:1: `crank.points.O` belongs to [bodies.crank] in line 1, where all keys of that table must "
            "be: put "
            "`points.O` there"},
       Slip{"bodies = { crank = { mass = 3 } }\n[bodies.rod]\nmass = 1\n",
            "2:1: [bodies.rod] is written in line 1 already, as a key: put all its keys there"},
       Slip{"points = { A = [1, 0], A = [2, 0] }\n",
            "1:24: `A` is in this table a second time: keep one of them"},
       Slip{"curves = { disc = { type = \"circle\" }, disc.radius = 20 }\n",
            "1:40: `disc.radius` is a part of what is written in this table already, as a whole: put it "
            "there"},
       Slip{"[design]\nobjectives = []\n[[design.objectives]]\n",
            "3:1: [design.objectives] is written in line 2 already, as a key: put all its keys there"},
       Slip{"[design.objectives]\n[[design.objectives]]\n",
            "2:1: each table of this list is headed [[design.objectives]], here and in line 1"},
       Slip{"[driver\njoint = \"a\"\n", "1:1: the closing ] of the heading [driver is missing"},
       Slip{"[driver]]\n", "1:1: the heading of a table has one pair of brackets: [driver]"},
       Slip{"[]\n", "1:1: a heading needs a name between its brackets, such as [driver]"},
       Slip{"[", "1:1: a heading needs a name between its brackets, such as [driver]"},
       Slip{"[bodies.my cam]\n",
            "1:1: [bodies.my cam] is no heading: it is names of letters, digits, _ and -, joined by points, "
            "as in "
            "[bodies.cam]"},
       Slip{"[driver] joint = \"a\"\n",
            "1:9: a heading is a line of its own: put `joint = \"a\"` on the next one"},
       Slip{"radius 20\n", "1:1: expected = after the key `radius`"},
       Slip{"radius: 20\n", "1:7: key and value are joined by =, not by :"},
       Slip{"radius == 20\n", "1:9: one = joins a key and its value"},
       Slip{"free length = 40\n", "1:1: a key is one word: free_length"},
       Slip{"radius\n", "1:1: `radius` is no line of TOML: expected key = value, or a heading [table]"},
       Slip{"= 20\n", "1:1: a key is missing before the ="},
       Slip{"größe = 20\n", "1:1: expected = after the key `gr`"},
       Slip{"driver]\n", "1:1: the opening [ of the heading [driver] is missing"},
       Slip{"points.A : [0, 0]\n", "1:10: key and value are joined by =, not by :"},
       Slip{"points..A = [0, 0]\n", "1:1: the parts of a key are words, joined by single points"},
       Slip{"x = 1 y = 2\n", "1:7: one key on a line: put `y = 2` on the next one"},
       Slip{"x = 1, y = 2\n", "1:6: one key on a line: put `y = 2` on the next one"},
       Slip{"x = 1;\n", "1:6: a line ends without a semicolon"},
       Slip{"// a cam\n", "1:1: a comment begins with #"},
       Slip{"```toml\nx = 1\n```\n", "1:1: leave the lines ``` out, they are Markdown"},
       Slip{"x = 1\n```\n", "2:1: leave the lines ``` out, they are Markdown"},
       Slip{"x = 3 - 2\n", "1:5: nothing is worked out here: write the number instead of `3 - 2`"},
       Slip{"x = 3 // mm\n", "1:7: a comment begins with #"},
       Slip{"{ \"driver\": 1 }\n",
            "1:1: this looks like JSON; a profile is TOML: lines key = value under headings [table]"},
       Slip{"x = 1\ry = 2\n",
            "1:7: a line ends with a carriage return alone: save the file with LF or CR LF line ends"}});
}

TEST(Encoding, OtherThanUtf8IsNamedWithTheRemedy) {
  const std::string save = "save it as UTF-8 (\"Save as\" of most editors offers the encoding)";
  const std::string ascii = "title = \"cam\"\n";
  std::string little = "\xff\xfe";
  std::string big;
  for (const char c : ascii) {
    little += {c, '\0'};
    big += {'\0', c};
  }
  for (const std::string& wide : {little, little.substr(2), big}) {
    EXPECT_TRUE(lines_are(messages(wide), {"test.toml: this file is in UTF-16 or UTF-32; " + save}));
  }
  EXPECT_TRUE(lines_are(messages("format = 1\ntitle = \"K\xfchler\"\n"),
                        {"test.toml:2:11: the byte 0xFC is not UTF-8: the file seems to be in Latin-1 or "
                         "Windows-1252, where it is ü; " +
                         save}));
  EXPECT_TRUE(lines_are(
      messages("title = \"ü\x93\"\n"),
      {"test.toml:1:11: the byte 0x93 is not UTF-8: the file seems to be in Latin-1 or Windows-1252; " +
       save}));
  EXPECT_TRUE(lines_are(messages(std::string("format = 1\n\0", 12)),
                        {"test.toml:2:1: a zero byte: this is no text file"}));
  EXPECT_THAT(
      messages("\x1f\x8b\x08\x08\x9b"),  // as gzip writes it
      ::testing::ElementsAre("test.toml:1:2: the byte 0x8B and control characters: this is no text file"));
}

TEST(Encoding, AMarkTabsAndTheLineEndsOfWindowsAreFine) {
  std::string text = "\xef\xbb\xbf";
  for (const char c : testing::crank_profile("\t# end\n")) {
    text += c == '\n' ? std::string("\r\n") : c == '=' ? std::string("\t=\t") : std::string(1, c);
  }
  EXPECT_THAT(messages(text), ::testing::IsEmpty());
}

TEST(SyntaxMessages, ADecimalCommaIsFoundBehindAsMuchTextAsThereIs) {
  std::string points;
  for (int i = 0; i < 20000; ++i) points += "[1, 2], ";
  EXPECT_TRUE(lines_are(messages("face = { points = [" + points + "], radius = 30,5 }\n"),
                        {"test.toml:1:160032: a decimal number is written with a point: 30.5"}));
}

// Whatever is cut off or inserted, the message is a single line with a position within the text.
TEST(SyntaxMessages, AreOneLineForEveryProfileCutAnywhere) {
  const std::string text = testing::kCamProfile;
  for (std::size_t length = 0; length <= text.size(); length += 7) {
    for (const char* more : {"", "\n", "\"", "{", "]", ",", "\\", "\r", "“", "\x01"}) {
      for (const std::string& message : messages(text.substr(0, length) + more + text.substr(length))) {
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_THAT(message, ::testing::StartsWith("test.toml:"));
      }
    }
    (void)messages(text.substr(0, length));
  }
}

}  // namespace
}  // namespace higherpair
