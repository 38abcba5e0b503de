"""`boxbeam reliability` beside OpenTURNS (Debian: python3-openturns), which is no part of CTest: index,
design point and importance by its FORM, p_f by its SORM and importance sampling, of studies that are
formulas.

Usage: reliability_openturns.py PROGRAM    with a Python that has openturns
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import openturns as ot

PROGRAM = sys.argv[1]


def normal(mean, sd):
    return ot.Normal(mean, sd), f'distribution = "normal"\nmean = {mean!r}\nsd = {sd!r}\n'


def lognormal(mean, sd):
    return (ot.ParametrizedDistribution(ot.LogNormalMuSigma(mean, sd, 0.0)),
            f'distribution = "lognormal"\nmean = {mean!r}\nsd = {sd!r}\n')


def gumbel(mean, sd):
    return (ot.ParametrizedDistribution(ot.GumbelMuSigma(mean, sd)),
            f'distribution = "gumbel"\nmean = {mean!r}\nsd = {sd!r}\n')


def weibull(mean, sd):
    return (ot.ParametrizedDistribution(ot.WeibullMinMuSigma(mean, sd, 0.0)),
            f'distribution = "weibull"\nmean = {mean!r}\nsd = {sd!r}\n')


# Name, variables, correlation of the first two, limit state.
CASES = [
    ("resistance less load", [("r", normal(4.0, 1.0)), ("s", normal(2.0, 1.0))], 0.5, "r - s"),
    ("axial rod", [("f", lognormal(300.0, 30.0)), ("n", normal(75e3, 5e3))], 0.0, "f - n/314.1592653589793"),
    ("frame (RP8)", [(f"a{i}", lognormal(120.0, 12.0)) for i in range(4)] +
     [("p", lognormal(50.0, 10.0)), ("q", lognormal(40.0, 8.0))], 0.0, "a0 + 2*a1 + 2*a2 + a3 - 5*p - 5*q"),
    ("cantilever under wind", [("w", gumbel(2.0, 0.5)), ("q", gumbel(3.0, 0.4)), ("f", lognormal(390.0, 27.3)),
                               ("k", weibull(1.0, 0.08))], 0.4, "f*k - 20*w - 45*q"),
    ("fatigue", [("d", lognormal(1.0, 0.3)), ("k", lognormal(1.0, 0.73)), ("b", lognormal(1.0, 0.25))], 0.0,
     "20*d*k - b^3"),
]


def by_openturns(variables, rho, formula):
    correlation = ot.CorrelationMatrix(len(variables))
    if rho:
        first, second = (of[0].getDistribution() if hasattr(of[0], "getDistribution") else of[0]
                         for _, of in variables[:2])
        # The correlation of the normal variables behind: as the program, by its own Nataf model.
        correlation[0, 1] = nataf(first, second, rho)
    joint = ot.ComposedDistribution([of[0] for _, of in variables], ot.NormalCopula(correlation))
    function = ot.SymbolicFunction([name for name, _ in variables], [formula])
    vector = ot.CompositeRandomVector(function, ot.RandomVector(joint))
    event = ot.ThresholdEvent(vector, ot.Less(), 0.0)
    solver = ot.AbdoRackwitz()
    solver.setMaximumIterationNumber(1000)
    for tolerance in (solver.setMaximumAbsoluteError, solver.setMaximumRelativeError,
                      solver.setMaximumResidualError, solver.setMaximumConstraintError):
        tolerance(1e-10)
    form = ot.FORM(solver, event, joint.getMean())
    form.run()
    sorm = ot.SORM(solver, event, joint.getMean())
    sorm.run()
    point = form.getResult().getStandardSpaceDesignPoint()
    ot.RandomGenerator.SetSeed(1)
    sampling = ot.ProbabilitySimulationAlgorithm(
        ot.StandardEvent(event), ot.ImportanceSamplingExperiment(ot.Normal(point, ot.CovarianceMatrix(len(point)))))
    sampling.setMaximumCoefficientOfVariation(0.01)
    sampling.setMaximumOuterSampling(200000)
    sampling.run()
    result = form.getResult()
    return (result.getHasoferReliabilityIndex(), list(result.getPhysicalSpaceDesignPoint()),
            sorm.getResult().getEventProbabilityBreitung(),
            sorm.getResult().getEventProbabilityHohenbichler(),
            sampling.getResult().getProbabilityEstimate())


def nataf(first, second, rho):
    """By bisection on the correlation of the pair, integrated by a Gauss-Hermite rule."""
    nodes, weights = ot.GaussProductExperiment(ot.Normal(2), [40, 40]).generateWithWeights()

    def of(z):
        root = (1 - z * z) ** 0.5
        total = 0.0
        for (a, b), weight in zip(nodes, weights):
            x = first.computeQuantile(ot.DistFunc.pNormal(a))[0]
            y = second.computeQuantile(ot.DistFunc.pNormal(z * a + root * b))[0]
            total += weight * (x - first.getMean()[0]) * (y - second.getMean()[0])
        return total / (first.getStandardDeviation()[0] * second.getStandardDeviation()[0])

    low, high = -0.999, 0.999
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if of(middle) < rho else (low, middle)
    return 0.5 * (low + high)


def by_boxbeam(folder, variables, rho, formula):
    text = '[study]\nseed = 1\nsamples = 1000000\n'
    for name, (_, written) in variables:
        text += f"[variables.{name}]\n{written}"
    if rho:
        text += f'[correlation]\n"{variables[0][0]},{variables[1][0]}" = {rho}\n'
    text += f'[limit_state]\nexpression = "{formula}"\n[reliability]\n'
    text += 'methods = ["form", "sorm", "importance"]\nvariation = 0.01\n'
    study = folder / "study.toml"
    study.write_text(text)
    done = subprocess.run([PROGRAM, "reliability", study, "--out", folder / "out", "--json", "-"],
                          capture_output=True, check=True)
    methods = json.loads(done.stdout)["methods"]
    point = [at["value"] for at in methods["form"]["design_points"][0]["variables"]]
    return (methods["form"]["beta"], point, methods["sorm"]["p_f_breitung"], methods["sorm"]["p_f"],
            methods["importance"]["p_f"])


def main():
    failures = 0
    print("| limit state | beta | apart | design point apart | p_f by Breitung apart | by Hohenbichler, Rackwitz | "
          "by importance sampling |\n|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        for case, variables, rho, formula in CASES:
            ours = by_boxbeam(pathlib.Path(name), variables, rho, formula)
            theirs = by_openturns(variables, rho, formula)
            beta = abs(ours[0] - theirs[0])
            point = max(abs(a / b - 1) for a, b in zip(ours[1], theirs[1]))
            shares = [abs(a / b - 1) for a, b in zip(ours[2:], theirs[2:])]
            print(f"| {case} | {ours[0]:.6f} | {beta:.1g} | {point:.1g} | {shares[0]:.1g} | {shares[1]:.1g} | "
                  f"{100 * shares[2]:.1f} % |")
            good = beta < 1e-5 and point < 1e-3 and max(shares[:2]) < 1e-3 and shares[2] < 0.06
            failures += not good
    print(f"{failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
