# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Regular, random and clustered patterns, grown, measured, and called by their names."""

from littoral import vtkQuadratAnalysisFilter, vtkQuadratPointSource

EXPECTED = {"Poisson": "random", "Binomial": "regular", "NegativeBinomial": "clustered",
            "PoissonPoisson": "clustered", "PoissonBinomial": "clustered",
            "PoissonNegativeBinomial": "clustered"}

for law, pattern in EXPECTED.items():
    source = vtkQuadratPointSource()
    source.SetLaw(getattr(vtkQuadratPointSource, law))
    source.SetQuadrats(30, 30)
    source.SetMode(vtkQuadratPointSource.Sampling)
    source.SetSeed(11)
    analysis = vtkQuadratAnalysisFilter()
    analysis.SetInputConnection(source.GetOutputPort())
    analysis.SetSize(source.GetSize())
    analysis.SetQuadrats(30, 30)
    analysis.Update()
    fields = analysis.GetOutput().GetFieldData()
    called = fields.GetAbstractArray("Pattern").GetValue(0)
    index = fields.GetArray("DispersionIndex").GetValue(0)
    print(f"{law}: {called}, index of dispersion {index:.2f}")
    assert called == pattern, f"{law} is called {called}"
