#include "analysis/constraints_merge.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

#include "analysis/constraints_screws.h"
#include "analysis/union_find.h"
#include "base/index.h"

namespace liftarm::analysis {

namespace {

using base::at;

//! Bodies that turn about one line. Those of one axial group do not shift against each other.
struct Cluster {
  Link line;
  std::vector<std::pair<int, int>> members;  // (body, axial group), by body, each body once
};

//! For each link the first link on the same line.
//! \details Only lines about as far from some point off the lattice can be the same: few.
std::vector<int> findLines(const std::vector<Link>& links) {
  constexpr double kWidth = 0.1;  // modules; far above what onOneLine allows
  const lattice::Vec3 eye{0.3819, 0.7264, 0.5497};
  std::vector<int> lines(links.size());
  std::map<int, std::vector<int>> firsts;  // by distance
  for (std::size_t l = 0; l < links.size(); ++l) {
    const double distance =
        lattice::length(lattice::cross(links[l].at - eye, links[l].axis)) / kWidth;
    const int bucket = static_cast<int>(distance);
    int known = static_cast<int>(l);
    for (int near = bucket - 1; near <= bucket + 1; ++near) {
      const auto found = firsts.find(near);
      if (found != firsts.end()) {
        for (const int first : found->second) {
          known = first < known && onOneLine(links[at(first)], links[l]) ? first : known;
        }
      }
    }
    lines[l] = known;
    if (at(known) == l) {
      firsts[bucket].push_back(known);
    }
  }
  return lines;
}

class Merger {
 public:
  explicit Merger(const Linkage& linkage)
      : linkage_(linkage), bodies_(at(linkage.bodies)), lineOf_(findLines(linkage.links)) {}

  void join(int a, int b) { bodies_.join(a, b); }

  void run() {
    for (const Link& link : linkage_.links) {
      if (!link.turns && !link.shifts) {
        bodies_.join(link.a, link.b);
      }
    }
    do {
      makeClusters();
    } while (mergePairs() || mergeLoops());
  }

  [[nodiscard]] MergedLinkage result() {
    MergedLinkage merged;
    std::map<int, int> numbers;
    for (int i = 0; i < linkage_.bodies; ++i) {
      const int number = static_cast<int>(numbers.size());
      merged.bodyOf.push_back(numbers.emplace(bodies_.find(i), number).first->second);
    }
    merged.linkage.bodies = static_cast<int>(numbers.size());
    for (const Cluster& cluster : clusters_) {
      addTree(cluster, numbers, merged.linkage.links);
    }
    return merged;
  }

 private:
  //! Sorts the links into lines: links on one line belong together where they share a body.
  void makeClusters() {
    const std::vector<int> clusterOf = clustersOfLinks();
    std::map<int, Cluster> found;
    UnionFind axial(linkage_.links.size() * 2);
    std::map<std::pair<int, int>, int> seat;  // (line, body) -> an axial element
    for (std::size_t l = 0; l < linkage_.links.size(); ++l) {
      if (clusterOf[l] < 0) {
        continue;
      }
      const Link& link = linkage_.links[l];
      const int line = clusterOf[l];
      found[line].line = linkage_.links[at(line)];
      const int i = seat.emplace(std::pair(line, bodies_.find(link.a)), static_cast<int>(2 * l))
                        .first->second;
      const int j = seat.emplace(std::pair(line, bodies_.find(link.b)), static_cast<int>(2 * l + 1))
                        .first->second;
      if (!link.shifts) {
        axial.join(i, j);
      }
    }
    for (const auto& [key, element] : seat) {
      found[key.first].members.emplace_back(key.second, axial.find(element));
    }
    clusters_.clear();
    for (auto& [line, cluster] : found) {
      clusters_.push_back(std::move(cluster));
    }
    clustersOf_.assign(at(linkage_.bodies), {});
    for (std::size_t c = 0; c < clusters_.size(); ++c) {
      for (const auto& [body, group] : clusters_[c].members) {
        clustersOf_[at(body)].push_back(static_cast<int>(c));
      }
    }
  }

  //! For each link the first link of its cluster; -1 where its bodies are one.
  [[nodiscard]] std::vector<int> clustersOfLinks() {
    std::vector<int> clusters(linkage_.links.size(), -1);
    UnionFind same(linkage_.links.size());
    std::map<std::pair<int, int>, int> seats;  // (line, body) -> a link there
    for (std::size_t l = 0; l < linkage_.links.size(); ++l) {
      const Link& link = linkage_.links[l];
      const int index = static_cast<int>(l);
      for (const int body : {bodies_.find(link.a), bodies_.find(link.b)}) {
        if (bodies_.find(link.a) != bodies_.find(link.b)) {
          clusters[l] = index;
          same.join(index, seats.emplace(std::pair(lineOf_[l], body), index).first->second);
        }
      }
    }
    for (int& cluster : clusters) {
      cluster = cluster < 0 ? -1 : same.find(cluster);
    }
    return clusters;
  }

  //! How two members of a cluster may move against each other.
  static Link between(const Cluster& cluster, std::size_t i, std::size_t j) {
    Link link = cluster.line;
    link.a = cluster.members[i].first;
    link.b = cluster.members[j].first;
    link.turns = true;
    link.shifts = cluster.members[i].second != cluster.members[j].second;
    return link;
  }

  //! Two bodies on two lines.
  bool mergePairs() {
    std::map<std::pair<int, int>, Link> links;
    bool changed = false;
    for (const Cluster& cluster : clusters_) {
      for (std::size_t i = 0; i < cluster.members.size(); ++i) {
        for (std::size_t j = i + 1; j < cluster.members.size(); ++j) {
          const Link link = between(cluster, i, j);
          const auto [entry, isNew] = links.emplace(std::pair(link.a, link.b), link);
          const Link both = together(entry->second, link);
          if (!isNew && !both.turns && !both.shifts) {
            bodies_.join(link.a, link.b);
            changed = true;
          }
        }
      }
    }
    return changed;
  }

