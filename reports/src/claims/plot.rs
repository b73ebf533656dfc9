//! What to draw of an experiment: points of some series, or a histogram.

use serde::{Deserialize, Serialize};

/// Points kept of a series.
const MOST: usize = 600;

/// A plot; one without series is none.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Plot {
    /// What is along the horizontal axis.
    pub x: String,
    /// What is along the vertical axis; empty for a histogram of the abscissas.
    pub y: String,
    /// Whether the axes are logarithmic.
    pub log: [bool; 2],
    /// The series.
    pub series: Vec<Series>,
}

/// Points of one kind.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Series {
    /// What they are.
    pub name: String,
    /// Whether they are joined by lines.
    pub line: bool,
    /// The points.
    pub points: Vec<[f64; 2]>,
}

impl Series {
    /// Points of this name; of many, every so many-th and the highest.
    #[must_use]
    pub fn new(name: &str, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let all: Vec<[f64; 2]> = points.into_iter().filter(|p| p.iter().all(|c| c.is_finite())).collect();
        let step = all.len().div_ceil(MOST).max(1);
        let mut points: Vec<[f64; 2]> = all.iter().copied().step_by(step).collect();
        points.extend(all.iter().copied().max_by(|p, q| p[1].total_cmp(&q[1])).filter(|_| step > 1));
        Self { name: name.into(), line: false, points }
    }

    /// The same, joined by lines.
    #[must_use]
    pub fn joined(self) -> Self {
        Self { line: true, ..self }
    }
}

impl Plot {
    /// A plot on two logarithmic axes.
    #[must_use]
    pub fn log_log(x: &str, y: &str, series: Vec<Series>) -> Self {
        Self { x: x.into(), y: y.into(), log: [true, true], series }
    }

    /// A plot on two linear axes.
    #[must_use]
    pub fn linear(x: &str, y: &str, series: Vec<Series>) -> Self {
        Self { x: x.into(), y: y.into(), log: [false, false], series }
    }

    /// A histogram.
    #[must_use]
    pub fn histogram(x: &str, values: impl IntoIterator<Item = f64>) -> Self {
        let series = Series::new("", values.into_iter().map(|v| [v, 0.0]));
        Self { x: x.into(), y: String::new(), log: [false, false], series: vec![series] }
    }
}
