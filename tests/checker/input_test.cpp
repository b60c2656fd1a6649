#include "tests/checker/certificates.hpp"

#include <cstdio>
#include <random>

using namespace limes::test;

namespace {

const std::vector<std::string> chaikin{"1/4", "3/4", "3/4", "1/4"};

void expect_rejected_text(const std::string& text, const std::string& step) {
  const auto result = limes::checker::check(text);
  EXPECT_FALSE(result.valid);
  EXPECT_EQ(result.step, step) << result.reason;
  EXPECT_FALSE(result.reason.empty());
}

}  // namespace

TEST(Input, TruncationsAreRejectedAtEveryByte) {
  for (const auto& [name, json] : valid_certificates()) {
    const std::string text = json.dump(1);
    for (std::size_t n = 0; n < text.size(); ++n) expect_rejected_text(text.substr(0, n), "json");
  }
}

TEST(Input, RandomBytesNeverCrashAndFlippedOnesNeverProveMore) {
  std::mt19937 random(7);
  const auto all = valid_certificates();
  for (int round = 0; round < 3000; ++round) {
    std::string text = std::next(all.begin(), static_cast<long>(random() % all.size()))->second.dump();
    for (int k = 0; k < 40; ++k) text[random() % text.size()] = static_cast<char>(random() % 256);
    EXPECT_FALSE(limes::checker::check(text).valid) << text;
  }
}

TEST(Input, TextThatIsNoStrictJson) {
  const std::string text = smooth({{}, chaikin, "C1"}, 1).dump();
  EXPECT_TRUE(limes::checker::check(text).valid);
  expect_rejected_text("\xEF\xBB\xBF" + text, "json");
  expect_rejected_text(text + std::string(1, '\0'), "json");
  expect_rejected_text(text + std::string("\0{", 2), "json");
  expect_rejected_text(text + text, "json");
  expect_rejected_text(text + "// comment", "json");
  expect_rejected_text("/**/" + text, "json");
  for (const char* whole : {"", " ", "null", "true", "1", "\"text\"", "[]", "NaN"})
    EXPECT_FALSE(limes::checker::check(whole).valid) << whole;
  const auto replaced = [&](const std::string& what, const std::string& with) {
    std::string result = text;
    return result.replace(result.find(what), what.size(), with);
  };
  for (const char* number : {"NaN", "Infinity", "-Infinity", "0x1", "01", "+1", "1.", "1e", "'1'"})
    expect_rejected_text(replaced("\"level\":1", "\"level\":" + std::string(number)), "json");
  for (const char* number : {"1.0", "1e0", "0", "-1", "25", "1e400", "18446744073709551616", "18446744073709551617",
                             "4294967297", "-4294967295", "\"1\"", "true", "[1]"})
    EXPECT_FALSE(limes::checker::check(replaced("\"level\":1", "\"level\":" + std::string(number))).valid) << number;
  expect_rejected_text(replaced("\"test\"", "\"a\x01\""), "json");
  expect_rejected_text(replaced("\"test\"", "\"a\xFF\""), "json");
  expect_rejected_text(replaced("\"test\"", "\"\\ud800\""), "json");
  for (const char* name : {"\"\\u001b[2J\"", "\"\\n\"", "\"\\u0000\"", "\"\\u007f\"", "\"\\u009b1m\"", "\"\""})
    expect_rejected_text(replaced("\"test\"", name), "scheme");
}

TEST(Input, DuplicateKeysAreRejectedEverywhere) {
  const std::string text = rough({{"w"}, four_point, "not C2", {{"w", "1/8"}}}, "interpolatory").dump();
  ASSERT_TRUE(limes::checker::check(text).valid);
  std::size_t keys = 0;
  for (std::size_t colon = text.find("\":"); colon != std::string::npos; colon = text.find("\":", colon + 1)) {
    // Repeats the key with another value in front of it, then with an escaped spelling.
    const std::size_t start = text.rfind('"', colon - 1);
    const std::string key = text.substr(start + 1, colon - start - 1);
    expect_rejected_text(text.substr(0, start) + "\"" + key + "\":null," + text.substr(start), "json");
    char escaped[8];
    std::snprintf(escaped, sizeof escaped, "\\u%04x", static_cast<unsigned>(key[0]));
    expect_rejected_text(text.substr(0, start) + "\"" + escaped + key.substr(1) + "\":null," + text.substr(start),
                         "json");
    ++keys;
  }
  EXPECT_EQ(keys, 21u);
}

