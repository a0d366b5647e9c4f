"""The lightest walls of a mast, what they cost, and whether the mast also stands what the task did not ask."""

import kinetruss as kt

file, task, *_ = kt.library.example_files()["mast_design"]
found = kt.design.optimise(None, task)
print(found)
assert found.certificate.first_order
assert f"{found.objective:.1f}" == "98.7"  # kg

# the check of all rules, beam-columns too, at more instants than the task asks
deploy = found.model.runs["deploy"].with_(samples=61)
still = kt.Run(analysis="statics.linear", load_cases=["x", "y"])
checked = found.model.with_(runs={"deploy": deploy, "still": still})
for name, when in (("deploy", "while it is raised"), ("still", "deployed")):
    run = kt.run(checked, name)
    worst = run.verdict.table()[0]
    print(f"{when} {worst.part} governs, {100 * worst.utilisation:.1f} % of {worst.rule} in {worst.load_case}")
    assert not run.finding.over

# buckling of the whole: with elastic bars, of the weight of the antenna alone
elastic = found.model.with_(
    bars={name: bar.with_(kind="elastic") for name, bar in found.model.bars.items()},
    loads={**found.model.loads, "antenna": kt.NodalForce(node="B6.N8", force=(0, 0, -12 * 9.81))},
    load_cases={**found.model.load_cases, "alone": kt.LoadCase(loads={})},
)
factor = kt.statics.buckling(elastic, "antenna", load_case="alone")
assert factor.load_factor.values[0] > 100
print(f"the mast as a whole buckles at {factor.load_factor.values[0]:.0f} times the weight of the antenna")
