// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Drainage/StreamNetwork.h"

#include "Drainage/LeastSquaresLine.h"

#include <algorithm>
#include <cmath>

namespace littoral
{

namespace
{

/// Whether a cell drains to another one.
bool Flows(const FlowRouting& routing, CellIndex cell)
{
  return routing.Receiver[cell] != cell;
}

/// Length of the step from a cell to its receiver [m].
double StepLength(const FlowRouting& routing, const CellLattice& lattice, CellIndex cell)
{
  return lattice.Distance(lattice.DirectionTo(cell, routing.Receiver[cell]));
}

/// Marks of the heads of streams: cells of streams into which no stream of their own order comes.
std::vector<bool> HeadsOf(const FlowRouting& routing, const std::vector<int>& orders)
{
  std::vector<bool> isHead(orders.size());
  for (std::size_t cell = 0; cell < orders.size(); ++cell)
  {
    isHead[cell] = orders[cell] > 0;
  }
  for (std::size_t cell = 0; cell < orders.size(); ++cell)
  {
    const CellIndex receiver = routing.Receiver[cell];
    if (Flows(routing, static_cast<CellIndex>(cell)) && orders[cell] == orders[receiver])
    {
      isHead[receiver] = false;
    }
  }
  return isHead;
}

}

std::vector<int> StrahlerOrders(
  const FlowRouting& routing, const std::vector<CellIndex>& accumulation, CellIndex threshold, const Poll& poll)
{
  SteppedPoll steps(poll, 1 << 16);
  // The highest order that comes into a cell, and how many streams of it do; upstream cells are last in the order.
  std::vector<int> highest(routing.Receiver.size(), 0);
  std::vector<unsigned char> count(routing.Receiver.size(), 0);
  std::vector<int> orders(routing.Receiver.size(), 0);
  for (auto next = routing.Order.rbegin(); next != routing.Order.rend(); ++next)
  {
    steps.Step();
    const CellIndex cell = *next;
    if (accumulation[cell] < threshold)
    {
      continue;
    }
    orders[cell] = highest[cell] == 0 ? 1 : highest[cell] + (count[cell] > 1 ? 1 : 0);
    const CellIndex receiver = routing.Receiver[cell];
    if (receiver == cell)
    {
      continue;
    }
    if (orders[cell] > highest[receiver])
    {
      highest[receiver] = orders[cell];
      count[receiver] = 1;
    }
    else if (orders[cell] == highest[receiver])
    {
      ++count[receiver];
    }
  }
  return orders;
}

StreamNetwork FindStreams(const GridSamples& heights, const FlowRouting& routing,
  const std::vector<CellIndex>& accumulation, CellIndex threshold, const Poll& poll)
{
  SteppedPoll steps(poll, 1 << 16);
  const CellLattice lattice(heights);
  StreamNetwork network;
  network.Orders = StrahlerOrders(routing, accumulation, threshold, poll);
  const std::vector<bool> isHead = HeadsOf(routing, network.Orders);
  for (CellIndex head = 0; head < lattice.Count(); ++head)
  {
    steps.Step();
    if (!isHead[head] || !Flows(routing, head))
    {
      continue;
    }
    River river;
    river.Order = network.Orders[head];
    CellIndex own = head;
    for (CellIndex cell = head;; cell = routing.Receiver[cell])
    {
      river.Cells.push_back(cell);
      if (network.Orders[cell] != river.Order)
      {
        break;
      }
      own = cell;
      if (!Flows(routing, cell))
      {
        break;
      }
      river.Length += StepLength(routing, lattice, cell);
    }
    river.Area = accumulation[own] * lattice.CellArea();
    river.Slope = (heights.Values[head] - heights.Values[river.Cells.back()]) / river.Length;
    network.Rivers.push_back(std::move(river));
  }
  return network;
}

std::vector<double> LongestFlowLengths(const FlowRouting& routing, const CellLattice& lattice)
{
  std::vector<double> lengths(routing.Receiver.size(), 0.0);
  for (auto next = routing.Order.rbegin(); next != routing.Order.rend(); ++next)
  {
    if (Flows(routing, *next))
    {
      // L_r = max(L_r, L + d)
      double& below = lengths[routing.Receiver[*next]];
      below = std::max(below, lengths[*next] + StepLength(routing, lattice, *next));
    }
  }
  return lengths;
}

std::vector<StreamOrderClass> ClassesByOrder(const std::vector<River>& rivers)
{
  std::vector<StreamOrderClass> classes;
  for (const River& river : rivers)
  {
    while (static_cast<int>(classes.size()) < river.Order)
    {
      classes.push_back({ static_cast<int>(classes.size()) + 1, 0, 0.0, 0.0 });
    }
    StreamOrderClass& own = classes[river.Order - 1];
    ++own.Streams;
    own.MeanLength += river.Length;
    own.MeanArea += river.Area;
  }
  for (StreamOrderClass& own : classes)
  {
    own.MeanLength /= std::max(own.Streams, 1);
    own.MeanArea /= std::max(own.Streams, 1);
  }
  return classes;
}

HortonRatios RatiosOf(const std::vector<StreamOrderClass>& classes)
{
  // ln N = a - w ln R_B, ln L = b + w ln R_L, ln A = c + w ln R_A; the variance of each is as 1 / N
  std::vector<double> orders;
  std::vector<double> numbers;
  std::vector<double> lengths;
  std::vector<double> areas;
  std::vector<double> weights;
  for (const StreamOrderClass& own : classes)
  {
    if (own.Streams > 0)
    {
      orders.push_back(own.Order);
      numbers.push_back(std::log(own.Streams));
      lengths.push_back(std::log(own.MeanLength));
      areas.push_back(std::log(own.MeanArea));
      weights.push_back(own.Streams);
    }
  }
  return { std::exp(-LineThrough(orders, numbers, weights).Slope),
    std::exp(LineThrough(orders, lengths, weights).Slope), std::exp(LineThrough(orders, areas, weights).Slope) };
}

}
