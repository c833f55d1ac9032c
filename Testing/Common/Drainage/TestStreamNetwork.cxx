// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Orders, streams and ratios of trees that are known, and of random ones walked naively.
#include "Drainage/StreamNetwork.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace littoral;

namespace
{

/// A stack of receivers of which each has a smaller index than its donors.
FlowRouting Downwards(std::vector<CellIndex> receivers)
{
  FlowRouting routing;
  routing.Receiver = std::move(receivers);
  for (std::size_t cell = 0; cell < routing.Receiver.size(); ++cell)
  {
    routing.Order.push_back(static_cast<CellIndex>(cell));
  }
  return routing;
}

/// Cells above each cell, itself included, by a walk downstream from every cell.
std::vector<CellIndex> WalkedCells(const FlowRouting& routing)
{
  std::vector<CellIndex> cells(routing.Receiver.size(), 0);
  for (std::size_t start = 0; start < cells.size(); ++start)
  {
    auto cell = static_cast<CellIndex>(start);
    ++cells[cell];
    while (routing.Receiver[cell] != cell)
    {
      cell = routing.Receiver[cell];
      ++cells[cell];
    }
  }
  return cells;
}

/// Strahler's definition, by recursion.
int OrderByDefinition(const FlowRouting& routing, const std::vector<CellIndex>& cells, CellIndex least, CellIndex cell)
{
  if (cells[cell] < least)
  {
    return 0;
  }
  std::vector<int> incoming;
  for (std::size_t donor = 0; donor < cells.size(); ++donor)
  {
    if (routing.Receiver[donor] == cell && static_cast<CellIndex>(donor) != cell)
    {
      incoming.push_back(OrderByDefinition(routing, cells, least, static_cast<CellIndex>(donor)));
    }
  }
  const int highest = incoming.empty() ? 0 : *std::max_element(incoming.begin(), incoming.end());
  if (highest == 0)
  {
    return 1;
  }
  return highest + (std::count(incoming.begin(), incoming.end(), highest) > 1 ? 1 : 0);
}

/// A grid on which every inner cell flows to one of the three cells below it (y - 1), at random.
FlowRouting RandomSlopes(int width, int height, unsigned seed)
{
  std::mt19937_64 engine(seed);
  std::vector<CellIndex> receivers;
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const bool isOutlet = i == 0 || j == 0 || i == width - 1 || j == height - 1;
      const int step = static_cast<int>(engine() % 3) - 1;
      receivers.push_back(isOutlet ? j * width + i : (j - 1) * width + i + step);
    }
  }
  return Downwards(std::move(receivers));
}

GridSamples Grid(int width, int height, double dx, double dy)
{
  GridSamples grid;
  grid.Width = width;
  grid.Height = height;
  grid.Spacing = { dx, dy };
  grid.Values.assign(static_cast<std::size_t>(width) * height, 0.0);
  return grid;
}

}

/// Node n of a heap flows to (n - 1)/2: an order for each row of the tree.
TEST(StreamNetwork, PerfectTree)
{
  constexpr int Rows = 9;
  std::vector<CellIndex> receivers{ 0 };
  for (CellIndex node = 1; node < (1 << Rows) - 1; ++node)
  {
    receivers.push_back((node - 1) / 2);
  }
  const FlowRouting routing = Downwards(receivers);
  const std::vector<int> orders = StrahlerOrders(routing, WalkedCells(routing), 1);
  for (std::size_t node = 0; node < orders.size(); ++node)
  {
    const int row = std::ilogb(static_cast<double>(node + 1));
    ASSERT_EQ(orders[node], Rows - row);
  }
}

/// A main stream keeps its order past tributaries of a lower one: 1 + 1 -> 2, 2 + 1 -> 2, 2 + 2 -> 3, and three of one.
TEST(StreamNetwork, Tributaries)
{
  const FlowRouting routing = Downwards({ 0, 0, 0, 1, 1, 2, 2, 2, 0, 3, 3, 4 });
  const std::vector<int> orders = StrahlerOrders(routing, WalkedCells(routing), 1);
  EXPECT_EQ(orders, (std::vector<int>{ 3, 2, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1 }));
}

