// SPDX-License-Identifier: MIT
/// \file
/// Every file of the corpora is fuzzed once: what has once been found stays found.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/fuzz/targets.h"

namespace umbilic::fuzz {
namespace {

std::vector<std::filesystem::path> corpus_of(std::string_view target) {
  std::vector<std::filesystem::path> files;
  const auto folder = std::filesystem::path(UMBILIC_SOURCE_DIR) / "tests/fuzz/corpus" / target;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  return files;
}

std::string content_of(const std::filesystem::path& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, breaks_no_promise) {
  const auto files = corpus_of(GetParam().name);
  EXPECT_GE(files.size(), 5u);
  std::uintmax_t bytes = 0;
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename());
    bytes += std::filesystem::file_size(file);
    GetParam().run(content_of(file));
  }
  EXPECT_LT(bytes, 16'384u) << "corpora in the tree stay small";
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(kTargets),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(Promises, end_the_program_where_they_are_broken) {
  EXPECT_DEATH(require(false, "the sky is green"), "broken promise: the sky is green");
  EXPECT_DEATH(require_words(""), "a failure has words");
  require(true, "nothing happens");
}

}  // namespace
}  // namespace umbilic::fuzz
