// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sea/MeasuredSpectrum.h"

#include "Numerics/Constants.h"
#include "Numerics/InvalidInput.h"
#include "Numerics/TextTable.h"
#include "Numerics/Words.h"
#include "Sea/SpectrumText.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numeric>

namespace littoral
{

namespace
{

constexpr double Missing = std::numeric_limits<double>::quiet_NaN();
/// A gap in directions is no step of a circle if it is so much wider than all others.
constexpr double OpenGap = 1.5;
/// Density and gravity of water with which SWAN writes energies [kg/m3], [m/s2].
constexpr double SwanWeight = 1025.0 * 9.81;

/// An angle of a file [degrees] as that towards which waves travel, from x towards y [rad].
double TowardsOf(double degrees, DirectionConvention convention)
{
  switch (convention)
  {
    case DirectionConvention::NauticalFrom:
      degrees = 270.0 - degrees;
      break;
    case DirectionConvention::NauticalTo:
      degrees = 90.0 - degrees;
      break;
    case DirectionConvention::CartesianFrom:
      degrees += 180.0;
      break;
    default:
      break;
  }
  return std::remainder(degrees, 360.0) * Pi / 180.0;
}

/// Convention that the options ask for, or else that of a format.
DirectionConvention Meant(const SpectrumFileOptions& options, DirectionConvention own)
{
  return options.Convention == DirectionConvention::File ? own : options.Convention;
}

void RequireSpectrum(const MeasuredSpectrum& spectrum)
{
  Require(spectrum.Frequencies.size() < 2 ? "there are fewer than two frequencies with a density." : "");
  for (std::size_t n = 0; n < spectrum.Frequencies.size(); ++n)
  {
    const double f = spectrum.Frequencies[n];
    if (!std::isfinite(f) || f < 0.0 || (n > 0 && f <= spectrum.Frequencies[n - 1]))
    {
      Refuse("frequency ", n, ", ", f, " Hz, must be above the one before and not negative.");
    }
    if (!std::isfinite(spectrum.Densities[n]) || spectrum.Densities[n] < 0.0)
    {
      Refuse("the density at ", f, " Hz is ", spectrum.Densities[n], "; it must not be negative.");
    }
  }
}

/// Directions [degrees] as those towards which waves travel, and lengths; those that are missing are the nearest's.
void TakeDirections(MeasuredSpectrum& spectrum, const std::vector<double>& degrees, const std::vector<double>& lengths,
  DirectionConvention convention)
{
  const std::size_t count = spectrum.Frequencies.size();
  const auto isThere = [&](std::size_t n) { return std::isfinite(degrees[n]) && std::isfinite(lengths[n]); };
  for (std::size_t n = 0; n < count; ++n)
  {
    std::size_t nearest = count;
    for (std::size_t m = 0; m < count; ++m)
    {
      const bool isNearer = nearest == count || std::abs(double(m) - double(n)) < std::abs(double(nearest) - double(n));
      nearest = isThere(m) && isNearer ? m : nearest;
    }
    if (nearest == count)
    {
      spectrum.Directions.clear();
      spectrum.Lengths.clear();
      return;
    }
    if (std::abs(degrees[nearest]) > 720.0 || lengths[nearest] < 0.0 || lengths[nearest] > 1.0)
    {
      Refuse("at ", spectrum.Frequencies[n], " Hz the direction is ", degrees[nearest], " degrees and r1 ",
        lengths[nearest], "; r1 must be 0 to 1.");
    }
    spectrum.Directions.push_back(TowardsOf(degrees[nearest], convention));
    spectrum.Lengths.push_back(lengths[nearest]);
  }
}

/// Widths of the parts of a circle for which angles [degrees] stand, half-way to their neighbors.
std::vector<double> WidthsOf(const std::vector<double>& angles)
{
  const std::size_t count = angles.size();
  Require(count < 3 ? "there are fewer than three directions." : "");
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto turned = [&](std::size_t n) { return angles[n] - 360.0 * std::floor(angles[n] / 360.0); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return turned(a) < turned(b); });
  std::vector<double> gaps(count); // to the next
  for (std::size_t n = 0; n < count; ++n)
  {
    gaps[n] = turned(order[(n + 1) % count]) - turned(order[n]) + (n + 1 == count ? 360.0 : 0.0);
    if (!(gaps[n] > 1e-6))
    {
      Refuse("direction ", angles[order[n]], " is there twice, or is no number.");
    }
  }
  const auto widest = std::max_element(gaps.begin(), gaps.end());
  double next = 0.0;
  for (auto gap = gaps.begin(); gap != gaps.end(); ++gap)
  {
    next = gap == widest ? next : std::max(next, *gap);
  }
  // A sector: its ends stand for as much outwards as inwards
  const bool isOpen = *widest > OpenGap * next;
  std::vector<double> widths(count);
  for (std::size_t n = 0; n < count; ++n)
  {
    const std::size_t before = (n + count - 1) % count;
    const bool isEnd = isOpen && gaps.begin() + static_cast<std::ptrdiff_t>(n) == widest;
    const bool isStart = isOpen && gaps.begin() + static_cast<std::ptrdiff_t>(before) == widest;
    widths[order[n]] = 0.5 * ((isEnd ? gaps[before] : gaps[n]) + (isStart ? gaps[n] : gaps[before]));
  }
  return widths;
}

/// Reduces densities by frequency and direction [m2/Hz/degree] to their integrals and mean vectors.
void Reduce(MeasuredSpectrum& spectrum, const std::vector<double>& angles, const std::vector<double>& densities,
  DirectionConvention convention)
{
  const std::vector<double> widths = WidthsOf(angles);
  for (std::size_t n = 0; n < spectrum.Frequencies.size(); ++n)
  {
    double sum = 0.0;
    std::complex<double> mean(0.0, 0.0);
    for (std::size_t m = 0; m < angles.size(); ++m)
    {
      const double density = densities[n * angles.size() + m];
      if (!std::isfinite(density) || density < 0.0)
      {
        Refuse("the density at ", spectrum.Frequencies[n], " Hz and ", angles[m], " degrees is ", density,
          "; it must not be negative.");
      }
      sum += density * widths[m];
      mean += density * widths[m] * std::polar(1.0, TowardsOf(angles[m], convention));
    }
    spectrum.Densities.push_back(sum);
    spectrum.Directions.push_back(std::arg(mean));
    spectrum.Lengths.push_back(sum > 0.0 ? std::min(1.0, std::abs(mean) / sum) : 0.0);
  }
}

/// Rows by falling frequency the other way round.
template <typename Row>
void Reverse(std::vector<double>& frequencies, std::vector<Row>& rows)
{
  if (frequencies.size() > 1 && frequencies.front() > frequencies.back())
  {
    std::reverse(frequencies.begin(), frequencies.end());
    std::reverse(rows.begin(), rows.end());
  }
}

// NDBC ---------------------------------------------------------------------------------------------------------------

/// One record of a file of NDBC: numbers by frequency.
struct NdbcRecord
{
  std::string Time;
  std::vector<double> Frequencies;
  std::vector<double> Values; ///< missing ones NaN
};

bool IsNdbc(const std::string& line)
{
  const std::vector<std::string> words = WordsOf(line);
  return words.size() > 4 && (words[0] == "#YY" || words[0] == "YY" || words[0] == "YYYY" || words[0] == "#YYYY") &&
    words[1] == "MM" && words[2] == "DD";
}

/// Missing is what has nothing but nines.
double NdbcValue(const std::string& word)
{
  double value = 0.0;
  Require(ReadNumber(word, value) ? "" : "'" + word + "' is no number.");
  return value >= 99.0 && word.find_first_not_of("9.0") == std::string::npos && word.find("99") == 0 ? Missing : value;
}

NdbcRecord ReadNdbc(const std::string& bytes, int wanted)
{
  LineReader lines(bytes);
  const std::vector<std::string> head = WordsOf(lines.Next());
  // Names of times, then frequencies; or words, and frequencies behind each number
  const auto isTime = [](const std::string& word) {
    return word == "#YY" || word == "YY" || word == "YYYY" || word == "#YYYY" || word == "MM" || word == "DD" ||
      word == "hh" || word == "mm";
  };
  const auto times = static_cast<std::size_t>(std::find_if_not(head.begin(), head.end(), isTime) - head.begin());
  const bool isPaired = std::any_of(
    head.begin(), head.end(), [](const std::string& word) { return word.find("(freq_1)") != std::string::npos; });
  const std::size_t start = times + (isPaired && times < head.size() && head[times] == "Sep_Freq" ? 1 : 0);
  int count = 0;
  while (!lines.AtEnd())
  {
    const std::vector<std::string> words = WordsOf(lines.Next());
    if (words.empty() || words[0][0] == '#')
    {
      continue;
    }
    if (count++ != wanted)
    {
      continue;
    }
    NdbcRecord record;
    for (std::size_t n = 0; n < std::min(times, words.size()); ++n)
    {
      record.Time += (n == 0 ? "" : " ") + words[n];
    }
    for (std::size_t n = start; n < words.size(); n += isPaired ? 2 : 1)
    {
      const std::size_t at = isPaired ? n + 1 : times + (n - start);
      const std::vector<std::string>& row = isPaired ? words : head;
      Require(at < row.size() ? "" : "record " + std::to_string(wanted) + " has another number of frequencies.");
      std::string hertz = row[at];
      hertz.erase(std::remove_if(hertz.begin(), hertz.end(), [](char c) { return c == '(' || c == ')'; }), hertz.end());
      double frequency = 0.0;
      Require(ReadNumber(hertz, frequency) ? "" : "'" + hertz + "' is no frequency.");
      record.Frequencies.push_back(frequency);
      record.Values.push_back(NdbcValue(words[n]));
    }
    Require(isPaired || record.Values.size() == head.size() - times
        ? ""
        : "record " + std::to_string(wanted) + " has another number of frequencies than the first line.");
    return record;
  }
  Refuse("there is no record ", wanted, "; the file has ", count, ".");
}

/// Numbers of the other file at the frequencies of a record of the same time.
std::vector<double> NdbcBeside(const std::string& bytes, const NdbcRecord& record)
{
  NdbcRecord other;
  for (int n = 0; other.Time != record.Time; ++n)
  {
    other = InContext("directions at " + record.Time + ": ", [&] { return ReadNdbc(bytes, n); });
  }
  std::vector<double> values;
  for (const double frequency : record.Frequencies)
  {
    const auto at = std::find(other.Frequencies.begin(), other.Frequencies.end(), frequency);
    values.push_back(at == other.Frequencies.end() ? Missing : other.Values[at - other.Frequencies.begin()]);
  }
  return values;
}

/// r1 in hundredths, as in files of years, as a part of 1.
void InWholes(std::vector<double>& lengths)
{
  const bool isHundredths = std::any_of(lengths.begin(), lengths.end(), [](double r) { return r > 1.0; });
  for (double& length : lengths)
  {
    length *= isHundredths ? 0.01 : 1.0;
  }
}

MeasuredSpectrum OfNdbc(
  const std::string& bytes, const SpectrumFileOptions& options, const std::string& alpha1, const std::string& r1)
{
  const NdbcRecord record = ReadNdbc(bytes, options.Record);
  const bool hasDirections = !alpha1.empty() && !r1.empty();
  std::vector<double> directions, lengths;
  if (hasDirections)
  {
    directions = NdbcBeside(alpha1, record);
    lengths = NdbcBeside(r1, record);
    InWholes(lengths);
  }
  MeasuredSpectrum spectrum;
  spectrum.Format = "NDBC";
  spectrum.Time = record.Time;
  std::vector<double> ownDirections, ownLengths;
  for (std::size_t n = 0; n < record.Values.size(); ++n)
  {
    if (!std::isnan(record.Values[n]))
    {
      spectrum.Frequencies.push_back(record.Frequencies[n]);
      spectrum.Densities.push_back(record.Values[n]);
      if (hasDirections)
      {
        ownDirections.push_back(directions[n]);
        ownLengths.push_back(lengths[n]);
      }
    }
  }
  Require(spectrum.Frequencies.empty()
      ? "record " + std::to_string(options.Record) + ", " + record.Time + ", has no density that was measured."
      : "");
  if (hasDirections)
  {
    TakeDirections(spectrum, ownDirections, ownLengths, Meant(options, DirectionConvention::NauticalFrom));
  }
  return spectrum;
}

// SWAN ---------------------------------------------------------------------------------------------------------------

class SwanFile
{
public:
  SwanFile(const std::string& bytes, const SpectrumFileOptions& options)
    : Lines(bytes)
    , Options(options)
  {
  }

