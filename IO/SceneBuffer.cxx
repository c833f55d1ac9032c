// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneBuffer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace littoral
{

namespace
{

int TypeOf(int components)
{
  return components == 1 ? TINYGLTF_TYPE_SCALAR : components;
}

}

//----------------------------------------------------------------------------
int SceneBuffer::AddView(const void* from, std::size_t bytes, int target)
{
  constexpr std::size_t alignment = 4;
  if (this->Model.buffers.empty())
  {
    this->Model.buffers.emplace_back();
  }
  std::vector<unsigned char>& data = this->Model.buffers[0].data;
  data.resize((data.size() + alignment - 1) / alignment * alignment);
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = bytes;
  view.target = target;
  const auto* first = static_cast<const unsigned char*>(from);
  data.insert(data.end(), first, first + bytes);
  this->Model.bufferViews.push_back(view);
  return static_cast<int>(this->Model.bufferViews.size()) - 1;
}

//----------------------------------------------------------------------------
int SceneBuffer::AddAccessor(int view, int component, int type, std::size_t count)
{
  tinygltf::Accessor accessor;
  accessor.bufferView = view;
  accessor.componentType = component;
  accessor.type = type;
  accessor.count = count;
  this->Model.accessors.push_back(accessor);
  return static_cast<int>(this->Model.accessors.size()) - 1;
}

//----------------------------------------------------------------------------
int SceneBuffer::AddBytes(const std::vector<unsigned char>& bytes)
{
  return this->AddView(bytes.data(), bytes.size(), 0);
}

//----------------------------------------------------------------------------
int SceneBuffer::AddNumbers(const std::vector<float>& numbers, int components)
{
  return this->AddAccessor(this->AddView(numbers.data(), numbers.size() * sizeof(float), 0),
    TINYGLTF_COMPONENT_TYPE_FLOAT, TypeOf(components), numbers.size() / components);
}

//----------------------------------------------------------------------------
int SceneBuffer::AddVertices(const std::vector<float>& numbers, int components)
{
  const int view = this->AddView(numbers.data(), numbers.size() * sizeof(float), TINYGLTF_TARGET_ARRAY_BUFFER);
  const int index =
    this->AddAccessor(view, TINYGLTF_COMPONENT_TYPE_FLOAT, TypeOf(components), numbers.size() / components);
  this->SetBounds(index, numbers, components);
  return index;
}

//----------------------------------------------------------------------------
int SceneBuffer::AddBounded(const std::vector<float>& numbers, int components)
{
  const int index = this->AddNumbers(numbers, components);
  this->SetBounds(index, numbers, components);
  return index;
}

//----------------------------------------------------------------------------
void SceneBuffer::SetBounds(int index, const std::vector<float>& numbers, int components)
{
  tinygltf::Accessor& accessor = this->Model.accessors[index];
  accessor.minValues.assign(components, std::numeric_limits<double>::infinity());
  accessor.maxValues.assign(components, -std::numeric_limits<double>::infinity());
  for (std::size_t number = 0; number < numbers.size(); ++number)
  {
    double& least = accessor.minValues[number % components];
    double& most = accessor.maxValues[number % components];
    least = std::min(least, static_cast<double>(numbers[number]));
    most = std::max(most, static_cast<double>(numbers[number]));
  }
}

//----------------------------------------------------------------------------
/// Each vertex has the room of four parts, since it has to begin at a multiple of four bytes.
int SceneBuffer::AddColors(const std::vector<float>& numbers, int components)
{
  constexpr float whole = 65535.0f;
  constexpr std::size_t room = 4;
  const std::size_t count = numbers.size() / components;
  std::vector<std::uint16_t> parts(room * count, 0);
  for (std::size_t number = 0; number < numbers.size(); ++number)
  {
    const float part = std::clamp(numbers[number], 0.0f, 1.0f);
    parts[room * (number / components) + number % components] = static_cast<std::uint16_t>(std::lround(whole * part));
  }
  const int view = this->AddView(parts.data(), parts.size() * sizeof(std::uint16_t), TINYGLTF_TARGET_ARRAY_BUFFER);
  this->Model.bufferViews[view].byteStride = room * sizeof(std::uint16_t);
  const int index = this->AddAccessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TypeOf(components), count);
  this->Model.accessors[index].normalized = true;
  return index;
}

