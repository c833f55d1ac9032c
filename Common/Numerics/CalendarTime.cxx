// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Numerics/CalendarTime.h"

#include "Numerics/InvalidInput.h"
#include "Numerics/Words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <vector>

namespace littoral
{

namespace
{

constexpr double SecondsPerDay = 86400.0;
constexpr long long FarthestYear = 1000000;

/// The day number of 1582-10-15 in both of Gregory's calendars: the first one of the standard calendar that is not
/// Julian.
constexpr long long FirstGregorian = -141427;

long long FloorDivide(long long a, long long b)
{
  return a / b - (a % b < 0 ? 1 : 0);
}

/// Days from 0000-03-01 to a date of a calendar whose years end with February, which has 365 days but for leap days.
long long DaysSinceMarch(const CalendarDate& date, bool isJulian)
{
  // March is month 0 of its year; the days before month m are floor((153 m + 2)/5)
  const long long year = date.Year - (date.Month < 3 ? 1 : 0);
  const int month = (date.Month + 9) % 12;
  const long long leap = FloorDivide(year, 4) - (isJulian ? 0 : FloorDivide(year, 100) - FloorDivide(year, 400));
  return 365 * year + leap + (153 * month + 2) / 5 + date.Day - 1;
}

constexpr long long EpochGregorian = 719468; ///< days from 0000-03-01 to 1970-01-01
constexpr long long EpochJulian = 719470;    ///< to the same day, which is Julian 1969-12-19, both by their own count

int DaysOfMonth(Calendar calendar, long long year, int month)
{
  constexpr std::array<int, 12> days{ 31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31 };
  if (calendar == Calendar::Days360)
  {
    return 30;
  }
  const bool isJulian = calendar == Calendar::Julian || (calendar == Calendar::Standard && year <= 1582);
  const bool isLeap = calendar == Calendar::AllLeap ||
    (calendar != Calendar::NoLeap && year % 4 == 0 && (isJulian || year % 100 != 0 || year % 400 == 0));
  return days[month - 1] + (month == 2 && isLeap ? 1 : 0);
}

bool IsGregorian(const CalendarDate& date)
{
  return std::array<long long, 3>{ date.Year, date.Month, date.Day } >= std::array<long long, 3>{ 1582, 10, 15 };
}

/// The day number of a date that the calendar has.
long long NumberOf(Calendar calendar, const CalendarDate& date)
{
  constexpr std::array<int, 12> before{ 0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334 };
  switch (calendar)
  {
    case Calendar::Days360:
      return 360 * (date.Year - 1970) + 30 * (date.Month - 1) + date.Day - 1;
    case Calendar::NoLeap:
      return 365 * (date.Year - 1970) + before[date.Month - 1] + date.Day - 1;
    case Calendar::AllLeap:
      return 366 * (date.Year - 1970) + before[date.Month - 1] + (date.Month > 2 ? 1 : 0) + date.Day - 1;
    case Calendar::Julian:
      return DaysSinceMarch(date, true) - EpochJulian;
    case Calendar::ProlepticGregorian:
      return DaysSinceMarch(date, false) - EpochGregorian;
    case Calendar::Standard:
      break;
  }
  return IsGregorian(date) ? DaysSinceMarch(date, false) - EpochGregorian : DaysSinceMarch(date, true) - EpochJulian;
}

/// Reads "6", "6:30" or "6:30:15.5" as seconds; false if it is none.
bool ReadClock(const std::string& text, double& seconds)
{
  double parts[3] = { 0.0, 0.0, 0.0 };
  int used = 0;
  const int count =
    std::sscanf(text.c_str(), "%lf%n:%lf%n:%lf%n", &parts[0], &used, &parts[1], &used, &parts[2], &used);
  if (count < 1 || used != static_cast<int>(text.size()) || parts[0] < 0.0 || parts[0] > 24.0 || parts[1] < 0.0 ||
    parts[1] >= 60.0 || parts[2] < 0.0 || parts[2] > 60.0)
  {
    return false;
  }
  seconds = 3600.0 * parts[0] + 60.0 * parts[1] + parts[2];
  return true;
}

/// Reads "+01:00", "-3", "0130", "Z" or "UTC" as seconds ahead of UTC; false if it is none.
bool ReadZone(const std::string& text, double& seconds)
{
  const std::string word = Lower(text);
  if (word == "z" || word == "utc" || word == "gmt")
  {
    seconds = 0.0;
    return true;
  }
  const bool isSigned = word[0] == '+' || word[0] == '-';
  std::string clock = word.substr(isSigned ? 1 : 0);
  if (clock.find(':') == std::string::npos && clock.size() > 2)
  {
    clock.insert(clock.size() - 2, ":"); // hours and minutes in four digits
  }
  const bool isRead = ReadClock(clock, seconds);
  seconds = word[0] == '-' ? -seconds : seconds;
  return isRead;
}

/// Divides "06:00:00Z" or "06:00:00+01:00" into its time and its zone, which may be empty.
void DivideClock(const std::string& word, std::string& clock, std::string& zone)
{
  const std::size_t end = word.find_first_of("+-zZuUgG");
  clock = word.substr(0, end);
  zone = end == std::string::npos ? "" : word.substr(end);
}

}

Calendar CalendarOf(const std::string& name)
{
  const std::string word = Lower(name);
  if (word.empty() || word == "standard" || word == "gregorian")
  {
    return Calendar::Standard;
  }
  if (word == "proleptic_gregorian")
  {
    return Calendar::ProlepticGregorian;
  }
  if (word == "julian")
  {
    return Calendar::Julian;
  }
  if (word == "noleap" || word == "365_day")
  {
    return Calendar::NoLeap;
  }
  if (word == "all_leap" || word == "366_day")
  {
    return Calendar::AllLeap;
  }
  if (word == "360_day")
  {
    return Calendar::Days360;
  }
  Refuse("its calendar '", name,
    "' is none of standard, gregorian, proleptic_gregorian, julian, noleap, 365_day, "
    "all_leap, 366_day and 360_day");
}

long long DayNumber(Calendar calendar, const CalendarDate& date)
{
  const bool isMonth = date.Month >= 1 && date.Month <= 12 && date.Year >= -FarthestYear && date.Year <= FarthestYear;
  const bool isLost =
    calendar == Calendar::Standard && date.Year == 1582 && date.Month == 10 && date.Day > 4 && date.Day < 15;
  if (!isMonth || isLost || date.Day < 1 || date.Day > DaysOfMonth(calendar, date.Year, date.Month))
  {
    Refuse("its calendar has no date ", date.Year, "-", date.Month, "-", date.Day);
  }
  return NumberOf(calendar, date);
}

CalendarDate DateOf(Calendar calendar, long long day)
{
  // a year that is not too early, then the year and the month that begin last before the day
  const double days = calendar == Calendar::Days360 ? 360.0 : calendar == Calendar::AllLeap ? 366.0 : 365.0;
  const double years = static_cast<double>(day) / (day < 0 ? 366.0 : days);
  CalendarDate date{ 1972 + static_cast<long long>(std::floor(years)), 1, 1 };
  while (NumberOf(calendar, date) > day)
  {
    --date.Year;
  }
  for (date.Month = 12; NumberOf(calendar, { date.Year, date.Month, 1 }) > day; --date.Month)
  {
  }
  date.Day = 1 + static_cast<int>(day - NumberOf(calendar, date));
  // October 1582 has lost ten days
  const bool isShort = calendar == Calendar::Standard && date.Year == 1582 && date.Month == 10 && day >= FirstGregorian;
  date.Day = isShort ? 15 + static_cast<int>(day - FirstGregorian) : date.Day;
  return date;
}

CalendarTime ReadTime(Calendar calendar, const std::string& text)
{
  std::string plain = text;
  const std::size_t middle = plain.find_first_of("Tt");
  if (middle != std::string::npos && middle > 0 && std::isdigit(static_cast<unsigned char>(plain[middle - 1])))
  {
    plain[middle] = ' ';
  }
  const std::vector<std::string> words = WordsOf(plain);
  CalendarDate date;
  int used = 0;
  const bool isDate = !words.empty() && words.size() <= 3 &&
    std::sscanf(words[0].c_str(), "%lld-%d-%d%n", &date.Year, &date.Month, &date.Day, &used) == 3 &&
    used == static_cast<int>(words[0].size());
  double seconds = 0.0;
  double zone = 0.0;
  bool isTime = isDate;
  if (isDate && words.size() > 1)
  {
    std::string clock, ahead;
    DivideClock(words[1], clock, ahead);
    ahead = words.size() > 2 ? words[2] : ahead;
    isTime = clock.empty() ? words.size() == 2 : ReadClock(clock, seconds);
    isTime = isTime && (ahead.empty() || ReadZone(ahead, zone));
  }
  if (!isTime)
  {
    Refuse("'", text, "' is no date, as 2020-02-28 or 2020-02-28T06:00:00Z");
  }
  return Later({ DayNumber(calendar, date), 0.0 }, seconds - zone);
}

std::string TextOfTime(Calendar calendar, const CalendarTime& time)
{
  const CalendarTime rounded = Later({ time.Day, 0.0 }, std::round(time.Seconds));
  const CalendarDate date = DateOf(calendar, rounded.Day);
  const int seconds = static_cast<int>(rounded.Seconds);
  char text[64];
  std::snprintf(text, sizeof(text), "%04lld-%02d-%02dT%02d:%02d:%02dZ", date.Year, date.Month, date.Day, seconds / 3600,
    seconds / 60 % 60, seconds % 60);
  return text;
}

CalendarTime Later(const CalendarTime& time, double seconds)
{
  const double all = time.Seconds + seconds;
  const double days = std::floor(all / SecondsPerDay);
  return { time.Day + static_cast<long long>(days), all - days * SecondsPerDay };
}

double SecondsBetween(const CalendarTime& from, const CalendarTime& to)
{
  return SecondsPerDay * static_cast<double>(to.Day - from.Day) + (to.Seconds - from.Seconds);
}

TimeUnit TimeUnitOf(Calendar calendar, const std::string& units)
{
  const std::vector<std::string> words = WordsOf(units);
  const std::string word = words.empty() ? "" : Lower(words[0]);
  const auto isOneOf = [&](std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), word) != names.end();
  };
  TimeUnit unit;
  if (isOneOf({ "s", "sec", "secs", "second", "seconds" }))
  {
    unit.Seconds = 1.0;
  }
  else if (isOneOf({ "ms", "msec", "msecs", "millisec", "millisecs", "millisecond", "milliseconds" }))
  {
    unit.Seconds = 1e-3;
  }
  else if (isOneOf({ "min", "mins", "minute", "minutes" }))
  {
    unit.Seconds = 60.0;
  }
  else if (isOneOf({ "h", "hr", "hrs", "hour", "hours" }))
  {
    unit.Seconds = 3600.0;
  }
  else if (isOneOf({ "d", "day", "days" }))
  {
    unit.Seconds = SecondsPerDay;
  }
  else if (isOneOf({ "month", "months", "year", "years", "yr", "common_year", "common_years" }))
  {
    Refuse("the unit '", units, "' of its times has no length; days and shorter ones have");
  }
  else
  {
    Refuse("'", units, "' is no unit of times, as 'days since 2000-01-01'");
  }
  if (words.size() > 1)
  {
    if (Lower(words[1]) != "since")
    {
      Refuse("'", units, "' is no unit of times, as 'days since 2000-01-01'");
    }
    unit.HasDate = true;
    unit.Since = ReadTime(calendar, units.substr(Lower(units).find("since") + 5));
  }
  return unit;
}

}
