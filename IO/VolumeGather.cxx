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

bool IsAlone(vtkMultiProcessController* controller)
{
  return !controller || controller->GetNumberOfProcesses() < 2;
}

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

bool IsDense(const VolumeBlock& block, int components)
{
  return block.Stride == static_cast<std::size_t>(components);
}

/// Why there is no memory to send one block after the other; empty if there is.
std::string WhyNotPacked(const std::vector<Volume>& volumes)
{
  double bytes = 0.0;
  for (const Volume& volume : volumes)
  {
    for (const VolumeBlock& block : volume.Blocks)
    {
      const bool dense = IsDense(block, volume.Components);
      bytes = std::max(bytes, dense ? 0.0 : sizeof(float) * volume.Components * static_cast<double>(block.Count()));
    }
  }
  return WhyRefused([&] { RequireMemory(bytes, "A part of the volumes", "take a smaller or coarser grid"); });
}

/// A block's values without gaps between the samples.
std::vector<float> Packed(const VolumeBlock& block, int components)
{
  std::vector<float> values;
  values.reserve(block.Count() * components);
  for (std::size_t sample = 0; sample < block.Count(); ++sample)
  {
    const float* from = block.Values + sample * block.Stride;
    values.insert(values.end(), from, from + components);
  }
  return values;
}

void SendBlock(vtkMultiProcessController* controller, const VolumeBlock& block, int components)
{
  const bool dense = IsDense(block, components);
  const std::vector<float> packed = dense ? std::vector<float>() : Packed(block, components);
  controller->Send(
    dense ? block.Values : packed.data(), static_cast<vtkIdType>(block.Count()) * components, 0, ValuesTag);
  if (block.Ghosts && block.Hidden)
  {
    controller->Send(block.Ghosts, static_cast<vtkIdType>(block.Count()), 0, GhostsTag);
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

void ReceiveBlock(vtkMultiProcessController* controller, VolumeBlock& block, int components, int rank)
{
  block.Stride = components;
  block.Values = ReceiveInto<float>(controller, block, block.Count() * components, rank, ValuesTag);
  if (block.Hidden)
  {
    block.Ghosts = ReceiveInto<unsigned char>(controller, block, block.Count(), rank, GhostsTag);
  }
}

void SendShapes(vtkMultiProcessController* controller, const VolumeInput& input)
{
  vtkMultiProcessStream head;
  const std::string reason = input.Reason.empty() ? WhyNotPacked(input.Volumes) : input.Reason;
  head << reason << static_cast<vtkTypeInt64>(input.Samples) << static_cast<int>(input.Volumes.size());
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
  int volumes;
  head >> reason >> samples >> volumes;
  input.Samples += static_cast<std::size_t>(samples);
  if (input.Reason.empty())
  {
    input.Reason = reason;
  }
  for (int n = 0; n < volumes; ++n)
  {
    Volume volume;
    volume.Rank = rank;
    Take(head, volume);
    input.Volumes.push_back(volume);
  }
}

}

bool IsFirstRank(vtkMultiProcessController* controller)
{
  return IsAlone(controller) || controller->GetLocalProcessId() == 0;
}

void GatherShapes(vtkMultiProcessController* controller, VolumeInput& input)
{
  if (IsAlone(controller))
  {
    return;
  }
  if (!IsFirstRank(controller))
  {
    SendShapes(controller, input);
    return;
  }
  for (int rank = 1; rank < controller->GetNumberOfProcesses(); ++rank)
  {
    ReceiveShapes(controller, input, rank);
  }
}

void GatherValues(vtkMultiProcessController* controller, VolumeInput& input)
{
  for (Volume& volume : input.Volumes)
  {
    for (VolumeBlock& block : volume.Blocks)
    {
      if (!IsFirstRank(controller))
      {
        SendBlock(controller, block, volume.Components);
      }
      else if (volume.Rank != 0)
      {
        ReceiveBlock(controller, block, volume.Components, volume.Rank);
      }
    }
  }
}

bool ShareAnswer(vtkMultiProcessController* controller, bool answer)
{
  int shared = answer;
  if (!IsAlone(controller))
  {
    controller->Broadcast(&shared, 1, 0);
  }
  return shared != 0;
}

}
