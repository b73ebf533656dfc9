//! `arcsum-cgal`: answers questions to CGAL, a line each, so that CGAL can die without its asker.

fn main() -> std::io::Result<()> {
    arcsum_cgal::child::serve()
}
