"""Displays of public repositories whose readings were judged by eye, each with its source."""

# ruff: noqa: E501 (a display is not broken)

JUDGED = (  # LaTeX, the right reading as a fully bracketed expression, repository and path
    (
        "C_D = \\left[\\frac{1}{(\\phi_1 + \\phi_2)^{-1} + (\\phi_3)^{-1}} + \\phi_4\\right]^{0.1}",
        "Chain(C_D, Pow(Add(Div(1; Add(Pow(Add(\\phi_1, \\phi_2); Neg(1)), Pow(\\phi_3; Neg(1)))), \\phi_4); 0.1); =)",
        "CalebBell/fluids/fluids/drag.py",
    ),
    (
        "x(t) = \\cos t + \\int_0^t \\cos(t-\\tau) x(\\tau) \\, d\\tau .",
        "Chain(Call(x; t), Add(Call(cos; t), Integral(Mul(Call(cos; Add(t, Neg(\\tau))), Call(x; \\tau)); \\tau; 0; t)); =)",
        "jirilebl/diffyqs/ch-laplace.tex",
    ),
    (
        "A = \\pi a b",
        "Chain(A, Mul(\\pi, a, b); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/elliptical-orbits.md",
    ),
    (
        "\\bm R_{n} =\\bm{R}_{P1} \\times \\bm{R}_{P2}",
        "Chain(\\bm{R}_n, Cross(\\bm{R}_{P1}; \\bm{R}_{P2}); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/celestialTwoBodyPoint/_Documentation/celestialTwoBodyPoint.tex",
    ),
    (
        "\\dfrac{\\mathrm{d} \\boldsymbol{L}'}{\\mathrm{d} t} = \\boldsymbol{M}^{(\\mathrm{e})} - \\boldsymbol{r}_C \\times \\boldsymbol{R}^{(\\mathrm{e})}",
        "Chain(Derivative(Call(\\boldsymbol{L}'); t, 1), Add(\\boldsymbol { M } ^ { ( \\mathrm { e } ) }, Neg(Cross(\\boldsymbol{r}_C; \\boldsymbol { R } ^ { ( \\mathrm { e } ) }))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "X^B = f_{kin}^B(q),",
        "Chain(X ^ { B }, Call(f _ { k i n } ^ { B }; q); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "{\\bf J} = \\begin{bmatrix} {\\bf n}\\\\ {\\bf t}_1\\\\ {\\bf t}_2 \\end{bmatrix},",
        "Chain(\\mathbf{J}, MatrixOf(\\mathbf{n}, \\mathbf{t}_1, \\mathbf{t}_2); =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "\\phi({\\bf q}) \\geq 0.",
        "Chain(Call(\\phi; \\mathbf{q}), 0; \\ge)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    ("\\vec{x}(t_0) = \\vec{b}", "Chain(Call(\\vec{x}; t_0), \\vec{b}; =)", "jirilebl/diffyqs/ch-systems.tex"),
    (
        "W({\\bf x}) \\ge 0 \\quad \\text{and} \\quad W({\\bf x}) \\ge \\mathcal{B}({\\bf x}) +1,",
        "System(Chain(Call(W; \\mathbf{x}), 0; \\ge), Chain(Call(W; \\mathbf{x}), Add(Call(\\mathcal{B}; \\mathbf{x}), 1); \\ge))",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "\\boldsymbol{a} = a_t \\boldsymbol{\\hat{u}}_{t} + a_n \\boldsymbol{\\hat{u}}_{n}",
        "Chain(\\boldsymbol{a}, Add(Mul(a_t, \\boldsymbol{\\hat{u}}_t), Mul(a_n, \\boldsymbol{\\hat{u}}_n)); =)",
        "bryanwweber/orbital-mechanics-notes/review/kinematics.md",
    ),
    (
        "\\begin{aligned} \\mu &= K \\mu_z + (1-K) \\bar\\mu\\\\ &= \\bar\\mu + K(\\mu_z - \\bar\\mu) \\end{aligned}",
        "Chain(\\mu, Add(Mul(K, \\mu_z), Mul(Add(1, Neg(K)), \\bar{\\mu})), Add(\\bar{\\mu}, Mul(K, Add(\\mu_z, Neg(\\bar{\\mu})))); =, =)",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_2_main.rst",
    ),
    (
        "\\dot{V} = x (-x + x^3) = -x^2 + x^4.",
        "Chain(Call(\\dot{V}), Mul(x, Add(Neg(x), Pow(x; 3))), Add(Neg(Pow(x; 2)), Pow(x; 4)); =, =)",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "n_1 = \\frac{N_2}{\\left(\\frac{C}{d^2}\\right)^2}",
        "Chain(n_1, Div(N_2; Pow(Div(C; Pow(d; 2)); 2)); =)",
        "CalebBell/fluids/fluids/control_valve.py",
    ),
    (
        "0 = \\frac{1}{2}\\tan\\frac{\\nu}{2} + \\frac{1}{6}\\tan^3\\frac{\\nu}{2} - M_p",
        "Chain(0, Add(Mul(Div(1; 2), Call(tan; Div(\\nu; 2))), Mul(Div(1; 6), Pow(Call(tan; Div(\\nu; 2)); 3)), Neg(M_p)); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/parabolic-trajectories.md",
    ),
    (
        "\\frac{v^2}{2} - \\frac{\\mu}{r} = 0",
        "Chain(Add(Div(Pow(v; 2); 2), Neg(Div(\\mu; r))), 0; =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/parabolic-trajectories.md",
    ),
    (
        "S(z) = \\int_{1/2}^z \\pi \\cot(\\pi t) dt",
        "Chain(Call(S; z), Integral(Mul(\\pi, Call(cot; Mul(\\pi, t))); t; Div(1; 2); z); =)",
        "fredrik-johansson/arb/doc/source/acb.rst",
    ),
    (
        "C = 0.6143 + 0.718(1 - \\beta^2)",
        "Chain(C, Add(0.6143, Mul(0.718, Add(1, Neg(Pow(\\beta; 2))))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "\\mathrm{B}_z (a, b) = \\mathrm{B}_{(0, z)}(a, b)",
        "Chain(Call(\\text{B}_z; a, b), Call(\\text{B}_{(0,z)}; a, b); =)",
        "sympy/sympy/sympy/functions/special/beta_functions.py",
    ),
    (
        "\\hat{\\bm e} = \\frac{\\bm h \\times \\hat{\\bm h}_{c}}{|\\bm h \\times \\hat{\\bm h}_{c}|}",
        "Chain(\\hat{\\bm{e}}, Div(Cross(\\bm{h}; \\hat{\\bm{h}}_c); Bars(Cross(\\bm{h}; \\hat{\\bm{h}}_c))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/opNavPoint/_Documentation/secModelDescription.tex",
    ),
    (
        "a\\cos E = ae + r\\cos\\nu",
        "Chain(Mul(a, Call(cos; E)), Add(Mul(a, e), Mul(r, Call(cos; \\nu))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "f(k) := \\rho B(k, \\rho + 1)",
        "Chain(Call(f; k), Mul(\\rho, Call(B; k, Add(\\rho, 1))); =)",
        "sympy/sympy/sympy/stats/drv_types.py",
    ),
    (
        "\\dot{v}=u_a",
        "Chain(Call(\\dot{v}), u_a; =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/cgmres_nmpc/cgmres_nmpc_main.rst",
    ),
    (
        "b = \\left[\\begin{array}{c} 1 \\\\ -6 \\\\ 2 \\end{array}\\right]",
        "Chain(b, MatrixOf(1, Neg(6), 2); =)",
        "sympy/sympy/sympy/solvers/solveset.py",
    ),
    (
        "\\mathbf{q}_{t+1} = e^{\\frac{1}{2}\\boldsymbol\\Omega(\\boldsymbol\\omega)\\Delta t}\\mathbf{q}_t",
        "Chain(\\mathbf{q}_{t+1}, Mul(Pow(e; Mul(Div(1; 2), Call(\\boldsymbol{\\Omega}; \\boldsymbol{\\omega}), \\Delta t)), \\mathbf{q}_t); =)",
        "Mayitzin/ahrs/ahrs/filters/angular.py",
    ),
    (
        "u_{s,CL} = u_{s} - K (u_{n} - u_{s})",
        "Chain(u_{s,CL}, Add(u_s, Neg(Mul(K, Add(u_n, Neg(u_s))))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/rwMotorVoltage/_Documentation/secModelDescription.tex",
    ),
    (
        "E(m) = \\int_0^{\\pi/2} \\sqrt{1-m \\sin^2 t} \\, dt = \\int_0^1 \\frac{\\sqrt{1-mt^2}}{\\sqrt{1-t^2}} \\, dt",
        "Chain(Call(E; m), Integral(Sqrt(Add(1, Neg(Mul(m, Pow(Call(sin; t); 2))))); t; 0; Div(\\pi; 2)), Integral(Div(Sqrt(Add(1, Neg(Mul(m, Pow(t; 2))))); Sqrt(Add(1, Neg(Pow(t; 2))))); t; 0; 1); =, =)",
        "fredrik-johansson/arb/doc/source/acb_elliptic.rst",
    ),
    (
        "\\dot{X} = \\frac{\\mu - X}{\\tau}",
        "Chain(Call(\\dot{X}), Div(Add(\\mu, Neg(Call(X))); \\tau); =)",
        "AVSLab/basilisk/src/simulation/mujocoDynamics/_GeneralModuleFiles/inhomogeneousGeometricBrownianMotion.rst",
    ),
    (
        "\\dot{{\\bf x}} = {\\bf A}(t){\\bf x} + {\\bf B}(t){\\bf u} + {\\bf c}(t),",
        "Chain(Call(\\dot{\\mathbf{x}}), Add(Mul(Call(\\mathbf{A}; t), Call(\\mathbf{x})), Mul(Call(\\mathbf{B}; t), \\mathbf{u}), Call(\\mathbf{c}; t)); =)",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "\\bar{f}_d(\\dot{\\bar{u}}, \\bar{u}, \\bar{q}, t) = 0 \\\\ \\bar{f}_k(\\dot{\\bar{q}}, \\bar{u}, \\bar{q}, t) = 0",
        "System(Chain(Call(\\bar{f}_d; Call(\\dot{\\bar{u}}), Call(\\bar{u}), Call(\\bar{q}), t), 0; =), Chain(Call(\\bar{f}_k; Call(\\dot{\\bar{q}}), Call(\\bar{u}), Call(\\bar{q}), t), 0; =))",
        "moorepants/learn-multibody-dynamics/eom.rst",
    ),
    (
        "X''(x) + \\lambda X(x) &= 0 , \\\\ T'(t) + \\lambda k T(t) &= 0 .",
        "System(Chain(Add(Call(X''; x), Mul(\\lambda, Call(X; x))), 0; =), Chain(Add(Call(T'; t), Mul(\\lambda, k, Call(T; t))), 0; =))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    ("a = a_1 + a_2", "Chain(a, Add(a_1, a_2); =)", "CalebBell/fluids/fluids/geometry.py"),
    (
        "\\sigma X",
        "Mul(\\sigma, X)",
        "AVSLab/basilisk/src/simulation/mujocoDynamics/_GeneralModuleFiles/inhomogeneousGeometricBrownianMotion.rst",
    ),
    ("y'' - k^2 y = 0 .", "Chain(Add(y'', Neg(Mul(Pow(k; 2), y))), 0; =)", "jirilebl/diffyqs/ch-higher-order-ode.tex"),
    (
        "\\ddot{\\boldsymbol{R}} = \\boldsymbol{A}_s + \\boldsymbol{P}_p",
        "Chain(Call(\\ddot{\\boldsymbol{R}}), Add(\\boldsymbol{A}_s, \\boldsymbol{P}_p); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/sphere-of-influence.md",
    ),
    (
        "u = [a, \\delta]",
        "Chain(u, Tuple(a, \\delta; []); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/model_predictive_speed_and_steering_control/model_predictive_speed_and_steering_control_main.rst",
    ),
    (
        "u = -\\tau_g + m\\left[\\ddot{q}_d + K_p (q_d - q) + K_d (\\dot{q}_d - \\dot{q}) \\right].",
        "Chain(u, Add(Neg(\\tau_g), Mul(m, Add(Call(\\ddot{q}_d), Mul(K_p, Add(Call(q_d), Neg(Call(q)))), Mul(K_d, Add(Call(\\dot{q}_d), Neg(Call(\\dot{q}))))))); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "V_s = \\frac{1}{2} k \\left| \\bar{r}^{P/Q} \\right|^2 = \\frac{1}{2} k \\bar{r}^{P/Q} \\cdot \\bar{r}^{P/Q}",
        "Chain(V_s, Mul(Div(1; 2), k, Pow(Bars(\\bar { r } ^ { P / Q }); 2)), Mul(Div(1; 2), k, \\bar { r } ^ { P / Q }, \\bar { r } ^ { P / Q }); =, =)",
        "moorepants/learn-multibody-dynamics/energy.rst",
    ),
    (
        "|u_{t}|<u_{max}",
        "Chain(Bars(u_t), u_{max}; <)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/model_predictive_speed_and_steering_control/model_predictive_speed_and_steering_control_main.rst",
    ),
    (
        "e_t = \\frac{r_1 - r_3}{r_3 + r_1}",
        "Chain(e_t, Div(Add(r_1, Neg(r_3)); Add(r_3, r_1)); =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/comparison-of-bielliptic-and-hohmann.md",
    ),
    (
        "{}^N\\bar{v}^{Bo} \\cdot \\hat{b}_y = 0 \\\\ {}^N\\bar{v}^{Co} \\cdot \\hat{c}_y = 0",
        "System(Chain(Mul(\\prescript { N } { } { \\bar { v } } ^ { B o }, \\hat{b}_y; 1), 0; =), Chain(Mul(\\prescript { N } { } { \\bar { v } } ^ { C o }, \\hat{c}_y; 1), 0; =))",
        "moorepants/learn-multibody-dynamics/motion.rst",
    ),
    (
        "X'(t) = A(t) X(t) + b(t)",
        "Chain(Call(X'; t), Add(Mul(Call(A; t), Call(X; t)), Call(b; t)); =)",
        "sympy/sympy/sympy/solvers/ode/systems.py",
    ),
    (
        "v_r = \\dot{r} = \\frac{\\mu}{h} e \\sin\\nu",
        "Chain(v_r, Call(\\dot{r}), Mul(Div(\\mu; h), e, Call(sin; \\nu)); =, =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/orbital-nomenclature.md",
    ),
    (
        "\\bar{F}_r + \\bar{F}^*_r = \\bar{f}_d(\\dot{\\bar{u}}, \\bar{u}, \\bar{q}, t) = 0",
        "Chain(Add(\\bar{F}_r, \\bar { F } _ { r } ^ { * }), Call(\\bar{f}_d; Call(\\dot{\\bar{u}}), Call(\\bar{u}), \\bar{q}, t), 0; =, =)",
        "moorepants/learn-multibody-dynamics/eom.rst",
    ),
    (
        "g_V(x,u)=g(x,u)+\\frac{dV(x)}{dx}f(x,u),",
        "Chain(Call(g_V; x, u), Add(Call(g; x, u), Mul(Derivative(Call(V; x); x, 1), Call(f; x, u))); =)",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "2x - 2y + 4z = -2",
        "Chain(Add(Mul(2, x), Neg(Mul(2, y)), Mul(4, z)), Neg(2); =)",
        "sympy/sympy/sympy/solvers/solveset.py",
    ),
    (
        "f(x) = \\begin{cases} 0.1\\, x & \\text{if } \\; 0 \\leq x \\leq 1 , \\\\ 0.1\\, (2-x) & \\text{if } \\; 1 < x \\leq 2 . \\end{cases}",
        "Chain(Call(f; x), Piecewise(Mul(0.1, x), Chain(0, x, 1; \\le, \\le), Mul(0.1, Add(2, Neg(x))), Chain(1, x, 2; <, \\le)); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "S(u,v,\\phi,t) = -Et + p_\\phi\\phi + S_1(u)+S_2(v)",
        "Chain(Call(S; u, v, \\phi, t), Add(Neg(Mul(E, t)), Mul(p_\\phi, \\phi), Call(S_1; u), Call(S_2; v)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\Gamma(x+1) = x \\Gamma(x) .",
        "Chain(Call(Gamma; Add(x, 1)), Mul(x, Call(Gamma; x)); =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "L(q, s, a) = \\Phi(e^{2\\pi i q}, s, a).",
        "Chain(Call(L; q, s, a), Call(\\Phi; Pow(e; Mul(2, \\pi, i, q)), s, a); =)",
        "sympy/sympy/sympy/functions/special/zeta_functions.py",
    ),
    (
        "y = C_1 e^{-2x} + C_2 e^{-3x} + \\frac{3x-1}{9} .",
        "Chain(y, Add(Mul(C_1, Pow(e; Neg(Mul(2, x)))), Mul(C_2, Pow(e; Neg(Mul(3, x)))), Div(Add(Mul(3, x), Neg(1)); 9)); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "{}^{\\mathcal{B}}\\bar{\\bm L}_{r} = [C]^{T} [C] {}^{\\mathcal{B}}\\bm L_{r}",
        "Chain(\\prescript { \\mathcal { B } } { } { \\bar { \\bm { L } } } _ { r }, Mul(Transpose([ C ]), [ C ], \\prescript { \\mathcal { B } } { } { \\bm { L } } _ { r }); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/thrForceMapping/_Documentation/secModuleDescription.tex",
    ),
    (
        "\\begin{cases} \\ddot{\\theta} = 0 \\\\ \\ddot{\\phi} = 0 \\end{cases}",
        "System(Chain(Call(\\ddot{\\theta}), 0; =), Chain(Call(\\ddot{\\phi}), 0; =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "\\Phi = \\arccos \\left( \\frac{\\bm s \\cdot \\hat{\\bm s}_{c} }{|\\bm s|} \\right)",
        "Chain(\\Phi, Call(arccos; Div(Mul(\\bm{s}, \\hat{\\bm{s}}_c; 1); Bars(\\bm{s}))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/sunSafePoint/_Documentation/secModelDescription.tex",
    ),
    (
        "\\mathbf{q}\\cdot\\mathbf{q}_I = q_w",
        "Chain(Mul(\\mathbf{q}, \\mathbf{q}_I; 1), q_w; =)",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "{\\bf PA} + {\\bf A}^T{\\bf P} = - {\\bf Q},",
        "Chain(Add(Mul(\\mathbf{P}, \\mathbf{A}), Mul(Transpose(\\mathbf{A}), \\mathbf{P})), Neg(\\mathbf{Q}); =)",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    ("4r(r-1) + 1 = 0 .", "Chain(Add(Mul(4, r, Add(r, Neg(1))), 1), 0; =)", "jirilebl/diffyqs/ch-power-ser.tex"),
    (
        "I_3>I_2>I_1",
        "Chain(I_3, I_2, I_1; >, >)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "\\Delta P > F_L^2(P_1 - F_F P_{sat})",
        "Chain(\\Delta P, Mul(Pow(F_L; 2), Add(P_1, Neg(Mul(F_F, P_{sat})))); >)",
        "CalebBell/fluids/fluids/control_valve.py",
    ),
    (
        "E = -\\frac{\\mu}{2a}",
        "Chain(E, Neg(Div(\\mu; Mul(2, a))); =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/hohmann-transfer.md",
    ),
    (
        "v_{\\infty} = \\frac{\\mu}{h}e\\sin\\nu_{\\infty} = \\frac{\\mu}{h}\\sqrt{e^2 - 1}",
        "Chain(v_\\infty, Mul(Div(\\mu; h), e, Call(sin; \\nu_\\infty)), Mul(Div(\\mu; h), Sqrt(Add(Pow(e; 2), Neg(1)))); =, =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/hyperbolic-trajectories.md",
    ),
    (
        "I_{arm} \\ddot{q} = \\tau_{gravity} + \\tau,",
        "Chain(Mul(I_{arm}, Call(\\ddot{q})), Add(\\tau_{gravity}, \\tau); =)",
        "RussTedrake/manipulation/book/robot.html",
    ),
    (
        "b = - \\frac{ \\rho_{\\text{ref}} - \\rho(t_c) }{(t_c - t_f)^2}",
        "Chain(b, Neg(Div(Add(\\rho_{ref}, Neg(Call(\\rho; t_c))); Pow(Add(t_c, Neg(t_f)); 2))); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedLinearTranslation/prescribedLinearTranslation.rst",
    ),
    (
        "f_p = \\frac{\\Delta P d_p}{\\rho v_s^2 L}",
        "Chain(f_p, Div(Mul(\\Delta P, d_p); Mul(\\rho, Pow(v_s; 2), L)); =)",
        "CalebBell/fluids/fluids/packed_bed.py",
    ),
    (
        "\\phi = \\sqrt{1 + C_{Ch} X + X^2}",
        "Chain(\\phi, Sqrt(Add(1, Mul(C_{Ch}, X), Pow(X; 2))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "\\int_0^\\infty g(x(t),u(t))dt<\\infty.",
        "Chain(Integral(Call(g; Call(x; t), Call(u; t)); t; 0; Infinity()), Infinity(); <)",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "f(z) = -\\frac{\\pi^2 z^4}{16} \\,.",
        "Chain(Call(f; z), Neg(Div(Mul(Pow(\\pi; 2), Pow(z; 4)); 16)); =)",
        "sympy/sympy/doc/src/modules/simplify/hyperexpand.rst",
    ),
    ("R = 1", "Chain(R, 1; =)", "AVSLab/basilisk/src/simulation/communication/simpleAntenna/simpleAntenna.rst"),
    (
        "Y = \\frac{\\Delta \\bar \\omega}{\\Delta P} - 0.0896 - 0.48\\beta^9",
        "Chain(Y, Add(Div(\\Delta \\bar { \\omega }; \\Delta P), Neg(0.0896), Neg(Mul(0.48, Pow(\\beta; 9)))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    ("E := K + V", "Chain(E, Add(K, V); =)", "moorepants/learn-multibody-dynamics/energy.rst"),
    (
        "\\mathrm{BIC} = -2\\,\\mathcal{L}^* + K\\,\\log N",
        "Chain(\\text{BIC}, Add(Neg(Mul(2, \\mathcal { L } ^ { * })), Mul(K, Call(log; N))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\Omega_{\\text{out}} = N\\frac{2\\pi}{n\\Delta t}",
        "Chain(\\Omega_{out}, Mul(N, Div(Mul(2, \\pi); Mul(n, \\Delta t))); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/encoder/encoder.rst",
    ),
    (
        "\\cos \\frac{\\theta}{2} = \\cos(\\beta-\\alpha) = \\cos\\beta \\cos\\alpha + \\sin \\beta \\sin \\alpha",
        "Chain(Call(cos; Div(\\theta; 2)), Call(cos; Add(\\beta, Neg(\\alpha))), Add(Mul(Call(cos; \\beta), Call(cos; \\alpha)), Mul(Call(sin; \\beta), Call(sin; \\alpha))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "h = \\frac{\\mu}{v_{\\infty}} \\sqrt{e^2 - 1}",
        "Chain(h, Mul(Div(\\mu; v_\\infty), Sqrt(Add(Pow(e; 2), Neg(1)))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables-example.md",
    ),
    (
        "\\mathbf{C}\\,^r\\mathbf{m}=\\,^b\\mathbf{m}",
        "Chain(Mul(\\mathbf{C}, \\prescript { r } { } { \\mathbf { m } }), \\prescript { b } { } { \\mathbf { m } }; =)",
        "Mayitzin/ahrs/ahrs/filters/saam.py",
    ),
    ("\\sin\\theta = a_x", "Chain(Call(sin; \\theta), a_x; =)", "Mayitzin/ahrs/ahrs/filters/fqa.py"),
    (
        "F = \\frac{G m M}{r^2}",
        "Chain(F, Div(Mul(G, m, M); Pow(r; 2)); =)",
        "sympy/sympy/doc/src/modules/physics/units/examples.rst",
    ),
    (
        "\\bm e = \\frac{\\dot{\\bm r} \\times \\bm h}{\\mu} - \\frac{\\bm r}{r}",
        "Chain(\\bm{e}, Add(Div(Cross(Call(\\dot{\\bm{r}}); \\bm{h}); \\mu), Neg(Div(Call(\\bm{r}); Call(r)))); =)",
        "AVSLab/basilisk/src/architecture/utilitiesSelfCheck/_Documentation/secModelDescription.tex",
    ),
    (
        "b_4(t) = -t^2 + t^3",
        "Chain(Call(b_4; t), Add(Neg(Pow(t; 2)), Pow(t; 3)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/catmull_rom_spline/catmull_rom_spline_main.rst",
    ),
    (
        "\\boldsymbol{F}' = m \\boldsymbol{a}'",
        "Chain(\\boldsymbol{F}', Mul(m, \\boldsymbol{a}'); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter7.tex",
    ),
    (
        "I(a,b;z) = \\frac{\\Gamma(a+b)}{\\Gamma(b)} z^a {}_2{\\widetilde F}_1(a, 1-b, a+1, z).",
        "Chain(Call(I; Given(a, b; z; ;)), Mul(Div(Call(Gamma; Add(a, b)); Call(Gamma; b)), Pow(z; a), Call(\\prescript { } { 2 } { \\widetilde { F } } _ { 1 }; a, Add(1, Neg(b)), Add(a, 1), z)); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "\\ddot{\\boldsymbol{r}}_2 = - \\frac{\\mu'}{r_2^3}\\boldsymbol{r}_2",
        "Chain(Call(\\ddot{\\boldsymbol{r}}_2), Neg(Mul(Div(\\mu'; Pow(Call(r_2); 3)), Call(\\boldsymbol{r}_2))); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-relative-motion.md",
    ),
    ("L_1 = L_2' = 0", "Chain(L_1, L_2', 0; =, =)", "CalebBell/fluids/fluids/flow_meter.py"),
    (
        "Q = -b\\dot\\theta(t) + u(t).",
        "Chain(Q, Add(Neg(Mul(b, Call(\\dot{\\theta}; t))), Call(u; t)); =)",
        "RussTedrake/underactuated/book/pend.html",
    ),
    (
        "y_c = C_1 e^{-3x} + C_2 e^{3x} .",
        "Chain(y_c, Add(Mul(C_1, Pow(e; Neg(Mul(3, x)))), Mul(C_2, Pow(e; Mul(3, x)))); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "\\frac{x-y+2}{x-y} = D e^{2x} ,",
        "Chain(Div(Add(x, Neg(y), 2); Add(x, Neg(y))), Mul(D, Pow(e; Mul(2, x))); =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "C = 0.77 - 0.09\\beta",
        "Chain(C, Add(0.77, Neg(Mul(0.09, \\beta))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "\\begin{aligned} {x}_{\\omega} &= r\\cos\\nu & {y}_{\\omega} &= r\\sin\\nu \\end{aligned}",
        "System(Chain(x_\\omega, Mul(r, Call(cos; \\nu)); =), Chain(y_\\omega, Mul(r, Call(sin; \\nu)); =))",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/perifocal-frame.md",
    ),
    (
        "r = \\frac{h^2}{\\mu}\\frac{1}{1 + e\\cos\\nu}",
        "Chain(r, Mul(Div(Pow(h; 2); \\mu), Div(1; Add(1, Mul(e, Call(cos; \\nu))))); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/the-orbit-equation.md",
    ),
    (
        "C_p = \\frac{A_{\\text{overlap}}}{\\pi}.",
        "Chain(C_p, Div(A_{overlap}; \\pi); =)",
        "AVSLab/basilisk/src/simulation/communication/simpleAntenna/simpleAntenna.rst",
    ),
    ("GM_A = G\\ M_A", "Chain(Mul(G, M_A), Mul(G, M_A); =)", "Mayitzin/ahrs/ahrs/utils/wgs84.py"),
    (
        "G = \\sum_{\\alpha,\\beta=1}^s M_{\\alpha\\beta}q'_\\alpha q'_\\beta",
        "Chain(G, BigSum(\\alpha, \\beta; 1; s; Mul(M_{\\alpha \\beta}, q'_{\\alpha}, q'_{\\beta})); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "\\frac{dx}{dt} &= f(t, x, u, \\theta), \\\\ y &= h(t, x, u, \\theta),",
        "System(Chain(Derivative(Call(x); t, 1), Call(f; t, Call(x), u, \\theta); =), Chain(y, Call(h; t, Call(x), u, \\theta); =))",
        "python-control/python-control/doc/nlsys.rst",
    ),
    (
        "P(X \\mid Z) = \\frac{P(Z \\mid X)P(X)}{P(Z)}",
        "Chain(Call(P; Given(X; Z; |)), Div(Mul(Call(P; Given(Z; X; |)), Call(P; X)); Call(P; Z)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_main.rst",
    ),
    (
        "{\\bm{r}}'_{S/C} = - \\bm{c}'",
        "Chain(\\bm{r}_{S/C}', Neg(\\bm{c}'); =)",
        "AVSLab/basilisk/src/architecture/utilities/_Documentation/discretize/secTest.tex",
    ),
    (
        "\\textbf{z}_t=[x_t,y_t]",
        "Chain(\\mathbf{z}_t, Tuple(x_t, y_t; []); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/extended_kalman_filter_localization_files/extended_kalman_filter_localization_main.rst",
    ),
    (
        "\\boldsymbol{v} = \\boldsymbol{v}_O + \\boldsymbol{\\omega} \\times \\boldsymbol{r}' = \\boldsymbol{v}_O + \\boldsymbol{\\omega} \\times (\\boldsymbol{r}-\\boldsymbol{r}_O)",
        "Chain(\\boldsymbol{v}, Add(\\boldsymbol{v}_O, Cross(\\boldsymbol{\\omega}; \\boldsymbol{r}')), Add(\\boldsymbol{v}_O, Cross(\\boldsymbol{\\omega}; Add(\\boldsymbol{r}, Neg(\\boldsymbol{r}_O)))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "\\begin{array}{ll} y_{tt} = 2 y_{xx} & \\qquad \\text{for } \\; 0 < x < \\pi \\text{ and } t > 0, \\\\ y(0,t) = y(\\pi,t) = 0 & \\qquad \\text{for } \\; t > 0 , \\\\ y(x,0) = x & \\qquad \\text{for } \\; 0 < x < \\pi , \\\\ y_t(x,0) = 0 & \\qquad \\text{for } \\; 0 < x < \\pi . \\end{array}",
        "System(Implies(System(Chain(0, x, \\pi; <, <), Chain(t, 0; >)); Chain(y_{tt}, Mul(2, y_{xx}); =)), Implies(Chain(t, 0; >); Chain(Call(y; 0, t), Call(y; \\pi, t), 0; =, =)), Implies(Chain(0, x, \\pi; <, <); Chain(Call(y; x, 0), x; =)), Implies(Chain(0, x, \\pi; <, <); Chain(Call(y_t; x, 0), 0; =)))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "h(z)=\\frac{\\exp \\left(-(d - z)^{2} / 2\\right)}{\\sqrt{2 \\pi}}",
        "Chain(Call(h; z), Div(Call(exp; Neg(Div(Pow(Add(d, Neg(z)); 2); 2))); Sqrt(Mul(2, \\pi))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/histogram_filter_localization/histogram_filter_localization_main.rst",
    ),
    (
        "\\eta_s = \\frac{(P_2/P_1)^{(k-1)/k}-1} {(P_2/P_1)^{\\frac{k-1}{k\\eta_p}}-1}",
        "Chain(\\eta_s, Div(Add(Pow(Div(P_2; P_1); Div(Add(k, Neg(1)); k)), Neg(1)); Add(Pow(Div(P_2; P_1); Div(Add(k, Neg(1)); Mul(k, \\eta_p))), Neg(1))); =)",
        "CalebBell/fluids/fluids/compressible.py",
    ),
    (
        "M_m \\dot{x} = f_m",
        "Chain(Mul(M_m, Call(\\dot{x})), f_m; =)",
        "sympy/sympy/sympy/physics/mechanics/system.py",
    ),
    (
        "\\begin{bmatrix} \\hat{b}_x \\\\ \\hat{b}_y \\\\ \\hat{b}_z \\end{bmatrix} = {}^B\\mathbf{C}^A {}^A\\mathbf{C}^N \\begin{bmatrix} \\hat{n}_x \\\\ \\hat{n}_y \\\\ \\hat{n}_z \\end{bmatrix}",
        "Chain(MatrixOf(\\hat{b}_x, \\hat{b}_y, \\hat{b}_z), Mul(\\prescript { B } { } { \\mathbf { C } } ^ { A }, \\prescript { A } { } { \\mathbf { C } } ^ { N }, MatrixOf(\\hat{n}_x, \\hat{n}_y, \\hat{n}_z)); =)",
        "moorepants/learn-multibody-dynamics/orientation.rst",
    ),
    (
        "T_n(z) = {}_2F_1\\left(-n,n,\\frac{1}{2},\\frac{1-z}{2}\\right)",
        "Chain(Call(T_n; z), Call(\\prescript { } { 2 } { F } _ { 1 }; Neg(n), n, Div(1; 2), Div(Add(1, Neg(z)); 2)); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "\\begin{aligned} \\boldsymbol{h} &= \\boldsymbol{r}\\times\\boldsymbol{v} = r\\boldsymbol{\\hat{u}}_r \\times\\left(v_r\\boldsymbol{\\hat{u}}_r + v_{\\perp}\\boldsymbol{\\hat{u}}_{\\perp}\\right)\\\\ &= r v_r\\left(\\boldsymbol{\\hat{u}}_r\\times\\boldsymbol{\\hat{u}}_r\\right) + r v_{\\perp}\\left(\\boldsymbol{\\hat{u}}_r\\times\\boldsymbol{\\hat{u}}_{\\perp}\\right)\\\\ &= r v_{\\perp}\\boldsymbol{\\hat{h}} \\end{aligned}",
        "Chain(\\boldsymbol{h}, Cross(\\boldsymbol{r}; \\boldsymbol{v}), Cross(Mul(r, \\boldsymbol{\\hat{u}}_r); Add(Mul(v_r, \\boldsymbol{\\hat{u}}_r), Mul(v_\\perp, \\boldsymbol{\\hat{u}}_\\perp))), Add(Mul(r, v_r, Cross(\\boldsymbol{\\hat{u}}_r; \\boldsymbol{\\hat{u}}_r)), Mul(r, v_\\perp, Cross(\\boldsymbol{\\hat{u}}_r; \\boldsymbol{\\hat{u}}_\\perp))), Mul(r, v_\\perp, \\boldsymbol{\\hat{h}}); =, =, =, =)",
        "bryanwweber/orbital-mechanics-notes/constants-of-orbital-motion/orbital-plane-and-keplers-second-law.md",
    ),
    (
        "\\begin{split} 0 = y''-xy &= \\Biggl( \\sum_{k=2}^\\infty k\\,(k-1) \\, a_k x^{k-2} \\Biggr) - x \\Biggl( \\sum_{k=0}^\\infty a_k x^k \\Biggr) \\\\ &= \\Biggl( \\sum_{k=2}^\\infty k\\,(k-1) \\, a_k x^{k-2} \\Biggr) - \\Biggl( \\sum_{k=0}^\\infty a_k x^{k+1} \\Biggr) . \\end{split}",
        "Chain(0, Add(y'', Neg(Mul(x, y))), Add(BigSum(k; 2; Infinity(); Mul(k, Add(k, Neg(1)), a_k, Pow(x; Add(k, Neg(2))))), Neg(Mul(x, BigSum(k; 0; Infinity(); Mul(a_k, Pow(x; k)))))), Add(BigSum(k; 2; Infinity(); Mul(k, Add(k, Neg(1)), a_k, Pow(x; Add(k, Neg(2))))), Neg(BigSum(k; 0; Infinity(); Mul(a_k, Pow(x; Add(k, 1)))))); =, =, =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "\\mathbf{a}' = \\mathbf{a} + 2\\alpha (\\vec{\\mathbf{v}}\\times\\mathbf{a}) + 2\\big(\\vec{\\mathbf{v}}\\times(\\vec{\\mathbf{v}}\\times\\mathbf{a})\\big)",
        "Chain(\\mathbf{a}', Add(\\mathbf{a}, Mul(2, \\alpha, Cross(\\vec{\\mathbf{v}}; \\mathbf{a})), Mul(2, Cross(\\vec{\\mathbf{v}}; Cross(\\vec{\\mathbf{v}}; \\mathbf{a})))); =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "E_F = \\frac{1}{2} m_{\\text{tot}} v_{\\text{CoM}}^2 + 2\\Big[\\frac{1}{2} k \\theta_{\\text{max}}^2\\Big]",
        "Chain(E_F, Add(Mul(Div(1; 2), m_{tot}, Pow(v_{CoM}; 2)), Mul(2, Mul(Div(1; 2), k, Pow(\\theta_{max}; 2)))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/HingedRigidBodies/_Documentation/secTest.tex",
    ),
    (
        "w = R - h",
        "Chain(w, Add(R, Neg(h)); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "T_{\\text{orb}} = \\frac{1}{2} m_{sc} \\dot{\\bm r}_{C/N} \\cdot \\dot{\\bm r}_{C/N}",
        "Chain(T_{orb}, Mul(Div(1; 2), m_{sc}, Call(\\dot{\\bm{r}}_{C/N}), Call(\\dot{\\bm{r}}_{C/N}); 3); =)",
        "AVSLab/basilisk/src/simulation/dynamics/spacecraft/_Documentation/Spacecraft/secModelDescription.tex",
    ),
    (
        "{\\bf \\phi}({\\bf q},\\dot{\\bf q}, \\ddot{\\bf q}, {\\bf u}, t) = 0,",
        "Chain(Call(\\mathbf{\\phi}; Call(\\mathbf{q}), Call(\\dot{\\mathbf{q}}), Call(\\ddot{\\mathbf{q}}), \\mathbf{u}, t), 0; =)",
        "RussTedrake/underactuated/book/intro.html",
    ),
    (
        "{}^Ap^B_F = - {}^Bp^A_F.",
        "Chain(\\prescript { A } { } { p } _ { F } ^ { B }, Neg(\\prescript { B } { } { p } _ { F } ^ { A }); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "l_1 = c_1 \\tan(f_1)",
        "Chain(l_1, Mul(c_1, Call(tan; f_1)); =)",
        "AVSLab/basilisk/src/simulation/environment/eclipse/eclipse.rst",
    ),
    (
        "r = \\frac{p}{2}(1+\\eta^2)",
        "Chain(r, Mul(Div(p; 2), Add(1, Pow(\\eta; 2))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "\\underbrace{A \\cos \\bigl(-\\sqrt{\\lambda}\\, \\pi\\bigr) + B \\sin \\bigl(-\\sqrt{\\lambda}\\, \\pi\\bigr)}_{x(-\\pi)} = \\underbrace{A \\cos \\bigl( \\sqrt{\\lambda}\\, \\pi \\bigr) + B \\sin \\bigl( \\sqrt{\\lambda}\\, \\pi\\bigr)}_{x(\\pi)} .",
        "Chain(Add(Mul(A, Call(cos; Neg(Mul(Sqrt(\\lambda), \\pi)))), Mul(B, Call(sin; Neg(Mul(Sqrt(\\lambda), \\pi))))), Add(Mul(A, Call(cos; Mul(Sqrt(\\lambda), \\pi))), Mul(B, Call(sin; Mul(Sqrt(\\lambda), \\pi)))); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\bm\\omega_{R/N} = \\bm\\omega_{R/R_{0}} + \\bm\\omega_{R_{0}/N} = \\bm\\omega_{R_{0}/N}",
        "Chain(\\bm{\\omega}_{R/N}, Add(\\bm{\\omega}_{R/R_0}, \\bm{\\omega}_{R_0/N}), \\bm{\\omega}_{R_0/N}; =, =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/attTrackingError/_Documentation/secModuleDescription.tex",
    ),
    (
        "\\alpha = (1 - \\sigma')^{-1}",
        "Chain(\\alpha, Pow(Add(1, Neg(\\sigma')); Neg(1)); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "\\tan\\beta = \\frac{e \\sin f}{1 + e \\cos f}",
        "Chain(Call(tan; \\beta), Div(Mul(e, Call(sin; f)); Add(1, Mul(e, Call(cos; f)))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/velocityPoint/_Documentation/velocityPoint.tex",
    ),
    (
        "Lw = L(y_p - \\tilde{y}_p) = Ly_p - L\\tilde{y}_p = (2x+1)-(2x+1) = 0 .",
        "Chain(Mul(L, w), Mul(L, Add(y_p, Neg(\\tilde{y}_p))), Add(Mul(L, y_p), Neg(Mul(L, \\tilde{y}_p))), Add(Add(Mul(2, x), 1), Neg(Add(Mul(2, x), 1))), 0; =, =, =, =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "\\bar{\\textbf{x}} = \\dfrac{1}{m_{total}}\\sum_{i}m_i\\textbf{x}_i,",
        "Chain(\\bar{\\mathbf{x}}, Mul(Div(1; m_{total}), BigSum(i; Mul(m_i, \\mathbf{x}_i))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/formationBarycenter/formationBarycenter.rst",
    ),
    (
        "a_z = -g\\cos\\theta",
        "Chain(a_z, Neg(Mul(g, Call(cos; \\theta))); =)",
        "Mayitzin/ahrs/ahrs/filters/fqa.py",
    ),
    (
        "R_{\\mathrm{dropped,pot}} = R_{\\mathrm{remove,pot}} - R_{\\mathrm{delivered,pot}}",
        "Chain(R_{dropped,pot}, Add(R_{remove,pot}, Neg(R_{delivered,pot})); =)",
        "AVSLab/basilisk/src/simulation/communication/downlinkHandling/downlinkHandling.rst",
    ),
    (
        "\\boldsymbol{r}_2 = \\left(x - \\pi_1 r_{12}\\right)\\boldsymbol{\\hat{\\imath}} + y\\boldsymbol{\\hat{\\jmath}} + z\\boldsymbol{\\hat{k}}",
        "Chain(\\boldsymbol{r}_2, Add(Mul(Add(x, Neg(Mul(\\pi_1, r_{12}))), \\boldsymbol{\\hat{\\imath}}), Mul(y, \\boldsymbol{\\hat{\\jmath}}), Mul(z, \\boldsymbol{\\hat{k}})); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "C_0 = 1 + 0.2(1-x)(gD)^{0.25}\\left(\\frac{\\rho_l}{G_{tp}}\\right)^{0.5}",
        "Chain(C_0, Add(1, Mul(0.2, Add(1, Neg(x)), Pow(Mul(g, D); 0.25), Pow(Div(\\rho_l; G_{tp}); 0.5))); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "E = \\frac{1}{2} m l^2 \\dot\\theta^2 - mgl\\cos\\theta.",
        "Chain(E, Add(Mul(Div(1; 2), m, Pow(l; 2), Pow(Call(\\dot{\\theta}); 2)), Neg(Mul(m, g, l, Call(cos; Call(\\theta))))); =)",
        "RussTedrake/underactuated/book/pend.html",
    ),
    (
        "\\bm\\omega_{R/N} = \\bm\\omega_{R/R_{0}} + \\bm\\omega_{R_{0}/N} = \\bm\\omega_{R_{0}/N} = \\frac{1+e \\cos f}{1+e^{2} + 2 e \\cos f} \\dot f \\hat{\\bm\\imath}_{h}",
        "Chain(\\bm{\\omega}_{R/N}, Add(\\bm{\\omega}_{R/R_0}, \\bm{\\omega}_{R_0/N}), \\bm{\\omega}_{R_0/N}, Mul(Div(Add(1, Mul(e, Call(cos; Call(f)))); Add(1, Pow(e; 2), Mul(2, e, Call(cos; Call(f))))), Call(\\dot{f}), \\hat{\\bm{\\imath}}_h); =, =, =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/velocityPoint/_Documentation/velocityPoint.tex",
    ),
    (
        "S_2 = 2\\pi D^2 f_k\\left(\\alpha - \\alpha_1 + (0.5 - f_k)\\left(\\sin^{-1} \\left(\\frac{\\alpha-\\alpha_2}{f_k}\\right) - \\sin^{-1}\\left(\\frac{ \\alpha_1-\\alpha_2}{f_k}\\right)\\right)\\right)",
        "Chain(S_2, Mul(2, \\pi, Pow(D; 2), f_k, Add(\\alpha, Neg(\\alpha_1), Mul(Add(0.5, Neg(f_k)), Add(Call(arcsin; Div(Add(\\alpha, Neg(\\alpha_2)); f_k)), Neg(Call(arcsin; Div(Add(\\alpha_1, Neg(\\alpha_2)); f_k))))))); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\frac{d}{dt}\\left(\\dot{\\boldsymbol{r}}\\times\\boldsymbol{h} - \\mu\\frac{\\boldsymbol{r}}{r}\\right) = \\boldsymbol{0}",
        "Chain(Derivative(Add(Cross(Call(\\dot{\\boldsymbol{r}}); \\boldsymbol{h}), Neg(Mul(\\mu, Div(Call(\\boldsymbol{r}); Call(r))))); t, 1), 0; =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/the-orbit-equation.md",
    ),
    (
        "\\frac{{}_1F_1(a,b,z)}{\\Gamma(b)} = \\frac{(-z)^{-a}}{\\Gamma(b-a)} U^{*}(a,b,z) + \\frac{z^{a-b} e^z}{\\Gamma(a)} U^{*}(b-a,b,-z)",
        "Chain(Div(Call(\\prescript { } { 1 } { F } _ { 1 }; a, b, z); Call(Gamma; b)), Add(Mul(Div(Pow(Neg(z); Neg(a)); Call(Gamma; Add(b, Neg(a)))), Call(U ^ { * }; a, b, z)), Mul(Div(Mul(Pow(z; Add(a, Neg(b))), Pow(e; z)); Call(Gamma; a)), Call(U ^ { * }; Add(b, Neg(a)), b, Neg(z)))); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "0 = x^{*} - \\frac{1 - \\pi_2}{\\left\\lvert x^* + \\pi_2\\right\\rvert ^3}\\left(x^* + \\pi_2\\right) - \\frac{\\pi_2}{\\left\\lvert x^* - 1 + \\pi_2\\right\\rvert ^3}\\left(x^* - 1 + \\pi_2\\right)",
        "Chain(0, Add(x ^ { * }, Neg(Mul(Div(Add(1, Neg(\\pi_2)); Pow(Bars(Add(x ^ { * }, \\pi_2)); 3)), Add(x ^ { * }, \\pi_2))), Neg(Mul(Div(\\pi_2; Pow(Bars(Add(x ^ { * }, Neg(1), \\pi_2)); 3)), Add(x ^ { * }, Neg(1), \\pi_2)))); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/lagrange-points.md",
    ),
    (
        "\\mathbf{S} = \\mathbf{K} - \\mathbf{I}",
        "Chain(\\mathbf{S}, Add(\\mathbf{K}, Neg(\\mathbf{I})); =)",
        "Mayitzin/ahrs/ahrs/filters/famc.py",
    ),
    (
        "\\begin{split} u & = e^{-\\xi^2-s} + (1 - \\xi) e^{-s} +s+\\xi-1 \\\\ & = e^{-{(x-t)}^2-t} + (1 - x + t) e^{-t} +x-1 . \\end{split}",
        "Chain(u, Add(Pow(e; Add(Neg(Pow(\\xi; 2)), Neg(s))), Mul(Add(1, Neg(\\xi)), Pow(e; Neg(s))), s, \\xi, Neg(1)), Add(Pow(e; Add(Neg(Pow(Add(x, Neg(t)); 2)), Neg(t))), Mul(Add(1, Neg(x), t), Pow(e; Neg(t))), x, Neg(1)); =, =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "c_n = 2 \\int_0^1 t \\sin (n \\pi t) \\,dt = \\frac{2 \\, {(-1)}^{n+1}}{n \\pi} .",
        "Chain(c_n, Mul(2, Integral(Mul(t, Call(sin; Mul(n, \\pi, t))); t; 0; 1)), Div(Mul(2, Pow(Neg(1); Add(n, 1))); Mul(n, \\pi)); =, =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "r = \\sqrt{\\boldsymbol{r}\\cdot\\boldsymbol{r}}",
        "Chain(r, Sqrt(Mul(\\boldsymbol{r}, \\boldsymbol{r}; 1)); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-lagrange-coefficients-example.md",
    ),
    (
        "r = \\frac{a^2 + R^2}{2|a|}",
        "Chain(r, Div(Add(Pow(a; 2), Pow(R; 2)); Mul(2, Bars(a))); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "u(t) = K_p (q_d(t) - q(t)) + K_d (\\dot{q}_d(t) - \\dot{q}(t)) + K_i \\int_0^t (q_d(t) - q(t)) dt,",
        "Chain(Call(u; t), Add(Mul(K_p, Add(Call(q_d; t), Neg(Call(q; t)))), Mul(K_d, Add(Call(\\dot{q}_d; t), Neg(Call(\\dot{q}; t)))), Mul(K_i, Integral(Add(Call(q_d; t), Neg(Call(q; t))); t; 0; t))); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "{}^{\\mathbf{N}}\\boldsymbol{\\omega}^{\\mathbf{A}} &= 0\\\\ {}^{\\mathbf{A}}\\boldsymbol{\\omega}^{\\mathbf{B}} &= \\dot{q_1} \\mathbf{\\hat{a}_x}\\\\ {}^{\\mathbf{B}}\\boldsymbol{\\omega}^{\\mathbf{C}} &= - \\dot{q_2} \\mathbf{\\hat{b}_z}\\\\ {}^{\\mathbf{C}}\\boldsymbol{\\omega}^{\\mathbf{D}} &= \\dot{q_3} \\mathbf{\\hat{c}_y}\\\\ {}^{\\mathbf{N}}\\boldsymbol{\\omega}^{\\mathbf{D}} &= \\dot{q_1} \\mathbf{\\hat{a}_x} - \\dot{q_2} \\mathbf{\\hat{b}_z} + \\dot{q_3} \\mathbf{\\hat{c}_y}",
        "System(Chain(\\prescript { \\mathbf { N } } { } { \\boldsymbol { \\omega } } ^ { \\mathbf { A } }, 0; =), Chain(\\prescript { \\mathbf { A } } { } { \\boldsymbol { \\omega } } ^ { \\mathbf { B } }, Mul(Call(\\dot{q}_1), \\mathbf{\\hat{a}}_x); =), Chain(\\prescript { \\mathbf { B } } { } { \\boldsymbol { \\omega } } ^ { \\mathbf { C } }, Neg(Mul(Call(\\dot{q}_2), \\mathbf{\\hat{b}}_z)); =), Chain(\\prescript { \\mathbf { C } } { } { \\boldsymbol { \\omega } } ^ { \\mathbf { D } }, Mul(Call(\\dot{q}_3), \\mathbf{\\hat{c}}_y); =), Chain(\\prescript { \\mathbf { N } } { } { \\boldsymbol { \\omega } } ^ { \\mathbf { D } }, Add(Mul(Call(\\dot{q}_1), \\mathbf{\\hat{a}}_x), Neg(Mul(Call(\\dot{q}_2), \\mathbf{\\hat{b}}_z)), Mul(Call(\\dot{q}_3), \\mathbf{\\hat{c}}_y)); =))",
        "sympy/sympy/doc/src/explanation/modules/physics/vector/kinematics/kinematics.rst",
    ),
    (
        "1 + \\sum_{i=1}^p \\left(\\frac{C}{k}\\right)^i \\le 1 + \\frac{C}{k-C}",
        "Chain(Add(1, BigSum(i; 1; p; Pow(Div(C; k); i))), Add(1, Div(C; Add(k, Neg(C)))); \\le)",
        "fredrik-johansson/arb/doc/source/hypgeom.rst",
    ),
    (
        "|u_\\delta| \\leq u_{\\delta,max}",
        "Chain(Bars(u_\\delta), u_{\\delta,max}; \\le)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/cgmres_nmpc/cgmres_nmpc_main.rst",
    ),
    (
        "\\left| (x+a)(y+b) - x y \\right| \\le |xb| + |ya| + |ab|.",
        "Chain(Bars(Add(Mul(Add(x, a), Add(y, b)), Neg(Mul(x, y)))), Add(Bars(Mul(x, b)), Bars(Mul(y, a)), Bars(Mul(a, b))); \\le)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "v_{term} = v_{max} = \\sqrt{\\frac{4 g d_p (\\rho_p-\\rho_f)}{3 C_D \\rho_f }}",
        "Chain(v_{term}, v_{max}, Sqrt(Div(Mul(4, g, d_p, Add(\\rho_p, Neg(\\rho_f))); Mul(3, C_D, \\rho_f))); =, =)",
        "CalebBell/fluids/fluids/separator.py",
    ),
    (
        "\\frac{T^*}{T_0} = \\frac{2}{k+1}",
        "Chain(Div(T ^ { * }; T_0), Div(2; Add(k, 1)); =)",
        "CalebBell/fluids/fluids/compressible.py",
    ),
    (
        "\\theta_{1,0}(z,\\tau) = \\theta_2(z,\\tau), \\quad \\theta_{1,1}(z,\\tau) = i \\theta_1(z,\\tau)",
        "System(Chain(Call(\\theta_{1,0}; z, \\tau), Call(\\theta_2; z, \\tau); =), Chain(Call(\\theta_{1,1}; z, \\tau), Mul(i, Call(\\theta_1; z, \\tau)); =))",
        "fredrik-johansson/arb/doc/source/acb_modular.rst",
    ),
    (
        "M_p = \\frac{\\mu^2}{h^3}t",
        "Chain(M_p, Mul(Div(Pow(\\mu; 2); Pow(h; 3)), t); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/parabolic-trajectories.md",
    ),
    (
        "\\boldsymbol{B} = B_X\\boldsymbol{\\hat{I}} + B_Y\\boldsymbol{\\hat{J}} + B_Z\\boldsymbol{\\hat{K}}",
        "Chain(\\boldsymbol{B}, Add(Mul(B_X, \\boldsymbol{\\hat{I}}), Mul(B_Y, \\boldsymbol{\\hat{J}}), Mul(B_Z, \\boldsymbol{\\hat{K}})); =)",
        "bryanwweber/orbital-mechanics-notes/review/time-derivatives-of-moving-vectors.md",
    ),
    (
        "{\\vphantom{\\hat{\\bm s}}}^{\\mathcal{B}\\!}{\\hat{\\bm s}} = [BN] {\\vphantom{\\hat{\\bm s}}}^{\\mathcal{N}\\!}{\\hat{\\bm s}}",
        "Chain(\\prescript { \\mathcal { B } \\! } { } { \\hat { \\bm { s } } }, Mul([ B N ], \\prescript { \\mathcal { N } \\! } { } { \\hat { \\bm { s } } }); =)",
        "AVSLab/basilisk/src/simulation/sensors/coarseSunSensor/_Documentation/secModelDescription.tex",
    ),
    (
        "y' = \\sum_{k=1}^\\infty k a_k x^{k-1} .",
        "Chain(y', BigSum(k; 1; Infinity(); Mul(k, a_k, Pow(x; Add(k, Neg(1))))); =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "\\begin{array}{r} m\\ddot{q}_1= \\phantom{-}F\\\\ m\\ddot{q}_2= -F\\\\ m\\ddot{q}_3 + mg = \\phantom{-}0\\\\ \\ddot{q}_1 - \\ddot{q}_2\\!\\! = \\phantom{-}0 \\end{array}",
        "System(Chain(Mul(m, Call(\\ddot{q}_1)), F; =), Chain(Mul(m, Call(\\ddot{q}_2)), Neg(F); =), Chain(Add(Mul(m, Call(\\ddot{q}_3)), Mul(m, g)), 0; =), Chain(Add(Call(\\ddot{q}_1), Neg(Call(\\ddot{q}_2))), 0; =))",
        "moorepants/learn-multibody-dynamics/lagrange.rst",
    ),
    (
        "\\bar{p}_1 = 23 \\hat{n}_x - 12 \\hat{n}_y \\\\ \\bar{p}_2 = 16 \\hat{n}_x + 2 \\hat{n}_y - 4 \\hat{n}_z \\\\ \\bar{p}_3 = \\hat{n}_x + 14 \\hat{n}_z",
        "System(Chain(\\bar{p}_1, Add(Mul(23, \\hat{n}_x), Neg(Mul(12, \\hat{n}_y))); =), Chain(\\bar{p}_2, Add(Mul(16, \\hat{n}_x), Mul(2, \\hat{n}_y), Neg(Mul(4, \\hat{n}_z))); =), Chain(\\bar{p}_3, Add(\\hat{n}_x, Mul(14, \\hat{n}_z)); =))",
        "moorepants/learn-multibody-dynamics/vectors.rst",
    ),
    (
        "f(t) = \\sum_{n=1}^\\infty c_n \\sin (n \\pi t) .",
        "Chain(Call(f; t), BigSum(n; 1; Infinity(); Mul(c_n, Call(sin; Mul(n, \\pi, t)))); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\mathbf{q}_{am} = \\frac{1}{4} \\Big(\\mathbf{W}_a + \\mathbf{I}_4\\Big) \\Big(\\mathbf{W}_m + \\mathbf{I}_4\\Big) \\mathbf{q}_{t-1}",
        "Chain(\\mathbf{q}_{am}, Mul(Div(1; 4), Add(\\mathbf{W}_a, \\mathbf{I}_4), Add(\\mathbf{W}_m, \\mathbf{I}_4), \\mathbf{q}_{t-1}); =)",
        "Mayitzin/ahrs/ahrs/filters/fkf.py",
    ),
    (
        "v_f = v_i + v_r \\ln \\frac{M_i}{M_f} - gt_f = v_i + v_r \\ln \\left(1+\\frac{|\\Delta M|}{M_f}\\right) - gt_f",
        "Chain(v_f, Add(v_i, Mul(v_r, Call(ln; Div(M_i; M_f))), Neg(Mul(g, t_f))), Add(v_i, Mul(v_r, Call(ln; Add(1, Div(Bars(\\Delta M); M_f)))), Neg(Mul(g, t_f))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "\\mathbf{R}_X(\\theta) = \\begin{bmatrix} 1 & 0 & 0 \\\\ 0 & \\cos \\theta & -\\sin \\theta \\\\ 0 & \\sin \\theta & \\cos \\theta \\end{bmatrix}",
        "Chain(Call(\\mathbf{R}_X; \\theta), MatrixOf(1, 0, 0, 0, Call(cos; \\theta), Neg(Call(sin; \\theta)), 0, Call(sin; \\theta), Call(cos; \\theta)); =)",
        "Mayitzin/ahrs/ahrs/common/dcm.py",
    ),
    (
        "1 = \\frac{1 - \\pi_2}{\\sigma_3} + \\frac{\\pi_2}{\\psi^3}",
        "Chain(1, Add(Div(Add(1, Neg(\\pi_2)); \\sigma_3), Div(\\pi_2; Pow(\\psi; 3))); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/lagrange-points.md",
    ),
    (
        "\\boldsymbol{h} = \\boldsymbol{r}_0 \\times\\boldsymbol{v}_0 = \\boldsymbol{\\hat{w}}\\left(x_0\\dot{y}_0 - y_0\\dot{x}_0\\right)",
        "Chain(\\boldsymbol{h}, Cross(\\boldsymbol{r}_0; \\boldsymbol{v}_0), Mul(\\boldsymbol{\\hat{w}}, Add(Mul(Call(x_0), Call(\\dot{y}_0)), Neg(Mul(Call(y_0), Call(\\dot{x}_0))))); =, =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/the-lagrange-coefficients.md",
    ),
    (
        "\\ddot{q}_d = \\ddot{q}_0(t) + K_p(q_0(t) - q) + K_d(\\dot{q}_0(t) - \\dot{q}).",
        "Chain(Call(\\ddot{q}_d), Add(Call(\\ddot{q}_0; t), Mul(K_p, Add(Call(q_0; t), Neg(Call(q)))), Mul(K_d, Add(Call(\\dot{q}_0; t), Neg(Call(\\dot{q}))))); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "\\epsilon_2 = \\sqrt{1 + \\frac{\\Delta P}{P_2}} - (0.41 + 0.35\\beta^4) \\frac{\\Delta P}{\\kappa P_2 \\sqrt{1 + \\frac{\\Delta P}{P_2}}}",
        "Chain(\\epsilon_2, Add(Sqrt(Add(1, Div(\\Delta P; P_2))), Neg(Mul(Add(0.41, Mul(0.35, Pow(\\beta; 4))), Div(\\Delta P; Mul(\\kappa, P_2, Sqrt(Add(1, Div(\\Delta P; P_2)))))))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "f(x) := \\dfrac{1}{\\beta} \\exp \\left( -\\dfrac{x-\\mu}{\\beta} - \\exp \\left( -\\dfrac{x - \\mu}{\\beta} \\right) \\right)",
        "Chain(Call(f; x), Mul(Div(1; \\beta), Call(exp; Add(Neg(Div(Add(x, Neg(\\mu)); \\beta)), Neg(Call(exp; Neg(Div(Add(x, Neg(\\mu)); \\beta))))))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "\\dot x &= v \\cos \\theta, \\\\ \\dot y &= v \\sin \\theta, \\\\ \\dot \\theta &= u.",
        "System(Chain(Call(\\dot{x}), Mul(v, Call(cos; Call(\\theta))); =), Chain(Call(\\dot{y}), Mul(v, Call(sin; Call(\\theta))); =), Chain(Call(\\dot{\\theta}), u; =))",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "m a = F",
        "Chain(Mul(m, a), F; =)",
        "sympy/sympy/doc/src/modules/physics/units/examples.rst",
    ),
    (
        "b_n \\bigl(2 - n^2 \\pi^2\\bigr) = \\frac{2\\,{(-1)}^{n+1}}{n \\pi}",
        "Chain(Mul(b_n, Add(2, Neg(Mul(Pow(n; 2), Pow(\\pi; 2))))), Div(Mul(2, Pow(Neg(1); Add(n, 1))); Mul(n, \\pi)); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\begin{aligned} a &= e_i p_f - e_f p_i \\cos\\eta & b &= -e_f p_i \\sin\\eta & c &= p_i - p_f \\end{aligned}",
        "System(Chain(a, Add(Mul(e_i, p_f), Neg(Mul(e_f, p_i, Call(cos; \\eta)))); =), Chain(b, Neg(Mul(e_f, p_i, Call(sin; \\eta))); =), Chain(c, Add(p_i, Neg(p_f)); =))",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/apse-line-rotation-example.md",
    ),
    (
        "\\xi = m + n - p \\\\ \\delta = m + n - \\frac{p + q}{2}",
        "System(Chain(\\xi, Add(m, n, Neg(p)); =), Chain(\\delta, Add(m, n, Neg(Div(Add(p, q); 2))); =))",
        "sympy/sympy/doc/src/modules/integrals/g-functions.rst",
    ),
    (
        "\\boldsymbol{\\hat{h}} = \\frac{\\boldsymbol{h}}{h}",
        "Chain(\\boldsymbol{\\hat{h}}, Div(\\boldsymbol{h}; h); =)",
        "bryanwweber/orbital-mechanics-notes/constants-of-orbital-motion/orbital-plane-and-keplers-second-law.md",
    ),
    (
        "\\eta_p = \\frac{\\left(\\frac{n}{n-1}\\right)}{\\left(\\frac{k}{k-1} \\right)} = \\frac{n(k-1)}{k(n-1)}",
        "Chain(\\eta_p, Div(Div(n; Add(n, Neg(1))); Div(k; Add(k, Neg(1)))), Div(Mul(n, Add(k, Neg(1))); Mul(k, Add(n, Neg(1)))); =, =)",
        "CalebBell/fluids/fluids/compressible.py",
    ),
    (
        "c_0 = 2 \\int_0^1 t \\,dt = 1 ,",
        "Chain(c_0, Mul(2, Integral(t; t; 0; 1)), 1; =, =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\Pi = \\Omega + \\omega",
        "Chain(\\Pi, Add(\\Omega, \\omega); =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/classical-orbital-elements.md",
    ),
    (
        "\\left| \\sqrt{x+a} - \\sqrt{x} \\right| \\le \\sqrt{x} \\left(1 - \\sqrt{1-\\frac{|a|}{x}}\\right) \\le \\frac{\\sqrt{x}}{2} \\left(\\frac{|a|}{x} + \\frac{|a|^2}{x^2}\\right)",
        "Chain(Bars(Add(Sqrt(Add(x, a)), Neg(Sqrt(x)))), Mul(Sqrt(x), Add(1, Neg(Sqrt(Add(1, Neg(Div(Bars(a); x))))))), Mul(Div(Sqrt(x); 2), Add(Div(Bars(a); x), Div(Pow(Bars(a); 2); Pow(x; 2)))); \\le, \\le)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "\\boldsymbol{\\hat{w}} = \\frac{\\boldsymbol{h}}{h}",
        "Chain(\\boldsymbol{\\hat{w}}, Div(\\boldsymbol{h}; h); =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/perifocal-frame.md",
    ),
    (
        "[G_{s}]{\\bf u}_{s} = -{\\bf L}_{r}",
        "Chain(Mul([ G _ { s } ], \\mathbf{u}_s), Neg(\\mathbf{L}_r); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attControl/mrpFeedback/mrpFeedback.rst",
    ),
    (
        "\\Delta H = \\frac{V^2}{2}",
        "Chain(\\Delta H, Div(Pow(V; 2); 2); =)",
        "CalebBell/fluids/fluids/compressible.py",
    ),
    (
        "y = \\underbrace{(C_1 + C_2 x + C_3 x^2)\\, e^x}_{\\text{terms coming from } r=1} + \\underbrace{C_4}_{\\text{from } r=0} .",
        "Chain(y, Add(Mul(Add(C_1, Mul(C_2, x), Mul(C_3, Pow(x; 2))), Pow(e; x)), C_4); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "f(x) = \\sum_{n=1}^\\infty b_n \\sin (n \\pi x) .",
        "Chain(Call(f; x), BigSum(n; 1; Infinity(); Mul(b_n, Call(sin; Mul(n, \\pi, x)))); =)",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "\\xi = 0, \\eta = f(y)",
        "System(Chain(\\xi, 0; =), Chain(\\eta, Call(f; y); =))",
        "sympy/sympy/sympy/solvers/ode/lie_group.py",
    ),
    (
        "S_{n,j,k} &=& \\phi_{n,j}\\,\\phi_{n,k}\\,\\left[S_{n-1,j,k} + D_{n-1,n-1}\\,\\tilde{W}_{n-1,j}\\,\\tilde{W}_{n-1,k}\\right] \\\\ D_{n,n} &=& A_{n,n} - \\sum_{j=1}^{2\\,J}\\sum_{k=1}^{2\\,J} \\tilde{U}_{n,j}\\,S_{n,j,k}\\,\\tilde{U}_{n,k} \\\\ \\tilde{W}_{n,j} &=& \\frac{1}{D_{n,n}}\\left[ \\tilde{V}_{n,j} - \\sum_{k=1}^{2\\,J}\\tilde{U}_{n,k}\\,S_{n,j,k} \\right] \\quad.",
        "System(Chain(S_{n,j,k}, Mul(\\phi_{n,j}, \\phi_{n,k}, Add(S_{n-1,j,k}, Mul(D_{n-1,n-1}, \\tilde{W}_{n-1,j}, \\tilde{W}_{n-1,k}))); =), Chain(D_{n,n}, Add(A_{n,n}, Neg(BigSum(j; 1; Mul(2, J); BigSum(k; 1; Mul(2, J); Mul(\\tilde{U}_{n,j}, S_{n,j,k}, \\tilde{U}_{n,k}))))); =), Chain(\\tilde{W}_{n,j}, Mul(Div(1; D_{n,n}), Add(\\tilde{V}_{n,j}, Neg(BigSum(k; 1; Mul(2, J); Mul(\\tilde{U}_{n,k}, S_{n,j,k}))))); =))",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\boldsymbol{\\alpha} = \\frac{d\\boldsymbol{\\omega}}{dt}",
        "Chain(\\boldsymbol{\\alpha}, Derivative(Call(\\boldsymbol{\\omega}); t, 1); =)",
        "bryanwweber/orbital-mechanics-notes/review/time-derivatives-of-moving-vectors.md",
    ),
    (
        "\\mathbf{M} = \\mathbf{R}^T\\mathbf{M}_0\\mathbf{R}",
        "Chain(\\mathbf{M}, Mul(Transpose(\\mathbf{R}), \\mathbf{M}_0, \\mathbf{R}); =)",
        "Mayitzin/ahrs/ahrs/filters/mahony.py",
    ),
    (
        "\\frac{\\boldsymbol{r}}{r} + \\boldsymbol{e} = \\frac{\\dot{\\boldsymbol{r}}\\times\\boldsymbol{h}}{\\mu}",
        "Chain(Add(Div(Call(\\boldsymbol{r}); Call(r)), \\boldsymbol{e}), Div(Cross(Call(\\dot{\\boldsymbol{r}}); \\boldsymbol{h}); \\mu); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/the-orbit-equation.md",
    ),
    (
        "\\dot{x}_0 =& -x_0 - 2x_1^2 \\\\ \\dot{x}_1 =& -x_1 - x_0 x_1 - 2x_1^3,",
        "System(Chain(Call(\\dot{x}_0), Add(Neg(Call(x_0)), Neg(Mul(2, Pow(Call(x_1); 2)))); =), Chain(Call(\\dot{x}_1), Add(Neg(Call(x_1)), Neg(Mul(Call(x_0), Call(x_1))), Neg(Mul(2, Pow(Call(x_1); 3)))); =))",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "\\rho \\frac{\\partial^2 \\eta}{\\partial t^2} - T\\frac{\\partial^2 \\eta}{\\partial x^2} = 0",
        "Chain(Add(Mul(\\rho, Derivative(Call(\\eta); t, 2; True)), Neg(Mul(T, Derivative(Call(\\eta); x, 2; True)))), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\boldsymbol{r} = \\frac{h^2}{\\mu}\\frac{1}{1 + e\\cos\\nu}\\left(\\cos\\nu\\boldsymbol{\\hat{p}} + \\sin\\nu\\boldsymbol{\\hat{q}}\\right)",
        "Chain(\\boldsymbol{r}, Mul(Div(Pow(h; 2); \\mu), Div(1; Add(1, Mul(e, Call(cos; \\nu)))), Add(Mul(Call(cos; \\nu), \\boldsymbol{\\hat{p}}), Mul(Call(sin; \\nu), \\boldsymbol{\\hat{q}}))); =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/perifocal-frame.md",
    ),
    (
        "0 = x^2 - \\frac{1}{4}x^2\\left[\\frac{\\partial J^*}{\\partial x}\\right]^2 + \\frac{\\partial J^*}{\\partial x} f_1(x).",
        "Chain(0, Add(Pow(x; 2), Neg(Mul(Div(1; 4), Pow(x; 2), Pow(Derivative(Call(J ^ { * }); x, 1; True); 2))), Mul(Derivative(Call(J ^ { * }); x, 1; True), Call(f_1; x))); =)",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "\\vec{x} = \\begin{bmatrix} 2 t + \\frac{1}{\\sqrt{3}} \\sin ( \\sqrt{3} \\, t ) \\\\ 2 t - \\frac{2}{\\sqrt{3}} \\sin ( \\sqrt{3} \\, t ) \\end{bmatrix} .",
        "Chain(\\vec{x}, MatrixOf(Add(Mul(2, t), Mul(Div(1; Sqrt(3)), Call(sin; Mul(Sqrt(3), t)))), Add(Mul(2, t), Neg(Mul(Div(2; Sqrt(3)), Call(sin; Mul(Sqrt(3), t)))))); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\dot{x} = v s \\cos(\\phi)",
        "Chain(Call(\\dot{x}), Mul(v, s, Call(cos; \\phi)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/extended_kalman_filter_localization_files/extended_kalman_filter_localization_main.rst",
    ),
    (
        "x'' + 2 x = F(t) ,",
        "Chain(Add(x'', Mul(2, x)), Call(F; t); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "k_\\mathrm{true} (\\tau) = A\\, \\exp\\left(-\\frac{\\tau^2}{2\\,\\lambda^2}\\right)\\, \\cos\\left(\\frac{2\\,\\pi\\,\\tau}{P_\\mathrm{true}}\\right)",
        "Chain(Call(k_{true}; \\tau), Mul(A, Call(exp; Neg(Div(Pow(\\tau; 2); Mul(2, Pow(\\lambda; 2))))), Call(cos; Div(Mul(2, \\pi, \\tau); P_{true}))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "m \\ddot{\\boldsymbol{r}} = \\boldsymbol{F}_p + \\boldsymbol{F}_s",
        "Chain(Mul(m, Call(\\ddot{\\boldsymbol{r}})), Add(\\boldsymbol{F}_p, \\boldsymbol{F}_s); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/sphere-of-influence.md",
    ),
    (
        "\\begin{aligned} a_t &= \\dot{v} = \\ddot{s} \\\\ a_n &= \\frac{v^2}{\\rho} \\end{aligned}",
        "System(Chain(a_t, Call(\\dot{v}), Call(\\ddot{s}); =, =), Chain(a_n, Div(Pow(Call(v); 2); \\rho); =))",
        "bryanwweber/orbital-mechanics-notes/review/kinematics.md",
    ),
    (
        "\\varepsilon = \\frac{1}{2}\\frac{\\mu^2}{h^2}\\left(1 - e^2\\right)",
        "Chain(\\varepsilon, Mul(Div(1; 2), Div(Pow(\\mu; 2); Pow(h; 2)), Add(1, Neg(Pow(e; 2)))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-lagrange-coefficients-example.md",
    ),
    (
        "T = \\frac12 m(\\dot{r}^2 + r^2 \\dot{\\theta}^2) + \\frac12 M\\dot{r}^2,\\quad V = Mg(r-l)",
        "System(Chain(T, Add(Mul(Div(1; 2), m, Add(Pow(Call(\\dot{r}); 2), Mul(Pow(Call(r); 2), Pow(Call(\\dot{\\theta}); 2)))), Mul(Div(1; 2), M, Pow(Call(\\dot{r}); 2))); =), Chain(V, Mul(M, g, Add(Call(r), Neg(l))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "Z(h) = e^{i\\theta(h)} \\zeta(1/2+ih).",
        "Chain(Call(Z; h), Mul(Pow(e; Mul(i, Call(\\theta; h))), Call(\\zeta; Add(Div(1; 2), Mul(i, h)))); =)",
        "fredrik-johansson/arb/doc/source/arb_poly.rst",
    ),
    (
        "\\frac{di(t)}{dt} = -\\frac{R}{L} i(t) - \\frac{1}{L} v_C(t) + \\frac{1}{L} v_{in}(t)",
        "Chain(Derivative(Call(i; t); t, 1), Add(Neg(Mul(Div(R; L), Call(i; t))), Neg(Mul(Div(1; L), Call(v_C; t))), Mul(Div(1; L), Call(v_{in}; t))); =)",
        "sympy/sympy/doc/src/tutorials/physics/control/electrical_problems.rst",
    ),
    (
        "\\cos\\eta = -\\frac{1}{e}",
        "Chain(Call(cos; \\eta), Neg(Div(1; e)); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-depahture-trajectory.md",
    ),
    (
        "t = \\sqrt{\\frac{\\mu a^3}{|\\alpha|}} (e\\sinh \\xi-\\xi)",
        "Chain(t, Mul(Sqrt(Div(Mul(\\mu, Pow(a; 3)); Bars(\\alpha))), Add(Mul(e, Call(sinh; \\xi)), Neg(\\xi))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "I_{ab} := \\bar{I}_{a} \\cdot \\hat{n}_b",
        "Chain(I_{ab}, Mul(\\bar{I}_a, \\hat{n}_b; 1); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "E = M_e + \\sum_{n = 1}^{\\infty}a_n e^n",
        "Chain(E, Add(M_e, BigSum(n; 1; Infinity(); Mul(a_n, Pow(e; n)))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "\\ddot{\\boldsymbol{\\rho}} = \\left(\\ddot{x}^* - 2\\dot{y}^* - x^*\\right)\\boldsymbol{\\hat{\\imath}} + \\left(\\ddot{y}^* + 2\\dot{x}^* - y^*\\right)\\boldsymbol{\\hat{\\jmath}} + \\ddot{z}^*\\boldsymbol{\\hat{k}}",
        "Chain(Call(\\ddot{\\boldsymbol{\\rho}}), Add(Mul(Add(Call(\\ddot { x } ^ { * }), Neg(Mul(2, Call(\\dot { y } ^ { * }))), Neg(Call(x ^ { * }))), \\boldsymbol{\\hat{\\imath}}), Mul(Add(Call(\\ddot { y } ^ { * }), Mul(2, Call(\\dot { x } ^ { * })), Neg(Call(y ^ { * }))), \\boldsymbol{\\hat{\\jmath}}), Mul(Call(\\ddot { z } ^ { * }), \\boldsymbol{\\hat{k}})); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "x^{1/k} - (x-r)^{1/k} &= x^{1/k} [1 - (1-r/x)^{1/k}]",
        "Chain(Add(Pow(x; Div(1; k)), Neg(Pow(Add(x, Neg(r)); Div(1; k)))), Mul(Pow(x; Div(1; k)), Add(1, Neg(Pow(Add(1, Neg(Div(r; x))); Div(1; k))))); =)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "\\begin{bmatrix}u\\\\ v\\end{bmatrix} = \\frac{f}{z}\\begin{bmatrix}x\\\\y\\end{bmatrix}",
        "Chain(MatrixOf(u, v), Mul(Div(f; z), MatrixOf(x, y)); =)",
        "AVSLab/basilisk/src/simulation/navigation/pinholeCamera/pinholeCamera.rst",
    ),
    (
        "\\dot{y} = v s \\sin(\\phi)",
        "Chain(Call(\\dot{y}), Mul(v, s, Call(sin; \\phi)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/extended_kalman_filter_localization_files/extended_kalman_filter_localization_main.rst",
    ),
    (
        "\\frac{p_s}{a_p} < \\frac{P_p}{A_s}",
        "Chain(Div(p_s; a_p), Div(P_p; A_s); <)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/sphere-of-influence.md",
    ),
    (
        "\\ddot{\\tilde{z}} + k_d \\dot{\\tilde{z}} + k_p \\tilde{z} = 0,",
        "Chain(Add(Call(\\ddot{\\tilde{z}}), Mul(k_d, Call(\\dot{\\tilde{z}})), Mul(k_p, Call(\\tilde{z}))), 0; =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "M_e = \\frac{\\mu^2}{h^3} t \\left(1 - e^2\\right)^{3/2}",
        "Chain(M_e, Mul(Div(Pow(\\mu; 2); Pow(h; 3)), t, Pow(Add(1, Neg(Pow(e; 2))); Div(3; 2))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "x' = e^{\\lambda x} F(x,y)",
        "Chain(x', Mul(Pow(e; Mul(\\lambda, x)), Call(F; x, y)); =)",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "N = \\frac{\\cos \\alpha}{\\sin \\beta} mg",
        "Chain(N, Mul(Div(Call(cos; \\alpha); Call(sin; \\beta)), m, g); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise2.tex",
    ),
    (
        "\\log(10) = 46 \\operatorname{atanh}(1/31) + 34 \\operatorname{atanh}(1/49) + 20 \\operatorname{atanh}(1/161)",
        "Chain(Call(log; 10), Add(Mul(46, Call(atanh; Div(1; 31))), Mul(34, Call(atanh; Div(1; 49))), Mul(20, Call(atanh; Div(1; 161)))); =)",
        "fredrik-johansson/arb/doc/source/constants.rst",
    ),
    (
        "\\mathbf{v}_t = \\mathbf{z}_t - \\bar{\\mathbf{z}}",
        "Chain(\\mathbf{v}_t, Add(\\mathbf{z}_t, Neg(\\bar{\\mathbf{z}})); =)",
        "Mayitzin/ahrs/ahrs/filters/ukf.py",
    ),
    (
        "\\begin{aligned}\\boldsymbol{r}_0 &= 7000.0\\boldsymbol{\\hat{\\imath}} - 12124\\boldsymbol{\\hat{\\jmath}}\\\\\\boldsymbol{v}_0 &= 2.6679\\boldsymbol{\\hat{\\imath}} + 4.6210\\boldsymbol{\\hat{\\jmath}}\\end{aligned}",
        "System(Chain(\\boldsymbol{r}_0, Add(Mul(7000.0, \\boldsymbol{\\hat{\\imath}}), Neg(Mul(12124, \\boldsymbol{\\hat{\\jmath}}))); =), Chain(\\boldsymbol{v}_0, Add(Mul(2.6679, \\boldsymbol{\\hat{\\imath}}), Mul(4.6210, \\boldsymbol{\\hat{\\jmath}})); =))",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-lagrange-coefficients-example.md",
    ),
    (
        "\\ddot{\\bm{r}}_{M/N} = \\ddot{\\bm{r}}_{B/N} + \\ddot{\\bm{r}}_{M/B}",
        "Chain(Call(\\ddot{\\bm{r}}_{M/N}), Add(Call(\\ddot{\\bm{r}}_{B/N}), Call(\\ddot{\\bm{r}}_{M/B})); =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "\\bar{u} = u_1\\hat{b}_x + u_2\\hat{b}_y + u_3\\hat{b}_z",
        "Chain(\\bar{u}, Add(Mul(u_1, \\hat{b}_x), Mul(u_2, \\hat{b}_y), Mul(u_3, \\hat{b}_z)); =)",
        "moorepants/learn-multibody-dynamics/angular.rst",
    ),
    (
        "f_c(b_i) = k_c \\left( \\frac{b_{i-1} - b_i}{\\|b_{i-1} - b_i\\|} + \\frac{b_{i+1} - b_i}{\\|b_{i+1} - b_i\\|} \\right)",
        "Chain(Call(f_c; b_i), Mul(k_c, Add(Div(Add(b_{i-1}, Neg(b_i)); Norm(Add(b_{i-1}, Neg(b_i)))), Div(Add(b_{i+1}, Neg(b_i)); Norm(Add(b_{i+1}, Neg(b_i)))))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/elastic_bands/elastic_bands_main.rst",
    ),
    (
        "y(t) = b_0+b_1t+b_2t^2+b_3t^3+b_4t^4+b_5t^5",
        "Chain(Call(y; t), Add(b_0, Mul(b_1, t), Mul(b_2, Pow(t; 2)), Mul(b_3, Pow(t; 3)), Mul(b_4, Pow(t; 4)), Mul(b_5, Pow(t; 5))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/quintic_polynomials_planner/quintic_polynomials_planner_main.rst",
    ),
    (
        "\\nu = \\cos^{-1}\\left(\\frac{\\boldsymbol{e}\\cdot\\boldsymbol{r}}{e r}\\right)",
        "Chain(\\nu, Call(arccos; Div(Mul(\\boldsymbol{e}, \\boldsymbol{r}; 1); Mul(e, r))); =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/orbital-elements-and-the-state-vector.md",
    ),
    (
        "\\begin{cases} \\displaystyle v_1^+ = \\frac{(m_1-\\chi m_2)v_1^-+m_2(1+\\chi)v_2^-}{m_1+m_2} \\\\[1.5ex] \\displaystyle v_2^+ = \\frac{m_1(1+\\chi)v_1^-+(m_2-\\chi m_1)v_2^-}{m_1+m_2} \\end{cases}",
        "System(Chain(v _ { 1 } ^ { + }, Div(Add(Mul(Add(m_1, Neg(Mul(\\chi, m_2))), v _ { 1 } ^ { - }), Mul(m_2, Add(1, \\chi), v _ { 2 } ^ { - })); Add(m_1, m_2)); =), Chain(v _ { 2 } ^ { + }, Div(Add(Mul(m_1, Add(1, \\chi), v _ { 1 } ^ { - }), Mul(Add(m_2, Neg(Mul(\\chi, m_1))), v _ { 2 } ^ { - })); Add(m_1, m_2)); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "{}^N\\bar{v}^{G} = 0",
        "Chain(\\prescript { N } { } { \\bar { v } } ^ { G }, 0; =)",
        "moorepants/learn-multibody-dynamics/motion.rst",
    ),
    (
        "K = \\cos^{-1} M + M^3\\cosh^{-1} \\frac{1}{M} - 2M\\sqrt{1 - M^2}",
        "Chain(K, Add(Call(arccos; M), Mul(Pow(M; 3), Call(arcosh; Div(1; M))), Neg(Mul(2, M, Sqrt(Add(1, Neg(Pow(M; 2))))))); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\left|\\det \\boldsymbol{M}\\right| = 1",
        "Chain(Bars(Call(det; \\boldsymbol{M})), 1; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "c_2 e^{x} + 2 c_3 e^{2x} = 0 .",
        "Chain(Add(Mul(c_2, Pow(e; x)), Mul(2, c_3, Pow(e; Mul(2, x)))), 0; =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "x = x(t) = \\cos t + \\sin t",
        "Chain(Call(x), Call(x; t), Add(Call(cos; t), Call(sin; t)); =, =)",
        "jirilebl/diffyqs/ch-intro.tex",
    ),
    (
        "u = \\underbrace{k_p(x_d-x) - k_d\\dot{x}}_{\\text{feedback force for position control}} - \\underbrace{f^{F_c}_{desired}}_{\\text{feedforward force}}",
        "Chain(u, Add(Mul(k_p, Add(x_d, Neg(Call(x)))), Neg(Mul(k_d, Call(\\dot{x}))), Neg(f _ { d e s i r e d } ^ { F _ { c } })); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "r =\\sqrt{R^2 - \\frac{m_\\text{fuel}}{2\\,\\pi\\,\\rho\\,h}}",
        "Chain(r, Sqrt(Add(Pow(R; 2), Neg(Div(m_{fuel}; Mul(2, \\pi, \\rho, h))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "v_1(t) = x_1(t)",
        "Chain(Call(v_1; t), Call(x_1; t); =)",
        "sympy/sympy/doc/src/tutorials/physics/control/electrical_problems.rst",
    ),
    (
        "a = \\frac{18\\mu_f}{D^2\\rho_p}",
        "Chain(a, Div(Mul(18, \\mu_f); Mul(Pow(D; 2), \\rho_p)); =)",
        "CalebBell/fluids/fluids/drag.py",
    ),
    (
        "\\begin{aligned} t_{\\text{wait}} &= \\frac{-2\\gamma_2 - 2\\pi N}{n_f - n_i} &&\\text{if } n_i > n_f \\\\ t_{\\text{wait}} &= \\frac{-2\\gamma_2 + 2\\pi N}{n_f - n_i} &&\\text{if } n_i < n_f \\end{aligned}",
        "System(Implies(Chain(n_i, n_f; >); Chain(t_{wait}, Div(Add(Neg(Mul(2, \\gamma_2)), Neg(Mul(2, \\pi, N))); Add(n_f, Neg(n_i))); =)), Implies(Chain(n_i, n_f; <); Chain(t_{wait}, Div(Add(Neg(Mul(2, \\gamma_2)), Mul(2, \\pi, N)); Add(n_f, Neg(n_i))); =)))",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/interplanetary-transfer-phasing.md",
    ),
    (
        "X(t) = Y(tau)",
        "Chain(Call(X; t), Call(Y; \\tau); =)",
        "sympy/sympy/sympy/solvers/ode/systems.py",
    ),
    (
        "\\mathbf{\\hat{n}_v} = \\frac{\\mathbf{v}}{\\Vert \\mathbf{v} \\Vert}",
        "Chain(\\mathbf{\\hat{n}}_v, Div(\\mathbf{v}; Norm(\\mathbf{v})); =)",
        "sympy/sympy/doc/src/explanation/modules/physics/vector/vectors/vectors.rst",
    ),
    (
        "p(x) = 1 + (1-2x)^2 + x^2,",
        "Chain(Call(p; x), Add(1, Pow(Add(1, Neg(Mul(2, x))); 2), Pow(x; 2)); =)",
        "RussTedrake/underactuated/book/optimization.html",
    ),
    (
        "\\dot{\\mathbf{q}} = \\frac{1}{2}\\boldsymbol\\Omega(\\boldsymbol\\omega)\\mathbf{q}",
        "Chain(Call(\\dot{\\mathbf{q}}), Mul(Div(1; 2), Call(\\boldsymbol{\\Omega}; \\boldsymbol{\\omega}), Call(\\mathbf{q})); =)",
        "Mayitzin/ahrs/ahrs/filters/angular.py",
    ),
    (
        "x''(t) = 2a_2+6a_3t+12a_4t^2",
        "Chain(Call(x''; t), Add(Mul(2, a_2), Mul(6, a_3, t), Mul(12, a_4, Pow(t; 2))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/quintic_polynomials_planner/quintic_polynomials_planner_main.rst",
    ),
    (
        "T=& \\frac{1}{2} (m_c + m_p)\\dot{x}^2 + m_p \\dot{x}\\dot\\theta l \\cos{\\theta} + \\frac{1}{2}m_p l^2 \\dot\\theta^2 \\\\ U =& -m_p g l \\cos\\theta.",
        "System(Chain(T, Add(Mul(Div(1; 2), Add(m_c, m_p), Pow(Call(\\dot{x}); 2)), Mul(m_p, Call(\\dot{x}), Call(\\dot{\\theta}), l, Call(cos; Call(\\theta))), Mul(Div(1; 2), m_p, Pow(l; 2), Pow(Call(\\dot{\\theta}); 2))); =), Chain(U, Neg(Mul(m_p, g, l, Call(cos; Call(\\theta)))); =))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "f^{B}_{2, B_z} = f^{B}_{1, B_z} + \\frac{mgh}{l}\\sin\\gamma.",
        "Chain(f _ { 2 , B _ { z } } ^ { B }, Add(f _ { 1 , B _ { z } } ^ { B }, Mul(Div(Mul(m, g, h); l), Call(sin; \\gamma))); =)",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "I_{s_{i2,2}} ( \\dot\\omega_{s_{i2,2}} + \\ddot\\theta_{i1} + \\ddot\\theta_{i2}) = - (I_{s_{i2,1}} - I_{s_{i2,3}}) \\omega_{s_{i2,3}} \\omega_{s_{i2,1}} + L_{s_{i2,2}}",
        "Chain(Mul(I_{s_i2,2}, Add(Call(\\dot{\\omega}_{s_i2,2}), Call(\\ddot{\\theta}_{i1}), Call(\\ddot{\\theta}_{i2}))), Add(Neg(Mul(Add(I_{s_i2,1}, Neg(I_{s_i2,3})), \\omega_{s_i2,3}, \\omega_{s_i2,1})), L_{s_i2,2}); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "[RN] = [B_cN][BN]",
        "Chain([ R N ], Mul([ B _ { c } N ], [ B N ]); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/attRefCorrection/attRefCorrection.rst",
    ),
    (
        "\\frac{da}{dt} &= \\left( \\frac{1}{\\tau_a \\left(1 + 3a(t)\\right)} (1 + 2f) + \\frac{1 + 3a(t)}{4\\tau_d} (1 - 2f) \\right) \\left(e(t) - a(t) \\right) \\\\ f &= \\frac{1}{2} \\tanh{\\left(b \\left(e(t) -a(t)\\right)\\right)}",
        "System(Chain(Derivative(Call(a); t, 1), Mul(Add(Mul(Div(1; Mul(\\tau_a, Add(1, Mul(3, Call(a; t))))), Add(1, Mul(2, f))), Mul(Div(Add(1, Mul(3, Call(a; t))); Mul(4, \\tau_d)), Add(1, Neg(Mul(2, f))))), Add(Call(e; t), Neg(Call(a; t)))); =), Chain(f, Mul(Div(1; 2), Call(tanh; Mul(b, Add(Call(e; t), Neg(Call(a; t)))))); =))",
        "sympy/sympy/doc/src/explanation/modules/physics/biomechanics/biomechanics.rst",
    ),
    (
        "v_{gm} = 1.41\\left[\\frac{g\\sigma(\\rho_l-\\rho_g)}{\\rho_l^2}\\right]^{0.25}",
        "Chain(v_{gm}, Mul(1.41, Pow(Div(Mul(g, \\sigma, Add(\\rho_l, Neg(\\rho_g))); Pow(\\rho_l; 2)); 0.25)); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "c_2 = s_0 - \\frac{r_P}{\\sin(f_2)}",
        "Chain(c_2, Add(s_0, Neg(Div(r_P; Call(sin; f_2)))); =)",
        "AVSLab/basilisk/src/simulation/environment/eclipse/eclipse.rst",
    ),
    (
        "\\left| I - \\sum_{k=0}^{n-1} w_k f(x_k) \\right| \\le \\frac{64 M}{15 (\\rho-1) \\rho^{2n-1}}",
        "Chain(Bars(Add(I, Neg(BigSum(k; 0; Add(n, Neg(1)); Mul(w_k, Call(f; x_k)))))), Div(Mul(64, M); Mul(15, Add(\\rho, Neg(1)), Pow(\\rho; Add(Mul(2, n), Neg(1))))); \\le)",
        "fredrik-johansson/arb/doc/source/acb_calc.rst",
    ),
    (
        "\\frac{dx}{dt} + x = \\underbrace{(-\\sin t + \\cos t - e^{-t})}_{\\frac{dx}{dt}} + \\underbrace{(\\cos t + \\sin t + e^{-t})}_{x} = 2\\cos t .",
        "Chain(Add(Derivative(Call(x); t, 1), Call(x)), Add(Add(Neg(Call(sin; t)), Call(cos; t), Neg(Pow(e; Neg(t)))), Add(Call(cos; t), Call(sin; t), Pow(e; Neg(t)))), Mul(2, Call(cos; t)); =, =)",
        "jirilebl/diffyqs/ch-intro.tex",
    ),
    (
        "E(\\phi,m) = \\int_0^{\\phi} \\sqrt{1-m \\sin^2 t} \\, dt = \\int_0^{\\sin \\phi} \\frac{\\sqrt{1-mt^2}}{\\sqrt{1-t^2}} \\, dt",
        "Chain(Call(E; \\phi, m), Integral(Sqrt(Add(1, Neg(Mul(m, Pow(Call(sin; t); 2))))); t; 0; \\phi), Integral(Div(Sqrt(Add(1, Neg(Mul(m, Pow(t; 2))))); Sqrt(Add(1, Neg(Pow(t; 2))))); t; 0; Call(sin; \\phi)); =, =)",
        "fredrik-johansson/arb/doc/source/acb_elliptic.rst",
    ),
    (
        "{}^N\\bar{v}^{P_4}\\cdot\\hat{n}_x = 0 \\\\ {}^N\\bar{v}^{P_4}\\cdot\\hat{n}_y = 0",
        "System(Chain(Mul(\\prescript { N } { } { \\bar { v } } ^ { P _ { 4 } }, \\hat{n}_x; 1), 0; =), Chain(Mul(\\prescript { N } { } { \\bar { v } } ^ { P _ { 4 } }, \\hat{n}_y; 1), 0; =))",
        "moorepants/learn-multibody-dynamics/configuration.rst",
    ),
    (
        "K = L\\,D\\,L^\\mathrm{T}",
        "Chain(K, Mul(L, D, Transpose(L)); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "L = 112 + 17\\log_{10}\\left(\\frac{m}{\\text{tonne/hour}}\\right)",
        "Chain(L, Add(112, Mul(17, Call(lg; Div(m; \\text{tonne/hour})))); =)",
        "CalebBell/fluids/fluids/safety_valve.py",
    ),
    (
        "\\lambda = \\mathrm{arctan2}\\left(x, \\,y\\right)",
        "Chain(\\lambda, Call(\\text{arctan2}; x, y); =)",
        "Mayitzin/ahrs/ahrs/common/frames.py",
    ),
    (
        "x_A = a,\\quad y_A = a\\tan \\phi",
        "System(Chain(x_A, a; =), Chain(y_A, Mul(a, Call(tan; \\phi)); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise2.tex",
    ),
    (
        "r_m = \\left(\\frac{l^2}{n\\alpha \\mu}\\right)^{\\frac{1}{2-n}}",
        "Chain(r_m, Pow(Div(Pow(l; 2); Mul(n, \\alpha, \\mu)); Div(1; Add(2, Neg(n)))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "{ {\\boldsymbol{y}}} = { {\\boldsymbol{\\mu}}}_{ {\\boldsymbol{\\theta}}}({ {\\boldsymbol{t}}})+ K_{ {\\boldsymbol{\\alpha}}}^{1/2}\\,{ {\\boldsymbol{q}}}",
        "Chain(\\boldsymbol{y}, Add(Call(\\boldsymbol{\\mu}_{\\boldsymbol\\theta}; \\boldsymbol{t}), Mul(Pow(K_{\\boldsymbol\\alpha}; Div(1; 2)), \\boldsymbol{q})); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "x'(T)=a_1+2a_2T+3a_3T^2+4a_4T^3+5a_5T^4=v_e",
        "Chain(Call(x'; T), Add(a_1, Mul(2, a_2, T), Mul(3, a_3, Pow(T; 2)), Mul(4, a_4, Pow(T; 3)), Mul(5, a_5, Pow(T; 4))), v_e; =, =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/quintic_polynomials_planner/quintic_polynomials_planner_main.rst",
    ),
    (
        "v_{\\text{CoM}} = \\frac{1}{m_{\\text{tot}}}(m_{\\text{hub}} \\dot{y}_{B/N} + 2 m_{\\text{sp}}\\dot{ r}_{\\text{sp},y})",
        "Chain(v_{CoM}, Mul(Div(1; m_{tot}), Add(Mul(m_{hub}, Call(\\dot{y}_{B/N})), Mul(2, m_{sp}, Call(\\dot{r}_{sp,y})))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/HingedRigidBodies/_Documentation/secTest.tex",
    ),
    (
        "f(t) = \\begin{cases} -t & \\text{if } \\; {-1} < t \\leq 0 , \\\\ t^2 & \\text{if } \\; \\phantom{-}0 < t \\leq 1 , \\end{cases}",
        "Chain(Call(f; t), Piecewise(Neg(t), Chain(Neg(1), t, 0; <, \\le), Pow(t; 2), Chain(0, t, 1; <, \\le)); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "x y'' + y' + \\lambda^2 x y = 0 ,",
        "Chain(Add(Mul(x, y''), y', Mul(Pow(\\lambda; 2), x, y)), 0; =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "V = \\frac{\\pi D^2}{12} (3h + 2a ),\\;\\; h \\ge |a|",
        "System(Chain(V, Mul(Div(Mul(\\pi, Pow(D; 2)); 12), Add(Mul(3, h), Mul(2, a))); =), Chain(h, Bars(a); \\ge))",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "v1 = p2 - p1",
        "Chain(\\text{v1}, Add(\\text{p2}, Neg(\\text{p1})); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/3_mapping/normal_vector_estimation/normal_vector_estimation_main.rst",
    ),
    (
        "\\frac{dA}{dt} = \\frac{h}{2}",
        "Chain(Derivative(Call(A); t, 1), Div(h; 2); =)",
        "bryanwweber/orbital-mechanics-notes/constants-of-orbital-motion/orbital-plane-and-keplers-second-law.md",
    ),
    (
        "\\begin{aligned} \\dot{x}(t) &= Ax(t) + Bu(t) \\\\ y(t) &= Cx(t) + Du(t) \\end{aligned}",
        "System(Chain(Call(\\dot{x}; t), Add(Mul(A, Call(x; t)), Mul(B, Call(u; t))); =), Chain(Call(y; t), Add(Mul(C, Call(x; t)), Mul(D, Call(u; t))); =))",
        "sympy/sympy/sympy/physics/control/lti.py",
    ),
    (
        "\\frac{d}{dt}\\left(\\dot{\\boldsymbol{r}}\\times\\boldsymbol{h}\\right) = \\frac{d}{dt}\\left(\\mu\\frac{\\boldsymbol{r}}{r}\\right)",
        "Chain(Derivative(Cross(Call(\\dot{\\boldsymbol{r}}); \\boldsymbol{h}); t, 1), Derivative(Mul(\\mu, Div(Call(\\boldsymbol{r}); Call(r))); t, 1); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/the-orbit-equation.md",
    ),
    (
        "J(x, u) = \\int_0^T L(x, u)\\, dt + V \\bigl( x(T) \\bigr).",
        "Chain(Call(J; Call(x), u), Add(Integral(Call(L; Call(x), u); t; 0; T), Call(V; Call(x; T))); =)",
        "python-control/python-control/doc/optimal.rst",
    ),
    (
        "\\left|\\frac{f'(m)}{f(m)}\\right| = \\left|\\sum_i \\frac{1}{m-\\zeta_i}\\right| \\le \\sum_i \\frac{1}{|m-\\zeta_i|} < \\frac{n}{r} = \\left|\\frac{f'(m)}{f(m)}\\right|",
        "Chain(Bars(Div(Call(f'; m); Call(f; m))), Bars(BigSum(i; Div(1; Add(m, Neg(\\zeta_i))))), BigSum(i; Div(1; Bars(Add(m, Neg(\\zeta_i))))), Div(n; r), Bars(Div(Call(f'; m); Call(f; m))); =, \\le, <, =)",
        "fredrik-johansson/arb/doc/source/acb_poly.rst",
    ),
    (
        "y = C_1 e^{2x} + C_2 e^{4x} .",
        "Chain(y, Add(Mul(C_1, Pow(e; Mul(2, x))), Mul(C_2, Pow(e; Mul(4, x)))); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "E_{\\text{capture}} = -\\frac{\\mu_f}{2a}",
        "Chain(E_{capture}, Neg(Div(\\mu_f; Mul(2, a))); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-arrival-capture.md",
    ),
    (
        "U = V + \\Phi",
        "Chain(U, Add(V, \\Phi); =)",
        "Mayitzin/ahrs/ahrs/utils/wgs84.py",
    ),
    (
        "\\phi(\\boldsymbol{r}) = A(\\boldsymbol{r}) \\mathrm{e}^{\\mathrm{i}k_0 L(\\boldsymbol{r})}",
        "Chain(Call(\\phi; \\boldsymbol{r}), Mul(Call(A; \\boldsymbol{r}), Pow(\\text{e}; Mul(\\text{i}, k_0, Call(L; \\boldsymbol{r})))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\rho = \\tfrac{1}{2} |2a^2-2ab+b| + \\sigma' (1+ \\tfrac{1}{4} \\sigma') (1-\\sigma')^{-2}",
        "Chain(\\rho, Add(Mul(Div(1; 2), Bars(Add(Mul(2, Pow(a; 2)), Neg(Mul(2, a, b)), b))), Mul(\\sigma', Add(1, Mul(Div(1; 4), \\sigma')), Pow(Add(1, Neg(\\sigma')); Neg(2)))); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "2y = F_y (x,y) = A'(y) .",
        "Chain(Mul(2, y), Call(F_y; x, y), Call(A'; y); =, =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\ddot{{\\bf q}} = {\\bf u}'.",
        "Chain(Call(\\ddot{\\mathbf{q}}), \\mathbf{u}'; =)",
        "RussTedrake/underactuated/book/intro.html",
    ),
    (
        "R_N = \\frac{a}{\\sqrt{1-e^2\\sin^2\\phi}}",
        "Chain(R_N, Div(a; Sqrt(Add(1, Neg(Mul(Pow(e; 2), Pow(Call(sin; \\phi); 2)))))); =)",
        "Mayitzin/ahrs/ahrs/utils/geodesy.py",
    ),
    (
        "\\ddot{\\boldsymbol{r}} = -G m_1 \\frac{\\boldsymbol{r}}{r^3} - G m_2 \\frac{\\boldsymbol{r}}{r^3}",
        "Chain(Call(\\ddot{\\boldsymbol{r}}), Add(Neg(Mul(G, m_1, Div(Call(\\boldsymbol{r}); Pow(Call(r); 3)))), Neg(Mul(G, m_2, Div(Call(\\boldsymbol{r}); Pow(Call(r); 3))))); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-relative-motion.md",
    ),
    (
        "\\bm F_{2/1i} + \\bm F_{\\text{ext}_{i2}} = m_{sp_{i2}} \\ddot{\\bm{r}}_{S_{c,i2}/N}",
        "Chain(Add(\\bm{F}_{2/1i}, \\bm{F}_{ext_i2}), Mul(m_{sp_i2}, Call(\\ddot{\\bm{r}}_{S_c,i2/N})); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "f^{B_{com}}_{gravity,W} = mg.",
        "Chain(f _ { g r a v i t y , W } ^ { B _ { c o m } }, Mul(m, g); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "{}^N\\mathbf{C}^A = \\left({}^A\\mathbf{C}^N\\right)^{-1} = \\left({}^A\\mathbf{C}^N\\right)^T",
        "Chain(\\prescript { N } { } { \\mathbf { C } } ^ { A }, Pow(\\prescript { A } { } { \\mathbf { C } } ^ { N }; Neg(1)), Transpose(\\prescript { A } { } { \\mathbf { C } } ^ { N }); =, =)",
        "moorepants/learn-multibody-dynamics/orientation.rst",
    ),
    (
        "\\Delta N = \\Omega_{\\text{in}}\\Delta t \\frac{n}{2\\pi} + \\Delta N - N",
        "Chain(\\Delta N, Add(Mul(\\Omega_{in}, \\Delta t, Div(n; Mul(2, \\pi))), \\Delta N, Neg(N)); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/encoder/encoder.rst",
    ),
    (
        "C = 0.03948\\sqrt{\\frac{1}{e}}",
        "Chain(C, Mul(0.03948, Sqrt(Div(1; e))); =)",
        "CalebBell/fluids/fluids/safety_valve.py",
    ),
    (
        "\\begin{aligned} A &= \\mathrm{INT}\\left(\\frac{M - 14}{12}\\right) \\\\ B &= 1461\\left(Y + 4800 + A\\right) \\\\ C &= 367\\left(M - 2 - 12A\\right) \\\\ E &= \\mathrm{INT}\\left(\\frac{Y + 4900 + A}{100}\\right) \\end{aligned}",
        "System(Chain(A, Call(\\text{INT}; Div(Add(M, Neg(14)); 12)); =), Chain(B, Mul(1461, Add(Y, 4800, A)); =), Chain(C, Mul(367, Add(M, Neg(2), Neg(Mul(12, A)))); =), Chain(E, Call(\\text{INT}; Div(Add(Y, 4900, A); 100)); =))",
        "bryanwweber/orbital-mechanics-notes/reference/julian-date.md",
    ),
    (
        "v^2 = \\boldsymbol{v} \\cdot \\boldsymbol{v} = \\dot{r}^2 + r^2 \\dot{\\theta}^2 + r^2 \\dot{\\phi}^2 \\sin^2 \\theta",
        "Chain(Pow(v; 2), Mul(\\boldsymbol{v}, \\boldsymbol{v}; 1), Add(Pow(Call(\\dot{r}); 2), Mul(Pow(Call(r); 2), Pow(Call(\\dot{\\theta}); 2)), Mul(Pow(Call(r); 2), Pow(Call(\\dot{\\phi}); 2), Pow(Call(sin; Call(\\theta)); 2))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Kinematics.tex",
    ),
    (
        "\\begin{bmatrix}e \\\\ n \\\\ u\\end{bmatrix} = \\begin{bmatrix} \\sin\\theta & -\\cos\\theta & 0 \\\\ \\cos\\theta & \\sin\\theta & 0 \\\\ 0 & 0 & 1 \\end{bmatrix} \\begin{bmatrix}d \\\\ c \\\\ a\\end{bmatrix}",
        "Chain(MatrixOf(e, n, u), Mul(MatrixOf(Call(sin; \\theta), Neg(Call(cos; \\theta)), 0, Call(cos; \\theta), Call(sin; \\theta), 0, 0, 0, 1), MatrixOf(d, c, a)); =)",
        "Mayitzin/ahrs/ahrs/common/frames.py",
    ),
    (
        "\\begin{aligned}\\boldsymbol{r}_0 &= x_0\\boldsymbol{\\hat{p}} + y_0\\boldsymbol{\\hat{q}} & \\boldsymbol{v}_0 &= \\dot{x}_0\\boldsymbol{\\hat{p}} + \\dot{y}_0\\boldsymbol{\\hat{q}}\\end{aligned}",
        "System(Chain(\\boldsymbol{r}_0, Add(Mul(Call(x_0), \\boldsymbol{\\hat{p}}), Mul(Call(y_0), \\boldsymbol{\\hat{q}})); =), Chain(\\boldsymbol{v}_0, Add(Mul(Call(\\dot{x}_0), \\boldsymbol{\\hat{p}}), Mul(Call(\\dot{y}_0), \\boldsymbol{\\hat{q}})); =))",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/the-lagrange-coefficients.md",
    ),
    (
        "\\theta(t) = a (t - t_0)^2 + \\theta_0",
        "Chain(Call(\\theta; t), Add(Mul(a, Pow(Add(t, Neg(t_0)); 2)), \\theta_0); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedRotation1DOF/prescribedRotation1DOF.rst",
    ),
    (
        "M(q)\\ddot{q} + C(q,\\dot{q})\\dot{q} + K_p(q - q_d) + K_d(\\dot{q} - \\dot{q}_d) = \\tau_{ext},",
        "Chain(Add(Mul(Call(M; Call(q)), Call(\\ddot{q})), Mul(Call(C; Call(q), Call(\\dot{q})), Call(\\dot{q})), Mul(K_p, Add(Call(q), Neg(Call(q_d)))), Mul(K_d, Add(Call(\\dot{q}), Neg(Call(\\dot{q}_d))))), \\tau_{ext}; =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "v_0^2 = \\boldsymbol{v}_0 \\cdot\\boldsymbol{v}_0",
        "Chain(Pow(v_0; 2), Mul(\\boldsymbol{v}_0, \\boldsymbol{v}_0; 1); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-lagrange-coefficients-example.md",
    ),
    (
        "C_{\\infty} = 0.6016 + 0.3312\\beta^{2.1} -1.5581\\beta^8 + \\frac{0.6510\\beta^4}{(1-\\beta^4)} - 0.7308\\beta^3",
        "Chain(C_\\infty, Add(0.6016, Mul(0.3312, Pow(\\beta; 2.1)), Neg(Mul(1.5581, Pow(\\beta; 8))), Div(Mul(0.6510, Pow(\\beta; 4)); Add(1, Neg(Pow(\\beta; 4)))), Neg(Mul(0.7308, Pow(\\beta; 3)))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "\\cosh^2 c - \\sinh^2 c = 1",
        "Chain(Add(Pow(Call(cosh; c); 2), Neg(Pow(Call(sinh; c); 2))), 1; =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/hyperbolic-trajectories.md",
    ),
    (
        "\\vec{x} = e^{tP} \\vec{c} ,",
        "Chain(\\vec{x}, Mul(Pow(e; Mul(t, P)), \\vec{c}); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "K = 1.12 - 22\\frac{t}{d} + 216\\left(\\frac{t}{d}\\right)^2 + 80\\left(\\frac{t}{d}\\right)^3",
        "Chain(K, Add(1.12, Neg(Mul(22, Div(t; d))), Mul(216, Pow(Div(t; d); 2)), Mul(80, Pow(Div(t; d); 3))); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "p = a \\left(1 - e^2\\right)",
        "Chain(p, Mul(a, Add(1, Neg(Pow(e; 2)))); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/elliptical-orbits.md",
    ),
    (
        "\\hat{\\bm e}_{180} = \\frac{ \\hat{\\bm h}_{c} \\times \\hat{\\bm b}_{2}}{| \\hat{\\bm h}_{c} \\times \\hat{\\bm b}_{2}|}",
        "Chain(\\hat{\\bm{e}}_{180}, Div(Cross(\\hat{\\bm{h}}_c; \\hat{\\bm{b}}_2); Bars(Cross(\\hat{\\bm{h}}_c; \\hat{\\bm{b}}_2))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/opNavPoint/_Documentation/secModelDescription.tex",
    ),
    (
        "3^{2x} = 2^{x + 3}",
        "Chain(Pow(3; Mul(2, x)), Pow(2; Add(x, 3)); =)",
        "sympy/sympy/sympy/solvers/solveset.py",
    ),
    (
        "y_t (x,t) = \\frac{\\partial}{\\partial t} \\left[ C u\\bigl(t-\\nicefrac{x}{\\alpha}\\bigr) \\right] = C u'\\bigl(t-\\nicefrac{x}{\\alpha}\\bigr) = C \\delta\\bigl(t-\\nicefrac{x}{\\alpha}\\bigr)",
        "Chain(Call(y_t; x, t), Derivative(Mul(C, Call(u; Add(t, Neg(Div(x; \\alpha))))); t, 1; True), Mul(C, Call(u'; Add(t, Neg(Div(x; \\alpha))))), Mul(C, Call(\\delta; Add(t, Neg(Div(x; \\alpha))))); =, =, =)",
        "jirilebl/diffyqs/ch-laplace.tex",
    ),
    (
        "\\boldsymbol{r}_A \\cdot \\boldsymbol{e}_n = \\boldsymbol{r}_B \\cdot \\boldsymbol{e}_n = 0",
        "Chain(Mul(\\boldsymbol{r}_A, \\boldsymbol{e}_n; 1), Mul(\\boldsymbol{r}_B, \\boldsymbol{e}_n; 1), 0; =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter9.tex",
    ),
    (
        "k(\\tau) = \\frac{a}{2+b}\\,e^{-c\\,\\tau}\\left[ \\cos\\left(\\frac{2\\,\\pi\\,\\tau}{P}\\right) + (1+b) \\right]",
        "Chain(Call(k; \\tau), Mul(Div(a; Add(2, b)), Pow(e; Neg(Mul(c, \\tau))), Add(Call(cos; Div(Mul(2, \\pi, \\tau); P)), Add(1, b))); =)",
        "dfm/celerite/docs/python/kernel.rst",
    ),
    (
        "v_r = \\frac{\\mu}{h} e \\sin\\nu",
        "Chain(v_r, Mul(Div(\\mu; h), e, Call(sin; \\nu)); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables-example.md",
    ),
    (
        "\\begin{aligned} \\boldsymbol{r} &= \\boldsymbol{R}_2 - \\boldsymbol{R}_1 \\end{aligned}",
        "Chain(\\boldsymbol{r}, Add(\\boldsymbol{R}_2, Neg(\\boldsymbol{R}_1)); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-relative-motion.md",
    ),
    (
        "a_x = g\\sin\\theta",
        "Chain(a_x, Mul(g, Call(sin; \\theta)); =)",
        "Mayitzin/ahrs/ahrs/filters/fqa.py",
    ),
    (
        "\\vec{x} = A^{-1} A \\vec{x} = A^{-1} \\vec{b} .",
        "Chain(\\vec{x}, Mul(Pow(A; Neg(1)), A, \\vec{x}), Mul(Pow(A; Neg(1)), \\vec{b}); =, =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "u_{s_{i}} = I_{w_{s_{i}}}(\\dot{\\Omega}_{i} + \\hat{\\boldsymbol{ g}}_{s_{i}}^{T}\\dot{\\boldsymbol{ \\omega}} + \\dot{\\gamma}_{i}\\omega_{t_{i}})",
        "Chain(u_{s_i}, Mul(I_{w_s_i}, Add(Call(\\dot{\\Omega}_i), Mul(Transpose(\\hat{\\boldsymbol{g}}_{s_i}), Call(\\dot{\\boldsymbol{\\omega}})), Mul(Call(\\dot{\\gamma}_i), \\omega_{t_i}))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/vscmgGimbalRateServo/vscmgGimbalRateServo.rst",
    ),
    (
        "Q_k(z) = -{\\rm rem}(Q_{k-2},\\,Q_{k-1})",
        "Chain(Call(Q_k; z), Neg(Call(\\text{rem}; Q_{k-2}, Q_{k-1})); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "{\\bf S}(t_f) = {\\bf Q}_f.",
        "Chain(Call(\\mathbf{S}; t_f), \\mathbf{Q}_f; =)",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "V_f = \\frac{\\pi}{4}\\left(\\frac{Dh}{a}\\right)^2 \\left(a - \\frac{h}{3}\\right),\\; h < a",
        "System(Chain(V_f, Mul(Div(\\pi; 4), Pow(Div(Mul(D, h); a); 2), Add(a, Neg(Div(h; 3)))); =), Chain(h, a; <))",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "C_{\\infty} = (0.7746 - 0.1334\\beta^{2.1} + 1.4098\\beta^8 + \\frac{0.0675\\beta^4}{(1 - \\beta^4)} + 0.3865\\beta^3)",
        "Chain(C_\\infty, Add(0.7746, Neg(Mul(0.1334, Pow(\\beta; 2.1))), Mul(1.4098, Pow(\\beta; 8)), Div(Mul(0.0675, Pow(\\beta; 4)); Add(1, Neg(Pow(\\beta; 4)))), Mul(0.3865, Pow(\\beta; 3))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "(M + m)y'' - ml \\phi'' \\sin(\\phi) - ml(\\phi')^2 \\cos(\\phi) + k_1 y + k_2 y^3 + c_1 y' = F_0 \\cos(\\nu t)",
        "Chain(Add(Mul(Add(M, m), y''), Neg(Mul(m, l, \\phi'', Call(sin; \\phi))), Neg(Mul(m, l, Pow(\\phi'; 2), Call(cos; \\phi))), Mul(k_1, y), Mul(k_2, Pow(y; 3)), Mul(c_1, y')), Mul(F_0, Call(cos; Mul(\\nu, t))); =)",
        "sympy/sympy/doc/src/tutorials/physics/mechanics/duffing-example.rst",
    ),
    (
        "U(\\mathbf{\\bar r}) = G \\frac{ m_\\text{Q}}{\\rho_\\text{Q}}",
        "Chain(Call(U; \\mathbf{\\bar{r}}), Mul(G, Div(m_Q; \\rho_Q)); =)",
        "AVSLab/basilisk/src/simulation/dynamics/gravityEffector/_Documentation/secModelDescription.tex",
    ),
    (
        "\\begin{array}{rcl} \\boldsymbol\\sigma_\\boldsymbol\\omega^2 &=& 0.3^2 \\\\ \\boldsymbol\\sigma_\\mathbf{a}^2 &=& 0.5^2 \\\\ \\boldsymbol\\sigma_\\mathbf{m}^2 &=& 0.8^2 \\end{array}",
        "System(Chain(Pow(\\boldsymbol{\\sigma}_{\\boldsymbol\\omega}; 2), Pow(0.3; 2); =), Chain(Pow(\\boldsymbol{\\sigma}_{\\mathbf a}; 2), Pow(0.5; 2); =), Chain(Pow(\\boldsymbol{\\sigma}_{\\mathbf m}; 2), Pow(0.8; 2); =))",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "\\mathbf{H}_x\\mathbf{P}_1 + \\mathbf{H}_y\\mathbf{P}_2 + \\mathbf{H}_z\\mathbf{P}_3 - \\mathbf{q}^\\dagger = \\mathbf{0}_{1\\times 4}",
        "Chain(Add(Mul(\\mathbf{H}_x, \\mathbf{P}_1), Mul(\\mathbf{H}_y, \\mathbf{P}_2), Mul(\\mathbf{H}_z, \\mathbf{P}_3), Neg(\\mathbf { q } ^ { \\dagger })), Marked(0; _{ 1 \\times 4 }); =)",
        "Mayitzin/ahrs/ahrs/filters/flae.py",
    ),
    (
        "\\boldsymbol{v}_{\\ell mn} = v_{\\ell}\\boldsymbol{\\hat{\\lambda}} + v_m\\boldsymbol{\\hat{\\rho}} + v_n\\boldsymbol{\\hat{\\sigma}}",
        "Chain(\\boldsymbol{v}_{\\ell mn}, Add(Mul(v_\\ell, \\boldsymbol{\\hat{\\lambda}}), Mul(v_m, \\boldsymbol{\\hat{\\rho}}), Mul(v_n, \\boldsymbol{\\hat{\\sigma}})); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "\\left[\\mathbf{R_1(\\phi)}\\right] = \\begin{bmatrix}1 & 0 & 0\\\\0 & \\cos\\phi & \\sin\\phi\\\\0 & -\\sin\\phi & \\cos\\phi\\end{bmatrix}",
        "Chain(Call(\\mathbf{R}_1; \\phi), MatrixOf(1, 0, 0, 0, Call(cos; \\phi), Call(sin; \\phi), 0, Neg(Call(sin; \\phi)), Call(cos; \\phi)); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "\\left[\\mathbf{Q}\\right] = \\left[\\mathbf{R_1(\\gamma)}\\right]\\left[\\mathbf{R_2(\\beta)}\\right]\\left[\\mathbf{R_3(\\alpha)}\\right]",
        "Chain([ \\mathbf { Q } ], Mul(Call(\\mathbf{R}_1; \\gamma), Call(\\mathbf{R}_2; \\beta), Call(\\mathbf{R}_3; \\alpha)); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "\\frac{d\\boldsymbol{B}}{dt} = \\left.\\frac{d\\boldsymbol{B}}{dt}\\right)_{\\text{rel}} + \\boldsymbol{\\Omega}\\times\\boldsymbol{B}",
        "Chain(Derivative(Call(\\boldsymbol{B}); t, 1), Add(Marked(Derivative(Call(\\boldsymbol{B}); t, 1); _{ \\text { r e l } }), Cross(\\boldsymbol{\\Omega}; Call(\\boldsymbol{B}))); =)",
        "bryanwweber/orbital-mechanics-notes/review/time-derivatives-of-moving-vectors.md",
    ),
    (
        "\\dot\\theta^{+}_{n+1} = \\cos(2\\alpha) \\sqrt{ ({\\dot\\theta_n}^{+})^{2} + 4\\frac{g}{l}\\sin\\alpha \\sin\\gamma}.",
        "Chain(Call(\\dot { \\theta } _ { n + 1 } ^ { + }), Mul(Call(cos; Mul(2, \\alpha)), Sqrt(Add(Pow(Call(\\dot { \\theta } _ { n } ^ { + }); 2), Mul(4, Div(g; l), Call(sin; \\alpha), Call(sin; \\gamma))))); =)",
        "RussTedrake/underactuated/book/simple_legs.html",
    ),
    (
        "\\frac{{}^Ad\\hat{b}_x}{dt} = {}^A\\bar{\\omega}^B \\times \\hat{b}_x",
        "Chain(Marked(Derivative(Call(\\hat{b}_x); t, 1); _{ A }), Cross(\\prescript { A } { } { \\bar { \\omega } } ^ { B }; Call(\\hat{b}_x)); =)",
        "moorepants/learn-multibody-dynamics/angular.rst",
    ),
    (
        "\\frac{{}^A d \\bar{v}}{dt} := \\sum_{i=1}^3 \\frac{d v_i}{dt} \\hat{a}_i",
        "Chain(Marked(Derivative(Call(\\bar{v}); t, 1); _{ A }), BigSum(i; 1; 3; Mul(Derivative(Call(v_i); t, 1), \\hat{a}_i)); =)",
        "moorepants/learn-multibody-dynamics/differentiation.rst",
    ),
    (
        "v_x \\frac{{}^N\\partial \\hat{a}_x}{\\partial q_r}, v_y \\frac{{}^N\\partial \\hat{a}_y}{\\partial q_r}, v_z \\frac{{}^N\\partial \\hat{a}_z}{\\partial q_r}",
        "System(Mul(v_x, Marked(Derivative(Call(\\hat{a}_x); q_r, 1; True); _{ N })), Mul(v_y, Marked(Derivative(Call(\\hat{a}_y); q_r, 1; True); _{ N })), Mul(v_z, Marked(Derivative(Call(\\hat{a}_z); q_r, 1; True); _{ N })))",
        "moorepants/learn-multibody-dynamics/differentiation.rst",
    ),
    (
        "\\bar{M}^{S/P} = \\sum_{i=1}^{\\nu} \\bar{r}^{L_i/P} \\times \\bar{v}_i",
        "Chain(\\bar { M } ^ { S / P }, BigSum(i; 1; \\nu; Cross(\\bar { r } ^ { L _ { i } / P }; \\bar{v}_i)); =)",
        "moorepants/learn-multibody-dynamics/loads.rst",
    ),
    (
        "m := \\int_{\\textrm{solid}} \\rho dV",
        "Chain(m, Over(\\int; _ { \\text { s o l i d } }; \\rho; V); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "\\bar{r}^{S_o/O} = \\frac{ \\int_{\\textrm{solid}} \\rho \\bar{r} dV }{ \\int_{\\textrm{solid}} \\rho dV }",
        "Chain(\\bar { r } ^ { S _ { o } / O }, Div(Over(\\int; _ { \\text { s o l i d } }; Mul(\\rho, \\bar{r}); V); Over(\\int; _ { \\text { s o l i d } }; \\rho; V)); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "\\sum\\bar{F}^{P_1} = m_1 {}^N\\bar{a}^{P_1} \\\\ \\sum\\bar{F}^{P_2} = m_2 {}^N\\bar{a}^{P_2}",
        "System(Chain(Limiting(sum; ; \\bar { F } ^ { P _ { 1 } }), Mul(m_1, \\prescript { N } { } { \\bar { a } } ^ { P _ { 1 } }); =), Chain(Limiting(sum; ; \\bar { F } ^ { P _ { 2 } }), Mul(m_2, \\prescript { N } { } { \\bar { a } } ^ { P _ { 2 } }); =))",
        "moorepants/learn-multibody-dynamics/noncontributing.rst",
    ),
    (
        "u = u_\\text{d} - K (x - x_\\text{d})",
        "Chain(u, Add(u_d, Neg(Mul(K, Add(x, Neg(x_d))))); =)",
        "python-control/python-control/doc/iosys.rst",
    ),
    (
        "K = \\begin{bmatrix} K_\\text{p} \\\\ K_\\text{i} \\end{bmatrix}",
        "Chain(K, MatrixOf(K_p, K_i); =)",
        "python-control/python-control/doc/iosys.rst",
    ),
    (
        "I_1+I_2=\\int_V \\rho(x^2+y^2+2z^2)\\mathrm{d} V = I_3+2\\int_V \\rho z^2\\mathrm{d} V \\geqslant I_3",
        "Chain(Add(I_1, I_2), Over(\\int; _ { V }; Mul(\\rho, Add(Pow(x; 2), Pow(y; 2), Mul(2, Pow(z; 2)))); V), Add(I_3, Mul(2, Over(\\int; _ { V }; Mul(\\rho, Pow(z; 2)); V))), I_3; =, =, \\ge)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "\\left.\\frac{\\mathrm{d} V}{\\mathrm{d} r}\\right|_{r=r_0} = -\\frac{L^2}{mr^3_0} + \\frac{2mg}{a}r_0 = 0",
        "Chain(Evaluated(Derivative(Call(V); r, 1); r; r_0), Add(Neg(Div(Pow(L; 2); Mul(m, Pow(r_0; 3)))), Mul(Div(Mul(2, m, g); a), r_0)), 0; =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "\\alpha = 1 - \\exp\\{-1 - 0.3\\ln(Ft) - 0.0328[\\ln(Ft)]^2\\}",
        "Chain(\\alpha, Add(1, Neg(Call(exp; Add(Neg(1), Neg(Mul(0.3, Call(ln; Mul(F, t)))), Neg(Mul(0.0328, Pow(Call(ln; Mul(F, t)); 2))))))); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "\\begin{bmatrix} x \\\\ y \\end{bmatrix} ' = P \\begin{bmatrix} x \\\\ y \\end{bmatrix} = P ( \\alpha \\vec{v} ) = \\alpha ( P \\vec{v} ) = \\alpha \\lambda \\vec{v} .",
        "Chain(Marked(MatrixOf(x, y); '), Mul(P, MatrixOf(x, y)), Mul(P, Mul(\\alpha, \\vec{v})), Mul(\\alpha, Mul(P, \\vec{v})), Mul(\\alpha, \\lambda, \\vec{v}); =, =, =, =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\log G(z+1) = \\log \\Gamma(z) + \\log G(z).",
        "Chain(Call(log; Call(G; Add(z, 1))), Add(Call(log; Call(Gamma; z)), Call(log; Call(G; z))); =)",
        "fredrik-johansson/arb/doc/source/acb.rst",
    ),
    (
        "\\Phi(z,s,a) = -\\frac{\\Gamma(1-s)}{2 \\pi i} \\int_C \\frac{(-t)^{s-1} e^{-a t}}{1 - z e^{-t}} dt",
        "Chain(Call(\\Phi; z, s, a), Neg(Mul(Div(Call(Gamma; Add(1, Neg(s))); Mul(2, \\pi, i)), Over(\\int; _ { C }; Div(Mul(Pow(Neg(t); Add(s, Neg(1))), Pow(e; Neg(Mul(a, t)))); Add(1, Neg(Mul(z, Pow(e; Neg(t)))))); t))); =)",
        "fredrik-johansson/arb/doc/source/acb_dirichlet.rst",
    ),
    (
        "\\operatorname{Ei}(z) = -e^z U(1,1,-z) - \\log(-z) + \\frac{1}{2} \\left(\\log(z) - \\log\\left(\\frac{1}{z}\\right) \\right)",
        "Chain(Call(\\text{Ei}; z), Add(Neg(Mul(Pow(e; z), Call(U; 1, 1, Neg(z)))), Neg(Call(log; Neg(z))), Mul(Div(1; 2), Add(Call(log; z), Neg(Call(log; Div(1; z)))))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "\\operatorname{Li}_s(z) = \\sum_{k=1}^{\\infty} \\frac{z^k}{k^s}",
        "Chain(Call(\\text{Li}_s; z), BigSum(k; 1; Infinity(); Div(Pow(z; k); Pow(k; s))); =)",
        "fredrik-johansson/arb/doc/source/polylogarithms.rst",
    ),
    (
        "\\operatorname{Ai}^\\prime(z) := \\frac{\\mathrm{d} \\operatorname{Ai}(z)}{\\mathrm{d} z}.",
        "Chain(Call(\\text{Ai}'; z), Derivative(Call(\\text{Ai}; z); z, 1); =)",
        "sympy/sympy/sympy/functions/special/bessel.py",
    ),
    (
        "G(z) = \\frac{1}{2\\pi i} \\int_L \\Delta(s) z^s \\mathrm{d}s.",
        "Chain(Call(G; z), Mul(Div(1; Mul(2, \\pi, i)), Over(\\int; _ { L }; Mul(Call(\\Delta; s), Pow(z; s)); s)); =)",
        "sympy/sympy/doc/src/modules/integrals/g-functions.rst",
    ),
    (
        "C_D = \\frac{29.1667}{Re}-\\frac{3.8889}{Re^2} + 1.2220",
        "Chain(C_D, Add(Div(29.1667; R e), Neg(Div(3.8889; Pow(R e; 2))), 1.2220); =)",
        "CalebBell/fluids/fluids/drag.py",
    ),
    (
        "Fr = \\frac{V}{\\sqrt{gL}}",
        "Chain(F r, Div(V; Sqrt(Mul(g, L))); =)",
        "CalebBell/fluids/fluids/core.py",
    ),
    (
        "D \\ge 50 \\text{ mm}",
        "Chain(D, Mul(50, \\text{mm}); \\ge)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "{\\vphantom{\\Delta_{2/1}}}^{\\mathcal{P}\\!}{\\Delta_{2/1}} \\dot{\\bm{r}}_{S/N} = [PN] ^{\\mathcal{N}} \\Delta_{2/1} \\dot{\\bm{r}}_{S/N}",
        "Chain(Mul(\\prescript { \\mathcal { P } \\! } { } { \\Delta } _ { 2 / 1 }, Call(\\dot{\\bm{r}}_{S/N})), Mul([ P N ], \\prescript { \\mathcal { N } } { } { \\Delta } _ { 2 / 1 }, Call(\\dot{\\bm{r}}_{S/N})); =)",
        "AVSLab/basilisk/src/architecture/utilities/_Documentation/discretize/secModelDescription.tex",
    ),
    (
        "\\rho \\cdot Vol \\cdot c_p \\dfrac{dT}{dt} = \\dot{Q}_{\\text{absorb}} + \\dot{Q}_{in} - \\dot{Q}_{\\text{emit}}",
        "Chain(Mul(\\rho, \\text{Vol}, c_p, Derivative(Call(T); t, 1)), Add(Call(\\dot{Q}_{absorb}), Call(\\dot{Q}_{in}), Neg(Call(\\dot{Q}_{emit}))); =)",
        "AVSLab/basilisk/src/simulation/thermal/sensorThermal/sensorThermal.rst",
    ),
    (
        "E_\\mathrm{mes} = k_1(1-\\langle\\hat{\\mathbf{v}}_a, \\mathbf{v}_a\\rangle) + k_2(1-\\langle\\hat{\\mathbf{v}}_m, \\mathbf{v}_m\\rangle)",
        "Chain(E_{mes}, Add(Mul(k_1, Add(1, Neg(Pair(\\hat{\\mathbf{v}}_a; \\mathbf{v}_a)))), Mul(k_2, Add(1, Neg(Pair(\\hat{\\mathbf{v}}_m; \\mathbf{v}_m))))); =)",
        "Mayitzin/ahrs/ahrs/filters/mahony.py",
    ),
    (
        "V(r, \\theta, \\phi) = a \\sum_{n=1}^k\\Big(\\frac{a}{r}\\Big)^{n+1}\\sum_{m=0}^{n}\\big(g_n^m \\cos(m\\phi) + h_n^m \\sin(m\\phi)\\big) P_n^m(\\theta)",
        "Chain(Call(V; r, \\theta, \\phi), Mul(a, BigSum(n; 1; k; Mul(Pow(Div(a; r); Add(n, 1)), BigSum(m; 0; n; Mul(Add(Mul(g _ { n } ^ { m }, Call(cos; Mul(m, \\phi))), Mul(h _ { n } ^ { m }, Call(sin; Mul(m, \\phi)))), Call(P _ { n } ^ { m }; \\theta)))))); =)",
        "Mayitzin/ahrs/ahrs/utils/wmm.py",
    ),
    (
        "\\ddot{\\boldsymbol{r}} = -G\\left(m_1 + m_2\\right)\\frac{\\boldsymbol{r}}{r^3}",
        "Chain(Call(\\ddot{\\boldsymbol{r}}), Neg(Mul(G, Add(m_1, m_2), Div(Call(\\boldsymbol{r}); Pow(Call(r); 3)))); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-relative-motion.md",
    ),
    (
        "\\mu = G\\left(m_1 + m_2\\right)",
        "Chain(\\mu, Mul(G, Add(m_1, m_2)); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-relative-motion.md",
    ),
    (
        "\\bar{f}_h(q_1, q_2, q_3) = 0 \\textrm{ where } \\bar{f}_h \\in \\mathbb{R}^2",
        "System(Chain(Call(\\bar{f}_h; q_1, q_2, q_3), 0; =), Chain(Call(\\bar{f}_h), Pow(\\mathbb{R}; 2); \\in))",
        "moorepants/learn-multibody-dynamics/configuration.rst",
    ),
    (
        "\\frac{{}^A\\partial \\bar{v}}{\\partial q_r} = \\sum_{i=1}^3 \\frac{\\partial v_i}{\\partial q_r} \\hat{a}_i \\textrm{ for } r=1\\ldots n",
        "System(Chain(Marked(Derivative(Call(\\bar{v}); q_r, 1; True); _{ A }), BigSum(i; 1; 3; Mul(Derivative(Call(v_i); q_r, 1; True), \\hat{a}_i)); =), Values(r; 1, Dots(), n))",
        "moorepants/learn-multibody-dynamics/differentiation.rst",
    ),
    (
        "\\bar{I}_a := \\int_{\\textrm{solid}} \\rho(\\tau) \\left[ \\bar{r}^{P(\\tau)/O} \\times \\left( \\hat{n}_a \\times \\bar{r}^{P(\\tau)/O} \\right) \\right] d\\tau",
        "Chain(\\bar{I}_a, Over(\\int; _ { \\text { s o l i d } }; Mul(Call(\\rho; \\tau), Cross(\\bar { r } ^ { P ( \\tau ) / O }; Cross(\\hat{n}_a; \\bar { r } ^ { P ( \\tau ) / O }))); \\tau); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "I_{ab} = \\sum_{i=1}^\\nu m_i \\left( \\bar{r}^{P_i/O} \\times \\hat{n}_a \\right) \\cdot \\left( \\bar{r}^{P_i/O} \\times \\hat{n}_b \\right)\\textrm{.}",
        "Chain(I_{ab}, BigSum(i; 1; \\nu; Mul(m_i, Cross(\\bar { r } ^ { P _ { i } / O }; \\hat{n}_a), Cross(\\bar { r } ^ { P _ { i } / O }; \\hat{n}_b); 2)); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "\\bar{I}_a = \\hat{n}_a \\cdot \\sum_{i=1}^\\nu m_i \\left( \\left|\\bar{r}^{P_i/O}\\right|^2 \\breve{U} - \\bar{r}^{P_i/O} \\otimes \\bar{r}^{P_i/O} \\right)",
        "Chain(\\bar{I}_a, Mul(\\hat{n}_a, BigSum(i; 1; \\nu; Mul(m_i, Add(Mul(Pow(Bars(\\bar { r } ^ { P _ { i } / O }); 2), \\breve{U}), Neg(Operated(\\otimes; \\bar { r } ^ { P _ { i } / O }; \\bar { r } ^ { P _ { i } / O })))))); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "& \\ddot{x} = \\frac{m(gcos{\\theta} - \\dot{\\theta}^2l)sin{\\theta} + u}{M + m - mcos^2{\\theta}} \\\\ & \\ddot{\\theta} = \\frac{g(M + m)sin{\\theta} - \\dot{\\theta}^2lmsin{\\theta}cos{\\theta} + ucos{\\theta}}{l(M + m - mcos^2{\\theta})}",
        "System(Chain(Call(\\ddot{x}), Div(Add(Mul(m, Add(Mul(g, Call(cos; Call(\\theta))), Neg(Mul(Pow(Call(\\dot{\\theta}); 2), l))), Call(sin; Call(\\theta))), u); Add(M, m, Neg(Mul(m, Pow(Call(cos; Call(\\theta)); 2))))); =), Chain(Call(\\ddot{\\theta}), Div(Add(Mul(g, Add(M, m), Call(sin; Call(\\theta))), Neg(Mul(Pow(Call(\\dot{\\theta}); 2), l, m, Call(sin; Call(\\theta)), Call(cos; Call(\\theta)))), Mul(u, Call(cos; Call(\\theta)))); Mul(l, Add(M, m, Neg(Mul(m, Pow(Call(cos; Call(\\theta)); 2)))))); =))",
        "AtsushiSakai/PythonRobotics/docs/modules/10_inverted_pendulum/inverted_pendulum_main.rst",
    ),
    (
        "\\Delta \\mathbf{x}^k = -H^{-1} \\mathbf{b}.",
        "Chain(\\Delta \\mathbf { x } ^ { k }, Neg(Mul(Pow(H; Neg(1)), \\mathbf{b})); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/4_slam/graph_slam/graphSLAM_formulation.rst",
    ),
    (
        "x_{i}(t+1) = x_{i}(t) + v_{i}(t+1)",
        "Chain(Call(x_i; Add(t, 1)), Add(Call(x_i; t), Call(v_i; Add(t, 1))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/particleSwarmOptimization/particleSwarmOptimization_main.rst",
    ),
    (
        "x[t+1] &= f(t, x[t], u[t], \\theta), \\\\ y[t] &= h(t, x[t], u[t], \\theta).",
        "System(Chain(Indexed(x; Add(t, 1)), Call(f; t, Indexed(x; t), Indexed(u; t), \\theta); =), Chain(Indexed(y; t), Call(h; t, Indexed(x; t), Indexed(u; t), \\theta); =))",
        "python-control/python-control/doc/nlsys.rst",
    ),
    (
        "\\boldsymbol{M}^{-\\mathrm{T}} \\boldsymbol{J} \\boldsymbol{M}^{-1} = \\boldsymbol{J}",
        "Chain(Mul(Transpose(Pow(\\boldsymbol{M}; Neg(1))), \\boldsymbol{J}, Pow(\\boldsymbol{M}; Neg(1))), \\boldsymbol{J}; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "v = \\frac{\\mathrm{d} x}{\\mathrm{d} t} = \\sqrt{\\frac{g(x^2-l^2)}{L}}",
        "Chain(v, Derivative(Call(x); t, 1), Sqrt(Div(Mul(g, Add(Pow(Call(x); 2), Neg(Pow(l; 2)))); L)); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "\\zeta(s) = \\mathcal{R}(s) + X(s) \\overline{\\mathcal{R}}(1-s), \\quad X(s) = \\pi^{s-1/2} \\frac{\\Gamma((1-s)/2)}{\\Gamma(s/2)}",
        "System(Chain(Call(\\zeta; s), Add(Call(\\mathcal{R}; s), Mul(Call(X; s), Call(\\overline{\\mathcal{R}}; Add(1, Neg(s))))); =), Chain(Call(X; s), Mul(Pow(\\pi; Add(s, Neg(Div(1; 2)))), Div(Call(Gamma; Div(Add(1, Neg(s)); 2)); Call(Gamma; Div(s; 2)))); =))",
        "fredrik-johansson/arb/doc/source/acb_dirichlet.rst",
    ),
    (
        "C_n^{m}(z)=\\frac{(2m)_n}{\\Gamma(n+1)} {}_2F_1\\left(-n,2m+n,m+\\frac{1}{2},\\frac{1-z}{2}\\right).",
        "Chain(Call(C _ { n } ^ { m }; z), Mul(Div(Marked(Mul(2, m); _{ n }); Call(Gamma; Add(n, 1))), Call(\\prescript { } { 2 } { F } _ { 1 }; Neg(n), Add(Mul(2, m), n), Add(m, Div(1; 2)), Div(Add(1, Neg(z)); 2))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "2 Q^E W^{N+2} \\left[ 1 + Q^F W + Q^{2F} W^2 + \\ldots \\right] = \\frac{2 Q^E W^{N+2}}{1 - Q^F W}",
        "Chain(Mul(2, Pow(Q; E), Pow(W; Add(N, 2)), Add(1, Mul(Pow(Q; F), W), Mul(Pow(Q; Mul(2, F)), Pow(W; 2)), Dots())), Div(Mul(2, Pow(Q; E), Pow(W; Add(N, 2))); Add(1, Neg(Mul(Pow(Q; F), W)))); =)",
        "fredrik-johansson/arb/doc/source/acb_modular.rst",
    ),
    (
        "|M''(z+\\varepsilon)| \\le \\frac{2 \\max(1, |z|+|\\varepsilon|+r)}{r^2}",
        "Chain(Bars(Call(M''; Add(z, \\varepsilon))), Div(Mul(2, Call(max; 1, Add(Bars(z), Bars(\\varepsilon), r))); Pow(r; 2)); \\le)",
        "fredrik-johansson/arb/doc/source/agm.rst",
    ),
    (
        "D = |z| \\, \\prod_{i=1}^p \\left(1 + \\frac{|a_i-b_i|}{\\mathcal{R}(b_i+N)}\\right) \\prod_{i=p+1}^{q} \\frac{1}{\\mathcal{R}(b_i + N)}.",
        "Chain(D, Mul(Bars(z), BigProduct(i; 1; p; Mul(Add(1, Div(Bars(Add(a_i, Neg(b_i))); Call(\\mathcal{R}; Add(b_i, N)))), BigProduct(i; Add(p, 1); q; Div(1; Call(\\mathcal{R}; Add(b_i, N))))))); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "Y_n^m(\\theta, \\varphi) := \\sqrt{\\frac{(2n+1)(n-m)!}{4\\pi(n+m)!}} \\exp(i m \\varphi) \\mathrm{P}_n^m\\left(\\cos(\\theta)\\right)",
        "Chain(Call(Y _ { n } ^ { m }; \\theta, \\varphi), Mul(Sqrt(Div(Mul(Add(Mul(2, n), 1), Factorial(Add(n, Neg(m)))); Mul(4, \\pi, Factorial(Add(n, m))))), Call(exp; Mul(i, m, \\varphi)), Call(\\mathrm { P } _ { n } ^ { m }; Call(cos; \\theta))); =)",
        "sympy/sympy/sympy/functions/special/spherical_harmonics.py",
    ),
    (
        "\\begin{aligned} \\operatorname{RealGaunt}(l_1,l_2,l_3,\\mu_1,\\mu_2,\\mu_3) &=\\int Z^{\\mu_1}_{l_1}(\\Omega) Z^{\\mu_2}_{l_2}(\\Omega) Z^{\\mu_3}_{l_3}(\\Omega) \\,d\\Omega \\\\ \\end{aligned}",
        "Chain(Call(\\text{RealGaunt}; l_1, l_2, l_3, \\mu_1, \\mu_2, \\mu_3), Antiderivative(Mul(Call(Z _ { l _ { 1 } } ^ { \\mu _ { 1 } }; \\Omega), Call(Z _ { l _ { 2 } } ^ { \\mu _ { 2 } }; \\Omega), Call(Z _ { l _ { 3 } } ^ { \\mu _ { 3 } }; \\Omega)); \\Omega); =)",
        "sympy/sympy/sympy/physics/wigner.py",
    ),
    (
        "moment(X, c, n) = E((X-c)^{n})",
        "Chain(Call(\\text{moment}; X, c, n), Call(E; Pow(Add(X, Neg(c)); n)); =)",
        "sympy/sympy/sympy/stats/rv_interface.py",
    ),
    (
        "[G_{s}] = [\\hat{\\bm g}_{s_{1}} \\cdots \\hat{\\bm g}_{s_{N}}]",
        "Chain([ G _ { s } ], Tuple(\\hat{\\bm{g}}_{s_1}, Dots(), \\hat{\\bm{g}}_{s_N}; []); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/rwNullSpace/_Documentation/secModuleDescription.tex",
    ),
    (
        "\\dot{\\bm{H}}_{\\text{sc},B} = [I_{\\text{hub},B_c}] \\dot{\\bm\\omega}_{\\cal B/N} + \\bm\\omega_{\\cal B/N} \\times [I_{\\text{hub},B_c}] \\bm\\omega_{\\cal B/N} + m_{\\text{hub}} \\bm{r}_{B_c/B}\\times\\ddot{\\bm r}_{B_c/B}\\\\ +\\sum\\limits_{i=1}^{N_S} \\biggl( [I'_{\\text{sp}_{i1},S_{c,i1}}] \\bm\\omega_{\\cal B/N} + [I_{\\text{sp}_{i1},S_{c,i1}}] \\dot{\\bm\\omega}_{\\cal B/N} + \\bm\\omega_{\\cal B/N} \\times [I_{\\text{sp}_{i1},S_{c,i1}}] \\bm\\omega_{\\cal B/N}\\\\ + \\ddot{\\theta}_{i1} I_{s_{i1,2}}\\bm{\\hat{s}}_{i1,2}+ \\bm\\omega_{\\cal B/N} \\times \\dot{\\theta}_{i1} I_{s_{i1,2}}\\bm{\\hat{s}}_{i1,2} +m_{\\text{sp}_{i1}} \\bm{r}_{S_{c,i1}/B} \\times \\ddot{\\bm r}_{S_{c,i1}/B}\\\\ + [I'_{\\text{sp}_{i2},S_{c,i2}}] \\bm\\omega_{\\cal B/N} + [I_{\\text{sp}_{i2},S_{c,i2}}] \\dot{\\bm\\omega}_{\\cal B/N} + \\bm\\omega_{\\cal B/N} \\times [I_{\\text{sp}_{i2},S_{c,i2}}] \\bm\\omega_{\\cal B/N}\\\\ + \\big(\\ddot{\\theta}_{i1} + \\ddot{\\theta}_{i2}\\big) I_{s_{i2,2}}\\bm{\\hat{s}}_{i2,2}+ \\bm\\omega_{\\cal B/N} \\times \\big(\\dot{\\theta}_{i1} + \\dot{\\theta}_{i2}\\big) I_{s_{i2,2}}\\bm{\\hat{s}}_{i2,2} +m_{\\text{sp}_{i1}} \\bm{r}_{S_{c,i2}/B} \\times \\ddot{\\bm r}_{S_{c,i2}/B}\\biggr)",
        "Chain(Call(\\dot{\\bm{H}}_{sc,B}), Add(Mul([ I _ { \\text { h u b } , B _ { c } } ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N })), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Mul([ I _ { \\text { h u b } , B _ { c } } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}))), Cross(Mul(m_{hub}, Call(\\bm{r}_{B_c/B})); Call(\\ddot{\\bm{r}}_{B_c/B})), BigSum(i; 1; N_S; Add(Mul([ I ' _ { \\text { s p } _ { i 1 } , S _ { c , i 1 } } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})), Mul([ I _ { \\text { s p } _ { i 1 } , S _ { c , i 1 } } ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N })), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Mul([ I _ { \\text { s p } _ { i 1 } , S _ { c , i 1 } } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}))), Mul(Call(\\ddot{\\theta}_{i1}), I_{s_i1,2}, \\bm{\\hat{s}}_{i1,2}), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Mul(Call(\\dot{\\theta}_{i1}), I_{s_i1,2}, \\bm{\\hat{s}}_{i1,2})), Cross(Mul(m_{sp_i1}, Call(\\bm{r}_{S_c,i1/B})); Call(\\ddot{\\bm{r}}_{S_c,i1/B})), Mul([ I ' _ { \\text { s p } _ { i 2 } , S _ { c , i 2 } } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})), Mul([ I _ { \\text { s p } _ { i 2 } , S _ { c , i 2 } } ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N })), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Mul([ I _ { \\text { s p } _ { i 2 } , S _ { c , i 2 } } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}))), Mul(Add(Call(\\ddot{\\theta}_{i1}), Call(\\ddot{\\theta}_{i2})), I_{s_i2,2}, \\bm{\\hat{s}}_{i2,2}), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Mul(Add(Call(\\dot{\\theta}_{i1}), Call(\\dot{\\theta}_{i2})), I_{s_i2,2}, \\bm{\\hat{s}}_{i2,2})), Cross(Mul(m_{sp_i1}, Call(\\bm{r}_{S_c,i2/B})); Call(\\ddot{\\bm{r}}_{S_c,i2/B}))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "[b_n]_i = \\Pr(x_n = x_i | u_0, y_0, ... u_{n-1}, y_{n-1}).",
        "Chain(Marked(b_n; _{ i }), Call(Pr; Given(Chain(x_n, x_i; =); u_0, y_0, Dots(), u_{n-1}, y_{n-1}; |)); =)",
        "RussTedrake/underactuated/book/belief.html",
    ),
    (
        "\\begin{cases} x = x(q_1,q_2,q_3) \\\\ y = y(q_1,q_2,q_3) \\\\ z = z(q_1,q_2,q_3) \\end{cases}",
        "System(Chain(Call(x), Call(x; q_1, q_2, q_3); =), Chain(Call(y), Call(y; q_1, q_2, q_3); =), Chain(Call(z), Call(z; q_1, q_2, q_3); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Kinematics.tex",
    ),
    (
        "a = \\frac{g(\\rho_p-\\rho_f)}{\\rho_p} - \\frac{3C_D \\rho_f u^2}{4D \\rho_p}",
        "Chain(a, Add(Div(Mul(g, Add(\\rho_p, Neg(\\rho_f))); \\rho_p), Neg(Div(Mul(3, C_D, \\rho_f, Pow(u; 2)); Mul(4, D, \\rho_p)))); =)",
        "CalebBell/fluids/fluids/drag.py",
    ),
    (
        "a u_x + b u_t + c u = g, \\qquad u(x,0) = f(x) .",
        "System(Chain(Add(Mul(a, u_x), Mul(b, u_t), Mul(c, Call(u))), g; =), Chain(Call(u; x, 0), Call(f; x); =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\delta\\boldsymbol{r}_A = (-l\\sin\\alpha\\delta\\alpha,l\\cos\\alpha\\delta\\alpha),\\quad \\delta\\boldsymbol{r}_B = (-2l\\sin\\alpha\\delta\\alpha,0),\\quad \\delta\\boldsymbol{r}_C = (-l\\sin\\alpha\\delta\\alpha,-l\\cos\\alpha\\delta\\alpha)",
        "System(Chain(\\delta \\boldsymbol { r } _ { A }, Pair(Neg(Mul(l, Call(sin; \\alpha), \\delta \\alpha)); Mul(l, Call(cos; \\alpha), \\delta \\alpha)); =), Chain(\\delta \\boldsymbol { r } _ { B }, Pair(Neg(Mul(2, l, Call(sin; \\alpha), \\delta \\alpha)); 0); =), Chain(\\delta \\boldsymbol { r } _ { C }, Pair(Neg(Mul(l, Call(sin; \\alpha), \\delta \\alpha)); Neg(Mul(l, Call(cos; \\alpha), \\delta \\alpha))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "\\bm{c}'' = \\ddot{\\bm{c}} - 2\\bm{\\omega}_{B/N} \\times \\bm{c}' - \\dot{\\bm{\\omega}}_{B/N} \\times \\bm{c} -\\bm{\\omega}_{B/N} \\times \\bm{\\omega}_{B/N} \\times \\bm{c}",
        "Chain(Call(\\bm{c}''), Add(Call(\\ddot{\\bm{c}}), Neg(Cross(Mul(2, Call(\\bm{\\omega}_{B/N})); Call(\\bm{c}'))), Neg(Cross(Call(\\dot{\\bm{\\omega}}_{B/N}); Call(\\bm{c}))), Neg(Cross(Call(\\bm{\\omega}_{B/N}); Cross(Call(\\bm{\\omega}_{B/N}); Call(\\bm{c}))))); =)",
        "AVSLab/basilisk/src/architecture/utilities/_Documentation/discretize/secTest.tex",
    ),
    (
        "\\dot{\\hat{\\bm{r}}}_1 &= {\\bm R}_{P1} \\left( {\\bm R}_{P1} \\cdot {\\bm R}_{P1} \\right)^{-\\frac{1}{2}} \\\\ &= \\frac{\\dot{\\bm R}_{P1}}{|{\\bm R}_{P1}|} - \\frac{1}{2} {\\bm R}_{P1} {\\bm R}_{P1}\\cdot \\dot{\\bm R}_{P1} \\left({\\bm R}_{P1} \\cdot {\\bm R}_{P1} \\right)^{-\\frac{3}{2}} \\\\ &= \\frac{\\dot{\\bm R}_{P1}}{|{\\bm R}_{P1}|} - \\hat{\\bm r}_1 \\hat{\\bm r}_{1}^T \\frac{\\dot{\\bm R}_{P1}}{|{\\bm R}_{P1}|} \\\\ &=([I_{3\\times3}] - {\\hat{\\bm{r}}_1}{\\hat{\\bm{r}}_1}^T) \\frac{{\\bm R}_{P1}}{|{\\bm R}_{P1}|}",
        "Chain(Call(\\dot{\\hat{\\bm{r}}}_1), Mul(Call(\\bm{R}_{P1}), Pow(Mul(Call(\\bm{R}_{P1}), Call(\\bm{R}_{P1})); Neg(Div(1; 2)))), Add(Div(Call(\\dot{\\bm{R}}_{P1}); Bars(Call(\\bm{R}_{P1}))), Neg(Mul(Div(1; 2), Call(\\bm{R}_{P1}), Call(\\bm{R}_{P1}), Call(\\dot{\\bm{R}}_{P1}), Pow(Mul(Call(\\bm{R}_{P1}), Call(\\bm{R}_{P1})); Neg(Div(3; 2)))))), Add(Div(Call(\\dot{\\bm{R}}_{P1}); Bars(Call(\\bm{R}_{P1}))), Neg(Mul(Call(\\hat{\\bm{r}}_1), Transpose(Call(\\hat{\\bm{r}}_1)), Div(Call(\\dot{\\bm{R}}_{P1}); Bars(Call(\\bm{R}_{P1})))))), Mul(Add([ I _ { 3 \\times 3 } ], Neg(Mul(Call(\\hat{\\bm{r}}_1), Transpose(Call(\\hat{\\bm{r}}_1))))), Div(Call(\\bm{R}_{P1}); Bars(Call(\\bm{R}_{P1})))); =, =, =, =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/celestialTwoBodyPoint/_Documentation/secModelDescription.tex",
    ),
    (
        "\\dot{\\rho}(t) = \\pm \\ddot{\\rho}_{\\text{max}} \\left( \\frac{(t - t_0)^3}{t_{\\text{smooth}}^2} - \\frac{(t - t_0)^4}{2 t_{\\text{smooth}}^3} \\right)",
        "Chain(Call(\\dot{\\rho}; t), PlusMinus(Mul(Call(\\ddot{\\rho}_{max}), Add(Div(Pow(Add(t, Neg(t_0)); 3); Pow(t_{smooth}; 2)), Neg(Div(Pow(Add(t, Neg(t_0)); 4); Mul(2, Pow(t_{smooth}; 3))))))); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedLinearTranslation/prescribedLinearTranslation.rst",
    ),
    (
        "{\\bf L}_G = \\sum_{i=1}^N \\frac{3 \\mu}{| {\\bf R}_{C/P_i} |^5} {\\bf R}_{C/P_i} \\times [I_c] {\\bf R}_{C/P_i}",
        "Chain(\\mathbf{L}_G, BigSum(i; 1; N; Cross(Mul(Div(Mul(3, \\mu); Pow(Bars(\\mathbf{R}_{C/P_i}); 5)), \\mathbf{R}_{C/P_i}); Mul([ I _ { c } ], \\mathbf{R}_{C/P_i}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/GravityGradientEffector/GravityGradientEffector.rst",
    ),
    (
        "\\mathbf{C} = (\\eta ^2 - \\boldsymbol{\\epsilon}^T\\boldsymbol{\\epsilon})\\mathbf{I} + 2\\boldsymbol{\\epsilon}\\boldsymbol{\\epsilon}^T - 2 \\eta\\boldsymbol{\\epsilon}^\\times",
        "Chain(\\mathbf{C}, Add(Mul(Add(Pow(\\eta; 2), Neg(Mul(Transpose(\\boldsymbol{\\epsilon}), \\boldsymbol{\\epsilon}))), \\mathbf{I}), Mul(2, \\boldsymbol{\\epsilon}, Transpose(\\boldsymbol{\\epsilon})), Neg(Mul(2, \\eta, \\boldsymbol { \\epsilon } ^ { \\times }))); =)",
        "Mayitzin/ahrs/ahrs/common/orientation.py",
    ),
    (
        "\\mathbf{q}_{k+1} = \\mathbf{q}_k-\\mu\\frac{\\nabla f( \\mathbf{q}_k, \\,^E\\mathbf{d}, \\,^S\\mathbf{s})}{\\|\\nabla f( \\mathbf{q}_k, \\,^E\\mathbf{d}, \\,^S\\mathbf{s})\\|}",
        "Chain(\\mathbf{q}_{k+1}, Add(\\mathbf{q}_k, Neg(Mul(\\mu, Div(Call(\\nabla f; \\mathbf{q}_k, \\prescript { E } { } { \\mathbf { d } }, \\prescript { S } { } { \\mathbf { s } }); Norm(Call(\\nabla f; \\mathbf{q}_k, \\prescript { E } { } { \\mathbf { d } }, \\prescript { S } { } { \\mathbf { s } })))))); =)",
        "Mayitzin/ahrs/ahrs/filters/madgwick.py",
    ),
    (
        "d(\\mathbf{x}, \\mathbf{y}) = \\min \\{ |\\mathbf{x}-\\mathbf{y}|, 2\\pi - |\\mathbf{x}-\\mathbf{y}| \\}",
        "Chain(Call(d; \\mathbf{x}, \\mathbf{y}), Call(min; Bars(Add(\\mathbf{x}, Neg(\\mathbf{y}))), Add(Mul(2, \\pi), Neg(Bars(Add(\\mathbf{x}, Neg(\\mathbf{y})))))); =)",
        "Mayitzin/ahrs/ahrs/utils/metrics.py",
    ),
    (
        "\\begin{array}{ll} P^{0,0} & = 1 \\\\ P^{n,n} & = \\sin (x) P^{n-1, n-1} \\\\ P^{n,m} & = \\cos (x) P^{n-1, m} - K^{n, m} P^{n-2, m} \\end{array}",
        "System(Chain(P ^ { 0 , 0 }, 1; =), Chain(P ^ { n , n }, Mul(Call(sin; x), P ^ { n - 1 , n - 1 }); =), Chain(P ^ { n , m }, Add(Mul(Call(cos; x), P ^ { n - 1 , m }), Neg(Mul(K ^ { n , m }, P ^ { n - 2 , m }))); =))",
        "Mayitzin/ahrs/ahrs/utils/wmm.py",
    ),
    (
        "{\\bf x} = {\\bf V}{\\bf r},\\quad \\text{or}\\quad {\\bf r} = {\\bf V}^{-1}{\\bf x}.",
        "System(Chain(\\mathbf{x}, Mul(\\mathbf{V}, \\mathbf{r}); =), Words(\\text{~or~}), Chain(\\mathbf{r}, Mul(Pow(\\mathbf{V}; Neg(1)), \\mathbf{x}); =))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\operatorname{\\textrm{minimize}}_{\\pi} \\quad & t_f\\\\ \\textrm{subject to} \\quad & {\\bf x}(t_0) = {\\bf x}_0, \\\\ & {\\bf x}(t_f) = {\\bf 0}, \\\\ & \\ddot{q}(t) = u(t), \\\\ & |u(t)| \\le 1.",
        "System(Words(Limiting(min; _{ \\pi }; t_f)), Words(\\text{subject~to}), Chain(Call(\\mathbf{x}; t_0), \\mathbf{x}_0; =), Chain(Call(\\mathbf{x}; t_f), 0; =), Chain(Call(\\ddot{q}; t), Call(u; t); =), Chain(Bars(Call(u; t)), 1; \\le))",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "\\operatorname{\\textrm{maximize}}_{\\bf J} \\quad {\\bf c}^T {\\bf J}, \\\\ \\textrm{subject to} \\quad \\forall a, {\\bf J} \\le {\\bf \\ell}(a) + {\\bf T}(a) {\\bf J},",
        "System(Words(Limiting(max; _{ \\mathbf { J } }; Mul(Transpose(\\mathbf{c}), \\mathbf{J}))), Words(\\text{subject~to}), Forall(a), Chain(\\mathbf{J}, Add(Call(\\mathbf{\\ell}; a), Mul(Call(\\mathbf{T}; a), \\mathbf{J})); \\le))",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "\\ddot{{\\bf q}} =& {\\bf M}^{-1}({\\bf q})\\left[ {\\bf \\tau}_g({\\bf q}) + {\\bf B}{\\bf u} - {\\bf C}({\\bf q},\\dot{\\bf q})\\dot{\\bf q} \\right].",
        "Chain(Call(\\ddot{\\mathbf{q}}), Mul(Pow(Call(\\mathbf{M}; Call(\\mathbf{q})); Neg(1)), Add(Call(\\mathbf{\\tau}_g; Call(\\mathbf{q})), Mul(\\mathbf{B}, \\mathbf{u}), Neg(Mul(Call(\\mathbf{C}; Call(\\mathbf{q}), Call(\\dot{\\mathbf{q}})), Call(\\dot{\\mathbf{q}}))))); =)",
        "RussTedrake/underactuated/book/intro.html",
    ),
    (
        "\\forall {\\bf x}, \\quad 0 = \\min_{\\bf u} \\left[ {\\bf x}^T {\\bf Q} {\\bf x} + {\\bf u}^T {\\bf R} {\\bf u} + \\frac{\\partial J^*}{\\partial {\\bf x}} \\left( {\\bf A}{\\bf x} + {\\bf B}{\\bf u} \\right) \\right].",
        "System(Forall(\\mathbf{x}), Chain(0, Limiting(min; _{ \\mathbf { u } }; Add(Mul(Transpose(\\mathbf{x}), \\mathbf{Q}, \\mathbf{x}), Mul(Transpose(\\mathbf{u}), \\mathbf{R}, \\mathbf{u}), Mul(Derivative(Call(J ^ { * }); \\mathbf{x}, 1; True), Add(Mul(\\mathbf{A}, \\mathbf{x}), Mul(\\mathbf{B}, \\mathbf{u}))))); =))",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "0 = {\\bf x}^T \\left[ {\\bf Q} - {\\bf S B R}^{-1}{\\bf B}^T{\\bf S} + {\\bf SA} + {\\bf A}^T{\\bf S} \\right]{\\bf x}.",
        "Chain(0, Mul(Transpose(\\mathbf{x}), Add(\\mathbf{Q}, Neg(Mul(\\mathbf{S}, \\mathbf{B}, Pow(\\mathbf{R}; Neg(1)), Transpose(\\mathbf{B}), \\mathbf{S})), Mul(\\mathbf{S}, \\mathbf{A}), Mul(Transpose(\\mathbf{A}), \\mathbf{S})), \\mathbf{x}); =)",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "{\\bf u}^* = \\pi^*({\\bf x},t) = - {\\bf R}^{-1} {\\bf B}^T {\\bf S}(t) {\\bf x} \\\\ 0 = {\\bf x}^T \\left[ {\\bf Q} - {\\bf S}(t) {\\bf B} {\\bf R}^{-1} {\\bf B}^T {\\bf S}(t) + {\\bf S}(t) {\\bf A} + {\\bf A}^T {\\bf S}(t) + \\dot{\\bf S}(t) \\right] {\\bf x}.",
        "System(Chain(\\mathbf { u } ^ { * }, Call(\\pi ^ { * }; \\mathbf{x}, t), Neg(Mul(Pow(\\mathbf{R}; Neg(1)), Transpose(\\mathbf{B}), Call(\\mathbf{S}; t), \\mathbf{x})); =, =), Chain(0, Mul(Transpose(\\mathbf{x}), Add(\\mathbf{Q}, Neg(Mul(Call(\\mathbf{S}; t), \\mathbf{B}, Pow(\\mathbf{R}; Neg(1)), Transpose(\\mathbf{B}), Call(\\mathbf{S}; t))), Mul(Call(\\mathbf{S}; t), \\mathbf{A}), Mul(Transpose(\\mathbf{A}), Call(\\mathbf{S}; t)), Call(\\dot{\\mathbf{S}}; t)), \\mathbf{x}); =))",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "\\frac{d}{dt} E = \\frac{\\partial E}{\\partial \\theta}\\dot\\theta + \\frac{\\partial E}{\\partial \\dot\\theta}\\ddot\\theta = \\dot\\theta(ml^2\\ddot\\theta + mgl\\sin\\theta) = - b\\dot\\theta^2 \\le 0.",
        "Chain(Derivative(Call(E); t, 1), Add(Mul(Derivative(Call(E); \\theta, 1; True), Call(\\dot{\\theta})), Mul(Derivative(Call(E); \\dot{\\theta}, 1; True), Call(\\ddot{\\theta}))), Mul(Call(\\dot{\\theta}), Add(Mul(m, Pow(l; 2), Call(\\ddot{\\theta})), Mul(m, g, l, Call(sin; Call(\\theta))))), Neg(Mul(b, Pow(Call(\\dot{\\theta}); 2))), 0; =, =, =, \\le)",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "V(\\mathbf z) = \\int_0^\\infty ||{\\bf x}(t)-{\\bf x}^*||^2 dt, \\;\\text{ where } {\\bf x}(0)=\\mathbf z, \\;\\;\\dot{\\bf x} =f({\\bf x}).",
        "System(Chain(Call(V; \\mathbf{z}), Integral(Pow(Norm(Add(Call(\\mathbf{x}; t), Neg(\\mathbf { x } ^ { * }))); 2); t; 0; Infinity()); =), Chain(Call(\\mathbf{x}; 0), \\mathbf{z}; =), Chain(Call(\\dot{\\mathbf{x}}), Call(f; Call(\\mathbf{x})); =))",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "L({\\bf z},{\\bf \\lambda}) = \\ell({\\bf z}) + \\lambda^T\\phi({\\bf z}).",
        "Chain(Call(L; \\mathbf{z}, \\mathbf{\\lambda}), Add(Call(\\ell; \\mathbf{z}), Mul(Transpose(\\lambda), Call(\\phi; \\mathbf{z}))); =)",
        "RussTedrake/underactuated/book/optimization.html",
    ),
    (
        "\\min_{x,y} x+y, \\quad \\textrm{subject to} \\quad x^2 + y^2 = 1.",
        "System(Words(Limiting(min; _{ x , y }; Add(x, y))), Words(\\text{subject~to}), Chain(Add(Pow(x; 2), Pow(y; 2)), 1; =))",
        "RussTedrake/underactuated/book/optimization.html",
    ),
    (
        "\\min_{\\bf x} \\quad & {\\bf x}^T{\\bf A}{\\bf x} + {\\bf b}^T {\\bf x}, \\\\ \\text{subject to} \\quad & {\\bf x}^T{\\bf x} = 1.",
        "System(Words(Limiting(min; _{ \\mathbf { x } }; Add(Mul(Transpose(\\mathbf{x}), \\mathbf{A}, \\mathbf{x}), Mul(Transpose(\\mathbf{b}), \\mathbf{x})))), Words(\\text{subject~to}), Chain(Mul(Transpose(\\mathbf{x}), \\mathbf{x}), 1; =))",
        "RussTedrake/underactuated/book/optimization.html",
    ),
    (
        "\\dot{r} &= r(1-r), \\\\ \\dot\\theta &= \\sin^2 \\left( \\frac{\\theta}{2} \\right).",
        "System(Chain(Call(\\dot{r}), Mul(Call(r), Add(1, Neg(Call(r)))); =), Chain(Call(\\dot{\\theta}), Pow(Call(sin; Div(Call(\\theta); 2)); 2); =))",
        "RussTedrake/underactuated/book/pend.html",
    ),
    (
        "\\forall n, E\\left[ w[n] \\right] = 0,\\\\ E\\left[ w[i]w[j] \\right] = \\begin{cases} \\sigma^2, & \\text{ if } i=j,\\\\ 0, & \\text{ otherwise.} \\end{cases}",
        "System(Forall(n), Chain(Indexed(E; Indexed(w; n)), 0; =), Chain(Indexed(E; Mul(Indexed(w; i), Indexed(w; j))), Piecewise(Pow(\\sigma; 2), Chain(i, j; =), 0, None); =))",
        "RussTedrake/underactuated/book/stochastic.html",
    ),
    (
        "F_{g, W}^B = \\begin{bmatrix} 0, 0, 0, 0, 0, -mg \\end{bmatrix}^T.",
        "Chain(F _ { g , W } ^ { B }, Transpose(MatrixOf(0, 0, 0, 0, 0, Neg(Mul(m, g)))); =)",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "\\min_v && \\left|J^G(q)v - V^{G_d}\\right|^2_2\\,, \\\\ \\textrm{subject to} && v_{min} \\le v \\le v_{max}.",
        "System(Words(Limiting(min; _{ v }; Pow(Marked(Bars(Add(Mul(Call(J ^ { G }; q), v), Neg(V ^ { G _ { d } }))); _{ 2 }); 2))), Words(\\text{subject~to}), Chain(v_{min}, v, v_{max}; \\le, \\le))",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\min_{x,y} \\quad& (x-5)^2 + (y+3)^2 \\\\ \\textrm{subject to} \\quad& x - y \\le 6.",
        "System(Words(Limiting(min; _{ x , y }; Add(Pow(Add(x, Neg(5)); 2), Pow(Add(y, 3); 2)))), Words(\\text{subject~to}), Chain(Add(x, Neg(y)), 6; \\le))",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\begin{aligned} \\min_{p_x,p_y,a,b} \\quad & \\sum_i \\bigg\\| \\begin{pmatrix} p_x \\\\ p_y \\end{pmatrix} + \\begin{pmatrix} a & -b \\\\ b & a \\end{pmatrix} {}^Op^{m_{c_i}} - {}^Wp^{s_i} \\bigg\\|^2 \\\\ \\text{s.t.} \\quad & a^2 + b^2 = 1. \\end{aligned}",
        "System(Words(Limiting(min; _{ p _ { x } , p _ { y } , a , b }; BigSum(i; Pow(Norm(Add(MatrixOf(p_x, p_y), Mul(MatrixOf(a, Neg(b), b, a), \\prescript { O } { } { p } ^ { m _ { c _ { i } } }), Neg(\\prescript { W } { } { p } ^ { s _ { i } }))); 2)))), Words(\\text{subject~to}), Chain(Add(Pow(a; 2), Pow(b; 2)), 1; =))",
        "RussTedrake/manipulation/book/pose.html",
    ),
    (
        "\\min_q & \\quad |q - q_0|^2, \\\\ \\textrm{subject to} &\\quad X^G = f_{kin}(q),",
        "System(Words(Limiting(min; _{ q }; Pow(Bars(Add(q, Neg(q_0))); 2))), Words(\\text{subject~to}), Chain(X ^ { G }, Call(f_{kin}; q); =))",
        "RussTedrake/manipulation/book/trajectories.html",
    ),
    (
        "{}^A\\bar{\\alpha}^B := \\frac{{}^Ad}{dt} {}^A\\bar{\\omega}^B",
        "Chain(\\prescript { A } { } { \\bar { \\alpha } } ^ { B }, Marked(Derivative(Call(\\prescript { A } { } { \\bar { \\omega } } ^ { B }); t, 1); _{ A }); =)",
        "moorepants/learn-multibody-dynamics/angular.rst",
    ),
    (
        "\\bar{I}_a := \\sum_{i=1}^\\nu m_i \\bar{r}^{P_i/O} \\times \\left( \\hat{n}_a \\times \\bar{r}^{P_i/O} \\right)",
        "Chain(\\bar{I}_a, BigSum(i; 1; \\nu; Cross(Mul(m_i, \\bar { r } ^ { P _ { i } / O }); Cross(\\hat{n}_a; \\bar { r } ^ { P _ { i } / O }))); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "a_{11} x_1 + a_{12} x_2 + \\ldots + a_{1n} x_n + b_1 = 0 \\\\ a_{21} x_1 + a_{22} x_2 + \\ldots + a_{2n} x_n + b_2 = 0 \\\\ \\vdots \\\\ a_{n1} x_1 + a_{n2} x_2 + \\ldots + a_{nn} x_n + b_n = 0",
        "System(Chain(Add(Mul(a_{11}, x_1), Mul(a_{12}, x_2), Dots(), Mul(a_{1n}, x_n), b_1), 0; =), Chain(Add(Mul(a_{21}, x_1), Mul(a_{22}, x_2), Dots(), Mul(a_{2n}, x_n), b_2), 0; =), Words(Dots()), Chain(Add(Mul(a_{n1}, x_1), Mul(a_{n2}, x_2), Dots(), Mul(a_{nn}, x_n), b_n), 0; =))",
        "moorepants/learn-multibody-dynamics/sympy.rst",
    ),
    (
        "\\mathbb E[X] = \\sum_{i=1}^n p_ix_i",
        "Chain(Indexed(\\mathbb{E}; X), BigSum(i; 1; n; Mul(p_i, x_i)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_main.rst",
    ),
    (
        "\\dot z(t) &= \\sum_{i=1}^N c_i \\dot \\psi_i(t) \\\\ &\\, \\vdots \\\\ \\dot z^{(q)}(t) &= \\sum_{i=1}^N c_i \\psi^{(q)}_i(t).",
        "System(Chain(Call(\\dot{z}; t), BigSum(i; 1; N; Mul(c_i, Call(\\dot{\\psi}_i; t))); =), Words(Dots()), Chain(Call(\\dot { z } ^ { ( q ) }; t), BigSum(i; 1; N; Mul(c_i, Call(\\psi _ { i } ^ { ( q ) }; t))); =))",
        "python-control/python-control/doc/flatsys.rst",
    ),
    (
        "\\mathrm{dn}\\, x = \\sqrt{1-k^2\\mathrm{sn}\\,^2x}",
        "Chain(Call(dn; x), Sqrt(Add(1, Neg(Mul(Pow(k; 2), Pow(Call(sn; x); 2))))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/appendixA.tex",
    ),
    (
        "T = T_2 = \\frac12 \\sum_{\\alpha,\\beta=1}^s M_{\\alpha\\beta}\\dot{q}_\\alpha\\dot{q}_\\beta = \\dot{q}_1^2 \\left(\\frac12 \\sum_{\\alpha,\\beta=1}^s M_{\\alpha\\beta}q'_\\alpha q'_\\beta\\right)",
        "Chain(T, T_2, Mul(Div(1; 2), BigSum(\\alpha, \\beta; 1; s; Mul(M_{\\alpha \\beta}, Call(\\dot{q}_{\\alpha}), Call(\\dot{q}_{\\beta})))), Mul(Pow(Call(\\dot{q}_1); 2), Mul(Div(1; 2), BigSum(\\alpha, \\beta; 1; s; Mul(M_{\\alpha \\beta}, Call(q'_{\\alpha}), Call(q'_{\\beta}))))); =, =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "\\begin{cases} \\displaystyle x = \\frac{R\\omega_1}{\\omega_2} \\sin(\\omega_2 t + \\phi_0) - \\frac{R\\omega_1}{\\omega_2} \\sin \\phi_0 + x_0 \\\\[1,5ex] \\displaystyle y = -\\frac{R\\omega_1}{\\omega_2} \\cos(\\omega_2 t + \\phi_0) + \\frac{R\\omega_1}{\\omega_2} \\cos \\phi_0 + y_0 \\\\ \\theta = \\omega_1 t + \\theta_0 \\\\ \\phi = \\omega_2 t + \\phi_0 \\\\ \\lambda_1 = -R\\omega_1 \\omega_2 \\sin \\phi \\\\ \\lambda_2 = R\\omega_1 \\omega_2 \\cos \\phi \\end{cases}",
        "System(Chain(x, Add(Mul(Div(Mul(R, \\omega_1); \\omega_2), Call(sin; Add(Mul(\\omega_2, t), \\phi_0))), Neg(Mul(Div(Mul(R, \\omega_1); \\omega_2), Call(sin; \\phi_0))), x_0); =), Chain(y, Add(Neg(Mul(Div(Mul(R, \\omega_1); \\omega_2), Call(cos; Add(Mul(\\omega_2, t), \\phi_0)))), Mul(Div(Mul(R, \\omega_1); \\omega_2), Call(cos; \\phi_0)), y_0); =), Chain(\\theta, Add(Mul(\\omega_1, t), \\theta_0); =), Chain(\\phi, Add(Mul(\\omega_2, t), \\phi_0); =), Chain(\\lambda_1, Neg(Mul(R, \\omega_1, \\omega_2, Call(sin; \\phi))); =), Chain(\\lambda_2, Mul(R, \\omega_1, \\omega_2, Call(cos; \\phi)); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "\\sigma_t = \\frac{a^2}{4} \\int \\mathrm{d} \\omega = \\frac{a^2}{4} 4\\pi = \\pi a^2",
        "Chain(\\sigma_t, Mul(Div(Pow(a; 2); 4), Antiderivative(1; \\omega)), Mul(Div(Pow(a; 2); 4), 4, \\pi), Mul(\\pi, Pow(a; 2)); =, =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "I_n = \\int_V \\rho |\\boldsymbol{n} \\times \\boldsymbol{r}|^2 \\mathrm{d} V",
        "Chain(I_n, Over(\\int; _ { V }; Mul(\\rho, Pow(Bars(Cross(\\boldsymbol{n}; \\boldsymbol{r})); 2)); V); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "|\\boldsymbol{K}-\\omega^2 \\boldsymbol{M}| = \\begin{vmatrix} \\omega_0^2-\\omega^2 & -\\alpha \\\\ -\\alpha & \\omega_0^2-\\omega^2 \\end{vmatrix} = 0",
        "Chain(Bars(Add(\\boldsymbol{K}, Neg(Mul(Pow(\\omega; 2), \\boldsymbol{M})))), Bars(MatrixOf(Add(Pow(\\omega_0; 2), Neg(Pow(\\omega; 2))), Neg(\\alpha), Neg(\\alpha), Add(Pow(\\omega_0; 2), Neg(Pow(\\omega; 2))))), 0; =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "K_1 = \\left[1.2 + \\frac{160}{\\text{Re}_1}\\right] \\left[ \\left(\\frac{D_1} {D_2} \\right)^4 -1 \\right]",
        "Chain(K_1, Mul(Add(1.2, Div(160; \\text{Re}_1)), Add(Pow(Div(D_1; D_2); 4), Neg(1))); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "V_{1,max} = v_1(h=h_1)",
        "Chain(V_{1,max}, Call(v_1; Chain(h, h_1; =)); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "V = \\frac{\\pi D^2 h}{4} - v_1(h=a_1+a_2) + v_1(h=a_1 + a_2 -h),\\; 0 \\le h < a_2",
        "System(Chain(V, Add(Div(Mul(\\pi, Pow(D; 2), h); 4), Neg(Call(v_1; Chain(h, Add(a_1, a_2); =))), Call(v_1; Chain(h, Add(a_1, a_2, Neg(h)); =))); =), Chain(0, h, a_2; \\le, <))",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\vec{e}_1 = \\begin{bmatrix} 1 \\\\ 0 \\\\ 0 \\\\ \\vdots \\\\ 0 \\end{bmatrix} , \\qquad \\vec{e}_2 = \\begin{bmatrix} 0 \\\\ 1 \\\\ 0 \\\\ \\vdots \\\\ 0 \\end{bmatrix} , \\qquad \\vec{e}_3 = \\begin{bmatrix} 0 \\\\ 0 \\\\ 1 \\\\ \\vdots \\\\ 0 \\end{bmatrix} , \\qquad \\cdots , \\qquad \\vec{e}_n = \\begin{bmatrix} 0 \\\\ 0 \\\\ 0 \\\\ \\vdots \\\\ 1 \\end{bmatrix} .",
        "System(Chain(\\vec{e}_1, MatrixOf(1, 0, 0, Dots(), 0); =), Chain(\\vec{e}_2, MatrixOf(0, 1, 0, Dots(), 0); =), Chain(\\vec{e}_3, MatrixOf(0, 0, 1, Dots(), 0); =), Words(Dots()), Chain(\\vec{e}_n, MatrixOf(0, 0, 0, Dots(), 1); =))",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "\\left\\langle \\left(\\frac{16}{7},\\frac{4}{7},\\frac{-8}{7}\\right) , (1,2,3) \\right\\rangle = \\frac{16}{7} \\cdot 1 + \\frac{4}{7} \\cdot 2 -\\frac{8}{7} \\cdot 3 = 0 .",
        "Chain(Pair(Tuple(Div(16; 7), Div(4; 7), Div(Neg(8); 7); ()); Tuple(1, 2, 3; ())), Add(Mul(Div(16; 7), 1), Mul(Div(4; 7), 2), Neg(Mul(Div(8; 7), 3))), 0; =, =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "\\begin{vmatrix} a & b \\\\ c & d \\end{vmatrix} = \\det \\left( \\begin{bmatrix} a & b \\\\ c & d \\end{bmatrix} \\right) .",
        "Chain(Bars(MatrixOf(a, b, c, d)), Call(det; MatrixOf(a, b, c, d)); =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "f(x) = \\sum_{\\substack{n=1\\\\n \\text{~odd}}}^\\infty \\frac{-4}{5\\pi^3 n^3} \\sin (n \\pi x) .",
        "Chain(Call(f; x), Limiting(sum; _{ \\substack { n = 1 \\\\ n \\text { ~ o d d } } }^{ \\infty }; Mul(Div(Neg(4); Mul(5, Pow(\\pi; 3), Pow(n; 3))), Call(sin; Mul(n, \\pi, x)))); =)",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "\\frac{1}{2} \\ln \\left\\lvert \\frac{v+1}{v-1} \\right\\rvert = x + C , \\qquad \\text{or} \\qquad \\left\\lvert \\frac{v+1}{v-1} \\right\\rvert = e^{2x + 2C} , \\qquad \\text{or} \\qquad \\frac{v+1}{v-1} = D e^{2x} ,",
        "System(Chain(Mul(Div(1; 2), Call(ln; Bars(Div(Add(v, 1); Add(v, Neg(1)))))), Add(x, C); =), Words(\\text{~or~}), Chain(Bars(Div(Add(v, 1); Add(v, Neg(1)))), Pow(e; Add(Mul(2, x), Mul(2, C))); =), Words(\\text{~or~}), Chain(Div(Add(v, 1); Add(v, Neg(1))), Mul(D, Pow(e; Mul(2, x))); =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\frac{dx}{dt} = kx(M-x) ,",
        "Chain(Derivative(Call(x); t, 1), Mul(k, Call(x), Add(M, Neg(Call(x)))); =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "y(a) = b_0, \\quad y'(a) = b_1, \\quad \\ldots, \\quad y^{(n-1)}(a) = b_{n-1} .",
        "System(Chain(Call(y; a), b_0; =), Chain(Call(y'; a), b_1; =), Words(Dots()), Chain(Call(y ^ { ( n - 1 ) }; a), b_{n-1}; =))",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "A = \\lim_{k\\to\\infty} \\sqrt[k]{\\lvert a_k \\rvert} = \\lim_{k\\to\\infty} \\sqrt[k]{ \\left\\lvert\\frac{1}{k^k}\\right\\rvert} = \\lim_{k\\to\\infty} \\sqrt[k]{ {\\left\\lvert\\frac{1}{k}\\right\\rvert}^{k}} = \\lim_{k\\to\\infty} \\frac{1}{k} = 0 .",
        "Chain(A, Limiting(lim; _{ k \\to \\infty }; Root(Bars(a_k); k)), Limiting(lim; _{ k \\to \\infty }; Root(Bars(Div(1; Pow(k; k))); k)), Limiting(lim; _{ k \\to \\infty }; Root(Pow(Bars(Div(1; k)); k); k)), Limiting(lim; _{ k \\to \\infty }; Div(1; k)), 0; =, =, =, =, =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "a_k = \\frac{1}{k(k-1)(k-2) \\cdots 3 \\cdot 2} = \\frac{1}{k!} .",
        "Chain(a_k, Div(1; Mul(k, Add(k, Neg(1)), Add(k, Neg(2)), Dots(), 3, 2)), Div(1; Factorial(k)); =, =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "\\begin{bmatrix} 0 \\\\ 6 \\end{bmatrix} = {\\vec{x}}'(0) = \\begin{bmatrix} 1 \\\\ 2 \\end{bmatrix} b_1 + \\begin{bmatrix} 1 \\\\ -1 \\end{bmatrix} 2 b_2 = \\begin{bmatrix} b_1+2b_2 \\\\ 2b_1-2b_2 \\end{bmatrix} .",
        "Chain(MatrixOf(0, 6), Call(\\vec{x}'; 0), Add(Mul(MatrixOf(1, 2), b_1), Mul(MatrixOf(1, Neg(1)), 2, b_2)), MatrixOf(Add(b_1, Mul(2, b_2)), Add(Mul(2, b_1), Neg(Mul(2, b_2)))); =, =, =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\vec{x}'' = M^{-1}K \\vec{x} + M^{-1} \\vec{G} \\cos(\\omega t) \\qquad \\text{or} \\qquad \\vec{x}'' = A \\vec{x} + \\vec{F} \\cos(\\omega t) ,",
        "System(Chain(\\vec{x}'', Add(Mul(Pow(M; Neg(1)), K, \\vec{x}), Mul(Pow(M; Neg(1)), \\vec{G}, Call(cos; Mul(\\omega, t)))); =), Words(\\text{~or~}), Chain(\\vec{x}'', Add(Mul(A, \\vec{x}), Mul(\\vec{F}, Call(cos; Mul(\\omega, t)))); =))",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "G_q(a) = \\sum_{x \\bmod q} \\chi_q(a, x) e^{\\frac{2i\\pi x}q}",
        "Chain(Call(G_q; a), Limiting(sum; _{ x \\bmod q }; Mul(Call(\\chi_q; a, x), Pow(e; Div(Mul(2, i, \\pi, x); q)))); =)",
        "fredrik-johansson/arb/doc/source/acb_dirichlet.rst",
    ),
    (
        "{}_pF_q(a_1,\\ldots,a_p;b_1,\\ldots,b_q;z) = \\sum_{k=0}^\\infty \\frac{(a_1)_k\\dots(a_p)_k}{(b_1)_k\\dots(b_q)_k} \\frac {z^k} {k!}.",
        "Chain(Call(\\prescript { } { p } { F } _ { q }; Given(a_1, Dots(), a_p; Given(b_1, Dots(), b_q; z; ;); ;)), BigSum(k; 0; Infinity(); Mul(Div(Mul(Marked(a_1; _{ k }), Dots(), Marked(a_p; _{ k })); Mul(Marked(b_1; _{ k }), Dots(), Marked(b_q; _{ k }))), Div(Pow(z; k); Factorial(k)))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "\\operatorname{Ei}(z) = z {}_2F_2(1, 1; 2, 2; z) + \\gamma + \\frac{1}{2} \\left(\\log(z) - \\log\\left(\\frac{1}{z}\\right) \\right)",
        "Chain(Call(\\text{Ei}; z), Add(Mul(z, Call(\\prescript { } { 2 } { F } _ { 2 }; Given(1, 1; Given(2, 2; z; ;); ;))), \\gamma, Mul(Div(1; 2), Add(Call(log; z), Neg(Call(log; Div(1; z)))))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "Q_n^m(z) = \\frac{\\pi}{2 \\sin(\\pi m)} \\left( \\cos(\\pi m) P_n^m(z) - \\frac{\\Gamma(1+m+n)}{\\Gamma(1-m+n)} P_n^{-m}(z)\\right)",
        "Chain(Call(Q _ { n } ^ { m }; z), Mul(Div(\\pi; Mul(2, Call(sin; Mul(\\pi, m)))), Add(Mul(Call(cos; Mul(\\pi, m)), Call(P _ { n } ^ { m }; z)), Neg(Mul(Div(Call(Gamma; Add(1, m, n)); Call(Gamma; Add(1, Neg(m), n))), Call(P _ { n } ^ { - m }; z))))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "= m^{1/k} [1 - \\exp(\\log(1-r/m)/k)]",
        "Chain(Blank(), Mul(Pow(m; Div(1; k)), Add(1, Neg(Call(exp; Div(Call(log; Add(1, Neg(Div(r; m)))); k))))); =)",
        "fredrik-johansson/arb/doc/source/arb.rst",
    ),
    (
        "\\frac{1}{\\pi} = 12 \\sum^\\infty_{k=0} \\frac{(-1)^k (6k)! (13591409 + 545140134k)}{(3k)!(k!)^3 640320^{3k + 3/2}}",
        "Chain(Div(1; \\pi), Mul(12, BigSum(k; 0; Infinity(); Div(Mul(Pow(Neg(1); k), Factorial(Mul(6, k)), Add(13591409, Mul(545140134, k))); Mul(Factorial(Mul(3, k)), Pow(Factorial(k); 3), Pow(640320; Add(Mul(3, k), Div(3; 2))))))); =)",
        "fredrik-johansson/arb/doc/source/constants.rst",
    ),
    (
        "|f_{[k]}| \\le g_{[k]} = A {{N+k} \\choose k} \\nu^k.",
        "Chain(Bars(f_{[k]}), g_{[k]}, Mul(A, Binomial(Add(N, k); k), Pow(\\nu; k)); \\le, =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "F(z) = C \\times {}_{p+1}F_{q}\\left( \\begin{matrix} 1, (1 + l_u - l_i), (1 + l_u + b - a_i)^* \\\\ 1 + l_u, (1 + l_u - k_i), (1 + l_u + b - b_i)^* \\end{matrix} \\middle| (-1)^{p-m-n} z\\right),",
        "Chain(Call(F; z), Cross(C; Call(\\prescript { } { p + 1 } { F } _ { q }; Given(MatrixOf(1, Add(1, l_u, Neg(l_i)), Marked(Add(1, l_u, b, Neg(a_i)); ^*), Add(1, l_u), Add(1, l_u, Neg(k_i)), Marked(Add(1, l_u, b, Neg(b_i)); ^*)); Mul(Pow(Neg(1); Add(p, Neg(m), Neg(n))), z); |))); =)",
        "sympy/sympy/doc/src/modules/simplify/hyperexpand.rst",
    ),
    (
        "mR^2\\sin^2\\theta\\ddot{\\phi} + mR^2\\sin(2\\theta)\\dot{\\theta}\\dot{\\phi} + k\\frac{\\partial L_{total}}{\\partial \\phi}(L_{total} - L_0) = 0",
        "Chain(Add(Mul(m, Pow(R; 2), Pow(Call(sin; Call(\\theta)); 2), Call(\\ddot{\\phi})), Mul(m, Pow(R; 2), Call(sin; Mul(2, Call(\\theta))), Call(\\dot{\\theta}), Call(\\dot{\\phi})), Mul(k, Derivative(Call(L_{total}); \\phi, 1; True), Add(Call(L_{total}), Neg(L_0)))), 0; =)",
        "sympy/sympy/doc/src/tutorials/physics/mechanics/muscle_model_example.rst",
    ),
    (
        "1 = p_1 \\prod_{i \\ne 1}q_i + \\cdots + p_n \\prod_{i \\ne n}q_i",
        "Chain(1, Add(Mul(p_1, Limiting(prod; _{ i \\ne 1 }; q_i)), Dots(), Mul(p_n, Limiting(prod; _{ i \\ne n }; q_i))); =)",
        "sympy/sympy/sympy/functions/elementary/_trigonometric_special.py",
    ),
    (
        "\\hat{\\bm g}_{s_{1}} = {\\vphantom{\\begin{bmatrix} 1 \\\\ 0 \\\\ 0 \\end{bmatrix}}}^{\\mathcal{B}\\!}{\\begin{bmatrix} 1 \\\\ 0 \\\\ 0 \\end{bmatrix}} \\quad\\quad \\hat{\\bm g}_{s_{2}} = {\\vphantom{\\begin{bmatrix} 0 \\\\ 1 \\\\ 0 \\end{bmatrix}}}^{\\mathcal{B}\\!}{\\begin{bmatrix} 0 \\\\ 1 \\\\ 0 \\end{bmatrix}} \\quad\\quad \\hat{\\bm g}_{s_{3}} = {\\vphantom{\\begin{bmatrix} 0 \\\\ 0 \\\\ 1 \\end{bmatrix}}}^{\\mathcal{B}\\!}{\\begin{bmatrix} 0 \\\\ 0 \\\\ 1 \\end{bmatrix}} \\quad\\quad \\hat{\\bm g}_{s_{4}} = {\\vphantom{\\begin{bmatrix} 0.57735 \\\\ 0.57735 \\\\ 0.57735 \\end{bmatrix}}}^{\\mathcal{B}\\!}{\\begin{bmatrix} 0.57735 \\\\ 0.57735 \\\\ 0.57735 \\end{bmatrix}}",
        "System(Chain(\\hat{\\bm{g}}_{s_1}, Marked(MatrixOf(1, 0, 0); _{ \\mathcal { B } }); =), Chain(\\hat{\\bm{g}}_{s_2}, Marked(MatrixOf(0, 1, 0); _{ \\mathcal { B } }); =), Chain(\\hat{\\bm{g}}_{s_3}, Marked(MatrixOf(0, 0, 1); _{ \\mathcal { B } }); =), Chain(\\hat{\\bm{g}}_{s_4}, Marked(MatrixOf(0.57735, 0.57735, 0.57735); _{ \\mathcal { B } }); =))",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/rwNullSpace/_Documentation/secTest.tex",
    ),
    (
        "\\bm g_{t_{1}} = \\begin{bmatrix} +0.707107, +0.707107, 0 \\end{bmatrix}^{T} \\quad\\quad \\bm g_{t_{2}} = \\begin{bmatrix} -0.707107, +0.707107, 0 \\end{bmatrix}^{T} \\\\ \\bm g_{t_{3}} = \\begin{bmatrix} -0.707107, -0.707107, 0 \\end{bmatrix}^{T} \\quad\\quad \\bm g_{t_{4}} = \\begin{bmatrix} +0.707107, -0.707107, 0 \\end{bmatrix}^{T} \\\\ \\bm g_{t_{5}} = \\begin{bmatrix} +0.707107, +0.707107, 0 \\end{bmatrix}^{T} \\quad\\quad \\bm g_{t_{6}} = \\begin{bmatrix} -0.707107, +0.707107, 0 \\end{bmatrix}^{T} \\\\ \\bm g_{t_{7}} = \\begin{bmatrix} -0.707107, -0.707107, 0 \\end{bmatrix}^{T} \\quad\\quad \\bm g_{t_{8}} = \\begin{bmatrix} +0.707107, -0.707107, 0 \\end{bmatrix}^{T}",
        "System(Chain(\\bm{g}_{t_1}, Transpose(MatrixOf(0.707107, 0.707107, 0)); =), Chain(\\bm{g}_{t_2}, Transpose(MatrixOf(Neg(0.707107), 0.707107, 0)); =), Chain(\\bm{g}_{t_3}, Transpose(MatrixOf(Neg(0.707107), Neg(0.707107), 0)); =), Chain(\\bm{g}_{t_4}, Transpose(MatrixOf(0.707107, Neg(0.707107), 0)); =), Chain(\\bm{g}_{t_5}, Transpose(MatrixOf(0.707107, 0.707107, 0)); =), Chain(\\bm{g}_{t_6}, Transpose(MatrixOf(Neg(0.707107), 0.707107, 0)); =), Chain(\\bm{g}_{t_7}, Transpose(MatrixOf(Neg(0.707107), Neg(0.707107), 0)); =), Chain(\\bm{g}_{t_8}, Transpose(MatrixOf(0.707107, Neg(0.707107), 0)); =))",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/thrForceMapping/_Documentation/secTest.tex",
    ),
    (
        "\\dot{\\bm \\sigma}_{RN} = \\frac{{\\bm \\sigma}_{RN}(\\textrm{t}) - {\\bm \\sigma}_{RN}(\\textrm{t-1})}{\\Delta \\textrm{t}}",
        "Chain(Call(\\dot{\\bm{\\sigma}}_{RN}), Div(Add(Call(\\bm{\\sigma}_{RN}; \\text{t}), Neg(Call(\\bm{\\sigma}_{RN}; \\text{t-1}))); Mul(\\Delta, \\text{t})); =)",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/spacecraftPointing/_Documentation/secModuleDescription.tex",
    ),
    (
        "m_j l_j^2\\ddot{\\varphi}_j\\cos^2(\\vartheta_j) -m_{j} \\bm{\\hat{p}}_{0_j,3}^T [\\bm{\\tilde{l}_j}]([\\bm{\\tilde{l}_j}]+ [\\bm{\\tilde{d}}]) \\bm{\\dot{\\omega}}_{B/N} +m_{j} \\bm{\\hat{p}}_{0_j,3}^{T} [\\bm{\\tilde{l}_j}] \\bm{\\ddot{r}}_{B/N} =-m_{j} \\bm{\\hat{p}}_{0_j,3}^{T} [\\bm{\\tilde{l}_j}][\\bm{\\tilde{\\omega}}_{\\cal B/N}][\\bm{\\tilde{\\omega}}_{\\cal B/N}] \\bm{d}\\\\+\\bm{\\hat{p}}_{0_j,3}^T \\bm{L}_{T,j}+2m_j l_j^2\\dot{\\varphi}_j\\dot{\\vartheta}\\cos(\\vartheta_j)\\sin(\\vartheta_j)- m_j \\bm{\\hat{p}}_{0_j,3}^T [\\bm{\\tilde{l}_j}]\\bigg[2[\\bm{\\tilde{\\omega}}_{\\cal B/N}] \\bm{l_j'}+[\\bm{\\tilde{\\omega}}_{\\cal B/N}][\\bm{\\tilde{\\omega}}_{\\cal B/N}] \\bm{l_j}\\bigg]",
        "Chain(Add(Mul(m_j, Pow(l_j; 2), Call(\\ddot{\\varphi}_j), Pow(Call(cos; \\vartheta_j); 2)), Neg(Mul(m_j, Transpose(\\bm{\\hat{p}}_{0_j,3}), [ \\bm { \\tilde { l } } _ { j } ], Add([ \\bm { \\tilde { l } } _ { j } ], [ \\bm { \\tilde { d } } ]), \\bm{\\dot{\\omega}}_{B/N})), Mul(m_j, Transpose(\\bm{\\hat{p}}_{0_j,3}), [ \\bm { \\tilde { l } } _ { j } ], \\bm{\\ddot{r}}_{B/N})), Add(Neg(Mul(m_j, Transpose(\\bm{\\hat{p}}_{0_j,3}), [ \\bm { \\tilde { l } } _ { j } ], [ \\bm { \\tilde { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ \\bm { \\tilde { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{d})), Mul(Transpose(\\bm{\\hat{p}}_{0_j,3}), \\bm{L}_{T,j}), Mul(2, m_j, Pow(l_j; 2), Call(\\dot{\\varphi}_j), Call(\\dot{\\vartheta}), Call(cos; \\vartheta_j), Call(sin; \\vartheta_j)), Neg(Mul(m_j, Transpose(\\bm{\\hat{p}}_{0_j,3}), [ \\bm { \\tilde { l } } _ { j } ], Add(Mul(2, [ \\bm { \\tilde { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{l}_j'), Mul([ \\bm { \\tilde { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ \\bm { \\tilde { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{l}_j))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/sphericalPendulum/_Documentation/secModelDescription.tex",
    ),
    (
        "\\bm m = {\\vphantom{\\begin{bmatrix} g_{1}^{1} \\\\ h_{1}^{1} \\\\ g_{1}^{0} \\end{bmatrix}}}^{\\mathcal{E}\\!}{\\begin{bmatrix} g_{1}^{1} \\\\ h_{1}^{1} \\\\ g_{1}^{0} \\end{bmatrix}}",
        "Chain(\\bm{m}, Marked(MatrixOf(Pow(g_1; 1), Pow(h_1; 1), Pow(g_1; 0)); _{ \\mathcal { E } }); =)",
        "AVSLab/basilisk/src/simulation/environment/magneticFieldCenteredDipole/_Documentation/secModuleDescription.tex",
    ),
    (
        "|\\mathbf{R}| = \\begin{vmatrix}r_{11} & r_{12} & r_{13} \\\\ r_{21} & r_{22} & r_{23} \\\\ r_{31} & r_{32} & r_{33}\\end{vmatrix}= r_{11}\\begin{vmatrix}r_{22} & r_{23}\\\\r_{32} & r_{33}\\end{vmatrix} - r_{12}\\begin{vmatrix}r_{21} & r_{23}\\\\r_{31} & r_{33}\\end{vmatrix} + r_{13}\\begin{vmatrix}r_{21} & r_{22}\\\\r_{31} & r_{32}\\end{vmatrix}",
        "Chain(Bars(\\mathbf{R}), Bars(MatrixOf(r_{11}, r_{12}, r_{13}, r_{21}, r_{22}, r_{23}, r_{31}, r_{32}, r_{33})), Add(Mul(r_{11}, Bars(MatrixOf(r_{22}, r_{23}, r_{32}, r_{33}))), Neg(Mul(r_{12}, Bars(MatrixOf(r_{21}, r_{23}, r_{31}, r_{33})))), Mul(r_{13}, Bars(MatrixOf(r_{21}, r_{22}, r_{31}, r_{32})))); =, =)",
        "Mayitzin/ahrs/ahrs/common/dcm.py",
    ),
    (
        "\\begin{array}{rcl} \\dot{\\mathbf{q}} &=& \\underset{\\Delta t\\to 0}{\\mathrm{lim}} \\frac{\\mathbf{q}(t+\\Delta t) - \\mathbf{q}(t)}{\\Delta t} \\\\ &=& \\frac{1}{2}\\boldsymbol\\Omega_t\\mathbf{q}_{t-1} \\\\\\ &=& \\frac{1}{2} \\begin{bmatrix} -\\omega_x q_x -\\omega_y q_y - \\omega_z q_z\\\\ \\omega_x q_w + \\omega_z q_y - \\omega_y q_z\\\\ \\omega_y q_w - \\omega_z q_x + \\omega_x q_z\\\\ \\omega_z q_w + \\omega_y q_x - \\omega_x q_y \\end{bmatrix} \\end{array}",
        "Chain(Call(\\dot{\\mathbf{q}}), Limiting(lim; _{ \\Delta t \\to 0 }; Div(Add(Call(\\mathbf{q}; Add(t, \\Delta t)), Neg(Call(\\mathbf{q}; t))); \\Delta t)), Mul(Div(1; 2), \\boldsymbol{\\Omega}_t, \\mathbf{q}_{t-1}), Mul(Div(1; 2), MatrixOf(Add(Neg(Mul(\\omega_x, q_x)), Neg(Mul(\\omega_y, q_y)), Neg(Mul(\\omega_z, q_z))), Add(Mul(\\omega_x, q_w), Mul(\\omega_z, q_y), Neg(Mul(\\omega_y, q_z))), Add(Mul(\\omega_y, q_w), Neg(Mul(\\omega_z, q_x)), Mul(\\omega_x, q_z)), Add(Mul(\\omega_z, q_w), Mul(\\omega_y, q_x), Neg(Mul(\\omega_x, q_y))))); =, =, =)",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "L(\\mathbf{C}) = \\frac{1}{2}\\Big[\\frac{1}{2}\\|^b\\mathbf{a}-\\mathbf{C}\\,^r\\mathbf{a}\\|^2+\\frac{1}{2}\\|^b\\mathbf{m}-\\mathbf{C}\\,^r\\mathbf{m}\\|^2\\Big]",
        "Chain(Call(L; \\mathbf{C}), Mul(Div(1; 2), Add(Mul(Div(1; 2), Pow(Norm(Add(\\prescript { b } { } { \\mathbf { a } }, Neg(Mul(\\mathbf{C}, \\prescript { r } { } { \\mathbf { a } })))); 2)), Mul(Div(1; 2), Pow(Norm(Add(\\prescript { b } { } { \\mathbf { m } }, Neg(Mul(\\mathbf{C}, \\prescript { r } { } { \\mathbf { m } })))); 2)))); =)",
        "Mayitzin/ahrs/ahrs/filters/famc.py",
    ),
    (
        "\\begin{bmatrix}n_x \\\\ n_y\\end{bmatrix}= \\begin{bmatrix}\\cos\\psi & -\\sin\\psi \\\\ \\sin\\psi & \\cos\\psi\\end{bmatrix} \\begin{bmatrix}^em_x \\\\ ^em_y\\end{bmatrix}",
        "Chain(MatrixOf(n_x, n_y), Mul(MatrixOf(Call(cos; \\psi), Neg(Call(sin; \\psi)), Call(sin; \\psi), Call(cos; \\psi)), MatrixOf(\\prescript { e } { } { m } _ { x }, \\prescript { e } { } { m } _ { y })); =)",
        "Mayitzin/ahrs/ahrs/filters/fqa.py",
    ),
    (
        "{}_B\\mbox{\\boldmath $\\omega$}_{I\\!B} = \\mathbf C_{I\\!B}^T \\cdot \\mathbf E(\\mbox{\\boldmath $\\chi$}) \\cdot \\dot{\\mbox{\\boldmath $\\chi$}}",
        "Chain(\\prescript { } { B } { \\boldsymbol { \\omega } } _ { I \\! B }, Mul(Transpose(\\mathbf{C}_{I\\!B}), Call(\\mathbf{E}; Call(\\boldsymbol{\\chi})), Call(\\dot{\\boldsymbol{\\chi}}); 2); =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "\\frac{d\\Delta v}{d\\Delta i} = \\frac{v_1 v_{t1}\\sin\\Delta i}{\\sqrt{v_1^2 + v_{t1}^2 - 2v_1v_{t1}\\cos\\Delta i}} - \\frac{v_2 v_{t2}\\sin\\left(28.6° - \\Delta i\\right)}{\\sqrt{v_2^2 + v_{t2}^2 - 2v_2v_{t2}\\cos\\left(28.6° - \\Delta i\\right)}} = 0",
        "Chain(Derivative(Call(\\Delta v); \\Delta i, 1), Add(Div(Mul(v_1, v_{t1}, Call(sin; \\Delta i)); Sqrt(Add(Pow(v_1; 2), Pow(v_{t1}; 2), Neg(Mul(2, v_1, v_{t1}, Call(cos; \\Delta i)))))), Neg(Div(Mul(v_2, v_{t2}, Call(sin; Add(Degrees(28.6), Neg(\\Delta i)))); Sqrt(Add(Pow(v_2; 2), Pow(v_{t2}; 2), Neg(Mul(2, v_2, v_{t2}, Call(cos; Add(Degrees(28.6), Neg(\\Delta i)))))))))), 0; =, =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/plane-change-example.md",
    ),
    (
        "(I_1 + I_2 + m_2 l_1^2 + 2m_2 l_1 l_{c2} c_2) \\ddot{q}_1 + (I_2 + m_2 l_1 l_{c2} c_2)\\ddot{q}_2 - 2m_2 l_1 l_{c2} s_2 \\dot{q}_1 \\dot{q}_2 \\\\ \\quad -m_2 l_1 l_{c2} s_2 \\dot{q}_2^2 + m_1 g l_{c1}s_1 + m_2 g (l_1 s_1 + l_{c2} s_{1+2}) = 0 \\\\ (I_2 + m_2 l_1 l_{c2} c_2) \\ddot{q}_1 + I_2 \\ddot{q}_2 + m_2 l_1 l_{c2} s_2 \\dot{q}_1^2 + m_2 g l_{c2} s_{1+2} = \\tau",
        "System(Chain(Add(Mul(Add(I_1, I_2, Mul(m_2, Pow(l_1; 2)), Mul(2, m_2, l_1, l_{c2}, c_2)), Call(\\ddot{q}_1)), Mul(Add(I_2, Mul(m_2, l_1, l_{c2}, c_2)), Call(\\ddot{q}_2)), Neg(Mul(2, m_2, l_1, l_{c2}, s_2, Call(\\dot{q}_1), Call(\\dot{q}_2))), Neg(Mul(m_2, l_1, l_{c2}, s_2, Pow(Call(\\dot{q}_2); 2))), Mul(m_1, g, l_{c1}, s_1), Mul(m_2, g, Add(Mul(l_1, s_1), Mul(l_{c2}, s_{1+2})))), 0; =), Chain(Add(Mul(Add(I_2, Mul(m_2, l_1, l_{c2}, c_2)), Call(\\ddot{q}_1)), Mul(I_2, Call(\\ddot{q}_2)), Mul(m_2, l_1, l_{c2}, s_2, Pow(Call(\\dot{q}_1); 2)), Mul(m_2, g, l_{c2}, s_{1+2})), \\tau; =))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "{\\bf x} = \\begin{bmatrix}x_1 \\\\ x_2\\end{bmatrix}, \\text{ and } x_1[n], x_2[n] \\in \\mathbb{Z}.",
        "System(Chain(\\mathbf{x}, MatrixOf(x_1, x_2); =), Chain(Indexed(x_1; n), \\mathbb{Z}; \\in), Chain(Indexed(x_2; n), \\mathbb{Z}; \\in))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\min_\\tau || x(t) - x^*(\\tau) || \\rightarrow 0.",
        "Chain(Limiting(min; _{ \\tau }; Norm(Add(Call(x; t), Neg(Call(x ^ { * }; \\tau))))), 0; \\rightarrow)",
        "RussTedrake/underactuated/book/limit_cycles.html",
    ),
    (
        "\\mathit{VAR}(X) = \\frac{1}{n}\\sum_{i=1}^n (x_i - \\mu)^2",
        "Chain(Call(\\text{VAR}; X), Mul(Div(1; n), BigSum(i; 1; n; Pow(Add(x_i, Neg(\\mu)); 2))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_main.rst",
    ),
    (
        "\\mathbf{q} = \\begin{bmatrix} q_w \\ q_x \\ q_y \\ q_z \\end{bmatrix} = \\begin{bmatrix} \\cos (\\frac{\\theta}{2}) \\\\ n_x \\sin (\\frac{\\theta}{2}) \\\\ n_y \\sin (\\frac{\\theta}{2}) \\\\ n_z \\sin (\\frac{\\theta}{2}) \\end{bmatrix}",
        "Chain(\\mathbf{q}, MatrixOf(q_w, q_x, q_y, q_z), MatrixOf(Call(cos; Div(\\theta; 2)), Mul(n_x, Call(sin; Div(\\theta; 2))), Mul(n_y, Call(sin; Div(\\theta; 2))), Mul(n_z, Call(sin; Div(\\theta; 2)))); =, =)",
        "Mayitzin/ahrs/ahrs/common/orientation.py",
    ),
    (
        "\\mathbf{M}_k \\dot{\\bar{q}} + \\bar{g}_k = 0 \\rightarrow - \\begin{bmatrix} 1 & 0 & 0 \\\\ 0 & 1 & 0 \\\\ 0 & 0 & 1 \\\\ \\end{bmatrix} \\begin{bmatrix} \\dot{q}_1 \\\\ \\dot{q}_2 \\\\ \\dot{q}_3 \\end{bmatrix} + \\begin{bmatrix} u_1 \\\\ u_2 \\\\ u_3 \\end{bmatrix} = \\begin{bmatrix} 0 \\\\ 0 \\\\ 0 \\end{bmatrix}",
        "Implies(Chain(Add(Mul(\\mathbf{M}_k, Call(\\dot{\\bar{q}})), \\bar{g}_k), 0; =); Chain(Add(Neg(Mul(MatrixOf(1, 0, 0, 0, 1, 0, 0, 0, 1), MatrixOf(Call(\\dot{q}_1), Call(\\dot{q}_2), Call(\\dot{q}_3)))), MatrixOf(u_1, u_2, u_3)), MatrixOf(0, 0, 0); =))",
        "moorepants/learn-multibody-dynamics/eom.rst",
    ),
    (
        "-\\bar{F}^*_r = \\bar{F}_r \\rightarrow \\mathbf{M}(\\bar{q}, t) \\dot{\\bar{u}} + \\bar{C}(\\bar{u}, \\bar{q}, t) = \\bar{F}(\\bar{u}, \\bar{q}, t)",
        "Implies(Chain(Neg(\\bar { F } _ { r } ^ { * }), \\bar{F}_r; =); Chain(Add(Mul(Call(\\mathbf{M}; \\bar{q}, t), Call(\\dot{\\bar{u}})), Call(\\bar{C}; Call(\\bar{u}), \\bar{q}, t)), Call(\\bar{F}; Call(\\bar{u}), \\bar{q}, t); =))",
        "moorepants/learn-multibody-dynamics/eom.rst",
    ),
    (
        "\\frac{Likelihood*Prior}{Marginal}",
        "Div(Operated(*; \\text{Likelihood}; \\text{Prior}); \\text{Marginal})",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_2_main.rst",
    ),
    (
        "[RN(\\bm\\sigma_{R/N})] = [R_{0}R(\\bm\\sigma_{R_{0}/R})]^{T} [R_{0}N(\\bm\\sigma_{R_{0}/N})] = [R_{0}R(-\\bm\\sigma_{R_{0}/R})] [R_{0}N(\\bm\\sigma_{R_{0}/N})]",
        "Chain(Call([ R N ]; \\bm{\\sigma}_{R/N}), Mul(Transpose(Call([ R _ { 0 } R ]; \\bm{\\sigma}_{R_0/R})), Call([ R _ { 0 } N ]; \\bm{\\sigma}_{R_0/N})), Mul(Call([ R _ { 0 } R ]; Neg(\\bm{\\sigma}_{R_0/R})), Call([ R _ { 0 } N ]; \\bm{\\sigma}_{R_0/N})); =, =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/attTrackingError/_Documentation/secModuleDescription.tex",
    ),
    (
        "[R_{0}N] = [R_{0}N ( \\bm\\sigma_{R_{0}/N})]",
        "Chain(Call([ R _ { 0 } N ]), Call([ R _ { 0 } N ]; \\bm{\\sigma}_{R_0/N}); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/mrpRotation/_Documentation/secModuleDescription.tex",
    ),
    (
        "W = W(\\boldsymbol{q},\\boldsymbol{D}) = W(\\boldsymbol{q},E,D_2,\\cdots,D_s)",
        "Chain(Call(W), Call(W; \\boldsymbol{q}, \\boldsymbol{D}), Call(W; \\boldsymbol{q}, E, D_2, Dots(), D_s); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\boldsymbol{r}_i = \\boldsymbol{r}_i(q_1,q_2,\\cdots,q_s),\\quad i = 1,2,\\cdots,n",
        "System(Chain(Call(\\boldsymbol{r}_i), Call(\\boldsymbol{r}_i; q_1, q_2, Dots(), q_s); =), Values(i; 1, 2, Dots(), n))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "Y = Y(y_1,y_2,\\cdots,y_n) = \\sum_{i=1}^n y_ix_i - X(x_1,x_2,\\cdots,x_n)",
        "Chain(Call(Y), Call(Y; y_1, y_2, Dots(), y_n), Add(BigSum(i; 1; n; Mul(y_i, x_i)), Neg(Call(X; x_1, x_2, Dots(), x_n))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "x' = x (c F_2 - b F_3), \\enspace y' = y (a F_3 - c F_1), \\enspace z' = z (b F_1 - a F_2)",
        "System(Chain(x', Mul(x, Add(Mul(c, F_2), Neg(Mul(b, F_3)))); =), Chain(y', Mul(y, Add(Mul(a, F_3), Neg(Mul(c, F_1)))); =), Chain(z', Mul(z, Add(Mul(b, F_1), Neg(Mul(a, F_2)))); =))",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "2 \\sqrt{\\frac{R^{2} k^{2} \\left(4 R^{2} k^{2} - y^{2} + \\left(- 2 R k + R\\right)^{2} + 2 \\left(- 2 R k + R\\right) \\sqrt{4 R^{2} k^{2} - y^{2}} \\right)}{\\left(4 R^{2} k^{2} - y^{2}\\right) \\left(\\left(R - h\\right)^{2} - \\left(- 4 R k + 2 R\\right) \\sqrt{4 R^{2} k^{2} - y^{2}} + 2 \\left(- 2 R k + R\\right) \\sqrt{4 R^{2} k^{2} - y^{2}} \\right)}} \\sqrt{\\left(R - h\\right)^{2} - \\left(- 4 R k + 2 R\\right) \\sqrt{4 R^{2} k^{2} - y^{2}} + 2 \\left(- 2 R k + R\\right) \\sqrt{4 R^{2} k^{2} - y^{2}}} \\operatorname{atan}{\\left(\\frac{ \\sqrt{4 R^{2} k^{2} - y^{2} - \\left(R - h\\right)^{2} + \\left(- 4 R k + 2 R\\right) \\sqrt{4 R^{2} k^{2} - y^{2}} + \\left(- 2 R k + R\\right) ^{2}}}{\\sqrt{\\left(R - h\\right)^{2} - \\left(- 4 R k + 2 R\\right) \\sqrt{4 R^{2} k^{2} - y^{2}} + 2 \\left(- 2 R k + R\\right) \\sqrt{4 R^{2} k^{2} - y^{2}}}} \\right)}",
        "Mul(2, Sqrt(Div(Mul(Pow(R; 2), Pow(k; 2), Add(Mul(4, Pow(R; 2), Pow(k; 2)), Neg(Pow(y; 2)), Pow(Add(Neg(Mul(2, R, k)), R); 2), Mul(2, Add(Neg(Mul(2, R, k)), R), Sqrt(Add(Mul(4, Pow(R; 2), Pow(k; 2)), Neg(Pow(y; 2))))))); Mul(Add(Mul(4, Pow(R; 2), Pow(k; 2)), Neg(Pow(y; 2))), Add(Pow(Add(R, Neg(h)); 2), Neg(Mul(Add(Neg(Mul(4, R, k)), Mul(2, R)), Sqrt(Add(Mul(4, Pow(R; 2), Pow(k; 2)), Neg(Pow(y; 2)))))), Mul(2, Add(Neg(Mul(2, R, k)), R), Sqrt(Add(Mul(4, Pow(R; 2), Pow(k; 2)), Neg(Pow(y; 2))))))))), Sqrt(Add(Pow(Add(R, Neg(h)); 2), Neg(Mul(Add(Neg(Mul(4, R, k)), Mul(2, R)), Sqrt(Add(Mul(4, Pow(R; 2), Pow(k; 2)), Neg(Pow(y; 2)))))), Mul(2, Add(Neg(Mul(2, R, k)), R), Sqrt(Add(Mul(4, Pow(R; 2), Pow(k; 2)), Neg(Pow(y; 2))))))), Call(atan; Div(Sqrt(Add(Mul(4, Pow(R; 2), Pow(k; 2)), Neg(Pow(y; 2)), Neg(Pow(Add(R, Neg(h)); 2)), Mul(Add(Neg(Mul(4, R, k)), Mul(2, R)), Sqrt(Add(Mul(4, Pow(R; 2), Pow(k; 2)), Neg(Pow(y; 2))))), Pow(Add(Neg(Mul(2, R, k)), R); 2))); Sqrt(Add(Pow(Add(R, Neg(h)); 2), Neg(Mul(Add(Neg(Mul(4, R, k)), Mul(2, R)), Sqrt(Add(Mul(4, Pow(R; 2), Pow(k; 2)), Neg(Pow(y; 2)))))), Mul(2, Add(Neg(Mul(2, R, k)), R), Sqrt(Add(Mul(4, Pow(R; 2), Pow(k; 2)), Neg(Pow(y; 2))))))))))",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\mathbf{u}_t = [v_t, \\omega_t]^T",
        "Chain(\\mathbf{u}_t, Transpose(Tuple(v_t, \\omega_t; [])); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/ensamble_kalman_filter_localization_files/ensamble_kalman_filter_localization_main.rst",
    ),
    (
        "\\begin{aligned} \\operatorname{Wigner6j}(j_1,j_2,j_3,j_4,j_5,j_6) &=\\operatorname{Wigner6j}(j_1,j_5,j_6,j_4,j_2,j_3)\\\\ &=\\operatorname{Wigner6j}(j_4,j_2,j_6,j_1,j_5,j_3)\\\\ &=\\operatorname{Wigner6j}(j_4,j_5,j_3,j_1,j_2,j_6) \\end{aligned}",
        "Chain(Call(\\text{Wigner6j}; j_1, j_2, j_3, j_4, j_5, j_6), Call(\\text{Wigner6j}; j_1, j_5, j_6, j_4, j_2, j_3), Call(\\text{Wigner6j}; j_4, j_2, j_6, j_1, j_5, j_3), Call(\\text{Wigner6j}; j_4, j_5, j_3, j_1, j_2, j_6); =, =, =)",
        "sympy/sympy/sympy/physics/wigner.py",
    ),
    (
        "J=\\frac{1}{2}(u_a^2+u_{\\delta}^2)-\\phi_a d_a-\\phi_\\delta d_\\delta\\\\ +\\lambda_1vcos\\theta+\\lambda_2vsin\\theta+\\lambda_3\\frac{v}{WB}sin(u_{\\delta})+\\lambda_4u_a\\\\ +\\rho_1(u_a^2+d_a^2+u_{a,max}^2)+\\rho_2(u_\\delta^2+d_\\delta^2+u_{\\delta,max}^2)",
        "Chain(J, Add(Mul(Div(1; 2), Add(Pow(u_a; 2), Pow(u_\\delta; 2))), Neg(Mul(\\phi_a, d_a)), Neg(Mul(\\phi_\\delta, d_\\delta)), Mul(\\lambda_1, v, Call(cos; \\theta)), Mul(\\lambda_2, v, Call(sin; \\theta)), Mul(\\lambda_3, Div(v; Mul(W, B)), Call(sin; u_\\delta)), Mul(\\lambda_4, u_a), Mul(\\rho_1, Add(Pow(u_a; 2), Pow(d_a; 2), Pow(u_{a,max}; 2))), Mul(\\rho_2, Add(Pow(u_\\delta; 2), Pow(d_\\delta; 2), Pow(u_{\\delta,max}; 2)))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/cgmres_nmpc/cgmres_nmpc_main.rst",
    ),
    (
        "\\dot\\theta_{n+1}^{+} = \\begin{cases} \\cos(2\\alpha) \\sqrt{(\\dot\\theta_n^{+})^2 + 4 \\frac{g}{l} \\sin\\alpha \\sin\\gamma}, & \\text{ } 0 \\le \\dot\\theta_n^{+} \\\\ -\\dot\\theta_n^{+} \\cos(2\\alpha), & \\text{ } \\omega_2 < \\dot\\theta_n^{+} < 0 \\\\ -\\cos(2\\alpha) \\sqrt{(\\dot\\theta_n^{+})^2 - 4\\frac{g}{l} \\sin\\alpha \\sin\\gamma}, & \\dot\\theta_n^{+} \\le w_2 \\end{cases}.",
        "Chain(Call(\\dot { \\theta } _ { n + 1 } ^ { + }), Piecewise(Mul(Call(cos; Mul(2, \\alpha)), Sqrt(Add(Pow(Call(\\dot { \\theta } _ { n } ^ { + }); 2), Mul(4, Div(g; l), Call(sin; \\alpha), Call(sin; \\gamma))))), Chain(0, Call(\\dot { \\theta } _ { n } ^ { + }); \\le), Neg(Mul(Call(\\dot { \\theta } _ { n } ^ { + }), Call(cos; Mul(2, \\alpha)))), Chain(\\omega_2, Call(\\dot { \\theta } _ { n } ^ { + }), 0; <, <), Neg(Mul(Call(cos; Mul(2, \\alpha)), Sqrt(Add(Pow(Call(\\dot { \\theta } _ { n } ^ { + }); 2), Neg(Mul(4, Div(g; l), Call(sin; \\alpha), Call(sin; \\gamma))))))), Chain(Call(\\dot { \\theta } _ { n } ^ { + }), w_2; \\le)); =)",
        "RussTedrake/underactuated/book/simple_legs.html",
    ),
    (
        "0 = \\min_{\\bf u} \\left[ \\ell({\\bf x},{\\bf u}) + \\frac{\\partial J^*}{\\partial {\\bf x}}f({\\bf x},{\\bf u}) \\right], \\\\ \\pi^*({\\bf x}) = \\operatorname{\\textrm{argmin}}_{\\bf u} \\left[ \\ell({\\bf x},{\\bf u}) + \\frac{\\partial J^*}{\\partial {\\bf x}}f({\\bf x},{\\bf u}) \\right].",
        "System(Chain(0, Limiting(min; _{ \\mathbf { u } }; Add(Call(\\ell; \\mathbf{x}, \\mathbf{u}), Mul(Derivative(Call(J ^ { * }); \\mathbf{x}, 1; True), Call(f; \\mathbf{x}, \\mathbf{u})))); =), Chain(Call(\\pi ^ { * }; \\mathbf{x}), Limiting(argmin; _{ \\mathbf { u } }; Add(Call(\\ell; \\mathbf{x}, \\mathbf{u}), Mul(Derivative(Call(J ^ { * }); \\mathbf{x}, 1; True), Call(f; \\mathbf{x}, \\mathbf{u})))); =))",
        "RussTedrake/underactuated/book/dp.html",
    ),
)

REFUSED = (  # LaTeX with two readings, repository and path
    ("C_D = \\frac{24}{Re} + \\frac{7.3}{1+Re^{0.5}} + 0.25", "CalebBell/fluids/fluids/drag.py"),
    ("E = 0.383Re^{0.356}-0.207Re^{0.396} - \\frac{0.143}{1+(\\log_{10} Re)^2}", "CalebBell/fluids/fluids/drag.py"),
    (
        "F_{R,3a} = 1 + \\left(\\frac{0.33F_L^{0.5}}{n_2^{0.25}}\\right)\\log_{10} \\left(\\frac{Re_v}{10000}\\right)",
        "CalebBell/fluids/fluids/control_valve.py",
    ),
    ("Re = \\frac{\\rho v_s d_p}{\\mu}", "CalebBell/fluids/fluids/packed_bed.py"),
    ("q = f^{-1}_{kin}(X^G),", "RussTedrake/manipulation/book/trajectories.html"),
    ("y'' + \\lambda y = 0, \\quad y'(0) = 0, \\quad y'(1) = 0.", "jirilebl/diffyqs/ch-eigenvalue-probs.tex"),
    (
        "\\begin{array}{rcl} \\mathbf{f}_D(\\mathbf{q}) &=& \\mathbf{CD}^r - \\mathbf{D}^b \\\\ &=& \\mathbf{P}_D\\mathbf{q} - \\mathbf{D}^b \\\\ &=& (D_x^r\\mathbf{P}_1 + D_y^r\\mathbf{P}_2 + D_z^r\\mathbf{P}_3)\\mathbf{q} - \\mathbf{D}^b \\\\ &=& D_x^r\\mathbf{C}_1 + D_y^r\\mathbf{C}_2 + D_z^r\\mathbf{C}_3 - \\mathbf{D}^b \\end{array}",
        "Mayitzin/ahrs/ahrs/filters/flae.py",
    ),
    (
        "\\text{cost} = -\\sum_i (n^i_{G_x})^2,",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "|[t^k] R_n(z+t)| \\le 2 |B_{2n}| \\frac{\\Gamma(2n+k-1)}{\\Gamma(k+1) \\Gamma(2n+1)} \\; |z| \\; \\left(\\frac{b}{|z|}\\right)^{2n+k}",
        "fredrik-johansson/arb/doc/source/gamma.rst",
    ),
    (
        "res_{s = b + l_u + t} \\Gamma(b - s) = -\\frac{(-1)^{l_u + t}}{(l_u + t)!} = -\\frac{(-1)^{l_u}}{l_u!} \\frac{(-1)^t}{(l_u+1)_t}.",
        "sympy/sympy/doc/src/modules/simplify/hyperexpand.rst",
    ),
    (
        "f^k(x) + \\sum\\limits_{j=0}^{k-1} A_j f^j(x) = 0",
        "sympy/sympy/sympy/series/formal.py",
    ),
    (
        "m_1\\text{-}P\\text{-}Q = O\\text{-}P\\text{-}Q - O\\text{-}m_1\\text{-}Q = \\frac{a^2 E}{2} - \\frac{a^2 e \\sin{E}}{2}",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "0 = e^2 - \\frac{r_0}{a}\\cos\\nu_0 e - \\left(1 + \\frac{r_0}{a}\\right)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables-example.md",
    ),
    (
        "V = \\int_C \\rho gh \\mathrm{d} l = \\int_0^\\pi \\rho g R\\sin \\alpha R\\mathrm{d} \\alpha = 2\\rho gR^2",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "\\ell(\\theta) = \\mathbb{E}_{{\\bf x}, {\\bf \\epsilon}, \\sigma} || {\\bf f}_\\theta(-{\\bf K}{\\bf x} + \\sigma {\\bf \\epsilon}, \\sigma, {\\bf x}) - {\\bf \\epsilon} ||^2,",
        "RussTedrake/underactuated/book/imitation.html",
    ),
    (
        "\\frac{\\tilde{\\mathrm{d}} \\boldsymbol{L}}{\\mathrm{d} t} + \\boldsymbol{\\omega} \\times \\boldsymbol{L} = \\boldsymbol{M}",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "\\frac{\\mathrm{d} \\boldsymbol{\\omega}_0}{\\mathrm{d} t} = \\frac{\\tilde{\\mathrm{d}} \\boldsymbol{\\omega}_0}{\\mathrm{d} t} + \\boldsymbol{\\omega}_0 \\times \\boldsymbol{\\omega}_0 = \\frac{\\tilde{\\mathrm{d}} \\boldsymbol{\\omega}_0}{\\mathrm{d} t}",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter7.tex",
    ),
    (
        "\\text{SA} = \\pi h \\left(\\frac{a^2 + R^2}{a}\\right)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "Q = 0.821 \\left[\\frac{(P_1-P_2)D^5}{L \\cdot {SG} (1 + 91.44/D + 0.0018D)}\\right]^{0.5}",
        "CalebBell/fluids/fluids/compressible.py",
    ),
    (
        "\\widehat{\\Delta\\mathbf{q}}_\\mathrm{acc} = \\frac{\\overline{\\Delta\\mathbf{q}}_\\mathrm{acc}}{\\|\\overline{\\Delta\\mathbf{q}}_\\mathrm{acc}\\|}",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "\\phi_i(t) = \\sum_{i=0}^N {N \\choose i} \\left( \\frac{t}{T} - t \\right)^{N-i} \\left( \\frac{t}{T} \\right)^i",
        "python-control/python-control/control/flatsys/bezier.py",
    ),
    (
        "\\sqrt{{f^{c_i}_{C_x}}^2 + {f^{c_i}_{C_y}}^2} \\le \\mu f^{c_i}_{C_z},",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "\\widehat{f \\star g}(\\chi) = \\hat f(\\chi)\\hat g(\\chi)",
        "fredrik-johansson/arb/doc/source/acb_dft.rst",
    ),
    (
        "\\text{albedoAtInstrument} = ALB \\frac{f_1 \\cdot f_2 \\cdot f_3 \\cdot d_{Area}}{\\pi \\cdot |\\mathbf{r}_{IdA}|^2}",
        "AVSLab/basilisk/src/simulation/environment/albedo/albedo.rst",
    ),
    (
        "\\min_{{\\bf x},{\\bf u},{\\bf s}_x,{\\bf s}_u} \\sum_n^{N-1} {\\bf s}_x[n] + {\\bf s}_u[n], \\quad \\text{s.t.} \\quad {\\bf s}_x[n] \\ge {\\bf x}[n], \\quad {\\bf s}_x[n] \\ge -{\\bf x}[n], \\quad ...",
        "RussTedrake/underactuated/book/trajopt.html",
    ),
    (
        "u = k_f r - K_p x - K_i \\int(C x - r)",
        "python-control/python-control/control/statefbk.py",
    ),
    (
        "\\delta \\frac{\\partial \\eta_k}{\\partial t} = \\frac{\\partial (\\delta \\eta_k)}{\\partial t},\\quad \\delta \\frac{\\partial \\eta_k}{\\partial x_j} = \\frac{\\partial (\\delta \\eta_k)}{\\partial x_j}",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\mathcal{T}[b_{m}y^{\\left(m\\right)}+b_{m-1}y^{\\left(m-1\\right)}+\\dots+ b_{1}y^{\\left(1\\right)}+b_{0}y]= \\mathcal{T}[a_{n}x^{\\left(n\\right)}+a_{n-1}x^{\\left(n-1\\right)}+\\dots+ a_{1}x^{\\left(1\\right)}+a_{0}x]",
        "sympy/sympy/sympy/physics/control/lti.py",
    ),
)
