//! The proof of natural frequencies of undamped systems.
//!
//! `J(ω)` is the number of frequencies below ω, with multiplicity; motions that grow, of ω² < 0, are among them. A [run](count) gives a bound
//! of J from above or from below. All rounding is in the bound. The page `docs/guide/certificates.md` lists what has to be right
//! for it: the arithmetic, IEEE 754 with rounding to nearest, the numbers of the model, which [`visit`] names, and more.
//!
//! `neg(A)` is the number of negative eigenvalues of a symmetric matrix A. `A >= B` says that `A - B` has none. Then `neg(A) <= neg(B)`.
//!
//! **T1, domination.** E is symmetric and `|E_ij| <= δ_ij`. Take positive `c_ij` with `c_ij c_ji = 1`, and let D be diagonal with
//! `D_ii >= Σ_j c_ij δ_ij`. Then `-D <= E <= D`. *Proof*: `2 |E_ij x_i x_j| <= δ_ij (c_ij x_i² + c_ji x_j²)`. ∎ So errors of entries become
//! errors of rows. The `c_ij` decide how sharp these are, and not whether they hold. [`front`] shares a sum by its weights,
//! `c_ij = w_j/w_i`, and a product by the column of its pivot, `c_ij = |a_i/a_j|`.
//!
//! **T2, nudged elimination.** A is exact and not known. The front stores `A_1` and an error `e_i >= 0` of each row, such that
//! `A >= A_1 - diag(e)`. A variable k leaves in three steps. The pivot is any number `d <= (A_k)_kk - e_k` that is not zero. S is what the
//! exact elimination with the pivot d makes of the stored matrix. The front stores any `A_(k+1)`, and adds errors e' to the rows that stay,
//! such that `S >= A_(k+1) - diag(e')`. When all variables have left, `neg(A)` is at most the number of negative d. With all signs turned,
//! and `d >= (A_k)_kk + e_k`, it is at least that number. *Proof*: a lower diagonal entry only raises `neg`. What is added to the diagonal
//! of a row that stays commutes with the elimination. Let f be e without its entry k. Then `neg(A_k - diag e) <= [d < 0] + neg(S - diag f)`
//! (Haynsworth). That is at most `[d < 0] + neg(A_(k+1) - diag(f + e'))`. Induction. ∎ Nothing is asked of the size of a pivot, of the
//! order or of the condition: beside a small pivot the bound gets weak, not wrong, so its variable waits. Parts may join rows that stay at any time.
//!
//! **T3, count** (Wittrick and Williams). `J = Σ held + neg(K)`. K is the dynamic stiffness of all parts, and `held` the number of
//! frequencies of a member with both ends held. It holds where no member has such a frequency at ω itself. So the minor of each
//! member is proven not to be zero, or the member has a border (T6). Else [`member::Member::known_where`] makes its bounds infinite, the count
//! is NaN, and the run says nothing. `held` follows from the argument and the sign of the minor; where the sign leaves a choice it is a range.
//!
//! **T4, certificates.** `J(lower) <= k - 1` says `ω_k >= lower`, and `J(upper) >= k + m - 1` says `ω_(k+m-1) < upper`. So both say that the
//! frequencies k to `k + m - 1` lie in `[lower, upper)`. Intervals whose indices leave no gap are a complete list. Those of a range are
//! complete with J at both of its ends. Nothing is said about the exact coincidence of m frequencies.
//!
//! **T5, constraints.** Of a constrained structure the count is `neg(NᵀKN)` for any basis N of its admissible motions (Sylvester). So a
//! displacement of a part is a [`row`] over variables: a support has none, a joint shares them, a lever adds a rotation, a skew support has
//! one along a vector of any length. What has to be zero besides is solved for one variable. If it is zero already, exactly, it is held twice
//! by the same and dropped; if that is not decided, the run fails. The force λ of a rigid joint between nodes is a variable, and adds one
//! negative pivot, which is taken off. If two such forces depend on each other, both bounds never meet.
//!
//! **T6, borders.** Beside a frequency with held ends a stiffness is large and hardly known. There the member is `[[R, v], [vᵀ, -σ]]` with one
//! variable more, whose elimination gives the stiffness `R + v vᵀ/σ` back. R, v and σ are entire. J is `held - [σ > 0] + neg(all)`,
//! and `held - [σ > 0]` has no step there: it is the count with one displacement let go, less one. A general beam is two beams there
//! instead, and a tapered beam is short pieces, which have no such frequency.
//!
//! | file | what it has |
//! |---|---|
//! | [`word`], [`number`], [`four_words`], [`level`] | an `f64` or several in lanes; numbers of two and of four words, with the bounds of a sum and a product |
//! | [`ball`], [`series`], [`functions`] | a number with a bound of its error; Taylor series, sine, cosine and exponential of it, by `number::constants` |
//! | [`member`] | a stiffness in balls, its border, its count with held ends |
//! | [`line`], [`bending`], [`general_bending`], [`tapered`] | these of lines, plain beams, general beams, tapered beams |
//! | [`front`] | T1 and T2: parts are added, variables leave |
//! | [`row`], [`joining`], [`joined`], [`adding`] | T5: displacements over variables; T3 and T6: parts join the front |
//! | [`constraint`] | T5: what has to be zero makes a variable a combination of others; what does not go on leaves |
//! | [`join`], [`run`] | what parts join: the front, or the matrix of a disc; a visit that joins them |
//! | [`axes`] | axes of members, directions of nodes |
//! | [`tree`], [`frame`] | which rows the parts of a tree and of a frame have, and when variables leave |
//! | [`visit`] | how a model names its parts: all that a proof knows of it |
//! | [`count`], [`memory`] | a run; memory for its front, and lanes |
//! | [`prover`] | bounds of the count at a frequency, in two words and in four |
//! | [`beside`], [`certificate`] | bounds beside estimates; T4: claims about these |
//! | [`bisection`] | a frequency that nobody has proposed |
//! | [`disc`] | T8: simple eigenvalues of damped systems |

pub(crate) mod adding;
mod axes;
pub(crate) mod ball;
pub(crate) mod bending;
pub(crate) mod beside;
pub(crate) mod bisection;
pub(crate) mod certificate;
pub(crate) mod constraint;
pub(crate) mod count;
pub(crate) mod disc;
pub(crate) mod four_words;
pub(crate) mod frame;
pub(crate) mod front;
pub(crate) mod functions;
pub(crate) mod general_bending;
pub(crate) mod join;
pub(crate) mod joined;
pub(crate) mod joining;
pub(crate) mod level;
pub(crate) mod line;
pub(crate) mod member;
pub(crate) mod memory;
pub(crate) mod number;
pub(crate) mod prover;
pub(crate) mod row;
pub(crate) mod run;
pub(crate) mod series;
pub(crate) mod tapered;
pub(crate) mod tree;
pub(crate) mod visit;
pub(crate) mod word;

#[cfg(test)]
mod tests;