  MeasuredSpectrum Read()
  {
    this->ReadHead();
    for (int record = 0; !this->AtEnd(); ++record)
    {
      this->Spectrum.Time = this->HasTime ? FirstWord(this->Line()) : "";
      for (int location = 0; location < this->Locations; ++location)
      {
        const bool isWanted = record == this->Options.Record && location == this->Options.Location;
        this->ReadSpectrum(isWanted);
        if (isWanted)
        {
          return this->Spectrum;
        }
      }
      this->Records = record + 1;
    }
    Refuse("there is no record ", this->Options.Record, " at location ", this->Options.Location, "; the file has ",
      this->Records, " records of ", this->Locations, ".");
  }

private:
  /// The next line that is no comment.
  std::string Line()
  {
    while (!this->Lines.AtEnd())
    {
      const std::string line = this->Lines.Next();
      const std::string word = FirstWord(line);
      if (!word.empty() && word[0] != '$')
      {
        return line;
      }
    }
    Refuse("the file ends too early.");
  }

  bool AtEnd()
  {
    while (!this->Lines.AtEnd() && FirstWord(this->Lines.Peek()).empty())
    {
      this->Lines.Next();
    }
    return this->Lines.AtEnd();
  }

  double Number(const std::string& word) const
  {
    double value = Missing;
    ReadNumber(word, value);
    Require(std::isfinite(value) ? "" : "'" + word + "' is no number.");
    return value;
  }

