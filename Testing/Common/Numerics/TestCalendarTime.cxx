// SPDX-FileCopyrightText: Littoral contributors
// SPDX-License-Identifier: BSD-3-Clause
// Calendars of CF against Julian day numbers and counts of their own; units of times; what is none.
#include "Numerics/CalendarTime.h"
#include "Numerics/InvalidInput.h"

#include <gtest/gtest.h>

#include <string>

using namespace littoral;

namespace
{

constexpr Calendar All[] = { Calendar::Standard, Calendar::ProlepticGregorian, Calendar::Julian, Calendar::NoLeap,
  Calendar::AllLeap, Calendar::Days360 };

std::string After(const char* calendar, const char* units, double value)
{
  const Calendar own = CalendarOf(calendar);
  const TimeUnit unit = TimeUnitOf(own, units);
  return TextOfTime(own, Later(unit.Since, value * unit.Seconds));
}

}

TEST(CalendarTime, DaysAreThoseOfJulianDayNumbers)
{
  // 1970-01-01 is JDN 2440588; from the tables of the Astronomical Almanac
  EXPECT_EQ(DayNumber(Calendar::Standard, { 1970, 1, 1 }), 0);
  EXPECT_EQ(DayNumber(Calendar::Standard, { 2000, 1, 1 }), 2451545 - 2440588);
  EXPECT_EQ(DayNumber(Calendar::Standard, { 1858, 11, 17 }), 2400001 - 2440588);
  EXPECT_EQ(DayNumber(Calendar::Standard, { 1582, 10, 15 }), 2299161 - 2440588);
  EXPECT_EQ(DayNumber(Calendar::Standard, { 1582, 10, 4 }), 2299160 - 2440588);
  EXPECT_EQ(DayNumber(Calendar::Standard, { 1, 1, 1 }), 1721424 - 2440588);
  EXPECT_EQ(DayNumber(Calendar::ProlepticGregorian, { 1, 1, 1 }), 1721426 - 2440588);
  EXPECT_EQ(DayNumber(Calendar::Julian, { 1969, 12, 19 }), 0);
  EXPECT_EQ(DayNumber(Calendar::Standard, { -4712, 1, 1 }), -2440588);
}

TEST(CalendarTime, EachDayHasADateAndOnlyOne)
{
  for (const Calendar calendar : All)
  {
    CalendarDate last = DateOf(calendar, -150001);
    for (long long day = -150000; day < 60000; ++day)
    {
      const CalendarDate date = DateOf(calendar, day);
      ASSERT_EQ(DayNumber(calendar, date), day);
      const bool isNext = date.Day == last.Day + 1 || date.Day == 1 || (last.Day == 4 && date.Day == 15);
      ASSERT_TRUE(isNext) << date.Year << " " << date.Month << " " << date.Day;
      last = date;
    }
  }
}

TEST(CalendarTime, UnitsCountInTheirCalendar)
{
  EXPECT_EQ(After("", "days since 2000-02-28", 2.0), "2000-03-01T00:00:00Z");
  EXPECT_EQ(After("noleap", "days since 2000-02-28", 1.0), "2000-03-01T00:00:00Z");
  EXPECT_EQ(After("366_day", "days since 2001-02-28", 1.0), "2001-02-29T00:00:00Z");
  EXPECT_EQ(After("360_day", "days since 2001-02-28 12:00", 2.0), "2001-02-30T12:00:00Z");
  EXPECT_EQ(After("gregorian", "days since 1582-10-04", 1.0), "1582-10-15T00:00:00Z");
  EXPECT_EQ(After("proleptic_gregorian", "days since 1582-10-04", 1.0), "1582-10-05T00:00:00Z");
  EXPECT_EQ(After("julian", "days since 1900-02-28", 1.0), "1900-02-29T00:00:00Z");
  EXPECT_EQ(After("standard", "hours since 1950-01-01T06:00:00+01:30", 1.5), "1950-01-01T06:00:00Z");
  EXPECT_EQ(After("standard", "seconds since 1990-1-1 0:0:0.0 -3:30", 0.0), "1990-01-01T03:30:00Z");
  EXPECT_EQ(After("standard", "minutes since 1999-12-31 23:00:00 UTC", 60.0), "2000-01-01T00:00:00Z");
  EXPECT_EQ(After("Standard", "Days Since 1858-11-17 00:00:00", 58849.25), "2020-01-01T06:00:00Z");
  EXPECT_EQ(After("standard", "milliseconds since 2020-01-01", 1e3), "2020-01-01T00:00:01Z");
  EXPECT_FALSE(TimeUnitOf(Calendar::Standard, "second").HasDate);
  EXPECT_DOUBLE_EQ(SecondsBetween({ 1, 3600.0 }, { 2, 0.0 }), 82800.0);
}

TEST(CalendarTime, WhatIsNoTimeIsRefused)
{
  for (const char* units :
    { "", "fortnights since 2000-01-01", "days after 2000-01-01", "days since", "days since noon",
      "days since 2001-02-29", "days since 2000-13-01", "days since 1582-10-10", "days since 2000-01-01 25:00",
      "days since 2000-01-01 00:61", "days since 2000-01-01 00:00:00 MEZ", "months since 2000-01-01" })
  {
    EXPECT_THROW(TimeUnitOf(Calendar::Standard, units), InvalidInput) << units;
  }
  EXPECT_THROW(CalendarOf("mayan"), InvalidInput);
}
