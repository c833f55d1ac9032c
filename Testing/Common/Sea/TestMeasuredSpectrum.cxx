// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Files of one sea, written here by the layouts of buoys and models, against sums of its own formula.
#include "Numerics/InvalidInput.h"
#include "Sea/MeasuredSpectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

using namespace littoral;

namespace
{

const double Pi = std::acos(-1.0);
constexpr double Height = 3.0;
constexpr double Peak = 0.11;       // Hz
constexpr double Exponent = 8.0;    // s of cos^2s
constexpr double FromNorth = 250.0; // degrees at the peak, clockwise; turning with frequency

double Density(double f)
{
  const double r = Peak / f;
  return 5.0 / 16.0 * Height * Height / Peak * std::pow(r, 5.0) * std::exp(-1.25 * std::pow(r, 4.0));
}

/// Where waves come from, clockwise from north [degrees].
double From(double f)
{
  return FromNorth + 300.0 * (f - Peak);
}

/// Fraction of the energy of a frequency a degree, at an angle from the mean direction.
double Spread(double degrees)
{
  const double norm = std::tgamma(Exponent + 1.0) / (2.0 * std::sqrt(Pi) * std::tgamma(Exponent + 0.5));
  return norm * std::pow(std::cos(0.5 * degrees * Pi / 180.0), 2.0 * Exponent) * Pi / 180.0;
}

std::vector<double> Hertz()
{
  std::vector<double> f;
  f.reserve(90);
  for (int n = 0; n < 90; ++n)
  {
    f.push_back(0.05 + 0.005 * n);
  }
  return f;
}

/// Height, peak period and direction of travel from east towards north of a spectrum that was read.
struct Bulk
{
  double Height;
  double Period;
  double Towards;
  double Length;
};

Bulk BulkOf(const MeasuredSpectrum& spectrum)
{
  double energy = 0.0, most = 0.0, peak = 0.0;
  std::complex<double> sum(0.0, 0.0);
  for (std::size_t n = 0; n < spectrum.Frequencies.size(); ++n)
  {
    energy += 0.005 * spectrum.Densities[n];
    peak = spectrum.Densities[n] > most ? spectrum.Frequencies[n] : peak;
    most = std::max(most, spectrum.Densities[n]);
    if (!spectrum.Directions.empty())
    {
      sum += 0.005 * spectrum.Densities[n] * std::polar(spectrum.Lengths[n], spectrum.Directions[n]);
    }
  }
  return { 4.0 * std::sqrt(energy), 1.0 / peak, std::arg(sum) * 180.0 / Pi, std::abs(sum) / energy };
}

/// The same by the formula.
Bulk Truth()
{
  double energy = 0.0;
  std::complex<double> sum(0.0, 0.0);
  for (const double f : Hertz())
  {
    energy += 0.005 * Density(f);
    sum += 0.005 * Density(f) * Exponent / (Exponent + 1.0) * std::polar(1.0, (270.0 - From(f)) * Pi / 180.0);
  }
  return { 4.0 * std::sqrt(energy), 1.0 / Peak, std::arg(sum) * 180.0 / Pi, std::abs(sum) / energy };
}

void ExpectSea(const MeasuredSpectrum& spectrum, const char* format, double turned = 0.0)
{
  const Bulk truth = Truth();
  const Bulk bulk = BulkOf(spectrum);
  EXPECT_EQ(spectrum.Format, format);
  EXPECT_NEAR(bulk.Height / truth.Height, 1.0, 1e-3) << format;
  EXPECT_NEAR(bulk.Period / truth.Period, 1.0, 1e-6) << format;
  EXPECT_NEAR(std::remainder(bulk.Towards - truth.Towards - turned, 360.0), 0.0, 0.2) << format;
  EXPECT_NEAR(bulk.Length, truth.Length, 0.003) << format;
}

/// A file of NDBC's recent data: pairs of values and frequencies, the newest first.
std::string Recent(const std::function<double(double)>& value, const char* word, bool isDensity)
{
  std::ostringstream text;
  text << "#YY  MM DD hh mm " << (isDensity ? "Sep_Freq  < " : "") << word << "_1 (freq_1) " << word
       << "_2 (freq_2) ...\n";
  for (const char* time : { "2014 09 11 17 00", "2014 09 11 16 00" })
  {
    text << time << (isDensity ? " 0.140" : "");
    for (const double f : Hertz())
    {
      text << " " << std::fixed << std::setprecision(5) << (time[12] == '7' ? value(f) : 999.0) << " ("
           << std::setprecision(3) << f << ")";
    }
    text << "\n";
  }
  return text.str();
}

/// A file of NDBC of a year: frequencies in the first line.
std::string Yearly(const std::function<double(double)>& value)
{
  std::ostringstream text;
  text << "#YY  MM DD hh mm";
  for (const double f : Hertz())
  {
    text << "  " << std::fixed << std::setprecision(4) << f;
  }
  for (const char* time : { "2013 01 01 00 40", "2013 01 01 01 40" })
  {
    text << "\n" << time;
    for (const double f : Hertz())
    {
      text << " " << std::setprecision(5) << value(f);
    }
  }
  return text.str();
}

double Direction(double f)
{
  return From(f);
}

double Length(double)
{
  return Exponent / (Exponent + 1.0);
}

/// Directions every ten degrees from a start; densities by them with nautical directions.
std::string Matrix(double start, const std::function<double(double)>& nautical, double unit, const char* separator)
{
  std::ostringstream text;
  for (const double f : Hertz())
  {
    if (*separator == ',')
    {
      text << f << separator;
    }
    for (int n = 0; n < 36; ++n)
    {
      const double density = unit * Density(f) * Spread(nautical(start + 10.0 * n) - From(f));
      text << (n == 0 ? "" : separator) << (*separator == ',' ? density : std::round(density));
    }
    text << "\n";
  }
  return text.str();
}

std::string Swan(const char* keyword, const std::function<double(double)>& nautical)
{
  std::ostringstream text;
  text << "SWAN   1      Swan standard spectral file, version\n$   Data\nTIME        time-dependent data\n     1   "
          "option\n"
       << "LOCATIONS\n     2     number of locations\n 1.0 2.0\n 3.0 4.0\nAFREQ\n    90   number\n";
  for (const double f : Hertz())
  {
    text << "  " << f << "\n";
  }
  text << keyword << "   directions\n   36\n";
  for (int n = 0; n < 36; ++n)
  {
    text << "  " << 5.0 + 10.0 * n << "\n";
  }
  text << "QUANT\n   1\nVaDens   variance densities\nm2/Hz/degr   unit\n  -0.9900E+02   exception value\n"
       << "20140911.170000   date and time\nZERO\nFACTOR\n   0.1E-05\n"
       << Matrix(5.0, nautical, 1e6, " ") << "20140911.180000\nNODATA\nFACTOR\n 0.1E-05\n"
       << Matrix(5.0, nautical, 2e6, " ");
  return text.str();
}

std::string Spotter(bool hasMoments)
{
  std::ostringstream text;
  text << "{\"data\": {\"spotterId\": \"SPOT-0001\", \"frequencyData\": [{";
  const auto list = [&](const char* name, const std::function<double(double)>& value) {
    text << "\"" << name << "\": [";
    for (const double f : Hertz())
    {
      text << (f == Hertz().front() ? "" : ", ") << value(f);
    }
    text << "], ";
  };
  list("frequency", [](double f) { return f; });
  list("varianceDensity", Density);
  if (hasMoments)
  {
    list("a1", [](double f) { return Length(f) * std::cos((270.0 - From(f)) * Pi / 180.0); });
    list("b1", [](double f) { return Length(f) * std::sin((270.0 - From(f)) * Pi / 180.0); });
  }
  list("direction", Direction);
  list("directionalSpread", [](double f) { return std::sqrt(2.0 * (1.0 - Length(f))) * 180.0 / Pi; });
  text << "\"timestamp\": \"2018-07-04T06:00:00.000Z\", \"latitude\": null}]}}";
  return text.str();
}

std::string Table(const char* separator, double unit = 1.0)
{
  std::ostringstream text;
  text << "f/dir";
  for (int n = 0; n < 36; ++n)
  {
    text << separator << 10.0 * n;
  }
  return text.str() + "\n" +
    Matrix(
      0.0, [](double from) { return from; }, unit, separator);
}

}

