# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Can a machine tell patches of a place from patches of its twins? Trained on one half of the place and some seeds,
asked about the other half and other seeds, then the halves change their parts. Needs Debian's python3-sklearn."""

import numpy as np
from patch_features import features
from sklearn.ensemble import RandomForestClassifier
from sklearn.linear_model import LogisticRegression
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler


def measured_like(twin, place):
    """A twin in steps of its place's heights, as a model in whole metres; unchanged where these have no step."""
    steps = np.diff(np.unique(place))
    whole = steps.size and np.allclose(place, np.round(place))
    return np.round(twin) if whole else twin


def classifiers():
    regression = LogisticRegression(C=0.1, max_iter=2000, class_weight="balanced")
    return {"regression": make_pipeline(StandardScaler(), regression),
            "forest": RandomForestClassifier(200, min_samples_leaf=3, class_weight="balanced", random_state=1)}


def accuracy(place, twins, spacing):
    """Mean of the shares of both classes that are told rightly, by a logistic regression and by a forest, and features
    that tell most: (name, mean difference of twins to the place in standard deviations, importance in the forest)."""
    scale = np.hypot(*np.gradient(place, spacing[1], spacing[0])).mean()
    real, names = features(place, spacing, scale)
    fake = [features(measured_like(twin, place), spacing, scale)[0] for twin in twins]
    middle = len(twins) // 2
    told = {name: [] for name in classifiers()}
    weights = np.zeros(len(names))
    for part in (0, 1):
        for seeds, others in ((range(middle), range(middle, len(twins))), (range(middle, len(twins)), range(middle))):
            known = np.vstack([real[part], *[fake[n][part] for n in seeds]])
            labels = np.arange(len(known)) >= len(real[part])
            asked_real, asked = real[1 - part], np.vstack([fake[n][1 - part] for n in others])
            for name, classifier in classifiers().items():
                classifier.fit(known, labels)
                right = 0.5 * (np.mean(~classifier.predict(asked_real)) + np.mean(classifier.predict(asked)))
                told[name].append(right)
                if name == "forest":
                    weights += classifier.feature_importances_ / 4.0
    all_real, all_fake = np.vstack(real), np.vstack([half for twin in fake for half in twin])
    differences = (all_fake.mean(0) - all_real.mean(0)) / (all_real.std(0) + 1e-9)
    order = np.argsort(-weights)
    means = {name: np.mean(values) for name, values in told.items()}
    return means, [(names[n], differences[n], weights[n]) for n in order[:8]]
