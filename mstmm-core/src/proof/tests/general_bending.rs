//! The general beam against halves of halves of a short piece, whose stiffness is a series of matrices in 160 digits.

use crate::proof::ball::Ball;
use crate::proof::constants::HALF_PI;
use crate::proof::functions::Level;
use crate::proof::general_bending::{General, GeneralSection, general_bending};
use crate::proof::member::place;
use crate::proof::number::{Number, OneWord, TwoWords};
use crate::proof::word::Word;
use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use std::vec::Vec;

type Exact = FBig<HalfEven, 2>;
type Matrix<const N: usize> = [[Exact; N]; N];

/// Bits of the exact numbers.
const BITS: usize = 540;

fn exact(number: f64) -> Exact {
    Exact::try_from(number).unwrap().with_precision(BITS).value()
}

fn pair([hi, lo]: [f64; 2]) -> Exact {
    exact(hi) + exact(lo)
}

fn near(number: &Exact) -> f64 {
    number.to_f64().value()
}

fn product<const N: usize>(a: &Matrix<N>, b: &Matrix<N>) -> Matrix<N> {
    from_fn(|i| from_fn(|j| (0..N).fold(exact(0.0), |sum, k| sum + &a[i][k] * &b[k][j])))
}

fn sum<const N: usize>(a: &Matrix<N>, b: &Matrix<N>) -> Matrix<N> {
    from_fn(|i| from_fn(|j| &a[i][j] + &b[i][j]))
}

fn difference<const N: usize>(a: &Matrix<N>, b: &Matrix<N>) -> Matrix<N> {
    from_fn(|i| from_fn(|j| &a[i][j] - &b[i][j]))
}

fn determinant(a: &Matrix<2>) -> Exact {
    &a[0][0] * &a[1][1] - &a[0][1] * &a[1][0]
}

fn inverse(a: &Matrix<2>) -> Matrix<2> {
    let over = exact(1.0) / determinant(a);
    let [[p, q], [r, s]] = a;
    [[s * &over, -(q * &over)], [-(r * &over), p * &over]]
}

/// A beam at a frequency.
#[derive(Clone, Copy, Debug)]
struct Case {
    section: GeneralSection,
    length: f64,
    square: f64,
}

/// A beam's stiffness in quarters, [[near, between], [betweenᵀ, far]], and the count with both ends held.
struct Held {
    quarters: [Matrix<2>; 3],
    count: u32,
}

impl Case {
    /// σ, τ, g, h in units of l and EI.
    fn equations(&self) -> [Exact; 4] {
        let section = self.section;
        let (one, square, length) = (exact(1.0), exact(self.square), exact(self.length));
        let tension = pair(section.axial_force) + pair(section.shear_layer);
        let flexibility = pair(section.shear_flexibility);
        let scale = &length * &length / pair(section.bending_stiffness);
        let sigma = &one / (&one + &tension * &flexibility);
        let tau = &flexibility * &sigma / &scale;
        let g = (&sigma * tension - pair(section.rotary_inertia) * &square) * &scale;
        let h =
            (pair(section.mass_per_length) * square - pair(section.foundation_stiffness)) * scale * &length * length;
        [sigma, tau, g, h]
    }

    /// A piece of `2^-halvings` l: by the transfer matrix, a series.
    fn piece(equations: &[Exact; 4], halvings: i32) -> Held {
        let [sigma, tau, g, h] = equations;
        let part = exact(0.5f64.powi(halvings));
        let [sigma, tau, g, h] = [sigma, tau, g, h].map(|number| number * &part);
        // of the state (Y, Θ, M, Q): a column of the product has few terms
        let next = |row: &[Exact; 4]| {
            [&row[3] * &h, &row[0] * &sigma + &row[2] * &g, &row[1] * &part, &row[2] * &sigma - &row[0] * &tau]
        };
        let identity: Matrix<4> = from_fn(|i| from_fn(|j| exact(f64::from(u8::from(i == j)))));
        let (mut transfer, mut term) = (identity.clone(), identity);
        for n in 1..90 {
            term = from_fn(|i| next(&term[i]).map(|entry| entry / exact(f64::from(n))));
            transfer = sum(&transfer, &term);
        }
        let block = |row: usize, column: usize| -> Matrix<2> {
            from_fn(|i| from_fn(|j| transfer[row + i][column + j].clone()))
        };
        // the forces that do work on y and θ are (Q, -M) at the near end and (-Q, M) at the far one
        let forces = |m: Matrix<2>| -> Matrix<2> {
            let [moments, shears] = m;
            [shears, moments.map(|entry| -entry)]
        };
        let negated = |m: Matrix<2>| m.map(|row| row.map(|entry| -entry));
        // d₂ = A d₁ + B f₁, f₂ = C d₁ + D f₁
        let [a, b, c, d] = [block(0, 0), block(0, 2), block(2, 0), block(2, 2)];
        let flexible = inverse(&b);
        let held = negated(product(&flexible, &a));
        let far = negated(product(&d, &flexible));
        let _ = c;
        Held { quarters: [forces(held), forces(flexible), forces(far)], count: 0 }
    }

