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
    (
        "\\vec{x}(t_0) = \\vec{b}",
        "Chain(Call(\\vec{x}; t_0), \\vec{b}; =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
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
    (
        "a = a_1 + a_2",
        "Chain(a, Add(a_1, a_2); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\sigma X",
        "Mul(\\sigma, X)",
        "AVSLab/basilisk/src/simulation/mujocoDynamics/_GeneralModuleFiles/inhomogeneousGeometricBrownianMotion.rst",
    ),
    (
        "y'' - k^2 y = 0 .",
        "Chain(Add(y'', Neg(Mul(Pow(k; 2), y))), 0; =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
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
    (
        "4r(r-1) + 1 = 0 .",
        "Chain(Add(Mul(4, r, Add(r, Neg(1))), 1), 0; =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
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
    (
        "R = 1",
        "Chain(R, 1; =)",
        "AVSLab/basilisk/src/simulation/communication/simpleAntenna/simpleAntenna.rst",
    ),
    (
        "Y = \\frac{\\Delta \\bar \\omega}{\\Delta P} - 0.0896 - 0.48\\beta^9",
        "Chain(Y, Add(Div(\\Delta \\bar { \\omega }; \\Delta P), Neg(0.0896), Neg(Mul(0.48, Pow(\\beta; 9)))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "E := K + V",
        "Chain(E, Add(K, V); =)",
        "moorepants/learn-multibody-dynamics/energy.rst",
    ),
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
    (
        "\\sin\\theta = a_x",
        "Chain(Call(sin; \\theta), a_x; =)",
        "Mayitzin/ahrs/ahrs/filters/fqa.py",
    ),
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
    (
        "L_1 = L_2' = 0",
        "Chain(L_1, L_2', 0; =, =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
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
    (
        "GM_A = G\\ M_A",
        "Chain(Mul(G, M_A), Mul(G, M_A); =)",
        "Mayitzin/ahrs/ahrs/utils/wgs84.py",
    ),
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
        "Chain(\\boldsymbol{h}, Cross(\\boldsymbol{r}_0; \\boldsymbol{v}_0), Mul(\\boldsymbol{\\hat{w}}, Add(Mul(x_0, \\dot { y } _ { 0 }), Neg(Mul(y_0, \\dot { x } _ { 0 })))); =, =)",
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
        "System(Chain(\\boldsymbol{r}_0, Add(Mul(x_0, \\boldsymbol{\\hat{p}}), Mul(y_0, \\boldsymbol{\\hat{q}})); =), Chain(\\boldsymbol{v}_0, Add(Mul(\\dot { x } _ { 0 }, \\boldsymbol{\\hat{p}}), Mul(\\dot { y } _ { 0 }, \\boldsymbol{\\hat{q}})); =))",
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
        "Chain(Call(\\dot{\\rho}; t), PlusMinus(Mul(\\ddot { \\rho } _ { \\text { m a x } }, Add(Div(Pow(Add(t, Neg(t_0)); 3); Pow(t_{smooth}; 2)), Neg(Div(Pow(Add(t, Neg(t_0)); 4); Mul(2, Pow(t_{smooth}; 3))))))); =)",
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
    (
        "H = \\frac12 I_1 (\\dot{\\theta}^2 + \\dot{\\phi}^2 \\sin^2 \\theta) + \\frac12 I_3 (\\dot{\\psi} + \\dot{\\phi} \\cos \\theta)^2 + Mgl\\cos \\theta = E \\quad \\text{（常数）}",
        "System(Chain(H, Add(Mul(Div(1; 2), I_1, Add(Pow(Call(\\dot{\\theta}); 2), Mul(Pow(Call(\\dot{\\phi}); 2), Pow(Call(sin; Call(\\theta)); 2)))), Mul(Div(1; 2), I_3, Pow(Add(Call(\\dot{\\psi}), Mul(Call(\\dot{\\phi}), Call(cos; Call(\\theta)))); 2)), Mul(M, g, l, Call(cos; Call(\\theta)))), E; =, =), Words(\\text{（常数）}))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "\\text{distance}^2 = r^2 + r^2 - 2 r^2 \\cos\\theta_{err}.",
        "Chain(Pow(\\text{distance}; 2), Add(Pow(r; 2), Pow(r; 2), Neg(Mul(2, Pow(r; 2), Call(cos; \\theta_{err})))); =)",
        "RussTedrake/manipulation/book/pose.html",
    ),
    (
        "C_{11}: \\lvert{\\operatorname{arg}\\left(\\sigma\\right)}\\rvert = \\pi b^{*}",
        "Located(C_{11}; Chain(Bars(Call(arg; \\sigma)), Mul(\\pi, b ^ { * }); =))",
        "sympy/sympy/doc/src/modules/integrals/g-functions.rst",
    ),
    (
        "\\bar{M} := \\bar{r}^{L/P} \\times \\bar{v}",
        "Chain(\\bar{M}, Cross(\\bar { r } ^ { L / P }; \\bar{v}); =)",
        "moorepants/learn-multibody-dynamics/loads.rst",
    ),
    (
        "f_n = \\frac{d f_h}{dt} = \\frac{\\partial f_h}{\\partial x} \\frac{dx}{dt} + \\frac{\\partial f_h}{\\partial y} \\frac{dy}{dt} + \\frac{\\partial f_h}{\\partial \\theta} \\frac{d\\theta}{dt} + \\frac{\\partial f_h}{\\partial t}",
        "Chain(f_n, Derivative(Call(f_h); t, 1), Add(Mul(Derivative(Call(f_h); x, 1; True), Derivative(Call(x); t, 1)), Mul(Derivative(Call(f_h); y, 1; True), Derivative(Call(y); t, 1)), Mul(Derivative(Call(f_h); \\theta, 1; True), Derivative(Call(\\theta); t, 1)), Derivative(Call(f_h); t, 1; True)); =, =)",
        "moorepants/learn-multibody-dynamics/motion.rst",
    ),
    (
        "\\forall a, {\\bf J} \\le {\\bf \\ell}(a) + {\\bf T}(a) {\\bf J}.",
        "System(Forall(a), Chain(\\mathbf{J}, Add(Call(\\mathbf{\\ell}; a), Mul(Call(\\mathbf{T}; a), \\mathbf{J})); \\le))",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "\\dot{\\bar{q}} = -\\mathbf{M}_k(\\bar{q}, t)^{-1} \\bar{g}_k(\\bar{u}_s, \\bar{q}, t) \\\\ \\dot{\\bar{u}}_s = -\\mathbf{M}_d(\\bar{q}, t)^{-1} \\bar{g}_d(\\bar{u}_s, \\bar{q}, t)",
        "System(Chain(Call(\\dot{\\bar{q}}), Neg(Mul(Pow(Call(\\mathbf{M}_k; Call(\\bar{q}), t); Neg(1)), Call(\\bar{g}_k; Call(\\bar{u}_s), Call(\\bar{q}), t))); =), Chain(Call(\\dot{\\bar{u}}_s), Neg(Mul(Pow(Call(\\mathbf{M}_d; Call(\\bar{q}), t); Neg(1)), Call(\\bar{g}_d; Call(\\bar{u}_s), Call(\\bar{q}), t))); =))",
        "moorepants/learn-multibody-dynamics/nonholonomic-eom.rst",
    ),
    (
        "\\frac{d f(\\chi)}{d\\chi} = \\frac{r_0 v_{r,0}}{\\sqrt{\\mu}}\\chi\\left[1 - \\alpha\\chi^2 S(z)\\right] + \\left(1 - \\alpha r_0\\right)\\chi^2 C(z) + r_0",
        "Chain(Derivative(Call(f; \\chi); \\chi, 1), Add(Mul(Div(Mul(r_0, v_{r,0}); Sqrt(\\mu)), \\chi, Add(1, Neg(Mul(\\alpha, Pow(\\chi; 2), Call(S; z))))), Mul(Add(1, Neg(Mul(\\alpha, r_0))), Pow(\\chi; 2), Call(C; z)), r_0); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables.md",
    ),
    (
        "x_t = [e_t, \\dot{e}_t, \\theta_t, \\dot{\\theta}_t]^T",
        "Chain(x_t, Transpose(Tuple(Call(e_t), Call(\\dot{e}_t), Call(\\theta_t), Call(\\dot{\\theta}_t); [])); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/lqr_steering_control/lqr_steering_control_main.rst",
    ),
    (
        "{}^AX^B {}^BX^C = {}^AX^C,",
        "Chain(Mul(\\prescript { A } { } { X } ^ { B }, \\prescript { B } { } { X } ^ { C }), \\prescript { A } { } { X } ^ { C }; =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "& \\dfrac{\\mathrm{d}}{\\mathrm{d} t} \\frac{\\partial L}{\\partial q_i} - \\frac{\\partial L}{\\partial q_i} = 0\\quad (i=1,2,\\cdots,l) \\\\ & \\dfrac{\\mathrm{d}}{\\mathrm{d} t} \\frac{\\partial L}{\\partial q_\\alpha} - \\frac{\\partial L}{\\partial q_\\alpha} = 0\\quad (\\alpha=l+1,\\cdots,l)",
        "System(Chain(Add(Derivative(Derivative(Call(L); q_i, 1; True); t, 1), Neg(Derivative(Call(L); q_i, 1; True))), 0; =), Values(i; 1, 2, Dots(), l), Chain(Add(Derivative(Derivative(Call(L); q_\\alpha, 1; True); t, 1), Neg(Derivative(Call(L); q_\\alpha, 1; True))), 0; =), Values(\\alpha; Add(l, 1), Dots(), l))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "V_{\\text{int}} = \\frac{V_{\\text{max}} - V_{\\text{min}}}{u_{\\text{max}}} u_{s}",
        "Chain(V_{int}, Mul(Div(Add(V_{max}, Neg(V_{min})); u_{max}), u_s); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/rwMotorVoltage/_Documentation/secModelDescription.tex",
    ),
    (
        "v=y^{1-5} = y^{-4}, \\qquad v' = -4 y^{-5} y' .",
        "System(Chain(v, Pow(y; Add(1, Neg(5))), Pow(y; Neg(4)); =, =), Chain(v', Neg(Mul(4, Pow(y; Neg(5)), y')); =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\Delta t = t_{n} - t_{n-1}",
        "Chain(\\Delta t, Add(t_n, Neg(t_{n-1})); =)",
        "AVSLab/basilisk/src/architecture/utilities/_Documentation/discretize/secTest.tex",
    ),
    (
        "\\mathbf{F} = m\\,\\mathbf{a}",
        "Chain(\\mathbf{F}, Mul(m, \\mathbf{a}); =)",
        "AVSLab/basilisk/src/simulation/mujocoDynamics/NBodyGravity/NBodyGravity.rst",
    ),
    (
        "\\frac{dx}{dt} + x = 2 \\cos t .",
        "Chain(Add(Derivative(Call(x); t, 1), Call(x)), Mul(2, Call(cos; t)); =)",
        "jirilebl/diffyqs/ch-intro.tex",
    ),
    (
        "\\mathbf{q} = q_w + \\mathbf{q}_v",
        "Chain(\\mathbf{q}, Add(q_w, \\mathbf{q}_v); =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{u} &=& \\frac{\\mathbf{q}_v}{\\|\\mathbf{q}_v\\|} \\\\ \\theta &=& \\arccos\\Big(\\frac{q_w}{\\|\\mathbf{q}\\|}\\Big) \\end{array}",
        "System(Chain(\\mathbf{u}, Div(\\mathbf{q}_v; Norm(\\mathbf{q}_v)); =), Chain(\\theta, Call(arccos; Div(q_w; Norm(\\mathbf{q}))); =))",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "\\left[\\mathbf{Q}\\right] = \\left[\\mathbf{R_3(\\gamma)}\\right]\\left[\\mathbf{R_1(\\beta)}\\right]\\left[\\mathbf{R_3(\\alpha)}\\right]",
        "Chain([ \\mathbf { Q } ], Mul(Call(\\mathbf{R}_3; \\gamma), Call(\\mathbf{R}_1; \\beta), Call(\\mathbf{R}_3; \\alpha)); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "\\Gamma(1/3) = \\frac{2^{4/9} \\pi^{2/3}}{3^{1/12} \\left( \\operatorname{agm}\\left(1,\\frac{1}{2} \\sqrt{2+\\sqrt{3}}\\right)\\right)^{1/3}},",
        "Chain(Call(Gamma; Div(1; 3)), Div(Mul(Pow(2; Div(4; 9)), Pow(\\pi; Div(2; 3))); Mul(Pow(3; Div(1; 12)), Pow(Call(\\text{agm}; 1, Mul(Div(1; 2), Sqrt(Add(2, Sqrt(3))))); Div(1; 3)))); =)",
        "fredrik-johansson/arb/doc/source/gamma.rst",
    ),
    (
        "\\frac{\\mathrm{d}r}{\\mathrm{d}t} = \\sqrt{\\frac{2}{\\mu}\\left(\\frac{\\beta^2}{2\\mu r_0^2}-\\frac{\\alpha}{r_0}+ \\frac{\\alpha}{r}- \\frac{\\beta^2}{2\\mu r^2}\\right)} = \\sqrt{\\frac{2}{\\mu}\\left(E+\\frac{\\alpha}{r}-\\frac{\\beta^2}{2\\mu r^2}\\right)}",
        "Chain(Derivative(Call(r); t, 1), Sqrt(Mul(Div(2; \\mu), Add(Div(Pow(\\beta; 2); Mul(2, \\mu, Pow(r_0; 2))), Neg(Div(\\alpha; r_0)), Div(\\alpha; Call(r)), Neg(Div(Pow(\\beta; 2); Mul(2, \\mu, Pow(Call(r); 2))))))), Sqrt(Mul(Div(2; \\mu), Add(E, Div(\\alpha; Call(r)), Neg(Div(Pow(\\beta; 2); Mul(2, \\mu, Pow(Call(r); 2))))))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "q^{-1} = \\frac{q^*}{|q|^2}",
        "Chain(Pow(q; Neg(1)), Div(q ^ { * }; Pow(Bars(q); 2)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "\\bar{f}_k(\\dot{\\bar{q}}, \\bar{u}_s, \\bar{q}, t) = \\mathbf{M}_k\\dot{\\bar{q}} + \\bar{g}_k = 0 \\in \\mathbb{R}^n \\\\ \\bar{f}_d(\\dot{\\bar{u}}_s, \\bar{u}_s, \\bar{q}, t) = \\mathbf{M}_d\\dot{\\bar{u}}_s + \\bar{g}_d = 0 \\in \\mathbb{R}^p",
        "System(Chain(Call(\\bar{f}_k; Call(\\dot{\\bar{q}}), Call(\\bar{u}_s), Call(\\bar{q}), t), Add(Mul(\\mathbf{M}_k, Call(\\dot{\\bar{q}})), \\bar{g}_k), 0, Pow(\\mathbb{R}; n); =, =, \\in), Chain(Call(\\bar{f}_d; Call(\\dot{\\bar{u}}_s), Call(\\bar{u}_s), Call(\\bar{q}), t), Add(Mul(\\mathbf{M}_d, Call(\\dot{\\bar{u}}_s)), \\bar{g}_d), 0, Pow(\\mathbb{R}; p); =, =, \\in))",
        "moorepants/learn-multibody-dynamics/nonholonomic-eom.rst",
    ),
    (
        "\\bar{\\mathbf{q}} = \\begin{bmatrix}\\mathbf{Q} \\\\ q\\end{bmatrix} = \\begin{bmatrix}\\hat{\\mathbf{X}}\\sin\\frac{\\theta}{2} \\\\ \\cos\\frac{\\theta}{2}\\end{bmatrix}",
        "Chain(\\bar{\\mathbf{q}}, MatrixOf(\\mathbf{Q}, q), MatrixOf(Mul(\\hat{\\mathbf{X}}, Call(sin; Div(\\theta; 2))), Call(cos; Div(\\theta; 2))); =, =)",
        "Mayitzin/ahrs/ahrs/filters/quest.py",
    ),
    (
        "T_{rot}=\\frac{1}{2}\\bm\\omega_{\\cal B/N}^T [I_{\\text{hub},B_c}] \\bm\\omega_{\\cal B/N}+\\frac{1}{2}m_{\\text{hub}}(\\bm{\\dot{r}}_{B_c,B}-\\bm{\\dot{c}})\\cdot(\\bm{\\dot{r}}_{B_c,B}-\\bm{\\dot{c}})+\\sum\\limits_{j=1}^{N_P} \\frac{1}{2} m_j (\\bm{\\dot{r}}_{P_{c,j}/B}-\\bm{\\dot{c}})\\cdot(\\bm{\\dot{r}}_{P_{c,j}/B}-\\bm{\\dot{c}})",
        "Chain(T_{rot}, Add(Mul(Div(1; 2), Transpose(\\bm{\\omega}_{\\mathcal B/\\mathcal N}), [ I _ { \\text { h u b } , B _ { c } } ], \\bm{\\omega}_{\\mathcal B/\\mathcal N}), Mul(Div(1; 2), m_{hub}, Add(\\bm{\\dot{r}}_{B_c,B}, Neg(\\bm{\\dot{c}})), Add(\\bm{\\dot{r}}_{B_c,B}, Neg(\\bm{\\dot{c}})); 3), BigSum(j; 1; N_P; Mul(Div(1; 2), m_j, Add(\\bm{\\dot{r}}_{P_c,j/B}, Neg(\\bm{\\dot{c}})), Add(\\bm{\\dot{r}}_{P_c,j/B}, Neg(\\bm{\\dot{c}})); 3))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/sphericalPendulum/_Documentation/secModelDescription.tex",
    ),
    (
        "z = \\sqrt[3]{3M_p + \\sqrt{1 + \\left(3 M_p\\right)^2}}",
        "Chain(z, Root(Add(Mul(3, M_p), Sqrt(Add(1, Pow(Mul(3, M_p); 2)))); 3); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/parabolic-trajectories.md",
    ),
    (
        "\\gamma_{\\mathrm{clean}} = f_{\\mathrm{scale}} \\gamma_{\\textrm{li}}",
        "Chain(\\gamma_{clean}, Mul(f_{scale}, \\gamma_{li}); =)",
        "AVSLab/basilisk/src/simulation/sensors/coarseSunSensor/_Documentation/secModelDescription.tex",
    ),
    (
        "{\\bf H}_1 = {\\bf I}, {\\bf H}_2 = 0, \\dot{\\bf H} = 0, \\bar{{\\bf H}}=-{\\bf M}_{11}^{-1}{\\bf M}_{12}.",
        "System(Chain(\\mathbf{H}_1, \\mathbf{I}; =), Chain(\\mathbf{H}_2, 0; =), Chain(Call(\\dot{\\mathbf{H}}), 0; =), Chain(\\bar{\\mathbf{H}}, Neg(Mul(Pow(\\mathbf{M}_{11}; Neg(1)), \\mathbf{M}_{12})); =))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\bm\\omega_{\\mathcal{S}_{i1}/\\mathcal{N}} = \\bm\\omega_{\\mathcal{S}_{i1}/\\mathcal{H}_{i1}} + \\bm\\omega_{\\mathcal{H}_{i1}/\\mathcal{B}} + \\bm\\omega_{\\cal B/N}",
        "Chain(\\bm{\\omega}_{\\mathcal S_i1/\\mathcal N}, Add(\\bm{\\omega}_{\\mathcal S_i1/\\mathcal H_i1}, \\bm{\\omega}_{\\mathcal H_i1/\\mathcal B}, \\bm{\\omega}_{\\mathcal B/\\mathcal N}); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\varOmega = \\sqrt{\\frac{\\mu}{r_{12}^3}}",
        "Chain(\\varOmega, Sqrt(Div(\\mu; Pow(r_{12}; 3))); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "= m^{1/k} \\min(1, \\log(1+r/(m-r))/k).",
        "Chain(Blank(), Mul(Pow(m; Div(1; k)), Call(min; 1, Div(Call(log; Add(1, Div(r; Add(m, Neg(r))))); k))); =)",
        "fredrik-johansson/arb/doc/source/arb.rst",
    ),
    (
        "\\bm \\omega_{\\cal{B/N}} = \\bm \\omega_{\\cal{B/N}}",
        "Chain(\\bm{\\omega}_{\\cal B/N}, \\bm{\\omega}_{\\cal B/N}; =)",
        "AVSLab/basilisk/src/simulation/dynamics/LinearSpringMassDamper/_Documentation/secModelDescription.tex",
    ),
    (
        "V^G = J^G(q)v.",
        "Chain(V ^ { G }, Mul(Call(J ^ { G }; q), v); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\mu^*_m = \\sum_{k=1}^{2\\,J} \\left[Q^-_{n_0,k}X^-_{m,n_0,k}+Q^+_{n_0+1,k}X^+_{m,n_0+1,k}\\right] \\quad.",
        "Chain(\\mu _ { m } ^ { * }, BigSum(k; 1; Mul(2, J); Add(Mul(Q _ { n _ { 0 } , k } ^ { - }, X _ { m , n _ { 0 } , k } ^ { - }), Mul(Q _ { n _ { 0 } + 1 , k } ^ { + }, X _ { m , n _ { 0 } + 1 , k } ^ { + }))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "ml^2 \\ddot{\\theta} + mgl\\sin\\theta = -b\\dot{\\theta},",
        "Chain(Add(Mul(m, Pow(l; 2), Call(\\ddot{\\theta})), Mul(m, g, l, Call(sin; Call(\\theta)))), Neg(Mul(b, Call(\\dot{\\theta}))); =)",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "F= \\ln\\left[\\frac{\\sqrt{e + 1} + \\sqrt{e - 1}\\tan\\frac{\\nu}{2}}{\\sqrt{e + 1} - \\sqrt{e - 1}\\tan\\frac{\\nu}{2}}\\right]",
        "Chain(F, Call(ln; Div(Add(Sqrt(Add(e, 1)), Mul(Sqrt(Add(e, Neg(1))), Call(tan; Div(\\nu; 2)))); Add(Sqrt(Add(e, 1)), Neg(Mul(Sqrt(Add(e, Neg(1))), Call(tan; Div(\\nu; 2))))))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/hyperbolic-trajectories.md",
    ),
    (
        "\\mathbf{R} \\approx \\mathbf{R}_y=\\underset{\\mathbf{R}\\in SO(3)}{\\operatorname{arg\\,min}} (\\lambda_1|e_3-\\mathbf{Rv}_a|^2 + \\lambda_2|\\mathbf{v}_m^*-\\mathbf{Rv}_m|^2)",
        "Chain(\\mathbf{R}, \\mathbf{R}_y, Limiting(argmin; _{ \\mathbf { R } \\in S O ( 3 ) }; Add(Mul(\\lambda_1, Pow(Bars(Add(e_3, Neg(Mul(\\mathbf{R}, \\mathbf{v}_a)))); 2)), Mul(\\lambda_2, Pow(Bars(Add(\\mathbf { v } _ { m } ^ { * }, Neg(Mul(\\mathbf{R}, \\mathbf{v}_m)))); 2)))); \\approx, =)",
        "Mayitzin/ahrs/ahrs/filters/mahony.py",
    ),
    (
        "\\bm\\sigma_{R/N} = {\\tt addMRP}(\\bm\\sigma_{R_{0}/N}, -\\bm\\sigma_{R_{0}/R})",
        "Chain(\\bm{\\sigma}_{R/N}, Call(\\text{addMRP}; \\bm{\\sigma}_{R_0/N}, Neg(\\bm{\\sigma}_{R_0/R})); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/attTrackingError/_Documentation/secModuleDescription.tex",
    ),
    (
        "A = \\pi D_o L + \\pi D_i L + 2\\cdot \\frac{\\pi D_o^2}{4} - 2\\cdot \\frac{\\pi D_i^2}{4}",
        "Chain(A, Add(Mul(\\pi, D_o, L), Mul(\\pi, D_i, L), Mul(2, Div(Mul(\\pi, Pow(D_o; 2)); 4)), Neg(Mul(2, Div(Mul(\\pi, Pow(D_i; 2)); 4)))); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\boldsymbol{L}' = \\boldsymbol{L} - \\boldsymbol{r}_C\\times M\\boldsymbol{v}_C",
        "Chain(\\boldsymbol{L}', Add(\\boldsymbol{L}, Neg(Cross(\\boldsymbol{r}_C; Mul(M, \\boldsymbol{v}_C)))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "L_1 = 1",
        "Chain(L_1, 1; =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "x(t) = 0.5 \\cos (2t) + 0.5 \\sin (2t) .",
        "Chain(Call(x; t), Add(Mul(0.5, Call(cos; Mul(2, t))), Mul(0.5, Call(sin; Mul(2, t)))); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "K = 0.0696\\left(1 - 0.569\\frac{r}{d_2}\\right)\\left(1-\\sqrt{\\frac{r} {d_2}}\\beta\\right)(1-\\beta^5)\\lambda^2 + (\\lambda-1)^2",
        "Chain(K, Add(Mul(0.0696, Add(1, Neg(Mul(0.569, Div(r; d_2)))), Add(1, Neg(Mul(Sqrt(Div(r; d_2)), \\beta))), Add(1, Neg(Pow(\\beta; 5))), Pow(\\lambda; 2)), Pow(Add(\\lambda, Neg(1)); 2)); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "\\ddot{\\theta}(t) = \\begin{cases} \\pm \\ddot{\\theta}_{\\text{max}} & \\text{if } t_0 \\leq t < t_s \\\\ \\mp \\ddot{\\theta}_{\\text{max}} & \\text{if } t_s \\leq t \\leq t_f \\\\ 0 & \\text{if } t > t_f \\end{cases}",
        "Chain(Call(\\ddot{\\theta}; t), Piecewise(PlusMinus(\\ddot { \\theta } _ { \\text { m a x } }), Chain(t_0, t, t_s; \\le, <), PlusMinus(\\ddot { \\theta } _ { \\text { m a x } }; True), Chain(t_s, t, t_f; \\le, \\le), 0, Chain(t, t_f; >)); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/stepperMotor/stepperMotor.rst",
    ),
    (
        "^B_A\\mathbf{q}^* = \\,^A_B\\mathbf{q} = \\begin{bmatrix}q_w\\\\-q_x\\\\-q_y\\\\-q_z\\end{bmatrix}",
        "Chain(\\prescript { B } { A } { \\mathbf { q } } ^ { * }, \\prescript { A } { B } { \\mathbf { q } }, MatrixOf(q_w, Neg(q_x), Neg(q_y), Neg(q_z)); =, =)",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "\\left| \\frac{x}{y} - \\frac{x+a}{y+b} \\right| \\le \\frac{|xb|+|ya|}{|y| (|y|-|b|)}.",
        "Chain(Bars(Add(Div(x; y), Neg(Div(Add(x, a); Add(y, b))))), Div(Add(Bars(Mul(x, b)), Bars(Mul(y, a))); Mul(Bars(y), Add(Bars(y), Neg(Bars(b))))); \\le)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "n = \\frac{k\\eta_p}{1 - k(1-\\eta_p)}",
        "Chain(n, Div(Mul(k, \\eta_p); Add(1, Neg(Mul(k, Add(1, Neg(\\eta_p)))))); =)",
        "CalebBell/fluids/fluids/compressible.py",
    ),
    (
        "\\mathrm{CNR}_{dB} = 10\\log_{10}(\\mathrm{CNR})",
        "Chain(\\text{CNR}_{dB}, Mul(10, Call(lg; \\text{CNR})); =)",
        "AVSLab/basilisk/src/simulation/communication/downlinkHandling/downlinkHandling.rst",
    ),
    (
        "\\Big[m_{\\text{sp}_{i2}} d_{i2} \\hat{\\bm s}_{i2,3}^T\\Big] \\ddot{\\bm{r}}_{B/N} + \\Big[I_{s_{i2,2}} \\hat{\\bm s}_{i2,2}^T - m_{\\text{sp}_{i2}} d_{i2} \\hat{\\bm s}_{i2,3}^T [\\tilde{\\bm{r}}_{S_{c,i2}/B}]\\Big] \\dot{\\bm\\omega}_{\\cal B/N} + \\Big[I_{s_{i2,2}} + m_{\\text{sp}_{i2}} d_{i2}^2 + m_{\\text{sp}_{i2}} l_{i1} d_{i2} \\hat{\\bm s}_{i2,3}^T \\bm{\\hat{s}}_{i1,3} \\Big] \\ddot\\theta_{i1} \\\\ + \\Big[I_{s_{i2,2}} + m_{\\text{sp}_{i2}} d_{i2}^2 \\Big] \\ddot\\theta_{i2} = - (I_{s_{i2,1}} - I_{s_{i2,3}}) \\omega_{s_{i2,3}} \\omega_{s_{i2,1}} - k_{i2} \\theta_{i2} - c_{i2} \\dot{\\theta}_{i2} + \\hat{\\bm s}_{i2,2}^T \\bm \\tau_{\\text{ext}_{i2},H_{i2}} \\\\ - m_{\\text{sp}_{i2}} d_{i2} \\hat{\\bm s}_{i2,3}^T \\Big[ 2 [\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm{r}'_{S_{c,i2}/B} + [\\tilde{\\bm\\omega}_{\\cal B/N}] [\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm{r}_{S_{c,i2}/B} + l_{i1} \\dot{\\theta}_{i1}^2 \\bm{\\hat{s}}_{i1,1} \\Big]",
        "Chain(Add(Mul(Mul(m_{sp_i2}, d_{i2}, Transpose(\\hat{\\bm{s}}_{i2,3})), Call(\\ddot{\\bm{r}}_{B/N})), Mul(Add(Mul(I_{s_i2,2}, Transpose(\\hat{\\bm{s}}_{i2,2})), Neg(Mul(m_{sp_i2}, d_{i2}, Transpose(\\hat{\\bm{s}}_{i2,3}), [ \\tilde { \\bm { r } } _ { S _ { c , i 2 } / B } ]))), Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N })), Mul(Add(I_{s_i2,2}, Mul(m_{sp_i2}, Pow(d_{i2}; 2)), Mul(m_{sp_i2}, l_{i1}, d_{i2}, Transpose(\\hat{\\bm{s}}_{i2,3}), \\bm{\\hat{s}}_{i1,3})), Call(\\ddot{\\theta}_{i1})), Mul(Add(I_{s_i2,2}, Mul(m_{sp_i2}, Pow(d_{i2}; 2))), Call(\\ddot{\\theta}_{i2}))), Add(Neg(Mul(Add(I_{s_i2,1}, Neg(I_{s_i2,3})), \\omega_{s_i2,3}, \\omega_{s_i2,1})), Neg(Mul(k_{i2}, Call(\\theta_{i2}))), Neg(Mul(c_{i2}, Call(\\dot{\\theta}_{i2}))), Mul(Transpose(\\hat{\\bm{s}}_{i2,2}), \\bm{\\tau}_{ext_i2,H_i2}), Neg(Mul(m_{sp_i2}, d_{i2}, Transpose(\\hat{\\bm{s}}_{i2,3}), Add(Mul(2, [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{r}_{S_c,i2/B}'), Mul([ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{r}_{S_c,i2/B}), Mul(l_{i1}, Pow(Call(\\dot{\\theta}_{i1}); 2), \\bm{\\hat{s}}_{i1,1}))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\boldsymbol{\\hat{u}}_{r,1} = \\boldsymbol{\\hat{u}}_{r,2} = \\boldsymbol{\\hat{u}}_r",
        "Chain(\\boldsymbol{\\hat{u}}_{r,1}, \\boldsymbol{\\hat{u}}_{r,2}, \\boldsymbol{\\hat{u}}_r; =, =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/plane-change-maneuvers.md",
    ),
    (
        "f(x) := \\frac{\\exp\\left(-\\frac{1}{2}\\left(\\frac{x-\\mu}{\\sigma}+\\exp\\left(\\frac{x-\\mu}{\\sigma}\\right)\\right)\\right)} {\\sqrt{2\\pi}\\sigma}",
        "Chain(Call(f; x), Div(Call(exp; Neg(Mul(Div(1; 2), Add(Div(Add(x, Neg(\\mu)); \\sigma), Call(exp; Div(Add(x, Neg(\\mu)); \\sigma)))))); Mul(Sqrt(Mul(2, \\pi)), \\sigma)); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "t_0 = 0\\quad r_0 = r_p \\quad v_{r,0} = 0",
        "System(Chain(t_0, 0; =), Chain(r_0, r_p; =), Chain(v_{r,0}, 0; =))",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables.md",
    ),
    (
        "\\dot{\\bar{x}}(t) = \\bar{f}_m(\\bar{x}, t) = -\\mathbf{M}_m^{-1}\\bar{g}_m",
        "Chain(Call(\\dot{\\bar{x}}; t), Call(\\bar{f}_m; Call(\\bar{x}), t), Neg(Mul(Pow(\\mathbf{M}_m; Neg(1)), \\bar{g}_m)); =, =)",
        "moorepants/learn-multibody-dynamics/simulation.rst",
    ),
    (
        "f(x) := \\frac{1}{\\pi \\gamma [1 + {(\\frac{x-x_0}{\\gamma})}^2]}",
        "Chain(Call(f; x), Div(1; Mul(\\pi, \\gamma, Add(1, Pow(Div(Add(x, Neg(x_0)); \\gamma); 2)))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "\\begin{array}{c} ^b\\mathbf{a} = \\mathbf{C}\\,^r\\mathbf{a} \\\\ \\\\ ^b\\mathbf{m} = \\mathbf{C}\\,^r\\mathbf{m} \\end{array}",
        "System(Chain(\\prescript { b } { } { \\mathbf { a } }, Mul(\\mathbf{C}, \\prescript { r } { } { \\mathbf { a } }); =), Chain(\\prescript { b } { } { \\mathbf { m } }, Mul(\\mathbf{C}, \\prescript { r } { } { \\mathbf { m } }); =))",
        "Mayitzin/ahrs/ahrs/filters/famc.py",
    ),
    (
        "\\dot{V} = -2 \\alpha x_\\perp^2 < 0, \\quad \\forall x_\\perp > -1.",
        "System(Chain(Call(\\dot{V}), Neg(Mul(2, \\alpha, Pow(x_\\perp; 2))), 0; =, <), Forall(Chain(x_\\perp, Neg(1); >)))",
        "RussTedrake/underactuated/book/limit_cycles.html",
    ),
    (
        "f(\\boldsymbol{r}_1,\\boldsymbol{r}_2,\\cdots,\\boldsymbol{r}_n,t) = 0",
        "Chain(Call(f; \\boldsymbol{r}_1, \\boldsymbol{r}_2, Dots(), \\boldsymbol{r}_n, t), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/analytical-mechanics/Constraint.tex",
    ),
    (
        "\\begin{aligned} \\boldsymbol{v}_{\\mathrm{COG}} &= \\dot{\\boldsymbol{R}}_{\\mathrm{COG}} = \\frac{m_1 \\dot{\\boldsymbol{R}}_1 + m_2\\dot{\\boldsymbol{R}}_2}{m_1 + m_2}\\\\ \\boldsymbol{a}_{\\mathrm{COG}} &= \\ddot{\\boldsymbol{R}}_{\\mathrm{COG}} = \\frac{m_1 \\ddot{\\boldsymbol{R}}_1 + m_2\\ddot{\\boldsymbol{R}}_2}{m_1 + m_2} \\end{aligned}",
        "System(Chain(\\boldsymbol{v}_{COG}, Call(\\dot{\\boldsymbol{R}}_{COG}), Div(Add(Mul(m_1, Call(\\dot{\\boldsymbol{R}}_1)), Mul(m_2, Call(\\dot{\\boldsymbol{R}}_2))); Add(m_1, m_2)); =, =), Chain(\\boldsymbol{a}_{COG}, Call(\\ddot{\\boldsymbol{R}}_{COG}), Div(Add(Mul(m_1, Call(\\ddot{\\boldsymbol{R}}_1)), Mul(m_2, Call(\\ddot{\\boldsymbol{R}}_2))); Add(m_1, m_2)); =, =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/motion-of-the-barycenter.md",
    ),
    (
        "\\alpha_m = \\frac{1}{1 + \\left(\\frac{1-x}{x}\\right)\\frac{\\rho_g}{\\rho_l}} \\text{(homogeneous model)}",
        "System(Chain(\\alpha_m, Div(1; Add(1, Mul(Div(Add(1, Neg(x)); x), Div(\\rho_g; \\rho_l)))); =), Words(\\text{(homogeneous~model)}))",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "F(t) = \\begin{cases} -1 & \\text{if } \\; {-1} < t < 0 , \\\\ 1 & \\text{if } \\; \\phantom{-}0 < t < 1 , \\end{cases}",
        "Chain(Call(F; t), Piecewise(Neg(1), Chain(Neg(1), t, 0; <, <), 1, Chain(0, t, 1; <, <)); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "K = N\\cdot f_d",
        "Chain(K, Mul(N, f_d); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "C_{\\infty} = 0.5959 + 0.0312\\beta^{2.1} - 0.184\\beta^8 + \\frac{0.039\\beta^4}{(1.0 - \\beta^4)} - 0.01584",
        "Chain(C_\\infty, Add(0.5959, Mul(0.0312, Pow(\\beta; 2.1)), Neg(Mul(0.184, Pow(\\beta; 8))), Div(Mul(0.039, Pow(\\beta; 4)); Add(1.0, Neg(Pow(\\beta; 4)))), Neg(0.01584)); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "\\begin{array}{c} f_g( \\mathbf{q}, \\,^S\\mathbf{a}) = \\begin{bmatrix} 2(q_xq_z-q_wq_y)-a_x \\\\ 2(q_wq_x+q_yq_z)-a_y \\\\ 2(\\frac{1}{2}-q_x^2-q_y^2)-a_z \\end{bmatrix} \\\\ \\\\ J_g( \\mathbf{q})=\\begin{bmatrix} -2q_y & 2q_z & -2q_w & 2q_x \\\\ 2q_x & 2q_w & 2q_z & 2q_y \\\\ 0 & -4q_x & -4q_y & 0 \\end{bmatrix} \\end{array}",
        "System(Chain(Call(f_g; \\mathbf{q}, \\prescript { S } { } { \\mathbf { a } }), MatrixOf(Add(Mul(2, Add(Mul(q_x, q_z), Neg(Mul(q_w, q_y)))), Neg(a_x)), Add(Mul(2, Add(Mul(q_w, q_x), Mul(q_y, q_z))), Neg(a_y)), Add(Mul(2, Add(Div(1; 2), Neg(Pow(q_x; 2)), Neg(Pow(q_y; 2)))), Neg(a_z))); =), Chain(Call(J_g; \\mathbf{q}), MatrixOf(Neg(Mul(2, q_y)), Mul(2, q_z), Neg(Mul(2, q_w)), Mul(2, q_x), Mul(2, q_x), Mul(2, q_w), Mul(2, q_z), Mul(2, q_y), 0, Neg(Mul(4, q_x)), Neg(Mul(4, q_y)), 0); =))",
        "Mayitzin/ahrs/ahrs/filters/madgwick.py",
    ),
    (
        "\\mathbf{M}_{B_1} = \\begin{bmatrix} m_{B_1} & 0 & 0 & 0 & 0 & 0 \\\\ 0 & m_{B_1} & 0 & 0 & 0 & 0 \\\\ 0 & 0 & m_{B_1} & 0 & 0 & 0 \\\\ 0 & 0 & 0 & \\breve{I}^{B_1/B_{1o}} \\cdot \\hat{n}_x\\hat{n}_x & \\breve{I}^{B_1/B_{1o}} \\cdot \\hat{n}_x\\hat{n}_y & \\breve{I}^{B_1/B_{1o}} \\cdot \\hat{n}_x\\hat{n}_z \\\\ 0 & 0 & 0 & \\breve{I}^{B_1/B_{1o}} \\cdot \\hat{n}_y\\hat{n}_x & \\breve{I}^{B_1/B_{1o}} \\cdot \\hat{n}_y\\hat{n}_y & \\breve{I}^{B_1/B_{1o}} \\cdot \\hat{n}_y\\hat{n}_z \\\\ 0 & 0 & 0 & \\breve{I}^{B_1/B_{1o}} \\cdot \\hat{n}_z\\hat{n}_x & \\breve{I}^{B_1/B_{1o}} \\cdot \\hat{n}_z\\hat{n}_y & \\breve{I}^{B_1/B_{1o}} \\cdot \\hat{n}_z\\hat{n}_z \\\\ \\end{bmatrix}",
        "Chain(\\mathbf{M}_{B_1}, MatrixOf(m_{B_1}, 0, 0, 0, 0, 0, 0, m_{B_1}, 0, 0, 0, 0, 0, 0, m_{B_1}, 0, 0, 0, 0, 0, 0, Mul(\\breve { I } ^ { B _ { 1 } / B _ { 1 o } }, \\hat{n}_x, \\hat{n}_x), Mul(\\breve { I } ^ { B _ { 1 } / B _ { 1 o } }, \\hat{n}_x, \\hat{n}_y), Mul(\\breve { I } ^ { B _ { 1 } / B _ { 1 o } }, \\hat{n}_x, \\hat{n}_z), 0, 0, 0, Mul(\\breve { I } ^ { B _ { 1 } / B _ { 1 o } }, \\hat{n}_y, \\hat{n}_x), Mul(\\breve { I } ^ { B _ { 1 } / B _ { 1 o } }, \\hat{n}_y, \\hat{n}_y), Mul(\\breve { I } ^ { B _ { 1 } / B _ { 1 o } }, \\hat{n}_y, \\hat{n}_z), 0, 0, 0, Mul(\\breve { I } ^ { B _ { 1 } / B _ { 1 o } }, \\hat{n}_z, \\hat{n}_x), Mul(\\breve { I } ^ { B _ { 1 } / B _ { 1 o } }, \\hat{n}_z, \\hat{n}_y), Mul(\\breve { I } ^ { B _ { 1 } / B _ { 1 o } }, \\hat{n}_z, \\hat{n}_z)); =)",
        "moorepants/learn-multibody-dynamics/tmt.rst",
    ),
    (
        "\\boldsymbol{r}' & = \\overrightarrow{OQ} = \\overrightarrow{ON} + \\overrightarrow{NV} + \\overrightarrow{VQ} \\\\ & = (\\boldsymbol{n}\\cdot \\boldsymbol{r})\\boldsymbol{n} + \\big[\\boldsymbol{r}-(\\boldsymbol{n}\\cdot\\boldsymbol{r})\\boldsymbol{n}\\big] \\cos \\phi - (\\boldsymbol{r}\\times \\boldsymbol{n})\\sin \\phi",
        "Chain(\\boldsymbol{r}', \\vec { O Q }, Add(\\vec { O N }, \\vec { N V }, \\vec { V Q }), Add(Mul(Mul(\\boldsymbol{n}, \\boldsymbol{r}; 1), \\boldsymbol{n}), Mul(Add(\\boldsymbol{r}, Neg(Mul(Mul(\\boldsymbol{n}, \\boldsymbol{r}; 1), \\boldsymbol{n}))), Call(cos; \\phi)), Neg(Mul(Cross(\\boldsymbol{r}; \\boldsymbol{n}), Call(sin; \\phi)))); =, =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "L_{s_{i1,2}} = - k_{i1} \\theta_{i1} - c_{i1}\\dot{\\theta}_{i1} + k_{i2} \\theta_{i2} + c_{i2} \\dot\\theta_{i2} + \\hat{\\bm s}_{i1,2} \\cdot \\bm \\tau_{\\text{ext}_{i1},H_{i1}} + l_{i1} \\hat{\\bm s}_{i1,3} \\cdot \\bm F_{\\text{ext}_{i2}} - m_{\\text{sp}_{i1}} d_{i1} \\hat{\\bm s}_{i1,3} \\cdot \\Big[\\ddot{\\bm{r}}_{B/N} \\\\ + \\bm{r}''_{S_{c,i1}/B} + 2 \\bm\\omega_{\\cal B/N} \\times \\bm{r}'_{S_{c,i1}/B} + \\dot{\\bm\\omega}_{\\cal B/N} \\times \\bm{r}_{S_{c,i1}/B} + \\bm\\omega_{\\cal B/N} \\times (\\bm\\omega_{\\cal B/N} \\times \\bm{r}_{S_{c,i1}/B})\\Big]\\\\ - m_{sp_{i2}} l_{i1} \\hat{\\bm s}_{i1,3} \\cdot \\Big[\\ddot{\\bm{r}}_{B/N} + \\bm{r}''_{S_{c,i2}/B} + 2 \\bm\\omega_{\\cal B/N} \\times \\bm{r}'_{S_{c,i2}/B} + \\dot{\\bm\\omega}_{\\cal B/N} \\times \\bm{r}_{S_{c,i2}/B} \\\\ + \\bm\\omega_{\\cal B/N} \\times (\\bm\\omega_{\\cal B/N} \\times \\bm{r}_{S_{c,i2}/B})\\Big]",
        "Chain(L_{s_i1,2}, Add(Neg(Mul(k_{i1}, Call(\\theta_{i1}))), Neg(Mul(c_{i1}, Call(\\dot{\\theta}_{i1}))), Mul(k_{i2}, Call(\\theta_{i2})), Mul(c_{i2}, Call(\\dot{\\theta}_{i2})), Mul(\\hat{\\bm{s}}_{i1,2}, \\bm{\\tau}_{ext_i1,H_i1}; 1), Mul(l_{i1}, \\hat{\\bm{s}}_{i1,3}, \\bm{F}_{ext_i2}), Neg(Mul(m_{sp_i1}, d_{i1}, \\hat{\\bm{s}}_{i1,3}, Add(Call(\\ddot{\\bm{r}}_{B/N}), \\bm{r}_{S_c,i1/B}'', Cross(Mul(2, Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})); \\bm{r}_{S_c,i1/B}'), Cross(Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }); \\bm{r}_{S_c,i1/B}), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); \\bm{r}_{S_c,i1/B}))); 3)), Neg(Mul(m_{sp_i2}, l_{i1}, \\hat{\\bm{s}}_{i1,3}, Add(Call(\\ddot{\\bm{r}}_{B/N}), \\bm{r}_{S_c,i2/B}'', Cross(Mul(2, Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})); \\bm{r}_{S_c,i2/B}'), Cross(Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }); \\bm{r}_{S_c,i2/B}), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); \\bm{r}_{S_c,i2/B}))); 3))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\dot{\\boldsymbol{r}}\\times\\boldsymbol{h} - \\mu\\frac{\\boldsymbol{r}}{r} = \\boldsymbol{B}",
        "Chain(Add(Cross(Call(\\dot{\\boldsymbol{r}}); \\boldsymbol{h}), Neg(Mul(\\mu, Div(Call(\\boldsymbol{r}); Call(r))))), \\boldsymbol{B}; =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/the-orbit-equation.md",
    ),
    (
        "\\nu_{\\text{circle}} = \\frac{2\\pi}{T} t",
        "Chain(\\nu_{circle}, Mul(Div(Mul(2, \\pi); T), t); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "x^{*} = \\frac{1 - \\pi_2}{\\sigma^3}\\left(x^* + \\pi_2\\right) + \\frac{\\pi_2}{\\psi^3}\\left(x^* - 1 + \\pi_2\\right)",
        "Chain(x ^ { * }, Add(Mul(Div(Add(1, Neg(\\pi_2)); Pow(\\sigma; 3)), Add(x ^ { * }, \\pi_2)), Mul(Div(\\pi_2; Pow(\\psi; 3)), Add(x ^ { * }, Neg(1), \\pi_2))); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/lagrange-points.md",
    ),
    (
        "u(x,t) = V(x) \\cos (\\omega t) + W (x) \\sin ( \\omega t)",
        "Chain(Call(u; x, t), Add(Mul(Call(V; x), Call(cos; Mul(\\omega, t))), Mul(Call(W; x), Call(sin; Mul(\\omega, t)))); =)",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "\\mathscr{J}_\\theta = \\boldsymbol{J} \\cdot \\frac{\\partial \\boldsymbol{r}'}{\\partial \\theta} = Jl\\cos\\theta \\\\ \\mathscr{J}_\\phi = \\boldsymbol{J} \\cdot \\frac{\\partial \\boldsymbol{r}'}{\\partial \\phi} = Ja\\cos\\phi",
        "System(Chain(\\mathscr{J}_\\theta, Mul(\\boldsymbol{J}, Derivative(Call(\\boldsymbol{r}'); \\theta, 1; True)), Mul(J, l, Call(cos; \\theta)); =, =), Chain(\\mathscr{J}_\\phi, Mul(\\boldsymbol{J}, Derivative(Call(\\boldsymbol{r}'); \\phi, 1; True)), Mul(J, a, Call(cos; \\phi)); =, =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "\\phi_{n,2\\,j-1} = \\phi_{n,2\\,j} = e^{-c_j\\,(t_n - t_{n-1})}",
        "Chain(\\phi_{n,2\\,j-1}, \\phi_{n,2\\,j}, Pow(e; Neg(Mul(c_j, Add(t_n, Neg(t_{n-1}))))); =, =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "x = C_1 x_0(t) + C_2 x_0(t) \\int \\frac{g(t) F(t) P(t)}{x_0^{2}(t)} \\,dt",
        "Chain(x, Add(Mul(C_1, Call(x_0; t)), Mul(C_2, Call(x_0; t), Antiderivative(Div(Mul(Call(g; t), Call(F; t), Call(P; t)); Pow(Call(x_0; t); 2)); t))); =)",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "\\mathbf{y} = \\begin{bmatrix}f_x & f_y & f_z & h_x & h_y & h_z\\end{bmatrix}^T",
        "Chain(\\mathbf{y}, Transpose(MatrixOf(f_x, f_y, f_z, h_x, h_y, h_z)); =)",
        "Mayitzin/ahrs/ahrs/filters/fourati.py",
    ),
    (
        "\\frac{dV}{dt} = -\\frac{G m_1 m_2}{\\left(x^2 + y^2 + z^2\\right)^{3/2}} \\left(-x v_x - y v_y - z v_z\\right)",
        "Chain(Derivative(Call(V); t, 1), Neg(Mul(Div(Mul(G, m_1, m_2); Pow(Add(Pow(x; 2), Pow(y; 2), Pow(z; 2)); Div(3; 2))), Add(Neg(Mul(x, v_x)), Neg(Mul(y, v_y)), Neg(Mul(z, v_z))))); =)",
        "bryanwweber/orbital-mechanics-notes/constants-of-orbital-motion/energy-is-conserved-in-orbital-motion.md",
    ),
    (
        "X(t) = \\exp(B(t)) C",
        "Chain(Call(X; t), Mul(Call(exp; Call(B; t)), C); =)",
        "sympy/sympy/sympy/solvers/ode/systems.py",
    ),
    (
        "\\bar{T} = \\bar{M}^{S/P} \\\\ \\bar{v} = \\bar{R}^{S/P}",
        "System(Chain(\\bar{T}, \\bar { M } ^ { S / P }; =), Chain(\\bar{v}, \\bar { R } ^ { S / P }; =))",
        "moorepants/learn-multibody-dynamics/loads.rst",
    ),
    (
        "M_h = e\\sinh F - F",
        "Chain(M_h, Add(Mul(e, Call(sinh; F)), Neg(F)); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/hyperbolic-trajectories.md",
    ),
    (
        "{}^A\\bar{v}^P & = \\frac{{}^Ad\\bar{r}^{P/O}}{dt} \\\\ & = \\frac{{}^Bd\\bar{r}^{P/O}}{dt} + {}^A\\bar{\\omega}^B\\times\\bar{r}^{P/O} \\\\ & = {}^B\\bar{v}^P + {}^A\\bar{\\omega}^B\\times\\bar{r}^{P/O}",
        "Chain(\\prescript { A } { } { \\bar { v } } ^ { P }, Marked(Derivative(Call(\\bar { r } ^ { P / O }); t, 1); _{ A }), Add(Marked(Derivative(Call(\\bar { r } ^ { P / O }); t, 1); _{ B }), Cross(\\prescript { A } { } { \\bar { \\omega } } ^ { B }; Call(\\bar { r } ^ { P / O }))), Add(\\prescript { B } { } { \\bar { v } } ^ { P }, Cross(\\prescript { A } { } { \\bar { \\omega } } ^ { B }; Call(\\bar { r } ^ { P / O }))); =, =, =)",
        "moorepants/learn-multibody-dynamics/translational.rst",
    ),
    (
        "(m\\ddot{z} + mg) (x_{cp} - x) = (z_{cp} - z) m\\ddot{x} - I\\ddot\\theta.",
        "Chain(Mul(Add(Mul(m, Call(\\ddot{z})), Mul(m, g)), Add(x_{cp}, Neg(Call(x)))), Add(Mul(Add(z_{cp}, Neg(Call(z))), m, Call(\\ddot{x})), Neg(Mul(I, Call(\\ddot{\\theta})))); =)",
        "RussTedrake/underactuated/book/humanoids.html",
    ),
    (
        "\\Gamma(s,z) = \\Gamma(s) - \\frac{z^s}{s} {}_1F_1(s, s+1, -z)",
        "Chain(Call(Gamma; s, z), Add(Call(Gamma; s), Neg(Mul(Div(Pow(z; s); s), Call(\\prescript { } { 1 } { F } _ { 1 }; s, Add(s, 1), Neg(z))))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "\\bar{f}_k(\\dot{\\bar{q}}, \\dot{\\bar{q}}_r, \\bar{u}, \\bar{u}_r, \\bar{q}, \\bar{q}_r, t) = 0 \\in \\mathbb{R}^N",
        "Chain(Call(\\bar{f}_k; Call(\\dot{\\bar{q}}), Call(\\dot{\\bar{q}}_r), \\bar{u}, \\bar{u}_r, Call(\\bar{q}), Call(\\bar{q}_r), t), 0, Pow(\\mathbb{R}; N); =, \\in)",
        "moorepants/learn-multibody-dynamics/holonomic-eom.rst",
    ),
    (
        "{\\bf P} = {\\bf P}^T \\succ 0, \\quad {\\bf A}^T {\\bf P}{\\bf E} + {\\bf E}^T {\\bf P} {\\bf A} \\prec 0.",
        "System(Chain(\\mathbf{P}, Transpose(\\mathbf{P}), 0; =, \\succ), Chain(Add(Mul(Transpose(\\mathbf{A}), \\mathbf{P}, \\mathbf{E}), Mul(Transpose(\\mathbf{E}), \\mathbf{P}, \\mathbf{A})), 0; \\prec))",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "u = -\\tau_g + K_p (q_d - q) + K_d (\\dot{q}_d - \\dot{q}).",
        "Chain(u, Add(Neg(\\tau_g), Mul(K_p, Add(Call(q_d), Neg(Call(q)))), Mul(K_d, Add(Call(\\dot{q}_d), Neg(Call(\\dot{q}))))); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "H3 &= 1",
        "Chain(\\text{H3}, 1; =)",
        "sympy/sympy/doc/src/tutorials/physics/control/control_problems.rst",
    ),
    (
        "\\bar{v} = & v_x \\hat{n}_x + v_y \\hat{n}_y + v_z \\hat{n}_z \\\\ \\bar{w} = & w_x \\hat{n}_x + w_y \\hat{n}_y + w_z \\hat{n}_z \\\\ \\bar{v} \\cdot \\bar{w} = & v_x w_x + v_v w_y + v_z w_z",
        "System(Chain(\\bar{v}, Add(Mul(v_x, \\hat{n}_x), Mul(v_y, \\hat{n}_y), Mul(v_z, \\hat{n}_z)); =), Chain(\\bar{w}, Add(Mul(w_x, \\hat{n}_x), Mul(w_y, \\hat{n}_y), Mul(w_z, \\hat{n}_z)); =), Chain(Mul(\\bar{v}, \\bar{w}; 1), Add(Mul(v_x, w_x), Mul(v_v, w_y), Mul(v_z, w_z)); =))",
        "moorepants/learn-multibody-dynamics/vectors.rst",
    ),
    (
        "f(x, \\mu, \\sigma) = \\frac{1}{\\sigma\\sqrt{2\\pi}} \\exp\\big [{-\\frac{(x-\\mu)^2}{2\\sigma^2} }\\big ]",
        "Chain(Call(f; x, \\mu, \\sigma), Mul(Div(1; Mul(\\sigma, Sqrt(Mul(2, \\pi)))), Call(exp; Neg(Div(Pow(Add(x, Neg(\\mu)); 2); Mul(2, Pow(\\sigma; 2)))))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_main.rst",
    ),
    (
        "\\bm \\omega_k = \\frac{1}{\\Delta t} \\frac{\\bm d_k \\times \\bm d_{k-1}}{\\|\\bm d_k \\times \\bm d_{k-1} \\|} \\arccos\\left( \\frac{\\bm d_k \\cdot \\bm d_{k-1}}{\\|\\bm d_k \\| \\| \\bm d_{k-1}\\|}\\right)",
        "Chain(\\bm{\\omega}_k, Mul(Div(1; \\Delta t), Div(Cross(\\bm{d}_k; \\bm{d}_{k-1}); Norm(Cross(\\bm{d}_k; \\bm{d}_{k-1}))), Call(arccos; Div(Mul(\\bm{d}_k, \\bm{d}_{k-1}; 1); Mul(Norm(\\bm{d}_k), Norm(\\bm{d}_{k-1}))))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attDetermination/okeefeEKF/_Documentation/Okeefe_EKF.tex",
    ),
    (
        "\\left\\|\\exp(2^{-r}A) - \\sum_{k=0}^{N-1} \\frac{\\left(2^{-r} A\\right)^k}{k!} \\right\\|_{\\infty} = \\left\\|\\sum_{k=N}^{\\infty} \\frac{\\left(2^{-r} A\\right)^k}{k!}\\right\\|_{\\infty} \\le \\sum_{k=N}^{\\infty} \\frac{(2^{-r} \\|A\\|_{\\infty})^k}{k!}.",
        "Chain(Marked(Norm(Add(Call(exp; Mul(Pow(2; Neg(r)), A)), Neg(BigSum(k; 0; Add(N, Neg(1)); Div(Pow(Mul(Pow(2; Neg(r)), A); k); Factorial(k)))))); _{ \\infty }), Marked(Norm(BigSum(k; N; Infinity(); Div(Pow(Mul(Pow(2; Neg(r)), A); k); Factorial(k)))); _{ \\infty }), BigSum(k; N; Infinity(); Div(Pow(Mul(Pow(2; Neg(r)), Marked(Norm(A); _{ \\infty })); k); Factorial(k))); =, \\le)",
        "fredrik-johansson/arb/doc/source/arb_mat.rst",
    ),
    (
        "P_n^m(z) = \\frac{(1+z)^{m/2}}{(1-z)^{m/2}} \\mathbf{F}\\left(-n, n+1, 1-m, \\frac{1-z}{2}\\right)",
        "Chain(Call(P _ { n } ^ { m }; z), Mul(Div(Pow(Add(1, z); Div(m; 2)); Pow(Add(1, Neg(z)); Div(m; 2))), Call(\\mathbf{F}; Neg(n), Add(n, 1), Add(1, Neg(m)), Div(Add(1, Neg(z)); 2))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "U(x^*, y^*) = -\\frac{1 - \\pi_2}{\\sigma} - \\frac{\\pi_2}{\\psi} - \\frac{1}{2}\\left[\\left(1 - \\pi_2\\right)\\sigma^2 + \\pi_2 \\psi^2\\right]",
        "Chain(Call(U; x ^ { * }, y ^ { * }), Add(Neg(Div(Add(1, Neg(\\pi_2)); \\sigma)), Neg(Div(\\pi_2; \\psi)), Neg(Mul(Div(1; 2), Add(Mul(Add(1, Neg(\\pi_2)), Pow(\\sigma; 2)), Mul(\\pi_2, Pow(\\psi; 2)))))); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/jacobi-constant.md",
    ),
    (
        "\\begin{bmatrix} x_{lm,obs} \\\\ y_{lm,obs} \\end{bmatrix} = \\begin{bmatrix} x + d \\cos(\\phi + \\theta) \\\\ y + d \\sin(\\phi + \\theta) \\end{bmatrix}",
        "Chain(MatrixOf(x_{lm,obs}, y_{lm,obs}), MatrixOf(Add(x, Mul(d, Call(cos; Add(\\phi, \\theta)))), Add(y, Mul(d, Call(sin; Add(\\phi, \\theta))))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/ensamble_kalman_filter_localization_files/ensamble_kalman_filter_localization_main.rst",
    ),
    (
        "\\dot{x} = v \\cos\\theta \\\\ \\dot{y} = v \\sin\\theta \\\\ v = \\sqrt{\\dot{x}^2 + \\dot{y}^2}",
        "System(Chain(Call(\\dot{x}), Mul(v, Call(cos; \\theta)); =), Chain(Call(\\dot{y}), Mul(v, Call(sin; \\theta)); =), Chain(v, Sqrt(Add(Pow(Call(\\dot{x}); 2), Pow(Call(\\dot{y}); 2))); =))",
        "RussTedrake/underactuated/book/intro.html",
    ),
    (
        "\\begin{aligned} {}_I \\mathbf J_Q(\\mathbf q) &= \\begin{bmatrix} {}_I \\mathbf J_P \\\\ {}_I \\mathbf J_R \\end{bmatrix} \\\\ &= \\begin{bmatrix} \\mathds{1}_{3\\times 3} && -\\mathbf C_{I\\!B} \\cdot {}_B\\hat{\\mathbf r}_{B\\!Q} && \\mathbf C_{I\\!B} \\cdot {}_B \\mathbf J_{P_{q_j}}(\\mathbf q_j) \\\\ \\mathbf{0}_{3 \\times 3} && \\mathbf C_{I\\!B} && \\mathbf C_{I\\!B} \\cdot {}_B \\mathbf J_{R_{q_j}}(\\mathbf q_j) \\end{bmatrix} \\end{aligned}",
        "Chain(Call(\\prescript { } { I } { \\mathbf { J } } _ { Q }; \\mathbf{q}), MatrixOf(\\prescript { } { I } { \\mathbf { J } } _ { P }, \\prescript { } { I } { \\mathbf { J } } _ { R }), MatrixOf(Marked(1; _{ 3 \\times 3 }), Blank(), Neg(Mul(\\mathbf{C}_{I\\!B}, \\prescript { } { B } { \\hat { \\mathbf { r } } } _ { B \\! Q })), Blank(), Mul(\\mathbf{C}_{I\\!B}, Call(\\prescript { } { B } { \\mathbf { J } } _ { P _ { q _ { j } } }; \\mathbf{q}_j)), Marked(0; _{ 3 \\times 3 }), Blank(), \\mathbf{C}_{I\\!B}, Blank(), Mul(\\mathbf{C}_{I\\!B}, Call(\\prescript { } { B } { \\mathbf { J } } _ { R _ { q _ { j } } }; \\mathbf{q}_j))); =, =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "\\sinh F = \\frac{y}{b}",
        "Chain(Call(sinh; F), Div(y; b); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/hyperbolic-trajectories.md",
    ),
    (
        "\\omega = \\sqrt{\\omega_1^2 +\\omega_2^2 +\\omega_3^2} = \\sqrt{\\omega_0^2 + \\varOmega^2}\\quad \\text{（常数）}",
        "System(Chain(\\omega, Sqrt(Add(Pow(\\omega_1; 2), Pow(\\omega_2; 2), Pow(\\omega_3; 2))), Sqrt(Add(Pow(\\omega_0; 2), Pow(\\varOmega; 2))); =, =), Words(\\text{（常数）}))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "\\left[\\mathbf{Q}\\right]^T = \\begin{bmatrix}Q_{11} & Q_{21} & Q_{31}\\\\Q_{12} & Q_{22} & Q_{32}\\\\Q_{13} & Q_{23} & Q_{33}\\end{bmatrix}",
        "Chain(Transpose([ \\mathbf { Q } ]), MatrixOf(Q_{11}, Q_{21}, Q_{31}, Q_{12}, Q_{22}, Q_{32}, Q_{13}, Q_{23}, Q_{33}); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "r_{\\text{SOI}} = R \\left(\\frac{m_p}{m_s}\\right)^{2/5}",
        "Chain(r_{SOI}, Mul(R, Pow(Div(m_p; m_s); Div(2; 5))); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/sphere-of-influence.md",
    ),
    (
        "C_0 = \\sup_{|t| \\le |a|} |f(x+t)|, \\quad C_1 = \\sup_{|t| \\le |a|} |f'(x+t)|.",
        "System(Chain(C_0, Limiting(sup; _{ | t | \\le | a | }; Bars(Call(f; Add(x, t)))); =), Chain(C_1, Limiting(sup; _{ | t | \\le | a | }; Bars(Call(f'; Add(x, t)))); =))",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "n := N - M",
        "Chain(n, Add(N, Neg(M)); =)",
        "moorepants/learn-multibody-dynamics/configuration.rst",
    ),
    (
        "{\\bf y}[0] =& {\\bf C}{\\bf x}[0] + {\\bf D}{\\bf u}[0] + {\\bf v}[0], \\\\ {\\bf y}[1] =& {\\bf C}({\\bf A}{\\bf x}[0] + {\\bf B}{\\bf u}[0] + {\\bf w}[0]) + {\\bf D}{\\bf u}[1] + {\\bf v}[1], \\\\ {\\bf y}[n] =& {\\bf C}{\\bf A}^n{\\bf x}[0] + {\\bf D}{\\bf u}[n] + {\\bf v}[n] + \\sum_{k=0}^{n-1}{\\bf C}{\\bf A}^{n-k-1}({\\bf B}{\\bf u}[k] + {\\bf w}[k]).",
        "System(Chain(Indexed(\\mathbf{y}; 0), Add(Mul(\\mathbf{C}, Indexed(\\mathbf{x}; 0)), Mul(\\mathbf{D}, Indexed(\\mathbf{u}; 0)), Indexed(\\mathbf{v}; 0)); =), Chain(Indexed(\\mathbf{y}; 1), Add(Mul(\\mathbf{C}, Add(Mul(\\mathbf{A}, Indexed(\\mathbf{x}; 0)), Mul(\\mathbf{B}, Indexed(\\mathbf{u}; 0)), Indexed(\\mathbf{w}; 0))), Mul(\\mathbf{D}, Indexed(\\mathbf{u}; 1)), Indexed(\\mathbf{v}; 1)); =), Chain(Indexed(\\mathbf{y}; n), Add(Mul(\\mathbf{C}, Pow(\\mathbf{A}; n), Indexed(\\mathbf{x}; 0)), Mul(\\mathbf{D}, Indexed(\\mathbf{u}; n)), Indexed(\\mathbf{v}; n), BigSum(k; 0; Add(n, Neg(1)); Mul(\\mathbf{C}, Pow(\\mathbf{A}; Add(n, Neg(k), Neg(1))), Add(Mul(\\mathbf{B}, Indexed(\\mathbf{u}; k)), Indexed(\\mathbf{w}; k))))); =))",
        "RussTedrake/underactuated/book/sysid.html",
    ),
    (
        "|R| \\le \\frac{4}{(2\\pi)^{2M}} \\int_N^U \\left| f^{(2M)}(t) \\right| dt.",
        "Chain(Bars(R), Mul(Div(4; Pow(Mul(2, \\pi); Mul(2, M))), Integral(Bars(Call(f ^ { ( 2 M ) }; t)); t; N; U)); \\le)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "f^{B_q}_C = f^{B_p}_C, \\qquad \\tau^{B_q}_C = \\tau^{B_p}_C + {}^{B_q}p^{B_p}_C \\times f^{B_p}_C.",
        "System(Chain(f _ { C } ^ { B _ { q } }, f _ { C } ^ { B _ { p } }; =), Chain(\\tau _ { C } ^ { B _ { q } }, Add(\\tau _ { C } ^ { B _ { p } }, Cross(\\prescript { B _ { q } } { } { p } _ { C } ^ { B _ { p } }; f _ { C } ^ { B _ { p } })); =))",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "F \\left( \\begin{bmatrix} 1 \\\\ 3 \\end{bmatrix} \\right) = 2 \\begin{bmatrix} 1 \\\\ 3 \\end{bmatrix} = \\begin{bmatrix} 2 \\\\ 6 \\end{bmatrix} .",
        "Chain(Call(F; MatrixOf(1, 3)), Mul(2, MatrixOf(1, 3)), MatrixOf(2, 6); =, =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "L & = T-U = T_2 - U_1 - U_0 \\\\ H & = L_2 - L_0 = T_2 + U_1 + U_0",
        "System(Chain(L, Add(T, Neg(U)), Add(T_2, Neg(U_1), Neg(U_0)); =, =), Chain(H, Add(L_2, Neg(L_0)), Add(T_2, U_1, U_0); =, =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter9.tex",
    ),
    (
        "\\theta(h) = \\arg \\left(\\Gamma\\left(\\frac{2ih+1}{4}\\right)\\right) - \\frac{\\log \\pi}{2} h",
        "Chain(Call(\\theta; h), Add(Call(arg; Call(Gamma; Div(Add(Mul(2, i, h), 1); 4))), Neg(Mul(Div(Call(log; \\pi); 2), h))); =)",
        "fredrik-johansson/arb/doc/source/arb_poly.rst",
    ),
    (
        "\\lambda = \\sigma + \\mathbf{Z}\\cdot\\mathbf{Y}",
        "Chain(\\lambda, Add(\\sigma, Mul(\\mathbf{Z}, \\mathbf{Y})); =)",
        "Mayitzin/ahrs/ahrs/filters/quest.py",
    ),
    (
        "\\boxed{\\mathbf{P}_{yy} = \\sum_{i=0}^{2n} w_i^{(c)} (\\mathcal{Y}_i - \\bar{\\mathbf{y}})(\\mathcal{Y}_i - \\bar{\\mathbf{y}})^T + \\mathbf{Q}}",
        "Chain(\\mathbf{P}_{yy}, Add(BigSum(i; 0; Mul(2, n); Mul(w _ { i } ^ { ( c ) }, Add(\\mathcal{Y}_i, Neg(\\bar{\\mathbf{y}})), Transpose(Add(\\mathcal{Y}_i, Neg(\\bar{\\mathbf{y}}))))), \\mathbf{Q}); =)",
        "Mayitzin/ahrs/ahrs/filters/ukf.py",
    ),
    (
        "C = \\frac{F_0}{m \\sqrt{{(2\\omega p)}^2+{(\\omega_0^2-\\omega^2)}^2}} .",
        "Chain(C, Div(F_0; Mul(m, Sqrt(Add(Pow(Mul(2, \\omega, p); 2), Pow(Add(Pow(\\omega_0; 2), Neg(Pow(\\omega; 2))); 2))))); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "R = \\begin{bmatrix} \\cos(\\theta) & 0 & -\\sin(\\theta) \\\\ 0 & 1 & 0 \\\\ \\sin(\\theta) & 0 & \\cos(\\theta) \\end{bmatrix}",
        "Chain(R, MatrixOf(Call(cos; \\theta), 0, Neg(Call(sin; \\theta)), 0, 1, 0, Call(sin; \\theta), 0, Call(cos; \\theta)); =)",
        "sympy/sympy/sympy/matrices/dense.py",
    ),
    (
        "\\dot{\\boldsymbol{x}} = \\boldsymbol{f}\\big( \\boldsymbol{x}\\,,\\,\\boldsymbol{u} \\big)",
        "Chain(Call(\\dot{\\boldsymbol{x}}), Call(\\boldsymbol{f}; Call(\\boldsymbol{x}), \\boldsymbol{u}); =)",
        "JSBSim-Team/jsbsim-reference-manual/docs/formulation/overview.md",
    ),
    (
        "\\begin{split} \\det \\left( \\begin{bmatrix} 1 & 2 & 3 \\\\ 0 & 5 & 0 \\\\ 7 & 8 & 9 \\end{bmatrix} \\right) & = - 0 \\cdot \\det \\left( \\begin{bmatrix} 2 & 3 \\\\ 8 & 9 \\end{bmatrix} \\right) + 5 \\cdot \\det \\left( \\begin{bmatrix} 1 & 3 \\\\ 7 & 9 \\end{bmatrix} \\right) - 0 \\cdot \\det \\left( \\begin{bmatrix} 1 & 2 \\\\ 7 & 8 \\end{bmatrix} \\right) \\\\ & = 0 + 5 (1 \\cdot 9 - 3 \\cdot 7) + 0 = -60 . \\end{split}",
        "Chain(Call(det; MatrixOf(1, 2, 3, 0, 5, 0, 7, 8, 9)), Add(Neg(Mul(0, Call(det; MatrixOf(2, 3, 8, 9)))), Mul(5, Call(det; MatrixOf(1, 3, 7, 9))), Neg(Mul(0, Call(det; MatrixOf(1, 2, 7, 8))))), Add(0, Mul(5, Add(Mul(1, 9), Neg(Mul(3, 7)))), 0), Neg(60); =, =, =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "\\begin{bmatrix} x_{cp} \\\\ z_{cp}\\end{bmatrix} \\equiv \\,{}^Wp^{R_{cp}}_W = \\frac{\\sum_i {}^Wp^{B_i}_{W}\\, f^{B_i}_{W_z}}{\\sum_i f^{B_i}_{W_z}}.",
        "Chain(MatrixOf(x_{cp}, z_{cp}), \\prescript { W } { } { p } _ { W } ^ { R _ { c p } }, Div(BigSum(i; Mul(\\prescript { W } { } { p } _ { W } ^ { B _ { i } }, f _ { W _ { z } } ^ { B _ { i } })); BigSum(i; f _ { W _ { z } } ^ { B _ { i } })); \\equiv, =)",
        "RussTedrake/underactuated/book/humanoids.html",
    ),
    (
        "\\begin{aligned}f &= \\frac{x\\dot{y}_0 - y\\dot{x}_0}{h} & g &= \\frac{-xy_0 + yx_0}{h} \\\\ \\dot{f} &= \\frac{\\dot{x}\\dot{y}_0 - \\dot{y}\\dot{x}_0}{h} & \\dot{g} &= \\frac{-\\dot{x}y_0 + \\dot{y}x_0}{h}\\end{aligned}",
        "System(Chain(Call(f), Div(Add(Mul(Call(x), \\dot { y } _ { 0 }), Neg(Mul(Call(y), \\dot { x } _ { 0 }))); h); =), Chain(Call(g), Div(Add(Neg(Mul(Call(x), y_0)), Mul(Call(y), x_0)); h); =), Chain(Call(\\dot{f}), Div(Add(Mul(Call(\\dot{x}), \\dot { y } _ { 0 }), Neg(Mul(Call(\\dot{y}), \\dot { x } _ { 0 }))); h); =), Chain(Call(\\dot{g}), Div(Add(Neg(Mul(Call(\\dot{x}), y_0)), Mul(Call(\\dot{y}), x_0)); h); =))",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/the-lagrange-coefficients.md",
    ),
    (
        "x(t) = \\int_0^t \\frac{\\sin (\\omega_0 \\tau)}{\\omega_0} \\, \\cos \\bigl( \\omega_0 (t-\\tau) \\bigr) \\, d\\tau = \\frac{1}{\\omega_0} \\int_0^t \\sin ( \\omega_0 \\tau ) \\, \\cos \\bigl(\\omega_0 (t-\\tau) \\bigr) \\, d\\tau .",
        "Chain(Call(x; t), Integral(Mul(Div(Call(sin; Mul(\\omega_0, \\tau)); \\omega_0), Call(cos; Mul(\\omega_0, Add(t, Neg(\\tau))))); \\tau; 0; t), Mul(Div(1; \\omega_0), Integral(Mul(Call(sin; Mul(\\omega_0, \\tau)), Call(cos; Mul(\\omega_0, Add(t, Neg(\\tau))))); \\tau; 0; t)); =, =)",
        "jirilebl/diffyqs/ch-laplace.tex",
    ),
    (
        "\\dot{v} = 0",
        "Chain(Call(\\dot{v}), 0; =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/ensamble_kalman_filter_localization_files/ensamble_kalman_filter_localization_main.rst",
    ),
    (
        "v^* = v[n] - 2h \\frac{1 + \\epsilon}{\\kappa} v[n] - h\\frac{1+\\epsilon}{\\kappa^2} q[n].",
        "Chain(v ^ { * }, Add(Indexed(v; n), Neg(Mul(2, h, Div(Add(1, \\epsilon); \\kappa), Indexed(v; n))), Neg(Mul(h, Div(Add(1, \\epsilon); Pow(\\kappa; 2)), Indexed(q; n)))); =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "r^4 - 4 r^3 + 8 r^2 - 8 r + 4 & = 0 , \\\\ {(r^2-2r+2)}^2 & = 0 , \\\\ {\\bigl({(r-1)}^2+1\\bigr)}^2 & = 0 .",
        "System(Chain(Add(Pow(r; 4), Neg(Mul(4, Pow(r; 3))), Mul(8, Pow(r; 2)), Neg(Mul(8, r)), 4), 0; =), Chain(Pow(Add(Pow(r; 2), Neg(Mul(2, r)), 2); 2), 0; =), Chain(Pow(Add(Pow(Add(r, Neg(1)); 2), 1); 2), 0; =))",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "P_{nm}(x) = 2^{-n}(1-x^2)^{m/2} \\sum_{k=0}^{K}(-1)^k\\frac{(2n-2k)!}{k!(n-k)!(n-m-2k)!}x^{n-m-2k}",
        "Chain(Call(P_{nm}; x), Mul(Pow(2; Neg(n)), Pow(Add(1, Neg(Pow(x; 2))); Div(m; 2)), BigSum(k; 0; K; Mul(Pow(Neg(1); k), Div(Factorial(Add(Mul(2, n), Neg(Mul(2, k)))); Mul(Factorial(k), Factorial(Add(n, Neg(k))), Factorial(Add(n, Neg(m), Neg(Mul(2, k)))))), Pow(x; Add(n, Neg(m), Neg(Mul(2, k))))))); =)",
        "Mayitzin/ahrs/ahrs/utils/wmm.py",
    ),
    (
        "f(x) := \\frac{\\alpha\\,x_m^\\alpha}{x^{\\alpha+1}}",
        "Chain(Call(f; x), Div(Mul(\\alpha, Pow(x_m; \\alpha)); Pow(x; Add(\\alpha, 1))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "\\mathbf{T} := \\mathbf{J}_{\\bar{v},\\bar{u}} \\in \\mathbb{R}^{6\\nu \\times n} \\quad \\textrm{where} \\quad \\bar{v} = \\mathbf{T} \\bar{u}",
        "System(Chain(\\mathbf{T}, \\mathbf{J}_{\\bar v,\\bar u}, Pow(\\mathbb{R}; Cross(Mul(6, \\nu); n)); =, \\in), Chain(\\bar{v}, Mul(\\mathbf{T}, \\bar{u}); =))",
        "moorepants/learn-multibody-dynamics/tmt.rst",
    ),
    (
        "\\hat{J}^*_{\\bf \\alpha}({\\bf x}) = \\sum_i \\alpha_i \\psi_i({\\bf x}) = {\\bf \\psi}^T({\\bf x}) {\\bf \\alpha},",
        "Chain(Call(\\hat { J } _ { \\mathbf { \\alpha } } ^ { * }; \\mathbf{x}), BigSum(i; Mul(\\alpha_i, Call(\\psi_i; \\mathbf{x}))), Mul(Transpose(Call(\\mathbf{\\psi}; \\mathbf{x})), \\mathbf{\\alpha}); =, =)",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "\\begin{aligned} m_1 x_1'' & = k(x_2-x_1) , \\\\ m_2 x_2'' & = - k(x_2-x_1) . \\end{aligned}",
        "System(Chain(Mul(m_1, x_1''), Mul(k, Add(x_2, Neg(x_1))); =), Chain(Mul(m_2, x_2''), Neg(Mul(k, Add(x_2, Neg(x_1)))); =))",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\begin{aligned} x_1'(t) &= g_1\\bigl(x_1(t),x_2(t),x_3(t),t\\bigr) , \\\\ x_2'(t) &= g_2\\bigl(x_1(t),x_2(t),x_3(t),t\\bigr) , \\\\ x_3'(t) &= g_3\\bigl(x_1(t),x_2(t),x_3(t),t\\bigr) . \\end{aligned}",
        "System(Chain(Call(x_1'; t), Call(g_1; Call(x_1; t), Call(x_2; t), Call(x_3; t), t); =), Chain(Call(x_2'; t), Call(g_2; Call(x_1; t), Call(x_2; t), Call(x_3; t), t); =), Chain(Call(x_3'; t), Call(g_3; Call(x_1; t), Call(x_2; t), Call(x_3; t), t); =))",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "M_e = L - \\varpi + b T^2 + c\\cos\\left(f T\\right) + s\\sin\\left(f T\\right)",
        "Chain(M_e, Add(L, Neg(\\varpi), Mul(b, Pow(T; 2)), Mul(c, Call(cos; Mul(f, T))), Mul(s, Call(sin; Mul(f, T)))); =)",
        "bryanwweber/orbital-mechanics-notes/reference/planetary-ephemeris.md",
    ),
    (
        "\\begin{cases} N_r = \\lambda \\dfrac{\\partial}{\\partial r}(r-R) = \\lambda \\\\[1.5ex] N_\\theta = \\lambda \\dfrac{\\partial}{\\partial \\theta}(r-R) = 0 \\end{cases}",
        "System(Chain(N_r, Mul(\\lambda, Derivative(Add(r, Neg(R)); r, 1; True)), \\lambda; =, =), Chain(N_\\theta, Mul(\\lambda, Derivative(Add(r, Neg(R)); \\theta, 1; True)), 0; =, =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "& C = \\begin{bmatrix} 1 & 0 & 0 & 0\\\\0 & 0 & 1 & 0 \\end{bmatrix}\\\\ & D = \\begin{bmatrix} 0 \\\\ 0 \\end{bmatrix}",
        "System(Chain(C, MatrixOf(1, 0, 0, 0, 0, 0, 1, 0); =), Chain(D, MatrixOf(0, 0); =))",
        "AtsushiSakai/PythonRobotics/docs/modules/10_inverted_pendulum/inverted_pendulum_main.rst",
    ),
    (
        "f^{F_c} = - mg - u.",
        "Chain(f ^ { F _ { c } }, Add(Neg(Mul(m, g)), Neg(u)); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "S_\\mathrm{true} (\\omega) = \\frac{\\lambda\\,A}{2}\\,\\left[ \\exp\\left(-\\frac{\\lambda^2}{2}\\,\\left(\\omega- \\frac{2\\,\\pi}{P_\\mathrm{true}}\\right)^2\\right) + \\exp\\left(-\\frac{\\lambda^2}{2}\\,\\left(\\omega+ \\frac{2\\,\\pi}{P_\\mathrm{true}}\\right)^2\\right) \\right]",
        "Chain(Call(S_{true}; \\omega), Mul(Div(Mul(\\lambda, A); 2), Add(Call(exp; Neg(Mul(Div(Pow(\\lambda; 2); 2), Pow(Add(\\omega, Neg(Div(Mul(2, \\pi); P_{true}))); 2)))), Call(exp; Neg(Mul(Div(Pow(\\lambda; 2); 2), Pow(Add(\\omega, Div(Mul(2, \\pi); P_{true})); 2)))))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\dot{V}({\\bf x}) = {\\bf x}^T {\\bf PA} {\\bf x} + {\\bf x}^T {\\bf A}^T {\\bf P}{\\bf x} \\prec 0.",
        "Chain(Call(\\dot{V}; \\mathbf{x}), Add(Mul(Transpose(\\mathbf{x}), \\mathbf{P}, \\mathbf{A}, \\mathbf{x}), Mul(Transpose(\\mathbf{x}), Transpose(\\mathbf{A}), \\mathbf{P}, \\mathbf{x})), 0; =, \\prec)",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "x''(T)=2a_2+6a_3T+12a_4T^2+20a_5T^3=a_e",
        "Chain(Call(x''; T), Add(Mul(2, a_2), Mul(6, a_3, T), Mul(12, a_4, Pow(T; 2)), Mul(20, a_5, Pow(T; 3))), a_e; =, =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/quintic_polynomials_planner/quintic_polynomials_planner_main.rst",
    ),
    (
        "Y(t) = \\begin{bmatrix} 0 & 1 \\end{bmatrix} \\begin{bmatrix} x_1(t) \\\\ x_2(t) \\end{bmatrix} + \\begin{bmatrix} 0 \\end{bmatrix} v_{in}(t)",
        "Chain(Call(Y; t), Add(Mul(MatrixOf(0, 1), MatrixOf(Call(x_1; t), Call(x_2; t))), Mul(MatrixOf(0), Call(v_{in}; t))); =)",
        "sympy/sympy/doc/src/tutorials/physics/control/electrical_problems.rst",
    ),
    (
        "\\mu = \\begin{bmatrix}\\mu_1\\\\\\mu_2\\\\ \\vdots \\\\\\mu_n\\end{bmatrix}",
        "Chain(\\mu, MatrixOf(\\mu_1, \\mu_2, Dots(), \\mu_n); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_main.rst",
    ),
    (
        "{\\vec{x}}' = P\\vec{x} ,",
        "Chain(\\vec{x}', Mul(P, \\vec{x}); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\sigma = \\frac{P_1 - P_{sat}}{P_1 - P_2}",
        "Chain(\\sigma, Div(Add(P_1, Neg(P_{sat})); Add(P_1, Neg(P_2))); =)",
        "CalebBell/fluids/fluids/control_valve.py",
    ),
    (
        "v[n+1] = v[n] + \\frac{h}{m}(u + f^+ - f^-).",
        "Chain(Indexed(v; Add(n, 1)), Add(Indexed(v; n), Mul(Div(h; m), Add(u, f ^ { + }, Neg(f ^ { - })))); =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "\\bm{r}''_{Tc/B}\\cdot\\bm{\\hat{k}}_3 = -\\frac{\\pi\\,R_{\\text{tank}}^4\\,\\rho_{\\text{fuel}}}{4} \\left(\\frac{\\ddot{q}}{m_{\\text{fuel}}} -\\frac{2\\dot{q}\\dot{m}_{\\text{fuel}}}{m_{\\text{fuel}}^2} -\\frac{q\\ddot{m}_{\\text{fuel}}}{m_{\\text{fuel}}^2} +\\frac{2q\\dot{m}_{\\text{fuel}}^2}{m_{\\text{fuel}}^3}\\right).",
        "Chain(Mul(\\bm{r}_{Tc/B}'', \\bm{\\hat{k}}_3; 1), Neg(Mul(Div(Mul(\\pi, Pow(R_{tank}; 4), \\rho_{fuel}); 4), Add(Div(Call(\\ddot{q}); Call(m_{fuel})), Neg(Div(Mul(2, Call(\\dot{q}), Call(\\dot{m}_{fuel})); Pow(Call(m_{fuel}); 2))), Neg(Div(Mul(Call(q), Call(\\ddot{m}_{fuel})); Pow(Call(m_{fuel}); 2))), Div(Mul(2, Call(q), Pow(Call(\\dot{m}_{fuel}); 2)); Pow(Call(m_{fuel}); 3))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "\\frac{d}{dt} \\left(e^{at} \\right) = 0 + a + a^2 t + \\frac{a^3t^2}{2} + \\frac{a^4t^3}{6} + \\cdots = a \\left( 1 + a t + \\frac{{(at)}^2}{2} + \\frac{{(at)}^3}{6} + \\cdots \\right) = a e^{at}.",
        "Chain(Derivative(Pow(e; Mul(a, t)); t, 1), Add(0, a, Mul(Pow(a; 2), t), Div(Mul(Pow(a; 3), Pow(t; 2)); 2), Div(Mul(Pow(a; 4), Pow(t; 3)); 6), Dots()), Mul(a, Add(1, Mul(a, t), Div(Pow(Mul(a, t); 2); 2), Div(Pow(Mul(a, t); 3); 6), Dots())), Mul(a, Pow(e; Mul(a, t))); =, =, =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "r_{a} = \\frac{p}{1 - e}",
        "Chain(r_a, Div(p; Add(1, Neg(e))); =)",
        "AVSLab/basilisk/src/architecture/utilitiesSelfCheck/_Documentation/secModelDescription.tex",
    ),
    (
        "V = \\frac{GM}{E}\\arctan\\Big(\\frac{E}{u}\\Big) + \\frac{1}{2}\\omega^2a^2\\frac{q}{q_0}\\Big(\\sin^2\\beta-\\frac{1}{3}\\Big)",
        "Chain(V, Add(Mul(Div(Mul(G, M); E), Call(arctan; Div(E; u))), Mul(Div(1; 2), Pow(\\omega; 2), Pow(a; 2), Div(q; q_0), Add(Pow(Call(sin; \\beta); 2), Neg(Div(1; 3))))); =)",
        "Mayitzin/ahrs/ahrs/utils/wgs84.py",
    ),
    (
        "\\tau = \\sqrt{\\frac{(I_3-I_2)(L^2-2I_1T)}{I_1I_2I_3}}t,\\quad s = \\sqrt{\\frac{I_2(I_3-I_2)}{2I_3T-L^2}}\\omega_2",
        "System(Chain(\\tau, Mul(Sqrt(Div(Mul(Add(I_3, Neg(I_2)), Add(Pow(L; 2), Neg(Mul(2, I_1, T)))); Mul(I_1, I_2, I_3))), t); =), Chain(s, Mul(Sqrt(Div(Mul(I_2, Add(I_3, Neg(I_2))); Add(Mul(2, I_3, T), Neg(Pow(L; 2))))), \\omega_2); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "\\mathbf{K} = \\begin{bmatrix} \\mathbf{S} - \\boldsymbol{\\sigma}\\mathbf{I}_3 & \\mathbf{z} \\\\ \\mathbf{z}^T & \\boldsymbol{\\sigma} \\end{bmatrix}",
        "Chain(\\mathbf{K}, MatrixOf(Add(\\mathbf{S}, Neg(Mul(\\boldsymbol{\\sigma}, \\mathbf{I}_3))), \\mathbf{z}, Transpose(\\mathbf{z}), \\boldsymbol{\\sigma}); =)",
        "Mayitzin/ahrs/ahrs/common/orientation.py",
    ),
    (
        "\\textbf{x}_{t+1} = f(\\textbf{x}_t, \\textbf{u}_t) = F\\textbf{x}_t+B\\textbf{u}_t",
        "Chain(\\mathbf{x}_{t+1}, Call(f; \\mathbf{x}_t, \\mathbf{u}_t), Add(Mul(F, \\mathbf{x}_t), Mul(B, \\mathbf{u}_t)); =, =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/extended_kalman_filter_localization_files/extended_kalman_filter_localization_main.rst",
    ),
    (
        "\\ddot{q} + \\mu (q^2 - 1) \\dot{q} + q = 0, \\quad \\mu>0,",
        "System(Chain(Add(Call(\\ddot{q}), Mul(\\mu, Add(Pow(Call(q); 2), Neg(1)), Call(\\dot{q})), Call(q)), 0; =), Chain(\\mu, 0; >))",
        "RussTedrake/underactuated/book/limit_cycles.html",
    ),
    (
        "\\lambda_k = k^2 \\qquad \\text{with an eigenfunction} \\qquad x_k = \\cos (k t) \\qquad \\text{for all integers } k \\geq 1 ,",
        "System(Chain(\\lambda_k, Pow(k; 2); =), Words(\\text{with~an~eigenfunction}), Chain(x_k, Call(cos; Mul(k, t)); =), Words(\\text{for~all~integers}), Chain(k, 1; \\ge))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\mathrm{i}^2=\\mathrm{j}^2=\\mathrm{k}^2=\\mathrm{i}\\mathrm{j}\\mathrm{k}=-1",
        "Chain(Pow(\\text{i}; 2), Pow(\\text{j}; 2), Pow(\\text{k}; 2), Mul(\\text{i}, \\text{j}, \\text{k}), Neg(1); =, =, =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "p^G(t) = \\begin{bmatrix} 2\\cos(1-t) \\\\ 0 \\end{bmatrix}.",
        "Chain(Call(p ^ { G }; t), MatrixOf(Mul(2, Call(cos; Add(1, Neg(t)))), 0); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\frac{r_3}{r_1} < 11.94",
        "Chain(Div(r_3; r_1), 11.94; <)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/bielliptic-hohmann-transfer.md",
    ),
    (
        "\\boldsymbol{\\eta} = \\begin{bmatrix} \\boldsymbol{\\Omega} \\\\ \\boldsymbol{\\gamma} \\end{bmatrix}",
        "Chain(\\boldsymbol{\\eta}, MatrixOf(\\boldsymbol{\\Omega}, \\boldsymbol{\\gamma}); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/vscmgVelocitySteering/vscmgVelocitySteering.rst",
    ),
    (
        "P = A^T P A - A^T P B ( R + B^T P B )^{-1} B^T P A + Q",
        "Chain(P, Add(Mul(Transpose(A), P, A), Neg(Mul(Transpose(A), P, B, Pow(Add(R, Mul(Transpose(B), P, B)); Neg(1)), Transpose(B), P, A)), Q); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/10_inverted_pendulum/inverted_pendulum_main.rst",
    ),
    (
        "\\tilde{v}_r = & \\bar{v}_r + \\left[\\bar{v}_{p+1} \\ldots \\bar{v}_{n}\\right] \\mathbf{A}_n \\hat{e}_r \\\\ \\tilde{\\omega}_r = & \\bar{\\omega}_r + \\left[\\bar{\\omega}_{p+1} \\ldots \\bar{\\omega}_{n}\\right] \\mathbf{A}_n \\hat{e}_r \\quad \\textrm{for } r=1\\ldots p",
        "System(Chain(\\tilde{v}_r, Add(\\bar{v}_r, Mul(Tuple(\\bar{v}_{p+1}, Dots(), \\bar{v}_n; []), \\mathbf{A}_n, \\hat{e}_r)); =), Chain(\\tilde{\\omega}_r, Add(\\bar{\\omega}_r, Mul(Tuple(\\bar{\\omega}_{p+1}, Dots(), \\bar{\\omega}_n; []), \\mathbf{A}_n, \\hat{e}_r)); =), Values(r; 1, Dots(), p))",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "A = P * J * P^{-1}",
        "Chain(A, Operated(*; Operated(*; P; J); Pow(P; Neg(1))); =)",
        "sympy/sympy/sympy/solvers/ode/systems.py",
    ),
    (
        "\\begin{bmatrix} \\psi_1(0) & \\psi_2(0) & \\dots & \\psi_N(0) \\\\ \\dot \\psi_1(0) & \\dot \\psi_2(0) & \\dots & \\dot \\psi_N(0) \\\\ \\vdots & \\vdots & & \\vdots \\\\ \\psi^{(q)}_1(0) & \\psi^{(q)}_2(0) & \\dots & \\psi^{(q)}_N(0) \\\\[1ex] \\psi_1(T) & \\psi_2(T) & \\dots & \\psi_N(T) \\\\ \\dot \\psi_1(T) & \\dot \\psi_2(T) & \\dots & \\dot \\psi_N(T) \\\\ \\vdots & \\vdots & & \\vdots \\\\ \\psi^{(q)}_1(T) & \\psi^{(q)}_2(T) & \\dots & \\psi^{(q)}_N(T) \\\\ \\end{bmatrix} \\begin{bmatrix} c_1 \\\\ \\vdots \\\\ c_N \\end{bmatrix} = \\begin{bmatrix} z(0) \\\\ \\dot z(0) \\\\ \\vdots \\\\ z^{(q)}(0) \\\\[1ex] z(T) \\\\ \\dot z(T) \\\\ \\vdots \\\\ z^{(q)}(T) \\\\ \\end{bmatrix}",
        "Chain(Mul(MatrixOf(Call(\\psi_1; 0), Call(\\psi_2; 0), Dots(), Call(\\psi_N; 0), Call(\\dot{\\psi}_1; 0), Call(\\dot{\\psi}_2; 0), Dots(), Call(\\dot{\\psi}_N; 0), Dots(), Dots(), Blank(), Dots(), Call(\\psi _ { 1 } ^ { ( q ) }; 0), Call(\\psi _ { 2 } ^ { ( q ) }; 0), Dots(), Call(\\psi _ { N } ^ { ( q ) }; 0), Call(\\psi_1; T), Call(\\psi_2; T), Dots(), Call(\\psi_N; T), Call(\\dot{\\psi}_1; T), Call(\\dot{\\psi}_2; T), Dots(), Call(\\dot{\\psi}_N; T), Dots(), Dots(), Blank(), Dots(), Call(\\psi _ { 1 } ^ { ( q ) }; T), Call(\\psi _ { 2 } ^ { ( q ) }; T), Dots(), Call(\\psi _ { N } ^ { ( q ) }; T)), MatrixOf(c_1, Dots(), c_N)), MatrixOf(Call(z; 0), Call(\\dot{z}; 0), Dots(), Call(z ^ { ( q ) }; 0), Call(z; T), Call(\\dot{z}; T), Dots(), Call(z ^ { ( q ) }; T)); =)",
        "python-control/python-control/doc/flatsys.rst",
    ),
    (
        "\\text{cooling degree days} = max(T_{base} - T, 0)",
        "Chain(\\text{cooling~degree~days}, Call(max; Add(T_{base}, Neg(T)), 0); =)",
        "CalebBell/fluids/fluids/design_climate.py",
    ),
    (
        "B_{j\\alpha}(\\boldsymbol{q},t) = \\sum_{i=1}^n \\boldsymbol{A}_{ji}\\cdot \\frac{\\partial \\boldsymbol{r}_i}{\\partial q_\\alpha},\\quad B_{j0}(\\boldsymbol{q},t) = \\sum_{i=1}^n \\boldsymbol{A}_{ji}\\cdot \\frac{\\partial \\boldsymbol{r}_i}{\\partial t}+A_{j0}",
        "System(Chain(Call(B_{j\\alpha}; \\boldsymbol{q}, t), BigSum(i; 1; n; Mul(\\boldsymbol{A}_{ji}, Derivative(Call(\\boldsymbol{r}_i); q_\\alpha, 1; True))); =), Chain(Call(B_{j0}; \\boldsymbol{q}, t), Add(BigSum(i; 1; n; Mul(\\boldsymbol{A}_{ji}, Derivative(Call(\\boldsymbol{r}_i); t, 1; True))), A_{j0}); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/analytical-mechanics/Constraint.tex",
    ),
    (
        "\\psi_i(x(T)) = 0, \\qquad i = 1, \\dots, q.",
        "System(Chain(Call(\\psi_i; Call(x; T)), 0; =), Values(i; 1, Dots(), q))",
        "python-control/python-control/doc/optimal.rst",
    ),
    (
        "P(x) = \\frac{M_y-N_x}{N} = \\frac{2y}{x+1} \\, \\frac{1}{2y} = \\frac{1}{x+1}",
        "Chain(Call(P; x), Div(Add(M_y, Neg(N_x)); N), Mul(Div(Mul(2, y); Add(x, 1)), Div(1; Mul(2, y))), Div(1; Add(x, 1)); =, =, =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "T_{syn} = \\frac{T_i T_f}{\\lvert T_i - T_f\\rvert}",
        "Chain(T_{syn}, Div(Mul(T_i, T_f); Bars(Add(T_i, Neg(T_f)))); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/interplanetary-transfer-phasing.md",
    ),
    (
        "{\\bf x}[1] &= {\\bf A}{\\bf x}_0 + {\\bf B}\\tilde{\\bf K}_0{\\bf x}_0, \\\\ {\\bf x}[2] &= {\\bf A}({\\bf A} + {\\bf B}\\tilde{\\bf K}_0){\\bf x}_0 + {\\bf B}\\tilde{\\bf K}_1 {\\bf x}_0 \\\\ {\\bf x}[n] &= \\left( {\\bf A}^n + \\sum_{i=0}^{n-1}{\\bf A}^{n-i-1}{\\bf B}\\tilde{\\bf K}_{i} \\right) {\\bf x}_0",
        "System(Chain(Indexed(\\mathbf{x}; 1), Add(Mul(\\mathbf{A}, \\mathbf{x}_0), Mul(\\mathbf{B}, \\tilde{\\mathbf{K}}_0, \\mathbf{x}_0)); =), Chain(Indexed(\\mathbf{x}; 2), Add(Mul(\\mathbf{A}, Add(\\mathbf{A}, Mul(\\mathbf{B}, \\tilde{\\mathbf{K}}_0)), \\mathbf{x}_0), Mul(\\mathbf{B}, \\tilde{\\mathbf{K}}_1, \\mathbf{x}_0)); =), Chain(Indexed(\\mathbf{x}; n), Mul(Add(Pow(\\mathbf{A}; n), BigSum(i; 0; Add(n, Neg(1)); Mul(Pow(\\mathbf{A}; Add(n, Neg(i), Neg(1))), \\mathbf{B}, \\tilde{\\mathbf{K}}_i))), \\mathbf{x}_0); =))",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "F^{B_p}_{\\text{total},C} = \\sum_i F^{B_p}_{i,C} .",
        "Chain(F _ { \\text { t o t a l } , C } ^ { B _ { p } }, BigSum(i; F _ { i , C } ^ { B _ { p } }); =)",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "\\dot{\\boldsymbol{y}} = f\\left(t, \\boldsymbol{y}\\right)",
        "Chain(Call(\\dot{\\boldsymbol{y}}), Call(f; t, Call(\\boldsymbol{y})); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-inertial-numerical-solution.md",
    ),
    (
        "v_p = \\frac{h}{r_p} = \\frac{v_{\\infty}y}{r_p}",
        "Chain(v_p, Div(h; r_p), Div(Mul(v_\\infty, y); r_p); =, =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-arrival-capture.md",
    ),
    (
        "f_{n,j} &=& \\phi_{n,j}\\,\\left[f_{n-1,j} + \\tilde{W}_{n-1,j}\\,z_{n-1}^\\prime\\right] \\\\ z_n^\\prime &=& y_n - \\sum_{j=1}^{2\\,J} \\tilde{U}_{n,j}\\,f_{n,j}",
        "System(Chain(f_{n,j}, Mul(\\phi_{n,j}, Add(f_{n-1,j}, Mul(\\tilde{W}_{n-1,j}, z_{n-1}'))); =), Chain(z_n', Add(y_n, Neg(BigSum(j; 1; Mul(2, J); Mul(\\tilde{U}_{n,j}, f_{n,j})))); =))",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "{}^AV^{B_A} = \\begin{bmatrix} {}^A\\omega^{B_A} \\\\ {}^A\\text{v}^{B_A} \\end{bmatrix} = \\begin{bmatrix} {}^A\\omega^{B_A} + {}^{B_A}\\omega^B_{A} \\\\ {}^A\\text{v}^B + {}^B\\text{v}^{B_A}_A + {}^A\\omega^B \\times {}^Bp^{B_A}_A \\end{bmatrix} = \\begin{bmatrix} {}^A \\omega^{B} \\\\ {}^A\\text{v}^B - {}^A\\omega^B \\times {}^Ap^{B} \\end{bmatrix}.",
        "Chain(\\prescript { A } { } { V } ^ { B _ { A } }, MatrixOf(\\prescript { A } { } { \\omega } ^ { B _ { A } }, \\prescript { A } { } { \\text { v } } ^ { B _ { A } }), MatrixOf(Add(\\prescript { A } { } { \\omega } ^ { B _ { A } }, \\prescript { B _ { A } } { } { \\omega } _ { A } ^ { B }), Add(\\prescript { A } { } { \\text { v } } ^ { B }, \\prescript { B } { } { \\text { v } } _ { A } ^ { B _ { A } }, Cross(\\prescript { A } { } { \\omega } ^ { B }; \\prescript { B } { } { p } _ { A } ^ { B _ { A } }))), MatrixOf(\\prescript { A } { } { \\omega } ^ { B }, Add(\\prescript { A } { } { \\text { v } } ^ { B }, Neg(Cross(\\prescript { A } { } { \\omega } ^ { B }; \\prescript { A } { } { p } ^ { B })))); =, =, =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "{}^B\\mathbf{C}^A = \\begin{bmatrix} \\frac{\\sqrt{2}}{4} & \\frac{\\sqrt{2}}{2} & \\frac{\\sqrt{6}}{4} \\\\ -\\frac{\\sqrt{3}}{2} & 0 & \\frac{1}{2} \\\\ \\frac{\\sqrt{2}}{4} & - \\frac{\\sqrt{2}}{2} & \\frac{\\sqrt{6}}{4} \\end{bmatrix}",
        "Chain(\\prescript { B } { } { \\mathbf { C } } ^ { A }, MatrixOf(Div(Sqrt(2); 4), Div(Sqrt(2); 2), Div(Sqrt(6); 4), Neg(Div(Sqrt(3); 2)), 0, Div(1; 2), Div(Sqrt(2); 4), Neg(Div(Sqrt(2); 2)), Div(Sqrt(6); 4)); =)",
        "moorepants/learn-multibody-dynamics/angular.rst",
    ),
    (
        "\\mathcal{A}(s) = (-i)^{s+1} \\operatorname{Li}_{-s}(i) + i^{s+1} \\operatorname{Li}_{-s}(-i) = \\\\ \\frac{2 \\Gamma(s+1)}{(2\\pi)^{s+1}} (\\zeta(s+1, 1/4) - \\zeta(s+1, 3/4) \\cos{\\pi s})",
        "Chain(Call(\\mathcal{A}; s), Add(Mul(Pow(Neg(i); Add(s, 1)), Call(\\text{Li}_{-s}; i)), Mul(Pow(i; Add(s, 1)), Call(\\text{Li}_{-s}; Neg(i)))), Mul(Div(Mul(2, Call(Gamma; Add(s, 1))); Pow(Mul(2, \\pi); Add(s, 1))), Add(Call(\\zeta; Add(s, 1), Div(1; 4)), Neg(Mul(Call(\\zeta; Add(s, 1), Div(3; 4)), Call(cos; Mul(\\pi, s)))))); =, =)",
        "sympy/sympy/sympy/functions/combinatorial/numbers.py",
    ),
    (
        "\\Delta \\boldsymbol{p}_1 = \\Delta M_1\\boldsymbol{u}_1,\\quad \\Delta \\boldsymbol{p}_2 = \\Delta M_2\\boldsymbol{u}_2",
        "System(Chain(\\Delta \\boldsymbol { p } _ { 1 }, Mul(\\Delta M _ { 1 }, \\boldsymbol{u}_1); =), Chain(\\Delta \\boldsymbol { p } _ { 2 }, Mul(\\Delta M _ { 2 }, \\boldsymbol{u}_2); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "\\mathbf{q}_t = \\mathbf{q}_{t-1} + \\dot{\\hat{\\mathbf{q}}}\\Delta_t",
        "Chain(\\mathbf{q}_t, Add(\\mathbf{q}_{t-1}, Mul(Call(\\dot{\\hat{\\mathbf{q}}}), \\Delta_t)); =)",
        "Mayitzin/ahrs/ahrs/filters/fourati.py",
    ),
    (
        "C(z) = \\begin{cases}\\displaystyle \\frac{1 - \\cos\\sqrt{z}}{z} & \\left(z > 0\\right)\\\\ \\displaystyle\\frac{\\cosh\\sqrt{-z} - 1}{-z} & \\left(z < 0\\right) \\\\ \\displaystyle\\frac{1}{2} & \\left(z = 0\\right)\\end{cases}",
        "Chain(Call(C; z), Piecewise(Div(Add(1, Neg(Call(cos; Sqrt(z)))); z), Chain(z, 0; >), Div(Add(Call(cosh; Sqrt(Neg(z))), Neg(1)); Neg(z)), Chain(z, 0; <), Div(1; 2), Chain(z, 0; =)); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables-example.md",
    ),
    (
        "X'' = A(t) * (t*X' - X) + b(t)",
        "Chain(X'', Add(Operated(*; Call(A; t); Add(Operated(*; t; X'), Neg(X))), Call(b; t)); =)",
        "sympy/sympy/sympy/solvers/ode/systems.py",
    ),
    (
        "\\bar{r}^{P_1/O}\\cdot\\hat{n}_z = 0 \\\\ \\bar{r}^{P_2/O}\\cdot\\hat{n}_z = 0 \\\\ \\bar{r}^{P_3/O}\\cdot\\hat{n}_z = 0 \\\\ \\bar{r}^{P_4/O}\\cdot\\hat{n}_z = 0",
        "System(Chain(Mul(\\bar { r } ^ { P _ { 1 } / O }, \\hat{n}_z; 1), 0; =), Chain(Mul(\\bar { r } ^ { P _ { 2 } / O }, \\hat{n}_z; 1), 0; =), Chain(Mul(\\bar { r } ^ { P _ { 3 } / O }, \\hat{n}_z; 1), 0; =), Chain(Mul(\\bar { r } ^ { P _ { 4 } / O }, \\hat{n}_z; 1), 0; =))",
        "moorepants/learn-multibody-dynamics/configuration.rst",
    ),
    (
        "\\mathbf{q}_\\mathrm{acc} = \\begin{bmatrix}\\sqrt{\\frac{a_z+1}{2}} & -\\frac{a_y}{\\sqrt{2(a_z+1)}} & \\frac{a_x}{\\sqrt{2(a_z+1)}} & 0\\end{bmatrix}^T",
        "Chain(\\mathbf{q}_{acc}, Transpose(MatrixOf(Sqrt(Div(Add(a_z, 1); 2)), Neg(Div(a_y; Sqrt(Mul(2, Add(a_z, 1))))), Div(a_x; Sqrt(Mul(2, Add(a_z, 1)))), 0)); =)",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "G(u_*) = \\frac{1}{54}\\left[(\\beta^2+12)^{\\frac32}+36\\beta-\\beta^3\\right]-\\alpha^2 =: f(\\beta)-\\alpha^2",
        "Chain(Call(G; u_*), Add(Mul(Div(1; 54), Add(Pow(Add(Pow(\\beta; 2), 12); Div(3; 2)), Mul(36, \\beta), Neg(Pow(\\beta; 3)))), Neg(Pow(\\alpha; 2))), Add(Call(f; \\beta), Neg(Pow(\\alpha; 2))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "\\bar{f}_n(u_1, u_2, u_3, q_3, q_4, q_5) = 0 \\textrm{ where } \\bar{f}_n \\in \\mathbb{R}^2",
        "System(Chain(Call(\\bar{f}_n; u_1, u_2, u_3, q_3, q_4, q_5), 0; =), Chain(Call(\\bar{f}_n), Pow(\\mathbb{R}; 2); \\in))",
        "moorepants/learn-multibody-dynamics/motion.rst",
    ),
    (
        "m_{\\text{sc}} \\left[\\tilde{\\bm{c}}\\right]\\ddot{\\bm{r}}_{B/N} + \\left[I_{\\text{sc, }B}\\right]\\,\\dot{\\bm{\\omega}}_{\\cal{B}/\\cal{N}} = - \\left[\\tilde{\\bm{\\omega}}_{\\cal{B}/\\cal{N}}\\right]\\left[I_{\\text{sc, }B}\\right]\\,\\bm{\\omega}_{\\cal{B}/\\cal{N}} + \\bm{L}_{B} + \\sum_{j=1}^{N}\\bm{L}_{B_{\\text{thr}_j}}",
        "Chain(Add(Mul(m_{sc}, [ \\tilde { \\bm { c } } ], Call(\\ddot{\\bm{r}}_{B/N})), Mul([ I _ { \\text { s c , } B } ], Call(\\dot { \\bm { \\omega } } _ { \\cal B / \\cal N }))), Add(Neg(Mul([ \\tilde { \\bm { \\omega } } _ { \\cal B / \\cal N } ], [ I _ { \\text { s c , } B } ], Call(\\bm{\\omega}_{\\cal B/\\cal N}))), \\bm{L}_B, BigSum(j; 1; N; \\bm{L}_{B_thr_j})); =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "\\ddot{\\bm r}_{B/N} - [\\tilde{\\bm{c}}]\\dot{\\bm \\omega} + \\frac{1}{m_{\\text{sc}}} \\sum\\limits_{i=1}^{N}\\bm{u}_{r_i}\\ddot{\\gamma}_i + \\frac{1}{m_{\\text{sc}}} \\sum\\limits_{i=1}^{N}\\bm{v}_{r_i}\\dot{\\Omega}_i = \\ddot{\\bm r}_{C/N} - 2[\\tilde{\\bm{\\omega}}]\\bm{c}' - [\\tilde{\\bm{\\omega}}]^2\\bm{c} - \\frac{1}{m_{\\text{sc}}} \\sum\\limits_{i=1}^{N}\\bm{k}_{r_i}",
        "Chain(Add(Call(\\ddot{\\bm{r}}_{B/N}), Neg(Mul([ \\tilde { \\bm { c } } ], Call(\\dot{\\bm{\\omega}}))), Mul(Div(1; m_{sc}), BigSum(i; 1; N; Mul(\\bm{u}_{r_i}, Call(\\ddot{\\gamma}_i)))), Mul(Div(1; m_{sc}), BigSum(i; 1; N; Mul(\\bm{v}_{r_i}, Call(\\dot{\\Omega}_i))))), Add(Call(\\ddot{\\bm{r}}_{C/N}), Neg(Mul(2, [ \\tilde { \\bm { \\omega } } ], \\bm{c}')), Neg(Mul(Pow([ \\tilde { \\bm { \\omega } } ]; 2), \\bm{c})), Neg(Mul(Div(1; m_{sc}), BigSum(i; 1; N; \\bm{k}_{r_i})))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/VSCMGs/_Documentation/secModelDescription.tex",
    ),
    (
        "\\boldsymbol{M} = \\prod_{i=1}^\\infty \\boldsymbol{M}_i(\\varepsilon_i,G_i),\\quad \\varepsilon_i \\to 0",
        "System(Chain(\\boldsymbol{M}, BigProduct(i; 1; Infinity(); Call(\\boldsymbol{M}_i; \\varepsilon_i, G_i)); =), Chain(\\varepsilon_i, 0; \\to))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\rho = \\sqrt{(x_{robot} - x_{target})^2 + (y_{robot} - y_{target})^2}.",
        "Chain(\\rho, Sqrt(Add(Pow(Add(x_{robot}, Neg(x_{target})); 2), Pow(Add(y_{robot}, Neg(y_{target})); 2))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/move_to_a_pose/move_to_a_pose_main.rst",
    ),
    (
        "B = \\frac{520}{\\Gamma G_{tp}^{0.5}}",
        "Chain(B, Div(520; Mul(\\varGamma, Pow(G_{tp}; 0.5))); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "\\dot{e}_t = V \\sin(\\theta_{t-1})",
        "Chain(Call(\\dot{e}_t), Mul(V, Call(sin; \\theta_{t-1})); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/lqr_speed_and_steering_control/lqr_speed_and_steering_control_main.rst",
    ),
    (
        "\\vec{x}_p = X(t)\\, \\vec{u}(t) ,",
        "Chain(\\vec{x}_p, Mul(Call(X; t), Call(\\vec{u}; t)); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "b_i^{\\text{new}} = b_i^{\\text{old}} + \\alpha (f_c + f_r),",
        "Chain(b _ { i } ^ { \\text { n e w } }, Add(b _ { i } ^ { \\text { o l d } }, Mul(\\alpha, Add(f_c, f_r))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/elastic_bands/elastic_bands_main.rst",
    ),
    (
        "T = \\frac{1}{\\sqrt{2g}} \\int_a^b \\sqrt{\\frac{1+y'^2}{y}} \\mathrm{d} x",
        "Chain(T, Mul(Div(1; Sqrt(Mul(2, g))), Integral(Sqrt(Div(Add(1, Pow(y'; 2)); y)); x; a; b)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter9.tex",
    ),
    (
        "\\boldsymbol{u} = \\big[ \\, \\delta_\\mathrm{T}, \\, \\delta_\\mathrm{a}, \\, \\delta_\\mathrm{e}, \\, \\delta_\\mathrm{r} \\,\\big]",
        "Chain(\\boldsymbol{u}, Tuple(\\delta_T, \\delta_a, \\delta_e, \\delta_r; []); =)",
        "JSBSim-Team/jsbsim-reference-manual/docs/user/concepts/flight-control-and-systems-modeling.md",
    ),
    (
        "\\bar{u} = \\mathbf{I} \\dot{\\bar{q}}",
        "Chain(\\bar{u}, Mul(\\mathbf{I}, Call(\\dot{\\bar{q}})); =)",
        "moorepants/learn-multibody-dynamics/motion.rst",
    ),
    (
        "\\bm\\omega_{R_{0}/N} = \\dot f \\hat{\\bm\\imath}_{h}",
        "Chain(\\bm{\\omega}_{R_0/N}, Mul(Call(\\dot{f}), \\hat{\\bm{\\imath}}_h); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/hillPoint/_Documentation/hillPoint.tex",
    ),
    (
        "\\mathbf{p}(\\tau) = \\frac{\\sin\\!\\bigl((1-\\tau)\\,\\theta\\bigr)}{\\sin\\theta}\\,\\mathbf{p}_s + \\frac{\\sin(\\tau\\,\\theta)}{\\sin\\theta}\\,\\mathbf{p}_e",
        "Chain(Call(\\mathbf{p}; \\tau), Add(Mul(Div(Call(sin; Mul(Add(1, Neg(\\tau)), \\theta)); Call(sin; \\theta)), \\mathbf{p}_s), Mul(Div(Call(sin; Mul(\\tau, \\theta)); Call(sin; \\theta)), \\mathbf{p}_e)); =)",
        "AVSLab/basilisk/src/simulation/environment/stripLocation/stripLocation.rst",
    ),
    (
        "\\begin{bmatrix}\\cos\\psi \\\\ \\sin\\psi \\end{bmatrix} = \\begin{bmatrix}M_x & M_y \\\\ -My & M_x \\end{bmatrix} \\begin{bmatrix}N_x \\\\ N_y \\end{bmatrix}",
        "Chain(MatrixOf(Call(cos; \\psi), Call(sin; \\psi)), Mul(MatrixOf(M_x, M_y, Neg(Mul(M, y)), M_x), MatrixOf(N_x, N_y)); =)",
        "Mayitzin/ahrs/ahrs/filters/fqa.py",
    ),
    (
        "G_{2k}(\\tau) = \\sum_{m^2 + n^2 \\ne 0} \\frac{1}{(m+n\\tau )^{2k}}",
        "Chain(Call(G_{2k}; \\tau), Limiting(sum; _{ m ^ { 2 } + n ^ { 2 } \\ne 0 }; Div(1; Pow(Add(m, Mul(n, \\tau)); Mul(2, k)))); =)",
        "fredrik-johansson/arb/doc/source/acb_modular.rst",
    ),
    (
        "\\mathbf{q} = \\begin{bmatrix}\\cos\\theta \\\\ \\mathbf{v}\\sin\\theta\\end{bmatrix}",
        "Chain(\\mathbf{q}, MatrixOf(Call(cos; \\theta), Mul(\\mathbf{v}, Call(sin; \\theta))); =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "\\bm{r}_{S_{c,{i1}}/B} = \\bm{r}_{H_{i1}/B} -d_{i1} \\bm{\\hat{s}}_{i1,1}",
        "Chain(\\bm{r}_{S_c,i1/B}, Add(\\bm{r}_{H_i1/B}, Neg(Mul(d_{i1}, \\bm{\\hat{s}}_{i1,1}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "A = \\begin{pmatrix} 1 \\\\ 0 \\\\ 0 \\end{pmatrix}, \\qquad L = \\begin{pmatrix} 0 \\\\ 1 \\\\ 0 \\end{pmatrix}, \\qquad V = \\begin{pmatrix} 0 \\\\ 0 \\\\ 1 \\end{pmatrix},",
        "System(Chain(A, MatrixOf(1, 0, 0); =), Chain(L, MatrixOf(0, 1, 0); =), Chain(V, MatrixOf(0, 0, 1); =))",
        "sympy/sympy/doc/src/modules/physics/units/philosophy.rst",
    ),
    (
        "c_k(z) = \\frac{1}{k!} - \\frac{z}{\\left(k + 2\\right)!} + \\frac{z^2}{\\left(k + 4\\right)!} - \\cdots = \\sum_{i=0}^{\\infty}\\frac{\\left(-1\\right)^{i} z^i}{\\left(k + 2i\\right)!}",
        "Chain(Call(c_k; z), Add(Div(1; Factorial(k)), Neg(Div(z; Factorial(Add(k, 2)))), Div(Pow(z; 2); Factorial(Add(k, 4))), Neg(Dots())), BigSum(i; 0; Infinity(); Div(Mul(Pow(Neg(1); i), Pow(z; i)); Factorial(Add(k, Mul(2, i))))); =, =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables.md",
    ),
    (
        "{\\bf x}(0) = - \\int_0^{t_f} e^{-{\\bf A}\\tau}{\\bf B} {\\bf u}(\\tau) d\\tau.",
        "Chain(Call(\\mathbf{x}; 0), Neg(Integral(Mul(Pow(e; Neg(Mul(\\mathbf{A}, \\tau))), \\mathbf{B}, Call(\\mathbf{u}; \\tau)); \\tau; 0; t_f)); =)",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "p_w(w) = \\frac{1}{\\sqrt{2 \\pi \\sigma_w^2}} e^{-\\frac{(w-\\mu)^2}{2\\sigma_w^2}}.",
        "Chain(Call(p_w; w), Mul(Div(1; Sqrt(Mul(2, \\pi, Pow(\\sigma_w; 2)))), Pow(e; Neg(Div(Pow(Add(w, Neg(\\mu)); 2); Mul(2, Pow(\\sigma_w; 2)))))); =)",
        "RussTedrake/underactuated/book/stochastic.html",
    ),
    (
        "\\phi_{lo}^2 = (1-x)^2 + 2.87x^2\\left(\\frac{P}{P_c}\\right)^{-1} + 1.68x^{0.8}(1-x)^{0.25}\\left(\\frac{P}{P_c}\\right)^{-1.64}",
        "Chain(Pow(\\phi_{lo}; 2), Add(Pow(Add(1, Neg(x)); 2), Mul(2.87, Pow(x; 2), Pow(Div(P; P_c); Neg(1))), Mul(1.68, Pow(x; 0.8), Pow(Add(1, Neg(x)); 0.25), Pow(Div(P; P_c); Neg(1.64)))); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "g x'' - (fg + gp + g') x' + (fgp - g^{2} h + f g' - f' g) x = 0",
        "Chain(Add(Mul(g, x''), Neg(Mul(Add(Mul(f, g), Mul(g, p), g'), x')), Mul(Add(Mul(f, g, p), Neg(Mul(Pow(g; 2), h)), Mul(f, g'), Neg(Mul(f', g))), x)), 0; =)",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "\\dot{\\Phi}(k+1,k) = A_{k+1}\\Phi(k+1,k)",
        "Chain(Call(\\dot{\\Phi}; Add(k, 1), k), Mul(A_{k+1}, Call(\\Phi; Add(k, 1), k)); =)",
        "AVSLab/basilisk/src/fswAlgorithms/smallBodyNavigation/smallBodyNavEKF/smallBodyNavEKF.rst",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{x}' &=& \\mathbf{C}(\\hat{\\mathbf{q}})\\mathbf{x} \\\\ &=& \\begin{bmatrix} \\hat{q}_w^2 + \\hat{q}_x^2 - \\hat{q}_y^2 - \\hat{q}_z^2 & 2(\\hat{q}_x\\hat{q}_y-\\hat{q}_w\\hat{q}_z) & 2(\\hat{q}_x\\hat{q}_z+\\hat{q}_w\\hat{q}_y) \\\\ 2(\\hat{q}_x\\hat{q}_y+\\hat{q}_w\\hat{q}_z) & \\hat{q}_w^2 - \\hat{q}_x^2 + \\hat{q}_y^2 - \\hat{q}_z^2 & 2(\\hat{q}_y\\hat{q}_z-\\hat{q}_w\\hat{q}_x) \\\\ 2(\\hat{q}_x\\hat{q}_z-\\hat{q}_w\\hat{q}_y) & 2(\\hat{q}_w\\hat{q}_x+\\hat{q}_y\\hat{q}_z) & \\hat{q}_w^2 - \\hat{q}_x^2 - \\hat{q}_y^2 + \\hat{q}_z^2 \\end{bmatrix} \\begin{bmatrix}x_1 \\\\ x_2 \\\\ x_3 \\end{bmatrix} \\end{array}",
        "Chain(\\mathbf{x}', Mul(Call(\\mathbf{C}; \\hat{\\mathbf{q}}), \\mathbf{x}), Mul(MatrixOf(Add(Pow(\\hat{q}_w; 2), Pow(\\hat{q}_x; 2), Neg(Pow(\\hat{q}_y; 2)), Neg(Pow(\\hat{q}_z; 2))), Mul(2, Add(Mul(\\hat{q}_x, \\hat{q}_y), Neg(Mul(\\hat{q}_w, \\hat{q}_z)))), Mul(2, Add(Mul(\\hat{q}_x, \\hat{q}_z), Mul(\\hat{q}_w, \\hat{q}_y))), Mul(2, Add(Mul(\\hat{q}_x, \\hat{q}_y), Mul(\\hat{q}_w, \\hat{q}_z))), Add(Pow(\\hat{q}_w; 2), Neg(Pow(\\hat{q}_x; 2)), Pow(\\hat{q}_y; 2), Neg(Pow(\\hat{q}_z; 2))), Mul(2, Add(Mul(\\hat{q}_y, \\hat{q}_z), Neg(Mul(\\hat{q}_w, \\hat{q}_x)))), Mul(2, Add(Mul(\\hat{q}_x, \\hat{q}_z), Neg(Mul(\\hat{q}_w, \\hat{q}_y)))), Mul(2, Add(Mul(\\hat{q}_w, \\hat{q}_x), Mul(\\hat{q}_y, \\hat{q}_z))), Add(Pow(\\hat{q}_w; 2), Neg(Pow(\\hat{q}_x; 2)), Neg(Pow(\\hat{q}_y; 2)), Pow(\\hat{q}_z; 2))), MatrixOf(x_1, x_2, x_3)); =, =)",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "\\boldsymbol{v} = v_r\\boldsymbol{\\hat{u}}_r + v_{\\perp}\\boldsymbol{\\hat{u}}_{\\perp}",
        "Chain(\\boldsymbol{v}, Add(Mul(v_r, \\boldsymbol{\\hat{u}}_r), Mul(v_\\perp, \\boldsymbol{\\hat{u}}_\\perp)); =)",
        "bryanwweber/orbital-mechanics-notes/constants-of-orbital-motion/orbital-plane-and-keplers-second-law.md",
    ),
    (
        "\\Delta v = \\lvert v_p - v_{\\text{pahking}}\\rvert",
        "Chain(\\Delta v, Bars(Add(v_p, Neg(v_{pahking}))); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-depahture-trajectory.md",
    ),
    (
        "W = \\int p\\mathrm{d} x = \\sqrt{km} \\int \\sqrt{\\frac{2E}{k}-x^2}\\mathrm{d} x = \\sqrt{km} \\int \\sqrt{\\frac{2J}{\\sqrt{km}}-x^2}\\mathrm{d} x",
        "Chain(W, Antiderivative(p; x), Mul(Sqrt(Mul(k, m)), Antiderivative(Sqrt(Add(Div(Mul(2, E); k), Neg(Pow(x; 2)))); x)), Mul(Sqrt(Mul(k, m)), Antiderivative(Sqrt(Add(Div(Mul(2, J); Sqrt(Mul(k, m))), Neg(Pow(x; 2)))); x)); =, =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\Delta E = v\\Delta v \\cos\\Delta\\phi + \\frac{1}{2}\\Delta v^2",
        "Chain(\\Delta E, Add(Mul(v, \\Delta v, Call(cos; \\Delta \\phi)), Mul(Div(1; 2), Pow(\\Delta v; 2))); =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/non-hohmann-transfers.md",
    ),
    (
        "\\frac{\\Delta P_{tp}}{\\Delta P_{lo}} = \\phi_{tp}^2",
        "Chain(Div(\\Delta P _ { t p }; \\Delta P _ { l o }), Pow(\\phi_{tp}; 2); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "\\big(\\frac{dF}{dx}\\big)_{x_{0}} \\approx \\frac{F_{i+1} - F_{i}}{h} + O(h)",
        "Chain(Marked(Derivative(Call(F); x, 1); _{ x _ { 0 } }), Add(Div(Add(F_{i+1}, Neg(F_i)); h), Call(O; h)); \\approx)",
        "sympy/sympy/doc/src/explanation/special_topics/finite_diff_derivatives.rst",
    ),
    (
        "\\frac{d^2\\boldsymbol{B}}{dt^2} = \\left.\\frac{d^2\\boldsymbol{B}}{dt^2}\\right)_{\\text{rel}} + \\dot{\\boldsymbol{\\Omega}}\\times\\boldsymbol{B} + \\boldsymbol{\\Omega}\\times\\left(\\boldsymbol{\\Omega}\\times\\boldsymbol{B}\\right) + 2\\boldsymbol{\\Omega}\\times\\left.\\frac{d\\boldsymbol{B}}{dt}\\right)_{\\text{rel}}",
        "Chain(Derivative(Call(\\boldsymbol{B}); t, 2), Add(Marked(Derivative(Call(\\boldsymbol{B}); t, 2); _{ \\text { r e l } }), Cross(Call(\\dot{\\boldsymbol{\\Omega}}); Call(\\boldsymbol{B})), Cross(Call(\\boldsymbol{\\Omega}); Cross(Call(\\boldsymbol{\\Omega}); Call(\\boldsymbol{B}))), Cross(Mul(2, Call(\\boldsymbol{\\Omega})); Marked(Derivative(Call(\\boldsymbol{B}); t, 1); _{ \\text { r e l } }))); =)",
        "bryanwweber/orbital-mechanics-notes/review/time-derivatives-of-moving-vectors.md",
    ),
    (
        "\\gamma = \\frac{0.71 + 2.35\\left(\\frac{\\rho_g}{\\rho_l}\\right)} {1 + \\frac{1-x}{x} \\cdot \\frac{\\rho_g}{\\rho_l}}",
        "Chain(\\gamma, Div(Add(0.71, Mul(2.35, Div(\\rho_g; \\rho_l))); Add(1, Mul(Div(Add(1, Neg(x)); x), Div(\\rho_g; \\rho_l)))); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "t = \\frac{M_e}{2\\pi} T",
        "Chain(t, Mul(Div(M_e; Mul(2, \\pi)), T); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "T^+-T^- = \\boldsymbol{S}^{(e)}\\cdot \\frac{\\boldsymbol{v}_C^+-\\boldsymbol{v}_C^-}{2} + \\boldsymbol{K}_C^{(e)}\\cdot \\frac{\\boldsymbol{\\omega}^+-\\boldsymbol{\\omega}^-}{2}",
        "Chain(Add(T ^ { + }, Neg(T ^ { - })), Add(Mul(\\boldsymbol { S } ^ { ( e ) }, Div(Add(\\boldsymbol { v } _ { C } ^ { + }, Neg(\\boldsymbol { v } _ { C } ^ { - })); 2)), Mul(\\boldsymbol { K } _ { C } ^ { ( e ) }, Div(Add(\\boldsymbol { \\omega } ^ { + }, Neg(\\boldsymbol { \\omega } ^ { - })); 2))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "K_Q := \\frac{1}{2}m\\left|{}^N\\bar{v}^{Q}\\right|^2 = \\frac{1}{2}m {}^N\\bar{v}^{Q} \\cdot {}^N\\bar{v}^{Q}",
        "Chain(K_Q, Mul(Div(1; 2), m, Pow(Bars(\\prescript { N } { } { \\bar { v } } ^ { Q }); 2)), Mul(Div(1; 2), m, \\prescript { N } { } { \\bar { v } } ^ { Q }, \\prescript { N } { } { \\bar { v } } ^ { Q }; 3); =, =)",
        "moorepants/learn-multibody-dynamics/energy.rst",
    ),
    (
        "r = a\\frac{1 - e^2}{1 + e\\cos\\nu}",
        "Chain(r, Mul(a, Div(Add(1, Neg(Pow(e; 2))); Add(1, Mul(e, Call(cos; \\nu))))); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/elliptical-orbits.md",
    ),
    (
        "\\begin{array}{c} f_{g,b}( \\mathbf{q}, \\,^S\\mathbf{a}, \\,^E\\mathbf{b}, \\,^S\\mathbf{m})= \\begin{bmatrix}f_g( \\mathbf{q}, \\,^S\\mathbf{a}) \\\\ f_b( \\mathbf{q}, \\,^E\\mathbf{b}, \\,^S\\mathbf{m})\\end{bmatrix}\\\\ \\\\ J_{g,b}( \\mathbf{q}, \\,^E\\mathbf{b})= \\begin{bmatrix}J_g^T( \\mathbf{q}) \\\\ J_b^T( \\mathbf{q}, \\,^E\\mathbf{b})\\end{bmatrix} \\end{array}",
        "System(Chain(Call(f_{g,b}; \\mathbf{q}, \\prescript { S } { } { \\mathbf { a } }, \\prescript { E } { } { \\mathbf { b } }, \\prescript { S } { } { \\mathbf { m } }), MatrixOf(Call(f_g; \\mathbf{q}, \\prescript { S } { } { \\mathbf { a } }), Call(f_b; \\mathbf{q}, \\prescript { E } { } { \\mathbf { b } }, \\prescript { S } { } { \\mathbf { m } })); =), Chain(Call(J_{g,b}; \\mathbf{q}, \\prescript { E } { } { \\mathbf { b } }), MatrixOf(Transpose(Call(J_g; \\mathbf{q})), Transpose(Call(J_b; \\mathbf{q}, \\prescript { E } { } { \\mathbf { b } }))); =))",
        "Mayitzin/ahrs/ahrs/filters/madgwick.py",
    ),
    (
        "a_0 = \\frac{2}{L} \\int_{0}^L f(t) \\, dt .",
        "Chain(a_0, Mul(Div(2; L), Integral(Call(f; t); t; 0; L)); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\bar{v} = \\sum_{r=1}^n \\bar{v}_r u_r + \\bar{v}_t \\\\ \\bar{\\omega} = \\sum_{r=1}^n \\bar{\\omega}_r u_r + \\bar{\\omega}_t",
        "System(Chain(\\bar{v}, Add(BigSum(r; 1; n; Mul(\\bar{v}_r, u_r)), \\bar{v}_t); =), Chain(\\bar{\\omega}, Add(BigSum(r; 1; n; Mul(\\bar{\\omega}_r, u_r)), \\bar{\\omega}_t); =))",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "u_x(0,t) = 0 \\quad \\text{and} \\quad u_x(L,t) = 0 \\quad \\text{for } \\; t > 0 .",
        "Implies(Chain(t, 0; >); System(Chain(Call(u_x; 0, t), 0; =), Chain(Call(u_x; L, t), 0; =)))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "M = \\left|\\frac{R-h}{R}\\right|",
        "Chain(M, Bars(Div(Add(R, Neg(h)); R)); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\tan\\frac{\\nu}{2} = z - \\frac{1}{z}",
        "Chain(Call(tan; Div(\\nu; 2)), Add(z, Neg(Div(1; z))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/parabolic-trajectories.md",
    ),
    (
        "{\\bf f}(\\pmb\\sigma_{\\mathcal{B}/\\mathcal{R}}) = \\begin{pmatrix} f(\\sigma_{1})\\\\ f(\\sigma_{2})\\\\ f(\\sigma_{3}) \\end{pmatrix}",
        "Chain(Call(\\mathbf{f}; \\pmb{\\sigma}_{\\mathcal B/\\mathcal R}), MatrixOf(Call(f; \\sigma_1), Call(f; \\sigma_2), Call(f; \\sigma_3)); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attControl/mrpSteering/mrpSteering.rst",
    ),
    (
        "y = y_c + y_p",
        "Chain(y, Add(y_c, y_p); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "\\bar{\\mathbf E}(\\mbox{\\boldmath $\\chi$}) = \\mathbf E^{-1}(\\mbox{\\boldmath $\\chi$}) = \\begin{bmatrix} \\dfrac{\\cos(z)\\sin(y)}{\\cos(y)} & \\dfrac{\\sin(y)\\sin(z)}{\\cos(y)} & 1 \\\\ -\\sin(z) & \\cos(z) & 0 \\\\ \\dfrac{\\cos(z)}{\\cos(y)} & \\dfrac{\\sin(z)}{\\cos(y)} & 0 \\end{bmatrix}",
        "Chain(Call(\\bar{\\mathbf{E}}; \\boldsymbol{\\chi}), Pow(Call(\\mathbf{E}; \\boldsymbol{\\chi}); Neg(1)), MatrixOf(Div(Mul(Call(cos; z), Call(sin; y)); Call(cos; y)), Div(Mul(Call(sin; y), Call(sin; z)); Call(cos; y)), 1, Neg(Call(sin; z)), Call(cos; z), 0, Div(Call(cos; z); Call(cos; y)), Div(Call(sin; z); Call(cos; y)), 0); =, =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "\\frac{{}^Ad}{dt} {}^A\\bar{\\omega}^B & = \\frac{{}^Bd}{dt} {}^A\\bar{\\omega}^B + {}^A\\bar{\\omega}^B \\times {}^A\\bar{\\omega}^B",
        "Chain(Marked(Derivative(Call(\\prescript { A } { } { \\bar { \\omega } } ^ { B }); t, 1); _{ A }), Add(Marked(Derivative(Call(\\prescript { A } { } { \\bar { \\omega } } ^ { B }); t, 1); _{ B }), Cross(Call(\\prescript { A } { } { \\bar { \\omega } } ^ { B }); Call(\\prescript { A } { } { \\bar { \\omega } } ^ { B }))); =)",
        "moorepants/learn-multibody-dynamics/angular.rst",
    ),
    (
        "\\hat{\\bf v}_{LP/R} = [RN] \\, \\hat{\\bf v}_{LP/N}",
        "Chain(\\hat{\\mathbf{v}}_{LP/R}, Mul([ R N ], \\hat{\\mathbf{v}}_{LP/N}); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/locationPointing/locationPointing.rst",
    ),
    (
        "{}^A\\bar{\\omega}^B := \\left(\\frac{{}^A d\\hat{b}_y}{dt} \\cdot \\hat{b}_z\\right) \\hat{b}_x + \\left(\\frac{{}^A d\\hat{b}_z}{dt} \\cdot \\hat{b}_x\\right) \\hat{b}_y + \\left(\\frac{{}^A d\\hat{b}_x}{dt} \\cdot \\hat{b}_y\\right) \\hat{b}_z \\textrm{.}",
        "Chain(\\prescript { A } { } { \\bar { \\omega } } ^ { B }, Add(Mul(Mul(Marked(Derivative(Call(\\hat{b}_y); t, 1); _{ A }), Call(\\hat{b}_z)), Call(\\hat{b}_x)), Mul(Mul(Marked(Derivative(Call(\\hat{b}_z); t, 1); _{ A }), Call(\\hat{b}_x)), Call(\\hat{b}_y)), Mul(Mul(Marked(Derivative(Call(\\hat{b}_x); t, 1); _{ A }), Call(\\hat{b}_y)), Call(\\hat{b}_z))); =)",
        "moorepants/learn-multibody-dynamics/angular.rst",
    ),
    (
        "f_v = \\frac{\\Delta P d_p^2}{\\mu v_s L}\\frac{\\epsilon^3}{(1-\\epsilon)^2}",
        "Chain(f_v, Mul(Div(Mul(\\Delta P, Pow(d_p; 2)); Mul(\\mu, v_s, L)), Div(Pow(\\epsilon; 3); Pow(Add(1, Neg(\\epsilon)); 2))); =)",
        "CalebBell/fluids/fluids/packed_bed.py",
    ),
    (
        "\\boldsymbol{r}_{C/P} = \\rho \\boldsymbol{\\hat{u}}_{n}",
        "Chain(\\boldsymbol{r}_{C/P}, Mul(\\rho, \\boldsymbol{\\hat{u}}_n); =)",
        "bryanwweber/orbital-mechanics-notes/review/kinematics.md",
    ),
    (
        "\\begin{bmatrix} a_1 & a_2 & a_3 \\end{bmatrix} \\cdot \\begin{bmatrix} b_1 \\\\ b_2 \\\\ b_3 \\end{bmatrix} = a_1 b_1 + a_2 b_2 + a_3 b_3 .",
        "Chain(Mul(MatrixOf(a_1, a_2, a_3), MatrixOf(b_1, b_2, b_3)), Add(Mul(a_1, b_1), Mul(a_2, b_2), Mul(a_3, b_3)); =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "\\sum_{n=M+1}^{\\infty} \\zeta(2n, N) = \\sum_{n=M+1}^{\\infty} \\sum_{k=0}^{\\infty} (k+N)^{-2n} \\le \\sum_{n=M+1}^{\\infty} \\left( N^{-2n} + \\int_0^{\\infty} (t+N)^{-2n} dt \\right)",
        "Chain(BigSum(n; Add(M, 1); Infinity(); Call(\\zeta; Mul(2, n), N)), BigSum(n; Add(M, 1); Infinity(); BigSum(k; 0; Infinity(); Pow(Add(k, N); Neg(Mul(2, n))))), BigSum(n; Add(M, 1); Infinity(); Add(Pow(N; Neg(Mul(2, n))), Integral(Pow(Add(t, N); Neg(Mul(2, n))); t; 0; Infinity()))); =, \\le)",
        "fredrik-johansson/arb/doc/source/constants.rst",
    ),
    (
        "\\mathbf{A}\\bar{x} = \\bar{b}",
        "Chain(Mul(\\mathbf{A}, \\bar{x}), \\bar{b}; =)",
        "moorepants/learn-multibody-dynamics/sympy.rst",
    ),
    (
        "\\mathscr{J}_\\alpha = \\sum_{i=1}^n \\left(\\int_{t_0}^{t_0+\\tau} \\boldsymbol{F}_i\\mathrm{d} t\\right) \\cdot \\frac{\\partial \\boldsymbol{r}_i}{\\partial q_\\alpha}",
        "Chain(\\mathscr{J}_\\alpha, BigSum(i; 1; n; Mul(Integral(\\boldsymbol{F}_i; t; t_0; Add(t_0, \\tau)), Derivative(Call(\\boldsymbol{r}_i); q_\\alpha, 1; True))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "T = L V^{-1}, \\qquad M = A V^{-2},\\\\ T = \\begin{pmatrix} 0 \\\\ 1 \\\\ -1 \\end{pmatrix}, \\qquad M = \\begin{pmatrix} 1 \\\\ 0 \\\\ -2 \\end{pmatrix}.",
        "System(Chain(T, Mul(L, Pow(V; Neg(1))); =), Chain(M, Mul(A, Pow(V; Neg(2))); =), Chain(T, MatrixOf(0, 1, Neg(1)); =), Chain(M, MatrixOf(1, 0, Neg(2)); =))",
        "sympy/sympy/doc/src/modules/physics/units/philosophy.rst",
    ),
    (
        "{\\bf u}^* = -\\frac{1}{2}{\\bf R}^{-1}f_2^T({\\bf x}) \\frac{\\partial J}{\\partial {\\bf x}}^T.",
        "Chain(\\mathbf { u } ^ { * }, Neg(Mul(Div(1; 2), Pow(\\mathbf{R}; Neg(1)), Transpose(Call(f_2; \\mathbf{x})), Transpose(Derivative(Call(J); \\mathbf{x}, 1; True)))); =)",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "a \\frac{\\partial f(x,y)}{\\partial x} + b \\frac{\\partial f(x,y)}{\\partial y} + c f(x,y) = G(x,y)",
        "Chain(Add(Mul(a, Derivative(Call(f; x, y); x, 1; True)), Mul(b, Derivative(Call(f; x, y); y, 1; True)), Mul(c, Call(f; x, y))), Call(G; x, y); =)",
        "sympy/sympy/sympy/solvers/pde.py",
    ),
    (
        "V_f = \\frac{\\pi h^2}{4}\\left(2a + \\frac{D^2}{2a} - \\frac{4h}{3}\\right),\\; h < a",
        "System(Chain(V_f, Mul(Div(Mul(\\pi, Pow(h; 2)); 4), Add(Mul(2, a), Div(Pow(D; 2); Mul(2, a)), Neg(Div(Mul(4, h); 3)))); =), Chain(h, a; <))",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\frac{\\mu}{h^3}t = \\frac{1}{\\left(1 - e^2\\right)^{3/2}}\\left[2\\tan^{-1}\\left(\\sqrt{\\frac{1 - e}{1 + e}}\\tan\\frac{\\nu}{2}\\right)-\\frac{e\\sqrt{1 - e^2}\\sin \\nu}{1 + e \\cos \\nu}\\right]",
        "Chain(Mul(Div(\\mu; Pow(h; 3)), t), Mul(Div(1; Pow(Add(1, Neg(Pow(e; 2))); Div(3; 2))), Add(Mul(2, Call(arctan; Mul(Sqrt(Div(Add(1, Neg(e)); Add(1, e))), Call(tan; Div(\\nu; 2))))), Neg(Div(Mul(e, Sqrt(Add(1, Neg(Pow(e; 2)))), Call(sin; \\nu)); Add(1, Mul(e, Call(cos; \\nu))))))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "H_{geo} = \\frac{C_{geo}-A_{geo}}{C_{geo}}",
        "Chain(H_{geo}, Div(Add(C_{geo}, Neg(A_{geo})); C_{geo}); =)",
        "Mayitzin/ahrs/ahrs/utils/wgs84.py",
    ),
    (
        "U^{*}(a,b,z) = \\sum_{k=0}^{n-1} \\frac{(a)_k (a-b+1)_k}{k! (-z)^k} + \\varepsilon_n(z).",
        "Chain(Call(U ^ { * }; a, b, z), Add(BigSum(k; 0; Add(n, Neg(1)); Div(Mul(Marked(a; _{ k }), Marked(Add(a, Neg(b), 1); _{ k })); Mul(Factorial(k), Pow(Neg(z); k)))), Call(\\varepsilon_n; z)); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "r = fD",
        "Chain(r, Mul(f, D); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "L_n^{m}(z)=\\frac{(m+1)_n}{\\Gamma(n+1)} {}_1F_1\\left(-n,m+1,z\\right).",
        "Chain(Call(L _ { n } ^ { m }; z), Mul(Div(Marked(Add(m, 1); _{ n }); Call(Gamma; Add(n, 1))), Call(\\prescript { } { 1 } { F } _ { 1 }; Neg(n), Add(m, 1), z)); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "[A] = \\Big\\{m_{\\text{sc}}[I_{3\\times3}] -\\sum_{j=1}^{N_{P}}m_j l_j \\bigg[ \\Big(\\sin(\\varphi_j)\\cos(\\vartheta_j)\\bm{\\hat{p}}_{0_j,1}-\\cos(\\varphi_j)\\cos(\\vartheta_j)\\bm{\\hat{p}}_{0_j,2}\\Big)\\bm a_{\\varphi_j}^T \\\\ +\\Big(\\cos(\\varphi_j)\\sin(\\vartheta_j)\\bm{\\hat{p}}_{0_j,1}+\\sin(\\varphi_j)\\sin(\\vartheta_j)\\bm{\\hat{p}}_{0_j,2}+\\cos(\\vartheta_j)\\bm{\\hat{p}}_{0_j,3}\\Big)\\bm a_{\\vartheta_j}^T \\bigg]\\Big\\}",
        "Chain([ A ], Tuple(Add(Mul(m_{sc}, [ I _ { 3 \\times 3 } ]), Neg(BigSum(j; 1; N_P; Mul(m_j, l_j, Add(Mul(Add(Mul(Call(sin; \\varphi_j), Call(cos; \\vartheta_j), \\bm{\\hat{p}}_{0_j,1}), Neg(Mul(Call(cos; \\varphi_j), Call(cos; \\vartheta_j), \\bm{\\hat{p}}_{0_j,2}))), Transpose(\\bm{a}_{\\varphi_j})), Mul(Add(Mul(Call(cos; \\varphi_j), Call(sin; \\vartheta_j), \\bm{\\hat{p}}_{0_j,1}), Mul(Call(sin; \\varphi_j), Call(sin; \\vartheta_j), \\bm{\\hat{p}}_{0_j,2}), Mul(Call(cos; \\vartheta_j), \\bm{\\hat{p}}_{0_j,3})), Transpose(\\bm{a}_{\\vartheta_j}))))))); {}); =)",
        "AVSLab/basilisk/src/simulation/dynamics/sphericalPendulum/_Documentation/secModelDescription.tex",
    ),
    (
        "x'' + \\lambda x = 0, \\quad x'(a) = 0, \\quad x'(b) = 0 ,",
        "System(Chain(Add(Call(x''), Mul(\\lambda, Call(x))), 0; =), Chain(Call(x'; a), 0; =), Chain(Call(x'; b), 0; =))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "[E] = \\begin{bmatrix} \\bm e_{i1}^T\\\\ \\bm e_{i2}^T \\end{bmatrix}",
        "Chain([ E ], MatrixOf(Transpose(\\bm{e}_{i1}), Transpose(\\bm{e}_{i2})); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "y_p = Ax + B .",
        "Chain(y_p, Add(Mul(A, x), B); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "F_0 = 2 \\tanh^{-1}\\left(\\sqrt{\\frac{e - 1}{e + 1}}\\tan\\frac{\\nu_0}{2}\\right)",
        "Chain(F_0, Mul(2, Call(artanh; Mul(Sqrt(Div(Add(e, Neg(1)); Add(e, 1))), Call(tan; Div(\\nu_0; 2))))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables-example.md",
    ),
    (
        "x' = (a-by)x = ax - byx .",
        "Chain(x', Mul(Add(a, Neg(Mul(b, y))), x), Add(Mul(a, x), Neg(Mul(b, y, x))); =, =)",
        "jirilebl/diffyqs/ch-nonlin-systems.tex",
    ),
    (
        "\\dot{q}_1 + \\dot{q}_2 r = 0",
        "Chain(Add(Call(\\dot{q}_1), Mul(Call(\\dot{q}_2), r)), 0; =)",
        "moorepants/learn-multibody-dynamics/motion.rst",
    ),
    (
        "\\hat{a}_x = (\\hat{a}_x \\cdot \\hat{n}_x) \\hat{n}_x + (\\hat{a}_x \\cdot \\hat{n}_y) \\hat{n}_y + (\\hat{a}_x \\cdot \\hat{n}_z) \\hat{n}_z \\\\ \\hat{a}_y = (\\hat{a}_y \\cdot \\hat{n}_x) \\hat{n}_x + (\\hat{a}_y \\cdot \\hat{n}_y) \\hat{n}_y + (\\hat{a}_y \\cdot \\hat{n}_z) \\hat{n}_z \\\\ \\hat{a}_x = (\\hat{a}_z \\cdot \\hat{n}_x) \\hat{n}_x + (\\hat{a}_z \\cdot \\hat{n}_y) \\hat{n}_y + (\\hat{a}_z \\cdot \\hat{n}_z) \\hat{n}_z",
        "System(Chain(\\hat{a}_x, Add(Mul(Mul(\\hat{a}_x, \\hat{n}_x; 1), \\hat{n}_x), Mul(Mul(\\hat{a}_x, \\hat{n}_y; 1), \\hat{n}_y), Mul(Mul(\\hat{a}_x, \\hat{n}_z; 1), \\hat{n}_z)); =), Chain(\\hat{a}_y, Add(Mul(Mul(\\hat{a}_y, \\hat{n}_x; 1), \\hat{n}_x), Mul(Mul(\\hat{a}_y, \\hat{n}_y; 1), \\hat{n}_y), Mul(Mul(\\hat{a}_y, \\hat{n}_z; 1), \\hat{n}_z)); =), Chain(\\hat{a}_x, Add(Mul(Mul(\\hat{a}_z, \\hat{n}_x; 1), \\hat{n}_x), Mul(Mul(\\hat{a}_z, \\hat{n}_y; 1), \\hat{n}_y), Mul(Mul(\\hat{a}_z, \\hat{n}_z; 1), \\hat{n}_z)); =))",
        "moorepants/learn-multibody-dynamics/orientation.rst",
    ),
    (
        "\\begin{aligned} \\mu_1 &= G m_1 & \\mu_2 &= G m_2 \\end{aligned}",
        "System(Chain(\\mu_1, Mul(G, m_1); =), Chain(\\mu_2, Mul(G, m_2); =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "[C] = m_{\\text{sc}} + [C_{\\text{contr}}]",
        "Chain([ C ], Add(m_{sc}, [ C _ { \\text { c o n t r } } ]); =)",
        "AVSLab/basilisk/src/simulation/dynamics/NHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "Y_{\\nu}(z) = \\frac{\\cos(\\nu \\pi) J_{\\nu}(z) - J_{-\\nu}(z)}{\\sin(\\nu \\pi)}",
        "Chain(Call(Y_\\nu; z), Div(Add(Mul(Call(cos; Mul(\\nu, \\pi)), Call(J_\\nu; z)), Neg(Call(J_{-\\nu}; z))); Call(sin; Mul(\\nu, \\pi))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "y' = \\frac{xy}{y^2+1} .",
        "Chain(y', Div(Mul(x, y); Add(Pow(y; 2), 1)); =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\lvert f(t) \\rvert \\leq M e^{ct} ,",
        "Chain(Bars(Call(f; t)), Mul(M, Pow(e; Mul(c, t))); \\le)",
        "jirilebl/diffyqs/ch-laplace.tex",
    ),
    (
        "|\\varepsilon_n(z)| \\le 2 \\alpha C_n \\left|\\frac{(a)_n (a-b+1)_n}{n! z^n} \\right| \\exp(2 \\alpha \\rho C_1 / |z|)",
        "Chain(Bars(Call(\\varepsilon_n; z)), Mul(2, \\alpha, C_n, Bars(Div(Mul(Marked(a; _{ n }), Marked(Add(a, Neg(b), 1); _{ n })); Mul(Factorial(n), Pow(z; n)))), Call(exp; Div(Mul(2, \\alpha, \\rho, C_1); Bars(z)))); \\le)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "b = 52.8 - 434.2\\beta + 1571.2\\beta^2 - 2460.9\\beta^3 + 1420.2\\beta^4",
        "Chain(b, Add(52.8, Neg(Mul(434.2, \\beta)), Mul(1571.2, Pow(\\beta; 2)), Neg(Mul(2460.9, Pow(\\beta; 3))), Mul(1420.2, Pow(\\beta; 4))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "\\mathbf{C} = \\begin{bmatrix}\\mathbf{P}_1\\mathbf{q} & \\mathbf{P}_2\\mathbf{q} & \\mathbf{P}_3\\mathbf{q}\\end{bmatrix}",
        "Chain(\\mathbf{C}, MatrixOf(Mul(\\mathbf{P}_1, \\mathbf{q}), Mul(\\mathbf{P}_2, \\mathbf{q}), Mul(\\mathbf{P}_3, \\mathbf{q})); =)",
        "Mayitzin/ahrs/ahrs/filters/oleq.py",
    ),
    (
        "{}^N\\bar{v}^R = {}^B\\bar{v}^R + {}^N\\bar{v}^T",
        "Chain(\\prescript { N } { } { \\bar { v } } ^ { R }, Add(\\prescript { B } { } { \\bar { v } } ^ { R }, \\prescript { N } { } { \\bar { v } } ^ { T }); =)",
        "moorepants/learn-multibody-dynamics/translational.rst",
    ),
    (
        "|f(x+a) - f(x)| \\le \\min(2 C_0, C_1 |a|)",
        "Chain(Bars(Add(Call(f; Add(x, a)), Neg(Call(f; x)))), Call(min; Mul(2, C_0), Mul(C_1, Bars(a))); \\le)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "\\ddot{{\\bf q}} = {\\bf f}({\\bf q},\\dot{{\\bf q}},{\\bf u},t),",
        "Chain(Call(\\ddot{\\mathbf{q}}), Call(\\mathbf{f}; Call(\\mathbf{q}), Call(\\dot{\\mathbf{q}}), \\mathbf{u}, t); =)",
        "RussTedrake/underactuated/book/intro.html",
    ),
    (
        "E_\\mathrm{tr} = \\frac{1}{2}\\mathrm{tr}(\\mathbf{I}_3-\\tilde{\\mathbf{R}})",
        "Chain(E_{tr}, Mul(Div(1; 2), Call(tr; Add(\\mathbf{I}_3, Neg(\\tilde{\\mathbf{R}})))); =)",
        "Mayitzin/ahrs/ahrs/filters/mahony.py",
    ),
    (
        "\\mathbf{W}_m = \\begin{bmatrix} m_z & m_y & -m_x & 0 \\\\ m_y & -m_z & 0 & m_x \\\\ -m_x & 0 & -m_z & m_y \\\\ 0 & m_x & m_y & m_z \\end{bmatrix}",
        "Chain(\\mathbf{W}_m, MatrixOf(m_z, m_y, Neg(m_x), 0, m_y, Neg(m_z), 0, m_x, Neg(m_x), 0, Neg(m_z), m_y, 0, m_x, m_y, m_z); =)",
        "Mayitzin/ahrs/ahrs/filters/fkf.py",
    ),
    (
        "\\boldsymbol{a} = \\boldsymbol{a}_C + \\dot{\\boldsymbol{\\Omega}}\\times\\boldsymbol{r}_{\\text{rel}} + \\boldsymbol{\\Omega}\\times\\left(\\boldsymbol{\\Omega}\\times\\boldsymbol{r}_{\\text{rel}}\\right) + 2\\boldsymbol{\\Omega}\\times\\boldsymbol{v}_{\\text{rel}} + \\boldsymbol{a}_{\\text{rel}}",
        "Chain(\\boldsymbol{a}, Add(\\boldsymbol{a}_C, Cross(Call(\\dot{\\boldsymbol{\\Omega}}); \\boldsymbol{r}_{rel}), Cross(Call(\\boldsymbol{\\Omega}); Cross(Call(\\boldsymbol{\\Omega}); \\boldsymbol{r}_{rel})), Cross(Mul(2, Call(\\boldsymbol{\\Omega})); \\boldsymbol{v}_{rel}), \\boldsymbol{a}_{rel}); =)",
        "bryanwweber/orbital-mechanics-notes/reference/relative-motion.md",
    ),
    (
        "\\operatorname{Ci}(z) = -\\tfrac{z^2}{4} {}_2F_3(1, 1; 2, 2, \\tfrac{3}{2}; -\\tfrac{z^2}{4}) + \\log(z) + \\gamma",
        "Chain(Call(\\text{Ci}; z), Add(Neg(Mul(Div(Pow(z; 2); 4), Call(\\prescript { } { 2 } { F } _ { 3 }; Given(1, 1; Given(2, 2, Div(3; 2); Neg(Div(Pow(z; 2); 4)); ;); ;)))), Call(log; z), \\gamma); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "\\exp(A) = \\sum_{k=0}^{\\infty} \\frac{A^k}{k!}.",
        "Chain(Call(exp; A), BigSum(k; 0; Infinity(); Div(Pow(A; k); Factorial(k))); =)",
        "fredrik-johansson/arb/doc/source/acb_mat.rst",
    ),
    (
        "\\text{Stk} = \\frac{\\rho_p V D_p^2}{18\\mu_f D}",
        "Chain(\\text{Stk}, Div(Mul(\\rho_p, V, Pow(D_p; 2)); Mul(18, \\mu_f, D)); =)",
        "CalebBell/fluids/fluids/core.py",
    ),
    (
        "\\mathcal{Y} = f(\\mathcal{X})",
        "Chain(\\mathcal{Y}, Call(f; \\mathcal{X}); =)",
        "Mayitzin/ahrs/ahrs/filters/ukf.py",
    ),
    (
        "\\dot{{\\bf x}} = (U({\\bf x})-1) {\\bf R}(\\theta) \\frac{\\partial U}{\\partial {\\bf x}}^T,",
        "Chain(Call(\\dot{\\mathbf{x}}), Mul(Add(Call(U; Call(\\mathbf{x})), Neg(1)), Call(\\mathbf{R}; \\theta), Transpose(Derivative(Call(U); \\mathbf{x}, 1; True))); =)",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "\\Phi = \\frac{1}{2} \\omega^2(u^2+E^2)\\cos^2\\beta",
        "Chain(\\Phi, Mul(Div(1; 2), Pow(\\omega; 2), Add(Pow(u; 2), Pow(E; 2)), Pow(Call(cos; \\beta); 2)); =)",
        "Mayitzin/ahrs/ahrs/utils/wgs84.py",
    ),
    (
        "\\nabla f( \\mathbf{q}_k, \\,^E\\mathbf{d}, \\,^S\\mathbf{s}) = J( \\mathbf{q}_k, \\,^E\\mathbf{d})^T f( \\mathbf{q}_k, \\,^E\\mathbf{d}, \\,^S\\mathbf{s})",
        "Chain(Call(\\nabla f; \\mathbf{q}_k, \\prescript { E } { } { \\mathbf { d } }, \\prescript { S } { } { \\mathbf { s } }), Mul(Transpose(Call(J; \\mathbf{q}_k, \\prescript { E } { } { \\mathbf { d } })), Call(f; \\mathbf{q}_k, \\prescript { E } { } { \\mathbf { d } }, \\prescript { S } { } { \\mathbf { s } })); =)",
        "Mayitzin/ahrs/ahrs/filters/madgwick.py",
    ),
    (
        "\\begin{array}{rcl} \\hat{\\mathbf{q}}_t &=& \\Bigg(\\mathbf{I}_4 + \\frac{1}{2}\\boldsymbol\\Omega_t\\Delta t + \\frac{1}{2!}\\Big(\\frac{1}{2}\\boldsymbol\\Omega_t\\Delta t\\Big)^2 + \\frac{1}{3!}\\Big(\\frac{1}{2}\\boldsymbol\\Omega_t\\Delta t\\Big)^3 + \\cdots\\Bigg)\\mathbf{q}_{t-1} \\\\ && \\qquad{} + \\frac{1}{4}\\dot{\\boldsymbol\\Omega}_t\\Delta t^2\\mathbf{q}_{t-1} + \\Big[\\frac{1}{12}\\dot{\\boldsymbol\\Omega}_t\\boldsymbol\\Omega_t + \\frac{1}{24}\\boldsymbol\\Omega_t\\dot{\\boldsymbol\\Omega}_t + \\frac{1}{12}\\ddot{\\boldsymbol\\Omega}_t\\Big]\\Delta t^3\\mathbf{q}_{t-1} + \\cdots \\end{array}",
        "Chain(\\hat{\\mathbf{q}}_t, Add(Mul(Add(\\mathbf{I}_4, Mul(Div(1; 2), Call(\\boldsymbol{\\Omega}_t), \\Delta t), Mul(Div(1; Factorial(2)), Pow(Mul(Div(1; 2), Call(\\boldsymbol{\\Omega}_t), \\Delta t); 2)), Mul(Div(1; Factorial(3)), Pow(Mul(Div(1; 2), Call(\\boldsymbol{\\Omega}_t), \\Delta t); 3)), Dots()), \\mathbf{q}_{t-1}), Mul(Div(1; 4), Call(\\dot{\\boldsymbol{\\Omega}}_t), Pow(\\Delta t; 2), \\mathbf{q}_{t-1}), Mul(Add(Mul(Div(1; 12), Call(\\dot{\\boldsymbol{\\Omega}}_t), Call(\\boldsymbol{\\Omega}_t)), Mul(Div(1; 24), Call(\\boldsymbol{\\Omega}_t), Call(\\dot{\\boldsymbol{\\Omega}}_t)), Mul(Div(1; 12), Call(\\ddot{\\boldsymbol{\\Omega}}_t))), Pow(\\Delta t; 3), \\mathbf{q}_{t-1}), Dots()); =)",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "[A_\\text{contr}] = [0_{3 \\times 3}]",
        "Chain([ A _ { \\text { c o n t r } } ], Marked(0; _{ 3 \\times 3 }); =)",
        "AVSLab/basilisk/src/simulation/dynamics/reactionWheels/_Documentation/RWJitterBackSubstitution/Basilisk-RWJitterBackSub-20161221.tex",
    ),
    (
        "\\Delta v = 2 \\left\\lvert v_a - v_i \\right\\rvert",
        "Chain(\\Delta v, Mul(2, Bars(Add(v_a, Neg(v_i)))); =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/phasing-maneuvers.md",
    ),
    (
        "\\frac{1}{2} y^2 + \\frac{1}{2} x^2 - \\frac{1}{3} x^3 = C .",
        "Chain(Add(Mul(Div(1; 2), Pow(y; 2)), Mul(Div(1; 2), Pow(x; 2)), Neg(Mul(Div(1; 3), Pow(x; 3)))), C; =)",
        "jirilebl/diffyqs/ch-nonlin-systems.tex",
    ),
    (
        "\\int_{\\tau_0}^{\\tau_1} \\delta \\varLambda \\mathrm{d} \\tau = 0",
        "Chain(Integral(\\delta \\varLambda; \\tau; \\tau_0; \\tau_1), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter9.tex",
    ),
    (
        "\\hat{\\bm\\imath}_{n} = \\hat{\\bm\\imath}_{v} \\times \\hat{\\bm\\imath}_{h}",
        "Chain(\\hat{\\bm{\\imath}}_n, Cross(\\hat{\\bm{\\imath}}_v; \\hat{\\bm{\\imath}}_h); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/velocityPoint/_Documentation/velocityPoint.tex",
    ),
    (
        "\\mathbf{x} = \\begin{bmatrix} \\ddot{\\mathbf{q}} \\\\ \\mathbf{\\lambda} \\end{bmatrix}",
        "Chain(\\mathbf{x}, MatrixOf(Call(\\ddot{\\mathbf{q}}), \\mathbf{\\lambda}); =)",
        "sympy/sympy/doc/src/explanation/modules/physics/mechanics/lagrange.rst",
    ),
    (
        "U^{*}(a,b,z) \\sim {}_2F_0(a, a-b+1, -1/z)",
        "Chain(Call(U ^ { * }; a, b, z), Call(\\prescript { } { 2 } { F } _ { 0 }; a, Add(a, Neg(b), 1), Neg(Div(1; z))); \\sim)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "- \\left(\\frac{\\Delta P}{\\Delta z}\\right)_{acc} = 0.5\\rho_i v_i^2 - 0.5\\rho_o v_o^2",
        "Chain(Neg(Marked(Div(\\Delta P; \\Delta z); _{ a c c })), Add(Mul(0.5, \\rho_i, Pow(v_i; 2)), Neg(Mul(0.5, \\rho_o, Pow(v_o; 2)))); =)",
        "CalebBell/fluids/fluids/friction.py",
    ),
    (
        "\\dot{\\bm{H}}_{\\text{sc},B} = [I_{\\text{sc},B}] \\dot{\\bm\\omega}_{\\cal B/N} + \\bm\\omega_{\\cal B/N} \\times [I_{\\text{sc},B}] \\bm\\omega_{\\cal B/N} + [I'_{\\text{sc},B}] \\bm\\omega_{\\cal B/N} \\\\+ \\sum\\limits_{j=1}^{N_P}\\biggl[m_j \\bm r_{P_{c,j}/B}\\times\\bm{r}''_{P_{c,j}/B} + m_j \\bm\\omega_{\\cal B/N} \\times \\Bigl(\\bm{r}_{P_{c,j}/B} \\times \\bm{r}'_{P_{c,j}/B}\\Bigr)\\biggr]",
        "Chain(Call(\\dot{\\bm{H}}_{sc,B}), Add(Mul([ I _ { \\text { s c } , B } ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N })), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Mul([ I _ { \\text { s c } , B } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}))), Mul([ I ' _ { \\text { s c } , B } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})), BigSum(j; 1; N_P; Add(Cross(Mul(m_j, \\bm{r}_{P_c,j/B}); \\bm{r}_{P_c,j/B}''), Cross(Mul(m_j, Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})); Cross(\\bm{r}_{P_c,j/B}; \\bm{r}_{P_c,j/B}'))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/LinearSpringMassDamper/_Documentation/secModelDescription.tex",
    ),
    (
        "\\Pr(x_{n+1} = x | b_n, h_n, u_n) = \\Pr(x_{n+1} = x | b_n, u_n).",
        "Chain(Call(Pr; Given(Chain(x_{n+1}, x; =); b_n, h_n, u_n; |)), Call(Pr; Given(Chain(x_{n+1}, x; =); b_n, u_n; |)); =)",
        "RussTedrake/underactuated/book/belief.html",
    ),
    (
        "K = f\\alpha\\frac{r}{d} + (0.10 + 2.4f)\\sin(\\alpha/2) + \\frac{6.6f(\\sqrt{\\sin(\\alpha/2)}+\\sin(\\alpha/2))} {(r/d)^{\\frac{4\\alpha}{\\pi}}}",
        "Chain(K, Add(Mul(f, \\alpha, Div(r; d)), Mul(Add(0.10, Mul(2.4, f)), Call(sin; Div(\\alpha; 2))), Div(Mul(6.6, f, Add(Sqrt(Call(sin; Div(\\alpha; 2))), Call(sin; Div(\\alpha; 2)))); Pow(Div(r; d); Div(Mul(4, \\alpha); \\pi)))); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "\\dot x = f(x) = - x^3 + 4x^2 +11x - 30.",
        "Chain(Call(\\dot{x}), Call(f; Call(x)), Add(Neg(Pow(Call(x); 3)), Mul(4, Pow(Call(x); 2)), Mul(11, Call(x)), Neg(30)); =, =)",
        "RussTedrake/underactuated/book/pend.html",
    ),
    (
        "E_1 Z_1 + E_2 Z_2 = (E_1 + E_2)/x + E_1 \\tilde Z_1 + E_2 \\tilde Z_2.",
        "Chain(Add(Mul(E_1, Z_1), Mul(E_2, Z_2)), Add(Div(Add(E_1, E_2); x), Mul(E_1, \\tilde{Z}_1), Mul(E_2, \\tilde{Z}_2)); =)",
        "fredrik-johansson/arb/doc/source/polylogarithms.rst",
    ),
    (
        "R_M = \\frac{a(1-e^2)}{(1-e^2\\sin^2\\phi)^{\\frac{3}{2}}}",
        "Chain(R_M, Div(Mul(a, Add(1, Neg(Pow(e; 2)))); Pow(Add(1, Neg(Mul(Pow(e; 2), Pow(Call(sin; \\phi); 2)))); Div(3; 2))); =)",
        "Mayitzin/ahrs/ahrs/utils/geodesy.py",
    ),
    (
        "y^{(4)}+\\lambda y = 0, \\quad y(0) = 0, \\quad y'(0) = 0, \\quad y(1) = 0, \\quad y'(1) = 0 .",
        "System(Chain(Add(y ^ { ( 4 ) }, Mul(\\lambda, Call(y))), 0; =), Chain(Call(y; 0), 0; =), Chain(Call(y'; 0), 0; =), Chain(Call(y; 1), 0; =), Chain(Call(y'; 1), 0; =))",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "f_{1, C_1,z}^{B_{c_1}} \\ge 0,",
        "Chain(f _ { 1 , C _ { 1 } , z } ^ { B _ { c _ { 1 } } }, 0; \\ge)",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "{ {\\boldsymbol{y}}}^* = \\left(\\begin{array}{ccccc} t_1^*\\quad & & \\cdots\\quad & & t_M^* \\end{array}\\right)^\\mathrm{T}",
        "Chain(\\boldsymbol { y } ^ { * }, Transpose(MatrixOf(t _ { 1 } ^ { * }, Blank(), Dots(), Blank(), t _ { M } ^ { * })); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\mathbf{C}\\,^r\\mathbf{a}=\\,^b\\mathbf{a}",
        "Chain(Mul(\\mathbf{C}, \\prescript { r } { } { \\mathbf { a } }), \\prescript { b } { } { \\mathbf { a } }; =)",
        "Mayitzin/ahrs/ahrs/filters/saam.py",
    ),
    (
        "\\bar{L} = T-W = T + \\sum_{j=1}^l \\lambda_j \\bar{f}_j (\\boldsymbol{q},t)",
        "Chain(\\bar{L}, Add(T, Neg(W)), Add(T, BigSum(j; 1; l; Mul(\\lambda_j, Call(\\bar{f}_j; \\boldsymbol{q}, t)))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "\\frac{\\pi}{4 K(z^2)} = \\tfrac{1}{2} - \\tfrac{1}{8} z^2 - \\tfrac{5}{128} z^4 - \\tfrac{11}{512} z^6 - \\tfrac{469}{32768} z^8 + \\ldots",
        "Chain(Div(\\pi; Mul(4, Call(K; Pow(z; 2)))), Add(Div(1; 2), Neg(Mul(Div(1; 8), Pow(z; 2))), Neg(Mul(Div(5; 128), Pow(z; 4))), Neg(Mul(Div(11; 512), Pow(z; 6))), Neg(Mul(Div(469; 32768), Pow(z; 8))), Dots()); =)",
        "fredrik-johansson/arb/doc/source/agm.rst",
    ),
    (
        "\\frac{dx}{ds} = a, \\qquad \\frac{dt}{ds} = b .",
        "System(Chain(Derivative(Call(x); s, 1), a; =), Chain(Derivative(Call(t); s, 1), b; =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\begin{aligned} \\Delta v &= \\lvert v_f - v_{t,a}\\rvert + \\lvert v_i - v_{t,p}\\rvert & \\text{If $r_i < r_f$} \\\\ \\Delta v &= \\lvert v_f - v_{t,p}\\rvert + \\lvert v_i - v_{t,a}\\rvert & \\text{If $r_f < r_i$} \\end{aligned}",
        "System(Chain(\\Delta v, Add(Bars(Add(v_f, Neg(v_{t,a}))), Bars(Add(v_i, Neg(v_{t,p})))); =), Words(\\text{If$r_{i}<r_{f}$}), Chain(\\Delta v, Add(Bars(Add(v_f, Neg(v_{t,p}))), Bars(Add(v_i, Neg(v_{t,a})))); =), Words(\\text{If$r_{f}<r_{i}$}))",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/hohmann-transfer.md",
    ),
    (
        "V_1 = \\int_0^{\\sqrt{2kDh - h^2}} \\left[n^2\\sin^{-1}\\frac{\\sqrt {n^2-w^2}}{n} - w\\sqrt{n^2-w^2}\\right]dx",
        "Chain(V_1, Integral(Add(Mul(Pow(n; 2), Call(arcsin; Div(Sqrt(Add(Pow(n; 2), Neg(Pow(w; 2)))); n))), Neg(Mul(w, Sqrt(Add(Pow(n; 2), Neg(Pow(w; 2))))))); x; 0; Sqrt(Add(Mul(2, k, D, h), Neg(Pow(h; 2))))); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "y = \\frac{2\\sqrt{2}}{3} \\omega_0 h \\sqrt{\\frac{h}{g}} \\cos \\lambda",
        "Chain(y, Mul(Div(Mul(2, Sqrt(2)); 3), \\omega_0, h, Sqrt(Div(h; g)), Call(cos; \\lambda)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter7.tex",
    ),
    (
        "\\bm{v}_{P2} = \\bm{R}_{P1} \\times \\bm{a}_{P1}",
        "Chain(\\bm{v}_{P2}, Cross(\\bm{R}_{P1}; \\bm{a}_{P1}); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/celestialTwoBodyPoint/_Documentation/celestialTwoBodyPoint.tex",
    ),
    (
        "\\operatorname{Chi}(x) = \\gamma + \\log{x} + \\int_0^x \\frac{\\cosh{t} - 1}{t} \\mathrm{d}t,",
        "Chain(Call(\\text{Chi}; x), Add(\\gamma, Call(log; x), Integral(Div(Add(Call(cosh; t), Neg(1)); t); t; 0; x)); =)",
        "sympy/sympy/sympy/functions/special/error_functions.py",
    ),
    (
        "[Q] = \\begin{bmatrix} D_0 & D \\end{bmatrix}",
        "Chain([ Q ], MatrixOf(D_0, D); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/vscmgVelocitySteering/vscmgVelocitySteering.rst",
    ),
    (
        "L = L_2+L_1+L_0",
        "Chain(L, Add(L_2, L_1, L_0); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "\\find_{{\\bf w},{\\bf z}} \\quad \\textrm{subject to} \\quad & {\\bf w} = {\\bf q} + {\\bf M} {\\bf z}, \\\\ & {\\bf w} \\ge 0, {\\bf z} \\ge 0, {\\bf w}^T{\\bf z} = 0.",
        "System(Words(\\text{find}_{\\mathbf w,\\mathbf z}), Words(\\text{subject~to}), Chain(\\mathbf{w}, Add(\\mathbf{q}, Mul(\\mathbf{M}, \\mathbf{z})); =), Chain(\\mathbf{w}, 0; \\ge), Chain(\\mathbf{z}, 0; \\ge), Chain(Mul(Transpose(\\mathbf{w}), \\mathbf{z}), 0; =))",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "k(\\tau) &=& \\lim_{f \\to 0}\\, \\frac{1}{2}\\,S_0\\,\\omega_0\\, \\left[\\left(1+1/f\\right)\\,e^{-\\omega_0\\,(1-f)\\,\\tau} + \\left(1-1/f\\right)\\,e^{-\\omega_0\\,(1+f)\\,\\tau} \\right] \\\\ &=& S_0\\,\\omega_0\\,e^{-\\omega_0\\,\\tau}\\,[1+\\omega_0\\,\\tau]",
        "Chain(Call(k; \\tau), Limiting(lim; _{ f \\to 0 }; Mul(Div(1; 2), S_0, \\omega_0, Add(Mul(Add(1, Div(1; f)), Pow(e; Neg(Mul(\\omega_0, Add(1, Neg(f)), \\tau)))), Mul(Add(1, Neg(Div(1; f))), Pow(e; Neg(Mul(\\omega_0, Add(1, f), \\tau))))))), Mul(S_0, \\omega_0, Pow(e; Neg(Mul(\\omega_0, \\tau))), Add(1, Mul(\\omega_0, \\tau))); =, =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "f(t) = \\frac{a_0}{2} + \\sum_{n=1}^\\infty a_n \\cos (n t) ,",
        "Chain(Call(f; t), Add(Div(a_0; 2), BigSum(n; 1; Infinity(); Mul(a_n, Call(cos; Mul(n, t))))); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "-2 z (z^2-1) c_2 = (3z^2-1) c_1 + z c_0,",
        "Chain(Neg(Mul(2, z, Add(Pow(z; 2), Neg(1)), c_2)), Add(Mul(Add(Mul(3, Pow(z; 2)), Neg(1)), c_1), Mul(z, c_0)); =)",
        "fredrik-johansson/arb/doc/source/agm.rst",
    ),
    (
        "P_1 = \\frac{F_{F} F_{L}^{2} P_{sat} - P_{2}}{F_{L}^{2} - 1}",
        "Chain(P_1, Div(Add(Mul(F_F, Pow(F_L; 2), P_{sat}), Neg(P_2)); Add(Pow(F_L; 2), Neg(1))); =)",
        "CalebBell/fluids/fluids/control_valve.py",
    ),
    (
        "\\dot{m}_\\text{fuel} = - 4\\pi\\rho\\,h\\,r\\,\\dot{r}",
        "Chain(Call(\\dot{m}_{fuel}), Neg(Mul(4, \\pi, \\rho, h, Call(r), Call(\\dot{r}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "\\left|\\sum_{k=N}^{\\infty} c_k z^k\\right| \\le \\frac{C D^N}{1-D}, \\quad D = \\left|\\frac{r}{R}\\right|.",
        "System(Chain(Bars(BigSum(k; N; Infinity(); Mul(c_k, Pow(z; k)))), Div(Mul(C, Pow(D; N)); Add(1, Neg(D))); \\le), Chain(D, Bars(Div(r; R)); =))",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "\\theta(t) = \\pm \\ddot{\\theta}_{\\text{max}} \\left( \\frac{(t - t_{b1})^2}{2} - \\frac{(t - t_{b1})^4}{4 t_{\\text{smooth}}^2} - \\frac{(t - t_{b1})^5}{10 t_{\\text{smooth}}^3} \\right) + \\dot{\\theta}(t_{b1})(t - t_{b1}) + \\theta(t_{b1})",
        "Chain(Call(\\theta; t), Add(PlusMinus(Mul(\\ddot { \\theta } _ { \\text { m a x } }, Add(Div(Pow(Add(t, Neg(t_{b1})); 2); 2), Neg(Div(Pow(Add(t, Neg(t_{b1})); 4); Mul(4, Pow(t_{smooth}; 2)))), Neg(Div(Pow(Add(t, Neg(t_{b1})); 5); Mul(10, Pow(t_{smooth}; 3))))))), Mul(Call(\\dot{\\theta}; t_{b1}), Add(t, Neg(t_{b1}))), Call(\\theta; t_{b1})); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedRotation1DOF/prescribedRotation1DOF.rst",
    ),
    (
        "\\bar{L} = \\frac12 m(\\dot{r}^2+r^2 \\dot{\\theta}) - mgr\\cos \\theta + \\lambda(r-R)",
        "Chain(\\bar{L}, Add(Mul(Div(1; 2), m, Add(Pow(Call(\\dot{r}); 2), Mul(Pow(Call(r); 2), Call(\\dot{\\theta})))), Neg(Mul(m, g, Call(r), Call(cos; Call(\\theta)))), Mul(\\lambda, Add(Call(r), Neg(R)))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "m \\ddot{z} = k_p (z_d - z) + k_d (\\dot{z}_d - \\dot{z}).",
        "Chain(Mul(m, Call(\\ddot{z})), Add(Mul(k_p, Add(Call(z_d), Neg(Call(z)))), Mul(k_d, Add(Call(\\dot{z}_d), Neg(Call(\\dot{z}))))); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "\\exp(-\\pi i \\tau/12) \\eta(\\tau) = \\sum_{n=-\\infty}^{\\infty} (-1)^n q^{(3n^2-n)/2}",
        "Chain(Mul(Call(exp; Neg(Div(Mul(\\pi, i, \\tau); 12))), Call(\\eta; \\tau)), BigSum(n; Neg(Infinity()); Infinity(); Mul(Pow(Neg(1); n), Pow(q; Div(Add(Mul(3, Pow(n; 2)), Neg(n)); 2)))); =)",
        "fredrik-johansson/arb/doc/source/acb_modular.rst",
    ),
    (
        "a(t) = \\int_0^t b(\\tau) d\\tau",
        "Chain(Call(a; t), Integral(Call(b; \\tau); \\tau; 0; t); =)",
        "python-control/python-control/doc/examples/template.rst",
    ),
    (
        "z_{k+1}=Az_k+Bu_k +C",
        "Chain(z_{k+1}, Add(Mul(A, z_k), Mul(B, u_k), C); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/model_predictive_speed_and_steering_control/model_predictive_speed_and_steering_control_main.rst",
    ),
    (
        "\\boldsymbol{v}_{xyz} = v_x\\boldsymbol{\\hat{\\imath}} + v_y\\boldsymbol{\\hat{\\jmath}} + v_z\\boldsymbol{\\hat{k}}",
        "Chain(\\boldsymbol{v}_{xyz}, Add(Mul(v_x, \\boldsymbol{\\hat{\\imath}}), Mul(v_y, \\boldsymbol{\\hat{\\jmath}}), Mul(v_z, \\boldsymbol{\\hat{k}})); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "\\bar{\\bf H}^+ = \\bar{\\bf H}^T (\\bar{\\bf H} \\bar{\\bf H}^T)^{-1},",
        "Chain(\\bar { \\mathbf { H } } ^ { + }, Mul(Transpose(\\bar{\\mathbf{H}}), Pow(Mul(\\bar{\\mathbf{H}}, Transpose(\\bar{\\mathbf{H}})); Neg(1))); =)",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\alpha_2 = f_d - \\sqrt{f_d^2 - 2f_d f_k + f_k - 0.25}",
        "Chain(\\alpha_2, Add(f_d, Neg(Sqrt(Add(Pow(f_d; 2), Neg(Mul(2, f_d, f_k)), f_k, Neg(0.25))))); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\omega = \\varpi - \\Omega",
        "Chain(\\omega, Add(\\varpi, Neg(\\Omega)); =)",
        "bryanwweber/orbital-mechanics-notes/reference/planetary-ephemeris.md",
    ),
    (
        "g''(z) = \\frac{N+1}{2} \\left( \\frac{\\nu}{1-\\nu z} \\right) g'(z) + \\frac{(N+1)N}{2} \\left( \\frac{\\nu}{1-\\nu z} \\right)^2 g(z)",
        "Chain(Call(g''; z), Add(Mul(Div(Add(N, 1); 2), Div(\\nu; Add(1, Neg(Mul(\\nu, z)))), Call(g'; z)), Mul(Div(Mul(Add(N, 1), N); 2), Pow(Div(\\nu; Add(1, Neg(Mul(\\nu, z)))); 2), Call(g; z))); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{R}^T(^L_G\\mathbf{q})\\,^L\\mathbf{a} &=& \\,^G\\mathbf{g} \\\\ && \\\\ \\mathbf{R}^T(^L_G\\mathbf{q})\\,^L\\mathbf{m} &=& \\,^G\\mathbf{h} \\end{array}",
        "System(Chain(Mul(Transpose(Call(\\mathbf{R}; \\prescript { L } { G } { \\mathbf { q } })), \\prescript { L } { } { \\mathbf { a } }), \\prescript { G } { } { \\mathbf { g } }; =), Chain(Mul(Transpose(Call(\\mathbf{R}; \\prescript { L } { G } { \\mathbf { q } })), \\prescript { L } { } { \\mathbf { m } }), \\prescript { G } { } { \\mathbf { h } }; =))",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "n_1 = \\frac{{\\ln \\left({{{\\Delta P_{{l}}}/ {\\Delta P_{{lo}}}}} \\right)}}{{\\ln \\left({1 - x} \\right)}}",
        "Chain(n_1, Div(Call(ln; Div(\\Delta P _ { l }; \\Delta P _ { l o })); Call(ln; Add(1, Neg(x)))); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "\\boldsymbol{r}_{O'} = \\boldsymbol{r}_O + \\boldsymbol{E}\\boldsymbol{U}\\boldsymbol{x}_{O'}",
        "Chain(\\boldsymbol{r}_{O'}, Add(\\boldsymbol{r}_O, Mul(\\boldsymbol{E}, \\boldsymbol{U}, \\boldsymbol{x}_{O'})); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "\\mathrm{g}(\\phi) = \\frac{ag_e \\cos^2\\phi + bg_p\\sin^2\\phi}{\\sqrt{a^2\\cos^2\\phi + b^2\\sin^2\\phi}}",
        "Chain(Call(\\text{g}; \\phi), Div(Add(Mul(a, g_e, Pow(Call(cos; \\phi); 2)), Mul(b, g_p, Pow(Call(sin; \\phi); 2))); Sqrt(Add(Mul(Pow(a; 2), Pow(Call(cos; \\phi); 2)), Mul(Pow(b; 2), Pow(Call(sin; \\phi); 2))))); =)",
        "Mayitzin/ahrs/ahrs/utils/wgs84.py",
    ),
    (
        "{\\vphantom{\\bm\\omega}}^{\\mathcal{B}\\!}{\\bm\\omega}_{R/N} = {\\vphantom{\\hat{\\bm s}}}^{\\mathcal{B}\\!}{\\hat{\\bm s}} \\dot\\theta",
        "Chain(\\prescript { \\mathcal { B } \\! } { } { \\bm { \\omega } } _ { R / N }, Mul(\\prescript { \\mathcal { B } \\! } { } { \\hat { \\bm { s } } }, Call(\\dot{\\theta})); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/sunSafePoint/_Documentation/secModelDescription.tex",
    ),
    (
        "M &\\in \\mathbb{R}^{(n+o+k) \\times (n+o+k)}\\\\ A &\\in \\mathbb{R}^{(n+o+k) \\times (n-l+o-m)}\\\\ B &\\in \\mathbb{R}^{(n+o+k) \\times s}",
        "System(Chain(M, Pow(\\mathbb{R}; Cross(Add(n, o, k); Add(n, o, k))); \\in), Chain(A, Pow(\\mathbb{R}; Cross(Add(n, o, k); Add(n, Neg(l), o, Neg(m)))); \\in), Chain(B, Pow(\\mathbb{R}; Cross(Add(n, o, k); s)); \\in))",
        "sympy/sympy/doc/src/explanation/modules/physics/mechanics/linearize.rst",
    ),
    (
        "\\begin{array}{rcl} \\hat{\\mathbf{f}} &=& \\begin{bmatrix}\\hat{f}_x & \\hat{f}_y & \\hat{f}_z \\end{bmatrix}^T = \\hat{\\mathbf{q}}^{-1}\\mathbf{g_q}\\hat{\\mathbf{q}} \\\\ && \\\\ \\hat{\\mathbf{h}} &=& \\begin{bmatrix}\\hat{h}_x & \\hat{h}_y & \\hat{h}_z \\end{bmatrix}^T = \\hat{\\mathbf{q}}^{-1}\\mathbf{m_q}\\hat{\\mathbf{q}} \\end{array}",
        "System(Chain(\\hat{\\mathbf{f}}, Transpose(MatrixOf(\\hat{f}_x, \\hat{f}_y, \\hat{f}_z)), Mul(Pow(\\hat{\\mathbf{q}}; Neg(1)), \\mathbf{g}_q, \\hat{\\mathbf{q}}); =, =), Chain(\\hat{\\mathbf{h}}, Transpose(MatrixOf(\\hat{h}_x, \\hat{h}_y, \\hat{h}_z)), Mul(Pow(\\hat{\\mathbf{q}}; Neg(1)), \\mathbf{m}_q, \\hat{\\mathbf{q}}); =, =))",
        "Mayitzin/ahrs/ahrs/filters/fourati.py",
    ),
    (
        "\\begin{aligned} u_1' \\cos x \\sin x + u_2' \\sin^2 x & = 0 ,\\\\ -u_1' \\sin x \\cos x + u_2' \\cos^2 x & = \\tan x \\cos x = \\sin x . \\end{aligned}",
        "System(Chain(Add(Mul(u_1', Call(cos; x), Call(sin; x)), Mul(u_2', Pow(Call(sin; x); 2))), 0; =), Chain(Add(Neg(Mul(u_1', Call(sin; x), Call(cos; x))), Mul(u_2', Pow(Call(cos; x); 2))), Mul(Call(tan; x), Call(cos; x)), Call(sin; x); =, =))",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "\\zeta(z, \\tau) = \\frac{1}{z} + \\sum_{n^2+m^2 \\ne 0} \\left[ \\frac{1}{z-m-n\\tau} + \\frac{1}{m+n\\tau} + \\frac{z}{(m+n\\tau)^2} \\right]",
        "Chain(Call(\\zeta; z, \\tau), Add(Div(1; z), Limiting(sum; _{ n ^ { 2 } + m ^ { 2 } \\ne 0 }; Add(Div(1; Add(z, Neg(m), Neg(Mul(n, \\tau)))), Div(1; Add(m, Mul(n, \\tau))), Div(z; Pow(Add(m, Mul(n, \\tau)); 2))))); =)",
        "fredrik-johansson/arb/doc/source/acb_elliptic.rst",
    ),
    (
        "\\mathbf{x}_{t+1} = f(\\mathbf{x}_t, \\mathbf{u}_t) = \\mathbf{F}\\mathbf{x}_t + \\mathbf{B}\\mathbf{u}_t",
        "Chain(\\mathbf{x}_{t+1}, Call(f; \\mathbf{x}_t, \\mathbf{u}_t), Add(Mul(\\mathbf{F}, \\mathbf{x}_t), Mul(\\mathbf{B}, \\mathbf{u}_t)); =, =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/ensamble_kalman_filter_localization_files/ensamble_kalman_filter_localization_main.rst",
    ),
    (
        "\\sigma = \\frac{\\lVert\\boldsymbol{r}*1\\rVert}{r*{12}} \\Rightarrow r_1 = r_{12}",
        "Implies(Chain(\\sigma, Div(Norm(Mul(\\boldsymbol{r}, 1)); Mul(r, 12)); =); Chain(r_1, r_{12}; =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/lagrange-points.md",
    ),
    (
        "E = \\frac{\\mu}{2a}",
        "Chain(E, Div(\\mu; Mul(2, a)); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/hyperbolic-trajectories.md",
    ),
    (
        "[colback=white,colframe=black,boxrule=0.5pt,top=1.5pt,bottom=1.5pt]{~~ u(x,t) = \\sum_{n=1}^\\infty b_n u_n(x,t) = \\sum_{n=1}^\\infty b_n \\sin \\left( \\frac{n \\pi}{L} x \\right) e^{\\frac{-n^2 \\pi^2}{L^2} k t} . ~~}",
        "Chain(Call(u; x, t), BigSum(n; 1; Infinity(); Mul(b_n, Call(u_n; x, t))), BigSum(n; 1; Infinity(); Mul(b_n, Call(sin; Mul(Div(Mul(n, \\pi); L), x)), Pow(e; Mul(Div(Neg(Mul(Pow(n; 2), Pow(\\pi; 2))); Pow(L; 2)), k, t)))); =, =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "M_E(q) \\ddot{p}^E + C_E(q,\\dot{q})\\dot{q} + K_p(p^{E} - p^{E_d}) + K_d(\\dot{p}^{E} - \\dot{p}^{E_d}) = f^{B_E}_{ext}.",
        "Chain(Add(Mul(Call(M_E; Call(q)), Call(\\ddot { p } ^ { E })), Mul(Call(C_E; Call(q), Call(\\dot{q})), Call(\\dot{q})), Mul(K_p, Add(Call(p ^ { E }), Neg(Call(p ^ { E _ { d } })))), Mul(K_d, Add(Call(\\dot { p } ^ { E }), Neg(Call(\\dot { p } ^ { E _ { d } }))))), f _ { e x t } ^ { B _ { E } }; =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "\\mu_t = \\alpha\\|\\,\\dot{\\mathbf{q}}_{\\omega, t}\\|\\Delta t",
        "Chain(\\mu_t, Mul(\\alpha, Norm(Call(\\dot{\\mathbf{q}}_{\\omega,t})), \\Delta t); =)",
        "Mayitzin/ahrs/ahrs/filters/madgwick.py",
    ),
    (
        "{\\bf M}({\\bf q})\\ddot{\\bf q} + {\\bf C}({\\bf q},\\dot{\\bf q})\\dot{\\bf q} = {\\bf \\tau}_g(q) + {\\bf B}{\\bf u},",
        "Chain(Add(Mul(Call(\\mathbf{M}; Call(\\mathbf{q})), Call(\\ddot{\\mathbf{q}})), Mul(Call(\\mathbf{C}; Call(\\mathbf{q}), Call(\\dot{\\mathbf{q}})), Call(\\dot{\\mathbf{q}}))), Add(Call(\\mathbf{\\tau}_g; Call(q)), Mul(\\mathbf{B}, \\mathbf{u})); =)",
        "RussTedrake/underactuated/book/simple_legs.html",
    ),
    (
        "f(k) := \\frac{\\lambda^{k} e^{- \\lambda}}{k!}",
        "Chain(Call(f; k), Div(Mul(Pow(\\lambda; k), Pow(e; Neg(\\lambda))); Factorial(k)); =)",
        "sympy/sympy/sympy/stats/drv_types.py",
    ),
    (
        "|F(k)| \\le \\frac{k (k-D)}{(k-C)(k-2D)} = \\left(1 + \\frac{C}{k-C} \\right) \\left(1 + \\frac{D}{k-2D} \\right).",
        "Chain(Bars(Call(F; k)), Div(Mul(k, Add(k, Neg(D))); Mul(Add(k, Neg(C)), Add(k, Neg(Mul(2, D))))), Mul(Add(1, Div(C; Add(k, Neg(C)))), Add(1, Div(D; Add(k, Neg(Mul(2, D)))))); \\le, =)",
        "fredrik-johansson/arb/doc/source/hypgeom.rst",
    ),
    (
        "W = mg",
        "Chain(W, Mul(m, g); =)",
        "bryanwweber/orbital-mechanics-notes/intro/mass-force-and-newtons-law-of-gravitation.md",
    ),
    (
        "{\\bf n} {\\bf v}^+ - {\\bf n}{\\bf v}^- = {\\bf n} {\\bf M}^{-1} {\\bf n}^T \\int_{t_c^-}^{t_c^+} \\lambda dt.",
        "Chain(Add(Mul(\\mathbf{n}, \\mathbf { v } ^ { + }), Neg(Mul(\\mathbf{n}, \\mathbf { v } ^ { - }))), Mul(\\mathbf{n}, Pow(\\mathbf{M}; Neg(1)), Transpose(\\mathbf{n}), Integral(\\lambda; t; t _ { c } ^ { - }; t _ { c } ^ { + })); =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "S_n(a,b) = \\sum_{k=a}^{b-1} k^n.",
        "Chain(Call(S_n; a, b), BigSum(k; a; Add(b, Neg(1)); Pow(k; n)); =)",
        "fredrik-johansson/arb/doc/source/arb.rst",
    ),
    (
        "e = \\sqrt{1 + \\frac{h^2}{\\mu}\\left(v^2 - \\frac{2\\mu}{r}\\right)}",
        "Chain(e, Sqrt(Add(1, Mul(Div(Pow(h; 2); \\mu), Add(Pow(v; 2), Neg(Div(Mul(2, \\mu); r)))))); =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/orbital-elements-and-the-state-vector.md",
    ),
    (
        "&= x^{1/k} \\min(1, \\log(1+r/(x-r))/k).",
        "Chain(Blank(), Mul(Pow(x; Div(1; k)), Call(min; 1, Div(Call(log; Add(1, Div(r; Add(x, Neg(r))))); k))); =)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "{\\vphantom{\\bm v}}^{\\mathcal{N}\\!}{\\bm v}_{C/N} = \\begin{cases} +v \\ {\\vphantom{\\hat{\\bm\\imath}}}^{\\mathcal{N}\\!}{\\hat{\\bm\\imath}}_{r} & 0 \\le E \\le \\pi \\\\ -v \\ {\\vphantom{\\hat{\\bm\\imath}}}^{\\mathcal{N}\\!}{\\hat{\\bm\\imath}}_{r} & -\\pi \\le E \\le 0 \\end{cases}",
        "Chain(\\prescript { \\mathcal { N } \\! } { } { \\bm { v } } _ { C / N }, Piecewise(Mul(v, \\prescript { \\mathcal { N } \\! } { } { \\hat { \\bm { \\imath } } } _ { r }), Chain(0, E, \\pi; \\le, \\le), Neg(Mul(v, \\prescript { \\mathcal { N } \\! } { } { \\hat { \\bm { \\imath } } } _ { r })), Chain(Neg(\\pi), E, 0; \\le, \\le)); =)",
        "AVSLab/basilisk/src/architecture/utilitiesSelfCheck/_Documentation/secModelDescription.tex",
    ),
    (
        "\\mathbf{M}_d = -\\mathbf{T}^T \\mathbf{M} \\mathbf{T}",
        "Chain(\\mathbf{M}_d, Neg(Mul(Transpose(\\mathbf{T}), \\mathbf{M}, \\mathbf{T})); =)",
        "moorepants/learn-multibody-dynamics/tmt.rst",
    ),
    (
        "\\operatorname{erf}(z) &= \\frac{2z e^{-z^2}}{\\sqrt{\\pi}} {}_1F_1(1, \\tfrac{3}{2}, z^2)",
        "Chain(Call(erf; z), Mul(Div(Mul(2, z, Pow(e; Neg(Pow(z; 2)))); Sqrt(\\pi)), Call(\\prescript { } { 1 } { F } _ { 1 }; 1, Div(3; 2), Pow(z; 2))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "v_0^2 \\geqslant \\frac{2g \\big[(R_1-R_2)\\cot \\alpha - h\\big]R_1^2}{R_1^2 - (R_2 + h\\tan \\alpha)^2}",
        "Chain(Pow(v_0; 2), Div(Mul(2, g, Add(Mul(Add(R_1, Neg(R_2)), Call(cot; \\alpha)), Neg(h)), Pow(R_1; 2)); Add(Pow(R_1; 2), Neg(Pow(Add(R_2, Mul(h, Call(tan; \\alpha))); 2)))); \\ge)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "v_{gm} = 0",
        "Chain(v_{gm}, 0; =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "I_{\\text{V}_{g_i}}(\\hat{\\bm g}_{\\text{g}_i}^T\\dot{\\bm{\\omega}} + \\ddot{\\gamma}_i) = u_{\\text{g}_i} + (I_{\\text{V}_{s_i}}-I_{\\text{V}_{t_i}})\\omega_s\\omega_t + I_{\\text{W}_{s_i}}\\Omega_i\\omega_t",
        "Chain(Mul(I_{V_g_i}, Add(Mul(Transpose(\\hat{\\bm{g}}_{g_i}), Call(\\dot{\\bm{\\omega}})), Call(\\ddot{\\gamma}_i))), Add(u_{g_i}, Mul(Add(I_{V_s_i}, Neg(I_{V_t_i})), \\omega_s, \\omega_t), Mul(I_{W_s_i}, \\Omega_i, \\omega_t)); =)",
        "AVSLab/basilisk/src/simulation/dynamics/VSCMGs/_Documentation/secModelDescription.tex",
    ),
    (
        "C \\frac{d v_2(t)}{dt} + \\frac{v_2(t) - v_1(t)}{R} = 0",
        "Chain(Add(Mul(C, Derivative(Call(v_2; t); t, 1)), Div(Add(Call(v_2; t), Neg(Call(v_1; t))); R)), 0; =)",
        "sympy/sympy/doc/src/tutorials/physics/control/electrical_problems.rst",
    ),
    (
        "\\sigma(\\theta) = \\frac{b(\\theta)}{\\sin \\theta} |b'(\\theta)| = \\frac{\\left(\\dfrac{\\alpha}{4E}\\right)^2}{\\sin^4 \\dfrac{\\theta}{2}}",
        "Chain(Call(\\sigma; \\theta), Mul(Div(Call(b; \\theta); Call(sin; \\theta)), Bars(Call(b'; \\theta))), Div(Pow(Div(\\alpha; Mul(4, E)); 2); Pow(Call(sin; Div(\\theta; 2)); 4)); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "y_p = A \\cos (2x) + B \\sin (2x) .",
        "Chain(y_p, Add(Mul(A, Call(cos; Mul(2, x))), Mul(B, Call(sin; Mul(2, x)))); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "\\bm F_{\\text{ext}} -m_{\\text{hub}} \\ddot{\\bm r}_{B_c/N} + \\sum\\limits_{i}^{N_S} \\Big( -m_{\\text{sp}_{i1}} \\ddot{\\bm{r}}_{S_{c,{i1}}/N} -m_{\\text{sp}_{i2}} \\ddot{\\bm{r}}_{S_{c,{i2}}/N}\\Big) = 0",
        "Chain(Add(\\bm{F}_{ext}, Neg(Mul(m_{hub}, Call(\\ddot{\\bm{r}}_{B_c/N}))), Limiting(sum; _{ i }^{ N _ { S } }; Add(Neg(Mul(m_{sp_i1}, Call(\\ddot{\\bm{r}}_{S_c,i1/N}))), Neg(Mul(m_{sp_i2}, Call(\\ddot{\\bm{r}}_{S_c,i2/N})))))), 0; =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "p_{\\text{bMDP}}({\\bf b}'|{\\bf b}, a) = \\sum_{i \\in |O|} p({\\bf b}'| {\\bf b}, a, o_i) p_{o |b,a}(o_i | {\\bf b}, a) = \\sum_{i \\in |O|} p({\\bf b}'| {\\bf b}, a, o_i) {\\bf c}^T(o_i) \\, {\\bf T}(a) \\, {\\bf b},",
        "Chain(Call(p_{bMDP}; Given(\\mathbf{b}'; \\mathbf{b}, a; |)), Limiting(sum; _{ i \\in | O | }; Mul(Call(p; Given(\\mathbf{b}'; \\mathbf{b}, a, o_i; |)), Call(p_{o|b,a}; Given(o_i; \\mathbf{b}, a; |)))), Limiting(sum; _{ i \\in | O | }; Mul(Call(p; Given(\\mathbf{b}'; \\mathbf{b}, a, o_i; |)), Transpose(Call(\\mathbf{c}; o_i)), Call(\\mathbf{T}; a), \\mathbf{b})); =, =)",
        "RussTedrake/underactuated/book/output_feedback.html",
    ),
    (
        "\\bar{F} = \\begin{bmatrix} \\bar{R}^{B_{1o}} \\cdot \\hat{n}_x \\\\ \\bar{R}^{B_{1o}} \\cdot \\hat{n}_y \\\\ \\bar{R}^{B_{1o}} \\cdot \\hat{n}_z \\\\ \\bar{T}^{B_1} \\cdot \\hat{n}_x \\\\ \\bar{T}^{B_1} \\cdot \\hat{n}_y \\\\ \\bar{T}^{B_1} \\cdot \\hat{n}_z \\\\ \\vdots \\\\ \\bar{R}^{B_{2o}} \\cdot \\hat{n}_x \\\\ \\bar{R}^{B_{2o}} \\cdot \\hat{n}_y \\\\ \\bar{R}^{B_{2o}} \\cdot \\hat{n}_z \\\\ \\bar{T}^{B_2} \\cdot \\hat{n}_x \\\\ \\bar{T}^{B_2} \\cdot \\hat{n}_y \\\\ \\bar{T}^{B_2} \\cdot \\hat{n}_z \\\\ \\end{bmatrix}",
        "Chain(\\bar{F}, MatrixOf(Mul(\\bar { R } ^ { B _ { 1 o } }, \\hat{n}_x; 1), Mul(\\bar { R } ^ { B _ { 1 o } }, \\hat{n}_y; 1), Mul(\\bar { R } ^ { B _ { 1 o } }, \\hat{n}_z; 1), Mul(\\bar { T } ^ { B _ { 1 } }, \\hat{n}_x; 1), Mul(\\bar { T } ^ { B _ { 1 } }, \\hat{n}_y; 1), Mul(\\bar { T } ^ { B _ { 1 } }, \\hat{n}_z; 1), Dots(), Mul(\\bar { R } ^ { B _ { 2 o } }, \\hat{n}_x; 1), Mul(\\bar { R } ^ { B _ { 2 o } }, \\hat{n}_y; 1), Mul(\\bar { R } ^ { B _ { 2 o } }, \\hat{n}_z; 1), Mul(\\bar { T } ^ { B _ { 2 } }, \\hat{n}_x; 1), Mul(\\bar { T } ^ { B _ { 2 } }, \\hat{n}_y; 1), Mul(\\bar { T } ^ { B _ { 2 } }, \\hat{n}_z; 1)); =)",
        "moorepants/learn-multibody-dynamics/tmt.rst",
    ),
    (
        "\\left.\\frac{\\mathrm{d}^2 U}{\\mathrm{d} r^2}\\right|_{r=r_m} = \\frac{3(l^2+cm)}{mr_m^4} - \\frac{2k}{r_m^3} = \\frac{l^2+cm}{mr_m^4} > 0",
        "Chain(Evaluated(Derivative(Call(U); r, 2); r; r_m), Add(Div(Mul(3, Add(Pow(l; 2), Mul(c, m))); Mul(m, Pow(r_m; 4))), Neg(Div(Mul(2, k); Pow(r_m; 3)))), Div(Add(Pow(l; 2), Mul(c, m)); Mul(m, Pow(r_m; 4))), 0; =, =, >)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "\\overline{r}_{\\nu} = a\\sqrt{1 - e^2} = b = \\sqrt{r_p r_a}",
        "Chain(\\overline{r}_\\nu, Mul(a, Sqrt(Add(1, Neg(Pow(e; 2))))), b, Sqrt(Mul(r_p, r_a)); =, =, =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/elliptical-orbits.md",
    ),
    (
        "\\langle \\, f(t)\\, , \\, g(t) \\, \\rangle \\overset{\\text{def}}{=} \\int_{-\\pi}^\\pi f(t) \\, g(t) \\, dt .",
        "Chain(Pair(Call(f; t); Call(g; t)), Integral(Mul(Call(f; t), Call(g; t)); t; Neg(\\pi); \\pi); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "{}^A\\text{v}^C =& {}^A\\text{v}^B + {}^A\\dot{R}^B {}^Bp^C + {}^AR^B {}^B\\text{v}^C \\\\ =& {}^A\\text{v}^B_A + {}^A\\dot{R}^B {}^BR^A {}^Bp^C_A + {}^B\\text{v}^C_A.",
        "Chain(\\prescript { A } { } { \\text { v } } ^ { C }, Add(\\prescript { A } { } { \\text { v } } ^ { B }, Mul(Call(\\prescript { A } { } { \\dot { R } } ^ { B }), \\prescript { B } { } { p } ^ { C }), Mul(Call(\\prescript { A } { } { R } ^ { B }), \\prescript { B } { } { \\text { v } } ^ { C })), Add(\\prescript { A } { } { \\text { v } } _ { A } ^ { B }, Mul(Call(\\prescript { A } { } { \\dot { R } } ^ { B }), \\prescript { B } { } { R } ^ { A }, \\prescript { B } { } { p } _ { A } ^ { C }), \\prescript { B } { } { \\text { v } } _ { A } ^ { C }); =, =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "& \\dot{x} = Ax + Bu \\\\ & y = Cx + Du",
        "System(Chain(Call(\\dot{x}), Add(Mul(A, Call(x)), Mul(B, u)); =), Chain(y, Add(Mul(C, Call(x)), Mul(D, u)); =))",
        "AtsushiSakai/PythonRobotics/docs/modules/10_inverted_pendulum/inverted_pendulum_main.rst",
    ),
    (
        "R_G(x,y,z) = \\frac{1}{4} \\int_0^{\\infty} \\frac{t}{\\sqrt{(t+x)(t+y)(t+z)}} \\left( \\frac{x}{t+x} + \\frac{y}{t+y} + \\frac{z}{t+z}\\right) dt",
        "Chain(Call(R_G; x, y, z), Mul(Div(1; 4), Integral(Mul(Div(t; Sqrt(Mul(Add(t, x), Add(t, y), Add(t, z)))), Add(Div(x; Add(t, x)), Div(y; Add(t, y)), Div(z; Add(t, z)))); t; 0; Infinity())); =)",
        "fredrik-johansson/arb/doc/source/acb_elliptic.rst",
    ),
    (
        "\\Phi(z,s,a) = \\sum_{k=0}^{\\infty} \\frac{z^k}{(k+a)^s}",
        "Chain(Call(\\Phi; z, s, a), BigSum(k; 0; Infinity(); Div(Pow(z; k); Pow(Add(k, a); s))); =)",
        "fredrik-johansson/arb/doc/source/acb_dirichlet.rst",
    ),
    (
        "\\begin{cases} v_x = C_1 \\mathrm{e}^{-\\frac{t}{\\tau}} \\\\ v_y = C_2 \\mathrm{e}^{-\\frac{t}{\\tau}} \\end{cases}",
        "System(Chain(v_x, Mul(C_1, Pow(\\text{e}; Neg(Div(t; \\tau)))); =), Chain(v_y, Mul(C_2, Pow(\\text{e}; Neg(Div(t; \\tau)))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "a_2 = kD\\cos\\alpha",
        "Chain(a_2, Mul(k, D, Call(cos; \\alpha)); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "{\\bf x}[1] &= {\\bf A}{\\bf x}_0 + {\\bf B}{\\bf K}_0{\\bf x}_0, \\\\ {\\bf x}[2] &= {\\bf A}({\\bf A} + {\\bf BK}_0){\\bf x}_0 + {\\bf BK}_1({\\bf A} + {\\bf BK}_0){\\bf x}_0 \\\\ {\\bf x}[n] &= \\left( \\prod_{i=0}^{n-1} ({\\bf A} + {\\bf BK}_i) \\right) {\\bf x}_0",
        "System(Chain(Indexed(\\mathbf{x}; 1), Add(Mul(\\mathbf{A}, \\mathbf{x}_0), Mul(\\mathbf{B}, \\mathbf{K}_0, \\mathbf{x}_0)); =), Chain(Indexed(\\mathbf{x}; 2), Add(Mul(\\mathbf{A}, Add(\\mathbf{A}, Mul(\\mathbf{B}, \\mathbf{K}_0)), \\mathbf{x}_0), Mul(\\mathbf{B}, \\mathbf{K}_1, Add(\\mathbf{A}, Mul(\\mathbf{B}, \\mathbf{K}_0)), \\mathbf{x}_0)); =), Chain(Indexed(\\mathbf{x}; n), Mul(BigProduct(i; 0; Add(n, Neg(1)); Add(\\mathbf{A}, Mul(\\mathbf{B}, \\mathbf{K}_i))), \\mathbf{x}_0); =))",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "T = \\frac{2\\pi r}{\\sqrt{\\mu/r}} = \\frac{2\\pi}{\\sqrt{\\mu}}r^{3/2}",
        "Chain(T, Div(Mul(2, \\pi, r); Sqrt(Div(\\mu; r))), Mul(Div(Mul(2, \\pi); Sqrt(\\mu)), Pow(r; Div(3; 2))); =, =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/circular-orbits.md",
    ),
    (
        "k_j(\\tau) \\, k_i(\\tau) = e^{-\\tilde{c}\\,\\tau}\\,[ \\tilde{a}_+\\,\\cos(\\tilde{d}_+\\,\\tau) + \\tilde{b}_+\\,\\sin(\\tilde{d}_+\\,\\tau) + \\tilde{a}_-\\,\\cos(\\tilde{d}_-\\,\\tau) + \\tilde{b}_-\\,\\sin(\\tilde{d}_-\\,\\tau) ]",
        "Chain(Mul(Call(k_j; \\tau), Call(k_i; \\tau)), Mul(Pow(e; Neg(Mul(\\tilde{c}, \\tau))), Add(Mul(\\tilde{a}_+, Call(cos; Mul(\\tilde{d}_+, \\tau))), Mul(\\tilde{b}_+, Call(sin; Mul(\\tilde{d}_+, \\tau))), Mul(\\tilde{a}_-, Call(cos; Mul(\\tilde{d}_-, \\tau))), Mul(\\tilde{b}_-, Call(sin; Mul(\\tilde{d}_-, \\tau))))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "B = 1 - \\frac{\\pi^2 d_p}{24D_t}\\left(1 - \\frac{0.5d_p}{D_t}\\right)",
        "Chain(B, Add(1, Neg(Mul(Div(Mul(Pow(\\pi; 2), d_p); Mul(24, D_t)), Add(1, Neg(Div(Mul(0.5, d_p); D_t)))))); =)",
        "CalebBell/fluids/fluids/packed_bed.py",
    ),
    (
        "h_t = \\sqrt{\\mu r_1 (1 - e)} = \\sqrt{\\mu r_3 (1 + e)}",
        "Chain(h_t, Sqrt(Mul(\\mu, r_1, Add(1, Neg(e)))), Sqrt(Mul(\\mu, r_3, Add(1, e))); =, =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/comparison-of-bielliptic-and-hohmann.md",
    ),
    (
        "x' = A\\sqrt{-\\lambda}\\, \\sinh \\bigl( \\sqrt{-\\lambda}\\, t\\bigr) + B\\sqrt{-\\lambda}\\, \\cosh \\bigl( \\sqrt{-\\lambda}\\, t \\bigr) .",
        "Chain(x', Add(Mul(A, Sqrt(Neg(\\lambda)), Call(sinh; Mul(Sqrt(Neg(\\lambda)), t))), Mul(B, Sqrt(Neg(\\lambda)), Call(cosh; Mul(Sqrt(Neg(\\lambda)), t)))); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "P^{-}_{k+1}\\leftarrow P^{-}_{k+1} + P_{proc}",
        "Chain(P _ { k + 1 } ^ { - }, Add(P _ { k + 1 } ^ { - }, P_{proc}); \\leftarrow)",
        "AVSLab/basilisk/src/fswAlgorithms/smallBodyNavigation/smallBodyNavUKF/smallBodyNavUKF.rst",
    ),
    (
        "\\begin{bmatrix} x \\\\ y \\end{bmatrix} = \\begin{bmatrix} \\frac{e^{3t}+e^{-t}}{2} & \\frac{e^{3t}-e^{-t}}{2} \\\\ \\frac{e^{3t}-e^{-t}}{2} & \\frac{e^{3t}+e^{-t}}{2} \\end{bmatrix} \\begin{bmatrix} 4 \\\\ 2 \\end{bmatrix} = \\begin{bmatrix} 2e^{3t}+2e^{-t} + e^{3t}-e^{-t} \\\\ 2e^{3t}-2e^{-t} + e^{3t}+e^{-t} \\end{bmatrix} = \\begin{bmatrix} 3e^{3t}+e^{-t} \\\\ 3e^{3t}-e^{-t} \\end{bmatrix} .",
        "Chain(MatrixOf(x, y), Mul(MatrixOf(Div(Add(Pow(e; Mul(3, t)), Pow(e; Neg(t))); 2), Div(Add(Pow(e; Mul(3, t)), Neg(Pow(e; Neg(t)))); 2), Div(Add(Pow(e; Mul(3, t)), Neg(Pow(e; Neg(t)))); 2), Div(Add(Pow(e; Mul(3, t)), Pow(e; Neg(t))); 2)), MatrixOf(4, 2)), MatrixOf(Add(Mul(2, Pow(e; Mul(3, t))), Mul(2, Pow(e; Neg(t))), Pow(e; Mul(3, t)), Neg(Pow(e; Neg(t)))), Add(Mul(2, Pow(e; Mul(3, t))), Neg(Mul(2, Pow(e; Neg(t)))), Pow(e; Mul(3, t)), Pow(e; Neg(t)))), MatrixOf(Add(Mul(3, Pow(e; Mul(3, t))), Pow(e; Neg(t))), Add(Mul(3, Pow(e; Mul(3, t))), Neg(Pow(e; Neg(t))))); =, =, =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\nu_{\\infty} = \\cos^{-1}\\left(-1/e\\right)",
        "Chain(\\nu_\\infty, Call(arccos; Neg(Div(1; e))); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/hyperbolic-trajectories.md",
    ),
    (
        "\\mathrm{sn}\\, x \\to \\sin x",
        "Chain(Call(sn; x), Call(sin; x); \\to)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/appendixA.tex",
    ),
    (
        "{\\bf m}(s) &= {\\bf M}({\\bf r}(s)){\\bf r}'(s), \\\\ {\\bf c}(s) &= {\\bf M}({\\bf r}(s)){\\bf r}''(s) + {\\bf C}({\\bf r}(s), {\\bf r}'(s)) {\\bf r}'(s), \\\\ \\bar{\\bf \\tau}_g(s) &= {\\bf \\tau}_g({\\bf r}(s)).",
        "System(Chain(Call(\\mathbf{m}; s), Mul(Call(\\mathbf{M}; Call(\\mathbf{r}; s)), Call(\\mathbf{r}'; s)); =), Chain(Call(\\mathbf{c}; s), Add(Mul(Call(\\mathbf{M}; Call(\\mathbf{r}; s)), Call(\\mathbf{r}''; s)), Mul(Call(\\mathbf{C}; Call(\\mathbf{r}; s), Call(\\mathbf{r}'; s)), Call(\\mathbf{r}'; s))); =), Chain(Call(\\bar{\\mathbf{\\tau}}_g; s), Call(\\mathbf{\\tau}_g; Call(\\mathbf{r}; s)); =))",
        "RussTedrake/manipulation/book/trajectories.html",
    ),
    (
        "\\ddot{\\boldsymbol{r}} = \\left(\\ddot{x} - 2\\varOmega\\dot{y} - \\varOmega^2 x\\right)\\boldsymbol{\\hat{\\imath}} + \\left(\\ddot{y} + 2\\varOmega\\dot{x} - \\varOmega^2 y\\right)\\boldsymbol{\\hat{\\jmath}} + \\ddot{z}\\boldsymbol{\\hat{k}}",
        "Chain(Call(\\ddot{\\boldsymbol{r}}), Add(Mul(Add(Call(\\ddot{x}), Neg(Mul(2, \\varOmega, Call(\\dot{y}))), Neg(Mul(Pow(\\varOmega; 2), Call(x)))), \\boldsymbol{\\hat{\\imath}}), Mul(Add(Call(\\ddot{y}), Mul(2, \\varOmega, Call(\\dot{x})), Neg(Mul(Pow(\\varOmega; 2), Call(y)))), \\boldsymbol{\\hat{\\jmath}}), Mul(Call(\\ddot{z}), \\boldsymbol{\\hat{k}})); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "\\operatorname{\\textrm{minimize}}_{\\bf z} \\ell({\\bf z}) \\quad \\textrm{subject to} \\quad {\\bf \\phi}({\\bf z}) = 0,",
        "System(Words(Limiting(min; _{ \\mathbf { z } }; Call(\\ell; \\mathbf{z}))), Words(\\text{subject~to}), Chain(Call(\\mathbf{\\phi}; \\mathbf{z}), 0; =))",
        "RussTedrake/underactuated/book/optimization.html",
    ),
    (
        "\\epsilon = 1 - \\frac{\\frac{m_{mesh}}{\\frac{\\pi}{4}d_{column}^2 L_{mesh}}}{\\rho_{material}}",
        "Chain(\\epsilon, Add(1, Neg(Div(Div(m_{mesh}; Mul(Div(\\pi; 4), Pow(d_{column}; 2), L_{mesh})); \\rho_{material}))); =)",
        "CalebBell/fluids/fluids/packed_tower.py",
    ),
    (
        "V_f = A_fL + \\pi a h^2\\left(1 - \\frac{h}{3R}\\right)",
        "Chain(V_f, Add(Mul(A_f, L), Mul(\\pi, a, Pow(h; 2), Add(1, Neg(Div(h; Mul(3, R)))))); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "-\\bar{F}^*_r = \\frac{\\mathrm{d}}{\\mathrm{d}t}\\left(\\frac{\\partial K}{\\partial \\dot{q}_r} \\right) - \\frac{\\partial K}{\\partial q_r}",
        "Chain(Neg(\\bar { F } _ { r } ^ { * }), Add(Derivative(Derivative(Call(K); \\dot{q}_r, 1; True); t, 1), Neg(Derivative(Call(K); q_r, 1; True))); =)",
        "moorepants/learn-multibody-dynamics/lagrange.rst",
    ),
    (
        "{\\mathcal P}_n^m(z) = \\frac{(z+1)^{m/2}}{(z-1)^{m/2}} \\mathbf{F}\\left(-n, n+1, 1-m, \\frac{1-z}{2}\\right).",
        "Chain(Call(\\mathcal { P } _ { n } ^ { m }; z), Mul(Div(Pow(Add(z, 1); Div(m; 2)); Pow(Add(z, Neg(1)); Div(m; 2))), Call(\\mathbf{F}; Neg(n), Add(n, 1), Add(1, Neg(m)), Div(Add(1, Neg(z)); 2))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "\\mathrm{adj}(\\mathbf{A}) = \\mathrm{det}(\\mathbf{A})\\mathbf{A}^T",
        "Chain(Call(adj; \\mathbf{A}), Mul(Call(det; \\mathbf{A}), Transpose(\\mathbf{A})); =)",
        "Mayitzin/ahrs/ahrs/common/dcm.py",
    ),
    (
        "y = \\sum_{k=0}^\\infty a_k x^k = \\sum_{n=0}^\\infty \\left( \\frac{a_0}{(2n)!} \\,x^{2n} + \\frac{a_1}{(2n+1)!} \\,x^{2n+1} \\right) = a_0 \\sum_{n=0}^\\infty \\frac{1}{(2n)!} \\,x^{2n} + a_1 \\sum_{n=0}^\\infty \\frac{1}{(2n+1)!} \\,x^{2n+1} .",
        "Chain(y, BigSum(k; 0; Infinity(); Mul(a_k, Pow(x; k))), BigSum(n; 0; Infinity(); Add(Mul(Div(a_0; Factorial(Mul(2, n))), Pow(x; Mul(2, n))), Mul(Div(a_1; Factorial(Add(Mul(2, n), 1))), Pow(x; Add(Mul(2, n), 1))))), Add(Mul(a_0, BigSum(n; 0; Infinity(); Mul(Div(1; Factorial(Mul(2, n))), Pow(x; Mul(2, n))))), Mul(a_1, BigSum(n; 0; Infinity(); Mul(Div(1; Factorial(Add(Mul(2, n), 1))), Pow(x; Add(Mul(2, n), 1)))))); =, =, =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "\\phi_{ch}^2 = 1 + (\\Gamma^2 -1)\\left\\{B x^{(2-n)/2} (1-x)^{(2-n)/2} + x^{2-n} \\right\\}",
        "Chain(Pow(\\phi_{ch}; 2), Add(1, Mul(Add(Pow(\\varGamma; 2), Neg(1)), Tuple(Add(Mul(B, Pow(x; Div(Add(2, Neg(n)); 2)), Pow(Add(1, Neg(x)); Div(Add(2, Neg(n)); 2))), Pow(x; Add(2, Neg(n)))); {}))); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "V(\\bm r_{B/P}) = \\frac{\\bm m \\cdot \\bm r_{B/P}}{|\\bm r_{B/P}|^{3}}",
        "Chain(Call(V; \\bm{r}_{B/P}), Div(Mul(\\bm{m}, \\bm{r}_{B/P}; 1); Pow(Bars(\\bm{r}_{B/P}); 3)); =)",
        "AVSLab/basilisk/src/simulation/environment/magneticFieldCenteredDipole/_Documentation/secModuleDescription.tex",
    ),
    (
        "{}^A\\bar{\\omega}^B = u_1\\hat{b}_x + u_2\\hat{b}_y + u_3\\hat{b}_z",
        "Chain(\\prescript { A } { } { \\bar { \\omega } } ^ { B }, Add(Mul(u_1, \\hat{b}_x), Mul(u_2, \\hat{b}_y), Mul(u_3, \\hat{b}_z)); =)",
        "moorepants/learn-multibody-dynamics/motion.rst",
    ),
    (
        "T_r = \\frac{1}{2} \\omega \\cdot \\mathbf{I^*} \\cdot \\omega",
        "Chain(T_r, Mul(Div(1; 2), \\omega, \\mathbf { I } ^ { * }, \\omega); =)",
        "sympy/sympy/doc/src/explanation/modules/physics/mechanics/masses.rst",
    ),
    (
        "\\frac{1}{2m}\\left[\\left(\\frac{\\partial W}{\\partial x}\\right)^2+ \\left(\\frac{\\partial W}{\\partial y}\\right)^2 + \\left(\\frac{\\partial W}{\\partial z}\\right)^2\\right] - \\frac{\\alpha}{r} = E",
        "Chain(Add(Mul(Div(1; Mul(2, m)), Add(Pow(Derivative(Call(W); x, 1; True); 2), Pow(Derivative(Call(W); y, 1; True); 2), Pow(Derivative(Call(W); z, 1; True); 2))), Neg(Div(\\alpha; r))), E; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\frac{d f(E)}{d E} = f'(E) = 1 - e\\cos E",
        "Chain(Derivative(Call(f; E); E, 1), Call(f'; E), Add(1, Neg(Mul(e, Call(cos; E)))); =, =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "\\min_{f^{B_C}_{finger,C}, \\, f^{B_A}_{ground,A}} \\quad& \\left| \\tau^{B_A}_{finger,W_y} - \\text{PID}(\\theta_d, \\hat\\theta) \\right|^2,\\\\ \\textrm{subject to} \\quad & f^{B_C}_{\\text{finger}, C_z} \\ge 0, \\qquad |f^{B_C}_{\\text{finger}, C_x}| \\le \\hat\\mu_C f^{B_C}_{\\text{finger}, C_z}, \\\\ & f^{B_A}_{\\text{ground}, A_z} \\ge 0, \\qquad |f^{B_A}_{\\text{ground}, A_x}| \\le \\hat\\mu_A f^{B_A}_{\\text{ground}, A_z}, \\\\ & f^{B_A}_{\\text{ground}, A} + \\hat{f}^{B_A}_{gravity, A} + f^{B_A}_{finger, A} = 0.",
        "System(Words(Limiting(min; _{ f _ { f i n g e r , C } ^ { B _ { C } } , \\, f _ { g r o u n d , A } ^ { B _ { A } } }; Pow(Bars(Add(\\tau _ { f i n g e r , W _ { y } } ^ { B _ { A } }, Neg(Call(\\text{PID}; \\theta_d, \\hat{\\theta})))); 2))), Words(\\text{subject~to}), Chain(f _ { \\text { f i n g e r } , C _ { z } } ^ { B _ { C } }, 0; \\ge), Chain(Bars(f _ { \\text { f i n g e r } , C _ { x } } ^ { B _ { C } }), Mul(\\hat{\\mu}_C, f _ { \\text { f i n g e r } , C _ { z } } ^ { B _ { C } }); \\le), Chain(f _ { \\text { g r o u n d } , A _ { z } } ^ { B _ { A } }, 0; \\ge), Chain(Bars(f _ { \\text { g r o u n d } , A _ { x } } ^ { B _ { A } }), Mul(\\hat{\\mu}_A, f _ { \\text { g r o u n d } , A _ { z } } ^ { B _ { A } }); \\le), Chain(Add(f _ { \\text { g r o u n d } , A } ^ { B _ { A } }, \\hat { f } _ { g r a v i t y , A } ^ { B _ { A } }, f _ { f i n g e r , A } ^ { B _ { A } }), 0; =))",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "V(x) = c_0 + c_1x_0 + c_2x_1 + c_3x_0^2 + c_4 x_0x_1 + c_5 x_1^2.",
        "Chain(Call(V; x), Add(c_0, Mul(c_1, x_0), Mul(c_2, x_1), Mul(c_3, Pow(x_0; 2)), Mul(c_4, x_0, x_1), Mul(c_5, Pow(x_1; 2))); =)",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "\\gamma_{\\mathrm{noise}} = (\\gamma_{\\textrm{li}} + n + b) f_{\\mathrm{scale}}",
        "Chain(\\gamma_{noise}, Mul(Add(\\gamma_{li}, n, b), f_{scale}); =)",
        "AVSLab/basilisk/src/simulation/sensors/coarseSunSensor/_Documentation/secModelDescription.tex",
    ),
    (
        "{}^{P} {\\bf r}_{S/P} = [PN] ( {}^{N} {\\bf r}_{S/N} - {}^{N} {\\bf r}_{P/N})",
        "Chain(\\prescript { P } { } { \\mathbf { r } } _ { S / P }, Mul([ P N ], Add(\\prescript { N } { } { \\mathbf { r } } _ { S / N }, Neg(\\prescript { N } { } { \\mathbf { r } } _ { P / N }))); =)",
        "AVSLab/basilisk/src/simulation/environment/spacecraftLocation/spacecraftLocation.rst",
    ),
    (
        "\\mathbf{x} := \\begin{bmatrix} \\mathbf{x}_1 \\\\ \\mathbf{x}_2 \\\\ \\vdots \\\\ \\mathbf{x}_N \\end{bmatrix} \\in \\mathbb{R}^{cN}",
        "Chain(\\mathbf{x}, MatrixOf(\\mathbf{x}_1, \\mathbf{x}_2, Dots(), \\mathbf{x}_N), Pow(\\mathbb{R}; Mul(c, N)); =, \\in)",
        "AtsushiSakai/PythonRobotics/docs/modules/4_slam/graph_slam/graphSLAM_formulation.rst",
    ),
    (
        "\\bar{f}_n(\\bar{u}_s, \\bar{u}_r, \\bar{q}, t) = \\mathbf{M}_n(\\bar{q}, t)\\bar{u}_r + \\bar{g}_n(\\bar{u}_s, \\bar{q}, t) = 0 \\in \\mathbb{R}^m",
        "Chain(Call(\\bar{f}_n; \\bar{u}_s, \\bar{u}_r, \\bar{q}, t), Add(Mul(Call(\\mathbf{M}_n; \\bar{q}, t), \\bar{u}_r), Call(\\bar{g}_n; \\bar{u}_s, \\bar{q}, t)), 0, Pow(\\mathbb{R}; m); =, =, \\in)",
        "moorepants/learn-multibody-dynamics/nonholonomic-eom.rst",
    ),
    (
        "\\hat x[k+1] = f(\\hat x[k], u[k], v[k]), \\quad k = 0, \\dots, N-1.",
        "System(Chain(Indexed(\\hat{x}; Add(k, 1)), Call(f; Indexed(\\hat{x}; k), Indexed(u; k), Indexed(v; k)); =), Values(k; 0, Dots(), Add(N, Neg(1))))",
        "python-control/python-control/doc/stochastic.rst",
    ),
    (
        "T = \\frac12 \\boldsymbol{\\omega}^{\\mathrm{T}} \\boldsymbol{I} \\boldsymbol{\\omega} = \\frac12 I_n \\omega^2",
        "Chain(T, Mul(Div(1; 2), Transpose(\\boldsymbol{\\omega}), \\boldsymbol{I}, \\boldsymbol{\\omega}), Mul(Div(1; 2), I_n, Pow(\\omega; 2)); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "E({\\bf x}) = \\frac{1}{2}\\dot{\\bf q}^T{\\bf M}\\dot{{\\bf q}} + U({\\bf x}).",
        "Chain(Call(E; \\mathbf{x}), Add(Mul(Div(1; 2), Transpose(Call(\\dot{\\mathbf{q}})), \\mathbf{M}, Call(\\dot{\\mathbf{q}})), Call(U; \\mathbf{x})); =)",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\frac{\\partial L}{\\partial {\\bf v}'}^T = {\\bf M}({\\bf v}' - {\\bf v}) - h{\\bf \\tau} - {\\bf J}_\\beta^T \\beta = 0.",
        "Chain(Transpose(Derivative(Call(L); \\mathbf{v}', 1; True)), Add(Mul(\\mathbf{M}, Add(\\mathbf{v}', Neg(\\mathbf{v}))), Neg(Mul(h, \\mathbf{\\tau})), Neg(Mul(Transpose(\\mathbf{J}_\\beta), \\beta))), 0; =, =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "\\begin{array}{ll} u_t = k u_{xx} & \\qquad \\text{for } \\; 0 < x < L \\text{ and } t > 0, \\\\ u(0,t) = u(L,t) , \\quad u_x(0,t) = u_x(L,t) & \\qquad \\text{for } \\; t > 0, \\\\ u(x,0) = f(x) & \\qquad \\text{for } \\; 0 < x < L . \\end{array}",
        "System(Implies(System(Chain(0, x, L; <, <), Chain(t, 0; >)); Chain(u_t, Mul(k, u_{xx}); =)), Implies(Chain(t, 0; >); System(Chain(Call(u; 0, t), Call(u; L, t); =), Chain(Call(u_x; 0, t), Call(u_x; L, t); =))), Implies(Chain(0, x, L; <, <); Chain(Call(u; x, 0), Call(f; x); =)))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\lim_{t \\rightarrow \\infty} {\\bf x}(t) = 0.",
        "Chain(Limiting(lim; _{ t \\rightarrow \\infty }; Call(\\mathbf{x}; t)), 0; =)",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\bm d = -K \\Delta\\bm\\Omega",
        "Chain(\\bm{d}, Neg(Mul(K, \\Delta \\bm { \\Omega })); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/rwNullSpace/_Documentation/secModuleDescription.tex",
    ),
    (
        "K = K_1 = K_2 = 8f_d",
        "Chain(K, K_1, K_2, Mul(8, f_d); =, =, =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "t'\\mathrm{d} L = \\sum_{\\alpha=1}^s p'_\\alpha \\mathrm{d} q_\\alpha + \\sum_{\\alpha=1}^s p_\\alpha t' \\mathrm{d} \\dot{q}_\\alpha - H' \\mathrm{d} t",
        "Chain(Mul(t', Total(L)), Add(BigSum(\\alpha; 1; s; Mul(p'_{\\alpha}, Total(Call(q_{\\alpha})))), BigSum(\\alpha; 1; s; Mul(p_{\\alpha}, t', Total(Call(\\dot{q}_{\\alpha})))), Neg(Mul(H', Total(t)))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "\\lambda_k = k^2 \\qquad \\text{with an eigenfunction} \\qquad x_k = \\sin (k t) \\qquad \\text{for all integers } k \\geq 1 .",
        "System(Chain(\\lambda_k, Pow(k; 2); =), Words(\\text{with~an~eigenfunction}), Chain(x_k, Call(sin; Mul(k, t)); =), Words(\\text{for~all~integers}), Chain(k, 1; \\ge))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "(mg\\cot \\alpha - 2\\pi T) \\delta x = 0",
        "Chain(Mul(Add(Mul(m, g, Call(cot; \\alpha)), Neg(Mul(2, \\pi, T))), \\delta x), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "y = \\left[X_1\\ Y_1\\ Z_1\\ X_2\\ Y_2\\ Z_2\\ \\dot{X}_1\\ \\dot{Y}_1\\ \\dot{Z_1}\\ \\dot{X}_2\\ \\dot{Y}_2\\ \\dot{Z}_2\\right]",
        "Chain(y, Tuple(Call(X_1), Call(Y_1), Call(Z_1), Call(X_2), Call(Y_2), Call(Z_2), Call(\\dot{X}_1), Call(\\dot{Y}_1), Call(\\dot{Z}_1), Call(\\dot{X}_2), Call(\\dot{Y}_2), Call(\\dot{Z}_2); []); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-inertial-numerical-solution.md",
    ),
    (
        "a_n(x) y^{(n)} + \\cdots + a_1(x)y' + a_0(x) y + B(x) = 0",
        "Chain(Add(Mul(Call(a_n; x), y ^ { ( n ) }), Dots(), Mul(Call(a_1; x), y'), Mul(Call(a_0; x), y), Call(B; x)), 0; =)",
        "sympy/sympy/sympy/solvers/ode/single.py",
    ),
    (
        "\\operatorname{Ci}(x) = \\gamma + \\log{x} + \\int_0^x \\frac{\\cos{t} - 1}{t} \\mathrm{d}t = -\\int_x^\\infty \\frac{\\cos{t}}{t} \\mathrm{d}t,",
        "Chain(Call(\\text{Ci}; x), Add(\\gamma, Call(log; x), Integral(Div(Add(Call(cos; t), Neg(1)); t); t; 0; x)), Neg(Integral(Div(Call(cos; t); t); t; x; Infinity())); =, =)",
        "sympy/sympy/sympy/functions/special/error_functions.py",
    ),
    (
        "\\mathbf{M}_b = \\begin{bmatrix} \\mathbf{q}_b & \\mathbf{r}_b & \\mathbf{s}_b \\end{bmatrix}",
        "Chain(\\mathbf{M}_b, MatrixOf(\\mathbf{q}_b, \\mathbf{r}_b, \\mathbf{s}_b); =)",
        "Mayitzin/ahrs/ahrs/filters/triad.py",
    ),
    (
        "K_{conv,2} = 0.0696[1+C_B(\\sin(\\alpha/2)-1)](1-\\beta^5)\\lambda^2 + (\\lambda-1)^2",
        "Chain(K_{conv,2}, Add(Mul(0.0696, Add(1, Mul(C_B, Add(Call(sin; Div(\\alpha; 2)), Neg(1)))), Add(1, Neg(Pow(\\beta; 5))), Pow(\\lambda; 2)), Pow(Add(\\lambda, Neg(1)); 2)); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "f(x) := \\alpha (x-\\beta)^2",
        "Chain(Call(f; x), Mul(\\alpha, Pow(Add(x, Neg(\\beta)); 2)); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "p = |r_m| = \\frac{l^2}{\\mu |\\alpha|},\\quad e = Ap",
        "System(Chain(p, Bars(r_m), Div(Pow(l; 2); Mul(\\mu, Bars(\\alpha))); =, =), Chain(e, Mul(A, p); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "\\frac{{}^Ad\\hat{b}_x}{dt} = \\left| {}^A\\bar{\\omega}^B \\right| \\left( {}^A\\hat{\\omega}^B \\times \\hat{b}_x \\right)",
        "Chain(Marked(Derivative(Call(\\hat{b}_x); t, 1); _{ A }), Mul(Bars(\\prescript { A } { } { \\bar { \\omega } } ^ { B }), Cross(\\prescript { A } { } { \\hat { \\omega } } ^ { B }; Call(\\hat{b}_x))); =)",
        "moorepants/learn-multibody-dynamics/angular.rst",
    ),
    (
        "{\\bf J}({\\bf \\alpha}_B) := \\begin{bmatrix} {\\bf \\Sigma}_B & {\\bf h}_B \\\\ {\\bf h}_B^T & m_B \\end{bmatrix} \\succ 0.",
        "Chain(Call(\\mathbf{J}; \\mathbf{\\alpha}_B), MatrixOf(\\mathbf{\\Sigma}_B, \\mathbf{h}_B, Transpose(\\mathbf{h}_B), m_B), 0; =, \\succ)",
        "RussTedrake/underactuated/book/sysid.html",
    ),
    (
        "\\begin{bmatrix} 2 & 0 \\\\ 0 & 1 \\end{bmatrix} {\\vec{x}}'' = \\begin{bmatrix} -2 & 2 \\\\ 2 & -2 \\end{bmatrix} \\vec{x} ,",
        "Chain(Mul(MatrixOf(2, 0, 0, 1), \\vec{x}''), Mul(MatrixOf(Neg(2), 2, 2, Neg(2)), \\vec{x}); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\Delta v^2 = \\Delta\\boldsymbol{v}\\cdot\\Delta\\boldsymbol{v} = \\left(v_{r,2} - v_{r,1}\\right)^2 + v_{\\perp,2}^2 + v_{\\perp,1}^2 - 2v_{\\perp,1}v_{\\perp,2}\\left(\\boldsymbol{\\hat{u}}_{\\perp,1}\\cdot\\boldsymbol{\\hat{u}}_{\\perp,2}\\right)",
        "Chain(Pow(\\Delta v; 2), Mul(\\Delta \\boldsymbol { v }, \\Delta \\boldsymbol { v }; 1), Add(Pow(Add(v_{r,2}, Neg(v_{r,1})); 2), Pow(v_{\\perp,2}; 2), Pow(v_{\\perp,1}; 2), Neg(Mul(2, v_{\\perp,1}, v_{\\perp,2}, Mul(\\boldsymbol{\\hat{u}}_{\\perp,1}, \\boldsymbol{\\hat{u}}_{\\perp,2}; 1)))); =, =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/plane-change-maneuvers.md",
    ),
    (
        "m_{\\text{sc}}[\\tilde{\\bm{c}}]\\ddot{\\bm r}_{B/N}+[I_{\\text{sc},B}] \\dot{\\bm\\omega}_{\\cal B/N} +\\sum\\limits_{i}^{N}\\biggl\\lbrace I_{s_i,2}\\bm{\\hat{h}}_{i,2}+m_{\\text{sp}_i}d_i [\\tilde{\\bm{r}}_{S_i/B}] \\bm{\\hat{s}}_{i,3}\\biggr\\rbrace\\ddot{\\theta}_i = \\\\ -[\\bm{\\tilde{\\omega}}_{\\cal B/N}] [I_{\\text{sc},B}] \\bm\\omega_{\\cal B/N} - [I'_{\\text{sc},B}] \\bm\\omega_{\\cal B/N} - \\sum\\limits_{i}^{N}\\biggl\\lbrace\\dot{\\theta}_i [\\bm{\\tilde{\\omega}}_{\\cal B/N}] \\left(I_{s_i,2} \\bm{\\hat{h}}_{i,2}+m_{\\text{sp}_i} d_i [\\tilde{\\bm{r}}_{S_i/B}] \\hat{\\bm s}_{i,3}\\right)\\\\ +m_{\\text{sp}_i}d_i\\dot{\\theta}_i^2[\\tilde{\\bm{r}}_{S_i/B}] \\bm{\\hat{s}}_{i,1} \\biggr\\rbrace + \\bm{L}_B",
        "Chain(Add(Mul(m_{sc}, [ \\tilde { \\bm { c } } ], Call(\\ddot{\\bm{r}}_{B/N})), Mul([ I _ { \\text { s c } , B } ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N })), Limiting(sum; _{ i }^{ N }; Mul(Tuple(Add(Mul(I_{s_i,2}, \\bm{\\hat{h}}_{i2}), Mul(m_{sp_i}, d_i, [ \\tilde { \\bm { r } } _ { S _ { i } / B } ], \\bm{\\hat{s}}_{i3})); {}), Call(\\ddot{\\theta}_i)))), Add(Neg(Mul([ \\bm { \\tilde { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ I _ { \\text { s c } , B } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}))), Neg(Mul([ I ' _ { \\text { s c } , B } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}))), Neg(Limiting(sum; _{ i }^{ N }; Tuple(Add(Mul(Call(\\dot{\\theta}_i), [ \\bm { \\tilde { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], Add(Mul(I_{s_i,2}, \\bm{\\hat{h}}_{i2}), Mul(m_{sp_i}, d_i, [ \\tilde { \\bm { r } } _ { S _ { i } / B } ], \\hat{\\bm{s}}_{i3}))), Mul(m_{sp_i}, d_i, Pow(Call(\\dot{\\theta}_i); 2), [ \\tilde { \\bm { r } } _ { S _ { i } / B } ], \\bm{\\hat{s}}_{i1})); {}))), \\bm{L}_B); =)",
        "AVSLab/basilisk/src/simulation/dynamics/HingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "L = \\frac12 m\\sigma^2 (\\xi^2-\\eta^2)\\left(\\frac{\\dot{\\xi}^2}{\\xi^2-1} + \\frac{\\dot{\\eta}^2}{1-\\eta^2}\\right) + \\frac12 m\\sigma^2(\\xi^2-1)(1-\\eta^2)\\dot{\\phi}^2 - V(\\xi,\\eta,\\phi)",
        "Chain(L, Add(Mul(Div(1; 2), m, Pow(\\sigma; 2), Add(Pow(Call(\\xi); 2), Neg(Pow(Call(\\eta); 2))), Add(Div(Pow(Call(\\dot{\\xi}); 2); Add(Pow(Call(\\xi); 2), Neg(1))), Div(Pow(Call(\\dot{\\eta}); 2); Add(1, Neg(Pow(Call(\\eta); 2)))))), Mul(Div(1; 2), m, Pow(\\sigma; 2), Add(Pow(Call(\\xi); 2), Neg(1)), Add(1, Neg(Pow(Call(\\eta); 2))), Pow(Call(\\dot{\\phi}); 2)), Neg(Call(V; Call(\\xi), Call(\\eta), Call(\\phi)))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "R = \\begin{bmatrix} \\cos(\\theta) & -\\sin(\\theta) & 0 \\\\ \\sin(\\theta) & \\cos(\\theta) & 0 \\\\ 0 & 0 & 1 \\end{bmatrix}",
        "Chain(R, MatrixOf(Call(cos; \\theta), Neg(Call(sin; \\theta)), 0, Call(sin; \\theta), Call(cos; \\theta), 0, 0, 0, 1); =)",
        "sympy/sympy/sympy/matrices/dense.py",
    ),
    (
        "p = 2*r_{p}",
        "Chain(p, Mul(2, r_p); =)",
        "AVSLab/basilisk/src/architecture/utilitiesSelfCheck/_Documentation/secModelDescription.tex",
    ),
    (
        "\\ddot{x} = g \\frac{(x - x_{cp})}{(z - z_{cp})}.",
        "Chain(Call(\\ddot{x}), Mul(g, Div(Add(Call(x), Neg(x_{cp})); Add(z, Neg(z_{cp})))); =)",
        "RussTedrake/underactuated/book/humanoids.html",
    ),
    (
        "y' + y^2 = a(x)",
        "Chain(Add(y', Pow(y; 2)), Call(a; x); =)",
        "sympy/sympy/sympy/solvers/ode/riccati.py",
    ),
    (
        "^{\\mathbf{A}}\\mathbf{C}^{\\mathbf{B}} = \\begin{bmatrix} \\cos(\\theta) & - \\sin(\\theta) & 0\\\\ \\sin(\\theta) & \\cos(\\theta) & 0\\\\ 0 & 0 & 1\\\\ \\end{bmatrix}",
        "Chain(\\prescript { \\mathbf { A } } { } { \\mathbf { C } } ^ { \\mathbf { B } }, MatrixOf(Call(cos; \\theta), Neg(Call(sin; \\theta)), 0, Call(sin; \\theta), Call(cos; \\theta), 0, 0, 0, 1); =)",
        "sympy/sympy/doc/src/explanation/modules/physics/vector/vectors/vectors.rst",
    ),
    (
        "\\hat{\\bm r}_{1} &= \\frac{{\\bm R}_{P1}} {|{\\bm R}_{P1}|} \\\\ \\hat{\\bm r}_{3} &= \\frac{{\\bm R}_{n}}{|{\\bm R}_{n}|} \\\\ \\hat{\\bm r}_{2} &= \\hat{\\bm r}_{3} \\times \\hat{\\bm r}_{1}",
        "System(Chain(\\hat{\\bm{r}}_1, Div(\\bm{R}_{P1}; Bars(\\bm{R}_{P1})); =), Chain(\\hat{\\bm{r}}_3, Div(\\bm{R}_n; Bars(\\bm{R}_n)); =), Chain(\\hat{\\bm{r}}_2, Cross(\\hat{\\bm{r}}_3; \\hat{\\bm{r}}_1); =))",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/celestialTwoBodyPoint/_Documentation/celestialTwoBodyPoint.tex",
    ),
    (
        "\\boldsymbol{a}(t) = \\frac{d v_x}{dt} \\boldsymbol{\\hat{\\imath}} + \\frac{d v_y}{dt} \\boldsymbol{\\hat{\\jmath}} + \\frac{d v_z}{dt} \\boldsymbol{\\hat{k}} = a_x \\boldsymbol{\\hat{imath}} + a_y \\boldsymbol{\\hat{\\jmath}} + a_z \\boldsymbol{\\hat{k}}",
        "Chain(Call(\\boldsymbol{a}; t), Add(Mul(Derivative(Call(v_x); t, 1), \\boldsymbol{\\hat{\\imath}}), Mul(Derivative(Call(v_y); t, 1), \\boldsymbol{\\hat{\\jmath}}), Mul(Derivative(Call(v_z); t, 1), \\boldsymbol{\\hat{k}})), Add(Mul(a_x, \\boldsymbol{\\hat{\\imath}}), Mul(a_y, \\boldsymbol{\\hat{\\jmath}}), Mul(a_z, \\boldsymbol{\\hat{k}})); =, =)",
        "bryanwweber/orbital-mechanics-notes/review/time-derivatives-of-moving-vectors.md",
    ),
    (
        "m_{\\text{fuel}}=\\rho_{\\text{fuel}}\\mathcal{V}(\\theta^*) \\quad \\Rightarrow \\quad \\dot{m}_{\\text{fuel}}=\\rho_{\\text{fuel}}\\dot{\\mathcal{V}}(\\theta^*)",
        "Implies(Chain(Call(m_{fuel}), Mul(\\rho_{fuel}, Call(\\mathcal{V}; \\theta ^ { * })); =); Chain(Call(\\dot{m}_{fuel}), Mul(\\rho_{fuel}, Call(\\dot{\\mathcal{V}}; \\theta ^ { * })); =))",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "\\dot{\\mbox{\\boldmath $\\chi$}} = \\bar{\\mathbf E}(\\mbox{\\boldmath $\\chi$}) \\cdot \\mathbf C_{I\\!B} \\cdot {}_B\\mbox{\\boldmath $\\omega$}_{I\\!B}",
        "Chain(Call(\\dot{\\boldsymbol{\\chi}}), Mul(Call(\\bar{\\mathbf{E}}; Call(\\boldsymbol{\\chi})), \\mathbf{C}_{I\\!B}, \\prescript { } { B } { \\boldsymbol { \\omega } } _ { I \\! B }); =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "f(x):= e^{-a_1 -a_2}\\sum_{j=0}^{\\left \\lfloor x/2 \\right \\rfloor} \\frac{a_{1}^{x-2j}a_{2}^{j}}{(x-2j)!j!}",
        "Chain(Call(f; x), Mul(Pow(e; Add(Neg(a_1), Neg(a_2))), BigSum(j; 0; Call(floor; Div(x; 2)); Div(Mul(Pow(a_1; Add(x, Neg(Mul(2, j)))), Pow(a_2; j)); Mul(Factorial(Add(x, Neg(Mul(2, j)))), Factorial(j))))); =)",
        "sympy/sympy/sympy/stats/drv_types.py",
    ),
    (
        "\\dot{{\\bf x}} = {\\bf A}(t){\\bf x} + {\\bf B(t)}{\\bf u}.",
        "Chain(Call(\\dot{\\mathbf{x}}), Add(Mul(Call(\\mathbf{A}; t), Call(\\mathbf{x})), Mul(Call(\\mathbf{B}; t), \\mathbf{u})); =)",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "u_n(x,t) = X_n(x)T_n(t) = \\sin \\left( \\frac{n \\pi}{L} x \\right) e^{\\frac{-n^2 \\pi^2}{L^2} k t} .",
        "Chain(Call(u_n; x, t), Mul(Call(X_n; x), Call(T_n; t)), Mul(Call(sin; Mul(Div(Mul(n, \\pi); L), x)), Pow(e; Mul(Div(Neg(Mul(Pow(n; 2), Pow(\\pi; 2))); Pow(L; 2)), k, t))); =, =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\frac{1}{\\omega_0^2}\\dot{u}^2 = (1-u^2)(\\beta-2u)-\\alpha^2 =: G(u)",
        "Chain(Mul(Div(1; Pow(\\omega_0; 2)), Pow(Call(\\dot{u}); 2)), Add(Mul(Add(1, Neg(Pow(Call(u); 2))), Add(\\beta, Neg(Mul(2, Call(u))))), Neg(Pow(\\alpha; 2))), Call(G; Call(u)); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "\\mathbf{q} = w + v",
        "Chain(\\mathbf{q}, Add(w, v); =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "\\dot{m} = \\frac{F}{g I_{sp}}",
        "Chain(Call(\\dot{m}), Div(F; Mul(g, I_{sp})); =)",
        "AVSLab/basilisk/src/simulation/dynamics/Thrusters/thrusterDynamicEffector/_Documentation/secTest.tex",
    ),
    (
        "\\bm{r}'_{Tc/B} = 0 \\qquad\\qquad \\bm{r}''_{Tc/B}=0",
        "System(Chain(\\bm{r}_{Tc/B}', 0; =), Chain(\\bm{r}_{Tc/B}'', 0; =))",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "y(x) = C_1 y_1(x) + C_2 y_2(x) ,",
        "Chain(Call(y; x), Add(Mul(C_1, Call(y_1; x)), Mul(C_2, Call(y_2; x))); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "\\mu_m = \\rho_m\\left(x\\nu_g + (1-x)\\nu_l + 2\\sqrt{x(1-x)\\nu_g\\nu_l} \\right)",
        "Chain(\\mu_m, Mul(\\rho_m, Add(Mul(x, \\nu_g), Mul(Add(1, Neg(x)), \\nu_l), Mul(2, Sqrt(Mul(x, Add(1, Neg(x)), \\nu_g, \\nu_l))))); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "ml^2 \\ddot\\theta + b \\dot\\theta + mgl\\sin\\theta = \\tau.",
        "Chain(Add(Mul(m, Pow(l; 2), Call(\\ddot{\\theta})), Mul(b, Call(\\dot{\\theta})), Mul(m, g, l, Call(sin; Call(\\theta)))), \\tau; =)",
        "RussTedrake/underactuated/book/sysid.html",
    ),
    (
        "\\boldsymbol{n}\\times \\boldsymbol{q} = \\frac{\\cos\\theta}{\\cos\\theta_0}\\left(\\cos\\theta_0\\sin\\varOmega\\boldsymbol{e}_1-\\cos\\theta_0\\cos\\varOmega\\boldsymbol{e}_2+\\sin\\theta_0\\boldsymbol{e}_3\\right)",
        "Chain(Cross(\\boldsymbol{n}; \\boldsymbol{q}), Mul(Div(Call(cos; \\theta); Call(cos; \\theta_0)), Add(Mul(Call(cos; \\theta_0), Call(sin; \\varOmega), \\boldsymbol{e}_1), Neg(Mul(Call(cos; \\theta_0), Call(cos; \\varOmega), \\boldsymbol{e}_2)), Mul(Call(sin; \\theta_0), \\boldsymbol{e}_3))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\boldsymbol{R}_{\\mathrm{COG}} = \\frac{m_1 \\boldsymbol{R}_1 + m_2 \\boldsymbol{R}_2}{m_1 + m_2}",
        "Chain(\\boldsymbol{R}_{COG}, Div(Add(Mul(m_1, \\boldsymbol{R}_1), Mul(m_2, \\boldsymbol{R}_2)); Add(m_1, m_2)); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/motion-of-the-barycenter.md",
    ),
    (
        "I = \\frac{P}{V \\cdot \\text{PF} \\sqrt{3}}",
        "Chain(I, Div(P; Mul(V, \\text{PF}, Sqrt(3))); =)",
        "CalebBell/fluids/fluids/pump.py",
    ),
    (
        "\\begin{bmatrix} \\hat{a}_x \\\\ \\hat{a}_y \\\\ \\hat{a}_z \\end{bmatrix} = \\begin{bmatrix} \\cos{\\theta} & \\sin{\\theta} & 0 \\\\ -\\sin{\\theta} & \\cos{\\theta} & 0 \\\\ 0 & 0 & 1 \\end{bmatrix} \\begin{bmatrix} \\hat{n}_x \\\\ \\hat{n}_y \\\\ \\hat{n}_z \\end{bmatrix}",
        "Chain(MatrixOf(\\hat{a}_x, \\hat{a}_y, \\hat{a}_z), Mul(MatrixOf(Call(cos; \\theta), Call(sin; \\theta), 0, Neg(Call(sin; \\theta)), Call(cos; \\theta), 0, 0, 0, 1), MatrixOf(\\hat{n}_x, \\hat{n}_y, \\hat{n}_z)); =)",
        "moorepants/learn-multibody-dynamics/orientation.rst",
    ),
    (
        "D = \\prod_{i=1}^n d_i^{a_i}, \\qquad a_i \\in \\mathbf{Z}.",
        "System(Chain(D, BigProduct(i; 1; n; Pow(d_i; a_i)); =), Chain(a_i, \\mathbf{Z}; \\in))",
        "sympy/sympy/doc/src/modules/physics/units/philosophy.rst",
    ),
    (
        "r_2 = \\frac{p}{1-e\\cos \\xi}",
        "Chain(r_2, Div(p; Add(1, Neg(Mul(e, Call(cos; \\xi))))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise2.tex",
    ),
    (
        "\\bar{F}_r + \\bar{F}_r^* = \\bar{f}_d(\\dot{\\bar{u}}, \\bar{u}, \\bar{q}, t) = \\begin{bmatrix} \\bar{f}_{ds}(\\dot{\\bar{u}}, \\bar{u}, \\bar{q}, t) \\\\ \\bar{f}_{dr}(\\dot{\\bar{u}}, \\bar{u}, \\bar{q}, t) \\\\ \\end{bmatrix} = 0 \\in \\mathbb{R}^n",
        "Chain(Add(\\bar{F}_r, \\bar { F } _ { r } ^ { * }), Call(\\bar{f}_d; Call(\\dot{\\bar{u}}), Call(\\bar{u}), \\bar{q}, t), MatrixOf(Call(\\bar{f}_{ds}; Call(\\dot{\\bar{u}}), Call(\\bar{u}), \\bar{q}, t), Call(\\bar{f}_{dr}; Call(\\dot{\\bar{u}}), Call(\\bar{u}), \\bar{q}, t)), 0, Pow(\\mathbb{R}; n); =, =, =, \\in)",
        "moorepants/learn-multibody-dynamics/nonholonomic-eom.rst",
    ),
    (
        "\\mathbf{r} = \\begin{bmatrix} r_x \\\\ r_y \\\\ r_z \\end{bmatrix}",
        "Chain(\\mathbf{r}, MatrixOf(r_x, r_y, r_z); =)",
        "Mayitzin/ahrs/ahrs/filters/ukf.py",
    ),
    (
        "\\Gamma(x) = \\int_0^\\infty t^{x-1} e^{-t} \\, dt .",
        "Chain(Call(Gamma; x), Integral(Mul(Pow(t; Add(x, Neg(1))), Pow(e; Neg(t))); t; 0; Infinity()); =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "\\boldsymbol{r}(t) = x(t)\\boldsymbol{\\hat{\\imath}} + y(t)\\boldsymbol{\\hat{\\jmath}} + z(t)\\boldsymbol{\\hat{k}}",
        "Chain(Call(\\boldsymbol{r}; t), Add(Mul(Call(x; t), \\boldsymbol{\\hat{\\imath}}), Mul(Call(y; t), \\boldsymbol{\\hat{\\jmath}}), Mul(Call(z; t), \\boldsymbol{\\hat{k}})); =)",
        "bryanwweber/orbital-mechanics-notes/review/kinematics.md",
    ),
    (
        "\\phi(t+T)=\\phi(t)+\\Delta \\phi,\\quad \\psi(t+T)=\\psi(t)+\\Delta\\psi",
        "System(Chain(Call(\\phi; Add(t, T)), Add(Call(\\phi; t), \\Delta \\phi); =), Chain(Call(\\psi; Add(t, T)), Add(Call(\\psi; t), \\Delta \\psi); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "\\mu = GM = G\\left(m_1 + m_2\\right)",
        "Chain(\\mu, Mul(G, M), Mul(G, Add(m_1, m_2)); =, =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "R_n = A r^n + B r^{-n} .",
        "Chain(R_n, Add(Mul(A, Pow(r; n)), Mul(B, Pow(r; Neg(n)))); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "s = (kD\\sin\\alpha)^2",
        "Chain(s, Pow(Mul(k, D, Call(sin; \\alpha)); 2); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "q'(t) = q(t)+\\alpha \\eta(t)",
        "Chain(Call(q'; t), Add(Call(q; t), Mul(\\alpha, Call(\\eta; t))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter9.tex",
    ),
    (
        "\\ddot{\\theta}(t) = \\mp \\ddot{\\theta}_{\\text{max}}",
        "Chain(Call(\\ddot{\\theta}; t), PlusMinus(\\ddot { \\theta } _ { \\text { m a x } }; True); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedRotation1DOF/prescribedRotation1DOF.rst",
    ),
    (
        "d(\\mathbf{q}_1, \\mathbf{q}_2) = \\mathrm{min} \\{ \\|\\mathbf{q}_1-\\mathbf{q}_2\\|, \\|\\mathbf{q}_1+\\mathbf{q}_2\\|\\}",
        "Chain(Call(d; \\mathbf{q}_1, \\mathbf{q}_2), Call(min; Norm(Add(\\mathbf{q}_1, Neg(\\mathbf{q}_2))), Norm(Add(\\mathbf{q}_1, \\mathbf{q}_2))); =)",
        "Mayitzin/ahrs/ahrs/utils/metrics.py",
    ),
    (
        "\\begin{aligned}\\boldsymbol{r} &= \\left[1 - \\frac{\\chi^2}{r_0}C\\left(\\alpha\\chi^2\\right)\\right]\\boldsymbol{r}_0 + \\left[\\left(t - t_0\\right) - \\frac{\\chi^3}{\\sqrt{\\mu}}S\\left(\\alpha\\chi^2\\right)\\right]\\boldsymbol{v}_0\\\\\\boldsymbol{v} &= \\frac{\\chi\\sqrt{\\mu}}{r r_0}\\left[\\alpha\\chi^2S\\left(\\alpha\\chi^2\\right) - 1\\right]\\boldsymbol{r}_0 + \\left[1 - \\frac{\\chi^2}{r}C\\left(\\alpha\\chi^2\\right)\\right]\\boldsymbol{v}_0\\end{aligned}",
        "System(Chain(\\boldsymbol{r}, Add(Mul(Add(1, Neg(Mul(Div(Pow(\\chi; 2); r_0), Call(C; Mul(\\alpha, Pow(\\chi; 2)))))), \\boldsymbol{r}_0), Mul(Add(Add(t, Neg(t_0)), Neg(Mul(Div(Pow(\\chi; 3); Sqrt(\\mu)), Call(S; Mul(\\alpha, Pow(\\chi; 2)))))), \\boldsymbol{v}_0)); =), Chain(\\boldsymbol{v}, Add(Mul(Div(Mul(\\chi, Sqrt(\\mu)); Mul(r, r_0)), Add(Mul(\\alpha, Pow(\\chi; 2), Call(S; Mul(\\alpha, Pow(\\chi; 2)))), Neg(1)), \\boldsymbol{r}_0), Mul(Add(1, Neg(Mul(Div(Pow(\\chi; 2); r), Call(C; Mul(\\alpha, Pow(\\chi; 2)))))), \\boldsymbol{v}_0)); =))",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables.md",
    ),
    (
        "v_r = \\boldsymbol{v} \\cdot \\frac{\\boldsymbol{r}}{r}",
        "Chain(v_r, Mul(\\boldsymbol{v}, Div(\\boldsymbol{r}; r); 1); =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/orbital-elements-and-the-state-vector.md",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{v}_t &=& \\mathbf{z}_t - \\mathbf{H}\\hat{\\mathbf{x}}_t \\\\ \\mathbf{S}_t &=& \\mathbf{H} \\hat{\\mathbf{P}}_t \\mathbf{H}^T + \\mathbf{R} \\\\ \\mathbf{K}_t &=& \\hat{\\mathbf{P}}_t \\mathbf{H}^T \\mathbf{S}_t^{-1} \\\\ \\mathbf{x}_t &=& \\hat{\\mathbf{x}}_t + \\mathbf{K}_t \\mathbf{v}_t \\\\ \\mathbf{P}_t &=& \\hat{\\mathbf{P}}_t - \\mathbf{K}_t \\mathbf{S}_t \\mathbf{K}_t^T \\end{array}",
        "System(Chain(\\mathbf{v}_t, Add(\\mathbf{z}_t, Neg(Mul(\\mathbf{H}, \\hat{\\mathbf{x}}_t))); =), Chain(\\mathbf{S}_t, Add(Mul(\\mathbf{H}, \\hat{\\mathbf{P}}_t, Transpose(\\mathbf{H})), \\mathbf{R}); =), Chain(\\mathbf{K}_t, Mul(\\hat{\\mathbf{P}}_t, Transpose(\\mathbf{H}), Pow(\\mathbf{S}_t; Neg(1))); =), Chain(\\mathbf{x}_t, Add(\\hat{\\mathbf{x}}_t, Mul(\\mathbf{K}_t, \\mathbf{v}_t)); =), Chain(\\mathbf{P}_t, Add(\\hat{\\mathbf{P}}_t, Neg(Mul(\\mathbf{K}_t, \\mathbf{S}_t, Transpose(\\mathbf{K}_t)))); =))",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "G(z) = -\\sum_{j=1}^w (F_j(z) + R_j(z)),",
        "Chain(Call(G; z), Neg(BigSum(j; 1; w; Add(Call(F_j; z), Call(R_j; z)))); =)",
        "sympy/sympy/doc/src/modules/simplify/hyperexpand.rst",
    ),
    (
        "k_{ {\\boldsymbol{\\alpha}}}(\\tau_{nm}) = \\sigma_n^2\\,\\delta_{nm} + \\sum_{j=1}^J &&\\left[ a_j\\,\\exp\\left(-c_j\\,\\tau_{nm}\\right)\\,\\cos\\left(d_j\\,\\tau_{nm}\\right) \\right. \\\\ &&+ \\left. b_j\\,\\exp\\left(-c_j\\,\\tau_{nm}\\right)\\,\\sin\\left(d_j\\,\\tau_{nm}\\right) \\right] \\quad.",
        "Chain(Call(k_{\\boldsymbol\\alpha}; \\tau_{nm}), Add(Mul(Pow(\\sigma_n; 2), \\delta_{nm}), BigSum(j; 1; J; Add(Mul(a_j, Call(exp; Neg(Mul(c_j, \\tau_{nm}))), Call(cos; Mul(d_j, \\tau_{nm}))), Mul(b_j, Call(exp; Neg(Mul(c_j, \\tau_{nm}))), Call(sin; Mul(d_j, \\tau_{nm})))))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\alpha = \\frac{1}{a} = \\frac{2}{r_0} - \\frac{v_0^2}{\\mu}",
        "Chain(\\alpha, Div(1; a), Add(Div(2; r_0), Neg(Div(Pow(v_0; 2); \\mu))); =, =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-lagrange-coefficients-example.md",
    ),
    (
        "{\\bf M}({\\bf q})\\ddot{\\bf q} + {\\bf C}({\\bf q},\\dot{\\bf q})\\dot{\\bf q} = {\\bf \\tau}_g({\\bf q}) + {\\bf B}{\\bf u},",
        "Chain(Add(Mul(Call(\\mathbf{M}; Call(\\mathbf{q})), Call(\\ddot{\\mathbf{q}})), Mul(Call(\\mathbf{C}; Call(\\mathbf{q}), Call(\\dot{\\mathbf{q}})), Call(\\dot{\\mathbf{q}}))), Add(Call(\\mathbf{\\tau}_g; Call(\\mathbf{q})), Mul(\\mathbf{B}, \\mathbf{u})); =)",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\ddot{x} = -\\frac{\\ddot\\theta + s}{c} \\\\ \\ddot\\theta(c - \\frac{2}{c}) - 2 \\tan\\theta - \\dot\\theta^2 s = f_x",
        "System(Chain(Call(\\ddot{x}), Neg(Div(Add(Call(\\ddot{\\theta}), s); c)); =), Chain(Add(Mul(Call(\\ddot{\\theta}), Add(c, Neg(Div(2; c)))), Neg(Mul(2, Call(tan; Call(\\theta)))), Neg(Mul(Pow(Call(\\dot{\\theta}); 2), s))), f_x; =))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "{\\bf x}(t) = \\begin{bmatrix} q_0 + t\\dot{q}_0 \\\\ \\dot{q}_0 \\end{bmatrix} + \\sum_{i=0}^k \\left(\\frac{t^{i+1}}{i+1}\\begin{bmatrix} 0 \\\\ c_i \\end{bmatrix} + \\frac{t^{i+2}}{i+2}\\begin{bmatrix} c_i \\\\ 0 \\end{bmatrix}\\right).",
        "Chain(Call(\\mathbf{x}; t), Add(MatrixOf(Add(q_0, Mul(t, \\dot { q } _ { 0 })), \\dot { q } _ { 0 }), BigSum(i; 0; k; Add(Mul(Div(Pow(t; Add(i, 1)); Add(i, 1)), MatrixOf(0, c_i)), Mul(Div(Pow(t; Add(i, 2)); Add(i, 2)), MatrixOf(c_i, 0))))); =)",
        "RussTedrake/underactuated/book/trajopt.html",
    ),
    (
        "\\begin{bmatrix} \\hat{\\mathbf{b}}_1 \\\\ \\hat{\\mathbf{b}}_2 \\\\ \\hat{\\mathbf{b}}_3 \\end{bmatrix} = {}^B\\mathbf{C}^A \\begin{bmatrix} \\hat{\\mathbf{a}}_1 \\\\ \\hat{\\mathbf{a}}_2 \\\\ \\hat{\\mathbf{a}}_3 \\end{bmatrix}.",
        "Chain(MatrixOf(\\hat{\\mathbf{b}}_1, \\hat{\\mathbf{b}}_2, \\hat{\\mathbf{b}}_3), Mul(\\prescript { B } { } { \\mathbf { C } } ^ { A }, MatrixOf(\\hat{\\mathbf{a}}_1, \\hat{\\mathbf{a}}_2, \\hat{\\mathbf{a}}_3)); =)",
        "sympy/sympy/sympy/physics/vector/frame.py",
    ),
    (
        "e_{out} = e_{main} + e_{off}",
        "Chain(e_{out}, Add(e_{main}, e_{off}); =)",
        "AVSLab/basilisk/src/fswAlgorithms/orbitControl/orbElemOffset/orbElemOffset.rst",
    ),
    (
        "\\begin{aligned} e_t &= \\frac{r_B - r_A}{r_A + r_B} \\\\ p_t &= \\frac{2 r_A r_B}{r_A - r_B} \\end{aligned}",
        "System(Chain(e_t, Div(Add(r_B, Neg(r_A)); Add(r_A, r_B)); =), Chain(p_t, Div(Mul(2, r_A, r_B); Add(r_A, Neg(r_B))); =))",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/non-hohmann-transfers.md",
    ),
    (
        "x[n+1] = a x[n] + w[n].",
        "Chain(Indexed(x; Add(n, 1)), Add(Mul(a, Indexed(x; n)), Indexed(w; n)); =)",
        "RussTedrake/underactuated/book/stochastic.html",
    ),
    (
        "\\dot{\\bf x} = \\begin{bmatrix} c \\dot\\theta \\\\ -s \\dot\\theta \\\\ -\\frac{1}{m l^2} \\left( b \\dot\\theta + mgls \\right) \\end{bmatrix}.",
        "Chain(Call(\\dot{\\mathbf{x}}), MatrixOf(Mul(c, Call(\\dot{\\theta})), Neg(Mul(s, Call(\\dot{\\theta}))), Neg(Mul(Div(1; Mul(m, Pow(l; 2))), Add(Mul(b, Call(\\dot{\\theta})), Mul(m, g, l, s))))); =)",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "K = K_1 = K_2 = 340 f_d",
        "Chain(K, K_1, K_2, Mul(340, f_d); =, =, =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "I = I_3 = \\begin{bmatrix} 1 & 0 & 0 \\\\ 0 & 1 & 0 \\\\ 0 & 0 & 1 \\end{bmatrix} .",
        "Chain(I, I_3, MatrixOf(1, 0, 0, 0, 1, 0, 0, 0, 1); =, =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "R(z) = \\sum_{r=0}^{l_u - 1} res_{s = r + b}.",
        "Chain(Call(R; z), BigSum(r; 0; Add(l_u, Neg(1)); \\text{res}_{s=r+b}); =)",
        "sympy/sympy/doc/src/modules/simplify/hyperexpand.rst",
    ),
    (
        "R = \\frac{h_2^2}{\\mu_{\\text{sun}}} \\frac{1}{1 + e_2 \\cos\\nu_2}",
        "Chain(R, Mul(Div(Pow(h_2; 2); \\mu_{sun}), Div(1; Add(1, Mul(e_2, Call(cos; \\nu_2))))); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-arrival-flyby.md",
    ),
    (
        "K_N = \\frac{0.02764P_1-1000}{0.03324P_1-1061}",
        "Chain(K_N, Div(Add(Mul(0.02764, P_1), Neg(1000)); Add(Mul(0.03324, P_1), Neg(1061))); =)",
        "CalebBell/fluids/fluids/safety_valve.py",
    ),
    (
        "\\frac{1}{2} \\left(v^*\\right)^2 = \\frac{1}{2}\\left[\\left(\\dot{x}^*\\right)^2 + \\left(\\dot{y}^*\\right)^2\\right]",
        "Chain(Mul(Div(1; 2), Pow(v ^ { * }; 2)), Mul(Div(1; 2), Add(Pow(Call(\\dot { x } ^ { * }); 2), Pow(Call(\\dot { y } ^ { * }); 2))); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/jacobi-constant.md",
    ),
    (
        "a_k = \\frac{4 (k+\\nicefrac{1}{2}-1) + 2}{4 (k+\\nicefrac{1}{2})\\,(k+\\nicefrac{1}{2}-1) + 1} \\, a_{k-1} = \\frac{1}{k} \\, a_{k-1} .",
        "Chain(a_k, Mul(Div(Add(Mul(4, Add(k, Div(1; 2), Neg(1))), 2); Add(Mul(4, Add(k, Div(1; 2)), Add(k, Div(1; 2), Neg(1))), 1)), a_{k-1}), Mul(Div(1; k), a_{k-1}); =, =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "\\begin{aligned}\\boldsymbol{a}(t) &= \\frac{dv_x(t)}{dt}\\boldsymbol{\\hat{\\imath}} + \\frac{dv_y(t)}{dt}\\boldsymbol{\\hat{\\jmath}} + \\frac{dv_z(t)}{dt}\\boldsymbol{\\hat{k}} \\\\ &= a_x\\boldsymbol{\\hat{\\imath}} + a_y\\boldsymbol{\\hat{\\jmath}} + a_z\\boldsymbol{\\hat{k}} \\\\ &= \\dot{\\boldsymbol{v}} = \\ddot{\\boldsymbol{r}}\\end{aligned}",
        "Chain(Call(\\boldsymbol{a}; t), Add(Mul(Derivative(Call(v_x; t); t, 1), \\boldsymbol{\\hat{\\imath}}), Mul(Derivative(Call(v_y; t); t, 1), \\boldsymbol{\\hat{\\jmath}}), Mul(Derivative(Call(v_z; t); t, 1), \\boldsymbol{\\hat{k}})), Add(Mul(a_x, \\boldsymbol{\\hat{\\imath}}), Mul(a_y, \\boldsymbol{\\hat{\\jmath}}), Mul(a_z, \\boldsymbol{\\hat{k}})), Call(\\dot{\\boldsymbol{v}}), Call(\\ddot{\\boldsymbol{r}}); =, =, =, =)",
        "bryanwweber/orbital-mechanics-notes/review/kinematics.md",
    ),
    (
        "R = \\begin{bmatrix} a & -b \\\\ b & a\\end{bmatrix}.",
        "Chain(R, MatrixOf(a, Neg(b), b, a); =)",
        "RussTedrake/manipulation/book/pose.html",
    ),
    (
        "\\frac12 mvc = I_u\\omega",
        "Chain(Mul(Div(1; 2), m, v, c), Mul(I_u, \\omega); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "\\dot{\\bm{H}}_{\\text{sc},B} = [I_{\\text{hub},B_c}] \\dot{\\bm\\omega}_{\\cal B/N} + \\bm\\omega_{\\cal B/N} \\times [I_{\\text{hub},B_c}] \\bm\\omega_{\\cal B/N} + m_{\\text{\\text{hub}}}\\bm{r}_{B_{c}/B} \\times \\ddot{\\bm{r}}_{B_{c}/B}\\\\ + \\sum\\limits_{j=1}^{N_P}m_j \\bm r_{P_{c,j}/B}\\times \\Bigl[\\bm{r}''_{P_{c,j}/B} +2 \\bm\\omega_{\\cal B/N} \\times \\bm{r}'_{P_{c,j}/B} + \\dot{\\bm\\omega}_{\\cal B/N} \\times \\bm{r}_{P_{c,j}/B} +\\bm\\omega_{\\cal B/N} \\times (\\bm\\omega_{\\cal B/N} \\times \\bm{r}_{P_{c,j}/B})\\Bigr]",
        "Chain(Call(\\dot{\\bm{H}}_{sc,B}), Add(Mul([ I _ { \\text { h u b } , B _ { c } } ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N })), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Mul([ I _ { \\text { h u b } , B _ { c } } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}))), Cross(Mul(m_{hub}, Call(\\bm{r}_{B_c/B})); Call(\\ddot{\\bm{r}}_{B_c/B})), BigSum(j; 1; N_P; Cross(Mul(m_j, \\bm{r}_{P_c,j/B}); Add(\\bm{r}_{P_c,j/B}'', Cross(Mul(2, Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})); \\bm{r}_{P_c,j/B}'), Cross(Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }); \\bm{r}_{P_c,j/B}), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); \\bm{r}_{P_c,j/B})))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/LinearSpringMassDamper/_Documentation/secModelDescription.tex",
    ),
    (
        "\\operatorname{Wigner6j}(j_1,j_2,j_3,j_4,j_5,j_6) =(-1)^{j_1+j_2+j_4+j_5} W(j_1,j_2,j_5,j_4,j_3,j_6)",
        "Chain(Call(\\text{Wigner6j}; j_1, j_2, j_3, j_4, j_5, j_6), Mul(Pow(Neg(1); Add(j_1, j_2, j_4, j_5)), Call(W; j_1, j_2, j_5, j_4, j_3, j_6)); =)",
        "sympy/sympy/sympy/physics/wigner.py",
    ),
    (
        "K^* &=& K({ {\\boldsymbol{t}}}^*,\\,{ {\\boldsymbol{t}}}^*) - K({ {\\boldsymbol{t}}}^*,\\,{ {\\boldsymbol{t}}})\\,{K({ {\\boldsymbol{t}}},\\,{ {\\boldsymbol{t}}})}^{-1}\\, K({ {\\boldsymbol{t}}},\\,{ {\\boldsymbol{t}}}^*)",
        "Chain(K ^ { * }, Add(Call(K; \\boldsymbol { t } ^ { * }, \\boldsymbol { t } ^ { * }), Neg(Mul(Call(K; \\boldsymbol { t } ^ { * }, \\boldsymbol{t}), Pow(Call(K; \\boldsymbol{t}, \\boldsymbol{t}); Neg(1)), Call(K; \\boldsymbol{t}, \\boldsymbol { t } ^ { * })))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\bar{\\mathbf{q}}^T\\bar{\\mathbf{q}} = |\\mathbf{Q}|^2 + q^2 = 1",
        "Chain(Mul(Transpose(\\bar{\\mathbf{q}}), \\bar{\\mathbf{q}}), Add(Pow(Bars(\\mathbf{Q}); 2), Pow(q; 2)), 1; =, =)",
        "Mayitzin/ahrs/ahrs/filters/quest.py",
    ),
    (
        "z = S(s,1,n) \\sum_{k=1}^n \\frac{1}{k^{s+t}}",
        "Chain(z, Mul(Call(S; s, 1, n), BigSum(k; 1; n; Div(1; Pow(k; Add(s, t))))); =)",
        "fredrik-johansson/arb/doc/source/acb_poly.rst",
    ),
    (
        "u^* = -q - \\sqrt{3} \\dot{q},",
        "Chain(u ^ { * }, Add(Neg(Call(q)), Neg(Mul(Sqrt(3), Call(\\dot{q})))); =)",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "K_{SB} = \\sqrt{\\frac{(\\rho_p-\\rho_f)}{\\rho_f}} = \\sqrt{\\frac{4 g d_p}{3 C_D}}",
        "Chain(K_{SB}, Sqrt(Div(Add(\\rho_p, Neg(\\rho_f)); \\rho_f)), Sqrt(Div(Mul(4, g, d_p); Mul(3, C_D))); =, =)",
        "CalebBell/fluids/fluids/separator.py",
    ),
    (
        "f(k) := \\frac{1}{k^s \\zeta{(s)}}",
        "Chain(Call(f; k), Div(1; Mul(Pow(k; s), Call(\\zeta; s))); =)",
        "sympy/sympy/sympy/stats/drv_types.py",
    ),
    (
        "\\mathnormal{\\Lambda} (\\boldsymbol{q},t,\\boldsymbol{q}',t') = L \\left(\\boldsymbol{q}, \\frac{\\boldsymbol{q}'}{t'},t\\right) t'",
        "Chain(Call(\\Lambda; \\boldsymbol{q}, t, \\boldsymbol{q}', t'), Mul(Call(L; \\boldsymbol{q}, Div(\\boldsymbol{q}'; t'), t), t'); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter9.tex",
    ),
    (
        "\\dim S = k .",
        "Chain(Call(dim; S), k; =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "W = zRT\\ln\\left(\\frac{P_2}{P_1}\\right) = P_1 V_1 \\ln\\left(\\frac{P_2} {P_1}\\right) = P_2 V_2 \\ln\\left(\\frac{P_2}{P_1}\\right)",
        "Chain(W, Mul(z, R, T, Call(ln; Div(P_2; P_1))), Mul(P_1, V_1, Call(ln; Div(P_2; P_1))), Mul(P_2, V_2, Call(ln; Div(P_2; P_1))); =, =, =)",
        "CalebBell/fluids/fluids/compressible.py",
    ),
    (
        "\\begin{bmatrix} T^3 & T^4 & T^5 \\\\ 3T^2 & 4T^3 & 5T^4 \\\\ 6T & 12T^2 & 20T^3 \\end{bmatrix}\\begin{bmatrix} a_3\\\\ a_4\\\\ a_5\\end{bmatrix}=\\begin{bmatrix} x_e-x_s-v_sT-0.5a_sT^2\\\\ v_e-v_s-a_sT\\\\ a_e-a_s\\end{bmatrix}",
        "Chain(Mul(MatrixOf(Pow(T; 3), Pow(T; 4), Pow(T; 5), Mul(3, Pow(T; 2)), Mul(4, Pow(T; 3)), Mul(5, Pow(T; 4)), Mul(6, T), Mul(12, Pow(T; 2)), Mul(20, Pow(T; 3))), MatrixOf(a_3, a_4, a_5)), MatrixOf(Add(x_e, Neg(x_s), Neg(Mul(v_s, T)), Neg(Mul(0.5, a_s, Pow(T; 2)))), Add(v_e, Neg(v_s), Neg(Mul(a_s, T))), Add(a_e, Neg(a_s))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/quintic_polynomials_planner/quintic_polynomials_planner_main.rst",
    ),
    (
        "\\begin{bmatrix} \\hat{a}_x \\\\ \\hat{a}_y \\\\ \\hat{a}_z \\end{bmatrix} = {}^A\\mathbf{C}^B \\begin{bmatrix} \\hat{b}_x \\\\ \\hat{b}_y \\\\ \\hat{b}_z \\end{bmatrix}",
        "Chain(MatrixOf(\\hat{a}_x, \\hat{a}_y, \\hat{a}_z), Mul(\\prescript { A } { } { \\mathbf { C } } ^ { B }, MatrixOf(\\hat{b}_x, \\hat{b}_y, \\hat{b}_z)); =)",
        "moorepants/learn-multibody-dynamics/notation.rst",
    ),
    (
        "\\omega = \\frac{\\partial W}{\\partial J} = \\frac{\\partial W}{\\partial k_2} \\frac{\\partial k_2}{\\partial J}",
        "Chain(\\omega, Derivative(Call(W); J, 1; True), Mul(Derivative(Call(W); k_2, 1; True), Derivative(Call(k_2); J, 1; True)); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\left.v_{\\perp}\\right)_0 = \\sqrt{v_0^2 - v_{r,0}^2}",
        "Chain(Marked(v_\\perp; _{ 0 }), Sqrt(Add(Pow(v_0; 2), Neg(Pow(v_{r,0}; 2)))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-lagrange-coefficients-example.md",
    ),
    (
        "\\boldsymbol{v}_{\\text{rel}} = \\dot{x}\\boldsymbol{\\hat{\\imath}} + \\dot{y}\\boldsymbol{\\hat{\\jmath}} + \\dot{z}\\boldsymbol{\\hat{k}}",
        "Chain(\\boldsymbol{v}_{rel}, Add(Mul(Call(\\dot{x}), \\boldsymbol{\\hat{\\imath}}), Mul(Call(\\dot{y}), \\boldsymbol{\\hat{\\jmath}}), Mul(Call(\\dot{z}), \\boldsymbol{\\hat{k}})); =)",
        "bryanwweber/orbital-mechanics-notes/reference/relative-motion.md",
    ),
    (
        "h_2 = R V_{\\perp,2}",
        "Chain(h_2, Mul(R, V_{\\perp,2}); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-arrival-flyby.md",
    ),
    (
        "X(t) = \\begin{bmatrix} e^t & 0 \\\\ \\frac{1}{2} e^t & e^{-t} \\end{bmatrix} .",
        "Chain(Call(X; t), MatrixOf(Pow(e; t), 0, Mul(Div(1; 2), Pow(e; t)), Pow(e; Neg(t))); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "{\\bf A}_{\\bf y} = {\\bf P}{\\bf A}_{\\bf x}{\\bf P}^T, \\qquad {\\bf B}_{\\bf y} = {\\bf P}{\\bf B}_{\\bf x}, \\qquad {\\bf Q}_{\\bf y} = {\\bf P}{\\bf Q}_{\\bf x}{\\bf P}^T",
        "System(Chain(\\mathbf{A}_{\\mathbf y}, Mul(\\mathbf{P}, \\mathbf{A}_{\\mathbf x}, Transpose(\\mathbf{P})); =), Chain(\\mathbf{B}_{\\mathbf y}, Mul(\\mathbf{P}, \\mathbf{B}_{\\mathbf x}); =), Chain(\\mathbf{Q}_{\\mathbf y}, Mul(\\mathbf{P}, \\mathbf{Q}_{\\mathbf x}, Transpose(\\mathbf{P})); =))",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "R = \\begin{bmatrix} 1 & 0 & 0 \\\\ 0 & \\cos(\\theta) & \\sin(\\theta) \\\\ 0 & -\\sin(\\theta) & \\cos(\\theta) \\end{bmatrix}",
        "Chain(R, MatrixOf(1, 0, 0, 0, Call(cos; \\theta), Call(sin; \\theta), 0, Neg(Call(sin; \\theta)), Call(cos; \\theta)); =)",
        "sympy/sympy/sympy/matrices/dense.py",
    ),
    (
        "a_n = \\frac{-4}{n^2 \\pi^2 (2 - n^2 \\pi^2)} .",
        "Chain(a_n, Div(Neg(4); Mul(Pow(n; 2), Pow(\\pi; 2), Add(2, Neg(Mul(Pow(n; 2), Pow(\\pi; 2)))))); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\xi = \\cos(\\phi) \\cos(\\lambda) + j \\cos(\\phi) \\sin(\\lambda) = \\frac{x}{r} + j \\frac{y}{r} = s + j t",
        "Chain(\\xi, Add(Mul(Call(cos; \\phi), Call(cos; \\lambda)), Mul(j, Call(cos; \\phi), Call(sin; \\lambda))), Add(Div(x; r), Mul(j, Div(y; r))), Add(s, Mul(j, t)); =, =, =)",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/spacecraftPointing/_Documentation/example/secModelDescription.tex",
    ),
    (
        "h = \\lVert\\boldsymbol{r}_0 \\times\\boldsymbol{v}_0\\rVert",
        "Chain(h, Norm(Cross(\\boldsymbol{r}_0; \\boldsymbol{v}_0)); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/the-lagrange-coefficients.md",
    ),
    (
        "\\sigma_t = \\int_0^\\pi 2\\pi \\sigma(\\theta) \\sin \\theta \\mathrm{d} \\theta \\to +\\infty",
        "Chain(\\sigma_t, Integral(Mul(2, \\pi, Call(\\sigma; \\theta), Call(sin; \\theta)); \\theta; 0; \\pi), Infinity(); =, \\to)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "Z = \\frac12 \\sum_{i=1}^nm_i\\left(\\boldsymbol{a}_i-\\frac{\\boldsymbol{F}_i}{m_i}\\right)^2",
        "Chain(Z, Mul(Div(1; 2), BigSum(i; 1; n; Mul(m_i, Pow(Add(\\boldsymbol{a}_i, Neg(Div(\\boldsymbol{F}_i; m_i))); 2)))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "\\begin{array}{rcl} \\lambda_{\\mathbf{K},1} &=& \\sqrt{(1-w)^2+w^2+2w(1-w)(\\alpha m_D+V)} \\\\ && \\\\ \\lambda_{\\mathbf{K},2} &=& \\sqrt{(1-w)^2+w^2+2w(1-w)(\\alpha m_D-V)} \\\\ && \\\\ \\lambda_{\\mathbf{K},3} &=& -\\sqrt{(1-w)^2+w^2+2w(1-w)(\\alpha m_D-V)} \\\\ && \\\\ \\lambda_{\\mathbf{K},4} &=& -\\sqrt{(1-w)^2+w^2+2w(1-w)(\\alpha m_D+V)} \\end{array}",
        "System(Chain(\\lambda_{\\mathbf K,1}, Sqrt(Add(Pow(Add(1, Neg(w)); 2), Pow(w; 2), Mul(2, w, Add(1, Neg(w)), Add(Mul(\\alpha, m_D), V)))); =), Chain(\\lambda_{\\mathbf K,2}, Sqrt(Add(Pow(Add(1, Neg(w)); 2), Pow(w; 2), Mul(2, w, Add(1, Neg(w)), Add(Mul(\\alpha, m_D), Neg(V))))); =), Chain(\\lambda_{\\mathbf K,3}, Neg(Sqrt(Add(Pow(Add(1, Neg(w)); 2), Pow(w; 2), Mul(2, w, Add(1, Neg(w)), Add(Mul(\\alpha, m_D), Neg(V)))))); =), Chain(\\lambda_{\\mathbf K,4}, Neg(Sqrt(Add(Pow(Add(1, Neg(w)); 2), Pow(w; 2), Mul(2, w, Add(1, Neg(w)), Add(Mul(\\alpha, m_D), V))))); =))",
        "Mayitzin/ahrs/ahrs/filters/saam.py",
    ),
    (
        "\\left[ {}^Bp^{\\text{ZMP}}_W \\times f^{\\text{ZMP}}_{net,W} \\right]_y = {}^Bp^{\\text{ZMP}}_{W_z} f^{\\text{ZMP}}_{net,W_x} - {}^Bp^{\\text{ZMP}}_{W_x} f^{\\text{ZMP}}_{net,W_z} = \\sum_i \\left[ {}^Bp^{B_i}_W \\times f^{B_i}_W \\right]_y.",
        "Chain(Marked(Cross(\\prescript { B } { } { p } _ { W } ^ { \\text { Z M P } }; f _ { n e t , W } ^ { \\text { Z M P } }); _{ y }), Add(Mul(\\prescript { B } { } { p } _ { W _ { z } } ^ { \\text { Z M P } }, f _ { n e t , W _ { x } } ^ { \\text { Z M P } }), Neg(Mul(\\prescript { B } { } { p } _ { W _ { x } } ^ { \\text { Z M P } }, f _ { n e t , W _ { z } } ^ { \\text { Z M P } }))), BigSum(i; Marked(Cross(\\prescript { B } { } { p } _ { W } ^ { B _ { i } }; f _ { W } ^ { B _ { i } }); _{ y })); =, =)",
        "RussTedrake/underactuated/book/humanoids.html",
    ),
    (
        "\\dot{\\tilde{E}}({\\bf x}) =& \\dot{E}({\\bf x}) = \\dot\\theta \\ddot\\theta + \\dot\\theta s \\\\ =& \\dot\\theta [ -uc - s] + \\dot\\theta s \\\\ =& - u\\dot\\theta \\cos\\theta.",
        "Chain(Call(\\dot{\\tilde{E}}; \\mathbf{x}), Call(\\dot{E}; \\mathbf{x}), Add(Mul(Call(\\dot{\\theta}), Call(\\ddot{\\theta})), Mul(Call(\\dot{\\theta}), s)), Add(Mul(Call(\\dot{\\theta}), Add(Neg(Mul(u, c)), Neg(s))), Mul(Call(\\dot{\\theta}), s)), Neg(Mul(u, Call(\\dot{\\theta}), Call(cos; Call(\\theta)))); =, =, =, =)",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "[R_cN] = [B_cN]^T [RN]",
        "Chain([ R _ { c } N ], Mul(Transpose([ B _ { c } N ]), [ R N ]); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/attRefCorrection/attRefCorrection.rst",
    ),
    (
        "(\\mathbf{a} \\times \\mathbf{b} ) \\times \\mathbf{c} \\neq \\mathbf{a} \\times (\\mathbf{b} \\times \\mathbf{c})",
        "Chain(Cross(Cross(\\mathbf{a}; \\mathbf{b}); \\mathbf{c}), Cross(\\mathbf{a}; Cross(\\mathbf{b}; \\mathbf{c})); \\ne)",
        "sympy/sympy/doc/src/explanation/modules/physics/vector/vectors/vectors.rst",
    ),
    (
        "\\dot{\\rho}(t) = \\pm \\ddot{\\rho}_{\\text{max}} (t - t_{s1}) + \\dot{\\rho}(t_{s1})",
        "Chain(Call(\\dot{\\rho}; t), Add(PlusMinus(Mul(\\ddot { \\rho } _ { \\text { m a x } }, Add(t, Neg(t_{s1})))), Call(\\dot{\\rho}; t_{s1})); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedLinearTranslation/prescribedLinearTranslation.rst",
    ),
    (
        "\\bar{v}(\\bar{u}, \\bar{q}, t) = \\begin{bmatrix} {}^N\\bar{v}^{B_{1o}} \\cdot \\hat{n}_x \\\\ {}^N\\bar{v}^{B_{1o}} \\cdot \\hat{n}_y \\\\ {}^N\\bar{v}^{B_{1o}} \\cdot \\hat{n}_z \\\\ {}^N\\bar{\\omega}^{B_1} \\cdot \\hat{n}_x \\\\ {}^N\\bar{\\omega}^{B_1} \\cdot \\hat{n}_y \\\\ {}^N\\bar{\\omega}^{B_1} \\cdot \\hat{n}_z \\\\ \\vdots \\\\ {}^N\\bar{v}^{B_{\\nu o}} \\cdot \\hat{n}_x \\\\ {}^N\\bar{v}^{B_{\\nu o}} \\cdot \\hat{n}_y \\\\ {}^N\\bar{v}^{B_{\\nu o}} \\cdot \\hat{n}_z \\\\ {}^N\\bar{\\omega}^{B_\\nu} \\cdot \\hat{n}_x \\\\ {}^N\\bar{\\omega}^{B_\\nu} \\cdot \\hat{n}_y \\\\ {}^N\\bar{\\omega}^{B_\\nu} \\cdot \\hat{n}_z \\\\ \\end{bmatrix} \\in \\mathbb{R}^{6\\nu}",
        "Chain(Call(\\bar{v}; \\bar{u}, \\bar{q}, t), MatrixOf(Mul(\\prescript { N } { } { \\bar { v } } ^ { B _ { 1 o } }, \\hat{n}_x; 1), Mul(\\prescript { N } { } { \\bar { v } } ^ { B _ { 1 o } }, \\hat{n}_y; 1), Mul(\\prescript { N } { } { \\bar { v } } ^ { B _ { 1 o } }, \\hat{n}_z; 1), Mul(\\prescript { N } { } { \\bar { \\omega } } ^ { B _ { 1 } }, \\hat{n}_x; 1), Mul(\\prescript { N } { } { \\bar { \\omega } } ^ { B _ { 1 } }, \\hat{n}_y; 1), Mul(\\prescript { N } { } { \\bar { \\omega } } ^ { B _ { 1 } }, \\hat{n}_z; 1), Dots(), Mul(\\prescript { N } { } { \\bar { v } } ^ { B _ { \\nu o } }, \\hat{n}_x; 1), Mul(\\prescript { N } { } { \\bar { v } } ^ { B _ { \\nu o } }, \\hat{n}_y; 1), Mul(\\prescript { N } { } { \\bar { v } } ^ { B _ { \\nu o } }, \\hat{n}_z; 1), Mul(\\prescript { N } { } { \\bar { \\omega } } ^ { B _ { \\nu } }, \\hat{n}_x; 1), Mul(\\prescript { N } { } { \\bar { \\omega } } ^ { B _ { \\nu } }, \\hat{n}_y; 1), Mul(\\prescript { N } { } { \\bar { \\omega } } ^ { B _ { \\nu } }, \\hat{n}_z; 1)), Pow(\\mathbb{R}; Mul(6, \\nu)); =, \\in)",
        "moorepants/learn-multibody-dynamics/tmt.rst",
    ),
    (
        "t_s = t_0 + \\frac{\\Delta t}{2}",
        "Chain(t_s, Add(t_0, Div(\\Delta t; 2)); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/prescribedRot2DOF/prescribedRot2DOF.rst",
    ),
    (
        "\\mathbf{q} = \\begin{pmatrix} \\cos\\frac{\\beta}{2} \\\\ u_x\\sin\\frac{\\beta}{2} \\\\ u_y\\sin\\frac{\\beta}{2} \\\\ u_z\\sin\\frac{\\beta}{2} \\end{pmatrix}",
        "Chain(\\mathbf{q}, MatrixOf(Call(cos; Div(\\beta; 2)), Mul(u_x, Call(sin; Div(\\beta; 2))), Mul(u_y, Call(sin; Div(\\beta; 2))), Mul(u_z, Call(sin; Div(\\beta; 2)))); =)",
        "Mayitzin/ahrs/ahrs/filters/fqa.py",
    ),
    (
        "L_B = m\\mathbf{v^*}",
        "Chain(L_B, Mul(m, \\mathbf { v } ^ { * }); =)",
        "sympy/sympy/doc/src/explanation/modules/physics/mechanics/masses.rst",
    ),
    (
        "k = \\frac{b\\mathrm{g}_p - a\\mathrm{g}_e}{a\\mathrm{g}_e} = \\frac{b\\mathrm{g}_p}{a\\mathrm{g}_e}-1",
        "Chain(k, Div(Add(Mul(b, \\text{g}_p), Neg(Mul(a, \\text{g}_e))); Mul(a, \\text{g}_e)), Add(Div(Mul(b, \\text{g}_p); Mul(a, \\text{g}_e)), Neg(1)); =, =)",
        "Mayitzin/ahrs/ahrs/utils/geodesy.py",
    ),
    (
        "{\\bf x}[n+1] = {\\bf A}{\\bf x}[n] + {\\bf B}{\\bf u}[n] + {\\bf w}[n], \\\\ \\mathbb{X}_{n+1} = ({\\bf A}\\mathbb{X}_n + {\\bf B}{\\bf u}_n) \\oplus \\mathbb{W}.",
        "System(Chain(Indexed(\\mathbf{x}; Add(n, 1)), Add(Mul(\\mathbf{A}, Indexed(\\mathbf{x}; n)), Mul(\\mathbf{B}, Indexed(\\mathbf{u}; n)), Indexed(\\mathbf{w}; n)); =), Chain(\\mathbb{X}_{n+1}, Operated(\\oplus; Add(Mul(\\mathbf{A}, \\mathbb{X}_n), Mul(\\mathbf{B}, \\mathbf{u}_n)); \\mathbb{W}); =))",
        "RussTedrake/underactuated/book/robust.html",
    ),
    (
        "\\begin{aligned} \\boldsymbol{R}_1 &= X_1\\boldsymbol{\\hat{I}} + Y_1\\boldsymbol{\\hat{J}} + Z_1\\boldsymbol{\\hat{K}}\\\\ \\boldsymbol{R}_2 &= X_2\\boldsymbol{\\hat{I}} + Y_2\\boldsymbol{\\hat{J}} + Z_2\\boldsymbol{\\hat{K}} \\end{aligned}",
        "System(Chain(\\boldsymbol{R}_1, Add(Mul(X_1, \\boldsymbol{\\hat{I}}), Mul(Y_1, \\boldsymbol{\\hat{J}}), Mul(Z_1, \\boldsymbol{\\hat{K}})); =), Chain(\\boldsymbol{R}_2, Add(Mul(X_2, \\boldsymbol{\\hat{I}}), Mul(Y_2, \\boldsymbol{\\hat{J}}), Mul(Z_2, \\boldsymbol{\\hat{K}})); =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-inertial-motion.md",
    ),
    (
        "K_{branch} = C\\left[1 + D\\left(\\frac{Q_{branch}}{Q_{comb}\\cdot \\beta_{branch}^2}\\right)^2 - E\\left(1 - \\frac{Q_{branch}}{Q_{comb}} \\right)^2 - \\frac{F}{\\beta_{branch}^2} \\left(\\frac{Q_{branch}} {Q_{comb}}\\right)^2\\right]",
        "Chain(K_{branch}, Mul(C, Add(1, Mul(D, Pow(Div(Q_{branch}; Mul(Q_{comb}, Pow(\\beta_{branch}; 2))); 2)), Neg(Mul(E, Pow(Add(1, Neg(Div(Q_{branch}; Q_{comb}))); 2))), Neg(Mul(Div(F; Pow(\\beta_{branch}; 2)), Pow(Div(Q_{branch}; Q_{comb}); 2))))); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "J = \\frac{m_1m_2}{m_1+m_2}(v_1^--v_2^-)",
        "Chain(J, Mul(Div(Mul(m_1, m_2); Add(m_1, m_2)), Add(v _ { 1 } ^ { - }, Neg(v _ { 2 } ^ { - }))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "\\begin{aligned} x_1' & = \\frac{r}{V} (x_2-x_1), \\\\ x_2' & = \\frac{r}{V} (x_1-x_2). \\end{aligned}",
        "System(Chain(x_1', Mul(Div(r; V), Add(x_2, Neg(x_1))); =), Chain(x_2', Mul(Div(r; V), Add(x_1, Neg(x_2))); =))",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "K_{\\nu}(z) = \\frac{1}{2} \\left[ \\left(\\frac{z}{2}\\right)^{-\\nu} \\Gamma(\\nu) {}_0F_1\\left(1-\\nu, \\frac{z^2}{4}\\right) - \\left(\\frac{z}{2}\\right)^{\\nu} \\frac{\\pi}{\\nu \\sin(\\pi \\nu) \\Gamma(\\nu)} {}_0F_1\\left(\\nu+1, \\frac{z^2}{4}\\right) \\right]",
        "Chain(Call(K_\\nu; z), Mul(Div(1; 2), Add(Mul(Pow(Div(z; 2); Neg(\\nu)), Call(Gamma; \\nu), Call(\\prescript { } { 0 } { F } _ { 1 }; Add(1, Neg(\\nu)), Div(Pow(z; 2); 4))), Neg(Mul(Pow(Div(z; 2); \\nu), Div(\\pi; Mul(\\nu, Call(sin; Mul(\\pi, \\nu)), Call(Gamma; \\nu))), Call(\\prescript { } { 0 } { F } _ { 1 }; Add(\\nu, 1), Div(Pow(z; 2); 4)))))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "U = U(\\boldsymbol{q},\\dot{\\boldsymbol{q}},t) = U(\\boldsymbol{r}(\\boldsymbol{q},t),\\dot{\\boldsymbol{r}}(\\boldsymbol{q},\\dot{\\boldsymbol{q}},t),t)",
        "Chain(Call(U), Call(U; Call(\\boldsymbol{q}), Call(\\dot{\\boldsymbol{q}}), t), Call(U; Call(\\boldsymbol{r}; Call(\\boldsymbol{q}), t), Call(\\dot{\\boldsymbol{r}}; Call(\\boldsymbol{q}), Call(\\dot{\\boldsymbol{q}}), t), t); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "\\dot{x} = A x + B u",
        "Chain(Call(\\dot{x}), Add(Mul(A, Call(x)), Mul(B, u)); =)",
        "sympy/sympy/doc/src/tutorials/physics/control/mechanics_problems.rst",
    ),
    (
        "h_1 = \\sqrt{\\mu_{\\text{sun}} R_{\\text{Neptune}}\\left(1 - e_1\\right)}",
        "Chain(h_1, Sqrt(Mul(\\mu_{sun}, R_{Neptune}, Add(1, Neg(e_1)))); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-arrival-flyby.md",
    ),
    (
        "E = \\frac{v^2}{2} - \\frac{\\mu}{r}",
        "Chain(E, Add(Div(Pow(v; 2); 2), Neg(Div(\\mu; r))); =)",
        "bryanwweber/orbital-mechanics-notes/constants-of-orbital-motion/energy-is-conserved-in-orbital-motion.md",
    ),
    (
        "\\begin{bmatrix} \\ddot\\theta & \\dot\\theta & \\sin\\theta \\end{bmatrix} \\begin{bmatrix} ml^2 \\\\ b \\\\ mgl \\end{bmatrix} - \\tau = 0.",
        "Chain(Add(Mul(MatrixOf(Call(\\ddot{\\theta}), Call(\\dot{\\theta}), Call(sin; Call(\\theta))), MatrixOf(Mul(m, Pow(l; 2)), b, Mul(m, g, l))), Neg(\\tau)), 0; =)",
        "RussTedrake/underactuated/book/sysid.html",
    ),
    (
        "G2 &= \\frac{1}{1 + s}",
        "Chain(\\text{G2}, Div(1; Add(1, s)); =)",
        "sympy/sympy/doc/src/tutorials/physics/control/control_problems.rst",
    ),
    (
        "{}^N\\bar{v}^S = {}^A\\bar{v}^S + {}^N\\bar{\\omega}^A\\times\\bar{r}^{S/O}",
        "Chain(\\prescript { N } { } { \\bar { v } } ^ { S }, Add(\\prescript { A } { } { \\bar { v } } ^ { S }, Cross(\\prescript { N } { } { \\bar { \\omega } } ^ { A }; \\bar { r } ^ { S / O })); =)",
        "moorepants/learn-multibody-dynamics/translational.rst",
    ),
    (
        "\\frac{\\mu^2}{h^3}t = \\int_{0}^{\\nu}\\frac{d\\nu}{\\left(1 + e\\cos\\nu\\right)^2}",
        "Chain(Mul(Div(Pow(\\mu; 2); Pow(h; 3)), t), Integral(Div(1; Pow(Add(1, Mul(e, Call(cos; \\nu))); 2)); \\nu; 0; \\nu); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "\\frac{m_1}{m_2} + \\frac{m_2}{m_1} \\geq 25",
        "Chain(Add(Div(m_1; m_2), Div(m_2; m_1)), 25; \\ge)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/lagrange-points.md",
    ),
    (
        "K = 0.42\\sin(\\alpha/2) + 2.56\\sin^3(\\alpha/2)",
        "Chain(K, Add(Mul(0.42, Call(sin; Div(\\alpha; 2))), Mul(2.56, Pow(Call(sin; Div(\\alpha; 2)); 3))); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "e^{\\frac{\\Delta t}{2}\\boldsymbol\\Omega_t} = \\sum_{k=0}^\\infty \\frac{1}{k!} \\Big(\\frac{\\Delta t}{2}\\boldsymbol\\Omega_t\\Big)^k",
        "Chain(Pow(e; Mul(Div(\\Delta t; 2), \\boldsymbol{\\Omega}_t)), BigSum(k; 0; Infinity(); Mul(Div(1; Factorial(k)), Pow(Mul(Div(\\Delta t; 2), \\boldsymbol{\\Omega}_t); k))); =)",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "\\Delta Q_n = Q_n(d_{max}) - Q_n(d_{min})",
        "Chain(\\Delta Q _ { n }, Add(Call(Q_n; d_{max}), Neg(Call(Q_n; d_{min}))); =)",
        "CalebBell/fluids/fluids/particle_size_distribution.py",
    ),
    (
        "\\bar{v} = v_x \\hat{a}_x + v_y \\hat{a}_y + v_z \\hat{a}_z",
        "Chain(\\bar{v}, Add(Mul(v_x, \\hat{a}_x), Mul(v_y, \\hat{a}_y), Mul(v_z, \\hat{a}_z)); =)",
        "moorepants/learn-multibody-dynamics/vectors.rst",
    ),
    (
        "\\mathrm{d} \\sigma = \\frac{\\mathrm{d}N}{I} = 2\\pi b \\mathrm{d} b = \\frac{b(\\theta)}{\\sin \\theta} |b'(\\theta)| \\mathrm{d} \\omega",
        "Chain(Total(\\sigma), Div(Total(N); I), Mul(2, \\pi, Call(b), Total(Call(b))), Mul(Div(Call(b; \\theta); Call(sin; \\theta)), Bars(Call(b'; \\theta)), Total(\\omega)); =, =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "f(x) = \\sqrt{\\frac{2}{\\pi}} \\int_{0}^\\infty F(k) \\cos(2\\pi x k) \\mathrm{d} k.",
        "Chain(Call(f; x), Mul(Sqrt(Div(2; \\pi)), Integral(Mul(Call(F; k), Call(cos; Mul(2, \\pi, x, k))); k; 0; Infinity())); =)",
        "sympy/sympy/sympy/integrals/transforms.py",
    ),
    (
        "^N \\mathbf{H} ^ {B^*/O} = \\mathbf{r^*} \\times m \\mathbf{v^*}",
        "Chain(\\prescript { N } { } { \\mathbf { H } } ^ { B ^ { * } / O }, Cross(\\mathbf { r } ^ { * }; Mul(m, \\mathbf { v } ^ { * })); =)",
        "sympy/sympy/doc/src/explanation/modules/physics/mechanics/masses.rst",
    ),
    (
        "\\log\\mathbf{q} = \\begin{bmatrix} \\log\\|\\mathbf{q}\\| \\\\ \\mathbf{u}\\theta \\end{bmatrix}",
        "Chain(Call(log; \\mathbf{q}), MatrixOf(Call(log; Norm(\\mathbf{q})), Mul(\\mathbf{u}, \\theta)); =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "ml^2 \\ddot\\theta = u_0 - mgl \\sin\\theta - b\\dot\\theta,",
        "Chain(Mul(m, Pow(l; 2), Call(\\ddot{\\theta})), Add(u_0, Neg(Mul(m, g, l, Call(sin; Call(\\theta)))), Neg(Mul(b, Call(\\dot{\\theta})))); =)",
        "RussTedrake/underactuated/book/pend.html",
    ),
    (
        "\\lvert y \\rvert = e^{\\frac{x^2}{2} + C} = e^{\\frac{x^2}{2}} e^C = D e^{\\frac{x^2}{2}} ,",
        "Chain(Bars(y), Pow(e; Add(Div(Pow(x; 2); 2), C)), Mul(Pow(e; Div(Pow(x; 2); 2)), Pow(e; C)), Mul(D, Pow(e; Div(Pow(x; 2); 2))); =, =, =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\ddot{\\boldsymbol{r}} = -\\frac{\\mu_1}{r_1^3}\\boldsymbol{r}_1 - \\frac{\\mu_2}{r_2^3}\\boldsymbol{r}_2",
        "Chain(Call(\\ddot{\\boldsymbol{r}}), Add(Neg(Mul(Div(\\mu_1; Pow(r_1; 3)), \\boldsymbol{r}_1)), Neg(Mul(Div(\\mu_2; Pow(r_2; 3)), \\boldsymbol{r}_2))); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "G_{MSH} = \\Delta P_{lo} + 2\\left[\\Delta P_{go} - \\Delta P_{lo}\\right]x",
        "Chain(G_{MSH}, Add(\\Delta P _ { l o }, Mul(2, Add(\\Delta P _ { g o }, Neg(\\Delta P _ { l o })), x)); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "\\text{Velocity of approach} = \\frac{1}{\\sqrt{1 - \\beta^4}}",
        "Chain(\\text{Velocity~of~approach}, Div(1; Sqrt(Add(1, Neg(Pow(\\beta; 4))))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "\\bar{r}^{P_4/P_1} \\cdot \\hat{n}_y = 0",
        "Chain(Mul(\\bar { r } ^ { P _ { 4 } / P _ { 1 } }, \\hat{n}_y; 1), 0; =)",
        "moorepants/learn-multibody-dynamics/configuration.rst",
    ),
    (
        "T_2 = \\frac{2\\pi}{\\sqrt{\\mu}} a_2^{3/2}",
        "Chain(T_2, Mul(Div(Mul(2, \\pi); Sqrt(\\mu)), Pow(a_2; Div(3; 2))); =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/phasing-maneuvers.md",
    ),
    (
        "x_t = [e_t, \\dot{e}_t, \\theta_t, \\dot{\\theta}_t, \\upsilon_t]^T",
        "Chain(x_t, Transpose(Tuple(Call(e_t), Call(\\dot{e}_t), Call(\\theta_t), Call(\\dot{\\theta}_t), \\upsilon_t; [])); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/lqr_speed_and_steering_control/lqr_speed_and_steering_control_main.rst",
    ),
    (
        "\\dot{\\mathbf{x}}_t = \\frac{d\\mathbf{x}_t}{dt} = \\mathbf{Ax}_t + \\mathbf{Lw}_t",
        "Chain(Call(\\dot{\\mathbf{x}}_t), Derivative(Call(\\mathbf{x}_t); t, 1), Add(Mul(\\mathbf{A}, Call(\\mathbf{x}_t)), Mul(\\mathbf{L}, \\mathbf{w}_t)); =, =)",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "{}^N\\bar{v}^S = {}^N\\bar{v}^P + {}^N\\bar{\\omega}^A \\times \\bar{r}^{S/P}",
        "Chain(\\prescript { N } { } { \\bar { v } } ^ { S }, Add(\\prescript { N } { } { \\bar { v } } ^ { P }, Cross(\\prescript { N } { } { \\bar { \\omega } } ^ { A }; \\bar { r } ^ { S / P })); =)",
        "moorepants/learn-multibody-dynamics/translational.rst",
    ),
    (
        "& \\lim_{x \\to 0} ~x \\frac{Q(x)}{P(x)} = \\lim_{x \\to 0} ~x \\frac{x(1+x)}{x^2} = \\lim_{x \\to 0} ~(1+x) = 1 , \\\\ & \\lim_{x \\to 0} ~x^2 \\frac{R(x)}{P(x)} = \\lim_{x \\to 0} ~x^2 \\frac{(\\pi+x^2)}{x^2} = \\lim_{x \\to 0} ~(\\pi+x^2) = \\pi .",
        "System(Chain(Limiting(lim; _{ x \\to 0 }; Mul(x, Div(Call(Q; x); Call(P; x)))), Limiting(lim; _{ x \\to 0 }; Mul(x, Div(Mul(x, Add(1, x)); Pow(x; 2)))), Limiting(lim; _{ x \\to 0 }; Add(1, x)), 1; =, =, =), Chain(Limiting(lim; _{ x \\to 0 }; Mul(Pow(x; 2), Div(Call(R; x); Call(P; x)))), Limiting(lim; _{ x \\to 0 }; Mul(Pow(x; 2), Div(Add(\\pi, Pow(x; 2)); Pow(x; 2)))), Limiting(lim; _{ x \\to 0 }; Add(\\pi, Pow(x; 2))), \\pi; =, =, =))",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "& \\mathrm{sn}\\,^2x+\\mathrm{cn}\\,^2x=1 \\\\ & \\mathrm{dn}\\,^2x+k^2\\mathrm{sn}\\,^2x=1",
        "System(Chain(Add(Pow(Call(sn; x); 2), Pow(Call(cn; x); 2)), 1; =), Chain(Add(Pow(Call(dn; x); 2), Mul(Pow(k; 2), Pow(Call(sn; x); 2))), 1; =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/appendixA.tex",
    ),
    (
        "K(m) = \\int_0^{\\pi/2} \\frac{dt}{\\sqrt{1-m \\sin^2 t}} = \\int_0^1 \\frac{dt}{\\left(\\sqrt{1-t^2}\\right)\\left(\\sqrt{1-mt^2}\\right)}",
        "Chain(Call(K; m), Integral(Div(1; Sqrt(Add(1, Neg(Mul(m, Pow(Call(sin; t); 2)))))); t; 0; Div(\\pi; 2)), Integral(Div(1; Mul(Sqrt(Add(1, Neg(Pow(t; 2)))), Sqrt(Add(1, Neg(Mul(m, Pow(t; 2))))))); t; 0; 1); =, =)",
        "fredrik-johansson/arb/doc/source/acb_elliptic.rst",
    ),
    (
        "S = \\frac12 \\sum_{i=1}^n m_i\\boldsymbol{a}_i^2",
        "Chain(S, Mul(Div(1; 2), BigSum(i; 1; n; Mul(m_i, Pow(\\boldsymbol{a}_i; 2)))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "[\\mathcal{F}\\mathcal{F}_0] = \\text{PRV2C}(\\phi, {}^\\mathcal{F} \\boldsymbol{\\hat{s}})",
        "Chain([ \\mathcal { F } \\mathcal { F } _ { 0 } ], Call(\\text{PRV2C}; \\phi, \\prescript { \\mathcal { F } } { } { \\boldsymbol { \\hat { s } } }); =)",
        "AVSLab/basilisk/src/simulation/dynamics/facetSRPDynamicEffector/facetSRPDynamicEffector.rst",
    ),
    (
        "\\boldsymbol{\\hat{\\rho}} = -\\sin\\phi\\boldsymbol{\\hat{\\imath}} + \\cos\\phi \\boldsymbol{\\hat{\\jmath}} + 0 \\boldsymbol{\\hat{k}}",
        "Chain(\\boldsymbol{\\hat{\\rho}}, Add(Neg(Mul(Call(sin; \\phi), \\boldsymbol{\\hat{\\imath}})), Mul(Call(cos; \\phi), \\boldsymbol{\\hat{\\jmath}}), Mul(0, \\boldsymbol{\\hat{k}})); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "\\dot\\theta_{n+1}^{+} = -\\dot\\theta_n^{+} \\cos(2\\alpha).",
        "Chain(Call(\\dot { \\theta } _ { n + 1 } ^ { + }), Neg(Mul(Call(\\dot { \\theta } _ { n } ^ { + }), Call(cos; Mul(2, \\alpha)))); =)",
        "RussTedrake/underactuated/book/simple_legs.html",
    ),
    (
        "A({\\bf q}(t)) = \\int_{t_0}^{t_1} T({\\bf q},\\dot{\\bf q})dt,",
        "Chain(Call(A; Call(\\mathbf{q}; t)), Integral(Call(T; Call(\\mathbf{q}), Call(\\dot{\\mathbf{q}})); t; t_0; t_1); =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "\\theta = \\omega_1 t + \\theta_0",
        "Chain(\\theta, Add(Mul(\\omega_1, t), \\theta_0); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "\\nu_i = \\alpha \\pm \\cos^{-1}\\left(\\frac{c}{a}\\cos\\alpha\\right)",
        "Chain(\\nu_i, Add(\\alpha, PlusMinus(Call(arccos; Mul(Div(c; a), Call(cos; \\alpha))))); =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/apse-line-rotation-example.md",
    ),
    (
        "\\Delta v = \\lvert v_p - v_{\\text{parking}}\\rvert",
        "Chain(\\Delta v, Bars(Add(v_p, Neg(v_{parking}))); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-departure-trajectory.md",
    ),
    (
        "S(\\omega) = \\sqrt{\\frac{2}{\\pi}}\\,\\frac{S_0\\,\\omega_0^4} {(\\omega^2-\\omega_0^2)^2 + \\omega_0^2\\omega^2/Q^2}",
        "Chain(Call(S; \\omega), Mul(Sqrt(Div(2; \\pi)), Div(Mul(S_0, Pow(\\omega_0; 4)); Add(Pow(Add(Pow(\\omega; 2), Neg(Pow(\\omega_0; 2))); 2), Div(Mul(Pow(\\omega_0; 2), Pow(\\omega; 2)); Pow(Q; 2))))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "v_{r,0} = \\boldsymbol{v}\\cdot\\boldsymbol{\\hat{u}}_r = \\boldsymbol{v}\\cdot\\frac{\\boldsymbol{r}}{r}",
        "Chain(v_{r,0}, Mul(\\boldsymbol{v}, \\boldsymbol{\\hat{u}}_r; 1), Mul(\\boldsymbol{v}, Div(\\boldsymbol{r}; r); 1); =, =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-lagrange-coefficients-example.md",
    ),
    (
        "\\bm {a}_{n} = \\bm{a}_{P1} \\times \\bm{R}_{P2} + \\bm{R}_{P1} \\times \\bm{a}_{P2} + 2 \\bm{v}_{P1} \\times \\bm{v}_{P2}",
        "Chain(\\bm{a}_n, Add(Cross(\\bm{a}_{P1}; \\bm{R}_{P2}), Cross(\\bm{R}_{P1}; \\bm{a}_{P2}), Cross(Mul(2, \\bm{v}_{P1}); \\bm{v}_{P2})); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/celestialTwoBodyPoint/_Documentation/celestialTwoBodyPoint.tex",
    ),
    (
        "b = 7.3 - 15.7\\beta + 170.8\\beta^2 - 399.7\\beta^3 + 332.2\\beta^4",
        "Chain(b, Add(7.3, Neg(Mul(15.7, \\beta)), Mul(170.8, Pow(\\beta; 2)), Neg(Mul(399.7, Pow(\\beta; 3))), Mul(332.2, Pow(\\beta; 4))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "\\begin{gathered}\\mu_x = \\mu_p + \\mu_z \\\\ \\sigma_x^2 = \\sigma_z^2+\\sigma_p^2\\, \\end{gathered}",
        "System(Chain(\\mu_x, Add(\\mu_p, \\mu_z); =), Chain(Pow(\\sigma_x; 2), Add(Pow(\\sigma_z; 2), Pow(\\sigma_p; 2)); =))",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_main.rst",
    ),
    (
        "\\ddot{\\bf q}_1 = {\\bf M}_{11}^{-1} ({\\bf \\tau}_1 - {\\bf M}_{12} \\ddot{\\bf q}_2)",
        "Chain(Call(\\ddot{\\mathbf{q}}_1), Mul(Pow(\\mathbf{M}_{11}; Neg(1)), Add(\\mathbf{\\tau}_1, Neg(Mul(\\mathbf{M}_{12}, Call(\\ddot{\\mathbf{q}}_2))))); =)",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\mathbf{W}_a = \\begin{bmatrix} a_z & a_y & -a_x & 0 \\\\ a_y & -a_z & 0 & a_x \\\\ -a_x & 0 & -a_z & a_y \\\\ 0 & a_x & a_y & a_z \\end{bmatrix}",
        "Chain(\\mathbf{W}_a, MatrixOf(a_z, a_y, Neg(a_x), 0, a_y, Neg(a_z), 0, a_x, Neg(a_x), 0, Neg(a_z), a_y, 0, a_x, a_y, a_z); =)",
        "Mayitzin/ahrs/ahrs/filters/fkf.py",
    ),
    (
        "X(t) = e^{A t} ( \\int e^{- A t} b \\,dt + C)",
        "Chain(Call(X; t), Mul(Pow(e; Mul(A, t)), Add(Antiderivative(Mul(Pow(e; Neg(Mul(A, t))), b); t), C)); =)",
        "sympy/sympy/sympy/solvers/ode/systems.py",
    ),
    (
        "\\lambda_{s0}(c_1, c_2) = c_1 (q - p)|\\omega|^{1/(q - p)} \\sin{\\psi} + c_2 (v - u)|\\sigma|^{1/(v - u)} \\sin{\\theta}",
        "Chain(Call(\\lambda_{s0}; c_1, c_2), Add(Mul(c_1, Add(q, Neg(p)), Pow(Bars(\\omega); Div(1; Add(q, Neg(p)))), Call(sin; \\psi)), Mul(c_2, Add(v, Neg(u)), Pow(Bars(\\sigma); Div(1; Add(v, Neg(u)))), Call(sin; \\theta))); =)",
        "sympy/sympy/doc/src/modules/integrals/g-functions.rst",
    ),
    (
        "F(\\vec{x}) = 2 \\vec{x} .",
        "Chain(Call(F; \\vec{x}), Mul(2, \\vec{x}); =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "m_{\\text{sc}} \\ddot{y}_{B/N}+\\sum_{i}^{N}m_{\\text{sp}_i} d_i \\ddot{\\theta}_i = F_{y}",
        "Chain(Add(Mul(m_{sc}, Call(\\ddot{y}_{B/N})), Limiting(sum; _{ i }^{ N }; Mul(m_{sp_i}, d_i, Call(\\ddot{\\theta}_i)))), F_y; =)",
        "AVSLab/basilisk/src/simulation/dynamics/HingedRigidBodies/_Documentation/secTest.tex",
    ),
    (
        "\\omega = \\sqrt{\\omega_0^2 -\\beta^2} ,\\quad \\phi = \\arctan\\left(\\frac{\\dot{x}_0}{x_0 \\omega} + \\frac{\\beta}{\\omega}\\right),\\quad a = x_0\\left[1+\\left(\\frac{\\dot{x}_0}{x_0\\omega} + \\frac{\\beta}{\\omega}\\right)^2\\right]",
        "System(Chain(\\omega, Sqrt(Add(Pow(\\omega_0; 2), Neg(Pow(\\beta; 2)))); =), Chain(\\phi, Call(arctan; Add(Div(\\dot { x } _ { 0 }; Mul(x_0, \\omega)), Div(\\beta; \\omega))); =), Chain(a, Mul(x_0, Add(1, Pow(Add(Div(\\dot { x } _ { 0 }; Mul(x_0, \\omega)), Div(\\beta; \\omega)); 2))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter5.tex",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{C}_1 &=& \\mathbf{P}_1\\mathbf{q} = \\begin{bmatrix}q_w^2+q_x^2-q_y^2-q_z^2 \\\\ 2(q_xq_y + q_wq_z) \\\\ 2(q_xq_z - q_wq_y) \\end{bmatrix} \\\\ && \\\\ \\mathbf{C}_2 &=& \\mathbf{P}_2\\mathbf{q} = \\begin{bmatrix}2(q_xq_y - q_wq_z) \\\\ q_w^2-q_x^2+q_y^2-q_z^2 \\\\2(q_wq_x + q_yq_z) \\end{bmatrix} \\\\ && \\\\ \\mathbf{C}_3 &=& \\mathbf{P}_3\\mathbf{q} = \\begin{bmatrix}2(q_xq_z + q_wq_y) \\\\ 2(q_yq_z - q_wq_x) \\\\ q_w^2-q_x^2-q_y^2+q_z^2 \\end{bmatrix} \\end{array}",
        "System(Chain(\\mathbf{C}_1, Mul(\\mathbf{P}_1, \\mathbf{q}), MatrixOf(Add(Pow(q_w; 2), Pow(q_x; 2), Neg(Pow(q_y; 2)), Neg(Pow(q_z; 2))), Mul(2, Add(Mul(q_x, q_y), Mul(q_w, q_z))), Mul(2, Add(Mul(q_x, q_z), Neg(Mul(q_w, q_y))))); =, =), Chain(\\mathbf{C}_2, Mul(\\mathbf{P}_2, \\mathbf{q}), MatrixOf(Mul(2, Add(Mul(q_x, q_y), Neg(Mul(q_w, q_z)))), Add(Pow(q_w; 2), Neg(Pow(q_x; 2)), Pow(q_y; 2), Neg(Pow(q_z; 2))), Mul(2, Add(Mul(q_w, q_x), Mul(q_y, q_z)))); =, =), Chain(\\mathbf{C}_3, Mul(\\mathbf{P}_3, \\mathbf{q}), MatrixOf(Mul(2, Add(Mul(q_x, q_z), Mul(q_w, q_y))), Mul(2, Add(Mul(q_y, q_z), Neg(Mul(q_w, q_x)))), Add(Pow(q_w; 2), Neg(Pow(q_x; 2)), Neg(Pow(q_y; 2)), Pow(q_z; 2))); =, =))",
        "Mayitzin/ahrs/ahrs/filters/flae.py",
    ),
    (
        "\\mathbf{F} = e^{\\mathbf{A}\\Delta t} = \\mathbf{I} + \\mathbf{A}\\Delta t + \\frac{(\\mathbf{A}\\Delta t)^2}{2!} + \\frac{(\\mathbf{A}\\Delta t)^3}{3!} + \\cdots = \\sum_{k=0}^\\infty\\frac{(\\mathbf{A}\\Delta t)^k}{k!}",
        "Chain(\\mathbf{F}, Pow(e; Mul(\\mathbf{A}, \\Delta t)), Add(\\mathbf{I}, Mul(\\mathbf{A}, \\Delta t), Div(Pow(Mul(\\mathbf{A}, \\Delta t); 2); Factorial(2)), Div(Pow(Mul(\\mathbf{A}, \\Delta t); 3); Factorial(3)), Dots()), BigSum(k; 0; Infinity(); Div(Pow(Mul(\\mathbf{A}, \\Delta t); k); Factorial(k))); =, =, =)",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "x &= \\beta(z, \\dot z, \\dots, z^{(q)}) \\\\ u &= \\gamma(z, \\dot z, \\dots, z^{(q)}).",
        "System(Chain(x, Call(\\beta; Call(z), Call(\\dot{z}), Dots(), z ^ { ( q ) }); =), Chain(u, Call(\\gamma; Call(z), Call(\\dot{z}), Dots(), z ^ { ( q ) }); =))",
        "python-control/python-control/doc/flatsys.rst",
    ),
    (
        "\\dfrac{\\mathrm{d} v_D}{\\mathrm{d} t}\\boldsymbol{u} + v_D\\dfrac{\\mathrm{d} \\boldsymbol{u}}{\\mathrm{d} t} = -\\frac72kg\\boldsymbol{u}",
        "Chain(Add(Mul(Derivative(Call(v_D); t, 1), Call(\\boldsymbol{u})), Mul(Call(v_D), Derivative(Call(\\boldsymbol{u}); t, 1))), Neg(Mul(Div(7; 2), k, g, Call(\\boldsymbol{u}))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "T = \\frac{1}{2}I\\dot\\theta^2, \\quad U = -mgl\\cos(\\theta),",
        "System(Chain(T, Mul(Div(1; 2), I, Pow(Call(\\dot{\\theta}); 2)); =), Chain(U, Neg(Mul(m, g, l, Call(cos; Call(\\theta)))); =))",
        "RussTedrake/underactuated/book/pend.html",
    ),
    (
        "\\mathrm{cn}\\, x \\to \\cos x,\\quad \\mathrm{dn}\\, x \\to 1",
        "System(Chain(Call(cn; x), Call(cos; x); \\to), Chain(Call(dn; x), 1; \\to))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/appendixA.tex",
    ),
    (
        "m_j\\bm{l_j}\\times \\bigg[ l_j\\Big(-\\ddot{\\varphi}_j\\sin(\\varphi_j)\\cos(\\vartheta_j)-\\ddot{\\vartheta}_j\\cos(\\varphi_j)\\sin(\\vartheta_j)-\\dot{\\varphi}_j^2\\cos(\\varphi_j)\\cos(\\vartheta_j)-\\dot{\\vartheta}_j^2\\cos(\\varphi_j)\\cos(\\vartheta_j)\\\\+2\\dot{\\varphi}_j\\dot{\\vartheta}_j\\sin(\\varphi_j)\\sin(\\vartheta_j) \\Big)\\bm{\\hat{p}}_{0_j,1} +l_j\\Big(\\ddot{\\varphi}_j\\cos(\\varphi_j)\\cos(\\vartheta_j)-\\ddot{\\vartheta}_j\\sin(\\varphi_j)\\sin(\\vartheta_j)-\\dot{\\varphi}_j^2\\sin(\\varphi_j)\\cos(\\vartheta_j)\\\\-\\dot{\\vartheta}_j^2\\sin(\\varphi_j)\\cos(\\vartheta_j)-2\\dot{\\varphi}_j\\dot{\\vartheta}_j\\cos(\\varphi_j)\\sin(\\vartheta_j) \\Big)\\bm{\\hat{p}}_{0_j,2} +l_j\\Big(-\\ddot{\\vartheta}_j\\cos(\\vartheta_j)+\\dot{\\vartheta}_j^2\\sin(\\vartheta_j) \\Big)\\bm{\\hat{p}}_{0_j,3}\\\\ +\\bm{\\dot{\\omega}}_{B/N}\\times \\bm{l_j} + 2\\bm\\omega_{\\cal B/N}\\times \\bm{l_j'}+\\bm\\omega_{\\cal B/N}\\times(\\bm\\omega_{\\cal B/N}\\times \\bm{l_j})\\bigg]=\\bm{L}_{T,j}+m_{j} \\bm{\\ddot{r}}_{T/N}\\times \\bm{l_j}",
        "Chain(Cross(Mul(m_j, \\bm{l}_j); Add(Mul(l_j, Add(Neg(Mul(Call(\\ddot{\\varphi}_j), Call(sin; Call(\\varphi_j)), Call(cos; Call(\\vartheta_j)))), Neg(Mul(Call(\\ddot{\\vartheta}_j), Call(cos; Call(\\varphi_j)), Call(sin; Call(\\vartheta_j)))), Neg(Mul(Pow(Call(\\dot{\\varphi}_j); 2), Call(cos; Call(\\varphi_j)), Call(cos; Call(\\vartheta_j)))), Neg(Mul(Pow(Call(\\dot{\\vartheta}_j); 2), Call(cos; Call(\\varphi_j)), Call(cos; Call(\\vartheta_j)))), Mul(2, Call(\\dot{\\varphi}_j), Call(\\dot{\\vartheta}_j), Call(sin; Call(\\varphi_j)), Call(sin; Call(\\vartheta_j)))), \\bm{\\hat{p}}_{0_j,1}), Mul(l_j, Add(Mul(Call(\\ddot{\\varphi}_j), Call(cos; Call(\\varphi_j)), Call(cos; Call(\\vartheta_j))), Neg(Mul(Call(\\ddot{\\vartheta}_j), Call(sin; Call(\\varphi_j)), Call(sin; Call(\\vartheta_j)))), Neg(Mul(Pow(Call(\\dot{\\varphi}_j); 2), Call(sin; Call(\\varphi_j)), Call(cos; Call(\\vartheta_j)))), Neg(Mul(Pow(Call(\\dot{\\vartheta}_j); 2), Call(sin; Call(\\varphi_j)), Call(cos; Call(\\vartheta_j)))), Neg(Mul(2, Call(\\dot{\\varphi}_j), Call(\\dot{\\vartheta}_j), Call(cos; Call(\\varphi_j)), Call(sin; Call(\\vartheta_j))))), \\bm{\\hat{p}}_{0_j,2}), Mul(l_j, Add(Neg(Mul(Call(\\ddot{\\vartheta}_j), Call(cos; Call(\\vartheta_j)))), Mul(Pow(Call(\\dot{\\vartheta}_j); 2), Call(sin; Call(\\vartheta_j)))), \\bm{\\hat{p}}_{0_j,3}), Cross(\\bm{\\dot{\\omega}}_{B/N}; \\bm{l}_j), Cross(Mul(2, \\bm{\\omega}_{\\mathcal B/\\mathcal N}); \\bm{l}_j'), Cross(\\bm{\\omega}_{\\mathcal B/\\mathcal N}; Cross(\\bm{\\omega}_{\\mathcal B/\\mathcal N}; \\bm{l}_j)))), Add(\\bm{L}_{T,j}, Cross(Mul(m_j, \\bm{\\ddot{r}}_{T/N}); \\bm{l}_j)); =)",
        "AVSLab/basilisk/src/simulation/dynamics/sphericalPendulum/_Documentation/secModelDescription.tex",
    ),
    (
        "P = \\rho g \\cdot \\text{head}",
        "Chain(P, Mul(\\rho, g, \\text{head}); =)",
        "CalebBell/fluids/fluids/core.py",
    ),
    (
        "I_{aa} = \\sum_{i=1}^\\nu m_i \\left( \\bar{r}^{P_i/O} \\times \\hat{n}_a \\right) \\cdot \\left( \\bar{r}^{P_i/O} \\times \\hat{n}_a \\right)",
        "Chain(I_{aa}, BigSum(i; 1; \\nu; Mul(m_i, Cross(\\bar { r } ^ { P _ { i } / O }; \\hat{n}_a), Cross(\\bar { r } ^ { P _ { i } / O }; \\hat{n}_a); 2)); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "T = \\frac12\\dot{\\psi}^2 ,\\quad V = -\\frac gl\\cos\\psi",
        "System(Chain(T, Mul(Div(1; 2), Pow(Call(\\dot{\\psi}); 2)); =), Chain(V, Neg(Mul(Div(g; l), Call(cos; Call(\\psi)))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "\\dot{\\boldsymbol{x}}(t_{k}) = \\boldsymbol{f}\\big( t_k, \\boldsymbol{x}(t_{k}), \\dot{\\boldsymbol{x}}(t_{k-1}), \\boldsymbol{u} \\big)",
        "Chain(Call(\\dot{\\boldsymbol{x}}; t_k), Call(\\boldsymbol{f}; t_k, Call(\\boldsymbol{x}; t_k), Call(\\dot{\\boldsymbol{x}}; t_{k-1}), \\boldsymbol{u}); =)",
        "JSBSim-Team/jsbsim-reference-manual/docs/formulation/state-propagation-contract.md",
    ),
    (
        "f^{B_E}_u = -f^{B_E}_g(q) + K_p(p^{E_d} - p^E) + K_d(\\dot{p}^{E_d} - \\dot{p}^E),",
        "Chain(f _ { u } ^ { B _ { E } }, Add(Neg(Call(f _ { g } ^ { B _ { E } }; q)), Mul(K_p, Add(Call(p ^ { E _ { d } }), Neg(Call(p ^ { E })))), Mul(K_d, Add(Call(\\dot { p } ^ { E _ { d } }), Neg(Call(\\dot { p } ^ { E }))))); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "\\begin{bmatrix} [colback=white,colframe=black,boxrule=0.5pt,left=0pt,right=0pt,top=0pt,bottom=0pt]{1} & 2 & 3 & 4 \\\\ 2 & 4 & 5 & 6 \\\\ 3 & 6 & 7 & 8 \\end{bmatrix} \\to \\begin{bmatrix} [colback=white,colframe=black,boxrule=0.5pt,left=0pt,right=0pt,top=0pt,bottom=0pt]{1} & 2 & 3 & 4 \\\\ 0 & 0 & -1 & -2 \\\\ 3 & 6 & 7 & 8 \\end{bmatrix} \\to \\begin{bmatrix} [colback=white,colframe=black,boxrule=0.5pt,left=0pt,right=0pt,top=0pt,bottom=0pt]{1} & 2 & 3 & 4 \\\\ 0 & 0 & -1 & -2 \\\\ 0 & 0 & -2 & -4 \\end{bmatrix} .",
        "Chain(MatrixOf(1, 2, 3, 4, 2, 4, 5, 6, 3, 6, 7, 8), MatrixOf(1, 2, 3, 4, 0, 0, Neg(1), Neg(2), 3, 6, 7, 8), MatrixOf(1, 2, 3, 4, 0, 0, Neg(1), Neg(2), 0, 0, Neg(2), Neg(4)); \\to, \\to)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "\\mathbf{Q} = \\begin{bmatrix} \\sigma_d^2 & 0 \\\\ 0 & \\sigma_\\theta^2 \\end{bmatrix}",
        "Chain(\\mathbf{Q}, MatrixOf(Pow(\\sigma_d; 2), 0, 0, Pow(\\sigma_\\theta; 2)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/ensamble_kalman_filter_localization_files/ensamble_kalman_filter_localization_main.rst",
    ),
    (
        "\\mathbf{y}_{k+1}=\\begin{bmatrix} I & 0_{3\\times3} & 0_{3\\times3}\\\\ \\end{bmatrix}\\mathbf{x}_{k+1}",
        "Chain(\\mathbf{y}_{k+1}, Mul(MatrixOf(I, Marked(0; _{ 3 \\times 3 }), Marked(0; _{ 3 \\times 3 })), \\mathbf{x}_{k+1}); =)",
        "AVSLab/basilisk/src/fswAlgorithms/smallBodyNavigation/smallBodyNavUKF/smallBodyNavUKF.rst",
    ),
    (
        "^N \\mathbf{H} ^ {P/O} = \\mathbf{r} \\times m\\mathbf{v}",
        "Chain(\\prescript { N } { } { \\mathbf { H } } ^ { P / O }, Cross(\\mathbf{r}; Mul(m, \\mathbf{v})); =)",
        "sympy/sympy/doc/src/explanation/modules/physics/mechanics/masses.rst",
    ),
    (
        "r_p = \\frac{h^2}{\\mu}\\frac{1}{1 + e}",
        "Chain(r_p, Mul(Div(Pow(h; 2); \\mu), Div(1; Add(1, e))); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/hyperbolic-trajectories.md",
    ),
    (
        "\\mathbf{h}(\\hat{\\mathbf{q}}_t) = 2 \\begin{bmatrix} g_x (q_w^2 + q_x^2 - q_y^2 - q_z^2) + g_y (q_wq_z + q_xq_y) + g_z (q_xq_z - q_wq_y) \\\\ g_x (q_xq_y - q_wq_z) + g_y (q_w^2 - q_x^2 + q_y^2 - q_z^2) + g_z (q_wq_x + q_yq_z) \\\\ g_x (q_wq_y + q_xq_z) + g_y (q_yq_z - q_wq_x) + g_z (q_w^2 - q_x^2 - q_y^2 + q_z^2) \\end{bmatrix}",
        "Chain(Call(\\mathbf{h}; \\hat{\\mathbf{q}}_t), Mul(2, MatrixOf(Add(Mul(g_x, Add(Pow(q_w; 2), Pow(q_x; 2), Neg(Pow(q_y; 2)), Neg(Pow(q_z; 2)))), Mul(g_y, Add(Mul(q_w, q_z), Mul(q_x, q_y))), Mul(g_z, Add(Mul(q_x, q_z), Neg(Mul(q_w, q_y))))), Add(Mul(g_x, Add(Mul(q_x, q_y), Neg(Mul(q_w, q_z)))), Mul(g_y, Add(Pow(q_w; 2), Neg(Pow(q_x; 2)), Pow(q_y; 2), Neg(Pow(q_z; 2)))), Mul(g_z, Add(Mul(q_w, q_x), Mul(q_y, q_z)))), Add(Mul(g_x, Add(Mul(q_w, q_y), Mul(q_x, q_z))), Mul(g_y, Add(Mul(q_y, q_z), Neg(Mul(q_w, q_x)))), Mul(g_z, Add(Pow(q_w; 2), Neg(Pow(q_x; 2)), Neg(Pow(q_y; 2)), Pow(q_z; 2)))))); =)",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "\\bm{F}_{\\text{ext}} - \\int_{\\text{Body}}\\left(\\ddot{\\bm{r}}_{B/N} + \\dot{\\bm{\\omega}}_{\\mathcal{B}/\\mathcal{N}}\\times\\bm{r}_{M/B} + \\bm{\\omega}_{\\mathcal{B}/\\mathcal{N}} \\times\\left(\\bm{\\omega}_{\\mathcal{B}/\\mathcal{N}} \\times\\bm{r}_{M/B}\\right)\\right)\\text{d}m = \\int_{\\mathcal{V}_{\\text{sc}}} \\text{d}\\bm{F}_{\\text{vol}}+\\\\ +\\int_{\\mathcal{A}_{\\text{sc}}} \\text{d}\\bm{F}_{\\text{surf}} - \\int_{\\mathcal{V}_{\\text{sc}}}\\rho\\,\\left(\\ddot{\\bm{r}}_{B/N} + \\dot{\\bm{\\omega}}_{\\mathcal{B}/\\mathcal{N}}\\times\\bm{r}_{M/B} + \\bm{\\omega}_{\\mathcal{B}/\\mathcal{N}} \\times\\left(\\bm{\\omega}_{\\mathcal{B}/\\mathcal{N}} \\times\\bm{r}_{M/B}\\right)\\right)\\text{d}\\mathcal{V}",
        "Chain(Add(\\bm{F}_{ext}, Neg(Over(\\int; _ { \\text { B o d y } }; Add(Call(\\ddot{\\bm{r}}_{B/N}), Cross(Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }); \\bm{r}_{M/B}), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); \\bm{r}_{M/B}))); m))), Add(Over(\\int; _ { \\mathcal { V } _ { \\text { s c } } }; 1; \\bm{F}_{vol}), Over(\\int; _ { \\mathcal { A } _ { \\text { s c } } }; 1; \\bm{F}_{surf}), Neg(Over(\\int; _ { \\mathcal { V } _ { \\text { s c } } }; Mul(\\rho, Add(Call(\\ddot{\\bm{r}}_{B/N}), Cross(Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }); \\bm{r}_{M/B}), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); \\bm{r}_{M/B})))); \\mathcal{V}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "r_i = \\bm n_i \\cdot \\bm d - \\bm n_i \\cdot \\hat{\\bm d}",
        "Chain(r_i, Add(Mul(\\bm{n}_i, \\bm{d}; 1), Neg(Mul(\\bm{n}_i, \\hat{\\bm{d}}; 1))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attDetermination/CSSEst/_Documentation/Basilisk-cssWlsEst-20180429.tex",
    ),
    (
        "\\left[\\mathbf{Q}\\right] = \\begin{bmatrix}Q_{11} & Q_{12} & Q_{13}\\\\Q_{21} & Q_{22} & Q_{23}\\\\Q_{31} & Q_{32} & Q_{33}\\end{bmatrix}",
        "Chain([ \\mathbf { Q } ], MatrixOf(Q_{11}, Q_{12}, Q_{13}, Q_{21}, Q_{22}, Q_{23}, Q_{31}, Q_{32}, Q_{33}); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "\\text{Jet pump efficiency} = \\eta = M\\cdot N = \\frac{Q_s(P_5-P_2)}{Q_p(P_1 - P_5)}",
        "Chain(\\text{Jet~pump~efficiency}, \\eta, Mul(M, N), Div(Mul(Q_s, Add(P_5, Neg(P_2))); Mul(Q_p, Add(P_1, Neg(P_5)))); =, =, =)",
        "CalebBell/fluids/fluids/jet_pump.py",
    ),
    (
        "\\frac{\\partial R}{\\partial t} = -\\frac{\\partial L}{\\partial t}",
        "Chain(Derivative(Call(R); t, 1; True), Neg(Derivative(Call(L); t, 1; True)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "\\tilde{F}^*_r = F_r^* + \\left[ F^*_{p+1} \\ldots F^*_n \\right] \\mathbf{A}_n \\hat{e}_r \\textrm{ for } r=1\\ldots p",
        "System(Chain(\\tilde { F } _ { r } ^ { * }, Add(F _ { r } ^ { * }, Mul(Tuple(F _ { p + 1 } ^ { * }, Dots(), F _ { n } ^ { * }; []), \\mathbf{A}_n, \\hat{e}_r)); =), Values(r; 1, Dots(), p))",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "\\rho(t) = \\dot{\\rho}(t_{b1}) (t - t_{b1}) + \\rho(t_{b1})",
        "Chain(Call(\\rho; t), Add(Mul(Call(\\dot{\\rho}; t_{b1}), Add(t, Neg(t_{b1}))), Call(\\rho; t_{b1})); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedLinearTranslation/prescribedLinearTranslation.rst",
    ),
    (
        "B = \\frac{55}{G_{tp}^{0.5}} \\text{ for } G_{tp} > 1900",
        "Implies(Chain(G_{tp}, 1900; >); Chain(B, Div(55; Pow(G_{tp}; 0.5)); =))",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "k(\\tau) = A\\,\\exp\\left(-\\frac{\\tau^2}{2\\,\\ell^2} - \\Gamma\\,\\sin^2\\left(\\frac{\\pi\\,\\tau}{P_\\mathrm{rot}} \\right) \\right)",
        "Chain(Call(k; \\tau), Mul(A, Call(exp; Add(Neg(Div(Pow(\\tau; 2); Mul(2, Pow(\\ell; 2)))), Neg(Mul(\\varGamma, Pow(Call(sin; Div(Mul(\\pi, \\tau); P_{rot})); 2)))))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\text{Oblateness} = \\frac{\\text{Equatorial radius} - \\text{Polar radius}}{\\text{Equatorial radius}}",
        "Chain(\\text{Oblateness}, Div(Add(\\text{Equatorial~radius}, Neg(\\text{Polar~radius})); \\text{Equatorial~radius}); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/7-effects-of-the-earths-oblateness.md",
    ),
    (
        "M_e = \\frac{2\\pi}{T}t",
        "Chain(M_e, Mul(Div(Mul(2, \\pi); T), t); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "{\\bf \\lambda} = - \\left( \\frac{\\partial {\\bf h}_v}{\\partial {\\bf v}} {\\bf M}^{-1} \\frac{\\partial {\\bf h}_v}{\\partial {\\bf v}} \\right)^+ \\left[ \\frac{\\partial {\\bf h}_v}{\\partial {\\bf v}} {\\bf M}^{-1} {\\bf \\tau} + \\frac{\\partial {\\bf h}_v}{\\partial {\\bf q}} {\\bf N}({\\bf q}) {\\bf v} + \\alpha {\\bf h}_v \\right].",
        "Chain(\\mathbf{\\lambda}, Neg(Mul(Marked(Mul(Derivative(Call(\\mathbf{h}_v); \\mathbf{v}, 1; True), Pow(\\mathbf{M}; Neg(1)), Derivative(Call(\\mathbf{h}_v); \\mathbf{v}, 1; True)); ^+), Add(Mul(Derivative(Call(\\mathbf{h}_v); \\mathbf{v}, 1; True), Pow(\\mathbf{M}; Neg(1)), \\mathbf{\\tau}), Mul(Derivative(Call(\\mathbf{h}_v); \\mathbf{q}, 1; True), Call(\\mathbf{N}; \\mathbf{q}), \\mathbf{v}), Mul(\\alpha, Call(\\mathbf{h}_v))))); =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "x(0) &= \\beta\\bigl(z(0), \\dot z(0), \\dots, z^{(q)}(0) \\bigr) = x_0, \\\\ x(T) &= \\gamma\\bigl(z(T), \\dot z(T), \\dots, z^{(q)}(T) \\bigr) = x_f,",
        "System(Chain(Call(x; 0), Call(\\beta; Call(z; 0), Call(\\dot{z}; 0), Dots(), Call(z ^ { ( q ) }; 0)), x_0; =, =), Chain(Call(x; T), Call(\\gamma; Call(z; T), Call(\\dot{z}; T), Dots(), Call(z ^ { ( q ) }; T)), x_f; =, =))",
        "python-control/python-control/doc/flatsys.rst",
    ),
    (
        "\\begin{aligned} v_{t,p} &= \\sqrt{\\mu\\left(\\frac{2}{r_{t,p}} - \\frac{1}{a_t}\\right)} & v_{t,a} &= \\sqrt{\\mu\\left(\\frac{2}{r_{t,a}} - \\frac{1}{a_t}\\right)} \\end{aligned}",
        "System(Chain(v_{t,p}, Sqrt(Mul(\\mu, Add(Div(2; r_{t,p}), Neg(Div(1; a_t))))); =), Chain(v_{t,a}, Sqrt(Mul(\\mu, Add(Div(2; r_{t,a}), Neg(Div(1; a_t))))); =))",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/hohmann-transfer.md",
    ),
    (
        "X^G = f_{kin}^G(q).",
        "Chain(X ^ { G }, Call(f _ { k i n } ^ { G }; q); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\alpha = \\frac{1}{a}",
        "Chain(\\alpha, Div(1; a); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables-example.md",
    ),
    (
        "J_{s_{i}} \\dot\\Omega_{i} + K\\Delta\\Omega_{i} = 0",
        "Chain(Add(Mul(J_{s_i}, Call(\\dot{\\Omega}_i)), Mul(K, \\Delta \\Omega _ { i })), 0; =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/rwNullSpace/_Documentation/secModuleDescription.tex",
    ),
    (
        "[\\boldsymbol{K}_n] = [\\boldsymbol{P}_n] [\\boldsymbol{C}_n]^T \\left( [\\boldsymbol{C}_n] [\\boldsymbol{P}_n] [\\boldsymbol{C}_n]^T + [\\boldsymbol{R}] \\right)^{-1} \\\\ \\boldsymbol{x}_{n+1} = \\boldsymbol{x}_n + [\\boldsymbol{K}_n] \\left( \\boldsymbol{y}_n - [\\boldsymbol{C}_n] \\boldsymbol{x}_n \\right) \\\\ \\left[\\boldsymbol{P}_{n+1}\\right] = \\left( [\\boldsymbol{I}] - [\\boldsymbol{K}_n] [\\boldsymbol{C}_n] \\right) [\\boldsymbol{P}_n]",
        "System(Chain([ \\boldsymbol { K } _ { n } ], Mul([ \\boldsymbol { P } _ { n } ], Transpose([ \\boldsymbol { C } _ { n } ]), Pow(Add(Mul([ \\boldsymbol { C } _ { n } ], [ \\boldsymbol { P } _ { n } ], Transpose([ \\boldsymbol { C } _ { n } ])), [ \\boldsymbol { R } ]); Neg(1))); =), Chain(\\boldsymbol{x}_{n+1}, Add(\\boldsymbol{x}_n, Mul([ \\boldsymbol { K } _ { n } ], Add(\\boldsymbol{y}_n, Neg(Mul([ \\boldsymbol { C } _ { n } ], \\boldsymbol{x}_n))))); =), Chain([ \\boldsymbol { P } _ { n + 1 } ], Mul(Add([ \\boldsymbol { I } ], Neg(Mul([ \\boldsymbol { K } _ { n } ], [ \\boldsymbol { C } _ { n } ]))), [ \\boldsymbol { P } _ { n } ]); =))",
        "AVSLab/basilisk/src/fswAlgorithms/stateEstimation/thrustCMEstimation/thrustCMEstimation.rst",
    ),
    (
        "\\begin{split} b_n & = \\frac{1}{\\pi} \\int_{-\\pi}^\\pi t \\sin (nt) \\,dt \\\\ & = \\frac{2}{\\pi} \\int_{0}^\\pi t \\sin (nt) \\,dt \\\\ & = \\frac{2}{\\pi} \\left( \\left[ \\frac{-t \\cos (nt)}{n} \\right]_{t=0}^{\\pi} + \\frac{1}{n} \\int_{0}^\\pi \\cos (nt) \\,dt \\right) \\\\ & = \\frac{2}{\\pi} \\left( \\frac{-\\pi \\cos (n\\pi)}{n} + 0 \\right) \\\\ & = \\frac{-2 \\cos (n\\pi)}{n} = \\frac{2 \\,{(-1)}^{n+1}}{n} . \\end{split}",
        "Chain(b_n, Mul(Div(1; \\pi), Integral(Mul(t, Call(sin; Mul(n, t))); t; Neg(\\pi); \\pi)), Mul(Div(2; \\pi), Integral(Mul(t, Call(sin; Mul(n, t))); t; 0; \\pi)), Mul(Div(2; \\pi), Add(Evaluated(Div(Neg(Mul(t, Call(cos; Mul(n, t)))); n); t; 0; \\pi), Mul(Div(1; n), Integral(Call(cos; Mul(n, t)); t; 0; \\pi)))), Mul(Div(2; \\pi), Add(Div(Neg(Mul(\\pi, Call(cos; Mul(n, \\pi)))); n), 0)), Div(Neg(Mul(2, Call(cos; Mul(n, \\pi)))); n), Div(Mul(2, Pow(Neg(1); Add(n, 1))); n); =, =, =, =, =, =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "t = 2a_2",
        "Chain(t, Mul(2, a_2); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "s = \\int_{-\\theta}^0 p \\frac{\\sqrt{1-2e\\cos\\xi+e^2}}{(1-e\\cos\\xi)^2} \\mathrm{d} \\xi = -\\int_0^{-\\theta} p \\frac{\\sqrt{1-2e\\cos\\xi+e^2}}{(1-e\\cos\\xi)^2} \\mathrm{d} \\xi",
        "Chain(s, Integral(Mul(p, Div(Sqrt(Add(1, Neg(Mul(2, e, Call(cos; \\xi))), Pow(e; 2))); Pow(Add(1, Neg(Mul(e, Call(cos; \\xi)))); 2))); \\xi; Neg(\\theta); 0), Neg(Integral(Mul(p, Div(Sqrt(Add(1, Neg(Mul(2, e, Call(cos; \\xi))), Pow(e; 2))); Pow(Add(1, Neg(Mul(e, Call(cos; \\xi)))); 2))); \\xi; 0; Neg(\\theta))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise2.tex",
    ),
    (
        "\\mathbf{m}_n(\\mathbf{q}, t) \\dot{\\mathbf{q}} + \\mathbf{f}_n(\\mathbf{q}, t) = \\mathbf{0}",
        "Chain(Add(Mul(Call(\\mathbf{m}_n; Call(\\mathbf{q}), t), Call(\\dot{\\mathbf{q}})), Call(\\mathbf{f}_n; Call(\\mathbf{q}), t)), 0; =)",
        "sympy/sympy/doc/src/explanation/modules/physics/mechanics/lagrange.rst",
    ),
    (
        "\\boldsymbol{v} = \\boldsymbol{v}_O + \\boldsymbol{E} \\dot{\\boldsymbol{U}} \\boldsymbol{x} = \\boldsymbol{v}_O + \\boldsymbol{e} \\boldsymbol{U}^{\\mathrm{T}} \\dot{\\boldsymbol{U}} \\boldsymbol{x}",
        "Chain(\\boldsymbol{v}, Add(\\boldsymbol{v}_O, Mul(\\boldsymbol{E}, Call(\\dot{\\boldsymbol{U}}), \\boldsymbol{x})), Add(\\boldsymbol{v}_O, Mul(\\boldsymbol{e}, Transpose(Call(\\boldsymbol{U})), Call(\\dot{\\boldsymbol{U}}), \\boldsymbol{x})); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "\\boldsymbol{I} = (\\boldsymbol{I}+\\boldsymbol{u}^{\\mathrm{T}})(\\boldsymbol{I}+\\boldsymbol{u}) = \\boldsymbol{I} + \\boldsymbol{u}^{\\mathrm{T}} + \\boldsymbol{u} + \\boldsymbol{u}^{\\mathrm{T}} \\boldsymbol{u}",
        "Chain(\\boldsymbol{I}, Mul(Add(\\boldsymbol{I}, Transpose(\\boldsymbol{u})), Add(\\boldsymbol{I}, \\boldsymbol{u})), Add(\\boldsymbol{I}, Transpose(\\boldsymbol{u}), \\boldsymbol{u}, Mul(Transpose(\\boldsymbol{u}), \\boldsymbol{u})); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "L & = \\frac12 (\\dot{q}_1^2 + \\dot{q}_2^2 + \\dot{q}_3^2) - q_1q_2 + q_2q_3 - 2q_1^2 - \\frac52 q_2^2 - 2q_3^2 \\\\ & = \\frac12 \\dot{\\boldsymbol{q}}^{\\mathrm{T}} \\boldsymbol{M} \\dot{\\boldsymbol{q}} - \\frac12 \\boldsymbol{q}^{\\mathrm{T}} \\boldsymbol{K} \\boldsymbol{q}",
        "Chain(L, Add(Mul(Div(1; 2), Add(Pow(Call(\\dot{q}_1); 2), Pow(Call(\\dot{q}_2); 2), Pow(Call(\\dot{q}_3); 2))), Neg(Mul(Call(q_1), Call(q_2))), Mul(Call(q_2), Call(q_3)), Neg(Mul(2, Pow(Call(q_1); 2))), Neg(Mul(Div(5; 2), Pow(Call(q_2); 2))), Neg(Mul(2, Pow(Call(q_3); 2)))), Add(Mul(Div(1; 2), Transpose(Call(\\dot{\\boldsymbol{q}})), \\boldsymbol{M}, Call(\\dot{\\boldsymbol{q}})), Neg(Mul(Div(1; 2), Transpose(Call(\\boldsymbol{q})), \\boldsymbol{K}, Call(\\boldsymbol{q})))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "\\nu = \\left(\\tfrac{1}{2} + \\tfrac{1}{2}\\sqrt{1-4\\sigma^2}\\right)^{-1/2} \\le 1 + 2 \\sigma^2",
        "Chain(\\nu, Pow(Add(Div(1; 2), Mul(Div(1; 2), Sqrt(Add(1, Neg(Mul(4, Pow(\\sigma; 2))))))); Neg(Div(1; 2))), Add(1, Mul(2, Pow(\\sigma; 2))); =, \\le)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "\\bar{\\mathbf{y}} \\leftarrow \\frac{\\bar{\\mathbf{y}}}{\\|\\bar{\\mathbf{y}}\\|}",
        "Chain(\\bar{\\mathbf{y}}, Div(\\bar{\\mathbf{y}}; Norm(\\bar{\\mathbf{y}})); \\leftarrow)",
        "Mayitzin/ahrs/ahrs/filters/ukf.py",
    ),
    (
        "\\dot{\\bm{H}}_{\\text{sc, }B} = \\left[I_{\\text{hub},\\,Bc}\\right]\\dot{\\bm{\\omega}}_{\\cal{B}/\\cal{N}} + \\bm{\\omega}_{\\cal{B}/\\cal{N}} \\times \\left(\\left[I_{\\text{hub},\\,Bc}\\right]\\bm{\\omega}_{\\cal{B}/\\cal{N}}\\right)+ \\bm{r}_{Bc/B} \\times m_\\text{hub}\\,\\ddot{\\bm{r}}_{Bc/B} +\\\\ + \\sum_{i=1}^{M}\\left(\\left[I_{\\text{fuel}_i,\\,Fc_i}\\right] \\dot{\\bm{\\omega}}_{\\cal{B}/\\cal{N}} + \\bm{\\omega}_{\\cal{B}/\\cal{N}} \\times \\left(\\left[I_{\\text{fuel}_i,\\,Fc_i}\\right]\\, \\bm{\\omega}_{\\cal{B}/\\cal{N}}\\right) + \\bm{r}_{Fc_i/B} \\times m_{\\text{fuel}_i}\\, \\ddot{\\bm{r}}_{Fc_i/B}+\\right.\\\\ \\left.+ \\bm{r}_{Fc_i/B} \\times \\dot{m}_{\\text{fuel}_i} \\,\\dot{\\bm{r}}_{Fc_i/B} + \\left[I_{\\text{fuel}_i,\\, Fc_i}\\right]' \\, \\bm{\\omega}_{\\cal{B}/\\cal{N}}\\right)",
        "Chain(Call(\\dot{\\bm{H}}_{sc,B}), Add(Mul([ I _ { \\text { h u b } , \\, B c } ], Call(\\dot { \\bm { \\omega } } _ { \\cal B / \\cal N })), Cross(Call(\\bm{\\omega}_{\\cal B/\\cal N}); Mul([ I _ { \\text { h u b } , \\, B c } ], Call(\\bm{\\omega}_{\\cal B/\\cal N}))), Cross(Call(\\bm{r}_{Bc/B}); Mul(m_{hub}, Call(\\ddot{\\bm{r}}_{Bc/B}))), BigSum(i; 1; M; Add(Mul([ I _ { \\text { f u e l } _ { i } , \\, F c _ { i } } ], Call(\\dot { \\bm { \\omega } } _ { \\cal B / \\cal N })), Cross(Call(\\bm{\\omega}_{\\cal B/\\cal N}); Mul([ I _ { \\text { f u e l } _ { i } , \\, F c _ { i } } ], Call(\\bm{\\omega}_{\\cal B/\\cal N}))), Cross(Call(\\bm{r}_{Fc_i/B}); Mul(Call(m_{fuel_i}), Call(\\ddot{\\bm{r}}_{Fc_i/B}))), Cross(Call(\\bm{r}_{Fc_i/B}); Mul(Call(\\dot{m}_{fuel_i}), Call(\\dot{\\bm{r}}_{Fc_i/B}))), Mul([ I _ { \\text { f u e l } _ { i } , \\, F c _ { i } } ]', Call(\\bm{\\omega}_{\\cal B/\\cal N}))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "K(m) = F\\left(\\tfrac{\\pi}{2}\\middle| m\\right)",
        "Chain(Call(K; m), Call(F; Given(Div(\\pi; 2); m; |)); =)",
        "sympy/sympy/sympy/functions/special/elliptic_integrals.py",
    ),
    (
        "\\frac{\\pi}{2} + \\sum_{\\substack{n=1\\\\n \\text{ odd}}}^\\infty \\frac{2}{n} \\sin (n t) = \\frac{\\pi}{2} + \\sum_{k=1}^\\infty \\frac{2}{2k-1} \\sin \\bigl( (2k-1)\\, t \\bigr) .",
        "Chain(Add(Div(\\pi; 2), Limiting(sum; _{ \\substack { n = 1 \\\\ n \\text { o d d } } }^{ \\infty }; Mul(Div(2; n), Call(sin; Mul(n, t))))), Add(Div(\\pi; 2), BigSum(k; 1; Infinity(); Mul(Div(2; Add(Mul(2, k), Neg(1))), Call(sin; Mul(Add(Mul(2, k), Neg(1)), t))))); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\begin{bmatrix} 0 & 1 \\\\ 0 & 0 \\end{bmatrix} \\begin{bmatrix} 0 & 1 \\\\ 0 & 0 \\end{bmatrix} = \\begin{bmatrix} 0 & 0 \\\\ 0 & 0 \\end{bmatrix} = \\begin{bmatrix} 0 & 1 \\\\ 0 & 0 \\end{bmatrix} \\begin{bmatrix} 0 & 2 \\\\ 0 & 0 \\end{bmatrix} .",
        "Chain(Mul(MatrixOf(0, 1, 0, 0), MatrixOf(0, 1, 0, 0)), MatrixOf(0, 0, 0, 0), Mul(MatrixOf(0, 1, 0, 0), MatrixOf(0, 2, 0, 0)); =, =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "\\textbf{z}_{t} = g(\\textbf{x}_t) = H \\textbf{x}_t",
        "Chain(\\mathbf{z}_t, Call(g; \\mathbf{x}_t), Mul(H, \\mathbf{x}_t); =, =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/extended_kalman_filter_localization_files/extended_kalman_filter_localization_main.rst",
    ),
    (
        "\\overline{h} = \\frac{1}{N}\\sum_{i=1}^{N}I_{w_{s_{i}}}\\Omega_{i_{0}}",
        "Chain(\\overline{h}, Mul(Div(1; N), BigSum(i; 1; N; Mul(I_{w_s_i}, \\Omega_{i_0}))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/vscmgVelocitySteering/vscmgVelocitySteering.rst",
    ),
    (
        "\\dot{\\phi} = \\omega",
        "Chain(Call(\\dot{\\phi}), \\omega; =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/ensamble_kalman_filter_localization_files/ensamble_kalman_filter_localization_main.rst",
    ),
    (
        "a_{i1,1} &= I_{s_{i1,2}} + m_{\\text{sp}_{i1}} d^2_{i1} + m_{sp_{i2}} l^2_{i1}+ m_{sp_{i2}} l_{i1} d_{i2}\\hat{\\bm s}^T_{i1,3} \\bm{\\hat{s}}_{i2,3} \\\\ a_{i1,2} &= m_{sp_{i2}} l_{i1} d_{i2} \\hat{\\bm s}^T_{i1,3} \\bm{\\hat{s}}_{i2,3}\\\\ a_{i2,1} &= I_{s_{i2,2}} + m_{\\text{sp}_{i2}} d^2_{i2} + m_{\\text{sp}_{i2}} l_{i1} d_{i2}\\hat{\\bm s}^T_{i2,3} \\bm{\\hat{s}}_{i1,3} \\\\ a_{i2,2} &= I_{s_{i2,2}} + m_{\\text{sp}_{i2}} d^2_{i2}",
        "System(Chain(a_{i1,1}, Add(I_{s_i1,2}, Mul(m_{sp_i1}, Pow(d_{i1}; 2)), Mul(m_{sp_i2}, Pow(l_{i1}; 2)), Mul(m_{sp_i2}, l_{i1}, d_{i2}, Transpose(\\hat{\\bm{s}}_{i1,3}), \\bm{\\hat{s}}_{i2,3})); =), Chain(a_{i1,2}, Mul(m_{sp_i2}, l_{i1}, d_{i2}, Transpose(\\hat{\\bm{s}}_{i1,3}), \\bm{\\hat{s}}_{i2,3}); =), Chain(a_{i2,1}, Add(I_{s_i2,2}, Mul(m_{sp_i2}, Pow(d_{i2}; 2)), Mul(m_{sp_i2}, l_{i1}, d_{i2}, Transpose(\\hat{\\bm{s}}_{i2,3}), \\bm{\\hat{s}}_{i1,3})); =), Chain(a_{i2,2}, Add(I_{s_i2,2}, Mul(m_{sp_i2}, Pow(d_{i2}; 2))); =))",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\dot{x}_1 =& x_2 -\\alpha x_1 \\left( 1 - \\frac{1}{\\sqrt{x_1^2+x_2^2}}\\right) \\\\ \\dot{x}_2 =& -x_1 -\\alpha x_2 \\left( 1 - \\frac{1}{\\sqrt{x_1^2+x_2^2}}\\right),",
        "System(Chain(Call(\\dot{x}_1), Add(Call(x_2), Neg(Mul(\\alpha, Call(x_1), Add(1, Neg(Div(1; Sqrt(Add(Pow(Call(x_1); 2), Pow(Call(x_2); 2))))))))); =), Chain(Call(\\dot{x}_2), Add(Neg(Call(x_1)), Neg(Mul(\\alpha, Call(x_2), Add(1, Neg(Div(1; Sqrt(Add(Pow(Call(x_1); 2), Pow(Call(x_2); 2))))))))); =))",
        "RussTedrake/underactuated/book/limit_cycles.html",
    ),
    (
        "\\sum_{\\alpha=1}^s \\dot{q}_\\alpha \\frac{\\partial D}{\\partial \\dot{q}_\\alpha} = 2D",
        "Chain(BigSum(\\alpha; 1; s; Mul(Call(\\dot{q}_{\\alpha}), Derivative(Call(D); \\dot{q}_{\\alpha}, 1; True))), Mul(2, Call(D)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter5.tex",
    ),
    (
        "R_F(x,y,z) = \\frac{1}{2} \\int_0^{\\infty} \\frac{dt}{\\sqrt{(t+x)(t+y)(t+z)}}",
        "Chain(Call(R_F; x, y, z), Mul(Div(1; 2), Integral(Div(1; Sqrt(Mul(Add(t, x), Add(t, y), Add(t, z)))); t; 0; Infinity())); =)",
        "fredrik-johansson/arb/doc/source/acb_elliptic.rst",
    ),
    (
        "\\frac{T^2}{a^3} = \\frac{4 \\pi^2}{GM}",
        "Chain(Div(Pow(T; 2); Pow(a; 3)), Div(Mul(4, Pow(\\pi; 2)); Mul(G, M)); =)",
        "sympy/sympy/doc/src/modules/physics/units/examples.rst",
    ),
    (
        "K_m = \\frac{4f_d L}{D}",
        "Chain(K_m, Div(Mul(4, f_d, L); D); =)",
        "CalebBell/fluids/fluids/jet_pump.py",
    ),
    (
        "\\dot{x}_1 = x_2",
        "Chain(Call(\\dot{x}_1), x_2; =)",
        "sympy/sympy/doc/src/tutorials/physics/control/mechanics_problems.rst",
    ),
    (
        "\\tan \\omega = \\frac{(\\hat{\\bm \\imath}_{e} \\times \\hat{\\bm \\imath}_{r}) \\cdot \\hat{\\bm \\imath}_{h}} {\\hat{\\bm \\imath}_{e} \\cdot \\hat{\\bm \\imath}_{r}}",
        "Chain(Call(tan; \\omega), Div(Mul(Cross(\\hat{\\bm{\\imath}}_e; \\hat{\\bm{\\imath}}_r), \\hat{\\bm{\\imath}}_h; 1); Mul(\\hat{\\bm{\\imath}}_e, \\hat{\\bm{\\imath}}_r; 1)); =)",
        "AVSLab/basilisk/src/architecture/utilitiesSelfCheck/_Documentation/secModelDescription.tex",
    ),
    (
        "\\boldsymbol{q} = \\boldsymbol{A} \\boldsymbol{\\xi}",
        "Chain(\\boldsymbol{q}, Mul(\\boldsymbol{A}, \\boldsymbol{\\xi}); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter5.tex",
    ),
    (
        "\\begin{aligned} x^{*} &= \\frac{1}{2} - \\pi_2 \\\\ y^* &= \\pm \\frac{\\sqrt{3}}{2} \\end{aligned}",
        "System(Chain(x ^ { * }, Add(Div(1; 2), Neg(\\pi_2)); =), Chain(y ^ { * }, PlusMinus(Div(Sqrt(3); 2)); =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/lagrange-points.md",
    ),
    (
        "\\frac{8 K_{1} Q^{2} \\rho}{\\pi^{2} D_{1}^{4}} = \\frac{8 K_{2} Q^{2} \\rho}{\\pi^{2} D_{2}^{4}}",
        "Chain(Div(Mul(8, K_1, Pow(Q; 2), \\rho); Mul(Pow(\\pi; 2), Pow(D_1; 4))), Div(Mul(8, K_2, Pow(Q; 2), \\rho); Mul(Pow(\\pi; 2), Pow(D_2; 4))); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "\\boldsymbol{M} = \\begin{pmatrix} m & 0 \\\\ 0 & m \\end{pmatrix},\\quad \\boldsymbol{K} = \\begin{pmatrix} \\dfrac{mg}{l}+k & -k \\\\[1.5ex] -k & \\dfrac{mg}{l} + k \\end{pmatrix}",
        "System(Chain(\\boldsymbol{M}, MatrixOf(m, 0, 0, m); =), Chain(\\boldsymbol{K}, MatrixOf(Add(Div(Mul(m, g); l), k), Neg(k), Neg(k), Add(Div(Mul(m, g); l), k)); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter5.tex",
    ),
    (
        "{}^N\\bar{v}^S &= \\frac{{}^N d\\bar{r}^{S/O} }{dt} \\\\ &= \\frac{{}^N d\\left(\\bar{r}^{P/O} + \\bar{r}^{S/P}\\right)}{dt} \\\\ &= {}^N\\bar{v}^P + \\frac{{}^N d\\bar{r}^{S/P} }{dt} \\\\ &= {}^N\\bar{v}^P + {}^N\\bar{\\omega}^A \\times \\bar{r}^{S/P}",
        "Chain(\\prescript { N } { } { \\bar { v } } ^ { S }, Marked(Derivative(Call(\\bar { r } ^ { S / O }); t, 1); _{ N }), Marked(Derivative(Add(Call(\\bar { r } ^ { P / O }), Call(\\bar { r } ^ { S / P })); t, 1); _{ N }), Add(\\prescript { N } { } { \\bar { v } } ^ { P }, Marked(Derivative(Call(\\bar { r } ^ { S / P }); t, 1); _{ N })), Add(\\prescript { N } { } { \\bar { v } } ^ { P }, Cross(\\prescript { N } { } { \\bar { \\omega } } ^ { A }; Call(\\bar { r } ^ { S / P }))); =, =, =, =)",
        "moorepants/learn-multibody-dynamics/translational.rst",
    ),
    (
        "\\sum_{i=1}^\\nu m_i \\bar{r}^{P_i/S_o} = 0\\textrm{.}",
        "Chain(BigSum(i; 1; \\nu; Mul(m_i, \\bar { r } ^ { P _ { i } / S _ { o } })), 0; =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "\\frac{\\mathrm{d}}{\\mathrm{d} t} \\frac{\\partial L}{\\partial \\dot{q}_\\alpha} - \\frac{\\partial L}{\\partial q_\\alpha} = 0 \\quad (\\alpha = 1,2,\\cdots,s)",
        "System(Chain(Add(Derivative(Derivative(Call(L); \\dot{q}_{\\alpha}, 1; True); t, 1), Neg(Derivative(Call(L); q_{\\alpha}, 1; True))), 0; =), Values(\\alpha; 1, 2, Dots(), s))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\theta(t) = b (t - t_f)^2 + \\theta_{\\text{ref}}",
        "Chain(Call(\\theta; t), Add(Mul(b, Pow(Add(t, Neg(t_f)); 2)), \\theta_{ref}); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedRotation1DOF/prescribedRotation1DOF.rst",
    ),
    (
        "-\\left(\\Delta P \\right)_{grav} = L \\rho g \\sin \\theta",
        "Chain(Neg(Marked(\\Delta P; _{ g r a v })), Mul(L, \\rho, g, Call(sin; \\theta)); =)",
        "CalebBell/fluids/fluids/friction.py",
    ),
    (
        "v_D = v_D(0)-\\frac72kg",
        "Chain(Call(v_D), Add(Call(v_D; 0), Neg(Mul(Div(7; 2), k, g))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "u = k_\\text{f}\\, r - K x,",
        "Chain(u, Add(Mul(k_f, r), Neg(Mul(K, x))); =)",
        "python-control/python-control/doc/iosys.rst",
    ),
    (
        "W = \\left(\\frac{k}{k-1}\\right) P_1 V_1 \\left[\\left(\\frac{P_2}{P_1} \\right)^{(k-1)/k}-1\\right]",
        "Chain(W, Mul(Div(k; Add(k, Neg(1))), P_1, V_1, Add(Pow(Div(P_2; P_1); Div(Add(k, Neg(1)); k)), Neg(1))); =)",
        "CalebBell/fluids/fluids/compressible.py",
    ),
    (
        "[B_{\\text{contr}}] = \\sum_{i=1}^{N_{S}}\\bigg[\\Big(m_{\\text{sp}_{i1}}d_{i1} \\bm{\\hat{s}}_{i1,3} +m_{\\text{sp}_{i2}}l_{i1}\\bm{\\hat{s}}_{i1,3}+m_{\\text{sp}_{i2}} d_{i2}\\bm{\\hat{s}}_{i2,3}\\Big) e_{i1}^T[G_i] +m_{\\text{sp}_{i2}} d_{i2} \\bm{\\hat{s}}_{i2,3} e_{i2}^T[G_i]\\bigg]",
        "Chain([ B _ { \\text { c o n t r } } ], BigSum(i; 1; N_S; Add(Mul(Add(Mul(m_{sp_i1}, d_{i1}, \\bm{\\hat{s}}_{i1,3}), Mul(m_{sp_i2}, l_{i1}, \\bm{\\hat{s}}_{i1,3}), Mul(m_{sp_i2}, d_{i2}, \\bm{\\hat{s}}_{i2,3})), Transpose(e_{i1}), [ G _ { i } ]), Mul(m_{sp_i2}, d_{i2}, \\bm{\\hat{s}}_{i2,3}, Transpose(e_{i2}), [ G _ { i } ]))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\phi_i(t) = \\left( \\frac{t}{T} \\right)^i",
        "Chain(Call(\\phi_i; t), Pow(Div(t; T); i); =)",
        "python-control/python-control/control/flatsys/poly.py",
    ),
    (
        "Y^2 = \\frac{\\Delta P_{go}}{\\Delta P_{lo}}",
        "Chain(Pow(Y; 2), Div(\\Delta P _ { g o }; \\Delta P _ { l o }); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "m_{\\text{sc}} \\ddot{\\bm r}_{B/N}-m_{\\text{sc}} [\\tilde{\\bm{c}}] \\dot{\\bm\\omega}_{\\cal B/N} +\\sum_{j=1}^{N_{P}}m_j \\hat{\\bm p}_j \\ddot{\\rho}_j = \\bm F_{\\text{ext}} - 2 m_{\\text{sc}} [\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm c' - m_{\\text{sc}} [\\tilde{\\bm\\omega}_{\\cal B/N}][\\tilde{\\bm\\omega}_{\\cal B/N}]\\bm{c}",
        "Chain(Add(Mul(m_{sc}, Call(\\ddot{\\bm{r}}_{B/N})), Neg(Mul(m_{sc}, [ \\tilde { \\bm { c } } ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }))), BigSum(j; 1; N_P; Mul(m_j, \\hat{\\bm{p}}_j, Call(\\ddot{\\rho}_j)))), Add(\\bm{F}_{ext}, Neg(Mul(2, m_{sc}, [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{c}')), Neg(Mul(m_{sc}, [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{c}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/LinearSpringMassDamper/_Documentation/secModelDescription.tex",
    ),
    (
        "\\lambda_c = (q - p)|\\omega|^{1/(q - p)} \\cos{\\psi} + (v - u)|\\sigma|^{1/(v - u)} \\cos{\\theta}",
        "Chain(\\lambda_c, Add(Mul(Add(q, Neg(p)), Pow(Bars(\\omega); Div(1; Add(q, Neg(p)))), Call(cos; \\psi)), Mul(Add(v, Neg(u)), Pow(Bars(\\sigma); Div(1; Add(v, Neg(u)))), Call(cos; \\theta))); =)",
        "sympy/sympy/doc/src/modules/integrals/g-functions.rst",
    ),
    (
        "\\sum_{\\alpha=1}^r \\left(\\dfrac{\\mathrm{d}}{\\mathrm{d} t}\\frac{\\partial T}{\\partial \\dot{q}_\\alpha} - \\frac{\\partial T}{\\partial q_\\alpha} - Q_\\alpha\\right)\\delta q_\\alpha = 0",
        "Chain(BigSum(\\alpha; 1; r; Mul(Add(Derivative(Derivative(Call(T); \\dot{q}_{\\alpha}, 1; True); t, 1), Neg(Derivative(Call(T); q_{\\alpha}, 1; True)), Neg(Q_{\\alpha})), \\delta q _ { \\alpha })), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "n = \\frac{v1 \\times v2}{|v1 \\times v2|}",
        "Chain(n, Div(Cross(\\text{v1}; \\text{v2}); Bars(Cross(\\text{v1}; \\text{v2}))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/3_mapping/normal_vector_estimation/normal_vector_estimation_main.rst",
    ),
    (
        "\\operatorname{Si}(z) = \\frac{i}{2} \\left[ e^{iz} U(1,1,-iz) - e^{-iz} U(1,1,iz) + \\log(-iz) - \\log(iz) \\right]",
        "Chain(Call(\\text{Si}; z), Mul(Div(i; 2), Add(Mul(Pow(e; Mul(i, z)), Call(U; 1, 1, Neg(Mul(i, z)))), Neg(Mul(Pow(e; Neg(Mul(i, z))), Call(U; 1, 1, Mul(i, z)))), Call(log; Neg(Mul(i, z))), Neg(Call(log; Mul(i, z))))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "L = K - V",
        "Chain(L, Add(K, Neg(V)); =)",
        "moorepants/learn-multibody-dynamics/lagrange.rst",
    ),
    (
        "H = \\sum^{N}_{i=-N}w^{[i]}_{c}(\\pmb{\\chi}^{[i]} - \\hat{\\mathbf{x}}^{-}_{k+1})(\\pmb{\\xi}^{[i]} - \\hat{\\mathbf{y}}^{-}_{k+1})^T",
        "Chain(H, BigSum(i; Neg(N); N; Mul(w _ { c } ^ { [ i ] }, Add(\\pmb { \\chi } ^ { [ i ] }, Neg(\\hat { \\mathbf { x } } _ { k + 1 } ^ { - })), Transpose(Add(\\pmb { \\xi } ^ { [ i ] }, Neg(\\hat { \\mathbf { y } } _ { k + 1 } ^ { - }))))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/smallBodyNavigation/smallBodyNavUKF/smallBodyNavUKF.rst",
    ),
    (
        "T_0(x) = 1",
        "Chain(Call(T_0; x), 1; =)",
        "AVSLab/basilisk/src/fswAlgorithms/sensorInterfaces/CSSSensorData/_Documentation/secModuleDescription.tex",
    ),
    (
        "\\begin{array}{lcr} \\mathbf{r}_1 = \\begin{bmatrix}r_{11}\\\\ r_{21} \\\\ r_{31} \\end{bmatrix} \\; , & \\mathbf{r}_2 = \\begin{bmatrix}r_{12}\\\\ r_{22} \\\\ r_{32} \\end{bmatrix} \\; , & \\mathbf{r}_3 = \\begin{bmatrix}r_{13}\\\\ r_{23} \\\\ r_{33} \\end{bmatrix} \\end{array}",
        "System(Chain(\\mathbf{r}_1, MatrixOf(r_{11}, r_{21}, r_{31}); =), Chain(\\mathbf{r}_2, MatrixOf(r_{12}, r_{22}, r_{32}); =), Chain(\\mathbf{r}_3, MatrixOf(r_{13}, r_{23}, r_{33}); =))",
        "Mayitzin/ahrs/ahrs/common/dcm.py",
    ),
    (
        "C_{17}: \\int_0^\\infty G_{p, q}^{m, n}(\\omega x) \\mathrm{d} x \\text{ converges at infinity }",
        "System(Located(C_{17}; Integral(Call(G _ { p , q } ^ { m , n }; Mul(\\omega, x)); x; 0; Infinity())), Words(\\text{converges~at~infinity}))",
        "sympy/sympy/doc/src/modules/integrals/g-functions.rst",
    ),
    (
        "\\log G(z) = (z-1) \\log \\Gamma(z) - \\zeta'(-1,z) + \\zeta'(-1).",
        "Chain(Call(log; Call(G; z)), Add(Mul(Add(z, Neg(1)), Call(log; Call(Gamma; z))), Neg(Call(\\zeta'; Neg(1), z)), Call(\\zeta'; Neg(1))); =)",
        "fredrik-johansson/arb/doc/source/acb.rst",
    ),
    (
        "\\eta = g(x), \\xi = f(x)",
        "System(Chain(\\eta, Call(g; x); =), Chain(\\xi, Call(f; x); =))",
        "sympy/sympy/sympy/solvers/ode/lie_group.py",
    ),
    (
        "Az = \\arctan\\!\\frac{y}{x}",
        "Chain(\\text{Az}, Call(arctan; Div(y; x)); =)",
        "AVSLab/basilisk/src/simulation/environment/stripLocation/stripLocation.rst",
    ),
    (
        "y'' - 8 y' + 16 y = 8 e^{4x} + 16xe^{4x} - 8(e^{4x} + 4xe^{4x}) + 16 xe^{4x} = 0 .",
        "Chain(Add(y'', Neg(Mul(8, y')), Mul(16, y)), Add(Mul(8, Pow(e; Mul(4, x))), Mul(16, x, Pow(e; Mul(4, x))), Neg(Mul(8, Add(Pow(e; Mul(4, x)), Mul(4, x, Pow(e; Mul(4, x)))))), Mul(16, x, Pow(e; Mul(4, x)))), 0; =, =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "\\left|\\prod_{p < N} \\left(1 - \\frac{\\chi(p)}{p^s}\\right) - \\frac{1}{L(s,\\chi)}\\right| \\le \\sum_{k=N}^{\\infty} \\frac{1}{k^s} = \\zeta(s,N).",
        "Chain(Bars(Add(Limiting(prod; _{ p < N }; Add(1, Neg(Div(Call(\\chi; p); Pow(p; s))))), Neg(Div(1; Call(L; s, Call(\\chi)))))), BigSum(k; N; Infinity(); Div(1; Pow(k; s))), Call(\\zeta; s, N); \\le, =)",
        "fredrik-johansson/arb/doc/source/acb_dirichlet.rst",
    ),
    (
        "\\bar{v} = & \\sum_{r=1}^p \\tilde{v}_r u_r + \\tilde{v}_t \\\\ \\bar{\\omega} = & \\sum_{r=1}^p \\tilde{\\omega}_r u_r + \\tilde{\\omega}_t",
        "System(Chain(\\bar{v}, Add(BigSum(r; 1; p; Mul(\\tilde{v}_r, u_r)), \\tilde{v}_t); =), Chain(\\bar{\\omega}, Add(BigSum(r; 1; p; Mul(\\tilde{\\omega}_r, u_r)), \\tilde{\\omega}_t); =))",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "x_3 = \\dot{\\theta_2} \\quad \\text{(angular velocity of the second flywheel)}",
        "System(Chain(x_3, Call(\\dot{\\theta}_2); =), Words(\\text{(angular~velocity~of~the~second~flywheel)}))",
        "sympy/sympy/doc/src/tutorials/physics/control/mechanics_problems.rst",
    ),
    (
        "[W] = \\begin{bmatrix} [I]_{3\\times 3} & [0]_{3 \\times 2} \\\\ [0]_{2 \\times 3} & [\\mathcal{S}_2 \\mathcal{S}_1](2,3)\\end{bmatrix}",
        "Chain([ W ], MatrixOf([ I ] _ { 3 \\times 3 }, Marked(0; _{ 3 \\times 2 }), Marked(0; _{ 2 \\times 3 }), Call([ \\mathcal { S } _ { 2 } \\mathcal { S } _ { 1 } ]; 2, 3)); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attDetermination/headingSuKF/_Documentation/heading_SuKF.tex",
    ),
    (
        "P_5 = P_4 + \\frac{1}{2}\\rho_d V_4^2 - K_d\\left(\\frac{1}{2}\\rho_d V_4^2\\right)",
        "Chain(P_5, Add(P_4, Mul(Div(1; 2), \\rho_d, Pow(V_4; 2)), Neg(Mul(K_d, Mul(Div(1; 2), \\rho_d, Pow(V_4; 2))))); =)",
        "CalebBell/fluids/fluids/jet_pump.py",
    ),
    (
        "\\bm{\\ddot{d}}=\\bm{\\dot{\\omega}}_{B/N}\\times \\bm{d}+\\bm\\omega_{\\cal B/N}\\times(\\bm\\omega_{\\cal B/N}\\times \\bm{d})",
        "Chain(\\bm{\\ddot{d}}, Add(Cross(\\bm{\\dot{\\omega}}_{B/N}; \\bm{d}), Cross(\\bm{\\omega}_{\\mathcal B/\\mathcal N}; Cross(\\bm{\\omega}_{\\mathcal B/\\mathcal N}; \\bm{d}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/sphericalPendulum/_Documentation/secModelDescription.tex",
    ),
    (
        "{\\vphantom{\\hat{\\bm\\imath}}}^{\\mathcal{N}\\!}{\\hat{\\bm\\imath}}_{r}={\\vphantom{\\begin{pmatrix} \\cos\\Omega\\cos\\omega - \\sin\\Omega\\sin\\omega\\cos i \\\\ \\sin\\Omega\\cos\\omega + \\cos\\Omega\\sin\\omega\\cos i \\\\ \\sin\\theta\\sin i \\end{pmatrix}}}^{\\mathcal{N\\!\\!\\!}\\!}{\\begin{pmatrix} \\cos\\Omega\\cos\\omega - \\sin\\Omega\\sin\\omega\\cos i \\\\ \\sin\\Omega\\cos\\omega + \\cos\\Omega\\sin\\omega\\cos i \\\\ \\sin\\theta\\sin i \\end{pmatrix}}",
        "Chain(\\prescript { \\mathcal { N } \\! } { } { \\hat { \\bm { \\imath } } } _ { r }, Marked(MatrixOf(Add(Mul(Call(cos; \\Omega), Call(cos; \\omega)), Neg(Mul(Call(sin; \\Omega), Call(sin; \\omega), Call(cos; i)))), Add(Mul(Call(sin; \\Omega), Call(cos; \\omega)), Mul(Call(cos; \\Omega), Call(sin; \\omega), Call(cos; i))), Mul(Call(sin; \\theta), Call(sin; i))); _{ \\mathcal { N } }); =)",
        "AVSLab/basilisk/src/architecture/utilitiesSelfCheck/_Documentation/secModelDescription.tex",
    ),
    (
        "\\frac{\\mu^2}{h^3}t = \\frac{1}{2}\\tan\\frac{\\nu}{2} + \\frac{1}{6}\\tan^3\\frac{\\nu}{2}",
        "Chain(Mul(Div(Pow(\\mu; 2); Pow(h; 3)), t), Add(Mul(Div(1; 2), Call(tan; Div(\\nu; 2))), Mul(Div(1; 6), Pow(Call(tan; Div(\\nu; 2)); 3))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/parabolic-trajectories.md",
    ),
    (
        "c_{\\text{lift}} = 2\\sin\\alpha\\cos\\alpha, \\quad c_{\\text{drag}} = 2\\sin^2\\alpha.",
        "System(Chain(c_{lift}, Mul(2, Call(sin; \\alpha), Call(cos; \\alpha)); =), Chain(c_{drag}, Mul(2, Pow(Call(sin; \\alpha); 2)); =))",
        "RussTedrake/underactuated/book/trajopt.html",
    ),
    (
        "\\chi_{i=0} = \\sqrt{\\mu} \\left\\lvert\\alpha\\right\\rvert \\Delta t",
        "Chain(\\chi_{i=0}, Mul(Sqrt(\\mu), Bars(\\alpha), \\Delta t); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables-example.md",
    ),
    (
        "C_n = \\begin{cases} 1 & \\text{if } R = 1 \\\\ \\chi(n) & \\text{if } R = 2 \\\\ (\\chi(n) + \\sigma \\nu^2 n) \\nu^n & \\text{if } R = 3 \\end{cases}",
        "Chain(C_n, Piecewise(1, Chain(R, 1; =), Call(\\chi; n), Chain(R, 2; =), Mul(Add(Call(\\chi; n), Mul(\\sigma, Pow(\\nu; 2), n)), Pow(\\nu; n)), Chain(R, 3; =)); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "v_{\\infty} = \\sqrt{\\frac{\\mu}{a}}",
        "Chain(v_\\infty, Sqrt(Div(\\mu; a)); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/hyperbolic-trajectories.md",
    ),
    (
        "\\varepsilon_2(a,b,c,d) &= \\exp(\\pi i [-R(a,b,c,d) + (5+(2-c)a)] / 4)",
        "Chain(Call(\\varepsilon_2; a, b, c, d), Call(exp; Div(Mul(\\pi, i, Add(Neg(Call(R; a, b, c, d)), Add(5, Mul(Add(2, Neg(c)), a)))); 4)); =)",
        "fredrik-johansson/arb/doc/source/acb_modular.rst",
    ),
    (
        "\\operatorname{Ei}(x) = \\sum_{n=1}^\\infty \\frac{x^n}{n\\, n!} + \\log(x) + \\gamma,",
        "Chain(Call(\\text{Ei}; x), Add(BigSum(n; 1; Infinity(); Div(Pow(x; n); Mul(n, Factorial(n)))), Call(log; x), \\gamma); =)",
        "sympy/sympy/sympy/functions/special/error_functions.py",
    ),
    (
        "B := \\begin{bmatrix} \\alpha_{\\sigma(0)} & \\alpha_{\\sigma(1)} & \\cdots & \\alpha_{\\sigma(n-1)} \\end{bmatrix}",
        "Chain(B, MatrixOf(\\alpha_{\\sigma(0)}, \\alpha_{\\sigma(1)}, Dots(), \\alpha_{\\sigma(n-1)}); =)",
        "sympy/sympy/sympy/matrices/common.py",
    ),
    (
        "J_{\\bf \\alpha}({\\bf x}) =& \\int_0^\\infty \\ell({\\bf x}(t), {\\bf u}(t)) dt, \\\\ \\textrm{subject to} \\quad & \\dot{\\bf x} = f({\\bf x}, {\\bf u}), \\quad {\\bf u} = {\\bf \\pi}_{\\bf \\alpha}({\\bf x}), \\quad {\\bf x}(0) = {\\bf x}.",
        "System(Chain(Call(J_{\\mathbf\\alpha}; Call(\\mathbf{x})), Integral(Call(\\ell; Call(\\mathbf{x}; t), Call(\\mathbf{u}; t)); t; 0; Infinity()); =), Words(\\text{subject~to}), Chain(Call(\\dot{\\mathbf{x}}), Call(f; Call(\\mathbf{x}), Call(\\mathbf{u})); =), Chain(Call(\\mathbf{u}), Call(\\mathbf{\\pi}_{\\mathbf\\alpha}; Call(\\mathbf{x})); =), Chain(Call(\\mathbf{x}; 0), Call(\\mathbf{x}); =))",
        "RussTedrake/underactuated/book/policy_search.html",
    ),
    (
        "h = \\frac{p}{\\cos\\phi} - N",
        "Chain(h, Add(Div(p; Call(cos; \\phi)), Neg(N)); =)",
        "Mayitzin/ahrs/ahrs/common/frames.py",
    ),
    (
        "p_{\\text{RW}} = p_{\\text{base}} + \\frac{| p_{\\text{mech}} |}{\\eta_{e2m}}",
        "Chain(p_{RW}, Add(p_{base}, Div(Bars(p_{mech}); \\eta_{e2m})); =)",
        "AVSLab/basilisk/src/simulation/power/ReactionWheelPower/ReactionWheelPower.rst",
    ),
    (
        "\\lambda = - \\frac{\\mathrm{d}T}{\\mathrm{d}h}",
        "Chain(\\lambda, Neg(Derivative(Call(T); h, 1)); =)",
        "JSBSim-Team/jsbsim-reference-manual/docs/formulation/earth-modeling.md",
    ),
    (
        "J = \\int_{0}^{\\infty} [{\\bf x}^T(t) {\\bf Q} {\\bf x}(t) + R u^2(t)] dt,",
        "Chain(J, Integral(Add(Mul(Transpose(Call(\\mathbf{x}; t)), \\mathbf{Q}, Call(\\mathbf{x}; t)), Mul(R, Pow(Call(u; t); 2))); t; 0; Infinity()); =)",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "\\boldsymbol{p} = \\boldsymbol{p}(t)",
        "Chain(Call(\\boldsymbol{p}), Call(\\boldsymbol{p}; t); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\bm T^* = -[I_{\\text{hub},B}] \\dot{\\bm\\omega}_{\\cal B/N} -[\\bm{\\tilde{\\omega}}_{\\cal B/N}] [I_{\\text{hub},B}] \\bm\\omega_{\\cal B/N}",
        "Chain(\\bm { T } ^ { * }, Add(Neg(Mul([ I _ { \\text { h u b } , B } ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }))), Neg(Mul([ \\bm { \\tilde { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ I _ { \\text { h u b } , B } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/LinearSpringMassDamper/_Documentation/secModelDescription.tex",
    ),
    (
        "\\dot{\\phi} = \\frac{vtan(\\delta)}{L}",
        "Chain(Call(\\dot{\\phi}), Div(Mul(v, Call(tan; \\delta)); L); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/model_predictive_speed_and_steering_control/model_predictive_speed_and_steering_control_main.rst",
    ),
    (
        "\\operatorname{B}(s, a) = \\begin{cases} -s \\zeta(1-s, a) & s \\ne 0 \\\\ 1 & s = 0 \\end{cases}",
        "Chain(Call(\\text{B}; s, a), Piecewise(Neg(Mul(s, Call(\\zeta; Add(1, Neg(s)), a))), Chain(s, 0; \\ne), 1, Chain(s, 0; =)); =)",
        "sympy/sympy/sympy/functions/combinatorial/numbers.py",
    ),
    (
        "\\frac{{}^A\\partial \\bar{v}}{\\partial q_r} = \\frac{\\partial v_x}{\\partial q_r} \\hat{a}_x + \\frac{\\partial v_y}{\\partial q_r} \\hat{a}_y + \\frac{\\partial v_z}{\\partial q_r} \\hat{a}_z \\textrm{ for } r=1\\ldots n",
        "System(Chain(Marked(Derivative(Call(\\bar{v}); q_r, 1; True); _{ A }), Add(Mul(Derivative(Call(v_x); q_r, 1; True), \\hat{a}_x), Mul(Derivative(Call(v_y); q_r, 1; True), \\hat{a}_y), Mul(Derivative(Call(v_z); q_r, 1; True), \\hat{a}_z)); =), Values(r; 1, Dots(), n))",
        "moorepants/learn-multibody-dynamics/differentiation.rst",
    ),
    (
        "e_1 = \\frac{R_{\\text{Neptune}} - R_{\\text{Venus}}}{R_{\\text{Neptune}} + R_{\\text{Venus}}\\cos\\nu_1}",
        "Chain(e_1, Div(Add(R_{Neptune}, Neg(R_{Venus})); Add(R_{Neptune}, Mul(R_{Venus}, Call(cos; \\nu_1)))); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-arrival-flyby.md",
    ),
    (
        "\\omega_1 = \\omega_0 \\sqrt{1-\\frac{\\alpha}{\\omega_0^2}},\\quad \\omega_2 = \\omega_0 \\sqrt{1+\\frac{\\alpha}{\\omega_0^2}}",
        "System(Chain(\\omega_1, Mul(\\omega_0, Sqrt(Add(1, Neg(Div(\\alpha; Pow(\\omega_0; 2)))))); =), Chain(\\omega_2, Mul(\\omega_0, Sqrt(Add(1, Div(\\alpha; Pow(\\omega_0; 2))))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "{\\bf u}^* = {\\bf u}_0(t) - {\\bf K}(t) ({\\bf x} - {\\bf x}_0(t)).",
        "Chain(\\mathbf { u } ^ { * }, Add(Call(\\mathbf{u}_0; t), Neg(Mul(Call(\\mathbf{K}; t), Add(\\mathbf{x}, Neg(Call(\\mathbf{x}_0; t)))))); =)",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "y' = y^2, \\qquad y(0) = A .",
        "System(Chain(Call(y'), Pow(Call(y); 2); =), Chain(Call(y; 0), A; =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\left|\\frac{T(k+1)}{T(k)}\\right| = \\frac{|x|}{a} \\frac{(k+\\sigma-1)}{(k+\\sigma)} \\frac{(k+\\sigma+a)}{(k+\\sigma+a-1)} \\frac{|k+s|}{(k+1)} \\le \\frac{|x|}{a} \\left(1 + \\frac{1}{K+\\sigma+a-1}\\right) \\left(1 + \\frac{|s-1|}{K+1}\\right) = C",
        "Chain(Bars(Div(Call(T; Add(k, 1)); Call(T; k))), Mul(Div(Bars(x); a), Div(Add(k, \\sigma, Neg(1)); Add(k, \\sigma)), Div(Add(k, \\sigma, a); Add(k, \\sigma, a, Neg(1))), Div(Bars(Add(k, s)); Add(k, 1))), Mul(Div(Bars(x); a), Add(1, Div(1; Add(K, \\sigma, a, Neg(1)))), Add(1, Div(Bars(Add(s, Neg(1))); Add(K, 1)))), C; =, \\le, =)",
        "fredrik-johansson/arb/doc/source/hurwitz.rst",
    ),
    (
        "{\\bf f}(\\pmb\\sigma_{\\mathcal{B}/\\mathcal{R}}) = \\begin{cases} K_{1} \\sigma_{i} &\\text{if } |K_{1} \\sigma_{i}| \\le \\omega_{\\text{max}} \\\\ \\omega_{\\text{max}} \\text{sgn}(\\sigma_{i}) &\\text{if } |K_{1} \\sigma_{i}| > \\omega_{\\text{max}} \\end{cases}",
        "Chain(Call(\\mathbf{f}; \\pmb{\\sigma}_{\\mathcal B/\\mathcal R}), Piecewise(Mul(K_1, \\sigma_i), Chain(Bars(Mul(K_1, \\sigma_i)), \\omega_{max}; \\le), Mul(\\omega_{max}, Call(sgn; \\sigma_i)), Chain(Bars(Mul(K_1, \\sigma_i)), \\omega_{max}; >)); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attControl/mrpSteering/mrpSteering.rst",
    ),
    (
        "\\left|x\\right|^{a} \\left|y\\right|^{b} \\left|z\\right|^{c} = C_1",
        "Chain(Mul(Pow(Bars(x); a), Pow(Bars(y); b), Pow(Bars(z); c)), C_1; =)",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "{}_I\\mathbf r_{I\\!Q}(\\mathbf q) = {}_I\\mathbf r_{I\\!B}(\\mathbf q) + \\mathbf C_{I\\!B}(\\mathbf q) \\cdot {}_B\\mathbf r_{B\\!Q}(\\mathbf q),",
        "Chain(Call(\\prescript { } { I } { \\mathbf { r } } _ { I \\! Q }; \\mathbf{q}), Add(Call(\\prescript { } { I } { \\mathbf { r } } _ { I \\! B }; \\mathbf{q}), Mul(Call(\\mathbf{C}_{I\\!B}; \\mathbf{q}), Call(\\prescript { } { B } { \\mathbf { r } } _ { B \\! Q }; \\mathbf{q}); 1)); =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "f(x) := \\begin{cases} 0 & \\mathrm{for\\ } x < a, \\\\ \\frac{2(x-a)}{(b-a)(c-a)} & \\mathrm{for\\ } a \\le x < c, \\\\ \\frac{2}{b-a} & \\mathrm{for\\ } x = c, \\\\ \\frac{2(b-x)}{(b-a)(b-c)} & \\mathrm{for\\ } c < x \\le b, \\\\ 0 & \\mathrm{for\\ } b < x. \\end{cases}",
        "Chain(Call(f; x), Piecewise(0, Chain(x, a; <), Div(Mul(2, Add(x, Neg(a))); Mul(Add(b, Neg(a)), Add(c, Neg(a)))), Chain(a, x, c; \\le, <), Div(2; Add(b, Neg(a))), Chain(x, c; =), Div(Mul(2, Add(b, Neg(x))); Mul(Add(b, Neg(a)), Add(b, Neg(c)))), Chain(c, x, b; <, \\le), 0, Chain(b, x; <)); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "f(x) := \\frac{e^{- e^{\\frac{- \\mu + x}{\\beta}} + \\frac{- \\mu + x}{\\beta}}}{\\beta}",
        "Chain(Call(f; x), Div(Pow(e; Add(Neg(Pow(e; Div(Add(Neg(\\mu), x); \\beta))), Div(Add(Neg(\\mu), x); \\beta))); \\beta); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "\\boldsymbol{x} = \\big[ u, v, w,\\, p, q, r,\\, x_{\\text{cg}}, y_{\\text{cg}}, z_{\\text{cg}},\\, q_0, q_1, q_2, q_3,\\, \\text{masses},\\text{inertias}\\big]",
        "Chain(\\boldsymbol{x}, Tuple(u, v, w, p, q, r, x_{cg}, y_{cg}, z_{cg}, q_0, q_1, q_2, q_3, \\text{masses}, \\text{inertias}; []); =)",
        "JSBSim-Team/jsbsim-reference-manual/docs/formulation/state-propagation-contract.md",
    ),
    (
        "f(x) := \\frac{e^{\\kappa\\cos(x-\\mu)}}{2\\pi I_0(\\kappa)}",
        "Chain(Call(f; x), Div(Pow(e; Mul(\\kappa, Call(cos; Add(x, Neg(\\mu))))); Mul(2, \\pi, Call(I_0; \\kappa))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "\\bm k_{1} &= \\bm f\\left(t_{n}, \\bm x_{n}\\right) \\\\ \\bm k_{2} &= \\bm f\\left(t_{n} + \\frac{h}{2}, \\bm x_{n} + \\frac{h}{2} \\bm k_{1}\\right) \\\\ \\bm k_{3} &= \\bm f\\left(t_{n} + \\frac{h}{2}, \\bm x_{n} + \\frac{h}{2} \\bm k_{2}\\right) \\\\ \\bm k_{4} &= \\bm f\\left(t_{n} + h, \\bm x_{n} + h \\bm k_{3}\\right)",
        "System(Chain(\\bm{k}_1, Call(\\bm{f}; t_n, \\bm{x}_n); =), Chain(\\bm{k}_2, Call(\\bm{f}; Add(t_n, Div(h; 2)), Add(\\bm{x}_n, Mul(Div(h; 2), \\bm{k}_1))); =), Chain(\\bm{k}_3, Call(\\bm{f}; Add(t_n, Div(h; 2)), Add(\\bm{x}_n, Mul(Div(h; 2), \\bm{k}_2))); =), Chain(\\bm{k}_4, Call(\\bm{f}; Add(t_n, h), Add(\\bm{x}_n, Mul(h, \\bm{k}_3))); =))",
        "AVSLab/basilisk/src/simulation/dynamics/Integrators/_Documentation/secModelDescription.tex",
    ),
    (
        "\\boldsymbol{\\epsilon} = \\begin{bmatrix} \\sqrt{\\frac{1+c_{11}}{2}} \\\\ \\sqrt{\\frac{1+c_{22}}{2}} \\\\ \\sqrt{\\frac{1+c_{33}}{2}} \\end{bmatrix}",
        "Chain(\\boldsymbol{\\epsilon}, MatrixOf(Sqrt(Div(Add(1, c_{11}); 2)), Sqrt(Div(Add(1, c_{22}); 2)), Sqrt(Div(Add(1, c_{33}); 2))); =)",
        "Mayitzin/ahrs/ahrs/common/orientation.py",
    ),
    (
        "\\tan \\phi = \\frac{2Eb}{\\alpha}",
        "Chain(Call(tan; \\phi), Div(Mul(2, E, b); \\alpha); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "\\frac{(a_j\\,c_j+b_j\\,d_j)\\,({c_j}^2+{d_j}^2)+(a_j\\,c_j-b_j\\,d_j)\\,\\omega^2} {\\omega^4+2\\,({c_j}^2-{d_j}^2)\\,\\omega^2+{({c_j}^2+{d_j}^2)}^2} > 0 \\quad.",
        "Chain(Div(Add(Mul(Add(Mul(a_j, c_j), Mul(b_j, d_j)), Add(Pow(c_j; 2), Pow(d_j; 2))), Mul(Add(Mul(a_j, c_j), Neg(Mul(b_j, d_j))), Pow(\\omega; 2))); Add(Pow(\\omega; 4), Mul(2, Add(Pow(c_j; 2), Neg(Pow(d_j; 2))), Pow(\\omega; 2)), Pow(Add(Pow(c_j; 2), Pow(d_j; 2)); 2))), 0; >)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\boldsymbol{J}_{iR} = \\int_{t_0}^{t_0+\\tau}\\boldsymbol{R}_i\\mathrm{d} t",
        "Chain(\\boldsymbol{J}_{iR}, Integral(\\boldsymbol{R}_i; t; t_0; Add(t_0, \\tau)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "\\begin{aligned} \\dfrac{d J_{i,j}(\\mathbf q)}{dt} = \\dfrac{\\partial J_{i,j}(\\mathbf q)}{\\partial \\mathbf q} \\cdot \\dfrac{d\\mathbf q}{dt} = \\sum_{k=1}^{n} \\dfrac{\\partial J_{i,j}(\\mathbf q)}{\\partial q_k} \\cdot \\dfrac{dq_k}{dt} = \\sum_{k=1}^{n} H_{k_{i,j}}(\\mathbf q) \\cdot \\dfrac{dq_k}{dt}, \\end{aligned}",
        "Chain(Derivative(Call(J_{i,j}; Call(\\mathbf{q})); t, 1), Mul(Derivative(Call(J_{i,j}; Call(\\mathbf{q})); \\mathbf{q}, 1; True), Derivative(Call(\\mathbf{q}); t, 1); 1), BigSum(k; 1; n; Mul(Derivative(Call(J_{i,j}; Call(\\mathbf{q})); q_k, 1; True), Derivative(Call(q_k); t, 1))), BigSum(k; 1; n; Mul(Call(H_{k_i,j}; Call(\\mathbf{q})), Derivative(Call(q_k); t, 1))); =, =, =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "I = \\int_a^b f(t) dt",
        "Chain(I, Integral(Call(f; t); t; a; b); =)",
        "fredrik-johansson/arb/doc/source/acb_calc.rst",
    ),
    (
        "\\begin{aligned} {}_I\\mbox{\\boldmath $\\omega$}_{I\\!Q} &= {}_I\\mbox{\\boldmath $\\omega$}_{I\\!B} + {}_I\\mbox{\\boldmath $\\omega$}_{B\\!Q} \\\\ &= \\begin{bmatrix} \\mathbf{0}_{3 \\times 3} && \\mathbf C_{I\\!B} && \\mathbf C_{I\\!B} \\cdot {}_B \\mathbf J_{R_{q_j}}(\\mathbf q_j) \\end{bmatrix} \\cdot \\mathbf u \\end{aligned}",
        "Chain(\\prescript { } { I } { \\boldsymbol { \\omega } } _ { I \\! Q }, Add(\\prescript { } { I } { \\boldsymbol { \\omega } } _ { I \\! B }, \\prescript { } { I } { \\boldsymbol { \\omega } } _ { B \\! Q }), Mul(MatrixOf(Marked(0; _{ 3 \\times 3 }), Blank(), \\mathbf{C}_{I\\!B}, Blank(), Mul(\\mathbf{C}_{I\\!B}, Call(\\prescript { } { B } { \\mathbf { J } } _ { R _ { q _ { j } } }; \\mathbf{q}_j))), \\mathbf{u}; 1); =, =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "\\frac12 ml^2 \\dot{\\theta}^2 = -mgl(1+\\cos\\theta)",
        "Chain(Mul(Div(1; 2), m, Pow(l; 2), Pow(Call(\\dot{\\theta}); 2)), Neg(Mul(m, g, l, Add(1, Call(cos; Call(\\theta))))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "f(x) := \\frac{1}{\\pi\\sqrt{(x-a)(b-x)}}",
        "Chain(Call(f; x), Div(1; Mul(\\pi, Sqrt(Mul(Add(x, Neg(a)), Add(b, Neg(x)))))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "\\Delta P = \\Delta P_{lo} \\phi_{lo}^2",
        "Chain(\\Delta P, Mul(\\Delta P _ { l o }, Pow(\\phi_{lo}; 2)); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "\\bm{\\omega}_{B/N,n} = \\bm{\\omega}_{B/N,n-1} + \\frac{\\dot{\\bm{\\omega}}_{B/N,n-1}+\\dot{\\bm{\\omega}}_{B/N,n}}{2} \\Delta t",
        "Chain(Call(\\bm{\\omega}_{B/N,n}), Add(Call(\\bm{\\omega}_{B/N,n-1}), Mul(Div(Add(Call(\\dot{\\bm{\\omega}}_{B/N,n-1}), Call(\\dot{\\bm{\\omega}}_{B/N,n})); 2), \\Delta t)); =)",
        "AVSLab/basilisk/src/architecture/utilities/_Documentation/discretize/secTest.tex",
    ),
    (
        "{\\bf x}[1] =& {\\bf A}{\\bf x}[0] + {\\bf B}{\\bf u}[0] \\\\ {\\bf x}[2] =& {\\bf A}({\\bf A}{\\bf x}[0] + {\\bf B}{\\bf u}[0]) + {\\bf B}{\\bf u}[1] \\\\ {\\bf x}[n] =& {\\bf A}^n{\\bf x}[0] + \\sum_{k=0}^{n-1} {\\bf A}^{n-1-k}{\\bf B}{\\bf u}[k].",
        "System(Chain(Indexed(\\mathbf{x}; 1), Add(Mul(\\mathbf{A}, Indexed(\\mathbf{x}; 0)), Mul(\\mathbf{B}, Indexed(\\mathbf{u}; 0))); =), Chain(Indexed(\\mathbf{x}; 2), Add(Mul(\\mathbf{A}, Add(Mul(\\mathbf{A}, Indexed(\\mathbf{x}; 0)), Mul(\\mathbf{B}, Indexed(\\mathbf{u}; 0)))), Mul(\\mathbf{B}, Indexed(\\mathbf{u}; 1))); =), Chain(Indexed(\\mathbf{x}; n), Add(Mul(Pow(\\mathbf{A}; n), Indexed(\\mathbf{x}; 0)), BigSum(k; 0; Add(n, Neg(1)); Mul(Pow(\\mathbf{A}; Add(n, Neg(1), Neg(k))), \\mathbf{B}, Indexed(\\mathbf{u}; k)))); =))",
        "RussTedrake/underactuated/book/trajopt.html",
    ),
    (
        "\\boldsymbol{e} = \\frac{1}{\\mu}\\left[\\left(v^2 - \\frac{\\mu}{r}\\right)\\boldsymbol{r} - r v_r \\boldsymbol{v}\\right]",
        "Chain(\\boldsymbol{e}, Mul(Div(1; \\mu), Add(Mul(Add(Pow(v; 2), Neg(Div(\\mu; r))), \\boldsymbol{r}), Neg(Mul(r, v_r, \\boldsymbol{v})))); =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/orbital-elements-and-the-state-vector.md",
    ),
    (
        "a = \\frac{\\mu_f}{v_{\\infty}^2}",
        "Chain(a, Div(\\mu_f; Pow(v_\\infty; 2)); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-arrival-capture.md",
    ),
    (
        "{}^N\\bar{a}^S & = \\frac{{}^N d\\left({}^N\\bar{v}^P\\right)}{dt} + \\frac{{}^N d \\left( {}^N\\bar{\\omega}^A \\times \\bar{r}^{S/P}\\right)}{dt} \\\\ & = {}^N\\bar{a}^P + \\frac{{}^N d \\left( {}^N\\bar{\\omega}^A \\right)}{dt} \\times \\bar{r}^{S/P} + {}^N\\bar{\\omega}^A \\times \\frac{{}^N d \\left(\\bar{r}^{S/P}\\right)}{dt} \\\\ & = {}^N\\bar{a}^P + {}^N\\bar{\\alpha}^A \\times\\bar{r}^{S/P} + {}^N\\bar{\\omega}^A\\times\\left({}^N\\bar{\\omega}^A \\times\\bar{r}^{S/P}\\right)",
        "Chain(\\prescript { N } { } { \\bar { a } } ^ { S }, Add(Marked(Derivative(Call(\\prescript { N } { } { \\bar { v } } ^ { P }); t, 1); _{ N }), Marked(Derivative(Cross(Call(\\prescript { N } { } { \\bar { \\omega } } ^ { A }); Call(\\bar { r } ^ { S / P })); t, 1); _{ N })), Add(\\prescript { N } { } { \\bar { a } } ^ { P }, Cross(Marked(Derivative(Call(\\prescript { N } { } { \\bar { \\omega } } ^ { A }); t, 1); _{ N }); Call(\\bar { r } ^ { S / P })), Cross(Call(\\prescript { N } { } { \\bar { \\omega } } ^ { A }); Marked(Derivative(Call(\\bar { r } ^ { S / P }); t, 1); _{ N }))), Add(\\prescript { N } { } { \\bar { a } } ^ { P }, Cross(\\prescript { N } { } { \\bar { \\alpha } } ^ { A }; Call(\\bar { r } ^ { S / P })), Cross(Call(\\prescript { N } { } { \\bar { \\omega } } ^ { A }); Cross(Call(\\prescript { N } { } { \\bar { \\omega } } ^ { A }); Call(\\bar { r } ^ { S / P })))); =, =, =)",
        "moorepants/learn-multibody-dynamics/translational.rst",
    ),
    (
        "F = x^{0.78}(1 - x)^{0.224}",
        "Chain(F, Mul(Pow(x; 0.78), Pow(Add(1, Neg(x)); 0.224)); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "\\begin{bmatrix} \\mathbf{M}_k && 0 \\\\ 0 && \\mathbf{M}_d \\\\ \\end{bmatrix} \\begin{bmatrix} \\dot{\\bar{q}} \\\\ \\dot{\\bar{u}} \\end{bmatrix} + \\begin{bmatrix} \\bar{g}_k(\\bar{u}, \\bar{q}, t) \\\\ \\bar{g}_d(\\bar{u}, \\bar{q}, t) \\end{bmatrix} = \\begin{bmatrix} 0 \\\\ 0 \\end{bmatrix}",
        "Chain(Add(Mul(MatrixOf(\\mathbf{M}_k, Blank(), 0, 0, Blank(), \\mathbf{M}_d), MatrixOf(Call(\\dot{\\bar{q}}), Call(\\dot{\\bar{u}}))), MatrixOf(Call(\\bar{g}_k; Call(\\bar{u}), Call(\\bar{q}), t), Call(\\bar{g}_d; Call(\\bar{u}), Call(\\bar{q}), t))), MatrixOf(0, 0); =)",
        "moorepants/learn-multibody-dynamics/eom.rst",
    ),
    (
        "\\dot{x} = -x + \\alpha x^3, \\quad \\frac{3}{4} < \\alpha < \\frac{3}{2}.",
        "System(Chain(Call(\\dot{x}), Add(Neg(Call(x)), Mul(\\alpha, Pow(Call(x); 3))); =), Chain(Div(3; 4), \\alpha, Div(3; 2); <, <))",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "\\mathbf{M} = \\sum_{i=1}^nw_i\\mathbf{q}_i\\mathbf{q}_i^T",
        "Chain(\\mathbf{M}, BigSum(i; 1; n; Mul(w_i, \\mathbf{q}_i, Transpose(\\mathbf{q}_i))); =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "z_{t+1}=Az_t+Bu+C",
        "Chain(z_{t+1}, Add(Mul(A, z_t), Mul(B, u), C); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/model_predictive_speed_and_steering_control/model_predictive_speed_and_steering_control_main.rst",
    ),
    (
        "\\alpha_1 = f_d\\left(1 - \\sqrt{1 - \\left(\\frac{0.5 - f_k}{f_d-f_k} \\right)^2}\\right)",
        "Chain(\\alpha_1, Mul(f_d, Add(1, Neg(Sqrt(Add(1, Neg(Pow(Div(Add(0.5, Neg(f_k)); Add(f_d, Neg(f_k))); 2))))))); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "L = \\frac12 m\\dot{\\boldsymbol{r}}^2 + e \\boldsymbol{A} \\cdot \\dot{\\boldsymbol{r}} - e\\phi",
        "Chain(L, Add(Mul(Div(1; 2), m, Pow(Call(\\dot{\\boldsymbol{r}}); 2)), Mul(e, \\boldsymbol{A}, Call(\\dot{\\boldsymbol{r}})), Neg(Mul(e, \\phi))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "\\tilde{h}(v) \\le h(v), \\forall v \\in V.",
        "System(Chain(Call(\\tilde{h}; v), Call(h; v); \\le), Forall(Chain(v, V; \\in)))",
        "RussTedrake/underactuated/book/planning.html",
    ),
    (
        "W = 0.106V^{0.6}",
        "Chain(W, Mul(0.106, Pow(V; 0.6)); =)",
        "CalebBell/fluids/fluids/jet_pump.py",
    ),
    (
        "m_j \\hat{\\bm p_j}^T \\ddot{\\bm{r}}_{B/N} - m_j \\hat{\\bm p_j}^T [\\tilde{\\bm{r}}_{P_{c,j}/B}] \\dot{\\bm\\omega}_{\\cal B/N} + m_j \\ddot{\\rho}_j \\\\ = \\hat{\\bm p_j}^T \\bm F_G - k_j \\rho_j - c_j \\dot{\\rho_j} - 2 m_j \\hat{\\bm p_j}^T [\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm{r}'_{P_{c,j}/B} - m_j \\hat{\\bm p_j}^T [\\tilde{\\bm\\omega}_{\\cal B/N}] [\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm{r}_{P_{c,j}/B}",
        "Chain(Add(Mul(m_j, Transpose(\\hat{\\bm{p}}_j), Call(\\ddot{\\bm{r}}_{B/N})), Neg(Mul(m_j, Transpose(\\hat{\\bm{p}}_j), [ \\tilde { \\bm { r } } _ { P _ { c , j } / B } ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }))), Mul(m_j, Call(\\ddot{\\rho}_j))), Add(Mul(Transpose(\\hat{\\bm{p}}_j), \\bm{F}_G), Neg(Mul(k_j, Call(\\rho_j))), Neg(Mul(c_j, Call(\\dot{\\rho}_j))), Neg(Mul(2, m_j, Transpose(\\hat{\\bm{p}}_j), [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{r}_{P_c,j/B}')), Neg(Mul(m_j, Transpose(\\hat{\\bm{p}}_j), [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{r}_{P_c,j/B}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/LinearSpringMassDamper/_Documentation/secModelDescription.tex",
    ),
    (
        "^L_G\\dot{\\mathbf{q}}_{\\omega, t_k}= \\,^G_L\\dot{\\mathbf{q}}_{\\omega, t_k}^*=-\\frac{1}{2}\\,^L\\mathbf{\\omega}_{q, t_k}\\,^L_G\\mathbf{q}_{t_{k-1}}",
        "Chain(Call(\\prescript { L } { G } { \\dot { \\mathbf { q } } } _ { \\omega , t _ { k } }), Call(\\prescript { G } { L } { \\dot { \\mathbf { q } } } _ { \\omega , t _ { k } } ^ { * }), Neg(Mul(Div(1; 2), \\prescript { L } { } { \\mathbf { \\omega } } _ { q , t _ { k } }, \\prescript { L } { G } { \\mathbf { q } } _ { t _ { k - 1 } })); =, =)",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "E\\left[ \\Delta {\\bf \\alpha} \\right] \\approx -\\eta \\sigma_\\beta^2 \\frac{\\partial g}{\\partial {\\bf \\alpha}}^T.",
        "Chain(Indexed(E; \\Delta \\mathbf { \\alpha }), Neg(Mul(\\eta, Pow(\\sigma_\\beta; 2), Transpose(Derivative(Call(g); \\mathbf{\\alpha}, 1; True)))); \\approx)",
        "RussTedrake/underactuated/book/rl_policy_search.html",
    ),
    (
        "i_{out} = i_{main} + i_{off}",
        "Chain(i_{out}, Add(i_{main}, i_{off}); =)",
        "AVSLab/basilisk/src/fswAlgorithms/orbitControl/orbElemOffset/orbElemOffset.rst",
    ),
    (
        "t_c = t_{b1} + \\frac{\\Delta \\rho_{\\text{coast}}}{\\dot{\\rho}(t_{b1})}",
        "Chain(t_c, Add(t_{b1}, Div(\\Delta \\rho _ { \\text { c o a s t } }; Call(\\dot{\\rho}; t_{b1}))); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedLinearTranslation/prescribedLinearTranslation.rst",
    ),
    (
        "\\boldsymbol{a}_i = \\boldsymbol{a}_i'+\\boldsymbol{a}_C",
        "Chain(\\boldsymbol{a}_i, Add(\\boldsymbol{a}_i', \\boldsymbol{a}_C); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "M_e = \\left[2\\tan^{-1}\\left(\\sqrt{\\frac{1 - e}{1 + e}}\\tan\\frac{\\nu}{2}\\right)-\\frac{e\\sqrt{1 - e^2}\\sin \\nu}{1 + e \\cos \\nu}\\right]",
        "Chain(M_e, Add(Mul(2, Call(arctan; Mul(Sqrt(Div(Add(1, Neg(e)); Add(1, e))), Call(tan; Div(\\nu; 2))))), Neg(Div(Mul(e, Sqrt(Add(1, Neg(Pow(e; 2)))), Call(sin; \\nu)); Add(1, Mul(e, Call(cos; \\nu)))))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "\\mu_m = \\frac{\\mu_l \\mu_g}{\\mu_g + x^{1.4}(\\mu_l - \\mu_g)}",
        "Chain(\\mu_m, Div(Mul(\\mu_l, \\mu_g); Add(\\mu_g, Mul(Pow(x; 1.4), Add(\\mu_l, Neg(\\mu_g))))); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "\\bar{u}_r = \\mathbf{A}_r^{-1}\\left(-\\mathbf{A}_s \\bar{u}_s - \\bar{b}_{rs}\\right) \\\\ \\bar{u}_r = \\mathbf{A}_n \\bar{u}_s + \\bar{b}_n",
        "System(Chain(\\bar{u}_r, Mul(Pow(\\mathbf{A}_r; Neg(1)), Add(Neg(Mul(\\mathbf{A}_s, \\bar{u}_s)), Neg(\\bar{b}_{rs}))); =), Chain(\\bar{u}_r, Add(Mul(\\mathbf{A}_n, \\bar{u}_s), \\bar{b}_n); =))",
        "moorepants/learn-multibody-dynamics/motion.rst",
    ),
    (
        "t-t_0 = \\sqrt{\\frac{\\mu p^3}{|\\alpha|}} \\int_0^\\eta \\frac12(1+\\eta^2) \\mathrm{d}\\eta = \\sqrt{\\frac{\\mu p^3}{|\\alpha|}} \\frac{\\eta}{2}\\left(1+\\frac{\\eta^3}{3}\\right)",
        "Chain(Add(t, Neg(t_0)), Mul(Sqrt(Div(Mul(\\mu, Pow(p; 3)); Bars(\\alpha))), Integral(Mul(Div(1; 2), Add(1, Pow(\\eta; 2))); \\eta; 0; \\eta)), Mul(Sqrt(Div(Mul(\\mu, Pow(p; 3)); Bars(\\alpha))), Div(\\eta; 2), Add(1, Div(Pow(\\eta; 3); 3))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "\\boldsymbol{v} = \\dot{\\boldsymbol{r}} = \\dot{{x}_{\\omega}}\\boldsymbol{\\hat{p}} + \\dot{{y}_{\\omega}}\\boldsymbol{\\hat{q}}",
        "Chain(\\boldsymbol{v}, Call(\\dot{\\boldsymbol{r}}), Add(Mul(Call(\\dot{x}_\\omega), \\boldsymbol{\\hat{p}}), Mul(Call(\\dot{y}_\\omega), \\boldsymbol{\\hat{q}})); =, =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/perifocal-frame.md",
    ),
    (
        "\\tau = \\frac{\\Delta t}{\\ell / v_a}",
        "Chain(\\tau, Div(\\Delta t; Div(\\ell; v_a)); =)",
        "AVSLab/basilisk/src/simulation/environment/stripLocation/stripLocation.rst",
    ),
    (
        "{}^N\\bar{a}^R = {}^B\\bar{a}^R + {}^N\\bar{a}^T + 2{}^N\\bar{\\omega}^B \\times {}^B\\bar{v}^R",
        "Chain(\\prescript { N } { } { \\bar { a } } ^ { R }, Add(\\prescript { B } { } { \\bar { a } } ^ { R }, \\prescript { N } { } { \\bar { a } } ^ { T }, Cross(Mul(2, \\prescript { N } { } { \\bar { \\omega } } ^ { B }); \\prescript { B } { } { \\bar { v } } ^ { R })); =)",
        "moorepants/learn-multibody-dynamics/translational.rst",
    ),
    (
        "\\mathbf{B} = \\sum_{i=1}^Nw_i\\mathbf{UV}",
        "Chain(\\mathbf{B}, BigSum(i; 1; N; Mul(w_i, \\mathbf{U}, \\mathbf{V})); =)",
        "Mayitzin/ahrs/ahrs/filters/davenport.py",
    ),
    (
        "{\\vphantom{\\bm \\omega_{R/N} }}^{\\mathcal{R}\\!}{\\bm \\omega_{R/N} } = \\begin{bmatrix} 0\\\\ 0 \\\\ \\dot{f} \\end{bmatrix}",
        "Chain(\\prescript { \\mathcal { R } \\! } { } { \\bm { \\omega } } _ { R / N }, MatrixOf(0, 0, Call(\\dot{f})); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/hillPoint/_Documentation/hillPoint.tex",
    ),
    (
        "\\operatorname{agm}(a,b) = \\frac{(a+b) \\pi}{4 K(z^2)},",
        "Chain(Call(\\text{agm}; a, b), Div(Mul(Add(a, b), \\pi); Mul(4, Call(K; Pow(z; 2)))); =)",
        "fredrik-johansson/arb/doc/source/agm.rst",
    ),
    (
        "(F_r)_B := {}^A\\bar{v}^Q_r \\cdot \\bar{R} + {}^A\\bar{\\omega}^B_r \\cdot \\bar{T}",
        "Chain(Marked(F_r; _{ B }), Add(Mul(\\prescript { A } { } { \\bar { v } } _ { r } ^ { Q }, \\bar{R}; 1), Mul(\\prescript { A } { } { \\bar { \\omega } } _ { r } ^ { B }, \\bar{T}; 1)); =)",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "f_i = S_{n_{i-1}-1}(f,g) \\qquad (2\\le i \\le k).",
        "System(Chain(f_i, Call(S_{n_i-1-1}; f, g); =), Chain(2, i, k; \\le, \\le))",
        "sympy/sympy/doc/src/modules/polys/internals.rst",
    ),
    (
        "\\eta = 1 - (v - u) - \\mu - \\rho",
        "Chain(\\eta, Add(1, Neg(Add(v, Neg(u))), Neg(\\mu), Neg(\\rho)); =)",
        "sympy/sympy/doc/src/modules/integrals/g-functions.rst",
    ),
    (
        "\\dot{\\bar{\\bf x}} \\approx f({\\bf x}_0,{\\bf u}_0) + \\frac{\\partial f({\\bf x}_0,{\\bf u}_0)}{\\partial {\\bf x}} ({\\bf x} - {\\bf x}_0) + \\frac{\\partial f({\\bf x}_0,{\\bf u}_0)}{\\partial {\\bf u}} ({\\bf u} - {\\bf u}_0) = {\\bf A}\\bar{{\\bf x}} + {\\bf B}\\bar{\\bf u}.",
        "Chain(Call(\\dot{\\bar{\\mathbf{x}}}), Add(Call(f; \\mathbf{x}_0, \\mathbf{u}_0), Mul(Derivative(Call(f; \\mathbf{x}_0, \\mathbf{u}_0); \\mathbf{x}, 1; True), Add(\\mathbf{x}, Neg(\\mathbf{x}_0))), Mul(Derivative(Call(f; \\mathbf{x}_0, \\mathbf{u}_0); \\mathbf{u}, 1; True), Add(\\mathbf{u}, Neg(\\mathbf{u}_0)))), Add(Mul(\\mathbf{A}, Call(\\bar{\\mathbf{x}})), Mul(\\mathbf{B}, \\bar{\\mathbf{u}})); \\approx, =)",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "[b_{n+1}]_i = f_i(b_n, u_n, y_n) = \\frac{P_y(y_n | x_i) \\sum_{j \\in |X|} P_x(x_i|x_j,u_n) [b_n]_j}{\\Pr(y_n | b_n, u_n)}",
        "Chain(Marked(b_{n+1}; _{ i }), Call(f_i; b_n, u_n, y_n), Div(Mul(Call(P_y; Given(y_n; x_i; |)), Limiting(sum; _{ j \\in | X | }; Mul(Call(P_x; Given(x_i; x_j, u_n; |)), Marked(b_n; _{ j })))); Call(Pr; Given(y_n; b_n, u_n; |))); =, =)",
        "RussTedrake/underactuated/book/belief.html",
    ),
    (
        "U_{n,2\\,j-1} &=& a_j\\,e^{-c_j\\,t_n}\\,\\cos(d_j\\,t_n) + b_j\\,e^{-c_j\\,t_n}\\,\\sin(d_j\\,t_n) \\\\ U_{n,2\\,j} &=& a_j\\,e^{-c_j\\,t_n}\\,\\sin(d_j\\,t_n) - b_j\\,e^{-c_j\\,t_n}\\,\\cos(d_j\\,t_n) \\\\ V_{m,2\\,j-1} &=& e^{c_j\\,t_m}\\,\\cos(d_j\\,t_m) \\\\ V_{m,2\\,j} &=& e^{c_j\\,t_m}\\,\\sin(d_j\\,t_m) \\\\ A_{n,n} &=& \\sigma_n^2 + \\sum_{j=1}^J a_j \\quad.",
        "System(Chain(U_{n,2\\,j-1}, Add(Mul(a_j, Pow(e; Neg(Mul(c_j, t_n))), Call(cos; Mul(d_j, t_n))), Mul(b_j, Pow(e; Neg(Mul(c_j, t_n))), Call(sin; Mul(d_j, t_n)))); =), Chain(U_{n,2\\,j}, Add(Mul(a_j, Pow(e; Neg(Mul(c_j, t_n))), Call(sin; Mul(d_j, t_n))), Neg(Mul(b_j, Pow(e; Neg(Mul(c_j, t_n))), Call(cos; Mul(d_j, t_n))))); =), Chain(V_{m,2\\,j-1}, Mul(Pow(e; Mul(c_j, t_m)), Call(cos; Mul(d_j, t_m))); =), Chain(V_{m,2\\,j}, Mul(Pow(e; Mul(c_j, t_m)), Call(sin; Mul(d_j, t_m))); =), Chain(A_{n,n}, Add(Pow(\\sigma_n; 2), BigSum(j; 1; J; a_j)); =))",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "S_j(\\omega) = \\sqrt{\\frac{2}{\\pi}}\\,\\frac{a_j}{c_j}\\, \\frac{1}{1+{\\left(\\frac{\\omega}{c_j}\\right)}^2} \\quad.",
        "Chain(Call(S_j; \\omega), Mul(Sqrt(Div(2; \\pi)), Div(a_j; c_j), Div(1; Add(1, Pow(Div(\\omega; c_j); 2)))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\dot{e}_t = V \\theta_{t-1}",
        "Chain(Call(\\dot{e}_t), Mul(V, \\theta_{t-1}); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/lqr_speed_and_steering_control/lqr_speed_and_steering_control_main.rst",
    ),
    (
        "\\bar{R}^*_i := -m_i {}^A\\bar{a}^{P_i}_i",
        "Chain(\\bar { R } _ { i } ^ { * }, Neg(Mul(m_i, \\prescript { A } { } { \\bar { a } } _ { i } ^ { P _ { i } })); =)",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "{ {\\boldsymbol{y}}} = \\left(\\begin{array}{ccccc} y_1\\quad & & \\cdots\\quad & & y_N \\end{array}\\right)^\\mathrm{T}",
        "Chain(\\boldsymbol{y}, Transpose(MatrixOf(y_1, Blank(), Dots(), Blank(), y_N)); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\Delta\\boldsymbol{v} = \\frac{\\boldsymbol{F}}{m}\\Delta t",
        "Chain(\\Delta \\boldsymbol { v }, Mul(Div(\\boldsymbol{F}; m), \\Delta t); =)",
        "bryanwweber/orbital-mechanics-notes/intro/force-acceleration-and-momentum.md",
    ),
    (
        "v_{\\text{latitude}} = v_{\\text{equatorial}} \\cos\\phi",
        "Chain(v_{latitude}, Mul(v_{equatorial}, Call(cos; \\phi)); =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/plane-change-maneuvers.md",
    ),
    (
        "\\delta H = 0,\\quad \\delta t \\neq 0,\\quad \\delta \\tau = 0",
        "System(Chain(\\delta H, 0; =), Chain(\\delta t, 0; \\ne), Chain(\\delta \\tau, 0; =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter9.tex",
    ),
    (
        "\\int_{0}^\\pi \\cos (mt) \\cos (nt) \\,dt = 0 , \\quad \\text{when } m \\neq n, \\qquad \\text{and} \\qquad \\int_{0}^\\pi \\cos (nt) \\,dt = 0 .",
        "System(Implies(Chain(m, n; \\ne); Chain(Integral(Mul(Call(cos; Mul(m, t)), Call(cos; Mul(n, t))); t; 0; \\pi), 0; =)), Chain(Integral(Call(cos; Mul(n, t)); t; 0; \\pi), 0; =))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\frac{xy+1}{y} = x+\\frac{1}{y} = x+ A'(y) .",
        "Chain(Div(Add(Mul(x, y), 1); y), Add(x, Div(1; y)), Add(x, Call(A'; y)); =, =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "g_n^m(t) & = & g_n^m(t_0) + (t-t_0) \\dot{g}_n^m(t_0) \\\\ h_n^m(t) & = & h_n^m(t_0) + (t-t_0) \\dot{h}_n^m(t_0)",
        "System(Chain(Call(g _ { n } ^ { m }; t), Add(Call(g _ { n } ^ { m }; t_0), Mul(Add(t, Neg(t_0)), Call(\\dot { g } _ { n } ^ { m }; t_0))); =), Chain(Call(h _ { n } ^ { m }; t), Add(Call(h _ { n } ^ { m }; t_0), Mul(Add(t, Neg(t_0)), Call(\\dot { h } _ { n } ^ { m }; t_0))); =))",
        "Mayitzin/ahrs/ahrs/utils/wmm.py",
    ),
    (
        "u=K_p(q_d-q) + K_d(\\dot{q}_d - \\dot{q}),",
        "Chain(u, Add(Mul(K_p, Add(Call(q_d), Neg(Call(q)))), Mul(K_d, Add(Call(\\dot{q}_d), Neg(Call(\\dot{q}))))); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "Y(l_1,l_2,l_3,m_1,m_2,m_3) =Y(l_1,l_2,l_3,-m_1,-m_2,-m_3)",
        "Chain(Call(Y; l_1, l_2, l_3, m_1, m_2, m_3), Call(Y; l_1, l_2, l_3, Neg(m_1), Neg(m_2), Neg(m_3)); =)",
        "sympy/sympy/sympy/physics/wigner.py",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{x} &=& \\begin{bmatrix} q_w & q_x & q_y & q_z \\end{bmatrix}^T \\\\ \\\\ \\mathbf{u} &=& \\begin{bmatrix} \\omega_x & \\omega_y & \\omega_z \\end{bmatrix}^T \\end{array}",
        "System(Chain(\\mathbf{x}, Transpose(MatrixOf(q_w, q_x, q_y, q_z)); =), Chain(\\mathbf{u}, Transpose(MatrixOf(\\omega_x, \\omega_y, \\omega_z)); =))",
        "Mayitzin/ahrs/ahrs/filters/ukf.py",
    ),
    (
        "\\mathrm{PER} = 1 - (1-\\mathrm{BER})^L",
        "Chain(\\text{PER}, Add(1, Neg(Pow(Add(1, Neg(\\text{BER})); L))); =)",
        "AVSLab/basilisk/src/simulation/communication/downlinkHandling/downlinkHandling.rst",
    ),
    (
        "C_{\\infty} = 0.5959 + 0.461\\beta^{2.1} + 0.48\\beta^8 + \\frac{0.039\\beta^4}{(1.0 - \\beta^4)}",
        "Chain(C_\\infty, Add(0.5959, Mul(0.461, Pow(\\beta; 2.1)), Mul(0.48, Pow(\\beta; 8)), Div(Mul(0.039, Pow(\\beta; 4)); Add(1.0, Neg(Pow(\\beta; 4))))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "\\mathbf{q}_t = \\hat{\\mathbf{q}}_t + \\mathbf{K}_t \\big(\\mathbf{z}_t - \\mathbf{h}(\\mathbf{q}_t)\\big)",
        "Chain(\\mathbf{q}_t, Add(\\hat{\\mathbf{q}}_t, Mul(\\mathbf{K}_t, Add(\\mathbf{z}_t, Neg(Call(\\mathbf{h}; \\mathbf{q}_t))))); =)",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "\\mathbf{R} = \\begin{bmatrix} \\sigma_v^2 & 0 \\\\ 0 & \\sigma_\\omega^2 \\end{bmatrix}",
        "Chain(\\mathbf{R}, MatrixOf(Pow(\\sigma_v; 2), 0, 0, Pow(\\sigma_\\omega; 2)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/ensamble_kalman_filter_localization_files/ensamble_kalman_filter_localization_main.rst",
    ),
    (
        "E = \\frac{v_p^2}{2} - \\frac{\\mu_i}{r_p} = \\frac{v_{\\infty}^2}{2} - \\frac{\\mu_i}{r_{\\infty}}",
        "Chain(E, Add(Div(Pow(v_p; 2); 2), Neg(Div(\\mu_i; r_p))), Add(Div(Pow(v_\\infty; 2); 2), Neg(Div(\\mu_i; r_\\infty))); =, =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-depahture-trajectory.md",
    ),
    (
        "\\boldsymbol{X}_2 = \\boldsymbol{U}_2 \\boldsymbol{U}_1^{-1} \\boldsymbol{X}_1 = (\\boldsymbol{U}_2 \\boldsymbol{U}_1^{\\mathrm{T}}) \\boldsymbol{X}_1 = \\boldsymbol{U} \\boldsymbol{X}_1",
        "Chain(\\boldsymbol{X}_2, Mul(\\boldsymbol{U}_2, Pow(\\boldsymbol{U}_1; Neg(1)), \\boldsymbol{X}_1), Mul(Mul(\\boldsymbol{U}_2, Transpose(\\boldsymbol{U}_1)), \\boldsymbol{X}_1), Mul(\\boldsymbol{U}, \\boldsymbol{X}_1); =, =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "\\boldsymbol{\\Omega} = \\varOmega\\boldsymbol{\\hat{k}}",
        "Chain(\\boldsymbol{\\Omega}, Mul(\\varOmega, \\boldsymbol{\\hat{k}}); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "b y' = (c - a) z x f(x, y, z, t)",
        "Chain(Mul(b, y'), Mul(Add(c, Neg(a)), z, x, Call(f; x, y, z, t)); =)",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "U = \\begin{bmatrix} U_{0, 0} & U_{0, 1} & U_{0, 2} & \\cdots & U_{0, n-1} \\\\ 0 & U_{1, 1} & U_{1, 2} & \\cdots & U_{1, n-1} \\\\ 0 & 0 & U_{2, 2} & \\cdots & U_{2, n-1} \\\\ \\vdots & \\vdots & \\vdots & \\ddots & \\vdots \\\\ 0 & 0 & 0 & \\cdots & U_{n-1, n-1} \\\\ 0 & 0 & 0 & \\cdots & 0 \\\\ \\vdots & \\vdots & \\vdots & \\ddots & \\vdots \\\\ 0 & 0 & 0 & \\cdots & 0 \\end{bmatrix}",
        "Chain(U, MatrixOf(U_{0,0}, U_{0,1}, U_{0,2}, Dots(), U_{0,n-1}, 0, U_{1,1}, U_{1,2}, Dots(), U_{1,n-1}, 0, 0, U_{2,2}, Dots(), U_{2,n-1}, Dots(), Dots(), Dots(), Dots(), Dots(), 0, 0, 0, Dots(), U_{n-1,n-1}, 0, 0, 0, Dots(), 0, Dots(), Dots(), Dots(), Dots(), Dots(), 0, 0, 0, Dots(), 0); =)",
        "sympy/sympy/sympy/matrices/decompositions.py",
    ),
    (
        "\\mathrm{KE} + V = E",
        "Chain(Add(\\text{KE}, V), E; =)",
        "bryanwweber/orbital-mechanics-notes/constants-of-orbital-motion/energy-is-conserved-in-orbital-motion.md",
    ),
    (
        "\\mathbf{r}_{B/L} = x\\hat{S} + y\\hat{E} + z\\hat{Z}",
        "Chain(\\mathbf{r}_{B/L}, Add(Mul(x, \\hat{S}), Mul(y, \\hat{E}), Mul(z, \\hat{Z})); =)",
        "AVSLab/basilisk/src/simulation/environment/groundLocation/groundLocation.rst",
    ),
    (
        "\\frac{B_{rough}}{B_{smooth}} = \\left[0.5\\left\\{1+ \\left(\\frac{\\mu_g} {\\mu_l}\\right)^2 + 10^{-600\\epsilon/D}\\right\\}\\right]^{\\frac{0.25-n} {0.25}}",
        "Chain(Div(B_{rough}; B_{smooth}), Pow(Mul(0.5, Tuple(Add(1, Pow(Div(\\mu_g; \\mu_l); 2), Pow(10; Neg(Div(Mul(600, \\epsilon); D)))); {})); Div(Add(0.25, Neg(n)); 0.25)); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "b_3(t) = t + 4t^2 - 3t^3",
        "Chain(Call(b_3; t), Add(t, Mul(4, Pow(t; 2)), Neg(Mul(3, Pow(t; 3)))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/catmull_rom_spline/catmull_rom_spline_main.rst",
    ),
    (
        "h>\\left(1-\\sqrt{\\frac{\\chi}{1+\\chi}}\\right)R",
        "Chain(h, Mul(Add(1, Neg(Sqrt(Div(\\chi; Add(1, \\chi))))), R); >)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "\\begin{aligned} {}^Wp^{s_0}&=(1,5) \\\\ {}^Wp^{s_1}&=(3,10) \\\\ {}^Wp^{s_2}&=(5,10) \\end{aligned}",
        "System(Chain(\\prescript { W } { } { p } ^ { s _ { 0 } }, Pair(1; 5); =), Chain(\\prescript { W } { } { p } ^ { s _ { 1 } }, Pair(3; 10); =), Chain(\\prescript { W } { } { p } ^ { s _ { 2 } }, Pair(5; 10); =))",
        "RussTedrake/manipulation/book/pose.html",
    ),
    (
        "{\\bf E}\\dot{\\bf x} = {\\bf A}{\\bf x} + {\\bf B}{\\bf u},",
        "Chain(Mul(\\mathbf{E}, Call(\\dot{\\mathbf{x}})), Add(Mul(\\mathbf{A}, Call(\\mathbf{x})), Mul(\\mathbf{B}, \\mathbf{u})); =)",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "\\hat{\\bm r} = \\frac{\\bm r_{B/P}}{|\\bm r_{B/P}|}",
        "Chain(\\hat{\\bm{r}}, Div(\\bm{r}_{B/P}; Bars(\\bm{r}_{B/P})); =)",
        "AVSLab/basilisk/src/simulation/environment/magneticFieldCenteredDipole/_Documentation/secModuleDescription.tex",
    ),
    (
        "f^{B_p}_D = {}^DR^C f^{B_p}_C, \\qquad \\tau^{B_p}_D = {}^DR^C \\tau^{B_p}_C.",
        "System(Chain(f _ { D } ^ { B _ { p } }, Mul(\\prescript { D } { } { R } ^ { C }, f _ { C } ^ { B _ { p } }); =), Chain(\\tau _ { D } ^ { B _ { p } }, Mul(\\prescript { D } { } { R } ^ { C }, \\tau _ { C } ^ { B _ { p } }); =))",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "{}^A\\bar{\\omega}^B = u_1\\hat{a}_x + u_2\\hat{a}_y + u_3\\hat{a}_z",
        "Chain(\\prescript { A } { } { \\bar { \\omega } } ^ { B }, Add(Mul(u_1, \\hat{a}_x), Mul(u_2, \\hat{a}_y), Mul(u_3, \\hat{a}_z)); =)",
        "moorepants/learn-multibody-dynamics/motion.rst",
    ),
    (
        "\\begin{array}{l} \\bar{n}_x\\cdot ({}^N\\bar{v}^{B_o} + {}^N\\bar{\\omega}^B \\times (-r\\hat{n}_z)) = 0 \\\\ \\bar{n}_y\\cdot ({}^N\\bar{v}^{B_o} + {}^N\\bar{\\omega}^B \\times (-r\\hat{n}_z)) = 0 \\\\ \\bar{n}_z\\cdot ({}^N\\bar{v}^{B_o} + {}^N\\bar{\\omega}^B \\times (-r\\hat{n}_z)) = 0 \\\\ \\end{array}",
        "System(Chain(Mul(\\bar{n}_x, Add(\\prescript { N } { } { \\bar { v } } ^ { B _ { o } }, Cross(\\prescript { N } { } { \\bar { \\omega } } ^ { B }; Neg(Mul(r, \\hat{n}_z))))), 0; =), Chain(Mul(\\bar{n}_y, Add(\\prescript { N } { } { \\bar { v } } ^ { B _ { o } }, Cross(\\prescript { N } { } { \\bar { \\omega } } ^ { B }; Neg(Mul(r, \\hat{n}_z))))), 0; =), Chain(Mul(\\bar{n}_z, Add(\\prescript { N } { } { \\bar { v } } ^ { B _ { o } }, Cross(\\prescript { N } { } { \\bar { \\omega } } ^ { B }; Neg(Mul(r, \\hat{n}_z))))), 0; =))",
        "moorepants/learn-multibody-dynamics/lagrange.rst",
    ),
    (
        "\\mathbf{A} = \\mathbf{M}_b\\mathbf{M}_r^T",
        "Chain(\\mathbf{A}, Mul(\\mathbf{M}_b, Transpose(\\mathbf{M}_r)); =)",
        "Mayitzin/ahrs/ahrs/filters/triad.py",
    ),
    (
        "\\begin{aligned}r &= \\frac{h^2}{\\mu}\\frac{1}{1 + e\\cos\\nu_0} & v_{r,0} = \\frac{\\mu}{h}\\sin\\nu_0\\end{aligned}",
        "System(Chain(r, Mul(Div(Pow(h; 2); \\mu), Div(1; Add(1, Mul(e, Call(cos; \\nu_0))))); =), Chain(v_{r,0}, Mul(Div(\\mu; h), Call(sin; \\nu_0)); =))",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/the-lagrange-coefficients.md",
    ),
    (
        "m v^{+} = -e m v^{-}",
        "Chain(Mul(m, v ^ { + }), Neg(Mul(e, m, v ^ { - })); =)",
        "moorepants/learn-multibody-dynamics/loads.rst",
    ),
    (
        "y = \\frac{-x^2-1}{x-1} .",
        "Chain(y, Div(Add(Neg(Pow(x; 2)), Neg(1)); Add(x, Neg(1))); =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "{}^A\\omega^B_F + {}^B\\omega^C_F = {}^A\\omega^C_F,",
        "Chain(Add(\\prescript { A } { } { \\omega } _ { F } ^ { B }, \\prescript { B } { } { \\omega } _ { F } ^ { C }), \\prescript { A } { } { \\omega } _ { F } ^ { C }; =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\nu_{i,2} = \\nu_{i,1} + n_i t_{12}",
        "Chain(\\nu_{i,2}, Add(\\nu_{i,1}, Mul(n_i, t_{12})); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/interplanetary-transfer-phasing.md",
    ),
    (
        "\\begin{array}{rcl} w_0^{(m)} &=& \\frac{\\lambda}{n + \\lambda} \\\\ w_0^{(c)} &=& \\frac{\\lambda}{n + \\lambda} + (1 - \\alpha^2 + \\beta) \\\\ w_i^{(m)} = w_i^{(c)} &=& \\frac{1}{2(n + \\lambda)} \\quad \\text{for} \\quad i=1,2,\\ldots,2n \\end{array}",
        "System(Chain(w _ { 0 } ^ { ( m ) }, Div(\\lambda; Add(n, \\lambda)); =), Chain(w _ { 0 } ^ { ( c ) }, Add(Div(\\lambda; Add(n, \\lambda)), Add(1, Neg(Pow(\\alpha; 2)), \\beta)); =), Chain(w _ { i } ^ { ( m ) }, w _ { i } ^ { ( c ) }, Div(1; Mul(2, Add(n, \\lambda))); =, =), Values(i; 1, 2, Dots(), Mul(2, n)))",
        "Mayitzin/ahrs/ahrs/filters/ukf.py",
    ),
    (
        "\\operatorname{Bi}(z) = \\frac{1}{2 \\sqrt{\\pi} z^{1/4}} [2X + iY]",
        "Chain(Call(\\text{Bi}; z), Mul(Div(1; Mul(2, Sqrt(\\pi), Pow(z; Div(1; 4)))), Add(Mul(2, X), Mul(i, Y))); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "\\boldsymbol{v}' = \\boldsymbol{v} - \\boldsymbol{v}_0,\\quad \\boldsymbol{a}' = \\boldsymbol{a}",
        "System(Chain(\\boldsymbol{v}', Add(\\boldsymbol{v}, Neg(\\boldsymbol{v}_0)); =), Chain(\\boldsymbol{a}', \\boldsymbol{a}; =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "\\boxed{\\mathbf{q}_{t+1} = \\Bigg[ \\cos\\Big(\\frac{\\|\\boldsymbol\\omega\\|\\Delta t}{2}\\Big)\\mathbf{I}_4 + \\frac{1}{\\|\\boldsymbol\\omega\\|}\\sin\\Big(\\frac{\\|\\boldsymbol\\omega\\|\\Delta t}{2}\\Big)\\boldsymbol\\Omega(\\boldsymbol\\omega) \\Bigg]\\mathbf{q}_t}",
        "Chain(\\mathbf{q}_{t+1}, Mul(Add(Mul(Call(cos; Div(Mul(Norm(\\boldsymbol{\\omega}), \\Delta t); 2)), \\mathbf{I}_4), Mul(Div(1; Norm(\\boldsymbol{\\omega})), Call(sin; Div(Mul(Norm(\\boldsymbol{\\omega}), \\Delta t); 2)), Call(\\boldsymbol{\\Omega}; \\boldsymbol{\\omega}))), \\mathbf{q}_t); =)",
        "Mayitzin/ahrs/ahrs/filters/angular.py",
    ),
    (
        "\\dot{\\bar{u}}_r = \\dot{\\mathbf{A}}_n \\bar{u}_s + \\mathbf{A}_n \\dot{\\bar{u}}_s + \\dot{\\bar{b}}_n",
        "Chain(Call(\\dot{\\bar{u}}_r), Add(Mul(Call(\\dot{\\mathbf{A}}_n), Call(\\bar{u}_s)), Mul(Call(\\mathbf{A}_n), Call(\\dot{\\bar{u}}_s)), Call(\\dot{\\bar{b}}_n)); =)",
        "moorepants/learn-multibody-dynamics/nonholonomic-eom.rst",
    ),
    (
        "C = \\begin{cases} 2 \\exp(7 / (36 |\\zeta|)) & |\\arg(z)| \\le \\pi/3 \\\\ 2 \\chi(n) \\exp(7 \\pi / (72 |\\zeta|)) & \\pi/3 \\le |\\arg(z)| \\le 2\\pi/3 \\\\ 4 \\chi(n) \\exp(7 \\pi / (36 |\\operatorname{re}(\\zeta)|)) |\\cos(\\arg(\\zeta))|^{-n} & 2\\pi/3 \\le |\\arg(z)| < \\pi. \\end{cases}",
        "Chain(C, Piecewise(Mul(2, Call(exp; Div(7; Mul(36, Bars(\\zeta))))), Chain(Bars(Call(arg; z)), Div(\\pi; 3); \\le), Mul(2, Call(\\chi; n), Call(exp; Div(Mul(7, \\pi); Mul(72, Bars(\\zeta))))), Chain(Div(\\pi; 3), Bars(Call(arg; z)), Div(Mul(2, \\pi); 3); \\le, \\le), Mul(4, Call(\\chi; n), Call(exp; Div(Mul(7, \\pi); Mul(36, Bars(Call(\\text{re}; \\zeta))))), Pow(Bars(Call(cos; Call(arg; \\zeta))); Neg(n))), Chain(Div(Mul(2, \\pi); 3), Bars(Call(arg; z)), \\pi; \\le, <)); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "X(s) - \\frac{1}{s^2} = \\frac{1}{s} X(s) ,",
        "Chain(Add(Call(X; s), Neg(Div(1; Pow(s; 2)))), Mul(Div(1; s), Call(X; s)); =)",
        "jirilebl/diffyqs/ch-laplace.tex",
    ),
    (
        "T_{syn} = \\frac{2\\pi}{\\lvert n_f - n_i\\rvert}",
        "Chain(T_{syn}, Div(Mul(2, \\pi); Bars(Add(n_f, Neg(n_i)))); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/interplanetary-transfer-phasing.md",
    ),
    (
        "M_d \\dot{u} = f_d",
        "Chain(Mul(M_d, Call(\\dot{u})), f_d; =)",
        "sympy/sympy/sympy/physics/mechanics/system.py",
    ),
    (
        "u_1 = {}^A\\bar{\\omega}^B \\cdot \\hat{a}_x \\\\ u_2 = {}^A\\bar{\\omega}^B \\cdot \\hat{a}_y \\\\ u_3 = {}^A\\bar{\\omega}^B \\cdot \\hat{a}_z",
        "System(Chain(u_1, Mul(\\prescript { A } { } { \\bar { \\omega } } ^ { B }, \\hat{a}_x; 1); =), Chain(u_2, Mul(\\prescript { A } { } { \\bar { \\omega } } ^ { B }, \\hat{a}_y; 1); =), Chain(u_3, Mul(\\prescript { A } { } { \\bar { \\omega } } ^ { B }, \\hat{a}_z; 1); =))",
        "moorepants/learn-multibody-dynamics/motion.rst",
    ),
    (
        "\\mathbf{q} = \\begin{pmatrix}s & \\mathbf{v}\\end{pmatrix}^T",
        "Chain(\\mathbf{q}, Transpose(MatrixOf(s, \\mathbf{v})); =)",
        "Mayitzin/ahrs/ahrs/filters/fourati.py",
    ),
    (
        "\\tilde{\\bm F} = \\rho \\bm F &\\hspace{1cm} \\tilde{\\bm T} =\\rho \\bm T",
        "System(Chain(\\tilde{\\bm{F}}, Mul(\\rho, \\bm{F}); =), Chain(\\tilde{\\bm{T}}, Mul(\\rho, \\bm{T}); =))",
        "AVSLab/basilisk/src/simulation/dynamics/Thrusters/thrusterDynamicEffector/_Documentation/secTest.tex",
    ),
    (
        "|\\log(x+a) - \\log(x)| \\le \\log\\left(1 + \\frac{|a|}{x-|a|}\\right),",
        "Chain(Bars(Add(Call(log; Add(x, a)), Neg(Call(log; x)))), Call(log; Add(1, Div(Bars(a); Add(x, Neg(Bars(a)))))); \\le)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{R}(^L_G\\mathbf{q})\\,^G\\mathbf{g} &=& \\, ^L\\mathbf{a} \\\\ \\mathbf{R}(\\mathbf{q}_\\mathrm{acc})\\mathbf{R}(\\mathbf{q}_\\mathrm{mag}) \\begin{bmatrix}0 \\\\ 0 \\\\ 1\\end{bmatrix} &=& \\begin{bmatrix}a_x \\\\ a_y \\\\ a_z\\end{bmatrix} \\end{array}",
        "System(Chain(Mul(Call(\\mathbf{R}; \\prescript { L } { G } { \\mathbf { q } }), \\prescript { G } { } { \\mathbf { g } }), \\prescript { L } { } { \\mathbf { a } }; =), Chain(Mul(Call(\\mathbf{R}; \\mathbf{q}_{acc}), Call(\\mathbf{R}; \\mathbf{q}_{mag}), MatrixOf(0, 0, 1)), MatrixOf(a_x, a_y, a_z); =))",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "K = \\left[0.0733 + 0.923 \\left(\\frac{d}{rc}\\right)^{3.5} \\right] \\theta^{0.5}",
        "Chain(K, Mul(Add(0.0733, Mul(0.923, Pow(Div(d; Mul(r, c)); 3.5))), Pow(\\theta; 0.5)); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "^{\\mathbf{A}}\\mathbf{C}^{\\mathbf{B}} = (^{\\mathbf{B}}\\mathbf{C}^{\\mathbf{A}})^{-1}\\\\ = (^{\\mathbf{B}}\\mathbf{C}^{\\mathbf{A}})^T",
        "Chain(\\prescript { \\mathbf { A } } { } { \\mathbf { C } } ^ { \\mathbf { B } }, Pow(\\prescript { \\mathbf { B } } { } { \\mathbf { C } } ^ { \\mathbf { A } }; Neg(1)), Transpose(\\prescript { \\mathbf { B } } { } { \\mathbf { C } } ^ { \\mathbf { A } }); =, =)",
        "sympy/sympy/doc/src/explanation/modules/physics/vector/vectors/vectors.rst",
    ),
    (
        "\\left|\\frac{1}{b+k}\\right| \\le \\frac{1}{|b+n|}",
        "Chain(Bars(Div(1; Add(b, k))), Div(1; Bars(Add(b, n))); \\le)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "(\\tilde{F}^*_r)_P = {}^A\\tilde{v}_r^{P} \\cdot \\bar{R}^* \\\\ (\\tilde{F}^*_r)_B = {}^A\\tilde{v}_r^Q \\cdot \\bar{R}^* + {}^A\\tilde{\\omega}_r^B \\cdot \\bar{T}^*",
        "System(Chain(Marked(\\tilde { F } _ { r } ^ { * }; _{ P }), Mul(\\prescript { A } { } { \\tilde { v } } _ { r } ^ { P }, \\bar { R } ^ { * }; 1); =), Chain(Marked(\\tilde { F } _ { r } ^ { * }; _{ B }), Add(Mul(\\prescript { A } { } { \\tilde { v } } _ { r } ^ { Q }, \\bar { R } ^ { * }; 1), Mul(\\prescript { A } { } { \\tilde { \\omega } } _ { r } ^ { B }, \\bar { T } ^ { * }; 1)); =))",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "S(\\boldsymbol{q},t) = S_0(\\boldsymbol{q}',t)+S_1(q_1)",
        "Chain(Call(S; \\boldsymbol{q}, t), Add(Call(S_0; \\boldsymbol{q}', t), Call(S_1; q_1)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "F_d = \\frac{1}{2}\\rho C_dAv^2",
        "Chain(F_d, Mul(Div(1; 2), \\rho, C_d, A, Pow(v; 2)); =)",
        "moorepants/learn-multibody-dynamics/loads.rst",
    ),
    (
        "\\boldsymbol{V} = V \\boldsymbol{\\hat{u}}_V = \\sqrt{\\frac{\\mu_{\\text{sun}}}{R}} \\boldsymbol{\\hat{u}}_V",
        "Chain(\\boldsymbol{V}, Mul(V, \\boldsymbol{\\hat{u}}_V), Mul(Sqrt(Div(\\mu_{sun}; R)), \\boldsymbol{\\hat{u}}_V); =, =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-arrival-flyby.md",
    ),
    (
        "\\theta_3(z,\\tau) = \\sum_{n=-\\infty}^{\\infty} \\exp(\\pi i [n^2 \\tau + 2n z]) = 1 + 2 \\sum_{n=1}^{\\infty} q^{n^2} \\cos(2n \\pi z)",
        "Chain(Call(\\theta_3; z, \\tau), BigSum(n; Neg(Infinity()); Infinity(); Call(exp; Mul(\\pi, i, Add(Mul(Pow(n; 2), \\tau), Mul(2, n, z))))), Add(1, Mul(2, BigSum(n; 1; Infinity(); Mul(Pow(q; Pow(n; 2)), Call(cos; Mul(2, n, \\pi, z)))))); =, =)",
        "fredrik-johansson/arb/doc/source/acb_modular.rst",
    ),
    (
        "t \\theta(a,t) = \\epsilon(\\chi) \\theta\\left(\\frac1a, \\frac1t\\right)",
        "Chain(Mul(t, Call(\\theta; a, t)), Mul(Call(\\epsilon; \\chi), Call(\\theta; Div(1; a), Div(1; t))); =)",
        "fredrik-johansson/arb/doc/source/acb_dirichlet.rst",
    ),
    (
        "\\mu_\\mathtt{new} = \\frac{\\sigma_z^2\\bar\\mu + \\bar\\sigma^2z}{\\bar\\sigma^2+\\sigma_z^2}",
        "Chain(\\mu_{new}, Div(Add(Mul(Pow(\\sigma_z; 2), \\bar{\\mu}), Mul(Pow(\\bar{\\sigma}; 2), z)); Add(Pow(\\bar{\\sigma}; 2), Pow(\\sigma_z; 2))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_main.rst",
    ),
    (
        "\\begin{aligned} {}_I \\mathbf v_{Q} &= {}_I \\mathbf v_{B} + \\dot{\\mathbf C}_{I\\!B} \\cdot {}_B\\mathbf r_{B\\!Q} + \\mathbf C_{I\\!B} \\cdot {}_B\\dot{\\mathbf r}_{B\\!Q} \\\\ &= {}_I \\mathbf v_{B} + \\mathbf C_{I\\!B} \\cdot {}_B\\hat{\\mbox{\\boldmath $\\omega$}}_{I\\!B} \\cdot {}_B\\mathbf r_{B\\!Q} + \\mathbf C_{I\\!B} \\cdot {}_B\\dot{\\mathbf r}_{B\\!Q} \\\\ &= {}_I \\mathbf v_{B} - \\mathbf C_{I\\!B} \\cdot {}_B\\hat{\\mathbf r}_{B\\!Q} \\cdot {}_B\\mbox{\\boldmath $\\omega$}_{I\\!B} + \\mathbf C_{I\\!B} \\cdot {}_B\\dot{\\mathbf r}_{B\\!Q} \\\\ &= {}_I \\mathbf v_{B} - \\mathbf C_{I\\!B} \\cdot {}_B\\hat{\\mathbf r}_{B\\!Q} \\cdot {}_B\\mbox{\\boldmath $\\omega$}_{I\\!B} + \\mathbf C_{I\\!B} \\cdot {}_B \\mathbf J_{P_{q_j}}(\\mathbf q_j) \\cdot \\dot{\\mathbf q}_j \\\\ &= \\begin{bmatrix} \\mathds{1}_{3\\times 3} && -\\mathbf C_{I\\!B} \\cdot {}_B\\hat{\\mathbf r}_{B\\!Q} && \\mathbf C_{I\\!B} \\cdot {}_B \\mathbf J_{P_{q_j}}(\\mathbf q_j) \\end{bmatrix} \\cdot \\mathbf u \\end{aligned}",
        "Chain(\\prescript { } { I } { \\mathbf { v } } _ { Q }, Add(\\prescript { } { I } { \\mathbf { v } } _ { B }, Mul(Call(\\dot{\\mathbf{C}}_{I\\!B}), Call(\\prescript { } { B } { \\mathbf { r } } _ { B \\! Q })), Mul(Call(\\mathbf{C}_{I\\!B}), Call(\\prescript { } { B } { \\dot { \\mathbf { r } } } _ { B \\! Q }))), Add(\\prescript { } { I } { \\mathbf { v } } _ { B }, Mul(Call(\\mathbf{C}_{I\\!B}), \\prescript { } { B } { \\hat { \\boldsymbol { \\omega } } } _ { I \\! B }, Call(\\prescript { } { B } { \\mathbf { r } } _ { B \\! Q }); 2), Mul(Call(\\mathbf{C}_{I\\!B}), Call(\\prescript { } { B } { \\dot { \\mathbf { r } } } _ { B \\! Q }))), Add(\\prescript { } { I } { \\mathbf { v } } _ { B }, Neg(Mul(Call(\\mathbf{C}_{I\\!B}), \\prescript { } { B } { \\hat { \\mathbf { r } } } _ { B \\! Q }, \\prescript { } { B } { \\boldsymbol { \\omega } } _ { I \\! B }; 2)), Mul(Call(\\mathbf{C}_{I\\!B}), Call(\\prescript { } { B } { \\dot { \\mathbf { r } } } _ { B \\! Q }))), Add(\\prescript { } { I } { \\mathbf { v } } _ { B }, Neg(Mul(Call(\\mathbf{C}_{I\\!B}), \\prescript { } { B } { \\hat { \\mathbf { r } } } _ { B \\! Q }, \\prescript { } { B } { \\boldsymbol { \\omega } } _ { I \\! B }; 2)), Mul(Call(\\mathbf{C}_{I\\!B}), Call(\\prescript { } { B } { \\mathbf { J } } _ { P _ { q _ { j } } }; Call(\\mathbf{q}_j)), Call(\\dot{\\mathbf{q}}_j); 2)), Mul(MatrixOf(Marked(1; _{ 3 \\times 3 }), Blank(), Neg(Mul(Call(\\mathbf{C}_{I\\!B}), \\prescript { } { B } { \\hat { \\mathbf { r } } } _ { B \\! Q })), Blank(), Mul(Call(\\mathbf{C}_{I\\!B}), Call(\\prescript { } { B } { \\mathbf { J } } _ { P _ { q _ { j } } }; Call(\\mathbf{q}_j)))), \\mathbf{u}; 1); =, =, =, =, =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "y(x) = b_0 \\cosh (kx) + \\frac{b_1}{k} \\sinh (kx) .",
        "Chain(Call(y; x), Add(Mul(b_0, Call(cosh; Mul(k, x))), Mul(Div(b_1; k), Call(sinh; Mul(k, x)))); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "\\boldsymbol{\\theta} = \\alpha\\boldsymbol{\\theta}_\\omega + (1 - \\alpha)\\boldsymbol{\\theta}_{am}",
        "Chain(\\boldsymbol{\\theta}, Add(Mul(\\alpha, \\boldsymbol{\\theta}_\\omega), Mul(Add(1, Neg(\\alpha)), \\boldsymbol{\\theta}_{am})); =)",
        "Mayitzin/ahrs/ahrs/filters/complementary.py",
    ),
    (
        "\\frac{\\mathrm{d}}{\\mathrm{d} t}\\frac{\\partial P}{\\partial q_\\alpha'} - \\frac{\\partial P}{\\partial q_\\alpha} = 0\\quad (\\alpha=2,3,\\cdots,s)",
        "System(Chain(Add(Derivative(Derivative(Call(P); q'_{\\alpha}, 1; True); t, 1), Neg(Derivative(Call(P); q_{\\alpha}, 1; True))), 0; =), Values(\\alpha; 2, 3, Dots(), s))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "{\\bf B} ({\\bf q}) = \\begin{bmatrix} l_1 c_1 + l_2 c_{1+2} & l_1 s_1 + l_2 s_{1+2} \\\\ l_2 c_{1+2} & l_2 s_{1+2} \\end{bmatrix}.",
        "Chain(Call(\\mathbf{B}; \\mathbf{q}), MatrixOf(Add(Mul(l_1, c_1), Mul(l_2, c_{1+2})), Add(Mul(l_1, s_1), Mul(l_2, s_{1+2})), Mul(l_2, c_{1+2}), Mul(l_2, s_{1+2})); =)",
        "RussTedrake/underactuated/book/intro.html",
    ),
    (
        "\\boldsymbol{v} = \\boldsymbol{\\omega} \\times \\boldsymbol{r}",
        "Chain(\\boldsymbol{v}, Cross(\\boldsymbol{\\omega}; \\boldsymbol{r}); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "\\vec{c} = {(A +\\omega^2 I)}^{-1} (-\\vec{F} ).",
        "Chain(\\vec{c}, Mul(Pow(Add(A, Mul(Pow(\\omega; 2), I)); Neg(1)), Neg(\\vec{F})); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "U(k) = z \\; B(k, \\max(0, -s)) \\; B(k \\log(k), d)",
        "Chain(Call(U; k), Mul(z, Call(B; k, Call(max; 0, Neg(s))), Call(B; Mul(k, Call(log; k)), d)); =)",
        "fredrik-johansson/arb/doc/source/polylogarithms.rst",
    ),
    (
        "\\theta_{1+i}(z,\\tau) = \\exp(\\pi i R_i / 4) \\cdot A \\cdot B \\cdot \\theta_{1+S_i}(z',\\tau')",
        "Chain(Call(\\theta_{1+i}; z, \\tau), Mul(Call(exp; Div(Mul(\\pi, i, R_i); 4)), A, B, Call(\\theta_{1+S_i}; z', \\tau')); =)",
        "fredrik-johansson/arb/doc/source/acb_modular.rst",
    ),
    (
        "K_1 = K_{1,sharp} \\sqrt{\\sin \\frac{\\theta}{2}}",
        "Chain(K_1, Mul(K_{1,sharp}, Sqrt(Call(sin; Div(\\theta; 2)))); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "\\boldsymbol{M}_1^\\mathrm{T} \\boldsymbol{J} \\boldsymbol{M}_1 = \\boldsymbol{J},\\quad \\boldsymbol{M}_2^\\mathrm{T} \\boldsymbol{J} \\boldsymbol{M}_2 = \\boldsymbol{J}",
        "System(Chain(Mul(Transpose(\\boldsymbol{M}_1), \\boldsymbol{J}, \\boldsymbol{M}_1), \\boldsymbol{J}; =), Chain(Mul(Transpose(\\boldsymbol{M}_2), \\boldsymbol{J}, \\boldsymbol{M}_2), \\boldsymbol{J}; =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\dot{x}^* = \\dot{y}^* = \\dot{z}^* = 0 \\qquad \\text{and} \\qquad \\ddot{x}^* = \\ddot{y}^* = \\ddot{z}^* = 0",
        "System(Chain(Call(\\dot { x } ^ { * }), Call(\\dot { y } ^ { * }), Call(\\dot { z } ^ { * }), 0; =, =, =), Chain(Call(\\ddot { x } ^ { * }), Call(\\ddot { y } ^ { * }), Call(\\ddot { z } ^ { * }), 0; =, =, =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/lagrange-points.md",
    ),
    (
        "\\operatorname{Li}_{s}(z) = z \\Phi(z, s, 1).",
        "Chain(Call(\\text{Li}_s; z), Mul(z, Call(\\Phi; z, s, 1)); =)",
        "sympy/sympy/sympy/functions/special/zeta_functions.py",
    ),
    (
        "y^2 = -\\frac89 \\frac{\\omega_0^2 \\cos^2 \\lambda}{g} (z-h)^3",
        "Chain(Pow(y; 2), Neg(Mul(Div(8; 9), Div(Mul(Pow(\\omega_0; 2), Pow(Call(cos; \\lambda); 2)); g), Pow(Add(z, Neg(h)); 3))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter7.tex",
    ),
    (
        "x''(0) = 2a_2 = a_s",
        "Chain(Call(x''; 0), Mul(2, a_2), a_s; =, =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/quintic_polynomials_planner/quintic_polynomials_planner_main.rst",
    ),
    (
        "\\ddot{\\boldsymbol{r}} = \\ddot{\\boldsymbol{R}}_2 - \\ddot{\\boldsymbol{R}}_1",
        "Chain(Call(\\ddot{\\boldsymbol{r}}), Add(Call(\\ddot{\\boldsymbol{R}}_2), Neg(Call(\\ddot{\\boldsymbol{R}}_1))); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-relative-motion.md",
    ),
    (
        "\\breve{I}^{B/O} = I_{11} \\hat{b}_1 \\otimes \\hat{b}_1 + I_{22} \\hat{b}_2 \\otimes \\hat{b}_2 + I_{33} \\hat{b}_3 \\otimes \\hat{b}_3",
        "Chain(\\breve { I } ^ { B / O }, Add(Operated(\\otimes; Mul(I_{11}, \\hat{b}_1); \\hat{b}_1), Operated(\\otimes; Mul(I_{22}, \\hat{b}_2); \\hat{b}_2), Operated(\\otimes; Mul(I_{33}, \\hat{b}_3); \\hat{b}_3)); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "y' = \\frac{1}{x}, \\qquad y(0) = 0 .",
        "System(Chain(Call(y'), Div(1; x); =), Chain(Call(y; 0), 0; =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "dy/dx = f(x) y^2 + g(x) y + h(x)\\text{.}",
        "Chain(Derivative(Call(y); x, 1), Add(Mul(Call(f; x), Pow(Call(y); 2)), Mul(Call(g; x), Call(y)), Call(h; x)); =)",
        "sympy/sympy/sympy/solvers/ode/single.py",
    ),
    (
        "f(x) := \\frac{2d_1^{d_1/2} d_2^{d_2/2}} {\\mathrm{B}(d_1/2, d_2/2)} \\frac{e^{d_1z}}{\\left(d_1e^{2z}+d_2\\right)^{\\left(d_1+d_2\\right)/2}}",
        "Chain(Call(f; x), Mul(Div(Mul(2, Pow(d_1; Div(d_1; 2)), Pow(d_2; Div(d_2; 2))); Call(\\text{B}; Div(d_1; 2), Div(d_2; 2))), Div(Pow(e; Mul(d_1, z)); Pow(Add(Mul(d_1, Pow(e; Mul(2, z))), d_2); Div(Add(d_1, d_2); 2)))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "P = \\begin{pmatrix} 0 & 1 & 0 \\\\ 1 & 0 & 1 \\\\ 0 & -2 & -1 \\end{pmatrix}.",
        "Chain(P, MatrixOf(0, 1, 0, 1, 0, 1, 0, Neg(2), Neg(1)); =)",
        "sympy/sympy/doc/src/modules/physics/units/philosophy.rst",
    ),
    (
        "\\dot{\\bf q} &= {\\bf r}'(s)\\dot{s},\\\\ \\ddot{\\bf q}(t) &= {\\bf r}''(s) \\dot{s}^2 + {\\bf r}'(s)\\ddot{s}.",
        "System(Chain(Call(\\dot{\\mathbf{q}}), Mul(Call(\\mathbf{r}'; Call(s)), Call(\\dot{s})); =), Chain(Call(\\ddot{\\mathbf{q}}; t), Add(Mul(Call(\\mathbf{r}''; Call(s)), Pow(Call(\\dot{s}); 2)), Mul(Call(\\mathbf{r}'; Call(s)), Call(\\ddot{s}))); =))",
        "RussTedrake/manipulation/book/trajectories.html",
    ),
    (
        "x = \\varphi(y), \\int \\frac{1}{g(y) F(\\varphi(y),y)} \\,dy = t + C_2",
        "System(Chain(x, Call(\\varphi; y); =), Chain(Antiderivative(Div(1; Mul(Call(g; y), Call(F; Call(\\varphi; y), y))); y), Add(t, C_2); =))",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "\\log(2) = \\frac{3}{4} \\sum_{k=0}^{\\infty} \\frac{(-1)^k (k!)^2}{2^k (2k+1)!}",
        "Chain(Call(log; 2), Mul(Div(3; 4), BigSum(k; 0; Infinity(); Div(Mul(Pow(Neg(1); k), Pow(Factorial(k); 2)); Mul(Pow(2; k), Factorial(Add(Mul(2, k), 1)))))); =)",
        "fredrik-johansson/arb/doc/source/constants.rst",
    ),
    (
        "\\bm \\delta = h\\frac{\\left\\| \\sum_{i=1}^{13}\\text{CT}(i)\\bm k_i \\right\\|}{\\|\\bm x_n\\|}",
        "Chain(\\bm{\\delta}, Mul(h, Div(Norm(BigSum(i; 1; 13; Mul(Call(\\text{CT}; i), \\bm{k}_i))); Norm(\\bm{x}_n))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/Integrators/_Documentation/secModelDescription.tex",
    ),
    (
        "\\frac{{}_0F_1(a,z)}{\\Gamma(a)} = (-z)^{(1-a)/2} J_{a-1}(2 \\sqrt{-z}) = z^{(1-a)/2} I_{a-1}(2 \\sqrt{z}).",
        "Chain(Div(Call(\\prescript { } { 0 } { F } _ { 1 }; a, z); Call(Gamma; a)), Mul(Pow(Neg(z); Div(Add(1, Neg(a)); 2)), Call(J_{a-1}; Mul(2, Sqrt(Neg(z))))), Mul(Pow(z; Div(Add(1, Neg(a)); 2)), Call(I_{a-1}; Mul(2, Sqrt(z)))); =, =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "\\eta(s, a) = \\sum_{n=0}^\\infty \\frac{(-1)^n}{(n+a)^s}.",
        "Chain(Call(\\eta; s, a), BigSum(n; 0; Infinity(); Div(Pow(Neg(1); n); Pow(Add(n, a); s))); =)",
        "sympy/sympy/sympy/functions/special/zeta_functions.py",
    ),
    (
        "\\frac{dE}{dt} = 0 = \\frac{d\\mathrm{KE}}{dt} + \\frac{dV}{dt}",
        "Chain(Derivative(Call(E); t, 1), 0, Add(Derivative(Call(\\text{KE}); t, 1), Derivative(Call(V); t, 1)); =, =)",
        "bryanwweber/orbital-mechanics-notes/constants-of-orbital-motion/energy-is-conserved-in-orbital-motion.md",
    ),
    (
        "{}^AR^B \\: {}^BR^C = {}^AR^C.",
        "Chain(Mul(\\prescript { A } { } { R } ^ { B }, \\prescript { B } { } { R } ^ { C }), \\prescript { A } { } { R } ^ { C }; =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\mathbf{a} = \\sum_k \\mathbf{a}_k(\\mathbf{r})",
        "Chain(\\mathbf{a}, BigSum(k; Call(\\mathbf{a}_k; \\mathbf{r})); =)",
        "AVSLab/basilisk/src/simulation/mujocoDynamics/NBodyGravity/NBodyGravity.rst",
    ),
    (
        "a(x, y) \\frac{\\partial f(x, y)}{\\partial x} + b(x, y) \\frac{\\partial f(x, y)}{\\partial y} + c(x, y) f(x, y) = G(x, y)",
        "Chain(Add(Mul(Call(a; x, y), Derivative(Call(f; x, y); x, 1; True)), Mul(Call(b; x, y), Derivative(Call(f; x, y); y, 1; True)), Mul(Call(c; x, y), Call(f; x, y))), Call(G; x, y); =)",
        "sympy/sympy/sympy/solvers/pde.py",
    ),
    (
        "\\alpha = \\frac{v_{gs}}{v_{gs}\\left(1 + \\left(\\frac{v_{ls}}{v_{gs}} \\right)^{\\left(\\frac{\\rho_g}{\\rho_l}\\right)^{0.1}}\\right) + 2.9\\left[\\frac{gD\\sigma(1+\\cos\\theta)(\\rho_l-\\rho_g)} {\\rho_l^2}\\right]^{0.25}(1.22 + 1.22\\sin\\theta)^{\\frac{P}{P_{atm}}}}",
        "Chain(\\alpha, Div(v_{gs}; Add(Mul(v_{gs}, Add(1, Pow(Div(v_{ls}; v_{gs}); Pow(Div(\\rho_g; \\rho_l); 0.1)))), Mul(2.9, Pow(Div(Mul(g, D, \\sigma, Add(1, Call(cos; \\theta)), Add(\\rho_l, Neg(\\rho_g))); Pow(\\rho_l; 2)); 0.25), Pow(Add(1.22, Mul(1.22, Call(sin; \\theta))); Div(P; P_{atm}))))); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "\\zeta(-n,a) = -\\frac{B_{n+1}(a)}{n+1}",
        "Chain(Call(\\zeta; Neg(n), a), Neg(Div(Call(B_{n+1}; a); Add(n, 1))); =)",
        "sympy/sympy/sympy/functions/special/zeta_functions.py",
    ),
    (
        "\\varphi = -\\frac{1}{\\lambda} log(C_1 - \\lambda \\int \\frac{1}{g(y)} \\,dy)",
        "Chain(\\varphi, Neg(Mul(Div(1; \\lambda), Call(log; Add(C_1, Neg(Mul(\\lambda, Antiderivative(Div(1; Call(g; y)); y))))))); =)",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "\\alpha = \\arccos\\!\\left(\\hat{\\bf c}_B \\cdot \\hat{\\bf v}_{\\perp}\\right)",
        "Chain(\\alpha, Call(arccos; Mul(\\hat{\\mathbf{c}}_B, \\hat{\\mathbf{v}}_\\perp; 1)); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/locationPointing/locationPointing.rst",
    ),
    (
        "\\boldsymbol{B} = B_x\\boldsymbol{\\hat{\\imath}} + B_y\\boldsymbol{\\hat{\\jmath}} + B_z\\boldsymbol{\\hat{k}}",
        "Chain(\\boldsymbol{B}, Add(Mul(B_x, \\boldsymbol{\\hat{\\imath}}), Mul(B_y, \\boldsymbol{\\hat{\\jmath}}), Mul(B_z, \\boldsymbol{\\hat{k}})); =)",
        "bryanwweber/orbital-mechanics-notes/review/time-derivatives-of-moving-vectors.md",
    ),
    (
        "V = C\\sqrt{S R_h}",
        "Chain(V, Mul(C, Sqrt(Mul(S, R_h))); =)",
        "CalebBell/fluids/fluids/open_flow.py",
    ),
    (
        "\\gamma_2 = \\nu_{f,2} - \\nu_{i,2}",
        "Chain(\\gamma_2, Add(\\nu_{f,2}, Neg(\\nu_{i,2})); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/interplanetary-transfer-phasing.md",
    ),
    (
        "f(\\boldsymbol{r}_1,\\boldsymbol{r}_2,\\cdots,\\boldsymbol{r}_n,\\dot{\\boldsymbol{r}}_1,\\dot{\\boldsymbol{r}}_2,\\cdots,\\dot{\\boldsymbol{r}}_n,t) \\geqslant 0",
        "Chain(Call(f; Call(\\boldsymbol{r}_1), Call(\\boldsymbol{r}_2), Dots(), Call(\\boldsymbol{r}_n), Call(\\dot{\\boldsymbol{r}}_1), Call(\\dot{\\boldsymbol{r}}_2), Dots(), Call(\\dot{\\boldsymbol{r}}_n), t), 0; \\ge)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/analytical-mechanics/Constraint.tex",
    ),
    (
        "L(\\mathbf{A}) = \\frac{1}{2}\\sum_{i=1}^n a_i |\\hat{\\mathbf{W}}_i - \\mathbf{A}\\hat{\\mathbf{V}}_i|^2",
        "Chain(Call(L; \\mathbf{A}), Mul(Div(1; 2), BigSum(i; 1; n; Mul(a_i, Pow(Bars(Add(\\hat{\\mathbf{W}}_i, Neg(Mul(\\mathbf{A}, \\hat{\\mathbf{V}}_i)))); 2)))); =)",
        "Mayitzin/ahrs/ahrs/filters/quest.py",
    ),
    (
        "x+2x-y+y = 2+4, \\qquad \\text{or} \\qquad 3x = 6 .",
        "System(Chain(Add(x, Mul(2, x), Neg(y), y), Add(2, 4); =), Words(\\text{~or~}), Chain(Mul(3, x), 6; =))",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "\\bar{u}_r = -\\mathbf{M}_{hd}^{-1} \\bar{g}_{hd} \\in \\mathbb{R}^M",
        "Chain(\\bar{u}_r, Neg(Mul(Pow(\\mathbf{M}_{hd}; Neg(1)), \\bar{g}_{hd})), Pow(\\mathbb{R}; M); =, \\in)",
        "moorepants/learn-multibody-dynamics/holonomic-eom.rst",
    ),
    (
        "\\frac{-y}{x^2+y^2} dx + \\frac{x}{x^2+y^2} dy = 0 , \\qquad y(1) = 2.",
        "System(Chain(Add(Mul(Div(Neg(Call(y)); Add(Pow(x; 2), Pow(Call(y); 2))), Total(x)), Mul(Div(x; Add(Pow(x; 2), Pow(Call(y); 2))), Total(Call(y)))), 0; =), Chain(Call(y; 1), 2; =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "0 = \\min_{\\bf u} \\left[\\ell({\\bf x}, {\\bf u}) + \\frac{\\partial J^*}{\\partial {\\bf x}}f({\\bf x},{\\bf u}) + \\frac{\\partial J^*}{\\partial t} \\right].",
        "Chain(0, Limiting(min; _{ \\mathbf { u } }; Add(Call(\\ell; \\mathbf{x}, \\mathbf{u}), Mul(Derivative(Call(J ^ { * }); \\mathbf{x}, 1; True), Call(f; \\mathbf{x}, \\mathbf{u})), Derivative(Call(J ^ { * }); t, 1; True))); =)",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "m_{\\text{sc}}[\\tilde{\\bm{c}}]\\ddot{\\bm r}_{B/N}+[I_{\\text{sc},B}] \\dot{\\bm\\omega}_{\\cal B/N} + \\sum\\limits_{j=1}^{N_P}m_j [\\tilde{\\bm r}_{P_{c,j}/B}] \\hat{\\bm p}_j \\ddot{\\rho}_j = \\\\ -[\\bm{\\tilde{\\omega}}_{\\cal B/N}] [I_{\\text{sc},B}] \\bm\\omega_{\\cal B/N} - [I'_{\\text{sc},B}] \\bm\\omega_{\\cal B/N} - \\sum\\limits_{j=1}^{N_P} m_j [\\tilde{\\bm\\omega}_{\\cal B/N}] [\\tilde{\\bm{r}}_{P_{c,j}/B}] \\bm{r}'_{P_{c,j}/B} + \\bm{L}_B",
        "Chain(Add(Mul(m_{sc}, [ \\tilde { \\bm { c } } ], Call(\\ddot{\\bm{r}}_{B/N})), Mul([ I _ { \\text { s c } , B } ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N })), BigSum(j; 1; N_P; Mul(m_j, [ \\tilde { \\bm { r } } _ { P _ { c , j } / B } ], \\hat{\\bm{p}}_j, Call(\\ddot{\\rho}_j)))), Add(Neg(Mul([ \\bm { \\tilde { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ I _ { \\text { s c } , B } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}))), Neg(Mul([ I ' _ { \\text { s c } , B } ], Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}))), Neg(BigSum(j; 1; N_P; Mul(m_j, [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ \\tilde { \\bm { r } } _ { P _ { c , j } / B } ], \\bm{r}_{P_c,j/B}'))), \\bm{L}_B); =)",
        "AVSLab/basilisk/src/simulation/dynamics/LinearSpringMassDamper/_Documentation/secModelDescription.tex",
    ),
    (
        "R = \\begin{bmatrix} \\cos(\\theta) & \\sin(\\theta) & 0 \\\\ -\\sin(\\theta) & \\cos(\\theta) & 0 \\\\ 0 & 0 & 1 \\end{bmatrix}",
        "Chain(R, MatrixOf(Call(cos; \\theta), Call(sin; \\theta), 0, Neg(Call(sin; \\theta)), Call(cos; \\theta), 0, 0, 0, 1); =)",
        "sympy/sympy/sympy/matrices/dense.py",
    ),
    (
        "\\Phi_2 = 2 \\cos^{-1} \\left ( \\cos \\frac{\\Phi_{1a}}{2} \\cos \\frac{\\Phi_{1b}}{2} - \\sin \\frac{\\Phi_{1a}}{2} \\sin \\frac {\\Phi_{1b}}{2} \\ \\hat{\\boldsymbol{e}}_{1a} \\cdot \\hat{\\boldsymbol{e}}_{1b} \\right )",
        "Chain(\\Phi_2, Mul(2, Call(arccos; Add(Mul(Call(cos; Div(\\Phi_{1a}; 2)), Call(cos; Div(\\Phi_{1b}; 2))), Neg(Mul(Call(sin; Div(\\Phi_{1a}; 2)), Call(sin; Div(\\Phi_{1b}; 2)), \\hat{\\boldsymbol{e}}_{1a}, \\hat{\\boldsymbol{e}}_{1b}; 3))))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/prescribedRot2DOF/prescribedRot2DOF.rst",
    ),
    (
        "A_{\\text{circular sector}} = \\frac{r^2 \\phi}{2}",
        "Chain(A_{circular~sector}, Div(Mul(Pow(r; 2), \\phi); 2); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/hyperbolic-trajectories.md",
    ),
    (
        "\\dfrac{\\mathrm{d} \\boldsymbol{L}}{\\mathrm{d} t} & = \\sum_{i=1}^n \\left(\\dfrac{\\mathrm{d} \\boldsymbol{r}_i}{\\mathrm{d} t} - \\dfrac{\\mathrm{d} \\boldsymbol{r}_A}{\\mathrm{d} t}\\right)\\times \\boldsymbol{p}_i + \\sum_{i=1}^n (\\boldsymbol{r}_i - \\boldsymbol{r}_A) \\times \\dfrac{\\mathrm{d} \\boldsymbol{p}_i}{\\mathrm{d} t} \\\\ & = \\sum_{i=1}^n (\\boldsymbol{v}_i - \\boldsymbol{v}_A) \\times \\boldsymbol{p}_i + \\sum_{i=1}^n (\\boldsymbol{r}_i - \\boldsymbol{r}_A) \\times \\boldsymbol{F}_i",
        "Chain(Derivative(Call(\\boldsymbol{L}); t, 1), Add(BigSum(i; 1; n; Cross(Add(Derivative(Call(\\boldsymbol{r}_i); t, 1), Neg(Derivative(Call(\\boldsymbol{r}_A); t, 1))); Call(\\boldsymbol{p}_i))), BigSum(i; 1; n; Cross(Add(Call(\\boldsymbol{r}_i), Neg(Call(\\boldsymbol{r}_A))); Derivative(Call(\\boldsymbol{p}_i); t, 1)))), Add(BigSum(i; 1; n; Cross(Add(\\boldsymbol{v}_i, Neg(\\boldsymbol{v}_A)); Call(\\boldsymbol{p}_i))), BigSum(i; 1; n; Cross(Add(Call(\\boldsymbol{r}_i), Neg(Call(\\boldsymbol{r}_A))); \\boldsymbol{F}_i))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "\\hat{a}_x & = \\cos{\\theta} \\hat{n}_x + \\sin{\\theta} \\hat{n}_y + 0 \\hat{n}_z \\\\ \\hat{a}_y & = -\\sin{\\theta} \\hat{n}_x + \\cos{\\theta} \\hat{n}_y + 0 \\hat{n}_z \\\\ \\hat{a}_z & = 0 \\hat{n}_x + 0 \\hat{n}_y + 1 \\hat{n}_z",
        "System(Chain(\\hat{a}_x, Add(Mul(Call(cos; \\theta), \\hat{n}_x), Mul(Call(sin; \\theta), \\hat{n}_y), Mul(0, \\hat{n}_z)); =), Chain(\\hat{a}_y, Add(Neg(Mul(Call(sin; \\theta), \\hat{n}_x)), Mul(Call(cos; \\theta), \\hat{n}_y), Mul(0, \\hat{n}_z)); =), Chain(\\hat{a}_z, Add(Mul(0, \\hat{n}_x), Mul(0, \\hat{n}_y), Mul(1, \\hat{n}_z)); =))",
        "moorepants/learn-multibody-dynamics/orientation.rst",
    ),
    (
        "{\\bf M}({\\bf q})\\ddot{\\bf q} = \\begin{bmatrix} m & 0 & 0 \\\\ 0 & m & 0 \\\\ 0 & 0 & \\frac{2}{3}mr^2 \\end{bmatrix} \\ddot{\\bf q} = \\begin{bmatrix} 0 \\\\ -g \\\\ 0 \\end{bmatrix} + \\begin{bmatrix} 0 & 1 \\\\ 1 & 0 \\\\ 0 & r \\end{bmatrix} \\begin{bmatrix} \\lambda_z \\\\ \\lambda_x \\end{bmatrix} = \\tau_g + {\\bf J}^T {\\bf \\lambda},",
        "Chain(Mul(Call(\\mathbf{M}; Call(\\mathbf{q})), Call(\\ddot{\\mathbf{q}})), Mul(MatrixOf(m, 0, 0, 0, m, 0, 0, 0, Mul(Div(2; 3), m, Pow(r; 2))), Call(\\ddot{\\mathbf{q}})), Add(MatrixOf(0, Neg(g), 0), Mul(MatrixOf(0, 1, 1, 0, 0, r), MatrixOf(\\lambda_z, \\lambda_x))), Add(\\tau_g, Mul(Transpose(\\mathbf{J}), \\mathbf{\\lambda})); =, =, =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "R(\\theta) = \\begin{bmatrix} \\cos\\theta & -\\sin\\theta \\\\ \\sin\\theta & \\cos\\theta \\end{bmatrix}.",
        "Chain(Call(R; \\theta), MatrixOf(Call(cos; \\theta), Neg(Call(sin; \\theta)), Call(sin; \\theta), Call(cos; \\theta)); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\cos E = \\frac{e + \\cos\\nu}{1 + e\\cos\\nu}",
        "Chain(Call(cos; E), Div(Add(e, Call(cos; \\nu)); Add(1, Mul(e, Call(cos; \\nu)))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "\\Phi = \\arccos \\left( \\frac{\\bm h \\cdot \\hat{\\bm h}_{c} }{|\\bm h|} \\right)",
        "Chain(\\Phi, Call(arccos; Div(Mul(\\bm{h}, \\hat{\\bm{h}}_c; 1); Bars(\\bm{h}))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/opNavPoint/_Documentation/secModelDescription.tex",
    ),
    (
        "F = (\\mu_k f_n + (\\mu_s - \\mu_k) f_n e^{-(\\frac{v}{v_s})^2}) \\text{sign}(v) + \\sigma v",
        "Chain(F, Add(Mul(Add(Mul(\\mu_k, f_n), Mul(Add(\\mu_s, Neg(\\mu_k)), f_n, Pow(e; Neg(Pow(Div(v; v_s); 2))))), Call(sign; v)), Mul(\\sigma, v)); =)",
        "sympy/sympy/sympy/physics/mechanics/actuator.py",
    ),
    (
        "\\mathbf{q}_t \\leftarrow \\frac{1}{\\|\\mathbf{q}_t\\|}\\mathbf{q}_t",
        "Chain(\\mathbf{q}_t, Mul(Div(1; Norm(\\mathbf{q}_t)), \\mathbf{q}_t); \\leftarrow)",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "(A - \\lambda I)\\vec{v} = \\vec{0} .",
        "Chain(Mul(Add(A, Neg(Mul(\\lambda, I))), \\vec{v}), 0; =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\frac{dx}{dt} &= v \\cos\\theta \\\\ \\frac{dy}{dt} &= v \\sin\\theta \\\\ \\frac{d\\theta}{dt} &= \\omega",
        "System(Chain(Derivative(Call(x); t, 1), Mul(v, Call(cos; Call(\\theta))); =), Chain(Derivative(Call(y); t, 1), Mul(v, Call(sin; Call(\\theta))); =), Chain(Derivative(Call(\\theta); t, 1), \\omega; =))",
        "python-control/python-control/doc/iosys.rst",
    ),
    (
        "A(BC) & = (AB)C, \\\\ A(B+C) & = AB + AC, \\\\ (B+C)A & = BA + CA, \\\\ \\alpha(AB) & = (\\alpha A)B = A(\\alpha B), \\\\ IA & = A = AI .",
        "System(Chain(Mul(A, Mul(B, C)), Mul(Mul(A, B), C); =), Chain(Mul(A, Add(B, C)), Add(Mul(A, B), Mul(A, C)); =), Chain(Mul(Add(B, C), A), Add(Mul(B, A), Mul(C, A)); =), Chain(Mul(\\alpha, Mul(A, B)), Mul(Mul(\\alpha, A), B), Mul(A, Mul(\\alpha, B)); =, =), Chain(Mul(I, A), A, Mul(A, I); =, =))",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\ddot{\\xi} + 4\\omega_0^2 \\xi = 0",
        "Chain(Add(Call(\\ddot{\\xi}), Mul(4, Pow(\\omega_0; 2), Call(\\xi))), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter7.tex",
    ),
    (
        "\\dot{\\rho} = \\frac{x\\dot{x}+y\\dot{y}+z\\dot{z}}{\\sqrt{x^2 + y^2 + z^2}}",
        "Chain(Call(\\dot{\\rho}), Div(Add(Mul(Call(x), Call(\\dot{x})), Mul(Call(y), Call(\\dot{y})), Mul(Call(z), Call(\\dot{z}))); Sqrt(Add(Pow(Call(x); 2), Pow(Call(y); 2), Pow(Call(z); 2)))); =)",
        "AVSLab/basilisk/src/simulation/environment/stripLocation/stripLocation.rst",
    ),
    (
        "h(a, \\omega, t, b) = \\displaystyle a \\sin{\\left(\\omega \\right)} + \\frac{\\left|{f{\\left(t \\right)}}\\right|}{\\sqrt{b}}",
        "Chain(Call(h; a, \\omega, t, b), Add(Mul(a, Call(sin; \\omega)), Div(Bars(Call(f; t)); Sqrt(b))); =)",
        "moorepants/learn-multibody-dynamics/sympy.rst",
    ),
    (
        "\\left[\\mathbf{R_3(\\phi)}\\right] = \\begin{bmatrix}\\cos\\phi & \\sin\\phi & 0\\\\-\\sin\\phi & \\cos\\phi & 0\\\\0 & 0 & 1\\end{bmatrix}",
        "Chain(Call(\\mathbf{R}_3; \\phi), MatrixOf(Call(cos; \\phi), Call(sin; \\phi), 0, Neg(Call(sin; \\phi)), Call(cos; \\phi), 0, 0, 0, 1); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "2\\ddot{x} + \\ddot\\theta \\cos\\theta - \\dot\\theta^2 \\sin\\theta = f_x \\\\ \\ddot{x}\\cos\\theta + \\ddot\\theta + \\sin\\theta = 0.",
        "System(Chain(Add(Mul(2, Call(\\ddot{x})), Mul(Call(\\ddot{\\theta}), Call(cos; Call(\\theta))), Neg(Mul(Pow(Call(\\dot{\\theta}); 2), Call(sin; Call(\\theta))))), f_x; =), Chain(Add(Mul(Call(\\ddot{x}), Call(cos; Call(\\theta))), Call(\\ddot{\\theta}), Call(sin; Call(\\theta))), 0; =))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\bm{v}_{P1} &=\\bm{v}_{P} - \\bm{v}_{B/N} \\\\ \\bm{v}_{P2} &=\\bm{v}_{S} - \\bm{v}_{B/N} \\\\ \\bm{a}_{P1} &=\\bm{a}_{P} - \\bm{a}_{B/N} \\\\ \\bm{a}_{P2} &=\\bm{a}_{S} - \\bm{a}_{B/N}",
        "System(Chain(\\bm{v}_{P1}, Add(\\bm{v}_P, Neg(\\bm{v}_{B/N})); =), Chain(\\bm{v}_{P2}, Add(\\bm{v}_S, Neg(\\bm{v}_{B/N})); =), Chain(\\bm{a}_{P1}, Add(\\bm{a}_P, Neg(\\bm{a}_{B/N})); =), Chain(\\bm{a}_{P2}, Add(\\bm{a}_S, Neg(\\bm{a}_{B/N})); =))",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/celestialTwoBodyPoint/_Documentation/celestialTwoBodyPoint.tex",
    ),
    (
        "{}^A\\bar{\\omega}^Z = {}^A\\bar{\\omega}^B + {}^B\\bar{\\omega}^C + \\ldots + {}^Y\\bar{\\omega}^Z",
        "Chain(\\prescript { A } { } { \\bar { \\omega } } ^ { Z }, Add(\\prescript { A } { } { \\bar { \\omega } } ^ { B }, \\prescript { B } { } { \\bar { \\omega } } ^ { C }, Dots(), \\prescript { Y } { } { \\bar { \\omega } } ^ { Z }); =)",
        "moorepants/learn-multibody-dynamics/angular.rst",
    ),
    (
        "h_{s_{i}} = J_{s_{i}} (\\omega_{s_{i}} + \\Omega_{i})",
        "Chain(h_{s_i}, Mul(J_{s_i}, Add(\\omega_{s_i}, \\Omega_i)); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attControl/mrpSteering/mrpSteering.rst",
    ),
    (
        "K_{sharp} = \\left[1 + 0.8 f_{d,1}\\right] \\left\\{ \\left[1 - \\left( \\frac{D_1}{D_2}\\right)^2 \\right]^2 \\right\\}",
        "Chain(K_{sharp}, Mul(Add(1, Mul(0.8, f_{d,1})), Tuple(Pow(Add(1, Neg(Pow(Div(D_1; D_2); 2))); 2); {})); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "A + \\mathrm{tril}(U\\,V^\\mathrm{T}) + \\mathrm{triu}(V\\,U^\\mathrm{T}) &=& \\left[I + \\mathrm{tril} (U\\,W^T)\\right]\\,D\\, {\\left[I + \\mathrm{tril} (U\\,W^T)\\right]}^\\mathrm{T} \\\\ &=& D + \\mathrm{tril}(U\\,W^\\mathrm{T})\\,D + D\\,\\mathrm{triu}(W\\,U^\\mathrm{T}) \\\\ && +\\, \\mathrm{tril}(U\\,W^\\mathrm{T})\\,D\\,\\mathrm{triu}(W\\,U^\\mathrm{T})",
        "Chain(Add(A, Call(\\text{tril}; Mul(U, Transpose(V))), Call(\\text{triu}; Mul(V, Transpose(U)))), Mul(Add(I, Call(\\text{tril}; Mul(U, Transpose(W)))), D, Transpose(Add(I, Call(\\text{tril}; Mul(U, Transpose(W)))))), Add(D, Mul(Call(\\text{tril}; Mul(U, Transpose(W))), D), Mul(D, Call(\\text{triu}; Mul(W, Transpose(U)))), Mul(Call(\\text{tril}; Mul(U, Transpose(W))), D, Call(\\text{triu}; Mul(W, Transpose(U))))); =, =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "S_0(x) = \\sum_{k=0}^{\\infty} \\frac{H_k}{(k!)^2} \\left(\\frac{x}{2}\\right)^{2k}, \\quad I_0(x) = \\sum_{k=0}^{\\infty} \\frac{1}{(k!)^2} \\left(\\frac{x}{2}\\right)^{2k}",
        "System(Chain(Call(S_0; x), BigSum(k; 0; Infinity(); Mul(Div(H_k; Pow(Factorial(k); 2)), Pow(Div(x; 2); Mul(2, k)))); =), Chain(Call(I_0; x), BigSum(k; 0; Infinity(); Mul(Div(1; Pow(Factorial(k); 2)), Pow(Div(x; 2); Mul(2, k)))); =))",
        "fredrik-johansson/arb/doc/source/constants.rst",
    ),
    (
        "f(x) := \\frac{1}{\\pi x} \\frac{\\sigma}{(log(x)-\\mu^2) + \\sigma^2}",
        "Chain(Call(f; x), Mul(Div(1; Mul(\\pi, x)), Div(\\sigma; Add(Add(Call(log; x), Neg(Pow(\\mu; 2))), Pow(\\sigma; 2)))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "T_\\mathrm{Galaxy} = T_\\mathrm{Galaxy,table}(f) + T_\\mathrm{CMB}",
        "Chain(T_{Galaxy}, Add(Call(T_{Galaxy,table}; f), T_{CMB}); =)",
        "AVSLab/basilisk/src/simulation/communication/simpleAntenna/simpleAntenna.rst",
    ),
    (
        "\\lambda = \\sigma + \\mathbf{Z}^T \\frac{1}{(\\lambda+\\sigma)\\mathbf{I}-\\mathbf{S}}\\mathbf{Z}",
        "Chain(\\lambda, Add(\\sigma, Mul(Transpose(\\mathbf{Z}), Div(1; Add(Mul(Add(\\lambda, \\sigma), \\mathbf{I}), Neg(\\mathbf{S}))), \\mathbf{Z})); =)",
        "Mayitzin/ahrs/ahrs/filters/quest.py",
    ),
    (
        "\\frac{y'}{1+y^2} & = \\frac{1 - x^2}{x^2} , \\\\ \\frac{y'}{1+y^2} & = \\frac{1}{x^2} - 1 , \\\\ \\arctan (y) & = \\frac{-1}{x} - x + C , \\\\ y & = \\tan \\left(\\frac{-1}{x} - x + C\\right) .",
        "System(Chain(Div(y'; Add(1, Pow(y; 2))), Div(Add(1, Neg(Pow(x; 2))); Pow(x; 2)); =), Chain(Div(y'; Add(1, Pow(y; 2))), Add(Div(1; Pow(x; 2)), Neg(1)); =), Chain(Call(arctan; y), Add(Div(Neg(1); x), Neg(x), C); =), Chain(y, Call(tan; Add(Div(Neg(1); x), Neg(x), C)); =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\vec{x}_1 = \\frac{-\\alpha_2}{\\alpha_1} \\vec{x}_2 - \\frac{-\\alpha_3}{\\alpha_1} \\vec{x}_3 + \\cdots + \\frac{-\\alpha_n}{\\alpha_1} \\vec{x}_n .",
        "Chain(\\vec{x}_1, Add(Mul(Div(Neg(\\alpha_2); \\alpha_1), \\vec{x}_2), Neg(Mul(Div(Neg(\\alpha_3); \\alpha_1), \\vec{x}_3)), Dots(), Mul(Div(Neg(\\alpha_n); \\alpha_1), \\vec{x}_n)); =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "|R_n(z)| \\le C |u(n)| |\\zeta|^{-n}, \\quad |R'_n(z)| \\le C |v(n)| |\\zeta|^{-n}",
        "System(Chain(Bars(Call(R_n; z)), Mul(C, Bars(Call(u; n)), Pow(Bars(\\zeta); Neg(n))); \\le), Chain(Bars(Call(R_n'; z)), Mul(C, Bars(Call(v; n)), Pow(Bars(\\zeta); Neg(n))); \\le))",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "\\frac{m_l}{m_g}\\sqrt{\\rho_g/\\rho_l} = \\frac{(1-x)}{x}\\sqrt{\\rho_g/\\rho_l}",
        "Chain(Mul(Div(m_l; m_g), Sqrt(Div(\\rho_g; \\rho_l))), Mul(Div(Add(1, Neg(x)); x), Sqrt(Div(\\rho_g; \\rho_l))); =)",
        "CalebBell/fluids/fluids/separator.py",
    ),
    (
        "U(a,b,z) = \\frac{1}{\\Gamma(a)} \\int_0^{\\infty} e^{-zt} t^{a-1} (1+t)^{b-a-1} dt.",
        "Chain(Call(U; a, b, z), Mul(Div(1; Call(Gamma; a)), Integral(Mul(Pow(e; Neg(Mul(z, t))), Pow(t; Add(a, Neg(1))), Pow(Add(1, t); Add(b, Neg(a), Neg(1)))); t; 0; Infinity())); =)",
        "fredrik-johansson/arb/doc/source/arb_hypgeom.rst",
    ),
    (
        "\\dot{\\bm{r}}_{B/N,n} = \\dot{\\bm{r}}_{B/N,n-1} + \\frac{\\ddot{\\bm{r}}_{B/N,n-1}+\\ddot{\\bm{r}}_{B/N,n}}{2} \\Delta t",
        "Chain(Call(\\dot{\\bm{r}}_{B/N,n}), Add(Call(\\dot{\\bm{r}}_{B/N,n-1}), Mul(Div(Add(Call(\\ddot{\\bm{r}}_{B/N,n-1}), Call(\\ddot{\\bm{r}}_{B/N,n})); 2), \\Delta t)); =)",
        "AVSLab/basilisk/src/architecture/utilities/_Documentation/discretize/secTest.tex",
    ),
    (
        "\\breve{I}^{S/O} := \\sum_{i=1}^\\nu m_i \\left( \\left|\\bar{r}^{P_i/O}\\right|^2 \\breve{U} - \\bar{r}^{P_i/O} \\otimes \\bar{r}^{P_i/O} \\right)",
        "Chain(\\breve { I } ^ { S / O }, BigSum(i; 1; \\nu; Mul(m_i, Add(Mul(Pow(Bars(\\bar { r } ^ { P _ { i } / O }); 2), \\breve{U}), Neg(Operated(\\otimes; \\bar { r } ^ { P _ { i } / O }; \\bar { r } ^ { P _ { i } / O }))))); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "{\\vec{x}}'(t) = P(t)\\vec{x}(t) + \\vec{f}(t),",
        "Chain(Call(\\vec{x}'; t), Add(Mul(Call(P; t), Call(\\vec{x}; t)), Call(\\vec{f}; t)); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "y = C x^{1/2} .",
        "Chain(y, Mul(C, Pow(x; Div(1; 2))); =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "t_i = \\sqrt{(x_{i+1} - x_i)^2 + (y_{i+1} - y_i)^2}",
        "Chain(t_i, Sqrt(Add(Pow(Add(x_{i+1}, Neg(x_i)); 2), Pow(Add(y_{i+1}, Neg(y_i)); 2))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/catmull_rom_spline/catmull_rom_spline_main.rst",
    ),
    (
        "K = 0.70(1-\\alpha) + 4.9(1-\\alpha)^2",
        "Chain(K, Add(Mul(0.70, Add(1, Neg(\\alpha))), Mul(4.9, Pow(Add(1, Neg(\\alpha)); 2))); =)",
        "CalebBell/fluids/fluids/filters.py",
    ),
    (
        "\\dfrac{\\mathrm{d} \\boldsymbol{L}'}{\\mathrm{d} t} = \\boldsymbol{M}' = \\boldsymbol{r} \\times \\left(-V'(r) \\frac{\\boldsymbol{r}}{r}\\right) = \\boldsymbol{0}",
        "Chain(Derivative(Call(\\boldsymbol{L}'); t, 1), \\boldsymbol{M}', Cross(\\boldsymbol{r}; Neg(Mul(Call(V'; r), Div(\\boldsymbol{r}; r)))), 0; =, =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "\\|\\mathbf{q}\\| = \\sqrt{q_w^2 + q_x^2 + q_y^2 + q_z^2} = 1",
        "Chain(Norm(\\mathbf{q}), Sqrt(Add(Pow(q_w; 2), Pow(q_x; 2), Pow(q_y; 2), Pow(q_z; 2))), 1; =, =)",
        "Mayitzin/ahrs/ahrs/common/orientation.py",
    ),
    (
        "\\ddot{x} = u, \\quad |u| \\le 1.",
        "System(Chain(Call(\\ddot{x}), u; =), Chain(Bars(u), 1; \\le))",
        "RussTedrake/underactuated/book/intro.html",
    ),
    (
        "\\theta(t) = \\pm \\ddot{\\theta}_{\\text{max}} \\left( \\frac{(t - t_0)^4}{4 t_{\\text{smooth}}^2} - \\frac{(t - t_0)^5}{10 t_{\\text{smooth}}^3} \\right) + \\theta_0",
        "Chain(Call(\\theta; t), Add(PlusMinus(Mul(\\ddot { \\theta } _ { \\text { m a x } }, Add(Div(Pow(Add(t, Neg(t_0)); 4); Mul(4, Pow(t_{smooth}; 2))), Neg(Div(Pow(Add(t, Neg(t_0)); 5); Mul(10, Pow(t_{smooth}; 3))))))), \\theta_0); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedRotation1DOF/prescribedRotation1DOF.rst",
    ),
    (
        "u = -\\tau_g(q) + K_p(q_d-q) + K_d(\\dot{q}_d - \\dot{q}).",
        "Chain(u, Add(Neg(Call(\\tau_g; Call(q))), Mul(K_p, Add(Call(q_d), Neg(Call(q)))), Mul(K_d, Add(Call(\\dot{q}_d), Neg(Call(\\dot{q}))))); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "\\begin{bmatrix} \\dot{q}_1 \\\\ \\dot{q}_2 \\\\ \\dot{q}_3 \\end{bmatrix} = \\begin{bmatrix} u_1 \\\\ u_2 \\\\ u_3 \\end{bmatrix}",
        "Chain(MatrixOf(Call(\\dot{q}_1), Call(\\dot{q}_2), Call(\\dot{q}_3)), MatrixOf(u_1, u_2, u_3); =)",
        "moorepants/learn-multibody-dynamics/eom.rst",
    ),
    (
        "f_{n,j} &=& \\phi_{n,j}\\,\\left[f_{n-1,j} + \\tilde{W}_{n-1,j}\\, \\sqrt{D_{n-1,n-1}}\\,q_{n-1}\\right]\\\\ y_n &=& \\sqrt{D_{n,n}}\\,q_n + \\sum_{j=1}^{2\\,J} \\tilde{U}_{n,j}\\,f_{n,j}",
        "System(Chain(f_{n,j}, Mul(\\phi_{n,j}, Add(f_{n-1,j}, Mul(\\tilde{W}_{n-1,j}, Sqrt(D_{n-1,n-1}), q_{n-1}))); =), Chain(y_n, Add(Mul(Sqrt(D_{n,n}), q_n), BigSum(j; 1; Mul(2, J); Mul(\\tilde{U}_{n,j}, f_{n,j}))); =))",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\left[{}^AR^B\\right]^{-1} = {}^BR^A.",
        "Chain(Pow(\\prescript { A } { } { R } ^ { B }; Neg(1)), \\prescript { B } { } { R } ^ { A }; =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\mathrm{B}_{(x_1, x_2)}(a, b) = \\int_{x_1}^{x_2} t^{a - 1} (1 - t)^{b - 1} dt",
        "Chain(Call(\\text{B}_{(x_1,x_2)}; a, b), Integral(Mul(Pow(t; Add(a, Neg(1))), Pow(Add(1, Neg(t)); Add(b, Neg(1)))); t; x_1; x_2); =)",
        "sympy/sympy/sympy/functions/special/beta_functions.py",
    ),
    (
        "x = \\cos t + \\sin t + C e^{-t} ,",
        "Chain(x, Add(Call(cos; t), Call(sin; t), Mul(C, Pow(e; Neg(t)))); =)",
        "jirilebl/diffyqs/ch-intro.tex",
    ),
    (
        "\\frac{2 \\left(1 - \\pi_2\\right)}{\\sigma} + \\frac{2 \\pi_2}{\\psi} + \\left[\\left(1 - \\pi_2\\right)\\sigma^2 + \\pi_2 \\psi^2\\right] + 2J = 0",
        "Chain(Add(Div(Mul(2, Add(1, Neg(\\pi_2))); \\sigma), Div(Mul(2, \\pi_2); \\psi), Add(Mul(Add(1, Neg(\\pi_2)), Pow(\\sigma; 2)), Mul(\\pi_2, Pow(\\psi; 2))), Mul(2, J)), 0; =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/jacobi-constant.md",
    ),
    (
        "k_{ {\\boldsymbol{\\alpha}}}(\\tau_{nm}) = \\sigma_n^2\\,\\delta_{nm} + \\sum_{j=1}^J a_j\\,\\exp(-c_j\\,\\tau_{nm}) \\quad.",
        "Chain(Call(k_{\\boldsymbol\\alpha}; \\tau_{nm}), Add(Mul(Pow(\\sigma_n; 2), \\delta_{nm}), BigSum(j; 1; J; Mul(a_j, Call(exp; Neg(Mul(c_j, \\tau_{nm})))))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "r_1 = r_2 = r_{12}\\qquad \\text{and}\\qquad \\psi = \\sigma",
        "System(Chain(r_1, r_2, r_{12}; =, =), Chain(\\psi, \\sigma; =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/lagrange-points.md",
    ),
    (
        "\\langle f(t) , g(t) \\rangle = \\int_{a}^{b} f(t) g(t) \\, dt .",
        "Chain(Pair(Call(f; t); Call(g; t)), Integral(Mul(Call(f; t), Call(g; t)); t; a; b); =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "\\boldsymbol{L}_C = \\boldsymbol{r}_C\\times M\\boldsymbol{v}_C",
        "Chain(\\boldsymbol{L}_C, Cross(\\boldsymbol{r}_C; Mul(M, \\boldsymbol{v}_C)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "\\mathbf{K}\\hat{\\mathbf{q}} = \\lambda\\hat{\\mathbf{q}}",
        "Chain(Mul(\\mathbf{K}, \\hat{\\mathbf{q}}), Mul(\\lambda, \\hat{\\mathbf{q}}); =)",
        "Mayitzin/ahrs/ahrs/filters/davenport.py",
    ),
    (
        "\\xi_2 = 1.0\\left[1 -\\left(\\frac{d}{D_2}\\right)^2\\right]^2",
        "Chain(\\xi_2, Mul(1.0, Pow(Add(1, Neg(Pow(Div(d; D_2); 2))); 2)); =)",
        "CalebBell/fluids/fluids/control_valve.py",
    ),
    (
        "d(\\mathbf{R}_1, \\mathbf{R}_2) = \\|\\mathbf{I}-\\mathbf{R}_1\\mathbf{R}_2^T\\|_F",
        "Chain(Call(d; \\mathbf{R}_1, \\mathbf{R}_2), Marked(Norm(Add(\\mathbf{I}, Neg(Mul(\\mathbf{R}_1, Transpose(\\mathbf{R}_2))))); _{ F }); =)",
        "Mayitzin/ahrs/ahrs/utils/metrics.py",
    ),
    (
        "c = \\sqrt{kR_{specific}T}",
        "Chain(c, Sqrt(Mul(k, R_{specific}, T)); =)",
        "CalebBell/fluids/fluids/core.py",
    ),
    (
        "\\sigma_\\mathtt{new} = \\frac{\\sigma_z^2\\bar\\sigma^2}{\\bar\\sigma^2+\\sigma_z^2}",
        "Chain(\\sigma_{new}, Div(Mul(Pow(\\sigma_z; 2), Pow(\\bar{\\sigma}; 2)); Add(Pow(\\bar{\\sigma}; 2), Pow(\\sigma_z; 2))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_main.rst",
    ),
    (
        "u_{min} < u_t < u_{max}",
        "Chain(u_{min}, u_t, u_{max}; <, <)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/model_predictive_speed_and_steering_control/model_predictive_speed_and_steering_control_main.rst",
    ),
    (
        "D = 0",
        "Chain(D, 0; =)",
        "sympy/sympy/doc/src/tutorials/physics/control/mechanics_problems.rst",
    ),
    (
        "F_{\\text{odd}}(t) & \\overset{\\text{def}}{=} \\begin{cases} f(t) & \\text{if } \\; \\phantom{-}0 \\leq t \\leq L , \\\\ -f(-t) & \\text{if } \\; {-L} < t < 0 , \\end{cases} \\\\ F_{\\text{even}}(t) & \\overset{\\text{def}}{=} \\begin{cases} f(t) & \\text{if } \\; \\phantom{-}0 \\leq t \\leq L , \\\\ f(-t) & \\text{if } \\; {-L} < t < 0 . \\end{cases}",
        "System(Chain(Call(F_{odd}; t), Piecewise(Call(f; t), Chain(0, t, L; \\le, \\le), Neg(Call(f; Neg(t))), Chain(Neg(L), t, 0; <, <)); =), Chain(Call(F_{even}; t), Piecewise(Call(f; t), Chain(0, t, L; \\le, \\le), Call(f; Neg(t)), Chain(Neg(L), t, 0; <, <)); =))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\operatorname{Ei}(x) = \\int_{-\\infty}^x \\frac{e^t}{t} \\mathrm{d}t",
        "Chain(Call(\\text{Ei}; x), Integral(Div(Pow(e; t); t); t; Neg(Infinity()); x); =)",
        "sympy/sympy/sympy/functions/special/error_functions.py",
    ),
    (
        "\\boldsymbol{\\omega} = -\\dot{\\phi}\\boldsymbol{\\hat{\\imath}} + \\dot{\\Lambda}\\cos\\phi\\boldsymbol{\\hat{\\jmath}} + \\dot{\\Lambda}\\sin\\phi\\boldsymbol{\\hat{k}}",
        "Chain(\\boldsymbol{\\omega}, Add(Neg(Mul(Call(\\dot{\\phi}), \\boldsymbol{\\hat{\\imath}})), Mul(Call(\\dot{\\Lambda}), Call(cos; Call(\\phi)), \\boldsymbol{\\hat{\\jmath}}), Mul(Call(\\dot{\\Lambda}), Call(sin; Call(\\phi)), \\boldsymbol{\\hat{k}})); =)",
        "bryanwweber/orbital-mechanics-notes/reference/relative-motion.md",
    ),
    (
        "{\\bf x}[n+1] = {\\bf A}{\\bf x}[n] + {\\bf B}{\\bf u}[n],",
        "Chain(Indexed(\\mathbf{x}; Add(n, 1)), Add(Mul(\\mathbf{A}, Indexed(\\mathbf{x}; n)), Mul(\\mathbf{B}, Indexed(\\mathbf{u}; n))); =)",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "\\Big(m_{\\text{sc}} [I_{3\\times3}] +\\sum_{i=1}^{N}m_{\\text{sp}_i}d_i \\bm{\\hat{s}}_{i,3} \\bm a_{\\theta_i}^T\\Big)\\ddot{\\bm r}_{B/N}+\\Big(-m_{\\text{sc}} [\\tilde{\\bm{c}}] +\\sum_{i=1}^{N}m_{\\text{sp}_i}d_i \\bm{\\hat{s}}_{i,3} \\bm b_{\\theta_i}^T\\Big) \\dot{\\bm\\omega}_{\\cal B/N} \\\\ = m_{\\text{sc}} \\ddot{\\bm r}_{C/N} - 2 m_{\\text{sc}} [\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm c' -m_{\\text{sc}} [\\tilde{\\bm\\omega}_{\\cal B/N}][\\tilde{\\bm\\omega}_{\\cal B/N}]\\bm{c} -\\sum_{i=1}^{N}\\Big(m_{\\text{sp}_i}d_i \\dot{\\theta}_i^2 \\bm{\\hat{s}}_{i,1}+m_{\\text{sp}_i}d_i c_{\\theta_i} \\bm{\\hat{s}}_{i,3} \\Big)",
        "Chain(Add(Mul(Add(Mul(m_{sc}, [ I _ { 3 \\times 3 } ]), BigSum(i; 1; N; Mul(m_{sp_i}, d_i, \\bm{\\hat{s}}_{i3}, Transpose(\\bm{a}_{\\theta_i})))), Call(\\ddot{\\bm{r}}_{B/N})), Mul(Add(Neg(Mul(m_{sc}, [ \\tilde { \\bm { c } } ])), BigSum(i; 1; N; Mul(m_{sp_i}, d_i, \\bm{\\hat{s}}_{i3}, Transpose(\\bm{b}_{\\theta_i})))), Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }))), Add(Mul(m_{sc}, Call(\\ddot{\\bm{r}}_{C/N})), Neg(Mul(2, m_{sc}, [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{c}')), Neg(Mul(m_{sc}, [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{c})), Neg(BigSum(i; 1; N; Add(Mul(m_{sp_i}, d_i, Pow(Call(\\dot{\\theta}_i); 2), \\bm{\\hat{s}}_{i1}), Mul(m_{sp_i}, d_i, c_{\\theta_i}, \\bm{\\hat{s}}_{i3}))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/HingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\begin{cases} q = \\sqrt{\\dfrac{2E}{m\\omega^2}} \\sin (\\omega t + \\phi) \\\\[1.5ex] p = \\sqrt{2mE} \\cos(\\omega t+\\phi) \\end{cases}",
        "System(Chain(q, Mul(Sqrt(Div(Mul(2, E); Mul(m, Pow(\\omega; 2)))), Call(sin; Add(Mul(\\omega, t), \\phi))); =), Chain(p, Mul(Sqrt(Mul(2, m, E)), Call(cos; Add(Mul(\\omega, t), \\phi))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\Delta v = \\lVert\\Delta\\boldsymbol{v}\\rVert = \\sqrt{\\left(\\boldsymbol{v}_{A_t} - \\boldsymbol{v}_{A}\\right)\\cdot\\left(\\boldsymbol{v}_{A_t} - \\boldsymbol{v}_{A}\\right)}",
        "Chain(\\Delta v, Norm(\\Delta \\boldsymbol { v }), Sqrt(Mul(Add(\\boldsymbol{v}_{A_t}, Neg(\\boldsymbol{v}_A)), Add(\\boldsymbol{v}_{A_t}, Neg(\\boldsymbol{v}_A)); 1)); =, =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/non-hohmann-transfers.md",
    ),
    (
        "- 9 C_1 \\cos (3t) & = - C_1 \\cos (3t) + \\frac{2}{3} \\cos (3t) , \\\\ - 9 C_2 \\cos (3t) & = - 4 C_2 \\cos (3t) - \\frac{2}{3} \\cos (3t) .",
        "System(Chain(Neg(Mul(9, C_1, Call(cos; Mul(3, t)))), Add(Neg(Mul(C_1, Call(cos; Mul(3, t)))), Mul(Div(2; 3), Call(cos; Mul(3, t)))); =), Chain(Neg(Mul(9, C_2, Call(cos; Mul(3, t)))), Add(Neg(Mul(4, C_2, Call(cos; Mul(3, t)))), Neg(Mul(Div(2; 3), Call(cos; Mul(3, t))))); =))",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "C_{\\infty} = 0.5959 + 0.0312\\beta^{2.1} - 0.184\\beta^8 + \\frac{2.286\\beta^4}{(D_{mm}(1.0 - \\beta^4))} - \\frac{0.856\\beta^3}{D_{mm}}",
        "Chain(C_\\infty, Add(0.5959, Mul(0.0312, Pow(\\beta; 2.1)), Neg(Mul(0.184, Pow(\\beta; 8))), Div(Mul(2.286, Pow(\\beta; 4)); Mul(D_{mm}, Add(1.0, Neg(Pow(\\beta; 4))))), Neg(Div(Mul(0.856, Pow(\\beta; 3)); D_{mm}))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "\\mathrm{g}_p = \\mathrm{g}_0(\\beta=90°) = \\frac{GM}{a^2}\\Big(1+\\frac{me'q_0'}{3q_0}\\Big)",
        "Chain(\\text{g}_p, Call(\\text{g}_0; Chain(\\beta, Degrees(90); =)), Mul(Div(Mul(G, M); Pow(a; 2)), Add(1, Div(Mul(m, e', q_0'); Mul(3, q_0)))); =, =)",
        "Mayitzin/ahrs/ahrs/utils/wgs84.py",
    ),
    (
        "\\hat{u} = \\frac{\\bar{u}}{|\\bar{u}|}",
        "Chain(\\hat{u}, Div(\\bar{u}; Bars(\\bar{u})); =)",
        "moorepants/learn-multibody-dynamics/vectors.rst",
    ),
    (
        "T = \\frac{1}{2} \\left( f(N) + f(U) \\right) + \\sum_{k=1}^M \\frac{B_{2k}}{(2k)!} \\left(f^{(2k-1)}(U) - f^{(2k-1)}(N)\\right),",
        "Chain(T, Add(Mul(Div(1; 2), Add(Call(f; N), Call(f; U))), BigSum(k; 1; M; Mul(Div(B_{2k}; Factorial(Mul(2, k))), Add(Call(f ^ { ( 2 k - 1 ) }; U), Neg(Call(f ^ { ( 2 k - 1 ) }; N)))))); =)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "\\mathbf{F} = [D]^T([D][D]^T)^{-1}\\begin{bmatrix} \\boldsymbol{\\tau}_{req} \\\\ \\mathbf{F}_{req} \\end{bmatrix}",
        "Chain(\\mathbf{F}, Mul(Transpose([ D ]), Pow(Mul([ D ], Transpose([ D ])); Neg(1)), MatrixOf(\\boldsymbol{\\tau}_{req}, \\mathbf{F}_{req})); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/forceTorqueThrForceMapping/forceTorqueThrForceMapping.rst",
    ),
    (
        "y = \\left(\\tau \\alpha + \\frac{g\\tau}{v_0\\cos\\alpha}\\right) x g\\tau^2 \\ln \\left(1-\\frac{x}{v_0\\tau \\cos \\alpha}\\right)",
        "Chain(y, Mul(Add(Mul(\\tau, \\alpha), Div(Mul(g, \\tau); Mul(v_0, Call(cos; \\alpha)))), x, g, Pow(\\tau; 2), Call(ln; Add(1, Neg(Div(x; Mul(v_0, \\tau, Call(cos; \\alpha))))))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "J = \\int_0^\\infty \\left[ {\\bf x}^T {\\bf Q} {\\bf x} + {\\bf u}^T {\\bf R} {\\bf u} \\right] dt, \\quad {\\bf Q} = {\\bf Q}^T \\succeq {\\bf 0}, {\\bf R} = {\\bf R}^T \\succ 0.",
        "System(Chain(J, Integral(Add(Mul(Transpose(\\mathbf{x}), \\mathbf{Q}, \\mathbf{x}), Mul(Transpose(\\mathbf{u}), \\mathbf{R}, \\mathbf{u})); t; 0; Infinity()); =), Chain(\\mathbf{Q}, Transpose(\\mathbf{Q}), 0; =, \\succeq), Chain(\\mathbf{R}, Transpose(\\mathbf{R}), 0; =, \\succ))",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "^e\\mathbf{m} = \\mathbf{q}_e\\mathbf{q}_r \\,^b\\mathbf{m}\\mathbf{q}_r^{-1}\\mathbf{q}_e^{-1}",
        "Chain(\\prescript { e } { } { \\mathbf { m } }, Mul(\\mathbf{q}_e, \\mathbf{q}_r, \\prescript { b } { } { \\mathbf { m } }, Pow(\\mathbf{q}_r; Neg(1)), Pow(\\mathbf{q}_e; Neg(1))); =)",
        "Mayitzin/ahrs/ahrs/filters/fqa.py",
    ),
    (
        "f(x) := \\frac{\\beta^\\alpha}{\\Gamma(\\alpha)} x^{-\\alpha - 1} \\exp\\left(\\frac{-\\beta}{x}\\right)",
        "Chain(Call(f; x), Mul(Div(Pow(\\beta; \\alpha); Call(Gamma; \\alpha)), Pow(x; Add(Neg(\\alpha), Neg(1))), Call(exp; Div(Neg(\\beta); x))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "\\mathbf{R}(\\mathbf{q}) = \\begin{bmatrix} 1 - 2(q_y^2 + q_z^2) & 2(q_xq_y - q_wq_z) & 2(q_xq_z + q_wq_y) \\\\ 2(q_xq_y + q_wq_z) & 1 - 2(q_x^2 + q_z^2) & 2(q_yq_z - q_wq_x) \\\\ 2(q_xq_z - q_wq_y) & 2(q_wq_x + q_yq_z) & 1 - 2(q_x^2 + q_y^2) \\end{bmatrix}",
        "Chain(Call(\\mathbf{R}; \\mathbf{q}), MatrixOf(Add(1, Neg(Mul(2, Add(Pow(q_y; 2), Pow(q_z; 2))))), Mul(2, Add(Mul(q_x, q_y), Neg(Mul(q_w, q_z)))), Mul(2, Add(Mul(q_x, q_z), Mul(q_w, q_y))), Mul(2, Add(Mul(q_x, q_y), Mul(q_w, q_z))), Add(1, Neg(Mul(2, Add(Pow(q_x; 2), Pow(q_z; 2))))), Mul(2, Add(Mul(q_y, q_z), Neg(Mul(q_w, q_x)))), Mul(2, Add(Mul(q_x, q_z), Neg(Mul(q_w, q_y)))), Mul(2, Add(Mul(q_w, q_x), Mul(q_y, q_z))), Add(1, Neg(Mul(2, Add(Pow(q_x; 2), Pow(q_y; 2)))))); =)",
        "Mayitzin/ahrs/ahrs/common/dcm.py",
    ),
    (
        "\\mathbf{q} = \\frac{1}{\\sqrt{q_w^2+q_x^2+q_y^2+q_z^2}}\\begin{pmatrix}q_w & q_x & q_y & q_z\\end{pmatrix}",
        "Chain(\\mathbf{q}, Mul(Div(1; Sqrt(Add(Pow(q_w; 2), Pow(q_x; 2), Pow(q_y; 2), Pow(q_z; 2)))), MatrixOf(q_w, q_x, q_y, q_z)); =)",
        "Mayitzin/ahrs/ahrs/filters/saam.py",
    ),
    (
        "\\frac{v^2}{2} - \\frac{\\mu}{r} = \\frac{\\mu}{2a}",
        "Chain(Add(Div(Pow(v; 2); 2), Neg(Div(\\mu; r))), Div(\\mu; Mul(2, a)); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/hyperbolic-trajectories.md",
    ),
    (
        "\\frac{\\mathrm{d}}{\\mathrm{d} t} \\frac{\\partial L}{\\partial \\dot{q}_\\alpha} - \\frac{\\partial L}{\\partial q_\\alpha} + \\frac{\\partial D}{\\partial \\dot{q}_\\alpha} = 0,\\quad \\alpha=1,2,\\cdots,s",
        "System(Chain(Add(Derivative(Derivative(Call(L); \\dot{q}_{\\alpha}, 1; True); t, 1), Neg(Derivative(Call(L); q_{\\alpha}, 1; True)), Derivative(Call(D); \\dot{q}_{\\alpha}, 1; True)), 0; =), Values(\\alpha; 1, 2, Dots(), s))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter5.tex",
    ),
    (
        "\\boldsymbol{n}_\\varSigma = \\frac{\\dfrac{\\partial \\boldsymbol{\\varSigma}}{\\partial r} \\times \\dfrac{\\partial \\boldsymbol{\\varSigma}}{\\partial \\phi}}{\\left|\\dfrac{\\partial \\boldsymbol{\\varSigma}}{\\partial r} \\times \\dfrac{\\partial \\boldsymbol{\\varSigma}}{\\partial \\phi}\\right|} = \\frac{1}{\\sqrt{a^2+\\big[(f'(r))^2+1\\big] r^2}} \\begin{pmatrix} a\\sin\\phi-rf'(r)\\cos\\phi \\\\ -a\\cos\\phi-rf'(r)\\sin\\phi \\\\ r \\end{pmatrix}",
        "Chain(\\boldsymbol{n}_\\varSigma, Div(Cross(Derivative(Call(\\boldsymbol{\\varSigma}); r, 1; True); Derivative(Call(\\boldsymbol{\\varSigma}); \\phi, 1; True)); Bars(Cross(Derivative(Call(\\boldsymbol{\\varSigma}); r, 1; True); Derivative(Call(\\boldsymbol{\\varSigma}); \\phi, 1; True)))), Mul(Div(1; Sqrt(Add(Pow(a; 2), Mul(Add(Pow(Call(f'; r); 2), 1), Pow(r; 2))))), MatrixOf(Add(Mul(a, Call(sin; \\phi)), Neg(Mul(r, Call(f'; r), Call(cos; \\phi)))), Add(Neg(Mul(a, Call(cos; \\phi))), Neg(Mul(r, Call(f'; r), Call(sin; \\phi)))), r)); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise2.tex",
    ),
    (
        "\\hat{h}_h = \\frac{r \\times v}{|r \\times v|}",
        "Chain(\\hat{h}_h, Div(Cross(r; v); Bars(Cross(r; v))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/hillStateConverter/hillStateConverter.rst",
    ),
    (
        "I_1\\dot{\\omega}_1 = 0",
        "Chain(Mul(I_1, Call(\\dot{\\omega}_1)), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "m l^2 \\ddot\\theta(t) + mgl\\sin{\\theta(t)} = Q.",
        "Chain(Add(Mul(m, Pow(l; 2), Call(\\ddot{\\theta}; t)), Mul(m, g, l, Call(sin; Call(\\theta; t)))), Q; =)",
        "RussTedrake/underactuated/book/pend.html",
    ),
    (
        "\\dot{x_1}(t) = -\\frac{2x_1(t)}{RC} + \\frac{x_2(t)}{RC} + \\frac{u(t)}{RC}",
        "Chain(Call(\\dot{x}_1; t), Add(Neg(Div(Mul(2, Call(x_1; t)); Mul(R, C))), Div(Call(x_2; t); Mul(R, C)), Div(Call(u; t); Mul(R, C))); =)",
        "sympy/sympy/doc/src/tutorials/physics/control/electrical_problems.rst",
    ),
    (
        "f'(\\chi) = \\frac{r_0v_{r,0}}{\\sqrt{\\mu}} \\chi\\left(1 - z S(z)\\right) + \\left(1 - \\alpha r_0\\right) \\chi^2 C(z) + r_0",
        "Chain(Call(f'; \\chi), Add(Mul(Div(Mul(r_0, v_{r,0}); Sqrt(\\mu)), \\chi, Add(1, Neg(Mul(z, Call(S; z))))), Mul(Add(1, Neg(Mul(\\alpha, r_0))), Pow(\\chi; 2), Call(C; z)), r_0); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables-example.md",
    ),
    (
        "m\\ddot{x} =& \\sum_i f^{B_i}_{W_x} = f^A_{net,W_x},\\\\ m\\ddot{z} =& \\sum_i f^{B_i}_{W_z} - mg = f^A_{net,W_z} - mg,\\\\ I\\ddot\\theta =& \\sum_i \\left[ {}^Bp^{B_i}_W \\times f^{B_i}_W \\right]_y = [{}^Bp^A_W \\times f^A_{net,W}]_y + \\tau^A_{net,W},",
        "System(Chain(Mul(m, Call(\\ddot{x})), BigSum(i; f _ { W _ { x } } ^ { B _ { i } }), f _ { n e t , W _ { x } } ^ { A }; =, =), Chain(Mul(m, Call(\\ddot{z})), Add(BigSum(i; f _ { W _ { z } } ^ { B _ { i } }), Neg(Mul(m, g))), Add(f _ { n e t , W _ { z } } ^ { A }, Neg(Mul(m, g))); =, =), Chain(Mul(I, Call(\\ddot{\\theta})), BigSum(i; Marked(Cross(\\prescript { B } { } { p } _ { W } ^ { B _ { i } }; f _ { W } ^ { B _ { i } }); _{ y })), Add(Marked(Cross(\\prescript { B } { } { p } _ { W } ^ { A }; f _ { n e t , W } ^ { A }); _{ y }), \\tau _ { n e t , W } ^ { A }); =, =))",
        "RussTedrake/underactuated/book/humanoids.html",
    ),
    (
        "\\dot{\\tilde{E}} = - k \\dot\\theta^2 \\tilde{E}.",
        "Chain(Call(\\dot{\\tilde{E}}), Neg(Mul(k, Pow(Call(\\dot{\\theta}); 2), Call(\\tilde{E}))); =)",
        "RussTedrake/underactuated/book/pend.html",
    ),
    (
        "\\dot{x} = vcos(\\phi)",
        "Chain(Call(\\dot{x}), Mul(v, Call(cos; \\phi)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/model_predictive_speed_and_steering_control/model_predictive_speed_and_steering_control_main.rst",
    ),
    (
        "\\dot{q}=4\\sin^3{\\theta^*}\\cos{\\theta^*}\\dot{\\theta^*},",
        "Chain(Call(\\dot{q}), Mul(4, Pow(Call(sin; Call(\\theta ^ { * })); 3), Call(cos; Call(\\theta ^ { * })), Call(\\dot { \\theta } ^ { * })); =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "x^2y' = y^2+xy, \\qquad y(1)=1.",
        "System(Chain(Mul(Pow(x; 2), Call(y')), Add(Pow(Call(y); 2), Mul(x, Call(y))); =), Chain(Call(y; 1), 1; =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\phi \\sqrt{h^2+r^2} = \\psi r",
        "Chain(Mul(\\phi, Sqrt(Add(Pow(h; 2), Pow(r; 2)))), Mul(\\psi, r); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "\\frac{\\partial k_2}{\\partial J} = -\\frac{\\pi k_2^2}{4\\omega_0K(k_2)}",
        "Chain(Derivative(Call(k_2); J, 1; True), Neg(Div(Mul(\\pi, Pow(Call(k_2); 2)); Mul(4, \\omega_0, Call(K; Call(k_2))))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\operatorname{E}(s, a) = -\\frac{\\operatorname{G}(s+1, a)}{s+1}",
        "Chain(Call(\\text{E}; s, a), Neg(Div(Call(\\text{G}; Add(s, 1), a); Add(s, 1))); =)",
        "sympy/sympy/sympy/functions/combinatorial/numbers.py",
    ),
    (
        "V_3 = \\int_w^g(r^2 - x^2)\\tan^{-1}\\frac{\\sqrt{g^2 - x^2}}{z}dx - \\frac{z}{2}\\left(g^2\\cos^{-1}\\frac{w}{g} - w\\sqrt{2g(h-h_1) - (h-h_1)^2}\\right)",
        "Chain(V_3, Add(Integral(Mul(Add(Pow(r; 2), Neg(Pow(x; 2))), Call(arctan; Div(Sqrt(Add(Pow(g; 2), Neg(Pow(x; 2)))); z))); x; w; g), Neg(Mul(Div(z; 2), Add(Mul(Pow(g; 2), Call(arccos; Div(w; g))), Neg(Mul(w, Sqrt(Add(Mul(2, g, Add(h, Neg(h_1))), Neg(Pow(Add(h, Neg(h_1)); 2)))))))))); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "(F_r^*)_B := {}^A\\bar{v}^{B_o}_r \\cdot \\bar{R}^* + {}^A\\bar{\\omega}^B_r \\cdot \\bar{T}^*",
        "Chain(Marked(F _ { r } ^ { * }; _{ B }), Add(Mul(\\prescript { A } { } { \\bar { v } } _ { r } ^ { B _ { o } }, \\bar { R } ^ { * }; 1), Mul(\\prescript { A } { } { \\bar { \\omega } } _ { r } ^ { B }, \\bar { T } ^ { * }; 1)); =)",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "\\bm v_{\\text{rot,contr}} = U_{s_i}\\Omega_i^2[\\tilde{\\bm{r}}_{W_i/B}]\\hat{\\bm{u}}_i + U_{d_i}\\Omega_i^2\\hat{\\bm{v}}",
        "Chain(\\bm{v}_{rot,contr}, Add(Mul(U_{s_i}, Pow(\\Omega_i; 2), [ \\tilde { \\bm { r } } _ { W _ { i } / B } ], \\hat{\\bm{u}}_i), Mul(U_{d_i}, Pow(\\Omega_i; 2), \\hat{\\bm{v}})); =)",
        "AVSLab/basilisk/src/simulation/dynamics/reactionWheels/_Documentation/secModelDescription.tex",
    ),
    (
        "\\sigma' = \\begin{cases} \\sigma & \\text{if } R \\ne 3 \\\\ \\nu \\sigma & \\text{if } R = 3 \\end{cases}",
        "Chain(\\sigma', Piecewise(\\sigma, Chain(R, 3; \\ne), Mul(\\nu, \\sigma), Chain(R, 3; =)); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "^E\\mathbf{h}_t = \\begin{bmatrix}0 & h_x & h_y & h_z\\end{bmatrix} = \\,\\mathbf{q}_{t-1}\\,^S\\mathbf{m}_t\\,\\mathbf{q}_{t-1}^*",
        "Chain(\\prescript { E } { } { \\mathbf { h } } _ { t }, MatrixOf(0, h_x, h_y, h_z), Mul(\\mathbf{q}_{t-1}, \\prescript { S } { } { \\mathbf { m } } _ { t }, \\mathbf { q } _ { t - 1 } ^ { * }); =, =)",
        "Mayitzin/ahrs/ahrs/filters/madgwick.py",
    ),
    (
        "x(t) = \\int_0^t \\frac{\\sin (\\omega_0 \\tau)}{\\omega_0} f(t-\\tau) \\, d\\tau ,",
        "Chain(Call(x; t), Integral(Mul(Div(Call(sin; Mul(\\omega_0, \\tau)); \\omega_0), Call(f; Add(t, Neg(\\tau)))); \\tau; 0; t); =)",
        "jirilebl/diffyqs/ch-laplace.tex",
    ),
    (
        "\\mathbf{q} = \\begin{pmatrix}q_w\\\\q_x\\\\q_y\\\\q_z\\end{pmatrix} = \\begin{pmatrix}-1\\\\\\chi\\\\\\rho\\\\\\upsilon\\end{pmatrix}",
        "Chain(\\mathbf{q}, MatrixOf(q_w, q_x, q_y, q_z), MatrixOf(Neg(1), \\chi, \\rho, \\upsilon); =, =)",
        "Mayitzin/ahrs/ahrs/filters/flae.py",
    ),
    (
        "f(x) := b \\eta e^{b x} e^{\\eta} \\exp \\left(-\\eta e^{bx} \\right)",
        "Chain(Call(f; x), Mul(b, \\eta, Pow(e; Mul(b, x)), Pow(e; \\eta), Call(exp; Neg(Mul(\\eta, Pow(e; Mul(b, x)))))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "\\begin{bmatrix} x_{1} \\\\ x_2 \\\\ \\vdots \\\\ x_n \\end{bmatrix} + \\begin{bmatrix} y_{1} \\\\ y_2 \\\\ \\vdots \\\\ y_n \\end{bmatrix} = \\begin{bmatrix} x_1 + y_{1} \\\\ x_2+ y_2 \\\\ \\vdots \\\\ x_n + y_n \\end{bmatrix} .",
        "Chain(Add(MatrixOf(x_1, x_2, Dots(), x_n), MatrixOf(y_1, y_2, Dots(), y_n)), MatrixOf(Add(x_1, y_1), Add(x_2, y_2), Dots(), Add(x_n, y_n)); =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "\\ddot{\\boldsymbol{r}} = \\boldsymbol{a}_{\\mathrm{COG}} + \\dot{\\boldsymbol{\\Omega}}\\times\\boldsymbol{r} + \\boldsymbol{\\Omega}\\times\\left(\\boldsymbol{\\Omega}\\times\\boldsymbol{r}\\right) + 2\\boldsymbol{\\Omega}\\times\\boldsymbol{v}_{\\text{rel}} + \\boldsymbol{a}_{\\text{rel}}",
        "Chain(Call(\\ddot{\\boldsymbol{r}}), Add(\\boldsymbol{a}_{COG}, Cross(Call(\\dot{\\boldsymbol{\\Omega}}); Call(\\boldsymbol{r})), Cross(Call(\\boldsymbol{\\Omega}); Cross(Call(\\boldsymbol{\\Omega}); Call(\\boldsymbol{r}))), Cross(Mul(2, Call(\\boldsymbol{\\Omega})); \\boldsymbol{v}_{rel}), \\boldsymbol{a}_{rel}); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "\\bm x_{n+1} = \\bm x_{n} + \\frac{h}{6} \\left( \\bm k_{1} + 2 \\bm k_{2} + 2 \\bm k_{3} + \\bm k_{4} \\right)",
        "Chain(\\bm{x}_{n+1}, Add(\\bm{x}_n, Mul(Div(h; 6), Add(\\bm{k}_1, Mul(2, \\bm{k}_2), Mul(2, \\bm{k}_3), \\bm{k}_4))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/Integrators/_Documentation/secModelDescription.tex",
    ),
    (
        "k_j(\\tau_{nm}) = a_j\\,\\exp\\left(-c_j\\,\\tau_{nm}\\right)",
        "Chain(Call(k_j; \\tau_{nm}), Mul(a_j, Call(exp; Neg(Mul(c_j, \\tau_{nm})))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\text{SA} = 2\\pi f D h",
        "Chain(\\text{SA}, Mul(2, \\pi, f, D, h); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\dot{y} = v \\sin(\\phi)",
        "Chain(Call(\\dot{y}), Mul(v, Call(sin; \\phi)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/ensamble_kalman_filter_localization_files/ensamble_kalman_filter_localization_main.rst",
    ),
    (
        "\\mathbf{P}_{\\Sigma D} = \\mathbf{U}_{D_x}\\mathbf{P}_1 + \\mathbf{U}_{D_y}\\mathbf{P}_2 + \\mathbf{U}_{D_z}\\mathbf{P}_3",
        "Chain(\\mathbf{P}_{\\Sigma D}, Add(Mul(\\mathbf{U}_{D_x}, \\mathbf{P}_1), Mul(\\mathbf{U}_{D_y}, \\mathbf{P}_2), Mul(\\mathbf{U}_{D_z}, \\mathbf{P}_3)); =)",
        "Mayitzin/ahrs/ahrs/filters/flae.py",
    ),
    (
        "z_p = \\frac{| \\bar{r}^{P/O} \\cdot \\hat{n}_z | - \\bar{r}^{P/O} \\cdot \\hat{n}_z}{2}",
        "Chain(z_p, Div(Add(Bars(Mul(\\bar { r } ^ { P / O }, \\hat{n}_z; 1)), Neg(Mul(\\bar { r } ^ { P / O }, \\hat{n}_z; 1))); 2); =)",
        "moorepants/learn-multibody-dynamics/loads.rst",
    ),
    (
        "f(r) = \\int_{0}^\\infty F_\\nu(k) J_\\nu(k r) k \\mathrm{d} k.",
        "Chain(Call(f; r), Integral(Mul(Call(F_\\nu; k), Call(J_\\nu; Mul(k, r)), k); k; 0; Infinity()); =)",
        "sympy/sympy/sympy/integrals/transforms.py",
    ),
    (
        "\\sum_{k=K}^{\\infty} |x|^k \\frac{|(s)_k|}{k!} \\zeta(\\sigma+k,a) \\le \\sum_{k=K}^{\\infty} |x|^k \\frac{|(s)_k|}{k!} \\left[ \\frac{1}{a^{\\sigma+k}} + \\frac{1}{(\\sigma+k-1) a^{\\sigma+k-1}} \\right].",
        "Chain(BigSum(k; K; Infinity(); Mul(Pow(Bars(x); k), Div(Bars(Marked(s; _{ k })); Factorial(k)), Call(\\zeta; Add(\\sigma, k), a))), BigSum(k; K; Infinity(); Mul(Pow(Bars(x); k), Div(Bars(Marked(s; _{ k })); Factorial(k)), Add(Div(1; Pow(a; Add(\\sigma, k))), Div(1; Mul(Add(\\sigma, k, Neg(1)), Pow(a; Add(\\sigma, k, Neg(1)))))))); \\le)",
        "fredrik-johansson/arb/doc/source/hurwitz.rst",
    ),
    (
        "\\boldsymbol\\Sigma_\\boldsymbol\\omega = \\begin{bmatrix} \\sigma_{\\boldsymbol\\omega x}^2 & 0 & 0 \\\\ 0 & \\sigma_{\\boldsymbol\\omega y}^2 & 0 \\\\ 0 & 0 & \\sigma_{\\boldsymbol\\omega z}^2 \\end{bmatrix}",
        "Chain(\\boldsymbol{\\Sigma}_{\\boldsymbol\\omega}, MatrixOf(Pow(\\sigma_{\\boldsymbol\\omega x}; 2), 0, 0, 0, Pow(\\sigma_{\\boldsymbol\\omega y}; 2), 0, 0, 0, Pow(\\sigma_{\\boldsymbol\\omega z}; 2)); =)",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "F_r = -\\frac{\\partial V}{\\partial q_r}",
        "Chain(F_r, Neg(Derivative(Call(V); q_r, 1; True)); =)",
        "moorepants/learn-multibody-dynamics/energy.rst",
    ),
    (
        "\\frac{1}{2}(2x+6\\sin(x)\\cos(x))^2 \\ge \\mu(x^2 + 3\\sin^2(x)),",
        "Chain(Mul(Div(1; 2), Pow(Add(Mul(2, x), Mul(6, Call(sin; x), Call(cos; x))); 2)), Mul(\\mu, Add(Pow(x; 2), Mul(3, Pow(Call(sin; x); 2)))); \\ge)",
        "RussTedrake/underactuated/book/policy_search.html",
    ),
    (
        "\\varepsilon_4(a,b,c,d) &= \\exp(\\pi i [-R(a,b,c,d) + (3-(2+d)b)] / 4)",
        "Chain(Call(\\varepsilon_4; a, b, c, d), Call(exp; Div(Mul(\\pi, i, Add(Neg(Call(R; a, b, c, d)), Add(3, Neg(Mul(Add(2, d), b))))); 4)); =)",
        "fredrik-johansson/arb/doc/source/acb_modular.rst",
    ),
    (
        "{}^A\\bar{v}^{B_c} = {}^B\\bar{v}^{B_c} + {}^A\\bar{\\omega}^B\\times\\bar{r}^{B_c/S}",
        "Chain(\\prescript { A } { } { \\bar { v } } ^ { B _ { c } }, Add(\\prescript { B } { } { \\bar { v } } ^ { B _ { c } }, Cross(\\prescript { A } { } { \\bar { \\omega } } ^ { B }; \\bar { r } ^ { B _ { c } / S })); =)",
        "moorepants/learn-multibody-dynamics/translational.rst",
    ),
    (
        "{\\bf n} {\\bf v}^+ - {\\bf n}{\\bf v}^- = -(1+e){\\bf n}{\\bf v}^-,",
        "Chain(Add(Mul(\\mathbf{n}, \\mathbf { v } ^ { + }), Neg(Mul(\\mathbf{n}, \\mathbf { v } ^ { - }))), Neg(Mul(Add(1, e), \\mathbf{n}, \\mathbf { v } ^ { - })); =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "K_{ {\\boldsymbol{\\alpha}}} = K_{ {\\boldsymbol{\\alpha}}}^{1/2} \\, {\\left(K_{ {\\boldsymbol{\\alpha}}}^{1/2}\\right)}^T\\quad.",
        "Chain(K_{\\boldsymbol\\alpha}, Mul(Pow(K_{\\boldsymbol\\alpha}; Div(1; 2)), Transpose(Pow(K_{\\boldsymbol\\alpha}; Div(1; 2)))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\dot{\\tilde{E}} = - k \\dot\\theta^2 \\cos^2\\theta \\tilde{E}.",
        "Chain(Call(\\dot{\\tilde{E}}), Neg(Mul(k, Pow(Call(\\dot{\\theta}); 2), Pow(Call(cos; Call(\\theta)); 2), Call(\\tilde{E}))); =)",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "L' = T' - U'",
        "Chain(L', Add(T', Neg(U')); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter7.tex",
    ),
    (
        "e_1 = \\sqrt{1 - \\frac{c^2}{a^2}}",
        "Chain(e_1, Sqrt(Add(1, Neg(Div(Pow(c; 2); Pow(a; 2))))); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\operatorname{Chi}(z) = -\\frac{1}{2} \\left[ e^{z} U(1,1,-z) + e^{-z} U(1,1,z) + \\log(-z) - \\log(z) \\right]",
        "Chain(Call(\\text{Chi}; z), Neg(Mul(Div(1; 2), Add(Mul(Pow(e; z), Call(U; 1, 1, Neg(z))), Mul(Pow(e; Neg(z)), Call(U; 1, 1, z)), Call(log; Neg(z)), Neg(Call(log; z))))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "E(m) = E\\left(\\tfrac{\\pi}{2}\\middle| m\\right)",
        "Chain(Call(E; m), Call(E; Given(Div(\\pi; 2); m; |)); =)",
        "sympy/sympy/sympy/functions/special/elliptic_integrals.py",
    ),
    (
        "y'' + \\lambda y = 0, \\quad y'(0) = 0, \\quad y'(1) = 0.",
        "System(Chain(Add(Call(y''), Mul(\\lambda, Call(y))), 0; =), Chain(Call(y'; 0), 0; =), Chain(Call(y'; 1), 0; =))",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "\\bm{\\omega}_{RN} = \\dot{\\bm{\\omega}}_{RN} = 0",
        "Chain(Call(\\bm{\\omega}_{RN}), Call(\\dot{\\bm{\\omega}}_{RN}), 0; =, =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/inertial3D/_Documentation/secModuleDescription.tex",
    ),
    (
        "\\begin{bmatrix} \\ddot \\theta_{i1}\\\\ \\ddot \\theta_{i2} \\end{bmatrix} = [E_i][F_i] \\ddot{\\bm r}_{B/N} + [E_i][G_i]\\dot{\\bm\\omega}_{\\cal B/N} + [E_i]\\bm v_i",
        "Chain(MatrixOf(Call(\\ddot{\\theta}_{i1}), Call(\\ddot{\\theta}_{i2})), Add(Mul([ E _ { i } ], [ F _ { i } ], Call(\\ddot{\\bm{r}}_{B/N})), Mul([ E _ { i } ], [ G _ { i } ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N })), Mul([ E _ { i } ], \\bm{v}_i)); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "{}^Ap^B_G = {}^GR^F {}^Ap^B_F.",
        "Chain(\\prescript { A } { } { p } _ { G } ^ { B }, Mul(\\prescript { G } { } { R } ^ { F }, \\prescript { A } { } { p } _ { F } ^ { B }); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\alpha = \\frac{\\rho_m - \\rho_l}{\\rho_g - \\rho_l}",
        "Chain(\\alpha, Div(Add(\\rho_m, Neg(\\rho_l)); Add(\\rho_g, Neg(\\rho_l))); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "z = S(s,a,n) = \\sum_{k=0}^{n-1} \\frac{q^k}{(k+a)^{s+t}}",
        "Chain(z, Call(S; s, a, n), BigSum(k; 0; Add(n, Neg(1)); Div(Pow(q; k); Pow(Add(k, a); Add(s, t)))); =, =)",
        "fredrik-johansson/arb/doc/source/acb_poly.rst",
    ),
    (
        "\\dot x_1 &=-\\frac{6x_1}{(1+x_1^2)^2}+2x_2, \\\\ \\dot x_2 &=-\\frac{2(x_1+x_2)}{(1+x_1^2)^2},",
        "System(Chain(Call(\\dot{x}_1), Add(Neg(Div(Mul(6, Call(x_1)); Pow(Add(1, Pow(Call(x_1); 2)); 2))), Mul(2, Call(x_2))); =), Chain(Call(\\dot{x}_2), Neg(Div(Mul(2, Add(Call(x_1), Call(x_2))); Pow(Add(1, Pow(Call(x_1); 2)); 2))); =))",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "\\sigma = |(b-2a)/z|",
        "Chain(\\sigma, Bars(Div(Add(b, Neg(Mul(2, a))); z)); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "r_{\\mathrm{min}} = \\frac{p}{1+e}",
        "Chain(r_{min}, Div(p; Add(1, e)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "\\dot{\\bm \\sigma}_{\\cal B/N} = \\frac{1}{4}[B(\\bm\\sigma_{\\cal B/N})] {\\vphantom{\\bm\\omega}}^{\\mathcal{B}\\!}{\\bm\\omega}_{\\cal B/N}",
        "Chain(Call(\\dot { \\bm { \\sigma } } _ { \\mathcal B / \\mathcal N }), Mul(Div(1; 4), Call([ B ]; Call(\\bm{\\sigma}_{\\mathcal B/\\mathcal N})), \\prescript { \\mathcal { B } \\! } { } { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } }); =)",
        "AVSLab/basilisk/src/architecture/utilitiesSelfCheck/_Documentation/secUserGuide.tex",
    ),
    (
        "\\mathbf{G}_t = \\mathbf{\\Sigma}_{\\mathbf{q}_t^-} \\big [\\mathbf{\\Sigma}_{\\mathbf{q}_t^-} + \\mathbf{\\Sigma}_{v_t}\\big ]^{-1}",
        "Chain(\\mathbf{G}_t, Mul(\\mathbf{\\Sigma}_{\\mathbf q_t^-}, Pow(Add(\\mathbf{\\Sigma}_{\\mathbf q_t^-}, \\mathbf{\\Sigma}_{v_t}); Neg(1))); =)",
        "Mayitzin/ahrs/ahrs/filters/fkf.py",
    ),
    (
        "\\alpha = 0 \\text{ for } F_t \\le 0.01032",
        "Implies(Chain(F_t, 0.01032; \\le); Chain(\\alpha, 0; =))",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "\\alpha = \\frac{x}{\\rho_g}\\left[C_0\\left(\\frac{x}{\\rho_g} + \\frac{1-x} {\\rho_l}\\right) +\\frac{v_{gm}}{G} \\right]^{-1}",
        "Chain(\\alpha, Mul(Div(x; \\rho_g), Pow(Add(Mul(C_0, Add(Div(x; \\rho_g), Div(Add(1, Neg(x)); \\rho_l))), Div(v_{gm}; G)); Neg(1))); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "a_n f^{(n)}(x) + a_{n-1} f^{(n-1)}(x) + \\cdots + a_1 f'(x) + a_0 f(x) = P(x)\\text{,}",
        "Chain(Add(Mul(a_n, Call(f ^ { ( n ) }; x)), Mul(a_{n-1}, Call(f ^ { ( n - 1 ) }; x)), Dots(), Mul(a_1, Call(f'; x)), Mul(a_0, Call(f; x))), Call(P; x); =)",
        "sympy/sympy/sympy/solvers/ode/single.py",
    ),
    (
        "{}^Bp^{\\text{ZMP}}_{W_z} m\\ddot{y} - {}^Bp^{\\text{ZMP}}_{W_y} (m\\ddot{z} + mg) = I \\ddot{\\theta}.",
        "Chain(Add(Mul(\\prescript { B } { } { p } _ { W _ { z } } ^ { \\text { Z M P } }, m, Call(\\ddot{y})), Neg(Mul(\\prescript { B } { } { p } _ { W _ { y } } ^ { \\text { Z M P } }, Add(Mul(m, Call(\\ddot{z})), Mul(m, g))))), Mul(I, Call(\\ddot{\\theta})); =)",
        "RussTedrake/underactuated/book/humanoids.html",
    ),
    (
        "\\vec{x} = \\operatorname{proj}_{\\vec{v}_1} ( \\vec{x} ) + \\operatorname{proj}_{\\vec{v}_2} ( \\vec{x} ) + \\cdots + \\operatorname{proj}_{\\vec{v}_n} ( \\vec{x} ) = \\frac{\\langle \\vec{x}, \\vec{v}_1 \\rangle}{ \\langle \\vec{v}_1, \\vec{v}_1 \\rangle } \\vec{v}_1 + \\frac{\\langle \\vec{x}, \\vec{v}_2 \\rangle}{ \\langle \\vec{v}_2, \\vec{v}_2 \\rangle } \\vec{v}_2 + \\cdots + \\frac{\\langle \\vec{x}, \\vec{v}_n \\rangle}{ \\langle \\vec{v}_n, \\vec{v}_n \\rangle } \\vec{v}_n .",
        "Chain(\\vec{x}, Add(Call(\\text{proj}_{\\vec v_1}; \\vec{x}), Call(\\text{proj}_{\\vec v_2}; \\vec{x}), Dots(), Call(\\text{proj}_{\\vec v_n}; \\vec{x})), Add(Mul(Div(Pair(\\vec{x}; \\vec{v}_1); Pair(\\vec{v}_1; \\vec{v}_1)), \\vec{v}_1), Mul(Div(Pair(\\vec{x}; \\vec{v}_2); Pair(\\vec{v}_2; \\vec{v}_2)), \\vec{v}_2), Dots(), Mul(Div(Pair(\\vec{x}; \\vec{v}_n); Pair(\\vec{v}_n; \\vec{v}_n)), \\vec{v}_n)); =, =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "J = -\\frac{1+\\chi}{\\mu^2}(\\boldsymbol{v}_{O_1}^-\\cdot \\boldsymbol{n}_1+\\boldsymbol{v}_{O_2}^-\\cdot \\boldsymbol{n}_2)",
        "Chain(J, Neg(Mul(Div(Add(1, \\chi); Pow(\\mu; 2)), Add(Mul(\\boldsymbol { v } _ { O _ { 1 } } ^ { - }, \\boldsymbol{n}_1; 1), Mul(\\boldsymbol { v } _ { O _ { 2 } } ^ { - }, \\boldsymbol{n}_2; 1)))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "\\begin{aligned} A_s &= \\frac{G m_s}{R^2} & P_p &= \\frac{G m_p}{r^2} & a_p &= \\frac{G m_p}{r^2} & p_s & = \\frac{G m_s}{R^3} r \\end{aligned}",
        "System(Chain(A_s, Div(Mul(G, m_s); Pow(R; 2)); =), Chain(P_p, Div(Mul(G, m_p); Pow(r; 2)); =), Chain(a_p, Div(Mul(G, m_p); Pow(r; 2)); =), Chain(p_s, Mul(Div(Mul(G, m_s); Pow(R; 3)), r); =))",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/sphere-of-influence.md",
    ),
    (
        "x(t) = C_1 e^{r_1 t} + C_2 e^{r_2 t} .",
        "Chain(Call(x; t), Add(Mul(C_1, Pow(e; Mul(r_1, t))), Mul(C_2, Pow(e; Mul(r_2, t)))); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "t_C = \\sqrt{\\frac{r_{12}^3}{\\mu}}",
        "Chain(t_C, Sqrt(Div(Pow(r_{12}; 3); \\mu)); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "\\boldsymbol r_{B/P} = \\boldsymbol r_{B/O} - \\boldsymbol r_{P/O}",
        "Chain(\\boldsymbol{r}_{B/P}, Add(\\boldsymbol{r}_{B/O}, Neg(\\boldsymbol{r}_{P/O})); =)",
        "AVSLab/basilisk/src/simulation/sensors/magnetometer/magnetometer.rst",
    ),
    (
        "\\bm{\\omega}_{\\mathrm{sat}} = \\mathrm{max}\\big(\\omega_{\\mathrm{min}}, \\mathrm{min}\\big( \\bm{\\omega}_{\\mathrm{discretized}}, \\omega_{\\mathrm{max}} \\big) \\big)",
        "Chain(\\bm{\\omega}_{sat}, Call(max; \\omega_{min}, Call(min; \\bm{\\omega}_{discretized}, \\omega_{max})); =)",
        "AVSLab/basilisk/src/architecture/utilities/_Documentation/discretize/secModelDescription.tex",
    ),
    (
        "\\mathbf{q}_t = \\gamma_t \\mathbf{q}_{\\nabla, t} + (1-\\gamma_t) \\mathbf{q}_{\\omega, t}",
        "Chain(\\mathbf{q}_t, Add(Mul(\\gamma_t, \\mathbf{q}_{\\nabla,t}), Mul(Add(1, Neg(\\gamma_t)), \\mathbf{q}_{\\omega,t})); =)",
        "Mayitzin/ahrs/ahrs/filters/madgwick.py",
    ),
    (
        "\\operatorname{Ci}(z) = \\log(z) - \\frac{1}{2} \\left[ e^{iz} U(1,1,-iz) + e^{-iz} U(1,1,iz) + \\log(-iz) + \\log(iz) \\right]",
        "Chain(Call(\\text{Ci}; z), Add(Call(log; z), Neg(Mul(Div(1; 2), Add(Mul(Pow(e; Mul(i, z)), Call(U; 1, 1, Neg(Mul(i, z)))), Mul(Pow(e; Neg(Mul(i, z))), Call(U; 1, 1, Mul(i, z))), Call(log; Neg(Mul(i, z))), Call(log; Mul(i, z)))))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "\\begin{gathered} \\nu_{f,1} + n_f t_{12} = \\nu_B \\\\ \\nu_{f,1} - \\nu_{i,1} + n_f t_{12} = \\nu_B - \\nu_A \\\\ \\gamma_1 + n_f t_{12} = \\Gamma \\\\ \\gamma_1 = \\Gamma - n_f t_{12} \\end{gathered}",
        "System(Chain(Add(\\nu_{f,1}, Mul(n_f, t_{12})), \\nu_B; =), Chain(Add(\\nu_{f,1}, Neg(\\nu_{i,1}), Mul(n_f, t_{12})), Add(\\nu_B, Neg(\\nu_A)); =), Chain(Add(\\gamma_1, Mul(n_f, t_{12})), \\varGamma; =), Chain(\\gamma_1, Add(\\varGamma, Neg(Mul(n_f, t_{12}))); =))",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/interplanetary-transfer-phasing.md",
    ),
    (
        "K_1 = \\left[1.205 - 3.28(0.0625-\\beta^4)-12.8\\beta^6\\sqrt{\\frac {\\alpha-60^\\circ}{120^\\circ}}\\right](1-\\beta^2)^2",
        "Chain(K_1, Mul(Add(1.205, Neg(Mul(3.28, Add(0.0625, Neg(Pow(\\beta; 4))))), Neg(Mul(12.8, Pow(\\beta; 6), Sqrt(Div(Add(\\alpha, Neg(Degrees(60))); Degrees(120)))))), Pow(Add(1, Neg(Pow(\\beta; 2))); 2)); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "{\\bf \\lambda} =- ({\\bf H} {\\bf M}^{-1} {\\bf H}^T)^+ ({\\bf H} {\\bf M}^{-1} {\\bf \\tau} + \\dot{{\\bf H}}{\\bf v} + 2\\alpha {\\bf H}{\\bf v} + \\alpha^2 {\\bf h}).",
        "Chain(\\mathbf{\\lambda}, Neg(Mul(Marked(Mul(Call(\\mathbf{H}), Pow(\\mathbf{M}; Neg(1)), Transpose(Call(\\mathbf{H}))); ^+), Add(Mul(Call(\\mathbf{H}), Pow(\\mathbf{M}; Neg(1)), \\mathbf{\\tau}), Mul(Call(\\dot{\\mathbf{H}}), \\mathbf{v}), Mul(2, \\alpha, Call(\\mathbf{H}), \\mathbf{v}), Mul(Pow(\\alpha; 2), \\mathbf{h})))); =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "\\boxed{\\mathbf{P}_{yz} = \\sum_{i=0}^{2n} w_i^{(c)} (\\mathcal{Y}_i - \\bar{\\mathbf{y}})(\\mathcal{Z}_i - \\bar{\\mathbf{z}})^T}",
        "Chain(\\mathbf{P}_{yz}, BigSum(i; 0; Mul(2, n); Mul(w _ { i } ^ { ( c ) }, Add(\\mathcal{Y}_i, Neg(\\bar{\\mathbf{y}})), Transpose(Add(\\mathcal{Z}_i, Neg(\\bar{\\mathbf{z}}))))); =)",
        "Mayitzin/ahrs/ahrs/filters/ukf.py",
    ),
    (
        "\\int_{0}^\\pi \\sin (mt) \\sin (nt) \\,dt = 0 , \\quad \\text{when } m \\neq n.",
        "Implies(Chain(m, n; \\ne); Chain(Integral(Mul(Call(sin; Mul(m, t)), Call(sin; Mul(n, t))); t; 0; \\pi), 0; =))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\boldsymbol{v}_A = (-l\\dot{\\alpha}\\sin\\alpha,l\\dot{\\alpha}\\cos\\alpha),\\quad \\boldsymbol{v}_C = (-l\\dot{\\alpha}\\sin\\alpha,-l\\dot{\\alpha}\\cos\\alpha)",
        "System(Chain(\\boldsymbol{v}_A, Pair(Neg(Mul(l, Call(\\dot{\\alpha}), Call(sin; Call(\\alpha)))); Mul(l, Call(\\dot{\\alpha}), Call(cos; Call(\\alpha)))); =), Chain(\\boldsymbol{v}_C, Pair(Neg(Mul(l, Call(\\dot{\\alpha}), Call(sin; Call(\\alpha)))); Neg(Mul(l, Call(\\dot{\\alpha}), Call(cos; Call(\\alpha))))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "\\begin{pmatrix} \\omega_1 \\\\ \\omega_2 \\\\ \\omega_3 \\end{pmatrix} = \\begin{pmatrix} \\sin\\theta\\cos\\psi & -\\sin\\psi & 0 \\\\ \\sin\\theta\\sin\\psi & \\cos\\psi & 0 \\\\ \\cos\\theta & 0 & 1 \\end{pmatrix} \\begin{pmatrix} \\dot{\\theta} \\\\ \\dot{\\phi} \\\\ \\dot{\\psi} \\end{pmatrix}",
        "Chain(MatrixOf(\\omega_1, \\omega_2, \\omega_3), Mul(MatrixOf(Mul(Call(sin; Call(\\theta)), Call(cos; Call(\\psi))), Neg(Call(sin; Call(\\psi))), 0, Mul(Call(sin; Call(\\theta)), Call(sin; Call(\\psi))), Call(cos; Call(\\psi)), 0, Call(cos; Call(\\theta)), 0, 1), MatrixOf(Call(\\dot{\\theta}), Call(\\dot{\\phi}), Call(\\dot{\\psi}))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "k_{aa} := \\sqrt{\\frac{I_{aa}}{m}}",
        "Chain(k_{aa}, Sqrt(Div(I_{aa}; m)); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "J_{{\\bf u}(\\cdot)}({\\bf x}_0) = \\ell_f ({\\bf x}(t_f)) + \\int_{t_0}^{t_f} \\ell({\\bf x}(t),{\\bf u}(t)) dt.",
        "Chain(Call(J_{\\mathbf u(\\cdot)}; \\mathbf{x}_0), Add(Call(\\ell_f; Call(\\mathbf{x}; t_f)), Integral(Call(\\ell; Call(\\mathbf{x}; t), Call(\\mathbf{u}; t)); t; t_0; t_f)); =)",
        "RussTedrake/underactuated/book/trajopt.html",
    ),
    (
        "&= x^{1/k} [1 - \\exp(\\log(1-r/x)/k)] \\le x^{1/k} \\min(1, -\\log(1-r/x)/k)",
        "Chain(Blank(), Mul(Pow(x; Div(1; k)), Add(1, Neg(Call(exp; Div(Call(log; Add(1, Neg(Div(r; x)))); k))))), Mul(Pow(x; Div(1; k)), Call(min; 1, Neg(Div(Call(log; Add(1, Neg(Div(r; x)))); k)))); =, \\le)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "X(x)T'(t) = k X''(x)T(t) .",
        "Chain(Mul(Call(X; x), Call(T'; t)), Mul(k, Call(X''; x), Call(T; t)); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\begin{bmatrix} \\dot{x_1}(t) \\\\ \\dot{x_2}(t) \\end{bmatrix} = \\begin{bmatrix} -\\frac{2}{RC} & \\frac{1}{RC} \\\\ \\frac{1}{RC} & -\\frac{1}{RC} \\end{bmatrix} \\begin{bmatrix} x_1(t) \\\\ x_2(t) \\end{bmatrix} + \\begin{bmatrix} \\frac{1}{RC} \\\\ 0 \\end{bmatrix} u(t)",
        "Chain(MatrixOf(Call(\\dot{x}_1; t), Call(\\dot{x}_2; t)), Add(Mul(MatrixOf(Neg(Div(2; Mul(R, C))), Div(1; Mul(R, C)), Div(1; Mul(R, C)), Neg(Div(1; Mul(R, C)))), MatrixOf(Call(x_1; t), Call(x_2; t))), Mul(MatrixOf(Div(1; Mul(R, C)), 0), Call(u; t))); =)",
        "sympy/sympy/doc/src/tutorials/physics/control/electrical_problems.rst",
    ),
    (
        "\\bar{v} = & v_x \\hat{n}_x + v_y \\hat{n}_y + v_z \\hat{n}_z \\\\ \\bar{w} = & w_x \\hat{n}_x + w_y \\hat{n}_y + w_z \\hat{n}_z \\\\ \\bar{v} \\times \\bar{w} = & (v_y w_z - v_z w_y) \\hat{n}_x + (v_z w_x - v_x w_z) \\hat{n}_y + (v_x w_y - v_y w_x) \\hat{n}_z",
        "System(Chain(\\bar{v}, Add(Mul(v_x, \\hat{n}_x), Mul(v_y, \\hat{n}_y), Mul(v_z, \\hat{n}_z)); =), Chain(\\bar{w}, Add(Mul(w_x, \\hat{n}_x), Mul(w_y, \\hat{n}_y), Mul(w_z, \\hat{n}_z)); =), Chain(Cross(\\bar{v}; \\bar{w}), Add(Mul(Add(Mul(v_y, w_z), Neg(Mul(v_z, w_y))), \\hat{n}_x), Mul(Add(Mul(v_z, w_x), Neg(Mul(v_x, w_z))), \\hat{n}_y), Mul(Add(Mul(v_x, w_y), Neg(Mul(v_y, w_x))), \\hat{n}_z)); =))",
        "moorepants/learn-multibody-dynamics/vectors.rst",
    ),
    (
        "\\mathbf{r}_3^T = \\begin{bmatrix} 0 & 0 & 1 \\end{bmatrix}",
        "Chain(Transpose(\\mathbf{r}_3), MatrixOf(0, 0, 1); =)",
        "Mayitzin/ahrs/ahrs/common/orientation.py",
    ),
    (
        "a_n = \\frac{1}{2^{n - 1}} \\sum_{k=0}^{\\mathrm{floor}(n/2)}(-1)^k\\frac{1}{\\left(n - k\\right)!k!}\\left(n - 2k\\right)^{n - 1}\\sin\\left[\\left(n - 2k\\right)M_e\\right]",
        "Chain(a_n, Mul(Div(1; Pow(2; Add(n, Neg(1)))), BigSum(k; 0; Call(floor; Div(n; 2)); Mul(Pow(Neg(1); k), Div(1; Mul(Factorial(Add(n, Neg(k))), Factorial(k))), Pow(Add(n, Neg(Mul(2, k))); Add(n, Neg(1))), Call(sin; Mul(Add(n, Neg(Mul(2, k))), M_e))))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "\\operatorname{atan}(x) = \\operatorname{atan}(p/q) + \\operatorname{atan}(w), \\quad w = \\frac{qx-p}{px+q}, \\quad p = \\lfloor qx \\rfloor",
        "System(Chain(Call(atan; x), Add(Call(atan; Div(p; q)), Call(atan; w)); =), Chain(w, Div(Add(Mul(q, x), Neg(p)); Add(Mul(p, x), q)); =), Chain(p, Call(floor; Mul(q, x)); =))",
        "fredrik-johansson/arb/doc/source/arb.rst",
    ),
    (
        "\\begin{split} m_{\\text{\\text{sc}}}[\\tilde{\\bm{c}}]\\ddot{\\bm r}_{B/N} + [I_{\\text{sc},B}]\\dot{\\bm\\omega} + \\sum\\limits_{i=1}^{N}\\bm{u}_{\\omega_i}\\ddot{\\gamma}_i + \\sum\\limits_{i=1}^{N}\\bm{v}_{\\omega_i}\\dot{\\Omega}_i \\\\= \\bm{L}_B - [I_{\\text{sc},B}]'\\bm{\\omega} - [\\tilde{\\bm\\omega}][I_{\\text{sc},B}]\\bm\\omega - \\sum\\limits_{i=1}^{N}\\bm{k}_{\\omega_i} \\end{split}",
        "Chain(Add(Mul(m_{sc}, [ \\tilde { \\bm { c } } ], Call(\\ddot{\\bm{r}}_{B/N})), Mul([ I _ { \\text { s c } , B } ], Call(\\dot{\\bm{\\omega}})), BigSum(i; 1; N; Mul(\\bm{u}_{\\omega_i}, Call(\\ddot{\\gamma}_i))), BigSum(i; 1; N; Mul(\\bm{v}_{\\omega_i}, Call(\\dot{\\Omega}_i)))), Add(\\bm{L}_B, Neg(Mul([ I _ { \\text { s c } , B } ]', Call(\\bm{\\omega}))), Neg(Mul([ \\tilde { \\bm { \\omega } } ], [ I _ { \\text { s c } , B } ], Call(\\bm{\\omega}))), Neg(BigSum(i; 1; N; \\bm{k}_{\\omega_i}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/VSCMGs/_Documentation/secModelDescription.tex",
    ),
    (
        "S(\\omega)= \\sum_{j=1}^J \\frac{q_j\\,z + r_j}{z^2+s_j\\,z + t_j} = 0",
        "Chain(Call(S; \\omega), BigSum(j; 1; J; Div(Add(Mul(q_j, z), r_j); Add(Pow(z; 2), Mul(s_j, z), t_j))), 0; =, =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "T' = \\frac12 mR^2 \\dot{\\theta}^2",
        "Chain(T', Mul(Div(1; 2), m, Pow(R; 2), Pow(Call(\\dot{\\theta}); 2)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "J = m_Av = (m_A+m_B)g\\sqrt{\\frac{m_A}{2k}}",
        "Chain(J, Mul(m_A, v), Mul(Add(m_A, m_B), g, Sqrt(Div(m_A; Mul(2, k)))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "\\mathbf{\\Sigma}_{\\mathbf{q}_t} = (\\mathbf{I}_4 - \\mathbf{G}_t) \\mathbf{\\Sigma}_{\\mathbf{q}_t^-}",
        "Chain(\\mathbf{\\Sigma}_{\\mathbf q_t}, Mul(Add(\\mathbf{I}_4, Neg(\\mathbf{G}_t)), \\mathbf{\\Sigma}_{\\mathbf q_t^-}); =)",
        "Mayitzin/ahrs/ahrs/filters/fkf.py",
    ),
    (
        "\\mathrm{d} \\omega = 2\\pi \\sin \\theta\\mathrm{d} \\theta",
        "Chain(Total(\\omega), Mul(2, \\pi, Call(sin; \\theta), Total(\\theta)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "\\boldsymbol\\Sigma_\\boldsymbol\\omega = \\sigma_\\boldsymbol\\omega^2\\mathbf{I}_3",
        "Chain(\\boldsymbol{\\Sigma}_{\\boldsymbol\\omega}, Mul(Pow(\\sigma_{\\boldsymbol\\omega}; 2), \\mathbf{I}_3); =)",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "\\begin{bmatrix} [A] & [B]\\\\ [C] & [D] \\end{bmatrix} \\begin{bmatrix} \\ddot{\\bm r}_{B/N}\\\\ \\dot{\\bm\\omega}_{\\cal B/N} \\end{bmatrix} = \\begin{bmatrix} \\bm v_{\\text{trans}}\\\\ \\bm v_{\\text{rot}} \\end{bmatrix}",
        "Chain(Mul(MatrixOf([ A ], [ B ], [ C ], [ D ]), MatrixOf(Call(\\ddot{\\bm{r}}_{B/N}), Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }))), MatrixOf(\\bm{v}_{trans}, \\bm{v}_{rot}); =)",
        "AVSLab/basilisk/src/simulation/dynamics/HingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\sigma^2 = \\frac{2}{\\tau}\\,\\frac{\\sigma_{st}^2}{\\mu^2 + \\sigma_{st}^2}",
        "Chain(Pow(\\sigma; 2), Mul(Div(2; \\tau), Div(Pow(\\sigma_{st}; 2); Add(Pow(\\mu; 2), Pow(\\sigma_{st}; 2)))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/igbmNoiseStateEffector/igbmNoiseStateEffector.rst",
    ),
    (
        "\\boldsymbol{y}(t_k) = \\boldsymbol{g}\\big( t_k, \\boldsymbol{x}(t_k), \\dot{\\boldsymbol{x}}(t_{k-1}), \\boldsymbol{u}(t_k) \\big)",
        "Chain(Call(\\boldsymbol{y}; t_k), Call(\\boldsymbol{g}; t_k, Call(\\boldsymbol{x}; t_k), Call(\\dot{\\boldsymbol{x}}; t_{k-1}), Call(\\boldsymbol{u}; t_k)); =)",
        "JSBSim-Team/jsbsim-reference-manual/docs/formulation/state-propagation-contract.md",
    ),
    (
        "d'_i = \\prod_{j=1}^n d_j^{P_{ij}}.",
        "Chain(d_i', BigProduct(j; 1; n; Pow(d_j; P_{ij})); =)",
        "sympy/sympy/doc/src/modules/physics/units/philosophy.rst",
    ),
    (
        "{\\vphantom{\\bm F}}^{\\mathcal{B}\\!}{\\bm F} = {\\vphantom{\\bm F_1}}^{\\mathcal{B}\\!}{\\bm F_1} + {\\vphantom{\\bm F_2}}^{\\mathcal{B}\\!}{\\bm F_2} &\\hspace{1cm} {\\vphantom{\\bm T}}^{\\mathcal{B}\\!}{\\bm T} = {\\vphantom{\\bm T_1}}^{\\mathcal{B}\\!}{\\bm T_1} + {\\vphantom{\\bm T_2}}^{\\mathcal{B}\\!}{\\bm T_2}",
        "System(Chain(\\prescript { \\mathcal { B } \\! } { } { \\bm { F } }, Add(\\prescript { \\mathcal { B } \\! } { } { \\bm { F } } _ { 1 }, \\prescript { \\mathcal { B } \\! } { } { \\bm { F } } _ { 2 }); =), Chain(\\prescript { \\mathcal { B } \\! } { } { \\bm { T } }, Add(\\prescript { \\mathcal { B } \\! } { } { \\bm { T } } _ { 1 }, \\prescript { \\mathcal { B } \\! } { } { \\bm { T } } _ { 2 }); =))",
        "AVSLab/basilisk/src/simulation/dynamics/Thrusters/thrusterDynamicEffector/_Documentation/secTest.tex",
    ),
    (
        "\\mathbf{Q} = \\begin{bmatrix} \\mathbf{q}_0 \\\\ \\mathbf{q}_1 \\\\ \\vdots \\\\ \\mathbf{q}_{N-1} \\end{bmatrix} = \\begin{bmatrix} w_0 & x_0 & y_0 & z_0 \\\\ w_1 & x_1 & y_1 & z_1 \\\\ \\vdots & \\vdots & \\vdots & \\vdots \\\\ w_{N-1} & x_{N-1} & y_{N-1} & z_{N-1} \\end{bmatrix}",
        "Chain(\\mathbf{Q}, MatrixOf(\\mathbf{q}_0, \\mathbf{q}_1, Dots(), \\mathbf{q}_{N-1}), MatrixOf(w_0, x_0, y_0, z_0, w_1, x_1, y_1, z_1, Dots(), Dots(), Dots(), Dots(), w_{N-1}, x_{N-1}, y_{N-1}, z_{N-1}); =, =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "\\begin{bmatrix} \\mathbf{M}_d & \\mathbf{M}_{hn}^T \\\\ \\mathbf{ M}_{hn} & 0 \\end{bmatrix} \\begin{bmatrix} \\ddot{\\bar{q}} \\\\ \\bar{\\lambda} \\end{bmatrix} + \\begin{bmatrix} \\bar{g}_d \\\\ \\bar{g}_{hnd} \\end{bmatrix} = \\begin{bmatrix} 0 \\\\ 0 \\end{bmatrix}",
        "Chain(Add(Mul(MatrixOf(\\mathbf{M}_d, Transpose(\\mathbf{M}_{hn}), \\mathbf{M}_{hn}, 0), MatrixOf(Call(\\ddot{\\bar{q}}), \\bar{\\lambda})), MatrixOf(\\bar{g}_d, \\bar{g}_{hnd})), MatrixOf(0, 0); =)",
        "moorepants/learn-multibody-dynamics/lagrange.rst",
    ),
    (
        "v = \\lVert\\boldsymbol{v}\\rVert = \\sqrt{v_x^2 + v_y^2 + v_z^2}",
        "Chain(v, Norm(\\boldsymbol{v}), Sqrt(Add(Pow(v_x; 2), Pow(v_y; 2), Pow(v_z; 2))); =, =)",
        "bryanwweber/orbital-mechanics-notes/review/kinematics.md",
    ),
    (
        "F_r := \\sum_{i=1}^\\nu {}^A\\bar{v}^{P_i}_r \\cdot \\bar{R}_i",
        "Chain(F_r, BigSum(i; 1; \\nu; Mul(\\prescript { A } { } { \\bar { v } } _ { r } ^ { P _ { i } }, \\bar{R}_i; 1)); =)",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "\\begin{cases} \\dfrac12 m(v_\\theta^2 + v_\\phi^2) + mgz = \\dfrac12 mv_0^2 - mgh \\\\[1.5ex] mv_\\phi \\sqrt{r^2-z^2} = mv_0\\sqrt{r^2-h^2} \\end{cases}",
        "System(Chain(Add(Mul(Div(1; 2), m, Add(Pow(v_\\theta; 2), Pow(v_\\phi; 2))), Mul(m, g, z)), Add(Mul(Div(1; 2), m, Pow(v_0; 2)), Neg(Mul(m, g, h))); =), Chain(Mul(m, v_\\phi, Sqrt(Add(Pow(r; 2), Neg(Pow(z; 2))))), Mul(m, v_0, Sqrt(Add(Pow(r; 2), Neg(Pow(h; 2))))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "y''+\\lambda y = 0, \\quad y(0)- y'(0) = 0, \\quad y(1) = 0 .",
        "System(Chain(Add(Call(y''), Mul(\\lambda, Call(y))), 0; =), Chain(Add(Call(y; 0), Neg(Call(y'; 0))), 0; =), Chain(Call(y; 1), 0; =))",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "\\text{De} = \\frac{\\sqrt{\\text{centripetal forces}\\cdot \\text{inertial forces}}}{\\text{viscous forces}}",
        "Chain(\\text{De}, Div(Sqrt(Mul(\\text{centripetal~forces}, \\text{inertial~forces})); \\text{viscous~forces}); =)",
        "CalebBell/fluids/fluids/core.py",
    ),
    (
        "\\int\\frac{d\\nu}{\\left(1 + e\\cos \\nu\\right)^2} = \\frac{1}{\\left(1 - e^2\\right)^{3/2}}\\left[2\\tan^{-1}\\left(\\sqrt{\\frac{1 - e}{1 + e}}\\tan\\frac{\\nu}{2}\\right)-\\frac{e\\sqrt{1 - e^2}\\sin \\nu}{1 + e \\cos \\nu}\\right]",
        "Chain(Antiderivative(Div(1; Pow(Add(1, Mul(e, Call(cos; \\nu))); 2)); \\nu), Mul(Div(1; Pow(Add(1, Neg(Pow(e; 2))); Div(3; 2))), Add(Mul(2, Call(arctan; Mul(Sqrt(Div(Add(1, Neg(e)); Add(1, e))), Call(tan; Div(\\nu; 2))))), Neg(Div(Mul(e, Sqrt(Add(1, Neg(Pow(e; 2)))), Call(sin; \\nu)); Add(1, Mul(e, Call(cos; \\nu))))))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "g = g_0\\left(\\frac{r_0}{r_0+Z}\\right)^2",
        "Chain(g, Mul(g_0, Pow(Div(r_0; Add(r_0, Z)); 2)); =)",
        "CalebBell/fluids/fluids/atmosphere.py",
    ),
    (
        "\\wp(z, \\tau) = \\frac{1}{z^2} + \\sum_{n^2+m^2 \\ne 0} \\left[ \\frac{1}{(z+m+n\\tau)^2} - \\frac{1}{(m+n\\tau)^2} \\right]",
        "Chain(Call(\\wp; z, \\tau), Add(Div(1; Pow(z; 2)), Limiting(sum; _{ n ^ { 2 } + m ^ { 2 } \\ne 0 }; Add(Div(1; Pow(Add(z, m, Mul(n, \\tau)); 2)), Neg(Div(1; Pow(Add(m, Mul(n, \\tau)); 2)))))); =)",
        "fredrik-johansson/arb/doc/source/acb_elliptic.rst",
    ),
    (
        "\\mathbf{Q}_t = \\int_0^{\\Delta t} e^{\\mathbf{A}_t} \\boldsymbol\\Sigma_\\boldsymbol\\omega e^{\\mathbf{A}_t^T} dt",
        "Chain(\\mathbf{Q}_t, Integral(Mul(Pow(e; \\mathbf{A}_t), \\boldsymbol{\\Sigma}_{\\boldsymbol\\omega}, Pow(e; Transpose(\\mathbf{A}_t))); t; 0; \\Delta t); =)",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "i = \\cos^{-1}\\left(\\frac{h_Z}{h}\\right)",
        "Chain(i, Call(arccos; Div(h_Z; h)); =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/orbital-elements-and-the-state-vector.md",
    ),
    (
        "\\psi^{(1)}(z) := \\frac{\\mathrm{d}^{2}}{\\mathrm{d} z^{2}} \\log\\Gamma(z).",
        "Chain(Call(\\psi ^ { ( 1 ) }; z), Derivative(Call(log; Call(Gamma; z)); z, 2); =)",
        "sympy/sympy/sympy/functions/special/gamma_functions.py",
    ),
    (
        "\\frac{dx(t)}{dt} = A \\times x(t), x(0) = x0",
        "System(Chain(Derivative(Call(x; t); t, 1), Cross(A; Call(x; t)); =), Chain(Call(x; 0), \\text{x0}; =))",
        "sympy/sympy/sympy/solvers/ode/systems.py",
    ),
    (
        "U'(r_m) = -\\frac{l^2}{\\mu r_m^3} + \\alpha n r_m^{n-1} = 0",
        "Chain(Call(U'; r_m), Add(Neg(Div(Pow(l; 2); Mul(\\mu, Pow(r_m; 3)))), Mul(\\alpha, n, Pow(r_m; Add(n, Neg(1))))), 0; =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "I'_{3\\,3} = \\dot{m}_\\text{fuel}\\,r^2",
        "Chain(I_{3\\,3}', Mul(Call(\\dot{m}_{fuel}), Pow(r; 2)); =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "y = y' + \\frac{a_1 c_2 - a_2 c_1}{a_2 b_1 - a_1 b_2}\\text{.}",
        "Chain(y, Add(y', Div(Add(Mul(a_1, c_2), Neg(Mul(a_2, c_1))); Add(Mul(a_2, b_1), Neg(Mul(a_1, b_2))))); =)",
        "sympy/sympy/sympy/solvers/ode/single.py",
    ),
    (
        "\\int_a^b x_1(t) x_2(t) \\,dt = 0 .",
        "Chain(Integral(Mul(Call(x_1; t), Call(x_2; t)); t; a; b), 0; =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\underbrace{X'(t)\\, \\vec{u}(t) + X(t)\\, {\\vec{u}}'(t)} _{{\\vec{x}_p}'(t)} = \\underbrace{A(t)\\, X(t)\\, \\vec{u}(t)} _{A(t) \\vec{x}_p (t)} + \\vec{f}(t) .",
        "Chain(Add(Mul(Call(X'; t), Call(\\vec{u}; t)), Mul(Call(X; t), Call(\\vec{u}'; t))), Add(Mul(Call(A; t), Call(X; t), Call(\\vec{u}; t)), Call(\\vec{f}; t)); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "J_n({\\bf x}) = {\\bf x}^T {\\bf S}_n {\\bf x} + c_n,",
        "Chain(Call(J_n; \\mathbf{x}), Add(Mul(Transpose(\\mathbf{x}), \\mathbf{S}_n, \\mathbf{x}), c_n); =)",
        "RussTedrake/underactuated/book/robust.html",
    ),
    (
        "\\mathbf{q}_e = \\begin{pmatrix}\\cos\\frac{\\theta}{2} \\\\ 0 \\\\ \\sin\\frac{\\theta}{2} \\\\ 0\\end{pmatrix}",
        "Chain(\\mathbf{q}_e, MatrixOf(Call(cos; Div(\\theta; 2)), 0, Call(sin; Div(\\theta; 2)), 0); =)",
        "Mayitzin/ahrs/ahrs/filters/fqa.py",
    ),
    (
        "K_{\\nu}(z) = \\left(\\frac{2z}{\\pi}\\right)^{-1/2} e^{-z} U^{*}(\\nu+\\tfrac{1}{2}, 2\\nu+1, 2z).",
        "Chain(Call(K_\\nu; z), Mul(Pow(Div(Mul(2, z); \\pi); Neg(Div(1; 2))), Pow(e; Neg(z)), Call(U ^ { * }; Add(\\nu, Div(1; 2)), Add(Mul(2, \\nu), 1), Mul(2, z))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "dx/dt &= A x + B u \\\\ y &= C x + D u",
        "System(Chain(Derivative(Call(x); t, 1), Add(Mul(A, Call(x)), Mul(B, u)); =), Chain(y, Add(Mul(C, Call(x)), Mul(D, u)); =))",
        "python-control/python-control/control/statesp.py",
    ),
    (
        "\\mathbf{M}_{B_1} \\bar{v}_{B_1} = \\begin{bmatrix} \\bar{p}^{B_{1o}} \\cdot \\hat{n}_x \\\\ \\bar{p}^{B_{1o}} \\cdot \\hat{n}_y \\\\ \\bar{p}^{B_{1o}} \\cdot \\hat{n}_z \\\\ \\bar{H}^{B_1/B_{1o}} \\cdot \\hat{n}_x \\\\ \\bar{H}^{B_1/B_{1o}} \\cdot \\hat{n}_y \\\\ \\bar{H}^{B_1/B_{1o}} \\cdot \\hat{n}_z \\\\ \\end{bmatrix}",
        "Chain(Mul(\\mathbf{M}_{B_1}, \\bar{v}_{B_1}), MatrixOf(Mul(\\bar { p } ^ { B _ { 1 o } }, \\hat{n}_x; 1), Mul(\\bar { p } ^ { B _ { 1 o } }, \\hat{n}_y; 1), Mul(\\bar { p } ^ { B _ { 1 o } }, \\hat{n}_z; 1), Mul(\\bar { H } ^ { B _ { 1 } / B _ { 1 o } }, \\hat{n}_x; 1), Mul(\\bar { H } ^ { B _ { 1 } / B _ { 1 o } }, \\hat{n}_y; 1), Mul(\\bar { H } ^ { B _ { 1 } / B _ { 1 o } }, \\hat{n}_z; 1)); =)",
        "moorepants/learn-multibody-dynamics/tmt.rst",
    ),
    (
        "\\dot{\\boldsymbol{y}} = \\left[\\dot{X}_1\\ \\dot{Y}_1\\ \\dot{Z}_1\\ \\dot{X}_2\\ \\dot{Y}_2\\ \\dot{Z}_2\\ \\ddot{X}_1\\ \\ddot{Y}_1\\ \\ddot{Z}_1\\ \\ddot{X}_2\\ \\ddot{Y}_2\\ \\ddot{Z}_2\\right]",
        "Chain(Call(\\dot{\\boldsymbol{y}}), Tuple(Call(\\dot{X}_1), Call(\\dot{Y}_1), Call(\\dot{Z}_1), Call(\\dot{X}_2), Call(\\dot{Y}_2), Call(\\dot{Z}_2), Call(\\ddot{X}_1), Call(\\ddot{Y}_1), Call(\\ddot{Z}_1), Call(\\ddot{X}_2), Call(\\ddot{Y}_2), Call(\\ddot{Z}_2); []); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-inertial-numerical-solution.md",
    ),
    (
        "{\\bf A}\\, {}^W p^{B_i}_W(\\theta) \\le {\\bf b}.",
        "Chain(Mul(\\mathbf{A}, Call(\\prescript { W } { } { p } _ { W } ^ { B _ { i } }; \\theta)), \\mathbf{b}; \\le)",
        "RussTedrake/underactuated/book/humanoids.html",
    ),
    (
        "\\alpha = 0.823- 0.157\\ln(X_{tt})",
        "Chain(\\alpha, Add(0.823, Neg(Mul(0.157, Call(ln; X_{tt})))); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "\\underbrace{ \\begin{bmatrix} 2 & 2 & 2 \\\\ 1 & 1 & 3 \\\\ 1 & 4 & 1 \\end{bmatrix} }_{A} \\underbrace{ \\begin{bmatrix} x_1 \\\\ x_2 \\\\ x_3 \\end{bmatrix} }_{\\vec{x}} = \\underbrace{ \\begin{bmatrix} 2 \\\\ 5 \\\\ 10 \\end{bmatrix} }_{\\vec{b}} .",
        "Chain(Mul(MatrixOf(2, 2, 2, 1, 1, 3, 1, 4, 1), MatrixOf(x_1, x_2, x_3)), MatrixOf(2, 5, 10); =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "r = a\\frac{e^2 - 1}{1 + e\\cos\\nu}",
        "Chain(r, Mul(a, Div(Add(Pow(e; 2), Neg(1)); Add(1, Mul(e, Call(cos; \\nu))))); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/hyperbolic-trajectories.md",
    ),
    (
        "\\mathbf{R}^T(\\Delta\\mathbf{q}_\\mathrm{mag}) \\begin{bmatrix}l_x \\\\ l_y \\\\ l_z\\end{bmatrix} = \\begin{bmatrix}\\sqrt{l_x^2+l_y^2} \\\\ 0 \\\\ l_z\\end{bmatrix}",
        "Chain(Mul(Transpose(Call(\\mathbf{R}; \\Delta \\mathbf { q } _ { \\mathrm { m a g } })), MatrixOf(l_x, l_y, l_z)), MatrixOf(Sqrt(Add(Pow(l_x; 2), Pow(l_y; 2))), 0, l_z); =)",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "\\mathbf C_{I\\!Q} = \\mathbf C_{I\\!B} \\cdot \\mathbf C_{B\\!Q}",
        "Chain(\\mathbf{C}_{I\\!Q}, Mul(\\mathbf{C}_{I\\!B}, \\mathbf{C}_{B\\!Q}); =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "\\dot{x} + x = \\tanh(w x),",
        "Chain(Add(Call(\\dot{x}), Call(x)), Call(tanh; Mul(w, Call(x))); =)",
        "RussTedrake/underactuated/book/pend.html",
    ),
    (
        "\\boldsymbol{\\hat{u}}_S = -\\boldsymbol{\\hat{u}}_{r}",
        "Chain(\\boldsymbol{\\hat{u}}_S, Neg(\\boldsymbol{\\hat{u}}_r); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-arrival-flyby.md",
    ),
    (
        "F_{1,B}^{B_{c_1}} = {}^B R^{C_1} F_{1,C_{1}}^{B_{c_1}}.",
        "Chain(F _ { 1 , B } ^ { B _ { c _ { 1 } } }, Mul(\\prescript { B } { } { R } ^ { C _ { 1 } }, F _ { 1 , C _ { 1 } } ^ { B _ { c _ { 1 } } }); =)",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "\\frac{s^2+s+1}{s^3+s} = \\frac{A}{s} + \\frac{Bs+C}{s^2+1} .",
        "Chain(Div(Add(Pow(s; 2), s, 1); Add(Pow(s; 3), s)), Add(Div(A; s), Div(Add(Mul(B, s), C); Add(Pow(s; 2), 1))); =)",
        "jirilebl/diffyqs/ch-laplace.tex",
    ),
    (
        "{\\bf M}({{\\bf q}})\\ddot{{\\bf q}} + {\\bf C}({\\bf q},\\dot{{\\bf q}})\\dot{\\bf q} = {\\bf \\tau}_g({\\bf q}) + {\\bf B}{\\bf u} + \\sum_i {\\bf J}_i^T({\\bf q}) {\\bf \\lambda}_i,",
        "Chain(Add(Mul(Call(\\mathbf{M}; Call(\\mathbf{q})), Call(\\ddot{\\mathbf{q}})), Mul(Call(\\mathbf{C}; Call(\\mathbf{q}), Call(\\dot{\\mathbf{q}})), Call(\\dot{\\mathbf{q}}))), Add(Call(\\mathbf{\\tau}_g; Call(\\mathbf{q})), Mul(\\mathbf{B}, \\mathbf{u}), BigSum(i; Mul(Transpose(Call(\\mathbf{J}_i; Call(\\mathbf{q}))), \\mathbf{\\lambda}_i))); =)",
        "RussTedrake/underactuated/book/contact.html",
    ),
    (
        "b_2(t) = 2 - 5t^2 + 3t^3",
        "Chain(Call(b_2; t), Add(2, Neg(Mul(5, Pow(t; 2))), Mul(3, Pow(t; 3))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/catmull_rom_spline/catmull_rom_spline_main.rst",
    ),
    (
        "\\dot{\\mathbf{M}} = \\left[\\begin{array}{c|c|c} \\mathbf{J}_{\\bar{M}_i, \\bar{q}}\\bar{u} & \\ldots & \\mathbf{J}_{\\bar{M}_{6\\nu}, \\bar{q}}\\bar{u} \\end{array}\\right], \\quad \\dot{\\mathbf{T}} = \\left[\\begin{array}{c|c|c} \\mathbf{J}_{\\bar{T}_j, \\bar{q}}\\bar{u} & \\ldots & \\mathbf{J}_{\\bar{T}_n, \\bar{q}}\\bar{u} \\end{array}\\right]",
        "System(Chain(Call(\\dot{\\mathbf{M}}), MatrixOf(Mul(\\mathbf{J}_{\\bar M_i,\\bar q}, \\bar{u}), Dots(), Mul(\\mathbf{J}_{\\bar M_6\\nu,\\bar q}, \\bar{u})); =), Chain(Call(\\dot{\\mathbf{T}}), MatrixOf(Mul(\\mathbf{J}_{\\bar T_j,\\bar q}, \\bar{u}), Dots(), Mul(\\mathbf{J}_{\\bar T_n,\\bar q}, \\bar{u})); =))",
        "moorepants/learn-multibody-dynamics/tmt.rst",
    ),
    (
        "\\mathrm{B}(x) = 2^{1 - 2x}\\mathrm{B}(x, \\frac{1}{2}) \\\\ \\mathrm{B}(x) = 2^{1 - 2x} cos(\\pi x) \\mathrm{B}(\\frac{1}{2} - x, x) \\\\ \\mathrm{B}(x) = \\int_{0}^{1} \\frac{t^x}{(1 + t)^{2x}} dt \\\\ \\mathrm{B}(x) = \\frac{2}{x} \\prod_{n = 1}^{\\infty} \\frac{n(n + 2x)}{(n + x)^2}",
        "System(Chain(Call(\\text{B}; x), Mul(Pow(2; Add(1, Neg(Mul(2, x)))), Call(\\text{B}; x, Div(1; 2))); =), Chain(Call(\\text{B}; x), Mul(Pow(2; Add(1, Neg(Mul(2, x)))), Call(cos; Mul(\\pi, x)), Call(\\text{B}; Add(Div(1; 2), Neg(x)), x)); =), Chain(Call(\\text{B}; x), Integral(Div(Pow(t; x); Pow(Add(1, t); Mul(2, x))); t; 0; 1); =), Chain(Call(\\text{B}; x), Mul(Div(2; x), BigProduct(n; 1; Infinity(); Div(Mul(n, Add(n, Mul(2, x))); Pow(Add(n, x); 2)))); =))",
        "sympy/sympy/sympy/functions/special/beta_functions.py",
    ),
    (
        "(\\lambda_1 - \\lambda_2) x_1 x_2 = x_2'' x_1 - x_2 x_1'' .",
        "Chain(Mul(Add(\\lambda_1, Neg(\\lambda_2)), x_1, x_2), Add(Mul(x_2'', x_1), Neg(Mul(x_2, x_1''))); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "V = \\frac{\\pi D^2}{12} \\left(3h + a - \\frac{(a+h)^3}{a^2}\\right) ,\\;\\; 0 \\le h < |a|",
        "System(Chain(V, Mul(Div(Mul(\\pi, Pow(D; 2)); 12), Add(Mul(3, h), a, Neg(Div(Pow(Add(a, h); 3); Pow(a; 2))))); =), Chain(0, h, Bars(a); \\le, <))",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\rho(t) = \\mp \\ddot{\\rho}_{\\text{max}} \\left (\\frac{(t_f - t)^4}{4 t_{\\text{smooth}}^2} - \\frac{(t_f - t)^5}{10 t_{\\text{smooth}}^3} \\right ) + \\rho_{\\text{ref}}",
        "Chain(Call(\\rho; t), Add(PlusMinus(Mul(\\ddot { \\rho } _ { \\text { m a x } }, Add(Div(Pow(Add(t_f, Neg(t)); 4); Mul(4, Pow(t_{smooth}; 2))), Neg(Div(Pow(Add(t_f, Neg(t)); 5); Mul(10, Pow(t_{smooth}; 3)))))); True), \\rho_{ref}); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedLinearTranslation/prescribedLinearTranslation.rst",
    ),
    (
        "\\left[\\mathbf{Q}\\right] = \\begin{bmatrix}\\cos\\alpha\\cos\\beta & \\sin\\alpha\\cos\\beta & -\\sin\\beta\\\\\\cos\\alpha\\sin\\beta\\sin\\gamma - \\sin\\alpha\\cos\\beta & \\sin\\alpha\\sin\\beta\\sin\\gamma + \\cos\\alpha\\cos\\gamma & \\cos\\beta\\sin\\gamma\\\\\\cos\\alpha\\sin\\beta\\cos\\gamma + \\sin\\alpha\\sin\\gamma & \\sin\\alpha\\sin\\beta\\cos\\gamma - \\cos\\alpha\\sin\\gamma & \\cos\\beta\\cos\\gamma\\end{bmatrix}",
        "Chain([ \\mathbf { Q } ], MatrixOf(Mul(Call(cos; \\alpha), Call(cos; \\beta)), Mul(Call(sin; \\alpha), Call(cos; \\beta)), Neg(Call(sin; \\beta)), Add(Mul(Call(cos; \\alpha), Call(sin; \\beta), Call(sin; \\gamma)), Neg(Mul(Call(sin; \\alpha), Call(cos; \\beta)))), Add(Mul(Call(sin; \\alpha), Call(sin; \\beta), Call(sin; \\gamma)), Mul(Call(cos; \\alpha), Call(cos; \\gamma))), Mul(Call(cos; \\beta), Call(sin; \\gamma)), Add(Mul(Call(cos; \\alpha), Call(sin; \\beta), Call(cos; \\gamma)), Mul(Call(sin; \\alpha), Call(sin; \\gamma))), Add(Mul(Call(sin; \\alpha), Call(sin; \\beta), Call(cos; \\gamma)), Neg(Mul(Call(cos; \\alpha), Call(sin; \\gamma)))), Mul(Call(cos; \\beta), Call(cos; \\gamma))); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "\\boldsymbol{v}' = \\dot{x}\\boldsymbol{i},\\quad \\boldsymbol{a}' = \\ddot{x}\\boldsymbol{i}",
        "System(Chain(\\boldsymbol{v}', Mul(Call(\\dot{x}), \\boldsymbol{i}); =), Chain(\\boldsymbol{a}', Mul(Call(\\ddot{x}), \\boldsymbol{i}); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter7.tex",
    ),
    (
        "z_p = \\begin{cases} 0 & \\bar{r}^{P/O} \\cdot \\hat{n}_z > 0 \\\\ \\bar{r}^{P/O} \\cdot \\hat{n}_z & \\bar{r}^{P/O} \\cdot \\hat{n}_z \\leq 0 \\end{cases}",
        "Chain(z_p, Piecewise(0, Chain(Mul(\\bar { r } ^ { P / O }, \\hat{n}_z; 1), 0; >), Mul(\\bar { r } ^ { P / O }, \\hat{n}_z; 1), Chain(Mul(\\bar { r } ^ { P / O }, \\hat{n}_z; 1), 0; \\le)); =)",
        "moorepants/learn-multibody-dynamics/loads.rst",
    ),
    (
        "{\\bf b}[n+1] = {\\bf T}({\\bf a}[n]) {\\bf b}[n].",
        "Chain(Indexed(\\mathbf{b}; Add(n, 1)), Mul(Call(\\mathbf{T}; Indexed(\\mathbf{a}; n)), Indexed(\\mathbf{b}; n)); =)",
        "RussTedrake/underactuated/book/stochastic.html",
    ),
    (
        "\\mathbf{\\bar g} = (a_1[r,s,t,u] + s \\cdot a_4[r,s,t,u]) \\mathbf{\\hat i} + (a_2[r,s,t,u] + t \\cdot a_4[r,s,t,u]) \\mathbf{\\hat j} + (a_3[r,s,t,u] + u \\cdot a_4[r,s,t,u]) \\mathbf{\\hat k}",
        "Chain(\\mathbf{\\bar{g}}, Add(Mul(Add(Indexed(a_1; r, s, t, u), Mul(s, Indexed(a_4; r, s, t, u))), \\mathbf{\\hat{i}}), Mul(Add(Indexed(a_2; r, s, t, u), Mul(t, Indexed(a_4; r, s, t, u))), \\mathbf{\\hat{j}}), Mul(Add(Indexed(a_3; r, s, t, u), Mul(u, Indexed(a_4; r, s, t, u))), \\mathbf{\\hat{k}})); =)",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/spacecraftPointing/_Documentation/example/secModelDescription.tex",
    ),
    (
        "p_\\theta\\mathrm{d} \\theta = \\beta\\mathrm{d} \\varTheta - p_\\phi\\mathrm{d} \\phi",
        "Chain(Mul(p_\\theta, Total(\\theta)), Add(Mul(\\beta, Total(\\varTheta)), Neg(Mul(p_\\phi, Total(\\phi)))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\dot{X}(t) = \\begin{bmatrix} -\\frac{R}{L} & -\\frac{1}{L} \\\\ \\frac{1}{C} & 0 \\end{bmatrix} \\begin{bmatrix} x_1(t) \\\\ x_2(t) \\end{bmatrix} + \\begin{bmatrix} \\frac{1}{L} \\\\ 0 \\end{bmatrix} v_{in}(t)",
        "Chain(Call(\\dot{X}; t), Add(Mul(MatrixOf(Neg(Div(R; L)), Neg(Div(1; L)), Div(1; C), 0), MatrixOf(Call(x_1; t), Call(x_2; t))), Mul(MatrixOf(Div(1; L), 0), Call(v_{in}; t))); =)",
        "sympy/sympy/doc/src/tutorials/physics/control/electrical_problems.rst",
    ),
    (
        "\\begin{cases} x - R\\theta\\cos \\phi_0 + C_1 = 0 \\\\ y - R\\theta\\sin \\phi_0 + C_2 = 0 \\end{cases}",
        "System(Chain(Add(x, Neg(Mul(R, \\theta, Call(cos; \\phi_0))), C_1), 0; =), Chain(Add(y, Neg(Mul(R, \\theta, Call(sin; \\phi_0))), C_2), 0; =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/analytical-mechanics/Constraint.tex",
    ),
    (
        "{\\bf M}({\\bf q}) = \\begin{bmatrix} m_c + m_p & m_p l \\cos\\theta \\\\ m_p l \\cos\\theta & m_p l^2 \\end{bmatrix}, \\quad {\\bf C}({\\bf q},\\dot{{\\bf q}}) = \\begin{bmatrix} 0 & -m_p l \\dot\\theta \\sin\\theta \\\\ 0 & 0 \\end{bmatrix}, \\\\ {\\bf \\tau}_g({\\bf q}) = \\begin{bmatrix} 0 \\\\ - m_p gl \\sin\\theta \\end{bmatrix}, \\quad {\\bf B} = \\begin{bmatrix} 1 \\\\ 0 \\end{bmatrix}",
        "System(Chain(Call(\\mathbf{M}; Call(\\mathbf{q})), MatrixOf(Add(m_c, m_p), Mul(m_p, l, Call(cos; Call(\\theta))), Mul(m_p, l, Call(cos; Call(\\theta))), Mul(m_p, Pow(l; 2))); =), Chain(Call(\\mathbf{C}; Call(\\mathbf{q}), Call(\\dot{\\mathbf{q}})), MatrixOf(0, Neg(Mul(m_p, l, Call(\\dot{\\theta}), Call(sin; Call(\\theta)))), 0, 0); =), Chain(Call(\\mathbf{\\tau}_g; Call(\\mathbf{q})), MatrixOf(0, Neg(Mul(m_p, g, l, Call(sin; Call(\\theta))))); =), Chain(\\mathbf{B}, MatrixOf(1, 0); =))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\alpha = \\frac{1}{1 + \\left(\\frac{1-x}{x}\\right)\\frac{\\rho_g}{\\rho_l}}",
        "Chain(\\alpha, Div(1; Add(1, Mul(Div(Add(1, Neg(x)); x), Div(\\rho_g; \\rho_l)))); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "L = \\begin{bmatrix} 1 & 0 & 0 & \\cdots & 0 & 0 & \\cdots & 0 \\\\ L_{1, 0} & 1 & 0 & \\cdots & 0 & 0 & \\cdots & 0 \\\\ L_{2, 0} & L_{2, 1} & 1 & \\cdots & 0 & 0 & \\cdots & 0 \\\\ \\vdots & \\vdots & \\vdots & \\ddots & \\vdots & \\vdots & \\ddots & \\vdots \\\\ L_{n-1, 0} & L_{n-1, 1} & L_{n-1, 2} & \\cdots & 1 & 0 & \\cdots & 0 \\\\ L_{n, 0} & L_{n, 1} & L_{n, 2} & \\cdots & L_{n, n-1} & 1 & \\cdots & 0 \\\\ \\vdots & \\vdots & \\vdots & \\ddots & \\vdots & \\vdots & \\ddots & \\vdots \\\\ L_{m-1, 0} & L_{m-1, 1} & L_{m-1, 2} & \\cdots & L_{m-1, n-1} & 0 & \\cdots & 1 \\\\ \\end{bmatrix}",
        "Chain(L, MatrixOf(1, 0, 0, Dots(), 0, 0, Dots(), 0, L_{1,0}, 1, 0, Dots(), 0, 0, Dots(), 0, L_{2,0}, L_{2,1}, 1, Dots(), 0, 0, Dots(), 0, Dots(), Dots(), Dots(), Dots(), Dots(), Dots(), Dots(), Dots(), L_{n-1,0}, L_{n-1,1}, L_{n-1,2}, Dots(), 1, 0, Dots(), 0, L_{n,0}, L_{n,1}, L_{n,2}, Dots(), L_{n,n-1}, 1, Dots(), 0, Dots(), Dots(), Dots(), Dots(), Dots(), Dots(), Dots(), Dots(), L_{m-1,0}, L_{m-1,1}, L_{m-1,2}, Dots(), L_{m-1,n-1}, 0, Dots(), 1); =)",
        "sympy/sympy/sympy/matrices/decompositions.py",
    ),
    (
        "\\lim_{x \\to 0} ~x \\frac{Q(x)}{P(x)} = \\lim_{x \\to 0} ~x \\frac{(1+x)}{x^2} = \\lim_{x \\to 0} ~\\frac{1+x}{x} = \\text{DNE}.",
        "Chain(Limiting(lim; _{ x \\to 0 }; Mul(x, Div(Call(Q; x); Call(P; x)))), Limiting(lim; _{ x \\to 0 }; Mul(x, Div(Add(1, x); Pow(x; 2)))), Limiting(lim; _{ x \\to 0 }; Div(Add(1, x); x)), \\text{DNE}; =, =, =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "\\begin{cases} \\displaystyle \\omega_1 = \\frac{La}{I_1}\\sqrt{\\frac{I_3}{I_2}-1} \\sin (\\omega_0t+\\phi_0) \\\\ \\displaystyle \\omega_2 = \\frac{La}{I_2}\\sqrt{\\frac{I_3}{I_1}-1} \\sin (\\omega_0t+\\phi_0) \\\\ \\displaystyle \\omega_3 = \\varOmega \\end{cases}",
        "System(Chain(\\omega_1, Mul(Div(Mul(L, a); I_1), Sqrt(Add(Div(I_3; I_2), Neg(1))), Call(sin; Add(Mul(\\omega_0, t), \\phi_0))); =), Chain(\\omega_2, Mul(Div(Mul(L, a); I_2), Sqrt(Add(Div(I_3; I_1), Neg(1))), Call(sin; Add(Mul(\\omega_0, t), \\phi_0))); =), Chain(\\omega_3, \\varOmega; =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "{\\bf T}_t = m_T [ {\\bf u} - {\\bf F}_c (1/m_T + 1/m_D)]",
        "Chain(\\mathbf{T}_t, Mul(m_T, Add(\\mathbf{u}, Neg(Mul(\\mathbf{F}_c, Add(Div(1; m_T), Div(1; m_D)))))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/etSphericalControl/etSphericalControl.rst",
    ),
    (
        "\\begin{aligned} \\int 0 dt &= \\int \\frac{d}{dt} \\left(\\frac{v^2}{2}\\right) dt - \\int \\frac{d}{dt}\\left(\\frac{\\mu}{r}\\right) dt \\\\ E &= \\frac{v^2}{2} + \\left(C - \\frac{\\mu}{r}\\right) \\end{aligned}",
        "System(Chain(Antiderivative(0; t), Add(Antiderivative(Derivative(Div(Pow(Call(v); 2); 2); t, 1); t), Neg(Antiderivative(Derivative(Div(Call(\\mu); Call(r)); t, 1); t))); =), Chain(E, Add(Div(Pow(Call(v); 2); 2), Add(C, Neg(Div(Call(\\mu); Call(r))))); =))",
        "bryanwweber/orbital-mechanics-notes/constants-of-orbital-motion/energy-is-conserved-in-orbital-motion.md",
    ),
    (
        "\\dot{y}=vsin\\theta",
        "Chain(Call(\\dot{y}), Mul(v, Call(sin; \\theta)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/cgmres_nmpc/cgmres_nmpc_main.rst",
    ),
    (
        "\\gamma(s, x) := \\int_0^x t^{s-1} e^{-t} \\mathrm{d}t = \\Gamma(s) - \\Gamma(s, x).",
        "Chain(Call(\\gamma; s, x), Integral(Mul(Pow(t; Add(s, Neg(1))), Pow(e; Neg(t))); t; 0; x), Add(Call(Gamma; s), Neg(Call(Gamma; s, x))); =, =)",
        "sympy/sympy/sympy/functions/special/gamma_functions.py",
    ),
    (
        "\\boxed{\\mathbf{q}_t^- = \\Phi_t \\mathbf{q}_{t-1} + \\xi_t}",
        "Chain(\\mathbf { q } _ { t } ^ { - }, Add(Mul(\\Phi_t, \\mathbf{q}_{t-1}), \\xi_t); =)",
        "Mayitzin/ahrs/ahrs/filters/fkf.py",
    ),
    (
        "H2 &= \\frac{2 \\cdot (6 + s)}{1 + s}",
        "Chain(\\text{H2}, Div(Mul(2, Add(6, s)); Add(1, s)); =)",
        "sympy/sympy/doc/src/tutorials/physics/control/control_problems.rst",
    ),
    (
        "S = \\frac{1}{1 + P C}, \\qquad T = \\frac{P C}{1 + P C}",
        "System(Chain(S, Div(1; Add(1, Mul(P, C))); =), Chain(T, Div(Mul(P, C); Add(1, Mul(P, C))); =))",
        "python-control/python-control/doc/xferfcn.rst",
    ),
    (
        "\\begin{split} 0 = y''-y & = \\Biggl( \\sum_{k=0}^\\infty (k+2)\\,(k+1) \\, a_{k+2} x^k \\Biggr) - \\Biggl( \\sum_{k=0}^\\infty a_k x^k \\Biggr) \\\\ & = \\sum_{k=0}^\\infty \\,\\Bigl( (k+2)\\,(k+1) \\, a_{k+2} x^k - a_k x^k \\Bigr) \\\\ & = \\sum_{k=0}^\\infty \\,\\bigl( (k+2)\\,(k+1) \\,a_{k+2} - a_k \\bigr) \\, x^k . \\end{split}",
        "Chain(0, Add(y'', Neg(y)), Add(BigSum(k; 0; Infinity(); Mul(Add(k, 2), Add(k, 1), a_{k+2}, Pow(x; k))), Neg(BigSum(k; 0; Infinity(); Mul(a_k, Pow(x; k))))), BigSum(k; 0; Infinity(); Add(Mul(Add(k, 2), Add(k, 1), a_{k+2}, Pow(x; k)), Neg(Mul(a_k, Pow(x; k))))), BigSum(k; 0; Infinity(); Mul(Add(Mul(Add(k, 2), Add(k, 1), a_{k+2}), Neg(a_k)), Pow(x; k))); =, =, =, =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "r = \\frac{p}{1 + e \\cos f}",
        "Chain(r, Div(p; Add(1, Mul(e, Call(cos; f)))); =)",
        "AVSLab/basilisk/src/architecture/utilitiesSelfCheck/_Documentation/secModelDescription.tex",
    ),
    (
        "\\bar{v}_r = \\frac{\\partial \\bar{v}}{\\partial u_r} \\\\ \\bar{\\omega}_r = \\frac{\\partial \\bar{\\omega}}{\\partial u_r}",
        "System(Chain(\\bar{v}_r, Derivative(Call(\\bar{v}); u_r, 1; True); =), Chain(\\bar{\\omega}_r, Derivative(Call(\\bar{\\omega}); u_r, 1; True); =))",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "\\boldsymbol{x}(t_{k+1}) = \\boldsymbol{x}(t_k) + \\int_{t_k}^{t_{k+1}} \\dot{\\boldsymbol{x}}(\\tau)\\,\\mathrm{d}\\tau",
        "Chain(Call(\\boldsymbol{x}; t_{k+1}), Add(Call(\\boldsymbol{x}; t_k), Integral(Call(\\dot{\\boldsymbol{x}}; \\tau); \\tau; t_k; t_{k+1})); =)",
        "JSBSim-Team/jsbsim-reference-manual/docs/formulation/state-propagation-contract.md",
    ),
    (
        "\\frac{\\mathrm{d}\\boldsymbol{A}}{\\mathrm{d}t} = \\boldsymbol{0}",
        "Chain(Derivative(Call(\\boldsymbol{A}); t, 1), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "|u_a| \\leq u_{a,max}",
        "Chain(Bars(u_a), u_{a,max}; \\le)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/cgmres_nmpc/cgmres_nmpc_main.rst",
    ),
    (
        "\\begin{aligned} \\boldsymbol{r} &= \\boldsymbol{R}_2 - \\boldsymbol{R}_1\\\\ \\boldsymbol{r} &= \\left(X_2 - X_1\\right)\\boldsymbol{\\hat{I}} + \\left(Y_2 - Y_1\\right)\\boldsymbol{\\hat{J}} + \\left(Z_2 - Z_1\\right)\\boldsymbol{\\hat{K}} \\end{aligned}",
        "System(Chain(\\boldsymbol{r}, Add(\\boldsymbol{R}_2, Neg(\\boldsymbol{R}_1)); =), Chain(\\boldsymbol{r}, Add(Mul(Add(X_2, Neg(X_1)), \\boldsymbol{\\hat{I}}), Mul(Add(Y_2, Neg(Y_1)), \\boldsymbol{\\hat{J}}), Mul(Add(Z_2, Neg(Z_1)), \\boldsymbol{\\hat{K}})); =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-inertial-motion.md",
    ),
    (
        "C_3 = v_{\\infty}^2",
        "Chain(C_3, Pow(v_\\infty; 2); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/hyperbolic-trajectories.md",
    ),
    (
        "\\operatorname{Bi}(z) = \\frac{1}{2 \\sqrt{\\pi} z^{1/4}} [2X - iY]",
        "Chain(Call(\\text{Bi}; z), Mul(Div(1; Mul(2, Sqrt(\\pi), Pow(z; Div(1; 4)))), Add(Mul(2, X), Neg(Mul(i, Y)))); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "{\\bf u}_{k-1} = {\\bf u}_k + \\frac{\\sigma_{k-1} - \\sigma_k}{\\sigma_k}\\left[{\\bf u}_k + {\\bf K}{\\bf x}\\right],",
        "Chain(\\mathbf{u}_{k-1}, Add(\\mathbf{u}_k, Mul(Div(Add(\\sigma_{k-1}, Neg(\\sigma_k)); \\sigma_k), Add(\\mathbf{u}_k, Mul(\\mathbf{K}, \\mathbf{x})))); =)",
        "RussTedrake/underactuated/book/imitation.html",
    ),
    (
        "\\boldsymbol{M}_O = \\boldsymbol{r}\\times\\boldsymbol{F} = \\boldsymbol{r}\\times m\\boldsymbol{a} = \\boldsymbol{r}\\times m\\frac{d\\boldsymbol{v}}{dt}",
        "Chain(\\boldsymbol{M}_O, Cross(\\boldsymbol{r}; \\boldsymbol{F}), Cross(\\boldsymbol{r}; Mul(m, \\boldsymbol{a})), Cross(\\boldsymbol{r}; Mul(m, Derivative(Call(\\boldsymbol{v}); t, 1))); =, =, =)",
        "bryanwweber/orbital-mechanics-notes/intro/force-acceleration-and-momentum.md",
    ),
    (
        "y = h({\\bf q}) = -l \\cos\\theta \\\\ \\dot{y} = l \\dot\\theta \\sin\\theta",
        "System(Chain(Call(y), Call(h; \\mathbf{q}), Neg(Mul(l, Call(cos; Call(\\theta)))); =, =), Chain(Call(\\dot{y}), Mul(l, Call(\\dot{\\theta}), Call(sin; Call(\\theta))); =))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\kappa=(\\delta-A) / L",
        "Chain(\\kappa, Div(Add(\\delta, Neg(A)); L); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/clothoid_path/clothoid_path_main.rst",
    ),
    (
        "K_2 = N\\cdot f_d",
        "Chain(K_2, Mul(N, f_d); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "a0 = \\frac{\\tanh{\\left(b \\left(e - a\\right) \\right)}}{2}",
        "Chain(\\text{a0}, Div(Call(tanh; Mul(b, Add(e, Neg(a)))); 2); =)",
        "sympy/sympy/sympy/physics/biomechanics/activation.py",
    ),
    (
        "V = \\frac{\\pi D^2}{12} (3h + a ),\\;\\; h \\ge |a|",
        "System(Chain(V, Mul(Div(Mul(\\pi, Pow(D; 2)); 12), Add(Mul(3, h), a)); =), Chain(h, Bars(a); \\ge))",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\mathbf{\\Sigma}_{\\mathbf{q}_t^-} = \\Phi_t \\mathbf{\\Sigma}_{\\mathbf{q}_{t-1}} \\Phi_t^T + \\mathbf{\\Sigma}_{\\xi_t}",
        "Chain(\\mathbf{\\Sigma}_{\\mathbf q_t^-}, Add(Mul(\\Phi_t, \\mathbf{\\Sigma}_{\\mathbf q_t-1}, Transpose(\\Phi_t)), \\mathbf{\\Sigma}_{\\xi_t}); =)",
        "Mayitzin/ahrs/ahrs/filters/fkf.py",
    ),
    (
        "f(x) = C-\\frac{2\\pi^2 k}{mg}(x-a)^2",
        "Chain(Call(f; x), Add(C, Neg(Mul(Div(Mul(2, Pow(\\pi; 2), k); Mul(m, g)), Pow(Add(x, Neg(a)); 2)))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "F_{1,B}^B + F_{2,B}^B + F_{g,B}^B = 0,",
        "Chain(Add(F _ { 1 , B } ^ { B }, F _ { 2 , B } ^ { B }, F _ { g , B } ^ { B }), 0; =)",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "\\theta_4(z,\\tau) = \\sum_{n=-\\infty}^{\\infty} (-1)^n \\exp(\\pi i [n^2 \\tau + 2n z]) = 1 + 2 \\sum_{n=1}^{\\infty} (-1)^n q^{n^2} \\cos(2n \\pi z)",
        "Chain(Call(\\theta_4; z, \\tau), BigSum(n; Neg(Infinity()); Infinity(); Mul(Pow(Neg(1); n), Call(exp; Mul(\\pi, i, Add(Mul(Pow(n; 2), \\tau), Mul(2, n, z)))))), Add(1, Mul(2, BigSum(n; 1; Infinity(); Mul(Pow(Neg(1); n), Pow(q; Pow(n; 2)), Call(cos; Mul(2, n, \\pi, z)))))); =, =)",
        "fredrik-johansson/arb/doc/source/acb_modular.rst",
    ),
    (
        "\\frac{^{\\mathbf{B}} d \\mathbf{c}}{dt} &= \\frac{dx}{dt} \\mathbf{\\hat{b}_x} + \\frac{dl}{dt} \\mathbf{\\hat{b}_y}\\\\ &= \\dot{x} \\mathbf{\\hat{b}_x}",
        "Chain(Marked(Derivative(Call(\\mathbf{c}); t, 1); _{ \\mathbf { B } }), Add(Mul(Derivative(Call(x); t, 1), \\mathbf{\\hat{b}}_x), Mul(Derivative(Call(l); t, 1), \\mathbf{\\hat{b}}_y)), Mul(Call(\\dot{x}), \\mathbf{\\hat{b}}_x); =, =)",
        "sympy/sympy/doc/src/explanation/modules/physics/vector/vectors/vectors.rst",
    ),
    (
        "\\bar{v} = (\\bar{v} \\cdot \\hat{a}_x) \\hat{a}_x + (\\bar{v} \\cdot \\hat{a}_y) \\hat{a}_y + (\\bar{v} \\cdot \\hat{a}_z) \\hat{a}_z",
        "Chain(\\bar{v}, Add(Mul(Mul(\\bar{v}, \\hat{a}_x; 1), \\hat{a}_x), Mul(Mul(\\bar{v}, \\hat{a}_y; 1), \\hat{a}_y), Mul(Mul(\\bar{v}, \\hat{a}_z; 1), \\hat{a}_z)); =)",
        "moorepants/learn-multibody-dynamics/vectors.rst",
    ),
    (
        "\\epsilon = 1 - (0.351 + 0.256\\beta^4 + 0.93\\beta^8) \\left[1-\\left(\\frac{P_2}{P_1}\\right)^{1/\\kappa}\\right]",
        "Chain(\\epsilon, Add(1, Neg(Mul(Add(0.351, Mul(0.256, Pow(\\beta; 4)), Mul(0.93, Pow(\\beta; 8))), Add(1, Neg(Pow(Div(P_2; P_1); Div(1; \\kappa))))))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "\\mathcal{L} = T - V = \\frac{1}{2}mR^2\\left(\\dot{\\theta}^2 + \\sin^2\\theta \\cdot \\dot{\\phi}^2\\right) - \\frac{1}{2}k(L_{total}(\\theta, \\phi) - L_0)^2",
        "Chain(\\mathcal{L}, Add(T, Neg(V)), Add(Mul(Div(1; 2), m, Pow(R; 2), Add(Pow(Call(\\dot{\\theta}); 2), Mul(Pow(Call(sin; Call(\\theta)); 2), Pow(Call(\\dot{\\phi}); 2)))), Neg(Mul(Div(1; 2), k, Pow(Add(Call(L_{total}; Call(\\theta), Call(\\phi)), Neg(L_0)); 2)))); =, =)",
        "sympy/sympy/doc/src/tutorials/physics/mechanics/muscle_model_example.rst",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{a} &=& \\frac{1}{\\sqrt{a_x^2+a_y^2+a_z^2}} \\begin{bmatrix}a_x & a_y & a_z\\end{bmatrix}^T \\\\ && \\\\ \\mathbf{m} &=& \\frac{1}{\\sqrt{m_x^2+m_y^2+m_z^2}} \\begin{bmatrix}m_x & m_y & m_z\\end{bmatrix}^T \\end{array}",
        "System(Chain(\\mathbf{a}, Mul(Div(1; Sqrt(Add(Pow(a_x; 2), Pow(a_y; 2), Pow(a_z; 2)))), Transpose(MatrixOf(a_x, a_y, a_z))); =), Chain(\\mathbf{m}, Mul(Div(1; Sqrt(Add(Pow(m_x; 2), Pow(m_y; 2), Pow(m_z; 2)))), Transpose(MatrixOf(m_x, m_y, m_z))); =))",
        "Mayitzin/ahrs/ahrs/filters/ekf.py",
    ),
    (
        "\\mathbf{A} = \\begin{bmatrix} 0 & 1 \\\\ -\\frac{k}{m} & -\\frac{b}{m} \\end{bmatrix}, \\quad \\mathbf{B} = \\begin{bmatrix} 0 \\\\ \\frac{1}{m} \\end{bmatrix}, \\quad \\mathbf{C} = \\begin{bmatrix} 1 & 0 \\end{bmatrix}",
        "System(Chain(\\mathbf{A}, MatrixOf(0, 1, Neg(Div(k; m)), Neg(Div(b; m))); =), Chain(\\mathbf{B}, MatrixOf(0, Div(1; m)); =), Chain(\\mathbf{C}, MatrixOf(1, 0); =))",
        "sympy/sympy/doc/src/tutorials/physics/control/mechanics_problems.rst",
    ),
    (
        "\\varepsilon_3(a,b,c,d) &= \\exp(\\pi i [-R(a,b,c,d) + (4+(c-d-2)(b-a))] / 4)",
        "Chain(Call(\\varepsilon_3; a, b, c, d), Call(exp; Div(Mul(\\pi, i, Add(Neg(Call(R; a, b, c, d)), Add(4, Mul(Add(c, Neg(d), Neg(2)), Add(b, Neg(a)))))); 4)); =)",
        "fredrik-johansson/arb/doc/source/acb_modular.rst",
    ),
    (
        "\\begin{aligned} {}_I\\hat{\\mbox{\\boldmath $\\omega$}}_{I\\!Q} \\cdot \\mathbf C_{I\\!Q} &= {}_I\\hat{\\mbox{\\boldmath $\\omega$}}_{I\\!B} \\cdot \\mathbf C_{I\\!B} \\cdot \\mathbf C_{B\\!Q} + \\mathbf C_{I\\!B} \\cdot {}_B\\hat{\\mbox{\\boldmath $\\omega$}}_{B\\!Q} \\cdot \\mathbf C_{B\\!Q} \\\\ &= {}_I\\hat{\\mbox{\\boldmath $\\omega$}}_{I\\!B} \\cdot \\mathbf C_{I\\!Q} + \\mathbf C_{I\\!B} \\cdot \\mathbf C_{B\\!I} \\cdot {}_I\\hat{\\mbox{\\boldmath $\\omega$}}_{B\\!Q} \\cdot \\mathbf C_{B\\!I}^\\mathsf{T} \\cdot \\mathbf C_{B\\!Q} \\\\ &= {}_I\\hat{\\mbox{\\boldmath $\\omega$}}_{I\\!B} \\cdot \\mathbf C_{I\\!Q} + {}_I\\hat{\\mbox{\\boldmath $\\omega$}}_{B\\!Q} \\cdot \\mathbf C_{I\\!Q}, \\end{aligned}",
        "Chain(Mul(\\prescript { } { I } { \\hat { \\boldsymbol { \\omega } } } _ { I \\! Q }, \\mathbf{C}_{I\\!Q}), Add(Mul(\\prescript { } { I } { \\hat { \\boldsymbol { \\omega } } } _ { I \\! B }, \\mathbf{C}_{I\\!B}, \\mathbf{C}_{B\\!Q}), Mul(\\mathbf{C}_{I\\!B}, \\prescript { } { B } { \\hat { \\boldsymbol { \\omega } } } _ { B \\! Q }, \\mathbf{C}_{B\\!Q})), Add(Mul(\\prescript { } { I } { \\hat { \\boldsymbol { \\omega } } } _ { I \\! B }, \\mathbf{C}_{I\\!Q}), Mul(\\mathbf{C}_{I\\!B}, \\mathbf{C}_{B\\!I}, \\prescript { } { I } { \\hat { \\boldsymbol { \\omega } } } _ { B \\! Q }, Transpose(\\mathbf{C}_{B\\!I}), \\mathbf{C}_{B\\!Q})), Add(Mul(\\prescript { } { I } { \\hat { \\boldsymbol { \\omega } } } _ { I \\! B }, \\mathbf{C}_{I\\!Q}), Mul(\\prescript { } { I } { \\hat { \\boldsymbol { \\omega } } } _ { B \\! Q }, \\mathbf{C}_{I\\!Q})); =, =, =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "\\boldsymbol{F}=\\begin{pmatrix} F_x \\\\ F_y \\\\ F_z \\end{pmatrix},\\quad \\boldsymbol{M}_O=\\begin{pmatrix} M_x \\\\ M_y \\\\ M_z \\end{pmatrix},\\quad \\boldsymbol{R}=\\begin{pmatrix} R_x \\\\ R_y \\\\ R_z \\end{pmatrix},\\quad \\boldsymbol{R}_1=\\begin{pmatrix} R_{1x} \\\\ R_{1y} \\\\ R_{1z} \\end{pmatrix},\\quad \\boldsymbol{L}_O=\\begin{pmatrix} L_x \\\\ L_y \\\\ L_z \\end{pmatrix}",
        "System(Chain(\\boldsymbol{F}, MatrixOf(F_x, F_y, F_z); =), Chain(\\boldsymbol{M}_O, MatrixOf(M_x, M_y, M_z); =), Chain(\\boldsymbol{R}, MatrixOf(R_x, R_y, R_z); =), Chain(\\boldsymbol{R}_1, MatrixOf(R_{1x}, R_{1y}, R_{1z}); =), Chain(\\boldsymbol{L}_O, MatrixOf(L_x, L_y, L_z); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "T_{\\text{phasing}} = t_{137.2°} + n T_{\\text{one orbit}}",
        "Chain(T_{phasing}, Add(t_{137.2^\\circ}, Mul(n, T_{one~orbit})); =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/phasing-maneuvers.md",
    ),
    (
        "\\delta \\approx 0",
        "Chain(\\delta, 0; \\approx)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/lqr_speed_and_steering_control/lqr_speed_and_steering_control_main.rst",
    ),
    (
        "x[n+1] &= Ax[n] + Bu[n] + Gw[n] \\\\ y[n] &= Cx[n] + Du[n] + v[n]",
        "System(Chain(Indexed(x; Add(n, 1)), Add(Mul(A, Indexed(x; n)), Mul(B, Indexed(u; n)), Mul(G, Indexed(w; n))); =), Chain(Indexed(y; n), Add(Mul(C, Indexed(x; n)), Mul(D, Indexed(u; n)), Indexed(v; n)); =))",
        "python-control/python-control/control/stochsys.py",
    ),
    (
        "\\boldsymbol{M} = \\begin{pmatrix} m_1+m_2 & -m_2l \\\\ -m_2l & m_2l^2 \\end{pmatrix},\\quad \\boldsymbol{K} = \\begin{pmatrix} k & 0 \\\\ 0 & m_2gl \\end{pmatrix}",
        "System(Chain(\\boldsymbol{M}, MatrixOf(Add(m_1, m_2), Neg(Mul(m_2, l)), Neg(Mul(m_2, l)), Mul(m_2, Pow(l; 2))); =), Chain(\\boldsymbol{K}, MatrixOf(k, 0, 0, Mul(m_2, g, l)); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "\\tau = \\sqrt{\\frac{(I_2-I_1)(2I_3T-L^2)}{I_1I_2I_3}}t,\\quad s = \\sqrt{\\frac{I_2(I_2-I_1)}{L^2-2I_1T}}\\omega_2",
        "System(Chain(\\tau, Mul(Sqrt(Div(Mul(Add(I_2, Neg(I_1)), Add(Mul(2, I_3, T), Neg(Pow(L; 2)))); Mul(I_1, I_2, I_3))), t); =), Chain(s, Mul(Sqrt(Div(Mul(I_2, Add(I_2, Neg(I_1))); Add(Pow(L; 2), Neg(Mul(2, I_1, T))))), \\omega_2); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "2y(x+1) = 2xy + A'(y) .",
        "Chain(Mul(2, y, Add(x, 1)), Add(Mul(2, x, y), Call(A'; y)); =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\begin{aligned} \\boldsymbol{F}_{12} &= m_1\\ddot{\\boldsymbol{R}}_1 \\\\ \\boldsymbol{F}_{21} &= m_2\\ddot{\\boldsymbol{R}}_2 \\end{aligned}",
        "System(Chain(\\boldsymbol{F}_{12}, Mul(m_1, Call(\\ddot{\\boldsymbol{R}}_1)); =), Chain(\\boldsymbol{F}_{21}, Mul(m_2, Call(\\ddot{\\boldsymbol{R}}_2)); =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-inertial-motion.md",
    ),
    (
        "y(t) = v_2(t) = x_2(t)",
        "Chain(Call(y; t), Call(v_2; t), Call(x_2; t); =, =)",
        "sympy/sympy/doc/src/tutorials/physics/control/electrical_problems.rst",
    ),
    (
        "x^2 + y^2 = l^2",
        "Chain(Add(Pow(x; 2), Pow(y; 2)), Pow(l; 2); =)",
        "moorepants/learn-multibody-dynamics/configuration.rst",
    ),
    (
        "u_t = [\\delta_t, a_t]^T",
        "Chain(u_t, Transpose(Tuple(\\delta_t, a_t; [])); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/lqr_speed_and_steering_control/lqr_speed_and_steering_control_main.rst",
    ),
    (
        "xv' = v^2+v-v = v^2 ,",
        "Chain(Mul(x, v'), Add(Pow(v; 2), v, Neg(v)), Pow(v; 2); =, =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "f(x) := \\frac{1}{\\Gamma(k) \\theta^k} x^{k - 1} e^{-\\frac{x}{\\theta}}",
        "Chain(Call(f; x), Mul(Div(1; Mul(Call(Gamma; k), Pow(\\theta; k))), Pow(x; Add(k, Neg(1))), Pow(e; Neg(Div(x; \\theta)))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "C = 0.9858 - 0.196\\beta^{4.5}",
        "Chain(C, Add(0.9858, Neg(Mul(0.196, Pow(\\beta; 4.5)))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "y(x) = C_1 e^{kx} + C_2 e^{-kx} ,",
        "Chain(Call(y; x), Add(Mul(C_1, Pow(e; Mul(k, x))), Mul(C_2, Pow(e; Neg(Mul(k, x))))); =)",
        "jirilebl/diffyqs/ch-intro.tex",
    ),
    (
        "f(t) = \\frac{\\pi}{2} + \\sum_{k=1}^\\infty \\frac{2}{2k-1} \\sin \\bigl( (2k-1)\\, t \\bigr) .",
        "Chain(Call(f; t), Add(Div(\\pi; 2), BigSum(k; 1; Infinity(); Mul(Div(2; Add(Mul(2, k), Neg(1))), Call(sin; Mul(Add(Mul(2, k), Neg(1)), t))))); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "J_2 \\ddot{\\theta}_2 + (B_{r2} + B_{r1}) \\dot{\\theta}_2 - B_{r1} \\dot{\\theta}_1 = 0",
        "Chain(Add(Mul(J_2, Call(\\ddot{\\theta}_2)), Mul(Add(B_{r2}, B_{r1}), Call(\\dot{\\theta}_2)), Neg(Mul(B_{r1}, Call(\\dot{\\theta}_1)))), 0; =)",
        "sympy/sympy/doc/src/tutorials/physics/control/mechanics_problems.rst",
    ),
    (
        "\\boldsymbol{F} = -kmg\\boldsymbol{u}",
        "Chain(\\boldsymbol{F}, Neg(Mul(k, m, g, \\boldsymbol{u})); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "\\dot{\\theta}_t = \\frac{V}{L} \\tan(\\delta)",
        "Chain(Call(\\dot{\\theta}_t), Mul(Div(V; L), Call(tan; \\delta)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/lqr_speed_and_steering_control/lqr_speed_and_steering_control_main.rst",
    ),
    (
        "m_{\\text{sp}_i} d_i \\ddot{y}_{B/N} + \\left( I_{s_{i,2}} + m_{\\text{sp}_i} d_i^{2} \\right) \\ddot \\theta_i = - k_i \\theta_i - c_i \\dot\\theta_i",
        "Chain(Add(Mul(m_{sp_i}, d_i, Call(\\ddot{y}_{B/N})), Mul(Add(I_{s_i,2}, Mul(m_{sp_i}, Pow(d_i; 2))), Call(\\ddot{\\theta}_i))), Add(Neg(Mul(k_i, Call(\\theta_i))), Neg(Mul(c_i, Call(\\dot{\\theta}_i)))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/HingedRigidBodies/_Documentation/secTest.tex",
    ),
    (
        "Q^-_{n,k} &=& \\left[Q^-_{n-1,k}+z_n\\,\\tilde V_{n,k}\\right]\\,e^{-c_{k//2}\\,(t_{n+1}-t_{n})},\\\\ X^-_{m,n,k} &=& e^{-c_{k//2}\\,(t_m^*-t_{n+1})}\\,\\tilde U_{m,k}^*,\\\\ Q^+_{n,k} &=& \\left[Q^+_{n+1,k}+z_n\\,\\tilde U_{n,k}\\right]\\,e^{-c_{k//2}(t_{n}-t_{n-1})},\\\\ X^+_{m,n,k} &=& e^{-c_{k//2}\\,(t_{n-1}-t_m^*)}\\,\\tilde V_{m,k}^* \\quad,",
        "System(Chain(Q _ { n , k } ^ { - }, Mul(Add(Q _ { n - 1 , k } ^ { - }, Mul(z_n, \\tilde{V}_{n,k})), Pow(e; Neg(Mul(c_{k//2}, Add(t_{n+1}, Neg(t_n)))))); =), Chain(X _ { m , n , k } ^ { - }, Mul(Pow(e; Neg(Mul(c_{k//2}, Add(t _ { m } ^ { * }, Neg(t_{n+1}))))), \\tilde { U } _ { m , k } ^ { * }); =), Chain(Q _ { n , k } ^ { + }, Mul(Add(Q _ { n + 1 , k } ^ { + }, Mul(z_n, \\tilde{U}_{n,k})), Pow(e; Neg(Mul(c_{k//2}, Add(t_n, Neg(t_{n-1})))))); =), Chain(X _ { m , n , k } ^ { + }, Mul(Pow(e; Neg(Mul(c_{k//2}, Add(t_{n-1}, Neg(t _ { m } ^ { * }))))), \\tilde { V } _ { m , k } ^ { * }); =))",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\frac{\\mathrm{d} f}{\\mathrm{d} t} = \\frac{\\partial f}{\\partial t} + \\sum_{\\alpha=1}^s \\left(\\frac{\\partial f}{\\partial q_\\alpha} \\dot{q}_\\alpha + \\frac{\\partial f}{\\partial p_\\alpha} \\dot{p}_\\alpha\\right) = \\frac{\\partial f}{\\partial t} + \\sum_{\\alpha=1}^s \\left(\\frac{\\partial f}{\\partial q_\\alpha} \\frac{\\partial H}{\\partial p_\\alpha} - \\frac{\\partial f}{\\partial p_\\alpha} \\frac{\\partial H}{\\partial q_\\alpha}\\right)",
        "Chain(Derivative(Call(f); t, 1), Add(Derivative(Call(f); t, 1; True), BigSum(\\alpha; 1; s; Add(Mul(Derivative(Call(f); q_{\\alpha}, 1; True), Call(\\dot{q}_{\\alpha})), Mul(Derivative(Call(f); p_{\\alpha}, 1; True), Call(\\dot{p}_{\\alpha}))))), Add(Derivative(Call(f); t, 1; True), BigSum(\\alpha; 1; s; Add(Mul(Derivative(Call(f); q_{\\alpha}, 1; True), Derivative(Call(H); p_{\\alpha}, 1; True)), Neg(Mul(Derivative(Call(f); p_{\\alpha}, 1; True), Derivative(Call(H); q_{\\alpha}, 1; True)))))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "-k_{i2} \\theta_{i2} - c_{i2} \\dot{\\theta}_{i2} + \\bm{\\hat{s}}_{i2,2} \\cdot \\bm \\tau_{\\text{ext}_{i2},H_{i2}} + \\bm{\\hat{s}}_{i2,2} \\cdot \\Big[-[I_{\\text{sp}_{i2},S_{c,i2}}] \\dot{\\bm\\omega}_{\\mathcal{S}_{i2}/\\mathcal{N}} -[\\tilde{\\bm \\omega}_{\\mathcal{S}_{i2}/\\mathcal{N}}] [I_{\\text{sp}_{i2},S_{c,i2}}] \\bm \\omega_{\\mathcal{S}_{i2}/\\mathcal{N}} \\Big] \\\\ - m_{\\text{sp}_{i2}} d_{i2}\\bm{\\hat{s}}_{i2,3}^T \\ddot{\\bm{r}}_{S_{c,i2}/N} = 0",
        "Chain(Add(Neg(Mul(k_{i2}, Call(\\theta_{i2}))), Neg(Mul(c_{i2}, Call(\\dot{\\theta}_{i2}))), Mul(\\bm{\\hat{s}}_{i2,2}, \\bm{\\tau}_{ext_i2,H_i2}; 1), Mul(\\bm{\\hat{s}}_{i2,2}, Add(Neg(Mul([ I _ { \\text { s p } _ { i 2 } , S _ { c , i 2 } } ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal S _ i 2 / \\mathcal N }))), Neg(Mul([ \\tilde { \\bm { \\omega } } _ { \\mathcal { S } _ { i 2 } / \\mathcal { N } } ], [ I _ { \\text { s p } _ { i 2 } , S _ { c , i 2 } } ], Call(\\bm{\\omega}_{\\mathcal S_i2/\\mathcal N})))); 1), Neg(Mul(m_{sp_i2}, d_{i2}, Transpose(\\bm{\\hat{s}}_{i2,3}), Call(\\ddot{\\bm{r}}_{S_c,i2/N})))), 0; =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "L = x+y+\\lambda(x^2+y^2-1),",
        "Chain(L, Add(x, y, Mul(\\lambda, Add(Pow(x; 2), Pow(y; 2), Neg(1)))); =)",
        "RussTedrake/underactuated/book/optimization.html",
    ),
    (
        "\\boldsymbol{r}_1 = \\left(x - x_1\\right)\\boldsymbol{\\hat{\\imath}} + y\\boldsymbol{\\hat{\\jmath}} + z\\boldsymbol{\\hat{k}} = \\left(x + \\pi_2 r_{12}\\right)\\boldsymbol{\\hat{\\imath}} + y\\boldsymbol{\\hat{\\jmath}} + z\\boldsymbol{\\hat{k}}",
        "Chain(\\boldsymbol{r}_1, Add(Mul(Add(x, Neg(x_1)), \\boldsymbol{\\hat{\\imath}}), Mul(y, \\boldsymbol{\\hat{\\jmath}}), Mul(z, \\boldsymbol{\\hat{k}})), Add(Mul(Add(x, Mul(\\pi_2, r_{12})), \\boldsymbol{\\hat{\\imath}}), Mul(y, \\boldsymbol{\\hat{\\jmath}}), Mul(z, \\boldsymbol{\\hat{k}})); =, =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "A = \\begin{pmatrix} l \\\\ 0 \\\\ 0 \\end{pmatrix},\\quad B = \\begin{pmatrix} 0 \\\\ l \\\\ 0 \\end{pmatrix},\\quad C = \\begin{pmatrix} 0 \\\\ 0 \\\\ l \\end{pmatrix},\\quad D = \\begin{pmatrix} \\dfrac13 \\left(l-\\sqrt{3L^2-2l^2}\\right) \\\\[1.5ex] \\dfrac13 \\left(l-\\sqrt{3L^2-2l^2}\\right) \\\\[1.5ex] \\dfrac13 \\left(l-\\sqrt{3L^2-2l^2}\\right) \\end{pmatrix}",
        "System(Chain(A, MatrixOf(l, 0, 0); =), Chain(B, MatrixOf(0, l, 0); =), Chain(C, MatrixOf(0, 0, l); =), Chain(D, MatrixOf(Mul(Div(1; 3), Add(l, Neg(Sqrt(Add(Mul(3, Pow(L; 2)), Neg(Mul(2, Pow(l; 2)))))))), Mul(Div(1; 3), Add(l, Neg(Sqrt(Add(Mul(3, Pow(L; 2)), Neg(Mul(2, Pow(l; 2)))))))), Mul(Div(1; 3), Add(l, Neg(Sqrt(Add(Mul(3, Pow(L; 2)), Neg(Mul(2, Pow(l; 2))))))))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise2.tex",
    ),
    (
        "\\frac{dJ^*}{dt} = \\frac{\\partial J^*}{\\partial {\\bf x}}f({\\bf x},{\\bf u}) + \\frac{\\partial J^*}{\\partial t},",
        "Chain(Derivative(Call(J ^ { * }); t, 1), Add(Mul(Derivative(Call(J ^ { * }); \\mathbf{x}, 1; True), Call(f; \\mathbf{x}, \\mathbf{u})), Derivative(Call(J ^ { * }); t, 1; True)); =)",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "\\bm{c}=\\frac{m_{\\text{hub}}\\,\\bm{r}_{Bc/B} + \\sum_{i=1}^{M}m_{\\text{fuel}_i}\\,\\bm{r}_{Fc_i/B}}{m_{\\text{hub}}+ \\sum_{i=1}^{M}m_{\\text{fuel}_i}}",
        "Chain(\\bm{c}, Div(Add(Mul(m_{hub}, \\bm{r}_{Bc/B}), BigSum(i; 1; M; Mul(m_{fuel_i}, \\bm{r}_{Fc_i/B}))); Add(m_{hub}, BigSum(i; 1; M; m_{fuel_i}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "\\bm{r}_{P_{c,j}/B} = \\bm{r}_{P_{j}/B} + \\rho_j \\hat{\\bm p}_j",
        "Chain(\\bm{r}_{P_c,j/B}, Add(\\bm{r}_{P_j/B}, Mul(\\rho_j, \\hat{\\bm{p}}_j)); =)",
        "AVSLab/basilisk/src/simulation/dynamics/LinearSpringMassDamper/_Documentation/secModelDescription.tex",
    ),
    (
        "\\boxed{\\mathbf{K} = \\mathbf{P}_{yz} \\mathbf{P}_{zz}^{-1}}",
        "Chain(\\mathbf{K}, Mul(\\mathbf{P}_{yz}, Pow(\\mathbf{P}_{zz}; Neg(1))); =)",
        "Mayitzin/ahrs/ahrs/filters/ukf.py",
    ),
    (
        "\\dot{\\theta}_t = \\frac{V}{L} \\delta",
        "Chain(Call(\\dot{\\theta}_t), Mul(Div(V; L), \\delta); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/lqr_speed_and_steering_control/lqr_speed_and_steering_control_main.rst",
    ),
    (
        "\\bar{u}_r = \\mathbf{A}_n \\bar{u}_s + \\bar{b}_n \\in \\mathbb{R}^m",
        "Chain(\\bar{u}_r, Add(Mul(\\mathbf{A}_n, \\bar{u}_s), \\bar{b}_n), Pow(\\mathbb{R}; m); =, \\in)",
        "moorepants/learn-multibody-dynamics/nonholonomic-eom.rst",
    ),
    (
        "a = \\frac{1}{\\alpha}",
        "Chain(a, Div(1; \\alpha); =)",
        "AVSLab/basilisk/src/architecture/utilitiesSelfCheck/_Documentation/secModelDescription.tex",
    ),
    (
        "u_1 &= \\pi_1({\\bf x}) = - x_1 \\cos x_3, \\\\ u_2 &= \\pi_2({\\bf x}) = x_3 + \\frac{(x_2 + x_3) \\cos x_3 \\sin x_3}{x_3},",
        "System(Chain(u_1, Call(\\pi_1; \\mathbf{x}), Neg(Mul(x_1, Call(cos; x_3))); =, =), Chain(u_2, Call(\\pi_2; \\mathbf{x}), Add(x_3, Div(Mul(Add(x_2, x_3), Call(cos; x_3), Call(sin; x_3)); x_3)); =, =))",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "V = \\begin{cases} V_0,& r<a \\\\ 0,& r\\geqslant a \\end{cases}",
        "Chain(V, Piecewise(V_0, Chain(r, a; <), 0, Chain(r, a; \\ge)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "\\tau =& \\text{atan2}(-x_2,x_1) \\\\ x_\\perp =& \\sqrt{x_1^2+x_2^2}-1,",
        "System(Chain(\\tau, Call(\\text{atan2}; Neg(x_2), x_1); =), Chain(x_\\perp, Add(Sqrt(Add(Pow(x_1; 2), Pow(x_2; 2))), Neg(1)); =))",
        "RussTedrake/underactuated/book/limit_cycles.html",
    ),
    (
        "\\Delta\\mathbf{q}_\\mathrm{mag} = \\begin{bmatrix} \\frac{\\sqrt{\\Gamma+l_x\\sqrt{\\Gamma}}}{\\sqrt{2\\Gamma}} & 0 & 0 & \\frac{l_y}{\\sqrt{2(\\Gamma+l_x\\sqrt{\\Gamma})}} \\end{bmatrix}^T",
        "Chain(\\Delta \\mathbf { q } _ { \\mathrm { m a g } }, Transpose(MatrixOf(Div(Sqrt(Add(\\varGamma, Mul(l_x, Sqrt(\\varGamma)))); Sqrt(Mul(2, \\varGamma))), 0, 0, Div(l_y; Sqrt(Mul(2, Add(\\varGamma, Mul(l_x, Sqrt(\\varGamma)))))))); =)",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "\\begin{aligned} \\boldsymbol{F}_1 &= -G\\frac{m_1 m}{r_1^2} \\left.\\boldsymbol{\\hat{u}}_r\\right)_1 = -\\frac{\\mu_1 m}{r_1^3}\\boldsymbol{r}_1 \\\\ \\boldsymbol{F}_2 &= -G\\frac{m_2 m}{r_2^2}\\left.\\boldsymbol{\\hat{u}}_r\\right)_2 = -\\frac{\\mu_2 m}{r_2^3}\\boldsymbol{r}_2 \\end{aligned}",
        "System(Chain(\\boldsymbol{F}_1, Neg(Mul(G, Div(Mul(m_1, m); Pow(r_1; 2)), Marked(\\boldsymbol{\\hat{u}}_r; _{ 1 }))), Neg(Mul(Div(Mul(\\mu_1, m); Pow(r_1; 3)), \\boldsymbol{r}_1)); =, =), Chain(\\boldsymbol{F}_2, Neg(Mul(G, Div(Mul(m_2, m); Pow(r_2; 2)), Marked(\\boldsymbol{\\hat{u}}_r; _{ 2 }))), Neg(Mul(Div(Mul(\\mu_2, m); Pow(r_2; 3)), \\boldsymbol{r}_2)); =, =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "f(t) = \\lvert t \\rvert \\qquad \\text{for } \\; {-1} < t \\leq 1,",
        "Implies(Chain(Neg(1), t, 1; <, \\le); Chain(Call(f; t), Bars(t); =))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{B} &=& \\frac{1}{2}\\big(\\,^b\\mathbf{a}(\\,^r\\mathbf{a})^T+\\,^b\\mathbf{m}(^r\\mathbf{m})^T\\big) \\\\ && \\\\ \\mathbf{z}^T &=& \\begin{bmatrix}B_{23}-B_{32}\\\\B_{31}-B_{13}\\\\B_{12}-B_{21}\\end{bmatrix} \\end{array}",
        "System(Chain(\\mathbf{B}, Mul(Div(1; 2), Add(Mul(\\prescript { b } { } { \\mathbf { a } }, Transpose(\\prescript { r } { } { \\mathbf { a } })), Mul(\\prescript { b } { } { \\mathbf { m } }, Transpose(\\prescript { r } { } { \\mathbf { m } })))); =), Chain(Transpose(\\mathbf{z}), MatrixOf(Add(B_{23}, Neg(B_{32})), Add(B_{31}, Neg(B_{13})), Add(B_{12}, Neg(B_{21}))); =))",
        "Mayitzin/ahrs/ahrs/filters/famc.py",
    ),
    (
        "\\begin{array}{rcl} a &=& \\sigma^2-\\kappa \\\\ && \\\\ b &=& \\sigma^2 + \\mathbf{Z}^T\\mathbf{Z} \\\\ && \\\\ c &=& \\Delta + \\mathbf{Z}^T\\mathbf{SZ} \\\\ && \\\\ d &=& \\mathbf{Z}^T\\mathbf{S}^2\\mathbf{Z} \\\\ && \\\\ \\sigma &=& \\frac{1}{2}\\mathrm{tr}\\mathbf{S} \\\\ && \\\\ \\kappa &=& \\mathrm{tr}\\big(\\mathrm{adj}(\\mathbf{S})\\big) \\\\ && \\\\ \\Delta &=& \\mathrm{det}(\\mathbf{S}) \\end{array}",
        "System(Chain(a, Add(Pow(\\sigma; 2), Neg(\\kappa)); =), Chain(b, Add(Pow(\\sigma; 2), Mul(Transpose(\\mathbf{Z}), \\mathbf{Z})); =), Chain(c, Add(\\Delta, Mul(Transpose(\\mathbf{Z}), \\mathbf{S}, \\mathbf{Z})); =), Chain(d, Mul(Transpose(\\mathbf{Z}), Pow(\\mathbf{S}; 2), \\mathbf{Z}); =), Chain(\\sigma, Mul(Div(1; 2), Call(tr; \\mathbf{S})); =), Chain(\\kappa, Call(tr; Call(adj; \\mathbf{S})); =), Chain(\\Delta, Call(det; \\mathbf{S}); =))",
        "Mayitzin/ahrs/ahrs/filters/quest.py",
    ),
    (
        "v_{\\perp} = \\sqrt{v^2 - v_r^2}",
        "Chain(v_\\perp, Sqrt(Add(Pow(v; 2), Neg(Pow(v_r; 2)))); =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/orbital-elements-and-the-state-vector.md",
    ),
    (
        "\\begin{cases} f = \\dfrac{Qa\\cos \\phi}{r\\sin(\\phi+\\theta)}-P \\\\[1.5ex] N = \\dfrac{Qa\\sin \\phi}{r\\sin(\\phi+\\theta)} \\end{cases}",
        "System(Chain(f, Add(Div(Mul(Q, a, Call(cos; \\phi)); Mul(r, Call(sin; Add(\\phi, \\theta)))), Neg(P)); =), Chain(N, Div(Mul(Q, a, Call(sin; \\phi)); Mul(r, Call(sin; Add(\\phi, \\theta)))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise2.tex",
    ),
    (
        "e^2 = 2f - f^2",
        "Chain(Pow(e; 2), Add(Mul(2, f), Neg(Pow(f; 2))); =)",
        "Mayitzin/ahrs/ahrs/utils/geodesy.py",
    ),
    (
        "a_1 = \\frac{1}{1} a_0 = 1 , \\quad a_2 = \\frac{1}{2} a_1 = \\frac{1}{2} , \\quad a_3 = \\frac{1}{3} a_2 = \\frac{1}{3 \\cdot 2} , \\quad a_4 = \\frac{1}{4} a_3 = \\frac{1}{4 \\cdot 3 \\cdot 2} , \\quad \\cdots",
        "System(Chain(a_1, Mul(Div(1; 1), a_0), 1; =, =), Chain(a_2, Mul(Div(1; 2), a_1), Div(1; 2); =, =), Chain(a_3, Mul(Div(1; 3), a_2), Div(1; Mul(3, 2)); =, =), Chain(a_4, Mul(Div(1; 4), a_3), Div(1; Mul(4, 3, 2)); =, =), Words(Dots()))",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "h = v_{\\infty} y",
        "Chain(h, Mul(v_\\infty, y); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-arrival-capture.md",
    ),
    (
        "\\frac{\\partial}{\\partial q_r}(\\bar{v} \\cdot \\bar{w}) = & \\frac{\\partial \\bar{v}}{\\partial q_r} \\cdot \\bar{w} + \\bar{v} \\cdot \\frac{\\partial \\bar{w}}{\\partial q_r}",
        "Chain(Derivative(Mul(Call(\\bar{v}), Call(\\bar{w})); q_r, 1; True), Add(Mul(Derivative(Call(\\bar{v}); q_r, 1; True), Call(\\bar{w})), Mul(Call(\\bar{v}), Derivative(Call(\\bar{w}); q_r, 1; True))); =)",
        "moorepants/learn-multibody-dynamics/differentiation.rst",
    ),
    (
        "J = \\int_0^{\\infty} [3x^2(t) + u^2(t)] dt.",
        "Chain(J, Integral(Add(Mul(3, Pow(Call(x; t); 2)), Pow(Call(u; t); 2)); t; 0; Infinity()); =)",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "[colback=white,colframe=black,boxrule=0.5pt,top=1.5pt,bottom=1.5pt]{ ~~ u(x,y) = \\sum_{n=1}^\\infty b_n u_n(x,y) = \\sum_{n=1}^\\infty b_n \\sin \\left( \\frac{n \\pi}{w} x \\right) \\left( \\frac{\\sinh \\left( \\frac{n \\pi (h-y) }{w} \\right)} {\\sinh \\left( \\frac{n \\pi h }{w} \\right)} \\right) . ~~ }",
        "Chain(Call(u; x, y), BigSum(n; 1; Infinity(); Mul(b_n, Call(u_n; x, y))), BigSum(n; 1; Infinity(); Mul(b_n, Call(sin; Mul(Div(Mul(n, \\pi); w), x)), Div(Call(sinh; Div(Mul(n, \\pi, Add(h, Neg(y))); w)); Call(sinh; Div(Mul(n, \\pi, h); w))))); =, =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "{\\bf x}[n+1] = {\\bf A}{\\bf x}[n] + {\\bf B}{\\bf u}[n] + {\\bf w}[n], \\\\ {\\bf y}[n] = {\\bf C}{\\bf x}[n] + {\\bf D}{\\bf u}[n] + {\\bf v}[n], \\\\ {\\bf w}[n] \\sim \\mathcal{N}({\\bf 0}, {\\bf \\Sigma}_w), \\quad {\\bf v}[n] \\sim \\mathcal{N}({\\bf 0}, {\\bf \\Sigma}_v).",
        "System(Chain(Indexed(\\mathbf{x}; Add(n, 1)), Add(Mul(\\mathbf{A}, Indexed(\\mathbf{x}; n)), Mul(\\mathbf{B}, Indexed(\\mathbf{u}; n)), Indexed(\\mathbf{w}; n)); =), Chain(Indexed(\\mathbf{y}; n), Add(Mul(\\mathbf{C}, Indexed(\\mathbf{x}; n)), Mul(\\mathbf{D}, Indexed(\\mathbf{u}; n)), Indexed(\\mathbf{v}; n)); =), Chain(Indexed(\\mathbf{w}; n), Call(\\mathcal{N}; 0, \\mathbf{\\Sigma}_w); \\sim), Chain(Indexed(\\mathbf{v}; n), Call(\\mathcal{N}; 0, \\mathbf{\\Sigma}_v); \\sim))",
        "RussTedrake/underactuated/book/imitation.html",
    ),
    (
        "\\frac{d\\boldsymbol{A}}{dt} = \\boldsymbol{\\omega}\\times\\boldsymbol{A}",
        "Chain(Derivative(Call(\\boldsymbol{A}); t, 1), Cross(\\boldsymbol{\\omega}; Call(\\boldsymbol{A})); =)",
        "bryanwweber/orbital-mechanics-notes/review/time-derivatives-of-moving-vectors.md",
    ),
    (
        "v_{\\text{GEO}} = 3.075~\\mathrm{km/s}",
        "Chain(v_{GEO}, Mul(3.075, \\text{km/s}); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/circular-orbits.md",
    ),
    (
        "t_{pregrasp} = k \\left\\|{}^{G_0}p^{G_{pregrasp}}\\right\\|_2.",
        "Chain(t_{pregrasp}, Mul(k, Marked(Norm(\\prescript { G _ { 0 } } { } { p } ^ { G _ { p r e g r a s p } }); _{ 2 })); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\ddot{q}(t) = u = -1, \\\\\\dot{q}(t) = \\dot{q}(0) - t, \\\\ q(t) = q(0) + \\dot{q}(0) t - \\frac{1}{2} t^2.",
        "System(Chain(Call(\\ddot{q}; t), u, Neg(1); =, =), Chain(Call(\\dot{q}; t), Add(Call(\\dot{q}; 0), Neg(t)); =), Chain(Call(q; t), Add(Call(q; 0), Mul(Call(\\dot{q}; 0), t), Neg(Mul(Div(1; 2), Pow(t; 2)))); =))",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "\\frac{d\\boldsymbol{h}}{dt} = \\dot{\\boldsymbol{r}}\\times\\dot{\\boldsymbol{r}} + \\boldsymbol{r}\\times\\ddot{\\boldsymbol{r}}",
        "Chain(Derivative(Call(\\boldsymbol{h}); t, 1), Add(Cross(Call(\\dot{\\boldsymbol{r}}); Call(\\dot{\\boldsymbol{r}})), Cross(Call(\\boldsymbol{r}); Call(\\ddot{\\boldsymbol{r}}))); =)",
        "bryanwweber/orbital-mechanics-notes/constants-of-orbital-motion/angular-momentum-is-conserved.md",
    ),
    (
        "X(s) = \\frac{F(s)}{1-G(s)} .",
        "Chain(Call(X; s), Div(Call(F; s); Add(1, Neg(Call(G; s)))); =)",
        "jirilebl/diffyqs/ch-laplace.tex",
    ),
    (
        "y_c = C_1 e^{-2x} + C_2 e^{-3x}.",
        "Chain(y_c, Add(Mul(C_1, Pow(e; Neg(Mul(2, x)))), Mul(C_2, Pow(e; Neg(Mul(3, x))))); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "Q_0(z) = \\sum_{j=1}^J (q_j z + r_j)\\prod_{k \\ne j}\\left(z^2+s_kz + t_k\\right) = 0\\quad,",
        "Chain(Call(Q_0; z), BigSum(j; 1; J; Mul(Add(Mul(q_j, z), r_j), Limiting(prod; _{ k \\ne j }; Add(Pow(z; 2), Mul(s_k, z), t_k)))), 0; =, =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\bm v_{\\text{trans}} = \\bm F - 2m_\\text{sc} [\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm c'- m_\\text{sc} [\\tilde{\\bm\\omega}_{\\cal B/N}][\\tilde{\\bm\\omega}_{\\cal B/N}]\\bm{c} + \\bm v_{\\text{trans,contr}}",
        "Chain(\\bm{v}_{trans}, Add(\\bm{F}, Neg(Mul(2, m_{sc}, [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{c}')), Neg(Mul(m_{sc}, [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{c})), \\bm{v}_{trans,contr}); =)",
        "AVSLab/basilisk/src/simulation/dynamics/NHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\begin{aligned}\\ddot{x} &= -\\mu\\frac{x}{r^3} + \\frac{T}{m}\\frac{\\dot{x}}{v} & \\ddot{y} &= -\\mu\\frac{y}{r^3} + \\frac{T}{m}\\frac{\\dot{y}}{v} & \\ddot{z} &= -\\mu\\frac{z}{r^3} + \\frac{T}{m}\\frac{\\dot{z}}{v}\\end{aligned}",
        "System(Chain(Call(\\ddot{x}), Add(Neg(Mul(\\mu, Div(Call(x); Pow(r; 3)))), Mul(Div(T; m), Div(Call(\\dot{x}); v))); =), Chain(Call(\\ddot{y}), Add(Neg(Mul(\\mu, Div(Call(y); Pow(r; 3)))), Mul(Div(T; m), Div(Call(\\dot{y}); v))); =), Chain(Call(\\ddot{z}), Add(Neg(Mul(\\mu, Div(Call(z); Pow(r; 3)))), Mul(Div(T; m), Div(Call(\\dot{z}); v))); =))",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/nonimpulsive-orbital-maneuvers.md",
    ),
    (
        "y_{tt} = a^2 y_{xx} + F_0 \\cos ( \\omega t) ,",
        "Chain(y_{tt}, Add(Mul(Pow(a; 2), y_{xx}), Mul(F_0, Call(cos; Mul(\\omega, t)))); =)",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "S(\\omega) = \\sqrt{\\frac{2}{\\pi}}\\frac{S_1\\,{\\omega_1}^4}{(\\omega^2 - {\\omega_1}^2)^2 + 2\\,{\\omega_1}^2\\,\\omega^2} + \\sqrt{\\frac{2}{\\pi}}\\frac{S_2\\,{\\omega_2}^4}{(\\omega^2 - {\\omega_2}^2)^2 + {\\omega_2}^2\\,\\omega^2/Q^2}",
        "Chain(Call(S; \\omega), Add(Mul(Sqrt(Div(2; \\pi)), Div(Mul(S_1, Pow(\\omega_1; 4)); Add(Pow(Add(Pow(\\omega; 2), Neg(Pow(\\omega_1; 2))); 2), Mul(2, Pow(\\omega_1; 2), Pow(\\omega; 2))))), Mul(Sqrt(Div(2; \\pi)), Div(Mul(S_2, Pow(\\omega_2; 4)); Add(Pow(Add(Pow(\\omega; 2), Neg(Pow(\\omega_2; 2))); 2), Div(Mul(Pow(\\omega_2; 2), Pow(\\omega; 2)); Pow(Q; 2)))))); =)",
        "dfm/celerite/docs/tutorials/first.rst",
    ),
    (
        "f({\\bf b}, a, o) = \\frac{\\text{diag}({\\bf c}(o)) \\, {\\bf T}(a) \\, {\\bf b}}{{\\bf c}^T(o) \\, {\\bf T}(a) \\, {\\bf b}},",
        "Chain(Call(f; \\mathbf{b}, a, o), Div(Mul(Diag(Call(\\mathbf{c}; o)), Call(\\mathbf{T}; a), \\mathbf{b}); Mul(Transpose(Call(\\mathbf{c}; o)), Call(\\mathbf{T}; a), \\mathbf{b})); =)",
        "RussTedrake/underactuated/book/output_feedback.html",
    ),
    (
        "\\bm a_{d} = -\\frac{\\rho}{2} C_{d} \\frac{A v^{2}}{m} \\cdot \\frac{\\dot{\\bm r}}{|\\bm r|}",
        "Chain(\\bm{a}_d, Neg(Mul(Div(\\rho; 2), C_d, Div(Mul(A, Pow(v; 2)); m), Div(Call(\\dot{\\bm{r}}); Bars(Call(\\bm{r}))))); =)",
        "AVSLab/basilisk/src/architecture/utilitiesSelfCheck/_Documentation/secModelDescription.tex",
    ),
    (
        "m\\ddot{x} &= F_1 \\cos \\theta + F_2 \\sin \\theta \\\\ m\\ddot{y} &= F_1 \\sin \\theta - F_2 \\cos \\theta - mg \\\\ I\\ddot{\\theta} &= rF_1",
        "System(Chain(Mul(m, Call(\\ddot{x})), Add(Mul(F_1, Call(cos; Call(\\theta))), Mul(F_2, Call(sin; Call(\\theta)))); =), Chain(Mul(m, Call(\\ddot{y})), Add(Mul(F_1, Call(sin; Call(\\theta))), Neg(Mul(F_2, Call(cos; Call(\\theta)))), Neg(Mul(m, g))); =), Chain(Mul(I, Call(\\ddot{\\theta})), Mul(r, F_1); =))",
        "RussTedrake/underactuated/book/trajopt.html",
    ),
    (
        "\\boxed{\\bar{\\mathbf{z}} = \\sum_{i=0}^{2n} w_i^{(m)} \\mathcal{Z}_i}",
        "Chain(\\bar{\\mathbf{z}}, BigSum(i; 0; Mul(2, n); Mul(w _ { i } ^ { ( m ) }, \\mathcal{Z}_i)); =)",
        "Mayitzin/ahrs/ahrs/filters/ukf.py",
    ),
    (
        "S(\\boldsymbol{r},\\boldsymbol{D},t) = W(\\boldsymbol{r},\\boldsymbol{D}) - Et",
        "Chain(Call(S; \\boldsymbol{r}, \\boldsymbol{D}, t), Add(Call(W; \\boldsymbol{r}, \\boldsymbol{D}), Neg(Mul(E, t))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{Kq} &=& \\lambda_{\\mathrm{max}}\\mathbf{q} \\\\ \\begin{bmatrix} \\mathbf{B}+\\mathbf{B}-\\mathrm{tr}(\\mathbf{B})\\mathbf{I} & \\mathbf{z} \\\\ \\mathbf{z}^T & \\mathrm{tr}(\\mathbf{B}) \\end{bmatrix} \\begin{bmatrix}q_x\\\\q_y\\\\q_z\\\\q_w\\end{bmatrix} &=& \\lambda_{\\mathrm{max}}\\begin{bmatrix}q_x\\\\q_y\\\\q_z\\\\q_w\\end{bmatrix} \\end{array}",
        "System(Chain(Mul(\\mathbf{K}, \\mathbf{q}), Mul(\\lambda_{max}, \\mathbf{q}); =), Chain(Mul(MatrixOf(Add(\\mathbf{B}, \\mathbf{B}, Neg(Mul(Call(tr; \\mathbf{B}), \\mathbf{I}))), \\mathbf{z}, Transpose(\\mathbf{z}), Call(tr; \\mathbf{B})), MatrixOf(q_x, q_y, q_z, q_w)), Mul(\\lambda_{max}, MatrixOf(q_x, q_y, q_z, q_w)); =))",
        "Mayitzin/ahrs/ahrs/filters/famc.py",
    ),
    (
        "\\begin{aligned}\\dot{x} &= \\left(R_E + z\\right) \\dot{\\Lambda}\\cos\\phi & \\dot{y} &= \\left(R_E + z\\right)\\dot{\\phi}\\end{aligned}",
        "System(Chain(Call(\\dot{x}), Mul(Add(R_E, z), Call(\\dot{\\Lambda}), Call(cos; Call(\\phi))); =), Chain(Call(\\dot{y}), Mul(Add(R_E, z), Call(\\dot{\\phi})); =))",
        "bryanwweber/orbital-mechanics-notes/reference/relative-motion.md",
    ),
    (
        "J_n(x) = {(-1)}^nJ_{-n}(x) .",
        "Chain(Call(J_n; x), Mul(Pow(Neg(1); n), Call(J_{-n}; x)); =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{B} &=& \\frac{1}{3} \\mathbf{b}_1\\mathbf{r}_1^T + \\frac{1}{3} \\mathbf{b}_2\\mathbf{r}_2^T + \\frac{1}{3} \\mathbf{b}_3\\mathbf{r}_3^T \\\\ &=& \\frac{1}{3}\\begin{bmatrix} \\mathbf{d}_1 & \\mathbf{d}_2 & \\mathbf{d}_3 \\end{bmatrix} \\\\ &=& \\frac{1}{3}\\mathbf{D} \\end{array}",
        "Chain(\\mathbf{B}, Add(Mul(Div(1; 3), \\mathbf{b}_1, Transpose(\\mathbf{r}_1)), Mul(Div(1; 3), \\mathbf{b}_2, Transpose(\\mathbf{r}_2)), Mul(Div(1; 3), \\mathbf{b}_3, Transpose(\\mathbf{r}_3))), Mul(Div(1; 3), MatrixOf(\\mathbf{d}_1, \\mathbf{d}_2, \\mathbf{d}_3)), Mul(Div(1; 3), \\mathbf{D}); =, =, =)",
        "Mayitzin/ahrs/ahrs/common/orientation.py",
    ),
    (
        "k(\\tau) = a_1\\,e^{-c_1\\,\\tau} + a_2\\,e^{-c_2\\,\\tau} + \\frac{1}{2}\\left[ (a_3 + i\\,b_3)\\,e^{-(c_3+i\\,d_3)\\,\\tau} + (a_3 - i\\,b_3)\\,e^{-(c_3-i\\,d_3)\\,\\tau} \\right]",
        "Chain(Call(k; \\tau), Add(Mul(a_1, Pow(e; Neg(Mul(c_1, \\tau)))), Mul(a_2, Pow(e; Neg(Mul(c_2, \\tau)))), Mul(Div(1; 2), Add(Mul(Add(a_3, Mul(i, b_3)), Pow(e; Neg(Mul(Add(c_3, Mul(i, d_3)), \\tau)))), Mul(Add(a_3, Neg(Mul(i, b_3))), Pow(e; Neg(Mul(Add(c_3, Neg(Mul(i, d_3))), \\tau))))))); =)",
        "dfm/celerite/docs/cpp/start.rst",
    ),
    (
        "V = mgh",
        "Chain(V, Mul(m, g, h); =)",
        "moorepants/learn-multibody-dynamics/energy.rst",
    ),
    (
        "Y_n(z) = -\\frac{2}{\\pi} \\left( i^n K_n(iz) + \\left[\\log(iz)-\\log(z)\\right] J_n(z) \\right)",
        "Chain(Call(Y_n; z), Neg(Mul(Div(2; \\pi), Add(Mul(Pow(i; n), Call(K_n; Mul(i, z))), Mul(Add(Call(log; Mul(i, z)), Neg(Call(log; z))), Call(J_n; z))))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "-\\sum_{\\zeta=1}^s \\frac{\\partial P_\\zeta}{\\partial p_\\alpha} \\frac{\\partial Q_\\zeta}{\\partial p_\\beta} - \\sum_{\\zeta=1}^s P_\\zeta \\frac{\\partial^2 Q_\\zeta}{\\partial p_\\alpha \\partial p_\\beta} = -\\sum_{\\zeta=1}^s \\frac{\\partial P_\\zeta}{\\partial p_\\beta} \\frac{\\partial Q_\\zeta}{\\partial p_\\alpha} - \\sum_{\\zeta=1}^s P_\\zeta \\frac{\\partial^2 Q_\\zeta}{\\partial p_\\beta \\partial p_\\alpha}",
        "Chain(Add(Neg(BigSum(\\zeta; 1; s; Mul(Derivative(Call(P_{\\zeta}); p_\\alpha, 1; True), Derivative(Call(Q_{\\zeta}); p_\\beta, 1; True)))), Neg(BigSum(\\zeta; 1; s; Mul(Call(P_{\\zeta}), Derivative(Call(Q_{\\zeta}); p_\\alpha, 1, p_\\beta, 1; True))))), Add(Neg(BigSum(\\zeta; 1; s; Mul(Derivative(Call(P_{\\zeta}); p_\\beta, 1; True), Derivative(Call(Q_{\\zeta}); p_\\alpha, 1; True)))), Neg(BigSum(\\zeta; 1; s; Mul(Call(P_{\\zeta}), Derivative(Call(Q_{\\zeta}); p_\\beta, 1, p_\\alpha, 1; True))))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\dddot{\\bf q}(t) = {\\bf r}'''(s) \\dot{s}^3(t) + 3{\\bf r}''(s) \\dot{s}(t) \\ddot{s}(t) + {\\bf r}'(s)\\dddot{s}(t).",
        "Chain(Call(\\dddot{\\mathbf{q}}; t), Add(Mul(Call(\\mathbf{r}'''; Call(s)), Pow(Call(\\dot{s}; t); 3)), Mul(3, Call(\\mathbf{r}''; Call(s)), Call(\\dot{s}; t), Call(\\ddot{s}; t)), Mul(Call(\\mathbf{r}'; Call(s)), Call(\\dddot{s}; t))); =)",
        "RussTedrake/manipulation/book/trajectories.html",
    ),
    (
        "x_0 = a+\\frac{mg\\cot\\alpha}{4\\pi^2k}",
        "Chain(x_0, Add(a, Div(Mul(m, g, Call(cot; \\alpha)); Mul(4, Pow(\\pi; 2), k))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "X'' = A * X",
        "Chain(X'', Operated(*; A; X); =)",
        "sympy/sympy/sympy/solvers/ode/systems.py",
    ),
    (
        "s^2 X(s) + \\omega_0^2 X(s) = F(s) .",
        "Chain(Add(Mul(Pow(s; 2), Call(X; s)), Mul(Pow(\\omega_0; 2), Call(X; s))), Call(F; s); =)",
        "jirilebl/diffyqs/ch-laplace.tex",
    ),
    (
        "L(\\mathbf{D}) = \\frac{1}{2}\\sum_{i=1}^{k}a_i|\\mathbf{b}_i - \\mathbf{D}\\mathbf{r}_i|^2",
        "Chain(Call(L; \\mathbf{D}), Mul(Div(1; 2), BigSum(i; 1; k; Mul(a_i, Pow(Bars(Add(\\mathbf{b}_i, Neg(Mul(\\mathbf{D}, \\mathbf{r}_i)))); 2)))); =)",
        "Mayitzin/ahrs/ahrs/common/orientation.py",
    ),
    (
        "k_j(\\tau_{nm}) = a_j\\,\\exp\\left(-c_j\\,\\tau_{nm}\\right)\\,\\cos\\left(d_j\\,\\tau_{nm}\\right)",
        "Chain(Call(k_j; \\tau_{nm}), Mul(a_j, Call(exp; Neg(Mul(c_j, \\tau_{nm}))), Call(cos; Mul(d_j, \\tau_{nm}))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "V = \\frac{\\alpha}{r},\\quad \\alpha > 0",
        "System(Chain(V, Div(\\alpha; r); =), Chain(\\alpha, 0; >))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "p_0 \\cdot f(x) + p_1 \\cdot f^{(1)}(x) + p_2 \\cdot f^{(2)}(x) + ... + p_r \\cdot f^{(r)}(x) = 0",
        "Chain(Add(Mul(p_0, Call(f; x)), Mul(p_1, Call(f ^ { ( 1 ) }; x)), Mul(p_2, Call(f ^ { ( 2 ) }; x)), Dots(), Mul(p_r, Call(f ^ { ( r ) }; x))), 0; =)",
        "sympy/sympy/doc/src/modules/holonomic/about.rst",
    ),
    (
        "y_{tt} = a^2 y_{xx}",
        "Chain(y_{tt}, Mul(Pow(a; 2), y_{xx}); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\begin{cases} \\bar A=T^{-1}AT\\\\ \\bar B=T^{-1}B\\\\ \\bar C=CT\\\\ \\bar D=D\\end{cases}",
        "System(Chain(\\bar{A}, Mul(Pow(T; Neg(1)), A, T); =), Chain(\\bar{B}, Mul(Pow(T; Neg(1)), B); =), Chain(\\bar{C}, Mul(C, T); =), Chain(\\bar{D}, D; =))",
        "sympy/sympy/sympy/physics/control/lti.py",
    ),
    (
        "\\begin{cases} r = r_0 \\\\ z = a\\phi+f(r) \\end{cases}",
        "System(Chain(r, r_0; =), Chain(z, Add(Mul(a, \\phi), Call(f; r)); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise2.tex",
    ),
    (
        "El = \\tan{\\frac{z}{\\sqrt{x^2+y^2}}}",
        "Chain(\\text{El}, Call(tan; Div(z; Sqrt(Add(Pow(x; 2), Pow(y; 2))))); =)",
        "AVSLab/basilisk/src/simulation/environment/groundLocation/groundLocation.rst",
    ),
    (
        "L = \\begin{bmatrix} 1 & 0 & 0 & \\cdots & 0 \\\\ L_{1, 0} & 1 & 0 & \\cdots & 0 \\\\ L_{2, 0} & L_{2, 1} & 1 & \\cdots & 0 \\\\ \\vdots & \\vdots & \\vdots & \\ddots & \\vdots \\\\ L_{n-1, 0} & L_{n-1, 1} & L_{n-1, 2} & \\cdots & 1 \\end{bmatrix}",
        "Chain(L, MatrixOf(1, 0, 0, Dots(), 0, L_{1,0}, 1, 0, Dots(), 0, L_{2,0}, L_{2,1}, 1, Dots(), 0, Dots(), Dots(), Dots(), Dots(), Dots(), L_{n-1,0}, L_{n-1,1}, L_{n-1,2}, Dots(), 1); =)",
        "sympy/sympy/sympy/matrices/decompositions.py",
    ),
    (
        "\\frac{\\partial f}{\\partial \\boldsymbol{r}} \\cdot \\mathrm{d} \\boldsymbol{r} = 0",
        "Chain(Mul(Derivative(Call(f); \\boldsymbol{r}, 1; True), Total(\\boldsymbol{r}); 1), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/analytical-mechanics/Constraint.tex",
    ),
    (
        "\\left| \\frac{1}{\\sqrt{x+a}} - \\frac{1}{\\sqrt{x}} \\right| \\le \\frac{|a|}{2 (x-|a|)^{3/2}}.",
        "Chain(Bars(Add(Div(1; Sqrt(Add(x, a))), Neg(Div(1; Sqrt(x))))), Div(Bars(a); Mul(2, Pow(Add(x, Neg(Bars(a))); Div(3; 2)))); \\le)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "R^{-}_{k+1}\\leftarrow R^{-}_{k+1} + R_{meas}",
        "Chain(R _ { k + 1 } ^ { - }, Add(R _ { k + 1 } ^ { - }, R_{meas}); \\leftarrow)",
        "AVSLab/basilisk/src/fswAlgorithms/smallBodyNavigation/smallBodyNavUKF/smallBodyNavUKF.rst",
    ),
    (
        "f_i({\\bf b}, a, o) = \\frac{p_{o|s}(o \\,|\\, s_i) \\sum_{j \\in |S|} p(s_i\\,|\\,s_j,a) b_j}{p_{o|b,a}(o \\,|\\, {\\bf b}, a)} = \\frac{p_{o|s}(o \\,|\\, s_i) \\sum_{j \\in |S|} p(s_i\\,|\\,s_j,a) b_j}{\\sum_{i \\in |S|} p_{o|s}(o \\,|\\, s_i) \\sum_{j \\in |S|} p(s_i | s_j, a) b_j}.",
        "Chain(Call(f_i; \\mathbf{b}, a, o), Div(Mul(Call(p_{o|s}; Given(o; s_i; |)), Limiting(sum; _{ j \\in | S | }; Mul(Call(p; Given(s_i; s_j, a; |)), b_j))); Call(p_{o|b,a}; Given(o; \\mathbf{b}, a; |))), Div(Mul(Call(p_{o|s}; Given(o; s_i; |)), Limiting(sum; _{ j \\in | S | }; Mul(Call(p; Given(s_i; s_j, a; |)), b_j))); Limiting(sum; _{ i \\in | S | }; Mul(Call(p_{o|s}; Given(o; s_i; |)), Limiting(sum; _{ j \\in | S | }; Mul(Call(p; Given(s_i; s_j, a; |)), b_j))))); =, =)",
        "RussTedrake/underactuated/book/output_feedback.html",
    ),
    (
        "\\begin{cases} x = \\rho \\cos \\phi \\\\ y = \\rho \\sin \\phi \\\\ z = z \\end{cases}",
        "System(Chain(x, Mul(\\rho, Call(cos; \\phi)); =), Chain(y, Mul(\\rho, Call(sin; \\phi)); =), Chain(z, z; =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Kinematics.tex",
    ),
    (
        "v_{\\text{esc}} = \\sqrt{2} v_{\\text{circular}}",
        "Chain(v_{esc}, Mul(Sqrt(2), v_{circular}); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/parabolic-trajectories.md",
    ),
    (
        "E = M_e + \\sum_{n=1}^{\\infty}\\frac{2}{n} J_n(ne)\\sin n M_e",
        "Chain(E, Add(M_e, BigSum(n; 1; Infinity(); Mul(Div(2; n), Call(J_n; Mul(n, e)), Call(sin; Mul(n, M_e))))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "\\boldsymbol{F}_{12} = -\\boldsymbol{F}_{21}",
        "Chain(\\boldsymbol{F}_{12}, Neg(\\boldsymbol{F}_{21}); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-inertial-motion.md",
    ),
    (
        "v^* = \\left[ J^G(q) \\right]^+V^{G_d}.",
        "Chain(v ^ { * }, Mul(Marked(Call(J ^ { G }; q); ^+), V ^ { G _ { d } }); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "v_2 = v_a = \\frac{h}{r_a} = \\frac{h}{R_E + z_0}",
        "Chain(v_2, v_a, Div(h; r_a), Div(h; Add(R_E, z_0)); =, =, =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/single-impulse-example.md",
    ),
    (
        "\\left[I_{\\text{hub},\\,B}\\right]= \\left[I_{\\text{hub},\\,Bc}\\right] + m_\\text{hub}\\, \\left[\\tilde{\\bm{r}}_{Bc/B}\\right]\\left[\\tilde{\\bm{r}}_{Bc/B}\\right]^T",
        "Chain([ I _ { \\text { h u b } , \\, B } ], Add([ I _ { \\text { h u b } , \\, B c } ], Mul(m_{hub}, [ \\tilde { \\bm { r } } _ { B c / B } ], Transpose([ \\tilde { \\bm { r } } _ { B c / B } ]))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "{\\bf h}_{A,B}({\\bf q}) = {}^W{\\bf p}^{C_a}_{C_{a;z}} - {}^W{\\bf p}^{C_b}_{C_{a;z}} = 0,",
        "Chain(Call(\\mathbf{h}_{A,B}; \\mathbf{q}), Add(\\prescript { W } { } { \\mathbf { p } } _ { C _ { a ; z } } ^ { C _ { a } }, Neg(\\prescript { W } { } { \\mathbf { p } } _ { C _ { a ; z } } ^ { C _ { b } })), 0; =, =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "e'^2 = \\frac{a^2-b^2}{b^2}",
        "Chain(Pow(e'; 2), Div(Add(Pow(a; 2), Neg(Pow(b; 2))); Pow(b; 2)); =)",
        "Mayitzin/ahrs/ahrs/utils/geodesy.py",
    ),
    (
        "{}_pf_{q}(z) = \\sum_{k=0}^{\\infty} T(k) = \\sum_{k=0}^{n-1} T(k) + \\varepsilon",
        "Chain(Call(\\prescript { } { p } { f } _ { q }; z), BigSum(k; 0; Infinity(); Call(T; k)), Add(BigSum(k; 0; Add(n, Neg(1)); Call(T; k)), \\varepsilon); =, =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "K_{\\nu}(z) = \\frac{1}{2} \\frac{\\pi}{\\sin(\\pi \\nu)} \\left[ \\left(\\frac{z}{2}\\right)^{-\\nu} {}_0{\\widetilde F}_1\\left(1-\\nu, \\frac{z^2}{4}\\right) - \\left(\\frac{z}{2}\\right)^{\\nu} {}_0{\\widetilde F}_1\\left(1+\\nu, \\frac{z^2}{4}\\right) \\right].",
        "Chain(Call(K_\\nu; z), Mul(Div(1; 2), Div(\\pi; Call(sin; Mul(\\pi, \\nu))), Add(Mul(Pow(Div(z; 2); Neg(\\nu)), Call(\\prescript { } { 0 } { \\widetilde { F } } _ { 1 }; Add(1, Neg(\\nu)), Div(Pow(z; 2); 4))), Neg(Mul(Pow(Div(z; 2); \\nu), Call(\\prescript { } { 0 } { \\widetilde { F } } _ { 1 }; Add(1, \\nu), Div(Pow(z; 2); 4)))))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "\\mathbf{Q} = \\begin{bmatrix} 0.1^2 & 0 & 0 & 0 \\\\ 0 & 0.1^2 & 0 & 0 \\\\ 0 & 0 & (0.017)^2 & 0 \\\\ 0 & 0 & 0 & 1.0^2 \\end{bmatrix}",
        "Chain(\\mathbf{Q}, MatrixOf(Pow(0.1; 2), 0, 0, 0, 0, Pow(0.1; 2), 0, 0, 0, 0, Pow(0.017; 2), 0, 0, 0, 0, Pow(1.0; 2)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/unscented_kalman_filter_localization/unscented_kalman_filter_localization_main.rst",
    ),
    (
        "p(x[n+1]|x[n]) = \\frac{1}{\\sqrt{2 \\pi \\sigma_w^2}} e^{-\\frac{(x[n+1]-ax[n])^2}{2\\sigma_w^2}},",
        "Chain(Call(p; Given(Indexed(x; Add(n, 1)); Indexed(x; n); |)), Mul(Div(1; Sqrt(Mul(2, \\pi, Pow(\\sigma_w; 2)))), Pow(e; Neg(Div(Pow(Add(Indexed(x; Add(n, 1)), Neg(Mul(a, Indexed(x; n)))); 2); Mul(2, Pow(\\sigma_w; 2)))))); =)",
        "RussTedrake/underactuated/book/stochastic.html",
    ),
    (
        "\\Pi(n, m) = \\int_0^{\\pi/2} \\frac{dt}{(1-n \\sin^2 t) \\sqrt{1-m \\sin^2 t}} = \\int_0^1 \\frac{dt}{(1-nt^2) \\sqrt{1-t^2} \\sqrt{1-mt^2}}.",
        "Chain(Call(\\Pi; n, m), Integral(Div(1; Mul(Add(1, Neg(Mul(n, Pow(Call(sin; t); 2)))), Sqrt(Add(1, Neg(Mul(m, Pow(Call(sin; t); 2))))))); t; 0; Div(\\pi; 2)), Integral(Div(1; Mul(Add(1, Neg(Mul(n, Pow(t; 2)))), Sqrt(Add(1, Neg(Pow(t; 2)))), Sqrt(Add(1, Neg(Mul(m, Pow(t; 2))))))); t; 0; 1); =, =)",
        "fredrik-johansson/arb/doc/source/acb_elliptic.rst",
    ),
    (
        "\\frac{1}{1-v^2} \\,dv = dx .",
        "Chain(Mul(Div(1; Add(1, Neg(Pow(v; 2)))), Total(v)), Total(x); =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\delta y = -\\delta x \\cot \\alpha",
        "Chain(\\delta y, Neg(Mul(\\delta x, Call(cot; \\alpha))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "\\lambda_{t+1} \\gets \\lambda_t - \\frac{f(\\lambda)}{f'(\\lambda)} = \\lambda_t - \\frac{\\lambda^4-(a+b)\\lambda^2-c\\lambda+(ab+c\\sigma-d)}{4\\lambda^3-2(a+b)\\lambda-c}",
        "Chain(\\lambda_{t+1}, Add(\\lambda_t, Neg(Div(Call(f; \\lambda); Call(f'; \\lambda)))), Add(\\lambda_t, Neg(Div(Add(Pow(\\lambda; 4), Neg(Mul(Add(a, b), Pow(\\lambda; 2))), Neg(Mul(c, \\lambda)), Add(Mul(a, b), Mul(c, \\sigma), Neg(d))); Add(Mul(4, Pow(\\lambda; 3)), Neg(Mul(2, Add(a, b), \\lambda)), Neg(c))))); \\leftarrow, =)",
        "Mayitzin/ahrs/ahrs/filters/quest.py",
    ),
    (
        "\\mu^*_m &=& \\sum_{j=1}^J\\sum_{n=1}^{n_0} e^{-c_j\\,(t^*_m-t_n)}\\,\\left[a_j\\,\\cos{(d_j\\,(t^*_m-t_n))} +b_j\\,\\sin{(d_j\\,(t^*_m-t_n))}\\right]\\,z_n \\\\ &+& \\sum_{j=1}^J\\sum_{n=n_0+1}^N e^{-c_j\\,(t_n-t^*_m)}\\,\\left[ a_j\\,\\cos{(d_j\\,(t_n-t^*_m))}+b_j\\,\\sin{(d_j\\,(t_n-t^*_m))}\\right]\\,z_n \\quad.",
        "Chain(\\mu _ { m } ^ { * }, Add(BigSum(j; 1; J; BigSum(n; 1; n_0; Mul(Pow(e; Neg(Mul(c_j, Add(t _ { m } ^ { * }, Neg(t_n))))), Add(Mul(a_j, Call(cos; Mul(d_j, Add(t _ { m } ^ { * }, Neg(t_n))))), Mul(b_j, Call(sin; Mul(d_j, Add(t _ { m } ^ { * }, Neg(t_n)))))), z_n))), BigSum(j; 1; J; BigSum(n; Add(n_0, 1); N; Mul(Pow(e; Neg(Mul(c_j, Add(t_n, Neg(t _ { m } ^ { * }))))), Add(Mul(a_j, Call(cos; Mul(d_j, Add(t_n, Neg(t _ { m } ^ { * }))))), Mul(b_j, Call(sin; Mul(d_j, Add(t_n, Neg(t _ { m } ^ { * })))))), z_n)))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "u = -\\tau_g(q) + K_p(q_d - q) + K_d(\\dot{q}_d - \\dot{q}) + \\tau_{ff},",
        "Chain(u, Add(Neg(Call(\\tau_g; Call(q))), Mul(K_p, Add(Call(q_d), Neg(Call(q)))), Mul(K_d, Add(Call(\\dot{q}_d), Neg(Call(\\dot{q})))), \\tau_{ff}); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "\\bm F(\\bm X) =\\dot{\\bm d} = - \\bm \\omega \\times \\bm d",
        "Chain(Call(\\bm{F}; \\bm{X}), Call(\\dot{\\bm{d}}), Neg(Cross(\\bm{\\omega}; Call(\\bm{d}))); =, =)",
        "AVSLab/basilisk/src/fswAlgorithms/attDetermination/okeefeEKF/_Documentation/Okeefe_EKF.tex",
    ),
    (
        "C_{\\infty} = 0.6276 + 0.0828\\beta^{2.1} + 0.2739\\beta^8 - \\frac{0.0934\\beta^4}{(1-\\beta^4)} - 0.1132\\beta^3",
        "Chain(C_\\infty, Add(0.6276, Mul(0.0828, Pow(\\beta; 2.1)), Mul(0.2739, Pow(\\beta; 8)), Neg(Div(Mul(0.0934, Pow(\\beta; 4)); Add(1, Neg(Pow(\\beta; 4))))), Neg(Mul(0.1132, Pow(\\beta; 3)))); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "x = \\frac{p}{2} - \\frac{y^2}{2p}",
        "Chain(x, Add(Div(p; 2), Neg(Div(Pow(y; 2); Mul(2, p)))); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/parabolic-trajectories.md",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{q}&=&\\begin{pmatrix}q_w & q_x & q_y & q_z\\end{pmatrix}^T \\\\ &=& \\begin{pmatrix}\\cos\\frac{\\theta}{2} & n_x\\sin\\frac{\\theta}{2} & n_y\\sin\\frac{\\theta}{2} & n_z\\sin\\frac{\\theta}{2}\\end{pmatrix}^T \\end{array}",
        "Chain(\\mathbf{q}, Transpose(MatrixOf(q_w, q_x, q_y, q_z)), Transpose(MatrixOf(Call(cos; Div(\\theta; 2)), Mul(n_x, Call(sin; Div(\\theta; 2))), Mul(n_y, Call(sin; Div(\\theta; 2))), Mul(n_z, Call(sin; Div(\\theta; 2))))); =, =)",
        "Mayitzin/ahrs/ahrs/filters/flae.py",
    ),
    (
        "\\left| (x+a)^{1/k} - x^{1/k} \\right| \\le x^{1/k} \\min\\left(1, \\frac{1}{k} \\, \\log\\left(1+\\frac{|a|}{x-|a|}\\right)\\right).",
        "Chain(Bars(Add(Pow(Add(x, a); Div(1; k)), Neg(Pow(x; Div(1; k))))), Mul(Pow(x; Div(1; k)), Call(min; 1, Mul(Div(1; k), Call(log; Add(1, Div(Bars(a); Add(x, Neg(Bars(a))))))))); \\le)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{B} &=& w\\,^b\\mathbf{a}\\,^r\\mathbf{a}^T + (1-w)\\,^b\\mathbf{m}\\,^r\\mathbf{m}^T \\\\ \\mathbf{z} &=& \\begin{bmatrix}B_{23}-B_{32}\\\\B_{31}-B_{13}\\\\B_{12}-B_{21}\\end{bmatrix} \\end{array}",
        "System(Chain(\\mathbf{B}, Add(Mul(w, \\prescript { b } { } { \\mathbf { a } }, Transpose(\\prescript { r } { } { \\mathbf { a } })), Mul(Add(1, Neg(w)), \\prescript { b } { } { \\mathbf { m } }, Transpose(\\prescript { r } { } { \\mathbf { m } }))); =), Chain(\\mathbf{z}, MatrixOf(Add(B_{23}, Neg(B_{32})), Add(B_{31}, Neg(B_{13})), Add(B_{12}, Neg(B_{21}))); =))",
        "Mayitzin/ahrs/ahrs/filters/saam.py",
    ),
    (
        "[D] = \\Big\\{[I_{\\text{sc},B}] - \\sum\\limits_{j=1}^{N_P}m_j l_j [\\tilde{\\bm{r}}_{P_{c,j}/B}] \\bigg[ \\Big(\\sin(\\varphi_j)\\cos(\\vartheta_j)\\bm{\\hat{p}}_{0_j,1}-\\cos(\\varphi_j)\\cos(\\vartheta_j)\\bm{\\hat{p}}_{0_j,2}\\Big)\\bm b_{\\varphi_j}^T \\\\ +\\Big(\\cos(\\varphi_j)\\sin(\\vartheta_j)\\bm{\\hat{p}}_{0_j,1} +\\sin(\\varphi_j)\\sin(\\vartheta_j)\\bm{\\hat{p}}_{0_j,2}+\\cos(\\vartheta_j)\\bm{\\hat{p}}_{0_j,3} \\Big)\\bm b_{\\vartheta_j}^T \\bigg] \\Big\\}",
        "Chain([ D ], Tuple(Add([ I _ { \\text { s c } , B } ], Neg(BigSum(j; 1; N_P; Mul(m_j, l_j, [ \\tilde { \\bm { r } } _ { P _ { c , j } / B } ], Add(Mul(Add(Mul(Call(sin; \\varphi_j), Call(cos; \\vartheta_j), \\bm{\\hat{p}}_{0_j,1}), Neg(Mul(Call(cos; \\varphi_j), Call(cos; \\vartheta_j), \\bm{\\hat{p}}_{0_j,2}))), Transpose(\\bm{b}_{\\varphi_j})), Mul(Add(Mul(Call(cos; \\varphi_j), Call(sin; \\vartheta_j), \\bm{\\hat{p}}_{0_j,1}), Mul(Call(sin; \\varphi_j), Call(sin; \\vartheta_j), \\bm{\\hat{p}}_{0_j,2}), Mul(Call(cos; \\vartheta_j), \\bm{\\hat{p}}_{0_j,3})), Transpose(\\bm{b}_{\\vartheta_j}))))))); {}); =)",
        "AVSLab/basilisk/src/simulation/dynamics/sphericalPendulum/_Documentation/secModelDescription.tex",
    ),
    (
        "{\\bf M}\\dot{{\\bf v}} = {\\bf \\tau} + \\frac{\\partial {\\bf h}_v}{\\partial {\\bf v}}^T {\\bf \\lambda}.",
        "Chain(Mul(\\mathbf{M}, Call(\\dot{\\mathbf{v}})), Add(\\mathbf{\\tau}, Mul(Transpose(Derivative(Call(\\mathbf{h}_v); \\mathbf{v}, 1; True)), \\mathbf{\\lambda})); =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "\\frac{dx}{dt} = (\\text{rate in} \\times \\text{concentration in}) - (\\text{rate out} \\times \\text{concentration out}) .",
        "Chain(Derivative(Call(x); t, 1), Add(Cross(\\text{rate~in}; \\text{concentration~in}), Neg(Cross(\\text{rate~out}; \\text{concentration~out}))); =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "{\\bf S}[n-1] = {\\bf Q} + {\\bf A}^T{\\bf S}[n]{\\bf A} - ({\\bf A}^T{\\bf S}[n]{\\bf B})({\\bf R} + {\\bf B}^T {\\bf S}[n] {\\bf B})^{-1} ({\\bf B}^T {\\bf S}[n]{\\bf A}), \\quad {\\bf S}[N] = 0,",
        "System(Chain(Indexed(\\mathbf{S}; Add(n, Neg(1))), Add(\\mathbf{Q}, Mul(Transpose(\\mathbf{A}), Indexed(\\mathbf{S}; n), \\mathbf{A}), Neg(Mul(Mul(Transpose(\\mathbf{A}), Indexed(\\mathbf{S}; n), \\mathbf{B}), Pow(Add(\\mathbf{R}, Mul(Transpose(\\mathbf{B}), Indexed(\\mathbf{S}; n), \\mathbf{B})); Neg(1)), Mul(Transpose(\\mathbf{B}), Indexed(\\mathbf{S}; n), \\mathbf{A})))); =), Chain(Indexed(\\mathbf{S}; N), 0; =))",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "\\sum_{i=1}^nm_i\\ddot{\\boldsymbol{r}}_i\\cdot \\frac{\\partial \\boldsymbol{r}_i}{\\partial q_\\alpha} = \\frac{\\mathrm{d}}{\\mathrm{d} t}\\frac{\\partial T}{\\partial \\dot{q}_\\alpha} - \\frac{\\partial T}{\\partial q_\\alpha}",
        "Chain(BigSum(i; 1; n; Mul(m_i, Call(\\ddot{\\boldsymbol{r}}_i), Derivative(Call(\\boldsymbol{r}_i); q_\\alpha, 1; True); 2)), Add(Derivative(Derivative(Call(T); \\dot{q}_\\alpha, 1; True); t, 1), Neg(Derivative(Call(T); q_\\alpha, 1; True))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "|A + B| \\le |A| + |B|, \\quad |A B| \\le |A| |B|, \\quad |A / B| \\le |A| / \\mathcal{R}(B).",
        "System(Chain(Bars(Add(A, B)), Add(Bars(A), Bars(B)); \\le), Chain(Bars(Mul(A, B)), Mul(Bars(A), Bars(B)); \\le), Chain(Bars(Div(A; B)), Div(Bars(A); Call(\\mathcal{R}; B)); \\le))",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "\\mathbf{z}_t = [x_t, y_t]^T",
        "Chain(\\mathbf{z}_t, Transpose(Tuple(x_t, y_t; [])); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/unscented_kalman_filter_localization/unscented_kalman_filter_localization_main.rst",
    ),
    (
        "\\widehat{\\mathbf{r}} = \\frac{\\overline{\\mathbf{r}}}{\\|\\overline{\\mathbf{r}}\\|}",
        "Chain(\\widehat{\\mathbf{r}}, Div(\\overline{\\mathbf{r}}; Norm(\\overline{\\mathbf{r}})); =)",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "f_d = \\frac{K D}{L}",
        "Chain(f_d, Div(Mul(K, D); L); =)",
        "CalebBell/fluids/fluids/core.py",
    ),
    (
        "k(\\tau) = k_\\mathrm{SHO}(\\tau;\\,S_0,\\,Q,\\,\\omega_1) \\, k_\\mathrm{SHO}(\\tau;\\,S_0 = 1,\\,Q = 1/\\sqrt{2},\\,\\omega_2)",
        "Chain(Call(k; \\tau), Mul(Call(k_{SHO}; Given(\\tau; S_0, Q, \\omega_1; ;)), Call(k_{SHO}; Given(\\tau; Chain(S_0, 1; =), Chain(Q, Div(1; Sqrt(2)); =), \\omega_2; ;))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\begin{array}{ll} g_n^m(t) & = g_n^m(t_0) + \\Delta_t \\dot{g}_n^m (t_0) \\\\ h_n^m(t) & = h_n^m(t_0) + \\Delta_t \\dot{h}_n^m (t_0) \\end{array}",
        "System(Chain(Call(g _ { n } ^ { m }; t), Add(Call(g _ { n } ^ { m }; t_0), Mul(\\Delta_t, Call(\\dot { g } _ { n } ^ { m }; t_0))); =), Chain(Call(h _ { n } ^ { m }; t), Add(Call(h _ { n } ^ { m }; t_0), Mul(\\Delta_t, Call(\\dot { h } _ { n } ^ { m }; t_0))); =))",
        "Mayitzin/ahrs/ahrs/utils/wmm.py",
    ),
    (
        "p^{P_i} = X^C {}^Cp^{P_i}.",
        "Chain(p ^ { P _ { i } }, Mul(X ^ { C }, \\prescript { C } { } { p } ^ { P _ { i } }); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\begin{bmatrix} \\hat{a}_x \\\\ \\hat{a}_y \\\\ \\hat{a}_z \\end{bmatrix} = {}^A\\mathbf{C}^N \\begin{bmatrix} \\hat{n}_x \\\\ \\hat{n}_y \\\\ \\hat{n}_z \\end{bmatrix}",
        "Chain(MatrixOf(\\hat{a}_x, \\hat{a}_y, \\hat{a}_z), Mul(\\prescript { A } { } { \\mathbf { C } } ^ { N }, MatrixOf(\\hat{n}_x, \\hat{n}_y, \\hat{n}_z)); =)",
        "moorepants/learn-multibody-dynamics/orientation.rst",
    ),
    (
        "f\\left(\\frac{a+b}{2}\\right) = \\frac{\\pi^2}{4} + 3 \\approx 5.47 > \\frac{f(a)+f(b)}{2} = \\frac{5\\pi^2}{16} + \\frac{3}{2} \\approx 4.58.",
        "Chain(Call(f; Div(Add(a, b); 2)), Add(Div(Pow(\\pi; 2); 4), 3), 5.47, Div(Add(Call(f; a), Call(f; b)); 2), Add(Div(Mul(5, Pow(\\pi; 2)); 16), Div(3; 2)), 4.58; =, \\approx, >, =, \\approx)",
        "RussTedrake/underactuated/book/policy_search.html",
    ),
    (
        "M(q)\\ddot{q} + C(q,\\dot{q})\\dot{q} = \\tau_g(q) + u.",
        "Chain(Add(Mul(Call(M; Call(q)), Call(\\ddot{q})), Mul(Call(C; Call(q), Call(\\dot{q})), Call(\\dot{q}))), Add(Call(\\tau_g; Call(q)), u); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "p({ {\\boldsymbol{\\theta}}},\\,{ {\\boldsymbol{\\alpha}}}\\,|\\,{ {\\boldsymbol{y}}},\\,X) \\propto p({ {\\boldsymbol{y}}}\\,|\\,{X,\\,{ {\\boldsymbol{\\theta}}}},\\,{ {\\boldsymbol{\\alpha}}})\\, p({ {\\boldsymbol{\\theta}}},\\,{ {\\boldsymbol{\\alpha}}})",
        "Chain(Call(p; Given(\\boldsymbol{\\theta}, \\boldsymbol{\\alpha}; \\boldsymbol{y}, X; |)), Mul(Call(p; Given(\\boldsymbol{y}; X, \\boldsymbol{\\theta}, \\boldsymbol{\\alpha}; |)), Call(p; \\boldsymbol{\\theta}, \\boldsymbol{\\alpha})); \\propto)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "F(\\phi,m) = \\int_0^{\\phi} \\frac{dt}{\\sqrt{1-m \\sin^2 t}} = \\int_0^{\\sin \\phi} \\frac{dt}{\\left(\\sqrt{1-t^2}\\right)\\left(\\sqrt{1-mt^2}\\right)}",
        "Chain(Call(F; \\phi, m), Integral(Div(1; Sqrt(Add(1, Neg(Mul(m, Pow(Call(sin; t); 2)))))); t; 0; \\phi), Integral(Div(1; Mul(Sqrt(Add(1, Neg(Pow(t; 2)))), Sqrt(Add(1, Neg(Mul(m, Pow(t; 2))))))); t; 0; Call(sin; \\phi)); =, =)",
        "fredrik-johansson/arb/doc/source/acb_elliptic.rst",
    ),
    (
        "F(t) = e^{\\int f(t) \\,dt}, P(t) = e^{\\int p(t) \\,dt}",
        "System(Chain(Call(F; t), Pow(e; Antiderivative(Call(f; t); t)); =), Chain(Call(P; t), Pow(e; Antiderivative(Call(p; t); t)); =))",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "\\mathbf{M}_m \\dot{\\bar{x}} + \\bar{g}_m = \\bar{0}",
        "Chain(Add(Mul(\\mathbf{M}_m, Call(\\dot{\\bar{x}})), \\bar{g}_m), 0; =)",
        "moorepants/learn-multibody-dynamics/eom.rst",
    ),
    (
        "\\bar{f}_n(\\bar{u}, \\bar{q}, t) = 0 \\\\ \\textrm{ where } \\\\ \\bar{f}_n \\in \\mathbb{R}^m \\\\ \\bar{u} = \\left[ u_1, \\ldots, u_n\\right]^T \\in \\mathbb{R}^n\\\\ \\bar{q} = \\left[ q_1, \\ldots, q_n\\right]^T \\in \\mathbb{R}^n",
        "System(Chain(Call(\\bar{f}_n; \\bar{u}, \\bar{q}, t), 0; =), Chain(Call(\\bar{f}_n), Pow(\\mathbb{R}; m); \\in), Chain(\\bar{u}, Transpose(Tuple(u_1, Dots(), u_n; [])), Pow(\\mathbb{R}; n); =, \\in), Chain(\\bar{q}, Transpose(Tuple(q_1, Dots(), q_n; [])), Pow(\\mathbb{R}; n); =, \\in))",
        "moorepants/learn-multibody-dynamics/motion.rst",
    ),
    (
        "{(60+2t)}^{3/2} \\frac{dx}{dt} + {(60+2t)}^{3/2} \\frac{3}{60+2t} x & = 0.5{(60+2t)}^{3/2} ,\\\\ \\frac{d}{dt}\\left[ {(60+2t)}^{3/2} x \\right] & = 0.5{(60+2t)}^{3/2} .",
        "System(Chain(Add(Mul(Pow(Add(60, Mul(2, t)); Div(3; 2)), Derivative(Call(x); t, 1)), Mul(Pow(Add(60, Mul(2, t)); Div(3; 2)), Div(3; Add(60, Mul(2, t))), Call(x))), Mul(0.5, Pow(Add(60, Mul(2, t)); Div(3; 2))); =), Chain(Derivative(Mul(Pow(Add(60, Mul(2, t)); Div(3; 2)), Call(x)); t, 1), Mul(0.5, Pow(Add(60, Mul(2, t)); Div(3; 2))); =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\mathcal{K}^{B_p}_{\\text{total},C}= \\mathcal{K}^{B_p}_{0,C} \\oplus \\mathcal{K}^{B_p}_{1,C} \\oplus \\cdots",
        "Chain(\\mathcal { K } _ { \\text { t o t a l } , C } ^ { B _ { p } }, Operated(\\oplus; Operated(\\oplus; \\mathcal { K } _ { 0 , C } ^ { B _ { p } }; \\mathcal { K } _ { 1 , C } ^ { B _ { p } }); Dots()); =)",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "\\begin{array}{rcl} \\alpha &=& a_xm_x + a_ym_y + a_zm_z \\\\ V &=& m_N\\sqrt{1-\\alpha^2} \\end{array}",
        "System(Chain(\\alpha, Add(Mul(a_x, m_x), Mul(a_y, m_y), Mul(a_z, m_z)); =), Chain(V, Mul(m_N, Sqrt(Add(1, Neg(Pow(\\alpha; 2))))); =))",
        "Mayitzin/ahrs/ahrs/filters/saam.py",
    ),
    (
        "f(x) := \\frac{\\Gamma \\left(\\frac{\\nu+1}{2} \\right)} {\\sqrt{\\nu\\pi}\\Gamma \\left(\\frac{\\nu}{2} \\right)} \\left(1+\\frac{x^2}{\\nu} \\right)^{-\\frac{\\nu+1}{2}}",
        "Chain(Call(f; x), Mul(Div(Call(Gamma; Div(Add(\\nu, 1); 2)); Mul(Sqrt(Mul(\\nu, \\pi)), Call(Gamma; Div(\\nu; 2)))), Pow(Add(1, Div(Pow(x; 2); \\nu)); Neg(Div(Add(\\nu, 1); 2)))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "\\bar{r}^{S_o/O} = \\frac{ \\sum_{i=1}^\\nu m_i \\bar{r}^{P_i/O} }{\\sum_{i=1}^\\nu m_i}\\textrm{.}",
        "Chain(\\bar { r } ^ { S _ { o } / O }, Div(BigSum(i; 1; \\nu; Mul(m_i, \\bar { r } ^ { P _ { i } / O })); BigSum(i; 1; \\nu; m_i)); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "f(x) := \\begin{cases} \\frac{k}{\\lambda}\\left(\\frac{x}{\\lambda}\\right)^{k-1} e^{-(x/\\lambda)^{k}} & x\\geq0\\\\ 0 & x<0 \\end{cases}",
        "Chain(Call(f; x), Piecewise(Mul(Div(k; \\lambda), Pow(Div(x; \\lambda); Add(k, Neg(1))), Pow(e; Neg(Pow(Div(x; \\lambda); k)))), Chain(x, 0; \\ge), 0, Chain(x, 0; <)); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "{\\bf u}(s) = {\\bf m}(s)\\ddot{s} + {\\bf c}(s)\\dot{s}^2 + \\bar{\\bf \\tau}_g(s),",
        "Chain(Call(\\mathbf{u}; Call(s)), Add(Mul(Call(\\mathbf{m}; Call(s)), Call(\\ddot{s})), Mul(Call(\\mathbf{c}; Call(s)), Pow(Call(\\dot{s}); 2)), Call(\\bar{\\mathbf{\\tau}}_g; Call(s))); =)",
        "RussTedrake/manipulation/book/trajectories.html",
    ),
    (
        "a = \\frac{-r_a - r_p}{2} = \\frac{h^2}{\\mu}\\frac{1}{e^2 - 1}",
        "Chain(a, Div(Add(Neg(r_a), Neg(r_p)); 2), Mul(Div(Pow(h; 2); \\mu), Div(1; Add(Pow(e; 2), Neg(1)))); =, =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/hyperbolic-trajectories.md",
    ),
    (
        "{\\bf h}_{A,B}({\\bf q}) = {}^W{\\bf p}^{C_a}_{C_a} - {}^W{\\bf p}^{C_b}_{C_a} = 0.",
        "Chain(Call(\\mathbf{h}_{A,B}; \\mathbf{q}), Add(\\prescript { W } { } { \\mathbf { p } } _ { C _ { a } } ^ { C _ { a } }, Neg(\\prescript { W } { } { \\mathbf { p } } _ { C _ { a } } ^ { C _ { b } })), 0; =, =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "\\bar{F} = & \\frac{{}^N d \\bar{p}}{dt} \\quad \\textrm{ where } \\bar{p} = m_B{}^N\\bar{v}^{B_o} \\\\ \\bar{M} = & \\frac{{}^N d\\bar{H}}{dt} \\quad \\textrm{ where } \\bar{H} = \\breve{I}^{B/B_o} \\cdot {}^N\\bar{\\omega}^{B}",
        "System(Chain(\\bar{F}, Marked(Derivative(Call(\\bar{p}); t, 1); _{ N }); =), Chain(Call(\\bar{p}), Mul(m_B, \\prescript { N } { } { \\bar { v } } ^ { B _ { o } }); =), Chain(\\bar{M}, Marked(Derivative(Call(\\bar{H}); t, 1); _{ N }); =), Chain(Call(\\bar{H}), Mul(\\breve { I } ^ { B / B _ { o } }, \\prescript { N } { } { \\bar { \\omega } } ^ { B }); =))",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "\\bar{f}_n(\\dot{\\bar{q}}, \\bar{q}, t) = 0 \\\\ \\textrm{ where } \\\\ \\bar{f}_n \\in \\mathbb{R}^m \\\\ \\bar{q} = \\left[ q_1, \\ldots, q_n\\right]^T \\in \\mathbb{R}^n",
        "System(Chain(Call(\\bar{f}_n; Call(\\dot{\\bar{q}}), Call(\\bar{q}), t), 0; =), Chain(Call(\\bar{f}_n), Pow(\\mathbb{R}; m); \\in), Chain(Call(\\bar{q}), Transpose(Tuple(q_1, Dots(), q_n; [])), Pow(\\mathbb{R}; n); =, \\in))",
        "moorepants/learn-multibody-dynamics/motion.rst",
    ),
    (
        "\\chi^2 := \\sum_{j=1}^M (\\mathbf{e}_j(\\mathbf{z}_j, \\hat{\\mathbf{z}}_j))^{\\scriptstyle{\\mathsf{T}}}\\Omega_j \\mathbf{e}_j(\\mathbf{z}_j, \\hat{\\mathbf{z}}_j),",
        "Chain(Pow(\\chi; 2), BigSum(j; 1; M; Mul(Transpose(Call(\\mathbf{e}_j; \\mathbf{z}_j, \\hat{\\mathbf{z}}_j)), \\Omega_j, Call(\\mathbf{e}_j; \\mathbf{z}_j, \\hat{\\mathbf{z}}_j))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/4_slam/graph_slam/graphSLAM_formulation.rst",
    ),
    (
        "\\bar{F}_r^\\textrm{c} = -\\frac{\\partial V}{\\partial q_r}",
        "Chain(\\bar { F } _ { r } ^ { \\text { c } }, Neg(Derivative(Call(V); q_r, 1; True)); =)",
        "moorepants/learn-multibody-dynamics/lagrange.rst",
    ),
    (
        "\\operatorname{Shi}(z) = \\int_0^z \\frac{\\sinh{t}}{t} \\mathrm{d}t.",
        "Chain(Call(\\text{Shi}; z), Integral(Div(Call(sinh; t); t); t; 0; z); =)",
        "sympy/sympy/sympy/functions/special/error_functions.py",
    ),
    (
        "x'' + \\omega_0^2 x = f(t) ,",
        "Chain(Add(x'', Mul(Pow(\\omega_0; 2), x)), Call(f; t); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "({\\bf A} - {\\bf B}{\\bf K})^T{\\bf P} + {\\bf P}({\\bf A} - {\\bf B}{\\bf K}) + {\\bf Q} + {\\bf K}^T{\\bf R}{\\bf K} = 0.",
        "Chain(Add(Mul(Transpose(Add(\\mathbf{A}, Neg(Mul(\\mathbf{B}, \\mathbf{K})))), \\mathbf{P}), Mul(\\mathbf{P}, Add(\\mathbf{A}, Neg(Mul(\\mathbf{B}, \\mathbf{K})))), \\mathbf{Q}, Mul(Transpose(\\mathbf{K}), \\mathbf{R}, \\mathbf{K})), 0; =)",
        "RussTedrake/underactuated/book/policy_search.html",
    ),
    (
        "b = a\\sqrt{1 - e^2}",
        "Chain(b, Mul(a, Sqrt(Add(1, Neg(Pow(e; 2))))); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/elliptical-orbits.md",
    ),
    (
        "\\Big[m_{\\text{sp}_{i1}} d_{i1} \\bm{\\hat{s}}_{i1,3}^T + m_{sp_{i2}} l_{i1} \\bm{\\hat{s}}_{i1,3}^T \\Big] \\ddot{\\bm{r}}_{B/N} + \\Big[I_{s_{i1,2}} \\bm{\\hat{s}}_{i1,2}^T - m_{\\text{sp}_{i1}} d_{i1} \\bm{\\hat{s}}_{i1,3}^T [\\tilde{\\bm{r}}_{S_{c,i1}/B}] - m_{sp_{i2}} l_{i1} \\bm{\\hat{s}}_{i1,3}^T [\\tilde{\\bm{r}}_{S_{c,i2}/B}] \\Big] \\dot{\\bm \\omega}_{\\cal{B/N}} \\\\ + \\Big[I_{s_{i1,2}} + m_{\\text{sp}_{i1}} d_{i1}^2 + m_{sp_{i2}} l_{i1}^2 + m_{sp_{i2}} l_{i1} d_{i2} \\bm{\\hat{s}}_{i1,3}^T \\bm{\\hat{s}}_{i2,3} \\Big] \\ddot{\\theta}_{i1} + \\Big[m_{sp_{i2}} l_{i1} d_{i2} \\bm{\\hat{s}}_{i1,3}^T \\bm{\\hat{s}}_{i2,3} \\Big]\\ddot{\\theta}_{i2} = - (I_{s_{i1,1}} - I_{s_{i1,3}}) \\omega_{s_{i1,3}} \\omega_{s_{i1,1}}\\\\ -k_{i1} \\theta_{i1} - c_{i1} \\dot{\\theta}_{i1} + k_{i2} \\theta_{i2} + c_{i2} \\dot{\\theta}_{i2} + \\bm{\\hat{s}}_{i1,2}^T \\bm \\tau_{\\text{ext}_{i1},H_{i1}} + l_{i1} \\bm{\\hat{s}}_{i1,3}^T \\bm F_{\\text{ext}_{i2}} - m_{\\text{sp}_{i1}} d_{i1} \\bm{\\hat{s}}_{i1,3}^T [\\tilde{\\bm\\omega}_{\\cal B/N}] [\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm{r}_{S_{c,i1}/B}\\\\ - m_{sp_{i2}} l_{i1} \\bm{\\hat{s}}_{i1,3}^T\\Big[ 2 [\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm{r}'_{S_{c,i2}/B} + [\\tilde{\\bm\\omega}_{\\cal B/N}] [\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm{r}_{S_{c,i2}/B} + d_{i2} \\big(\\dot{\\theta}_{i1} + \\dot{\\theta}_{i2}\\big)^2 \\bm{\\hat{s}}_{i2,1}\\Big]",
        "Chain(Add(Mul(Add(Mul(m_{sp_i1}, d_{i1}, Transpose(\\bm{\\hat{s}}_{i1,3})), Mul(m_{sp_i2}, l_{i1}, Transpose(\\bm{\\hat{s}}_{i1,3}))), Call(\\ddot{\\bm{r}}_{B/N})), Mul(Add(Mul(I_{s_i1,2}, Transpose(\\bm{\\hat{s}}_{i1,2})), Neg(Mul(m_{sp_i1}, d_{i1}, Transpose(\\bm{\\hat{s}}_{i1,3}), [ \\tilde { \\bm { r } } _ { S _ { c , i 1 } / B } ])), Neg(Mul(m_{sp_i2}, l_{i1}, Transpose(\\bm{\\hat{s}}_{i1,3}), [ \\tilde { \\bm { r } } _ { S _ { c , i 2 } / B } ]))), Call(\\dot { \\bm { \\omega } } _ { \\cal B / N })), Mul(Add(I_{s_i1,2}, Mul(m_{sp_i1}, Pow(d_{i1}; 2)), Mul(m_{sp_i2}, Pow(l_{i1}; 2)), Mul(m_{sp_i2}, l_{i1}, d_{i2}, Transpose(\\bm{\\hat{s}}_{i1,3}), \\bm{\\hat{s}}_{i2,3})), Call(\\ddot{\\theta}_{i1})), Mul(Mul(m_{sp_i2}, l_{i1}, d_{i2}, Transpose(\\bm{\\hat{s}}_{i1,3}), \\bm{\\hat{s}}_{i2,3}), Call(\\ddot{\\theta}_{i2}))), Add(Neg(Mul(Add(I_{s_i1,1}, Neg(I_{s_i1,3})), \\omega_{s_i1,3}, \\omega_{s_i1,1})), Neg(Mul(k_{i1}, Call(\\theta_{i1}))), Neg(Mul(c_{i1}, Call(\\dot{\\theta}_{i1}))), Mul(k_{i2}, Call(\\theta_{i2})), Mul(c_{i2}, Call(\\dot{\\theta}_{i2})), Mul(Transpose(\\bm{\\hat{s}}_{i1,2}), \\bm{\\tau}_{ext_i1,H_i1}), Mul(l_{i1}, Transpose(\\bm{\\hat{s}}_{i1,3}), \\bm{F}_{ext_i2}), Neg(Mul(m_{sp_i1}, d_{i1}, Transpose(\\bm{\\hat{s}}_{i1,3}), [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{r}_{S_c,i1/B})), Neg(Mul(m_{sp_i2}, l_{i1}, Transpose(\\bm{\\hat{s}}_{i1,3}), Add(Mul(2, [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{r}_{S_c,i2/B}'), Mul([ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{r}_{S_c,i2/B}), Mul(d_{i2}, Pow(Add(Call(\\dot{\\theta}_{i1}), Call(\\dot{\\theta}_{i2})); 2), \\bm{\\hat{s}}_{i2,1}))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "W(t) = \\int_{t_0}^{t_f} P(t) \\text{d}t",
        "Chain(Call(W; t), Integral(Call(P; t); t; t_0; t_f); =)",
        "moorepants/learn-multibody-dynamics/energy.rst",
    ),
    (
        "\\max_{v_n, \\alpha} \\quad & \\alpha, \\\\ \\textrm{subject to} \\quad & J^G(q)v_n = \\alpha V^{G_d}, \\\\ & 0 \\le \\alpha \\le 1, \\\\ & \\text{additional constraints}.",
        "System(Words(Limiting(max; _{ v _ { n } , \\alpha }; \\alpha)), Words(\\text{subject~to}), Chain(Mul(Call(J ^ { G }; q), v_n), Mul(\\alpha, V ^ { G _ { d } }); =), Chain(0, \\alpha, 1; \\le, \\le), Words(\\text{additional~constraints}))",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "z = [x, y, v,\\phi]",
        "Chain(z, Tuple(x, y, v, \\phi; []); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/model_predictive_speed_and_steering_control/model_predictive_speed_and_steering_control_main.rst",
    ),
    (
        "M_E(q) \\ddot{p}^E + C_E(q,\\dot{q})\\dot{q} = f^{B_E}_g(q) + f^{B_E}_u + f^{B_E}_{ext} ,",
        "Chain(Add(Mul(Call(M_E; Call(q)), Call(\\ddot { p } ^ { E })), Mul(Call(C_E; Call(q), Call(\\dot{q})), Call(\\dot{q}))), Add(Call(f _ { g } ^ { B _ { E } }; Call(q)), f _ { u } ^ { B _ { E } }, f _ { e x t } ^ { B _ { E } }); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "\\Delta\\Omega_i = \\Omega_i - \\Omega_{i,d}",
        "Chain(\\Delta \\Omega _ { i }, Add(\\Omega_i, Neg(\\Omega_{i,d})); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/rwNullSpace/_Documentation/secModuleDescription.tex",
    ),
    (
        "\\{\\boldsymbol{v}_{xyz}\\} = \\left[\\mathbf{Q}\\right]^T\\{\\boldsymbol{v}_{\\ell mn}\\}",
        "Chain(Tuple(\\boldsymbol{v}_{xyz}; {}), Mul(Transpose([ \\mathbf { Q } ]), Tuple(\\boldsymbol{v}_{\\ell mn}; {})); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "\\pmb\\sigma_{\\mathcal{B}/\\mathcal{R}} = (\\sigma_{1}, \\sigma_{2}, \\sigma_{3})^{T}",
        "Chain(\\pmb{\\sigma}_{\\mathcal B/\\mathcal R}, Transpose(Tuple(\\sigma_1, \\sigma_2, \\sigma_3; ())); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attControl/mrpSteering/mrpSteering.rst",
    ),
    (
        "p_t=p_{t-1}*h(z)",
        "Chain(p_t, Operated(*; p_{t-1}; Call(h; z)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/histogram_filter_localization/histogram_filter_localization_main.rst",
    ),
    (
        "\\frac{da}{dt} = \\left(\\frac{\\frac{1}{2} + a0}{\\tau_a \\left(\\frac{1}{2} + \\frac{3a}{2}\\right)} + \\frac{\\left(\\frac{1}{2} + \\frac{3a}{2}\\right) \\left(\\frac{1}{2} - a0\\right)}{\\tau_d}\\right) \\left(e - a\\right)",
        "Chain(Derivative(Call(a); t, 1), Mul(Add(Div(Add(Div(1; 2), \\text{a0}); Mul(\\tau_a, Add(Div(1; 2), Div(Mul(3, Call(a)); 2)))), Div(Mul(Add(Div(1; 2), Div(Mul(3, Call(a)); 2)), Add(Div(1; 2), Neg(\\text{a0}))); \\tau_d)), Add(e, Neg(Call(a)))); =)",
        "sympy/sympy/sympy/physics/biomechanics/activation.py",
    ),
    (
        "\\cos\\nu = \\frac{e - \\cos E}{e\\cos E - 1}",
        "Chain(Call(cos; \\nu), Div(Add(e, Neg(Call(cos; E))); Add(Mul(e, Call(cos; E)), Neg(1))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "\\dot{\\bm\\omega}_{R/N} = \\dot{\\bm\\omega}_{R/R_{0}} + \\dot{\\bm\\omega}_{R_{0}/N} = \\dot{\\bm\\omega}_{R_{0}/N} = \\left( \\frac{1+e\\cos f}{1+e^{2}+2 e \\cos f} \\ddot f - \\frac{ e (e^{2}-1)\\sin f }{ (1+e^{2}+2 e \\cos f)^{2} } \\dot f^{2} \\right) \\hat{\\bm\\imath}_{h}",
        "Chain(Call(\\dot{\\bm{\\omega}}_{R/N}), Add(Call(\\dot{\\bm{\\omega}}_{R/R_0}), Call(\\dot{\\bm{\\omega}}_{R_0/N})), Call(\\dot{\\bm{\\omega}}_{R_0/N}), Mul(Add(Mul(Div(Add(1, Mul(e, Call(cos; Call(f)))); Add(1, Pow(e; 2), Mul(2, e, Call(cos; Call(f))))), Call(\\ddot{f})), Neg(Mul(Div(Mul(e, Add(Pow(e; 2), Neg(1)), Call(sin; Call(f))); Pow(Add(1, Pow(e; 2), Mul(2, e, Call(cos; Call(f)))); 2)), Pow(Call(\\dot{f}); 2)))), \\hat{\\bm{\\imath}}_h); =, =, =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/velocityPoint/_Documentation/velocityPoint.tex",
    ),
    (
        "p_r = \\frac{\\partial L}{\\partial \\dot{q_r}}",
        "Chain(p_r, Derivative(Call(L); \\dot{q}_r, 1; True); =)",
        "moorepants/learn-multibody-dynamics/lagrange.rst",
    ),
    (
        "\\operatorname{proj}_{S}(\\vec{x}) = \\frac{\\langle \\vec{x}, \\vec{v}_1 \\rangle}{ \\langle \\vec{v}_1, \\vec{v}_1 \\rangle } \\vec{v}_1 + \\frac{\\langle \\vec{x}, \\vec{v}_2 \\rangle}{ \\langle \\vec{v}_2, \\vec{v}_2 \\rangle } \\vec{v}_2 + \\cdots + \\frac{\\langle \\vec{x}, \\vec{v}_n \\rangle}{ \\langle \\vec{v}_n, \\vec{v}_n \\rangle } \\vec{v}_n .",
        "Chain(Call(\\text{proj}_S; \\vec{x}), Add(Mul(Div(Pair(\\vec{x}; \\vec{v}_1); Pair(\\vec{v}_1; \\vec{v}_1)), \\vec{v}_1), Mul(Div(Pair(\\vec{x}; \\vec{v}_2); Pair(\\vec{v}_2; \\vec{v}_2)), \\vec{v}_2), Dots(), Mul(Div(Pair(\\vec{x}; \\vec{v}_n); Pair(\\vec{v}_n; \\vec{v}_n)), \\vec{v}_n)); =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "P_1 = P_3 + \\frac{1}{2}\\rho_p V_n^2 + K_p\\left(\\frac{1}{2}\\rho_p V_n^2\\right)",
        "Chain(P_1, Add(P_3, Mul(Div(1; 2), \\rho_p, Pow(V_n; 2)), Mul(K_p, Mul(Div(1; 2), \\rho_p, Pow(V_n; 2)))); =)",
        "CalebBell/fluids/fluids/jet_pump.py",
    ),
    (
        "A = \\frac{\\sqrt{2} m \\sqrt{\\frac{K}{\\rho \\left(P_{1} - P_{2}\\right)}}}{2}",
        "Chain(A, Div(Mul(Sqrt(2), m, Sqrt(Div(K; Mul(\\rho, Add(P_1, Neg(P_2)))))); 2); =)",
        "CalebBell/fluids/fluids/safety_valve.py",
    ),
    (
        "\\tilde{U}_{n,2\\,j-1} &=& a_j\\,\\cos(d_j\\,t_n) + b_j\\,\\sin(d_j\\,t_n) \\\\ \\tilde{U}_{n,2\\,j} &=& a_j\\,\\sin(d_j\\,t_n) - b_j\\,\\cos(d_j\\,t_n) \\\\ \\tilde{V}_{m,2\\,j-1} &=& \\cos(d_j\\,t_m) \\\\ \\tilde{V}_{m,2\\,j} &=& \\sin(d_j\\,t_m) \\\\ \\tilde{W}_{n,2\\,j-1} &=& e^{-c_j\\,t_n}\\,W_{n,2\\,j-1} \\\\ \\tilde{W}_{n,2\\,j} &=& e^{-c_j\\,t_n}\\,W_{n,2\\,j}",
        "System(Chain(\\tilde{U}_{n,2\\,j-1}, Add(Mul(a_j, Call(cos; Mul(d_j, t_n))), Mul(b_j, Call(sin; Mul(d_j, t_n)))); =), Chain(\\tilde{U}_{n,2\\,j}, Add(Mul(a_j, Call(sin; Mul(d_j, t_n))), Neg(Mul(b_j, Call(cos; Mul(d_j, t_n))))); =), Chain(\\tilde{V}_{m,2\\,j-1}, Call(cos; Mul(d_j, t_m)); =), Chain(\\tilde{V}_{m,2\\,j}, Call(sin; Mul(d_j, t_m)); =), Chain(\\tilde{W}_{n,2\\,j-1}, Mul(Pow(e; Neg(Mul(c_j, t_n))), W_{n,2\\,j-1}); =), Chain(\\tilde{W}_{n,2\\,j}, Mul(Pow(e; Neg(Mul(c_j, t_n))), W_{n,2\\,j}); =))",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "{\\bf p}_{c1} = \\begin{bmatrix} l_{c1} s_1 \\\\ -l_{c1} c_1 \\end{bmatrix}, \\quad {\\bf p}_{c2} = \\begin{bmatrix} l_1 s_1 + l_{c2} s_{1+2} \\\\ -l_1 c_1 - l_{c2} c_{1+2} \\end{bmatrix},",
        "System(Chain(\\mathbf{p}_{c1}, MatrixOf(Mul(l_{c1}, s_1), Neg(Mul(l_{c1}, c_1))); =), Chain(\\mathbf{p}_{c2}, MatrixOf(Add(Mul(l_1, s_1), Mul(l_{c2}, s_{1+2})), Add(Neg(Mul(l_1, c_1)), Neg(Mul(l_{c2}, c_{1+2})))); =))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "{}^A\\bar{\\alpha}^Z \\neq {}^A\\bar{\\alpha}^B + {}^B\\bar{\\alpha}^C + \\ldots + {}^Y\\bar{\\alpha}^Z",
        "Chain(\\prescript { A } { } { \\bar { \\alpha } } ^ { Z }, Add(\\prescript { A } { } { \\bar { \\alpha } } ^ { B }, \\prescript { B } { } { \\bar { \\alpha } } ^ { C }, Dots(), \\prescript { Y } { } { \\bar { \\alpha } } ^ { Z }); \\ne)",
        "moorepants/learn-multibody-dynamics/angular.rst",
    ),
    (
        "K_{1,sharp} = \\left[1.2 + \\frac{160}{\\text{Re}_1}\\right] \\left[ \\left(\\frac{D_1} {D_2} \\right)^4 -1 \\right]",
        "Chain(K_{1,sharp}, Mul(Add(1.2, Div(160; \\text{Re}_1)), Add(Pow(Div(D_1; D_2); 4), Neg(1))); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "V_{\\text{orb}} = \\frac{\\mu}{\\vert \\bm r_{C/N} \\vert}",
        "Chain(V_{orb}, Div(\\mu; Bars(\\bm{r}_{C/N})); =)",
        "AVSLab/basilisk/src/simulation/dynamics/spacecraft/_Documentation/Spacecraft/secModelDescription.tex",
    ),
    (
        "J=\\frac{1}{2}(u_a^2+u_{\\delta}^2)-\\phi_a d_a-\\phi_\\delta d_\\delta",
        "Chain(J, Add(Mul(Div(1; 2), Add(Pow(u_a; 2), Pow(u_\\delta; 2))), Neg(Mul(\\phi_a, d_a)), Neg(Mul(\\phi_\\delta, d_\\delta))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/cgmres_nmpc/cgmres_nmpc_main.rst",
    ),
    (
        "\\begin{bmatrix} \\hat{b}_x \\\\ \\hat{b}_y \\\\ \\hat{b}_z \\end{bmatrix} = {}^B\\mathbf{C}^A \\begin{bmatrix} \\hat{a}_x \\\\ \\hat{a}_y \\\\ \\hat{a}_z \\end{bmatrix}",
        "Chain(MatrixOf(\\hat{b}_x, \\hat{b}_y, \\hat{b}_z), Mul(\\prescript { B } { } { \\mathbf { C } } ^ { A }, MatrixOf(\\hat{a}_x, \\hat{a}_y, \\hat{a}_z)); =)",
        "moorepants/learn-multibody-dynamics/orientation.rst",
    ),
    (
        "U = \\begin{bmatrix} U_{0, 0} & U_{0, 1} & U_{0, 2} & \\cdots & U_{0, m-1} & \\cdots & U_{0, n-1} \\\\ 0 & U_{1, 1} & U_{1, 2} & \\cdots & U_{1, m-1} & \\cdots & U_{1, n-1} \\\\ 0 & 0 & U_{2, 2} & \\cdots & U_{2, m-1} & \\cdots & U_{2, n-1} \\\\ \\vdots & \\vdots & \\vdots & \\ddots & \\vdots & \\cdots & \\vdots \\\\ 0 & 0 & 0 & \\cdots & U_{m-1, m-1} & \\cdots & U_{m-1, n-1} \\\\ \\end{bmatrix}",
        "Chain(U, MatrixOf(U_{0,0}, U_{0,1}, U_{0,2}, Dots(), U_{0,m-1}, Dots(), U_{0,n-1}, 0, U_{1,1}, U_{1,2}, Dots(), U_{1,m-1}, Dots(), U_{1,n-1}, 0, 0, U_{2,2}, Dots(), U_{2,m-1}, Dots(), U_{2,n-1}, Dots(), Dots(), Dots(), Dots(), Dots(), Dots(), Dots(), 0, 0, 0, Dots(), U_{m-1,m-1}, Dots(), U_{m-1,n-1}); =)",
        "sympy/sympy/sympy/matrices/decompositions.py",
    ),
    (
        "L = L_\\mathrm{basic} \\big(\\alpha_\\mathrm{B},\\phi_\\mathrm{hyst}\\big) + \\Delta L \\big(\\delta_\\mathrm{flap}\\big) + \\Delta L \\big(\\delta_\\mathrm{e}\\big) + \\Delta L \\big(\\dot{\\alpha}_\\mathrm{B}\\big) + \\Delta L \\big( q \\big)",
        "Chain(L, Add(Call(L_{basic}; Call(\\alpha_B), \\phi_{hyst}), Call(\\Delta L; \\delta_{flap}), Call(\\Delta L; \\delta_e), Call(\\Delta L; Call(\\dot{\\alpha}_B)), Call(\\Delta L; q)); =)",
        "JSBSim-Team/jsbsim-reference-manual/docs/user/concepts/forces-and-moments.md",
    ),
    (
        "S = \\frac{4(1-\\epsilon)}{d_{wire}}",
        "Chain(S, Div(Mul(4, Add(1, Neg(\\epsilon))); d_{wire}); =)",
        "CalebBell/fluids/fluids/packed_tower.py",
    ),
    (
        "M = \\frac{GM}{G}",
        "Chain(M, Div(Mul(G, M); G); =)",
        "Mayitzin/ahrs/ahrs/utils/geodesy.py",
    ),
    (
        "U(\\mathbf{\\bar r}) = \\frac{\\mu}{r} \\sum_{l=0}^\\infty \\sum_{m=0}^l \\bigg(\\frac{R_{\\text{ref}}}{r}\\bigg)^l \\bar A_{l,m}[u] \\{\\bar C_{l,m} R_m[s,t] + \\bar S_{l,m} I_m[s,t]\\}",
        "Chain(Call(U; \\mathbf{\\bar{r}}), Mul(Div(\\mu; r), BigSum(l; 0; Infinity(); BigSum(m; 0; l; Mul(Pow(Div(R_{ref}; r); l), Indexed(\\bar{A}_{lm}; u), Tuple(Add(Mul(\\bar{C}_{lm}, Indexed(R_m; s, t)), Mul(\\bar{S}_{lm}, Indexed(I_m; s, t))); {}))))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/spacecraftPointing/_Documentation/example/secModelDescription.tex",
    ),
    (
        "\\dfrac{\\mathrm{d}}{\\mathrm{d} t} \\frac{\\partial R}{\\partial q_i} - \\frac{\\partial R}{\\partial q_i} = 0\\quad (i=1,2,\\cdots,l)",
        "System(Chain(Add(Derivative(Derivative(Call(R); q_i, 1; True); t, 1), Neg(Derivative(Call(R); q_i, 1; True))), 0; =), Values(i; 1, 2, Dots(), l))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "\\mathbf{a}_{\\mathrm{measured}} = \\mathbf{a}_{\\mathrm{truth}} + \\mathbf{e}_{\\mathrm{a,noise}} + \\mathbf{e}_{\\mathrm{a, bias}}",
        "Chain(\\mathbf{a}_{measured}, Add(\\mathbf{a}_{truth}, \\mathbf{e}_{a,noise}, \\mathbf{e}_{a,bias}); =)",
        "AVSLab/basilisk/src/architecture/utilities/_Documentation/discretize/secModelDescription.tex",
    ),
    (
        "u = u_\\text{d} - K (\\hat x - x_\\text{d}).",
        "Chain(u, Add(u_d, Neg(Mul(K, Add(\\hat{x}, Neg(x_d))))); =)",
        "python-control/python-control/doc/stochastic.rst",
    ),
    (
        "\\dot\\theta_{n+1}^{+} = - \\cos(2\\alpha)\\sqrt{(\\dot\\theta_n^{+})^2 - 4 \\frac{g}{l} \\sin\\alpha \\sin\\gamma}.",
        "Chain(Call(\\dot { \\theta } _ { n + 1 } ^ { + }), Neg(Mul(Call(cos; Mul(2, \\alpha)), Sqrt(Add(Pow(Call(\\dot { \\theta } _ { n } ^ { + }); 2), Neg(Mul(4, Div(g; l), Call(sin; \\alpha), Call(sin; \\gamma))))))); =)",
        "RussTedrake/underactuated/book/simple_legs.html",
    ),
    (
        "\\kappa^{\\prime}=2 A / L^{2}",
        "Chain(\\kappa', Div(Mul(2, A); Pow(L; 2)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/clothoid_path/clothoid_path_main.rst",
    ),
    (
        "C = \\left( \\begin{matrix} 1 \\\\ 0 \\\\ 0 \\end{matrix} \\right)",
        "Chain(C, MatrixOf(1, 0, 0); =)",
        "sympy/sympy/doc/src/modules/simplify/hyperexpand.rst",
    ),
    (
        "e^\\mathbf{v} = e^{\\mathbf{u}\\theta} = \\Big(1 - \\frac{\\theta^2}{2!} + \\frac{\\theta^4}{4!} + \\cdots\\Big) + \\Big(\\mathbf{u}\\theta - \\frac{\\mathbf{u}\\theta^3}{3!} + \\frac{\\mathbf{u}\\theta^5}{5!} + \\cdots\\Big)",
        "Chain(Pow(e; \\mathbf{v}), Pow(e; Mul(\\mathbf{u}, \\theta)), Add(Add(1, Neg(Div(Pow(\\theta; 2); Factorial(2))), Div(Pow(\\theta; 4); Factorial(4)), Dots()), Add(Mul(\\mathbf{u}, \\theta), Neg(Div(Mul(\\mathbf{u}, Pow(\\theta; 3)); Factorial(3))), Div(Mul(\\mathbf{u}, Pow(\\theta; 5)); Factorial(5)), Dots())); =, =)",
        "Mayitzin/ahrs/ahrs/filters/angular.py",
    ),
    (
        "x[k+1] &= A x[k] + B u[k] \\\\\\\\ y[k] &= C x[k] + D u[k]",
        "System(Chain(Indexed(x; Add(k, 1)), Add(Mul(A, Indexed(x; k)), Mul(B, Indexed(u; k))); =), Chain(Indexed(y; k), Add(Mul(C, Indexed(x; k)), Mul(D, Indexed(u; k))); =))",
        "python-control/python-control/control/modelsimp.py",
    ),
    (
        "x = \\begin{bmatrix} x_1 \\\\ x_2 \\\\ x_3 \\end{bmatrix} = \\begin{bmatrix} \\theta_1 \\\\ \\dot{\\theta}_1 \\\\ \\theta_2 \\end{bmatrix}",
        "Chain(x, MatrixOf(x_1, x_2, x_3), MatrixOf(Call(\\theta_1), Call(\\dot{\\theta}_1), \\theta_2); =, =)",
        "sympy/sympy/doc/src/tutorials/physics/control/mechanics_problems.rst",
    ),
    (
        "\\boldsymbol{r} = \\boldsymbol{r}_0 + \\boldsymbol{r}'",
        "Chain(\\boldsymbol{r}, Add(\\boldsymbol{r}_0, \\boldsymbol{r}'); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter7.tex",
    ),
    (
        "\\mu'' = \\left(\\frac{m_2}{m_1 + m_2}\\right)^3\\mu",
        "Chain(\\mu'', Mul(Pow(Div(m_2; Add(m_1, m_2)); 3), \\mu); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-relative-motion.md",
    ),
    (
        "\\Phi(t) = a (t - t_0)^2",
        "Chain(Call(\\Phi; t), Mul(a, Pow(Add(t, Neg(t_0)); 2)); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/prescribedRot2DOF/prescribedRot2DOF.rst",
    ),
    (
        "[D_\\text{contr}] = -\\sum_{i=1}^{N}J_{\\text{s}_i} \\hat{\\bm g}_{\\text{s}_i} \\hat{\\bm g}_{\\text{s}_i}^T",
        "Chain([ D _ { \\text { c o n t r } } ], Neg(BigSum(i; 1; N; Mul(J_{s_i}, \\hat{\\bm{g}}_{s_i}, Transpose(\\hat{\\bm{g}}_{s_i})))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/reactionWheels/_Documentation/RWJitterBackSubstitution/Basilisk-RWJitterBackSub-20161221.tex",
    ),
    (
        "x = x_c + x_p = x_{tr} + x_{sp} .",
        "Chain(x, Add(x_c, x_p), Add(x_{tr}, x_{sp}); =, =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "= \\sum_{n=M+1}^{\\infty} \\frac{1}{N^{2n}} \\left(1 + \\frac{N}{2n-1}\\right) \\le \\sum_{n=M+1}^{\\infty} \\frac{N+1}{N^{2n}} = \\frac{1}{N^{2M} (N-1)} \\le \\frac{1}{N^{2M}}.",
        "Chain(Blank(), BigSum(n; Add(M, 1); Infinity(); Mul(Div(1; Pow(N; Mul(2, n))), Add(1, Div(N; Add(Mul(2, n), Neg(1)))))), BigSum(n; Add(M, 1); Infinity(); Div(Add(N, 1); Pow(N; Mul(2, n)))), Div(1; Mul(Pow(N; Mul(2, M)), Add(N, Neg(1)))), Div(1; Pow(N; Mul(2, M))); =, \\le, =, \\le)",
        "fredrik-johansson/arb/doc/source/constants.rst",
    ),
    (
        "\\mathbf{x}_t = [x_t, y_t, \\phi_t, v_t]^T",
        "Chain(\\mathbf{x}_t, Transpose(Tuple(x_t, y_t, \\phi_t, v_t; [])); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/ensamble_kalman_filter_localization_files/ensamble_kalman_filter_localization_main.rst",
    ),
    (
        "W = 0.026P^{0.34}V^{0.6}",
        "Chain(W, Mul(0.026, Pow(P; 0.34), Pow(V; 0.6)); =)",
        "CalebBell/fluids/fluids/jet_pump.py",
    ),
    (
        "\\Big[m_{\\text{sp}_{i2}} d_{i2}\\bm{\\hat{s}}_{i2,3}^T\\Big] \\ddot{\\bm{r}}_{B/N} + \\Big[I_{s_{i2,2}} \\bm{\\hat{s}}_{i2,2}^T - m_{\\text{sp}_{i2}} d_{i2}\\bm{\\hat{s}}_{i2,3}^T [\\tilde{\\bm{r}}_{S_{c,i2}/B}] \\Big] \\dot{\\bm \\omega}_{\\cal{B/N}} + \\Big[I_{s_{i2,2}}\\Big] \\ddot{\\theta}_{i1} + \\Big[I_{s_{i2,2}}\\Big] \\ddot{\\theta}_{i2} \\\\+ m_{\\text{sp}_{i2}} d_{i2}\\bm{\\hat{s}}_{i2,3}^T \\Big[ \\bm{r}''_{S_{c,i2}/B}\\Big] = - (I_{s_{i2,1}} - I_{s_{i2,3}}) \\omega_{s_{i2,3}} \\omega_{s_{i2,1}} -k_{i2} \\theta_{i2} - c_{i2} \\dot{\\theta}_{i2} + \\bm{\\hat{s}}_{i2,2} \\cdot \\bm \\tau_{\\text{ext}_{i2},H_{i2}} \\\\ - m_{\\text{sp}_{i2}} d_{i2}\\bm{\\hat{s}}_{i2,3}^T \\Big[ 2 [\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm{r}'_{S_{c,i2}/B} + [\\tilde{\\bm\\omega}_{\\cal B/N}] [\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm{r}_{S_{c,i2}/B}\\Big]",
        "Chain(Add(Mul(Mul(m_{sp_i2}, d_{i2}, Transpose(\\bm{\\hat{s}}_{i2,3})), Call(\\ddot{\\bm{r}}_{B/N})), Mul(Add(Mul(I_{s_i2,2}, Transpose(\\bm{\\hat{s}}_{i2,2})), Neg(Mul(m_{sp_i2}, d_{i2}, Transpose(\\bm{\\hat{s}}_{i2,3}), [ \\tilde { \\bm { r } } _ { S _ { c , i 2 } / B } ]))), Call(\\dot { \\bm { \\omega } } _ { \\cal B / N })), Mul(I_{s_i2,2}, Call(\\ddot{\\theta}_{i1})), Mul(I_{s_i2,2}, Call(\\ddot{\\theta}_{i2})), Mul(m_{sp_i2}, d_{i2}, Transpose(\\bm{\\hat{s}}_{i2,3}), \\bm{r}_{S_c,i2/B}'')), Add(Neg(Mul(Add(I_{s_i2,1}, Neg(I_{s_i2,3})), \\omega_{s_i2,3}, \\omega_{s_i2,1})), Neg(Mul(k_{i2}, Call(\\theta_{i2}))), Neg(Mul(c_{i2}, Call(\\dot{\\theta}_{i2}))), Mul(\\bm{\\hat{s}}_{i2,2}, \\bm{\\tau}_{ext_i2,H_i2}; 1), Neg(Mul(m_{sp_i2}, d_{i2}, Transpose(\\bm{\\hat{s}}_{i2,3}), Add(Mul(2, [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{r}_{S_c,i2/B}'), Mul([ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{r}_{S_c,i2/B}))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\bar{g}_d = \\mathbf{T}^T\\left(\\bar{F} - \\bar{g}\\right)",
        "Chain(\\bar{g}_d, Mul(Transpose(\\mathbf{T}), Add(\\bar{F}, Neg(\\bar{g}))); =)",
        "moorepants/learn-multibody-dynamics/tmt.rst",
    ),
    (
        "\\dot{\\theta}(t) = \\dot{\\theta}(t_{s2})",
        "Chain(Call(\\dot{\\theta}; t), Call(\\dot{\\theta}; t_{s2}); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedRotation1DOF/prescribedRotation1DOF.rst",
    ),
    (
        "\\dot{\\theta}_{i1} \\hat{\\bm s}_{i1,2} \\times [I_{\\text{sp}_{i1},S_{c,i1}}]\\bm \\omega_{\\cal{B/N}} = \\dot{\\theta}_{i1} {\\vphantom{\\begin{bmatrix} 0 & 0 & I_{s_{i1,3}} \\\\ 0 & 0 & 0 \\\\ -I_{s_{i1,1}} & 0 & 0 \\end{bmatrix}}}^{\\mathcal{S}_{i1}\\!}{\\begin{bmatrix} 0 & 0 & I_{s_{i1,3}} \\\\ 0 & 0 & 0 \\\\ -I_{s_{i1,1}} & 0 & 0 \\end{bmatrix}} {\\vphantom{\\bm \\omega_{\\cal{B/N}}}}^{\\mathcal{S}_{i1}\\!}{\\bm \\omega_{\\cal{B/N}}}",
        "Chain(Cross(Mul(Call(\\dot{\\theta}_{i1}), \\hat{\\bm{s}}_{i1,2}); Mul([ I _ { \\text { s p } _ { i 1 } , S _ { c , i 1 } } ], \\bm{\\omega}_{\\cal B/N})), Mul(Call(\\dot{\\theta}_{i1}), Marked(MatrixOf(0, 0, I_{s_i1,3}, 0, 0, 0, Neg(I_{s_i1,1}), 0, 0); _{ \\mathcal { S } _ { i 1 } }), \\prescript { \\mathcal { S } _ { i 1 } \\! } { } { \\bm { \\omega } } _ { \\cal B / N }); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\bar{f}_h(\\bar{q}, \\bar{q}_r, t) = 0 \\in \\mathbb{R}^M",
        "Chain(Call(\\bar{f}_h; \\bar{q}, \\bar{q}_r, t), 0, Pow(\\mathbb{R}; M); =, \\in)",
        "moorepants/learn-multibody-dynamics/holonomic-eom.rst",
    ),
    (
        "\\log(2x) - 15 = 0",
        "Chain(Add(Call(log; Mul(2, x)), Neg(15)), 0; =)",
        "sympy/sympy/sympy/solvers/solveset.py",
    ),
    (
        "u_1' = u_2, \\qquad u_2' = u_3, \\qquad u_3' = 2u_3 + 8u_2 + u_1 + t .",
        "System(Chain(u_1', u_2; =), Chain(u_2', u_3; =), Chain(u_3', Add(Mul(2, u_3), Mul(8, u_2), u_1, t); =))",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "e = \\frac{z_0}{R_E \\left(1 + \\cos\\nu\\right) + z_0}",
        "Chain(e, Div(z_0; Add(Mul(R_E, Add(1, Call(cos; \\nu))), z_0)); =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/single-impulse-example.md",
    ),
    (
        "z(t) = \\sum_{i=1}^N c_i \\psi_i(t), \\qquad c_i \\in R",
        "System(Chain(Call(z; t), BigSum(i; 1; N; Mul(c_i, Call(\\psi_i; t))); =), Chain(c_i, R; \\in))",
        "python-control/python-control/doc/flatsys.rst",
    ),
    (
        "f(x) := \\frac{1}{2s}\\left(1+\\cos\\left(\\frac{x-\\mu}{s}\\pi\\right)\\right)",
        "Chain(Call(f; x), Mul(Div(1; Mul(2, s)), Add(1, Call(cos; Mul(Div(Add(x, Neg(\\mu)); s), \\pi)))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "\\mathbf{q} = \\frac{\\mathbf{W} + \\mathbf{I}}{2} \\mathbf{q}_\\mathrm{rand}",
        "Chain(\\mathbf{q}, Mul(Div(Add(\\mathbf{W}, \\mathbf{I}); 2), \\mathbf{q}_{rand}); =)",
        "Mayitzin/ahrs/ahrs/filters/oleq.py",
    ),
    (
        "\\mathbf{m}_d(\\mathbf{q}, t) \\ddot{\\mathbf{q}} + \\mathbf{\\Lambda}(\\mathbf{q}, t) \\mathbf{\\lambda} + \\mathbf{f}_d(\\dot{\\mathbf{q}}, \\mathbf{q}, t) = 0",
        "Chain(Add(Mul(Call(\\mathbf{m}_d; Call(\\mathbf{q}), t), Call(\\ddot{\\mathbf{q}})), Mul(Call(\\mathbf{\\Lambda}; Call(\\mathbf{q}), t), \\mathbf{\\lambda}), Call(\\mathbf{f}_d; Call(\\dot{\\mathbf{q}}), Call(\\mathbf{q}), t)), 0; =)",
        "sympy/sympy/doc/src/explanation/modules/physics/mechanics/lagrange.rst",
    ),
    (
        "r^2 \\dot{\\theta} = l = av_0 = a\\sqrt{\\frac{9ag}{2}}",
        "Chain(Mul(Pow(r; 2), Call(\\dot{\\theta})), l, Mul(a, v_0), Mul(a, Sqrt(Div(Mul(9, a, g); 2))); =, =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "\\mu_m = x\\mu_g + (1-x)\\mu_l",
        "Chain(\\mu_m, Add(Mul(x, \\mu_g), Mul(Add(1, Neg(x)), \\mu_l)); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "\\psi(s,z) = \\frac{\\zeta'(s+1,z) + (\\gamma + \\psi(-s)) \\zeta(s+1,z)}{\\Gamma(-s)}",
        "Chain(Call(\\psi; s, z), Div(Add(Call(\\zeta'; Add(s, 1), z), Mul(Add(\\gamma, Call(\\psi; Neg(s))), Call(\\zeta; Add(s, 1), z))); Call(Gamma; Neg(s))); =)",
        "fredrik-johansson/arb/doc/source/acb.rst",
    ),
    (
        "r^{+}_{\\text{ellipse}} = r_a",
        "Chain(r _ { \\text { e l l i p s e } } ^ { + }, r_a; =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables.md",
    ),
    (
        "\\begin{array}{rcl} a_y &=& -\\cos\\theta\\sin\\phi \\\\ a_z &=& -\\cos\\theta\\cos\\phi \\end{array}",
        "System(Chain(a_y, Neg(Mul(Call(cos; \\theta), Call(sin; \\phi))); =), Chain(a_z, Neg(Mul(Call(cos; \\theta), Call(cos; \\phi))); =))",
        "Mayitzin/ahrs/ahrs/filters/fqa.py",
    ),
    (
        "\\frac{d}{dt}\\left(\\dot{\\boldsymbol{r}}\\times\\boldsymbol{h}\\right) = \\ddot{\\boldsymbol{r}}\\times\\boldsymbol{h} + \\dot{\\boldsymbol{r}}\\times\\dot{\\boldsymbol{h}}",
        "Chain(Derivative(Cross(Call(\\dot{\\boldsymbol{r}}); Call(\\boldsymbol{h})); t, 1), Add(Cross(Call(\\ddot{\\boldsymbol{r}}); Call(\\boldsymbol{h})), Cross(Call(\\dot{\\boldsymbol{r}}); Call(\\dot{\\boldsymbol{h}}))); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/the-orbit-equation.md",
    ),
    (
        "\\tan(\\delta) = \\delta",
        "Chain(Call(tan; \\delta), \\delta; =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/lqr_speed_and_steering_control/lqr_speed_and_steering_control_main.rst",
    ),
    (
        "A_{l,l}[u] &= (2 l -1) A_{l-1,l-1}[u] \\\\ A_{l,l-1}[u] &= u A_{l,l}[u]",
        "System(Chain(Indexed(A_{l,l}; u), Mul(Add(Mul(2, l), Neg(1)), Indexed(A_{l-1,l-1}; u)); =), Chain(Indexed(A_{l,l-1}; u), Mul(u, Indexed(A_{l,l}; u)); =))",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/spacecraftPointing/_Documentation/example/secModelDescription.tex",
    ),
    (
        "\\boldsymbol{a} = \\sum_{\\alpha=1}^3 a_\\alpha \\boldsymbol{e}_\\alpha",
        "Chain(\\boldsymbol{a}, BigSum(\\alpha; 1; 3; Mul(a_{\\alpha}, \\boldsymbol{e}_{\\alpha})); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Kinematics.tex",
    ),
    (
        "\\gamma'_1 = - \\gamma_2",
        "Chain(\\gamma_1', Neg(\\gamma_2); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/interplanetary-transfer-phasing.md",
    ),
    (
        "{\\bf A}^T {\\bf P}{\\bf E} + {\\bf E}^T {\\bf P} {\\bf A} = -{\\bf Q},",
        "Chain(Add(Mul(Transpose(\\mathbf{A}), \\mathbf{P}, \\mathbf{E}), Mul(Transpose(\\mathbf{E}), \\mathbf{P}, \\mathbf{A})), Neg(\\mathbf{Q}); =)",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "\\dot{\\theta} = \\sqrt{\\frac{2g}{\\pi R} \\left(\\frac12 \\theta^2 - \\cos \\theta + 1\\right)} = 2\\sqrt{\\frac{g}{\\pi R}\\left[\\left(\\frac{\\theta}{2}\\right)^2+ \\sin^2 \\frac{\\theta}{2}\\right]}",
        "Chain(Call(\\dot{\\theta}), Sqrt(Mul(Div(Mul(2, g); Mul(\\pi, R)), Add(Mul(Div(1; 2), Pow(Call(\\theta); 2)), Neg(Call(cos; Call(\\theta))), 1))), Mul(2, Sqrt(Mul(Div(g; Mul(\\pi, R)), Add(Pow(Div(Call(\\theta); 2); 2), Pow(Call(sin; Div(Call(\\theta); 2)); 2))))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "A = \\frac{190.5m}{P_1 K_d K_b K_c K_N K_{SH}}",
        "Chain(A, Div(Mul(190.5, m); Mul(P_1, K_d, K_b, K_c, K_N, K_{SH})); =)",
        "CalebBell/fluids/fluids/safety_valve.py",
    ),
    (
        "x' = f_1(x) g_1(y) \\phi(x,y,t)",
        "Chain(x', Mul(Call(f_1; x), Call(g_1; y), Call(\\phi; x, y, t)); =)",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "[I_{\\text{sp}_{i1},S_{c,i1}}] \\dot{\\theta}_{i1} \\hat{\\bm s}_{i1,2} \\times \\bm \\omega_{\\cal{B/N}} = \\dot{\\theta}_{i1} {\\vphantom{\\begin{bmatrix} I_{s_{i1,1}} & 0 & 0 \\\\ 0 & I_{s_{i1,2}} & 0 \\\\ 0 & 0 & I_{s_{i1,3}} \\end{bmatrix}}}^{\\mathcal{S}_{i1}\\!}{\\begin{bmatrix} 0 & 0 & I_{s_{i1,1}} \\\\ 0 & 0 & 0 \\\\ -I_{s_{i1,3}} & 0 & 0 \\end{bmatrix}} {\\vphantom{\\bm \\omega_{\\cal{B/N}}}}^{\\mathcal{S}_{i1}\\!}{\\bm \\omega_{\\cal{B/N}}}",
        "Chain(Cross(Mul([ I _ { \\text { s p } _ { i 1 } , S _ { c , i 1 } } ], Call(\\dot{\\theta}_{i1}), \\hat{\\bm{s}}_{i1,2}); \\bm{\\omega}_{\\cal B/N}), Mul(Call(\\dot{\\theta}_{i1}), Marked(MatrixOf(0, 0, I_{s_i1,1}, 0, 0, 0, Neg(I_{s_i1,3}), 0, 0); _{ \\mathcal { S } _ { i 1 } }), \\prescript { \\mathcal { S } _ { i 1 } \\! } { } { \\bm { \\omega } } _ { \\cal B / N }); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\Delta \\theta_{\\text{coast}} = (\\theta_{\\text{ref}} - \\theta_0) - 2 (\\theta(t_{b1}) - \\theta_0)",
        "Chain(\\Delta \\theta _ { \\text { c o a s t } }, Add(Add(\\theta_{ref}, Neg(\\theta_0)), Neg(Mul(2, Add(Call(\\theta; t_{b1}), Neg(\\theta_0))))); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedRotation1DOF/prescribedRotation1DOF.rst",
    ),
    (
        "\\alpha = 0.833\\alpha_h",
        "Chain(\\alpha, Mul(0.833, \\alpha_h); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "\\frac{\\mathrm{d}}{\\mathrm{d}t}\\left(\\frac{\\partial L}{\\partial \\dot{q}_r} \\right) - \\frac{\\partial L}{\\partial q_r} = F_r^\\textrm{nc} \\textrm{ for } r = 1,\\ldots,n",
        "System(Chain(Add(Derivative(Derivative(Call(L); \\dot{q}_r, 1; True); t, 1), Neg(Derivative(Call(L); q_r, 1; True))), F _ { r } ^ { \\text { n c } }; =), Values(r; 1, Dots(), n))",
        "moorepants/learn-multibody-dynamics/lagrange.rst",
    ),
    (
        "V({\\bf x}) = {\\bf x}^T {\\bf P} {\\bf x}, \\quad {\\bf P} = {\\bf P^T} \\succ 0,",
        "System(Chain(Call(V; \\mathbf{x}), Mul(Transpose(\\mathbf{x}), \\mathbf{P}, \\mathbf{x}); =), Chain(\\mathbf{P}, Transpose(\\mathbf{P}), 0; =, \\succ))",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "\\zeta(s, a) = \\sum_{n=0}^\\infty \\frac{1}{(n + a)^s},",
        "Chain(Call(\\zeta; s, a), BigSum(n; 0; Infinity(); Div(1; Pow(Add(n, a); s))); =)",
        "sympy/sympy/sympy/functions/special/zeta_functions.py",
    ),
    (
        "\\begin{split} {^{\\cal N}\\hat{{\\bm x}}} &= {^{\\cal N}\\hat{{\\bm \\rho}}} \\\\ {^{\\cal N}\\hat{{\\bm y}}} &= {\\hat{\\bm z}} \\times {^{\\cal N}\\hat{{\\bm \\rho}}} \\\\ {^{\\cal N}\\hat{{\\bm z}}} &= {^{\\cal N}\\hat{{\\bm x}}} \\times {^{\\cal N}\\hat{{\\bm y}}} \\end{split}",
        "System(Chain(\\prescript { \\mathcal { N } } { } { \\hat { \\bm { x } } }, \\prescript { \\mathcal { N } } { } { \\hat { \\bm { \\rho } } }; =), Chain(\\prescript { \\mathcal { N } } { } { \\hat { \\bm { y } } }, Cross(\\hat{\\bm{z}}; \\prescript { \\mathcal { N } } { } { \\hat { \\bm { \\rho } } }); =), Chain(\\prescript { \\mathcal { N } } { } { \\hat { \\bm { z } } }, Cross(\\prescript { \\mathcal { N } } { } { \\hat { \\bm { x } } }; \\prescript { \\mathcal { N } } { } { \\hat { \\bm { y } } }); =))",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/spacecraftPointing/_Documentation/secModuleDescription.tex",
    ),
    (
        "E_{\\min} \\approx 0.1,\\quad E_{\\max} \\approx E_{\\mathrm{grid,max}}",
        "System(Chain(E_\\min, 0.1; \\approx), Chain(E_\\max, E_{grid,max}; \\approx))",
        "AVSLab/basilisk/src/simulation/environment/spacecraftChargingEquilibrium/spacecraftChargingEquilibrium.rst",
    ),
    (
        "T = \\left[\\frac{(dP/dL)_{l,s,f}}{(\\rho_l-\\rho_g)g\\cos\\theta}\\right]^{0.5}",
        "Chain(T, Pow(Div(Marked(Derivative(Call(P); L, 1); _{ l , s , f }); Mul(Add(\\rho_l, Neg(\\rho_g)), g, Call(cos; \\theta))); 0.5); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "{ {\\boldsymbol{z}}} = K^{-1}\\,{ {\\boldsymbol{y}}} = {(L^\\mathrm{T})}^{-1}\\,D^{-1}\\,L^{-1}\\,{ {\\boldsymbol{y}}} \\quad.",
        "Chain(\\boldsymbol{z}, Mul(Pow(K; Neg(1)), \\boldsymbol{y}), Mul(Pow(Transpose(L); Neg(1)), Pow(D; Neg(1)), Pow(L; Neg(1)), \\boldsymbol{y}); =, =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "p^E = f_{kin}(q), \\qquad v^E = \\dot{p}^E = J(q) \\dot{q}, \\qquad a^E = \\ddot{p}^E = J(q)\\ddot{q} + \\dot{J}(q) \\dot{q}.",
        "System(Chain(Call(p ^ { E }), Call(f_{kin}; Call(q)); =), Chain(v ^ { E }, Call(\\dot { p } ^ { E }), Mul(Call(J; Call(q)), Call(\\dot{q})); =, =), Chain(a ^ { E }, Call(\\ddot { p } ^ { E }), Add(Mul(Call(J; Call(q)), Call(\\ddot{q})), Mul(Call(\\dot{J}; Call(q)), Call(\\dot{q}))); =, =))",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "V_f = \\frac{\\pi h^2}{4}\\left(2a_1 + \\frac{D_1^2}{2a_1} - \\frac{4h}{3}\\right),\\; 0 \\le h \\le a_1",
        "System(Chain(V_f, Mul(Div(Mul(\\pi, Pow(h; 2)); 4), Add(Mul(2, a_1), Div(Pow(D_1; 2); Mul(2, a_1)), Neg(Div(Mul(4, h); 3)))); =), Chain(0, h, a_1; \\le, \\le))",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "H = \\frac{1}{2m\\sigma^2(\\xi^2-\\eta^2)}\\left[(\\xi^2-1)p_\\xi^2+(1-\\eta^2)p_\\eta^2+\\left(\\frac{1}{\\xi^2-1}+\\frac{1}{1-\\eta^2}\\right)p_\\phi^2\\right] + V(\\xi,\\eta,\\phi)",
        "Chain(H, Add(Mul(Div(1; Mul(2, m, Pow(\\sigma; 2), Add(Pow(\\xi; 2), Neg(Pow(\\eta; 2))))), Add(Mul(Add(Pow(\\xi; 2), Neg(1)), Pow(p_\\xi; 2)), Mul(Add(1, Neg(Pow(\\eta; 2))), Pow(p_\\eta; 2)), Mul(Add(Div(1; Add(Pow(\\xi; 2), Neg(1))), Div(1; Add(1, Neg(Pow(\\eta; 2))))), Pow(p_\\phi; 2)))), Call(V; \\xi, \\eta, \\phi)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "L_P = m\\mathbf{v}",
        "Chain(L_P, Mul(m, \\mathbf{v}); =)",
        "sympy/sympy/doc/src/explanation/modules/physics/mechanics/masses.rst",
    ),
    (
        "{}^B\\mathbf{C}^N &= {}^B\\mathbf{C}^A {}^A\\mathbf{C}^N \\\\ {}^A\\mathbf{C}^B &= \\left({}^B\\mathbf{C}^N \\left({}^A\\mathbf{C}^N\\right)^T\\right)^T = {}^A\\mathbf{C}^N\\left({}^B\\mathbf{C}^N\\right)^T",
        "System(Chain(\\prescript { B } { } { \\mathbf { C } } ^ { N }, Mul(\\prescript { B } { } { \\mathbf { C } } ^ { A }, \\prescript { A } { } { \\mathbf { C } } ^ { N }); =), Chain(\\prescript { A } { } { \\mathbf { C } } ^ { B }, Transpose(Mul(\\prescript { B } { } { \\mathbf { C } } ^ { N }, Transpose(\\prescript { A } { } { \\mathbf { C } } ^ { N }))), Mul(\\prescript { A } { } { \\mathbf { C } } ^ { N }, Transpose(\\prescript { B } { } { \\mathbf { C } } ^ { N })); =, =))",
        "moorepants/learn-multibody-dynamics/orientation.rst",
    ),
    (
        "m \\ddot{\\boldsymbol{r}} = \\boldsymbol{F}_1 + \\boldsymbol{F}_2",
        "Chain(Mul(m, Call(\\ddot{\\boldsymbol{r}})), Add(\\boldsymbol{F}_1, \\boldsymbol{F}_2); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "g(s) = f\\left(\\frac{L}{\\pi} s \\right)",
        "Chain(Call(g; s), Call(f; Mul(Div(L; \\pi), s)); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\bm u_{s,\\text{cont}} = \\begin{bmatrix} 0.1 & 0.2 & 0.15 & -0.2 \\end{bmatrix} \\text{ Nm}",
        "Chain(\\bm{u}_{s,cont}, Mul(MatrixOf(0.1, 0.2, 0.15, Neg(0.2)), \\text{Nm}); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/rwNullSpace/_Documentation/secTest.tex",
    ),
    (
        "\\sin(\\theta) = \\theta",
        "Chain(Call(sin; \\theta), \\theta; =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/lqr_speed_and_steering_control/lqr_speed_and_steering_control_main.rst",
    ),
    (
        "[P_2P_1] = [PN]_2[NP]_1",
        "Chain([ P _ { 2 } P _ { 1 } ], Mul([ P N ] _ { 2 }, [ N P ] _ { 1 }); =)",
        "AVSLab/basilisk/src/architecture/utilities/_Documentation/discretize/secModelDescription.tex",
    ),
    (
        "A_f = R^2\\cos^{-1}\\frac{R-h}{R} - (R-h)\\sqrt{2Rh - h^2}",
        "Chain(A_f, Add(Mul(Pow(R; 2), Call(arccos; Div(Add(R, Neg(h)); R))), Neg(Mul(Add(R, Neg(h)), Sqrt(Add(Mul(2, R, h), Neg(Pow(h; 2))))))); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "{}^{\\mathbf{N}}\\boldsymbol{\\omega}^{\\mathbf{B}} = (\\frac{{}^{\\mathbf{N}}d \\mathbf{\\hat{b}_y}}{dt}\\cdot\\mathbf{\\hat{b}_z} )\\mathbf{\\hat{b}_x} + (\\frac{{}^{\\mathbf{N}}d \\mathbf{\\hat{b}_z}}{dt}\\cdot \\mathbf{\\hat{b}_x})\\mathbf{\\hat{b}_y} + (\\frac{{}^{\\mathbf{N}}d \\mathbf{\\hat{b}_x}}{dt}\\cdot\\mathbf{\\hat{b}_y})\\mathbf{\\hat{b}_z}",
        "Chain(\\prescript { \\mathbf { N } } { } { \\boldsymbol { \\omega } } ^ { \\mathbf { B } }, Add(Mul(Mul(Marked(Derivative(Call(\\mathbf{\\hat{b}}_y); t, 1); _{ \\mathbf { N } }), Call(\\mathbf{\\hat{b}}_z); 1), Call(\\mathbf{\\hat{b}}_x)), Mul(Mul(Marked(Derivative(Call(\\mathbf{\\hat{b}}_z); t, 1); _{ \\mathbf { N } }), Call(\\mathbf{\\hat{b}}_x); 1), Call(\\mathbf{\\hat{b}}_y)), Mul(Mul(Marked(Derivative(Call(\\mathbf{\\hat{b}}_x); t, 1); _{ \\mathbf { N } }), Call(\\mathbf{\\hat{b}}_y); 1), Call(\\mathbf{\\hat{b}}_z))); =)",
        "sympy/sympy/doc/src/explanation/modules/physics/vector/kinematics/kinematics.rst",
    ),
    (
        "T = \\frac{2\\pi ab}{h}",
        "Chain(T, Div(Mul(2, \\pi, a, b); h); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/elliptical-orbits.md",
    ),
    (
        "\\begin{aligned} r_p &= a\\left(e - 1\\right) & r_a &= -a\\left(e + 1\\right) \\end{aligned}",
        "System(Chain(r_p, Mul(a, Add(e, Neg(1))); =), Chain(r_a, Neg(Mul(a, Add(e, 1))); =))",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/hyperbolic-trajectories.md",
    ),
    (
        "J^*({\\bf x}) = {\\bf x}^T {\\bf E}^T {\\bf S} {\\bf E} {\\bf x}, \\qquad {\\bf u}^* = -{\\bf R}^{-1} {\\bf B}^T {\\bf S} {\\bf E} {\\bf x},",
        "System(Chain(Call(J ^ { * }; \\mathbf{x}), Mul(Transpose(\\mathbf{x}), Transpose(\\mathbf{E}), \\mathbf{S}, \\mathbf{E}, \\mathbf{x}); =), Chain(\\mathbf { u } ^ { * }, Neg(Mul(Pow(\\mathbf{R}; Neg(1)), Transpose(\\mathbf{B}), \\mathbf{S}, \\mathbf{E}, \\mathbf{x})); =))",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "E(\\phi + n \\pi, m) = 2 n E(m) + E(\\phi,m), n \\in \\mathbb{Z}.",
        "System(Chain(Call(E; Add(\\phi, Mul(n, \\pi)), m), Add(Mul(2, n, Call(E; m)), Call(E; \\phi, m)); =), Chain(n, \\mathbb{Z}; \\in))",
        "fredrik-johansson/arb/doc/source/acb_elliptic.rst",
    ),
    (
        "\\mu_m = \\mu_l(1-\\alpha_m)(1 + 2.5\\alpha_m) + \\mu_g\\alpha_m",
        "Chain(\\mu_m, Add(Mul(\\mu_l, Add(1, Neg(\\alpha_m)), Add(1, Mul(2.5, \\alpha_m))), Mul(\\mu_g, \\alpha_m)); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "m_{\\text{sp}_i} d_i \\hat{\\bm s}_{i,3}^{T} \\ddot{\\bm r}_{B/N}+ \\biggl[\\left(I_{s_{i,2}} + m_{\\text{sp}_i}d_i^{2}\\right) \\hat{\\bm s}_{i,2}^{T}-m_{\\text{sp}_i} d_i \\hat{\\bm s}_{i,3}^{T} [\\tilde{\\bm r}_{H_i/B}]\\biggr] \\dot{\\bm\\omega}_{\\cal B/N} \\\\ + \\left( I_{s_{i,2}} + m_{\\text{sp}_i} d_i^{2} \\right) \\ddot \\theta_i = u_i - k_i \\theta_i - c_i \\dot\\theta_i + \\hat{\\bm s}_{i,2}^T \\bm \\tau_{\\text{ext},H_i} + \\left( I_{s_{i,3}} - I_{s_{i,1}} + m_{\\text{sp}_i}d_i^{2}\\right) \\omega_{s_{i,3}} \\omega_{s_{i,1}}\\\\ - m_{\\text{sp}_i} d_i \\hat{\\bm s}_{i,3}^{T} [\\tilde{\\bm\\omega}_{\\cal B/N}][\\tilde{\\bm\\omega}_{\\cal B/N}] \\bm r_{H_i/B}",
        "Chain(Add(Mul(m_{sp_i}, d_i, Transpose(\\hat{\\bm{s}}_{i,3}), Call(\\ddot{\\bm{r}}_{B/N})), Mul(Add(Mul(Add(I_{s_i,2}, Mul(m_{sp_i}, Pow(d_i; 2))), Transpose(\\hat{\\bm{s}}_{i,2})), Neg(Mul(m_{sp_i}, d_i, Transpose(\\hat{\\bm{s}}_{i,3}), [ \\tilde { \\bm { r } } _ { H _ { i } / B } ]))), Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N })), Mul(Add(I_{s_i,2}, Mul(m_{sp_i}, Pow(d_i; 2))), Call(\\ddot{\\theta}_i))), Add(u_i, Neg(Mul(k_i, Call(\\theta_i))), Neg(Mul(c_i, Call(\\dot{\\theta}_i))), Mul(Transpose(\\hat{\\bm{s}}_{i,2}), \\bm{\\tau}_{ext,H_i}), Mul(Add(I_{s_i,3}, Neg(I_{s_i,1}), Mul(m_{sp_i}, Pow(d_i; 2))), \\omega_{s_i,3}, \\omega_{s_i,1}), Neg(Mul(m_{sp_i}, d_i, Transpose(\\hat{\\bm{s}}_{i,3}), [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], [ \\tilde { \\bm { \\omega } } _ { \\mathcal { B } / \\mathcal { N } } ], \\bm{r}_{H_i/B}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/HingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\dot{z} =\\frac{\\partial }{\\partial z} z = f(z, u) = A'z+B'u",
        "Chain(Call(\\dot{z}), Derivative(Call(z); z, 1; True), Call(f; Call(z), u), Add(Mul(A', Call(z)), Mul(B', u)); =, =, =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/model_predictive_speed_and_steering_control/model_predictive_speed_and_steering_control_main.rst",
    ),
    (
        "p = [x, y, z]",
        "Chain(p, Tuple(x, y, z; []); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/3_mapping/normal_vector_estimation/normal_vector_estimation_main.rst",
    ),
    (
        "{\\bf b}[n] = {\\bf T}^n {\\bf b}[0].",
        "Chain(Indexed(\\mathbf{b}; n), Mul(Pow(\\mathbf{T}; n), Indexed(\\mathbf{b}; 0)); =)",
        "RussTedrake/underactuated/book/stochastic.html",
    ),
    (
        "x[n+1] = 4 x[n](1-x[n]),",
        "Chain(Indexed(x; Add(n, 1)), Mul(4, Indexed(x; n), Add(1, Neg(Indexed(x; n)))); =)",
        "RussTedrake/underactuated/book/stochastic.html",
    ),
    (
        "\\left[\\mathbf{Q}\\right] = \\begin{bmatrix}-\\sin\\alpha\\cos\\beta\\sin\\gamma + \\cos\\alpha\\cos\\gamma & \\cos\\alpha\\cos\\beta\\sin\\gamma + \\sin\\alpha\\cos\\gamma & \\sin\\beta\\sin\\gamma\\\\-\\sin\\alpha\\cos\\beta\\sin\\gamma - \\cos\\alpha\\cos\\gamma & \\cos\\alpha\\cos\\beta\\sin\\gamma - \\sin\\alpha\\cos\\gamma & \\sin\\beta\\cos\\gamma \\\\\\sin\\alpha\\sin\\beta & -\\cos\\alpha\\sin\\beta & \\cos\\beta\\end{bmatrix}",
        "Chain([ \\mathbf { Q } ], MatrixOf(Add(Neg(Mul(Call(sin; \\alpha), Call(cos; \\beta), Call(sin; \\gamma))), Mul(Call(cos; \\alpha), Call(cos; \\gamma))), Add(Mul(Call(cos; \\alpha), Call(cos; \\beta), Call(sin; \\gamma)), Mul(Call(sin; \\alpha), Call(cos; \\gamma))), Mul(Call(sin; \\beta), Call(sin; \\gamma)), Add(Neg(Mul(Call(sin; \\alpha), Call(cos; \\beta), Call(sin; \\gamma))), Neg(Mul(Call(cos; \\alpha), Call(cos; \\gamma)))), Add(Mul(Call(cos; \\alpha), Call(cos; \\beta), Call(sin; \\gamma)), Neg(Mul(Call(sin; \\alpha), Call(cos; \\gamma)))), Mul(Call(sin; \\beta), Call(cos; \\gamma)), Mul(Call(sin; \\alpha), Call(sin; \\beta)), Neg(Mul(Call(cos; \\alpha), Call(sin; \\beta))), Call(cos; \\beta)); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "v_{2,max} = v_2(h=h_2)",
        "Chain(v_{2,max}, Call(v_2; Chain(h, h_2; =)); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "\\hat{\\bm s}_2 = \\frac{\\hat{\\bm s}_1 \\times \\hat{\\bm b}_1}{|\\hat{\\bm s}_1 \\times \\hat{\\bm b}_1|} \\hspace{2cm} \\hat{\\bm s}_3 = \\frac{\\hat{\\bm s}_1 \\times \\hat{\\bm s}_2}{|\\hat{\\bm s}_1 \\times \\hat{\\bm s}_2|}",
        "System(Chain(\\hat{\\bm{s}}_2, Div(Cross(\\hat{\\bm{s}}_1; \\hat{\\bm{b}}_1); Bars(Cross(\\hat{\\bm{s}}_1; \\hat{\\bm{b}}_1))); =), Chain(\\hat{\\bm{s}}_3, Div(Cross(\\hat{\\bm{s}}_1; \\hat{\\bm{s}}_2); Bars(Cross(\\hat{\\bm{s}}_1; \\hat{\\bm{s}}_2))); =))",
        "AVSLab/basilisk/src/fswAlgorithms/attDetermination/headingSuKF/_Documentation/heading_SuKF.tex",
    ),
    (
        "\\min_{p, R} \\quad& \\sum_{i=1}^{N_s} \\| p + R \\: {}^Op^{m_{c_i}} - X^C \\: {}^Cp^{s_i} \\|^2, \\\\ \\textrm{subject to} \\quad& R^T = R^{-1}, \\quad \\det(R) = +1.",
        "System(Words(Limiting(min; _{ p , R }; BigSum(i; 1; N_s; Pow(Norm(Add(p, Mul(R, \\prescript { O } { } { p } ^ { m _ { c _ { i } } }), Neg(Mul(X ^ { C }, \\prescript { C } { } { p } ^ { s _ { i } })))); 2)))), Words(\\text{subject~to}), Chain(Transpose(R), Pow(R; Neg(1)); =), Chain(Call(det; R), 1; =))",
        "RussTedrake/manipulation/book/pose.html",
    ),
    (
        "w'(x) = b_0(x) + b_1(x)*w(x) + b_2(x)*w(x)^2",
        "Chain(Call(w'; x), Add(Call(b_0; x), Operated(*; Call(b_1; x); Call(w; x)), Operated(*; Call(b_2; x); Pow(Call(w; x); 2))); =)",
        "sympy/sympy/sympy/solvers/ode/riccati.py",
    ),
    (
        "\\mathbf{\\Sigma}_{\\mathrm{gyro}} = \\begin{bmatrix} \\sigma_{\\omega_x}^2 & 0 & 0 \\\\ 0 & \\sigma_{\\omega_y}^2 & 0 \\\\ 0 & 0 & \\sigma_{\\omega_z}^2 \\end{bmatrix}",
        "Chain(\\mathbf{\\Sigma}_{gyro}, MatrixOf(Pow(\\sigma_{\\omega_x}; 2), 0, 0, 0, Pow(\\sigma_{\\omega_y}; 2), 0, 0, 0, Pow(\\sigma_{\\omega_z}; 2)); =)",
        "Mayitzin/ahrs/ahrs/filters/fkf.py",
    ),
    (
        "H(j\\omega) N(A) = -1",
        "Chain(Mul(Call(H; Mul(j, \\omega)), Call(N; A)), Neg(1); =)",
        "python-control/python-control/doc/descfcn.rst",
    ),
    (
        "X = \\left(\\begin{array}{ccccc} { {\\boldsymbol{x}}}_1\\quad & & \\cdots\\quad & & { {\\boldsymbol{x}}}_N \\end{array}\\right)^\\mathrm{T}",
        "Chain(X, Transpose(MatrixOf(\\boldsymbol{x}_1, Blank(), Dots(), Blank(), \\boldsymbol{x}_N)); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "F_r^* := \\sum_{i=1}^\\nu {}^A\\bar{v}^{P_i}_r \\cdot \\bar{R}^*_i",
        "Chain(F _ { r } ^ { * }, BigSum(i; 1; \\nu; Mul(\\prescript { A } { } { \\bar { v } } _ { r } ^ { P _ { i } }, \\bar { R } _ { i } ^ { * }; 1)); =)",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "t_{b1} = t_{s1} + t_{\\text{bang}}",
        "Chain(t_{b1}, Add(t_{s1}, t_{bang}); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedLinearTranslation/prescribedLinearTranslation.rst",
    ),
    (
        "\\begin{bmatrix} \\theta \\\\ \\omega \\end{bmatrix} ' = \\begin{bmatrix} \\omega \\\\ - \\frac{g}{L} \\sin \\theta \\end{bmatrix} .",
        "Chain(Marked(MatrixOf(\\theta, \\omega); '), MatrixOf(\\omega, Neg(Mul(Div(g; L), Call(sin; \\theta)))); =)",
        "jirilebl/diffyqs/ch-nonlin-systems.tex",
    ),
    (
        "\\varPhi\\left(\\boldsymbol{q}',t,\\frac{\\partial S_0}{\\partial \\boldsymbol{q}'},\\frac{\\partial S_0}{\\partial t},\\phi\\left(q_1,\\dfrac{\\mathrm{d} S_1}{\\mathrm{d} q_1}\\right)\\right) = 0",
        "Chain(Call(\\varPhi; \\boldsymbol{q}', t, Derivative(Call(S_0); \\boldsymbol{q}', 1; True), Derivative(Call(S_0); t, 1; True), Call(\\phi; q_1, Derivative(Call(S_1); q_1, 1))), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "{}^{\\mathbf{N}}\\boldsymbol{\\alpha}^{\\mathbf{B}} &= \\frac{{}^{\\mathbf{N}} d{}^{\\mathbf{N}}\\boldsymbol{\\omega}^{\\mathbf{B}}}{dt}",
        "Chain(\\prescript { \\mathbf { N } } { } { \\boldsymbol { \\alpha } } ^ { \\mathbf { B } }, Marked(Derivative(Call(\\prescript { \\mathbf { N } } { } { \\boldsymbol { \\omega } } ^ { \\mathbf { B } }); t, 1); _{ \\mathbf { N } }); =)",
        "sympy/sympy/doc/src/explanation/modules/physics/vector/kinematics/kinematics.rst",
    ),
    (
        "\\dot\\tau =& 1 \\\\ \\dot{x}_\\perp =& -\\alpha x_\\perp.",
        "System(Chain(Call(\\dot{\\tau}), 1; =), Chain(Call(\\dot{x}_\\perp), Neg(Mul(\\alpha, Call(x_\\perp))); =))",
        "RussTedrake/underactuated/book/limit_cycles.html",
    ),
    (
        "u = -K x",
        "Chain(u, Neg(Mul(K, x)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/10_inverted_pendulum/inverted_pendulum_main.rst",
    ),
    (
        "A_1 = 1.62(\\frac{\\epsilon}{D})^{0.134}",
        "Chain(A_1, Mul(1.62, Pow(Div(\\epsilon; D); 0.134)); =)",
        "CalebBell/fluids/fluids/friction.py",
    ),
    (
        "T_{rot}=\\frac{1}{2}\\bm\\omega_{\\cal B/N}^T [I_{\\text{hub},B_c}] \\bm\\omega_{\\cal B/N}+\\frac{1}{2}m_{\\text{hub}}\\bm{\\dot{r}}_{B_c,B}\\cdot\\bm{\\dot{r}}_{B_c,B}+\\sum\\limits_{j=1}^{N_P} \\frac{1}{2} m_j \\bm{\\dot{r}}_{P_{c,j}/B}\\cdot\\bm{\\dot{r}}_{P_{c,j}/B}-\\frac{1}{2}m_{SC}\\bm{\\dot{c}}\\cdot\\bm{\\dot{c}}",
        "Chain(T_{rot}, Add(Mul(Div(1; 2), Transpose(\\bm{\\omega}_{\\mathcal B/\\mathcal N}), [ I _ { \\text { h u b } , B _ { c } } ], \\bm{\\omega}_{\\mathcal B/\\mathcal N}), Mul(Div(1; 2), m_{hub}, \\bm{\\dot{r}}_{B_c,B}, \\bm{\\dot{r}}_{B_c,B}; 3), BigSum(j; 1; N_P; Mul(Div(1; 2), m_j, \\bm{\\dot{r}}_{P_c,j/B}, \\bm{\\dot{r}}_{P_c,j/B}; 3)), Neg(Mul(Div(1; 2), m_{SC}, \\bm{\\dot{c}}, \\bm{\\dot{c}}; 3))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/sphericalPendulum/_Documentation/secModelDescription.tex",
    ),
    (
        "\\begin{aligned} v_{t,p} &= \\frac{h_t}{r_p} & v_{t,a} &= \\frac{h_t}{r_a} \\end{aligned}",
        "System(Chain(v_{t,p}, Div(h_t; r_p); =), Chain(v_{t,a}, Div(h_t; r_a); =))",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/hohmann-transfer.md",
    ),
    (
        "\\begin{bmatrix} 2 & 0 \\\\ 0 & 1 \\end{bmatrix} {\\vec{x}}'' = \\begin{bmatrix} -(4+2) & 2 \\\\ 2 & -2 \\end{bmatrix} \\vec{x} + \\begin{bmatrix} 0 \\\\ 2 \\end{bmatrix} \\cos (3 t) \\qquad \\text{or} \\qquad {\\vec{x}}'' = \\begin{bmatrix} -3 & 1 \\\\ 2 & -2 \\end{bmatrix} \\vec{x} + \\begin{bmatrix} 0 \\\\ 2 \\end{bmatrix} \\cos (3 t) .",
        "System(Chain(Mul(MatrixOf(2, 0, 0, 1), \\vec{x}''), Add(Mul(MatrixOf(Neg(Add(4, 2)), 2, 2, Neg(2)), \\vec{x}), Mul(MatrixOf(0, 2), Call(cos; Mul(3, t)))); =), Words(\\text{~or~}), Chain(\\vec{x}'', Add(Mul(MatrixOf(Neg(3), 1, 2, Neg(2)), \\vec{x}), Mul(MatrixOf(0, 2), Call(cos; Mul(3, t)))); =))",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\ell_f({\\bf x}) = \\begin{bmatrix} {\\bf x} \\\\ 1 \\end{bmatrix}^T {\\bf Q}_f \\begin{bmatrix} {\\bf x} \\\\ 1 \\end{bmatrix}.",
        "Chain(Call(\\ell_f; \\mathbf{x}), Mul(Transpose(MatrixOf(\\mathbf{x}, 1)), \\mathbf{Q}_f, MatrixOf(\\mathbf{x}, 1)); =)",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "a = \\sqrt{h(2r - h)}",
        "Chain(a, Sqrt(Mul(h, Add(Mul(2, r), Neg(h)))); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "A_{j,k} = \\sqrt{\\frac{2}{n}} \\cos\\left(\\frac{\\pi j}{n} \\left(k+\\frac{1}{2}\\right)\\right)",
        "Chain(A_{j,k}, Mul(Sqrt(Div(2; n)), Call(cos; Mul(Div(Mul(\\pi, j); n), Add(k, Div(1; 2))))); =)",
        "fredrik-johansson/arb/doc/source/arb_mat.rst",
    ),
    (
        "\\cos(\\alpha+\\beta)=\\cos\\alpha\\cos\\beta-\\sin\\alpha\\sin\\beta",
        "Chain(Call(cos; Add(\\alpha, \\beta)), Add(Mul(Call(cos; \\alpha), Call(cos; \\beta)), Neg(Mul(Call(sin; \\alpha), Call(sin; \\beta)))); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "gain = - C \\cdot A^{-1} \\cdot B + D",
        "Chain(\\text{gain}, Add(Neg(Mul(C, Pow(A; Neg(1)), B)), D); =)",
        "python-control/python-control/control/matlab/wrappers.py",
    ),
    (
        "2\\ddot{r} - r\\dot{\\theta}^2 + g = 0",
        "Chain(Add(Mul(2, Call(\\ddot{r})), Neg(Mul(Call(r), Pow(Call(\\dot{\\theta}); 2))), g), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "\\sin \\alpha = \\frac{R\\omega_0^2 \\sin 2\\lambda}{2g}",
        "Chain(Call(sin; \\alpha), Div(Mul(R, Pow(\\omega_0; 2), Call(sin; Mul(2, \\lambda))); Mul(2, g)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter7.tex",
    ),
    (
        "u = -mg + K_p (p^{F_d} - p^{F}) + K_d (v^{F_d} - v^{F}) - f^{F}_{\\text{feedforward}}.",
        "Chain(u, Add(Neg(Mul(m, g)), Mul(K_p, Add(p ^ { F _ { d } }, Neg(p ^ { F }))), Mul(K_d, Add(v ^ { F _ { d } }, Neg(v ^ { F }))), Neg(f _ { \\text { f e e d f o r w a r d } } ^ { F })); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "\\begin{aligned}\\frac{d\\boldsymbol{\\hat{\\imath}}}{dt} &= \\boldsymbol{\\Omega}\\times\\boldsymbol{\\hat{\\imath}} & \\frac{d\\boldsymbol{\\hat{\\jmath}}}{dt} &= \\boldsymbol{\\Omega}\\times\\boldsymbol{\\hat{\\jmath}} & \\frac{d\\boldsymbol{\\hat{k}}}{dt} &= \\boldsymbol{\\Omega}\\times\\boldsymbol{\\hat{k}}\\end{aligned}",
        "System(Chain(Derivative(Call(\\boldsymbol{\\hat{\\imath}}); t, 1), Cross(\\boldsymbol{\\Omega}; Call(\\boldsymbol{\\hat{\\imath}})); =), Chain(Derivative(Call(\\boldsymbol{\\hat{\\jmath}}); t, 1), Cross(\\boldsymbol{\\Omega}; Call(\\boldsymbol{\\hat{\\jmath}})); =), Chain(Derivative(Call(\\boldsymbol{\\hat{k}}); t, 1), Cross(\\boldsymbol{\\Omega}; Call(\\boldsymbol{\\hat{k}})); =))",
        "bryanwweber/orbital-mechanics-notes/review/time-derivatives-of-moving-vectors.md",
    ),
    (
        "{\\vphantom{\\bm {O}}}^{\\mathcal{P}\\!}{\\bm {O}} = [\\bm{PB}] \\cdot{\\vphantom{\\bm {O}}}^{\\mathcal{B}\\!}{\\bm {O}}",
        "Chain(\\prescript { \\mathcal { P } \\! } { } { \\bm { O } }, Mul([ \\bm { P } \\bm { B } ], \\prescript { \\mathcal { B } \\! } { } { \\bm { O } }); =)",
        "AVSLab/basilisk/src/simulation/dynamics/DynOutput/boreAngCalc/_Documentation/secModelDescription.tex",
    ),
    (
        "\\begin{array}{rcl} \\|\\,^b\\mathbf{a}-\\mathbf{C}\\,^r\\mathbf{a}\\|^2 & \\simeq & 0 \\\\ \\\\ \\|\\,^b\\mathbf{m}-\\mathbf{C}\\,^r\\mathbf{m}\\|^2 & \\simeq & 0 \\end{array}",
        "System(Chain(Pow(Norm(Add(\\prescript { b } { } { \\mathbf { a } }, Neg(Mul(\\mathbf{C}, \\prescript { r } { } { \\mathbf { a } })))); 2), 0; \\simeq), Chain(Pow(Norm(Add(\\prescript { b } { } { \\mathbf { m } }, Neg(Mul(\\mathbf{C}, \\prescript { r } { } { \\mathbf { m } })))); 2), 0; \\simeq))",
        "Mayitzin/ahrs/ahrs/filters/saam.py",
    ),
    (
        "\\operatorname{Chi}(z) = \\operatorname{Ci}\\left(e^{i \\pi/2}z\\right) - i\\frac{\\pi}{2},",
        "Chain(Call(\\text{Chi}; z), Add(Call(\\text{Ci}; Mul(Pow(e; Div(Mul(i, \\pi); 2)), z)), Neg(Mul(i, Div(\\pi; 2)))); =)",
        "sympy/sympy/sympy/functions/special/error_functions.py",
    ),
    (
        "\\bm{c}' = \\frac{1}{m_{\\text{sc}}}\\sum_{j=1}^{N_{P}}m_j l_j \\bigg[\\Big(-\\dot{\\varphi}_j\\sin(\\varphi_j)\\cos(\\vartheta_j)-\\dot{\\vartheta}_j\\cos(\\varphi_j)\\sin(\\vartheta_j)\\Big)\\bm{\\hat{p}}_{0_j,1}+\\\\ \\Big(\\dot{\\varphi}_j\\cos(\\varphi_j)\\cos(\\vartheta_j)-\\dot{\\vartheta}_j\\sin(\\varphi_j)\\sin(\\vartheta_j) \\Big)\\bm{\\hat{p}}_{0_j,2} -\\dot{\\vartheta}_j\\cos(\\vartheta_j) \\bm{\\hat{p}}_{0_j,3} \\bigg]",
        "Chain(\\bm{c}', Mul(Div(1; m_{sc}), BigSum(j; 1; N_P; Mul(m_j, l_j, Add(Mul(Add(Neg(Mul(Call(\\dot{\\varphi}_j), Call(sin; Call(\\varphi_j)), Call(cos; Call(\\vartheta_j)))), Neg(Mul(Call(\\dot{\\vartheta}_j), Call(cos; Call(\\varphi_j)), Call(sin; Call(\\vartheta_j))))), \\bm{\\hat{p}}_{0_j,1}), Mul(Add(Mul(Call(\\dot{\\varphi}_j), Call(cos; Call(\\varphi_j)), Call(cos; Call(\\vartheta_j))), Neg(Mul(Call(\\dot{\\vartheta}_j), Call(sin; Call(\\varphi_j)), Call(sin; Call(\\vartheta_j))))), \\bm{\\hat{p}}_{0_j,2}), Neg(Mul(Call(\\dot{\\vartheta}_j), Call(cos; Call(\\vartheta_j)), \\bm{\\hat{p}}_{0_j,3})))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/sphericalPendulum/_Documentation/secModelDescription.tex",
    ),
    (
        "\\int_{-1}^{1} \\sqrt{1-x^2} f(x)\\,dx \\approx \\sum_{i=1}^n w_i f(x_i)",
        "Chain(Integral(Mul(Sqrt(Add(1, Neg(Pow(x; 2)))), Call(f; x)); x; Neg(1); 1), BigSum(i; 1; n; Mul(w_i, Call(f; x_i))); \\approx)",
        "sympy/sympy/sympy/integrals/quadrature.py",
    ),
    (
        "\\forall {\\bf x}, \\quad \\dot{J}^*({\\bf x}) \\le \\gamma^2 {\\bf w}^T(t){\\bf w}(t) - {\\bf x}^T(t){\\bf Q}{\\bf x}(t) - {\\bf u}^T(t) {\\bf R}{\\bf u}(t).",
        "System(Forall(Call(\\mathbf{x})), Chain(Call(\\dot { J } ^ { * }; Call(\\mathbf{x})), Add(Mul(Pow(\\gamma; 2), Transpose(Call(\\mathbf{w}; t)), Call(\\mathbf{w}; t)), Neg(Mul(Transpose(Call(\\mathbf{x}; t)), \\mathbf{Q}, Call(\\mathbf{x}; t))), Neg(Mul(Transpose(Call(\\mathbf{u}; t)), \\mathbf{R}, Call(\\mathbf{u}; t)))); \\le))",
        "RussTedrake/underactuated/book/robust.html",
    ),
    (
        "{}^B\\mathbf{C}^N = {}^B\\mathbf{C}^A {}^A\\mathbf{C}^N",
        "Chain(\\prescript { B } { } { \\mathbf { C } } ^ { N }, Mul(\\prescript { B } { } { \\mathbf { C } } ^ { A }, \\prescript { A } { } { \\mathbf { C } } ^ { N }); =)",
        "moorepants/learn-multibody-dynamics/orientation.rst",
    ),
    (
        "M^{B/B_{cm}} = \\begin{bmatrix} I & 0 & 0\\\\ 0 & m & 0 \\\\ 0 & 0 & m \\end{bmatrix},",
        "Chain(M ^ { B / B _ { c m } }, MatrixOf(I, 0, 0, 0, m, 0, 0, 0, m); =)",
        "RussTedrake/underactuated/book/humanoids.html",
    ),
    (
        "\\eta(a)=\\eta(b)=0",
        "Chain(Call(\\eta; a), Call(\\eta; b), 0; =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter9.tex",
    ),
    (
        "\\frac{r_3}{r_1} > 15.58",
        "Chain(Div(r_3; r_1), 15.58; >)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/bielliptic-hohmann-transfer.md",
    ),
    (
        "S_j(\\omega) = \\frac{1}{\\sqrt{2\\,\\pi}}\\,\\frac{a_j}{c_j}\\,\\left[ \\frac{1}{1+{\\left(\\frac{\\omega-d_j}{c_j}\\right)}^2} + \\frac{1}{1+{\\left(\\frac{\\omega+d_j}{c_j}\\right)}^2} \\right] \\quad.",
        "Chain(Call(S_j; \\omega), Mul(Div(1; Sqrt(Mul(2, \\pi))), Div(a_j; c_j), Add(Div(1; Add(1, Pow(Div(Add(\\omega, Neg(d_j)); c_j); 2))), Div(1; Add(1, Pow(Div(Add(\\omega, d_j); c_j); 2))))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "[B_\\text{contr}] = \\sum\\limits_{i=1}^{N}m_{\\text{rw}_i}d_i\\hat{\\bm{w}}_{3_i}\\bm{b}_{\\Omega_i}^T",
        "Chain([ B _ { \\text { c o n t r } } ], BigSum(i; 1; N; Mul(m_{rw_i}, d_i, \\hat{\\bm{w}}_{3_i}, Transpose(\\bm{b}_{\\Omega_i}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/reactionWheels/_Documentation/secModelDescription.tex",
    ),
    (
        "r = \\frac{h^2}{\\mu}\\frac{1}{1 + \\left(\\frac{h^2}{\\mu r_0} - 1\\right) \\cos\\Delta\\nu - \\frac{hv_{r,0}}{\\mu}\\sin\\Delta\\nu}",
        "Chain(r, Mul(Div(Pow(h; 2); \\mu), Div(1; Add(1, Mul(Add(Div(Pow(h; 2); Mul(\\mu, r_0)), Neg(1)), Call(cos; \\Delta \\nu)), Neg(Mul(Div(Mul(h, v_{r,0}); \\mu), Call(sin; \\Delta \\nu)))))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/the-lagrange-coefficients.md",
    ),
    (
        "\\bar{f}_k(\\dot{\\bar{q}}, \\bar{u}, \\bar{q}, \\bar{q}_r, t) = 0 \\in \\mathbb{R}^n \\\\ \\bar{f}_d(\\dot{\\bar{u}}, \\bar{u}, \\bar{q}, \\bar{q}_r, t) = 0 \\in \\mathbb{R}^n \\\\ \\bar{f}_h(\\bar{q}, \\bar{q}_r, t) = 0 \\in \\mathbb{R}^M",
        "System(Chain(Call(\\bar{f}_k; Call(\\dot{\\bar{q}}), Call(\\bar{u}), Call(\\bar{q}), \\bar{q}_r, t), 0, Pow(\\mathbb{R}; n); =, \\in), Chain(Call(\\bar{f}_d; Call(\\dot{\\bar{u}}), Call(\\bar{u}), Call(\\bar{q}), \\bar{q}_r, t), 0, Pow(\\mathbb{R}; n); =, \\in), Chain(Call(\\bar{f}_h; Call(\\bar{q}), \\bar{q}_r, t), 0, Pow(\\mathbb{R}; M); =, \\in))",
        "moorepants/learn-multibody-dynamics/holonomic-eom.rst",
    ),
    (
        "v_{i}(t+1) = w \\cdot v_{i}(t) + c_1 \\cdot r_1 \\cdot (p_{i} - x_{i}(t)) + c_2 \\cdot r_2 \\cdot (g - x_{i}(t))",
        "Chain(Call(v_i; Add(t, 1)), Add(Mul(w, Call(v_i; t)), Mul(c_1, r_1, Add(p_i, Neg(Call(x_i; t)))), Mul(c_2, r_2, Add(g, Neg(Call(x_i; t))))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/particleSwarmOptimization/particleSwarmOptimization_main.rst",
    ),
    (
        "\\boldsymbol{\\alpha} = \\frac{\\mathrm{d} \\boldsymbol{\\omega}}{\\mathrm{d} t} = \\dot{\\boldsymbol{\\omega}}",
        "Chain(\\boldsymbol{\\alpha}, Derivative(Call(\\boldsymbol{\\omega}); t, 1), Call(\\dot{\\boldsymbol{\\omega}}); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "\\dot{x}(t) = A x(t) + B u(t) \\\\ y(t) = C x(t) + D u(t)",
        "System(Chain(Call(\\dot{x}; t), Add(Mul(A, Call(x; t)), Mul(B, Call(u; t))); =), Chain(Call(y; t), Add(Mul(C, Call(x; t)), Mul(D, Call(u; t))); =))",
        "sympy/sympy/doc/src/tutorials/physics/control/electrical_problems.rst",
    ),
    (
        "y_p = (A + Bx + Cx^2)\\,e^{-x} \\cos (\\pi x) + (D + Ex + Fx^2)\\,e^{-x} \\sin (\\pi x) .",
        "Chain(y_p, Add(Mul(Add(A, Mul(B, x), Mul(C, Pow(x; 2))), Pow(e; Neg(x)), Call(cos; Mul(\\pi, x))), Mul(Add(D, Mul(E, x), Mul(F, Pow(x; 2))), Pow(e; Neg(x)), Call(sin; Mul(\\pi, x)))); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "C = \\frac{1}{\\omega} \\arcsin\\left(\\sqrt{\\frac{m\\omega^2}{2E}}q_0\\right) - t_0,\\quad E = \\frac{p_0^2}{2m} + \\frac12 m\\omega^2 q_0^2",
        "System(Chain(C, Add(Mul(Div(1; \\omega), Call(arcsin; Mul(Sqrt(Div(Mul(m, Pow(\\omega; 2)); Mul(2, E))), q_0))), Neg(t_0)); =), Chain(E, Add(Div(Pow(p_0; 2); Mul(2, m)), Mul(Div(1; 2), m, Pow(\\omega; 2), Pow(q_0; 2))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\boxed{\\mathbf{\\Sigma}_{\\mathbf{q}_t^-} = \\Phi_t \\mathbf{\\Sigma}_{\\mathbf{q}_{t-1}} \\Phi_t^T + \\mathbf{\\Sigma}_{\\xi_t}}",
        "Chain(\\mathbf{\\Sigma}_{\\mathbf q_t^-}, Add(Mul(\\Phi_t, \\mathbf{\\Sigma}_{\\mathbf q_t-1}, Transpose(\\Phi_t)), \\mathbf{\\Sigma}_{\\xi_t}); =)",
        "Mayitzin/ahrs/ahrs/filters/fkf.py",
    ),
    (
        "\\mathbf{q}_{t+1} = \\Bigg[ \\cos\\Big(\\frac{\\|\\boldsymbol\\omega\\|\\Delta t}{2}\\Big)\\mathbf{I}_4 + \\frac{1}{\\|\\boldsymbol\\omega\\|}\\sin\\Big(\\frac{\\|\\boldsymbol\\omega\\|\\Delta t}{2}\\Big)\\boldsymbol\\Omega(\\boldsymbol\\omega) \\Bigg]\\mathbf{q}_t",
        "Chain(\\mathbf{q}_{t+1}, Mul(Add(Mul(Call(cos; Div(Mul(Norm(\\boldsymbol{\\omega}), \\Delta t); 2)), \\mathbf{I}_4), Mul(Div(1; Norm(\\boldsymbol{\\omega})), Call(sin; Div(Mul(Norm(\\boldsymbol{\\omega}), \\Delta t); 2)), Call(\\boldsymbol{\\Omega}; \\boldsymbol{\\omega}))), \\mathbf{q}_t); =)",
        "Mayitzin/ahrs/ahrs/filters/angular.py",
    ),
    (
        "S(\\omega) = \\sqrt{\\frac{2}{\\pi}}\\,\\frac{S_0}{\\left[(\\omega/\\omega_0)^2+1\\right]^2}",
        "Chain(Call(S; \\omega), Mul(Sqrt(Div(2; \\pi)), Div(S_0; Pow(Add(Pow(Div(\\omega; \\omega_0); 2), 1); 2))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "v_{\\infty} = \\lvert v_{t,f} - v_f \\rvert",
        "Chain(v_\\infty, Bars(Add(v_{t,f}, Neg(v_f))); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-arrival-capture.md",
    ),
    (
        "f(t) = \\frac{1}{t} \\frac{1}{2\\pi i} \\int_L \\Delta(s) \\frac{1}{\\Gamma(-as)} \\left(\\frac{b}{t^a}\\right)^s \\mathrm{d}s,",
        "Chain(Call(f; t), Mul(Div(1; t), Div(1; Mul(2, \\pi, i)), Over(\\int; _ { L }; Mul(Call(\\Delta; s), Div(1; Call(Gamma; Neg(Mul(a, s)))), Pow(Div(b; Pow(t; a)); s)); s)); =)",
        "sympy/sympy/doc/src/modules/integrals/g-functions.rst",
    ),
    (
        "\\Pi(n, \\phi + k \\pi, m) = 2 k \\Pi(n,m) + \\Pi(n,\\phi,m), k \\in \\mathbb{Z}.",
        "System(Chain(Call(\\Pi; n, Add(\\phi, Mul(k, \\pi)), m), Add(Mul(2, k, Call(\\Pi; n, m)), Call(\\Pi; n, \\phi, m)); =), Chain(k, \\mathbb{Z}; \\in))",
        "fredrik-johansson/arb/doc/source/acb_elliptic.rst",
    ),
    (
        "e_i p_f \\cos\\nu_i - e_f p_i \\cos\\nu_i \\cos\\eta - e_f p_i \\sin\\nu_i \\sin\\eta = p_i - p_f",
        "Chain(Add(Mul(e_i, p_f, Call(cos; \\nu_i)), Neg(Mul(e_f, p_i, Call(cos; \\nu_i), Call(cos; \\eta))), Neg(Mul(e_f, p_i, Call(sin; \\nu_i), Call(sin; \\eta)))), Add(p_i, Neg(p_f)); =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/apse-line-rotation-example.md",
    ),
    (
        "\\psi^3 = 1",
        "Chain(Pow(\\psi; 3), 1; =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/lagrange-points.md",
    ),
    (
        "v_{\\infty} = \\Delta v_{\\text{Sun}}\\text{ relative to the Sun}",
        "System(Chain(v_\\infty, \\Delta v _ { \\text { S u n } }; =), Words(\\text{relative~to~the~Sun}))",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-depahture-trajectory.md",
    ),
    (
        "e = (x - x_d)^2 + (f^{F_c} - f^{F_c}_{desired})^2",
        "Chain(e, Add(Pow(Add(x, Neg(x_d)); 2), Pow(Add(f ^ { F _ { c } }, Neg(f _ { d e s i r e d } ^ { F _ { c } })); 2)); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "U = \\begin{bmatrix} U_{0, 0} & U_{0, 1} & U_{0, 2} & \\cdots & U_{0, n-1} \\\\ 0 & U_{1, 1} & U_{1, 2} & \\cdots & U_{1, n-1} \\\\ 0 & 0 & U_{2, 2} & \\cdots & U_{2, n-1} \\\\ \\vdots & \\vdots & \\vdots & \\ddots & \\vdots \\\\ 0 & 0 & 0 & \\cdots & U_{n-1, n-1} \\end{bmatrix}",
        "Chain(U, MatrixOf(U_{0,0}, U_{0,1}, U_{0,2}, Dots(), U_{0,n-1}, 0, U_{1,1}, U_{1,2}, Dots(), U_{1,n-1}, 0, 0, U_{2,2}, Dots(), U_{2,n-1}, Dots(), Dots(), Dots(), Dots(), Dots(), 0, 0, 0, Dots(), U_{n-1,n-1}); =)",
        "sympy/sympy/sympy/matrices/decompositions.py",
    ),
    (
        "\\ddot{\\bf y}^d = {\\bf K}_d (\\dot{{\\bf y}}^d - \\dot{\\bf y}) + {\\bf K}_p ({\\bf y}^d -{\\bf y}).",
        "Chain(Call(\\ddot { \\mathbf { y } } ^ { d }), Add(Mul(\\mathbf{K}_d, Add(Call(\\dot { \\mathbf { y } } ^ { d }), Neg(Call(\\dot{\\mathbf{y}})))), Mul(\\mathbf{K}_p, Add(Call(\\mathbf { y } ^ { d }), Neg(Call(\\mathbf{y}))))); =)",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\bar{r}^{P_4/P_1} & = l_n \\hat{n}_x \\\\ \\bar{r}^{P_4/P_1} & = \\bar{r}^{P_2/P_1} + \\bar{r}^{P_3/P_2} + \\bar{r}^{P_4/P_3} = l_a\\hat{a}_x + l_b\\hat{b}_x + l_c\\hat{c}_x",
        "System(Chain(\\bar { r } ^ { P _ { 4 } / P _ { 1 } }, Mul(l_n, \\hat{n}_x); =), Chain(\\bar { r } ^ { P _ { 4 } / P _ { 1 } }, Add(\\bar { r } ^ { P _ { 2 } / P _ { 1 } }, \\bar { r } ^ { P _ { 3 } / P _ { 2 } }, \\bar { r } ^ { P _ { 4 } / P _ { 3 } }), Add(Mul(l_a, \\hat{a}_x), Mul(l_b, \\hat{b}_x), Mul(l_c, \\hat{c}_x)); =, =))",
        "moorepants/learn-multibody-dynamics/configuration.rst",
    ),
    (
        "k(\\tau) \\approx S_0\\,\\omega_0\\,Q\\, \\exp\\left(-\\frac{\\omega_0\\,\\tau}{2\\,Q}\\right)\\, \\cos\\left(\\omega_0\\,\\tau\\right) \\quad.",
        "Chain(Call(k; \\tau), Mul(S_0, \\omega_0, Q, Call(exp; Neg(Div(Mul(\\omega_0, \\tau); Mul(2, Q)))), Call(cos; Mul(\\omega_0, \\tau))); \\approx)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\min_{\\alpha,T} & \\quad T, \\\\ \\textrm{subject to} &\\quad X^{G_{start}} = f_{kin}(q_\\alpha(0)),\\\\ & \\quad X^{G_{goal}} = f_{kin}(q_\\alpha(T)), \\\\ & \\quad \\forall t , \\quad \\left|\\dot{q}_\\alpha(t)\\right| \\le v_{max} .",
        "System(Words(Limiting(min; _{ \\alpha , T }; T)), Words(\\text{subject~to}), Chain(X ^ { G _ { s t a r t } }, Call(f_{kin}; Call(q_\\alpha; 0)); =), Chain(X ^ { G _ { g o a l } }, Call(f_{kin}; Call(q_\\alpha; T)); =), Forall(t), Chain(Bars(Call(\\dot{q}_\\alpha; t)), v_{max}; \\le))",
        "RussTedrake/manipulation/book/trajectories.html",
    ),
    (
        "\\begin{aligned} x_1 &= -\\pi_2 r_{12} & x_2 &= \\pi_1 r_{12} \\end{aligned}",
        "System(Chain(x_1, Neg(Mul(\\pi_2, r_{12})); =), Chain(x_2, Mul(\\pi_1, r_{12}); =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "\\dot{\\bm\\omega}_{R/N} = \\dot{\\bm\\omega}_{B_{u,t}/N} = \\bm 0",
        "Chain(Call(\\dot{\\bm{\\omega}}_{R/N}), Call(\\dot{\\bm{\\omega}}_{B_u,t/N}), 0; =, =)",
        "AVSLab/basilisk/src/fswAlgorithms/dvGuidance/dvAttGuidance/_Documentation/secModuleDescription.tex",
    ),
    (
        "{}_2F_1(a,b,c,z) = \\frac{\\Gamma(a)}{\\Gamma(b) \\Gamma(c-b)} \\int_0^1 t^{b-1} (1-t)^{c-b-1} (1-zt)^{-a} dt.",
        "Chain(Call(\\prescript { } { 2 } { F } _ { 1 }; a, b, c, z), Mul(Div(Call(Gamma; a); Mul(Call(Gamma; b), Call(Gamma; Add(c, Neg(b))))), Integral(Mul(Pow(t; Add(b, Neg(1))), Pow(Add(1, Neg(t)); Add(c, Neg(b), Neg(1))), Pow(Add(1, Neg(Mul(z, t))); Neg(a))); t; 0; 1)); =)",
        "fredrik-johansson/arb/doc/source/arb_hypgeom.rst",
    ),
    (
        "\\begin{bmatrix} \\phi \\\\ \\theta \\\\ \\psi \\end{bmatrix} = \\begin{bmatrix} \\mathrm{atan2}\\big(2(q_wq_x + q_yq_z), 1-2(q_x^2+q_y^2)\\big) \\\\ \\arcsin\\big(2(q_wq_y - q_zq_x)\\big) \\\\ \\mathrm{atan2}\\big(2(q_wq_z + q_xq_y), 1-2(q_y^2+q_z^2)\\big) \\end{bmatrix}",
        "Chain(MatrixOf(\\phi, \\theta, \\psi), MatrixOf(Call(\\text{atan2}; Mul(2, Add(Mul(q_w, q_x), Mul(q_y, q_z))), Add(1, Neg(Mul(2, Add(Pow(q_x; 2), Pow(q_y; 2)))))), Call(arcsin; Mul(2, Add(Mul(q_w, q_y), Neg(Mul(q_z, q_x))))), Call(\\text{atan2}; Mul(2, Add(Mul(q_w, q_z), Mul(q_x, q_y))), Add(1, Neg(Mul(2, Add(Pow(q_y; 2), Pow(q_z; 2))))))); =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "\\begin{aligned} v_r &= \\frac{\\mu}{h}\\sin\\nu \\\\ v_{\\perp} &= \\frac{\\mu}{h}\\left(1 + \\cos\\nu\\right) \\end{aligned}",
        "System(Chain(v_r, Mul(Div(\\mu; h), Call(sin; \\nu)); =), Chain(v_\\perp, Mul(Div(\\mu; h), Add(1, Call(cos; \\nu))); =))",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/parabolic-trajectories.md",
    ),
    (
        "\\boxed{\\mathbf{G}_t = \\mathbf{\\Sigma}_{\\mathbf{q}_t^-} \\big [\\mathbf{\\Sigma}_{\\mathbf{q}_t^-} + \\mathbf{\\Sigma}_{v_t}\\big ]^{-1}}",
        "Chain(\\mathbf{G}_t, Mul(\\mathbf{\\Sigma}_{\\mathbf q_t^-}, Pow(Add(\\mathbf{\\Sigma}_{\\mathbf q_t^-}, \\mathbf{\\Sigma}_{v_t}); Neg(1))); =)",
        "Mayitzin/ahrs/ahrs/filters/fkf.py",
    ),
    (
        "\\frac{X^{(4)}}{X} = \\frac{- T''}{a^4T} = \\lambda .",
        "Chain(Div(X ^ { ( 4 ) }; X), Div(Neg(T''); Mul(Pow(a; 4), T)), \\lambda; =, =)",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "\\begin{split} e^{t A} = E e^{tD} E^{-1} & = \\begin{bmatrix} 1 & 1 \\\\ 1 & -1 \\end{bmatrix} \\begin{bmatrix} e^{3t} & 0 \\\\ 0 & e^{-t} \\end{bmatrix} \\begin{bmatrix} 1 & 1 \\\\ 1 & -1 \\end{bmatrix}^{-1} \\\\ & = \\begin{bmatrix} 1 & 1 \\\\ 1 & -1 \\end{bmatrix} \\begin{bmatrix} e^{3t} & 0 \\\\ 0 & e^{-t} \\end{bmatrix} \\frac{-1}{2} \\begin{bmatrix} -1 & -1 \\\\ -1 & 1 \\end{bmatrix} \\\\ & = \\frac{-1}{2} \\begin{bmatrix} e^{3t} & e^{-t} \\\\ e^{3t} & -e^{-t} \\end{bmatrix} \\begin{bmatrix} -1 & -1 \\\\ -1 & 1 \\end{bmatrix} \\\\ & = \\frac{-1}{2} \\begin{bmatrix} -e^{3t}-e^{-t} & -e^{3t}+e^{-t} \\\\ -e^{3t}+e^{-t} & -e^{3t}-e^{-t} \\end{bmatrix} = \\begin{bmatrix} \\frac{e^{3t}+e^{-t}}{2} & \\frac{e^{3t}-e^{-t}}{2} \\\\ \\frac{e^{3t}-e^{-t}}{2} & \\frac{e^{3t}+e^{-t}}{2} \\end{bmatrix} . \\end{split}",
        "Chain(Pow(e; Mul(t, A)), Mul(E, Pow(e; Mul(t, D)), Pow(E; Neg(1))), Mul(MatrixOf(1, 1, 1, Neg(1)), MatrixOf(Pow(e; Mul(3, t)), 0, 0, Pow(e; Neg(t))), Pow(MatrixOf(1, 1, 1, Neg(1)); Neg(1))), Mul(MatrixOf(1, 1, 1, Neg(1)), MatrixOf(Pow(e; Mul(3, t)), 0, 0, Pow(e; Neg(t))), Div(Neg(1); 2), MatrixOf(Neg(1), Neg(1), Neg(1), 1)), Mul(Div(Neg(1); 2), MatrixOf(Pow(e; Mul(3, t)), Pow(e; Neg(t)), Pow(e; Mul(3, t)), Neg(Pow(e; Neg(t)))), MatrixOf(Neg(1), Neg(1), Neg(1), 1)), Mul(Div(Neg(1); 2), MatrixOf(Add(Neg(Pow(e; Mul(3, t))), Neg(Pow(e; Neg(t)))), Add(Neg(Pow(e; Mul(3, t))), Pow(e; Neg(t))), Add(Neg(Pow(e; Mul(3, t))), Pow(e; Neg(t))), Add(Neg(Pow(e; Mul(3, t))), Neg(Pow(e; Neg(t)))))), MatrixOf(Div(Add(Pow(e; Mul(3, t)), Pow(e; Neg(t))); 2), Div(Add(Pow(e; Mul(3, t)), Neg(Pow(e; Neg(t)))); 2), Div(Add(Pow(e; Mul(3, t)), Neg(Pow(e; Neg(t)))); 2), Div(Add(Pow(e; Mul(3, t)), Pow(e; Neg(t))); 2)); =, =, =, =, =, =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\frac{d\\hat x}{dt} = A \\hat x + B u + L(y - C\\hat x - D u),",
        "Chain(Derivative(Call(\\hat{x}); t, 1), Add(Mul(A, Call(\\hat{x})), Mul(B, u), Mul(L, Add(y, Neg(Mul(C, Call(\\hat{x}))), Neg(Mul(D, u))))); =)",
        "python-control/python-control/doc/statesp.rst",
    ),
    (
        "y_p'' -9y_p = 6Ae^{3x} + 9Axe^{3x} - 9Axe^{3x} = 6Ae^{3x} .",
        "Chain(Add(y_p'', Neg(Mul(9, y_p))), Add(Mul(6, A, Pow(e; Mul(3, x))), Mul(9, A, x, Pow(e; Mul(3, x))), Neg(Mul(9, A, x, Pow(e; Mul(3, x))))), Mul(6, A, Pow(e; Mul(3, x))); =, =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "B(a,b;z) = \\frac{z^a}{a} {}_2F_1(a, 1-b, a+1, z)",
        "Chain(Call(B; Given(a, b; z; ;)), Mul(Div(Pow(z; a); a), Call(\\prescript { } { 2 } { F } _ { 1 }; a, Add(1, Neg(b)), Add(a, 1), z)); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "dx_e/dt = A x_e + B u + L(y - C x_e - D u)",
        "Chain(Derivative(Call(x_e); t, 1), Add(Mul(A, Call(x_e)), Mul(B, u), Mul(L, Add(y, Neg(Mul(C, Call(x_e))), Neg(Mul(D, u))))); =)",
        "python-control/python-control/control/stochsys.py",
    ),
    (
        "\\boldsymbol{d}_e = \\left(\\sum_{i=1}^n\\dot{u}_i^2 + 1\\right)^{-\\frac12} \\begin{pmatrix} \\dot{u}_1 \\\\ \\dot{u}_2 \\\\ \\vdots \\\\ \\dot{u}_{3n} \\\\ 1 \\end{pmatrix}",
        "Chain(\\boldsymbol{d}_e, Mul(Pow(Add(BigSum(i; 1; n; Pow(Call(\\dot{u}_i); 2)), 1); Neg(Div(1; 2))), MatrixOf(Call(\\dot{u}_1), Call(\\dot{u}_2), Dots(), Call(\\dot{u}_{3n}), 1)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/analytical-mechanics/Constraint.tex",
    ),
    (
        "\\bar{x} = \\mathbf{A}^{-1}\\bar{b}",
        "Chain(\\bar{x}, Mul(Pow(\\mathbf{A}; Neg(1)), \\bar{b}); =)",
        "moorepants/learn-multibody-dynamics/sympy.rst",
    ),
    (
        "k(\\tau) = S_0\\,\\omega_0\\,e^{-\\frac{1}{\\sqrt{2}}\\,\\omega_0\\,\\tau}\\, \\cos{\\left(\\frac{\\omega_0\\,\\tau}{\\sqrt{2}}-\\frac{\\pi}{4}\\right)} \\quad.",
        "Chain(Call(k; \\tau), Mul(S_0, \\omega_0, Pow(e; Neg(Mul(Div(1; Sqrt(2)), \\omega_0, \\tau))), Call(cos; Add(Div(Mul(\\omega_0, \\tau); Sqrt(2)), Neg(Div(\\pi; 4))))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\alpha u_x + u_t = 0, \\qquad u(x,0) = f(x) ,",
        "System(Chain(Add(Mul(\\alpha, u_x), u_t), 0; =), Chain(Call(u; x, 0), Call(f; x); =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "T = \\frac{\\mathrm{JDT} - 2451545}{36525}",
        "Chain(T, Div(Add(\\text{JDT}, Neg(2451545)); 36525); =)",
        "bryanwweber/orbital-mechanics-notes/reference/planetary-ephemeris.md",
    ),
    (
        "[B_\\text{contr}] = \\frac{1}{m_{\\text{sc}}}\\sum\\limits_{i=1}^{N}m_{\\text{rw}_i}d_i\\hat{\\bm{w}}_{3_i}\\bm{b}_{\\Omega_i}^T",
        "Chain([ B _ { \\text { c o n t r } } ], Mul(Div(1; m_{sc}), BigSum(i; 1; N; Mul(m_{rw_i}, d_i, \\hat{\\bm{w}}_{3_i}, Transpose(\\bm{b}_{\\Omega_i})))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/reactionWheels/_Documentation/RWJitterBackSubstitution/Basilisk-RWJitterBackSub-20161221.tex",
    ),
    (
        "{\\bf A}' = {\\bf T}^{-1} {\\bf A} {\\bf T},\\quad {\\bf B}' = {\\bf T}^{-1} {\\bf B},\\quad {\\bf C}' = {\\bf C}{\\bf T},",
        "System(Chain(\\mathbf{A}', Mul(Pow(\\mathbf{T}; Neg(1)), \\mathbf{A}, \\mathbf{T}); =), Chain(\\mathbf{B}', Mul(Pow(\\mathbf{T}; Neg(1)), \\mathbf{B}); =), Chain(\\mathbf{C}', Mul(\\mathbf{C}, \\mathbf{T}); =))",
        "RussTedrake/underactuated/book/sysid.html",
    ),
    (
        "[B(\\pmb\\sigma_{R/N})] = (1-\\sigma_{R/N}^{2}) [I_{3\\times 3}] + 2 [\\tilde{\\pmb\\sigma}_{R/N}] + 2 \\pmb\\sigma_{R/N} \\pmb\\sigma_{R/N}^{T}",
        "Chain(Call([ B ]; \\pmb{\\sigma}_{R/N}), Add(Mul(Add(1, Neg(Pow(\\sigma_{R/N}; 2))), [ I _ { 3 \\times 3 } ]), Mul(2, [ \\tilde { \\pmb { \\sigma } } _ { R / N } ]), Mul(2, \\pmb{\\sigma}_{R/N}, Transpose(\\pmb{\\sigma}_{R/N}))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/inertial3DSpin/inertial3DSpin.rst",
    ),
    (
        "H = \\sum_{\\alpha=1}^s \\frac{\\partial L}{\\partial \\dot{q}_\\alpha} \\dot{q}_\\alpha - L",
        "Chain(H, Add(BigSum(\\alpha; 1; s; Mul(Derivative(Call(L); \\dot{q}_{\\alpha}, 1; True), Call(\\dot{q}_{\\alpha}))), Neg(Call(L))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "\\theta_1(z,\\tau) = -i \\sum_{n=-\\infty}^{\\infty} (-1)^n \\exp(\\pi i [(n + 1/2)^2 \\tau + (2n + 1) z]) = 2 q_{1/4} \\sum_{n=0}^{\\infty} (-1)^n q^{n(n+1)} \\sin((2n+1) \\pi z)",
        "Chain(Call(\\theta_1; z, \\tau), Neg(Mul(i, BigSum(n; Neg(Infinity()); Infinity(); Mul(Pow(Neg(1); n), Call(exp; Mul(\\pi, i, Add(Mul(Pow(Add(n, Div(1; 2)); 2), \\tau), Mul(Add(Mul(2, n), 1), z)))))))), Mul(2, q_{1/4}, BigSum(n; 0; Infinity(); Mul(Pow(Neg(1); n), Pow(q; Mul(n, Add(n, 1))), Call(sin; Mul(Add(Mul(2, n), 1), \\pi, z))))); =, =)",
        "fredrik-johansson/arb/doc/source/acb_modular.rst",
    ),
    (
        "f_{1,B}^B + f_{2,B}^B = \\begin{bmatrix}0 \\\\ 0 \\\\ mg\\end{bmatrix},",
        "Chain(Add(f _ { 1 , B } ^ { B }, f _ { 2 , B } ^ { B }), MatrixOf(0, 0, Mul(m, g)); =)",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "\\ddot{\\boldsymbol{\\rho}} = \\frac{d^2\\boldsymbol{r}}{dt^2}\\frac{t_C^2}{r_{12}} = \\frac{d^2\\boldsymbol{\\rho}}{d\\tau^2}",
        "Chain(Call(\\ddot{\\boldsymbol{\\rho}}), Mul(Derivative(Call(\\boldsymbol{r}); t, 2), Div(Pow(t_C; 2); r_{12})), Derivative(Call(\\boldsymbol{\\rho}); \\tau, 2); =, =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "u = u_\\text{d} - K(\\mu) (x - x_\\text{d})",
        "Chain(u, Add(u_d, Neg(Mul(Call(K; \\mu), Add(x, Neg(x_d))))); =)",
        "python-control/python-control/doc/iosys.rst",
    ),
    (
        "\\operatorname{Bi}(z) = A_3 [S_n(i \\zeta) + R_n(z_1)] + A_4 [S_n(-i \\zeta) + R_n(z_2)]",
        "Chain(Call(\\text{Bi}; z), Add(Mul(A_3, Add(Call(S_n; Mul(i, \\zeta)), Call(R_n; z_1))), Mul(A_4, Add(Call(S_n; Neg(Mul(i, \\zeta))), Call(R_n; z_2)))); =)",
        "fredrik-johansson/arb/doc/source/hypergeometric.rst",
    ),
    (
        "\\sigma = \\sqrt{\\frac{2}{\\tau}}\\sigma_{st}",
        "Chain(\\sigma, Mul(Sqrt(Div(2; \\tau)), \\sigma_{st}); =)",
        "AVSLab/basilisk/src/simulation/mujocoDynamics/_GeneralModuleFiles/meanRevertingNoise.rst",
    ),
    (
        "\\hat{a}_x & = \\cos\\alpha_{xx} \\hat{n}_x +\\cos\\alpha_{xy} \\hat{n}_y + \\cos\\alpha_{xz} \\hat{n}_z \\\\ \\hat{a}_y & = \\cos\\alpha_{yx} \\hat{n}_x +\\cos\\alpha_{yy} \\hat{n}_y + \\cos\\alpha_{yz} \\hat{n}_z \\\\ \\hat{a}_z & = \\cos\\alpha_{zx} \\hat{n}_x +\\cos\\alpha_{zy} \\hat{n}_y + \\cos\\alpha_{zz} \\hat{n}_z",
        "System(Chain(\\hat{a}_x, Add(Mul(Call(cos; \\alpha_{xx}), \\hat{n}_x), Mul(Call(cos; \\alpha_{xy}), \\hat{n}_y), Mul(Call(cos; \\alpha_{xz}), \\hat{n}_z)); =), Chain(\\hat{a}_y, Add(Mul(Call(cos; \\alpha_{yx}), \\hat{n}_x), Mul(Call(cos; \\alpha_{yy}), \\hat{n}_y), Mul(Call(cos; \\alpha_{yz}), \\hat{n}_z)); =), Chain(\\hat{a}_z, Add(Mul(Call(cos; \\alpha_{zx}), \\hat{n}_x), Mul(Call(cos; \\alpha_{zy}), \\hat{n}_y), Mul(Call(cos; \\alpha_{zz}), \\hat{n}_z)); =))",
        "moorepants/learn-multibody-dynamics/orientation.rst",
    ),
    (
        "(2+3i)(4i) - 5i = (2\\times 4)i + (3 \\times 4) i^2 - 5i = 8i + 12 (-1) - 5i = -12 + 3i .",
        "Chain(Add(Mul(Add(2, Mul(3, i)), Mul(4, i)), Neg(Mul(5, i))), Add(Mul(Cross(2; 4), i), Mul(Cross(3; 4), Pow(i; 2)), Neg(Mul(5, i))), Add(Mul(8, i), Mul(12, Neg(1)), Neg(Mul(5, i))), Add(Neg(12), Mul(3, i)); =, =, =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "m\\ddot{x} = u + f^{F_c}",
        "Chain(Mul(m, Call(\\ddot{x})), Add(u, f ^ { F _ { c } }); =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "F(t) = \\frac{1}{2} + \\sum_{\\substack{n=1 \\\\ n \\text{ odd}}}^\\infty \\frac{2}{\\pi n} \\sin (n \\pi t) .",
        "Chain(Call(F; t), Add(Div(1; 2), Limiting(sum; _{ \\substack { n = 1 \\\\ n \\text { o d d } } }^{ \\infty }; Mul(Div(2; Mul(\\pi, n)), Call(sin; Mul(n, \\pi, t))))); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "\\begin{cases} \\displaystyle q = 2\\mathrm{am}\\,\\left(\\frac{K(k_2)\\omega}{\\pi}\\right) \\\\[1.5ex] \\displaystyle p = \\frac{2\\omega_0}{k_2}\\mathrm{dn}\\,\\left(\\frac{K(k_2)\\omega}{\\pi}\\right) \\end{cases}",
        "System(Chain(q, Mul(2, Call(am; Div(Mul(Call(K; k_2), \\omega); \\pi))); =), Chain(p, Mul(Div(Mul(2, \\omega_0); k_2), Call(dn; Div(Mul(Call(K; k_2), \\omega); \\pi))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "C_{dyn} = -\\sqrt{5}Ma^2\\frac{C_{2,0dyn}}{H}",
        "Chain(C_{dyn}, Neg(Mul(Sqrt(5), M, Pow(a; 2), Div(C_{2,0dyn}; H))); =)",
        "Mayitzin/ahrs/ahrs/utils/wgs84.py",
    ),
    (
        "V = \\frac12 \\sum_{\\alpha,\\beta=1}^s k_{\\alpha\\beta}q_\\alpha q_\\beta = \\frac12 \\boldsymbol{q}^{\\mathrm{T}} \\boldsymbol{K} \\boldsymbol{q}",
        "Chain(V, Mul(Div(1; 2), BigSum(\\alpha, \\beta; 1; s; Mul(k_{\\alpha \\beta}, q_{\\alpha}, q_{\\beta}))), Mul(Div(1; 2), Transpose(\\boldsymbol{q}), \\boldsymbol{K}, \\boldsymbol{q}); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter5.tex",
    ),
    (
        "f(x) := \\frac{2\\mu^\\mu}{\\Gamma(\\mu)\\omega^\\mu} x^{2\\mu-1} \\exp\\left(-\\frac{\\mu}{\\omega}x^2 \\right)",
        "Chain(Call(f; x), Mul(Div(Mul(2, Pow(\\mu; \\mu)); Mul(Call(Gamma; \\mu), Pow(\\omega; \\mu))), Pow(x; Add(Mul(2, \\mu), Neg(1))), Call(exp; Neg(Mul(Div(\\mu; \\omega), Pow(x; 2))))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "\\chi = \\sqrt{-a} \\left(F - F_0\\right)",
        "Chain(\\chi, Mul(Sqrt(Neg(a)), Add(F, Neg(F_0))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables-example.md",
    ),
    (
        "& y'' + \\lambda y = 0, \\quad 0 < x < \\nicefrac{\\pi}{2} , \\\\ & y(0) =0, \\quad y'(\\nicefrac{\\pi}{2}) = 0 .",
        "System(Chain(Add(Call(y''), Mul(\\lambda, Call(y))), 0; =), Chain(0, x, Div(\\pi; 2); <, <), Chain(Call(y; 0), 0; =), Chain(Call(y'; Div(\\pi; 2)), 0; =))",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "\\dot{E} =& ml^2\\dot\\theta \\ddot\\theta + \\dot\\theta mgl\\sin\\theta \\\\ =& \\dot\\theta \\left[ u - mgl\\sin\\theta \\right] + \\dot\\theta mgl\\sin\\theta \\\\ =& u\\dot\\theta.",
        "Chain(Call(\\dot{E}), Add(Mul(m, Pow(l; 2), Call(\\dot{\\theta}), Call(\\ddot{\\theta})), Mul(Call(\\dot{\\theta}), m, g, l, Call(sin; Call(\\theta)))), Add(Mul(Call(\\dot{\\theta}), Add(u, Neg(Mul(m, g, l, Call(sin; Call(\\theta)))))), Mul(Call(\\dot{\\theta}), m, g, l, Call(sin; Call(\\theta)))), Mul(u, Call(\\dot{\\theta})); =, =, =)",
        "RussTedrake/underactuated/book/pend.html",
    ),
    (
        "x_c = \\begin{cases} C_1 e^{r_1 t} + C_2 e^{r_2 t} & \\text{if } \\; c^2 > 4km , \\\\ C_1 e^{-p t} + C_2 t e^{-p t} & \\text{if } \\; c^2 = 4km , \\\\ e^{-p t} \\bigl( C_1 \\cos (\\omega_1 t) + C_2 \\sin (\\omega_1 t) \\bigr) & \\text{if } \\; c^2 < 4km , \\end{cases}",
        "Chain(x_c, Piecewise(Add(Mul(C_1, Pow(e; Mul(r_1, t))), Mul(C_2, Pow(e; Mul(r_2, t)))), Chain(Pow(c; 2), Mul(4, k, m); >), Add(Mul(C_1, Pow(e; Neg(Mul(p, t)))), Mul(C_2, t, Pow(e; Neg(Mul(p, t))))), Chain(Pow(c; 2), Mul(4, k, m); =), Mul(Pow(e; Neg(Mul(p, t))), Add(Mul(C_1, Call(cos; Mul(\\omega_1, t))), Mul(C_2, Call(sin; Mul(\\omega_1, t))))), Chain(Pow(c; 2), Mul(4, k, m); <)); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "G_n = 2 (1 - 2^n) B_n",
        "Chain(G_n, Mul(2, Add(1, Neg(Pow(2; n))), B_n); =)",
        "sympy/sympy/sympy/functions/combinatorial/numbers.py",
    ),
    (
        "\\dot{\\rho}(t) = \\mp \\ddot{\\rho}_{\\text{max}} \\left ( -(t - t_{b2}) + \\frac{(t - t_{b2})^3}{t_{\\text{smooth}}^2} - \\frac{(t - t_{b2})^4}{2 t_{\\text{smooth}}^3} \\right ) + \\dot{\\rho}(t_{b2})",
        "Chain(Call(\\dot{\\rho}; t), Add(PlusMinus(Mul(\\ddot { \\rho } _ { \\text { m a x } }, Add(Neg(Add(t, Neg(t_{b2}))), Div(Pow(Add(t, Neg(t_{b2})); 3); Pow(t_{smooth}; 2)), Neg(Div(Pow(Add(t, Neg(t_{b2})); 4); Mul(2, Pow(t_{smooth}; 3)))))); True), Call(\\dot{\\rho}; t_{b2})); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedLinearTranslation/prescribedLinearTranslation.rst",
    ),
    (
        "\\frac12 I_1\\dot{\\theta}^2 + \\frac{(L_Z-L_3\\cos\\theta)^2}{2I_1\\sin^2\\theta}+\\frac{L_3^2}{2I_3}+Mgl\\cos\\theta = E",
        "Chain(Add(Mul(Div(1; 2), I_1, Pow(Call(\\dot{\\theta}); 2)), Div(Pow(Add(L_Z, Neg(Mul(L_3, Call(cos; Call(\\theta))))); 2); Mul(2, I_1, Pow(Call(sin; Call(\\theta)); 2))), Div(Pow(L_3; 2); Mul(2, I_3)), Mul(M, g, l, Call(cos; Call(\\theta)))), E; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "\\det(I) = 1 .",
        "Chain(Call(det; I), 1; =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "M = \\begin{bmatrix} 1 & 2 \\\\ 3 & 4 \\end{bmatrix} .",
        "Chain(M, MatrixOf(1, 2, 3, 4); =)",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "4 x^2 y'' - 4 x^2 y' + (1-2x)y = 0,",
        "Chain(Add(Mul(4, Pow(x; 2), y''), Neg(Mul(4, Pow(x; 2), y')), Mul(Add(1, Neg(Mul(2, x))), y)), 0; =)",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "{}^{G_{grasp}}p^O = \\begin{bmatrix} 0 \\\\ 0.11 \\\\ 0 \\end{bmatrix}, \\qquad {}^{G_{pregrasp}}p^O = \\begin{bmatrix} 0 \\\\ 0.2 \\\\ 0 \\end{bmatrix}.",
        "System(Chain(\\prescript { G _ { g r a s p } } { } { p } ^ { O }, MatrixOf(0, 0.11, 0); =), Chain(\\prescript { G _ { p r e g r a s p } } { } { p } ^ { O }, MatrixOf(0, 0.2, 0); =))",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "{}^{\\cal B} {\\pmb\\tau}_{\\text{desired}} = - K_p \\ {}^{\\cal B} {\\bf h}_{\\text{wheels}}",
        "Chain(\\prescript { \\mathcal { B } } { } { \\pmb { \\tau } } _ { \\text { d e s i r e d } }, Neg(Mul(K_p, \\prescript { \\mathcal { B } } { } { \\mathbf { h } } _ { \\text { w h e e l s } })); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attControl/mtbMomentumManagementSimple/mtbMomentumManagementSimple.rst",
    ),
    (
        "f_d = \\left[ 4.781 - \\frac{(A - 4.781)^2} {B-2A+4.781}\\right]^{-2}",
        "Chain(f_d, Pow(Add(4.781, Neg(Div(Pow(Add(A, Neg(4.781)); 2); Add(B, Neg(Mul(2, A)), 4.781)))); Neg(2)); =)",
        "CalebBell/fluids/fluids/friction.py",
    ),
    (
        "q_{motor} = n q,\\quad \\dot{q}_{motor} = n \\dot{q}, \\quad \\ddot{q}_{motor} = n \\ddot{q}, \\qquad \\tau_{motor} = \\frac{1}{n} \\tau.",
        "System(Chain(Call(q_{motor}), Mul(n, Call(q)); =), Chain(Call(\\dot{q}_{motor}), Mul(n, Call(\\dot{q})); =), Chain(Call(\\ddot{q}_{motor}), Mul(n, Call(\\ddot{q})); =), Chain(\\tau_{motor}, Mul(Div(1; n), \\tau); =))",
        "RussTedrake/manipulation/book/robot.html",
    ),
    (
        "\\gamma_{\\mathrm{out}} = \\gamma_{\\mathrm{floored}} = \\mathrm{max}(\\mathrm{minOutput}, \\gamma_{\\mathrm{capped}})",
        "Chain(\\gamma_{out}, \\gamma_{floored}, Call(max; \\text{minOutput}, \\gamma_{capped}); =, =)",
        "AVSLab/basilisk/src/simulation/sensors/coarseSunSensor/_Documentation/secModelDescription.tex",
    ),
    (
        "\\sum_{i=1}^n \\boldsymbol{F}_i^*\\cdot \\boldsymbol{v}_i = 0",
        "Chain(BigSum(i; 1; n; Mul(\\boldsymbol { F } _ { i } ^ { * }, \\boldsymbol{v}_i)), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "x' = F(x,y)",
        "Chain(x', Call(F; x, y); =)",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "a_n f^{(n)}(x) + a_{n-1} f^{(n-1)}(x) + \\cdots + a_1 f'(x) + a_0 f(x) = 0\\text{.}",
        "Chain(Add(Mul(a_n, Call(f ^ { ( n ) }; x)), Mul(a_{n-1}, Call(f ^ { ( n - 1 ) }; x)), Dots(), Mul(a_1, Call(f'; x)), Mul(a_0, Call(f; x))), 0; =)",
        "sympy/sympy/sympy/solvers/ode/single.py",
    ),
    (
        "\\dot V = - \\pmb\\sigma_{\\mathcal{B}/\\mathcal{R}}^{T} {\\bf f}(\\pmb\\sigma_{\\mathcal{B}/\\mathcal{R}}) < 0",
        "Chain(Call(\\dot{V}), Neg(Mul(Transpose(\\pmb{\\sigma}_{\\mathcal B/\\mathcal R}), Call(\\mathbf{f}; \\pmb{\\sigma}_{\\mathcal B/\\mathcal R}))), 0; =, <)",
        "AVSLab/basilisk/src/fswAlgorithms/attControl/mrpSteering/mrpSteering.rst",
    ),
    (
        "\\zeta(s,a) \\le \\frac{1}{a^s} + \\frac{1}{(s-1) a^{s-1}}",
        "Chain(Call(\\zeta; s, a), Add(Div(1; Pow(a; s)), Div(1; Mul(Add(s, Neg(1)), Pow(a; Add(s, Neg(1)))))); \\le)",
        "fredrik-johansson/arb/doc/source/mag.rst",
    ),
    (
        "\\bar{\\mathrm{g}} = \\mathrm{g}_e\\Big(1 + \\frac{1}{6}e^2 + \\frac{1}{3}k + \\frac{59}{360}e^4 + \\frac{5}{18}e^2k + \\frac{2371}{15120}e^6 + \\frac{259}{1080}e^4k + \\frac{270229}{1814400}e^8 + \\frac{9623}{45360}e^6k \\Big)",
        "Chain(\\bar{\\text{g}}, Mul(\\text{g}_e, Add(1, Mul(Div(1; 6), Pow(e; 2)), Mul(Div(1; 3), k), Mul(Div(59; 360), Pow(e; 4)), Mul(Div(5; 18), Pow(e; 2), k), Mul(Div(2371; 15120), Pow(e; 6)), Mul(Div(259; 1080), Pow(e; 4), k), Mul(Div(270229; 1814400), Pow(e; 8)), Mul(Div(9623; 45360), Pow(e; 6), k))); =)",
        "Mayitzin/ahrs/ahrs/utils/geodesy.py",
    ),
    (
        "\\mathbf{q}_{t+1} \\gets \\frac{\\mathbf{q}_{t+1}}{\\|\\mathbf{q}_{t+1}\\|}",
        "Chain(\\mathbf{q}_{t+1}, Div(\\mathbf{q}_{t+1}; Norm(\\mathbf{q}_{t+1})); \\leftarrow)",
        "Mayitzin/ahrs/ahrs/filters/angular.py",
    ),
    (
        "{}^N\\bar{v}^A = v_x(\\dot{q}_1, q_1, q_2, q_3)\\hat{n}_x + v_y(\\dot{q}_1, q_1, q_2, q_3)\\hat{n}_y + v_z(\\dot{q}_1, q_1, q_2, q_3)\\hat{n}_z",
        "Chain(\\prescript { N } { } { \\bar { v } } ^ { A }, Add(Mul(Call(v_x; Call(\\dot{q}_1), Call(q_1), q_2, q_3), \\hat{n}_x), Mul(Call(v_y; Call(\\dot{q}_1), Call(q_1), q_2, q_3), \\hat{n}_y), Mul(Call(v_z; Call(\\dot{q}_1), Call(q_1), q_2, q_3), \\hat{n}_z)); =)",
        "moorepants/learn-multibody-dynamics/configuration.rst",
    ),
    (
        "\\sum_{i=1}^n (\\boldsymbol{J}_i - m_i\\Delta\\boldsymbol{v}_i) \\cdot \\delta\\boldsymbol{r}_i = 0",
        "Chain(BigSum(i; 1; n; Mul(Add(\\boldsymbol{J}_i, Neg(Mul(m_i, \\Delta \\boldsymbol { v } _ { i }))), \\delta \\boldsymbol { r } _ { i }; 1)), 0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "& k_1 = f(x_i,y_i) , & & k_2 = f\\bigl(x_i + \\nicefrac{h}{2},y_i + k_1 (\\nicefrac{h}{2})\\bigr) , \\\\ & k_3 = f\\bigl(x_i + \\nicefrac{h}{2},y_i + k_2 (\\nicefrac{h}{2})\\bigr) , & & k_4 = f(x_i + h,y_i + k_3 h) , \\\\ & x_{i+1} = x_i + h , & & y_{i+1} = y_i + \\frac{k_1 + 2k_2 + 2k_3 + k_4}{6}\\,h .",
        "System(Chain(k_1, Call(f; x_i, y_i); =), Chain(k_2, Call(f; Add(x_i, Div(h; 2)), Add(y_i, Mul(k_1, Div(h; 2)))); =), Chain(k_3, Call(f; Add(x_i, Div(h; 2)), Add(y_i, Mul(k_2, Div(h; 2)))); =), Chain(k_4, Call(f; Add(x_i, h), Add(y_i, Mul(k_3, h))); =), Chain(x_{i+1}, Add(x_i, h); =), Chain(y_{i+1}, Add(y_i, Mul(Div(Add(k_1, Mul(2, k_2), Mul(2, k_3), k_4); 6), h)); =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\begin{aligned} &x(s)=x_{0}+\\int_{0}^{s} \\cos \\left(\\frac{1}{2} \\kappa^{\\prime} \\tau^{2}+\\kappa \\tau+\\vartheta_{0}\\right) \\mathrm{d} \\tau \\\\ &y(s)=y_{0}+\\int_{0}^{s} \\sin \\left(\\frac{1}{2} \\kappa^{\\prime} \\tau^{2}+\\kappa \\tau+\\vartheta_{0}\\right) \\mathrm{d} \\tau \\end{aligned}",
        "System(Chain(Call(x; s), Add(x_0, Integral(Call(cos; Add(Mul(Div(1; 2), \\kappa', Pow(\\tau; 2)), Mul(\\kappa, \\tau), \\vartheta_0)); \\tau; 0; s)); =), Chain(Call(y; s), Add(y_0, Integral(Call(sin; Add(Mul(Div(1; 2), \\kappa', Pow(\\tau; 2)), Mul(\\kappa, \\tau), \\vartheta_0)); \\tau; 0; s)); =))",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/clothoid_path/clothoid_path_main.rst",
    ),
    (
        "\\mathbf{m} = \\mathbf{R}^T\\mathbf{h} + \\mathbf{B}_m + \\mu_b",
        "Chain(\\mathbf{m}, Add(Mul(Transpose(\\mathbf{R}), \\mathbf{h}), \\mathbf{B}_m, \\mu_b); =)",
        "Mayitzin/ahrs/ahrs/filters/mahony.py",
    ),
    (
        "M_p = \\frac{1}{6}\\left(\\frac{\\chi\\sqrt{\\mu}}{h}\\right)^3 + \\frac{1}{2}\\left(\\frac{\\sqrt{\\mu}}{h}\\chi\\right)",
        "Chain(M_p, Add(Mul(Div(1; 6), Pow(Div(Mul(\\chi, Sqrt(\\mu)); h); 3)), Mul(Div(1; 2), Mul(Div(Sqrt(\\mu); h), \\chi))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables.md",
    ),
    (
        "\\mu = W_1 \\mu_z + W_2 \\bar\\mu",
        "Chain(\\mu, Add(Mul(W_1, \\mu_z), Mul(W_2, \\bar{\\mu})); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_2_main.rst",
    ),
    (
        "\\tan \\omega = \\frac{(\\hat{\\bm \\imath}_{n} \\times \\hat{\\bm \\imath}_{e}) \\cdot \\hat{\\bm \\imath}_{h}} {\\hat{\\bm \\imath}_{n} \\cdot \\hat{\\bm \\imath}_{e}}",
        "Chain(Call(tan; \\omega), Div(Mul(Cross(\\hat{\\bm{\\imath}}_n; \\hat{\\bm{\\imath}}_e), \\hat{\\bm{\\imath}}_h; 1); Mul(\\hat{\\bm{\\imath}}_n, \\hat{\\bm{\\imath}}_e; 1)); =)",
        "AVSLab/basilisk/src/architecture/utilitiesSelfCheck/_Documentation/secModelDescription.tex",
    ),
    (
        "{\\bf u}[n] = {\\bf K}_n {\\bf x}[n],",
        "Chain(Indexed(\\mathbf{u}; n), Mul(\\mathbf{K}_n, Indexed(\\mathbf{x}; n)); =)",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "\\text{rank}\\left(\\bar{{\\bf H}} \\right) = p,",
        "Chain(Call(rank; \\bar{\\mathbf{H}}), p; =)",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "w_i = -\\frac{2n+\\alpha+\\beta+2}{n+\\alpha+\\beta+1} \\frac{\\Gamma(n+\\alpha+1)\\Gamma(n+\\beta+1)} {\\Gamma(n+\\alpha+\\beta+1)(n+1)!} \\frac{2^{\\alpha+\\beta}}{P'_n(x_i) P^{(\\alpha,\\beta)}_{n+1}(x_i)}",
        "Chain(w_i, Neg(Mul(Div(Add(Mul(2, n), \\alpha, \\beta, 2); Add(n, \\alpha, \\beta, 1)), Div(Mul(Call(Gamma; Add(n, \\alpha, 1)), Call(Gamma; Add(n, \\beta, 1))); Mul(Call(Gamma; Add(n, \\alpha, \\beta, 1)), Factorial(Add(n, 1)))), Div(Pow(2; Add(\\alpha, \\beta)); Mul(Call(P_n'; x_i), Call(P _ { n + 1 } ^ { ( \\alpha , \\beta ) }; x_i))))); =)",
        "sympy/sympy/sympy/integrals/quadrature.py",
    ),
    (
        "\\sum_{k=K}^{\\infty} T(k) \\le \\frac{T(K)}{1-C}.",
        "Chain(BigSum(k; K; Infinity(); Call(T; k)), Div(Call(T; K); Add(1, Neg(C))); \\le)",
        "fredrik-johansson/arb/doc/source/hurwitz.rst",
    ),
    (
        "\\ddot{\\Phi}(t) = \\alpha_{\\text{max}}",
        "Chain(Call(\\ddot{\\Phi}; t), \\alpha_{max}; =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/prescribedRot2DOF/prescribedRot2DOF.rst",
    ),
    (
        "\\begin{aligned} \\dot{\\boldsymbol{R}}_{1,0} &= \\left(10 \\boldsymbol{\\hat{I}} + 20 \\boldsymbol{\\hat{J}} + 30 \\boldsymbol{\\hat{K}}\\right) \\mathrm{km/s} \\\\ \\dot{\\boldsymbol{R}}_{2,0} &= \\left(0 \\boldsymbol{\\hat{I}} + 40 \\boldsymbol{\\hat{J}} + 0 \\boldsymbol{\\hat{K}}\\right) \\mathrm{km/s} \\end{aligned}",
        "System(Chain(Call(\\dot{\\boldsymbol{R}}_{1,0}), Mul(Add(Mul(10, \\boldsymbol{\\hat{I}}), Mul(20, \\boldsymbol{\\hat{J}}), Mul(30, \\boldsymbol{\\hat{K}})), \\text{km/s}); =), Chain(Call(\\dot{\\boldsymbol{R}}_{2,0}), Mul(Add(Mul(0, \\boldsymbol{\\hat{I}}), Mul(40, \\boldsymbol{\\hat{J}}), Mul(0, \\boldsymbol{\\hat{K}})), \\text{km/s}); =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/two-body-inertial-numerical-solution.md",
    ),
    (
        "(-4A+4B+2A) \\cos(2x) + (-4B-4A+2B) \\sin(2x) = \\cos(2x) .",
        "Chain(Add(Mul(Add(Neg(Mul(4, A)), Mul(4, B), Mul(2, A)), Call(cos; Mul(2, x))), Mul(Add(Neg(Mul(4, B)), Neg(Mul(4, A)), Mul(2, B)), Call(sin; Mul(2, x)))), Call(cos; Mul(2, x)); =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "\\mathnormal{\\Lambda}(\\boldsymbol{q},t,\\boldsymbol{q}',t',\\tau) = L \\left(\\boldsymbol{q},\\frac{\\boldsymbol{q}'}{t'},t\\right) t'",
        "Chain(Call(\\Lambda; \\boldsymbol{q}, t, \\boldsymbol{q}', t', \\tau), Mul(Call(L; \\boldsymbol{q}, Div(\\boldsymbol{q}'; t'), t), t'); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "\\mathbf{A} = \\begin{bmatrix} a_{11} & a_{12} & \\ldots & a_{1n} \\\\ a_{21} & a_{22} & \\ldots & a_{2n} \\\\ \\ldots & \\ldots & \\ldots & \\ldots \\\\ a_{n1} & a_{n2} & \\ldots & a_{nn} \\end{bmatrix}, \\bar{x} = \\begin{bmatrix} x_1 \\\\ x_2 \\\\ \\ldots \\\\ x_n \\end{bmatrix}, \\bar{b} = \\begin{bmatrix} -b_1 \\\\ -b_2 \\\\ \\ldots \\\\ -b_n \\end{bmatrix}",
        "System(Chain(\\mathbf{A}, MatrixOf(a_{11}, a_{12}, Dots(), a_{1n}, a_{21}, a_{22}, Dots(), a_{2n}, Dots(), Dots(), Dots(), Dots(), a_{n1}, a_{n2}, Dots(), a_{nn}); =), Chain(\\bar{x}, MatrixOf(x_1, x_2, Dots(), x_n); =), Chain(\\bar{b}, MatrixOf(Neg(b_1), Neg(b_2), Dots(), Neg(b_n)); =))",
        "moorepants/learn-multibody-dynamics/sympy.rst",
    ),
    (
        "S(z) =\\begin{cases}\\displaystyle \\frac{\\sqrt{z} - \\sin\\sqrt{z}}{\\left(\\sqrt{z}\\right)^3} & \\left(z > 0\\right)\\\\ \\displaystyle \\frac{\\sinh\\sqrt{-z} - \\sqrt{-z}}{\\left(\\sqrt{-z}\\right)^3} & \\left(z < 0\\right) \\\\ \\displaystyle \\frac{1}{6} & \\left(z = 0\\right)\\end{cases}",
        "Chain(Call(S; z), Piecewise(Div(Add(Sqrt(z), Neg(Call(sin; Sqrt(z)))); Pow(Sqrt(z); 3)), Chain(z, 0; >), Div(Add(Call(sinh; Sqrt(Neg(z))), Neg(Sqrt(Neg(z)))); Pow(Sqrt(Neg(z)); 3)), Chain(z, 0; <), Div(1; 6), Chain(z, 0; =)); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables-example.md",
    ),
    (
        "\\left( \\bar{r}^{P_2/P_1} + \\bar{r}^{P_3/P_2} + \\bar{r}^{P_4/P_3} \\right) - \\bar{r}^{P_4/P_1} = 0",
        "Chain(Add(Add(\\bar { r } ^ { P _ { 2 } / P _ { 1 } }, \\bar { r } ^ { P _ { 3 } / P _ { 2 } }, \\bar { r } ^ { P _ { 4 } / P _ { 3 } }), Neg(\\bar { r } ^ { P _ { 4 } / P _ { 1 } })), 0; =)",
        "moorepants/learn-multibody-dynamics/configuration.rst",
    ),
    (
        "y(x) = y(x_{0}) + \\sum_{n = 1}^{\\infty} \\frac{F_{n}(x_{0},b)(x - x_{0})^n}{n!},",
        "Chain(Call(y; x), Add(Call(y; x_0), BigSum(n; 1; Infinity(); Div(Mul(Call(F_n; x_0, b), Pow(Add(x, Neg(x_0)); n)); Factorial(n)))); =)",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "B = \\frac{-F_0 \\left( \\cos \\left( \\frac{\\omega L}{a} \\right) - 1 \\right)} {\\omega^2 \\sin \\left( \\frac{\\omega L}{a} \\right)}.",
        "Chain(B, Div(Neg(Mul(F_0, Add(Call(cos; Div(Mul(\\omega, L); a)), Neg(1)))); Mul(Pow(\\omega; 2), Call(sin; Div(Mul(\\omega, L); a)))); =)",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "\\chi^2 = \\sum_{e_j \\in \\mathcal{E}} \\mathbf{e}_j^{\\scriptstyle{\\mathsf{T}}}\\Omega_j \\mathbf{e}_j.",
        "Chain(Pow(\\chi; 2), Limiting(sum; _{ e _ { j } \\in \\mathcal { E } }; Mul(Transpose(\\mathbf{e}_j), \\Omega_j, \\mathbf{e}_j)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/4_slam/graph_slam/graphSLAM_formulation.rst",
    ),
    (
        "x^{*} = \\left(1 - \\frac{\\pi_2}{\\psi^3}\\right)\\left(x^* + \\pi_2\\right) + \\frac{\\pi_2}{\\psi^3}\\left(x^* - 1 + \\pi_2\\right)",
        "Chain(x ^ { * }, Add(Mul(Add(1, Neg(Div(\\pi_2; Pow(\\psi; 3)))), Add(x ^ { * }, \\pi_2)), Mul(Div(\\pi_2; Pow(\\psi; 3)), Add(x ^ { * }, Neg(1), \\pi_2))); =)",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/lagrange-points.md",
    ),
    (
        "u(x) = \\frac{T_2-T_1}{L} x + T_1 .",
        "Chain(Call(u; x), Add(Mul(Div(Add(T_2, Neg(T_1)); L), x), T_1); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "M c = \\begin{bmatrix} \\bar z(0) \\\\ \\bar z(T) \\end{bmatrix}",
        "Chain(Mul(M, c), MatrixOf(Call(\\bar{z}; 0), Call(\\bar{z}; T)); =)",
        "python-control/python-control/doc/flatsys.rst",
    ),
    (
        "\\mathbf{a} &= \\mathbf{\\hat{n}_x} + 5 \\mathbf{\\hat{n}_y}\\\\ \\mathbf{b} &= \\mathbf{\\hat{n}_y} + \\alpha \\mathbf{\\hat{n}_z}\\\\ \\mathbf{a} + \\mathbf{b} &= \\mathbf{\\hat{n}_x} + 6 \\mathbf{\\hat{n}_y} + \\alpha \\mathbf{\\hat{n}_z}\\\\ \\mathbf{a} \\cdot \\mathbf{b} &= 5\\\\ \\mathbf{a} \\cdot \\mathbf{\\hat{n}_y} &= 5\\\\ \\mathbf{a} \\cdot \\mathbf{\\hat{n}_z} &= 0\\\\ \\mathbf{a} \\times \\mathbf{b} &= 5 \\alpha \\mathbf{\\hat{n}_x} - \\alpha \\mathbf{\\hat{n}_y} + \\mathbf{\\hat{n}_z}\\\\ \\mathbf{b} \\times \\mathbf{a} &= -5 \\alpha \\mathbf{\\hat{n}_x} + \\alpha \\mathbf{\\hat{n}_y} - \\mathbf{\\hat{n}_z}",
        "System(Chain(\\mathbf{a}, Add(\\mathbf{\\hat{n}}_x, Mul(5, \\mathbf{\\hat{n}}_y)); =), Chain(\\mathbf{b}, Add(\\mathbf{\\hat{n}}_y, Mul(\\alpha, \\mathbf{\\hat{n}}_z)); =), Chain(Add(\\mathbf{a}, \\mathbf{b}), Add(\\mathbf{\\hat{n}}_x, Mul(6, \\mathbf{\\hat{n}}_y), Mul(\\alpha, \\mathbf{\\hat{n}}_z)); =), Chain(Mul(\\mathbf{a}, \\mathbf{b}; 1), 5; =), Chain(Mul(\\mathbf{a}, \\mathbf{\\hat{n}}_y; 1), 5; =), Chain(Mul(\\mathbf{a}, \\mathbf{\\hat{n}}_z; 1), 0; =), Chain(Cross(\\mathbf{a}; \\mathbf{b}), Add(Mul(5, \\alpha, \\mathbf{\\hat{n}}_x), Neg(Mul(\\alpha, \\mathbf{\\hat{n}}_y)), \\mathbf{\\hat{n}}_z); =), Chain(Cross(\\mathbf{b}; \\mathbf{a}), Add(Neg(Mul(5, \\alpha, \\mathbf{\\hat{n}}_x)), Mul(\\alpha, \\mathbf{\\hat{n}}_y), Neg(\\mathbf{\\hat{n}}_z)); =))",
        "sympy/sympy/doc/src/explanation/modules/physics/vector/vectors/vectors.rst",
    ),
    (
        "\\boldsymbol{h}_0 = \\boldsymbol{r}_0 \\times\\boldsymbol{v}_0 = \\boldsymbol{h}",
        "Chain(\\boldsymbol{h}_0, Cross(\\boldsymbol{r}_0; \\boldsymbol{v}_0), \\boldsymbol{h}; =, =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/the-lagrange-coefficients.md",
    ),
    (
        "\\Delta P = \\Delta P_{l} \\phi_{l}^2",
        "Chain(\\Delta P, Mul(\\Delta P _ { l }, Pow(\\phi_l; 2)); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "\\theta \\approx 0",
        "Chain(\\theta, 0; \\approx)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/lqr_speed_and_steering_control/lqr_speed_and_steering_control_main.rst",
    ),
    (
        "{\\bf X} = E\\left[ \\int_0^\\infty {\\bf x} {\\bf x}^T dt \\right].",
        "Chain(\\mathbf{X}, Indexed(E; Integral(Mul(\\mathbf{x}, Transpose(\\mathbf{x})); t; 0; Infinity())); =)",
        "RussTedrake/underactuated/book/policy_search.html",
    ),
    (
        "\\boldsymbol{v} = \\frac{\\mu}{h}\\left[-\\sin\\nu\\boldsymbol{\\hat{p}} + \\left(e + \\cos\\nu\\right)\\boldsymbol{\\hat{q}}\\right]",
        "Chain(\\boldsymbol{v}, Mul(Div(\\mu; h), Add(Neg(Mul(Call(sin; \\nu), \\boldsymbol{\\hat{p}})), Mul(Add(e, Call(cos; \\nu)), \\boldsymbol{\\hat{q}}))); =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/perifocal-frame.md",
    ),
    (
        "\\chi_{i = 0} = \\frac{\\mu\\Delta t^2}{r_p \\left[f(\\chi^{+}) + \\sqrt{\\mu}\\Delta t\\right]}",
        "Chain(\\chi_{i=0}, Div(Mul(\\mu, Pow(\\Delta t; 2)); Mul(r_p, Add(Call(f; \\chi ^ { + }), Mul(Sqrt(\\mu), \\Delta t)))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables.md",
    ),
    (
        "L = \\sqrt{I_1^2 \\omega_1^2+ I_2^2 \\omega_2^2+ I_3^2 \\omega_3^2} = \\sqrt{I_1^2 \\omega_0^2 + I_3^2 \\varOmega^2}\\quad \\text{（常数）}",
        "System(Chain(L, Sqrt(Add(Mul(Pow(I_1; 2), Pow(\\omega_1; 2)), Mul(Pow(I_2; 2), Pow(\\omega_2; 2)), Mul(Pow(I_3; 2), Pow(\\omega_3; 2)))), Sqrt(Add(Mul(Pow(I_1; 2), Pow(\\omega_0; 2)), Mul(Pow(I_3; 2), Pow(\\varOmega; 2)))); =, =), Words(\\text{（常数）}))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "\\left[\\mathbf{Q}\\right] = \\begin{bmatrix}1 & 0 & 0\\\\0 & \\cos\\varepsilon & \\sin\\varepsilon\\\\0 & -\\sin\\varepsilon & \\cos\\varepsilon\\end{bmatrix}",
        "Chain([ \\mathbf { Q } ], MatrixOf(1, 0, 0, 0, Call(cos; \\varepsilon), Call(sin; \\varepsilon), 0, Neg(Call(sin; \\varepsilon)), Call(cos; \\varepsilon)); =)",
        "bryanwweber/orbital-mechanics-notes/reference/planetary-ephemeris.md",
    ),
    (
        "r = \\frac{p}{1+e\\cos \\theta}",
        "Chain(r, Div(p; Add(1, Mul(e, Call(cos; \\theta)))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "v = v_0",
        "Chain(v, v_0; =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/vectorial-mechanics/Dynamics.tex",
    ),
    (
        "\\mathbf{R}(^G_L\\mathbf{q}_\\omega)\\,^L\\mathbf{a} = \\,^G\\mathbf{g}_p",
        "Chain(Mul(Call(\\mathbf{R}; \\prescript { G } { L } { \\mathbf { q } } _ { \\omega }), \\prescript { L } { } { \\mathbf { a } }), \\prescript { G } { } { \\mathbf { g } } _ { p }; =)",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "{}^A\\text{v}^C_F = {}^A\\text{v}^B_F + {}^B\\text{v}^C_F + {}^A\\omega^B_F \\times {}^Bp^C_F.",
        "Chain(\\prescript { A } { } { \\text { v } } _ { F } ^ { C }, Add(\\prescript { A } { } { \\text { v } } _ { F } ^ { B }, \\prescript { B } { } { \\text { v } } _ { F } ^ { C }, Cross(\\prescript { A } { } { \\omega } _ { F } ^ { B }; \\prescript { B } { } { p } _ { F } ^ { C })); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\int_{\\dot{m}_{\\text{noz}_j}}\\left[\\tilde{\\bm{r}}_{M/B}\\right] \\left[\\tilde{\\bm{r}}_{M/B}\\right]\\,\\text{d}\\dot{m} =\\int_{\\dot{m}_{\\text{noz}_j}}\\left(\\left[\\tilde{\\bm{r}}_{N_j/B}\\right] + \\left[\\tilde{\\bm{r}}_{M/N_j}\\right]\\right)\\left(\\left[\\tilde{\\bm{r}}_{N_j/B}\\right] + \\left[\\tilde{\\bm{r}}_{M/N_j}\\right]\\right)\\,\\text{d}\\dot{m} =\\\\ =-\\dot{m}_{\\text{noz}_j}\\left(\\left[\\tilde{\\bm{r}}_{N_j/B}\\right]\\left[\\tilde{\\bm{r}}_{N_j/B}\\right]^T + \\frac{A_{\\text{noz}_j}}{4\\,\\pi}\\left[BM_j\\right]\\left[\\begin{matrix} 2&0&0\\\\ 0&1&0\\\\ 0&0&1 \\end{matrix}\\right]\\left[BM_j\\right]^T\\right)",
        "Chain(Over(\\int; _ { \\dot { m } _ { \\text { n o z } _ { j } } }; Mul([ \\tilde { \\bm { r } } _ { M / B } ], [ \\tilde { \\bm { r } } _ { M / B } ]); Call(\\dot{m})), Over(\\int; _ { \\dot { m } _ { \\text { n o z } _ { j } } }; Mul(Add([ \\tilde { \\bm { r } } _ { N _ { j } / B } ], [ \\tilde { \\bm { r } } _ { M / N _ { j } } ]), Add([ \\tilde { \\bm { r } } _ { N _ { j } / B } ], [ \\tilde { \\bm { r } } _ { M / N _ { j } } ])); Call(\\dot{m})), Neg(Mul(Call(\\dot{m}_{noz_j}), Add(Mul([ \\tilde { \\bm { r } } _ { N _ { j } / B } ], Transpose([ \\tilde { \\bm { r } } _ { N _ { j } / B } ])), Mul(Div(A_{noz_j}; Mul(4, \\pi)), [ B M _ { j } ], MatrixOf(2, 0, 0, 0, 1, 0, 0, 0, 1), Transpose([ B M _ { j } ]))))); =, =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "A = \\begin{bmatrix} a_{11} & a_{12} & a_{13} \\\\ a_{21} & a_{22} & a_{23} \\end{bmatrix} \\qquad \\text{and} \\qquad B = \\begin{bmatrix} b_{11} & b_{12} & b_{13} \\\\ b_{21} & b_{22} & b_{23} \\end{bmatrix} ,",
        "System(Chain(A, MatrixOf(a_{11}, a_{12}, a_{13}, a_{21}, a_{22}, a_{23}); =), Chain(B, MatrixOf(b_{11}, b_{12}, b_{13}, b_{21}, b_{22}, b_{23}); =))",
        "jirilebl/diffyqs/ap-linear-algebra.tex",
    ),
    (
        "N = \\frac{2R + \\frac{2 C M^2 R^2}{1-R} - R^2 (1+CM) (1+M) (1 + K_m + K_d + \\alpha^2) - \\frac{CM^2R^2}{(1-R)^2} (1+K_s)} {(1+K_p) - 2R - \\frac{2CM^2R^2}{1-R} + R^2(1+CM)(1+M)(1+K_m + K_d + \\alpha^2) + (1-j)\\left(\\frac{CM^2R^2}{({1-R})^2} \\right)(1+K_s)}",
        "Chain(N, Div(Add(Mul(2, R), Div(Mul(2, C, Pow(M; 2), Pow(R; 2)); Add(1, Neg(R))), Neg(Mul(Pow(R; 2), Add(1, Mul(C, M)), Add(1, M), Add(1, K_m, K_d, Pow(\\alpha; 2)))), Neg(Mul(Div(Mul(C, Pow(M; 2), Pow(R; 2)); Pow(Add(1, Neg(R)); 2)), Add(1, K_s)))); Add(Add(1, K_p), Neg(Mul(2, R)), Neg(Div(Mul(2, C, Pow(M; 2), Pow(R; 2)); Add(1, Neg(R)))), Mul(Pow(R; 2), Add(1, Mul(C, M)), Add(1, M), Add(1, K_m, K_d, Pow(\\alpha; 2))), Mul(Add(1, Neg(j)), Div(Mul(C, Pow(M; 2), Pow(R; 2)); Pow(Add(1, Neg(R)); 2)), Add(1, K_s)))); =)",
        "CalebBell/fluids/fluids/jet_pump.py",
    ),
    (
        "\\mathbf{f}_{LVLH} = -\\mathbf{B}_{oe}^{T}\\mathbf{y}",
        "Chain(\\mathbf{f}_{LVLH}, Neg(Mul(Transpose(\\mathbf{B}_{oe}), \\mathbf{y})); =)",
        "AVSLab/basilisk/src/simulation/mujocoDynamics/linearTimeInvariantSystem/orbitalElementControl.rst",
    ),
    (
        "{\\bf K}_1 = \\begin{bmatrix} 1 & 0 & -10 \\\\ -1 & 1 & 0 \\\\ 0 & 0 & 1 \\end{bmatrix} \\quad \\text{and} \\quad {\\bf K}_2 = \\begin{bmatrix} 1 & -10 & 0 \\\\ 0 & 1 & 0 \\\\ -1 & 0 & 1 \\end{bmatrix},",
        "System(Chain(\\mathbf{K}_1, MatrixOf(1, 0, Neg(10), Neg(1), 1, 0, 0, 0, 1); =), Chain(\\mathbf{K}_2, MatrixOf(1, Neg(10), 0, 0, 1, 0, Neg(1), 0, 1); =))",
        "RussTedrake/underactuated/book/policy_search.html",
    ),
    (
        "v^+\\sin\\beta = \\chi v^-\\sin\\alpha",
        "Chain(Mul(v ^ { + }, Call(sin; \\beta)), Mul(\\chi, v ^ { - }, Call(sin; \\alpha)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "\\int_{\\mathcal{A}_{\\text{sc}}} \\rho\\,\\bm{r}'_{M/B}\\cdot\\bm{\\hat{n}}\\,\\bm{r}_{M/B}\\,\\text{d}A =-\\sum_{j=1}^{N} \\int_{\\dot{m}_{\\text{noz}_j}}\\left(\\bm{r}_{M/N_j}+ \\bm{r}_{N_j/B}\\right)\\text{d}\\dot{m} =-\\sum_{j=1}^{N}\\dot{m}_{\\text{noz}_j}\\bm{r}_{N_j/B}",
        "Chain(Over(\\int; _ { \\mathcal { A } _ { \\text { s c } } }; Mul(\\rho, \\bm{r}_{M/B}', \\bm{\\hat{n}}, \\bm{r}_{M/B}; 2); A), Neg(BigSum(j; 1; N; Over(\\int; _ { \\dot { m } _ { \\text { n o z } _ { j } } }; Add(\\bm{r}_{M/N_j}, \\bm{r}_{N_j/B}); Call(\\dot{m})))), Neg(BigSum(j; 1; N; Mul(Call(\\dot{m}_{noz_j}), \\bm{r}_{N_j/B}))); =, =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "b_i[n] = P(s[n] = s_i | a[0] = a_0, o[0] = o_0, ... a_{n-1}, o_{n-1}).",
        "Chain(Indexed(b_i; n), Call(P; Given(Chain(Indexed(s; n), s_i; =); Chain(Indexed(a; 0), a_0; =), Chain(Indexed(o; 0), o_0; =), Dots(), a_{n-1}, o_{n-1}; |)); =)",
        "RussTedrake/underactuated/book/output_feedback.html",
    ),
    (
        "z R(k) = z \\frac{P(k)}{Q(k)} = z \\left( \\frac{a_p}{b_q} \\right) \\frac{1}{k^{q-p}} F(k)",
        "Chain(Mul(z, Call(R; k)), Mul(z, Div(Call(P; k); Call(Q; k))), Mul(z, Div(a_p; b_q), Div(1; Pow(k; Add(q, Neg(p)))), Call(F; k)); =, =)",
        "fredrik-johansson/arb/doc/source/hypgeom.rst",
    ),
    (
        "\\mathbf{R}_Y(\\theta) = \\begin{bmatrix} \\cos \\theta & 0 & \\sin \\theta \\\\ 0 & 1 & 0 \\\\ -\\sin \\theta & 0 & \\cos \\theta \\end{bmatrix}",
        "Chain(Call(\\mathbf{R}_Y; \\theta), MatrixOf(Call(cos; \\theta), 0, Call(sin; \\theta), 0, 1, 0, Neg(Call(sin; \\theta)), 0, Call(cos; \\theta)); =)",
        "Mayitzin/ahrs/ahrs/common/dcm.py",
    ),
    (
        "L = T - V = \\frac12 m \\left(\\dot{R}^2 + R^2 \\dot{\\phi}^2 + b^2 \\dot{\\phi}^2\\right) + kR^2",
        "Chain(L, Add(T, Neg(V)), Add(Mul(Div(1; 2), m, Add(Pow(Call(\\dot{R}); 2), Mul(Pow(Call(R); 2), Pow(Call(\\dot{\\phi}); 2)), Mul(Pow(b; 2), Pow(Call(\\dot{\\phi}); 2)))), Mul(k, Pow(Call(R); 2))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "\\frac{\\partial L}{\\partial {\\bf z}} = 0, \\quad \\frac{\\partial L}{\\partial \\lambda} = 0.",
        "System(Chain(Derivative(Call(L); \\mathbf{z}, 1; True), 0; =), Chain(Derivative(Call(L); \\lambda, 1; True), 0; =))",
        "RussTedrake/underactuated/book/optimization.html",
    ),
    (
        "\\lim_{t \\to \\infty} \\bigl( x(t), y(t) \\bigr) = (x_0,y_0) .",
        "Chain(Limiting(lim; _{ t \\to \\infty }; Pair(Call(x; t); Call(y; t))), Pair(x_0; y_0); =)",
        "jirilebl/diffyqs/ch-nonlin-systems.tex",
    ),
    (
        "D_1 = 2fD\\sin\\alpha",
        "Chain(D_1, Mul(2, f, D, Call(sin; \\alpha)); =)",
        "CalebBell/fluids/fluids/geometry.py",
    ),
    (
        "{}^{P} {\\bf r}_{S/B} = {}^{P} {\\bf r}_{S/P} - {}^{P} {\\bf r}_{B/P}",
        "Chain(\\prescript { P } { } { \\mathbf { r } } _ { S / B }, Add(\\prescript { P } { } { \\mathbf { r } } _ { S / P }, Neg(\\prescript { P } { } { \\mathbf { r } } _ { B / P })); =)",
        "AVSLab/basilisk/src/simulation/environment/spacecraftLocation/spacecraftLocation.rst",
    ),
    (
        "|c_k| \\le \\frac{4}{(2\\pi)^{2M}} \\int_N^U |a_k^{(2M)}(t)| dt.",
        "Chain(Bars(c_k), Mul(Div(4; Pow(Mul(2, \\pi); Mul(2, M))), Integral(Bars(Call(a _ { k } ^ { ( 2 M ) }; t)); t; N; U)); \\le)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "& x_1 = x_0 + h = 0 + 1 = 1, & & y_1 = y_0 + h \\, f(x_0,y_0) = 1 + 1 \\cdot \\nicefrac{1}{3} = \\nicefrac{4}{3} \\approx 1.333,\\\\ & x_2 = x_1 + h = 1 + 1 = 2, & & y_2 = y_1 + h \\, f(x_1,y_1) = \\nicefrac{4}{3} + 1 \\cdot \\frac{{(\\nicefrac{4}{3})}^2}{3} = \\nicefrac{52}{27} \\approx 1.926.",
        "System(Chain(x_1, Add(x_0, h), Add(0, 1), 1; =, =, =), Chain(y_1, Add(y_0, Mul(h, Call(f; x_0, y_0))), Add(1, Mul(1, Div(1; 3))), Div(4; 3), 1.333; =, =, =, \\approx), Chain(x_2, Add(x_1, h), Add(1, 1), 2; =, =, =), Chain(y_2, Add(y_1, Mul(h, Call(f; x_1, y_1))), Add(Div(4; 3), Mul(1, Div(Pow(Div(4; 3); 2); 3))), Div(52; 27), 1.926; =, =, =, \\approx))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\begin{bmatrix} v_1 \\\\ v_2 \\\\ v_3 \\end{bmatrix}_A \\otimes \\begin{bmatrix} w_1 \\\\ w_2 \\\\ w_3 \\end{bmatrix}_A = \\begin{bmatrix} v_1w_1 & v_1w_2 & v_1w_3 \\\\ v_2w_1 & v_2w_2 & v_2w_3 \\\\ v_3w_1 & v_3w_2 & v_3w_3 \\\\ \\end{bmatrix}_A",
        "Chain(Operated(\\otimes; Marked(MatrixOf(v_1, v_2, v_3); _{ A }); Marked(MatrixOf(w_1, w_2, w_3); _{ A })), Marked(MatrixOf(Mul(v_1, w_1), Mul(v_1, w_2), Mul(v_1, w_3), Mul(v_2, w_1), Mul(v_2, w_2), Mul(v_2, w_3), Mul(v_3, w_1), Mul(v_3, w_2), Mul(v_3, w_3)); _{ A }); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "b = 91.706\\beta^{2.5}",
        "Chain(b, Mul(91.706, Pow(\\beta; 2.5)); =)",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
    (
        "V_e = \\frac{C}{\\sqrt{\\rho_m}}",
        "Chain(V_e, Div(C; Sqrt(\\rho_m)); =)",
        "CalebBell/fluids/fluids/piping.py",
    ),
    (
        "\\sqrt{\\mu}\\left(t - t_0\\right) = \\frac{r_0 v_{r,0}}{\\sqrt{\\mu}}\\chi^2 C\\left(\\alpha\\chi^2\\right) + \\left(1 - \\alpha r_0\\right) \\chi^3S\\left(\\alpha\\chi^2\\right) + r_0 \\chi",
        "Chain(Mul(Sqrt(\\mu), Add(t, Neg(t_0))), Add(Mul(Div(Mul(r_0, v_{r,0}); Sqrt(\\mu)), Pow(\\chi; 2), Call(C; Mul(\\alpha, Pow(\\chi; 2)))), Mul(Add(1, Neg(Mul(\\alpha, r_0))), Pow(\\chi; 3), Call(S; Mul(\\alpha, Pow(\\chi; 2)))), Mul(r_0, \\chi)); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables.md",
    ),
    (
        "a_n = \\frac{2}{L} \\int_{a}^{b}{f(x) \\cos(\\frac{2n \\pi x}{L}) dx}",
        "Chain(a_n, Mul(Div(2; L), Integral(Mul(Call(f; x), Call(cos; Div(Mul(2, n, \\pi, x); L))); x; a; b)); =)",
        "sympy/sympy/sympy/series/fourier.py",
    ),
    (
        "\\overline{\\mathbf{r}} = (1-\\alpha)\\mathbf{p} + \\alpha\\mathbf{q}",
        "Chain(\\overline{\\mathbf{r}}, Add(Mul(Add(1, Neg(\\alpha)), \\mathbf{p}), Mul(\\alpha, \\mathbf{q})); =)",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "mva = \\dfrac13Ma\\omega^++mv^+a",
        "Chain(Mul(m, v, a), Add(Mul(Div(1; 3), M, a, \\omega ^ { + }), Mul(m, v ^ { + }, a)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "T(k) = \\frac{\\prod_{i=0}^{p-1} (a_i)_k}{\\prod_{i=0}^{q-1} (b_i)_k} z^k",
        "Chain(Call(T; k), Mul(Div(BigProduct(i; 0; Add(p, Neg(1)); Marked(a_i; _{ k })); BigProduct(i; 0; Add(q, Neg(1)); Marked(b_i; _{ k }))), Pow(z; k)); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "H = T'+V'",
        "Chain(H, Add(T', V'); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "\\mathbf{v}_a = \\frac{\\mathbf{a}}{|\\mathbf{a}|} \\approx -\\mathbf{R}^Te_3",
        "Chain(\\mathbf{v}_a, Div(\\mathbf{a}; Bars(\\mathbf{a})), Neg(Mul(Transpose(\\mathbf{R}), e_3)); =, \\approx)",
        "Mayitzin/ahrs/ahrs/filters/mahony.py",
    ),
    (
        "\\Delta P = \\Delta P_{g} \\phi_g^2",
        "Chain(\\Delta P, Mul(\\Delta P _ { g }, Pow(\\phi_g; 2)); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "\\mathbf E(\\mbox{\\boldmath $\\chi$}) = \\begin{bmatrix} {}_I \\mathbf e^z_I & {}_I \\mathbf e^y_{I'} & {}_I \\mathbf e^x_{I''} \\end{bmatrix} = \\begin{bmatrix} 0 & -\\sin(z) & \\cos(y)\\cos(z) \\\\ 0 & \\cos(z) & \\cos(y)\\sin(z) \\\\ 1 & 0 & -\\sin(y) \\\\ \\end{bmatrix}",
        "Chain(Call(\\mathbf{E}; \\boldsymbol{\\chi}), MatrixOf(\\prescript { } { I } { \\mathbf { e } } _ { I } ^ { z }, \\prescript { } { I } { \\mathbf { e } } _ { I ' } ^ { y }, \\prescript { } { I } { \\mathbf { e } } _ { I ' ' } ^ { x }), MatrixOf(0, Neg(Call(sin; z)), Mul(Call(cos; y), Call(cos; z)), 0, Call(cos; z), Mul(Call(cos; y), Call(sin; z)), 1, 0, Neg(Call(sin; y))); =, =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "\\boldsymbol{\\tau}_i = ((\\mathbf{r}_i - \\mathbf{r}_{\\text{COM}}) \\times \\hat{\\mathbf{g}}_{t_i})F_i = \\mathbf{d}_iF_i",
        "Chain(\\boldsymbol{\\tau}_i, Mul(Cross(Add(\\mathbf{r}_i, Neg(\\mathbf{r}_{COM})); \\hat{\\mathbf{g}}_{t_i}), F_i), Mul(\\mathbf{d}_i, F_i); =, =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/forceTorqueThrForceMapping/forceTorqueThrForceMapping.rst",
    ),
    (
        "\\mu = \\left( \\frac{\\bar\\sigma^2}{\\bar\\sigma^2 + \\sigma_z^2}\\right) \\mu_z + \\left(\\frac{\\sigma_z^2}{\\bar\\sigma^2 + \\sigma_z^2}\\right)\\bar\\mu",
        "Chain(\\mu, Add(Mul(Div(Pow(\\bar{\\sigma}; 2); Add(Pow(\\bar{\\sigma}; 2), Pow(\\sigma_z; 2))), \\mu_z), Mul(Div(Pow(\\sigma_z; 2); Add(Pow(\\bar{\\sigma}; 2), Pow(\\sigma_z; 2))), \\bar{\\mu})); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_2_main.rst",
    ),
    (
        "\\frac{\\partial J^*}{\\partial {\\bf x}} = 2 {\\bf x}^T {\\bf S}_{xx}(t) + 2{\\bf s}_{x}^T(t),\\quad \\frac{\\partial J^*}{\\partial t} = {\\bf x}^T \\dot{\\bf S}_{xx}(t) {\\bf x} + 2{\\bf x}^T \\dot{\\bf s}_x(t) + \\dot{s}_0(t).",
        "System(Chain(Derivative(Call(J ^ { * }); \\mathbf{x}, 1; True), Add(Mul(2, Transpose(\\mathbf{x}), Call(\\mathbf{S}_{xx}; t)), Mul(2, Transpose(Call(\\mathbf{s}_x; t)))); =), Chain(Derivative(Call(J ^ { * }); t, 1; True), Add(Mul(Transpose(\\mathbf{x}), Call(\\dot{\\mathbf{S}}_{xx}; t), \\mathbf{x}), Mul(2, Transpose(\\mathbf{x}), Call(\\dot{\\mathbf{s}}_x; t)), Call(\\dot{s}_0; t)); =))",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "\\bm{\\tau}_{\\mathrm{out}} = F_{\\mathrm{s}}\\bm{\\tau}_{\\mathrm{full\\_sun}}",
        "Chain(\\bm{\\tau}_{out}, Mul(F_s, \\bm{\\tau}_{full\\_sun}); =)",
        "AVSLab/basilisk/src/simulation/dynamics/RadiationPressure/_Documentation/secModelDescription.tex",
    ),
    (
        "\\Delta E = \\frac{\\left(\\boldsymbol{v} + \\Delta\\boldsymbol{v}\\right)\\cdot\\left(\\boldsymbol{v} + \\Delta\\boldsymbol{v}\\right)}{2} - \\frac{\\boldsymbol{v}\\cdot\\boldsymbol{v}}{2}",
        "Chain(\\Delta E, Add(Div(Mul(Add(\\boldsymbol{v}, \\Delta \\boldsymbol { v }), Add(\\boldsymbol{v}, \\Delta \\boldsymbol { v }); 1); 2), Neg(Div(Mul(\\boldsymbol{v}, \\boldsymbol{v}; 1); 2))); =)",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/non-hohmann-transfers.md",
    ),
    (
        "\\operatorname{erf}(z) &= \\frac{2z}{\\sqrt{\\pi}} {}_1F_1(\\tfrac{1}{2}, \\tfrac{3}{2}, -z^2)",
        "Chain(Call(erf; z), Mul(Div(Mul(2, z); Sqrt(\\pi)), Call(\\prescript { } { 1 } { F } _ { 1 }; Div(1; 2), Div(3; 2), Neg(Pow(z; 2)))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "h({\\bf x}) = {\\bf x}^T {\\bf Q}_f {\\bf x},\\quad {\\bf Q}_f = {\\bf Q}_f^T \\succeq {\\bf 0} \\\\ \\ell({\\bf x},{\\bf u}) = {\\bf x}^T {\\bf Q} {\\bf x} + {\\bf u}^T {\\bf R} {\\bf u}, \\quad {\\bf Q} = {\\bf Q}^T \\succeq 0, {\\bf R}={\\bf R}^T \\succ 0",
        "System(Chain(Call(h; \\mathbf{x}), Mul(Transpose(\\mathbf{x}), \\mathbf{Q}_f, \\mathbf{x}); =), Chain(\\mathbf{Q}_f, Transpose(\\mathbf{Q}_f), 0; =, \\succeq), Chain(Call(\\ell; \\mathbf{x}, \\mathbf{u}), Add(Mul(Transpose(\\mathbf{x}), \\mathbf{Q}, \\mathbf{x}), Mul(Transpose(\\mathbf{u}), \\mathbf{R}, \\mathbf{u})); =), Chain(\\mathbf{Q}, Transpose(\\mathbf{Q}), 0; =, \\succeq), Chain(\\mathbf{R}, Transpose(\\mathbf{R}), 0; =, \\succ))",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "m(\\gamma) = \\int_0^\\infty \\rho \\left\\{1 - \\left[1 + 2(\\text{RI}-1) (1-\\rho/\\rho_0)\\right] \\left[\\frac{\\cos \\gamma}{(1+h/R)}\\right]^2\\right\\}^{-1/2} dH",
        "Chain(Call(m; \\gamma), Integral(Mul(\\rho, Pow(Tuple(Add(1, Neg(Mul(Add(1, Mul(2, Add(\\text{RI}, Neg(1)), Add(1, Neg(Div(\\rho; \\rho_0))))), Pow(Div(Call(cos; \\gamma); Add(1, Div(h; R))); 2)))); {}); Neg(Div(1; 2)))); H; 0; Infinity()); =)",
        "CalebBell/fluids/fluids/atmosphere.py",
    ),
    (
        "f_d = \\frac{4}{F^2}",
        "Chain(f_d, Div(4; Pow(F; 2)); =)",
        "CalebBell/fluids/fluids/friction.py",
    ),
    (
        "S_{n,j,k} &=& S_{n-1,j,k} + D_{n-1,n-1}\\,W_{n-1,j}\\,W_{n-1,k} \\\\ D_{n,n} &=& A_{n,n} - \\sum_{j=1}^{R}\\sum_{k=1}^{R} U_{n,j}\\,S_{n,j,k}\\,U_{n,k} \\\\ W_{n,j} &=& \\frac{1}{D_{n,n}}\\left[ V_{n,j} - \\sum_{k=1}^{R}U_{n,k}\\,S_{n,j,k} \\right]",
        "System(Chain(S_{n,j,k}, Add(S_{n-1,j,k}, Mul(D_{n-1,n-1}, W_{n-1,j}, W_{n-1,k})); =), Chain(D_{n,n}, Add(A_{n,n}, Neg(BigSum(j; 1; R; BigSum(k; 1; R; Mul(U_{n,j}, S_{n,j,k}, U_{n,k}))))); =), Chain(W_{n,j}, Mul(Div(1; D_{n,n}), Add(V_{n,j}, Neg(BigSum(k; 1; R; Mul(U_{n,k}, S_{n,j,k}))))); =))",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "v_2(t) = x_2(t)",
        "Chain(Call(v_2; t), Call(x_2; t); =)",
        "sympy/sympy/doc/src/tutorials/physics/control/electrical_problems.rst",
    ),
    (
        "m\\ddot{q} = u + f.",
        "Chain(Mul(m, Call(\\ddot{q})), Add(u, f); =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "T = \\frac{\\pi ab}{l/(2\\mu)} = \\pi |\\alpha| \\sqrt{\\frac{\\mu}{2|E|^3}} = \\pi \\sqrt{\\frac{4\\mu a^3}{|\\alpha|}}",
        "Chain(T, Div(Mul(\\pi, a, b); Div(l; Mul(2, \\mu))), Mul(\\pi, Bars(\\alpha), Sqrt(Div(\\mu; Mul(2, Pow(Bars(E); 3))))), Mul(\\pi, Sqrt(Div(Mul(4, \\mu, Pow(a; 3)); Bars(\\alpha)))); =, =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter4.tex",
    ),
    (
        "\\dot{\\tau} = f_\\tau({\\bf x}_\\perp,\\tau) \\\\ \\dot{\\bf x}_\\perp = f_\\perp({\\bf x}_\\perp,\\tau).",
        "System(Chain(Call(\\dot{\\tau}), Call(f_\\tau; Call(\\mathbf{x}_\\perp), Call(\\tau)); =), Chain(Call(\\dot{\\mathbf{x}}_\\perp), Call(f_\\perp; Call(\\mathbf{x}_\\perp), Call(\\tau)); =))",
        "RussTedrake/underactuated/book/limit_cycles.html",
    ),
    (
        "\\Delta \\theta' & = -2\\frac{\\partial}{\\partial L} \\int_{r_{\\min}}^{r_{\\max}} \\sqrt{2m\\left(E-V_0(r)-\\dfrac{L^2}{2mr^2}\\right)} \\mathrm{d} r \\\\ & \\quad {} + 2\\frac{\\partial}{\\partial L} \\int_{r_{\\min}}^{r_{\\max}} \\frac{m}{\\sqrt{2m\\left(E-V_0(r)-\\dfrac{L^2}{2mr^2}\\right)}} \\delta V(r)\\mathrm{d} r",
        "Chain(\\Delta \\theta', Add(Neg(Mul(2, Derivative(Integral(Sqrt(Mul(2, m, Add(E, Neg(Call(V_0; r)), Neg(Div(Pow(L; 2); Mul(2, m, Pow(r; 2))))))); r; r_\\min; r_\\max); L, 1; True))), Mul(2, Derivative(Integral(Mul(Div(m; Sqrt(Mul(2, m, Add(E, Neg(Call(V_0; r)), Neg(Div(Pow(L; 2); Mul(2, m, Pow(r; 2)))))))), Call(\\delta V; r)); r; r_\\min; r_\\max); L, 1; True))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "T = \\frac{1}{2} \\dot{{\\bf q}}^T {\\bf M}({\\bf q}) \\dot{{\\bf q}},",
        "Chain(T, Mul(Div(1; 2), Transpose(Call(\\dot{\\mathbf{q}})), Call(\\mathbf{M}; Call(\\mathbf{q})), Call(\\dot{\\mathbf{q}})); =)",
        "RussTedrake/underactuated/book/multibody.html",
    ),
    (
        "\\boldsymbol{\\theta}_{am} = \\begin{bmatrix} \\theta_x \\\\ \\theta_y \\\\ \\theta_z \\end{bmatrix} = \\begin{bmatrix} \\mathrm{arctan2}(a_y, a_z) \\\\ \\mathrm{arctan2}\\big(-a_x, \\sqrt{a_y^2+a_z^2}\\big) \\\\ 0 \\end{bmatrix}",
        "Chain(\\boldsymbol{\\theta}_{am}, MatrixOf(\\theta_x, \\theta_y, \\theta_z), MatrixOf(Call(\\text{arctan2}; a_y, a_z), Call(\\text{arctan2}; Neg(a_x), Sqrt(Add(Pow(a_y; 2), Pow(a_z; 2)))), 0); =, =)",
        "Mayitzin/ahrs/ahrs/filters/complementary.py",
    ),
    (
        "u_t = 0.3 \\, u_{xx}, \\qquad u(0,t)=u(1,t)=0, \\qquad u(x,0) = 0.1 \\sin(\\pi x) + \\sin(2\\pi x) .",
        "System(Chain(u_t, Mul(0.3, u_{xx}); =), Chain(Call(u; 0, t), Call(u; 1, t), 0; =, =), Chain(Call(u; x, 0), Add(Mul(0.1, Call(sin; Mul(\\pi, x))), Call(sin; Mul(2, \\pi, x))); =))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "y(0,t) = y_{x}(0,t) = 0 .",
        "Chain(Call(y; 0, t), Call(y_x; 0, t), 0; =, =)",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "\\left|\\frac{M(z+h) - M(z-h)}{2h} - M'(z)\\right| \\le \\frac{C D^3 h^2}{1 - D h}",
        "Chain(Bars(Add(Div(Add(Call(M; Add(z, h)), Neg(Call(M; Add(z, Neg(h))))); Mul(2, h)), Neg(Call(M'; z)))), Div(Mul(C, Pow(D; 3), Pow(h; 2)); Add(1, Neg(Mul(D, h)))); \\le)",
        "fredrik-johansson/arb/doc/source/agm.rst",
    ),
    (
        "\\dot{x}=vcos\\theta",
        "Chain(Call(\\dot{x}), Mul(v, Call(cos; \\theta)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/cgmres_nmpc/cgmres_nmpc_main.rst",
    ),
    (
        "\\Delta P_{tp} = \\frac{0.83 G_{tp}^{1.4} \\sigma^{0.4} L}{D^{1.2} \\rho_{h}^{0.866}}",
        "Chain(\\Delta P _ { t p }, Div(Mul(0.83, Pow(G_{tp}; 1.4), Pow(\\sigma; 0.4), L); Mul(Pow(D; 1.2), Pow(\\rho_h; 0.866))); =)",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "\\left| \\bar{I}_a \\right| = m \\left| \\bar{r}^{P/O} \\right| ^2",
        "Chain(Bars(\\bar{I}_a), Mul(m, Pow(Bars(\\bar { r } ^ { P / O }); 2)); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{q}_X &=& \\begin{pmatrix}\\cos\\frac{\\phi}{2} & \\sin\\frac{\\phi}{2} & 0 & 0\\end{pmatrix} \\\\ && \\\\ \\mathbf{q}_Y &=& \\begin{pmatrix}\\cos\\frac{\\theta}{2} & 0 & \\sin\\frac{\\theta}{2} & 0\\end{pmatrix} \\\\ && \\\\ \\mathbf{q}_Z &=& \\begin{pmatrix}\\cos\\frac{\\psi}{2} & 0 & 0 & \\sin\\frac{\\psi}{2}\\end{pmatrix} \\end{array}",
        "System(Chain(\\mathbf{q}_X, MatrixOf(Call(cos; Div(\\phi; 2)), Call(sin; Div(\\phi; 2)), 0, 0); =), Chain(\\mathbf{q}_Y, MatrixOf(Call(cos; Div(\\theta; 2)), 0, Call(sin; Div(\\theta; 2)), 0); =), Chain(\\mathbf{q}_Z, MatrixOf(Call(cos; Div(\\psi; 2)), 0, 0, Call(sin; Div(\\psi; 2))); =))",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "x(t) = a_0+a_1t+a_2t^2+a_3t^3+a_4t^4+a_5t^5",
        "Chain(Call(x; t), Add(a_0, Mul(a_1, t), Mul(a_2, Pow(t; 2)), Mul(a_3, Pow(t; 3)), Mul(a_4, Pow(t; 4)), Mul(a_5, Pow(t; 5))); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/quintic_polynomials_planner/quintic_polynomials_planner_main.rst",
    ),
    (
        "\\begin{split} C' & = a y^{a-1} (cx-d)y x^d e^{-cx-by} + y^a d x^{d-1} (a-by)x e^{-cx-by} \\\\ & \\phantom{mm} + y^a x^d e^{-cx-by} \\bigl(-c(a-by)x-b(cx-d)y\\bigr) \\\\ & = y^a x^d e^{-cx-by} \\Bigl( a (cx-d) + d (a-by) + \\bigl(-c(a-by)x-b(cx-d)y\\bigr) \\Bigr) \\\\ & = 0 . \\end{split}",
        "Chain(C', Add(Mul(a, Pow(y; Add(a, Neg(1))), Add(Mul(c, x), Neg(d)), y, Pow(x; d), Pow(e; Add(Neg(Mul(c, x)), Neg(Mul(b, y))))), Mul(Pow(y; a), d, Pow(x; Add(d, Neg(1))), Add(a, Neg(Mul(b, y))), x, Pow(e; Add(Neg(Mul(c, x)), Neg(Mul(b, y))))), Mul(Pow(y; a), Pow(x; d), Pow(e; Add(Neg(Mul(c, x)), Neg(Mul(b, y)))), Add(Neg(Mul(c, Add(a, Neg(Mul(b, y))), x)), Neg(Mul(b, Add(Mul(c, x), Neg(d)), y))))), Mul(Pow(y; a), Pow(x; d), Pow(e; Add(Neg(Mul(c, x)), Neg(Mul(b, y)))), Add(Mul(a, Add(Mul(c, x), Neg(d))), Mul(d, Add(a, Neg(Mul(b, y)))), Add(Neg(Mul(c, Add(a, Neg(Mul(b, y))), x)), Neg(Mul(b, Add(Mul(c, x), Neg(d)), y))))), 0; =, =, =)",
        "jirilebl/diffyqs/ch-nonlin-systems.tex",
    ),
    (
        "\\begin{aligned} L_{\\text{total}} &= L_{1} + L_{\\text{curve}} + L_{2} \\\\ &= (h + q) + (\\pi\\,r) + (h - q) \\\\ &= 2\\,h + \\pi\\,r \\end{aligned}",
        "Chain(L_{total}, Add(L_1, L_{curve}, L_2), Add(Add(h, q), Mul(\\pi, r), Add(h, Neg(q))), Add(Mul(2, h), Mul(\\pi, r)); =, =, =)",
        "sympy/sympy/doc/src/tutorials/physics/mechanics/atwoods_machine_example.rst",
    ),
    (
        "\\Delta\\dot{\\gamma} = \\dot{\\gamma} - \\dot{\\gamma}_{d}",
        "Chain(Call(\\Delta \\dot { \\gamma }), Add(Call(\\dot{\\gamma}), Neg(Call(\\dot{\\gamma}_d))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/effectorInterfaces/vscmgGimbalRateServo/vscmgGimbalRateServo.rst",
    ),
    (
        "r_p = \\frac{p}{2}",
        "Chain(r_p, Div(p; 2); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/parabolic-trajectories.md",
    ),
    (
        "a^{2} x^{2} + b^{2} y^{2} + c^{2} z^{2} = C_2",
        "Chain(Add(Mul(Pow(a; 2), Pow(x; 2)), Mul(Pow(b; 2), Pow(y; 2)), Mul(Pow(c; 2), Pow(z; 2))), C_2; =)",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "\\omega = \\cos^{-1}\\left(\\frac{\\boldsymbol{e}\\cdot\\boldsymbol{N}}{e N}\\right)",
        "Chain(\\omega, Call(arccos; Div(Mul(\\boldsymbol{e}, \\boldsymbol{N}); Mul(e, N))); =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/orbital-elements-and-the-state-vector.md",
    ),
    (
        "m_{\\text{hub}} \\ddot{\\bm r}_{B/N} + m_{\\text{hub}}\\Big[\\bm{\\dot{\\omega}}_{\\cal B/N} \\times \\bm{r}_{B_c/B} + \\bm\\omega_{\\cal B/N} \\times (\\bm\\omega_{\\cal B/N} \\times \\bm{r}_{B_c/B})\\Big] + \\sum\\limits_{i}^{N_S} \\bigg( m_{\\text{sp}_{i1}} \\Big[\\ddot{\\bm r}_{B/N} + \\bm{r}''_{S_{c,i1}/B} \\\\ + 2 \\bm\\omega_{\\cal B/N} \\times \\bm{r}'_{S_{c,i1}/B} + \\dot{\\bm\\omega}_{\\cal B/N} \\times \\bm{r}_{S_{c,i1}/B} + \\bm\\omega_{\\cal B/N} \\times (\\bm\\omega_{\\cal B/N} \\times \\bm{r}_{S_{c,i1}/B})\\Big] + m_{\\text{sp}_{i2}} \\Big[\\ddot{\\bm r}_{B/N} \\\\ + \\bm{r}''_{S_{c,i2}/B} + 2 \\bm\\omega_{\\cal B/N} \\times \\bm{r}'_{S_{c,i2}/B} + \\dot{\\bm\\omega}_{\\cal B/N} \\times \\bm{r}_{S_{c,i2}/B} + \\bm\\omega_{\\cal B/N} \\times (\\bm\\omega_{\\cal B/N} \\times \\bm{r}_{S_{c,i2}/B})\\Big]\\bigg) = \\bm F_{\\text{ext}}",
        "Chain(Add(Mul(m_{hub}, Call(\\ddot{\\bm{r}}_{B/N})), Mul(m_{hub}, Add(Cross(\\bm{\\dot{\\omega}}_{\\mathcal B/\\mathcal N}; \\bm{r}_{B_c/B}), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); \\bm{r}_{B_c/B})))), Limiting(sum; _{ i }^{ N _ { S } }; Add(Mul(m_{sp_i1}, Add(Call(\\ddot{\\bm{r}}_{B/N}), \\bm{r}_{S_c,i1/B}'', Cross(Mul(2, Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})); \\bm{r}_{S_c,i1/B}'), Cross(Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }); \\bm{r}_{S_c,i1/B}), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); \\bm{r}_{S_c,i1/B})))), Mul(m_{sp_i2}, Add(Call(\\ddot{\\bm{r}}_{B/N}), \\bm{r}_{S_c,i2/B}'', Cross(Mul(2, Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})); \\bm{r}_{S_c,i2/B}'), Cross(Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }); \\bm{r}_{S_c,i2/B}), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); \\bm{r}_{S_c,i2/B}))))))), \\bm{F}_{ext}; =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\ddot{\\rho}(t) = \\mp \\ddot{\\rho}_{\\text{max}} \\left( \\frac{3 (t - t_c)^2}{t_{\\text{smooth}}^2} - \\frac{2 (t - t_c)^3}{t_{\\text{smooth}}^3} \\right)",
        "Chain(Call(\\ddot{\\rho}; t), PlusMinus(Mul(\\ddot { \\rho } _ { \\text { m a x } }, Add(Div(Mul(3, Pow(Add(t, Neg(t_c)); 2)); Pow(t_{smooth}; 2)), Neg(Div(Mul(2, Pow(Add(t, Neg(t_c)); 3)); Pow(t_{smooth}; 3))))); True); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedLinearTranslation/prescribedLinearTranslation.rst",
    ),
    (
        "\\frac{\\mathrm{d}}{\\mathrm{d} \\tau} \\frac{\\partial \\mathnormal{\\Lambda}}{\\partial q'_\\alpha} - \\frac{\\partial \\mathnormal{\\Lambda}}{\\partial q_\\alpha} = 0,\\quad \\alpha = 1,2,\\cdots,s+1",
        "System(Chain(Add(Derivative(Derivative(Call(\\Lambda); q'_{\\alpha}, 1; True); \\tau, 1), Neg(Derivative(Call(\\Lambda); q_{\\alpha}, 1; True))), 0; =), Values(\\alpha; 1, 2, Dots(), Add(s, 1)))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "\\dot{p}_\\alpha = - \\frac{\\partial H}{\\partial q_\\alpha}",
        "Chain(Call(\\dot{p}_\\alpha), Neg(Derivative(Call(H); q_\\alpha, 1; True)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter9.tex",
    ),
    (
        "\\begin{aligned} \\mathop{\\mathrm{arg\\,max}}_{\\mathbf{p}_1, \\ldots, \\mathbf{p}_N} \\ p(\\mathbf{p}_1, \\ldots, \\mathbf{p}_N \\ | \\ \\mathcal{Z}) &= \\mathop{\\mathrm{arg\\,max}}_{\\mathbf{p}_1, \\ldots, \\mathbf{p}_N} \\ p( \\mathcal{Z} \\ | \\ \\mathbf{p}_1, \\ldots, \\mathbf{p}_N) \\\\ &= \\mathop{\\mathrm{arg\\,max}}_{\\mathbf{p}_1, \\ldots, \\mathbf{p}_N} \\prod_{j=1}^M p(\\mathbf{z}_j \\ | \\ \\mathbf{p}_1, \\ldots, \\mathbf{p}_N) \\\\ &= \\mathop{\\mathrm{arg\\,max}}_{\\mathbf{p}_1, \\ldots, \\mathbf{p}_N} \\prod_{j=1}^M \\exp \\left( -(\\mathbf{e}_j(\\mathbf{z}_j, \\hat{\\mathbf{z}}_j))^{\\scriptstyle{\\mathsf{T}}}\\Omega_j \\mathbf{e}_j(\\mathbf{z}_j, \\hat{\\mathbf{z}}_j) \\right) \\\\ &= \\mathop{\\mathrm{arg\\,min}}_{\\mathbf{p}_1, \\ldots, \\mathbf{p}_N} \\sum_{j=1}^M (\\mathbf{e}_j(\\mathbf{z}_j, \\hat{\\mathbf{z}}_j))^{\\scriptstyle{\\mathsf{T}}}\\Omega_j \\mathbf{e}_j(\\mathbf{z}_j, \\hat{\\mathbf{z}}_j).\\end{aligned}",
        "Chain(Limiting(argmax; _{ \\mathbf { p } _ { 1 } , \\ldots , \\mathbf { p } _ { N } }; Call(p; Given(\\mathbf{p}_1, Dots(), \\mathbf{p}_N; \\mathcal{Z}; |))), Limiting(argmax; _{ \\mathbf { p } _ { 1 } , \\ldots , \\mathbf { p } _ { N } }; Call(p; Given(\\mathcal{Z}; \\mathbf{p}_1, Dots(), \\mathbf{p}_N; |))), Limiting(argmax; _{ \\mathbf { p } _ { 1 } , \\ldots , \\mathbf { p } _ { N } }; BigProduct(j; 1; M; Call(p; Given(\\mathbf{z}_j; \\mathbf{p}_1, Dots(), \\mathbf{p}_N; |)))), Limiting(argmax; _{ \\mathbf { p } _ { 1 } , \\ldots , \\mathbf { p } _ { N } }; BigProduct(j; 1; M; Call(exp; Neg(Mul(Transpose(Call(\\mathbf{e}_j; \\mathbf{z}_j, \\hat{\\mathbf{z}}_j)), \\Omega_j, Call(\\mathbf{e}_j; \\mathbf{z}_j, \\hat{\\mathbf{z}}_j)))))), Limiting(argmin; _{ \\mathbf { p } _ { 1 } , \\ldots , \\mathbf { p } _ { N } }; BigSum(j; 1; M; Mul(Transpose(Call(\\mathbf{e}_j; \\mathbf{z}_j, \\hat{\\mathbf{z}}_j)), \\Omega_j, Call(\\mathbf{e}_j; \\mathbf{z}_j, \\hat{\\mathbf{z}}_j)))); =, =, =, =)",
        "AtsushiSakai/PythonRobotics/docs/modules/4_slam/graph_slam/graphSLAM_formulation.rst",
    ),
    (
        "J_{\\nu}(z) = \\frac{z^{\\nu}}{2^{\\nu} e^{iz} \\Gamma(\\nu+1)} {}_1F_1(\\nu+\\tfrac{1}{2}, 2\\nu+1, 2iz) = A_{+} B_{+} + A_{-} B_{-}",
        "Chain(Call(J_\\nu; z), Mul(Div(Pow(z; \\nu); Mul(Pow(2; \\nu), Pow(e; Mul(i, z)), Call(Gamma; Add(\\nu, 1)))), Call(\\prescript { } { 1 } { F } _ { 1 }; Add(\\nu, Div(1; 2)), Add(Mul(2, \\nu), 1), Mul(2, i, z))), Add(Mul(A_+, B_+), Mul(A_-, B_-)); =, =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "k_{ {\\boldsymbol{\\alpha}}}(\\tau_{nm}) = \\sigma_n^2\\,\\delta_{nm} + a\\,\\exp(-c\\,\\tau_{nm})",
        "Chain(Call(k_{\\boldsymbol\\alpha}; \\tau_{nm}), Add(Mul(Pow(\\sigma_n; 2), \\delta_{nm}), Mul(a, Call(exp; Neg(Mul(c, \\tau_{nm}))))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "qq^* = (w^2+\\boldsymbol{v}^2,\\boldsymbol{0})",
        "Chain(Mul(q, q ^ { * }), Pair(Add(Pow(w; 2), Pow(\\boldsymbol{v}; 2)); 0); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6.tex",
    ),
    (
        "r^3 - 3 r^2 - r + 3 = 0 .",
        "Chain(Add(Pow(r; 3), Neg(Mul(3, Pow(r; 2))), Neg(r), 3), 0; =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "\\dfrac{\\mathrm{d} v_D}{\\mathrm{d} t} = -\\frac72kg",
        "Chain(Derivative(Call(v_D); t, 1), Neg(Mul(Div(7; 2), k, g)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "F = \\frac{\\chi}{\\sqrt{-a}} + F_0",
        "Chain(F, Add(Div(\\chi; Sqrt(Neg(a))), F_0); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables-example.md",
    ),
    (
        "y'' + \\lambda y = 0, \\quad y'(0) = 0, \\quad y(1) = 0 .",
        "System(Chain(Add(Call(y''), Mul(\\lambda, Call(y))), 0; =), Chain(Call(y'; 0), 0; =), Chain(Call(y; 1), 0; =))",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "\\frac{\\partial}{\\partial q_r}(\\bar{v} \\times \\bar{w}) = & \\frac{\\partial \\bar{v}}{\\partial q_r} \\times \\bar{w} + \\bar{v} \\times \\frac{\\partial \\bar{w}}{\\partial q_r}",
        "Chain(Derivative(Cross(Call(\\bar{v}); Call(\\bar{w})); q_r, 1; True), Add(Cross(Derivative(Call(\\bar{v}); q_r, 1; True); Call(\\bar{w})), Cross(Call(\\bar{v}); Derivative(Call(\\bar{w}); q_r, 1; True))); =)",
        "moorepants/learn-multibody-dynamics/differentiation.rst",
    ),
    (
        "\\mathbf{a}' = \\mathbf{a}\\cos\\theta + (\\mathbf{v}\\times\\mathbf{a})\\sin\\theta + \\mathbf{v}(\\mathbf{v}\\cdot\\mathbf{a})(1-\\cos\\theta)",
        "Chain(\\mathbf{a}', Add(Mul(\\mathbf{a}, Call(cos; \\theta)), Mul(Cross(\\mathbf{v}; \\mathbf{a}), Call(sin; \\theta)), Mul(\\mathbf{v}, Mul(\\mathbf{v}, \\mathbf{a}; 1), Add(1, Neg(Call(cos; \\theta))))); =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "& \\ddot{x} = \\frac{gm}{M}\\theta + \\frac{1}{M}u\\\\ & \\ddot{\\theta} = \\frac{g(M + m)}{Ml}\\theta + \\frac{1}{Ml}u",
        "System(Chain(Call(\\ddot{x}), Add(Mul(Div(Mul(g, m); M), Call(\\theta)), Mul(Div(1; M), u)); =), Chain(Call(\\ddot{\\theta}), Add(Mul(Div(Mul(g, Add(M, m)); Mul(M, l)), Call(\\theta)), Mul(Div(1; Mul(M, l)), u)); =))",
        "AtsushiSakai/PythonRobotics/docs/modules/10_inverted_pendulum/inverted_pendulum_main.rst",
    ),
    (
        "\\frac{{}^N\\partial \\bar{v}}{\\partial q_r} = \\frac{{}^N\\partial v_x}{\\partial q_r}\\hat{a}_x + v_x \\frac{{}^N\\partial \\hat{a}_x}{\\partial q_r} + \\frac{{}^N\\partial v_y}{\\partial q_r}\\hat{a}_y + v_y \\frac{{}^N\\partial \\hat{a}_y}{\\partial q_r} + \\frac{{}^N\\partial v_z}{\\partial q_r}\\hat{a}_z + v_z \\frac{{}^N\\partial \\hat{a}_z}{\\partial q_r}",
        "Chain(Marked(Derivative(Call(\\bar{v}); q_r, 1; True); _{ N }), Add(Mul(Marked(Derivative(Call(v_x); q_r, 1; True); _{ N }), Call(\\hat{a}_x)), Mul(Call(v_x), Marked(Derivative(Call(\\hat{a}_x); q_r, 1; True); _{ N })), Mul(Marked(Derivative(Call(v_y); q_r, 1; True); _{ N }), Call(\\hat{a}_y)), Mul(Call(v_y), Marked(Derivative(Call(\\hat{a}_y); q_r, 1; True); _{ N })), Mul(Marked(Derivative(Call(v_z); q_r, 1; True); _{ N }), Call(\\hat{a}_z)), Mul(Call(v_z), Marked(Derivative(Call(\\hat{a}_z); q_r, 1; True); _{ N }))); =)",
        "moorepants/learn-multibody-dynamics/differentiation.rst",
    ),
    (
        "f(\\theta,\\phi) = f_{0} \\cdot \\exp\\Bigg[ -2 \\cdot \\ln(2) \\Bigg( \\Big( \\frac{\\theta}{\\theta_{\\mathrm{HPBW}}} \\Big)^2 + \\Big( \\frac{\\phi}{\\phi_{\\mathrm{HPBW}}} \\Big)^2 \\Bigg) \\Bigg]",
        "Chain(Call(f; \\theta, \\phi), Mul(f_0, Call(exp; Neg(Mul(2, Call(ln; 2), Add(Pow(Div(\\theta; \\theta_{HPBW}); 2), Pow(Div(\\phi; \\phi_{HPBW}); 2)))))); =)",
        "AVSLab/basilisk/src/simulation/communication/simpleAntenna/simpleAntenna.rst",
    ),
    (
        "K_1 = 2 \\left[1 - \\left( \\frac{D_1}{D_2} \\right)^4 \\right]",
        "Chain(K_1, Mul(2, Add(1, Neg(Pow(Div(D_1; D_2); 4)))); =)",
        "CalebBell/fluids/fluids/fittings.py",
    ),
    (
        "f(x) = \\sum_{n=1}^\\infty b_n \\sin \\left( \\frac{n \\pi x }{w} \\right) .",
        "Chain(Call(f; x), BigSum(n; 1; Infinity(); Mul(b_n, Call(sin; Div(Mul(n, \\pi, x); w)))); =)",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "{ {\\boldsymbol{r}}}_{ {\\boldsymbol{\\theta}}} = \\left(\\begin{array}{ccccc} y_1 - \\mu_{ {\\boldsymbol{\\theta}}}({ {\\boldsymbol{x}}}_1)\\quad & & \\cdots\\quad & & y_N - \\mu_{ {\\boldsymbol{\\theta}}}({ {\\boldsymbol{x}}}_N) \\end{array}\\right)^\\mathrm{T}",
        "Chain(\\boldsymbol{r}_{\\boldsymbol\\theta}, Transpose(MatrixOf(Add(y_1, Neg(Call(\\mu_{\\boldsymbol\\theta}; \\boldsymbol{x}_1))), Blank(), Dots(), Blank(), Add(y_N, Neg(Call(\\mu_{\\boldsymbol\\theta}; \\boldsymbol{x}_N))))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "B = \\frac{21}{\\Gamma} \\text{ for } G_{tp} > 600",
        "Implies(Chain(G_{tp}, 600; >); Chain(B, Div(21; \\varGamma); =))",
        "CalebBell/fluids/fluids/two_phase.py",
    ),
    (
        "\\Sigma = \\begin{bmatrix} \\sigma_1^2 & \\sigma_{12} & \\cdots & \\sigma_{1n} \\\\ \\sigma_{21} &\\sigma_2^2 & \\cdots & \\sigma_{2n} \\\\ \\vdots & \\vdots & \\ddots & \\vdots \\\\ \\sigma_{n1} & \\sigma_{n2} & \\cdots & \\sigma_n^2 \\end{bmatrix}",
        "Chain(\\Sigma, MatrixOf(Pow(\\sigma_1; 2), \\sigma_{12}, Dots(), \\sigma_{1n}, \\sigma_{21}, Pow(\\sigma_2; 2), Dots(), \\sigma_{2n}, Dots(), Dots(), Dots(), Dots(), \\sigma_{n1}, \\sigma_{n2}, Dots(), Pow(\\sigma_n; 2)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_main.rst",
    ),
    (
        "\\left\\{\\begin{matrix} X_\\mathrm{B} \\\\ Y_\\mathrm{B} \\\\ Z_\\mathrm{B} \\end{matrix}\\right\\} = \\left[\\begin{matrix} \\cos\\alpha_\\mathrm{B} & 0 & -\\sin\\alpha_\\mathrm{B} \\\\ 0 & 1 & 0 \\\\ \\sin\\alpha_\\mathrm{B} & 0 & \\cos\\alpha_\\mathrm{B} \\end{matrix}\\right] \\left[\\begin{matrix} \\cos\\beta & \\sin(-\\beta) & 0 \\\\ -\\sin(-\\beta) & \\cos\\beta & 0 \\\\ 0 & 0 & 1 \\end{matrix}\\right] \\left\\{\\begin{matrix} -D \\\\ Y_\\mathrm{W} \\\\ -L \\end{matrix}\\right\\}",
        "Chain(Tuple(MatrixOf(X_B, Y_B, Z_B); {}), Mul(MatrixOf(Call(cos; \\alpha_B), 0, Neg(Call(sin; \\alpha_B)), 0, 1, 0, Call(sin; \\alpha_B), 0, Call(cos; \\alpha_B)), MatrixOf(Call(cos; \\beta), Call(sin; Neg(\\beta)), 0, Neg(Call(sin; Neg(\\beta))), Call(cos; \\beta), 0, 0, 0, 1), Tuple(MatrixOf(Neg(D), Y_W, Neg(L)); {})); =)",
        "JSBSim-Team/jsbsim-reference-manual/docs/user/concepts/frames-of-reference.md",
    ),
    (
        "m \\ddot{x} = \\sum F = -kx - c\\dot{x}",
        "Chain(Mul(m, Call(\\ddot{x})), Limiting(sum; ; F), Add(Neg(Mul(k, Call(x))), Neg(Mul(c, Call(\\dot{x})))); =, =)",
        "sympy/sympy/doc/src/explanation/modules/physics/biomechanics/biomechanics.rst",
    ),
    (
        "\\theta(t) = \\pm \\frac{\\ddot{\\theta}_{\\text{max}} (t - t_{s1})^2}{2} + \\dot{\\theta}(t_{s1})(t - t_{s1}) + \\theta(t_{s1})",
        "Chain(Call(\\theta; t), Add(PlusMinus(Div(Mul(\\ddot { \\theta } _ { \\text { m a x } }, Pow(Add(t, Neg(t_{s1})); 2)); 2)), Mul(Call(\\dot{\\theta}; t_{s1}), Add(t, Neg(t_{s1}))), Call(\\theta; t_{s1})); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedRotation1DOF/prescribedRotation1DOF.rst",
    ),
    (
        "M_e = E - e \\sin{E}",
        "Chain(M_e, Add(E, Neg(Mul(e, Call(sin; E)))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "v = \\frac{J}{m},\\quad \\omega = \\frac{6J}{ml}",
        "System(Chain(v, Div(J; m); =), Chain(\\omega, Div(Mul(6, J); Mul(m, l)); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "\\theta = \\arccos\\Big(\\frac{\\mathrm{tr}(\\mathbf{R})-1}{2}\\Big)",
        "Chain(\\theta, Call(arccos; Div(Add(Call(tr; \\mathbf{R}), Neg(1)); 2)); =)",
        "Mayitzin/ahrs/ahrs/common/dcm.py",
    ),
    (
        "v = [J^G(q)]^+V^{G_d}.",
        "Chain(v, Mul(Marked(Call(J ^ { G }; q); ^+), V ^ { G _ { d } }); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "\\bm{c}' &= \\frac{1}{m_{\\text{sc}}}\\sum_{i=1}^{N_{S}}\\big(m_{\\text{sp}_{i1}}\\bm{r}'_{S_{c,i1}/B}+m_{\\text{sp}_{i2}}\\bm{r}'_{S_{c,i2}/B}\\big) \\\\ \\bm{c}'' &= \\frac{1}{m_{\\text{sc}}}\\sum_{i=1}^{N_{S}}\\big(m_{\\text{sp}_{i1}}\\bm{r}''_{S_{c,i1}/B}+m_{\\text{sp}_{i2}}\\bm{r}''_{S_{c,i2}/B}\\big)",
        "System(Chain(\\bm{c}', Mul(Div(1; m_{sc}), BigSum(i; 1; N_S; Add(Mul(m_{sp_i1}, \\bm{r}_{S_c,i1/B}'), Mul(m_{sp_i2}, \\bm{r}_{S_c,i2/B}')))); =), Chain(\\bm{c}'', Mul(Div(1; m_{sc}), BigSum(i; 1; N_S; Add(Mul(m_{sp_i1}, \\bm{r}_{S_c,i1/B}''), Mul(m_{sp_i2}, \\bm{r}_{S_c,i2/B}'')))); =))",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\begin{aligned} \\boldsymbol{\\rho} &= \\frac{\\boldsymbol{r}}{r_{12}} = x^*\\boldsymbol{\\hat{\\imath}} + y^*\\boldsymbol{\\hat{\\jmath}} + z^*\\boldsymbol{\\hat{k}} \\\\ \\boldsymbol{\\sigma} &= \\frac{\\boldsymbol{r}_1}{r_{12}} = \\left(x^* + \\pi_2\\right)\\boldsymbol{\\hat{\\imath}} + y^*\\boldsymbol{\\hat{\\jmath}} + z^*\\boldsymbol{\\hat{k}} \\\\ \\boldsymbol{\\psi} &= \\frac{\\boldsymbol{r}_2}{r_{12}} = \\left(x^* - 1 + \\pi_2\\right)\\boldsymbol{\\hat{\\imath}} + y^*\\boldsymbol{\\hat{\\jmath}} + z^*uvec{k} \\end{aligned}",
        "System(Chain(\\boldsymbol{\\rho}, Div(\\boldsymbol{r}; r_{12}), Add(Mul(x ^ { * }, \\boldsymbol{\\hat{\\imath}}), Mul(y ^ { * }, \\boldsymbol{\\hat{\\jmath}}), Mul(z ^ { * }, \\boldsymbol{\\hat{k}})); =, =), Chain(\\boldsymbol{\\sigma}, Div(\\boldsymbol{r}_1; r_{12}), Add(Mul(Add(x ^ { * }, \\pi_2), \\boldsymbol{\\hat{\\imath}}), Mul(y ^ { * }, \\boldsymbol{\\hat{\\jmath}}), Mul(z ^ { * }, \\boldsymbol{\\hat{k}})); =, =), Chain(\\boldsymbol{\\psi}, Div(\\boldsymbol{r}_2; r_{12}), Add(Mul(Add(x ^ { * }, Neg(1), \\pi_2), \\boldsymbol{\\hat{\\imath}}), Mul(y ^ { * }, \\boldsymbol{\\hat{\\jmath}}), Mul(z ^ { * }, u, v, e, c, k)); =, =))",
        "bryanwweber/orbital-mechanics-notes/the-n-body-problem/circular-restricted-three-body-problem.md",
    ),
    (
        "\\bar{F}_r = \\begin{bmatrix} \\sum_{i=1}^\\nu {}^A\\bar{v}_1^{P_i} \\cdot \\bar{R}_i \\\\ \\vdots \\\\ \\sum_{i=1}^\\nu {}^A\\bar{v}_r^{P_i} \\cdot \\bar{R}_i \\\\ \\vdots \\\\ \\sum_{i=1}^\\nu {}^A\\bar{v}_n^{P_i} \\cdot \\bar{R}_i \\end{bmatrix}",
        "Chain(\\bar{F}_r, MatrixOf(BigSum(i; 1; \\nu; Mul(\\prescript { A } { } { \\bar { v } } _ { 1 } ^ { P _ { i } }, \\bar{R}_i; 1)), Dots(), BigSum(i; 1; \\nu; Mul(\\prescript { A } { } { \\bar { v } } _ { r } ^ { P _ { i } }, \\bar{R}_i; 1)), Dots(), BigSum(i; 1; \\nu; Mul(\\prescript { A } { } { \\bar { v } } _ { n } ^ { P _ { i } }, \\bar{R}_i; 1))); =)",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "\\bar P_{l,m}[x] = P_{l,m}[x] N_{l,m}",
        "Chain(Indexed(\\bar{P}_{l,m}; x), Mul(Indexed(P_{l,m}; x), N_{l,m}); =)",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/spacecraftPointing/_Documentation/example/secModelDescription.tex",
    ),
    (
        "f(x) := \\frac{\\alpha}{s} \\left(\\frac{x-m}{s}\\right)^{-1-\\alpha} e^{-(\\frac{x-m}{s})^{-\\alpha}}",
        "Chain(Call(f; x), Mul(Div(\\alpha; s), Pow(Div(Add(x, Neg(m)); s); Add(Neg(1), Neg(\\alpha))), Pow(e; Neg(Pow(Div(Add(x, Neg(m)); s); Neg(\\alpha))))); =)",
        "sympy/sympy/sympy/stats/crv_types.py",
    ),
    (
        "{\\bf J} = \\min_a \\left[ {\\bf \\ell}(a) + {\\bf T}(a) {\\bf J} \\right],",
        "Chain(\\mathbf{J}, Limiting(min; _{ a }; Add(Call(\\mathbf{\\ell}; a), Mul(Call(\\mathbf{T}; a), \\mathbf{J}))); =)",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "\\dot{\\bar{f}}_n(\\dot{\\bar{u}}_r, \\dot{\\bar{u}}_s, \\bar{u}_s, \\bar{u}_r, \\bar{q}, t) = \\mathbf{M}_{nd}\\dot{\\bar{u}}_r + \\bar{g}_{nd}= 0 \\in \\mathbb{R}^m\\\\ \\dot{\\bar{u}}_r = -\\mathbf{M}_{nd}(\\bar{q}, t)^{-1} \\bar{g}_{nd}(\\dot{\\bar{u}}_s, \\bar{u}_s, \\bar{q}, t)",
        "System(Chain(Call(\\dot{\\bar{f}}_n; Call(\\dot{\\bar{u}}_r), Call(\\dot{\\bar{u}}_s), Call(\\bar{u}_s), Call(\\bar{u}_r), \\bar{q}, t), Add(Mul(Call(\\mathbf{M}_{nd}), Call(\\dot{\\bar{u}}_r)), Call(\\bar{g}_{nd})), 0, Pow(\\mathbb{R}; m); =, =, \\in), Chain(Call(\\dot{\\bar{u}}_r), Neg(Mul(Pow(Call(\\mathbf{M}_{nd}; \\bar{q}, t); Neg(1)), Call(\\bar{g}_{nd}; Call(\\dot{\\bar{u}}_s), Call(\\bar{u}_s), \\bar{q}, t))); =))",
        "moorepants/learn-multibody-dynamics/nonholonomic-eom.rst",
    ),
    (
        "x_{t+1} = A x_t + B u_t",
        "Chain(x_{t+1}, Add(Mul(A, x_t), Mul(B, u_t)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/6_path_tracking/lqr_speed_and_steering_control/lqr_speed_and_steering_control_main.rst",
    ),
    (
        "m := \\sum_{i=1}^\\nu m_i",
        "Chain(m, BigSum(i; 1; \\nu; m_i); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "\\left[I_{\\text{fuel, }Tc}\\right] = \\frac{2}{5}\\,m_{\\text{fuel}} \\,R_{\\text{tank}}^2\\, \\left[I_{3\\times3}\\right]",
        "Chain([ I _ { \\text { f u e l , } T c } ], Mul(Div(2; 5), m_{fuel}, Pow(R_{tank}; 2), [ I _ { 3 \\times 3 } ]); =)",
        "AVSLab/basilisk/src/simulation/dynamics/FuelTank/_Documentation/secModelDescription.tex",
    ),
    (
        "A &\\in \\mathbb{R}^{(n-l+o-m) \\times (n-l+o-m)}\\\\ B &\\in \\mathbb{R}^{(n-l+o-m) \\times s}",
        "System(Chain(A, Pow(\\mathbb{R}; Cross(Add(n, Neg(l), o, Neg(m)); Add(n, Neg(l), o, Neg(m)))); \\in), Chain(B, Pow(\\mathbb{R}; Cross(Add(n, Neg(l), o, Neg(m)); s)); \\in))",
        "sympy/sympy/doc/src/explanation/modules/physics/mechanics/linearize.rst",
    ),
    (
        "RMSE = \\sqrt{\\frac{1}{MN}\\sum_{i=1}^{M}\\sum_{j=1}^{N}(A_{ij} - B_{ij})^2}",
        "Chain(\\text{RMSE}, Sqrt(Mul(Div(1; Mul(M, N)), BigSum(i; 1; M; BigSum(j; 1; N; Pow(Add(A_{ij}, Neg(B_{ij})); 2))))); =)",
        "Mayitzin/ahrs/ahrs/utils/metrics.py",
    ),
    (
        "\\tan\\frac{\\nu - \\nu_0}{2} = \\frac{z}{z}",
        "Chain(Call(tan; Div(Add(\\nu, Neg(\\nu_0)); 2)), Div(z; z); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/universal-variables.md",
    ),
    (
        "\\frac{\\mathrm{d}}{\\mathrm{d} x} \\frac{\\partial F}{\\partial y'_i} - \\frac{\\partial F}{\\partial y_i} = 0 \\quad (i = 1,2,\\cdots,n)",
        "System(Chain(Add(Derivative(Derivative(Call(F); y'_i, 1; True); x, 1), Neg(Derivative(Call(F); y_i, 1; True))), 0; =), Values(i; 1, 2, Dots(), n))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter9.tex",
    ),
    (
        "e = 1 + \\frac{r_p}{a} = 1 + \\frac{r_p v_{\\infty}^2}{\\mu_i}",
        "Chain(e, Add(1, Div(r_p; a)), Add(1, Div(Mul(r_p, Pow(v_\\infty; 2)); \\mu_i)); =, =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-depahture-trajectory.md",
    ),
    (
        "F^{B_p}_{{\\text{name}},C} = \\begin{bmatrix} \\tau^{B_p}_{\\text{name},C} \\\\ f^{B_p}_{\\text{name},C} \\end{bmatrix} \\quad \\text{ or, if you prefer } \\quad \\left[F^{B_p}_{\\text{name}}\\right]_C = \\begin{bmatrix} \\left[\\tau^{B_p}_{\\text{name}}\\right]_C \\\\ \\left[f^{B_p}_{\\text{name}}\\right]_C \\end{bmatrix}.",
        "System(Chain(F _ { \\text { n a m e } , C } ^ { B _ { p } }, MatrixOf(\\tau _ { \\text { n a m e } , C } ^ { B _ { p } }, f _ { \\text { n a m e } , C } ^ { B _ { p } }); =), Words(\\text{or,if~you~prefer}), Chain(Marked(F _ { \\text { n a m e } } ^ { B _ { p } }; _{ C }), MatrixOf(Marked(\\tau _ { \\text { n a m e } } ^ { B _ { p } }; _{ C }), Marked(f _ { \\text { n a m e } } ^ { B _ { p } }; _{ C })); =))",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "\\boldsymbol{x}(t_{k+1}) = \\boldsymbol{x}(t_k) + \\boldsymbol{f}\\big( \\boldsymbol{x}_k\\,,\\,\\boldsymbol{u}_k \\big) \\, \\Delta t",
        "Chain(Call(\\boldsymbol{x}; t_{k+1}), Add(Call(\\boldsymbol{x}; t_k), Mul(Call(\\boldsymbol{f}; \\boldsymbol{x}_k, \\boldsymbol{u}_k), \\Delta t)); =)",
        "JSBSim-Team/jsbsim-reference-manual/docs/formulation/overview.md",
    ),
    (
        "|\\operatorname{atan}(x+a) - \\operatorname{atan}(x)| = \\operatorname{atan}\\left(\\frac{|a|}{1 + x(x+a)}\\right).",
        "Chain(Bars(Add(Call(atan; Add(x, a)), Neg(Call(atan; x)))), Call(atan; Div(Bars(a); Add(1, Mul(x, Add(x, a))))); =)",
        "fredrik-johansson/arb/doc/source/formulas.rst",
    ),
    (
        "K_B := \\frac{1}{2} m {}^N\\bar{v}^{B_o} \\cdot {}^N\\bar{v}^{B_o} + \\frac{1}{2} {}^N\\bar{\\omega}^B \\cdot \\breve{I}^{B/B_o} \\cdot {}^N\\bar{\\omega}^B",
        "Chain(K_B, Add(Mul(Div(1; 2), m, \\prescript { N } { } { \\bar { v } } ^ { B _ { o } }, \\prescript { N } { } { \\bar { v } } ^ { B _ { o } }; 3), Mul(Div(1; 2), \\prescript { N } { } { \\bar { \\omega } } ^ { B }, \\breve { I } ^ { B / B _ { o } }, \\prescript { N } { } { \\bar { \\omega } } ^ { B })); =)",
        "moorepants/learn-multibody-dynamics/energy.rst",
    ),
    (
        "I_{s_{i2,2}} ( \\dot\\omega_{s_{i2,2}} + \\ddot\\theta_{i1} + \\ddot\\theta_{i2}) = - (I_{s_{i2,1}} - I_{s_{i2,3}}) \\omega_{s_{i2,3}} \\omega_{s_{i2,1}} - k_{i2} \\theta_{i2} - c_{i2} \\dot{\\theta}_{i2} + \\hat{\\bm s}_{i2,2}^T \\bm \\tau_{\\text{ext}_{i2},H_{i2}} \\\\ - m_{\\text{sp}_{i2}} d_{i2} \\hat{\\bm s}_{i2,3}^T \\Big[ \\ddot{\\bm{r}}_{B/N} + \\bm{r}''_{S_{c,i2}/B} + 2 \\bm\\omega_{\\cal B/N} \\times \\bm{r}'_{S_{c,i2}/B} + \\dot{\\bm\\omega}_{\\cal B/N} \\times \\bm{r}_{S_{c,i2}/B} + \\bm\\omega_{\\cal B/N} \\times (\\bm\\omega_{\\cal B/N} \\times \\bm{r}_{S_{c,i2}/B})\\Big]",
        "Chain(Mul(I_{s_i2,2}, Add(Call(\\dot{\\omega}_{s_i2,2}), Call(\\ddot{\\theta}_{i1}), Call(\\ddot{\\theta}_{i2}))), Add(Neg(Mul(Add(I_{s_i2,1}, Neg(I_{s_i2,3})), \\omega_{s_i2,3}, \\omega_{s_i2,1})), Neg(Mul(k_{i2}, Call(\\theta_{i2}))), Neg(Mul(c_{i2}, Call(\\dot{\\theta}_{i2}))), Mul(Transpose(\\hat{\\bm{s}}_{i2,2}), \\bm{\\tau}_{ext_i2,H_i2}), Neg(Mul(m_{sp_i2}, d_{i2}, Transpose(\\hat{\\bm{s}}_{i2,3}), Add(Call(\\ddot{\\bm{r}}_{B/N}), \\bm{r}_{S_c,i2/B}'', Cross(Mul(2, Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})); \\bm{r}_{S_c,i2/B}'), Cross(Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }); \\bm{r}_{S_c,i2/B}), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); \\bm{r}_{S_c,i2/B})))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\begin{bmatrix} x \\\\ y \\end{bmatrix} ' = \\begin{bmatrix} 1 & 2 \\\\ 2 & 1 \\end{bmatrix} \\begin{bmatrix} x \\\\ y \\end{bmatrix} .",
        "Chain(Marked(MatrixOf(x, y); '), Mul(MatrixOf(1, 2, 2, 1), MatrixOf(x, y)); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\mathbf{y} = \\begin{bmatrix}y_0 & y_1 & \\cdots & y_{N-1}\\end{bmatrix}",
        "Chain(\\mathbf{y}, MatrixOf(y_0, y_1, Dots(), y_{N-1}); =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "J_2 = \\sqrt{\\mu\\alpha a(1-e^2)}",
        "Chain(J_2, Sqrt(Mul(\\mu, \\alpha, a, Add(1, Neg(Pow(e; 2))))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\left( \\frac{\\log(k+1)}{\\log(k)} \\right)^d \\le \\left(1 + \\frac{1}{k \\log(k)}\\right)^d.",
        "Chain(Pow(Div(Call(log; Add(k, 1)); Call(log; k)); d), Pow(Add(1, Div(1; Mul(k, Call(log; k)))); d); \\le)",
        "fredrik-johansson/arb/doc/source/polylogarithms.rst",
    ),
    (
        "\\begin{cases} \\displaystyle \\dot{X}_C(t) = -(kg\\cos\\alpha) t + \\dot{X}_C(0) \\\\ \\displaystyle \\dot{Y}_C(t) = -(kg\\sin\\alpha) t + \\dot{Y}_C(0) \\end{cases}",
        "System(Chain(Call(\\dot{X}_C; t), Add(Neg(Mul(Mul(k, g, Call(cos; \\alpha)), t)), Call(\\dot{X}_C; 0)); =), Chain(Call(\\dot{Y}_C; t), Add(Neg(Mul(Mul(k, g, Call(sin; \\alpha)), t)), Call(\\dot{Y}_C; 0)); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter6_gyro_theory.tex",
    ),
    (
        "\\omega = \\frac{J\\sin\\alpha}{ml}",
        "Chain(\\omega, Div(Mul(J, Call(sin; \\alpha)); Mul(m, l)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "\\begin{array}{rcl} \\mathbf{b} &=& \\begin{bmatrix} \\cos\\theta_x & \\sin\\theta_x\\sin\\theta_y & \\sin\\theta_x\\cos\\theta_y \\\\ 0 & \\cos\\theta_y & -\\sin\\theta_y \\\\ -\\sin\\theta_x & \\cos\\theta_x\\sin\\theta_y & \\cos\\theta_x\\cos\\theta_y \\end{bmatrix} \\begin{bmatrix}m_x \\\\ m_y \\\\ m_z\\end{bmatrix} \\\\ \\begin{bmatrix}b_x \\\\ b_y \\\\ b_z\\end{bmatrix} &=& \\begin{bmatrix} m_x\\cos\\theta_x + m_y\\sin\\theta_x\\sin\\theta_y + m_z\\sin\\theta_x\\cos\\theta_y \\\\ m_y\\cos\\theta_y - m_z\\sin\\theta_y \\\\ -m_x\\sin\\theta_x + m_y\\cos\\theta_x\\sin\\theta_y + m_z\\cos\\theta_x\\cos\\theta_y \\end{bmatrix} \\end{array}",
        "System(Chain(\\mathbf{b}, Mul(MatrixOf(Call(cos; \\theta_x), Mul(Call(sin; \\theta_x), Call(sin; \\theta_y)), Mul(Call(sin; \\theta_x), Call(cos; \\theta_y)), 0, Call(cos; \\theta_y), Neg(Call(sin; \\theta_y)), Neg(Call(sin; \\theta_x)), Mul(Call(cos; \\theta_x), Call(sin; \\theta_y)), Mul(Call(cos; \\theta_x), Call(cos; \\theta_y))), MatrixOf(m_x, m_y, m_z)); =), Chain(MatrixOf(b_x, b_y, b_z), MatrixOf(Add(Mul(m_x, Call(cos; \\theta_x)), Mul(m_y, Call(sin; \\theta_x), Call(sin; \\theta_y)), Mul(m_z, Call(sin; \\theta_x), Call(cos; \\theta_y))), Add(Mul(m_y, Call(cos; \\theta_y)), Neg(Mul(m_z, Call(sin; \\theta_y)))), Add(Neg(Mul(m_x, Call(sin; \\theta_x))), Mul(m_y, Call(cos; \\theta_x), Call(sin; \\theta_y)), Mul(m_z, Call(cos; \\theta_x), Call(cos; \\theta_y)))); =))",
        "Mayitzin/ahrs/ahrs/filters/complementary.py",
    ),
    (
        "\\begin{aligned}\\boldsymbol{v}(t) &= \\frac{dx(t)}{dt}\\boldsymbol{\\hat{\\imath}} + \\frac{dy(t)}{dt}\\boldsymbol{\\hat{\\jmath}} + \\frac{dz(t)}{dt}\\boldsymbol{\\hat{k}} \\\\ &= v_x\\boldsymbol{\\hat{\\imath}} + v_y\\boldsymbol{\\hat{\\jmath}} + v_z\\boldsymbol{\\hat{k}} \\\\ &= \\dot{\\boldsymbol{r}}\\end{aligned}",
        "Chain(Call(\\boldsymbol{v}; t), Add(Mul(Derivative(Call(x; t); t, 1), \\boldsymbol{\\hat{\\imath}}), Mul(Derivative(Call(y; t); t, 1), \\boldsymbol{\\hat{\\jmath}}), Mul(Derivative(Call(z; t); t, 1), \\boldsymbol{\\hat{k}})), Add(Mul(v_x, \\boldsymbol{\\hat{\\imath}}), Mul(v_y, \\boldsymbol{\\hat{\\jmath}}), Mul(v_z, \\boldsymbol{\\hat{k}})), Call(\\dot{\\boldsymbol{r}}); =, =, =)",
        "bryanwweber/orbital-mechanics-notes/review/kinematics.md",
    ),
    (
        "\\mathrm{B} = \\frac{(a-1)! (b-1)!}{(a+b-1)!}",
        "Chain(\\text{B}, Div(Mul(Factorial(Add(a, Neg(1))), Factorial(Add(b, Neg(1)))); Factorial(Add(a, b, Neg(1)))); =)",
        "sympy/sympy/sympy/functions/special/beta_functions.py",
    ),
    (
        "\\mathbf{q}^a & = & e^{\\log(\\mathbf{q}^a)} \\\\ & = & e^{a \\log(\\mathbf{q})} \\\\ & = & e^{a \\mathbf{u}\\theta} \\\\ & = & \\begin{bmatrix} \\cos(a\\theta) \\\\ \\mathbf{u} \\sin(a\\theta) \\end{bmatrix}",
        "Chain(Pow(\\mathbf{q}; a), Pow(e; Call(log; Pow(\\mathbf{q}; a))), Pow(e; Mul(a, Call(log; \\mathbf{q}))), Pow(e; Mul(a, \\mathbf{u}, \\theta)), MatrixOf(Call(cos; Mul(a, \\theta)), Mul(\\mathbf{u}, Call(sin; Mul(a, \\theta)))); =, =, =, =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "\\bm c = \\frac{1}{m_{sc}}\\Big[ \\sum_{i=1}^{N_p} m_p {\\bm r}_{S_i/B}\\Big]",
        "Chain(\\bm{c}, Mul(Div(1; m_{sc}), BigSum(i; 1; N_p; Mul(m_p, \\bm{r}_{S_i/B}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/NHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\bm x_{n+1} = \\bm x_{n} + h \\bm k_{1}",
        "Chain(\\bm{x}_{n+1}, Add(\\bm{x}_n, Mul(h, \\bm{k}_1)); =)",
        "AVSLab/basilisk/src/simulation/dynamics/Integrators/_Documentation/secModelDescription.tex",
    ),
    (
        "\\frac{-m \\ddot{x}}{ m \\ddot{y} + mg} = \\frac{(u_1 + u_2)\\sin\\theta}{(u_1+u_2)\\cos\\theta} = \\tan\\theta.",
        "Chain(Div(Neg(Mul(m, Call(\\ddot{x}))); Add(Mul(m, Call(\\ddot{y})), Mul(m, g))), Div(Mul(Add(u_1, u_2), Call(sin; \\theta)); Mul(Add(u_1, u_2), Call(cos; \\theta))), Call(tan; \\theta); =, =)",
        "RussTedrake/underactuated/book/trajopt.html",
    ),
    (
        "\\operatorname{E}_{2k} = (-1)^k \\mathcal{A}_{2k}",
        "Chain(\\text{E}_{2k}, Mul(Pow(Neg(1); k), \\mathcal{A}_{2k}); =)",
        "sympy/sympy/sympy/functions/combinatorial/numbers.py",
    ),
    (
        "T & = \\frac12 I_O\\omega^2 = \\frac12 \\left[\\frac{1}{12}ml^2 + m\\left(\\frac l4\\right)^2\\right]\\omega^2 = \\frac{7}{96}ml^2\\omega^2",
        "Chain(T, Mul(Div(1; 2), I_O, Pow(\\omega; 2)), Mul(Div(1; 2), Add(Mul(Div(1; 12), m, Pow(l; 2)), Mul(m, Pow(Div(l; 4); 2))), Pow(\\omega; 2)), Mul(Div(7; 96), m, Pow(l; 2), Pow(\\omega; 2)); =, =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "B = \\frac{\\pi^2 D^4}{4^2} \\rho_{avg}",
        "Chain(B, Mul(Div(Mul(Pow(\\pi; 2), Pow(D; 4)); Pow(4; 2)), \\rho_{avg}); =)",
        "CalebBell/fluids/fluids/compressible.py",
    ),
    (
        "\\ddot{\\bm r}_{B/N} = [A]^{-1} (\\bm v_{\\text{trans}} - [B]\\dot{\\bm\\omega}_{\\cal B/N})",
        "Chain(Call(\\ddot{\\bm{r}}_{B/N}), Mul(Pow([ A ]; Neg(1)), Add(\\bm{v}_{trans}, Neg(Mul([ B ], Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N }))))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/NHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "S = \\frac12 m(\\ddot{x}^2+\\ddot{y}^2) + \\frac12 (I_1\\ddot{\\theta}^2 + I_2\\ddot{\\phi}^2)",
        "Chain(S, Add(Mul(Div(1; 2), m, Add(Pow(Call(\\ddot{x}); 2), Pow(Call(\\ddot{y}); 2))), Mul(Div(1; 2), Add(Mul(I_1, Pow(Call(\\ddot{\\theta}); 2)), Mul(I_2, Pow(Call(\\ddot{\\phi}); 2))))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "\\operatorname{Si}(z) = z {}_1F_2(\\tfrac{1}{2}; \\tfrac{3}{2}, \\tfrac{3}{2}; -\\tfrac{z^2}{4})",
        "Chain(Call(\\text{Si}; z), Mul(z, Call(\\prescript { } { 1 } { F } _ { 2 }; Given(Div(1; 2); Given(Div(3; 2), Div(3; 2); Neg(Div(Pow(z; 2); 4)); ;); ;))); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "\\begin{aligned} p(\\mathbf{p}_1, \\ldots, \\mathbf{p}_N \\ | \\ \\mathcal{Z}) &= \\frac{p( \\mathcal{Z} \\ | \\ \\mathbf{p}_1, \\ldots, \\mathbf{p}_N) p(\\mathbf{p}_1, \\ldots, \\mathbf{p}_N) }{ p(\\mathcal{Z}) } \\\\ &\\propto p( \\mathcal{Z} \\ | \\ \\mathbf{p}_1, \\ldots, \\mathbf{p}_N) \\end{aligned}",
        "Chain(Call(p; Given(\\mathbf{p}_1, Dots(), \\mathbf{p}_N; \\mathcal{Z}; |)), Div(Mul(Call(p; Given(\\mathcal{Z}; \\mathbf{p}_1, Dots(), \\mathbf{p}_N; |)), Call(p; \\mathbf{p}_1, Dots(), \\mathbf{p}_N)); Call(p; \\mathcal{Z})), Call(p; Given(\\mathcal{Z}; \\mathbf{p}_1, Dots(), \\mathbf{p}_N; |)); =, \\propto)",
        "AtsushiSakai/PythonRobotics/docs/modules/4_slam/graph_slam/graphSLAM_formulation.rst",
    ),
    (
        "\\mu_m = \\rho_m \\left[x\\left(\\frac{\\mu_g}{\\rho_g}\\right) + (1 - x)\\left(\\frac{\\mu_l}{\\rho_l}\\right)\\right]",
        "Chain(\\mu_m, Mul(\\rho_m, Add(Mul(x, Div(\\mu_g; \\rho_g)), Mul(Add(1, Neg(x)), Div(\\mu_l; \\rho_l)))); =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "\\lambda(x) = c_0 + c_1 x + c_2 x^2.",
        "Chain(Call(\\lambda; x), Add(c_0, Mul(c_1, x), Mul(c_2, Pow(x; 2))); =)",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "J(x,u)=\\int_0^Tg(x(t),u(t))dt\\ge V(x_0)-V(x(T)).",
        "Chain(Call(J; Call(x), Call(u)), Integral(Call(g; Call(x; t), Call(u; t)); t; 0; T), Add(Call(V; x_0), Neg(Call(V; Call(x; T)))); =, \\ge)",
        "RussTedrake/underactuated/book/dp.html",
    ),
    (
        "v2 = p3 - p1",
        "Chain(\\text{v2}, Add(\\text{p3}, Neg(\\text{p1})); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/3_mapping/normal_vector_estimation/normal_vector_estimation_main.rst",
    ),
    (
        "S[\\boldsymbol{q}(t),\\boldsymbol{p}(t)] = \\int_{t_0}^{t_1} \\left[\\sum_{\\alpha=1}^s p_\\alpha \\dot{q}_\\alpha - H(\\boldsymbol{q},\\boldsymbol{p},t)\\right] \\mathrm{d} t",
        "Chain(Indexed(S; Call(\\boldsymbol{q}; t), Call(\\boldsymbol{p}; t)), Integral(Add(BigSum(\\alpha; 1; s; Mul(p_{\\alpha}, Call(\\dot{q}_{\\alpha}))), Neg(Call(H; Call(\\boldsymbol{q}), Call(\\boldsymbol{p}), t))); t; t_0; t_1); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter9.tex",
    ),
    (
        "C_0 = 1.19",
        "Chain(C_0, 1.19; =)",
        "CalebBell/fluids/fluids/two_phase_voidage.py",
    ),
    (
        "\\tilde{F}_r + \\tilde{F}_r^* = \\bar{f}_{ds}(\\dot{\\bar{u}}, \\bar{u}, \\bar{q}, t) + \\mathbf{A}_n^T \\bar{f}_{dr}(\\dot{\\bar{u}}, \\bar{u}, \\bar{q}, t) = 0 \\in \\mathbb{R}^p",
        "Chain(Add(\\tilde{F}_r, \\tilde { F } _ { r } ^ { * }), Add(Call(\\bar{f}_{ds}; Call(\\dot{\\bar{u}}), Call(\\bar{u}), \\bar{q}, t), Mul(Transpose(\\mathbf{A}_n), Call(\\bar{f}_{dr}; Call(\\dot{\\bar{u}}), Call(\\bar{u}), \\bar{q}, t))), 0, Pow(\\mathbb{R}; p); =, =, \\in)",
        "moorepants/learn-multibody-dynamics/nonholonomic-eom.rst",
    ),
    (
        "\\text{SNR} = \\frac{1}{N-\\frac{1}{5}}.",
        "Chain(\\text{SNR}, Div(1; Add(N, Neg(Div(1; 5)))); =)",
        "RussTedrake/underactuated/book/rl_policy_search.html",
    ),
    (
        "{\\vec{x}}' = \\begin{bmatrix} 2 & 1 & 1 \\\\ 1 & 2 & 0 \\\\ 0 & 0 & 2 \\end{bmatrix} \\vec{x} .",
        "Chain(\\vec{x}', Mul(MatrixOf(2, 1, 1, 1, 2, 0, 0, 0, 2), \\vec{x}); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\breve{U} := \\hat{a}_x \\otimes \\hat{a}_x + \\hat{a}_y \\otimes \\hat{a}_y + \\hat{a}_z \\otimes \\hat{a}_z",
        "Chain(\\breve{U}, Add(Operated(\\otimes; \\hat{a}_x; \\hat{a}_x), Operated(\\otimes; \\hat{a}_y; \\hat{a}_y), Operated(\\otimes; \\hat{a}_z; \\hat{a}_z)); =)",
        "moorepants/learn-multibody-dynamics/mass.rst",
    ),
    (
        "L = b - a",
        "Chain(L, Add(b, Neg(a)); =)",
        "sympy/sympy/sympy/series/fourier.py",
    ),
    (
        "\\boxed{\\mathbf{q}_t = \\mathbf{q}_t^- + \\mathbf{G}_t (\\mathbf{q}_{am} - \\mathbf{q}_t^-)}",
        "Chain(\\mathbf{q}_t, Add(\\mathbf { q } _ { t } ^ { - }, Mul(\\mathbf{G}_t, Add(\\mathbf{q}_{am}, Neg(\\mathbf { q } _ { t } ^ { - })))); =)",
        "Mayitzin/ahrs/ahrs/filters/fkf.py",
    ),
    (
        "g_{n,j} &=& \\phi_{n+1,j}\\,\\left[g_{n+1,j} + \\tilde{U}_{n+1,j}\\,z_{n+1}\\right] \\\\ z_n &=& \\frac{z_n^\\prime}{D_{n,n}} - \\sum_{j=1}^{2\\,J} \\tilde{W}_{n,j}\\,g_{n,j}",
        "System(Chain(g_{n,j}, Mul(\\phi_{n+1,j}, Add(g_{n+1,j}, Mul(\\tilde{U}_{n+1,j}, z_{n+1}))); =), Chain(z_n, Add(Div(z_n'; D_{n,n}), Neg(BigSum(j; 1; Mul(2, J); Mul(\\tilde{W}_{n,j}, g_{n,j})))); =))",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\ddot{\\bm r} = - \\frac{\\mu}{r^{3}}{\\bm r}",
        "Chain(Call(\\ddot{\\bm{r}}), Neg(Mul(Div(\\mu; Pow(Call(r); 3)), Call(\\bm{r}))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/Integrators/_Documentation/secTest.tex",
    ),
    (
        "F_s=V_s\\rho_g^{0.5}",
        "Chain(F_s, Mul(V_s, Pow(\\rho_g; 0.5)); =)",
        "CalebBell/fluids/fluids/packed_tower.py",
    ),
    (
        "r_p = a\\left(1 - e\\right)",
        "Chain(r_p, Mul(a, Add(1, Neg(e))); =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/elliptical-orbits.md",
    ),
    (
        "Tr\\cos \\left(\\frac{\\pi}{2}-\\phi-\\theta\\right) = Qa",
        "Chain(Mul(T, r, Call(cos; Add(Div(\\pi; 2), Neg(\\phi), Neg(\\theta)))), Mul(Q, a); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise2.tex",
    ),
    (
        "m \\begin{bmatrix}\\ddot{x} \\\\ \\ddot{z} \\end{bmatrix} + K_d \\begin{bmatrix} \\dot{x} \\\\ \\dot{z} \\end{bmatrix} + K_p \\begin{bmatrix} x - x_d \\\\ z - z_d \\end{bmatrix} = f^{F_c}.",
        "Chain(Add(Mul(m, MatrixOf(Call(\\ddot{x}), Call(\\ddot{z}))), Mul(K_d, MatrixOf(Call(\\dot{x}), Call(\\dot{z}))), Mul(K_p, MatrixOf(Add(Call(x), Neg(x_d)), Add(Call(z), Neg(z_d))))), f ^ { F _ { c } }; =)",
        "RussTedrake/manipulation/book/force.html",
    ),
    (
        "\\begin{bmatrix} x_{cm} \\\\ z_{cm} \\end{bmatrix} \\equiv {}^Wp^{R_{cm}}({\\bf q}) = \\frac{\\sum_i {}^W p^{B_{i,cm}}({\\bf q}) \\, m_i}{\\sum_i m_i} = \\frac{\\sum_i {}^WX^{B_i}({\\bf q}) \\,{}^B_i p^{B_{i,cm}} \\, m_i}{\\sum_i m_i}.",
        "Chain(MatrixOf(x_{cm}, z_{cm}), Call(\\prescript { W } { } { p } ^ { R _ { c m } }; \\mathbf{q}), Div(BigSum(i; Mul(Call(\\prescript { W } { } { p } ^ { B _ { i , c m } }; \\mathbf{q}), m_i)); BigSum(i; m_i)), Div(BigSum(i; Mul(Call(\\prescript { W } { } { X } ^ { B _ { i } }; \\mathbf{q}), \\prescript { B } { i } { p } ^ { B _ { i , c m } }, m_i)); BigSum(i; m_i)); \\equiv, =, =)",
        "RussTedrake/underactuated/book/humanoids.html",
    ),
    (
        "\\begin{aligned} \\sigma^2 &= \\frac{\\bar\\sigma^2 \\sigma_z^2 } {\\bar\\sigma^2 + \\sigma_z^2} \\\\ &= K\\sigma_z^2 \\\\ &= (1-K)\\bar\\sigma^2 \\end{aligned}",
        "Chain(Pow(\\sigma; 2), Div(Mul(Pow(\\bar{\\sigma}; 2), Pow(\\sigma_z; 2)); Add(Pow(\\bar{\\sigma}; 2), Pow(\\sigma_z; 2))), Mul(K, Pow(\\sigma_z; 2)), Mul(Add(1, Neg(K)), Pow(\\bar{\\sigma}; 2)); =, =, =)",
        "AtsushiSakai/PythonRobotics/docs/modules/12_appendix/Kalmanfilter_basics_2_main.rst",
    ),
    (
        "\\rho = [HN](r_{dep} - r_{chief})",
        "Chain(\\rho, Mul([ H N ], Add(r_{dep}, Neg(r_{chief}))); =)",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/hillStateConverter/hillStateConverter.rst",
    ),
    (
        "\\begin{array}{rcl} e^{\\mathbf{q}} &=& e^{q_w+\\mathbf{q}_v} = e^{q_w}e^{\\mathbf{q}_v}\\\\ &=& e^{q_w} \\begin{bmatrix} \\cos\\|\\mathbf{q}_v\\| \\\\ \\frac{\\mathbf{q}}{\\|\\mathbf{q}_v\\|}\\sin\\|\\mathbf{q}_v\\| \\end{bmatrix} \\end{array}",
        "Chain(Pow(e; \\mathbf{q}), Pow(e; Add(q_w, \\mathbf{q}_v)), Mul(Pow(e; q_w), Pow(e; \\mathbf{q}_v)), Mul(Pow(e; q_w), MatrixOf(Call(cos; Norm(\\mathbf{q}_v)), Mul(Div(\\mathbf{q}; Norm(\\mathbf{q}_v)), Call(sin; Norm(\\mathbf{q}_v))))); =, =, =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "\\begin{array}{llr} \\frac{dP^{0, 0}}{dx} & = 1 & \\\\ \\frac{dP^{n, n}}{dx} & = \\sin (x) \\frac{dP^{n-1, n-1}}{dx} + \\cos (x) P^{n-1, n-1} & n\\geq 1 \\\\ \\frac{dP^{n, m}}{dx} & = \\cos (x) \\frac{dP^{n-1, m}}{dx} - \\sin (x) P^{n-1, m} - K^{n, m} \\frac{dP^{n-2, m}}{dx} & \\end{array}",
        "System(Chain(Derivative(Call(P ^ { 0 , 0 }); x, 1), 1; =), Chain(Derivative(Call(P ^ { n , n }); x, 1), Add(Mul(Call(sin; x), Derivative(Call(P ^ { n - 1 , n - 1 }); x, 1)), Mul(Call(cos; x), Call(P ^ { n - 1 , n - 1 }))); =), Chain(n, 1; \\ge), Chain(Derivative(Call(P ^ { n , m }); x, 1), Add(Mul(Call(cos; x), Derivative(Call(P ^ { n - 1 , m }); x, 1)), Neg(Mul(Call(sin; x), Call(P ^ { n - 1 , m }))), Neg(Mul(K ^ { n , m }, Derivative(Call(P ^ { n - 2 , m }); x, 1)))); =))",
        "Mayitzin/ahrs/ahrs/utils/wmm.py",
    ),
    (
        "\\tilde{F}_r = F_r + \\left[F_{p+1} \\ldots F_n \\right] \\mathbf{A}_n \\hat{e}_r \\textrm{ for } r=1\\ldots p",
        "System(Chain(\\tilde{F}_r, Add(F_r, Mul(Tuple(F_{p+1}, Dots(), F_n; []), \\mathbf{A}_n, \\hat{e}_r)); =), Values(r; 1, Dots(), p))",
        "moorepants/learn-multibody-dynamics/generalized-forces.rst",
    ),
    (
        "\\int_{-\\infty}^\\infty p_x(x ;n) dx = 1.",
        "Chain(Integral(Call(p_x; Given(x; n; ;)); x; Neg(Infinity()); Infinity()), 1; =)",
        "RussTedrake/underactuated/book/stochastic.html",
    ),
    (
        "{}^Gp^A = {}^GX^F {}^Fp^A = {}^Gp^F + {}^Fp^A_G = {}^Gp^F + {}^GR^F {}^Fp^A.",
        "Chain(\\prescript { G } { } { p } ^ { A }, Mul(\\prescript { G } { } { X } ^ { F }, \\prescript { F } { } { p } ^ { A }), Add(\\prescript { G } { } { p } ^ { F }, \\prescript { F } { } { p } _ { G } ^ { A }), Add(\\prescript { G } { } { p } ^ { F }, Mul(\\prescript { G } { } { R } ^ { F }, \\prescript { F } { } { p } ^ { A })); =, =, =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "x = x' + \\frac{b_2 c_1 - b_1 c_2}{a_2 b_1 - a_1 b_2}",
        "Chain(x, Add(x', Div(Add(Mul(b_2, c_1), Neg(Mul(b_1, c_2))); Add(Mul(a_2, b_1), Neg(Mul(a_1, b_2))))); =)",
        "sympy/sympy/sympy/solvers/ode/single.py",
    ),
    (
        "W = zRT\\ln\\left(\\frac{P_2}{P_1}\\right)",
        "Chain(W, Mul(z, R, T, Call(ln; Div(P_2; P_1))); =)",
        "CalebBell/fluids/fluids/compressible.py",
    ),
    (
        "\\textbf{u}_t=[v_t, \\omega_t]",
        "Chain(\\mathbf{u}_t, Tuple(v_t, \\omega_t; []); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/2_localization/extended_kalman_filter_localization_files/extended_kalman_filter_localization_main.rst",
    ),
    (
        "\\operatorname{Li}_{s+1}(z) = \\int_0^z \\frac{\\operatorname{Li}_s(t)}{t} \\mathrm{d}t.",
        "Chain(Call(\\text{Li}_{s+1}; z), Integral(Div(Call(\\text{Li}_s; t); t); t; 0; z); =)",
        "sympy/sympy/sympy/functions/special/zeta_functions.py",
    ),
    (
        "\\Delta\\left(\\frac{a\\tau+b}{c\\tau+d}\\right) = (c\\tau+d)^{12} \\Delta(\\tau).",
        "Chain(Call(\\Delta; Div(Add(Mul(a, \\tau), b); Add(Mul(c, \\tau), d))), Mul(Pow(Add(Mul(c, \\tau), d); 12), Call(\\Delta; \\tau)); =)",
        "fredrik-johansson/arb/doc/source/acb_modular.rst",
    ),
    (
        "{\\bf A}{\\bf v}_i = \\lambda_i {\\bf v}_i,",
        "Chain(Mul(\\mathbf{A}, \\mathbf{v}_i), Mul(\\lambda_i, \\mathbf{v}_i); =)",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\mathbf{T}^T\\left[\\mathbf{M}\\mathbf{T}\\dot{\\bar{u}} + \\left(\\dot{\\mathbf{M}}\\mathbf{T} + \\mathbf{M}\\dot{\\mathbf{T}}\\right)\\bar{u}\\right] = \\mathbf{T}^T \\bar{F} \\in \\mathbb{R}^{n}",
        "Chain(Mul(Transpose(Call(\\mathbf{T})), Add(Mul(Call(\\mathbf{M}), Call(\\mathbf{T}), Call(\\dot{\\bar{u}})), Mul(Add(Mul(Call(\\dot{\\mathbf{M}}), Call(\\mathbf{T})), Mul(Call(\\mathbf{M}), Call(\\dot{\\mathbf{T}}))), Call(\\bar{u})))), Mul(Transpose(Call(\\mathbf{T})), \\bar{F}), Pow(\\mathbb{R}; n); =, \\in)",
        "moorepants/learn-multibody-dynamics/tmt.rst",
    ),
    (
        "\\begin{aligned} r_A &= \\frac{p_t}{1 + e_t\\cos\\nu_A} & r_B &= \\frac{p_t}{1 + e_t\\cos\\nu_B} \\end{aligned}",
        "System(Chain(r_A, Div(p_t; Add(1, Mul(e_t, Call(cos; \\nu_A)))); =), Chain(r_B, Div(p_t; Add(1, Mul(e_t, Call(cos; \\nu_B)))); =))",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/non-hohmann-transfers.md",
    ),
    (
        "\\hat{n}_x \\times \\hat{n}_y & = \\hat{n}_z \\\\ \\hat{n}_y \\times \\hat{n}_z & = \\hat{n}_x \\\\ \\hat{n}_z \\times \\hat{n}_x & = \\hat{n}_y",
        "System(Chain(Cross(\\hat{n}_x; \\hat{n}_y), \\hat{n}_z; =), Chain(Cross(\\hat{n}_y; \\hat{n}_z), \\hat{n}_x; =), Chain(Cross(\\hat{n}_z; \\hat{n}_x), \\hat{n}_y; =))",
        "moorepants/learn-multibody-dynamics/orientation.rst",
    ),
    (
        "\\hat{h}_r = \\frac{r}{|r|}",
        "Chain(\\hat{h}_r, Div(r; Bars(r)); =)",
        "AVSLab/basilisk/src/fswAlgorithms/formationFlying/hillStateConverter/hillStateConverter.rst",
    ),
    (
        "\\bm \\sigma_{\\text{ch}}(t_\\text{s}) = - \\frac{\\bm \\sigma_0(t_\\text{s})}{\\vert \\bm \\sigma_0(t_\\text{s}) \\vert^2}",
        "Chain(Call(\\bm{\\sigma}_{ch}; t_s), Neg(Div(Call(\\bm{\\sigma}_0; t_s); Pow(Bars(Call(\\bm{\\sigma}_0; t_s)); 2))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/spacecraft/_Documentation/Spacecraft/secTest.tex",
    ),
    (
        "f(E) = E - e\\sin E - M_e",
        "Chain(Call(f; E), Add(E, Neg(Mul(e, Call(sin; E))), Neg(M_e)); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "x(T)=a_0+a_1T+a_2T^2+a_3T^3+a_4T^4+a_5T^5=x_e",
        "Chain(Call(x; T), Add(a_0, Mul(a_1, T), Mul(a_2, Pow(T; 2)), Mul(a_3, Pow(T; 3)), Mul(a_4, Pow(T; 4)), Mul(a_5, Pow(T; 5))), x_e; =, =)",
        "AtsushiSakai/PythonRobotics/docs/modules/5_path_planning/quintic_polynomials_planner/quintic_polynomials_planner_main.rst",
    ),
    (
        "\\operatorname{Li}_s(z) = \\frac{\\Gamma(v)}{(2\\pi)^v} \\left[ i^v \\zeta \\left(v, \\frac{1}{2} + \\frac{\\log(-z)}{2\\pi i}\\right) + i^{-v} \\zeta \\left(v, \\frac{1}{2} - \\frac{\\log(-z)}{2\\pi i}\\right) \\right]",
        "Chain(Call(\\text{Li}_s; z), Mul(Div(Call(Gamma; v); Pow(Mul(2, \\pi); v)), Add(Mul(Pow(i; v), Call(\\zeta; v, Add(Div(1; 2), Div(Call(log; Neg(z)); Mul(2, \\pi, i))))), Mul(Pow(i; Neg(v)), Call(\\zeta; v, Add(Div(1; 2), Neg(Div(Call(log; Neg(z)); Mul(2, \\pi, i)))))))); =)",
        "fredrik-johansson/arb/doc/source/polylogarithms.rst",
    ),
    (
        "L(\\mathbf{A}) = \\frac{1}{2}\\sum_{i=1}^Nw_i|u_i-\\mathbf{A}v_i|^2",
        "Chain(Call(L; \\mathbf{A}), Mul(Div(1; 2), BigSum(i; 1; N; Mul(w_i, Pow(Bars(Add(u_i, Neg(Mul(\\mathbf{A}, v_i)))); 2)))); =)",
        "Mayitzin/ahrs/ahrs/filters/davenport.py",
    ),
    (
        "u_{\\min} = \\frac{km+\\sqrt{k^2m^2-2mE(l^2+cm)}}{l^2+cm}",
        "Chain(u_\\min, Div(Add(Mul(k, m), Sqrt(Add(Mul(Pow(k; 2), Pow(m; 2)), Neg(Mul(2, m, E, Add(Pow(l; 2), Mul(c, m))))))); Add(Pow(l; 2), Mul(c, m))); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/exercise.tex",
    ),
    (
        "\\mathbf{q}^{-1} = \\mathbf{q}^*",
        "Chain(Pow(\\mathbf{q}; Neg(1)), \\mathbf { q } ^ { * }; =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "{}^{B}{\\pmb\\omega}_{{\\mathcal{B}}^{\\ast}/\\mathcal{R}} = - {\\bf f}(\\pmb\\sigma_{\\mathcal{B}/\\mathcal{R}})",
        "Chain(\\prescript { B } { } { \\pmb { \\omega } } _ { \\mathcal { B } ^ { * } / \\mathcal { R } }, Neg(Call(\\mathbf{f}; \\pmb{\\sigma}_{\\mathcal B/\\mathcal R})); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attControl/mrpSteering/mrpSteering.rst",
    ),
    (
        "y = C_1 y_0(t) + C_2 [\\frac{F(t) P(t)}{x_0(t)} + y_0(t) \\int \\frac{g(t) F(t) P(t)}{x_0^{2}(t)} \\,dt]",
        "Chain(y, Add(Mul(C_1, Call(y_0; t)), Mul(C_2, Add(Div(Mul(Call(F; t), Call(P; t)); Call(x_0; t)), Mul(Call(y_0; t), Antiderivative(Div(Mul(Call(g; t), Call(F; t), Call(P; t)); Pow(Call(x_0; t); 2)); t))))); =)",
        "sympy/sympy/sympy/solvers/ode/ode.py",
    ),
    (
        "\\rho(t) = b (t - t_f)^2 + \\rho_{\\text{ref}}",
        "Chain(Call(\\rho; t), Add(Mul(b, Pow(Add(t, Neg(t_f)); 2)), \\rho_{ref}); =)",
        "AVSLab/basilisk/src/simulation/deviceInterface/prescribedLinearTranslation/prescribedLinearTranslation.rst",
    ),
    (
        "L = I + \\mathrm{tril} (U\\,W^T)",
        "Chain(L, Add(I, Call(\\text{tril}; Mul(U, Transpose(W)))); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "{}_I\\mbox{\\boldmath $\\omega$}_{I\\!B} = \\mathbf E(\\mbox{\\boldmath $\\chi$}) \\cdot \\dot{\\mbox{\\boldmath $\\chi$}}",
        "Chain(\\prescript { } { I } { \\boldsymbol { \\omega } } _ { I \\! B }, Mul(Call(\\mathbf{E}; Call(\\boldsymbol{\\chi})), Call(\\dot{\\boldsymbol{\\chi}}); 1); =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "& J_p(x) = \\frac{1}{2^p\\Gamma(1+p)} y_1 = \\sum_{k=0}^\\infty \\frac{{(-1)}^k}{k! \\, \\Gamma(k+p+1)} {\\left(\\frac{x}{2}\\right)}^{2k+p} , \\\\ & J_{-p}(x) = \\frac{1}{2^{-p}\\Gamma(1-p)} y_2 = \\sum_{k=0}^\\infty \\frac{{(-1)}^k}{k! \\,\\Gamma(k-p+1)} {\\left(\\frac{x}{2}\\right)}^{2k-p} .",
        "System(Chain(Call(J_p; x), Mul(Div(1; Mul(Pow(2; p), Call(Gamma; Add(1, p)))), y_1), BigSum(k; 0; Infinity(); Mul(Div(Pow(Neg(1); k); Mul(Factorial(k), Call(Gamma; Add(k, p, 1)))), Pow(Div(x; 2); Add(Mul(2, k), p)))); =, =), Chain(Call(J_{-p}; x), Mul(Div(1; Mul(Pow(2; Neg(p)), Call(Gamma; Add(1, Neg(p))))), y_2), BigSum(k; 0; Infinity(); Mul(Div(Pow(Neg(1); k); Mul(Factorial(k), Call(Gamma; Add(k, Neg(p), 1)))), Pow(Div(x; 2); Add(Mul(2, k), Neg(p))))); =, =))",
        "jirilebl/diffyqs/ch-power-ser.tex",
    ),
    (
        "\\mathscr{J}_\\alpha = \\int_{t_0}^{t_0+\\tau} \\left(\\sum_{i=1}^n \\boldsymbol{F}_i \\cdot \\frac{\\partial \\boldsymbol{r}_i}{\\partial q_\\alpha}\\right)\\mathrm{d} t = \\int_{t_0}^{t_0+\\tau} Q_\\alpha\\mathrm{d} t",
        "Chain(\\mathscr{J}_\\alpha, Integral(BigSum(i; 1; n; Mul(\\boldsymbol{F}_i, Derivative(Call(\\boldsymbol{r}_i); q_\\alpha, 1; True))); t; t_0; Add(t_0, \\tau)), Integral(Q_\\alpha; t; t_0; Add(t_0, \\tau)); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "\\begin{aligned}\\left\\{r\\right\\}_{{x}_{\\omega}} &= \\left\\{\\begin{matrix}{x}_{\\omega}\\\\{y}_{\\omega}\\\\ 0\\end{matrix}\\right\\} = \\left[\\mathbf{Q}\\right]_{X{x}_{\\omega}} \\left\\{r\\right\\}_{X} & \\left\\{v\\right\\}_{{x}_{\\omega}} &= \\left\\{\\begin{matrix}\\dot{{x}_{\\omega}}\\\\\\dot{{y}_{\\omega}}\\\\ 0\\end{matrix}\\right\\} = \\left[\\mathbf{Q}\\right]_{X{x}_{\\omega}} \\left\\{v\\right\\}_{X}\\end{aligned}",
        "System(Chain(Marked(Tuple(r; {}); _{ x _ { \\omega } }), Tuple(MatrixOf(Call(x_\\omega), Call(y_\\omega), 0); {}), Mul([ \\mathbf { Q } ] _ { X x _ { \\omega } }, Marked(Tuple(r; {}); _{ X })); =, =), Chain(Marked(Tuple(v; {}); _{ x _ { \\omega } }), Tuple(MatrixOf(Call(\\dot{x}_\\omega), Call(\\dot{y}_\\omega), 0); {}), Mul([ \\mathbf { Q } ] _ { X x _ { \\omega } }, Marked(Tuple(v; {}); _{ X })); =, =))",
        "bryanwweber/orbital-mechanics-notes/chapter-4/6-transformation-between-geocentric-equatorial-and-perifocal-frames.md",
    ),
    (
        "J({\\bf x}_0) = \\int_0^\\infty \\left[ {\\bf x}^T(t) {\\bf Q} {\\bf x}(t) + {\\bf u}^T(t) {\\bf R} {\\bf u}(t) \\right]dt, \\quad {\\bf x}(0)={\\bf x}_0, {\\bf Q}={\\bf Q}^T>0, {\\bf R}={\\bf R}^T>0.",
        "System(Chain(Call(J; \\mathbf{x}_0), Integral(Add(Mul(Transpose(Call(\\mathbf{x}; t)), \\mathbf{Q}, Call(\\mathbf{x}; t)), Mul(Transpose(Call(\\mathbf{u}; t)), \\mathbf{R}, Call(\\mathbf{u}; t))); t; 0; Infinity()); =), Chain(Call(\\mathbf{x}; 0), \\mathbf{x}_0; =), Chain(\\mathbf{Q}, Transpose(\\mathbf{Q}), 0; =, >), Chain(\\mathbf{R}, Transpose(\\mathbf{R}), 0; =, >))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\mathbf{B} = \\sum_{i=1}^nw_i\\mathbf{A}(\\mathbf{q}_i)",
        "Chain(\\mathbf{B}, BigSum(i; 1; n; Mul(w_i, Call(\\mathbf{A}; \\mathbf{q}_i))); =)",
        "Mayitzin/ahrs/ahrs/common/quaternion.py",
    ),
    (
        "\\boldsymbol{e} = \\frac{\\dot{\\boldsymbol{r}}\\times\\boldsymbol{h}}{\\mu} - \\frac{\\boldsymbol{r}}{r}",
        "Chain(\\boldsymbol{e}, Add(Div(Cross(Call(\\dot{\\boldsymbol{r}}); \\boldsymbol{h}); \\mu), Neg(Div(Call(\\boldsymbol{r}); Call(r)))); =)",
        "bryanwweber/orbital-mechanics-notes/classical-orbital-elements/orbital-elements-and-the-state-vector.md",
    ),
    (
        "p^2 - \\omega_0^2 = {\\left( \\frac{c}{2m} \\right)}^2 - \\frac{k}{m} = \\frac{c^2 - 4km}{4m^2} .",
        "Chain(Add(Pow(p; 2), Neg(Pow(\\omega_0; 2))), Add(Pow(Div(c; Mul(2, m)); 2), Neg(Div(k; m))), Div(Add(Pow(c; 2), Neg(Mul(4, k, m))); Mul(4, Pow(m; 2))); =, =)",
        "jirilebl/diffyqs/ch-higher-order-ode.tex",
    ),
    (
        "x = \\xi e^s, \\qquad t = s .",
        "System(Chain(x, Mul(\\xi, Pow(e; s)); =), Chain(t, s; =))",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\boldsymbol{r}(t) = \\boldsymbol{r}(\\boldsymbol{q}(t),t)",
        "Chain(Call(\\boldsymbol{r}; t), Call(\\boldsymbol{r}; Call(\\boldsymbol{q}; t), t); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "{}^{\\mathbf{N}}\\boldsymbol{\\omega}^{\\mathbf{B}} = w_x \\mathbf{\\hat{b}_x} + w_y \\mathbf{\\hat{b}_y} + w_z \\mathbf{\\hat{b}_z}",
        "Chain(\\prescript { \\mathbf { N } } { } { \\boldsymbol { \\omega } } ^ { \\mathbf { B } }, Add(Mul(w_x, \\mathbf{\\hat{b}}_x), Mul(w_y, \\mathbf{\\hat{b}}_y), Mul(w_z, \\mathbf{\\hat{b}}_z)); =)",
        "sympy/sympy/doc/src/explanation/modules/physics/vector/kinematics/kinematics.rst",
    ),
    (
        "\\int\\frac{d\\nu}{\\left(1 + e\\cos \\nu\\right)^2} = \\frac{1}{\\left(e^2 - 1\\right)^{3/2}}\\left[\\frac{e\\sqrt{e^2 - 1}\\sin \\nu}{1 + e\\cos \\nu} - \\ln\\left(\\frac{\\sqrt{e + 1} + \\sqrt{e - 1}\\tan\\frac{\\nu}{2}}{\\sqrt{e + 1} - \\sqrt{e - 1}\\tan\\frac{\\nu}{2}}\\right)\\right]",
        "Chain(Antiderivative(Div(1; Pow(Add(1, Mul(e, Call(cos; \\nu))); 2)); \\nu), Mul(Div(1; Pow(Add(Pow(e; 2), Neg(1)); Div(3; 2))), Add(Div(Mul(e, Sqrt(Add(Pow(e; 2), Neg(1))), Call(sin; \\nu)); Add(1, Mul(e, Call(cos; \\nu)))), Neg(Call(ln; Div(Add(Sqrt(Add(e, 1)), Mul(Sqrt(Add(e, Neg(1))), Call(tan; Div(\\nu; 2)))); Add(Sqrt(Add(e, 1)), Neg(Mul(Sqrt(Add(e, Neg(1))), Call(tan; Div(\\nu; 2)))))))))); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/hyperbolic-trajectories.md",
    ),
    (
        "x_1'' + \\lambda_1 x_1 = 0 \\qquad \\text{and} \\qquad x_2'' + \\lambda_2 x_2 = 0.",
        "System(Chain(Add(x_1'', Mul(\\lambda_1, x_1)), 0; =), Chain(Add(x_2'', Mul(\\lambda_2, x_2)), 0; =))",
        "jirilebl/diffyqs/ch-fourier-and-pde.tex",
    ),
    (
        "u(t) = \\begin{cases} 0 & \\text{if } \\; t < 0 , \\\\ 1 & \\text{if } \\; t \\geq 0 . \\end{cases}",
        "Chain(Call(u; t), Piecewise(0, Chain(t, 0; <), 1, Chain(t, 0; \\ge)); =)",
        "jirilebl/diffyqs/ch-laplace.tex",
    ),
    (
        "\\sin\\dfrac q2 = k_1\\sin u",
        "Chain(Call(sin; Div(q; 2)), Mul(k_1, Call(sin; u)); =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\begin{array}{rcl} h(\\hat{\\mathbf{x}}) &=& \\mathbf{R}(\\hat{\\mathbf{x}})^T \\mathbf{g} \\\\ &=& \\begin{bmatrix} 1 - 2(\\hat{q_y}^2 + \\hat{q_z}^2) & 2(\\hat{q_x} \\hat{q_y} + \\hat{q_w} \\hat{q_z}) & 2(\\hat{q_x} \\hat{q_z} - \\hat{q_w} \\hat{q_y}) \\\\ 2(\\hat{q_x} \\hat{q_y} - \\hat{q_w} \\hat{q_z}) & 1 - 2(\\hat{q_x}^2 + \\hat{q_z}^2) & 2(\\hat{q_y} \\hat{q_z} + \\hat{q_w} \\hat{q_x}) \\\\ 2(\\hat{q_x} \\hat{q_z} + \\hat{q_w} \\hat{q_y}) & 2(\\hat{q_y} \\hat{q_z} - \\hat{q_w} \\hat{q_x}) & 1 - 2(\\hat{q_x}^2 + \\hat{q_y}^2) \\end{bmatrix} \\begin{bmatrix} 0 \\\\ 0 \\\\ 1 \\end{bmatrix} \\\\ &=& \\begin{bmatrix} 2(\\hat{q_x} \\hat{q_z} - \\hat{q_w} \\hat{q_y}) \\\\ 2(\\hat{q_y} \\hat{q_z} + \\hat{q_w} \\hat{q_x}) \\\\ 1 - 2(\\hat{q_x}^2 + \\hat{q_y}^2) \\end{bmatrix} \\end{array}",
        "Chain(Call(h; \\hat{\\mathbf{x}}), Mul(Transpose(Call(\\mathbf{R}; \\hat{\\mathbf{x}})), \\mathbf{g}), Mul(MatrixOf(Add(1, Neg(Mul(2, Add(Pow(\\hat{q}_y; 2), Pow(\\hat{q}_z; 2))))), Mul(2, Add(Mul(\\hat{q}_x, \\hat{q}_y), Mul(\\hat{q}_w, \\hat{q}_z))), Mul(2, Add(Mul(\\hat{q}_x, \\hat{q}_z), Neg(Mul(\\hat{q}_w, \\hat{q}_y)))), Mul(2, Add(Mul(\\hat{q}_x, \\hat{q}_y), Neg(Mul(\\hat{q}_w, \\hat{q}_z)))), Add(1, Neg(Mul(2, Add(Pow(\\hat{q}_x; 2), Pow(\\hat{q}_z; 2))))), Mul(2, Add(Mul(\\hat{q}_y, \\hat{q}_z), Mul(\\hat{q}_w, \\hat{q}_x))), Mul(2, Add(Mul(\\hat{q}_x, \\hat{q}_z), Mul(\\hat{q}_w, \\hat{q}_y))), Mul(2, Add(Mul(\\hat{q}_y, \\hat{q}_z), Neg(Mul(\\hat{q}_w, \\hat{q}_x)))), Add(1, Neg(Mul(2, Add(Pow(\\hat{q}_x; 2), Pow(\\hat{q}_y; 2)))))), MatrixOf(0, 0, 1)), MatrixOf(Mul(2, Add(Mul(\\hat{q}_x, \\hat{q}_z), Neg(Mul(\\hat{q}_w, \\hat{q}_y)))), Mul(2, Add(Mul(\\hat{q}_y, \\hat{q}_z), Mul(\\hat{q}_w, \\hat{q}_x))), Add(1, Neg(Mul(2, Add(Pow(\\hat{q}_x; 2), Pow(\\hat{q}_y; 2)))))); =, =, =)",
        "Mayitzin/ahrs/ahrs/filters/ukf.py",
    ),
    (
        "-{}^A\\text{v}^B_F = {}^B\\text{v}^A_F + {}^A\\omega^B_F \\times {}^Bp^A_F.",
        "Chain(Neg(\\prescript { A } { } { \\text { v } } _ { F } ^ { B }), Add(\\prescript { B } { } { \\text { v } } _ { F } ^ { A }, Cross(\\prescript { A } { } { \\omega } _ { F } ^ { B }; \\prescript { B } { } { p } _ { F } ^ { A })); =)",
        "RussTedrake/manipulation/book/pick.html",
    ),
    (
        "x_1' + 5x_1 - 3x_2 &= e^t , \\\\ x_2' + 3x_1 - x_2 &= 0 ,",
        "System(Chain(Add(x_1', Mul(5, x_1), Neg(Mul(3, x_2))), Pow(e; t); =), Chain(Add(x_2', Mul(3, x_1), Neg(x_2)), 0; =))",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\bm\\omega_{B/R} = \\bm\\omega_{B/N} - \\bm\\omega_{R/N}",
        "Chain(\\bm{\\omega}_{B/R}, Add(\\bm{\\omega}_{B/N}, Neg(\\bm{\\omega}_{R/N})); =)",
        "AVSLab/basilisk/src/fswAlgorithms/attGuidance/opNavPoint/_Documentation/secModelDescription.tex",
    ),
    (
        "\\tan \\phi = \\frac{v_r}{v_{\\perp}} = \\frac{e\\sin\\nu}{1 + e\\cos\\nu}",
        "Chain(Call(tan; \\phi), Div(v_r; v_\\perp), Div(Mul(e, Call(sin; \\nu)); Add(1, Mul(e, Call(cos; \\nu)))); =, =)",
        "bryanwweber/orbital-mechanics-notes/the-orbit-equation/orbital-nomenclature.md",
    ),
    (
        "h = r v_{\\perp}",
        "Chain(h, Mul(r, v_\\perp); =)",
        "bryanwweber/orbital-mechanics-notes/constants-of-orbital-motion/orbital-plane-and-keplers-second-law.md",
    ),
    (
        "{ {\\boldsymbol{y}}} = K\\,{ {\\boldsymbol{z}}}",
        "Chain(\\boldsymbol{y}, Mul(K, \\boldsymbol{z}); =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\mathbf{M}_N^B(\\mathbf{q}) = \\begin{bmatrix} 2(s^2 + v_x^2) - 1 & 2(v_xv_y + sv_z) & 2(v_xv_z - sv_y) \\\\ 2(v_xv_y - sv_z) & 2(s^2 + v_y^2) - 1 & 2(sv_x + v_yv_z) \\\\ 2(sv_y + v_xv_z) & 2(v_yv_z - sv_x) & 2(s^2 + v_z^2) - 1 \\end{bmatrix}",
        "Chain(Call(\\mathbf { M } _ { N } ^ { B }; \\mathbf{q}), MatrixOf(Add(Mul(2, Add(Pow(s; 2), Pow(v_x; 2))), Neg(1)), Mul(2, Add(Mul(v_x, v_y), Mul(s, v_z))), Mul(2, Add(Mul(v_x, v_z), Neg(Mul(s, v_y)))), Mul(2, Add(Mul(v_x, v_y), Neg(Mul(s, v_z)))), Add(Mul(2, Add(Pow(s; 2), Pow(v_y; 2))), Neg(1)), Mul(2, Add(Mul(s, v_x), Mul(v_y, v_z))), Mul(2, Add(Mul(s, v_y), Mul(v_x, v_z))), Mul(2, Add(Mul(v_y, v_z), Neg(Mul(s, v_x)))), Add(Mul(2, Add(Pow(s; 2), Pow(v_z; 2))), Neg(1))); =)",
        "Mayitzin/ahrs/ahrs/filters/fourati.py",
    ),
    (
        "\\begin{cases} \\displaystyle p_\\alpha = \\frac{\\partial F_1}{\\partial q_\\alpha} = \\bar{p}_\\alpha(\\boldsymbol{q},\\boldsymbol{Q},t) \\\\[1.5ex] \\displaystyle P_\\alpha = -\\frac{\\partial F_1}{\\partial Q_\\alpha} = \\bar{P}_\\alpha(\\boldsymbol{q},\\boldsymbol{Q},t) \\\\[1.5ex] \\displaystyle K = H+\\frac{\\partial F_1}{\\partial t} \\end{cases}",
        "System(Chain(p_\\alpha, Derivative(Call(F_1); q_\\alpha, 1; True), Call(\\bar{p}_\\alpha; \\boldsymbol{q}, \\boldsymbol{Q}, t); =, =), Chain(P_\\alpha, Neg(Derivative(Call(F_1); Q_\\alpha, 1; True)), Call(\\bar{P}_\\alpha; \\boldsymbol{q}, \\boldsymbol{Q}, t); =, =), Chain(K, Add(H, Derivative(Call(F_1); t, 1; True)); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "(\\boldsymbol{v}_{O_k}^+-\\boldsymbol{v}_{O_k}^-) \\cdot \\boldsymbol{n}_k & = \\Delta\\boldsymbol{v}_k \\cdot \\boldsymbol{n}_k + (\\Delta\\boldsymbol{\\omega}_k\\times \\overrightarrow{C_kO_k})\\cdot \\boldsymbol{n}_k \\\\ & = \\Delta\\boldsymbol{v}_k \\cdot \\boldsymbol{n}_k + (\\overrightarrow{C_kO_k} \\times \\boldsymbol{n}_k)\\cdot \\Delta\\boldsymbol{\\omega}_k",
        "Chain(Mul(Add(\\boldsymbol { v } _ { O _ { k } } ^ { + }, Neg(\\boldsymbol { v } _ { O _ { k } } ^ { - })), \\boldsymbol{n}_k; 1), Add(Mul(\\Delta \\boldsymbol { v } _ { k }, \\boldsymbol{n}_k; 1), Mul(Cross(\\Delta \\boldsymbol { \\omega } _ { k }; \\vec { C _ { k } O _ { k } }), \\boldsymbol{n}_k; 1)), Add(Mul(\\Delta \\boldsymbol { v } _ { k }, \\boldsymbol{n}_k; 1), Mul(Cross(\\vec { C _ { k } O _ { k } }; \\boldsymbol{n}_k), \\Delta \\boldsymbol { \\omega } _ { k }; 1)); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter8.tex",
    ),
    (
        "A_m = C t = \\pi a b \\frac{t}{T}",
        "Chain(A_m, Mul(C, t), Mul(\\pi, a, b, Div(t; T)); =, =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/elliptical-orbits.md",
    ),
    (
        "{}_I \\mathbf e^x_{I''} = \\mathbf C_{I\\!I'}(z) \\cdot \\mathbf C_{I\\!'I''}(y) \\cdot \\begin{bmatrix} 1 \\\\ 0 \\\\ 0 \\end{bmatrix} = \\begin{bmatrix} \\cos(z) & -\\sin(z) & 0 \\\\ \\sin(z) & \\cos(z) & 0 \\\\ 0 & 0 & 1 \\end{bmatrix} \\begin{bmatrix} \\cos(y) & 0 & \\sin(y) \\\\ 0 & 1 & 0 \\\\ -\\sin(y) & 0 & \\cos(z) \\end{bmatrix} \\begin{bmatrix} 1 \\\\ 0 \\\\ 0 \\end{bmatrix} = \\begin{bmatrix} \\cos(y)\\cos(z) \\\\ \\cos(y)\\sin(z) \\\\ -\\sin(z) \\end{bmatrix}",
        "Chain(\\prescript { } { I } { \\mathbf { e } } _ { I ' ' } ^ { x }, Mul(Call(\\mathbf{C}_{I\\!I'}; z), Call(\\mathbf{C}_{I\\!'I''}; y), MatrixOf(1, 0, 0)), Mul(MatrixOf(Call(cos; z), Neg(Call(sin; z)), 0, Call(sin; z), Call(cos; z), 0, 0, 0, 1), MatrixOf(Call(cos; y), 0, Call(sin; y), 0, 1, 0, Neg(Call(sin; y)), 0, Call(cos; z)), MatrixOf(1, 0, 0)), MatrixOf(Mul(Call(cos; y), Call(cos; z)), Mul(Call(cos; y), Call(sin; z)), Neg(Call(sin; z))); =, =, =)",
        "ANYbotics/kindr/doc/cheatsheet/cheatsheet_kindr1.tex",
    ),
    (
        "\\begin{aligned} v_r &= v \\sin\\phi & v_{\\perp} &= v \\cos\\phi \\end{aligned}",
        "System(Chain(v_r, Mul(v, Call(sin; \\phi)); =), Chain(v_\\perp, Mul(v, Call(cos; \\phi)); =))",
        "bryanwweber/orbital-mechanics-notes/orbital-maneuvers/plane-change-maneuvers.md",
    ),
    (
        "E_{apex}(z, \\dot{x}) = \\frac{1}{2}m \\dot{x}^2 + mgz = E_0.",
        "Chain(Call(E_{apex}; z, Call(\\dot{x})), Add(Mul(Div(1; 2), m, Pow(Call(\\dot{x}); 2)), Mul(m, g, z)), E_0; =, =)",
        "RussTedrake/underactuated/book/simple_legs.html",
    ),
    (
        "\\mathbf{M}_r = \\begin{bmatrix} \\mathbf{q}_r & \\mathbf{r}_r & \\mathbf{s}_r \\end{bmatrix}",
        "Chain(\\mathbf{M}_r, MatrixOf(\\mathbf{q}_r, \\mathbf{r}_r, \\mathbf{s}_r); =)",
        "Mayitzin/ahrs/ahrs/filters/triad.py",
    ),
    (
        "u(x,y) M(x,y) \\, dx + u(x,y) N(x,y) \\, dy = 0",
        "Chain(Add(Mul(Call(u; x, y), Call(M; x, y), Total(x)), Mul(Call(u; x, y), Call(N; x, y), Total(y))), 0; =)",
        "jirilebl/diffyqs/ch-first-order-ode.tex",
    ),
    (
        "\\Gamma(s,z) = e^{-z} U(1-s,1-s,z)",
        "Chain(Call(Gamma; s, z), Mul(Pow(e; Neg(z)), Call(U; Add(1, Neg(s)), Add(1, Neg(s)), z)); =)",
        "fredrik-johansson/arb/doc/source/acb_hypgeom.rst",
    ),
    (
        "\\begin{aligned} Y(l_1,l_2,l_3,m_1,m_2,m_3) &=Y(l_3,l_1,l_2,m_3,m_1,m_2) \\\\ &=Y(l_2,l_3,l_1,m_2,m_3,m_1) \\\\ &=Y(l_3,l_2,l_1,m_3,m_2,m_1) \\\\ &=Y(l_1,l_3,l_2,m_1,m_3,m_2) \\\\ &=Y(l_2,l_1,l_3,m_2,m_1,m_3) \\end{aligned}",
        "Chain(Call(Y; l_1, l_2, l_3, m_1, m_2, m_3), Call(Y; l_3, l_1, l_2, m_3, m_1, m_2), Call(Y; l_2, l_3, l_1, m_2, m_3, m_1), Call(Y; l_3, l_2, l_1, m_3, m_2, m_1), Call(Y; l_1, l_3, l_2, m_1, m_3, m_2), Call(Y; l_2, l_1, l_3, m_2, m_1, m_3); =, =, =, =, =)",
        "sympy/sympy/sympy/physics/wigner.py",
    ),
    (
        "f^+_{n,j} &=& \\phi_{n+1,j}\\,\\left[f^+_{n+1,j} + \\tilde{U}_{n,j}\\,z_{n+1}\\right] \\\\ f^-_{n,j} &=& \\phi_{n,j}\\,\\left[f^-_{n-1,j} + \\tilde{V}_{n-1,j}\\,z_{n-1}\\right] \\\\ y_n &=& A_{n,n}\\,z_n + \\sum_{j=1}^{2\\,J} \\left[ \\tilde{V}_{n,j} f^+_{n,j} + \\tilde U_{n-1,j} f^-_{n,j}\\right] \\quad,",
        "System(Chain(f _ { n , j } ^ { + }, Mul(\\phi_{n+1,j}, Add(f _ { n + 1 , j } ^ { + }, Mul(\\tilde{U}_{n,j}, z_{n+1}))); =), Chain(f _ { n , j } ^ { - }, Mul(\\phi_{n,j}, Add(f _ { n - 1 , j } ^ { - }, Mul(\\tilde{V}_{n-1,j}, z_{n-1}))); =), Chain(y_n, Add(Mul(A_{n,n}, z_n), BigSum(j; 1; Mul(2, J); Add(Mul(\\tilde{V}_{n,j}, f _ { n , j } ^ { + }), Mul(\\tilde{U}_{n-1,j}, f _ { n , j } ^ { - })))); =))",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "J = x^T Q x + u^T R u",
        "Chain(J, Add(Mul(Transpose(x), Q, x), Mul(Transpose(u), R, u)); =)",
        "AtsushiSakai/PythonRobotics/docs/modules/10_inverted_pendulum/inverted_pendulum_main.rst",
    ),
    (
        "{\\bf H}_1 = 0, {\\bf H}_2 = {\\bf I}, \\dot{\\bf H} = 0, \\bar{\\bf H} = {\\bf I}, \\bar{\\bf H}^+ = {\\bf I}.",
        "System(Chain(\\mathbf{H}_1, 0; =), Chain(\\mathbf{H}_2, \\mathbf{I}; =), Chain(Call(\\dot{\\mathbf{H}}), 0; =), Chain(\\bar{\\mathbf{H}}, \\mathbf{I}; =), Chain(\\bar { \\mathbf { H } } ^ { + }, \\mathbf{I}; =))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "\\sum_r a_r(\\bar{q}) \\dot{q}_r = 0",
        "Chain(BigSum(r; Mul(Call(a_r; \\bar{q}), Call(\\dot{q}_r))), 0; =)",
        "moorepants/learn-multibody-dynamics/lagrange.rst",
    ),
    (
        "\\begin{cases} m\\ddot{x} = F_x+2m\\omega_0 \\dot{y} \\sin \\lambda \\\\ m\\ddot{y} = F_y-2m\\omega_0 (\\dot{x} \\sin \\lambda + \\dot{z} \\cos \\lambda) \\\\ m\\ddot{z} = F_z+2m\\omega_0 \\dot{y} \\cos \\lambda \\end{cases}",
        "System(Chain(Mul(m, Call(\\ddot{x})), Add(F_x, Mul(2, m, \\omega_0, Call(\\dot{y}), Call(sin; \\lambda))); =), Chain(Mul(m, Call(\\ddot{y})), Add(F_y, Neg(Mul(2, m, \\omega_0, Add(Mul(Call(\\dot{x}), Call(sin; \\lambda)), Mul(Call(\\dot{z}), Call(cos; \\lambda)))))); =), Chain(Mul(m, Call(\\ddot{z})), Add(F_z, Mul(2, m, \\omega_0, Call(\\dot{y}), Call(cos; \\lambda))); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter7.tex",
    ),
    (
        "\\mathbf{D}_{\\mathrm{orth}} = \\mathbf{B}(\\mathbf{B}^T\\mathbf{B})^{-\\frac{1}{2}}",
        "Chain(\\mathbf{D}_{orth}, Mul(\\mathbf{B}, Pow(Mul(Transpose(\\mathbf{B}), \\mathbf{B}); Neg(Div(1; 2)))); =)",
        "Mayitzin/ahrs/ahrs/common/orientation.py",
    ),
    (
        "\\dot{\\bf y} = {\\bf H} \\dot{\\bf q} \\\\ \\ddot{\\bf y} = \\dot{\\bf H} \\dot{\\bf q} + {\\bf H}_1 \\ddot{\\bf q}_1 + {\\bf H}_2 \\ddot{\\bf q}_2.",
        "System(Chain(Call(\\dot{\\mathbf{y}}), Mul(Call(\\mathbf{H}), Call(\\dot{\\mathbf{q}})); =), Chain(Call(\\ddot{\\mathbf{y}}), Add(Mul(Call(\\dot{\\mathbf{H}}), Call(\\dot{\\mathbf{q}})), Mul(\\mathbf{H}_1, Call(\\ddot{\\mathbf{q}}_1)), Mul(\\mathbf{H}_2, Call(\\ddot{\\mathbf{q}}_2))); =))",
        "RussTedrake/underactuated/book/acrobot.html",
    ),
    (
        "f'(F) = e \\cosh F - 1",
        "Chain(Call(f'; F), Add(Mul(e, Call(cosh; F)), Neg(1)); =)",
        "bryanwweber/orbital-mechanics-notes/time-since-periapsis-and-keplers-equation/hyperbolic-trajectories.md",
    ),
    (
        "A = \\begin{bmatrix} 3 & 0 \\\\ 0 & 3 \\end{bmatrix} .",
        "Chain(A, MatrixOf(3, 0, 0, 3); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\xi_1'' = - \\xi_1 + \\frac{2}{3} \\cos (3t) , \\qquad \\xi_2'' = -4 \\, \\xi_2 - \\frac{2}{3} \\cos (3t) .",
        "System(Chain(\\xi_1'', Add(Neg(\\xi_1), Mul(Div(2; 3), Call(cos; Mul(3, t)))); =), Chain(\\xi_2'', Add(Neg(Mul(4, \\xi_2)), Neg(Mul(Div(2; 3), Call(cos; Mul(3, t))))); =))",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\dot{x}_1 = \\dot{\\theta}_1 = x_2",
        "Chain(Call(\\dot{x}_1), Call(\\dot{\\theta}_1), x_2; =, =)",
        "sympy/sympy/doc/src/tutorials/physics/control/mechanics_problems.rst",
    ),
    (
        "\\frac{\\mathrm{d}}{\\mathrm{d} t} \\frac{\\partial T}{\\partial \\dot{q}_\\alpha} - \\frac{\\partial T}{\\partial q_\\alpha} = Q_\\alpha \\quad (\\alpha = 1,2,\\cdots,s)",
        "System(Chain(Add(Derivative(Derivative(Call(T); \\dot{q}_{\\alpha}, 1; True); t, 1), Neg(Derivative(Call(T); q_{\\alpha}, 1; True))), Q_{\\alpha}; =), Values(\\alpha; 1, 2, Dots(), s))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter2.tex",
    ),
    (
        "\\bar{u}_r = -\\mathbf{M}_n(\\bar{q}, t)^{-1}\\bar{g}_n(\\bar{u}_s, \\bar{q}, t)",
        "Chain(\\bar{u}_r, Neg(Mul(Pow(Call(\\mathbf{M}_n; \\bar{q}, t); Neg(1)), Call(\\bar{g}_n; \\bar{u}_s, \\bar{q}, t))); =)",
        "moorepants/learn-multibody-dynamics/nonholonomic-eom.rst",
    ),
    (
        "P_\\alpha = D_\\alpha\\quad \\text{（常数）}",
        "System(Chain(P_\\alpha, D_\\alpha; =), Words(\\text{（常数）}))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\frac{{}^Ad}{dt} {}^A\\bar{\\omega}^B = \\frac{{}^Bd}{dt} {}^A\\bar{\\omega}^B",
        "Chain(Marked(Derivative(Call(\\prescript { A } { } { \\bar { \\omega } } ^ { B }); t, 1); _{ A }), Marked(Derivative(Call(\\prescript { A } { } { \\bar { \\omega } } ^ { B }); t, 1); _{ B }); =)",
        "moorepants/learn-multibody-dynamics/angular.rst",
    ),
    (
        "\\mathbf{a} = \\mathbf{R}^T(\\dot{\\mathbf{v}}-\\mathbf{g}_0) + \\mathbf{b}_a + \\mu_a",
        "Chain(\\mathbf{a}, Add(Mul(Transpose(\\mathbf{R}), Add(Call(\\dot{\\mathbf{v}}), Neg(\\mathbf{g}_0))), \\mathbf{b}_a, \\mu_a); =)",
        "Mayitzin/ahrs/ahrs/filters/mahony.py",
    ),
    (
        "\\ddot{\\bm{r}}_{B/N} = \\ddot{\\bm{r}}_{B/C} + \\ddot{\\bm{r}}_{C/N} = \\ddot{\\bm{r}}_{B/C, \\mathrm{grav}} + \\ddot{\\bm{r}}_{C/N, \\mathrm{grav}} + \\ddot{\\bm{r}}_{B/N, \\mathrm{thrust}} + \\ddot{\\bm{r}}_{B/N, \\mathrm{SRP}} + \\dots",
        "Chain(Call(\\ddot{\\bm{r}}_{B/N}), Add(Call(\\ddot{\\bm{r}}_{B/C}), Call(\\ddot{\\bm{r}}_{C/N})), Add(Call(\\ddot{\\bm{r}}_{B/C,grav}), Call(\\ddot{\\bm{r}}_{C/N,grav}), Call(\\ddot{\\bm{r}}_{B/N,thrust}), Call(\\ddot{\\bm{r}}_{B/N,SRP}), Dots()); =, =)",
        "AVSLab/basilisk/src/simulation/dynamics/gravityEffector/_Documentation/secModelDescription.tex",
    ),
    (
        "\\lambda_n = {(2n-1)}^2 .",
        "Chain(\\lambda_n, Pow(Add(Mul(2, n), Neg(1)); 2); =)",
        "jirilebl/diffyqs/ch-eigenvalue-probs.tex",
    ),
    (
        "{\\vec{x}}'(t) = A\\vec{x}(t) + \\vec{f}(t) ,",
        "Chain(Call(\\vec{x}'; t), Add(Mul(A, Call(\\vec{x}; t)), Call(\\vec{f}; t)); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\psi = 2\\arcsin(\\tanh \\omega_0t) = -\\pi+4\\arctan(\\mathrm{e}^{\\omega_0t})",
        "Chain(\\psi, Mul(2, Call(arcsin; Call(tanh; Mul(\\omega_0, t)))), Add(Neg(\\pi), Mul(4, Call(arctan; Pow(\\text{e}; Mul(\\omega_0, t))))); =, =)",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "K = \\frac{2 A^{2} \\rho \\left(P_{1} - P_{2}\\right)}{m^{2}}",
        "Chain(K, Div(Mul(2, Pow(A; 2), \\rho, Add(P_1, Neg(P_2))); Pow(m; 2)); =)",
        "CalebBell/fluids/fluids/safety_valve.py",
    ),
    (
        "v = \\frac{ds}{dt} = \\dot{s}",
        "Chain(v, Derivative(Call(s); t, 1), Call(\\dot{s}); =, =)",
        "bryanwweber/orbital-mechanics-notes/review/kinematics.md",
    ),
    (
        "k(\\tau) &=& \\lim_{f \\to 0}\\, S_0\\,\\omega_0\\,e^{-\\omega_0\\,\\tau}\\, \\left[\\cos(f\\,\\tau) + \\frac{\\omega_0}{f}\\,\\sin(f\\,\\tau)\\right] \\\\ &=& S_0\\,\\omega_0\\,e^{-\\omega_0\\,\\tau}\\,[1+\\omega_0\\,\\tau] \\quad.",
        "Chain(Call(k; \\tau), Limiting(lim; _{ f \\to 0 }; Mul(S_0, \\omega_0, Pow(e; Neg(Mul(\\omega_0, \\tau))), Add(Call(cos; Mul(f, \\tau)), Mul(Div(\\omega_0; f), Call(sin; Mul(f, \\tau)))))), Mul(S_0, \\omega_0, Pow(e; Neg(Mul(\\omega_0, \\tau))), Add(1, Mul(\\omega_0, \\tau))); =, =)",
        "dfm/celerite/paper/ms.tex",
    ),
    (
        "\\dot{\\hat{\\mathbf{q}}} = \\big(\\frac{1}{2}\\hat{\\mathbf{q}}\\omega_\\mathbf{q}\\big)\\Delta",
        "Chain(Call(\\dot{\\hat{\\mathbf{q}}}), Mul(Mul(Div(1; 2), Call(\\hat{\\mathbf{q}}), \\omega_{\\mathbf q}), \\Delta); =)",
        "Mayitzin/ahrs/ahrs/filters/fourati.py",
    ),
    (
        "I_{\\mathrm{ph}}(\\phi) = \\begin{cases} j_{\\mathrm{ph},0}\\,A_{\\mathrm{sunlit}}, & \\phi \\le 0 \\\\ j_{\\mathrm{ph},0}\\,A_{\\mathrm{sunlit}} \\exp\\!\\left(-\\dfrac{\\phi}{T_{\\mathrm{ph}}}\\right), & \\phi > 0 \\end{cases}",
        "Chain(Call(I_{ph}; \\phi), Piecewise(Mul(j_{ph,0}, A_{sunlit}), Chain(\\phi, 0; \\le), Mul(j_{ph,0}, A_{sunlit}, Call(exp; Neg(Div(\\phi; T_{ph})))), Chain(\\phi, 0; >)); =)",
        "AVSLab/basilisk/src/simulation/environment/spacecraftChargingEquilibrium/spacecraftChargingEquilibrium.rst",
    ),
    (
        "a = \\frac{\\mu_i}{v_{\\infty}^2}",
        "Chain(a, Div(\\mu_i; Pow(v_\\infty; 2)); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/planetary-depahture-trajectory.md",
    ),
    (
        "\\boldsymbol{v} = \\boldsymbol{v}_O + \\boldsymbol{\\Omega}\\times\\boldsymbol{r}_{\\text{rel}} + \\boldsymbol{v}_{\\text{rel}}",
        "Chain(\\boldsymbol{v}, Add(\\boldsymbol{v}_O, Cross(\\boldsymbol{\\Omega}; \\boldsymbol{r}_{rel}), \\boldsymbol{v}_{rel}); =)",
        "bryanwweber/orbital-mechanics-notes/reference/relative-motion.md",
    ),
    (
        "& \\omega_1 = \\omega_\\phi-\\omega_\\theta,\\quad \\omega_2 = \\omega_\\theta-\\omega_r,\\quad \\omega_3 = \\omega_r \\\\ & J_1 = J_\\phi,\\quad J_2 = J_\\theta+J_\\phi,\\quad J_3 = J_r+J_\\theta+J_\\phi",
        "System(Chain(\\omega_1, Add(\\omega_\\phi, Neg(\\omega_\\theta)); =), Chain(\\omega_2, Add(\\omega_\\theta, Neg(\\omega_r)); =), Chain(\\omega_3, \\omega_r; =), Chain(J_1, J_\\phi; =), Chain(J_2, Add(J_\\theta, J_\\phi); =), Chain(J_3, Add(J_r, J_\\theta, J_\\phi); =))",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter10.tex",
    ),
    (
        "\\gamma = \\frac{S_0(2n) - K_0(2n)}{I_0(2n)} - \\log(n)",
        "Chain(\\gamma, Add(Div(Add(Call(S_0; Mul(2, n)), Neg(Call(K_0; Mul(2, n)))); Call(I_0; Mul(2, n))), Neg(Call(log; n))); =)",
        "fredrik-johansson/arb/doc/source/constants.rst",
    ),
    (
        "1 - \\sum_{i=1}^q \\left(\\frac{D}{k}\\right)^i \\ge 1 + \\frac{D}{D-k}.",
        "Chain(Add(1, Neg(BigSum(i; 1; q; Pow(Div(D; k); i)))), Add(1, Div(D; Add(D, Neg(k)))); \\ge)",
        "fredrik-johansson/arb/doc/source/hypgeom.rst",
    ),
    (
        "\\begin{array}{rcl} \\mathcal{X}_0 &=& \\mathbf{x}_{t-1} \\\\ \\mathcal{X}_i &=& \\mathbf{x}_{t-1} + \\mathbf{L}_i \\\\ \\mathcal{X}_{i+n} &=& \\mathbf{x}_{t-1} - \\mathbf{L}_i \\end{array}",
        "System(Chain(\\mathcal{X}_0, \\mathbf{x}_{t-1}; =), Chain(\\mathcal{X}_i, Add(\\mathbf{x}_{t-1}, \\mathbf{L}_i); =), Chain(\\mathcal{X}_{i+n}, Add(\\mathbf{x}_{t-1}, Neg(\\mathbf{L}_i)); =))",
        "Mayitzin/ahrs/ahrs/filters/ukf.py",
    ),
    (
        "\\Big[m_{\\text{sp}_{i1}} d_{i1} \\hat{\\bm s}_{i1,3}^T + m_{sp_{i2}} l_{i1} \\hat{\\bm s}_{i1,3}^T \\Big] \\ddot{\\bm{r}}_{B/N} + \\Big[I_{s_{i1,2}} \\hat{\\bm s}_{i1,2}^T - m_{\\text{sp}_{i1}} d_{i1} \\hat{\\bm s}_{i1,3}^T [\\tilde{\\bm{r}}_{S_{c,i1}/B}] - m_{sp_{i2}} l_{i1} \\hat{\\bm s}_{i1,3}^T [\\tilde{\\bm{r}}_{S_{c,i2}/B}] \\Big]\\dot{\\bm\\omega}_{\\cal B/N} \\\\ + I_{s_{i1,2}} \\ddot\\theta_{i1} + m_{\\text{sp}_{i1}} d_{i1} \\hat{\\bm s}_{i1,3}^T \\bm{r}''_{S_{c,i1}/B} + m_{sp_{i2}} l_{i1} \\hat{\\bm s}_{i1,3}^T \\bm{r}''_{S_{c,i2}/B} = - (I_{s_{i1,1}} - I_{s_{i1,3}}) \\omega_{s_{i1,3}} \\omega_{s_{i1,1}} - k_{i1} \\theta_{i1} - c_{i1}\\dot{\\theta}_{i1} \\\\ + k_{i2} \\theta_{i2} + c_{i2} \\dot\\theta_{i2} + \\hat{\\bm s}_{i1,2} \\cdot \\bm \\tau_{\\text{ext}_{i1},H_{i1}} + l_{i1} \\hat{\\bm s}_{i1,3} \\cdot \\bm F_{\\text{ext}_{i2}} - m_{\\text{sp}_{i1}} d_{i1} \\hat{\\bm s}_{i1,3} \\cdot \\Big[2 \\bm\\omega_{\\cal B/N} \\times \\bm{r}'_{S_{c,i1}/B} \\\\ + \\bm\\omega_{\\cal B/N} \\times (\\bm\\omega_{\\cal B/N} \\times \\bm{r}_{S_{c,i1}/B})\\Big] - m_{sp_{i2}} l_{i1} \\hat{\\bm s}_{i1,3} \\cdot \\Big[ 2 \\bm\\omega_{\\cal B/N} \\times \\bm{r}'_{S_{c,i2}/B} + \\bm\\omega_{\\cal B/N} \\times (\\bm\\omega_{\\cal B/N} \\times \\bm{r}_{S_{c,i2}/B})\\Big]",
        "Chain(Add(Mul(Add(Mul(m_{sp_i1}, d_{i1}, Transpose(\\hat{\\bm{s}}_{i1,3})), Mul(m_{sp_i2}, l_{i1}, Transpose(\\hat{\\bm{s}}_{i1,3}))), Call(\\ddot{\\bm{r}}_{B/N})), Mul(Add(Mul(I_{s_i1,2}, Transpose(\\hat{\\bm{s}}_{i1,2})), Neg(Mul(m_{sp_i1}, d_{i1}, Transpose(\\hat{\\bm{s}}_{i1,3}), [ \\tilde { \\bm { r } } _ { S _ { c , i 1 } / B } ])), Neg(Mul(m_{sp_i2}, l_{i1}, Transpose(\\hat{\\bm{s}}_{i1,3}), [ \\tilde { \\bm { r } } _ { S _ { c , i 2 } / B } ]))), Call(\\dot { \\bm { \\omega } } _ { \\mathcal B / \\mathcal N })), Mul(I_{s_i1,2}, Call(\\ddot{\\theta}_{i1})), Mul(m_{sp_i1}, d_{i1}, Transpose(\\hat{\\bm{s}}_{i1,3}), \\bm{r}_{S_c,i1/B}''), Mul(m_{sp_i2}, l_{i1}, Transpose(\\hat{\\bm{s}}_{i1,3}), \\bm{r}_{S_c,i2/B}'')), Add(Neg(Mul(Add(I_{s_i1,1}, Neg(I_{s_i1,3})), \\omega_{s_i1,3}, \\omega_{s_i1,1})), Neg(Mul(k_{i1}, Call(\\theta_{i1}))), Neg(Mul(c_{i1}, Call(\\dot{\\theta}_{i1}))), Mul(k_{i2}, Call(\\theta_{i2})), Mul(c_{i2}, Call(\\dot{\\theta}_{i2})), Mul(\\hat{\\bm{s}}_{i1,2}, \\bm{\\tau}_{ext_i1,H_i1}; 1), Mul(l_{i1}, \\hat{\\bm{s}}_{i1,3}, \\bm{F}_{ext_i2}), Neg(Mul(m_{sp_i1}, d_{i1}, \\hat{\\bm{s}}_{i1,3}, Add(Cross(Mul(2, Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})); \\bm{r}_{S_c,i1/B}'), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); \\bm{r}_{S_c,i1/B}))); 3)), Neg(Mul(m_{sp_i2}, l_{i1}, \\hat{\\bm{s}}_{i1,3}, Add(Cross(Mul(2, Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N})); \\bm{r}_{S_c,i2/B}'), Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); Cross(Call(\\bm{\\omega}_{\\mathcal B/\\mathcal N}); \\bm{r}_{S_c,i2/B}))); 3))); =)",
        "AVSLab/basilisk/src/simulation/dynamics/dualHingedRigidBodies/_Documentation/secModelDescription.tex",
    ),
    (
        "\\Gamma = \\nu_B - \\nu_A",
        "Chain(\\varGamma, Add(\\nu_B, Neg(\\nu_A)); =)",
        "bryanwweber/orbital-mechanics-notes/interplanetary-maneuvers/interplanetary-transfer-phasing.md",
    ),
    (
        "{\\bf u}_{min} \\le \\frac{1}{2}{\\bf m}(s_i)b'(s_i) + {\\bf c}(s_i)b(s_i) + \\bar{\\bf \\tau}_g(s_i) \\le {\\bf u}_{max} \\Rightarrow\\\\ {\\bf u}_{min} \\le {\\bf u}(t_i) \\le {\\bf u}_{max}.",
        "Implies(Chain(\\mathbf{u}_{min}, Add(Mul(Div(1; 2), Call(\\mathbf{m}; s_i), Call(b'; s_i)), Mul(Call(\\mathbf{c}; s_i), Call(b; s_i)), Call(\\bar{\\mathbf{\\tau}}_g; s_i)), \\mathbf{u}_{max}; \\le, \\le); Chain(\\mathbf{u}_{min}, Call(\\mathbf{u}; t_i), \\mathbf{u}_{max}; \\le, \\le))",
        "RussTedrake/manipulation/book/trajectories.html",
    ),
    (
        "\\dot{x} = -x + x^3 + \\alpha, \\quad -\\frac{1}{4} < \\alpha < \\frac{1}{4}.",
        "System(Chain(Call(\\dot{x}), Add(Neg(Call(x)), Pow(Call(x); 3), \\alpha); =), Chain(Neg(Div(1; 4)), \\alpha, Div(1; 4); <, <))",
        "RussTedrake/underactuated/book/lyapunov.html",
    ),
    (
        "E_n = 2^n E_n\\left(\\frac{1}{2}\\right).",
        "Chain(Call(E_n), Mul(Pow(2; n), Call(E_n; Div(1; 2))); =)",
        "sympy/sympy/sympy/functions/combinatorial/numbers.py",
    ),
    (
        "\\mathbf{R}(\\mathbf{q}_\\mathrm{acc}) \\begin{bmatrix}0 \\\\ 0 \\\\ 1\\end{bmatrix} = \\begin{bmatrix}a_x \\\\ a_y \\\\ a_z\\end{bmatrix}",
        "Chain(Mul(Call(\\mathbf{R}; \\mathbf{q}_{acc}), MatrixOf(0, 0, 1)), MatrixOf(a_x, a_y, a_z); =)",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
    (
        "U_0 = \\frac{GM}{E} \\arctan e' + \\frac{\\omega^2a^2}{3}",
        "Chain(U_0, Add(Mul(Div(Mul(G, M); E), Call(arctan; e')), Div(Mul(Pow(\\omega; 2), Pow(a; 2)); 3)); =)",
        "Mayitzin/ahrs/ahrs/utils/geodesy.py",
    ),
    (
        "\\zeta(s, 1) = \\zeta(s) = \\sum_{n=1}^\\infty \\frac{1}{n^s}.",
        "Chain(Call(\\zeta; s, 1), Call(\\zeta; s), BigSum(n; 1; Infinity(); Div(1; Pow(n; s))); =, =)",
        "sympy/sympy/sympy/functions/special/zeta_functions.py",
    ),
    (
        "{\\bf Q}_{xx} = {\\bf Q}_t,\\quad {\\bf q}_x = -{\\bf Q}_t {\\bf x}_d - {\\bf N}_t{\\bf u}_d, \\quad q_0 = {\\bf x}_d^T {\\bf Q}_t {\\bf x}_d + 2 {\\bf x}_d^T {\\bf N}_t {\\bf u}_d, \\\\ {\\bf R}_{uu} = {\\bf R}_t, \\quad {\\bf r}_u = -{\\bf R}_t {\\bf u}_d - {\\bf N}_t^T {\\bf x}_d, \\quad r_0 = {\\bf u}_d^T {\\bf R}_t {\\bf u}_d, \\quad {\\bf N} = {\\bf N}_t.",
        "System(Chain(\\mathbf{Q}_{xx}, \\mathbf{Q}_t; =), Chain(\\mathbf{q}_x, Add(Neg(Mul(\\mathbf{Q}_t, \\mathbf{x}_d)), Neg(Mul(\\mathbf{N}_t, \\mathbf{u}_d))); =), Chain(q_0, Add(Mul(Transpose(\\mathbf{x}_d), \\mathbf{Q}_t, \\mathbf{x}_d), Mul(2, Transpose(\\mathbf{x}_d), \\mathbf{N}_t, \\mathbf{u}_d)); =), Chain(\\mathbf{R}_{uu}, \\mathbf{R}_t; =), Chain(\\mathbf{r}_u, Add(Neg(Mul(\\mathbf{R}_t, \\mathbf{u}_d)), Neg(Mul(Transpose(\\mathbf{N}_t), \\mathbf{x}_d))); =), Chain(r_0, Mul(Transpose(\\mathbf{u}_d), \\mathbf{R}_t, \\mathbf{u}_d); =), Chain(\\mathbf{N}, \\mathbf{N}_t; =))",
        "RussTedrake/underactuated/book/lqr.html",
    ),
    (
        "D = \\begin{bmatrix} \\lambda_1 & 0 & \\cdots & 0 \\\\ 0 & \\lambda_2 & \\cdots & 0 \\\\ \\vdots & \\vdots & \\ddots & \\vdots \\\\ 0 & 0 & \\cdots & \\lambda_n \\end{bmatrix} .",
        "Chain(D, MatrixOf(\\lambda_1, 0, Dots(), 0, 0, \\lambda_2, Dots(), 0, Dots(), Dots(), Dots(), Dots(), 0, 0, Dots(), \\lambda_n); =)",
        "jirilebl/diffyqs/ch-systems.tex",
    ),
    (
        "\\boldsymbol{v}(t) = v_x \\boldsymbol{\\hat{\\imath}} + v_y \\boldsymbol{\\hat{\\jmath}} + v_z \\boldsymbol{\\hat{k}}",
        "Chain(Call(\\boldsymbol{v}; t), Add(Mul(v_x, \\boldsymbol{\\hat{\\imath}}), Mul(v_y, \\boldsymbol{\\hat{\\jmath}}), Mul(v_z, \\boldsymbol{\\hat{k}})); =)",
        "bryanwweber/orbital-mechanics-notes/review/time-derivatives-of-moving-vectors.md",
    ),
    (
        "\\mathcal{K}^{B_q}_C = \\begin{bmatrix} I_{3 \\times 3} & \\left[ {}^{B_q}p^{B_p}_C \\right]_\\times \\\\ 0_{3 \\times 3} & I_{3 \\times 3} \\end{bmatrix} \\mathcal{K}^{B_p}_C,",
        "Chain(\\mathcal { K } _ { C } ^ { B _ { q } }, Mul(MatrixOf(I_{3\\times3}, Marked(\\prescript { B _ { q } } { } { p } _ { C } ^ { B _ { p } }; _{ \\times }), Marked(0; _{ 3 \\times 3 }), I_{3\\times3}), \\mathcal { K } _ { C } ^ { B _ { p } }); =)",
        "RussTedrake/manipulation/book/clutter.html",
    ),
    (
        "\\dot{\\bar{x}} = -\\mathbf{M}_m^{-1} \\bar{g}_m =\\bar{f}_m(\\bar{x}, t)",
        "Chain(Call(\\dot{\\bar{x}}), Neg(Mul(Pow(\\mathbf{M}_m; Neg(1)), \\bar{g}_m)), Call(\\bar{f}_m; Call(\\bar{x}), t); =, =)",
        "moorepants/learn-multibody-dynamics/eom.rst",
    ),
    (
        "\\boldsymbol{\\hat{\\lambda}} = \\cos\\phi \\boldsymbol{\\hat{\\imath}} + \\sin\\phi \\boldsymbol{\\hat{\\jmath}} + 0 \\boldsymbol{\\hat{k}}",
        "Chain(\\boldsymbol{\\hat{\\lambda}}, Add(Mul(Call(cos; \\phi), \\boldsymbol{\\hat{\\imath}}), Mul(Call(sin; \\phi), \\boldsymbol{\\hat{\\jmath}}), Mul(0, \\boldsymbol{\\hat{k}})); =)",
        "bryanwweber/orbital-mechanics-notes/chapter-4/5-coordinate-transformations.md",
    ),
    (
        "\\sum_i {}^Bp^{B_i}_{W_z} f^{B_i}_{W_x} = {}^Bp^{\\text{ZMP}}_{W_z} \\sum_i f^{B_i}_{W_x} = {}^Bp^\\text{ZMP}_{W_z} f^\\text{ZMP}_{net, W_x},",
        "Chain(BigSum(i; Mul(\\prescript { B } { } { p } _ { W _ { z } } ^ { B _ { i } }, f _ { W _ { x } } ^ { B _ { i } })), Mul(\\prescript { B } { } { p } _ { W _ { z } } ^ { \\text { Z M P } }, BigSum(i; f _ { W _ { x } } ^ { B _ { i } })), Mul(\\prescript { B } { } { p } _ { W _ { z } } ^ { \\text { Z M P } }, f _ { n e t , W _ { x } } ^ { \\text { Z M P } }); =, =)",
        "RussTedrake/underactuated/book/humanoids.html",
    ),
    (
        "\\mathrm{JDN} = \\mathrm{INT}\\left(\\frac{B}{4}\\right) + \\mathrm{INT}\\left(\\frac{C}{12}\\right) - \\mathrm{INT}\\left(\\frac{3E}{4}\\right) + D - 32075",
        "Chain(\\text{JDN}, Add(Call(\\text{INT}; Div(B; 4)), Call(\\text{INT}; Div(C; 12)), Neg(Call(\\text{INT}; Div(Mul(3, E); 4))), D, Neg(32075)); =)",
        "bryanwweber/orbital-mechanics-notes/reference/julian-date.md",
    ),
    (
        "e_m = \\frac{|\\|\\,^L\\tilde{\\mathbf{a}}\\|-g|}{g}",
        "Chain(e_m, Div(Bars(Add(Norm(\\prescript { L } { } { \\tilde { \\mathbf { a } } }), Neg(g))); g); =)",
        "Mayitzin/ahrs/ahrs/filters/aqua.py",
    ),
)

REFUSED = (  # LaTeX with two readings, repository and path
    (
        "C_D = \\frac{24}{Re} + \\frac{7.3}{1+Re^{0.5}} + 0.25",
        "CalebBell/fluids/fluids/drag.py",
    ),
    (
        "E = 0.383Re^{0.356}-0.207Re^{0.396} - \\frac{0.143}{1+(\\log_{10} Re)^2}",
        "CalebBell/fluids/fluids/drag.py",
    ),
    (
        "F_{R,3a} = 1 + \\left(\\frac{0.33F_L^{0.5}}{n_2^{0.25}}\\right)\\log_{10} \\left(\\frac{Re_v}{10000}\\right)",
        "CalebBell/fluids/fluids/control_valve.py",
    ),
    (
        "Re = \\frac{\\rho v_s d_p}{\\mu}",
        "CalebBell/fluids/fluids/packed_bed.py",
    ),
    (
        "q = f^{-1}_{kin}(X^G),",
        "RussTedrake/manipulation/book/trajectories.html",
    ),
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
    (
        "f_{curved} = f_{\\text{straight,laminar}} \\left[1 - \\left(1-\\left( \\frac{11.6}{De}\\right)^{0.45}\\right)^{\\frac{1}{0.45}}\\right]^{-1}",
        "CalebBell/fluids/fluids/friction.py",
    ),
    (
        "L_\\mathrm{FSPL}\\,\\mathrm{[dB]} = 20 \\cdot \\log_{10}\\left(\\frac{4 \\pi d}{\\lambda}\\right)",
        "AVSLab/basilisk/src/simulation/communication/linkBudget/linkBudget.rst",
    ),
    (
        "\\frac{\\mathrm{d}}{\\mathrm{d} t} [f,g] = 0",
        "ArcturusZhang/Classical-Mechanics-Lecture-Notes/chapter/chapter3.tex",
    ),
    (
        "\\Sigma \\xi = \\xi_1 + \\xi_2 + \\xi_{B1} - \\xi_{B2}",
        "CalebBell/fluids/fluids/control_valve.py",
    ),
    (
        "\\rho_g = \\frac{P\\cdot MW}{T\\cdot R\\cdot 1000}",
        "CalebBell/fluids/fluids/atmosphere.py",
    ),
    (
        "{\\mathbf{F}_{\\textrm{radiation,scaled}}} = {\\mathbf{F}_{\\textrm{radiation}}}{\\Big( \\frac{AU}{|\\textbf{r}_{\\textrm{sun}}|} \\Big)}^{2} [N]",
        "AVSLab/basilisk/src/simulation/dynamics/RadiationPressure/_Documentation/secModelDescription.tex",
    ),
    (
        "\\boldsymbol{a}(t) = \\frac{d\\boldsymbol{v}(t)}{dt} = \\frac{d \\left(v_x \\boldsymbol{\\hat{\\imath}}\\right)}{dt} + \\frac{d \\left(v_y \\boldsymbol{\\hat{\\jmath}}\\right)}{dt} + \\frac{d \\left(v_z \\boldsymbol{\\hat{k}}\\right)}{dt}",
        "bryanwweber/orbital-mechanics-notes/review/time-derivatives-of-moving-vectors.md",
    ),
    (
        "\\ddot{\\bm{r}}_{P_{c,j}/B} &= \\bm{r}''_{P_{c,j}/B} +2 \\bm\\omega_{\\cal B/N} \\times \\bm{r}'_{P_{c,j}/B} + \\dot{\\bm\\omega}_{\\cal B/N} \\times \\bm{r}_{P_{c,j}/B} +\\bm\\omega_{\\cal B/N} \\times (\\bm\\omega_{\\cal B/N} \\times \\bm{r}_{P_{c,j}/B})",
        "AVSLab/basilisk/src/simulation/dynamics/LinearSpringMassDamper/_Documentation/secModelDescription.tex",
    ),
    (
        "\\epsilon = \\sqrt{\\frac{- D^{4} P_{1} P_{2}^{2} \\log{\\left(\\frac{P_{2}} {P_{1}} \\right)} + Do^{4} P_{1} P_{2}^{2} \\log{\\left(\\frac{P_{2}}{P_{1}} \\right)}}{D^{4} P_{1}^{3} - D^{4} P_{1}^{2} P_{2} - Do^{4} P_{1} P_{2}^{2} + Do^{4} P_{2}^{3}}}",
        "CalebBell/fluids/fluids/flow_meter.py",
    ),
)