TEST(MeasuredSpectrum, NdbcWithDirections)
{
  const SpectrumFileOptions options;
  ExpectSea(ReadSpectrumFile(
              Recent(Density, "spec", true), options, Recent(Direction, "alpha1", false), Recent(Length, "r1", false)),
    "NDBC");
  const auto yearly =
    ReadSpectrumFile(Yearly(Density), options, Yearly(Direction), Yearly([](double f) { return 100.0 * Length(f); }));
  ExpectSea(yearly, "NDBC");
  EXPECT_EQ(yearly.Time, "2013 01 01 00 40");
  EXPECT_TRUE(ReadSpectrumFile(Yearly(Density), options).Directions.empty());
  SpectrumFileOptions second;
  second.Record = 1;
  EXPECT_EQ(ReadSpectrumFile(Yearly(Density), second).Time, "2013 01 01 01 40");
  EXPECT_EQ(WhyRefused([&] { ReadSpectrumFile(Recent(Density, "spec", true), second); }),
    "record 1, 2014 09 11 16 00, has no density that was measured.");
  second.Record = 2;
  EXPECT_EQ(WhyRefused([&] { ReadSpectrumFile(Yearly(Density), second); }), "there is no record 2; the file has 2.");
}

TEST(MeasuredSpectrum, MissingNumbersAreLeftOut)
{
  const auto gap = [](const std::function<double(double)>& value) {
    return [value](double f) { return f > 0.2 && f < 0.21 ? 999.0 : value(f); };
  };
  const auto some = ReadSpectrumFile(Yearly(gap(Density)), {}, Yearly(Direction), Yearly(Length));
  EXPECT_LT(some.Frequencies.size(), Hertz().size());
  const auto nearest = ReadSpectrumFile(Yearly(Density), {}, Yearly(gap(Direction)), Yearly(Length));
  EXPECT_EQ(nearest.Frequencies.size(), Hertz().size());
  ExpectSea(nearest, "NDBC");
}