    /// The whole, and that of its two halves: the stiffness of the point between them has the frequencies that are new.
    fn held(&self) -> Held {
        let equations = self.equations();
        let [sigma, tau, g, h] = equations.each_ref().map(near);
        // No frequency of a held piece of a l is below, by ∫Y² <= A ∫Y'² and the same for Θ, A = (a/π)²: with e = Y' - σΘ its energy is
        // ∫Θ'² + e²/τ + gΘ² - hY², and Y'² <= 2σ²Θ² + 2e².
        let is_free = |part: f64| {
            let (square, h) = ((part / core::f64::consts::PI).powi(2), h.max(0.0));
            2.0 * h * tau * square < 0.9 && 0.9 + g * square - 2.0 * h * sigma * sigma * square * square > 0.0
        };
        let largest = [sigma, tau, g.abs(), h.abs(), 1.0].into_iter().fold(0.0, f64::max);
        let is_short = |halvings: i32| 0.5f64.powi(halvings) * largest < 0.5 && is_free(0.5f64.powi(halvings));
        let halvings = (0..200).find(|halvings| is_short(*halvings)).unwrap();
        let mut whole = Self::piece(&equations, halvings);
        for _ in 0..halvings {
            let [first, between, last] = &whole.quarters;
            let point = sum(first, last);
            let (det, trace) = (determinant(&point), &point[0][0] + &point[1][1]);
            let zero = exact(0.0);
            let negative = if det < zero {
                1
            } else if trace < zero {
                2
            } else {
                0
            };
            let flexible = inverse(&point);
            let transposed: Matrix<2> = from_fn(|i| from_fn(|j| between[j][i].clone()));
            let through = product(between, &flexible);
            whole = Held {
                quarters: [
                    difference(first, &product(&through, &transposed)),
                    product(&through, between).map(|row| row.map(|entry| -entry)),
                    difference(last, &product(&product(&transposed, &flexible), between)),
                ],
                count: 2 * whole.count + negative,
            };
        }
        whole
    }

    fn at<N: Level>(&self) -> General<N> {
        general_bending(&self.section, Ball::of(self.length), Ball::of(self.square))
    }
}

impl Held {
    /// The lower triangle over (y1, θ1, y2, θ2).
    fn entries(&self) -> Vec<Exact> {
        let [first, between, last] = &self.quarters;
        let mut entries = std::vec![exact(0.0); 10];
        for i in 0..2 {
            for j in 0..2 {
                entries[place(i, j)] = first[i][j].clone();
                entries[place(2 + i, 2 + j)] = last[i][j].clone();
                entries[place(2 + j, i)] = between[i][j].clone();
            }
        }
        entries
    }
}

/// What a number is exactly.
trait Parts: Level {
    fn exactly(self) -> Exact;
}

impl Parts for OneWord {
    fn exactly(self) -> Exact {
        exact(self.0)
    }
}

impl Parts for TwoWords<f64> {
    fn exactly(self) -> Exact {
        exact(self.hi) + exact(self.lo)
    }
}

/// What the tests saw.
#[derive(Debug, Default)]
struct Seen {
    cases: u32,
    /// Entries without a bound.
    unknown: u32,
    ranges: u32,
    beside: u32,
    /// The largest part of a bound that was needed.
    share: f64,
    /// The largest bound beside the sizes of its row and its column, away from poles.
    radius: f64,
}

