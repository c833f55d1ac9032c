// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LittoralCalendarTime_h
#define LittoralCalendarTime_h

// Times of data files, as the conventions for climate and forecast (CF) write them: numbers in a unit since a date of
// a calendar.

#include <string>

namespace littoral
{

enum class Calendar
{
  Standard, ///< Julian up to 1582-10-04, Gregorian from 1582-10-15, the day after it
  ProlepticGregorian,
  Julian,
  NoLeap,  ///< all years have 365 days
  AllLeap, ///< all years have 366 days
  Days360, ///< all months have 30 days
};

/// The calendar of a name, as `noleap` or `365_day`; the empty one is the standard one. Throws InvalidInput.
Calendar CalendarOf(const std::string& name);

struct CalendarDate
{
  long long Year = 1970;
  int Month = 1;
  int Day = 1;
};

/// Number of a day, which rises by 1 from each day of a calendar to the next. Throws InvalidInput for a date that the
/// calendar does not have.
long long DayNumber(Calendar calendar, const CalendarDate& date);

/// The date of a number of a day.
CalendarDate DateOf(Calendar calendar, long long day);

/// An instant of a calendar: the number of its day and the time since its midnight.
struct CalendarTime
{
  long long Day = 0;
  double Seconds = 0.0; ///< 0 to 86400
};

/// The instant of a text, "2020-02-28", "2020-02-28T06:00:00Z" or "1990-1-1 0:0:0.0 -3:30"; a time zone is that far
/// ahead of UTC, in which the result is. Throws InvalidInput.
CalendarTime ReadTime(Calendar calendar, const std::string& text);

/// "2020-02-28T06:00:00Z", rounded to the second.
std::string TextOfTime(Calendar calendar, const CalendarTime& time);

/// An instant so many seconds later.
CalendarTime Later(const CalendarTime& time, double seconds);

/// Seconds from one instant to another.
double SecondsBetween(const CalendarTime& from, const CalendarTime& to);

/// The unit of an axis of times.
struct TimeUnit
{
  double Seconds = 1.0; ///< of one
  bool HasDate = false; ///< else its times are since no date
  CalendarTime Since;
};

/// The unit of a text, as "hours since 1950-01-01" or "s". Months and years, which have no length, and what is no unit
/// of times throw InvalidInput.
TimeUnit TimeUnitOf(Calendar calendar, const std::string& units);

}

#endif
