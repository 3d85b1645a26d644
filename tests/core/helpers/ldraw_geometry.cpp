#include "core/helpers/ldraw_geometry.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>

#include "core/helpers/shared_data.h"

namespace liftarm::testing {

namespace {

using lattice::Mat3;
using lattice::Vec3;

constexpr double kLdu = 1.0 / 20.0;

std::string fileName(std::string name) {
  for (char& c : name) {
    c = c == '\\' ? '/' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

Vec3 readVec(std::istringstream& in) {
  Vec3 v;
  in >> v.x >> v.y >> v.z;
  return v;
}

Vec3 ours(Vec3 ldraw) {
  return {ldraw.x * kLdu, ldraw.z * kLdu, -ldraw.y * kLdu};
}

struct Walker {
  std::map<std::string, std::vector<std::string>>& files;
  std::vector<Triangle> triangles;
  bool complete = true;

  const std::vector<std::string>* open(const std::string& name) {
    const auto known = files.find(name);
    if (known != files.end()) {
      return known->second.empty() ? nullptr : &known->second;
    }
    std::vector<std::string>& lines = files[name];
    for (const char* folder : {"ldraw/parts/", "ldraw/p/"}) {
      const std::optional<std::string> text = readSharedFile(folder + name);
      if (text.has_value()) {
        std::istringstream in(*text);
        for (std::string line; std::getline(in, line);) {
          lines.push_back(line);
        }
        break;
      }
    }
    return lines.empty() ? nullptr : &lines;
  }

  void walk(const std::string& name, const Mat3& rotation, Vec3 position) {
    const std::vector<std::string>* lines = open(name);
    if (lines == nullptr) {
      complete = false;
      return;
    }
    for (const std::string& line : *lines) {
      std::istringstream in(line);
      int type = 0;
      int color = 0;
      if (!(in >> type >> color)) {
        continue;
      }
      if (type == 1) {
        const Vec3 at = readVec(in);
        Mat3 m;
        for (double& value : m.m) {
          in >> value;
        }
        std::string sub;
        in >> sub;
        walk(fileName(sub), rotation * m, rotation * at + position);
      } else if (type == 3 || type == 4) {
        std::vector<Vec3> corners;
        for (int i = 0; i < type; ++i) {
          corners.push_back(ours(rotation * readVec(in) + position));
        }
        for (std::size_t i = 2; i < corners.size(); ++i) {
          triangles.push_back({corners[0], corners[i - 1], corners[i]});
        }
      }
    }
  }
};

//! Distance from the origin of the plane across the axis to the segment a-b of that plane.
double planeDistance(Vec3 a, Vec3 b) {
  const Vec3 d = b - a;
  const double square = lattice::dot(d, d);
  const double t = square > 0.0 ? std::clamp(-lattice::dot(a, d) / square, 0.0, 1.0) : 0.0;
  return lattice::length(a + t * d);
}

}  // namespace

std::vector<Triangle> LdrawGeometry::part(const std::string& id) {
  Walker walker{files_, {}, true};
  walker.walk(id + ".dat", Mat3(), {});
  return walker.complete ? walker.triangles : std::vector<Triangle>();
}

double distanceToAxis(const Triangle& triangle, Vec3 center, Vec3 axis, double reach) {
  // Clip to the slab |height| <= reach, then look at the outline in the plane across the axis.
  std::vector<Vec3> shape(triangle.begin(), triangle.end());
  for (const double side : {1.0, -1.0}) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const Vec3 a = shape[i];
      const Vec3 b = shape[(i + 1) % shape.size()];
      const double ha = reach - side * lattice::dot(a - center, axis);
      const double hb = reach - side * lattice::dot(b - center, axis);
      if (ha >= 0.0) {
        kept.push_back(a);
      }
      if ((ha > 0.0 && hb < 0.0) || (ha < 0.0 && hb > 0.0)) {
        kept.push_back(a + (ha / (ha - hb)) * (b - a));
      }
    }
    shape = kept;
  }
  double best = 1e9;
  double turning = 0.0;
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const auto flat = [&](Vec3 p) {
      const Vec3 q = p - center;
      return q - lattice::dot(q, axis) * axis;
    };
    const Vec3 a = flat(shape[i]);
    const Vec3 b = flat(shape[(i + 1) % shape.size()]);
    best = std::min(best, planeDistance(a, b));
    turning += std::atan2(lattice::dot(lattice::cross(a, b), axis), lattice::dot(a, b));
  }
  return std::abs(turning) > 3.0 ? 0.0 : best;  // the axis pierces the face
}

}  // namespace liftarm::testing