TEST(Input, DepthIsLimited) {
  for (const int depth : {33, 1000, 1000000}) {
    expect_rejected_text(std::string(static_cast<std::size_t>(depth), '['), "json");
    std::string objects;
    for (int k = 0; k < depth; ++k) objects += "{\"a\":";
    expect_rejected_text(objects, "json");
  }
  const auto nested = [](int depth, const std::string& open, const std::string& close) {
    std::string result;
    for (int k = 0; k < depth; ++k) result += open;
    result += "1/4";
    for (int k = 0; k < depth; ++k) result += close;
    return result;
  };
  for (const auto& [open, close] :
       std::vector<std::pair<std::string, std::string>>{{"(", ")"}, {"--", ""}, {"-(-", ")"}}) {
    const int fits = open.size() == 1 ? 299 : open.size() == 2 ? 149 : 99;
    expect_valid(smooth({{}, {nested(fits, open, close), "3/4", "3/4", "1/4"}, "C1"}, 1));
    expect_invalid(smooth({{}, {nested(fits + 2, open, close), "3/4", "3/4", "1/4"}, "C1"}, 1), "scheme");
    expect_invalid(smooth({{}, {nested(30000, open, close), "3/4", "3/4", "1/4"}, "C1"}, 1), "scheme");
  }
}

TEST(Input, StatementsAndNames) {
  for (const char* statement :
       {"C65", "C-1", "C01", "C", "c1", "C 1", "C1 ", " C1", "C1.0", "C+1", "C999999999999999999999", "not", "not  C1",
        "notC1", "not not C1", "Not C1", "", "C\u0661"})
    expect_invalid(smooth({{}, chaikin, statement}, 1), "claim");
  expect_invalid(smooth({{}, chaikin, "C64"}, 1), "factor");
  for (const auto& parameters : std::vector<std::vector<std::string>>{{""},
                                                                      {"1w"},
                                                                      {"w w"},
                                                                      {"_w"},
                                                                      {"w-"},
                                                                      {"\u03c9"},
                                                                      {"w", "w"},
                                                                      {"w\n"},
                                                                      {std::string(65, 'w')},
                                                                      {"a", "b", "c", "d", "e", "f", "g", "h", "i"}}) {
    Json region = Json::object();
    for (const auto& name : parameters) region[name] = "1/16";
    expect_invalid(smooth({parameters, chaikin, "C1", region}, 1), "scheme");
  }
}

TEST(Input, RegionsAndIntervals) {
  for (const char* interval :
       {"",          "w",       "[0,1",    "0, 1]",   "[1, 0]",  "[1, 1]",  "(1, 1)",   "(1, 1]", "[0; 1]",
        "[0, 1, 2]", "[0 , 1]", "[ 0, 1]", "[0,  1]", "[0, 1] ", " [0, 1]", "[0, 1/0]", "1/0",    "0/0",
        "1/",        "/1",      "--1",     "+1",      "1/-2",    "0.5",     "1e3",      "[,]",    "[",
        "]",         "()",      "[1/2]",   "]0, 1[",  "{0, 1}",  "NaN",     "inf",      "\u0661", "0x10"})
    expect_invalid(smooth({{"w"}, chaikin, "C1", {{"w", interval}}}, 1), "claim");
  expect_valid(smooth({{"w"}, chaikin, "C1", {{"w", "[-007/14,12/24)"}}}, 1));
  for (const Json& region : {Json::object(), Json{{"v", "1"}}, Json{{"w", "1"}, {"v", "1"}}, Json{{"w", 1}},
                             Json{{"w", {"1", "2"}}}, Json::array(), Json("1"), Json()})
    expect_invalid(smooth({{"w"}, chaikin, "C1", region}, 1), "claim");
  expect_invalid(smooth({{}, chaikin, "C1", {{"w", "1"}}}, 1), "claim");
}

TEST(Input, Expressions) {
  for (const char* text :
       {"",       " ",    "1/4)",  "(1/4",  "1//4",  "1/",     "*1",    "+1/4",  "1/4 +",  "1 4",           "w",
        "x",      "1/4;", "0.25",  "1e-1",  "2^-1",  "2^(1)",  "2^2^1", "2^",    "2^1001", "2^99999999999", "2^w",
        "sin(1)", "1/0",  "0^0/0", "1/4\t", "1/4\n", "\u00bc", "1/4\\", "[1/4]", "1,4",    "1/(1-1)"})
    expect_invalid(smooth({{"v"}, {text, "3/4", "3/4", "1/4"}, "C1", {{"v", "1"}}}, 1), "scheme");
  for (const char* text : {" 1 / 4 ", "(1/2)^2", "--1/4", "1/2*1/2", "2^0/4", "-(-1)/4", "1/2 - 1/4", "1/2/2",
                           "(v + 1)^2/16 - (v^2 + 2*v - 3)/16", "2^ 3/32", "1/4*(2-v)/(2-v)", "3 - 11/4", "-1^2 + 5/4",
                           "0001/0004", "0^0/4", "1/4 - 0*v"})
    expect_valid(smooth({{"v"}, {text, "3/4", "3/4", "1/4"}, "C1", {{"v", "1"}}}, 1));
}