TEST(StreamNetwork, OrdersByDefinition)
{
  for (unsigned seed : { 1u, 2u, 3u })
  {
    const FlowRouting routing = RandomSlopes(23, 31, seed);
    const std::vector<CellIndex> cells = WalkedCells(routing);
    for (CellIndex least : { 1, 4, 20 })
    {
      const std::vector<int> orders = StrahlerOrders(routing, cells, least);
      for (std::size_t cell = 0; cell < cells.size(); ++cell)
      {
        ASSERT_EQ(orders[cell], OrderByDefinition(routing, cells, least, static_cast<CellIndex>(cell)));
      }
    }
  }
}

/// Every cell of a stream belongs to one river, which falls, grows and lengthens as its cells tell.
TEST(StreamNetwork, RiversCoverStreams)
{
  GridSamples heights = Grid(41, 60, 2.0, 3.0);
  for (std::size_t n = 0; n < heights.Values.size(); ++n)
  {
    heights.Values[n] = 0.7 * static_cast<double>(n / heights.Width) + 1e-3 * static_cast<double>(n % 7);
  }
  const FlowRouting routing = RandomSlopes(heights.Width, heights.Height, 5);
  const std::vector<CellIndex> cells = WalkedCells(routing);
  const StreamNetwork network = FindStreams(heights, routing, cells, 3);
  std::vector<int> owners(cells.size(), 0);
  ASSERT_GT(network.Rivers.size(), 50u);
  for (const River& river : network.Rivers)
  {
    ASSERT_GE(river.Cells.size(), 2u);
    double length = 0.0;
    CellIndex own = river.Cells.front();
    for (std::size_t k = 0; k < river.Cells.size(); ++k)
    {
      const CellIndex cell = river.Cells[k];
      if (k > 0)
      {
        const CellIndex before = river.Cells[k - 1];
        ASSERT_EQ(routing.Receiver[before], cell);
        const int columns = cell % heights.Width - before % heights.Width;
        length += columns == 0 ? 3.0 : std::sqrt(13.0);
      }
      if (network.Orders[cell] == river.Order)
      {
        ++owners[cell];
        own = cell;
      }
      else
      {
        ASSERT_EQ(k, river.Cells.size() - 1);
        ASSERT_GT(network.Orders[cell], river.Order);
      }
    }
    EXPECT_DOUBLE_EQ(river.Length, length);
    EXPECT_DOUBLE_EQ(river.Area, 6.0 * cells[own]);
    EXPECT_DOUBLE_EQ(river.Slope, (heights.Values[river.Cells.front()] - heights.Values[river.Cells.back()]) / length);
  }
  for (std::size_t cell = 0; cell < owners.size(); ++cell)
  {
    const bool isStream = network.Orders[cell] > 0;
    const bool isOutlet = routing.Receiver[cell] == static_cast<CellIndex>(cell);
    ASSERT_TRUE(owners[cell] == (isStream ? 1 : 0) || (isOutlet && isStream && owners[cell] == 0));
  }
}

/// Water that runs straight down: a river in each column, of a known head, length, area and slope.
TEST(StreamNetwork, StraightRivers)
{
  GridSamples heights = Grid(6, 12, 5.0, 10.0);
  std::vector<CellIndex> receivers;
  for (int n = 0; n < 72; ++n)
  {
    const int i = n % 6;
    const int j = n / 6;
    heights.Values[n] = 0.25 * 10.0 * j;
    receivers.push_back(i == 0 || i == 5 || j == 0 || j == 11 ? n : n - 6);
  }
  const FlowRouting routing = Downwards(receivers);
  const StreamNetwork network = FindStreams(heights, routing, WalkedCells(routing), 3);
  ASSERT_EQ(network.Rivers.size(), 4u);
  for (const River& river : network.Rivers)
  {
    EXPECT_EQ(river.Order, 1);
    EXPECT_EQ(river.Cells.size(), 9u);
    EXPECT_DOUBLE_EQ(river.Length, 80.0);
    EXPECT_DOUBLE_EQ(river.Area, 11 * 50.0);
    EXPECT_DOUBLE_EQ(river.Slope, 0.25);
  }
  const std::vector<double> lengths = LongestFlowLengths(routing, CellLattice(heights));
  EXPECT_DOUBLE_EQ(lengths[1], 100.0);
  EXPECT_DOUBLE_EQ(lengths[10 * 6 + 1], 0.0);
}

