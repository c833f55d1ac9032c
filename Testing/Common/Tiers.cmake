# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause

# Cases with a tier of their own, as filters of GoogleTest by program: all others are in the tier `quick`, where a
# program may take 1 s of processor time. `standard`: what takes above about 0.4 s, up to 10 s a program.
set(standard_TestAonoKuniiTree *AreAFunctionOfTheirSeed*)
set(standard_TestBeamModes BeamModes.ShapesDoNotCancel)
set(standard_TestCoarseGround CoarseGround.LargeGroundIsCarvedByItTheSameOnAnyThreads)
set(standard_TestCurveEnvelope CurveEnvelope.RejectsARandomPatternAsOftenAsItsLevel)
set(standard_TestDetrendedWindow
  DetrendedWindow.AgreesWithTheMatricesOfAllValues TurningBandsPlane.IsTheOneFittedToTheField)
set(standard_TestDrainageCarving
  DrainageCarving.GroundMuchLargerThanItsPlaceDrainsWithThePlacesHeights DrainageCarving.MeetsThePlacesMeasures)
set(standard_TestFieldAtData FieldAtData.HasTheModelsCovariance)
set(standard_TestFractalDimension FractalDimension.OfFractalSurfacesIsTheirs)
set(standard_TestGardnerPlant
  Kinds/*/Tree Kinds/*/Bush GardnerTexture.ShellsAreAsOpaqueAsTheFunctionIsAboveTheirThreshold)
set(all_TestGardnerPlant Kinds/*/Cypress Kinds/*/StonePine) # as tree and bush
set(standard_TestIntensityTrend
  IntensityTrend.PointsAtADistanceHaveATrend IntensityTrend.ClustersAreFoundUnderATrend)
# The fit is right by MeetsTheEquationsOfTheLikelihood too.
set(all_TestIntensityTrend IntensityTrend.WhatWasSimulatedIsFoundAgain)
set(standard_TestLevelLooks *LookTheSameAtAllLevels)
set(standard_TestPairFunctions PairFunctions.AgreeWithSpatstat PairFunctions.FollowTheirDefinitions)
set(standard_TestParticleLevels
  ParticleLevels.NothingVisibleIsLost ParticleLevels.SlavesStayWithinTheirBound
  TrainSelection.TailSumBoundsTheErrorOnTheScreen)
set(standard_TestPatternVerdict
  PatternVerdict.CellsAreMadeByASoftCoreAndNotByAStrictDistance PatternVerdict.WhatNothingMakesIsCalledByNoName
  PatternVerdict.PolygonsHaveProcessesOnly PatternVerdict.MappedPatternsAreRegrown)
# CellsAreMadeByASoftCoreAndNotByAStrictDistance too.
set(all_TestPatternVerdict PatternVerdict.CellsHaveASoftCoreAndNothingElse)
set(standard_TestPlantLevels
  PlantLevels.LowIsFourRectanglesAroundThePlant CylindricalProjection.ATreeIsDenseInItsMiddleAndOpenAtItsRim)
set(standard_TestPlantMeshes *) # all grow all plants
set(standard_TestPlantSway PlantSway.AnyTimeWithoutHistoryBitwise PlantSway.InterpolatedIsCloseForATree)
set(standard_TestPointProcesses
  *SameBytesOnAnyThreads/* *RasterChangesTheIntensity/* *SimulatedPairsFollowTheClosedForm/*
  PointProcesses.StraussPointsObeyTheirConditionalIntensity
  PointProcesses.StraussPointsWhoseBoundsDoNotMeetAreNotCalledExact
  PointProcesses.StraussPointsWithoutInteractionArePoisson)
set(standard_TestProcessFits ProcessFits.SimulatedProcessesAreFoundAgain ProcessFits.SameBytesOnAnyThreads)
set(standard_TestQuadratLaws QuadratLaws/LargeLaws.*)
set(standard_TestSeaweedDynamics SeaweedDynamics.RodsInSpaceMoveAsLagrangesEquationsSay)
set(standard_TestSeaweedMotion
  SeaweedMotion.ChainsOfAnyStiffnessAreStable
  SeaweedMotion.PlantsOfAnyResolutionAndStiffnessFollowTheWater)
set(standard_TestSoftCore
  SoftCore.RandomPointsHaveNone SoftCore.WhatWasSimulatedIsFoundAgain SoftCore.ForcesBalanceAsInEquilibrium
  SoftCore.IntensityIsThatAskedFor)
set(standard_TestTerrainLevels *AreWatertightInRandomViews/*)
set(standard_TestTurningBands
  */SimpleExponential */Spherical */Bessel1 TurningBands.SpectrumIsAsEvenAsThatOfExactNoise
  TurningBands.MeasuredVarianceIsTheModels TurningBands.UniformBinsOfThePaperKeepVarianceAndCovariance)
# CovarianceOfLinesAndShortWavesIsTheModels for all models too.
set(all_TestTurningBands */DoubleExponential */Telis */Bessel2)
set(standard_TestVariogramFit VariogramFit.GrownFieldsGiveBackModelAndParameters)
set(standard_TestWaterWalls WaterWalls.GatherNoTracers)
set(standard_TestWaveTrains WaveDirections.HaveTheMomentsOfTheirDistribution)
set(standard_TestWindField WindField.SpectraOfOneRun WindField.AgreesWithCholesky)
# Coherence is that of the model in ImpliedCoherenceIsTheModelWithinTheReportedError and AgreesWithCholesky too.
set(all_TestWindField WindField.CoherenceOfSixRuns)
