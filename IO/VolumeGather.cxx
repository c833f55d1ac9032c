// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeGather.h"

#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"

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
  const bool dense = block.Stride == static_cast<std::size_t>(components);
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

void SendVolumes(vtkMultiProcessController* controller, const VolumeInput& input)
{
  vtkMultiProcessStream head;
  head << input.Reason << static_cast<vtkTypeInt64>(input.Samples);
  const int volumes = input.Reason.empty() ? static_cast<int>(input.Volumes.size()) : 0;
  head << volumes;
  for (int n = 0; n < volumes; ++n)
  {
    Put(head, input.Volumes[n]);
  }
  controller->Send(head, 0, HeadTag);
  for (int n = 0; n < volumes; ++n)
  {
    for (const VolumeBlock& block : input.Volumes[n].Blocks)
    {
      SendBlock(controller, block, input.Volumes[n].Components);
    }
  }
}

void ReceiveVolumes(vtkMultiProcessController* controller, VolumeInput& input, int rank)
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
    Take(head, volume);
    input.Volumes.push_back(volume);
  }
  for (auto volume = input.Volumes.end() - volumes; volume != input.Volumes.end(); ++volume)
  {
    for (VolumeBlock& block : volume->Blocks)
    {
      ReceiveBlock(controller, block, volume->Components, rank);
    }
  }
}

}

bool IsFirstRank(vtkMultiProcessController* controller)
{
  return IsAlone(controller) || controller->GetLocalProcessId() == 0;
}

void GatherVolumes(vtkMultiProcessController* controller, VolumeInput& input)
{
  if (IsAlone(controller))
  {
    return;
  }
  if (!IsFirstRank(controller))
  {
    SendVolumes(controller, input);
    return;
  }
  for (int rank = 1; rank < controller->GetNumberOfProcesses(); ++rank)
  {
    ReceiveVolumes(controller, input, rank);
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