  //! Short loops without a motion.
  bool mergeLoops() {
    bool changed = false;
    reached_.assign(at(linkage_.bodies), {});
    passed_.assign(clusters_.size(), 0);
    search_ = 0;
    for (int c = 0; c < static_cast<int>(clusters_.size()); ++c) {
      for (const auto& [start, group] : clusters_[at(c)].members) {
        changed = mergeLoopsFrom(start, c) || changed;
      }
    }
    return changed;
  }

  struct Step {
    int search = 0;    // the search that got here last; the rest is of that one
    int from = -1;     // body
    int cluster = -1;  // passed to get here
    int depth = 0;
  };

  //! Searches breadth first for other ways from `start` to the other members of a cluster.
  bool mergeLoopsFrom(int start, int closing) {
    constexpr int kLongest = 5;  // links beside the closing one: six screws can be independent
    ++search_;
    reached_[at(start)] = {search_, -1, -1, 0};
    passed_[at(closing)] = search_;
    queue_.assign(1, start);
    bool changed = false;
    for (std::size_t head = 0; head < queue_.size(); ++head) {
      const int body = queue_[head];
      const int depth = reached_[at(body)].depth;
      if (depth == kLongest) {
        break;
      }
      for (const int c : clustersOf_[at(body)]) {
        if (passed_[at(c)] == search_) {
          continue;
        }
        passed_[at(c)] = search_;
        for (const auto& [next, group] : clusters_[at(c)].members) {
          if (reached_[at(next)].search != search_) {
            reached_[at(next)] = {search_, body, c, depth + 1};
            queue_.push_back(next);
            changed = (start < next && tryLoop(start, next, closing)) || changed;
          }
        }
      }
    }
    return changed;
  }

  [[nodiscard]] static const std::pair<int, int>* memberOf(const Cluster& cluster, int body) {
    const auto found = std::find_if(cluster.members.begin(),
                                    cluster.members.end(),
                                    [&](const auto& m) { return m.first == body; });
    return found == cluster.members.end() ? nullptr : &*found;
  }

  [[nodiscard]] Link linkBetween(int cluster, int a, int b) const {
    const Cluster& c = clusters_[at(cluster)];
    const auto* i = memberOf(c, a);
    const auto* j = memberOf(c, b);
    return between(
        c, at(static_cast<int>(i - c.members.data())), at(static_cast<int>(j - c.members.data())));
  }

  //! Joins the bodies of a loop whose screws are independent.
  bool tryLoop(int start, int end, int closing) {
    if (memberOf(clusters_[at(closing)], end) == nullptr) {
      return false;
    }
    std::vector<Link> loop{linkBetween(closing, start, end)};
    for (int body = end; body != start; body = reached_[at(body)].from) {
      const Step& step = reached_[at(body)];
      loop.push_back(linkBetween(step.cluster, step.from, body));
    }
    bool joined = true;
    for (const Link& link : loop) {
      joined = joined && bodies_.find(link.a) == bodies_.find(link.b);
    }
    if (joined || !haveIndependentScrews(loop)) {
      return false;
    }
    for (const Link& link : loop) {
      bodies_.join(link.a, link.b);
    }
    return true;
  }

  //! The links of a cluster as a tree: a hub for each axial group, hinged to its members; the other
  //! hubs turn and shift against the first. Hubs are the members with most other lines.
  void addTree(const Cluster& cluster,
               const std::map<int, int>& numbers,
               std::vector<Link>& links) const {
    std::map<int, std::size_t> hubs;
    const auto lines = [&](std::size_t i) {
      return clustersOf_[at(cluster.members[i].first)].size();
    };
    std::size_t first = 0;
    for (std::size_t i = 0; i < cluster.members.size(); ++i) {
      const auto [hub, isNew] = hubs.emplace(cluster.members[i].second, i);
      hub->second = lines(i) > lines(hub->second) ? i : hub->second;
      first = lines(i) > lines(first) ? i : first;
    }
    hubs[cluster.members[first].second] = first;
    for (std::size_t i = 0; i < cluster.members.size(); ++i) {
      const std::size_t groupHub = hubs.at(cluster.members[i].second);
      const std::size_t hub = i == groupHub ? first : groupHub;
      if (i != hub) {
        Link link = between(cluster, hub, i);
        link.a = numbers.at(link.a);
        link.b = numbers.at(link.b);
        links.push_back(link);
      }
    }
  }

  const Linkage& linkage_;
  UnionFind bodies_;
  std::vector<int> lineOf_;
  std::vector<Cluster> clusters_;
  std::vector<std::vector<int>> clustersOf_;  // by body
  // Of the search for loops, reused from one to the next.
  int search_ = 0;
  std::vector<Step> reached_;  // by body
  std::vector<int> passed_;    // by cluster: the search that passed it last
  std::vector<int> queue_;
};

}  // namespace

MergedLinkage mergeRigid(const Linkage& linkage) {
  Merger merger(linkage);
  merger.run();
  return merger.result();
}

MergedLinkage mergeFurther(const MergedLinkage& merged,
                           const std::vector<std::pair<int, int>>& joined) {
  Merger merger(merged.linkage);
  for (const auto& [a, b] : joined) {
    merger.join(a, b);
  }
  merger.run();
  MergedLinkage result = merger.result();
  std::vector<int> bodyOf;
  for (const int body : merged.bodyOf) {
    bodyOf.push_back(result.bodyOf[at(body)]);
  }
  result.bodyOf = std::move(bodyOf);
  return result;
}

}  // namespace liftarm::analysis
