#include "exporters/calculix.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <utility>
#include <vector>

namespace liftarm::exporters {

namespace {

using analysis::Frame;
using analysis::FrameElement;
using analysis::FrameSpring;
using analysis::Section;
using analysis::Six;
using lattice::Vec3;

constexpr double kNoInertia = 1e-13;  // mm^4: the plane of a U1 that is not right
constexpr int kTermsPerLine = 4;      // of an EQUATION

//! CalculiX reads at most 20 characters, and wants a point in each real number.
std::string real(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9e", value);
  return text.data();
}

std::string real(Vec3 v) {
  return real(v.x) + "," + real(v.y) + "," + real(v.z);
}

std::string number(int value) {
  return std::to_string(value);
}

//! One line of words: what a title may hold.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) {
    result +=
        static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e ? ' ' : c;
  }
  return result;
}

struct Term {
  int node = 0;
  int freedom = 0;
  double factor = 0.0;
};

class Deck {
 public:
  Deck(const analysis::StressState& state, const std::string& title)
      : state_(state), frame_(state.model.frame), title_(plain(title)) {}

  std::string write() {
    nextNode_ = static_cast<int>(frame_.nodes.size()) + 1;
    for (std::size_t i = 0; i < frame_.nodes.size(); ++i) {
      addNode(static_cast<int>(i) + 1, frame_.nodes[i]);
    }
    std::vector<bool> hasBar(frame_.nodes.size(), false);
    for (const FrameElement& element : frame_.elements) {
      addBar(element);
      hasBar[static_cast<std::size_t>(element.a)] = true;
      hasBar[static_cast<std::size_t>(element.b)] = true;
    }
    for (std::size_t i = 0; i < hasBar.size(); ++i) {
      if (!hasBar[i]) {
        addStub(static_cast<int>(i));
      }
    }
    for (const FrameSpring& spring : frame_.springs) {
      addSpring(spring);
    }
    for (std::size_t i = 0; i < frame_.contacts.size(); ++i) {
      if (state_.touching[i]) {
        addSpring(frame_.contacts[i]);
      }
    }
    return heading() + nodes_ + elementsText() + springsText() + equations_ + "*BOUNDARY\n" +
           boundary_ + stepText();
  }

 private:
  [[nodiscard]] std::string heading() const {
    return "*HEADING\n" + title_ + "\n** Units: N, mm, MPa. Nodes 1 to " +
           number(static_cast<int>(frame_.nodes.size())) +
           " are the frame's.\n** Each bar: two rows of U1, one for each plane of bending.\n"
           "** SPRING1 on auxiliary nodes: torsion of bars, fits, ground.\n";
  }

  void addNode(int id, Vec3 at) { nodes_ += number(id) + "," + real(at) + "\n"; }

  void addBar(const FrameElement& element) {
    const Vec3 a = frame_.nodes[static_cast<std::size_t>(element.a)];
    const Vec3 b = frame_.nodes[static_cast<std::size_t>(element.b)];
    std::vector<int> chain{element.a + 1};
    for (int i = 1; i < kCalculixPieces; ++i) {
      addNode(nextNode_, a + (static_cast<double>(i) / kCalculixPieces) * (b - a));
      chain.push_back(nextNode_++);
    }
    chain.push_back(element.b + 1);
    const Section& s = frame_.sections[static_cast<std::size_t>(element.section)];
    const lattice::Mat3 axes = analysis::axesOf(frame_, element);
    const double half = s.area / 2.0;
    const Vec3 y{axes.m[1], axes.m[4], axes.m[7]};
    const Vec3 z{axes.m[2], axes.m[5], axes.m[8]};
    addRow(chain, sectionText(half, s.inertiaZ, s.shearY, y));
    addRow(chain, sectionText(half, s.inertiaY, s.shearZ, z));
    addTwist(element, {axes.m[0], axes.m[3], axes.m[6]}, s);
  }

  //! A node without a bar (a bush) would have no rotations: it gets a bar that leads nowhere.
  void addStub(int node) {
    addNode(nextNode_, frame_.nodes[static_cast<std::size_t>(node)] + Vec3{1, 0, 0});
    const Section s = analysis::pinSection();
    addRow({node + 1, nextNode_}, sectionText(s.area / 2.0, s.inertiaZ, s.shearY, {0, 1, 0}));
    addRow({node + 1, nextNode_++}, sectionText(s.area / 2.0, s.inertiaY, s.shearZ, {0, 0, 1}));
  }

  static std::string sectionText(double area, double inertia, double shearArea, Vec3 direction) {
    return real(area) + "," + real(inertia) + ",0.," + real(kNoInertia) + "," +
           real(shearArea / area) + "\n" + real(direction) + "\n";
  }

  void addRow(const std::vector<int>& chain, const std::string& section) {
    std::string& rows = bars_[section];
    for (std::size_t i = 1; i < chain.size(); ++i) {
      rows += number(nextElement_++) + "," + number(chain[i - 1]) + "," + number(chain[i]) + "\n";
    }
  }

