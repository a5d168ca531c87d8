//! The proof of simple eigenvalues of damped systems.
//!
//! K(λ) is the dynamic stiffness of all parts over all variables, complex and symmetric: nothing is eliminated. A member that is beside a frequency
//! with held ends is cut in two, and a general beam is short pieces, so that no entry is large.
//!
//! **T8, discs.** D is a disc about λ₀ with the radius r. K is analytic on it, since no minor of a member vanishes there. b is a vector of numbers,
//! and `M = [[K, b], [bᵀ, 0]]` is regular on D. `M [x; g] = [0; 1]` defines g(λ). Where `|g(λ₀)| < r (|c| - S)`, with any number c and
//! `S >= |g' - c|` on D, exactly one eigenvalue is in D, and it is simple. *Proof*. `g = det K/det M` (Cramer): g and det K have the same zeros
//! in D, with multiplicity. On the rim `|g - c (λ - λ₀)| <= |g(λ₀)| + r S < r |c|`, so that g has as many zeros in D as `c (λ - λ₀)`
//! (Rouché). ∎ The zeros of det K are the eigenvalues, since a motion without displacements of the variables is one of a member with held ends.
//!
//! **Slope.** `g' = -xᵀ K' x`. *Proof*. The derivative of `K x + b g = 0` times xᵀ is `xᵀ K' x + xᵀ K x' + g' = 0`, since `bᵀx = 1`. And
//! `xᵀ K x' = -g bᵀ x' = 0`. ∎
//!
//! **Solution.** R is nearly the inverse of M. Where `q = |I - R M| < 1` in the norm of the largest row, M is regular, and a vector ỹ is off the solution
//! by `|R (e - M ỹ)|/(1 - q)` at most. On D it is `e - M ỹ` at λ₀ less `(K - K(λ₀)) x̃`, of which `r sup|K'| |x̃|` is a bound. That of g alone is sharper, by its
//! row of R and of `I - R M`.
//!
//! **Derivatives.** Let C be the difference of K at λ₀ and at `λ₀ + h` over h, with `h <= r`. It is a mean of K' on D, so that `|K' - C| <= 2r sup|K''|`.
//! Where `|K| <= B` on a disc of the radius R about λ₀, `|K''| <= 2B/(R - r)²` on D (Cauchy). So no derivative is enclosed, but K at three discs:
//! at λ₀, at `λ₀ + h` and on the wide one.
//!
//! All of that is in the units of powers of two that make rows alike. Sums of bounds are of positive numbers; what their rounding loses is added.
//! Nothing is asked of b, R, ỹ and c: where they are poor nothing is proven.
//!
//! | file | what it has |
//! |---|---|
//! | [`complex`] | complex numbers with a bound of their error; inverse, root, decay, series |
//! | [`member`], [`line`], [`bending`], [`general`] | stiffnesses of members with damping at complex frequencies |
//! | [`matrix`] | K: what the parts of a model join |
//! | [`examination`], [`invert`] | slopes, M, R and ỹ |
//! | [`bounds`] | q, S, and the least radius |
//! | [`eigenvalue`], [`memory`], [`room`] | estimates that are moved to where they are proven; memory |

pub(crate) mod bending;
pub(crate) mod bounds;
pub(crate) mod complex;
pub(crate) mod eigenvalue;
pub(crate) mod examination;
pub(crate) mod general;
pub(crate) mod invert;
pub(crate) mod line;
pub(crate) mod matrix;
pub(crate) mod member;
pub(crate) mod memory;
pub(crate) mod room;