impl Seen {
    fn look<N: Parts<Word = f64>>(&mut self, case: &Case, truth: &Held) {
        let General { member, is_beside_pole } = case.at::<N>();
        self.cases += 1;
        self.beside += u32::from(is_beside_pole);
        if member.stiffness.iter().any(|ball| !ball.rad.is_finite()) {
            self.unknown += 1;
            return;
        }
        let count = f64::from(truth.count);
        let [least, most] = member.held;
        assert!(least <= count && count <= most, "{count} is not in {least} to {most}: {case:?}");
        assert!(least == most || is_beside_pole);
        self.ranges += u32::from(least < most);
        let places = (0..4).flat_map(|row| (0..=row).map(move |column| (row, column)));
        for (entry, (ball, exactly)) in places.zip(member.stiffness.iter().zip(truth.entries())) {
            let off = near(&(ball.mid.exactly() - &exactly)).abs();
            assert!(off <= ball.rad, "{entry:?}: {off:e} of {:e}, {:e}: {case:?}", ball.rad, near(&exactly));
            self.share = self.share.max(off / ball.rad);
            if !is_beside_pole {
                let size = (member.sizes[entry.0] * member.sizes[entry.1]).sqrt();
                self.radius = self.radius.max(ball.rad / size);
            }
        }
    }
}

/// Random numbers.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn decade(&mut self, from: f64, to: f64) -> f64 {
        10f64.powf(from + (to - from) * self.next())
    }

    /// A beam of some regime. The second words of its parameters are not zero.
    fn case(&mut self, kind: usize) -> Case {
        let tail = |number: f64, random: &mut Self| [number, number * 1e-17 * random.next()];
        let shear = self.decade(-5.0, 0.0);
        let tension = self.decade(-1.0, 3.0);
        let [f, r, n, k] = match kind % 8 {
            0 => [shear, self.decade(-5.0, 0.0), 0.0, 0.0],
            1 => [0.0, 0.0, tension, self.decade(-1.0, 5.0)],
            2 => [0.0, self.decade(-5.0, -1.0), -tension, 0.0],
            3 => [shear, self.decade(-5.0, 0.0), -(0.9 / shear).min(tension), self.decade(-1.0, 5.0)],
            4 => [0.0, 0.0, -tension, self.decade(1.0, 5.0)],
            5 => [shear, 0.0, tension, 0.0],
            6 => [self.decade(-3.0, 0.0), self.decade(-3.0, 0.0), 0.0, self.decade(-1.0, 3.0)],
            _ => [shear, self.decade(-5.0, 0.0), tension, self.decade(-1.0, 5.0)],
        };
        let square = match kind % 5 {
            0 => -self.decade(-2.0, 4.0),
            1 if r * f > 0.0 => self.decade(0.0, 1.0) / (r * f),
            _ => self.decade(-2.0, 5.0),
        };
        let [bending, mass, length] = [self.decade(-0.5, 0.5), self.decade(-0.5, 0.5), self.decade(-0.3, 0.3)];
        let section = GeneralSection {
            bending_stiffness: tail(bending, self),
            mass_per_length: tail(mass, self),
            shear_flexibility: tail(f, self),
            rotary_inertia: tail(r, self),
            axial_force: tail(n, self),
            shear_layer: if kind % 3 == 0 { tail(0.3 * n.abs(), self) } else { [0.0; 2] },
            foundation_stiffness: tail(k, self),
        };
        Case { section, length, square }
    }
}

fn random_beams(seed: u64, count: usize) {
    let mut random = Random(seed);
    let mut seen = [Seen::default(), Seen::default()];
    for kind in 0..count {
        let case = random.case(kind);
        let truth = case.held();
        seen[0].look::<OneWord>(&case, &truth);
        seen[1].look::<TwoWords<f64>>(&case, &truth);
    }
    std::println!("{seen:#?}");
    assert!(seen[0].share < 1.0 && seen[1].share < 1.0);
    assert!(seen[1].unknown == 0 && seen[1].ranges == 0);
}