TEST(StreamNetwork, LongestLengthsByWalks)
{
  const CellLattice lattice(17, 40, { 3.0, 4.0 });
  const FlowRouting routing = RandomSlopes(17, 40, 9);
  std::vector<double> walked(routing.Receiver.size(), 0.0);
  for (std::size_t start = 0; start < walked.size(); ++start)
  {
    double length = 0.0;
    for (auto cell = static_cast<CellIndex>(start); routing.Receiver[cell] != cell; cell = routing.Receiver[cell])
    {
      length += cell % 17 == routing.Receiver[cell] % 17 ? 4.0 : 5.0;
      walked[routing.Receiver[cell]] = std::max(walked[routing.Receiver[cell]], length);
    }
  }
  EXPECT_EQ(LongestFlowLengths(routing, lattice), walked);
}

/// Rivers whose numbers, lengths and areas are powers have the ratios of these.
TEST(StreamNetwork, HortonsLaws)
{
  std::vector<River> rivers;
  for (int order = 1; order <= 5; ++order)
  {
    for (int k = 0; k < std::lround(std::pow(4.0, 5 - order)); ++k)
    {
      River river;
      river.Order = order;
      river.Length = 7.0 * std::pow(2.3, order);
      river.Area = 3.0 * std::pow(4.6, order);
      rivers.push_back(river);
    }
  }
  const std::vector<StreamOrderClass> classes = ClassesByOrder(rivers);
  ASSERT_EQ(classes.size(), 5u);
  EXPECT_EQ(classes[1].Streams, 64);
  EXPECT_NEAR(classes[1].MeanLength, 7.0 * 2.3 * 2.3, 1e-10);
  const HortonRatios ratios = RatiosOf(classes);
  EXPECT_NEAR(ratios.Bifurcation, 4.0, 1e-12);
  EXPECT_NEAR(ratios.Length, 2.3, 1e-12);
  EXPECT_NEAR(ratios.Area, 4.6, 1e-12);
}

// The weight of an order is its number of streams: as if each of them were a point of its own.
TEST(StreamNetwork, RatiosAreThoseOfAllStreams)
{
  const std::vector<StreamOrderClass> classes{ { 1, 30, 100.0, 2000.0 }, { 2, 8, 260.0, 9000.0 },
    { 3, 2, 300.0, 50000.0 }, { 4, 1, 5000.0, 61000.0 } };
  double n = 0.0;
  double mean[2] = { 0.0, 0.0 };
  double products[2] = { 0.0, 0.0 };
  for (const StreamOrderClass& own : classes)
  {
    for (int stream = 0; stream < own.Streams; ++stream)
    {
      const double values[2] = { static_cast<double>(own.Order), std::log(own.MeanLength) };
      n += 1.0;
      for (int i : { 0, 1 })
      {
        mean[i] += values[i];
        products[i] += values[0] * values[i];
      }
    }
  }
  const double slope = (n * products[1] - mean[0] * mean[1]) / (n * products[0] - mean[0] * mean[0]);
  EXPECT_NEAR(RatiosOf(classes).Length, std::exp(slope), 1e-10);
}

TEST(StreamNetwork, OneOrderHasNoRatios)
{
  EXPECT_TRUE(std::isnan(RatiosOf({ { 1, 12, 100.0, 2000.0 } }).Bifurcation));
  EXPECT_TRUE(std::isnan(RatiosOf({}).Length));
}