  int Count()
  {
    const double count = this->Number(FirstWord(this->Line()));
    Require(count >= 1.0 && count <= 1e6 ? "" : "a number of lines is " + std::to_string(count) + ".");
    return static_cast<int>(count);
  }

  std::vector<double> Column()
  {
    std::vector<double> numbers;
    for (int left = this->Count(); left > 0; --left)
    {
      numbers.push_back(this->Number(FirstWord(this->Line())));
    }
    return numbers;
  }

  void ReadHead()
  {
    this->Spectrum.Format = "SWAN";
    this->Lines.Next();
    while (this->Quantities.empty())
    {
      const std::string word = FirstWord(this->Line());
      if (word == "TIME")
      {
        this->HasTime = true;
        this->Line();
      }
      else if (word == "LOCATIONS" || word == "LONLAT")
      {
        this->Locations = this->Count();
        for (int n = 0; n < this->Locations; ++n)
        {
          this->Line();
        }
      }
      else if (word == "AFREQ" || word == "RFREQ")
      {
        this->Spectrum.Frequencies = this->Column();
      }
      else if (word == "NDIR" || word == "CDIR")
      {
        this->Own = word == "NDIR" ? DirectionConvention::NauticalFrom : DirectionConvention::CartesianTo;
        this->Angles = this->Column();
      }
      else if (word == "QUANT")
      {
        this->ReadQuantities();
      }
      else
      {
        Refuse("the word ", word, " is none of SWAN's spectral files.");
      }
    }
    Require(this->Spectrum.Frequencies.empty() ? "there are no frequencies." : "");
  }

