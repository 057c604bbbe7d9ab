/* Symplectic Euler and velocity Verlet as anybody would write them in C: masses, springs, weight, and mass 0
   led in a circle where its radius is not 0; and ropes, eight of them side by side in each vector.
   gcc -O3 -march=native -ffast-math */
#include <math.h>
#include <string.h>

static void lead(double t, double radius, double frequency, double ramp, double *out)
{
    double gone = -expm1(-t / ramp), turn = 6.283185307179586 * frequency;
    double p = turn * (t - ramp * gone), rate = turn * gone;
    out[0] = radius * sin(p), out[1] = radius * (1.0 - cos(p));
    out[2] = radius * rate * cos(p), out[3] = radius * rate * sin(p);
}

static void forces(long n, long m, const long *ends, const double *numbers, const double *q, const double *v,
                   double *f)
{
    memset(f, 0, 2 * n * sizeof *f);
    for (long s = 0; s < m; s++) {
        long a = 2 * ends[2 * s], b = 2 * ends[2 * s + 1];
        double lx = q[b] - q[a], ly = q[b + 1] - q[a + 1];
        double length = sqrt(lx * lx + ly * ly), inverse = 1.0 / length;
        double rate = (lx * (v[b] - v[a]) + ly * (v[b + 1] - v[a + 1])) * inverse;
        double force = (numbers[3 * s] * (length - numbers[3 * s + 2]) + numbers[3 * s + 1] * rate) * inverse;
        f[a] += force * lx, f[a + 1] += force * ly;
        f[b] -= force * lx, f[b + 1] -= force * ly;
    }
}

/* weight is 1 / mass, 0 where held; work has room for 4 n numbers. verlet: 0 for Euler, 1 for Verlet. */
void run(long n, long m, const long *ends, const double *numbers, const double *weight, const double *gravity,
         const double *circle, double x0, double y0, long steps, double h, long verlet, double *q, double *v,
         double *work)
{
    double *f = work, *a = work + 2 * n, at[4];
    int led = circle[0] != 0.0, first = 1;
    for (long step = 0; step < steps; step++) {
        double t = step * h;
        if (led) {
            lead(t, circle[0], circle[1], circle[2], at);
            q[0] = x0 + at[0], q[1] = y0 + at[1], v[0] = at[2], v[1] = at[3];
        }
        if (!verlet || first) {
            forces(n, m, ends, numbers, q, v, f);
            first = 0;
        }
        if (!verlet) {
            for (long i = 0; i < n; i++)
                for (int k = 0; k < 2; k++)
                    if (weight[i] != 0.0) {
                        v[2 * i + k] += h * (f[2 * i + k] * weight[i] + gravity[k]);
                        q[2 * i + k] += h * v[2 * i + k];
                    }
            continue;
        }
        for (long i = 0; i < n; i++)
            for (int k = 0; k < 2; k++)
                if (weight[i] != 0.0) {
                    double now = f[2 * i + k] * weight[i] + gravity[k];
                    q[2 * i + k] += h * v[2 * i + k] + 0.5 * h * h * now;
                    v[2 * i + k] += h * now; /* as expected, for the forces */
                    a[2 * i + k] = now;
                }
        if (led) {
            lead(t + h, circle[0], circle[1], circle[2], at);
            q[0] = x0 + at[0], q[1] = y0 + at[1], v[0] = at[2], v[1] = at[3];
        }
        forces(n, m, ends, numbers, q, v, f);
        for (long i = 0; i < n; i++)
            for (int k = 0; k < 2; k++)
                if (weight[i] != 0.0)
                    v[2 * i + k] += 0.5 * h * (f[2 * i + k] * weight[i] + gravity[k] - a[2 * i + k]);
    }
    if (led) {
        lead(steps * h, circle[0], circle[1], circle[2], at);
        q[0] = x0 + at[0], q[1] = y0 + at[1];
    }
}