  //! What U1 lacks in torsion: it takes Iy + Iz for the constant.
  void addTwist(const FrameElement& element, Vec3 along, const Section& s) {
    const double lacking = frame_.material.shearModulus() * (s.torsion - s.inertiaY - s.inertiaZ) /
                           analysis::lengthOf(frame_, element);
    if (std::abs(lacking) < 1e-6) {
      return;
    }
    std::vector<Term> terms;
    for (int i = 0; i < 3; ++i) {
      terms.push_back({element.a + 1, 4 + i, -along[i]});
      terms.push_back({element.b + 1, 4 + i, along[i]});
    }
    const int node = addAuxiliary();
    tie(node, 1, lacking, terms);
    fix(node, 2, 3);
  }

  int addAuxiliary() {
    addNode(nextNode_, {});
    return nextNode_++;
  }

  void fix(int node, int from, int to) {
    boundary_ += number(node) + "," + number(from) + "," + number(to) + "\n";
  }

  //! A spring on the sum of terms, by way of one freedom of an auxiliary node.
  void tie(int node, int freedom, double stiffness, const std::vector<Term>& terms) {
    std::vector<Term> all{{node, freedom, 1.0}};
    for (const Term& term : terms) {
      if (std::abs(term.factor) > 1e-12) {
        all.push_back({term.node, term.freedom, -term.factor});
      }
    }
    equations_ += "*EQUATION\n" + number(static_cast<int>(all.size())) + "\n";
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool last = i + 1 == all.size() || (i + 1) % kTermsPerLine == 0;
      equations_ += number(all[i].node) + "," + number(all[i].freedom) + "," + real(all[i].factor) +
                    (last ? "\n" : ",");
    }
    springs_[{freedom, real(stiffness)}].push_back(node);
  }

  void addSpring(const FrameSpring& spring) {
    const auto rows = analysis::springRows(frame_, spring);
    for (std::size_t block = 0; block < 2; ++block) {
      const int node = addAuxiliary();
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t row = 3 * block + i;
        const int freedom = static_cast<int>(i) + 1;
        if (spring.stiffness[row] == 0.0) {
          fix(node, freedom, freedom);
          continue;
        }
        std::vector<Term> terms;
        for (std::size_t k = 0; k < 12; ++k) {
          const int end = k < 6 ? spring.a : spring.b;
          terms.push_back({end + 1, static_cast<int>(k % 6) + 1, rows[row][k]});
        }
        tie(node, freedom, spring.stiffness[row], terms);
      }
    }
  }

  [[nodiscard]] std::string elementsText() const {
    std::string text = "*USER ELEMENT,TYPE=U1,NODES=2,INTEGRATION POINTS=2,MAXDOF=6\n";
    int set = 0;
    for (const auto& [section, rows] : bars_) {
      text += "*ELEMENT,TYPE=U1,ELSET=BAR" + number(++set) + "\n" + rows;
    }
    text += "*MATERIAL,NAME=ABS\n*ELASTIC\n" + real(frame_.material.youngsModulus) + "," +
            real(frame_.material.poissonRatio) + "\n";
    set = 0;
    for (const auto& [section, rows] : bars_) {
      text +=
          "*BEAM SECTION,ELSET=BAR" + number(++set) + ",MATERIAL=ABS,SECTION=GENERAL\n" + section;
    }
    return text;
  }

  [[nodiscard]] std::string springsText() const {
    std::string text;
    int set = 0;
    int element = nextElement_;
    for (const auto& [kind, nodes] : springs_) {
      const std::string name = "SPRING" + number(++set);
      text += "*ELEMENT,TYPE=SPRING1,ELSET=" + name + "\n";
      for (const int node : nodes) {
        text += number(element++) + "," + number(node) + "\n";
      }
      text += "*SPRING,ELSET=" + name + "\n" + number(kind.first) + "\n" + kind.second + "\n";
    }
    return text;
  }

  [[nodiscard]] std::string stepText() const {
    std::string text = "*NSET,NSET=FRAME,GENERATE\n1," +
                       number(static_cast<int>(frame_.nodes.size())) + "\n*STEP\n*STATIC\n*CLOAD\n";
    const std::vector<Six> loads = analysis::nodalLoads(frame_);
    for (std::size_t node = 0; node < loads.size(); ++node) {
      for (std::size_t k = 0; k < 6; ++k) {
        if (loads[node][k] != 0.0) {
          text += number(static_cast<int>(node) + 1) + "," + number(static_cast<int>(k) + 1) + "," +
                  real(loads[node][k]) + "\n";
        }
      }
    }
    return text + "*NODE PRINT,NSET=FRAME\nU\n*NODE FILE\nU\n*END STEP\n";
  }

  const analysis::StressState& state_;
  const Frame& frame_;
  std::string title_;
  std::string nodes_ = "*NODE\n";
  std::map<std::string, std::string> bars_;                          // elements by section
  std::map<std::pair<int, std::string>, std::vector<int>> springs_;  // nodes by freedom, stiffness
  std::string equations_;
  std::string boundary_;
  int nextNode_ = 1;
  int nextElement_ = 1;
};

}  // namespace

std::string writeCalculix(const analysis::StressState& state, const std::string& title) {
  return Deck(state, title).write();
}

}  // namespace liftarm::exporters