TEST(Input, HugeNumbersAndExponentsMeetALimit) {
  const std::string digits(10000, '9'), more(20000, '9');
  expect_valid(smooth({{"w"}, chaikin, "C1", {{"w", "[-" + digits + ", " + digits + "/7]"}}}, 1));
  expect_invalid(smooth({{"w"}, chaikin, "C1", {{"w", more}}}, 1), "claim");
  expect_invalid(smooth({{"w"}, chaikin, "C1", {{"w", "1/" + more}}}, 1), "claim");
  expect_invalid(smooth({{}, {more, "3/4", "3/4", "1/4"}, "C1"}, 1), "scheme");
  expect_invalid(
      smooth({{"w"}, {"1/4 + " + digits + "*w", "3/4", "3/4", "1/4"}, "C1", {{"w", "[0, " + digits + "]"}}}, 24),
      "sum limits");
  for (const char* text :
       {"((2^1000)^1000)^1000", "((((9^999)^999)^999)^999)^999", "((w^1000)^1000)^1000", "(1+w+v)^1000"}) {
    const auto json = smooth({{"v", "w"}, {text, "3/4", "3/4", "1/4"}, "C1", {{"v", "[0, 1]"}, {"w", "[1, 2]"}}}, 1);
    expect_invalid(json, "limits sum");
  }
}

TEST(Input, WorkIsLimitedBeforeItIsDone) {
  const auto refused = [](const Json& json, const std::string& steps) {
    expect_invalid(json, steps);  // what would hang meets CTest's time limit
  };
  refused(smooth({{"w"}, four_point, "C1", {{"w", "[1/10, 1/8]"}}}, 24), "limits");
  refused(smooth({{"w"}, four_point, "C1", {{"w", "1/16"}}}, 24), "limits");
  refused(smooth({{}, std::vector<std::string>(1024, "1/512"), "C0"}, 20), "limits");
  refused(smooth({{}, {"1", "1"}, "C0", Json::object(), 2}, 24), "contractivity");  // b = 1: one entry at every level
  // A long word over large sections, and many leaves.
  std::vector<std::string> mask{"1"};
  for (int k = 0; k < 400; ++k) mask.insert(mask.end(), {"0", k % 2 ? "1/200" : "0"});
  mask.push_back("0");
  refused(rough({{}, mask, "not C0"}, "interpolatory", std::vector<int>(64, 1)), "limits stability factor word");
  Json leaves = Json::array();
  for (int k = 0; k < 400; ++k) leaves.push_back({{"region", {{"w", "[1/10, 1/8]"}}}, {"level", 12}});
  leaves.push_back({{"region", {{"w", "[1/1000000, 1/10]"}}}, {"level", 12}});
  refused(certificate({{"w"}, four_point, "C1", {{"w", "[1/1000000, 1/8]"}}}, "certified", "U1", {{"leaves", leaves}}),
       "limits");
  leaves = Json::array();
  for (int k = 0; k <= 100000; ++k) leaves.push_back(0);
  refused(certificate({{"w"}, four_point, "C1", {{"w", "1/8"}}}, "certified", "U1", {{"leaves", leaves}}), "proof");
  refused(Json(std::vector<int>(3000000, 1)), "limits");
}

TEST(Input, LettersLevelsAndArity) {
  const Claim claim{{}, {"1/2", "1", "1/2"}, "not C1"};
  expect_valid(rough(claim, "interpolatory", {0}));
  for (const std::vector<int>& word : {std::vector<int>{2}, {-1}, {0, 2}, std::vector<int>(65, 0)})
    expect_invalid(rough(claim, "interpolatory", word), "proof");
  expect_valid(rough(claim, "interpolatory", std::vector<int>(64, 0)));
  auto json = rough(claim, "interpolatory", {0});
  for (const Json& word : {Json::array(), Json{0.0}, Json{"0"}, Json{nullptr}, Json("0"), Json(0), Json{{0}}}) {
    json["proof"]["leaves"][0]["word"] = word;
    expect_invalid(json, "proof");
  }
  json = rough(claim, "interpolatory", {0});
  json["proof"]["leaves"][0]["missing_factor"] = true;
  expect_invalid(json, "proof");
  json["proof"]["leaves"][0].erase("word");
  json["proof"]["leaves"][0]["missing_factor"] = false;
  expect_invalid(json, "proof");
  for (const int arity : {-2, 0, 1, 17, 1000000})
    expect_invalid(smooth({{}, chaikin, "C1", Json::object(), arity}, 1), "scheme");
  for (const int arity : {3, 4, 16}) expect_invalid(smooth({{}, chaikin, "C1", Json::object(), arity}, 1), "sum");
  for (const int level : {-1, 0, 25, 1000000000}) expect_invalid(smooth({{}, chaikin, "C1"}, level), "proof");
}
