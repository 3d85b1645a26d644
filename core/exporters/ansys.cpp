#include "exporters/ansys.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace liftarm::exporters {

namespace {

using analysis::Frame;
using analysis::FrameElement;
using analysis::FrameSpring;
using analysis::Section;
using analysis::Six;
using lattice::Vec3;

constexpr std::size_t kConstantsPerLine = 6;
constexpr std::size_t kMaxTitle = 70;

std::string apdlReal(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9g", value);
  return text.data();
}

std::string apdlNumber(int value) {
  return std::to_string(value);
}

std::string nodeText(int id, Vec3 at) {
  return "N," + apdlNumber(id) + "," + apdlReal(at.x) + "," + apdlReal(at.y) + "," +
         apdlReal(at.z) + "\n";
}

//! A title without what APDL would take for a command.
std::string apdlTitle(const std::string& text) {
  std::string result;
  for (const char c : text.substr(0, kMaxTitle)) {
    const auto code = static_cast<unsigned char>(c);
    result += code < 0x20 || code > 0x7e || c == '$' || c == '!' || c == '%' ? ' ' : c;
  }
  return result;
}

std::string sectionText(const Frame& frame, int id, const Section& s) {
  const double g = frame.material.shearModulus();
  return "SECTYPE," + apdlNumber(id) + ",BEAM,ASEC\nSECDATA," + apdlReal(s.area) + "," +
         apdlReal(s.inertiaY) + ",0," + apdlReal(s.inertiaZ) + ",0," + apdlReal(s.torsion) +
         ",0,0,0,0\n" + "SECCONTROL," + apdlReal(g * s.shearZ) + ",0," + apdlReal(g * s.shearY) +
         "\n";
}

//! The upper triangle of a spring's stiffness, row by row.
std::vector<double> matrixOf(const Frame& frame, const FrameSpring& spring) {
  const auto rows = analysis::springRows(frame, spring);
  std::vector<double> upper;
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t j = i; j < 12; ++j) {
      double value = 0.0;
      for (std::size_t k = 0; k < 6; ++k) {
        value += spring.stiffness[k] * rows[k][i] * rows[k][j];
      }
      upper.push_back(value);
    }
  }
  return upper;
}

class Script {
 public:
  Script(const analysis::StressState& state, const std::string& title)
      : state_(state), frame_(state.model.frame) {
    text_ = "! Units: N, mm, MPa\n/PREP7\n/TITLE," + apdlTitle(title) +
            "\nET,1,BEAM188\nKEYOPT,1,3,3\nET,2,MATRIX27\nKEYOPT,2,3,4\nMP,EX,1," +
            apdlReal(frame_.material.youngsModulus) + "\nMP,PRXY,1," +
            apdlReal(frame_.material.poissonRatio) + "\n";
  }

  std::string write() {
    for (std::size_t i = 0; i < frame_.sections.size(); ++i) {
      text_ += sectionText(frame_, static_cast<int>(i) + 1, frame_.sections[i]);
    }
    for (std::size_t i = 0; i < frame_.nodes.size(); ++i) {
      text_ += nodeText(static_cast<int>(i) + 1, frame_.nodes[i]);
    }
    nextNode_ = static_cast<int>(frame_.nodes.size()) + 1;
    text_ += "TYPE,1\nMAT,1\n";
    for (const FrameElement& element : frame_.elements) {
      addBar(element);
    }
    text_ += "TYPE,2\n";
    for (const FrameSpring& spring : frame_.springs) {
      addSpring(spring);
    }
    for (std::size_t i = 0; i < frame_.contacts.size(); ++i) {
      if (state_.touching[i]) {
        addSpring(frame_.contacts[i]);
      }
    }
    addLoads();
    return text_ +
           "FINISH\n/SOLU\nANTYPE,STATIC\nSOLVE\nFINISH\n/POST1\nPRNSOL,U\nPRRSOL\nFINISH\n";
  }

 private:
  void addBar(const FrameElement& element) {
    const lattice::Mat3 axes = analysis::axesOf(frame_, element);
    const Vec3 z{axes.m[2], axes.m[5], axes.m[8]};
    text_ += nodeText(nextNode_, frame_.nodes[static_cast<std::size_t>(element.a)] + 10.0 * z);
    text_ += "SECNUM," + apdlNumber(element.section + 1) + "\nE," + apdlNumber(element.a + 1) +
             "," + apdlNumber(element.b + 1) + "," + apdlNumber(nextNode_++) + "\n";
  }

  void addSpring(const FrameSpring& spring) {
    const std::vector<double> constants = matrixOf(frame_, spring);
    ++lastReal_;
    for (std::size_t i = 0; i < constants.size(); ++i) {
      if (i % kConstantsPerLine == 0) {
        text_ += i == 0 ? "R," + apdlNumber(lastReal_) : std::string("\nRMORE");
      }
      text_ += "," + apdlReal(constants[i]);
    }
    int other = spring.b + 1;
    if (spring.b < 0) {
      text_ += "\n" + nodeText(nextNode_, spring.at) + "D," + apdlNumber(nextNode_) + ",ALL";
      other = nextNode_++;
    }
    text_ += "\nREAL," + apdlNumber(lastReal_) + "\nE," + apdlNumber(spring.a + 1) + "," +
             apdlNumber(other) + "\n";
  }

  void addLoads() {
    constexpr std::array<const char*, 6> kNames{"FX", "FY", "FZ", "MX", "MY", "MZ"};
    const std::vector<Six> loads = analysis::nodalLoads(frame_);
    for (std::size_t node = 0; node < loads.size(); ++node) {
      for (std::size_t k = 0; k < 6; ++k) {
        if (loads[node][k] != 0.0) {
          text_ += "F," + apdlNumber(static_cast<int>(node) + 1) + "," + kNames[k] + "," +
                   apdlReal(loads[node][k]) + "\n";
        }
      }
    }
  }

  const analysis::StressState& state_;
  const Frame& frame_;
  std::string text_;
  int nextNode_ = 1;
  int lastReal_ = 0;
};

}  // namespace

std::string writeAnsys(const analysis::StressState& state, const std::string& title) {
  return Script(state, title).write();
}

}  // namespace liftarm::exporters