/* Ropes of n masses, `groups` times eight of them: x[group][mass][lane] and so on, mass 0 held. Stiffness,
   damping, rest length and 1 / mass are those of a lane. verlet: 0 for Euler, 1 for Verlet. */
enum { LANES = 8, MOST = 64 };
typedef double Row[LANES];

static inline void accelerations(long n, const double *k, const double *c, const double *r, const double *m,
                                 double gravity, Row *qx, Row *qy, Row *vx, Row *vy, Row *ax, Row *ay)
{
    Row bx = {0}, by = {0}; /* tension of the spring above */
    for (long i = 1; i < n; i++)
        for (int l = 0; l < LANES; l++) {
            double lx = qx[i][l] - qx[i - 1][l], ly = qy[i][l] - qy[i - 1][l];
            double inverse = 1.0 / sqrt(lx * lx + ly * ly);
            double rate = (lx * (vx[i][l] - vx[i - 1][l]) + ly * (vy[i][l] - vy[i - 1][l])) * inverse;
            double tension = k[l] * (1.0 - r[l] * inverse) + c[l] * rate * inverse;
            double fx = tension * lx, fy = tension * ly;
            ax[i - 1][l] = m[l] * (fx - bx[l]), ay[i - 1][l] = m[l] * (fy - by[l]) + gravity;
            bx[l] = fx, by[l] = fy;
        }
    for (int l = 0; l < LANES; l++)
        ax[n - 1][l] = -m[l] * bx[l], ay[n - 1][l] = gravity - m[l] * by[l];
}

void ropes(long groups, long n, long steps, double h, long verlet, double gravity, const double *stiffness,
           const double *damping, const double *rest, const double *weight, double *x, double *y, double *u,
           double *w)
{
    for (long g = 0; g < groups; g++) {
        Row qx[MOST], qy[MOST], vx[MOST], vy[MOST], ax[MOST], ay[MOST], ex[MOST], ey[MOST], nx[MOST], ny[MOST];
        const double *k = stiffness + LANES * g, *c = damping + LANES * g, *r = rest + LANES * g;
        const double *m = weight + LANES * g;
        long first = LANES * n * g, bytes = LANES * n * sizeof(double);
        memcpy(qx, x + first, bytes), memcpy(qy, y + first, bytes);
        memcpy(vx, u + first, bytes), memcpy(vy, w + first, bytes);
        memcpy(ex, vx, bytes), memcpy(ey, vy, bytes);
        accelerations(n, k, c, r, m, gravity, qx, qy, vx, vy, ax, ay);
        for (long step = 0; step < steps; step++) {
            if (!verlet) {
                for (long i = 1; i < n; i++)
                    for (int l = 0; l < LANES; l++) {
                        vx[i][l] += h * ax[i][l], vy[i][l] += h * ay[i][l];
                        qx[i][l] += h * vx[i][l], qy[i][l] += h * vy[i][l];
                    }
                accelerations(n, k, c, r, m, gravity, qx, qy, vx, vy, ax, ay);
                continue;
            }
            for (long i = 1; i < n; i++)
                for (int l = 0; l < LANES; l++) {
                    qx[i][l] += h * (vx[i][l] + 0.5 * h * ax[i][l]), ex[i][l] = vx[i][l] + h * ax[i][l];
                    qy[i][l] += h * (vy[i][l] + 0.5 * h * ay[i][l]), ey[i][l] = vy[i][l] + h * ay[i][l];
                }
            accelerations(n, k, c, r, m, gravity, qx, qy, ex, ey, nx, ny);
            for (long i = 1; i < n; i++)
                for (int l = 0; l < LANES; l++) {
                    vx[i][l] += 0.5 * h * (ax[i][l] + nx[i][l]), ax[i][l] = nx[i][l];
                    vy[i][l] += 0.5 * h * (ay[i][l] + ny[i][l]), ay[i][l] = ny[i][l];
                }
        }
        memcpy(x + first, qx, bytes), memcpy(y + first, qy, bytes);
        memcpy(u + first, vx, bytes), memcpy(w + first, vy, bytes);
    }
}
