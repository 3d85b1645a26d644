#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

namespace liftarm::testing {

//! \brief What one run of the command gave.
struct Outcome {
  int exitCode = -1;
  std::string out;
  std::string err;
};

//! \brief Runs the command itself, in a folder of its own.
class Command : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / (std::string("liftarm-cli-") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }

  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& content) {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return (folder_ / name).string();
  }

  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  Outcome run(const std::string& arguments) {
    const std::string line = std::string("'") + LIFTARM_COMMAND + "' " + arguments + " >'" +
                             (folder_ / "stdout").string() + "' 2>'" +
                             (folder_ / "stderr").string() + "'";
    Outcome outcome;
    const int status = std::system(line.c_str());
    outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.out = read("stdout");
    outcome.err = read("stderr");
    return outcome;
  }

  //! One line on standard error, nothing on standard output, exit 1.
  void expectRefused(const std::string& arguments, const std::string& message) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  }

  std::filesystem::path folder_;
};

}  // namespace liftarm::testing
