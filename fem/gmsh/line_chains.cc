#include "fem/gmsh/line_chains.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace interlock::fem
{
namespace
{
// One end of a link.
struct LinkEnd {
  int link = -1, end = 0;
};

// What follows beyond both ends of each link: the end of the next link that it meets.
using Followers = std::vector<std::array<LinkEnd, 2>>;

Followers find_followers(const std::vector<Eigen::Vector3d>& positions,
                         const std::vector<ChainLink>& links)
{
  std::map<int, std::vector<LinkEnd>> ends_at;
  for (int l = 0; l < static_cast<int>(links.size()); ++l)
    for (int end : {0, 1}) ends_at[links[l].node[end]].push_back({l, end});
  const auto away = [&](const LinkEnd& e) {
    const auto& node = links[e.link].node;
    return (positions[node[1 - e.end]] - positions[node[e.end]]).normalized();
  };

  Followers followers(links.size());
  for (const auto& [node, ends] : ends_at) {
    struct Pair {
      double cosine; // of the bend, 1 when straight
      LinkEnd a, b;
    };
    std::vector<Pair> pairs;
    for (std::size_t j = 1; j < ends.size(); ++j)
      for (std::size_t i = 0; i < j; ++i) {
        const double cosine = -away(ends[i]).dot(away(ends[j]));
        if (cosine > std::sqrt(0.5) && links[ends[i].link].normal == links[ends[j].link].normal)
          pairs.push_back({cosine, ends[i], ends[j]});
      }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.cosine > b.cosine; });
    for (const auto& [cosine, a, b] : pairs) {
      LinkEnd &after_a = followers[a.link][a.end], &after_b = followers[b.link][b.end];
      if (after_a.link >= 0 || after_b.link >= 0) continue;
      after_a = b;
      after_b = a;
    }
  }
  return followers;
}

// The end at which the chain of a link starts when it is followed against the link's direction; in
// a ring, that of the link itself.
LinkEnd chain_start(const Followers& followers, int link)
{
  LinkEnd first{link, 0};
  for (;;) {
    const LinkEnd before = followers[first.link][first.end];
    if (before.link < 0) return first;
    if (before.link == link) return {link, 0};
    first = {before.link, 1 - before.end};
  }
}
} // namespace

std::vector<Chain> straightest_chains(const std::vector<Eigen::Vector3d>& positions,
                                      const std::vector<ChainLink>& links)
{
  const Followers followers = find_followers(positions, links);
  std::vector<bool> used(links.size(), false);
  std::vector<Chain> chains;
  for (int l = 0; l < static_cast<int>(links.size()); ++l) {
    if (used[l]) continue;
    LinkEnd next = chain_start(followers, l);
    Chain chain;
    chain.nodes.push_back(links[next.link].node[next.end]);
    while (next.link >= 0 && !used[next.link]) {
      used[next.link] = true;
      chain.links.push_back(next.link);
      chain.nodes.push_back(links[next.link].node[1 - next.end]);
      next = followers[next.link][1 - next.end];
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}
} // namespace interlock::fem
