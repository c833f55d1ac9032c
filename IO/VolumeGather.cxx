// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeGather.h"

#include "Numerics/InvalidInput.h"
#include "Pipeline/Memory.h"

#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"

#include <algorithm>

namespace littoral
{

namespace
{

constexpr int HeadTag = 78120;
constexpr int ValuesTag = 78121;
constexpr int GhostsTag = 78122;
constexpr int RequestTag = 78123;

void Put(vtkMultiProcessStream& stream, const VolumeRemarks& remarks)
{
  stream << static_cast<int>(remarks.size());
  for (const auto& [name, remark] : remarks)
  {
    stream << name << static_cast<int>(remark.index());
    if (const auto* text = std::get_if<std::string>(&remark))
    {
      stream << *text;
    }
    else if (const auto* number = std::get_if<double>(&remark))
    {
      stream << *number;
    }
    else
    {
      const auto& triple = std::get<2>(remark);
      stream << triple[0] << triple[1] << triple[2];
    }
  }
}

void Take(vtkMultiProcessStream& stream, VolumeRemarks& remarks)
{
  int count;
  stream >> count;
  for (int n = 0; n < count; ++n)
  {
    std::string name;
    int kind;
    stream >> name >> kind;
    if (kind == 0)
    {
      std::string text;
      stream >> text;
      remarks[name] = text;
    }
    else if (kind == 1)
    {
      double number;
      stream >> number;
      remarks[name] = number;
    }
    else
    {
      std::array<double, 3> triple;
      stream >> triple[0] >> triple[1] >> triple[2];
      remarks[name] = triple;
    }
  }
}

/// The twelve numbers of a lattice.
template <typename Lattice, typename Visit>
void EachNumber(Lattice& lattice, const Visit& visit)
{
  for (auto& number : lattice.Origin)
  {
    visit(number);
  }
  for (auto& step : lattice.Step)
  {
    for (auto& number : step)
    {
      visit(number);
    }
  }
}

void Put(vtkMultiProcessStream& stream, const Volume& volume)
{
  stream << volume.Place << volume.Array << volume.Components << static_cast<int>(volume.Vectors);
  EachNumber(volume.Lattice, [&](double number) { stream << number; });
  Put(stream, volume.Remarks);
  stream << static_cast<int>(volume.Blocks.size());
  for (const VolumeBlock& block : volume.Blocks)
  {
    for (int bound : block.Extent)
    {
      stream << bound;
    }
    stream << static_cast<int>(block.Ghosts ? block.Hidden : 0);
  }
}

void Take(vtkMultiProcessStream& stream, Volume& volume)
{
  int vectors, blocks;
  stream >> volume.Place >> volume.Array >> volume.Components >> vectors;
  volume.Vectors = static_cast<VolumeVectors>(vectors);
  EachNumber(volume.Lattice, [&](double& number) { stream >> number; });
  Take(stream, volume.Remarks);
  stream >> blocks;
  volume.Blocks.resize(blocks);
  for (VolumeBlock& block : volume.Blocks)
  {
    for (int& bound : block.Extent)
    {
      stream >> bound;
    }
    int hidden;
    stream >> hidden;
    block.Hidden = static_cast<unsigned char>(hidden);
  }
}

/// Why there is no memory to send a box of a block; empty if there is.
std::string WhyNotPacked(const std::vector<Volume>& volumes)
{
  double bytes = 0.0;
  for (const Volume& volume : volumes)
  {
    for (const VolumeBlock& block : volume.Blocks)
    {
      bytes = std::max(bytes, BytesToLoad(block, volume.Components));
    }
  }
  return WhyRefused([&] { RequireMemory(bytes, "A part of the volumes", "take a smaller or coarser grid"); });
}

/// Visits the rows of a box of a block: the places of their first samples, and their lengths.
template <typename Visit>
void EachRow(const VolumeBlock& block, const std::array<int, 6>& box, const Visit& visit)
{
  for (int z = box[4]; z <= box[5]; ++z)
  {
    for (int y = box[2]; y <= box[3]; ++y)
    {
      visit(block.Place(box[0], y, z), static_cast<std::size_t>(box[1] - static_cast<long long>(box[0]) + 1));
    }
  }
}

void SendBox(
  vtkMultiProcessController* controller, const VolumeBlock& block, int components, const std::array<int, 6>& box)
{
  VolumeBlock part;
  part.Extent = box;
  std::vector<float> values;
  std::vector<unsigned char> ghosts;
  values.reserve(part.Count() * components);
  EachRow(block, box, [&](std::size_t first, std::size_t length) {
    for (std::size_t sample = first; sample < first + length; ++sample)
    {
      const float* from = block.Values + sample * block.Stride;
      values.insert(values.end(), from, from + components);
    }
    if (block.Ghosts && block.Hidden)
    {
      ghosts.insert(ghosts.end(), block.Ghosts + first, block.Ghosts + first + length);
    }
  });
  controller->Send(values.data(), static_cast<vtkIdType>(values.size()), 0, ValuesTag);
  if (!ghosts.empty())
  {
    controller->Send(ghosts.data(), static_cast<vtkIdType>(ghosts.size()), 0, GhostsTag);
  }
}

template <typename Number>
const Number* ReceiveInto(
  vtkMultiProcessController* controller, VolumeBlock& block, std::size_t count, int rank, int tag)
{
  auto numbers = std::make_shared<std::vector<Number>>(count);
  controller->Receive(numbers->data(), static_cast<vtkIdType>(count), rank, tag);
  block.Own.push_back(numbers);
  return numbers->data();
}

/// The numbers of a volume and of a block of it, and a box, that a rank is asked for; a volume below 0 ends it.
using Request = std::array<int, 8>;

/// A box of a block of another rank.
VolumeBlock LoadedBox(
  vtkMultiProcessController* controller, int rank, const Request& request, int components, int hidden)
{
  controller->Send(request.data(), static_cast<vtkIdType>(request.size()), rank, RequestTag);
  VolumeBlock part;
  std::copy(request.begin() + 2, request.end(), part.Extent.begin());
  part.Stride = static_cast<std::size_t>(components);
  part.Values = ReceiveInto<float>(controller, part, part.Count() * components, rank, ValuesTag);
  part.Hidden = static_cast<unsigned char>(hidden);
  if (hidden != 0)
  {
    part.Ghosts = ReceiveInto<unsigned char>(controller, part, part.Count(), rank, GhostsTag);
  }
  return part;
}

bool IsEmpty(const std::array<int, 6>& extent)
{
  return extent[1] < extent[0] || extent[3] < extent[2] || extent[5] < extent[4];
}

std::array<int, 6> Union(const std::array<int, 6>& a, const std::array<int, 6>& b)
{
  std::array<int, 6> both = IsEmpty(a) ? b : a;
  for (int axis = 0; axis < 3 && !IsEmpty(b); ++axis)
  {
    both[2 * axis] = std::min(both[2 * axis], b[2 * axis]);
    both[2 * axis + 1] = std::max(both[2 * axis + 1], b[2 * axis + 1]);
  }
  return both;
}

void SendShapes(vtkMultiProcessController* controller, const VolumeInput& input)
{
  vtkMultiProcessStream head;
  const std::string reason = input.Reason.empty() ? WhyNotPacked(input.Volumes) : input.Reason;
  head << reason << static_cast<vtkTypeInt64>(input.Samples);
  for (const int bound : input.Extent)
  {
    head << bound;
  }
  Put(head, input.Remarks);
  head << static_cast<int>(input.Volumes.size());
  for (const Volume& volume : input.Volumes)
  {
    Put(head, volume);
  }
  controller->Send(head, 0, HeadTag);
}

void ReceiveShapes(vtkMultiProcessController* controller, VolumeInput& input, int rank)
{
  vtkMultiProcessStream head;
  controller->Receive(head, rank, HeadTag);
  std::string reason;
  vtkTypeInt64 samples;
  std::array<int, 6> extent;
  VolumeRemarks remarks;
  int volumes;
  head >> reason >> samples;
  for (int& bound : extent)
  {
    head >> bound;
  }
  Take(head, remarks);
  head >> volumes;
  input.Remarks = input.Samples == 0 ? remarks : input.Remarks; // of the first rank that has samples
  input.Samples += static_cast<std::size_t>(samples);
  input.Extent = Union(input.Extent, extent);
  if (input.Reason.empty())
  {
    input.Reason = reason;
  }
  for (int n = 0; n < volumes; ++n)
  {
    Volume volume;
    volume.Rank = rank;
    Take(head, volume);
    for (std::size_t index = 0; index < volume.Blocks.size(); ++index)
    {
      VolumeBlock& block = volume.Blocks[index];
      block.Load = [=, components = volume.Components, hidden = static_cast<int>(block.Hidden)](
                     const std::array<int, 6>& box) {
        Request request{ { n, static_cast<int>(index) } };
        std::copy(box.begin(), box.end(), request.begin() + 2);
        return LoadedBox(controller, rank, request, components, hidden);
      };
    }
    input.Volumes.push_back(volume);
  }
}

}

void GatherShapes(const WriterRanks& ranks, VolumeInput& input)
{
  for (int rank = 1; ranks.IsFirst() && rank < ranks.GetNumberOfRanks(); ++rank)
  {
    ReceiveShapes(ranks.GetController(), input, rank);
  }
  if (!ranks.IsFirst())
  {
    SendShapes(ranks.GetController(), input);
  }
}

VolumeServing::~VolumeServing()
{
  const Request end{ { -1 } };
  for (int rank = 1; this->Ranks.IsFirst() && rank < this->Ranks.GetNumberOfRanks(); ++rank)
  {
    this->Ranks.GetController()->Send(end.data(), static_cast<vtkIdType>(end.size()), rank, RequestTag);
  }
}

void VolumeServing::Serve(const VolumeInput& input) const
{
  for (;;)
  {
    Request request;
    this->Ranks.GetController()->Receive(request.data(), static_cast<vtkIdType>(request.size()), 0, RequestTag);
    if (request[0] < 0)
    {
      return;
    }
    const Volume& volume = input.Volumes[request[0]];
    std::array<int, 6> box;
    std::copy(request.begin() + 2, request.end(), box.begin());
    SendBox(this->Ranks.GetController(), volume.Blocks[request[1]], volume.Components, box);
  }
}

}