  void ReadQuantities()
  {
    for (int left = this->Count(); left > 0; --left)
    {
      this->Quantities.push_back(FirstWord(this->Line()));
      this->Units.push_back(FirstWord(this->Line()));
      this->Exceptions.push_back(this->Number(FirstWord(this->Line())));
    }
    const std::string& first = this->Quantities.front();
    Require(first == "VaDens" || first == "EnDens" ? "" : "the quantity " + first + " is not VaDens or EnDens.");
    const std::string& unit = this->Units.front();
    const std::string expected =
      std::string(first == "VaDens" ? "m2/Hz" : "J/m2/Hz") + (this->Angles.empty() ? "" : "/degr");
    Require(unit == expected ? "" : "the unit of " + first + " is " + unit + ", not " + expected + ".");
    this->Scale = first == "EnDens" ? 1.0 / SwanWeight : 1.0;
  }

  void ReadSpectrum(bool isWanted)
  {
    const std::string word = FirstWord(this->Line());
    if (word == "NODATA" || word == "ZERO")
    {
      Require(isWanted ? "there is no spectrum at this record and location: " + word + "." : "");
      return;
    }
    Require(
      word == (this->Angles.empty() ? "LOCATION" : "FACTOR") ? "" : "'" + word + "' stands where a spectrum begins.");
    if (this->Angles.empty())
    {
      this->ReadRows(isWanted);
      return;
    }
    const double factor = this->Scale * this->Number(FirstWord(this->Line()));
    const std::size_t wanted = this->Spectrum.Frequencies.size() * this->Angles.size();
    std::vector<double> densities;
    while (densities.size() < wanted)
    {
      for (const std::string& number : WordsOf(this->Line()))
      {
        const double value = this->Number(number);
        densities.push_back(value == this->Exceptions.front() ? Missing : factor * value);
      }
    }
    Require(densities.size() == wanted ? "" : "a spectrum has more numbers than frequencies times directions.");
    if (isWanted)
    {
      const std::size_t width = this->Angles.size();
      std::vector<double>& hertz = this->Spectrum.Frequencies;
      if (hertz.front() > hertz.back())
      {
        std::reverse(hertz.begin(), hertz.end());
        std::reverse(densities.begin(), densities.end());
        for (std::size_t row = 0; row < hertz.size(); ++row)
        {
          std::reverse(densities.begin() + row * width, densities.begin() + (row + 1) * width);
        }
      }
      Reduce(this->Spectrum, this->Angles, densities, Meant(this->Options, this->Own));
    }
  }

