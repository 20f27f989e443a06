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
    (
        "A_{l,l}[u] &= (2 l -1) A_{l-1,l-1}[u] \\\\ A_{l,l-1}[u] &= u A_{l,l}[u]",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/spacecraftPointing/_Documentation/example/secModelDescription.tex",
    ),
    ("y'' + \\lambda y = 0, \\quad y'(0) = 0, \\quad y'(1) = 0.", "jirilebl/diffyqs/ch-eigenvalue-probs.tex"),
)