TEST(MeasuredSpectrum, SwanByItsConvention)
{
  SpectrumFileOptions options;
  options.Location = 1;
  ExpectSea(ReadSpectrumFile(Swan("NDIR", [](double from) { return from; }), options), "SWAN");
  // Cartesian: towards, from x towards y
  ExpectSea(ReadSpectrumFile(Swan("CDIR", [](double to) { return 270.0 - to; }), options), "SWAN");
  EXPECT_EQ(ReadSpectrumFile(Swan("NDIR", [](double from) { return from; }), options).Time, "20140911.170000");
  options.Record = 1;
  const auto twice = ReadSpectrumFile(Swan("NDIR", [](double from) { return from; }), options);
  EXPECT_NEAR(BulkOf(twice).Height / Truth().Height, std::sqrt(2.0), 2e-3);
  options.Location = 0;
  EXPECT_NE(WhyRefused([&] { ReadSpectrumFile(Swan("NDIR", Direction), options); }).find("NODATA"), std::string::npos);
  options.Record = 2;
  EXPECT_NE(WhyRefused([&] { ReadSpectrumFile(Swan("NDIR", Direction), options); }).find("the file has 2 records of 2"),
    std::string::npos);
}

TEST(MeasuredSpectrum, SpotterByMomentsOrDirections)
{
  ExpectSea(ReadSpectrumFile(Spotter(true), {}), "Spotter");
  const auto byDirections = ReadSpectrumFile(Spotter(false), {});
  ExpectSea(byDirections, "Spotter");
  EXPECT_EQ(byDirections.Time, "2018-07-04T06:00:00.000Z");
}

TEST(MeasuredSpectrum, TablesAsked)
{
  SpectrumFileOptions options;
  EXPECT_NE(
    WhyRefused([&] { ReadSpectrumFile(Table(","), options); }).find("set DirectionConvention"), std::string::npos);
  options.Convention = DirectionConvention::NauticalFrom;
  ExpectSea(ReadSpectrumFile(Table(","), options), "Table");
  options.Convention = DirectionConvention::NauticalTo;
  ExpectSea(ReadSpectrumFile(Table(","), options), "Table", 180.0);
  options.Convention = DirectionConvention::NauticalFrom;
  options.Unit = DensityUnit::PerRadian;
  ExpectSea(ReadSpectrumFile(Table(",", 180.0 / Pi), options), "Table");
  // Towards = the number itself, so that the mean direction is that of a mirrored sea
  options.Unit = DensityUnit::PerDegree;
  options.Convention = DirectionConvention::CartesianTo;
  const double towards = BulkOf(ReadSpectrumFile(Table(","), options)).Towards;
  EXPECT_NEAR(std::remainder(towards - (270.0 - Truth().Towards), 360.0), 0.0, 0.2);
  options.Convention = DirectionConvention::CartesianFrom;
  const double from = BulkOf(ReadSpectrumFile(Table(","), options)).Towards;
  EXPECT_NEAR(std::abs(std::remainder(towards - from, 360.0)), 180.0, 1e-6);

  std::ostringstream columns;
  columns << "Frequency;Density;alpha1;r1\n";
  for (const double f : Hertz())
  {
    columns << f << ";" << Density(f) << ";" << From(f) << ";" << Length(f) << "\n";
  }
  ExpectSea(ReadSpectrumFile(columns.str(), {}), "Table");
}

