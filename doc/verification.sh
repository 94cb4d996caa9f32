#!/usr/bin/env bash
# Runs the verification tests on one rank and writes what they measured to doc/verification.md.
#   doc/verification.sh BUILD-FOLDER      for instance build/release
set -euo pipefail
build="${1:?usage: doc/verification.sh BUILD-FOLDER}/test/verification"
out="$(dirname "${BASH_SOURCE[0]}")/verification.md"
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1

section() {  # title, text, test and its arguments
  printf '\n## %s\n\n%s\n\n```\n' "$1" "$2"
  local start=$SECONDS log
  log="$("$build/$3" "${@:4}")" || { printf '%s\n' "$log" >&2; return 1; }
  grep -vE '^(\[|Note|Running main|$)' <<<"$log" | sed 's/  rate nan/  rate -/' || true
  printf '```\n\nRun time of `%s`: %d s on one core.\n' "$3" "$((SECONDS - start))"
}

{
  printf '# Verification\n\nMeasured by `doc/verification.sh build/release` against the reference results in `test/data`; each row is also a test.\n'
  printf 'Errors are relative; a rate is the exponent of the error over the element size.\n'
  section "Sleeves on bodies of revolution" \
    "Root mean square of the pressure against the semi-analytic membrane solution, an eighth of the rows at each end left out; sum of all forces over their magnitudes; largest gap in contact." \
    contact_reference_test
  section "Elliptic cylinder" \
    "The same with pressures that range over 4 : 1; independence of the contact stiffness; the body as unstructured triangles of 5 mm, the garment not aligned with them." \
    contact_ellipse_test
  section "Pressure on any mesh" \
    "Eight kinds of mesh: aligned with the body, a square lattice turned by 30 degrees, nodes moved by 25 %, free triangles, free quadrilaterals, both beside each other (mixed), and each with sizes 1 : 3; on cylinder, ellipse and ellipsoid, three fabrics. Root mean square over all nodes, rate from 8 mm, largest error away from the ends (in brackets that of nodal force over area), sum of pressure times area, and the effectivity of pressure_error: its root mean square over that of the error, and the part of the nodes that twice of it covers." \
    contact_meshes_test
  section "Pressure where more happens" \
    "Free meshes of 4 mm: lift-off at a waist, wrinkles, a body of unstructured triangles of 5 mm, shells on their inner face, two fabrics side by side." \
    contact_variety_test
  section "Layers" \
    "Tubes, one over the other, on a cylinder (input/benchmarks/layers.xml): pressure of each of four and their sum against sum T_i/(R + (i - 1/2) t) with the present thickness, in brackets; two to four on free meshes of 4 mm and thick ones, at a level and at a place of the body, with the error that is told there; per area of the skin, sum T_i/R; and what four would press if all lay on the skin." \
    layers_test
  section "Pressure along lines" \
    "Lines on the body of a settled sleeve (list Lines): a helix on a cylinder, the shortest way between two places of a cone and an oblique cut of it. Their lengths against those on the developed surface and the perimeter of the ellipse; the pressure at 41 to 73 places along them, which no line of the mesh follows, against the semi-analytic membrane solution, and that error over the told one." \
    pressure_along_line_test
  section "The shipped leg" \
    "Mean pressure at the hosiery levels over three meshes, of which the last is the shipped one (in brackets what pressure_error says), against a spectral solution that was computed without Toile (test/data/contact/leg_reference.py)." \
    leg_reference_test
  section "Lift-off at a waist" "Where the sleeve leaves the body (reference in brackets), its radius in the middle, and the pressure two elements away from lift-off." \
    contact_waist_test
  section "Real body and parametric leg" "Pressure noise at facet wavelength on the thigh of a body of a real shape, below the mean edge length there, with cell, smoothing and reach chosen by the program; and the balance of the written field." \
    contact_leg_test
  section "Cook's membrane" "Uniform meshes converge with the rate of the corner's singularity (1.248), graded ones with second order." plane_cook_test
  section "Clamped strips" "Uniform meshes and meshes graded to the corners, wale at 0, 45 and 90 degrees to the pull." plane_strip_test
  section "Plane stress on free meshes" "Cook's membrane (published deflection) and a clamped strip on free triangles, free quadrilaterals, and both in one panel. Elements of one size have the rate of the corner's singularity (1.248) at least, those that shrink at the corners with the power 1.75 of the size have second order." plane_free_test
  section "Tension field in shear" "A wide clamped strip of neo-Hookean fabric in shear, relaxed energy against the semi-analytic tension field (test/data/plane_stress/tension_field_shear_nh.csv)." \
    ../material/material_tests --gtest_filter=TensionField.sheared_strip
  section "Annulus in torsion" "Tension field of a sheet whose hub is turned in its plane (input/benchmarks/annulus-torsion.xml): torque of the relaxed and of the unwrinkled sheet against an axisymmetric solution, rates, how far the wrinkles reach, straight lines of tension, and the closed form of Stein and Hedgepeth (1961) at small angles." annulus_torsion_test
  section "Partly wrinkled strip in bending" "A strip of tension field under a pull P and a moment M, which is slack over the share b/h of its height (input/benchmarks/bent-strip.xml): against the closed form of Stein and Hedgepeth (1961) in brackets, and how little it depends on the steps of the load and on the residual stiffness. The curvature follows an error of the moment three times (M = 0.3 P h) and eight times (0.4 P h)." bent_strip_test
  section "Shells in large rotations" "Scenes of input/benchmarks against Sze, Liu and Lo (2004): S4R elements on the same meshes." shell_benchmark_test
  section "Shells on free meshes" "Cantilever 3.1 against the inextensible elastica, thin and very thin, and hemisphere 3.4 against Sze, Liu and Lo (2004), on free triangles, free quadrilaterals (reduced integration), and both in one panel." shell_free_test
  section "Cantilever under its own weight" "A strip of fabric, clamped level (input/benchmarks/cantilever-weight.xml), against the inextensible elastica (test/data/shell/heavy_cantilever.py; in brackets): angle of the line from clamp to tip, and the tip." heavy_cantilever_test
  section "Sleeve of shells on its inner face" "Pressure away from ends and seam against that of a plane-stress shell, 0.72967 kPa; the tube of finite thickness has 0.73131 kPa: the model's error is -0.22 %." shell_sleeve_test
  section "Inflated membrane" "Height of the pole of a clamped circular membrane under follower pressure." inflation_test
  section "Mylar balloon" "Two discs of foil, joined at their rims and inflated: a tension field that is as good as inextensible (input/benchmarks/mylar-balloon.xml) against the closed form (Paulsen 1994; Mladenov and Oprea 2003) in brackets. The error of the volume is that of the facets." mylar_balloon_test
  section "Wrinkles of a sheared foil" "Kapton foil, stretched, then sheared (input/benchmarks/kapton-shear.xml): half-wave across the crests and amplitude at mid height, away from the free sides, against the formulae of Wong and Pellegrino (2006) in brackets; accepted are 10 % (8 % from a shear of 2 mm on) and 10 %. The last lines: another imperfection." kapton_shear_test
  section "Wrinkles of a stretched sheet" "Clamped neo-Hookean sheet, 140 mm wide and 0.14 mm thick (input/benchmarks/stretched-sheet.xml): the wrinkles rise, fall and vanish with the stretch at L/W = 2, and there are none at L/W = 1.5 (Nayyar, Ravi-Chandar and Huang 2011; Li and Healey 2016)." stretched_sheet_test
  section "Drape of cotton and silk" "Fabrics on Cusick's drapemeter (input/benchmarks/drape-cotton.xml, drape-silk.xml). No fabric is known to us with its weight, bending, shear and drape coefficient all measured, so the reference is a band of the kind of fabric: near 0.7 (here 0.6 to 0.8) for stiff cotton, 0.2 to 0.4 for silk, 3 to 8 folds. A fabric may have several stable states; these are the ones into which the weight takes it little by little, the lowest in energy of all that were found on one mesh. Silk has 0.38, 0.37 and 0.38 with elements of 6, 5 and 4 mm. Given are constants from the ranges of Kawabata's tests, bending B in gf cm^2/cm and shear G in gf/(cm degree): the stiff end of cottons (B = 0.3, G = 2, 200 g/m^2; of 0.1 to 0.3, 0.3 to 2, 150 to 250) and the soft end of silks (0.02, 0.3, 60; of 0.02 to 0.05, 0.3 and more, 50 to 80). Elsewhere in these ranges cotton has 0.37 (0.1, 0.3, 250) to 0.73 (0.3, 2, 150), silk 0.35 (0.02, 0.3, 80), 0.44 (0.03, 0.4, 60) and 0.57 (0.05, 0.4, 50): from the middle of its range on silk drapes less here than the band says. In the model yarns are as stiff under compression as under tension, and the crests of the folds, which lie along them, stand out almost level (the shadow reaches 148 of 150 mm); friction between yarns is left out. Exact are the last lines: a board, which has 1 but for the facets of its rim, and the ring as an isotropic plate that hardly bends (closed form in brackets)." drape_coefficient_test
  section "Strips between clamps as a model of tests" "What toile identify computes for model = clamped strip: largest error of the stress at any stretch against the independent solution of test/data/plane_stress/strips.csv, default mesh and one twice as fine; and that of a homogeneous state." \
    ../identify/identify_strip_test --gtest_filter=ClampedStrip.AgreesWithTheIndependentSolution:ClampedStrip.ConvergesWithSecondOrder
  section "Fits of virtual tests" "Data of the published Itskov set with 2 % noise. The Itskov law fitted to three tensile and two biaxial curves, then to the tensile ones alone: largest error against the law that made the data. The rebar law fitted to wale and course, then to bias as well." \
    ../identify/identify_fit_test "--gtest_filter=Fit.Itskov*:Fit.RebarIsTooSoftInBias"
} >"$out.new"
mv "$out.new" "$out"