#[test]
fn a_few_random_beams() {
    random_beams(1, 60);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_random_beams() {
    random_beams(2, 20_000);
}

/// The number in two words.
fn words(number: &Exact) -> [f64; 2] {
    let hi = near(number);
    [hi, near(&(number - exact(hi)))]
}

/// Thick beams above the frequency of thickness shear whose two waves reach mπ and nπ together, within some 30 ulps of one word, or of two.
///
/// With `l = EI = ω = 1` and no axial force, `rω² = (m² - c (m² - n²))π²` and `fmω⁴ = (n² + c (m² - n²))π²` have the right sum, and
/// `mω² = c (1 - c) (m² - n²)²π⁴` the right product.
fn waves_that_meet(seed: u64, count: usize) -> [Seen; 2] {
    let mut random = Random(seed);
    let pi = HALF_PI.iter().fold(exact(0.0), |sum, part| sum + exact(*part)) * exact(2.0);
    let mut seen = [Seen::default(), Seen::default()];
    let pairs = [(2, 1), (3, 1), (3, 2), (4, 1), (4, 3), (5, 2)];
    for number in 0..count {
        let (long, short) = pairs[number % pairs.len()];
        let [long, short] = [long, short].map(|waves: i32| exact(f64::from(waves * waves)));
        let c = exact(0.05 + 0.9 * random.next());
        let (gap, square) = (&long - &short, &pi * &pi);
        let ulp = [53, 80, 106, 112][(number / pairs.len()) % 4];
        let mut moved = |number: Exact| {
            let moved = words(&(number * (exact(1.0) + exact((60.0 * random.next() - 30.0) * 0.5f64.powi(ulp)))));
            if ulp == 53 { [moved[0], 0.0] } else { moved }
        };
        let mass = &c * (exact(1.0) - &c) * &gap * &gap * &square * &square;
        let section = GeneralSection {
            bending_stiffness: [1.0, 0.0],
            shear_flexibility: moved((&short + &c * &gap) * &square / &mass),
            rotary_inertia: moved((&long - &c * &gap) * &square),
            mass_per_length: moved(mass),
            axial_force: [0.0; 2],
            shear_layer: [0.0; 2],
            foundation_stiffness: [0.0; 2],
        };
        let case = Case { section, length: 1.0, square: 1.0 };
        let truth = case.held();
        if ulp == 53 {
            seen[0].look::<OneWord>(&case, &truth);
        }
        seen[1].look::<TwoWords<f64>>(&case, &truth);
    }
    std::println!("{seen:#?}");
    seen
}

#[test]
fn counts_are_ranges_where_two_waves_are_undecided() {
    let [_, seen] = waves_that_meet(3, 96);
    assert!(seen.ranges > 0 && seen.share < 1.0);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_counts_where_two_waves_are_undecided() {
    let [_, seen] = waves_that_meet(4, 40_000);
    assert!(seen.ranges > 0 && seen.share < 1.0);
}

/// A beam without shear of this sum and product of both squared wave numbers.
fn of_waves(sum: f64, product: f64) -> Case {
    let (mass, foundation) =
        if product < 0.0 { (-product, [0.0; 2]) } else { (1.0, words(&(exact(1.0) + exact(product)))) };
    let section = GeneralSection {
        bending_stiffness: [1.0, 0.0],
        mass_per_length: [mass, 0.0],
        shear_flexibility: [0.0; 2],
        rotary_inertia: [0.0; 2],
        axial_force: [sum, 0.0],
        shear_layer: [0.0; 2],
        foundation_stiffness: foundation,
    };
    Case { section, length: 1.0, square: 1.0 }
}

/// Where one form ends and another one begins, where wave numbers meet or vanish, and where both do at a whole number of half waves.
#[test]
fn forms_meet() {
    let square = core::f64::consts::PI * core::f64::consts::PI;
    let mut seen = [Seen::default(), Seen::default()];
    let beside = |number: f64| [number * (1.0 - 2.0 * f64::EPSILON), number, number * (1.0 + 2.0 * f64::EPSILON)];
    let mut pairs = std::vec![(0.0, 0.0), (0.0, 5.0), (0.0, -5.0), (40.0, 0.0), (-40.0, 0.0), (-square, 0.0)];
    for sum in [2.0, -2.0, 1e-3, 5.0, -5.0, 40.0, -40.0, -2.0 * square, -8.0 * square] {
        // |s| = 2, |d| = 1, δ = 4d, δ = 0, d = 0
        for product in [1.0, -1.0, sum * sum / 8.0, sum * sum / 4.0, 1e-20, -1e-20] {
            pairs.extend(beside(product).map(|product| (sum, product)));
        }
    }
    for (sum, product) in pairs {
        let case = of_waves(sum, product);
        let truth = case.held();
        seen[0].look::<OneWord>(&case, &truth);
        seen[1].look::<TwoWords<f64>>(&case, &truth);
    }
    std::println!("{seen:#?}");
    assert!(seen[1].share < 1.0 && seen[1].unknown == 0);
}

/// Beside poles, at both of two numbers next to each other with the pole between them.
fn beside_poles(seed: u64, count: usize) {
    let mut random = Random(seed);
    let mut seen = Seen::default();
    let mut kind = 0;
    while (seen.cases as usize) < count {
        kind += 1;
        let case = random.case(kind);
        let [mut low, mut high] = [case.square, case.square + 3.0 * case.square.abs()];
        let at = |square: f64| Case { square, ..case }.held();
        let below = at(low).count;
        if at(high).count == below {
            continue;
        }
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if at(middle).count == below { low = middle } else { high = middle }
        }
        for square in [low, high] {
            let case = Case { square, ..case };
            assert!(case.at::<TwoWords<f64>>().is_beside_pole);
            seen.look::<TwoWords<f64>>(&case, &at(square));
        }
    }
    std::println!("{seen:#?}");
    assert!(seen.share < 1.0);
}

#[test]
fn poles_are_seen() {
    beside_poles(5, 2);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_poles_are_seen() {
    beside_poles(6, 400);
}

/// What is proven for a ball holds for each number in it.
#[test]
fn arguments_may_be_balls() {
    let mut random = Random(7);
    for kind in 0..40 {
        let mut case = random.case(kind);
        let [[length, length_bound], [square, square_bound]] =
            [case.length, case.square].map(|number: f64| [number, number.abs() * 1e-12]);
        let [length, square] =
            [(length, length_bound), (square, square_bound)].map(|(mid, rad)| Ball { mid: TwoWords::of(mid), rad });
        let General { member, .. } = general_bending(&case.section, length, square);
        case.length += (2.0 * random.next() - 1.0) * length_bound;
        case.square += (2.0 * random.next() - 1.0) * square_bound;
        let truth = case.held();
        for (ball, exactly) in member.stiffness.iter().zip(truth.entries()) {
            assert!(near(&(ball.mid.exactly() - exactly)).abs() <= ball.rad, "{case:?}");
        }
        let [least, most] = member.held;
        assert!((least..=most).contains(&f64::from(truth.count)));
    }
}

/// Four words at once.
#[derive(Clone, Copy, Debug)]
struct Four([f64; 4]);

impl Four {
    fn by(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Four(from_fn(|lane| of(self.0[lane], other.0[lane])))
    }
}

macro_rules! operators {
    ($($Trait:ident $name:ident),*) => {$(
        impl $Trait for Four {
            type Output = Self;
            fn $name(self, other: Self) -> Self {
                self.by(other, f64::$name)
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Four {
    type Output = Self;
    fn neg(self) -> Self {
        Four(self.0.map(|lane| -lane))
    }
}

impl Word for Four {
    type Mask = [bool; 4];
    const LANES: usize = 4;

    fn of(number: f64) -> Self {
        Four([number; 4])
    }

    fn load(numbers: &[f64]) -> Self {
        Four(from_fn(|lane| numbers[lane.min(numbers.len() - 1)]))
    }

    fn store(self, numbers: &mut [f64]) {
        numbers.iter_mut().zip(self.0).for_each(|(number, lane)| *number = lane);
    }

    fn size(self) -> Self {
        Four(self.0.map(Word::size))
    }

    fn root(self) -> Self {
        Four(self.0.map(Word::root))
    }

    fn power_of_two(self) -> Self {
        Four(self.0.map(Word::power_of_two))
    }

    fn is_less(self, other: Self) -> [bool; 4] {
        from_fn(|lane| self.0[lane] < other.0[lane])
    }

    fn vanishes(self) -> bool {
        self.0 == [0.0; 4]
    }

    fn select(truth: [bool; 4], first: Self, second: Self) -> Self {
        Four(from_fn(|lane| if truth[lane] { first.0[lane] } else { second.0[lane] }))
    }

    fn all(truth: [bool; 4]) -> bool {
        truth == [true; 4]
    }
}

/// Each lane is what it is alone, whatever forms the others have.
#[test]
fn lanes_do_not_see_each_other() {
    let mut random = Random(8);
    for kind in 0..120 {
        let case = random.case(kind);
        let squares: [f64; 4] = from_fn(|lane| case.square * [1.0, 1e-9, -1.0, 30.0][(lane + kind) % 4]);
        let together = general_bending::<TwoWords<Four>>(
            &case.section,
            Ball::of(case.length),
            Ball::exactly(TwoWords::of_word(Four(squares))),
        );
        for (lane, square) in squares.into_iter().enumerate() {
            let alone = Case { square, ..case }.at::<TwoWords<f64>>();
            assert_eq!(together.is_beside_pole[lane], alone.is_beside_pole);
            assert_eq!(together.member.held.map(|held| held.0[lane]), alone.member.held);
            for (ball, own) in together.member.stiffness.iter().zip(alone.member.stiffness) {
                let ball = [ball.mid.hi, ball.mid.lo, ball.rad].map(|words| words.0[lane].to_bits());
                assert_eq!(ball, [own.mid.hi, own.mid.lo, own.rad].map(f64::to_bits));
            }
        }
    }
}