  /// A spectrum by frequency alone: density, direction and spread.
  void ReadRows(bool isWanted)
  {
    std::vector<double> directions, lengths;
    for (std::size_t n = 0; n < this->Spectrum.Frequencies.size(); ++n)
    {
      const std::vector<std::string> words = WordsOf(this->Line());
      Require(words.size() == this->Quantities.size() ? "" : "a row has another number of quantities than QUANT says.");
      double direction = Missing, length = Missing;
      for (std::size_t q = 0; q < words.size(); ++q)
      {
        const double value = this->Number(words[q]);
        const double known = value == this->Exceptions[q] ? Missing : value;
        if (q == 0 && isWanted)
        {
          this->Spectrum.Densities.push_back(std::isnan(known) ? 0.0 : this->Scale * known);
        }
        if (this->Quantities[q] == "CDIR" || this->Quantities[q] == "NDIR")
        {
          this->Own =
            this->Quantities[q] == "CDIR" ? DirectionConvention::CartesianTo : DirectionConvention::NauticalFrom;
          direction = known;
        }
        // r = 1 - s2 / 2
        length = this->Quantities[q] == "DSPRDEGR" ? 1.0 - 0.5 * std::pow(known * Pi / 180.0, 2.0) : length;
      }
      directions.push_back(direction);
      lengths.push_back(length);
    }
    if (isWanted)
    {
      TakeDirections(this->Spectrum, directions, lengths, Meant(this->Options, this->Own));
    }
  }

