//! The peak of a response over a band, between two bounds.
//!
//! The largest of `|f/g|` over the band, where f is the response H and g is 1, or f and g are two responses of one system, or they have changed their
//! places, of which the inverse is the least of the response. The band `λ = iω` is cut into pieces. A piece of the middle c and the half length h is
//! `λ = i(c + h x)` with x from -1 to 1.
//!
//! **Poles.** Let B be a box about the piece, and λ_n the eigenvalues in it. If B holds no others, `F = f Π` and `G = g Π` with
//! `Π = Π (x - x_n)` are analytic in B, and `f/g = F/G`. A count of the eigenvalues in B tells that; the list of the user only says where they are. Where
//! the counts differ the piece is cut in two: boxes shrink with pieces until they hold no eigenvalue that the list lacks.
//!
//! **Polynomials.** B contains the ellipse `E`, `x = (r e^{it} + e^{-it}/r)/2` with r = 3. Let M be the largest of |F| on it. Then the coefficients of
//! Chebyshev's series of F are at most `2 M r^-k`, and the series cut at degree d errs by `2 M r^-d/(r - 1)`. Let p be the polynomial of degree d through values of F at d + 1 places. It
//! errs by `1 + Λ` times as much, where Λ bounds a polynomial of that degree by its values at the places. At the zeros x_j of `T_{d+1}` this is `1 + (2/π) ln(d + 1)`, no more than 3.5.
//! Rounding moves places by δ, some units of rounding of the frequency over h. By Markov's inequality a polynomial q changes by `δ d² max |q|` there, so that Λ becomes
//! `Λ/(1 - Λ d² δ)`. No piece is so short that this is more than 3.9.
//!
//! **Roundings.** Values of F err by rounding, and where λ_n is known to a radius e_n by `e_n/|λ - λ_n|` of F for each n. The polynomial errs by no more than
//! Λ times the largest of these. At x the true Π differs from that of the list by no more than `Σ e_n/(|λ - λ_n| - e_n)` of it.
//!
//! **Levels.** On a part of the piece, from `x0 - s` to `x0 + s`, both polynomials are expanded about x0. With bounds a and b of their errors,
//! `|p| + a <= γ (|q| - b)` follows from `γ² |q|² - |p|² >= 2 γ (a + γ b) sup |q|`: the left side is
//! `(γ |q| - |p|)(γ |q| + |p|)`, and the second factor is at most `2 γ |q|`. The left side is a polynomial. Its terms of order three and more are bounded by their
//! coefficients, the rest is a parabola. Parts where that does not decide are halved, so that the last ones are a share of the cube root of the tolerance.
//!
//! What is above the level in a polynomial is evaluated, and raises the level: γ is never less than `1 + ε` times a value that was seen. The peak is bounded when all pieces are
//! below the level.
//!
//! **What the upper bound rests on, beside the theorem.** On the count of eigenvalues in each box, by the argument principle as `count_in` has it, or by the proven count of the undamped system; for a
//! sum over modes on nothing. A count is not trusted alone: at two places between those of the values the polynomial has to be as near to F as its error says. On M, which is four times the largest of 16 values on the ellipse: a double pole just outside of the box exceeds them by three. On
//! roundings of values, of which no bound is known: they are taken as 16 units of each value. All else is a theorem.

pub(crate) mod function;
pub(crate) mod level;
pub(crate) mod piece;
pub(crate) mod search;
pub(crate) mod source;
#[cfg(test)]
mod tests;
