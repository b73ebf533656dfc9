//! Edges led through the vertices next to them, so that what crosses by less than the tolerance meets in vertices.

use super::edge::{Edge, Net};

/// An edge that was led elsewhere may come near other vertices: how often that is looked at again.
pub(super) const ROUNDS: usize = 4;

/// The net with every edge cut at the vertices within the tolerance of it.
pub(super) fn lead(mut net: Net, tolerance: f64) -> Net {
    let mut order: Vec<u32> = (0..net.points.len() as u32).collect();
    order.sort_by(|u, v| net.points[*u as usize].x.total_cmp(&net.points[*v as usize].x));
    for _ in 0..ROUNDS {
        let cut = |e: &Edge| cut(&net, &order, e, tolerance);
        let loops: Vec<Vec<Edge>> = net.loops.iter().map(|edges| edges.iter().flat_map(cut).collect()).collect();
        if loops.iter().map(Vec::len).eq(net.loops.iter().map(Vec::len)) {
            break;
        }
        net.loops = loops;
    }
    net
}

/// The parts of an edge between the vertices within the tolerance of it; `order` sorts the vertices by x.
fn cut(net: &Net, order: &[u32], edge: &Edge, tolerance: f64) -> Vec<Edge> {
    let span = net.span(edge);
    let (low, high) = span.bounds();
    let (low, high) = (low - tolerance, high + tolerance);
    let point = |v: u32| net.points[v as usize];
    let from = order.partition_point(|v| point(*v).x < low.x);
    let near = order[from..].iter().copied().take_while(|v| point(*v).x <= high.x);
    let near = near.filter(|v| point(*v).y >= low.y && point(*v).y <= high.y && ![edge.tail, edge.head].contains(v));
    let mut near: Vec<u32> = near.filter(|v| span.distance(point(*v)).is_some_and(|d| d <= tolerance)).collect();
    near.sort_by(|u, v| point(*u).distance(span.tail).total_cmp(&point(*v).distance(span.tail)));
    let mut parts = Vec::with_capacity(near.len() + 1);
    let (mut tail, mut done) = (edge.tail, 0.0);
    for head in near {
        let upto = span.half_sweep_to(point(head));
        parts.push(Edge { tail, head, delta: upto - done });
        (tail, done) = (head, upto);
    }
    parts.push(Edge { tail, head: edge.head, delta: edge.delta - done });
    parts
}
