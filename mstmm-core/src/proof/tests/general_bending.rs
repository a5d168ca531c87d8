//! General beams against pieces in many digits: nothing is outside of its ball, and no count outside of its bounds.

use crate::element::BeamNumbers;
use crate::number::constants::HALF_PI;
use crate::proof::ball::Ball;
use crate::proof::general_bending::{General, general_bending};
use crate::proof::level::Level;
use crate::proof::number::{Number, OneWord, TwoWords};
use crate::proof::tests::lanes::Four;
use core::array::from_fn;
use pieces::{Case, Exact, Held, exact, near};

mod pieces;

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
        let section = BeamNumbers {
            bending_stiffness: tail(bending, self),
            mass_per_length: tail(mass, self),
            shear_stiffness: if f > 0.0 { tail(1.0 / f, self) } else { [0.0; 2] },
            rotary_inertia: tail(r, self),
            axial_force: tail(n, self),
            shear_layer: if kind.is_multiple_of(3) { tail(0.3 * n.abs(), self) } else { [0.0; 2] },
            foundation_stiffness: tail(k, self),
            ..BeamNumbers::default()
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
    assert!(seen[1].unknown == 0 && seen[1].ranges == 0 && seen[1].radius < 1e-20);
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
/// With `l = EI = ω = 1` and no axial force, `rω² = (m² - c (m² - n²))π²` and `mω⁴/kGA = (n² + c (m² - n²))π²` have the right sum, and
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
        let section = BeamNumbers {
            bending_stiffness: [1.0, 0.0],
            shear_stiffness: moved(&mass / ((&short + &c * &gap) * &square)),
            rotary_inertia: moved((&long - &c * &gap) * &square),
            mass_per_length: moved(mass),
            axial_force: [0.0; 2],
            shear_layer: [0.0; 2],
            foundation_stiffness: [0.0; 2],
            ..BeamNumbers::default()
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
    let section = BeamNumbers {
        bending_stiffness: [1.0, 0.0],
        mass_per_length: [mass, 0.0],
        shear_stiffness: [0.0; 2],
        rotary_inertia: [0.0; 2],
        axial_force: [sum, 0.0],
        shear_layer: [0.0; 2],
        foundation_stiffness: foundation,
        ..BeamNumbers::default()
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
        let General { member, .. } = general_bending(&case.section, length, square, None);
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
            None,
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
