/* What a careful programmer writes by hand for three kernels; what generated C is compared with in speed.

   The functions are those of glibc's vector library, which err by up to four units in the last place. Under names of
   their own, as GCC makes one call of the sine and cosine of an angle, which has no vector form. */
#include <math.h>
#include <stddef.h>

#if defined(__x86_64__) && !defined(__clang__) && (__GLIBC__ > 2 || (__GLIBC__ == 2 && __GLIBC_MINOR__ >= 35))
__attribute__((simd("notinbranch"))) double vcos(double) __asm__("cos");
__attribute__((simd("notinbranch"))) double vsin(double) __asm__("sin");
__attribute__((simd("notinbranch"))) double vtan(double) __asm__("tan");
#else
#define vcos cos
#define vsin sin
#define vtan tan
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
