//! Directed edges between numbered places, equal points under one number.

use std::collections::HashMap;

use crate::arrange::Edge;
use crate::number::Number;
use crate::point::{Place, Point};

/// Edges as pairs of indices into the places.
pub struct Graph<Q> {
    /// The places, no two equal.
    pub places: Vec<Place<Q>>,
    /// The edges: tail and head.
    pub edges: Vec<(usize, usize)>,
}

impl<Q: Number> Graph<Q> {
    /// Numbers the ends of the edges.
    #[must_use]
    pub fn new(edges: Vec<Edge<Q>>) -> Self {
        let mut numbers: HashMap<Point<Q>, usize> = HashMap::with_capacity(edges.len());
        let mut places: Vec<Place<Q>> = Vec::new();
        let mut number = |point: Point<Q>| {
            *numbers.entry(point).or_insert_with_key(|point| {
                places.push(Place::from(point.clone()));
                places.len() - 1
            })
        };
        let edges = edges.into_iter().map(|(a, b)| (number(a), number(b))).collect();
        Self { places, edges }
    }
}
