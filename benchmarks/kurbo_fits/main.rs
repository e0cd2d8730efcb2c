//! kurbo's two fits of one curve, for `benchmarks/kurbo.py`: `kurbo_fits CURVE LOW HIGH TOLERANCE`.
//!
//! For each fit a line "NAME MICROSECONDS COUNT", then a line of eight coordinates for each cubic.

use kurbo::{
    fit_to_bezpath, fit_to_bezpath_opt, BezPath, CurveFitSample, ParamCurveFit, PathSeg, Point, Vec2,
};
use std::{env, ops::Range, time::Instant};

/// So long is a fit repeated, in seconds; the fastest counts.
const ENOUGH: f64 = 0.3;

/// A curve on an interval, which the fits call [0, 1].
struct Curve {
    function: fn(f64) -> (Point, Vec2),
    low: f64,
    size: f64,
}

impl ParamCurveFit for Curve {
    fn sample_pt_deriv(&self, part: f64) -> (Point, Vec2) {
        let (point, rate) = (self.function)(self.low + self.size * part);
        (point, rate * self.size)
    }

    fn sample_pt_tangent(&self, part: f64, _sign: f64) -> CurveFitSample {
        let (p, tangent) = self.sample_pt_deriv(part);
        CurveFitSample { p, tangent }
    }

    fn break_cusp(&self, _range: Range<f64>) -> Option<f64> {
        None
    }
}

fn spiral(t: f64) -> (Point, Vec2) {
    let (s, c) = t.sin_cos();
    (Point::new(t * c, t * s), Vec2::new(c - t * s, s + t * c))
}

fn exponential(t: f64) -> (Point, Vec2) {
    (Point::new(t, t.exp()), Vec2::new(1.0, t.exp()))
}

fn sine(t: f64) -> (Point, Vec2) {
    (Point::new(t, t.sin()), Vec2::new(1.0, t.cos()))
}

fn catenary(t: f64) -> (Point, Vec2) {
    (Point::new(t, t.cosh()), Vec2::new(1.0, t.sinh()))
}

fn report(name: &str, fit: impl Fn() -> BezPath) {
    let path = fit();
    let (began, mut least) = (Instant::now(), f64::INFINITY);
    while began.elapsed().as_secs_f64() < ENOUGH {
        let before = Instant::now();
        std::hint::black_box(fit());
        least = least.min(before.elapsed().as_secs_f64());
    }
    let microseconds = 1e6 * least;
    println!("{name} {microseconds} {}", path.segments().count());
    for segment in path.segments() {
        let cubic = match segment {
            PathSeg::Cubic(cubic) => cubic,
            other => other.to_cubic(),
        };
        let points = [cubic.p0, cubic.p1, cubic.p2, cubic.p3];
        let numbers: Vec<String> = points.iter().map(|p| format!("{:e} {:e}", p.x, p.y)).collect();
        println!("{}", numbers.join(" "));
    }
}

fn main() {
    let words: Vec<String> = env::args().skip(1).collect();
    let number = |i: usize| words[i].parse::<f64>().expect("a number");
    let function = match words[0].as_str() {
        "spiral" => spiral,
        "exponential" => exponential,
        "sine" => sine,
        "catenary" => catenary,
        other => panic!("no curve is called {other}"),
    };
    let curve = Curve { function, low: number(1), size: number(2) - number(1) };
    let tolerance = number(3);
    report("plain", || fit_to_bezpath(&curve, tolerance));
    report("opt", || fit_to_bezpath_opt(&curve, tolerance));
}
