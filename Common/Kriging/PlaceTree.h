// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralPlaceTree_h
#define LittoralPlaceTree_h

#include "Kriging/CovarianceTable.h"

#include <nanoflann.hpp>

#include <cstddef>
#include <vector>

namespace littoral
{

/// Search for the nearest of many places, by a k-d tree.
class PlaceTree
{
public:
  /// The places must stay where they are.
  explicit PlaceTree(const std::vector<ReducedPlace>& places)
    : Points{ places }
    , Tree(2, Points, nanoflann::KDTreeSingleIndexAdaptorParams(16))
  {
    this->Tree.buildIndex();
  }
  PlaceTree(const PlaceTree&) = delete;
  PlaceTree& operator=(const PlaceTree&) = delete;

  /// Indices of the nearest places, at most `count`, by distance.
  void Nearest(const ReducedPlace& place, std::size_t count, std::vector<std::size_t>& found) const
  {
    found.resize(count);
    this->Squares().resize(count);
    found.resize(this->Tree.knnSearch(place.data(), count, found.data(), this->Squares().data()));
  }

private:
  struct Cloud
  {
    const std::vector<ReducedPlace>& Places;

    std::size_t kdtree_get_point_count() const { return this->Places.size(); }
    double kdtree_get_pt(std::size_t index, std::size_t axis) const { return this->Places[index][axis]; }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const
    {
      return false;
    }
  };
  using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 2, std::size_t>;

  static std::vector<double>& Squares()
  {
    thread_local std::vector<double> squares;
    return squares;
  }

  Cloud Points;
  Index Tree;
};

}

#endif
