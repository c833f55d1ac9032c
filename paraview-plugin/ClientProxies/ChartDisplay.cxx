// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ChartDisplay.h"

#include "SceneView.h"

#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyIterator.h"
#include "vtkSMProxyManager.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewLayoutProxy.h"
#include "vtkSMViewProxy.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <set>
#include <sstream>

namespace littoral
{
namespace
{

/// Ink, then colors that all readers can tell apart (Okabe and Ito), in the order of series.
constexpr std::array<std::array<double, 3>, 6> Palette{ { { 0.15, 0.15, 0.15 }, { 0.0, 0.447, 0.698 },
  { 0.835, 0.369, 0.0 }, { 0.0, 0.62, 0.451 }, { 0.8, 0.475, 0.655 }, { 0.65, 0.7, 0.75 } } };

// Numbers of vtkPlotPoints and vtkPen.
constexpr int CircleMarker = 4;
constexpr int NoMarker = 0;
constexpr int NoLine = 0;
/// Solid, dashed, dash-dotted: of the first, second and third of several lines.
constexpr std::array<int, 3> LineStyles{ 1, 2, 4 };

const char* TextOf(vtkPVXMLElement* element, const char* attribute)
{
  const char* text = element->GetAttribute(attribute);
  return text ? text : "";
}

int NumberOf(vtkPVXMLElement* element, const char* attribute, int otherwise)
{
  const char* text = element->GetAttribute(attribute);
  return text ? static_cast<int>(std::strtol(text, nullptr, 10)) : otherwise;
}

/// The name of a column in words: "NegativeBinomial" is "Negative Binomial".
std::string InWords(const std::string& name)
{
  std::string words;
  for (std::size_t k = 0; k < name.size(); ++k)
  {
    const bool starts = std::isupper(static_cast<unsigned char>(name[k])) ||
      (std::isdigit(static_cast<unsigned char>(name[k])) &&
        !std::isdigit(static_cast<unsigned char>(name[k - (k > 0)])));
    words += std::string(k > 0 && starts ? 1 : 0, ' ') + name[k];
  }
  return words;
}

/// Names of the columns of a table.
std::vector<std::string> ColumnsOf(vtkPVDataInformation* data)
{
  std::vector<std::string> names;
  vtkPVDataSetAttributesInformation* columns = data->GetRowDataInformation();
  names.reserve(columns->GetNumberOfArrays());
  for (int k = 0; k < columns->GetNumberOfArrays(); ++k)
  {
    names.emplace_back(columns->GetArrayInformation(k)->GetName());
  }
  return names;
}

/// Names of the visible series of a chart.
std::set<std::string> VisibleSeries(vtkSMProxy* representation)
{
  std::set<std::string> names;
  const vtkSMPropertyHelper series(representation, "SeriesVisibility");
  for (unsigned int k = 0; k + 1 < series.GetNumberOfElements(); k += 2)
  {
    if (std::strtol(series.GetAsString(k + 1), nullptr, 10) != 0)
    {
      names.insert(series.GetAsString(k));
    }
  }
  return names;
}

/// Whether a view shows nothing but one representation.
bool ShowsOnly(vtkSMProxy* view, vtkSMProxy* representation)
{
  const vtkSMPropertyHelper shown(view, "Representations");
  for (unsigned int k = 0; k < shown.GetNumberOfElements(); ++k)
  {
    vtkSMProxy* one = shown.GetAsProxy(k);
    if (one && one != representation && one->GetProperty("Input") &&
      vtkSMPropertyHelper(one, "Visibility", true).GetAsInt() != 0)
    {
      return false;
    }
  }
  return true;
}

}

//----------------------------------------------------------------------------
ChartDisplay::~ChartDisplay()
{
  StopObserving(this->Views);
  StopObserving(this->Pictures);
  if (this->Manager)
  {
    this->Manager->RemoveObserver(this->RegisterObserver);
    this->Owner->RemoveObserver(this->DataObserver);
  }
}

//----------------------------------------------------------------------------
void ChartDisplay::Watch()
{
  if (!this->Manager && this->Owner->GetSession())
  {
    this->Manager = this->Owner->GetSessionProxyManager();
    this->RegisterObserver = this->Manager->AddObserver(vtkCommand::RegisterEvent, this, &ChartDisplay::OnRegister);
    this->DataObserver = this->Owner->AddObserver(vtkCommand::UpdateDataEvent, this, &ChartDisplay::OnData);
  }
}

//----------------------------------------------------------------------------
vtkPVXMLElement* ChartDisplay::Hint(const char* name, int port)
{
  vtkPVXMLElement* hints = this->Owner->GetHints();
  for (unsigned int k = 0; hints && k < hints->GetNumberOfNestedElements(); ++k)
  {
    vtkPVXMLElement* hint = hints->GetNestedElement(k);
    if (std::strcmp(hint->GetName(), name) == 0 && NumberOf(hint, "port", 0) == port)
    {
      return hint;
    }
  }
  return nullptr;
}

//----------------------------------------------------------------------------
/// First values of a column of text.
std::vector<std::string> ChartDisplay::TextsOf(const char* column, int port, int count)
{
  std::vector<std::string> texts;
  vtkPVArrayInformation* array = this->Owner->GetDataInformation(port)->GetArrayInformation(column, vtkDataObject::ROW);
  for (int k = 0; array && k < std::min(count, array->GetNumberOfStringValues()); ++k)
  {
    texts.emplace_back(array->GetStringValue(k));
  }
  return texts;
}

//----------------------------------------------------------------------------
std::vector<ChartDisplay::Series> ChartDisplay::SeriesOf(vtkPVXMLElement* hint)
{
  std::vector<Series> series;
  for (unsigned int k = 0; k < hint->GetNumberOfNestedElements(); ++k)
  {
    vtkPVXMLElement* element = hint->GetNestedElement(k);
    const char* column = element->GetAttribute("names");
    const std::vector<std::string> names = column
      ? this->TextsOf(column, NumberOf(element, "of-port", 0), NumberOf(element, "count", 1))
      : std::vector<std::string>{ TextOf(element, "name") };
    for (const std::string& name : names)
    {
      const char* label = element->GetAttribute("label");
      const int color = NumberOf(element, "color", static_cast<int>(series.size()));
      const std::size_t order = column ? static_cast<std::size_t>(&name - names.data()) : 0;
      series.push_back(
        { name, label ? label : InWords(name), element->GetName(), color, LineStyles[order % LineStyles.size()] });
    }
  }
  return series;
}

//----------------------------------------------------------------------------
void ChartDisplay::OnRegister(vtkObject*, unsigned long, void* information)
{
  const auto* registered = static_cast<vtkSMProxyManager::RegisteredProxyInformation*>(information);
  if (registered->Type != vtkSMProxyManager::RegisteredProxyInformation::PROXY || !registered->GroupName ||
    std::strcmp(registered->GroupName, "representations") != 0 || this->Manager->GetInLoadXMLState() ||
    !registered->Proxy->GetProperty("Input"))
  {
    return;
  }
  vtkSMProxy* representation = registered->Proxy;
  const vtkSMPropertyHelper input(representation, "Input");
  if (input.GetAsProxy() != this->Owner)
  {
    return;
  }
  const int port = input.GetOutputPort();
  vtkPVXMLElement* hint = this->Hint("ChartDisplay", port);
  if (hint && representation->GetProperty("SeriesVisibility"))
  {
    this->Charts.push_back({ representation, port, {} });
    const std::vector<Series> series = this->SeriesOf(hint);
    this->DrawSeries(representation, hint, series);
  }
  this->WaitForView(representation, port);
}

//----------------------------------------------------------------------------
void ChartDisplay::DrawSeries(vtkSMProxy* representation, vtkPVXMLElement* hint, const std::vector<Series>& series)
{
  vtkSMPropertyHelper(representation, "UseIndexForXAxis").Set(0);
  vtkSMPropertyHelper(representation, "XArrayName").Set(TextOf(hint, "x"));
  vtkSMPropertyHelper visible(representation, "SeriesVisibility");
  for (const std::string& name : VisibleSeries(representation))
  {
    visible.SetStatus(name.c_str(), 0);
  }
  const bool isLineChart = representation->GetProperty("SeriesMarkerStyle") != nullptr;
  for (const Series& one : series)
  {
    const char* name = one.Name.c_str();
    visible.SetStatus(name, 1);
    vtkSMPropertyHelper(representation, "SeriesLabel").SetStatus(name, one.Label.c_str());
    std::array<double, 3> color = Palette[static_cast<std::size_t>(one.Color) % Palette.size()];
    vtkSMPropertyHelper(representation, "SeriesColor").SetStatus(name, color.data(), 3);
    if (isLineChart)
    {
      const bool isPoints = one.Style == "Points";
      vtkSMPropertyHelper(representation, "SeriesMarkerStyle").SetStatus(name, isPoints ? CircleMarker : NoMarker);
      vtkSMPropertyHelper(representation, "SeriesMarkerSize").SetStatus(name, 6);
      vtkSMPropertyHelper(representation, "SeriesLineStyle").SetStatus(name, isPoints ? NoLine : one.LineStyle);
      vtkSMPropertyHelper(representation, "SeriesLineThickness").SetStatus(name, 2);
    }
  }
  representation->UpdateVTKObjects();
  for (Chart& chart : this->Charts)
  {
    if (chart.Representation == representation)
    {
      chart.Names.clear();
      std::transform(
        series.begin(), series.end(), std::back_inserter(chart.Names), [](const Series& one) { return one.Name; });
    }
  }
}

//----------------------------------------------------------------------------
/// Other data may have other series: the best models of another terrain.
void ChartDisplay::OnData(vtkObject*, unsigned long, void*)
{
  if (vtkSMProxy* view = ViewOfScene(this->Manager))
  {
    this->FormerView = view;
  }
  const auto isGone = [](const Chart& chart) { return !chart.Representation; };
  this->Charts.erase(std::remove_if(this->Charts.begin(), this->Charts.end(), isGone), this->Charts.end());
  const std::vector<Chart> charts = this->Charts;
  for (const Chart& chart : charts)
  {
    vtkPVXMLElement* hint = this->Hint("ChartDisplay", chart.Port);
    const std::vector<Series> series = this->SeriesOf(hint);
    const bool isSame = std::equal(series.begin(), series.end(), chart.Names.begin(), chart.Names.end(),
      [](const Series& one, const std::string& name) { return one.Name == name; });
    const bool isUntouched =
      VisibleSeries(chart.Representation) == std::set<std::string>(chart.Names.begin(), chart.Names.end());
    if (!isSame && isUntouched)
    {
      this->DrawSeries(chart.Representation, hint, series);
    }
  }
}

//----------------------------------------------------------------------------
/// A representation is registered before it is added to a view, and no event tells to which one.
void ChartDisplay::WaitForView(vtkSMProxy* representation, int port)
{
  StopObserving(this->Views);
  this->Homeless = representation;
  this->HomelessPort = port;
  vtkNew<vtkSMProxyIterator> next; // two views can have the same name
  next->SetSessionProxyManager(this->Manager);
  for (next->Begin("views"); !next->IsAtEnd(); next->Next())
  {
    vtkSMProxy* view = next->GetProxy();
    this->Views.push_back({ view, view->AddObserver(vtkCommand::PropertyModifiedEvent, this, &ChartDisplay::OnView) });
  }
}

//----------------------------------------------------------------------------
void ChartDisplay::OnView(vtkObject* object, unsigned long, void*)
{
  vtkSMProxy* view = vtkSMProxy::SafeDownCast(object);
  if (!this->Homeless || vtkSMViewProxy::FindView(this->Homeless) != view)
  {
    return;
  }
  StopObserving(this->Views);
  vtkPVXMLElement* chart = this->Hint("ChartDisplay", this->HomelessPort);
  vtkPVXMLElement* table = this->Hint("TableDisplay", this->HomelessPort);
  if (chart && view->GetProperty("LeftAxisTitle") && ShowsOnly(view, this->Homeless))
  {
    this->SetAxes(view, chart);
  }
  if (table && view->GetProperty("HiddenColumnLabels"))
  {
    this->HideColumns(view, table, this->HomelessPort);
  }
  if (this->FormerView && !vtkSMViewLayoutProxy::FindLayout(vtkSMViewProxy::SafeDownCast(view)))
  {
    // Opened by Apply: a view that a script creates has its place before it shows anything.
    this->Pictures.push_back({ view, view->AddObserver(vtkCommand::EndEvent, this, &ChartDisplay::OnPicture) });
  }
}

//----------------------------------------------------------------------------
void ChartDisplay::SetAxes(vtkSMProxy* view, vtkPVXMLElement* hint)
{
  for (const char* name : { "BottomAxisTitle", "LeftAxisTitle", "BottomAxisLogScale", "LeftAxisLogScale",
         "BottomAxisUseCustomRange", "LeftAxisUseCustomRange", "LegendLocation" })
  {
    if (!view->GetProperty(name)->IsValueDefault())
    {
      return; // chosen by someone
    }
  }
  const std::string logarithmic = TextOf(hint, "log");
  vtkSMPropertyHelper(view, "BottomAxisTitle").Set(TextOf(hint, "x-title"));
  vtkSMPropertyHelper(view, "LeftAxisTitle").Set(TextOf(hint, "y-title"));
  vtkSMPropertyHelper(view, "BottomAxisLogScale").Set(logarithmic.find('x') != std::string::npos ? 1 : 0);
  vtkSMPropertyHelper(view, "LeftAxisLogScale").Set(logarithmic.find('y') != std::string::npos ? 1 : 0);
  if (const char* corner = hint->GetAttribute("legend"))
  {
    vtkSMPropertyHelper(view, "LegendLocation").Set(corner);
  }
}

//----------------------------------------------------------------------------
/// Hides the columns that the hint does not name, and none that it names.
void ChartDisplay::HideColumns(vtkSMProxy* view, vtkPVXMLElement* hint, int port)
{
  std::istringstream words(TextOf(hint, "columns"));
  const std::set<std::string> wanted{ std::istream_iterator<std::string>(words), {} };
  vtkSMPropertyHelper property(view, "HiddenColumnLabels");
  std::set<std::string> hidden{ "Row ID" };
  for (unsigned int k = 0; k < property.GetNumberOfElements(); ++k)
  {
    hidden.insert(property.GetAsString(k));
  }
  for (const std::string& column : ColumnsOf(this->Owner->GetDataInformation(port)))
  {
    hidden.insert(column);
  }
  for (const std::string& column : wanted)
  {
    hidden.erase(column);
  }
  property.RemoveAllValues();
  unsigned int k = 0;
  for (const std::string& column : hidden)
  {
    property.Set(k++, column.c_str());
  }
}

//----------------------------------------------------------------------------
vtkSMProxy* ChartDisplay::ActiveView()
{
  vtkSMProxySelectionModel* active = this->Manager->GetSelectionModel("ActiveView");
  return active ? active->GetCurrentProxy() : nullptr;
}

//----------------------------------------------------------------------------
/// ParaView has made the opened view the active one by its first picture.
void ChartDisplay::OnPicture(vtkObject* object, unsigned long, void*)
{
  if (this->FormerView && this->ActiveView() == object)
  {
    this->Manager->GetSelectionModel("ActiveView")
      ->SetCurrentProxy(this->FormerView, vtkSMProxySelectionModel::CLEAR_AND_SELECT);
  }
  const auto isDrawn = [&](const Observation& one) { return one.Object == object; };
  const auto drawn = std::stable_partition(this->Pictures.begin(), this->Pictures.end(), std::not_fn(isDrawn));
  std::vector<Observation> done(drawn, this->Pictures.end());
  this->Pictures.erase(drawn, this->Pictures.end());
  StopObserving(done);
}

}
