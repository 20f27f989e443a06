/* What a careful programmer writes by hand for five kernels; what generated C is compared with in speed.

   The functions are those of glibc's vector library, which err by up to four units in the last place. Under names of
   their own, as GCC makes one call of the sine and cosine of an angle, which has no vector form. */
#include <math.h>
#include <stddef.h>

#if defined(__x86_64__) && !defined(__clang__) && (__GLIBC__ > 2 || (__GLIBC__ == 2 && __GLIBC_MINOR__ >= 35))
__attribute__((simd("notinbranch"), const)) double vcos(double) __asm__("cos");
__attribute__((simd("notinbranch"), const)) double vsin(double) __asm__("sin");
__attribute__((simd("notinbranch"), const)) double vtan(double) __asm__("tan");
#else
#define vcos cos
#define vsin sin
#define vtan tan
#endif
#if defined(__x86_64__) && !defined(__clang__) && (__GLIBC__ > 2 || (__GLIBC__ == 2 && __GLIBC_MINOR__ >= 35))
__attribute__((simd("notinbranch"), const)) double vexp(double) __asm__("exp");
__attribute__((simd("notinbranch"), const)) double vlog1p(double) __asm__("log1p");
#else
#define vexp exp
#define vlog1p log1p
#endif

#define LOOP _Pragma("omp parallel for simd if(parallel: n >= 50000)") for (size_t i = 0; i < n; ++i)

void copy(size_t n, const double *restrict from, double *restrict to)
{
    LOOP to[i] = from[i];
}

/* Pitch alpha, yaw beta, roll gamma. */
void direction_cosines(size_t n, const double *restrict alpha, const double *restrict beta,
                       const double *restrict gamma, double *restrict a11, double *restrict a12, double *restrict a13,
                       double *restrict a21, double *restrict a22, double *restrict a23, double *restrict a31,
                       double *restrict a32, double *restrict a33)
{
    LOOP {
        const double ca = vcos(alpha[i]), sa = vsin(alpha[i]), cb = vcos(beta[i]), sb = vsin(beta[i]);
        const double cg = vcos(gamma[i]), sg = vsin(gamma[i]), ss = sa * sb, cs = ca * sb;
        a11[i] = ca * cb;
        a12[i] = sa * sg - cs * cg;
        a13[i] = sa * cg + cs * sg;
        a21[i] = sb;
        a22[i] = cb * cg;
        a23[i] = -cb * sg;
        a31[i] = -sa * cb;
        a32[i] = ca * sg + ss * cg;
        a33[i] = ca * cg - ss * sg;
    }
}

void product_of_axial_moments(size_t n, const double *restrict I1, const double *restrict I2, const double *restrict I3,
                              const double *restrict a11, const double *restrict a12, const double *restrict a13,
                              const double *restrict a21, const double *restrict a22, const double *restrict a23,
                              const double *restrict a31, const double *restrict a32, const double *restrict a33,
                              double *restrict f)
{
    LOOP {
        const double J1 = I1[i] * a11[i] * a11[i] + I2[i] * a12[i] * a12[i] + I3[i] * a13[i] * a13[i];
        const double J2 = I1[i] * a21[i] * a21[i] + I2[i] * a22[i] * a22[i] + I3[i] * a23[i] * a23[i];
        const double J3 = I1[i] * a31[i] * a31[i] + I2[i] * a32[i] * a32[i] + I3[i] * a33[i] * a33[i];
        f[i] = J1 * J2 * J3;
    }
}

/* In the tangents t and u of both angles, which lie between 0 and a quarter turn. */
void face_distances_of_four_wheels(size_t n, const double *restrict a, const double *restrict b, double *restrict r1,
                                   double *restrict r2, double *restrict r3)
{
    LOOP {
        const double t = vtan(a[i]), u = vtan(b[i]), tt = t * t, uu = u * u, v = 1.0 + uu, w = 1.0 + tt;
        r1[i] = 4.0 * t * u / sqrt(v + tt * (1.0 + uu * (2.0 + tt)));
        r2[i] = 4.0 * t / sqrt(v + tt * (2.0 + uu + tt));
        r3[i] = 4.0 * t * u / (v * sqrt(w));
    }
}

/* The sums of the printed coefficients with what they have in common computed once: 74 operations. */
void drift_coefficients(size_t n, const double *restrict a, const double *restrict psi, const double *restrict omega,
                        const double *restrict k, const double *restrict eps, const double *restrict d11,
                        const double *restrict d12, const double *restrict d13, const double *restrict d21,
                        const double *restrict d22, const double *restrict d23, const double *restrict d31,
                        const double *restrict d32, const double *restrict d33, const double *restrict g11,
                        const double *restrict g12, const double *restrict g21, const double *restrict g22,
                        const double *restrict g13, double *restrict k1, double *restrict k2, double *restrict k3)
{
    LOOP {
        const double s = vsin(psi[i]), c = vcos(psi[i]), ss = s * s, cc = c * c, sc = s * c, w = omega[i] / k[i];
        const double p = g11[i] * g11[i], q = g12[i] * g12[i], u = g21[i] * g21[i], v = g22[i] * g22[i];
        const double inverse = 1.0 / a[i];
        const double many = p * cc * (1.0 + ss) + q * ss * (1.0 + cc);
        const double along = many + 2.0 * (sc * (d12[i] + d21[i]) - d11[i] * cc - d22[i] * ss);
        const double turning = 0.5 * (p + q) * (cc - ss) + (u - v) * inverse * inverse + d11[i] - d22[i];
        k1[i] = eps[i] * (w * (d23[i] * s - d13[i] * c) + 0.5 * (a[i] * along + (u * ss + v * cc) * inverse));
        k2[i] = eps[i] * (w * inverse * (d13[i] * s + d23[i] * c) + d21[i] * cc - d12[i] * ss + sc * turning);
        k3[i] = eps[i] * (omega[i] * (0.5 * g13[i] * g13[i] - d33[i]) + a[i] * k[i] * (d32[i] * s - d31[i] * c));
    }
}

/* Gamma(x + 1/2)/(Gamma(x) sqrt(x)) by Stirling's series, after nine steps up; it is 1 for x as large as 2^100. */
void density_of_frequency(size_t n, const double *restrict omega, const double *restrict k, const double *restrict g13,
                          const double *restrict g23, const double *restrict d33, double *restrict p)
{
    LOOP {
        const double g = g13[i] * g13[i], b = g23[i] * k[i], bb = b * b, ww = omega[i] * omega[i];
        const double x = d33[i] / g, y = x + 0.5, z = x + 9.0;
        const double s = x * z, t = y * (y + 9.0); /* (x + k)(x + 9 - k) = s + k (9 - k) */
        const double above = (s + 8.0) * (s + 14.0) * ((s + 18.0) * (s + 20.0));
        const double under = (t + 8.0) * (t + 14.0) * ((t + 18.0) * (t + 20.0)) * y;
        const double r = 1.0 / z, rr = r * r;
        const double log_ratio = r * (-1.0 / 8 + rr * (1.0 / 192 + rr * (-1.0 / 640 + rr * (17.0 / 14336
            + rr * (-31.0 / 18432 + rr * (691.0 / 180224 + rr * (-5461.0 / 425984)))))));
        const double power = vexp(log_ratio - x * vlog1p(ww * g / bb));
        const double steps = x > 0x1p100 ? 1.0 : sqrt(s) * above / under;
        p[i] = power * steps * sqrt(d33[i] / (3.14159265358979324 * (ww * g + bb)));
    }
}
