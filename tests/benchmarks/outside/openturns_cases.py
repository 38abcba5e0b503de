"""`boxbeam reliability` and `boxbeam sweep` beside OpenTURNS (PyPI: openturns; Debian: python3-openturns), which is no
part of CTest: index, design point and p_f of limit states by its FORM, SORM, importance sampling and Monte Carlo; the
correlation behind every pair of distributions (Nataf); Sobol's indices. All studies are formulas.

Usage: openturns_cases.py PROGRAM    with a Python that has openturns
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import openturns as ot

PROGRAM = sys.argv[1]
# Its name was another until 1.24.
JointDistribution = getattr(ot, "JointDistribution", None) or ot.ComposedDistribution
failures = 0


def check(holds):
    global failures
    failures += not holds
    return "" if holds else "  <- FAILED"


def written(kind, mean, sd):
    return f'distribution = "{kind}"\nmean = {mean!r}\nsd = {sd!r}\n'


def by_parameters(parameters):
    return ot.Distribution(ot.ParametrizedDistribution(parameters))


# Each the distribution by OpenTURNS and as a study has it, from mean and standard deviation.
def normal(mean, sd):
    return ot.Normal(mean, sd), written("normal", mean, sd)


def lognormal(mean, sd):
    return by_parameters(ot.LogNormalMuSigma(mean, sd, 0.0)), written("lognormal", mean, sd)


def gumbel(mean, sd):
    return by_parameters(ot.GumbelMuSigma(mean, sd)), written("gumbel", mean, sd)


def weibull(mean, sd):
    return by_parameters(ot.WeibullMinMuSigma(mean, sd, 0.0)), written("weibull", mean, sd)


def uniform(mean, sd):
    half = 3 ** 0.5 * sd
    return ot.Uniform(mean - half, mean + half), written("uniform", mean, sd)


def exponential(mean, sd):
    assert mean == sd
    return ot.Exponential(1.0 / mean), f'distribution = "exponential"\nmean = {mean!r}\n'


def standard(count):
    return [(f"x{i}", normal(0.0, 1.0)) for i in range(1, count + 1)]


# Name, variables, correlation of the first two, limit state; of one design point, which FORM finds from the mean.
POINTS = [
    ("resistance less load, correlated", [("r", normal(4.0, 1.0)), ("s", normal(2.0, 1.0))], 0.5, "r - s"),
    ("axial rod", [("f", lognormal(300.0, 30.0)), ("n", normal(75e3, 5e3))], 0.0, "f - n/314.1592653589793"),
    ("box under a lognormal load", [("f", lognormal(390.0, 27.3)), ("p", lognormal(140e3, 21e3))], 0.0,
     "f - 0.0015*p"),
    ("frame of six lognormal variables (RP8)",
     [(f"a{i}", lognormal(120.0, 12.0)) for i in range(4)] + [("p", lognormal(50.0, 10.0)), ("q", lognormal(40.0, 8.0))],
     0.0, "a0 + 2*a1 + 2*a2 + a3 - 5*p - 5*q"),
    ("Gumbel loads, correlated, lognormal and Weibull resistance",
     [("w", gumbel(2.0, 0.5)), ("q", gumbel(3.0, 0.4)), ("f", lognormal(390.0, 27.3)), ("k", weibull(1.0, 0.08))], 0.4,
     "f*k - 20*w - 45*q"),
    ("fatigue in Wirsching's format",
     [("d", lognormal(1.0, 0.3)), ("k", lognormal(1.0, 0.73)), ("b", lognormal(1.0, 0.25))], 0.0, "20*d*k - b^3"),
    ("sum of ten (RP107)", standard(10), 0.0, "15.811388300841896 - (x1+x2+x3+x4+x5+x6+x7+x8+x9+x10)"),
    ("curved (RP22)", standard(2), 0.0, "2.5 - (x1+x2)/1.4142135623730951 + 0.1*(x1-x2)^2"),
]
# Several design points, or none that tells: p_f alone.
SEVERAL = [
    ("product (RP75)", standard(2), "3 - x1*x2"),
    ("four branches", standard(2),
     "min(3 + 0.1*(x1-x2)^2 - (x1+x2)/1.4142135623730951, 3 + 0.1*(x1-x2)^2 + (x1+x2)/1.4142135623730951, "
     "x1 - x2 + 4.949747468305833, x2 - x1 + 4.949747468305833)"),
    ("two branches (RP89)", standard(2), "min(8 - x1^2 - x2, 6 - x1/5 - x2)"),
]
# Of each kind one, of unlike skewness.
KINDS = {"normal": normal(5.0, 1.0), "lognormal": lognormal(5.0, 2.0), "uniform": uniform(5.0, 1.5),
         "weibull": weibull(5.0, 2.5), "gumbel": gumbel(5.0, 1.5), "exponential": exponential(5.0, 5.0)}


def value_at(distribution, z):
    """By the nearer tail, so that no share is rounded to 1."""
    return distribution.computeQuantile(ot.DistFunc.pNormal(-abs(z)), z > 0.0)[0]


def nataf(first, second, rho):
    """By bisection on the correlation of the pair of normal variables, integrated by a Gauss-Hermite rule."""
    nodes, weights = ot.GaussProductExperiment(ot.Normal(2), [40, 40]).generateWithWeights()

    def of(z):
        root = (1 - z * z) ** 0.5
        total = 0.0
        for (a, b), weight in zip(nodes, weights):
            x, y = value_at(first, a), value_at(second, z * a + root * b)
            total += weight * (x - first.getMean()[0]) * (y - second.getMean()[0])
        return total / (first.getStandardDeviation()[0] * second.getStandardDeviation()[0])

    # Secant steps: the function is close to a straight line.
    low, high, at_low, at_high = 0.0, rho, 0.0, of(rho)
    for _ in range(12):
        new = high + (rho - at_high) * (high - low) / (at_high - at_low)
        low, high, at_low, at_high = high, new, at_high, of(new)
        if abs(at_high - rho) < 1e-13 or high == low:
            break
    return high


def event_of(variables, rho, formula):
    """Failure where the formula is below zero."""
    correlation = ot.CorrelationMatrix(len(variables))
    if rho:
        correlation[0, 1] = nataf(variables[0][1][0], variables[1][1][0], rho)
    joint = JointDistribution([of[0] for _, of in variables], ot.NormalCopula(correlation))
    function = ot.SymbolicFunction([name for name, _ in variables], [formula])
    vector = ot.CompositeRandomVector(function, ot.RandomVector(joint))
    return joint, ot.ThresholdEvent(vector, ot.Less(), 0.0)


def nearest_point(method, joint, event):
    solver = ot.AbdoRackwitz()
    getattr(solver, "setMaximumIterationNumber")(1000)
    for tolerance in (solver.setMaximumAbsoluteError, solver.setMaximumRelativeError, solver.setMaximumResidualError,
                      solver.setMaximumConstraintError):
        tolerance(1e-10)
    try:  # since 1.24 the solver holds the start
        solver.setStartingPoint(joint.getMean())
        algorithm = method(solver, event)
    except TypeError:
        algorithm = method(solver, event, joint.getMean())
    algorithm.run()
    return algorithm.getResult()


def sampled(event, experiment, variation):
    ot.RandomGenerator.SetSeed(1)
    algorithm = ot.ProbabilitySimulationAlgorithm(event, experiment)
    algorithm.setMaximumCoefficientOfVariation(variation)
    algorithm.setBlockSize(10_000)
    algorithm.setMaximumOuterSampling(1000)
    algorithm.run()
    result = algorithm.getResult()
    return result.getProbabilityEstimate(), result.getCoefficientOfVariation()


def study_of(variables, rho, seed_and_samples):
    text = f"[study]\n{seed_and_samples}"
    for name, (_, of) in variables:
        text += f"[variables.{name}]\n{of}"
    if rho:
        text += f'[correlation]\n"{variables[0][0]},{variables[1][0]}" = {rho}\n'
    return text


def run(command, folder, text):
    study = folder / "study.toml"
    study.write_text(text)
    done = subprocess.run([PROGRAM, command, study, "--out", folder / "out", "--quiet", "--json", "-"],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise SystemExit(f"{text}\n{done.stderr}")
    return json.loads(done.stdout)


def methods_of(folder, variables, rho, formula, methods):
    return run("reliability", folder, study_of(variables, rho, "seed = 1\nsamples = 1000000\n") +
               f'[limit_state]\nexpression = "{formula}"\n[reliability]\nmethods = {json.dumps(methods)}\n'
               "variation = 0.01\n")["methods"]


def compare_points(folder):
    print("| limit state | beta | beta apart | design point apart | p_f by Breitung apart | by Hohenbichler, Rackwitz | "
          "by importance sampling |\n|---|---|---|---|---|---|---|")
    for case, variables, rho, formula in POINTS:
        ours = methods_of(folder, variables, rho, formula, ["form", "sorm", "importance"])
        joint, event = event_of(variables, rho, formula)
        form = nearest_point(ot.FORM, joint, event)
        sorm = nearest_point(ot.SORM, joint, event)
        at = form.getStandardSpaceDesignPoint()
        weighted, _ = sampled(ot.StandardEvent(event), ot.ImportanceSamplingExperiment(
            ot.Normal(at, ot.CovarianceMatrix(len(at)))), 0.01)
        beta = abs(ours["form"]["beta"] - form.getHasoferReliabilityIndex())
        scales = [of[0].getStandardDeviation()[0] for _, of in variables]
        point = max(abs(a["value"] - b) / scale for a, b, scale in
                    zip(ours["form"]["design_points"][0]["variables"], form.getPhysicalSpaceDesignPoint(), scales))
        shares = [abs(a / b - 1) for a, b in (
            (ours["sorm"]["p_f_breitung"], sorm.getEventProbabilityBreitung()),
            (ours["sorm"]["p_f"], sorm.getEventProbabilityHohenbichler()), (ours["importance"]["p_f"], weighted))]
        # Both samplings have a coefficient of variation of 1 %.
        good = beta < 1e-5 and point < 1e-3 and max(shares[:2]) < 1e-3 and shares[2] < 4 * 2 ** 0.5 * 0.01
        print(f"| {case} | {ours['form']['beta']:.6f} | {beta:.1g} | {point:.1g} | {shares[0]:.1g} | {shares[1]:.1g} | "
              f"{100 * shares[2]:.1f} % |{check(good)}", flush=True)


def compare_several(folder):
    print("\n| limit state | p_f by importance sampling | by subset simulation | OpenTURNS, Monte Carlo | apart, in "
          "standard deviations |\n|---|---|---|---|---|")
    for case, variables, formula in SEVERAL:
        ours = methods_of(folder, variables, 0.0, formula, ["importance", "subset"])
        _, event = event_of(variables, 0.0, formula)
        p_f, variation = sampled(event, ot.MonteCarloExperiment(), 0.01)
        apart = [(ours[name]["p_f"] / p_f - 1) / math.hypot(ours[name]["cov"], variation)
                 for name in ("importance", "subset")]
        print(f"| {case} | {ours['importance']['p_f']:.5g} | {ours['subset']['p_f']:.5g} | {p_f:.5g} | "
              f"{apart[0]:.1f}, {apart[1]:.1f} |{check(max(map(abs, apart)) < 4)}", flush=True)


def compare_nataf(folder):
    """The index of a sum of two correlated variables: it moves with the correlation behind them."""
    print("\n| correlated 0.4 | correlation of the normal variables behind | beta of their sum | apart |\n|---|---|---|---|")
    names = list(KINDS)
    for i, first in enumerate(names):
        for second in names[i:]:
            variables = [("a", KINDS[first]), ("b", KINDS[second])]
            limit = sum(of[0].getMean()[0] + 1.2 * of[0].getStandardDeviation()[0] for _, of in variables)
            formula = f"{limit!r} - a - b"
            ours = methods_of(folder, variables, 0.4, formula, ["form"])["form"]["beta"]
            joint, event = event_of(variables, 0.4, formula)
            theirs = nearest_point(ot.FORM, joint, event).getHasoferReliabilityIndex()
            behind = nataf(variables[0][1][0], variables[1][1][0], 0.4)
            print(f"| {first}, {second} | {behind:.6f} | {ours:.6f} | {abs(ours - theirs):.1g} |"
                  f"{check(abs(ours - theirs) < 1e-6)}", flush=True)


# Name, variables, formula, exact S1 and ST: Saltelli and others, Global Sensitivity Analysis (2008).
INDICES = [
    ("Ishigami", [(f"x{i}", -math.pi, math.pi) for i in (1, 2, 3)], "sin(x1) + 7*sin(x2)^2 + 0.1*x3^4*sin(x1)",
     (0.3139052, 0.4424111, 0.0), (0.5575889, 0.4424111, 0.2436837)),
    ("g, a = 0, 9, 99", [(f"x{i}", 0.0, 1.0) for i in (1, 2, 3)],
     "abs(4*x1-2) * (abs(4*x2-2)+9)/10 * (abs(4*x3-2)+99)/100",
     (0.9867118, 0.0098671, 0.0000987), (0.9900339, 0.0131566, 0.0001320)),
]


def compare_indices(folder):
    samples = 4096
    print("\n| indices | of | boxbeam | its bounds | OpenTURNS | exact |\n|---|---|---|---|---|---|")
    for case, variables, formula, *exact in INDICES:
        text = f'[study]\nseed = 3\nsamples = {samples}\nsampling = "sobol"\n'
        for name, low, high in variables:
            text += f'[variables.{name}]\ndistribution = "uniform"\nmin = {low!r}\nmax = {high!r}\n'
        text += f'[results]\ncolumns = ["f = {formula}"]\n[indices]\n'
        ours = run("sweep", folder, text)["indices"][0]["variables"]
        joint = JointDistribution([ot.Uniform(low, high) for _, low, high in variables])
        function = ot.SymbolicFunction([name for name, _, _ in variables], [formula])
        ot.RandomGenerator.SetSeed(1)
        theirs = ot.SaltelliSensitivityAlgorithm(joint, 4 * samples, function, False)
        found = (theirs.getFirstOrderIndices(), theirs.getTotalOrderIndices())
        for name, mine, their, right in zip(("S1", "ST"), ("S1", "ST"), found, exact):
            for at, other, value in zip(ours, their, right):
                low, high = at[f"{mine}_low"], at[f"{mine}_high"]
                # Bounds hold the exact value; theirs, by other points, has errors of its own.
                good = low - 0.002 <= value <= high + 0.002 and abs(at[mine] - other) < (high - low) + 0.02
                print(f"| {case} | {name} {at['variable']} | {at[mine]:.4f} | {low:.4f} to {high:.4f} | {other:.4f} | "
                      f"{value:.4f} |{check(good)}", flush=True)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        print(f"OpenTURNS {ot.__version__}\n")
        for compare in (compare_points, compare_several, compare_nataf, compare_indices):
            compare(folder)
    print(f"{failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
