//! Where the printed algorithm is wrong or silent, and what this engine does instead.
//!
//! | MS | printed | here |
//! |---|---|---|
//! | 4.1, 4.2 | normal angle arctan((h_y - t_y)/(t_x - h_x)) | arctan of the inverse fraction: [`crate::angle::Ang::of_line`] |
//! | 4.1 | delta = arcsin(d/r), whose only bad values are coordinate differences | badly conditioned near half circles: arctan with an exact radicand, [`crate::arc::half_sweep_of_radius`] |
//! | 4.1 | angles as radians | relative error near multiples of 90 degrees is lost, and with it Theorem 1: axis and offset, [`crate::angle::Ang`] |
//! | 4.1 | second form of d_x | holds for theta = gamma only: points by rotation from the nearer end, [`crate::arc::Arc::offset`] |
//! | 4.1 | condition number y g(y)/g'(y) | y g'(y)/g(y) |
//! | 4.1 | two applications of Dekker's method round the sum of three once | they do not: round to odd, [`crate::sum3`] |
//! | 4.1 | a secant errs by eps/2 because the sine of gamma exceeds 1/2 | neither true nor needed; at most 0.18 eps with these angles, [`crate::smooth`] |
//! | 4.1 | lines with rounded vertical normals are split | cannot occur with these angles; counted to prove it, [`crate::smooth::Counts`] |
//! | 4.2 | cot phi is well conditioned | not near 180 and 360 degrees in radians |
//! | 3 | radius(e) = radius(a) + radius(b) | the negative for sums that run backwards, whose normal is opposite: [`crate::convolution`] |
//! | 3, Fig. 2 | head h1 + t2, tail h1 + t2 | head t1 + h2 |
//! | 3 | vertices are labelled 1, 2, ... | only comparisons between A and B are made: A comes first, one bit |
//! | 3 | the winding number counts the components of A ∩ (t - B) | it is the Euler characteristic: holes are filled unless the partner fits, [`crate::convolution::fill`] |
//! | 2 | the extension to several loops is straightforward | it is the fill rule |
//! | 4 | negative winding numbers are impossible in exact arithmetic | possible with holes that should have been filled |
//! | 7.1 | the convolution order is enforced between all related segments | it speaks of ordinates at one abscissa: where a line rises by much within a rounding of x, and between verticals, it says nothing |
//! | 5.1 | T segments are boundaries | reversed boundaries: [`crate::chain`] and the convolution |
//! | 4.2 | vertical distance in Theorems 1 and 3 | end points have rounded abscissas, so on steep pieces only a Hausdorff distance can be small |
//! | 6.1 | the vertical error of T segments is trivially O(eps) | half a unit in the last place of the abscissa times their slope: their ends are right to a unit |
//! | 4.2 | Theorem 1: chains move vertically by a few eps | an arc of sweep s that continues a vertical line moves by up to 0.6/s eps: realized along a direction clear of all stored ones |
//! | 4.2 | chains are split at every angle of the convolution | angles an ulp apart give swapped or equal points: arcs are not split, since an exact arc has every normal |
//! | 7.1, 7.2 | rule 4: L1+L2 is nowhere above U1+U2 | only as far as the shorter chain of each pair reaches: 17/4 above 15/4 at 13/2 in a test on small integers, [`crate::convolution::order`] |
//! | 7.1 | an edge is related to at most five segments | five at each of its ends: a crust has two, and six are met |
//! | 7.2, Lemma 3 | the functions f1', f2' are close to f1, f2 | they are, but not the other way round: a spike at an end may be dropped |
//! | 7.2, Theorem 4 | no falsely free points | the proof takes errors for vertical ones: none where no segment is a few roundings wide and taller, as far as is known |
//!
//! The arrangement algorithm of MS reference 5 is not printed in MS. [`crate::arrangement`] is a design of its own with the
//! bounds that MS quotes. Two things were learnt on lines that rise by much within a few units in the last place of x: curves
//! must be ordered by ordinates at one abscissa, because nearness in the normal direction is not transitive; and a
//! crossing of such lines may have no representable place between their ends in the order of events, so when it happens and
//! where it happens are kept apart.
