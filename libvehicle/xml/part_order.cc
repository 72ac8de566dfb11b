#include "libvehicle/xml/part_order.h"

#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace vehicle {

namespace {

/// A part that stands alone, or a group with its members: what cannot be torn apart.
struct Block {
  PartToWrite part;
  std::size_t kind = 0;  // index of its row
  int waits_for = 0;     // blocks that must be written before
  std::vector<std::size_t> followers;
};

// Accessors take a mutable struct; nothing is changed through it here.
std::string groupOf(const ElementRow& row, const void* object) {
  return row.group == nullptr ? "" : *row.group(const_cast<void*>(object));
}

}  // namespace

std::vector<PartToWrite> orderOfWriting(const ElementRow& row, const void* object) {
  std::vector<Block> blocks;
  std::map<std::string, std::size_t> block_of_group;
  const auto follow = [&blocks](std::size_t first, std::size_t second) {
    blocks[first].followers.push_back(second);
    ++blocks[second].waits_for;
  };
  for (std::size_t kind = 0; kind < row.children.size(); ++kind) {
    const ElementRow& child = row.children[kind];
    if (!child.is_group) continue;
    for (std::size_t i = 0; i < child.count(object); ++i) {
      const void* part = child.at(object, i);
      block_of_group.emplace(std::get<std::string>(child.attribute("name")->get(part)), blocks.size());
      blocks.push_back({{&child, part, {}}, kind, 0, {}});
      if (i > 0) follow(blocks.size() - 2, blocks.size() - 1);
    }
  }
  for (std::size_t kind = 0; kind < row.children.size(); ++kind) {
    const ElementRow& child = row.children[kind];
    if (child.is_group || child.count == nullptr) continue;
    const std::size_t count = child.required ? 1 : child.count(object);
    std::size_t previous = blocks.size();
    for (std::size_t i = 0; i < count; ++i) {
      const void* part = child.at(object, i);
      const std::string group = groupOf(child, part);
      std::size_t own = blocks.size();
      if (group.empty()) {
        blocks.push_back({{&child, part, {}}, kind, 0, {}});
      } else {
        const auto found = block_of_group.find(group);
        if (found == block_of_group.end()) {
          throw std::invalid_argument(
              fmt::format("write: a <{}> stands in group \"{}\", which does not exist", child.name, group));
        }
        own = found->second;
        blocks[own].part.members.push_back({&child, part, {}});
      }
      if (i > 0 && previous != own) follow(previous, own);
      previous = own;
    }
  }
  // Of the blocks that may come next, the first kind of the table does: elements, bodies, groups, wheelsets, ...
  std::set<std::pair<std::size_t, std::size_t>> ready;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].waits_for == 0) ready.emplace(blocks[i].kind, i);
  }
  std::vector<PartToWrite> order;
  while (!ready.empty()) {
    const std::size_t next = ready.begin()->second;
    ready.erase(ready.begin());
    for (const std::size_t follower : blocks[next].followers) {
      if (--blocks[follower].waits_for == 0) ready.emplace(blocks[follower].kind, follower);
    }
    order.push_back(std::move(blocks[next].part));
  }
  if (order.size() < blocks.size()) {
    throw std::invalid_argument(
        fmt::format("write: the parts of <{}> are in an order that its groups cannot give", row.name));
  }
  return order;
}

}  // namespace vehicle