//----------------------------------------------------------------------------
int SceneBuffer::AddJoints(const std::vector<std::uint16_t>& joints)
{
  const int view = this->AddView(joints.data(), joints.size() * sizeof(std::uint16_t), TINYGLTF_TARGET_ARRAY_BUFFER);
  return this->AddAccessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_VEC4, joints.size() / 4);
}

//----------------------------------------------------------------------------
/// Parts of 65535, whose sum is that: each is rounded with what the ones before it were off by.
int SceneBuffer::AddWeights(const std::vector<float>& weights)
{
  constexpr double whole = 65535.0;
  std::vector<std::uint16_t> parts;
  parts.reserve(weights.size());
  for (std::size_t first = 0; first < weights.size(); first += 4)
  {
    double sum = 0.0;
    long given = 0;
    for (std::size_t hold = 0; hold < 4; ++hold)
    {
      sum += static_cast<double>(weights[first + hold]);
      const long part = (hold == 3 ? static_cast<long>(whole) : std::lround(whole * sum)) - given;
      parts.push_back(static_cast<std::uint16_t>(part));
      given += part;
    }
  }
  const int view = this->AddView(parts.data(), parts.size() * sizeof(std::uint16_t), TINYGLTF_TARGET_ARRAY_BUFFER);
  const int index =
    this->AddAccessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_VEC4, parts.size() / 4);
  this->Model.accessors[index].normalized = true;
  return index;
}

//----------------------------------------------------------------------------
/// An accessor at the end of the view of samples, which is the last one: tuples are of four bytes or a multiple.
int SceneBuffer::AddShared(const void* from, std::size_t bytes, int component, int type, std::size_t count)
{
  if (this->Shared < 0 || this->Shared + 1 != static_cast<int>(this->Model.bufferViews.size()))
  {
    this->Shared = this->AddView(nullptr, 0, 0);
  }
  tinygltf::BufferView& view = this->Model.bufferViews[this->Shared];
  const std::size_t offset = view.byteLength;
  const auto* first = static_cast<const unsigned char*>(from);
  std::vector<unsigned char>& data = this->Model.buffers[0].data;
  data.insert(data.end(), first, first + bytes);
  view.byteLength += bytes;
  const int index = this->AddAccessor(this->Shared, component, type, count);
  this->Model.accessors[index].byteOffset = offset;
  return index;
}

//----------------------------------------------------------------------------
int SceneBuffer::AddRotations(const std::vector<std::int16_t>& rotations)
{
  const int index = this->AddShared(rotations.data(), rotations.size() * sizeof(std::int16_t),
    TINYGLTF_COMPONENT_TYPE_SHORT, TINYGLTF_TYPE_VEC4, rotations.size() / 4);
  this->Model.accessors[index].normalized = true;
  return index;
}

//----------------------------------------------------------------------------
int SceneBuffer::AddSamples(const std::vector<float>& numbers, int components)
{
  return this->AddShared(numbers.data(), numbers.size() * sizeof(float), TINYGLTF_COMPONENT_TYPE_FLOAT,
    TypeOf(components), numbers.size() / components);
}

//----------------------------------------------------------------------------
int SceneBuffer::AddInverses(const std::vector<float>& places)
{
  std::vector<float> columns;
  for (std::size_t place = 0; place < places.size(); place += 3)
  {
    columns.insert(columns.end(), { 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f });
    columns.insert(columns.end(), { -places[place], -places[place + 1], -places[place + 2], 1.0f });
  }
  const int view = this->AddView(columns.data(), columns.size() * sizeof(float), 0);
  return this->AddAccessor(view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_MAT4, columns.size() / 16);
}

//----------------------------------------------------------------------------
int SceneBuffer::AddIndices(const std::vector<std::uint32_t>& indices, std::size_t vertices)
{
  // The largest number of a type means a restart, not a vertex.
  if (vertices > std::numeric_limits<std::uint16_t>::max())
  {
    const int view =
      this->AddView(indices.data(), indices.size() * sizeof(std::uint32_t), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    return this->AddAccessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, indices.size());
  }
  const std::vector<std::uint16_t> halves(indices.begin(), indices.end());
  const int view =
    this->AddView(halves.data(), halves.size() * sizeof(std::uint16_t), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  return this->AddAccessor(view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR, indices.size());
}

}