TEST(MeasuredSpectrum, SectorsStandForAsMuchOutwards)
{
  SpectrumFileOptions options;
  options.Convention = DirectionConvention::CartesianTo;
  // 10 degrees each, 30 in all
  const auto sector = ReadSpectrumFile("x,10,20,30\n0.1,1,1,1\n0.2,1,2,1\n", options);
  EXPECT_NEAR(sector.Densities[0], 30.0, 1e-12);
  EXPECT_NEAR(sector.Densities[1], 40.0, 1e-12);
  EXPECT_NEAR(sector.Directions[0], 20.0 * Pi / 180.0, 1e-12);
  const auto circle = ReadSpectrumFile("x,0,120,240\n0.2,1,1,1\n0.1,2,1,1\n", options);
  EXPECT_NEAR(circle.Densities[1], 360.0, 1e-10); // by increasing frequency
  EXPECT_NEAR(circle.Lengths[1], 0.0, 1e-12);
}

TEST(MeasuredSpectrum, SpreadOfCosines)
{
  const double known[3][2] = { { 2.0, 46.782 }, { 5.0, 33.080 }, { 10.0, 24.431 } };
  for (const auto& row : known)
  {
    EXPECT_NEAR(CircularSpread(row[0] / (row[0] + 1.0)) * 180.0 / Pi, row[1], 1e-3);
  }
}

TEST(MeasuredSpectrum, WhatIsNoneIsRefused)
{
  SpectrumFileOptions options;
  options.Convention = DirectionConvention::NauticalFrom;
  const auto why = [&](const std::string& bytes) { return WhyRefused([&] { ReadSpectrumFile(bytes, options); }); };
  EXPECT_EQ(why(" \n"), "the file is empty.");
  EXPECT_NE(why("x,0,120,240\n0.1,1,1,-1\n0.2,1,1,1\n").find("must not be negative"), std::string::npos);
  EXPECT_NE(why("x,0,120,360\n0.1,1,1,1\n0.2,1,1,1\n").find("is there twice"), std::string::npos);
  EXPECT_NE(why("x,0,120,240\n0.1,1,1,1\n0.1,1,1,1\n").find("must be above the one before"), std::string::npos);
  EXPECT_NE(why("x,0,120,240\n0.1,1,1\n").find("another number of densities"), std::string::npos);
  EXPECT_NE(why("depth,tide\n1,2\n").find("Frequency and Density"), std::string::npos);
  EXPECT_NE(why("{\"data\": [1, 2]}").find("no frequencyData"), std::string::npos);
  EXPECT_NE(why("{\"data\": [1, 2").find("ends too early"), std::string::npos);
  EXPECT_NE(why(std::string(100, '[')).find("too many arrays"), std::string::npos);
  EXPECT_NE(why("SWAN 1\nAFREQ\n 2\n0.1\n").find("ends too early"), std::string::npos);
  EXPECT_NE(why("SWAN 1\nHELLO\n").find("none of SWAN's"), std::string::npos);
  EXPECT_NE(why("#YY MM DD hh mm 0.1 0.2\n2014 1 1 1 1 2\n").find("another number of frequencies"), std::string::npos);
  EXPECT_NE(why("#YY MM DD hh mm 0.1 0.2\n2014 1 1 1 1 2 -1\n").find("must not be negative"), std::string::npos);
  EXPECT_NE(why("#YY MM DD hh mm 0.1 0.2\n2014 1 1 1 1 2 x\n").find("'x' is no number"), std::string::npos);
  const std::string swan = Swan("NDIR", Direction);
  const std::size_t unit = swan.find("m2/Hz/degr");
  EXPECT_NE(
    why(swan.substr(0, unit) + "m2/Hz/rad" + swan.substr(unit + 10)).find("the unit of VaDens"), std::string::npos);
  options.Location = 1;
  EXPECT_NE(why(swan.substr(0, swan.size() / 3)).find("ends too early"), std::string::npos);
}