  LineReader Lines;
  SpectrumFileOptions Options;
  MeasuredSpectrum Spectrum;
  std::vector<double> Angles;
  std::vector<std::string> Quantities;
  std::vector<std::string> Units;
  std::vector<double> Exceptions;
  DirectionConvention Own = DirectionConvention::NauticalFrom;
  double Scale = 1.0;
  bool HasTime = false;
  int Locations = 1;
  int Records = 0;
};

// Spotter ------------------------------------------------------------------------------------------------------------

/// Objects with a spectrum in a JSON text, in their order.
void CollectSpectra(const Json& value, std::vector<const Json*>& found)
{
  if (value.Member("varianceDensity") && value.Member("frequency"))
  {
    found.push_back(&value);
    return;
  }
  for (const Json& item : value.Items)
  {
    CollectSpectra(item, found);
  }
}

std::vector<double> NumbersOf(const Json& object, const char* name)
{
  const Json* array = object.Member(name);
  std::vector<double> numbers;
  for (std::size_t n = 0; array && n < array->Items.size(); ++n)
  {
    Require(array->Items[n].IsNumber ? "" : std::string(name) + " has what is no number.");
    numbers.push_back(array->Items[n].Number);
  }
  return numbers;
}

MeasuredSpectrum OfSpotter(const std::string& bytes, const SpectrumFileOptions& options)
{
  const Json text = ReadJson(bytes);
  std::vector<const Json*> spectra;
  CollectSpectra(text, spectra);
  Require(spectra.empty() ? "it has no frequencyData with frequency and varianceDensity." : "");
  if (static_cast<std::size_t>(options.Record) >= spectra.size())
  {
    Refuse("there is no record ", options.Record, "; the file has ", spectra.size(), ".");
  }
  const Json& own = *spectra[options.Record];
  MeasuredSpectrum spectrum;
  spectrum.Format = "Spotter";
  spectrum.Frequencies = NumbersOf(own, "frequency");
  spectrum.Densities = NumbersOf(own, "varianceDensity");
  const Json* time = own.Member("timestamp");
  spectrum.Time = time ? time->Text : "";
  const std::size_t count = spectrum.Frequencies.size();
  Require(spectrum.Densities.size() == count ? "" : "frequency and varianceDensity have different numbers of values.");
  const std::vector<double> a1 = NumbersOf(own, "a1");
  const std::vector<double> b1 = NumbersOf(own, "b1");
  std::vector<double> degrees = NumbersOf(own, "direction");
  const std::vector<double> spreads = NumbersOf(own, "directionalSpread");
  std::vector<double> lengths;
  if (a1.size() == count && b1.size() == count)
  {
    // Moments by the direction of travel, from east towards north: from = 270 - atan2(b1, a1)
    degrees.clear();
    for (std::size_t n = 0; n < count; ++n)
    {
      degrees.push_back(270.0 - std::atan2(b1[n], a1[n]) * 180.0 / Pi);
      lengths.push_back(std::hypot(a1[n], b1[n]));
    }
  }
  else if (degrees.size() == count && spreads.size() == count)
  {
    for (const double spread : spreads)
    {
      lengths.push_back(1.0 - 0.5 * std::pow(spread * Pi / 180.0, 2.0));
    }
  }
  else
  {
    return spectrum;
  }
  TakeDirections(spectrum, degrees, lengths, Meant(options, DirectionConvention::NauticalFrom));
  return spectrum;
}

// Tables -------------------------------------------------------------------------------------------------------------

std::vector<double> ColumnOf(const TextTable& table, int column)
{
  std::vector<double> numbers;
  for (const std::string& word : table.Columns[column])
  {
    double number = Missing;
    Require(ReadNumber(word, number) ? "" : "'" + word + "' in column " + table.Names[column] + " is no number.");
    numbers.push_back(number);
  }
  return numbers;
}

/// The first column with one of some names; -1 if there is none.
int Named(const TextTable& table, std::initializer_list<const char*> names)
{
  for (const char* name : names)
  {
    if (table.ColumnOf(name) >= 0)
    {
      return table.ColumnOf(name);
    }
  }
  return -1;
}

MeasuredSpectrum OfColumns(const TextTable& table, int frequency, int density, const SpectrumFileOptions& options)
{
  MeasuredSpectrum spectrum;
  spectrum.Format = "Table";
  spectrum.Frequencies = ColumnOf(table, frequency);
  spectrum.Densities = ColumnOf(table, density);
  const int alpha = Named(table, { "alpha1", "swdir", "swdir1" });
  const int r = Named(table, { "r1", "swr1" });
  std::vector<double> degrees, lengths;
  if (alpha >= 0 && r >= 0)
  {
    degrees = ColumnOf(table, alpha);
    lengths = ColumnOf(table, r);
  }
  std::vector<std::size_t> order(spectrum.Frequencies.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  Reverse(spectrum.Frequencies, order);
  const auto sorted = [&order](const std::vector<double>& values) {
    std::vector<double> result;
    std::transform(order.begin(), order.end(), std::back_inserter(result), [&](std::size_t n) { return values[n]; });
    return result;
  };
  spectrum.Densities = sorted(spectrum.Densities);
  if (!degrees.empty())
  {
    degrees = sorted(degrees);
    lengths = sorted(lengths);
    std::replace(lengths.begin(), lengths.end(), 999.0, Missing);
    std::replace(degrees.begin(), degrees.end(), 999.0, Missing);
    InWholes(lengths);
    TakeDirections(spectrum, degrees, lengths, Meant(options, DirectionConvention::NauticalFrom));
  }
  return spectrum;
}

MeasuredSpectrum OfTable(const std::string& bytes, const SpectrumFileOptions& options)
{
  const TextTable named = ReadTable(bytes);
  const int frequency = Named(named, { "frequency", "frequencyhz", "freq", "freqhz", "f", "fhz" });
  const int density =
    Named(named, { "density", "densitym2hz", "energy", "c11", "variancedensity", "spec", "s", "em2hz" });
  if (frequency >= 0 && density >= 0)
  {
    return OfColumns(named, frequency, density, options);
  }
  // Directions in the first row, frequencies in the first column; its corner may be empty
  std::vector<std::vector<double>> rows;
  std::vector<double> angles, hertz;
  LineReader lines(bytes);
  while (!lines.AtEnd())
  {
    const std::string line = lines.Next();
    const std::vector<std::string> words = CellsOf(line);
    if (Trimmed(line).empty() || Trimmed(line)[0] == '#')
    {
      continue;
    }
    std::vector<double> numbers;
    for (std::size_t n = 1; n < words.size(); ++n)
    {
      double number = Missing;
      ReadNumber(words[n], number);
      Require(std::isfinite(number) ? ""
                                    : "'" + words[n] +
            "' is no number; a table needs the columns Frequency and Density, or a row of directions "
            "and a column of frequencies.");
      numbers.push_back(number);
    }
    if (angles.empty())
    {
      angles = numbers;
      continue;
    }
    double number = Missing;
    ReadNumber(words.empty() ? "" : words[0], number);
    Require(std::isfinite(number) && numbers.size() == angles.size()
        ? ""
        : "a row has no frequency, or another number of densities than there are directions.");
    hertz.push_back(number);
    rows.push_back(numbers);
  }
  Require(options.Convention == DirectionConvention::File
      ? "a table does not say what its directions are: set DirectionConvention."
      : "");
  Reverse(hertz, rows);
  MeasuredSpectrum spectrum;
  spectrum.Format = "Table";
  spectrum.Frequencies = hertz;
  std::vector<double> densities;
  for (const std::vector<double>& row : rows)
  {
    for (const double value : row)
    {
      densities.push_back(value * (options.Unit == DensityUnit::PerRadian ? Pi / 180.0 : 1.0));
    }
  }
  Reduce(spectrum, angles, densities, options.Convention);
  return spectrum;
}

}

double CircularSpread(double length)
{
  return std::sqrt(2.0 * std::max(0.0, 1.0 - length));
}

MeasuredSpectrum ReadSpectrumFile(
  const std::string& bytes, const SpectrumFileOptions& options, const std::string& alpha1, const std::string& r1)
{
  Require(options.Record < 0 || options.Location < 0 ? "Record and Location must not be negative." : "");
  const std::string text = Utf8Of(bytes);
  const std::string first = Trimmed(LineReader(text).Next());
  const std::size_t mark = text.find_first_not_of(" \t\r\n");
  Require(mark == std::string::npos ? "the file is empty." : "");
  MeasuredSpectrum spectrum;
  if (first.compare(0, 4, "SWAN") == 0)
  {
    spectrum = SwanFile(text, options).Read();
  }
  else if (text[mark] == '{' || text[mark] == '[')
  {
    spectrum = OfSpotter(text, options);
  }
  else
  {
    spectrum = IsNdbc(first) ? OfNdbc(text, options, alpha1, r1) : OfTable(text, options);
  }
  RequireSpectrum(spectrum);
  return spectrum;
}

}
